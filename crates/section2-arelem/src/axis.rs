//! The tool axis in multi-axis work (APT: `TLAXIS`).

use aptc_contact::{Condition, Gap};
use aptc_geometry::{Shape, Surface, Vec3, trig};
use aptc_protap::{AxisAngle, OptionSurface, ToolAxis};

use crate::space::Keep;
use crate::state::unit;

/// Sine of the lean of an axis that counts as upright.
pub(crate) const UPRIGHT: f64 = 1e-6;
/// Degrees that count as none: the edge of a flat end rises by 2e-11 of its radius.
const LEVEL_DEG: f64 = 1e-9;

/// How the axis follows from the contacts.
#[derive(Clone, Debug)]
pub(crate) enum AxisRule {
    /// It stays.
    Fixed,
    /// Along the normal of the part or drive surface.
    Normal(OptionSurface),
    /// Along the rulings.
    Rulings(OptionSurface),
    /// At an angle to the normal.
    Angle(AxisAngle, Came),
    /// The same square to the reference of the angle, of the two such axes always the one that a motion began with: +1 or -1 for
    /// where it is from the normal about the reference.
    InPlane(AxisAngle, f64),
    /// Square to a direction.
    Square(Vec3),
}

/// On which side of the surface that does not control the axis the tool was before its end came to lie on it.
/// An angle leans the axis away from such a surface when the cutter is at it. When the tool end is on it the axis leans
/// to the side to which it leans already, and an upright one onwards in a GO, along the normal in a motion. Source: what
/// APT-360 does, by trial.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Came {
    /// Where the surface's normals point.
    Front,
    Back,
    /// It was there already.
    There,
}

impl Came {
    /// From the distance before, or less the way there.
    pub(crate) fn from(distance: f64, near: f64) -> Self {
        if distance > near {
            Self::Front
        } else if distance < -near {
            Self::Back
        } else {
            Self::There
        }
    }

    /// The sign of the normal that points onwards.
    pub(crate) fn onwards(self) -> f64 {
        if self == Self::Front { -1.0 } else { 1.0 }
    }

    /// The sign of the normal that points to where the tool came from.
    pub(crate) fn home(self) -> f64 {
        if self == Self::Back { -1.0 } else { 1.0 }
    }
}

/// How an axis turns with the tool end.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Turn {
    /// By a symmetrical form in the tangent plane.
    Even(Shape),
    /// By the first vector, times the product of the way with the second.
    Alike([Vec3; 2]),
}

impl Turn {
    /// How fast the product of the axis with `v` rises with the tool end.
    pub(crate) fn gradient(&self, v: Vec3) -> Vec3 {
        match self {
            Self::Even(shape) => shape.apply(v),
            Self::Alike([by, way]) => way * by.dot(&v),
        }
    }
}

/// The contacts at a place.
pub(crate) struct Around<'a> {
    /// The tool end.
    pub(crate) te: Vec3,
    /// The axis as it is.
    pub(crate) ta: Vec3,
    pub(crate) part: &'a Gap,
    pub(crate) drive: &'a Gap,
    /// Direction of motion.
    pub(crate) along: Vec3,
}

impl AxisRule {
    pub(crate) fn of(axis: &ToolAxis) -> Self {
        match axis {
            ToolAxis::NormPs => Self::Normal(OptionSurface::Part),
            ToolAxis::NormDs => Self::Normal(OptionSurface::Drive),
            ToolAxis::Parallel { surface, .. } => Self::Rulings(*surface),
            // A flat end on a dome stands along the normal wherever on the end it touches: of all these it is the middle, as in
            // APT-360.
            ToolAxis::Angle(a) if upright(a) => Self::Normal(a.surface),
            ToolAxis::Angle(a) => Self::Angle(a.clone(), Came::There),
            ToolAxis::PerpTo(v) => Self::Square(*v),
            _ => Self::Fixed,
        }
    }

    /// Does it change along a path?
    pub(crate) fn turns(&self) -> bool {
        !matches!(self, Self::Fixed)
    }

    /// The axis that the place of the tool end alone tells, as with NORMPS and NORMDS and along the rulings of a RLDSRF, and how
    /// it changes with it. `None` for other rules and where the surface has no curvature.
    pub(crate) fn by_place(&self, te: Vec3, ta: Vec3, keeps: [&Keep; 2]) -> Option<(Vec3, Turn)> {
        let keep = match self {
            Self::Normal(OptionSurface::Part) | Self::Rulings(OptionSurface::Part) => keeps[1],
            Self::Normal(OptionSurface::Drive) | Self::Rulings(OptionSurface::Drive) => keeps[0],
            _ => return None,
        };
        if matches!(self, Self::Rulings(_)) {
            return turning_ruling(keep, te, ta);
        }
        let foot = keep.surface.foot(te);
        let turned = match keep.condition {
            Condition::On => foot.normal.dot(&ta) < 0.0,
            Condition::Touch => keep.side.sign() < 0.0,
        };
        let shape = foot.shape.offset(foot.distance)?;
        if !shape.k.iter().all(|k| k.is_finite()) {
            return None;
        }
        let (ta, shape) =
            if turned { (-foot.normal, shape.reversed()) } else { (foot.normal, shape) };
        Some((ta, Turn::Even(shape)))
    }

    /// The surface that controls an angle, when there is one.
    pub(crate) fn angle_to(&self) -> Option<OptionSurface> {
        match self {
            Self::Angle(a, _) | Self::InPlane(a, _) => Some(a.surface),
            _ => None,
        }
    }

    /// The surface whose normal the axis follows, along it or at an angle.
    pub(crate) fn normal_of(&self) -> Option<OptionSurface> {
        match self {
            Self::Normal(s) => Some(*s),
            rule => rule.angle_to(),
        }
    }

    /// The same rule for a tool whose end came to the other surface from there.
    pub(crate) fn coming(&self, from: Came) -> Self {
        match self {
            Self::Angle(a, _) => Self::Angle(a.clone(), from),
            rule => rule.clone(),
        }
    }

    /// The same rule for a tool whose axis is `ta` and whose end lies on the other surface, with the normal `on`: as far as
    /// the axis leans across that surface its lean says the side, as in APT-360, which takes such a normal on the side of
    /// the axis wherever the tool came from and whatever direction is given.
    pub(crate) fn leaning(&self, ta: Vec3, on: Vec3) -> Self {
        let Self::Angle(a, came) = self else { return self.clone() };
        match Came::from(-ta.dot(&on) * a.angle_deg.signum(), UPRIGHT) {
            Came::There => Self::Angle(a.clone(), *came),
            lean => Self::Angle(a.clone(), lean),
        }
    }

    /// The same rule for all of a motion that begins there: where the plane square to the reference nearly holds the motion the side
    /// that the sign of the angle says would change with each bend.
    pub(crate) fn begun(self, around: &Around<'_>, keeps: [&Keep; 2]) -> Self {
        /// Sine of a lean from the normal that is rounding.
        const EVEN: f64 = 1e-9;
        let Self::Angle(a, _) = &self else { return self };
        let sense = || {
            let (v, ta) = (unit(a.reference?)?, self.at(around, keeps)?);
            let (gap, keep) = match a.surface {
                OptionSurface::Part => (around.part, keeps[1]),
                OptionSurface::Drive => (around.drive, keeps[0]),
            };
            let sense = v.cross(&outward(gap, keep, around.ta)).dot(&ta);
            (sense.abs() > EVEN).then(|| sense.signum())
        };
        match sense() {
            Some(sense) => Self::InPlane(a.clone(), sense),
            None => self,
        }
    }

    /// The axis at a place; `None` when the conditions contradict each other. `keeps` are drive and part.
    pub(crate) fn at(&self, around: &Around<'_>, keeps: [&Keep; 2]) -> Option<Vec3> {
        let pick = |s: OptionSurface| match s {
            OptionSurface::Part => (around.part, around.drive, keeps[1]),
            OptionSurface::Drive => (around.drive, around.part, keeps[0]),
        };
        match self {
            Self::Fixed => Some(around.ta),
            Self::Normal(s) => {
                let (gap, _, keep) = pick(*s);
                Some(below(gap, keep, around))
            }
            Self::Rulings(s) => {
                let (gap, _, keep) = pick(*s);
                ruling(gap, keep, around)
            }
            Self::Angle(a, came) => {
                let (gap, other, keep) = pick(a.surface);
                let n = outward(gap, keep, around.ta);
                let sign = if other.segment.is_none() { came.onwards() } else { 1.0 };
                lean(a, n, other.normal * sign, around.along)
            }
            Self::InPlane(a, sense) => {
                let (gap, _, keep) = pick(a.surface);
                let (u, w, [c, s]) =
                    in_plane(a.angle_deg, outward(gap, keep, around.ta), unit(a.reference?)?)?;
                unit(u * c + w * (s * sense))
            }
            Self::Square(v) => {
                let v = unit(*v)?;
                unit(around.ta - v * around.ta.dot(&v))
            }
        }
    }
}

/// Is it the normal itself, with no lean along the motion and no plane to stay in?
fn upright(a: &AxisAngle) -> bool {
    let level = |deg: f64| deg.abs() <= LEVEL_DEG;
    level(a.angle_deg) && a.cutting_deg.is_none_or(level) && a.reference.is_none()
}

/// The normal on the side of the tool: away from the surface when the cutter touches it, on the side of the
/// axis as it is when the tool end lies on it.
fn outward(gap: &Gap, keep: &Keep, ta: Vec3) -> Vec3 {
    if keep.condition == Condition::On && gap.normal.dot(&ta) < 0.0 {
        -gap.normal
    } else {
        gap.normal
    }
}

/// The normal through the tool end. A cutter upright on a surface touches there; its flat end touches a dome
/// there and anywhere else on the end, and a hollow all round with its edge, where no normal is the axis.
fn below(gap: &Gap, keep: &Keep, around: &Around<'_>) -> Vec3 {
    match keep.condition {
        Condition::On => outward(gap, keep, around.ta),
        Condition::Touch => keep.surface.foot(around.te).normal * keep.side.sign(),
    }
}

/// The ruling along which the flank lies, towards where the axis points. Rulings that are twisted have none: a flank along
/// one of them cuts in at its ends. Beside the middle of a flank upon the ruling below the tool end it does so least.
fn ruling(gap: &Gap, keep: &Keep, around: &Around<'_>) -> Option<Vec3> {
    let ruling =
        |p: Vec3| keep.surface.ruling(p).map(|r| if r.dot(&around.ta) < 0.0 { -r } else { r });
    if keep.condition == Condition::On || !matches!(keep.surface, Surface::Parametric(_)) {
        // A flank that reaches beyond the vertex of a cone may touch there, where all rulings meet.
        return ruling(gap.surface_point).or_else(|| ruling(around.te));
    }
    let [_, [_, upper]] = keep.profile.joints();
    let below = ruling(around.te)?;
    ruling(around.te + below * (0.5 * (upper + keep.profile.height()))).or(Some(below))
}

/// What [`ruling`] finds beside a ruled surface, and how it turns with the tool end.
fn turning_ruling(keep: &Keep, te: Vec3, ta: Vec3) -> Option<(Vec3, Turn)> {
    let Surface::Parametric(surface) = &keep.surface else { return None };
    if keep.condition == Condition::On {
        return None;
    }
    let at = |p: Vec3| {
        let (along, [turn, way]) = surface.turning_ruling(p)?;
        let sign = if along.dot(&ta) < 0.0 { -1.0 } else { 1.0 };
        Some((along * sign, turn * sign, way))
    };
    let [_, [_, upper]] = keep.profile.joints();
    let middle = 0.5 * (upper + keep.profile.height());
    let (below, lean, first) = at(te)?;
    let (along, turn, way) = at(te + below * middle)?;
    // The place beside the middle of the flank goes as the tool end does, and with the ruling below that.
    Some((along, Turn::Alike([turn, way + first * (middle * way.dot(&lean))])))
}

/// The axis at the angle alpha to the normal `n`, positive towards the normal `other` of the surface that
/// does not control it; with CUTANG leaning by beta along the motion, with a vector square to it.
fn lean(a: &AxisAngle, n: Vec3, other: Vec3, along: Vec3) -> Option<Vec3> {
    let (sin, cos) = (trig::sin_deg(a.angle_deg), trig::cos_deg(a.angle_deg));
    let t = unit(along - n * along.dot(&n))?;
    let side = n.cross(&t);
    let m = if side.dot(&other) < 0.0 { -side } else { side };
    if let Some(v) = a.reference {
        let (u, w, [c, s]) = in_plane(a.angle_deg, n, unit(v)?)?;
        // Of the two the one on the side that the sign says; where the plane holds the motion, along it.
        let towards = if w.dot(&m).abs() > 1e-6 { m } else { t };
        let sign = if (w.dot(&towards) >= 0.0) == (a.angle_deg >= 0.0) { 1.0 } else { -1.0 };
        return unit(u * c + w * (s * sign));
    }
    let lead = a.cutting_deg.map_or(0.0, trig::sin_deg);
    let rest = sin * sin - lead * lead;
    if rest < -1e-12 {
        return None;
    }
    let across = rest.max(0.0).sqrt() * if a.angle_deg < 0.0 { -1.0 } else { 1.0 };
    unit(n * cos + t * lead + m * across)
}

/// The two axes square to `v` that make the angle with `n`: the part of `n` square to `v` and a direction across both, with cosine and
/// sine of the turn between that part and the axes.
fn in_plane(angle_deg: f64, n: Vec3, v: Vec3) -> Option<(Vec3, Vec3, [f64; 2])> {
    let cos = trig::cos_deg(angle_deg);
    let flat = n - v * n.dot(&v);
    let size = flat.norm();
    if size < cos.abs() - 1e-12 || size <= 1e-9 {
        return None;
    }
    let u = flat / size;
    let w = v.cross(&u);
    let c = (cos / size).clamp(-1.0, 1.0);
    let s = ((1.0 - c) * (1.0 + c)).max(0.0).sqrt();
    Some((u, w, [c, s]))
}
