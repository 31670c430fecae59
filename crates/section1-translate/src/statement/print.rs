//! PRINT and PUNCH.
//!
//! | statement | prints |
//! | --- | --- |
//! | PRINT/ON, PRINT/OFF | from here on the canonical form of each definition, or no longer |
//! | PRINT/0 | a new page |
//! | PRINT/1,names | bit by bit |
//! | PRINT/2,names | values without names |
//! | PRINT/3,names or ALL | values with names |
//! | PRINT/4,names or ALL | as 3, and saves them as PUNCH does |
//! | PUNCH/1 2 3,names or ALL | saves all, numbers, forms as statements for READ/1 |
//! | PRINT/AVPRT,ON or AVMSG,ON | each gouge that is avoided, until OFF |
//! | PRINT/SSPRT,ON and its kin | tables of APT4 that nobody needs: without effect |

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_protap::{self as protap, Kind, NameRef};
use aptc_syntax::tree::{Clause, Expr, ExprKind, Name};
use aptc_vocabulary::{Word, word};

use super::reader::Reader;
use super::saved::statement;
use crate::Interpreter;
use crate::eval::{Arg, ArgKind, Known, Names, Poisoned};
use crate::listing::EntryKind;
use crate::memory::{Place, Value};

/// How values are printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Style {
    Bits,
    Plain,
    Named,
    /// PRINT/4.
    NamedAndSaved,
    /// PUNCH.
    Saved,
}

/// Which of all values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Which {
    All,
    Numbers,
    Forms,
}

impl Interpreter<'_> {
    /// PRINT/..., PUNCH/...
    pub(super) fn print(&mut self, word: Word, clause: &Clause) -> Known<()> {
        let exprs = clause.args.as_deref().unwrap_or_default();
        if word == word::PUNCH {
            return self.punch(clause, exprs);
        }
        let Some((first, rest)) = exprs.split_first() else {
            return Err(self.bad_print(clause));
        };
        if let ExprKind::Name(name) = &first.kind {
            return match self.head_word(name) {
                Some(word::ON) if rest.is_empty() => {
                    self.state.print = true;
                    Ok(())
                }
                Some(word::OFF) if rest.is_empty() => {
                    self.state.print = false;
                    Ok(())
                }
                Some(what @ (word::AVPRT | word::AVMSG)) => {
                    let switch = match rest {
                        [one] => match &one.kind {
                            ExprKind::Name(n) => self.head_word(n),
                            _ => None,
                        },
                        _ => None,
                    };
                    let Some(switch @ (word::ON | word::OFF)) = switch else {
                        return Err(self.bad_print(clause));
                    };
                    let args = [what, switch].map(|w| protap::Arg::Word(w.text().into()));
                    self.emit(Kind::Regional { word: word.text().into(), args: args.into() });
                    Ok(())
                }
                Some(word::SSPRT | word::SSTEST | word::TABPRT | word::LIBPRT) => {
                    let text = self.interner.text(name.symbol).to_owned();
                    self.list(EntryKind::Remark(format!("PRINT/{text} has no effect here")));
                    Ok(())
                }
                _ => Err(self.bad_print(clause)),
            };
        }
        #[expect(clippy::cast_possible_truncation, reason = "compared with 0 to 4")]
        let style = match self.number(first)?.trunc() as i64 {
            0 if rest.is_empty() => {
                self.list(EntryKind::Page);
                return Ok(());
            }
            1 => Style::Bits,
            2 => Style::Plain,
            3 => Style::Named,
            4 => Style::NamedAndSaved,
            _ => return Err(self.bad_print(clause)),
        };
        self.print_list(style, Which::All, rest, clause)
    }

    fn punch(&mut self, clause: &Clause, exprs: &[Expr]) -> Known<()> {
        let (which, rest) = match exprs {
            [first, rest @ ..] if !matches!(first.kind, ExprKind::Name(_)) => {
                #[expect(clippy::cast_possible_truncation, reason = "compared with 1 to 3")]
                let which = match self.number(first)?.trunc() as i64 {
                    1 => Which::All,
                    2 => Which::Numbers,
                    3 => Which::Forms,
                    _ => return Err(self.bad_print(clause)),
                };
                (which, rest)
            }
            all => (Which::All, all),
        };
        self.print_list(Style::Saved, which, rest, clause)
    }

    fn bad_print(&mut self, clause: &Clause) -> Poisoned {
        let args: &[Arg] = &[];
        let reader = Reader::new(word::PRINT, clause, args);
        let mut message = reader.expected("ON, OFF, AVPRT, 0, or 1 to 4 and names");
        message.span = clause.span;
        message.message = "this form of PRINT or PUNCH is not known".to_owned();
        message.help = Some("write PRINT/ON, PRINT/OFF, PRINT/0 or PRINT/3,names".to_owned());
        self.error(message);
        Poisoned
    }

    fn print_list(
        &mut self,
        style: Style,
        which: Which,
        exprs: &[Expr],
        clause: &Clause,
    ) -> Known<()> {
        if exprs.is_empty() {
            return Err(self.bad_print(clause));
        }
        for expr in exprs {
            let all = match &expr.kind {
                ExprKind::Name(name) => self.head_word(name) == Some(word::ALL),
                _ => false,
            };
            if all {
                self.print_all(style, which);
            } else {
                self.print_one(style, expr);
            }
        }
        Ok(())
    }

    fn print_all(&mut self, style: Style, which: Which) {
        let places: Vec<Place> = self
            .memory
            .values()
            .filter(|(_, slot)| match slot.value {
                Value::Number(_) => which != Which::Forms,
                Value::Form(_) => which != Which::Numbers,
                _ => false,
            })
            .map(|(place, _)| place)
            .collect();
        for place in places {
            self.print_place(style, place);
        }
    }

    fn print_place(&mut self, style: Style, place: Place) {
        let name = self.name_ref(place);
        let value = self.memory.slot(place).value.clone();
        self.print_value(style, name, &value);
    }

    fn print_value(&mut self, style: Style, name: NameRef, value: &Value) {
        let (word, elements) = match value {
            Value::Number(n) => ("SCALAR", vec![*n]),
            Value::Form(form) => (form.kind().word(), self.seen(form).canonical()),
            _ => return,
        };
        let unnamed = name.name.is_empty();
        if matches!(style, Style::Saved | Style::NamedAndSaved) && !unnamed {
            for card in statement(&name, word, &elements) {
                self.list(EntryKind::Saved(card));
            }
        }
        let name = (style != Style::Plain).then_some(name);
        self.list(match (style, name, value) {
            (Style::Saved, ..) => return,
            (Style::Bits, Some(name), _) => EntryKind::Bits { name, word, elements },
            (_, name, Value::Number(n)) => EntryKind::Scalar { name, value: *n },
            (_, name, _) => EntryKind::Form { name, word, elements },
        });
    }

    /// One item of the list; a name without a value is told, but is no error.
    fn print_one(&mut self, style: Style, expr: &Expr) {
        if let ExprKind::Name(name) = &expr.kind {
            let place = self.memory.place(name.symbol);
            if let Value::Array(array) = self.memory.slot(place).value {
                let n = self.memory.array(array).slots.len();
                for i in (0u32..).take(n) {
                    self.print_place(style, Place::Element(array, i));
                }
                return;
            }
            if matches!(self.memory.slot(place).value, Value::Unset) {
                self.print_undefined(name, place);
                return;
            }
        }
        if let ExprKind::Indexed(indexed) = &expr.kind
            && let Some(places) = self.printed_elements(&indexed.name, &indexed.list, expr.span)
        {
            for place in places {
                if matches!(self.memory.slot(place).value, Value::Unset) {
                    self.print_undefined(&indexed.name, place);
                } else {
                    self.memory.slot_mut(place).read = true;
                    self.print_place(style, place);
                }
            }
            return;
        }
        let Ok(args) = self.arguments(std::slice::from_ref(expr), Names::Free) else { return };
        for arg in args {
            match arg.kind {
                ArgKind::Number(n) | ArgKind::Digits(n) => {
                    let name = match &expr.kind {
                        ExprKind::Name(name) => self.name_ref(self.memory.place(name.symbol)),
                        _ => NameRef::default(),
                    };
                    self.print_value(style, name, &Value::Number(n));
                }
                ArgKind::Form { form, name } => self.print_value(style, name, &Value::Form(form)),
                _ => {}
            }
        }
    }

    /// The elements that an item names; `None` when it is no array, none when they cannot be had.
    fn printed_elements(
        &mut self,
        name: &Name,
        subscripts: &[Expr],
        span: Span,
    ) -> Option<Vec<Place>> {
        let place = self.memory.place(name.symbol);
        let Value::Array(array) = self.memory.slot(place).value else { return None };
        let places = if self.several(subscripts) {
            self.elements(array, subscripts, span)
        } else {
            self.indexed_element(array, place, subscripts, span).map(|p| vec![p])
        };
        Some(places.unwrap_or_default())
    }

    fn print_undefined(&mut self, name: &Name, place: Place) {
        let shown = self.name_ref(place);
        let text = self.spelled(place);
        if !self.is_doubtful(name.symbol) {
            let mut message = Diagnostic::warning(
                codes::PRINTED_UNDEFINED,
                name.span,
                format!("{text} has no value to print"),
            );
            if shown.subscript == 0
                && let Some(near) = self.near(name.symbol, &text)
            {
                message = message.help(format!("did you mean {near}?"));
            }
            self.error(message);
        }
        self.list(EntryKind::Undefined { name: shown });
    }
}
