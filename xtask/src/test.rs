//! All tests, with a count of what passed, failed and was skipped.
//!
//! The harness of Rust knows no skipped test: one that misses its client passes. So such a test writes
//! a line to the file named by `APTC_SKIP_LOG` (`aptc_testkit::skip`), and here it is taken from the
//! passed ones, named and counted.

use std::collections::BTreeMap;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::Stdio;
use std::time::Instant;

use crate::clients;
use crate::repository::cargo;

/// Installs clients, builds, runs every test, prints the counts last.
pub(crate) fn run() -> Result<(), String> {
    let start = Instant::now();
    clients::install();
    build()?;
    let log = std::env::temp_dir().join(format!("aptc-skipped-{}", std::process::id()));
    std::fs::write(&log, "").map_err(|error| format!("{}: {error}", log.display()))?;
    let (mut counts, finished) = run_tests(&log)?;
    let skipped = Skipped::parse(&std::fs::read_to_string(&log).unwrap_or_default());
    std::fs::remove_file(&log).map_err(|error| format!("{}: {error}", log.display()))?;
    if !finished && counts.failed == 0 {
        // A test program that was killed, or that did not build, prints no count of its own.
        counts.failures.push("a test program ended without a result".to_owned());
        counts.failed = 1;
    }
    report(&counts, &skipped, start.elapsed().as_secs());
    let unattended = std::env::var_os("CI").is_some();
    if counts.failed > 0 {
        Err("tests failed".to_owned())
    } else if unattended && (skipped.forbidden() > 0 || counts.ignored > 0) {
        Err("nothing may be skipped where CI is set".to_owned())
    } else {
        Ok(())
    }
}

/// The program itself, which tests start, and then every test program.
fn build() -> Result<(), String> {
    for arguments in
        [["build", "--package", "aptc"].as_slice(), &["test", "--workspace", "--no-run"]]
    {
        let status = cargo().args(arguments).status();
        if !status.is_ok_and(|status| status.success()) {
            println!("0 passed, 1 failed, 0 skipped");
            return Err(format!("cargo {} failed", arguments.join(" ")));
        }
    }
    Ok(())
}

fn run_tests(log: &Path) -> Result<(Counts, bool), String> {
    let mut tests = cargo()
        .args(["test", "--workspace", "--no-fail-fast"])
        .env("APTC_SKIP_LOG", log)
        .stdout(Stdio::piped())
        .spawn()
        .map_err(|error| format!("cargo does not start: {error}"))?;
    let mut counts = Counts::default();
    let output = tests.stdout.take().expect("stdout is piped");
    for line in BufReader::new(output).split(b'\n') {
        let line = line.map_err(|error| format!("cannot read the tests' output: {error}"))?;
        let line = String::from_utf8_lossy(&line);
        counts.take(&line);
        if worth_reading(&line) {
            println!("{line}");
        }
    }
    let status = tests.wait().map_err(|error| format!("cargo does not end: {error}"))?;
    Ok((counts, status.success()))
}

/// A passing test is one line of thousands: only what else is said is printed.
fn worth_reading(line: &str) -> bool {
    let passed = line.starts_with("test ") && line.ends_with(" ... ok");
    let counted = line.starts_with("test result: ok. ") || line.starts_with("running ");
    !passed && !counted && !line.trim().is_empty() && !line.starts_with("all doctests ran")
}

fn report(counts: &Counts, skipped: &Skipped, seconds: u64) {
    println!();
    for name in &counts.failures {
        println!("failed   {name}");
    }
    for (name, (_, reason)) in &skipped.checks {
        println!("skipped  {name}: {reason}");
    }
    for name in &counts.ignored_names {
        println!("skipped  {name}: ignored");
    }
    let n_skipped = skipped.checks.len();
    println!("{seconds} s");
    println!(
        "{} passed, {} failed, {} skipped",
        counts.passed.saturating_sub(n_skipped),
        counts.failed,
        n_skipped + counts.ignored
    );
}

/// What the harness printed, summed over all test programs.
#[derive(Debug, Default, PartialEq, Eq)]
struct Counts {
    passed: usize,
    failed: usize,
    ignored: usize,
    failures: Vec<String>,
    ignored_names: Vec<String>,
}

impl Counts {
    fn take(&mut self, line: &str) {
        if let Some(test) = line.strip_prefix("test ") {
            if let Some(name) = test.strip_suffix(" ... FAILED") {
                self.failures.push(name.to_owned());
            } else if let Some((name, "ignored")) = test.split_once(" ... ") {
                self.ignored_names.push(name.to_owned());
            }
        }
        // "test result: ok. 12 passed; 0 failed; 0 ignored; 0 measured; ..."
        let Some(result) = line.strip_prefix("test result: ") else { return };
        let result = result.split_once(". ").map_or(result, |(_, counts)| counts);
        for count in result.split("; ") {
            match count.split_once(' ').map(|(n, what)| (n.parse::<usize>(), what)) {
                Some((Ok(n), "passed")) => self.passed += n,
                Some((Ok(n), "failed")) => self.failed += n,
                Some((Ok(n), "ignored")) => self.ignored += n,
                _ => {}
            }
        }
    }
}

/// Checks that wrote themselves into the log: name, kind, reason.
#[derive(Debug, PartialEq, Eq)]
struct Skipped {
    checks: BTreeMap<String, (String, String)>,
}

impl Skipped {
    fn parse(log: &str) -> Self {
        let mut checks = BTreeMap::new();
        for line in log.lines() {
            let mut fields = line.splitn(3, '\t').map(str::to_owned);
            if let (Some(kind), Some(name), Some(reason)) =
                (fields.next(), fields.next(), fields.next())
            {
                checks.insert(name, (kind, reason));
            }
        }
        Self { checks }
    }

    /// How many were skipped for another reason than data that is optional.
    fn forbidden(&self) -> usize {
        self.checks.values().filter(|(kind, _)| kind != "data").count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_summed_over_programs() {
        let mut counts = Counts::default();
        for line in [
            "running 3 tests",
            "test a::b ... ok",
            "test c ... FAILED",
            "test d ... ignored",
            "test result: FAILED. 1 passed; 1 failed; 1 ignored; 0 measured; 0 filtered out",
            "test result: ok. 41 passed; 0 failed; 0 ignored; 0 measured; 0 filtered out; finished in 0.1s",
        ] {
            counts.take(line);
        }
        assert_eq!((counts.passed, counts.failed, counts.ignored), (42, 1, 1));
        assert_eq!(counts.failures, ["c"]);
        assert_eq!(counts.ignored_names, ["d"]);
    }

    #[test]
    fn missing_clients_are_forbidden_and_missing_data_is_not() {
        let skipped = Skipped::parse(
            "client\trs274\tnot found\ndata\toracle\tabsent\ndata\toracle\tabsent\n",
        );
        assert_eq!(skipped.checks.len(), 2);
        assert_eq!(skipped.forbidden(), 1);
    }
}
