//! Programs for each chapter of the language: all of their statements are read, and those that move the
//! tool, set, edit or talk to the post-processor become the records that they should.

mod support;

use aptc_diagnostics::Severity;
use support::{Ran, clean, run};

/// Kinds of the records in order: the name before the first bracket.
fn kinds(ran: &Ran) -> Vec<String> {
    let name = |text: String| {
        text.split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default().to_owned()
    };
    ran.kinds().iter().map(|k| name(format!("{k:?}"))).collect()
}

/// Each line is a statement and what it becomes, in order; `-` for nothing.
fn becomes(scene: &str, table: &[(&str, &str)]) {
    for (statement, wanted) in table {
        let ran = run(&format!("{scene}{statement}\nFINI\n"));
        // What does nothing here is noted.
        let noted = ran.diagnostics.iter().all(|d| d.severity == Severity::Note);
        assert!(noted, "{statement}\n{}", ran.messages());
        let before = clean(&format!("{scene}FINI\n")).kinds().len();
        let found = kinds(&ran)[before..].join(" ");
        assert_eq!(found, wanted.replace('-', ""), "{statement}");
        assert!(aptc_protap::verify(&ran.records).is_empty(), "{statement}");
    }
}

const SCENE: &str = "P=POINT/1,2,3\nQ=POINT/5,5,3\nV=VECTOR/0,0,1\nL1=LINE/XAXIS\nL2=LINE/YAXIS\n\
                     C1=CIRCLE/5,5,2\nPL=PLANE/0,0,1,0\nPT=PATERN/LINEAR,P,Q,9\nM=MATRIX/XYROT,90\n";

#[test]
fn point_to_point_motion() {
    becomes(
        SCENE,
        &[
            ("FROM/P", "From"),
            ("FROM/1,2", "From"),
            ("FROM/1,2,3", "From"),
            ("FROM/P,V,20", "Post From"),
            ("FROM/P,0,0,1", "From"),
            ("GOTO/P", "Goto"),
            ("GOTO/1,2", "Goto"),
            ("GOTO/1,2,3,100", "Post Goto"),
            ("GOTO/1,2,3,0,0,1", "Goto"),
            ("GOTO/1,2,3,0,0,1,55", "Post Goto"),
            ("GOTO/P,V", "Goto"),
            ("GOTO/P,V,30", "Post Goto"),
            ("GOTO/(POINT/PT,3)", "Goto"),
            ("GOTO/PT", "Points"),
            ("GOTO/PT,INVERS", "Points"),
            ("GOTO/PT,CONST", "Points"),
            ("GOTO/PT,OMIT,2,THRU,4", "Points"),
            ("GOTO/PT,RETAIN,1,3,5", "Points"),
            ("GOTO/PT,ZIGZAG", "Points"),
            ("GODLTA/1,2,3", "GoDelta"),
            ("GODLTA/1,2,3,50", "Post GoDelta"),
            ("GODLTA/5", "GoDeltaAxis"),
            ("GODLTA/5,50", "Post GoDeltaAxis"),
            ("GODLTA/V", "GoDelta"),
            ("GODLTA/V,50", "Post GoDelta"),
            ("RAPID,GOTO/P", "Post Goto"),
        ],
    );
}

#[test]
fn start_up_and_sense_of_direction() {
    becomes(
        SCENE,
        &[
            ("INDIRV/V", "Sense"),
            ("INDIRV/1,0,0", "Sense"),
            ("INDIRV/V,,V", "Sense"),
            ("INDIRV/,,V", "Sense"),
            ("INDIRV/(VECTOR/1,1,0),V", "Sense"),
            ("INDIRP/P", "Sense"),
            ("INDIRP/1,2", "Sense"),
            ("INDIRP/1,2,3", "Sense"),
            ("SRFVCT/V", "SurfaceNormals"),
            ("SRFVCT/,V", "SurfaceNormals"),
            ("GO/L1", "Go"),
            ("GO/L1,PL", "Go"),
            ("GO/ON,L1,ON,PL", "Go"),
            ("GO/PAST,L1,TO,PL,TANTO,C1", "Go"),
            ("GO/(LINE/0,0,1,0),(S1=PLANE/0,0,1,4)", "Go"),
            ("OFFSET/TO,L1,ON,PL", "Go"),
            ("PSIS/PL", "PartSurface"),
            ("PSIS/(PLANE/0,0,1,3)", "PartSurface"),
            ("AUTOPS", "Autops"),
            ("NOPS", "Nops"),
        ],
    );
}

#[test]
fn motion_along_surfaces() {
    becomes(
        SCENE,
        &[
            ("GOLFT/L1", "Drive"),
            ("GORGT/L1,L2", "Drive"),
            ("GOFWD/L1,PAST,L2", "Drive"),
            ("GOBACK/L1,ON,2,INTOF,C1", "Drive"),
            ("GOFWD/L1,2,INTOF,C1", "Drive"),
            ("GOUP/L1,DSTAN,C1", "Drive"),
            ("GODOWN/L1,PSTAN,C1", "Drive"),
            ("GOFWD/L1,TANTO,C1,55", "Post Drive"),
            ("TLLFT,GOLFT/L1,TO,L2", "DriveSide Drive"),
            ("TLRGT,TLONPS,GOLFT/L1,TO,L2", "DriveSide PartSide Drive"),
            ("TLON", "DriveSide"),
            ("TLNDON,GOFWD/L1,L2", "DriveSide Drive"),
            ("TLOFPS", "PartSide"),
            ("GOLFT/L1,TO,L2,A,PAST,C1,B\nA) STOP\nB) STOP", "Drive Post Post"),
            ("TRANTO/A\nGOTO/P\nA) CONTIN", ""),
            ("DNTCUT", "Cut"),
            ("DNTCUT/PRINT", "Cut"),
            ("CUT", "Cut"),
            ("POCKET/.5,.8,.2,10,20,30,1,1,P,Q,(POINT/5,0)", "Pocket"),
        ],
    );
}

#[test]
fn cutter_tolerance_and_axis() {
    becomes(
        SCENE,
        &[
            ("CUTTER/1", "Cutter"),
            ("CUTTER/1,.25", "Cutter"),
            ("CUTTER/1,.25,.25,.25,0,0,3", "Cutter"),
            ("CUTTER/OPTION,2,.5,0", "CutterOption"),
            ("CUTTER/OPTION,1,OFF", "CutterOption"),
            ("TOLER/.001", "Intol Outtol"),
            ("INTOL/.1,.2,.3", "Intol"),
            ("OUTTOL/.005", "Outtol"),
            ("THICK/.1", "Thick"),
            ("THICK/.1,.2,.3,.4", "Thick"),
            ("MAXDP/2", "Maxdp"),
            ("MAXDP/2,8", "Maxdp"),
            ("NUMPTS/500", "Numpts"),
            ("2DCALC", "Calc"),
            ("3DCALC", "Calc"),
            ("NDTEST", "Calc"),
            ("GOUGCK/ON", "Gougck"),
            ("MULTAX", "Multax"),
            ("MULTAX/OFF", "Multax"),
            ("TLAXIS/V", "ToolAxis"),
            ("TLAXIS/0,0,1", "ToolAxis"),
            ("TLAXIS/1", "ToolAxis"),
            ("TLAXIS/NORMPS", "ToolAxis"),
            ("TLAXIS/NORMDS", "ToolAxis"),
            ("TLAXIS/PARLEL,2", "ToolAxis"),
            ("TLAXIS/ATANGL,1,10", "ToolAxis"),
            ("TLAXIS/ATANGL,2,10,V", "ToolAxis"),
            ("TLAXIS/ATANGL,2,10,CUTANG,5", "ToolAxis"),
            ("TLAXIS/LAST", "ToolAxis"),
            ("TLAXIS/PARLEL,DS,RADIUS,2,HIGHT,3", "ToolAxis"),
            ("TLAXIS/ATANGL,DS,5,RADIUS,1,HIGHT,2", "ToolAxis"),
            ("TLAXIS/ATANGL,DS,3,CUTANG,LAG,5", "ToolAxis"),
            ("TLAXIS/ATANGL,DS,3,PARLEL,L1", "ToolAxis"),
            ("TLAXIS/ATANGL,DS,3,PERPTO,V", "ToolAxis"),
        ],
    );
    // The unit stands before what it measures.
    becomes("", &[("UNITS/MM", "Units"), ("UNITS/CM", "Units"), ("UNITS/FEET", "Units")]);
}

#[test]
fn editing_and_listing() {
    becomes(
        SCENE,
        &[
            ("TRACUT/M", "Edit"),
            ("TRACUT/(MATRIX/TRANSL,1,2,3)", "Edit"),
            ("TRACUT/NOMORE", "Edit"),
            ("INDEX/1\nGOTO/P\nINDEX/1,NOMORE\nCOPY/1,SAME,2", "Edit Goto Edit Edit"),
            ("INDEX/1\nCOPY/1,TRANSL,1,2,3,2", "Edit Edit"),
            ("INDEX/1\nCOPY/1,ZXROT,30,3", "Edit Edit"),
            ("INDEX/1\nCOPY/1,MODIFY,M,3", "Edit Edit"),
            ("VTLAXS/ON,LEFT,10,2,0,RIGHT\nVTLAXS/OFF,LEFT,10", "Post Post"),
            (
                "VTLAXS/ON,LEFT,10,2,0,RIGHT,ZSMALL\nWCORN/LEFT,5,RIGHT,6,1\nVTLAXS/OFF,LEFT,1",
                "Post Post Post",
            ),
            ("PTONLY/1", ""),
            ("PTONLY/3,40", ""),
            ("CLPRNT", "Clprnt"),
            ("CLPRNT/OFF", "Clprnt"),
            ("NOPOST", "Nopost"),
            ("NOPLOT,CUTTER/1", "Noplot Cutter"),
            ("TITLES A HEADING", ""),
            ("PRINT/3,ALL", ""),
            ("PRINT/ON", ""),
            ("PUNCH/1,P", ""),
            ("MACHIN/BENDIX,2,CURCUL", "Post"),
            ("CLTV", ""),
            ("CLTV/OPTION", ""),
        ],
    );
}

#[test]
fn words_of_post_processors() {
    for statement in [
        "SPINDL/1000,CLW",
        "SPINDL/RPM,500,CCLW,LOW",
        "SPINDL/OFF",
        "FEDRAT/10,IPM",
        "FEDRAT/10,.5,2",
        "FEDRAT/IPR,.01,MAXIPM,20",
        "COOLNT/TAPKUL",
        "LOADTL/5,LENGTH,6,OFFSET,7",
        "SELCTL/5",
        "TOOLNO/5,6,LARGE",
        "CYCLE/DRILL,FEDTO,1,IPM,5,RAPTO,.1",
        "CYCLE/OFF",
        "CUTCOM/LEFT,XYPLAN,5",
        "ROTABL/ATANGL,90,CLW",
        "ROTHED/ATANGL,9",
        "AUXFUN/8",
        "PREFUN/17,NEXT",
        "DELAY/2,REV",
        "RAPID",
        "STOP",
        "OPSTOP",
        "ISTOP",
        "END",
        "RETRCT",
        "HEAD/BOTH",
        "TURRET/1,2,3,4,5,SIDE",
        "THREAD/5",
        "ARCSLP/LINCIR,ON",
        "ORIGIN/1,2,3",
        "TRANS/1,2,3",
        "SEQNO/10,INCR,5",
        "TMARK/AUTO",
        "LEADER/20",
        "OPSKIP/ON",
        "POSTN/2",
        "CHECK/1,2,3,AUTO",
        "CLAMP/1",
        "MODE/MILL",
        "SLOWDN/ON",
        "COUPLE/1,ATANGL,4",
        "MAXDPM/2",
        "PIVOTZ/3",
        "PLUNGE/5,6",
        "SAFETY/3",
        "DISPLY/1,2",
        "PPLOT/1",
        "MCHTOL/.1",
        "INTCOD/3",
        "CLEARP/XYPLAN,5",
        "CLRSRF/(PLANE/0,0,1,5)",
        "CLRSRF/NORMAL,0,0,1,5",
        "DWELL/3",
        "REWIND/2",
        "UNLOAD",
        "SWITCH",
        "DRESS",
        "PENUP",
        "PENDWN",
        "ZERO",
        "GOHOME",
        "RESET",
        "GOCLER",
        "DRAWLI",
        "PROBX",
        "PROBY",
        "ULOCKX",
        "LOCKX",
        "FACEML",
        "PICKUP",
        "MOVETO/3",
        "PBS/1",
        "PITCH/2",
        "PLABEL/1",
        "OVPLOT/1",
        "LETTER/1,2,3,4",
        "IFRO/1",
        "DRAFT/1",
        "CORNFD/1",
        "ASLOPE/2",
        "MAXVEL/3",
        "MCHFIN/1",
        "MDEND/1",
        "MDWRIT/1",
        "MAGTAP/1",
        "LPRINT/1",
    ] {
        let ran = clean(&format!("{statement}\nFINI\n"));
        assert_eq!(kinds(&ran), ["Post"], "{statement}");
    }
    for statement in ["PARTNO A PART", "PARTNO/'A PART'", "PPRINT TEXT,=(", "INSERT G0X1"] {
        assert_eq!(kinds(&clean(&format!("{statement}\nFINI\n"))), ["Text"], "{statement}");
    }
}

#[test]
fn inclusive_subscripts() {
    let text = "RESERV/A,4,B,12,P,8\nA(1)=0\nA(2)=0\nA(3)=1\nA(4)=2\nL1=LINE/A(ALL)\nDO/X,I=1,12\n\
        X) B(I)=I*I-I\nL2=LINE/B(7,THRU,10)\nDO/Y,I=1,8\nY) P(I)=POINT/I,(I*I/10),0\n\
        T1=TABCYL/NOZ,SPLINE,P(ALL)\nT2=TABCYL/NOZ,SPLINE,P(1,THRU,8,INCR,2)\n\
        PT=PATERN/RANDOM,P(8,THRU,8),P(1,THRU,4),P(5,THRU,3),P(ALL,DECR,3)\nGOTO/PT\n\
        PRINT/3,P(THRU,ALL)\nPUNCH/1,P(THRU,5,INCR,2)\nFINI\n";
    let ran = clean(text);
    let xs: Vec<f64> = ran.form("PT").chunks(3).map(|p| p[0]).collect();
    assert_eq!(xs.iter().map(|x| format!("{x}")).collect::<String>(), "812345852");
    assert_eq!(ran.listing.len(), 8 + 3);
}

#[test]
fn macros_with_words_points_and_locals() {
    let text = "M=MACRO/A,B=TLLFT,C=(3+4),D=P\nLOCAL/Q,R\nQ=A*2\nR=Q+C\nB,GOLFT/L1,TO,L2\nGOTO/D\n\
        1) Q=Q-1\nIF(Q)2,2,1\n2) GOTO/Q,R,0\nTERMAC\nP=POINT/1,2\nL1=LINE/XAXIS\nL2=LINE/YAXIS\n\
        CALL/M,A=4\nCALL/M,A=(2*3),B=TLRGT,D=(POINT/3,4)\nQ=5\nGOTO/Q,0,0\nFINI\n";
    let ran = clean(text);
    assert_eq!(support::numbers(&ran), [1.0, 0.0, 3.0, 0.0, 5.0]);
}

#[test]
fn obtain_in_every_spelling() {
    for head in ["OBTAIN,CIRCLE/C", "OBTAIN/CIRCLE,C", "OBTAIN/CIRCLE/C"] {
        let ran = clean(&format!("C=CIRCLE/1,2,5\n{head},X,,,,,,R\nGOTO/X,R,0\nFINI\n"));
        assert_eq!(support::numbers(&ran), [1.0], "{head}");
    }
}
