//! Records as bytes, exact and quick: for the spool of COPY.

use std::sync::Arc as Shared;

use aptc_cldata::{Arc, Course, Kind, Motion, MotionKind, NameRef, Position, Record};
use aptc_diagnostics::{FileId, Origin, Span, Trace};
use aptc_geometry::{Circle, Vec3};

/// Writes and reads records. Names of files and traces of macros stay in memory, each once.
#[derive(Default)]
pub(crate) struct Codec {
    files: Vec<Shared<str>>,
    traces: Vec<Trace>,
}

/// A record could not be read back: the spool did not give what was put in.
#[derive(Debug)]
pub(crate) struct Corrupt;

impl Codec {
    /// Appends a record with its length before it.
    pub(crate) fn put(&mut self, out: &mut Vec<u8>, record: &Record) -> serde_json::Result<()> {
        let start = out.len();
        out.extend([0; 4]);
        self.origin(out, &record.origin);
        match &record.kind {
            Kind::Motion(m) => motion(out, m),
            other => {
                out.push(0);
                serde_json::to_writer(&mut *out, other)?;
            }
        }
        let len = u32::try_from(out.len() - start - 4).unwrap_or(u32::MAX);
        out[start..start + 4].copy_from_slice(&len.to_le_bytes());
        Ok(())
    }

    fn origin(&mut self, out: &mut Vec<u8>, o: &Origin) {
        let file = o.file.as_ref().map_or(0, |f| {
            let known = self.files.iter().rposition(|k| k == f);
            1 + known.unwrap_or_else(|| {
                self.files.push(f.clone());
                self.files.len() - 1
            })
        });
        let trace = o.trace.as_ref().map_or(0, |t| {
            // The trace of the record before is the likely one; others are looked for among the last few.
            let near = self.traces.len().saturating_sub(8);
            let same = |k: &Trace| k.as_ref().is_some_and(|k| Shared::ptr_eq(k, t));
            let known = self.traces[near..].iter().rposition(same).map(|i| i + near);
            1 + known.unwrap_or_else(|| {
                self.traces.push(Some(t.clone()));
                self.traces.len() - 1
            })
        });
        let index = |i: usize| u32::try_from(i).unwrap_or(0);
        let span = o.span;
        for n in [span.file.0, span.start, span.end, o.isn, o.line, index(file), index(trace)] {
            out.extend(n.to_le_bytes());
        }
    }

    /// The record in `bytes`, those that [`Codec::put`] wrote after the length.
    pub(crate) fn get(&self, bytes: &[u8], record: &mut Record) -> Result<(), Corrupt> {
        let mut at = Bytes(bytes);
        let span = Span::new(FileId(at.int()?), at.int()?, at.int()?);
        let (isn, line, file, trace) = (at.int()?, at.int()?, at.int()?, at.int()?);
        let index = |n: u32| (n as usize).checked_sub(1);
        let file = index(file).and_then(|i| self.files.get(i)).cloned();
        let trace = index(trace).and_then(|i| self.traces.get(i)).cloned().flatten();
        record.origin = Origin { span, isn, line, file, trace };
        let kind = match at.byte()? {
            1 => MotionKind::From,
            2 => MotionKind::Goto,
            3 => MotionKind::Startup,
            4 => MotionKind::Continuous,
            _ => {
                record.kind = serde_json::from_slice(at.0).map_err(|_| Corrupt)?;
                return Ok(());
            }
        };
        let mut m = match std::mem::take(&mut record.kind) {
            Kind::Motion(m) => m,
            _ => Motion::default(),
        };
        m.points.clear();
        m.kind = kind;
        at.motion(&mut m)?;
        record.kind = Kind::Motion(m);
        Ok(())
    }
}

fn motion(out: &mut Vec<u8>, m: &Motion) {
    let kind = match m.kind {
        MotionKind::From => 1,
        MotionKind::Goto => 2,
        MotionKind::Startup => 3,
        MotionKind::Continuous => 4,
    };
    let course = match m.arc.map(|a| a.course) {
        None => 0,
        Some(Course::Chords) => 1,
        Some(Course::Sweep(_)) => 2,
    };
    let name = m.name.name.as_bytes();
    let name = &name[..name.len().min(255)];
    out.extend([kind, course, u8::from(m.with_axis), u8::try_from(name.len()).unwrap_or(255)]);
    out.extend_from_slice(name);
    out.extend(m.name.subscript.to_le_bytes());
    let vector = |out: &mut Vec<u8>, v: Vec3| {
        for x in [v.x, v.y, v.z] {
            out.extend(x.to_le_bytes());
        }
    };
    if let Some(arc) = m.arc {
        vector(out, arc.circle.center);
        vector(out, arc.circle.axis);
        out.extend(arc.circle.radius.to_le_bytes());
        if let Course::Sweep(angle) = arc.course {
            out.extend(angle.to_le_bytes());
        }
    }
    for p in &m.points {
        vector(out, p.te);
        vector(out, p.ta);
    }
}

/// What is left to be read.
struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    fn take<const N: usize>(&mut self) -> Result<[u8; N], Corrupt> {
        let (head, rest) = self.0.split_first_chunk().ok_or(Corrupt)?;
        self.0 = rest;
        Ok(*head)
    }

    fn byte(&mut self) -> Result<u8, Corrupt> {
        self.take::<1>().map(|b| b[0])
    }

    fn int(&mut self) -> Result<u32, Corrupt> {
        self.take().map(u32::from_le_bytes)
    }

    fn number(&mut self) -> Result<f64, Corrupt> {
        self.take().map(f64::from_le_bytes)
    }

    fn vector(&mut self) -> Result<Vec3, Corrupt> {
        Ok(Vec3::new(self.number()?, self.number()?, self.number()?))
    }

    /// The rest of a motion; its kind was the first byte and has been taken.
    fn motion(&mut self, m: &mut Motion) -> Result<(), Corrupt> {
        let [course, with_axis, length] = self.take()?;
        let (name, rest) = self.0.split_at_checked(length.into()).ok_or(Corrupt)?;
        self.0 = rest;
        let name = std::str::from_utf8(name).map_err(|_| Corrupt)?;
        m.name = NameRef { name: name.into(), subscript: self.int()? };
        m.with_axis = with_axis > 0;
        m.control = None;
        m.arc = match course {
            0 => None,
            _ => {
                let (center, axis) = (self.vector()?, self.vector()?);
                let circle = Circle { center, axis, radius: self.number()? };
                let course =
                    if course == 1 { Course::Chords } else { Course::Sweep(self.number()?) };
                Some(Arc { circle, course })
            }
        };
        while !self.0.is_empty() {
            m.points.push(Position { te: self.vector()?, ta: self.vector()? });
        }
        Ok(())
    }
}
