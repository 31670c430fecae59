//! The numbers of a definition in the order written, for print-outs and checks.

use std::sync::Arc;

use super::{CurveDefinition, Knot, Smoothing};
use crate::{Transform, Vec3};

pub(super) fn push(out: &mut Vec<f64>, points: &[Vec3]) {
    out.extend(points.iter().flat_map(|p| [p.x, p.y, p.z]));
}

pub(super) fn push_smoothing(out: &mut Vec<f64>, s: &Smoothing) {
    out.extend(s.weight.into_iter().chain(s.limit));
}

pub(super) fn push_knots(out: &mut Vec<f64>, knots: &[Knot]) {
    for knot in knots {
        push(out, &[knot.point]);
        for v in [knot.tangent, knot.cross, knot.normal].into_iter().flatten() {
            push(out, &[v]);
        }
        push_smoothing(out, &knot.smoothing);
    }
}

pub(super) fn push_curves(out: &mut Vec<f64>, curves: &[Arc<CurveDefinition>]) {
    curves.iter().for_each(|c| out.extend(c.numbers()));
}

pub(super) fn push_map(out: &mut Vec<f64>, map: Option<&Transform>) {
    out.extend(map.iter().flat_map(|m| m.rows()));
}
