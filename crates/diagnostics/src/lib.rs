//! Diagnostics as data.
//!
//! A Section that finds fault with the user's program pushes a [`Diagnostic`] and goes on; nothing
//! here draws, prints or stops. The code of every message stands in the registry ([`codes`]) and has
//! a page in `docs/errors`.
//!
//! ```
//! use aptc_diagnostics::{Diagnostic, FileId, Span, codes};
//! let span = Span::new(FileId(0), 10, 12);
//! let d = Diagnostic::error(codes::UNREADABLE_FILE, span, "cannot read part.apt")
//!     .help("check the name and the folder");
//! assert_eq!(d.code.to_string(), "APT0001");
//! ```

pub mod codes;
mod diagnostic;
mod origin;
mod source_map;
mod span;

pub use codes::Code;
pub use diagnostic::{Diagnostic, Label, Severity};
pub use origin::{Frame, FrameKind, Origin, Trace};
pub use source_map::{FileId, SourceFile, SourceMap};
pub use span::Span;
