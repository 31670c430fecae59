//! The convex side of a quadric: its support function, and the place of it that is next to a tool outside.

use aptc_geometry::surface::QuadricSurface;
use aptc_geometry::{Vec3, trig};

use crate::sheet::SLACK;
use crate::solid::{Supported, any_across, square_to_both, unit_or, without};
use crate::tool::{Pose, Tool};

/// Largest sine by which a direction may miss the bounded ones and still count as rounding.
const ROUNDING: f64 = 1e-12;

/// The convex side of an ellipsoid, elliptic cylinder, paraboloid or parabolic cylinder.
#[derive(Clone, Debug)]
pub(crate) struct Oval {
    axes: [Axis; 3],
    /// The unit direction in which the form is linear and half its slope there; towards its opposite the solid has no end.
    linear: Option<(Vec3, f64)>,
    /// By how much the form falls below zero in the middle; with a linear part, where that vanishes.
    depth: f64,
    /// No radius of curvature is less.
    roundest: f64,
}

/// A principal direction of the form.
#[derive(Clone, Copy, Debug)]
struct Axis {
    e: Vec3,
    /// How much the form bends along it, and 1 over that; both 0 where it does not.
    bend: f64,
    wide: f64,
    /// Where its middle is.
    middle: f64,
}

/// The place of an oval next to a tool.
pub(crate) struct Nearest {
    /// The gap from above, and its value where the place was found.
    pub(crate) gap: f64,
    /// The place, the normal there, and the point of the tool next to it.
    pub(crate) x: Vec3,
    pub(crate) n: Vec3,
    pub(crate) p: Vec3,
}

impl Oval {
    /// Of the negative side of a quadric; `None` when that is not convex.
    pub(crate) fn new(quadric: &QuadricSurface) -> Option<Self> {
        if quadric.convexity() != 1 {
            return None;
        }
        let (axes, lambda, beta, constant) = quadric.principal();
        let (mut slope, mut depth) = (Vec3::zeros(), -constant);
        let (mut most, mut least) = (0.0_f64, f64::INFINITY);
        let axes = [0, 1, 2].map(|i| {
            let (e, bend) = (axes[i], lambda[i]);
            if bend <= 0.0 {
                slope += e * beta[i];
                return Axis { e, bend: 0.0, wide: 0.0, middle: 0.0 };
            }
            depth += beta[i] * beta[i] / bend;
            (most, least) = (most.max(bend), least.min(bend));
            Axis { e, bend, wide: 1.0 / bend, middle: -beta[i] / bend }
        });
        let size = slope.norm();
        let linear = (size > 0.0).then(|| (slope / size, size));
        // The normal curvature is the form's over the length of half its gradient.
        let gradient = if size > 0.0 { size } else { (least * depth.max(0.0)).sqrt() };
        Some(Self { axes, linear, depth, roundest: gradient / most })
    }

    /// Does it hardly bend along an axis, so that its middle is far off and what is told from there is lost in rounding?
    pub(crate) fn is_slack(&self) -> bool {
        let bends = || self.axes.iter().map(|a| a.bend).filter(|bend| *bend > 0.0);
        bends().fold(f64::INFINITY, f64::min) < SLACK * bends().fold(0.0, f64::max)
    }

    /// No radius of curvature is less: a ball of that radius within it touches it anywhere.
    pub(crate) fn roundest(&self) -> f64 {
        self.roundest
    }

    /// Does it run on for ever in the unit direction `d`?
    pub(crate) fn is_endless(&self, d: Vec3) -> bool {
        let bent: f64 = self.round().map(|a| d.dot(&a.e).abs()).sum();
        bent <= ROUNDING && self.straight().is_none_or(|t| d.dot(&t) <= ROUNDING)
    }

    /// Half the gradient of the form.
    pub(crate) fn slope(&self, p: Vec3) -> Vec3 {
        let along = |a: &Axis| a.e * (a.bend * (p.dot(&a.e) - a.middle));
        let [x, y, z] = &self.axes;
        let round = along(x) + along(y) + along(z);
        self.linear.map_or(round, |(t, slope)| round + t * slope)
    }

    /// The directions in which it bends, then that in which it is linear.
    pub(crate) fn frame(&self) -> impl Iterator<Item = Vec3> {
        self.round().map(|a| a.e).chain(self.straight())
    }

    /// The direction in which it is linear, away from where it has no end.
    pub(crate) fn straight(&self) -> Option<Vec3> {
        self.linear.map(|l| l.0)
    }

    /// Of a cylinder the direction in which it runs straight for ever.
    fn generator(&self) -> Option<Vec3> {
        let mut frame = self.frame();
        let [a, b, c] = [frame.next()?, frame.next()?, frame.next().unwrap_or_else(Vec3::zeros)];
        (c == Vec3::zeros()).then(|| a.cross(&b))
    }

    /// The point that is farthest along `m`; `None` where it has no end that way.
    pub(crate) fn touching(&self, m: Vec3) -> Option<Vec3> {
        let (up, squares) = self.parts(m)?;
        let scale = if self.linear.is_some() { 1.0 / up } else { (self.depth / squares).sqrt() };
        let at = |a: &Axis| a.e * (a.middle + scale * m.dot(&a.e) * a.wide);
        let [x, y, z] = &self.axes;
        let mut point = at(x) + at(y) + at(z);
        if let Some((t, slope)) = self.linear {
            // The form without its linear part, which that makes up for.
            let value = scale * scale * squares - self.depth;
            point -= t * (0.5 * value / slope);
        }
        point.iter().all(|x| x.is_finite()).then_some(point)
    }

    /// The place next to a tool outside, looked for from where the normal is `near`: the distance from the tool is convex
    /// over the oval, and has its least where its gradient lies along the normal. Newton's method, which goes down. Of a tool
    /// end inside of it a place where the distance is least beside others. `None` where the oval has no place at all.
    pub(crate) fn next_to(
        &self,
        tool: &Tool<'_>,
        pose: &Pose,
        near: Option<Vec3>,
    ) -> Option<Nearest> {
        /// Rounds; three are usual.
        const ROUNDS: u32 = 60;
        /// Sine by which the way to the tool may miss the normal, which takes its square, or itself beside a flat of the
        /// tool; and what counts as none.
        const LEVEL: f64 = 1e-8;
        const NONE: f64 = 1e-12;
        /// Share of the size that distances are rounded by.
        const ALIKE: f64 = 1e-14;
        // Of a cylinder at the height of `at`.
        let generator = self.generator();
        let place = |n: Vec3, at: Vec3| {
            let x = self.touching(self.bounded_direction(n))?;
            Some(generator.map_or(x, |g| x + g * g.dot(&(at - x))))
        };
        let middle = pose.te + pose.ta * tool.shoulder();
        let first = near.unwrap_or_else(|| self.slope(middle));
        let mut best = self.look(tool, pose, place(first, middle)?);
        let mut share = 1.0;
        for _ in 0..ROUNDS {
            if best.off <= NONE || best.off <= LEVEL && share < 1.0 {
                break;
            }
            let to = best.x + best.step * share;
            let Some(x) = place(self.slope(to), to) else { break };
            let seen = self.look(tool, pose, x);
            let alike = seen.far <= best.far + ALIKE * (best.far + x.norm() + pose.te.norm());
            if seen.far < best.far || alike && seen.off < 0.5 * best.off {
                (best, share) = (seen, 1.0);
            } else {
                share *= 0.5;
            }
        }
        // Deeper than the oval is round another place may be nearer.
        let found = best.off <= LEVEL && best.gap >= -self.roundest;
        // No point of the oval is farther from the tool than the distance to it.
        let gap = if found { best.gap } else { best.far.max(0.0) };
        Some(Nearest { gap, x: best.x, n: best.n, p: best.p })
    }

    /// How far inside it is looked at: the point next to the tool there lies below that of its own, and the bends differ by as
    /// small a share.
    fn little(&self) -> f64 {
        0.01 * self.roundest
    }

    /// Twice the part of `m` along which it is linear, over its slope; and the squares of the others over their bends.
    fn parts(&self, m: Vec3) -> Option<(f64, f64)> {
        let mut rest = Vec3::zeros();
        let mut squares = 0.0;
        for a in &self.axes {
            let part = m.dot(&a.e);
            squares += part * part * a.wide;
            if a.bend == 0.0 {
                rest += a.e * part;
            }
        }
        let Some((t, slope)) = self.linear else {
            return (rest.norm() <= ROUNDING * m.norm()).then_some((0.0, squares));
        };
        let up = rest.dot(&t);
        let bounded = up > 0.0 && (rest - t * up).norm() <= ROUNDING * m.norm();
        bounded.then_some((up / slope, squares))
    }

    fn round(&self) -> impl Iterator<Item = &Axis> {
        self.axes.iter().filter(|a| a.bend > 0.0)
    }

    /// What the tool is from a place of the oval.
    fn look(&self, tool: &Tool<'_>, pose: &Pose, x: Vec3) -> Look {
        let slope = self.slope(x);
        let size = slope.norm();
        let n = slope / size;
        let a = any_across(n);
        let b = n.cross(&a);
        let mut bends = [0.0; 3];
        for axis in &self.axes {
            let [u, v] = [a.dot(&axis.e), b.dot(&axis.e)];
            for (sum, part) in bends.iter_mut().zip([u * u, u * v, v * v]) {
                *sum += part * axis.bend / size;
            }
        }
        // What the distance falls by along both, and its second derivatives there; of a tool end both times itself. Then the
        // length of what falls as an angle.
        let (far, gap, p, fall, change, size) = if tool.solid().is_none() {
            let w = pose.te - x;
            let gap = w.dot(&n);
            // On the far side it falls too.
            let g = gap.max(-0.5 * self.roundest);
            let change = [1.0 + g * bends[0], g * bends[1], 1.0 + g * bends[2]];
            let far = w.norm();
            (far, gap, pose.te, [w.dot(&a), w.dot(&b)], change, far + self.roundest)
        } else {
            // A little inside of the oval, where the distance has no edges yet.
            let x = x - n * self.little();
            let (d, g, change) = tool.bent(pose, x);
            let own = [change.along(a, a), change.along(a, b), change.along(b, b)];
            let sum = [0, 1, 2].map(|i| own[i] + bends[i]);
            let fall = [-g.dot(&a), -g.dot(&b)];
            (d, d - self.little(), x - g * d, fall, sum, 1.0)
        };
        // Along a straight line of both nothing is to be gained: no step is longer than what there is.
        let [aa, ab, bb] = change;
        let down = trig::hypot(fall[0], fall[1]);
        let little =
            1e-12 * (aa.abs() + bb.abs()) + down / (tool.reach() + far.abs() + self.roundest);
        let (aa, bb) = (aa + little, bb + little);
        let det = aa * bb - ab * ab;
        let [u, v] = [(fall[0] * bb - fall[1] * ab) / det, (fall[1] * aa - fall[0] * ab) / det];
        let off = down / size;
        Look { x, n, p, far, gap, off, step: a * u + b * v }
    }
}

impl Supported for Oval {
    fn support(&self, m: Vec3) -> f64 {
        self.touching(m).map_or(f64::INFINITY, |x| x.dot(&m))
    }

    fn bounded_direction(&self, m: Vec3) -> Vec3 {
        let mut laid = m;
        for a in self.axes.iter().filter(|a| a.bend == 0.0) {
            laid -= a.e * a.e.dot(&m);
        }
        if let Some((t, _)) = self.linear {
            laid += t * t.dot(&m).max(1e-9 * m.norm());
        }
        let first = self.round().next().map_or(Vec3::z(), |a| a.e);
        unit_or(laid, first)
    }

    fn square_direction(&self, m: Vec3, v: Vec3) -> Vec3 {
        let bounded = |m: Vec3| self.bounded_direction(m);
        match self.generator() {
            Some(g) => bounded(square_to_both(m, g, v)),
            None => bounded(without(m, v)),
        }
    }
}

/// A place of an oval, and the tool seen from there.
struct Look {
    x: Vec3,
    n: Vec3,
    /// The point of the tool next to it.
    p: Vec3,
    /// What is to be least: the distance, of a tool end without its sign.
    far: f64,
    /// The gap, where it is least.
    gap: f64,
    /// Newton's step, and the sine of the angle between the normal and the way to the tool.
    step: Vec3,
    off: f64,
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::{Cutter, Profile, Quadric, QuadricKind};
    use proptest::prelude::*;

    /// Ellipsoid, elliptic cylinder, paraboloid and parabolic cylinder, turned about the diagonal of space.
    fn ovals(half: [f64; 3]) -> Vec<Oval> {
        let [a, b, c] = half.map(|x| 1.0 / (x * x));
        let turned = |l: [f64; 3]| {
            // The coordinates change places, two of them mixed.
            let [l, k, n] = l;
            let (x, y, xy) = (0.64 * l + 0.36 * k, 0.36 * l + 0.64 * k, 0.48 * (l - k));
            let c = [y, n, x, -1.0, 0.0, xy, 0.0, 0.0, 0.0, 0.0];
            Oval::new(&QuadricSurface::new(&Quadric { kind: QuadricKind::Qadric, c }).unwrap())
        };
        let all = [turned([a, b, c]), turned([a, 0.0, c]), turned([a, b, 0.0])];
        let plain = |c: [f64; 10]| {
            Oval::new(&QuadricSurface::new(&Quadric { kind: QuadricKind::Qadric, c }).unwrap())
        };
        let open = [
            plain([a, b, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5 / half[2]]),
            plain([a, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5 / half[2]]),
        ];
        all.into_iter().chain(open).flatten().collect()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(300))]
        /// The gap from above is what its direction proves from below.
        #[test]
        fn what_is_found_next_to_a_tool_is_next_to_it(
            half in prop::array::uniform3(8.0_f64..60.0), te in prop::array::uniform3(-30.0_f64..30.0),
            lean in prop::array::uniform2(-1.0_f64..1.0), corner in 0.0_f64..5.0, near in -1.0_f64..1.0,
        ) {
            let ta = Vec3::new(lean[0], lean[1], 1.0).normalize();
            let profile = Profile::new(&Cutter::mill(10.0, corner, 60.0)).unwrap();
            let ovals = ovals(half);
            prop_assert_eq!(ovals.len(), 5);
            for oval in &ovals {
                for tool in [Tool::Solid(&profile), Tool::End] {
                    let out = oval.bounded_direction(Vec3::new(lean[1], near, 1.0));
                    let te = oval.touching(out).unwrap() + out * 115.0 + Vec3::from(te);
                    let pose = Pose { te, ta };
                    let near = (near > 0.0).then(|| (out + Vec3::new(0.3 * near, 0.2, 0.1)).normalize());
                    let Nearest { gap, n, .. } = oval.next_to(&tool, &pose, near).unwrap();
                    let shown = -tool.height(&pose, -n) - oval.support(n);
                    prop_assert!((gap - shown).abs() <= 1e-10 * (1.0 + gap.abs()), "{gap} {shown} {oval:?}");
                }
            }
        }

        #[test]
        fn directions_square_to_a_way_are(
            half in prop::array::uniform3(8.0_f64..60.0), m in prop::array::uniform3(-1.0_f64..1.0),
            v in prop::array::uniform3(-1.0_f64..1.0),
        ) {
            let v = Vec3::from(v);
            for oval in ovals(half) {
                let d = oval.square_direction(oval.bounded_direction(Vec3::from(m)), v);
                prop_assert!((d.norm() - 1.0).abs() <= 1e-12 && oval.support(d).is_finite());
                let free = oval.linear.is_none();
                prop_assert!(!free || d.dot(&v).abs() <= 1e-12, "{d} {v} {oval:?}");
            }
        }
    }
}
