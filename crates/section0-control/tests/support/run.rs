//! Compiles a part program of a test: what is told, and where the tool goes.
#![allow(dead_code, reason = "each test program uses a part of it")]

use aptc_control::{Disk, Options, Source, Verify, compile};

/// What a program gave.
pub(crate) struct Ran {
    /// Code and text of each message.
    pub(crate) told: Vec<(String, String)>,
    /// Tool ends of all motions.
    pub(crate) places: Vec<[f64; 3]>,
    /// The tool axis at each.
    pub(crate) axes: Vec<[f64; 3]>,
}

/// Compiles a program without a post processor.
pub(crate) fn run(text: &str, verify: Verify) -> Ran {
    let options = Options { verify, post: false, ..Options::default() };
    let source = Source { name: "part".into(), text: text.into() };
    let compiled = compile(source, &mut Disk::new(Vec::new(), 0), &options);
    let told = compiled.diagnostics.iter().map(|d| (d.code.to_string(), d.message.clone()));
    let (mut places, mut axes) = (Vec::new(), Vec::new());
    for part in &compiled.parts {
        let take = |r: &aptc_cldata::Record| {
            if let aptc_cldata::Kind::Motion(m) = &r.kind {
                places.extend(m.points.iter().map(|p| <[f64; 3]>::from(p.te)));
                axes.extend(m.points.iter().map(|p| <[f64; 3]>::from(p.ta)));
            }
        };
        part.computed.for_each(take).expect("they can be read");
    }
    Ran { told: told.collect(), places, axes }
}

impl Ran {
    /// The codes of all messages.
    pub(crate) fn codes(&self) -> Vec<String> {
        self.told.iter().map(|(code, _)| code.clone()).collect()
    }

    /// The codes of what is wrong with path or proof.
    pub(crate) fn faults(&self) -> Vec<String> {
        let wrong = |c: &String| c.starts_with("APT2") || c.starts_with("APT5");
        self.codes().into_iter().filter(wrong).collect()
    }
}
