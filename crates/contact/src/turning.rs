//! Sculptured surfaces beside a tool on a way on which its axis turns.

use std::collections::BinaryHeap;

use aptc_geometry::{Profile, Vec3};

use crate::bodies::Convex;
use crate::patches::{Clear, Look, PIECES, PatchPlace, PatchTree, Piece};
use crate::turned::{Turned, axis_between};

/// Halvings of the way, at most.
const HALVINGS: u32 = 16;
/// The way is divided so that the axis turns by no more on a part, radians.
const TURN: f64 = 0.1;
/// More than make half a turn.
const MOST: i32 = 32;

/// A part of the way.
struct Part<'a> {
    body: Turned<'a>,
    range: [f64; 2],
    halvings: u32,
    /// Where its halves stand, once they are asked for.
    halves: Option<[usize; 2]>,
}

/// The way from one tool end and axis to another, and its parts.
struct Parts<'a> {
    solid: (&'a Profile, f64),
    ends: [(Vec3, Vec3); 2],
    all: Vec<Part<'a>>,
}

impl PatchTree {
    /// Is no point of the surfaces deeper than `allowed` in a tool that moves straight from one place and axis
    /// to the other, while its axis turns evenly in the plane of both? The lower end of the profile is `up` above the tool
    /// end. Pieces that are not decided are halved, or the part of the way for which they are asked, whichever is more unsure.
    pub fn clear_turning(
        &self,
        solid: (&Profile, f64),
        ends: [(Vec3, Vec3); 2],
        allowed: f64,
    ) -> Clear {
        let limit = -allowed;
        let mut parts = Parts { solid, ends, all: Vec::new() };
        // The most suspicious first: beside the place where the tool comes to be too deep there is no end of halving.
        let mut heap = BinaryHeap::new();
        for part in 0..parts.divided() {
            let suspects = self.suspects(&parts.all[part].body, limit);
            heap.extend(suspects.into_iter().map(|piece| (piece, part)));
        }
        let mut deepest: Option<PatchPlace> = None;
        let mut looked = 0;
        while let Some((piece, part)) = heap.pop() {
            looked += 1;
            let body = parts.all[part].body;
            let Look { mut place, bound, low, split, unsure } = self.look(&body, &piece, limit);
            let bulge = body.slack(place.point, 0.0);
            if place.distance - bulge < limit {
                // The look tells no more than what the distance is at least.
                place.distance = body.near(place.point).0;
            }
            if place.distance + bulge < limit {
                return Clear::No(place);
            }
            if deepest.is_none_or(|d| place.distance < d.distance) {
                deepest = Some(place);
            }
            if bound >= limit {
                continue;
            }
            if looked > PIECES {
                return Clear::Unknown(deepest.unwrap_or(place));
            }
            // Is it as deep as it seems? Then nothing need be halved until a middle happens to be so.
            if let Some(deep) = self.as_deep(&body, &piece, low, limit) {
                return Clear::No(deep);
            }
            // While the middle itself is in doubt halves of the piece are, too.
            let unsure = unsure - bulge;
            if place.distance - bulge < limit || bulge > unsure && bound + bulge + unsure >= limit {
                let Some(halves) = parts.halves(part) else { return Clear::Unknown(place) };
                heap.extend(halves.map(|half| (Piece { bound, ..piece }, half)));
            } else {
                self.parts(piece, split, &mut |p| heap.push((Piece { bound, ..p }, part)));
            }
        }
        Clear::Yes
    }
}

impl<'a> Parts<'a> {
    /// Divides the way evenly; how many parts that are.
    fn divided(&mut self) -> usize {
        let [a, b] = self.ends;
        let angle = aptc_geometry::trig::angle_between(a.1, b.1);
        let count = (1..=MOST).find(|n| f64::from(*n) * TURN >= angle).unwrap_or(MOST);
        for k in 0..count {
            let range = [k, k + 1].map(|k| f64::from(k) / f64::from(count));
            self.put(range, 0);
        }
        self.all.len()
    }

    fn put(&mut self, range: [f64; 2], halvings: u32) -> usize {
        let [a, b] = self.ends;
        let ends = range.map(|t| match t {
            0.0 => a,
            1.0 => b,
            _ => (a.0 + (b.0 - a.0) * t, axis_between(a.1, b.1, t)),
        });
        let body = Turned::new(self.solid.0, self.solid.1, ends);
        self.all.push(Part { body, range, halvings, halves: None });
        self.all.len() - 1
    }

    /// The halves of a part, the first on top; `None` where it is not halved any more.
    fn halves(&mut self, part: usize) -> Option<[usize; 2]> {
        let Part { range: [from, to], halvings, halves, .. } = self.all[part];
        if halves.is_some() || halvings >= HALVINGS {
            return halves;
        }
        let middle = 0.5 * (from + to);
        let halves = [[middle, to], [from, middle]].map(|range| self.put(range, halvings + 1));
        self.all[part].halves = Some(halves);
        Some(halves)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::sculpt::{Patch, Vec4};
    use aptc_geometry::{Cutter, Sculptured, Tool};
    use proptest::prelude::*;

    /// A third of a cone 40 high and 50 wide.
    fn cone() -> PatchTree {
        let sin = aptc_geometry::trig::sin_deg(60.0);
        let corners = [(1.0, 0.0, 1.0), (0.5, sin, 0.5), (-0.5, sin, 1.0)];
        let [a, b, c] = corners.map(|(x, y, w)| Vec4::new(25.0 * x, 25.0 * y, 0.0, w));
        let rim = [a, (a + b * 2.0) / 3.0, (b * 2.0 + c) / 3.0, c];
        let net = rim.map(|end| {
            let tip = Vec4::new(0.0, 0.0, 40.0 * end.w, end.w);
            core::array::from_fn(|i| tip + (end - tip) * (i as f64 / 3.0))
        });
        PatchTree::new(&Sculptured::grid(vec![Patch::new(net)], 1, 1).unwrap())
    }

    /// A flat bottom that lies on a cone along its rulings, up to the tip, where pieces are far longer by one parameter than by
    /// the other.
    #[test]
    fn a_bottom_lies_on_a_cone() {
        let (tree, tip) = (cone(), Vec3::new(0.0, 0.0, 40.0));
        let profile = Profile::new(&Cutter::mill(10.0, 0.0, 60.0)).unwrap();
        let at = |turn: f64| {
            let (sin, cos) = aptc_geometry::trig::sin_cos(turn);
            let foot = Vec3::new(25.0 * cos, 25.0 * sin, 0.0);
            (foot, Vec3::new(40.0 * cos, 40.0 * sin, 25.0).normalize())
        };
        for turn in [0.1, 0.8, 1.9] {
            let (foot, ta) = at(turn);
            for ends in [[(tip, ta), (foot, ta)], [(tip, ta), (tip, at(2.0 - turn).1)]] {
                let clear = |allowed| tree.clear_turning((&profile, 0.0), ends, allowed);
                assert_eq!(clear(0.01), Clear::Yes, "{turn}");
                let down = ends.map(|(te, ta)| (te - ta * 0.02, ta));
                let deep = tree.clear_turning((&profile, 0.0), down, 0.01);
                assert!(matches!(deep, Clear::No(_)), "{turn} {deep:?}");
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        /// What is answered on both sides of the deepest place of many on the way.
        #[test]
        fn the_deepest_place_of_the_way_decides(
            z in prop::array::uniform16(-1.0_f64..1.0), corner in 0.2_f64..5.0, up in 0.0_f64..4.0,
            at in prop::array::uniform2(5.0_f64..55.0), by in prop::array::uniform3(-4.0_f64..4.0), low in -6.0_f64..6.0,
            lean in prop::array::uniform2(-0.4_f64..0.4), turn in prop::array::uniform2(-0.4_f64..0.4), wide: bool,
        ) {
            let net = core::array::from_fn(|j| {
                core::array::from_fn(|i| {
                    Vec4::new(20.0 * i as f64, 20.0 * j as f64, 12.0 * z[4 * j + i], 1.0)
                })
            });
            let surface = Sculptured::grid(vec![Patch::new(net)], 1, 1).unwrap();
            let tree = PatchTree::new(&surface);
            let profile = Profile::new(&Cutter::mill(12.0, corner, 60.0)).unwrap();
            let far = if wide { 1.0 } else { 0.1 };
            let axis = |k: f64| {
                let [x, y] = [0, 1].map(|i| lean[i] + k * far * turn[i]);
                Vec3::new(x, y, 1.0).normalize()
            };
            let te = Vec3::new(at[0], at[1], low);
            let ends = [(te, axis(0.0)), (te + Vec3::from(by), axis(1.0))];
            let mut least = f64::INFINITY;
            for k in 0..=40 {
                let t = f64::from(k) / 40.0;
                let ta = axis_between(ends[0].1, ends[1].1, t);
                let te = ends[0].0 + (ends[1].0 - ends[0].0) * t + ta * up;
                let tool = Tool { profile: &profile, te, ta };
                least = least.min(tree.deepest(&tool, 1e-7).unwrap().0.distance);
            }
            let clear = |allowed| tree.clear_turning((&profile, up), ends, allowed);
            let between = 0.05;
            prop_assert_eq!(clear(between - least), Clear::Yes);
            match clear(-between - least) {
                Clear::No(place) => prop_assert!(place.distance < least + between),
                other => prop_assert!(false, "{:?}", other),
            }
        }
    }
}
