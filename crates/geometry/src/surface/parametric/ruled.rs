//! Rulings between two plane curves, as a function of two parameters.

use crate::surface::Surface;
use crate::{Fiop, Form, Rail, Reason, RuledSurface, Second, Vec2, Vec3};

use super::rail::Pieces;
use super::{Domain, Jet};

/// Pieces of a curve that is no TABCYL.
const PIECES: u32 = 32;
/// Share of the base line by which derivatives keep away from its ends.
const INSET: f64 = 1e-6;
/// Share of the curve at a steep end that is not laid down as polynomials.
const STEEP: f64 = 0.1;
/// Sine of the turn from one sample to the next up to which a curve is straight there.
const STRAIGHT: f64 = 1e-9;
/// How far rulings go beyond the curves, in lengths of a ruling; the manual advises against more than two.
const REACH: f64 = 10.0;

/// The rulings.
#[derive(Clone, Debug)]
pub(super) struct Rulings {
    first: Curve,
    second: Far,
    /// At the start and at the end: does a curve leave the base line at a right angle?
    steep: [bool; 2],
}

#[derive(Clone, Debug)]
enum Far {
    Curve(Curve),
    Apex(Vec3),
}

/// One of the curves, its surface prepared.
#[derive(Clone, Debug)]
struct Curve {
    surface: Surface,
    start: Vec3,
    base: Vec3,
    toward: Vec3,
    spans: u32,
    /// Its height along `toward` over the base line, by `u`, once it is known.
    heights: Option<Pieces>,
}

/// Value and derivatives of a curve.
#[derive(Clone, Copy, Debug)]
struct Line {
    p: Vec3,
    d: Vec3,
    dd: Vec3,
}

/// A place over the base lines.
struct Over {
    u: f64,
    /// The nearest in [0, 1].
    at: f64,
    /// The fraction of the base line there with its derivatives.
    fraction: [f64; 3],
    /// Is it near a steep end?
    end: bool,
}

impl Rulings {
    pub(super) fn new(form: &RuledSurface) -> Option<Self> {
        let first = Curve::new(&form.first)?;
        let second = match &form.second {
            Second::Rail(rail) => Far::Curve(Curve::new(rail)?),
            Second::Apex(p) => Far::Apex(*p),
        };
        let mut new = Self { first, second, steep: [false; 2] };
        let steep = |t: f64| new.curves().any(|c| c.steep(t));
        new.steep = [steep(0.0), steep(1.0)];
        let found =
            |c: &Curve| (0..=PIECES).all(|i| c.point(f64::from(i) / f64::from(PIECES)).is_ok());
        let complete = new.curves().all(found);
        if !complete {
            return None;
        }
        let first = new.heights(&new.first);
        new.first.heights = Some(first);
        let second = match &new.second {
            Far::Curve(c) => Some(new.heights(c)),
            Far::Apex(_) => None,
        };
        if let Far::Curve(c) = &mut new.second {
            c.heights = second;
        }
        Some(new)
    }

    fn curves(&self) -> impl Iterator<Item = &Curve> {
        let second = match &self.second {
            Far::Curve(c) => Some(c),
            Far::Apex(_) => None,
        };
        std::iter::once(&self.first).chain(second)
    }

    /// Into how many pieces the curves are cut for samples.
    pub(super) fn pieces(&self) -> u32 {
        self.curves().map(|c| c.spans).max().unwrap_or(PIECES)
    }

    /// Does a curve bend to both sides of its base line?
    pub(super) fn waves(&self) -> bool {
        self.curves().any(|curve| {
            let n = f64::from(curve.spans);
            let up = |i: u32| {
                let u = f64::from(i) / n;
                let over = Over { u, at: u, fraction: self.fraction(u), end: false };
                let p = self.line(curve, &over).p - curve.start;
                Vec2::new(over.fraction[0] * curve.base.norm(), p.dot(&curve.toward))
            };
            let (mut before, mut way) = (up(0), None::<Vec2>);
            let mut bends = [false; 2];
            for i in 1..=curve.spans {
                let here = up(i);
                let next = here - before;
                let turn = way.map_or(0.0, |w| w.perp(&next) / (w.norm() * next.norm()));
                if turn.abs() > STRAIGHT {
                    bends[usize::from(turn > 0.0)] = true;
                }
                (before, way) = (here, Some(next));
            }
            bends == [true; 2]
        })
    }

    pub(super) fn domain(&self) -> Domain {
        let far = match &self.second {
            Far::Curve(_) => 1.0 + REACH,
            Far::Apex(_) => 1.0,
        };
        Domain { u: [-0.5, 1.5], v: [-REACH, far] }
    }

    /// Base line and direction of both curves; those of an apex are none. `None` with a steep end.
    pub(super) fn rails(&self) -> Option<[[Vec3; 2]; 2]> {
        let of = |c: &Curve| [c.base, c.toward];
        let second = match &self.second {
            Far::Curve(c) => of(c),
            Far::Apex(_) => [Vec3::zeros(); 2],
        };
        (self.steep == [false; 2]).then_some([of(&self.first), second])
    }

    /// First and second derivative of the height of a curve between two parameters, least and greatest; `None` at a joint.
    pub(super) fn slopes(&self, curve: usize, ends: &[f64]) -> Option<[[f64; 2]; 2]> {
        let curve = match (curve, &self.second) {
            (0, _) => &self.first,
            (_, Far::Curve(c)) => c,
            (_, Far::Apex(_)) => return Some([[0.0; 2]; 2]),
        };
        let [a, b] = [ends[0], ends[1]];
        let mut found = curve.heights.as_ref()?.slopes([a.clamp(0.0, 1.0), b.clamp(0.0, 1.0)])?;
        if a < 0.0 || b > 1.0 {
            // Straight on beyond the ends.
            found[1] = [found[1][0].min(0.0), found[1][1].max(0.0)];
        }
        Some(found)
    }

    /// Fraction of the base line at `u` in [0, 1] with its derivatives: slow where a curve is steep, which
    /// makes the square root in it smooth.
    fn fraction(&self, u: f64) -> [f64; 3] {
        match self.steep {
            [false, false] => [u, 1.0, 0.0],
            [true, false] => [u * u, 2.0 * u, 2.0],
            [false, true] => [u * (2.0 - u), 2.0 - 2.0 * u, -2.0],
            [true, true] => [u * u * (3.0 - 2.0 * u), 6.0 * u * (1.0 - u), 6.0 - 12.0 * u],
        }
    }

    /// The height of a curve over its base line as polynomials.
    fn heights(&self, curve: &Curve) -> Pieces {
        let size = curve.start.norm() + curve.base.norm();
        Pieces::new(curve.spans, size, |u| {
            let [t, dt, ddt] = self.fraction(u);
            let line = self.exact(curve, u);
            let [d, dd] = [line.d - curve.base * dt, line.dd - curve.base * ddt];
            let up = line.p - curve.start - curve.base * t;
            [up, d, dd].map(|v| v.dot(&curve.toward))
        })
    }

    #[inline]
    fn line(&self, curve: &Curve, over: &Over) -> Line {
        let known = curve.heights.as_ref().filter(|_| !over.end).and_then(|p| p.at(over.at));
        let Some([h, dh, ddh]) = known else {
            return self.exact(curve, over.u);
        };
        let [t, dt, ddt] = over.fraction;
        let p = curve.start + curve.base * t + curve.toward * h;
        let d = curve.base * dt + curve.toward * dh;
        let beyond = over.u - over.at;
        if beyond != 0.0 {
            return Line { p: p + d * beyond, d, dd: Vec3::zeros() };
        }
        Line { p, d, dd: curve.base * ddt + curve.toward * ddh }
    }

    /// From the curve itself.
    fn exact(&self, curve: &Curve, u: f64) -> Line {
        let at = u.clamp(0.0, 1.0);
        let [t, ..] = self.fraction(at);
        // At a steep end the derivatives are those of a place beside it.
        let inset = |x: f64| {
            let low = if self.steep[0] { INSET } else { 0.0 };
            let high = if self.steep[1] { 1.0 - INSET } else { 1.0 };
            x.clamp(low, high)
        };
        let [ti, d1, d2] = self.fraction(inset(at));
        #[expect(clippy::float_cmp, reason = "the same value or another place")]
        let same = ti == t;
        let place = |t: f64| curve.point(t).unwrap_or_else(|_| curve.start + curve.base * t);
        let p = place(t);
        let [dp, ddp] = curve.derivatives(if same { p } else { place(ti) });
        let d = dp * d1;
        let beyond = u - at;
        let dd = if beyond == 0.0 { ddp * (d1 * d1) + dp * d2 } else { Vec3::zeros() };
        Line { p: p + d * beyond, d, dd }
    }

    #[inline]
    pub(super) fn jet(&self, u: f64, v: f64) -> Jet {
        match self.between(u) {
            Some([a, b]) => Jet::ruling(&a, &b, v),
            None => self.anywhere(u, v),
        }
    }

    /// Both curves between their ends, where their heights are known there.
    #[inline(always)]
    fn between(&self, u: f64) -> Option<[Line; 2]> {
        let Far::Curve(second) = &self.second else { return None };
        if self.steep != [false; 2] || !(0.0..=1.0).contains(&u) {
            return None;
        }
        Some([self.first.between(u)?, second.between(u)?])
    }

    fn anywhere(&self, u: f64, v: f64) -> Jet {
        let at = u.clamp(0.0, 1.0);
        // At a steep end the curve itself is asked: its derivatives there are those of a place beside it.
        let end = self.steep[0] && at < STEEP || self.steep[1] && at > 1.0 - STEEP;
        let over = Over { u, at, fraction: self.fraction(at), end };
        let a = self.line(&self.first, &over);
        let b = match &self.second {
            Far::Curve(c) => self.line(c, &over),
            Far::Apex(p) => Line { p: *p, d: Vec3::zeros(), dd: Vec3::zeros() },
        };
        Jet::ruling(&a, &b, v)
    }
}

impl Jet {
    /// At the share `v` of the way between two lines.
    #[inline]
    fn ruling(a: &Line, b: &Line, v: f64) -> Self {
        let (sv, suv) = (b.p - a.p, b.d - a.d);
        Self {
            s: a.p + sv * v,
            su: a.d + suv * v,
            sv,
            suu: a.dd + (b.dd - a.dd) * v,
            suv,
            svv: Vec3::zeros(),
        }
    }
}

impl Curve {
    fn new(rail: &Rail) -> Option<Self> {
        let spans = match rail.surface.shape() {
            Form::Tabcyl(t) => {
                u32::try_from(4 * t.spans.len()).unwrap_or(PIECES).clamp(PIECES, 400)
            }
            _ => PIECES,
        };
        Some(Self {
            surface: Surface::from_form(&rail.surface)?,
            start: rail.start,
            base: rail.end - rail.start,
            toward: rail.toward.try_normalize(0.0)?,
            spans,
            heights: None,
        })
    }

    /// Value and derivatives at `u` in [0, 1] of a curve that is not steep, where its height is known.
    #[inline(always)]
    fn between(&self, u: f64) -> Option<Line> {
        let [h, dh, ddh] = self.heights.as_ref()?.at(u)?;
        let p = self.start + self.base * u + self.toward * h;
        Some(Line { p, d: self.base + self.toward * dh, dd: self.toward * ddh })
    }

    /// As [`Rail::point`], with the surface prepared.
    fn point(&self, t: f64) -> Result<Vec3, Reason> {
        let from = self.start + self.base * t - self.toward * (Rail::BEHIND * self.base.norm());
        match self.surface.directed_distance(from, self.toward, Fiop::AheadFirst) {
            Ok(hit) => Ok(hit.point),
            // An end is on its curve, also where rounding lets a steep curve miss it.
            Err(_) if t <= 0.0 || t >= 1.0 => Ok(self.start + self.base * t),
            Err(reason) => Err(reason),
        }
    }

    /// First and second derivative by the fraction of the base line at the point `p`: it moves along the base line
    /// and along `toward`, in the surface.
    fn derivatives(&self, p: Vec3) -> [Vec3; 2] {
        let foot = self.surface.foot(p);
        let ahead = foot.normal.dot(&self.toward);
        let d = self.base - self.toward * (foot.normal.dot(&self.base) / ahead);
        let dd = self.toward * (-foot.shape.second(d) / ahead);
        let finite = |v: &Vec3| v.iter().all(|x| x.is_finite());
        if finite(&d) && finite(&dd) { [d, dd] } else { [self.base, Vec3::zeros()] }
    }

    /// Is the surface parallel to `toward` at that end?
    fn steep(&self, t: f64) -> bool {
        self.point(t).is_ok_and(|p| self.surface.foot(p).normal.dot(&self.toward).abs() < 1e-2)
    }
}
