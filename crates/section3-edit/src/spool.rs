//! Where records wait for their COPY: in memory, and when that is not enough in a file of Section 0.

use std::io::{self, Read, Seek, SeekFrom, Write};

use aptc_cldata::Record;

use crate::codec::Codec;

/// A file that is read, written and forgotten.
pub trait Spill: Read + Write + Seek {}

impl<T: Read + Write + Seek> Spill for T {}

/// Bytes kept in memory before the file is asked for.
const IN_MEMORY: usize = 4 << 20;
/// Bytes read from the file at once.
const BLOCK: usize = 256 * 1024;

/// Gives a temporary file when it is needed.
type Opener = Box<dyn FnMut() -> io::Result<Box<dyn Spill>>>;

/// Records in order, which can be read again from any of them on.
#[derive(Default)]
pub struct Spool {
    codec: Codec,
    /// The end of the records, from `spilled` on.
    memory: Vec<u8>,
    /// Bytes that are in the file.
    spilled: u64,
    file: Option<Box<dyn Spill>>,
    opener: Option<Opener>,
    /// Bytes kept in memory; 0 for the usual ones.
    limit: usize,
}

impl Spool {
    /// A spool that keeps all in memory.
    pub fn in_memory() -> Self {
        Self::default()
    }

    /// A spool that asks for a temporary file when it has 4 MiB.
    pub fn spilling(opener: impl FnMut() -> io::Result<Box<dyn Spill>> + 'static) -> Self {
        Self { opener: Some(Box::new(opener)), ..Self::default() }
    }

    /// A spool that asks for a temporary file when it has more than `bytes`.
    pub fn spilling_after(
        bytes: usize,
        opener: impl FnMut() -> io::Result<Box<dyn Spill>> + 'static,
    ) -> Self {
        Self { limit: bytes, ..Self::spilling(opener) }
    }

    /// Does it go to a file when it grows?
    pub(crate) fn is_spilling(&self) -> bool {
        self.opener.is_some()
    }

    /// Where the next record will be put.
    pub(crate) fn end(&self) -> u64 {
        self.spilled + self.memory.len() as u64
    }

    /// Appends a record.
    pub(crate) fn put(&mut self, record: &Record) -> io::Result<()> {
        self.codec.put(&mut self.memory, record)?;
        let limit = if self.limit > 0 { self.limit } else { IN_MEMORY };
        if self.memory.len() > limit {
            self.spill()?;
        }
        Ok(())
    }

    fn spill(&mut self) -> io::Result<()> {
        if self.file.is_none() {
            let Some(opener) = &mut self.opener else { return Ok(()) };
            self.file = Some(opener()?);
        }
        let Some(file) = &mut self.file else { return Ok(()) };
        file.seek(SeekFrom::Start(self.spilled))?;
        file.write_all(&self.memory)?;
        self.spilled += self.memory.len() as u64;
        self.memory.clear();
        Ok(())
    }

    /// Puts the record at `at` into `record`; the place of the one after it. `block` keeps bytes between
    /// calls and belongs to one reading.
    pub(crate) fn get(
        &mut self,
        at: u64,
        record: &mut Record,
        block: &mut Block,
    ) -> io::Result<u64> {
        let head = self.bytes(at, 4, block)?;
        let len = u32::from_le_bytes([head[0], head[1], head[2], head[3]]) as usize;
        // The codec is apart from the bytes, which may lie in the block.
        let codec = std::mem::take(&mut self.codec);
        let done = self.bytes(at + 4, len, block).and_then(|bytes| {
            let corrupt = |_| io::Error::new(io::ErrorKind::InvalidData, "spooled record");
            codec.get(bytes, record).map_err(corrupt)
        });
        self.codec = codec;
        done?;
        Ok(at + 4 + len as u64)
    }

    fn bytes<'a>(&'a mut self, at: u64, len: usize, block: &'a mut Block) -> io::Result<&'a [u8]> {
        let missing = || io::Error::new(io::ErrorKind::UnexpectedEof, "spooled record");
        if at >= self.spilled {
            let start = usize::try_from(at - self.spilled).map_err(|_| missing())?;
            let end = start.checked_add(len).ok_or_else(missing)?;
            return self.memory.get(start..end).ok_or_else(missing);
        }
        let have = block.start..block.start + block.bytes.len() as u64;
        if at < have.start || at + len as u64 > have.end {
            let left = usize::try_from(self.spilled - at).unwrap_or(usize::MAX);
            block.bytes.resize(left.min(len.max(BLOCK)), 0);
            block.start = at;
            let file = self.file.as_mut().ok_or_else(missing)?;
            file.seek(SeekFrom::Start(at))?;
            file.read_exact(&mut block.bytes)?;
        }
        let start = usize::try_from(at - block.start).map_err(|_| missing())?;
        block.bytes.get(start..start + len).ok_or_else(missing)
    }
}

/// Bytes of the file that a reading has at hand.
#[derive(Default)]
pub(crate) struct Block {
    start: u64,
    bytes: Vec<u8>,
}
