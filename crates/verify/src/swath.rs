//! What a tool sweeps on many ways, in a tree of boxes.

use aptc_geometry::{Profile, Vec3};

use crate::between::{angle, between_poses, bulge};
use crate::sweep::Sweep;
use crate::tool::{Pose, Tool};

/// Ways in a leaf.
const LEAF: usize = 4;

/// The ways of a tool.
#[derive(Debug)]
pub(crate) struct Swath {
    profile: Profile,
    /// Does the tool end alone count?
    on: bool,
    ways: Vec<[Pose; 2]>,
    /// Numbers of the ways, those of a leaf beside each other.
    order: Vec<usize>,
    nodes: Vec<Node>,
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
    pub(crate) fn new(profile: &Profile, on: bool, ways: Vec<[Pose; 2]>) -> Self {
        let n = ways.len();
        let boxes: Vec<[Vec3; 2]> = ways.iter().map(|w| hull(profile, w)).collect();
        let order = (0..n).collect();
        let mut new = Self { profile: *profile, on, ways, order, nodes: Vec::new() };
        if n > 0 {
            new.grow(&boxes, 0, n);
        }
        new
    }

    fn tool(&self) -> Tool<'_> {
        if self.on { Tool::End } else { Tool::Solid(&self.profile) }
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

    /// Signed distance of a point from the tool at its nearest on a way, and the share of the way; never less
    /// than it is.
    pub(crate) fn distance(&self, i: usize, x: Vec3) -> (f64, f64) {
        let [a, b] = self.ways[i];
        let turn = angle(a.ta, b.ta);
        let meeting = Sweep::new(&self.tool(), a, b, turn).meet(x);
        if turn <= 1e-15 {
            return (meeting.distance, meeting.t);
        }
        (self.tool().near(&between_poses(&a, &b, meeting.t), x).0, meeting.t)
    }

    /// The same for a parallelogram `x +- a +- b`: no point of it is farther.
    pub(crate) fn farthest(&self, i: usize, x: Vec3, sides: [Vec3; 2], t: f64) -> f64 {
        let [a, b] = self.ways[i];
        let turns = angle(a.ta, b.ta) > 1e-15;
        let still = between_poses(&a, &b, t);
        let signs = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)];
        let corners = signs.map(|(s, t)| x + sides[0] * s + sides[1] * t);
        // What a tool sweeps is convex where it does not turn; else it is held still.
        let of = |p: Vec3| {
            if turns { self.tool().near(&still, p).0 } else { self.distance(i, p).0 }
        };
        corners.into_iter().map(of).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The least distance of a point from any way that comes within `margin`, with its number.
    pub(crate) fn least(&self, x: Vec3, margin: f64) -> Option<(f64, usize)> {
        let mut best: Option<(f64, usize)> = None;
        self.around(x, margin, |i| {
            let (d, _) = self.distance(i, x);
            if best.is_none_or(|b| d < b.0 || d <= b.0 && i < b.1) {
                best = Some((d, i));
            }
            false
        });
        best
    }
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
