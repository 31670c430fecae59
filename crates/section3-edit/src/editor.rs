//! INDEX, COPY, TRACUT and VTLAXS carried out on the stream of records.

use std::io;

use aptc_cldata::{Block, Edit, Kind, Position, Record, RecordWriter, Spool, Units};
use aptc_diagnostics::{Code, Diagnostic, Origin, Severity, Span, codes};
use aptc_geometry::Transform;

use crate::carry::{Carrier, Trouble};
use crate::vtlaxs::Vtlaxs;

/// Levels of COPY within COPY. APT has three; more do no harm.
const DEEPEST: usize = 100;
/// Records that all copies of one program may make, against a mistake in a count: in memory, and where they
/// go to a file.
const MOST_COPIED: u64 = 5_000_000;
const MOST_COPIED_TO_FILE: u64 = 1_000_000_000;
/// Messages of one stream.
const MOST_MESSAGES: usize = 500;

/// Carries out the editing of a stream.
///
/// TRACUT is not cumulative: each acts on the positions as Section 2 made them and replaces the one
/// before. A COPY repeats the edited records of its range; those stand between INDEX and `INDEX/n,NOMORE`
/// or, without that, the COPY itself, copies made in between included. A copy of a copy is made anew from the
/// record that it repeats: what copies now goes first, then what copied before, as APT-360 carries out the
/// statements of the range, COPY among them, once more. Copies are not transformed by a TRACUT around them
/// again, and carry the origin of what they repeat.
#[derive(Default)]
pub struct Editor {
    /// The records of open ranges as they were before any COPY, and between them the maps of the copies.
    spool: Spool,
    /// Map of the record put last into the spool, if it is that of a copy.
    spooled: Option<Transform>,
    ranges: Vec<Range>,
    tracut: Option<Carrier>,
    vtlaxs: Vtlaxs,
    /// Last position before editing.
    last: Option<Position>,
    /// The same where VTLAXS has been done.
    put: Option<Position>,
    /// Last position put out.
    emitted: Option<Position>,
    units: Units,
    tolerance: f64,
    failed: bool,
    n_copied: u64,
    n_spooled: u64,
    scratch: Record,
    list: Vec<Diagnostic>,
    /// How many more there were, and the first of them.
    left_out: Option<(u64, Code, Span)>,
    said: Vec<(Code, &'static str)>,
}

/// What stands between INDEX and its end.
struct Range {
    n: f64,
    start: u64,
    end: Option<u64>,
    /// Map of what stands at its beginning, if that is a copy.
    map: Option<Transform>,
    origin: Origin,
    copied: bool,
    /// Records in the spool where it begins and ends.
    counts: (u64, Option<u64>),
    /// The range that ended while this one, which began in it, was still open.
    overlaps: Option<f64>,
    /// Position before it.
    before: Option<Position>,
}

impl Editor {
    /// An editor that keeps ranges in memory.
    pub fn new() -> Self {
        Self::default()
    }

    /// An editor that keeps ranges in that spool.
    pub fn with_spool(spool: Spool) -> Self {
        Self { spool, ..Self::default() }
    }

    /// From here on nothing is edited: motion had errors, and copies of a broken path are of no use.
    pub fn motion_failed(&mut self) {
        self.failed = true;
    }

    /// What there is to say so far.
    pub fn take_diagnostics(&mut self) -> Vec<Diagnostic> {
        let mut list = std::mem::take(&mut self.list);
        if let Some((n, code, span)) = self.left_out.take() {
            let what = format!("{n} more messages about COPY and INDEX are left out");
            list.push(Diagnostic::note_at(code, span, what));
        }
        list
    }

    /// Takes a record and puts out what becomes of it.
    pub fn push(&mut self, record: &Record, out: &mut dyn RecordWriter) -> io::Result<()> {
        if self.failed {
            return out.write(record);
        }
        match self.vtlaxs.push(record, self.last) {
            crate::vtlaxs::Step::Pass => self.edit(record, out)?,
            crate::vtlaxs::Step::Hold => {}
            crate::vtlaxs::Step::Release(records) => {
                for d in self.vtlaxs.take_diagnostics() {
                    self.list.push(d);
                }
                for r in records {
                    self.edit(&r, out)?;
                }
            }
        }
        if let Kind::Motion(m) = &record.kind {
            self.last = m.points.last().copied().or(self.last);
        }
        Ok(())
    }

    /// Ends the stream.
    pub fn finish(&mut self, out: &mut dyn RecordWriter) -> io::Result<()> {
        let held = self.vtlaxs.end();
        self.list.extend(self.vtlaxs.take_diagnostics());
        for r in held {
            self.edit(&r, out)?;
        }
        self.end_program();
        Ok(())
    }

    fn edit(&mut self, record: &Record, out: &mut dyn RecordWriter) -> io::Result<()> {
        match &record.kind {
            Kind::Edit(Edit::Index { n, close: false }) => {
                self.open(*n, &record.origin);
                self.emit(record, out)
            }
            Kind::Edit(Edit::Index { n, close: true }) => {
                self.emit(record, out)?;
                self.close(*n, &record.origin);
                Ok(())
            }
            Kind::Edit(Edit::Copy { n, step, count }) => {
                self.copy(*n, step, *count, record, out)?;
                self.emit(record, out)
            }
            Kind::Edit(Edit::Tracut(map)) => {
                self.tracut = map.map(Carrier::new);
                self.emit(record, out)
            }
            kind => {
                match kind {
                    Kind::Units(u) => self.units = *u,
                    Kind::Intol(t) => self.tolerance = t[1],
                    Kind::Outtol(t) => self.tolerance += t[1],
                    _ => {}
                }
                let last = self.put;
                if let Kind::Motion(m) = kind {
                    self.put = m.points.last().copied().or(last);
                }
                let end = matches!(kind, Kind::Fini);
                match self.tracut.clone() {
                    Some(carrier) if touches(kind) => self.carried(&carrier, record, last, out)?,
                    _ => self.emit(record, out)?,
                }
                if end {
                    self.end_program();
                }
                Ok(())
            }
        }
    }

    fn carried(
        &mut self,
        carrier: &Carrier,
        record: &Record,
        start: Option<Position>,
        out: &mut dyn RecordWriter,
    ) -> io::Result<()> {
        let mut scratch = std::mem::take(&mut self.scratch);
        scratch.clone_from(record);
        if let Err(trouble) = carrier.carry(&mut scratch.kind, start, self.chord_tolerance()) {
            self.trouble(trouble, &scratch.origin);
        }
        let done = self.emit(&scratch, out);
        self.scratch = scratch;
        done
    }

    /// Tolerance of chords that an arc must be cut into: the one stated, or 10 micrometres.
    fn chord_tolerance(&self) -> f64 {
        if self.tolerance > 0.0 { self.tolerance } else { 0.01 / self.units.mm() }
    }

    /// Puts a record out, and into the spool while a range is open.
    fn emit(&mut self, record: &Record, out: &mut dyn RecordWriter) -> io::Result<()> {
        self.keep(record, None)?;
        self.put_out(record, out)
    }

    /// Puts into the spool, while a range is open, a record that `map` makes a copy of.
    fn keep(&mut self, record: &Record, map: Option<Transform>) -> io::Result<()> {
        if self.ranges.iter().any(|r| r.end.is_none()) {
            if self.spooled != map {
                self.spooled = map;
                let kind = Kind::Edit(Edit::Tracut(map));
                self.spool.put(&Record { origin: map_origin(), kind })?;
            }
            self.spool.put(record)?;
            self.n_spooled += 1;
        }
        Ok(())
    }

    fn put_out(&mut self, record: &Record, out: &mut dyn RecordWriter) -> io::Result<()> {
        if let Kind::Motion(m) = &record.kind {
            self.emitted = m.points.last().copied().or(self.emitted);
        }
        out.write(record)
    }

    fn open(&mut self, n: f64, origin: &Origin) {
        let n_open = self.ranges.iter().filter(|r| r.end.is_none()).count();
        if n_open >= DEEPEST {
            let what = format!("INDEX/{n} is the {}th that is open", n_open + 1);
            return self.error(codes::NESTED_TOO_DEEP, origin, what, "close some with NOMORE");
        }
        if self.ranges.iter().any(|r| same(r.n, n)) {
            let what = format!("INDEX/{n} stands twice");
            let d = Diagnostic::warning(codes::INDEX_TWICE, origin.span, what);
            let d = d.note("a COPY takes the range that began last");
            let d = d.help("give each range a number of its own");
            self.say(d.within(origin.trace.clone()));
        }
        let range = Range {
            n,
            start: self.spool.end(),
            end: None,
            map: self.spooled,
            origin: origin.clone(),
            copied: false,
            counts: (self.n_spooled, None),
            overlaps: None,
            before: self.emitted,
        };
        self.ranges.push(range);
    }

    /// The range of that number that began last.
    fn find(&mut self, n: f64) -> Option<usize> {
        self.ranges.iter().rposition(|r| same(r.n, n))
    }

    fn close(&mut self, n: f64, origin: &Origin) {
        let (end, n_spooled) = (self.spool.end(), self.n_spooled);
        match self.find(n).map(|i| &mut self.ranges[i]) {
            Some(range) if range.end.is_none() => {
                range.end = Some(end);
                range.counts.1 = Some(n_spooled);
            }
            _ => {
                let what = format!("INDEX/{n},NOMORE closes nothing");
                let help = format!("write INDEX/{n} where the range begins");
                self.error(codes::NO_INDEX, origin, what, &help);
            }
        }
    }

    fn copy(
        &mut self,
        n: f64,
        step: &Transform,
        count: u32,
        record: &Record,
        out: &mut dyn RecordWriter,
    ) -> io::Result<()> {
        let origin = &record.origin;
        let Some(index) = self.find(n) else {
            let what = format!("COPY/{n} without INDEX/{n}");
            let help = format!("write INDEX/{n} where the range begins");
            self.error(codes::NO_INDEX, origin, what, &help);
            return Ok(());
        };
        // The end is that of NOMORE, or here; a range without NOMORE stays open for a further COPY.
        let (start, end) = (self.ranges[index].start, self.ranges[index].end);
        let end = end.unwrap_or(self.spool.end());
        self.ranges[index].copied = true;
        if let Some(outer) = self.ranges[index].overlaps {
            let what = format!("the range of COPY/{n} overlaps that of COPY/{outer}");
            let help = format!("end the range {n} before COPY/{outer}, or begin it after");
            self.error(codes::COPY_OVERLAP, origin, what, &help);
            return Ok(());
        }
        for r in &mut self.ranges {
            let inside = r.start > start && r.start < end;
            if inside && r.end.is_none() && !r.copied {
                r.overlaps.get_or_insert(n);
            }
        }
        let mut map = *step;
        let mut copied = Record::default();
        let mut block = Block::default();
        let range = &self.ranges[index];
        let n_range = range.counts.1.unwrap_or(self.n_spooled).saturating_sub(range.counts.0);
        self.n_copied = self.n_copied.saturating_add(n_range.saturating_mul(count.into()));
        let most = if self.spool.is_spilling() { MOST_COPIED_TO_FILE } else { MOST_COPIED };
        if self.n_copied > most {
            let what = format!("{count} copies make more than {most} records");
            self.error(codes::TOO_MANY_COPIES, origin, what, "lower the count of copies");
            return Ok(());
        }
        for k in 0..count {
            // What copied before is done after.
            let after = |inner: Option<Transform>| inner.map_or(map, |inner| map.then(&inner));
            let mut total = after(self.ranges[index].map);
            let mut carrier = Carrier::new(total);
            let mut at = start;
            let mut last = self.ranges[index].before;
            while at < end {
                at = self.spool.get(at, &mut copied, &mut block)?;
                if let Some(inner) = as_map(&copied) {
                    total = after(inner);
                    carrier = Carrier::new(total);
                    continue;
                }
                let before = last;
                if let Kind::Motion(m) = &copied.kind {
                    last = m.points.last().copied().or(last);
                }
                self.keep(&copied, Some(total))?;
                if total != Transform::identity() && touches(&copied.kind) {
                    let tolerance = self.chord_tolerance();
                    if let Err(trouble) = carrier.carry(&mut copied.kind, before, tolerance) {
                        self.trouble(trouble, &copied.origin);
                    }
                }
                self.put_out(&copied, out)?;
            }
            if k + 1 < count {
                map = map.then(step);
            }
        }
        Ok(())
    }

    fn end_program(&mut self) {
        for range in std::mem::take(&mut self.ranges) {
            if !range.copied && range.end.is_none() {
                let d = Diagnostic::warning(
                    codes::INDEX_UNUSED,
                    range.origin.span,
                    format!("INDEX/{} without COPY or NOMORE", range.n),
                )
                .help(format!(
                    "write COPY/{0},.. or INDEX/{0},NOMORE where the range ends",
                    range.n
                ));
                self.say(d.within(range.origin.trace));
            }
        }
        self.tracut = None;
        (self.last, self.put, self.emitted) = (None, None, None);
    }

    fn error(&mut self, code: Code, origin: &Origin, what: String, help: &str) {
        let d = Diagnostic::error(code, origin.span, what).help(help);
        self.say(d.within(origin.trace.clone()));
    }

    /// Keeps a message, of very many only the first; an error that is the first one always.
    fn say(&mut self, d: Diagnostic) {
        let first_error = || d.is_error() && !self.list.iter().any(Diagnostic::is_error);
        if self.list.len() < MOST_MESSAGES || first_error() {
            self.list.push(d);
        } else {
            self.left_out.get_or_insert((0, d.code, d.span)).0 += 1;
        }
    }

    /// Says what could not be carried, each kind once.
    fn trouble(&mut self, trouble: Trouble, origin: &Origin) {
        let (severity, what, help) = match trouble {
            Trouble::Argument => (
                Severity::Error,
                "a geometric argument cannot be carried by this matrix and stays where it is",
                "a matrix that turns and moves, or scales all directions alike, carries every form",
            ),
            Trouble::Axis => (
                Severity::Error,
                "the matrix leaves nothing of the tool axis",
                "use a matrix that has an inverse",
            ),
            Trouble::Tilt => (
                Severity::Warning,
                "the matrix tilts the tool, but the positions have no axis that says so",
                "write MULTAX before the motion",
            ),
            Trouble::Scale => (
                Severity::Warning,
                "the matrix scales the path and not the cutter, which no longer touches what it touched",
                "define the part in its size, or take a cutter as much larger or smaller",
            ),
        };
        if self.said.contains(&(codes::CL_NOT_CARRIED, what)) {
            return;
        }
        self.said.push((codes::CL_NOT_CARRIED, what));
        let d = match severity {
            Severity::Error => Diagnostic::error(codes::CL_NOT_CARRIED, origin.span, what),
            _ => Diagnostic::warning(codes::CL_NOT_CARRIED, origin.span, what),
        };
        self.list.push(d.help(help).within(origin.trace.clone()));
    }
}

/// Origin of the records of the spool that hold the map of those after them: no statement has this number.
fn map_origin() -> Origin {
    Origin { isn: u32::MAX, line: u32::MAX, ..Origin::default() }
}

/// The map of the copies that follow, or that none do, if the record of the spool says so.
fn as_map(record: &Record) -> Option<Option<Transform>> {
    match record.kind {
        Kind::Edit(Edit::Tracut(map)) if record.origin == map_origin() => Some(map),
        _ => None,
    }
}

/// Can a map change the record?
fn touches(kind: &Kind) -> bool {
    match kind {
        Kind::Motion(_) => true,
        Kind::Post { args, .. } => args.iter().any(|a| matches!(a, aptc_cldata::Arg::Form { .. })),
        _ => false,
    }
}

/// Numbers of ranges are whole.
fn same(a: f64, b: f64) -> bool {
    (a - b).abs() < 0.5
}
