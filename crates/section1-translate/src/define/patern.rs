//! PATERN: points in order.

use aptc_geometry::{Form, Pattern, Vec3};
use aptc_vocabulary::{Word, word};

use super::fault::Fault;
use super::format::Item::{C, N, Of, P, PT, Rest, V, W};
use super::format::{Args, Format, row};
use super::line::at_degrees;

const TURNS: &[Word] = &[word::CLW, word::CCLW];
const GRIDS: &[Word] = &[word::PARLEL, word::GRID, word::PERIM];
const STEPS: super::format::Item = Rest("increments or number,AT,increment");

pub(super) const FORMATS: &[Format] = &[
    row(&[W(word::LINEAR), P, P, N], linear_between),
    row(&[W(word::LINEAR), P, V, N], linear_along),
    row(&[W(word::LINEAR), P, V, W(word::INCR), STEPS], linear_steps),
    row(&[W(word::ARC), C, N, N, Of(TURNS), N], arc_between),
    row(&[W(word::ARC), C, N, Of(TURNS), W(word::INCR), STEPS], arc_steps),
    row(&[Of(GRIDS), PT, PT], grid_of_two),
    row(&[Of(GRIDS), PT, V, N], grid_along),
    row(&[Of(GRIDS), PT, V, W(word::INCR), STEPS], grid_steps),
    row(&[W(word::RANDOM), Rest("points and patterns")], random),
    row(&[PT], same),
];

/// Distances of neighbours, how often; a list is kept packed until its length is known to be allowed.
struct Steps {
    groups: Vec<Vec<f64>>,
}

/// The increments after the INCR that stands before `from`: numbers, or `n,AT,i`, in groups that each
/// begin with an INCR.
fn steps(a: &Args<'_>, from: usize) -> Result<Steps, Fault> {
    let (mut groups, mut group, mut at, mut n) = (Vec::new(), Vec::new(), from, 1);
    while at < a.len() {
        if a.is(at, word::INCR) {
            if group.is_empty() {
                return Err(Fault::Unexpected { at, expected: "an increment" });
            }
            groups.push(std::mem::take(&mut group));
            at += 1;
            continue;
        }
        if !a.is_number(at) {
            return Err(Fault::Unexpected { at, expected: "an increment, AT or INCR" });
        }
        if a.is(at + 1, word::AT) {
            if !a.is_number(at + 2) {
                return Err(Fault::Unexpected { at: at + 2, expected: "a number" });
            }
            let (count, step) = counted(a, at)?;
            n += count;
            limit(a, at, n)?;
            group.extend(std::iter::repeat_n(step, count));
            at += 3;
        } else {
            n += 1;
            limit(a, at, n)?;
            group.push(a.number(at)?);
            at += 1;
        }
    }
    if group.is_empty() {
        return Err(Fault::Unexpected { at, expected: "an increment" });
    }
    groups.push(group);
    Ok(Steps { groups })
}

/// Which of `x,AT,y` is the count: the first, as in APT-360 and APT4, for columns too, which the manual of APT-360
/// writes the other way round in its text. A number that is not whole cannot be the count in either.
fn counted(a: &Args<'_>, at: usize) -> Result<(usize, f64), Fault> {
    let whole = |x: f64| x >= 1.0 && (x - x.round()).abs() < 1e-9;
    let first = whole(a.number(at)?) || !whole(a.number(at + 2)?);
    let (count, step) = if first { (at, at + 2) } else { (at + 2, at) };
    Ok((a.count(count, 1)?, a.number(step)?))
}

fn limit(a: &Args<'_>, at: usize, n: usize) -> Result<(), Fault> {
    let limit = a.context.max_points;
    if n > limit { Err(Fault::TooMany { at, limit }) } else { Ok(()) }
}

/// Whole number as a factor.
fn factor(i: usize) -> f64 {
    u32::try_from(i).map_or(f64::INFINITY, f64::from)
}

fn pattern(points: Vec<Vec3>) -> Form {
    Form::Pattern(Pattern { points })
}

fn linear_between(a: &Args<'_>) -> Result<Form, Fault> {
    let (p, q, n) = (a.point(1)?, a.point(2)?, a.count(3, 2)?);
    let last = factor(n - 1);
    Ok(pattern((0..n).map(|i| p + (q - p) * (factor(i) / last)).collect()))
}

fn linear_along(a: &Args<'_>) -> Result<Form, Fault> {
    let (p, v, n) = (a.point(1)?, a.vector(2)?, a.count(3, 1)?);
    if n > 1 {
        a.direction(2)?;
    }
    Ok(pattern((0..n).map(|i| p + v * factor(i)).collect()))
}

/// Running sums of the increments, beginning with 0.
fn sums(steps: &Steps) -> Vec<f64> {
    let mut sum = 0.0;
    let mut all = vec![0.0];
    for step in steps.groups.iter().flatten() {
        sum += step;
        all.push(sum);
    }
    all
}

fn linear_steps(a: &Args<'_>) -> Result<Form, Fault> {
    let (p, u) = (a.point(1)?, a.direction(2)?);
    let steps = steps(a, 4)?;
    Ok(pattern(sums(&steps).iter().map(|s| p + u * *s).collect()))
}

/// The point of the circle at `at` that stands at `degrees`, at its own height or on ZSURF.
fn on_circle(a: &Args<'_>, degrees: f64) -> Result<Vec3, Fault> {
    let c = a.circle(1)?;
    let p = c.center.xy() + at_degrees(degrees) * c.radius;
    let z = if a.context.zsurf.is_some() { a.context.lift(p).z } else { c.center.z };
    Ok(Vec3::new(p.x, p.y, z))
}

/// -1 for CLW at `at`.
fn sense(a: &Args<'_>, at: usize) -> f64 {
    if a.is(at, word::CLW) { -1.0 } else { 1.0 }
}

/// From the start to the end angle; equal angles mean the full circle.
fn arc_between(a: &Args<'_>) -> Result<Form, Fault> {
    let ([start, end], n, sense) = (a.numbers(2)?, a.count(5, 2)?, sense(a, 4));
    let sweep = (sense * (end - start)).rem_euclid(360.0);
    let sweep = if sweep > 0.0 { sweep } else { 360.0 };
    let angle = |i: usize| start + sense * sweep * (factor(i) / factor(n - 1));
    let points: Result<_, _> = (0..n).map(|i| on_circle(a, angle(i))).collect();
    points.map(pattern)
}

/// Each INCR begins anew with the point that was reached, as APT-360 has it: with a second INCR that
/// point stands twice.
fn arc_steps(a: &Args<'_>) -> Result<Form, Fault> {
    let (mut angle, sense) = (a.number(2)?, sense(a, 3));
    let mut points = Vec::new();
    for group in &steps(a, 5)?.groups {
        points.push(on_circle(a, angle)?);
        for step in group {
            angle += sense * step;
            points.push(on_circle(a, angle)?);
        }
    }
    limit(a, 5, points.len())?;
    Ok(pattern(points))
}

/// The column carried by each of `ways`: there and back as a grid, or around the border alone for PERIM.
fn grid(a: &Args<'_>, column: &[Vec3], ways: &[Vec3]) -> Result<Form, Fault> {
    let n = column.len().saturating_mul(ways.len());
    limit(a, 1, n)?;
    let mut points = Vec::with_capacity(n);
    if a.is(0, word::PERIM) && ways.len() > 1 && column.len() > 1 {
        let (first, last) = (column[0], column[column.len() - 1]);
        let (inner, end) = (&ways[1..ways.len() - 1], ways[ways.len() - 1]);
        points.extend(column.iter().map(|p| p + ways[0]));
        points.extend(inner.iter().map(|w| last + w));
        points.extend(column.iter().rev().map(|p| p + end));
        points.extend(inner.iter().rev().map(|w| first + w));
        return Ok(pattern(points));
    }
    for (i, way) in ways.iter().enumerate() {
        if i % 2 == 0 {
            points.extend(column.iter().map(|p| p + way));
        } else {
            points.extend(column.iter().rev().map(|p| p + way));
        }
    }
    Ok(pattern(points))
}

/// Both patterns share a point that is first or last in each; the columns go away from it.
fn grid_of_two(a: &Args<'_>) -> Result<Form, Fault> {
    let (column, row) = (&a.pattern(1)?.points, &a.pattern(2)?.points);
    let (Some(c0), Some(c1)) = (column.first(), column.last()) else {
        return Err(Fault::TooFew { at: 1, need: 1, found: 0, what: "points" });
    };
    let (Some(r0), Some(r1)) = (row.first(), row.last()) else {
        return Err(Fault::TooFew { at: 2, need: 1, found: 0, what: "points" });
    };
    let size = column.iter().chain(row).fold(0.0_f64, |m, p| m.max(p.amax()));
    let near = |p: &Vec3| (p - c0).norm().min((p - c1).norm());
    let backwards = near(r1) < near(r0);
    let common = if backwards { r1 } else { r0 };
    if near(common) > 1e-6 * size {
        let what = "has no end in common with";
        return Err(Fault::Misplaced { at: 2, by: 1, what, amount: near(common) });
    }
    let mut ways: Vec<Vec3> = row.iter().map(|p| p - common).collect();
    if backwards {
        ways.reverse();
    }
    grid(a, column, &ways)
}

fn grid_along(a: &Args<'_>) -> Result<Form, Fault> {
    let (v, n) = (a.vector(2)?, a.count(3, 1)?);
    let ways: Vec<Vec3> = (0..n).map(|i| v * factor(i)).collect();
    grid(a, &a.pattern(1)?.points, &ways)
}

/// With a second INCR the column that was reached stands twice, as with arcs.
fn grid_steps(a: &Args<'_>) -> Result<Form, Fault> {
    let u = a.direction(2)?;
    let (mut sum, mut ways) = (0.0, Vec::new());
    for group in &steps(a, 4)?.groups {
        ways.push(u * sum);
        for step in group {
            sum += step;
            ways.push(u * sum);
        }
    }
    grid(a, &a.pattern(1)?.points, &ways)
}

fn random(a: &Args<'_>) -> Result<Form, Fault> {
    let mut points = Vec::new();
    for at in 1..a.len() {
        if let Ok(more) = a.pattern(at) {
            points.extend_from_slice(&more.points);
        } else if a.is_point(at) {
            points.push(a.point(at)?);
        } else {
            return Err(Fault::Unexpected { at, expected: "a point or a pattern" });
        }
        limit(a, at, points.len())?;
    }
    if points.is_empty() {
        return Err(Fault::TooFew { at: 1, need: 1, found: 0, what: "points" });
    }
    Ok(pattern(points))
}

fn same(a: &Args<'_>) -> Result<Form, Fault> {
    a.pattern(0).map(|p| Form::Pattern(p.clone()))
}
