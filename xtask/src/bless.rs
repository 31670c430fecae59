//! Writes the goldens of the corpus anew.

use crate::repository::cargo;

/// Runs the chore with its option `[FILTER]`. Messages that a program does not expect still fail: they are
/// set right in the program, by hand.
pub(crate) fn run(options: &[&str]) -> Result<(), String> {
    let filter = options.first().copied().unwrap_or_default();
    let status = cargo()
        .args([
            "test",
            "--quiet",
            "--package",
            "aptc-tests",
            "--test",
            "corpus",
            "the_corpus_is_as_its_goldens",
            "--",
            "--nocapture",
        ])
        .env("APTC_BLESS", filter)
        .status()
        .map_err(|error| format!("cargo does not start: {error}"))?;
    if status.success() {
        println!("xtask: now read the changes: git diff corpus");
        Ok(())
    } else {
        Err("bless: some programs are not as they should be".to_owned())
    }
}
