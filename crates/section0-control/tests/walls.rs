//! Sculptured walls: one that is a part of a cylinder is met where the cylinder is, from near and from far; along a twisted one a
//! ball with its shank goes on where the place of contact leaps along the flank.

#[path = "support/run.rs"]
mod run;

use aptc_control::{ClFile, Disk, Options, Source, Verify, verify};

/// The codes of all messages, and where the last motion ends.
fn run(text: &str, verify: Verify) -> (Vec<String>, [f64; 3]) {
    let ran = run::run(text, verify);
    (ran.codes(), ran.places.last().copied().unwrap_or([f64::NAN; 3]))
}

/// A part of a cylinder of radius 30 about x = `middle`, upright, round to where the tool comes from or open to it, and the tool
/// on its way along y = `beside`.
fn program(middle: f64, open: bool, beside: f64, floor: &str, work: &str) -> String {
    let (crest, ends) =
        if open { (middle + 30.0, middle + 18.0) } else { (middle - 30.0, middle - 18.0) };
    format!(
        "UNITS/MM
ARC=SCURV/CURSEG,(POINT/{ends},-24,-20),(POINT/{crest},0,-20),$
(POINT/{ends},24,-20)
TOP=SCURV/CURSEG,(POINT/{ends},-24,40),(POINT/{crest},0,40),$
(POINT/{ends},24,40)
WALL=SSURF/GENCUR,ARC,TOP
FLOOR={floor}
WAY=PLANE/0,1,0,{beside}
CUTTER/10,2,3,2,0,0,15
INTOL/.001
OUTTOL/.001
FROM/0,{beside},9
GO/ON,WAY,TO,FLOOR
INDIRV/1,0,0
TLON,GOFWD/WAY,{work}
FINI
"
    )
}

#[test]
fn a_sculptured_wall_is_met_where_its_cylinder_is() {
    let straight = "PLANE/0,0,1,0";
    // A floor that bends away from the tool makes many cut vectors of the way.
    let bent = "CYLNDR/0,0,-4000,0,1,0,4000";
    for floor in [straight, bent] {
        for (middle, open) in [(45.0, false), (15.0, true), (80.0, false), (60.0, true)] {
            for beside in [0.0, -9.0] {
                // Where the circle of a radius about the middle crosses the way.
                let crossing = |radius: f64| {
                    let across = (radius * radius - beside * beside).sqrt();
                    if open { middle + across } else { middle - across }
                };
                // Inside of the wall the tool has less room, outside more.
                let (first, second) = if open { (25.0, 35.0) } else { (35.0, 25.0) };
                for (work, radius) in [("TO,WALL", first), ("ON,WALL", 30.0), ("PAST,WALL", second)]
                {
                    let text = program(middle, open, beside, floor, work);
                    let (codes, end) = run(&text, Verify::Off);
                    assert!(codes.is_empty(), "{codes:?} {text}");
                    let off = (end[0] - crossing(radius)).abs();
                    assert!(off < 0.005, "{end:?} for {} {text}", crossing(radius));
                }
            }
        }
    }
}

/// A ruled wall that twists along x, bent by `bend` and leaning by `lean`, and a ball with its shank along it.
fn twisted([bend, lean, twist]: [f64; 3], radius: f64, right: bool, axis: &str) -> String {
    let y = |x: f64, z: f64| bend * (x - 4.0) * (x - 6.0) + lean * z + twist * x * z;
    let row = |z: f64| {
        let at = |x: f64| format!(",$\n({x},{:.6},{z})", y(x, z));
        [-2.0, 1.5, 5.0, 8.5, 12.0].map(at).concat()
    };
    let (side, word) = if right { (-3.0, "TLRGT") } else { (3.0, "TLLFT") };
    format!(
        "UNITS/INCHES
WALL=SSURF/SMESH,XYZ,SPLINE{},SPLINE{}
FLOOR=PLANE/-.03,.05,1,0
CUTTER/{},{radius},0,{radius},0,0,1
INTOL/.001
OUTTOL/.001
MULTAX
FROM/0,{side},4
TLAXIS/{axis}
GO/TO,WALL,TO,FLOOR,ON,(PLANE/1,0,0,.7)
INDIRV/1,0,0
{word},GOFWD/WALL,ON,(PLANE/1,0,0,7)
FINI
",
        row(-3.0),
        row(5.0),
        2.0 * radius
    )
}

#[test]
fn a_ball_goes_along_a_twisted_wall_where_its_contact_leaps() {
    for shape in [[0.02, 0.1, 0.02], [-0.02, -0.15, 0.015], [0.03, 0.0, -0.02], [0.0, 0.2, 0.01]] {
        for radius in [0.25, 0.4] {
            for right in [false, true] {
                for axis in ["PARLEL,2", "0,0,1"] {
                    let text = twisted(shape, radius, right, axis);
                    let (codes, end) = run(&text, Verify::Full);
                    assert!(codes.is_empty(), "{codes:?} {text}");
                    assert!((end[0] - 7.0).abs() < 0.01, "{end:?} {text}");
                }
            }
        }
    }
}

/// The way on ends where the straight continuation of the wall does: nothing behind the start is come to.
#[test]
fn a_tool_end_on_a_wall_does_not_turn_round_at_its_end() {
    let rows = [
        (-3, [0.459086, 0.230026, 0.200592, 0.470838, 0.73744, 0.701978]),
        (1, [0.014509, -0.274417, -0.363717, -0.153336, 0.0534, -0.041927]),
        (5, [-0.430069, -0.77886, -0.928025, -0.77751, -0.630639, -0.785833]),
    ];
    let row = |(z, y): (i32, [f64; 6])| {
        let x = [-2.0, 0.6, 3.2, 5.8, 8.4, 11.0];
        let points = x.iter().zip(y).map(|(x, y)| format!(",$\n({x},{y},{z})"));
        format!(",SPLINE{}", points.collect::<String>())
    };
    let text = format!(
        "UNITS/MM
WALL=SSURF/SMESH,XYZ{}
FLOOR=PLANE/0,0,1,0
CUTTER/.8,.12,.28,.12,0,0,1.5
INTOL/.0025
OUTTOL/.005
FROM/0,-1.6,4
GO/ON,WALL,TO,FLOOR,ON,(PLANE/1,0,0,.862277)
INDIRV/1,0,0
TLON,TLOFPS,GOFWD/WALL,ON,(PLANE/1,0,0,-9)
FINI
",
        rows.map(row).concat()
    );
    let (codes, end) = run(&text, Verify::Off);
    assert_eq!(codes, ["APT2021"], "{end:?} {text}");
}

/// RULED,AXIS goes ten inches to both sides of its curve, whatever the unit; the tool that comes to it far from the curve is
/// stopped, and a start finds it.
#[test]
fn rulings_along_an_axis_reach_ten_inches() {
    for (units, mm) in [("MM", 1.0), ("INCHES", 25.4)] {
        let n = |x: f64| format!("{:.5}", x / mm);
        let along = |from: f64, close: &str| {
            format!(
                "UNITS/{units}
S1=SCURV/CURSEG,(POINT/{},{},{}),$
(POINT/{},0,{}),(POINT/{},{},{})
WALL=SSURF/RULED,S1,AXIS,(VECTOR/1,0,0)
FLOOR=PLANE/0,0,1,0
SIDE=PLANE/1,0,0,0
CUTTER/{},0,{},0,0,0,{}
INTOL/{}
OUTTOL/{}
FROM/0,{},{}
{close}
FINI
",
                n(from),
                n(-8.0),
                n(-20.0),
                n(from),
                n(20.0),
                n(from),
                n(-8.0),
                n(60.0),
                n(20.0),
                n(10.0),
                n(40.0),
                n(0.01),
                n(0.01),
                n(-60.0),
                n(30.0),
            )
        };
        let far = n(50.0);
        for from in [-30.0, -100.0, 240.0] {
            let led = format!(
                "GO/ON,SIDE,TO,FLOOR,ON,(PLANE/0,1,0,{})\nINDIRV/0,1,0\nTLON,GOFWD/SIDE,TO,WALL,L1,ON,$\n(PLANE/0,1,0,{far}),L2\nL1) CONTIN\nL2) CONTIN",
                n(-60.0)
            );
            let start = "INDIRV/0,1,0\nGO/TO,WALL,TO,FLOOR,ON,SIDE".to_owned();
            for close in [led, start] {
                let text = along(from, &close);
                let (codes, [x, y, z]) = run(&text, Verify::Full);
                assert!(codes.is_empty(), "{codes:?} {text}");
                // The rims of the flank are in the hollow of a radius of 104.
                let stop = (104.0_f64 * 104.0 - 400.0).sqrt() - 104.0 - 10.0;
                assert!((y * mm - stop).abs() < 0.011, "{y} {stop} {text}");
                assert!(x.abs() < 1e-9 && z.abs() < 1e-5, "{x} {z}");
            }
        }
    }
}

/// A cutter that begins in a trough, its end below the middle, comes to the wall from within, however wide the trough is for it; once it has
/// left it, it is past where the whole cutter is.
#[test]
fn a_trough_is_counted_alike_whether_the_cutter_is_taller_than_it_is_wide() {
    for radius in [8.0, 12.0, 15.0, 16.0, 20.0] {
        let end = |word: &str| {
            let text = format!(
                "UNITS/MM\nPA=SPHERE/0,0,-200,200\nDR=CYLNDR/0,0,0,0,0,1,31\nCUTTER/4,1,1,1,0,0,30\nINTOL/.01\nOUTTOL/.02\n\
                 FROM/-36,0,40\nGO/TO,DR,TO,PA,ON,(PLANE/0,1,0,0)\nINDIRV/0,-1,0\n\
                 TROUGH=CYLNDR/0,5,0,1,.1,0,{radius}\nTLRGT,GOFWD/DR,{word},TROUGH\nFINI\n"
            );
            let ran = run::run(&text, Verify::Full);
            assert!(ran.told.is_empty(), "{radius} {word} {:?}", ran.told);
            *ran.places.last().expect("the tool goes")
        };
        // How far the axis of the cutter is from that of the trough, to its left.
        let off = |p: [f64; 3]| (p[1] - 5.0 - 0.1 * p[0]) / f64::sqrt(1.01);
        let near = |at: f64, asked: f64| (at - asked).abs() < 0.5;
        for (word, side, asked) in [
            ("TO", -1.0, -(radius - 2.0)),
            ("PAST", -1.0, -(radius + 2.0)),
            ("TO,2,INTOF", 1.0, -(radius + 2.0)),
            ("PAST,2,INTOF", 1.0, radius + 2.0),
        ] {
            let p = end(word);
            assert!(near(off(p), asked) && p[0] * side > 0.0, "{radius} {word} {} {p:?}", off(p));
        }
    }
}

/// A quarter of a cylinder of radius 20 by rulings, and a flat end along the line through `from` towards `along`, which it crosses.
fn quarter(diameter: f64, [x, y]: [f64; 2], [along, across]: [f64; 2]) -> String {
    let (half, off) = (0.5 * diameter, along * y - across * x);
    format!(
        "PARTNO QUARTER
UNITS/MM
C1=CIRCLE/0,0,0,20
C2=CIRCLE/0,0,30,20
W=VECTOR/1,1,0
R=RLDSRF/C1,(POINT/20,0,0),(POINT/0,20,0),W,$
 C2,(POINT/20,0,30),(POINT/0,20,30),W
D=PLANE/{},{along},0,{off}
CUTTER/{diameter},0,{half},0,0,0,20
INTOL/.01
OUTTOL/.01
FROM/{x},{y},40
GO/ON,D,TO,(PLANE/0,0,1,0),ON,(PLANE/{along},{across},0,{})
INDIRV/{along},{across},0
TLON,GOFWD/D,TO,R
NOPOST
FINI
",
        -across,
        along * x + across * y,
    )
}

/// From beyond the end of a ruled wall, and of what goes on straight from it, nothing of it faces the tool.
#[test]
fn a_wall_is_met_from_beyond_its_ends() {
    let mut far = 0;
    for diameter in [0.5, 1.0, 3.0] {
        for x in [-1.0, -8.0, -20.0, -26.0, -40.0, -100.0] {
            let text = quarter(diameter, [x, 24.0 - x], [1.0, -1.0]);
            let (codes, [x, y, _]) = run(&text, Verify::Full);
            assert!(codes.is_empty(), "{codes:?} {text}");
            let off = aptc_geometry::trig::hypot(x, y) - 20.0 - 0.5 * diameter;
            assert!(off.abs() < 0.0101 && y > x, "{off} {x} {y} {text}");
            far += 1;
        }
    }
    for at in [-5.0, -10.0, -20.0, -30.0, -50.0, -100.0] {
        let text = quarter(10.0, [at, at], [1.0, 1.0]);
        let (codes, [x, y, _]) = run(&text, Verify::Full);
        assert!(codes.is_empty(), "{codes:?} {text}");
        let off = 20.0 - aptc_geometry::trig::hypot(x, y) - 5.0;
        assert!(off.abs() < 0.0101 && x > 0.0, "{off} {x} {y} {text}");
        far += 1;
    }
    assert_eq!(far, 24);
}

/// A file whose tool is through the wall where it stops there is refuted, from wherever it comes.
#[test]
fn a_file_that_stops_behind_a_wall_is_refuted() {
    let inside = (0.5_f64 * (19.5 * 19.5 - 288.0)).sqrt();
    for x in [-1.0, -20.0, -40.0, -100.0] {
        let text = quarter(1.0, [x, 24.0 - x], [1.0, -1.0]);
        let ran = run::run(&text, Verify::Off);
        let [near, before] = [1, 2].map(|k| ran.places[ran.places.len() - k]);
        let behind = [12.0 + inside, 12.0 - inside, 0.0];
        for (end, right) in [(near, true), (behind, false)] {
            let place = |[x, y, z]: [f64; 3]| format!("{x:.9},{y:.9},{z:.9}");
            let file = format!(
                "PARTNO QUARTER\nUNITS/MM\n$$ LINE 12\nFROM/{}\n$$ LINE 13\nGOTO/{}\n$$ LINE 15\nGOTO/{}\nFINI\n",
                place(ran.places[0]),
                place(before),
                place(end)
            );
            let options = Options { verify: Verify::Full, post: false, ..Options::default() };
            let source = Source { name: "part".into(), text: text.as_str().into() };
            let file = ClFile { name: "part.cl".into(), bytes: file.into_bytes() };
            let found = verify(source, &mut Disk::new(Vec::new(), 0), &options, Some(file));
            let told: Vec<_> =
                found.diagnostics.iter().map(|d| format!("{} {}", d.code, d.message)).collect();
            let refuted = told.iter().any(|t| t.starts_with("APT5001") && t.contains("check"));
            assert_eq!(refuted, !right, "{told:?} {text}");
        }
    }
}
