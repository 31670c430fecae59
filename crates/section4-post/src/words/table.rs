//! The table of words.

use crate::args::Statement;
use crate::words::{
    Action, arcslp, coolnt, cutcom, cycle, fedrat, planes, program, rotabl, spindl, stock, thread,
    tool,
};

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
const EDITED: &str = "it was carried out before: the path that follows has it";
const TAPE: &str = "there is no tape";
const NAMED: &str = "it names a part of the work";
const TOOL: &str = "it describes the tool";
const LISTED: &str = "it is for the listing of another post-processor";

fn nothing(_: &mut crate::post::Post, _: &Statement<'_>) {}

/// Sorted by word.
static TABLE: &[(&str, Entry)] = &[
    ("AIR", Do(coolnt::air)),
    ("ARCSLP", Do(arcslp::arcslp)),
    ("AUXFUN", Do(program::auxfun)),
    ("BREAK", Ignore(TAPE)),
    ("CALSUB", Do(program::calsub)),
    ("CAMERA", Silent(SHOWN)),
    ("CATPROCESS", Silent(NAMED)),
    ("CATPRODUCT", Silent(NAMED)),
    ("CHANNEL", Do(program::channel)),
    ("CHECK", Ignore("limits stand in the machine file")),
    ("CLAMP", Ignore("the machine file says what holds a rotary axis")),
    ("CLEARP", Do(planes::clearp)),
    ("CLRSRF", Do(planes::clrsrf)),
    ("COOLNT", Do(coolnt::coolnt)),
    ("COUPLE", Refuse("no machine here couples an axis to the spindle")),
    ("CSI_SET_EXTENSION_LENGTH", Silent(TOOL)),
    ("CSI_SET_FLUTE_LENGTH", Silent(TOOL)),
    ("CSI_TOOL_PATH", Silent(NAMED)),
    ("CUTCOM", Do(cutcom::cutcom)),
    ("CYCLE", Do(cycle::cycle)),
    ("DELAY", Do(program::delay)),
    ("DELETE", Do(program::opskip)),
    ("DISPLY", Do(program::disply)),
    ("DRAFT", Silent(DRAWN)),
    ("DRAWLI", Silent(DRAWN)),
    ("DRESS", Refuse("no machine here dresses a wheel")),
    ("DWELL", Do(program::delay)),
    ("END", Do(program::end)),
    ("FACEML", Refuse("no machine here has a milling cycle for faces")),
    ("FEDRAT", Do(fedrat::fedrat)),
    ("GOCLER", Do(planes::retrct)),
    ("GOHOME", Do(planes::gohome)),
    ("HEAD", Refuse("no machine here has several heads")),
    ("INSERT", Do(program::insert_word)),
    ("INTCOD", Refuse("no machine here has interpolation codes of its own")),
    ("ISTOP", Do(program::stop)),
    ("LEADER", Ignore(TAPE)),
    ("LETTER", Silent(DRAWN)),
    ("LINTOL", Do(program::lintol)),
    ("LOAD", Do(tool::load)),
    ("LOADTL", Do(tool::loadtl)),
    ("LOCKX", Refuse("no machine here locks axes")),
    ("LPRINT", Silent(LISTED)),
    ("MACHIN", Do(nothing)),
    ("MAXDPM", Ignore("the machine file has the speed of rotary axes")),
    ("MCHTOL", Do(program::mchtol)),
    ("MCSYS", Do(program::ofstno)),
    ("MODE", Do(program::mode)),
    ("MOVE_ATTRIB", Silent("it marks lead-in and lead-out")),
    ("OFSTNO", Do(program::ofstno)),
    ("OPFEATEND", Silent(NAMED)),
    ("OPFEATSTART", Silent(NAMED)),
    ("OPNAME", Silent(NAMED)),
    ("OPSKIP", Do(program::opskip)),
    ("OPSTOP", Do(program::opstop)),
    ("OP_NAME", Silent(NAMED)),
    ("ORIGIN", Do(program::origin)),
    ("OVPLOT", Silent(DRAWN)),
    ("PAINT", Silent(SHOWN)),
    ("PARTNO", Do(program::partno)),
    ("PART_OPE", Silent(NAMED)),
    ("PEN", Silent(DRAWN)),
    ("PENDWN", Silent(DRAWN)),
    ("PENUP", Silent(DRAWN)),
    ("PICKUP", Refuse("no machine here picks up parts")),
    ("PIVOTZ", Ignore("the machine file says where rotary axes turn")),
    ("PLABEL", Silent(DRAWN)),
    ("PLOT", Silent(DRAWN)),
    ("PLUNGE", Refuse("write the motion itself: GODLTA or CYCLE")),
    ("POSTN", Refuse("write the motion itself: GOTO with a tool axis")),
    ("PPFUN", Ignore("it is for another post-processor")),
    ("PPLOT", Silent(DRAWN)),
    ("PPRINT", Do(program::pprint)),
    ("PREFUN", Do(program::prefun)),
    ("PROBX", Refuse("no machine here probes")),
    ("PROBY", Refuse("no machine here probes")),
    ("PROGRAM", Silent(NAMED)),
    ("RAPID", Do(fedrat::rapid)),
    ("RESET", Refuse("axes are not reset; ORIGIN and TRANS move the part")),
    ("RETRCT", Do(planes::retrct)),
    ("REVERS", Refuse("nothing is mirrored here; TRACUT mirrors a path")),
    ("REWIND", Do(program::rewind)),
    ("ROTABL", Do(rotabl::rotabl)),
    ("ROTHED", Do(rotabl::rotabl)),
    ("SAFETY", Ignore("CLRSRF is the clearance plane")),
    ("SELCTL", Do(tool::selctl)),
    ("SELECT", Do(tool::select)),
    ("SEQNO", Do(program::seqno)),
    ("SETUP", Silent("the coordinate system of a setup comes with CSYS")),
    ("SLOWDN", Ignore("the control slows down by itself")),
    ("SPINDL", Do(spindl::spindl)),
    ("STOCK", Do(stock::stock)),
    ("STOP", Do(program::stop)),
    ("SWITCH", Ignore("the offset number comes from LOADTL or TURRET")),
    ("SYN", Ignore("it is for another post-processor")),
    ("TDATA", Ignore("tool data come with CUTTER")),
    ("THREAD", Do(thread::thread)),
    ("TMARK", Ignore(TAPE)),
    ("TOOLNO", Do(tool::toolno)),
    ("TPRINT", Do(tool::tprint)),
    ("TRANS", Do(program::trans)),
    ("TRNTYP", Silent("positions are taken as they stand")),
    ("TURRET", Do(tool::loadtl)),
    ("ULOCKX", Refuse("no machine here locks axes")),
    ("UNLOAD", Ignore("the next tool change takes the tool out")),
    ("VTLAXS", Silent(EDITED)),
    ("WCORN", Silent(EDITED)),
    ("ZERO", Refuse("axes are not set to zero; ORIGIN and TRANS move the part")),
];

#[cfg(test)]
mod tests {
    use super::*;

    /// The words of the IBM manual and of the posts whose CL files are read: none is unknown.
    const USUAL: &str = "END STOP OPSTOP ISTOP RAPID SWITCH RETRCT DRESS PICKUP UNLOAD PENUP PENDWN ZERO \
        GOHOME RESET PROBX PROBY ULOCKX LOCKX FACEML REWIND COOLNT SPINDL FEDRAT LOADTL SELCTL TOOLNO \
        CUTCOM CYCLE DELAY AUXFUN PREFUN CLEARP CLRSRF ROTABL ROTHED HEAD TURRET THREAD ARCSLP ORIGIN TRANS \
        SEQNO TMARK LEADER OPSKIP POSTN CHECK CLAMP LINTOL MODE SLOWDN COUPLE MAXDPM PIVOTZ PLUNGE SAFETY \
        REVERS AIR LETTER PPLOT MCHTOL INTCOD DISPLY PARTNO PPRINT INSERT GOCLER DRAWLI BREAK MACHIN TPRINT";

    #[test]
    fn no_usual_word_is_unknown() {
        let unknown: Vec<_> = USUAL.split_whitespace().filter(|w| treatment(w).is_none()).collect();
        assert!(unknown.is_empty(), "{unknown:?}");
    }

    #[test]
    fn sorted() {
        for w in TABLE.windows(2) {
            assert!(w[0].0 < w[1].0, "{} before {}", w[0].0, w[1].0);
        }
    }
}
