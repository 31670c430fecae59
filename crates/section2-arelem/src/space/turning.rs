//! A place on the track of a tool whose axis turns with the place.
//!
//! A place of contact high up the shank moves by much more than the tool end does where the axis turns about it: the
//! normals alone then tell Newton's method too little, and it runs away. Here the gaps are told apart by differences,
//! each with the axis that belongs to its place.

use aptc_contact::Gap;
use aptc_geometry::Vec3;

use super::keep::Pose;
use super::track::{Aim, MISSED, Node, Track, Trouble, direction};
use crate::axis::Around;

/// Rounds of Newton's method.
const ROUNDS: usize = 20;
/// Rounds in which axis and contacts come to rest at one place.
const TURNS: usize = 30;
/// Greatest share of the way between two axes by which the next one is put off or back.
const MOST_SHARE: f64 = 3.0;
/// Shortest share of a step that is tried.
const LEAST: f64 = 1e-3;
/// Part of the scene's size by which a place is moved to see how its gaps change.
const BESIDE: f64 = 1e-6;
/// Sine of the angle between three planes below which they have no common point.
const FLAT: f64 = 1e-9;

impl Track {
    /// As [`Track::settle`], by differences; several times as slow.
    pub(super) fn settle_turning(&self, start: Pose, aim: &Aim<'_>) -> Result<Node, Trouble> {
        let Aim { across, targets, hint, look } = *aim;
        let level = across.dot(&start.te);
        let step = BESIDE * self.size;
        let off = |pose: &Pose, gaps: &[Gap; 2]| {
            let level = level - across.dot(&pose.te);
            [targets[0] - gaps[0].g, targets[1] - gaps[1].g, level]
        };
        let worst = |off: &[f64; 3]| off.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let (mut pose, mut gaps) = self.with_axis(start, &hint.gaps, hint.course.along)?;
        for _ in 0..ROUNDS {
            let now = off(&pose, &gaps);
            if worst(&now) <= self.exact {
                let deeper = if look { self.deeper(&pose, &gaps, 0.0).0 } else { [None, None] };
                if deeper.iter().all(Option::is_none) {
                    return self.finish(pose, gaps, hint.course.along);
                }
                let near = [0, 1].map(|i| deeper[i].unwrap_or(gaps[i]));
                (pose, gaps) = self.with_axis(pose, &near, hint.course.along)?;
                if worst(&off(&pose, &gaps)) <= self.exact {
                    return Err(Trouble::Stuck);
                }
                continue;
            }
            let mut slopes = [Vec3::zeros(); 2];
            for i in 0..3 {
                let mut beside = pose;
                beside.te[i] += step;
                let (_, other) = self.with_axis(beside, &gaps, hint.course.along)?;
                for (slope, (a, b)) in slopes.iter_mut().zip(gaps.iter().zip(&other)) {
                    slope[i] = (b.g - a.g) / step;
                }
            }
            let by = meet([slopes[0], slopes[1], across], now).ok_or(Trouble::SideBySide)?;
            let (mut share, mut missed) = (1.0, 0);
            (pose, gaps) = loop {
                let next = Pose { te: pose.te + by * share, ..pose };
                match self.with_axis(next, &gaps, hint.course.along) {
                    Ok(next) if worst(&off(&next.0, &next.1)) < worst(&now) || share < LEAST => {
                        break next;
                    }
                    Ok(_) => missed = 0,
                    Err(trouble) if missed >= MISSED => return Err(trouble),
                    Err(trouble) => missed += u32::from(matches!(trouble, Trouble::Contact)),
                }
                if share < LEAST {
                    return Err(Trouble::Stuck);
                }
                share *= 0.5;
            };
        }
        Err(Trouble::Stuck)
    }

    /// The tool at its place with the axis that belongs there.
    fn with_axis(
        &self,
        mut pose: Pose,
        near: &[Gap; 2],
        heading: Vec3,
    ) -> Result<(Pose, [Gap; 2]), Trouble> {
        let mut gaps = self.gaps(&pose, Some(near))?;
        let mut last: Option<(Vec3, Vec3)> = None;
        for _ in 0..TURNS {
            let along = direction([gaps[0].normal, gaps[1].normal], heading)?;
            let (te, ta) = (pose.te, pose.ta);
            let around = Around { te, ta, part: &gaps[1], drive: &gaps[0], along };
            let next =
                self.axis.at(&around, [&self.keeps[0], &self.keeps[1]]).ok_or(Trouble::Axis)?;
            let turn = next - ta;
            pose.ta = match last {
                // The part of both turns that is alike is left out, by as much as they differ by it.
                Some((before, turned)) if turn.norm() > 1e-12 && turn != turned => {
                    let change = turn - turned;
                    let share = turn.dot(&change) / change.norm_squared().max(f64::MIN_POSITIVE);
                    let ahead = next - (next - before) * share.clamp(-MOST_SHARE, MOST_SHARE);
                    ahead.try_normalize(0.5).unwrap_or(next)
                }
                _ => next,
            };
            last = Some((next, turn));
            gaps = self.gaps(&pose, Some(&gaps))?;
            if turn.norm() <= 1e-12 {
                return Ok((pose, gaps));
            }
        }
        Err(Trouble::Stuck)
    }
}

/// The vector with given products with three others.
pub(super) fn meet([a, b, c]: [Vec3; 3], rhs: [f64; 3]) -> Option<Vec3> {
    let det = a.dot(&b.cross(&c));
    let flat = det.abs() <= FLAT * a.norm() * b.norm() * c.norm();
    (!flat && det.is_finite())
        .then(|| (b.cross(&c) * rhs[0] + c.cross(&a) * rhs[1] + a.cross(&b) * rhs[2]) / det)
}
