//! Machines of three to five axes drawn at random: what is posted is proved and within the limits, whatever they are.

mod common;

use aptc_geometry::Vec3;
use aptc_post::{Carries, Machine, PostOptions, Rotary, machine, post_all};
use common::records;
use proptest::prelude::*;
use proptest::test_runner::{TestCaseError, TestRunner};

fn direction() -> impl Strategy<Value = [f64; 3]> {
    let nutated = (-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64)
        .prop_filter("a direction", |(x, y, z)| x * x + y * y + z * z > 0.1)
        .prop_map(|(x, y, z)| [x, y, z]);
    let usual = prop::sample::select(vec![
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, 1.0, 1.0],
        [-1.0, 0.0, 1.0],
    ]);
    prop_oneof![2 => usual, 1 => nutated]
}

fn rotary(letter: char) -> impl Strategy<Value = Rotary> {
    let place = (-100.0..100.0_f64, -100.0..100.0_f64, -100.0..100.0_f64);
    let limit = prop::option::weighted(0.6, 40.0..200.0_f64);
    (direction(), place, limit).prop_map(move |(axis, (x, y, z), limit)| Rotary {
        letter,
        carries: Carries::Part,
        axis,
        point: [x, y, z],
        min: limit.map(|l| -l),
        max: limit,
        wrap: Default::default(),
        max_feed: 3600.0,
        clamp: String::new(),
        unclamp: String::new(),
    })
}

/// Table, head, table-table, head-table or head-head, from the machine file of a LinuxCNC mill.
fn any_machine() -> impl Strategy<Value = Machine> {
    (0..6_usize, rotary('A'), rotary('C'), any::<bool>()).prop_map(|(kind, a, c, tool_center)| {
        let mut m = machine("linuxcnc-5axis").expect("built in").clone();
        let carries = |mut r: Rotary, carries| {
            r.carries = carries;
            r
        };
        let (part, tool) = (Carries::Part, Carries::Tool);
        m.rotary = match kind {
            0 => Vec::new(),
            1 => vec![carries(a, part)],
            2 => vec![carries(a, tool)],
            3 => vec![carries(a, part), carries(c, part)],
            4 => vec![carries(a, part), carries(c, tool)],
            _ => vec![carries(a, tool), carries(c, tool)],
        };
        m.multiaxis.tool_center = tool_center;
        for (letter, most) in [('X', 400.0), ('Y', 300.0), ('Z', 500.0)] {
            let axis = m.axes.entry(letter).or_default();
            (axis.min, axis.max) = (Some(-most), Some(most));
        }
        m
    })
}

/// The numbers after a letter in the words of motion.
fn values(nc: &str, letter: char) -> Vec<f64> {
    let motion = nc.lines().filter(|l| !l.starts_with('(') && !l.contains("G53"));
    motion.flat_map(|l| l.split(' ')).filter_map(|w| w.strip_prefix(letter)?.parse().ok()).collect()
}

type Step = ((f64, f64, f64), (f64, f64));

/// Was it posted? An error of the test says what is wrong with what was posted.
fn held(m: &Machine, path: &[Step]) -> Result<bool, TestCaseError> {
    let mut text = "UNITS/MM\nCUTTER/8\nLOADTL/1,LENGTH,90\nSPINDL/3000,CLW\nCOOLNT/ON\nFEDRAT/500\nMULTAX\nFROM/0,0,100\n".to_owned();
    for (i, ((x, y, z), (a, b))) in path.iter().enumerate() {
        // A machine with fewer axes gets tool axes that it can have: along Z, or across its one axis.
        let lean = match m.rotary.as_slice() {
            [] => Vec3::z(),
            [one] => {
                let d = Vec3::from(one.axis).normalize();
                let (s, c) = aptc_geometry::trig::sin_cos(*a);
                Vec3::z() * c + d.cross(&Vec3::z()) * s + d * (d.z * (1.0 - c))
            }
            _ => Vec3::new(*a, *b, 1.0).normalize(),
        };
        let rapid = if i == 0 { "RAPID\n" } else { "" };
        text.push_str(&format!("{rapid}GOTO/{x},{y},{z},{},{},{}\n", lean.x, lean.y, lean.z));
    }
    text.push_str("FINI");
    let records = records(&text);
    let (nc, posted) = post_all(m, PostOptions::default(), &records);
    let errors: Vec<_> = posted.diagnostics.iter().filter(|d| d.is_error()).collect();
    if !errors.is_empty() {
        // Out of reach, beyond a limit, or a turn-over: told, never a text that is not the CL data.
        let told = |c: &str| ["APT4004", "APT4008", "APT4023"].contains(&c);
        prop_assert!(
            errors.iter().all(|d| told(&d.code.to_string())),
            "{:?}\n{:#?}\n{}",
            m.rotary,
            errors,
            nc
        );
        return Ok(false);
    }
    let proof = posted.proof.expect("it was read back");
    prop_assert!(proof.points >= path.len() as u64, "{:?}", proof);
    prop_assert!(
        proof.position_mm < 0.0003 && proof.path_mm <= m.multiaxis.lintol + 0.0003,
        "{:?}",
        proof
    );
    for (letter, axis) in &m.axes {
        for v in values(&nc, *letter) {
            prop_assert!(
                axis.max.is_none_or(|most| v.abs() <= most + 1e-4),
                "{}{}\n{}",
                letter,
                v,
                nc
            );
        }
    }
    for r in &m.rotary {
        for v in values(&nc, r.letter) {
            prop_assert!(
                r.max.is_none_or(|most| v.abs() <= most + 1e-4),
                "{}{}\n{}",
                r.letter,
                v,
                nc
            );
        }
    }
    // The same text wherever and whenever it is made.
    let elsewhere = std::thread::scope(|s| {
        s.spawn(|| post_all(m, PostOptions::default(), &records).0).join().expect("it ran")
    });
    prop_assert_eq!(nc, elsewhere);
    Ok(true)
}

#[test]
fn what_is_posted_is_proved_and_within_the_limits() {
    let place = (-80.0..80.0_f64, -80.0..80.0_f64, -40.0..40.0_f64);
    let path = prop::collection::vec((place, (-0.6..0.6_f64, -0.6..0.6_f64)), 2..8);
    let mut runner = TestRunner::new(ProptestConfig::with_cases(400));
    let posted = std::cell::Cell::new(0);
    let done = runner.run(&(any_machine(), path), |(m, path)| {
        posted.set(posted.get() + u32::from(held(&m, &path)?));
        Ok(())
    });
    assert!(done.is_ok(), "{}", done.unwrap_err());
    assert!(posted.get() > 100, "only {} of 400 were within reach", posted.get());
}
