//! Files that the user names: a part program, CL data or machine code, each refused in a word where it is another of them.

use std::fs::File;
use std::io::{ErrorKind, Read as _};
use std::path::Path;

use aptc_control::{Dialect, Disk, FileKind, Source, dialect_of};

/// Bytes that tell what a file is.
const HEAD: u64 = 64 * 1024;

/// The part program at `path`, or why there is none.
pub(crate) fn part_program(path: &Path, limit: u64) -> Result<Source, String> {
    let why = |text: String| format!("cannot read {}: {text}", path.display());
    let source =
        Disk::open(path, limit).map_err(|e| why(misspelt(path).unwrap_or(e.to_string())))?;
    let numeric = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("protap"));
    match FileKind::of(source.text.as_bytes()) {
        None | Some(FileKind::PartProgram | FileKind::Statements) => Ok(source),
        Some(FileKind::Protap) if numeric => Ok(source),
        Some(FileKind::Empty) => Err(why("it is empty".into())),
        Some(FileKind::Protap) => {
            Err(why("it is a numeric part program; let its name end in .protap".into()))
        }
        Some(kind) => Err(why(format!("it is {kind}, no part program"))),
    }
}

/// Why a file holds no CL data, as far as its first bytes tell.
pub(crate) fn cl_fault(path: &Path, dialect: Option<Dialect>) -> Option<String> {
    let why = |text: &str| Some(format!("cannot read {}: {text}", path.display()));
    let head = match head(path) {
        Ok(head) => head,
        Err(text) => return why(&text),
    };
    let binary =
        [Dialect::Tape, Dialect::Clfile].contains(&dialect.unwrap_or_else(|| dialect_of(&head)));
    match FileKind::of(&head)? {
        FileKind::Empty => why("it is empty"),
        FileKind::PartProgram => {
            why(&format!("it is a part program, no CL data; `aptc {}` compiles it", path.display()))
        }
        FileKind::Statements => None,
        FileKind::Binary if binary => None,
        kind => why(&format!("it is {kind}, no CL data")),
    }
}

/// Why a file holds no machine code, as far as its first bytes tell.
pub(crate) fn nc_fault(path: &Path) -> Option<String> {
    let why = |text: &str| Some(format!("cannot read {}: {text}", path.display()));
    match head(path).map(|head| FileKind::of(&head)) {
        Err(text) => why(&text),
        Ok(None | Some(FileKind::MachineCode | FileKind::PlainCode)) => None,
        Ok(Some(FileKind::Empty)) => why("it is empty"),
        Ok(Some(kind)) => why(&format!("it is {kind}, no machine code")),
    }
}

/// What the file at `path` is, as far as its first bytes tell.
pub(crate) fn kind(path: &Path) -> Option<FileKind> {
    head(path).ok().and_then(|head| FileKind::of(&head))
}

/// The first bytes of a file, or why it cannot be read.
fn head(path: &Path) -> Result<Vec<u8>, String> {
    // Asked before it is opened: to open a pipe would wait for ever.
    if path.exists() && !path.is_file() {
        return Err("it is no file".into());
    }
    let mut bytes = Vec::new();
    let read = File::open(path).and_then(|file| file.take(HEAD).read_to_end(&mut bytes));
    read.map(|_| bytes).map_err(|e| match e.kind() {
        ErrorKind::NotFound => "there is no such file".into(),
        _ => e.to_string(),
    })
}

/// A word without an ending that is no file, but nearly a command.
fn misspelt(path: &Path) -> Option<String> {
    let word =
        path.to_str().filter(|w| !path.exists() && w.bytes().all(|b| b.is_ascii_lowercase()))?;
    let near = COMMANDS.iter().find(|c| is_near(word, c))?;
    Some(format!("there is no such file; did you mean the command {near}?"))
}

const COMMANDS: [&str; 13] = [
    "compile",
    "check",
    "verify",
    "post",
    "fmt",
    "convert",
    "cldiff",
    "stats",
    "test",
    "explain",
    "machines",
    "completions",
    "help",
];

/// Does one letter too much, too few, or another, or two that changed places, make the difference?
fn is_near(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    let start = a.iter().zip(b).take_while(|(x, y)| x == y).count();
    let (a, b) = (&a[start..], &b[start..]);
    let end = a.iter().rev().zip(b.iter().rev()).take_while(|(x, y)| x == y).count();
    let (a, b) = (&a[..a.len() - end], &b[..b.len() - end]);
    matches!((a, b), ([], [_]) | ([_], [] | [_]))
        || matches!((a, b), ([x, y], [v, w]) if x == w && y == v)
}

/// Files that are read, each with what it is, and that no result may take the place of.
pub(crate) struct Inputs<'a>(Vec<(&'a Path, &'static str)>);

impl<'a> Inputs<'a> {
    /// These and the machine's file where it has one.
    pub(crate) fn new(
        files: impl IntoIterator<Item = (&'a Path, &'static str)>,
        machine: Option<&'a str>,
    ) -> Self {
        let ending =
            |path: &&Path| path.extension().is_some_and(|e| e.eq_ignore_ascii_case("toml"));
        let machine = machine.map(Path::new).filter(ending);
        let machine = machine.map(|path| (path, "the file of the machine"));
        Self(files.into_iter().chain(machine).collect())
    }

    /// What the file at `path` is, where a result may not be written.
    pub(crate) fn what_is(&self, path: &Path) -> Option<&'static str> {
        self.0.iter().find(|(input, _)| is_same(path, input)).map(|(_, what)| *what)
    }
}

/// Are both the same file? A result may not take the place of what it is made of.
pub(crate) fn is_same(a: &Path, b: &Path) -> bool {
    a == b || is_one(a, b)
}

/// By the numbers that the system gives it: two questions, where a path in full takes one for each folder.
#[cfg(unix)]
fn is_one(a: &Path, b: &Path) -> bool {
    use std::os::unix::fs::MetadataExt as _;
    let numbers = |p: &Path| p.metadata().map(|m| (m.dev(), m.ino()));
    matches!((numbers(a), numbers(b)), (Ok(a), Ok(b)) if a == b)
}

#[cfg(not(unix))]
fn is_one(a: &Path, b: &Path) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_is_near_when_one_letter_is_wrong() {
        for word in ["copmile", "compil", "compilee", "compite"] {
            assert!(is_near(word, "compile"), "{word}");
        }
        assert!(!is_near("plate", "compile") && !is_near("compile", "compile"));
    }
}
