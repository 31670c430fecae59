//! The statement tree.
//!
//! One [`Statement`] for each statement of the text, in order, with the cards it stands on. Words and
//! symbols are not told apart here: a vocabulary word may be a symbol of an old program (`PT`, `TP`), so
//! a [`Name`] carries both its spelling and the word it may mean, and Section 1 decides.

use aptc_diagnostics::Span;
use aptc_vocabulary::Word;

use crate::Symbol;

/// A parsed file.
#[derive(Clone, Debug, Default)]
pub struct Program {
    /// The statements in order.
    pub statements: Vec<Statement>,
    /// Cards of the file but continuations, for the statement number of what is appended.
    pub n_cards: u32,
}

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// First to last byte of its text, without comment.
    pub span: Span,
    /// Line of its first card, from 1.
    pub line: u32,
    /// Number as APT counts: every card, blank and comment cards too, but not continuation cards.
    pub isn: u32,
    /// The label in front, `12)` or `LAB:`.
    pub label: Option<Name>,
    /// What it says.
    pub body: Body,
}

/// What a statement says.
#[derive(Clone, Debug, PartialEq)]
pub enum Body {
    /// A label alone.
    Empty,
    /// A fixed-field word with the rest of its card as text: PARTNO PPRINT INSERT REMARK TITLES. The text
    /// is as written, without the blanks around it; quotes of `PARTNO/'...'` are taken off.
    Text {
        /// The word.
        word: Word,
        /// Where the text stands.
        text_span: Span,
        /// The text.
        text: Box<str>,
    },
    /// `A=3*B`, `P(2)=POINT/1,2`, `PL=(PLANE/0,0,1,D)CANON`.
    Assign {
        /// What gets the value.
        target: Target,
        /// The value: an expression, or [`ExprKind::Define`].
        value: Expr,
    },
    /// Words joined by commas, the last perhaps with arguments: `RAPID,GOTO/P`, `TLLFT,GOLFT/L1,TO,L2`,
    /// `OBTAIN,LINE/L,A,B`, `FINI`. Never empty. A label of digits among the arguments, `JUMPTO/12`, is a
    /// number.
    Clauses(Box<[Clause]>),
    /// `M=MACRO/A,B=2`.
    Macro {
        /// Its name.
        name: Name,
        /// Its parameters.
        params: Box<[Param]>,
    },
    /// `CALL/M,A=1,B=TLLFT` also with further positional words; an argument without a name that is not a
    /// word alone (`CALL/PROG,SEC1,3`) has the name of no letters, `""`.
    Call {
        /// What is called.
        name: Name,
        /// `name=value`; a word alone has no value.
        args: Box<[Param]>,
    },
    /// `IF(expr)l1,l2,l3`.
    If {
        /// The number judged.
        value: Expr,
        /// Where to go for negative, zero, positive.
        targets: Box<[Name; 3]>,
    },
    /// `IF(expr)statement` of APT4.
    IfThen {
        /// The condition.
        condition: Expr,
        /// What is done when it holds; never a labelled statement or a macro.
        then: Box<Body>,
    },
    /// `DO/label,var=first,last[,step]`.
    Do {
        /// Label of the last statement of the loop.
        label: Name,
        /// The running variable.
        variable: Name,
        /// First value.
        first: Box<Expr>,
        /// Last value.
        last: Box<Expr>,
        /// Step, 1 when left out.
        step: Option<Box<Expr>>,
    },
    /// `SYN/new,old,...`, `JUMPTO/label`, `TRANTO/label` and so on are clauses. This one could not be
    /// read; a diagnostic was given, or that of the statement before stands for both. The names are those that it would have defined, so that their
    /// users stay silent.
    Error {
        /// Name left of `=`.
        defines: Option<Name>,
        /// Names of definitions in brackets, and of the variable of a DO.
        within: Box<[Name]>,
    },
}

/// A name as written: symbol or word.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Name {
    /// The spelling.
    pub symbol: Symbol,
    /// The vocabulary word of that spelling.
    pub word: Option<Word>,
    /// Where.
    pub span: Span,
}

/// What gets a value: a symbol, perhaps subscripted.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    /// The symbol.
    pub name: Name,
    /// `(i)`; one expression.
    pub subscript: Option<Box<Expr>>,
    /// Where all of it stands.
    pub span: Span,
}

/// A parameter of MACRO or an argument of CALL.
#[derive(Clone, Debug, PartialEq)]
pub struct Param {
    /// Its name.
    pub name: Name,
    /// Default or actual value.
    pub value: Option<Expr>,
}

/// A word with or without arguments.
#[derive(Clone, Debug, PartialEq)]
pub struct Clause {
    /// The head; one that is no word is an error of Section 1 (misspelt word).
    pub head: Name,
    /// What follows the slash; `None` without a slash.
    pub args: Option<Box<[Expr]>>,
    /// Where all of it stands.
    pub span: Span,
}

/// An expression or an argument.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Where.
    pub span: Span,
}

/// Kind of an expression or argument.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// An empty field: `A,,B`.
    Empty,
    /// A number.
    Number(f64),
    /// Quoted text.
    Text(Box<str>),
    /// `.TRUE.` or `.FALSE.`, also without the second point.
    Truth(bool),
    /// A symbol or a word.
    Name(Name),
    /// `P(3)`, `P(1,THRU,5)`, `P(ALL)`, and a function call `SINF(A)`, `DOTF(V1,V2)`: both are a name with a
    /// list in brackets; Section 1 knows which.
    Indexed(Box<Indexed>),
    /// `-a`, `+a`, `.NOT. a`.
    Unary(UnaryOp, Box<Expr>),
    /// `a op b`.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// `POINT/1,2`, `(POINT/1,2)`, `(P=POINT/1,2)`. `juxtaposed` are words that follow the closing bracket
    /// without a comma, as in `(PLANE/0,0,1,D)CANON`; they are also given when a comma stands between in
    /// the statement's own list (then they are ordinary arguments and this is empty).
    Define(Box<Definition>),
    /// `(x,y)` or `(x,y,z)`: an unnamed point of APT4.
    Tuple(Box<[Expr]>),
    /// `(A=3)`: assignment inside an expression; its value is the value assigned.
    Assign(Box<Target>, Box<Expr>),
}

/// A name with a list in brackets.
#[derive(Clone, Debug, PartialEq)]
pub struct Indexed {
    /// The name.
    pub name: Name,
    /// What stands in the brackets.
    pub list: Box<[Expr]>,
}

/// A geometric definition.
#[derive(Clone, Debug, PartialEq)]
pub struct Definition {
    /// The name in a nested definition `(P=POINT/1,2)`.
    pub target: Option<Target>,
    /// The major word: POINT, LINE, ... or any other name that stands before a slash in an expression.
    pub head: Name,
    /// The arguments.
    pub args: Box<[Expr]>,
    /// Words after the closing bracket, `(PLANE/..)CANON`.
    pub juxtaposed: Box<[Expr]>,
}

/// Operators with one side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnaryOp {
    /// `-`
    Neg,
    /// `+`
    Pos,
    /// `.NOT.` or `.NOT`
    Not,
}

/// Operators with two sides. Powers bind first and to the right (`2**3**2` is `2**(3**2)`), and a sign
/// binds closer than they do (`-A**2` is `(-A)**2`), as APT-360 has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names say it")]
pub enum BinaryOp {
    Add,
    Sub,
    Mul,
    Div,
    Pow,
    /// `KREUZ`, the vector product of APT4.
    Cross,
    /// `DOT`, the scalar product of APT4.
    Dot,
    Eq,
    Ne,
    Lt,
    Le,
    Gt,
    Ge,
    And,
    Or,
}
