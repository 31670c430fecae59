//! Hollows along a way: what is shown of a piece holds for all its points.

use std::cell::Cell;
use std::sync::Arc;

use super::*;
use crate::beside::Ways;
use crate::tool::{Pose, Tool};
use aptc_geometry::sculptured::{
    Knot, MeshKind, MeshSpacing, MeshSpline, Smoothing, SurfaceDefinition, SurfaceShape,
};
use aptc_geometry::{Cutter, Form, Profile, trig};
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

/// A bowl or a trough of three by two patches, 12 by 8, with waves in it.
fn bowl([round, across, wave]: [f64; 3]) -> Sheet {
    let row = |j: i32| {
        let at = |i: i32| {
            let (x, y) = (4.0 * f64::from(i) - 6.0, 4.0 * f64::from(j) - 4.0);
            let waves = wave * trig::sin(1.1 * x + 0.6 * y);
            let point = Vec3::new(x, y, 0.5 * (round * x * x + across * y * y) + waves);
            Knot { point, ..Knot::default() }
        };
        MeshSpline { smoothing: Smoothing::default(), knots: (0..4).map(at).collect() }
    };
    let shape = SurfaceShape::Mesh {
        kind: MeshKind::Smesh,
        spacing: MeshSpacing::Xyz,
        splines: (0..3).map(row).collect(),
    };
    let form = Form::Ssurf(Arc::new(SurfaceDefinition::plain(shape)));
    Sheet::new(&form).expect("it has charts")
}

/// No direction farther off than told is one in which what is swept is nearest to the middle of the piece: to both sides the
/// distance falls.
fn is_met(valley: &Valley<'_>, tile: &Tile, met: &Met) -> Result<(), TestCaseError> {
    let on = valley.along.cross(&met.n);
    prop_assert!(met.n.dot(&valley.along).abs() < 1e-12);
    for side in [1.0, -1.0] {
        let at = |k: u32| {
            let turn = side * (met.off + 1e-3 * f64::from(k));
            let n = met.n * trig::cos(turn) + on * trig::sin(turn);
            n.dot(&(tile.c - valley.whole.tool.farthest(&valley.whole.a, n)))
        };
        for k in 0..30 {
            prop_assert!(at(k + 1) <= at(k) + 1e-12, "{k} {met:?}");
        }
    }
    Ok(())
}

/// Of a piece that is seen to be spanned no place is nearer to the tool on its way than its border, or than what the standing
/// tool shows: in bowls, and over crests, where most are not.
#[test]
fn nothing_in_a_piece_is_nearer_than_its_border() {
    let one = || -1.0_f64..1.0;
    let all = (
        (-0.25_f64..0.25, -0.02_f64..0.25, 0.0_f64..0.03, any::<bool>()),
        ([one(), one()], 0.0_f64..360.0, 0.02_f64..0.6, -0.1_f64..0.1),
        (0.0_f64..0.001, [one(), one()]),
    );
    let counts = Cell::new([0_u32; 2]);
    let mut runner = TestRunner::new(Config::with_cases(400));
    let check =
        runner.run(&all, |((round, across, wave, ball), (at, turn, far, rise), (room, lean))| {
            let sheet = bowl([round, across, wave]);
            let corner = if ball { 1.0 } else { 0.7 };
            let profile = Profile::new(&Cutter::mill(2.0, corner, 8.0)).unwrap();
            let tool = Tool::Solid(&profile);
            let tilt = if ball || lean[0] > 0.5 { 0.3 } else { 0.9 };
            let ta = Vec3::new(tilt * lean[0], tilt * lean[1], 1.0).normalize();
            // Down to the surface, and from there both ways along it.
            let mut te = Vec3::new(3.0 * at[0], 2.0 * at[1], 9.0);
            let charts = sheet.pieces(&[[f64::NEG_INFINITY, f64::INFINITY]; 2]);
            let tiles: Vec<Tile> = charts.iter().map(|p| sheet.tile(p)).collect();
            let mut n = Vec3::z();
            for _ in 0..8 {
                let stands = Pose { te, ta };
                let near = |t: &Tile| (tool.near(&stands, t.c).0, t.n);
                let least = tiles.iter().map(near).min_by(|a, b| a.0.total_cmp(&b.0));
                let (gap, normal) = least.expect("pieces");
                (te.z, n) = (te.z - gap, normal);
            }
            let v = Vec3::new(trig::cos_deg(turn), trig::sin_deg(turn), rise) * far;
            let v = v - n * v.dot(&n);
            let te = te - v * 0.5;
            let pose = |t: f64| Pose { te: te + v * t, ta };
            let near = |p: Vec3| tool.near(&pose(0.0), p).0.min(tool.near(&pose(1.0), p).0);
            let beside: Vec<Patch> =
                charts.iter().filter(|p| near(sheet.tile(p).c) < 0.3).copied().collect();
            let at = |p: &Patch, s: [f64; 2]| {
                let at = [0, 1].map(|i| p.at[i] + s[i] * p.half[i]);
                sheet.jet(&Spot { chart: p.chart, at }).p
            };
            let share = |i: i32| 0.1 * f64::from(i);
            let all = (-10..=10).flat_map(|i| (-10..=10).map(move |j| [i, j].map(share)));
            let all: Vec<[f64; 2]> = all.collect();
            let least = beside.iter().flat_map(|p| all.iter().map(|s| near(at(p, *s))));
            // So much less than what both ends have.
            let enough = least.fold(f64::INFINITY, f64::min) - room;
            let sweep = Sweep::new(&tool, pose(0.0), pose(1.0), 0.0);
            let quarters = |p: &Patch| p.halves(0).map(|p| p.halves(1)).concat();
            let ways = Ways::new(&sweep);
            let Some(corner) = Corner::new(&sweep, enough) else { return Ok(()) };
            for p in beside.iter().flat_map(quarters).flat_map(|p| quarters(&p)) {
                let tile = sheet.tile(&p);
                let valley =
                    Valley::new(ways.ends(), &sweep, &corner, &sheet, p.spot(), corner.met(&tile));
                let Some(valley) = valley else { continue };
                if let Some(met) = valley.met(&tile).filter(|met| met.off < 0.1) {
                    is_met(&valley, &tile, &met)?;
                }
                let [n, spanned] = counts.get();
                let Seen::Spanned { low, .. } = valley.see(&sheet, &p, &tile) else {
                    counts.set([n + 1, spanned]);
                    continue;
                };
                counts.set([n + 1, spanned + 1]);
                let on_way = |s: [f64; 2]| sweep.meet(at(&p, s)).distance;
                let border = (-10..=10).flat_map(|i| {
                    let s = share(i);
                    [[s, -1.0], [s, 1.0], [-1.0, s], [1.0, s]]
                });
                let border = border.map(on_way).fold(enough + low, f64::min);
                for s in &all {
                    let inside = on_way(*s);
                    // The border is seen at some places only.
                    prop_assert!(inside >= border - 1e-4, "{inside} {border} {s:?}");
                }
            }
            Ok(())
        });
    check.unwrap();
    let [seen, spanned] = counts.get();
    assert!(spanned > 300 && seen - spanned > 300, "{seen} {spanned}");
}
