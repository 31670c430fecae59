//! The repository: where it lies, its files, its cargo.

use std::path::{Path, PathBuf};
use std::process::Command;

/// The folder that holds the workspace manifest.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("xtask lies in the root").to_path_buf()
}

/// The text of a file, or a message that names it.
pub(crate) fn read(path: &Path) -> Result<String, String> {
    std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))
}

/// The cargo that runs this chore, in the root.
pub(crate) fn cargo() -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.current_dir(root());
    command
}

/// A command of cargo whose programs need no shared library and lie in memory where they were linked to, as the package
/// has them: they start in a third less time.
/// With a target named, the flag is for the programs alone and not for build scripts.
pub(crate) fn linked_statically<'a>(command: &'a mut Command, triple: &str) -> &'a mut Command {
    command
        .args(["--target", triple])
        .env("RUSTFLAGS", "-C target-feature=+crt-static -C relocation-model=static")
}

pub(crate) fn target_folder() -> Result<PathBuf, String> {
    let output = cargo().args(["metadata", "--no-deps", "--format-version", "1"]).output();
    let output = output.map_err(|e| format!("cargo: {e}"))?;
    let metadata: serde_json::Value =
        serde_json::from_slice(&output.stdout).map_err(|e| format!("cargo metadata: {e}"))?;
    let folder = metadata["target_directory"].as_str().ok_or("cargo metadata: no target folder")?;
    Ok(PathBuf::from(folder))
}

/// The files under version control or about to be, relative to the root, sorted. In a tree without git,
/// all files but those of `target`.
pub(crate) fn files() -> Result<Vec<PathBuf>, String> {
    let listed = Command::new("git")
        .args(["ls-files", "-z", "--cached", "--others", "--exclude-standard"])
        .current_dir(root())
        .output();
    let mut files = match listed {
        Ok(output) if output.status.success() => String::from_utf8_lossy(&output.stdout)
            .split_terminator('\0')
            .map(PathBuf::from)
            .filter(|path| root().join(path).is_file())
            .collect(),
        _ => {
            let mut files = Vec::new();
            walk(&root(), &root(), &mut files)?;
            files
        }
    };
    files.sort();
    Ok(files)
}

fn walk(root: &Path, folder: &Path, files: &mut Vec<PathBuf>) -> Result<(), String> {
    let name = |error| format!("{}: {error}", folder.display());
    for entry in std::fs::read_dir(folder).map_err(name)? {
        let path = entry.map_err(name)?.path();
        if path.ends_with("target") || path.ends_with(".git") || path.is_symlink() {
            continue;
        }
        if path.is_dir() {
            walk(root, &path, files)?;
        } else if let Ok(relative) = path.strip_prefix(root) {
            files.push(relative.to_path_buf());
        }
    }
    Ok(())
}

/// The triple of this machine.
pub(crate) fn triple() -> Result<String, String> {
    let output = Command::new("rustc").arg("-vV").output().map_err(|e| format!("rustc: {e}"))?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let host = text.lines().find_map(|l| l.strip_prefix("host: "));
    host.map(str::to_owned).ok_or_else(|| "rustc does not name its host".to_owned())
}
