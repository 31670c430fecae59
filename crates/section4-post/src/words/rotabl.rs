//! ROTABL and ROTHED: turning of a table or head apart from the tool axes of the CL data.

use aptc_diagnostics::codes;

use crate::args::Statement;
use crate::index::wanted;
use crate::post::Post;
use crate::words::refuse;

/// Angles below this are no turning, degrees.
const NOTHING: f64 = 1e-6;

/// `ROTABL/[AXIS,n,]ATANGL|INCR,a[,CLW|CCLW]`, `ROTHED` likewise: the axis turns with the tool retracted, and
/// what follows is programmed at the turned table. Under MULTAX the tool axes of the CL data turn the axes.
pub(super) fn rotabl(post: &mut Post, s: &Statement<'_>) {
    let nothing = s.first_number().is_some_and(|a| a.abs() < NOTHING) && s.word(0).is_none();
    if post.machine.rotary.is_empty() && s.after(&["ATANGL", "INCR"]).is_some_and(|a| a == 0.0)
        || nothing
        || post.st.multax && s.after(&["ATANGL", "INCR"]).is_some_and(|a| a == 0.0)
    {
        let message = format!("{} is left out: it turns nothing", s.written());
        post.note(codes::WORD_IGNORED, s.origin, message, "");
        return;
    }
    if post.machine.rotary.is_empty() {
        refuse(post, s, "the machine has no rotary axis");
        return;
    }
    if post.st.multax {
        refuse(
            post,
            s,
            "under MULTAX rotary axes follow the tool axes; write MULTAX/OFF before it",
        );
        return;
    }
    match wanted(s, &post.machine, post.st.angles) {
        Ok(wanted) => post.index_to(&wanted, s),
        Err(reason) => refuse(post, s, &reason),
    }
}
