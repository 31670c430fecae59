//! Flanks along sculptured walls that are lower than the cutter is tall, that are round, or one patch alone: all of it is proved.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;
use aptc_geometry::trig;

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

/// Along a wall with waves of this length and two heights, phases and slowness along its height, by a cutter with this diameter and
/// corner, an axis that leans and a band on one side of it.
struct Waving {
    length: f64,
    heights: [f64; 2],
    phases: [f64; 2],
    slow: f64,
    cutter: [f64; 2],
    axis: &'static str,
    band: f64,
    left: bool,
}

impl Waving {
    fn program(&self) -> String {
        let &Self { length, heights, phases, slow, cutter, axis, band, left } = self;
        let step = (length / 0.6).round() / 10.0;
        let along = |x: f64| trig::sin(std::f64::consts::TAU * x / length + phases[0]);
        let row = |j: i32| {
            let z = f64::from(12 * j - 6);
            let up = heights[1] * trig::sin(z / slow + phases[1]);
            let point = |i: i32| {
                let x = step * f64::from(i - 5);
                format!("({x:.1},{:.3},{z})", heights[0] * along(x) + up)
            };
            format!("SPLINE,{}", (0..11).map(point).collect::<Vec<_>>().join(",$\n"))
        };
        let rows = (0..5).map(row).collect::<Vec<_>>().join(",$\n");
        let ([diameter, corner], x) = (cutter, 3.5 * step);
        let (far, side) = (diameter + 25.0, if left { "TLLFT" } else { "TLRGT" });
        let y = if left { far } else { -far };
        format!(
            "UNITS/MM\nWALL=SSURF/SMESH,XYZ,$\n{rows}\nFLOOR=PLANE/0,0,1,0\nFIRST=PLANE/1,0,0,-{x}\n\
             LAST=PLANE/1,0,0,{x}\nCUTTER/{diameter},{corner},{},{corner},0,0,30\nINTOL/0\nOUTTOL/{band}\n\
             MULTAX\nFROM/-{x},{y},3\nTLAXIS/{axis},1\nGO/TO,WALL,TO,FLOOR,ON,FIRST\nINDIRV/1,0,0\n\
             {side},GOFWD/WALL,ON,LAST\nFINI\n",
            0.5 * diameter - corner
        )
    }
}

/// Where the wall waves along its height the flank touches it at one height and then at another, which is seen before it cuts in there.
#[test]
fn a_flank_goes_over_from_one_height_of_a_wall_to_another() {
    let short = |heights, phases, slow, corner, axis, left| Waving {
        length: 10.2,
        heights,
        phases,
        slow,
        cutter: [6.0, corner],
        axis,
        band: 1e-4,
        left,
    };
    let long = |heights, phases, slow, axis| Waving {
        length: 27.2,
        heights,
        phases,
        slow,
        cutter: [16.0, 8.0],
        axis,
        band: 1e-3,
        left: false,
    };
    let all = [
        short([0.91, 0.2], [0.71, 4.05], 13.0, 3.0, "0.1,-0.07", false),
        short([0.88, 0.28], [3.58, 4.03], 9.0, 3.0, "-0.1,0", false),
        short([0.9, 0.34], [5.91, 3.7], 11.0, 0.0, "0.1,0.07", true),
        long([2.2, 1.38], [3.71, 4.33], 9.0, "-0.1,0"),
        long([2.61, 0.92], [4.34, 5.5], 11.0, "0,-0.07"),
    ];
    for (i, wall) in all.iter().enumerate() {
        let ran = run::run(&wall.program(), Verify::Full);
        assert!(ran.codes().is_empty(), "{i} {:?}", ran.told);
    }
}
