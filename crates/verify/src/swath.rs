//! What a tool sweeps on many ways, in a tree of boxes.

use aptc_geometry::{Profile, Vec3};

use crate::between::{NO_TURN, Way, angle, between_poses, bulge};
use crate::solid::unit_or;
use crate::sweep::{Slack, Sweep};
use crate::tool::{Pose, Tool};

/// Ways in a leaf.
const LEAF: usize = 4;
/// Parts of a way.
const MOST: f64 = 64.0;
/// Looks for where a tool that turns is nearest, and by how much another place of the way may be nearer.
const LOOKS: u32 = 12;
const EXACT: f64 = 1e-10;

/// The ways of a tool.
#[derive(Debug)]
pub(crate) struct Swath {
    profile: Profile,
    /// Does the tool end alone count?
    on: bool,
    /// Ways, those on which the tool turns in parts.
    ways: Vec<[Pose; 2]>,
    /// The number of the way each of them is of.
    whole: Vec<usize>,
    /// Numbers of the parts, those of a leaf beside each other.
    order: Vec<usize>,
    nodes: Vec<Node>,
}

/// What lies within `slop` of the parallelogram `x +- sides[0] +- sides[1]`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    pub(crate) x: Vec3,
    pub(crate) sides: [Vec3; 2],
    pub(crate) slop: f64,
}

/// Distances of a parallelogram from the tool on a way.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hold {
    /// No point of it is farther.
    pub(crate) most: f64,
    /// Those of the ends by parameter, the farther one, between their corners.
    pub(crate) ends: [f64; 2],
}

#[derive(Clone, Copy, Debug)]
struct Node {
    lo: Vec3,
    hi: Vec3,
    below: Below,
}

#[derive(Clone, Copy, Debug)]
enum Below {
    Nodes([usize; 2]),
    Ways(usize, usize),
}

impl Swath {
    /// Of the ways; where the tool turns, in parts on which points seen from it leave their chords by no more than
    /// `fine` near the tool end.
    pub(crate) fn new(profile: &Profile, on: bool, all: &[[Pose; 2]], fine: f64) -> Self {
        let (mut ways, mut whole) = (Vec::with_capacity(all.len()), Vec::with_capacity(all.len()));
        for (i, way) in all.iter().enumerate() {
            ways.extend(parts(profile, way, fine));
            whole.resize(ways.len(), i);
        }
        let n = ways.len();
        let boxes: Vec<[Vec3; 2]> = ways.iter().map(|w| hull(profile, w)).collect();
        let order = (0..n).collect();
        let mut new = Self { profile: *profile, on, ways, whole, order, nodes: Vec::new() };
        if n > 0 {
            new.grow(&boxes, 0, n);
        }
        new
    }

    fn tool(&self) -> Tool<'_> {
        if self.on { Tool::End } else { Tool::Solid(&self.profile) }
    }

    /// The number of the way that part `i` is of.
    pub(crate) fn whole(&self, i: usize) -> usize {
        self.whole.get(i).copied().unwrap_or(i)
    }

    /// Ways, not parts.
    pub(crate) fn count(&self) -> usize {
        self.whole.last().map_or(0, |i| i + 1)
    }

    fn grow(&mut self, boxes: &[[Vec3; 2]], from: usize, to: usize) -> usize {
        let all = self.order[from..to].iter();
        let far = f64::INFINITY;
        let (lo, hi) = all.fold((Vec3::repeat(far), Vec3::repeat(-far)), |b, &i| {
            (b.0.inf(&boxes[i][0]), b.1.sup(&boxes[i][1]))
        });
        let below = if to - from <= LEAF {
            Below::Ways(from, to)
        } else {
            let axis = (hi - lo).imax();
            let middle = |i: &usize| boxes[*i][0][axis] + boxes[*i][1][axis];
            self.order[from..to].sort_by(|a, b| middle(a).total_cmp(&middle(b)).then(a.cmp(b)));
            let cut = usize::midpoint(from, to);
            Below::Nodes([self.grow(boxes, from, cut), self.grow(boxes, cut, to)])
        };
        self.nodes.push(Node { lo, hi, below });
        self.nodes.len() - 1
    }

    /// Calls `look` for each way whose tool comes within `margin` of the point, until it says so.
    pub(crate) fn around(&self, x: Vec3, margin: f64, mut look: impl FnMut(usize) -> bool) {
        let Some(root) = self.nodes.len().checked_sub(1) else { return };
        let mut stack = vec![root];
        while let Some(node) = stack.pop() {
            let Node { lo, hi, below } = self.nodes[node];
            let out = (x - x.sup(&lo).inf(&hi)).amax();
            if out > margin {
                continue;
            }
            match below {
                Below::Nodes(pair) => stack.extend(pair),
                Below::Ways(from, to) => {
                    for &i in &self.order[from..to] {
                        if look(i) {
                            return;
                        }
                    }
                }
            }
        }
    }

    /// What the distance of the middle of a piece from way `i` is no less than; `None` where all of the piece is seen to be farther
    /// than `most`. A look at both ends.
    pub(crate) fn bound(&self, i: usize, piece: &Piece, most: f64) -> Option<f64> {
        let [a, b] = self.ways[i];
        let tool = self.tool();
        let sweep = Sweep::new(&tool, a, b, angle(a.ta, b.ta));
        let meeting = sweep.glance(piece.x);
        let least = |all: &dyn Fn(Vec3) -> f64, enough: f64| {
            let slack = |m: Vec3| Slack { by: [0.0; 2], all: all(m) };
            sweep.proved(&meeting, piece.x, piece.radius(), enough, slack).0
        };
        let slack =
            |m: Vec3| m.dot(&piece.sides[0]).abs() + m.dot(&piece.sides[1]).abs() + piece.slop;
        // Most ways are farther, and of those no more is asked.
        let near = least(&slack, most.next_up()) <= most;
        near.then(|| least(&|_| 0.0, f64::INFINITY))
    }

    /// Signed distance of a point from the tool at its nearest on a way, and the share of the way; never less
    /// than it is. Where the axis turns it is looked for until it is no more than `enough`.
    pub(crate) fn distance(&self, i: usize, x: Vec3, enough: f64) -> (f64, f64) {
        let [a, b] = self.ways[i];
        let turn = angle(a.ta, b.ta);
        let meeting = Sweep::new(&self.tool(), a, b, turn).meet(x);
        if turn <= NO_TURN {
            return (meeting.distance, meeting.t);
        }
        self.turning([a, b], x, meeting.t, enough)
    }

    /// The same where the axis turns, from a share of the way at which the chord of the point, as seen from the tool, is nearest:
    /// its arc is off the chord by as much as a scallop may be high, and nearest elsewhere.
    fn turning(&self, [a, b]: [Pose; 2], x: Vec3, t: f64, enough: f64) -> (f64, f64) {
        let (way, tool) = (Way::new(a, b), self.tool());
        let spin = unit_or(a.ta.cross(&b.ta), Vec3::zeros()) * way.turn;
        let at = |t: f64| {
            let pose = way.at(t);
            let (distance, m) = tool.near(&pose, x);
            let rate = -m.dot(&(b.te - a.te + spin.cross(&(x - pose.te))));
            (distance, t, rate)
        };
        let mut best = at(t);
        let end = if best.2 > 0.0 { 0.0 } else { 1.0 };
        let near = |best: (f64, f64, f64)| (best.0, best.1);
        if best.0 <= enough || best.2.abs() * (t - end).abs() <= EXACT {
            return near(best);
        }
        // Regula falsi; the end that stays twice counts half.
        let (mut from, mut to) = (best, at(end));
        for _ in 0..LOOKS {
            if to.0 < best.0 {
                best = to;
            }
            let room = (to.1 - from.1).abs();
            let done = best.0 <= enough || to.2.abs().min(from.2.abs()) * room <= EXACT;
            if done || (from.2 > 0.0) == (to.2 > 0.0) {
                break;
            }
            let now = at(from.1 - from.2 * (to.1 - from.1) / (to.2 - from.2));
            if (now.2 > 0.0) == (to.2 > 0.0) {
                from.2 *= 0.5;
            } else {
                from = to;
            }
            to = now;
        }
        near(best)
    }

    /// How far the parallelogram of a piece is from a way, closely where the first look does not show it to be no farther than
    /// `enough`.
    pub(crate) fn hold(&self, i: usize, piece: &Piece, enough: f64) -> Hold {
        let [a, b] = self.ways[i];
        let turns = angle(a.ta, b.ta) > NO_TURN;
        let hold = self.hold_by(i, piece, f64::INFINITY);
        // All corners in one manner: between what two manners tell of one place the tool would seem to turn.
        if turns && hold.most > enough { self.hold_by(i, piece, f64::NEG_INFINITY) } else { hold }
    }

    fn hold_by(&self, i: usize, piece: &Piece, close: f64) -> Hold {
        let [a, b] = self.ways[i];
        let turn = angle(a.ta, b.ta);
        let signs = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)];
        let corners = signs.map(|(s, t)| {
            self.distance(i, piece.x + piece.sides[0] * s + piece.sides[1] * t, close)
        });
        let most = corners.iter().map(|c| c.0).fold(f64::NEG_INFINITY, f64::max);
        let (first, last) = corners
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |r, c| (r.0.min(c.1), r.1.max(c.1)));
        // What a tool sweeps is convex where it does not turn. Else a point between the corners, seen from the tool at
        // the share of the way between theirs, is between what they are but for second derivatives of that view.
        let spread = last - first;
        let bent = if turn > 1e-15 && spread > 0.0 {
            let way = (b.te - a.te).norm();
            let lever = (piece.x - a.te).norm() + piece.radius() + way;
            let way = turn * turn * lever + 2.0 * turn * way;
            spread * (0.125 * way * spread + 0.5 * turn * piece.radius())
        } else {
            0.0
        };
        let mean = |i: usize, j: usize| 0.5 * (corners[i].0 + corners[j].0);
        let ends = [mean(0, 1).max(mean(2, 3)), mean(0, 2).max(mean(1, 3))];
        Hold { most: most + bent, ends }
    }

    /// The least distance of a point from any way that comes within `margin`, with the number of its part.
    pub(crate) fn least(&self, x: Vec3, margin: f64) -> Option<(f64, usize)> {
        let mut best: Option<(f64, usize)> = None;
        let point = Piece { x, sides: [Vec3::zeros(); 2], slop: 0.0 };
        self.around(x, margin, |i| {
            if best.is_some_and(|b| self.bound(i, &point, b.0).is_none()) {
                return false;
            }
            let (d, _) = self.distance(i, x, f64::NEG_INFINITY);
            if best.is_none_or(|b| d < b.0 || d <= b.0 && i < b.1) {
                best = Some((d, i));
            }
            false
        });
        best
    }
}

impl Piece {
    /// Radius of the sphere about the middle that holds the parallelogram.
    pub(crate) fn radius(&self) -> f64 {
        self.sides[0].norm() + self.sides[1].norm()
    }
}

/// A way in parts.
fn parts(profile: &Profile, way: &[Pose; 2], fine: f64) -> impl Iterator<Item = [Pose; 2]> {
    let [a, b] = *way;
    let turn = angle(a.ta, b.ta);
    let bent = 0.25 * turn * (b.te - a.te).norm() + bulge(profile.widest(), turn);
    let n = if bent > fine { (bent / fine).sqrt().ceil().min(MOST) } else { 1.0 };
    let at = move |k: f64| between_poses(&a, &b, k / n);
    std::iter::successors(Some(0.0), |k| Some(k + 1.0))
        .take_while(move |k| *k < n)
        .map(move |k| [if k > 0.0 { at(k) } else { a }, at(k + 1.0)])
}

/// A box about all of the tool on its way.
fn hull(profile: &Profile, way: &[Pose; 2]) -> [Vec3; 2] {
    let far = f64::INFINITY;
    let mut out = [Vec3::repeat(far), Vec3::repeat(-far)];
    let room = Vec3::repeat(profile.widest() + bulge(profile.reach(), angle(way[0].ta, way[1].ta)));
    for pose in way {
        for z in [profile.bottom(), profile.height()] {
            let p = pose.te + pose.ta * z;
            out = [out[0].inf(&(p - room)), out[1].sup(&(p + room))];
        }
    }
    out
}

#[cfg(test)]
#[path = "swath_tests.rs"]
mod tests;
