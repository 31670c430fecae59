//! Places from which curves are followed: pairs of cells in which two sheets cross.

use super::MeetFault;
use super::level;
use super::sheet::{Shape, Sheet};
use super::trace::{State, Tracer, Uvs};
use crate::sculpt::Patch;
use crate::{Vec3, trig};

/// Pairs of cells that are looked at in one statement.
const MOST: usize = 2_000_000;
/// Halvings of a patch before a pair of cells counts as simple, and before it is given up as one in which the
/// two do not cross.
const SIMPLE_FROM: u32 = 2;
const SIMPLE_TO: u32 = 5;
/// Halvings at most.
const DEEPEST: u32 = 8;
/// By how much the spread of the normals in a cell is taken greater than that of its samples.
const SPREAD: f64 = 1.5;
/// Share of a cell by which a place may lie outside of it.
const ASIDE: f64 = 0.05;

/// How much may still be done.
pub(super) struct Budget(usize);

impl Budget {
    pub(super) fn new() -> Self {
        Self(MOST)
    }

    pub(super) fn spend(&mut self) -> Result<(), MeetFault> {
        self.0 = self.0.checked_sub(1).ok_or(MeetFault::Alike(MOST))?;
        Ok(())
    }
}

/// A part of a sheet.
#[derive(Clone)]
struct Cell {
    range: [[f64; 2]; 2],
    depth: u32,
    /// Its own net; none of a plane.
    net: Option<Box<Patch>>,
    lo: Vec3,
    hi: Vec3,
}

/// Places of all curves in which the two sheets meet, some of them more than once.
pub(super) fn seeds(t: &Tracer<'_>, budget: &mut Budget) -> Result<Vec<State>, MeetFault> {
    if let (Shape::Plane { origin, normal, .. }, Shape::Patch(patch)) =
        (t.sheets[0].shape, t.sheets[1].shape)
        && t.sheets[1].thick.abs() <= 0.0
    {
        let plane = (normal, normal.dot(&origin) + t.sheets[0].thick);
        let starts = level::starts(patch, plane, t.tolerance, budget)?;
        return Ok(starts.into_iter().filter_map(|start| t.place(start)).collect());
    }
    let mut found = Vec::new();
    let mut stack = vec![t.sheets.map(whole)];
    while let Some([a, b]) = stack.pop() {
        budget.spend()?;
        if apart(t.sheets, [&a, &b]) {
            continue;
        }
        let depth = b.depth.max(if a.net.is_some() { a.depth } else { 0 });
        let even = b.depth.min(if a.net.is_some() { a.depth } else { b.depth });
        let size = |c: &Cell| if c.net.is_some() { (c.hi - c.lo).norm() } else { 0.0 };
        let small = depth >= DEEPEST || size(&a).max(size(&b)) <= 4.0 * t.tolerance;
        let simple = even >= SIMPLE_FROM && cross_at_an_angle(t.sheets, [&a, &b]);
        if simple || small {
            let before = found.len();
            for start in starts([&a, &b]) {
                found.extend(t.place(start).filter(|s| within(s.uvs(), [&a, &b])));
            }
            if found.len() > before || small || depth >= SIMPLE_TO {
                continue;
            }
        }
        split(t.sheets, a, b, &mut stack);
    }
    Ok(found)
}

fn whole(sheet: &Sheet<'_>) -> Cell {
    let range = [[0.0, 1.0]; 2];
    match sheet.shape {
        Shape::Plane { .. } => {
            Cell { range, depth: 0, net: None, lo: Vec3::zeros(), hi: Vec3::zeros() }
        }
        Shape::Patch(p) => {
            let [lo, hi] = p.bounds();
            Cell { range, depth: 0, net: Some(Box::new(p.clone())), lo, hi }
        }
    }
}

/// Is there surely no place in common?
fn apart(sheets: [&Sheet<'_>; 2], [a, b]: [&Cell; 2]) -> bool {
    let room = sheets[0].thick.abs() + sheets[1].thick.abs();
    if let (Shape::Plane { origin, normal, .. }, Some(net)) = (sheets[0].shape, &b.net) {
        let level = normal.dot(&origin) + sheets[0].thick;
        let room = sheets[1].thick.abs();
        let off = |h: &crate::sculpt::Vec4| normal.dot(&h.xyz()) / h.w - level;
        let all = || net.net.iter().flatten().map(off);
        return all().all(|x| x > room) || all().all(|x| x < -room);
    }
    (0..3).any(|k| a.lo[k] > b.hi[k] + room || b.lo[k] > a.hi[k] + room)
}

/// Do the tangent planes of the two cross at an angle everywhere in the cells?
fn cross_at_an_angle(sheets: [&Sheet<'_>; 2], cells: [&Cell; 2]) -> bool {
    let mut normals = [Vec3::zeros(); 2];
    let mut spread = [0.0_f64; 2];
    for i in 0..2 {
        let at = |s: f64, t: f64| {
            let [u, v] = cells[i].range;
            sheets[i].spot([u[0] + (u[1] - u[0]) * s, v[0] + (v[1] - v[0]) * t])
        };
        let Some(middle) = at(0.5, 0.5) else { return false };
        normals[i] = middle.normal;
        if cells[i].net.is_none() {
            continue;
        }
        for (s, t) in [
            (0.0, 0.0),
            (1.0, 0.0),
            (0.0, 1.0),
            (1.0, 1.0),
            (0.5, 0.0),
            (0.5, 1.0),
            (0.0, 0.5),
            (1.0, 0.5),
        ] {
            let Some(spot) = at(s, t) else { return false };
            let sine = spot.normal.cross(&middle.normal).norm();
            spread[i] = spread[i].max(trig::atan2(sine, spot.normal.dot(&middle.normal)));
        }
    }
    let between =
        trig::atan2(normals[0].cross(&normals[1]).norm(), normals[0].dot(&normals[1]).abs());
    SPREAD * (spread[0] + spread[1]) < between
}

/// Middle and corners of both cells.
fn starts(cells: [&Cell; 2]) -> Vec<Uvs> {
    const PLACES: [[f64; 2]; 5] = [[0.5, 0.5], [0.1, 0.1], [0.9, 0.1], [0.1, 0.9], [0.9, 0.9]];
    let at = |c: &Cell, [s, t]: [f64; 2]| {
        let [u, v] = c.range;
        [u[0] + (u[1] - u[0]) * s, v[0] + (v[1] - v[0]) * t]
    };
    let plane = cells[0].net.is_none();
    let firsts = if plane { 1 } else { PLACES.len() };
    let mut all = Vec::with_capacity(firsts + PLACES.len());
    for b in PLACES {
        // A place on the plane follows from that on the patch.
        let a = if plane { [0.0, 0.0] } else { at(cells[0], [0.5, 0.5]) };
        all.push([a, at(cells[1], b)]);
    }
    if !plane {
        for a in &PLACES[1..] {
            all.push([at(cells[0], *a), at(cells[1], [0.5, 0.5])]);
        }
    }
    all
}

fn within(uvs: &Uvs, cells: [&Cell; 2]) -> bool {
    let inside = |x: f64, [a, b]: [f64; 2]| {
        let aside = ASIDE * (b - a);
        x >= a - aside && x <= b + aside
    };
    (0..2).all(|i| cells[i].net.is_none() || (0..2).all(|k| inside(uvs[i][k], cells[i].range[k])))
}

/// The larger of the two in four, each with the other.
fn split(sheets: [&Sheet<'_>; 2], a: Cell, b: Cell, stack: &mut Vec<[Cell; 2]>) {
    let first = a.net.is_some() && a.depth < b.depth;
    let (sheet, cell) = if first { (sheets[0], &a) } else { (sheets[1], &b) };
    let (Shape::Patch(patch), [u, v]) = (sheet.shape, cell.range) else { return };
    let middle = |r: [f64; 2]| 0.5 * (r[0] + r[1]);
    for u in [[u[0], middle(u)], [middle(u), u[1]]] {
        for v in [[v[0], middle(v)], [middle(v), v[1]]] {
            let net = patch.part(u, v);
            let [lo, hi] = net.bounds();
            let part =
                Cell { range: [u, v], depth: cell.depth + 1, net: Some(Box::new(net)), lo, hi };
            stack.push(if first { [part, b.clone()] } else { [a.clone(), part] });
        }
    }
}
