//! What lies between the first and the last pass of a region, on surfaces that may close in themselves.

use aptc_cldata::milling::Outline;
use aptc_geometry::sculpt::{Layout, nearest_on};
use aptc_geometry::{Sculptured, Vec3};

/// Share of the surface's size up to which two places are one.
const SAME: f64 = 1e-9;
/// Lines more than an outline has corners into which it is cut at most.
const MORE: usize = 4096;
/// A line is straight enough whose middle is this share of its length beside that of the straight line in space.
const BESIDE: f64 = 0.1;

/// The first pass, the ends of the others, the last pass back, and their beginnings back: an outline that does not cross itself, or
/// the reason why there is none. Passes by the parameters of what they touch, all in one direction.
///
/// Where the surface closes in itself, as one that is turned about an axis does, a line goes the shorter way round. One that goes round
/// as a whole holds what lies on the side of the passes between, to the end of the surface there: of a dome to its top.
pub(crate) fn round(passes: &[&[[f64; 2]]], surface: &Sculptured) -> Result<Outline, &'static str> {
    if !is_one(surface) {
        return Err("the parameters of its part surface do not run through from patch to patch");
    }
    let [first, between @ .., last] = passes else { return Err("it has fewer than two passes") };
    if passes.iter().any(|t| t.is_empty()) {
        return Err("a pass of it touches nothing");
    }
    let ends = between.iter().filter_map(|t| t.last());
    let begins = between.iter().rev().filter_map(|t| t.first());
    let way = first.iter().chain(ends).chain(last.iter().rev()).chain(begins);
    let mut corners: Vec<[f64; 2]> = way.copied().collect();
    corners.dedup();
    if corners.len() > 1 && corners.first() == corners.last() {
        corners.pop();
    }
    // Over a hole a pass goes on beyond the border.
    let spans = surface.spans();
    let inside = |at: [f64; 2], k: usize| at[k].clamp(SAME * spans[k], (1.0 - SAME) * spans[k]);
    let middle = |t: &[[f64; 2]]| [0, 1].map(|k| inside(t[t.len() / 2], k));
    let mut within: Vec<[f64; 2]> =
        between.iter().filter(|t| t.len() > 2).map(|t| middle(t)).collect();
    let whole = enclosed(&corners, surface, true, |outline| {
        if within.is_empty() {
            return point(passes, surface, outline.along);
        }
        Some(if most(outline, &within) { 0.0 } else { spans[outline.along] })
    })?;
    // Round a whole ball the outline holds nothing: its lines lie on its seam, to and fro.
    if within.is_empty() {
        let [p, q] = [first, last].map(|t| middle(t)).map(|[u, v]| surface.at(u, v).point);
        within.push(nearest_on(surface, 0.5 * (p + q)).uv);
    }
    if most(&whole, &within) { Ok(whole) } else { Err("its outline does not hold its passes") }
}

/// Do the parameters of a surface run through from patch to patch?
pub(crate) fn is_one(surface: &Sculptured) -> bool {
    matches!(surface.layout, Layout::Mesh { .. }) || surface.patches.len() == 1
}

/// What a closed curve holds by its corners, which may cross itself; round a surface that closes in itself what lies towards the
/// point that that ends in.
pub(crate) fn closed(corners: &[[f64; 2]], surface: &Sculptured) -> Result<Outline, &'static str> {
    enclosed(corners, surface, false, |outline| point(&[corners], surface, outline.along))
}

/// What an outline holds by its corners, of one that is to be `simple` or the reason why it is not; where it goes round by one
/// parameter, to the border of the other that `border` tells, within which it lies where that is at 0.
fn enclosed(
    corners: &[[f64; 2]],
    surface: &Sculptured,
    simple: bool,
    border: impl Fn(&Outline) -> Option<f64>,
) -> Result<Outline, &'static str> {
    let spans = surface.spans();
    let periods = [0, 1].map(|k| surface.closes(k).then_some(spans[k]));
    let next = corners.iter().cycle().skip(1);
    let mut round = Round { surface, periods, least: SAME * surface.extent(), lines: Vec::new() };
    for (a, b) in corners.iter().zip(next) {
        round.add(Line::between(*a, *b, periods), corners.len() + MORE);
    }
    let Round { least, lines, .. } = round;
    // A line of the outline that leaves the surface between its ends is none: the contact jumps, or the parameters do.
    let strays = simple
        && lines.iter().any(|line| {
            let [p, middle, q] = [0.0, 0.5, 1.0].map(|t| line.place(surface, t));
            (middle - 0.5 * (p + q)).norm() > (q - p).norm() + least
        });
    if strays {
        return Err("the contacts of its passes jump");
    }
    let around = match [0, 1].map(|k| lines.iter().any(|line| line.over[k] != 0.0)) {
        [true, true] => return Err("its passes go round its part surface by both parameters"),
        [false, false] => None,
        [u, _] => Some(usize::from(!u)),
    };
    let turns =
        around.map_or(0.0, |k| lines.iter().map(|line| line.over[k]).sum::<f64>() / spans[k]);
    let along = around.map_or(0, |k| 1 - k);
    let mut outline = Outline { lines: lines.iter().flat_map(Line::within).collect(), along };
    if simple && crosses(&outline.lines) {
        return Err("the contacts of its passes cross");
    }
    let is_odd = (0.5 * turns.round()).fract() != 0.0;
    if let Some(k) = around.filter(|_| is_odd) {
        let Some(border_at) = border(&outline) else {
            return Err("its passes go round its part surface, and nothing lies between them");
        };
        let mut border = [[0.0; 2]; 2];
        for (end, at) in border.iter_mut().zip([0.0, spans[k]]) {
            (end[k], end[along]) = (at, border_at);
        }
        outline.lines.push(border);
    }
    Ok(outline)
}

/// An outline as it is made.
struct Round<'a> {
    surface: &'a Sculptured,
    periods: [Option<f64>; 2],
    /// Places so near are one.
    least: f64,
    lines: Vec<Line>,
}

impl Round<'_> {
    /// Adds a line, in so many parts that it goes straight in space too where the surface lets it: beside a point, round which a
    /// parameter runs, a line in the parameters goes round. Up to so many lines in all.
    fn add(&mut self, line: Line, most: usize) {
        let [p, middle, q] = [0.0, 0.5, 1.0].map(|t| line.place(self.surface, t));
        let (wanted, length) = (0.5 * (p + q), (q - p).norm());
        let off = (middle - wanted).norm();
        if length > self.least && off > BESIDE * length && self.lines.len() < most {
            let hit = nearest_on(self.surface, wanted);
            // Its parts are shorter.
            if hit.distance < 0.5 * off.min(length) {
                let [a, b] = line.ends;
                self.add(Line::between(a, hit.uv, self.periods), most);
                self.add(Line::between(hit.uv, b, self.periods), most);
                return;
            }
        }
        self.lines.push(line);
    }
}

/// A line of an outline, which may come over an end of a parameter to where that begins.
struct Line {
    ends: [[f64; 2]; 2],
    /// What is to be added to its second end to go on there: a period where it does.
    over: [f64; 2],
}

impl Line {
    /// The shorter way round where a parameter has a period.
    fn between(a: [f64; 2], b: [f64; 2], periods: [Option<f64>; 2]) -> Self {
        /// A line that goes half round goes as its corners say.
        const HALF: f64 = 0.5 + 1e-9;
        let over = [0, 1].map(|k| {
            let ways = periods[k].map_or(0.0, |p| (a[k] - b[k]) / p);
            if ways.abs() <= HALF { 0.0 } else { periods[k].map_or(0.0, |p| p * ways.round()) }
        });
        Self { ends: [a, b], over }
    }

    /// A place of the surface by its share of the line.
    fn place(&self, surface: &Sculptured, share: f64) -> Vec3 {
        let [a, b] = self.ends;
        let [u, v] = [0, 1].map(|k| {
            let at = a[k] + (b[k] + self.over[k] - a[k]) * share;
            if self.over[k] == 0.0 { at } else { at.rem_euclid(self.over[k].abs()) }
        });
        surface.at(u, v).point
    }

    /// The same in two lines where it comes over an end.
    fn within(&self) -> impl Iterator<Item = [[f64; 2]; 2]> {
        let [a, b] = self.ends;
        let parts = match (0..2).find(|k| self.over[*k] != 0.0) {
            None => [Some([a, b]), None],
            Some(k) => {
                let (out, into) =
                    if self.over[k] > 0.0 { (self.over[k], 0.0) } else { (0.0, -self.over[k]) };
                let length = b[k] + self.over[k] - a[k];
                // From one end to the other, which is the same place.
                let share = if length == 0.0 { 0.0 } else { (out - a[k]) / length };
                let middle = |at: f64| {
                    let mut middle = [0, 1].map(|i| a[i] + (b[i] - a[i]) * share);
                    middle[k] = at;
                    middle
                };
                [Some([a, middle(out)]), Some([middle(into), b])]
            }
        };
        parts.into_iter().flatten()
    }
}

/// Do most of these places lie within?
fn most(outline: &Outline, places: &[[f64; 2]]) -> bool {
    2 * places.iter().filter(|at| outline.holds(**at)).count() > places.len()
}

/// At which end of the parameter is the surface a point that passes go round, or over? Of two the one that a pass comes nearer to.
fn point(passes: &[&[[f64; 2]]], surface: &Sculptured, along: usize) -> Option<f64> {
    let span = surface.spans()[along];
    let all = || passes.iter().flat_map(|pass| pass.iter().map(|uv| uv[along]));
    let low = all().fold(f64::INFINITY, f64::min);
    let high = all().fold(f64::NEG_INFINITY, f64::max);
    let ends = [(low, 0.0), (span - high, span)];
    let points = ends.into_iter().zip([false, true]);
    let points = points.filter(|(_, last)| surface.is_point(along, *last)).map(|(end, _)| end);
    points.min_by(|a, b| a.0.total_cmp(&b.0)).map(|end| end.1)
}

/// Do lines cross each other? Looked over along the parameter that they are shorter in, so that few lie beside each other: along v
/// where passes do.
pub(crate) fn crosses(lines: &[[[f64; 2]; 2]]) -> bool {
    let mut all = lines.to_vec();
    let share = |k: usize| {
        let ways: f64 = all.iter().map(|[a, b]| (b[k] - a[k]).abs()).sum();
        let xs = all.iter().flatten().map(|c| c[k]);
        let [low, high] =
            xs.fold([f64::INFINITY, f64::NEG_INFINITY], |r, x| [r[0].min(x), r[1].max(x)]);
        ways / (high - low)
    };
    let k = usize::from(share(1) < share(0));
    let low = |e: &[[f64; 2]; 2]| e[0][k].min(e[1][k]);
    all.sort_by(|a, b| low(a).total_cmp(&low(b)));
    let side = |[a, b]: [[f64; 2]; 2], p: [f64; 2]| {
        (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
    };
    let apart = |e: [[f64; 2]; 2], f: [[f64; 2]; 2]| side(e, f[0]) * side(e, f[1]);
    all.iter().enumerate().any(|(i, e)| {
        let high = e[0][k].max(e[1][k]);
        let beside = all[i + 1..].iter().take_while(|f| low(f) <= high);
        // Lines that meet at a corner do not cross.
        beside.into_iter().any(|f| apart(*e, *f) < 0.0 && apart(*f, *e) < 0.0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::sculpt::{CubicArc, SpaceCurve, revolve};
    use aptc_geometry::trig;
    use proptest::prelude::*;

    /// A cone of slope 1 / 2 that ends in its tip, 12 wide; turned about its axis by degrees, with its parameters exchanged, and from
    /// its rim to the tip.
    fn cone(by: f64, exchanged: bool, falling: bool) -> Sculptured {
        let (tip, rim) = (Vec3::new(0.0, 0.0, 6.0), Vec3::new(12.0, 0.0, 0.0));
        let [a, b] = if falling { [rim, tip] } else { [tip, rim] };
        let line = CubicArc::hermite(a, b, b - a, b - a);
        let curve = SpaceCurve::new(vec![line]);
        let s = revolve(&curve, Vec3::zeros(), Vec3::z(), [by, by + 360.0], true).unwrap();
        if !exchanged {
            return s;
        }
        let Layout::Mesh { u, v } = &s.layout else { unreachable!() };
        let [m, n] = [u.len() - 1, v.len() - 1];
        let of = |k: usize| s.patches[k / n + k % n * m].exchanged();
        Sculptured::grid((0..m * n).map(of).collect(), n, m).unwrap()
    }

    fn on(s: &Sculptured, [x, y]: [f64; 2]) -> [f64; 2] {
        nearest_on(s, Vec3::new(x, y, 6.0 - 0.5 * (x * x + y * y).sqrt())).uv
    }

    proptest! {
        /// Rectangles on a cone, askew: over its tip, beside it, over its seam.
        #[test]
        fn places_of_a_cone_are_within_as_in_a_plan(
            by in -180.0..180.0_f64, exchanged: bool, falling: bool,
            middle in prop::array::uniform2(-4.0..4.0_f64), half in prop::array::uniform2(0.5..3.0_f64),
            angle in 0.0..6.0_f64, inner in 1..3, places in prop::array::uniform8(prop::array::uniform2(-2.0..2.0_f64)),
        ) {
            let s = cone(by, exchanged, falling);
            let (sin, cos) = trig::sin_cos(angle);
            let plan = |[a, b]: [f64; 2]| {
                let [p, q] = [a * half[0], b * half[1]];
                [middle[0] + p * cos - q * sin, middle[1] + p * sin + q * cos]
            };
            let steps = |n: i32| (0..=n).map(move |i| f64::from(2 * i - n) / f64::from(n));
            // Of those between the ends are enough, with one place more or without.
            let pass = |b: f64| {
                let n = if b.abs() < 1.0 { inner } else { 60 };
                steps(n).map(|a| on(&s, plan([a, b]))).collect()
            };
            let passes: Vec<Vec<[f64; 2]>> = steps(20).map(pass).collect();
            let passes: Vec<&[[f64; 2]]> = passes.iter().map(|p| &p[..]).collect();
            let o = round(&passes, &s).unwrap();
            for [a, b] in places {
                let out = a.abs().max(b.abs());
                // Lines in the parameters are bent in the plan.
                if (out - 1.0).abs() > 0.1 {
                    prop_assert_eq!(o.holds(on(&s, plan([a, b]))), out < 1.0);
                }
            }
        }
    }

    /// The first of the passes goes straight over the tip, with a contact there or without.
    #[test]
    fn a_pass_over_the_tip() {
        for (exchanged, falling, shift) in
            [(false, false, 0.0), (false, true, 0.2), (true, false, 0.2), (true, true, 0.0)]
        {
            let s = cone(20.0, exchanged, falling);
            let line = |y: f64| (-10..=10).map(move |i| [0.5 * f64::from(i) + shift, y]);
            let passes =
                [0.0, 1.0, 2.0, 3.0].map(|y| line(y).map(|p| on(&s, p)).collect::<Vec<_>>());
            let o = round(&passes.each_ref().map(|p| &p[..]), &s).unwrap();
            let inside = [[0.01, 0.02], [-0.1, 0.02], [4.5, 0.3], [-4.5, 2.8], [0.0, 2.9]];
            let outside = [[0.01, -0.02], [-0.1, -0.02], [4.5, -0.3], [-4.5, 3.2], [5.5, 1.0]];
            assert!(inside.iter().all(|p| o.holds(on(&s, *p))));
            assert!(!outside.iter().any(|p| o.holds(on(&s, *p))));
        }
    }

    /// Rings from the tip on: the first is one place, and the outline holds what lies between it and the last, or is told not to.
    #[test]
    fn rings_from_a_tip_hold_what_lies_between_or_nothing_is_told() {
        let s = cone(0.0, false, false);
        let span = s.spans();
        let ring =
            |r: f64| (0..=24).map(|i| [span[0] * r, span[1] * f64::from(i) / 24.0]).collect();
        let rings: Vec<Vec<[f64; 2]>> = [0.2, 0.4, 0.6].map(ring).to_vec();
        let all: Vec<&[[f64; 2]]> = rings.iter().map(|r| &r[..]).collect();
        let o = round(&all, &s).unwrap();
        assert!(o.holds([span[0] * 0.3, 1.1]) && !o.holds([span[0] * 0.1, 1.1]));
        let tip = [[0.0, 0.0]];
        let from_tip: Vec<&[[f64; 2]]> = std::iter::once(&tip[..]).chain(all).collect();
        match round(&from_tip, &s) {
            Ok(o) => assert!(o.holds([span[0] * 0.1, 1.1]) && o.holds([span[0] * 0.5, 2.0])),
            Err(why) => assert!(why.contains("hold"), "{why}"),
        }
    }

    /// Lines half round go as their corners say, and from one end to the other is no way.
    #[test]
    fn lines_half_and_all_round() {
        let periods = [None, Some(3.0)];
        let over = |to: f64| Line::between([0.5, 0.0], [0.5, to], periods).over[1];
        assert!(over(1.5).abs() < 1e-12 && (over(1.6) + 3.0).abs() < 1e-12);
        let all: Vec<_> = Line::between([0.5, 3.0], [0.6, 0.0], periods).within().collect();
        assert!(all.iter().flatten().flatten().all(|x| x.is_finite()), "{all:?}");
    }

    /// A tube has no point that passes could go round, and passes all round it do not close over an end.
    #[test]
    fn passes_round_a_tube_have_no_outline() {
        let (a, b) = (Vec3::new(3.0, 0.0, 0.0), Vec3::new(3.0, 0.0, 9.0));
        let curve = SpaceCurve::new(vec![CubicArc::hermite(a, b, b - a, b - a)]);
        let tube = revolve(&curve, Vec3::zeros(), Vec3::z(), [0.0, 360.0], true).unwrap();
        let k = usize::from(tube.closes(1));
        let ring: Vec<[f64; 2]> = (0..40)
            .map(|i| {
                let mut at = [0.5; 2];
                at[k] = tube.spans()[k] * f64::from(i) / 40.0;
                at
            })
            .collect();
        let one: Vec<[f64; 2]> = ring[..20].to_vec();
        let other: Vec<[f64; 2]> = ring[20..].iter().rev().copied().collect();
        assert!(round(&[&one, &other], &tube).is_err());
    }

    /// The same made longer in either parameter, and lines that only come near each other.
    #[test]
    fn lines_cross_or_come_near() {
        let closed = |c: [[f64; 2]; 4]| [[c[0], c[1]], [c[1], c[2]], [c[2], c[3]], [c[3], c[0]]];
        for [x, y] in [[1.0, 0.1], [0.1, 1.0]] {
            assert!(crosses(&closed([[0.0, 0.0], [x, y], [x, 0.0], [0.0, y]])));
            assert!(!crosses(&closed([[0.0, 0.0], [x, 0.0], [x, y], [0.0, y]])));
        }
    }
}
