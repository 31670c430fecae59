//! The dispatcher of regional milling.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_diagnostics::Diagnostic;
use aptc_geometry::{Form, Sculptured, Vec3};
use aptc_protap::{Kind, Record};

use crate::area::Areas;
use crate::avoid::Avoid;
use crate::failure::Failure;
use crate::guard::Checked;
use crate::outline::Outlines;
use crate::settings::Settings;

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
    /// CHKSRF/PS.
    pub(crate) check_part: bool,
    /// CHKSRF/name.
    pub(crate) checked: Vec<Checked>,
    /// AVCTRL.
    pub(crate) avoid: Avoid,
    /// CLDAT and REGION.
    pub(crate) outlines: Outlines,
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
        let Kind::Regional { word, args } = &record.kind else {
            self.settings.observe(&record.kind);
            return Ok(None);
        };
        let done = match word.as_str() {
            "SCON" => self.scon(args).map(|()| None),
            "SMIL" => self.smil(&record.origin, args, out),
            "CHKSRF" => self.chksrf(args).map(|()| None),
            "AVCTRL" => self.avctrl(args).map(|()| None),
            "GOLOFT" => self.goloft(&record.origin, args, out),
            "CLDAT" => self.cldat(args, out).map(|()| None),
            "REGION" => self.region(args).map(|()| None),
            "GCLEAR" if !matches!(args.last(), Some(aptc_protap::Arg::Word(w)) if w == "OFF") => {
                Err(Failure::Undone { what: "GCLEAR" })
            }
            "GOMILL" => Err(Failure::Undone { what: "GOMILL" }),
            _ => Ok(None),
        };
        done.map_err(|failure| {
            self.diagnostics.push(failure.explain(&record.origin));
            Failed
        })
    }

    /// The diagnostics since the last call.
    pub fn take_diagnostics(&mut self) -> Vec<Diagnostic> {
        std::mem::take(&mut self.diagnostics)
    }
}
