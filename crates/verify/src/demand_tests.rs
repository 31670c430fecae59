//! Closed forms against brute force.

use super::*;
use aptc_geometry::{Cone, Cutter, Cylinder, Sphere, trig};
use proptest::prelude::*;

fn cutters() -> [Cutter; 4] {
    let cone = Cutter { e: 1.0, alpha_deg: 0.0, beta_deg: 15.0, ..Cutter::mill(4.0, 0.0, 12.0) };
    let cone = Cutter { e: 2.0, ..cone };
    [
        Cutter::mill(10.0, 5.0, 30.0),
        Cutter::mill(12.0, 2.0, 30.0),
        Cutter::mill(8.0, 0.0, 25.0),
        cone,
    ]
}

fn forms() -> [Form; 4] {
    let t = Vec3::new(2.0, -1.0, 2.0) / 3.0;
    [
        Form::Plane(Plane { n: t, d: 1.0 }),
        Form::Sphere(Sphere { center: Vec3::new(3.0, 1.0, -20.0), radius: 20.0 }),
        Form::Cylinder(Cylinder { point: Vec3::new(0.0, 2.0, -15.0), axis: t, radius: 12.0 }),
        Form::Cone(Cone { vertex: Vec3::new(0.0, 0.0, 5.0), axis: -Vec3::z(), cos_half: 0.8 }),
    ]
}

/// Points all over the outside of the tool, its faces included.
fn skin(profile: &Profile) -> Vec<(f64, f64)> {
    let corner = |i: i32| {
        let (s, c) = trig::sin_cos(f64::from(i) * std::f64::consts::PI / 80.0);
        let [x, z] = profile.support(s, -c).point;
        (x, z)
    };
    let mut out = vec![(0.0, corner(0).1), (0.0, corner(80).1)];
    for i in 0..80 {
        let (a, b) = (corner(i), corner(i + 1));
        let n = if (a.0 - b.0).abs() + (a.1 - b.1).abs() > 1.0 { 60 } else { 1 };
        out.extend((0..n).map(|k| {
            let t = f64::from(k) / f64::from(n);
            (a.0 + t * (b.0 - a.0), a.1 + t * (b.1 - a.1))
        }));
    }
    let rim = corner(0);
    out.extend((1..60).map(|k| (rim.0 * f64::from(k) / 60.0, rim.1)));
    out
}

/// How far apart the samples are, at most, with a diagonal.
const COARSE: f64 = 0.08;

/// The gap by brute force, and how far apart the points are.
fn brute(profile: &Profile, solid: &Solid, pose: &Pose, within: bool) -> f64 {
    let u = crate::solid::any_across(pose.ta);
    let w = pose.ta.cross(&u);
    let mut least = f64::INFINITY;
    for (x, z) in skin(profile) {
        for i in 0..240 {
            let (s, c) = trig::sin_cos(f64::from(i) * std::f64::consts::TAU / 240.0);
            let d = solid.distance(pose.te + z * pose.ta + x * (c * u + s * w));
            least = least.min(if within { -d } else { d });
        }
    }
    least
}

fn check(
    cutter: &Cutter,
    form: &Form,
    within: bool,
    a: &Position,
    b: &Position,
) -> Result<(), TestCaseError> {
    let profile = Profile::new(cutter).unwrap();
    let solid = Solid::new(form).unwrap();
    if within && matches!(solid, Solid::Half(_)) {
        return Ok(());
    }
    let (least, most) = (f64::NEG_INFINITY, f64::INFINITY);
    let demand = Demand {
        body: Body::Solid(solid),
        side: 1.0,
        within,
        open: false,
        on: false,
        moved: 0.0,
        least,
        most,
    };
    let Verdict::Proved { low, high } = demand.judge(&profile, a, b, 0.0) else {
        return Err(TestCaseError::fail("an open band is always proved"));
    };
    let mut seen = (f64::INFINITY, f64::NEG_INFINITY);
    let mut deep_seen = (f64::INFINITY, f64::NEG_INFINITY);
    for i in 0..=8 {
        let way = Way::new(Pose { te: a.te, ta: a.ta }, Pose { te: b.te, ta: b.ta });
        let pose = way.at(f64::from(i) / 8.0);
        let g = brute(&profile, &solid, &pose, within);
        // A tool sunk beyond its corner is refuted whatever its exact depth, which is then a matter of
        // definition.
        if g < -1.0 {
            return Ok(());
        }
        // The depth of a cut is the way back out. Where the vertex of a cone is in the tool, the tool's
        // points are nearer to the flank than the vertex is to the tool, by the sine of the half angle.
        let deep = |g: f64| match solid {
            Solid::Nappe(.., sin) if g < 0.0 && !within => g / sin,
            _ => g,
        };
        seen = (seen.0.min(g), seen.1.max(g));
        deep_seen = (deep_seen.0.min(deep(g - COARSE)), deep_seen.1.max(deep(g - COARSE)));
        let exact = demand.gap(&Tool::Solid(&profile), &pose, Convex::Solid(&solid));
        prop_assert!(exact <= g + 1e-9, "gap {exact} sampled {g} {solid:?}");
        prop_assert!(exact >= deep(g - COARSE), "gap {exact} sampled {g} {solid:?} {cutter:?}");
    }
    prop_assert!(low <= seen.0 + 1e-9, "{low} {seen:?} {solid:?}");
    prop_assert!(high >= deep_seen.1, "{high} {seen:?} {solid:?}");
    if a.ta == b.ta {
        // Without turning the bounds are the gap itself.
        prop_assert!(low >= deep_seen.0 - 0.1, "loose {low} {seen:?} {solid:?} {cutter:?}");
        prop_assert!(high <= seen.1 + 0.1, "loose {high} {seen:?} {solid:?} {cutter:?}");
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]
    #[test]
    fn bounds_hold_what_sampling_finds(
        te in prop::array::uniform3(-6.0..6.0_f64), v in prop::array::uniform3(-3.0..3.0_f64),
        lean in prop::array::uniform2(-0.3..0.3_f64), turn in prop::array::uniform2(-0.1..0.1_f64),
        c in 0_usize..4, f in 0_usize..4, within: bool,
    ) {
        let up = |x: f64, y: f64| Vec3::new(x, y, 1.0).normalize();
        let (te, v) = (Vec3::from(te), Vec3::from(v));
        let a = Position { te, ta: up(lean[0], lean[1]) };
        let still = Position { te: te + v, ta: a.ta };
        let turned = Position { te: te + v, ta: up(lean[0] + turn[0], lean[1] + turn[1]) };
        check(&cutters()[c], &forms()[f], within, &a, &still)?;
        check(&cutters()[c], &forms()[f], within, &a, &turned)?;
    }
}

proptest! {
    /// What one vector leaves to the next changes no answer: neither the bounds nor where a vector is refuted.
    #[test]
    fn a_walk_is_judged_as_each_of_its_vectors(
        te in prop::array::uniform3(-6.0..6.0_f64), c in 0_usize..4, f in 0_usize..4,
        ways in prop::collection::vec(prop::array::uniform3(-2.0..2.0_f64), 6), lean in prop::array::uniform2(-0.3..0.3_f64),
        open: bool, jump in 0_usize..9,
    ) {
        let (profile, form) = (Profile::new(&cutters()[c]).unwrap(), &forms()[f]);
        let mut demand = Demand::clear(form, 1.0, false, 0.5).expect("a closed form");
        if open {
            (demand.least, demand.most) = (f64::NEG_INFINITY, f64::INFINITY);
        }
        let ta = Vec3::new(lean[0], lean[1], 1.0).normalize();
        let mut from = Position { te: Vec3::from(te), ta };
        let (mut warm, mut told) = (Warm::default(), None);
        for (i, way) in ways.iter().enumerate() {
            if i == jump {
                from.te += Vec3::new(1.0, -1.0, 0.5);
            }
            let to = Position { te: from.te + Vec3::from(*way), ta };
            let alone = demand.judge(&profile, &from, &to, 1e-9);
            warm.told = told;
            let next = demand.judge_next(&profile, &from, &to, 1e-9, &mut warm);
            let same = match (alone, next) {
                (Verdict::Proved { low, high }, Verdict::Proved { low: l, high: h }) => {
                    // What was told before need not be told closer.
                    let close = (low - l).abs() < 1e-10;
                    let enough = told.is_some_and(|told| l >= told - 1e-10) && l <= low + 1e-10;
                    told = Some(told.unwrap_or(f64::INFINITY).min(l));
                    (close || enough) && (high - h).abs() < 1e-10
                }
                (alone, next) => alone == next,
            };
            prop_assert!(same, "{alone:?} {next:?}");
            from = to;
        }
    }
}

/// A shank that passes square through a bar has opposite directions at both ends, and none between them.
#[test]
fn a_way_through_a_solid_is_never_proved() {
    let profile = Profile::new(&Cutter::mill(10.0, 5.0, 80.0)).unwrap();
    let bar = Form::Cylinder(Cylinder { point: Vec3::zeros(), axis: Vec3::x(), radius: 20.0 });
    let ball = Form::Sphere(Sphere { center: Vec3::zeros(), radius: 20.0 });
    for form in [bar, ball] {
        let demand = Demand::clear(&form, 1.0, false, 0.0).expect("a closed form");
        for told in [None, Some(0.0), Some(f64::NEG_INFINITY)] {
            for z in [-40.0, -30.0, -5.1, -5.0, -4.9, 0.0, 10.0] {
                let at = |x: f64, y: f64| Position::upright(Vec3::new(x, y, z));
                for [from, to] in
                    [[at(0.0, 60.0), at(0.0, -60.0)], [at(3.0, 60.0), at(-3.0, -60.0)]]
                {
                    let mut warm = Warm::default();
                    warm.told = told;
                    let found = demand.judge_next(&profile, &from, &to, 1e-9, &mut warm);
                    let deep = matches!(found, Verdict::Refuted { gap, .. } if gap < -5.0);
                    assert!(deep, "{z} {told:?} {found:?}");
                }
            }
        }
    }
}

#[test]
fn a_chord_across_a_cylinder_gouges_by_its_sagitta() {
    // Ball centre on a path of radius 5 about a cylinder of radius 4: chord of angle .2.
    let rod = Form::Cylinder(Cylinder { point: Vec3::zeros(), axis: Vec3::z(), radius: 4.0 });
    let profile = Profile::new(&Cutter::mill(2.0, 1.0, 10.0)).unwrap();
    let solid = Solid::new(&rod).unwrap();
    let at = |angle: f64| {
        let (s, c) = trig::sin_cos(angle);
        Position::upright(5.0 * Vec3::new(c, s, 0.0))
    };
    let sagitta = 0.024_979_173_6;
    let demand = |least| Demand {
        body: Body::Solid(solid),
        side: 1.0,
        within: false,
        open: false,
        on: false,
        moved: 0.0,
        least,
        most: 1e-9,
    };
    let judge = |d: Demand| d.judge(&profile, &at(0.0), &at(0.2), 1e-12);
    match judge(demand(-sagitta - 1e-9)) {
        Verdict::Proved { low, high } => {
            assert!((low + sagitta).abs() < 1e-9 && high.abs() < 1e-12, "{low} {high}");
        }
        v => panic!("{v:?}"),
    }
    match judge(demand(-sagitta + 1e-8)) {
        Verdict::Refuted { gap, .. } => assert!((gap + sagitta).abs() < 1e-9),
        v => panic!("{v:?}"),
    }
}
