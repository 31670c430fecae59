//! Kinematics: from a position of the tool to positions of the axes, and back.
//!
//! Up to two rotary axes, any of which may carry the part or the tool, in any direction (so also nutated
//! ones). With the rotations of the part `P1 P2` (P2 carries the part) and of the tool `T1 T2` (T2 carries
//! the tool), a tool end `p` with axis `a` in the frame of the part stands in the machine at `P1 P2 p`, and
//! `P1 P2 a = T1 T2 z`. That is always one equation `R(d1, x) R(d2, y) u = v` of two rotations, which has two
//! solutions, one or none (Paden and Kahan's second subproblem).

mod angles;

use std::f64::consts::TAU;

use aptc_geometry::{Vec3, trig};
use nalgebra::{Matrix3, Unit};

use crate::emit::Joints;
use crate::machine::{Carries, Machine, Rotary, Wrap};
use angles::{Spin, clean_degrees, one_turn, two_turns, wrapped};

/// A rotary axis in radians and output units.
#[derive(Clone, Debug)]
struct Turn {
    carries: Carries,
    /// Unit direction.
    d: Vec3,
    /// A point of the axis.
    c: Vec3,
    min: f64,
    max: f64,
    endless: bool,
}

/// The rotary axes of a machine with a tool of a certain length.
#[derive(Clone, Debug)]
pub(crate) struct Chain {
    turns: Vec<Turn>,
    /// The control keeps the tool end on its path: positions are written in the frame of the part.
    tool_center: bool,
    /// Angles of the singular direction within which an axis may keep its angle, radians.
    singular: f64,
    /// A lathe without Y that mills: the one axis brings the place of the tool into its plane Y = 0.
    lathe: bool,
    /// The tool at zero of all axes, from its end to the spindle.
    tool: Vec3,
    /// Positions are written in a tilted plane: the rotation from the frame of the part to it.
    pub(crate) plane: Option<Matrix3<f64>>,
}

/// Why there is no position of the axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NoSolution {
    /// No angles give this tool axis.
    Direction,
    /// The angles lie beyond limits.
    Limits,
}

/// Angles beyond their limit by less than this count as within, radians.
const ON_LIMIT: f64 = 1e-9;

impl Chain {
    /// The chain of a machine; lengths of the machine file are divided by `unit_mm`, `length` is in output
    /// units.
    pub(crate) fn new(machine: &Machine, unit_mm: f64, length: f64) -> Self {
        let turn = |r: &Rotary| {
            let d = Vec3::from(r.axis);
            let mut c = Vec3::from(r.point) / unit_mm;
            if r.carries == Carries::Tool {
                c.z += length;
            }
            Turn {
                carries: r.carries,
                d: Unit::new_normalize(d).into_inner(),
                c,
                min: r.min.map_or(f64::NEG_INFINITY, f64::to_radians),
                max: r.max.map_or(f64::INFINITY, f64::to_radians),
                endless: r.min.is_none() && r.max.is_none() && r.wrap == Wrap::Modulo,
            }
        };
        Self {
            turns: machine.rotary.iter().take(2).map(turn).collect(),
            tool_center: machine.multiaxis.tool_center,
            singular: machine.multiaxis.singular.to_radians(),
            lathe: machine.is_milling(),
            tool: Vec3::z(),
            plane: None,
        }
    }

    /// The tool of a lathe stands across the spindle, along X.
    pub(crate) fn stand_across(&mut self) {
        self.tool = Vec3::x();
    }

    /// Tool end and tool axis in the frame of the part for a tool end that is given beside a table turned to
    /// `angles`, degrees, in the frame of the linear axes.
    pub(crate) fn programmed(&self, te: Vec3, angles: [f64; 2]) -> (Vec3, Vec3) {
        let spins = self.spins(angles);
        let (mut point, mut axis) = (te, Vec3::z());
        for (turn, spin) in self.turns.iter().zip(spins).rev() {
            if turn.carries == Carries::Tool {
                axis = spin.turn(turn.d, axis);
            }
        }
        for (turn, spin) in self.turns.iter().zip(spins) {
            if turn.carries == Carries::Part {
                axis = spin.back().turn(turn.d, axis);
                point = turn.c + spin.back().turn(turn.d, point - turn.c);
            }
        }
        (point, axis)
    }

    /// The rotation from the frame of the part to that of the linear axes at `angles`, degrees.
    pub(crate) fn table(&self, angles: [f64; 2]) -> Matrix3<f64> {
        let mut m = Matrix3::identity();
        for (turn, angle) in self.turns.iter().zip(angles).rev() {
            if turn.carries == Carries::Part {
                let spin = Spin::new(angle);
                m = Matrix3::from_columns(
                    &[0, 1, 2].map(|i| spin.turn(turn.d, m.column(i).into())),
                );
            }
        }
        m
    }

    /// Tool end and tool axis in the frame of the part.
    pub(crate) fn forward(&self, joints: &Joints) -> (Vec3, Vec3) {
        let xyz = Vec3::new(joints[0], joints[1], joints[2]);
        if let Some(plane) = &self.plane {
            return (plane.tr_mul(&xyz), plane.tr_mul(&Vec3::z()));
        }
        let mut axis = self.tool;
        let mut end = Vec3::zeros();
        let spins = self.spins([joints[3], joints[4]]);
        // The tool end moves with the head; the axis nearest to the tool turns it first.
        for (turn, spin) in self.turns.iter().zip(spins).rev() {
            if turn.carries == Carries::Tool {
                axis = spin.turn(turn.d, axis);
                end = turn.c + spin.turn(turn.d, end - turn.c);
            }
        }
        let mut point = xyz + end;
        for (turn, spin) in self.turns.iter().zip(spins) {
            if turn.carries == Carries::Part {
                let back = spin.back();
                axis = back.turn(turn.d, axis);
                if !self.tool_center {
                    point = turn.c + back.turn(turn.d, point - turn.c);
                }
            }
        }
        (if self.tool_center { xyz } else { point }, axis)
    }

    /// Positions of the linear axes when the rotary axes stand at `angles`, degrees.
    pub(crate) fn linear(&self, te: Vec3, angles: [f64; 2]) -> Vec3 {
        if let Some(plane) = &self.plane {
            return plane * te;
        }
        if self.tool_center {
            return te;
        }
        let mut point = te;
        let mut end = Vec3::zeros();
        for (turn, spin) in self.turns.iter().zip(self.spins(angles)).rev() {
            match turn.carries {
                Carries::Part => point = turn.c + spin.turn(turn.d, point - turn.c),
                Carries::Tool => end = turn.c + spin.turn(turn.d, end - turn.c),
            }
        }
        point - end
    }

    /// Greatest distance of a rotary axis from the zero of its frame.
    pub(crate) fn reach(&self) -> f64 {
        self.turns.iter().map(|t| t.c.norm()).sum()
    }

    fn spins(&self, degrees: [f64; 2]) -> [Spin; 2] {
        match self.turns.len() {
            0 => [Spin::NONE; 2],
            1 => [Spin::new(degrees[0]), Spin::NONE],
            _ => degrees.map(Spin::new),
        }
    }

    /// The rotation from the frame of the part to that in which positions are written at `angles`, degrees.
    pub(crate) fn turned(&self, angles: [f64; 2]) -> Matrix3<f64> {
        match self.plane {
            Some(plane) => plane,
            None if self.tool_center => Matrix3::identity(),
            None => self.table(angles),
        }
    }

    /// Angles in degrees for a tool axis, the ones nearest to `from` (degrees). Among solutions within the
    /// limits the one with the least sum of motion is taken; equal ones go to the first axis at rest.
    pub(crate) fn angles(
        &self,
        te: Vec3,
        axis: Vec3,
        from: [f64; 2],
    ) -> Result<[f64; 2], NoSolution> {
        if let Some(plane) = &self.plane {
            // The plane is there for this tool axis alone; the angles stay.
            let along = (plane * axis - Vec3::z()).norm() < UPRIGHT;
            return if along { Ok(from) } else { Err(NoSolution::Direction) };
        }
        let from = from.map(f64::to_radians);
        if self.lathe {
            return self.spindle_angle(te, axis, from);
        }
        let solutions = self.solutions(axis, from)?;
        let mut best: Option<([f64; 2], f64)> = None;
        for pair in solutions.into_iter().flatten() {
            let near =
                |i: usize| self.turns.get(i).map_or(Some(0.0), |t| t.nearest(pair[i], from[i]));
            let (Some(x), Some(y)) = (near(0), near(1)) else { continue };
            let way = (x - from[0]).abs() + (y - from[1]).abs();
            if best.is_none_or(|(_, w)| way < w - 1e-9) {
                best = Some(([x, y], way));
            }
        }
        best.map(|(a, _)| a.map(clean_degrees)).ok_or(NoSolution::Limits)
    }

    /// The angle of a lathe's spindle for a tool end: where the tool stands along the spindle, the one that brings
    /// the tool end to Y = 0 and X above 0; where it stands across, the one that brings its axis along X.
    fn spindle_angle(&self, te: Vec3, axis: Vec3, from: [f64; 2]) -> Result<[f64; 2], NoSolution> {
        let [turn] = self.turns.as_slice() else { return Err(NoSolution::Direction) };
        let stands = |v: f64| (v - self.tool.dot(&turn.d)).abs() < UPRIGHT;
        if !stands(axis.dot(&turn.d)) {
            return Err(NoSolution::Direction);
        }
        let u = if self.tool.x > 0.0 { axis } else { self.spoke(te) };
        let angle = if u.norm() < CENTER {
            from[0]
        } else {
            one_turn(turn.d, u.normalize(), Vec3::x(), from[0], 0.0)?
        };
        let near = turn.nearest(angle, from[0]).ok_or(NoSolution::Limits)?;
        Ok([clean_degrees(near), 0.0])
    }

    /// From the axis of a lathe's spindle to the tool end.
    fn spoke(&self, te: Vec3) -> Vec3 {
        let Some(turn) = self.turns.first() else { return te };
        let d = te - turn.c;
        d - turn.d * d.dot(&turn.d)
    }

    /// The rotary axis that may turn without turning the tool by more than `factor` singular angles when its
    /// axis is `axis`.
    pub(crate) fn free(&self, te: Vec3, axis: Vec3, factor: f64) -> Option<usize> {
        if self.lathe {
            // A tool along the spindle, on its axis.
            let center = self.tool.z > 0.0 && self.spoke(te).norm() < CENTER;
            return center.then_some(0);
        }
        let [one, two] = self.turns.as_slice() else { return None };
        let z = Vec3::z();
        let along = |d: Vec3, v: Vec3| d.cross(&v).norm() < UPRIGHT.max(factor * self.singular);
        let (first, second) = match (one.carries, two.carries) {
            (Carries::Part, Carries::Part) => (along(one.d, z), along(two.d, axis)),
            _ => (along(one.d, axis), along(two.d, z)),
        };
        if second {
            Some(1)
        } else if first {
            Some(0)
        } else {
            None
        }
    }

    /// The solutions without regard to limits, radians.
    fn solutions(&self, axis: Vec3, from: [f64; 2]) -> Result<[Option<[f64; 2]>; 2], NoSolution> {
        let z = Vec3::z();
        match self.turns.as_slice() {
            [] => {
                let leans = trig::hypot(axis.x, axis.y) > UPRIGHT || axis.z < 0.0;
                if leans { Err(NoSolution::Direction) } else { Ok([Some([0.0, 0.0]), None]) }
            }
            [one] => {
                let (u, v, sign) = match one.carries {
                    Carries::Part => (axis, z, 1.0),
                    Carries::Tool => (z, axis, 1.0),
                };
                let x = one_turn(one.d, u, v, from[0], self.singular)? * sign;
                Ok([Some([x, 0.0]), None])
            }
            [one, two, ..] => {
                let (d1, d2, u, v, sign) = match (one.carries, two.carries) {
                    // P1 P2 a = z
                    (Carries::Part, Carries::Part) => (one.d, two.d, axis, z, [1.0, 1.0]),
                    // T1 T2 z = a
                    (Carries::Tool, Carries::Tool) => (one.d, two.d, z, axis, [1.0, 1.0]),
                    // P a = T z: P(-x) T(y) z = a
                    _ => (one.d, two.d, z, axis, [-1.0, 1.0]),
                };
                let from = [from[0] * sign[0], from[1] * sign[1]];
                let pairs = two_turns(d1, d2, u, v, from, self.singular)?;
                Ok(pairs.map(|p| p.map(|[x, y]| [x * sign[0], y * sign[1]])))
            }
        }
    }
}

/// Nearer to the axis of a lathe's spindle than this any angle will do, output units.
const CENTER: f64 = 1e-7;

/// A tool axis counts as reached when it leans by less than this, radians: some 0.2 seconds of arc, below the
/// last digit of any CL text.
pub(crate) const UPRIGHT: f64 = 1e-6;

impl Turn {
    /// The angle equal to `angle` up to whole turns that is nearest to `from` and within the limits.
    fn nearest(&self, angle: f64, from: f64) -> Option<f64> {
        let near = from + wrapped(angle - from);
        if self.endless {
            return Some(near);
        }
        // Whole turns that bring it within the limits, the nearest first.
        let within = |a: f64| a >= self.min - ON_LIMIT && a <= self.max + ON_LIMIT;
        if within(near) {
            return Some(near);
        }
        let mut best: Option<f64> = None;
        for k in -4_i32..=4 {
            let a = near + TAU * f64::from(k);
            if within(a) && best.is_none_or(|b| (a - from).abs() < (b - from).abs()) {
                best = Some(a);
            }
        }
        best
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn chain(turns: Vec<Turn>, tool_center: bool) -> Chain {
        Chain { turns, tool_center, singular: 1e-9, lathe: false, tool: Vec3::z(), plane: None }
    }

    fn turn(carries: Carries, d: Vec3, c: Vec3) -> Turn {
        let d = d.normalize();
        Turn { carries, d, c, min: f64::NEG_INFINITY, max: f64::INFINITY, endless: false }
    }

    fn vector() -> impl Strategy<Value = Vec3> {
        (-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64)
            .prop_map(|(x, y, z)| Vec3::new(x, y, z))
            .prop_filter("a direction", |v| v.norm() > 0.1)
    }

    #[test]
    fn table_table_stands_as_expected() {
        // A about X, then C about Z on it.
        let origin = Vec3::zeros();
        let m = chain(
            vec![turn(Carries::Part, Vec3::x(), origin), turn(Carries::Part, Vec3::z(), origin)],
            false,
        );
        let [a, c] =
            m.angles(Vec3::zeros(), Vec3::new(0.0, -1.0, 1.0).normalize(), [0.0; 2]).unwrap();
        let (te, ta) = m.forward(&[0.0, 0.0, 0.0, a, c]);
        assert!((ta - Vec3::new(0.0, -1.0, 1.0).normalize()).norm() < 1e-12 && te.norm() < 1e-12);
        assert!((a.abs() - 45.0).abs() < 1e-9, "{a} {c}");
        // Upright, C is free and stays.
        assert!((m.angles(Vec3::zeros(), Vec3::z(), [10.0, 77.0]).unwrap()[1] - 77.0).abs() < 1e-9);
    }

    #[test]
    fn limits_choose_the_other_solution_or_refuse() {
        let origin = Vec3::zeros();
        let mut tilt = turn(Carries::Part, Vec3::x(), origin);
        (tilt.min, tilt.max) = (0.0, 2.0);
        let m = chain(vec![tilt.clone(), turn(Carries::Part, Vec3::z(), origin)], false);
        for y in [-1.0, 1.0] {
            let [a, _] =
                m.angles(Vec3::zeros(), Vec3::new(0.0, y, 1.0).normalize(), [0.0; 2]).unwrap();
            assert!((a - 45.0).abs() < 1e-9);
        }
        assert_eq!(m.angles(Vec3::zeros(), -Vec3::z(), [0.0; 2]), Err(NoSolution::Limits));
        let one = chain(vec![tilt], false);
        assert_eq!(one.angles(Vec3::zeros(), Vec3::x(), [0.0; 2]), Err(NoSolution::Direction));
    }

    #[test]
    fn a_lean_across_what_the_machine_can_turn_is_refused_however_small() {
        let turn = |d| turn(Carries::Part, d, Vec3::zeros());
        let one = chain(vec![turn(Vec3::z())], false);
        let two = chain(vec![turn(Vec3::z()), turn(Vec3::y())], false);
        for lean in [1e-5, 9e-4, 0.1] {
            let across = Vec3::new(0.0, lean, 1.0).normalize();
            let along = Vec3::new(lean, 0.0, 1.0).normalize();
            for m in [&one, &two] {
                assert_eq!(m.angles(Vec3::zeros(), across, [0.0; 2]), Err(NoSolution::Direction));
            }
            let [a, c] = two.angles(Vec3::zeros(), along, [0.0; 2]).unwrap();
            let (_, axis) = two.forward(&[0.0, 0.0, 0.0, a, c]);
            assert!((axis - along).norm() < 1e-9, "{a} {c}");
        }
    }

    #[test]
    fn the_nearest_turn_is_taken() {
        let origin = Vec3::zeros();
        let m = chain(vec![turn(Carries::Part, Vec3::x(), origin)], false);
        let axis = Vec3::new(0.0, trig::sin_deg(-10.0), trig::cos_deg(-10.0));
        let [a, _] = m.angles(Vec3::zeros(), axis, [355.0, 0.0]).unwrap();
        let [b, _] = m.angles(Vec3::zeros(), axis, [-5.0, 0.0]).unwrap();
        assert!((a - b - 360.0).abs() < 1e-9, "{a} {b}");
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        #[test]
        fn forward_of_inverse_is_the_same(
            kind in 0..4_u8, d1 in vector(), d2 in vector(), c1 in vector(), c2 in vector(),
            te in vector(), x in -3.0..3.0_f64, y in -3.0..3.0_f64, from in (-180.0..180.0_f64, -180.0..180.0_f64),
            tool_center: bool,
        ) {
            prop_assume!(d1.normalize().cross(&d2.normalize()).norm() > 0.05);
            let (a, b) = match kind {
                0 => (Carries::Part, Carries::Part),
                1 => (Carries::Part, Carries::Tool),
                2 => (Carries::Tool, Carries::Tool),
                _ => (Carries::Part, Carries::Part),
            };
            let mut turns = vec![turn(a, d1, c1 * 100.0), turn(b, d2, c2 * 100.0)];
            if kind == 3 { turns.pop(); }
            let m = chain(turns, tool_center);
            // An axis that the machine can take.
            let second = if kind == 3 { 0.0 } else { y.to_degrees() };
            let (_, axis) = m.forward(&[0.0, 0.0, 0.0, x.to_degrees(), second]);
            let angles = m.angles(Vec3::zeros(), axis, [from.0, from.1]).unwrap();
            let te = te * 300.0;
            let p = m.linear(te, angles);
            let (back, ta) = m.forward(&[p.x, p.y, p.z, angles[0], angles[1]]);
            prop_assert!((back - te).norm() < 1e-9 * 1000.0, "{back} {te}");
            prop_assert!((ta - axis).norm() < 1e-7, "{ta} {axis}");
        }
    }
}
