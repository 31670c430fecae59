//! Random scenes that are built to have a solution.
#![allow(dead_code, reason = "each test program uses a part of it")]

use std::sync::Arc;

use aptc_geometry::{
    Circle, Fit, Form, Knot, Polyconic, Quadric, QuadricKind, Rail, RuledSurface, Second, Surface,
    Tabcyl, Vec2, Vec3, trig,
};
use nalgebra::Matrix3;

use super::{Forms, form, run};

/// A small generator with a fixed sequence, so that a failing scene can be run again.
pub(crate) struct Dice(u64);

impl Dice {
    pub(crate) fn new(seed: u64) -> Self {
        let mut new = Self(seed.wrapping_mul(7919).wrapping_add(17));
        for _ in 0..5 {
            new.unit();
        }
        new
    }

    pub(crate) fn unit(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        #[expect(clippy::cast_precision_loss, reason = "31 bits")]
        let x = (self.0 >> 33) as f64;
        x / 2_147_483_648.0
    }

    pub(crate) fn between(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * self.unit()
    }

    pub(crate) fn pick(&mut self, n: u32) -> u32 {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "below n")]
        let k = (self.unit() * f64::from(n)) as u32;
        k.min(n - 1)
    }

    fn sign(&mut self) -> f64 {
        if self.unit() < 0.5 { -1.0 } else { 1.0 }
    }
}

fn direction(angle_deg: f64) -> Vec3 {
    Vec3::new(trig::cos_deg(angle_deg), trig::sin_deg(angle_deg), 0.0)
}

/// Names of the part surfaces, in the order of the kinds.
pub(crate) const PARTS: [&str; 13] = [
    "plane",
    "dome",
    "bowl",
    "ridge",
    "valley",
    "cone",
    "ellipsoid",
    "paraboloid",
    "hollow",
    "saddle",
    "waves",
    "ruled",
    "polyconic",
];
/// Names of the drive surfaces.
pub(crate) const DRIVES: [&str; 11] = [
    "line",
    "circle",
    "plane",
    "sphere",
    "cone",
    "inside",
    "ellipse",
    "hyperbola",
    "waves",
    "ruled",
    "quadric",
];

/// Names of the check surfaces.
const CHECKS: [&str; 8] =
    ["sphere", "plane", "plane", "cylinder", "cone", "ellipsoid", "waves", "ruled"];

/// A quadric by its general coefficients Ax2+By2+Cz2+Fyz+Gxz+Hxy+Px+Qy+Rz+D.
fn quadric(k: [f64; 10]) -> Form {
    let [a, b, c, f, g, h, p, q, r, d] = k;
    let half = |x: f64| 0.5 * x;
    let c = [a, b, c, d, half(f), half(g), half(h), half(p), half(q), half(r)];
    Form::Quadric(Quadric { kind: QuadricKind::Qadric, c })
}

/// A wave through points along `along`, rising towards `up`: the least radius is some 12.
fn waves(d: &mut Dice, along: Vec3, up: Vec3, shift: f64, s: f64) -> Form {
    let (length, phase) = (d.between(40.0, 70.0), d.between(0.0, 360.0));
    // Curvature: height (2 pi / length)^2.
    let height = d.between(0.0, 1.0) * length * length / (40.0 * 12.0);
    let knots: Vec<Knot> = (-12..=12)
        .map(|i| {
            let x = f64::from(i) * 5.0;
            let y = height * (trig::sin_deg(360.0 * x / length + phase) - trig::sin_deg(phase));
            Knot { point: Vec2::new(x, y + shift) * s, tangent: None }
        })
        .collect();
    let w = along.cross(&up);
    let axes = Matrix3::from_rows(&[along.transpose(), up.transpose(), w.transpose()]);
    Form::Tabcyl(Arc::new(Tabcyl::fit(&knots, Fit::Spline, axes, 10.0 * s).expect("a spline")))
}

/// Straight rulings between two arcs of different radius about different points.
fn ruled(d: &mut Dice, along: Vec3, up: Vec3, shift: f64, s: f64) -> Form {
    let across = along.cross(&up);
    let hollow = d.sign();
    let mut rail = |side: f64| {
        let radius = d.between(60.0, 200.0) * s;
        let middle = across * (40.0 * side * s) + up * (shift * s);
        let half = 45.0 * s;
        let sink = radius - ((radius - half) * (radius + half)).sqrt();
        let circle = Circle { center: middle - up * (hollow * radius), axis: across, radius };
        let lift = |x: f64| middle + along * (x * half) - up * (hollow * sink);
        let surface = Arc::new(Form::Circle(circle));
        Rail { surface, start: lift(-1.0), end: lift(1.0), toward: up * hollow }
    };
    let (first, second) = (rail(-1.0), Second::Rail(rail(1.0)));
    Form::Ruled(Arc::new(RuledSurface { first, second }))
}

/// An arched surface over y from -50 to 50 that changes its height along x from -60 to 60.
fn polyconic(d: &mut Dice, s: f64) -> Form {
    let mut e = [0.0; 79];
    e[0] = 1.0;
    (e[14], e[15]) = (-60.0 * s, 120.0 * s);
    let (rise, change) = (d.between(10.0, 30.0), d.between(-8.0, 8.0));
    // From (50, -h) over the apex to (-50, -h); the shoulder at z = 0 or near it.
    let p = d.between(0.65, 0.75);
    let top = rise * (2.0 * p - 1.0);
    e[16] = -50.0 * s;
    e[24] = rise * s;
    e[32] = -50.0 * s;
    e[40] = -rise * s;
    e[48] = 50.0 * s;
    (e[56], e[57], e[58]) = (-top * s, change * s, -change * s);
    e[64] = p;
    Form::Polyconic(Arc::new(Polyconic::from_canonical(&e)))
}

fn part(d: &mut Dice, kind: u32, s: f64) -> Form {
    let u = direction(d.between(0.0, 360.0));
    let big = d.between(15.0, 60.0) * s;
    let f = |name: &str, w: &[f64]| form(name, w).expect("a legal form");
    match kind {
        0 => {
            let n = Vec3::z() + u * trig::tan(d.between(0.0, 0.44));
            f("PLANE", &[n.x, n.y, n.z, 0.0])
        }
        1 => f("SPHERE", &[0.0, 0.0, -big, big]),
        2 => f("SPHERE", &[0.0, 0.0, big, big]),
        3 => f("CYLNDR", &[0.0, 0.0, -big, u.x, u.y, 0.0, big]),
        4 => f("CYLNDR", &[0.0, 0.0, big, u.x, u.y, 0.0, big]),
        5 => {
            let cos = trig::cos_deg(d.between(55.0, 80.0));
            f("CONE", &[20.0 * s, 12.0 * s, 9.0 * s, 0.0, 0.0, -1.0, cos])
        }
        6 => {
            // Half axes a, b, c with the top at the origin.
            let [a, b, c] = [d.between(20.0, 60.0), d.between(20.0, 60.0), d.between(15.0, 30.0)]
                .map(|x| 1.0 / (x * x * s * s));
            let h = 1.0 / c.sqrt();
            quadric([a, b, c, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0 * c * h, 0.0])
        }
        7 | 8 => {
            // z = -(x^2/a + y^2/b) or the same upside down; radii a/2 and b/2 at the top.
            let sign = if kind == 7 { 1.0 } else { -1.0 };
            let [a, b] = [d.between(30.0, 90.0), d.between(30.0, 90.0)].map(|x| sign / (x * s));
            quadric([a, b, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0])
        }
        9 => {
            let k = 1.0 / (d.between(20.0, 60.0) * s);
            quadric([0.0, 0.0, 0.0, 0.0, 0.0, k, 0.0, 0.0, -1.0, 0.0])
        }
        10 => waves(d, u, Vec3::z(), 0.0, s),
        11 => ruled(d, u, Vec3::z(), 0.0, s),
        _ => polyconic(d, s),
    }
}

fn drive(d: &mut Dice, kind: u32, s: f64) -> Form {
    let w = direction(d.between(0.0, 360.0));
    let (wall, off) = (d.between(8.0, 40.0), d.between(1.0, 5.0));
    let f = |name: &str, w: &[f64]| form(name, w).expect("a legal form");
    let c = w * (wall + off) * s;
    match kind {
        0 => f("LINE", &[w.x, w.y, 0.0, off * s]),
        1 => f("CIRCLE", &[c.x, c.y, 0.0, 0.0, 0.0, 1.0, wall * s]),
        2 => f("PLANE", &[w.x, w.y, d.between(-0.4, 0.4), off * s]),
        3 => f("SPHERE", &[c.x, c.y, d.between(-5.0, 5.0) * s, wall * s]),
        4 => {
            let axis = d.sign();
            f("CONE", &[c.x, c.y, -axis * wall * s, 0.0, 0.0, axis, 0.5f64.sqrt()])
        }
        5 => {
            let c = w * (off - 12.0 - wall) * s;
            f("CIRCLE", &[c.x, c.y, 0.0, 0.0, 0.0, 1.0, (12.0 + wall) * s])
        }
        6 | 7 => {
            // An upright ellipse or hyperbola with its nearest vertex at w off.
            let (a, b) = (d.between(15.0, 40.0) * s, d.between(15.0, 40.0) * s);
            let v = Vec3::new(-w.y, w.x, 0.0);
            let c = w * (off * s + a);
            let sign = if kind == 6 { 1.0 } else { -1.0 };
            let (p, q) = (1.0 / (a * a), sign / (b * b));
            let k = |x: Vec3, y: Vec3, i: usize, j: usize| p * x[i] * x[j] + q * y[i] * y[j];
            let (xx, yy, xy) = (k(w, v, 0, 0), k(w, v, 1, 1), 2.0 * k(w, v, 0, 1));
            let lin = [-2.0 * xx * c.x - xy * c.y, -2.0 * yy * c.y - xy * c.x];
            let last = xx * c.x * c.x + yy * c.y * c.y + xy * c.x * c.y - 1.0;
            quadric([xx, yy, 0.0, 0.0, 0.0, xy, lin[0], lin[1], 0.0, last])
        }
        8 => {
            let v = Vec3::new(-w.y, w.x, 0.0);
            waves(d, v, w, off, s)
        }
        9 => {
            let v = Vec3::new(-w.y, w.x, 0.0);
            ruled(d, v, w, off, s)
        }
        _ => {
            // An ellipsoid beside the tool.
            let [a, b, c] = [0, 1, 2].map(|_| 1.0 / (d.between(20.0, 50.0) * s).powi(2));
            let m = w * (off * s + 1.0 / (a * w.x * w.x + b * w.y * w.y).sqrt());
            let last = a * m.x * m.x + b * m.y * m.y - 1.0;
            quadric([a, b, c, 0.0, 0.0, 0.0, -2.0 * a * m.x, -2.0 * b * m.y, 0.0, last])
        }
    }
}

/// A scene with its start-up, and in words what it is.
pub(crate) struct Scene {
    pub(crate) forms: Forms,
    pub(crate) setup: String,
    pub(crate) what: String,
    /// The kinds of part and drive surface.
    pub(crate) kinds: (u32, u32),
    /// Of the cutter, before scaling.
    pub(crate) radius: f64,
}

fn scene(d: &mut Dice, s: f64) -> Scene {
    let mut forms = Forms::new();
    let radius = d.between(1.0, 4.0);
    let corner = [0.0, 0.3, 1.0][d.pick(3) as usize] * radius;
    let (p, q) = (d.pick(13), d.pick(11));
    forms.insert("PS".into(), part(d, p, s));
    forms.insert("DS".into(), drive(d, q, s));
    let band = trig::pow(10.0, d.between(-5.0, -1.0)) * radius * s;
    let share = d.unit();
    let relation = if d.unit() < 0.3 { "ON" } else { "TO" };
    let (calc, height) = (["2DCALC", "3DCALC"][d.pick(2) as usize], d.between(0.5, 4.0));
    let setup = format!(
        "{calc}\nMAXDP/{}\nCUTTER/{},{},{},{},0,0,{}\nINTOL/{}\nOUTTOL/{}\nFROM/0,0,{}\nGO/{relation},DS,TO,PS",
        200.0 * s,
        2.0 * radius * s,
        corner * s,
        (radius - corner) * s,
        corner * s,
        20.0 * s,
        share * band,
        (1.0 - share) * band,
        height * s,
    );
    let what = format!(
        "{} and {} radius {radius:.2} corner {corner:.2} band {band:.1e} {relation} {calc}",
        PARTS[p as usize], DRIVES[q as usize]
    );
    Scene { forms, setup, what, kinds: (p, q), radius }
}

/// A scene with a motion from its start-up on; `None` where drive and part run too much alike for one. The
/// check surface stands across the way. The text of the refused start-up is an error.
pub(crate) fn motion(seed: u64, scale: f64) -> Option<Scene> {
    let mut d = Dice::new(seed);
    let s = scene(&mut d, scale);
    onward(&mut d, s, scale, false)
}

/// As [`motion`], with every kind of cutter, disks, THICK, leaning and turning axes, and every kind of check
/// surface.
pub(crate) fn wide(seed: u64, scale: f64) -> Option<Scene> {
    let mut d = Dice::new(seed ^ 0x5EED);
    let mut s = scene(&mut d, scale);
    let (p, q) = s.kinds;
    let radius = s.radius;
    let mut lines: Vec<String> = s.setup.lines().map(str::to_owned).collect();
    let at = |lines: &[String], word: &str| lines.iter().position(|l| l.starts_with(word)).unwrap();
    // The cutter.
    let [a, r] = [2.0 * radius * scale, d.between(0.1, 0.4) * radius * scale];
    let cutter = match d.pick(6) {
        0 => format!("CUTTER/{a},{r}"),
        1 => format!("CUTTER/{a},{}", 0.5 * a),
        // A cone with a sharp corner: its side leans by 10 degrees.
        2 => format!("CUTTER/{a},0,{},0,0,10,{}", 0.5 * a, 20.0 * scale),
        _ => lines[at(&lines, "CUTTER")].clone(),
    };
    let round = cutter.ends_with(&format!(",{}", 0.5 * a));
    let i = at(&lines, "CUTTER");
    lines[i] = if cutter.matches(',').count() == 1 {
        // The height that CUTTER has when none is given.
        let (d0, r0) = cutter["CUTTER/".len()..].split_once(',').unwrap();
        let (d0, r0): (f64, f64) = (d0.parse().unwrap(), r0.parse().unwrap());
        format!("CUTTER/{d0},{r0},{},{r0},0,0,{}", 0.5 * d0 - r0, 127.0 * scale)
    } else {
        cutter
    };
    let disk = d.pick(8);
    if disk < 2 {
        let (r, h) = (radius * scale * d.between(0.4, 1.0), d.between(0.0, 0.5) * scale);
        lines.insert(i + 1, format!("CUTTER/OPTION,{},{r},{h}", disk + 1));
    }
    let i = at(&lines, "INTOL");
    if d.unit() < 0.3 {
        let mut t = || d.between(-0.1, 0.5) * scale;
        lines.insert(i, format!("THICK/{},{},{}", t(), t(), t()));
    }
    // The axis. An end that is flat cannot lie in a hollow with its middle.
    let fits = round || !matches!(p, 2 | 4 | 8..);
    let i = at(&lines, "GO/");
    let lean = |d: &mut Dice| direction(d.between(0.0, 360.0)) * d.between(0.05, 0.3) + Vec3::z();
    let axis = match d.pick(10) {
        0 => {
            let v = lean(&mut d);
            Some(format!("{},{},{}", v.x, v.y, v.z))
        }
        1 if fits => Some("NORMPS".to_owned()),
        2 if fits => Some(format!("ATANGL,1,{}", d.between(2.0, 15.0))),
        3 if fits => {
            Some(format!("ATANGL,1,{},CUTANG,{}", d.between(6.0, 12.0), d.between(1.0, 5.0)))
        }
        // Along the rulings of a cone the cutter's side would lie over the vertex.
        4 if matches!(q, 1 | 5 | 6 | 8 | 9) => Some("PARLEL,2".to_owned()),
        5 => {
            let v = direction(d.between(0.0, 360.0)) + Vec3::z() * d.between(-0.2, 0.2);
            Some(format!("PERPTO,{},{},{}", v.x, v.y, v.z))
        }
        _ => None,
    };
    if let Some(axis) = axis {
        s.what += &format!(" axis {axis}");
        lines.insert(i, format!("TLAXIS/{axis}"));
        lines.insert(i, "MULTAX".to_owned());
    }
    s.setup = lines.join("\n");
    onward(&mut d, s, scale, true)
}

/// The motion from the start-up on.
fn onward(d: &mut Dice, mut s: Scene, scale: f64, all: bool) -> Option<Scene> {
    let start = run(&s.forms, &s.setup);
    if !start.diagnostics.is_empty() {
        return Some(s);
    }
    let te = start.end();
    let normal = |name: &str| {
        let surface = Surface::from_form(&s.forms[name]).expect("a surface");
        surface.foot(te).normal
    };
    let t = normal("DS").cross(&normal("PS"));
    if t.norm() < 0.2 {
        return None;
    }
    let t = t.normalize() * d.sign();
    let far = d.between(2.0, 7.0) * scale;
    let lean = Vec3::new(d.between(-0.3, 0.3), d.between(-0.3, 0.3), 0.0);
    let n = (t + lean).normalize();
    let at = te + t * far;
    let how = ["TO", "ON", "PAST"][d.pick(3) as usize];
    let how = if far > 6.0 * scale || how != "TO" { how } else { "ON" };
    let level = n.dot(&at) / scale;
    let across = n.cross(&Vec3::z()).normalize();
    let kind = d.pick(if all { 8 } else { 3 });
    s.what += &format!(" until {how} {}", CHECKS[kind as usize]);
    let check = match kind {
        3 => {
            let c = at + n * (25.0 * scale);
            form("CYLNDR", &[c.x, c.y, c.z, across.x, across.y, 0.6, 25.0 * scale])
        }
        4 => {
            let cos = 0.75_f64.sqrt();
            let c = at + n * (25.0 * scale) + Vec3::z() * (25.0 * 3.0_f64.sqrt() * scale);
            form("CONE", &[c.x, c.y, c.z, 0.0, 0.0, -1.0, cos])
        }
        5 => {
            let k = [20.0, 30.0, 25.0].map(|a: f64| 1.0 / (a * scale * a * scale));
            let reach = 1.0 / (k[0] * n.x * n.x + k[1] * n.y * n.y + k[2] * n.z * n.z).sqrt();
            let m = at + n * reach;
            let l = [0, 1, 2].map(|i| -2.0 * k[i] * m[i]);
            let last = k[0] * m.x * m.x + k[1] * m.y * m.y + k[2] * m.z * m.z - 1.0;
            Some(quadric([k[0], k[1], k[2], 0.0, 0.0, 0.0, l[0], l[1], l[2], last]))
        }
        6 => Some(waves(d, across, n, level, scale)),
        7 => Some(ruled(d, across, n, level, scale)),
        0 => {
            let c = at + n * (30.0 * scale);
            form("SPHERE", &[c.x, c.y, c.z, 30.0 * scale])
        }
        _ => form("PLANE", &[n.x, n.y, n.z, n.dot(&at)]),
    };
    s.forms.insert("CS".into(), check.expect("a check surface"));
    s.setup += &format!("\nINDIRV/{},{},{}\nGOFWD/DS,{how},CS", t.x, t.y, t.z);
    Some(s)
}
