//! Creo: comments that are data, `$$-> CUTTER / d` and `REMARK -> CUTTER / d`.

use super::args;
use super::state::State;
use super::words;

/// Takes the text of a comment in; false when it is an ordinary one.
pub(super) fn structured(state: &mut State, text: &[u8]) -> bool {
    let Some(body) = text.trim_ascii_start().strip_prefix(b"->") else { return false };
    let body = body.trim_ascii();
    let slash = memchr::memchr(b'/', body);
    let (head, rest) = slash.map_or((body, &b""[..]), |s| (&body[..s], &body[s + 1..]));
    match args::upper(head).as_str() {
        "CUTTER" | "CSYS" => {
            let statement = [args::upper(head).as_bytes(), b"/", rest].concat();
            words::statement(state, &statement);
            true
        }
        _ => false,
    }
}
