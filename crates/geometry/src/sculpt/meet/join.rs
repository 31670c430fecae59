//! The pieces of curves put together where they meet.

use super::trace::{Knot, Piece};

/// Curves from pieces whose ends are no farther apart than the tolerance.
pub(super) fn join(mut pieces: Vec<Piece>, tolerance: f64) -> Vec<Piece> {
    let mut curves = Vec::new();
    while !pieces.is_empty() {
        let mut curve = pieces.remove(0);
        if !curve.closed {
            while let Some(next) = take_next(&curve.knots, &mut pieces, tolerance) {
                append(&mut curve.knots, next);
            }
            turn(&mut curve.knots);
            while let Some(next) = take_next(&curve.knots, &mut pieces, tolerance) {
                append(&mut curve.knots, next);
            }
            turn(&mut curve.knots);
            close(&mut curve, tolerance);
        }
        curves.push(curve);
    }
    curves
}

/// The piece that goes on most straight at the end, in the sense of the curve.
fn take_next(knots: &[Knot], pieces: &mut Vec<Piece>, tolerance: f64) -> Option<Vec<Knot>> {
    let [first, .., end] = knots else { return None };
    // A curve that has come back is whole.
    if knots.len() > 2 && (first.point - end.point).norm() <= tolerance {
        return None;
    }
    let mut best: Option<(f64, usize, bool)> = None;
    for (i, piece) in pieces.iter().enumerate().filter(|(_, p)| !p.closed) {
        let [a, .., b] = piece.knots.as_slice() else { continue };
        for (knot, back) in [(a, false), (b, true)] {
            if (knot.point - end.point).norm() > tolerance {
                continue;
            }
            let along = if back { -knot.along } else { knot.along };
            let straight = along.dot(&end.along);
            if best.is_none_or(|x| straight > x.0) {
                best = Some((straight, i, back));
            }
        }
    }
    let (_, i, back) = best?;
    let mut next = pieces.remove(i).knots;
    if back {
        turn(&mut next);
    }
    Some(next)
}

fn append(knots: &mut Vec<Knot>, next: Vec<Knot>) {
    knots.extend(next.into_iter().skip(1));
}

fn turn(knots: &mut [Knot]) {
    knots.reverse();
    for k in knots {
        k.along = -k.along;
    }
}

fn close(curve: &mut Piece, tolerance: f64) {
    let ([first, .., last], true) = (curve.knots.as_slice(), curve.knots.len() > 3) else { return };
    if (first.point - last.point).norm() <= tolerance && first.along.dot(&last.along) > 0.0 {
        let first = *first;
        curve.closed = true;
        curve.knots.pop();
        curve.knots.push(first);
    }
}
