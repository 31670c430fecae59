//! RLDSRF: straight rulings between two plane curves.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::{Fiop, Form, Place, Reason, Surface, Vec3};

/// RLDSRF. A ruling joins the points of both curves that stand over equal fractions of their base lines.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RuledSurface {
    /// The first curve.
    pub first: Rail,
    /// What the rulings run to.
    pub second: Second,
}

/// The far ends of the rulings.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Second {
    /// A second curve.
    Rail(Rail),
    /// One point for all: a general cone.
    Apex(Vec3),
}

/// A plane curve: the cut of a surface with the plane of its base line and a vector.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rail {
    /// The surface that is cut.
    pub surface: Arc<Form>,
    /// One end of the curve and of the base line.
    pub start: Vec3,
    /// The other end.
    pub end: Vec3,
    /// Direction in the cutting plane in which the curve is looked for from the base line, backwards only
    /// when it is not found forwards. Of any length but zero, not parallel to the base line.
    pub toward: Vec3,
}

impl RuledSurface {
    /// Flat list for print-outs: for each curve its surface's elements, both ends, the vector; or the apex.
    pub fn canonical(&self) -> Vec<f64> {
        let mut e = self.first.canonical();
        match &self.second {
            Second::Rail(rail) => e.extend(rail.canonical()),
            Second::Apex(p) => e.extend([p.x, p.y, p.z]),
        }
        e
    }
}

impl Rail {
    /// Share of the base line by which a rail's end may lie off its surface, as points of a drawing do.
    pub(crate) const BEHIND: f64 = 1e-6;

    fn canonical(&self) -> Vec<f64> {
        let mut e = self.surface.canonical();
        e.extend([self.start, self.end, self.toward].iter().flat_map(|p| [p.x, p.y, p.z]));
        e
    }

    /// The point of the base line at fraction `t`, 0 at the start, 1 at the end.
    pub fn base(&self, t: f64) -> Vec3 {
        self.start + (self.end - self.start) * t
    }

    /// The point of the curve over fraction `t` of the base line: the nearest of the surface in the
    /// direction `toward`, or behind when there is none before.
    ///
    /// At both ends the base line meets the curve, so the search begins a little behind it: otherwise
    /// rounding would decide whether the end itself lies ahead.
    pub fn point(&self, t: f64) -> Result<Vec3, Reason> {
        let surface = Surface::from_form(&self.surface).ok_or(Reason::NoHit)?;
        let chord = (self.end - self.start).norm();
        let toward = self.toward.try_normalize(0.0).ok_or(Reason::Degenerate(Place::Direction))?;
        let from = self.base(t) - toward * (Self::BEHIND * chord);
        surface.directed_distance(from, toward, Fiop::AheadFirst).map(|hit| hit.point)
    }
}

impl RuledSurface {
    /// The ruling over fraction `t` of the base lines: its point on the first curve, and on the second or
    /// the apex.
    pub fn ruling(&self, t: f64) -> Result<(Vec3, Vec3), Reason> {
        let far = match &self.second {
            Second::Rail(rail) => rail.point(t)?,
            Second::Apex(p) => *p,
        };
        Ok((self.first.point(t)?, far))
    }

    /// The point at share `u` of the ruling over `t`; rulings go on beyond 0 and 1.
    pub fn point(&self, t: f64, u: f64) -> Result<Vec3, Reason> {
        let (near, far) = self.ruling(t)?;
        Ok(near + (far - near) * u)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Circle;

    fn rail(radius: f64, z: f64, toward: Vec3) -> Rail {
        let circle = Circle { center: Vec3::zeros(), axis: Vec3::z(), radius };
        let end = Vec3::new(0.0, radius, z);
        let start = Vec3::new(radius, 0.0, z);
        Rail { surface: Arc::new(Form::Circle(circle)), start, end, toward }
    }

    #[test]
    fn rulings_join_equal_fractions() {
        let out = Vec3::new(1.0, 1.0, 0.0);
        let second = Second::Rail(rail(4.0, 3.0, out));
        let s = RuledSurface { first: rail(2.0, 0.0, out), second };
        for t in [0.0, 0.25, 0.5, 0.9, 1.0] {
            let (a, b) = s.ruling(t).unwrap();
            assert!((a.xy().norm() - 2.0).abs() < 1e-12 && a.z.abs() < 1e-12);
            assert!((b.xy().norm() - 4.0).abs() < 1e-12);
            // Over the base line in the direction given, and alike on both curves.
            assert!((a - s.first.base(t)).cross(&out).norm() < 1e-12, "{t}");
            assert!((b.xy() - a.xy() * 2.0).norm() < 1e-12);
            assert!((s.point(t, 0.5).unwrap() - (a + b) * 0.5).norm() < 1e-15);
        }
        assert!((s.ruling(0.0).unwrap().0 - Vec3::new(2.0, 0.0, 0.0)).norm() < 1e-12);
    }

    #[test]
    fn the_far_side_is_found_when_asked() {
        let inward = rail(2.0, 0.0, Vec3::new(-1.0, -1.0, 0.0));
        let p = inward.point(0.5).unwrap();
        let far = -2.0 * std::f64::consts::FRAC_1_SQRT_2;
        assert!((p - Vec3::new(far, far, 0.0)).norm() < 1e-12);
    }
}
