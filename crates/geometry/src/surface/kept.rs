//! To which side of a surface of CHKSRF cutter and holder keep: the rule that makes the path and by which it is
//! proved.
//!
//! - Planes, spheres, cylinders, cones and the quadrics that bound a convex solid have sides; what other surfaces have is
//!   told by where they end. There nothing of the surface may be in the tool, and that is all.
//! - The side is that of the place from which the tool comes to a statement: where the last motion ended that was put
//!   out. What is only recorded (CLDAT) and what a machine does by itself (CYCLE, LOADTL, RETRCT) does not count. Where
//!   nothing was put out before, the first place of the statement tells.
//! - Of the tool its lower end counts: the place of its axis as far up as the cutter is wide, half way up at most. So
//!   a surface between cutter and holder, or one that the shank goes through, stands in the way of what is above.
//! - A lower end on the surface is on the side to which the tool axis leads from there.
//! - The inside of a sphere, or of a cylinder, cone or convex quadric that lies, is a bowl or a trough. What lies above it,
//!   seen along the tool axis, is no material, whether the tool is taller than it or not: a roof over a tool that has room
//!   in a closed hollow is not seen.
//! - Between cutter and holder the tool axis is a thin rod.

use crate::{Cutter, Profile, Surface, Vec3};

/// Share of the size of the numbers within which a place counts as on the surface.
const NEAR: f64 = 1e-9;
/// Cosine with the axis below which a normal counts as square to it.
const LEVEL: f64 = 1e-12;
/// How thick the rod between cutter and holder is, as a share of the wider of both, beyond what may be cut of it: thin
/// enough to pass wherever the axis does, and thick enough for a search to tell it from a line.
const THIN: f64 = 1e-3;

/// The surface with its convex inside, if it has one, on its negative side; `None` of surfaces that have no sides.
pub fn with_inside(surface: &Surface) -> Option<Surface> {
    match surface {
        Surface::Plane(_) | Surface::Sphere(_) | Surface::Cylinder(_) | Surface::Cone(_) => {
            Some(surface.clone())
        }
        Surface::Quadric(s) => match s.convexity() {
            1 => Some(surface.clone()),
            -1 => s.reversed().map(|s| Surface::Quadric(s.into())),
            _ => None,
        },
        Surface::Tabcyl(_) | Surface::Parametric(_) => None,
    }
}

/// The side on which a place lies, +1 or -1; of a place no farther than `near` from the surface that to which `up`
/// leads, and +1 where that runs along the surface.
pub fn side_of(surface: &Surface, p: Vec3, up: Vec3, near: f64) -> f64 {
    let foot = surface.foot(p);
    if foot.distance.abs() > near.max(NEAR * (surface.extent() + p.norm())) {
        return foot.distance.signum();
    }
    let rise = foot.normal.dot(&up);
    if rise < -LEVEL { -1.0 } else { 1.0 }
}

/// The side to which a cutter keeps that comes from the tool end `te` with the axis `ta`; a lower end no farther than
/// `near` from the surface is on it. `None` of surfaces that have no sides; else as [`with_inside`] has it.
pub fn side_from(
    surface: &Surface,
    cutter: &Profile,
    (te, ta): (Vec3, Vec3),
    near: f64,
) -> Option<f64> {
    let surface = with_inside(surface)?;
    Some(side_of(&surface, lower_end(cutter, (te, ta)), ta, near))
}

/// The place of the tool that tells its side.
pub fn lower_end(cutter: &Profile, (te, ta): (Vec3, Vec3)) -> Vec3 {
    te + ta * cutter.widest().min(0.5 * cutter.height())
}

/// Does the inside of the surface count as open along the axis `ta`? That of a sphere or ellipsoid does, and that of a
/// cylinder or cone that lies, askew to the axis by 45 degrees or more: one that stands is a bore; a paraboloid about the
/// axis is open as it is.
pub fn opens(surface: &Surface, ta: Vec3) -> bool {
    let lies = |axis: Vec3| axis.dot(&ta).abs() <= std::f64::consts::FRAC_1_SQRT_2;
    match surface {
        Surface::Sphere(_) => true,
        Surface::Cylinder(s) => lies(s.axis),
        Surface::Cone(s) => {
            // No ray along the tool axis stays in it.
            let along = s.axis.dot(&ta);
            let across = (ta - s.axis * along).norm();
            lies(s.axis) && s.sin_half() * along.abs() < (1.0 - LEVEL) * s.cos_half * across
        }
        Surface::Quadric(s) => s.generator().is_none_or(lies) && s.opened(ta).is_some(),
        Surface::Plane(_) | Surface::Tabcyl(_) | Surface::Parametric(_) => false,
    }
}

/// The rod between the cutter and what begins above it, and its height over the tool end; `None` where nothing is between
/// them. What is in it no deeper than `allowed` does not come to the axis.
pub fn between(cutter: &Profile, above: &[(Profile, f64)], allowed: f64) -> Option<(Profile, f64)> {
    let (lowest, up) = above.iter().min_by(|a, b| a.1.total_cmp(&b.1))?;
    let (top, wide) = (cutter.height(), cutter.widest().max(lowest.widest()));
    let length = up - top;
    if length.is_nan() || length <= NEAR * (top + up) {
        return None;
    }
    let radius = allowed.max(0.0) + THIN * wide.max(THIN * length);
    let rod = Profile::new(&Cutter::mill(2.0 * radius, 0.0, length)).ok()?;
    Some((rod, top))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Circle, Cone, Cylinder, Form, Line, Plane, Quadric, QuadricKind, Sphere, trig};

    const UP: Vec3 = Vec3::new(0.0, 0.0, 1.0);

    fn mill() -> Profile {
        Profile::new(&Cutter::mill(10.0, 5.0, 40.0)).unwrap()
    }

    fn at(x: f64, y: f64, z: f64) -> (Vec3, Vec3) {
        (Vec3::new(x, y, z), UP)
    }

    fn plane(n: Vec3, d: f64) -> Surface {
        Surface::Plane(Plane { n, d })
    }

    fn quadric(c: [f64; 10]) -> Surface {
        Surface::from_form(&Form::Quadric(Quadric { kind: QuadricKind::Qadric, c })).unwrap()
    }

    #[test]
    fn the_lower_end_tells_the_side() {
        let cutter = mill();
        // As far up as the cutter is wide: 5. Of a flat one half way up, 1.
        let flat = Profile::new(&Cutter::mill(10.0, 0.0, 2.0)).unwrap();
        assert_eq!(lower_end(&cutter, at(1.0, 2.0, 3.0)), Vec3::new(1.0, 2.0, 8.0));
        assert_eq!(lower_end(&flat, at(1.0, 2.0, 3.0)), Vec3::new(1.0, 2.0, 4.0));
        let side = |z: f64| side_from(&plane(UP, z), &cutter, at(0.0, 0.0, 0.0), 0.0);
        assert_eq!((side(4.9), side(5.1)), (Some(1.0), Some(-1.0)));
        let lean = (Vec3::zeros(), Vec3::new(0.6, 0.0, 0.8));
        let side = |z: f64| side_from(&plane(UP, z), &cutter, lean, 0.0);
        assert_eq!((side(3.9), side(4.1)), (Some(1.0), Some(-1.0)));
    }

    #[test]
    fn a_place_on_the_surface_is_where_the_axis_leads() {
        let point = Profile::new(&Cutter::mill(0.0, 0.0, 0.0)).unwrap();
        // Whichever way the normal of the floor points the tool stands above it, also .004 in it where .01 is allowed.
        for z in [0.0, 0.004, -0.004] {
            let side = |s: &Surface, near| side_from(s, &point, at(3.0, 4.0, z), near);
            assert_eq!(side(&plane(UP, 0.0), 0.01), Some(1.0), "{z}");
            assert_eq!(side(&plane(-UP, 0.0), 0.01), Some(-1.0), "{z}");
        }
        assert_eq!(side_from(&plane(UP, 0.0), &point, at(0.0, 0.0, -0.004), 0.001), Some(-1.0));
        // Beside a wall the axis leads nowhere: the positive side.
        let wall = plane(Vec3::x(), 3.0);
        assert_eq!(side_from(&wall, &point, at(3.0, 0.0, 1.0), 0.0), Some(1.0));
        // At the bottom of a bowl it leads in, on the top of a ball out.
        let ball = Surface::Sphere(Sphere { center: Vec3::zeros(), radius: 5.0 });
        assert_eq!(side_from(&ball, &point, at(0.0, 0.0, -5.0), 0.0), Some(-1.0));
        assert_eq!(side_from(&ball, &point, at(0.0, 0.0, 5.0), 0.0), Some(1.0));
        assert_eq!(side_from(&ball, &point, at(3.0, 0.0, -4.0 + 1e-12), 0.0), Some(-1.0));
    }

    #[test]
    fn a_line_is_a_plane_and_a_circle_a_cylinder() {
        let cutter = mill();
        let line = Form::Line(Line { a: 0.0, b: 1.0, d: 0.0 });
        let line = Surface::from_form(&line).unwrap();
        let right = side_from(&line, &cutter, at(0.0, 7.0, 0.0), 0.0);
        assert_eq!(right, side_from(&line, &cutter, at(9.0, 7.0, -90.0), 0.0));
        assert_ne!(right, side_from(&line, &cutter, at(0.0, -7.0, 0.0), 0.0));
        let circle = Circle { center: Vec3::zeros(), axis: UP, radius: 3.0 };
        let circle = Surface::from_form(&Form::Circle(circle)).unwrap();
        assert_eq!(side_from(&circle, &cutter, at(2.0, 0.0, 80.0), 0.0), Some(-1.0));
        assert_eq!(side_from(&circle, &cutter, at(2.0, 2.5, 80.0), 0.0), Some(1.0));
        assert!(!opens(&circle, UP) && opens(&circle, Vec3::x()));
    }

    #[test]
    fn a_quadric_has_the_sides_of_the_surface_that_it_is() {
        let cutter = mill();
        // x^2 + y^2 + z^2 - 400 and its opposite.
        let c = [1.0, 1.0, 1.0, -400.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let ball = Surface::Sphere(Sphere { center: Vec3::zeros(), radius: 20.0 });
        for form in [quadric(c), quadric(c.map(|x| -x))] {
            let same = with_inside(&form).unwrap();
            assert!(opens(&same, UP) && opens(&same, Vec3::x()));
            for z in [-30.0, -24.5, -20.0, 0.0, 14.0, 16.0, 90.0] {
                let sides = [&form, &ball].map(|s| side_from(s, &cutter, at(3.0, 1.0, z), 0.0));
                assert_eq!(sides[0], sides[1], "{z}");
            }
        }
        // A saddle has no inside.
        let saddle = quadric([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.5, 0.0, 0.0, 0.5]);
        assert!(side_from(&saddle, &cutter, at(0.0, 0.0, 9.0), 0.0).is_none());
    }

    #[test]
    fn what_lies_opens_and_what_stands_is_a_bore() {
        let lean = |angle: f64| {
            let (s, c) = trig::sin_cos(angle.to_radians());
            Vec3::new(c, 0.0, s)
        };
        let bar = |angle: f64| {
            let (point, axis) = (Vec3::zeros(), lean(angle));
            Surface::Cylinder(Cylinder { point, axis, radius: 3.0 })
        };
        assert!(opens(&bar(44.9), UP) && !opens(&bar(45.1), UP) && !opens(&bar(90.0), UP));
        // A cone of half angle 30 degrees holds a ray up when it leans to within 30 degrees of it: never where it lies by 45.
        let cone = |angle: f64, half: f64| {
            let cos_half = trig::cos(half.to_radians());
            Surface::Cone(Cone { vertex: Vec3::zeros(), axis: lean(angle), cos_half })
        };
        assert!(opens(&cone(44.9, 30.0), UP) && !opens(&cone(45.1, 30.0), UP));
        // Of half angle 60 it does from 30 degrees on.
        assert!(opens(&cone(29.9, 60.0), UP) && !opens(&cone(30.1, 60.0), UP));
        assert!(!opens(&plane(UP, 0.0), UP));
        // z = x^2 + y^2 is open as it is.
        let bowl = quadric([1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.5]);
        assert!(!opens(&bowl, UP) && opens(&bowl, lean(80.0)));
    }

    #[test]
    fn a_rod_stands_between_cutter_and_holder() {
        let cutter = mill();
        let chuck = Profile::new(&Cutter::mill(20.0, 0.0, 30.0)).unwrap();
        let wide = Profile::new(&Cutter::mill(60.0, 0.0, 10.0)).unwrap();
        let (rod, up) = between(&cutter, &[(wide, 90.0), (chuck, 60.0)], 0.02).unwrap();
        assert!((up - 40.0).abs() < 1e-12 && (rod.height() - 20.0).abs() < 1e-12);
        assert!((rod.widest() - 0.03).abs() < 1e-12);
        assert!(between(&cutter, &[(chuck, 40.0)], 0.02).is_none());
        assert!(between(&cutter, &[(chuck, 35.0)], 0.02).is_none());
        assert!(between(&cutter, &[], 0.02).is_none());
        // Neither has a width.
        let thin = Profile::new(&Cutter::mill(0.0, 0.0, 5.0)).unwrap();
        assert!(between(&thin, &[(thin, 9.0)], 0.0).is_some_and(|(rod, _)| rod.widest() > 0.0));
    }
}
