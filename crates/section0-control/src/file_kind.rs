//! What a file is, by its looks: so that the wrong one is refused in a word, not misread from end to end.

use std::fmt;

use aptc_vocabulary::{Class, find};

/// Bytes at the head of a file that are looked at.
const HEAD: usize = 64 * 1024;
/// Lines with text at the head that tell machine code.
const LINES: usize = 40;

/// Files that are often at hand beside one another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    /// Nothing is in it but blanks.
    Empty,
    /// It has definitions of geometry, which CL data have not.
    PartProgram,
    /// Blocks of a control.
    MachineCode,
    /// SVG, HTML or other XML.
    Markup,
    /// A listing of ours.
    Listing,
    /// A numeric part program of ours.
    Protap,
    /// No text; binary CL data look so too.
    Binary,
}

impl FileKind {
    /// The kind of a file that begins so; `None` where nothing tells. CL data are a part program without definitions,
    /// so that neither is named where a text has none.
    pub fn of(bytes: &[u8]) -> Option<Self> {
        let head = &bytes[..bytes.len().min(HEAD)];
        let wide = head.starts_with(&[0xff, 0xfe]) || head.starts_with(&[0xfe, 0xff]);
        let text: Vec<u8> = head.iter().copied().filter(|b| !wide || *b != 0).collect();
        if text.trim_ascii().is_empty() {
            return Some(Self::Empty);
        }
        // A stray control character in a text is told at its place.
        let odd = |b: &&u8| **b < b' ' && !matches!(**b, b'\t' | b'\n' | b'\r' | b'\x0c' | b'\x1a');
        if text.iter().filter(odd).count() * 20 > text.len() {
            return Some(Self::Binary);
        }
        let text = String::from_utf8_lossy(&text).to_ascii_uppercase();
        let text = text.trim_start_matches(|c: char| !c.is_ascii()).trim_ascii_start();
        if ["<?XML", "<SVG", "<HTML", "<!DOCTYPE"].iter().any(|mark| text.starts_with(mark)) {
            return Some(Self::Markup);
        }
        if text.starts_with("{\"PROTAP\"") {
            return Some(Self::Protap);
        }
        let mut lines = text.split(['\n', '\r']).map(str::trim).filter(|line| !line.is_empty());
        if text.starts_with("SOURCE  ")
            && lines.clone().nth(1).is_some_and(|l| l.starts_with("1  "))
        {
            return Some(Self::Listing);
        }
        if is_machine_code(lines.clone()) {
            return Some(Self::MachineCode);
        }
        lines.any(is_definition).then_some(Self::PartProgram)
    }
}

impl fmt::Display for FileKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Empty => "empty",
            Self::PartProgram => "a part program",
            Self::MachineCode => "machine code",
            Self::Markup => "a drawing or a page (SVG, HTML, XML)",
            Self::Listing => "a listing",
            Self::Protap => "a numeric part program (.protap)",
            Self::Binary => "binary",
        })
    }
}

/// Are most of the first lines blocks, and three of them with a G or M word?
fn is_machine_code<'a>(lines: impl Iterator<Item = &'a str>) -> bool {
    let comment = |line: &&str| line.starts_with([';', '(', '%', ':']);
    let (mut seen, mut blocks, mut coded) = (0, 0, 0);
    for line in lines.filter(|line| !comment(line)).take(LINES) {
        let unnumbered = line.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start();
        if seen == 0 && unnumbered.starts_with("BEGIN PGM ") {
            return true;
        }
        seen += 1;
        if let Some(codes) = codes(line) {
            blocks += 1;
            coded += usize::from(codes > 0);
        }
    }
    coded >= 3 && 2 * blocks > seen
}

/// How many G and M words stand in a block, `None` where the line is none: addresses of one letter with a number each.
fn codes(line: &str) -> Option<usize> {
    let line = line.split([';', '(']).next().unwrap_or(line);
    let mut rest = line.trim_start_matches('/').trim();
    let mut codes = 0;
    while let Some(letter) = rest.chars().next() {
        let number =
            rest.strip_prefix(|c: char| c.is_ascii_uppercase())?.trim_start_matches([' ', '=']);
        let end = number
            .find(|c: char| !matches!(c, '0'..='9' | '.' | '+' | '-'))
            .unwrap_or(number.len());
        if end == 0 {
            return None;
        }
        codes += usize::from(matches!(letter, 'G' | 'M'));
        rest = number[end..].trim_start();
    }
    Some(codes)
}

/// `NAME = WORD/..`, also with a subscript.
fn is_definition(line: &str) -> bool {
    let Some((name, value)) = line.split_once('=') else { return false };
    let name = name.trim_end();
    let name = match name.strip_suffix(')').and_then(|n| n.split_once('(')) {
        Some((name, _)) => name.trim_end(),
        None => name,
    };
    let word = value.split_once('/').map(|(word, _)| word.trim());
    let plain = |text: &str| text.bytes().all(|b| b.is_ascii_alphanumeric());
    let is_name = name.starts_with(|c: char| c.is_ascii_alphabetic()) && plain(name);
    let geometry = |w: &str| find(w).is_some_and(|w| w.is(Class::Geometry));
    is_name && word.is_some_and(geometry)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Option<FileKind> {
        FileKind::of(text.as_bytes())
    }

    #[test]
    fn each_kind_is_told_by_its_head() {
        assert_eq!(of(" \r\n\n"), Some(FileKind::Empty));
        let code = "%\nO100\n(PLATE)\nG21\nG17 G40 G80\nT1 M6\nG0 X-15. Y=-15.\nN10G1Z5F100\nM30\n";
        assert_eq!(of(code), Some(FileKind::MachineCode));
        assert_eq!(of("0 BEGIN PGM PLATE MM\n1 L X+5\n"), Some(FileKind::MachineCode));
        assert_eq!(of("\u{feff}<?xml version='1.0'?>\n"), Some(FileKind::Markup));
        assert_eq!(of("{\"protap\":1}\n"), Some(FileKind::Protap));
        assert_eq!(of("SOURCE  x.apt\n\n     1  PARTNO X\n"), Some(FileKind::Listing));
        let wild: Vec<u8> = (0..64).flat_map(|i: u8| [i, i.wrapping_mul(37), 200 - i]).collect();
        assert_eq!(FileKind::of(&wild), Some(FileKind::Binary));
        for line in ["L1=LINE/XAXIS", "p(3) = point / 1,2", "A= CIRCLE/C,5"] {
            assert_eq!(of(&format!("PARTNO X\n{line}\n")), Some(FileKind::PartProgram), "{line}");
        }
        let wide: Vec<u8> =
            "\u{feff}P = POINT/1,2\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
        assert_eq!(FileKind::of(&wide), Some(FileKind::PartProgram));
    }

    /// What no kind has to itself stays untold: CL data, programs of points alone, words of one letter and a number.
    #[test]
    fn cl_data_and_plain_programs_are_no_other_kind() {
        let cl =
            "PARTNO X\nUNITS/MM\n$$ A = LINE/1\nPPRINT A = LINE/2\nINSERT G54\nGOTO/1,2,3\nFINI\n";
        assert_eq!(of(cl), None);
        assert_eq!(of("A1\nM2\nG4\nX = 3\nY = X/2\nB = SQRTF(4)\nZ = 2\nGOTO/X,Y\n"), None);
        assert_eq!(of("$$\u{1}\nPARTNO X\nUNITS/MM\nGOTO/1,2,3\nGOTO/4,5,6\n"), None);
    }
}
