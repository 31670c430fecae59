//! PSTAN: the tool stops with its end over the line along which the check surface is tangent to its floor.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

/// Along a wall to a cylinder along y that is tangent to the floor at x = 20.
fn stops(wall: &str, cutter: &str, cylinder: &str) -> [f64; 3] {
    let text = format!(
        "UNITS/MM\nFLOOR=PLANE/0,0,1,0\nWALL={wall}\nROUND=CYLNDR/{cylinder}\n{cutter}\n\
         INTOL/.005\nOUTTOL/.005\nFROM/-20,-15,5\nINDIRV/0,1,0\nGO/TO,WALL,TO,FLOOR\n\
         INDIRV/1,0,0\nTLRGT,GOFWD/WALL,PSTAN,ROUND\nFINI\n"
    );
    let ran = run::run(&text, Verify::Full);
    assert!(ran.codes().is_empty(), "{:?} {text}", ran.told);
    *ran.places.last().expect("the tool goes")
}

const WALLS: [&str; 3] = [
    "PLANE/0,1,0,0",
    "CYLNDR/0,80,0,0,0,1,80",
    "TABCYL/NOZ,SPLINE,-60,-1,-40,1,-20,-1,0,1,20,-1,40,1,60,-1",
];

#[test]
fn a_cutter_taller_than_a_fillet_comes_to_it_from_outside_of_its_cylinder() {
    for wall in WALLS {
        for cutter in ["CUTTER/6,3,0,3,0,0,60", "CUTTER/6,3,0,3,0,0,8"] {
            let p = stops(wall, cutter, "20,0,12,0,1,0,12");
            assert!((p[0] - 20.0).abs() < 0.02 && p[2].abs() <= 0.01, "{wall} {cutter} {p:?}");
        }
    }
}

/// Its flat lies on both from the place on where its leading edge comes to the line, over many cut vectors of a round wall.
#[test]
fn a_flat_end_stops_over_the_line_where_a_hump_begins() {
    for wall in WALLS {
        for diameter in [6, 14] {
            let p = stops(wall, &format!("CUTTER/{diameter}"), "20,0,-40,0,1,0,40");
            assert!((p[0] - 20.0).abs() < 0.02 && p[2].abs() <= 0.01, "{wall} {diameter} {p:?}");
        }
    }
}

/// Onto a sphere that touches the drive surface from within, and from outside of a hollow one: the cutter ends in the bands of both,
/// though chords lie at the edge of that of the drive surface before.
#[test]
fn a_motion_to_a_tangent_sphere_ends_in_the_bands_of_both() {
    for (k, radius) in [30.0, 42.0, 20.0, 47.0, 12.0].into_iter().enumerate() {
        let up = 0.25 + 0.13 * f64::from(u32::try_from(k).expect("few"));
        let out = (1.0 - up * up).sqrt();
        for [intol, outtol] in [[0.0, 0.02], [0.02, 0.02], [0.0, 0.005], [0.05, 0.0]] {
            let z = 55.0 * up - 5.0;
            let text = format!(
                "UNITS/MM\nDR=SPHERE/0,0,0,50\nCH=SPHERE/{},0,{},{radius}\nPA=PLANE/0,0,1,{z}\n\
                 EN=PLANE/0,1,0,8\nCUTTER/10,5,0,5,0,0,20\nINTOL/{intol}\nOUTTOL/{outtol}\n\
                 FROM/{},-18,{}\nGO/TO,DR,TO,PA\nINDIRV/0,1,0\nTLRGT,GOFWD/DR,TANTO,CH\n\
                 GOFWD/CH,ON,EN\nFINI\n",
                (50.0 - radius) * out,
                (50.0 - radius) * up,
                55.0 * out + 5.0,
                z + 10.0,
            );
            let ran = run::run(&text, Verify::Full);
            assert_eq!(ran.codes(), Vec::<String>::new(), "{:?} {text}", ran.told);
            let near = |p: &&[f64; 3]| p[1].abs() < 1.0;
            assert!(ran.places.iter().any(|p| near(&p)), "{:?} {text}", ran.places);
        }
    }
}

/// A wave that cuts in by more than the bands where it comes near first is not tangent there, when it is tangent farther on; with
/// nothing farther on the first place counts, and the proof tells what is wrong with it.
#[test]
fn a_near_miss_is_passed_by_where_a_tangency_follows() {
    let stops = |second: f64| {
        let text = format!(
            "UNITS/MM\nW=PLANE/0,1,0,0\nC=TABCYL/NOZ,SPLINE,-30,6,-20,4,-10,2,0,2,10,-.05,20,2,$\n\
             30,2,40,{second},50,2,60,2,70,4,80,6\nCUTTER/6\nINTOL/.01\nOUTTOL/.02\n\
             FROM/-20,-20,5\nINDIRV/0,1,0\nGO/TO,W,TO,(PLANE/0,0,1,0)\nINDIRV/1,0,0\n\
             TLRGT,GOFWD/W,TANTO,C\nFINI\n"
        );
        let ran = run::run(&text, Verify::Full);
        (ran.places.last().expect("it goes")[0], ran.faults())
    };
    let (x, faults) = stops(0.0);
    assert!((x - 40.0).abs() < 0.5 && faults.is_empty(), "{x} {faults:?}");
    let (x, faults) = stops(1.0);
    assert!((x - 10.0).abs() < 0.5 && faults == ["APT5001"], "{x} {faults:?}");
}

/// What keeps a cutter from being tangent to both is told: another thickness, or a hollow that it does not fit.
#[test]
fn why_surfaces_are_not_tangent_is_told() {
    for (cutter, why) in [("10,5\nTHICK/.2,.5", "0.3 deep"), ("10,0,5,0,0,0,15", "deep in that")] {
        let text = format!(
            "UNITS/MM\nFL=PLANE/0,0,1,0\nG=CYLNDR/0,0,20,0,1,0,20\nCUTTER/{cutter}\nOUTTOL/.01\n\
             FROM/-40,-20,30\nGO/TO,(PLANE/0,1,0,0),TO,FL\nINDIRV/1,0,0\n\
             TLRGT,GOFWD/(PLANE/0,1,0,0),PSTAN,G\nFINI\n"
        );
        let ran = run::run(&text, Verify::Full);
        assert_eq!(ran.faults(), ["APT2009"], "{:?}", ran.told);
        assert!(ran.told.iter().any(|(_, m)| m.contains(why)), "{:?}", ran.told);
    }
}

/// Out of a round groove between two ramps, whatever the height of the cutter: one that would fit in the middle of the cylinder and
/// not where ramp and groove meet has the groove open above it, as a taller one has.
#[test]
fn a_groove_is_open_for_a_cutter_that_does_not_fit_below_its_cylinder_there() {
    for height in [10.0, 25.0, 33.0, 34.3, 34.32, 34.5, 35.0, 36.0, 37.5, 39.0, 40.0, 127.0] {
        let text = format!(
            "UNITS/MM\nR1=PLANE/.5,0,.866025403784439,0\nR2=PLANE/-.5,0,.866025403784439,0\n\
             G=CYLNDR/0,0,23.094010767585,0,1,0,20\nDR=PLANE/0,1,0,0\nCUTTER/4,2,0,2,0,0,{height}\n\
             OUTTOL/.02\nFROM/-40,0,60\nGO/ON,DR,TO,R1\nINDIRV/1,0,0\nTLON,GOFWD/DR,PSTAN,G\n\
             PSIS/G\nGOFWD/DR,PSTAN,R2\nPSIS/R2\nGOFWD/DR,ON,(PLANE/1,0,0,40)\nFINI\n"
        );
        let ran = run::run(&text, Verify::Full);
        assert_eq!(ran.codes(), Vec::<String>::new(), "{:?} {text}", ran.told);
        // The middle of the ball is 18 below that of the groove, and 2 above the ramps.
        for [x, _, z] in ran.places.into_iter().skip(1) {
            let low = z + 2.0 - 23.094010767585;
            let groove = 18.0 - (x * x + low * low).sqrt();
            let ramps = (z + 2.0) * 0.866025403784439 - x.abs() * 0.5 - 2.0;
            let above = if x.abs() < 9.0 { groove } else { ramps };
            assert!((-1e-6..=0.021).contains(&above), "{above} at {x}, {z} {text}");
        }
    }
}

/// Behind a place where the cutter is in its check surface no other check surface ends the motion.
#[test]
fn a_near_miss_is_not_passed_by_for_another_check_surface() {
    let text = "UNITS/MM\nW=PLANE/0,1,0,0\nC=TABCYL/NOZ,SPLINE,-30,6,-20,4,-10,2,0,2,10,-.05,20,2,$\n\
                30,2,40,4,50,4,60,4,70,4,80,6\nE=PLANE/1,0,0,60\nCUTTER/6\nINTOL/.01\nOUTTOL/.02\n\
                FROM/-20,-20,5\nINDIRV/0,1,0\nGO/TO,W,TO,(PLANE/0,0,1,0)\nINDIRV/1,0,0\n\
                TLRGT,GOFWD/W,TANTO,C,LA,ON,E,LB\nLA)GODLTA/0,0,1\nLB)GODLTA/0,0,1\nFINI\n";
    let ran = run::run(text, Verify::Full);
    assert_eq!(ran.faults(), ["APT5001"], "{:?}", ran.told);
    assert!(ran.places.iter().all(|p| p[0] < 11.0), "{:?}", ran.places);
}

/// A place at which a cutter touches a hollow as a whole and as an open one is one place.
#[test]
fn one_tangency_counts_once() {
    for height in [20, 30, 60] {
        for (nth, faults) in [("", &[][..]), ("2,INTOF,", &["APT2009"])] {
            let text = format!(
                "UNITS/MM\nFL=PLANE/0,0,1,0\nG=CYLNDR/0,0,20,0,1,0,20\n\
                 CUTTER/10,5,0,5,0,0,{height}\nOUTTOL/.01\nFROM/-40,-20,30\n\
                 GO/TO,(PLANE/0,1,0,0),TO,FL\nINDIRV/1,0,0\n\
                 TLRGT,GOFWD/(PLANE/0,1,0,0),PSTAN,{nth}G\nFINI\n"
            );
            let ran = run::run(&text, Verify::Full);
            assert_eq!(ran.faults(), faults, "{:?} {text}", ran.told);
        }
    }
}
