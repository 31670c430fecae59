//! Records as bytes, exact and quick.

use std::sync::Arc as Shared;

use aptc_diagnostics::{FileId, Frame, Origin, Span, Trace};
use aptc_geometry::{Circle, Form, Vec3};

use crate::{Arc, Control, Course, Kind, Motion, MotionKind, NameRef, Position, Record};

/// Writes and reads records. What stays in memory: names of files, each once, and what governs a motion
/// where it is large, a sculptured surface or regional milling.
#[derive(Default)]
pub(super) struct Codec {
    files: Vec<Shared<str>>,
    controls: Vec<Shared<Control>>,
    /// The last trace that was written, and that was read, each with its bytes: the next is likely the same.
    written: (Trace, Vec<u8>),
    read: (Trace, Vec<u8>),
}

/// A record could not be read back: the spool did not give what was put in.
#[derive(Debug)]
pub(super) struct Corrupt;

impl Codec {
    /// Appends a record with its length before it.
    pub(super) fn put(&mut self, out: &mut Vec<u8>, record: &Record) -> serde_json::Result<()> {
        let start = out.len();
        out.extend([0; 4]);
        self.origin(out, &record.origin)?;
        match &record.kind {
            Kind::Motion(m) => {
                motion(out, m);
                let at = out.len();
                out.extend([0; 4]);
                if let Some(control) = &m.control {
                    self.control(out, control)?;
                }
                let len = u32::try_from(out.len() - at - 4).unwrap_or(u32::MAX);
                out[at..at + 4].copy_from_slice(&len.to_le_bytes());
                for p in &m.points {
                    vector(out, p.te);
                    vector(out, p.ta);
                }
            }
            other => {
                out.push(0);
                serde_json::to_writer(&mut *out, other)?;
            }
        }
        let len = u32::try_from(out.len() - start - 4).unwrap_or(u32::MAX);
        out[start..start + 4].copy_from_slice(&len.to_le_bytes());
        Ok(())
    }

    fn origin(&mut self, out: &mut Vec<u8>, o: &Origin) -> serde_json::Result<()> {
        let file = o.file.as_ref().map_or(0, |f| {
            let known = self.files.iter().rposition(|k| k == f);
            1 + known.unwrap_or_else(|| {
                self.files.push(f.clone());
                self.files.len() - 1
            })
        });
        let same = match (&self.written.0, &o.trace) {
            (Some(a), Some(b)) => Shared::ptr_eq(a, b),
            (a, b) => a.is_none() && b.is_none(),
        };
        if !same {
            self.written.1.clear();
            if o.trace.is_some() {
                let frames = std::iter::successors(o.trace.as_deref(), |f| f.outer.as_deref());
                serde_json::to_writer(&mut self.written.1, &frames.collect::<Vec<_>>())?;
            }
            self.written.0.clone_from(&o.trace);
        }
        let count = |i: usize| u32::try_from(i).unwrap_or(0);
        let (span, trace) = (o.span, &self.written.1);
        for n in [span.file.0, span.start, span.end, o.isn, o.line, count(file), count(trace.len())]
        {
            out.extend(n.to_le_bytes());
        }
        out.extend_from_slice(trace);
        Ok(())
    }

    /// A small one as it is, a large one by its number.
    fn control(&mut self, out: &mut Vec<u8>, c: &Shared<Control>) -> serde_json::Result<()> {
        let surfaces = c.drive.iter().chain(&c.part).chain(&c.checks);
        let large = c.milling.is_some() || surfaces.into_iter().any(|s| is_large(&s.form));
        if !large {
            return serde_json::to_writer(out, &(&c.drive, &c.part, &c.checks));
        }
        if !self.controls.last().is_some_and(|k| Shared::ptr_eq(k, c)) {
            self.controls.push(c.clone());
        }
        serde_json::to_writer(out, &(self.controls.len() - 1))
    }

    fn get_control(&self, bytes: &[u8]) -> Result<Option<Shared<Control>>, Corrupt> {
        match bytes.first() {
            None => Ok(None),
            Some(b'[') => {
                let (drive, part, checks) = serde_json::from_slice(bytes).map_err(|_| Corrupt)?;
                Ok(Some(Shared::new(Control { drive, part, checks, milling: None })))
            }
            Some(_) => {
                let i: usize = serde_json::from_slice(bytes).map_err(|_| Corrupt)?;
                self.controls.get(i).cloned().map(Some).ok_or(Corrupt)
            }
        }
    }

    fn get_trace(&mut self, bytes: &[u8]) -> Result<Trace, Corrupt> {
        if bytes.is_empty() {
            return Ok(None);
        }
        if self.read.1 != bytes {
            let frames: Vec<Frame> = serde_json::from_slice(bytes).map_err(|_| Corrupt)?;
            let around = |outer, mut f: Frame| {
                f.outer = outer;
                Some(Shared::new(f))
            };
            self.read.0 = frames.into_iter().rev().fold(None, around);
            self.read.1.clear();
            self.read.1.extend_from_slice(bytes);
        }
        Ok(self.read.0.clone())
    }

    /// The record in `bytes`, those that [`Codec::put`] wrote after the length.
    pub(super) fn get(&mut self, bytes: &[u8], record: &mut Record) -> Result<(), Corrupt> {
        let mut at = Bytes(bytes);
        let span = Span::new(FileId(at.int()?), at.int()?, at.int()?);
        let (isn, line, file, trace) = (at.int()?, at.int()?, at.int()?, at.int()?);
        let index = |n: u32| (n as usize).checked_sub(1);
        let file = index(file).and_then(|i| self.files.get(i)).cloned();
        let trace = self.get_trace(at.bytes(trace)?)?;
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
        let length = at.int()?;
        m.control = self.get_control(at.bytes(length)?)?;
        while !at.0.is_empty() {
            m.points.push(Position { te: at.vector()?, ta: at.vector()? });
        }
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
    if let Some(arc) = m.arc {
        vector(out, arc.circle.center);
        vector(out, arc.circle.axis);
        out.extend(arc.circle.radius.to_le_bytes());
        if let Course::Sweep(angle) = arc.course {
            out.extend(angle.to_le_bytes());
        }
    }
}

fn vector(out: &mut Vec<u8>, v: Vec3) {
    for x in [v.x, v.y, v.z] {
        out.extend(x.to_le_bytes());
    }
}

/// Has the form more than a few numbers?
fn is_large(form: &Form) -> bool {
    match form {
        Form::Point(_)
        | Form::Vector(_)
        | Form::Line(_)
        | Form::Plane(_)
        | Form::Circle(_)
        | Form::Cylinder(_)
        | Form::Sphere(_)
        | Form::Cone(_)
        | Form::Quadric(_)
        | Form::Matrix(_) => false,
        Form::Written(w) => is_large(&w.shape),
        _ => true,
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

    fn bytes(&mut self, length: u32) -> Result<&[u8], Corrupt> {
        let (head, rest) = self.0.split_at_checked(length as usize).ok_or(Corrupt)?;
        self.0 = rest;
        Ok(head)
    }

    /// The head of a motion; its kind was the first byte and has been taken.
    fn motion(&mut self, m: &mut Motion) -> Result<(), Corrupt> {
        let [course, with_axis, length] = self.take()?;
        let name = self.bytes(length.into())?;
        let name = std::str::from_utf8(name).map_err(|_| Corrupt)?;
        let name = name.into();
        m.name = NameRef { name, subscript: self.int()? };
        m.with_axis = with_axis > 0;
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
        Ok(())
    }
}
