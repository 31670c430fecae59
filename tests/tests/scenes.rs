//! Random scenes that the proof did not decide once: it does.

#[path = "../../crates/section2-arelem/tests/support/mod.rs"]
mod support;

use aptc_verify::{Effort, Verifier};
use support::run;
use support::scene::wide;

#[test]
fn what_was_left_open_once_is_proved() {
    let scenes = [
        // A flat end that slides over a dome in it, just within its band.
        750_746,
        // The rim of a disk in a dome, and in a wall beside the border of a chart.
        715_343, 762_404,
        // A flank nearly along rulings, from the end of which the gap rises by a millionth.
        704_822,
    ];
    for seed in scenes {
        let scene = wide(seed, 1.0).expect("a scene");
        let ran = run(&scene.forms, &scene.setup);
        let mut verifier = Verifier::new(Effort::Full);
        for record in &ran.cl {
            verifier.push(record);
        }
        let (certificate, _) = verifier.finish();
        let faults = certificate.statements.iter().filter_map(|s| s.fault.as_ref());
        assert_eq!(faults.count(), 0, "{seed} {}", scene.what);
        assert!(certificate.proved > 1, "{seed}");
    }
}
