//! Surfaces of CHKSRF against brute force.

use std::sync::atomic::{AtomicU32, Ordering};

use super::*;
use crate::sheet::forms::parametric;
use crate::sheet::tests::quadrics;
use crate::solid::Solid;
use aptc_geometry::sculpt::{SplinePoint, mesh};
use aptc_geometry::sculptured::MeshSpacing;
use aptc_geometry::surface::kept;
use aptc_geometry::{Cone, Cutter, Cylinder, Plane, Sphere, Surface, Tabcyl, Vec2, Vec3, trig};
use proptest::prelude::*;

fn cutters() -> [Cutter; 4] {
    [
        Cutter::mill(2.0, 1.0, 6.0),
        Cutter::mill(3.0, 0.5, 6.0),
        Cutter::mill(2.0, 0.0, 5.0),
        Cutter { e: 0.5, beta_deg: 15.0, ..Cutter::mill(1.0, 0.0, 3.0) },
    ]
}

fn tabcyl() -> Form {
    let knot = |i: i32| {
        let x = f64::from(i) - 4.0;
        aptc_geometry::Knot { point: Vec2::new(x, 0.9 * trig::sin(x)), tangent: None }
    };
    let knots: Vec<_> = (0..9).map(knot).collect();
    let own = |e: Vec3| e * e.transpose();
    let axes = own(Vec3::x()) + own(Vec3::z()) - own(Vec3::y());
    let t = Tabcyl::fit(&knots, aptc_geometry::Fit::Spline, axes, 1.0);
    Form::Tabcyl(Arc::new(t.expect("a curve")))
}

/// One of every kind that is not sculptured.
fn forms() -> Vec<Form> {
    let t = Vec3::new(2.0, -1.0, 2.0) / 3.0;
    let mut all = vec![
        Form::Plane(Plane { n: t, d: 1.0 }),
        Form::Sphere(Sphere { center: Vec3::new(0.5, 0.0, -1.0), radius: 1.5 }),
        Form::Sphere(Sphere { center: Vec3::new(0.0, 1.0, 0.0), radius: 9.0 }),
        Form::Cylinder(Cylinder { point: Vec3::zeros(), axis: t, radius: 1.0 }),
        Form::Cylinder(Cylinder { point: Vec3::zeros(), axis: t, radius: 8.0 }),
        Form::Cone(Cone { vertex: Vec3::new(0.0, 0.0, 1.0), axis: -Vec3::z(), cos_half: 0.8 }),
        tabcyl(),
    ];
    all.extend(quadrics());
    all.extend(parametric().into_iter().filter(|f| !matches!(f, Form::Ssurf(_))));
    all
}

/// Nothing asked but what is given.
fn milling(intol: f64) -> Milling {
    Milling {
        part: None,
        on: false,
        risen: false,
        checked: Vec::new(),
        plain: Vec::new(),
        holder: Vec::new(),
        guarded: false,
        intol,
        outtol: intol,
        scallop: None,
        joined: false,
        over: false,
        limits: None,
    }
}

/// The deepest place of the surface in the solid among those that lie beside points all over it, each taken downhill.
fn deepest(surface: &Surface, solid: &aptc_geometry::Tool<'_>) -> f64 {
    const STEPS: u32 = 30;
    let [u, w] = aptc_geometry::surface::frame_about(solid.ta);
    let profile = solid.profile;
    let mut places: Vec<(f64, Vec3)> = Vec::new();
    for i in 0..=4 {
        let z = profile.bottom() + (profile.height() - profile.bottom()) * f64::from(i) / 4.0;
        for j in 0..6 {
            let (s, c) = trig::sin_cos(f64::from(j) * std::f64::consts::TAU / 6.0);
            for x in [0.0, 1.0].map(|k| k * profile.widest()) {
                let q = surface.foot(solid.te + z * solid.ta + x * (c * u + s * w)).point;
                places.push((solid.distance(q), q));
            }
        }
    }
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    let down = |(mut d, mut q): (f64, Vec3)| {
        let mut step = 0.3 * profile.widest();
        for k in 0..STEPS {
            let (s, c) = trig::sin_cos(2.4 * f64::from(k));
            let z = trig::sin(1.7 * f64::from(k));
            let tries = [Vec3::new(c, s, z), Vec3::new(-s, z, c), Vec3::new(z, -c, s)];
            let tried = tries.into_iter().flat_map(|t| [t, -t]).map(|t| {
                let q = surface.foot(q + t * step).point;
                (solid.distance(q), q)
            });
            match tried.min_by(|a, b| a.0.total_cmp(&b.0)) {
                Some(better) if better.0 < d => (d, q) = better,
                _ => step *= 0.6,
            }
        }
        d
    };
    places.into_iter().take(2).map(down).fold(f64::INFINITY, f64::min)
}

/// How far the solid reaches over to the other side of the surface than that on which `middle` lies.
fn beyond(surface: &Surface, solid: &aptc_geometry::Tool<'_>, middle: Vec3) -> f64 {
    let side = 1.0_f64.copysign(surface.foot(middle).distance);
    let [u, w] = aptc_geometry::surface::frame_about(solid.ta);
    let mut least = f64::INFINITY;
    for i in 0..=40 {
        let (s, c) = trig::sin_cos(f64::from(i) * std::f64::consts::PI / 40.0);
        let [x, z] = solid.profile.support(s, -c).point;
        for j in 0..40 {
            let (s, c) = trig::sin_cos(f64::from(j) * std::f64::consts::TAU / 40.0);
            let p = solid.te + z * solid.ta + x * (c * u + s * w);
            least = least.min(side * surface.foot(p).distance);
        }
    }
    least
}

/// The same of the inside of a convex solid together with all that lies above it: how far a point is from that is
/// least among the places below the point.
fn beyond_open(inside: &Surface, solid: &aptc_geometry::Tool<'_>) -> f64 {
    const FAR: f64 = 40.0;
    let far = |p: Vec3| {
        let below = |s: f64| inside.distance(p - solid.ta * s);
        let (mut from, mut to) = (0.0, FAR);
        for _ in 0..60 {
            let (a, b) = (from + (to - from) / 3.0, to - (to - from) / 3.0);
            if below(a) <= below(b) { to = b } else { from = a }
        }
        below(0.5 * (from + to)).min(below(0.0))
    };
    let [u, w] = aptc_geometry::surface::frame_about(solid.ta);
    let mut most = f64::NEG_INFINITY;
    for i in 0..=30 {
        let (s, c) = trig::sin_cos(f64::from(i) * std::f64::consts::PI / 30.0);
        let [x, z] = solid.profile.support(s, -c).point;
        for j in 0..30 {
            let (s, c) = trig::sin_cos(f64::from(j) * std::f64::consts::TAU / 30.0);
            most = most.max(far(solid.te + z * solid.ta + x * (c * u + s * w)));
        }
    }
    // Within it nothing is told.
    if most > 0.0 { -most } else { f64::INFINITY }
}

/// Motions that were not decided, of all that are tried.
static UNDECIDED: AtomicU32 = AtomicU32::new(0);

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]
    /// What is proved holds of each place of the surface, and what is refuted is so, of the cutter and of what stands
    /// above it, with an axis that turns too.
    #[test]
    fn what_is_checked_is_clear_as_brute_force_finds(
        which in 0_usize..23, c in 0_usize..4, up in 0.0..5.0_f64, holds: bool,
        te in prop::array::uniform3(-4.0..4.0_f64), v in prop::array::uniform3(-1.0..1.0_f64),
        lean in prop::array::uniform2(-0.4..0.4_f64), turn in prop::array::uniform2(-0.2..0.2_f64),
        turning: bool, share in 0.0..2.0_f64,
    ) {
        let forms = forms();
        let Some(form) = forms.get(which) else { return Ok(()) };
        let surface = Surface::from_form(form).unwrap();
        let profile = Profile::new(&cutters()[c]).unwrap();
        let up = if holds { up } else { 0.0 };
        let axis = |x: f64, y: f64| Vec3::new(x, y, 1.0).normalize();
        let a = Position { te: Vec3::from(te), ta: axis(lean[0], lean[1]) };
        let ta = if turning { axis(lean[0] + turn[0], lean[1] + turn[1]) } else { a.ta };
        let b = Position { te: a.te + Vec3::from(v), ta };
        let ends = [a, b].map(|p| Pose { te: p.te, ta: p.ta });
        let solid = |t: f64| {
            let at = between_poses(&ends[0], &ends[1], t);
            aptc_geometry::Tool { profile: &profile, te: at.te + at.ta * up, ta: at.ta }
        };
        let middle = solid(0.0).te + a.ta * (0.5 * (profile.bottom() + profile.height()));
        let inside = kept::with_inside(&surface).filter(|s| s.distance(middle) < 0.0);
        let open = inside.filter(|s| kept::opens(s, (a.ta + ta).normalize()));
        let found = |t: f64| match &open {
            Some(inside) => beyond_open(inside, &solid(t)),
            None => deepest(&surface, &solid(t)),
        };
        let sampled = (0..=3).map(|i| found(f64::from(i) / 3.0));
        let depth = -sampled.fold(f64::INFINITY, f64::min);
        // Now more, now less than what is found.
        let intol = if depth > 0.0 { depth * share } else { 0.01 * share };
        // A middle that is on the surface, as far as is allowed, would be where the axis leads.
        if kept::with_inside(&surface).is_some() && surface.distance(middle).abs() <= intol {
            return Ok(());
        }
        let plain = Plain { name: NameRef::default(), form: Arc::new(form.clone()), thick: 0.0 };
        // The cutter itself is far away where the holder is judged.
        let cutter = Profile::new(&Cutter::mill(0.1, 0.0, 0.1)).unwrap();
        // The middle of the solid tells the side: a tool without size that comes from there.
        let point = Profile::new(&Cutter::mill(0.0, 0.0, 0.0)).unwrap();
        let from = Position { te: middle, ta: a.ta };
        let asked = MilledSurface::plain(&plain, intol, &Sheets::default(), (&point, &from));
        let asked = MilledSurface { holder: holds.then_some(Raised { profile, up }), ..asked };
        let mut seen = Seen::default();
        let own = if holds { &cutter } else { &profile };
        match asked.vector(own, &a, &b, 1e-10, 1, &mut seen) {
            None => {
                prop_assert!(seen.low >= -intol - 1e-9);
                prop_assert!(-depth >= seen.low - 1e-9, "{form:?}: {depth} proved {}", seen.low);
            }
            Some(fault) if fault.refuted => {
                let t = (0..=1000).map(|i| f64::from(i) / 1000.0);
                let off = |t: f64| (solid(t).te - solid(t).ta * up - Vec3::from(fault.te)).norm();
                let t = t.min_by(|s, t| off(*s).total_cmp(&off(*t))).unwrap_or(0.0);
                let there = solid(t);
                let mid = 0.5 * (profile.bottom() + profile.height());
                let middle = solid(0.0).te + solid(0.0).ta * mid;
                let told = -intol - fault.depth;
                // The places between are as far as a step of the way, and samples are not everywhere.
                let room = 2e-3 + 0.02 * fault.depth;
                let found = found(t);
                let closed = Solid::new(form).is_some();
                let found = if closed && open.is_none() { found.min(beyond(&surface, &there, middle)) } else { found };
                let sharp = if closed { 0.5 * fault.depth } else { 0.0 };
                prop_assert!(found <= told + room + sharp, "{form:?}: {found} told {told}");
            }
            Some(fault) => {
                // Not decided is an answer, but a rare one.
                let n = UNDECIDED.fetch_add(1, Ordering::Relaxed);
                prop_assert!(n < 3, "{form:?}: {fault:?}");
            }
        }
    }
}

/// What is told of cutter, holder and the axis between them on a way at the height 0, the tool coming from `from`.
fn told(form: Form, from: Option<Vec3>) -> Vec<(bool, f64)> {
    let profile = Profile::new(&Cutter::mill(10.0, 5.0, 40.0)).unwrap();
    let chuck = Raised { profile: Profile::new(&Cutter::mill(16.0, 0.0, 20.0)).unwrap(), up: 50.0 };
    let plain = vec![Plain { name: NameRef::default(), form: Arc::new(form), thick: 0.0 }];
    let milling = Milling { plain, holder: vec![chuck], ..milling(0.01) };
    let at = |x: f64| Position { te: Vec3::x() * x, ta: Vec3::z() };
    let (a, b) = (at(-1.0), at(1.0));
    let from = from.map_or(a, |te| Position { te, ..a });
    let region = Region::new(&milling, &Sheets::default(), &profile, &from).unwrap();
    let judged = region.surfaces().iter().map(|s| {
        let fault = s.vector(&profile, &a, &b, 1e-10, 1, &mut Seen::default());
        fault
            .map_or((false, 0.0), |f| (f.why.is_some(), if f.refuted { f.depth } else { f64::NAN }))
    });
    judged.collect()
}

/// The depths beyond what is allowed, to a tenth of them.
fn near(form: Form, from: Option<Vec3>, wanted: [f64; 3]) {
    let found = told(form.clone(), from);
    let off = found.iter().zip(wanted).map(|((_, d), w)| (d - w).abs() - 0.1 * w - 0.02);
    assert!(
        found.len() == 3 && off.clone().all(|x| x <= 0.0),
        "{form:?}: {found:?}, not {wanted:?}"
    );
}

const ABOVE: Option<Vec3> = Some(Vec3::new(0.0, 0.0, 90.0));
const INSIDE: Option<Vec3> = Some(Vec3::new(0.0, 0.0, 1.0));

fn sphere(center: Vec3, radius: f64) -> [Form; 2] {
    let c = center * -1.0;
    let last = center.norm_squared() - radius * radius;
    let c = [1.0, 1.0, 1.0, last, 0.0, 0.0, 0.0, c.x, c.y, c.z];
    let kind = aptc_geometry::QuadricKind::Qadric;
    [Form::Sphere(Sphere { center, radius }), Form::Quadric(aptc_geometry::Quadric { kind, c })]
}

#[test]
fn the_side_is_that_from_which_the_tool_comes() {
    let plane = |n: Vec3, z: f64| Form::Plane(Plane { n, d: z * n.z });
    for n in [Vec3::z(), -Vec3::z()] {
        near(plane(n, 45.0), INSIDE, [0.0, 25.0, 5.0]);
        near(plane(n, 45.0), ABOVE, [45.0, 0.0, 5.0]);
        near(plane(n, -3.0), ABOVE, [0.0; 3]);
        near(plane(n, 75.0), INSIDE, [0.0; 3]);
        near(plane(n, 45.0), None, [0.0, 25.0, 5.0]);
    }
}

#[test]
fn a_bowl_is_open_above_and_solid_for_who_comes_from_outside() {
    let center = Vec3::new(0.0, 0.0, 6.0);
    for from in [INSIDE, None] {
        for radius in [9.0, 8.5, 90.0] {
            for form in sphere(center, radius) {
                near(form, from, [0.0, f64::max(9.0 - radius, 0.0), 0.0]);
            }
        }
        // A roof over a tool that had room below it does not count.
        for form in sphere(Vec3::new(0.0, 0.0, 30.0), 50.0) {
            near(form, from, [0.0; 3]);
        }
    }
    let [ball, own] = sphere(center, 9.5);
    near(ball.clone(), ABOVE, [14.5, 0.0, 0.0]);
    let [ball, own] = [ball, own].map(|form| told(form, ABOVE)[0]);
    assert!(ball.0 && own.0 && own.1 > 0.0, "{ball:?} {own:?}");
    // Far below the shell, which no part of the tool touches.
    for form in sphere(center, 400.0) {
        let all = told(form, Some(Vec3::z() * 900.0));
        assert!(all.iter().all(|(why, depth)| *why && *depth > 300.0), "{all:?}");
    }
}

#[test]
fn the_axis_between_cutter_and_holder_meets_what_stands_there() {
    for form in sphere(Vec3::new(0.0, 0.0, 45.0), 2.0) {
        let found = told(form, ABOVE);
        assert!(found[0].1 == 0.0 && found[1].1 == 0.0 && found[2].1 > 0.0, "{found:?}");
    }
    for form in sphere(Vec3::new(0.0, 2.5, 45.0), 2.0) {
        near(form, ABOVE, [0.0; 3]);
    }
    // z = 45 + xy / 10 and z = -9 + xy / 10, which have no sides.
    let kind = aptc_geometry::QuadricKind::Qadric;
    let saddle = |z: f64| {
        let c = [0.0, 0.0, 0.0, z, 0.0, 0.0, 0.05, 0.0, 0.0, -0.5];
        Form::Quadric(aptc_geometry::Quadric { kind, c })
    };
    let found = told(saddle(45.0), ABOVE);
    assert!(found[0].1 == 0.0 && found[1].1 == 0.0 && found[2].1 > 0.0, "{found:?}");
    near(saddle(-9.0), ABOVE, [0.0; 3]);
}

/// How deep beyond what is allowed a way at the height 0 is told to be beside a plane at the height 45, behind these records.
fn told_after(before: Vec<aptc_cldata::Kind>) -> f64 {
    use aptc_cldata::{Control, Kind, Motion, MotionKind, Record};
    let plain = Form::Plane(Plane { n: Vec3::z(), d: 45.0 });
    let plain = vec![Plain { name: NameRef::default(), form: Arc::new(plain), thick: 0.0 }];
    let control =
        Control { milling: Some(Milling { plain, ..milling(0.01) }), ..Control::default() };
    let at = |x: f64| Position { te: Vec3::x() * x, ta: Vec3::z() };
    let cut = Kind::Motion(Motion {
        kind: MotionKind::Continuous,
        points: vec![at(-1.0), at(1.0)],
        control: Some(Arc::new(control)),
        ..Motion::default()
    });
    let cutter = Kind::Cutter(Cutter::mill(10.0, 5.0, 50.0));
    let mut verifier = crate::Verifier::new(crate::Effort::Full);
    for kind in std::iter::once(cutter).chain(before).chain([cut]) {
        let isn = u32::from(matches!(&kind, Kind::Motion(m) if m.control.is_some()));
        let origin = aptc_diagnostics::Origin { isn, ..Default::default() };
        verifier.push(&Record { origin, kind });
    }
    let fault = verifier.finish().0.statements.pop().and_then(|s| s.fault);
    fault.map_or(0.0, |f| if f.refuted { f.depth } else { f64::NAN })
}

#[test]
fn only_the_last_motion_before_a_statement_tells_its_side() {
    use aptc_cldata::{Kind, Motion, MotionKind};
    let motion = |kind, z: f64| {
        let points = vec![Position { te: Vec3::z() * z, ta: Vec3::z() }];
        Kind::Motion(Motion { kind, points, ..Motion::default() })
    };
    let from = || motion(MotionKind::From, 90.0);
    let word = |word: &str| Kind::Post { word: word.into(), args: Vec::new() };
    let near = |before, wanted: f64| {
        let found = told_after(before);
        assert!((found - wanted).abs() < 0.1 * wanted + 0.02, "{found}, not {wanted}");
    };
    // The cutter, 50 high, stands by 5 above the plane, or it comes from above.
    near(vec![from(), motion(MotionKind::Goto, 2.0)], 5.0);
    near(vec![from()], 45.0);
    near(vec![motion(MotionKind::Goto, 2.0), motion(MotionKind::Goto, 90.0)], 45.0);
    for post in ["CYCLE", "LOADTL", "RETRCT", "GOHOME"] {
        near(vec![from(), word(post)], 45.0);
    }
    // Nothing was put out before: the first place.
    near(Vec::new(), 5.0);
}

#[test]
fn a_ruled_wall_is_told_as_deep_as_it_is_nearer_than_the_radius() {
    // Upright rulings along a quarter of a circle of radius 40 about the z axis, higher than the cutter of radius 5.
    let arc = |z: f64| {
        let center = Vec3::z() * z;
        let at = |x: f64, y: f64| center + Vec3::new(x, y, 0.0) * 40.0;
        let circle = aptc_geometry::Circle { center, axis: Vec3::z(), radius: 40.0 };
        let surface = Arc::new(Form::Circle(circle));
        let toward = Vec3::new(1.0, 1.0, 0.0);
        aptc_geometry::Rail { surface, start: at(1.0, 0.0), end: at(0.0, 1.0), toward }
    };
    let second = aptc_geometry::Second::Rail(arc(80.0));
    let ruled = aptc_geometry::RuledSurface { first: arc(-20.0), second };
    let plain = vec![Plain {
        name: NameRef::default(),
        form: Arc::new(Form::Ruled(Arc::new(ruled))),
        thick: 0.0,
    }];
    let milling = Milling { plain, ..milling(0.01) };
    let at = |rho: f64, along: f64| {
        let te = Vec3::new(rho - along, rho + along, 0.0) * 0.5_f64.sqrt();
        Position { te, ta: Vec3::z() }
    };
    for corner in [0.0, 5.0] {
        let profile = Profile::new(&Cutter::mill(10.0, corner, 50.0)).unwrap();
        // Straight on along the tangent, straight in, and where it stands.
        let ways = [
            ([at(43.0, -9.0), at(43.0, 15.0)], 2.0),
            ([at(60.0, 0.0), at(42.0, 0.0)], 3.0),
            ([at(36.0, 0.0); 2], 1.0),
        ];
        for ([a, b], deep) in ways {
            let region = Region::new(&milling, &Sheets::default(), &profile, &a).unwrap();
            let judge =
                |s: &MilledSurface| s.vector(&profile, &a, &b, 1e-10, 1, &mut Seen::default());
            let fault = region.surfaces().iter().find_map(judge).unwrap();
            let deep = deep - 0.01;
            assert!(
                fault.refuted && fault.depth <= deep + 1e-6 && fault.depth > 0.9 * deep,
                "{fault:?}"
            );
            let te = Vec3::from(fault.te);
            let off = (trig::hypot(te.x, te.y) - 40.0).abs();
            assert!((5.0 - off - 0.01 - fault.depth).abs() < 1e-4, "{fault:?}");
        }
    }
}

/// Places that pass the rim of a leaning flat end within, from its side to its bottom, are in no tool as deep as in all that it
/// sweeps, and are proved as they are in each.
#[test]
fn a_leading_rim_is_proved_as_deep_as_it_is_in_each_tool() {
    let at = |i: i32, j: i32| {
        let (x, y) = (4.0 * f64::from(i), 4.0 * f64::from(j));
        SplinePoint::plain(Vec3::new(x, y, 0.0))
    };
    let rows: Vec<Vec<_>> = (0..5).map(|j| (0..5).map(|i| at(i, j)).collect()).collect();
    let sheet = Sheet::bare(&mesh(&rows, MeshSpacing::Xyz).expect("a plane")).unwrap();
    let profile = Profile::new(&Cutter::mill(6.0, 0.0, 20.0)).unwrap();
    let tool = Tool::Solid(&profile);
    let (lean, rim) = (0.12, 0.0054);
    let pose = |x: f64, turned: f64| {
        let (s, c) = trig::sin_cos(lean + turned);
        // The rim ahead stands below the plane.
        Position { te: Vec3::new(x - 3.0 * c, 8.0, 3.0 * s - rim), ta: Vec3::new(s, 0.0, c) }
    };
    for turned in [0.0, 0.02, -0.02] {
        let [a, b] = [pose(6.0, 0.0), pose(9.0, turned)];
        let ends = [a, b].map(|p| Pose { te: p.te, ta: p.ta });
        let places = (0..=6000).map(|i| Vec3::new(4.0 + 0.001 * f64::from(i), 8.0, 0.0));
        let depth = places.fold(0.0, |deepest: f64, x| {
            let in_each = (0..=100)
                .map(|i| tool.near(&between_poses(&ends[0], &ends[1], 0.01 * f64::from(i)), x).0);
            deepest.max(-in_each.fold(f64::INFINITY, f64::min))
        });
        assert!(depth < 0.95 * rim, "{turned}: {depth}");
        let judged = |least: f64| clear(&sheet, &tool, [&a, &b], least, &mut Warm::default());
        let told = judged(-depth - 2e-4);
        assert!(matches!(told, Verdict::Proved { .. }), "{turned}: {depth} {told:?}");
        let told = judged(-depth + 1e-4);
        assert!(matches!(told, Verdict::Refuted { .. }), "{turned}: {depth} {told:?}");
    }
}
