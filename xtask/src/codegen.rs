//! Generates the word tables of `aptc-vocabulary` and the grammars for editors from `words.tsv`.
//!
//! The table is data that people edit; what the compiler needs of it (packed spellings for the hash,
//! codes sorted for the way back) is derived here once instead of at each start of the program.

mod grammar;

use std::collections::BTreeMap;
use std::fmt::Write as _;

use crate::repository::{read, root};

/// Dialect columns of the table, in the order of `aptc_vocabulary::Dialect`.
const DIALECTS: [&str; 6] = ["APT-360", "APT4", "PostWorks", "NCL", "IBM CL", "CL text"];
const HEADER: &str = "word\tclass\talso\tapt360\tapt4\tpostworks\tncl\tibm\ttext";
const CLASSES: [&str; 9] = [
    "Geometry", "Motion", "Control", "Function", "Text", "Post", "Regional", "Operator", "Modifier",
];
/// Slots of the hash table. Four times the words keeps runs of full slots short.
const SLOT_BITS: u32 = 12;
const EMPTY: u16 = u16::MAX;

/// Whether to write the generated file or to compare it with what is there.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Mode {
    /// Write the file.
    Write,
    /// Fail when the file differs.
    Check,
}

/// Runs the chore.
pub(crate) fn run(mode: Mode) -> Result<(), String> {
    let crate_dir = root().join("crates/vocabulary");
    let rows = parse(&read(&crate_dir.join("words.tsv"))?)?;
    let files = [
        (crate_dir.join("src/table.rs"), generate(&rows)?),
        (root().join("editors/apt.tmLanguage.json"), grammar::part_program(&rows)),
        (root().join("editors/apt-cl.tmLanguage.json"), grammar::cl_text()),
    ];
    for (path, generated) in files {
        if mode == Mode::Write {
            std::fs::write(&path, generated)
                .map_err(|error| format!("{}: {error}", path.display()))?;
        } else if !read(&path).is_ok_and(|present| present == generated) {
            return Err(format!("{} is stale; run `cargo xtask codegen`", path.display()));
        }
    }
    Ok(())
}

/// A code as the table writes it: `1031M`, `73m`, `6000:2M`, `s4M` (surface type), `-M`.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Cell {
    major: bool,
    code: CellCode,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum CellCode {
    Known,
    Word(u16),
    Surface(u8),
    Record(u16, u8),
}

struct Row {
    word: String,
    class: String,
    also: Option<String>,
    cells: Vec<Vec<Cell>>,
}

fn parse(text: &str) -> Result<Vec<Row>, String> {
    let mut lines = text.lines();
    if lines.next() != Some(HEADER) {
        return Err("words.tsv: unexpected header".to_owned());
    }
    let mut rows: Vec<Row> = Vec::new();
    for (line, number) in lines.zip(2..) {
        let row = parse_row(line).map_err(|error| format!("words.tsv line {number}: {error}"))?;
        if rows.last().is_some_and(|last| last.word >= row.word) {
            return Err(format!("words.tsv line {number}: `{}` is out of order", row.word));
        }
        rows.push(row);
    }
    Ok(rows)
}

fn parse_row(line: &str) -> Result<Row, String> {
    let mut fields: Vec<&str> = line.split('\t').collect();
    fields.resize(3 + DIALECTS.len(), "");
    let known = |class: &str| {
        CLASSES.contains(&class).then(|| class.to_owned()).ok_or(format!("no class `{class}`"))
    };
    let word = fields[0].to_owned();
    let spelled = word.bytes().all(|b| b.is_ascii_uppercase() || b.is_ascii_digit() || b == b'.');
    if !spelled || word.is_empty() || word.len() > 8 {
        return Err(format!("`{word}` is not 1 to 8 capital letters and digits"));
    }
    let also = if fields[2].is_empty() { None } else { Some(known(fields[2])?) };
    let cells = fields[3..]
        .iter()
        .map(|field| field.split_ascii_whitespace().map(parse_cell).collect())
        .collect::<Result<Vec<Vec<Cell>>, String>>()?;
    if cells.iter().all(Vec::is_empty) {
        return Err(format!("`{word}` belongs to no dialect"));
    }
    Ok(Row { word, class: known(fields[1])?, also, cells })
}

fn parse_cell(text: &str) -> Result<Cell, String> {
    let wrong = || format!("`{text}` is not a code such as 1031M, 73m, 6000:2M, s4M or -m");
    let (digits, major) = match text.split_at_checked(text.len() - 1) {
        Some((digits, "M")) => (digits, true),
        Some((digits, "m")) => (digits, false),
        _ => return Err(wrong()),
    };
    let code = match digits.split_once(':') {
        _ if digits == "-" => CellCode::Known,
        _ if digits.starts_with('s') => {
            CellCode::Surface(digits[1..].parse().map_err(|_| wrong())?)
        }
        Some((record, subtype)) => CellCode::Record(
            record.parse().map_err(|_| wrong())?,
            subtype.parse().map_err(|_| wrong())?,
        ),
        None => CellCode::Word(digits.parse().map_err(|_| wrong())?),
    };
    Ok(Cell { major, code })
}

/// The spelling as a number, first letter lowest; the same as `aptc_vocabulary::pack`.
fn pack(word: &str) -> u64 {
    word.bytes().rev().fold(0, |packed, byte| packed << 8 | u64::from(byte))
}

fn home(packed: u64, multiplier: u64) -> usize {
    usize::try_from(packed.wrapping_mul(multiplier) >> (64 - SLOT_BITS)).expect("12 bits fit")
}

/// Multiplier and slots whose longest probe is shortest among the multipliers tried.
fn hash_table(rows: &[Row]) -> (u64, Vec<u16>) {
    let mut best: Option<(usize, u64, Vec<u16>)> = None;
    let mut multiplier: u64 = 0x9E37_79B9_7F4A_7C15;
    for _ in 0..2_000 {
        multiplier = multiplier.wrapping_mul(0xD134_2543_DE82_EF95).wrapping_add(2) | 1;
        let mut slots = vec![EMPTY; 1 << SLOT_BITS];
        let mut longest = 0;
        for (row, index) in rows.iter().zip(0u16..) {
            let start = home(pack(&row.word), multiplier);
            let probe = (0..slots.len())
                .find(|step| slots[(start + step) % slots.len()] == EMPTY)
                .expect("four slots a word");
            let length = slots.len();
            slots[(start + probe) % length] = index;
            longest = longest.max(probe);
        }
        if best.as_ref().is_none_or(|(least, ..)| longest < *least) {
            best = Some((longest, multiplier, slots));
        }
    }
    let (_, multiplier, slots) = best.expect("multipliers were tried");
    (multiplier, slots)
}

/// Codes to words. Where a code stands for several words of a dialect, the word known to most dialects
/// wins, then the longer spelling, then the alphabet.
fn by_code(rows: &[Row]) -> BTreeMap<(usize, bool, u32), u16> {
    let mut best: BTreeMap<(usize, bool, u32), u16> = BTreeMap::new();
    let rank = |index: u16| {
        let row = &rows[usize::from(index)];
        (row.cells.iter().filter(|cells| !cells.is_empty()).count(), row.word.len())
    };
    for (row, index) in rows.iter().zip(0u16..) {
        for (dialect, cells) in row.cells.iter().enumerate() {
            for cell in cells.iter().filter(|cell| cell.code != CellCode::Known) {
                let place = best.entry((dialect, !cell.major, raw(cell.code))).or_insert(index);
                if rank(index) > rank(*place) {
                    *place = index;
                }
            }
        }
    }
    best
}

/// The code as `aptc_vocabulary::entry` stores it.
fn raw(code: CellCode) -> u32 {
    match code {
        CellCode::Known => u32::MAX,
        CellCode::Word(number) => u32::from(number),
        CellCode::Surface(number) => 1 << 30 | u32::from(number),
        CellCode::Record(record, subtype) => 1 << 31 | u32::from(record) << 8 | u32::from(subtype),
    }
}

fn rust_cell(cells: &[Cell], major: bool) -> String {
    match cells.iter().find(|cell| cell.major == major).map(|cell| cell.code) {
        None => "O".to_owned(),
        Some(CellCode::Known) => "K".to_owned(),
        Some(CellCode::Word(number)) => number.to_string(),
        Some(CellCode::Surface(number)) => format!("s({number})"),
        Some(CellCode::Record(record, subtype)) => format!("r({record}, {subtype})"),
    }
}

fn constant(word: &str) -> String {
    match word.as_bytes()[0] {
        b'.' => format!("DOT_{}", &word[1..]),
        b'0'..=b'9' => format!("W{word}"),
        _ => word.to_owned(),
    }
}

/// One line for readers of the documentation: `Motion; APT-360 8000:1, NCL 705`.
fn summary(row: &Row) -> String {
    let mut text = format!("`{}`: {}", row.word, row.class);
    if let Some(also) = &row.also {
        write!(text, " and {also}").expect("a string takes all");
    }
    let mut separator = "; ";
    for (name, cells) in DIALECTS.iter().zip(&row.cells) {
        for cell in cells {
            let kind = if cell.major { "" } else { " minor" };
            let code = match cell.code {
                CellCode::Known => String::new(),
                CellCode::Word(number) => format!(" {number}"),
                CellCode::Surface(number) => format!(" surface type {number}"),
                CellCode::Record(record, subtype) => format!(" {record}:{subtype}"),
            };
            write!(text, "{separator}{name}{kind}{code}").expect("a string takes all");
            separator = ", ";
        }
    }
    text
}

fn generate(rows: &[Row]) -> Result<String, String> {
    let mut out = String::new();
    write_all(&mut out, rows).map_err(|error| error.to_string())?;
    Ok(out)
}

fn write_all(out: &mut String, rows: &[Row]) -> std::fmt::Result {
    writeln!(
        out,
        "//! The words. Made by `cargo xtask codegen` from `words.tsv`: change that file.\n"
    )?;
    writeln!(
        out,
        "use crate::class::Class::{{\n    self, Control, Function, Geometry, Modifier, Motion, Operator, Post, Regional, Text,\n}};"
    )?;
    writeln!(out, "use crate::entry::{{Entry, K, O, entry as w, record as r, surface as s}};\n")?;
    writeln!(out, "const NONE: Option<Class> = None;\n")?;
    writeln!(out, "/// How many words there are.")?;
    writeln!(out, "pub(crate) const COUNT: u16 = {};\n", rows.len())?;
    writeln!(
        out,
        "/// Every word, sorted by spelling; a row of codes is major, minor for each dialect."
    )?;
    writeln!(out, "#[rustfmt::skip]")?;
    writeln!(out, "pub(crate) static ENTRIES: [Entry; COUNT as usize] = [")?;
    for row in rows {
        let also = row.also.as_ref().map_or("NONE".to_owned(), |class| format!("Some({class})"));
        let codes: Vec<String> = row
            .cells
            .iter()
            .map(|cells| format!("[{}, {}]", rust_cell(cells, true), rust_cell(cells, false)))
            .collect();
        writeln!(out, "    w(\"{}\", {}, {also}, [{}]),", row.word, row.class, codes.join(", "))?;
    }
    writeln!(out, "];\n")?;
    write_hash(out, rows)?;
    write_by_code(out, rows)?;
    writeln!(
        out,
        "/// The words as constants; a spelling that begins with a digit has `W` before it, one"
    )?;
    writeln!(out, "/// with a point `DOT_` in its place.")?;
    writeln!(out, "pub mod word {{")?;
    writeln!(out, "    use crate::Word;\n")?;
    for (index, row) in rows.iter().enumerate() {
        writeln!(out, "    /// {}.", summary(row))?;
        writeln!(out, "    pub const {}: Word = Word({index});", constant(&row.word))?;
    }
    writeln!(out, "}}")
}

fn write_hash(out: &mut String, rows: &[Row]) -> std::fmt::Result {
    let (multiplier, slots) = hash_table(rows);
    writeln!(
        out,
        "/// Spreads packed spellings over `SLOTS`: chosen so that the longest probe is short."
    )?;
    writeln!(out, "pub(crate) const MULTIPLIER: u64 = {multiplier:#018x};\n")?;
    writeln!(out, "/// Packed spellings, in the order of `ENTRIES`.")?;
    writeln!(out, "#[rustfmt::skip]")?;
    writeln!(out, "pub(crate) static PACKED: [u64; COUNT as usize] = [")?;
    for chunk in rows.chunks(8) {
        let line: Vec<String> = chunk.iter().map(|row| format!("{:#x}", pack(&row.word))).collect();
        writeln!(out, "    {},", line.join(", "))?;
    }
    writeln!(out, "];\n")?;
    writeln!(
        out,
        "/// Open-addressed table of indices into `ENTRIES`; `u16::MAX` is an empty slot."
    )?;
    writeln!(out, "#[rustfmt::skip]")?;
    writeln!(out, "pub(crate) static SLOTS: [u16; {}] = [", slots.len())?;
    for chunk in slots.chunks(16) {
        let line: Vec<String> = chunk.iter().map(u16::to_string).collect();
        writeln!(out, "    {},", line.join(", "))?;
    }
    writeln!(out, "];\n")
}

fn write_by_code(out: &mut String, rows: &[Row]) -> std::fmt::Result {
    let codes = by_code(rows);
    writeln!(
        out,
        "/// (dialect, minor, stored code, index into `ENTRIES`), sorted for a binary search."
    )?;
    writeln!(out, "#[rustfmt::skip]")?;
    writeln!(out, "pub(crate) static BY_CODE: [(u8, bool, u32, u16); {}] = [", codes.len())?;
    for ((dialect, minor, code), index) in &codes {
        writeln!(out, "    ({dialect}, {minor}, {code:#x}, {index}),")?;
    }
    writeln!(out, "];\n")
}
