//! How statements are written that have no table of formats, and what the tables leave to be read by hand: for the pages
//! of words.

use aptc_vocabulary::{Class, Dialect, Word, word};

/// The forms of a statement: alternatives with `|`, what may be left out in `[ ]`, and `@` where the word itself stands.
pub(crate) fn usage(word: Word) -> &'static [&'static str] {
    match word.class() {
        Class::Geometry => geometry(word),
        Class::Function => function(word),
        Class::Post => post(word),
        _ => statement(word),
    }
}

fn statement(word: Word) -> &'static [&'static str] {
    match word {
        word::FROM => &["FROM/point[,vector]", "FROM/x,y[,z[,i,j,k]]"],
        word::GOTO => &[
            "GOTO/point[,vector][,feed]",
            "GOTO/x,y[,z[,i,j,k]][,feed]",
            "GOTO/pattern[,INVERS][,CONST|ZIGZAG][,OMIT|RETAIN,n,THRU,m,..][,AVOID,height,n,THRU,m,..]",
        ],
        word::GODLTA => {
            &["GODLTA/dx,dy,dz[,feed]", "GODLTA/vector", "GODLTA/length along the tool axis"]
        }
        word::GO | word::OFFSET => &[
            "@/[TO|ON|PAST,]drive surface",
            "@/TO|ON|PAST,drive surface,TO|ON|PAST,part surface[,TO|ON|PAST|TANTO,check surface]",
        ],
        word::GOLFT | word::GORGT | word::GOFWD | word::GOBACK | word::GOUP | word::GODOWN => &[
            "[TLLFT|TLRGT|TLON,]@/drive surface",
            "[TLLFT|TLRGT|TLON,]@/drive surface,TO|ON|PAST|TANTO|PSTAN,[n,INTOF,]check surface",
            "@/drive surface,TO,check surface,label,PAST,check surface,label",
        ],
        word::TLLFT | word::TLRGT | word::TLON | word::TLNDON => &["@,GOLFT/.."],
        word::TLONPS | word::TLOFPS => &["@", "[TLLFT|TLRGT|TLON,]@,GOLFT/.."],
        word::PSIS => &["PSIS/part surface"],
        word::INDIRV => &["INDIRV/vector", "INDIRV/i,j,k"],
        word::INDIRP => &["INDIRP/point", "INDIRP/x,y,z"],
        word::CUTTER => &[
            "CUTTER/diameter[,corner radius]",
            "CUTTER/d,r,e,f,a,b,h",
            "CUTTER/OPTION,1|2,radius,height|OFF",
        ],
        word::INTOL | word::OUTTOL => {
            &["@/for all surfaces", "@/part,drive,check,second check surface"]
        }
        word::TOLER => &["TOLER/for all surfaces", "TOLER/part,drive,check,second check surface"],
        word::THICK => &["THICK/for all surfaces", "THICK/part,drive,check,second check surface"],
        word::MAXDP => &["MAXDP/longest step[,longest path]"],
        word::TLAXIS => &[
            "TLAXIS/vector",
            "TLAXIS/i,j,k",
            "TLAXIS/NORMPS|NORMDS",
            "TLAXIS/PARLEL,1|2|PS|DS[,RADIUS,r][,HIGHT,h]",
            "TLAXIS/ATANGL,1|2|PS|DS,angle[,MOTDIR][,RADIUS,r][,HIGHT,h]",
            "TLAXIS/ATANGL,1|2|PS|DS,angle,[PERPTO,]vector[,RADIUS,r][,HIGHT,h]",
            "TLAXIS/ATANGL,1|2|PS|DS,angle,[PARLEL,]line|plane[,RADIUS,r][,HIGHT,h]",
            "TLAXIS/ATANGL,1|2|PS|DS,angle,CUTANG,[LEAD|LAG,]angle[,RADIUS,r][,HIGHT,h]",
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
        word::JUMPTO | word::TRANTO => &["@/label"],
        word::LOOPST | word::LOOPND => &["LOOPST  ..  LOOPND"],
        word::RESERV => &["RESERV/name,n[,name,n,..]"],
        word::OBTAIN => &["OBTAIN,kind/name,variable,variable,.."],
        word::PRINT => &[
            "PRINT/1|2|3|4,name,name,..",
            "PRINT/1|2|3|4,ALL",
            "PRINT/ON|OFF",
            "PRINT/0",
            "PRINT/AVPRT|AVMSG,ON|OFF",
            "PRINT/SSPRT|SSTEST|TABPRT|LIBPRT,ON|OFF",
        ],
        word::PUNCH => &["PUNCH/1|2|3,name,name,..", "PUNCH/1|2|3,ALL"],
        word::READ => &["READ/1,name", "READ/2,name"],
        word::INCLUD => &["INCLUD/'file'"],
        word::SYN => &["SYN/new,word,new,word,.."],
        word::MACHIN => &["MACHIN/name", "MACHIN/name,number"],
        word::TANTO | word::DSTAN | word::PSTAN => {
            &["GOFWD/drive surface,TANTO|DSTAN|PSTAN,[n,INTOF,]check surface"]
        }
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
        word::MULTAX => &["MULTAX[/ON|OFF]"],
        word::CANON => &[
            "CANON/ON|OFF",
            "name=kind/CANON,element,element,..",
            "name=kind/form,CANON,element,,element,..",
        ],
        word::TERMAC => &["name=MACRO/parameter[=value],..  ..  TERMAC"],
        word::CONTIN => &["label) CONTIN"],
        word::LOCAL => &["LOCAL/name,name,.."],
        word::LIBRY => &["LIBRY/name,name,.."],
        word::NOPOST | word::NOPLOT => &["@"],
        word::PARTNO | word::REMARK | word::TITLES | word::INSERT | word::PPRINT => &["@ text"],
        _ => &[],
    }
}

/// Formats of geometry that no table holds, and what stands behind `..` in those that one does.
fn geometry(word: Word) -> &'static [&'static str] {
    match word {
        word::POINT => &["POINT/CLDATA,n,TP|PDS|PPS,k", "POINT/CLDATA,k"],
        word::VECTOR => &["VECTOR/CLDATA,n,TA|TV|NDS|NPS,k", "VECTOR/CLDATA,k"],
        word::POLCON => &["POLCON/CANON,79 elements"],
        word::TABCYL => &[
            "TABCYL/..,point[,SLOPE,tangent|NORMAL,tangent],point[,SLOPE,tangent|NORMAL,tangent],..",
        ],
        word::PATERN => &[
            "PATERN/LINEAR,point,vector,INCR,increment,increment,..",
            "PATERN/LINEAR,point,vector,INCR,n,AT,increment,..",
        ],
        word::SCURV => &[
            "SCURV/CURSEG,point[,TANSPL|CRSSPL|NORMAL,vector],point,..",
            "SCURV/SPLINE,[WEIGHT,w,][LIMIT,l,]point[,TANSPL|CRSSPL|NORMAL,vector][,WEIGHT,w][,LIMIT,l],point,..",
            "SCURV/SEG,line|circle,line|circle[,POSX|POSY|NEGX|NEGY],line|circle[,POSX|POSY|NEGX|NEGY]",
            "SCURV/..,FLOW,ARC|PARAM,n1,n2[,RELTOL,t],..,SEG,LENGTH|PARAM,n1,n2,..",
            "SCURV/..,FLOW,ANGLE,n1,n2,[PIVOT,]point[,RELTOL,t],..,SEG,LENGTH|PARAM,n1,n2,..",
            "SCURV/..,FLOW,CHORD,n1,n2[,[CHDPT,]point,point|[PLANO,]vector][,RELTOL,t],..,SEG,LENGTH|PARAM,n1,n2,..",
            "SCURV/..,TRFORM,matrix",
        ],
        word::SSURF => &[
            "SSURF/SMESH|GMESH,..,[WEIGHT,w,][LIMIT,l,]SPLINE,[WEIGHT,w,][LIMIT,l,]point[,TANSPL|CRSSPL|NORMAL,vector][,WEIGHT,w][,LIMIT,l],..",
            "SSURF/GENCUR,curve,curve,..[,CROSS,curve,curve,..][,TRFORM,matrix]",
            "SSURF/..,TRFORM,matrix",
        ],
        word::BOUNDS => {
            &["BOUNDS/surface[,IN|OUT|POSX|POSY|POSZ|NEGX|NEGY|NEGZ|point|number],surface,.."]
        }
        _ => &[],
    }
}

fn function(word: Word) -> &'static [&'static str] {
    match word {
        word::ATAN2F | word::ATAN2B => &["@(y,x)"],
        word::MODF | word::SIGNF => &["@(a,b)"],
        word::MINF | word::MAXF => &["@(a,b,..)"],
        word::DOTF => &["DOTF(vector,vector)"],
        word::SPATF => &["SPATF(vector,vector,vector)"],
        word::LNTHF => &["LNTHF(vector)"],
        word::ANGLF | word::ANGLB => &["@(circle,point)"],
        word::DISTF => &["DISTF(point|line|plane,point|line|plane)"],
        word::NUMF => &["NUMF(pattern)", "NUMF(curve|surface)", "NUMF(CLDATA[,n])"],
        word::PARMF => &[
            "PARMF(UVAL|VVAL|PVAL|TVAL|SVAL)",
            "PARMF(curve[,PARAM|FLOW])",
            "PARMF(surface[,PATCH|UPARAM|VPARAM])",
        ],
        word::CANF => &["CANF(name,n)"],
        word::CLDATF => &["CLDATF(n,UPS|VPS|PPS|UDS|VDS|PDS,k)"],
        _ if word.is_in(Dialect::Apt360) || word.is_in(Dialect::Apt4) => &["@(number)"],
        _ => &[],
    }
}

/// The words that the posts for the usual machines know.
fn post(word: Word) -> &'static [&'static str] {
    match word {
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
        word::SELCTL | word::TURRET => &["@/n"],
        word::CUTCOM => &["CUTCOM/LEFT|RIGHT,n", "CUTCOM/OFF"],
        word::CLRSRF => &["CLRSRF/z", "CLRSRF/NOW"],
        word::RAPID | word::RETRCT | word::GOHOME | word::STOP | word::OPSTOP | word::END => &["@"],
        word::STOCK => &["STOCK/x1,y1,z1,x2,y2,z2"],
        word::THREAD => &["THREAD/k", "THREAD/OFF"],
        word::ROTABL | word::ROTHED => &["@/[AXIS,n,]ATANGL|INCR,angle[,CLW|CCLW]"],
        word::ARCSLP => &["ARCSLP/LINCIR,ON[,t]", "ARCSLP/LINCIR,OFF"],
        word::DELAY => &["DELAY/t"],
        word::OPSKIP => &["OPSKIP/ON|OFF"],
        word::SEQNO => &["SEQNO/n[,INCR,i]"],
        word::PREFUN | word::AUXFUN => &["@/n"],
        word::ORIGIN | word::TRANS => &["@/x,y,z"],
        word::MCHTOL => &["MCHTOL/t"],
        word::LINTOL => &["LINTOL/t", "LINTOL/ON"],
        _ => &[],
    }
}
