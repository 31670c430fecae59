//! What a word does, in a sentence or two, for the pages of words.

use aptc_vocabulary::{Class, Word, word};

/// What a word does, where its forms do not show it.
pub(crate) fn sentence(word: Word) -> Option<&'static str> {
    Some(match word {
        word::TANTO | word::DSTAN => {
            "The motion ends where the cutter is tangent to the check surface, which is tangent to the drive surface."
        }
        word::PSTAN => {
            "The motion ends where the cutter is tangent to the check surface, which is tangent to the part surface."
        }
        word::OFFSET => {
            "Brings the tool to its surfaces as GO does, but to the nearest place; after INDIRV or INDIRP first along the normal where that \
             direction pierces the drive surface, then along the axis to the part surface. In LOADTL: the register of the tool's length."
        }
        word::NOPS => {
            "A GO that names the drive surface alone does without a part surface, up to PSIS, AUTOPS or a GO that names one."
        }
        word::AUTOPS => {
            "The part surface is the plane through the tool end square to the tool axis, as they are here."
        }
        word::NUMPTS => "A motion ends with an error when it has more than n cut vectors.",
        word::SRFVCT => {
            "For the next start: vectors from the TO side to the PAST side of each surface, wherever the tool stands."
        }
        word::DNTCUT => {
            "The tool moves on, but its motions are not put out; CUT puts out again, from where the tool is then."
        }
        word::CUT => "Motions are put out again after DNTCUT.",
        word::W2DCALC | word::NDTEST => {
            "Motion square to the tool axis is computed in the plane where the surfaces allow it; this holds from the start."
        }
        word::W3DCALC => {
            "Motion is computed in space, also where the plane would do; 2DCALC ends it."
        }
        word::CLPRNT => {
            "Puts the CL data in the listing: all of them, or those from ON to OFF; OPTION those before COPY and TRACUT."
        }
        word::GOUGCK => {
            "Passed on in the CL data and of no effect else: every cut vector is checked for gouges here, with OFF too."
        }
        word::TLNDON => "The tool end stays on the drive surface, as with TLON.",
        word::SCON => {
            "Sets what SMIL mills by: DS the region from u1 to u2 and v1 to v2 of a surface, PS the surface that is touched and the \
             thickness on it, FEED along, between, down and up, STEPOV scallop, greatest step, lift and number of passes."
        }
        word::SMIL => {
            "Mills the region of SCON/DS: POSN one position, PATH one pass, ZIGZAG and PICKFD all; PARAM u,v is where it begins, \
             TANSPL leads along u and CRSSPL along v, and PLUS or MINUS say which way."
        }
        word::CUTTER => {
            "d is the diameter, r the corner radius, e how far from the axis the centre of the corner lies and f how high above the tool end, \
             a the rise of the bottom and b the taper of the side in degrees, h the height. With e and f both 0 the corner touches bottom and \
             side, wherever that is. Where h is left out it is 5 inches, 127 mm. OPTION puts a disk in the place of the cutter against the part \
             (1) or drive surface (2) up to OFF: its radius, and how far it lies above the tool end."
        }
        word::THICK => {
            "What is left on the surfaces; the last number holds for those that follow it. A negative one lets the cutter into the surface, by its \
             radius at most. Where the tool end is ON a surface there is none."
        }
        word::INTOL => {
            "How far the cutter may go into the surface; 0 from the start. The last number holds for the surfaces that follow it."
        }
        word::OUTTOL => {
            "How far the cutter may stay off the surface; .0005 inch from the start. The last number holds for the surfaces that follow it."
        }
        word::TOLER => "OUTTOL, with INTOL zero.",
        word::TLAXIS => {
            "1 or PS is the part surface, 2 or DS the drive surface. The angle of ATANGL is that from the normal, in degrees, positive away from \
             the other surface; a vector, line or plane behind it gives the plane in which the axis stays, CUTANG how far it leans along the \
             motion. RADIUS and HIGHT say for GOLOFT where along the bottom and the flank the cutter touches. TLAXIS/1 keeps the axis as it is."
        }
        word::TRANTO => {
            "Goes on at the label, as JUMPTO does; APT-360 had it for the labels behind check surfaces."
        }
        word::JUMPTO => "Goes on at the label.",
        word::POLCON => {
            "A family of conic sections by its control curves, a matrix and a thickness: it has no format but its 79 canonical elements."
        }
        word::MULTAX => "The tool axis stands in the CL data with each position, up to MULTAX/OFF.",
        word::TLONPS => "The tool end stays on the part surface.",
        word::TLOFPS => "The cutter touches the part surface; this holds from the start.",
        word::TLON => "The tool end stays on the drive surface.",
        word::TLLFT | word::TLRGT => {
            "The tool stays to the left (TLLFT) or the right (TLRGT) of the drive surface, seen along the motion."
        }
        word::CANON => {
            "ON lets a geometric name be given another value. Among arguments: a form by its canonical elements, or another form with some of \
             them replaced; an empty field keeps one."
        }
        word::CLDAT => {
            "Records the cut vectors of the motions between START and NOMORE, and puts those motions out nowhere. The words say what is kept \
             besides tool end, axis and direction."
        }
        word::REGION => {
            "Lines of GOLOFT and GOMILL are milled only inside (IN) or outside (OUT) of the outline that CLDAT recorded."
        }
        word::LIMIT => {
            "In a spline: how far a point may leave its place when WEIGHT below 1 smooths the curve; alone it changes nothing. In AVCTRL: the \
             greatest distance by which the tool is lifted."
        }
        word::BOUNDS => {
            "The space on named sides of surfaces. It can be defined, and put into an OBJECT; no statement uses it."
        }
        word::OBJECT => "Bounded spaces in one object. It can be defined; no statement uses it.",
        word::FINI => "Ends the part program; what follows in the file is a further one.",
        _ => match word.class() {
            Class::Function => return function(word),
            _ => return modifier(word),
        },
    })
}

fn function(word: Word) -> Option<&'static str> {
    Some(match word {
        word::CLDATF => {
            "A parameter of the place that cut vector k of section n of CLDAT touches: u (UPS) and v (VPS) in the patch of the part surface, \
             and the number of the patch (PPS); UDS, VDS and PDS those of the drive surface."
        }
        word::NUMF => {
            "The number of points of a pattern, of arcs or patches, or of cut vectors that CLDAT recorded."
        }
        word::PARMF => {
            "The parameters of the place that the last POINT or VECTOR found on a sculptured curve or surface."
        }
        word::CANF => "The n-th element of a canonical form.",
        word::INTF => "Cuts the fraction off.",
        word::MODF => "The rest of a by b.",
        word::SIGNF => "a with the sign of b.",
        word::DISTF => {
            "The distance of two parallel lines or planes, of a point from a line or plane, or of two points."
        }
        word::ANGLF => "The angle of a point seen from a circle's centre, in degrees.",
        word::ANGLB => "The angle of a point seen from a circle's centre, in radians.",
        word::SPATF => "The product of two vectors, times a third.",
        word::SINF | word::COSF | word::TANF | word::COTANF => "Of an angle in degrees.",
        word::ATANF | word::ATAN2F | word::ARSINF | word::ARCOSF => "An angle in degrees.",
        word::SINB | word::COSB | word::TANB | word::COTANB => "Of an angle in radians.",
        word::ATANB | word::ATAN2B | word::ARSINB | word::ARCOSB => "An angle in radians.",
        _ => return None,
    })
}

/// What a word says that stands among the arguments of others.
fn modifier(word: Word) -> Option<&'static str> {
    Some(match word {
        word::INTOF => {
            "The place where two things meet; in a motion `n,INTOF` before the check surface is the n-th place where the drive surface meets it."
        }
        word::CUTANG => {
            "Behind ATANGL the lean along the motion, in degrees; in AVCTRL lets the tool tilt out of the way."
        }
        word::LEAD => "Behind CUTANG: the axis leans towards the motion.",
        word::LAG => "Behind CUTANG: the axis leans against the motion.",
        word::ATANGL => "An angle in degrees follows.",
        word::FLOW => {
            "A second parameter of a curve, for surfaces through several of them: by ARC length, by the curve's own (PARAM), by the ANGLE about a \
             point or along a CHORD, between points that have numbers from 0; SEG behind it divides it. In POINT, VECTOR and GOLOFT: measured by it."
        }
        word::SEG => {
            "The piece of a line or circle between two bounds; behind FLOW: by what its spans are divided, their LENGTH or their parameter (PARAM)."
        }
        word::WEIGHT => {
            "How much a point of a spline holds the curve, from 0 to 1: below 1 the point is moved for a smoother curve, by LIMIT at most; 1 or more \
             leaves it. Before the first point it holds for all, behind a point for that one."
        }
        word::GENCUR => {
            "A surface through curves one after the other; CROSS begins curves across, which lie in it too."
        }
        word::CROSS => {
            "The product of two vectors; in SSURF the curves across, or the curve along which another is carried."
        }
        word::AVPRT | word::AVMSG => {
            "Tells of each gouge that CHKSRF found and AVCTRL avoided, until OFF."
        }
        word::SSPRT | word::SSTEST | word::TABPRT | word::LIBPRT => {
            "Printed tables of APT4; without effect here."
        }
        word::OPTION => {
            "In CUTTER a disk in the place of the cutter against the part (1) or drive surface (2); in CLPRNT the CL data before COPY and TRACUT."
        }
        word::SPLINE => {
            "In TABCYL, SCURV and SSURF: a curve whose slope and curvature are continuous at its points."
        }
        word::FOURPT => {
            "Over each chord the cubic through its ends and the next point on either side."
        }
        word::TWOPT => {
            "Slopes where they are given, elsewhere those of the circle through a point and its neighbours."
        }
        word::PTSLOP => "A slope follows each point.",
        word::PTNORM => "The angle of the normal follows each point, in degrees.",
        word::TANSPL => {
            "The tangent of a curve; on a surface the direction in which the first parameter grows."
        }
        word::CRSSPL => {
            "Across the curve; on a surface the direction in which the second parameter grows."
        }
        word::TRFORM => "Carries what is defined by a matrix.",
        word::UNIT => "Of length 1.",
        word::CLDATA => {
            "Cut vectors of a section of CLDAT, or of the last motion where no section is named."
        }
        word::TP => "The tool end of a cut vector.",
        word::TA => "The tool axis of a cut vector.",
        word::TV => "The direction of a cut vector.",
        word::PPS | word::PDS => {
            "The place that a cut vector touches on the part (PPS) or drive surface (PDS)."
        }
        word::NPS | word::NDS => {
            "The normal where a cut vector touches the part (NPS) or drive surface (NDS)."
        }
        word::UVPPS | word::UVPDS => {
            "The parameters where a cut vector touches the part (UVPPS) or drive surface (UVPDS)."
        }
        word::PARAM => "Parameters follow, or hold.",
        word::MOTDIR => "The direction of the motion.",
        word::RANGE => "The least and the greatest angle by which AVCTRL may tilt the tool.",
        word::PERIM => "Of a pattern of rows the points of its border alone.",
        word::OMIT => "Leaves the points with these numbers out.",
        word::RETAIN => "Takes the points with these numbers alone.",
        word::FUNOFY => "x as a function of y.",
        word::XLARGE | word::XSMALL | word::YLARGE | word::YSMALL | word::ZLARGE | word::ZSMALL => {
            "Of several solutions the one with the larger or smaller coordinate."
        }
        _ => return None,
    })
}
