//! Cut vectors proved a second, by surface and cutter.
//!
//! `cargo bench -p aptc-verify`. Chords that stay in their band go over a crest along the plane y = 0, on which the
//! tool end is; the part surface is below.

use std::sync::Arc;

use aptc_cldata::{
    Control, Controlled, Kind, Motion, MotionKind, NameRef, Position, Record, Relation,
};
use aptc_diagnostics::Origin;
use aptc_geometry::sculptured::{
    Knot, MeshKind, MeshSpacing, MeshSpline, Smoothing, SurfaceDefinition, SurfaceShape,
};
use aptc_geometry::surface::continued;
use aptc_geometry::{Cutter, Cylinder, Form, Plane, Quadric, QuadricKind, Sphere, Vec3};
use aptc_testkit::bench;
use aptc_verify::{Effort, Verifier};

const BAND: f64 = 0.01;
const VECTORS: i32 = 20_000;

fn controlled(form: Form, relation: Relation, side: i8) -> Controlled {
    Controlled {
        name: NameRef::default(),
        form: Arc::new(form),
        relation,
        side,
        nth: 1,
        thick: 0.0,
        disk: None,
        intol: BAND,
        outtol: BAND,
        open: false,
    }
}

/// A crest as an SSURF, 100 long and 40 wide.
fn mesh() -> SurfaceDefinition {
    let row = |j: i32| {
        let at = |i: i32| {
            let (x, y) = (10.0 * f64::from(i) - 50.0, 10.0 * f64::from(j) - 20.0);
            let point = Vec3::new(x, y, -(x * x + y * y) / 100.0);
            Knot { point, ..Knot::default() }
        };
        MeshSpline { smoothing: Smoothing::default(), knots: (0..=10).map(at).collect() }
    };
    SurfaceDefinition::plain(SurfaceShape::Mesh {
        kind: MeshKind::Smesh,
        spacing: MeshSpacing::Xyz,
        splines: (0..=4).map(row).collect(),
    })
}

/// Point of the crest and its upward normal at the share `t` of one flank.
type Crest = Box<dyn Fn(f64) -> (Vec3, Vec3)>;

fn surfaces() -> Vec<(&'static str, Form, i8, Crest)> {
    let round = |t: f64| {
        let (s, c) = aptc_geometry::trig::sin_cos(0.1 + 0.6 * t);
        let n = Vec3::new(s, 0.0, c);
        (n * 50.0, n)
    };
    let mut ten = [0.0; 10];
    // x2 + y2 + 100 z = 0.
    (ten[0], ten[1], ten[9]) = (1.0, 1.0, 50.0);
    let ssurf = mesh();
    let fitted = continued(&ssurf).expect("a surface").surface;
    let axis = Cylinder { point: Vec3::zeros(), axis: Vec3::y(), radius: 50.0 };
    vec![
        (
            "plane",
            Form::Plane(Plane { n: Vec3::new(0.6, 0.0, 0.8), d: 0.0 }),
            1,
            Box::new(|t| (Vec3::new(40.0 * t, 0.0, -30.0 * t), Vec3::new(0.6, 0.0, 0.8))),
        ),
        (
            "sphere",
            Form::Sphere(Sphere { center: Vec3::zeros(), radius: 50.0 }),
            1,
            Box::new(round),
        ),
        ("cylinder", Form::Cylinder(axis), 1, Box::new(round)),
        (
            "quadric",
            Form::Quadric(Quadric { kind: QuadricKind::Qadric, c: ten }),
            1,
            Box::new(|t| {
                let x = 3.0 + 30.0 * t;
                let n = Vec3::new(2.0 * x, 0.0, 100.0).normalize();
                (Vec3::new(x, 0.0, -x * x / 100.0), n)
            }),
        ),
        (
            "SSURF",
            Form::Ssurf(Arc::new(ssurf)),
            1,
            Box::new(move |t| {
                let d = fitted.at(5.3 + 3.0 * t, 2.0);
                (d.point, d.normal().expect("regular"))
            }),
        ),
    ]
}

fn main() {
    for (cutter, name) in
        [(Cutter::mill(10.0, 5.0, 40.0), "ball"), (Cutter::mill(10.0, 2.0, 40.0), "bull nose")]
    {
        for (surface, form, side, crest) in surfaces() {
            let place = |i: i32| {
                // Back and forth over the flank in steps of about a millimetre.
                let k = i % 80;
                let t = f64::from(if k < 40 { k } else { 80 - k }) / 40.0;
                let (p, n) = crest(t);
                let out = Vec3::new(n.x.signum(), 0.0, 0.0) * cutter.e;
                let te = p + n * cutter.corner_radius + out - Vec3::z() * cutter.corner_radius;
                Position::upright(te)
            };
            let control = Control {
                drive: Some(controlled(
                    Form::Plane(Plane { n: Vec3::y(), d: 0.0 }),
                    Relation::On,
                    0,
                )),
                part: Some(controlled(form, Relation::To, side)),
                ..Control::default()
            };
            let record = |kind| Record { origin: Origin::default(), kind };
            let motion = |kind, points, control| {
                record(Kind::Motion(Motion { kind, points, control, ..Motion::default() }))
            };
            let records = [
                record(Kind::Cutter(cutter)),
                motion(MotionKind::From, vec![place(0)], None),
                motion(
                    MotionKind::Continuous,
                    (1..=VECTORS).map(place).collect(),
                    Some(Arc::new(control)),
                ),
            ];
            let run = || {
                let mut verifier = Verifier::new(Effort::Full);
                records.iter().for_each(|r| verifier.push(r));
                let (certificate, _) = verifier.finish();
                assert!(
                    certificate.is_proved(),
                    "{name} on {surface}: {certificate} {:?}",
                    certificate.statements[0].fault
                );
                certificate
            };
            bench::rate(
                &format!("proof, {name} on {surface}"),
                f64::from(VECTORS) / 1e6,
                "million cut vectors/s",
                None,
                run,
            );
        }
    }
}
