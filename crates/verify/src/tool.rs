//! The cutter in space.

use aptc_cldata::Position;
use aptc_geometry::{Profile, Vec3, trig};

use crate::between::parabola;
use crate::solid::{any_across, unit_or};

/// Tool end and unit tool axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pose {
    pub(crate) te: Vec3,
    pub(crate) ta: Vec3,
}

impl Pose {
    #[inline]
    pub(crate) fn of(at: &Position) -> Self {
        Self { te: at.te, ta: at.ta }
    }
}

impl PartialEq for Pose {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        same(self.te, other.te) && same(self.ta, other.ta)
    }
}

/// Equality of vectors in three comparisons: that of the library goes through them by an iterator, ten times as long.
#[expect(clippy::float_cmp, reason = "the same numbers are meant")]
#[inline]
pub(crate) fn same(a: Vec3, b: Vec3) -> bool {
    a.x == b.x && a.y == b.y && a.z == b.z
}

/// What is held against a surface: the cutter's solid, or the tool end alone (ON).
#[derive(Clone, Copy, Debug)]
pub(crate) enum Tool<'a> {
    Solid(&'a Profile),
    /// A solid whose lower end stands so high above the tool end: shank or holder.
    Raised(&'a Profile, f64),
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

impl<'a> Tool<'a> {
    /// The solid and how high above the tool end it begins; `None` of the tool end alone.
    #[inline]
    pub(crate) fn solid(&self) -> Option<(&'a Profile, f64)> {
        match *self {
            Self::Solid(profile) => Some((profile, 0.0)),
            Self::Raised(profile, up) => Some((profile, up)),
            Self::End => None,
        }
    }

    /// The tool at the ends of a vector: one without size has no axis that could turn.
    #[inline]
    pub(crate) fn ends(&self, a: &Position, b: &Position) -> [Pose; 2] {
        let ta = if same(a.ta, b.ta) || self.reach() > 0.0 { b.ta } else { a.ta };
        [Pose::of(a), Pose { te: b.te, ta }]
    }

    /// The point of the tool farthest along `n`.
    pub(crate) fn farthest(&self, pose: &Pose, n: Vec3) -> Vec3 {
        let Some((profile, base)) = self.solid() else { return pose.te };
        let up = n.dot(&pose.ta);
        let across = n - up * pose.ta;
        let out = across.norm();
        let length = n.norm();
        if length == 0.0 {
            return pose.te;
        }
        let [x, z] = profile.support(out / length, up / length).point;
        pose.te + x * radial(across, out, pose.ta) + (z + base) * pose.ta
    }

    /// Support function: greatest `n . p` over the tool.
    #[inline]
    pub(crate) fn height(&self, pose: &Pose, n: Vec3) -> f64 {
        n.dot(&pose.te) + self.over(pose.ta, n)
    }

    /// The same from its tool end on, along the axis `ta`.
    #[inline]
    pub(crate) fn over(&self, ta: Vec3, n: Vec3) -> f64 {
        let Some((profile, lift)) = self.solid() else { return 0.0 };
        let up = n.dot(&ta);
        let (out, length) = ((n - up * ta).norm(), n.norm());
        if length == 0.0 {
            return 0.0;
        }
        lift * up + length * profile.support(out / length, up / length).reach
    }

    /// Greatest `n . p` at most over the tool on its way from one position to another, the axis turning evenly
    /// by `turn`, and what the turn makes of it.
    pub(crate) fn height_turning(
        &self,
        from: &Pose,
        to: &Pose,
        n: Vec3,
        turn: &Turn,
    ) -> (f64, f64) {
        self.height_about(from, to, n, turn, unit_or(from.ta.cross(&to.ta), Vec3::zeros()))
    }

    /// The same about the unit axis of the turn.
    pub(crate) fn height_about(
        &self,
        from: &Pose,
        to: &Pose,
        n: Vec3,
        turn: &Turn,
        k: Vec3,
    ) -> (f64, f64) {
        let across = n - k * n.dot(&k);
        let ends = [self.height(from, n), self.height(to, n)];
        let own = |pose: &Pose, n: Vec3, height: f64| height - n.dot(&pose.te);
        let apart = own(from, n, ends[0]) - own(to, n, ends[1]);
        let reach = |pose: &Pose| own(pose, across, self.height(pose, across));
        let rise = turn.rise(reach(from).max(reach(to)), apart.abs());
        (parabola(ends[0], ends[1], rise), rise)
    }

    /// How far the tool's ends are from its tool end, along the axis.
    pub(crate) fn tallest(&self) -> f64 {
        let tallest =
            |(p, up): (&Profile, f64)| (up + p.height()).abs().max((up + p.bottom()).abs());
        self.solid().map_or(0.0, tallest)
    }

    /// Signed distance of `q` from the tool and its unit gradient.
    pub(crate) fn near(&self, pose: &Pose, q: Vec3) -> (f64, Vec3) {
        let w = q - pose.te;
        let Some((profile, up)) = self.solid() else {
            return (w.norm(), unit_or(w, -pose.ta));
        };
        let z = w.dot(&pose.ta);
        let across = w - z * pose.ta;
        let far = across.norm();
        let near = profile.near(far, z - up);
        let [out, up] = near.normal;
        (near.distance, out * radial(across, far, pose.ta) + up * pose.ta)
    }

    /// The same with how the gradient changes.
    pub(crate) fn bent(&self, pose: &Pose, q: Vec3) -> (f64, Vec3, Change) {
        let w = q - pose.te;
        let Some((profile, up)) = self.solid() else {
            let (far, m) = (w.norm(), unit_or(w, -pose.ta));
            let round = 1.0 / far;
            return (far, m, Change { m, ring: Vec3::zeros(), across: round, around: round });
        };
        let z = w.dot(&pose.ta);
        let across = w - z * pose.ta;
        let far = across.norm();
        let near = profile.near(far, z - up);
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
        let Some((profile, up)) = self.solid() else {
            return (w.norm(), unit_or(-w, -pose.ta));
        };
        let z = w.dot(&pose.ta);
        let across = w - z * pose.ta;
        let f = profile.farthest(across.norm(), z - up);
        let [out, up] = f.direction;
        (f.distance, up * pose.ta - out * radial(across, across.norm(), pose.ta))
    }

    /// Greatest distance of a point of the tool from the ray that runs from `c` along the tool axis, and the
    /// unit direction to it.
    pub(crate) fn farthest_below(&self, pose: &Pose, c: Vec3) -> (f64, Vec3) {
        let w = c - pose.te;
        let z = w.dot(&pose.ta);
        let across = w - z * pose.ta;
        let Some((profile, up)) = self.solid() else {
            let off = -across - z.max(0.0) * pose.ta;
            return (off.norm(), unit_or(off, -pose.ta));
        };
        let f = profile.farthest_below(across.norm(), z - up);
        let [out, up] = f.direction;
        (f.distance, up * pose.ta - out * radial(across, across.norm(), pose.ta))
    }

    /// Has it no inside: the tool end alone, a disk, a cutter of no width?
    pub(crate) fn is_thin(&self) -> bool {
        self.solid().is_none_or(|(p, _)| p.widest() <= 0.0 || p.height() <= p.bottom())
    }

    /// A point well inside.
    pub(crate) fn inner(&self, pose: &Pose) -> Vec3 {
        pose.te + pose.ta * self.middle().0
    }

    /// How far up its axis the middle of the tool is, and the radius of the sphere about it that holds the tool.
    pub(crate) fn middle(&self) -> (f64, f64) {
        let Some((p, up)) = self.solid() else { return (0.0, 0.0) };
        let half = 0.5 * (p.height() - p.bottom());
        (up + 0.5 * (p.bottom() + p.height()), trig::hypot(p.widest(), half))
    }

    /// The radius of the ball that rolls about it inside, from its end up, and the height up to which all that is near is so;
    /// `None` of a tool with other edges than that of its top.
    pub(crate) fn rounding(&self) -> Option<(f64, f64)> {
        /// Share of the height up to which the edge of the top is far, and that the radius may have.
        const LOW: f64 = 0.5;
        const ROUND: f64 = 0.4;
        /// Greatest sine at which the sides lean outwards.
        const LEANING: f64 = 0.8;
        let (profile, up) = self.solid()?;
        let ([rho, high], radius) = (profile.corner(), profile.corner_radius());
        let [[low, bottom], [out, joint]] = profile.joints();
        let near = 1e-12 * profile.reach();
        // Down to its end or to a flat one, and without an edge to its sides.
        let off = [low - rho, bottom - profile.bottom(), high - radius - bottom];
        let level = off.into_iter().all(|x| x.abs() <= near);
        let [sin, cos] = [(out - rho) / radius, (high - joint) / radius];
        let height = profile.height();
        let side = sin * (profile.top_radius() - out) - cos * (height - joint);
        let tangent = side.abs() <= 1e3 * near && (-1e-12..=LEANING).contains(&cos);
        let round = radius > 0.0 && radius <= ROUND * height;
        (round && rho >= 0.0 && sin >= 0.0 && level && tangent)
            .then_some((radius, up + LOW * height))
    }

    /// How far up its axis the middle of its corner is.
    pub(crate) fn shoulder(&self) -> f64 {
        self.solid().map_or(0.0, |(profile, up)| up + profile.corner()[1])
    }

    /// Greatest distance of a point of the tool from its axis.
    pub(crate) fn widest(&self) -> f64 {
        self.solid().map_or(0.0, |(profile, _)| profile.widest())
    }

    /// Radius of the sphere about the tool end that holds the tool.
    pub(crate) fn reach(&self) -> f64 {
        self.solid().map_or(0.0, |(profile, up)| up.abs() + profile.reach())
    }
}

/// Unit vector along `across` of length `n`, square to the axis also where rounding is all that is left across it; any such
/// where that is nothing.
pub(crate) fn radial(across: Vec3, n: f64, ta: Vec3) -> Vec3 {
    /// Cosine to the axis up to which it is square to that.
    const SQUARE: f64 = 1e-12;
    /// Share of it that is to be left square to that.
    const LEFT: f64 = 0.1;
    if n > 0.0 {
        let out = across / n;
        let along = out.dot(&ta);
        if along.abs() <= SQUARE {
            return out;
        }
        if let Some(out) = (out - ta * along).try_normalize(LEFT) {
            return out;
        }
    }
    any_across(ta)
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

/// The angle by which an axis turns evenly, with what it makes of heights.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turn {
    pub(crate) angle: f64,
    /// Of `l - 1` and `s - t` below the greatest part of `4 t (1 - t)`.
    longer: f64,
    uneven: f64,
}

impl Turn {
    pub(crate) fn new(angle: f64) -> Self {
        let longer = 1.0 / trig::cos(0.5 * angle) - 1.0;
        let uneven = 0.25 * (angle / trig::sin(angle) - 1.0).max(0.0);
        let uneven = if angle > 0.0 { uneven } else { 0.0 };
        Self { angle, longer, uneven }
    }

    /// By how much the height h of a turning tool over its tool end along a direction n is more than evenly between its
    /// values at the ends, which are `apart`; at the share t of the way the part 4 t (1 - t) of it. `across` is the
    /// greater height along the part of n square to the axis k of the rotation.
    ///
    /// Seen from the tool that part turns evenly: `n(t) = (1 - s) n(0) + s n(1) + (l - 1) c` with c between its values at
    /// the ends, `l = cos((t - 1/2) turn) / cos(turn / 2)` and `s - 1/2 = tan((t - 1/2) turn) / (2 tan(turn / 2))`; h is
    /// convex and grows with the length of n. `l - 1 <= 4 t (1 - t) (1 / cos(turn / 2) - 1)`, for cos(sqrt) is convex, and
    /// `|s - t| <= t (1 - t) (turn / sin(turn) - 1)`, as the series of the tangent has no negative term.
    pub(crate) fn rise(&self, across: f64, apart: f64) -> f64 {
        if !(self.longer >= 0.0 && self.uneven.is_finite()) {
            return f64::INFINITY;
        }
        self.longer * across.max(0.0) + apart * self.uneven
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::Cutter;
    use proptest::prelude::*;

    /// Of a point that lies on the axis but for rounding the directions from and to the tool are of unit length and show what they are
    /// told to.
    #[test]
    fn beside_the_axis_by_rounding_directions_are_those_of_the_distance() {
        let profiles = [
            Profile::disk(3.0, 0.0),
            Profile::new(&Cutter::mill(10.0, 5.0, 80.0)),
            Profile::new(&Cutter::mill(10.0, 1.0, 80.0)),
        ];
        let ta = Vec3::new(0.123, -0.104, 0.987).normalize();
        for profile in profiles.map(Result::unwrap) {
            let tool = Tool::Solid(&profile);
            for k in 0..400 {
                let f = f64::from(k);
                let te = Vec3::new(-37.0 + 0.1 * f, 31.0, 3.9);
                let off = Vec3::new(trig::sin(f), trig::cos(2.0 * f), trig::sin(3.0 * f));
                let c =
                    te + ta * (2.9 * f - 300.0) + off * [0.0, 1e-15, 1e-13, 1e-10][k as usize % 4];
                let pose = Pose { te, ta };
                let ((far, m), (near, to)) = (tool.farthest_from(&pose, c), tool.near(&pose, c));
                let (below, down) = tool.farthest_below(&pose, c);
                for unit in [m, to, down] {
                    assert!((unit.norm() - 1.0).abs() < 1e-12, "{k} {unit:?}");
                }
                let over = |m: Vec3| tool.height(&pose, m) - m.dot(&c);
                assert!((over(m) - far).abs() < 1e-10, "{k} {far} {}", over(m));
                assert!(near < 0.0 || (over(to) + near).abs() < 1e-10, "{k} {near} {}", over(to));
                assert!(over(down) <= below + 1e-10, "{k} {below} {}", over(down));
            }
        }
    }

    proptest! {
        #[test]
        fn a_turning_tool_is_nowhere_higher_than_its_bound(
            n in prop::array::uniform3(-1.0..1.0_f64), v in prop::array::uniform3(-9.0..9.0_f64),
            lean in prop::array::uniform4(-1.5..1.5_f64), corner in 0.0..5.0_f64,
        ) {
            let profile = Profile::new(&Cutter::mill(10.0, corner, 80.0)).unwrap();
            let tool = Tool::Solid(&profile);
            let up = |x: f64, y: f64| Vec3::new(x, y, 1.0).normalize();
            let a = Pose { te: Vec3::zeros(), ta: up(lean[0], lean[1]) };
            let b = Pose { te: Vec3::from(v), ta: up(lean[2], lean[3]) };
            let (n, turn) = (Vec3::from(n), Turn::new(crate::between::angle(a.ta, b.ta)));
            let (most, _) = tool.height_turning(&a, &b, n, &turn);
            for i in 0..=40 {
                let at = crate::between::between_poses(&a, &b, f64::from(i) / 40.0);
                prop_assert!(tool.height(&at, n) <= most + 1e-9, "{i}");
            }
        }
    }
}
