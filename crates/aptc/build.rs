//! Puts the pages of `docs/errors` into the program, for `aptc explain`, and the commit for `--version`.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

fn main() {
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR").expect("cargo sets it")).join("../..");
    let out = PathBuf::from(env::var("OUT_DIR").expect("cargo sets it"));
    fs::write(out.join("pages.rs"), pages(&root.join("docs/errors"))).expect("OUT_DIR is writable");
    println!("cargo::rerun-if-changed=../../docs/errors");
    // Each commit writes it; a worktree has its own.
    if let Some(log) =
        git(&root, &["rev-parse", "--path-format=absolute", "--git-path", "logs/HEAD"])
    {
        println!("cargo::rerun-if-changed={log}");
    }
    if at_fixed_addresses() {
        println!("cargo::rustc-link-arg-bins=-no-pie");
    }
    let commit = git(&root, &["rev-parse", "--short", "HEAD"]).unwrap_or_default();
    println!("cargo::rustc-env=APTC_COMMIT={commit}");
}

/// Is the program linked to addresses of its own? Nothing is left to put right at each start then, which is a seventh of
/// it; as in the package, where the whole of it stands in one file.
fn at_fixed_addresses() -> bool {
    let is = |name: &str, value: &str| env::var(name).is_ok_and(|v| v == value);
    is("PROFILE", "release")
        && is("CARGO_CFG_TARGET_ARCH", "x86_64")
        && is("CARGO_CFG_TARGET_OS", "linux")
        && is("CARGO_CFG_TARGET_ENV", "gnu")
}

/// What git prints; `None` where there is no git or no repository.
fn git(root: &Path, arguments: &[&str]) -> Option<String> {
    let output = Command::new("git").args(arguments).current_dir(root).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| text.trim().to_owned())
}

/// A slice of (code, page) in order of code.
fn pages(folder: &Path) -> String {
    let mut files: Vec<PathBuf> =
        fs::read_dir(folder).map(|d| d.flatten().map(|e| e.path()).collect()).unwrap_or_default();
    files.retain(|p| p.extension().is_some_and(|e| e == "md"));
    files.sort();
    let mut code = String::from("&[\n");
    for file in files {
        let path = file.canonicalize().expect("it was just listed");
        let stem = file.file_stem().and_then(|s| s.to_str()).unwrap_or_default();
        writeln!(code, "({stem:?}, include_str!({path:?})),").expect("strings take all");
    }
    code + "]"
}
