//! Tokens of a statement.
//!
//! [`Raw`] is what the lexer finds in the statement's significant characters: capitals, without blanks.
//! [`Token`] is what the grammar sees: small, without borrowed text, names already interned.

use aptc_vocabulary::Word;
use chumsky::span::SimpleSpan;
use logos::Logos;

use crate::Symbol;
use crate::tree::BinaryOp;

/// A token with the bytes of the file on which it stands.
pub(crate) type Spanned = (Token, SimpleSpan<u32>);

/// The lexer's tokens.
///
/// A digit string with letters is a symbol (`3X`, `1E5`); with a decimal point it is a number, whose
/// exponent may follow. `1.EQ.2` is a number, an operator and a number, hence the joint token.
#[derive(Logos, Clone, Copy, Debug, PartialEq, Eq)]
#[logos(utf8 = true)]
pub(crate) enum Raw {
    #[regex(r"[0-9]*[A-Z][A-Z0-9]*")]
    Name,
    #[regex(r"[0-9]+")]
    Integer,
    #[regex(r"[0-9]+\.[0-9]*([ED][+-]?[0-9]+)?")]
    #[regex(r"\.[0-9]+([ED][+-]?[0-9]+)?")]
    Real,
    #[regex(r"[0-9]+\.(EQ|NE|LT|LE|GT|GE|AND|OR|KREUZ|DOT)\.?")]
    IntegerThenOperator,
    #[regex(r"\.(EQ|NE|LT|LE|GT|GE|AND|OR|NOT|TRUE|FALSE|KREUZ|DOT)\.?")]
    Dotted,
    #[regex(r"'[^']*'")]
    #[regex(r#""[^"]*""#)]
    Text,
    #[token("**")]
    Power,
    #[token("*")]
    Star,
    #[token("+")]
    Plus,
    #[token("-")]
    Minus,
    #[token("/")]
    Slash,
    #[token(",")]
    Comma,
    #[token("=")]
    Equal,
    #[token("(")]
    Open,
    #[token(")")]
    Close,
    #[token(":")]
    Colon,
}

/// What the grammar sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Token {
    /// A symbol or word.
    Name(Symbol, Option<Word>),
    /// A name before a slash that begins a list of arguments, not a division: `POINT` of `P=POINT/1,2`.
    Head(Symbol, Option<Word>),
    /// A number, with its spelling where a label may stand.
    Number(f64, Option<Symbol>),
    /// Quoted text: its place among the texts.
    Text(u32),
    /// A fixed-field word with its text: its place among them.
    Fixed(u32),
    /// `.TRUE.` or `.FALSE.`
    Truth(bool),
    /// `.NOT.`
    Not,
    /// An operator between two sides, but for division.
    Operator(BinaryOp),
    Slash,
    Comma,
    Equal,
    Open,
    Close,
    Colon,
}

/// The sign of an operator.
pub(crate) fn sign(op: BinaryOp) -> &'static str {
    match op {
        BinaryOp::Add => "+",
        BinaryOp::Sub => "-",
        BinaryOp::Mul => "*",
        BinaryOp::Div => "/",
        BinaryOp::Pow => "**",
        BinaryOp::Cross => "KREUZ",
        BinaryOp::Dot => "DOT",
        BinaryOp::Eq => ".EQ.",
        BinaryOp::Ne => ".NE.",
        BinaryOp::Lt => ".LT.",
        BinaryOp::Le => ".LE.",
        BinaryOp::Gt => ".GT.",
        BinaryOp::Ge => ".GE.",
        BinaryOp::And => ".AND.",
        BinaryOp::Or => ".OR.",
    }
}
