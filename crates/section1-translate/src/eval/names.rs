//! Names in expressions, and what to say of those without a value.

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_syntax::Symbol;
use aptc_syntax::tree::Name;
use aptc_vocabulary::{Class, Word, closest, find};

use super::{Known, Poisoned};
use crate::Interpreter;
use crate::memory::{Place, Value};
use crate::usage::usage;

/// Shorter modifiers, as TO and ON, end too many names by chance.
const SHORTEST_MODIFIER: usize = 4;

impl Interpreter<'_> {
    /// What `name` stands for: a value, or the vocabulary word of that spelling.
    pub(crate) fn named(&mut self, name: &Name) -> Known<Value> {
        let place = self.memory.place(name.symbol);
        let slot = self.memory.slot_mut(place);
        match &slot.value {
            Value::Unset => match self.synonyms.word(name) {
                Some(word) => Ok(Value::Word(word)),
                None => Err(self.undefined(name)),
            },
            Value::Poison => {
                self.blamed = Some((place, slot.given));
                Err(Poisoned)
            }
            Value::Array(_) => Err(self.subscript_missing(place, name.span)),
            value => {
                let value = value.clone();
                slot.read = true;
                Ok(value)
            }
        }
    }

    /// The word that stands at the head of a statement or among arguments, where a symbol of that
    /// spelling does not count; a macro parameter may stand for it.
    pub(crate) fn head_word(&self, name: &Name) -> Option<Word> {
        if self.memory.is_local(name.symbol)
            && let Value::Word(word) = self.memory.slot(self.memory.place(name.symbol)).value
        {
            return Some(word);
        }
        self.synonyms.word(name)
    }

    /// Says that `name` has no value, and says it once.
    pub(crate) fn undefined(&mut self, name: &Name) -> Poisoned {
        let place = self.memory.place(name.symbol);
        let text = self.interner.text(name.symbol).to_owned();
        let shown = self.spelled(place);
        if !self.is_doubtful(self.memory.name(place).0) {
            let mut message = Diagnostic::error(
                codes::UNDEFINED_NAME,
                name.span,
                if shown == text {
                    format!("{text} has no value here")
                } else {
                    format!("{text} stands for {shown}, which has no value here")
                },
            );
            let near = self.near_in_form(&text).or_else(|| self.near(name.symbol, &text));
            match near {
                _ if let Some((front, rest)) = self.run_together(&text) => {
                    message =
                        message.help(format!("put a `,` in between if it is {front} and {rest}"));
                }
                Some(near) => message = message.help(format!("did you mean {near}?")),
                None if self.memory.is_local(name.symbol) && shown == text => {
                    message = message.help("give the parameter a value in the CALL");
                }
                None => {
                    let (from, to) = (name.span.start as usize, name.span.end as usize);
                    let unit = self.levels.last().map(|l| &l.unit.text);
                    let written = unit.and_then(|text| text.get(from..to));
                    let behind = unit.and_then(|text| text.get(to..)).unwrap_or_default();
                    let pieces: Vec<&str> =
                        written.unwrap_or_default().split_whitespace().collect();
                    let geometry = |w: Word| w.is(Class::Geometry) && self.synonyms.knows(w);
                    let major = closest(&text, geometry)
                        .filter(|_| behind.trim_start_matches(' ').starts_with('/'));
                    message = message.help(if let Some(major) = major {
                        format!("did you mean {major}?")
                    } else if let Some((figures, power)) = exponential(&text, behind) {
                        format!("a number with an exponent has a point: {figures}.E{power}")
                    } else if pieces.len() > 1 {
                        // Blanks have no meaning, but people set them where they mean something.
                        format!("put a `,` in between if it is {}", pieces.join(" and "))
                    } else if let Some(form) = self.form_of_post() {
                        format!("write {form}, or define {text} in a statement before this one")
                    } else {
                        format!("define {text} in a statement before this one")
                    });
                }
            }
            self.error(message);
        }
        self.memory.set(place, Value::Poison, name.span);
        Poisoned
    }

    /// The word of the forms of that statement that `text` was perhaps meant to be: BORE, where others are as near.
    fn near_in_form(&self, text: &str) -> Option<String> {
        let forms = usage(self.state.arguments_of?);
        let is_there = |word: Word| {
            let words = forms.iter().flat_map(|f| f.split(|c: char| !c.is_ascii_alphanumeric()));
            words.clone().any(|w| w == word.text())
        };
        closest(text, is_there).map(|word| word.text().to_owned())
    }

    /// Both halves of `L1YLARGE`, a name that has a value and a modifier, or the other way round.
    fn run_together<'t>(&self, text: &'t str) -> Option<(&'t str, &'t str)> {
        let modifier = |s: &str| {
            let word = find(s).filter(|w| self.synonyms.knows(*w));
            s.len() >= SHORTEST_MODIFIER && word.is_some_and(|w| w.is(Class::Modifier))
        };
        let named = |s: &str| {
            let place = self.interner.find(s).map(|symbol| self.memory.place(symbol));
            place.is_some_and(|p| !matches!(self.memory.slot(p).value, Value::Unset))
        };
        let halves = (1..text.len()).filter_map(|i| text.split_at_checked(i));
        let mut fit = halves.filter(|(a, b)| named(a) && modifier(b) || modifier(a) && named(b));
        fit.next()
    }

    /// The form that the statement of the post-processor has whose arguments are read.
    fn form_of_post(&self) -> Option<String> {
        let word = self.state.arguments_of?;
        let form = usage(word).first().map(|form| form.replace('@', word.text()))?;
        form.contains('/').then_some(form)
    }

    /// The name with a value, or the word, that `text` was perhaps meant to be.
    pub(crate) fn near(&self, symbol: Symbol, text: &str) -> Option<String> {
        let mut best: Option<(usize, &str)> = None;
        let mut tie = false;
        if text.len() >= 2 {
            for (place, slot) in self.memory.values() {
                let Place::Global(other) = place else { continue };
                if other == symbol || matches!(slot.value, Value::Unset | Value::Poison) {
                    continue;
                }
                let candidate = self.interner.text(other);
                let slips = slips(text, candidate);
                let limit = if text.len() < 6 { 1 } else { 2 };
                if slips > limit || slips >= text.len().min(candidate.len()) {
                    continue;
                }
                match best {
                    Some((least, _)) if slips > least => {}
                    Some((least, _)) if slips == least => tie = true,
                    _ => {
                        best = Some((slips, candidate));
                        tie = false;
                    }
                }
            }
        }
        if let Some((1, name)) = best.filter(|_| !tie) {
            return Some(name.to_owned());
        }
        let modifier =
            |w: Word| w.text() != text && self.synonyms.knows(w) && w.is(Class::Modifier);
        if let Some(word) = closest(text, modifier) {
            return Some(word.text().to_owned());
        }
        best.filter(|_| !tie).map(|(_, name)| name.to_owned())
    }

    /// Says that an array needs a subscript.
    pub(crate) fn subscript_missing(&mut self, place: Place, span: Span) -> Poisoned {
        let name = self.spelled(place);
        self.error(
            Diagnostic::error(
                codes::SUBSCRIPT_MISSING,
                span,
                format!("{name} is an array and stands here without a subscript"),
            )
            .also(self.memory.slot(place).given, "reserved here")
            .help(format!("write {name}(i), or {name}(ALL) in a list")),
        );
        Poisoned
    }

    /// Says that a name with a subscript is no array.
    pub(crate) fn not_reserved(&mut self, name: &Name) -> Poisoned {
        if let Some(word) = name.word.filter(|w| super::functions::is_function(*w)) {
            return self.no_function(word, name.span);
        }
        let place = self.memory.place(name.symbol);
        let text = self.spelled(place);
        let slot = self.memory.slot(place);
        let (set, given) = (!matches!(slot.value, Value::Unset), slot.given);
        if matches!(slot.value, Value::Poison) {
            return Poisoned;
        }
        if !self.is_doubtful(self.memory.name(place).0) {
            let mut message = Diagnostic::error(
                codes::NOT_RESERVED,
                name.span,
                format!("{text} has a subscript but is no array"),
            );
            if set {
                message = message.also(given, "it has a single value from here");
            } else {
                message = message.help(format!("reserve it first: RESERV/{text},n"));
            }
            self.error(message);
        }
        if !set {
            self.memory.set(place, Value::Poison, name.span);
        }
        Poisoned
    }
}

/// Slips between two spellings: letters wrong, missing, too many, or neighbours exchanged.
fn slips(a: &str, b: &str) -> usize {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    if a.len().abs_diff(b.len()) > 2 {
        return usize::MAX;
    }
    let mut before: Vec<usize> = Vec::new();
    let mut last: Vec<usize> = (0..=b.len()).collect();
    for i in 1..=a.len() {
        let mut now = vec![i; b.len() + 1];
        for j in 1..=b.len() {
            let same = a[i - 1] == b[j - 1];
            now[j] = (last[j - 1] + usize::from(!same)).min(last[j] + 1).min(now[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                now[j] = now[j].min(before[j - 2] + 1);
            }
        }
        before = std::mem::replace(&mut last, now);
    }
    last[b.len()]
}

/// Both parts of `1E3`, which is a name in APT, and of `1E-3`, which is one less three: a number with an exponent
/// has a point. `behind` is what follows the name.
fn exponential<'a>(text: &'a str, behind: &'a str) -> Option<(&'a str, &'a str)> {
    let (figures, power) = text.split_once('E')?;
    let digits = |part: &str| part.bytes().take_while(u8::is_ascii_digit).count();
    let is_number = |part: &str| !part.is_empty() && digits(part) == part.len();
    if !is_number(figures) {
        return None;
    }
    if !power.is_empty() {
        return is_number(power).then_some((figures, power));
    }
    let behind = behind.trim_start_matches(' ');
    let end = 1 + digits(behind.strip_prefix(['+', '-'])?);
    (end > 1).then(|| (figures, &behind[..end]))
}

#[cfg(test)]
mod tests {
    use super::slips;

    #[test]
    fn slips_are_counted() {
        assert_eq!(slips("SETPT", "SETTP"), 1);
        assert_eq!(slips("PT1", "PT2"), 1);
        assert_eq!(slips("KITTEN", "SITTIN"), 2);
        assert_eq!(slips("A", "ABCD"), usize::MAX);
        assert_eq!(slips("", ""), 0);
    }
}
