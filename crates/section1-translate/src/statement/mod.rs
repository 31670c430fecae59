//! Statements: each major word to its file.

mod axis;
mod cutter;
mod drive;
mod edit;
mod goto;
mod intsec;
mod obtain;
mod pattern;
mod pocket;
mod post;
mod print;
mod reader;
pub(crate) mod refused;
mod regional;
mod saved;
mod setting;
mod shape;
mod startup;
mod surface;
mod switch;
mod system;
mod text;
mod tilt;

pub(crate) use refused::fate;

use std::sync::Arc;

use aptc_diagnostics::{Diagnostic, codes};
use aptc_protap::Kind;
use aptc_syntax::tree::{Body, Clause, Expr, ExprKind, Name, Target};
use aptc_vocabulary::{Class, Word, closest, word};

use crate::Interpreter;
use crate::eval::{Known, Poisoned};
use crate::memory::Value;
use crate::program::{Unit, untranslated};

/// Words that a value is never meant for: without the statement the part is another one.
const NEVER_NAMES: &[Word] = &[
    word::CUTTER,
    word::INTOL,
    word::OUTTOL,
    word::TOLER,
    word::THICK,
    word::UNITS,
    word::FEDRAT,
    word::SPINDL,
    word::COOLNT,
    word::LOADTL,
    word::MACHIN,
    word::FROM,
    word::GOTO,
    word::GODLTA,
    word::TLAXIS,
    word::PSIS,
];

impl Interpreter<'_> {
    /// Carries out a statement that does not change the order of execution by its place.
    pub(crate) fn body(&mut self, unit: &Arc<Unit>, body: &Body) {
        match body {
            Body::Empty => {}
            Body::Text { word, text, .. } => self.text(*word, text),
            Body::Assign { target, value } => self.assignment(target, value),
            Body::Clauses(clauses) => self.clauses(unit, clauses),
            Body::Call { name, args } => self.call(name, args),
            Body::IfThen { condition, then } => match self.logical(condition) {
                Ok(true) => self.body(unit, then),
                Ok(false) => {}
                Err(Poisoned) => self.state.doubt.paths = true,
            },
            Body::Error { defines, within } => {
                for name in defines.iter().chain(within) {
                    let place = self.memory.place(name.symbol);
                    self.memory.set(place, Value::Poison, name.span);
                }
                if defines.is_none() {
                    self.fail();
                }
            }
            // These have roles of their own in the plan.
            Body::Macro { .. } | Body::If { .. } | Body::Do { .. } => {}
        }
    }

    /// `A=3`, `P=POINT/1,2`.
    fn assignment(&mut self, target: &Target, value: &Expr) {
        if let ExprKind::Define(definition) = &value.kind
            && definition.target.is_none()
        {
            let form = self.define(definition, value.span);
            let again = self.by_canon(definition);
            // What went wrong was told.
            let _: Known<_> = self.name_form(target, form, again);
            return;
        }
        if let Some(word) = self.statement_of(target) {
            let message = format!("{word} takes its arguments behind a `/`, not a `=`");
            self.error(
                Diagnostic::error(codes::BAD_ARGUMENTS, target.span, message)
                    .help(format!("write {word}/..; a name for a value needs another spelling")),
            );
            self.fail();
            return;
        }
        let value = self.value(value);
        let Ok(place) = self.target(target) else { return };
        match value {
            Ok(Value::Form(form)) => {
                let _: Known<_> = self.name_form(target, Ok(form), false);
            }
            Ok(value) => {
                let _: Known<_> = self.assign(place, value, target);
            }
            Err(Poisoned) => self.memory.set(place, Value::Poison, target.span),
        }
    }

    /// The statement that was meant where a value is given to a word, `CUTTER=10`, which would name it.
    fn statement_of(&self, target: &Target) -> Option<Word> {
        let word = self.head_word(&target.name).filter(|w| NEVER_NAMES.contains(w))?;
        let unset =
            matches!(self.memory.slot(self.memory.place(target.name.symbol)).value, Value::Unset);
        (target.subscript.is_none() && unset).then_some(word)
    }

    /// Words joined by commas, each carried out in turn.
    fn clauses(&mut self, unit: &Arc<Unit>, clauses: &[Clause]) {
        if let [first, rest @ ..] = clauses
            && first.args.is_none()
            && self.head_word(&first.head) == Some(word::OBTAIN)
        {
            self.obtain(first, rest);
            return;
        }
        if let [first, second, ..] = clauses
            && first.args.is_none()
            && self.head_word(&first.head).is_none()
            && let Some(word) = self.head_word(&second.head)
            && word.is(Class::Geometry)
        {
            return self.comma_for_equals(&first.head, word);
        }
        for (i, clause) in clauses.iter().enumerate() {
            match self.head_word(&clause.head) {
                // What follows was meant to be its arguments, or to stand before it: one message, not one a word.
                Some(word) if clause.args.is_none() && i + 1 < clauses.len() && goes(word) => {
                    let message = format!("{word} is followed by `,` and has no arguments");
                    self.error(
                        Diagnostic::error(codes::BAD_ARGUMENTS, clause.head.span, message).help(
                            format!("write {word}/ and its arguments, after all other words"),
                        ),
                    );
                    self.fail();
                    return;
                }
                Some(word)
                    if i > 0
                        && clause.args.is_none()
                        && word.class() == Class::Modifier
                        && !self.begins_statement(word) =>
                {
                    // `COOLNT,ON`
                    let before = &clauses[i - 1];
                    let text = self.interner.text(before.head.symbol);
                    let message = format!("{text} takes its arguments behind a `/`, not a `,`");
                    let span = before.span.to(clause.span);
                    self.error(
                        Diagnostic::error(codes::BAD_ARGUMENTS, span, message)
                            .help(format!("write {text}/{word}")),
                    );
                    self.fail();
                    return;
                }
                Some(word) => {
                    if self.clause(unit, word, clause).is_err() && moves(word) {
                        self.fail();
                    }
                    if word == word::FINI {
                        return;
                    }
                }
                None => self.unknown_head(clause),
            }
        }
    }

    /// One word with its arguments.
    fn clause(&mut self, unit: &Arc<Unit>, word: Word, clause: &Clause) -> Known<()> {
        let args = clause.args.as_deref();
        match word {
            word::FROM | word::GOTO | word::GODLTA => self.goto(word, clause),
            word::GO | word::OFFSET => self.go(word, clause, unit),
            word::INDIRV | word::INDIRP | word::SRFVCT => self.sense(word, clause),
            word::GOLFT | word::GORGT | word::GOFWD | word::GOBACK | word::GOUP | word::GODOWN => {
                self.drive(word, clause, unit)
            }
            word::TLLFT
            | word::TLRGT
            | word::TLON
            | word::TLNDON
            | word::TLONPS
            | word::TLOFPS
            | word::AUTOPS
            | word::NOPS
            | word::W2DCALC
            | word::W3DCALC
            | word::NDTEST
            | word::CUT
            | word::DNTCUT
            | word::MULTAX
            | word::GOUGCK
            | word::CLPRNT
            | word::NOPOST
            | word::NOPLOT
            | word::CANON => self.switch(word, clause),
            word::PSIS => self.part_surface(clause),
            word::CUTTER => self.cutter(clause),
            word::TOLER
            | word::INTOL
            | word::OUTTOL
            | word::THICK
            | word::MAXDP
            | word::NUMPTS
            | word::UNITS => self.setting(word, clause),
            word::TLAXIS => self.tool_axis(clause),
            word::POCKET => self.pocket(clause),
            word::INDEX | word::COPY | word::TRACUT => self.edit(word, clause),
            word::VTLAXS | word::WCORN => self.tilt(word, clause),
            word::ZSURF | word::REFSYS => self.system(word, clause),
            word::RESERV => self.reserve(clause),
            word::PRINT | word::PUNCH => self.print(word, clause),
            word::OBTAIN => self.obtain_alone(clause),
            word::LOCAL => {
                self.local(args.unwrap_or_default());
                Ok(())
            }
            word::READ => {
                self.read(args.unwrap_or_default());
                Ok(())
            }
            word::INCLUD => {
                match args {
                    Some([name]) => self.include(crate::Asker::Include, name),
                    _ => self.include(crate::Asker::Include, &missing(clause)),
                }
                Ok(())
            }
            word::LIBRY => {
                self.library(args.unwrap_or_default());
                Ok(())
            }
            word::FINI => {
                self.finish();
                Ok(())
            }
            // The plan took care of these.
            word::SYN | word::LOOPST | word::LOOPND | word::CONTIN | word::TERMAC => Ok(()),
            word::JUMPTO | word::TRANTO => self.late_jump(unit, clause),
            _ => self.other(word, clause),
        }
    }

    /// `L1,LINE/...`
    fn comma_for_equals(&mut self, name: &Name, word: Word) {
        let text = self.interner.text(name.symbol).to_owned();
        let message = format!("{text} gets its value by `=`, not by `,`");
        self.error(
            Diagnostic::error(codes::NO_STATEMENT, name.span, message)
                .help(format!("write {text}={word}/..")),
        );
        let place = self.memory.place(name.symbol);
        self.memory.set(place, Value::Poison, name.span);
    }

    /// JUMPTO behind another word, as in `RAPID,JUMPTO/A`.
    fn late_jump(&mut self, unit: &Arc<Unit>, clause: &Clause) -> Known<()> {
        let argument = clause.args.as_deref().and_then(<[Expr]>::first);
        let is_label = |a: &&Expr| matches!(a.kind, ExprKind::Name(_) | ExprKind::Number(_));
        let Some(label) = argument.filter(is_label) else {
            self.error(
                Diagnostic::error(codes::NO_SUCH_LABEL, clause.span, "a label is expected here")
                    .help("write JUMPTO/label"),
            );
            return Err(Poisoned);
        };
        match self.label_goal(unit, label.span) {
            Some(goal) => self.go_to(goal),
            None => self.state.doubt.paths = true,
        }
        Ok(())
    }

    /// Words that the tables of classes decide.
    fn other(&mut self, word: Word, clause: &Clause) -> Known<()> {
        if let Some(known) = self.refused(word, clause) {
            return known;
        }
        if word == word::INTSEC {
            return self.intsec(clause);
        }
        if word.is(Class::Regional) {
            return self.regional(word, clause);
        }
        if word.is(Class::Post) {
            return self.post(word, clause);
        }
        self.no_statement(word, clause);
        Err(Poisoned)
    }

    /// A word that begins no statement.
    fn no_statement(&mut self, word: Word, clause: &Clause) {
        if let Some(message) = untranslated(word, clause.head.span) {
            self.error(message);
            self.fail();
            return;
        }
        let what = match word.class() {
            Class::Geometry => "defines geometry and needs a name: name=",
            Class::Function => "is a function and stands in expressions",
            Class::Modifier => "is a modifier and begins no statement",
            _ => "begins no statement",
        };
        let what = match word.class() {
            Class::Geometry => format!("{word} {what}{word}/..."),
            _ => format!("{word} {what}"),
        };
        let mut message = Diagnostic::error(codes::NO_STATEMENT, clause.head.span, what);
        if let Some(near) = closest(word.text(), |w| w != word && self.begins_statement(w)) {
            message = message.help(format!("did you mean {near}?"));
        }
        self.error(message);
        self.fail();
    }

    /// A name at the head that is no word: misspelt, or a word of a post-processor that nobody knows.
    fn unknown_head(&mut self, clause: &Clause) {
        let text = self.interner.text(clause.head.symbol).to_owned();
        if let Some(word) = clause.head.word {
            // A word of another dialect.
            self.error(
                Diagnostic::error(
                    codes::OTHER_DIALECT,
                    clause.head.span,
                    format!("{word} is a word of NCL, not of APT"),
                )
                .help("translate the program with --dialect ncl"),
            );
            self.state.doubt.names = true;
            self.fail();
            return;
        }
        let near = closest(&text, |w| self.begins_statement(w));
        if near.is_none() && clause.args.as_deref().is_some_and(|args| self.names_check(args)) {
            self.error(
                Diagnostic::error(
                    codes::NO_STATEMENT,
                    clause.head.span,
                    format!("{text} begins no statement"),
                )
                .help("motion begins with GO, GOLFT, GORGT, GOFWD, GOBACK, GOUP or GODOWN"),
            );
            self.fail();
            return;
        }
        let value = self.memory.slot(self.memory.place(clause.head.symbol)).value.clone();
        if near.is_some_and(|w| !w.is(Class::Post)) || !matches!(value, Value::Unset) {
            let mut message = Diagnostic::error(
                codes::NO_STATEMENT,
                clause.head.span,
                format!("{text} begins no statement"),
            );
            if let Some(near) = near {
                message = message.help(format!("did you mean {near}?"));
            } else if matches!(value, Value::Poison) {
                self.fail();
                return;
            } else {
                message = message.help(format!("a value is given by {text}=..."));
            }
            self.error(message);
            self.fail();
            return;
        }
        self.unknown_post(&text, near, clause);
    }

    /// Do the arguments say how far to go to a check surface, as those of a motion do?
    fn names_check(&self, args: &[Expr]) -> bool {
        let checks = [word::TO, word::ON, word::PAST, word::TANTO];
        args.iter().skip(1).any(|arg| match &arg.kind {
            ExprKind::Name(name) => self.synonyms.word(name).is_some_and(|w| checks.contains(&w)),
            _ => false,
        })
    }

    fn begins_statement(&self, word: Word) -> bool {
        self.synonyms.knows(word)
            && (word.is(Class::Motion)
                || word.is(Class::Control)
                || word.is(Class::Post)
                || word.is(Class::Text)
                || word.is(Class::Regional))
    }

    /// A statement that sets or moves the tool could not be translated.
    pub(crate) fn fail(&mut self) {
        self.emit(Kind::Failed);
    }
}

/// How a statement with a table of arguments is written: `SCON/AXIS,vector[,PLUS|MINUS]`.
pub(crate) fn statement_shapes(word: Word) -> Vec<String> {
    if word == word::INTSEC {
        return intsec::FORMATS.map(str::to_owned).to_vec();
    }
    let shapes = match word {
        word::VTLAXS | word::WCORN => tilt::shapes(word),
        _ => regional::shapes(word),
    };
    shapes.iter().map(|s| format!("{word}/{}", s.text())).collect()
}

/// Does a failure of the statement leave it unknown where the tool stands, or how it cuts?
fn moves(word: Word) -> bool {
    word.is(Class::Motion) || word.is(Class::Regional) || word == word::CUTTER
}

/// Does the word say where the tool goes, which nothing but its own arguments can tell?
fn goes(word: Word) -> bool {
    let along = [word::GOLFT, word::GORGT, word::GOFWD, word::GOBACK, word::GOUP, word::GODOWN];
    along.contains(&word) || [word::FROM, word::GO, word::GOTO, word::GODLTA].contains(&word)
}

fn missing(clause: &Clause) -> Expr {
    Expr { kind: ExprKind::Empty, span: clause.span }
}
