//! Surfaces with charts against brute force.

use std::sync::atomic::{AtomicU32, Ordering};

use super::*;
use crate::between::between_poses;
use crate::demand::Demand;
use crate::sheet::tests::quadrics;
use crate::sheets::Sheets;
use aptc_cldata::{Controlled, Position, Relation};
use aptc_geometry::{Cutter, Form, Profile, Vec3, trig};
use proptest::prelude::*;
use std::sync::Arc;

fn cutters() -> [Cutter; 4] {
    [
        Cutter::mill(2.0, 1.0, 6.0),
        Cutter::mill(3.0, 0.5, 6.0),
        Cutter::mill(2.0, 0.0, 5.0),
        Cutter { e: 0.5, beta_deg: 15.0, ..Cutter::mill(1.0, 0.0, 3.0) },
    ]
}

fn controlled(form: &Form, side: i8) -> Controlled {
    Controlled {
        name: aptc_cldata::NameRef::default(),
        form: Arc::new(form.clone()),
        relation: Relation::To,
        side,
        open: false,
        nth: 1,
        thick: 0.0,
        disk: None,
        intol: 0.0,
        outtol: 0.0,
    }
}

/// Quadrics, and surfaces by two parameters.
fn surfaces() -> Vec<Form> {
    quadrics().into_iter().chain(crate::sheet::forms::parametric()).collect()
}

/// Points of the whole tool, its inside too.
fn flesh(profile: &Profile, pose: &Pose) -> Vec<Vec3> {
    let u = crate::solid::any_across(pose.ta);
    let w = pose.ta.cross(&u);
    let mut out = Vec::new();
    for i in 0..=10 {
        let (s, c) = trig::sin_cos(f64::from(i) * std::f64::consts::PI / 10.0);
        let [x, z] = profile.support(s, -c).point;
        for k in 0..=2 {
            let x = x * f64::from(k) / 2.0;
            for j in 0..20 {
                let (s, c) = trig::sin_cos(f64::from(j) * std::f64::consts::TAU / 20.0);
                out.push(pose.te + z * pose.ta + x * (c * u + s * w));
            }
        }
    }
    out
}

/// Motions that were not decided, of all that are tried.
static UNDECIDED: AtomicU32 = AtomicU32::new(0);

/// Not decided is an answer, but a rare one.
fn rare(limit: f64) -> Result<(), TestCaseError> {
    let n = UNDECIDED.fetch_add(1, Ordering::Relaxed);
    prop_assert!(n < 12, "{n} were not decided, the last against {limit}");
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(192))]
    /// The bounds of a vector hold what the nearest points of the surface, found another way, say.
    #[test]
    fn bounds_hold_what_sampling_finds(
        which in 0_usize..18, c in 0_usize..4, right: bool,
        te in prop::array::uniform3(-5.0..5.0_f64), v in prop::array::uniform3(-1.0..1.0_f64),
        lean in prop::array::uniform2(-0.3..0.3_f64), turn in prop::array::uniform2(-0.05..0.05_f64),
        turning: bool, band in prop::array::uniform2(0.0..1.0_f64),
    ) {
        let form = &surfaces()[which];
        let surface = aptc_geometry::Surface::from_form(form).unwrap();
        let profile = Profile::new(&cutters()[c]).unwrap();
        let up = |x: f64, y: f64| Vec3::new(x, y, 1.0).normalize();
        let (te, v) = (Vec3::from(te), Vec3::from(v));
        let a = Position { te, ta: up(lean[0], lean[1]) };
        let ta = if turning { up(lean[0] + turn[0], lean[1] + turn[1]) } else { a.ta };
        let b = Position { te: te + v, ta };
        let side = if right { 1.0 } else { -1.0 };
        // The gap by sampling the tool, from above.
        let mut seen = (f64::INFINITY, f64::NEG_INFINITY);
        let sampled = |t: f64| {
            let pose = between_poses(
                &Pose { te: a.te, ta: a.ta }, &Pose { te: b.te, ta: b.ta }, t);
            flesh(&profile, &pose)
                .into_iter()
                .map(|p| surface.foot(p))
                // Beside a border there is no inside: what lies there is held by no side of the surface.
                .filter(|f| f.shape.k[0].is_finite())
                .map(|f| side * f.distance)
                .fold(f64::INFINITY, f64::min)
        };
        for i in 0..=2 {
            let g = sampled(f64::from(i) / 2.0);
            seen = (seen.0.min(g), seen.1.max(g));
        }
        if !(seen.0.is_finite() && seen.1.is_finite()) {
            return Ok(());
        }
        let mut demand = Demand::new(&controlled(form, if right { 1 } else { -1 }), &Sheets::default());
        // A band that is open above: proved only if no sample lies below.
        demand.least = seen.0 - band[0] * 0.2 + 0.05;
        demand.most = f64::INFINITY;
        match demand.judge(&profile, &a, &b, 1e-9) {
            Verdict::Proved { low, .. } => {
                prop_assert!(seen.0 >= demand.least - 1e-8, "proved {} {:?}", demand.least, seen);
                prop_assert!(seen.0 >= low - 1e-8, "{} {:?}", low, seen);
            }
            Verdict::Refuted { gap, .. } => {
                prop_assert!(gap < demand.least, "{} {}", gap, demand.least);
                // The samples are coarse: they lie above the gap by no more than their distance.
                prop_assert!(seen.0 < demand.least + 0.6, "refuted {} {:?}", demand.least, seen);
            }
            Verdict::Undecided { .. } if demand.least >= 0.0 => rare(demand.least)?,
            Verdict::Undecided { .. } => {}
        }
        // And one open below.
        demand.least = f64::NEG_INFINITY;
        demand.most = seen.1 + band[1] * 0.2 - 0.1;
        match demand.judge(&profile, &a, &b, 1e-9) {
            Verdict::Proved { high, .. } => prop_assert!(high <= demand.most + 1e-8),
            Verdict::Refuted { gap, te } => {
                // Where it says so no sample of the tool lies nearer.
                let g = sampled((te - a.te).norm() / v.norm().max(1e-300));
                // From above alone a tool that is wholly on the other side is as far away.
                prop_assert!(gap <= g + 1e-8 || g < 0.0, "refuted {} {} {}", demand.most, gap, g);
                prop_assert!(gap > demand.most);
            }
            Verdict::Undecided { .. } if demand.most >= 0.0 => rare(demand.most)?,
            Verdict::Undecided { .. } => {}
        }
    }
}

/// A flat end in `z = p x^2 + q y^2` touches with its sharp rim at both sides, at any depth that THICK asks for.
#[test]
fn a_sharp_rim_in_a_hollow_is_decided_at_any_depth() {
    let cutter = Cutter::mill(4.0, 0.0, 9.0);
    let profile = Profile::new(&cutter).unwrap();
    let p = 0.05;
    for q in [0.04, 0.03, 0.0, -0.05] {
        let mut ten = [0.0; 10];
        (ten[0], ten[1], ten[9]) = (p, q, -0.5);
        let form = Form::Quadric(aptc_geometry::Quadric {
            kind: aptc_geometry::QuadricKind::Qadric,
            c: ten,
        });
        for depth in [0.0, 0.01, 0.2, -0.05] {
            // The foot of the rim's point at x = 2, its height by the normal there.
            let mut x = 2.0_f64;
            for _ in 0..50 {
                let w = (1.0 + 4.0 * p * p * x * x).sqrt();
                x = 2.0 - depth * 2.0 * p * x / w;
            }
            let z = p * x * x - depth / (1.0 + 4.0 * p * p * x * x).sqrt();
            let at = Position::upright(Vec3::new(0.0, 0.0, z));
            let asked =
                |thick| Controlled { thick, intol: 1e-6, outtol: 1e-6, ..controlled(&form, -1) };
            let judge = |c: Controlled| {
                Demand::new(&c, &Sheets::default()).judge(&profile, &at, &at, 1e-11)
            };
            let verdict = judge(asked(-depth));
            assert!(matches!(verdict, Verdict::Proved { .. }), "{q} {depth} {verdict:?}");
            // What is told lies between the band and the truth.
            for off in [3e-6, -3e-6] {
                match judge(asked(-depth + off)) {
                    Verdict::Refuted { gap, .. } => assert!((gap + depth).abs() < 2e-6, "{gap}"),
                    // How far a tool is above its depth is not always decided.
                    Verdict::Undecided { .. } if off < 0.0 => {}
                    verdict => panic!("{q} {depth} {off} {verdict:?}"),
                }
            }
        }
    }
}

/// A leaning flat end whose rim is in an upright wall by its tolerance stands on the side where it is.
#[test]
fn the_rim_of_a_leaning_tool_in_its_tolerance_is_on_its_side() {
    let form = &crate::sheet::forms::parametric()[3];
    // The wall is the plane y = 1.
    let spot = Spot { chart: 20, at: [0.5, 0.5] };
    let positive = Sheet::new(form).unwrap().jet(&spot).n.y;
    let profile = Profile::new(&Cutter::mill(2.0, 0.0, 5.0)).unwrap();
    for away in [1.0, -1.0] {
        for lean in [0.05, 0.2] {
            let ta = Vec3::new(0.0, away * lean, 1.0).normalize();
            let te = Vec3::new(0.0, 1.0 + away * (ta.z - 1e-4), 0.3);
            let at = Position { te, ta };
            let side = if away * positive > 0.0 { 1 } else { -1 };
            let c = Controlled { intol: 2e-4, outtol: 1e-4, ..controlled(form, side) };
            let verdict = Demand::new(&c, &Sheets::default()).judge(&profile, &at, &at, 1e-11);
            assert!(matches!(verdict, Verdict::Proved { .. }), "{away} {lean} {verdict:?}");
            let c = Controlled { side: -side, ..c };
            let verdict = Demand::new(&c, &Sheets::default()).judge(&profile, &at, &at, 1e-11);
            assert!(matches!(verdict, Verdict::Refuted { .. }), "{away} {lean} {verdict:?}");
        }
    }
}

/// A ball beside a quarter of a cone: in the band where it should be, by closed form.
#[test]
fn the_thickness_of_a_polyconic_moves_its_surface() {
    let Form::Polyconic(p) = crate::sheet::forms::polyconic(false) else { unreachable!() };
    let profile = Profile::new(&cutters()[0]).unwrap();
    // The section of radius 1 + d about the x axis, its normal to the outside but for its lean.
    let lean = 6.0_f64 / 37.0_f64.sqrt();
    for thickness in [0.0, 0.25, -0.25] {
        let form =
            Form::Polyconic(Arc::new(aptc_geometry::Polyconic { thickness, ..(*p).clone() }));
        let jet = Sheet::new(&form).expect("conics").jet(&Spot { chart: 40, at: [0.5, 0.5] });
        let side: i8 = if jet.n.y + jet.n.z > 0.0 { 1 } else { -1 };
        // Centre of the ball at 45 degrees. From start to end the section turns with the y axis towards the z axis: its
        // product with the length, to which the thickness is counted, points outwards.
        let radius = 1.5 + (1.0 + thickness) / lean;
        let half = radius * std::f64::consts::FRAC_1_SQRT_2;
        let at = Position::upright(Vec3::new(0.0, half, half - 1.0));
        let c = Controlled { intol: 1e-6, outtol: 1e-6, ..controlled(&form, side) };
        let verdict = Demand::new(&c, &Sheets::default()).judge(&profile, &at, &at, 1e-9);
        assert!(matches!(verdict, Verdict::Proved { .. }), "{thickness} {verdict:?}");
        let off = Controlled { thick: 1e-5, ..c };
        let verdict = Demand::new(&off, &Sheets::default()).judge(&profile, &at, &at, 1e-9);
        assert!(matches!(verdict, Verdict::Refuted { .. }), "{thickness} {verdict:?}");
    }
}

/// The least signed distance of a cylinder's skin, its bottom at `te`, by samples and a search to and fro about the best.
fn deepest_by_force(
    surface: &aptc_geometry::Surface,
    at: &Position,
    [r, low, high]: [f64; 3],
) -> f64 {
    let [u, w] = aptc_geometry::surface::frame_about(at.ta);
    // The face by its radius, the flank by its height.
    let point = |flank: bool, x: f64, turn: f64| {
        let (s, c) = trig::sin_cos(turn);
        let (rho, z) = if flank { (r, x.clamp(low, high)) } else { (x.clamp(0.0, r), low) };
        at.te + at.ta * z + (u * c + w * s) * rho
    };
    let mut found = f64::INFINITY;
    for (flank, from, to) in [(true, low, high), (false, 0.0, r)] {
        let gap = |x: f64, turn: f64| surface.foot(point(flank, x, turn)).distance;
        let mut best = (f64::INFINITY, 0.0, 0.0);
        for i in 0..=24 {
            for k in 0..48 {
                let (x, turn) = (from + (to - from) * f64::from(i) / 24.0, f64::from(k) * 0.131);
                let g = gap(x, turn);
                best = if g < best.0 { (g, x, turn) } else { best };
            }
        }
        let mut step = 0.1;
        while step > 1e-10 {
            let ways = [
                (1.0, 0.0),
                (-1.0, 0.0),
                (0.0, 1.0),
                (0.0, -1.0),
                (1.0, 1.0),
                (1.0, -1.0),
                (-1.0, 1.0),
                (-1.0, -1.0),
            ];
            let near = ways.map(|(a, b)| (best.1 + a * step, best.2 + b * step));
            let near = near.map(|(x, turn)| (gap(x, turn), x, turn));
            let next = near.into_iter().min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
            if next.0 < best.0 { best = next } else { step *= 0.5 }
        }
        found = found.min(best.0);
    }
    found
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]
    /// How deep a cylinder or a disk stands in a dome: what sampling finds is proved, a tenth of a millionth less is refuted.
    #[test]
    fn a_tool_in_a_dome_is_as_deep_as_sampling_finds(
        bend in prop::array::uniform2(0.005..0.2_f64), sunk in 0.005..0.3_f64, thin: bool,
        xy in prop::array::uniform2(-3.0..3.0_f64), lean in prop::array::uniform2(-0.5..0.5_f64),
    ) {
        let c = [bend[0], bend[1], 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5];
        let form = Form::Quadric(aptc_geometry::Quadric { kind: aptc_geometry::QuadricKind::Qadric, c });
        let surface = aptc_geometry::Surface::from_form(&form).unwrap();
        let (r, h) = (1.3, 20.0);
        let cutter = Cutter::mill(2.0 * r, 0.0, h);
        let (profile, skin) = if thin {
            (Profile::disk(r, 0.2).unwrap(), [r, 0.2, 0.2])
        } else {
            (Profile::new(&cutter).unwrap(), [r, 0.0, h])
        };
        let ta = Vec3::new(lean[0], lean[1], 1.0).normalize();
        let [x, y] = xy;
        let top = -(bend[0] * x * x + bend[1] * y * y);
        // Moved along the axis until it stands as deep as that.
        let at = |z: f64| Position { te: Vec3::new(x, y, top) + ta * z, ta };
        assert!(surface.foot(Vec3::new(0.0, 0.0, 50.0)).distance > 0.0, "above is outside");
        let (mut low, mut high) = (-8.0, 8.0);
        for _ in 0..40 {
            let middle: f64 = 0.5 * (low + high);
            let deep = deepest_by_force(&surface, &at(middle), skin) < -sunk;
            *(if deep { &mut low } else { &mut high }) = middle;
        }
        let at = at(high);
        let gap = deepest_by_force(&surface, &at, skin);
        prop_assume!((gap + sunk).abs() < 0.01);
        let mut demand = Demand::new(&controlled(&form, 1), &Sheets::default());
        demand.least = f64::NEG_INFINITY;
        for (above, proved) in [(1e-7, true), (1e-9, true), (-1e-7, false)] {
            demand.most = gap + above;
            let verdict = demand.judge(&profile, &at, &at, 1e-9);
            let holds = matches!(verdict, Verdict::Proved { .. });
            prop_assert!(holds == proved, "{above:e} {gap} {verdict:?}");
            // What the vectors before found does not change it.
            let mut warm = Warm::default();
            for far in [0.9, -0.4, 0.0] {
                let there = Position { te: at.te + Vec3::new(far, far, 0.0), ta };
                let verdict = demand.judge_next(&profile, &there, &there, 1e-9, &mut warm);
                let holds = matches!(verdict, Verdict::Proved { .. });
                prop_assert!(far != 0.0 || holds == proved, "{above:e} {gap} {verdict:?}");
            }
        }
    }
}

/// The deepest point of a flat end that slides over a dome stays where the dome is highest, and goes from one place of the end to
/// another: no point of the tool is as deep all along.
#[test]
fn a_flat_end_that_slides_over_a_dome_is_proved_to_the_edge_of_its_band() {
    let c = [0.015, 0.033, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5];
    let kind = aptc_geometry::QuadricKind::Qadric;
    let form = Form::Quadric(aptc_geometry::Quadric { kind, c });
    let profile = Profile::new(&Cutter::mill(5.3, 0.0, 20.0)).unwrap();
    let at = |x: f64, y: f64| Position { te: Vec3::new(x, y, -0.0457), ta: Vec3::z() };
    let (from, to) = (at(0.5, 0.3), at(-1.5, 1.2));
    let mut demand = Demand::new(&controlled(&form, 1), &Sheets::default());
    demand.least = f64::NEG_INFINITY;
    for (above, proved) in [(1e-9, true), (-1e-7, false)] {
        demand.most = -0.0457 + above;
        let verdict = demand.judge(&profile, &from, &to, 1e-10);
        assert_eq!(matches!(verdict, Verdict::Proved { .. }), proved, "{above:e} {verdict:?}");
    }
}
