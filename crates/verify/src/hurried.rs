//! RAPID before a motion along surfaces: all of that motion is rapid, which few part programs mean.

use aptc_cldata::Control;
use aptc_diagnostics::{Diagnostic, Origin, codes};

use crate::judged::called;
use crate::milled::name_of;

/// A motion along surfaces after RAPID.
#[derive(Debug)]
pub(crate) struct Hurried {
    origin: Origin,
    vectors: usize,
    along: String,
    /// What the statement does at rapid: of regional milling its first path alone.
    what: &'static str,
}

impl Hurried {
    /// Of a motion with so many cut vectors along its surfaces; `None` where it has none.
    pub(crate) fn new(origin: &Origin, control: &Control, vectors: usize) -> Option<Self> {
        let drive = control.drive.iter().map(|c| called(c, "drive"));
        let part = control.part.iter().map(|c| called(c, "part"));
        let milled = control
            .milling
            .iter()
            .flat_map(|m| &m.part)
            .map(|m| format!("part surface {}", name_of(&m.name)));
        let along = drive.chain(part).chain(milled).collect::<Vec<_>>().join(" and ");
        let what = if control.milling.is_some() { "the first path" } else { "the next motion" };
        (vectors > 0).then(|| Self { origin: origin.clone(), vectors, along, what })
    }

    pub(crate) fn told(&self) -> Diagnostic {
        let along = if self.along.is_empty() { "surfaces" } else { &self.along };
        let vectors = match self.vectors {
            1 => "its cut vector goes".to_owned(),
            n => format!("its {n} cut vectors go"),
        };
        let message =
            format!("RAPID is for all of {}: {vectors} along {along} at rapid", self.what);
        let d = Diagnostic::warning(codes::RAPID_ALONG, self.origin.span, message);
        d.help("go above its beginning with RAPID and GOTO, and leave RAPID out before the motion itself")
            .within(self.origin.trace.clone())
    }
}
