//! Positions between two, the axis turning evenly, and what that makes of points and distances.

use aptc_geometry::{Vec3, trig};

use crate::tool::{Pose, same};

/// How far a point of the tool at distance `lever` from the tool end leaves the chord of its way at most, when
/// the axis turns by `turn`; at the share t of the way the part 4 t (1 - t) of it.
pub(crate) fn bulge(lever: f64, turn: f64) -> f64 {
    lever * turn * turn / 8.0
}

/// Greatest value of the line from `f0` to `f1` and a parabola over it of height `rise`.
pub(crate) fn parabola(f0: f64, f1: f64, rise: f64) -> f64 {
    let top = f0.max(f1);
    let difference = (f1 - f0).abs();
    if 4.0 * rise <= difference || !rise.is_finite() {
        return if rise.is_finite() { top } else { f64::INFINITY };
    }
    let lean = difference / (4.0 * rise);
    0.5 * (f0 + f1) + rise * (1.0 + lean * lean)
}

pub(crate) fn angle(a: Vec3, b: Vec3) -> f64 {
    if same(a, b) {
        return 0.0;
    }
    trig::angle_between(a, b)
}

/// Tool end on the straight line, tool axis turning evenly.
pub(crate) fn between_poses(a: &Pose, b: &Pose, t: f64) -> Pose {
    Way::new(*a, *b).at(t)
}

/// Angle between two axes that counts as none.
pub(crate) const NO_TURN: f64 = 1e-15;

/// Sine of the angle between two axes from which the axis turns evenly from one to the other.
const EVEN: f64 = 1e-9;

/// The way from one position to another.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Way {
    a: Pose,
    b: Pose,
    /// Angle between the axes, and its sine.
    pub(crate) turn: f64,
    sine: f64,
}

impl Way {
    pub(crate) fn new(a: Pose, b: Pose) -> Self {
        let turn = angle(a.ta, b.ta);
        let sine = if turn > NO_TURN { trig::sin(turn) } else { 0.0 };
        Self { a, b, turn, sine }
    }

    /// By how much the axis turns on a part of the way, so long a share of it.
    pub(crate) fn turn_between(&self, from: &Pose, to: &Pose, share: f64) -> f64 {
        // Between axes that are nearly opposite it does not turn evenly.
        if self.sine > EVEN { self.turn * share } else { angle(from.ta, to.ta) }
    }

    /// The position at a share of the way.
    pub(crate) fn at(&self, t: f64) -> Pose {
        let Self { a, b, turn, sine } = self;
        if t >= 1.0 {
            return *b;
        }
        let te = a.te + t * (b.te - a.te);
        if t <= 0.0 || *turn <= NO_TURN {
            return Pose { te, ta: a.ta };
        }
        let ta = if *sine > EVEN {
            (a.ta * trig::sin((1.0 - t) * turn) + b.ta * trig::sin(t * turn)) / *sine
        } else {
            a.ta + t * (b.ta - a.ta)
        };
        Pose { te, ta: ta.normalize() }
    }
}
