//! Cut vectors per second for pairs of surfaces, from the PROTAP records to the CL records.
#![expect(clippy::expect_used, reason = "a benchmark that cannot run says so")]

use std::sync::Arc;

use aptc_arelem::{Arelem, Options};
use aptc_cldata as cl;
use aptc_geometry::{
    Circle, Cutter, Cylinder, Fit, Form, Knot, Line, Plane, Quadric, QuadricKind, Rail,
    RuledSurface, Second, Sphere, Tabcyl, Vec2, Vec3, trig,
};
use aptc_protap::{
    Check, Direction, Drive, DriveSide, Go, Kind, NameRef, Place, Record, Relation, Sense,
    SurfaceRef,
};
use aptc_testkit::bench;

/// Half the band.
const BAND: f64 = 1e-4;
/// The same of a path so long in cut vectors that its start and its end count for little.
const FINE: f64 = 1e-6;

fn surface(form: Form) -> SurfaceRef {
    SurfaceRef { name: NameRef::default(), form: Arc::new(form) }
}

/// A motion over the part surface along the drive surface from x = -30 to x = 30.
struct Motion {
    name: &'static str,
    target: Option<f64>,
    corner: f64,
    drive: Form,
    on: bool,
    part: Form,
    band: f64,
}

impl Motion {
    fn records(&self) -> Vec<Record> {
        let how = if self.on { Relation::On } else { Relation::To };
        let side = if self.on { DriveSide::Tlon } else { DriveSide::Tlrgt };
        let end = Form::Plane(Plane { n: Vec3::x(), d: 30.0 });
        let cutter = Cutter::mill(10.0, self.corner, 40.0);
        let from =
            Place { name: NameRef::default(), point: Vec3::new(-30.0, -8.0, 8.0), axis: None };
        let kinds = vec![
            Kind::Cutter(cutter),
            Kind::Intol([self.band; 4]),
            Kind::Outtol([self.band; 4]),
            Kind::Maxdp { step: 1e3, length: None },
            Kind::From(from),
            Kind::Go(Go {
                offset: false,
                surfaces: vec![
                    (how, surface(self.drive.clone())),
                    (Relation::To, surface(self.part.clone())),
                ],
            }),
            Kind::Sense(Sense::Vector(vec![Some(Vec3::x())])),
            Kind::DriveSide(side),
            Kind::Drive(Drive {
                direction: Direction::Gofwd,
                drive: surface(self.drive.clone()),
                checks: vec![Check {
                    relation: Relation::On,
                    nth: 1,
                    surface: surface(end),
                    branch: false,
                }],
            }),
        ];
        kinds.into_iter().map(|kind| Record { origin: Default::default(), kind }).collect()
    }
}

/// The number of cut vectors of a run.
fn run(records: &[Record]) -> usize {
    let (mut arelem, mut out) = (Arelem::new(Options::default()), Vec::new());
    for record in records {
        arelem.execute(record, &mut out);
    }
    let told: Vec<String> = arelem.take_diagnostics().into_iter().map(|d| d.message).collect();
    assert!(told.is_empty(), "{told:?}");
    let points = |r: &cl::Record| match &r.kind {
        cl::Kind::Motion(m) if m.kind == cl::MotionKind::Continuous => m.points.len(),
        _ => 0,
    };
    out.iter().map(points).sum()
}

fn ball_at(radius: f64) -> Form {
    Form::Sphere(Sphere { center: Vec3::new(0.0, 0.0, -radius), radius })
}

/// Half axes 60, 45 and 50, its top at the origin.
fn ellipsoid() -> Form {
    let [a, b, c] = [60.0, 45.0, 50.0].map(|x: f64| 1.0 / (x * x));
    let c = [a, b, c, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 50.0 * c];
    Form::Quadric(Quadric { kind: QuadricKind::Qadric, c })
}

/// A wave beside the x axis, y from 0 to 4.
fn wave() -> Form {
    let knots: Vec<Knot> = (-14..=14)
        .map(|i| {
            let x = 4.0 * f64::from(i);
            Knot { point: Vec2::new(x, 2.0 + 2.0 * trig::sin_deg(6.0 * x)), tangent: None }
        })
        .collect();
    let axes = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
    let axes = nalgebra::Matrix3::from_row_slice(&axes);
    Form::Tabcyl(Arc::new(Tabcyl::fit(&knots, Fit::Spline, axes, 10.0).expect("a spline")))
}

/// Rulings along y between two arcs over x from -45 to 45.
fn ruled() -> Form {
    let rail = |y: f64, radius: f64| {
        let circle = Circle { center: Vec3::new(0.0, y, -radius), axis: Vec3::y(), radius };
        let z = ((radius - 45.0) * (radius + 45.0)).sqrt() - radius;
        let end = |x: f64| Vec3::new(x, y, z);
        let surface = Arc::new(Form::Circle(circle));
        Rail { surface, start: end(-45.0), end: end(45.0), toward: Vec3::z() }
    };
    let (first, second) = (rail(-40.0, 60.0), Second::Rail(rail(40.0, 90.0)));
    Form::Ruled(Arc::new(RuledSurface { first, second }))
}

fn main() {
    let line = || Form::Line(Line::new(0.0, 1.0, 0.0).expect("a line"));
    let wall = || {
        let point = Vec3::new(0.0, 60.0, 0.0);
        Form::Cylinder(Cylinder { point, axis: Vec3::z(), radius: 60.0 })
    };
    let flat = || Form::Plane(Plane { n: Vec3::z(), d: 0.0 });
    let motion = |name, target, corner, drive, on, part| {
        let band = BAND;
        Motion { name, target, corner, drive, on, part, band }
    };
    let fine = |motion: Motion| Motion { band: FINE, ..motion };
    let all = [
        motion("plane: circle in a plane", Some(10.0), 0.0, wall(), false, flat()),
        motion("ball: plane ON, sphere", Some(4.0), 5.0, line(), true, ball_at(50.0)),
        motion("ball: cylinder, sphere", Some(4.0), 5.0, wall(), false, ball_at(50.0)),
        motion("bull nose: plane ON, sphere", Some(1.5), 2.0, line(), true, ball_at(50.0)),
        motion("bull nose: cylinder, sphere", Some(1.5), 2.0, wall(), false, ball_at(50.0)),
        motion("ball: plane ON, ellipsoid", Some(0.4), 5.0, line(), true, ellipsoid()),
        motion("bull nose: plane ON, ellipsoid", Some(0.4), 2.0, line(), true, ellipsoid()),
        motion("ball: TABCYL, plane", Some(0.4), 5.0, wave(), false, flat()),
        motion("ball: TABCYL, sphere", Some(0.4), 5.0, wave(), false, ball_at(50.0)),
        motion("ball: plane ON, ruled", Some(0.4), 5.0, line(), true, ruled()),
        motion("bull nose: plane ON, ruled", Some(0.4), 2.0, line(), true, ruled()),
        fine(motion("ball: cylinder, sphere, fine", Some(4.0), 5.0, wall(), false, ball_at(50.0))),
        fine(motion("ball: plane ON, ruled, fine", Some(0.4), 5.0, line(), true, ruled())),
        fine(motion("bull nose: plane ON, ruled, fine", Some(0.4), 2.0, line(), true, ruled())),
    ];
    for m in &all {
        let records = m.records();
        #[expect(clippy::cast_precision_loss, reason = "thousands")]
        let vectors = run(&records) as f64;
        bench::rate(
            &format!("motion: {}", m.name),
            1e-6 * vectors,
            "million vectors/s",
            m.target,
            || run(&records),
        );
    }
}
