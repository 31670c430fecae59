//! Section 4 from a CL file, in memory that does not grow with it.

use std::io::{self, Read, Write};
use std::mem;

use aptc_cldata::{Dialect, Kind, Reader, Record, RecordReader as _, RecordWriter};
use aptc_diagnostics::{Diagnostic, FileId, SourceMap, Span, codes};
use aptc_edit::{Editor, Subprograms};

use crate::cl_edit::{Edited, spool};
use crate::compile::once_each;
use crate::post::{PartHead, Poster};
use crate::{CodeOptions, Compiled, Part, Summary};

/// Files up to this length are kept, so that messages can show their text.
const KEPT: u64 = 4 << 20;

/// What came of posting a CL file.
#[derive(Debug)]
pub struct PostedCl<W> {
    /// Messages and figures; the texts of the machine codes stand apart.
    pub compiled: Compiled,
    /// The texts, in the order of [`Compiled::nc`].
    pub texts: Vec<W>,
}

/// How a CL file is read.
#[derive(Clone, Copy, Debug, Default)]
pub struct ClOptions {
    /// The dialect; found out if it is not given.
    pub dialect: Option<Dialect>,
    /// Are INDEX, COPY and TRACUT carried out? CL data of `aptc compile` have been edited already.
    pub edit: bool,
}

/// Posts every part program of a CL file, in whatever dialect it is written; binary too. `open` gives the
/// file from its beginning and is called several times; `create` gives an output for each machine code.
/// DEFSUB and CALSUB are carried out.
///
/// # Errors
/// What reading and writing give.
pub fn post_cl<W: Write>(
    name: &str,
    open: &mut dyn FnMut() -> io::Result<Box<dyn Read>>,
    cl: ClOptions,
    code: &CodeOptions,
    create: &mut dyn FnMut() -> io::Result<W>,
) -> io::Result<PostedCl<W>> {
    let mut compiled = Compiled::default();
    let (file, kept) = source(name, open, &mut compiled.sources)?;
    let heads = heads(open()?, cl, file)?;
    let reader = Reader::open_file(open()?, cl.dialect, file)?;
    let end = Parts::new(&heads, code, create);
    let mut posted = run(reader, cl, end)?;
    compiled.parts = mem::take(&mut posted.parts);
    compiled.diagnostics = mem::take(&mut posted.diagnostics);
    once_each(&mut compiled.diagnostics);
    if !kept {
        find_places(&compiled.diagnostics, &mut compiled.sources, file, open()?)?;
    }
    Ok(PostedCl { compiled, texts: posted.texts })
}

/// Takes the file in; its text too when it is not long.
fn source(
    name: &str,
    open: &mut dyn FnMut() -> io::Result<Box<dyn Read>>,
    sources: &mut SourceMap,
) -> io::Result<(FileId, bool)> {
    let mut bytes = Vec::new();
    open()?.take(KEPT + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > KEPT {
        return Ok((sources.add_unkept(name), false));
    }
    let text = match String::from_utf8(bytes) {
        Ok(text) => text,
        // One character a byte, or the places would not be found.
        Err(e) => {
            e.into_bytes().iter().map(|b| if b.is_ascii() { char::from(*b) } else { '?' }).collect()
        }
    };
    Ok((sources.add(name, text), true))
}

/// Finds lines and columns of the messages by one more reading.
pub fn find_places(
    diagnostics: &[Diagnostic],
    sources: &mut SourceMap,
    file: FileId,
    mut input: impl Read,
) -> io::Result<()> {
    let spans = diagnostics.iter().map(|d| d.span).filter(|s| s.file == file);
    let mut wanted: Vec<u32> = spans.map(|s| s.start).collect();
    wanted.sort_unstable();
    wanted.dedup();
    let mut places = Vec::with_capacity(wanted.len());
    let mut wanted = wanted.into_iter().peekable();
    let mut buffer = vec![0; 1 << 18];
    let (mut at, mut line, mut line_start) = (0_u64, 1_u32, 0_u64);
    while wanted.peek().is_some() {
        let n = match input.read(&mut buffer) {
            Err(e) if e.kind() == io::ErrorKind::Interrupted => continue,
            other => other?,
        };
        if n == 0 {
            break;
        }
        let mut done = 0;
        let block = &buffer[..n];
        loop {
            let next = block[done..].iter().position(|b| *b == b'\n').map_or(n, |i| done + i + 1);
            while let Some(w) = wanted.next_if(|w| u64::from(*w) < at + next as u64) {
                let column = (u64::from(w) - line_start).min(u64::from(u32::MAX - 1));
                places.push([w, line, u32::try_from(column).unwrap_or(0) + 1]);
            }
            if next == n && block.last() != Some(&b'\n') {
                break;
            }
            line = line.saturating_add(1);
            line_start = at + next as u64;
            done = next;
            if done == n {
                break;
            }
        }
        at += n as u64;
    }
    sources.set_places(file, places);
    Ok(())
}

/// The heads of all part programs.
fn heads(input: Box<dyn Read>, cl: ClOptions, file: FileId) -> io::Result<Vec<PartHead>> {
    let mut reader = Reader::open_file(input, cl.dialect, file)?;
    let (mut heads, mut head) = (Vec::new(), PartHead::default());
    let mut record = Record::default();
    while reader.read(&mut record)? {
        if matches!(record.kind, Kind::Fini) {
            heads.push(mem::take(&mut head));
        } else {
            head.push(&record);
        }
    }
    heads.push(head);
    Ok(heads)
}

/// Sends all records through subprograms, the editor if it is wanted, and the post-processors.
fn run<W: Write>(
    mut reader: Reader<Box<dyn Read>>,
    cl: ClOptions,
    mut end: Parts<'_, W>,
) -> io::Result<Parts<'_, W>> {
    let mut subprograms = Subprograms::with_spool(spool());
    let mut editor = cl.edit.then(|| Editor::with_spool(spool()));
    let mut record = Record::default();
    while reader.read(&mut record)? {
        match &mut editor {
            None => subprograms.push(&record, &mut end)?,
            Some(editor) => subprograms.push(&record, &mut Edited { editor, out: &mut end })?,
        }
    }
    match &mut editor {
        None => subprograms.finish(&mut end)?,
        Some(editor) => {
            subprograms.finish(&mut Edited { editor, out: &mut end })?;
            editor.finish(&mut end)?;
        }
    }
    end.finish()?;
    let mut diagnostics = reader.into_diagnostics();
    diagnostics.extend(subprograms.take_diagnostics());
    diagnostics.extend(editor.as_mut().map(Editor::take_diagnostics).unwrap_or_default());
    end.diagnostics.splice(0..0, diagnostics);
    Ok(end)
}

/// The part programs, one after the other.
struct Parts<'a, W> {
    heads: std::slice::Iter<'a, PartHead>,
    code: &'a CodeOptions,
    create: &'a mut dyn FnMut() -> io::Result<W>,
    present: Option<(Poster<W>, Summary)>,
    parts: Vec<Part>,
    texts: Vec<W>,
    diagnostics: Vec<Diagnostic>,
    /// The last motion, if nothing has told since that the program is at its end.
    open: Option<Span>,
}

impl<'a, W: Write> Parts<'a, W> {
    fn new(
        heads: &'a [PartHead],
        code: &'a CodeOptions,
        create: &'a mut dyn FnMut() -> io::Result<W>,
    ) -> Self {
        let (parts, texts, diagnostics) = (Vec::new(), Vec::new(), Vec::new());
        let (heads, present, open) = (heads.iter(), None, None);
        Self { heads, code, create, present, parts, texts, diagnostics, open }
    }

    fn end_part(&mut self) -> io::Result<()> {
        let Some((poster, summary)) = self.present.take() else { return Ok(()) };
        let (done, diagnostics) = poster.finish()?;
        let mut part = Part { summary, ..Part::default() };
        for (nc, text) in done {
            part.nc.push(nc);
            self.texts.push(text);
        }
        self.parts.push(part);
        self.diagnostics.extend(diagnostics);
        Ok(())
    }
}

impl<W: Write> RecordWriter for Parts<'_, W> {
    fn write(&mut self, record: &Record) -> io::Result<()> {
        if self.present.is_none() {
            // What stands between two programs is part of neither.
            if matches!(record.kind, Kind::Comment(_)) {
                return Ok(());
            }
            let nothing = PartHead::default();
            let head = self.heads.next().unwrap_or(&nothing);
            let poster = Poster::new(head, self.code, self.create)?;
            self.present = Some((poster, Summary::default()));
        }
        if matches!(record.kind, Kind::Motion(_)) {
            self.open = Some(record.origin.span);
        } else if ends(&record.kind) {
            self.open = None;
        }
        if let Some((poster, summary)) = &mut self.present {
            summary.push(record);
            poster.push(record)?;
        }
        if matches!(record.kind, Kind::Fini) { self.end_part() } else { Ok(()) }
    }

    fn finish(&mut self) -> io::Result<()> {
        self.end_part()?;
        if let Some(last) = self.open {
            let message = "the CL data end after a motion, without FINI";
            let d = Diagnostic::warning(codes::CL_UNENDED, last, message);
            let help =
                "see whether the file is whole; what is missing is missing in the machine code";
            self.diagnostics.push(d.help(help));
        }
        Ok(())
    }
}

/// Does it tell that the program is at its end, in any dialect?
fn ends(kind: &Kind) -> bool {
    match kind {
        Kind::Fini => true,
        // NX.
        Kind::Comment(text) => text.trim_start().starts_with("END-OF-PATH"),
        Kind::Post { word, .. } => matches!(word.as_str(), "END" | "REWIND"),
        _ => false,
    }
}
