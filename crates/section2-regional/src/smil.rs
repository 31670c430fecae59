//! SMIL: a point, a line or the region.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_cldata::milling::{Milled, Milling, Scallop};
use aptc_diagnostics::Origin;
use aptc_geometry::{Form, Vec3};
use aptc_protap::{Arg, NameRef};

use crate::area::{AxisArea, DriveArea, Guide, Hold, PartArea};
use crate::drive::Course;
use crate::failure::Failure;
use crate::guard::Guard;
use crate::path::{Broken, Setup};
use crate::region::{Put, Region};
use crate::regional::{Regional, Stand};
use crate::scon::Words;

/// What a statement gives.
struct Done {
    puts: Vec<Put>,
    /// Why it ended early.
    why: Option<Failure>,
    /// What is left between its passes.
    scallop: Option<Scallop>,
    /// Is its first point not put out, as the tool stands there?
    joined: bool,
    /// Was the tool end led away from where it stands on the surface?
    away: bool,
}

impl Regional {
    /// Mills; the positions go to `out`.
    ///
    /// APT: `SMIL`.
    pub(crate) fn smil(
        &mut self,
        origin: &Origin,
        args: &[Arg],
        out: &mut Vec<cl::Record>,
    ) -> Result<Option<Stand>, Failure> {
        let mut w = Words(args);
        let word = w.word().unwrap_or("");
        w.take("DS");
        w.take("PARAM");
        let from = [w.number().unwrap_or(0.0), w.number().unwrap_or(0.0)];
        let guard = self.guard();
        let done = match word {
            "POSN" => {
                let (puts, away) = self.point(from, &mut w)?;
                Done { puts, why: None, scallop: None, joined: false, away }
            }
            "PATH" => self.line(from, &mut w, guard.as_ref())?,
            "ZIGZAG" | "PICKFD" => self.area(word == "PICKFD", from, &mut w, guard.as_ref())?,
            _ => return Err(Failure::Undone { what: "this form of SMIL" }),
        };
        let control = self.control(&done);
        let stand = self.put(origin, done.puts, control.as_ref(), out);
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
        Err(Failure::NotSet { areas: missing(&areas) })
    }

    fn setup(&self) -> Result<Setup<'_>, Failure> {
        let (drive, part, axis) = self.set()?;
        let profile = self.settings.profile.as_ref().ok_or(Failure::NoCutter)?;
        Ok(Setup {
            drive,
            part,
            axis,
            profile,
            band: self.settings.band(),
            lateral: self.settings.lateral(),
            maxdp: self.settings.maxdp(),
            numpts: self.settings.numpts(),
            length: self.settings.length(),
            lift: 0.0,
            fixed: None,
            guard: None,
            over: 1.0,
        })
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

    /// The position, and whether it is led away from the surface.
    fn point(&self, from: [f64; 2], w: &mut Words<'_>) -> Result<(Vec<Put>, bool), Failure> {
        let setup = self.setup()?;
        let from = self.checked(from)?;
        let (p, _) = setup.position(from, Course::U, 1.0, None, false)?;
        w.take("INCR");
        let te = if let Some(back) = w.number() {
            let d = setup.drive.place(from, Course::U).direction.unwrap_or_else(Vec3::zeros);
            p.te - d * back
        } else if let Some(v) = w.vector() {
            p.te + v
        } else {
            match w.form().map(|(_, f)| f.shape().clone()) {
                Some(Form::Plane(plane)) => p.te - plane.n * plane.distance(p.te),
                _ => p.te,
            }
        };
        Ok((vec![Put::Move(vec![(te, p.ta)])], te != p.te))
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
        guard: Option<&Guard>,
    ) -> Result<Done, Failure> {
        let mut setup = self.setup()?;
        setup.guard = guard.map(|g| (g, self.avoid));
        let from = self.checked(from)?;
        let (course, sense) = self.course(w)?;
        let skip = w.number().is_some_and(|s| s > 0.0);
        let to = setup.drive.limits(course)[usize::from(sense > 0.0)];
        let (points, broken) = match setup.run(from, to, course, sense, None) {
            Ok(points) => (points, None),
            Err(broken) => {
                let Broken { done, why } = *broken;
                (done, Some(why))
            }
        };
        let moves = points.iter().skip(usize::from(skip)).map(|p| (p.te, p.ta)).collect();
        let puts = vec![Put::Move(moves)];
        Ok(Done { puts, why: broken, scallop: None, joined: skip, away: false })
    }

    fn area(
        &self,
        pick: bool,
        from: [f64; 2],
        w: &mut Words<'_>,
        guard: Option<&Guard>,
    ) -> Result<Done, Failure> {
        let mut setup = self.setup()?;
        setup.guard = guard.map(|g| (g, self.avoid));
        let from = self.checked(from)?;
        let (course, along) = self.course(w)?;
        w.take("STEPOV");
        let over = w.sign();
        setup.over = over;
        let skip = w.number().is_some_and(|s| s > 0.0);
        let a = &self.areas;
        let (Some(feeds), Some(stepover)) = (a.feeds, a.stepover) else {
            let areas = [("FEED", a.feeds.is_none()), ("STEPOV", a.stepover.is_none())];
            return Err(Failure::NotSet { areas: missing(&areas) });
        };
        let clearance = if pick {
            Some(a.clearance.ok_or(Failure::NotSet { areas: vec!["FEED,plane"] })?)
        } else {
            None
        };
        if setup.drive.is_curve() {
            return Err(Failure::Undone { what: "a region along a curve" });
        }
        let senses = [along, over];
        let same =
            matches!(&setup.drive.guide, Guide::Surface(s) if Arc::ptr_eq(s, &setup.part.surface));
        let along = same && setup.drive.hold == Hold::At && setup.drive.offset == 0.0;
        let known = along && setup.part.touches && (guard.is_none() || !self.avoid.on);
        let done = Region { setup, stepover, feeds, clearance, course, senses, skip }.mill(from);
        let range = known.then_some(done.range);
        let height = stepover.scallop;
        let scallop = (height > 0.0 && done.why.is_none()).then_some(Scallop { height, range });
        Ok(Done { puts: done.puts, why: done.why, scallop, joined: skip, away: false })
    }

    /// What the statement keeps to.
    fn control(&self, done: &Done) -> Option<Arc<cl::Control>> {
        let part = self.areas.part.as_ref()?;
        let name = |n: &NameRef| cl::NameRef { name: n.name.clone(), subscript: n.subscript };
        let own = Milled {
            name: name(&part.name),
            surface: Arc::clone(&part.surface),
            side: part.side,
            thick: part.thick,
        };
        let others = self.checked.iter().filter(|c| !Arc::ptr_eq(&c.surface, &part.surface));
        let checked = others.map(|c| Milled {
            name: cl::NameRef { name: c.name.as_str().into(), subscript: 0 },
            surface: Arc::clone(&c.surface),
            side: 1.0,
            thick: 0.0,
        });
        let band = self.settings.band();
        let milling = Milling {
            part: (part.touches || !done.away).then_some(own),
            on: !part.touches,
            checked: checked.collect(),
            intol: band.intol,
            outtol: band.outtol,
            scallop: done.scallop,
            joined: done.joined,
        };
        Some(Arc::new(cl::Control { milling: Some(milling), ..cl::Control::default() }))
    }

    /// Positions as CL records; where the tool stands then.
    fn put(
        &self,
        origin: &Origin,
        puts: Vec<Put>,
        control: Option<&Arc<cl::Control>>,
        out: &mut Vec<cl::Record>,
    ) -> Option<Stand> {
        let mut stand = None;
        let mut before: Option<Vec3> = None;
        for put in puts {
            match put {
                Put::Feed(f) if f != 0.0 => {
                    let kind =
                        cl::Kind::Post { word: "FEDRAT".into(), args: vec![cl::Arg::Number(f)] };
                    out.push(cl::Record { origin: origin.clone(), kind });
                }
                Put::Feed(_) => {}
                Put::Move(points) => {
                    for (te, ta) in &points {
                        let along = before.map_or_else(Vec3::zeros, |b| te - b);
                        stand = Some(Stand { te: *te, ta: *ta, along });
                        before = Some(*te);
                    }
                    self.motion(origin, points, control, out);
                }
            }
        }
        stand
    }

    fn motion(
        &self,
        origin: &Origin,
        points: Vec<(Vec3, Vec3)>,
        control: Option<&Arc<cl::Control>>,
        out: &mut Vec<cl::Record>,
    ) {
        if points.is_empty() || self.settings.cut == Some(false) {
            return;
        }
        let drive = self.areas.drive.as_ref();
        let name =
            drive.map(|d| cl::NameRef { name: d.name.name.clone(), subscript: d.name.subscript });
        let motion = cl::Motion {
            kind: cl::MotionKind::Continuous,
            name: name.unwrap_or_default(),
            arc: None,
            points: points.into_iter().map(|(te, ta)| cl::Position { te, ta }).collect(),
            with_axis: self.settings.multax,
            control: control.map(Arc::clone),
        };
        out.push(cl::Record { origin: origin.clone(), kind: cl::Kind::Motion(motion) });
    }
}

fn missing(areas: &[(&'static str, bool)]) -> Vec<&'static str> {
    areas.iter().filter(|a| a.1).map(|a| a.0).collect()
}
