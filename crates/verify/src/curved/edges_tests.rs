//! Valleys of two flat faces and pits of four, against the distance of points in closed form.

use std::sync::Arc;

use aptc_cldata::{Controlled, NameRef, Position, Relation};
use aptc_geometry::sculptured::{
    BsplineSurface, Knot, MeshKind, MeshSpacing, MeshSpline, Smoothing, SurfaceDefinition,
    SurfaceShape,
};
use aptc_geometry::{
    Cutter, Fit, Form, Knot as CurveKnot, Profile, Quadric, QuadricKind, Rail, RuledSurface,
    Second, Tabcyl, TabcylSpan, Vec2, Vec3, trig,
};
use proptest::prelude::*;

use crate::demand::{Demand, Verdict};
use crate::sheets::Sheets;

/// Half the width of each face along y and along the edge.
const WIDE: f64 = 4.0;

/// Faces that rise by `slope` on both sides of the edge, which is the x axis.
fn valley(slope: f64) -> Form {
    let row = |y: f64| {
        let knot = |x: f64| Knot { point: Vec3::new(x, y, slope * y.abs()), ..Knot::default() };
        let knots = [-WIDE, 0.0, WIDE].map(knot).to_vec();
        MeshSpline { smoothing: Smoothing::default(), knots }
    };
    let shape = SurfaceShape::Mesh {
        kind: MeshKind::Smesh,
        spacing: MeshSpacing::Ruled,
        splines: [-WIDE, 0.0, WIDE].map(row).to_vec(),
    };
    Form::Ssurf(Arc::new(SurfaceDefinition::plain(shape)))
}

/// The same, or a ridge where it falls, as a TABCYL with a corner or with rulings between two of them.
fn folded(slope: f64, ruled: bool) -> Form {
    let knot = |y: f64| CurveKnot { point: Vec2::new(y, slope * y.abs()), tangent: None };
    let row = |k: Vec3, own: Vec3| k * own.transpose();
    let axes = row(Vec3::x(), Vec3::y()) + row(Vec3::y(), Vec3::z()) + row(Vec3::z(), Vec3::x());
    let knots = [-WIDE, 0.0, WIDE].map(knot);
    let mut curve = Tabcyl::fit(&knots, Fit::TwoPoint, axes, 10.0).unwrap();
    curve.spans.iter_mut().for_each(|s| *s = TabcylSpan::new(s.start, 0.0, 0.0, s.length));
    let surface = Arc::new(Form::Tabcyl(Arc::new(curve)));
    if !ruled {
        return Arc::unwrap_or_clone(surface);
    }
    let rail = |x: f64| {
        let end = |y: f64| Vec3::new(x, y, slope * y.abs());
        let toward = Vec3::z() * -slope.signum();
        Rail { surface: surface.clone(), start: end(-WIDE), end: end(WIDE), toward }
    };
    // Its upper side is the positive one.
    let second = Second::Rail(rail(-2.0 * WIDE));
    Form::Ruled(Arc::new(RuledSurface { first: rail(2.0 * WIDE), second }))
}

/// Faces over the quadrants of the plane that rise by `slope` along x and y, in cells as wide.
fn pit(slope: f64, cells: u32) -> Form {
    let last = f64::from(cells);
    let at = |i: u32| WIDE * (2.0 * f64::from(i) / last - 1.0);
    let places = (0..=cells).flat_map(|j| (0..=cells).map(move |i| (at(i), at(j))));
    let points = places.map(|(x, y)| [x, y, slope * (x.abs() + y.abs()), 1.0]).collect();
    let inner = (0..=cells).map(f64::from);
    let knots: Vec<f64> = std::iter::once(0.0).chain(inner).chain(std::iter::once(last)).collect();
    let counts = [cells as usize + 1; 2];
    let surface = BsplineSurface {
        degree: [1, 1],
        knots: [knots.clone(), knots],
        counts,
        points,
        range: [None; 2],
    };
    Form::Ssurf(Arc::new(SurfaceDefinition::plain(SurfaceShape::Bspline(Box::new(surface)))))
}

/// Signed distance of a point from the pit, negative below it, without its borders.
fn above_pit(p: Vec3, slope: f64) -> f64 {
    let below = p.z < slope * (p.x.abs() + p.y.abs());
    let ray = |way: Vec3| {
        let way = way.normalize();
        (p - way * way.dot(&p).max(0.0)).norm()
    };
    let face = |[x, y]: [f64; 2]| {
        let n = Vec3::new(-slope * x, -slope * y, 1.0).normalize();
        let foot = p - n * n.dot(&p);
        let inside = foot.x * x >= 0.0 && foot.y * y >= 0.0;
        if inside { n.dot(&p).abs() } else { f64::INFINITY }
    };
    let signs = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];
    let edges =
        signs.iter().flat_map(|[x, y]| [Vec3::new(*x, 0.0, slope), Vec3::new(0.0, *y, slope)]);
    let far = signs.map(face).into_iter().chain(edges.map(ray)).fold(f64::INFINITY, f64::min);
    if below { -far } else { far }
}

/// Signed distance of a point from the valley, negative below the faces, without their borders.
fn above_valley(p: Vec3, slope: f64) -> f64 {
    let size = (1.0 + slope * slope).sqrt();
    let (y, z) = (p.y.abs(), p.z);
    // Along the nearer face from the edge, and off it.
    let (along, off) = ((y + slope * z) / size, (z - slope * y) / size);
    let far = if along >= 0.0 { off.abs() } else { trig::hypot(y, z) };
    if off >= 0.0 { far } else { -far }
}

/// The deepest of the points of a tool.
fn deepest(profile: &Profile, at: &Position, distance: impl Fn(Vec3) -> f64) -> f64 {
    const AROUND: u32 = 90;
    const HIGH: u32 = 48;
    let u = crate::solid::any_across(at.ta);
    let w = at.ta.cross(&u);
    let mut least = f64::INFINITY;
    for i in 0..=HIGH {
        let (s, c) = trig::sin_cos(f64::from(i) / f64::from(HIGH) * std::f64::consts::PI);
        let [widest, z] = profile.support(s, -c).point;
        for k in 0..AROUND {
            let (s, c) = trig::sin_cos(f64::from(k) / f64::from(AROUND) * std::f64::consts::TAU);
            // A flat end may be deepest in its middle.
            for r in [0.0, 0.5, 1.0].map(|share| share * widest) {
                least = least.min(distance(at.te + at.ta * z + (u * c + w * s) * r));
            }
        }
    }
    least
}

fn cutters() -> [Cutter; 5] {
    [
        Cutter::mill(0.02, 0.0, 5.0),
        Cutter::mill(0.1, 0.05, 5.0),
        Cutter::mill(1.0, 0.0, 5.0),
        Cutter::mill(1.0, 0.2, 5.0),
        Cutter { e: 0.0, beta_deg: 20.0, ..Cutter::mill(0.002, 0.0, 3.0) },
    ]
}

fn judge(form: &Arc<Form>, profile: &Profile, ends: [&Position; 2], least: f64) -> Verdict {
    judge_with(form, profile, ends, [0.0, -least])
}

fn judge_with(
    form: &Arc<Form>,
    profile: &Profile,
    [a, b]: [&Position; 2],
    [thick, intol]: [f64; 2],
) -> Verdict {
    let controlled = Controlled {
        name: NameRef::default(),
        form: Arc::clone(form),
        relation: Relation::To,
        side: 1,
        open: false,
        nth: 1,
        thick,
        disk: None,
        intol,
        outtol: 1.0,
    };
    Demand::new(&controlled, &Sheets::default()).judge(profile, a, b, 1e-11)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]
    /// A tool that goes deeper in at a hollow edge or a corner of four than it may is never proved, however thin it is; one that
    /// does not is.
    #[test]
    fn a_tool_at_a_hollow_edge_is_proved_to_its_depth_and_no_deeper(
        slope in 0.02..1.5_f64, te in prop::array::uniform3(-0.4..0.4_f64), v in prop::array::uniform2(-0.5..0.5_f64),
        lean in prop::array::uniform2(-0.5..0.5_f64), which in 0_usize..5, cells in 0_u32..3, deep in 0.0..1.0_f64,
    ) {
        let profile = Profile::new(&cutters()[which]).unwrap();
        let ta = Vec3::new(lean[0], lean[1], 1.0).normalize();
        // Over the valley also where it goes on beyond its border.
        let along = if cells == 0 && te[2] > 0.2 { 6.0 } else { 0.0 };
        let a = Position { te: Vec3::new(te[0] + along, te[1], 0.3 * te[2] - 0.3 * deep), ta };
        let b = Position { te: a.te + Vec3::new(v[0], v[1], 0.0), ta };
        let distance = |p: Vec3| if cells == 0 { above_valley(p, slope) } else { above_pit(p, slope) };
        let gaps = [0.0, 0.25, 0.5, 0.75, 1.0].map(|t| {
            let at = Position { te: a.te + (b.te - a.te) * t, ta };
            deepest(&profile, &at, distance)
        });
        let gap = gaps.into_iter().fold(f64::INFINITY, f64::min);
        prop_assume!(gap < -0.01);
        let form = Arc::new(if cells == 0 { valley(slope) } else { pit(slope, 2 * cells) });
        let shallow = judge(&form, &profile, [&a, &b], gap + 1e-6);
        prop_assert!(!matches!(shallow, Verdict::Proved { .. }), "{} {:?}", gap, shallow);
        // What lies between the points and places that are looked at is deeper by less.
        let deep = judge(&form, &profile, [&a, &b], 1.02 * gap - 0.003);
        prop_assert!(matches!(deep, Verdict::Proved { .. }), "{} {:?}", gap, deep);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]
    /// Corners of a TABCYL and of rails: no tool is proved between the faces where they part, hollow where these are moved back and
    /// on a ridge where THICK moves them out; nor is one held to what overlaps on a ridge where they are moved back.
    #[test]
    fn no_tool_is_proved_between_faces_that_part_at_a_corner(
        slope in 0.02..1.0_f64, hollow: bool, ruled: bool, below: bool, te in prop::array::uniform3(-0.4..0.4_f64),
        v in prop::array::uniform2(-0.5..0.5_f64), lean in prop::array::uniform2(-0.5..0.5_f64), which in 0_usize..5,
        off in 0.05..1.0_f64,
    ) {
        let profile = Profile::new(&cutters()[which]).unwrap();
        let ta = Vec3::new(lean[0], lean[1], 1.0).normalize();
        let slope = if hollow { slope } else { -slope };
        let high = if hollow || below { -off } else { off };
        let a = Position { te: Vec3::new(te[0], 0.3 * te[1], 0.1 * te[2] + high), ta };
        let b = Position { te: a.te + Vec3::new(v[0], v[1], 0.0), ta };
        let gaps = [0.0, 0.25, 0.5, 0.75, 1.0].map(|t| {
            let at = Position { te: a.te + (b.te - a.te) * t, ta };
            deepest(&profile, &at, |p| above_valley(p, slope))
        });
        let gap = gaps.into_iter().fold(f64::INFINITY, f64::min);
        let form = Arc::new(folded(slope, ruled));
        if hollow || below {
            prop_assume!(gap < -0.02);
            let verdict = judge(&form, &profile, [&a, &b], gap + 1e-4);
            prop_assert!(!matches!(verdict, Verdict::Proved { .. }), "{} {:?}", gap, verdict);
            // On a ridge the edge may be deeper in the tool than the tool is below both faces.
            let verdict = judge(&form, &profile, [&a, &b], 1.02 * gap - 0.003);
            let proved = matches!(verdict, Verdict::Proved { .. });
            prop_assert!(proved || !hollow, "{} {:?}", gap, verdict);
        } else {
            prop_assume!(gap > 0.02);
            let intol = 0.1 * gap;
            let verdict = judge_with(&form, &profile, [&a, &b], [gap + intol + 1e-4, intol]);
            prop_assert!(!matches!(verdict, Verdict::Proved { .. }), "{} {:?}", gap, verdict);
            let verdict = judge_with(&form, &profile, [&a, &b], [0.98 * gap + intol - 0.003, intol]);
            prop_assert!(matches!(verdict, Verdict::Proved { .. }), "{} {:?}", gap, verdict);
        }
    }
}

/// A ball that goes straight through the corner of the rails, from one face to the other.
#[test]
fn a_ball_through_a_ridge_between_rails_is_refuted() {
    let profile = Profile::new(&Cutter::mill(10.0, 5.0, 30.0)).unwrap();
    for slope in [-0.05, -0.2, -0.5] {
        for ruled in [false, true] {
            let form = Arc::new(folded(slope, ruled));
            let at = |y: f64| {
                let lift = 5.0 * (1.0 + slope * slope).sqrt() - 5.0;
                Position::upright(Vec3::new(1.0, y, slope * y.abs() + lift))
            };
            // Where the middle of the way is below the ridge.
            for far in [1.0, 3.0, 4.0].into_iter().filter(|y| at(*y).te.z < -0.02) {
                let verdict = judge(&form, &profile, [&at(-far), &at(far)], -0.01);
                assert!(matches!(verdict, Verdict::Refuted { .. }), "{slope} {far} {verdict:?}");
            }
        }
    }
}

/// However many edges are near: a ball in a hollow of facets.
#[test]
fn a_ball_over_many_facets_is_proved() {
    let profile = Profile::new(&Cutter::mill(6.0, 3.0, 10.0)).unwrap();
    for cells in [4, 10, 24] {
        let form = Arc::new(pit(0.1, cells));
        let at = |x: f64| Position::upright(Vec3::new(x, 0.4, 0.1 * (x.abs() + 0.4)));
        let [a, b] = [at(0.3), at(0.6)];
        let places = (0..=20).map(|k| {
            let at = Position { te: a.te + (b.te - a.te) * (0.05 * f64::from(k)), ..a };
            above_pit(at.te + Vec3::z() * 3.0, 0.1) - 3.0
        });
        let gap = places.fold(f64::INFINITY, f64::min);
        let verdict = judge(&form, &profile, [&a, &b], gap - 1e-4);
        assert!(matches!(verdict, Verdict::Proved { .. }), "{cells} {gap} {verdict:?}");
        let verdict = judge(&form, &profile, [&a, &b], gap + 1e-3);
        assert!(matches!(verdict, Verdict::Refuted { .. }), "{cells} {gap} {verdict:?}");
    }
}

/// A tool smaller than what is to be left on the surface, which stands between both: nothing of it is where the surface is moved to.
#[test]
fn a_tool_in_what_is_to_be_left_is_refuted() {
    // z = .05 (x^2 - y^2), the tool above.
    let c = [-0.05, 0.05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5];
    let saddle = Arc::new(Form::Quadric(Quadric { kind: QuadricKind::Gconic, c }));
    let forms = [folded(0.2, false), folded(-0.2, false), folded(0.2, true), valley(0.3)];
    for form in forms.into_iter().map(Arc::new).chain([saddle]) {
        for cutter in [cutters()[2], cutters()[3]] {
            let profile = Profile::new(&Cutter { height: 0.5, ..cutter }).unwrap();
            let at = |x: f64, z: f64| Position::upright(Vec3::new(x, 0.3, z));
            let near = judge_with(&form, &profile, [&at(0.0, 1.0), &at(0.4, 1.0)], [3.0, 0.1]);
            assert!(matches!(near, Verdict::Refuted { .. }), "{form:?} {near:?}");
            let far = judge_with(&form, &profile, [&at(0.0, 3.5), &at(0.4, 3.5)], [3.0, 0.1]);
            assert!(matches!(far, Verdict::Proved { .. }), "{form:?} {far:?}");
        }
    }
}
