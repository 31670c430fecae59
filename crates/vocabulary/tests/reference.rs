//! Every word that the public tables of APT-360 and APT4 have is in ours.
//!
//! The list is not part of this project; without it the test says so and passes.

use aptc_vocabulary::{Dialect, find_in};

#[test]
fn no_word_of_apt_is_missing() {
    let name = "no_word_of_apt_is_missing";
    let Some(path) = aptc_testkit::shared(name, "reference/vocabulary.tsv") else { return };
    let text = std::fs::read_to_string(path).expect("a table");
    let mut missing = Vec::new();
    let mut n = 0;
    for line in text.lines().skip(1) {
        let fields: Vec<&str> = line.split('\t').collect();
        let [word, _, _, _, sources] = fields[..] else { panic!("{line}") };
        for (source, dialect) in [("APT360:", Dialect::Apt360), ("APT4SSV3:", Dialect::Apt4)] {
            if !sources.contains(source) {
                continue;
            }
            n += 1;
            let known = find_in(word, dialect).is_some();
            if !known {
                missing.push(format!("{word} of {}", dialect.name()));
            }
        }
    }
    assert!(n > 900, "{n} rows");
    missing.dedup();
    assert!(missing.is_empty(), "{} words: {missing:?}", missing.len());
}
