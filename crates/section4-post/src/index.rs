//! Indexed work: ROTABL and ROTHED turn a table or head, and what follows is programmed beside it.
//!
//! After ROTABL positions are those of the linear axes as the programmer sees them at the turned table, with the
//! tool along Z, and after ROTHED the tool leans as the head does. Here they become positions and tool axes in
//! the frame of the part, so that everything after knows one kind of CL data only. A position that has the
//! turned tool axis itself stands in the frame of the part already.

use aptc_cldata::{Arc, Kind, Motion, Position, Record};
use aptc_diagnostics::codes;
use aptc_geometry::{Plane, Vec3};
use nalgebra::Matrix3;

use crate::args::Statement;
use crate::kinematics::Chain;
use crate::machine::{Carries, Machine};
use crate::post::{Post, trimmed};

/// Tool axes that differ by less are the same.
const SAME_AXIS: f64 = 1e-6;

/// Where the table and head stand, and what that makes of positions.
#[derive(Clone, Debug)]
pub(crate) struct Index {
    /// From positions beside the table to the frame of the part: a rotation, then a shift in millimetres.
    turn: Matrix3<f64>,
    shift_mm: Vec3,
    /// The tool axis in the frame of the part.
    pub(crate) axis: Vec3,
}

/// How a statement wants an axis turned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Wanted {
    /// The axis, 0 or 1.
    pub(crate) axis: usize,
    /// Its new angle, degrees.
    pub(crate) angle: f64,
    /// Anticlockwise, clockwise, or the shorter way.
    pub(crate) anticlockwise: Option<bool>,
}

impl Index {
    /// The table and head at these angles.
    pub(crate) fn new(machine: &Machine, angles: [f64; 2]) -> Self {
        let chain = Chain::new(machine, 1.0, 0.0);
        let (shift_mm, axis) = chain.programmed(Vec3::zeros(), angles);
        Self { turn: chain.table(angles).transpose(), shift_mm, axis }
    }

    /// A position in millimetres in the frame of the part; `None` for a tool axis that is neither along Z nor
    /// the turned one.
    pub(crate) fn position(&self, te: Vec3, ta: Vec3) -> Option<(Vec3, Vec3)> {
        if (ta - Vec3::z()).norm() < SAME_AXIS {
            return Some((self.turn * te + self.shift_mm, self.axis));
        }
        ((ta - self.axis).norm() < SAME_AXIS).then_some((te, ta))
    }

    /// A plane beside the table in the frame of the part.
    pub(crate) fn plane(&self, p: &Plane) -> Plane {
        let n = self.turn * p.n;
        Plane { n, d: p.d + n.dot(&self.shift_mm) }
    }

    /// The rotation from the frame of the part to that of the linear axes.
    pub(crate) fn tilt(&self) -> Matrix3<f64> {
        self.turn.transpose()
    }
}

/// What `ROTABL/[AXIS,n,]ATANGL|INCR,a[,CLW|CCLW]` asks of a machine whose axes stand at `now`; an error is the
/// reason to refuse it.
pub(crate) fn wanted(
    s: &Statement<'_>,
    machine: &Machine,
    now: [f64; 2],
) -> Result<Wanted, String> {
    let (carries, what) = match s.word {
        "ROTHED" => (Carries::Tool, "head"),
        _ => (Carries::Part, "table"),
    };
    let axes: Vec<usize> = (0..machine.rotary.len().min(2))
        .filter(|&i| machine.rotary[i].carries == carries)
        .collect();
    let known = ["AXIS", "ATANGL", "INCR", "CLW", "CCLW"];
    let words = (0..s.args.len()).filter_map(|i| s.word(i));
    if let Some(other) = words.into_iter().find(|w| !known.contains(w)) {
        return Err(format!(
            "{other} is not known here, only ATANGL or INCR with AXIS, CLW and CCLW"
        ));
    }
    let axis = match (s.after(&["AXIS"]), axes.as_slice()) {
        (_, []) => return Err(format!("the machine has no rotary {what}")),
        (None, [one]) => *one,
        (None, _) => {
            let names = axes
                .iter()
                .zip(1..)
                .map(|(&i, n)| format!("AXIS,{n} for {}", machine.rotary[i].letter));
            return Err(format!("say which: {}", names.collect::<Vec<_>>().join(" or ")));
        }
        (Some(n), _) => {
            let nth = axes.iter().zip(1_u32..).find(|(_, i)| (f64::from(*i) - n).abs() < 1e-9);
            *nth.ok_or_else(|| format!("there is no rotary {what} {n}"))?.0
        }
    };
    let mut angle = match (s.after(&["ATANGL"]), s.after(&["INCR"])) {
        (Some(a), None) => a,
        (None, Some(i)) => now[axis] + i,
        _ => return Err("give the angle with ATANGL,a or INCR,a".into()),
    };
    if angle.is_nan() || angle.abs() >= 1e6 {
        return Err(format!("{angle} is no angle"));
    }
    let anticlockwise = match (s.has("CLW"), s.has("CCLW")) {
        (true, true) => return Err("it cannot turn both ways".into()),
        (true, false) => Some(false),
        (false, true) => Some(true),
        _ => None,
    };
    let r = &machine.rotary[axis];
    let endless = r.min.is_none() && r.max.is_none();
    if s.has("ATANGL") && endless {
        // Whole turns do not count: the nearest, or the next in the direction asked for.
        let turns = match anticlockwise {
            // Of two ways as long as each other the one towards zero.
            None => {
                let turns = (now[axis] - angle) / 360.0;
                turns.signum() * (turns.abs() - 0.5 - 1e-12).ceil()
            }
            Some(true) => ((now[axis] - angle) / 360.0 - 1e-9).ceil(),
            Some(false) => ((now[axis] - angle) / 360.0 + 1e-9).floor(),
        };
        angle += 360.0 * turns;
    }
    Ok(Wanted { axis, angle, anticlockwise })
}

impl Post {
    /// Turns the axis with the tool retracted; what follows is programmed there.
    pub(crate) fn index_to(&mut self, wanted: &Wanted, s: &Statement<'_>) {
        let machine = std::sync::Arc::clone(&self.machine);
        let r = &machine.rotary[wanted.axis];
        let over = r.min.is_some_and(|m| wanted.angle < m - 1e-9)
            || r.max.is_some_and(|m| wanted.angle > m + 1e-9);
        let fault = if over {
            let [low, high] =
                [r.min, r.max].map(|m| m.map_or_else(|| "any".into(), |m| trimmed(m, 4)));
            Some(format!(
                "{}: {} goes from {low} to {high} on {}",
                s.written(),
                r.letter,
                machine.name
            ))
        } else if self.st.cutcom.is_some() {
            Some(format!("{} while radius compensation is on", s.written()))
        } else if !self.st.away && machine.program.retract.is_empty() {
            Some(format!("{}: {} has no way to retract first", s.written(), machine.name))
        } else {
            None
        };
        if let Some(message) = fault {
            let help = "lay the part otherwise, or write CUTCOM/OFF and a retract before it";
            self.error(codes::INDEXED, s.origin, message, help);
            return;
        }
        self.start(s.origin);
        self.annotate(s.origin);
        self.leave_cycle();
        self.st.rapid = false;
        let mut angles = self.st.angles;
        angles[wanted.axis] = wanted.angle;
        if !self.st.away {
            self.retract_to_home(s.origin);
        }
        self.leave_plane();
        self.turn_axis(wanted, s);
        self.st.angles = angles;
        let upright = angles.iter().all(|a| (a / 360.0 - (a / 360.0).round()).abs() < 1e-12);
        self.st.index = (!upright).then(|| Box::new(Index::new(&machine, angles)));
        let tilted = self.st.index.as_ref().filter(|_| !machine.multiaxis.plane_on.is_empty());
        self.st.plane = tilted.map(|i| i.tilt());
        self.st.chain = None;
        self.st.placed = None;
        self.st.away = true;
        // Where the tool stands beside the turned part only the machine knows.
        self.st.pos = None;
        self.length_words();
    }

    fn turn_axis(&mut self, wanted: &Wanted, s: &Statement<'_>) {
        let machine = std::sync::Arc::clone(&self.machine);
        let (i, r) = (wanted.axis, &machine.rotary[wanted.axis]);
        let mut mask = [false; 5];
        mask[3 + i] = true;
        let mut joints = [0.0; 5];
        (joints[3], joints[4]) = (self.st.angles[0], self.st.angles[1]);
        let from = joints[3 + i];
        // A control that takes the shorter way is led the longer one by a stop in between.
        let shortest = r.wrap == crate::machine::Wrap::Modulo;
        let stop = (shortest && (wanted.angle - from).abs() >= 180.0 - 1e-9)
            .then_some(f64::midpoint(from, wanted.angle));
        self.blocks.line(&r.unclamp);
        for angle in stop.into_iter().chain([wanted.angle]) {
            joints[3 + i] = angle;
            let range = &mut self.st.reach[3 + i];
            *range = [range[0].min(angle), range[1].max(angle)];
            let done = self.blocks.straight(crate::emit::MotionCode::Rapid, &joints, mask, None);
            self.check(done, s.origin);
        }
        self.blocks.line(&r.clamp);
    }

    /// The control leaves the tilted plane before it moves in the frame of the machine.
    pub(crate) fn leave_plane(&mut self) {
        if !std::mem::take(&mut self.st.plane_on) {
            return;
        }
        let machine = std::sync::Arc::clone(&self.machine);
        let vars = self.common_vars();
        self.blocks.template(&machine.multiaxis.plane_off, &vars.list());
        self.blocks.tilted = false;
        self.forget_places();
    }

    /// The control enters the tilted plane before it goes to the part.
    pub(crate) fn enter_plane(&mut self) {
        let Some(plane) = self.st.plane.filter(|_| !self.st.plane_on) else { return };
        self.st.plane_on = true;
        let machine = std::sync::Arc::clone(&self.machine);
        // The frame of the plane in the frame of the part.
        let q = plane.transpose();
        let letter = machine.rotary.first().map_or(b'A', |r| r.letter as u8);
        let text = |degrees: f64| {
            let n = self.blocks.number(letter);
            n.text(n.round(degrees).unwrap_or(0))
        };
        let (e, x) =
            (crate::angles::euler_zxz(&q).map(text), crate::angles::euler_xyz(&q).map(text));
        let mut vars = vec![
            ("first", e[0].as_str()),
            ("second", &e[1]),
            ("third", &e[2]),
            ("x", &x[0]),
            ("y", &x[1]),
            ("z", &x[2]),
        ];
        let common = self.common_vars();
        vars.extend(common.list());
        self.blocks.template(&machine.multiaxis.plane_on, &vars);
        self.blocks.tilted = true;
        self.forget_places();
    }

    fn forget_places(&mut self) {
        for i in 0..3 {
            self.blocks.forget_axis(i);
        }
    }

    /// A record as the part sees it while the table or head is turned; no points where it cannot be.
    pub(crate) fn seen_from_part(&mut self, record: &Record) -> Option<Record> {
        let index = self.st.index.as_ref()?;
        let Kind::Motion(m) = &record.kind else { return None };
        let (scale, shift, unit) = (self.st.scale, self.st.shift, self.st.out_mm());
        let mm = |te: Vec3| (te * scale + shift) * unit;
        let back = |te: Vec3| (te / unit - shift) / scale;
        let seen = |p: &Position| {
            let (te, ta) = index.position(mm(p.te), p.ta)?;
            Some(Position { te: back(te), ta })
        };
        let points: Option<Vec<Position>> = m.points.iter().map(seen).collect();
        let beside = m.points.first().is_some_and(|p| (p.ta - Vec3::z()).norm() < SAME_AXIS);
        let arc = m.arc.as_ref().map(|a| {
            let mut circle = a.circle;
            if beside {
                circle.center = back(index.turn * mm(circle.center) + index.shift_mm);
                circle.axis = index.turn * circle.axis;
            }
            Arc { circle, ..*a }
        });
        if points.is_none() {
            let message =
                "a tool axis of its own while a table or head is turned by its word".to_string();
            let help = "write ROTABL/ATANGL,0 first, or leave the axis to ROTABL";
            self.error(codes::INDEXED, &record.origin, message, help);
        }
        let kind = Kind::Motion(Motion { points: points.unwrap_or_default(), arc, ..m.clone() });
        Some(Record { origin: record.origin.clone(), kind })
    }
}
