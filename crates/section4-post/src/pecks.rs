//! Pecks of a deep hole: how long each is, and how many.

use crate::drill::DrillCycle;
use crate::post::Post;

/// Pecks of one expanded hole; more are refused.
pub(crate) const MOST_PECKS: usize = 10_000;

/// A peck may be longer than STEP by this, millimetres, and by no more than a hundredth of it. CL data have three to
/// six decimals: a hole of 10 in three pecks of 3.3333 has no fourth of .0001.
const HAIR_MM: f64 = 0.001;

/// The first peck and the others, as the program gives them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pecks {
    pub(crate) first: f64,
    pub(crate) step: f64,
    /// By how much they may be longer.
    pub(crate) hair: f64,
}

/// Is it a cycle that drills in pecks?
pub(crate) fn is_pecked(kind: &str) -> bool {
    matches!(kind, "DEEP" | "BRKCHP")
}

impl Pecks {
    /// The same for a way of this length: no peck is longer than it may be, and none is left over that rounding alone
    /// has made. Beside them how many there are; the last may be shorter.
    pub(crate) fn fitted(self, way: f64) -> (Self, usize) {
        if (self.first - self.step).abs() < 1e-9 {
            let (step, n) = self.spread(way);
            return (Self { first: step, step, ..self }, n);
        }
        if way <= self.first + self.hair.min(self.first / 100.0) {
            return (Self { first: self.first.max(way), ..self }, 1);
        }
        let (step, n) = self.spread(way - self.first);
        (Self { step, ..self }, n + 1)
    }

    /// Even pecks for a way.
    fn spread(self, way: f64) -> (f64, usize) {
        let longest = self.step + self.hair.min(self.step / 100.0);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "bounded")]
        let n = (way / longest).ceil().clamp(1.0, 1e9) as usize;
        #[expect(clippy::cast_precision_loss, reason = "at most 1e9")]
        let even = way / n as f64;
        (self.step.max(even), n)
    }

    /// Where each peck ends, from `top` down to `bottom`; `None` when there are too many.
    pub(crate) fn depths(self, top: f64, bottom: f64) -> Option<Vec<f64>> {
        let (pecks, n) = self.fitted(top - bottom);
        if n > MOST_PECKS {
            return None;
        }
        // Each from the top, so that rounding does not add up.
        #[expect(clippy::cast_precision_loss, reason = "at most MOST_PECKS")]
        let end = |i: usize| top - pecks.first - pecks.step * i as f64;
        Some((0..n - 1).map(end).chain([bottom]).collect())
    }
}

impl Post {
    /// The pecks of a cycle in output units, whole steps of the output so that rounding makes none longer; `None`
    /// without a step, or with one that is nothing to the control.
    pub(crate) fn pecks(&self, cycle: &DrillCycle) -> Option<Pecks> {
        let resolution = self.blocks.number(b'Z').resolution();
        let whole = |said: f64| (said * self.st.scale / resolution + 1e-6).floor() * resolution;
        let step = whole(cycle.step.or(cycle.first_step)?);
        let first = whole(cycle.first_step.or(cycle.step)?);
        let hair = HAIR_MM / self.st.out_mm();
        let some = |p: f64| p > resolution / 2.0;
        (some(step) && some(first)).then_some(Pecks { first, step, hair })
    }

    /// The same as a cycle of the control is told them, for a way of this length: rounded up, or the control would
    /// make one more peck of what is left.
    pub(crate) fn told_pecks(&self, cycle: &DrillCycle, way: f64, letter: u8) -> Option<Pecks> {
        let number = self.blocks.number(letter);
        let resolution = number.resolution();
        let up = |p: f64| (p / resolution - 1e-6).ceil() * resolution;
        let (pecks, _) = self.pecks(cycle)?.fitted(way);
        Some(Pecks { first: up(pecks.first), step: up(pecks.step), ..pecks })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn depths(first: f64, step: f64, depth: f64) -> Vec<f64> {
        Pecks { first, step, hair: HAIR_MM }.depths(2.0, -depth).unwrap()
    }

    #[test]
    fn rounding_makes_no_peck_of_its_own() {
        // 12 = 4 * 3, 12 = 9 * 1.3333, 10.16 = 4 * 2.54, and .1 is no number of base 2.
        for (step, depth, n) in [(3.0, 10.0, 4), (1.3333, 10.0, 9), (2.54, 8.16, 4), (0.1, 1.0, 30)]
        {
            let list = depths(step, step, depth);
            assert_eq!(list.len(), n, "{step}: {list:?}");
            assert_eq!(list.last().copied(), Some(-depth));
        }
    }

    #[test]
    fn no_peck_is_longer_than_it_may_be_and_none_a_sliver() {
        for k in 1..400_u32 {
            for (first, step) in [(0.0, 1.0), (0.0, 1.0 / 3.0), (0.0, 2.54), (3.0, 0.7)] {
                let first = if first > 0.0 { first } else { step };
                let depth = f64::from(k) * 0.0617;
                let mut top = 2.0;
                for (i, z) in depths(first, step, depth).into_iter().enumerate() {
                    let most: f64 = if i == 0 { first } else { step };
                    assert!(top - z <= most + HAIR_MM + 1e-12, "{depth} {most}: {}", top - z);
                    assert!(top - z > HAIR_MM / 2.0, "{depth} {most}: {}", top - z);
                    top = z;
                }
            }
        }
    }

    #[test]
    fn a_remainder_stays_the_last_peck() {
        assert_eq!(depths(5.0, 5.0, 10.0), [-3.0, -8.0, -10.0]);
        assert_eq!(depths(4.0, 3.0, 10.0), [-2.0, -5.0, -8.0, -10.0]);
        assert_eq!(depths(12.0005, 3.0, 10.0), [-10.0]);
        assert_eq!(Pecks { first: 1e-6, step: 1e-6, hair: 0.0 }.depths(2.0, -10.0), None);
    }
}
