//! The corpus: every program against its goldens, and against a real control.
//!
//! `cargo xtask bless` sets `APTC_BLESS`, which writes the goldens of the programs whose name contains its
//! value anew.

use std::io::{Cursor, Read};
use std::path::Path;

use aptc_control::{Artifact, ClOptions, CodeOptions, Options, Source, post_cl, resume};
use aptc_golden::{Case, Fault, Mode, Stage, discover, run};
use aptc_testkit::repository;

#[test]
fn the_corpus_is_as_its_goldens() {
    let wanted = std::env::var("APTC_BLESS").ok();
    let mode = if wanted.is_some() { Mode::Bless } else { Mode::Compare };
    let filter = wanted.unwrap_or_default();
    let report = run(&repository().join("corpus"), &filter, mode, aptc_golden::compile)
        .expect("the corpus can be read");
    assert!(report.n_cases() > 0, "no program is called {filter}");
    println!("{report}");
    assert!(report.is_good(), "{report}\ncargo xtask bless takes changes over that are right");
}

#[test]
fn goldens_without_a_program_are_found() {
    let mut orphans = Vec::new();
    collect_orphans(&repository().join("corpus"), &mut orphans);
    assert_eq!(orphans, [""; 0], "goldens whose program is gone");
    let topics = discover(&repository().join("corpus"), "").expect("the corpus can be read");
    assert!(topics.len() >= 15, "{} programs", topics.len());
}

/// Folders with a golden and no program.
fn collect_orphans(folder: &Path, orphans: &mut Vec<String>) {
    let entries = std::fs::read_dir(folder).expect("the corpus can be read");
    let paths: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
    let golden = |path: &Path| {
        path.file_name().is_some_and(|n| {
            let name = n.to_string_lossy();
            name.starts_with("program.") && name != "program.apt"
        })
    };
    if paths.iter().any(|path| golden(path)) && !folder.join("program.apt").is_file() {
        orphans.push(folder.display().to_string());
    }
    paths.iter().filter(|path| path.is_dir()).for_each(|path| collect_orphans(path, orphans));
}

#[test]
fn a_changed_golden_of_the_corpus_is_found() {
    let corpus = repository().join("corpus/mill/wedge");
    let copy = tempfile::tempdir().expect("a folder");
    for entry in std::fs::read_dir(corpus).expect("it is there").flatten() {
        std::fs::copy(entry.path(), copy.path().join(entry.file_name())).expect("it is copied");
    }
    let faults = || -> Vec<Fault> {
        let report = run(copy.path(), "", Mode::Compare, aptc_golden::compile).expect("it runs");
        report.faults().map(|(_, fault)| fault.clone()).collect()
    };
    assert_eq!(faults(), []);
    let change = |file: &str, from: &str, to: &str| {
        let path = copy.path().join(file);
        let text = std::fs::read_to_string(&path).expect("a golden");
        assert!(text.contains(from), "{file} has {from}");
        std::fs::write(path, text.replacen(from, to, 1)).expect("it is written");
    };
    change("program.nc", "G1 ", "G01 ");
    change("program.cl", "$$ LINE 11", "$$ LINE 12");
    assert!(faults().iter().all(|fault| matches!(fault, Fault::Cosmetic(..))), "{:?}", faults());
    assert_eq!(faults().len(), 2);
    change("program.nc", "X106", "X107");
    std::fs::remove_file(copy.path().join("program.protap")).expect("it was there");
    std::fs::write(copy.path().join("program.edited.cl"), "FINI\n").expect("it is written");
    let mut found = faults();
    found.retain(|fault| !matches!(fault, Fault::Cosmetic(..)));
    assert!(
        matches!(found.as_slice(), [Fault::NoGolden(_), Fault::Orphan(_), Fault::Changed { .. }]),
        "{found:?}"
    );
}

/// Programs whose goldens have machine code.
fn with_code() -> Vec<Case> {
    let cases = discover(&repository().join("corpus"), "").expect("the corpus can be read");
    let good = cases.into_iter().filter(|case| case.goldens.join("program.nc").is_file());
    let good: Vec<Case> = good.collect();
    assert!(good.len() >= 15);
    good
}

fn golden(case: &Case, stage: Stage) -> Option<String> {
    std::fs::read_to_string(case.goldens.join(stage.file())).ok()
}

#[test]
fn machine_code_is_the_same_from_cl_text() {
    for case in with_code() {
        let edited = golden(&case, Stage::EditedCl).or_else(|| golden(&case, Stage::Cl));
        let text = edited.expect("where there is machine code there are CL data").into_bytes();
        let mut open = || Ok(Box::new(Cursor::new(text.clone())) as Box<dyn Read>);
        let (cl, code) = (ClOptions::default(), CodeOptions::default());
        let posted = post_cl("program.cl", &mut open, cl, &code, &mut || Ok(Vec::new()));
        let texts = posted.expect("memory can be read").texts.concat();
        let code = String::from_utf8(texts).expect("machine code is text");
        assert_eq!(Some(code), golden(&case, Stage::Nc), "{}", case.name);
    }
}

#[test]
fn a_numeric_part_program_gives_the_same_cl_data_and_code() {
    for case in with_code() {
        let text = golden(&case, Stage::Protap).expect("there is one of every good program");
        let source = Source { name: "program.protap".into(), text: text.into() };
        let resumed = resume(source, &Options { plot: false, ..Options::default() });
        for (artifact, stages) in
            [(Artifact::Cl, [Stage::EditedCl, Stage::Cl]), (Artifact::Nc, [Stage::Nc, Stage::Nc])]
        {
            let files = resumed.artifact(artifact, false).expect("they can be read");
            let made: String =
                files.iter().map(|(_, bytes)| String::from_utf8_lossy(bytes)).collect();
            let expected = stages.into_iter().find_map(|stage| golden(&case, stage));
            assert_eq!(Some(made), expected, "{}", case.name);
        }
    }
}
