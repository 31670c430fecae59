//! A region of a surface's parameters that is bounded by straight lines.

use aptc_cldata::milling;

use crate::sheet::Patch;

/// What an outline holds.
#[derive(Clone, Debug)]
pub(crate) struct Outline(milling::Outline);

/// What of a piece lies in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Share {
    All,
    /// The outline goes through it, and its middle is within.
    Middle,
    /// The outline goes through it and has this place there, and its middle is without.
    Rest([f64; 2]),
    None,
}

/// A piece is taken for larger by this share of the numbers, so that rounding loses no line that goes through it.
const ROUNDING: f64 = 1e-12;

impl Outline {
    pub(crate) fn new(outline: &milling::Outline) -> Self {
        Self(outline.clone())
    }

    /// Least and greatest parameters of its lines.
    pub(crate) fn range(&self) -> [[f64; 2]; 2] {
        [0, 1].map(|k| {
            let all = self.0.lines.iter().flatten().map(|end| end[k]);
            all.fold([f64::INFINITY, f64::NEG_INFINITY], |r, x| [r[0].min(x), r[1].max(x)])
        })
    }

    pub(crate) fn lines(&self) -> &[[[f64; 2]; 2]] {
        &self.0.lines
    }

    /// Does it hold the place? Its lines are met an odd number of times on the way from there on which the one parameter rises.
    pub(crate) fn within(&self, at: [f64; 2]) -> bool {
        let (k, mut odd) = (self.0.along, false);
        for [a, b] in &self.0.lines {
            // Heights over the way; a line that ends on it counts as if it ended below.
            let (p, q) = (a[1 - k] - at[1 - k], b[1 - k] - at[1 - k]);
            if (p > 0.0) != (q > 0.0) {
                // Where it is met, ahead: `a + (b - a) p / (p - q) > at`, without the quotient.
                let ahead = (a[k] - at[k]) * (p - q) + (b[k] - a[k]) * p;
                odd ^= (ahead > 0.0) == (p > q) && ahead != 0.0;
            }
        }
        odd
    }

    /// Does one of its lines come into a piece?
    pub(crate) fn meets(&self, patch: &Patch) -> bool {
        let half = wider(patch);
        self.0.lines.iter().any(|line| meets(*line, patch.at, half))
    }

    /// A piece through which no line goes is as its middle is.
    pub(crate) fn share(&self, patch: &Patch) -> Share {
        let half = wider(patch);
        let through = self.0.lines.iter().find(|e| meets(**e, patch.at, half));
        match (through, self.within(patch.at)) {
            (None, true) => Share::All,
            (Some(_), true) => Share::Middle,
            (Some(edge), false) => Share::Rest(beside(*edge, patch.at, half)),
            (None, false) => Share::None,
        }
    }
}

/// Half lengths of a piece, and what rounding may leave of them.
fn wider(patch: &Patch) -> [f64; 2] {
    [0, 1].map(|k| patch.half[k] + ROUNDING * (patch.at[k].abs() + patch.half[k]))
}

/// Does a line come into the box `at +- half`? Neither an axis of the box nor the normal of the line parts them.
fn meets([a, b]: [[f64; 2]; 2], at: [f64; 2], half: [f64; 2]) -> bool {
    for k in 0..2 {
        let (lo, hi) = (a[k].min(b[k]), a[k].max(b[k]));
        if lo > at[k] + half[k] || hi < at[k] - half[k] {
            return false;
        }
    }
    let [p, q] = [b[0] - a[0], b[1] - a[1]];
    let off = p * (at[1] - a[1]) - q * (at[0] - a[0]);
    off.abs() <= (p.abs() * half[1] + q.abs() * half[0]) * (1.0 + ROUNDING)
}

/// The place of a line next to the middle of a box, by the size of the box.
fn beside([a, b]: [[f64; 2]; 2], at: [f64; 2], half: [f64; 2]) -> [f64; 2] {
    let [p, q] = [0, 1].map(|k| (b[k] - a[k]) / half[k]);
    let [x, y] = [0, 1].map(|k| (at[k] - a[k]) / half[k]);
    let t = ((p * x + q * y) / (p * p + q * q)).clamp(0.0, 1.0);
    [0, 1].map(|k| a[k] + (b[k] - a[k]) * t)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn outline(corners: &[[f64; 2]], along: usize) -> Outline {
        let next = corners.iter().cycle().skip(1);
        let lines = corners.iter().zip(next).map(|(a, b)| [*a, *b]).collect();
        Outline::new(&milling::Outline { lines, along })
    }

    /// A star of five points about (2, 1).
    fn star(along: usize) -> Outline {
        let corner = |i: i32| {
            let (s, c) = aptc_geometry::trig::sin_cos(f64::from(i) * std::f64::consts::PI / 5.0);
            let r = if i % 2 == 0 { 1.5 } else { 0.6 };
            [2.0 + r * c, 1.0 + r * s]
        };
        outline(&(0..10).map(corner).collect::<Vec<_>>(), along)
    }

    proptest! {
        #[test]
        fn pieces_are_within_and_without_as_their_places_are(
            at in prop::array::uniform2(-0.5..3.5_f64), half in prop::array::uniform2(0.0..0.6_f64),
            along in 0_usize..2,
        ) {
            let o = star(along);
            let share = o.share(&Patch { at, half, ..Patch::default() });
            for i in 0..=20_i32 {
                for j in 0..=20_i32 {
                    let [s, t] = [i, j].map(|i| 0.1 * f64::from(i) - 1.0);
                    let held = o.0.holds([at[0] + s * half[0], at[1] + t * half[1]]);
                    match share {
                        Share::All => prop_assert!(held),
                        Share::None => prop_assert!(!held),
                        Share::Middle | Share::Rest(_) => {}
                    }
                }
            }
            if let Share::Rest(x) = share {
                let off = |k: usize| (x[k] - at[k]).abs() <= 1.5 * half[k] + 1e-9;
                prop_assert!(off(0) && off(1), "{x:?}");
            }
            prop_assert_eq!(o.0.holds(at), matches!(share, Share::All | Share::Middle));
        }
    }

    #[test]
    fn the_range_is_that_of_the_corners() {
        let o = outline(&[[0.0, 1.0], [2.0, 0.5], [1.0, 3.0]], 0);
        assert_eq!(o.range(), [[0.0, 2.0], [0.5, 3.0]]);
    }
}
