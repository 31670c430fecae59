//! TABCYL: a plane of data, a way of fairing, and a list of points with slopes or normals among them.

use std::sync::Arc;

use aptc_geometry::{
    CurveFoot, Fit, FitError, Form, Knot, Line, Tabcyl, TabcylSpan, Transform, Vec2, Vec3,
    nearest_foot,
};
use aptc_vocabulary::{Word, word};

use super::fault::Fault;
use super::format::Item::{self, M, Of, Rest, V, W};
use super::format::{Args, Format, row};
use super::line::at_degrees;
use super::meet;

const FRAMES: Item = Of(&[word::NOX, word::NOY, word::NOZ]);
const POLAR: Item = Of(&[word::RTHETA, word::THETAR]);
const XYZ: Item = W(word::XYZ);
const FITS: Item = Of(&[word::SPLINE, word::FOURPT, word::TWOPT, word::PTSLOP, word::PTNORM]);
const FREE_FITS: Item = Of(&[word::SPLINE, word::FOURPT, word::TWOPT]);
const TRFORM: Item = W(word::TRFORM);
const DATA: Item = Rest("points");

pub(super) const FORMATS: &[Format] = &[
    row(&[FRAMES, FITS, TRFORM, M, DATA], faired),
    row(&[FRAMES, FITS, DATA], faired),
    row(&[POLAR, FITS, TRFORM, M, DATA], faired),
    row(&[POLAR, FITS, DATA], faired),
    row(&[XYZ, FREE_FITS, TRFORM, M, V, DATA], faired),
    row(&[XYZ, FREE_FITS, V, DATA], faired),
];

/// Rows u, v, w of a frame: the first two data axes and the generatrix.
type Axes = [Vec3; 3];

/// The frame of the data word.
///
/// The data of NOY come as z, x. With XYZ the generatrix is the vector and u is the projection of the axis
/// that follows, in the order x y z, the one it is nearest to.
fn axes(word: Word, generatrix: Option<Vec3>) -> Axes {
    let (x, y, z) = (Vec3::x(), Vec3::y(), Vec3::z());
    match (word, generatrix) {
        (_, Some(w)) => {
            let most = w.iamax();
            let next = [y, z, x][most];
            let u = (next - w * w.dot(&next)).normalize();
            [u, w.cross(&u), w]
        }
        (word::NOX, None) => [y, z, x],
        (word::NOY, None) => [z, x, y],
        _ => [x, y, z],
    }
}

fn faired(a: &Args<'_>) -> Result<Form, Fault> {
    let (frame, fit) = (a.word(0)?, a.word(1)?);
    let (transform, mut at) = if a.is(2, word::TRFORM) { (Some(3), 4) } else { (None, 2) };
    let generatrix = if frame == word::XYZ {
        at += 1;
        Some(a.direction(at - 1)?)
    } else {
        None
    };
    let axes = axes(frame, generatrix);
    let (mut knots, places) =
        Reader { a, axes, frame, fit, at, knots: Vec::new(), places: Vec::new() }.read()?;
    let mut after = None;
    if let Some(place) = transform {
        let m = a.matrix(place)?;
        let w = m.vector(axes[2]);
        if w.cross(&axes[2]).norm() <= 1e-9 * w.norm() && w.norm() > 0.0 {
            // The plane of the data stays: the curve is faired after it has been moved.
            for knot in &mut knots {
                let flat = |v: Vec3| Vec2::new(axes[0].dot(&v), axes[1].dot(&v));
                let lift = |p: Vec2| axes[0] * p.x + axes[1] * p.y;
                knot.point = flat(m.point(lift(knot.point)));
                knot.tangent = knot.tangent.map(|t| flat(m.vector(lift(t))));
            }
        } else {
            after = Some((place, m));
        }
    }
    let way = match fit {
        word::SPLINE => Fit::Spline,
        word::FOURPT => Fit::FourPoint,
        _ => Fit::TwoPoint,
    };
    let rows = Transform::from_rows(&[
        axes[0].x, axes[0].y, axes[0].z, 0.0, axes[1].x, axes[1].y, axes[1].z, 0.0, axes[2].x,
        axes[2].y, axes[2].z, 0.0,
    ]);
    let curve = Tabcyl::fit(&knots, way, rows.linear, a.context.tabcyl_end)
        .map_err(|error| refusal(error, &places, a.len()))?;
    let curve = match after {
        Some((at, m)) => curve.transformed(&m).ok_or(Fault::Skew { at })?,
        None => curve,
    };
    Ok(Form::Tabcyl(Arc::new(curve)))
}

fn refusal(error: FitError, places: &[usize], end: usize) -> Fault {
    let at = |i: usize| places.get(i).copied().unwrap_or(end);
    match error {
        FitError::TooFew => Fault::TooFew { at: end, need: 2, found: places.len(), what: "points" },
        FitError::Coincide(i) => Fault::Coincide { a: at(i - 1), b: at(i) },
        FitError::Overhang(i, degrees) => Fault::Overhang { at: at(i), degrees },
        FitError::Level(i) => Fault::Overhang { at: at(i), degrees: 90.0 },
        FitError::NotConverged { at: i, turn_deg, residual } => {
            Fault::NotConverged { at: at(i), turn_deg, residual }
        }
    }
}

/// The data of a TABCYL as they are read.
struct Reader<'a, 'b> {
    a: &'a Args<'b>,
    axes: Axes,
    frame: Word,
    fit: Word,
    at: usize,
    knots: Vec<Knot>,
    places: Vec<usize>,
}

impl Reader<'_, '_> {
    fn read(mut self) -> Result<(Vec<Knot>, Vec<usize>), Fault> {
        let limit = self.a.context.max_points;
        while self.at < self.a.len() {
            let place = self.at;
            let point = self.point()?;
            let tangent = self.tangent()?;
            if self.knots.len() == limit {
                return Err(Fault::TooMany { at: place, limit });
            }
            self.knots.push(Knot { point, tangent });
            self.places.push(place);
        }
        Ok((self.knots, self.places))
    }

    fn flat(&self, p: Vec3) -> Vec2 {
        Vec2::new(self.axes[0].dot(&p), self.axes[1].dot(&p))
    }

    /// A point, or as many numbers as the frame has coordinates.
    fn point(&mut self) -> Result<Vec2, Fault> {
        let (a, at) = (self.a, self.at);
        if a.is_point(at) {
            self.at += 1;
            return Ok(self.flat(a.point(at)?));
        }
        let n = if self.frame == word::XYZ { 3 } else { 2 };
        for i in 0..n {
            if !a.is_number(at + i) {
                let expected = if i > 0 {
                    if n == 3 {
                        "the rest of three coordinates"
                    } else {
                        "the second of two coordinates"
                    }
                } else if self.fit == word::SPLINE || self.fit == word::TWOPT {
                    "a point, SLOPE or NORMAL"
                } else {
                    "a point"
                };
                return Err(Fault::Unexpected { at: at + i, expected });
            }
        }
        self.at += n;
        if n == 3 {
            let [x, y, z] = a.numbers(at)?;
            return Ok(self.flat(Vec3::new(x, y, z)));
        }
        let [one, other] = a.numbers(at)?;
        Ok(match self.frame {
            word::RTHETA => at_degrees(other) * one,
            word::THETAR => at_degrees(one) * other,
            _ => Vec2::new(one, other),
        })
    }

    /// The slope or normal after a point, as the fit has it.
    fn tangent(&mut self) -> Result<Option<Vec2>, Fault> {
        let (a, at) = (self.a, self.at);
        let number = |at: usize| match a.is_number(at) {
            true => a.number(at),
            false => Err(Fault::Unexpected { at, expected: "a slope or an angle" }),
        };
        let slope = |s: f64| Vec2::new(1.0, s);
        let normal = |degrees: f64| meet::left(at_degrees(degrees));
        match self.fit {
            word::PTSLOP => {
                self.at += 1;
                Ok(Some(slope(number(at)?)))
            }
            word::PTNORM => {
                self.at += 1;
                Ok(Some(normal(number(at)?)))
            }
            word::SPLINE | word::TWOPT if self.frame != word::XYZ => {
                if a.is(at, word::SLOPE) {
                    self.at += 2;
                    return Ok(Some(slope(number(at + 1)?)));
                }
                if a.is(at, word::NORMAL) {
                    self.at += 2;
                    return Ok(Some(normal(number(at + 1)?)));
                }
                Ok(None)
            }
            _ => Ok(None),
        }
    }
}

/// The canonical elements of a TABCYL: n, k, nine direction cosines, n - 1 times u v a b length max min,
/// then u v. Lengths and extremes are computed anew, as the points and cubics determine them.
pub(super) fn from_elements(e: &[f64]) -> Result<Form, Fault> {
    let head = 11;
    if e.len() < head + 7 + 2 || !(e.len() - head - 2).is_multiple_of(7) {
        let n = e.len().saturating_sub(head + 2).div_ceil(7).max(1);
        return Err(Fault::Elements { at: e.len(), need: head + 7 * n + 2, found: e.len() });
    }
    let n_spans = (e.len() - head - 2) / 7;
    let n = e[0];
    if (n - f64::from(u32::try_from(n_spans + 1).unwrap_or(u32::MAX))).abs() > 1e-6 {
        return Err(Fault::Range { at: 0, value: n, need: "that counts the points of its list" });
    }
    let mut rows = [0.0; 12];
    for i in 0..9 {
        rows[i + i / 3] = e[2 + i];
    }
    let axes = Transform::from_rows(&rows);
    if axes.uniform_scale().is_none_or(|k| (k - 1.0).abs() > 1e-6) || axes.mirrors() {
        return Err(Fault::Skew { at: 2 });
    }
    let start = |i: usize| Vec2::new(e[head + 7 * i], e[head + 7 * i + 1]);
    let mut spans = Vec::with_capacity(n_spans);
    for i in 0..n_spans {
        let length = (start(i + 1) - start(i)).norm();
        if length <= 0.0 {
            return Err(Fault::Coincide { a: head + 7 * i, b: head + 7 * (i + 1) });
        }
        let at = head + 7 * i;
        spans.push(TabcylSpan::new(start(i), e[at + 2], e[at + 3], length));
    }
    Ok(Form::Tabcyl(Arc::new(Tabcyl { axes: axes.linear, spans, end: start(n_spans) })))
}

/// The TABCYL at `at`, whose generatrix must be upright, with the turn from xy to its plane.
struct Upright<'a> {
    curve: &'a Tabcyl,
}

impl<'a> Upright<'a> {
    fn of(a: &'a Args<'_>, at: usize) -> Result<Self, Fault> {
        let curve = a.tabcyl(at)?;
        let w = curve.w();
        if w.xy().norm() > 1e-9 {
            return Err(Fault::Leans { at, normal: w });
        }
        Ok(Self { curve })
    }

    /// From xy to uv; both planes are parallel.
    fn inside(&self, v: Vec2) -> Vec2 {
        self.curve.flatten(Vec3::new(v.x, v.y, 0.0))
    }

    /// From uv to xy.
    fn outside(&self, v: Vec2) -> Vec2 {
        self.curve.lift(v, 0.0).xy()
    }

    /// Direction of the curve at a foot, in xy.
    fn along(&self, foot: &CurveFoot) -> Vec2 {
        self.outside(self.curve.tangent(foot.span, foot.s)).normalize()
    }
}

/// The cut of the line with the curve that is nearest to the point.
pub(super) fn line_meets(a: &Args<'_>, line: usize, at: usize, near: usize) -> Result<Vec3, Fault> {
    let (l, t, p) = (a.line(line)?, Upright::of(a, at)?, a.point2(near)?);
    let feet = t.curve.meets_line(t.inside(meet::normal(&l)), l.d);
    let foot = nearest_foot(&feet, t.inside(p));
    let foot = foot.ok_or(Fault::Apart { a: line, b: at, gap: f64::INFINITY })?;
    Ok(a.context.lift(t.outside(foot.point)))
}

/// The line through the point at `p` that touches the curve nearest to the point at `near`.
pub(super) fn tangent(a: &Args<'_>, p: usize, at: usize, near: usize) -> Result<Line, Fault> {
    let (from, t, near) = (a.point2(p)?, Upright::of(a, at)?, a.point2(near)?);
    let feet = t.curve.tangents_from(t.inside(from));
    let Some(foot) = nearest_foot(&feet, t.inside(near)) else {
        return Err(Fault::NoFoot { p, at, what: "no line through it touches" });
    };
    // Along the curve, not along the way to the touch, which has no direction when the point is the touch.
    Ok(meet::line_at(from, meet::left(t.along(&foot))))
}

/// The line through the point at `p` that stands upright on the curve nearest to the point at `near`.
pub(super) fn normal(a: &Args<'_>, p: usize, at: usize, near: usize) -> Result<Line, Fault> {
    let (from, t, near) = (a.point2(p)?, Upright::of(a, at)?, a.point2(near)?);
    let feet = t.curve.normals_from(t.inside(from));
    let Some(foot) = nearest_foot(&feet, t.inside(near)) else {
        return Err(Fault::NoFoot { p, at, what: "no line through it stands upright on" });
    };
    // Its normal does not point down. Source: what APT-360 does.
    let n = t.along(&foot);
    Ok(meet::line_at(from, if n.y < 0.0 || n.y == 0.0 && n.x < 0.0 { -n } else { n }))
}

/// Centre of the circle `TANTO,line,modifier,TABCYL,modifier,point,RADIUS,r`: on the side of the line that
/// the first modifier names, from the touch on the side that the second names, touching the curve as near
/// to the point as possible.
pub(super) fn circle_center(a: &Args<'_>, r: f64) -> Result<Vec2, Fault> {
    let (l, t, near) = (a.line(1)?, Upright::of(a, 3)?, a.point2(5)?);
    let moved = meet::offset(&l, r * a.side2(2, meet::normal(&l))?);
    let toward = a.toward(4)?.xy();
    let found = t.curve.circles_on_line(t.inside(meet::normal(&moved)), moved.d, r);
    let side = |(foot, center): &(CurveFoot, Vec2)| t.outside(center - foot.point).dot(&toward);
    let there: Vec<_> = found.iter().filter(|c| side(c) > 1e-9 * r).collect();
    let far = |f: &CurveFoot| (t.outside(f.point) - near).norm_squared();
    let best = there.iter().min_by(|a, b| far(&a.0).total_cmp(&far(&b.0)));
    match best {
        Some((_, center)) => Ok(t.outside(*center)),
        None if found.is_empty() => Err(Fault::OutOfReach { a: 1, b: 3, gap: f64::INFINITY }),
        None => {
            let what = "the circles that touch both lie on the other side of the TABCYL".to_owned();
            Err(Fault::NothingThere { at: 4, what })
        }
    }
}
