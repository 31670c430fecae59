//! THREAD: cuts that go with the turning of the spindle.

use crate::args::Statement;
use crate::post::Post;
use crate::words::{bad_arguments, refuse};

/// `THREAD/[TURN,][LEAD,]k` sets the lead; all cuts up to `THREAD/OFF` are passes of the thread. RAPID motions
/// between them are not.
pub(super) fn thread(post: &mut Post, s: &Statement<'_>) {
    if s.word(0) == Some("OFF") {
        post.st.thread = None;
        return;
    }
    if post.machine.turning.thread.is_empty() {
        refuse(post, s, "the machine cuts no threads with a single point");
        return;
    }
    let said = ["TURN", "LEAD"].into_iter().filter(|word| s.has(word)).count();
    let others = s.args.len() > 1 + said;
    match s.first_number().filter(|k| *k > 0.0 && k.is_finite()) {
        Some(_) if others => refuse(post, s, "only threads of one constant lead are cut here"),
        Some(lead) => post.st.thread = Some(lead * post.st.scale),
        None => bad_arguments(post, s, "THREAD/k with the lead, or THREAD/OFF"),
    }
}
