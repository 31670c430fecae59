//! How a tool that stands near its surfaces, and not within their bands, is put into these before its motion.

use aptc_contact::Condition;

use super::band::AIM_TURNING;
use super::judge::{BETWEEN, between};
use super::keep::{Keep, Limits};
use super::track::{Aim, Node, Track, Trouble};
use crate::axis::AxisRule;

/// The place where it is put, so that it comes into both bands on its way and stays in those where it is: with the axis that the motion
/// asks for, else as it stands, higher or lower in the bands.
pub(super) fn put(track: &Track, node: &Node) -> Result<Node, Trouble> {
    /// How high in their bands, the first that serves.
    const HIGH: [f64; 3] = [0.5, 0.9, 0.1];
    let usual = track.settle(node.pose, &placing(track, node));
    if usual.as_ref().is_ok_and(|to| is_short(track, node, to) && comes_in(track, node, to)) {
        return usual;
    }
    let still = Track { axis: AxisRule::Fixed, guides: None, ..track.clone() };
    let at = |high: f64| {
        let level = placing(track, node).targets;
        let targets = [0, 1].map(|i| {
            let (keep, limits) = (&track.keeps[i], track.keeps[i].limits());
            let straight = keep.is_plane() || keep.condition == Condition::On;
            if straight { level[i] } else { limits.low + high * (limits.high - limits.low) }
        });
        still.settle(node.pose, &Aim { targets, ..Aim::at(node) }).ok()
    };
    let other = HIGH.into_iter().filter_map(at).find(|to| comes_in(track, node, to));
    other.map_or(usual, Ok)
}

/// Where a tool that stands near is put, in the plane across the track: touching, but as far inside of the bands as vertices are.
///
/// A band that begins at the surface has no room for what comes to the surface itself or begins there: the place is found to some share of
/// it only, and where a flat end lies along a ruling any place on that may touch, as rounding has it.
pub(super) fn placing<'a>(track: &Track, node: &'a Node) -> Aim<'a> {
    let targets = track.keeps.each_ref().map(|keep| match track.axis.turns() {
        true => keep.inside(0.0, AIM_TURNING),
        false => keep.level(),
    });
    Aim { targets, ..Aim::at(node) }
}

/// Is the way between two nodes short beside how far the tool comes to the surfaces? With an axis that turns by much it is not: the tool
/// would cut along them on its way.
fn is_short(track: &Track, from: &Node, to: &Node) -> bool {
    /// Its length at most, in widths of the narrower band and how far the tool comes to both surfaces; the proof allows 3.
    const LONG: f64 = 2.8;
    let comes: f64 = (0..2)
        .map(|i| {
            let (Limits { low, high }, gap) = (track.keeps[i].in_place(), from.gaps[i].g);
            (low - gap).max(gap - high).max(0.0)
        })
        .sum();
    let band = track.keeps.iter().map(Keep::width).fold(f64::INFINITY, f64::min);
    (to.pose.te - from.pose.te).norm() <= LONG * (comes + band)
}

/// Does the way between two nodes leave neither band farther than it does at its beginning?
fn comes_in(track: &Track, from: &Node, to: &Node) -> bool {
    (0..2).all(|i| {
        let (keep, start) = (&track.keeps[i], from.gaps[i].g);
        let Limits { low, high } = keep.in_place();
        let band = low.min(start) - track.exact..=high.max(start) + track.exact;
        BETWEEN.into_iter().all(|t| {
            let gap = keep.gap(&between(&from.pose, &to.pose, t), None);
            gap.is_ok_and(|gap| band.contains(&gap.g))
        })
    })
}
