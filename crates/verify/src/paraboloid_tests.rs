//! Pieces next to a corner: what is shown of them holds for all their points.

use std::cell::Cell;

use super::*;
use crate::beside::{Begin, Beside, Ways};
use crate::between::between_poses;
use crate::sheet::Kept;
use crate::sheet::{forms, forms::chart, tests::quadrics};
use crate::tool::{Pose, Tool};
use aptc_geometry::{Cutter, Profile, trig};
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

/// A tool that goes straight into the surface is nowhere told to be clear of the place that it goes through.
#[test]
fn a_way_into_the_surface_shows_nothing_of_it() {
    let profile = Profile::new(&Cutter::mill(1.0, 0.5, 4.0)).unwrap();
    let tool = Tool::Solid(&profile);
    let mut found = 0;
    for (which, form) in forms::parametric().into_iter().chain(quadrics()).enumerate() {
        let sheet = Sheet::new(&form).unwrap();
        for side in [1.0, -1.0] {
            let walk: Vec<bool> = (0..14).map(|i| (which >> (i % 3)) % 2 == 0).collect();
            let whole = chart(&sheet, &walk);
            let half = whole.half.map(|h| 0.01 * h);
            let patch = Patch { kept: Kept::Nowhere, half, ..whole };
            let jet = sheet.jet(&patch.spot());
            let m = jet.n * side;
            let at = |far: f64| Pose { te: jet.p + m * far, ta: -m };
            let sweep = Sweep::new(&tool, at(-0.01), at(2.0), 0.0);
            let corner = Corner::new(&sweep, 0.0).unwrap();
            for begin in [At::Start, At::Between, At::End] {
                let Some(place) = corner.find(&sheet, patch.spot(), begin, m) else { continue };
                found += 1;
                let seen = corner.see(&place, &sheet, &patch, &sheet.tile(&patch));
                assert!(!matches!(seen, Seen::Clear(..)), "{which} {begin:?} {seen:?}");
            }
        }
    }
    assert!(found > 5, "{found}");
}

/// What is shown of a piece next to a corner holds for all its points and the tool all along its way.
#[test]
fn no_point_of_a_piece_is_nearer_than_what_is_shown() {
    let forms: Vec<_> = forms::parametric().into_iter().chain(quadrics()).collect();
    let sheets: Vec<_> = forms.iter().map(|form| Sheet::new(form).unwrap()).collect();
    let one = || -1.0_f64..1.0;
    let all = (
        (0..sheets.len(), prop::collection::vec(any::<bool>(), 14), [one(), one()]),
        ([one(), one()], [0.003_f64..1.0, 0.003_f64..1.0], [one(), one()]),
        (any::<bool>(), 0.0_f64..80.0, 0.0_f64..360.0, 0_usize..4, -0.005_f64..0.08),
        ([one(), one(), one()], 0.0_f64..0.4, -0.02_f64..0.02),
    );
    let (counts, levels) = (Cell::new([0_u32; 3]), Cell::new(0_u32));
    let mut runner = TestRunner::new(Config::with_cases(20_000));
    let check = runner.run(
        &all,
        |(
            (which, walk, at),
            (off, half, within),
            (side, lean, turn, kind, above),
            (way, far, least),
        )| {
            let sheet = &sheets[which];
            let whole = chart(sheet, &walk);
            let at = [0, 1].map(|i| whole.at[i] + 0.9 * at[i] * whole.half[i]);
            let spot = Spot { chart: whole.chart, at };
            let jet = sheet.jet(&spot);
            let m = if side { jet.n } else { -jet.n };
            let [x, y] = aptc_geometry::surface::frame_about(m);
            let across = x * trig::cos_deg(turn) + y * trig::sin_deg(turn);
            let ta = across * trig::sin_deg(lean) - m * trig::cos_deg(lean);
            let corner = [0.5, 0.2, 0.3, 0.45][kind];
            let profile = Profile::new(&Cutter::mill(1.0, corner, 4.0)).unwrap();
            let tool = Tool::Solid(&profile);
            let foot = tool.farthest(&Pose { te: Vec3::zeros(), ta }, m);
            let te = jet.p - foot - m * (above + least);
            let v = Vec3::from(way) * far;
            let v = v - m * (0.9 * v.dot(&m));
            let sweep = Sweep::new(
                &tool,
                Pose { te: te - v * 0.5, ta },
                Pose { te: te + v * 0.5, ta },
                0.0,
            );
            let mut patch = Patch { kept: Kept::Nowhere, ..whole };
            for i in 0..2 {
                // A piece of the chart that is next to the place, or holds it.
                patch.half[i] *= half[i] * half[i];
                patch.at[i] = at[i] + 1.5 * off[i] * patch.half[i];
                let room = whole.half[i] - patch.half[i];
                patch.at[i] = patch.at[i].clamp(whole.at[i] - room, whole.at[i] + room);
            }
            let tile = sheet.tile(&patch);
            let ways = Ways::new(&sweep);
            let mut all = Beside::new(&ways, least, Begin::default());
            let seen = all.see(sheet, &patch, &tile).0;
            let [clear, large, near] = counts.get();
            let Seen::Clear(low, about, level) = seen else {
                let large = large + u32::from(matches!(seen, Seen::Large(_)));
                counts.set([clear, large, near + 1]);
                return Ok(());
            };
            counts.set([clear + 1, large, near]);
            prop_assert!(low >= 0.0);
            for s in [[0.0, 0.0], [1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0], within] {
                let at = [0, 1].map(|k| patch.at[k] + s[k] * patch.half[k]);
                let high = about.dot(&sheet.jet(&Spot { chart: patch.chart, at }).p);
                prop_assert!(level.is_none_or(|level| high >= level - 1e-9), "{level:?} {high}");
            }
            levels.set(levels.get() + u32::from(level.is_some()));
            for i in 0..=10 {
                let pose = between_poses(&sweep.a, &sweep.b, 0.1 * f64::from(i));
                for s in [[0.0, 0.0], [1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0], within] {
                    let at = [0, 1].map(|k| patch.at[k] + s[k] * patch.half[k]);
                    let p = sheet.jet(&Spot { chart: patch.chart, at }).p;
                    let far = tool.near(&pose, p).0;
                    prop_assert!(far >= least + low - 1e-9, "{far} {least} {low} {i} {s:?}");
                }
            }
            Ok(())
        },
    );
    check.unwrap();
    let [clear, large, near] = counts.get();
    let levels = levels.get();
    assert!(clear > 800 && large > 400 && levels > 10, "{clear} {large} {near} {levels}");
}
