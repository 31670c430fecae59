//! Text that was made: in memory while it is short, then in a temporary file.

use std::fmt;
use std::io::{self, Seek as _, SeekFrom, Write};
use std::sync::{Mutex, PoisonError};

use tempfile::SpooledTempFile;

/// Bytes that stay in memory.
const IN_MEMORY: usize = 4 << 20;

/// A text that is written once and can be read again and again.
pub struct Text(Mutex<SpooledTempFile>);

impl Text {
    /// Writes it all to `out`.
    ///
    /// # Errors
    /// What the temporary file and `out` give.
    pub fn copy_to(&self, out: &mut dyn Write) -> io::Result<()> {
        let mut file = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        file.rewind()?;
        io::copy(&mut *file, out)?;
        file.seek(SeekFrom::End(0)).map(|_| ())
    }

    /// All of it in memory.
    ///
    /// # Errors
    /// What the temporary file gives.
    pub fn to_vec(&self) -> io::Result<Vec<u8>> {
        let mut all = Vec::new();
        self.copy_to(&mut all)?;
        Ok(all)
    }
}

impl Default for Text {
    fn default() -> Self {
        Self(Mutex::new(SpooledTempFile::new(IN_MEMORY)))
    }
}

impl Write for Text {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.get_mut().unwrap_or_else(PoisonError::into_inner).write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.get_mut().unwrap_or_else(PoisonError::into_inner).flush()
    }
}

impl fmt::Debug for Text {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Text")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_text_is_read_as_it_was_written() {
        let mut text = Text::default();
        let line = b"G1 X1 Y2 Z3\n";
        let n = IN_MEMORY / line.len() + 100;
        for _ in 0..n {
            text.write_all(line).unwrap();
        }
        for _ in 0..2 {
            let all = text.to_vec().unwrap();
            assert!(all.len() == n * line.len() && all.ends_with(line));
        }
    }
}
