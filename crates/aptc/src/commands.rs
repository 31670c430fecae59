//! The commands.

mod check;
mod cl;
mod compile;
mod fmt;
mod install;
mod machines;
mod post;
mod test;
mod verify;

pub(crate) use check::check;
pub(crate) use cl::{cldiff, convert, stats};
pub(crate) use compile::compile;
pub(crate) use fmt::fmt;
pub(crate) use install::{completions, man};
pub(crate) use machines::machines;
pub(crate) use post::post;
pub(crate) use test::test;
pub(crate) use verify::verify;
