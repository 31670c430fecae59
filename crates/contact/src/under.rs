//! Below the distance of a rounded cutter: the square of its distance to a disk is above a form of second degree.
//!
//! A tangent plane bounds the distance of a convex cutter from below and gives away how both bend. Where the cutter
//! is a disk made thicker by its corner radius `r`, `(distance + r)^2` is the squared distance to the disk: `z^2` over the disk
//! and `(rho - e)^2 + z^2` beside it. Below each of them lies a form of second degree. On a piece of a patch that is one in its
//! parameters, but for terms of third degree.

use aptc_geometry::surface::frame_about;
use aptc_geometry::{Tool, Vec3};

/// A piece of a patch: `point + a s + b t + p s^2 + q s t + r t^2` for s and t from -1 to 1, but for what strays.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    /// Its middle.
    pub point: Vec3,
    /// Half its first derivatives there, [a, b].
    pub first: [Vec3; 2],
    /// What its second derivatives add, [p, q, r].
    pub second: [Vec3; 3],
    /// No point of it is farther off the sum of all than the first times `s^2` and the second times `t^2`.
    pub rests: [f64; 2],
    /// No point of it is farther from its middle.
    pub far: f64,
}

/// For all places `q + w` of a piece about `q` the squared distance to the disk is at least
/// `value + slope . w + |w|^2 - sum of share (m . w)^2` over the flats `(share, m)`; what is taken off is never more than
/// `|w|^2`.
#[derive(Clone, Copy, Debug)]
struct Under {
    value: f64,
    slope: Vec3,
    flats: [(f64, Vec3); 3],
    /// How many of the flats there are.
    count: usize,
}

/// A sweep whose square is this part of what it would be without flats goes along them.
const ALONG: f64 = 1e-6;
/// Rounds in which the nearest place on a way is looked for, and how near to each other, as parts of the way, the last two
/// are: the last is then off by the square of that, about, and the bound lower by the square of what it is off.
const NEAREST: usize = 5;
const CLOSE: f64 = 1e-2;

impl Cell {
    /// No point of it is farther from its middle along the vector, times the vector's length.
    #[inline]
    pub(crate) fn extent(&self, v: Vec3) -> f64 {
        let [a, b] = self.first.map(|d| d.dot(&v).abs());
        let [p, q, r] = self.second.map(|d| d.dot(&v).abs());
        a + b + p + q + r + (self.rests[0] + self.rests[1]) * v.norm()
    }

    /// By how much it rises at least along the unit vector `n`, or one that is shorter, where a parameter goes from the middle to the
    /// border, twice as much and without its slope. Negative where it may fall.
    #[inline]
    pub(crate) fn rises(&self, n: Vec3) -> [f64; 2] {
        let [p, q, r] = self.second.map(|d| d.dot(&n));
        // Of the middle term each parameter takes one half.
        let [s, t] = self.rests;
        [2.0 * (p - s) - q.abs(), 2.0 * (r - t) - q.abs()]
    }

    /// At most the least of what the places are along the vector from the middle, times the vector's length.
    #[inline]
    fn lowest(&self, v: Vec3) -> f64 {
        let [a, b] = self.first.map(|d| d.dot(&v).abs());
        let [p, q, r] = self.second.map(|d| d.dot(&v));
        p.min(0.0) + r.min(0.0) - a - b - q.abs() - (self.rests[0] + self.rests[1]) * v.norm()
    }
}

/// What is known of the distances of a piece.
#[derive(Clone, Copy, Debug)]
pub struct Low {
    /// That of its middle, or less.
    pub middle: f64,
    /// None is less.
    pub bound: f64,
    /// Where the bound is, about: s and t, from -1 to 1.
    pub at: [f64; 2],
}

/// The distances of a piece from a tool that moves by `by`, the bound as sharp as need be to reach `aim` if it can. `None`
/// where the tool is not rounded.
#[inline]
pub(crate) fn under(tool: &Tool<'_>, by: Vec3, cell: &Cell, aim: f64) -> Option<Low> {
    let q = cell.point;
    let part = |at: Vec3| {
        let w = q - at;
        let z = w.dot(&tool.ta);
        ((w - tool.ta * z).norm(), z)
    };
    let (rho, z) = part(tool.te);
    let moves = by != Vec3::zeros();
    let (mut rhos, mut zs) = ([rho; 2], [z; 2]);
    if moves {
        // On the way the height changes evenly, the distance from the axis is greatest at an end.
        let (rho_on, z_on) = part(tool.te + by);
        rhos = [0.5 * (rho + rho_on - by.norm()), rho.max(rho_on)];
        zs = [z.min(z_on), z.max(z_on)];
    }
    let rounded = |high: f64| {
        let [near, far] = [rhos[0] - cell.far, rhos[1] + cell.far];
        tool.profile.is_rounded([near, far], [zs[0] - high, zs[1] + high])
    };
    if !rounded(cell.far) && !rounded(cell.extent(tool.ta)) {
        return None;
    }
    let t = if moves { nearest(tool, by, q) } else { 0.0 };
    let range = if moves { [-t, 1.0 - t] } else { [0.0; 2] };
    let start = Start::of(&tool.at(tool.te + by * t), q);
    let radius = tool.profile.corner_radius();
    // A tangent is enough for most: the squared distance is convex, on the way too.
    let along = range.map(|t| t * start.slope.dot(&by));
    let value = start.value - along[0].max(along[1]).max(0.0);
    let plane = value + cell.lowest(start.slope);
    let root = |square: f64| square.max(0.0).sqrt() - radius;
    let enough = (aim + radius).max(0.0);
    if plane >= enough * enough {
        return Some(Low { middle: root(value), bound: root(plane), at: [0.0; 2] });
    }
    let least = |form: Under| {
        let form = if moves { form.swept(by, range, cell) } else { form };
        let (least, at) = form.over(cell);
        (form.value, least, at)
    };
    let (beside, over) = Under::parts(&start, tool, cell, by, range);
    let (mut middle, mut bound, mut at) = least(beside);
    if let Some(over) = over {
        if bound < enough * enough {
            // That of the other part would not help.
            return Some(Low { middle: root(value), bound: root(plane), at });
        }
        let (low, lower, there) = least(over);
        middle = middle.min(low);
        if lower < bound || lower.is_nan() {
            (bound, at) = (lower, there);
        }
    }
    Some(Low { middle: root(middle.max(value)), bound: root(bound.max(plane)), at })
}

/// The squared distance to the disk at a place, and its slope.
struct Start {
    value: f64,
    slope: Vec3,
    /// Unit direction from the axis.
    out: Vec3,
    /// Distance from the axis.
    rho: f64,
    /// Height over the disk.
    z: f64,
}

impl Start {
    #[inline]
    fn of(tool: &Tool<'_>, q: Vec3) -> Self {
        let [e, f] = tool.profile.corner();
        let w = q - tool.te;
        let height = w.dot(&tool.ta);
        let radial = w - tool.ta * height;
        let (rho, z) = (radial.norm(), height - f);
        let out = if rho > 0.0 { radial / rho } else { frame_about(tool.ta)[0] };
        let off = (rho - e).max(0.0);
        let slope = (out * off + tool.ta * z) * 2.0;
        Self { value: off * off + z * z, slope, out, rho, z }
    }
}

impl Under {
    /// For a tool that stands still where it is rounded: the places of a piece, and those moved the other way by the part
    /// of `by` within `range`. Where some may be over the disk and others beside it a form for each part: the lesser counts.
    #[inline]
    fn parts(
        start: &Start,
        tool: &Tool<'_>,
        cell: &Cell,
        by: Vec3,
        range: [f64; 2],
    ) -> (Self, Option<Self>) {
        let [e, _] = tool.profile.corner();
        let &Start { value, slope, out, rho, z } = start;
        let none = (0.0, Vec3::zeros());
        if e == 0.0 {
            return (Self { value, slope, flats: [none; 3], count: 0 }, None);
        }
        // How far along the radius the places in question are.
        let most = range[0].abs().max(range[1]);
        let reach = cell.extent(out) + most * by.dot(&out).abs();
        let (off, across) = (rho - e, tool.ta.cross(&out));
        // With a the way along the radius in the middle and b the way across, the radius of a place is at least `rho + a`: all
        // with `a >= -off` are beside the disk. `z^2` is below all squared distances, and where `a <= -off` so is
        // `z^2 + m (off + a)` with m from 0 up.
        let over = |m: f64| {
            let (value, slope) = (z * z + m * off, tool.ta * (2.0 * z) + out * m);
            Self { value, slope, flats: [(1.0, out), (1.0, across), none], count: 2 }
        };
        if off + reach <= 0.0 {
            return (over(0.0), None);
        }
        // Where `a >= -off` the radius is at most `rho + a + b^2 / (2 (rho + a))`, and its square `(rho + a)^2 + b^2`. So the
        // square of what it is above e is at least `(off + a)^2 + b^2 (1 - e / (rho + a))`.
        let least = (off - reach).max(0.0);
        let beside = Self {
            value: off * off + z * z,
            slope: (out * off + tool.ta * z) * 2.0,
            flats: [(e / (e + least), across), none, none],
            count: 1,
        };
        if off >= reach {
            return (beside, None);
        }
        // The m with which the piece falls least along the radius.
        let [a, b] = cell.first;
        let (x, y) = (out.dot(&a), out.dot(&b));
        let m = -2.0 * z * (tool.ta.dot(&a) * x + tool.ta.dot(&b) * y) / (x * x + y * y);
        (beside, Some(over(if m > 0.0 && m.is_finite() { m } else { 0.0 })))
    }

    /// The least of the forms for the places of a piece moved the other way by the part of `by` within `range`.
    #[inline]
    fn swept(mut self, by: Vec3, range: [f64; 2], cell: &Cell) -> Self {
        let hb = self.mapped(by);
        let (bb, sb) = (by.dot(&hb), self.slope.dot(&by));
        if bb <= ALONG * by.norm_squared() {
            // Next to level, as beside a flat: `t^2 by.H by` is not below 0.
            let most = range[0].abs().max(range[1]);
            self.value -= (range[0] * sb).max(range[1] * sb) + 2.0 * most * cell.extent(hb);
            return self;
        }
        let free = 0.5 * sb / bb;
        let end = free.clamp(range[0], range[1]);
        // A place whose nearest is `over + d` of the way beyond the end, `|d| <= far`, has to the square of the way across that of
        // what is beyond, if that is above 0: at least `over^2 + 2 over d + k d^2` with `k = 1 - (1 - over / far)^2`. For
        // `d >= -over` as k <= 1; below, the form is convex, at `d = -over` it is not above 0 and at `d = -far` it is 0.
        let over = free - end;
        let part = (over.abs() * bb / cell.extent(hb)).min(1.0);
        self.value += bb * (over * over - free * free);
        self.slope += hb * (2.0 * (over - free));
        self.flats[self.count] = ((1.0 - part) * (1.0 - part) / bb, hb);
        self.count += 1;
        self
    }

    fn flats(&self) -> &[(f64, Vec3)] {
        &self.flats[..self.count]
    }

    /// The form's second part as a vector.
    #[inline]
    fn mapped(&self, v: Vec3) -> Vec3 {
        self.flats().iter().fold(v, |sum, (share, m)| sum - m * (share * m.dot(&v)))
    }

    /// The least over the piece, and where, about.
    #[inline]
    fn over(&self, cell: &Cell) -> (f64, [f64; 2]) {
        let [a, b] = &cell.first;
        let [p, q, r] = &cell.second;
        // The products of the first derivatives, and those with the second by the powers of the parameters.
        let (mut aa, mut ab, mut bb) = (a.dot(a), a.dot(b), b.dot(b));
        let (mut s3, mut s2, mut t2, mut t3) =
            (a.dot(p), a.dot(q) + b.dot(p), a.dot(r) + b.dot(q), b.dot(r));
        for (share, m) in self.flats() {
            let (ma, mb) = (m.dot(a), m.dot(b));
            let (sa, sb) = (share * ma, share * mb);
            let (mp, mq, mr) = (m.dot(p), m.dot(q), m.dot(r));
            aa -= sa * ma;
            ab -= sa * mb;
            bb -= sb * mb;
            s3 -= sa * mp;
            s2 -= sa * mq + sb * mp;
            t2 -= sa * mr + sb * mq;
            t3 -= sb * mr;
        }
        // Third powers of parameters up to 1 are less than squares: what they take away is nothing in the middle.
        let n = &self.slope;
        let [rest_u, rest_v] = cell.rests.map(|rest| (n.norm() + 2.0 * cell.far) * rest);
        let second = [
            aa + n.dot(p) - 2.0 * (s3.abs() + s2.abs()) - rest_u,
            2.0 * ab + n.dot(q),
            bb + n.dot(r) - 2.0 * (t2.abs() + t3.abs()) - rest_v,
        ];
        let (least, at) = lowest([n.dot(a), n.dot(b)], second);
        (self.value + least, at)
    }
}

/// The part of the way by `by` on which a rounded tool is nearest to `q`, by Newton's method on the square of its distance
/// to the disk.
#[inline]
fn nearest(tool: &Tool<'_>, by: Vec3, q: Vec3) -> f64 {
    let [e, f] = tool.profile.corner();
    let w = q - tool.te;
    let (height, rise) = (w.dot(&tool.ta), by.dot(&tool.ta));
    let (radial, side) = (w - tool.ta * height, by - tool.ta * rise);
    let (here, both, on) = (radial.norm_squared(), radial.dot(&side), side.norm_squared());
    let mut t: f64 = 0.5;
    for _ in 0..NEAREST {
        let z = height - f - rise * t;
        let rho = (here - 2.0 * both * t + on * t * t).max(0.0).sqrt();
        let (mut slope, mut bend) = (-z * rise, rise * rise);
        if rho > e {
            let turn = (on * t - both) / rho;
            slope += (rho - e) * turn;
            bend += turn * turn + (rho - e) * (on - turn * turn) / rho;
        }
        if bend <= 0.0 {
            break;
        }
        let next = (t - slope / bend).clamp(0.0, 1.0);
        let near = (next - t).abs() <= CLOSE;
        t = next;
        if near {
            break;
        }
    }
    t
}

/// The least of `x s + y t + a s^2 + b s t + c t^2` with s and t from -1 to 1, and where.
#[inline]
fn lowest([x, y]: [f64; 2], [a, b, c]: [f64; 3]) -> (f64, [f64; 2]) {
    let det = 4.0 * a * c - b * b;
    if !(a > 0.0 && c > 0.0 && det > 0.0) {
        // Not hollow in all directions: the least is on a side.
        let mut least = (f64::INFINITY, [0.0; 2]);
        for end in [-1.0, 1.0] {
            let ((u, s), (v, t)) = (along(x + b * end, a), along(y + b * end, c));
            let (u, v) = (y * end + c + u, x * end + a + v);
            // What is no number shows nothing, and must not be passed over.
            if u < least.0 || u.is_nan() {
                least = (u, [s, end]);
            }
            if v < least.0 || v.is_nan() {
                least = (v, [end, t]);
            }
        }
        return least;
    }
    let (s, t) = ((b * y - 2.0 * c * x) / det, (b * x - 2.0 * a * y) / det);
    let (beside, beyond) = (s.abs() > 1.0, t.abs() > 1.0);
    if !beside && !beyond {
        return (0.5 * (x * s + y * t), [s, t]);
    }
    // On the sides that the lowest place is beyond.
    let mut least = (f64::INFINITY, [0.0; 2]);
    if beside {
        let s = 1.0_f64.copysign(s);
        let (v, t) = along(y + b * s, c);
        least = (x * s + a + v, [s, t]);
    }
    if beyond {
        let t = 1.0_f64.copysign(t);
        let (v, s) = along(x + b * t, a);
        let v = y * t + c + v;
        if v < least.0 || v.is_nan() {
            least = (v, [s, t]);
        }
    }
    least
}

/// The least of `x s + a s^2` with s from -1 to 1, and where.
#[inline]
fn along(x: f64, a: f64) -> (f64, f64) {
    let size = x.abs();
    if 2.0 * a > size {
        (-0.25 * x * x / a, -0.5 * x / a)
    } else {
        (a - size, -1.0_f64.copysign(x))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::{Cutter, Profile};
    use proptest::prelude::*;

    #[test]
    fn what_is_no_number_bounds_nothing() {
        for k in 0..5 {
            let mut x = [1.0; 5];
            x[k] = f64::NAN;
            let [a, b, c, d, e] = x;
            assert!(
                lowest([a, b], [c, d, e]).0.is_nan() || lowest([a, b], [c, d, e]).0 < -0.2,
                "{k}"
            );
            assert!(lowest([a, b], [-c, d, e]).0.is_nan(), "{k}");
        }
    }

    #[test]
    fn the_lowest_place_of_a_form() {
        for k in 0..400 {
            let f = f64::from(k);
            let of = |c: f64| aptc_geometry::trig::sin(c * f + c);
            let (x, y, a, b, c) = (2.0 * of(1.3), 2.0 * of(2.1), of(0.7), of(3.3), of(4.9));
            let mut least = f64::INFINITY;
            for i in 0..=100 {
                for j in 0..=100 {
                    let (s, t) = (0.02 * f64::from(i) - 1.0, 0.02 * f64::from(j) - 1.0);
                    least = least.min(x * s + y * t + a * s * s + b * s * t + c * t * t);
                }
            }
            let (found, [s, t]) = lowest([x, y], [a, b, c]);
            assert!(found <= least + 1e-12);
            assert!(found > least - 2e-3, "{k}: {found} {least}");
            let there = x * s + y * t + a * s * s + b * s * t + c * t * t;
            assert!((there - found).abs() < 1e-12, "{k}: {found} {there}");
        }
    }

    proptest! {
        #[test]
        fn no_place_is_nearer_than_the_form_says(
            r in 0.5_f64..5.0, wide in 0.0_f64..6.0, ball in 0..3_i32, moves in 0..4_i32,
            lean in prop::array::uniform2(-0.5_f64..0.5), at in prop::array::uniform3(-1.0_f64..1.0),
            by in prop::array::uniform3(-1.0_f64..1.0), far in 0.01_f64..1.5,
            sides in prop::array::uniform5(prop::array::uniform3(-1.0_f64..1.0)),
            off in prop::collection::vec(prop::array::uniform3(-1.0_f64..1.0), 30),
        ) {
            let e = if ball == 0 { 0.0 } else { wide };
            let profile = Profile::new(&Cutter::mill(2.0 * (e + r), r, 60.0)).unwrap();
            let ta = Vec3::new(lean[0], lean[1], 1.0).normalize();
            let tool = Tool { profile: &profile, te: Vec3::new(3.0, -2.0, 1.0), ta };
            let q = tool.te + Vec3::new(at[0] * (e + 2.0 * r), at[1] * (e + 2.0 * r), r * (at[2] - 0.3));
            let by = Vec3::from(by) * [0.0, 2.0, 8.0, 4.0][usize::try_from(moves).unwrap()];
            // Level ways, on which the disk goes along itself.
            let by = if moves == 3 { by - ta * ta.dot(&by) } else { by };
            let [a, b, second @ ..] = sides.map(|d| Vec3::from(d) * (0.2 * far));
            let rest = 0.1 * far;
            let size = [a, b].into_iter().chain(second).map(|d| d.norm()).sum::<f64>() + rest;
            let rests = [0.5 * rest; 2];
            let cell = Cell { point: q, first: [a, b], second, rests, far: size };
            // As a tangent has it, and as the form.
            let all = [-1e3, 1e3].map(|aim| under(&tool, by, &cell, aim));
            prop_assume!(all[0].is_some());
            let distance = |p: Vec3| {
                let one = |k: i32| tool.at(tool.te + by * (f64::from(k) / 64.0)).distance(p);
                (0..=64).map(one).fold(f64::INFINITY, f64::min)
            };
            let all: Vec<Low> = all.into_iter().flatten().collect();
            for low in &all {
                prop_assert!(low.middle <= distance(q) + 1e-9);
                prop_assert!(by != Vec3::zeros() || low.middle >= distance(q) - 1e-9);
            }
            for [s, t, x] in off {
                let bent = second[0] * (s * s) + second[1] * (s * t) + second[2] * (t * t);
                let w = a * s + b * t + bent + Vec3::new(x, s, t).normalize() * (0.5 * x * rest * (s * s + t * t));
                for low in &all {
                    prop_assert!(distance(q + w) >= low.bound - 1e-9);
                }
            }
        }
    }
}
