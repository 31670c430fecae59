//! Where records wait until they are wanted again, for their COPY or the next Section: in memory, and when
//! that is not enough in a file of Section 0.

mod codec;

use std::io::{self, Read, Seek, SeekFrom, Write};

use self::codec::Codec;
use crate::{Record, RecordWriter};

/// A file that is read, written and forgotten.
pub trait Spill: Read + Write + Seek + Send {}

impl<T: Read + Write + Seek + Send> Spill for T {}

/// Bytes kept in memory before the file is asked for.
const IN_MEMORY: usize = 4 << 20;
/// Bytes read from the file at once.
const BLOCK: usize = 256 * 1024;

/// Gives a temporary file when it is needed.
type Opener = Box<dyn FnMut() -> io::Result<Box<dyn Spill>> + Send>;

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
    pub fn spilling(opener: impl FnMut() -> io::Result<Box<dyn Spill>> + Send + 'static) -> Self {
        Self { opener: Some(Box::new(opener)), ..Self::default() }
    }

    /// A spool that asks for a temporary file when it has more than `bytes`.
    pub fn spilling_after(
        bytes: usize,
        opener: impl FnMut() -> io::Result<Box<dyn Spill>> + Send + 'static,
    ) -> Self {
        Self { limit: bytes, ..Self::spilling(opener) }
    }

    /// Does it go to a file when it grows?
    pub fn is_spilling(&self) -> bool {
        self.opener.is_some()
    }

    /// Where the next record will be put.
    pub fn end(&self) -> u64 {
        self.spilled + self.memory.len() as u64
    }

    /// Appends a record.
    pub fn put(&mut self, record: &Record) -> io::Result<()> {
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
    pub fn get(&mut self, at: u64, record: &mut Record, block: &mut Block) -> io::Result<u64> {
        let head = self.bytes(at, 4, block)?;
        let len = u32::from_le_bytes([head[0], head[1], head[2], head[3]]) as usize;
        // The codec is apart from the bytes, which may lie in the block.
        let mut codec = std::mem::take(&mut self.codec);
        let done = self.bytes(at + 4, len, block).and_then(|bytes| {
            let corrupt =
                |codec::Corrupt| io::Error::new(io::ErrorKind::InvalidData, "spooled record");
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

impl RecordWriter for Spool {
    fn write(&mut self, record: &Record) -> io::Result<()> {
        self.put(record)
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Bytes of the file that a reading has at hand.
#[derive(Default)]
pub struct Block {
    start: u64,
    bytes: Vec<u8>,
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;
    use std::sync::Arc;

    use aptc_diagnostics::{Frame, FrameKind, Origin, Span, Trace};
    use aptc_geometry::{Form, Pattern, Plane, Sphere, Vec3};

    use super::*;
    use crate::{Arg, Control, Controlled, Kind, Motion, NameRef, Position, Relation, Units};

    fn frame(kind: FrameKind, name: &str, pass: u32, outer: Trace) -> Trace {
        Some(Arc::new(Frame {
            kind,
            name: name.into(),
            span: Span::default(),
            line: 7,
            pass,
            outer,
        }))
    }

    fn controlled(form: Form) -> Controlled {
        Controlled {
            name: NameRef { name: "PL1".into(), subscript: 3 },
            form: Arc::new(form),
            relation: Relation::Past,
            side: -1,
            open: true,
            nth: 2,
            thick: -0.1,
            disk: Some([0.3, 1e-17]),
            intol: 0.0,
            outtol: 1.0 / 3.0,
        }
    }

    /// A motion of each kind of control: none, of small forms, of a large form; within macros and loops.
    fn records() -> Vec<Record> {
        let plane = Form::Plane(Plane::new(Vec3::new(1.0, 2.0, 3.0), 0.1).unwrap());
        let sphere = Form::Sphere(Sphere { center: Vec3::x() / 3.0, radius: 0.7 });
        let large = Form::Pattern(Pattern { points: vec![Vec3::x(); 40] });
        let small = Control {
            drive: Some(controlled(plane)),
            part: Some(controlled(sphere)),
            ..Control::default()
        };
        let large = Control { checks: vec![controlled(large)], ..Control::default() };
        let mut out = vec![Record { kind: Kind::Units(Units::Mm), ..Record::default() }];
        let call = frame(FrameKind::Macro, "HOLES", 0, None);
        for (i, control) in (0_u32..).zip([None, Some(small), Some(large)]) {
            let trace = frame(FrameKind::Loop, "L1", i, call.clone());
            let file = (i == 1).then(|| Arc::from("tools.mac"));
            let origin = Origin { isn: 9, line: i, file, trace, ..Origin::default() };
            let points = (0..=i).map(|k| Position::upright(Vec3::new(0.1, f64::from(k), -0.0)));
            let points = points.collect();
            let control = control.map(Arc::new);
            let motion = Motion { control, points, ..Motion::default() };
            out.push(Record { origin, kind: Kind::Motion(motion) });
        }
        let args = vec![Arg::Word("ON".into()), Arg::Number(0.1), Arg::Text("it's".into())];
        let kind = Kind::Post { word: "COOLNT".into(), args };
        out.push(Record { kind, ..Record::default() });
        out
    }

    #[test]
    fn records_come_back_as_they_were_from_memory_and_file() {
        let records = records();
        for limit in [1, 1 << 20] {
            let file = || Ok(Box::new(Cursor::new(Vec::new())) as Box<dyn Spill>);
            let mut spool = Spool::spilling_after(limit, file);
            let starts: Vec<u64> = records
                .iter()
                .map(|r| {
                    let start = spool.end();
                    spool.put(r).unwrap();
                    start
                })
                .collect();
            // In order, and from any of them on.
            let (mut back, mut block) = (Record::default(), Block::default());
            for (start, record) in
                starts.iter().zip(&records).chain(starts.iter().zip(&records).rev())
            {
                spool.get(*start, &mut back, &mut block).unwrap();
                assert_eq!(&back, record);
            }
        }
    }
}
