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
    if is_fast_to_start() {
        println!("cargo::rustc-link-arg-bins=-no-pie");
        if let Some(folder) = archives(&out) {
            println!("cargo::rustc-link-arg-bins=-L{}", folder.display());
            println!("cargo::rustc-link-arg-bins=-static");
        }
    }
    let commit = git(&root, &["rev-parse", "--short", "HEAD"]).unwrap_or_default();
    println!("cargo::rustc-env=APTC_COMMIT={commit}");
}

/// Is the program linked to addresses of its own, and without shared libraries where their archives are at hand? Nothing is left
/// to put right or to look up at each start then, which is a third of it; as in the package, where cargo is told so.
fn is_fast_to_start() -> bool {
    let is = |name: &str, value: &str| env::var(name).is_ok_and(|v| v == value);
    let told = env::var("CARGO_CFG_TARGET_FEATURE").is_ok_and(|f| f.contains("crt-static"));
    is("PROFILE", "release")
        && is("CARGO_CFG_TARGET_ARCH", "x86_64")
        && is("CARGO_CFG_TARGET_OS", "linux")
        && is("CARGO_CFG_TARGET_ENV", "gnu")
        && env::var("HOST") == env::var("TARGET")
        && !told
}

/// A folder in which the archives of the C library stand under the names of its shared libraries; `None` where one is missing.
///
/// Cargo leaves out shared libraries only where the target is named on its command line. The linker looks into this folder
/// first, and takes what it is led to.
fn archives(out: &Path) -> Option<PathBuf> {
    let names = ["m", "c", "util", "rt", "pthread", "dl"].map(|n| (n, format!("lib{n}.a")));
    let unwinder = ("gcc_s", "libgcc_eh.a".to_owned());
    let folder = out.join("archives");
    fs::create_dir_all(&folder).ok()?;
    for (name, archive) in names.into_iter().chain([unwinder]) {
        let lead = format!("INPUT({})\n", archive_at(&archive)?.display());
        fs::write(folder.join(format!("lib{name}.so")), lead).ok()?;
    }
    Some(folder)
}

/// Where the linker has an archive; `None` where it has none.
fn archive_at(name: &str) -> Option<PathBuf> {
    let linker = env::var("RUSTC_LINKER").unwrap_or_else(|_| "cc".to_owned());
    let output = Command::new(linker).arg(format!("-print-file-name={name}")).output().ok()?;
    let path = PathBuf::from(String::from_utf8(output.stdout).ok()?.trim());
    (output.status.success() && path.is_absolute()).then_some(path)
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
