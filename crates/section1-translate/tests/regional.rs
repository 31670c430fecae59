//! Regional milling and its checks: every format of the tables passes, and what leaves them is told where
//! it does.

mod support;

use aptc_protap::Kind;
use support::run;

const SCENE: &str = "P1=POINT/0,0,0\nP2=POINT/1,0,0\nQ1=POINT/0,1,0\nQ2=POINT/1,1,0\n\
                     V=VECTOR/0,0,1\nPL=PLANE/0,0,1,9\nK=CYLNDR/0,0,0,0,0,1,3\n\
                     C=SCURV/SPLINE,P1,P2\nS=SSURF/SMESH,XYZ,SPLINE,P1,P2,SPLINE,Q1,Q2\n";

/// Line of the statement under test.
const LINE: u32 = 10;

#[test]
fn every_format_passes_as_it_is_written() {
    for statement in [
        "SCON/INIT,ALL",
        "SCON/INIT,DS,PS,AXIS",
        "SCON/DS,C,PARAM,0,1,AT,V",
        "SCON/DS,C,PARAM,0,1,ON,CRSSPL,.5",
        "SCON/DS,S,PARAM,0,1,0,1,ON,V",
        "SCON/DS,S,PARAM,0,1,.2,.8,AT,NORMAL,2",
        "SCON/PS,TO,S,PLUS,.1",
        "SCON/PS,ON,S,MINUS,0",
        "SCON/AXIS,V",
        "SCON/AXIS,(VECTOR/0,1,1),MINUS",
        "SCON/AXIS,NORMDS,PLUS",
        "SCON/AXIS,ATANGL,PS,10,CUTANG,5",
        "SCON/AXIS,ATANGL,DS,10,CUTANG,LAG,5",
        "SCON/FEED,PL",
        "SCON/FEED,1,2,3,4",
        "SCON/STEPOV,.05,1,0,0",
        "SMIL/POSN,DS,PARAM,0,0,INCR,V",
        "SMIL/POSN,DS,PARAM,0,0,INCR,2.5",
        "SMIL/POSN,DS,PARAM,0,0,INCR,PL",
        "SMIL/PATH,DS,PARAM,0,0,TANSPL,PLUS",
        "SMIL/PATH,DS,PARAM,0,0,CRSSPL,MINUS,1",
        "SMIL/ZIGZAG,DS,PARAM,0,0,TANSPL,PLUS,STEPOV,MINUS",
        "SMIL/PICKFD,DS,PARAM,0,0,TANSPL,PLUS,STEPOV,PLUS,1",
        "CHKSRF/PS,ON",
        "CHKSRF/S,OFF",
        "CHKSRF/K,PS,S,ON",
        "CHKSRF/S,S,S,S,S,S,S,S,K,ON",
        "AVCTRL/ON",
        "AVCTRL/AXIS,LIMIT,3",
        "AVCTRL/CUTANG,CONST,1,RANGE,-5,5,NORMPS,LIMIT,2",
        "GOLOFT/S,UCONST,0.5",
        "GOLOFT/S,VCONST,0,START,TO,PL,THRU,PAST,PL,INVERS,MIRROR,INCR,.1",
        "GOLOFT/S,VCONST,0,THRU,1.5,LENGTH,3",
        "GOLOFT/S,AT,0.3",
        "GOLOFT/C,START,0,THRU,1,PARAM,CHORD,.01",
        "PLOTFT/S,GRID,UCONST,3,VCONST,5,INCR,.1",
        "PLOTFT/S,UCONST,.5,START,TO,PL,CHORD,.1",
        "PLOTFT/C,START,0,THRU,1,FLOW",
        "GOMILL/S,UCONST,0,STEPOV,2,ZIGZAG,SCALOP,.1,MAXSTP,3,RETR,V,START,0",
        "GOMILL/S,VCONST,0,THRU,1,INVERS,MIRROR,AT,.5,RETR,PL",
        "GCLEAR/START,ON",
        "GCLEAR/AWAY,MOTDIR,2,NORMAL,3,PARLEL,V,FEED,100,CLEARS,S",
        "GCLEAR/CLEARS,K",
        "CLDAT/START,1,TP,TA,UVPPS",
        "CLDAT/NOMORE,1",
        "REGION/1,IN",
        "REGION/OFF",
        "TLPROJ/V",
        "TLPROJ/V,AT",
        "TLPROJ/NORMAL,ON",
        "TLPROJ/OFF",
        "INTSEC/PL,S",
        "INTSEC/PL,WITH,S,CANON",
        "INTSEC/(LINE/P1,Q2),S,S,CANON",
        "INTSEC/S,WITH,(SSURF/SMESH,XYZ,SPLINE,P1,Q1,SPLINE,P2,Q2)",
    ] {
        let ran = run(&format!("{SCENE}{statement}\nFINI\n"));
        assert!(ran.diagnostics.is_empty(), "{}", ran.messages());
        let Some((word, _)) = statement.split_once('/') else { panic!("{statement}") };
        let handed =
            ran.kinds().iter().any(|k| matches!(k, Kind::Regional { word: w, .. } if w == word));
        assert!(handed, "{statement} reaches PROTAP");
    }
}

#[test]
fn a_curve_has_no_grid() {
    let ran = run(&format!("{SCENE}PLOTFT/C,GRID\nFINI\n"));
    assert_eq!(ran.diagnostics.len(), 1, "{}", ran.messages());
    assert!(!ran.kinds().iter().any(|k| matches!(k, Kind::Regional { .. })));
}

#[test]
fn what_leaves_the_tables_is_told_there() {
    for (statement, column) in [
        ("SCON/DS,C,PARAM,0,1,TO,V", 21),
        ("SCON/DS,C,PARAM,1,0,ON,V", 19),
        ("SCON/DS,PL,PARAM,0,1,ON,V", 9),
        ("SCON/PS,TO,S,PLUS", 18),
        ("SCON/STEPOV,1,2,3", 18),
        ("SCON/AXIS,5", 11),
        ("SMIL/PATH,DS,PARAM,0,0,TANSPL", 30),
        ("SMIL/ZIGZAG,DS,PARAM,0,0,TANSPL,PLUS,PLUS", 38),
        ("GOLOFT/S,UCONST,0,INCR,.1,CHORD,.2", 27),
        ("GOLOFT/PL,UCONST,0", 8),
        ("CHKSRF/S,K", 11),
        ("CHKSRF/ON", 8),
        ("CHKSRF/S,ON,K", 13),
        ("AVCTRL/CUTANG,CONST,1", 22),
        ("REGION/1,ON", 10),
        ("CLDAT/START,1,XY", 15),
        ("TLPROJ/S", 8),
        ("TLPROJ/V,TO", 10),
        ("INTSEC/P1,S", 8),
        ("INTSEC/PL", 10),
        ("INTSEC/PL,S,WITH,S", 13),
        ("INTSEC/S", 9),
        ("INTSEC/S,WITH,CANON", 15),
        ("INTSEC/S,WITH,S", 15),
        ("INTSEC/PL,S,CANON,S", 19),
    ] {
        let ran = run(&format!("{SCENE}{statement}\nFINI\n"));
        assert_eq!(ran.diagnostics.len(), 1, "{statement}\n{}", ran.messages());
        let start = u32::try_from(SCENE.len()).unwrap() + column - 1;
        assert_eq!(ran.diagnostics[0].span.start, start, "{statement}\n{}", ran.messages());
        assert_eq!(ran.told()[0].1, LINE);
    }
}
