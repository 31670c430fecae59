//! The unit of an IGES file and the scale of its model, fields 13 to 15 of the global section.

use super::number;
use crate::{Fault, broken};

/// The fields, from 0.
const SCALE: usize = 12;
const FLAG: usize = 13;
const NAME: usize = 14;

/// What a flag above 0 stands for, in millimetres; the name counts where it is 3.
const FLAGS: [(u32, f64); 10] = [
    (1, 25.4),
    (2, 1.0),
    (4, 304.8),
    (5, 1_609_344.0),
    (6, 1000.0),
    (7, 1e6),
    (8, 0.0254),
    (9, 1e-3),
    (10, 10.0),
    (11, 25.4e-6),
];

/// Millimetres of what a name stands for.
const NAMES: [(&str, f64); 16] = [
    ("IN", 25.4),
    ("INCH", 25.4),
    ("INCHES", 25.4),
    ("MM", 1.0),
    ("MILLIMETER", 1.0),
    ("MILLIMETRE", 1.0),
    ("FT", 304.8),
    ("FEET", 304.8),
    ("M", 1000.0),
    ("METER", 1000.0),
    ("CM", 10.0),
    ("KM", 1e6),
    ("MI", 1_609_344.0),
    ("UM", 1e-3),
    ("MIL", 0.0254),
    ("UIN", 25.4e-6),
];

fn field(fields: &[String], k: usize) -> &str {
    fields.get(k).map_or("", |f| f.trim())
}

/// Lengths of the model for lengths of the part: 1 where the file leaves it out.
pub(super) fn scale(fields: &[String]) -> Result<f64, Fault> {
    let text = field(fields, SCALE);
    if text.is_empty() {
        return Ok(1.0);
    }
    let scale = number(text).filter(|s| *s > 0.0);
    scale.ok_or_else(|| broken(format!("the scale of its model is {text}, and not above zero")))
}

/// Millimetres of the unit; `None` where the file names none that is known, which is told.
///
/// Without flag and name it is the inch, by the standard.
pub(super) fn unit(fields: &[String], notes: &mut Vec<String>) -> Option<f64> {
    let [flag, name] = [FLAG, NAME].map(|k| field(fields, k));
    let upper = name.to_ascii_uppercase();
    let named = NAMES.iter().find(|n| n.0 == upper).map(|n| n.1);
    let number = number(flag);
    let is = |k: u32| number.is_some_and(|x| (x - f64::from(k)).abs() < 0.5);
    if let Some((_, mm)) = FLAGS.iter().find(|f| is(f.0)) {
        if named.is_some_and(|n| (n - mm).abs() > 1e-9 * mm) {
            notes.push(format!(
                "the flag of its unit is {flag} and the name {name}; the flag counts, a unit of {mm} mm"
            ));
        }
        return Some(*mm);
    }
    if flag.is_empty() && name.is_empty() {
        return Some(25.4);
    }
    let taken = match named {
        Some(_) if flag.is_empty() || is(3) => return named,
        Some(_) => "the name",
        None => "the unit of the program",
    };
    let shown = |text: &str| if text.is_empty() { "empty".to_owned() } else { text.to_owned() };
    notes.push(format!(
        "its unit is not known (flag {}, name {}); {taken} is taken",
        shown(flag),
        shown(name)
    ));
    named
}
