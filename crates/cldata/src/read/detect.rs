//! Which dialect a file is in.

use aptc_diagnostics::Severity;

use super::layout;
use crate::{Dialect, Units, clfile, tape};

/// Bytes at the head of a file that are looked at.
pub(super) const HEAD: usize = 64 * 1024;

/// The dialect of a file by its first bytes (64 KiB are enough); ISO 4343 when nothing speaks for another.
pub fn dialect(head: &[u8]) -> Dialect {
    let head = &head[..head.len().min(HEAD)];
    if tape::looks_like(head) {
        return Dialect::Tape;
    }
    if clfile::looks_like(head) {
        return Dialect::Clfile;
    }
    if head.trim_ascii_start().first() == Some(&b'{') {
        return Dialect::Json;
    }
    let mut last = Vec::new();
    for line in lines(head) {
        let line = line.to_ascii_uppercase();
        if let Some(found) = by_line(&line) {
            return found;
        }
        // MODE stands in many programs, but only here as the statement before a PARTNO between quotes.
        let mode = matches!(last.as_slice(), b"MODE/MILL" | b"MODE/TURN");
        if mode && line.starts_with(b"PARTNO/'") {
            return Dialect::Fusion;
        }
        if !line.is_empty() && !line.starts_with(b"$$") {
            last = line;
        }
    }
    Dialect::Iso
}

/// The statements' part of each line, without the blanks around it.
fn lines(head: &[u8]) -> impl Iterator<Item = &[u8]> {
    let layout = layout::of(head);
    head.split(move |b| *b == layout.eol)
        .map(move |line| line.get(layout.skip..).unwrap_or_default().trim_ascii())
}

/// A line that only one dialect has, in capitals.
fn by_line(line: &[u8]) -> Option<Dialect> {
    let has = |what: &[u8]| memchr::memmem::find(line, what).is_some();
    let starts = |what: &[u8]| line.starts_with(what);
    let comment = starts(b"$$");
    if comment && (has(b"CATIA APT") || has(b"*CATIA0")) {
        return Some(Dialect::Catia);
    }
    if has(b"PRO/CLFILE") || starts(b"$$->") || starts(b"REMARK ->") {
        return Some(Dialect::Creo);
    }
    if is_tool_path(line) || starts(b"TLDATA/") || starts(b"PAINT/") {
        return Some(Dialect::Nx);
    }
    if starts(b"CSI_SET_") || starts(b"TRNTYP/") || starts(b"CYCLE/INIT") {
        return Some(Dialect::Camworks);
    }
    if starts(b"MCSYS/") || starts(b"OPNAME") || starts(b"MOVARC/ CENTER") {
        return Some(Dialect::Dmg);
    }
    if starts(b"REMARK") && has(b"NCL") {
        return Some(Dialect::Ncl);
    }
    None
}

/// `TOOL PATH/` with blanks or tabs between.
fn is_tool_path(line: &[u8]) -> bool {
    let path = line.strip_prefix(b"TOOL").filter(|rest| rest.first().is_some_and(is_blank));
    let slash = path.and_then(|rest| rest.trim_ascii_start().strip_prefix(b"PATH"));
    slash.is_some_and(|rest| rest.trim_ascii_start().starts_with(b"/"))
}

fn is_blank(byte: &u8) -> bool {
    byte.is_ascii_whitespace()
}

/// Is there a mark of the source's lines?
pub(super) fn marked(head: &[u8]) -> bool {
    [&b"$$ LINE "[..], b"$$ ISN "].iter().any(|m| memchr::memmem::find(head, m).is_some())
}

/// What the head of a text says about the unit.
pub(super) enum Unit {
    /// It is stated, or will be; the unit unless it is not known.
    Stated(Option<Units>),
    /// Feeds are in this unit; lengths will be too.
    Feeds(Units),
    /// Nothing says it, and the system that wrote the file works in this unit if it is not told otherwise.
    Usual(Units),
    /// Nothing says it.
    Unknown,
}

/// Looks for UNITS or UNIT, else for feeds in millimetres or inches.
pub(super) fn unit(head: &[u8]) -> Unit {
    let mut feeds = None;
    for line in lines(head) {
        let line = line.to_ascii_uppercase();
        if line.starts_with(b"$$") {
            continue;
        }
        let word = line.split(|b| *b == b'/').next().unwrap_or(&line).trim_ascii_end();
        if matches!(word, b"UNITS" | b"UNIT") {
            let rest = memchr::memchr(b'/', &line).map_or(&b""[..], |slash| &line[slash + 1..]);
            return Unit::Stated(super::words::unit_named(rest));
        }
        if !matches!(word, b"FEDRAT" | b"CYCLE" | b"TOOLNO") || feeds.is_some() {
            continue;
        }
        let rest = memchr::memchr(b'/', &line).map_or(&b""[..], |slash| &line[slash..]);
        for field in rest.split(|b| matches!(b, b',' | b'/')) {
            match field.trim_ascii() {
                b"MMPM" | b"MMPR" => feeds = Some(Units::Mm),
                b"IPM" | b"IPR" => feeds = Some(Units::Inches),
                _ => {}
            }
        }
    }
    feeds.map_or(Unit::Unknown, Unit::Feeds)
}

impl Unit {
    /// The same, knowing who wrote the file.
    pub(super) fn of(self, dialect: Dialect) -> Self {
        match (self, dialect) {
            (Self::Unknown, Dialect::Catia) => Self::Usual(Units::Mm),
            (other, _) => other,
        }
    }

    /// The unit to be stated before the first record, and what is to be said about it.
    pub(super) fn statement(&self) -> Option<(Option<Units>, Severity, &'static str)> {
        match self {
            Self::Stated(_) => None,
            Self::Feeds(Units::Mm) => Some((
                Some(Units::Mm),
                Severity::Note,
                "the unit is not stated; millimetres, as the feeds are",
            )),
            Self::Feeds(u) => {
                Some((Some(*u), Severity::Note, "the unit is not stated; inches, as the feeds are"))
            }
            Self::Usual(u) => Some((
                Some(*u),
                Severity::Warning,
                "the unit is not stated; millimetres are taken, as CATIA has them",
            )),
            Self::Unknown => {
                Some((None, Severity::Warning, "the unit is not stated; inches are taken"))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dialects_by_their_marks() {
        for (text, expected) in [
            ("PARTNO X\nUNITS/MM\nGOTO/1,2,3\n", Dialect::Iso),
            ("$$ ---\n$$     CATIA APT VERSION 1.0\n", Dialect::Catia),
            ("$$*          Pro/CLfile  Version 11.0\n", Dialect::Creo),
            ("PARTNO / M\nREMARK -> MFGNO / M\n", Dialect::Creo),
            ("TOOL PATH/A,TOOL,B\n", Dialect::Nx),
            ("TOOL\tPATH/A,TOOL,B\n", Dialect::Nx),
            ("TOOL \t PATH\t/A,TOOL,B\n", Dialect::Nx),
            ("TOOLPATH/A\n", Dialect::Iso),
            ("PARTNO/1\nUNIT/MM\nCSI_SET_FLUTE_LENGTH/4.\n", Dialect::Camworks),
            ("PARTNO/ 'x'\nOPNAME 'y'\n", Dialect::Dmg),
            ("MODE/MILL\nPARTNO/'1001'\n", Dialect::Fusion),
            ("MODE/MILL\n\n$$ VERSION 5\n  \nPARTNO/'1001'\n", Dialect::Fusion),
            ("MODE/TURN\nUNITS/MM\nPARTNO/'1001'\n", Dialect::Iso),
            ("MODE/MILL\nPARTNO 1001\n", Dialect::Iso),
            ("REMARK a.as  18-MAR-2019  NCLCAM 2018\n", Dialect::Ncl),
            ("{\"kind\"", Dialect::Json),
            ("", Dialect::Iso),
        ] {
            assert_eq!(dialect(text.as_bytes()), expected, "{text}");
        }
    }

    #[test]
    fn units_by_feeds() {
        assert!(matches!(unit(b"FEDRAT/ 0.1,MMPR\n"), Unit::Feeds(Units::Mm)));
        assert!(matches!(unit(b"FEDRAT/IPM,5\nUNIT/MM\n"), Unit::Stated(Some(Units::Mm))));
        assert!(matches!(unit(b"$$ UNITS/MM\nGOTO/1,2,3\n"), Unit::Unknown));
    }
}
