//! POLCON with a thickness and a matrix: its sections are quarter circles about the x axis of its own system, and the tool is where
//! the cylinder about that axis has it. The thickness counts to the side of the product of section and length, here outwards; the
//! matrix leads from the part into the system of the curves.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

const RADIUS: f64 = 10.0;
const BALL: f64 = 3.0;

/// Where the system of the curves stands in the part: turned a quarter about z, and turned over if mirrored.
#[derive(Clone, Copy, Debug)]
struct Placed {
    origin: [f64; 3],
    side: f64,
}

impl Placed {
    /// A point of the curves in the part.
    fn point(self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [a, b, c] = self.origin;
        [a - self.side * y, b + x, c + z]
    }

    /// The elements 2 to 13.
    fn matrix(self) -> [f64; 12] {
        let ([a, b, c], s) = (self.origin, self.side);
        [0.0, 1.0, 0.0, -b, -s, 0.0, 0.0, s * a, 0.0, 0.0, 1.0, -c]
    }
}

fn polyconic(thickness: f64, placed: Option<Placed>) -> String {
    let w = std::f64::consts::FRAC_1_SQRT_2;
    let mut e = [0.0; 79];
    e[0] = 1.0;
    if let Some(placed) = placed {
        e[1..13].copy_from_slice(&placed.matrix());
    }
    (e[13], e[15]) = (thickness, 40.0);
    // A and D, C and B, L: from (r, 0) by (r, r) to (0, r).
    (e[16], e[24], e[48], e[64]) = (-RADIUS, RADIUS, RADIUS, 0.5 + 0.5 * w / (1.0 + w));
    let elements: String = e.iter().map(|x| format!(",$\n{x:.10}")).collect();
    format!("ROUND=POLCON/CANON{elements}")
}

fn all() -> impl Iterator<Item = (f64, Option<Placed>)> {
    let turned = |side| Some(Placed { origin: [5.0, -60.0, 7.0], side });
    let places = [None, turned(1.0), turned(-1.0)];
    places.into_iter().flat_map(|p| [0.0, 2.0, -2.0].map(|t| (t, p)))
}

fn list([x, y, z]: [f64; 3]) -> String {
    format!("{x:.6},{y:.6},{z:.6}")
}

/// The plane through a point of the curves square to an axis of theirs.
fn plane(placed: Option<Placed>, at: [f64; 3], axis: usize) -> String {
    let there = |p: [f64; 3]| placed.map_or(p, |m| m.point(p));
    let mut beside = at;
    beside[axis] += 1.0;
    let (p, q) = (there(at), there(beside));
    let n = [0, 1, 2].map(|i| q[i] - p[i]);
    let d: f64 = (0..3).map(|i| n[i] * p[i]).sum();
    format!("PLANE/{},{d:.6}", list(n))
}

/// The last place in the system of the curves, the messages.
fn end(text: &str, placed: Option<Placed>) -> [f64; 3] {
    let ran = run::run(text, Verify::Full);
    assert!(ran.codes().is_empty(), "{:?} {text}", ran.told);
    let p = *ran.places.last().expect("the tool goes");
    let Some(m) = placed else { return p };
    [p[1] - m.origin[1], m.side * (m.origin[0] - p[0]), p[2] - m.origin[2]]
}

#[test]
fn a_ball_goes_over_the_working_surface() {
    for (thickness, placed) in all() {
        let there = |p: [f64; 3]| list(placed.map_or(p, |m| m.point(p)));
        let to = |x: f64, y: f64| format!("{},{}", x, y);
        let way = placed.map_or_else(|| to(0.0, -1.0), |m| to(m.side, 0.0));
        let text = format!(
            "UNITS/MM\n{}\nWAY={}\nEND={}\nINTOL/.001\nOUTTOL/.001\nCUTTER/{},{BALL}\nFROM/{}\n\
             INDIRV/0,0,-1\nGO/ON,WAY,TO,ROUND\nINDIRV/{way},0\nTLON,GOFWD/WAY,ON,END\nFINI\n",
            polyconic(thickness, placed),
            plane(placed, [20.0, 0.0, 0.0], 0),
            plane(placed, [0.0, 3.0, 0.0], 1),
            2.0 * BALL,
            there([20.0, 8.0, 15.0]),
        );
        let p = end(&text, placed);
        let reach = RADIUS + thickness + BALL;
        let gap = (p[1] * p[1] + (p[2] + BALL) * (p[2] + BALL)).sqrt() - reach;
        assert!((p[0] - 20.0).abs() < 1e-6 && (p[1] - 3.0).abs() < 1e-6, "{p:?} {text}");
        assert!(gap.abs() <= 0.001, "{gap} {text}");
    }
}

#[test]
fn the_working_surface_stops_the_tool() {
    for (thickness, placed) in all() {
        let there = |p: [f64; 3]| list(placed.map_or(p, |m| m.point(p)));
        let way = placed.map_or_else(|| "0,-1".to_owned(), |m| format!("{},0", m.side));
        let outside = RADIUS + thickness;
        // The side of a cylinder of radius 2 that stands at z = 5 touches a lying one with the edge of its bottom.
        let at = (outside * outside - 25.0).sqrt();
        for (word, y) in [("TO", at + 2.0), ("ON", at)] {
            let text = format!(
                "UNITS/MM\n{}\nWAY={}\nFLOOR={}\nINTOL/.001\nOUTTOL/.001\nCUTTER/4\nFROM/{}\n\
                 GO/ON,WAY,TO,FLOOR\nINDIRV/{way},0\nTLON,GOFWD/WAY,{word},ROUND\nFINI\n",
                polyconic(thickness, placed),
                plane(placed, [20.0, 0.0, 0.0], 0),
                plane(placed, [0.0, 0.0, 5.0], 2),
                there([20.0, 30.0, 9.0]),
            );
            let p = end(&text, placed);
            assert!((p[1] - y).abs() <= 0.003, "{p:?} {y} {text}");
        }
    }
}
