//! TLPROJ: motions whose tool ends guide the tool over the part surface.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_geometry::Vec3;
use aptc_geometry::sculpt::{CubicArc, SpaceCurve};
use aptc_geometry::surface::ParametricSurface;
use aptc_protap::{Arg, NameRef};

use crate::area::{AxisArea, DriveArea, Guide, Hold, Projection};
use crate::avoid::Avoid;
use crate::drive::Course;
use crate::failure::{Deep, Failure};
use crate::path::{Broken, Path};
use crate::position::Position;
use crate::regional::{Failed, Regional, Stand};
use crate::report::reports;
use crate::scon::Words;
use crate::solve::{Setup, Take};

/// Cosine of the angle by which the axis of a motion may turn and still be one axis.
const ONE_AXIS: f64 = 1.0 - 1e-12;

/// What TLPROJ set.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Projecting {
    /// None: against the normal of the part surface.
    direction: Option<Vec3>,
    hold: Hold,
    /// Where the last motion ended, as it was programmed; none before the first.
    last: Option<Vec3>,
}

impl Regional {
    /// TLPROJ/V,ON|AT, TLPROJ/NORMAL,ON|AT and TLPROJ/OFF. NORMAL takes each place to the nearest one of the part
    /// surface. After the latter the tool stands where it was projected to.
    ///
    /// APT: `TLPROJ`; SSV3 has the statement, and no routine that carries it out. Its words are those of SCON/DS,
    /// and mean the same here.
    pub(crate) fn tlproj(&mut self, args: &[Arg]) -> Result<Option<Stand>, Failure> {
        let mut w = Words(args);
        if w.take("OFF") {
            let projected = self.projecting.take().and_then(|p| p.last).is_some();
            return Ok(self.stand.filter(|_| projected));
        }
        let direction = if w.take("NORMAL") {
            None
        } else {
            let direction = w.vector().and_then(|v| v.try_normalize(0.0));
            Some(direction.ok_or(Failure::NoDirection { what: "the direction of TLPROJ" })?)
        };
        let hold = if w.take("AT") { Hold::At } else { Hold::On };
        self.projecting = Some(Projecting { direction, hold, last: None });
        Ok(None)
    }

    /// Projects the motions of the arithmetic element from `records[from]` on, while TLPROJ holds: their tool ends
    /// are the drive curve of a path of regional milling on the part surface of SCON/PS. Comes back with where the
    /// tool stands then.
    ///
    /// # Errors
    /// A motion cannot be projected; see [`Regional::take_diagnostics`]. Where the tool stands is then unknown.
    pub fn project(
        &mut self,
        records: &mut Vec<cl::Record>,
        from: usize,
    ) -> Result<Option<Stand>, Failed> {
        // Each motion comes from the one before; as they are watched next, that begins before the first.
        let came = self.came;
        let done = self.project_all(records, from);
        self.came = came;
        done
    }

    fn project_all(
        &mut self,
        records: &mut Vec<cl::Record>,
        from: usize,
    ) -> Result<Option<Stand>, Failed> {
        let Some(mut projecting) = self.projecting else { return Ok(None) };
        if projecting.direction.is_none() && records.len() > from {
            self.prepare_feet();
        }
        let mut stand = None;
        for i in from..records.len() {
            let record = &mut records[i];
            let cl::Kind::Motion(motion) = &mut record.kind else { continue };
            if motion.kind == cl::MotionKind::From {
                self.put_out(motion);
                projecting.last = None;
                self.projecting = Some(projecting);
                continue;
            }
            let end = motion.points.last().map(|p| p.te);
            let (path, why) = self.projected(&projecting, motion);
            self.diagnostics.extend(reports(&record.origin, &path.notes));
            let points = path.points.as_slice();
            motion.points = points.iter().map(|p| cl::Position { te: p.te, ta: p.ta }).collect();
            motion.arc = None;
            motion.kind = cl::MotionKind::Continuous;
            if !self.is_recording() {
                self.put_out(motion);
            }
            let joined = projecting.last.is_some();
            let part = self.areas.part.as_ref();
            motion.control = part.map(|part| self.milling_control(part, None, joined));
            if let [.., last] = points {
                let before = points.iter().rev().nth(1).map(|p| p.te).or(self.stand.map(|s| s.te));
                let along = before.map_or_else(Vec3::zeros, |b| last.te - b);
                stand = Some(Stand { te: last.te, ta: last.ta, along });
                self.stand = stand;
            }
            if let Some(why) = why {
                let why = self.areas.once(why);
                self.diagnostics.extend(why.explain(&record.origin));
                records.truncate(if points.is_empty() { i } else { i + 1 });
                (self.stand, self.projecting) = (None, None);
                return Err(Failed);
            }
            projecting.last = end.or(projecting.last);
            self.projecting = Some(projecting);
        }
        Ok(stand)
    }

    /// Makes the part surface ready for the places nearest to points; once for each.
    fn prepare_feet(&mut self) {
        let Some(part) = &self.areas.part else { return };
        if !self.feet.iter().any(|(s, _)| Arc::ptr_eq(s, &part.surface))
            && let Some(prepared) = ParametricSurface::of_sculptured(&part.surface)
        {
            self.feet.push((Arc::clone(&part.surface), Arc::new(prepared)));
        }
    }

    /// The path over the part surface, and why it ends early.
    fn projected(&self, projecting: &Projecting, motion: &cl::Motion) -> (Path, Option<Failure>) {
        match self.over_part(projecting, motion) {
            Ok(path) => (path, None),
            Err(broken) => (broken.done, Some(broken.why)),
        }
    }

    fn over_part(&self, projecting: &Projecting, motion: &cl::Motion) -> Result<Path, Box<Broken>> {
        let failed = |why| Box::new(Broken { done: Path::default(), why });
        let Some(part) = &self.areas.part else {
            return Err(failed(Failure::NotSet { areas: vec!["PS"] }));
        };
        let [first, ..] = motion.points.as_slice() else { return Ok(Path::default()) };
        let turns = motion.points.iter().any(|p| p.ta.dot(&first.ta) < ONE_AXIS);
        if turns && self.areas.axis.is_none() {
            let what = "TLPROJ of a motion whose tool axis turns, without SCON/AXIS,";
            return Err(failed(Failure::Undone { what }));
        }
        let axis = self.areas.axis.unwrap_or(AxisArea::Fixed(first.ta));
        let projection = match projecting.direction {
            Some(direction) => Projection::Along(direction),
            None => {
                let known = self.feet.iter().find(|(s, _)| Arc::ptr_eq(s, &part.surface));
                let (_, surface) = known.ok_or_else(|| {
                    failed(Failure::NoDirection { what: "the normal of the part surface" })
                })?;
                Projection::Foot(Arc::clone(surface), part.side)
            }
        };
        let (curve, goes) = guide(projecting.last, &motion.points);
        let drive = DriveArea {
            name: NameRef::default(),
            u: [0.0, curve.span()],
            v: [0.0; 2],
            guide: Guide::Curve(Arc::new(curve)),
            hold: projecting.hold,
            projection,
            offset: 0.0,
        };
        let guard = self.guard();
        let mut setup = Setup::new(&self.settings, &drive, part, axis).map_err(failed)?;
        let guard = guard.map(|g| setup.coming(g, self.avoid, [0.0; 2], (Course::U, 1.0)));
        setup.guard = guard.as_ref().map(|g| (g, self.avoid));
        // Every motion begins where the one before ended.
        setup.joins = true;
        if !goes {
            let (p, _) =
                setup.settled([0.0; 2], Course::U, 1.0, None, Take::Middle).map_err(failed)?;
            self.comes(projecting, &p).map_err(failed)?;
            return Ok(Path { points: vec![p], ..Path::default() });
        }
        let joined = |mut path: Path| {
            if projecting.last.is_some() && !path.points.is_empty() {
                path.points.remove(0);
            }
            path
        };
        match setup.run([0.0; 2], drive.u[1], Course::U, 1.0) {
            Ok(path) => {
                if let Some(p) = path.points.first() {
                    self.comes(projecting, p).map_err(failed)?;
                }
                Ok(joined(path))
            }
            Err(broken) => {
                let Broken { done, why } = *broken;
                Err(Box::new(Broken { done: joined(done), why }))
            }
        }
    }

    /// The straight way to the first projected position keeps out of the surfaces.
    fn comes(&self, projecting: &Projecting, to: &Position) -> Result<(), Failure> {
        let (None, Some(stand), Some(profile)) =
            (projecting.last, self.stand, self.settings.profile.as_ref())
        else {
            return Ok(());
        };
        let ways = self.ways_of(self.areas.part.as_ref());
        let way = [(stand.te, stand.ta), (to.te, to.ta)];
        ways.way(profile, way).map_err(|gouge| {
            let gouge = ways.deepest(profile, way, gouge);
            Failure::Approach(Box::new(Deep {
                gouge,
                te: to.te,
                ta: to.ta,
                avoids: Avoid::default(),
            }))
        })
    }
}

/// The polygon through the places, and whether it goes anywhere: one place stands at its beginning.
fn guide(last: Option<Vec3>, points: &[cl::Position]) -> (SpaceCurve, bool) {
    let mut here = last;
    let mut arcs = Vec::with_capacity(points.len());
    for p in points {
        if let Some(from) = here
            && (p.te - from).norm() > 1e-12 * p.te.norm()
        {
            arcs.push(CubicArc::line(from, p.te));
        }
        here = Some(p.te);
    }
    if arcs.is_empty() {
        let at = here.unwrap_or_else(Vec3::zeros);
        return (SpaceCurve::new(vec![CubicArc::line(at, at + Vec3::x())]), false);
    }
    (SpaceCurve::new(arcs), true)
}
