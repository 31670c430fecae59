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
}

/// Halvings of a way with a turning axis.
const HALVINGS: u32 = 14;
/// Stretches of it.
const STRETCHES: u32 = 4000;
/// Part of what is allowed to which the least gap of a way is found.
const FINE: f64 = 1e-3;

impl Plain {
    /// The side on which the whole tool is held, up to `top` above its end, the tool standing at `te` with the axis
    /// `ta`; `None` of surfaces whose distance tells no side from afar (TABCYL, RLDSRF, POLCON).
    ///
    /// It is decided by the point of the cutter's axis half way up the cutter, at most its radius: no surface that is less deep in the cutter than that point parts it from the cutter's end, and what a
    /// shank or holder above does not matter. A hollow in which the axis from end to top has no room wherever it stands
    /// is open along the axis, as for motion along surfaces: nothing else would let the tool in.
    pub(crate) fn side(&self, cutter: &Profile, top: f64, (te, ta): (Vec3, Vec3)) -> Option<Side> {
        let surface = &*self.surface;
        if matches!(surface, Surface::Tabcyl(_) | Surface::Parametric(_)) {
            return None;
        }
        let (bottom, height) = (cutter.bottom(), cutter.height() - cutter.bottom());
        let low = te + ta * (bottom + (0.5 * height).min(cutter.widest()));
        let side = Side::of(low, surface);
        let open = side == Side::Negative
            && opens(surface, ta)
            && !has_room(surface, low, ta, top.max(cutter.height()) - bottom);
        Some(if open { Side::Open } else { side })
    }

    /// How deep a solid whose lower end is `up` above the tool end gets into the surface on its way, and where,
    /// if that is deeper than `allowed`. Without a side it is the one on which the middle of the solid starts. What
    /// cannot be computed is not taken for clear.
    pub(crate) fn deep(
        &self,
        (profile, up): (&Profile, f64),
        side: Option<Side>,
        [a, b]: [(Vec3, Vec3); 2],
        allowed: f64,
    ) -> Option<(f64, Vec3)> {
        let reach = profile.reach();
        let middle = a.0 + a.1 * (up + 0.5 * (profile.bottom() + profile.height()));
        let own = Side::of(middle, &self.surface);
        let side = side.unwrap_or(own);
        if side != Side::Open && side != own {
            // The surface stands between the cutter and this solid, or in it.
            let depth = self.surface.distance(middle).abs();
            if depth > allowed {
                return Some((depth, a.0));
            }
        }
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

/// Can a line of the length `height` along `ta` stand in the hollow at all, in a cone about as far from its vertex as `p`?
fn has_room(surface: &Surface, p: Vec3, ta: Vec3, height: f64) -> bool {
    let longest = match surface {
        Surface::Sphere(s) => 2.0 * s.radius,
        Surface::Cylinder(s) => 2.0 * s.radius / s.axis.cross(&ta).norm(),
        Surface::Cone(s) => {
            // From a point of the axis the wall is met in both directions.
            let radius = (p - s.vertex).dot(&s.axis) * s.sin_half() / s.cos_half;
            let (along, across) = (s.axis.dot(&ta), s.axis.cross(&ta).norm());
            let narrows = along.abs() * s.sin_half() / s.cos_half;
            radius / (across - narrows) + radius / (across + narrows)
        }
        Surface::Quadric(s) => return !s.too_low(ta, p, height, 0.0),
        _ => f64::INFINITY,
    };
    height <= longest
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::{Cutter, Cylinder, Plane, Sphere};

    fn plain(surface: Surface) -> Plain {
        let form = Arc::new(Form::Point(Vec3::zeros()));
        Plain { name: "K".into(), form, surface: Arc::new(surface) }
    }

    #[test]
    fn planes_and_spheres_are_kept_clear_of() {
        let profile = Profile::new(&Cutter::mill(10.0, 5.0, 40.0)).unwrap();
        let up = Vec3::z();
        let floor = plain(Surface::Plane(Plane { n: Vec3::z(), d: 0.0 }));
        let deep = |p: &Plain, a: Vec3, b: Vec3| {
            let side = p.side(&profile, 40.0, (a, up));
            p.deep((&profile, 0.0), side, [(a, up), (b, up)], 0.01)
        };
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
        assert!(floor.deep((&profile, 0.0), Some(Side::Positive), ends, 0.01).is_some());
    }

    #[test]
    fn cutter_and_holder_are_one_tool() {
        let up = Vec3::z();
        let cutter = Profile::new(&Cutter::mill(10.0, 5.0, 40.0)).unwrap();
        let holder = (Profile::new(&Cutter::mill(16.0, 0.0, 20.0)).unwrap(), 60.0);
        let deep = |p: &Plain, te: Vec3| {
            let side = p.side(&cutter, 80.0, (te, up));
            let of = |s: (&Profile, f64)| p.deep(s, side, [(te, up); 2], 0.01).map(|d| d.0);
            [of((&cutter, 0.0)), of((&holder.0, holder.1))]
        };
        // A plane in the gap between both, and a ball that only the holder is in.
        let between = plain(Surface::Plane(Plane { n: -up, d: -50.0 }));
        let [cutter_in, holder_in] = deep(&between, Vec3::zeros());
        assert!(cutter_in.is_none() && holder_in.is_some_and(|d| d > 19.9), "{holder_in:?}");
        let ball = plain(Surface::Sphere(Sphere { center: up * 120.0, radius: 78.0 }));
        assert!(deep(&ball, Vec3::zeros())[1].is_some());
        // A bowl that has no room for both is open above; one that has is not.
        let bowl =
            |radius: f64| plain(Surface::Sphere(Sphere { center: up * (radius - 0.001), radius }));
        assert_eq!(deep(&bowl(30.0), Vec3::zeros()), [None, None]);
        assert_eq!(deep(&bowl(60.0), Vec3::zeros()), [None, None]);
        assert!(deep(&bowl(60.0), up * 45.0)[1].is_some());
        assert!(deep(&bowl(30.0), Vec3::x() * 10.0)[0].is_some());
        // So is a trough; a bore about the axis is not.
        let round = |axis: Vec3, radius: f64| {
            let point = if axis == up { Vec3::zeros() } else { up * (radius - 0.001) };
            plain(Surface::Cylinder(Cylinder { point, axis, radius }))
        };
        assert_eq!(deep(&round(Vec3::x(), 20.0), Vec3::zeros()), [None, None]);
        assert!(deep(&round(up, 7.0), Vec3::zeros())[1].is_some_and(|d| (d - 1.0).abs() < 1e-9));
    }
}
