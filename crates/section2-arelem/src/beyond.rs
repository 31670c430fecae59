//! Motion that lies wholly beyond the border of a sculptured surface, along what goes straight on there: it misses the part.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_contact::{Side, Tool, gap, on};
use aptc_geometry::surface::ParametricSurface;
use aptc_geometry::{FormKind, Profile, Surface, Vec3};
use aptc_protap::{NameRef, SurfaceRef};

use crate::arelem::Arelem;
use crate::scene::Path;
use crate::space::Pose;
use crate::state::Role;

/// Halvings of a way between two places of contact; what is not told by then counts as over the surface.
const HALVINGS: u32 = 12;

/// How the cutter keeps to a sculptured surface that has borders.
struct Bordered<'a> {
    kept: &'a cl::Controlled,
    profile: Profile,
    whole: Surface,
    /// Without what goes straight on beyond its borders.
    own: Arc<ParametricSurface>,
}

/// A place that is farther from the surface itself than a limit.
#[derive(Clone, Copy)]
struct Far {
    at: Vec3,
    away: f64,
    limit: f64,
}

impl Arelem {
    /// The part or drive surface beyond whose border all of the motion lies by more than the cutter's radius, and how far beyond it is
    /// at least. Of a start-up only its end counts.
    pub(crate) fn wholly_beyond(
        &self,
        kind: cl::MotionKind,
        path: &Path,
    ) -> Option<(SurfaceRef, f64)> {
        let end = path.points.last().map(|p| Pose { te: p.te, ta: p.ta })?;
        let kept = [(&path.control.part, Role::Part), (&path.control.drive, Role::Drive)];
        kept.into_iter().find_map(|(kept, role)| {
            let surface = self.bordered(kept.as_ref()?, role)?;
            // Nearly every motion is told to be over its surface by where it ends.
            surface.far(&end)?;
            let mut poses = vec![end];
            if kind == cl::MotionKind::Continuous {
                let start = self.tool.map(|t| Pose { te: t.te, ta: t.ta })?;
                let points = path.points.iter().map(|p| Pose { te: p.te, ta: p.ta });
                poses = std::iter::once(start).chain(points).collect();
            }
            let least = surface.least(&poses)?;
            let cl::NameRef { name, subscript } = &surface.kept.name;
            let name = NameRef { name: name.clone(), subscript: *subscript };
            Some((SurfaceRef { name, form: Arc::clone(&surface.kept.form) }, least))
        })
    }

    fn bordered<'a>(&self, kept: &'a cl::Controlled, role: Role) -> Option<Bordered<'a>> {
        let profile = self.settings.profile(role)?.ok()?;
        if kept.form.kind() != FormKind::Ssurf {
            return None;
        }
        let whole = self.fitted.of(&kept.form)?;
        let Surface::Parametric(surface) = &whole else { return None };
        let own = surface.without_continuation()?;
        Some(Bordered { kept, profile, whole, own })
    }
}

impl Bordered<'_> {
    /// The place, where it is farther from the surface itself than `limit`.
    fn farther(&self, at: Vec3, limit: f64) -> Option<Far> {
        let away = (self.own.foot(at).point - at).norm();
        (away > limit).then_some(Far { at, away, limit })
    }

    /// The place of contact, where that is farther from the surface than the cutter's radius. All of the tool axis keeps off it likewise, by
    /// the radius there: a flank lies along more of a wall than one place.
    fn far(&self, pose: &Pose) -> Option<Far> {
        let tool = Tool { profile: &self.profile, te: pose.te, ta: pose.ta };
        let side = match (self.kept.side, self.kept.open) {
            (_, true) => Side::Open,
            (..0, _) => Side::Negative,
            _ => Side::Positive,
        };
        let place = match self.kept.side {
            0 => on(pose.te, &self.whole, side).surface_point,
            _ => gap(&tool, &self.whole, side, 0.0).ok()?.surface_point,
        };
        let beside = self.kept.thick.max(0.0) + self.kept.intol + self.kept.outtol;
        let radius = self.profile.half_diameter();
        let top = pose.te + pose.ta * self.profile.height();
        let place = self.farther(place, radius + beside)?;
        let end = self.farther(pose.te, radius + beside)?;
        let top = self.farther(top, self.profile.top_radius() + beside)?;
        self.between([end, top]).map(|_| place)
    }

    /// How far the places of contact are from the surface at least; `None` where one is not beyond.
    fn least(&self, poses: &[Pose]) -> Option<f64> {
        let places = poses.iter().map(|pose| self.far(pose)).collect::<Option<Vec<_>>>()?;
        let least = places.iter().map(|place| place.away).fold(f64::INFINITY, f64::min);
        places.windows(2).try_fold(least, |least, ends| {
            self.between([ends[0], ends[1]]).map(|away| away.min(least))
        })
    }

    /// The least distance on the way from one place to another, where all are as far as they must. A distance changes by no more than
    /// the way is long.
    fn between(&self, ends: [Far; 2]) -> Option<f64> {
        let mut least = f64::INFINITY;
        let mut parts = vec![(ends, HALVINGS)];
        while let Some(([a, b], left)) = parts.pop() {
            least = least.min(a.away).min(b.away);
            if 0.5 * (a.away + b.away - (b.at - a.at).norm()) > a.limit.max(b.limit) {
                continue;
            }
            let left = left.checked_sub(1)?;
            let middle = self.farther(0.5 * (a.at + b.at), 0.5 * (a.limit + b.limit))?;
            parts.extend([([a, middle], left), ([middle, b], left)]);
        }
        Some(least)
    }
}
