//! What tests of every crate share: skipped checks, optional data, the built program.
//!
//! A test that cannot run here says so and returns:
//!
//! ```no_run
//! use aptc_testkit::{client, shared};
//!
//! fn the_control_accepts_our_blocks() {
//!     let Some(rs274) = client("the_control_accepts_our_blocks", "rs274") else { return };
//!     // start it ...
//! }
//!
//! fn sines_agree_with_the_oracle() {
//!     let Some(file) = shared("sines_agree_with_the_oracle", "oracle/apt360/sine.json") else { return };
//!     // read it ...
//! }
//! ```
//!
//! `cargo xtask test` counts such tests as skipped, not as passed, and names them.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a test talks to who runs it")]

pub mod bench;

use std::io::Write as _;
use std::path::{Path, PathBuf};

/// Records that the check `name` cannot run here. Where `CI` is set, the run then fails.
///
/// A test that would skip a part of what it checks is to be divided in two.
pub fn skip(name: &str, reason: &str) {
    record("client", name, reason);
}

/// A file or folder of the optional data that may lie in `../shared` beside the repository. `None`, and
/// a skipped check, where it is absent; that is allowed everywhere.
pub fn shared(name: &str, relative: &str) -> Option<PathBuf> {
    let path = repository().parent()?.join("shared").join(relative);
    if path.exists() {
        return Some(path);
    }
    record("data", name, &format!("../shared/{relative} is absent"));
    None
}

/// A program of others on the search path. `None`, and a skipped check, where it is missing.
pub fn client(name: &str, program: &str) -> Option<PathBuf> {
    let search = std::env::var_os("PATH").unwrap_or_default();
    let found = std::env::split_paths(&search).map(|folder| folder.join(program));
    let found = found.into_iter().find(|path| path.is_file());
    if found.is_none() {
        skip(name, &format!("`{program}` is not installed"));
    }
    found
}

/// The folder of the workspace.
pub fn repository() -> &'static Path {
    let kit = Path::new(env!("CARGO_MANIFEST_DIR"));
    kit.parent().and_then(Path::parent).expect("the kit lies in tests/kit")
}

/// The `aptc` that was built beside the running test.
///
/// # Panics
/// When there is none: `cargo xtask test` builds it first, `cargo build` makes it by hand.
pub fn aptc() -> PathBuf {
    let test = std::env::current_exe().expect("a test knows its own program");
    // target/debug/deps/test-1234 and target/debug/aptc; a documentation test lies elsewhere.
    let beside = test.ancestors().skip(1).map(|folder| folder.join("aptc")).find(|p| p.is_file());
    beside.unwrap_or_else(|| panic!("no `aptc` above {}: run `cargo build` first", test.display()))
}

fn record(kind: &str, name: &str, reason: &str) {
    eprintln!("SKIPPED: {name}: {reason}");
    let Some(log) = std::env::var_os("APTC_SKIP_LOG") else { return };
    let line = format!("{kind}\t{name}\t{reason}\n");
    let file = std::fs::OpenOptions::new().append(true).create(true).open(&log);
    // One write, so that lines of tests running side by side do not mix.
    let written = file.and_then(|mut file| file.write_all(line.as_bytes()));
    written.unwrap_or_else(|error| panic!("{}: {error}", log.display()));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_repository_holds_the_workspace() {
        assert!(repository().join("Cargo.lock").is_file());
    }
}
