//! FEDRAT and RAPID.

use aptc_cldata::Arg;
use aptc_diagnostics::codes;

use aptc_geometry::Units;

use crate::args::Statement;
use crate::machine::MachineKind;
use crate::post::Post;
use crate::state::{FeedUnit, Feedrate};
use crate::words::{bad_arguments, refuse};

/// Unit of a feed by its word.
pub(super) fn unit(word: &str) -> Option<FeedUnit> {
    Some(match word {
        "PERMIN" | "UPM" => FeedUnit::PerMinute,
        "PERREV" | "UPR" => FeedUnit::PerRevolution,
        "IPM" => FeedUnit::InchPerMinute,
        "IPR" => FeedUnit::InchPerRevolution,
        "MMPM" => FeedUnit::MmPerMinute,
        "MMPR" => FeedUnit::MmPerRevolution,
        _ => return None,
    })
}

/// `FEDRAT/f`, with a unit before or after the value; `FEDRAT/INVERS,AUTO|ON|OFF`; the slow-down
/// options of the arithmetic element are taken as given.
pub(super) fn fedrat(post: &mut Post, s: &Statement<'_>) {
    if s.word(0) == Some("INVERS") {
        inverse(post, s);
        return;
    }
    let mut value = None;
    let mut found = None;
    let mut args = s.args.iter();
    while let Some(arg) = args.next() {
        match arg {
            Arg::Number(n) => value = value.or(Some(*n)),
            Arg::Word(w) => match w.as_str() {
                "AUTO" | "STEP" | "NOW" | "NEXT" => {}
                "MAXIPM" => {
                    let _taken = args.next();
                    let message = format!("{}: the feed is not bounded by MAXIPM", s.written());
                    post.note(codes::WORD_IGNORED, s.origin, message, "");
                }
                "LOCK" => {
                    let message =
                        format!("{}: the feed override of the operator is not locked", s.written());
                    post.note(codes::WORD_IGNORED, s.origin, message, "");
                    return;
                }
                w => match unit(w) {
                    Some(u) if found.is_some_and(|f| f != u) => {
                        bad_arguments(post, s, "FEDRAT/f with one unit");
                        return;
                    }
                    Some(u) => found = Some(u),
                    None => {
                        bad_arguments(
                            post,
                            s,
                            "FEDRAT/f with IPM, IPR, MMPM, MMPR, PERMIN or PERREV",
                        );
                        return;
                    }
                },
            },
            _ => {}
        }
    }
    let Some(value) = value else {
        if found.is_none() {
            bad_arguments(post, s, "FEDRAT/f");
        }
        return;
    };
    if !(value > 0.0 && value.is_finite()) {
        let message = format!("{}: such a feed does not cut", s.written());
        post.error(codes::POST_ARGUMENTS, s.origin, message, "write FEDRAT/f with a positive feed");
        return;
    }
    if found.is_none() {
        doubt(post, s, value);
    }
    post.st.feed = Some(Feedrate { value, unit: found.unwrap_or(FeedUnit::PerMinute) });
    post.st.feed_word = None;
}

/// Says once that a feed without a unit is one a minute, where it is so small that one a turn is meant.
fn doubt(post: &mut Post, s: &Statement<'_>, value: f64) {
    /// Millimetres a minute below which nobody turns, or mills.
    const LEAST: [f64; 2] = [5.0, 1.0];
    let mills = post.machine.kind == MachineKind::Mill || post.machine.is_milling();
    let unit = if post.st.units == Units::Inches { ["IPR", "IPM"] } else { ["MMPR", "MMPM"] };
    if value * post.st.units.mm() >= LEAST[usize::from(mills)]
        || std::mem::replace(&mut post.st.feed_doubted, true)
    {
        return;
    }
    let message = format!("{} without a unit is a feed a minute", s.written());
    let help = format!(
        "write FEDRAT/{value},{} where a feed a turn is meant, or {} where not",
        unit[0], unit[1]
    );
    post.warn(codes::DOUBTFUL_FEED, s.origin, message, &help);
}

fn inverse(post: &mut Post, s: &Statement<'_>) {
    if s.has("OFF") {
        post.st.inverse = false;
    } else if post.machine.feed.inverse_time.is_empty() {
        refuse(post, s, "the machine has no inverse-time feed");
        return;
    } else {
        post.st.inverse = true;
    }
    if let Some(value) = s.first_number() {
        post.st.feed = Some(Feedrate { value, unit: FeedUnit::PerMinute });
        post.st.feed_word = None;
    }
}

/// RAPID: the next motion only.
pub(super) fn rapid(post: &mut Post, s: &Statement<'_>) {
    if !s.args.is_empty() {
        bad_arguments(post, s, "RAPID, and where to go in the statement behind it: GOTO/x,y,z");
        return;
    }
    post.st.rapid = true;
}
