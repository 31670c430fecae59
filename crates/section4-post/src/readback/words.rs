//! A line of RS-274 as words.

/// A letter and its number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Word {
    pub(super) letter: u8,
    pub(super) value: f64,
}

/// A word of several letters with its arguments: `CYCLE81(10,0,2,-5)`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Keyword {
    pub(super) name: String,
    /// Its arguments; none where the place is empty.
    pub(super) args: Vec<Option<f64>>,
}

/// The words of one line.
#[derive(Clone, Debug, Default)]
pub(super) struct Line {
    pub(super) words: Vec<Word>,
    pub(super) keywords: Vec<Keyword>,
    /// Are words of several letters understood?
    with_keywords: bool,
    /// Values of named parameters: `#<_wear_1>`.
    parameters: Vec<(String, f64)>,
}

impl Line {
    pub(super) fn new(with_keywords: bool) -> Self {
        Self { with_keywords, ..Self::default() }
    }

    /// Reads a line; an error says what cannot be read.
    pub(super) fn read(&mut self, text: &[u8]) -> Result<(), String> {
        self.words.clear();
        self.keywords.clear();
        let mut i = 0;
        while let Some(&c) = text.get(i) {
            match c {
                b' ' | b'\t' | b'\r' | b'\n' => i += 1,
                b'/' if self.words.is_empty() => i += 1,
                b'%' => return Ok(()),
                b'(' => match text[i..].iter().position(|&b| b == b')') {
                    Some(n) if !text[i + 1..i + n].contains(&b'(') => i += n + 1,
                    _ => return Err("a comment that does not end, or holds a bracket".into()),
                },
                b';' => return Ok(()),
                b'#' => {
                    let (name, next) = parameter(text, i)?;
                    let rest = &text[next..];
                    let Some(b'=') = rest.first() else {
                        return Err("a parameter that is given no value".into());
                    };
                    let (value, used) = number(&rest[1..])?;
                    self.parameters.retain(|(n, _)| *n != name);
                    self.parameters.push((name, value));
                    i = next + 1 + used;
                }
                c if self.with_keywords
                    && c.is_ascii_alphabetic()
                    && text.get(i + 1).is_some_and(u8::is_ascii_alphabetic) =>
                {
                    i = self.keyword(text, i)?;
                }
                c if c.is_ascii_alphabetic() => {
                    let letter = c.to_ascii_uppercase();
                    i += 1;
                    while text.get(i) == Some(&b' ') {
                        i += 1;
                    }
                    let value = if text.get(i) == Some(&b'#') {
                        let (name, next) = parameter(text, i)?;
                        i = next;
                        let known = self.parameters.iter().find(|(n, _)| *n == name);
                        known.ok_or_else(|| format!("parameter {name} has no value"))?.1
                    } else {
                        let (value, used) = number(&text[i..])?;
                        i += used;
                        value
                    };
                    self.words.push(Word { letter, value });
                }
                _ => return Err(format!("the character {:?}", char::from(c))),
            }
        }
        Ok(())
    }

    /// A keyword from `at`: where it ends.
    fn keyword(&mut self, text: &[u8], at: usize) -> Result<usize, String> {
        let name_char = |b: &u8| b.is_ascii_alphanumeric() || *b == b'_';
        let end = at + text[at..].iter().take_while(|b| name_char(b)).count();
        let name = String::from_utf8_lossy(&text[at..end]).to_ascii_uppercase();
        let mut args = Vec::new();
        let mut next = end;
        if text.get(end) == Some(&b'(') {
            let close = text[end..].iter().position(|b| *b == b')').ok_or("a bracket left open")?;
            next = end + close + 1;
            for field in text[end + 1..end + close].split(|b| *b == b',') {
                let field = field.trim_ascii();
                args.push(if field.is_empty() || field.starts_with(b"\"") {
                    None
                } else {
                    Some(number(field)?.0)
                });
            }
        }
        // A value of its own: `SPOS=45`.
        if text.get(end) == Some(&b'=') {
            let (value, used) = number(&text[end + 1..])?;
            args.push(Some(value));
            next = end + 1 + used;
        }
        self.keywords.push(Keyword { name, args });
        Ok(next)
    }

    /// The number of a letter, if it stands in the line.
    pub(super) fn value(&self, letter: u8) -> Option<f64> {
        self.words.iter().find(|w| w.letter == letter).map(|w| w.value)
    }
}

/// `#<name>` from `at`: the name and where it ends.
fn parameter(text: &[u8], at: usize) -> Result<(String, usize), String> {
    let rest = &text[at + 1..];
    if rest.first() != Some(&b'<') {
        return Err("a numbered parameter".into());
    }
    let end = rest.iter().position(|&b| b == b'>').ok_or("a parameter name that does not end")?;
    Ok((String::from_utf8_lossy(&rest[1..end]).into_owned(), at + 1 + end + 1))
}

/// A number without an exponent, and how many bytes it takes.
fn number(text: &[u8]) -> Result<(f64, usize), String> {
    let mut i = 0;
    let negative = match text.first() {
        Some(b'-') => {
            i = 1;
            true
        }
        Some(b'+') => {
            i = 1;
            false
        }
        _ => false,
    };
    let (mut digits, mut decimals, mut n, mut point) = (0_u64, 0_u32, 0_u32, false);
    while let Some(&c) = text.get(i) {
        match c {
            b'0'..=b'9' => {
                n += 1;
                if n > 18 {
                    return Err("a number of more than 18 digits".into());
                }
                digits = digits * 10 + u64::from(c - b'0');
                decimals += u32::from(point);
            }
            b'.' if !point => point = true,
            _ => break,
        }
        i += 1;
    }
    if n == 0 {
        return Err("a letter without a number".into());
    }
    #[expect(clippy::cast_precision_loss, reason = "below 2^53 for all that a control can hold")]
    let value = digits as f64 / POWERS[decimals as usize];
    Ok((if negative { -value } else { value }, i))
}

const POWERS: [f64; 19] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18,
];

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Result<Vec<(char, f64)>, String> {
        let mut line = Line::default();
        line.read(text.as_bytes())?;
        Ok(line.words.iter().map(|w| (char::from(w.letter), w.value)).collect())
    }

    #[test]
    fn letters_and_numbers() {
        assert_eq!(
            words("N10 G01X-1.5 y.25(A)Z+3.").unwrap(),
            [('N', 10.0), ('G', 1.0), ('X', -1.5), ('Y', 0.25), ('Z', 3.0)]
        );
        assert_eq!(words("/X5 ; REST").unwrap(), [('X', 5.0)]);
    }

    #[test]
    fn what_is_none_is_refused() {
        for bad in ["X", "X-", "X1E5X", "X1.2.3", "(OPEN", "((A))", "=5", "D#<_w>", "X1O"] {
            assert!(words(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn parameters() {
        let mut line = Line::default();
        line.read(b"#<_wear_1>=0.02").unwrap();
        line.read(b"G41.1 D#<_wear_1>").unwrap();
        assert_eq!(line.value(b'D'), Some(0.02));
    }
}
