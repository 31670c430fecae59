//! The commands, one file each.

mod check;
mod compile;
mod machines;
mod post;

pub(crate) use check::check;
pub(crate) use compile::compile;
pub(crate) use machines::machines;
pub(crate) use post::post;
