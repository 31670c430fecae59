//! Files that are written whole or not at all.

use std::fs::{self, Metadata};
use std::io::{self, Seek as _, Write};
use std::path::{Path, PathBuf};

use aptc_control::{Artifact, ArtifactFile};
use tempfile::NamedTempFile;

/// A result that is being written aside, in the folder where it is to go.
pub(crate) struct Aside(NamedTempFile);

impl Aside {
    /// Begins the result that will be `path`.
    pub(crate) fn begin(path: &Path) -> io::Result<Self> {
        let (path, there) = real(path);
        if is_stream(there.as_ref()) {
            return NamedTempFile::new().map(Self);
        }
        let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        if !folder.is_dir() {
            return Err(io::Error::new(io::ErrorKind::NotFound, "there is no such folder"));
        }
        // The name of what is written aside says nothing to who wants a result.
        let begun = tempfile::Builder::new().prefix(".aptc-").tempfile_in(folder);
        begun.map(Self).map_err(|e| {
            io::Error::new(e.kind(), format!("{} takes no file: {}", folder.display(), e.kind()))
        })
    }

    /// Gives it its name when it is on the disk: what was there stays until all is written, also when the power fails.
    pub(crate) fn keep(self, path: &Path) -> io::Result<()> {
        self.0.as_file().sync_all()?;
        self.name(path)
    }

    /// Gives it its name: what was there stays until all is handed to the system.
    fn name(self, path: &Path) -> io::Result<()> {
        let (path, there) = &real(path);
        if is_stream(there.as_ref()) {
            return self.copy_to(&mut fs::OpenOptions::new().write(true).open(path)?);
        }
        #[cfg(unix)]
        {
            // A temporary file is readable by its owner alone; a result is an ordinary file.
            use std::os::unix::fs::PermissionsExt as _;
            let mode = there.as_ref().map_or(0o644, |m| m.permissions().mode());
            self.0.as_file().set_permissions(fs::Permissions::from_mode(mode))?;
        }
        self.0.persist(path).map_err(|e| e.error)?;
        Ok(())
    }

    /// Copies it to another stream instead.
    pub(crate) fn copy_to(mut self, out: &mut dyn Write) -> io::Result<()> {
        self.0.rewind()?;
        io::copy(&mut self.0, out).map(|_| ())
    }
}

impl Write for Aside {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

/// Where the file itself stands, for a link stays one, and what is there now.
fn real(path: &Path) -> (PathBuf, Option<Metadata>) {
    match fs::symlink_metadata(path) {
        Ok(there) if there.is_symlink() => {
            let real = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
            let there = fs::metadata(&real).ok();
            (real, there)
        }
        there => (path.to_path_buf(), there.ok()),
    }
}

/// A device or a pipe takes what is written; it is never replaced by a file.
fn is_stream(there: Option<&Metadata>) -> bool {
    there.is_some_and(|m| !m.is_file() && !m.is_dir())
}

/// Writes a result aside in the folder of `path`, then renames: what was there stays until all is written.
///
/// Machine code is on the disk before it has its name. What is made from the program again at any time is not waited
/// for: to wait takes longer than to compile a small program.
pub(crate) fn write_whole(path: &Path, file: &ArtifactFile<'_>, kind: Artifact) -> io::Result<()> {
    let aside = written(path, |out| file.write_to(out))?;
    if kind == Artifact::Nc { aside.keep(path) } else { aside.name(path) }
}

/// The same of what `write` writes, which cannot be made again.
pub(crate) fn write_aside(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    written(path, write)?.keep(path)
}

fn written(path: &Path, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<Aside> {
    let mut aside = io::BufWriter::new(Aside::begin(path)?);
    write(&mut aside)?;
    aside.into_inner().map_err(io::IntoInnerError::into_error)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_whole_and_nothing_is_left_aside() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("x.cl");
        write_aside(&path, |out| out.write_all(b"one")).unwrap();
        write_aside(&path, |out| out.write_all(b"two")).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"two");
        assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 1);
        assert!(write_aside(&dir.path().join("no/such/folder"), |_| Ok(())).is_err());
    }

    #[cfg(unix)]
    #[test]
    fn a_link_stays_one_and_a_device_a_device() {
        let dir = tempfile::tempdir().unwrap();
        let (file, link, null) =
            (dir.path().join("x.cl"), dir.path().join("link"), dir.path().join("null"));
        fs::write(&file, "one").unwrap();
        std::os::unix::fs::symlink(&file, &link).unwrap();
        std::os::unix::fs::symlink("/dev/null", &null).unwrap();
        write_aside(&link, |out| out.write_all(b"two")).unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read(&file).unwrap(), b"two");
        write_aside(&null, |out| out.write_all(b"two")).unwrap();
        assert!(fs::symlink_metadata(&null).unwrap().is_symlink());
        assert!(!fs::metadata("/dev/null").unwrap().is_file());
    }
}
