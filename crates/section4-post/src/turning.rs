//! Turning: from the plane in which a turned part is drawn to the X and Z of a lathe.
//!
//! What comes after sees CL data of the lathe's own frame, the tool in the plane Y = 0 and its axis along Z,
//! whatever frame the part program has: the rest of Section 4 needs to know no other lathe.

use aptc_cldata::{Arc, Arg, Kind, Motion, Position, Record};
use aptc_diagnostics::{Origin, codes};
use aptc_geometry::{Form, Plane, Vec3};

use crate::machine::{Machine, TurningPlane};
use crate::post::{Post, trimmed};

/// How far from the plane of turning a position may be, millimetres: more than an output rounds away would
/// be a different diameter.
pub(crate) const OFF_PLANE_MM: f64 = 0.01;

/// The record as the lathe sees it, when it says anything of places or directions. A tool axis that a lathe
/// cannot have is left as it is, and refused by [`Post::stays_in_plane`].
pub(crate) fn seen_by_lathe(machine: &Machine, record: &Record, drills: bool) -> Option<Record> {
    let plane = machine.turning.plane;
    let kind = match &record.kind {
        Kind::Motion(m) => Kind::Motion(motion(plane, m, drills, machine.is_milling())),
        Kind::Post { word, args } => {
            Kind::Post { word: word.clone(), args: turned(plane, word, args)? }
        }
        _ => return None,
    };
    Some(Record { origin: record.origin.clone(), kind })
}

fn motion(plane: TurningPlane, m: &Motion, drills: bool, mills: bool) -> Motion {
    let seen = |p: &Position| {
        let ta = frame(plane, p.ta);
        let ta = if !mills && possible(plane, ta, drills) { Vec3::z() } else { ta };
        Position { te: frame(plane, p.te), ta }
    };
    let arc = m.arc.as_ref().map(|a| {
        let mut circle = a.circle;
        circle.center = frame(plane, circle.center);
        circle.axis = frame(plane, circle.axis);
        Arc { circle, ..*a }
    });
    Motion { points: m.points.iter().map(seen).collect(), arc, ..m.clone() }
}

/// Can a lathe have this tool axis, in its own frame? Along the spindle, as drills stand; square to the plane of
/// turning, as systems give it for turning tools. Where the part is drawn in XY that is also what APT takes
/// without TLAXIS, so that drills may have it there.
fn possible(plane: TurningPlane, ta: Vec3, drills: bool) -> bool {
    let along = |c: f64| c.abs() > 1.0 - 1e-9;
    along(ta.z) || along(ta.y) && (!drills || plane == TurningPlane::Xy)
}

/// The arguments of a word that moves the part or gives a clearance plane; `None` where nothing turns.
fn turned(plane: TurningPlane, word: &str, args: &[Arg]) -> Option<Vec<Arg>> {
    if plane == TurningPlane::Zx {
        return None;
    }
    match (word, args) {
        ("TRANS" | "ORIGIN", [Arg::Number(x), rest @ ..]) => {
            let number = |i: usize| match rest.get(i) {
                Some(Arg::Number(n)) => *n,
                _ => 0.0,
            };
            let v = frame(plane, Vec3::new(*x, number(0), number(1)));
            Some(vec![Arg::Number(v.x), Arg::Number(v.y), Arg::Number(v.z)])
        }
        ("CLRSRF" | "CLEARP", [Arg::Form { name, form }]) => {
            let Form::Plane(p) = form.shape() else { return None };
            let form = Form::Plane(Plane { n: frame(plane, p.n), d: p.d });
            Some(vec![Arg::Form { name: name.clone(), form: form.into() }])
        }
        _ => None,
    }
}

/// A direction or point of the program in the frame of the lathe: X away from the spindle, Z along it.
fn frame(plane: TurningPlane, v: Vec3) -> Vec3 {
    match plane {
        TurningPlane::Zx => v,
        TurningPlane::Xy => Vec3::new(v.y, v.z, v.x),
    }
}

impl Post {
    /// Refuses a motion that leaves the plane of turning; the first place is told.
    pub(crate) fn stays_in_plane(&mut self, m: &Motion, origin: &Origin) -> bool {
        if let Some(p) = m.points.iter().find(|p| p.ta != Vec3::z()) {
            if !std::mem::replace(&mut self.off_plane_told, true) {
                let [x, y, z] = [p.ta.x, p.ta.y, p.ta.z].map(|c| trimmed(c, 6));
                let message = format!(
                    "tool axis {x},{y},{z} in the frame of {}, whose tools do not turn",
                    self.machine.name
                );
                let help = "drill along the spindle, or choose a machine with a rotary axis";
                self.error(codes::AXIS_OUT_OF_REACH, origin, message, help);
            }
            return false;
        }
        let aside = |p: &Position| self.st.point(p.te).y;
        let mm = self.st.out_mm();
        let Some(y) = m.points.iter().map(aside).find(|y| (y * mm).abs() > OFF_PLANE_MM) else {
            return true;
        };
        if std::mem::replace(&mut self.off_plane_told, true) {
            return false;
        }
        let plane = self.machine.turning.plane;
        let (drawn, across) = match plane {
            TurningPlane::Zx => ("XZ", 'Y'),
            TurningPlane::Xy => ("XY", 'Z'),
        };
        let message = format!(
            "{across} {} lies off the plane {drawn} in which {} turns",
            trimmed(y, 4),
            self.machine.name
        );
        let help = "draw the turned part in that plane, or choose another machine: `aptc machines`";
        self.error(codes::OFF_TURNING_PLANE, origin, message, help);
        false
    }

    /// A cut of a thread to `te`: the spindle and the axes go together.
    pub(crate) fn thread_to(&mut self, te: Vec3, lead: f64, origin: &Origin) {
        let s = self.st.spindle;
        let axial = self.st.pos.map_or(0.0, |p| (te.z - p.z).abs());
        let fault = if !s.on {
            Some(("a thread while the spindle does not turn", "write SPINDL/n before it"))
        } else if s.surface {
            Some((
                "a thread at constant surface speed",
                "write SPINDL/n,RPM before it: the speed must not change in a thread",
            ))
        } else if axial < self.blocks.number(b'Z').resolution() {
            Some((
                "THREAD is on, but this cut does not go along the spindle",
                "write RAPID before it, or THREAD/OFF after the last pass",
            ))
        } else {
            None
        };
        if let Some((message, help)) = fault {
            self.error(codes::THREAD, origin, message.to_owned(), help);
            return;
        }
        let joints = [te.x, te.y, te.z, 0.0, 0.0];
        self.reach(&joints, origin);
        let done = self.blocks.thread(&joints, lead);
        self.check(done, origin);
        let feed =
            crate::emit::FeedWord { mode: crate::emit::FeedMode::PerRevolution, value: lead };
        self.count_cut(te, axial, feed);
    }

    /// Revolutions a minute where the tool is; at constant surface speed they are known on a lathe only.
    pub(crate) fn revolutions_here(&self) -> Option<f64> {
        match self.st.pos {
            _ if !self.st.spindle.surface => Some(self.st.spindle.speed),
            Some(pos) if self.machine.kind == crate::MachineKind::Lathe => {
                Some(self.revolutions(pos.x))
            }
            _ => None,
        }
    }

    /// Revolutions a minute; at constant surface speed those at a radius in output units.
    pub(crate) fn revolutions(&self, radius: f64) -> f64 {
        let s = self.st.spindle;
        if !s.surface {
            return s.speed;
        }
        let circumference_mm = std::f64::consts::TAU * radius.abs() * self.st.out_mm();
        let mm = if self.st.inch { 12.0 * 25.4 } else { 1000.0 };
        let most = self.st.max_rpm.unwrap_or(self.machine.spindle.max);
        let speed = s.speed * mm / circumference_mm.max(1e-9);
        if most > 0.0 { speed.min(most) } else { speed.min(MOST_RPM) }
    }
}

/// Taken for the time where the machine file has no greatest speed.
const MOST_RPM: f64 = 10_000.0;

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_cldata::{Course, MotionKind};
    use aptc_geometry::Circle;

    #[test]
    fn a_part_drawn_in_xy_is_turned_by_a_rotation_not_a_mirror() {
        let circle = Circle { center: Vec3::new(10.0, 5.0, 0.0), axis: Vec3::z(), radius: 2.0 };
        let arc = Some(Arc { circle, course: Course::Sweep(90.0) });
        let points = vec![Position { te: Vec3::new(12.0, 5.0, 0.0), ta: Vec3::z() }];
        let motion = Motion { kind: MotionKind::Goto, points, arc, ..Motion::default() };
        let record = Record { origin: Origin::default(), kind: Kind::Motion(motion) };
        let lathe = crate::machine("linuxcnc-lathe-xy").unwrap();
        let seen = seen_by_lathe(lathe, &record, false).unwrap();
        let Kind::Motion(m) = seen.kind else { panic!("a motion") };
        assert_eq!(m.points[0].te, Vec3::new(5.0, 0.0, 12.0));
        assert_eq!(m.points[0].ta, Vec3::z());
        let circle = m.arc.unwrap().circle;
        // Turning from Z to X: the axis is +Y.
        assert_eq!((circle.center, circle.axis), (Vec3::new(5.0, 0.0, 10.0), Vec3::y()));
    }
}
