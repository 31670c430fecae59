//! Section 0: conducts the Sections over a [`World`]; the face of the library.

mod artifact;
mod axis;
mod cl_edit;
mod compile;
mod edit;
mod file_kind;
mod geometry_json;
mod hands;
mod listing;
mod options;
mod post;
mod post_cl;
mod proof;
mod records;
mod summary;
mod text;
mod threads;
mod tools;
mod verify;
mod verify_code;
mod world;

pub use aptc_post::{Machine, NcReader, Proof, machine_file, machine_for, machines};
pub use aptc_translate::{Language, UnknownWords, about, near_word};
pub use aptc_verify::Certificate;
pub use artifact::{Artifact, ArtifactFile};
pub use cl_edit::edit_cl;
pub use compile::{Compiled, Part, compile, resume};
pub use file_kind::FileKind;
pub use geometry_json::{Named, geometry_json};
pub use options::{CodeOptions, FULL_PROOF, MachineChoice, Options, Verify};
pub use post::Nc;
pub use post_cl::{ClOptions, PostedCl, find_places, post_cl};
pub use records::Records;
pub use summary::Summary;
pub use text::Text;
pub use threads::Passes;
pub use verify::{ClFile, verify};
pub use verify_code::verify_code;
pub use world::{Disk, Memory, Source, World, WorldError};

pub use aptc_cldata::{
    CatiaWriter, ClfileWriter, Decimals, Dialect, JsonWriter, Reader, Record, RecordReader,
    RecordWriter, TapeWriter, TextOptions, TextWriter, copy, detect as dialect_of, diff, stats,
};
pub use aptc_syntax::{FormatOptions, format};
pub use aptc_vocabulary::Dialect as Codes;
