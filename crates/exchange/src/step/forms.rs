//! Surfaces of STEP by their parameters: what a place has for parameters, and the exact patch over a box of them.

use core::f64::consts::{FRAC_PI_2, TAU};

use aptc_geometry::sculpt::{self, Layout, Sculptured, nearest_on};
use aptc_geometry::sculptured::BsplineSurface;
use aptc_geometry::{Vec3, trig};

use super::curves::{Frame, Shape, axis, frame, vector};
use super::{Entities, real, reference, surface};
use crate::Limits;
use crate::border::Border;
use crate::curve::{Axis, Chain, Curve};

/// Surfaces that are read when a face bounds them.
pub(super) const NAMES: [&str; 7] = [
    "PLANE",
    "CYLINDRICAL_SURFACE",
    "CONICAL_SURFACE",
    "SPHERICAL_SURFACE",
    "TOROIDAL_SURFACE",
    "SURFACE_OF_REVOLUTION",
    "SURFACE_OF_LINEAR_EXTRUSION",
];

/// Parts of a curve at which the place nearest to a point is looked for, and steps that make it exact.
const PARTS: usize = 64;
const THIRDS: usize = 30;
const NEWTONS: usize = 6;

/// A surface with parameters u and v; du x dv points where STEP has its normal.
pub(crate) enum Form {
    /// x and y.
    Plane(Frame),
    /// Angle and height, with the radius there; `slope` is what it grows by with the height.
    Cone { frame: Frame, radius: f64, slope: f64 },
    /// Longitude and latitude.
    Sphere { frame: Frame, radius: f64 },
    /// Both angles.
    Torus { frame: Frame, radii: [f64; 2] },
    /// Angle, and the parameter of the curve.
    Turned { axis: Axis, curve: Curve },
    /// The parameter of the curve, and the share of the vector.
    Moved { curve: Curve, by: Vec3 },
    /// Its own parameters.
    Spline { surface: Box<BsplineSurface>, fitted: Box<Sculptured>, borders: [Vec<f64>; 2] },
}

impl Form {
    /// The surface of an entity; `None` when it is of another kind or broken. `angle` is the file's unit in radians.
    pub(super) fn of(
        entities: &Entities<'_>,
        id: u64,
        angle: f64,
        limits: &Limits,
    ) -> Option<Self> {
        let records = *entities.get(&id)?;
        if let Ok(Some(own)) = surface(entities, id, records, limits) {
            return Self::spline(own);
        }
        let [one] = records else { return None };
        let all = super::list(&one.parameter)?;
        let frame = || frame(entities, all.get(1)?);
        let number = |k: usize| real(all.get(k)?);
        let curve = |k: usize| Shape::of(entities, reference(all.get(k)?)?);
        Some(match one.name.as_str() {
            "PLANE" => Self::Plane(frame()?),
            "CYLINDRICAL_SURFACE" => Self::Cone { frame: frame()?, radius: number(2)?, slope: 0.0 },
            "CONICAL_SURFACE" => {
                let slope = trig::tan(number(3)? * angle);
                Self::Cone { frame: frame()?, radius: number(2)?, slope }
            }
            "SPHERICAL_SURFACE" => Self::Sphere { frame: frame()?, radius: number(2)? },
            "TOROIDAL_SURFACE" => Self::Torus { frame: frame()?, radii: [number(2)?, number(3)?] },
            "SURFACE_OF_REVOLUTION" => {
                let (point, z) = axis(entities, all.get(2)?)?;
                Self::turned(curve(1)?, Axis { point, z })?
            }
            "SURFACE_OF_LINEAR_EXTRUSION" => {
                Self::moved(curve(1)?, vector(entities, all.get(2)?)?)?
            }
            _ => return None,
        })
    }

    pub(crate) fn spline(own: BsplineSurface) -> Option<Self> {
        let (fitted, _) = sculpt::bspline(&own).ok()?;
        let borders = [0, 1].map(|k| {
            let (p, n) = (own.degree[k], own.counts[k]);
            let mut all = own.knots[k][p..=n].to_vec();
            all.dedup();
            all
        });
        Some(Self::Spline { surface: Box::new(own), fitted: Box::new(fitted), borders })
    }

    /// A line that is turned is a cylinder or a cone, or a plane.
    fn turned(shape: Shape, axis: Axis) -> Option<Self> {
        match shape {
            Shape::Line { point, along } => {
                let w = point - axis.point;
                let rise = along.dot(&axis.z);
                let out = w - axis.z * w.dot(&axis.z);
                let side = along - axis.z * rise;
                // A line aside of the axis makes a hyperboloid.
                if rise.abs() <= 1e-9 * along.norm()
                    || out.cross(&side).norm() > 1e-9 * out.norm() * along.norm()
                {
                    return None;
                }
                let x = out.try_normalize(0.0).or_else(|| side.try_normalize(0.0))?;
                let frame = Frame {
                    origin: axis.point + axis.z * w.dot(&axis.z),
                    x,
                    y: axis.z.cross(&x),
                    z: axis.z,
                };
                Some(Self::Cone { frame, radius: out.norm(), slope: side.dot(&x) / rise })
            }
            shape => Some(Self::Turned { axis, curve: whole(shape)? }),
        }
    }

    fn moved(shape: Shape, by: Vec3) -> Option<Self> {
        match shape {
            Shape::Line { point, along } => {
                let z = along.cross(&by).try_normalize(0.0)?;
                let x = along.try_normalize(0.0)?;
                Some(Self::Plane(Frame { origin: point, x, y: z.cross(&x), z }))
            }
            shape => Some(Self::Moved { curve: whole(shape)?, by }),
        }
    }

    /// After how much a parameter comes back to the same place.
    pub(crate) fn periods(&self) -> [Option<f64>; 2] {
        match self {
            Self::Plane(_) => [None; 2],
            Self::Cone { .. } | Self::Sphere { .. } => [Some(TAU), None],
            Self::Torus { .. } => [Some(TAU); 2],
            Self::Turned { curve, .. } => [Some(TAU), closed(curve)],
            Self::Moved { curve, .. } => [closed(curve), None],
            Self::Spline { fitted, borders, .. } => {
                let ends = fitted.spans();
                let [nu, nv] = ends;
                let same = |a: [f64; 2], b: [f64; 2]| {
                    let [a, b] = [a, b].map(|p| fitted.at(p[0], p[1]).point);
                    (a - b).norm() <= 1e-7 * fitted.extent()
                };
                let u = (0..=4).all(|k| {
                    let v = nv * f64::from(k) / 4.0;
                    same([0.0, v], [nu, v])
                });
                let v = (0..=4).all(|k| {
                    let u = nu * f64::from(k) / 4.0;
                    same([u, 0.0], [u, nv])
                });
                let length = |k: usize| borders[k][borders[k].len() - 1] - borders[k][0];
                [u.then(|| length(0)), v.then(|| length(1))]
            }
        }
    }

    /// Ends of a parameter where it does not come back and has some: the pole or the tip, or the borders.
    pub(crate) fn ends(&self, k: usize) -> [Option<f64>; 2] {
        match self {
            Self::Sphere { .. } if k == 1 => [Some(-FRAC_PI_2), Some(FRAC_PI_2)],
            Self::Cone { radius, slope, .. } if k == 1 && *slope != 0.0 => {
                let tip = Some(-radius / slope);
                if *slope > 0.0 { [tip, None] } else { [None, tip] }
            }
            Self::Turned { curve, .. } if k == 1 => curve.range.map(Some),
            Self::Moved { curve, .. } if k == 0 => curve.range.map(Some),
            Self::Spline { borders, .. } => {
                [borders[k].first().copied(), borders[k].last().copied()]
            }
            _ => [None; 2],
        }
    }

    /// The parameters of a place; `None` for the one that is none there, at a pole or tip.
    pub(crate) fn parameters(&self, p: Vec3) -> [Option<f64>; 2] {
        let around = |own: Vec3, size: f64| {
            let far = trig::hypot(own.x, own.y);
            (far > 1e-9 * size).then(|| trig::atan2(own.y, own.x))
        };
        match self {
            Self::Plane(frame) => {
                let own = frame.own(p);
                [Some(own.x), Some(own.y)]
            }
            Self::Cone { frame, radius, .. } => {
                let own = frame.own(p);
                [around(own, radius.abs().max(own.z.abs())), Some(own.z)]
            }
            Self::Sphere { frame, radius } => {
                let own = frame.own(p);
                let up = trig::atan2(own.z, trig::hypot(own.x, own.y));
                [around(own, *radius), Some(up)]
            }
            Self::Torus { frame, radii } => {
                let own = frame.own(p);
                let out = trig::hypot(own.x, own.y) - radii[0];
                [around(own, radii[0]), Some(trig::atan2(own.z, out))]
            }
            Self::Turned { axis, curve } => {
                let flat = |q: Vec3| {
                    let w = q - axis.point;
                    let z = w.dot(&axis.z);
                    ((w - axis.z * z).norm(), z)
                };
                let (rho, z) = flat(p);
                let t = nearest(curve, |q| {
                    let (r, h) = flat(q);
                    Vec3::new(r - rho, h - z, 0.0)
                });
                let side = |q: Vec3| {
                    let w = q - axis.point;
                    w - axis.z * w.dot(&axis.z)
                };
                let (from, to) = (side(curve.at(t)), side(p));
                let turned = rho > 1e-9 * (rho.abs() + z.abs());
                let angle = trig::atan2(axis.z.dot(&from.cross(&to)), from.dot(&to));
                [turned.then_some(angle), Some(t)]
            }
            Self::Moved { curve, by } => {
                let unit = by / by.norm();
                let t = nearest(curve, |q| {
                    let w = p - q;
                    w - unit * w.dot(&unit)
                });
                [Some(t), Some((p - curve.at(t)).dot(by) / by.norm_squared())]
            }
            Self::Spline { fitted, borders, .. } => {
                let uv = nearest_on(fitted, p).uv;
                [0, 1].map(|k| Some(knot(fitted, &borders[k], k, uv[k])))
            }
        }
    }

    /// A border's box within the range that the surface has: ends that are about its own, or about borders of its spans, are
    /// those. Of a face across the seam of a closed surface all round is taken, which is not its box.
    pub(crate) fn within(&self, mut border: Border) -> Border {
        const ABOUT: f64 = 1e-6;
        for k in 0..2 {
            let Self::Spline { borders, .. } = self else { continue };
            let (low, high) = (borders[k][0], borders[k][borders[k].len() - 1]);
            let room = ABOUT * (high - low);
            if border.range[k][0] < low - room || border.range[k][1] > high + room {
                (border.range[k], border.whole) = ([low, high], false);
            }
            border.range[k] = border.range[k].map(|x| {
                let near = borders[k].iter().find(|b| (x - **b).abs() <= room);
                near.copied().unwrap_or(x)
            });
        }
        border
    }

    /// The exact patch over a box of the parameters.
    pub(crate) fn patch(&self, [u, v]: [[f64; 2]; 2]) -> BsplineSurface {
        let turned = |frame: &Frame, profile: &Chain| {
            profile.turned(&Axis { point: frame.origin, z: frame.z }, u)
        };
        match self {
            Self::Plane(frame) => {
                let at = |x: f64, y: f64| frame.origin + frame.x * x + frame.y * y;
                let by = frame.y * (v[1] - v[0]);
                Curve::line(at(u[0], v[0]), at(u[1], v[0])).chain().moved(by)
            }
            Self::Cone { frame, radius, slope } => {
                let at = |h: f64| frame.origin + frame.x * (radius + slope * h) + frame.z * h;
                turned(frame, &Curve::line(at(v[0]), at(v[1])).chain())
            }
            Self::Sphere { frame, radius } => {
                let arc = Curve::arc(frame.origin, frame.x * *radius, frame.z * *radius, v);
                turned(frame, &arc.chain())
            }
            Self::Torus { frame, radii: [large, small] } => {
                let middle = frame.origin + frame.x * *large;
                turned(frame, &Curve::arc(middle, frame.x * *small, frame.z * *small, v).chain())
            }
            Self::Turned { axis, curve } => part(curve, v).chain().turned(axis, u),
            Self::Moved { curve, by } => {
                let mut moved = part(curve, u).chain().moved(by * (v[1] - v[0]));
                for p in &mut moved.points {
                    for (x, d) in p.iter_mut().zip(by.iter()) {
                        *x += d * v[0];
                    }
                }
                moved
            }
            Self::Spline { surface, .. } => {
                let mut own = (**surface).clone();
                own.range = [Some(u), Some(v)];
                own
            }
        }
    }
}

/// A whole curve that ends; circles and ellipses all round.
fn whole(shape: Shape) -> Option<Curve> {
    match shape {
        Shape::Line { .. } => None,
        Shape::Ellipse { frame, half } => {
            Some(Curve::arc(frame.origin, frame.x * half[0], frame.y * half[1], [0.0, TAU]))
        }
        Shape::Spline(curve) => Some(curve),
    }
}

fn part(curve: &Curve, range: [f64; 2]) -> Curve {
    let mut own = curve.clone();
    own.range = range;
    own
}

/// The length of a closed curve's parameter.
fn closed(curve: &Curve) -> Option<f64> {
    let [from, to] = curve.range;
    let (a, b, c) = (curve.at(from), curve.at(to), curve.at(0.5 * (from + to)));
    ((a - b).norm() <= 1e-9 * (a - c).norm().max((b - c).norm())).then_some(to - from)
}

/// The parameter at which what a place of a curve is off is least.
fn nearest(curve: &Curve, off: impl Fn(Vec3) -> Vec3) -> f64 {
    let [from, to] = curve.range;
    let step = (to - from) / PARTS as f64;
    let at = |k: usize| if k == PARTS { to } else { from + step * k as f64 };
    let of = |t: f64| off(curve.at(t)).norm_squared();
    let best = (0..=PARTS).min_by(|a, b| of(at(*a)).total_cmp(&of(at(*b)))).unwrap_or(0);
    let (mut low, mut high) = (at(best.saturating_sub(1)), at((best + 1).min(PARTS)));
    for _ in 0..THIRDS {
        let third = (high - low) / 3.0;
        if of(low + third) <= of(high - third) {
            high -= third;
        } else {
            low += third;
        }
    }
    // The last digits by Gauss and Newton: what is off at a place of the curve is nothing.
    let mut t = 0.5 * (low + high);
    let h = 1e-4 * step;
    for _ in 0..NEWTONS {
        let rate = (off(curve.at((t + h).min(to))) - off(curve.at((t - h).max(from))))
            / ((t + h).min(to) - (t - h).max(from));
        let by = off(curve.at(t)).dot(&rate) / rate.norm_squared();
        if !by.is_finite() {
            break;
        }
        t = (t - by).clamp(from, to);
    }
    // Ends are hit exactly.
    [from, to, at(best), t].into_iter().min_by(|a, b| of(*a).total_cmp(&of(*b))).unwrap_or(t)
}

/// A parameter of the fitted surface as one of the knots: spans between them count as one each.
fn knot(fitted: &Sculptured, borders: &[f64], k: usize, at: f64) -> f64 {
    let spans = borders.len() - 1;
    let last = match &fitted.layout {
        Layout::Mesh { u, v } => [u, v][k].last().copied().unwrap_or(1.0),
        Layout::Patches => 1.0,
    };
    // Parameters of the whole run over 0 to the number of spans.
    let x = (at * spans as f64 / last).clamp(0.0, spans as f64);
    let span = (0..spans).rev().find(|i| *i as f64 <= x).unwrap_or(0);
    let share = x - span as f64;
    borders[span] * (1.0 - share) + borders[span + 1] * share
}
