//! Trimmed surfaces of IGES (143 with 141, 144 with 142): the boxes of parameters that their borders leave.

use aptc_geometry::{Transform, Vec3};

use super::curves::paths;
use super::faces::Base;
use super::{Entry, File, Numbers};
use crate::border::{Border, Line};
use crate::follow::{Ground, Work, bounded, follow};
use crate::step::edges::Edge;
use crate::{Fault, Limits};

/// Curves of a border at most.
const CURVES: usize = 10_000;
/// How far what should be the same may be apart, as a share of a parameter's range.
const ABOUT: f64 = 1e-6;
/// A curve of a border begins within this share of its longest curve's size of the end of the one before.
const GAP: f64 = 1e-2;

/// A trimmed surface: the directory line of the whole, and its borders.
pub(super) struct Trimmed {
    pub(super) surface: usize,
    /// Directory lines of 142 or 141; none where the border is that of the surface.
    borders: Vec<usize>,
    /// The border of the surface is there besides.
    outer: bool,
}

pub(super) fn trimmed(file: &File<'_>, e: &Entry, limits: &Limits) -> Result<Trimmed, Fault> {
    let mut p = Numbers::of(file, e)?;
    if e.kind == 143 {
        let _kind = p.take(1)?;
        let surface = p.pointer()?;
        let n = p.count(limits)?.min(CURVES);
        let borders = (0..n).map(|_| p.pointer()).collect::<Result<_, _>>()?;
        return Ok(Trimmed { surface, borders, outer: n == 0 });
    }
    let surface = p.pointer()?;
    let own = p.take(1)?[0] > 0.5;
    let holes = p.count(limits)?.min(CURVES);
    let first = p.take(1)?[0];
    let mut borders = Vec::new();
    if own && first > 0.5 {
        p.at -= 1;
        borders.push(p.pointer()?);
    }
    for _ in 0..holes {
        borders.push(p.pointer()?);
    }
    Ok(Trimmed { surface, borders, outer: !own })
}

/// The edges of a border.
struct Bound {
    /// Its curves in space, carried to where the surface is without its matrix, each going on where the one before ends.
    space: Option<Vec<Edge>>,
    /// Its curves of the surface's parameters as the file has them.
    flat: Option<Vec<Edge>>,
    /// The file prefers those of the parameters.
    prefers: bool,
}

/// The parameters of the file; they say themselves how often they come round.
struct Flat<'b>(&'b Base);

impl Ground for Flat<'_> {
    fn periods(&self) -> [Option<f64>; 2] {
        [None; 2]
    }

    fn parameters(&self, p: Vec3) -> [Option<f64>; 2] {
        self.0.own([p.x, p.y]).map_or([None; 2], |own| own.map(Some))
    }

    fn off(&self, _: [f64; 2], _: Vec3) -> f64 {
        0.0
    }

    fn cost(&self) -> u64 {
        1
    }
}

impl Bound {
    fn flat(&self, work: &mut Work, base: &Base) -> Option<Line> {
        follow(work, self.flat.as_ref()?, &Flat(base), true)
    }

    /// The border by what the file prefers, or by the other curves where those are not read. `left`: is the face on the left of
    /// its curves in space, seen against the normal of the form?
    fn line(&self, work: &mut Work, base: &Base, left: bool) -> Option<Line> {
        match &self.space {
            Some(edges) if !self.prefers || self.flat.is_none() => {
                follow(work, edges, &base.form, left)
            }
            _ => self.flat(work, base),
        }
    }
}

/// The box of a trimmed surface in the parameters of its form; `None` where its borders do not tell.
pub(super) fn border(
    file: &File<'_>,
    trimmed: &Trimmed,
    base: &Base,
    work: &mut Work,
    limits: &Limits,
) -> Result<Option<Border>, Fault> {
    if trimmed.outer {
        let whole = trimmed.borders.is_empty();
        return Ok(base.whole.map(|range| Border { range, whole }));
    }
    let back = match &base.map {
        Some(m) => m.inverse(),
        None => Some(Transform::identity()),
    };
    let Some(back) = back else { return Ok(None) };
    let mut bounds = Vec::with_capacity(trimmed.borders.len());
    for at in &trimmed.borders {
        let Some(bound) = bound(file, *at, &back, work, limits)? else { return Ok(None) };
        bounds.push(bound);
    }
    if bounds.is_empty() {
        return Ok(None);
    }
    Ok(inside(&bounds, base, work).map(|b| base.form.within(b)))
}

/// The box inside borders.
///
/// The part of a trimmed surface is what its outer border encloses in the parameters, whichever way its curves run. Where a curve
/// in space does not show that, for it comes round or passes a pole, its sense is that of the same border in the parameters. Of a
/// file without these the part on the left is taken, seen against the file's normal, or that on the right if only this lies
/// within the surface; where both do, the box is told not to be the border's.
fn inside(bounds: &[Bound], base: &Base, work: &mut Work) -> Option<Border> {
    // Exchanged parameters have the normal on the other side.
    let left = !base.exchange;
    let lines = |left: &dyn Fn(usize) -> bool, work: &mut Work| {
        let all = bounds.iter().enumerate();
        all.map(|(i, b)| b.line(work, base, left(i))).collect::<Option<Vec<_>>>()
    };
    let mut first = lines(&|_| left, work)?;
    if base.form.plane().outward(&mut first) {
        return bounded(&mut first, &base.form);
    }
    if let Some(senses) = senses(bounds, base, work) {
        return bounded(&mut lines(&|i| senses[i], work)?, &base.form);
    }
    let mut found = Vec::new();
    for sense in [left, !left] {
        let mut lines = lines(&|_| sense, work)?;
        let once = lines.iter().all(|l| l.rounds.iter().all(|r| r.abs() < 1.5));
        if let Some(border) = bounded(&mut lines, &base.form) {
            found.push((border, once && base.holds(&border)));
        }
    }
    if found.iter().any(|(_, fits)| *fits) {
        found.retain(|(_, fits)| *fits);
    }
    let (mut border, _) = *found.first()?;
    border.whole &= found.iter().all(|(b, _)| base.apart(border.range, b.range) <= ABOUT);
    Some(border)
}

impl Base {
    /// Does a box lie in the surface, but for periods?
    fn holds(&self, border: &Border) -> bool {
        let Some(whole) = self.whole else { return true };
        let periods = self.form.plane().periods;
        (0..2).all(|k| {
            let ([a, b], [low, high]) = (border.range[k], whole[k]);
            let room = ABOUT * (high - low);
            // All round there is no end that it could cross.
            if periods[k].is_some_and(|p| high - low >= p - room) {
                return b - a <= high - low + room;
            }
            let by = periods[k].map_or(0.0, |p| ((low - room - a) / p).ceil() * p);
            a + by >= low - room && b + by <= high + room
        })
    }

    /// By how much of their size two boxes differ at most, but for periods.
    fn apart(&self, one: [[f64; 2]; 2], other: [[f64; 2]; 2]) -> f64 {
        let periods = self.form.plane().periods;
        let of = |k: usize| {
            let ([a, b], [c, d]) = (one[k], other[k]);
            let by = periods[k].map_or(0.0, |p| ((a - c) / p).round() * p);
            (c + by - a).abs().max((d + by - b).abs()) / (b - a)
        };
        of(0).max(of(1))
    }
}

/// Is the face on the left of each border, by the curves of the parameters? The largest is the outer one.
fn senses(bounds: &[Bound], base: &Base, work: &mut Work) -> Option<Vec<bool>> {
    let lines = bounds.iter().map(|b| b.flat(work, base)).collect::<Option<Vec<_>>>()?;
    let areas: Vec<f64> = lines.iter().map(Line::area).collect();
    let sound = lines.iter().zip(&areas).all(|(line, area)| {
        let [[a, b], [c, d]] = [line.range(0), line.range(1)];
        area.abs() > ABOUT * (b - a) * (d - c)
    });
    let most = |i: &usize, k: &usize| areas[*i].abs().total_cmp(&areas[*k].abs());
    let outer = (0..areas.len()).max_by(most).filter(|_| sound)?;
    Some(areas.iter().enumerate().map(|(i, area)| (*area > 0.0) == (i == outer)).collect())
}

/// The curves of a border; `None` where it is of another type.
fn bound(
    file: &File<'_>,
    at: usize,
    back: &Transform,
    work: &mut Work,
    limits: &Limits,
) -> Result<Option<Bound>, Fault> {
    let Some(e) = file.entries.get(&at).filter(|e| [141, 142].contains(&e.kind)) else {
        return Ok(None);
    };
    let mut p = Numbers::of(file, e)?;
    // Curves in space with their senses, and curves of parameters.
    let (mut space, mut flat) = (Vec::new(), Vec::new());
    let prefers;
    if e.kind == 142 {
        let _made = p.take(1)?;
        let _surface = p.take(1)?;
        let pointers = [p.take(1)?[0], p.take(1)?[0]];
        p.at -= 2;
        for (pointer, all) in pointers.iter().zip([&mut flat, &mut space]) {
            if *pointer > 0.5 {
                all.push((p.pointer()?, true));
            } else {
                p.at += 1;
            }
        }
        prefers = p.take(1).is_ok_and(|x| (x[0] - 1.0).abs() < 0.5);
    } else {
        let _kind = p.take(1)?;
        prefers = (p.take(1)?[0] - 2.0).abs() < 0.5;
        let _surface = p.take(1)?;
        for _ in 0..p.count(limits)?.min(CURVES) {
            let curve = p.pointer()?;
            let along = p.take(1)?[0] < 1.5;
            space.push((curve, along));
            for _ in 0..p.count(limits)?.min(CURVES) {
                flat.push((p.pointer()?, true));
            }
        }
    }
    let mut edges = |all: &[(usize, bool)], back: Option<&Transform>| {
        let mut out = Vec::new();
        for (at, along) in all {
            if work.spent() {
                return Ok(None);
            }
            let Some(paths) = paths(file, *at, limits)? else { return Ok(None) };
            let from = out.len();
            for mut path in paths {
                if let Some(back) = back {
                    path.curve.carry(back);
                }
                if work.take(path.curve.spans() as u64).is_none() {
                    return Ok(None);
                }
                out.push(Edge::whole(path.curve, *along));
            }
            if !along {
                out[from..].reverse();
            }
        }
        Ok::<_, Fault>((!out.is_empty()).then_some(out))
    };
    // A matrix of the border carries its curves in space.
    let back = file.map(e.matrix)?.map_or(*back, |m| m.then(back));
    let space = edges(&space, Some(&back))?.filter(|all| linked(all));
    let flat = edges(&flat, None)?;
    Ok(Some(Bound { space, flat, prefers }))
}

/// Does each edge begin where the one before ends?
fn linked(edges: &[Edge]) -> bool {
    let ends: Vec<[Vec3; 2]> = edges.iter().map(Edge::ends).collect();
    let size = edges.iter().map(Edge::extent).fold(0.0, f64::max);
    let n = ends.len();
    (0..n).all(|i| (ends[(i + 1) % n][0] - ends[i][1]).norm() <= GAP * size)
}
