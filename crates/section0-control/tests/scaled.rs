//! A matrix that scales moves the path of a cutter and leaves the cutter as it is: that is told where it matters.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

fn program(matrix: &str, go: &str, edits: [&str; 2]) -> String {
    format!(
        "UNITS/MM\nCUTTER/10\nINTOL/.01\nOUTTOL/.01\nM={matrix}\nW=LINE/XAXIS\nE=LINE/YAXIS\n{}\n\
         FROM/-50,-20,0\nGO/{go}\n{}\nFINI\n",
        edits[0], edits[1]
    )
}

#[test]
fn a_matrix_that_scales_the_path_of_a_cutter_is_told() {
    const TRACUT: [&str; 2] = ["TRACUT/M", "TRACUT/NOMORE"];
    const COPY: [&str; 2] = ["INDEX/1", "COPY/1,MODIFY,M,1"];
    const BESIDE: &str = "TO,W\nTLRGT,GORGT/W,TO,E";
    const ON: &str = "ON,W\nPSIS/(PLANE/0,0,1,0)\nTLON,GORGT/W,ON,E";
    for (matrix, go, edits, told) in [
        ("MATRIX/SCALE,2", BESIDE, TRACUT, true),
        ("MATRIX/SCALE,2", BESIDE, COPY, true),
        ("MATRIX/1,0,0,0,0,1.5,0,0,0,0,1,0", BESIDE, TRACUT, true),
        ("MATRIX/SCALE,2", ON, TRACUT, false),
        ("MATRIX/1,0,0,0,0,1,0,0,0,0,2,0", BESIDE, TRACUT, false),
        ("MATRIX/1,0,0,0,0,1,0,0,0,0,2,0", "ON,W,TO,(PLANE/.6,0,.8,0)", TRACUT, true),
        ("MATRIX/XYROT,30", BESIDE, TRACUT, false),
        ("MATRIX/MIRROR,YZPLAN", BESIDE, COPY, false),
        ("MATRIX/TRANSL,3,4,5", BESIDE, TRACUT, false),
    ] {
        let text = program(matrix, go, edits);
        let ran = run::run(&text, Verify::Full);
        let said: Vec<_> = ran.told.iter().filter(|(code, _)| code == "APT3106").collect();
        assert_eq!(said.len(), usize::from(told), "{:?} {text}", ran.told);
        assert_eq!(ran.faults(), Vec::<String>::new(), "{text}");
        assert!(ran.places.len() > 1, "{text}");
    }
}
