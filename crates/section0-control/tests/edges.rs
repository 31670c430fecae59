//! Sculptured surfaces with edges: check surfaces that are touched on one, and motion over them and round them.

#[path = "support/run.rs"]
mod run;

use aptc_control::{ClFile, Disk, Options, Source, Verify, verify};

const HEAD: &str = "PARTNO EDGES
UNITS/MM
INTOL/.02
OUTTOL/.02
F=PLANE/0,0,1,0
";

/// An upright ridge towards the tool, at x = 50 and y = 25.
const RIDGE: &str = "K=SSURF/SMESH,RULED,SPLINE,(60,-10,-5),(60,-10,45),$
 SPLINE,(50,25,-5),(50,25,45),SPLINE,(60,60,-5),(60,60,45)
";
/// A lying cone with its tip at x = 50.
const CONE: &str = "A=SCURV/CURSEG,(50,0,0),(80,0,15)
K=SSURF/REVOLV,A,AXIS,(POINT/0,0,0),(VECTOR/1,0,0),$
 CCLW,0,360,TRFORM,(MATRIX/TRANSL,0,25,3)
";
/// A ball of 3 of two arcs that meet at its equator, by rounded numbers.
const BALL: &str = "P1=SCURV/CURSEG,(POINT/0,0,3),$
 (POINT/2.12132,0,2.12132),(POINT/3,0,0)
P2=SCURV/CURSEG,(POINT/3,0,0),$
 (POINT/2.12132,0,-2.12132),(POINT/0,0,-3)
PR=SCURV/COMBIN,P1,P2
K=SSURF/REVOLV,PR,AXIS,(POINT/0,0,0),(VECTOR/0,0,1),$
 CCLW,0,360,TRFORM,(MATRIX/TRANSL,70,25,3)
";

/// A ball comes obliquely over a ridge of two planes, and over one that bends: it rolls over the edge, along which its contact goes
/// far between two places of the path.
#[test]
fn a_ball_goes_obliquely_over_a_ridge() {
    let rows = |high: f64, bends: f64| {
        let row =
            |y: i32, z: f64| format!("SPLINE,(-60,{y},{z}),(0,{y},{}),(60,{y},{z})", z + bends);
        format!("SSURF/SMESH,RULED,{},$\n{},$\n{}", row(-50, 0.0), row(0, high), row(50, 0.0))
    };
    for (high, bends) in [(4.0, 0.0), (15.0, 0.0), (30.0, 0.0), (4.0, 1.0)] {
        for slope in [0.1, 0.5, 1.3] {
            for cutter in ["8,4", "12,6"] {
                let text = format!(
                    "PARTNO RIDGE\nUNITS/MM\nK={}\nD=PLANE/{slope},1,0,0\nCUTTER/{cutter}\nINTOL/.01\nOUTTOL/.01\n\
                     FROM/-20,0,60\nGO/ON,D,TO,K,ON,(PLANE/1,0,0,-20)\nINDIRV/1,0,0\n\
                     TLON,GOFWD/D,ON,(PLANE/1,0,0,20)\nFINI\n",
                    rows(high, bends)
                );
                let ran = run::run(&text, Verify::Full);
                assert_eq!(ran.faults(), Vec::<String>::new(), "{text}");
                assert!(ran.places.len() < 30, "{} {text}", ran.places.len());
            }
        }
    }
}

/// A tool that is led along y towards the check surface, with another far behind it, and where it stops.
fn stop(cutter: &str, check: &str, y: f64, relation: &str) -> [f64; 3] {
    let text = format!(
        "{HEAD}{check}CUTTER/{cutter}
W=PLANE/0,1,0,{y}
FROM/5,20,50
GO/ON,W,TO,F,ON,(PLANE/1,0,0,10)
INDIRV/1,0,0
TLON,GOFWD/W,{relation},K,A1,TO,(PLANE/1,0,0,190),A2
A1) CONTIN
A2) CONTIN
END
FINI
"
    );
    let ran = run::run(&text, Verify::Full);
    assert_eq!(ran.faults(), Vec::<String>::new(), "{cutter} {y} {check}");
    ran.places[ran.places.len() - 1]
}

#[test]
fn a_check_surface_is_touched_on_an_edge() {
    for cutter in ["10", "10,2", "10,5"] {
        let [x, ..] = stop(cutter, RIDGE, 25.0, "TO");
        assert!((x - 45.0).abs() < 0.03, "{cutter} {x}");
    }
    // Beside the ridge too, as long as the circle of the cutter meets it before the faces.
    let [x, ..] = stop("20", RIDGE, 27.0, "TO");
    assert!((x - (50.0 - 96.0_f64.sqrt())).abs() < 0.03, "{x}");
    let [x, ..] = stop("10", RIDGE, 25.0, "ON");
    assert!((x - 50.0).abs() < 0.03, "{x}");
}

#[test]
fn a_check_surface_is_touched_on_a_tip() {
    let [x, ..] = stop("10", CONE, 25.0, "TO");
    assert!((x - 45.0).abs() < 0.03, "{x}");
}

#[test]
fn a_check_surface_is_touched_on_a_joint_that_is_none() {
    for y in [22.0, 25.0, 28.5] {
        let [x, ..] = stop("10", BALL, y, "TO");
        let beside = 70.0 - (64.0 - (y - 25.0) * (y - 25.0)).sqrt();
        assert!((x - beside).abs() < 0.03, "{y} {x} {beside}");
    }
}

/// Where the track ends to bend a cut vector goes much farther than the track is long: a plane on it is met all the same.
#[test]
fn a_plane_behind_the_end_of_an_arc_is_not_passed() {
    for at in [22.0, 30.0, 33.0, 34.7, 35.0, 35.5, 36.1, 40.0, 47.0] {
        let text = format!(
            "{HEAD}CUTTER/10
A1=SCURV/CURSEG,(POINT/0,-10,-2),$
 (POINT/5.857864,4.142136,-2),(POINT/20,10,-2)
L2=SCURV/SPLINE,(POINT/20,10,-2),(POINT/50,10,-2)
C=SCURV/COMBIN,A1,L2
D=SSURF/RULED,C,AXIS,(VECTOR/0,0,40)
FROM/16,-25,50
INDIRV/0,1,0
GO/TO,D,TO,F,ON,(PLANE/1,0,0,11)
INDIRV/1,0,0
TLRGT,GOFWD/D,ON,(PLANE/1,0,0,{at}),B1,ON,(PLANE/1,0,0,60),B2
B1) CONTIN
B2) CONTIN
END
FINI
"
        );
        let ran = run::run(&text, Verify::Full);
        assert_eq!(ran.faults(), Vec::<String>::new(), "{at}");
        let [x, ..] = ran.places[ran.places.len() - 1];
        assert!((x - at).abs() < 1e-6, "{at} {x}");
    }
}

/// Over a ridge and round a corner, with a thickness too; it is kept round the edge as beside the faces.
#[test]
fn a_tool_goes_over_an_edge_and_round_it() {
    let roof = "R0=SCURV/SPLINE,(0,0,2),(0,60,2)
R1=SCURV/SPLINE,(30,0,10),(30,60,10)
R2=SCURV/SPLINE,(60,0,4),(60,60,4)
G1=SSURF/RULED,R0,R1
G2=SSURF/RULED,R1,R2
R=SSURF/COMBIN,G1,G2
";
    for (cutter, thick) in [("10,5", 0.0), ("10", 0.0), ("12,2", 0.0), ("10,5", 1.5)] {
        let text = format!(
            "{HEAD}{roof}CUTTER/{cutter}
THICK/{thick}
D=PLANE/0,1,0,30
FROM/2,30,90
GO/ON,D,TO,R,ON,(PLANE/1,0,0,8)
INDIRV/1,0,0
TLON,GOFWD/D,ON,(PLANE/1,0,0,52)
END
FINI
"
        );
        let ran = run::run(&text, Verify::Full);
        assert_eq!(ran.faults(), Vec::<String>::new(), "{cutter} {thick}");
        let high = ran.places.iter().skip(1).map(|p| p[2]).fold(0.0, f64::max);
        let top = 10.0 + thick;
        assert!(high > top - 0.1 && high < top + 0.1, "{cutter} {thick} {high}");
    }
    let text = format!(
        "{HEAD}{RIDGE}CUTTER/10
THICK/0,2
FROM/30,5,50
INDIRV/1,0,0
GO/TO,K,TO,F,ON,(PLANE/0,1,0,5)
INDIRV/0,1,0
TLRGT,GOFWD/K,ON,(PLANE/0,1,0,45)
END
FINI
"
    );
    let ran = run::run(&text, Verify::Full);
    assert!(ran.faults().iter().all(|code| code == "APT2005"), "{:?}", ran.told);
    let beside = |p: &[f64; 3]| aptc_geometry::trig::hypot(p[0] - 50.0, p[1] - 25.0);
    let least = ran.places.windows(2).flat_map(|w| {
        let [a, b] = [w[0], w[1]];
        (0..=50).map(move |i| core::array::from_fn(|k| a[k] + (b[k] - a[k]) * f64::from(i) / 50.0))
    });
    let least = least.map(|p: [f64; 3]| beside(&p)).fold(f64::INFINITY, f64::min);
    assert!(least > 6.979 && least < 7.021, "{least}");
}

/// What the proof says of a CL file against a program: codes.
fn judged(program: &str, cl: &str) -> Vec<String> {
    let source = Source { name: "part".into(), text: program.into() };
    let file = ClFile { name: "path.cl".into(), bytes: cl.as_bytes().to_vec() };
    let options = Options { verify: Verify::Full, post: false, ..Options::default() };
    let judged = verify(source, &mut Disk::new(Vec::new(), 0), &options, Some(file));
    let codes = judged.diagnostics.iter().map(|d| d.code.to_string());
    codes.filter(|c| c.starts_with("APT5")).collect()
}

/// A sharp tool below the bottom of a groove, by more than INTOL and by less: the two faces moved back part there.
#[test]
fn a_tool_does_not_pass_between_the_faces_of_a_groove() {
    let program = format!(
        "{HEAD}R=SSURF/SMESH,RULED,SPLINE,(0,0,30),(60,0,30),$
 SPLINE,(0,30,0),(60,30,0),SPLINE,(0,60,30),(60,60,30)
CUTTER/10,0,0,0,70,0,60
D=PLANE/0,1,0,30
FROM/2,30,90
GO/ON,D,TO,R,ON,(PLANE/1,0,0,8)
INDIRV/1,0,0
TLON,GOFWD/D,ON,(PLANE/1,0,0,52)
END
FINI
"
    );
    for (z, right) in [(-0.015, true), (-0.021, false), (-0.05, false), (-0.5, false)] {
        let cl = format!(
            "PARTNO EDGES\nUNITS/MM\nCUTTER/10,0,0,0,70,0,60\nFROM/2,30,90\nGOTO/8,30,{z}\nGOTO/52,30,{z}\nFINI\n"
        );
        let codes = judged(&program, &cl);
        assert_eq!(codes.is_empty(), right, "{z}: {codes:?}");
        assert!(right || codes.contains(&"APT5001".to_owned()), "{z}: {codes:?}");
    }
}

/// A path that goes past one check surface and stops at another.
#[test]
fn the_proof_holds_a_path_to_all_check_surfaces() {
    let program = format!(
        "{HEAD}{RIDGE}CUTTER/10
W=PLANE/0,1,0,25
FROM/5,20,50
GO/ON,W,TO,F,ON,(PLANE/1,0,0,10)
INDIRV/1,0,0
TLON,GOFWD/W,TO,K,A1,TO,(PLANE/1,0,0,190),A2
A1) CONTIN
A2) CONTIN
END
FINI
"
    );
    for (x, right) in [(45.0, true), (46.0, false), (185.0, false)] {
        let cl = format!(
            "PARTNO EDGES\nUNITS/MM\nCUTTER/10\nFROM/5,20,50\nGOTO/10,25,0\nGOTO/{x},25,0\nFINI\n"
        );
        assert_eq!(judged(&program, &cl).is_empty(), right, "{x}: {:?}", judged(&program, &cl));
    }
}
