//! Random scenes over all pairs of surfaces: the motion is found and stays in its bands, by brute force.
//!
//! `APTC_SCENES` says how many scenes are tried, and `APTC_SCENES_FROM` where to begin.

mod support;

use std::collections::BTreeMap;

use aptc_cldata as cl;
use aptc_geometry::{Profile, Surface, Vec3};
use support::scene::motion;
use support::{Run, brute, run};

fn number(name: &str, otherwise: u64) -> u64 {
    std::env::var(name).ok().and_then(|n| n.parse().ok()).unwrap_or(otherwise)
}

/// By how many bands the motion of the last statement leaves its bands, and what says so.
fn worst(run: &Run) -> (f64, String) {
    let mut profile = Profile::disk(0.0, 0.0).expect("a point");
    let mut last: Option<cl::Position> = None;
    let mut worst = (0.0, String::new());
    for r in &run.cl {
        match &r.kind {
            cl::Kind::Cutter(c) => profile = Profile::new(c).expect("a cutter"),
            cl::Kind::Motion(m) => {
                if let (Some(control), Some(start), cl::MotionKind::Continuous) =
                    (&m.control, last, m.kind)
                {
                    let mut a = start;
                    let every = m.points.len() / 6 + 1;
                    for (i, b) in m.points.iter().enumerate() {
                        let ends = i == 0 || i + 1 == m.points.len();
                        for t in [0.5, 1.0] {
                            let te = a.te + (b.te - a.te) * t;
                            for c in control.drive.iter().chain(&control.part) {
                                if ends || i % every == 0 {
                                    check(&mut worst, c, &profile, te, b.ta);
                                }
                            }
                        }
                        a = *b;
                    }
                    if let Some(c) = control.checks.first() {
                        check(&mut worst, c, &profile, a.te, a.ta);
                    }
                }
                last = m.points.last().copied().or(last);
            }
            _ => {}
        }
    }
    worst
}

fn check(worst: &mut (f64, String), c: &cl::Controlled, profile: &Profile, te: Vec3, ta: Vec3) {
    let surface = Surface::from_form(&c.form).expect("a surface");
    let g = match c.side {
        0 => surface.distance(te),
        side => brute::least(profile, te, ta, &surface, f64::from(side)) - c.thick,
    };
    // With the tool end on a surface both sides are one band's.
    let least = if c.side == 0 { -c.intol.max(c.outtol) } else { -c.intol };
    let most = if c.side == 0 { c.intol.max(c.outtol) } else { c.outtol };
    let slack = 1e-9 * (1.0 + te.norm());
    let off = (least - g).max(g - most) - slack;
    let share = off / (c.intol + c.outtol);
    if share > worst.0 {
        *worst = (share, format!("{} gap {g:e} not in {least:e}..{most:e} at {te:?}", c.name.name));
    }
}

#[test]
fn scenes_over_all_surfaces_are_solved_within_their_bands() {
    let (from, n) = (number("APTC_SCENES_FROM", 0), number("APTC_SCENES", 120));
    let (mut solved, mut refused, mut out) = (0_usize, Vec::new(), Vec::new());
    let mut kinds: BTreeMap<String, u32> = BTreeMap::new();
    for seed in from..from + n {
        let Some(s) = motion(seed, 1.0) else { continue };
        let ran = run(&s.forms, &s.setup);
        if let Some(d) = ran.diagnostics.first() {
            refused.push(format!("{seed}: {} {:?} | {}", d.message, d.notes, s.what));
            continue;
        }
        solved += 1;
        for word in s.what.split(" radius").next().into_iter().flat_map(|w| w.split(" and ")) {
            *kinds.entry(word.to_owned()).or_default() += 1;
        }
        let (share, what) = worst(&ran);
        if share > 1e-3 {
            out.push(format!("{seed}: {share:.3} {what} | {}", s.what));
        }
    }
    println!("{solved} solved, {} refused, {} out of band: {kinds:?}", refused.len(), out.len());
    assert!(out.is_empty() && 100 * refused.len() <= solved, "out {out:#?}\nrefused {refused:#?}");
    assert!(2 * solved > usize::try_from(n).unwrap_or(0), "{solved} of {n} are motions");
}

#[test]
fn scenes_in_another_unit_give_the_same_path() {
    let mut different = Vec::new();
    for seed in 0..number("APTC_SCENES", 120) / 4 {
        let Some(s) = motion(seed, 1.0) else { continue };
        // Where two places of the cutter touch at once rounding decides which comes first, and the path
        // from there on is another one in the same band.
        if s.what.contains("ruled") || s.what.contains("waves") {
            continue;
        }
        let ends = |r: &Run| -> Vec<Vec3> {
            r.motions().flat_map(|(_, m)| m.points.iter().map(|p| p.te)).collect()
        };
        let plain = ends(&run(&s.forms, &s.setup));
        for scale in [25.4, 1e-3] {
            let Some(o) = motion(seed, scale) else { continue };
            let other = ends(&run(&o.forms, &o.setup));
            let apart =
                plain.iter().zip(&other).map(|(p, q)| (p - q / scale).norm() / (10.0 + p.norm()));
            let apart = apart.fold(0.0, f64::max);
            if plain.len() != other.len() || apart > 1e-9 {
                let n = [plain.len(), other.len()];
                different.push(format!("{seed} x {scale} {n:?} {apart:e}: {}", s.what));
            }
        }
    }
    assert!(different.is_empty(), "{different:#?}");
}
