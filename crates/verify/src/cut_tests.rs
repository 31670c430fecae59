//! Searches that go on from the last one: no place is nearer than they say.

use super::*;
use crate::between::{angle, between_poses};
use crate::search::{Aim, FOLD, Lead, clearance_from};
use crate::sheet::{Sheet, Spot, forms};
use crate::tool::Tool;
use aptc_geometry::{Cutter, Vec3};
use proptest::prelude::*;

/// Places all over the surface, its continuations too.
fn places(sheet: &Sheet) -> Vec<Spot> {
    let all = sheet.pieces(&[[f64::NEG_INFINITY, f64::INFINITY]; 2]);
    let at = |i: i32| [-1.0, -0.4, 0.3, 1.0].map(move |x| (i, x));
    let in_piece = at(0).into_iter().flat_map(|(_, s)| at(1).map(|(_, t)| [s, t]));
    let in_piece: Vec<[f64; 2]> = in_piece.collect();
    let of = |p: &Patch| {
        let (chart, at, half) = (p.chart, p.at, p.half);
        in_piece
            .clone()
            .into_iter()
            .map(move |st| Spot { chart, at: [0, 1].map(|i| at[i] + st[i] * half[i]) })
    };
    all.iter().flat_map(of).collect()
}

proptest! {
    /// No distance changes by more than the way from one position to another.
    #[test]
    fn distances_change_by_the_way_at_most(
        corner in 0.0_f64..1.0, te in prop::array::uniform3(-1.0..1.0_f64), small: bool,
        lean in prop::array::uniform4(-1.0..1.0_f64), q in prop::array::uniform3(-9.0..9.0_f64),
    ) {
        let profile = Profile::new(&Cutter::mill(2.0, corner, 6.0)).unwrap();
        let tool = Tool::Solid(&profile);
        let up = |x: f64, y: f64| Vec3::new(x, y, 1.0).normalize();
        let to = Vec3::from(te) * if small { 0.0 } else { 1.0 };
        let a = Pose { te: Vec3::zeros(), ta: up(lean[0], lean[1]) };
        let b = Pose { te: to, ta: up(lean[2], lean[3]) };
        let far = way(&Sweep::still(&tool, a), &a, &b);
        let [near, then] = [a, b].map(|at| tool.near(&at, Vec3::from(q)).0);
        prop_assert!((near - then).abs() <= far + 1e-9, "{near} {then} {far}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]
    /// On a walk of many vectors no place of the surface is nearer than each search says that goes on from the last, also
    /// where now and then another tool is held against it, or the surface to its other side.
    #[test]
    fn no_place_is_nearer_on_a_walk(
        which in 0_usize..9, corner in 0.0_f64..1.0, held in 0_usize..3, right: bool, shift in -0.2_f64..0.2,
        te in prop::array::uniform3(-5.0..5.0_f64), short in -0.1_f64..0.5,
        steps in prop::collection::vec((prop::array::uniform5(-1.0..1.0_f64), 0_usize..8), 12), turning: bool,
    ) {
        let sheet = Sheet::new(&forms::parametric()[which]).expect("it has charts");
        let profile = Profile::new(&Cutter::mill(2.0, corner, 6.0)).unwrap();
        let tools = [Tool::End, Tool::Raised(&profile, 3.0), Tool::Solid(&profile)];
        let side = if right { 1.0 } else { -1.0 };
        let moved = |side| Moved { sheet: &sheet, side, shift, fold: FOLD, overlaps: false, only: None };
        let points = |side| -> Vec<Vec3> {
            places(&sheet).iter().map(|spot| moved(side).place(spot)).collect()
        };
        let points = [side, -side].map(|side| (side, points(side)));
        let least = |pose: &Pose, tool: &Tool<'_>, points: &[Vec3]| {
            points.iter().map(|p| tool.near(pose, *p).0).fold(f64::INFINITY, f64::min)
        };
        let mut pose = Pose { te: Vec3::from(te), ta: Vec3::z() };
        let mut lead = Lead::default();
        for ([x, y, z, p, q], other) in steps {
            let [way, turn] = if turning && other % 2 == 0 { [0.02, 0.06] } else { [0.2, 0.0] };
            let ta = (pose.ta + Vec3::new(p, q, 0.0) * turn).normalize();
            let to = Pose { te: pose.te + Vec3::new(x, y, 0.2 * z) * way, ta };
            let tool = &tools[if other == 0 { (held + 1) % 3 } else { held }];
            let (side, points) = &points[usize::from(other == 1)];
            let enough = least(&Pose { te: Vec3::from(te), ta: Vec3::z() }, tool, points) - short;
            let sweep = Sweep::new(tool, pose, to, angle(pose.ta, to.ta));
            let found = clearance_from(&sweep, &moved(*side), enough, Aim::Clear, &mut lead);
            // What falls short is not searched to its end.
            for i in (0..=3).filter(|_| found.least >= enough) {
                let at = between_poses(&pose, &to, f64::from(i) / 3.0);
                let near = least(&at, tool, points);
                prop_assert!(near >= found.least - 1e-9, "{near} {found:?} {}", lead.cut.went_on);
            }
            pose = to;
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]
    /// A tool that comes straight to the surface, turning or not, is not told to be clear of it when it is no more: no
    /// group comes nearer sooner than its way says.
    #[test]
    fn a_tool_that_comes_to_the_surface_is_told_in_time(
        which in 0_usize..9, corner in 0.0_f64..1.0, end: bool, shift in -0.2_f64..0.2, steps in 3_i32..40,
        te in prop::array::uniform3(-9.0..9.0_f64), enough in -0.1_f64..0.3, lean in prop::array::uniform2(-0.5..0.5_f64),
    ) {
        let sheet = Sheet::new(&forms::parametric()[which]).expect("it has charts");
        let profile = Profile::new(&Cutter::mill(0.5, 0.25 * corner, 3.0)).unwrap();
        let tool = if end { Tool::End } else { Tool::Solid(&profile) };
        let moved = Moved::whole(&sheet, 1.0, shift);
        let points: Vec<Vec3> = places(&sheet).iter().map(|spot| moved.place(spot)).collect();
        let near = |pose: &Pose| {
            let all = points.iter().map(|p| (tool.near(pose, *p).0, *p));
            all.min_by(|a, b| a.0.total_cmp(&b.0)).expect("places")
        };
        let from = Pose { te: Vec3::from(te), ta: Vec3::z() };
        let to = Vec3::new(lean[0], lean[1], 1.0).normalize();
        let to = Pose { te: near(&from).1, ta: if te[0] > 0.0 { to } else { from.ta } };
        let turn = angle(from.ta, to.ta) / f64::from(steps);
        let mut lead = Lead::default();
        for i in 0..steps {
            let [a, b] = [i, i + 1]
                .map(|i| between_poses(&from, &to, f64::from(i) / f64::from(steps)));
            let sweep = Sweep::new(&tool, a, b, turn);
            let found = clearance_from(&sweep, &moved, enough, Aim::Clear, &mut lead);
            // What falls short is not searched to its end.
            for at in [a, b].iter().filter(|_| found.least >= enough) {
                prop_assert!(near(at).0 >= found.least - 1e-9, "{i} {found:?} {}", lead.cut.went_on);
            }
        }
    }
}

/// A cut is kept from one vector to the next for as long as the same is asked, and for nothing else.
#[test]
fn a_cut_serves_what_it_was_made_for() {
    let sheet = Sheet::new(&forms::parametric()[7]).expect("it has charts");
    let [ball, flat] = [1.0, 0.2].map(|r| Profile::new(&Cutter::mill(2.0, r, 6.0)).unwrap());
    let [tool, high] = [Tool::Solid(&ball), Tool::Raised(&ball, 1.0)];
    let moved = Moved::whole(&sheet, 1.0, 0.1);
    let at = |x: f64| Pose { te: Vec3::new(x, 0.3, 1.5), ta: Vec3::z() };
    let search = |lead: &mut Lead, tool: &Tool<'_>, moved: &Moved<'_>, enough: f64, x: f64| {
        let sweep = Sweep::new(tool, at(x), at(x + 0.01), 0.0);
        let found = clearance_from(&sweep, moved, enough, Aim::Clear, lead);
        assert!(found.least >= enough, "{found:?}");
        found.least
    };
    let mut lead = Lead::default();
    search(&mut lead, &tool, &moved, 0.1, 0.0);
    assert!(!lead.cut.went_on);
    search(&mut lead, &tool, &moved, 0.1, 0.01);
    assert!(lead.cut.went_on, "the next vector goes on");
    search(&mut lead.clone(), &tool, &moved, 0.1, 0.05);
    assert!(lead.cut.went_on, "also beyond a gap");
    let others = [
        (&Tool::Solid(&flat), moved, 0.1),
        (&high, moved, 0.1),
        (&Tool::End, moved, 0.1),
        (&tool, Moved { side: -1.0, ..moved }, 0.1),
        (&tool, Moved { shift: 0.2, ..moved }, 0.1),
        (&tool, moved, 0.05),
    ];
    for (tool, moved, enough) in others {
        let mut kept = lead.clone();
        let mut fresh = Lead { direction: lead.direction, ..Lead::default() };
        let [a, b] =
            [&mut kept, &mut fresh].map(|l| search(l, tool, &moved, enough, 0.02).to_bits());
        assert!(!kept.cut.went_on && a == b, "{tool:?} {moved:?} {enough}: {a} {b}");
    }
    // A search that broke off leaves nothing: the axis turns too far for any piece, whatever its size.
    let over = Pose { te: at(0.02).te, ta: Vec3::x() };
    let sweep = Sweep::new(&tool, at(0.02), over, angle(Vec3::z(), Vec3::x()));
    let found = clearance_from(&sweep, &moved, 0.1, Aim::Clear, &mut lead);
    assert!(found.least < 0.1 && lead.cut.last.is_none(), "{found:?}");
    search(&mut lead, &tool, &moved, 0.1, 0.02);
    assert!(!lead.cut.went_on);
}
