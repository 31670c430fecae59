//! Each Rust file by itself: size, module doc, and what may not stand in it.

use std::path::Path;

use super::Finding;
use crate::repository::{files, read, root};

/// Lines of a file without its tests. Tables may be longer.
const MOST_LINES: usize = 800;

/// Folders below Section 0, which alone meets the machine.
const BELOW_CONTROL: [&str; 13] = [
    "crates/cldata/",
    "crates/contact/",
    "crates/diagnostics/",
    "crates/geometry/",
    "crates/protap/",
    "crates/section1-translate/",
    "crates/section2-arelem/",
    "crates/section2-regional/",
    "crates/section3-edit/",
    "crates/section4-post/",
    "crates/syntax/",
    "crates/verify/",
    "crates/vocabulary/",
];

/// Files, environment, clock, threads and terminal: reached through Section 0's `World` only.
const MACHINE: [&str; 17] = [
    "std::fs",
    "std::env",
    "std::time",
    "std::thread",
    "std::process",
    "std::net",
    "io::stdin",
    "io::stdout",
    "io::stderr",
    "println!(",
    "print!(",
    "eprint!(",
    "ThreadPoolBuilder",
    "current_num_threads",
    "available_parallelism",
    "Instant::now",
    "SystemTime",
];

/// What stands nowhere. Broken in two, so that this file does not find itself.
const NOWHERE: [(&str, &str); 7] = [
    (concat!("#[ig", "nore"), "a test that does not run proves nothing"),
    (concat!("#[should", "_panic"), "assert the answer instead"),
    (concat!("to", "do!("), "unfinished"),
    (concat!("unimplement", "ed!("), "unfinished"),
    (concat!("TO", "DO"), "unfinished"),
    (concat!("FIX", "ME"), "unfinished"),
    (concat!("```ig", "nore"), "an example that does not run proves nothing"),
];

/// What is out of order in the Rust files.
pub(super) fn check() -> Result<Vec<Finding>, String> {
    let mut findings = Vec::new();
    for path in files()? {
        if path.extension().is_some_and(|extension| extension == "rs") {
            file_findings(&path, &read(&root().join(&path))?, &mut findings);
        }
    }
    Ok(findings)
}

fn file_findings(path: &Path, text: &str, findings: &mut Vec<Finding>) {
    let name = path.to_string_lossy().replace('\\', "/");
    let lines: Vec<&str> = text.lines().collect();
    let n_lines = lines_without_tests(&name, &lines);
    if n_lines > MOST_LINES && !is_table(&name) {
        findings.push(format!("{name}: {n_lines} lines without tests, {MOST_LINES} are allowed"));
    }
    if !text.starts_with("//!") {
        findings.push(format!("{name}: begins without a module doc"));
    }
    let below = BELOW_CONTROL.iter().any(|folder| name.starts_with(folder));
    for (line, number) in lines.iter().zip(1..) {
        for (banned, reason) in NOWHERE {
            if line.contains(banned) {
                findings.push(format!("{name}:{number}: `{banned}`: {reason}"));
            }
        }
        let code = line.split("//").next().unwrap_or_default();
        if number > n_lines || code.trim().is_empty() {
            continue;
        }
        if code.trim_start().starts_with("use ") && code.contains("::*") {
            findings.push(format!("{name}:{number}: glob import"));
        }
        if let Some(banned) = machine(code).filter(|_| below) {
            findings.push(format!("{name}:{number}: `{banned}` below Section 0"));
        }
    }
}

/// The first banned name in a line of code.
fn machine(code: &str) -> Option<&'static str> {
    let plain = MACHINE.into_iter().find(|banned| code.contains(banned));
    let grouped = || {
        let (_, group) = code.split_once("use std::{")?;
        let mut names = group.split([',', '{', '}', ':', ' ', ';']);
        let name = names.find(|n| ["fs", "env", "time", "thread", "process", "net"].contains(n))?;
        MACHINE.into_iter().find(|banned| banned.strip_prefix("std::") == Some(name))
    };
    plain.or_else(grouped)
}

/// Number of lines before the test module at the bottom; none are counted in a file of tests.
fn lines_without_tests(name: &str, lines: &[&str]) -> usize {
    let of_tests = ["/tests/", "/benches/", "/examples/"].iter().any(|part| name.contains(part));
    if of_tests || name.starts_with("tests/") || name.ends_with("tests.rs") {
        return 0;
    }
    lines.iter().position(|line| line.trim() == "#[cfg(test)]").map_or(lines.len(), |first| {
        let at = first + lines[first..].iter().take_while(|line| is_attribute(line)).count();
        // `mod tests;` only names a file: what follows it is not a test.
        let module = lines.get(at).is_some_and(|l| l.contains("mod ") && l.ends_with('{'));
        if module { first } else { lines.len() }
    })
}

/// A line of attributes, also one in the middle of a long attribute.
fn is_attribute(line: &str) -> bool {
    let line = line.trim();
    let inside = [",", "(", "\"", ")]"].iter().any(|end| line.ends_with(end));
    line.starts_with("#[") || inside
}

/// Tables are data in the clothes of code: generated files and the registry of codes.
fn is_table(name: &str) -> bool {
    name.ends_with("/table.rs") || name.ends_with("/tables.rs") || name.contains("/tables/")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn findings(name: &str, text: &str) -> Vec<Finding> {
        let mut findings = Vec::new();
        file_findings(Path::new(name), text, &mut findings);
        findings
    }

    #[test]
    fn the_machine_is_out_of_reach_below_section_0() {
        let text = "//! Doc.\nuse std::fs;\n";
        assert_eq!(findings("crates/geometry/src/lib.rs", text).len(), 1);
        assert_eq!(findings("crates/section0-control/src/lib.rs", text).len(), 0);
        assert_eq!(findings("crates/geometry/tests/oracle.rs", text).len(), 0);
        let grouped = "//! Doc.\nuse std::{fmt, time::Duration};\n";
        assert_eq!(findings("crates/cldata/src/lib.rs", grouped).len(), 1);
        let spoken = "//! Doc.\n// Not std::fs, because ...\nfn f() {} // std::env\n";
        assert_eq!(findings("crates/cldata/src/lib.rs", spoken).len(), 0);
        let tested = "//! Doc.\n#[cfg(test)]\nmod tests {\n    use std::fs;\n}\n";
        assert_eq!(findings("crates/cldata/src/lib.rs", tested).len(), 0);
    }

    #[test]
    fn long_files_are_found_without_their_tests() {
        let long = format!("//! Doc.\n{}", "fn f() {}\n".repeat(MOST_LINES));
        assert_eq!(findings("crates/aptc/src/main.rs", &long).len(), 1);
        assert_eq!(findings("crates/aptc/src/table.rs", &long).len(), 0);
        let tested = long.replacen("//! Doc.", "//! Doc.\n#[cfg(test)]\nmod tests {", 1);
        assert_eq!(findings("crates/aptc/src/main.rs", &tested).len(), 0);
    }

    #[test]
    fn a_test_module_may_have_attributes() {
        let text = "//! Doc.\n#[cfg(test)]\n#[expect(\n    a,\n    reason = \"r\"\n)]\npub(crate) mod \
                    tests {\n    use super::*;\n}\n";
        assert_eq!(findings("crates/aptc/src/a.rs", text), [""; 0]);
        let single = "//! Doc.\n#[cfg(test)]\nfn f() {}\nuse super::*;\n";
        assert_eq!(findings("crates/aptc/src/a.rs", single).len(), 1);
    }

    #[test]
    fn globs_and_missing_docs_are_found() {
        assert_eq!(findings("crates/aptc/src/a.rs", "use super::*;\n").len(), 2);
        assert_eq!(findings("crates/aptc/src/a.rs", "//! Doc.\npub use files::*;\n").len(), 0);
    }
}
