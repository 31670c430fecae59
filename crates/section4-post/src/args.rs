//! Reading the arguments of a post-processor word.

use aptc_cldata::Arg;
use aptc_diagnostics::Origin;

/// A post-processor statement.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Statement<'a> {
    pub(crate) word: &'a str,
    pub(crate) args: &'a [Arg],
    pub(crate) origin: &'a Origin,
}

impl<'a> Statement<'a> {
    /// The argument, if it is a number.
    pub(crate) fn number(&self, i: usize) -> Option<f64> {
        match self.args.get(i) {
            Some(Arg::Number(n)) => Some(*n),
            _ => None,
        }
    }

    /// The argument, if it is a word.
    pub(crate) fn word(&self, i: usize) -> Option<&'a str> {
        match self.args.get(i) {
            Some(Arg::Word(w)) => Some(w),
            _ => None,
        }
    }

    /// Does the word stand among the arguments?
    pub(crate) fn has(&self, word: &str) -> bool {
        self.args.iter().any(|a| matches!(a, Arg::Word(w) if w == word))
    }

    /// The number right after one of the words.
    pub(crate) fn after(&self, words: &[&str]) -> Option<f64> {
        self.args.windows(2).find_map(|w| match w {
            [Arg::Word(word), Arg::Number(n)] if words.contains(&word.as_str()) => Some(*n),
            _ => None,
        })
    }

    /// The first number, wherever it stands.
    pub(crate) fn first_number(&self) -> Option<f64> {
        self.args.iter().find_map(|a| match a {
            Arg::Number(n) => Some(*n),
            _ => None,
        })
    }

    /// As it might be written: `CYCLE/DRILL,2`.
    pub(crate) fn written(&self) -> String {
        use std::fmt::Write as _;
        let mut text = self.word.to_string();
        for (i, arg) in self.args.iter().take(12).enumerate() {
            text.push(if i == 0 { '/' } else { ',' });
            let done = match arg {
                Arg::Number(n) => write!(text, "{n}"),
                Arg::Word(w) => write!(text, "{w}"),
                Arg::Text(t) => write!(text, "'{t}'"),
                Arg::Form { name, .. } => write!(text, "{}", name.name),
            };
            debug_assert!(done.is_ok(), "writing into a String cannot fail");
        }
        text
    }
}

/// A whole number from 0 to 999,999 as tools, offsets and registers have it.
pub(crate) fn whole(n: f64) -> Option<u32> {
    let near = n.round();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within 0..1e6")]
    ((n - near).abs() < 1e-6 && (0.0..1e6).contains(&near)).then_some(near as u32)
}
