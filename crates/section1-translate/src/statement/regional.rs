//! Regional milling and its checks: handed on as they stand.

use aptc_protap::Kind;
use aptc_syntax::tree::Clause;
use aptc_vocabulary::Word;

use crate::Interpreter;
use crate::eval::{Known, Names};

impl Interpreter<'_> {
    /// SCON, SMIL, GOLOFT and their kin.
    pub(super) fn regional(&mut self, word: Word, clause: &Clause) -> Known<()> {
        let args = self.args(clause, Names::Defined)?;
        let args = self.handed_on(args)?;
        self.emit(Kind::Regional { word: word.text().into(), args });
        Ok(())
    }
}
