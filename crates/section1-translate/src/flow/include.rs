//! Files that a program reads: READ/2, INCLUD, LIBRY; and READ/1, whose saved definitions are statements
//! in a file of their name, by CANON or otherwise, or as surfaces of another program.

use std::sync::Arc;

use aptc_diagnostics::{Diagnostic, Frame, FrameKind, Span, codes};
use aptc_syntax::Symbol;
use aptc_syntax::tree::{Body, Expr, ExprKind};

use crate::eval::{Known, Poisoned};
use crate::interpreter::MacroDef;
use crate::level::{Level, LevelKind};
use crate::program::{Plan, Role, Unit};
use crate::{Asker, FileRequest, Interpreter, LoadedFile};

impl Interpreter<'_> {
    /// READ/1,names, READ/2,name.
    pub(crate) fn read(&mut self, args: &[Expr]) {
        let kind = args.first().map(|a| &a.kind);
        #[expect(clippy::float_cmp, reason = "the digits 1 and 2 themselves")]
        let is = |n: f64| matches!(kind, Some(ExprKind::Number(x)) if *x == n);
        if is(2.0) {
            match &args[1..] {
                [name] => self.include(Asker::Segment, name),
                _ => self.bad_read("READ/2 reads one file", "write READ/2,name"),
            }
        } else if is(1.0) {
            if args.len() == 1 {
                let help =
                    "write READ/1,name; the definitions of a name stand in a file of that name";
                self.bad_read("READ/1 names no definitions", help);
                return;
            }
            // The file that is opened last is read first.
            for name in args[1..].iter().rev() {
                self.include(Asker::Geometry, name);
            }
        } else {
            self.bad_read("READ reads 1, saved definitions, or 2, statements", "write READ/2,name");
        }
    }

    fn bad_read(&mut self, message: &str, help: &str) {
        self.error(Diagnostic::error(codes::NOT_READ, self.here.span, message).help(help));
        (self.state.doubt.names, self.state.doubt.macros) = (true, true);
    }

    /// INCLUD/name, and the READ/2 of the same effect: the statements of a file stand here.
    pub(crate) fn include(&mut self, asker: Asker, name: &Expr) {
        let Some(file) = self.file_name(name) else {
            self.bad_read("a file name is expected", "write a name, or a path in quotes");
            return;
        };
        let limit = self.options.limits.include_depth;
        let depth = self.levels.last().map_or(0, |l| l.n_files);
        if depth >= limit {
            self.error(
                Diagnostic::error(
                    codes::TOO_MANY_FILES,
                    name.span,
                    format!("more than {limit} files read within each other"),
                )
                .help("does the file read itself? the limit is a setting"),
            );
            (self.state.doubt.names, self.state.doubt.macros) = (true, true);
            return;
        }
        let Ok(text) = self.fetch(asker, &file, name.span) else {
            (self.state.doubt.names, self.state.doubt.macros) = (true, true);
            self.fail();
            return;
        };
        if asker == Asker::Geometry && self.outside(name, &text) {
            return;
        }
        let (unit, plan) = self.open(&text);
        let frame = Frame {
            kind: FrameKind::Include,
            name: unit.name.as_deref().unwrap_or_default().into(),
            span: self.here.span,
            line: self.here.line,
            pass: 0,
            outer: self.trace(),
        };
        let range = (plan.start(), plan.end());
        let level = Level::new(unit, plan, range, LevelKind::File, Some(Arc::new(frame)));
        self.levels.push(level.inside(self.levels.last()));
    }

    /// LIBRY/names: system macros, each fetched with its first CALL.
    pub(crate) fn library(&mut self, args: &[Expr]) {
        for arg in args {
            match &arg.kind {
                ExprKind::Name(name) => {
                    self.libraries.insert(name.symbol, arg.span);
                }
                _ => self.error(
                    Diagnostic::error(codes::NOT_READ, arg.span, "LIBRY takes names of macros")
                        .help("write LIBRY/name,name"),
                ),
            }
        }
    }

    /// Fetches a macro that LIBRY named.
    pub(super) fn fetch_library(&mut self, symbol: Symbol) -> Known<()> {
        let Some(span) = self.libraries.remove(&symbol) else { return Ok(()) };
        let file: Arc<str> = self.interner.text(symbol).into();
        let text = self.fetch(Asker::Library, &file, span)?;
        let (unit, plan) = self.open(&text);
        let mut found = false;
        for (place, statement) in (0u32..).zip(&unit.program.statements) {
            if let (Body::Macro { name, .. }, Role::Macro(end)) =
                (&statement.body, plan.role(place))
            {
                found |= name.symbol == symbol;
                let (unit, plan) = (Arc::clone(&unit), Arc::clone(&plan));
                self.macros.entry(name.symbol).or_insert(MacroDef { unit, plan, place, end });
            }
        }
        if found {
            return Ok(());
        }
        let text = self.interner.text(symbol).to_owned();
        self.error(
            Diagnostic::error(
                codes::NOT_READ,
                span,
                format!("the file {} holds no macro {text}", unit.name.as_deref().unwrap_or("")),
            )
            .help("a file of the library holds the macro of its name"),
        );
        Err(Poisoned)
    }

    fn open(&mut self, file: &LoadedFile) -> (Arc<Unit>, Arc<Plan>) {
        let unit = self.load(&file.name, &file.text, Some(Arc::clone(&file.name)));
        let plan = self.plan(&unit, 0);
        (unit, plan)
    }

    fn fetch(&mut self, asker: Asker, name: &str, span: Span) -> Known<LoadedFile> {
        let request = FileRequest { asker, name: name.into() };
        match self.files.read(&request) {
            Ok(file) => Ok(file),
            Err(why) => {
                let mut message = Diagnostic::error(why.code, span, why.message);
                message.help = why.help;
                self.error(message);
                Err(Poisoned)
            }
        }
    }

    fn file_name(&self, expr: &Expr) -> Option<Arc<str>> {
        match &expr.kind {
            ExprKind::Name(name) => Some(self.interner.text(name.symbol).into()),
            ExprKind::Text(text) => Some((&**text).into()),
            ExprKind::Number(_) => {
                let unit = &self.levels.last()?.unit;
                unit.text.get(expr.span.start as usize..expr.span.end as usize).map(Into::into)
            }
            _ => None,
        }
    }
}
