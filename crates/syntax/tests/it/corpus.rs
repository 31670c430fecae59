//! Real programs, where the folder of test data is present beside the project.

use std::fs;

use aptc_syntax::Options;
use aptc_testkit::shared;

use crate::show::read_with;

/// The files under a folder of the test data with their texts; none where it is absent.
pub(crate) fn files(test: &str, folder: &str) -> Vec<(String, String)> {
    let mut todo: Vec<_> = shared(test, &format!("corpus/{folder}")).into_iter().collect();
    let mut found = Vec::new();
    while let Some(path) = todo.pop() {
        if path.is_dir() {
            let entries = fs::read_dir(&path).expect("a folder that is there");
            todo.extend(entries.map(|e| e.expect("an entry").path()));
        } else if let Ok(bytes) = fs::read(&path) {
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            // A listing is no program.
            if !name.ends_with(".lst") {
                found.push((name, String::from_utf8_lossy(&bytes).into_owned()));
            }
        }
    }
    found.sort();
    found
}

/// Statements in error of a file, told line by line.
fn errors(name: &str, text: &str) -> Vec<String> {
    let (_, parsed, _) = read_with(text, &Options::default());
    let lines = parsed.diagnostics.iter().filter(|d| d.is_error()).map(|d| {
        let line = 1 + text[..d.span.start as usize].matches('\n').count();
        format!("{name}:{line}: {} {}", d.code, d.message)
    });
    lines.collect()
}

#[test]
fn programs_for_apt_360_have_no_statement_in_error() {
    for (name, text) in files("programs_for_apt_360_have_no_statement_in_error", "apt360") {
        assert_eq!(errors(&name, &text), [""; 0]);
    }
}

#[test]
fn programs_for_apt4_have_no_statement_in_error_but_dividing_lines() {
    for (name, text) in
        files("programs_for_apt4_have_no_statement_in_error_but_dividing_lines", "ssv3")
    {
        // Three files hold two programs, divided by a line such as `=====>`.
        let errors = errors(&name, &text);
        let allowed =
            if matches!(&name[..], "TEST10.DAT" | "TEST15.DAT" | "TEST16.DAT") { 2 } else { 0 };
        assert_eq!(errors.len(), allowed, "{errors:?}");
    }
}

#[test]
fn programs_for_ncl_give_at_most_one_message_a_statement() {
    for (name, text) in files("programs_for_ncl_give_at_most_one_message_a_statement", "ncl") {
        let (_, parsed, _) = read_with(&text, &Options::default());
        let errors = errors(&name, &text);
        assert!(errors.len() <= 3, "{errors:?}");
        for s in &parsed.program.statements {
            let within = parsed.diagnostics.iter().filter(|d| {
                d.is_error() && s.span.start <= d.span.start && d.span.end <= s.span.end
            });
            assert!(within.count() <= 1, "{name}:{}", s.line);
        }
    }
}

#[test]
fn every_truncation_gives_diagnostics_only() {
    for folder in ["apt360", "ssv3", "ncl"] {
        for (name, text) in files("every_truncation_gives_diagnostics_only", folder) {
            // Every byte of the small ones, and a spread of the large.
            let step = 1 + text.len() / 400;
            for end in (0..text.len()).step_by(step).filter(|&i| text.is_char_boundary(i)) {
                let (shown, parsed, _) = read_with(&text[..end], &Options::default());
                let bad = shown.iter().filter(|s| s.contains("error ")).count();
                let told: usize = parsed.diagnostics.iter().map(|d| 1 + d.labels.len()).sum();
                assert!(told >= bad, "{name} cut at {end}");
            }
        }
    }
}

#[test]
fn cl_files_of_other_makers_are_read_without_harm() {
    for folder in ["solidworks", "nx", "catia", "creo", "surfaces"] {
        for (name, text) in files("cl_files_of_other_makers_are_read_without_harm", folder) {
            let text: String = text.chars().take(200_000).collect();
            let (shown, _, _) = read_with(&text, &Options::default());
            assert!(!shown.is_empty(), "{name}");
        }
    }
}
