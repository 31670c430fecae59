//! WCORN: the way through a corner, where the axis is the line in which both walls meet.

use aptc_cldata::{Arg, Kind, Position, Record};
use aptc_geometry::Vec3;

use super::path::Path;
use super::{Section, angle};

/// What a WCORN says.
pub(super) struct Wcorn {
    pub(super) alpha: f64,
    pub(super) beta: f64,
    height: f64,
    n: u32,
}

/// The way through a corner.
pub(super) struct Corner {
    /// Where it is along the path.
    pub(super) s: f64,
    before: f64,
    behind: f64,
    /// Ways of the steps, the corner itself among them.
    pub(super) steps: Vec<f64>,
    /// Axes and wall normals before and behind, and the axis in the corner.
    into: (Vec3, Vec3),
    out_of: (Vec3, Vec3),
    axis: Vec3,
    position: Position,
}

impl Corner {
    pub(super) fn new(
        section: &Section,
        path: &Path,
        s: f64,
        w: &Wcorn,
        least: f64,
    ) -> Option<Self> {
        let (te, arriving, leaving) = path.at(s);
        let into = section.axis(arriving, w.alpha);
        let out_of = section.axis(leaving, w.beta);
        let axis = into.1.cross(&out_of.1).try_normalize(1e-6)?;
        let axis = if axis.z < 0.0 { -axis } else { axis };
        (axis.z > 0.1).then_some(())?;
        let lean = |a: Vec3| {
            let c = a.dot(&axis).clamp(-1.0, 1.0);
            w.height * (1.0 - c * c).sqrt() / c.abs().max(0.1)
        };
        let before = lean(into.0).min(s);
        let behind = lean(out_of.0).min(path.length() - s);
        // The feet of both walls meet at `foot`; the axis is at the radius from both.
        let (p, q) = (section.to_wall(arriving), section.to_wall(leaving));
        let c = p.dot(&q);
        let foot = te + (p + q) * (section.radius / (1.0 + c).max(1e-6));
        let c = into.1.dot(&out_of.1);
        let on = foot + (into.1 + out_of.1) * (section.radius / (1.0 + c).max(1e-6));
        let position = Position { te: section.lowered(on, axis, te.z), ta: axis };
        let count = |length: f64| {
            let most = (length / least).floor().clamp(1.0, f64::from(w.n));
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
            let most = most as u32;
            most
        };
        let mut steps = Vec::new();
        let (n, m) = (count(before), count(behind));
        steps.extend((0..n).map(|k| s - before * f64::from(n - k) / f64::from(n)));
        steps.push(s);
        steps.extend((1..=m).map(|k| s + behind * f64::from(k) / f64::from(m)));
        steps.retain(|s| *s > 0.0);
        Some(Self { s, before, behind, steps, into, out_of, axis, position })
    }

    /// Is the way within the steps?
    pub(super) fn covers(&self, s: f64, slack: f64) -> bool {
        s >= self.s - self.before - slack && s <= self.s + self.behind + slack
    }

    /// The position at a way within the steps: the axis turns in the wall.
    pub(super) fn position(&self, section: &Section, path: &Path, s: f64) -> Option<Position> {
        let slack = 1e-9 * path.length();
        if !self.covers(s, slack) {
            return None;
        }
        if (s - self.s).abs() <= slack {
            return Some(self.position);
        }
        let ((start, normal), part) = if s < self.s {
            (self.into, 1.0 - (self.s - s) / self.before)
        } else {
            (self.out_of, 1.0 - (s - self.s) / self.behind)
        };
        let ta = (start + (self.axis - start) * part).try_normalize(0.0)?;
        let foot = section.upright_foot(path, s).point;
        let on = foot + normal * section.radius;
        Some(Position { te: section.lowered(on, ta, foot.z), ta })
    }
}

/// The WCORN of a record, if it is one.
pub(super) fn wcorn_of(record: &Record) -> Option<Wcorn> {
    let Kind::Post { word, args } = &record.kind else { return None };
    let [a, b, c, d, Arg::Number(height), rest @ ..] = args.as_slice() else { return None };
    let n = match rest {
        [] => 6.0,
        [Arg::Number(n)] => n.clamp(1.0, 1000.0),
        _ => return None,
    };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
    let n = n as u32;
    let (alpha, beta) = (angle(a, b)?, angle(c, d)?);
    (word == "WCORN" && *height > 0.0).then_some(Wcorn { alpha, beta, height: *height, n })
}
