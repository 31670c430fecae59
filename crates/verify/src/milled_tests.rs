//! Surfaces of CHKSRF against brute force.

use std::sync::atomic::{AtomicU32, Ordering};

use super::*;
use crate::sheet::forms::parametric;
use crate::sheet::tests::quadrics;
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
        checked: Vec::new(),
        plain: Vec::new(),
        holder: Vec::new(),
        guarded: false,
        intol,
        outtol: intol,
        scallop: None,
        joined: false,
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
        let sampled = (0..=3).map(|i| deepest(&surface, &solid(f64::from(i) / 3.0)));
        let depth = -sampled.fold(f64::INFINITY, f64::min);
        // Now more, now less than what is found.
        let intol = if depth > 0.0 { depth * share } else { 0.01 * share };
        let plain = Plain { name: NameRef::default(), form: Arc::new(form.clone()) };
        // The cutter itself is far away where the holder is judged.
        let cutter = Profile::new(&Cutter::mill(0.1, 0.0, 0.1)).unwrap();
        // The middle of the solid tells the side: a tool without size that comes from there.
        let point = Profile::new(&Cutter::mill(0.0, 0.0, 0.0)).unwrap();
        let middle = solid(0.0).te + a.ta * (0.5 * (profile.bottom() + profile.height()));
        let from = Position { te: middle, ta: a.ta };
        let milling = milling(intol);
        let asked = MilledSurface::plain(&plain, &milling, &Sheets::default(), (&point, &from));
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
                let found = deepest(&surface, &there);
                let closed = Solid::new(form).is_some();
                let found = if closed { found.min(beyond(&surface, &there, middle)) } else { found };
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
