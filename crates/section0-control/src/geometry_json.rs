//! The canonical forms of all named geometry as one JSON object.

use std::fmt::Write as _;

use aptc_geometry::Form;

/// A named value at the end of a part program.
#[derive(Clone, Debug, PartialEq)]
pub enum Named {
    /// A number.
    Scalar(f64),
    /// A geometric form in the base system.
    Form(std::sync::Arc<Form>),
}

/// `{"P1": {"type": "POINT", "words": [1.0, 2.0, 0.0]}, ...}`, one name a line, in the order given. Keys
/// are upper case, `NAME(i)` for subscripted names; a PATERN has `points` in place of `words`.
pub fn geometry_json<'a>(items: impl IntoIterator<Item = (&'a str, &'a Named)>) -> String {
    let mut out = String::from("{");
    for (i, (name, value)) in items.into_iter().enumerate() {
        out.push_str(if i == 0 { "\n" } else { ",\n" });
        let name = serde_json::Value::from(name);
        let kind = match value {
            Named::Scalar(_) => "SCALAR",
            Named::Form(f) => f.kind().word(),
        };
        write!(out, "{name}: {{\"type\": \"{kind}\", ").expect("strings take all");
        match value {
            Named::Scalar(x) => write!(out, "\"words\": {}", list(&[*x])),
            Named::Form(f) => match &**f {
                Form::Pattern(p) => {
                    let points: Vec<_> = p.points.iter().map(|p| list(p.as_slice())).collect();
                    write!(out, "\"points\": [{}]", points.join(", "))
                }
                form => write!(out, "\"words\": {}", list(&form.canonical())),
            },
        }
        .expect("strings take all");
        out.push('}');
    }
    out.push_str("\n}\n");
    out
}

/// Numbers as JSON; `-0` is written as `0`.
fn list(values: &[f64]) -> String {
    let values: Vec<_> =
        values.iter().map(|&x| serde_json::Value::from(x + 0.0).to_string()).collect();
    format!("[{}]", values.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::{Pattern, Vec3};

    #[test]
    fn forms_stand_one_a_line() {
        let point = Named::Form(Form::Point(Vec3::new(1.0, -0.0, 0.5)).into());
        let points = vec![Vec3::zeros(), Vec3::x()];
        let pattern = Named::Form(Form::Pattern(Pattern { points }).into());
        let text = geometry_json([("P(1)", &point), ("PAT", &pattern), ("A", &Named::Scalar(2.0))]);
        assert_eq!(
            text,
            "{\n\"P(1)\": {\"type\": \"POINT\", \"words\": [1.0, 0.0, 0.5]},\n\
             \"PAT\": {\"type\": \"PATERN\", \"points\": [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]},\n\
             \"A\": {\"type\": \"SCALAR\", \"words\": [2.0]}\n}\n"
        );
    }
}
