//! CHKSRF of planes, spheres, cylinders and the other surfaces that are not sculptured.

use std::sync::Arc;

use aptc_contact::{Condition, Side, Tool, chord, gap, opens};
use aptc_geometry::{Form, Profile, Surface, Vec3, trig};

/// Such a surface.
#[derive(Clone, Debug)]
pub(crate) struct Plain {
    pub(crate) name: String,
    pub(crate) form: Arc<Form>,
    pub(crate) surface: Arc<Surface>,
    /// The side to which cutter and holder keep; `None`: each of their solids to that of its own middle.
    pub(crate) side: Option<Side>,
}

/// Halvings of a way with a turning axis.
const HALVINGS: u32 = 14;
/// Stretches of it.
const STRETCHES: u32 = 4000;
/// Part of what is allowed to which the least gap of a way is found.
const FINE: f64 = 1e-3;

impl Plain {
    /// Sets the side of a plane, sphere, cylinder or cone for a statement, by where the tool stands before it.
    ///
    /// The lower end of the cutter says it: the place of its axis as far up as the cutter is wide, half way up at most.
    /// So a surface between cutter and holder, or one that the shank goes through, stands in the way of what is above. Inside
    /// of a hollow out of which cutter or holder reach already it is open along the axis. Where the tool comes into a
    /// ball or a bar from outside, it stays one that it must not cut: each position for itself would take it for a bowl.
    pub(crate) fn come_from(
        &mut self,
        cutter: &Profile,
        holder: &[(Profile, f64)],
        (te, ta): (Vec3, Vec3),
        allowed: f64,
    ) {
        use Surface::{Cone, Cylinder, Plane, Sphere};
        if !matches!(*self.surface, Plane(_) | Sphere(_) | Cylinder(_) | Cone(_)) {
            return;
        }
        let side = Side::of(lower_end(cutter, (te, ta)), &self.surface);
        self.side = Some(side);
        if side == Side::Positive || !opens(&self.surface, ta) {
            return;
        }
        let stays = |&(profile, up): &(Profile, f64)| {
            self.deep((&profile, up), [(te, ta); 2], allowed).is_none()
        };
        if !stays(&(*cutter, 0.0)) || !holder.iter().all(stays) {
            self.side = Some(Side::Open);
        }
    }

    /// Does a tool that came from outside stand with its lower end in a solid that could be a bowl or a trough?
    pub(crate) fn is_entered(&self, cutter: &Profile, at: (Vec3, Vec3)) -> bool {
        self.side == Some(Side::Positive)
            && opens(&self.surface, at.1)
            && self.surface.distance(lower_end(cutter, at)) < 0.0
    }

    /// How deep a solid whose lower end is `up` above the tool end gets into the surface on its way, and where,
    /// if that is deeper than `allowed`. What cannot be computed is not taken for clear.
    pub(crate) fn deep(
        &self,
        (profile, up): (&Profile, f64),
        [a, b]: [(Vec3, Vec3); 2],
        allowed: f64,
    ) -> Option<(f64, Vec3)> {
        let reach = profile.reach();
        let own = || Side::of(a.0 + a.1 * (up + 0.5 * reach), &self.surface);
        let side = self.side.unwrap_or_else(own);
        let fine = FINE * allowed.abs().max(1e-6 * reach);
        let axis = |t: f64| (a.1 * (1.0 - t) + b.1 * t).try_normalize(1e-9).unwrap_or(a.1);
        // A trough along which the tool comes to stand is a bore.
        let bore = side == Side::Open && !opens(&self.surface, axis(0.5));
        let side = if bore { Side::Negative } else { side };
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

fn lower_end(cutter: &Profile, (te, ta): (Vec3, Vec3)) -> Vec3 {
    te + ta * cutter.widest().min(0.5 * cutter.height())
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::{Cutter, Cylinder, Plane, Sphere};

    fn plain(surface: Surface) -> Plain {
        let form = Arc::new(Form::Point(Vec3::zeros()));
        Plain { name: "K".into(), form, surface: Arc::new(surface), side: None }
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

    #[test]
    fn cutter_and_holder_keep_to_the_side_that_the_tool_comes_from() {
        let cutter = Profile::new(&Cutter::mill(10.0, 5.0, 40.0)).unwrap();
        let holder = [(Profile::new(&Cutter::mill(16.0, 0.0, 20.0)).unwrap(), 50.0)];
        let up = Vec3::z();
        // How deep the cutter and the holder are on a way at the height 0 along x.
        let deep = |surface: Surface, from: Vec3| {
            let mut p = plain(surface);
            p.come_from(&cutter, &holder, (from, up), 0.01);
            let ends = [(Vec3::new(-1.0, 0.0, 0.0), up), (Vec3::new(1.0, 0.0, 0.0), up)];
            let of = |solid: (&Profile, f64)| p.deep(solid, ends, 0.01).map_or(0.0, |d| d.0);
            [of((&cutter, 0.0)), of((&holder[0].0, 50.0))]
        };
        let near = |[a, b]: [f64; 2], [c, d]: [f64; 2]| {
            assert!((a - c).abs() < 2e-2 && (b - d).abs() < 2e-2, "{a} {b}, not {c} {d}");
        };
        let (above, inside) = (Vec3::new(0.0, 0.0, 90.0), Vec3::new(0.0, 0.0, 1.0));
        let plane = |z: f64| Surface::Plane(Plane { n: up, d: z });
        near(deep(plane(45.0), inside), [0.0, 25.0]);
        near(deep(plane(45.0), above), [45.0, 0.0]);
        near(deep(plane(-3.0), above), [0.0, 0.0]);
        near(deep(plane(75.0), inside), [0.0, 0.0]);
        let ball =
            |radius: f64| Surface::Sphere(Sphere { center: Vec3::new(0.0, 0.0, 6.0), radius });
        near(deep(ball(9.5), above), [14.5, 0.0]);
        near(deep(ball(9.0), inside), [0.0, 0.0]);
        near(deep(ball(8.5), inside), [0.0, 0.5]);
        near(deep(ball(5.5), inside), [0.914, 3.5]);
        let point = Vec3::new(0.0, 0.0, 6.0);
        let bar = |radius: f64| Surface::Cylinder(Cylinder { point, axis: Vec3::y(), radius });
        near(deep(bar(9.5), above), [14.5, 0.0]);
        near(deep(bar(9.0), inside), [0.0, 0.0]);
        near(deep(bar(8.5), inside), [0.0, 0.5]);
        // All of a tool that finds room in a ball stays in it.
        let large = ball(90.0);
        let mut p = plain(large);
        p.come_from(&cutter, &holder, (inside, up), 0.01);
        assert_eq!(p.side, Some(Side::Negative));
    }
}
