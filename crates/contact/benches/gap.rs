//! Time of one gap for each kind of pair, in nanoseconds, by `cargo bench -p aptc-contact`.

use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

use aptc_contact::{Condition, Side, Tool, chord, gap, gap_near, second};
use aptc_geometry::surface::{QuadricSurface, TabcylSurface};
use aptc_geometry::{
    Cone, Cutter, Cylinder, Fit, Knot, Plane, Profile, Quadric, QuadricKind, Sphere, Surface,
    Tabcyl, Vec2, Vec3, trig,
};

/// Nanoseconds a call: the best of many runs short enough to lie between two turns of the scheduler.
fn time(mut call: impl FnMut(u32) -> f64) -> f64 {
    let mut best = f64::INFINITY;
    let mut rounds = 8;
    for _ in 0..60 {
        let start = Instant::now();
        let mut sum = 0.0;
        for i in 0..rounds {
            sum += call(i);
        }
        black_box(sum);
        let each = start.elapsed().as_secs_f64() * 1e9 / f64::from(rounds);
        best = best.min(each);
        rounds = if best < 100.0 {
            4096
        } else if best < 1000.0 {
            512
        } else {
            32
        };
    }
    best
}

fn quadric(c: [f64; 10]) -> Surface {
    let form = Quadric { kind: QuadricKind::Qadric, c };
    Surface::Quadric(Arc::new(QuadricSurface::new(&form).expect("a quadric")))
}

#[expect(clippy::print_stdout, reason = "a bench prints its figures")]
fn main() {
    let (o, r) = (Vec3::zeros(), 50.0);
    let cylinder = |axis: Vec3| Surface::Cylinder(Cylinder { point: o, axis, radius: r });
    let cone = |axis: Vec3| Surface::Cone(Cone { vertex: o, axis, cos_half: trig::cos_deg(30.0) });
    let slant = Vec3::new(0.3, 0.5, 0.8).normalize();
    let ellipsoid = |a: f64, b: f64, c: f64| {
        quadric([a, b, c, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0].map(
            |k: f64| {
                if k < 0.0 { -1.0 } else { k }
            },
        ))
    };
    let q = |x: f64| 1.0 / (x * x);
    let surfaces = [
        ("plane", Surface::Plane(Plane { n: slant, d: 1.0 }), Side::Positive),
        ("sphere, outside", Surface::Sphere(Sphere { center: o, radius: r }), Side::Positive),
        ("sphere, inside", Surface::Sphere(Sphere { center: o, radius: r }), Side::Negative),
        ("cylinder along the axis", cylinder(Vec3::z()), Side::Positive),
        ("cylinder square to it", cylinder(Vec3::y()), Side::Positive),
        ("cylinder oblique, outside", cylinder(slant), Side::Positive),
        ("cylinder oblique, inside", cylinder(slant), Side::Negative),
        ("cone along the axis", cone(-Vec3::z()), Side::Positive),
        ("cone oblique, outside", cone(slant), Side::Positive),
        ("elliptic cylinder along the axis", ellipsoid(q(60.0), q(40.0), 0.0), Side::Positive),
        ("ellipsoid, outside", ellipsoid(q(60.0), q(40.0), q(50.0)), Side::Positive),
        ("ellipsoid, inside", ellipsoid(q(60.0), q(40.0), q(50.0)), Side::Negative),
        ("saddle", quadric([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.005, 0.0, 0.0, 0.5]), Side::Positive),
    ];
    let wave = |w: Vec3| {
        let knots: Vec<Knot> = (0..60)
            .map(|i| {
                let x = f64::from(i) * 4.0 - 120.0;
                Knot { point: Vec2::new(x, 5.0 * trig::sin(x * 0.05)), tangent: None }
            })
            .collect();
        let [u, v] = aptc_geometry::surface::frame_about(w);
        let axes = nalgebra::Matrix3::from_rows(&[u.transpose(), v.transpose(), w.transpose()]);
        let form = Tabcyl::fit(&knots, Fit::Spline, axes, 10.0).expect("a curve");
        Surface::Tabcyl(Arc::new(TabcylSurface::new(&Arc::new(form)).expect("spans")))
    };
    let tabcyls = [
        ("TABCYL of 60 points along the axis", wave(Vec3::z()), Side::Positive),
        ("TABCYL of 60 points square to it", wave(Vec3::x()), Side::Positive),
    ];
    let surfaces: Vec<_> = surfaces.into_iter().chain(tabcyls).collect();
    println!("{:34} {:>9} {:>9} {:>9} {:>9}", "ns a gap", "ball", "warm", "bull nose", "warm");
    for (name, surface, side) in &surfaces {
        print!("{name:34}");
        for corner in [5.0, 2.0] {
            let profile = Profile::new(&Cutter::mill(10.0, corner, 30.0)).expect("a mill");
            let away = if *side == Side::Positive { 70.0 } else { 20.0 };
            let mut base = Vec3::new(0.6, 0.5, 0.62) * away;
            for _ in 0..4 {
                let tool = Tool { profile: &profile, te: base, ta: Vec3::z() };
                let g = gap(&tool, surface, *side, 0.0).expect("a gap");
                base -= g.normal * g.g;
            }
            let at = |i: u32| {
                let x = f64::from(i % 64) * 0.01;
                Tool { profile: &profile, te: base + Vec3::new(x, -x, 0.3 * x), ta: Vec3::z() }
            };
            let cold = time(|i| gap(&at(i), surface, *side, 0.0).map_or(0.0, |g| g.g));
            let mut start = None;
            let warm = time(|i| {
                let g = gap_near(&at(i), surface, *side, 0.0, start).expect("a gap");
                start = Some(g.spot());
                g.g
            });
            print!(" {cold:9.1} {warm:9.1}");
        }
        println!();
    }
    let ball = Profile::new(&Cutter::mill(10.0, 5.0, 30.0)).expect("a ball");
    println!("\n{:34} {:>9} {:>9}", "ns", "second", "chord");
    for (name, surface, side) in &surfaces {
        let te = Vec3::new(30.0, 20.0, 25.0);
        let tool = Tool { profile: &ball, te, ta: Vec3::z() };
        let g = gap(&tool, surface, *side, 0.0).expect("a gap");
        let bend = time(|_| {
            second(black_box(&tool), surface, *side, &g).map_or(0.0, |s| s.second(Vec3::x()))
        });
        let to = tool.at(te + g.normal.cross(&Vec3::new(0.3, 0.2, 0.9)).normalize() * 2.0);
        let run = time(|_| {
            let c = chord(black_box(&tool), &to, surface, Condition::Touch, *side, 0.0, None, 1e-9);
            c.map_or(0.0, |c| c.low.g)
        });
        println!("{name:34} {bend:9.1} {run:9.1}");
    }
}
