//! Flat ends and bull noses over low waves, where places of the cutter far from each other touch in turn: each motion is
//! proved or refused.

use aptc_control::{Disk, Options, compile};

const PROGRAMS: u64 = 80;

/// Numbers that look random, of a fixed row for each seed.
struct Dice(u64);

impl Dice {
    /// Between two numbers, to four decimals.
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        #[expect(clippy::cast_precision_loss, reason = "53 bits are kept")]
        let share = (self.0 >> 11) as f64 / (1_u64 << 53) as f64;
        (1e4 * (low + (high - low) * share)).round() * 1e-4
    }

    fn one_of(&mut self, all: &[f64]) -> f64 {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a small index"
        )]
        let i = self.between(0.0, all.len() as f64 - 1e-3) as usize;
        all[i]
    }
}

/// A cutter of at most a wave's length along a slanting line over waves.
fn program(seed: u64) -> String {
    let mut dice = Dice(seed);
    let (height, length) = (dice.one_of(&[0.05, 0.1, 0.2, 0.3]), dice.one_of(&[8.0, 10.0, 12.0]));
    let mut waves = String::new();
    for i in -10..=10 {
        let up = if i % 2 == 0 { height } else { -height };
        let z = up * dice.between(0.5, 1.0);
        waves += &format!(",$\n{:.4},{z:.6}", 0.5 * length * f64::from(i));
    }
    let (s, c) = aptc_geometry::trig::sin_cos(dice.between(-0.7, 0.7));
    let off = dice.between(-2.0, 2.0);
    let cutter = [dice.one_of(&[4.0, 6.0, 8.0]), dice.one_of(&[0.0, 0.5, 1.0])];
    let [x, y] = [0, 1].map(|_| dice.between(-0.15, 0.15));
    let lean = if dice.between(0.0, 1.0) < 0.5 {
        String::new()
    } else {
        format!("TLAXIS/{x:.4},{y:.4},1\n")
    };
    let band = dice.one_of(&[0.005, 0.02, 0.05]);
    format!(
        "UNITS/MM\nT1=TABCYL/NOX,SPLINE{waves}\nL1=PLANE/{:.6},{c:.6},0,{off:.4}\nE0=PLANE/{c:.6},{s:.6},0,-15\n\
         E1=PLANE/{c:.6},{s:.6},0,15\nCUTTER/{},{}\nINTOL/0\nOUTTOL/{band}\nMULTAX\n{lean}FROM/{:.4},{:.4},25\n\
         GO/ON,L1,TO,T1,ON,E0\nINDIRV/{c:.6},{s:.6},0\nTLON,TLOFPS,GOFWD/L1,ON,E1\nFINI\n",
        -s,
        cutter[0],
        cutter[1],
        -18.0 * c,
        -18.0 * s
    )
}

#[test]
fn flat_ends_over_waves_are_proved_or_refused() {
    let (mut proved, mut bad) = (0, Vec::new());
    for seed in 0..PROGRAMS {
        let folder = tempfile::tempdir().expect("a folder of our own");
        let path = folder.path().join("waves.apt");
        std::fs::write(&path, program(seed)).expect("it can be written");
        let source = Disk::open(&path, 1 << 20).expect("it can be read");
        let mut world = Disk::new(Vec::new(), 1 << 20);
        let options = Options { post: false, plot: false, ..Options::default() };
        for part in compile(source, &mut world, &options).parts {
            let certificate = part.certificate.expect("it is proved in full");
            proved += u64::from(certificate.is_proved());
            if certificate.refuted + certificate.undecided > 0 {
                bad.push((seed, certificate.to_string()));
            }
        }
    }
    assert!(bad.is_empty(), "{bad:?}");
    assert!(proved >= PROGRAMS - 4, "{proved} of {PROGRAMS}");
}
