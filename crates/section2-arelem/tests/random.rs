//! Random scenes that have a solution: the motion is found and stays in its bands.

mod support;

use aptc_diagnostics::codes;
use aptc_geometry::{Surface, Vec3};
use support::{Forms, Run, assert_in_bands, form, run};

/// A small generator with a fixed sequence, so that a failing scene can be run again.
struct Dice(u64);

impl Dice {
    fn unit(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        #[expect(clippy::cast_precision_loss, reason = "31 bits")]
        let x = (self.0 >> 33) as f64;
        x / 2_147_483_648.0
    }

    fn between(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * self.unit()
    }

    fn pick(&mut self, n: u32) -> u32 {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "below n")]
        let k = (self.unit() * f64::from(n)) as u32;
        k.min(n - 1)
    }
}

fn direction(angle_deg: f64) -> Vec3 {
    Vec3::new(aptc_geometry::trig::cos_deg(angle_deg), aptc_geometry::trig::sin_deg(angle_deg), 0.0)
}

struct Scene {
    forms: Forms,
    setup: String,
    names: String,
}

fn scene(d: &mut Dice, scale: f64) -> Scene {
    let mut forms = Forms::new();
    let mut put = |name: &str, kind: &str, w: &[f64]| {
        forms.insert(name.into(), form(kind, w).expect("a legal form"));
    };
    let s = scale;
    let radius = d.between(1.0, 4.0);
    let corner = [0.0, 0.3, 1.0][d.pick(3) as usize] * radius;
    let turn = d.between(0.0, 360.0);
    let u = direction(turn);
    let big = d.between(15.0, 60.0);
    let part = d.pick(6);
    match part {
        0 => {
            let tilt = d.between(0.0, 25.0);
            let n = Vec3::z() + u * aptc_geometry::trig::tan(tilt.to_radians());
            put("PS", "PLANE", &[n.x, n.y, n.z, 0.0]);
        }
        1 => put("PS", "SPHERE", &[0.0, 0.0, -big * s, big * s]),
        2 => put("PS", "SPHERE", &[0.0, 0.0, big * s, big * s]),
        3 => put("PS", "CYLNDR", &[0.0, 0.0, -big * s, u.x, u.y, 0.0, big * s]),
        4 => put("PS", "CYLNDR", &[0.0, 0.0, big * s, u.x, u.y, 0.0, big * s]),
        _ => {
            let half = d.between(55.0, 80.0);
            let cos = aptc_geometry::trig::cos_deg(half);
            put("PS", "CONE", &[20.0 * s, 12.0 * s, 9.0 * s, 0.0, 0.0, -1.0, cos]);
        }
    }
    let w = direction(d.between(0.0, 360.0));
    let wall = d.between(8.0, 40.0);
    let off = d.between(1.0, 5.0);
    match d.pick(5) {
        0 => put("DS", "LINE", &[w.x, w.y, 0.0, off * s]),
        1 => {
            let c = w * (wall + off) * s;
            put("DS", "CIRCLE", &[c.x, c.y, 0.0, 0.0, 0.0, 1.0, wall * s]);
        }
        2 => put("DS", "PLANE", &[w.x, w.y, d.between(-0.4, 0.4), off * s]),
        3 => {
            let c = w * (wall + off) * s;
            put("DS", "SPHERE", &[c.x, c.y, d.between(-5.0, 5.0) * s, wall * s]);
        }
        _ => {
            let c = w * (wall + off) * s;
            let axis = if d.unit() < 0.5 { -1.0 } else { 1.0 };
            let z = -axis * wall;
            put("DS", "CONE", &[c.x, c.y, z * s, 0.0, 0.0, axis, 0.5f64.sqrt()]);
        }
    }
    let band = 10f64.powf_in(d.between(-4.0, -2.0)) * s;
    let share = d.unit();
    let relation = if d.unit() < 0.3 { "ON" } else { "TO" };
    let setup = format!(
        "MAXDP/{}\nCUTTER/{},{},{},{},0,0,{}\nINTOL/{}\nOUTTOL/{}\nFROM/0,0,{}\nGO/{relation},DS,TO,PS",
        200.0 * s,
        2.0 * radius * s,
        corner * s,
        (radius - corner) * s,
        corner * s,
        20.0 * s,
        share * band,
        (1.0 - share) * band,
        d.between(0.5, 4.0) * s,
    );
    let names = format!("part {part} radius {radius:.2} corner {corner:.2} band {band:.1e}");
    Scene { forms, setup, names }
}

trait Power {
    fn powf_in(self, e: f64) -> f64;
}

impl Power for f64 {
    fn powf_in(self, e: f64) -> f64 {
        aptc_geometry::trig::pow(self, e)
    }
}

/// A motion from the start-up on: its check surface stands across the way.
fn motion(d: &mut Dice, s: &Scene, scale: f64) -> Option<(Forms, String)> {
    let start = run(&s.forms, &s.setup);
    if !start.diagnostics.is_empty() {
        return None;
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
    let t = t.normalize() * if d.unit() < 0.5 { -1.0 } else { 1.0 };
    let far = d.between(2.0, 7.0) * scale;
    let lean = Vec3::new(d.between(-0.3, 0.3), d.between(-0.3, 0.3), 0.0);
    let n = (t + lean).normalize();
    let mut forms = s.forms.clone();
    let level = n.dot(&(te + t * far));
    forms.insert("CS".into(), form("PLANE", &[n.x, n.y, n.z, level]).expect("a plane"));
    let how = ["TO", "ON", "PAST"][d.pick(3) as usize];
    let far_enough = far > 6.0 * scale || how != "TO";
    let how = if far_enough { how } else { "ON" };
    Some((forms, format!("{}\nINDIRV/{},{},{}\nGOFWD/DS,{how},CS", s.setup, t.x, t.y, t.z)))
}

fn one(seed: u64, scale: f64) -> Option<(Run, String)> {
    let mut d = Dice(seed.wrapping_mul(7919).wrapping_add(17));
    for _ in 0..5 {
        d.unit();
    }
    let s = scene(&mut d, scale);
    let (forms, text) = motion(&mut d, &s, scale)?;
    Some((run(&forms, &text), format!("{}\n{forms:?}\n{text}", s.names)))
}

#[test]
fn solvable_scenes_are_solved_within_their_bands() {
    let (mut solved, mut refused, mut vectors) = (0, Vec::new(), 0);
    for seed in 0..1500 {
        let Some((ran, what)) = one(seed, 1.0) else { continue };
        // A surface that turns away before the cutter is past is solved too, with a warning.
        if ran.diagnostics.iter().all(|d| d.code == codes::COMES_BACK) {
            vectors += assert_in_bands(&ran, 8);
            solved += 1;
        } else {
            refused.push(format!("{seed}: {:?} {what}", ran.diagnostics[0].message));
        }
    }
    assert!(solved > 1000 && vectors > 10 * solved, "{solved} solved, {vectors} vectors");
    assert!(refused.len() * 100 <= solved + refused.len(), "{refused:#?}");
}

#[test]
fn another_unit_of_length_gives_the_same_path() {
    for seed in 0..60 {
        let Some((ran, what)) = one(seed, 1.0) else { continue };
        for scale in [25.4, 1e-3] {
            let Some((other, _)) = one(seed, scale) else { continue };
            let ends = |r: &Run| -> Vec<Vec3> {
                r.motions().flat_map(|(_, m)| m.points.iter().map(|p| p.te)).collect()
            };
            let (a, b) = (ends(&ran), ends(&other));
            assert_eq!(a.len(), b.len(), "{what}");
            for (p, q) in a.iter().zip(&b) {
                assert!((p - q / scale).norm() <= 1e-9 * (10.0 + p.norm()), "{p} {q} {what}");
            }
        }
    }
}
