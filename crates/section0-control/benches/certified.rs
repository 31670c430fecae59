//! Cut vectors a second that are made and proved, by surface and cutter: from the source to the certificate.
//!
//! `cargo bench -p aptc-control --bench certified`. Twenty passes along planes over each part surface, in a band of
//! +-.00001 beside a radius of 50, on one thread. The rate of the path alone stands beside each.

use aptc_control::{Memory, Options, Source, Verify, compile};
use aptc_testkit::bench;

/// Part surfaces, with the rates that are wanted of a ball and of a bull nose, million a second.
const SURFACES: [(&str, &str, [f64; 2]); 6] = [
    ("sphere", "S=SPHERE/0,0,-50,50", [2.5, 1.0]),
    ("cylinder", "S=CYLNDR/0,0,-50,0,1,0,50", [2.5, 1.0]),
    ("cone", "S=CONE/(POINT/0,250,-50),(VECTOR/0,-1,0),11", [0.2, 0.2]),
    // Half axes 60, 45 and 50.
    ("ellipsoid", "S=QADRIC/(1/3600),(1/2025),(1/2500),0,0,0,0,0,.02,0", [0.2, 0.2]),
    (
        "ruled",
        "A=CYLNDR/0,0,-60,0,1,0,60\nB=CYLNDR/0,0,-90,0,1,0,90\nV=VECTOR/0,0,1\nS=RLDSRF/A,(POINT/-48,-40,-24),$\n\
         (POINT/48,-40,-24),V,B,(POINT/-54,40,-18),(POINT/54,40,-18),V",
        [0.2, 0.2],
    ),
    (
        "SSURF",
        "S=SSURF/SMESH,XYZ,$\n\
         SPLINE,(POINT/-40,-30,-16),(POINT/-20,-30,-6),(POINT/0,-30,-3),$\n\
         (POINT/20,-30,-6),(POINT/40,-30,-16),$\n\
         SPLINE,(POINT/-40,0,-13),(POINT/-20,0,-3),(POINT/0,0,0),$\n\
         (POINT/20,0,-3),(POINT/40,0,-13),$\n\
         SPLINE,(POINT/-40,30,-14),(POINT/-20,30,-5),(POINT/0,30,-4),$\n\
         (POINT/20,30,-5),(POINT/40,30,-14)",
        [0.2, 0.2],
    ),
];

fn program(surface: &str, cutter: &str) -> String {
    format!(
        "PARTNO PASSES\nUNITS/MM\n{surface}\nE=PLANE/1,0,0,25\nCUTTER/{cutter}\nINTOL/.00001\nOUTTOL/.00001\n\
         FEDRAT/300,MMPM\nFROM/-25,-10,12\nPASS=MACRO/Y\nD=PLANE/0,1,0,Y\nGODLTA/0,0,20\nGOTO/-25,Y,12\n\
         GO/ON,D,TO,S\nINDIRV/1,0,0\nTLON,GOFWD/D,ON,E\nTERMAC\nDO/9,I=1,20\n9) CALL/PASS,Y=(I/2-5)\nFINI\n"
    )
}

fn main() {
    for (name, surface, wanted) in SURFACES {
        let cutters = [("ball", "10,5"), ("bull nose", "10,2")];
        for ((cutter, size), wanted) in cutters.into_iter().zip(wanted) {
            let text = program(surface, size);
            let run = |verify| {
                let source = Source { name: "passes.apt".into(), text: text.as_str().into() };
                let options =
                    Options { verify, post: false, plot: false, threads: 1, ..Options::default() };
                let compiled = compile(source, &mut Memory::default(), &options);
                assert!(!compiled.has_errors(), "{:?}", compiled.diagnostics.first());
                compiled
            };
            let compiled = run(Verify::Full);
            assert!(!compiled.is_refuted(), "{name}");
            let vectors: u64 = compiled.parts.iter().map(|part| part.summary.cut_vectors).sum();
            #[expect(clippy::cast_precision_loss, reason = "some thousands")]
            let millions = vectors as f64 / 1e6;
            let unit = "million vectors/s";
            let title = format!("{cutter} on {name}, path and proof");
            bench::rate(&title, millions, unit, Some(wanted), || run(Verify::Full));
            let title = format!("{cutter} on {name}, path alone");
            bench::rate(&title, millions, unit, None, || run(Verify::Off));
        }
    }
}
