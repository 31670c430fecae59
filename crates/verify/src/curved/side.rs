//! The place of the surface next to a point, and the side of it on which a point or the tool stands.

use aptc_geometry::surface::frame_about;
use aptc_geometry::{Vec3, trig};

use super::{Curved, Half};
use crate::search::{Aim, Moved, clearance};
use crate::sheet::{Jet, Spot, bare};
use crate::sweep::Sweep;
use crate::tool::{Pose, Tool};
use crate::witness::descend;

/// Times that a search for the nearest place is made eight times as wide.
const WIDER: u32 = 24;

impl Curved<'_> {
    /// Distance of a point from the surface, which is farther than `near`, and the place.
    pub(super) fn beyond(&self, p: Vec3, near: f64) -> (f64, Option<Spot>) {
        let mut enough = 4.0 * near;
        for _ in 0..WIDER {
            if let found @ (_, Some(_)) = self.nearest(p, enough) {
                return found;
            }
            enough *= 8.0;
        }
        (enough, None)
    }

    /// Of a tool that holds no place at the gap `least` from the surface, and has the point `inner` on a side: it lies between both, nearer
    /// all over, or farther all over as that point is.
    pub(super) fn farther(&self, inner: Vec3, sign: f64, least: f64, low: f64, pad: f64) -> Half {
        let still = Sweep::still(&Tool::End, Pose { te: inner, ta: Vec3::z() });
        let (whole, enough) = (Moved::whole(self.sheet, 1.0, 0.0), least - pad);
        let found = clearance(&still, &whole, enough, Aim::Any);
        match found.nearest {
            Some((gap, ..)) if gap < enough && sign > 0.0 => Half::Broken(0.0, gap),
            _ if found.least >= enough && sign > 0.0 => Half::Holds(low),
            _ => Half::Open(0.0, f64::INFINITY),
        }
    }

    /// On which side of the surface a point lies that is farther than `near`; 0 beside a border.
    pub(super) fn lies(&self, p: Vec3, near: f64) -> f64 {
        let (far, Some(spot)) = self.beyond(p, near) else { return 0.0 };
        let off = self.off(p, &spot);
        if off.abs() > 0.25 * far { off.signum() } else { 0.0 }
    }

    /// How far a point is off the surface along the normal at the place next to it; at an edge along that of the face which is seen
    /// best: from before two faces that is the nearer of both normals, and on its right side.
    pub(super) fn off(&self, p: Vec3, spot: &Spot) -> f64 {
        let way = p - self.sheet.jet(spot).p;
        let offs = self.sheet.around(spot).into_iter().map(|jet| way.dot(&jet.n));
        offs.max_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(0.0)
    }

    /// The same of a tool, none of whose points is nearer: of its middle, or of others round it. Next to an edge the middle may not be
    /// seen from the face that is looked at, and others are.
    pub(super) fn lies_about(&self, tool: &Tool<'_>, pose: &Pose, near: f64) -> f64 {
        /// Directions round the axis, and the share of the way from the middle to the border.
        const ROUND: u32 = 8;
        const OUT: f64 = 0.8;
        let inner = tool.inner(pose);
        let [a, b] = frame_about(pose.ta);
        let round = (0..ROUND).map(|k| {
            let (s, c) = trig::sin_cos(f64::from(k) * std::f64::consts::FRAC_PI_4);
            inner + (tool.farthest(pose, a * c + b * s) - inner) * OUT
        });
        let sides = std::iter::once(inner).chain(round).map(|p| self.lies(p, near));
        sides.into_iter().find(|side| *side != 0.0).unwrap_or(0.0)
    }

    /// On which side of the surface the tool stands that does not pass through it: that of its point nearest
    /// to the surface; 0 where that does not tell.
    pub(super) fn stands(&self, tool: &Tool<'_>, pose: &Pose) -> f64 {
        let band = [self.least, self.most].into_iter().filter(|x| x.is_finite());
        let near = 4.0 * band.fold(1e-6 * tool.reach(), |m, x| m.max(x.abs()));
        let mut enough = near.max(f64::MIN_POSITIVE);
        for _ in 0..WIDER {
            if let Some((distance, spot)) = self.next_to(tool, pose, enough)
                && distance < enough
            {
                return self.facing(tool, pose, &spot);
            }
            enough = (8.0 * enough).max(tool.reach());
        }
        0.0
    }

    /// The place of the surface next to the tool, and its distance, where that is less than `enough`: of a body with edges another
    /// place that is nearly as near may face the other way.
    pub(super) fn next_to(&self, tool: &Tool<'_>, pose: &Pose, enough: f64) -> Option<(f64, Spot)> {
        /// Searches one after another.
        const SEARCHES: u32 = 5;
        let sweep = Sweep::still(tool, *pose);
        let moved = Moved::whole(self.sheet, self.side, 0.0);
        // Each search comes to a tenth of what the one before left; where the surface goes through the tool one is enough.
        let mut nearest = None;
        let mut within = enough;
        for _ in 0..SEARCHES {
            match clearance(&sweep, &moved, within, Aim::Nearest).nearest {
                Some((d, _, spot)) if nearest.is_none() || d < within => nearest = Some((d, spot)),
                _ => break,
            }
            within = nearest.map_or(enough, |n: (f64, Spot)| n.0);
            if within <= 0.0 {
                break;
            }
        }
        nearest
    }

    /// The gap at the place next to the tool from `spot` on, any at first, and the direction away from the surface there; `None` where
    /// nothing is near, or the tool is on the other side.
    pub(crate) fn beside(
        &self,
        tool: &Tool<'_>,
        pose: &Pose,
        spot: &mut Option<Spot>,
    ) -> Option<(f64, Vec3)> {
        let pose = &self.sheet.local(pose);
        let somewhere = || self.next_to(tool, pose, 16.0 * tool.reach().max(1.0)).map(|n| n.1);
        let from = spot.take().or_else(somewhere)?;
        let (distance, place, jet) = descend(tool, pose, self.sheet, from);
        *spot = Some(place);
        if self.on {
            let sign = self.side * (pose.te - jet.p).dot(&jet.n);
            let away = self.sheet.in_space(jet.n * self.side);
            return Some((distance.copysign(sign), away));
        }
        let away = -tool.near(pose, jet.p).1;
        let other = Self::faces(tool, pose, &jet) * self.side < 0.0;
        (!other).then(|| (distance, self.sheet.in_space(away)))
    }

    /// The gap to the plane that is tangent at a place next to the tool: where the surface is one with it, that to the surface, also
    /// where a flank lies along it and the nearest place is hard to tell.
    pub(crate) fn beside_tangent(&self, tool: &Tool<'_>, pose: &Pose) -> Option<f64> {
        let mut spot = None;
        self.beside(tool, pose, &mut spot)?;
        let (pose, jet) = (self.sheet.local(pose), self.sheet.jet(&spot?));
        let n = jet.n * self.side;
        let least = if self.on { n.dot(&pose.te) } else { -tool.height(&pose, -n) };
        Some(least - n.dot(&jet.p))
    }

    /// Is no place of the surface nearer to the tool than so?
    pub(crate) fn nothing_nearer(&self, tool: &Tool<'_>, pose: &Pose, than: f64) -> bool {
        let sweep = Sweep::still(tool, self.sheet.local(pose));
        let whole = Moved::whole(self.sheet, self.side, 0.0);
        clearance(&sweep, &whole, than, Aim::Any).least >= than
    }

    /// The side of the surface at the place next to `spot` on which the tool stands: that to which it reaches farther
    /// along the normal. An edge of the tool that is in the surface by its tolerance does not tell: what is next to a
    /// place inside of it may be its other face. 0 where the tool lies beside the place.
    pub(super) fn facing(&self, tool: &Tool<'_>, pose: &Pose, spot: &Spot) -> f64 {
        /// Cosine between the normal and the way from the tool, beside an edge, from which it tells.
        const TELLS: f64 = 0.25;
        let (_, spot, jet) = descend(tool, pose, self.sheet, *spot);
        let (distance, way) = tool.near(pose, jet.p);
        let seen = |jet: &Jet| way.dot(&jet.n).abs();
        let around = self.sheet.around(&spot).into_iter();
        let jet = around.max_by(|a, b| seen(a).total_cmp(&seen(b))).unwrap_or(jet);
        if distance > 1e-6 * tool.reach() && way.dot(&jet.n).abs() < TELLS {
            return 0.0;
        }
        Self::faces(tool, pose, &jet)
    }

    /// The same at a place itself. Where a border runs together in a point the normal is rounding, and tells nothing.
    pub(super) fn faces(tool: &Tool<'_>, pose: &Pose, jet: &Jet) -> f64 {
        if bare(jet.d) {
            return 0.0;
        }
        let reach = |n: Vec3| tool.height(pose, n) - n.dot(&jet.p);
        let (right, left) = (reach(jet.n), reach(-jet.n));
        if right > 2.0 * left {
            1.0
        } else if left > 2.0 * right {
            -1.0
        } else {
            0.0
        }
    }

    /// Distance of a point from the surface and the place; not more than somewhat above `enough`.
    pub(super) fn nearest(&self, p: Vec3, enough: f64) -> (f64, Option<Spot>) {
        let pose = Pose { te: p, ta: Vec3::z() };
        let sweep = Sweep::still(&Tool::End, pose);
        let moved = Moved::whole(self.sheet, 1.0, 0.0);
        let (mut far, mut place) = (enough, None);
        let mut within = enough;
        for _ in 0..5 {
            match clearance(&sweep, &moved, within, Aim::Nearest).nearest {
                Some((d, _, spot)) if d < within => (far, place) = (d, Some(spot)),
                _ => break,
            }
            within = far * (1.0 - 1e-6);
        }
        let Some(spot) = place else { return (far, None) };
        // The last digits, which a search would come to slowly.
        let (d, spot, _) = descend(&Tool::End, &pose, self.sheet, spot);
        (far.min(d), Some(spot))
    }
}
