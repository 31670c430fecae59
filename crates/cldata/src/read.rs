//! Readers of CL data: one scanner and one state under all text dialects, each dialect a small file.

mod arcs;
mod args;
mod catia;
mod comments;
mod couplets;
mod creo;
mod detect;
mod edit;
mod encoding;
mod fast;
mod fusion;
mod layout;
mod motion;
mod nested;
mod nx;
mod reader;
mod report;
mod scan;
pub mod source;
mod spline;
mod state;
mod text_reader;
mod tools;
mod words;

pub(crate) use arcs::sweep;
pub(crate) use comments::unit;
pub use detect::dialect as detect;
pub use reader::Reader;
pub use text_reader::TextReader;
