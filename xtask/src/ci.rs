//! Everything that must hold before a change lands.

use crate::codegen::{self, Mode};
use crate::repository::cargo;
use crate::{test, tidy};

/// Formatting, lints, documentation, tidy, generated files, tests; stops at the first that fails.
pub(crate) fn run() -> Result<(), String> {
    step("formatting", &["fmt", "--all", "--check"], None)?;
    let lints = ["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"];
    step("lints", &lints, None)?;
    let documentation = ["doc", "--workspace", "--no-deps", "--document-private-items"];
    step("documentation", &documentation, Some(("RUSTDOCFLAGS", "-D warnings")))?;

    let fuzz = ["check", "--manifest-path", "fuzz/Cargo.toml", "--target-dir", "target/fuzz"];
    step("fuzz targets", &fuzz, None)?;
    tidy::run()?;
    codegen::run(Mode::Check)?;
    test::run()
}

fn step(name: &str, arguments: &[&str], variable: Option<(&str, &str)>) -> Result<(), String> {
    println!("xtask: {name}: cargo {}", arguments.join(" "));
    let status = cargo().args(arguments).envs(variable).status();
    match status {
        Ok(status) if status.success() => Ok(()),
        Ok(_) => Err(format!("{name} failed")),
        Err(error) => Err(format!("{name}: cargo does not start: {error}")),
    }
}
