//! Published values of the routines of Section 2, and the table of routines in `docs/method.md`.

mod support;

use std::path::Path;

use aptc_geometry::Vec3;
use support::{Forms, form, run};

fn forms(all: &[(&str, &str, &[f64])]) -> Forms {
    all.iter().map(|(n, k, w)| ((*n).to_owned(), form(k, w).expect("a legal form"))).collect()
}

const X0: (&str, &str, &[f64]) = ("X0", "PLANE", &[1.0, 0.0, 0.0, 0.0]);
const Y0: (&str, &str, &[f64]) = ("Y0", "PLANE", &[0.0, 1.0, 0.0, 0.0]);
const Z0: (&str, &str, &[f64]) = ("Z0", "PLANE", &[0.0, 0.0, 1.0, 0.0]);

#[track_caller]
fn ends(f: &Forms, text: &str, end: [f64; 3], off: f64) -> usize {
    let ran = run(f, text).clean();
    let away = (ran.end() - Vec3::from(end)).norm();
    assert!(away <= off, "{text}: {:?} is {away:e} away", ran.end());
    ran.motions().last().map_or(0, |(_, m)| m.points.len())
}

/// `CENTR`: three planes; a sphere and two planes.
#[test]
fn positions_at_three_surfaces() {
    let f = forms(&[X0, Y0, Z0, ("SP", "SPHERE", &[0.0, 0.0, -10.0, 10.0])]);
    let start = "3DCALC\nCUTTER/4,2\nINTOL/0\nOUTTOL/1E-9\nFROM/5,5,5\nGO/";
    ends(&f, &format!("{start}TO,X0,TO,Z0,TO,Y0"), [2.0, 2.0, 0.0], 1e-12);
    // Centre of the ball at sqrt 136 - 10 = 1.6619038, the tool end 2 below.
    ends(&f, &format!("{start}TO,Y0,TO,SP,TO,X0"), [2.0, 2.0, -0.338_096_2], 1e-7);
}

/// `CENTR2`: the nearest place at a cylinder and a plane.
#[test]
fn positions_at_two_surfaces() {
    let f = forms(&[X0, Y0, Z0, ("CY", "CYLNDR", &[0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 3.0])]);
    let start = "3DCALC\nCUTTER/4,2\nINTOL/0\nOUTTOL/1E-9\n";
    let end = [4.931_969_6, 0.821_994_9, 0.0];
    ends(&f, &format!("{start}FROM/6,1,-1.5\nGO/TO,CY,TO,Z0"), end, 1e-7);
    ends(&f, &format!("{start}FROM/5,1,5\nGO/TO,X0,TO,Y0"), [2.0, 2.0, 5.0], 1e-12);
}

/// `STRTUP`: in the plane a start goes square to the wall in plan, or as the direction says, and its height follows; in
/// space, and with the part surface named first, each step is the least one from where the last one led. Source of the
/// places: what APT-360 computes.
#[test]
fn start_ups_between_surfaces_that_lean() {
    let l = (0.3_f64 * 0.3 + 0.2 * 0.2 + 1.0).sqrt();
    let f = forms(&[
        ("TILT", "PLANE", &[0.3 / l, 0.2 / l, 1.0 / l, 0.5 / l]),
        ("WALL", "PLANE", &[0.8, 0.6, 0.0, 3.0]),
        ("CY", "CYLNDR", &[0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 3.0]),
        ("LOW", "PLANE", &[0.0, 0.0, 1.0, 0.5]),
        ("EGG", "QADRIC", &[1.0 / 9.0, 0.25, 1.0 / 2.25, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
    ]);
    let start = "CUTTER/1,.25\nINTOL/.001\nOUTTOL/.001\n";
    for (text, end, off) in [
        ("FROM/6,1,2\nGO/TO,WALL,ON,TILT", [4.48, -0.14, -0.816], 1e-6),
        ("FROM/6,1,2\nGO/ON,TILT,TO,WALL", [4.446_221_5, -0.094_962, -0.814_874], 1e-6),
        (
            "FROM/6,1,2\nINDIRV/-1,.1,0\nGO/TO,WALL,ON,TILT",
            [3.432_432_4, 1.256_756_8, -0.781_081],
            1e-6,
        ),
        (
            "FROM/6,1,2\nINDIRV/-1,.1,0\nGO/ON,TILT,TO,WALL",
            [-4.292_328, 11.556_438, -0.523_589],
            1e-6,
        ),
        ("FROM/6,1,2\nGO/ON,CY,ON,TILT", [2.959_182, 0.493_197, -0.486_394], 1e-6),
        ("3DCALC\nFROM/6,1,2\nGO/ON,CY,ON,TILT", [2.997_607, 0.138_396, -0.426_961], 2e-3),
        ("CUTTER/0\nFROM/4,3,.5\nGO/ON,EGG,ON,LOW", [2.302_774, 1.095_521, 0.5], 2e-3),
    ] {
        ends(&f, &format!("{start}{text}"), end, off);
    }
}

/// `STRTUP`: one surface by the least way, two together.
#[test]
fn start_up_by_the_least_way() {
    let f = forms(&[X0, Y0]);
    let start = "3DCALC\nCUTTER/4,2\nINTOL/0\nOUTTOL/1E-9\nFROM/10,0.5,0\n";
    ends(&f, &format!("{start}NOPS\nGO/TO,X0"), [2.0, 0.5, 0.0], 1e-12);
    ends(&f, &format!("{start}GO/TO,X0,TO,Y0"), [2.0, 2.0, 0.0], 1e-12);
}

/// `STRTUP`: GO tells whether the tool end lies on the part surface, also where the bands hold both.
#[test]
fn the_part_surface_is_kept_to_as_started() {
    let a = 0.0245;
    let f = forms(&[
        Y0,
        ("S", "PLANE", &[-a, 0.0, 1.0, 0.0]),
        ("X1", "PLANE", &[1.0, 0.0, 0.0, 10.0]),
        ("X2", "PLANE", &[1.0, 0.0, 0.0, 60.0]),
    ]);
    let start = "3DCALC\nCUTTER/10,5\nINTOL/.001\nOUTTOL/.001\nFROM/-20,-20,50\nGO/TO,Y0,";
    let drive = "S,TO,X1\nTLRGT,GORGT/Y0,PAST,X2";
    let over = 5.0 * ((1.0 + a * a).sqrt() - 1.0);
    ends(&f, &format!("{start}ON,{drive}"), [65.0, -5.0, 65.0 * a], 1e-9);
    ends(&f, &format!("{start}TO,{drive}"), [65.0, -5.0, 65.0 * a + over], 1e-9);
}

/// `ARLM2`: the cutter between two circles; `ARLM3` finds the same place.
#[test]
fn a_cutter_at_two_circles() {
    let f = forms(&[
        Z0,
        ("C1", "CIRCLE", &[0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 3.0]),
        ("C2", "CIRCLE", &[10.0, 0.0, 0.0, 0.0, 0.0, 1.0, 4.0]),
    ]);
    for calc in ["2DCALC", "3DCALC"] {
        let text =
            format!("{calc}\nCUTTER/4\nINTOL/0\nOUTTOL/1E-6\nFROM/4,5,0\nGO/TO,C1,TO,Z0,TO,C2");
        ends(&f, &text, [4.45, 2.279_802_6, 0.0], 2e-6);
    }
}

/// `ARLM3`: one cut vector between planes, 28 for a quarter of a circle of radius 5 in a band of .001
/// either way, each of them half as long again as with vertices on the surface.
#[test]
fn the_fewest_cut_vectors() {
    let f = forms(&[
        Y0,
        Z0,
        X0,
        ("X10", "PLANE", &[1.0, 0.0, 0.0, 10.0]),
        ("CY", "CYLNDR", &[0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 4.0]),
    ]);
    let straight = "3DCALC\nCUTTER/2,1\nINTOL/0\nOUTTOL/.001\nFROM/0,5,0\nGO/TO,Y0,TO,Z0
INDIRV/1,0,0\nTLLFT,GOFWD/Y0,TO,X10";
    assert_eq!(ends(&f, straight, [9.0, 1.0, 0.0], 1e-12), 1);
    for calc in ["2DCALC", "3DCALC"] {
        let quarter = format!(
            "{calc}\nCUTTER/2,1\nINTOL/.001\nOUTTOL/.001\nFROM/9,0,0\nGO/TO,CY,TO,Z0,ON,Y0
INDIRV/0,1,0\nTLRGT,GOFWD/CY,ON,X0"
        );
        let n = ends(&f, &quarter, [0.0, 5.0, 0.0], 1.1e-3);
        assert!(n == 28 || n == 29, "{calc} {n}");
    }
}

/// `CHECK1` and `CPLAN`: past a plane at a slant, and tangent to a circle.
#[test]
fn check_surfaces() {
    let f = forms(&[
        Z0,
        ("SLANT", "PLANE", &[0.8, -0.6, 0.0, 0.0]),
        ("X10", "PLANE", &[1.0, 0.0, 0.0, 10.0]),
        ("LX", "LINE", &[0.0, 1.0, 0.0, 0.0]),
        ("C", "CIRCLE", &[5.0, 3.0, 0.0, 0.0, 0.0, 1.0, 3.0]),
    ]);
    // From x = 3 along (.6, .8) the ball of radius 2 needs 25/3 to the plane x = 10.
    let slant = "3DCALC\nCUTTER/4,2\nINTOL/0\nOUTTOL/1E-9\nFROM/3,4,0\nINDIRV/.6,.8,0
TLON,GOFWD/SLANT,TO,X10";
    ends(&f, slant, [8.0, 4.0 + 20.0 / 3.0, 0.0], 1e-9);
    let tangent =
        "3DCALC\nCUTTER/0\nINTOL/0\nOUTTOL/1E-9\nFROM/0,0,0\nINDIRV/1,0,0\nTLON,GOFWD/LX,TANTO,C";
    ends(&f, tangent, [5.0, 0.0, 0.0], 1e-7);
}

/// Each file and each test that the page names is there.
#[test]
fn the_table_of_routines_is_true() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let page =
        std::fs::read_to_string(root.join("docs/method.md")).expect("docs/method.md is there");
    let mut rows = 0;
    for row in page.lines().filter(|l| l.starts_with("| `")) {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        let [_, _, place, _, tests, _] = cells.as_slice() else { panic!("four columns: {row}") };
        for path in place.split('`').skip(1).step_by(2) {
            assert!(root.join("crates").join(path).is_file(), "{path} in {row}");
        }
        for name in tests.split('`').skip(1).step_by(2) {
            let (file, test) = name.split_once("::").expect("file::test");
            let text = std::fs::read_to_string(root.join("crates").join(file)).unwrap_or_default();
            assert!(text.contains(&format!("fn {test}(")), "{name} in {row}");
        }
        rows += 1;
    }
    assert!(rows >= 40, "{rows} rows");
}
