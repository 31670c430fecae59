//! The curves between which the rulings of a RLDSRF run: cuts of a surface with the plane of a base line
//! and a direction, as the height `y` along the direction over the fraction `t` of the base line.

use aptc_geometry::{Form, Rail as Definition, Tabcyl, Vec3};

/// A rail that was recognised.
#[derive(Clone, Debug)]
pub(super) struct Rail {
    pub(super) start: Vec3,
    pub(super) base: Vec3,
    /// As long as the base line.
    pub(super) toward: Vec3,
    height: Height,
}

#[derive(Clone, Debug)]
enum Height {
    Conic(Conic),
    Spans(Vec<Span>),
}

/// `a y^2 + 2 b(t) y + c(t) = 0` with the root that is meant.
#[derive(Clone, Copy, Debug)]
struct Conic {
    a: f64,
    b: [f64; 2],
    c: [f64; 3],
    /// The discriminant `b^2 - a c` as a polynomial of t, and the sign of its root.
    q: [f64; 3],
    sign: f64,
    /// Does the discriminant vanish at the start, at the end? The curve is steep there.
    ends: [bool; 2],
}

/// A span of a TABCYL: over `t`, as a function of the place `x` along its chord.
#[derive(Clone, Copy, Debug)]
struct Span {
    t: [f64; 2],
    length: f64,
    /// `offset(x) = x (a (x^2 - l^2) + b (x - l))`.
    a: f64,
    b: f64,
    /// `(t, y) = m0 + m1 x + m2 offset(x)`.
    m: [[f64; 2]; 3],
}

/// Height with its two derivatives by `t`.
pub(super) type Profile = [f64; 3];

impl Rail {
    /// The rail of a plane, sphere, cylinder, cone, quadric or TABCYL; `None` for others, and where it is
    /// not the curve that its definition means.
    pub(super) fn new(rail: &Definition) -> Option<Self> {
        /// Places at which it is held against its definition.
        const PLACES: u32 = 32;
        let base = rail.end - rail.start;
        let toward = rail.toward.try_normalize(0.0)? * base.norm();
        let place = |t: f64, y: f64| rail.start + base * t + toward * y;
        let mut new = Self { start: rail.start, base, toward, height: Height::Spans(Vec::new()) };
        let candidates: Vec<Height> = match rail.surface.shape() {
            Form::Tabcyl(t) => vec![Height::Spans(spans(t, rail, toward)?)],
            form => {
                let conic = Conic::of(&|t, y| implicit(form, place(t, y)))?;
                [1.0, -1.0].map(|sign| Height::Conic(Conic { sign, ..conic })).into()
            }
        };
        let near = 1e-7 * base.norm();
        candidates.into_iter().find_map(|height| {
            new.height = height;
            let right = (1..PLACES).all(|i| {
                let t = f64::from(i) / f64::from(PLACES);
                let y = new.at(t).map(|f| f[0]);
                y.is_some_and(|y| rail.point(t).is_ok_and(|p| (p - place(t, y)).norm() <= near))
            });
            right.then(|| new.clone())
        })
    }

    /// Is it steep at the start, at the end?
    pub(super) fn steep(&self) -> [bool; 2] {
        match &self.height {
            Height::Conic(c) => c.ends,
            Height::Spans(_) => [false; 2],
        }
    }

    /// Fractions of the base line where its third derivative jumps, at corners the first.
    pub(super) fn joints(&self) -> Vec<f64> {
        match &self.height {
            Height::Conic(_) => Vec::new(),
            Height::Spans(spans) => spans
                .iter()
                .skip(1)
                .map(|s| s.t[0])
                .filter(|t| *t > 1e-9 && *t < 1.0 - 1e-9)
                .collect(),
        }
    }

    /// Height and derivatives over `t`, away from a steep end.
    pub(super) fn at(&self, t: f64) -> Option<Profile> {
        self.at_beside(t, t)
    }

    /// The same at an end of a span as of the one in which `inside` lies: at a corner both have slopes of their own.
    pub(super) fn at_beside(&self, t: f64, inside: f64) -> Option<Profile> {
        match &self.height {
            Height::Conic(c) => c.at(t),
            Height::Spans(spans) => spans[span_at(spans, inside)].at(t),
        }
    }

    /// The span in which `t` lies.
    pub(super) fn span(&self, t: f64) -> usize {
        match &self.height {
            Height::Conic(_) => 0,
            Height::Spans(spans) => span_at(spans, t),
        }
    }

    /// Bound of the second derivative over `t0..t1`; infinite where it is steep.
    pub(super) fn bend(&self, t0: f64, t1: f64) -> f64 {
        match &self.height {
            Height::Conic(c) => c.bend(t0, t1),
            Height::Spans(spans) => {
                let over = spans.iter().filter(|s| s.t[0] < t1 && s.t[1] > t0);
                over.map(|s| s.bends(t0.max(s.t[0]), t1.min(s.t[1]))[0]).fold(0.0, f64::max)
            }
        }
    }

    /// Bound of the third derivative over `t0..t1`; infinite where it is steep.
    pub(super) fn twist(&self, t0: f64, t1: f64) -> f64 {
        match &self.height {
            Height::Conic(c) => c.twist(t0, t1),
            Height::Spans(spans) => {
                let over = spans.iter().filter(|s| s.t[0] < t1 && s.t[1] > t0);
                over.map(|s| s.bends(t0.max(s.t[0]), t1.min(s.t[1]))[1]).fold(0.0, f64::max)
            }
        }
    }

    /// Where it is steep: the height as `(sign sqrt(q(t)) - b(t)) / a`, with q divided by what makes it
    /// vanish: sign, a, b and the coefficients of the rest of q.
    pub(super) fn root(&self) -> Option<Root> {
        let Height::Conic(c) = &self.height else { return None };
        let q = c.q;
        let rest = match c.ends {
            [true, true] => [-q[2], 0.0],
            [true, false] => [q[1], q[2]],
            // (1 - t)(q0 + (q0 + q1) t) when q0 + q1 + q2 = 0.
            [false, true] => [q[0], q[0] + q[1]],
            [false, false] => return None,
        };
        Some(Root { scale: c.sign / c.a, rest, b: c.b.map(|b| b / c.a) })
    }
}

/// A height with a root in it: `scale sqrt(t^i (1 - t)^j rest(t)) - b(t)`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Root {
    pub(super) scale: f64,
    pub(super) rest: [f64; 2],
    pub(super) b: [f64; 2],
}

/// A form of second degree that vanishes on the surface.
fn implicit(form: &Form, p: Vec3) -> Option<f64> {
    let across = |w: Vec3, t: Vec3| w - t * w.dot(&t);
    Some(match form {
        Form::Plane(s) => s.distance(p),
        Form::Line(l) => l.plane().distance(p),
        Form::Sphere(s) => (p - s.center).norm_squared() - s.radius * s.radius,
        Form::Circle(c) => across(p - c.center, c.axis).norm_squared() - c.radius * c.radius,
        Form::Cylinder(c) => across(p - c.point, c.axis).norm_squared() - c.radius * c.radius,
        Form::Cone(c) => {
            let w = p - c.vertex;
            let along = w.dot(&c.axis);
            along * along - c.cos_half * c.cos_half * w.norm_squared()
        }
        Form::Quadric(q) => q.value(p),
        _ => return None,
    })
}

impl Conic {
    /// From the form on the plane of the base line.
    fn of(f: &dyn Fn(f64, f64) -> Option<f64>) -> Option<Self> {
        // The form is of second degree: six values give it.
        let (o, t, y) =
            (f(0.0, 0.0)?, [f(1.0, 0.0)?, f(-1.0, 0.0)?], [f(0.0, 1.0)?, f(0.0, -1.0)?]);
        let both = f(1.0, 1.0)?;
        let c = [o, 0.5 * (t[0] - t[1]), 0.5 * (t[0] + t[1]) - o];
        let (b0, a) = (0.25 * (y[0] - y[1]), 0.5 * (y[0] + y[1]) - o);
        let b1 = 0.5 * (both - o - c[1] - c[2] - 2.0 * b0 - a);
        let size = c.iter().chain([&a, &b0, &b1]).fold(0.0_f64, |m, x| m.max(x.abs()));
        if size <= 0.0 {
            return None;
        }
        // What is rounding of the greatest is nothing.
        let clean = |x: f64| if x.abs() <= 1e-14 * size { 0.0 } else { x / size };
        let (a, b, c) = (clean(a), [clean(b0), clean(b1)], c.map(clean));
        let q = [b[0] * b[0] - a * c[0], 2.0 * b[0] * b[1] - a * c[1], b[1] * b[1] - a * c[2]];
        let scale = q[0].abs().max(q[1].abs()).max(q[2].abs());
        let ends = [q[0], q[0] + q[1] + q[2]].map(|q| q.abs() <= 1e-10 * scale);
        Some(Self { a, b, c, q, sign: 1.0, ends })
    }

    fn at(&self, t: f64) -> Option<Profile> {
        let b = self.b[0] + self.b[1] * t;
        let c = self.c[0] + t * (self.c[1] + t * self.c[2]);
        let [q0, q1, q2] = self.q;
        let q = (q0 + t * (q1 + t * q2)).max(0.0);
        let root = self.sign * q.sqrt();
        // Of the two formulas the one without a difference of equal numbers.
        let y = if (b < 0.0) == (root > 0.0) && self.a != 0.0 {
            (root - b) / self.a
        } else {
            -c / (b + root)
        };
        let slope = -(2.0 * self.b[1] * y + self.c[1] + 2.0 * self.c[2] * t) / (2.0 * root);
        let bend = -(2.0 * self.c[2] + 4.0 * self.b[1] * slope + 2.0 * self.a * slope * slope)
            / (2.0 * root);
        y.is_finite().then_some([y, slope, bend])
    }

    /// `|y''| = |M| / q^1.5` with the determinant M of the conic.
    fn bend(&self, t0: f64, t1: f64) -> f64 {
        let (m, least) = (self.determinant(), self.least(t0, t1));
        if m == 0.0 { 0.0 } else { m / (least * least.sqrt()) }
    }

    /// `|y'''| = 3/2 |M q'| / q^2.5`.
    fn twist(&self, t0: f64, t1: f64) -> f64 {
        let (m, least, q) = (self.determinant(), self.least(t0, t1), self.q);
        let slope = [t0, t1].map(|t| (q[1] + 2.0 * q[2] * t).abs());
        let slope = slope[0].max(slope[1]);
        if m * slope == 0.0 { 0.0 } else { 1.5 * m * slope / (least * least * least.sqrt()) }
    }

    /// The determinant without its sign.
    fn determinant(&self) -> f64 {
        let ([b0, b1], c, a) = (self.b, self.c, self.a);
        let m = -c[0] * b1 * b1 - c[2] * b0 * b0 + a * c[0] * c[2] + b0 * b1 * c[1]
            - 0.25 * a * c[1] * c[1];
        m.abs()
    }

    /// Least value of the discriminant over `t0..t1`.
    fn least(&self, t0: f64, t1: f64) -> f64 {
        let q = self.q;
        let at = |t: f64| q[0] + t * (q[1] + t * q[2]);
        let mut least = at(t0).min(at(t1));
        let turn = -0.5 * q[1] / q[2];
        if turn > t0 && turn < t1 {
            least = least.min(at(turn));
        }
        least.max(0.0)
    }
}

/// The spans of a TABCYL over the base line in rising order.
fn spans(form: &Tabcyl, rail: &Definition, toward: Vec3) -> Option<Vec<Span>> {
    let base = rail.end - rail.start;
    let flat = |p: Vec3| [form.u().dot(&p), form.v().dot(&p)];
    let (o, x, y) = (flat(rail.start), flat(base), flat(toward));
    let det = x[0] * y[1] - x[1] * y[0];
    if det == 0.0 {
        return None;
    }
    // (t, y) of a vector of the directrix's plane.
    let solve =
        |w: [f64; 2]| [(w[0] * y[1] - w[1] * y[0]) / det, (x[0] * w[1] - x[1] * w[0]) / det];
    let mut out: Vec<Span> = Vec::with_capacity(form.spans.len());
    for (i, s) in form.spans.iter().enumerate() {
        let chord = form.chord(i);
        let m = [
            solve([s.start.x - o[0], s.start.y - o[1]]),
            solve([chord.x, chord.y]),
            solve([-chord.y, chord.x]),
        ];
        let t = [m[0][0], m[0][0] + m[1][0] * s.length];
        out.push(Span { t, length: s.length, a: s.a, b: s.b, m });
    }
    let falls = out.first()?.t[0] > out.last()?.t[1];
    if falls {
        out.reverse();
        out.iter_mut().for_each(|s| s.t.reverse());
    }
    let first = out.iter().position(|s| s.t[1] > 1e-7)?;
    let last = out.iter().rposition(|s| s.t[0] < 1.0 - 1e-7)?;
    let out = out.get(first..=last)?.to_vec();
    // One after the other, without a steep place.
    let rising = out.iter().all(|s| s.t[0] < s.t[1] && s.bends(s.t[0], s.t[1])[0].is_finite());
    let adjoin = out.windows(2).all(|w| (w[0].t[1] - w[1].t[0]).abs() < 1e-9);
    let whole = out.first()?.t[0] < 1e-7 && out.last()?.t[1] > 1.0 - 1e-7;
    (rising && adjoin && whole).then_some(out)
}

fn span_at(spans: &[Span], t: f64) -> usize {
    spans.partition_point(|s| s.t[1] < t).min(spans.len() - 1)
}

impl Span {
    /// Offset from the chord at `x` with its two derivatives.
    fn offset(&self, x: f64) -> Profile {
        let (a, b, l) = (self.a, self.b, self.length);
        [
            x * (a * (x * x - l * l) + b * (x - l)),
            3.0 * a * x * x + 2.0 * b * x - a * l * l - b * l,
            6.0 * a * x + 2.0 * b,
        ]
    }

    /// The place along the chord over `t`: t rises or falls with it all the way.
    fn place(&self, t: f64) -> f64 {
        let (mut lo, mut hi) = (-1e-6 * self.length, (1.0 + 1e-6) * self.length);
        let of = |x: f64| {
            let f = self.offset(x);
            (
                self.m[0][0] + self.m[1][0] * x + self.m[2][0] * f[0],
                self.m[1][0] + self.m[2][0] * f[1],
            )
        };
        let rises = of(hi).0 > of(lo).0;
        let mut x = 0.5 * self.length;
        for _ in 0..60 {
            let (value, slope) = of(x);
            if (value < t) == rises {
                lo = x;
            } else {
                hi = x;
            }
            let newton = x - (value - t) / slope;
            let next = if newton > lo && newton < hi { newton } else { 0.5 * (lo + hi) };
            if (next - x).abs() <= 1e-16 * self.length {
                return next;
            }
            x = next;
        }
        x
    }

    fn at(&self, t: f64) -> Option<Profile> {
        let x = self.place(t);
        let f = self.offset(x);
        let [m0, m1, m2] = self.m;
        let (t1, t2) = (m1[0] + m2[0] * f[1], m2[0] * f[2]);
        let (y1, y2) = (m1[1] + m2[1] * f[1], m2[1] * f[2]);
        let slope = y1 / t1;
        let bend = (y2 - slope * t2) / (t1 * t1);
        let y = m0[1] + m1[1] * x + m2[1] * f[0];
        bend.is_finite().then_some([y, slope, bend])
    }

    /// Bounds of the second and third derivatives. With `r = t' = m1 + m2 f'` they are `f'' det / r^3` and
    /// `(f''' / r^4 - 3 m2 f''^2 / r^5) det`.
    fn bends(&self, t0: f64, t1: f64) -> [f64; 2] {
        let (x0, x1) = (self.place(t0), self.place(t1));
        let (x0, x1) = (x0.min(x1) - 1e-9 * self.length, x0.max(x1) + 1e-9 * self.length);
        let rate = |x: f64| self.m[1][0] + self.m[2][0] * self.offset(x)[1];
        let mut range = [rate(x0), rate(x1)];
        let turn = -self.b / (3.0 * self.a);
        if turn > x0 && turn < x1 {
            range =
                [range[0].min(rate(turn)).min(range[1]), range[1].max(rate(turn)).max(range[0])];
        }
        if range[0] * range[1] <= 0.0 {
            return [f64::INFINITY; 2];
        }
        let least = range[0].abs().min(range[1].abs());
        let second = self.offset(x0)[2].abs().max(self.offset(x1)[2].abs());
        let det = (self.m[1][0] * self.m[2][1] - self.m[1][1] * self.m[2][0]).abs();
        let cube = least * least * least;
        let third = 6.0 * self.a.abs() + 3.0 * self.m[2][0].abs() * second * second / least;
        [second * det / cube, third * det / (cube * least)]
    }
}
