//! Whatever comes in, Section 1 answers, and what it puts out keeps the rules of PROTAP.

mod support;

use aptc_geometry::Vec3;
use aptc_protap::{Kind, Outcome, verify};
use aptc_translate::{Limits, NoFiles, Options};
use proptest::collection::vec;
use proptest::prelude::{ProptestConfig, Strategy, proptest};
use proptest::sample::select;
use support::{Ran, run_with};

/// Pieces of statements, so that random ones get far.
const PIECES: &[&str] = &[
    "A",
    "B",
    "P",
    "L1",
    "L2",
    "C",
    "PL",
    "M",
    "V",
    "Q",
    "H",
    "MAC",
    "1",
    "2",
    "-1",
    ".5",
    "0",
    "100000",
    "1.E30",
    "(",
    ")",
    ",",
    ",",
    ",",
    "/",
    "=",
    "+",
    "-",
    "*",
    "**",
    "1)",
    "2)",
    "LAB)",
    "LAB",
    "A(1)",
    "A(I=I+1)",
    "H(2)",
    "H(ALL)",
    "H(1,THRU,3)",
    "POINT/",
    "LINE/",
    "CIRCLE/",
    "PLANE/",
    "MATRIX/",
    "VECTOR/",
    "PATERN/",
    "(POINT/1,2)",
    "(LINE/XAXIS)",
    "CANON",
    "INTOF",
    "TO",
    "ON",
    "PAST",
    "TANTO",
    "PSTAN",
    "OFF",
    "NOMORE",
    "ATANGL",
    "PARLEL",
    "XLARGE",
    "YSMALL",
    "RADIUS",
    "CENTER",
    "LINEAR",
    "RANDOM",
    "INVERS",
    "OMIT",
    "AVOID",
    "THRU",
    "ALL",
    "INCR",
    "GOTO/",
    "FROM/",
    "GODLTA/",
    "GO/",
    "GOLFT/",
    "GOFWD/",
    "TLLFT,",
    "PSIS/",
    "AUTOPS",
    "CUTTER/",
    "TOLER/",
    "INTOL/",
    "OUTTOL/",
    "THICK/",
    "MAXDP/",
    "NUMPTS/",
    "TLAXIS/",
    "INDIRV/",
    "INDIRP/",
    "SRFVCT/",
    "POCKET/",
    "TRACUT/",
    "COPY/",
    "INDEX/",
    "CUT",
    "DNTCUT",
    "MULTAX",
    "UNITS/MM",
    "ZSURF/",
    "REFSYS/",
    "RESERV/",
    "OBTAIN,",
    "PRINT/",
    "3",
    "SYN/",
    "READ/",
    "CALL/",
    "MACRO/",
    "TERMAC",
    "LOOPST",
    "LOOPND",
    "IF(A)",
    "IF(",
    ".GT.",
    ".AND.",
    "JUMPTO/",
    "TRANTO/",
    "DO/1,I=1,3",
    "CONTIN",
    "LOCAL/",
    "CYCLE/",
    "SPINDL/",
    "MACHIN/",
    "FEDRAT/",
    "FINI",
    "SINF(",
    "SQRTF(",
    "DISTF(",
    "NUMF(",
    "CANF(",
    "KREUZ",
    "DOT",
    "'TEXT'",
    "PARTNO X",
    "SCON/",
    "CLPRNT",
    "$$",
];

const BEFORE: &str = "RESERV/H,3\nI=0\nA=2\nB=3\nP=POINT/1,2,3\nL1=LINE/XAXIS\nL2=LINE/YAXIS\nC=CIRCLE/0,0,5\n\
    PL=PLANE/0,0,1,4\nM=MATRIX/XYROT,30\nV=VECTOR/1,0,0\nQ=PATERN/LINEAR,P,V,3\nMAC=MACRO/A=1,B\nGOTO/A,B,0\nTERMAC\n";

fn options() -> Options {
    let limits = Limits {
        statements: 300,
        array_elements: 1_000,
        points: 1_000,
        printed: 100,
        macro_depth: 8,
        ..Limits::default()
    };
    Options { limits, unused: true, ..Options::default() }
}

/// Runs a program; each motion is stopped by its second check surface.
fn survive(text: &str) -> Ran {
    let ran = run_with(text, &mut NoFiles, options(), |r| match r.kind {
        Kind::Drive(_) => Outcome::Moved { te: Vec3::zeros(), ta: Vec3::z(), check: 1 },
        _ => Outcome::None,
    });
    for message in verify(ran.records.iter()) {
        // Which COPY belongs to which INDEX is the concern of Section 3.
        let editing = message.message.starts_with("COPY") || message.message.starts_with("INDEX");
        assert!(editing, "{}\n{text}", message.message);
    }
    for d in &ran.diagnostics {
        assert!(!d.message.is_empty() && !d.message.contains("NaN"), "{d:?}");
    }
    ran
}

fn statement() -> impl Strategy<Value = String> {
    vec(select(PIECES), 1..9).prop_map(|pieces| pieces.concat())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_statements(statements in vec(statement(), 1..6)) {
        survive(&format!("{BEFORE}{}\nFINI\n", statements.join("\n")));
    }

    #[test]
    fn random_arguments(head in select(PIECES), args in vec(select(PIECES), 0..8)) {
        survive(&format!("{BEFORE}{head}{}\nFINI\n", args.join(",")));
    }

    #[test]
    fn random_text(text in "\\PC{0,120}") {
        survive(&text);
    }
}

#[test]
fn every_truncation_of_the_shared_programs() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../corpus");
    let mut n = 0;
    for topic in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        for program in std::fs::read_dir(topic.path()).into_iter().flatten().flatten() {
            let Ok(text) = std::fs::read_to_string(program.path().join("program.apt")) else {
                continue;
            };
            let places: Vec<usize> = text.char_indices().map(|(i, _)| i).collect();
            for end in places.into_iter().step_by(13) {
                survive(&text[..end]);
                n += 1;
            }
        }
    }
    assert!(n > 100, "{n} truncations");
}

#[test]
fn numbers_at_the_edge() {
    for number in ["1.E308", "-1.E308", "1.E-308", "0", "999999999999"] {
        for statement in [
            "GOTO/#,#,#",
            "GODLTA/#",
            "CUTTER/#,#",
            "INTOL/#",
            "TLAXIS/#,#,#",
            "INDIRV/#,#,#",
            "MAXDP/#",
            "NUMPTS/#",
            "COPY/#,SAME,#",
            "INDEX/#",
            "RESERV/Z,#",
            "A=#*#",
            "A=#**#",
            "A=#+#",
            "DO/1,K=#,#,#\n1) A=K",
            "X=POINT/#,#",
            "X=LINE/#,#,0,#",
            "X=CIRCLE/#,#,#",
            "X=PLANE/#,#,#,#",
            "X=VECTOR/UNIT,#,#,#",
            "X=MATRIX/SCALE,#",
            "X=PATERN/LINEAR,P,V,#",
            "GOTO/Q,OMIT,#",
            "H(#)=1",
            "A=H(#)",
            "IF(#)3,3,3\n3) STOP",
            "PRINT/#,A",
            "PTONLY/#",
            "ZSURF/#",
            "POCKET/#,#,#,#,#,#,0,0,P,(POINT/5,5),#,#,#",
            "A=SINF(#)",
            "A=TANF(#)",
            "GOLFT/L1,TO,#,INTOF,L2",
            "TLAXIS/ATANGL,1,#",
            "CUTTER/OPTION,#,#,#",
            "THICK/#",
            "A=CANF(C,#)",
        ] {
            survive(&format!("{BEFORE}{}\nFINI\n", statement.replace('#', number)));
        }
    }
}
