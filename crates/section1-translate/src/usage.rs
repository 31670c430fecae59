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
        word::PRINT => &["PRINT/3,ALL", "PRINT/3,name,name,..", "PRINT/ON|OFF"],
        word::INCLUD => &["INCLUD/'file'"],
        word::SYN => &["SYN/new,word,new,word,.."],
        word::MACHIN => &["MACHIN/name", "MACHIN/name,number"],
        word::LOADTL => &["LOADTL/n[,LENGTH,l][,OFFSET,h]"],
        word::SPINDL => {
            &["SPINDL/n,CLW|CCLW", "SPINDL/v,SMM|SFM,CLW|CCLW[,MAXRPM,n]", "SPINDL/OFF"]
        }
        word::FEDRAT => &["FEDRAT/f[,MMPM|MMPR|IPM|IPR]"],
        word::COOLNT => &["COOLNT/ON|FLOOD|MIST|OFF"],
        word::CYCLE => &[
            "CYCLE/DRILL|FACE|DEEP|BRKCHP|TAP|BORE|REAM|CSINK,DEPTH,d,MMPM|MMPR,f,CLEAR,c[,STEP,s][,DWELL,t]",
            "CYCLE/OFF",
        ],
        _ => &[],
    }
}
