//! A tool that stands in a closed body of triangles and touches none of them.

use std::fmt::Write as _;

use aptc_control::{ClFile, Memory, Options, Source, Verify, compile, verify};
use aptc_geometry::trig;

type Triangle = [[f64; 3]; 3];

/// A box from `low` to `high`.
fn cuboid(low: [f64; 3], high: [f64; 3]) -> Vec<Triangle> {
    let at = |i: usize| [0, 1, 2].map(|k| if i >> k & 1 == 0 { low[k] } else { high[k] });
    let faces =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).map(|t| t.map(at)).collect()
}

/// A ball of strips between circles of latitude.
fn ball(center: [f64; 3], radius: f64) -> Vec<Triangle> {
    const N: u32 = 24;
    let at = |i: u32, j: u32| {
        let turn = std::f64::consts::PI / f64::from(N);
        let (s, c) = trig::sin_cos(turn * f64::from(i));
        let (sin, cos) = trig::sin_cos(turn * f64::from(j % (2 * N)));
        let [x, y, z] = center;
        let ring = if i == N { 0.0 } else { s };
        [x + radius * ring * cos, y + radius * ring * sin, z + radius * c]
    };
    // At the poles one of both has no area.
    let down = |i, j| (i + 1 < N).then(|| [at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
    let up = |i, j| (i > 0).then(|| [at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
    let places = (0..N).flat_map(|i| (0..2 * N).map(move |j| (i, j)));
    places.flat_map(|(i, j)| [down(i, j), up(i, j)]).flatten().collect()
}

fn stl(triangles: &[Triangle]) -> String {
    let mut text = String::from("solid CLAMP\n");
    for t in triangles {
        text.push_str("facet normal 0 0 0\nouter loop\n");
        for [x, y, z] in t {
            writeln!(text, "vertex {x:.6} {y:.6} {z:.6}").expect("memory takes it");
        }
        text.push_str("endloop\nendfacet\n");
    }
    text + "endsolid CLAMP\n"
}

/// A floor below the body, milled by a small tool; `begin` brings it there.
fn program(begin: &str, holder: &str, close: &str, work: &str) -> String {
    format!(
        "PARTNO BODIES
UNITS/MM
READ/1,CLAMP
FLOOR=SSURF/SMESH,XYZ,SPLINE,(-18,-15,0),(0,-15,1),(18,-15,0),$
 SPLINE,(-18,15,0),(0,15,1),(18,15,0)
UP=VECTOR/0,0,1
CUTTER/4,2,0,2,0,0,12
{holder}
INTOL/.01
OUTTOL/.01
{begin}
SCON/DS,FLOOR,PARAM,0,2,0,1,AT,UP
SCON/PS,TO,FLOOR,PLUS,0
SCON/AXIS,UP
{close}
{work}
END
FINI
"
    )
}

const WORKS: [&str; 5] = [
    "SMIL/PATH,DS,PARAM,.2,.5,TANSPL,PLUS",
    "SMIL/POSN,DS,PARAM,.2,.5,INCR,0",
    "GOLOFT/FLOOR,VCONST,.5",
    "GOMILL/FLOOR,VCONST,.5,STEPOV,.5",
    "GODLTA/1,0,0",
];
const HOLDER: &str = "HOLDER/8,14,14,40";
const CLOSE: &str = "CHKSRF/CLAMP,ON";

fn options(verify: Verify) -> Options {
    Options { verify, post: false, ..Options::default() }
}

/// What is wrong with path or proof.
fn told(text: &str, triangles: &[Triangle], how: Verify, file: Option<&str>) -> Vec<String> {
    let mut world = Memory { files: vec![("CLAMP".into(), stl(triangles))] };
    let source = Source { name: "part".into(), text: text.into() };
    let file = file.map(|f| ClFile { name: "part.cl".into(), bytes: f.as_bytes().to_vec() });
    let compiled = match file {
        Some(_) => verify(source, &mut world, &options(how), file),
        None => compile(source, &mut world, &options(how)),
    };
    let all = compiled.diagnostics.iter().map(|d| format!("{} {}", d.code, d.message));
    all.filter(|d| !d.starts_with("APT1114")).collect()
}

/// Bodies that hold the tool along all of its paths, and touch it nowhere.
fn bodies() -> [Vec<Triangle>; 2] {
    [cuboid([-70.0, -60.0, -20.0], [70.0, 60.0, 90.0]), ball([0.0, 0.0, 20.0], 80.0)]
}

#[test]
fn a_tool_that_stands_in_a_body_is_told() {
    for body in bodies() {
        for holder in ["", HOLDER] {
            for begin in ["", "FROM/-15,0,8", "FROM/0,0,300\nFROM/-15,0,8"] {
                for work in WORKS.into_iter().filter(|w| !w.starts_with("GOD") || !begin.is_empty())
                {
                    let text = program(begin, holder, CLOSE, work);
                    let said = told(&text, &body, Verify::Off, None);
                    assert!(
                        matches!(&said[..], [one] if one.starts_with("APT2046")
                            && one.contains("the cutter stands inside of CLAMP")),
                        "{said:?}\n{text}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_tool_that_stands_outside_is_not() {
    let beside = [
        cuboid([-70.0, 25.0, -20.0], [70.0, 60.0, 90.0]),
        cuboid([-70.0, -60.0, -90.0], [70.0, 60.0, -20.0]),
        ball([0.0, 0.0, -60.0], 40.0),
    ];
    // What is open has no inside, and the hollow of a body is outside of it.
    let [outer, _] = bodies();
    let open = outer[..outer.len() - 1].to_vec();
    let inner = cuboid([-60.0, -50.0, -15.0], [60.0, 50.0, 80.0]);
    let hollow = outer.into_iter().chain(inner.into_iter().map(|[a, b, c]| [c, b, a]));
    for body in beside.into_iter().chain([open, hollow.collect()]) {
        for begin in ["", "FROM/-15,0,8"] {
            for work in WORKS.into_iter().filter(|w| !w.starts_with("GOD") || !begin.is_empty()) {
                let text = program(begin, HOLDER, CLOSE, work);
                assert_eq!(told(&text, &body, Verify::Full, None), Vec::<String>::new(), "{text}");
            }
        }
    }
}

/// The body is turned, moved and taken out of the check as any surface is.
#[test]
fn a_body_counts_where_it_is() {
    let [body, _] = bodies();
    let moved = "AWAY=SSURF/COMBIN,CLAMP,TRFORM,(MATRIX/TRANSL,500,0,0)";
    for (close, wrong) in [
        (format!("{moved}\nCHKSRF/AWAY,ON"), false),
        (format!("{CLOSE}\nCHKSRF/OFF"), false),
        (format!("{moved}\nCHKSRF/AWAY,CLAMP,ON"), true),
    ] {
        let text = program("FROM/-15,0,8", "", &close, WORKS[0]);
        let said = told(&text, &body, Verify::Full, None);
        assert_eq!(said.iter().any(|d| d.starts_with("APT2046")), wrong, "{said:?}\n{text}");
    }
}

/// The proof of a file tells it on its own.
#[test]
fn a_file_whose_tool_stands_in_a_body_is_refuted() {
    // The tool is led beside a body, and in the file into its middle.
    let body = cuboid([-10.0, 30.0, -20.0], [10.0, 50.0, 40.0]);
    let text = program("FROM/-15,0,8", "", CLOSE, "SMIL/POSN,DS,PARAM,.2,.5,INCR,0");
    assert_eq!(told(&text, &body, Verify::Full, None), Vec::<String>::new());
    let file = "PARTNO BODIES\nUNITS/MM\nFROM/0,40,8\nGOTO/0,40,8.001\nGOTO/-14.4,0,.36\nFINI\n";
    let said = told(&text, &body, Verify::Full, Some(file));
    let inside = |d: &String| d.starts_with("APT5001") && d.contains("checked surface CLAMP");
    assert!(said.iter().any(inside), "{said:?}");
}
