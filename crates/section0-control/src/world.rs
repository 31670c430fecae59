//! The world outside: files, through one trait.

use std::fmt;
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Where files come from. Everything below Section 0 reads through it or not at all.
pub trait World {
    /// The text of the file that a program names (READ, INCLUD, LIBRY), looked for in the allowed folders.
    /// A name without an ending is also tried with `.apt` and `.mac`, and with those of surfaces from outside
    /// (`.json`, `.igs`, `.iges`, `.stp`, `.step`, `.stl`), in any case.
    ///
    /// # Errors
    /// When there is none, when it lies outside the folders, is too long or cannot be read.
    fn include(&mut self, name: &str) -> Result<Source, WorldError>;
}

/// A file as text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// Name to show.
    pub name: Arc<str>,
    /// The text. UTF-16 is known by its mark; other bytes that are not UTF-8 are taken as Latin-1.
    pub text: Arc<str>,
}

/// Why a file was not had.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum WorldError {
    /// No folder has it.
    Missing {
        /// The folders that were searched.
        searched: Vec<String>,
    },
    /// The name leads out of the allowed folders.
    Outside,
    /// Longer than the limit.
    TooLarge {
        /// The limit in bytes.
        limit: u64,
    },
    /// The system says no.
    Unreadable {
        /// What it says.
        reason: String,
    },
}

impl fmt::Display for WorldError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing { searched } if searched.is_empty() => {
                f.write_str("there is no such file")
            }
            Self::Missing { searched } => {
                write!(f, "there is no such file in {}", searched.join(", "))
            }
            Self::Outside => f.write_str("it lies outside the allowed folders"),
            Self::TooLarge { limit } => write!(f, "it is larger than {limit} bytes"),
            Self::Unreadable { reason } => f.write_str(reason),
        }
    }
}

/// Files on disk, from a list of folders and never from outside them, also not through links.
#[derive(Clone, Debug)]
pub struct Disk {
    folders: Vec<PathBuf>,
    limit: u64,
    /// The part program, links resolved.
    program: Option<PathBuf>,
    /// The files that were included, links resolved.
    found: Vec<PathBuf>,
}

impl Disk {
    /// Reads from `folders` in their order, files of at most `limit` bytes.
    pub fn new(folders: Vec<PathBuf>, limit: u64) -> Self {
        Self { folders, limit, program: None, found: Vec::new() }
    }

    /// The same for a part program on disk, which is not meant where another file has the name too.
    #[must_use]
    pub fn for_program(self, path: &Path) -> Self {
        Self { program: path.canonicalize().ok(), ..self }
    }

    /// The files that were included so far, links resolved.
    pub fn included(&self) -> &[PathBuf] {
        &self.found
    }

    /// Reads a file that the user named himself on the command line.
    ///
    /// # Errors
    /// As [`World::include`], but from any folder.
    pub fn open(path: &Path, limit: u64) -> Result<Source, WorldError> {
        let text = read_limited(path, limit)?;
        Ok(Source { name: path.display().to_string().into(), text })
    }

    /// Reads a file that the user named himself, as it is.
    ///
    /// # Errors
    /// As [`World::include`], but from any folder.
    pub fn bytes(path: &Path, limit: u64) -> Result<Vec<u8>, WorldError> {
        read_bytes(path, limit)
    }
}

impl World for Disk {
    fn include(&mut self, name: &str) -> Result<Source, WorldError> {
        let name = name.trim();
        let mut outside = false;
        for folder in &self.folders {
            let Ok(root) = folder.canonicalize() else { continue };
            let paths = candidates(folder, name).into_iter().filter_map(|p| p.canonicalize().ok());
            // Of equal keys the first is taken.
            let found = paths.min_by_key(|p| self.program.as_ref() == Some(p));
            let Some(found) = found else { continue };
            // The path with all links resolved decides, so neither `..` nor a link leads out.
            if !found.starts_with(&root) {
                outside = true;
                continue;
            }
            let text = read_limited(&found, self.limit)?;
            let name = shown(name, &found).into();
            self.found.push(found);
            return Ok(Source { name, text });
        }
        if outside {
            return Err(WorldError::Outside);
        }
        let searched = self.folders.iter().map(|f| f.display().to_string()).collect();
        Err(WorldError::Missing { searched })
    }
}

/// The name to show of a file that is asked for by `name`: with the ending that tells a format other than APT's.
fn shown(name: &str, found: &Path) -> String {
    let ending = found.extension().and_then(|e| e.to_str()).unwrap_or_default();
    let has =
        |text: &str| Path::new(text).extension().is_some_and(|e| e.eq_ignore_ascii_case(ending));
    match ending.to_ascii_lowercase().as_str() {
        "" | "apt" | "mac" => name.to_owned(),
        _ if has(name) => name.to_owned(),
        _ => format!("{name}.{ending}"),
    }
}

/// Paths that `name` may mean in a folder, in order of preference: as written, then in other case and
/// with the usual endings.
fn candidates(folder: &Path, name: &str) -> Vec<PathBuf> {
    let mut paths = vec![folder.join(name)];
    const ENDINGS: [&str; 9] =
        ["", ".apt", ".mac", ".json", ".igs", ".iges", ".stp", ".step", ".stl"];
    let wanted = ENDINGS.map(|ending| format!("{name}{ending}"));
    if let Ok(entries) = fs::read_dir(folder) {
        let mut names: Vec<_> =
            entries.flatten().filter_map(|e| e.file_name().into_string().ok()).collect();
        names.sort_unstable();
        for w in &wanted {
            paths
                .extend(names.iter().filter(|n| n.eq_ignore_ascii_case(w)).map(|n| folder.join(n)));
        }
    }
    paths.retain(|p| p.is_file());
    paths
}

fn read_limited(path: &Path, limit: u64) -> Result<Arc<str>, WorldError> {
    read_bytes(path, limit).map(|bytes| decoded(bytes).into())
}

/// Bytes as text: UTF-16 where its mark begins them, UTF-8, else Latin-1. Where nothing but CR ends lines it does so as LF, but in
/// what is no text, as binary STL is none, every byte counts.
fn decoded(bytes: Vec<u8>) -> String {
    let wide = |unit: fn([u8; 2]) -> u16| {
        let units: Vec<u16> = bytes[2..].chunks_exact(2).map(|b| unit([b[0], b[1]])).collect();
        String::from_utf16_lossy(&units)
    };
    let text = match bytes.as_slice() {
        [0xff, 0xfe, ..] => wide(u16::from_le_bytes),
        [0xfe, 0xff, ..] => wide(u16::from_be_bytes),
        _ => String::from_utf8(bytes)
            .unwrap_or_else(|e| e.as_bytes().iter().map(|&b| char::from(b)).collect()),
    };
    let ends = text.contains('\r') && !text.contains('\n') && !text.contains('\0');
    if ends { text.replace('\r', "\n") } else { text }
}

fn read_bytes(path: &Path, limit: u64) -> Result<Vec<u8>, WorldError> {
    let unreadable = |e: std::io::Error| match e.kind() {
        std::io::ErrorKind::NotFound => WorldError::Missing { searched: Vec::new() },
        _ => WorldError::Unreadable { reason: e.to_string() },
    };
    // Asked before it is opened: to open a pipe would wait for ever.
    if !fs::metadata(path).map_err(unreadable)?.is_file() {
        return Err(WorldError::Unreadable { reason: "not a file".into() });
    }
    let file = fs::File::open(path).map_err(unreadable)?;
    let mut bytes = Vec::new();
    file.take(limit + 1).read_to_end(&mut bytes).map_err(unreadable)?;
    if bytes.len() as u64 > limit {
        return Err(WorldError::TooLarge { limit });
    }
    Ok(bytes)
}

/// A world in memory, for tests and for callers that have no disk.
#[derive(Clone, Debug, Default)]
pub struct Memory {
    /// Names and texts.
    pub files: Vec<(String, String)>,
}

impl World for Memory {
    fn include(&mut self, name: &str) -> Result<Source, WorldError> {
        let found = self.files.iter().find(|(n, _)| n.eq_ignore_ascii_case(name));
        let (name, text) = found.ok_or(WorldError::Missing { searched: Vec::new() })?;
        Ok(Source { name: name.as_str().into(), text: text.as_str().into() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A surface may have the name of the program that reads it.
    #[test]
    fn a_program_is_not_its_own_surface() {
        let dir = tempfile::tempdir().unwrap();
        let part = dir.path().join("hill.apt");
        fs::write(&part, "READ/1,HILL").unwrap();
        let mut disk = Disk::new(vec![dir.path().to_owned()], 100).for_program(&part);
        assert_eq!(&*disk.include("HILL").unwrap().text, "READ/1,HILL");
        fs::write(dir.path().join("hill.json"), "{}").unwrap();
        assert_eq!(&*disk.include("HILL").unwrap().text, "{}");
    }

    /// What format a file should have is told with it.
    #[test]
    fn the_ending_of_another_format_is_shown() {
        let dir = tempfile::tempdir().unwrap();
        for file in ["hill.IGS", "lib.mac", "plain", "dome.stp"] {
            fs::write(dir.path().join(file), "").unwrap();
        }
        let mut disk = Disk::new(vec![dir.path().to_owned()], 100);
        for (name, shown) in [
            ("HILL", "HILL.IGS"),
            ("hill.igs", "hill.igs"),
            ("LIB", "LIB"),
            ("PLAIN", "PLAIN"),
            ("DOME", "DOME.stp"),
        ] {
            assert_eq!(&*disk.include(name).unwrap().name, shown);
        }
    }

    #[test]
    fn includes_stay_in_their_folders() {
        let dir = tempfile::tempdir().unwrap();
        let (inside, outside) = (dir.path().join("lib"), dir.path().join("secret.apt"));
        fs::create_dir(&inside).unwrap();
        fs::write(inside.join("STRTUP"), "TERMAC\n").unwrap();
        fs::write(&outside, "no").unwrap();
        let mut disk = Disk::new(vec![inside.clone()], 100);
        assert_eq!(&*disk.include("strtup").unwrap().text, "TERMAC\n");
        assert_eq!(disk.include("../secret.apt"), Err(WorldError::Outside));
        assert_eq!(disk.include(outside.to_str().unwrap()), Err(WorldError::Outside));
        assert!(matches!(disk.include("nothing"), Err(WorldError::Missing { .. })));
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink(&outside, inside.join("link.apt")).unwrap();
            assert_eq!(disk.include("link.apt"), Err(WorldError::Outside));
        }
        fs::write(inside.join("long"), vec![b'A'; 101]).unwrap();
        assert_eq!(disk.include("long"), Err(WorldError::TooLarge { limit: 100 }));
        assert_eq!(disk.included(), [inside.join("STRTUP").canonicalize().unwrap()]);
    }

    #[test]
    fn utf16_and_old_line_ends_are_read() {
        let text = "\u{feff}$$ Füße\r\nFINI\r\n";
        let little: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
        for bytes in [little, big] {
            assert_eq!(decoded(bytes), "$$ Füße\r\nFINI\r\n");
        }
        assert_eq!(decoded(b"A=1\rFINI\r".to_vec()), "A=1\nFINI\n");
        assert_eq!(decoded(b"A=1\r\nB=2\r".to_vec()), "A=1\r\nB=2\r");
        assert_eq!(decoded(b"A\r\0\xff".to_vec()), "A\r\0\u{ff}");
    }

    #[test]
    fn bytes_that_are_not_utf8_are_latin1() {
        let dir = tempfile::tempdir().unwrap();
        fs::write(dir.path().join("a"), b"$$ F\xfc\xdfe").unwrap();
        let mut disk = Disk::new(vec![dir.path().to_owned()], 100);
        assert_eq!(&*disk.include("a").unwrap().text, "$$ Füße");
    }
}
