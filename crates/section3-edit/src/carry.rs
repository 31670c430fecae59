//! A record carried by a map: TRACUT, and each copy of a COPY.

use aptc_cldata::{Arc, Arg, Control, Controlled, Course, Kind, Motion, Position, flatten};
use aptc_geometry::surface::frame_about;
use aptc_geometry::{Circle, Form, Transform, Vec3};

/// What could not be carried properly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Trouble {
    /// A geometric argument of a post-processor word that the map would turn into something else.
    Argument,
    /// The map flattens the tool axis away.
    Axis,
    /// The map tilts the tool, and the positions have no axis to say so.
    Tilt,
    /// The map scales the path of a cutter beside a surface, and not the cutter.
    Scale,
}

/// The map with what is needed to carry records.
#[derive(Clone, Debug)]
pub(crate) struct Carrier {
    map: Transform,
    scale: Option<f64>,
    mirrors: bool,
    tilts: bool,
    scales: bool,
}

/// A factor so near to one moves nothing that could be measured.
const SCALED: f64 = 1e-6;

impl Carrier {
    pub(crate) fn new(map: Transform) -> Self {
        let z = map.linear.column(2);
        let tilts = z[0].abs().max(z[1].abs()) > 1e-9 * z.norm() || z[2] <= 0.0;
        let scale = map.uniform_scale();
        let scales = scale.is_none_or(|s| (s - 1.0).abs() > SCALED);
        Self { map, scale, mirrors: map.mirrors(), tilts, scales }
    }

    /// Carries the record. `start` is the position before a motion, not carried; `tolerance` is that of the
    /// chords that an arc is made into when the map would make an ellipse of it.
    pub(crate) fn carry(
        &self,
        kind: &mut Kind,
        start: Option<Position>,
        tolerance: f64,
    ) -> Result<(), Trouble> {
        match kind {
            Kind::Motion(m) => self.motion(m, start, tolerance),
            Kind::Post { args, .. } => {
                let mut done = Ok(());
                for arg in args {
                    let Arg::Form { form, .. } = arg else { continue };
                    match form.transformed(&self.map) {
                        Ok(carried) => *form = carried.into(),
                        Err(_) => done = Err(Trouble::Argument),
                    }
                }
                done
            }
            _ => Ok(()),
        }
    }

    fn motion(&self, m: &mut Motion, start: Option<Position>, tol: f64) -> Result<(), Trouble> {
        // The surfaces lie where they lay: they do not govern the carried path.
        let control = m.control.take();
        let upright = m.points.last().map(|p| p.ta);
        let scaled = self.scales && control.is_some_and(|c| self.parts(&c, upright));
        if let Some(arc) = &mut m.arc {
            match self.scale {
                Some(scale) => self.arc(arc, scale),
                None => {
                    m.points = flatten::positions(m, start, tol);
                    m.arc = None;
                }
            }
        }
        let mut done = if self.tilts && !m.with_axis {
            Err(Trouble::Tilt)
        } else if scaled {
            Err(Trouble::Scale)
        } else {
            Ok(())
        };
        for p in &mut m.points {
            p.te = self.map.point(p.te);
            if m.with_axis {
                match self.map.vector(p.ta).try_normalize(0.0) {
                    Some(ta) => p.ta = ta,
                    None => done = Err(Trouble::Axis),
                }
            }
        }
        done
    }

    /// Does the map move a cutter off a surface that it touches, and not with its end alone?
    fn parts(&self, control: &Control, ta: Option<Vec3>) -> bool {
        let below = |n: &Vec3| ta.is_some_and(|ta| n.cross(&ta).norm() <= SCALED);
        let off = |c: &&Controlled| match c.form.shape() {
            Form::Plane(p) => !below(&p.n) && self.stretches(p.n),
            Form::Line(l) => self.stretches(l.plane().n),
            Form::Circle(c) => self.stretches_across(c.axis),
            Form::Cylinder(c) => self.stretches_across(c.axis),
            _ => true,
        };
        let milled = control.milling.as_ref().is_some_and(|m| m.part.is_some() && !m.on);
        let touched = control.drive.iter().chain(&control.part).filter(|c| c.side != 0);
        milled || touched.into_iter().any(|c| off(&c))
    }

    /// Are planes with this normal farther apart after the map, or nearer?
    fn stretches(&self, n: Vec3) -> bool {
        let inverse = self.map.linear.try_inverse();
        inverse.is_none_or(|i| ((i.transpose() * n).norm() - 1.0).abs() > SCALED)
    }

    /// Is it so of planes along the axis?
    fn stretches_across(&self, axis: Vec3) -> bool {
        let [a, b] = frame_about(axis);
        [a, b, (a + b) / 2.0_f64.sqrt()].into_iter().any(|n| self.stretches(n))
    }

    fn arc(&self, arc: &mut Arc, scale: f64) {
        let c = arc.circle;
        let axis = self.map.vector(c.axis) / scale;
        // A mirror turns the sense of rotation about the carried axis.
        let turned = self.mirrors && matches!(arc.course, Course::Sweep(_));
        arc.circle = Circle {
            center: self.map.point(c.center),
            axis: if turned { -axis } else { axis },
            radius: c.radius * scale,
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::Vec3;

    fn quarter() -> (Motion, Position) {
        let circle = Circle { center: Vec3::new(1.0, 0.0, 0.0), axis: Vec3::z(), radius: 2.0 };
        let m = Motion {
            arc: Some(Arc { circle, course: Course::Sweep(90.0) }),
            points: vec![Position::upright(Vec3::new(1.0, 2.0, 0.0))],
            ..Motion::default()
        };
        (m, Position::upright(Vec3::new(3.0, 0.0, 0.0)))
    }

    /// The chords of the carried arc are the carried chords.
    #[test]
    fn an_arc_stays_an_arc_under_turns_mirrors_and_scales() {
        for map in [
            Transform::rotation(Vec3::y(), 90.0),
            Transform::from_rows(&[-2.0, 0.0, 0.0, 1.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0]),
            Transform::translation(Vec3::new(1.0, 2.0, 3.0)),
        ] {
            let (m, start) = quarter();
            let mut kind = Kind::Motion(m.clone());
            let _ = Carrier::new(map).carry(&mut kind, Some(start), 0.01);
            let Kind::Motion(carried) = kind else { panic!("still a motion") };
            assert!(carried.arc.is_some());
            let there = Position { te: map.point(start.te), ta: start.ta };
            let a = flatten::positions(&m, Some(start), 0.01);
            let b = flatten::positions(&carried, Some(there), 0.01);
            let (p, q) = (a[a.len() / 2 - 1].te, map.point(a[a.len() / 2 - 1].te));
            let near = b.iter().map(|x| (x.te - q).norm()).fold(f64::INFINITY, f64::min);
            assert!(near < 0.3, "{p} {q} {near}");
            let side = |p: Vec3| (p - carried.arc.unwrap().circle.center).norm();
            assert!(b.iter().all(|p| (side(p.te) - carried.arc.unwrap().circle.radius) < 1e-9));
        }
    }

    #[test]
    fn an_arc_that_becomes_an_ellipse_is_cut_into_chords() {
        let (m, start) = quarter();
        let map =
            Transform::from_rows(&[1.0, 0.0, 0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
        let mut kind = Kind::Motion(m);
        Carrier::new(map).carry(&mut kind, Some(start), 0.01).unwrap();
        let Kind::Motion(m) = kind else { panic!("still a motion") };
        assert!(m.arc.is_none() && m.points.len() > 5);
        assert_eq!(m.points.last().unwrap().te, Vec3::new(1.0, 6.0, 0.0));
    }
}
