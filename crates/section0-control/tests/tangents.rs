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
