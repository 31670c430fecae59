//! ROTABL and ROTHED: turning of a table or head apart from the tool axes of the CL data.

use aptc_diagnostics::codes;

use crate::args::Statement;
use crate::post::Post;
use crate::words::refuse;

/// Angles below this are no turning, degrees.
const NOTHING: f64 = 1e-6;

/// `ROTABL/[ATANGL,]a[,..]`. Rotary axes are turned by the tool axes of the CL data alone, so that positions
/// and angles always agree; an angle of zero asks for nothing else.
pub(super) fn rotabl(post: &mut Post, s: &Statement<'_>) {
    if s.first_number().is_some_and(|a| a.abs() < NOTHING) {
        let message = format!("{} is left out: rotary axes follow the tool axes", s.written());
        post.note(codes::WORD_IGNORED, s.origin, message, "");
        return;
    }
    if post.machine.rotary.is_empty() {
        refuse(post, s, "the machine has no rotary axis");
    } else {
        refuse(
            post,
            s,
            "rotary axes follow the tool axes: give them with MULTAX and TLAXIS or GOTO",
        );
    }
}
