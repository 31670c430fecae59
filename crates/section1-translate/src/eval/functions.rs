//! Functions of APT-360 and APT4.

use std::f64::consts::PI;

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_geometry::trig;
use aptc_syntax::tree::Expr;
use aptc_vocabulary::{Class, Word, word};

use super::{Known, Poisoned};
use crate::Interpreter;
use crate::memory::Value;

/// Degrees in a radian.
const DEGREES: f64 = 180.0 / PI;

/// Is it the name of a function, and of nothing else?
pub(super) fn is_function(word: Word) -> bool {
    word.class() == Class::Function
}

/// How a function takes its numbers.
enum Rule {
    One(fn(f64) -> f64),
    Two(fn(f64, f64) -> f64),
    Many(fn(f64, f64) -> f64),
}

/// The functions of numbers. Angles are degrees; those with B at the end take and give radians.
fn rule(word: Word) -> Option<Rule> {
    use Rule::{Many, One, Two};
    Some(match word {
        word::ABSF => One(f64::abs),
        word::SQRTF => One(f64::sqrt),
        word::EXPF => One(trig::exp),
        word::LOGF => One(trig::ln),
        word::LOG10F => One(trig::log10),
        word::INTF => One(f64::trunc),
        word::SINF => One(trig::sin_deg),
        word::COSF => One(trig::cos_deg),
        word::TANF => One(|x| quotient(trig::sin_deg(x), trig::cos_deg(x))),
        word::COTANF => One(|x| quotient(trig::cos_deg(x), trig::sin_deg(x))),
        word::ATANF => One(|x| trig::atan(x) * DEGREES),
        word::ARSINF => One(|x| trig::asin(x) * DEGREES),
        word::ARCOSF => One(|x| trig::acos(x) * DEGREES),
        word::ATAN2F => Two(|y, x| nowhere(x, y).unwrap_or_else(|| trig::atan2(y, x) * DEGREES)),
        word::SINB => One(trig::sin),
        word::COSB => One(trig::cos),
        word::TANB => One(trig::tan),
        word::COTANB => One(|x| quotient(trig::cos(x), trig::sin(x))),
        word::ATANB => One(trig::atan),
        word::ARSINB => One(trig::asin),
        word::ARCOSB => One(trig::acos),
        word::ATAN2B => Two(|y, x| nowhere(x, y).unwrap_or_else(|| trig::atan2(y, x))),
        word::SINHF => One(trig::sinh),
        word::COSHF => One(trig::cosh),
        word::TANHF => One(trig::tanh),
        word::MODF => Two(|a, b| a % b),
        word::SIGNF => Two(|a, b| if b < 0.0 { -a.abs() } else { a.abs() }),
        word::MINF => Many(f64::min),
        word::MAXF => Many(f64::max),
        _ => return None,
    })
}

/// `a/b`; no number when b is zero.
fn quotient(a: f64, b: f64) -> f64 {
    if b == 0.0 { f64::NAN } else { a / b }
}

/// The direction of the origin itself is no number.
fn nowhere(x: f64, y: f64) -> Option<f64> {
    (x == 0.0 && y == 0.0).then_some(f64::NAN)
}

impl Interpreter<'_> {
    /// The value of a function.
    pub(super) fn function(&mut self, word: Word, args: &[Expr], span: Span) -> Known<Value> {
        let Some(rule) = rule(word) else {
            return match self.geometric(word, args, span) {
                Some(value) => value,
                None => Err(self.no_function(word, span)),
            };
        };
        let wanted = match rule {
            Rule::One(_) => (1, 1),
            Rule::Two(_) => (2, 2),
            Rule::Many(_) => (2, usize::MAX),
        };
        self.count_arguments(word, args, wanted, span)?;
        let value = match (rule, args) {
            (Rule::One(f), [x]) => f(self.number(x)?),
            (Rule::Two(f), [x, y]) => {
                let (x, y) = (self.number(x), self.number(y));
                f(x?, y?)
            }
            (Rule::Many(f), _) => {
                let numbers: Vec<_> = args.iter().map(|a| self.number(a)).collect();
                let numbers: Vec<f64> = numbers.into_iter().collect::<Known<_>>()?;
                numbers.into_iter().reduce(f).unwrap_or(f64::NAN)
            }
            _ => unreachable!("the number of arguments was checked"),
        };
        if value.is_finite() {
            return Ok(Value::Number(value));
        }
        let shown: Vec<String> =
            args.iter().filter_map(|a| self.number(a).ok()).map(|n| n.to_string()).collect();
        self.error(Diagnostic::error(
            codes::NO_VALUE,
            span,
            format!("{word} has no value for {}", shown.join(", ")),
        ));
        Err(Poisoned)
    }

    /// Says when a function has too few or too many arguments.
    pub(super) fn count_arguments(
        &mut self,
        word: Word,
        args: &[Expr],
        (least, most): (usize, usize),
        span: Span,
    ) -> Known<()> {
        if (least..=most).contains(&args.len()) {
            return Ok(());
        }
        let wanted =
            if most == usize::MAX { format!("at least {least}") } else { least.to_string() };
        self.error(Diagnostic::error(
            codes::FUNCTION_ARGUMENTS,
            span,
            format!("{word} takes {wanted} argument{}, not {}", plural(least), args.len()),
        ));
        Err(Poisoned)
    }

    pub(super) fn no_function(&mut self, word: Word, span: Span) -> Poisoned {
        let message = if is_function(word) {
            Diagnostic::error(
                codes::FUNCTION_NOT_KNOWN,
                span,
                format!("the function {word} is not available here"),
            )
            .note("it belongs to another dialect")
        } else if word.class() == Class::Geometry {
            let message = format!("{word} takes its arguments behind a `/`");
            Diagnostic::error(codes::FUNCTION_NOT_KNOWN, span, message)
                .help(format!("write {word}/.., in brackets within a statement: ({word}/..)"))
        } else {
            Diagnostic::error(
                codes::FUNCTION_NOT_KNOWN,
                span,
                format!("{word} is a vocabulary word, neither a function nor an array"),
            )
            .help("an array is reserved first: RESERV/name,n")
        };
        self.error(message);
        Poisoned
    }
}

fn plural(n: usize) -> &'static str {
    if n == 1 { "" } else { "s" }
}
