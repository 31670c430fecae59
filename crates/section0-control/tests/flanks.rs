//! Flanks along sculptured walls that are lower than the cutter is tall, that are round, or one patch alone: all of it is proved.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

/// Along the drive surface WALL from x = 20 to x = 80, the tool on the side of greater y.
fn along(wall: &str, cutter: &str, more: &str) -> run::Ran {
    let text = format!(
        "UNITS/MM
{wall}
FLOOR=PLANE/0,0,1,0
CUTTER/{cutter}
INTOL/.01
OUTTOL/.01
FROM/20,50,20
{more}
INDIRV/0,-1,0
GO/TO,WALL,TO,FLOOR
INDIRV/1,0,0
TLLFT,GOFWD/WALL,ON,(PLANE/1,0,0,80)
FINI
"
    );
    run::run(&text, Verify::Full)
}

/// A wall whose top is moved sideways by as much as this.
fn wall(high: i32, over: f64) -> String {
    let points = [(0.0, 0.0), (25.0, 9.0), (60.0, 12.0), (100.0, 3.0)];
    let line = |by: f64, z: i32| {
        let points = points.map(|(x, y)| format!("(POINT/{x},{:.3},{z})", y + by));
        points.join(",$\n")
    };
    format!(
        "FOOT=SCURV/SPLINE,{}\nTOP=SCURV/SPLINE,{}\nWALL=SSURF/RULED,FOOT,TOP",
        line(0.0, 0),
        line(over, high)
    )
}

/// A cutter without a height is five inches tall, as many as ten heights of a low wall.
#[test]
fn a_flank_is_taller_than_many_heights_of_the_wall() {
    for high in [30, 12, 8] {
        for more in ["", "MULTAX\nTLAXIS/0,0,1\nTLAXIS/PARLEL,2"] {
            let ran = along(&wall(high, -0.5), "10,1", more);
            assert!(ran.codes().is_empty(), "{high} {more} {:?}", ran.told);
            let [x, ..] = *ran.places.last().expect("the tool goes");
            assert!((x - 80.0).abs() < 1e-6, "{high} {more} {x}");
        }
    }
}

/// Where the wall leans over the tool, what goes on above it keeps an upright flank off: that is told, for the part is missed.
#[test]
fn an_upright_flank_that_meets_only_what_goes_on_above_the_wall_is_told() {
    for high in [30, 12] {
        let ran = along(&wall(high, 0.8), "10,1", "");
        assert_eq!(ran.codes(), ["APT2061", "APT2061"], "{high} {:?}", ran.told);
    }
}

/// What is left on a round wall is taken off it as from a cylinder.
#[test]
fn a_flank_goes_round_a_wall_that_something_is_left_on() {
    let wall = "LINE1=SCURV/SPLINE,(POINT/50,-28,-30),(POINT/50,-28,30)
BASE=POINT/50,0,0
UP=VECTOR/0,0,1
WALL=SSURF/REVOLV,LINE1,AXIS,BASE,UP,CCLW,0,360";
    for (left, cutter) in [(0.0, "10,2"), (0.3, "10,5"), (1.5, "10,2"), (4.0, "10,0")] {
        let text = format!(
            "UNITS/MM\n{wall}\nFLOOR=PLANE/0,0,1,0\nCUTTER/{cutter}\nINTOL/.01\nOUTTOL/.01\nTHICK/0,{left},0\n\
             FROM/50,-60,20\nINDIRV/0,1,0\nGO/TO,WALL,TO,FLOOR\nINDIRV/1,0,0\n\
             TLRGT,GOFWD/WALL,ON,(PLANE/0,1,0,0)\nFINI\n"
        );
        let ran = run::run(&text, Verify::Full);
        assert!(ran.codes().is_empty(), "{left} {cutter} {:?}", ran.told);
        let [x, y, _] = *ran.places.last().expect("the tool goes");
        let radius = 28.0 + 5.0 + left;
        assert!((x - 50.0 - radius).abs() <= 0.0101 && y.abs() < 1e-6, "{left} {cutter} {x} {y}");
    }
}

/// One patch is a surface as a mesh is: the band on its inner side counts as well.
#[test]
fn one_patch_is_proved_with_a_band_on_both_sides() {
    let row = |y: i32, z: [f64; 4]| {
        let points = [-60, -20, 20, 60].iter().zip(z).map(|(x, z)| format!("({x},{y},{z})"));
        points.collect::<Vec<_>>().join(",")
    };
    let rows = [
        row(-45, [0.3, -0.4, 0.2, -0.1]),
        row(-15, [-0.4, 0.1, 0.3, 0.4]),
        row(15, [0.1, -0.3, -0.2, 0.2]),
        row(45, [0.4, 0.3, -0.5, 0.1]),
    ];
    for cutter in ["8,4", "8,1", "8,0"] {
        let text = format!(
            "UNITS/MM\nPS=SSURF/PATCH,POLYGN,PLUS,$\n{}\nCUTTER/{cutter}\nINTOL/.01\nOUTTOL/.01\nFROM/-16,0,25\n\
             GO/ON,(PLANE/0,1,0,3),TO,PS,ON,(PLANE/1,0,0,-16)\nINDIRV/1,0,0\n\
             TLON,GOFWD/(PLANE/0,1,0,3),ON,(PLANE/1,0,0,18)\nFINI\n",
            rows.join(",$\n")
        );
        let ran = run::run(&text, Verify::Full);
        assert!(ran.codes().is_empty(), "{cutter} {:?}", ran.told);
    }
}

/// Where the ball gives way to the flank a chord beside a sphere is as deep as both let it be.
#[test]
fn a_chord_beside_a_sphere_goes_over_from_flank_to_ball() {
    for band in [0.02, 0.001, 0.0002] {
        let text = format!(
            "UNITS/MM\nPS=PLANE/-0.155146,0.114186,1,0\nDS=SPHERE/0,79.755,4.3,74.59\n\
             CS=PLANE/1,0.107628,-0.085325,18.681162\nST=PLANE/1,0,0,-12.484417\n\
             CUTTER/5.293,2.6465,0,2.6465,0,0,32.33\nTOLER/{band}\nFROM/-12.484417,-12,25\n\
             INDIRV/0,.5,-1\nGO/TO,DS,TO,PS,ON,ST\nINDIRV/1,0,0\nTLRGT,TLOFPS,GOFWD/DS,ON,CS\nFINI\n"
        );
        let ran = run::run(&text, Verify::Full);
        assert!(ran.codes().is_empty(), "{band} {:?}", ran.told);
    }
}
