//! What PUNCH saves: statements that READ/1 of another program reads.

use std::fmt::Write as _;

use aptc_protap::NameRef;
use aptc_vocabulary::word;

/// Columns of a card for its statement.
const COLUMNS: usize = 72;

/// The cards that give `name` the canonical `elements` of the type `kind`, SCALAR for a number; a remark for a type
/// that has no such form.
pub(super) fn statement(name: &NameRef, kind: &str, elements: &[f64]) -> Vec<String> {
    let name = match name.subscript {
        0 => name.name.to_string(),
        n => format!("{}({n})", name.name),
    };
    let triple = |p: &[f64]| format!("(POINT/{},{},{})", p[0], p[1], p[2]);
    let (head, fields): (String, Vec<String>) = if kind == "SCALAR" {
        (format!("{name}="), elements.iter().map(f64::to_string).collect())
    } else if kind == word::PATERN.text() {
        (format!("{name}=PATERN/RANDOM,"), elements.chunks_exact(3).map(triple).collect())
    } else if kind == word::RLDSRF.text() || kind == word::BOUNDS.text() {
        return vec![format!("$$ {name}: {kind} has no form by CANON")];
    } else {
        (format!("{name}={kind}/CANON,"), elements.iter().map(f64::to_string).collect())
    };
    let mut cards = Vec::new();
    let mut card = head;
    let last = fields.len().saturating_sub(1);
    for (i, field) in fields.iter().enumerate() {
        let comma = if i == last { "" } else { "," };
        if card.len() + field.len() + comma.len() + 1 > COLUMNS {
            card.push('$');
            cards.push(std::mem::take(&mut card));
        }
        write!(card, "{field}{comma}").expect("strings take all");
    }
    cards.push(card);
    cards
}
