//! SMIL: a point, a line or the region.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_cldata::milling::{Extent, Milled, Milling, Plain, Raised, Scallop};
use aptc_diagnostics::Origin;
use aptc_geometry::{Form, Profile, Vec3};
use aptc_protap::{Arg, NameRef};

use crate::area::{Areas, AxisArea, DriveArea, Guide, Hold, PartArea};
use crate::avoid::Avoid;
use crate::crew::Crew;
use crate::drive::Course;
use crate::failure::{Deep, Failure};
use crate::guard::{Checked, Guard};
use crate::jump::Stands;
use crate::path::{Broken, Path};
use crate::position::{Odd, Position};
use crate::put::{Along, Put};
use crate::region::Region;
use crate::regional::{Regional, Stand};
use crate::report::{Note, lifted_far, reports};
use crate::retract::Retract;
use crate::scon::Words;
use crate::settings::Band;
use crate::solve::{Setup, Take};
use crate::touched::{along_lines, led};
use crate::unused::{Milling as Before, leads_out, steps_out};
use crate::warning::{left_out, left_standing, put_out, touches_with};

/// What a statement gives.
#[derive(Default)]
struct Done {
    puts: Vec<Put>,
    /// Gouges that were avoided.
    notes: Vec<Note>,
    odd: Odd,
    /// The first position, put out or not.
    first: Option<(Vec3, Vec3)>,
    /// Do passes return over the clearance plane?
    picks: bool,
    /// Why it ended early.
    why: Option<Failure>,
    /// What is left between its passes.
    scallop: Option<Scallop>,
    /// The same where the contact jumps and no scallop is asked for.
    stands: Option<Stands>,
    /// Is its first point not put out, as the tool stands there?
    joined: bool,
    /// Was the tool end led away from where it stands on the surface?
    away: bool,
    /// Does the way of its passes lead out of the limits at once? The start and the sense.
    outward: Option<([f64; 2], f64)>,
    /// Does the step from the first pass to the next?
    sideways: Option<([f64; 2], f64)>,
}

impl Regional {
    /// Mills; the positions go to `out`.
    ///
    /// APT: `SMIL`.
    pub(crate) fn smil(
        &mut self,
        origin: &Origin,
        args: &[Arg],
        crew: &dyn Crew,
        out: &mut Vec<cl::Record>,
    ) -> Result<Option<Stand>, Failure> {
        let mut w = Words(args);
        let word = w.word().unwrap_or("");
        w.take("DS");
        w.take("PARAM");
        let from = [w.number().unwrap_or(0.0), w.number().unwrap_or(0.0)];
        self.tells_unused(origin, if word == "POSN" { Before::Posn } else { Before::Smil });
        let guard = self.guard();
        self.tells_thin(origin, guard.as_ref());
        let mut done = match word {
            "POSN" => self.point(from, &mut w, guard)?,
            "PATH" => self.line(from, &mut w, guard)?,
            "ZIGZAG" | "PICKFD" => self.area(word == "PICKFD", from, &mut w, guard, crew)?,
            _ => return Err(Failure::Undone { what: "this form of SMIL" }),
        };
        if done.joined {
            self.join(origin, &mut done)?;
            // Where a statement before failed nothing is known of the way to the second point.
            done.joined &= self.stand.is_some();
            // How the tool comes to a surface on which its end is led is not known either.
            let near = 2.0 * (self.settings.band().intol + self.settings.band().outtol);
            let stands =
                self.stand.zip(done.first).is_some_and(|(s, f)| (s.te - f.0).norm() <= near);
            done.joined &= stands || self.areas.part.as_ref().is_none_or(|p| p.touches);
        }
        self.diagnostics.extend(reports(origin, &done.notes));
        self.odd(origin, done.odd);
        self.diagnostics.extend(done.outward.map(|(from, sense)| leads_out(origin, from, sense)));
        self.diagnostics.extend(done.sideways.map(|(from, sense)| steps_out(origin, from, sense)));
        let part = self.areas.part.as_ref().map_or("", |p| &p.name.name);
        let left = done.stands.map(|s| left_standing(origin, part, &s));
        self.diagnostics.extend(left);
        let control = self.control(&done);
        let drive = self.areas.drive.as_ref();
        let name = drive.map(|d| d.name.clone()).unwrap_or_default();
        let guide = drive.map(|d| d.guide.clone());
        let stand = self.put(origin, (&name, guide.as_ref()), done.puts, control.as_ref(), out);
        done.why.map_or(Ok(stand), Err)
    }

    /// Drive, part and axis, or which of them are not set.
    fn set(&self) -> Result<(&DriveArea, &PartArea, AxisArea), Failure> {
        let a = &self.areas;
        if let (Some(d), Some(p), Some(x)) = (&a.drive, &a.part, a.axis) {
            return Ok((d, p, x));
        }
        let areas =
            [("DS", a.drive.is_none()), ("PS", a.part.is_none()), ("AXIS", a.axis.is_none())];
        Err(Areas::missing(&areas))
    }

    fn setup(&self) -> Result<Setup<'_>, Failure> {
        let (drive, part, axis) = self.set()?;
        Setup::new(&self.settings, drive, part, axis)
    }

    /// A start must lie within the limits of the drive.
    fn checked(&self, from: [f64; 2]) -> Result<[f64; 2], Failure> {
        let (drive, ..) = self.set()?;
        let limits = if drive.is_curve() { vec![drive.u] } else { vec![drive.u, drive.v] };
        for (k, [a, b]) in limits.into_iter().enumerate() {
            if from[k] < a - 1e-9 || from[k] > b + 1e-9 {
                let what = if k == 0 { "the start's u" } else { "the start's v" };
                let need = format!("between the limits {a} and {b} of DS").into();
                return Err(Failure::Value { what, value: from[k], need });
            }
        }
        Ok(if drive.is_curve() { [from[0], 0.0] } else { from })
    }

    /// The position, led away from the surface where that is asked for. CHKSRF holds where it is put out.
    fn point(
        &self,
        from: [f64; 2],
        w: &mut Words<'_>,
        guard: Option<Guard>,
    ) -> Result<Done, Failure> {
        let mut setup = self.setup()?;
        let from = self.checked(from)?;
        let (p, _) = setup.settled(from, Course::U, 1.0, None, Take::Band)?;
        w.take("INCR");
        let away = if let Some(back) = w.number() {
            let d = setup.drive.place(from, Course::U).direction.unwrap_or_else(Vec3::zeros);
            Some(Retract::By(-d * back))
        } else if let Some(v) = w.vector() {
            Some(Retract::By(v))
        } else {
            match w.form().map(|(_, f)| f.shape().clone()) {
                Some(Form::Plane(plane)) => Some(Retract::Plane(plane)),
                _ => None,
            }
        };
        let led = |p: &Position| away.map_or((p.te, p.ta), |r| r.above((p.te, p.ta)));
        let guard = guard.map(|mut g| {
            if g.asks() {
                g.come_from(setup.profile, led(&p));
            }
            g
        });
        setup.guard = guard.as_ref().map(|g| (g, self.avoid));
        let Path { points, notes, avoided, .. } = setup.alone(p, (Course::U, 1.0), away)?;
        let along = |p: &Position| Along { at: led(p), uv: p.drive_uv };
        let moved = points.iter().any(|p| led(p).0 != p.te);
        let put = Put::path(points.iter().map(along).collect(), avoided);
        let (puts, odd) = (vec![put], Odd::of(&points));
        Ok(Done { puts, notes, odd, away: moved, ..Done::default() })
    }

    fn course(&self, w: &mut Words<'_>) -> Result<(Course, f64), Failure> {
        let (drive, ..) = self.set()?;
        let across = w.take("CRSSPL");
        w.take("TANSPL");
        let course = if across && !drive.is_curve() { Course::V } else { Course::U };
        Ok((course, w.sign()))
    }

    fn line(
        &self,
        from: [f64; 2],
        w: &mut Words<'_>,
        guard: Option<Guard>,
    ) -> Result<Done, Failure> {
        let mut setup = self.setup()?;
        let from = self.checked(from)?;
        let (course, sense) = self.course(w)?;
        let guard = guard.map(|g| setup.coming(g, self.avoid, from, (course, sense)));
        setup.guard = guard.as_ref().map(|g| (g, self.avoid));
        let skip = w.number().is_some_and(|s| s > 0.0);
        let to = setup.drive.limits(course)[usize::from(sense > 0.0)];
        let outward = is_at(from, course, to).then_some((from, sense));
        let (Path { points, notes, avoided, .. }, broken) = match setup.run(from, to, course, sense)
        {
            Ok(path) => (path, None),
            Err(broken) => {
                let Broken { done, why } = *broken;
                (done, Some(why))
            }
        };
        let moves = Along::each(&points, skip);
        let first = points.first().map(|p| (p.te, p.ta));
        let (puts, odd) = (vec![Put::path(moves, avoided)], Odd::of(&points));
        Ok(Done { puts, notes, odd, first, why: broken, joined: skip, outward, ..Done::default() })
    }

    fn area(
        &self,
        pick: bool,
        from: [f64; 2],
        w: &mut Words<'_>,
        guard: Option<Guard>,
        crew: &dyn Crew,
    ) -> Result<Done, Failure> {
        let mut setup = self.setup()?;
        let from = self.checked(from)?;
        let (course, along) = self.course(w)?;
        w.take("STEPOV");
        let over = w.sign();
        setup.over = over;
        let guard = guard.map(|g| setup.coming(g, self.avoid, from, (course, along)));
        setup.guard = guard.as_ref().map(|g| (g, self.avoid));
        let skip = w.number().is_some_and(|s| s > 0.0);
        let a = &self.areas;
        let (Some(feeds), Some(stepover)) = (a.feeds, a.stepover) else {
            let areas = [("FEED", a.feeds.is_none()), ("STEPOV", a.stepover.is_none())];
            return Err(Areas::missing(&areas));
        };
        let stepover = stepover.of(setup.profile);
        let clearance = if pick {
            let plane = a.clearance.ok_or(Failure::NotSet { areas: vec!["FEED,plane"] })?;
            Some(Retract::Plane(plane))
        } else {
            None
        };
        if setup.drive.is_curve() {
            return Err(Failure::Undone { what: "a region along a curve" });
        }
        let senses = [along, over];
        let to = setup.drive.limits(course)[usize::from(along > 0.0)];
        let outward = is_at(from, course, to).then_some((from, along));
        let wide = setup.drive.limits(course.across());
        let steps = stepover.paths != Some(1) && !is_at([wide[0]; 2], course, wide[1]);
        let aside = is_at(from, course.across(), wide[usize::from(over > 0.0)]) && steps;
        let sideways = aside.then_some((from, over));
        let same = setup.same_surface();
        let ways = &self.ways();
        let region = Region { setup, stepover, feeds, clearance, ways, course, senses, skip };
        let done = region.mill(from, crew);
        let part = &region.setup.part;
        let extent = || {
            if !part.touches && (pick || stepover.lift > 0.0 || done.avoided) {
                // What lies between is then judged in pieces.
                Extent::Unknown("the tool end is led on its part surface, and away from it")
            } else if same {
                along_lines(&done.touched, &part.surface)
            } else {
                led(&done.touched, &part.surface)
            }
        };
        // What the cutter does not come to lies between too.
        let over = !same && part.touches && region.setup.drive.hold == Hold::On;
        let scallop = done.scallop(stepover.scallop, extent, over);
        let crate::region::Done { puts, notes, odd, first, why, stands, .. } = done;
        let (joined, picks) = (skip, pick);
        let away = false;
        Ok(Done {
            puts,
            notes,
            odd,
            first,
            picks,
            why,
            scallop,
            stands,
            joined,
            away,
            outward,
            sideways,
        })
    }

    /// The first point of the statement is left out, as the tool is to stand there. Where it does not, and the
    /// straight way to the second goes through a surface, it is put out: over the clearance plane, if
    /// there is one for these passes.
    fn join(&mut self, origin: &Origin, done: &mut Done) -> Result<(), Failure> {
        let second = done.puts.iter().find_map(|p| match p {
            Put::Move(points) => points.first().copied(),
            Put::Path(points) | Put::Lifted(points) | Put::Risen(points) => {
                points.first().map(|p| p.at)
            }
            Put::Feed(_) => None,
        });
        let (Some(stand), Some(first), Some(second)) = (self.stand, done.first, second) else {
            return Ok(());
        };
        let Some(profile) = self.settings.profile.as_ref() else { return Ok(()) };
        let Band { intol, outtol } = self.settings.band();
        if (stand.te - first.0).norm() <= 2.0 * (intol + outtol) {
            return Ok(());
        }
        let ways = self.ways();
        let here = (stand.te, stand.ta);
        let Err(gouge) = ways.way(profile, [here, second]) else {
            self.diagnostics.push(left_out(origin, first.0, here.0));
            return Ok(());
        };
        let plane = self.areas.clearance.filter(|_| done.picks);
        let way = match &plane {
            Some(plane) => Retract::Plane(*plane).over(here, first).to_vec(),
            None => vec![first],
        };
        let mut steps = std::iter::once(here).chain(way.iter().copied()).zip(&way);
        let blocked = steps.any(|(a, b)| ways.way(profile, [a, *b]).is_err());
        if blocked {
            let gouge = ways.deepest(profile, [here, second], gouge);
            let (te, ta) = second;
            return Err(Failure::Skipped(Box::new(Deep {
                gouge,
                te,
                ta,
                avoids: Avoid::default(),
            })));
        }
        self.diagnostics.push(put_out(origin, first.0));
        done.puts.insert(0, Put::Move(way));
        done.joined = false;
        Ok(())
    }

    /// What ways beside the passes are held against: the part surface, and what CHKSRF names.
    fn ways(&self) -> Guard {
        self.ways_of(self.areas.part.as_ref())
    }

    /// The same beside passes on another part surface.
    pub(crate) fn ways_of(&self, part: Option<&PartArea>) -> Guard {
        let mut guard = self.guarded(part).unwrap_or_default();
        guard.intol = self.touching();
        let Some(part) = part.filter(|p| p.touches) else { return guard };
        guard.thick = part.thick;
        let (surface, tree) = part.whole.clone();
        if !guard.surfaces.iter().any(|c| Arc::ptr_eq(&c.surface, &surface)) {
            guard.surfaces.push(Checked::part(part.name.name.to_string(), surface, tree));
        }
        guard
    }

    /// Places of the cutter that touch and do not cut well, and how far it got out of the way without a limit, are told once a
    /// statement.
    ///
    /// APT: the warnings of `TULPOS`, whose last took a ball for the cutter: [`Failure::Sphere`].
    pub(crate) fn odd(&mut self, origin: &Origin, odd: Odd) {
        let said = [(odd.tip, "its tip"), (odd.rim, "the rim of its top")];
        for (at, place) in said {
            if let Some(at) = at {
                self.diagnostics.push(touches_with(origin, place, at));
            }
        }
        /// Lengths of the cutter by which a lift that nothing limits is told.
        const FAR: f64 = 3.0;
        let reach = self.settings.profile.as_ref().map_or(f64::INFINITY, Profile::reach);
        let far = odd.high.filter(|(by, _)| self.avoid.limit.is_none() && *by > FAR * reach);
        self.diagnostics.extend(far.map(|(by, at)| lifted_far(origin, by, at)));
    }

    /// What the statement keeps to.
    fn control(&self, done: &Done) -> Option<Arc<cl::Control>> {
        let part = self.areas.part.as_ref()?;
        let mut control = self.milling_control(part, done.scallop.clone(), done.joined);
        if let Some(c) = Arc::get_mut(&mut control).and_then(|c| c.milling.as_mut())
            && !part.touches
            && done.away
        {
            c.part = None;
        }
        Some(control)
    }

    /// What motions along a part surface keep to.
    pub(crate) fn milling_control(
        &self,
        part: &PartArea,
        scallop: Option<Scallop>,
        joined: bool,
    ) -> Arc<cl::Control> {
        let name = |n: &NameRef| cl::NameRef { name: n.name.clone(), subscript: n.subscript };
        let own = Milled {
            name: name(&part.name),
            surface: Arc::clone(&part.surface),
            side: part.side,
            thick: part.thick,
            body: None,
        };
        let others = self.checked.iter().filter(|c| !Arc::ptr_eq(&c.surface, &part.whole.0));
        let checked = others.map(|c| Milled {
            name: cl::NameRef { name: c.name.as_str().into(), subscript: 0 },
            surface: Arc::clone(&c.surface),
            side: 1.0,
            thick: self.settings.thick_check,
            body: c.body.clone(),
        });
        let plain = self.plain.iter().map(|p| Plain {
            name: cl::NameRef { name: p.name.as_str().into(), subscript: 0 },
            form: Arc::clone(&p.form),
            thick: self.settings.thick_check,
        });
        let holder = self.holder.iter().map(|&(profile, up)| Raised { profile, up });
        let band = self.settings.band();
        let milling = Milling {
            part: Some(own),
            on: !part.touches,
            risen: false,
            checked: checked.collect(),
            plain: plain.collect(),
            holder: holder.collect(),
            guarded: self.check_part && part.touches,
            intol: band.intol,
            outtol: band.outtol,
            scallop,
            joined,
            over: false,
            limits: None,
        };
        Arc::new(cl::Control { milling: Some(milling), ..cl::Control::default() })
    }

    /// Positions as CL records, under the name of what guides them; where the tool stands then.
    pub(crate) fn put(
        &mut self,
        origin: &Origin,
        (name, guide): (&NameRef, Option<&Guide>),
        puts: Vec<Put>,
        control: Option<&Arc<cl::Control>>,
        out: &mut Vec<cl::Record>,
    ) -> Option<Stand> {
        let mut stand = None;
        let mut before: Option<Vec3> = None;
        let freed = control.and_then(freed);
        let mut control = control;
        let (mut first, mut risen) = (true, false);
        for put in puts {
            // A tool end that is led on its part surface is free where it is led away, and on it again behind. Where it
            // got out of the way it may stand above, and on what goes on from there.
            let held = match (&freed, &put) {
                (Some(freed), Put::Move(_) | Put::Lifted(_)) => {
                    (control, risen) = (Some(&freed.back), false);
                    Some(&freed.free)
                }
                (Some(freed), Put::Path(_) | Put::Risen(_)) => {
                    let up = matches!(put, Put::Risen(_));
                    let held = match (up || risen, first) {
                        (true, true) => Some(&freed.first),
                        (true, false) => Some(&freed.risen),
                        (false, _) => control,
                    };
                    if up || risen {
                        control = Some(&freed.back);
                    }
                    risen = up;
                    held
                }
                _ => control,
            };
            first &= matches!(put, Put::Feed(_));
            let (points, uvs) = match put {
                Put::Feed(f) if f != 0.0 => {
                    let kind =
                        cl::Kind::Post { word: "FEDRAT".into(), args: vec![cl::Arg::Number(f)] };
                    out.push(cl::Record { origin: origin.clone(), kind });
                    continue;
                }
                Put::Feed(_) => continue,
                Put::Move(points) => (points, Vec::new()),
                Put::Path(points) | Put::Lifted(points) | Put::Risen(points) => {
                    points.into_iter().map(|p| (p.at, p.uv)).unzip()
                }
            };
            for (te, ta) in &points {
                let along = before.map_or_else(Vec3::zeros, |b| te - b);
                stand = Some(Stand { te: *te, ta: *ta, along });
                before = Some(*te);
            }
            let index = out.len();
            self.motion(origin, name, points, held, out);
            if out.len() > index
                && let Some(guide) = guide
            {
                self.guided(index, guide, uvs);
            }
        }
        stand
    }

    fn motion(
        &self,
        origin: &Origin,
        name: &NameRef,
        points: Vec<(Vec3, Vec3)>,
        control: Option<&Arc<cl::Control>>,
        out: &mut Vec<cl::Record>,
    ) {
        if points.is_empty() || self.settings.cut == Some(false) {
            return;
        }
        let motion = cl::Motion {
            kind: cl::MotionKind::Continuous,
            name: cl::NameRef { name: name.name.clone(), subscript: name.subscript },
            arc: None,
            points: points.into_iter().map(|(te, ta)| cl::Position { te, ta }).collect(),
            with_axis: self.settings.multax,
            control: control.map(Arc::clone),
        };
        out.push(cl::Record { origin: origin.clone(), kind: cl::Kind::Motion(motion) });
    }
}

/// What a tool keeps to whose end is led on a part surface.
struct Freed {
    /// Where it is led away.
    free: Arc<cl::Control>,
    /// Behind that, on the surface again.
    back: Arc<cl::Control>,
    /// Where it got out of the way, on the first path and on others.
    first: Arc<cl::Control>,
    risen: Arc<cl::Control>,
}

/// Does a start stand where its passes would end?
fn is_at(from: [f64; 2], course: Course, to: f64) -> bool {
    let start = match course {
        Course::U => from[0],
        Course::V => from[1],
    };
    (to - start).abs() <= 1e-9
}

/// `None` where the tool end is not led so.
fn freed(control: &Arc<cl::Control>) -> Option<Freed> {
    let milling = control.milling.as_ref().filter(|m| m.on && m.part.is_some())?;
    let back = Milling { scallop: None, joined: true, limits: None, ..milling.clone() };
    let free = Milling { part: None, ..back.clone() };
    let risen = Milling { risen: true, ..back.clone() };
    let first = Milling { risen: true, ..milling.clone() };
    let of = |milling| Arc::new(cl::Control { milling: Some(milling), ..cl::Control::default() });
    Some(Freed { free: of(free), back: of(back), first: of(first), risen: of(risen) })
}
