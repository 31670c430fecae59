//! The pieces of curves put together where they meet, and where curves may end.

use super::trace::{Knot, Piece, Touch};
use crate::Vec3;
use crate::sculpt::{Layout, Sculptured};

/// Share of the tolerance up to which ends are in one place: both are found on one border.
const TOGETHER: f64 = 1e-3;
/// By how much parameters of an end may lie beside a border.
const AT_BORDER: f64 = 1e-6;

/// What a curve goes on with.
enum Next {
    /// The piece of this number; from its end back, or not.
    Piece(usize, bool),
    /// Its own beginning.
    Beginning,
}

/// Curves from pieces whose ends are no farther apart than the tolerance.
pub(super) fn join(mut pieces: Vec<Piece>, tolerance: f64) -> Vec<Piece> {
    let mut curves = Vec::new();
    while !pieces.is_empty() {
        let mut curve = pieces.remove(0);
        if !curve.closed {
            for _ in 0..2 {
                extend(&mut curve, &mut pieces, tolerance);
                turn(&mut curve.knots);
            }
        }
        curves.push(curve);
    }
    curves
}

/// Goes on at the end of a curve as long as something begins there.
fn extend(curve: &mut Piece, pieces: &mut Vec<Piece>, tolerance: f64) {
    while !curve.closed {
        match next(&curve.knots, pieces, tolerance) {
            None => return,
            Some(Next::Beginning) => {
                let knots = &mut curve.knots;
                knots.pop();
                knots.extend(knots.first().copied());
                curve.closed = true;
            }
            Some(Next::Piece(i, back)) => {
                let mut next = pieces.remove(i).knots;
                if back {
                    turn(&mut next);
                }
                curve.knots.extend(next.into_iter().skip(1));
            }
        }
    }
}

/// What begins in the place of the end, or else near it; of several the one that goes on most straight.
fn next(knots: &[Knot], pieces: &[Piece], tolerance: f64) -> Option<Next> {
    let [first, .., end] = knots else { return None };
    let mut best: Option<((bool, f64), Next)> = None;
    let mut offer = |at: Vec3, along: Vec3, next: Next| {
        let off = (at - end.point).norm();
        let straight = along.dot(&end.along);
        if off > tolerance || straight <= 0.0 {
            return;
        }
        let rank = (off <= TOGETHER * tolerance, straight);
        if best.as_ref().is_none_or(|b| rank > b.0) {
            best = Some((rank, next));
        }
    };
    if knots.len() > 3 {
        offer(first.point, first.along, Next::Beginning);
    }
    for (i, piece) in pieces.iter().enumerate().filter(|(_, p)| !p.closed) {
        let [a, .., b] = piece.knots.as_slice() else { continue };
        offer(a.point, a.along, Next::Piece(i, false));
        offer(b.point, -b.along, Next::Piece(i, true));
    }
    best.map(|b| b.1)
}

fn turn(knots: &mut [Knot]) {
    knots.reverse();
    for k in knots {
        k.along = -k.along;
    }
}

/// An end of an open curve that lies on no border of a surface that ends there.
pub(super) fn loose_end(curve: &Piece, surfaces: [&[&Sculptured]; 2]) -> Option<Vec3> {
    let ends = [curve.knots.first(), curve.knots.last()].into_iter().filter(|_| !curve.closed);
    let at_border = |k: &Knot| (0..2).any(|i| is_border(&k.sides[i], surfaces[i]));
    ends.flatten().find(|k| !at_border(k)).map(|k| k.point)
}

fn is_border(touch: &Touch, surfaces: &[&Sculptured]) -> bool {
    let [surface, index] = touch.of;
    let Some(s) = surfaces.get(surface) else { return false };
    let ends = |at: [f64; 2], spans: [f64; 2], ends: &dyn Fn(usize, bool) -> bool| {
        (0..2).any(|k| {
            at[k] <= AT_BORDER && ends(k, false) || at[k] >= spans[k] - AT_BORDER && ends(k, true)
        })
    };
    match s.layout {
        // A border in the place of the opposite one is none.
        Layout::Mesh { .. } => {
            let uv = s.global(index, touch.uv[0], touch.uv[1]);
            ends(uv, s.spans(), &|k, last| s.is_point(k, last) || !s.closes(k))
        }
        // Which patches lie beside each other is not known.
        Layout::Patches => ends(touch.uv, [1.0; 2], &|_, _| true),
    }
}
