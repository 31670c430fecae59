//! Curves of STEP, and the edges of faces along them.

use aptc_geometry::{Vec3, trig};
use ruststep::ast::{Parameter, Record};

use super::{Entities, count, list, of, place, real, reference, repeated, steps};
use crate::curve::Curve;

/// Curves that stand for others, within each other at most.
const DEPTH: usize = 8;
/// Places of an edge at least.
const PLACES: usize = 16;

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

fn direction(entities: &Entities<'_>, p: &Parameter) -> Option<Vec3> {
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
    pub(super) fn of(entities: &Entities<'_>, id: u64) -> Option<Self> {
        Self::within(entities, id, 0)
    }

    fn within(entities: &Entities<'_>, id: u64, depth: usize) -> Option<Self> {
        let records = *entities.get(&id)?;
        if depth > DEPTH {
            return None;
        }
        for name in ["SURFACE_CURVE", "SEAM_CURVE", "INTERSECTION_CURVE", "TRIMMED_CURVE"] {
            if let Some(all) = of(records, name) {
                return Self::within(entities, reference(all.get(1)?)?, depth + 1);
            }
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
            let places = list(all.get(1)?)?
                .iter()
                .map(|p| point(entities, p))
                .collect::<Option<Vec<_>>>()?;
            return Curve::through(&places).map(Self::Spline);
        }
        spline(entities, records).map(Self::Spline)
    }

    /// Places from one place of it to another, in its sense; all round where both are the same.
    fn between(&self, [from, to]: [Vec3; 2], closed: bool) -> Vec<Vec3> {
        match self {
            Self::Line { .. } => even(|t| from + (to - from) * t),
            Self::Ellipse { frame, half } => {
                let angle = |p: Vec3| {
                    let own = frame.own(p);
                    trig::atan2(own.y / half[1], own.x / half[0])
                };
                let (a, b) = (angle(from), angle(to));
                let round = core::f64::consts::TAU;
                let by = if closed {
                    round
                } else {
                    let by = b - a;
                    if by <= 0.0 { by + round } else { by }
                };
                even(|t| {
                    let (s, c) = trig::sin_cos(a + by * t);
                    frame.origin + frame.x * (half[0] * c) + frame.y * (half[1] * s)
                })
            }
            Self::Spline(curve) => {
                let all = curve.places();
                let next = |p: Vec3| {
                    let far = |k: &usize| (all[*k] - p).norm();
                    (0..all.len()).min_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or(0)
                };
                let last = all.len() - 1;
                let (i, j) = if closed { (0, last) } else { (next(from), next(to)) };
                // Of a closed curve an end may be either.
                let round = (all[0] - all[last]).norm() <= 1e-9 * all[0].norm().max(1.0);
                let mut out = vec![from];
                if i <= j {
                    out.extend_from_slice(&all[i..=j]);
                } else if round && i == last {
                    out.extend_from_slice(&all[..=j]);
                } else if round && j == 0 {
                    out.extend_from_slice(&all[i..]);
                } else if round {
                    out.extend_from_slice(&all[i..]);
                    out.extend_from_slice(&all[..=j]);
                }
                out.push(to);
                out
            }
        }
    }
}

fn even(place: impl Fn(f64) -> Vec3) -> Vec<Vec3> {
    (0..=PLACES).map(|k| place(k as f64 / PLACES as f64)).collect()
}

/// A B-spline curve, rational or not, with its knots or with implied ones.
fn spline(entities: &Entities<'_>, records: &[Record]) -> Option<Curve> {
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

/// Places along an oriented edge, both ends among them.
pub(super) fn edge(entities: &Entities<'_>, p: &Parameter) -> Option<Vec<Vec3>> {
    let oriented = single(entities, reference(p)?, "ORIENTED_EDGE")?;
    let curve = single(entities, reference(oriented.get(3)?)?, "EDGE_CURVE")?;
    let vertex = |k: usize| {
        let v = single(entities, reference(curve.get(k)?)?, "VERTEX_POINT")?;
        point(entities, v.get(1)?)
    };
    let shape = Shape::of(entities, reference(curve.get(3)?)?)?;
    let ends = [vertex(1)?, vertex(2)?];
    let (along, forward) = (flag(curve.get(4)?)?, flag(oriented.get(4)?)?);
    let closed = reference(curve.get(1)?) == reference(curve.get(2)?) || ends[0] == ends[1];
    let mut places = shape.between(if along { ends } else { [ends[1], ends[0]] }, closed);
    if along != forward {
        places.reverse();
    }
    Some(places)
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
