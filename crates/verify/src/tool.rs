//! The cutter in space.

use aptc_geometry::{Profile, Vec3, trig};

use crate::solid::{any_across, unit_or};

/// Tool end and unit tool axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pose {
    pub(crate) te: Vec3,
    pub(crate) ta: Vec3,
}

/// What is held against a surface: the cutter's solid, or the tool end alone (ON).
#[derive(Clone, Copy, Debug)]
pub(crate) enum Tool<'a> {
    Solid(&'a Profile),
    End,
}

/// The second derivatives of the distance from the tool at a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Change {
    /// The gradient, in which it is straight.
    m: Vec3,
    /// Unit direction around the axis.
    ring: Vec3,
    /// Along the outline of the tool and around its axis.
    across: f64,
    around: f64,
}

impl Change {
    /// The second derivative by two directions.
    pub(crate) fn along(&self, x: Vec3, y: Vec3) -> f64 {
        let all = x.dot(&y) - self.m.dot(&x) * self.m.dot(&y);
        self.across * all + (self.around - self.across) * self.ring.dot(&x) * self.ring.dot(&y)
    }

    /// The greater of both.
    pub(crate) fn sharpness(&self) -> f64 {
        self.across.abs().max(self.around.abs())
    }
}

impl Tool<'_> {
    /// The point of the tool farthest along `n`.
    pub(crate) fn farthest(&self, pose: &Pose, n: Vec3) -> Vec3 {
        let Self::Solid(profile) = self else { return pose.te };
        let up = n.dot(&pose.ta);
        let across = n - up * pose.ta;
        let out = across.norm();
        let length = n.norm();
        if length == 0.0 {
            return pose.te;
        }
        let [x, z] = profile.support(out / length, up / length).point;
        pose.te + x * radial(across, out, pose.ta) + z * pose.ta
    }

    /// Support function: greatest `n . p` over the tool.
    pub(crate) fn height(&self, pose: &Pose, n: Vec3) -> f64 {
        let base = n.dot(&pose.te);
        let Self::Solid(profile) = self else { return base };
        let up = n.dot(&pose.ta);
        let out = (n - up * pose.ta).norm();
        let length = n.norm();
        if length == 0.0 {
            return base;
        }
        base + length * profile.support(out / length, up / length).reach
    }

    /// Signed distance of `q` from the tool and its unit gradient.
    pub(crate) fn near(&self, pose: &Pose, q: Vec3) -> (f64, Vec3) {
        let w = q - pose.te;
        let Self::Solid(profile) = self else {
            return (w.norm(), unit_or(w, -pose.ta));
        };
        let z = w.dot(&pose.ta);
        let across = w - z * pose.ta;
        let far = across.norm();
        let near = profile.near(far, z);
        let [out, up] = near.normal;
        (near.distance, out * radial(across, far, pose.ta) + up * pose.ta)
    }

    /// The same with how the gradient changes.
    pub(crate) fn bent(&self, pose: &Pose, q: Vec3) -> (f64, Vec3, Change) {
        let w = q - pose.te;
        let Self::Solid(profile) = self else {
            let (far, m) = (w.norm(), unit_or(w, -pose.ta));
            let round = 1.0 / far;
            return (far, m, Change { m, ring: Vec3::zeros(), across: round, around: round });
        };
        let z = w.dot(&pose.ta);
        let across = w - z * pose.ta;
        let far = across.norm();
        let near = profile.near(far, z);
        let [out, up] = near.normal;
        let radial = radial(across, far, pose.ta);
        let m = out * radial + up * pose.ta;
        let around = if far > 0.0 { out / far } else { near.bend };
        let ring = pose.ta.cross(&radial);
        (near.distance, m, Change { m, ring, across: near.bend, around })
    }

    /// Greatest distance of a point of the tool from `c`, and the unit direction to it.
    pub(crate) fn farthest_from(&self, pose: &Pose, c: Vec3) -> (f64, Vec3) {
        let w = c - pose.te;
        let Self::Solid(profile) = self else { return (w.norm(), unit_or(-w, -pose.ta)) };
        let z = w.dot(&pose.ta);
        let across = w - z * pose.ta;
        let f = profile.farthest(across.norm(), z);
        let [out, up] = f.direction;
        (f.distance, up * pose.ta - out * unit_or(across, any_across(pose.ta)))
    }

    /// Greatest distance of a point of the tool from the ray that runs from `c` along the tool axis, and the
    /// unit direction to it.
    pub(crate) fn farthest_below(&self, pose: &Pose, c: Vec3) -> (f64, Vec3) {
        let w = c - pose.te;
        let z = w.dot(&pose.ta);
        let across = w - z * pose.ta;
        let Self::Solid(profile) = self else {
            let off = -across - z.max(0.0) * pose.ta;
            return (off.norm(), unit_or(off, -pose.ta));
        };
        let f = profile.farthest_below(across.norm(), z);
        let [out, up] = f.direction;
        (f.distance, up * pose.ta - out * unit_or(across, any_across(pose.ta)))
    }

    /// Has it no inside: the tool end alone, a disk, a cutter of no width?
    pub(crate) fn is_thin(&self) -> bool {
        match self {
            Self::Solid(p) => p.widest() <= 0.0 || p.height() <= p.bottom(),
            Self::End => true,
        }
    }

    /// A point well inside.
    pub(crate) fn inner(&self, pose: &Pose) -> Vec3 {
        match self {
            Self::Solid(p) => pose.te + pose.ta * (0.5 * (p.bottom() + p.height())),
            Self::End => pose.te,
        }
    }

    /// How far up its axis the middle of the tool is, and the radius of the sphere about it that holds the tool.
    pub(crate) fn middle(&self) -> (f64, f64) {
        match self {
            Self::Solid(p) => {
                let half = 0.5 * (p.height() - p.bottom());
                (0.5 * (p.bottom() + p.height()), trig::hypot(p.widest(), half))
            }
            Self::End => (0.0, 0.0),
        }
    }

    /// How far up its axis the middle of its corner is.
    pub(crate) fn shoulder(&self) -> f64 {
        match self {
            Self::Solid(profile) => profile.corner()[1],
            Self::End => 0.0,
        }
    }

    /// Greatest distance of a point of the tool from its axis.
    pub(crate) fn widest(&self) -> f64 {
        match self {
            Self::Solid(profile) => profile.widest(),
            Self::End => 0.0,
        }
    }

    /// Radius of the sphere about the tool end that holds the tool.
    pub(crate) fn reach(&self) -> f64 {
        match self {
            Self::Solid(profile) => profile.reach(),
            Self::End => 0.0,
        }
    }
}

/// Unit vector along `across` of length `n`, any square to the axis where it has none.
fn radial(across: Vec3, n: f64, ta: Vec3) -> Vec3 {
    if n > 0.0 { across / n } else { any_across(ta) }
}

/// Where a point fixed in the tool goes when the tool moves from one position to another, the axis by the
/// least rotation.
pub(crate) fn carry(from: &Pose, to: &Pose, p: Vec3) -> Vec3 {
    to.te + turned(from.ta, to.ta, p - from.te)
}

/// A vector turned by the least rotation that brings the unit vector `from` to `to`.
pub(crate) fn turned(from: Vec3, to: Vec3, x: Vec3) -> Vec3 {
    let (k, c) = (from.cross(&to), from.dot(&to));
    // Opposite axes have no least rotation; whoever asks divides the motion until this does not occur.
    if c <= -1.0 + 1e-9 {
        return x;
    }
    x * c + k.cross(&x) + k * (k.dot(&x) / (1.0 + c))
}
