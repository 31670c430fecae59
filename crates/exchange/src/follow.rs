//! Borders of faces followed along their edges, exactly, in the parameters of a surface; the box that they leave of it.

use aptc_geometry::Vec3;

use crate::border::{Border, Line, following};
use crate::step::edges::Edge;
use crate::step::forms::Form;

/// A border may leave the sides of its box by this share of the face's size.
const SIDES: f64 = 1e-5;
/// And its surface by this share.
const SURFACE: f64 = 1e-2;
/// A parameter turns by this part of its period at most from one place of an edge to the next.
const TURN: f64 = 0.125;
/// How often a stretch of an edge is halved for that.
const HALVINGS: u32 = 40;
/// Steps to where a parameter is greatest.
const STEPS: usize = 24;

/// Evaluations of curves, or of what takes as long, for the borders of a file.
pub(crate) const WORK: u64 = 200_000_000;

/// The work that is left for the borders of a file.
pub(crate) struct Work(u64);

impl Work {
    pub(crate) fn new() -> Self {
        Self(WORK)
    }

    /// Takes work off what is left; `None` when there is none.
    pub(crate) fn take(&mut self, work: u64) -> Option<()> {
        self.0 = self.0.saturating_sub(work);
        (self.0 > 0).then_some(())
    }

    pub(crate) fn spent(&self) -> bool {
        self.0 == 0
    }
}

/// What a border lies in.
pub(crate) trait Ground {
    /// After how much each parameter comes back to the same place.
    fn periods(&self) -> [Option<f64>; 2];
    /// The parameters of a place of an edge; `None` for the one that is none there, at a pole or tip.
    fn parameters(&self, p: Vec3) -> [Option<f64>; 2];
    /// How far the place of these parameters is from that of the edge.
    fn off(&self, own: [f64; 2], p: Vec3) -> f64;
    /// What the parameters of a place take, as a number of evaluations of a curve.
    fn cost(&self) -> u64;
}

impl Ground for Form {
    fn periods(&self) -> [Option<f64>; 2] {
        self.plane().periods
    }

    fn parameters(&self, p: Vec3) -> [Option<f64>; 2] {
        self.parameters(p)
    }

    fn off(&self, own: [f64; 2], p: Vec3) -> f64 {
        (self.at(own) - p).norm()
    }

    fn cost(&self) -> u64 {
        self.cost()
    }
}

/// A place of an edge, and its parameters where it has some.
#[derive(Clone, Copy)]
struct Look {
    edge: usize,
    t: f64,
    own: [Option<f64>; 2],
}

/// The box of the face that closed lines on a surface bound, the face on their left; `None` where they do not tell it. No line
/// at all bounds all of a surface that has no border.
pub(crate) fn bounded(lines: &mut [Line], form: &Form) -> Option<Border> {
    let mut border = form.plane().bounded(lines)?;
    let sound = border.range.iter().all(|[a, b]| {
        let least = 1e-9 * a.abs().max(b.abs());
        (b - a).is_finite() && b - a > least
    });
    let places = || lines.iter().flat_map(|l| &l.places);
    // A line that never leaves the sides of the box goes round it.
    let points: Vec<Vec3> = places().map(|p| form.at(*p)).collect();
    let room = SIDES * size(&points);
    let on = |(p, point): (&[f64; 2], &Vec3)| {
        let mut sides = (0..2).flat_map(|k| border.range[k].map(|end| (k, end)));
        sides.any(|(k, end)| {
            let mut side = *p;
            side[k] = end;
            (form.at(side) - point).norm() <= room
        })
    };
    border.whole &= places().zip(&points).all(on);
    sound.then_some(border)
}

fn size(points: &[Vec3]) -> f64 {
    let Some(first) = points.first() else { return 0.0 };
    let [low, high] = points.iter().fold([*first; 2], |b, p| [b[0].inf(p), b[1].sup(p)]);
    (high - low).norm()
}

/// The parameters along the edges of a loop, with the face on the left, each parameter that comes round going on from the
/// place before.
pub(crate) fn follow(
    work: &mut Work,
    edges: &[Edge],
    form: &impl Ground,
    left: bool,
) -> Option<Line> {
    let periods = form.periods();
    let mut looks = Vec::new();
    let mut points = Vec::new();
    let mut farthest = 0.0_f64;
    for (edge, along) in edges.iter().enumerate() {
        let mut look = |t: f64| {
            work.take(form.cost())?;
            let p = along.at(t);
            let own = form.parameters(p);
            points.push(p);
            if let [Some(u), Some(v)] = own {
                farthest = farthest.max(form.off([u, v], p));
            }
            Some(Look { edge, t, own })
        };
        let mut last: Option<Look> = None;
        for t in along.looks() {
            let next = look(t)?;
            if let Some(last) = last {
                between(&mut looks, last, next, &periods, HALVINGS, &mut look)?;
            }
            looks.push(next);
            last = Some(next);
        }
    }
    if farthest > SURFACE * size(&points) {
        return None;
    }
    if !left {
        looks.reverse();
    }
    // It begins, and ends, where both parameters are known.
    let first = looks.iter().position(|l| l.own.iter().all(Option::is_some))?;
    looks.rotate_left(first);
    looks.push(looks[0]);
    let mut places: Vec<[f64; 2]> = Vec::with_capacity(looks.len());
    let mut of: Vec<Option<usize>> = Vec::with_capacity(looks.len());
    // The parameter that a pole has not, and the other one's value there and before.
    let mut pole: Option<(usize, f64, f64)> = None;
    for (i, look) in looks.iter().enumerate() {
        let last = places.last().copied();
        let near = |k: usize, x: f64| match (last, periods[k]) {
            (Some(last), Some(period)) => x + period * ((last[k] - x) / period).round(),
            _ => x,
        };
        let k = match look.own {
            [Some(u), Some(v)] => {
                let mut place = [near(0, u), near(1, v)];
                if let (Some((k, at, before)), Some(last)) = (pole.take(), last) {
                    // Along the pole the face is on the left too.
                    if let Some(period) = periods[k] {
                        let rising = (at > before) == (k == 1);
                        place[k] = if rising {
                            following(last[k], place[k], period)
                        } else {
                            -following(-last[k], -place[k], period)
                        };
                    }
                    let mut behind = place;
                    behind[1 - k] = at;
                    places.push(behind);
                    of.push(None);
                }
                places.push(place);
                of.push(Some(i));
                continue;
            }
            [None, Some(_)] => 0,
            [Some(_), None] => 1,
            [None, None] => return None,
        };
        let (Some(last), Some(at)) = (last, look.own[1 - k]) else { return None };
        if pole.is_none() {
            let at = near(1 - k, at);
            pole = Some((k, at, last[1 - k]));
            let mut place = last;
            place[1 - k] = at;
            places.push(place);
            of.push(None);
        }
    }
    let (first, last) = (places[0], places[places.len() - 1]);
    let rounds =
        [0, 1].map(|k| periods[k].map_or(0.0, |period| ((last[k] - first[k]) / period).round()));
    let highest = extremes(work, edges, form, &looks, &places, &of)?;
    places.extend(highest.iter().map(|(_, p)| *p));
    if !highest.is_empty() {
        // Each behind the place that it is next to.
        let n = places.len() - highest.len();
        let mut order: Vec<(usize, [f64; 2])> = places[..n].iter().copied().enumerate().collect();
        order.extend(highest);
        order.sort_by_key(|(i, _)| *i);
        places = order.into_iter().map(|(_, p)| p).collect();
    }
    let poles = looks.iter().any(|l| l.own.iter().any(Option::is_none));
    Some(Line { places, rounds, poles })
}

/// The places between two that a parameter turns too far between.
fn between(
    looks: &mut Vec<Look>,
    a: Look,
    b: Look,
    periods: &[Option<f64>; 2],
    halvings: u32,
    look: &mut impl FnMut(f64) -> Option<Look>,
) -> Option<()> {
    let far = |k: usize| match (a.own[k], b.own[k], periods[k]) {
        (Some(x), Some(y), Some(period)) => {
            let by = (y - x) / period;
            (by - by.round()).abs() > TURN
        }
        _ => false,
    };
    if !far(0) && !far(1) {
        return Some(());
    }
    let halvings = halvings.checked_sub(1)?;
    let middle = look(0.5 * (a.t + b.t))?;
    between(looks, a, middle, periods, halvings, look)?;
    looks.push(middle);
    between(looks, middle, b, periods, halvings, look)
}

/// Where a parameter is greatest or least within an edge, by parabolas through three places, each with the number of the place
/// next to it.
fn extremes(
    work: &mut Work,
    edges: &[Edge],
    form: &impl Ground,
    looks: &[Look],
    places: &[[f64; 2]],
    of: &[Option<usize>],
) -> Option<Vec<(usize, [f64; 2])>> {
    let periods = form.periods();
    let mut found = Vec::new();
    for (k, sign) in [(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0)] {
        let all = || places.iter().map(|p| sign * p[k]);
        let top = all().fold(f64::NEG_INFINITY, f64::max);
        let least = all().fold(f64::INFINITY, f64::min);
        let size = (top - least).max(1e-3 * top.abs().max(least.abs()));
        for i in 1..places.len().saturating_sub(1) {
            let [Some(a), Some(b), Some(c)] =
                [i - 1, i, i + 1].map(|i| of[i].map(|look| &looks[look]))
            else {
                continue;
            };
            let [x, y, z] = [i - 1, i, i + 1].map(|i| sign * places[i][k]);
            let bend = 2.0 * y - x - z;
            if a.edge != b.edge
                || b.edge != c.edge
                || x > y
                || z > y
                || y + bend < top
                || bend <= 1e-12 * size
            {
                continue;
            }
            let value = |work: &mut Work, t: f64| {
                work.take(form.cost())?;
                let [u, v] = form.parameters(edges[b.edge].at(t));
                let own = [u?, v?];
                let near = |k: usize| match periods[k] {
                    Some(p) => own[k] + p * ((places[i][k] - own[k]) / p).round(),
                    None => own[k],
                };
                Some([near(0), near(1)])
            };
            let mut three = [(a.t, x), (b.t, y), (c.t, z)];
            let mut best = None;
            for _ in 0..STEPS {
                let [(ta, x), (tb, y), (tc, z)] = three;
                let (p, q) = ((tb - ta) * (y - z), (tb - tc) * (y - x));
                let t = tb - 0.5 * ((tb - ta) * p - (tb - tc) * q) / (p - q);
                let inside = (t - ta) * (t - tc) < 0.0;
                if !inside || (t - tb).abs() <= 1e-9 * (c.t - a.t).abs() {
                    break;
                }
                // At a pole a parameter has none.
                let Some(place) = value(work, t) else {
                    if work.spent() {
                        return None;
                    }
                    break;
                };
                let new = (t, sign * place[k]);
                let before = (t - tb) * (tc - ta) < 0.0;
                three = match (new.1 > y, before) {
                    (true, true) => [three[0], new, three[1]],
                    (true, false) => [three[1], new, three[2]],
                    (false, true) => [new, three[1], three[2]],
                    (false, false) => [three[0], three[1], new],
                };
                if new.1 > y {
                    best = Some(place);
                }
            }
            found.extend(best.map(|place| (i, place)));
        }
    }
    Some(found)
}
