//! The corner of a cutter, with the flat end within it, against a surface while the tool axis stands: the place of contact goes
//! from one cut vector to the next by Newton's method.
//!
//! The points of the corner are as far from the circle of its middles as its radius, so that the gap is the distance of that
//! circle. With K the curvatures of the surface at a place, in the frame along and around the corner, and d the distance
//! along its normal of the middle that faces it, a step x along the surface moves the middle across that normal against the
//! surface by (1 + A K) x, A = diag(d, d + rho / s): rho is the radius of the circle, s the sine between normal and tool
//! axis. Where both principal minors are positive the place is the nearest one of all about it.
//!
//! A crest below the flat end stays where it is, as far above it as the plane of that: the gap is as long linear.

use aptc_geometry::profile::Segment;
use aptc_geometry::surface::frame_about;
use aptc_geometry::{Foot, Profile, Shape, Spot, Surface, Tool, Vec3};

use crate::curvature::relative;
use crate::disk;
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
/// is: the gap is off by a sixth of its third power then, and how it bends by as much of itself. What the ends of a chord foretell is
/// off by that share of the band.
const CLOSE: f64 = 1e-5;
/// Sine between normal and tool axis below which the corner is left.
const FLAT: f64 = 1e-8;
/// Slope towards the upper line from which it may touch as well: its far end comes down with the next step, where nothing is
/// to be seen of it now.
const BESIDE_LINE: f64 = 0.1;
/// Share of the cutter's radius by which a place lies beside another.
const BESIDE: f64 = 0.25;
/// Share of the cutter's radius that two places of contact lie apart when they are two.
const ANOTHER: f64 = 0.1;
/// Turn of the normal on a way as long as that radius up to which a surface does not bend.
const STRAIGHT: f64 = 1e-9;
/// Sine of the angle to a flat end up to which a track goes along it.
const ALONG: f64 = 0.1;
/// Share of the radius of the flat end from which a place is no longer at its edge.
const ROUNDED: f64 = 1e-6;
/// Share of the radius of the flat end by which a place may lie beside a straight ridge.
const BESIDE_RIDGE: f64 = 1e-9;

/// The corner of a cutter that does not turn.
#[derive(Clone, Copy, Debug)]
pub struct Ring {
    profile: Profile,
    ta: Vec3,
    /// From the tool end to the middle of the circle, and its radius.
    up: Vec3,
    rho: f64,
    side: Side,
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
    let Reading { end, .. } = ring.corner(surface, tool.te, near)?;
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
        (rho > 0.0).then_some(Self { profile, ta: tool.ta, up, rho, side, sign, thick, several })
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

    /// Does a place with that normal face the flat end, and not the corner?
    #[inline]
    pub(crate) fn is_level(&self, normal: Vec3) -> bool {
        let up = normal.dot(&self.ta);
        up > 0.0 && (normal - self.ta * up).norm_squared() <= FLAT * FLAT
    }

    /// Where on the way `v` of the tool end from `te` a crest comes below the flat end, and where it leaves it, the whole way being 1;
    /// `None` where it stays beside.
    pub(crate) fn passes(
        &self,
        surface: &Surface,
        crest: Spot,
        te: Vec3,
        v: Vec3,
    ) -> Option<[f64; 2]> {
        // Of a ridge the last place leaves it.
        let ridge = self.ridge(surface, crest).unwrap_or_else(Vec3::zeros);
        let across = |w: Vec3| w - self.ta * w.dot(&self.ta) - ridge * w.dot(&ridge);
        let (w, v) = (across(crest.point - te), across(v));
        let square = v.norm_squared();
        let middle = w.dot(&v) / square;
        let beside = (w - v * middle).norm_squared();
        let half = ((self.rho * self.rho - beside) / square).sqrt();
        half.is_finite().then_some([middle - half, middle + half])
    }

    /// The gap of the flat end with the tool end at `te` to a crest below it.
    pub(crate) fn above(&self, crest: Vec3, te: Vec3) -> f64 {
        (te + self.up - crest).dot(&self.ta) - self.profile.corner_radius() - self.thick
    }

    /// How far the tool goes on along the unit vector until it leaves the crest below its flat end; `None` where none is.
    pub(crate) fn leaves(&self, te: Vec3, end: &End<Spot>, along: Vec3) -> Option<f64> {
        let from_axis = (end.at.point - te).dot(&along);
        let stays = along.dot(&self.ta).abs() < ALONG && self.is_level(end.normal);
        stays.then_some(self.rho + from_axis)
    }

    /// What is read at the place near `near`; `None` where neither the corner touches there nor the flat end a crest.
    pub(crate) fn read(
        &self,
        surface: &Surface,
        te: Vec3,
        near: Spot,
    ) -> Option<Reading<Spot, PointBends>> {
        let w = near.point - te;
        let (out, inner) = (w - self.ta * w.dot(&self.ta), self.rho * (1.0 - ROUNDED));
        if out.norm_squared() < inner * inner {
            self.lower(surface, te, near).or_else(|| self.corner(surface, te, near))
        } else {
            self.corner(surface, te, near).or_else(|| self.lower(surface, te, near))
        }
    }

    /// The same from beside a crest, on which the flat end may lie as well as the corner.
    fn lower(&self, surface: &Surface, te: Vec3, near: Spot) -> Option<Reading<Spot, PointBends>> {
        let tool = Tool { profile: &self.profile, te, ta: self.ta };
        let gap = disk::beside(&tool, surface, self.side, near)?;
        if !self.is_level(gap.normal) {
            return self.corner(surface, te, gap.spot());
        }
        let at = self.middle(surface, te, gap.spot());
        let shape = surface.place(at).shape;
        let shape = if self.sign > 0.0 { shape } else { shape.reversed() };
        let bends = PointBends::Crest(shape.offset(gap.raw + self.profile.corner_radius())?);
        let end = End { g: self.above(at.point, te), normal: gap.normal, at };
        Some(Reading { end, bends })
    }

    /// Of the ridge through a crest the place next to the tool axis, whatever led to the one that is known; of others that.
    fn middle(&self, surface: &Surface, te: Vec3, crest: Spot) -> Spot {
        let Some(along) = self.ridge(surface, crest) else { return crest };
        let by = along * (te - crest.point).dot(&along);
        let foot = surface.foot_from(crest.point + by, crest);
        let off = (foot.point - crest.point - by).norm();
        let goes_on = off <= BESIDE_RIDGE * self.rho && self.is_level(foot.normal * self.sign);
        if goes_on && !surface.ends_at(foot.at) { foot.spot() } else { crest }
    }

    /// The direction of the ridge through a crest, along which the surface does not bend; `None` where it bends in all.
    fn ridge(&self, surface: &Surface, crest: Spot) -> Option<Vec3> {
        let [a, b] = frame_about(self.ta);
        let [h11, h12, h22] = surface.place(crest).shape.terms([a, b]).map(|h| h * self.sign);
        let (mean, half) = (0.5 * (h11 + h22), 0.5 * (h11 - h22));
        let root = (half * half + h12 * h12).sqrt();
        let v = if half >= 0.0 { a * (half + root) + b * h12 } else { a * h12 + b * (root - half) };
        let level = (mean - root).abs() * self.rho <= STRAIGHT && mean + root > 0.0;
        let across = v.try_normalize(0.0).filter(|_| level)?;
        Some(self.ta.cross(&across))
    }

    /// Does the contact go onto a crest below the flat end, off it or over it on the way between two places?
    pub(crate) fn crosses(&self, ends: [&End<Spot>; 2]) -> bool {
        let [a, b] = ends.map(|end| end.normal);
        self.is_level(a) || self.is_level(b) || self.apart(a, b)
    }

    /// What is read of the corner at the place near `near`; `None` where it does not touch there.
    fn corner(&self, surface: &Surface, te: Vec3, near: Spot) -> Option<Reading<Spot, PointBends>> {
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
        let level = self.is_level(normal);
        let tool_point = if level { at.point + normal * raw } else { p.point };
        let surface_point = tool_point - normal * raw;
        let segment = Some(if level { Segment::LowerLine } else { p.segment });
        Gap { g, raw, tool_point, surface_point, at: at.at, normal, segment, residual: 0.0 }
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
            let touches = matches!(first.segment, Some(Segment::Arc | Segment::LowerLine));
            prop_assert!(touches, "{first:?}");
            prop_assume!(v.norm() > 0.0);
            let Some(b) = ring.read(&surface, te + v, a.end.at) else { return Ok(()) };
            let last = find(te + v, Some(b.end.at)).filter(|g| g.residual < 1e-6);
            let Some(last) = last else { return Ok(()) };
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
