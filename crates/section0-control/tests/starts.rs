//! Start-ups of cutters whose sides lean, and beside walls that lean over the cutter: places that APT-360 gives as well.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

fn end(text: &str) -> [f64; 3] {
    let ran = run::run(text, Verify::Full);
    assert!(ran.codes().is_empty(), "{:?} {text}", ran.told);
    *ran.places.last().expect("the tool goes")
}

/// With sides that lean the direction brings the tool so near that it would touch with half its diameter, the width of the band
/// off; from there it goes to both surfaces by the least way.
#[test]
fn a_tapered_cutter_starts_up_in_space() {
    let (sin, cos) = (0.21265_f64, 0.97713_f64);
    let text = "CUTTER/.56158,.05515,.23282,.05515,0,7.9774,4.55847\n\
                INTOL/.0025\nOUTTOL/.0025\nFLOOR=PLANE/0,0,1,.4\n\
                WALL=PLANE/-.21265,.97713,0,.21601\nFROM/-1.2,-1.16,.78\n\
                INDIRV/.1,1,0\nGO/TO,WALL,TO,FLOOR\nFINI\n";
    let p = end(text);
    let te = [-1.2, -1.16];
    let size = 1.01_f64.sqrt();
    let v = [0.1 / size, 1.0 / size];
    let across = |x: [f64; 2]| cos * x[1] - sin * x[0];
    let along = |x: [f64; 2]| cos * x[0] + sin * x[1];
    let way = (0.21601 - across(te)) / across(v) - 0.28079 - 0.005;
    assert!((along([p[0], p[1]]) - along(te) - along(v) * way).abs() < 1e-5, "{p:?}");
    assert!((p[2] - 0.4).abs() < 1e-9, "{p:?}");
}

/// A wall that leans over the tool cuts through it where it stands: the tool stays on the side of its middle.
#[test]
fn a_cutter_that_a_wall_cuts_through_stays_where_its_middle_is() {
    // The wall y = .3 z: at its middle, 1.5 up, the tool is before it from y = .45 on.
    for (y, before) in [(0.7, true), (0.2, false)] {
        let text = format!(
            "CUTTER/.5,0,.25,0,0,0,3\nINTOL/.001\nOUTTOL/.001\nFLOOR=PLANE/0,0,1,0\n\
             WALL=PLANE/0,1,-.3,0\nFROM/0,{y},0\nGO/TO,WALL,TO,FLOOR\nFINI\n"
        );
        let p = end(&text);
        // With the top's edge from the front, with the bottom's from behind.
        let touches = if before { 0.9 + 0.25 } else { -0.25 };
        assert!((p[1] - touches).abs() < 1e-6 && p[2].abs() < 1e-9, "{before} {p:?}");
    }
}

/// OFFSET goes along the normal from the drive surface and then along the axis to the part surface: from a wall that leans
/// away it parts on its way down, and in a bowl it goes down and not to the place above.
#[test]
fn offset_goes_down_to_the_nearer_place_of_its_part_surface() {
    let program = |wall: &str| {
        format!(
            "CUTTER/1,.5\nINTOL/.001\nOUTTOL/.001\nBOWL=SPHERE/0,0,20,20\nWALL={wall}\nFROM/0,-3,2\n\
             INDIRV/0,1,0\nOFFSET/TO,WALL,TO,BOWL\nFINI\n"
        )
    };
    let low = |y: f64| 20.0 - (19.5_f64 * 19.5 - y * y).sqrt() - 0.5;
    // Upright at y = 0 the centre of the ball is .5 before it.
    let p = end(&program("PLANE/0,1,0,0"));
    assert!((p[1] + 0.5).abs() < 1e-6 && (p[2] - low(0.5)).abs() < 0.003, "{p:?}");
    // From the wall y = -.4 z it parts on its way down.
    let ran = run::run(&program("PLANE/0,1,.4,0"), Verify::Full);
    assert_eq!(ran.codes(), ["APT2058"], "{:?}", ran.told);
    let p = *ran.places.last().expect("the tool goes");
    assert!(p[1] < -1.0 && (p[2] - low(p[1])).abs() < 0.003, "{p:?}");
}

/// SRFVCT points from the TO side to the PAST side, wherever the tool stands: above the floor, on it or below.
#[test]
fn surface_vectors_tell_the_sides_wherever_the_tool_stands() {
    for from in [1.0, 0.0, -9.0] {
        for (relation, up, z) in
            [("TO", 1, -5.0), ("PAST", 1, 0.0), ("TO", -1, 0.0), ("PAST", -1, -5.0)]
        {
            let text = format!(
                "CUTTER/.5\nFLOOR=PLANE/0,0,1,0\nWALL=LINE/XAXIS\nFROM/2,0,{from}\n\
                 SRFVCT/0,-1,0,0,0,{up}\nGO/TO,WALL,{relation},FLOOR\nFINI\n"
            );
            let p = end(&text);
            let there = [2.0, 0.25, z];
            assert!(p.iter().zip(there).all(|(a, b)| (a - b).abs() < 1e-9), "{p:?} {text}");
        }
    }
}

/// With a direction for the part surface too the first one only brings the tool near: where it misses, by three quarters of
/// the gap; from there the nearest position counts. Without one for the drive surface it is the nearest from where the tool is.
#[test]
fn directions_for_several_surfaces_lead_to_the_nearest_position_behind_them() {
    let program = |given: &str| {
        format!(
            "CUTTER/.5\nHUB=CIRCLE/3,3,1\nFLOOR=PLANE/0,0,1,-.5\nFROM/8,0,1\nINDIRV/{given}\n\
             GO/TO,HUB,TO,FLOOR\nFINI\n"
        )
    };
    let nearest_to = |x: f64, y: f64| {
        let (u, v) = (x - 3.0, y - 3.0);
        let far = (u * u + v * v).sqrt();
        [3.0 + 1.25 * u / far, 3.0 + 1.25 * v / far, -0.5]
    };
    let gap = 34.0_f64.sqrt() - 1.25;
    let way = 0.75 * gap / 1.09_f64.sqrt();
    for (given, there) in [
        ("-1,.3,0,0,0,-1", nearest_to(8.0 - way, 0.3 * way)),
        (",(VECTOR/0,0,-1)", nearest_to(8.0, 0.0)),
    ] {
        let p = end(&program(given));
        assert!(p.iter().zip(there).all(|(a, b)| (a - b).abs() < 2e-3), "{p:?} {there:?}");
    }
}

/// What goes on straight beyond the corner of a twisted surface does not turn back over it: from however high the tool comes down
/// to the surface itself.
#[test]
fn a_tool_from_above_comes_down_to_the_surface_and_not_to_what_goes_on_beyond_a_corner() {
    use aptc_geometry::sculpt::{SplinePoint, mesh, nearest_on};
    use aptc_geometry::{Vec3, sculptured::MeshSpacing};
    let mut state = 7_u64;
    let mut draw = |size: i64| {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let share = i64::try_from(state >> 40).expect("24 bits");
        share % (2 * size + 1) - size
    };
    let mut climbs = 0;
    for _ in 0..40 {
        let rows: Vec<Vec<[i64; 3]>> = (0..4_i64)
            .map(|j| {
                let at = |i: i64| [40 * i - 60 + draw(14), 40 * j - 60 + draw(14), draw(14)];
                (0..4).map(at).collect()
            })
            .collect();
        let vec = |p: &[i64; 3]| Vec3::from(p.map(|x| f64::from(i32::try_from(x).expect("small"))));
        let knots: Vec<Vec<_>> = rows
            .iter()
            .map(|row| row.iter().map(|p| SplinePoint::plain(vec(p))).collect())
            .collect();
        let surface = mesh(&knots, MeshSpacing::Xyz).expect("a mesh");
        let spline = |row: &Vec<[i64; 3]>| {
            let points = row.iter().map(|[x, y, z]| format!("({x},{y},{z})"));
            format!("SPLINE,{}", points.collect::<Vec<_>>().join(",$\n"))
        };
        let all = rows.iter().map(spline).collect::<Vec<_>>().join(",$\n");
        for from in [40, 90, 300, 900] {
            let text = format!(
                "UNITS/MM\nF=SSURF/SMESH,XYZ,$\n{all}\nCUTTER/8,4,0,4,0,0,60\nINTOL/.01\nOUTTOL/.01\n\
                 FROM/-12,30,{from}\nINDIRV/0,-1,0\nGO/ON,(PLANE/0,1,0,8),TO,F,$\nON,(PLANE/1,0,0,-9)\nFINI\n"
            );
            let ran = run::run(&text, Verify::Full);
            assert!(ran.faults().is_empty(), "{:?} {text}", ran.told);
            let te = Vec3::from(*ran.places.last().expect("it goes"));
            let middle = te + Vec3::z() * 4.0;
            let foot = nearest_on(&surface, middle);
            assert!((foot.distance - 4.0).abs() < 0.0101, "{} {te} {text}", foot.distance);
            climbs += u32::from(te.z > 30.0);
        }
    }
    assert_eq!(climbs, 0);
}

/// A tool over a lying cylinder in a ball goes along that to the wall of the ball, and not down to the bottom of the ball first,
/// through the cylinder.
#[test]
fn a_tool_in_a_hollow_goes_along_what_stands_in_it() {
    for center in [-55.0, -40.0, -20.0, 20.0, 40.0, 55.0] {
        let text = format!(
            "UNITS/MM\nCYL=CYLNDR/0,0,-60,0,1,0,60\nBALL=SPHERE/{center},0,0,100\n\
             CUTTER/10,5,0,5,0,0,20\nOUTTOL/.01\nFROM/0,0,20\n\
             GO/ON,(PLANE/0,1,0,0),TO,CYL,TO,BALL\nFINI\n"
        );
        let ran = run::run(&text, Verify::Full);
        let [x, y, z] = *ran.places.last().expect("the tool goes");
        // The middle of the cutter's ball: 5 above the cylinder and 5 inside of the ball.
        let apart = |from: [f64; 2]| ((x - from[0]).powi(2) + (z + 5.0 - from[1]).powi(2)).sqrt();
        let (over, under) = (apart([0.0, -60.0]) - 65.0, 95.0 - apart([center, 0.0]));
        assert!(
            (-1e-9..=0.01).contains(&over) && (-1e-9..=0.01).contains(&under),
            "{text} {x} {z}"
        );
        // On the side of the cylinder's top and where the wall is nearer.
        assert!(y.abs() < 1e-9 && z > -60.0 && x * center <= 0.0, "{center} {x} {z}");
        assert!(ran.faults().iter().all(|code| code == "APT5009"), "{:?} {text}", ran.told);
    }
}

/// OFFSET comes to the wall first, and then up to the floor: from a wall that leans by 3 in 4 six tenths of that way away.
#[test]
fn what_offset_leaves_is_told() {
    let program = |first: &str, direction: &str| {
        format!(
            "UNITS/MM\nWALL=PLANE/0,.8,.6,0\nFLOOR=PLANE/0,0,1,0\nCUTTER/16,8\nINTOL/.01\nOUTTOL/.01\n\
             FROM/0,60,-30\n{direction}\n{first},FLOOR\nFINI\n"
        )
    };
    let ran = run::run(&program("OFFSET/TO,WALL,TO", "INDIRV/0,-1,0"), Verify::Full);
    let end = ran.places.last().expect("it goes there");
    // The ball of 8 comes to the wall 28.08 below the floor.
    let up = 30.0 - 3.2 * 0.6;
    assert!((end[1] - (22.5 + 3.2 * 0.8)).abs() < 1e-9 && end[2].abs() < 1e-9, "{end:?}");
    let [(code, message)] = &ran.told[..] else { panic!("{:?}", ran.told) };
    assert_eq!(code, "APT2058");
    assert!(message.contains(&format!("{:.3}", 0.6 * up)), "{message}");
    let ran = run::run(&program("GO/TO,WALL,TO", "INDIRV/0,-1,0"), Verify::Full);
    assert!(ran.told.is_empty(), "{:?}", ran.told);
}

/// Past a thin bar that lies there is no place for a tall cutter that comes from above: not in the air over it, beside what runs
/// straight up from its outline. The directions that lead to one are told, and do.
#[test]
fn a_cutter_does_not_stop_above_a_bar_that_it_is_to_be_past() {
    for bar in ["CYLNDR/0,0,0,0,1,0,7", "CONE/(POINT/0,-60,0),(VECTOR/0,1,-.2),13"] {
        let program = |way: &str| {
            format!(
                "UNITS/MM\nBAR={bar}\nDS=PLANE/0,1,0,5\nCUTTER/8,0,4,0,0,0,20\nTOLER/.01\nFROM/-24,-24,27\n\
                 {way}\nGO/ON,DS,PAST,BAR\nFINI\n"
            )
        };
        let ran = run::run(&program(""), Verify::Full);
        assert_eq!(ran.codes(), ["APT2011"], "{bar} {:?}", ran.told);
        let ran = run::run(&program("INDIRV/1,0,0"), Verify::Full);
        assert_eq!(ran.faults(), Vec::<String>::new(), "{bar} {:?}", ran.told);
        let [.., z] = *ran.places.last().expect("the tool goes");
        assert!(z < 0.0, "{bar} {z}");
    }
}

/// Where the way along the axis leads into the wall the same is told, with the depth, before the proof refutes it.
#[test]
fn what_offset_cuts_into_is_told() {
    // The wall leans over the floor: what comes to it above goes down into it.
    let text = "UNITS/MM\nWALL=PLANE/0,.8,-.6,0\nFLOOR=PLANE/0,0,1,-30\nCUTTER/16,8\nINTOL/0\nOUTTOL/.01\n\
                FROM/0,-60,0\nINDIRV/0,1,0\nOFFSET/TO,WALL,TO,FLOOR\nFINI\n";
    let ran = run::run(text, Verify::Full);
    assert_eq!(ran.codes(), ["APT2058", "APT5001"], "{:?}", ran.told);
    let end = ran.places.last().expect("it goes there");
    let ball = 0.8 * end[1] - 0.6 * (end[2] + 8.0);
    let deep = format!("{:.3}", 8.0 + ball);
    assert!(
        ran.told[0].1.contains(&deep) && ran.told[0].1.contains("deep in WALL"),
        "{ball} {:?}",
        ran.told
    );
}

/// POLCON W upright: sections that are conics in y and z, from y = -rise / 2 at z = 70 to the same at -30 with end tangents that meet
/// at y = rise / 2, along x.
fn hollow_wall(rise: f64, fullness: f64) -> String {
    let mut wall = [0.0; 79];
    wall[0] = 1.0;
    (wall[1], wall[7], wall[8], wall[10]) = (1.0, 1.0, -20.0, -1.0);
    (wall[14], wall[15]) = (-50.0, 100.0);
    (wall[16], wall[24], wall[32], wall[40]) = (-50.0, -rise, -50.0, rise);
    (wall[48], wall[56], wall[64]) = (50.0, 0.5 * rise, fullness);
    let wall: String = wall.iter().map(|x| format!(",$\n{x}")).collect();
    format!("W=POLCON/CANON{wall}")
}

/// The flank of a cutter before the upper end of a wall that leans over it goes by that end, and has no place of contact there: the
/// tool is before the wall all the same. TO stays there, from behind it stays behind, and PAST is the other one.
#[test]
fn a_tool_before_the_upper_end_of_a_hollow_wall_stays_before_it() {
    let wall = hollow_wall(3.0, 0.55);
    for (cutter, high) in [("6,0,6", 20), ("6,0,6", 50), ("6,0,6", 60), ("5.9,.1,5.9", 50)] {
        for (relation, from, before) in
            [("TO", -37, true), ("PAST", 37, true), ("TO", 37, false), ("PAST", -37, false)]
        {
            let text = format!(
                "UNITS/MM\n{wall}\nCUTTER/12,{cutter},0,0,30\nINTOL/.01\n\
                 OUTTOL/.01\nFROM/0,{from},{high}\nGO/{relation},W,TO,(PLANE/0,0,1,0)\nFINI\n"
            );
            let ran = run::run(&text, Verify::Full);
            let p = *ran.places.last().expect("the tool goes");
            let there = if before { -7.21 } else { 4.8 };
            assert!((p[1] - there).abs() < 0.03 && p[2].abs() < 1e-9, "{p:?} {text}");
            // On the way to the other side it goes through the wall, and is told so.
            let through = (relation == "PAST").then_some("APT5009");
            assert!(
                ran.codes().iter().all(|c| Some(c.as_str()) == through),
                "{:?} {text}",
                ran.told
            );
        }
    }
}

/// A wall that is lower than the tool and leans over it ends in the tool's side where its lower part is touched: that is no place,
/// and the end is named. A tool that is no taller than what leans over it stands there.
#[test]
fn a_wall_whose_upper_end_would_be_in_a_tall_tool_has_no_place_for_it() {
    for fullness in [0.52, 0.6, 0.7] {
        for cutter in ["6,0,6", "5,1,5", "1,5,1"] {
            let program = |height: f64| {
                format!(
                    "UNITS/MM\n{}\nCUTTER/12,{cutter},0,0,{height}\nINTOL/.01\nOUTTOL/.01\n\
                     FROM/0,-37,40\nGO/TO,W,TO,(PLANE/0,0,1,0)\nFINI\n",
                    hollow_wall(8.0, fullness)
                )
            };
            let tall = run::run(&program(127.0), Verify::Full);
            assert_eq!(tall.codes(), ["APT2011"], "{:?} {fullness} {cutter}", tall.told);
            let low = end(&program(30.0));
            // Before the wall's middle by its radius and hardly more.
            let middle = -4.0 + 8.0 * (2.0 * fullness - 1.0);
            assert!((low[1] - middle + 6.0).abs() < 0.5, "{low:?} {fullness} {cutter}");
        }
    }
}
