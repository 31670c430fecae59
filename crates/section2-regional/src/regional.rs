//! The dispatcher of regional milling.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_contact::PatchTree;
use aptc_diagnostics::Diagnostic;
use aptc_geometry::surface::ParametricSurface;
use aptc_geometry::{Form, Profile, Sculptured, Shell, Vec3};
use aptc_protap::{CutVectors, Kind, Record, ToolAxis};

use crate::area::Areas;
use crate::avoid::Avoid;
use crate::crew::{Alone, Crew};
use crate::cut_vectors::Recording;
use crate::drive::Course;
use crate::failure::Failure;
use crate::gclear::{Clears, post_arg};
use crate::guard::Checked;
use crate::outline::Outlines;
use crate::plain::Plain;
use crate::settings::Settings;
use crate::tlproj::Projecting;
use crate::watch::Watch;

/// Where the tool stands after a statement of regional milling.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stand {
    /// Tool end.
    pub te: Vec3,
    /// Unit tool axis.
    pub ta: Vec3,
    /// The last cut vector; zero when there was none.
    pub along: Vec3,
}

/// Regional milling: takes all PROTAP records in order, keeps the modal words, and mills at SMIL.
///
/// ```
/// use aptc_protap::{Arg, Kind, Record};
/// use aptc_regional::Regional;
/// let mut regional = Regional::default();
/// let args = vec![Arg::Word("INIT".into()), Arg::Word("ALL".into())];
/// let kind = Kind::Regional { word: "SCON".into(), args };
/// let stand = regional.execute(&Record { origin: Default::default(), kind }, &mut Vec::new());
/// assert!(stand.is_ok_and(|s| s.is_none()));
/// ```
#[derive(Debug, Default)]
pub struct Regional {
    pub(crate) settings: Settings,
    pub(crate) areas: Areas,
    pub(crate) fitted: Vec<(Arc<Form>, Arc<Sculptured>)>,
    /// Those that cannot be fitted, curves too.
    pub(crate) unfit: Vec<Arc<Form>>,
    /// Surfaces with what they are where their loose patches are one grid.
    pub(crate) wholes: Vec<(Arc<Sculptured>, Arc<Sculptured>)>,
    /// Surfaces prepared for questions.
    pub(crate) trees: Vec<(Arc<Sculptured>, Arc<PatchTree>)>,
    /// Surfaces prepared for the places nearest to points.
    pub(crate) feet: Vec<(Arc<Sculptured>, Arc<ParametricSurface>)>,
    /// Where the tool stands, if that is known.
    pub(crate) stand: Option<Stand>,
    /// Where the last motion ended that was put out: from there the tool comes to the next statement.
    pub(crate) came: Option<(Vec3, Vec3)>,
    /// HOLDER: solids with their height above the tool end.
    pub(crate) holder: Vec<(Profile, f64)>,
    /// What was told of words that have no effect.
    pub(crate) told_unused: Vec<String>,
    /// PRINT/AVPRT.
    pub(crate) report: bool,
    /// CHKSRF in ordinary motion.
    pub(crate) watch: Watch,
    /// The line of the last GOLOFT: surface, running parameter, value of the other.
    pub(crate) line: Option<(Arc<Form>, Course, f64)>,
    /// GCLEAR.
    pub(crate) clears: Clears,
    /// Is it told, since REGION was given, that a line goes straight through what it leaves out?
    pub(crate) told_over: bool,
    /// The last FEDRAT before the statement.
    pub(crate) feed: Vec<cl::Arg>,
    /// CHKSRF/PS.
    pub(crate) check_part: bool,
    /// Did the last CHKSRF fail?
    pub(crate) check_failed: bool,
    /// CHKSRF/name.
    pub(crate) checked: Vec<Checked>,
    /// What triangles bound that were checked.
    pub(crate) bodies: Vec<(Arc<Sculptured>, Option<Arc<Shell>>)>,
    /// Those of them that are not sculptured.
    pub(crate) plain: Vec<Plain>,
    /// AVCTRL.
    pub(crate) avoid: Avoid,
    /// REGION.
    pub(crate) outlines: Outlines,
    /// TLPROJ.
    pub(crate) projecting: Option<Projecting>,
    /// The open section of CLDAT.
    pub(crate) recording: Option<Recording>,
    /// Numbers of sections that CLDAT refused, which was told.
    pub(crate) refused: Vec<f64>,
    /// Cut vectors that the program may ask for.
    pub(crate) saved: Vec<CutVectors>,
    /// Lines that PLOTFT has drawn.
    pub(crate) drawn: Vec<Vec<Vec3>>,
    pub(crate) diagnostics: Vec<Diagnostic>,
}

/// A statement failed, and a diagnostic says why; where the tool stands is unknown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Failed;

impl Regional {
    /// Executes one record: modal words are kept, regional statements done, others passed by. What it
    /// gives is appended to `out`; where the tool moved, its place comes back.
    ///
    /// # Errors
    /// The statement failed; see [`Regional::take_diagnostics`].
    pub fn execute(
        &mut self,
        record: &Record,
        out: &mut Vec<cl::Record>,
    ) -> Result<Option<Stand>, Failed> {
        self.execute_by(record, &Alone, out)
    }

    /// Where the tool stands after a motion of the arithmetic element; `None` when that is unknown.
    pub fn stood(&mut self, stand: Option<Stand>) {
        match stand {
            Some(_) => self.stand = stand,
            None => self.lose(),
        }
    }

    /// A statement failed: from where the tool comes to the next one is unknown.
    fn lose(&mut self) {
        (self.stand, self.watch.last) = (None, None);
    }

    /// As [`Regional::execute`], the passes of a region milled by a crew. The result is the same, bit by bit.
    ///
    /// # Errors
    /// The statement failed; see [`Regional::take_diagnostics`].
    pub fn execute_by(
        &mut self,
        record: &Record,
        crew: &dyn Crew,
        out: &mut Vec<cl::Record>,
    ) -> Result<Option<Stand>, Failed> {
        let Kind::Regional { word, args } = &record.kind else {
            self.settings.observe(&record.kind);
            self.follow(&record.kind);
            return Ok(None);
        };
        let known = out.len();
        let done = match word.as_str() {
            "SCON" => self.scon(&record.origin, args).map(|()| None),
            "SMIL" => self.smil(&record.origin, args, crew, out),
            "CHKSRF" => self.chksrf(args).map(|()| None),
            "AVCTRL" => self.avctrl(args).map(|()| None),
            "GOLOFT" => self.goloft(&record.origin, args, out),
            "PLOTFT" => self.plotft(args).map(|()| None),
            "CLDAT" => self.cldat(args, out).map(|()| None),
            "REGION" => self.region(args).map(|()| None),
            "TLPROJ" => self.tlproj(args),
            "INTSEC" => self.intsec(&record.origin, args, out).map(|()| None),
            "GOMILL" => self.gomill(&record.origin, args, crew, out),
            "GCLEAR" => self.gclear(args).map(|()| None),
            "HOLDER" => self.holder(args).map(|()| None),
            "PRINT" => {
                self.print(args);
                Ok(None)
            }
            _ => Ok(None),
        };
        let done = done.and_then(|stand| {
            let way = self.comes_to(out.get(known..).unwrap_or_default());
            way.map(|()| stand).inspect_err(|_| out.truncate(known))
        });
        self.went(out.get(known..).unwrap_or_default());
        if word == "CHKSRF" {
            self.check_failed = done.is_err();
        }
        match &done {
            Ok(Some(stand)) => self.stand = Some(*stand),
            Ok(None) => {}
            Err(_) => self.lose(),
        }
        done.map_err(|failure| {
            let told = &mut self.settings.told_no_cutter;
            let failure = match self.areas.once(failure) {
                Failure::NoCutter if std::mem::replace(told, true) => Failure::Told,
                failure => failure,
            };
            self.diagnostics.extend(failure.explain(&record.origin));
            Failed
        })
    }

    /// Keeps where the tool stands, as far as a record says it, and the feed.
    fn follow(&mut self, kind: &Kind) {
        match kind {
            // A projected position was followed already.
            Kind::Goto(_) if self.projecting.is_some() => {}
            Kind::From(p) | Kind::Goto(p) => {
                let ta = p.axis.or(self.stand.map(|s| s.ta)).unwrap_or_else(Vec3::z);
                self.stand = Some(Stand { te: p.point, ta, along: Vec3::zeros() });
            }
            Kind::ToolAxis(ToolAxis::Fixed(v)) => {
                if let (Some(stand), Some(ta)) = (&mut self.stand, v.try_normalize(0.0)) {
                    stand.ta = ta;
                }
            }
            Kind::Post { word, args } if word == "FEDRAT" => {
                self.feed = args.iter().filter_map(post_arg).collect();
            }
            _ => {}
        }
    }

    /// The diagnostics since the last call.
    pub fn take_diagnostics(&mut self) -> Vec<Diagnostic> {
        std::mem::take(&mut self.diagnostics)
    }
}
