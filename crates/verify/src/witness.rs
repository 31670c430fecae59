//! That the tool is nowhere too far from a curved surface: a point of the surface that goes along with it.
//!
//! Between two positions of the tool with points p and q of the surface near it, the point that runs
//! evenly from p to q leaves the surface by no more than the sag of the chart, and its distance from a tool
//! that does not turn is a convex function of the way. So the gap is at most that between the ends.

use std::cell::Cell;

use aptc_geometry::Vec3;

use crate::demand::parabola;
use crate::pile::Pile;
use crate::search::{Aim, Clearance, Moved, clearance};
use crate::sheet::{Sheet, Spot};
use crate::sweep::Sweep;
use crate::tool::{Pose, Tool};

/// Rounds of the descent to the nearest place.
const ROUNDS: usize = 40;
/// Halvings of a vector.
const DEPTH: u32 = 24;
/// Searches of the whole surface for one vector, each where a descent ended in a place that is too far.
const SEARCHES: u32 = 48;
/// Positions at which one vector is looked at.
const MOST: u32 = 2000;

/// The greatest gap along the vector.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Excess {
    /// It is nowhere more.
    Within(f64),
    /// Here it is at least this much: share of the way, gap.
    Beyond(f64, f64),
    /// It may be this much here.
    Open(f64, f64),
}

/// A place of the surface with its distance from the tool at a position.
#[derive(Clone, Copy, Debug)]
struct Touch {
    t: f64,
    pose: Pose,
    gap: f64,
    spot: Spot,
    p: Vec3,
}

/// Judges that the gap is at most `most`; `pose` gives positions in the surface's own system, `bend` bounds
/// how far the way of a point of the surface, seen from the tool, may leave its chord, for a stretch of the
/// vector and the longest lever.
pub(crate) fn excess(
    tool: &Tool<'_>,
    sheet: &Sheet,
    side: f64,
    pose: &dyn Fn(f64) -> Pose,
    turn: f64,
    most: f64,
) -> Excess {
    let touch = |t: f64, from: Spot| {
        let pose = pose(t);
        let (gap, spot, p) = descend(tool, &pose, sheet, from);
        Touch { t, pose, gap, spot, p }
    };
    let globally = |t: f64, enough: f64| {
        let sweep = Sweep::still(tool, pose(t));
        clearance(&sweep, &Moved { sheet, side, shift: 0.0 }, enough, Aim::Any)
    };
    let asked = Cell::new(0_u32);
    let somewhere = |t: f64| match globally(t, most) {
        Clearance { nearest: Some((_, _, spot)), .. } => Ok(touch(t, spot)),
        Clearance { least, .. } if least > most => Err(Excess::Beyond(t, least)),
        _ => Err(Excess::Open(t, f64::INFINITY)),
    };
    // Where even the nearest point is too far, that is shown; else its place is where to go on. Most of what it
    // seems too far is asked for first, which is soon shown or found, then less and less.
    let settle = |mut now: Touch| -> Result<Touch, Excess> {
        for share in [0.95, 0.7, 0.4, 0.2, 0.1, 0.03, 0.01, 0.0] {
            if now.gap <= most {
                return Ok(now);
            }
            asked.set(asked.get() + 1);
            if asked.get() > SEARCHES {
                break;
            }
            let enough = most + share * (now.gap - most);
            let Clearance { least, nearest } = globally(now.t, enough);
            if least > most {
                return Err(Excess::Beyond(now.t, least));
            }
            if let Some((.., spot)) = nearest {
                let again = touch(now.t, spot);
                if again.gap < now.gap {
                    now = again;
                }
            }
        }
        if now.gap <= most { Ok(now) } else { Err(Excess::Open(now.t, now.gap)) }
    };
    let first = match somewhere(0.0) {
        Ok(touch) => touch,
        Err(open) => return open,
    };
    let last = touch(1.0, first.spot);
    let (first, last) = match (settle(first), settle(last)) {
        (Ok(first), Ok(last)) => (first, last),
        (Err(Excess::Beyond(_, g)), Err(Excess::Beyond(t, h))) if h > g => {
            return Excess::Beyond(t, h);
        }
        (Err(e @ Excess::Beyond(..)), _) | (_, Err(e @ Excess::Beyond(..))) => return e,
        (Err(e), _) | (_, Err(e)) => return e,
    };
    let mut worst = f64::NEG_INFINITY;
    let mut stack = Pile::<Option<(Touch, Touch, u32)>, 64>::new();
    stack.push(Some((first, last, 0)));
    let mut seen = 0;
    while let Some(Some((a, b, depth))) = stack.pop() {
        let bound = between(tool, sheet, &a, &b, turn);
        if bound <= most {
            worst = worst.max(bound);
            continue;
        }
        seen += 1;
        let t = 0.5 * (a.t + b.t);
        if depth >= DEPTH || seen > MOST {
            return Excess::Open(t, bound);
        }
        let middle = match settle(touch(t, a.spot)) {
            Ok(m) => m,
            Err(e) => return e,
        };
        if !(stack.push(Some((middle, b, depth + 1))) && stack.push(Some((a, middle, depth + 1)))) {
            return Excess::Open(t, bound);
        }
    }
    Excess::Within(worst)
}

/// Greatest gap between two positions.
fn between(tool: &Tool<'_>, sheet: &Sheet, a: &Touch, b: &Touch, turn: f64) -> f64 {
    let angle = turn * (b.t - a.t);
    let lever = (a.p - a.pose.te).norm().max((b.p - b.pose.te).norm());
    let drift = ((b.p - a.p) - (b.pose.te - a.pose.te)).norm();
    let bend = (angle * angle * lever + 2.0 * angle * drift) / 8.0;
    let moving = parabola(a.gap, b.gap, sheet.sag(&a.spot, &b.spot) + bend);
    // One point for all of the stretch.
    let fixed = |p: Vec3| {
        let (g0, g1) = (tool.near(&a.pose, p).0, tool.near(&b.pose, p).0);
        let drift = (b.pose.te - a.pose.te).norm();
        parabola(g0, g1, (angle * angle * lever + 2.0 * angle * drift) / 8.0)
    };
    moving.min(fixed(a.p)).min(fixed(b.p))
}

/// The place of the surface nearest to the tool, going down from `spot`: distance, place, point. Newton's
/// method with differences of the gradient; any result is true, the lowest is the sharpest.
pub(crate) fn descend(
    tool: &Tool<'_>,
    pose: &Pose,
    sheet: &Sheet,
    spot: Spot,
) -> (f64, Spot, Vec3) {
    let look = |spot: &Spot| {
        let jet = sheet.jet(spot);
        let (f, m) = tool.near(pose, jet.p);
        (f, [m.dot(&jet.d[0]), m.dot(&jet.d[1])], jet)
    };
    let mut spot = sheet.settle(spot);
    let (mut f, mut g, mut jet) = look(&spot);
    // Coarse first, which is soon near; then fine, for the sharp bend about an edge.
    let mut fine = false;
    for round in 0..2 * ROUNDS {
        fine |= round == ROUNDS;
        let size = [jet.d[0].norm().max(1e-300), jet.d[1].norm().max(1e-300)];
        if g[0].abs() <= 1e-15 * size[0] && g[1].abs() <= 1e-15 * size[1] {
            break;
        }
        // Differences over a small share of the tool, or of the distance.
        let scene = (tool.reach() + (jet.p - pose.te).norm()).max(1e-300);
        let coarse = 1e-5 * scene;
        let h = if fine { (0.1 * f.abs()).clamp(1e-8 * scene, coarse) } else { coarse };
        let shifted = |i: usize| {
            let mut s = spot;
            s.at[i] += h / size[i];
            look(&s).1
        };
        let (gu, gv) = (shifted(0), shifted(1));
        let per = [size[0] / h, size[1] / h];
        let (mut a, c) = ((gu[0] - g[0]) * per[0], (gv[1] - g[1]) * per[1]);
        let b = 0.5 * ((gu[1] - g[1]) * per[0] + (gv[0] - g[0]) * per[1]);
        // Enough is added to the Hessian that it goes down.
        let mut d = c;
        let scale = (size[0] * size[0] + size[1] * size[1]) / scene;
        let floor = 1e-9 * scale;
        let det = a * d - b * b;
        if !(a > floor * 1e-3 || d > floor * 1e-3) || det <= 0.0 {
            let lift = (a.abs() + d.abs() + 2.0 * b.abs()).max(floor);
            a += lift;
            d += lift;
        }
        let det = a * d - b * b;
        let mut step = [-(d * g[0] - b * g[1]) / det, -(a * g[1] - b * g[0]) / det];
        if !(step[0].is_finite() && step[1].is_finite()) {
            step = [
                -g[0] / (size[0] * size[0]) * 0.1 * scene,
                -g[1] / (size[1] * size[1]) * 0.1 * scene,
            ];
        }
        let mut moved = false;
        for _ in 0..12 {
            let next = Spot { at: [spot.at[0] + step[0], spot.at[1] + step[1]], ..spot };
            let next = sheet.settle(next);
            let (fn_, gn, jn) = look(&next);
            if fn_ < f {
                (spot, f, g, jet, moved) = (next, fn_, gn, jn, true);
                break;
            }
            step = step.map(|s| 0.25 * s);
        }
        if !moved {
            if fine {
                break;
            }
            fine = true;
        }
    }
    (f, spot, jet.p)
}
