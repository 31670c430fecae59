//! A folder with a program, and how the folders are found.

use std::fs;
use std::path::{Path, PathBuf};

use serde::Deserialize;

/// What `case.toml` may say.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Settings {
    /// Machine by name or file, instead of the program's MACHIN.
    pub machine: Option<String>,
    /// Folders, relative to the case, of macros and included files; the case's own comes first.
    pub include: Vec<PathBuf>,
    /// Lines of any length: no card columns.
    pub free_form: bool,
}

/// A part program with its goldens.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Case {
    /// Path below the folder that was searched, with `/`: `mill/bracket`.
    pub name: String,
    /// The folder.
    pub folder: PathBuf,
    /// What `case.toml` says.
    pub settings: Settings,
}

impl Case {
    /// The part program.
    pub fn program(&self) -> PathBuf {
        self.folder.join("program.apt")
    }

    /// The case's own folder and those of its settings.
    pub fn include_folders(&self) -> Vec<PathBuf> {
        let others = self.settings.include.iter().map(|folder| self.folder.join(folder));
        std::iter::once(self.folder.clone()).chain(others).collect()
    }
}

/// All cases below `root` whose name contains `filter`, by name.
///
/// # Errors
/// When a folder or a `case.toml` cannot be read.
pub fn discover(root: &Path, filter: &str) -> Result<Vec<Case>, String> {
    let mut cases = Vec::new();
    let mut waiting = vec![root.to_path_buf()];
    while let Some(folder) = waiting.pop() {
        let unreadable = |error: std::io::Error| format!("{}: {error}", folder.display());
        for entry in fs::read_dir(&folder).map_err(unreadable)? {
            let entry = entry.map_err(unreadable)?;
            // A link could lead in a circle.
            if entry.file_type().map_err(unreadable)?.is_dir() {
                waiting.push(entry.path());
            }
        }
        if folder.join("program.apt").is_file() {
            let below = folder.strip_prefix(root).unwrap_or(&folder);
            let name = below.to_string_lossy().replace('\\', "/");
            if name.contains(filter) {
                let settings = settings(&folder.join("case.toml"))?;
                cases.push(Case { name, folder, settings });
            }
        }
    }
    cases.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(cases)
}

fn settings(path: &Path) -> Result<Settings, String> {
    if !path.exists() {
        return Ok(Settings::default());
    }
    let text = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    toml::from_str(&text).map_err(|error| format!("{}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cases_are_found_with_their_settings() {
        let root = tempfile::tempdir().unwrap();
        for name in ["mill/b", "mill/a", "turn"] {
            fs::create_dir_all(root.path().join(name)).unwrap();
        }
        fs::write(root.path().join("mill/a/program.apt"), "FINI\n").unwrap();
        fs::write(root.path().join("mill/b/program.apt"), "FINI\n").unwrap();
        let text = "machine = \"lathe\"\ninclude = [\"../lib\"]\n";
        fs::write(root.path().join("mill/b/case.toml"), text).unwrap();
        let cases = discover(root.path(), "").unwrap();
        let names: Vec<&str> = cases.iter().map(|case| case.name.as_str()).collect();
        assert_eq!(names, ["mill/a", "mill/b"]);
        assert_eq!(cases[1].settings.machine.as_deref(), Some("lathe"));
        assert_eq!(cases[1].include_folders().len(), 2);
        assert_eq!(discover(root.path(), "/b").unwrap().len(), 1);
        fs::write(root.path().join("mill/b/case.toml"), "machin = 1\n").unwrap();
        assert!(discover(root.path(), "").unwrap_err().contains("machin"));
    }
}
