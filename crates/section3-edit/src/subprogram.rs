//! DEFSUB, ENDSUB and CALSUB carried out: what stands between the first two goes out at each call, and
//! not where it is defined.

use std::io;

use aptc_cldata::{Arg, Block, Kind, Motion, Position, Record, RecordWriter, Spool};
use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_geometry::Vec3;

/// Calls within calls.
const DEEPEST: usize = 16;
/// Records that all calls of a stream may make, against calls that multiply.
const MOST_CALLED: u64 = 1_000_000_000;

/// Expands the subprograms of a stream. One that has been expanded holds no definitions any more, so to do it
/// again changes nothing.
#[derive(Default)]
pub struct Subprograms {
    spool: Spool,
    known: Vec<Subprogram>,
    /// The definition that is being read, with its statement.
    open: Option<(usize, Origin)>,
    n_called: u64,
    /// Last position put out, and whether with its axis.
    last: Option<(Position, bool)>,
    list: Vec<Diagnostic>,
}

struct Subprogram {
    name: String,
    start: u64,
    end: u64,
}

/// A call that is being carried out.
struct Call {
    subprogram: usize,
    at: u64,
    block: Block,
}

impl Subprograms {
    /// Keeps definitions in that spool.
    pub fn with_spool(spool: Spool) -> Self {
        Self { spool, ..Self::default() }
    }

    /// What there is to say so far.
    pub fn take_diagnostics(&mut self) -> Vec<Diagnostic> {
        std::mem::take(&mut self.list)
    }

    /// Takes a record and puts out what becomes of it.
    pub fn push(&mut self, record: &Record, out: &mut dyn RecordWriter) -> io::Result<()> {
        if let Kind::Post { word, args } = &record.kind {
            match word.as_str() {
                "DEFSUB" => return self.define(args, &record.origin),
                "ENDSUB" if self.open.is_some() => {
                    self.end_definition();
                    return Ok(());
                }
                "CALSUB" if self.open.is_none() => {
                    if let Some(i) = self.find(args) {
                        out.write(&comment(args, &record.origin))?;
                        return self.call(i, &record.origin, out);
                    }
                }
                _ => {}
            }
        }
        let fini = matches!(record.kind, Kind::Fini);
        if fini {
            self.finish(out)?;
        }
        if self.open.is_some() {
            return self.spool.put(record);
        }
        self.put(record, out)?;
        if fini {
            self.known.clear();
            self.last = None;
        }
        Ok(())
    }

    /// Puts a record out; GODLTA, which readers leave where they do not know the place, becomes motion.
    fn put(&mut self, record: &Record, out: &mut dyn RecordWriter) -> io::Result<()> {
        match &record.kind {
            Kind::Motion(m) => {
                self.last = m.points.last().map(|p| (*p, m.with_axis)).or(self.last);
            }
            Kind::Post { word, args } if word == "GODLTA" => {
                let Some((p, with_axis)) = self.last.and_then(|last| moved(last, args)) else {
                    let help = "give the place with GOTO before";
                    self.error(&record.origin, "GODLTA from nowhere".to_owned(), help);
                    return Ok(());
                };
                self.last = Some((p, with_axis));
                let motion = Motion { points: vec![p], with_axis, ..Motion::default() };
                let kind = Kind::Motion(motion);
                return out.write(&Record { origin: record.origin.clone(), kind });
            }
            _ => {}
        }
        out.write(record)
    }

    /// Ends the stream: what a definition without its end holds goes out, so that no motion is lost.
    pub fn finish(&mut self, out: &mut dyn RecordWriter) -> io::Result<()> {
        let Some((index, origin)) = self.open.take() else { return Ok(()) };
        let what = format!("DEFSUB/{} without ENDSUB", self.known[index].name);
        self.error(&origin, what, "write ENDSUB where the subprogram ends");
        let (mut at, end) = (self.known[index].start, self.spool.end());
        let (mut record, mut block) = (Record::default(), Block::default());
        while at < end {
            at = self.spool.get(at, &mut record, &mut block)?;
            self.put(&record, out)?;
        }
        Ok(())
    }

    fn define(&mut self, args: &[Arg], origin: &Origin) -> io::Result<()> {
        if let Some((index, _)) = &self.open {
            let what = format!("DEFSUB/{} within DEFSUB/{}", name(args), self.known[*index].name);
            self.error(origin, what, "end the one before with ENDSUB");
            self.end_definition();
        }
        let start = self.spool.end();
        self.known.push(Subprogram { name: name(args), start, end: start });
        self.open = Some((self.known.len() - 1, origin.clone()));
        Ok(())
    }

    fn end_definition(&mut self) {
        if let Some((index, _)) = self.open.take() {
            self.known[index].end = self.spool.end();
        }
    }

    /// The subprogram of that name that was defined last.
    fn find(&self, args: &[Arg]) -> Option<usize> {
        let name = name(args);
        self.known.iter().rposition(|s| s.name == name)
    }

    fn call(
        &mut self,
        index: usize,
        origin: &Origin,
        out: &mut dyn RecordWriter,
    ) -> io::Result<()> {
        let begin = |known: &[Subprogram], i: usize| Call {
            subprogram: i,
            at: known[i].start,
            block: Block::default(),
        };
        let mut calls = vec![begin(&self.known, index)];
        let mut record = Record::default();
        while let Some(call) = calls.last_mut() {
            if call.at >= self.known[call.subprogram].end {
                calls.pop();
                continue;
            }
            call.at = self.spool.get(call.at, &mut record, &mut call.block)?;
            self.n_called += 1;
            if self.n_called > MOST_CALLED {
                let what = format!("more than {MOST_CALLED} records by CALSUB");
                self.error(origin, what, "call fewer subprograms within subprograms");
                return Ok(());
            }
            let inner = match &record.kind {
                Kind::Post { word, args } if word == "CALSUB" => self.find(args),
                _ => None,
            };
            let Some(inner) = inner else {
                self.put(&record, out)?;
                continue;
            };
            let name = &self.known[inner].name;
            if calls.iter().any(|c| c.subprogram == inner) || calls.len() >= DEEPEST {
                let what = format!("CALSUB/{name} within itself, or more than {DEEPEST} deep");
                self.error(&record.origin, what, "call it from outside alone");
            } else {
                calls.push(begin(&self.known, inner));
            }
        }
        Ok(())
    }

    fn error(&mut self, origin: &Origin, what: String, help: &str) {
        if self.list.len() < 100 {
            let d = Diagnostic::error(codes::SUBPROGRAM, origin.span, what).help(help);
            self.list.push(d.within(origin.trace.clone()));
        }
    }
}

/// The position after GODLTA: a way along the axis, a vector, or a vector and a new axis.
fn moved((p, with_axis): (Position, bool), args: &[Arg]) -> Option<(Position, bool)> {
    let numbers: Option<Vec<f64>> = args
        .iter()
        .map(|a| match a {
            Arg::Number(x) => Some(*x),
            _ => None,
        })
        .collect();
    match numbers?.as_slice() {
        [d] => Some((Position { te: p.te + p.ta * *d, ..p }, with_axis)),
        [x, y, z] => Some((Position { te: p.te + Vec3::new(*x, *y, *z), ..p }, with_axis)),
        [x, y, z, i, j, k] => {
            let ta = Vec3::new(*i, *j, *k).try_normalize(0.0)?;
            Some((Position { te: p.te + Vec3::new(*x, *y, *z), ta }, true))
        }
        _ => None,
    }
}

/// The name: what follows ID, or the first argument.
fn name(args: &[Arg]) -> String {
    let id = args.iter().position(|a| matches!(a, Arg::Word(w) if w == "ID")).map_or(0, |i| i + 1);
    match args.get(id) {
        Some(Arg::Number(x)) => x.to_string(),
        Some(Arg::Word(w)) => w.to_string(),
        Some(Arg::Text(t)) => t.trim().to_ascii_uppercase(),
        _ => String::new(),
    }
}

/// What stands in the place of a call.
fn comment(args: &[Arg], origin: &Origin) -> Record {
    let text = format!(" CALSUB/{}", name(args)).into();
    Record { origin: origin.clone(), kind: Kind::Comment(text) }
}
