//! READ/1 of a file that another program made: its surfaces get the name that READ gives.

use std::sync::Arc;

use aptc_diagnostics::{Diagnostic, codes};
use aptc_exchange::{Limits, Outside, read_named};
use aptc_geometry::{Form, Transform};
use aptc_syntax::tree::{Expr, ExprKind, Target};

use crate::Interpreter;
use crate::LoadedFile;
use crate::memory::Value;

impl Interpreter<'_> {
    /// Names the surfaces of a file of JSON, IGES, STEP or STL; `false` when it is of none of these. One surface
    /// gets the name, several the elements of an array of that name.
    pub(super) fn outside(&mut self, name: &Expr, file: &LoadedFile) -> bool {
        let Some(found) = read_named(&file.name, &file.text, &Limits::default()) else {
            let is_text = !file.text.contains('\0');
            if !is_text {
                self.unusable(
                    name,
                    format!(
                        "{} cannot be used: it is no text, and no binary STL file, whose length tells how many triangles it has",
                        file.name
                    ),
                );
            }
            return !is_text;
        };
        let surfaces = match found {
            Ok(outside) => self.told(name, file, outside),
            Err(why) => {
                self.unusable(name, format!("{} cannot be used: {why}", file.name));
                return true;
            }
        };
        let ExprKind::Name(symbol) = &name.kind else {
            self.unusable(name, format!("the surfaces of {} have no name", file.name));
            return true;
        };
        let n = surfaces.len();
        let place = self.memory.place(symbol.symbol);
        if n > 1 && matches!(self.memory.slot(place).value, Value::Unset) {
            let limit = self.options.limits.array_elements;
            if self.memory.n_elements().saturating_add(n) > limit {
                self.unusable(
                    name,
                    format!("{} holds {n} surfaces, more than the limit of elements", file.name),
                );
                return true;
            }
            self.memory.reserve(symbol.symbol, n, name.span);
        }
        for (k, form) in (1_u32..).zip(surfaces) {
            let number = Expr { kind: ExprKind::Number(f64::from(k)), span: name.span };
            let array = matches!(self.memory.slot(place).value, Value::Array(_));
            let subscript = (n > 1 || array).then(|| Box::new(number));
            let target = Target { name: *symbol, subscript, span: name.span };
            if self.name_form(&target, Ok(Arc::new(form)), false).is_err() {
                break;
            }
        }
        true
    }

    /// The surfaces in program units and in the base system; what the user should know of them is said.
    fn told(&mut self, name: &Expr, file: &LoadedFile, outside: Outside) -> Vec<Form> {
        if let Some((first, more)) = outside.notes.split_first() {
            // One message, for of several of one code at one place the first alone is told.
            let count = match more.len() {
                0 => String::new(),
                n => format!(" (1 of {} notes)", n + 1),
            };
            let message = format!("{}: {first}{count}", file.name);
            let message = Diagnostic::warning(codes::PART_OF_FILE, name.span, message)
                .help("make sure that the surfaces that are read are all that the cut needs");
            self.error(more.iter().fold(message, |m, note| m.note(note.clone())));
        }
        let scale = outside.unit_mm.map(|mm| mm / self.state.unit.mm());
        let scale = scale.filter(|s| (s - 1.0).abs() > 1e-12).map(Transform::scale);
        let carried = match (scale, self.state.refsys) {
            (Some(s), Some(m)) => Some(s.then(&m)),
            (a, b) => a.or(b),
        };
        let surfaces = outside.surfaces.into_iter().map(|mut s| {
            s.map = match (s.map, carried) {
                (Some(own), Some(c)) => Some(own.then(&c)),
                (a, b) => a.or(b),
            };
            Form::Ssurf(Arc::new(s))
        });
        surfaces.collect()
    }

    fn unusable(&mut self, name: &Expr, message: String) {
        self.error(Diagnostic::error(codes::BAD_SURFACE_FILE, name.span, message).help(
            "READ/1,name reads B-spline surfaces of JSON, IGES or STEP and triangles of STL",
        ));
        self.state.doubt.names = true;
    }
}
