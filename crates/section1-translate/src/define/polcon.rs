//! POLCON has no format but CANON, see [`super::canonical`].

use super::format::Format;

pub(super) const FORMATS: &[Format] = &[];
