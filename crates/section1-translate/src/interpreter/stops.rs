//! Ends of a program before its end.

use aptc_diagnostics::{Code, Diagnostic, codes};
use aptc_protap::Kind;

use super::Interpreter;
use crate::listing::EntryKind;

impl Interpreter<'_> {
    /// Ends the program before its end with a message about the statement that was to come.
    pub fn stop(&mut self, code: Code, why: String, help: &str) {
        if self.levels.is_empty() {
            return;
        }
        self.queue.clear();
        self.error(Diagnostic::error(code, self.here.span, why).help(help));
        self.levels.clear();
        self.emit(Kind::Fini);
    }

    /// Ends it at the limit of statements.
    pub(super) fn out_of_statements(&mut self) {
        let n = self.options.limits.statements;
        self.error(
            Diagnostic::error(
                codes::TOO_MANY_STATEMENTS,
                self.here.span,
                format!("the program stops here after {n} executed statements"),
            )
            .label("a loop that does not end?")
            .help("check what ends the loop; the limit is a setting"),
        );
        self.levels.clear();
        self.emit(Kind::Fini);
    }

    /// A loop whose end an error has taken away is not a second mistake: the listing says that the search for
    /// more ends here.
    pub(super) fn stopped_after_error(&mut self, n: u64) {
        let line = self.sources.line_column(self.here.span.file, self.here.span.start).0;
        let remark = format!("stopped at line {line}, {n} statements after the first error");
        self.list(EntryKind::Remark(remark));
        self.levels.clear();
        self.emit(Kind::Fini);
    }

    /// Ends it in a loop that changes nothing.
    pub(super) fn endless(&mut self) {
        let what = "this loop never ends: from one pass to the next no value changes";
        self.error(
            Diagnostic::error(codes::ENDLESS_LOOP, self.here.span, what)
                .help("change what the IF asks for within the loop"),
        );
        self.levels.clear();
        self.emit(Kind::Fini);
    }
}
