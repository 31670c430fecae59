//! Borders of faces in the plane of their surface's parameters: the box that holds them, and whether they are that box.

/// How far a period or a pole may be missed, as a share of the period.
const ABOUT: f64 = 1e-6;

/// A closed line that has the face on its left, u pointing to the right and v up.
#[derive(Clone, Debug)]
pub(crate) struct Line {
    /// Its places; the last is the first again, or that many periods from it.
    pub(crate) places: Vec<[f64; 2]>,
    /// How often each parameter came round.
    pub(crate) rounds: [f64; 2],
    /// It passes a pole or tip, along which its sense says where it goes.
    pub(crate) poles: bool,
}

/// The box of a border.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Border {
    /// From and to, of both parameters.
    pub(crate) range: [[f64; 2]; 2],
    /// May the border be that of the box? Not where a line that goes round leaves its level, or where what a box is was
    /// taken from the ends of the surface.
    pub(crate) whole: bool,
}

/// The parameters of a surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    /// After how much each comes back to the same place.
    pub(crate) periods: [Option<f64>; 2],
    /// Ends of each, a pole or tip or the borders.
    pub(crate) ends: [[Option<f64>; 2]; 2],
}

impl Line {
    pub(crate) fn range(&self, k: usize) -> [f64; 2] {
        let all = self.places.iter().map(|p| p[k]);
        all.fold([f64::INFINITY, f64::NEG_INFINITY], |r, x| [r[0].min(x), r[1].max(x)])
    }

    /// Is the face where the other parameter than the k-th, which comes round, is greater?
    fn upward(&self, k: usize) -> bool {
        (self.rounds[k] > 0.0) == (k == 0)
    }

    /// Twice the area that it goes round; above zero where the face is inside.
    pub(crate) fn area(&self) -> f64 {
        let n = self.places.len();
        let [u, v] = self.places[0];
        let of = |i: usize| {
            let (a, b) = (self.places[i], self.places[(i + 1) % n]);
            (a[0] - u) * (b[1] - v) - (b[0] - u) * (a[1] - v)
        };
        (0..n).map(of).sum()
    }
}

impl Plane {
    /// All of a parameter, where that is known.
    fn all(&self, k: usize) -> Option<[f64; 2]> {
        match (self.periods[k], self.ends[k]) {
            (_, [Some(from), Some(to)]) => Some([from, to]),
            (Some(period), _) => Some([0.0, period]),
            _ => None,
        }
    }

    /// The box of the face that closed lines bound; `None` where they do not tell it.
    pub(crate) fn bounded(&self, lines: &mut [Line]) -> Option<Border> {
        if lines.is_empty() {
            return Some(Border { range: [self.all(0)?, self.all(1)?], whole: true });
        }
        match (0..2).find(|k| lines.iter().any(|l| l.rounds[*k] != 0.0)) {
            Some(k) => self.round(lines, k),
            None => self.inside(lines),
        }
    }

    /// Turns lines whose senses are not known so that the face between them is on their left: the largest one about its inside, and
    /// of two that come round the lower one has the face above it. Do they tell the face so?
    pub(crate) fn outward(&self, lines: &mut [Line]) -> bool {
        if lines.iter().any(|l| l.poles) {
            return false;
        }
        let of = |k: usize| lines.iter().filter(move |l| l.rounds[k] != 0.0).count();
        match [of(0), of(1)] {
            [0, 0] => {
                let most = |a: &&mut Line, b: &&mut Line| a.area().abs().total_cmp(&b.area().abs());
                if let Some(outer) = lines.iter_mut().max_by(most).filter(|l| l.area() < 0.0) {
                    outer.places.reverse();
                }
                true
            }
            [2, 0] | [0, 2] => {
                let k = usize::from(of(0) == 0);
                let level = |l: &Line| l.range(1 - k).iter().sum::<f64>();
                let mut rings: Vec<_> = lines.iter_mut().filter(|l| l.rounds[k] != 0.0).collect();
                rings.sort_by(|a, b| level(a).total_cmp(&level(b)));
                for (up, ring) in [true, false].into_iter().zip(rings) {
                    if ring.upward(k) != up {
                        ring.places.reverse();
                        ring.rounds[k] = -ring.rounds[k];
                    }
                }
                self.periods[1 - k].is_none()
            }
            _ => false,
        }
    }

    /// Of lines none of which comes round: the outer one goes left about its inside. Where all go right about holes, the face is
    /// all else of a surface that is closed or ends.
    fn inside(&self, lines: &mut [Line]) -> Option<Border> {
        let most = |of: &dyn Fn(f64) -> f64| {
            let size = |k: &usize| of(lines[*k].area());
            (0..lines.len()).max_by(|a, b| size(a).total_cmp(&size(b)))
        };
        let closed = self.periods.iter().any(Option::is_some);
        let all = || Some([self.all(0)?, self.all(1)?]);
        let mut outer = most(&|area| area)?;
        if lines[outer].area() < 0.0 {
            match all().filter(|_| closed) {
                Some(range) => return Some(Border { range, whole: false }),
                // Elsewhere nothing but the largest line can be the outer one, whatever its sense.
                None => outer = most(&f64::abs)?,
            }
        }
        let mut whole = true;
        let mut range = [[0.0; 2]; 2];
        for (k, range) in range.iter_mut().enumerate() {
            let own = lines[outer].range(k);
            self.shifted(lines, k, own);
            *range = self.capped(k, over(lines, k), &mut whole);
        }
        Some(Border { range, whole })
    }

    /// Of lines some of which come round along the k-th parameter: all round, and along the other one between those that have the
    /// face above them and those that have it below; where there are only such of one kind, up to the end of the surface.
    fn round(&self, lines: &mut [Line], k: usize) -> Option<Border> {
        let (period, other) = (self.periods[k]?, 1 - k);
        let start = self.ends[k][0].unwrap_or_else(|| over(lines, k)[0]);
        let mut whole = true;
        let rings = |up: bool| {
            let of = move |l: &&Line| l.rounds[k] != 0.0 && l.upward(k) == up;
            let of = lines.iter().filter(of).map(|l| l.range(other));
            of.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
        };
        let count = lines.iter().filter(|l| l.rounds[k] != 0.0).count();
        let level = |r: [f64; 2], size: f64| r[1] - r[0] <= ABOUT * size;
        let across = match (rings(true), rings(false), self.periods[other]) {
            (Some(low), Some(high), Some(period)) => {
                let [a, b] = [low, high].map(|r| 0.5 * (r[0] + r[1]));
                let high = high.map(|x| x + following(a, b, period) - b);
                whole &= count == 2 && level(low, period) && level(high, period);
                self.capped(other, [low[0].min(high[0]), high[1].max(low[1])], &mut whole)
            }
            (Some(low), Some(high), None) => {
                whole &= count == 2;
                [low[0].min(high[0]), low[1].max(high[1])]
            }
            // A single line between a closed parameter and itself bounds nothing.
            (.., Some(_)) => return None,
            (one, two, None) => {
                let ring = one.or(two)?;
                let [low, high] = self.ends[other];
                let up = if one.is_some() { high.or(low)? } else { low.or(high)? };
                let range = [ring[0].min(up), ring[1].max(up)];
                whole &= count == 1 && level(ring, range[1] - range[0]);
                range
            }
        };
        if count == lines.len() {
            let size = across[1] - across[0];
            let of = |l: &Line| level(l.range(other), size);
            whole &= lines.iter().all(of);
        }
        self.shifted(lines, other, across);
        let mut range = [[start, start + period]; 2];
        range[other] = across;
        Some(Border { range, whole: whole && count == lines.len() })
    }

    /// Lines that do not come round are moved by whole periods to where their middle is nearest to that of a range.
    fn shifted(&self, lines: &mut [Line], k: usize, range: [f64; 2]) {
        let Some(period) = self.periods[k] else { return };
        for line in lines.iter_mut().filter(|l| l.rounds.iter().all(|r| *r == 0.0)) {
            let [a, b] = line.range(k);
            let by = (0.5 * (range[0] + range[1] - a - b) / period).round() * period;
            line.places.iter_mut().for_each(|p| p[k] += by);
        }
    }

    /// A range that is a period at most, which begins where the surface does.
    fn capped(&self, k: usize, range: [f64; 2], whole: &mut bool) -> [f64; 2] {
        let Some(period) = self.periods[k] else { return range };
        let over = range[1] - range[0] - period;
        if over > ABOUT * period {
            *whole = false;
        }
        let mut from = range[0];
        if let [Some(low), _] = self.ends[k] {
            from -= ((from - low) / period + ABOUT).floor() * period;
            // What is about the end is the end.
            if (from - low).abs() <= ABOUT * period {
                from = low;
            }
        }
        if over > -ABOUT * period {
            let from = self.ends[k][0].unwrap_or(from);
            [from, from + period]
        } else {
            [from, from + range[1] - range[0]]
        }
    }
}

/// The number that is `x` but for periods and follows `from` by one period at most, but not at once.
pub(crate) fn following(from: f64, x: f64, period: f64) -> f64 {
    let ahead = (x - from) / period;
    let ahead = ahead - ahead.floor();
    from + period * if ahead <= ABOUT || ahead >= 1.0 - ABOUT { 1.0 } else { ahead }
}

fn over(lines: &[Line], k: usize) -> [f64; 2] {
    let all = lines.iter().map(|l| l.range(k));
    all.fold([f64::INFINITY, f64::NEG_INFINITY], |a, b| [a[0].min(b[0]), a[1].max(b[1])])
}

#[cfg(test)]
mod tests {
    use super::*;

    const FLAT: Plane = Plane { periods: [None; 2], ends: [[None; 2]; 2] };
    /// A cylinder, a sphere and a torus of period 8.
    const ROUND: Plane = Plane { periods: [Some(8.0), None], ends: [[None; 2]; 2] };
    const POLES: Plane =
        Plane { periods: [Some(8.0), None], ends: [[None; 2], [Some(-2.0), Some(2.0)]] };
    const RING: Plane = Plane { periods: [Some(8.0); 2], ends: [[None; 2]; 2] };

    fn closed(corners: &[[f64; 2]]) -> Line {
        let mut places = Vec::new();
        for (k, a) in corners.iter().enumerate() {
            let b = corners[(k + 1) % corners.len()];
            places.extend((0..8).map(|i| {
                let t = f64::from(i) / 8.0;
                [0, 1].map(|k| a[k] + (b[k] - a[k]) * t)
            }));
        }
        Line { places, rounds: [0.0; 2], poles: false }
    }

    /// Once round u, with a wave.
    fn ring(v: f64, wave: f64, sense: f64) -> Line {
        let place = |k: i32| [4.0 + sense * f64::from(k - 4), v + wave * f64::from(k % 2)];
        Line { places: (0..9).map(place).collect(), rounds: [sense, 0.0], poles: false }
    }

    fn found(plane: &Plane, lines: &[Line]) -> ([[f64; 2]; 2], bool) {
        let border = plane.bounded(&mut lines.to_vec()).unwrap();
        (border.range, border.whole)
    }

    #[test]
    fn the_largest_line_bounds_a_plane() {
        let all = closed(&[[1.0, 2.0], [5.0, 2.0], [5.0, 3.0], [1.0, 3.0]]);
        let hole = closed(&[[2.0, 2.2], [3.0, 2.8], [3.0, 2.2]]);
        assert_eq!(found(&FLAT, std::slice::from_ref(&all)).0, [[1.0, 5.0], [2.0, 3.0]]);
        assert_eq!(found(&FLAT, &[hole.clone(), all.clone()]).0, [[1.0, 5.0], [2.0, 3.0]]);
        // A hole that was followed one round apart lies in the face.
        let mut apart = hole.clone();
        apart.places.iter_mut().for_each(|p| p[0] -= 8.0);
        assert_eq!(found(&ROUND, &[apart, all]).0, [[1.0, 5.0], [2.0, 3.0]]);
        // About a hole alone: all else, where that is known.
        assert_eq!(found(&RING, std::slice::from_ref(&hole)), ([[0.0, 8.0]; 2], false));
        assert_eq!(found(&ROUND, &[hole]).0, [[2.0, 3.0], [2.2, 2.8]]);
        assert_eq!(found(&RING, &[]), ([[0.0, 8.0]; 2], true));
        assert!(FLAT.bounded(&mut []).is_none() && ROUND.bounded(&mut []).is_none());
    }

    #[test]
    fn rings_bound_what_is_on_their_left() {
        let all = [0.0, 8.0];
        assert_eq!(
            found(&ROUND, &[ring(4.0, 0.0, -1.0), ring(1.0, 0.0, 1.0)]).0,
            [all, [1.0, 4.0]]
        );
        for (low, high, v) in
            [(1.0, 3.0, [1.0, 3.0]), (3.0, 1.0, [3.0, 9.0]), (3.0, 3.0, [3.0, 11.0])]
        {
            let rings = [ring(low, 0.0, 1.0), ring(high, 0.0, -1.0)];
            let (range, whole) = found(&RING, &rings);
            assert_eq!((range, whole), ([all, v], true));
        }
        assert_eq!(found(&POLES, &[ring(1.0, 0.0, 1.0)]), ([all, [1.0, 2.0]], true));
        assert_eq!(found(&POLES, &[ring(1.0, 0.0, -1.0)]).0, [all, [-2.0, 1.0]]);
        // A wave is in the box and is told.
        assert_eq!(found(&POLES, &[ring(1.0, 0.5, 1.0)]), ([all, [1.0, 2.0]], false));
        assert_eq!(found(&POLES, &[ring(1.0, -0.5, 1.0)]), ([all, [0.5, 2.0]], false));
        // Nothing ends there.
        assert!(ROUND.bounded(&mut [ring(1.0, 0.0, 1.0)]).is_none());
        assert!(RING.bounded(&mut [ring(1.0, 0.0, 1.0)]).is_none());
    }

    #[test]
    fn more_than_a_round_is_one() {
        let strip = closed(&[[1.0, 0.0], [11.0, 4.0], [11.0, 5.0], [1.0, 1.0]]);
        assert_eq!(found(&ROUND, &[strip]), ([[1.0, 9.0], [0.0, 5.0]], false));
        let seam = closed(&[[0.0, 0.0], [8.0, 0.0], [8.0, 5.0], [0.0, 5.0]]);
        assert_eq!(found(&ROUND, &[seam]), ([[0.0, 8.0], [0.0, 5.0]], true));
    }
}
