//! What was changed since the tool came to its surfaces, and where it no longer is for that reason.

use crate::arelem::Arelem;
use crate::failure::Failure;

/// Lines of statements since the last motion along surfaces.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Since {
    /// CUTTER with another cutter.
    pub(crate) cutter: Option<u32>,
    /// THICK with other thicknesses.
    pub(crate) thick: Option<u32>,
}

impl Arelem {
    /// Why a tool that a motion brought to its surfaces is not at them, where something was changed since.
    pub(crate) fn changed_since(&self, failure: &Failure) -> Vec<String> {
        let off = matches!(failure, Failure::OffDrive { .. } | Failure::OffPart { .. });
        let Some((_, cutter)) = self.ended.as_ref().filter(|_| off) else { return Vec::new() };
        let Since { cutter: changed, thick } = self.since;
        let changed = changed.filter(|_| *cutter != self.settings.cutter);
        let told = |(word, line)| {
            format!(
                "{word} was changed in line {line}, since the motion that brought the tool there"
            )
        };
        let all = [changed.map(|line| ("CUTTER", line)), thick.map(|line| ("THICK", line))];
        all.into_iter().flatten().map(told).collect()
    }
}
