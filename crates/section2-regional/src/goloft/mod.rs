//! GOLOFT: along a line of constant parameter of a surface, or along a curve.

mod line;
mod wish;

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_cldata::milling::AskedLine;
use aptc_diagnostics::{Diagnostic, Origin};
use aptc_geometry::{Form, Segment, Vec3};
use aptc_protap::{Arg, NameRef};

use crate::area::{DriveArea, Guide, Hold, PartArea, Projection};
use crate::drive::{Course, DrivePoint};
use crate::failure::{self, Failure};
use crate::gclear::Spot;
use crate::outline::broken_off;
use crate::position::Chosen;
use crate::regional::{Regional, Stand};
use crate::report::reports;
use crate::scon::Words;
use crate::solve::{Setup, Take};
use crate::unused::Milling;
use crate::warning;
pub(crate) use line::at_line;
use line::{Line, Milled, Stop, Stretch};
pub(crate) use wish::{End, Wish};

/// Step of the parameter when neither INCR nor CHORD is given (APT4).
const STEP: f64 = 0.05;
/// Most positions of a line.
const POSITIONS: usize = 100_000;

/// What of a curve GOMILL mills.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CurveWish {
    /// One place alone.
    pub(crate) at: Option<f64>,
    /// START and THRU.
    pub(crate) ends: [Option<f64>; 2],
    /// From THRU to START.
    pub(crate) inverse: bool,
}

impl Regional {
    /// Mills the line; the positions go to `out`, one motion for each stretch that REGION leaves of it.
    ///
    /// APT: `GOLOFT`. A line of a surface is milled as SMIL mills one whose drive is the part surface: chords
    /// are held to INTOL and OUTTOL (CHORD stands for both) and to CHKSRF; INCR names positions that are put
    /// out in any case, and further ones are inserted where the tolerance asks for them. START and THRU by a
    /// plane end where the tool meets it, not at the surface's own intersection.
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
        let course = if w.take("UCONST") {
            Some(Course::V)
        } else if w.take("VCONST") {
            Some(Course::U)
        } else {
            None
        };
        let fixed = if course.is_some() { w.number() } else { None };
        let wish = self.wish(&mut w)?;
        if matches!(form.shape(), Form::Scurv(_)) {
            return self.along_curve(origin, (name, form), &wish, out);
        }
        self.outlines.known()?;
        let (course, fixed) = course
            .zip(fixed)
            .or_else(|| self.line_before(form))
            .ok_or(Failure::Undone { what: "GOLOFT before UCONST or VCONST named a line" })?;
        let side = if wish.mirror { -1.0 } else { 1.0 };
        let thick = self.settings.thick;
        let part = self.own_part(name, form, (side, thick))?;
        let spans = part.surface.spans();
        let most = spans[course.across().index()];
        if !(-1e-9..=most + 1e-9).contains(&fixed) {
            let need = format!("between 0 and {most}").into();
            let what = if course == Course::V { "UCONST" } else { "VCONST" };
            return Err(Failure::Value { what, value: fixed, need });
        }
        self.line = Some((Arc::clone(form), course, fixed));
        self.tells_unused(origin, Milling::Goloft);
        self.settings.axis_idle = false;
        let drive = own_drive(&part);
        let guard = self.guarded(Some(&part));
        self.tells_thin(origin, guard.as_ref());
        let sense = if wish.inverse { -1.0 } else { 1.0 };
        let end = if wish.inverse { spans[course.index()] } else { 0.0 };
        let begins = drive.place(at_line(course, fixed, end), course);
        let mut setup = wish.asked(self.line_setup(&drive, &part, side, &begins)?);
        setup.over = self.nearer_axis(setup, course, fixed, sense);
        let line = Line::Surface(Box::new(setup), course, fixed, sense);
        let mut milled = Milled::default();
        let stretch = line.stretch(&wish)?;
        let (Stretch::At(t) | Stretch::From([t, _])) = stretch;
        let start = at_line(course, fixed, t);
        let unchosen = chosen_counts(origin, &setup, (start, course, sense))?;
        let guard = guard.map(|g| setup.coming(g, self.avoid, start, (course, sense)));
        setup.guard = guard.as_ref().map(|g| (g, self.avoid));
        let line = Line::Surface(Box::new(setup), course, fixed, sense);
        match stretch {
            Stretch::At(_) => {
                let (p, _) = setup.position(start, course, sense, None, Take::Nothing)?;
                milled.take(setup.alone(p, (course, sense), None)?);
            }
            Stretch::From(ends) => {
                let mut all = self.outlines.clip(form, course.index(), fixed, ends);
                if wish.inverse {
                    all.reverse();
                }
                let nothing = |a: &Spot, b: &Spot| setup.touch((a.te, a.ta), (b.te, b.ta));
                for ends in all {
                    line.mill(ends, &mut milled);
                    milled.join(nothing);
                    if milled.why.is_some() {
                        break;
                    }
                }
            }
        }
        let mut control = self.milling_control(&part, None, false);
        if let Some(c) = Arc::get_mut(&mut control).and_then(|c| c.milling.as_mut()) {
            c.over = milled.stretches.len() > 1;
            // A place alone is touched wherever it lies.
            if let Stretch::From(ends) = stretch {
                let off = setup.strays();
                let line = AskedLine { running: course.index(), fixed, ends };
                c.limits = self.outlines.limits(form, vec![line], off, self.avoid);
            }
        }
        if milled.through {
            self.diagnostics.push(warning::through(origin, &name.name));
        }
        self.diagnostics.extend(unchosen);
        self.diagnostics.extend(reports(origin, &milled.notes));
        self.odd(origin, milled.odd);
        let on = Some((control, &part));
        let from = out.len();
        let stand = self.put_line(origin, name, &milled.stretches, on, out);
        if stand.is_err() || milled.why.is_some() {
            broken_off(&mut out[from..]);
        }
        milled.why.map_or(stand, Err)
    }

    /// The line of the statement before, if that was on the same surface.
    fn line_before(&self, form: &Arc<Form>) -> Option<(Course, f64)> {
        let line = self.line.as_ref().filter(|(f, ..)| crate::outline::same_form(f, form));
        line.map(|(_, course, fixed)| (*course, *fixed))
    }

    /// The sense across in which, of the two axes at an angle, the one begins that is nearer to that of before.
    fn nearer_axis(&self, setup: Setup<'_>, course: Course, fixed: f64, sense: f64) -> f64 {
        let last = self.stand.map_or_else(Vec3::z, |s| s.ta);
        let near = |over: f64| {
            let line = Line::Surface(Box::new(Setup { over, ..setup }), course, fixed, sense);
            line.stop(0.0).map_or(-1.0, |s| s.ta.dot(&last))
        };
        if near(-1.0) > near(1.0) + 1e-9 { -1.0 } else { 1.0 }
    }

    fn along_curve(
        &mut self,
        origin: &Origin,
        (name, form): (&NameRef, &Arc<Form>),
        wish: &Wish,
        out: &mut Vec<cl::Record>,
    ) -> Result<Option<Stand>, Failure> {
        self.tells_unprojected(origin);
        let stops = self.curve_stops(name, form, wish)?;
        let points = stops.iter().map(Stop::spot).collect();
        self.put_line(origin, name, &[points], None, out)
    }

    fn curve_stops(
        &mut self,
        name: &NameRef,
        form: &Arc<Form>,
        wish: &Wish,
    ) -> Result<Vec<Stop>, Failure> {
        let curve = self.curve(name, form)?;
        let ta = match &self.settings.axis {
            None => Vec3::z(),
            Some(aptc_protap::ToolAxis::Fixed(v)) => v.try_normalize(0.0).unwrap_or_else(Vec3::z),
            Some(aptc_protap::ToolAxis::Keep) => self.stand.map_or_else(Vec3::z, |s| s.ta),
            Some(_) => {
                let what = "milling along a curve with a tool axis that follows a surface";
                return Err(Failure::Undone { what });
            }
        };
        let profile = self.settings.profile.as_ref().ok_or(Failure::NoCutter)?;
        let line = Line::Curve(curve, wish.flow, ta, profile);
        let mut stops = match line.stretch(wish)? {
            Stretch::At(t) => vec![line.stop(t)?],
            Stretch::From(ends) => line.run(wish, ends)?,
        };
        if wish.inverse {
            stops.reverse();
        }
        Ok(stops)
    }

    /// Tool ends and axes along a curve whose chords leave it by no more than `chord`.
    ///
    /// # Errors
    /// As [`Regional::goloft`]; and an end beyond those of the curve.
    pub(crate) fn curve_places(
        &mut self,
        name: &NameRef,
        form: &Arc<Form>,
        what: CurveWish,
        chord: f64,
    ) -> Result<Vec<(Vec3, Vec3)>, Failure> {
        let most = self.curve(name, form)?.span();
        let [start, thru] = what.ends;
        for (word, value) in [("START", start), ("THRU", thru), ("AT", what.at)] {
            if let Some(value) = value.filter(|t| !(-1e-9..=most + 1e-9).contains(t)) {
                let need = format!("between 0 and {most}").into();
                return Err(Failure::Value { what: word, value, need });
            }
        }
        let wish = Wish {
            start: start.map(End::Number),
            thru: thru.map(End::Number),
            at: what.at.map(End::Number),
            inverse: what.inverse,
            mirror: false,
            flow: false,
            incr: STEP,
            chord: Some(chord),
            longest: self.settings.maxdp(),
        };
        let stops = self.curve_stops(name, form, &wish)?;
        Ok(stops.iter().map(|s| (s.te, s.ta)).collect())
    }

    /// The surface of the statement as part surface.
    pub(crate) fn own_part(
        &mut self,
        name: &NameRef,
        form: &Arc<Form>,
        (side, thick): (f64, f64),
    ) -> Result<PartArea, Failure> {
        let surface = self.lined(name, form)?;
        Ok(self.part(name, surface, true, (side, thick)))
    }

    /// What holds along lines of a surface that is its own drive.
    pub(crate) fn line_setup<'a>(
        &'a self,
        drive: &'a DriveArea,
        part: &'a PartArea,
        side: f64,
        start: &DrivePoint,
    ) -> Result<Setup<'a>, Failure> {
        let last = self.stand.map_or_else(Vec3::z, |s| s.ta);
        let axis = crate::axis::of_line(self.settings.axis.as_ref(), side, last, start)?;
        let setup = Setup::new(&self.settings, drive, part, axis)?;
        let chosen = Chosen::of(self.settings.axis.as_ref());
        Ok(Setup { numpts: POSITIONS, length: None, centred: true, chosen, ..setup })
    }

    /// The stretches with what GCLEAR adds to them, as motions. The line itself was checked along its surface, which is `on`; what is
    /// added, and a curve, which no surface governs, are motion from point to point that CHKSRF watches here.
    pub(crate) fn put_line(
        &mut self,
        origin: &Origin,
        name: &NameRef,
        stretches: &[Vec<Spot>],
        on: Option<(Arc<cl::Control>, &PartArea)>,
        out: &mut Vec<cl::Record>,
    ) -> Result<Option<Stand>, Failure> {
        let all = self.clears.around(stretches)?;
        self.clears.used = true;
        let guard = self.guarded(on.as_ref().map(|on| on.1)).filter(|_| !self.is_recording());
        let control = on.as_ref().map(|on| &on.0);
        let mut stand = None;
        let mut here = self.watch.last;
        let mut straight = Vec::new();
        let mut from_line = false;
        for mut leg in all {
            let extra = leg.extra || control.is_none();
            // How the tool comes to the line from elsewhere is not known here, between its stretches it is.
            let free = if extra { leg.points.len() } else { usize::from(stand.is_some()) };
            let free = &leg.points[..free.min(leg.points.len())];
            let blocked = guard.as_ref().and_then(|g| self.blocked(g, here, free));
            if let (true, Some(from), Some(to)) =
                (leg.over && from_line && !leg.extra, here, leg.points.first())
            {
                straight.push([from.0, to.0]);
            }
            from_line = !leg.extra;
            here = leg.points.last().copied().or(here);
            let why = blocked.map(|(k, why)| {
                leg.points.truncate(k);
                match why {
                    Failure::Way(deep) if leg.over && k == 0 => Failure::Over(deep),
                    why => why,
                }
            });
            if self.settings.cut != Some(false)
                && let Some(args) = leg.feed.args(&self.feed)
            {
                let kind = cl::Kind::Post { word: "FEDRAT".into(), args };
                out.push(cl::Record { origin: origin.clone(), kind });
            }
            let along = match leg.points.as_slice() {
                [.., before, last] => last.0 - before.0,
                _ => Vec3::zeros(),
            };
            stand = leg.points.last().map(|&(te, ta)| Stand { te, ta, along }).or(stand);
            if self.settings.cut == Some(false) || leg.points.is_empty() {
                why.map_or(Ok(()), Err)?;
                continue;
            }
            let on_line = if leg.extra { None } else { control };
            let kind =
                if on_line.is_some() { cl::MotionKind::Continuous } else { cl::MotionKind::Goto };
            let motion = cl::Motion {
                kind,
                name: cl::NameRef { name: name.name.clone(), subscript: name.subscript },
                arc: None,
                points: leg.points.into_iter().map(|(te, ta)| cl::Position { te, ta }).collect(),
                with_axis: self.settings.multax,
                control: on_line.map(Arc::clone),
            };
            out.push(cl::Record { origin: origin.clone(), kind: cl::Kind::Motion(motion) });
            why.map_or(Ok(()), Err)?;
        }
        let moves = self.settings.cut != Some(false) && !self.is_recording();
        if let (true, Some(first)) = (moves && !self.told_over, straight.first()) {
            self.told_over = true;
            self.diagnostics.push(warning::straight_over(origin, *first, straight.len()));
        }
        Ok(stand)
    }
}

/// A surface as its own drive.
pub(crate) fn own_drive(part: &PartArea) -> DriveArea {
    let [u, v] = part.surface.spans();
    DriveArea {
        name: part.name.clone(),
        guide: Guide::Surface(Arc::clone(&part.surface)),
        u: [0.0, u],
        v: [0.0, v],
        hold: Hold::At,
        projection: Projection::Normal,
        offset: 0.0,
    }
}

/// Says where RADIUS or HIGHT of TLAXIS do not count at a place of a line.
///
/// # Errors
/// The number that counts is beyond the face that lies along the surface.
pub(crate) fn chosen_counts(
    origin: &Origin,
    setup: &Setup<'_>,
    (uv, course, sense): ([f64; 2], Course, f64),
) -> Result<Option<Diagnostic>, Failure> {
    if setup.chosen == Chosen::default() {
        return Ok(None);
    }
    let (p, _) = setup.position(uv, course, sense, None, Take::Nothing)?;
    match setup.chosen.counts(setup.profile, p.ta, p.normal) {
        Some((segment, Some(value), [least, most])) => {
            if (least..=most).contains(&value) {
                return Ok(None);
            }
            let what = match segment {
                Segment::LowerLine => "RADIUS of TLAXIS",
                _ => "HIGHT of TLAXIS",
            };
            let (least, most) = (failure::short(least), failure::short(most));
            let need = format!("between {least} and {most}, where the face of the cutter is");
            Err(Failure::Value { what, value, need: need.into() })
        }
        _ => Ok(Some(warning::contact_not_chosen(origin, &setup.part.name.name))),
    }
}
