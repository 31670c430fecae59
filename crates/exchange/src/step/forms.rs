//! Surfaces of STEP by their parameters: what a place has for parameters, and the exact patch over a box of them.

use core::cell::Cell;
use core::f64::consts::{FRAC_PI_2, TAU};

use aptc_geometry::sculpt::{self, BsplineFault, Layout, Sculptured, nearest_from, nearest_on};
use aptc_geometry::sculptured::BsplineSurface;
use aptc_geometry::{Vec3, trig};

use super::curves::{Frame, Shape, axis, frame, vector};
use super::{Entities, real, reference};
use crate::Limits;
use crate::border::{Border, Plane};
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

/// A place nearer to a pole or tip than this share of the surface's size is there.
const POLE: f64 = 1e-6;

/// A surface with parameters u and v; du x dv points where STEP has its normal.
pub(crate) enum Form {
    /// x and y.
    Plane(Frame),
    /// Angle and height, with the radius there; `slope` is what it grows by with the height, and `up` is -1 where the height
    /// counts against z.
    Cone { frame: Frame, radius: f64, slope: f64, up: f64 },
    /// Longitude and latitude.
    Sphere { frame: Frame, radius: f64 },
    /// Both angles.
    Torus { frame: Frame, radii: [f64; 2] },
    /// Angle, and the parameter of the curve.
    Turned { axis: Axis, curve: Curve },
    /// The parameter of the curve, and the share of the vector.
    Moved { curve: Curve, by: Vec3 },
    /// Its own parameters.
    Spline(Box<Spline>),
}

/// A B-spline surface with what is asked of it often.
pub(crate) struct Spline {
    surface: BsplineSurface,
    fitted: Sculptured,
    /// Both ends of each parameter, and knots between.
    borders: [Vec<f64>; 2],
    periods: [Option<f64>; 2],
    /// Points into which sides of the surface shrink: of each parameter at the ends of the other one.
    poles: [[Option<Vec3>; 2]; 2],
    /// The last place that was looked for: places of a border follow each other.
    last: Cell<Option<[f64; 2]>>,
}

impl Form {
    /// The surface of an entity; `None` when it is of another kind or broken. `angle` is the file's unit in radians, `own` the
    /// B-spline surface that it is.
    pub(super) fn of(
        entities: &Entities<'_>,
        id: u64,
        angle: f64,
        own: Option<&BsplineSurface>,
        limits: &Limits,
    ) -> Option<Self> {
        let records = *entities.get(&id)?;
        if let Some(own) = own {
            return Self::spline(own.clone()).ok();
        }
        let [one] = records else { return None };
        let all = super::list(&one.parameter)?;
        let frame = || frame(entities, all.get(1)?);
        let number = |k: usize| real(all.get(k)?);
        let radius = |k: usize| number(k).filter(|r| *r > 0.0);
        let curve = |k: usize| Shape::of(entities, reference(all.get(k)?)?, limits);
        Some(match one.name.as_str() {
            "PLANE" => Self::Plane(frame()?),
            "CYLINDRICAL_SURFACE" => {
                Self::Cone { frame: frame()?, radius: radius(2)?, slope: 0.0, up: 1.0 }
            }
            "CONICAL_SURFACE" => {
                let slope = trig::tan(number(3)? * angle);
                let radius = number(2).filter(|r| *r >= 0.0)?;
                Self::Cone { frame: frame()?, radius, slope, up: 1.0 }
            }
            "SPHERICAL_SURFACE" => Self::Sphere { frame: frame()?, radius: radius(2)? },
            "TOROIDAL_SURFACE" => Self::Torus { frame: frame()?, radii: [radius(2)?, radius(3)?] },
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

    pub(crate) fn spline(surface: BsplineSurface) -> Result<Self, BsplineFault> {
        let (fitted, _) = sculpt::bspline(&surface)?;
        let borders = [0, 1].map(|k| {
            let (p, n) = (surface.degree[k], surface.counts[k]);
            // The knots that the fitted surface counts.
            let all = &surface.knots[k][p..=n];
            let tiny = 1e-9 * (all[n - p] - all[0]);
            let mut borders: Vec<f64> =
                all.windows(2).filter(|w| w[1] - w[0] > tiny).map(|w| w[0]).collect();
            borders.push(all[n - p]);
            borders
        });
        let spans = fitted.spans();
        // Places at an end of the other parameter than the k-th.
        let side = |k: usize, end: usize| {
            [0, 1, 2, 3, 4].map(|i| {
                let mut uv = [spans[0] * end as f64, spans[1] * end as f64];
                uv[k] = spans[k] * f64::from(i) / 4.0;
                fitted.at(uv[0], uv[1]).point
            })
        };
        let (same, one) = (1e-7 * fitted.extent(), 1e-9 * fitted.extent());
        let periods = [0, 1].map(|k| {
            let (a, b) = (side(1 - k, 0), side(1 - k, 1));
            let closed = a.iter().zip(&b).all(|(a, b)| (a - b).norm() <= same);
            closed.then(|| borders[k][borders[k].len() - 1] - borders[k][0])
        });
        let poles = [0, 1].map(|k| {
            [0, 1].map(|end| {
                let all = side(k, end);
                all.iter().all(|p| (p - all[0]).norm() <= one).then_some(all[0])
            })
        });
        Ok(Self::Spline(Box::new(Spline {
            surface,
            fitted,
            borders,
            periods,
            poles,
            last: Cell::new(None),
        })))
    }

    /// A line that is turned is a cylinder or a cone, or a plane.
    fn turned(shape: Shape, axis: Axis) -> Option<Self> {
        match shape {
            Shape::Line { point, along } => {
                let w = point - axis.point;
                let rise = along.dot(&axis.z);
                let out = w - axis.z * w.dot(&axis.z);
                let side = along - axis.z * rise;
                let origin = axis.point + axis.z * w.dot(&axis.z);
                if rise.abs() <= 1e-9 * along.norm() {
                    // Turned to the left about z a line that leads outwards has its normal down.
                    let z = if out.dot(&side) < 0.0 { axis.z } else { -axis.z };
                    let x = side.try_normalize(0.0)?;
                    return Some(Self::Plane(Frame { origin, x, y: z.cross(&x), z }));
                }
                // A line aside of the axis makes a hyperboloid.
                if out.cross(&side).norm() > 1e-9 * out.norm() * along.norm() {
                    return None;
                }
                let x = out.try_normalize(0.0).or_else(|| side.try_normalize(0.0))?;
                let frame = Frame { origin, x, y: axis.z.cross(&x), z: axis.z };
                let (slope, up) = (side.dot(&x) / rise.abs(), rise.signum());
                Some(Self::Cone { frame, radius: out.norm(), slope, up })
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

    /// Periods and ends of the parameters.
    pub(crate) fn plane(&self) -> Plane {
        Plane { periods: self.periods(), ends: [self.ends(0), self.ends(1)] }
    }

    fn periods(&self) -> [Option<f64>; 2] {
        match self {
            Self::Plane(_) => [None; 2],
            Self::Cone { .. } | Self::Sphere { .. } => [Some(TAU), None],
            Self::Torus { .. } => [Some(TAU); 2],
            Self::Turned { curve, .. } => [Some(TAU), curve.period()],
            Self::Moved { curve, .. } => [curve.period(), None],
            Self::Spline(s) => s.periods,
        }
    }

    fn ends(&self, k: usize) -> [Option<f64>; 2] {
        match self {
            Self::Sphere { .. } if k == 1 => [Some(-FRAC_PI_2), Some(FRAC_PI_2)],
            Self::Cone { radius, slope, .. } if k == 1 && *slope != 0.0 => {
                let tip = Some(-radius / slope);
                if *slope > 0.0 { [tip, None] } else { [None, tip] }
            }
            Self::Turned { curve, .. } if k == 1 => curve.range.map(Some),
            Self::Moved { curve, .. } if k == 0 => curve.range.map(Some),
            Self::Spline(s) => [s.borders[k].first().copied(), s.borders[k].last().copied()],
            _ => [None; 2],
        }
    }

    /// What the parameters of a place take, as a number of evaluations of a curve.
    pub(crate) fn cost(&self) -> u64 {
        match self {
            Self::Turned { curve, .. } | Self::Moved { curve, .. } => {
                curve.spans() as u64 * 2 + 400
            }
            Self::Spline(s) => s.fitted.patches.len() as u64 / 10 + 400,
            _ => 1,
        }
    }

    /// The place of parameters.
    pub(crate) fn at(&self, [u, v]: [f64; 2]) -> Vec3 {
        let about = |frame: &Frame, r: f64, z: f64| {
            let (s, c) = trig::sin_cos(u);
            frame.origin + (frame.x * c + frame.y * s) * r + frame.z * z
        };
        match self {
            Self::Plane(frame) => frame.origin + frame.x * u + frame.y * v,
            Self::Cone { frame, radius, slope, up } => about(frame, radius + slope * v, up * v),
            Self::Sphere { frame, radius } => {
                let (s, c) = trig::sin_cos(v);
                about(frame, radius * c, radius * s)
            }
            Self::Torus { frame, radii } => {
                let (s, c) = trig::sin_cos(v);
                about(frame, radii[0] + radii[1] * c, radii[1] * s)
            }
            Self::Turned { axis, curve } => {
                let p = around(curve, v);
                let foot = axis.point + axis.z * (p - axis.point).dot(&axis.z);
                let (s, c) = trig::sin_cos(u);
                foot + (p - foot) * c + axis.z.cross(&(p - foot)) * s
            }
            Self::Moved { curve, by } => around(curve, u) + by * v,
            Self::Spline(own) => {
                let [u, v] = [0, 1].map(|k| own.fitted_at(k, [u, v][k]));
                own.fitted.at(u, v).point
            }
        }
    }

    /// The parameters of a place; `None` for the one that is none there, at a pole or tip.
    pub(crate) fn parameters(&self, p: Vec3) -> [Option<f64>; 2] {
        let around = |own: Vec3, size: f64| {
            let far = trig::hypot(own.x, own.y);
            (far > POLE * size).then(|| trig::atan2(own.y, own.x))
        };
        match self {
            Self::Plane(frame) => {
                let own = frame.own(p);
                [Some(own.x), Some(own.y)]
            }
            Self::Cone { frame, radius, slope, up } => {
                let own = frame.own(p);
                let height = up * own.z;
                // Beyond the tip it is on the other side of the axis.
                let other = radius + slope * height < 0.0;
                let turned = if other { -own } else { own };
                [around(turned, radius.abs().max((slope * height).abs())), Some(height)]
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
                let t = curve.nearest(|q| {
                    let (r, h) = flat(q);
                    Vec3::new(r - rho, h - z, 0.0)
                });
                let side = |q: Vec3| {
                    let w = q - axis.point;
                    w - axis.z * w.dot(&axis.z)
                };
                let (from, to) = (side(curve.at(t)), side(p));
                let turned = rho > POLE * (curve.extent() + (curve.at(t) - axis.point).norm());
                let angle = trig::atan2(axis.z.dot(&from.cross(&to)), from.dot(&to));
                [turned.then_some(angle), Some(t)]
            }
            Self::Moved { curve, by } => {
                let unit = by / by.norm();
                let t = curve.nearest(|q| {
                    let w = p - q;
                    w - unit * w.dot(&unit)
                });
                [Some(t), Some((p - curve.at(t)).dot(by) / by.norm_squared())]
            }
            Self::Spline(s) => {
                let near = |q: &Vec3| (p - q).norm() <= POLE * s.fitted.extent();
                for k in 0..2 {
                    let end = s.poles[k].iter().position(|q| q.as_ref().is_some_and(near));
                    if let Some(end) = end {
                        let mut own = [None; 2];
                        own[1 - k] = self.ends(1 - k)[end];
                        return own;
                    }
                }
                let uv = s.near(p);
                [0, 1].map(|k| Some(s.knot(k, uv[k])))
            }
        }
    }

    /// A border's box within the range that the surface has: of a B-spline surface ends that are about its own, or about borders of
    /// its spans, are those, and of a face across its seam all round is taken, which is not its box.
    pub(crate) fn within(&self, mut border: Border) -> Border {
        const ABOUT: f64 = 1e-6;
        let Self::Spline(s) = self else { return border };
        for k in 0..2 {
            let borders = &s.borders[k];
            let (low, high) = (borders[0], borders[borders.len() - 1]);
            let room = ABOUT * (high - low);
            if border.range[k][0] < low - room || border.range[k][1] > high + room {
                (border.range[k], border.whole) = ([low, high], false);
            }
            border.range[k] = border.range[k].map(|x| {
                let near = borders.iter().find(|b| (x - **b).abs() <= room);
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
            Self::Cone { frame, radius, slope, up } => {
                let at =
                    |h: f64| frame.origin + frame.x * (radius + slope * h) + frame.z * (up * h);
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
            Self::Turned { axis, curve } => curve.part(v).turned(axis, u),
            Self::Moved { curve, by } => {
                let mut moved = curve.part(u).moved(by * (v[1] - v[0]));
                for p in &mut moved.points {
                    for (x, d) in p.iter_mut().zip(by.iter()) {
                        *x += d * v[0];
                    }
                }
                moved
            }
            Self::Spline(s) => {
                let mut own = s.surface.clone();
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

/// A place of a curve, of a closed one also beyond its ends.
fn around(curve: &Curve, t: f64) -> Vec3 {
    let [from, to] = curve.range;
    if t < from || t > to { curve.around(t, to - from) } else { curve.at(t) }
}

impl Spline {
    /// The place of the fitted surface nearest to `p`: about the last one where `p` is on the surface there, for to look
    /// through all patches of a high degree takes seconds.
    fn near(&self, p: Vec3) -> [f64; 2] {
        /// How far a border is off its surface at most, as a share of its size, and still on it.
        const ON: f64 = 1e-5;
        let about = self.last.get().map(|uv| nearest_from(&self.fitted, p, uv));
        let about = about.filter(|hit| hit.distance <= ON * self.fitted.extent());
        let uv = about.unwrap_or_else(|| nearest_on(&self.fitted, p)).uv;
        self.last.set(Some(uv));
        uv
    }

    /// The last parameter of the fitted surface, and the spans between knots.
    fn length(&self, k: usize) -> (f64, usize) {
        let last = match &self.fitted.layout {
            Layout::Mesh { u, v } => [u, v][k].last().copied().unwrap_or(1.0),
            Layout::Patches => 1.0,
        };
        (last, self.borders[k].len() - 1)
    }

    /// A parameter of the fitted surface as one of the knots: spans between them count as one each.
    fn knot(&self, k: usize, at: f64) -> f64 {
        let (borders, (last, spans)) = (&self.borders[k], self.length(k));
        let x = (at * spans as f64 / last).clamp(0.0, spans as f64);
        let span = (0..spans).rev().find(|i| *i as f64 <= x).unwrap_or(0);
        let share = x - span as f64;
        borders[span] * (1.0 - share) + borders[span + 1] * share
    }

    /// The parameter of the fitted surface for one of the knots.
    fn fitted_at(&self, k: usize, t: f64) -> f64 {
        let (borders, (last, spans)) = (&self.borders[k], self.length(k));
        let (low, high) = (borders[0], borders[spans]);
        let over = self.periods[k].filter(|_| t < low || t > high);
        let t = over.map_or(t, |p| t - ((t - low) / p).floor() * p).clamp(low, high);
        let span = borders.partition_point(|b| *b <= t).clamp(1, spans) - 1;
        let share = (t - borders[span]) / (borders[span + 1] - borders[span]);
        (span as f64 + share) * last / spans as f64
    }
}
