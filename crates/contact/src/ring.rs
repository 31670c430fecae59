//! The corner of a cutter against a surface while the tool axis stands: the place of contact goes from one cut vector to the
//! next by Newton's method.
//!
//! The points of the corner are as far from the circle of its middles as its radius, so that the gap is the distance of that
//! circle. With K the curvatures of the surface at a place, in the frame along and around the corner, and d the distance
//! along its normal of the middle that faces it, a step x along the surface moves the middle across that normal against the
//! surface by (1 + A K) x, A = diag(d, d + rho / s): rho is the radius of the circle, s the sine between normal and tool
//! axis. Where both principal minors are positive the place is the nearest one of all about it.

use aptc_geometry::profile::Segment;
use aptc_geometry::{Foot, Profile, Shape, Spot, Surface, Tool, Vec3};

use crate::curvature::relative;
use crate::gap::{Condition, Gap, Side};
use crate::guide::{End, Reading};
use crate::point::PointBends;
use crate::search::{hollow, several};

/// Steps of Newton's method; two or three are usual.
const STEPS: usize = 8;
/// Share of the cutter's radius across the normal by which both points may fail to face each other. The gap is exact to its
/// square.
const FACING: f64 = 1e-10;
/// Share of it, and of the surface's least radius there, by which a place lies so close by another that this tells where and how it
/// is: the gap is off by a sixth of its third power then. A smaller one asks for one place more in most steps.
const CLOSE: f64 = 1e-4;
/// Sine between normal and tool axis below which the corner is left.
const FLAT: f64 = 1e-6;
/// Slope towards the upper line from which it may touch as well: its far end comes down with the next step, where nothing is
/// to be seen of it now.
const BESIDE_LINE: f64 = 0.1;
/// Share of the cutter's radius by which a place lies beside another.
const BESIDE: f64 = 0.25;
/// Share of the cutter's radius that two places of contact lie apart when they are two.
const ANOTHER: f64 = 0.1;

/// The corner of a cutter that does not turn.
#[derive(Clone, Copy, Debug)]
pub struct Ring {
    profile: Profile,
    ta: Vec3,
    /// From the tool end to the middle of the circle, and its radius.
    up: Vec3,
    rho: f64,
    pub(crate) sign: f64,
    /// What the gap is less than the distance.
    thick: f64,
    /// May another place of contact become the deepest?
    pub(crate) several: bool,
}

/// A place of the corner that faces against a normal.
struct Facing {
    /// Away from the axis.
    out: Vec3,
    /// Its part across and along the axis.
    across: f64,
    along: f64,
}

/// The gap at the place of contact of the corner beside the place `near` of a surface; `None` where there is none so near.
pub(crate) fn beside(tool: &Tool<'_>, surface: &Surface, side: Side, near: Spot) -> Option<Gap> {
    let ring = Ring::of(tool, side, 0.0, true)?;
    let Reading { end, .. } = ring.read(surface, tool.te, near)?;
    let gap = ring.gap(tool.te, &end);
    ((gap.surface_point - near.point).norm() <= BESIDE * tool.profile.half_width(gap.segment))
        .then_some(gap)
}

impl Ring {
    pub(crate) fn new(
        tool: &Tool<'_>,
        surface: &Surface,
        condition: Condition,
        side: Side,
        thick: f64,
    ) -> Option<Self> {
        let guided = !matches!(surface, Surface::Plane(_)) && side != Side::Open;
        let corner = condition == Condition::Touch && guided && !hollow(surface, side);
        Self::of(tool, side, thick, several(tool, surface, side)).filter(|_| corner)
    }

    fn of(tool: &Tool<'_>, side: Side, thick: f64, several: bool) -> Option<Self> {
        let ([rho, high], profile) = (tool.profile.corner(), *tool.profile);
        let (up, sign) = (tool.ta * high, side.sign());
        (rho > 0.0).then_some(Self { profile, ta: tool.ta, up, rho, sign, thick, several })
    }

    /// Do two places of contact lie far from each other on the cutter?
    #[inline]
    pub(crate) fn apart(&self, a: Vec3, b: Vec3) -> bool {
        let far = ANOTHER * self.profile.half_width(Some(Segment::Arc));
        // Parts across the axis turn by no more than the normals differ, over the less of them.
        let square = |n: Vec3| 1.0 - n.dot(&self.ta) * n.dot(&self.ta);
        let (least, turned) = (square(a).min(square(b)), (a - b).norm_squared());
        let radius = self.profile.corner_radius();
        let moved = 2.0 * turned * (self.rho * self.rho + radius * radius * least);
        if least > FLAT * FLAT && moved < far * far * least {
            return false;
        }
        let from =
            |n: Vec3| Some(self.facing(n)?.out * self.rho - n * self.profile.corner_radius());
        let (Some(a), Some(b)) = (from(a), from(b)) else { return true };
        (a - b).norm() > far
    }

    #[inline]
    fn facing(&self, normal: Vec3) -> Option<Facing> {
        let along = -normal.dot(&self.ta);
        let radial = -normal - self.ta * along;
        let across = radial.norm();
        (across > FLAT).then(|| Facing { out: radial * (1.0 / across), across, along })
    }

    /// What is read at the place near `near`; `None` where it is not the corner that touches.
    pub(crate) fn read(
        &self,
        surface: &Surface,
        te: Vec3,
        near: Spot,
    ) -> Option<Reading<Spot, PointBends>> {
        let middle = te + self.up;
        let wide = self.profile.widest();
        let enough = FACING * wide;
        let (mut foot, mut sides): (Foot, _) = surface.place_with_sides(near);
        for _ in 0..STEPS {
            let normal = foot.normal * self.sign;
            let Facing { out, across, along } = self.facing(normal)?;
            let away = middle + out * self.rho - foot.point;
            let d = away.dot(&normal);
            let rest = away - normal * d;
            let frame = [self.ta * across - out * along, self.ta.cross(&out)];
            let [k11, k12, k22] = foot.shape.terms(frame);
            let (k11, k12, k22) = (k11 * self.sign, k12 * self.sign, k22 * self.sign);
            let wider = self.rho / across;
            let around = d + wider;
            let (p, q) = (1.0 + d * k11, 1.0 + around * k22);
            let det = p * q - d * around * k12 * k12;
            // Not so where a curvature is none, as on an edge, or the place is no nearest one.
            if !(p > 0.0 && q > 0.0 && det > 0.0 && det.is_finite()) {
                return None;
            }
            if rest.norm_squared() <= enough * enough {
                let arc = self.profile.touches_with_arc(across, along)
                    && self.profile.touches_with_arc(
                        across - BESIDE_LINE * along,
                        along + BESIDE_LINE * across,
                    );
                if !arc || surface.ends_at(foot.at) {
                    return None;
                }
                let radius = self.profile.corner_radius();
                let raw = d - radius;
                let shape = Shape { frame, k: [k11, k12, k22] };
                let bends = PointBends::Level(relative(shape, [radius, radius + wider], raw)?);
                let end = End { g: raw - self.thick, normal, at: foot.spot() };
                return Some(Reading { end, bends });
            }
            let (x, y) = (rest.dot(&frame[0]), rest.dot(&frame[1]));
            let by = [(q * x - d * k12 * y) / det, (p * y - around * k12 * x) / det];
            let square = by[0] * by[0] + by[1] * by[1];
            let by = frame[0] * by[0] + frame[1] * by[1];
            if square > wide * wide {
                return None;
            }
            let bend = k11.abs() + k12.abs() + k22.abs();
            if square <= (CLOSE * wide) * (CLOSE * wide)
                && square * bend * bend <= CLOSE * CLOSE
                && let Some(there) = surface.close_by(&foot, sides, by)
            {
                foot = there;
                continue;
            }
            (foot, sides) = match surface.beside(foot.spot(), sides, by) {
                Some(found) => found,
                None => (surface.foot_from(foot.point + by, foot.spot()), None),
            };
        }
        None
    }

    pub(crate) fn gap(&self, te: Vec3, &End { g, normal, at }: &End<Spot>) -> Gap {
        let raw = g + self.thick;
        let tool = Tool { profile: &self.profile, te, ta: self.ta };
        let p = tool.support(-normal);
        let surface_point = p.point - normal * raw;
        let segment = Some(p.segment);
        Gap {
            g,
            raw,
            tool_point: p.point,
            surface_point,
            at: at.at,
            normal,
            segment,
            residual: 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::point::PointGuide;
    use crate::shapes::rulings;
    use crate::{Guide, chord, distance, second};
    use aptc_geometry::{Cone, Cutter, Cylinder, Form, Quadric, QuadricKind, Vec3};
    use proptest::prelude::*;

    /// An ellipsoid, a saddle, a cylinder, a cone and a ruled surface.
    fn surface(kind: usize) -> Surface {
        let quadric = |c: [f64; 10]| Form::Quadric(Quadric { kind: QuadricKind::Qadric, c });
        let lean = Vec3::new(0.3, -0.2, 0.9).normalize();
        let form = match kind {
            0 => quadric([0.0011, 0.0006, 0.0016, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
            1 => quadric([0.02, -0.015, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.5]),
            2 => Form::Cylinder(Cylinder { point: Vec3::zeros(), axis: lean, radius: 12.0 }),
            3 => Form::Cone(Cone { vertex: Vec3::new(0.0, 0.0, 20.0), axis: -lean, cos_half: 0.8 }),
            _ => return rulings([60.0, 90.0], 0.0),
        };
        Surface::from_form(&form).unwrap()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]
        #[test]
        fn reads_what_the_general_forms_read(
            kind in 0_usize..5, inside in any::<bool>(), sharp in any::<bool>(), thick in -0.3_f64..0.5,
            [te, v, ta] in prop::array::uniform3(prop::array::uniform3(-1.0_f64..1.0)),
        ) {
            let surface = surface(kind);
            let ta = Vec3::from(ta) + Vec3::z();
            prop_assume!(ta.norm() > 0.1);
            let ta = ta.normalize();
            let profile = Profile::new(&Cutter::mill(6.0, if sharp { 0.0 } else { 1.2 }, 9.0)).unwrap();
            let side = if inside { Side::Negative } else { Side::Positive };
            let (te, v) = (Vec3::from(te) * 30.0, Vec3::from(v) * 2.0);
            let tool = Tool { profile: &profile, te, ta };
            let guide = Ring::new(&tool, &surface, Condition::Touch, side, thick);
            prop_assert_eq!(guide.is_none(), hollow(&surface, side));
            let Some(ring) = guide else { return Ok(()) };
            let find = |te: Vec3, near: Option<Spot>| {
                distance(&tool.at(te), &surface, Condition::Touch, side, thick, near).ok()
            };
            let Some(first) = find(te, None).filter(|g| g.residual < 1e-6) else { return Ok(()) };
            let Some(a) = ring.read(&surface, te, first.spot()) else { return Ok(()) };
            prop_assert_eq!(first.segment, Some(Segment::Arc));
            let Some(b) = ring.read(&surface, te + v, a.end.at) else { return Ok(()) };
            let Some(last) = find(te + v, Some(b.end.at)) else { return Ok(()) };
            let ends = [first, last];
            for (te, read, gap) in [(te, &a, &ends[0]), (te + v, &b, &ends[1])] {
                prop_assert!((read.end.g - gap.g).abs() < 1e-9, "{read:?} {gap:?}");
                prop_assert!((read.end.normal - gap.normal).norm() < 1e-6);
                let made = ring.gap(te, &read.end);
                prop_assert!((made.tool_point - gap.tool_point).norm() < 1e-5, "{made:?} {gap:?}");
                prop_assert!((made.surface_point - gap.surface_point).norm() < 1e-5, "{made:?} {gap:?}");
                prop_assert!((made.raw - gap.raw).abs() < 1e-9);
                if let Some(shape) = second(&tool.at(te), &surface, side, gap) {
                    let d = v.normalize();
                    let (x, y) = (PointGuide::second(read, d), shape.second(d));
                    prop_assert!((x - y).abs() < 1e-5 * (1.0 + x.abs() * x.abs()), "{x} {y} {gap:?}");
                }
            }
            if first.g.abs() > 3.0 || last.g.abs() > 3.0 {
                return Ok(());
            }
            let path = PointGuide::Ring(ring);
            let Some([low, high]) = path.foretold_as_met(&surface, te, v, [&a, &b]) else { return Ok(()) };
            let to = tool.at(te + v);
            let whole = chord(&tool, &to, &surface, Condition::Touch, side, thick, Some(ends), 1e-10).unwrap();
            prop_assert!((low - whole.low.g).abs() < 1e-8, "{low} {whole:?}");
            prop_assert!((high - whole.high.g).abs() < 1e-8, "{high} {whole:?}");
        }
    }
}
