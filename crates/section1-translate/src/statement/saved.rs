//! What PUNCH saves: statements that READ/1 of another program reads.

use std::fmt::Write as _;

use aptc_protap::NameRef;
use aptc_vocabulary::word;

/// Columns of a card for its statement.
const COLUMNS: usize = 72;

/// The cards that give `name` the canonical `elements` of the type `kind`, SCALAR for a number; a remark for what has no such
/// form.
pub(super) fn statement(name: &NameRef, kind: &str, elements: &[f64]) -> Vec<String> {
    let name = match name.subscript {
        0 => name.name.to_string(),
        n => format!("{}({n})", name.name),
    };
    let no_canon = [word::RLDSRF, word::BOUNDS, word::SSURF, word::SCURV];
    if no_canon.iter().any(|w| w.text() == kind) {
        return vec![format!("$$ {name}: {kind} has no form by CANON")];
    }
    if elements.is_empty() || !elements.iter().all(|x| x.is_finite()) {
        return vec![format!("$$ {name}: {kind} without values")];
    }
    let triple = |p: &[f64]| {
        [format!("(POINT/{}", number(p[0])), number(p[1]), format!("{})", number(p[2]))]
    };
    let (head, fields): (String, Vec<String>) = if kind == word::PATERN.text() {
        (format!("{name}=PATERN/RANDOM,"), elements.chunks_exact(3).flat_map(triple).collect())
    } else {
        let head = if kind == "SCALAR" { "=".to_owned() } else { format!("={kind}/CANON,") };
        (name + &head, elements.iter().copied().map(number).collect())
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

/// The shorter of the ways in which a number can be written to its last digit.
fn number(x: f64) -> String {
    let plain = x.to_string();
    let scaled = format!("{x:E}");
    let (mantissa, power) = scaled.split_once('E').expect("it is so written");
    let point = if mantissa.contains('.') { "" } else { "." };
    let scaled = format!("{mantissa}{point}E{power}");
    if scaled.len() < plain.len() { scaled } else { plain }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Whatever the numbers are, a card holds its columns and a number is written to its last digit.
        #[test]
        fn cards_hold_their_columns(
            digits in prop::collection::vec(-1.0_f64..1.0, 1..40), power in -300_i32..300, which in 0_usize..3,
        ) {
            let all: Vec<f64> = digits.iter().map(|x| x * 10.0_f64.powi(power)).collect();
            for x in &all {
                prop_assert_eq!(number(*x).parse::<f64>().unwrap().to_bits(), x.to_bits());
            }
            let name = NameRef { name: "SEVENS".into(), subscript: 1234 };
            let kind = ["SCALAR", "PATERN", "TABCYL"][which];
            for card in statement(&name, kind, &all) {
                prop_assert!(card.len() <= COLUMNS, "{card}");
            }
        }
    }

    #[test]
    fn what_has_no_form_is_a_remark() {
        let name = NameRef { name: "S".into(), subscript: 0 };
        for (kind, elements) in
            [("SSURF", &[0.0; 4][..]), ("PATERN", &[]), ("POINT", &[f64::NAN; 3])]
        {
            let cards = statement(&name, kind, elements);
            assert!(cards.len() == 1 && cards[0].starts_with("$$ S: "), "{cards:?}");
        }
    }
}
