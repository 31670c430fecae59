//! Random arguments for a format, now and then nearly degenerate on purpose.

use aptc_geometry::{
    Circle, Cylinder, Form, Line, Pattern, Plane, Quadric, QuadricKind, Vec3, trig,
};
use aptc_vocabulary::{Word, word};

use super::{define, n};
use crate::define::Value;
use crate::define::format::{Format, Item};

/// SplitMix64: the same arguments on every machine.
pub(super) struct Gen {
    state: u64,
    scale: f64,
    points: Vec<Vec3>,
    lines: Vec<Line>,
    planes: Vec<Plane>,
    circles: Vec<Circle>,
    vectors: Vec<Vec3>,
}

impl Gen {
    pub(super) fn new(seed: u64) -> Self {
        let mut g = Self {
            state: seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ 0x1234_5678,
            scale: 1.0,
            points: Vec::new(),
            lines: Vec::new(),
            planes: Vec::new(),
            circles: Vec::new(),
            vectors: Vec::new(),
        };
        g.scale = [1.0, 1.0, 10.0, 1000.0, 1e-3][g.below(5)];
        g
    }

    fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// In [0, 1).
    fn share(&mut self) -> f64 {
        f64::from(u32::try_from(self.bits() >> 32).unwrap()) / f64::from(u32::MAX)
    }

    pub(super) fn below(&mut self, n: usize) -> usize {
        usize::try_from(self.bits() >> 33).unwrap() % n
    }

    fn one_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    pub(super) fn within(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.share()
    }

    /// A tiny share, from a thousandth down to rounding.
    fn tiny(&mut self) -> f64 {
        let exponent = self.within(-15.0, -3.0);
        trig::pow(10.0, exponent)
    }

    pub(super) fn coordinate(&mut self) -> f64 {
        match self.below(12) {
            0 => 0.0,
            1 => self.scale * self.within(-3.0, 3.0).round(),
            _ => {
                let s = self.scale;
                self.within(-s, s)
            }
        }
    }

    pub(super) fn vec3(&mut self) -> Vec3 {
        if !self.points.is_empty() && self.one_in(8) {
            let i = self.below(self.points.len());
            let near = self.points[i];
            let by = self.tiny() * self.scale;
            return near + Vec3::new(self.within(-by, by), self.within(-by, by), 0.0);
        }
        if !self.lines.is_empty() && self.one_in(10) {
            // On a line, or nearly.
            let i = self.below(self.lines.len());
            let l = self.lines[i];
            let (t, off) = (self.coordinate(), self.tiny() * self.scale);
            let n = Vec3::new(l.a, l.b, 0.0);
            return n * (l.d + off) + Vec3::new(-l.b, l.a, 0.0) * t;
        }
        let p = Vec3::new(self.coordinate(), self.coordinate(), self.coordinate());
        self.points.push(p);
        p
    }

    pub(super) fn direction(&mut self) -> Vec3 {
        if !self.vectors.is_empty() && self.one_in(8) {
            let i = self.below(self.vectors.len());
            let near = self.vectors[i];
            let by = self.tiny();
            return near + Vec3::new(self.within(-by, by), self.within(-by, by), 0.0);
        }
        let v = match self.below(8) {
            0 => [Vec3::x(), -Vec3::y(), Vec3::z()][self.below(3)],
            _ => Vec3::new(self.within(-1.0, 1.0), self.within(-1.0, 1.0), self.within(-1.0, 1.0)),
        };
        self.vectors.push(v);
        v
    }

    pub(super) fn radius(&mut self) -> f64 {
        self.scale * self.within(0.01, 1.5)
    }

    fn flat_line(&mut self) -> Line {
        if !self.lines.is_empty() && self.one_in(6) {
            let i = self.below(self.lines.len());
            let l = self.lines[i];
            let by = self.tiny();
            let d = self.coordinate();
            return Line::new(l.a + by, l.b - by, d).unwrap();
        }
        if !self.circles.is_empty() && self.one_in(6) {
            // Touching a circle, or nearly.
            let i = self.below(self.circles.len());
            let c = self.circles[i];
            let (s, k) = trig::sin_cos(self.within(0.0, std::f64::consts::TAU));
            let off = self.tiny() * self.within(-1.0, 1.0);
            let d = k * c.center.x + s * c.center.y + c.radius * (1.0 + off);
            return Line::new(k, s, d).unwrap();
        }
        let (s, k) = trig::sin_cos(self.within(0.0, std::f64::consts::TAU));
        let (a, b) = match self.below(8) {
            0 => (1.0, 0.0),
            1 => (0.0, -1.0),
            _ => (k, s),
        };
        let l = Line::new(a, b, self.coordinate()).unwrap();
        self.lines.push(l);
        l
    }

    fn plane(&mut self) -> Plane {
        let p = if !self.planes.is_empty() && self.one_in(6) {
            let i = self.below(self.planes.len());
            let near = self.planes[i];
            let by = self.tiny();
            Plane::new(near.n + Vec3::new(by, -by, by), self.coordinate())
        } else {
            Plane::new(self.direction(), self.coordinate())
        };
        let p = p.unwrap_or(Plane { n: Vec3::z(), d: 1.0 });
        self.planes.push(p);
        p
    }

    fn circle(&mut self) -> Circle {
        let mut c = Circle { center: self.vec3(), axis: Vec3::z(), radius: self.radius() };
        if !self.circles.is_empty() && self.one_in(5) {
            // Touching another one, or nearly.
            let i = self.below(self.circles.len());
            let o = self.circles[i];
            let d = (c.center - o.center).xy().norm();
            let r = (d - o.radius).abs() * (1.0 + self.tiny() * self.within(-1.0, 1.0));
            if r > 0.01 * self.scale {
                c.radius = r;
            }
        }
        self.circles.push(c);
        c
    }

    fn tabcyl(&mut self) -> Form {
        let mut args = vec![super::w("NOZ"), super::w("SPLINE")];
        let (rise, swing) = (self.within(0.2, 0.7), self.within(0.2, 0.8));
        for i in 0..12 {
            let x = f64::from(i);
            args.push(n(self.scale * (0.2 * x - 1.1)));
            args.push(n(self.scale * (swing * trig::sin(rise * x) * 0.5 + 0.05 * self.share())));
        }
        define(word::TABCYL, &args).expect("a gentle wave")
    }

    pub(super) fn pattern(&mut self) -> Form {
        let (p, v) = (self.vec3(), self.vec3());
        let n_points = 2 + self.below(5);
        let at = |i: usize| p + v * f64::from(u32::try_from(i).unwrap());
        Form::Pattern(Pattern { points: (0..n_points).map(at).collect() })
    }

    fn conic(&mut self) -> Form {
        let q = |g: &mut Self| g.within(-1.0, 1.0);
        let s = self.scale;
        let c = [
            1.0 + q(self),
            1.0 + q(self),
            0.0,
            -s * s,
            0.0,
            0.0,
            q(self),
            s * q(self),
            s * q(self),
            0.0,
        ];
        Form::Quadric(Quadric { kind: QuadricKind::Gconic, c })
    }

    pub(super) fn matrix(&mut self) -> Form {
        let args = vec![super::w("XYROT"), n(self.within(-180.0, 180.0)), super::w("TRANSL")];
        let shift = (0..3).map(|_| n(self.coordinate())).collect::<Vec<_>>();
        define(word::MATRIX, &[args, shift].concat()).expect("a matrix")
    }

    pub(super) fn pick(&mut self, words: &[Word]) -> Value {
        words[self.below(words.len())].into()
    }

    /// Random arguments for the format.
    pub(super) fn arguments(&mut self, format: &Format) -> Vec<Value> {
        let mut out = Vec::new();
        for item in format.items {
            let before = out.last().cloned();
            self.item(item, before.as_ref(), &mut out);
        }
        out
    }

    fn item(&mut self, item: &Item, before: Option<&Value>, out: &mut Vec<Value>) {
        let after = |word| before == Some(&Value::Word(word));
        let value: Value = match item {
            // What a number means tells the word before it.
            Item::N if after(word::ATANGL) || after(word::XYROT) => self.angle(),
            Item::N if after(word::SLOPE) => n(self.within(-4.0, 4.0)),
            Item::N if after(word::SCALE) => n(self.within(0.1, 3.0)),
            Item::N if after(word::RADIUS) => n(self.radius()),
            Item::N | Item::Num(_) => n(self.coordinate()),
            Item::W(word) => (*word).into(),
            Item::Of(words) => self.pick(words),
            Item::P => match self.below(3) {
                0 => self.vec3().into(),
                _ => Form::Point(self.vec3()).into(),
            },
            Item::XY => {
                let p = self.vec3();
                if self.one_in(2) {
                    out.push(n(p.x));
                    n(p.y)
                } else {
                    Form::Point(p).into()
                }
            }
            Item::V => Form::Vector(self.direction()).into(),
            Item::PV => match self.below(2) {
                0 => Form::Vector(self.direction()).into(),
                _ => Form::Point(self.vec3()).into(),
            },
            Item::L => {
                let l = self.flat_line();
                if self.one_in(5) { Form::Plane(l.plane()).into() } else { Form::Line(l).into() }
            }
            Item::PL => {
                if self.one_in(4) {
                    Form::Line(self.flat_line()).into()
                } else {
                    Form::Plane(self.plane()).into()
                }
            }
            Item::C => {
                let c = self.circle();
                if self.one_in(4) {
                    let axis = -c.axis;
                    Form::Cylinder(Cylinder { axis, ..c.cylinder() }).into()
                } else {
                    Form::Circle(c).into()
                }
            }
            Item::K => self.conic().into(),
            Item::TC => self.tabcyl().into(),
            Item::PT => self.pattern().into(),
            Item::M => self.matrix().into(),
            Item::S => match self.below(2) {
                0 => Form::Circle(self.circle()).into(),
                _ => Form::Plane(self.plane()).into(),
            },
            Item::LC | Item::SC | Item::SS | Item::AS | Item::Rest(_) | Item::Tail(_) => return,
        };
        out.push(value);
    }

    fn angle(&mut self) -> Value {
        let quarter = 90.0 * self.within(-4.0, 4.0).round();
        n(match self.below(5) {
            0 => quarter,
            1 => quarter + self.tiny(),
            _ => self.within(-360.0, 360.0),
        })
    }
}
