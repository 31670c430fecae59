//! Seeded mistakes: each is told once, at its place, with what to do, and nothing follows from it.

mod support;

use support::run;

/// A part program that is right.
const GOOD: &str = "\
PARTNO PLATE
UNITS/MM
RESERV/H,4
SETPT=POINT/0,0,50
LX=LINE/XAXIS
LY=LINE/YAXIS
L3=LINE/PARLEL,LX,YLARGE,40
TOP=PLANE/0,0,1,10
C1=CIRCLE/60,20,15
R=5
DO/10,I=1,4
10) H(I)=POINT/(I*10),20
HOLES=PATERN/RANDOM,H(1,THRU,4)
M1=MATRIX/TRANSL,0,100,0
DRILL=MACRO/PAT,DEEP=12
CYCLE/DRILL,DEEP,MMPM,100,2
GOTO/PAT
CYCLE/OFF
TERMAC
CUTTER/10
OUTTOL/.02
SPINDL/2000,CLW
FEDRAT/300,MMPM
FROM/SETPT
INDEX/1
GO/TO,LX,ON,TOP
TLRGT,GORGT/LX,TO,LY
GORGT/LY,PAST,L3,250
INDEX/1,NOMORE
COPY/1,MODIFY,M1,2
GOTO/SETPT
LOADTL/2
CALL/DRILL,PAT=HOLES,DEEP=(R+4)
IF(R-5)20,30,20
20) STOP
30) OBTAIN,CIRCLE/C1,CX,CY
GOTO/CX,CY,50
END
FINI
";

/// A change: the line it replaces, the line with the mistake, the code, the text that the message points
/// at, and a part of what it says to do.
type Mistake = (&'static str, &'static str, u16, &'static str, &'static str);

const MISTAKES: &[Mistake] = &[
    // the plane that is to be cut is the one that cuts
    (
        "LOADTL/2",
        "RR=RLDSRF/TOP,(POINT/0,0,10),(POINT/9,0,10),(VECTOR/0,5,0),SETPT",
        1205,
        "(VECTOR/0,5,0)",
        "",
    ),
    // names
    ("FROM/SETPT", "FROM/SETTP", 1050, "SETTP", "did you mean SETPT?"),
    ("LOADTL/2", "LOADTL/QQQQ", 1050, "QQQQ", "define QQQQ"),
    ("LX=LINE/XAXIS", "LX=LIEN/XAXIS", 1050, "LIEN", "did you mean LINE?"),
    ("LX=LINE/XAXIS", "LX=LINE/X-AXIS", 1050, "X", "define X"),
    ("LOADTL/2", "LOADTL/1E3", 1050, "1E3", "has a point: 1.E3"),
    ("LOADTL/2", "LOADTL/15E-300", 1050, "15E", "has a point: 15.E-300"),
    ("LOADTL/2", "LOADTL/1E+2,3", 1050, "1E", "has a point: 1.E+2"),
    ("GO/TO,LX,ON,TOP", "GO/TO,LX,ON,TOPP", 1050, "TOPP", "did you mean TOP?"),
    ("GORGT/LY,PAST,L3,250", "GORGT,LY,PAST,L3", 1304, "GORGT", "write GORGT/ and its arguments"),
    ("TLRGT,GORGT/LX,TO,LY", "GORGT,TLRGT/LX,TO,LY", 1304, "GORGT", "after all other words"),
    ("GORGT/LY,PAST,L3,250", "GORGT/LY,PSAT,L3,250", 1050, "PSAT", "did you mean PAST?"),
    (
        "HOLES=PATERN/RANDOM,H(1,THRU,4)",
        "HOLES=PATERN/RANDOM,H(1,THRU,5)",
        1059,
        "H(1,THRU,5)",
        "reserve more",
    ),
    ("HOLES=PATERN/RANDOM,H(1,THRU,4)", "HOLES=PATERN/RANDOM,H(1,2)", 1060, "H(1,2)", "(a,THRU,b)"),
    ("HOLES=PATERN/RANDOM,H(1,THRU,4)", "HOLES=PATERN/RANDOM,H", 1058, "H", "H(ALL)"),
    ("10) H(I)=POINT/(I*10),20", "10) H(I+4)=POINT/(I*10),20", 1059, "I+4", "reserve more"),
    ("RESERV/H,4", "RESERV/G,4", 1057, "H", "RESERV/H,n"),
    ("RESERV/H,4", "RESERV/H,-4", 1061, "-4", "RESERV/name,n"),
    ("RESERV/H,4", "RESERV/H,4.5", 1061, "4.5", "RESERV/name,n"),
    ("RESERV/H,4", "RESERV/H", 1061, "H", "RESERV/name,n"),
    ("LY=LINE/YAXIS", "LY=LINE/YAXIS\nLY=LINE/PARLEL,LY,XLARGE,0", 1062, "LY", "CANON/ON"),
    ("R=5", "R=5\nC1=3", 1063, "C1", "another name"),
    ("R=5", "R=5\nR=POINT/1,2", 1063, "R", "another name"),
    ("R=5", "R=SQRTF(-5)", 1053, "SQRTF(-5)", ""),
    ("R=5", "R=5/0", 1054, "5/0", ""),
    ("R=5", "R=TOP+1", 1052, "TOP", ""),
    ("R=5", "R=CLW", 1052, "R", "macro parameters"),
    ("R=5", "R=SINF(1,2)", 1055, "SINF(1,2)", ""),
    ("R=5", "R=SINE(30)", 1057, "SINE", "RESERV/SINE"),
    ("R=5", "R=COLF(30)", 1056, "COLF", ""),
    ("30) OBTAIN,CIRCLE/C1,CX,CY", "30) OBTAIN,LINE/C1,CX,CY", 1064, "LINE", "OBTAIN,CIRCLE/"),
    (
        "30) OBTAIN,CIRCLE/C1,CX,CY",
        "30) OBTAIN,CIRCLE/C1,CX,CY,,,,,,Q",
        1064,
        "Q",
        "count the commas",
    ),
    ("TOP=PLANE/0,0,1,10", "TOP=PLNE/0,0,1,10", 1065, "PLNE", "did you mean PLANE?"),
    ("PARTNO PLATE", "SYN/XX,YY", 1066, "YY", "first or second"),
    // geometry, from its own tables
    ("LX=LINE/XAXIS", "LX=LINE/1,1,1,1", 1204, "1", ""),
    ("TOP=PLANE/0,0,1,10", "TOP=PLANE/0,0,0,10", 1219, "0", ""),
    ("L3=LINE/PARLEL,LX,YLARGE,40", "L3=LINE/PARLEL,LX,YLARGE", 1200, "", ""),
    ("L3=LINE/PARLEL,LX,YLARGE,40", "L3=LINE/PARLEL,LX,XLARGE,40", 1210, "XLARGE", "YLARGE"),
    ("C1=CIRCLE/60,20,15", "C1=CIRCLE/60,20,-15", 1208, "-15", ""),
    // control
    ("IF(R-5)20,30,20", "IF(R-5)20,30,40", 1080, "40", "put `40)`"),
    ("IF(R-5)20,30,20", "JUMPTO/21", 1080, "21", "put `21)`"),
    ("20) STOP", "30) STOP\n20) STOP", 1081, "30", "another name"),
    ("DO/10,I=1,4", "DO/11,I=1,4", 1080, "11", "put `11)`"),
    ("DO/10,I=1,4", "DO/10,I=1,4,0", 1086, "0", "negative step"),
    ("LOADTL/2", "DO/10,I=1,2", 1085, "10", "last statement"),
    ("20) STOP", "20) LOOPST", 1082, "20) LOOPST", "LOOPND"),
    ("20) STOP", "20) LOOPND", 1083, "20) LOOPND", "LOOPST"),
    ("CYCLE/OFF", "NEW=MACRO/", 1089, "NEW=MACRO/", "TERMAC"),
    ("LOADTL/2", "TERMAC", 1088, "TERMAC", "name=MACRO"),
    ("LOADTL/2", "DRILL=MACRO/\nTERMAC", 1090, "DRILL", "another name"),
    (
        "CALL/DRILL,PAT=HOLES,DEEP=(R+4)",
        "CALL/DRIL,PAT=HOLES",
        1091,
        "DRIL",
        "the macros are DRILL",
    ),
    ("CALL/DRILL,PAT=HOLES,DEEP=(R+4)", "CALL/DRILL,PAT=HOLES,DEPTH=9", 1092, "DEPTH", "PAT, DEEP"),
    ("CALL/DRILL,PAT=HOLES,DEEP=(R+4)", "CALL/DRILL,DEEP=9", 1093, "DRILL", "PAT=value"),
    ("CALL/DRILL,PAT=HOLES,DEEP=(R+4)", "CALL/DRILL,HOLES", 1092, "HOLES", "parameter=value"),
    ("CALL/DRILL,PAT=HOLES,DEEP=(R+4)", "CALL/DRILL,PAT=HOLES,PAT=HOLES", 1092, "PAT", "once"),
    ("LOADTL/2", "CALL/SPECIA,SEC2,1,2", 1094, "SPECIA", "macro"),
    ("LOADTL/2", "READ/2,TOOLS", 1095, "TOOLS", ""),
    ("LOADTL/2", "LOCAL/A", 1067, "LOCAL/A", "MACRO"),
    // statements
    ("GORGT/LY,PAST,L3,250", "GORTG/LY,PAST,L3,250", 1300, "GORTG", "did you mean GORGT?"),
    ("GORGT/LY,PAST,L3,250", "GORGT/LY,PAST,L3,X1", 1080, "X1", "put `X1)`"),
    ("GORGT/LY,PAST,L3,250", "GORGT/LY,PAST,SETPT", 1304, "SETPT", ""),
    ("GORGT/LY,PAST,L3,250", "GORGT/LY,PAST", 1304, "", ""),
    ("GORGT/LY,PAST,L3,250", "GORGT/LY,PAST,0,INTOF,L3", 1304, "0", ""),
    ("GO/TO,LX,ON,TOP", "GO/TANTO,LX,ON,TOP", 1304, "TANTO", ""),
    ("GO/TO,LX,ON,TOP", "INDIRV/0,0,0", 1304, "", ""),
    ("FROM/SETPT", "FROM/TOP", 1304, "TOP", ""),
    ("FROM/SETPT", "FROM/1,2,3,4,5", 1304, "5", ""),
    ("CUTTER/10", "CUTTER/10,6", 1306, "6", "CUTTER/d"),
    ("CUTTER/10", "CUTTER/10,2,3", 1306, "CUTTER/10,2,3", "CUTTER/d"),
    ("OUTTOL/.02", "OUTTOL/-.02", 1307, "-.02", "lengths"),
    ("OUTTOL/.02", "TLAXIS/0,0,0", 1308, "0", ""),
    ("GOTO/SETPT", "GOTO/SETPT,0,0,0", 1308, "0", ""),
    ("OUTTOL/.02", "TLAXIS/ATANGL,1,100", 1308, "100", "surface normal"),
    ("OUTTOL/.02", "UNITS/MILES", 1304, "MILES", "MM, CM"),
    ("UNITS/MM", "UNITS/ON", 1304, "ON", ""),
    ("INDEX/1", "INDEX/A1", 1050, "A1", ""),
    ("COPY/1,MODIFY,M1,2", "COPY/1,MODIFY,M1", 1304, "", "how many copies"),
    ("COPY/1,MODIFY,M1,2", "COPY/1,MODIFY,C1,2", 1304, "C1", ""),
    ("COPY/1,MODIFY,M1,2", "COPY/1,MODIFY,M1,2.5", 1304, "2.5", ""),
    ("COPY/1,MODIFY,M1,2", "COPY/1,SAME,0", 1304, "0", ""),
    ("COPY/1,MODIFY,M1,2", "TRACUT/C1", 1304, "C1", ""),
    ("LOADTL/2", "DMILL/1", 1303, "DMILL", "other statements"),
    ("LOADTL/2", "NUMPTS/0", 1304, "0", ""),
    ("LOADTL/2", "MAXDP/0", 1304, "0", ""),
    ("LOADTL/2", "MAXDP/-1", 1304, "-1", ""),
    ("LOADTL/2", "PTONLY/1", 1305, "PTONLY", ""),
    ("GOTO/SETPT", "RAPID/GOTO/SETPT", 1052, "GOTO", "behind a `,`"),
    ("FROM/SETPT", "FROM/1,2,,3", 1304, "", "extra comma"),
    ("LOADTL/2", "CUTTER/10 MM", 1050, "10 MM", "it is 10 and MM"),
    ("C1=CIRCLE/60,20,15", "C1=CIRCLE/CENTER,SETPT,RADI,15", 1050, "RADI", "did you mean RADIUS?"),
    ("LX=LINE/XAXIS", "LX=LINE(0,0,9,0)", 1056, "LINE(0,0,9,0)", "write LINE/.."),
    // Words of the post-processor misspelt: the part would be cut without what they say.
    ("LOADTL/2", "COOLANT/ON", 1301, "COOLANT", "did you mean COOLNT?"),
    ("LOADTL/2", "LODTL/2", 1301, "LODTL", "did you mean LOADTL?"),
    ("LOADTL/2", "STOPP", 1301, "STOPP", "did you mean STOP?"),
    ("LOADTL/2", "COOLNT/WATER", 1050, "WATER", "write COOLNT/ON|FLOOD|MIST|OFF"),
    ("LOADTL/2", "CYCLE/BOREE,DEPTH,5", 1050, "BOREE", "did you mean BORE?"),
    ("LOADTL/2", "COOLNT,ON", 1304, "COOLNT,ON", "write COOLNT/ON"),
    ("LOADTL/2", "CUTTER=12", 1304, "CUTTER", "write CUTTER/.."),
    ("LOADTL/2", "HH=HEX/1A2B", 1303, "HEX", ""),
    ("LOADTL/2", "HH=SSURF/HEX,1A2B", 1303, "HEX", ""),
    ("LOADTL/2", "HH=SSURF/FETCH,WING", 1303, "FETCH", ""),
    ("LOADTL/2", "HH=LOFT/QQ1,QQ2", 1303, "LOFT", ""),
    ("LOADTL/2", "HH=SPLINE/SETPT,LX", 1065, "SPLINE", "SCURV/SPLINE,.."),
    ("LOADTL/2", "HH=LINE/SETPT,SETPT", 1204, "SETPT", ""),
    ("LOADTL/2", "DEBUG/ON", 1305, "DEBUG", ""),
    ("LOADTL/2", "RAPIDE", 1301, "RAPIDE", "did you mean RAPID?"),
    ("LOADTL/2", "XLARGE/2", 1300, "XLARGE", ""),
    ("LOADTL/2", "POINT/1,2", 1300, "POINT", ""),
    ("LOADTL/2", "SPINDL/,2", 1304, "", "extra comma"),
    (
        "LOADTL/2",
        "POCKET/1,1,1,1,1,1,0,0,0,0,0,1,1,1",
        1309,
        "POCKET/1,1,1,1,1,1,0,0,0,0,0,1,1,1",
        "3 to 20",
    ),
    ("LOADTL/2", "AUTOPS/1", 1304, "1", "alone"),
    ("LOADTL/2", "MULTAX/MAYBE", 1050, "MAYBE", ""),
    ("LOADTL/2", "ZSURF/(PLANE/1,0,0,3)", 1221, "(PLANE/1,0,0,3)", "leans"),
    ("LOADTL/2", "REFSYS/C1", 1304, "C1", ""),
    ("LOADTL/2", "PRINT/3,HOLE", 1051, "HOLE", "did you mean HOLES?"),
    ("LOADTL/2", "PRINT/9,R", 1304, "PRINT/9,R", "PRINT/3,names"),
    ("FINI\n", "FINI\nA=1", 1097, "A=1", "head the further part program with PARTNO"),
    ("FINI\n", "$$ the end", 1096, "END", "FINI"),
];

#[test]
fn the_program_without_mistakes_has_no_messages() {
    support::clean(GOOD);
}

#[test]
fn each_mistake_is_told_once_in_its_place() {
    let mut failures = Vec::new();
    for (good, bad, code, place, help) in MISTAKES {
        assert_eq!(
            GOOD.matches(&format!("\n{}\n", good.trim_end())).count()
                + usize::from(GOOD.starts_with(good)),
            1,
            "{good}"
        );
        let at = if GOOD.starts_with(good) {
            0
        } else {
            GOOD.find(&format!("\n{}\n", good.trim_end())).unwrap() + 1
        };
        let text = format!("{}{bad}{}", &GOOD[..at], &GOOD[at + good.trim_end().len()..]);
        let ran = run(&text);
        let [told] = ran.diagnostics.as_slice() else {
            failures.push(format!("{bad}: {} messages\n{}", ran.diagnostics.len(), ran.messages()));
            continue;
        };
        let spanned = &text[told.span.start as usize..told.span.end as usize];
        let found = told.help.as_deref().unwrap_or_default();
        if told.code.number() != *code || spanned != *place || !found.contains(help) {
            failures.push(format!("{bad}: at `{spanned}`\n{}", ran.messages()));
        }
        // It stands in the changed line (or in the line before what is missing).
        let line = GOOD[..at].lines().count();
        let (_, told_line) = ran.told()[0];
        let lines = bad.lines().count();
        if !(line..=line + lines).contains(&(told_line as usize))
            && ![1057, 1081, 1082].contains(code)
        {
            failures.push(format!("{bad}: told in line {told_line}, made in line {}", line + 1));
        }
    }
    assert!(
        failures.is_empty(),
        "{} of {}:\n{}",
        failures.len(),
        MISTAKES.len(),
        failures.join("\n")
    );
    assert!(MISTAKES.len() >= 60);
}

#[test]
fn ten_independent_mistakes_are_ten_messages() {
    let text = "\
PARTNO TEN
P1=POINT/1,WIDE
P2=POINT/P1,3
L1=LIEN/P1,P2
A=SQRTF(-2)
B=A*2
C=CIRCLE/0,0,(-1)
RESERV/Q,3
Q(4)=POINT/1,1
CUTTER/10,8
FROM/0,0,0
GO/TO,L1
GOLTF/L1,TO,C
GORGT/C,TO,L1
COOLNT/ONN
IF(B)10,20,30
10) D=1
20) CALL/NOMAC
30) GOTO/P2,E
GOTO/(Q(1)),0,0
FINI
";
    let ran = run(text);
    let expected = [
        (1050, 2),
        (1065, 4),
        (1053, 5),
        (1208, 7),
        (1059, 9),
        (1306, 10),
        (1300, 13),
        (1050, 15),
        (1091, 18),
    ];
    assert_eq!(ran.told(), expected, "{}", ran.messages());
}

#[test]
fn mistakes_in_every_statement_stay_apart() {
    // Each line alone is wrong; together they are as many messages as lines.
    let wrong: Vec<&str> = MISTAKES
        .iter()
        .filter(|(good, ..)| *good == "LOADTL/2")
        .map(|m| m.1)
        .filter(|bad| {
            // What leaves the rest of a program in doubt is not among them.
            !["TERMAC", "READ", "CALL", "LOCAL", "REFSYS", "DRILL", "ZSURF"]
                .iter()
                .any(|w| bad.starts_with(w))
        })
        .collect();
    let text = GOOD.replacen("LOADTL/2", &wrong.join("\n"), 1);
    let ran = run(&text);
    assert_eq!(ran.diagnostics.len(), wrong.len(), "{}", ran.messages());
}

/// A word that is like no other may be one of an installation; one that is like another is misspelt.
#[test]
fn a_word_of_an_installation_is_handed_on() {
    let ran = run("HYDRAU/ON\nFINI\n");
    assert_eq!(ran.told(), [(1301, 1)]);
    assert!(!ran.diagnostics[0].is_error());
    let ran = run("RAPPID\nFINI\n");
    assert!(ran.diagnostics[0].is_error(), "{}", ran.messages());
}

#[test]
fn a_comment_at_the_end_is_no_fini() {
    let codes = |text: &str| -> Vec<u16> {
        run(text).diagnostics.iter().map(|d| d.code.number()).collect()
    };
    assert_eq!(codes("A=1\n$$\n"), [1096]);
    assert!(codes("A=1\nFINI\n$$\n").is_empty());
}

#[test]
fn metric_feeds_without_units_are_told_once() {
    let head =
        "CUTTER/16\nFEDRAT/300,MMPM\nCYCLE/DRILL,DEPTH,9,MMPM,80,CLEAR,2\nGOTO/1,2,3\nFINI\n";
    assert_eq!(run(head).told(), [(1312, 2)]);
    for units in ["UNITS/MM", "UNITS/INCHES"] {
        assert!(run(&format!("{units}\n{head}")).told().is_empty());
    }
    // It may come behind the first feed, or from another file.
    assert!(run(&head.replace("CYCLE", "UNITS/MM\nCYCLE")).told().is_empty());
    let inches = head.replace("MMPM", "IPM");
    assert!(run(&inches).told().is_empty());
    // A misspelt UNITS is one mistake.
    assert_eq!(run(&format!("UNITSS/MM\n{head}")).told().len(), 1);
}
