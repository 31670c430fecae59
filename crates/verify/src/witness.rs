//! That the tool is nowhere too far from a curved surface: a point of the surface that goes along with it.
//!
//! Between two positions of the tool with points p and q of the surface near it, the point that runs
//! evenly from p to q leaves the surface by no more than the sag of the chart, and its distance from a tool
//! that does not turn is a convex function of the way. So the gap is at most that between the ends.

use std::cell::Cell;

use aptc_geometry::{Vec3, trig};

use crate::between::parabola;
use crate::deep::slide;
use crate::each::two;
use crate::pile::Pile;
use crate::search::{Aim, Clearance, Moved, clearance};
use crate::sheet::{Jet, Patch, Sheet, Spot};
use crate::sweep::Sweep;
use crate::tool::{Change, Pose, Tool};

/// Rounds of the descent to the nearest place.
const ROUNDS: usize = 40;
/// Share of the tool by which a place that is near enough may be farther than the nearest one.
const HARDLY: f64 = 1e-9;
/// Halvings of a vector.
const DEPTH: u32 = 24;
/// Searches of the whole surface for one vector, each where a descent ended in a place that is too far.
const SEARCHES: u32 = 48;
/// So many searches for one vector may come to no end in all, also once it is known to be too far somewhere: each takes a thousand
/// times as long as one that does.
const LOST: u32 = SEARCHES;
/// Positions at which one vector is looked at.
const MOST: u32 = 2000;
/// Positions at which a vector is looked at once it is known to be too far somewhere: how far it is at most is asked
/// to this share.
const FEW: u32 = 64;
const CLOSE: f64 = 0.05;
/// Lengths of the vector before up to which the place next to the tool is looked for as far ahead as this one is long.
const FARTHER: f64 = 4.0;
/// Times that a search for any place is made eight times as wide.
const WIDER: u32 = 24;

/// The greatest gap along the vector.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Excess {
    /// It is nowhere more.
    Within(f64),
    /// Here it is at least this much, and nowhere much more: share of the way, gap.
    Beyond(f64, f64),
    /// It may be this much here.
    Open(f64, f64),
}

/// A place of the surface with its distance from the tool at a position.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Touch {
    t: f64,
    pose: Pose,
    gap: f64,
    spot: Spot,
    pub(crate) jet: Jet,
    second: [Vec3; 3],
    /// Where it would have been looked for next.
    next: Spot,
}

/// A place of the surface next to the tool.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Near {
    pub(crate) spot: Spot,
    /// What was met there, when it was looked at.
    pub(crate) touch: Option<Touch>,
}

impl Near {
    pub(crate) fn jet(&self, sheet: &Sheet) -> Jet {
        self.touch.map_or_else(|| sheet.jet(&self.spot), |touch| touch.jet)
    }
}

/// Judges that the gap is at most `most`; `pose` gives positions in the surface's own system, `turn` is the angle by
/// which the axis turns. `near` has a place to begin with, the last,
/// and becomes those next to the tool at both ends; none unless the gap is allowed there. Where the gap is more the
/// place is told where it is greatest, to a twentieth of what is too much, as far as [`FEW`] looks show it.
pub(crate) fn excess(
    tool: &Tool<'_>,
    sheet: &Sheet,
    side: f64,
    pose: &dyn Fn(f64) -> Pose,
    turn: f64,
    most: f64,
    near: &mut Option<[Near; 2]>,
) -> Excess {
    let touch = |t: f64, from: Spot| {
        let pose = pose(t);
        let Down { far: gap, spot, jet, second, next } = meet(tool, &pose, sheet, side, from, most);
        Touch { t, pose, gap, spot, jet, second, next }
    };
    let globally = |t: f64, enough: f64| {
        let sweep = Sweep::still(tool, pose(t));
        clearance(&sweep, &Moved::whole(sheet, side, 0.0), enough, Aim::Any)
    };
    let (asked, lost) = (Cell::new(0_u32), Cell::new(0_u32));
    // Any place in the reach of the tool is good to begin with, or any at all.
    let somewhere = |t: f64| {
        let mut wide = most + tool.reach();
        for _ in 0..WIDER {
            match globally(t, wide) {
                Clearance { nearest: Some((_, _, spot)), .. } => return Ok(touch(t, spot)),
                Clearance { least, .. } if least > most => wide *= 8.0,
                _ => break,
            }
        }
        Err(Excess::Open(t, f64::INFINITY))
    };
    // Where even the nearest point is too far, that is shown: the gap is at least the second answer; else its place is
    // where to go on. Most of what it seems too far is asked for first, which is soon shown or found, then less and
    // less; from a nearer place all of it again.
    let settle = |mut now: Touch| -> (Touch, Option<f64>) {
        const SHARES: [f64; 8] = [0.95, 0.7, 0.4, 0.2, 0.1, 0.03, 0.01, 0.0];
        let mut shares = SHARES.iter();
        while now.gap > most
            && let Some(share) = shares.next()
        {
            asked.set(asked.get() + 1);
            if asked.get() > SEARCHES || lost.get() >= LOST {
                break;
            }
            let enough = most + share * (now.gap - most);
            let Clearance { least, nearest, .. } = globally(now.t, enough);
            lost.set(lost.get() + u32::from(least == f64::NEG_INFINITY));
            if least > most {
                return (now, Some(least));
            }
            if let Some((.., spot)) = nearest {
                let again = touch(now.t, spot);
                if now.gap - again.gap > 0.02 * (now.gap - most) {
                    shares = SHARES.iter();
                }
                if again.gap < now.gap {
                    now = again;
                }
            }
        }
        (now, None)
    };
    // Where the vector before ended this one begins.
    let again = |near: &Near| match &near.touch {
        Some(known) if known.pose == pose(0.0) => Touch { t: 0.0, ..*known },
        _ => touch(0.0, near.spot),
    };
    let before = near.take();
    let known = before.as_ref().map(|n| again(&n[1])).filter(|t| t.gap <= most);
    let first = match known.map_or_else(|| somewhere(0.0), Ok) {
        Ok(touch) => touch,
        Err(open) => return open,
    };
    // As far ahead as the vector before came, by the lengths of both.
    let ahead = |[from, to]: &[Near; 2]| {
        let way = |a: Vec3, b: Vec3| (b - a).norm_squared();
        let ratio = match (&from.touch, &to.touch) {
            (Some(a), Some(b)) => {
                (way(pose(0.0).te, pose(1.0).te) / way(a.pose.te, b.pose.te)).sqrt()
            }
            _ => 1.0,
        };
        let on = if ratio < FARTHER { ratio } else { 1.0 };
        let at = two([0, 1], |i| to.spot.at[i] + on * (to.spot.at[i] - from.spot.at[i]));
        let same = from.spot.chart == to.spot.chart && first.next == to.spot;
        same.then_some(Spot { at, ..to.spot })
    };
    let last = touch(1.0, before.as_ref().and_then(ahead).unwrap_or(first.spot));
    let bound = |a: &Touch, b: &Touch| between(tool, sheet, [a, b], turn, most);
    // As most are: nothing else is to be looked for.
    let within = first.gap <= most && last.gap <= most;
    let known = within.then(|| bound(&first, &last));
    if let Some(all) = known.filter(|all| *all <= most) {
        let next = |touch: Touch| Near { spot: touch.next, touch: Some(touch) };
        *near = Some([next(first), next(last)]);
        return Excess::Within(all);
    }
    let ends = [settle(first), settle(last)];
    let [first, last] = two(ends, |(touch, _)| touch);
    // Where the most was shown that is too much: share of the way, gap.
    let mut top: Option<(f64, f64)> = None;
    let raise = |top: &mut Option<(f64, f64)>, (touch, shown): &(Touch, Option<f64>)| {
        if let Some(gap) = *shown
            && top.is_none_or(|(_, g)| gap > g)
        {
            *top = Some((touch.t, gap));
        }
    };
    ends.iter().for_each(|end| raise(&mut top, end));
    match [first, last].into_iter().find(|end| end.gap > most) {
        Some(end) if top.is_none() => return Excess::Open(end.t, end.gap),
        Some(_) => {}
        None => *near = Some(two([first, last], |t| Near { spot: t.next, touch: Some(t) })),
    }
    let all = known.unwrap_or_else(|| bound(&first, &last));
    if top.is_none() && all <= most {
        return Excess::Within(all);
    }
    let mut worst = f64::NEG_INFINITY;
    let stretch = |a: Touch, b: Touch, depth| (a, b, depth, bound(&a, &b));
    let mut stack = Pile::<(Touch, Touch, u32, f64), 96>::new();
    stack.push((first, last, 0, all));
    let (mut seen, mut beyond) = (0, 0);
    loop {
        // Where it is known to be too far somewhere, the most is looked for.
        let next = if top.is_some() { stack.pop_greatest(|s| s.3) } else { stack.pop() };
        let Some((a, b, depth, bound)) = next else { break };
        if bound <= top.map_or(most, |(_, gap)| gap + CLOSE * (gap - most)) {
            worst = worst.max(bound);
            continue;
        }
        seen += 1;
        let t = 0.5 * (a.t + b.t);
        if top.is_some() {
            beyond += 1;
            // Each look has its own searches.
            asked.set(0);
            if beyond > FEW || depth >= DEPTH {
                continue;
            }
        } else if depth >= DEPTH || seen > MOST {
            return Excess::Open(t, bound);
        }
        let middle = settle(touch(t, a.spot));
        raise(&mut top, &middle);
        let middle = middle.0;
        if middle.gap > most && top.is_none() {
            return Excess::Open(t, middle.gap);
        }
        let room = stack.push(stretch(middle, b, depth + 1));
        if !(room && stack.push(stretch(a, middle, depth + 1))) && top.is_none() {
            return Excess::Open(t, bound);
        }
    }
    top.map_or(Excess::Within(worst), |(t, gap)| Excess::Beyond(t, gap))
}

/// Greatest gap between two positions, no closer than to `enough`.
fn between(tool: &Tool<'_>, sheet: &Sheet, [a, b]: [&Touch; 2], turn: f64, enough: f64) -> f64 {
    let angle = turn * (b.t - a.t);
    let lever = (a.jet.p - a.pose.te).norm().max((b.jet.p - b.pose.te).norm());
    let drift = ((b.jet.p - a.jet.p) - (b.pose.te - a.pose.te)).norm();
    let bend = (angle * angle * lever + 2.0 * angle * drift) / 8.0;
    let rise = if turn == 0.0 { rise(tool, sheet, a, b, drift) } else { None };
    let rise = rise.unwrap_or_else(|| sheet.sag(&a.spot, &b.spot) + bend);
    let moving = parabola(a.gap, b.gap, rise);
    if moving <= enough {
        return moving;
    }
    // One point for all of the stretch.
    let fixed = |p: Vec3| {
        let (g0, g1) = (tool.near(&a.pose, p).0, tool.near(&b.pose, p).0);
        let drift = (b.pose.te - a.pose.te).norm();
        parabola(g0, g1, (angle * angle * lever + 2.0 * angle * drift) / 8.0)
    };
    moving.min(fixed(a.jet.p)).min(fixed(b.jet.p))
}

/// By how much the gap may rise over that between two positions of a tool that does not turn, in the middle of the way.
///
/// On straight parameters the place of the surface goes beside its chord by no more than `t (1 - t) / 2` of its second derivative.
/// As the distance d is convex it is no more there than on the chord and what its gradient makes of that: the direction m of one
/// end, but for how far this turns, by the radius with which the tool is rounded, where the place is within `drift` of both.
fn rise(tool: &Tool<'_>, sheet: &Sheet, a: &Touch, b: &Touch, drift: f64) -> Option<f64> {
    let (radius, top) = tool.rounding()?;
    if a.spot.chart != b.spot.chart {
        return None;
    }
    let [du, dv] = two([0, 1], |i| b.spot.at[i] - a.spot.at[i]);
    let at = two([0, 1], |i| 0.5 * (a.spot.at[i] + b.spot.at[i]));
    let half = [0.5 * du.abs(), 0.5 * dv.abs()];
    let piece = Patch { chart: a.spot.chart, at, half, ..Patch::default() };
    let (bend, vary) = sheet.bend_on(&piece, &b.second);
    let [uu, uv, vv] = [du * du, 2.0 * du * dv, dv * dv];
    let (second, off) = (
        bend[0] * uu + bend[1] * uv + bend[2] * vv,
        vary[0] * uu + vary[1] * uv.abs() + vary[2] * vv,
    );
    let most = 0.125 * (second.norm() + off);
    let (d, m) = tool.near(&a.pose, a.jet.p);
    let far = drift + most;
    let inside = radius - (far - d).max(0.0);
    let above = (a.jet.p - a.pose.te).dot(&a.pose.ta) + far;
    // Neither near the edge of the top nor as deep as the ball's middle.
    if !(inside > 0.5 * radius && above <= top && far <= 0.25 * radius && d.abs() <= 0.25 * radius)
    {
        return None;
    }
    let along = 0.125 * (off - m.dot(&second));
    Some((along + most * (far / inside)).max(0.0))
}

/// A place of the surface not farther than `most` from the tool, or the nearest that is found from `spot` on.
fn meet(tool: &Tool<'_>, pose: &Pose, sheet: &Sheet, side: f64, spot: Spot, most: f64) -> Down {
    /// Times that the way along an edge and that down take turns.
    const TURNS: u32 = 4;
    let mut now = descend_to(tool, pose, sheet, spot, most);
    for _ in 0..TURNS {
        if now.far <= most {
            break;
        }
        let p = now.jet.p - tool.near(pose, now.jet.p).1 * now.far;
        let Some(deep) = slide(pose, sheet, side, p, now.spot) else { break };
        let next = descend_to(tool, pose, sheet, deep.spot, most);
        if next.far >= now.far {
            break;
        }
        now = next;
    }
    now
}

/// The place of the surface nearest to the tool, going down from `spot`: distance, place, what is there. Newton's
/// method; any result is true, the lowest is the sharpest.
pub(crate) fn descend(tool: &Tool<'_>, pose: &Pose, sheet: &Sheet, spot: Spot) -> (f64, Spot, Jet) {
    let Down { far, spot, jet, .. } = descend_to(tool, pose, sheet, spot, f64::NEG_INFINITY);
    (far, spot, jet)
}

/// Where a way down ended: distance, place, what is there, and where the next step would have led.
struct Down {
    far: f64,
    spot: Spot,
    jet: Jet,
    second: [Vec3; 3],
    next: Spot,
}

/// The same no farther than to a place that is no more than `enough` away; the first only where the nearest is hardly nearer.
fn descend_to(tool: &Tool<'_>, pose: &Pose, sheet: &Sheet, spot: Spot, enough: f64) -> Down {
    let slopes = |m: Vec3, jet: &Jet| [m.dot(&jet.d[0]), m.dot(&jet.d[1])];
    let look = |spot: &Spot| {
        let (jet, second) = sheet.bent(spot);
        let (f, m, change) = tool.bent(pose, jet.p);
        Look { f, g: slopes(m, &jet), m, second, change, jet }
    };
    let slope = |spot: &Spot| {
        let jet = sheet.jet(spot);
        slopes(tool.near(pose, jet.p).1, &jet)
    };
    let mut spot = sheet.settle(spot);
    let mut now = look(&spot);
    let mut way = Way::Exact;
    let mut next = None;
    for round in 0..2 * ROUNDS {
        if round == ROUNDS {
            way = Way::Fine;
        }
        let &Look { f, g, jet: Jet { d, p, .. }, .. } = &now;
        if round > 0 && f <= enough {
            break;
        }
        let size = [d[0].norm().max(1e-300), d[1].norm().max(1e-300)];
        if g[0].abs() <= 1e-15 * size[0] && g[1].abs() <= 1e-15 * size[1] {
            break;
        }
        // Differences over a small share of the tool, or of the distance.
        let scene = (tool.reach() + (p - pose.te).norm()).max(1e-300);
        let coarse = 1e-5 * scene;
        let [a, b, c] = if way == Way::Exact && now.change.sharpness() * coarse < 1.0 {
            now.hessian()
        } else {
            let fine = (0.1 * f.abs()).clamp(1e-8 * scene, coarse);
            let h = if way == Way::Fine { fine } else { coarse };
            let shifted = |i: usize| {
                let mut s = spot;
                s.at[i] += h / size[i];
                slope(&s)
            };
            let (gu, gv) = (shifted(0), shifted(1));
            let per = [size[0] / h, size[1] / h];
            let cross = 0.5 * ((gu[1] - g[1]) * per[0] + (gv[0] - g[0]) * per[1]);
            [(gu[0] - g[0]) * per[0], cross, (gv[1] - g[1]) * per[1]]
        };
        let scale = (size[0] * size[0] + size[1] * size[1]) / scene;
        let floor = 1e-9 * scale;
        let det = a * c - b * b;
        let mut step = if (a > floor * 1e-3 || c > floor * 1e-3) && det > 0.0 {
            [-(c * g[0] - b * g[1]) / det, -(a * g[1] - b * g[0]) / det]
        } else {
            downhill(g, [a, b, c], size, scene)
        };
        if round == 0 && f <= enough && det > 0.0 && a > 0.0 {
            let gain = -0.5 * (g[0] * step[0] + g[1] * step[1]);
            if gain <= HARDLY * scene {
                next = Some(step);
                break;
            }
        }
        if !(step[0].is_finite() && step[1].is_finite()) {
            step = [
                -g[0] / (size[0] * size[0]) * 0.1 * scene,
                -g[1] / (size[1] * size[1]) * 0.1 * scene,
            ];
        }
        // A step that gains less than the distance is rounded by leads nowhere.
        if (g[0] * step[0] + g[1] * step[1]).abs() <= 1e-16 * scene {
            break;
        }
        let mut moved = false;
        for _ in 0..12 {
            let next = Spot { at: [spot.at[0] + step[0], spot.at[1] + step[1]], ..spot };
            let next = sheet.settle(next);
            let there = look(&next);
            if there.f < f {
                (spot, now, moved) = (next, there, true);
                break;
            }
            step = two(step, |s| 0.25 * s);
        }
        if !moved {
            way = match way {
                Way::Exact => Way::Coarse,
                Way::Coarse => Way::Fine,
                Way::Fine => break,
            };
        }
    }
    let at = |by: [f64; 2]| Spot { at: [spot.at[0] + by[0], spot.at[1] + by[1]], ..spot };
    let next = next.map_or(spot, |by| sheet.settle(at(by)));
    Down { far: now.f, spot, jet: now.jet, second: now.second, next }
}

/// The step where the second derivatives `h` are not those of a dip: along either axis of them by Newton's method with the sign
/// that leads down, and no longer than a share of the scene. Beside a flank that lies nearly along a ruling the distance falls
/// evenly, by little, all the way to its end. `size` are the lengths of the derivatives by both parameters.
fn downhill(g: [f64; 2], [a, b, c]: [f64; 3], size: [f64; 2], scene: f64) -> [f64; 2] {
    /// Share of the scene that is a longest step, and least curvature over it that counts.
    const LONGEST: f64 = 0.5;
    const STRAIGHT: f64 = 1e-9;
    let [g0, g1] = [g[0] / size[0], g[1] / size[1]];
    let [a, b, c] = [a / (size[0] * size[0]), b / (size[0] * size[1]), c / (size[1] * size[1])];
    let (mean, half) = (0.5 * (a + c), 0.5 * (a - c));
    let root = trig::hypot(half, b);
    // The axis of the greater one.
    let (p, q) = if half >= 0.0 { (half + root, b) } else { (b, root - half) };
    let length = trig::hypot(p, q);
    let (p, q) = if length > 0.0 { (p / length, q / length) } else { (1.0, 0.0) };
    let (most, least) = (mean + root, mean - root);
    let floor = STRAIGHT / scene;
    let along = |slope: f64, bend: f64| {
        (-slope / bend.abs().max(floor)).clamp(-LONGEST * scene, LONGEST * scene)
    };
    let (x, y) = (along(p * g0 + q * g1, most), along(p * g1 - q * g0, least));
    [(p * x - q * y) / size[0], (q * x + p * y) / size[1]]
}

/// A place on the way down: distance, its slopes by the parameters, its gradient, the second derivatives of the surface and of the
/// tool's distance, and what is there.
#[derive(Clone, Copy, Debug)]
struct Look {
    f: f64,
    g: [f64; 2],
    m: Vec3,
    second: [Vec3; 3],
    change: Change,
    jet: Jet,
}

impl Look {
    /// The second derivatives of the distance by the parameters.
    fn hessian(&self) -> [f64; 3] {
        let bend =
            |i: usize, x: Vec3, y: Vec3| self.m.dot(&self.second[i]) + self.change.along(x, y);
        let [u, v] = self.jet.d;
        [bend(0, u, u), bend(1, u, v), bend(2, v, v)]
    }
}

/// Where the second derivatives come from: the closed form, which serves but next to edges of the tool; differences
/// over a coarse step, which is soon near; over a fine one for the sharp bend about an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    Exact,
    Coarse,
    Fine,
}

#[cfg(test)]
#[path = "witness_tests.rs"]
mod tests;
