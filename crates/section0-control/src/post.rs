//! Section 4 for every machine that a part program names.

use std::io::{self, Write};

use aptc_cldata::{Arg, Kind, Position, Record};
use aptc_diagnostics::{Code, Diagnostic, Span, codes};
use aptc_post::{BlockOrigin, Machine, Post, PostOptions, SetupSheet, ToolScan};
use smol_str::SmolStr;

use crate::{CodeOptions, MachineChoice, Records, Text};

/// Machine code for one machine.
#[derive(Debug)]
pub struct Nc {
    /// The machine.
    pub machine: Machine,
    /// The text.
    pub text: Text,
    /// Tools, times, travel and notes.
    pub summary: aptc_post::Summary,
    /// From which statement each run of lines comes, if it was asked for.
    pub map: Vec<BlockOrigin>,
    /// Is it for a machine after the first?
    pub further: bool,
}

impl Nc {
    /// Machining time in seconds.
    pub fn seconds(&self) -> f64 {
        60.0 * (self.summary.cut_minutes + self.summary.rapid_minutes)
    }

    /// The setup sheet.
    pub fn setup(&self) -> SetupSheet {
        SetupSheet::new(&self.machine, &self.summary)
    }
}

/// Posts an edited CL stream for the machine that was chosen, else for those that MACHIN names, else for the
/// default machine. A text that the post refused is left out.
pub(crate) fn post_part(
    records: &Records,
    head: &PartHead,
    code: &CodeOptions,
) -> io::Result<(Vec<Nc>, Vec<Diagnostic>)> {
    let mut poster = Poster::new(head, code, &mut || Ok(Text::default()))?;
    records.try_for_each(|record| poster.push(record))?;
    let (texts, diagnostics) = poster.finish()?;
    Ok((texts.into_iter().map(|(nc, text)| Nc { text, ..nc }).collect(), diagnostics))
}

/// Bytes of machine code that come together before they are handed on.
const BLOCK: usize = 64 * 1024;

/// What must be known of a part program before its first block is written.
#[derive(Debug, Default)]
pub(crate) struct PartHead {
    tools: ToolScan,
    machines: Vec<Machine>,
    /// PARTNO, or the first record.
    start: Option<(Span, bool)>,
    /// The first MACHIN that names no known machine.
    unknown: Option<(SmolStr, Span)>,
    /// Does the tool axis lean anywhere?
    leans: bool,
}

impl PartHead {
    /// Looks at one record.
    pub(crate) fn push(&mut self, record: &Record) {
        let partno = matches!(&record.kind, Kind::Text { word, .. } if word == "PARTNO");
        if self.start.is_none_or(|(_, found)| partno && !found) {
            self.start = Some((record.origin.span, partno));
        }
        if let Kind::Motion(motion) = &record.kind {
            // So little counts as upright on a machine of three axes.
            let upright = |p: &Position| p.ta.xy().norm_squared() <= 1e-12 && p.ta.z > 0.0;
            self.leans |= !self.leans && !motion.points.iter().all(upright);
        }
        let Kind::Post { word, args } = &record.kind else { return };
        self.tools.push(record);
        let name = match args.first() {
            Some(Arg::Word(name)) if word == "MACHIN" => name.clone(),
            // A name with hyphens.
            Some(Arg::Text(name)) if word == "MACHIN" => SmolStr::from(name.trim()),
            _ => return,
        };
        match aptc_post::machine_for(&name, &args[1..]) {
            Some(m) if self.machines.iter().any(|f| f.name == m.name) => {}
            Some(m) => self.machines.push(m.clone()),
            None if self.unknown.is_none() => {
                self.unknown = Some((name, record.origin.span));
            }
            None => {}
        }
    }

    /// Whether a MACHIN statement names a machine that is known.
    pub(crate) fn names_machine(&self) -> bool {
        !self.machines.is_empty()
    }

    fn machines(
        &self,
        choice: Option<&MachineChoice>,
        diagnostics: &mut Vec<Diagnostic>,
    ) -> Vec<Machine> {
        if let Some(choice) = choice {
            return match choice.machine() {
                Ok(m) => vec![m],
                Err(d) => {
                    diagnostics.extend(d);
                    Vec::new()
                }
            };
        }
        if !self.machines.is_empty() {
            return self.machines.clone();
        }
        let name = if self.leans { "linuxcnc-5axis" } else { "linuxcnc-mill" };
        let default = aptc_post::machine(name).expect("it is built in");
        let (span, message) = match &self.unknown {
            Some((name, span)) => (
                *span,
                format!("{name} is no machine that aptc knows; posted for {}", default.title),
            ),
            None => (
                self.start.map_or(Span::default(), |s| s.0),
                format!("no MACHIN statement; posted for {}", default.title),
            ),
        };
        let alike = |(unknown, _): &(SmolStr, Span)| {
            aptc_post::machin_names().find(|name| unknown.get(..3) == name.get(..3))
        };
        let near = self.unknown.as_ref().and_then(alike);
        let near = near.map_or(String::new(), |name| format!("did you mean MACHIN/{name}? "));
        let help = format!("{near}choose a machine with --machine; `aptc machines` lists them");
        diagnostics.push(Diagnostic::note_at(codes::MACHINE_ASSUMED, span, message).help(help));
        vec![default.clone()]
    }
}

/// Posts one part program for all its machines at once, record by record.
pub(crate) struct Poster<W> {
    runs: Vec<Run<W>>,
    diagnostics: Vec<Diagnostic>,
    /// The machine is assumed and its code was not asked for: a feed that is missing and words that it has not are no errors.
    may_fail: bool,
}

/// What a program lacks that was not written for the machine that is assumed, or has too much of: its motions are sound.
const LACKING: [Code; 3] = [codes::NO_FEED, codes::WORD_LACKING, codes::POST_ARGUMENTS];

/// Machine codes with their texts.
type Texts<W> = Vec<(Nc, W)>;

/// One machine.
struct Run<W> {
    machine: Machine,
    post: Post,
    block: Vec<u8>,
    out: W,
    /// Has anything been written?
    begun: bool,
}

impl<W: Write> Poster<W> {
    /// A post-processor for each machine, each with an output of its own from `create`.
    pub(crate) fn new(
        head: &PartHead,
        code: &CodeOptions,
        create: &mut dyn FnMut() -> io::Result<W>,
    ) -> io::Result<Self> {
        let mut diagnostics = Vec::new();
        let tools = head.tools.clone().finish();
        let mut runs = Vec::new();
        for machine in head.machines(code.machine.as_ref(), &mut diagnostics) {
            let options = PostOptions {
                tools: tools.clone(),
                work_offset: code.work_offset.clone(),
                stock: code.stock,
                annotate: code.annotate,
                map: code.map,
                ..PostOptions::default()
            };
            let post = Post::new(&machine, options);
            runs.push(Run { machine, post, block: Vec::new(), out: create()?, begun: false });
        }
        let may_fail = code.by_default
            && code.machine.is_none()
            && head.unknown.is_none()
            && !head.names_machine();
        Ok(Self { runs, diagnostics, may_fail })
    }

    /// Takes one record.
    pub(crate) fn push(&mut self, record: &Record) -> io::Result<()> {
        for run in &mut self.runs {
            run.post.push(record, &mut run.block);
            if run.block.len() >= BLOCK {
                run.pass_on()?;
            }
        }
        Ok(())
    }

    /// The machine codes that were not refused, their texts apart, and all messages.
    pub(crate) fn finish(mut self) -> io::Result<(Texts<W>, Vec<Diagnostic>)> {
        let mut texts = Vec::new();
        for (i, mut run) in self.runs.into_iter().enumerate() {
            let post = run.post;
            let posted = post.finish(&mut run.block);
            run.begun |= !run.block.is_empty();
            run.out.write_all(&run.block)?;
            run.out.flush()?;
            let refused = posted.diagnostics.iter().any(Diagnostic::is_error);
            let mut errors = posted.diagnostics.iter().filter(|d| d.is_error());
            let lacks = |d: &Diagnostic| LACKING.contains(&d.code);
            if self.may_fail
                && let Some(why) = errors.next()
                && lacks(why)
                && errors.all(lacks)
            {
                let what = format!("no machine code is written: {}", why.message);
                let help =
                    "choose a machine with MACHIN or --machine when there shall be machine code";
                let note = Diagnostic::note_at(codes::MACHINE_ASSUMED, why.span, what);
                self.diagnostics = vec![note.help(help)];
                continue;
            }
            for d in posted.diagnostics {
                if !self.diagnostics.contains(&d) {
                    self.diagnostics.push(d);
                }
            }
            if !refused && run.begun {
                let (machine, further, text) = (run.machine, i > 0, Text::default());
                let (summary, map) = (posted.summary, posted.map);
                texts.push((Nc { machine, text, summary, map, further }, run.out));
            }
        }
        Ok((texts, self.diagnostics))
    }
}

impl<W: Write> Run<W> {
    fn pass_on(&mut self) -> io::Result<()> {
        self.begun = true;
        self.out.write_all(&self.block)?;
        self.block.clear();
        Ok(())
    }
}
