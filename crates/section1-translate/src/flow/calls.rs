//! Macros: MACRO, CALL, TERMAC and their parameters.

use std::sync::Arc;

use aptc_diagnostics::{Diagnostic, Frame, FrameKind, Span, codes};
use aptc_syntax::Symbol;
use aptc_syntax::tree::{Body, Expr, ExprKind, Name, Param};
use aptc_vocabulary::word;

use crate::Interpreter;
use crate::eval::{Known, Poisoned};
use crate::interpreter::MacroDef;
use crate::level::{Level, LevelKind};
use crate::memory::{Binding, Place, Slot, Value};
use crate::program::{Plan, Unit};

impl Interpreter<'_> {
    /// name=MACRO/parameters.
    pub(crate) fn define_macro(
        &mut self,
        unit: &Arc<Unit>,
        plan: &Arc<Plan>,
        name: &Name,
        place: u32,
        end: u32,
    ) {
        let new = MacroDef { unit: Arc::clone(unit), plan: Arc::clone(plan), place, end };
        let Some(old) = self.macros.get(&name.symbol) else {
            self.macros.insert(name.symbol, new);
            return;
        };
        let first = old.unit.program.statements[old.place as usize].span;
        if first == self.here.span {
            return;
        }
        let text = self.interner.text(name.symbol).to_owned();
        self.error(
            Diagnostic::error(
                codes::MACRO_TWICE,
                name.span,
                format!("macro {text} is defined a second time"),
            )
            .also(first, "here first")
            .help("give one of them another name"),
        );
    }

    /// CALL/name,parameter=value,...
    pub(crate) fn call(&mut self, name: &Name, args: &[Param]) {
        if self.calls_program(name, args) {
            return;
        }
        if self.begin_call(name, args).is_err() {
            // What the macro would have defined or moved is not missed.
            self.state.doubt.paths = true;
            self.fail();
        }
    }

    fn begin_call(&mut self, name: &Name, args: &[Param]) -> Known<()> {
        let symbol = self.aliased(name.symbol);
        if !self.macros.contains_key(&symbol) && self.fetch_library(symbol).is_err() {
            self.state.doubt.names = true;
            return Err(Poisoned);
        }
        let Some(definition) = self.macros.get(&symbol).cloned() else {
            return Err(self.no_macro(symbol, name.span));
        };
        let limit = self.options.limits.macro_depth;
        let depth = self.levels.last().map_or(0, |l| l.n_calls);
        if depth >= limit {
            self.error(
                Diagnostic::error(
                    codes::TOO_MANY_CALLS,
                    name.span,
                    format!("more than {limit} macro calls within each other"),
                )
                .help("does the macro call itself? the limit is a setting"),
            );
            return Err(Poisoned);
        }
        let statement = &definition.unit.program.statements[definition.place as usize];
        let Body::Macro { name: macro_name, params } = &statement.body else {
            unreachable!("a macro begins with MACRO");
        };
        let bindings = self.bindings(macro_name, params, args, name.span)?;
        let caller_local = match self.levels.iter().rev().find_map(|l| match l.kind {
            LevelKind::Macro { first_local, .. } => Some(first_local),
            _ => None,
        }) {
            Some(first) => first,
            None => self.memory.n_locals(),
        };
        let trace = Some(Arc::new(Frame {
            kind: FrameKind::Macro,
            name: self.interner.text(symbol).into(),
            span: self.here.span,
            line: self.here.line,
            pass: 0,
            outer: self.trace(),
        }));
        let first_local = self.memory.n_locals();
        self.memory.hide(caller_local);
        for (symbol, binding) in bindings {
            self.memory.bind(symbol, binding);
        }
        let range = (definition.place + 1, (definition.end + 1).min(definition.plan.end()));
        let kind = LevelKind::Macro { first_local, caller_local };
        let MacroDef { unit, plan, .. } = definition;
        let level = Level::new(unit, plan, range, kind, trace).inside(self.levels.last());
        self.levels.push(level);
        Ok(())
    }

    /// The name that a macro parameter hands on, or `symbol` itself.
    fn aliased(&self, symbol: Symbol) -> Symbol {
        match self.memory.place(symbol) {
            Place::Global(other) => other,
            _ => symbol,
        }
    }

    /// What each parameter stands for: the argument of the call, else the default.
    fn bindings(
        &mut self,
        macro_name: &Name,
        params: &[Param],
        args: &[Param],
        call: Span,
    ) -> Known<Vec<(Symbol, Binding)>> {
        let mut known = Ok(());
        for arg in args {
            let twice = args.iter().take_while(|a| a.name.span != arg.name.span);
            let again = twice.into_iter().any(|a| a.name.symbol == arg.name.symbol);
            if !params.iter().any(|p| p.name.symbol == arg.name.symbol) {
                // Arguments without a name are one mistake, however many there are.
                let told = again && self.interner.text(arg.name.symbol).is_empty();
                known =
                    Err(if told { Poisoned } else { self.no_parameter(macro_name, params, arg) });
            } else if again {
                let text = self.interner.text(arg.name.symbol).to_owned();
                self.error(
                    Diagnostic::error(
                        codes::BAD_PARAMETER,
                        arg.name.span,
                        format!("parameter {text} is given twice"),
                    )
                    .help("give each parameter once"),
                );
                known = Err(Poisoned);
            }
        }
        let mut bindings = Vec::with_capacity(params.len());
        for param in params {
            let arg = args.iter().find(|a| a.name.symbol == param.name.symbol);
            let value = match arg {
                Some(arg) if arg.value.is_none() => param.value.as_ref(),
                Some(arg) => arg.value.as_ref(),
                None => param.value.as_ref(),
            };
            let binding = match value {
                Some(value) => self.binding(value),
                // It was perhaps given under the wrong name.
                None if known.is_err() => Err(Poisoned),
                None => Err(self.no_argument(macro_name, param, call)),
            };
            match binding {
                Ok(binding) => bindings.push((param.name.symbol, binding)),
                Err(Poisoned) => known = Err(Poisoned),
            }
        }
        known.map(|()| bindings)
    }

    /// What a parameter with this actual value stands for. A name stays a name, so that the macro can
    /// also define it; words and numbers are handed over as they are.
    fn binding(&mut self, value: &Expr) -> Known<Binding> {
        let own = |value: Value, given: Span| Binding::Own(Slot { value, given, read: false });
        match &value.kind {
            ExprKind::Name(name) => {
                let place = self.memory.place(name.symbol);
                let slot = self.memory.slot_mut(place);
                slot.read = true;
                match (&slot.value, self.synonyms.word(name)) {
                    (Value::Unset, Some(word)) => Ok(own(Value::Word(word), value.span)),
                    _ => Ok(Binding::Alias(place)),
                }
            }
            ExprKind::Indexed(indexed) => {
                let place = self.memory.place(indexed.name.symbol);
                if let (Value::Array(array), [subscript]) =
                    (&self.memory.slot(place).value, &indexed.list[..])
                {
                    let array = *array;
                    let n = self.number(subscript)?;
                    let element = self.element(array, n, subscript.span)?;
                    self.memory.slot_mut(element).read = true;
                    return Ok(Binding::Alias(element));
                }
                Ok(own(self.value(value)?, value.span))
            }
            // An argument that could not be had poisons the parameter, and the macro runs on.
            _ => Ok(own(self.value(value).unwrap_or(Value::Poison), value.span)),
        }
    }

    fn no_macro(&mut self, symbol: Symbol, span: Span) -> Poisoned {
        let text = self.interner.text(symbol).to_owned();
        self.state.doubt.names = true;
        if self.state.doubt.macros {
            return Poisoned;
        }
        let mut message = Diagnostic::error(
            codes::NO_SUCH_MACRO,
            span,
            format!("there is no macro {text} before this CALL"),
        );
        let mut names: Vec<&str> = self.macros.keys().map(|s| self.interner.text(*s)).collect();
        names.sort_unstable();
        message = if names.is_empty() {
            message.help(format!("define it before the CALL, or name it in LIBRY/{text}"))
        } else {
            message.help(format!("the macros are {}", names.join(", ")))
        };
        self.error(message);
        Poisoned
    }

    fn no_parameter(&mut self, macro_name: &Name, params: &[Param], arg: &Param) -> Poisoned {
        let text = self.interner.text(arg.name.symbol).to_owned();
        let name = self.interner.text(macro_name.symbol).to_owned();
        let names: Vec<&str> = params.iter().map(|p| self.interner.text(p.name.symbol)).collect();
        let names = names.join(", ");
        let help = match (arg.value.is_none(), names.is_empty()) {
            (_, true) => format!("{name} has no parameters"),
            (true, _) => format!("write parameter=value; the parameters are {names}"),
            (false, _) if text.is_empty() => {
                format!(
                    "write CALL/{name},{}=..; the parameters are {names}",
                    names.split(',').next().unwrap_or_default()
                )
            }
            (false, _) => format!("the parameters are {names}"),
        };
        self.error(
            Diagnostic::error(
                codes::BAD_PARAMETER,
                arg.name.span,
                if text.is_empty() {
                    format!("macro {name} takes its arguments by name")
                } else {
                    format!("macro {name} has no parameter {text}")
                },
            )
            .also(macro_name.span, "the macro is defined here")
            .help(help),
        );
        Poisoned
    }

    fn no_argument(&mut self, macro_name: &Name, param: &Param, call: Span) -> Poisoned {
        let text = self.interner.text(param.name.symbol).to_owned();
        let name = self.interner.text(macro_name.symbol).to_owned();
        self.error(
            Diagnostic::error(
                codes::MISSING_ARGUMENT,
                call,
                format!("the call gives no value to {text} of macro {name}"),
            )
            .also(param.name.span, "it has no default")
            .help(format!("write {text}=value in the CALL")),
        );
        Poisoned
    }

    /// CALL/program,SEC1|SEC2,...: a program of the installation, which is not there.
    fn calls_program(&mut self, name: &Name, args: &[Param]) -> bool {
        let Some(first) = args.first() else { return false };
        let section = self.synonyms.word(&first.name);
        let special = first.value.is_none() && matches!(section, Some(word::SEC1 | word::SEC2));
        if special {
            let text = self.interner.text(name.symbol).to_owned();
            self.error(
                Diagnostic::error(
                    codes::SPECIAL_PROGRAM,
                    name.span,
                    format!("the special program {text} is not available"),
                )
                .note("it was linked to the processor of the installation that the program is from")
                .help("write what it does as a macro"),
            );
            self.state.doubt.names = true;
            self.fail();
        }
        special
    }

    /// LOCAL/names: names of the present macro call alone.
    pub(crate) fn local(&mut self, args: &[Expr]) {
        let in_macro = self.levels.iter().rev().find(|l| !matches!(l.kind, LevelKind::File));
        if !matches!(in_macro.map(|l| &l.kind), Some(LevelKind::Macro { .. })) {
            self.error(
                Diagnostic::error(codes::BAD_LOCAL, self.here.span, "LOCAL stands in no macro")
                    .help("put it behind the MACRO statement"),
            );
            return;
        }
        for arg in args {
            match &arg.kind {
                // A jump back over LOCAL declares nothing new.
                ExprKind::Name(name) if self.memory.is_local(name.symbol) => {}
                ExprKind::Name(name) => {
                    self.memory.bind(name.symbol, Binding::Own(Slot::default()));
                }
                _ => self.error(
                    Diagnostic::error(codes::BAD_LOCAL, arg.span, "LOCAL takes names")
                        .help("an array is reserved by RESERV in the main program"),
                ),
            }
        }
    }
}
