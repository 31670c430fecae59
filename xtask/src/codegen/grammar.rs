//! The TextMate grammars of part programs and of CL text, for editors.

use serde_json::{Value, json};

use super::Row;

/// Grammar of `.apt` files.
pub(super) fn part_program(rows: &[Row]) -> String {
    let rules = [
        line("comment.line.double-dollar.apt", r"\$\$.*$"),
        fixed_field(rows),
        line("entity.name.label.apt", r"^\s*[A-Za-z0-9]+(?:\)|:)(?=\s|[A-Za-z])"),
        json!({
            "match": r"(?i)\b([A-Z0-9]{1,8})\s*=\s*(MACRO)\b",
            "captures": {"1": name("entity.name.function.apt"), "2": name("keyword.control.apt")},
        }),
        line("variable.other.definition.apt", r"\b[A-Za-z0-9]{1,8}(?=\s*(?:\([^)]*\))?\s*=[^=])"),
        line("string.quoted.single.apt", "'[^']*'"),
        line(
            "constant.numeric.apt",
            r"(?<![A-Za-z0-9])(?:\d+\.?\d*|\.\d+)(?:[Ee][+-]?\d+)?(?![A-Za-z])",
        ),
        line("punctuation.separator.continuation.apt", r"\$\s*$"),
        words(rows, "storage.type.geometry.apt", &["Geometry", "Regional"]),
        words(rows, "keyword.control.apt", &["Control"]),
        words(rows, "keyword.other.motion.apt", &["Motion"]),
        words(rows, "support.function.post.apt", &["Post"]),
        words(rows, "support.function.arithmetic.apt", &["Function"]),
        words(rows, "constant.language.modifier.apt", &["Modifier"]),
        line("keyword.operator.logical.apt", &format!(r"(?i)\.(?:{})\.", dotted(rows))),
        line("keyword.operator.apt", r"\*\*|[-+*/=,]"),
    ];
    text(&json!({
        "name": "APT part program",
        "scopeName": "source.apt",
        "fileTypes": ["apt"],
        "patterns": rules,
    }))
}

/// Grammar of CL text: that of part programs, and the comments that carry data.
pub(super) fn cl_text() -> String {
    text(&json!({
        "name": "APT CL data",
        "scopeName": "source.apt.cl",
        "fileTypes": ["cl", "cls", "ncl", "aptsource"],
        "patterns": [
            line("meta.preprocessor.origin.apt.cl", r"^\$\$ (?:LINE|CIRCLE)\b.*$"),
            line("meta.preprocessor.structured.apt.cl", r"^(?:\$\$|REMARK) ?->.*$"),
            json!({"include": "source.apt"}),
        ],
    }))
}

/// Words that take the rest of their line as text, also without a blank.
fn fixed_field(rows: &[Row]) -> Value {
    json!({
        "match": format!(r"(?i)^\s*({})(.*)$", alternatives(rows, &["Text"])),
        "captures": {"1": name("keyword.other.text.apt"), "2": name("string.unquoted.apt")},
    })
}

fn words(rows: &[Row], scope: &str, classes: &[&str]) -> Value {
    line(scope, &format!(r"(?i)(?<![A-Z0-9])(?:{})(?![A-Z0-9])", alternatives(rows, classes)))
}

fn alternatives(rows: &[Row], classes: &[&str]) -> String {
    // A letter alone is more often a symbol of the program.
    let of = |row: &&Row| classes.contains(&row.class.as_str()) && row.word.len() > 1;
    rows.iter().filter(of).map(|row| row.word.as_str()).collect::<Vec<_>>().join("|")
}

fn dotted(rows: &[Row]) -> String {
    let dotted = rows.iter().filter_map(|row| row.word.strip_prefix('.'));
    dotted.collect::<Vec<_>>().join("|")
}

fn line(scope: &str, pattern: &str) -> Value {
    json!({"name": scope, "match": pattern})
}

fn name(scope: &str) -> Value {
    json!({"name": scope})
}

fn text(grammar: &Value) -> String {
    format!("{grammar:#}\n")
}
