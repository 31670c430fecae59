//! What a file is, by its looks: so that the wrong one is refused in a word, not misread from end to end.

use std::fmt;

use aptc_cldata::source;

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
    /// Statements without a definition: CL data, or a part program that defines nothing.
    Statements,
    /// Blocks of a control.
    MachineCode,
    /// The same in the plain language of Heidenhain.
    PlainCode,
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
    /// The kind of a file that begins so; `None` where nothing tells. CL data are a part program without definitions, so that a text
    /// without any may be both.
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
        if let Some(code) = code(lines.clone()) {
            return Some(code);
        }
        let mut statements =
            lines.clone().filter(|line| line.starts_with("$$") || is_statement(line));
        let statements = statements.next().map(|_| Self::Statements);
        // A text may look like a definition, also where it goes on in further lines.
        let mut in_text = false;
        let definition = lines.any(|line| {
            let text = in_text || source::is_text(line.as_bytes());
            in_text = text && line.ends_with('$');
            !text && source::is_definition(line.as_bytes())
        });
        if definition { Some(Self::PartProgram) } else { statements }
    }
}

impl fmt::Display for FileKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Empty => "empty",
            Self::PartProgram => "a part program",
            Self::Statements => "CL data or a part program",
            Self::MachineCode | Self::PlainCode => "machine code",
            Self::Markup => "a drawing or a page (SVG, HTML, XML)",
            Self::Listing => "a listing",
            Self::Protap => "a numeric part program (.protap)",
            Self::Binary => "binary",
        })
    }
}

/// Machine code, where most of the first lines are blocks, three of them with a G or M word, and none a statement; or where the
/// first says that it begins in plain language.
fn code<'a>(lines: impl Iterator<Item = &'a str> + Clone) -> Option<FileKind> {
    let comment = |line: &&str| line.starts_with([';', '(', '%', ':']);
    let (mut all, mut seen, mut blocks, mut coded) = (lines.clone(), 0, 0, 0);
    for line in lines.filter(|line| !comment(line)).take(LINES) {
        let unnumbered = line.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start();
        if seen == 0 && unnumbered.starts_with("BEGIN PGM ") {
            return Some(FileKind::PlainCode);
        }
        seen += 1;
        if let Some(codes) = codes(line) {
            blocks += 1;
            coded += usize::from(codes > 0);
        }
    }
    let code = coded >= 3 && 2 * blocks > seen && !all.any(is_statement);
    code.then_some(FileKind::MachineCode)
}

/// A statement of part programs and CL data that no control takes. Some have GOTO too, without a slash.
fn is_statement(line: &str) -> bool {
    let line = source::unlabelled(line.as_bytes());
    let slashed: [&[u8]; 7] =
        [b"UNITS", b"FROM", b"CUTTER", b"MULTAX", b"LOADTL", b"TOOL PATH", b"GOTO"];
    let behind = |word: &&[u8]| line.strip_prefix(*word).map(<[u8]>::trim_ascii_start);
    line.starts_with(b"PARTNO")
        || line == b"FINI"
        || slashed.iter().find_map(behind).is_some_and(|rest| rest.starts_with(b"/"))
}

/// How many G and M words stand in a block, `None` where the line is none: addresses of one letter with a number each.
/// `G=4` is no code but a variable.
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
        let code = matches!(letter, 'G' | 'M');
        if end == 0 || (code && rest[1..rest.len() - number.len()].contains('=')) {
            return None;
        }
        codes += usize::from(code);
        rest = number[end..].trim_start();
    }
    Some(codes)
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
        assert_eq!(of("0 BEGIN PGM PLATE MM\n1 L X+5\n"), Some(FileKind::PlainCode));
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

    /// Scalars of one letter are no codes, and a line that no control takes decides.
    #[test]
    fn part_programs_are_no_machine_code() {
        assert_eq!(of("PARTNO X\nG=1\nG=2\nG=3\nFINI\n"), Some(FileKind::Statements));
        assert_eq!(of("A=1\nB=2\nC=3\nG=4\nM = 5\nG=6\nA1\n"), None);
        for line in ["PARTNO X", "UNITS/MM", "FROM /0,0,0", "G1 ) FROM/0,0,0", "CUTTER/5", "FINI"] {
            let kind = of(&format!("G1 X1\nG4\nM3\nM30\nG7\n{line}\n"));
            assert_eq!(kind, Some(FileKind::Statements), "{line}");
        }
        assert_eq!(of("G1 X1\nG4\nM3\nM30\nGOTO 7\n$$\n"), Some(FileKind::MachineCode));
        assert_eq!(of("G1 X=1\nG4\nM3\nM30\nG7\n"), Some(FileKind::MachineCode));
    }

    /// A text word heads a text, with or without a blank behind it, and what goes on with it.
    #[test]
    fn texts_hold_no_definitions() {
        for text in [
            "PPRINTP1=POINT/HOLE 3\n",
            "REMARK surfaces $\nA=PLANE/1,2\n",
            "INSERT A $\r\nB=LINE/1,$\r\nC=LINE/2\r\n",
        ] {
            let plain = of(&format!("PARTNO A\n{text}GOTO/1,2,3\n"));
            assert_eq!(plain, Some(FileKind::Statements), "{text}");
            let more = format!("PARTNO A\n{text}GOTO/1,2,3\nA=PLANE/0,0,1,2\n");
            assert_eq!(of(&more), Some(FileKind::PartProgram), "{text}");
        }
        assert_eq!(of("PARTNO A\n10) L1=LINE/XAXIS\n"), Some(FileKind::PartProgram));
    }

    /// CL data and programs of points alone are alike; words of one letter and a number tell nothing.
    #[test]
    fn cl_data_and_plain_programs_are_statements() {
        let cl =
            "PARTNO X\nUNITS/MM\n$$ A = LINE/1\nPPRINT A = LINE/2\nINSERT G54\nGOTO/1,2,3\nFINI\n";
        assert_eq!(of(cl), Some(FileKind::Statements));
        assert_eq!(of("A1\nM2\nG4\nX = 3\nY = X/2\nB = SQRTF(4)\nZ = 2\n"), None);
        for text in ["$$ A\nX = 3\n", "TOOL PATH/A,TOOL,B\n", " goto /1,2,3\n", "10) LOADTL/1\n"] {
            assert_eq!(of(text), Some(FileKind::Statements), "{text}");
        }
    }
}
