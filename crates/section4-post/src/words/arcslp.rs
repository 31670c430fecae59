//! ARCSLP: arcs in place of runs of short lines.

use crate::args::Statement;
use crate::machine::Machine;
use crate::post::Post;
use crate::words::{bad_arguments, refuse};

/// `ARCSLP/LINCIR,ON[,t]` and `ARCSLP/LINCIR,OFF`: t is how far an arc may leave the lines, else `arcs.fit` of the
/// machine.
pub(super) fn arcslp(post: &mut Post, s: &Statement<'_>) {
    if s.word(0) != Some("LINCIR") {
        refuse(post, s, "the slope of an arc has to stand with its MOVARC");
        return;
    }
    if post.machine.arcs.is_none() {
        refuse(post, s, "the machine has no arcs");
        return;
    }
    match asked(s, &post.machine, post.st.units.mm()) {
        Some(fit) => {
            post.st.last_fit_mm = fit.or(post.st.fit_mm).or(post.st.last_fit_mm);
            post.st.fit_mm = fit;
        }
        None => bad_arguments(post, s, "ARCSLP/LINCIR,ON,t with a positive tolerance, or OFF"),
    }
}

/// The tolerance in millimetres that a statement sets: none for OFF; `None` where it has no meaning.
pub(crate) fn asked(s: &Statement<'_>, machine: &Machine, mm: f64) -> Option<Option<f64>> {
    match (s.word(0), s.word(1), s.number(2)) {
        (Some("LINCIR"), Some("OFF"), None) => Some(None),
        (Some("LINCIR"), Some("ON"), said) => {
            let own = machine.arcs.as_ref().map_or(0.0, |a| a.fit);
            let t = said.map_or(own, |t| t * mm);
            (t > 0.0 && t.is_finite()).then_some(Some(t))
        }
        _ => None,
    }
}
