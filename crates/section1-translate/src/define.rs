//! Geometric definitions: from the arguments of a major word to the canonical form.
//!
//! APT: `AGEOM`-family routines of Section 1. One file a major word; each begins with the table of its
//! formats. [`define`] finds the format that the arguments fit and solves it; [`canonical`] takes the
//! elements of CANON. Neither knows names, redefinition or nesting: the interpreter resolves those first.

mod arg;
mod bounds;
mod canon;
mod choose;
mod circle;
mod cone;
mod conic;
mod context;
mod cursor;
mod cylndr;
mod fault;
mod fits;
mod format;
mod line;
mod matrix;
mod meet;
mod message;
mod mismatch;
mod patern;
mod plane;
mod point;
mod polcon;
mod qadric;
mod rldsrf;
mod sculpted;
mod scurv;
mod sphere;
mod ssurf;
mod tabcyl;
mod vector;

#[cfg(test)]
mod tests;

use aptc_geometry::Form;
use aptc_vocabulary::{Word, word};

pub(crate) use arg::short;
pub use arg::{Arg, Value};
pub use canon::canonical;
pub(crate) use context::on_zsurf;
pub use context::{Beyond, Context, Found};
pub use fault::{DefineError, Fault};
pub use fits::Fits;
use format::Format;
pub(crate) use format::Item;
pub use mismatch::Mismatch;

/// Does `head` define geometry here?
pub fn is_definition(head: Word) -> bool {
    table(head).is_some()
}

/// The formats of a word in the notation of the manuals, `LINE/point,PARLEL,line`, in the order in which
/// they are tried; none for a word that defines nothing.
pub fn formats(head: Word) -> Vec<String> {
    let rows = table(head).unwrap_or_default().iter();
    rows.chain(sculptured(head)).map(|f| format!("{head}/{}", f.text())).collect()
}

/// How definitions begin that have this word as their first argument.
pub(crate) fn begun_with(word: Option<Word>) -> Vec<String> {
    let Some(word) = word else { return Vec::new() };
    let begins = |head: &Word| {
        let rows = table(*head).unwrap_or_default().iter();
        rows.filter_map(|f| f.items.first()).any(|item| item.is_word(word))
    };
    let heads = aptc_vocabulary::all().filter(|w| is_definition(*w));
    heads.filter(begins).map(|head| format!("{head}/{word},..")).collect()
}

/// The form that `head/args` defines.
///
/// Symbols stand in the base system; with a reference system in `context` they are carried into it
/// first and the result is carried back. `args` hold no CANON: see [`canonical`].
pub fn define(head: Word, args: &[Arg], context: &Context) -> Result<Form, DefineError> {
    let Some(formats) = table_for(head, args) else { return Err(DefineError::no_word(head)) };
    let Some(system) = &context.refsys else {
        return format::solve(head, formats, args, context);
    };
    if head == word::MATRIX && context.apt4 {
        return format::solve(head, formats, args, context);
    }
    let Some(inverse) = system.inverse() else { return Err(DefineError::flat_system()) };
    let local = context.inside();
    let mut moved = args.to_vec();
    for (i, arg) in moved.iter_mut().enumerate() {
        arg.carry(&inverse).map_err(|why| DefineError::not_carried(i, why))?;
    }
    let form = format::solve(head, formats, &moved, &local)?;
    context.found.replace(local.found.take());
    form.transformed(system).map_err(DefineError::result_not_carried)
}

/// The formats of a major word that are for arguments of this kind: those of sculptured forms stand apart,
/// so that neither is proposed for the other.
fn table_for(head: Word, args: &[Arg]) -> Option<&'static [Format]> {
    if sculpted::asked(head, args) { Some(sculptured(head)) } else { table(head) }
}

/// The formats of POINT and VECTOR that take sculptured forms.
fn sculptured(head: Word) -> &'static [Format] {
    match head {
        word::POINT => sculpted::POINTS,
        word::VECTOR => sculpted::VECTORS,
        _ => &[],
    }
}

/// The formats of a major word.
fn table(head: Word) -> Option<&'static [Format]> {
    Some(match head {
        word::POINT => point::FORMATS,
        word::LINE => line::FORMATS,
        word::PLANE => plane::FORMATS,
        word::CIRCLE => circle::FORMATS,
        word::CYLNDR => cylndr::FORMATS,
        word::SPHERE => sphere::FORMATS,
        word::CONE => cone::FORMATS,
        word::ELLIPS => conic::ELLIPS,
        word::HYPERB => conic::HYPERB,
        word::GCONIC => conic::GCONIC,
        word::LCONIC => conic::LCONIC,
        word::QADRIC => qadric::FORMATS,
        word::VECTOR => vector::FORMATS,
        word::MATRIX => matrix::FORMATS,
        word::PATERN => patern::FORMATS,
        word::TABCYL => tabcyl::FORMATS,
        word::RLDSRF => rldsrf::FORMATS,
        word::POLCON => polcon::FORMATS,
        word::SCURV => scurv::FORMATS,
        word::SSURF => ssurf::FORMATS,
        word::BOUNDS => bounds::BOUNDS,
        word::OBJECT => bounds::OBJECT,
        _ => return None,
    })
}
