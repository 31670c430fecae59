//! Quadrics as curves in planes square to an axis.

use std::collections::BTreeMap;

use aptc_geometry::{Quadric, Vec3};

use super::view::Bounds;

/// Cells of a plane to a side.
const CELLS: usize = 90;

/// An edge of the grid: its lower corner, and whether it goes along the first coordinate.
type Edge = (usize, usize, bool);

/// Corners of a box about the surface where it has a centre and ends in x and y; otherwise about its centre
/// or, without one, the origin.
pub(crate) fn extent(q: &Quadric) -> Vec<Vec3> {
    let [a, b, c, _, f, g, h, p, m, r] = q.c;
    let flat = [c, f, g, r].iter().all(|x| x.abs() < 1e-12);
    let center = if flat {
        let det = a * b - h * h;
        (det.abs() > 1e-12 * (a * a + b * b))
            .then(|| Vec3::new((h * m - b * p) / det, (h * p - a * m) / det, 0.0))
    } else {
        [a, b, c].iter().all(|x| x.abs() > 1e-9).then(|| Vec3::new(-p / a, -m / b, -r / c))
    };
    let Some(center) = center else {
        let half = Vec3::new(20.0, 20.0, if flat { 0.0 } else { 20.0 });
        return vec![-half, half];
    };
    let k = -q.value(center);
    let det = if flat { a * b - h * h } else { a * b };
    let reach = |other: f64| (k * other / det).abs().sqrt();
    // Open surfaces are shown as far again.
    let open = if det * k * a <= 0.0 || (det < 0.0) { 1.8 } else { 1.0 };
    let z = if flat || c == 0.0 { 0.0 } else { (k / c).abs().sqrt() };
    let half = Vec3::new(reach(b), reach(a), z) * open;
    vec![center - half, center + half]
}

/// The cut of the surface with the plane where the coordinate `axis` is `at`, inside the box.
pub(crate) fn slice(q: &Quadric, room: &Bounds, axis: usize, at: f64) -> Vec<Vec<Vec3>> {
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let place = |u: f64, v: f64| {
        let mut p = Vec3::zeros();
        p[axis] = at;
        p[i] = room.low[i] + room.size()[i] * u;
        p[j] = room.low[j] + room.size()[j] * v;
        p
    };
    #[expect(clippy::cast_precision_loss, reason = "a few cells")]
    let corner = |m: usize, n: usize| place(m as f64 / CELLS as f64, n as f64 / CELLS as f64);
    let value = |m: usize, n: usize| q.value(corner(m, n));
    let crossing = |(m, n, first): Edge| {
        let (mut p, mut r) =
            (corner(m, n), if first { corner(m + 1, n) } else { corner(m, n + 1) });
        let low = q.value(p) < 0.0;
        for _ in 0..40 {
            let middle = (p + r) / 2.0;
            if (q.value(middle) < 0.0) == low { p = middle } else { r = middle }
        }
        p
    };
    // Each cell joins two of its edges, or two pairs.
    let mut joined: BTreeMap<Edge, Vec<Edge>> = BTreeMap::new();
    for (m, n) in (0..CELLS).flat_map(|m| (0..CELLS).map(move |n| (m, n))) {
        let inside =
            [(m, n), (m + 1, n), (m + 1, n + 1), (m, n + 1)].map(|(a, b)| value(a, b) < 0.0);
        let edges = [(m, n, true), (m + 1, n, false), (m, n + 1, true), (m, n, false)];
        let cut: Vec<Edge> =
            (0..4).filter(|k| inside[*k] != inside[(k + 1) % 4]).map(|k| edges[k]).collect();
        for pair in cut.chunks_exact(2) {
            joined.entry(pair[0]).or_default().push(pair[1]);
            joined.entry(pair[1]).or_default().push(pair[0]);
        }
    }
    let mut curves = Vec::new();
    while let Some(start) = first_end(&joined) {
        let mut chain = vec![start];
        let mut here = start;
        while let Some(next) = joined.get_mut(&here).and_then(Vec::pop) {
            // The way back is used up with the way there.
            let back = joined.get_mut(&next);
            if let Some(back) = back
                && let Some(k) = back.iter().position(|e| *e == here)
            {
                back.remove(k);
            }
            chain.push(next);
            here = next;
        }
        joined.retain(|_, to| !to.is_empty());
        curves.push(chain.into_iter().map(crossing).collect());
    }
    curves
}

/// Where a curve begins: at a border if there is one.
fn first_end(joined: &BTreeMap<Edge, Vec<Edge>>) -> Option<Edge> {
    joined.iter().find(|(_, to)| to.len() == 1).or_else(|| joined.iter().next()).map(|(e, _)| *e)
}
