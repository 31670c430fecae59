//! Every file under version control: the project speaks of itself alone.

use std::path::Path;

use super::Finding;
use crate::repository::{files, root};

/// Words of a workplace, not of the project. Broken in two, so that this file does not find itself.
const FOREIGN: [&str; 8] = [
    concat!("ses", "sion"),
    concat!("sub", "agent"),
    concat!("issue", " #"),
    concat!("/wo", "rk/"),
    concat!("/ro", "ot/"),
    concat!("/tm", "p/bash"),
    concat!("clau", "de"),
    concat!("anthro", "pic"),
];

/// The one registry that the lock file may name.
const REGISTRY: &str = "registry+https://github.com/rust-lang/crates.io-index";

/// Files that are neither text of ours nor meant for reading.
const NOT_READ: [&str; 6] = ["png", "bin", "tap", "svg", "tsv", "ico"];

/// Foreign words, packages from elsewhere, manifests without the workspace's lints.
pub(super) fn check() -> Result<Vec<Finding>, String> {
    let mut findings = Vec::new();
    for path in files()? {
        let read = path.extension().is_none_or(|e| NOT_READ.iter().all(|other| e != *other));
        // A file that is not text has no words.
        if let (true, Ok(text)) = (read, std::fs::read_to_string(root().join(&path))) {
            file_findings(&path, &text, &mut findings);
        }
    }
    Ok(findings)
}

fn file_findings(path: &Path, text: &str, findings: &mut Vec<Finding>) {
    let name = path.display();
    for (line, number) in text.lines().zip(1..) {
        let lower = line.to_ascii_lowercase();
        for word in FOREIGN {
            if lower.match_indices(word).any(|(at, _)| stands_alone(&lower, at, word)) {
                findings.push(format!("{name}:{number}: `{word}` is not a word of the project"));
            }
        }
    }
    if path == Path::new("Cargo.lock") {
        let sources = text.lines().filter_map(|line| line.strip_prefix("source = \""));
        for source in sources.filter(|source| !source.starts_with(REGISTRY)) {
            findings.push(format!("{name}: a package comes from \"{source}"));
        }
    }
    let manifest = path.file_name().is_some_and(|file| file == "Cargo.toml");
    let fuzz = path.starts_with("fuzz");
    if manifest
        && !fuzz
        && !text.contains("\n[lints]\nworkspace = true")
        && !text.contains("[workspace]")
    {
        findings.push(format!("{name}: without `[lints] workspace = true`"));
    }
    for (line, number) in text.lines().zip(1..).filter(|_| manifest && !fuzz) {
        // A version outside the workspace's list would be a second one sooner or later.
        let listed = text.contains("[workspace]") || line.contains("workspace = true");
        if !listed && line.contains("version = \"") {
            findings.push(format!("{name}:{number}: name versions in the workspace's manifest"));
        }
    }
}

/// Whether the word at `at` is no part of a longer one; a path may be.
fn stands_alone(line: &str, at: usize, word: &str) -> bool {
    let letter = |c: Option<char>| c.is_some_and(char::is_alphabetic);
    let plural = line[at + word.len()..].strip_prefix('s').unwrap_or(&line[at + word.len()..]);
    word.starts_with('/')
        || !letter(line[..at].chars().next_back()) && !letter(plural.chars().next())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn findings(name: &str, text: &str) -> usize {
        let mut findings = Vec::new();
        file_findings(Path::new(name), text, &mut findings);
        findings.len()
    }

    #[test]
    fn foreign_words_are_found_whole() {
        let [word, ..] = FOREIGN;
        assert_eq!(findings("a.md", &format!("in this {word}, we")), 1);
        assert_eq!(findings("a.md", &format!("two {word}s")), 1);
        assert_eq!(findings("a.md", &format!("ob{word} and pos{word}")), 0);
        assert_eq!(findings("a.md", "frame/work of the shop"), 0);
        assert_eq!(findings("a.rs", concat!("let path = \"/wo", "rk/main\";")), 1);
    }

    #[test]
    fn packages_come_from_the_public_registry() {
        let lock = |source: &str| format!("[[package]]\nname = \"a\"\nsource = \"{source}\"\n");
        assert_eq!(findings("Cargo.lock", &lock(REGISTRY)), 0);
        assert_eq!(findings("Cargo.lock", &lock("registry+https://mirror.example/index")), 1);
    }

    #[test]
    fn manifests_take_lints_and_versions_from_the_workspace() {
        let good = "[dependencies]\nlibm.workspace = true\n\n[lints]\nworkspace = true\n";
        assert_eq!(findings("crates/a/Cargo.toml", good), 0);
        assert_eq!(findings("crates/a/Cargo.toml", "[dependencies]\n"), 1);
        let version = good.replace("libm.workspace = true", "libm = { version = \"0.2\" }");
        assert_eq!(findings("crates/a/Cargo.toml", &version), 1);
    }
}
