//! What a place of the surface that goes along with the tool shows of the gap.

use std::cell::Cell;

use super::*;
use crate::between::between_poses;
use crate::sheet::{forms, forms::chart, tests::quadrics};
use aptc_geometry::{Cutter, Profile};
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

/// On straight parameters between two places the tool, which goes straight and does not turn, is nowhere farther than what is told.
#[test]
fn the_gap_rises_by_no_more_than_what_is_told() {
    let forms: Vec<_> = forms::parametric().into_iter().chain(quadrics()).collect();
    let sheets: Vec<_> = forms.iter().map(|form| Sheet::new(form).unwrap()).collect();
    let one = || -1.0_f64..1.0;
    let all = (
        (0..sheets.len(), prop::collection::vec(any::<bool>(), 14), [one(), one()]),
        ([one(), one()], 0.001_f64..0.5, any::<bool>(), 0_usize..3),
        ([one(), one()], -0.03_f64..0.06, [one(), one(), one()], 0.0_f64..0.2),
    );
    let counts = Cell::new([0_u32; 2]);
    let mut runner = TestRunner::new(Config::with_cases(6000));
    let check = runner.run(
        &all,
        |((which, walk, at), (to, far, side, kind), (lean, above, off, drift))| {
            let sheet = &sheets[which];
            let whole = chart(sheet, &walk);
            let inside = |at: [f64; 2]| {
                let at = [0, 1].map(|i| whole.at[i] + at[i].clamp(-1.0, 1.0) * whole.half[i]);
                Spot { chart: whole.chart, at }
            };
            let spots = [inside(at), inside([at[0] + far * to[0], at[1] + far * to[1]])];
            let jets = spots.map(|spot| sheet.jet(&spot));
            let m = if side { jets[0].n } else { -jets[0].n };
            let [x, y] = aptc_geometry::surface::frame_about(m);
            let ta = (x * lean[0] + y * lean[1] - m).normalize();
            let profile = Profile::new(&Cutter::mill(1.0, [0.5, 0.2, 0.35][kind], 4.0)).unwrap();
            let tool = Tool::Solid(&profile);
            let foot = tool.farthest(&Pose { te: Vec3::zeros(), ta }, m);
            let te = jets[0].p - foot - m * above;
            // With the place, but for a little.
            let way = jets[1].p - jets[0].p;
            let poses = [te, te + way + Vec3::from(off) * (drift * way.norm())];
            let poses = poses.map(|te| Pose { te, ta });
            let touch = |i: usize| {
                let gap = tool.near(&poses[i], jets[i].p).0;
                Touch {
                    t: i as f64,
                    pose: poses[i],
                    gap,
                    spot: spots[i],
                    jet: jets[i],
                    second: sheet.bent(&spots[i]).1,
                    next: spots[i],
                }
            };
            let (a, b) = (touch(0), touch(1));
            let moved = (way - (poses[1].te - poses[0].te)).norm();
            let [yes, no] = counts.get();
            let Some(rise) = rise(&tool, sheet, &a, &b, moved) else {
                counts.set([yes, no + 1]);
                return Ok(());
            };
            counts.set([yes + 1, no]);
            for i in 0..=20 {
                let t = 0.05 * f64::from(i);
                let pose = between_poses(&poses[0], &poses[1], t);
                let at = [0, 1].map(|k| spots[0].at[k] + t * (spots[1].at[k] - spots[0].at[k]));
                let gap = tool.near(&pose, sheet.jet(&Spot { at, ..spots[0] }).p).0;
                let told = a.gap + t * (b.gap - a.gap) + 4.0 * t * (1.0 - t) * rise;
                prop_assert!(gap <= told + 1e-9, "{gap} {told} {t} {rise}");
            }
            Ok(())
        },
    );
    check.unwrap();
    let [yes, no] = counts.get();
    assert!(yes > 1500, "{yes} {no}");
}
