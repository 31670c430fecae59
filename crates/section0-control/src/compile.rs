//! The road: from source text to machine code.

use std::collections::BTreeSet;
use std::sync::Arc;

use aptc_arelem::Arelem;
use aptc_cldata as cl;
use aptc_diagnostics::{Diagnostic, SourceMap, codes};
use aptc_protap as protap;
use aptc_translate::{
    Entry, FileError, FileRequest, Files, Interpreter, LoadedFile, Quantity, Step,
};
use aptc_verify::{Certificate, Effort, Verifier};

use crate::geometry_json::Named;
use crate::post::{Nc, post_part};
use crate::{FULL_PROOF, Options, Source, Summary, Verify, World, WorldError, listing};

/// What came of a part program.
#[derive(Debug, Default)]
pub struct Compiled {
    /// The files that were read.
    pub sources: SourceMap,
    /// All messages of all Sections, in the order of the road.
    pub diagnostics: Vec<Diagnostic>,
    /// The part programs of the file, PARTNO to FINI, in order.
    pub parts: Vec<Part>,
    /// The listing.
    pub listing: String,
    /// Final values of all names.
    pub geometry: Vec<(String, Named)>,
}

/// One part program, PARTNO to FINI.
#[derive(Debug, Default)]
pub struct Part {
    /// The numeric part program, if it was to be kept.
    pub protap: Vec<protap::Record>,
    /// CL data of Section 2.
    pub computed: Vec<cl::Record>,
    /// CL data after Section 3.
    pub edited: Vec<cl::Record>,
    /// Machine code, one text a machine.
    pub nc: Vec<Nc>,
    /// Figures.
    pub summary: Summary,
    /// What was proved of the path.
    pub certificate: Option<Certificate>,
    /// Was NOPLOT given?
    pub noplot: bool,
}

impl Compiled {
    /// Is there an error among the messages?
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|d| d.is_error() && !is_refutation(d))
    }

    /// Did verification refute a cut vector?
    pub fn is_refuted(&self) -> bool {
        self.diagnostics.iter().any(is_refutation)
    }

    /// Is the CL data whole: no error of Sections 1 to 3?
    pub fn is_cl_whole(&self) -> bool {
        !self.diagnostics.iter().any(|d| d.is_error() && d.code.number() < 4000)
    }
}

fn is_refutation(d: &Diagnostic) -> bool {
    d.is_error() && d.code.number() >= 5000
}

/// Compiles the part programs of a file.
pub fn compile(source: Source, world: &mut dyn World, options: &Options) -> Compiled {
    let mut files = Includes(world);
    let mut section1 =
        Interpreter::new(&source.name, &source.text, &mut files, options.translate.clone());
    let mut run = Run::new(options);
    let mut entries = Vec::new();
    loop {
        let step = section1.step();
        run.compiled.diagnostics.extend(section1.take_diagnostics());
        entries.extend(section1.take_listing());
        match step {
            Step::Record(record) => {
                let outcome = run.take(record);
                section1.outcome(outcome);
            }
            Step::End => break,
        }
    }
    run.end_part();
    run.compiled.sources = section1.sources().clone();
    let named = |quantity| match quantity {
        Quantity::Scalar(x) => Named::Scalar(x),
        Quantity::Form(form) => Named::Form(form),
    };
    run.compiled.geometry =
        section1.geometry().into_iter().map(|(n, q)| (name_of(&n), named(q))).collect();
    run.finish(&entries)
}

/// Goes on from a numeric part program, at Section 2.
pub fn resume(source: Source, options: &Options) -> Compiled {
    let mut run = Run::new(options);
    let file = run.compiled.sources.add(source.name, Arc::clone(&source.text));
    let (records, diagnostics) = protap::read(file, &source.text);
    run.compiled.diagnostics.extend(diagnostics);
    for record in records {
        run.take(record);
    }
    run.end_part();
    run.finish(&[])
}

fn name_of(n: &protap::NameRef) -> String {
    if n.subscript > 0 { format!("{}({})", n.name, n.subscript) } else { n.name.to_string() }
}

/// A run through Sections 2 to 4.
struct Run<'o> {
    options: &'o Options,
    compiled: Compiled,
    section2: Arelem,
    part: Part,
    /// Has the present part program any record?
    begun: bool,
    nopost: bool,
    /// PTONLY/n: Sections after the n-th do not run.
    last_section: u32,
}

impl<'o> Run<'o> {
    fn new(options: &'o Options) -> Self {
        Self {
            options,
            compiled: Compiled::default(),
            section2: Arelem::new(aptc_arelem::Options::default()),
            part: Part::default(),
            begun: false,
            nopost: false,
            last_section: 4,
        }
    }

    /// Hands a record to Section 2 and brings back the outcome.
    fn take(&mut self, record: protap::Record) -> protap::Outcome {
        self.begun = true;
        match &record.kind {
            protap::Kind::Nopost => self.nopost = true,
            protap::Kind::Noplot => self.part.noplot = true,
            protap::Kind::Ptonly(n) => self.last_section = *n,
            _ => {}
        }
        let runs = self.options.motion && self.last_section >= 2;
        let outcome = if runs {
            self.section2.execute(&record, &mut self.part.computed)
        } else {
            protap::Outcome::None
        };
        let fini = matches!(record.kind, protap::Kind::Fini);
        if self.options.keep_protap {
            self.part.protap.push(record);
        }
        if fini {
            self.end_part();
        }
        outcome
    }

    /// Sections 3 and 4 of a part program.
    fn end_part(&mut self) {
        if !self.begun {
            return;
        }
        self.section2.finish(&mut self.part.computed);
        self.compiled.diagnostics.extend(self.section2.take_diagnostics());
        let mut part = std::mem::take(&mut self.part);
        let whole = self.compiled.is_cl_whole();
        if self.options.verify != Verify::Off {
            self.prove(&mut part);
        }
        if self.last_section >= 3 {
            let (edited, diagnostics) = crate::edit::edit(&part.computed, whole);
            part.edited = edited;
            self.compiled.diagnostics.extend(diagnostics);
        }
        part.summary = Summary::of(&part.edited);
        if self.options.post
            && !self.nopost
            && self.last_section >= 4
            && self.compiled.is_cl_whole()
        {
            let (nc, diagnostics) = post_part(&part.edited, self.options.machine.as_ref());
            part.nc = nc;
            self.compiled.diagnostics.extend(diagnostics);
        }
        self.compiled.parts.push(part);
        self.section2 = Arelem::new(aptc_arelem::Options::default());
        (self.begun, self.nopost, self.last_section) = (false, false, 4);
    }

    /// Proves the path of Section 2 against its surfaces.
    fn prove(&mut self, part: &mut Part) {
        let points = |r: &cl::Record| match &r.kind {
            cl::Kind::Motion(m) => m.points.len() as u64,
            _ => 0,
        };
        let n: u64 = part.computed.iter().map(points).sum();
        let every = n.div_ceil(FULL_PROOF).max(2);
        let effort = match self.options.verify {
            Verify::UpTo(most) if n > most => Effort::Every(every),
            Verify::Sample => Effort::Every(every),
            _ => Effort::Full,
        };
        let mut verifier = Verifier::new(effort);
        for record in &part.computed {
            verifier.push(record);
        }
        let (certificate, diagnostics) = verifier.finish();
        part.certificate = Some(certificate);
        self.compiled.diagnostics.extend(diagnostics);
    }

    fn finish(mut self, entries: &[Entry]) -> Compiled {
        once_each(&mut self.compiled.diagnostics);
        let mut text = String::new();
        for (_, file) in self.compiled.sources.iter().take(1) {
            listing::source(&mut text, file);
        }
        listing::printed(&mut text, entries);
        listing::clprnt(&mut text, self.compiled.parts.iter().map(|p| p.edited.as_slice()));
        listing::messages(&mut text, &self.compiled.diagnostics, &self.compiled.sources);
        self.compiled.listing = text;
        self.compiled
    }
}

/// A statement in a loop or macro that fails in the same way each time is told of once.
fn once_each(diagnostics: &mut Vec<Diagnostic>) {
    let mut told = BTreeSet::new();
    diagnostics.retain(|d| told.insert((d.code, d.span, d.message.clone())));
}

/// Section 1's way to files.
struct Includes<'w>(&'w mut dyn World);

impl Files for Includes<'_> {
    fn read(&mut self, request: &FileRequest) -> Result<LoadedFile, FileError> {
        let found = self.0.include(&request.name);
        found.map(|s| LoadedFile { name: s.name, text: s.text }).map_err(|e| {
            let help = match &e {
                WorldError::Missing { .. } => Some("name its folder with --include".to_owned()),
                WorldError::Outside => Some(
                    "allow its folder with --include, or copy the file beside the program"
                        .to_owned(),
                ),
                _ => None,
            };
            let code = match &e {
                WorldError::Outside => codes::OUTSIDE_FOLDERS,
                WorldError::TooLarge { .. } => codes::FILE_TOO_LARGE,
                _ => codes::UNREADABLE_FILE,
            };
            FileError { code, message: format!("cannot read {}: {e}", request.name), help }
        })
    }
}
