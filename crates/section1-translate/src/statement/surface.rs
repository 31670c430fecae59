//! PSIS: the part surface.

use aptc_protap::Kind;
use aptc_syntax::tree::Clause;
use aptc_vocabulary::word;

use super::reader::Reader;
use crate::Interpreter;
use crate::eval::{Known, Names};

impl Interpreter<'_> {
    /// PSIS/surface.
    pub(super) fn part_surface(&mut self, clause: &Clause) -> Known<()> {
        let args = self.args(clause, Names::Defined)?;
        let mut reader = Reader::new(word::PSIS, clause, &args);
        let surface = self.surface(&mut reader, "a surface")?;
        self.at_end(&reader)?;
        self.emit(Kind::PartSurface(surface));
        Ok(())
    }
}
