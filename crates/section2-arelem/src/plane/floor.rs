//! The part surface of the plane routine: it gives the height of the tool end over each place.

use aptc_geometry::{Form, Plane, Tool, Vec3};

use super::frame::{Frame, Vec2};
use crate::scene::Wall;

/// Least sine between a part plane and the tool axis.
const STEEPEST: f64 = 1e-3;
/// Sine up to which a vector is level.
const LEVEL: f64 = 1e-12;

/// A plane on which the tool end lies, in the frame of the tool.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Floor {
    /// Unit normal of the part plane, on the side of the tool axis' tip.
    pub(crate) n: Vec3,
    /// `n . te` for a tool end in place.
    level: f64,
    /// +1 with the tool on the upper side, -1 below.
    pub(crate) side: f64,
}

/// Where the tool is to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Height {
    /// On the side that is nearer to having the cutter in place.
    AsItStands,
    /// Above unless the whole cutter is below.
    Near,
    /// Opposite to near.
    Far,
    /// Behind the direction from the TO side to the PAST side (SRFVCT).
    Behind(Vec3),
    /// Before it.
    Before(Vec3),
}

impl Floor {
    /// The plane of tool ends for a part surface; `None` when it is no plane across the axis.
    pub(crate) fn of(part: &Wall, frame: &Frame, te: Vec3, height: Height) -> Option<Self> {
        let plane = match part.surface.form.shape() {
            Form::Plane(p) => *p,
            Form::Line(l) => l.plane(),
            _ => return None,
        };
        let up = plane.n.dot(&frame.w);
        if up.abs() < STEEPEST {
            return None;
        }
        let Plane { n, d } = if up > 0.0 { plane } else { Plane { n: -plane.n, d: -plane.d } };
        if part.on {
            return Some(Self { n, level: d, side: 1.0 });
        }
        // The extreme points of the cutter, its end at the origin.
        let tool = Tool { profile: &part.profile, te: Vec3::zeros(), ta: frame.w };
        let above = d + part.thick + tool.support(-n).reach;
        let below = d - part.thick - tool.support(n).reach;
        let at = n.dot(&te);
        let up = match height {
            Height::AsItStands => (at - above).abs() <= (at - below).abs(),
            Height::Near => at > below,
            Height::Far => at <= below,
            // A level vector tells nothing of a level surface.
            Height::Behind(v) if n.dot(&v).abs() <= LEVEL * v.norm() => at > below,
            Height::Before(v) if n.dot(&v).abs() <= LEVEL * v.norm() => at <= below,
            Height::Behind(v) => n.dot(&v) < 0.0,
            Height::Before(v) => n.dot(&v) >= 0.0,
        };
        Some(if up {
            Self { n, level: above, side: 1.0 }
        } else {
            Self { n, level: below, side: -1.0 }
        })
    }

    /// How far the tool end is above its place.
    pub(crate) fn off(&self, te: Vec3) -> f64 {
        (self.n.dot(&te) - self.level) * self.side
    }

    /// Height of the tool end over a place.
    pub(crate) fn height(&self, frame: &Frame, q: Vec2) -> f64 {
        let flat = frame.space(q, 0.0);
        (self.level - self.n.dot(&flat)) / self.n.dot(&frame.w)
    }

    /// Is it square to the axis?
    pub(crate) fn is_level(&self, frame: &Frame) -> bool {
        frame.plan(self.n).norm() <= 1e-12
    }

    /// The direction in space of a direction in the plane.
    pub(crate) fn lift(&self, frame: &Frame, t: Vec2) -> Vec3 {
        let flat = frame.space(t, 0.0);
        (flat - frame.w * (self.n.dot(&flat) / self.n.dot(&frame.w))).normalize()
    }

    /// Side of the form's own normal on which the tool is.
    pub(crate) fn form_side(&self, part: &Wall) -> f64 {
        let own = match part.surface.form.shape() {
            Form::Plane(p) => p.n,
            Form::Line(l) => l.plane().n,
            _ => self.n,
        };
        self.side * own.dot(&self.n).signum()
    }
}
