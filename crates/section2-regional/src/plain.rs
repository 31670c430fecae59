//! CHKSRF of planes, spheres, cylinders and the other surfaces that are not sculptured.

use std::sync::Arc;

use aptc_contact::{Condition, Side, Tool, chord, gap};
use aptc_geometry::{Form, Profile, Surface, Vec3, trig};

/// Such a surface.
#[derive(Clone, Debug)]
pub(crate) struct Plain {
    pub(crate) name: String,
    pub(crate) form: Arc<Form>,
    pub(crate) surface: Arc<Surface>,
}

/// Halvings of a way with a turning axis.
const HALVINGS: u32 = 14;
/// Stretches of it.
const STRETCHES: u32 = 4000;
/// Part of what is allowed to which the least gap of a way is found.
const FINE: f64 = 1e-3;

impl Plain {
    /// How deep a solid whose lower end is `up` above the tool end gets into the surface on its way, and where,
    /// if that is deeper than `allowed`. The side is the one on which the middle of the solid starts. What
    /// cannot be computed is not taken for clear.
    pub(crate) fn deep(
        &self,
        (profile, up): (&Profile, f64),
        [a, b]: [(Vec3, Vec3); 2],
        allowed: f64,
    ) -> Option<(f64, Vec3)> {
        let reach = profile.reach();
        let side = Side::of(a.0 + a.1 * (up + 0.5 * reach), &self.surface);
        let fine = FINE * allowed.abs().max(1e-6 * reach);
        let axis = |t: f64| (a.1 * (1.0 - t) + b.1 * t).try_normalize(1e-9).unwrap_or(a.1);
        let place = |t: f64| (a.0 + (b.0 - a.0) * t, axis(t));
        let mut stack = vec![(0.0, 1.0, 0_u32)];
        let mut stretches = 0;
        while let Some((from, to, halvings)) = stack.pop() {
            stretches += 1;
            let ends = [place(from), place(to)];
            let mid = axis(0.5 * (from + to));
            let turn = trig::sin(0.25 * trig::acos_clamped(ends[0].1.dot(&ends[1].1))) * 2.0;
            let slack = turn * (up + 2.0 * reach);
            let at = |te: Vec3| Tool { profile, te: te + mid * up, ta: mid };
            let tool = at(ends[0].0);
            let low = if ends[0].0 == ends[1].0 {
                gap(&tool, &self.surface, side, 0.0).map(|g| g.g)
            } else {
                let end = at(ends[1].0);
                let touch = Condition::Touch;
                chord(&tool, &end, &self.surface, touch, side, 0.0, None, fine).map(|c| c.low.g)
            };
            let Ok(low) = low else { return Some((f64::INFINITY, ends[0].0)) };
            if low - slack >= -allowed {
                continue;
            }
            if low + slack < -allowed || halvings >= HALVINGS || stretches > STRETCHES {
                return Some((-low, ends[1].0));
            }
            let half = 0.5 * (from + to);
            stack.push((half, to, halvings + 1));
            stack.push((from, half, halvings + 1));
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::{Cutter, Plane, Sphere};

    fn plain(surface: Surface) -> Plain {
        let form = Arc::new(Form::Point(Vec3::zeros()));
        Plain { name: "K".into(), form, surface: Arc::new(surface) }
    }

    #[test]
    fn planes_and_spheres_are_kept_clear_of() {
        let profile = Profile::new(&Cutter::mill(10.0, 5.0, 40.0)).unwrap();
        let up = Vec3::z();
        let floor = plain(Surface::Plane(Plane { n: Vec3::z(), d: 0.0 }));
        let deep = |p: &Plain, a: Vec3, b: Vec3| p.deep((&profile, 0.0), [(a, up), (b, up)], 0.01);
        assert!(deep(&floor, Vec3::z() * 0.5, Vec3::new(30.0, 0.0, 0.0)).is_none());
        let (d, _) = deep(&floor, Vec3::z() * 0.5, Vec3::new(30.0, 0.0, -0.25)).unwrap();
        assert!((d - 0.25).abs() < 1e-3, "{d}");
        // Past a sphere whose top is met half way only.
        let ball = Sphere { center: Vec3::new(20.0, 0.0, -3.0), radius: 4.0 };
        let dome = plain(Surface::Sphere(ball));
        let (d, _) = deep(&dome, Vec3::zeros(), Vec3::x() * 40.0).unwrap();
        assert!((d - 1.0).abs() < 1e-2, "{d}");
        assert!(deep(&dome, Vec3::zeros(), Vec3::new(0.0, 40.0, 0.0)).is_none());
        // Turning about a tool end that stays clear, the side comes down on the plane.
        let lying = Vec3::new(1.0, 0.0, 0.02).normalize();
        let ends = [(Vec3::z() * 6.0, up), (Vec3::z() * 3.0, lying)];
        assert!(floor.deep((&profile, 0.0), ends, 0.01).is_some());
    }
}
