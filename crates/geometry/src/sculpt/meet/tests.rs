//! Level lines, sections and curves of two surfaces against what is known of them.

use super::*;
use crate::sculpt::{CubicArc, SpaceCurve, SplinePoint, mesh, revolve};
use crate::trig;

/// A height field z(x, y) over a grid of 10.
fn field(n: usize, z: impl Fn(f64, f64) -> f64) -> Sculptured {
    let at = |i: usize, j: usize| {
        let (x, y) = (10.0 * i as f64, 10.0 * j as f64);
        SplinePoint::plain(Vec3::new(x, y, z(x, y)))
    };
    let rows: Vec<Vec<SplinePoint>> = (0..n).map(|j| (0..n).map(|i| at(i, j)).collect()).collect();
    mesh(&rows, crate::sculptured::MeshSpacing::Xyz).unwrap()
}

fn bumps(x: f64, y: f64) -> f64 {
    6.0 * trig::sin(0.13 * x) * trig::cos(0.11 * y)
}

fn check(curves: &[MeetCurve], plane: Option<&Plane>, s: &Sculptured) {
    for c in curves {
        for p in &c.points {
            let side = &p.sides[1];
            let d = s.at(side.uv[0], side.uv[1]);
            assert!((d.point - side.foot).norm() < 1e-9);
            assert!((d.point - p.point).norm() < 1e-9, "{p:?}");
            if let Some(plane) = plane {
                assert!(plane.distance(p.point).abs() < 1e-9);
            }
        }
    }
}

#[test]
fn level_lines_of_bumps_are_all_found() {
    let s = field(13, bumps);
    for level in [-5.0, -1.3, 0.4, 3.0, 5.7] {
        let plane = Plane { n: Vec3::z(), d: level };
        let curves = meet((&Cutting::Plane(plane), 0.0), (&[&s], 0.0), 0.005).unwrap();
        check(&curves, Some(&plane), &s);
        // Each line of a fine grid is crossed by the curves as often as its heights change their sign.
        let n = 480;
        let mut expected = 0;
        let mut crossed = 0;
        for k in 0..=11 {
            let v = k as f64 + 0.377;
            let heights: Vec<f64> = (0..=n)
                .map(|i| s.at(12.0 * f64::from(i) / f64::from(n), v).point.z - level)
                .collect();
            expected += heights.windows(2).filter(|w| (w[0] > 0.0) != (w[1] > 0.0)).count();
            for c in &curves {
                let over = |p: &MeetPoint| p.sides[1].uv[1] > v;
                crossed += c.points.windows(2).filter(|w| over(&w[0]) != over(&w[1])).count();
            }
        }
        assert_eq!(crossed, expected, "at {level}");
    }
}

#[test]
fn a_loop_at_a_summit_is_found_and_closed() {
    let s = field(5, |x, y| 30.0 - 0.01 * ((x - 18.0).powi(2) + (y - 23.0).powi(2)));
    let top = (0..=400)
        .flat_map(|i| (0..=400).map(move |j| (i, j)))
        .map(|(i, j)| s.at(0.01 * f64::from(i), 0.01 * f64::from(j)).point.z)
        .fold(f64::NEG_INFINITY, f64::max);
    let plane = Plane { n: Vec3::z(), d: top - 0.005 };
    let curves = meet((&Cutting::Plane(plane), 0.0), (&[&s], 0.0), 0.001).unwrap();
    assert_eq!(curves.len(), 1);
    assert!(curves[0].closed);
    let (first, last) = (curves[0].points[0], curves[0].points[curves[0].points.len() - 1]);
    assert!((first.point - last.point).norm() < 1e-12);
}

#[test]
fn chords_keep_the_tolerance() {
    let s = field(7, bumps);
    let plane = Plane { n: Vec3::new(0.6, 0.8, 0.0), d: 40.0 };
    let curves = meet((&Cutting::Plane(plane), 0.0), (&[&s], 0.0), 0.01).unwrap();
    assert_eq!(curves.len(), 1);
    for w in curves[0].points.windows(2) {
        for k in 1..8 {
            let p = w[0].point.lerp(&w[1].point, f64::from(k) / 8.0);
            let hit = crate::sculpt::nearest_on(&s, p);
            assert!(hit.distance < 0.0101, "{}", hit.distance);
        }
    }
}

#[test]
fn a_thick_cylinder_meets_a_slanting_plane_in_an_ellipse() {
    let line = CubicArc::line(Vec3::new(10.0, 0.0, -20.0), Vec3::new(10.0, 0.0, 20.0));
    let curve = SpaceCurve::new(vec![line]);
    let s = revolve(&curve, Vec3::zeros(), Vec3::z(), [0.0, 0.0], true).unwrap();
    let outwards = s.at(0.5, 0.5);
    let sign = outwards.normal().unwrap().dot(&outwards.point.normalize()).signum();
    let plane = Plane { n: Vec3::new(0.6, 0.0, 0.8), d: 1.0 };
    let curves = meet((&Cutting::Plane(plane), 0.5), (&[&s], 2.0 * sign), 0.01).unwrap();
    assert_eq!(curves.len(), 1);
    assert!(curves[0].closed);
    for p in &curves[0].points {
        assert!((p.point.xy().norm() - 12.0).abs() < 1e-10);
        assert!((plane.distance(p.point) - 0.5).abs() < 1e-10);
        assert!((p.sides[1].foot.xy().norm() - 10.0).abs() < 1e-10);
    }
}

#[test]
fn two_fields_meet_in_curves_on_both() {
    let a = field(7, bumps);
    let b = field(7, |x, y| 0.05 * x - 0.03 * y + trig::sin(0.3 * x));
    let first = Cutting::Surfaces(vec![&a]);
    let curves = meet((&first, 0.0), (&[&b], 0.0), 0.005).unwrap();
    assert!(!curves.is_empty());
    check(&curves, None, &b);
    for p in curves.iter().flat_map(|c| &c.points) {
        let side = &p.sides[0];
        assert!((a.at(side.uv[0], side.uv[1]).point - p.point).norm() < 1e-9);
        // Across both normals.
        assert!(p.along.dot(&p.sides[0].normal).abs() < 1e-9);
        assert!(p.along.dot(&p.sides[1].normal).abs() < 1e-9);
    }
    // Each end lies on a border of one of both.
    for c in curves.iter().filter(|c| !c.closed) {
        for p in [&c.points[0], &c.points[c.points.len() - 1]] {
            let at_border =
                p.sides.iter().flat_map(|s| s.uv).any(|x| x.abs() < 1e-6 || (x - 6.0).abs() < 1e-6);
            assert!(at_border, "{p:?}");
        }
    }
    let swapped = meet((&Cutting::Surfaces(vec![&b]), 0.0), (&[&a], 0.0), 0.005).unwrap();
    assert_eq!(curves.len(), swapped.len());
}
