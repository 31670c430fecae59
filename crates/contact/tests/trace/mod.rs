//! The trace of SSV3's routines: their variables, call by call.

use std::collections::BTreeMap;

use aptc_geometry::Vec3;

/// A traced call: its variables.
pub(crate) type Call = BTreeMap<String, Vec<f64>>;

/// The calls of a routine; none where the traces are not there.
pub(crate) fn calls(test: &str, routine: &str) -> Vec<Call> {
    let Some(path) = aptc_testkit::shared(test, "oracle/ssv3/routines.txt") else {
        return Vec::new();
    };
    let text = std::fs::read_to_string(path).expect("the trace");
    let mut all: Vec<Call> = Vec::new();
    let mut here = false;
    for line in text.lines() {
        if let Some(head) = line.strip_prefix('#') {
            here = head.split(' ').next() == Some(routine);
            if here {
                all.push(Call::new());
            }
        } else if here && let Some(call) = all.last_mut() {
            let mut words = line.split_ascii_whitespace();
            let name = words.next().unwrap_or("").to_owned();
            call.insert(name, words.filter_map(|w| w.parse().ok()).collect());
        }
    }
    all
}

pub(crate) fn v(call: &Call, name: &str) -> Vec3 {
    Vec3::new(call[name][0], call[name][1], call[name][2])
}

pub(crate) fn x(call: &Call, name: &str) -> f64 {
    call[name][0]
}
