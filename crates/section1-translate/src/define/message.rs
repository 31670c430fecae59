//! The messages of definitions that fail: one place for all their words.

use aptc_diagnostics::{Code, Diagnostic, Span, codes};
use aptc_geometry::{Form, NotCarried, Vec3, trig};
use aptc_vocabulary::{Class, Word, word};

use super::arg::{in_words, short};
use super::fault::Fault;
use super::mismatch::Mismatch;
use super::{Arg, DefineError, Value};

impl DefineError {
    /// The message to the user. `args` are those that were given to [`super::define`], `statement` is the
    /// place of the whole definition.
    pub fn diagnostic(&self, args: &[Arg], statement: Span) -> Diagnostic {
        let words = Words { args, statement };
        match self {
            Self::NoWord { head } if head.is(Class::Geometry) => Diagnostic::error(
                codes::NO_SUCH_FORMAT,
                statement,
                format!("{head} has no form by CANON"),
            )
            .help(format!("define it by its formats: aptc explain {head} shows them")),
            Self::NoWord { head } => Diagnostic::error(
                codes::NO_SUCH_FORMAT,
                statement,
                format!("{head} defines no geometry"),
            ),
            Self::NoSuchFormat { head, at, mismatch, candidates } => {
                words.no_such_format(*head, *at, mismatch, candidates)
            }
            Self::NoForm { head, fault } => words.no_form(*head, fault),
            Self::NotCarried { at, why } => {
                let (span, what) = match at {
                    Some(at) => (words.span(*at), words.name(*at)),
                    None => (statement, "the result".to_owned()),
                };
                let why = match why {
                    NotCarried::Flat => "the matrix flattens space",
                    NotCarried::Unequal => "the matrix does not scale all directions alike",
                };
                Diagnostic::error(
                    codes::NOT_CARRIED,
                    span,
                    format!("{what} cannot be carried by the REFSYS matrix: {why}"),
                )
                .help("use a REFSYS matrix of rotations, translations and one scale")
            }
            Self::FlatSystem => Diagnostic::error(
                codes::NOT_CARRIED,
                statement,
                "the REFSYS matrix flattens space, so nothing can be defined in its system",
            )
            .help("use a REFSYS matrix of rotations, translations and one scale"),
        }
    }
}

/// The words of one statement.
struct Words<'a> {
    args: &'a [Arg],
    statement: Span,
}

impl Words<'_> {
    /// Place of argument `at`; the end of the last one when it is missing.
    fn span(&self, at: usize) -> Span {
        match (self.args.get(at), self.args.last()) {
            (Some(arg), _) => arg.span,
            (None, Some(last)) => Span::new(last.span.file, last.span.end, last.span.end),
            (None, None) => self.statement,
        }
    }

    fn name(&self, at: usize) -> String {
        self.args.get(at).map_or_else(|| "nothing".to_owned(), Arg::describe)
    }

    fn is_number(&self, at: usize) -> bool {
        matches!(self.args.get(at).map(|a| &a.value), Some(Value::Number(_)))
    }

    fn is_named(&self, at: usize) -> bool {
        matches!(self.args.get(at).map(|a| &a.value), Some(Value::Form { name, .. }) if !name.name.is_empty())
    }

    /// The argument with its canonical form.
    fn full(&self, at: usize) -> String {
        match self.args.get(at) {
            Some(arg) => match arg.form() {
                // An unnamed form is described by its numbers already.
                Some(form) if self.is_named(at) => {
                    format!("{} is {}", arg.describe(), in_words(form))
                }
                _ => arg.describe(),
            },
            None => "nothing".to_owned(),
        }
    }

    fn no_such_format(
        &self,
        head: Word,
        at: usize,
        mismatch: &Mismatch,
        candidates: &[String],
    ) -> Diagnostic {
        let found = self.name(at);
        let end = at >= self.args.len();
        let (code, here) = match mismatch {
            Mismatch::OtherWord(wanted) => {
                (codes::NO_SUCH_FORMAT, format!("expected {wanted}, found {found}"))
            }
            Mismatch::Missing(item) if end => {
                (codes::NO_SUCH_FORMAT, format!("{item} is missing at the end"))
            }
            Mismatch::Missing(item) => {
                (codes::NO_SUCH_FORMAT, format!("{item} is missing before {found}"))
            }
            Mismatch::Swapped => {
                let before = self.name(at - 1);
                (codes::NO_SUCH_FORMAT, format!("{found} should stand before {before}"))
            }
            Mismatch::OtherKind(wanted) => {
                (codes::WRONG_ARGUMENT, format!("expected a {wanted}, found {found}"))
            }
            Mismatch::Extra => (codes::NO_SUCH_FORMAT, format!("{found} is one argument too many")),
            Mismatch::Unread(expected) => {
                let one_of = match expected.as_slice() {
                    [] => "nothing".to_owned(),
                    [one] => one.clone(),
                    [most @ .., last] => format!("{} or {last}", most.join(", ")),
                };
                let here = if end {
                    format!("the statement ends where {one_of} is expected")
                } else {
                    format!("expected {one_of}, found {found}")
                };
                (codes::NO_SUCH_FORMAT, here)
            }
        };
        let given = self.args.iter().map(Arg::class).collect::<Vec<_>>().join(",");
        let message = match code {
            codes::WRONG_ARGUMENT => format!("{head}: {here}"),
            _ => format!("no format of {head} reads {head}/{given}: {here}"),
        };
        let mut d = self.error(code, at, message).label(here);
        let (shown, hidden) = candidates.split_at(candidates.len().min(6));
        for format in shown {
            d = d.note(format!("the format is {head}/{format}"));
        }
        if !hidden.is_empty() {
            d = d.note(format!("and {} more", hidden.len()));
        }
        d
    }

    fn error(&self, code: Code, at: usize, message: String) -> Diagnostic {
        Diagnostic::error(code, self.span(at), message)
    }

    /// An error that two arguments make together.
    fn both(&self, code: Code, a: usize, b: usize, message: String) -> Diagnostic {
        self.error(code, b, message)
            .label(self.name(b))
            .also(self.span(a), self.name(a))
            .note(self.full(a))
            .note(self.full(b))
    }

    #[expect(clippy::too_many_lines, reason = "one row a fault; splitting would hide the table")]
    fn no_form(&self, head: Word, fault: &Fault) -> Diagnostic {
        match fault {
            Fault::Kind { at } => self.error(
                codes::WRONG_ARGUMENT,
                *at,
                format!("{head} cannot use {} here", self.name(*at)),
            ),
            Fault::NotFinite { at } => self.error(
                codes::OUT_OF_RANGE,
                *at,
                "this number is infinite or undefined".to_owned(),
            ),
            Fault::Parallel { a, b, one, other } => {
                let sine = one.n.cross(&other.n).norm();
                let angle = trig::asin(sine.min(1.0)).to_degrees();
                let sign = one.n.dot(&other.n).signum();
                let gap = (one.d - sign * other.d).abs();
                let (x, y) = (self.name(*a), self.name(*b));
                self.both(
                    codes::PARALLEL,
                    *a,
                    *b,
                    format!("{x} and {y} do not meet: they are parallel, {} apart", short(gap)),
                )
                .note(format!("the angle between them is {} degrees", short(angle)))
            }
            Fault::OneDirection { planes: [a, b, c], along } => self
                .both(
                    codes::PARALLEL,
                    *a,
                    *c,
                    format!(
                        "{}, {} and {} have no single point in common: all three are parallel to \
                         ({})",
                        self.name(*a),
                        self.name(*b),
                        self.name(*c),
                        vector(along)
                    ),
                )
                .also(self.span(*b), self.name(*b))
                .note(self.full(*b)),
            Fault::Apart { a, b, gap } => {
                let (x, y) = (self.name(*a), self.name(*b));
                let gap = if gap.is_finite() {
                    format!("they miss each other by {}", short(*gap))
                } else {
                    "they have no point in common".to_owned()
                };
                self.both(codes::APART, *a, *b, format!("{x} and {y} do not meet: {gap}"))
            }
            Fault::LineMisses { p, to, on } => {
                let (x, y, s) = (self.name(*p), self.name(*to), self.name(*on));
                let joins = match self.args.get(*to).and_then(Arg::form) {
                    Some(Form::Vector(_)) => "along",
                    _ => "and",
                };
                let text = format!("the line through {x} {joins} {y} does not meet {s}");
                self.both(codes::APART, *p, *on, text)
                    .also(self.span(*to), self.name(*to))
                    .note(self.full(*to))
            }
            Fault::OutOfReach { a, b, gap } => {
                let (x, y) = (self.name(*a), self.name(*b));
                let text = format!("no circle of this radius touches {x} and {y} in this way");
                let d = self.both(codes::APART, *a, *b, text);
                let d = if gap.is_finite() {
                    d.note(format!("it would miss the second by {}", short(*gap)))
                } else {
                    d
                };
                d.help("another radius, or IN for OUT, or the other side of the line")
            }
            Fault::Coincide { a, b } if self.is_number(*a) && self.is_number(*b) => self
                .error(codes::COINCIDE, *b, format!("two points of this {head} fall together"))
                .label("the second begins here")
                .also(self.span(*a), "the first begins here"),
            Fault::Coincide { a, b } if self.is_named(*a) && self.name(*a) == self.name(*b) => self
                .error(codes::COINCIDE, *b, format!("{} is given twice", self.name(*b)))
                .label("here again")
                .also(self.span(*a), "here"),
            Fault::Coincide { a, b } => {
                let (x, y) = (self.name(*a), self.name(*b));
                self.both(codes::COINCIDE, *a, *b, format!("{x} and {y} fall together"))
            }
            Fault::Dependent { places, what } => {
                let names: Vec<String> = places.iter().map(|p| self.name(*p)).collect();
                let last = places.last().copied().unwrap_or(0);
                let mut d = self.error(
                    codes::DEPENDENT,
                    last,
                    format!("{} do not fix a {head}: {what}", names.join(", ")),
                );
                for place in places.iter().filter(|p| self.is_named(**p)) {
                    d = d.note(self.full(*place));
                }
                d
            }
            Fault::Misplaced { at, by, what, amount } => self.both(
                codes::MISPLACED,
                *by,
                *at,
                format!("{} {what} {} by {}", self.name(*at), self.name(*by), short(*amount)),
            ),
            Fault::NoLength { at } => self
                .error(
                    codes::NO_LENGTH,
                    *at,
                    format!("{} has no length, so it gives no direction", self.name(*at)),
                )
                .note(self.full(*at)),
            Fault::Aligned { a, b, what } => self.both(
                codes::DEPENDENT,
                *a,
                *b,
                format!("{} and {} {what}", self.name(*a), self.name(*b)),
            ),
            Fault::Range { at, value, need } => self.error(
                codes::OUT_OF_RANGE,
                *at,
                format!("{head} wants a number {need} here, found {}", short(*value)),
            ),
            Fault::Leans { at, normal } => {
                let wants = if head == word::CIRCLE
                    || self
                        .args
                        .get(*at)
                        .is_some_and(|a| matches!(a.class(), "circle" | "cylinder"))
                {
                    "its axis is not that of z"
                } else {
                    "it is not parallel to the z axis, so it is no line"
                };
                self.error(
                    codes::LEANS,
                    *at,
                    format!("{} cannot be used here: {wants}", self.name(*at)),
                )
                .label(format!("its direction is ({})", vector(normal)))
                .note(self.full(*at))
            }
            Fault::Undecided { at, one, other } => self
                .error(
                    codes::UNDECIDED,
                    *at,
                    format!(
                        "{} does not choose between the solutions ({}) and ({})",
                        self.name(*at),
                        vector(one),
                        vector(other)
                    ),
                )
                .help(other_axis(self.args.get(*at).and_then(Arg::word))),
            Fault::NoSide { at, normal } => self
                .error(codes::UNDECIDED, *at, format!("{} names no side here", self.name(*at)))
                .label(format!("the sides lie along ({})", vector(normal)))
                .help(other_axis(self.args.get(*at).and_then(Arg::word))),
            Fault::NothingThere { at, what } => self.error(
                codes::NOTHING_THERE,
                *at,
                format!("there is no {head} on the side that {} names: {what}", self.name(*at)),
            ),
            Fault::Flat { at } => self
                .error(
                    codes::FLAT_MATRIX,
                    *at,
                    format!("{} flattens space and has no inverse", self.name(*at)),
                )
                .note(self.full(*at)),
            Fault::Skew { at } => self
                .error(
                    codes::FLAT_MATRIX,
                    *at,
                    format!("{} does not keep angles, which this {head} needs", self.name(*at)),
                )
                .help("use rotations, translations and one scale"),
            Fault::NoFoot { p, at, what } => self.both(
                codes::APART,
                *p,
                *at,
                format!("{} gives no line: {what} {}", self.name(*p), self.name(*at)),
            ),
            Fault::NotSquare { a, b, degrees } => self.both(
                codes::NOT_SQUARE,
                *a,
                *b,
                format!(
                    "{} and {} are not at right angles: {} degrees",
                    self.name(*a),
                    self.name(*b),
                    short(*degrees)
                ),
            ),
            Fault::NoSuchPoint { at, value, n } => self.error(
                codes::NO_SUCH_POINT,
                *at,
                format!("the pattern has points 1 to {n}, none is {}", short(*value)),
            ),
            Fault::TooMany { at, limit } => self
                .error(
                    codes::TOO_MANY_POINTS,
                    *at,
                    format!("this {head} would have more than {limit} points"),
                )
                .help("split it, or raise the limit of points"),
            Fault::TooFew { at, need, found, what } => self.error(
                codes::TOO_FEW,
                *at,
                format!("this {head} needs at least {need} {what}, found {found}"),
            ),
            Fault::TooManyConditions { at, need, found } => self
                .error(
                    codes::DEPENDENT,
                    *at,
                    format!("a conic meets {need} points and tangents at most, found {found}"),
                )
                .help("use SPLINE, or COMBIN of several CURSEGs"),
            Fault::OtherCount { at, need, found } => self.error(
                codes::TOO_FEW,
                *at,
                format!("this spline has {found} points, the first of the mesh has {need}"),
            ),
            Fault::TooDeep { limit } => Diagnostic::error(
                codes::TOO_MANY_POINTS,
                self.statement,
                format!("this {head} holds definitions within each other, more than {limit} deep"),
            ),
            Fault::NotFitted { at, why } => {
                let name = self.name(*at);
                self.error(codes::NO_FIT, *at, format!("{name} cannot be fitted: {why}"))
            }
            Fault::NoSuchPart { at, value, n, whole } => self.error(
                codes::NO_SUCH_POINT,
                *at,
                format!("{whole} 1 to {n}, none is {}", short(*value)),
            ),
            Fault::NoVector { at } => self
                .error(
                    codes::NO_LENGTH,
                    *at,
                    format!("there is no {} at this place", self.name(*at)),
                )
                .help("a curve has CRSSPL and NORMAL only where its definition gives CRSSPL"),
            Fault::Unexpected { at, expected } => {
                let found = self.name(*at);
                self.error(
                    codes::NO_SUCH_FORMAT,
                    *at,
                    format!("{head} expects {expected} here, found {found}"),
                )
                .label(format!("expected {expected}"))
            }
            Fault::NoCurve { what } => {
                Diagnostic::error(codes::NO_CURVE, self.statement, format!("this {head} {what}"))
            }
            Fault::NotConverged { at, turn_deg, residual } => self
                .error(
                    codes::NO_FIT,
                    *at,
                    format!(
                        "SPLINE has no curve of one curvature through this point, where the chords turn \
                         by {} degrees",
                        short(*turn_deg)
                    ),
                )
                .note(if residual.is_finite() {
                    let off = short(*residual);
                    format!("the nearest curve bends by {off} more on one side, over the length of a chord")
                } else {
                    "the curve would have to turn back over its chords".into()
                })
                .help("give more points where the curve turns sharply, or TWOPT in place of SPLINE"),
            Fault::Overhang { at, degrees } => self
                .error(
                    codes::NO_FIT,
                    *at,
                    format!(
                        "the curve would leave the chord at {} degrees at this point",
                        short(*degrees)
                    ),
                )
                .help("give more points where the curve turns sharply"),
            Fault::Elements { at, need, found } => self.error(
                codes::CANON_ELEMENTS,
                *at,
                format!("the canonical form of {head} has {need} elements, found {found}"),
            ),
            Fault::OtherKind { found } => Diagnostic::error(
                codes::CANON_ELEMENTS,
                self.statement,
                format!("CANON alters a {head} by a {head}, found a {found}"),
            ),
            Fault::NoNormal { at } => self.error(
                codes::CANON_ELEMENTS,
                *at,
                match head {
                    word::PLANE | word::LINE => format!(
                        "the normal of this {head} has no length: the numbers that give it are all 0"
                    ),
                    _ => format!(
                        "the axis of this {head} has no length: the numbers that give it are all 0"
                    ),
                },
            ),
        }
    }
}

/// What to write instead of a modifier that decides nothing.
fn other_axis(word: Option<Word>) -> &'static str {
    match word.map(Word::text) {
        Some("XLARGE" | "XSMALL") => "choose by YLARGE or YSMALL",
        Some("YLARGE" | "YSMALL") => "choose by XLARGE or XSMALL",
        Some("POSX" | "NEGX") => "choose by POSY, NEGY, POSZ or NEGZ",
        Some("POSY" | "NEGY") => "choose by POSX, NEGX, POSZ or NEGZ",
        Some("POSZ" | "NEGZ") => "choose by POSX, NEGX, POSY or NEGY",
        _ => "choose by another axis",
    }
}

fn vector(v: &Vec3) -> String {
    format!("{}, {}, {}", short(v.x), short(v.y), short(v.z))
}
