//! Places of sculptured surfaces where the distance from a point dips.

use proptest::prelude::*;

use super::*;
use crate::Sculptured;
use crate::sculpt::{self, SplinePoint, mesh};
use crate::sculptured::MeshSpacing;
use crate::trig::{cos, sin};

/// Splines that are unevenly far from each other, through points at uneven ways.
fn waves(height: f64, shift: f64) -> Sculptured {
    let (xs, ys) = ([-9.0, -5.0, -4.0, 0.0, 3.0, 8.0], [-8.0, -6.5, -2.0, 1.0, 7.0]);
    let point = |x: f64, y: f64| {
        SplinePoint::plain(Vec3::new(x, y, height * sin(0.6 * x + shift) * cos(0.5 * y)))
    };
    let rows: Vec<Vec<_>> = ys.map(|y| xs.map(|x| point(x, y)).to_vec()).to_vec();
    mesh(&rows, MeshSpacing::Xyz).expect("an even mesh")
}

/// Two flat patches that meet in a ridge, or a furrow, along y.
fn roof(slope: f64) -> Sculptured {
    let at = |x: f64, y: f64| Vec3::new(x, y, -slope * x.abs());
    let flat = |x: f64| {
        let [a, b, c, d] = [at(x, -5.0), at(x + 6.0, -5.0), at(x, 5.0), at(x + 6.0, 5.0)];
        let none = Vec3::zeros();
        sculpt::Patch::hermite([
            [a, b, b - a, b - a],
            [c, d, d - c, d - c],
            [c - a, d - b, none, none],
            [c - a, d - b, none, none],
        ])
    };
    Sculptured::grid(vec![flat(-6.0), flat(0.0)], 2, 1).expect("two patches")
}

/// Distances of the two nearest dips, by ways down from all over the surface; infinite where there is no second.
fn nearest_two(s: &ParametricSurface, p: Vec3) -> [f64; 2] {
    const STARTS: u32 = 48;
    let domain = s.patch.domain();
    let at = |[a, b]: [f64; 2], k: u32| a + (b - a) * (f64::from(k) + 0.37) / f64::from(STARTS);
    let starts = (0..STARTS * STARTS).map(|k| [at(domain.u, k % STARTS), at(domain.v, k / STARTS)]);
    let found: Vec<_> = starts.map(|uv| s.descend_free(p, uv)).collect();
    let least = found.iter().min_by(|a, b| a.0.total_cmp(&b.0)).expect("some");
    let apart = |place: &Placed| (place.jet.s - least.1.jet.s).norm() > 1e-5 * s.extent;
    let others = found.iter().filter(|(_, place)| apart(place)).map(|(square, _)| square.sqrt());
    [least.0.sqrt(), others.fold(f64::INFINITY, f64::min)]
}

/// The same of the roof: a slope has a dip where the foot lies on it, and without any the ridge has one.
fn nearest_two_of_roof(slope: f64, p: Vec3) -> [f64; 2] {
    let feet = [-1.0, 1.0].map(|side| {
        let normal = Vec3::new(side * slope, 0.0, 1.0).normalize();
        let away = normal.dot(&p);
        (side * (p.x - normal.x * away) > 0.0).then_some(away.abs())
    });
    match feet {
        [Some(a), Some(b)] => [a.min(b), a.max(b)],
        [one, other] => [one.or(other).unwrap_or(Vec3::new(p.x, 0.0, p.z).norm()), f64::INFINITY],
    }
}

fn check(
    surface: &Sculptured,
    p: Vec3,
    limit: f64,
    [least, second]: [f64; 2],
) -> Result<(), TestCaseError> {
    let s = ParametricSurface::of_sculptured(surface).expect("a surface");
    let nearest = (s.foot(p).point - p).norm();
    prop_assert!((nearest - least).abs() < 1e-8, "{nearest} {least}");
    let told = s.rival(p, limit);
    prop_assert!((told - second.min(limit)).abs() < 1e-6, "{told} {second} {limit}");
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]
    #[test]
    fn the_two_nearest_dips_are_those_of_all_ways_down(
        height in 0.3_f64..2.5, shift in 0.0_f64..6.0,
        at in prop::array::uniform2(-0.9_f64..0.9), up in -4.0_f64..4.0, limit in 1.0_f64..8.0,
    ) {
        let (surface, p) = (waves(height, shift), Vec3::new(6.0 * at[0], 5.0 * at[1], up));
        let s = ParametricSurface::of_sculptured(&surface).expect("a surface");
        check(&surface, p, limit, nearest_two(&s, p))?;
    }

    #[test]
    fn the_dips_beside_an_edge_and_on_it_are_found(
        slope in -1.5_f64..1.5, at in prop::array::uniform2(-1.0_f64..1.0),
        up in -4.0_f64..4.0, limit in 1.0_f64..8.0,
    ) {
        prop_assume!(slope.abs() > 0.05 && up.abs() > 0.1);
        let p = Vec3::new(2.0 * at[0], 4.0 * at[1], up);
        check(&roof(slope), p, limit, nearest_two_of_roof(slope, p))?;
    }
}

#[test]
fn what_lies_close_by_is_told_within_a_patch_and_not_over_a_ridge() {
    let wavy = ParametricSurface::of_sculptured(&waves(1.5, 0.3)).expect("a surface");
    let mut told = 0;
    for i in 0..60 {
        let share = |k: u32| 0.03 + 0.94 * (f64::from(i * k % 61) / 61.0);
        let (place, sides) = wavy.place_with_sides([share(7), share(23)]);
        let size = 1e-4 * wavy.extent;
        let by = (place.shape.frame[0] * cos(f64::from(i))
            + place.shape.frame[1] * sin(f64::from(i)))
            * size;
        let Some(near) = wavy.close_by(&place, sides, by) else { continue };
        told += 1;
        let is = wavy.place(near.at.expect("parameters"));
        let off = near.point - is.point;
        assert!(off.norm() < 9.0 * size * size, "{i}: {off}");
        assert!(off.dot(&is.normal).abs() < 9.0 * size.powi(3) + 1e-13, "{i}: {off}");
        let turned = (near.normal - is.normal).norm();
        assert!(turned < 40.0 * size * size, "{i}: {turned}");
    }
    assert!(told > 50, "{told}");
    let ridge = ParametricSurface::of_sculptured(&roof(0.4)).expect("a surface");
    let (place, sides) = ridge.place_with_sides([0.5 - 1e-5, 0.3]);
    assert!(ridge.close_by(&place, sides, -Vec3::x() * 1e-6).is_some());
    assert!(ridge.close_by(&place, sides, Vec3::x() * 1e-3).is_none());
}
