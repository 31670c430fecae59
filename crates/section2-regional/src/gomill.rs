//! GOMILL: the lines of constant parameter of a surface, one beside the other.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_cldata::milling::AskedLine;
use aptc_diagnostics::Origin;
use aptc_geometry::{Form, Vec3};
use aptc_protap::{Arg, NameRef};

use crate::area::StepoverArea;
use crate::crew::Crew;
use crate::drive::Course;
use crate::failure::Failure;
use crate::goloft::{CurveWish, at_line, chosen_counts, own_drive};
use crate::path::Path;
use crate::position::Odd;
use crate::put::Put;
use crate::region::{GOT_OUT, Region};
use crate::regional::{Regional, Stand};
use crate::report::reports;
use crate::retract::Retract;
use crate::scon::Words;
use crate::solve::Take;
use crate::strips;
use crate::touched::along_lines;
use crate::unused::{Milling, lines_out};
use crate::warning::{left_standing, through};
use crate::within::{self, Stretch};

/// What the statement says besides surface and first line.
#[derive(Default)]
struct Wish {
    step: Option<f64>,
    pick: bool,
    scallop: f64,
    most: f64,
    retract: Option<Retract>,
    start: Option<f64>,
    thru: Option<f64>,
    inverse: bool,
    /// Is the other side of the surface milled than that of its normal?
    mirror: bool,
    at: Option<f64>,
}

impl Regional {
    /// `GOMILL/surface,UCONST|VCONST,c,STEPOV,s[,PICKFD|ZIGZAG][,SCALOP,h][,MAXSTP,m][,RETR,d|vector|plane]`
    /// `[,START,a][,THRU,b][,INVERS][,MIRROR][,AT,x]`: lines from the one named on, by steps of the parameter of at most
    /// |s| towards its sign, narrower where SCALOP or MAXSTP ask for it, up to the border; back and forth, or
    /// with PICKFD in one direction, led back by RETR. Of the lines only what REGION leaves is milled, with RETR
    /// between. AT touches each line at one place and leaves it by RETR.
    ///
    /// APT: `GOMILL`, whose routine was empty. Its lines are those of GOLOFT.
    pub(crate) fn gomill(
        &mut self,
        origin: &Origin,
        args: &[Arg],
        crew: &dyn Crew,
        out: &mut Vec<cl::Record>,
    ) -> Result<Option<Stand>, Failure> {
        let mut w = Words(args);
        let Some((name, form)) = w.form() else {
            return Err(Failure::Undone { what: "this form of GOMILL" });
        };
        if matches!(form.shape(), Form::Scurv(_)) {
            return self.gomill_curve(origin, (name, form), &mut w, out);
        }
        self.outlines.known()?;
        let course = if w.take("UCONST") { Course::V } else { Course::U };
        w.take("VCONST");
        let first = w.number().unwrap_or(0.0);
        let wish = wish(&mut w)?;
        self.tells_unused(origin, Milling::Gomill);
        self.settings.axis_idle = false;
        let side = if wish.mirror { -1.0 } else { 1.0 };
        let part = self.own_part(name, form, (side, self.settings.thick))?;
        let mut drive = own_drive(&part);
        let spans = part.surface.spans();
        let most = spans[course.across().index()];
        if !(-1e-9..=most + 1e-9).contains(&first) {
            let need = format!("between 0 and {most}").into();
            let what = if course == Course::V { "UCONST" } else { "VCONST" };
            return Err(Failure::Value { what, value: first, need });
        }
        let long = spans[course.index()];
        let (start, thru) = (wish.start.unwrap_or(0.0), wish.thru.unwrap_or(long));
        for (what, value) in [("START", start), ("THRU", thru)] {
            if !(-1e-9..=long + 1e-9).contains(&value) {
                let need = format!("between 0 and {long}").into();
                return Err(Failure::Value { what, value, need });
            }
        }
        if start >= thru {
            let need = format!("less than the {thru} of THRU").into();
            return Err(Failure::Value { what: "START", value: start, need });
        }
        match course {
            Course::U => drive.u = [start, thru],
            Course::V => drive.v = [start, thru],
        }
        let start_uv = at_line(course, first, if wish.inverse { thru } else { start });
        let over = if wish.step.is_some_and(|s| s < 0.0) { -1.0 } else { 1.0 };
        if (first - if over > 0.0 { most } else { 0.0 }).abs() <= 1e-9 {
            let word = if course == Course::V { "UCONST" } else { "VCONST" };
            self.diagnostics.push(lines_out(origin, &name.name, (word, first, wish.step)));
        }
        let sense = if wish.inverse { -1.0 } else { 1.0 };
        let begins = drive.place(start_uv, course);
        let setup = self.line_setup(&drive, &part, side, &begins)?;
        let unchosen = chosen_counts(origin, &setup, (start_uv, course, sense))?;
        let first_place = setup.position(start_uv, course, sense, None, Take::Nothing);
        let passes = first_place.is_ok_and(|(p, _)| p.stands_through());
        self.diagnostics.extend(unchosen);
        self.diagnostics.extend(passes.then(|| through(origin, &name.name)));
        let guard = self.guarded(Some(&part));
        self.tells_thin(origin, guard.as_ref());
        let mut setup = self.line_setup(&drive, &part, side, &begins)?;
        // The first place within REGION is not known yet.
        let guard = match guard {
            Some(g) if !self.outlines.is_active() => {
                Some(setup.coming(g, self.avoid, start_uv, (course, sense)))
            }
            other => other,
        };
        setup.guard = guard.as_ref().map(|g| (g, self.avoid));
        setup.over = over;
        let parameter = wish.step.map(f64::abs);
        let plain = wish.scallop <= 0.0 && wish.most <= 0.0;
        let stepover = StepoverArea {
            scallop: wish.scallop,
            most: if plain { -parameter.unwrap_or(1.0) } else { wish.most },
            lift: 0.0,
            paths: None,
            parameter,
        }
        .of(setup.profile);
        let retract = wish.retract.or(self.areas.clearance.map(Retract::Plane));
        let clearance = if wish.pick { Some(retract.ok_or(Failure::NoRetract)?) } else { None };
        let guide = Some(&drive.guide);
        let senses = [sense, over];
        let ways = &self.ways_of(Some(&part));
        let feeds = [0.0; 4];
        let region =
            Region { setup, stepover, feeds, clearance, ways, course, senses, skip: false };
        if let Some(at) = wish.at {
            if self.outlines.is_active() {
                return Err(Failure::Undone {
                    what: "GOMILL with AT while REGION limits the lines",
                });
            }
            let done = touched(&region, (course, first, at), wish.retract);
            let control = self.milling_control(&part, None, false);
            self.diagnostics.extend(reports(origin, &done.notes));
            self.odd(origin, done.odd);
            let stand = self.put(origin, (name, guide), done.puts, Some(&control), out);
            return done.why.map_or(Ok(stand), Err);
        }
        let from = start_uv;
        if self.outlines.is_active() {
            let ends = [start, thru];
            let lines = region.lines(from);
            let stretches = self.left(&region, form, &lines, (ends, wish.pick));
            let done = within::mill(&region, &stretches, retract, crew)?;
            let strips = if done.why.is_none() { &done.strips[..] } else { &[] };
            let excused = done.avoided.then_some(GOT_OUT);
            let scallop =
                strips::scallop(strips, (&part.surface, course), stepover.scallop, excused);
            let mut control = self.milling_control(&part, scallop, false);
            if let Some(c) = Arc::get_mut(&mut control).and_then(|c| c.milling.as_mut()) {
                let fixed = lines.iter().map(|at| at[course.across().index()]);
                let asked = fixed.map(|fixed| AskedLine { running: course.index(), fixed, ends });
                let off = setup.strays();
                let asked = if done.why.is_none() { asked.collect() } else { Vec::new() };
                c.limits = self.outlines.limits(form, asked, off, self.avoid);
            }
            self.diagnostics.extend(reports(origin, &done.notes));
            self.odd(origin, done.odd);
            let stand = self.put(origin, (name, guide), done.puts, Some(&control), out);
            return done.why.map_or(Ok(stand), Err);
        }
        let done = region.mill(from, crew);
        let extent = || along_lines(&done.touched, &part.surface);
        let scallop = done.scallop(stepover.scallop, extent, false);
        let control = self.milling_control(&part, scallop, false);
        self.diagnostics.extend(reports(origin, &done.notes));
        self.odd(origin, done.odd);
        let left = done.stands.map(|s| left_standing(origin, &name.name, &s));
        self.diagnostics.extend(left);
        let stand = self.put(origin, (name, guide), done.puts, Some(&control), out);
        done.why.map_or(Ok(stand), Err)
    }

    /// `GOMILL/curve,VCONST,0[,START,a][,THRU,b][,INVERS][,AT,x[,RETR,d]]`: the tool end along the curve, its chords
    /// within the tolerance of the drive surface; GOMILL/curve,UCONST,c: at its place c alone. AT and UCONST are led
    /// to and from the place by RETR. A curve is a line of constant v, 0, the only one, whose u is its parameter:
    /// no step leads to another.
    fn gomill_curve(
        &mut self,
        origin: &Origin,
        (name, form): (&NameRef, &Arc<Form>),
        w: &mut Words<'_>,
        out: &mut Vec<cl::Record>,
    ) -> Result<Option<Stand>, Failure> {
        let place = w.take("UCONST");
        w.take("VCONST");
        let fixed = w.number().unwrap_or(0.0);
        let given = wish(w)?;
        if given.scallop > 0.0 || given.most > 0.0 {
            return Err(Failure::Undone {
                what: "SCALOP or MAXSTP of GOMILL along a curve, which has one line",
            });
        }
        if !place && fixed != 0.0 {
            let need = "0, for a curve has one line".into();
            return Err(Failure::Value { what: "VCONST", value: fixed, need });
        }
        let at = if place { Some(fixed) } else { given.at };
        let ends = [given.start, given.thru];
        let (what, chord) =
            (CurveWish { at, ends, inverse: given.inverse }, self.settings.lateral());
        let mut points = self.curve_places(name, form, what, chord)?;
        if let (Some(_), Some(r), Some(&here)) = (at, &given.retract, points.first()) {
            points = vec![r.above(here), here, r.above(here)];
        }
        let guard = self.guarded(None).filter(|_| !self.is_recording());
        let why = guard.and_then(|g| self.blocked(&g, self.watch.last, &points));
        let why = why.map(|(k, why)| {
            points.truncate(k);
            why
        });
        let index = out.len();
        let stand = self.put(origin, (name, None), vec![Put::Move(points)], None, out);
        // No surface governs it: it counts as motion from point to point.
        for record in &mut out[index..] {
            if let cl::Kind::Motion(motion) = &mut record.kind {
                motion.kind = cl::MotionKind::Goto;
            }
        }
        why.map_or(Ok(stand), Err)
    }

    /// What REGION leaves of the lines, in the order and the sense in which they are milled.
    fn left(
        &self,
        region: &Region<'_>,
        form: &Arc<Form>,
        lines: &[[f64; 2]],
        (ends, pick): ([f64; 2], bool),
    ) -> Vec<Stretch> {
        let course = region.course;
        let mut rises = region.senses[0] > 0.0;
        let mut all = Vec::new();
        for (line, at) in lines.iter().enumerate() {
            let fixed = at[course.across().index()];
            let stretch = |[a, b]: [f64; 2]| {
                let (from, to) = if rises { (a, b) } else { (b, a) };
                Stretch { line, fixed, from, to }
            };
            let left = self.outlines.clip(form, course.index(), fixed, ends);
            let before = all.len();
            all.extend(left.into_iter().map(stretch));
            if !rises {
                all[before..].reverse();
            }
            // Back and forth, but for PICKFD.
            rises = if pick || all.len() == before { rises } else { !rises };
        }
        all
    }
}

/// One place on each line, and back from it. Each is checked as the first place of a path is, and the ways between them as
/// those between passes are.
fn touched(
    region: &Region<'_>,
    (course, first, at): (Course, f64, f64),
    retract: Option<Retract>,
) -> within::Done {
    let mut done = within::Done::default();
    let mut points: Vec<(Vec3, Vec3)> = Vec::new();
    for uv in region.lines(at_line(course, first, at)) {
        let mut uv = uv;
        uv[course.index()] = at;
        let found = region.setup.settled(uv, course, 1.0, None, Take::Band);
        let path = found.and_then(|(p, _)| region.setup.alone(p, (course, 1.0), None));
        let Path { points: stood, notes, .. } = match path {
            Ok(path) => path,
            Err(why) => {
                done.why = Some(why);
                break;
            }
        };
        done.notes.extend(notes);
        done.odd = done.odd.or(Odd::of(&stood));
        let Some(here) = stood.first().map(|p| (p.te, p.ta)) else { continue };
        let way = match &retract {
            Some(r) => vec![r.above(here), here, r.above(here)],
            None => vec![here],
        };
        // How the tool comes to the first place is not known here.
        let from = points.last().copied().unwrap_or(way[0]);
        if let Err(blocked) = region.clear(from, &way) {
            done.why = Some(blocked);
            break;
        }
        points.extend(way);
    }
    done.puts.push(Put::Move(points));
    done
}

fn wish(w: &mut Words<'_>) -> Result<Wish, Failure> {
    let mut wish = Wish::default();
    while let Some(word) = w.word() {
        match word {
            "STEPOV" => wish.step = w.number(),
            "PICKFD" => wish.pick = true,
            "SCALOP" => wish.scallop = w.positive("SCALOP")?,
            "MAXSTP" => wish.most = w.positive("MAXSTP")?,
            "RETR" => wish.retract = retract(w)?,
            "START" => wish.start = w.number(),
            "THRU" => wish.thru = w.number(),
            "INVERS" => wish.inverse = true,
            "MIRROR" => wish.mirror = true,
            "AT" => wish.at = w.number(),
            _ => {}
        }
    }
    if wish.step == Some(0.0) {
        let need = "other than 0".into();
        return Err(Failure::Value { what: "STEPOV", value: 0.0, need });
    }
    Ok(wish)
}

fn retract(w: &mut Words<'_>) -> Result<Option<Retract>, Failure> {
    if w.0.first().is_some_and(|a| matches!(a, Arg::Number(_))) {
        return Ok(Some(Retract::Along(w.positive("RETR")?)));
    }
    if let Some(v) = w.vector() {
        return Ok(Some(Retract::By(v)));
    }
    Ok(match w.form().map(|(_, f)| f.shape().clone()) {
        Some(Form::Plane(p)) => Some(Retract::Plane(p)),
        Some(Form::Line(l)) => Some(Retract::Plane(l.plane())),
        _ => None,
    })
}
