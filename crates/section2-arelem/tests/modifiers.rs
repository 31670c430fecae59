//! Each modifier of the motion statements by closed forms, in the plane and in space.

mod support;

use std::sync::Arc;

use aptc_geometry::{Form, Tabcyl, TabcylSpan, Vec2, Vec3, trig};
use nalgebra::Matrix3;
use support::{Forms, Run, form, run};

fn forms() -> Forms {
    let mut f = Forms::new();
    let mut add = |name: &str, kind: &str, w: &[f64]| {
        f.insert(name.into(), form(kind, w).expect("a legal form"));
    };
    add("LX", "LINE", &[0.0, 1.0, 0.0, 0.0]);
    add("LY", "LINE", &[1.0, 0.0, 0.0, 0.0]);
    add("L20", "LINE", &[1.0, 0.0, 0.0, 20.0]);
    add("C", "CIRCLE", &[10.0, 0.0, 0.0, 0.0, 0.0, 1.0, 3.0]);
    add("CT", "CIRCLE", &[5.0, 3.0, 0.0, 0.0, 0.0, 1.0, 3.0]);
    add("CB", "CIRCLE", &[0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 2.0]);
    add("PL", "PLANE", &[0.0, 0.0, 1.0, 0.0]);
    add("PL2", "PLANE", &[0.0, 0.0, 1.0, 2.0]);
    add("SP", "SPHERE", &[0.0, 0.0, -50.0, 50.0]);
    add("CY", "CYLNDR", &[10.0, 0.0, 0.0, 0.0, 1.0, 0.0, 3.0]);
    add("TILT", "PLANE", &[0.6, 0.0, 0.8, 6.0]);
    add("CR", "CYLNDR", &[10.0, 0.0, 0.0, 0.0, 1.0, 0.0, 2.0]);
    add("LS", "LINE", &[0.6, -0.8, 0.0, 2.0]);
    add("QE", "QADRIC", &[1.0, 1.0, 0.5, 98.0, 0.0, 0.0, 0.0, -10.0, 0.0, 0.0]);
    let n = 1.36_f64.sqrt();
    add("LT", "LINE", &[-0.6 / n, 1.0 / n, 0.0, (0.9 - 7.8) / n]);
    add("LOW", "PLANE", &[0.0, 0.0, 1.0, -10.0]);
    add("L3", "LINE", &[0.0, 1.0, 0.0, 0.3]);
    add("L30", "LINE", &[0.0, 1.0, 0.0, 30.0]);
    add("L40", "LINE", &[1.0, 0.0, 0.0, 40.0]);
    add("LN", "LINE", &[0.0, -1.0, 0.0, 0.0]);
    add("LW", "LINE", &[1.0, 0.0, 0.0, -2.0]);
    add("BALL", "SPHERE", &[0.0, 0.0, -4.0, 4.0]);
    add("LOG", "CYLNDR", &[0.0, 0.0, -4.0, 1.0, 0.0, 0.0, 4.0]);
    add("ROOF", "PLANE", &[-0.1, -0.2, 1.0, 0.0]);
    f.insert("TB".into(), Form::Tabcyl(Arc::new(spline())));
    f.insert("WAVE".into(), Form::Tabcyl(Arc::new(wave())));
    f
}

/// A spline from the x axis at 10, tangent to it, up to the line LT at 13, with straight ends of 10.
fn spline() -> Tabcyl {
    let spans = [
        [0.0, 0.0, 0.0, 0.0, 10.0],
        [10.0, 0.0, -0.002002925832530209, 0.10151663457052479, 1.004987562112089],
        [11.0, 0.1, -0.004750681628218854, 0.09538033506703883, 1.044030650891055],
        [12.0, 0.4, -0.005177920474813468, 0.08038027377914903, 1.118033988749895],
        [13.0, 0.9, 0.0, 0.0, 10.0],
    ];
    let span = |[x, y, a, b, length]: [f64; 5]| TabcylSpan::new(Vec2::new(x, y), a, b, length);
    let end = Vec2::new(21.574929257125444, 6.044957554275266);
    Tabcyl { axes: Matrix3::identity(), spans: spans.map(span).to_vec(), end }
}

/// Eight half waves over the x axis from 10 to 18, parabolas .6 high up and down in turn, with straight ends of 10.
fn wave() -> Tabcyl {
    let half = |k: u8| {
        let b = if k.is_multiple_of(2) { -2.4 } else { 2.4 };
        TabcylSpan::new(Vec2::new(10.0 + f64::from(k), 0.0), 0.0, b, 1.0)
    };
    let way = Vec2::new(10.0, 24.0) / 2.6;
    let mut spans = vec![TabcylSpan::new(Vec2::new(10.0, 0.0) - way, 0.0, 0.0, 10.0)];
    spans.extend((0..8).map(half));
    spans.push(TabcylSpan::new(Vec2::new(18.0, 0.0), 0.0, 0.0, 10.0));
    Tabcyl { axes: Matrix3::identity(), spans, end: Vec2::new(18.0, 0.0) + way }
}

/// Runs the text in the plane and in space; both end at `end`.
#[track_caller]
fn both(text: &str, end: [f64; 3]) -> [Run; 2] {
    ["2DCALC", "3DCALC"].map(|calc| {
        let ran = run(&forms(), &format!("{calc}\n{text}")).clean();
        let off = (ran.end() - Vec3::from(end)).norm();
        assert!(off < 1e-9, "{calc} {text}: {:?}", ran.end());
        ran
    })
}

#[test]
fn to_on_past_and_the_second_intersection() {
    let start = "CUTTER/2\nINTOL/0\nOUTTOL/1E-12\nFROM/0,0,0\nINDIRV/1,0,0\nTLON,GOFWD/LX,";
    for (how, x) in [
        ("TO,C", 6.0),
        ("ON,C", 7.0),
        ("PAST,C", 8.0),
        ("TO,2,INTOF,C", 12.0),
        ("ON,2,INTOF,C", 13.0),
        ("PAST,2,INTOF,C", 14.0),
    ] {
        both(&format!("{start}{how}"), [x, 0.0, 0.0]);
    }
}

#[test]
fn tangent_to_a_circle_and_on_along_it() {
    let start = "CUTTER/1\nINTOL/0\nOUTTOL/1E-12\nFROM/0,-2,0\nGO/TO,LX\nINDIRV/1,0,0\n";
    both(&format!("{start}TLRGT,GOFWD/LX,TANTO,CT"), [5.0, -0.5, 0.0]);
    // On round the circle to where the line is met again, half a millionth of the way outside.
    let wide = start.replace("1E-12", "1E-6");
    for calc in ["2DCALC", "3DCALC"] {
        let text = format!("{calc}\n{wide}TLRGT,GOFWD/LX,TANTO,CT\nGOFWD/CT,ON,(LINE/1,0,0,5)");
        let ran = run(&forms(), &text).clean();
        assert!((ran.end() - Vec3::new(5.0, 6.5, 0.0)).norm() < 1.1e-6, "{calc} {:?}", ran.end());
    }
}

/// A flat end lies on the crest as long as the crest is below it: it stops with its middle there, as APT-360 does.
#[test]
fn a_flat_that_passes_over_a_crest_stops_in_the_middle() {
    for (cutter, rest) in [("1", ""), ("1,.2", ""), ("1,.2", "INTOL/.001\n"), ("1,.5", "")] {
        let start =
            format!("INTOL/0\nOUTTOL/.0005\n{rest}CUTTER/{cutter}\nFROM/0,-5,5\nINDIRV/0,1,0\n");
        let go = "GO/TO,LX,TO,PL2\nINDIRV/1,0,0\nTLRGT,GOFWD/LX,PSTAN,CR";
        both(&format!("{start}{go}"), [10.0, -0.5, 2.0]);
        // At a slant the crest crosses the flat elsewhere, and the middle is below the tool end again.
        let slant = "GO/ON,LS,TO,PL2\nINDIRV/1,0,0\nTLON,GOFWD/LS,PSTAN,CR";
        both(&format!("{start}{slant}"), [10.0, 5.0, 2.0]);
    }
}

/// The straight ends of a TABCYL lie along the lines that it is tangent to.
#[test]
fn a_line_is_tangent_to_the_straight_end_of_a_tabcyl() {
    let start = "CUTTER/1\nINTOL/0\nOUTTOL/.0005\nFROM/5,-2,0\nGO/TO,LX\nINDIRV/1,0,0\n";
    let end = |text: &str| run(&forms(), &format!("{start}{text}")).clean().end();
    let near = |text: &str, p: [f64; 3], by: f64| {
        let end = end(text);
        assert!((end - Vec3::from(p)).norm() < by, "{text}: {end:?}");
    };
    near("TLRGT,GOFWD/LX,TANTO,TB", [10.0, -0.5, 0.0], 1e-6);
    near("TLRGT,GOFWD/LX\nGOFWD/TB,ON,(LINE/1,0,0,12)", [12.0, -0.125, 0.0], 0.02);
    let n = 1.36_f64.sqrt();
    let at = [13.0 + 0.3 / n, 0.9 - 0.5 / n, 0.0];
    near("TLRGT,GOFWD/LX,TANTO,TB\nGOFWD/TB,TANTO,LT", at, 0.02);
    // Wherever cut vectors end before, and where one ends just there.
    for step in ["200", "7", "3", "2.5", "2", "1"] {
        near(&format!("MAXDP/{step}\nTLRGT,GOFWD/TB,TANTO,LX"), [10.0, -0.5, 0.0], 0.05);
    }
    near("TLRGT,GOFWD/LX\nGOFWD/TB\nGOFWD/LT,ON,(LINE/1,0,0,20)", [20.0, 5.1 - 0.5 * n, 0.0], 1e-3);
}

/// A straight drive surface leads past all of a check surface on one cut vector: each of its crossings counts.
#[test]
fn every_crossing_of_a_wave_counts_from_far_away() {
    for from in [-3.0, -100.0] {
        for n in 1..=9 {
            let k = f64::from((n - 1) / 2);
            let x = if n == 9 {
                18.125
            } else {
                10.0 + 2.0 * k
                    + if n % 2 == 1 { 0.5 - 0.125_f64.sqrt() } else { 0.5 + 0.125_f64.sqrt() }
            };
            let text = format!(
                "CUTTER/.2\nINTOL/0\nOUTTOL/1E-12\nFROM/{from},.3,0\nINDIRV/1,0,0\nTLON,GOFWD/L3,ON,{n},INTOF,WAVE"
            );
            both(&text, [x, 0.3, 0.0]);
        }
    }
}

/// Beyond the end of a TABCYL the tool changes its side far from it, which is no contact.
#[test]
fn a_check_surface_passed_beyond_its_end_stops_nothing() {
    let start = "CUTTER/1\nINTOL/0\nOUTTOL/1E-12\nFROM/40,-20,0\nINDIRV/0,1,0";
    for word in ["TO", "ON", "PAST"] {
        both(&format!("{start}\nTLON,GOFWD/L40,{word},TB,ON,L30"), [40.0, 30.0, 0.0]);
    }
}

/// A cutter with a flat goes straight towards a small ellipsoid on a single cut vector that leads far beyond it.
#[test]
fn a_small_ellipsoid_on_the_way_of_a_long_cut_vector() {
    let start = "CUTTER/1\nINTOL/0\nOUTTOL/1E-12\nFROM/-3,0,0\nINDIRV/1,0,0\nTLON,GOFWD/LX,";
    both(&format!("{start}TO,QE"), [10.0 - 2.0_f64.sqrt() - 0.5, 0.0, 0.0]);
    both(&format!("{start}ON,QE"), [10.0 - 2.0_f64.sqrt(), 0.0, 0.0]);
}

/// With the tool end on the drive surface an axis at an angle to the part surface leans to the side to which it leans
/// already; an upright one onwards in a GO and along the normal in a motion: as APT-360, whatever INDIRV says.
#[test]
fn the_lean_across_the_surface_that_the_tool_end_is_on() {
    let lean = |text: &str| {
        let ran = run(&forms(), &format!("MULTAX\nCUTTER/.5\nOUTTOL/.001\n{text}")).clean();
        let (_, last) = ran.motions().last().expect("a motion");
        last.points[last.points.len() - 1].ta.y
    };
    let same = |text: &str, expected: f64| {
        let y = lean(text);
        assert!((y - expected).abs() < 1e-6, "{text}: {y}, not {expected}");
    };
    let (rule, sine) = ("TLAXIS/ATANGL,1,10\n", trig::sin_deg(10.0));
    for (drive, normal) in [("LX", 1.0), ("LN", -1.0)] {
        let go = format!("GO/ON,{drive},TO,PL\n");
        for (y, onwards) in [(-3, 1.0), (3, -1.0)] {
            for given in ["1,0,0", "1,.2,0", "1,-.2,0"] {
                let from = format!("FROM/-2,{y},3\n");
                let on = format!("INDIRV/{given}\nTLON,GOFWD/{drive},ON,L20");
                same(&format!("{from}{rule}{go}{on}"), onwards * sine);
                same(&format!("{from}{go}{rule}{on}"), normal * sine);
            }
            for side in [-0.02, 0.02_f64] {
                let axis = format!("FROM/-2,{y},3\nTLAXIS/.2,{side},1\n");
                same(&format!("{axis}{rule}{go}"), sine * side.signum());
            }
        }
    }
    // A part surface whose normal leans more than the angle decides alone.
    let n = 1.05_f64.sqrt();
    let across = trig::cos_deg(10.0) * -0.2 / n - sine * 1.01_f64.sqrt() / n;
    for y in [-3, 3_i32] {
        same(&format!("FROM/-2,{y},3\n{rule}GO/ON,LX,TO,ROOF\n"), across);
        // What leans at the start of the way does not count.
        let dome = format!("FROM/0,{y},3\n{rule}GO/ON,LX,TO,SP,ON,LY\n");
        assert!(lean(&dome) * f64::from(y) < -0.17, "{dome}");
    }
    // Nor what leaned on the way there along a surface that bends.
    for (drive, z, x) in [("LX", 2, -2.5), ("LN", 2, -1.5), ("LX", 9, -2.5), ("LN", 9, -1.5)] {
        for (y, part) in [(-1.5, "BALL"), (1.5, "BALL"), (-1.5, "LOG"), (1.5_f64, "LOG")] {
            let go = format!("FROM/{x},{y},{z}\n{rule}GO/ON,{drive},TO,{part},ON,LW\n");
            let y = lean(&go) * -y.signum();
            assert!((0.232..0.235).contains(&y), "{go}: {y}");
        }
    }
}

/// Of a surface that controls the axis and that the tool end is on, the normal is meant to which the axis leans already, else the
/// one that points on from where the tool comes, whichever way the surface's own does: as APT-360.
#[test]
fn an_upright_axis_leans_onwards_over_the_surface_that_controls_it() {
    for (axis, y) in [("NORMDS", 1.0), ("ATANGL,2,85", trig::cos_deg(85.0))] {
        for line in ["LX", "LN"] {
            for from in [-4.0_f64, 4.0] {
                for (before, sign) in
                    [("", -from.signum()), ("TLAXIS/0,.05,1\n", 1.0), ("TLAXIS/0,-.05,1\n", -1.0)]
                {
                    let text = format!(
                        "CUTTER/.5,.1\nINTOL/0\nOUTTOL/.001\nMULTAX\n{before}FROM/-3,{from},3\nTLAXIS/{axis}\n\
                         GO/ON,{line},TO,BALL,ON,LW\nINDIRV/1,0,0\nTLON,GOFWD/{line},ON,(LINE/1,0,0,2)"
                    );
                    let ran = run(&forms(), &text).clean();
                    let after = ran.motions().flat_map(|(_, m)| m.points.clone()).skip(1);
                    for at in after {
                        assert!((at.ta.y - sign * y).abs() < 1e-6, "{text}: {at:?}");
                    }
                }
            }
        }
    }
}

/// The axis is along the normal through the tool end, as with NORMPS, though a flat end that touches with its edge stands along
/// the normal as well: as APT-360. With CUTANG of no angle it is the same.
#[test]
fn at_no_angle_a_flat_end_touches_a_dome_in_its_middle() {
    for cutter in ["1", "1,.2", ".5,.25"] {
        let path = |axis: &str| {
            let text = format!(
                "CUTTER/{cutter}\nINTOL/0\nOUTTOL/.001\nMULTAX\nFROM/-3,2,3\nTLAXIS/{axis}\nGO/TO,LX,TO,BALL,ON,LW\n\
                 INDIRV/1,0,0\nTLLFT,GOFWD/LX,ON,(LINE/1,0,0,2)"
            );
            let ran = run(&forms(), &text).clean();
            ran.motions().flat_map(|(_, m)| m.points.clone()).collect::<Vec<_>>()
        };
        let normal = path("NORMPS");
        for at in &normal[2..] {
            let out = (at.te - Vec3::new(0.0, 0.0, -4.0)).normalize();
            assert!((at.ta - out).norm() < 1e-9, "{cutter}: {at:?}");
        }
        assert_eq!(normal, path("ATANGL,1,0"), "{cutter}");
        assert_eq!(normal, path("ATANGL,1,0,CUTANG,0"), "{cutter}");
    }
}

#[test]
fn thickness_of_drive_check_and_part_surface() {
    let start = "CUTTER/1\nINTOL/0\nOUTTOL/1E-12\nFROM/0,-2,5\nTHICK/";
    let go = "\nGO/TO,LX,TO,PL\nINDIRV/1,0,0\nTLRGT,GOFWD/LX,";
    both(&format!("{start}.3,.1,.2{go}TO,L20"), [19.3, -0.6, 0.3]);
    both(&format!("{start}-.3,-.1,-.2{go}TO,L20"), [19.7, -0.4, -0.3]);
    // Where the tool end lies on the surface there is no thickness.
    both(&format!("{start}.3,.1,.2{go}ON,L20"), [20.0, -0.6, 0.3]);
    both(&format!("{start}.3,.1,.2{go}PAST,L20"), [20.7, -0.6, 0.3]);
}

#[test]
fn a_negative_thickness_is_at_most_the_radius_of_the_cutter() {
    let start = |thick: &str| format!("INTOL/.01\nOUTTOL/.01\nFROM/0,-2,5\nTHICK/{thick}\n");
    let go = "GO/TO,LX,TO,PL";
    both(&format!("CUTTER/1\n{}{go}", start("0,-.5")), [0.0, 0.0, 0.0]);
    for (thick, of) in [("0,-.501", "LX"), ("-.501,0", "PL"), ("-20", "LX")] {
        let text = format!("CUTTER/1\n{}{go}", start(thick));
        let ran = run(&forms(), &text);
        assert_eq!(ran.code(), 2027, "{text}");
        assert!(ran.diagnostics[0].message.contains(of), "{text}");
    }
    // Neither where the tool end is ON the surface nor of a cutter that is not given.
    both(&format!("CUTTER/1\n{}GO/ON,LX,TO,PL", start("0,-20")), [0.0, 0.0, 0.0]);
    both(&format!("{}GO/ON,LX,TO,PL", start("-3,0")), [0.0, 0.0, -3.0]);
}

#[test]
fn start_ups_to_one_two_and_three_surfaces() {
    let start = "CUTTER/1\nINTOL/0\nOUTTOL/1E-12\nFROM/4,-3,5\n";
    both(&format!("{start}NOPS\nGO/TO,LX"), [4.0, -0.5, 5.0]);
    both(&format!("{start}GO/TO,LX"), [4.0, -0.5, 0.0]);
    both(&format!("{start}GO/PAST,LX,TO,PL2"), [4.0, 0.5, 2.0]);
    both(&format!("{start}GO/TO,LX,TO,PL2,TO,LY"), [0.5, -0.5, 2.0]);
    both(&format!("{start}GO/ON,LX,ON,PL2,PAST,LY"), [-0.5, 0.0, 2.0]);
    // OFFSET pierces along the vector and leaves along the normal.
    both(&format!("{start}INDIRV/1,1,0\nOFFSET/LX,TO,PL2"), [7.0, -0.5, 2.0]);
    // In the plane a directed start stays on its vector; in space it goes on square to the wall from where the cutter's
    // radius is left on the vector. Source: what APT-360 computes.
    for (calc, x) in [("2DCALC", 6.5), ("3DCALC", 7.0 - 0.5 * 0.5_f64.sqrt())] {
        let text = format!("{calc}\n{start}INDIRV/1,1,0\nGO/TO,LX,TO,PL2");
        let end = run(&forms(), &text).clean().end();
        assert!((end - Vec3::new(x, -0.5, 2.0)).norm() < 1e-9, "{text}: {end:?}");
    }
}

/// INDIRP is a direction from where the tool stands then; either word holds up to the next motion along surfaces, whatever moves
/// the tool between: as APT-360.
#[test]
fn a_direction_waits_for_the_next_motion_along_surfaces() {
    let start = "CUTTER/1\nINTOL/0\nOUTTOL/1E-12\nFROM/0,-3,5\n";
    let plane = |text: &str, end: [f64; 3]| {
        let at = run(&forms(), &format!("{start}{text}")).clean().end();
        assert!((at - Vec3::from(end)).norm() < 1e-9, "{text}: {at:?}");
    };
    for sense in ["INDIRV/1,1,0", "INDIRP/2,-1,5"] {
        for (between, x) in [
            ("GOTO/1,-4.5,3", 5.0),
            ("GODLTA/0,-1,0", 3.5),
            ("FROM/7,-1.5,0", 8.0),
            ("GOTO/9,9,9\nGODLTA/-9,-9,-9\nGOTO/0,-2.5,0", 2.0),
        ] {
            plane(&format!("{sense}\n{between}\nGO/TO,LX,TO,PL2"), [x, -0.5, 2.0]);
        }
        // It serves once, here a motion whose way the GODLTA before it says.
        let along = "GO/TO,LX\nINDIRV/-1,1,0\nGODLTA/1,0,0\nTLRGT,GOFWD/LX,ON,L20\n";
        plane(&format!("{sense}\n{along}GOTO/0,-3,5\nGO/TO,LX,TO,PL2"), [0.0, -0.5, 2.0]);
    }
}

#[test]
fn a_direction_guides_a_start_at_other_surfaces_from_the_middle_of_the_cutter() {
    let start = "3DCALC\nCUTTER/1,0,.5,0,0,0,4\nINTOL/0\nOUTTOL/1E-12\n";
    // The middle stands at 20,0,7 and the direction pierces the plane 11.6 / .48 farther on.
    let pierced = 0.6 * 11.6 / 0.48;
    // Missed, the sphere is 30.6.. away and the plane 30.
    let y = 0.75 * (6500.0_f64.sqrt() - 50.0);
    let out = 30.0 / trig::hypot(40.0, y);
    for (text, end) in [
        ("FROM/20,0,5\nINDIRV/-.8,.6,0\nGO/ON,TILT,TO,PL", [10.0, pierced, 0.0]),
        ("FROM/20,0,5\nINDIRV/-.8,.6,0\nGO/TO,TILT,TO,PL", [10.5, pierced - 0.3, 0.0]),
        ("FROM/40,0,20\nINDIRV/0,1,0\nGO/ON,SP,ON,LOW", [40.0 * out, y * out, -10.0]),
    ] {
        let ran = run(&forms(), &format!("{start}{text}")).clean();
        let off = (ran.end() - Vec3::from(end)).norm();
        assert!(off < 1e-6, "{text}: {:?} and not {end:?}", ran.end());
    }
}

#[test]
fn part_surfaces_on_off_and_through_the_tool() {
    let start = "CUTTER/1,.5\nINTOL/0\nOUTTOL/1E-12\nFROM/0,0,7\n";
    // AUTOPS is the plane through the tool end.
    both(&format!("{start}AUTOPS\nINDIRV/1,0,0\nTLON,GOFWD/LX,ON,L20"), [20.0, 0.0, 7.0]);
    // The ball of radius 1/2 at the tilted plane: centre half a unit off it.
    let z = |x: f64| (6.0 + 0.5 - 0.6 * x) / 0.8 - 0.5;
    let end = [10.0, 0.0, z(10.0)];
    let text = "GO/ON,LX,TO,TILT\nINDIRV/1,0,0\nTLON,TLOFPS,GOFWD/LX,ON,(LINE/1,0,0,10)";
    both(&format!("{start}{text}"), end);
    let text = "GO/ON,LX,ON,TILT\nINDIRV/1,0,0\nTLON,TLONPS,GOFWD/LX,ON,(LINE/1,0,0,10)";
    both(&format!("{start}{text}"), [10.0, 0.0, 0.0]);
}

#[test]
fn cutters_with_angles_touch_where_they_are_widest() {
    let along = "\nINTOL/0\nOUTTOL/1E-12\nFROM/-5,0,0\nINDIRV/1,0,0\nTLON,GOFWD/LX,TO,L20";
    let tan = |a: f64| trig::sin_deg(a) / trig::cos_deg(a);
    // Tapered outwards by 10 degrees, 10 high: the rim touches a wall.
    both(&format!("CUTTER/4,0,2,0,0,10,10{along}"), [20.0 - 2.0 - 10.0 * tan(10.0), 0.0, 0.0]);
    // Tapered inwards: the lower corner touches.
    both(&format!("CUTTER/4,0,2,0,0,-10,10{along}"), [18.0, 0.0, 0.0]);
    // A corner radius of 1 between the end and the upright side.
    both(&format!("CUTTER/4,1,1,1,0,0,10{along}"), [18.0, 0.0, 0.0]);
    // A point of 45 degrees beside a ridge of radius 3, its tip 3 from the middle: the line that goes up to
    // the ridge at 45 degrees is (3 + z) / sqrt 2 from the middle.
    let text =
        "CUTTER/4,0,2,2,45,0,10\nINTOL/0\nOUTTOL/1E-9\nFROM/0,5,9\nGO/ON,(LINE/1,0,0,13),TO,CY
INDIRV/0,-1,0\nTLON,GOFWD/(LINE/1,0,0,13),ON,LX";
    let ran = run(&forms(), &format!("3DCALC\n{text}")).clean();
    let z = 3.0 * 2.0_f64.sqrt() - 3.0;
    assert!((ran.end() - Vec3::new(13.0, 0.0, z)).norm() < 1e-8, "{:?}", ran.end());
}

#[test]
fn a_disk_stands_for_the_cutter() {
    let text = "CUTTER/4\nCUTTER/OPTION,2,.5,1\nINTOL/0\nOUTTOL/1E-12\nFROM/0,-3,0\nGO/TO,LX
INDIRV/1,0,0\nTLRGT,GOFWD/LX,TO,L20";
    // The disk at the drive surface, the real cutter at the check surface.
    both(text, [18.0, -0.5, 0.0]);
    both(&format!("{text}\nCUTTER/OPTION,2,OFF\nGOTO/0,-3,0\nGO/TO,LX"), [0.0, -2.0, 0.0]);
}

#[test]
fn maxdp_and_numpts() {
    let text =
        "CUTTER/1\nINTOL/0\nOUTTOL/.01\nFROM/0,-5,0\nGO/TO,CB\nINDIRV/1,0,0\nTLRGT,GOFWD/CB,ON,LY";
    // In the plane MAXDP does not count, as with APT-360.
    let ran = run(&forms(), &format!("3DCALC\nMAXDP/.05\n{text}")).clean();
    let (_, last) = ran.motions().last().expect("a motion");
    let longest = last.points.windows(2).map(|w| (w[1].te - w[0].te).norm()).fold(0.0, f64::max);
    assert!(longest <= 0.05 + 1e-12 && longest > 0.045, "{longest}");
    let few = run(&forms(), &format!("3DCALC\nNUMPTS/5\n{text}"));
    assert_eq!(few.code(), 2008);
}

/// The least number of cut vectors for an arc: vertices on the outer edge of the band, middles on the inner.
fn least(turn: f64, radius: f64, band: [f64; 2], outside: bool) -> usize {
    let (inner, outer) = if outside {
        (radius - band[0], radius + band[1])
    } else {
        (radius - band[1], radius + band[0])
    };
    let cos = inner / outer;
    let half = trig::atan2(((1.0 - cos) * (1.0 + cos)).sqrt(), cos);
    let n = turn / (2.0 * half);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "hundreds")]
    let whole = n.ceil() as usize;
    whole
}

/// Circles in the plane and in space, by APT-360's table of counts: no more than one above the least.
#[test]
fn arcs_have_the_fewest_cut_vectors() {
    let full = std::f64::consts::TAU;
    for (band, expected, outside) in [
        ([0.0, 0.001], 106, true),
        ([0.0, 0.001], 93, false),
        ([0.001, 0.001], 75, true),
        ([0.0005, 0.002], 67, true),
    ] {
        // Path of the cutter's centre: radius 2.25 outside, 1.75 inside a circle of radius 2.
        let radius = if outside { 2.25 } else { 1.75 };
        assert_eq!(least(full, radius, band, outside), expected, "{band:?}");
        // To the left below the circle's middle: outside the circle is on the right of the way.
        let (from, side) = if outside { (-5.0, "TLLFT") } else { (-1.0, "TLRGT") };
        for calc in ["2DCALC", "3DCALC"] {
            let text = format!(
                "{calc}\nCUTTER/.5\nINTOL/{}\nOUTTOL/{}\nFROM/0,{from},0\nGO/TO,CB\nINDIRV/-1,0,0\n{side},GOFWD/CB,ON,2,INTOF,LY",
                band[0], band[1]
            );
            let ran = run(&forms(), &text);
            let ran = ran.clean();
            let (_, last) = ran.motions().last().expect("a motion");
            let n = last.points.len();
            assert!(n == expected || n == expected + 1, "{calc} {band:?}: {n}, least {expected}");
        }
    }
}

/// Over a sphere, ball cutter, tool end in a plane through the centre: a circle again.
#[test]
fn spheres_have_the_fewest_cut_vectors() {
    for band in [1e-2, 1e-3, 1e-4] {
        let text = format!(
            "CUTTER/10,5\nMAXDP/1000\nINTOL/{band}\nOUTTOL/{band}\nFROM/-30,0,0\nGO/ON,LX,TO,SP
INDIRV/1,0,0\nTLON,GOFWD/LX,ON,(LINE/1,0,0,30)"
        );
        let ran = run(&forms(), &text).clean();
        let start = ran.motions().nth(1).and_then(|(_, m)| m.points.last()).expect("a start").te;
        let centre = Vec3::new(0.0, 0.0, -55.0);
        let (a, b) = (start - centre, ran.end() - centre);
        let turn = trig::angle_between(a, b);
        let (_, last) = ran.motions().last().expect("a motion");
        let n = last.points.len();
        let least = least(turn, 55.0, [band, band], true);
        assert!(n == least || n == least + 1, "{band}: {n}, least {least}");
    }
}

/// A plane that the cylinder is tangent to is grazed: where the tool stops does not hang on where cut vectors end before.
#[test]
fn what_is_only_grazed_stops_the_tool_where_a_tenth_of_the_band_is_left() {
    let mut forms = forms();
    let mut add = |name: &str, kind: &str, w: &[f64]| {
        forms.insert(name.into(), form(kind, w).expect("a legal form"));
    };
    add("WALL", "CYLNDR", &[0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 10.0]);
    add("DOME", "SPHERE", &[0.0, 0.0, -1000.0, 1000.0]);
    add("GRAZED", "PLANE", &[1.0, 0.0, 0.0, 20.0]);
    for (intol, outtol) in [(0.0, 0.02), (0.01, 0.01)] {
        for step in ["200", "7", "3", "2.5", "2", "1"] {
            let text = format!(
                "CUTTER/10\nINTOL/{intol}\nOUTTOL/{outtol}\nMAXDP/{step}\nFROM/20,-30,5\nGO/TO,WALL,TO,DOME\n\
                 INDIRV/1,0,0\nTLRGT,GOFWD/WALL,TO,GRAZED"
            );
            let end = run(&forms, &text).clean().end();
            assert!((end.x - (15.0 - 0.002)).abs() < 1e-8, "{intol} {step}: {end:?}");
        }
    }
}

/// Where the part surface leans, the tool end on it and the cutter touching it are a different height; the last of TLONPS,
/// TLOFPS and of the GOs that name the part surface says which is meant. Source: what APT-360 does.
#[test]
fn a_start_that_names_the_part_surface_says_anew_whether_the_tool_end_is_on_it() {
    // TILT at x: .6 x + .8 z = 6; a flat end of radius 1 touches it .75 above its tool end's place.
    let on = |x: f64| (6.0 - 0.6 * x) / 0.8;
    let to = |x: f64| on(x) + 0.75;
    let start = "CUTTER/2\nFROM/10,5,20\n";
    let along = "TLLFT,GOLFT/L20,ON,LB\n";
    let mut f = forms();
    f.insert("LB".into(), form("LINE", &[0.0, 1.0, 0.0, 8.0]).expect("a line"));
    let ends = |text: &str, end: [f64; 3]| {
        for calc in ["2DCALC", "3DCALC"] {
            let ran = run(&f, &format!("{calc}\n{start}{text}")).clean();
            let off = (ran.end() - Vec3::from(end)).norm();
            assert!(off < 1e-9, "{calc} {text}: {:?}", ran.end());
        }
    };
    // TLONPS or TLOFPS before such a GO holds no longer, also in the motion after it.
    ends(&format!("TLONPS\nGO/TO,L20,TO,TILT\n{along}"), [19.0, 8.0, to(19.0)]);
    ends(&format!("TLOFPS\nGO/TO,L20,ON,TILT\n{along}"), [19.0, 8.0, on(19.0)]);
    // A GO with the drive surface alone follows it, through GOTO and a further part surface too.
    ends("GO/TO,L20,ON,TILT\nGOTO/10,5,20\nGO/TO,LY", [1.0, 5.0, on(1.0)]);
    ends("GO/TO,L20,ON,PL\nPSIS/TILT\nGO/TO,LY", [1.0, 5.0, on(1.0)]);
    ends("GO/TO,L20,TO,TILT\nGO/TO,LY", [1.0, 5.0, to(1.0)]);
    // A word between them is the last to say so.
    ends("GO/TO,L20,ON,TILT\nTLOFPS\nGO/TO,LY", [1.0, 5.0, to(1.0)]);
    ends("GO/TO,L20,TO,TILT\nTLONPS\nGO/TO,LY", [1.0, 5.0, on(1.0)]);
}

/// In space a direction is followed all the way, forward or back, where the part surface has the normal that it had at the
/// start-up in space before; else it leads to where it pierces the drive surface, and on from there goes the least way.
/// Source: what APT-360 does.
#[test]
fn a_directed_start_in_space_keeps_to_its_direction_on_the_part_surface_of_the_one_before() {
    let ran = |before: &str, sense: &str| {
        let text = format!(
            "3DCALC\nCUTTER/2\nFROM/10,5,1\nGO/TO,L20,ON,{before}\nGOTO/10,5,1\n\
             INDIRV/{sense},0\nGO/TO,LY,ON,PL"
        );
        run(&forms(), &text).clean().end()
    };
    let near = |a: Vec3, b: [f64; 3], eps: f64| {
        assert!((a - Vec3::from(b)).norm() < eps, "{a:?}, not {b:?}");
    };
    // Nine to the left of 10,5 along -1,.3, and as far against 1,.3.
    near(ran("PL", "-1,.3"), [1.0, 7.7, 0.0], 1e-9);
    near(ran("LOW", "-1,.3"), [1.0, 7.7, 0.0], 1e-9);
    near(ran("PL", "1,.3"), [1.0, 2.3, 0.0], 1e-9);
    // C about 10,0 with radius 3 is passed by at more than the radius of the cutter.
    let text =
        "3DCALC\nCUTTER/2\nFROM/10,9,1\nGO/TO,L20,ON,PL\nGOTO/10,9,1\nINDIRV/1,.3,0\nGO/TO,C,ON,PL";
    assert_eq!(run(&forms(), text).code(), 2012);
    // Less the radius along the direction from where the line meets LY, then straight to it; the band is left out here.
    let y = 8.0 - 0.3 / 1.09_f64.sqrt();
    near(ran("TILT", "-1,.3"), [1.0, y, 0.0], 0.02);
}
