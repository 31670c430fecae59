//! The lines of an IGES file and its global section: 80 columns, of which the last eight say which section a line belongs to and
//! which of its lines it is.

use std::collections::BTreeMap;

use super::units::{scale, unit};
use super::{Entry, File};
use crate::{Fault, broken};

/// Where the letter of the section stands, from 0.
const MARK: usize = 72;
/// Columns of parameters; behind them stands which entity they are of.
const PARAMETERS: usize = 64;
const SECTIONS: [char; 5] = ['S', 'G', 'D', 'P', 'T'];

/// Is it the text of an IGES file, broken or not?
///
/// It is where the first line has the letter of the start section with a number where it belongs, and where lines of the start
/// section, wherever their ends stand, go over to those of a global one.
pub(crate) fn is(text: &str) -> bool {
    let mut lines = text.lines().filter(|l| !l.trim().is_empty());
    let Some(first) = lines.next() else { return false };
    if marked(first).is_some_and(|m| m.letter == 'S' && m.number.is_some()) {
        return true;
    }
    let letter = |l: &str| end(l).map(|(c, _)| c);
    let global = |l: &str| letter(l) == Some('G') && l.contains(',');
    letter(first) == Some('S') && lines.find(|l| letter(l) != Some('S')).is_some_and(global)
}

/// What the last columns of a line say.
struct Mark<'l> {
    /// What stands before them.
    body: &'l str,
    letter: char,
    /// Which line of its section it is; `None` where nothing says so.
    number: Option<usize>,
}

/// The mark of a line, where it belongs. Files of other than ASCII count columns by letters or by bytes.
fn marked(line: &str) -> Option<Mark<'_>> {
    let by_letters = line.char_indices().nth(MARK).map(|(at, _)| at);
    [by_letters, Some(MARK)].into_iter().flatten().find_map(|at| {
        let (body, mark) = line.split_at_checked(at)?;
        let letter = mark.chars().next().filter(|c| SECTIONS.contains(c))?;
        let number = mark[1..].get(..7).unwrap_or(&mark[1..]).trim();
        let number = if number.is_empty() { Some(None) } else { number.parse().ok().map(Some) };
        Some(Mark { body, letter, number: number? })
    })
}

/// The letter and the column, from 1, of a mark that ends a line, alone behind blanks.
fn end(line: &str) -> Option<(char, usize)> {
    let line = line.trim_end();
    let body = line.trim_end_matches(|c: char| c.is_ascii_digit()).trim_end();
    let letter = body.chars().next_back().filter(|c| SECTIONS.contains(c))?;
    let before = &body[..body.len() - 1];
    let alone = before.is_empty() || before.ends_with(' ') || before.chars().count() == MARK;
    alone.then(|| (letter, before.chars().count() + 1))
}

/// Why a line is none of a section.
fn unmarked(line: &str) -> String {
    let rest = |c: char| {
        line.char_indices().nth(MARK).is_some_and(|(at, _)| {
            line[at..].strip_prefix(c).is_some_and(|n| n.trim().parse::<usize>().is_ok())
        })
    };
    if rest('C') || rest('B') {
        return "IGES in compressed or binary form is not read; export it as ASCII".to_owned();
    }
    let stands = end(line).filter(|(_, column)| *column != MARK + 1);
    let stands = stands.map(|(c, column)| format!("; {c} stands in column {column}"));
    format!("neither S, G, D, P nor T stands in column 73{}", stands.unwrap_or_default())
}

pub(super) fn sections(text: &str) -> Result<File<'_>, Fault> {
    let (mut global, mut directory, mut parameters) = (String::new(), Vec::new(), Vec::new());
    for (k, line) in text.lines().enumerate() {
        let at = k + 1;
        if line.trim().is_empty() {
            continue;
        }
        let wrong = |what: String| Err(Fault::Broken { what, line: Some(at) });
        let Some(mark) = marked(line) else { return wrong(unmarked(line)) };
        let lines = match mark.letter {
            'G' => {
                global.push_str(mark.body);
                continue;
            }
            'D' => &mut directory,
            'P' => &mut parameters,
            _ => continue,
        };
        let wide = if mark.letter == 'P' { PARAMETERS } else { MARK };
        let to = mark.body.char_indices().nth(wide).map_or(mark.body.len(), |(at, _)| at);
        // Entities are found by the numbers of their lines.
        if let Some(n) = mark.number.filter(|n| *n != lines.len() + 1) {
            let (c, due) = (mark.letter, lines.len() + 1);
            return wrong(format!("it is line {n} of section {c}, and line {due} is due"));
        }
        lines.push((&mark.body[..to], at));
    }
    if global.is_empty() {
        return Err(broken("its global section, which says its unit, is not there"));
    }
    let (fields, marks) = globals(&global)?;
    let mut notes = Vec::new();
    let scale = scale(&fields)?;
    let unit_mm = unit(&fields, &mut notes).map(|mm| mm / scale);
    let mut entries = BTreeMap::new();
    for (k, pair) in directory.chunks(2).enumerate() {
        let [(first, line), (second, _)] = pair else {
            return Err(broken("the directory has an odd number of lines"));
        };
        let field = |text: &str, i: usize| {
            let digits = text.get(8 * i..8 * i + 8).unwrap_or_default().trim();
            if digits.is_empty() { Some(0) } else { digits.parse::<i64>().ok() }
        };
        let get = |text: &str, i: usize| {
            field(text, i).and_then(|n| usize::try_from(n.max(0)).ok()).ok_or_else(|| {
                Fault::Broken {
                    what: format!("field {} of the directory is no number", i + 1),
                    line: Some(*line),
                }
            })
        };
        let kind = u32::try_from(get(first, 0)?).unwrap_or(0);
        let (from, matrix, lines) = (get(first, 1)?, get(first, 6)?, get(second, 3)?);
        let form = get(second, 4)?;
        entries.insert(2 * k + 1, Entry { kind, form, from, lines, matrix, line: *line });
    }
    Ok(File { entries, parameters, marks, unit_mm, scale, notes })
}

/// The fields of the global section and the two marks that it sets.
fn globals(text: &str) -> Result<(Vec<String>, [char; 2]), Fault> {
    // `1H,` sets a mark; an empty field leaves the usual one.
    let mark = |text: &'_ str, usual: char| {
        let own = text.strip_prefix("1H").and_then(|t| t.chars().next());
        own.map_or((usual, 0), |c| (c, 2 + c.len_utf8()))
    };
    let mut rest = text.trim_start();
    let (between, used) = mark(rest, ',');
    rest = &rest[used..];
    rest = rest.strip_prefix(between).unwrap_or(rest);
    let (end, used) = mark(rest, ';');
    rest = &rest[used..];
    rest = rest.strip_prefix(between).unwrap_or(rest);
    let mut fields = vec![String::new(), String::new()];
    let mut last = false;
    while !last && !rest.is_empty() {
        let (field, after, over) = field(rest, [between, end])?;
        fields.push(field);
        rest = after;
        last = over;
    }
    Ok((fields, [between, end]))
}

/// The field before the next mark, what stands behind the mark, and whether the record ends there. Texts are
/// counted (`5Habcde`), so that marks may stand in them.
pub(super) fn field(text: &str, [between, end]: [char; 2]) -> Result<(String, &str, bool), Fault> {
    let start = text.trim_start();
    let digits = start.len() - start.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    if digits > 0 && start[digits..].starts_with('H') {
        let n: usize = start[..digits].parse().unwrap_or(usize::MAX);
        let body = &start[digits + 1..];
        let bytes = body.char_indices().nth(n).map_or(body.len(), |(at, _)| at);
        if n > body.len() {
            return Err(broken("a text is longer than its record"));
        }
        let (held, after) = body.split_at(bytes);
        let mut chars = after.trim_start().chars();
        let over = chars.next().is_none_or(|c| c == end);
        return Ok((held.to_owned(), chars.as_str(), over));
    }
    match start.find([between, end]) {
        Some(at) => {
            let c = start[at..].chars().next().unwrap_or(end);
            Ok((start[..at].to_owned(), &start[at + c.len_utf8()..], c == end))
        }
        None => Ok((start.to_owned(), "", true)),
    }
}
