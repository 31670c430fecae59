//! Format tables: patterns of argument classes, matching, and what to say when none fits.

use aptc_geometry::{
    Circle, Cylinder, Form, FormKind, Line, Pattern, Plane, Quadric, Tabcyl, Transform, Vec2, Vec3,
};
use aptc_vocabulary::Word;

use super::fault::Fault;
use super::{Arg, Context, DefineError, Value};

/// What may stand at a place of a format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Item {
    /// A number.
    N,
    /// A number, and what it is.
    Num(&'static str),
    /// This word.
    W(Word),
    /// One of these words.
    Of(&'static [Word]),
    /// A point: POINT or `(x,y,z)`.
    P,
    /// A point, or its two coordinates as two numbers.
    XY,
    /// A vector.
    V,
    /// A vector, or a point as the vector from the origin to it.
    PV,
    /// A line, or a plane parallel to z as APT4 has it.
    L,
    /// A plane, or a line as the vertical plane that it is.
    PL,
    /// A circle, or a cylinder along z as APT4 has it.
    C,
    /// A conic or quadric.
    K,
    /// A tabulated cylinder.
    TC,
    /// A pattern.
    PT,
    /// A matrix.
    M,
    /// A line, plane parallel to z, circle or cylinder along z.
    LC,
    /// A sculptured curve.
    SC,
    /// A sculptured surface.
    SS,
    /// A surface that RLDSRF may cut.
    S,
    /// Any surface, sculptured or not.
    AS,
    /// Whatever follows; the solver reads it. The text tells what is expected.
    Rest(&'static str),
    /// The same, or the end.
    Tail(&'static str),
}

/// How the arguments of a format become a form.
pub(super) type Solve = fn(&Args<'_>) -> Result<Form, Fault>;

/// One row of a table.
#[derive(Clone, Copy, Debug)]
pub(super) struct Format {
    /// The pattern.
    pub(super) items: &'static [Item],
    /// Its solution.
    pub(super) solve: Solve,
}

/// A row of a table.
pub(super) const fn row(items: &'static [Item], solve: Solve) -> Format {
    Format { items, solve }
}

/// The arguments of a matched format.
pub(super) struct Args<'a> {
    /// The major word.
    pub(super) head: Word,
    /// The arguments.
    pub(super) list: &'a [Arg],
    /// What stands around.
    pub(super) context: &'a Context,
}

/// Finds the format of `args` in `table` and solves it.
pub(super) fn solve(
    head: Word,
    table: &'static [Format],
    args: &[Arg],
    context: &Context,
) -> Result<Form, DefineError> {
    for (i, arg) in args.iter().enumerate() {
        if matches!(arg.value, Value::Number(n) if !n.is_finite()) {
            return Err(DefineError::from_fault(head, Fault::NotFinite { at: i }));
        }
    }
    let Some(format) = table.iter().find(|f| f.fits(args)) else {
        return Err(super::mismatch::explain(head, table, args));
    };
    let matched = Args { head, list: args, context };
    (format.solve)(&matched).map_err(|fault| DefineError::from_fault(head, fault))
}

impl Format {
    /// Do the arguments fit?
    pub(super) fn fits(&self, args: &[Arg]) -> bool {
        reach(self.items.iter(), args.iter()) == Reach::All
    }

    /// The pattern in the notation of the manuals: `XLARGE|XSMALL,INTOF,line,circle`.
    pub(super) fn text(&self) -> String {
        self.items.iter().map(Item::text).collect::<Vec<_>>().join(",")
    }
}

/// How far a format went.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Reach {
    /// To the end.
    All,
    /// To this argument, which does not fit.
    Stops(usize),
}

/// How far the arguments fit the items.
pub(super) fn reach<'a, 'b>(
    items: impl Iterator<Item = &'a Item>,
    args: impl Iterator<Item = &'b Arg>,
) -> Reach {
    let mut args = args.peekable();
    let mut at = 0;
    for item in items {
        if matches!(item, Item::Tail(_)) {
            return Reach::All;
        }
        let Some(arg) = args.next() else { return Reach::Stops(at) };
        let fits = match item {
            Item::Rest(_) => return Reach::All,
            // Two numbers stand for a point.
            Item::XY if Item::N.takes(arg) => {
                let pair = args.next_if(|a| Item::N.takes(a)).is_some();
                at += usize::from(pair);
                pair
            }
            item => item.takes(arg),
        };
        if !fits {
            return Reach::Stops(at);
        }
        at += 1;
    }
    if args.peek().is_none() { Reach::All } else { Reach::Stops(at) }
}

impl Item {
    /// Does `arg` fit here?
    pub(crate) fn takes(&self, arg: &Arg) -> bool {
        match (self, &arg.value) {
            (Self::Rest(_) | Self::Tail(_), _) | (Self::N | Self::Num(_), Value::Number(_)) => true,
            (Self::W(word), Value::Word(found)) => word == found,
            (Self::Of(words), Value::Word(found)) => words.contains(found),
            (Self::P | Self::PV | Self::XY, Value::Tuple { .. }) => true,
            (item, Value::Form { form, .. }) => item.takes_form(form.shape()),
            _ => false,
        }
    }

    /// May it be this word?
    pub(crate) fn is_word(&self, word: Word) -> bool {
        match self {
            Self::W(w) => *w == word,
            Self::Of(words) => words.contains(&word),
            _ => false,
        }
    }

    fn takes_form(&self, form: &Form) -> bool {
        match self {
            Self::P | Self::XY => matches!(form, Form::Point(_)),
            Self::V => matches!(form, Form::Vector(_)),
            Self::PV => matches!(form, Form::Point(_) | Form::Vector(_)),
            Self::L | Self::PL => matches!(form, Form::Line(_) | Form::Plane(_)),
            Self::C => matches!(form, Form::Circle(_) | Form::Cylinder(_)),
            Self::K => matches!(form, Form::Quadric(_)),
            Self::TC => matches!(form, Form::Tabcyl(_)),
            Self::PT => matches!(form, Form::Pattern(_)),
            Self::M => matches!(form, Form::Matrix(_)),
            Self::LC => {
                matches!(form, Form::Line(_) | Form::Plane(_) | Form::Circle(_) | Form::Cylinder(_))
            }
            Self::SC => matches!(form, Form::Scurv(_)),
            Self::SS => matches!(form, Form::Ssurf(_)),
            Self::S => !matches!(
                form,
                Form::Point(_)
                    | Form::Vector(_)
                    | Form::Matrix(_)
                    | Form::Pattern(_)
                    | Form::Scurv(_)
                    | Form::Ssurf(_)
                    | Form::Solid(_)
            ),
            Self::AS => Self::S.takes_form(form) || Self::SS.takes_form(form),
            Self::N | Self::Num(_) | Self::W(_) | Self::Of(_) | Self::Rest(_) | Self::Tail(_) => {
                false
            }
        }
    }

    /// The item in words.
    pub(crate) fn text(&self) -> String {
        match self {
            Self::N | Self::Num(_) => "number",
            Self::W(word) => word.text(),
            Self::Of(words) => {
                return words.iter().map(|w| w.text()).collect::<Vec<_>>().join("|");
            }
            Self::P => "point",
            Self::XY => "point",
            Self::V => "vector",
            Self::PV => "vector",
            Self::L => "line",
            Self::PL => "plane",
            Self::C => "circle",
            Self::K => "conic",
            Self::TC => "TABCYL",
            Self::PT => "pattern",
            Self::M => "matrix",
            Self::LC => "line|circle",
            Self::SC => "sculptured curve",
            Self::SS => "sculptured surface",
            Self::S | Self::AS => "surface",
            Self::Rest(text) | Self::Tail(text) => text,
        }
        .to_owned()
    }

    /// The item in words where it is missing: what a number is.
    pub(crate) fn missed(&self) -> String {
        match self {
            Self::Num(what) => (*what).to_owned(),
            item => item.text(),
        }
    }
}

/// A vertical component of a plane's unit normal, or a horizontal one of an axis, below which the plane
/// still counts as a line and the cylinder as a circle. Larger than what rounding leaves after a rotation.
const UPRIGHT: f64 = 1e-9;

/// Arguments by place and kind. A place that holds something else is a fault of the table, answered by
/// [`Fault::Kind`] so that a table's mistake cannot panic.
impl Args<'_> {
    fn kind<T>(&self, at: usize) -> Result<T, Fault> {
        Err(Fault::Kind { at })
    }

    /// How many arguments.
    pub(super) fn len(&self) -> usize {
        self.list.len()
    }

    /// The number at `at`.
    pub(super) fn number(&self, at: usize) -> Result<f64, Fault> {
        match self.list.get(at).map(|a| &a.value) {
            Some(Value::Number(n)) => Ok(*n),
            _ => self.kind(at),
        }
    }

    /// `N` numbers from `at` on.
    pub(super) fn numbers<const N: usize>(&self, at: usize) -> Result<[f64; N], Fault> {
        let mut out = [0.0; N];
        for (i, n) in out.iter_mut().enumerate() {
            *n = self.number(at + i)?;
        }
        Ok(out)
    }

    /// Is there a number at `at`?
    pub(super) fn is_number(&self, at: usize) -> bool {
        matches!(self.list.get(at).map(|a| &a.value), Some(Value::Number(_)))
    }

    /// A number at `at` that must be greater than zero.
    pub(super) fn positive(&self, at: usize) -> Result<f64, Fault> {
        let value = self.number(at)?;
        if value > 0.0 { Ok(value) } else { Err(Fault::Range { at, value, need: "above 0" }) }
    }

    /// A whole number at `at` from `least` up, bounded by the limit of points.
    pub(super) fn count(&self, at: usize, least: u32) -> Result<usize, Fault> {
        let value = self.number(at)?;
        let whole = value.round();
        if (value - whole).abs() > 1e-6 || whole < f64::from(least) {
            let need =
                if least > 1 { "that is whole and 2 or more" } else { "that is whole and above 0" };
            return Err(Fault::Range { at, value, need });
        }
        let limit = self.context.max_points;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "the cast saturates, and what is above the limit is refused"
        )]
        let n = whole as usize;
        if n > limit { Err(Fault::TooMany { at, limit }) } else { Ok(n) }
    }

    /// The word at `at`.
    pub(super) fn word(&self, at: usize) -> Result<Word, Fault> {
        self.list.get(at).and_then(Arg::word).map_or_else(|| self.kind(at), Ok)
    }

    /// Does `word` stand at `at`?
    pub(super) fn is(&self, at: usize, word: Word) -> bool {
        self.list.get(at).and_then(Arg::word) == Some(word)
    }

    /// The form at `at`.
    pub(super) fn form(&self, at: usize) -> Result<&Form, Fault> {
        self.list.get(at).and_then(Arg::form).map_or_else(|| self.kind(at), Ok)
    }

    /// The point at `at`.
    pub(super) fn point(&self, at: usize) -> Result<Vec3, Fault> {
        match self.list.get(at).map(|a| &a.value) {
            Some(Value::Tuple { x, y, z: Some(z) }) => Ok(Vec3::new(*x, *y, *z)),
            Some(Value::Tuple { x, y, z: None }) => Ok(self.context.on_zsurf(*x, *y)),
            _ => match self.form(at)? {
                Form::Point(p) => Ok(*p),
                _ => self.kind(at),
            },
        }
    }

    /// Is there a point at `at`?
    pub(super) fn is_point(&self, at: usize) -> bool {
        self.point(at).is_ok()
    }

    /// The point at `at`, seen along z.
    pub(super) fn point2(&self, at: usize) -> Result<Vec2, Fault> {
        self.point(at).map(|p| p.xy())
    }

    /// The vector at `at`, perhaps given as a point.
    pub(super) fn vector(&self, at: usize) -> Result<Vec3, Fault> {
        match self.list.get(at).and_then(Arg::form) {
            Some(Form::Vector(v)) => Ok(*v),
            _ => self.point(at),
        }
    }

    /// The direction of the vector at `at`, which must have one.
    pub(super) fn direction(&self, at: usize) -> Result<Vec3, Fault> {
        self.vector(at)?.try_normalize(0.0).ok_or(Fault::NoLength { at })
    }

    /// The line at `at`. A LINE that REFSYS has tilted is taken at its trace in the xy plane of the system.
    pub(super) fn line(&self, at: usize) -> Result<Line, Fault> {
        let tilted = match self.list.get(at).map(|a| &a.value) {
            Some(Value::Form { form, .. }) => form.kind() == FormKind::Line,
            _ => false,
        };
        match self.form(at)? {
            Form::Plane(p) if tilted && p.n.xy().norm() > UPRIGHT => {
                Line::new(p.n.x, p.n.y, p.d).map_or_else(|| self.kind(at), Ok)
            }
            Form::Line(l) => Ok(*l),
            Form::Plane(p) if p.n.z.abs() <= UPRIGHT => {
                Line::new(p.n.x, p.n.y, p.d).map_or_else(|| self.kind(at), Ok)
            }
            Form::Plane(p) => Err(Fault::Leans { at, normal: p.n }),
            _ => self.kind(at),
        }
    }

    /// The plane at `at`.
    pub(super) fn plane(&self, at: usize) -> Result<Plane, Fault> {
        match self.form(at)? {
            Form::Plane(p) => Ok(*p),
            Form::Line(l) => Ok(l.plane()),
            _ => self.kind(at),
        }
    }

    /// The circle at `at`, whose axis must be that of z.
    pub(super) fn circle(&self, at: usize) -> Result<Circle, Fault> {
        let (center, axis, radius) = match self.form(at)? {
            Form::Circle(c) => (c.center, c.axis, c.radius),
            Form::Cylinder(Cylinder { point, axis, radius }) => (*point, *axis, *radius),
            _ => return self.kind(at),
        };
        if axis.xy().norm() > UPRIGHT {
            return Err(Fault::Leans { at, normal: axis });
        }
        Ok(Circle { center, axis, radius })
    }

    /// Is there a CIRCLE at `at`, not a CYLNDR?
    pub(super) fn is_circle(&self, at: usize) -> bool {
        matches!(self.form(at), Ok(Form::Circle(_)))
    }

    /// The circle or cylinder at `at` with any axis.
    pub(super) fn circle_in_space(&self, at: usize) -> Result<Circle, Fault> {
        match self.form(at)? {
            Form::Circle(c) => Ok(*c),
            Form::Cylinder(c) => Ok(Circle { center: c.point, axis: c.axis, radius: c.radius }),
            _ => self.kind(at),
        }
    }

    /// The conic at `at`.
    pub(super) fn conic(&self, at: usize) -> Result<Quadric, Fault> {
        match self.form(at)? {
            Form::Quadric(q) => Ok(*q),
            _ => self.kind(at),
        }
    }

    /// The TABCYL at `at`.
    pub(super) fn tabcyl(&self, at: usize) -> Result<&Tabcyl, Fault> {
        match self.form(at)? {
            Form::Tabcyl(t) => Ok(t),
            _ => self.kind(at),
        }
    }

    /// The pattern at `at`.
    pub(super) fn pattern(&self, at: usize) -> Result<&Pattern, Fault> {
        match self.form(at)? {
            Form::Pattern(p) => Ok(p),
            _ => self.kind(at),
        }
    }

    /// The matrix at `at`.
    pub(super) fn matrix(&self, at: usize) -> Result<Transform, Fault> {
        match self.form(at)? {
            Form::Matrix(m) => Ok(*m),
            _ => self.kind(at),
        }
    }
}
