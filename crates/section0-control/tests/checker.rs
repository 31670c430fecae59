//! The checker checked: paths that were spoiled at random places are refuted where they are wrong, by as much
//! as they are, and brute force never contradicts a proof.
//!
//! The judge is a search over the skin of the tool with the distances of `geometry`; it shares no bound with the proof.
//! `APTC_CHECKER=n` sets the number of cut vectors that are held against it, and of spoiled places to a fiftieth. Each
//! kind of surface comes as often as the others, and so does each way to spoil a path.

#[path = "../../section2-arelem/tests/support/mod.rs"]
mod support;

#[path = "support/milled.rs"]
mod milled;

#[path = "support/proved.rs"]
mod proved;

#[path = "support/skin.rs"]
mod skin;

use std::collections::BTreeMap;
use std::sync::Arc;

use aptc_cldata::Control;
use aptc_geometry::{Cutter, Profile, Vec3};
use proved::{Case, HELD, Random, asked, cases, cases_of, judge};
use skin::{Brute, between};

/// Places of a vector of a spoiled motion at which the judge looks.
const PLACES: u32 = 8;
/// The same where the proof tells more than these show.
const FINER: u32 = 512;

/// Spoils a motion along a surface of a kind, at a vector at random and in one of five ways: a position moved or removed, a larger
/// tool, an end beyond the check surface, a wider holder. The band that it had; `None` where this way does not spoil it.
fn spoil(case: &mut Case, (way, kind): (u32, &str), random: &mut Random) -> Option<f64> {
    let n = case.points.len();
    let i = random.below(n);
    let (band, normal) = case.leaving(kind, &case.points[i])?;
    let cutter = case.cutter;
    match way {
        0 => {
            let sign = if random.below(2) == 0 { 1.5 } else { -1.5 };
            case.points[i].te += normal * (sign * band);
        }
        1 if n > 2 => {
            case.points.remove(random.below(n - 1));
        }
        2 if cutter.alpha_deg == 0.0 && cutter.beta_deg == 0.0 && cutter.diameter > 0.0 => {
            let ball = cutter.corner_radius >= 0.5 * cutter.diameter;
            let corner = if ball { 2.0 * band } else { 0.0 };
            case.cutter = Cutter::mill(
                cutter.diameter + 4.0 * band,
                cutter.corner_radius + corner,
                cutter.height,
            );
        }
        3 if !case.control.checks.is_empty() => {
            let from = if n > 1 { case.points[n - 2].te } else { case.start.te };
            let way = (case.points[n - 1].te - from).try_normalize(0.0)?;
            let check = &case.control.checks[0];
            case.points[n - 1].te += way * (2.0 * (check.intol + check.outtol));
        }
        4 if kind == HELD => {
            let brute = Brute::new(&cutter, &case.control, &case.start)?;
            case.control = wider(&case.control, brute.room(&case.points[i]) + 1.5 * band);
        }
        _ => return None,
    }
    Some(band)
}

/// With a shank and a holder of straight cylinders, wider by `more` than what is there is at most.
fn wider(control: &Control, more: f64) -> Arc<Control> {
    let mut control = Control::clone(control);
    for raised in control.milling.iter_mut().flat_map(|m| m.holder.iter_mut()) {
        let height = raised.profile.height();
        let cutter = Cutter::mill(2.0 * (raised.profile.widest() + more), 0.0, height);
        raised.profile = Profile::new(&cutter).expect("a cylinder");
    }
    Arc::new(control)
}

#[test]
fn brute_force_never_contradicts_a_proof() {
    let cases = cases();
    let mut random = Random(1990);
    let mut kinds: BTreeMap<&str, u32> = BTreeMap::new();
    let (mut looked, mut nearest) = (0, f64::INFINITY);
    while looked < asked() {
        let (case, _) = cases.draw(&mut random);
        let Some(brute) = Brute::new(&case.cutter, &case.control, &case.start) else { continue };
        let i = random.below(case.points.len());
        let from = if i == 0 { &case.start } else { &case.points[i - 1] };
        let last = i + 1 == case.points.len();
        let size = case.points[i].te.norm() + brute.profile.reach();
        for k in 0..=4 {
            let t = if k == 4 {
                1.0
            } else {
                0.25 * (f64::from(k) + random.below(1000) as f64 / 1000.0)
            };
            let excess = brute.at(&between(from, &case.points[i], t), last && k == 4);
            assert!(excess <= 1e-9 * size, "{} vector {i} at {t}: {excess}", case.program);
            nearest = nearest.min(-excess);
        }
        looked += 1;
        case.kinds().into_iter().for_each(|k| *kinds.entry(k).or_default() += 1);
    }
    println!(
        "{looked} cut vectors of {} motions at 5 places each, none beyond its band: {kinds:?}",
        cases.all.len()
    );
}

#[test]
fn what_was_spoiled_is_refuted_in_the_right_place() {
    let cases = cases();
    let mut random = Random(360);
    let mut kinds: BTreeMap<&str, u32> = BTreeMap::new();
    let (mut spoiled, mut harmless) = ([0_u32; 5], 0_u32);
    let wanted = u32::try_from(asked() / 50).expect("few");
    while spoiled.iter().sum::<u32>() < wanted {
        let (whole, surface) = cases.draw(&mut random);
        let kind = spoiled.iter().sum::<u32>() % 5;
        let last = whole.points.len() - 1;
        let mut case = whole.around(if kind == 3 { last } else { random.below(last + 1) });
        let n = case.points.len();
        let Some(band) = spoil(&mut case, (kind, surface), &mut random) else { continue };
        let Some(brute) = Brute::new(&case.cutter, &case.control, &case.start) else { continue };
        let worst = brute.worst(&case.start, &case.points, PLACES);
        let found = judge(&case);
        let fault = found.statements[0].fault.clone();
        let what = format!("{} {surface} kind {kind} of {n}: {worst} {fault:?}", case.program);
        if worst < 0.02 * band {
            // A vertex on a straight line, a wider tool that is ON: nothing was spoiled.
            let wrong = fault.is_some_and(|f| {
                f.refuted && f.depth > 0.05 * band && !f.surface.starts_with("check surface")
            });
            assert!(!wrong, "{what}");
            harmless += 1;
            continue;
        }
        let fault = fault.unwrap_or_else(|| panic!("not found: {what}"));
        assert!(fault.refuted, "{what}");
        spoiled[kind as usize] += 1;
        case.kinds().into_iter().for_each(|k| *kinds.entry(k).or_default() += 1);
        let vector = usize::try_from(fault.vector).expect("a number") - 1;
        if fault.surface.starts_with("check surface") && vector + 1 < case.points.len() {
            // It passes its check surface on the way, which the judge does not ask.
            continue;
        }
        // A narrow worst place may lie between those that are looked at.
        let finer = || brute.worst(&case.start, &case.points, FINER);
        let worst = if fault.depth > 1.1 * worst { finer() } else { worst };
        assert!(
            fault.depth >= 0.8 * worst - 0.02 * band && fault.depth <= 1.2 * worst + 0.02 * band,
            "{what}"
        );
        // At the place that is told the judge finds that depth.
        let from = if vector == 0 { case.start } else { case.points[vector - 1] };
        let to = case.points[vector];
        let way = to.te - from.te;
        let te = Vec3::from(fault.te);
        let t = if way.norm() > 0.0 { (te - from.te).dot(&way) / way.norm_squared() } else { 1.0 };
        let place = between(&from, &to, t.clamp(0.0, 1.0));
        assert!((place.te - te).norm() <= 1e-6 * (1.0 + te.norm()), "beside the vector: {what}");
        let there = brute.at(&place, vector + 1 == case.points.len() && t > 1.0 - 1e-9);
        assert!((there - fault.depth).abs() <= 0.02 * band + 0.05 * worst, "{there} there: {what}");
    }
    println!(
        "moved, removed, larger tool, overrun, wider holder: {spoiled:?} refuted: {kinds:?}; {harmless} changes left the path right"
    );
}

/// Most points of the tool that lie behind one face's plane are far from the face, whose edge is what the tool is too near.
#[test]
fn a_vector_taken_away_round_an_edge_is_refuted_by_as_much() {
    const BAND: f64 = 0.02;
    const ALONG: u32 = 32;
    let mut found = 0;
    for whole in cases_of("motion/prow") {
        for i in 0..whole.points.len() - 1 {
            let mut case = whole.clone();
            case.points.remove(i);
            let Some(brute) = Brute::new(&case.cutter, &case.control, &case.start) else {
                continue;
            };
            let from = if i == 0 { case.start } else { case.points[i - 1] };
            let share = |k: u32| f64::from(k) / f64::from(ALONG);
            let at = |k| brute.at(&between(&from, &case.points[i], share(k)), false);
            let worst = (0..=ALONG).map(at).fold(0.0, f64::max);
            if worst < BAND / 20.0 {
                continue;
            }
            let fault = judge(&case).statements[0].fault.clone().expect("a fault");
            let what = format!("vector {i}: {worst} {fault:?}");
            assert!(fault.refuted, "{what}");
            assert!((fault.depth - worst).abs() <= 0.2 * worst + 0.02 * BAND, "{what}");
            found += 1;
        }
    }
    assert!(found >= 20, "{found}");
}
