//! CYCLE/THREAD on a lathe: the passes of a thread.
//!
//! Every control has a threading cycle of its own, and each divides the depth its own way; so the passes are
//! written out, one by one, and proved like any other motion.

use aptc_cldata::Position;
use aptc_diagnostics::{Origin, codes};
use aptc_geometry::Vec3;

use crate::drill::DrillCycle;
use crate::emit::FeedMode;
use crate::post::Post;

/// Passes of one thread; more are refused.
const MOST_PASSES: u32 = 500;

/// Depths of the passes, each of the same area of chip: the first times the root of 1, 2, 3 .. up to the whole
/// depth. `None` for no depth, no first pass, or too many.
pub(crate) fn passes(depth: f64, first: f64) -> Option<Vec<f64>> {
    if !(depth > 0.0 && first > 0.0) {
        return None;
    }
    let mut list = Vec::new();
    for k in 1..=MOST_PASSES {
        let deep = first * f64::from(k).sqrt();
        if deep >= depth * (1.0 - 1e-9) {
            list.push(depth);
            return Some(list);
        }
        list.push(deep);
    }
    None
}

/// Stops of a thread from where the tool stands, outside or inside of the crest, to its end on the crest: to the
/// depth, along, clear of the crest, and back. The second of each four is a cut.
pub(crate) fn stops(from: Vec3, end: Vec3, clear: f64, depths: &[f64]) -> Option<Vec<Vec3>> {
    let side = from.x - end.x;
    if side.abs() < 1e-9 {
        return None;
    }
    let side = side.signum();
    let at = |x: f64, z: f64| Vec3::new(x, end.y, z);
    let out = end.x + side * clear;
    let pass = |d: &f64| {
        let x = end.x - side * d;
        [at(x, from.z), at(x, end.z), at(out, end.z), at(out, from.z)]
    };
    Some(depths.iter().flat_map(pass).collect())
}

impl Post {
    /// One thread, from where the tool stands along the spindle to the position.
    pub(crate) fn thread_cycle(&mut self, cycle: &DrillCycle, p: &Position, origin: &Origin) {
        let scale = self.st.scale;
        let end = self.st.point(p.te);
        let feed = cycle.feed.and_then(|f| self.feed_of(f, origin));
        let lead = feed.filter(|f| f.mode == FeedMode::PerRevolution).map(|f| f.value);
        let depths = passes(cycle.depth * scale, cycle.step.unwrap_or(0.0) * scale);
        let clear = cycle.clear.filter(|c| *c > 0.0).map(|c| c * scale);
        let (Some(lead), Some(depths), Some(clear)) = (lead, depths, clear) else {
            let message = "CYCLE/THREAD without depth, first pass, lead or clearance".to_string();
            let help = "write CYCLE/THREAD,DEPTH,d,STEP,s,MMPR,lead,CLEAR,c: d and s across, c above the crest";
            self.error(codes::CYCLE_INCOMPLETE, origin, message, help);
            return;
        };
        let Some(stops) = self.st.pos.and_then(|from| stops(from, end, clear, &depths)) else {
            let message = "the tool does not stand beside the crest of the thread".to_string();
            let help =
                "bring it to the start of the thread, outside of it or inside of a nut, with RAPID";
            self.error(codes::THREAD, origin, message, help);
            return;
        };
        if !self.st.ready_said {
            self.ready(origin);
        }
        for (to, i) in stops.into_iter().zip(0_u32..) {
            if i % 4 == 1 {
                self.thread_to(to, lead, origin);
                self.st.pos = Some(to);
            } else {
                self.go_to(to, Vec3::z(), true, origin);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_pass_takes_the_same_area() {
        let list = passes(0.9, 0.3).unwrap();
        assert_eq!(list.len(), 9);
        let area = |a: f64, b: f64| b * b - a * a;
        for w in list.windows(2) {
            assert!((area(w[0], w[1]) - 0.09).abs() < 1e-12, "{list:?}");
        }
        assert_eq!(passes(0.2, 0.3), Some(vec![0.2]));
        assert_eq!(passes(0.2, 0.0), None);
        assert_eq!(passes(9.0, 0.001), None);
    }
}
