//! What is left between passes against brute force.

use std::sync::Arc;

use super::*;
use crate::between::between_poses;
use crate::tool::{Pose, Tool};
use aptc_geometry::sculpt::{SplinePoint, mesh};
use aptc_geometry::sculptured::MeshSpacing;
use aptc_geometry::{Cutter, Profile, Sculptured, trig};
use proptest::prelude::*;

/// A square of 8 over x and y with a wave in it.
fn waved(high: f64) -> Sculptured {
    let at = |i: i32, j: i32| {
        let (x, y) = (2.0 * f64::from(i), 2.0 * f64::from(j));
        SplinePoint::plain(Vec3::new(x, y, high * trig::sin(0.7 * x + 0.3 * y)))
    };
    let rows: Vec<Vec<_>> = (0..5).map(|j| (0..5).map(|i| at(i, j)).collect()).collect();
    mesh(&rows, MeshSpacing::Xyz).expect("a surface")
}

/// Distance of a point from the tool at its nearest on the way: the best of a row of places, then a search beside it.
fn nearest(tool: &Tool<'_>, [a, b]: &[Pose; 2], x: Vec3) -> f64 {
    const PLACES: u32 = 12;
    let at = |t: f64| tool.near(&between_poses(a, b, t), x).0;
    let share = |k: u32| f64::from(k) / f64::from(PLACES);
    let best = (0..=PLACES).min_by(|i, j| at(share(*i)).total_cmp(&at(share(*j)))).unwrap_or(0);
    let (mut lo, mut hi) = (share(best.saturating_sub(1)), share((best + 1).min(PLACES)));
    for _ in 0..40 {
        let (s, t) = (lo + (hi - lo) / 3.0, hi - (hi - lo) / 3.0);
        if at(s) < at(t) { hi = t } else { lo = s }
    }
    at(0.5 * (lo + hi))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]
    /// Axes that stand still, lean and turn, cutters with round, bull nose and flat ends.
    #[test]
    fn what_is_left_is_as_brute_force_finds(
        which in 0_usize..3, high in 0.0..0.4_f64, step in 0.5..1.5_f64, stride in 0.5..3.0_f64,
        lean in prop::array::uniform2(-0.3..0.3_f64), turning in 0.0..0.1_f64,
        upright: bool,
    ) {
        let cutter = [Cutter::mill(4.0, 2.0, 9.0), Cutter::mill(4.0, 0.5, 9.0), Cutter::mill(3.0, 0.0, 9.0)][which];
        let profile = Profile::new(&cutter).unwrap();
        let tool = Tool::Solid(&profile);
        let surface = waved(high);
        // Passes along x; each position touches the surface's place below it, and may cut in beside it.
        let pose = |x: f64, y: f64| {
            let place = surface.at(x / 2.0, y / 2.0);
            let n = place.u.cross(&place.v).normalize();
            let n = if n.z < 0.0 { -n } else { n };
            let turn = turning * trig::sin(1.3 * x + 0.4 * y);
            let ta = if upright { Vec3::z() } else { Vec3::new(lean[0] + turn, lean[1] - turn, 1.0).normalize() };
            let still = Pose { te: Vec3::zeros(), ta };
            Pose { te: place.point - tool.farthest(&still, -n), ta }
        };
        let row = |by: f64| std::iter::successors(Some(0.0), move |x| (*x < 8.0).then(|| (x + by).min(8.0)));
        let mut poses = Vec::new();
        for (i, y) in row(step).enumerate() {
            let mut pass: Vec<_> = row(stride).map(|x| pose(x, y)).collect();
            if i % 2 == 1 {
                pass.reverse();
            }
            poses.extend(pass);
        }
        let ways: Vec<[Pose; 2]> = poses.windows(2).map(|w| [w[0], w[1]]).collect();
        let sheet = Arc::new(Sheet::bare(&surface).unwrap());
        let left = |height: f64| {
            let extent = Extent::Box([[0.0, 4.0]; 2]);
            let asked = Scallop { height, extent, excused: None, links: Vec::new() };
            let cusps = Cusps::new(&sheet, 1.0, 0.0, 1e-3, &asked);
            let swath = Swath::new(&profile, false, &ways, 0.3 * cusps.room);
            cusps.judge(&swath, || &swath, 1e-9, 0, 1)
        };
        // Between what is proved and what is refuted.
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..12 {
            let middle = 0.5 * (low + high);
            match left(middle) {
                Left::Proved => high = middle,
                Left::Higher(height, way) => {
                    prop_assert!(height > middle && way < ways.len());
                    low = middle;
                }
                Left::Open(..) | Left::Ends(..) => {
                    prop_assert!(high - low < 1e-2, "not decided from {low} to {high}");
                    low = middle;
                }
            }
        }
        // The farthest place at a height: the best ones of a grid, and uphill from there.
        let farthest = |height: f64| {
            let away = |[u, v]: [f64; 2]| {
                let place = surface.at(u, v);
                let x = place.point + place.u.cross(&place.v).normalize() * (height + 1e-3);
                let reach = |w: &[Pose; 2]| 2.0 * profile.widest() + (w[1].te - w[0].te).norm();
                let near = ways.iter().filter(|w| (x - w[0].te).norm() < reach(w));
                near.map(|w| nearest(&tool, w, x)).fold(f64::INFINITY, f64::min)
            };
            let grid = (0..=20_i32).flat_map(|i| (0..=20_i32).map(move |j| [i, j].map(|i| 0.2 * f64::from(i))));
            let mut all: Vec<_> = grid.map(|at| (away(at), at)).collect();
            all.sort_by(|a, b| b.0.total_cmp(&a.0));
            let uphill = |&(mut d, mut at): &(f64, [f64; 2])| {
                let mut step = 0.15;
                for k in 0..30 {
                    let (s, c) = trig::sin_cos(2.4 * f64::from(k));
                    let tries = [[c, s], [-s, c], [-c, -s], [s, -c]];
                    let tried = tries.map(|t| [0, 1].map(|i| (at[i] + step * t[i]).clamp(0.0, 4.0)));
                    let best = tried.map(|at| (away(at), at)).into_iter().max_by(|a, b| a.0.total_cmp(&b.0));
                    match best {
                        Some(better) if better.0 > d => (d, at) = better,
                        _ => step *= 0.7,
                    }
                }
                d
            };
            all.iter().take(6).map(uphill).fold(f64::NEG_INFINITY, f64::max)
        };
        prop_assert!(high > 0.999 || farthest(high) <= 1e-7, "proved {high}: {}", farthest(high));
        prop_assert!(low <= 0.0 || farthest(low - 0.02) > 0.0, "refuted {low}: {}", farthest(low - 0.02));
    }
}
