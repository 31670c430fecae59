//! Curves of STEP.

use aptc_geometry::Vec3;
use ruststep::ast::{Parameter, Record};

use super::{Entities, count, list, of, place, real, reference, repeated, steps};
use crate::Limits;
use crate::curve::Curve;

/// Curves that stand for others, within each other at most.
const DEPTH: usize = 8;

/// An origin with three unit directions square to each other.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    pub(crate) origin: Vec3,
    pub(crate) x: Vec3,
    pub(crate) y: Vec3,
    pub(crate) z: Vec3,
}

impl Frame {
    /// Coordinates of a place.
    pub(super) fn own(&self, p: Vec3) -> Vec3 {
        let w = p - self.origin;
        Vec3::new(w.dot(&self.x), w.dot(&self.y), w.dot(&self.z))
    }
}

/// The parameters of an entity that is a single record of that name.
pub(super) fn single<'x>(entities: &Entities<'x>, id: u64, name: &str) -> Option<&'x [Parameter]> {
    of(entities.get(&id)?, name)
}

pub(super) fn point(entities: &Entities<'_>, p: &Parameter) -> Option<Vec3> {
    place(entities, reference(p)?).map(Vec3::from)
}

pub(super) fn direction(entities: &Entities<'_>, p: &Parameter) -> Option<Vec3> {
    let all = single(entities, reference(p)?, "DIRECTION")?;
    let [x, y, z] = list(all.get(1)?)? else { return None };
    Vec3::new(real(x)?, real(y)?, real(z)?).try_normalize(0.0)
}

/// A vector with its length.
pub(super) fn vector(entities: &Entities<'_>, p: &Parameter) -> Option<Vec3> {
    let all = single(entities, reference(p)?, "VECTOR")?;
    Some(direction(entities, all.get(1)?)? * real(all.get(2)?)?)
}

/// AXIS2_PLACEMENT_3D; what it leaves out is z, and the direction nearest to x.
pub(super) fn frame(entities: &Entities<'_>, p: &Parameter) -> Option<Frame> {
    let all = single(entities, reference(p)?, "AXIS2_PLACEMENT_3D")?;
    let origin = point(entities, all.get(1)?)?;
    let z = all.get(2).and_then(|p| direction(entities, p)).unwrap_or_else(Vec3::z);
    let toward = all.get(3).and_then(|p| direction(entities, p));
    let square = |w: Vec3| (w - z * w.dot(&z)).try_normalize(1e-9);
    let x = toward.and_then(square).or_else(|| square(Vec3::x())).or_else(|| square(Vec3::y()))?;
    Some(Frame { origin, x, y: z.cross(&x), z })
}

/// AXIS1_PLACEMENT: a point and a unit direction.
pub(super) fn axis(entities: &Entities<'_>, p: &Parameter) -> Option<(Vec3, Vec3)> {
    let all = single(entities, reference(p)?, "AXIS1_PLACEMENT")?;
    let z = all.get(2).and_then(|p| direction(entities, p)).unwrap_or_else(Vec3::z);
    Some((point(entities, all.get(1)?)?, z))
}

/// A curve that is read.
#[derive(Clone, Debug)]
pub(super) enum Shape {
    Line {
        point: Vec3,
        along: Vec3,
    },
    /// `origin + x cos a + y sin a`, of half axes along x and y of the frame.
    Ellipse {
        frame: Frame,
        half: [f64; 2],
    },
    Spline(Curve),
}

impl Shape {
    pub(super) fn of(entities: &Entities<'_>, id: u64, limits: &Limits) -> Option<Self> {
        Self::within(entities, id, limits, 0)
    }

    fn within(entities: &Entities<'_>, id: u64, limits: &Limits, depth: usize) -> Option<Self> {
        let records = *entities.get(&id)?;
        if depth > DEPTH {
            return None;
        }
        for name in ["SURFACE_CURVE", "SEAM_CURVE", "INTERSECTION_CURVE"] {
            if let Some(all) = of(records, name) {
                return Self::within(entities, reference(all.get(1)?)?, limits, depth + 1);
            }
        }
        // Its ends are those of the edge or face; its sense may be against the curve's.
        if let Some(all) = of(records, "TRIMMED_CURVE") {
            let basis = Self::within(entities, reference(all.get(1)?)?, limits, depth + 1)?;
            return Some(if flag(all.get(4)?)? { basis } else { basis.reversed() });
        }
        if let Some(all) = of(records, "LINE") {
            let (point, along) = (point(entities, all.get(1)?)?, vector(entities, all.get(2)?)?);
            return Some(Self::Line { point, along });
        }
        if let Some(all) = of(records, "CIRCLE") {
            let (frame, r) = (frame(entities, all.get(1)?)?, real(all.get(2)?)?);
            return Some(Self::Ellipse { frame, half: [r; 2] });
        }
        if let Some(all) = of(records, "ELLIPSE") {
            let half = [real(all.get(2)?)?, real(all.get(3)?)?];
            return Some(Self::Ellipse { frame: frame(entities, all.get(1)?)?, half });
        }
        if let Some(all) = of(records, "POLYLINE") {
            let places = list(all.get(1)?)?;
            let places = (places.len() <= limits.points).then_some(places)?;
            let places = places.iter().map(|p| point(entities, p)).collect::<Option<Vec<_>>>()?;
            return Curve::through(&places).map(Self::Spline);
        }
        spline(entities, records, limits).map(Self::Spline)
    }

    /// Run through the other way.
    fn reversed(self) -> Self {
        match self {
            Self::Line { point, along } => Self::Line { point, along: -along },
            Self::Ellipse { frame, half } => {
                let frame = Frame { y: -frame.y, z: -frame.z, ..frame };
                Self::Ellipse { frame, half }
            }
            Self::Spline(curve) => Self::Spline(curve.reversed()),
        }
    }
}

/// A B-spline curve, rational or not, with its knots or with implied ones.
fn spline(entities: &Entities<'_>, records: &[Record], limits: &Limits) -> Option<Curve> {
    const IMPLIED: [&str; 3] = ["BEZIER_CURVE", "UNIFORM_CURVE", "QUASI_UNIFORM_CURVE"];
    let (base, own) = match records {
        [one] => {
            let rest = list(&one.parameter)?.get(1..)?;
            match one.name.as_str() {
                "B_SPLINE_CURVE_WITH_KNOTS" => (rest, rest.get(5..)),
                name if IMPLIED.contains(&name) => (rest, None),
                _ => return None,
            }
        }
        many => (of(many, "B_SPLINE_CURVE")?, of(many, "B_SPLINE_CURVE_WITH_KNOTS")),
    };
    let (degree, points) = (count(base.first()?)?, list(base.get(1)?)?);
    if points.len() > limits.points {
        return None;
    }
    let weights = of(records, "RATIONAL_B_SPLINE_CURVE").and_then(|w| list(w.first()?));
    let mut all = Vec::with_capacity(points.len());
    for (k, p) in points.iter().enumerate() {
        let w = match weights {
            Some(weights) => real(weights.get(k)?)?,
            None => 1.0,
        };
        let p = point(entities, p)?;
        all.push([p.x, p.y, p.z, w]);
    }
    let n = all.len();
    let knots = match own {
        Some([times, knots, ..]) => repeated(times, knots, n)?,
        Some(_) => return None,
        None => {
            let is = |name: &str| records.iter().any(|r| r.name == name);
            steps(degree, n, is("UNIFORM_CURVE"), is("BEZIER_CURVE"))?
        }
    };
    Curve::new(degree, knots, &all, None)
}

/// A truth value.
pub(super) fn flag(p: &Parameter) -> Option<bool> {
    match p {
        Parameter::Enumeration(e) => match e.as_str() {
            "T" | "TRUE" => Some(true),
            "F" | "FALSE" => Some(false),
            _ => None,
        },
        _ => None,
    }
}
