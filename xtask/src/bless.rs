//! Writes the goldens of the corpus and the pictures of the book anew.

use crate::repository::cargo;

/// Runs the chore with its option `[FILTER]`; `formats` and `pictures` mean those of the book.
/// Messages that a program does not expect still fail: they are set right in the program, by hand.
pub(crate) fn run(options: &[&str]) -> Result<(), String> {
    let filter = options.first().copied().unwrap_or_default();
    if matches!(filter, "" | "formats") {
        bless("formats", "each_picture_is_what_its_program_gives", "formats")?;
    }
    if !matches!(filter, "formats" | "pictures") {
        bless("corpus", "the_corpus_is_as_its_goldens", filter)?;
    }
    if matches!(filter, "" | "pictures") {
        bless("pictures", "each_picture_of_a_part_is_what_its_program_gives", "pictures")?;
    }
    println!("xtask: now read the changes: git diff corpus docs");
    Ok(())
}

/// Runs a test that writes what it would compare.
fn bless(file: &str, test: &str, filter: &str) -> Result<(), String> {
    let status = cargo()
        .args(["test", "--quiet", "--package", "aptc-tests", "--test", file, test])
        .args(["--", "--nocapture"])
        .env("APTC_BLESS", filter)
        .status()
        .map_err(|error| format!("cargo does not start: {error}"))?;
    if status.success() { Ok(()) } else { Err(format!("bless: {test} finds faults")) }
}
