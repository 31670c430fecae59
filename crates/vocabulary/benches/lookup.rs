//! How fast words are found: the lexer asks for each identifier.

use aptc_testkit::bench;
use aptc_vocabulary::{all, closest, find};

fn main() {
    // Half of what a program holds are words, half names of its own.
    let words = all().map(|word| word.text().to_owned());
    let names = (0..all().count()).map(|n| format!("P{n}"));
    let texts: Vec<String> = words.zip(names).flat_map(|(word, name)| [word, name]).collect();
    let millions = 1e-6 * f64::from(u32::try_from(texts.len()).unwrap_or(u32::MAX));
    bench::rate("vocabulary: find", millions, "million/s", Some(33.0), || {
        texts.iter().filter(|text| find(text).is_some()).count()
    });
    let slips = ["GOLFTT", "CLYNDR", "SPINDLE", "WIDGET"];
    bench::rate("vocabulary: closest", 4e-3, "thousand/s", None, || {
        slips.map(|text| closest(text, |_| true))
    });
}
