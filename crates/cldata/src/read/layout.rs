//! How the lines of a text lie: their ends, and the columns that carry numbers of cards or records.

/// Lines at the head that must agree before columns are taken for numbers.
const FEWEST: usize = 3;
/// Lines at the head that are looked at.
const MOST: usize = 400;
/// Columns of a statement on a card; identification follows.
const CARD: usize = 72;
/// Leading columns of record numbers, as Intercim writes them.
const LEADING: usize = 8;

/// Where statements stand on the lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Layout {
    /// The byte that ends a line.
    pub(super) eol: u8,
    /// Columns before the statement.
    pub(super) skip: usize,
    /// Columns up to the end of the statement.
    pub(super) width: usize,
}

impl Default for Layout {
    fn default() -> Self {
        Self { eol: b'\n', skip: 0, width: usize::MAX }
    }
}

/// The layout of a file by its head. Columns are numbers only if they grow from line to line in all lines.
pub(super) fn of(head: &[u8]) -> Layout {
    let eol = if head.contains(&b'\n') || !head.contains(&b'\r') { b'\n' } else { b'\r' };
    let mut layout = Layout { eol, ..Layout::default() };
    let whole = memchr::memrchr(eol, head).map_or(&b""[..], |end| &head[..end]);
    let lines: Vec<&[u8]> = whole
        .split(|b| *b == eol)
        .map(<[u8]>::trim_ascii_end)
        .filter(|l| !l.is_empty())
        .take(MOST)
        .collect();
    if grow(lines.iter().map(|l| leading(l))) {
        layout.skip = LEADING;
    } else if grow(lines.iter().map(|l| trailing(l))) {
        layout.width = CARD;
    }
    layout
}

/// Is each there and greater than the one before?
fn grow(numbers: impl ExactSizeIterator<Item = Option<u64>>) -> bool {
    let mut last = None;
    numbers.len() >= FEWEST
        && numbers.into_iter().all(|n| {
            let more = n.is_some() && n > last;
            last = n;
            more
        })
}

/// The number in the leading columns, right-justified or with zeros.
fn leading(line: &[u8]) -> Option<u64> {
    let (number, rest) = line.split_at_checked(LEADING)?;
    let digits = number.trim_ascii_start();
    let next = rest.first().is_none_or(|b| !matches!(b, b'0'..=b'9' | b'.' | b','));
    if digits.is_empty() || !digits.iter().all(u8::is_ascii_digit) || !next {
        return None;
    }
    std::str::from_utf8(digits).ok()?.parse().ok()
}

/// The number at the end of the identification columns.
fn trailing(line: &[u8]) -> Option<u64> {
    if line.len() <= CARD || line.len() > CARD + 8 {
        return None;
    }
    let name = line[CARD..].trim_ascii();
    let letters = name.iter().rposition(|b| !b.is_ascii_digit()).map_or(0, |i| i + 1);
    let plain = name.iter().all(|b| b.is_ascii_alphanumeric());
    let digits = std::str::from_utf8(&name[letters..]).ok()?;
    if plain { digits.parse().ok() } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_and_columns() {
        let plain = Layout::default();
        assert_eq!(of(b"GOTO/1,2,3\nGOTO/4,5,6\nFINI\n"), plain);
        assert_eq!(of(b"GOTO/1,2,3\rFINI\r"), Layout { eol: b'\r', ..plain });
        assert_eq!(of(b"GOTO/1,2,3\r\nFINI\r\n"), plain);
        let numbered = |f: &dyn Fn(u32) -> String| -> Vec<u8> {
            (1..9).map(f).collect::<String>().into_bytes()
        };
        let before = numbered(&|n| format!("{:08}GOTO/{n},2,3\n", 10 * n));
        assert_eq!(of(&before), Layout { skip: 8, ..plain });
        let after = numbered(&|n| format!("{:<72}APT{n:05}\n", "GOTO/1,2,3"));
        assert_eq!(of(&after), Layout { width: 72, ..plain });
    }

    /// Points without GOTO are no record numbers, and long lines no cards.
    #[test]
    fn data_are_not_taken_for_numbers() {
        let points = b"GOTO/1,2,3\n10000000,2,3\n20000000,3,4\n";
        assert_eq!(of(points), Layout::default());
        let bare = b"1.000000,2,3\n2.000000,3,4\n3.000000,4,5\n";
        assert_eq!(of(bare), Layout::default());
        let long: String = (0..9).map(|n| format!("{:<75}{n}\n", "GOTO/1,2,3,")).collect();
        assert_eq!(of(long.as_bytes()).width, 72, "a number in column 76 is one of a card");
        let wide: String = (0..9).map(|n| format!("GOTO/{:<70},{n}\n", "1,2")).collect();
        assert_eq!(of(wide.as_bytes()), Layout::default());
    }
}
