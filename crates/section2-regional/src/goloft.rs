//! GOLOFT: along a line of constant parameter of a surface, or along a curve.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_contact::Tool;
use aptc_diagnostics::Origin;
use aptc_geometry::sculpt::Derivatives;
use aptc_geometry::{Form, Plane, Profile, Sculptured, SpaceCurve, Vec3};
use aptc_protap::{Arg, NameRef, ToolAxis};

use crate::failure::{self, Failure};
use crate::position::{tool_end, toward_axis};
use crate::regional::{Regional, Stand};
use crate::scon::Words;

/// Step of the parameter when neither INCR nor CHORD is given (APT4).
const STEP: f64 = 0.05;
/// Most positions of a line.
const POSITIONS: usize = 100_000;
/// How often a chord is halved.
const HALVINGS: u32 = 20;

/// Where a line begins or ends.
#[derive(Clone, Copy, Debug)]
enum End {
    /// At a parameter.
    Number(f64),
    /// Where the tool meets a plane: -1 TO, 0 ON, +1 PAST.
    Plane(f64, Plane),
}

/// What the statement says besides the line.
#[derive(Clone, Debug)]
struct Wish {
    start: Option<End>,
    thru: Option<End>,
    at: Option<End>,
    inverse: bool,
    mirror: bool,
    /// PARAM when false.
    flow: bool,
    incr: f64,
    chord: Option<f64>,
    longest: f64,
}

/// A line with the tool along it.
struct Line<'a> {
    guide: Guide,
    profile: &'a Profile,
    axis: Axis,
    /// MIRROR: -1.
    side: f64,
    thick: f64,
}

enum Guide {
    /// The surface, the index of the parameter that runs, and the value of the other.
    Surface(Arc<Sculptured>, usize, f64),
    /// The curve, and whether it runs by FLOW.
    Curve(Arc<SpaceCurve>, bool),
}

/// The rule for the tool axis.
#[derive(Clone, Copy, Debug)]
enum Axis {
    Fixed(Vec3),
    Normal,
}

/// What is milled of a line.
#[derive(Clone, Copy, Debug)]
enum Stretch {
    At(f64),
    From([f64; 2]),
}

/// A position on the line.
#[derive(Clone, Copy, Debug)]
struct Stop {
    t: f64,
    te: Vec3,
    ta: Vec3,
}

impl Regional {
    /// Mills the line; the positions go to `out`, one motion for each stretch that REGION leaves of it.
    ///
    /// APT: `GOLOFT`. Without tolerance compensation, as it was; START and THRU by a plane end where the
    /// tool meets it, not at the surface's own intersection.
    pub(crate) fn goloft(
        &mut self,
        origin: &Origin,
        args: &[Arg],
        out: &mut Vec<cl::Record>,
    ) -> Result<Option<Stand>, Failure> {
        let mut w = Words(args);
        let Some((name, form)) = w.form() else {
            return Err(Failure::Undone { what: "this form of GOLOFT" });
        };
        let running = if w.take("UCONST") {
            Some(1)
        } else if w.take("VCONST") {
            Some(0)
        } else {
            None
        };
        let fixed = w.number();
        let wish = self.wish(&mut w)?;
        let guide = match (form.shape(), running, fixed) {
            (Form::Scurv(_), ..) => Guide::Curve(self.curve(name, form)?, wish.flow),
            (_, Some(k), Some(c)) => {
                let surface = self.surface(name, form)?;
                let most = surface.spans()[1 - k];
                if !(-1e-9..=most + 1e-9).contains(&c) {
                    let need = format!("between 0 and {most}").into();
                    let what = if k == 1 { "UCONST" } else { "VCONST" };
                    return Err(Failure::Value { what, value: c, need });
                }
                Guide::Surface(surface, k, c)
            }
            _ => return Err(Failure::Undone { what: "GOLOFT without UCONST or VCONST" }),
        };
        let axis = match &self.settings.axis {
            None => Axis::Fixed(Vec3::z()),
            Some(ToolAxis::NormPs) if matches!(guide, Guide::Surface(..)) => Axis::Normal,
            Some(ToolAxis::Fixed(v)) => Axis::Fixed(v.try_normalize(0.0).unwrap_or_else(Vec3::z)),
            Some(_) => return Err(Failure::Undone { what: "GOLOFT with this form of TLAXIS" }),
        };
        let profile = self.settings.profile.as_ref().ok_or(Failure::NoCutter)?;
        let side = if wish.mirror { -1.0 } else { 1.0 };
        let line = Line { guide, profile, axis, side, thick: self.settings.thick };
        let stretches = match line.stretch(&wish)? {
            Stretch::At(t) => vec![vec![line.stop(t)?]],
            Stretch::From(ends) => self
                .left_of(&line, form, ends)
                .into_iter()
                .map(|ends| line.run(&wish, ends))
                .collect::<Result<Vec<_>, _>>()?,
        };
        let through = line.through(&stretches);
        if through {
            self.diagnostics.push(failure::through(origin, &name.name));
        }
        let mut stand = None;
        for mut stops in stretches {
            if wish.inverse {
                stops.reverse();
            }
            let [.., last] = stops.as_slice() else { continue };
            let along =
                if stops.len() > 1 { last.te - stops[stops.len() - 2].te } else { Vec3::zeros() };
            stand = Some(Stand { te: last.te, ta: last.ta, along });
            self.line_motion(origin, name, &stops, out);
        }
        Ok(stand)
    }

    fn wish(&self, w: &mut Words<'_>) -> Result<Wish, Failure> {
        let mut wish = Wish {
            start: None,
            thru: None,
            at: None,
            inverse: false,
            mirror: false,
            flow: false,
            incr: STEP,
            chord: None,
            longest: self.settings.maxdp(),
        };
        while let Some(word) = w.word() {
            match word {
                "START" => wish.start = end(w),
                "THRU" => wish.thru = end(w),
                "AT" => wish.at = end(w),
                "INVERS" => wish.inverse = true,
                "MIRROR" => wish.mirror = true,
                "FLOW" => wish.flow = true,
                "INCR" => wish.incr = positive(w, "INCR")?,
                "CHORD" => wish.chord = Some(positive(w, "CHORD")?),
                "LENGTH" => wish.longest = positive(w, "LENGTH")?,
                _ => {}
            }
        }
        Ok(wish)
    }

    /// What REGION leaves of a line between two parameters.
    fn left_of(&self, line: &Line<'_>, form: &Arc<Form>, ends: [f64; 2]) -> Vec<[f64; 2]> {
        match line.guide {
            Guide::Surface(_, running, fixed) => self.outlines.clip(form, running, fixed, ends),
            Guide::Curve(..) => vec![ends],
        }
    }

    fn line_motion(
        &self,
        origin: &Origin,
        name: &NameRef,
        stops: &[Stop],
        out: &mut Vec<cl::Record>,
    ) {
        if self.settings.cut == Some(false) {
            return;
        }
        let motion = cl::Motion {
            kind: cl::MotionKind::Continuous,
            name: cl::NameRef { name: name.name.clone(), subscript: name.subscript },
            arc: None,
            points: stops.iter().map(|s| cl::Position { te: s.te, ta: s.ta }).collect(),
            with_axis: self.settings.multax,
            control: None,
        };
        out.push(cl::Record { origin: origin.clone(), kind: cl::Kind::Motion(motion) });
    }
}

fn end(w: &mut Words<'_>) -> Option<End> {
    if let Some(x) = w.number() {
        return Some(End::Number(x));
    }
    let relation = match w.word() {
        Some("TO") => -1.0,
        Some("PAST") => 1.0,
        _ => 0.0,
    };
    let (_, form) = w.form()?;
    match form.shape() {
        Form::Plane(p) => Some(End::Plane(relation, *p)),
        Form::Line(l) => Some(End::Plane(relation, l.plane())),
        _ => None,
    }
}

fn positive(w: &mut Words<'_>, what: &'static str) -> Result<f64, Failure> {
    let value = w.number().unwrap_or(0.0);
    if value > 0.0 {
        Ok(value)
    } else {
        Err(Failure::Value { what, value, need: "greater than 0".into() })
    }
}

impl Line<'_> {
    /// The last parameter.
    fn most(&self) -> f64 {
        match &self.guide {
            Guide::Surface(s, running, _) => s.spans()[*running],
            Guide::Curve(c, false) => c.span(),
            Guide::Curve(c, true) => c.flow_span(),
        }
    }

    /// The tool at a parameter; beyond the ends straight on.
    fn stop(&self, t: f64) -> Result<Stop, Failure> {
        let inside = t.clamp(0.0, self.most());
        let over = t - inside;
        match &self.guide {
            Guide::Curve(c, flow) => {
                let p = if *flow { c.at_flow(inside) } else { c.at(inside) };
                let ta = match self.axis {
                    Axis::Fixed(v) => v,
                    Axis::Normal => Vec3::z(),
                };
                Ok(Stop { t, te: p.point + p.first * over, ta })
            }
            Guide::Surface(s, running, fixed) => {
                let uv = if *running == 0 { [inside, *fixed] } else { [*fixed, inside] };
                let d: Derivatives = s.at(uv[0], uv[1]);
                let along = if *running == 0 { d.u } else { d.v };
                let n = d.normal().ok_or(Failure::NoAxis { uv })? * self.side;
                let ta = match self.axis {
                    Axis::Fixed(v) => v,
                    Axis::Normal => n,
                };
                let last = toward_axis(n, ta).unwrap_or(along);
                let contact = d.point + along * over;
                let te = tool_end(self.profile, ta, contact, n, self.thick, last);
                Ok(Stop { t, te, ta })
            }
        }
    }

    /// Does the cutter stand on the side of the surface to which its axis does not point, so that its shank
    /// passes through it?
    fn through(&self, stretches: &[Vec<Stop>]) -> bool {
        let Guide::Surface(s, running, fixed) = &self.guide else { return false };
        stretches.iter().flatten().any(|stop| {
            let t = stop.t.clamp(0.0, self.most());
            let uv = if *running == 0 { [t, *fixed] } else { [*fixed, t] };
            let normal = s.at(uv[0], uv[1]).normal();
            normal.is_some_and(|n| n.dot(&stop.ta) * self.side < -1e-6)
        })
    }

    /// First and last parameter, rising, or the one of AT.
    fn stretch(&self, wish: &Wish) -> Result<Stretch, Failure> {
        if let Some(at) = wish.at {
            let t = self.place(at, 0.0, 1.0)?;
            return Ok(Stretch::At(t));
        }
        let start = wish.start.map_or(Ok(0.0), |e| self.place(e, 0.0, 1.0))?;
        let thru = wish.thru.map_or(Ok(self.most()), |e| self.place(e, start, -1.0))?;
        if start >= thru {
            let need = format!("less than the {thru} of THRU").into();
            return Err(Failure::Value { what: "START", value: start, need });
        }
        Ok(Stretch::From([start, thru]))
    }

    /// The parameter of an end, the first after `from`. The plane is met on the side from which the line
    /// comes for THRU (`-1`), to which it goes for START (`+1`).
    fn place(&self, end: End, from: f64, sense: f64) -> Result<f64, Failure> {
        let (relation, plane) = match end {
            End::Number(t) => return Ok(t),
            End::Plane(relation, plane) => (relation, plane),
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
        let kept = if sense > 0.0 { ends[1] } else { ends[0] };
        let side = if plane.distance(kept.te) < 0.0 { -1.0 } else { 1.0 };
        let gap = |t: f64| -> Result<f64, Failure> {
            let s = self.stop(t)?;
            let over = plane.distance(s.te) * side;
            if relation == 0.0 {
                return Ok(over);
            }
            let tool = Tool { profile: self.profile, te: s.te, ta: s.ta };
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
        Err(Failure::PlaneMissed { word: if sense > 0.0 { "START" } else { "THRU" } })
    }

    /// The positions from one parameter to the other.
    fn run(&self, wish: &Wish, [a, b]: [f64; 2]) -> Result<Vec<Stop>, Failure> {
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
