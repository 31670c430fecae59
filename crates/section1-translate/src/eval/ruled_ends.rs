//! Whether the ends that a RLDSRF names are ends of its curves.

use aptc_diagnostics::{Diagnostic, codes};
use aptc_geometry::{Form, Surface, Vec3};
use aptc_protap::NameRef;
use aptc_vocabulary::{Word, word};

use crate::Interpreter;
use crate::define::{Arg, Value};

/// Parts of the line between the ends that an end may lie off its surface: a point read off a drawing is as near, one of
/// another curve is not.
const BESIDE: f64 = 0.01;

impl Interpreter<'_> {
    /// Says which ends lie off the surface whose cut they should end: rulings stand over the line between the ends, and
    /// begin elsewhere.
    pub(super) fn ruled_ends(&mut self, head: Word, args: &[Arg]) {
        if head != word::RLDSRF {
            return;
        }
        for at in [0, 4] {
            let [Some(of), Some(a), Some(b)] = [0, 1, 2].map(|i| args.get(at + i)) else { return };
            let (Some(surface), Some(p), Some(q)) = (surface(of), point(a), point(b)) else {
                return;
            };
            for (end, place) in [(a, p), (b, q)] {
                let off = surface.distance(place).abs();
                // A quadric may have no nearest place for a point, which says nothing.
                if !off.is_finite() || off <= BESIDE * (q - p).norm() {
                    continue;
                }
                let (end_named, of_named) = (named(end, "the point"), named(of, "its surface"));
                let message =
                    format!("{end_named} lies {off:.4} off {of_named}, whose cut it should end");
                self.error(
                    Diagnostic::warning(codes::END_BESIDE, end.span, message)
                        .help(format!("give the ends of the curve: places on {of_named}")),
                );
            }
        }
    }
}

fn surface(arg: &Arg) -> Option<Surface> {
    match &arg.value {
        Value::Form { form, .. } => match &**form {
            Form::Written(w) => Surface::from_form(&w.shape),
            form => Surface::from_form(form),
        },
        _ => None,
    }
}

fn point(arg: &Arg) -> Option<Vec3> {
    match &arg.value {
        Value::Form { form, .. } => match **form {
            Form::Point(p) => Some(p),
            _ => None,
        },
        _ => None,
    }
}

fn named<'a>(arg: &'a Arg, other: &'a str) -> &'a str {
    match &arg.value {
        Value::Form { name: NameRef { name, .. }, .. } if !name.is_empty() => name,
        _ => other,
    }
}
