//! Tests of the crate through its public face.

mod corpus;
mod format;
mod lexical;
mod messages;
mod robust;
mod show;
mod statements;
