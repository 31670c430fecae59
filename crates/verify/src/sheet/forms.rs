//! Surfaces by two parameters for tests, about the origin, a few units in size.

use std::sync::Arc;

use aptc_geometry::sculptured::{
    CurveDefinition, CurveShape, Knot, MeshKind, MeshSpacing, MeshSpline, Smoothing,
    SurfaceDefinition, SurfaceShape,
};
use aptc_geometry::{
    Circle, Fit, Form, Polyconic, Rail, RuledSurface, Second, Tabcyl, Vec2, Vec3, trig,
};

use super::{Patch, Patches, Sheet};

/// The arc of a circle about z at height `z` over the chord between two angles.
fn arc(radius: f64, z: f64, from: f64, to: f64) -> Rail {
    let circle = Circle { center: Vec3::zeros(), axis: Vec3::z(), radius };
    let at = |a: f64| Vec3::new(radius * trig::cos_deg(a), radius * trig::sin_deg(a), z);
    let toward = at(0.5 * (from + to)) - Vec3::new(0.0, 0.0, z);
    Rail { surface: Arc::new(Form::Circle(circle)), start: at(from), end: at(to), toward }
}

/// A straight rail in the plane y = 1.
fn straight(z: f64, rise: f64) -> Rail {
    let plane = aptc_geometry::Plane { n: Vec3::y(), d: 1.0 };
    Rail {
        surface: Arc::new(Form::Plane(plane)),
        start: Vec3::new(-4.0, 1.0, z),
        end: Vec3::new(4.0, 1.0, z + rise),
        toward: Vec3::y(),
    }
}

/// A curve through points and the plane x, y.
fn wave() -> Rail {
    let at = |x: f64| Vec2::new(x, 0.6 * trig::sin(x));
    let points: Vec<Vec2> = (0..9).map(|i| at(f64::from(i) - 4.0)).collect();
    let free: Vec<_> =
        points.iter().map(|p| aptc_geometry::Knot { point: *p, tangent: None }).collect();
    let own = |e: Vec3| e * e.transpose();
    let axes = own(Vec3::x()) + own(Vec3::y()) + own(Vec3::z());
    let t = Tabcyl::fit(&free, Fit::Spline, axes, 1.0).expect("a curve");
    let place = |p: Vec2| Vec3::new(p.x, p.y, 0.0);
    Rail {
        surface: Arc::new(Form::Tabcyl(Arc::new(t))),
        start: place(points[0]),
        end: place(points[8]),
        toward: Vec3::y(),
    }
}

fn ruled(first: Rail, second: Second) -> Form {
    Form::Ruled(Arc::new(RuledSurface { first, second }))
}

fn knots(points: &[[f64; 3]]) -> Vec<Knot> {
    points.iter().map(|p| Knot { point: Vec3::from(*p), ..Knot::default() }).collect()
}

fn mesh() -> Form {
    let row = |j: i32| {
        let at = |i: i32| {
            let (x, y) = (2.0 * f64::from(i) - 4.0, 2.0 * f64::from(j) - 3.0);
            [x, y, 0.5 * trig::sin(0.7 * x) * trig::cos(0.5 * y)]
        };
        let points: Vec<[f64; 3]> = (0..5).map(at).collect();
        MeshSpline { smoothing: Smoothing::default(), knots: knots(&points) }
    };
    let shape = SurfaceShape::Mesh {
        kind: MeshKind::Smesh,
        spacing: MeshSpacing::Xyz,
        splines: (0..4).map(row).collect(),
    };
    Form::Ssurf(Arc::new(SurfaceDefinition::plain(shape)))
}

/// Half a barrel about x: rational.
fn barrel() -> Form {
    let smoothing = Smoothing::default();
    let points = [[-3.0, 0.0, 2.0], [0.0, 0.0, 3.0], [3.0, 0.0, 2.0]];
    let curve = CurveShape::Spline { smoothing, knots: knots(&points) };
    let shape = SurfaceShape::Revolved {
        curve: Arc::new(CurveDefinition::plain(curve)),
        origin: Vec3::zeros(),
        axis: Vec3::x(),
        clockwise: false,
        angles_deg: [-80.0, 80.0],
    };
    Form::Ssurf(Arc::new(SurfaceDefinition::plain(shape)))
}

/// Sections are quarter circles of radius 1 + d, or 1 + sqrt d, about the x axis.
pub(crate) fn polyconic(root: bool) -> Form {
    let mut e = [0.0; 79];
    e[0] = 1.0;
    (e[14], e[15]) = (-3.0, 6.0);
    let w = std::f64::consts::FRAC_1_SQRT_2;
    for (k, sign) in [(16, -1.0), (24, 1.0), (48, 1.0)] {
        e[k] = sign;
        if root { e[72 + (k - 16) / 8] = sign } else { e[k + 1] = sign }
    }
    e[64] = 0.5 + 0.5 * w / (1.0 + w);
    Form::Polyconic(Arc::new(Polyconic::from_canonical(&e)))
}

/// All of them.
pub(crate) fn parametric() -> Vec<Form> {
    vec![
        ruled(arc(2.0, 0.0, 10.0, 90.0), Second::Rail(arc(4.0, 3.0, 10.0, 90.0))),
        ruled(arc(3.0, -1.0, 0.0, 180.0), Second::Rail(arc(3.0, 2.0, 0.0, 180.0))),
        ruled(arc(4.0, 3.0, 20.0, 110.0), Second::Apex(Vec3::new(0.5, 0.0, -4.0))),
        ruled(straight(-1.0, 0.0), Second::Rail(straight(2.0, 1.0))),
        ruled(wave(), Second::Rail(straight(3.0, -0.5))),
        polyconic(false),
        polyconic(true),
        mesh(),
        barrel(),
    ]
}

/// A chart of a surface, down its tree or one of its roots.
pub(crate) fn chart(sheet: &Sheet, walk: &[bool]) -> Patch {
    let Some(mut patch) = sheet.tree() else {
        let mut roots = Patches::new();
        assert!(sheet.roots(Vec3::zeros(), 3.0, &mut roots));
        let mut found = roots.pop().unwrap();
        for _ in walk.iter().filter(|side| **side) {
            found = roots.pop().unwrap_or(found);
        }
        return found;
    };
    for side in walk {
        let [first, second] = sheet.below(&patch, Vec3::zeros());
        patch = if *side { first.or(second) } else { second }.unwrap();
        if !patch.group {
            break;
        }
    }
    patch
}
