//! CL files of real systems: each posts for a fitting machine, or stands on the list with its diagnostic.

mod common;

use aptc_cldata::Kind;
use aptc_post::{PostOptions, machine, post_all};
use common::file_records as read;

/// Files that are refused, and why.
const REFUSED: &[(&str, &str)] = &[
    // A tap without clearance words: depth and one more number, and no feed anywhere.
    ("catia/DEMO2.txt", "APT4001"),
    // The front end wrote no FEDRAT.
    ("ncl/upside_down.as", "APT4001"),
];

#[test]
fn files_of_real_systems() {
    let Some(corpus) = aptc_testkit::shared("post::files_of_real_systems", "corpus") else {
        return;
    };
    let (mut n, mut listed) = (0, 0);
    for folder in ["solidworks", "nx", "creo", "catia", "ncl"] {
        let mut files: Vec<_> =
            std::fs::read_dir(corpus.join(folder)).unwrap().map(|f| f.unwrap().path()).collect();
        files.sort();
        for file in files.iter().filter(|f| f.is_file()) {
            let records = read(file);
            let motion = records.iter().filter(|r| matches!(r.kind, Kind::Motion(_))).count();
            // Sources of NCL and machine code lie there too.
            if motion == 0 {
                continue;
            }
            let name = format!("{folder}/{}", file.file_name().unwrap().to_string_lossy());
            let mut refusals = Vec::new();
            let posted = ["linuxcnc-mill", "linuxcnc-5axis", "linuxcnc-5axis-bar"]
                .into_iter()
                .find_map(|m| {
                    let (nc, posted) =
                        post_all(machine(m).unwrap(), PostOptions::default(), &records);
                    let errors = posted.diagnostics.into_iter().filter(|d| d.is_error());
                    refusals.extend(errors.map(|d| (d.code.to_string(), d.message)));
                    let bad = refusals.iter().any(|(code, _)| code == "APT5401");
                    assert!(!bad, "{name} for {m}: {refusals:?}");
                    posted.summary.blocks.gt(&0).then_some(())?;
                    refusals.is_empty().then_some((nc, posted.proof)).or_else(|| {
                        // Only a tool axis is a reason to try another machine.
                        refusals.retain(|(code, _)| code != "APT4004");
                        None
                    })
                });
            n += 1;
            match (posted, REFUSED.iter().find(|(f, _)| *f == name)) {
                (Some((nc, proof)), None) => {
                    if let Some(Err(e)) = common::rs274(&nc) {
                        panic!("{name}: {e}");
                    }
                    let proof = proof.unwrap();
                    assert!(proof.points > 0, "{name}");
                    assert!(
                        proof.position_mm < 0.0003 && proof.path_mm < 0.0101,
                        "{name}: {proof:?}"
                    );
                }
                (None, Some((_, code))) => {
                    listed += 1;
                    assert_eq!(refusals.first().map(|r| r.0.as_str()), Some(*code), "{name}");
                }
                (None, None) => panic!("{name}: {refusals:?}"),
                (Some(_), Some(_)) => panic!("{name} posts now: take it off the list"),
            }
        }
    }
    assert_eq!(listed, REFUSED.len());
    assert!(n > 40, "{n} files only");
}

#[test]
fn tapes_of_apt360() {
    let Some(oracle) = aptc_testkit::shared("post::tapes_of_apt360", "oracle/apt360") else {
        return;
    };
    let mut files: Vec<_> = std::fs::read_dir(oracle).unwrap().map(|f| f.unwrap().path()).collect();
    files.sort();
    let mut n_good = 0;
    for file in files.iter().filter(|f| f.to_string_lossy().ends_with(".cl.tap")) {
        let records = read(file);
        for name in ["linuxcnc-mill", "linuxcnc-5axis-bar", "linuxcnc-5axis", "linuxcnc-5axis-head"]
        {
            let (nc, posted) = post_all(machine(name).unwrap(), PostOptions::default(), &records);
            let errors: Vec<_> = posted.diagnostics.into_iter().filter(|d| d.is_error()).collect();
            let refused = errors.iter().all(|d| {
                matches!(d.code.to_string().as_str(), "APT4001" | "APT4004" | "APT4005" | "APT4023")
            });
            assert!(refused, "{} for {name}: {errors:#?}", file.display());
            if errors.is_empty() {
                n_good += 1;
                if let Some(Err(e)) = common::rs274(&nc) {
                    panic!("{} for {name}: {e}", file.display());
                }
            }
        }
    }
    assert!(n_good >= 30, "{n_good}");
}
