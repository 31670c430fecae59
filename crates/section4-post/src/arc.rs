//! Arcs: a run of chords that belongs to a circle becomes one G2 or G3.
//!
//! Everything is decided with the rounded end points, as the control will see them: the centre is chosen
//! after rounding, so that the radii at both ends agree and the arc stays in the band of the chords.

use aptc_cldata::{Arc, Course, Position};
use aptc_diagnostics::{Origin, codes};
use aptc_geometry::{Vec3, trig};

use crate::emit::{ArcBlock, MotionCode};
use crate::machine::{ArcCenter, ArcPlane, Arcs};
use crate::post::Post;

use std::f64::consts::{PI, TAU};

/// Longest arc of an R block, radians: well below half a turn, where the centre is ill-defined.
const MOST_FOR_RADIUS: f64 = 2.0;

/// An arc in the frame of its plane: angles in radians, lengths in output units.
#[derive(Clone, Copy, Debug)]
struct Turn {
    plane: ArcPlane,
    /// Centre in program coordinates (its component along the plane's normal does not count).
    center: Vec3,
    radius: f64,
    /// Angle of the start from the plane's first axis.
    start_angle: f64,
    /// Angle travelled, positive anticlockwise.
    sweep: f64,
    start: Vec3,
    end: Vec3,
}

impl Post {
    /// Writes the motion as arcs; `false` when it must be lines.
    pub(crate) fn arc(&mut self, arc: &Arc, points: &[Position], origin: &Origin) -> bool {
        if self.st.thread.is_some() {
            return false;
        }
        let Some(arcs) = self.machine.arcs.clone() else { return false };
        let Some(pos) = self.st.pos else { return false };
        if self.st.away || self.st.stands_still() {
            self.approach(pos, self.st.ta, false, origin);
        }
        let Some((turn, lead_in)) = self.turn(arc, points, &arcs) else { return false };
        if let Some(p) = lead_in.map(|i| points[i]) {
            self.go(&p, false, origin);
        }
        if self.blocks.with_motion.is_some() {
            let message = "radius compensation begins on an arc".to_string();
            let help = "let CUTCOM be followed by a straight motion";
            self.error(codes::COMPENSATION, origin, message, help);
        }
        let Some(pieces) = self.pieces(&turn, &arcs) else {
            // Only the points after the lead-in are still to go.
            let rest = lead_in.map_or(0, |i| i + 1);
            if matches!(arc.course, Course::Chords) {
                for p in &points[rest..] {
                    self.go(p, false, origin);
                }
                return true;
            }
            return false;
        };
        if !self.st.ready_said {
            self.ready(origin);
        }
        let n_pieces = pieces.len();
        let angles = self.st.angles;
        self.reach_of(&turn, origin);
        for (block, end) in pieces {
            let part = {
                #[expect(clippy::cast_precision_loss, reason = "a count of blocks")]
                let n = n_pieces as f64;
                turn.length() / n
            };
            let feed = if self.st.inverse {
                self.inverse_feed(part, origin)
            } else {
                self.feed_for(end, origin)
            };
            let Some(feed) = feed else { return true };
            let done = match block {
                Piece::Arc(block) => self.blocks.arc(&block, Some(feed)),
                Piece::Line => {
                    let joints = [end.x, end.y, end.z, angles[0], angles[1]];
                    self.blocks.straight(MotionCode::Line, &joints, crate::motion::ALL, Some(feed))
                }
            };
            self.check(done, origin);
            self.count_cut(end, part, feed);
        }
        if self.stock.is_some() {
            let mut from = self.st.pos;
            for p in points {
                let to = self.st.point(p.te);
                self.takes_away(from, to, p.ta, origin);
                from = Some(to);
            }
        }
        self.st.pos = points.last().map(|p| self.st.point(p.te));
        self.summary.arcs += 1;
        self.summary.chords_in_arcs += u64::try_from(points.len()).unwrap_or(0);
        true
    }

    /// The axes go along a turn: its ends and where it bulges farthest.
    fn reach_of(&mut self, turn: &Turn, origin: &Origin) {
        let angles = self.st.angles;
        // A turn of more than four quarters goes through the same extremes again.
        for angle in turn.stops(PI / 2.0, true).unwrap_or_default().into_iter().take(5) {
            self.reach_on(turn.at(angle), angles, origin);
        }
        self.reach_on(turn.end, angles, origin);
    }

    fn reach_on(&mut self, at: Vec3, angles: [f64; 2], origin: &Origin) {
        let joints = [at.x, at.y, at.z, angles[0], angles[1]];
        self.reach(&joints, origin);
        let te = self.st.chain.as_ref().map_or(at, |c| c.forward(&joints).0);
        self.take_extent(te);
    }

    /// A Sweep arc that the control cannot do, as chords within the path tolerance. What its end lies off its circle is
    /// spread along it.
    pub(crate) fn sweep_as_lines(
        &mut self,
        arc: &Arc,
        last: &Position,
        rapid: bool,
        origin: &Origin,
    ) {
        let Some(start) = self.st.pos else {
            let message = "an arc whose start is not known".to_string();
            let help = "write FROM or GOTO before it";
            self.error(codes::ARC_WITHOUT_START, origin, message, help);
            return;
        };
        let Course::Sweep(degrees) = arc.course else { return };
        let band = self.st.band().max(2.0 * self.blocks.number(b'X').resolution());
        let center = self.st.point(arc.circle.center);
        let axis = arc.circle.axis;
        let from = start - center;
        let radial = from - axis * from.dot(&axis);
        let end = self.st.point(last.te);
        let rise = (end - start).dot(&axis);
        let radius = radial.norm();
        let most = 2.0 * trig::acos_clamped(1.0 - band / radius.max(band));
        let sweep = degrees.to_radians();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "bounded")]
        let n = (sweep.abs() / most).ceil().clamp(1.0, 1e6) as u32;
        let side = axis.cross(&radial);
        let round = |part: f64| {
            let (s, c) = trig::sin_cos(sweep * part);
            center + axis * (from.dot(&axis) + rise * part) + radial * c + side * s
        };
        let off = end - round(1.0);
        if off.norm() > band {
            let message = format!(
                "the arc ends {:.4} off its circle, and is bent to its end along the way",
                off.norm() / self.st.scale
            );
            self.warn(codes::ARC_OFF_CIRCLE, origin, message, "check the centre and the end");
        }
        self.st.rounding = true;
        for i in 1..n {
            let part = f64::from(i) / f64::from(n);
            self.go_to(round(part) + off * part, last.ta, rapid, origin);
        }
        self.go_to(end, last.ta, rapid, origin);
        self.st.rounding = false;
    }

    /// The motion as a turn in a plane of the control, and the index of a point to which a line leads first.
    fn turn(&self, arc: &Arc, points: &[Position], arcs: &Arcs) -> Option<(Turn, Option<usize>)> {
        let last = points.last()?;
        let start = self.st.pos?;
        // With rotary axes in motion the circle is none for the linear axes.
        if points.iter().any(|p| (p.ta - self.st.ta).norm() > 1e-9) {
            return None;
        }
        let start = self.at_rest(start);
        let point = |p: &Position| self.at_rest(self.st.point(p.te));
        let resolution = self.blocks.number(b'X').resolution();
        let tol = self.st.band().max(resolution) + resolution;
        let radius = arc.circle.radius * self.st.scale;
        let unit = self.st.out_mm();
        if radius * unit < arcs.min_radius || radius * unit > arcs.max_radius {
            return None;
        }
        let center = self.at_rest(self.st.point(arc.circle.center));
        let axis = match &self.st.chain {
            Some(chain) => chain.turned(self.st.angles) * arc.circle.axis,
            None => arc.circle.axis,
        };
        let (plane, sense) = plane_of(axis, radius, resolution)?;
        if !arcs.planes.contains(&plane) {
            return None;
        }
        let ([a, b], _) = plane.axes();
        let normal = 3 - a - b;
        let polar = |p: Vec3| {
            let d = p - center;
            let r = trig::hypot(d[a], d[b]);
            ((r - radius).abs() <= tol).then(|| (d[a], d[b], p[normal]))
        };
        let end = point(last);
        match arc.course {
            Course::Sweep(degrees) => {
                let (u, v, _) = polar(start)?;
                polar(end)?;
                let sweep = degrees.to_radians() * sense;
                let start_angle = trig::atan2(v, u);
                let turn = Turn { plane, center, radius, start_angle, sweep, start, end };
                let rises = turn.rise().abs() > resolution;
                (turn.agrees(tol) && (arcs.helix || !rises)).then_some((turn, None))
            }
            Course::Chords => {
                // The tool may come to the circle on a line first.
                let lead_in = if polar(start).is_some() { None } else { Some(0) };
                let begin = lead_in.map_or(start, |i| point(&points[i]));
                let rest = &points[lead_in.map_or(0, |i| i + 1)..];
                if rest.is_empty() {
                    return None;
                }
                let mut at = polar(begin)?;
                let start_angle = trig::atan2(at.1, at.0);
                let mut sweep = 0.0;
                let mut heights = Vec::with_capacity(rest.len());
                for p in rest {
                    let next = polar(point(p))?;
                    let cross = at.0 * next.1 - at.1 * next.0;
                    let dot = at.0 * next.0 + at.1 * next.1;
                    let step = trig::atan2(cross, dot);
                    let back = step * sweep < 0.0 && step.abs() * radius > resolution;
                    if back || step.abs() > 0.95 * PI {
                        return None;
                    }
                    sweep += step;
                    heights.push((sweep, next.2));
                    at = next;
                }
                let turn = Turn { plane, center, radius, start_angle, sweep, start: begin, end };
                let rise = end[normal] - begin[normal];
                let even = |&(angle, h): &(f64, f64)| {
                    (h - begin[normal] - rise * angle / sweep).abs() <= tol
                };
                let flat = rise.abs() <= resolution;
                let level = flat && heights.iter().all(|h| (h.1 - begin[normal]).abs() <= tol);
                let helix = !flat && sweep != 0.0 && arcs.helix && heights.iter().all(even);
                (level || helix).then_some((turn, lead_in))
            }
        }
    }

    /// The blocks of a turn; `None` when the control would not take them.
    fn pieces(&self, turn: &Turn, arcs: &Arcs) -> Option<Vec<(Piece, Vec3)>> {
        let most = match arcs.center {
            ArcCenter::Radius => arcs.max_sweep.to_radians().min(MOST_FOR_RADIUS),
            _ if arcs.full_circle => arcs.max_sweep.to_radians(),
            // Halves, so that no block begins and ends at the same place.
            _ => arcs.max_sweep.to_radians().min(PI),
        };
        let angles = turn.stops(most, arcs.max_sweep <= 90.0)?;
        let [x, y] = self.st.angles;
        let round = |p: Vec3| self.blocks.round(&[p.x, p.y, p.z, x, y]).ok();
        let back = |q: &crate::emit::Rounded| {
            let j = self.blocks.unround(q);
            Vec3::new(j[0], j[1], j[2])
        };
        let ([a, b], letters) = turn.plane.axes();
        let resolution = self.blocks.number(b'X').resolution();
        let band = if self.st.fitted { 0.0 } else { self.st.band().max(resolution) };
        let tol = band + crate::fitting::ROUNDING * resolution;
        let radius_tol = arcs.radius_tolerance / self.st.out_mm();
        let mut from_q = round(turn.start)?;
        let mut from = back(&from_q);
        let mut from_angle = 0.0;
        let mut pieces = Vec::with_capacity(angles.len());
        for angle in angles {
            let end = turn.at(angle);
            let mut q = round(end)?;
            let mut to = back(&q);
            let sweep = angle - from_angle;
            let chord = trig::hypot(to[a] - from[a], to[b] - from[b]);
            let whole = sweep.abs() > PI && chord < 1.5 * resolution;
            if whole {
                // A whole turn ends where it began; rounding may have parted the two ends.
                (q[a], q[b]) = (from_q[a], from_q[b]);
                to = back(&q);
            }
            let sagitta = turn.radius * (1.0 - trig::cos(sweep.abs().min(PI) / 2.0));
            if !whole && sagitta < resolution / 2.0 {
                pieces.push((Piece::Line, end));
                (from_q, from, from_angle) = (q, to, angle);
                continue;
            }
            let (center, r) = self.center(turn, from, to, letters, radius_tol)?;
            let shift = trig::hypot(center[0] - turn.center[a], center[1] - turn.center[b]);
            if shift + (r - turn.radius).abs() > tol {
                return None;
            }
            let block = ArcBlock {
                plane: turn.plane,
                anticlockwise: sweep > 0.0,
                end: q,
                center: [center[0] - from[a], center[1] - from[b]],
                center_at: center,
                radius: r,
                large: sweep.abs() > PI,
                sweep: sweep.to_degrees(),
                rise: to[3 - a - b] - from[3 - a - b],
            };
            pieces.push((Piece::Arc(block), end));
            (from_q, from, from_angle) = (q, to, angle);
        }
        Some(pieces)
    }

    /// Centre and radius after rounding, so that both ends are equally far from it.
    fn center(
        &self,
        turn: &Turn,
        from: Vec3,
        to: Vec3,
        letters: [u8; 2],
        radius_tol: f64,
    ) -> Option<([f64; 2], f64)> {
        let ([a, b], _) = turn.plane.axes();
        let rounded = |c: [f64; 2]| {
            let mut out = c;
            for i in 0..2 {
                let n = self.blocks.number(letters[i]);
                let base = from[[a, b][i]];
                out[i] = base + n.value(n.round(c[i] - base)?);
            }
            Some(out)
        };
        let radii = |c: [f64; 2]| {
            let one = trig::hypot(from[a] - c[0], from[b] - c[1]);
            let two = trig::hypot(to[a] - c[0], to[b] - c[1]);
            (one, (one - two).abs())
        };
        let nominal = rounded([turn.center[a], turn.center[b]])?;
        let (r, differ) = radii(nominal);
        if differ <= radius_tol {
            return Some((nominal, r));
        }
        // The nearest point from which both ends are equally far: on the perpendicular bisector.
        let (du, dv) = (to[a] - from[a], to[b] - from[b]);
        let length2 = du * du + dv * dv;
        if length2 <= 0.0 {
            return None;
        }
        let (mu, mv) = (f64::midpoint(from[a], to[a]), f64::midpoint(from[b], to[b]));
        let off = ((turn.center[a] - mu) * du + (turn.center[b] - mv) * dv) / length2;
        let moved = rounded([turn.center[a] - off * du, turn.center[b] - off * dv])?;
        let (r, differ) = radii(moved);
        (differ <= radius_tol).then_some((moved, r))
    }
}

/// A block of an arc.
enum Piece {
    Arc(ArcBlock),
    /// A piece so flat that it is no arc at the output's resolution.
    Line,
}

impl Turn {
    /// Does the end lie where the angle says?
    fn agrees(&self, tol: f64) -> bool {
        let ([a, b], _) = self.plane.axes();
        let (s, c) = trig::sin_cos(self.start_angle + self.sweep);
        let at = [self.center[a] + self.radius * c, self.center[b] + self.radius * s];
        trig::hypot(at[0] - self.end[a], at[1] - self.end[b]) <= 2.0 * tol
    }

    fn rise(&self) -> f64 {
        let ([a, b], _) = self.plane.axes();
        let n = 3 - a - b;
        self.end[n] - self.start[n]
    }

    fn length(&self) -> f64 {
        trig::hypot(self.radius * self.sweep, self.rise())
    }

    /// Position at an angle from the start; exactly the end at the whole sweep.
    #[expect(clippy::float_cmp, reason = "the last stop is the sweep itself")]
    fn at(&self, angle: f64) -> Vec3 {
        if angle == self.sweep {
            return self.end;
        }
        let ([a, b], _) = self.plane.axes();
        let n = 3 - a - b;
        let (s, c) = trig::sin_cos(self.start_angle + angle);
        let mut p = self.start;
        p[a] = self.center[a] + self.radius * c;
        p[b] = self.center[b] + self.radius * s;
        p[n] += self.rise() * angle / self.sweep;
        p
    }

    /// Angles from the start at which blocks end, none longer than `most`; `None` for more than 10,000.
    fn stops(&self, most: f64, quadrants: bool) -> Option<Vec<f64>> {
        let total = self.sweep.abs();
        if total.is_nan() || total <= 0.0 || total / most > 1e4 {
            return None;
        }
        let sign = self.sweep.signum();
        let mut stops = Vec::new();
        if quadrants {
            // Where the path crosses an axis of the plane.
            let quarter = PI / 2.0;
            let begin = self.start_angle * sign;
            let mut k = (begin / quarter + 1e-9).floor() + 1.0;
            while k * quarter - begin < total - 1e-9 {
                stops.push(sign * (k * quarter - begin));
                k += 1.0;
            }
        } else {
            let n = (total / (most * (1.0 + 1e-9))).ceil().max(1.0);
            let mut i = 1.0;
            while i < n {
                stops.push(self.sweep * i / n);
                i += 1.0;
            }
        }
        stops.push(self.sweep);
        debug_assert!(total <= TAU * 1e5, "bounded above");
        Some(stops)
    }
}

/// The plane of an axis of the program's frame, and whether the axis points along (1) or against (-1) its
/// normal. `None` when the circle leans by more than a tenth of the resolution at its radius.
fn plane_of(axis: Vec3, radius: f64, resolution: f64) -> Option<(ArcPlane, f64)> {
    let planes = [ArcPlane::Yz, ArcPlane::Zx, ArcPlane::Xy];
    let lean = |i: usize| trig::hypot(axis[(i + 1) % 3], axis[(i + 2) % 3]);
    let i = (0..3).find(|&i| lean(i) * radius <= 0.1 * resolution || lean(i) < 1e-9)?;
    Some((planes[i], axis[i].signum()))
}
