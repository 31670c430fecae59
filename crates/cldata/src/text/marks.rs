//! Words of the comments that carry meaning.

use crate::MotionKind;

/// First words that a plain comment may not have; the writer puts a full stop before it.
const RESERVED: [&str; 5] = ["LINE", "ISN", "PATH", "CIRCLE", "GEOMETRY"];

/// Would the text of a comment be taken for a mark?
pub(crate) fn is_reserved(comment: &str) -> bool {
    let text = comment.trim_start();
    let end = text.find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(text.len());
    text.starts_with('.') || RESERVED.iter().any(|r| text[..end].eq_ignore_ascii_case(r))
}

/// The word of `$$ PATH`.
pub(crate) const fn kind_word(kind: MotionKind) -> &'static str {
    match kind {
        MotionKind::From => "FROM",
        MotionKind::Goto => "GOTO",
        MotionKind::Startup => "STARTUP",
        MotionKind::Continuous => "CONTINUOUS",
    }
}
