//! Geometric definitions: names and nesting here, formats and solutions in [`crate::define`].

use std::cell::{Cell, RefCell};
use std::rc::Rc;
use std::sync::Arc;

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_geometry::{Form, FormKind, Vec3};
use aptc_protap::{Kind, NameRef, Units, fault_of_form};
use aptc_syntax::tree::{Definition, ExprKind, Target};
use aptc_vocabulary::{Class, Word, closest, word};

use super::{Arg, ArgKind, Known, Names, Poisoned};
use crate::Interpreter;
use crate::define::{self, Context};
use crate::listing::EntryKind;
use crate::memory::{Place, Value};
use crate::program::untranslated;
use crate::statement::refused::no_geometry;

/// How far a TABCYL goes straight on at both ends, inches.
const TABCYL_END_INCHES: f64 = 10.0;
/// Surfaces of more points are fitted where they are needed, not where they are defined: it takes time.
pub(super) const FEW_POINTS: usize = 400;

impl Interpreter<'_> {
    /// The form of a definition and its name; a name in it gets the form.
    pub(crate) fn definition(
        &mut self,
        definition: &Definition,
        span: Span,
    ) -> Known<(Arc<Form>, NameRef)> {
        let form = self.define(definition, span);
        self.unfit_in_place();
        match &definition.target {
            Some(target) => self.name_form(target, form, self.by_canon(definition)),
            None => {
                let form = form?;
                self.list_form(&NameRef::default(), &form);
                Ok((form, NameRef::default()))
            }
        }
    }

    /// Is it a definition by canonical elements, which may be given to a name again?
    pub(crate) fn by_canon(&self, definition: &Definition) -> bool {
        definition.args.iter().take(2).any(|a| match &a.kind {
            ExprKind::Name(name) => self.synonyms.word(name) == Some(word::CANON),
            ExprKind::Define(inner) => inner.juxtaposed.iter().any(|j| match &j.kind {
                ExprKind::Name(name) => self.synonyms.word(name) == Some(word::CANON),
                _ => false,
            }),
            _ => false,
        })
    }

    /// Gives a form, or the mistake in its place, to a name; `again` when it may have one already.
    pub(crate) fn name_form(
        &mut self,
        target: &Target,
        form: Known<Arc<Form>>,
        again: bool,
    ) -> Known<(Arc<Form>, NameRef)> {
        self.unfit_named(target.name.symbol, target.span);
        let place = self.target(target)?;
        let Ok(form) = form else {
            self.memory.set(place, Value::Poison, target.span);
            return Err(Poisoned);
        };
        self.assign_again(place, Value::Form(Arc::clone(&form)), target, again)?;
        let name = self.name_ref(place);
        self.emit(Kind::Define { name: name.clone(), form: Arc::clone(&form) });
        self.list_form(&name, &form);
        Ok((form, name))
    }

    fn list_form(&mut self, name: &NameRef, form: &Form) {
        if self.state.print {
            let elements = self.seen(form).canonical();
            self.list(EntryKind::Form {
                name: Some(name.clone()),
                word: form.kind().word(),
                elements,
            });
        }
    }

    /// A form as the present reference system sees it, for the listing; as it is where it cannot be carried over.
    pub(crate) fn seen(&self, form: &Form) -> Form {
        let inverse = self.state.refsys.and_then(|m| m.inverse());
        inverse.and_then(|m| form.transformed(&m).ok()).unwrap_or_else(|| form.clone())
    }

    /// The form of a definition.
    pub(crate) fn define(&mut self, definition: &Definition, span: Span) -> Known<Arc<Form>> {
        if let Some(told) = self.refused_form(definition) {
            // Its arguments are of a language that is not read: their names get values, nothing is said of them.
            self.error(told);
            let _ = self.muted(|s| s.arguments(&definition.args, Names::Defined));
            return Err(Poisoned);
        }
        let args = self.arguments(&definition.args, Names::Defined);
        let Some(head) = self.head_word(&definition.head).filter(|w| define::is_definition(*w))
        else {
            return Err(self.no_definition(definition));
        };
        let args: Vec<define::Arg> = args?.into_iter().map(define::Arg::from).collect();
        let saved = args.first().is_some_and(|a| a.value == define::Value::Word(word::CLDATA));
        if saved && matches!(head, word::POINT | word::VECTOR) {
            // They are told in the base system, as forms are kept.
            return self.saved_form(head, &args, span).map(Arc::new);
        }
        let context = Context {
            zsurf: self.state.zsurf,
            refsys: self.state.refsys,
            apt4: self.state.sculptured,
            max_points: self.options.limits.points,
            tabcyl_end: self.prolongation(),
            fits: Rc::clone(&self.fits),
            found: RefCell::default(),
            beyond: Cell::default(),
        };
        self.matrix_within(head, span, &args);
        let canon = define::Value::Word(word::CANON);
        // Those whose places a message names.
        let (form, args) = match args.as_slice() {
            [first, rest @ ..] if first.value == canon => {
                (define::canonical(head, None, rest, &context), rest)
            }
            [define::Arg { value: define::Value::Form { form, .. }, .. }, second, rest @ ..]
                if second.value == canon =>
            {
                (define::canonical(head, Some(form), rest, &context), rest)
            }
            all => (define::define(head, all, &context), all),
        };
        if let Some(found) = context.found.take() {
            self.state.found = Some(found);
        }
        match form {
            Ok(form) => {
                self.product_in_order(head, span, args, &form, &context);
                self.inner_slope(head, args);
                self.patch_side(head, args);
                self.idle_smoothing(head, args);
                self.used_by_none(head, span);
                self.ruled_ends(head, args);
                self.fits(&form, span)?;
                self.area(&form, args, span)?;
                if let Some(beyond) = context.beyond.take() {
                    self.beyond_end(args[beyond.at].span, beyond);
                }
                // Numbers at the edge of what can be written leave no form behind.
                if let Some(why) = fault_of_form(&form) {
                    self.error(Diagnostic::error(
                        codes::OUT_OF_RANGE,
                        span,
                        format!("this {head} is beyond what numbers can hold: {why}"),
                    ));
                    return Err(Poisoned);
                }
                Ok(Arc::new(form))
            }
            Err(why) => {
                let message = why.diagnostic(args, span);
                self.error(message);
                Err(Poisoned)
            }
        }
    }

    /// Says once how a MATRIX given by places is taken within REFSYS, where the dialects differ.
    fn matrix_within(&mut self, head: Word, span: Span, args: &[define::Arg]) {
        let by_places = args.iter().any(|a| match &a.value {
            define::Value::Form { form, .. } => form.kind() != FormKind::Matrix,
            _ => false,
        });
        if head != word::MATRIX || self.state.refsys.is_none() || !by_places {
            return;
        }
        if std::mem::replace(&mut self.state.matrix_said, true) {
            return;
        }
        let (to, why) = if self.state.sculptured {
            ("the base system", "the program has sculptured forms: so APT4 takes it")
        } else {
            ("the reference system", "so the manual of APT-360 has it; APT4 takes the base system")
        };
        self.error(
            Diagnostic::warning(
                codes::MATRIX_IN_SYSTEM,
                span,
                format!("this MATRIX within REFSYS leads into {to}"),
            )
            .note(why)
            .help("define it before REFSYS, or after REFSYS/NOMORE, where no system is in doubt"),
        );
    }

    /// Says once that the first of two maps is carried out first, where the dialects differ.
    fn product_in_order(
        &mut self,
        head: Word,
        span: Span,
        args: &[define::Arg],
        form: &Form,
        context: &Context,
    ) {
        if head != word::MATRIX || !context.apt4 || self.state.product_said {
            return;
        }
        let other = Context { apt4: false, refsys: None, ..context.clone() };
        let (Form::Matrix(map), Ok(Form::Matrix(other))) =
            (form, define::define(head, args, &other))
        else {
            return;
        };
        let alike = |(a, b): (f64, f64)| (a - b).abs() <= 1e-9 * (1.0 + a.abs());
        if map.rows().into_iter().zip(other.rows()).all(alike) {
            return;
        }
        self.state.product_said = true;
        self.error(
            Diagnostic::warning(
                codes::MATRIX_ORDER,
                span,
                "of these two maps the first is carried out first",
            )
            .note("the program has sculptured forms: so APT4 takes it; APT-360 carries out the second first")
            .help("swap them where the other order is meant"),
        );
    }

    /// Says that a SPLINE takes slopes at its ends alone: at the first of them that stands elsewhere.
    fn inner_slope(&mut self, head: Word, args: &[define::Arg]) {
        let is = |i: usize, w: Word| args.get(i).is_some_and(|a| a.value == define::Value::Word(w));
        if head != word::TABCYL || !is(1, word::SPLINE) {
            return;
        }
        let data = if is(2, word::TRFORM) { 4 } else { 2 };
        // The first point is a form or two numbers.
        let first = match args.get(data).map(|a| &a.value) {
            Some(define::Value::Form { .. }) => data + 1,
            _ => data + 2,
        };
        let inner = (first + 1..args.len().saturating_sub(2))
            .find(|i| is(*i, word::SLOPE) || is(*i, word::NORMAL));
        let Some(at) = inner else { return };
        let what = if is(at, word::SLOPE) { "SLOPE" } else { "NORMAL" };
        self.error(
            Diagnostic::warning(
                codes::INNER_SLOPE,
                args[at].span,
                format!("{what} does not count between the ends of a SPLINE"),
            )
            .note("its slopes there are those with which the curvature is continuous, as in APT-360")
            .help("take TWOPT, whose slopes hold at every point, or end one SPLINE there and begin another"),
        );
    }

    /// Says once a statement that MINUS of a patch changes nothing.
    fn patch_side(&mut self, head: Word, args: &[define::Arg]) {
        let is = |a: &define::Arg, w: Word| a.value == define::Value::Word(w);
        if head != word::SSURF || !args.first().is_some_and(|a| is(a, word::PATCH)) {
            return;
        }
        let Some(minus) = args.iter().find(|a| is(a, word::MINUS)) else { return };
        self.error(
            Diagnostic::warning(codes::PATCH_SIDE, minus.span, "MINUS of a patch changes nothing")
                .note("its parameters and its normal are those of PLUS, as in APT4")
                .help("exchange rows and columns of its items where the other normal is meant"),
        );
    }

    /// Says once a statement that a place is beyond the end of a sculptured form.
    fn beyond_end(&mut self, span: Span, define::Beyond { value, last, .. }: define::Beyond) {
        if !self.state.beyond_said.insert(span) {
            return;
        }
        let (value, last) = (define::short(value), define::short(last));
        self.error(
            Diagnostic::warning(
                codes::BEYOND_END,
                span,
                format!("the parameter {value} is not between 0 and {last}"),
            )
            .note("the place is on what goes straight on beyond the end, as in APT4")
            .help("a curve counts its arcs, a surface its patches; in one of them it goes from 0 to 1"),
        );
    }

    /// How far a TABCYL goes straight on at its ends, and a RULED cylinder to both sides.
    pub(crate) fn prolongation(&self) -> f64 {
        TABCYL_END_INCHES * Units::Inches.mm() / self.state.unit.mm()
    }

    /// The message about a form that is not carried out, where `definition` is one.
    fn refused_form(&self, definition: &Definition) -> Option<Diagnostic> {
        let head = self.head_word(&definition.head)?;
        if let Some(reason) = no_geometry(head) {
            let message = format!("{head} is not carried out");
            let error = Diagnostic::error(codes::REFUSED_WORD, definition.head.span, message);
            return Some(error.note(reason));
        }
        let first = definition.args.first()?;
        let ExprKind::Name(name) = &first.kind else { return None };
        let reason = reason_of(self.synonyms.word(name)?)?;
        let message = format!("this form of {head} is not carried out");
        Some(Diagnostic::error(codes::REFUSED_WORD, first.span, message).note(reason))
    }

    /// Refuses a SSURF that has no area: its curves fall together, or it was turned by nothing.
    fn area(&mut self, form: &Form, args: &[define::Arg], span: Span) -> Known<()> {
        let Form::Ssurf(surface) = form else { return Ok(()) };
        if surface.extent().points > FEW_POINTS || surface.only_checks() {
            return Ok(());
        }
        let Ok(fitted) = self.fits.surface(surface) else { return Ok(()) };
        if fitted.has_area() {
            return Ok(());
        }
        let why = match args.first().map(|a| &a.value) {
            Some(define::Value::Word(word::SMESH | word::GMESH)) => {
                "its splines lie along each other: give them side by side"
            }
            Some(define::Value::Word(word::REVOLV)) => "the curve lies on the axis",
            Some(define::Value::Word(word::RULED | word::GENCUR)) => {
                "its curves lie along each other: give two that lie apart"
            }
            _ => "what it is made of runs one way only",
        };
        let message = "this SSURF has no area".to_owned();
        self.error(Diagnostic::error(codes::DEPENDENT, span, message).note(why));
        Err(Poisoned)
    }

    fn no_definition(&mut self, definition: &Definition) -> Poisoned {
        let head = &definition.head;
        if let Some(message) = self.head_word(head).and_then(|w| untranslated(w, head.span)) {
            self.error(message);
            return Poisoned;
        }
        let text = self.interner.text(head.symbol).to_owned();
        let mut message =
            Diagnostic::error(codes::NO_GEOMETRY, head.span, format!("{text} defines no geometry"));
        let begun = define::begun_with(self.head_word(head));
        if !begun.is_empty() {
            message = message.help(format!("it is a modifier: {}", begun.join(", ")));
        } else if let Some(word) = closest(&text, |w| w.class() == Class::Geometry) {
            message = message.help(format!("did you mean {word}?"));
        } else if !matches!(self.memory.slot(self.memory.place(head.symbol)).value, Value::Unset) {
            message = message.help("a division among arguments stands in brackets: (A/B)");
        }
        self.error(message);
        Poisoned
    }

    /// Gives `place` a value, unless it is of another kind already.
    pub(crate) fn assign(&mut self, place: Place, value: Value, target: &Target) -> Known<()> {
        self.assign_again(place, value, target, false)
    }

    fn assign_again(
        &mut self,
        place: Place,
        value: Value,
        target: &Target,
        again: bool,
    ) -> Known<()> {
        let slot = self.memory.slot(place);
        let (given, name_at) = (slot.given, target.name.span);
        match (&slot.value, &value) {
            (_, Value::Word(word)) => {
                let message = Diagnostic::error(
                    codes::WRONG_KIND,
                    target.span,
                    format!("the word {word} is no value that a name can have"),
                )
                .help("words are handed over by macro parameters only");
                self.error(message);
                self.memory.set(place, Value::Poison, target.span);
                return Err(Poisoned);
            }
            (Value::Form(_), Value::Form(_)) if again || self.state.redefinition => {}
            // The same statement once more, in a loop or a macro, is meant so, and elements of arrays
            // are filled again as in APT4.
            (Value::Form(_), Value::Form(_))
                if given == target.span || matches!(place, Place::Element(..)) => {}
            (Value::Form(old), Value::Form(_)) => {
                let (name, old) = (self.spelled(place), old.kind().word());
                self.error(
                    Diagnostic::warning(
                        codes::REDEFINED,
                        name_at,
                        format!("{name} is defined a second time"),
                    )
                    .label("from here on it is the new one")
                    .also(given, format!("it is a {old} since here"))
                    .help("write CANON/ON before it when this is meant"),
                );
            }
            (Value::Form(old), _) => {
                let old = old.kind().word();
                return Err(self.kind_changed(place, given, target, old, "a number"));
            }
            (Value::Number(_) | Value::Logical(_), Value::Form(new)) => {
                let new = new.kind().word();
                return Err(self.kind_changed(place, given, target, "number", &format!("a {new}")));
            }
            _ => {}
        }
        self.memory.set(place, value, target.span);
        Ok(())
    }

    fn kind_changed(
        &mut self,
        place: Place,
        given: Span,
        target: &Target,
        old: &str,
        new: &str,
    ) -> Poisoned {
        let name = self.spelled(place);
        self.error(
            Diagnostic::error(
                codes::KIND_CHANGED,
                target.span,
                format!("{name} is a {old} and cannot become {new}"),
            )
            .also(given, format!("it is a {old} since here"))
            .help("use another name"),
        );
        self.memory.set(place, Value::Poison, target.span);
        Poisoned
    }

    /// A form as the present reference system sees it.
    pub(crate) fn in_system(&mut self, form: &Arc<Form>, span: Span) -> Known<Arc<Form>> {
        let Some(system) = &self.state.refsys else { return Ok(Arc::clone(form)) };
        let kept = Arc::as_ptr(form).addr();
        if let Some([_, carried]) = self.state.carried.get(&kept) {
            return Ok(Arc::clone(carried));
        }
        let carried = system.inverse().and_then(|m| form.transformed(&m).ok()).map(Arc::new);
        match carried {
            Some(carried) => {
                // Of points a new one costs less than to keep it.
                if !matches!(**form, Form::Point(_) | Form::Vector(_)) {
                    let both = [Arc::clone(form), Arc::clone(&carried)];
                    self.state.carried.insert(kept, both);
                }
                Ok(carried)
            }
            None => {
                self.error(Diagnostic::error(
                    codes::NOT_CARRIED,
                    span,
                    format!("this {} has no form in the reference system", form.kind().word()),
                ));
                Err(Poisoned)
            }
        }
    }

    /// The point over (x, y) on ZSURF, all in the present reference system.
    pub(crate) fn on_zsurf(&self, x: f64, y: f64) -> Vec3 {
        define::on_zsurf(self.state.zsurf, x, y)
    }
}

impl From<Arg> for define::Arg {
    fn from(arg: Arg) -> Self {
        let value = match arg.kind {
            ArgKind::Empty | ArgKind::Name(_) => define::Value::Empty,
            ArgKind::Number(n) | ArgKind::Digits(n) => define::Value::Number(n),
            ArgKind::Word(word) => define::Value::Word(word),
            ArgKind::Form { form, name } => define::Value::Form { form, name },
            ArgKind::Text(text) => define::Value::Text(text),
        };
        Self::new(value, arg.span)
    }
}

/// Why no definition that this word begins the arguments of is carried out.
pub(crate) fn reason_of(word: Word) -> Option<&'static str> {
    match word {
        word::FETCH => Some(
            "it took a form from a library file of 1977 whose records were never published, and SSV3 \
             refuses it too; saved surfaces, and those of JSON, IGES, STEP and STL, are read by READ/1,name",
        ),
        word::HEX => no_geometry(word::HEX),
        _ => None,
    }
}

/// An argument in words: `number 3`, `line L1`, `TO`.
pub(crate) fn describe(arg: &Arg) -> String {
    match &arg.kind {
        ArgKind::Empty => "an empty field".to_owned(),
        ArgKind::Number(n) | ArgKind::Digits(n) => format!("the number {n}"),
        ArgKind::Word(word) => word.text().to_owned(),
        ArgKind::Name(_) => "a name".to_owned(),
        ArgKind::Form { form, name } => {
            let kind = form.kind().word();
            match (name.name.as_str(), name.subscript) {
                ("", _) => format!("an unnamed {kind}"),
                (symbol, 0) => format!("the {kind} {symbol}"),
                (symbol, i) => format!("the {kind} {symbol}({i})"),
            }
        }
        ArgKind::Text(text) => format!("the text '{text}'"),
    }
}
