//! VTLAXS and WCORN: a level path with an upright tool made into one that swarf-cuts a twisted wall.
//!
//! Between `VTLAXS/ON,side,alpha,d,r,side[,ZSMALL]` and `VTLAXS/OFF,side,beta` the tilt of the tool from
//! the vertical, to the right or left of the motion, goes from alpha to beta in proportion to the way.
//! The wall passes through the line that the upright tool touched at the part surface; the tilted tool
//! touches the wall along its side and the part surface with its lowest point, or, with ZSMALL, the foot
//! of the wall with the corner of its bottom. `WCORN/side,alpha,side,beta,h[,n]` after the motion into a
//! corner gives the tilts before and behind it: in the corner the axis is the line in which both walls
//! meet, and is reached and left in n steps (6) over the way by which the tool leans at the height h.

mod corner;
mod path;

use aptc_cldata::{Arg, Kind, Motion, Position, Record, Units};
use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_geometry::{Vec3, trig};

use corner::{Corner, wcorn_of};
use path::{Path, WITHOUT_MULTAX};

/// Records held between ON and OFF; what it trades is memory against paths longer than any wall.
const MOST_HELD: usize = 1_000_000;
/// Least step of WCORN in millimetres: .0005 inch.
const LEAST_STEP_MM: f64 = 0.0127;

/// Holds a path from VTLAXS/ON to OFF back.
#[derive(Default)]
pub(crate) struct Vtlaxs {
    section: Option<Section>,
    units: Units,
    /// The position put out last by a section, to join the next one.
    put: Option<Position>,
    list: Vec<Diagnostic>,
    /// Was MULTAX missed?
    multax_said: bool,
}

/// What becomes of a record.
pub(crate) enum Step {
    /// It goes on as it is.
    Pass,
    /// It is held back.
    Hold,
    /// These go on instead of what was held and of it.
    Release(Vec<Record>),
}

struct Section {
    /// Tilt at the start, degrees, positive to the right.
    alpha: f64,
    radius: f64,
    corner: f64,
    /// +1 when the drive surface is to the left of the motion.
    left: f64,
    zsmall: bool,
    start: Option<Position>,
    held: Vec<Record>,
}

impl Vtlaxs {
    pub(crate) fn take_diagnostics(&mut self) -> Vec<Diagnostic> {
        std::mem::take(&mut self.list)
    }

    /// Takes the next record; `last` is the position before it.
    pub(crate) fn push(&mut self, record: &Record, last: Option<Position>) -> Step {
        if let Kind::Units(u) = record.kind {
            self.units = u;
        }
        let args = match &record.kind {
            Kind::Post { word, args } if word == "VTLAXS" => Some(args.as_slice()),
            _ => None,
        };
        match (&mut self.section, args) {
            (None, None) => Step::Pass,
            (None, Some(args)) => match on(args, last) {
                Some(mut section) => {
                    section.held.push(record.clone());
                    self.section = Some(section);
                    Step::Hold
                }
                None => {
                    let help = "write VTLAXS/ON,LEFT,angle,diameter,corner radius,RIGHT";
                    self.say(&record.origin, "a VTLAXS that does not begin a path", help);
                    Step::Pass
                }
            },
            (Some(section), None) => {
                section.held.push(record.clone());
                if section.held.len() > MOST_HELD || matches!(record.kind, Kind::Fini) {
                    self.say(
                        &record.origin,
                        "VTLAXS/ON without OFF",
                        "end the path with VTLAXS/OFF",
                    );
                    return Step::Release(self.end());
                }
                Step::Hold
            }
            (Some(_), Some(args)) => {
                let Some(mut section) = self.section.take() else { return Step::Pass };
                section.held.push(record.clone());
                let Some(beta) = off(args) else {
                    let help = "write VTLAXS/OFF,LEFT,angle, the angle less than 80";
                    self.say(&record.origin, "a VTLAXS that does not end the path", help);
                    return Step::Release(section.held);
                };
                Step::Release(self.tilt(section, beta))
            }
        }
    }

    /// End of the stream: what is still held goes on as it was.
    pub(crate) fn end(&mut self) -> Vec<Record> {
        self.section.take().map_or_else(Vec::new, |s| s.held)
    }

    fn say(&mut self, origin: &Origin, what: &str, help: &str) {
        let d = Diagnostic::error(codes::VTLAXS_REFUSED, origin.span, what).help(help);
        self.list.push(d.within(origin.trace.clone()));
    }

    /// The tilted path.
    fn tilt(&mut self, section: Section, beta: f64) -> Vec<Record> {
        let on = section.held[0].origin.clone();
        let path = match Path::new(&section) {
            Ok(path) => path,
            Err((what, help)) => {
                // The one MULTAX that is missing is wanted by all paths that follow.
                if what != WITHOUT_MULTAX || !std::mem::replace(&mut self.multax_said, true) {
                    self.say(&on, what, help);
                }
                return section.held;
            }
        };
        let total = path.length();
        let corner = section.held.iter().position(|r| wcorn_of(r).is_some());
        let wcorn = corner.and_then(|i| wcorn_of(&section.held[i]));
        let least = LEAST_STEP_MM / self.units.mm();
        let bend = corner.map(|i| path.up_to_record(i));
        let corner = match (&wcorn, bend) {
            (Some(w), Some(s)) => match Corner::new(&section, &path, s, w, least) {
                Some(c) => Some(c),
                None => {
                    let what = "a WCORN where the walls do not meet at a corner";
                    self.say(&on, what, "put it behind the motion into the corner");
                    return section.held;
                }
            },
            _ => None,
        };
        let at = |s: f64| -> Position {
            if let Some(c) = &corner
                && let Some(p) = c.position(&section, &path, s)
            {
                return p;
            }
            let (from, to, part) = match (&corner, &wcorn) {
                (Some(c), Some(w)) if s < c.s => (section.alpha, w.alpha, s / c.s),
                (Some(c), Some(w)) => (w.beta, beta, (s - c.s) / (total - c.s)),
                _ => (section.alpha, beta, s / total),
            };
            section.upright_foot(&path, s).tilted(&section, from + (to - from) * part)
        };
        let mut out = Vec::new();
        let start = at(0.0);
        let joins = self.put.is_some_and(|p| near(p, start, total));
        for (i, mut record) in section.held.iter().cloned().enumerate() {
            if let Kind::Motion(m) = &mut record.kind {
                let stations = path.stations(i, corner.as_ref());
                m.points = stations.into_iter().map(at).collect();
                m.arc = None;
                m.control = None;
                self.put = m.points.last().copied();
            }
            out.push(record);
            if i == 0 && !joins && (start.ta - Vec3::z()).norm() > 1e-12 {
                let m = Motion { points: vec![start], with_axis: true, ..Motion::default() };
                out.push(Record { origin: on.clone(), kind: Kind::Motion(m) });
            }
        }
        out
    }
}

fn near(a: Position, b: Position, length: f64) -> bool {
    (a.te - b.te).norm() <= 1e-9 * length && (a.ta - b.ta).norm() <= 1e-9
}

/// Degrees to the right for a side and an angle.
fn angle(side: &Arg, angle: &Arg) -> Option<f64> {
    match (side, angle) {
        (Arg::Word(w), Arg::Number(a)) if w == "RIGHT" && a.abs() < 80.0 => Some(*a),
        (Arg::Word(w), Arg::Number(a)) if w == "LEFT" && a.abs() < 80.0 => Some(-*a),
        _ => None,
    }
}

fn on(args: &[Arg], start: Option<Position>) -> Option<Section> {
    let [Arg::Word(on), side, a, Arg::Number(d), Arg::Number(r), Arg::Word(ds), rest @ ..] = args
    else {
        return None;
    };
    let zsmall = match rest {
        [] => false,
        [Arg::Word(w)] => w == "ZSMALL" && r.abs() <= 0.0,
        _ => return None,
    };
    let left = match ds.as_str() {
        "RIGHT" => 1.0,
        "LEFT" => -1.0,
        _ => return None,
    };
    (on == "ON" && rest.is_empty() != zsmall && *d > 0.0).then_some(())?;
    let (alpha, radius) = (angle(side, a)?, d / 2.0);
    Some(Section { alpha, radius, corner: *r, left, zsmall, start, held: Vec::new() })
}

fn off(args: &[Arg]) -> Option<f64> {
    match args {
        [Arg::Word(w), side, a] if w == "OFF" => angle(side, a),
        _ => None,
    }
}

/// The point where the upright tool touches the foot of the wall, and the way of the motion there.
struct Foot {
    point: Vec3,
    ahead: Vec3,
}

impl Section {
    /// From the tool to the drive surface.
    fn to_wall(&self, ahead: Vec3) -> Vec3 {
        Vec3::z().cross(&ahead) * self.left
    }

    fn upright_foot(&self, path: &Path, s: f64) -> Foot {
        let (te, arriving, leaving) = path.at(s);
        let ahead = (arriving + leaving).try_normalize(1e-9).unwrap_or(arriving);
        Foot { point: te + self.to_wall(ahead) * self.radius, ahead }
    }

    /// Tool end of a tool with that axis whose axis line passes through `on`, the lowest point of the
    /// tool at the height `z`.
    fn lowered(&self, on: Vec3, axis: Vec3, z: f64) -> Vec3 {
        if self.zsmall {
            return on;
        }
        let r = self.corner.clamp(0.0, self.radius);
        let level = (1.0 - axis.z * axis.z).max(0.0).sqrt();
        let lowest = on.z + r * axis.z - (self.radius - r) * level - r;
        on + axis * ((z - lowest) / axis.z)
    }

    /// Axis tilted by degrees to the right of the motion, and the normal of the wall towards the tool.
    fn axis(&self, ahead: Vec3, tilt_deg: f64) -> (Vec3, Vec3) {
        let right = ahead.cross(&Vec3::z());
        let axis = Vec3::z() * trig::cos_deg(tilt_deg) + right * trig::sin_deg(tilt_deg);
        let out = -self.to_wall(ahead);
        let normal = out - axis * axis.dot(&out);
        (axis, normal.try_normalize(0.0).unwrap_or(out))
    }
}

impl Foot {
    fn tilted(&self, section: &Section, tilt_deg: f64) -> Position {
        let (ta, normal) = section.axis(self.ahead, tilt_deg);
        let on = self.point + normal * section.radius;
        Position { te: section.lowered(on, ta, self.point.z), ta }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn post(word: &str, args: Vec<Arg>) -> Record {
        Record { kind: Kind::Post { word: word.into(), args }, ..Record::default() }
    }

    fn word(w: &str) -> Arg {
        Arg::Word(w.into())
    }

    fn goto(points: &[[f64; 2]]) -> Record {
        let points = points.iter().map(|p| Position::upright(Vec3::new(p[0], p[1], 0.0))).collect();
        let m = Motion { points, with_axis: true, ..Motion::default() };
        Record { kind: Kind::Motion(m), ..Record::default() }
    }

    fn run(records: &[Record], start: [f64; 2]) -> (Vec<Position>, Vec<Diagnostic>) {
        let mut v = Vtlaxs::default();
        let last = Position::upright(Vec3::new(start[0], start[1], 0.0));
        let mut out = Vec::new();
        for r in records {
            if let Step::Release(list) = v.push(r, Some(last)) {
                for r in list {
                    if let Kind::Motion(m) = r.kind {
                        out.extend(m.points);
                    }
                }
            }
        }
        (out, v.take_diagnostics())
    }

    fn on(side: &str, alpha: f64, ds: &str, zsmall: bool) -> Record {
        let mut args =
            vec![word("ON"), word(side), Arg::Number(alpha), Arg::Number(2.0), Arg::Number(0.0)];
        args.push(word(ds));
        if zsmall {
            args.push(word("ZSMALL"));
        }
        post("VTLAXS", args)
    }

    fn off(side: &str, beta: f64) -> Record {
        post("VTLAXS", vec![word("OFF"), word(side), Arg::Number(beta)])
    }

    /// Distance of the tool's side from the foot of the wall, and its lowest point.
    fn contact(p: &Position, foot: Vec3) -> (f64, f64) {
        let arm = foot - p.te;
        let side = (arm - p.ta * p.ta.dot(&arm)).norm() - 1.0;
        (side, p.te.z - (1.0 - p.ta.z * p.ta.z).max(0.0).sqrt())
    }

    #[test]
    fn the_tilt_grows_with_the_way_and_the_tool_stays_at_the_foot() {
        // Along x, the wall at y = 1 to the left of the motion, the tool to its right.
        let path = goto(&[[1.0, 0.0], [2.0, 0.0], [4.0, 0.0]]);
        let program = [on("LEFT", 0.0, "RIGHT", false), path, off("LEFT", 20.0)];
        let (points, said) = run(&program, [0.0, 0.0]);
        assert!(said.is_empty(), "{said:?}");
        for (p, (x, tilt)) in points.iter().zip([(1.0, 5.0), (2.0, 10.0), (4.0, 20.0)]) {
            let want = Vec3::new(0.0, trig::sin_deg(tilt), trig::cos_deg(tilt));
            assert!((p.ta - want).norm() < 1e-12, "{p:?}");
            let (side, lowest) = contact(p, Vec3::new(x, 1.0, 0.0));
            assert!(side.abs() < 1e-12 && lowest.abs() < 1e-12, "{side} {lowest}");
        }
        assert_eq!(points.len(), 3);
    }

    #[test]
    fn leaning_away_the_tool_is_lifted_unless_zsmall() {
        for (zsmall, deepest) in [(false, 0.0), (true, -2.0 * trig::sin_deg(10.0))] {
            let program =
                [on("RIGHT", 10.0, "RIGHT", zsmall), goto(&[[3.0, 0.0]]), off("RIGHT", 10.0)];
            let (points, _) = run(&program, [0.0, 0.0]);
            // The tilted start is put out too.
            assert_eq!(points.len(), 2);
            for (p, x) in points.iter().zip([0.0, 3.0]) {
                let (side, lowest) = contact(p, Vec3::new(x, 1.0, 0.0));
                assert!(side.abs() < 1e-12, "{side}");
                assert!((lowest - deepest).abs() < 1e-12, "{lowest}");
            }
        }
    }

    #[test]
    fn a_corner_is_cleaned_along_the_line_where_the_walls_meet() {
        // East, then north; the tool to the left of the walls: an inside corner on the right hand.
        let wcorn = post(
            "WCORN",
            vec![
                word("RIGHT"),
                Arg::Number(10.0),
                word("RIGHT"),
                Arg::Number(10.0),
                Arg::Number(1.0),
            ],
        );
        let program = [
            on("RIGHT", 10.0, "RIGHT", false),
            goto(&[[5.0, 0.0]]),
            wcorn,
            goto(&[[5.0, -5.0]]),
            off("RIGHT", 10.0),
        ];
        let (points, said) = run(&program, [0.0, 0.0]);
        assert!(said.is_empty(), "{said:?}");
        // All positions touch the wall of the first or second motion and never dig into the other.
        let (sin, cos) = (trig::sin_deg(10.0), trig::cos_deg(10.0));
        let first = Vec3::new(0.0, -cos, -sin);
        let second = Vec3::new(-cos, 0.0, -sin);
        let mut both = 0;
        for p in &points {
            let a = (p.te - Vec3::new(0.0, 1.0, 0.0)).dot(&first) - 1.0;
            let b = (p.te - Vec3::new(6.0, 0.0, 0.0)).dot(&second) - 1.0;
            assert!(a.abs().min(b.abs()) < 1e-9 && a > -1e-9 && b > -1e-9, "{p:?} {a} {b}");
            both += usize::from(a.abs().max(b.abs()) < 1e-9);
        }
        assert!(points.len() > 10 && both == 1);
    }

    #[test]
    fn what_cannot_be_tilted_is_refused() {
        let mut high = goto(&[[1.0, 0.0]]);
        if let Kind::Motion(m) = &mut high.kind {
            m.points[0].te.z = 1.0;
        }
        for program in [
            vec![on("LEFT", 0.0, "RIGHT", false), high, off("LEFT", 5.0)],
            vec![on("LEFT", 85.0, "RIGHT", false)],
            vec![on("LEFT", 0.0, "RIGHT", false), off("LEFT", 5.0)],
        ] {
            assert_eq!(run(&program, [0.0, 0.0]).1.len(), 1);
        }
    }
}
