//! A line of a surface or a curve with the tool along it.

use std::sync::Arc;

use aptc_contact::Tool;
use aptc_geometry::{Profile, SpaceCurve, Vec3};

use super::POSITIONS;
use super::wish::{End, Wish};
use crate::drive::Course;
use crate::failure::Failure;
use crate::gclear::Spot;
use crate::path::{Broken, Path};
use crate::position::{Odd, Position};
use crate::report::Note;
use crate::solve::{Setup, Take};

/// How often a chord of a curve is halved.
const HALVINGS: u32 = 20;

/// A line with the tool along it.
pub(super) enum Line<'a> {
    /// On a surface: what holds there, the parameter that runs, the value of the other, and the sense.
    Surface(Box<Setup<'a>>, Course, f64, f64),
    /// The tool end on a curve, whether it runs by FLOW, and the fixed axis.
    Curve(Arc<SpaceCurve>, bool, Vec3, &'a Profile),
}

/// What is milled of a line.
#[derive(Clone, Copy, Debug)]
pub(super) enum Stretch {
    At(f64),
    From([f64; 2]),
}

/// A position on the line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stop {
    t: f64,
    pub(super) te: Vec3,
    pub(super) ta: Vec3,
    pub(super) normal: Vec3,
}

impl Stop {
    pub(super) fn spot(&self) -> Spot {
        Spot { te: self.te, ta: self.ta, normal: self.normal }
    }
}

/// What was milled of a line.
#[derive(Default)]
pub(super) struct Milled {
    /// Places of the tool, stretch by stretch.
    pub(super) stretches: Vec<Vec<Spot>>,
    /// Does the tool stand on the side to which its axis does not point, so that its shank passes through?
    pub(super) through: bool,
    /// What is odd about its places.
    pub(super) odd: Odd,
    pub(super) notes: Vec<Note>,
    pub(super) why: Option<Failure>,
}

impl Milled {
    pub(super) fn take(&mut self, path: Path) {
        let spot = |p: &Position| Spot { te: p.te, ta: p.ta, normal: p.normal };
        self.odd = self.odd.or(Odd::of(&path.points));
        self.through |= path.points.iter().any(Position::stands_through);
        self.stretches.push(path.points.iter().map(spot).collect());
        self.notes.extend(path.notes);
    }

    /// Makes one of the last two stretches where nothing lies between the tool at the end of the one and at the beginning of the other,
    /// as at a joint of patches that do not follow one another in their row.
    pub(super) fn join(&mut self, nothing: impl Fn(&Spot, &Spot) -> bool) {
        let [.., before, last] = self.stretches.as_mut_slice() else { return };
        if let (Some(end), Some(begin)) = (before.last(), last.first())
            && nothing(end, begin)
        {
            let same = end.te == begin.te && end.ta == begin.ta;
            before.extend(last.drain(usize::from(same)..));
            self.stretches.pop();
        }
    }
}

impl Line<'_> {
    /// The last parameter.
    pub(super) fn most(&self) -> f64 {
        match self {
            Self::Surface(setup, course, ..) => setup.part.surface.spans()[course.index()],
            Self::Curve(c, false, ..) => c.span(),
            Self::Curve(c, true, ..) => c.flow_span(),
        }
    }

    /// The tool at a parameter; beyond the ends straight on.
    pub(super) fn stop(&self, t: f64) -> Result<Stop, Failure> {
        match self {
            Self::Curve(c, flow, ta, _) => {
                let inside = t.clamp(0.0, self.most());
                let p = if *flow { c.at_flow(inside) } else { c.at(inside) };
                Ok(Stop { t, te: p.point + p.first * (t - inside), ta: *ta, normal: *ta })
            }
            Self::Surface(setup, course, fixed, sense) => {
                let uv = at_line(*course, *fixed, t);
                let (p, _) = setup.position(uv, *course, *sense, None, Take::Nothing)?;
                Ok(Stop { t, te: p.te, ta: p.ta, normal: p.normal })
            }
        }
    }

    /// Mills a stretch, in the sense of the line.
    pub(super) fn mill(&self, [a, b]: [f64; 2], out: &mut Milled) {
        let Self::Surface(setup, course, fixed, sense) = self else { return };
        let (from, to) = if *sense > 0.0 { (a, b) } else { (b, a) };
        let mut setup = **setup;
        if let Some(incr) = setup.every {
            // As many equal steps as fit.
            let n = ((b - a) / incr + 1e-9).floor().max(1.0);
            if n > POSITIONS as f64 {
                let need = format!("so great that at most {POSITIONS} positions follow").into();
                out.why = Some(Failure::Value { what: "INCR", value: incr, need });
                return;
            }
            setup.every = Some((b - a) / n);
        }
        let (path, why) = match setup.run(at_line(*course, *fixed, from), to, *course, *sense) {
            Ok(path) => (path, None),
            Err(broken) => {
                let Broken { done, why } = *broken;
                (done, Some(why))
            }
        };
        out.take(path);
        out.why = why;
    }

    /// First and last parameter, rising, or the one of AT.
    pub(super) fn stretch(&self, wish: &Wish) -> Result<Stretch, Failure> {
        if let Some(at) = wish.at {
            let t = self.place(at, 0.0, "AT")?;
            return Ok(Stretch::At(t));
        }
        let start = wish.start.map_or(Ok(0.0), |e| self.place(e, 0.0, "START"))?;
        let thru = wish.thru.map_or(Ok(self.most()), |e| self.place(e, start, "THRU"))?;
        if start >= thru {
            let need = format!("less than the {thru} of THRU").into();
            return Err(Failure::Value { what: "START", value: start, need });
        }
        Ok(Stretch::From([start, thru]))
    }

    /// The parameter of an end, the first after `from`. The plane is met on the side from which the line
    /// comes for THRU, to which it goes for START and AT.
    fn place(&self, end: End, from: f64, word: &'static str) -> Result<f64, Failure> {
        let (relation, plane) = match end {
            End::Number(t) => return Ok(t),
            End::Plane(relation, plane) => (relation, plane),
        };
        let profile = match self {
            Self::Surface(setup, ..) => setup.profile,
            Self::Curve(.., profile) => profile,
        };
        let pieces = 200;
        let most = self.most();
        let at = |i: usize| {
            #[expect(clippy::cast_precision_loss, reason = "hundreds")]
            let share = i as f64 / pieces as f64;
            from + (most - from) * share
        };
        // TO: the cutter is wholly on the side of the stretch; PAST: on the other.
        let ends = [self.stop(at(0))?, self.stop(at(pieces))?];
        let kept = if word == "THRU" { ends[0] } else { ends[1] };
        let side = if plane.distance(kept.te) < 0.0 { -1.0 } else { 1.0 };
        let gap = |t: f64| -> Result<f64, Failure> {
            let s = self.stop(t)?;
            let over = plane.distance(s.te) * side;
            if relation == 0.0 {
                return Ok(over);
            }
            let tool = Tool { profile, te: s.te, ta: s.ta };
            let n = plane.n * side;
            Ok(if relation < 0.0 {
                plane.distance(tool.support(-n).point) * side
            } else {
                plane.distance(tool.support(n).point) * side
            })
        };
        let mut before = (at(0), gap(at(0))?);
        for i in 1..=pieces {
            let here = (at(i), gap(at(i))?);
            if (here.1 > 0.0) != (before.1 > 0.0) {
                let (mut a, mut b) = (before.0, here.0);
                for _ in 0..60 {
                    let mid = 0.5 * (a + b);
                    if (gap(mid)? > 0.0) == (before.1 > 0.0) { a = mid } else { b = mid }
                }
                return Ok(0.5 * (a + b));
            }
            before = here;
        }
        Err(Failure::PlaneMissed { word })
    }

    /// The positions of a curve from one parameter to the other.
    pub(super) fn run(&self, wish: &Wish, [a, b]: [f64; 2]) -> Result<Vec<Stop>, Failure> {
        let Some(chord) = wish.chord else {
            let n = ((b - a) / wish.incr + 1e-9).floor().max(1.0);
            if n > POSITIONS as f64 {
                let need = format!("so great that at most {POSITIONS} positions follow").into();
                return Err(Failure::Value { what: "INCR", value: wish.incr, need });
            }
            let mut stops = Vec::new();
            let mut k = 0.0;
            while k <= n {
                stops.push(self.stop(a + (b - a) * (k / n))?);
                k += 1.0;
            }
            return Ok(stops);
        };
        // Chords never pass a joint, where the curvature may jump.
        let mut stops = vec![self.stop(a)?];
        let mut from = a;
        while from < b {
            let joint = from.floor() + 1.0;
            let to = if joint < b { joint } else { b };
            let first = self.stop(from)?;
            let last = self.stop(to)?;
            self.halve(first, last, (chord, wish.longest), HALVINGS, &mut stops)?;
            if stops.len() > POSITIONS {
                let need = format!("so great that at most {POSITIONS} positions follow").into();
                return Err(Failure::Value { what: "CHORD", value: chord, need });
            }
            from = to;
        }
        Ok(stops)
    }

    /// Positions after `a` up to `b`, such that no chord leaves the line by more than `chord` or is longer than
    /// `longest`.
    fn halve(
        &self,
        a: Stop,
        b: Stop,
        (chord, longest): (f64, f64),
        left: u32,
        stops: &mut Vec<Stop>,
    ) -> Result<(), Failure> {
        let way = b.te - a.te;
        let length = way.norm();
        let mut off = 0.0_f64;
        for i in 1..8 {
            let s = self.stop(a.t + (b.t - a.t) * (f64::from(i) / 8.0))?;
            let w = s.te - a.te;
            let along =
                if length > 0.0 { (w.dot(&way) / length / length).clamp(0.0, 1.0) } else { 0.0 };
            off = off.max((w - way * along).norm());
        }
        if left == 0 || stops.len() > POSITIONS || (off <= chord && length <= longest) {
            stops.push(b);
            return Ok(());
        }
        let mid = self.stop(0.5 * (a.t + b.t))?;
        self.halve(a, mid, (chord, longest), left - 1, stops)?;
        self.halve(mid, b, (chord, longest), left - 1, stops)
    }
}

/// Parameters of a line at a place of it.
pub(crate) fn at_line(course: Course, fixed: f64, t: f64) -> [f64; 2] {
    match course {
        Course::U => [t, fixed],
        Course::V => [fixed, t],
    }
}
