//! Cylinders that are turned and tilted, given as QADRIC by their coefficients to some digits: what rounding leaves of the third
//! eigenvalue puts the middle of such a surface anywhere, and moves the surface by next to nothing where the part is.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;
use aptc_geometry::{Vec3, trig};

/// The `i`th place of a low discrepancy sequence for the program `k`.
fn share(k: u32, i: u32) -> f64 {
    (f64::from(k + 1) * 0.618_033_988_75 * f64::from(i)).fract()
}

/// A cylinder over a curve of second degree, with a ball or flat end on its way over it.
struct Over {
    /// Directions of the axis, and the highest ruling through `middle`.
    axis: Vec3,
    middle: Vec3,
    /// Program.
    text: String,
    /// Unit direction of the way and how far it goes.
    ahead: Vec3,
    to: f64,
}

/// Radius of round ones.
const RADIUS: f64 = 60.0;

/// `kind` 0 is round, 1 elliptic, 2 parabolic, 3 hyperbolic.
fn over(k: u32, kind: u32, digits: usize, cutter: &str) -> Over {
    let share = |i: u32| share(k, i);
    let (s, c) = trig::sin_cos(std::f64::consts::TAU * share(1));
    let tilt = 0.3 * share(2) - 0.15;
    let axis = Vec3::new(c, s, tilt).normalize();
    let across = Vec3::new(-s, c, 0.0);
    let up = axis.cross(&across);
    let middle = Vec3::new(80.0 * share(3) - 40.0, 80.0 * share(4) - 40.0, 20.0 * share(5));
    let (a, b) = match kind {
        0 => (RADIUS, RADIUS),
        _ => (40.0 + 60.0 * share(6), 40.0 + 60.0 * share(7)),
    };
    // x' M x + 2 p . x = 0 with the highest ruling through the origin.
    let outer = |e: Vec3| e * e.transpose();
    let (m, p) = match kind {
        0 | 1 => (outer(across) / (a * a) + outer(up) / (b * b), up / b),
        2 => (outer(across) / (2.0 * a), 0.5 * up),
        _ => (outer(up) / (b * b) - outer(across) / (a * a), up / b),
    };
    let q = p - m * middle;
    let d = middle.dot(&(m * middle)) - 2.0 * p.dot(&middle);
    let all = [
        m[(0, 0)],
        m[(1, 1)],
        m[(2, 2)],
        2.0 * m[(1, 2)],
        2.0 * m[(0, 2)],
        2.0 * m[(0, 1)],
        2.0 * q.x,
        2.0 * q.y,
        2.0 * q.z,
        d,
    ];
    let printed = |x: &f64| {
        let text = format!("{:.*e}", digits - 1, x);
        // APT wants a point before the exponent.
        format!(",$\n{}", if text.contains('.') { text } else { text.replace('e', ".e") })
    };
    let coefficients: String = all.iter().map(printed).collect();
    let (s, c) = trig::sin_cos(std::f64::consts::TAU * share(8));
    let (ahead, side) = (Vec3::new(c, s, 0.0), Vec3::new(-s, c, 0.0));
    let (begin, to) = (middle - ahead * 20.0, ahead.dot(&middle) + 20.0);
    let plane = |n: Vec3, d: f64| format!("PLANE/{:.12},{:.12},0,{d:.12}", n.x, n.y);
    let text = format!(
        "UNITS/MM\nPS=QADRIC/{}\nDS={}\nBEGIN={}\nEND={}\nCUTTER/{cutter}\nTOLER/.01\n\
         FROM/{:.9},{:.9},{:.9}\nINDIRV/0,0,-1\nGO/ON,DS,TO,PS,ON,BEGIN\nINDIRV/{:.12},{:.12},0\n\
         TLON,GOFWD/DS,ON,END\nFINI\n",
        coefficients.trim_start_matches(','),
        plane(side, side.dot(&middle)),
        plane(ahead, ahead.dot(&begin)),
        plane(ahead, to),
        begin.x,
        begin.y,
        middle.z + 15.0,
        ahead.x,
        ahead.y
    );
    Over { axis, middle: middle - up * RADIUS, text, ahead, to }
}

/// The middle of the ball goes along the cylinder that is wider by its radius.
#[test]
fn a_ball_goes_over_a_round_cylinder_that_was_printed() {
    for (digits, off) in [(6, 2e-3), (9, 1e-5), (12, 1e-6)] {
        for k in 0..16 {
            let case = over(k, 0, digits, "8,4");
            let ran = run::run(&case.text, Verify::Full);
            assert!(ran.told.is_empty(), "{digits} {k}: {:?}\n{}", ran.told, case.text);
            for p in &ran.places[1..] {
                let away = Vec3::from(*p) + Vec3::new(0.0, 0.0, 4.0) - case.middle;
                let far = away.cross(&case.axis).norm() - RADIUS - 4.0;
                assert!(far.abs() <= 0.01 + off, "{digits} {k}: {far}");
            }
        }
    }
}

#[test]
fn cylinders_that_were_printed_are_cut_to_their_end() {
    for kind in 1..4 {
        for (k, digits) in (0..24).zip([6, 7, 9, 12].into_iter().cycle()) {
            let cutter = ["8,4", "12,2", "10,0"][(k % 3) as usize];
            let case = over(k, kind, digits, cutter);
            let ran = run::run(&case.text, Verify::Full);
            assert!(ran.told.is_empty(), "{kind} {k}: {:?}\n{}", ran.told, case.text);
            let last = ran.places.last().map_or(Vec3::zeros(), |p| Vec3::from(*p));
            assert!((case.ahead.dot(&last) - case.to).abs() < 1e-6, "{kind} {k}: {last}");
        }
    }
}
