//! The flat end and the corner of a cutter against a surface: the place of contact beside a known one.
//!
//! Their points are no farther than the corner's radius from the disk that the circle of the corner's middles bounds, so
//! that the gap is the least distance of that disk. Its place and that of the surface are found together, one place of the
//! surface for each step: at a point of the disk the foot goes by (1 + d K)^-1 of what the point lies off the normal, the
//! normal by K times that, and the second derivatives of the distance are K (1 + d K)^-1, with K the curvatures and d the
//! distance along the normal. The form of second degree that this makes is least on the disk in closed form, or along its
//! border. Neither the edge between flat end and corner nor a ruling along the flat end makes more steps of it.

use aptc_geometry::profile::Segment;
use aptc_geometry::surface::{self, frame_about};
use aptc_geometry::{Foot, Reason, Spot, Surface, Tool, Vec2, Vec3};

use crate::descent::local;
use crate::gap::{Gap, Side};

/// Steps; three to five are usual.
const STEPS: usize = 14;
/// Share of the cutter's radius by which both points may fail to face each other, or to lie where the gap is least. The gap
/// is exact to its square.
const FACING: f64 = 1e-12;
/// The same where steps no longer become shorter: rounding alone is left.
const ROUNDED: f64 = 1e-9;
/// Share of it, and of the surface's least radius there, by which a place lies so close by another that this tells where and how it
/// is to rounding: what it is off falls with the third power.
const BESIDE: f64 = 1e-5;
/// Share of the cutter's radius up to which a step is gone to the nearest place, where no simple one lies beside.
const CLOSE: f64 = 0.02;
/// Cosine between normal and tool axis below which it is left to other searches.
const UPRIGHT: f64 = 0.5;
/// Sine of the tilt from which the corner is to touch, if the flat end does not.
const TILT: f64 = 1e-7;
/// Share of the cutter's size by which a gap may change along a ruling and count as the same.
const ALIKE: f64 = 1e-14;
/// Steps along the border for one form of second degree, of Newton's method, and that after which rounding alone is left.
const ALONG: usize = 20;
const LAST: f64 = 1e-8;

/// Share of the cutter's radius from which a place of contact is far from where the way to it began: over a hollow a step may
/// lead past the nearest one, to the other side of the disk.
const FAR: f64 = 0.5;

/// Share of that way to another place for it to be a nearer one, and not the same.
const NEARER: f64 = 0.9;

/// The place of contact of flat end or corner into which the surface point `q` runs downhill, else that of any part of the
/// cutter.
pub(crate) fn below(
    tool: &Tool<'_>,
    surface: &Surface,
    side: Side,
    q: Spot,
) -> Result<Gap, Reason> {
    let away = |gap: &Gap| (gap.surface_point - q.point).norm();
    let far = FAR * tool.profile.widest();
    match follow(tool, surface, side, q) {
        Some((gap, bent)) if !bent || away(&gap) <= far => Ok(gap),
        Some((gap, _)) => match local(tool, surface, side, q) {
            Ok(near) if away(&near) < NEARER * away(&gap) => Ok(near),
            _ => Ok(gap),
        },
        None => local(tool, surface, side, q),
    }
}

/// The place of contact of flat end or corner into which the place `near` of a surface runs downhill; `None` where that is
/// not seen to be one.
pub(crate) fn beside(tool: &Tool<'_>, surface: &Surface, side: Side, near: Spot) -> Option<Gap> {
    follow(tool, surface, side, near).map(|(gap, _)| gap)
}

/// The same, and whether the distance bent down over the disk on the way, so that a step may have led past a place.
fn follow(tool: &Tool<'_>, surface: &Surface, side: Side, near: Spot) -> Option<(Gap, bool)> {
    let disk = Disk::of(tool, side)?;
    let radius = tool.profile.corner_radius();
    let widest = tool.profile.widest();
    let (enough, rounded) = (FACING * widest, ROUNDED * widest);
    let (mut last, mut bent) = (f64::INFINITY, false);
    let (mut foot, mut sides): (Foot, _) = surface.place_with_sides(near);
    let mut x = disk.above(foot.point, foot.normal * disk.sign)?;
    let begin = disk.distance(foot.point, foot.normal * disk.sign);
    for _ in 0..STEPS {
        let normal = foot.normal * disk.sign;
        if normal.dot(&tool.ta) < UPRIGHT {
            return None;
        }
        let away = disk.point(x) - foot.point;
        let d = away.dot(&normal);
        let off = away - normal * d;
        let shape = if disk.sign > 0.0 { foot.shape } else { foot.shape.reversed() };
        let ([a, b], [k11, k12, k22]) = (shape.frame, shape.k);
        let (p, q, r) = (1.0 + d * k11, d * k12, 1.0 + d * k22);
        let det = p * r - q * q;
        // Not so where a curvature is none, as on an edge, or the place is no nearest one.
        if !(p > 0.0 && det > 0.0 && det.is_finite()) {
            return None;
        }
        // (1 + d K)^-1 of what lies across the normal.
        let foot_by = |v: Vec3| {
            let (s, t) = (v.dot(&a), v.dot(&b));
            Vec2::new((r * s - q * t) / det, (p * t - q * s) / det)
        };
        let turned = |by: Vec2| a * (k11 * by.x + k12 * by.y) + b * (k12 * by.x + k22 * by.y);
        let slope = disk.across(normal + turned(foot_by(off)));
        let bend_along = |e: Vec3| disk.across(turned(foot_by(e)));
        let bend = [bend_along(disk.e[0]), bend_along(disk.e[1])];
        let (to, down) = disk.least(x, slope, bend, ALIKE * tool.profile.widest())?;
        bent |= down;
        let go = disk.point(to) - disk.point(x);
        let left = (off.norm_squared() + go.norm_squared()).sqrt();
        if left <= enough || left <= rounded && left > 0.5 * last {
            let raw = d - radius;
            let (out, up) = (disk.across(normal).norm(), normal.dot(&tool.ta));
            let segment = tool.profile.support(out, -up).segment;
            // Also at its edge, where all of a ruling lies along it.
            let flat = out <= TILT || x.norm() < disk.rho * (1.0 - ROUNDED);
            let touches = matches!(segment, Segment::Arc | Segment::LowerLine);
            let lower = d <= begin + rounded && !surface.ends_at(foot.at);
            let gap = || Gap {
                g: raw,
                raw,
                tool_point: disk.point(x) - normal * radius,
                surface_point: foot.point,
                at: foot.at,
                normal,
                segment: Some(if flat { Segment::LowerLine } else { Segment::Arc }),
                residual: off.norm(),
            };
            return (touches && lower).then(|| (gap(), bent));
        }
        let by = foot_by(off + go - normal * go.dot(&normal));
        last = left;
        let bend = k11.abs() + k12.abs() + k22.abs();
        let square = by.norm_squared();
        let by = a * by.x + b * by.y;
        if square <= (BESIDE * widest) * (BESIDE * widest)
            && square * bend * bend <= BESIDE * BESIDE
            && let Some(there) = surface.close_by(&foot, sides, by)
        {
            (foot, x) = (there, to);
            continue;
        }
        let (next, known) = match surface.beside(foot.spot(), sides, by) {
            Some(found) => found,
            // Along a TABCYL a longer step may lead over a crest to another one.
            None if by.norm() <= CLOSE * tool.profile.widest() => {
                (surface.foot_from(foot.point + by, foot.spot()), None)
            }
            None => return None,
        };
        (foot, sides, x) = (next, known, to);
    }
    None
}

/// The disk of the corner's middles of a cutter with a flat end that runs into the corner.
pub(crate) fn middles(tool: &Tool<'_>, side: Side) -> Option<surface::Disk> {
    let Disk { center, ta: axis, rho, .. } = Disk::of(tool, side)?;
    Some(surface::Disk { center, axis, rho })
}

/// The disk of the corner's middles.
struct Disk {
    center: Vec3,
    ta: Vec3,
    /// Unit vectors across the axis.
    e: [Vec3; 2],
    rho: f64,
    sign: f64,
}

impl Disk {
    /// `None` of cutters without a flat end that runs into the corner.
    fn of(tool: &Tool<'_>, side: Side) -> Option<Self> {
        let [rho, high] = tool.profile.corner();
        let at = |out: f64| tool.profile.support(out, -1.0).segment;
        let flat = at(0.0) == Segment::LowerLine && at(TILT) == Segment::Arc;
        (rho > 0.0 && flat && side != Side::Open).then(|| Self {
            center: tool.te + tool.ta * high,
            ta: tool.ta,
            e: frame_about(tool.ta),
            rho,
            sign: side.sign(),
        })
    }

    fn point(&self, x: Vec2) -> Vec3 {
        self.center + self.e[0] * x.x + self.e[1] * x.y
    }

    /// Its distance from a place of the surface with that normal, negative where it is plainly behind it.
    fn distance(&self, q: Vec3, normal: Vec3) -> f64 {
        let x = self.across(q - self.center);
        let far = x.norm();
        let near = self.point(if far > self.rho { x * (self.rho / far) } else { x }) - q;
        let size = near.norm();
        if near.dot(&normal) < -UPRIGHT * size { -size } else { size }
    }

    fn across(&self, v: Vec3) -> Vec2 {
        Vec2::new(self.e[0].dot(&v), self.e[1].dot(&v))
    }

    /// The point of it next to where the normal of a place of the surface meets its plane.
    fn above(&self, q: Vec3, normal: Vec3) -> Option<Vec2> {
        let up = normal.dot(&self.ta);
        let w = q - self.center;
        let x = self.across(w - normal * (w.dot(&self.ta) / up));
        let far = x.norm();
        (up >= UPRIGHT).then(|| if far > self.rho { x * (self.rho / far) } else { x })
    }

    /// Where a form of second degree with the derivatives `slope` and `bend` at `x` is least on the disk: inside, or on the
    /// border where it falls to. Changes of less than `alike` are none. `None` where it bends down in all directions, and
    /// where the search along the border does not end. With whether it bends down in one direction.
    fn least(&self, x: Vec2, slope: Vec2, bend: [Vec2; 2], alike: f64) -> Option<(Vec2, bool)> {
        let (h11, h12, h22) = (bend[0].x, 0.5 * (bend[0].y + bend[1].x), bend[1].y);
        let (mean, half) = (0.5 * (h11 + h22), 0.5 * (h11 - h22));
        let root = (half * half + h12 * h12).sqrt();
        let (most, least) = (mean + root, mean - root);
        if most <= 0.0 {
            return None;
        }
        let v = if half >= 0.0 { Vec2::new(half + root, h12) } else { Vec2::new(h12, root - half) };
        let v = v.try_normalize(0.0).unwrap_or_else(Vec2::x);
        let w = Vec2::new(-v.y, v.x);
        let (down, along) = (slope.dot(&v), slope.dot(&w));
        let first = x - v * (down / most);
        // By so much the form changes along `w` over the whole of the disk.
        let changes = self.rho * (along.abs() + least.abs() * self.rho);
        let far = 2.0 * self.rho;
        let by = if changes <= alike {
            // A ruling: to the nearest place of it on the disk.
            let high = first.dot(&w);
            let (level, reach) = (first.dot(&v), self.rho);
            let room = ((reach - level) * (reach + level)).max(0.0).sqrt();
            high.clamp(-room, room) - high
        } else if least > 0.0 {
            (-along / least).clamp(-far, far)
        } else {
            -far * along.signum()
        };
        let to = first + w * by;
        let down = changes > alike && least < 0.0;
        if to.norm() <= self.rho {
            return Some((to, down));
        }
        let bent = |y: Vec2| Vec2::new(h11 * y.x + h12 * y.y, h12 * y.x + h22 * y.y);
        let start =
            if first.norm() < self.rho { self.border(first, w * by.signum()) } else { first };
        let mut out = start.try_normalize(0.0)?;
        for _ in 0..ALONG {
            let around = Vec2::new(-out.y, out.x);
            let here = slope + bent(out * self.rho - x);
            let rate = here.dot(&around);
            let turn = self.rho * around.dot(&bent(around)) - here.dot(&out);
            let newton = -rate / turn;
            let step = if turn > 0.0 && newton.abs() < 0.5 { newton } else { -0.5 * rate.signum() };
            out = (out + around * step).normalize();
            if step.abs() <= LAST {
                return Some((out * self.rho, down));
            }
        }
        None
    }

    /// Where the way from a point of the disk along the unit vector `w` leaves it.
    fn border(&self, from: Vec2, w: Vec2) -> Vec2 {
        let along = from.dot(&w);
        let room = along * along + (self.rho - from.norm()) * (self.rho + from.norm());
        from + w * (room.max(0.0).sqrt() - along)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gap::gap;
    use crate::shapes::rulings;
    use aptc_geometry::{Cutter, Form, Profile, Quadric, QuadricKind, trig};
    use proptest::prelude::*;

    /// A surface of rulings along y between two arcs, an ellipsoid and a saddle.
    fn surface(kind: usize) -> Surface {
        let quadric = |c: [f64; 10]| Form::Quadric(Quadric { kind: QuadricKind::Qadric, c });
        let form = match kind {
            0 => return rulings([60.0, 90.0], 0.0),
            1 => quadric([3e-4, 5e-4, 4e-4, 0.0, 0.0, 0.0, 0.0, 0.0, 0.02, 0.0]),
            _ => quadric([0.01, -0.008, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5, 0.0]),
        };
        Surface::from_form(&form).unwrap()
    }

    #[test]
    fn a_flat_end_on_a_crest_touches_it_within_its_edge() {
        let profile = Profile::new(&Cutter::mill(10.0, 2.0, 40.0)).unwrap();
        let surface = surface(0);
        for k in -14..=14 {
            let te = Vec3::new(0.2 * f64::from(k), 0.0, 0.3);
            let tool = Tool { profile: &profile, te, ta: Vec3::z() };
            // From a place before the crest and one behind it.
            for x in [-3.0, 3.0] {
                let near = surface.foot(Vec3::new(x, 0.4, 0.0)).spot();
                let found = beside(&tool, &surface, Side::Positive, near).unwrap();
                assert!((found.raw - 0.3).abs() < 1e-12, "{k} {x} {found:?}");
                let off = found.tool_point - te;
                assert!(trig::hypot(off.x, off.y) <= 3.0 + 1e-9 && off.z.abs() < 1e-12, "{off}");
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(3000))]
        #[test]
        fn no_place_beside_is_nearer(
            kind in 0_usize..3, corner in 0_usize..3,
            [te, lean, start] in prop::array::uniform3(prop::array::uniform2(-1.0_f64..1.0)),
            up in -1.0_f64..2.0,
        ) {
            let surface = surface(kind);
            let (radius, corner) = (5.0, [0.0, 0.5, 2.0][corner]);
            let profile = Profile::new(&Cutter::mill(2.0 * radius, corner, 40.0)).unwrap();
            let ta = Vec3::new(0.1 * lean[0], 0.1 * lean[1], 1.0).normalize();
            let at = Vec3::new(20.0 * te[0], 15.0 * te[1], 0.0);
            let on = surface.foot(at).point;
            let tool = Tool { profile: &profile, te: on + Vec3::z() * up, ta };
            let q = surface.foot(on + Vec3::new(4.0 * start[0], 4.0 * start[1], 0.0)).spot();
            let Some(found) = beside(&tool, &surface, Side::Positive, q) else { return Ok(()) };
            let rho = radius - corner;
            let [a, b] = frame_about(ta);
            let x = found.tool_point + found.normal * corner;
            let value = |x: Vec3| surface.distance(x) - corner;
            prop_assert!((value(x) - found.raw).abs() < 1e-9, "{found:?}");
            // Nothing of the disk about it is nearer.
            for i in 0..24 {
                let (s, c) = trig::sin_cos(f64::from(i) * std::f64::consts::TAU / 24.0);
                let y = x + (a * c + b * s) * 1e-3;
                let w = y - tool.te - ta * corner;
                let out = (w - ta * w.dot(&ta)).norm();
                let y = if out > rho { y - (w - ta * w.dot(&ta)) * (1.0 - rho / out) } else { y };
                prop_assert!(value(y) >= found.raw - 1e-11, "{i} {} {found:?}", value(y) - found.raw);
            }
            // None is deeper than the deepest.
            if let Ok(deepest) = gap(&tool, &surface, Side::Positive, 0.0) {
                prop_assert!(found.raw >= deepest.raw - 1e-9, "{found:?} {deepest:?}");
            }
        }
    }
}
