//! The length of a cut vector that uses the whole of a band, from what trials use of it.

/// Share of a length within which another tells how the ratios go on.
const NEAR: f64 = 1e-2;
/// Share of a length within which another is the same: their ratios differ by rounding.
const SAME: f64 = 1e-7;
/// What more than the whole of a band one counts for at most: farther out it says little.
const MOST: f64 = 2.0;
/// Two lengths nearer to each other than this share of the usual one, of which the long one uses so much more of the band, have a
/// jump between them, as where the contact goes over to what lies far below: where it is no secant tells.
const CLOSE: f64 = 1.0 / 64.0;
const JUMP: f64 = 0.5;

/// Lengths that are too short and too long, with what each uses of the band: one over its ratio, less one. Along a parabola
/// that grows evenly with the length, and over a crest, where the ratio falls fast, nearly so.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Lengths {
    short: Option<(f64, f64)>,
    long: Option<(f64, f64)>,
    /// What both of them use.
    uses: [f64; 2],
    /// The last one, and the one before.
    last: [Option<(f64, f64)>; 2],
    /// How far both ends were apart at the last trials.
    apart: [Option<f64>; 2],
    /// The least length that was to use the whole of the band at most, once it was told; does it fall slower than that?
    least: Option<f64>,
    slow: bool,
}

impl Lengths {
    /// One that uses so much.
    pub(super) fn take(&mut self, s: f64, uses: f64) {
        let here = (s, uses.min(MOST));
        let told = self.least.is_some_and(|least| (least - s).abs() <= SAME * s);
        self.slow |= told && uses > 0.0 && uses < MOST;
        let (same, other) = match uses <= 0.0 {
            true => (&mut self.short, &mut self.long),
            false => (&mut self.long, &mut self.short),
        };
        // The end that stays counts half each time: else the secant comes from one side only.
        if self.last[0].is_some()
            && self.last[0] == *same
            && let Some(other) = other
        {
            other.1 *= 0.5;
        }
        *same = Some(here);
        self.uses[usize::from(uses > 0.0)] = here.1;
        self.last = [Some(here), older(s, self.last[0], self.last[1])];
    }

    /// Where the whole of the band is used, by the secant of the last two while it comes nearer, else by that of both ends;
    /// `None` where that is not seen. Along a chord longer than `usual`, the length foretold from a bend, it falls no slower
    /// than along the parabola of that length, unless a length at which it was to be short enough for that is not. Halfway where
    /// it jumps.
    pub(super) fn next(&mut self, usual: f64) -> Option<f64> {
        let secant = |(s, f): (f64, f64), (t, g): (f64, f64)| {
            let next = t - g * (t - s) / (g - f);
            ((g - f) * (t - s) > 0.0).then_some(next)
        };
        let (Some(short), Some(long)) = (self.short, self.long) else {
            let (s, uses) = self.short?;
            return (s > 2.0 * usual && uses > -0.5).then_some(s - uses * usual);
        };
        let least = if self.slow { short.0 } else { long.0 - long.1 * usual };
        let inside = |x: &f64| *x > short.0 && *x < long.0;
        let nearer = |a: (f64, f64), b: (f64, f64)| b.1.abs() <= 0.5 * a.1.abs();
        let comes_nearer = matches!(self.last, [Some(b), Some(a)] if nearer(a, b));
        let near = match self.last {
            [Some(b), Some(a)] if comes_nearer || a.1 > 0.0 && b.1 > 0.0 => secant(a, b),
            _ => None,
        };
        let apart = long.0 - short.0;
        let [last, before] = self.apart;
        self.apart = [Some(apart), last];
        let near = near.map(|x| x.max(least)).filter(inside);
        let stays = (near.is_none() || self.slow) && before.is_some_and(|b| apart > 0.5 * b);
        let both = || secant(short, long).map(|x| x.max(least)).filter(inside);
        let halves = 0.5 * (short.0 + long.0);
        let jumps = apart <= CLOSE * usual && self.uses[1] - self.uses[0] > JUMP;
        let next = match near {
            _ if jumps => Some(halves),
            Some(near) if !stays || comes_nearer => Some(near),
            _ if stays => Some(halves),
            _ => both(),
        };
        self.least = Some(least);
        next
    }
}

/// The next length to try: by the ratio, and from the second trial on by the secant of the ratios, which
/// also sees how the targets and the curvature change with the length.
pub(super) fn lengthen(s: f64, ratio: f64, before: Option<(f64, f64)>) -> f64 {
    let simple = s * ratio.clamp(0.1, 4.0);
    let Some((s0, r0)) = before else { return simple };
    let slope = (ratio - r0) / (s - s0);
    let secant = s - (ratio - 1.0) / slope;
    // The ratio falls with the length; where rounding or a kink says otherwise, or nothing bent along the one before, the simple
    // step holds.
    if slope < 0.0 && slope.is_finite() && secant > 0.25 * s && secant < 4.0 * s {
        secant
    } else {
        simple
    }
}

/// The trial with which one of length `s` tells a slope: the last one, or the one `before` where that is so near that the slope
/// would be that of rounding.
pub(super) fn older(
    s: f64,
    last: Option<(f64, f64)>,
    before: Option<(f64, f64)>,
) -> Option<(f64, f64)> {
    let near = last.is_some_and(|(t, _)| (t - s).abs() <= SAME * s);
    if near { before.or(last) } else { last }
}

/// The share of a length by which a chord beside it could be longer, by the secant of the ratios: where the contact goes over to
/// another place on the way these fall many times as fast as the length grows.
pub(super) fn rest(s: f64, ratio: f64, (s0, r0): (f64, f64)) -> Option<f64> {
    let slope = (ratio - r0) / (s - s0);
    ((s - s0).abs() <= NEAR * s && slope < -1.0 / s).then(|| (1.0 - ratio) / (slope * s))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trials until a length is found to a millionth.
    fn trials(uses: impl Fn(f64) -> f64, first: f64, usual: f64) -> usize {
        let (mut lengths, mut s, mut before) = (Lengths::default(), first, None);
        for k in 1..40 {
            let at = uses(s) - 1.0;
            if at.abs() <= 1e-6 {
                return k;
            }
            lengths.take(s, at);
            let ratio = 1.0 / (at + 1.0);
            let next = lengths.next(usual).unwrap_or_else(|| lengthen(s, ratio, before));
            (before, s) = (Some((s, ratio)), next);
        }
        40
    }

    #[test]
    fn the_length_along_a_parabola_comes_with_the_second_trial() {
        assert_eq!(trials(|s| s / 0.35, 0.3, 0.35), 2);
    }

    #[test]
    fn the_length_at_a_jump_comes_by_halves() {
        // Short of it the chord uses nearly all of the band, and beyond it more than any parabola tells.
        for (first, usual, beyond) in [(0.38, 0.38, f64::INFINITY), (0.2, 0.35, 1.98)] {
            let uses = |s: f64| if s <= 0.552 { s / 0.563 } else { beyond };
            let (mut lengths, mut s, mut before) = (Lengths::default(), first, None);
            let (mut ends, mut trials) = ([0.0, f64::INFINITY], 0);
            while ends[1] - ends[0] > 1e-9 {
                trials += 1;
                assert!(trials <= 36, "{first}: {ends:?}");
                let at = uses(s);
                ends[usize::from(at > 1.0)] = s;
                lengths.take(s, at - 1.0);
                let next = lengths.next(usual);
                let next = next.unwrap_or_else(|| lengthen(s, 1.0 / at, before));
                (before, s) = (Some((s, 1.0 / at)), next);
            }
            assert!((ends[0] - 0.552).abs() <= 1e-9);
        }
    }

    #[test]
    fn a_chord_along_which_nothing_bends_tells_no_slope() {
        let length = lengthen(2.0, 1.5, Some((1.0, f64::INFINITY)));
        assert_eq!(length.to_bits(), 3.0_f64.to_bits());
    }

    #[test]
    fn two_trials_of_one_length_tell_no_slope() {
        let (old, last) = (Some((1.0, 1.25)), Some((1.2, 1.0 + 1e-9)));
        assert_eq!(older(1.2 * (1.0 + 1e-9), last, old), old);
        assert_eq!(older(1.2 * (1.0 + 1e-9), last, None), last);
        assert_eq!(older(1.21, last, old), last);
    }

    #[test]
    fn a_length_over_a_crest_comes_soon() {
        // Nothing bends up to 6; then it uses as much as two parabolas do.
        for (first, usual) in [(6.2, 0.34), (6.02, 0.34), (6.01, 0.03), (6.05, 0.03)] {
            let crest = |s: f64| 0.4_f64.max(0.4 + 1.8 * (s - 6.0) / usual);
            let found = trials(crest, first, usual);
            assert!(found <= 9, "{first} {usual}: {found}");
        }
    }
}
