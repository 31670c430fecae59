//! The table of words.

use crate::args::Statement;
use crate::words::{Action, coolnt, cutcom, cycle, fedrat, planes, program, spindl, tool};

/// What becomes of a word.
pub(crate) enum Entry {
    /// It is done.
    Do(Action),
    /// It has no effect on this text, and the user is told why.
    Ignore(&'static str),
    /// It has no effect on any text and needs no telling.
    Silent(&'static str),
    /// No machine here has it.
    Refuse(&'static str),
}

use Entry::{Do, Ignore, Refuse, Silent};

/// How the post-processor treats a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Treatment {
    /// Carried out, or refused where the machine lacks it.
    Done,
    /// Left out, for this reason.
    Ignored(&'static str),
    /// Refused, for this reason.
    Refused(&'static str),
}

/// How the post-processor treats a word; `None` for one it does not know.
pub fn treatment(word: &str) -> Option<Treatment> {
    action(word).map(|e| match e {
        Do(_) => Treatment::Done,
        Ignore(why) | Silent(why) => Treatment::Ignored(why),
        Refuse(why) => Treatment::Refused(why),
    })
}

pub(crate) fn action(word: &str) -> Option<&'static Entry> {
    TABLE.binary_search_by(|(w, _)| (*w).cmp(word)).ok().map(|i| &TABLE[i].1)
}

const DRAWN: &str = "it is for a plotter";
const SHOWN: &str = "it is for the screen of a CAM system";
const TAPE: &str = "there is no tape";
const LISTED: &str = "it is for the listing of another post-processor";

fn nothing(_: &mut crate::post::Post, _: &Statement<'_>) {}

/// Sorted by word.
static TABLE: &[(&str, Entry)] = &[
    ("AIR", Do(coolnt::air)),
    ("AUXFUN", Do(program::auxfun)),
    ("BREAK", Ignore(TAPE)),
    ("CAMERA", Silent(SHOWN)),
    ("CLEARP", Do(planes::clearp)),
    ("CLRSRF", Do(planes::clrsrf)),
    ("COOLNT", Do(coolnt::coolnt)),
    ("CUTCOM", Do(cutcom::cutcom)),
    ("CYCLE", Do(cycle::cycle)),
    ("DELAY", Do(program::delay)),
    ("DELETE", Do(program::opskip)),
    ("DISPLY", Do(program::disply)),
    ("DRAFT", Silent(DRAWN)),
    ("DWELL", Do(program::delay)),
    ("END", Do(program::end)),
    ("FEDRAT", Do(fedrat::fedrat)),
    ("GOHOME", Do(planes::gohome)),
    ("HEAD", Refuse("no machine here has several heads")),
    ("INSERT", Do(program::insert_word)),
    ("LEADER", Ignore(TAPE)),
    ("LETTER", Silent(DRAWN)),
    ("LINTOL", Do(program::lintol)),
    ("LOAD", Do(tool::load)),
    ("LOADTL", Do(tool::loadtl)),
    ("LPRINT", Silent(LISTED)),
    ("MACHIN", Do(nothing)),
    ("MCHTOL", Do(program::mchtol)),
    ("OPSKIP", Do(program::opskip)),
    ("OPSTOP", Do(program::opstop)),
    ("ORIGIN", Do(program::origin)),
    ("OVPLOT", Silent(DRAWN)),
    ("PAINT", Silent(SHOWN)),
    ("PARTNO", Do(program::partno)),
    ("PEN", Silent(DRAWN)),
    ("PENDWN", Silent(DRAWN)),
    ("PENUP", Silent(DRAWN)),
    ("PLABEL", Silent(DRAWN)),
    ("PLOT", Silent(DRAWN)),
    ("PPLOT", Silent(DRAWN)),
    ("PPRINT", Do(program::pprint)),
    ("PREFUN", Do(program::prefun)),
    ("RAPID", Do(fedrat::rapid)),
    ("RETRCT", Do(planes::retrct)),
    ("REWIND", Do(program::rewind)),
    ("SELCTL", Do(tool::selctl)),
    ("SELECT", Do(tool::select)),
    ("SEQNO", Do(program::seqno)),
    ("SPINDL", Do(spindl::spindl)),
    ("STOP", Do(program::stop)),
    ("TMARK", Ignore(TAPE)),
    ("TOOLNO", Do(tool::toolno)),
    ("TRANS", Do(program::trans)),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sorted() {
        for w in TABLE.windows(2) {
            assert!(w[0].0 < w[1].0, "{} before {}", w[0].0, w[1].0);
        }
    }
}
