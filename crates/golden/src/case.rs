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
    /// Unknown post-processor words are errors.
    pub deny_unknown_words: bool,
    /// Most statements that are carried out.
    pub max_statements: Option<u64>,
}

/// A part program with its goldens.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Case {
    /// Path below the folder that was searched, with `/`: `mill/bracket`.
    pub name: String,
    /// The part program.
    pub program: PathBuf,
    /// The folder of its goldens.
    pub goldens: PathBuf,
    /// What `case.toml` says.
    pub settings: Settings,
}

impl Case {
    /// The folder that the program lies in.
    pub fn folder(&self) -> &Path {
        self.program.parent().unwrap_or(Path::new("."))
    }

    /// The program's own folder and those of its settings.
    pub fn include_folders(&self) -> Vec<PathBuf> {
        let others = self.settings.include.iter().map(|folder| self.folder().join(folder));
        std::iter::once(self.folder().to_owned()).chain(others).collect()
    }
}

/// All cases below `root` whose name contains `filter`, by name.
///
/// A folder with a `program.apt` is one case, whatever else lies in it. In other folders each file `X.apt` is
/// one, with its goldens in a folder `X.golden` beside it.
///
/// # Errors
/// When a folder or a `case.toml` cannot be read.
pub fn discover(root: &Path, filter: &str) -> Result<Vec<Case>, String> {
    let mut cases = Vec::new();
    let mut waiting = vec![root.to_path_buf()];
    while let Some(folder) = waiting.pop() {
        let unreadable = |error: std::io::Error| format!("{}: {error}", folder.display());
        let mut programs = Vec::new();
        for entry in fs::read_dir(&folder).map_err(unreadable)? {
            let entry = entry.map_err(unreadable)?;
            let (kind, path) = (entry.file_type().map_err(unreadable)?, entry.path());
            // A link could lead in a circle.
            if kind.is_dir() && !has_ending(&path, "golden") {
                waiting.push(path);
            } else if kind.is_file() && has_ending(&path, "apt") {
                programs.push(path);
            }
        }
        let own = folder.join("program.apt");
        if programs.contains(&own) {
            cases.push((own, folder));
        } else {
            cases.extend(programs.into_iter().map(|p| (p.clone(), p.with_extension("golden"))));
        }
    }
    let named = cases.into_iter().map(|(program, goldens)| {
        let path = if goldens == program.with_extension("golden") {
            program.with_extension("")
        } else {
            goldens.clone()
        };
        let name = path.strip_prefix(root).unwrap_or(&path).to_string_lossy().replace('\\', "/");
        (name, program, goldens)
    });
    let wanted = named.filter(|(name, _, _)| name.contains(filter));
    let with_settings = wanted.map(|(name, program, goldens)| {
        let settings = settings(&goldens.join("case.toml"))?;
        Ok(Case { name, program, goldens, settings })
    });
    let mut cases: Vec<Case> = with_settings.collect::<Result<_, String>>()?;
    cases.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(cases)
}

fn has_ending(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|e| e.eq_ignore_ascii_case(ending))
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
        fs::write(root.path().join("turn/loose.apt"), "FINI\n").unwrap();
        fs::create_dir(root.path().join("turn/loose.golden")).unwrap();
        let loose = discover(root.path(), "turn").unwrap();
        assert_eq!(loose[0].name, "turn/loose");
        assert_eq!(loose[0].goldens, root.path().join("turn/loose.golden"));
        fs::write(root.path().join("mill/b/case.toml"), "machin = 1\n").unwrap();
        assert!(discover(root.path(), "").unwrap_err().contains("machin"));
    }
}
