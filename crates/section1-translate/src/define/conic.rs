//! ELLIPS, HYPERB, GCONIC, LCONIC: upright cylinders over conics of the xy plane.

use aptc_geometry::{Form, Quadric, QuadricKind, Vec2};
use aptc_vocabulary::word;

use super::fault::Fault;
use super::format::Item::{N, P, W, XY};
use super::format::{Args, Format, row};
use super::line::at_degrees;
use super::meet;

pub(super) const ELLIPS: &[Format] = &[row(&[W(word::CENTER), P, N, N, N], central)];

pub(super) const HYPERB: &[Format] = &[row(&[W(word::CENTER), P, N, N, N], central)];

pub(super) const GCONIC: &[Format] = &[
    row(&[N, N, N, N, N, N], general),
    row(&[N, N, N, N, N], alternate),
    row(&[N, N, N, N, N, W(word::FUNOFY)], alternate),
];

pub(super) const LCONIC: &[Format] = &[
    row(&[W(word::W5PT), XY, XY, XY, XY, XY], five_points),
    row(&[W(word::W4PT1SL), XY, N, XY, XY, XY], four_points),
    row(&[W(word::W3PT2SL), XY, N, XY, N, XY], three_points),
];

/// `a x + b y + c`.
#[derive(Clone, Copy)]
struct Linear {
    a: f64,
    b: f64,
    c: f64,
}

/// `a x2 + b y2 + d + 2 h x y + 2 p x + 2 q y`.
#[derive(Clone, Copy)]
struct Conic {
    a: f64,
    b: f64,
    d: f64,
    h: f64,
    p: f64,
    q: f64,
}

impl Linear {
    /// Zero along the line through `p` and `q`.
    fn through(p: Vec2, q: Vec2) -> Self {
        let way = q - p;
        Self { a: -way.y, b: way.x, c: way.y * p.x - way.x * p.y }
    }

    /// Zero along the line through `p` with a slope.
    fn with_slope(p: Vec2, slope: f64) -> Self {
        Self { a: -slope, b: 1.0, c: slope * p.x - p.y }
    }

    /// The scale that APT-360 gives a line: y with the factor 1 up to 45 degrees, steeper a unit normal, which
    /// points up.
    fn scaled(self) -> Self {
        let Self { a, b, c } = self;
        let size = if a.abs() <= b.abs() { b } else { Vec2::new(a, b).norm().copysign(b) };
        Self { a: a / size, b: b / size, c: c / size }
    }

    fn at(&self, p: Vec2) -> f64 {
        self.a * p.x + self.b * p.y + self.c
    }

    /// The pair of lines.
    fn times(&self, o: &Self) -> Conic {
        Conic {
            a: self.a * o.a,
            b: self.b * o.b,
            d: self.c * o.c,
            h: (self.a * o.b + self.b * o.a) / 2.0,
            p: (self.a * o.c + self.c * o.a) / 2.0,
            q: (self.b * o.c + self.c * o.b) / 2.0,
        }
    }
}

impl Conic {
    /// `self + other * t`.
    fn plus(&self, other: &Self, t: f64) -> Self {
        Self {
            a: self.a + other.a * t,
            b: self.b + other.b * t,
            d: self.d + other.d * t,
            h: self.h + other.h * t,
            p: self.p + other.p * t,
            q: self.q + other.q * t,
        }
    }

    fn largest(&self) -> f64 {
        [self.a, self.b, self.h, self.p, self.q, self.d].iter().fold(0.0, |m, c| m.max(c.abs()))
    }

    /// Zero for a pair of lines.
    fn determinant(&self) -> f64 {
        let Self { a, b, d, h, p, q } = *self;
        a * (b * d - q * q) - h * (h * d - p * q) + p * (h * q - p * b)
    }

    /// The same curve after its points moved by `by`.
    fn moved(&self, by: Vec2) -> Self {
        let p = self.p - self.a * by.x - self.h * by.y;
        let q = self.q - self.h * by.x - self.b * by.y;
        let d = self.d - (self.p + p) * by.x - (self.q + q) * by.y;
        Self { p, q, d, ..*self }
    }

    fn form(&self, kind: QuadricKind) -> Form {
        let Self { a, b, d, h, p, q } = *self;
        // No negative zeros: they would show in print-outs.
        let c = [a, b, 0.0, d, 0.0, 0.0, h, p, q, 0.0].map(|x| x + 0.0);
        Form::Quadric(Quadric { kind, c })
    }
}

/// Centre, half axes, angle of the first axis. The form is that whose constant at the centre is the square of
/// the product of the half axes, less than zero, as APT-360 has it.
fn central(a: &Args<'_>) -> Result<Form, Fault> {
    let (center, u) = (a.point2(1)?, at_degrees(a.number(4)?));
    let (m, n) = (a.positive(2)?, a.positive(3)?);
    let ellipse = a.head == word::ELLIPS;
    let (i, j) = (n * n, if ellipse { m * m } else { -m * m });
    let conic = Conic {
        a: i * u.x * u.x + j * u.y * u.y,
        b: i * u.y * u.y + j * u.x * u.x,
        d: -m * m * n * n,
        h: (i - j) * u.x * u.y,
        p: 0.0,
        q: 0.0,
    };
    let kind = if ellipse { QuadricKind::Ellips } else { QuadricKind::Hyperb };
    Ok(conic.moved(center).form(kind))
}

/// `A x2 + B x y + C y2 + D x + E y + F = 0`.
fn general(a: &Args<'_>) -> Result<Form, Fault> {
    let [x2, xy, y2, x, y, one] = a.numbers(0)?;
    if [x2, xy, y2].iter().all(|c| c.abs() < f64::MIN_POSITIVE) {
        return Err(Fault::NoCurve { what: "has no term of second degree" });
    }
    let conic = Conic { a: x2, b: y2, d: one, h: xy / 2.0, p: x / 2.0, q: y / 2.0 };
    Ok(conic.form(QuadricKind::Gconic))
}

/// `y = P x + Q +- sqrt(R x2 + S x + T)`, or x as such a function of y.
fn alternate(a: &Args<'_>) -> Result<Form, Fault> {
    let [p, q, r, s, t] = a.numbers(0)?;
    let (of, to, across) = (p * p - r, 1.0, -p);
    let (linear, other, d) = (p * q - s / 2.0, -q, q * q - t);
    let conic = if a.is(5, word::FUNOFY) {
        Conic { a: to, b: of, d, h: across, p: other, q: linear }
    } else {
        Conic { a: of, b: to, d, h: across, p: linear, q: other }
    };
    Ok(conic.form(QuadricKind::Gconic))
}

/// The points of a LCONIC by their places, seen from the first, and its true place.
struct Points {
    /// Places of the arguments.
    at: Vec<usize>,
    local: Vec<Vec2>,
    first: Vec2,
    size: f64,
}

/// Reads points given as such or as pairs, each followed by `slopes[i]` numbers.
fn points(a: &Args<'_>, slopes: &[usize]) -> Result<(Points, Vec<f64>), Fault> {
    let (mut at, mut place, mut all, mut values) = (1, Vec::new(), Vec::new(), Vec::new());
    for n in slopes {
        place.push(at);
        if a.is_point(at) {
            all.push(a.point2(at)?);
            at += 1;
        } else {
            let [x, y] = a.numbers(at)?;
            all.push(Vec2::new(x, y));
            at += 2;
        }
        for _ in 0..*n {
            values.push(a.number(at)?);
            at += 1;
        }
    }
    let first = all[0];
    let local: Vec<Vec2> = all.iter().map(|p| p - first).collect();
    let size = local.iter().fold(0.0_f64, |m, p| m.max(p.amax()));
    for i in 0..all.len() {
        for j in 0..i {
            if (all[i] - all[j]).norm() <= 1e-9 * size {
                return Err(Fault::Coincide { a: place[j], b: place[i] });
            }
        }
    }
    Ok((Points { at: place, local, first, size }, values))
}

/// The conic `one + other t` where it stands, unless it is a pair of lines.
fn proper(p: &Points, one: Conic, other: Conic, t: f64) -> Result<Form, Fault> {
    let conic = one.plus(&other, t);
    let l = p.size;
    let scaled = Conic {
        a: conic.a * l * l,
        b: conic.b * l * l,
        d: conic.d,
        h: conic.h * l * l,
        p: conic.p * l,
        q: conic.q * l,
    };
    let largest = scaled.largest();
    // What is left of the determinant of a unit conic when it is two lines but for rounding.
    let determinant = scaled.determinant().abs();
    if determinant.is_nan() || determinant <= 1e-12 * largest * largest * largest {
        return Err(on_one_line(p));
    }
    Ok(conic.moved(p.first).form(QuadricKind::Lconic))
}

/// In the pencil of the line pairs (12)(45) and (14)(25) the conic through the third point; the first pair enters
/// once, which is the scale that APT-360 gives.
fn five_points(a: &Args<'_>) -> Result<Form, Fault> {
    let (p, _) = points(a, &[0; 5])?;
    let line = |i: usize, j: usize| Linear::through(p.local[i], p.local[j]).scaled();
    once(&p, [line(0, 1), line(3, 4)], [line(0, 3), line(1, 4)], p.local[2])
}

/// In the pencil of (tangent)(34) and (13)(14) the conic through the second point, in the scale of APT-360.
fn four_points(a: &Args<'_>) -> Result<Form, Fault> {
    let (p, slopes) = points(a, &[1, 0, 0, 0])?;
    let line = |i: usize, j: usize| Linear::through(p.local[i], p.local[j]).scaled();
    let tangent = Linear::with_slope(p.local[0], slopes[0]).scaled();
    once(&p, [tangent, line(2, 3)], [line(0, 2), line(0, 3)], p.local[1])
}

/// The product of the tangents less so much of the squared chord that the third point lies on it, in the scale
/// of APT-360.
fn three_points(a: &Args<'_>) -> Result<Form, Fault> {
    let (p, slopes) = points(a, &[1, 1, 0])?;
    let tangent = |i: usize| Linear::with_slope(p.local[i], slopes[i]).scaled();
    let chord = Linear::through(p.local[0], p.local[1]).scaled();
    once(&p, [tangent(0), tangent(1)], [chord, chord], p.local[2])
}

/// The first pair of lines less so much of the second that it passes through `q`.
fn once(p: &Points, one: [Linear; 2], other: [Linear; 2], q: Vec2) -> Result<Form, Fault> {
    let height = other[0].at(q) * other[1].at(q);
    if height.abs() <= meet::PARALLEL * p.size * p.size {
        return Err(on_one_line(p));
    }
    let k = one[0].at(q) * one[1].at(q) / height;
    proper(p, one[0].times(&one[1]), other[0].times(&other[1]), -k)
}

fn on_one_line(p: &Points) -> Fault {
    let what = "three of the points, or a point and a slope, lie on one line";
    Fault::Dependent { places: p.at.clone(), what }
}
