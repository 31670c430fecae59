//! Many cut vectors beside a plane at once.
//!
//! Where the axis does not turn all points of the tool go straight, and the gap to a plane runs evenly from end to end of
//! each vector: the gaps at the ends are its bounds.

use aptc_cldata::Position;
use aptc_geometry::{Plane, Vec3};

use crate::tool::{Tool, same};

/// Least and greatest gap along vectors in a row, and the end of the first of them on which it is least.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Run {
    pub(crate) low: f64,
    pub(crate) at: Option<Vec3>,
    pub(crate) high: f64,
}

/// The vectors from `start` to the first of the points, and from each to the next; `None` where the axis turns, and where a gap is
/// no number.
pub(crate) fn beside_plane(
    tool: &Tool<'_>,
    start: &Position,
    points: &[Position],
    plane: &Plane,
) -> Option<Run> {
    let still = tool.reach() == 0.0 || points.iter().all(|p| same(p.ta, start.ta));
    if !still {
        return None;
    }
    // How high the tool stands over its end is the same everywhere.
    let over = tool.over(start.ta, -plane.n);
    let gap = |te: Vec3| plane.distance(te) - over;
    let mut before = gap(start.te);
    let mut sum = before;
    let mut run = Run { low: f64::INFINITY, at: None, high: before };
    for p in points {
        let next = gap(p.te);
        let low = before.min(next);
        if low < run.low {
            (run.low, run.at) = (low, Some(p.te));
        }
        run.high = run.high.max(next);
        before = next;
        sum += next;
    }
    sum.is_finite().then_some(run)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outside;
    use crate::tool::Pose;
    use aptc_geometry::{Cutter, Profile, trig};

    /// The same numbers as vector by vector.
    #[test]
    fn a_row_is_bounded_as_its_vectors_are() {
        let profile = Profile::new(&Cutter::mill(10.0, 2.0, 40.0)).unwrap();
        let ta = Vec3::new(0.6, 0.0, 0.8);
        let at = |i: i32| {
            let f = f64::from(i);
            let te = Vec3::new(3.0 * f, 7.0 * trig::sin(f), 5.0 * trig::cos(1.7 * f));
            Position { te, ta }
        };
        let n = Vec3::new(0.48, 0.6, 0.64);
        let plane = Plane { n, d: 2.5 };
        let points: Vec<Position> = (1..40).map(at).collect();
        for tool in [Tool::Solid(&profile), Tool::End] {
            let run = beside_plane(&tool, &at(0), &points, &plane).unwrap();
            let mut seen = Run { low: f64::INFINITY, at: None, high: f64::NEG_INFINITY };
            for (a, b) in core::iter::once(&at(0)).chain(&points).zip(&points) {
                let ends = [Pose::of(a), Pose::of(b)];
                let [low, high] = outside::beside_plane(&tool, &ends, &plane, &mut None);
                if low < seen.low {
                    (seen.low, seen.at) = (low, Some(b.te));
                }
                seen.high = seen.high.max(high);
            }
            assert_eq!(run.at, seen.at);
            assert!((run.low - seen.low).abs() < 1e-12 && (run.high - seen.high).abs() < 1e-12);
        }
        let nowhere = Position { te: Vec3::repeat(f64::NAN), ta };
        assert_eq!(beside_plane(&Tool::End, &nowhere, &[nowhere, nowhere], &plane), None);
        let turned = Position { ta: Vec3::z(), ..at(41) };
        assert_eq!(beside_plane(&Tool::Solid(&profile), &at(0), &[turned], &plane), None);
        assert!(beside_plane(&Tool::End, &at(0), &[turned], &plane).is_some());
    }
}
