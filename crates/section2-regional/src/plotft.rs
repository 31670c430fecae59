//! PLOTFT: lines of sculptured surfaces and curves for the plot.

use std::sync::Arc;

use aptc_geometry::{Form, Sculptured, Vec3};
use aptc_protap::Arg;

use crate::drive::Course;
use crate::failure::Failure;
use crate::goloft::{End, Wish, at_line};
use crate::regional::Regional;
use crate::scon::Words;

/// Lines of a grid in one direction, and points of a statement, at most.
const LINES: f64 = 1000.0;
const POINTS: usize = 100_000;
/// How often a chord is halved.
const HALVINGS: u32 = 12;
/// Pieces of a line among which a plane is looked for.
const PIECES: u32 = 200;

/// How a line is divided.
#[derive(Clone, Copy, Debug)]
struct Steps {
    incr: f64,
    chord: Option<f64>,
    longest: f64,
}

impl Regional {
    /// Draws what the statement names; nothing moves.
    ///
    /// APT: `PLOTFT`. Of a surface with GRID lines of constant u and v at equal steps (as many as the numbers say;
    /// without a number those at the joints of its spans), with UCONST or VCONST one line from START to THRU; of a
    /// curve the curve. There is no tool here: START and THRU by a plane end where the line itself meets it.
    pub(crate) fn plotft(&mut self, args: &[Arg]) -> Result<(), Failure> {
        let mut w = Words(args);
        let Some((name, form)) = w.form() else {
            return Err(Failure::Undone { what: "this form of PLOTFT" });
        };
        if matches!(form.shape(), Form::Scurv(_)) {
            let wish = self.wish(&mut w)?;
            let curve = self.curve(name, form)?;
            let most = if wish.flow { curve.flow_span() } else { curve.span() };
            let at = |t: f64| {
                let inside = t.clamp(0.0, most);
                let p = if wish.flow { curve.at_flow(inside) } else { curve.at(inside) };
                p.point + p.first * (t - inside)
            };
            let line = stretch(&wish, most, at)?;
            let drawn = divided(line, &steps(&wish), at)?;
            self.drawn.push(drawn);
            return Ok(());
        }
        let surface = self.surface(name, form)?;
        if w.take("GRID") {
            return self.grid(&surface, &mut w);
        }
        let course = if w.take("UCONST") { Course::V } else { Course::U };
        w.take("VCONST");
        let fixed = w.number().unwrap_or(0.0);
        let most = surface.spans()[course.across().index()];
        if !(-1e-9..=most + 1e-9).contains(&fixed) {
            let need = format!("between 0 and {most}").into();
            let what = if course == Course::V { "UCONST" } else { "VCONST" };
            return Err(Failure::Value { what, value: fixed, need });
        }
        let wish = self.wish(&mut w)?;
        let at = along(&surface, course, fixed);
        let line = stretch(&wish, surface.spans()[course.index()], &at)?;
        let drawn = divided(line, &steps(&wish), at)?;
        self.drawn.push(drawn);
        Ok(())
    }

    /// Lines of constant u and v over the whole surface.
    fn grid(&mut self, surface: &Arc<Sculptured>, w: &mut Words<'_>) -> Result<(), Failure> {
        let mut lines: [Option<Option<f64>>; 2] = [None; 2];
        let mut rest: &[Arg] = w.0;
        // The steps stand behind the numbers of lines, and wish() knows them alone.
        let mut counts = Words(rest);
        while !counts.0.is_empty() {
            let k = usize::from(counts.take("VCONST"));
            if k == 0 && !counts.take("UCONST") {
                break;
            }
            let what = if k == 0 { "UCONST" } else { "VCONST" };
            let number = counts.number();
            if let Some(n) = number
                && !((1.0..=LINES).contains(&n) && n.fract() <= 0.0)
            {
                let need = format!("a whole number from 1 to {LINES}").into();
                return Err(Failure::Value { what, value: n, need });
            }
            lines[k] = Some(number);
            rest = counts.0;
        }
        let wish = self.wish(&mut Words(rest))?;
        if lines == [None; 2] {
            lines = [Some(None); 2];
        }
        let mut points = 0;
        for (k, wanted) in lines.into_iter().enumerate() {
            let Some(wanted) = wanted else { continue };
            let (course, most) = (if k == 0 { Course::V } else { Course::U }, surface.spans()[k]);
            // With a number the borders are among them; one line alone lies in the middle.
            let n = wanted.unwrap_or(most.min(LINES) + 1.0);
            let mut i = 0.0;
            while i < n {
                let fixed = if n > 1.0 { most * i / (n - 1.0) } else { 0.5 * most };
                let ends = [0.0, surface.spans()[course.index()]];
                let drawn = divided(ends, &steps(&wish), along(surface, course, fixed))?;
                points += drawn.len();
                if points > POINTS {
                    return Err(too_many("INCR", wish.incr));
                }
                self.drawn.push(drawn);
                i += 1.0;
            }
        }
        Ok(())
    }

    /// The lines that PLOTFT has drawn since the last call.
    pub fn take_drawn(&mut self) -> Vec<Vec<Vec3>> {
        std::mem::take(&mut self.drawn)
    }
}

fn along(surface: &Arc<Sculptured>, course: Course, fixed: f64) -> impl Fn(f64) -> Vec3 {
    let surface = Arc::clone(surface);
    move |t| {
        let [u, v] = at_line(course, fixed, t);
        surface.at(u, v).point
    }
}

fn steps(wish: &Wish) -> Steps {
    Steps { incr: wish.incr, chord: wish.chord, longest: wish.longest }
}

fn too_many(what: &'static str, value: f64) -> Failure {
    let need = format!("so great that at most {POINTS} points are drawn").into();
    Failure::Value { what, value, need }
}

/// First and last parameter of what is drawn; both the same with AT.
fn stretch(wish: &Wish, most: f64, at: impl Fn(f64) -> Vec3) -> Result<[f64; 2], Failure> {
    let place = |end: End, from: f64, word: &'static str| match end {
        End::Number(t) => Ok(t),
        End::Plane(_, plane) => {
            let t = |i: u32| from + (most - from) * (f64::from(i) / f64::from(PIECES));
            let over = |t: f64| plane.distance(at(t)) > 0.0;
            let first = over(from);
            let behind = (1..=PIECES).find(|i| over(t(*i)) != first);
            let Some(i) = behind else { return Err(Failure::PlaneMissed { word }) };
            let (mut a, mut b) = (t(i - 1), t(i));
            for _ in 0..60 {
                let mid = 0.5 * (a + b);
                if over(mid) == first { a = mid } else { b = mid }
            }
            Ok(0.5 * (a + b))
        }
    };
    if let Some(end) = wish.at {
        let t = place(end, 0.0, "AT")?;
        return Ok([t, t]);
    }
    let start = wish.start.map_or(Ok(0.0), |e| place(e, 0.0, "START"))?;
    let thru = wish.thru.map_or(Ok(most), |e| place(e, start, "THRU"))?;
    if start >= thru {
        let need = format!("less than the {thru} of THRU").into();
        return Err(Failure::Value { what: "START", value: start, need });
    }
    Ok([start, thru])
}

/// Points of the line: at equal steps of the parameter, or, with CHORD, so that no chord leaves it by more; no chord
/// is longer than LENGTH.
fn divided(
    [a, b]: [f64; 2],
    steps: &Steps,
    at: impl Fn(f64) -> Vec3,
) -> Result<Vec<Vec3>, Failure> {
    let step = if steps.chord.is_some() { 0.5 } else { steps.incr };
    let n = ((b - a) / step - 1e-9).ceil().max(0.0);
    if n > POINTS as f64 {
        return Err(too_many("INCR", steps.incr));
    }
    let mut points = vec![at(a)];
    let mut i = 0.0;
    while i < n {
        let [from, to] = [i, i + 1.0].map(|i| a + (b - a) * (i / n));
        let mut waiting = vec![(from, to, 0_u32)];
        while let Some((from, to, halvings)) = waiting.pop() {
            let (p, q) = (at(from), at(to));
            let mid = 0.5 * (from + to);
            let bent = steps.chord.is_some_and(|chord| {
                let way = (q - p).try_normalize(0.0).unwrap_or_else(Vec3::zeros);
                [0.25, 0.5, 0.75].iter().any(|s| {
                    let w = at(from + (to - from) * s) - p;
                    (w - way * way.dot(&w)).norm() > chord
                })
            });
            if halvings < HALVINGS && (bent || (q - p).norm() > steps.longest) {
                waiting.push((mid, to, halvings + 1));
                waiting.push((from, mid, halvings + 1));
                continue;
            }
            points.push(q);
            if points.len() > POINTS {
                let chord = steps.chord.map(|c| ("CHORD", c));
                let (what, value) = chord.unwrap_or(("LENGTH", steps.longest));
                return Err(too_many(what, value));
            }
        }
        i += 1.0;
    }
    Ok(points)
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::trig;

    #[test]
    fn a_chord_of_an_arc_stays_near_it() {
        let at = |t: f64| Vec3::new(10.0 * trig::cos(t), 10.0 * trig::sin(t), 0.0);
        let steps = Steps { incr: 0.05, chord: Some(0.01), longest: 100.0 };
        let points = divided([0.0, 3.0], &steps, at).unwrap();
        for w in points.windows(2) {
            assert!(10.0 - ((w[0] + w[1]) * 0.5).norm() <= 0.01);
        }
        assert!(points.len() < 50, "{}", points.len());
        assert!((points[points.len() - 1] - at(3.0)).norm() < 1e-12);
        // Equal steps, none longer than LENGTH; AT is a point.
        let even = Steps { incr: 1.0, chord: None, longest: 6.0 };
        assert_eq!(divided([0.0, 3.0], &even, at).unwrap().len(), 7);
        assert_eq!(divided([1.0, 1.0], &even, at).unwrap().len(), 1);
        let fine = Steps { incr: 1e-9, ..even };
        assert!(divided([0.0, 3.0], &fine, at).is_err());
    }
}
