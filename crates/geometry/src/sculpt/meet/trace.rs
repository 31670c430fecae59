//! From one place along a curve in both directions.

use super::MeetFault;
use super::sheet::{Sheet, Spot};
use super::strays::strays;
use crate::Vec3;

/// Rounds of Newton's method.
const ROUNDS: usize = 30;
/// Places of one piece.
const MOST: usize = 50_000;
/// Sine between two sheets below which the direction of their curve is lost.
const TANGENT: f64 = 1e-6;
/// By how much parameters may lie over a border.
const OVER: f64 = 1e-9;
/// Cosine of the turn of a curve in one chord.
const TURN: f64 = 0.9;
/// Share of the size of numbers to which places are found.
const EXACT: f64 = 1e-13;
/// Share of the tolerance up to which two places of a curve, across which it goes in one direction, are one. Curves so near to
/// each other, with the same side of the surface on their left, have another between them.
const SAME: f64 = 1e-3;
/// Places of a chord at which it is held against its curve. In the middle alone the chord of a bend to and fro seems exact.
const HELD: [f64; 3] = [0.25, 0.5, 0.75];
/// By how much more the curve may leave a chord elsewhere.
const MORE: f64 = 1.1;

/// A place on one of the two sheets.
#[derive(Clone, Copy, Debug)]
pub(super) struct Touch {
    /// Surface and patch.
    pub(super) of: [usize; 2],
    /// Parameters of the patch.
    pub(super) uv: [f64; 2],
    pub(super) foot: Vec3,
    pub(super) normal: Vec3,
}

/// A place of a curve.
#[derive(Clone, Copy, Debug)]
pub(super) struct Knot {
    pub(super) point: Vec3,
    pub(super) along: Vec3,
    pub(super) sides: [Touch; 2],
}

/// A curve, or the part of it in one pair of patches: on its left the second sheet lies on one side of the first.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    pub(super) knots: Vec<Knot>,
    pub(super) closed: bool,
}

/// Parameters on both sheets.
pub(super) type Uvs = [[f64; 2]; 2];

/// What holds besides that the two meet.
#[derive(Clone, Copy, Debug)]
enum Demand {
    /// The place on the second moves as little as can be.
    Near,
    /// In the plane across a direction, at a level of it.
    Across(Vec3, f64),
    /// A parameter, 0 or 1, of a sheet is given.
    Border(usize, usize, f64),
}

/// Where both sheets meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct State {
    uvs: Uvs,
    spots: [Spot; 2],
    /// Unit direction of the curve.
    along: Vec3,
}

/// Two sheets and the tolerance of their curves.
#[derive(Clone, Copy)]
pub(super) struct Tracer<'a> {
    pub(super) sheets: [&'a Sheet<'a>; 2],
    pub(super) tolerance: f64,
    exact: f64,
}

impl<'a> Tracer<'a> {
    pub(super) fn new(one: &'a Sheet<'a>, other: &'a Sheet<'a>, tolerance: f64) -> Self {
        let exact = EXACT * one.extent().max(other.extent()) + 1e-6 * EXACT * tolerance;
        Self { sheets: [one, other], tolerance, exact }
    }

    pub(super) fn point(&self, s: &State) -> Vec3 {
        (s.spots[0].point + s.spots[1].point) * 0.5
    }

    /// The place nearest to the start, if Newton's method finds one within the patches.
    pub(super) fn place(&self, start: Uvs) -> Option<State> {
        self.settle(start, Demand::Near).filter(|s| self.crossed(&s.uvs).is_none())
    }

    /// The curve through a place, from end to end or round; `None` when it has no length.
    pub(super) fn trace(&self, seed: State) -> Result<Option<Piece>, MeetFault> {
        let (mut knots, closed) = self.follow(seed, 1.0)?;
        if !closed {
            let (mut back, _) = self.follow(seed, -1.0)?;
            back.reverse();
            back.pop();
            back.append(&mut knots);
            knots = back;
        }
        let start = knots[0].point;
        let long = knots.iter().any(|k| (k.point - start).norm() > self.least());
        Ok((knots.len() > 1 && long).then_some(Piece { knots, closed }))
    }

    /// Shorter than this no chord is made, and no curve is told.
    fn least(&self) -> f64 {
        1e-3 * self.tolerance
    }

    /// Along the curve from `seed`, `sense` times its direction, to a border, round to the seed, or to where both sheets are tangent.
    /// Has it come back?
    fn follow(&self, seed: State, sense: f64) -> Result<(Vec<Knot>, bool), MeetFault> {
        let mut here = seed;
        let mut knots = vec![self.knot(&here)];
        let mut h = self.first_step(&seed);
        while h > self.least() {
            if knots.len() > MOST {
                return Err(MeetFault::Long(MOST));
            }
            let Some((mut next, mut ended)) = self.step(&here, here.along * sense, h) else {
                h *= 0.5;
                continue;
            };
            let again = knots.len() > 2 && self.comes_by(&here, &next, &seed);
            if again {
                (next, ended) = (seed, true);
            }
            let way = (self.point(&next) - self.point(&here)).norm();
            if way <= self.exact {
                if let (true, Some(last)) = (again, knots.last_mut()) {
                    *last = self.knot(&seed);
                }
                return Ok((knots, again));
            }
            let off = self.off(&here, &next).filter(|_| !self.strays(&here, &next));
            if off.is_none_or(|off| off > self.tolerance) {
                h = 0.5 * h.min(way);
                continue;
            }
            knots.push(self.knot(&next));
            if ended {
                return Ok((knots, again));
            }
            here = next;
            let share = self.tolerance / off.unwrap_or(0.0).max(1e-3 * self.tolerance);
            h *= (0.9 * share.sqrt()).clamp(0.5, 2.0);
        }
        Ok((knots, false))
    }

    /// Does the curve between two of its places go through the seed?
    fn comes_by(&self, here: &State, next: &State, seed: &State) -> bool {
        let ends = [here, next].map(|s| (self.point(s), s.uvs));
        self.same(ends, [-1e-9, 1.0 + 1e-9], self.point(seed))
            .is_some_and(|m| m.along.dot(&seed.along) > TURN)
    }

    /// A place within a piece, and the direction of its curve there.
    pub(super) fn middle(&self, piece: &Piece) -> Option<(Vec3, Vec3)> {
        let i = piece.knots.len().checked_sub(2)? / 2;
        let [a, b] = [&piece.knots[i], &piece.knots[i + 1]];
        let (t, p) = ((b.point - a.point).try_normalize(0.0)?, (a.point + b.point) * 0.5);
        let start = between(&a.sides.map(|s| s.uv), &b.sides.map(|s| s.uv), 0.5);
        let m = self.settle(start, Demand::Across(t, t.dot(&p)))?;
        Some((self.point(&m), m.along))
    }

    /// Does a place of these or other sheets, with the direction of the curve there, lie on the piece?
    ///
    /// Beside each chord in question the curve itself is met in the plane across.
    pub(super) fn holds(&self, piece: &Piece, p: Vec3, along: Vec3) -> bool {
        piece.knots.windows(2).any(|w| {
            let ends = [0, 1].map(|i| (w[i].point, w[i].sides.map(|s| s.uv)));
            // At a corner between chords the curve is beside neither.
            let met = self.same(ends, [-0.5, 1.5], p);
            met.is_some_and(|m| self.crossed(&m.uvs).is_none() && m.along.dot(&along).abs() > TURN)
        })
    }

    /// The place of the curve of a chord across which `p` lies, between these shares of it, if it is `p`.
    fn same(&self, ends: [(Vec3, Uvs); 2], shares: [f64; 2], p: Vec3) -> Option<State> {
        let [(a, from), (b, to)] = ends;
        let way = b - a;
        let share = (p - a).dot(&way) / way.norm_squared();
        let beside = (a + way * share - p).norm();
        if !(shares[0]..=shares[1]).contains(&share) || beside > 2.0 * self.tolerance {
            return None;
        }
        let t = way.try_normalize(0.0)?;
        let m = self.settle(between(&from, &to, share), Demand::Across(t, t.dot(&p)))?;
        ((self.point(&m) - p).norm() <= SAME * self.tolerance + self.exact).then_some(m)
    }

    fn knot(&self, s: &State) -> Knot {
        let touch = |i: usize| Touch {
            of: self.sheets[i].of,
            uv: s.uvs[i],
            foot: s.spots[i].foot,
            normal: s.spots[i].normal,
        };
        Knot { point: self.point(s), along: s.along, sides: [touch(0), touch(1)] }
    }

    /// A fifth of the way through the patch.
    fn first_step(&self, s: &State) -> f64 {
        let way = |i: usize| {
            let c = s.spots[i].components(s.along)?;
            self.sheets[i].ends().then(|| 0.2 / c[0].abs().max(c[1].abs()))
        };
        way(0).into_iter().chain(way(1)).fold(f64::INFINITY, f64::min)
    }

    /// The place a way `h` on in the direction `t`, or the end of the curve at a border before it.
    ///
    /// Of two curves side by side the one has on its left what the other has on its right: their directions tell them apart.
    fn step(&self, from: &State, t: Vec3, h: f64) -> Option<(State, bool)> {
        let p = self.point(from);
        let start = self.moved(from, t * h)?;
        let to = self.settle(start, Demand::Across(t, t.dot(&p) + h))?;
        let far = (self.point(&to) - p).norm() > 2.0 * h;
        if far || to.along.dot(&from.along) < TURN {
            return None;
        }
        let mut to = to;
        let mut ended = false;
        // The border that is crossed first; at its place another one may be crossed already.
        for _ in 0..4 {
            let Some((i, k, value)) = self.crossed(&to.uvs) else { return Some((to, ended)) };
            let (a, b) = (from.uvs[i][k], to.uvs[i][k]);
            let share = ((value - a) / (b - a)).clamp(0.0, 1.0);
            to = self.settle(between(&from.uvs, &to.uvs, share), Demand::Border(i, k, value))?;
            let ahead = (self.point(&to) - p).dot(&t);
            let beyond = ahead < -1e-6 * h || ahead > h * (1.0 + 1e-6);
            if beyond || to.along.dot(&from.along) < TURN {
                return None;
            }
            // There it goes out: where it goes in is but where it began.
            let way = to.along * t.dot(&to.along).signum();
            if to.spots[i].components(way)?[k] * (value - 0.5) < 0.0 {
                return None;
            }
            ended = true;
        }
        None
    }

    /// The border that is crossed by most: sheet, parameter, value there.
    fn crossed(&self, uvs: &Uvs) -> Option<(usize, usize, f64)> {
        let mut worst: Option<(f64, (usize, usize, f64))> = None;
        for (i, uv) in uvs.iter().enumerate().filter(|(i, _)| self.sheets[*i].ends()) {
            for (k, x) in uv.iter().enumerate() {
                let (over, value) = if *x < 0.0 { (-x, 0.0) } else { (x - 1.0, 1.0) };
                if over > OVER && worst.is_none_or(|w| over > w.0) {
                    worst = Some((over, (i, k, value)));
                }
            }
        }
        worst.map(|w| w.1)
    }

    /// How far the curve leaves the chord; `None` where it is not found beside it.
    fn off(&self, a: &State, b: &State) -> Option<f64> {
        let (p, q) = (self.point(a), self.point(b));
        let t = (q - p).try_normalize(0.0)?;
        let mut most = 0.0_f64;
        for share in HELD {
            let on = p + (q - p) * share;
            let m = self.settle(between(&a.uvs, &b.uvs, share), Demand::Across(t, t.dot(&on)))?;
            if m.along.dot(&a.along) < TURN {
                return None;
            }
            most = most.max((self.point(&m) - on).norm());
        }
        Some(MORE * most)
    }

    /// May the curve go over a border between two of its places within, by the cubic with its directions there?
    fn strays(&self, a: &State, b: &State) -> bool {
        let way = self.point(b) - self.point(a);
        let way = |s: &State| s.along * way.dot(&s.along).signum() * way.norm();
        (0..2).filter(|i| self.sheets[*i].ends()).any(|i| {
            let ways = [a, b].map(|s| s.spots[i].components(way(s)));
            let [Some(from), Some(to)] = ways else { return true };
            (0..2).any(|k| strays([a.uvs[i][k], b.uvs[i][k]], [from[k], to[k]]))
        })
    }

    fn moved(&self, s: &State, w: Vec3) -> Option<Uvs> {
        let to = |i: usize| {
            let c = s.spots[i].components(w)?;
            Some([s.uvs[i][0] + c[0], s.uvs[i][1] + c[1]])
        };
        Some([to(0)?, to(1)?])
    }

    /// Newton's method: both tangent planes and the demand give a point, to which the parameters move.
    fn settle(&self, start: Uvs, demand: Demand) -> Option<State> {
        let mut uvs = start;
        if let Demand::Border(i, k, value) = demand {
            uvs[i][k] = value;
        }
        for _ in 0..ROUNDS {
            let spots = [self.sheets[0].spot(uvs[0])?, self.sheets[1].spot(uvs[1])?];
            let cross = spots[0].normal.cross(&spots[1].normal);
            let sine = cross.norm();
            if sine <= TANGENT {
                return None;
            }
            let along = cross / sine;
            let mid = (spots[0].point + spots[1].point) * 0.5;
            let off = match demand {
                Demand::Across(t, level) => (t.dot(&mid) - level).abs(),
                _ => 0.0,
            };
            if (spots[0].point - spots[1].point).norm() <= self.exact && off <= 4.0 * self.exact {
                return Some(State { uvs, spots, along });
            }
            let x = match demand {
                Demand::Near => three(&spots, along, along.dot(&spots[1].point))?,
                Demand::Across(t, level) => three(&spots, t, level)?,
                Demand::Border(i, k, _) => {
                    // Along the line of the free parameter to the other's tangent plane.
                    let (own, other) = (&spots[i], &spots[1 - i]);
                    let line = if k == 0 { own.v } else { own.u };
                    let rate = other.normal.dot(&line);
                    if rate.abs() <= TANGENT * line.norm() {
                        return None;
                    }
                    own.point + line * (other.normal.dot(&(other.point - own.point)) / rate)
                }
            };
            for i in 0..2 {
                let [du, dv] = spots[i].components(x - spots[i].point)?;
                let free =
                    |k: usize| !matches!(demand, Demand::Border(s, p, _) if s == i && p == k);
                // Far outside a patch has no meaning.
                let reach = if self.sheets[i].ends() { 0.5 } else { f64::INFINITY };
                for (k, d) in [(0, du), (1, dv)] {
                    if free(k) {
                        uvs[i][k] = (uvs[i][k] + d.clamp(-reach, reach)).clamp(-reach, 1.0 + reach);
                    }
                }
            }
        }
        None
    }
}

/// The point in both tangent planes and across `t` at a level.
fn three(spots: &[Spot; 2], t: Vec3, level: f64) -> Option<Vec3> {
    let (a, b) = (spots[0].normal, spots[1].normal);
    let ab = a.cross(&b);
    let det = ab.dot(&t);
    if det.abs() <= TANGENT * 0.1 {
        return None;
    }
    let rhs = [a.dot(&spots[0].point), b.dot(&spots[1].point), level];
    Some((b.cross(&t) * rhs[0] + t.cross(&a) * rhs[1] + ab * rhs[2]) / det)
}

/// Parameters at a share of the way.
fn between(from: &Uvs, to: &Uvs, share: f64) -> Uvs {
    [0, 1].map(|i| [0, 1].map(|k| from[i][k] + (to[i][k] - from[i][k]) * share))
}

impl State {
    pub(super) fn uvs(&self) -> &Uvs {
        &self.uvs
    }

    pub(super) fn along(&self) -> Vec3 {
        self.along
    }
}
