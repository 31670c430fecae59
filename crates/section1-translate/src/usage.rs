//! How the statements that have no table of formats are written, for the pages of words.

use aptc_vocabulary::{Word, word};

/// The forms of a statement: alternatives with `|`, what may be left out in `[ ]`.
pub(crate) fn usage(word: Word) -> &'static [&'static str] {
    match word {
        word::FROM => &["FROM/point[,vector]", "FROM/x,y[,z[,i,j,k]]"],
        word::GOTO => &[
            "GOTO/point[,vector][,feed]",
            "GOTO/x,y[,z[,i,j,k]][,feed]",
            "GOTO/pattern[,INVERS][,OMIT|RETAIN,n,..][,AVOID,height,n,..]",
        ],
        word::GODLTA => {
            &["GODLTA/dx,dy,dz[,feed]", "GODLTA/vector", "GODLTA/length along the tool axis"]
        }
        word::GO | word::OFFSET => &[
            "GO/TO|ON|PAST,drive surface",
            "GO/TO|ON|PAST,drive surface,TO|ON|PAST,part surface[,TO|ON|PAST|TANTO,check surface]",
        ],
        word::GOLFT | word::GORGT | word::GOFWD | word::GOBACK | word::GOUP | word::GODOWN => &[
            "[TLLFT|TLRGT|TLON,]GOLFT/drive surface",
            "[TLLFT|TLRGT|TLON,]GOLFT/drive surface,TO|ON|PAST|TANTO|PSTAN,[n,INTOF,]check surface",
            "GOLFT/drive surface,TO,check surface,label,PAST,check surface,label",
        ],
        word::TLLFT | word::TLRGT | word::TLON => &["TLLFT,GOLFT/.."],
        word::PSIS => &["PSIS/part surface"],
        word::INDIRV => &["INDIRV/vector", "INDIRV/i,j,k"],
        word::INDIRP => &["INDIRP/point", "INDIRP/x,y,z"],
        word::CUTTER => &[
            "CUTTER/diameter[,corner radius]",
            "CUTTER/d,r,e,f,a,b,h",
            "CUTTER/OPTION,1|2,radius,height|OFF",
        ],
        word::INTOL | word::OUTTOL => {
            &["OUTTOL/for all surfaces", "OUTTOL/part,drive,check surface"]
        }
        word::TOLER => &["TOLER/tolerance"],
        word::THICK => &["THICK/for all surfaces", "THICK/part,drive,check surface"],
        word::MAXDP => &["MAXDP/longest step"],
        word::TLAXIS => &[
            "TLAXIS/vector",
            "TLAXIS/i,j,k",
            "TLAXIS/NORMPS|NORMDS",
            "TLAXIS/PARLEL,1|2",
            "TLAXIS/ATANGL,1|2,angle[,vector]",
            "TLAXIS/ATANGL,1|2,angle,CUTANG,[LEAD|LAG,]angle",
            "TLAXIS/PERPTO,vector",
            "TLAXIS/LAST",
            "TLAXIS/1",
        ],
        word::POCKET => &["POCKET/re,c,f,f1,f2,f3,o,p,point,point,point,.."],
        word::INDEX => &["INDEX/n", "INDEX/n,NOMORE"],
        word::COPY => &[
            "COPY/n,TRANSL,dx,dy,dz,times",
            "COPY/n,XYROT|YZROT|ZXROT,angle,times",
            "COPY/n,MODIFY,matrix,times",
            "COPY/n,SAME,times",
        ],
        word::TRACUT => &["TRACUT/matrix", "TRACUT/NOMORE"],
        word::REFSYS => &["REFSYS/matrix", "REFSYS/NOMORE"],
        word::ZSURF => &["ZSURF/plane", "ZSURF/z"],
        word::UNITS => &["UNITS/MM|CM|INCHES|FEET"],
        word::MACRO => &["name=MACRO/parameter[=value],..  .. TERMAC"],
        word::CALL => &["CALL/macro[,parameter=value,..]"],
        word::DO => &["DO/label,variable=first,last[,step]"],
        word::IF => &[
            "IF(number)label if negative,label if zero,label if positive",
            "IF(condition)statement",
        ],
        word::JUMPTO => &["JUMPTO/label"],
        word::LOOPST | word::LOOPND => &["LOOPST  ..  LOOPND"],
        word::RESERV => &["RESERV/name,n[,name,n,..]"],
        word::OBTAIN => &["OBTAIN,kind/name,variable,variable,.."],
        word::PRINT => &["PRINT/3,ALL", "PRINT/3,name,name,..", "PRINT/ON|OFF", "PRINT/0"],
        word::PUNCH => &["PUNCH/1|2|3,name,name,..", "PUNCH/1|2|3,ALL"],
        word::READ => &["READ/1,name", "READ/2,name"],
        word::INCLUD => &["INCLUD/'file'"],
        word::SYN => &["SYN/new,word,new,word,.."],
        word::MACHIN => &["MACHIN/name", "MACHIN/name,number"],
        word::LOADTL => &["LOADTL/n[,LENGTH,l][,OFFSET,h]"],
        word::SPINDL => {
            &["SPINDL/n,CLW|CCLW", "SPINDL/v,SMM|SFM,CLW|CCLW[,MAXRPM,n]", "SPINDL/OFF"]
        }
        word::FEDRAT => &[
            "FEDRAT/f[,MMPM|MMPR|IPM|IPR]",
            "FEDRAT/feed,distance,feed from there to the check surface[,MMPM|MMPR|IPM|IPR]",
            "FEDRAT/distance,feed from there to the next check surface[,MMPM|MMPR|IPM|IPR]",
        ],
        word::COOLNT => &["COOLNT/ON|FLOOD|MIST|OFF"],
        word::CYCLE => &[
            "CYCLE/DRILL|FACE|DEEP|BRKCHP|TAP|BORE|REAM|CSINK,DEPTH,d,MMPM|MMPR,f,CLEAR,c[,STEP,s][,DWELL,t]",
            "CYCLE/OFF",
        ],
        word::TANTO | word::DSTAN | word::PSTAN => {
            &["GOFWD/drive surface,TANTO|DSTAN|PSTAN,[n,INTOF,]check surface"]
        }
        word::TLNDON => &["TLNDON,GOLFT/.."],
        word::NOPS => &["NOPS"],
        word::AUTOPS => &["AUTOPS"],
        word::NUMPTS => &["NUMPTS/n"],
        word::SRFVCT => &[
            "SRFVCT/vector for the drive surface[,vector for the part surface[,for the check surface]]",
            "SRFVCT/i,j,k[,i,j,k[,i,j,k]]",
        ],
        word::DNTCUT | word::CUT => &["DNTCUT  ..  CUT"],
        word::W2DCALC => &["2DCALC"],
        word::W3DCALC => &["3DCALC"],
        word::NDTEST => &["NDTEST"],
        word::CLPRNT => &["CLPRNT", "CLPRNT/ON  ..  CLPRNT/OFF", "CLPRNT/OPTION  ..  CLPRNT/OFF"],
        word::GOUGCK => &["GOUGCK[/ON|OFF]"],
        word::FINI => &["FINI"],
        _ => &[],
    }
}

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
            "Brings the tool to its surfaces as GO does, but to the nearest place, without a direction of its own."
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
        word::FINI => "Ends the part program; what follows in the file is a further one.",
        _ => return None,
    })
}
