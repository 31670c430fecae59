//! POINT and VECTOR of sculptured curves and surfaces: by parameter, on a plane, near a point, on a line.
//!
//! APT: `APT109`. Source: APT4 SSV3.

use std::sync::Arc;

use aptc_geometry::sculpt::{
    ArcPoint, CurveAt, Derivatives, Sculptured, SpaceCurve, along_line, nearest_on,
};
use aptc_geometry::{Form, Plane, Vec3, polynomial};
use aptc_vocabulary::{Word, word};

use super::fault::Fault;
use super::format::Item::{self, N, Of, P, PL, SC, SS, Tail, V, W};
use super::format::{Args, Format, row};
use super::{Beyond, Found};
use crate::eval::found_on;

const MEASURE: Item = Of(&[word::PARAM, word::FLOW]);
const OF_CURVE: Item = Of(&[word::TANSPL, word::CRSSPL, word::NORMAL, word::BINORM]);
const OF_SURFACE: Item = Of(&[word::TANSPL, word::CRSSPL, word::NORMAL]);
const UNIT: Item = Tail("UNIT or the end");

/// Formats of POINT.
pub(super) const POINTS: &[Format] = &[
    row(&[W(word::INTOF), SC, MEASURE, N], point),
    row(&[W(word::INTOF), SC, MEASURE, N, N], point),
    row(&[W(word::INTOF), SS, N, N], point),
    row(&[W(word::INTOF), SS, N, N, N], point),
    row(&[W(word::INTOF), SS, MEASURE, N, N], point),
    row(&[W(word::INTOF), SS, MEASURE, N, N, N], point),
    row(&[W(word::INTOF), PL, SC, P], point),
    row(&[W(word::INTOF), SS, P], point),
    row(&[W(word::INTOF), SS, P, P], point),
    row(&[W(word::INTOF), SS, P, V], point),
    row(&[W(word::INTOF), SS, P, V, P], point),
    row(&[W(word::INTOF), SS, MEASURE, P], point),
    row(&[W(word::INTOF), SS, MEASURE, P, P], point),
    row(&[W(word::INTOF), SS, MEASURE, P, V], point),
    row(&[W(word::INTOF), SS, MEASURE, P, V, P], point),
];

/// Formats of VECTOR.
pub(super) const VECTORS: &[Format] = &[
    row(&[W(word::INTOF), SC, MEASURE, N, OF_CURVE, UNIT], vector),
    row(&[W(word::INTOF), SC, MEASURE, N, N, OF_CURVE, UNIT], vector),
    row(&[W(word::INTOF), SS, N, N, OF_SURFACE, UNIT], vector),
    row(&[W(word::INTOF), SS, N, N, N, OF_SURFACE, UNIT], vector),
    row(&[W(word::INTOF), SS, MEASURE, N, N, OF_SURFACE, UNIT], vector),
    row(&[W(word::INTOF), SS, MEASURE, N, N, N, OF_SURFACE, UNIT], vector),
    row(&[W(word::INTOF), PL, SC, P, OF_CURVE, UNIT], vector),
    row(&[W(word::INTOF), SS, P, OF_SURFACE, UNIT], vector),
    row(&[W(word::INTOF), SS, P, P, OF_SURFACE, UNIT], vector),
    row(&[W(word::INTOF), SS, P, V, OF_SURFACE, UNIT], vector),
    row(&[W(word::INTOF), SS, P, V, P, OF_SURFACE, UNIT], vector),
    row(&[W(word::INTOF), SS, MEASURE, P, OF_SURFACE, UNIT], vector),
    row(&[W(word::INTOF), SS, MEASURE, P, P, OF_SURFACE, UNIT], vector),
    row(&[W(word::INTOF), SS, MEASURE, P, V, OF_SURFACE, UNIT], vector),
    row(&[W(word::INTOF), SS, MEASURE, P, V, P, OF_SURFACE, UNIT], vector),
];

/// A place on a curve or surface.
enum Place {
    Curve { at: ArcPoint, cross: Option<Vec3> },
    Surface(Derivatives),
}

fn point(a: &Args<'_>) -> Result<Form, Fault> {
    Ok(Form::Point(match place(a)?.0 {
        Place::Curve { at, .. } => at.point,
        Place::Surface(d) => d.point,
    }))
}

fn vector(a: &Args<'_>) -> Result<Form, Fault> {
    let (place, which) = place(a)?;
    let unit = a.is(which + 1, word::UNIT);
    if a.len() > which + 1 + usize::from(unit) {
        let at = which + 1 + usize::from(unit);
        return Err(Fault::Unexpected { at, expected: "UNIT or the end" });
    }
    let none = Fault::NoVector { at: which };
    let v = match (place, a.word(which)?) {
        (Place::Curve { at, .. }, word::TANSPL) => at.first,
        (Place::Curve { at, .. }, word::BINORM) => at.first.cross(&at.second),
        (Place::Curve { cross, .. }, word::CRSSPL) => cross.ok_or(none.clone())?,
        (Place::Curve { at, cross }, _) => at.first.cross(&cross.ok_or(none.clone())?),
        (Place::Surface(d), word::TANSPL) => d.u,
        (Place::Surface(d), word::CRSSPL) => d.v,
        (Place::Surface(d), _) => d.u.cross(&d.v),
    };
    if v == Vec3::zeros() {
        return Err(none);
    }
    Ok(Form::Vector(if unit { v.try_normalize(0.0).ok_or(none)? } else { v }))
}

/// Notes a parameter that is not between 0 and the last one: the form goes straight on there.
fn note_beyond(a: &Args<'_>, at: usize, value: f64, last: f64) {
    /// Rounding of a parameter that was computed.
    const ROOM: f64 = 1e-9;
    if !(-ROOM..=last + ROOM).contains(&value) {
        a.context.beyond.set(Some(Beyond { at, value, last }));
    }
}

/// The place that the arguments behind INTOF name, and where the arguments behind it begin.
fn place(a: &Args<'_>) -> Result<(Place, usize), Fault> {
    match (a.form(1)?, a.form(2)) {
        (Form::Scurv(_), _) => on_curve(a),
        (_, Ok(Form::Scurv(_))) => on_plane(a),
        _ => on_surface(a),
    }
}

fn curve(a: &Args<'_>, at: usize) -> Result<Arc<SpaceCurve>, Fault> {
    let Form::Scurv(c) = a.form(at)? else { return Err(Fault::Kind { at }) };
    a.context.fits.curve(c).map_err(|why| Fault::NotFitted { at, why: why.to_string() })
}

/// `SCURV,PARAM|FLOW,t[,n]`: along the whole curve, or along its n-th arc or segment.
fn on_curve(a: &Args<'_>) -> Result<(Place, usize), Fault> {
    let c = curve(a, 1)?;
    let t = a.number(3)?;
    let n = if a.is_number(4) { part(a, 4)? } else { None };
    let how = if a.is(2, word::FLOW) { CurveAt::Flow(n) } else { CurveAt::Param(n) };
    let Some(at) = c.place(t, how) else {
        let (whole, n) = match how {
            CurveAt::Flow(_) => ("the curve has segments", c.segments()),
            CurveAt::Param(_) => ("the curve has arcs", c.arcs.len()),
        };
        return Err(Fault::NoSuchPart { at: 4, value: a.number(4)?, n, whole });
    };
    let last = match how {
        CurveAt::Flow(Some(_)) | CurveAt::Param(Some(_)) => 1.0,
        CurveAt::Flow(None) => c.flow_span(),
        CurveAt::Param(None) => c.span(),
    };
    note_beyond(a, 3, t, last);
    let whole = match (how, n) {
        (CurveAt::Flow(_), _) => None,
        (_, Some(n)) => Some(t + count(n) - 1.0),
        (_, None) => Some(t),
    };
    let cross = whole.and_then(|t| across(&c, t));
    Ok((Place::Curve { at, cross }, if a.is_number(4) { 5 } else { 4 }))
}

/// The direction across a curve between those given at its ends.
fn across(c: &SpaceCurve, t: f64) -> Option<Vec3> {
    let [Some(first), Some(last)] = c.cross else { return None };
    Some(first.lerp(&last, t / c.span()))
}

/// The number of an arc, segment or patch at `at`; 0 for the whole.
fn part(a: &Args<'_>, at: usize) -> Result<Option<usize>, Fault> {
    if a.number(at)? == 0.0 { Ok(None) } else { a.count(at, 1).map(Some) }
}

/// `plane,SCURV,P`: where the plane cuts the curve, or its straight prolongation, nearest to P.
fn on_plane(a: &Args<'_>) -> Result<(Place, usize), Fault> {
    let (plane, near) = (a.plane(1)?, a.point(3)?);
    let c = curve(a, 2)?;
    let places = cuts(&c, &plane);
    let distance = |p: &ArcPoint| (p.point - near).norm();
    let best = places.into_iter().min_by(|(_, p), (_, q)| distance(p).total_cmp(&distance(q)));
    let Some((t, at)) = best else { return Err(Fault::Apart { a: 1, b: 2, gap: f64::INFINITY }) };
    let cross = across(&c, t.clamp(0.0, c.span()));
    a.context.found.replace(Some(Found::Curve { t, curve: c }));
    Ok((Place::Curve { at, cross }, 4))
}

/// Where a plane cuts a curve, with the parameters.
fn cuts(c: &SpaceCurve, plane: &Plane) -> Vec<(f64, ArcPoint)> {
    let mut found = Vec::new();
    for (i, arc) in c.arcs.iter().enumerate() {
        // The weighted distance is a cubic of the parameter: Bernstein to powers.
        let g = arc.b.map(|h| plane.n.dot(&h.xyz()) - plane.d * h.w);
        let size = g.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let powers = [
            g[0],
            3.0 * (g[1] - g[0]),
            3.0 * (g[2] - 2.0 * g[1] + g[0]),
            g[3] - 3.0 * g[2] + 3.0 * g[1] - g[0],
        ];
        for t in polynomial::roots(&powers, 0.0, 1.0, 1e-12 * size) {
            found.push((count(i) + t, arc.at(t)));
        }
    }
    // Straight on at both ends.
    for (t, outward) in [(0.0, -1.0), (c.span(), 1.0)] {
        let end = c.at(t);
        let slope = plane.n.dot(&end.first);
        let by = -plane.distance(end.point) / slope;
        if slope.abs() > 1e-9 * end.first.norm() && by * outward > 1e-9 {
            let point = end.point + end.first * by;
            found.push((t + by, ArcPoint { point, second: Vec3::zeros(), ..end }));
        }
    }
    found
}

fn surface(a: &Args<'_>) -> Result<Arc<Sculptured>, Fault> {
    let Form::Ssurf(s) = a.form(1)? else { return Err(Fault::Kind { at: 1 }) };
    a.context.fits.surface(s).map_err(|why| Fault::NotFitted { at: 1, why: why.to_string() })
}

/// `SSURF,[PARAM,]u,v[,n]` and `SSURF,P[,P|V[,P]]`.
fn on_surface(a: &Args<'_>) -> Result<(Place, usize), Fault> {
    let s = surface(a)?;
    let at = if a.list.get(2).is_some_and(|x| MEASURE.takes(x)) { 3 } else { 2 };
    if a.is_number(at) {
        let [u, v] = a.numbers(at)?;
        let n = if a.is_number(at + 2) { part(a, at + 2)? } else { None };
        let lasts = if n.is_some() { [1.0; 2] } else { s.spans() };
        note_beyond(a, at, u, lasts[0]);
        note_beyond(a, at + 1, v, lasts[1]);
        if !a.is_number(at + 2) {
            return Ok((Place::Surface(s.at(u, v)), at + 2));
        }
        let d = match n {
            None => s.at(u, v),
            Some(n) => s.at_span(n, u, v).ok_or(Fault::NoSuchPart {
                at: at + 2,
                value: a.number(at + 2)?,
                n: s.patches.len(),
                whole: "the surface has patches",
            })?,
        };
        return Ok((Place::Surface(d), at + 3));
    }
    let p = a.point(at)?;
    let Some((direction, near, next)) = line(a, at, p)? else {
        let hit = nearest_on(&s, p);
        a.context.found.replace(Some(found_on(&s, hit.uv)));
        return Ok((Place::Surface(hit.at), at + 1));
    };
    let hits = along_line(&s, p, direction);
    let best =
        hits.iter().min_by(|g, h| (g.distance - near).abs().total_cmp(&(h.distance - near).abs()));
    match best {
        Some(hit) => {
            a.context.found.replace(Some(found_on(&s, hit.uv)));
            Ok((Place::Surface(hit.at), next))
        }
        None => Err(Fault::LineMisses { p: at, to: at + 1, on: 1 }),
    }
}

/// The line behind the point at `at`: direction, the place along it that the hit must be nearest to, and
/// the argument behind it.
fn line(a: &Args<'_>, at: usize, p: Vec3) -> Result<Option<(Vec3, f64, usize)>, Fault> {
    match a.form(at + 1) {
        Ok(Form::Vector(v)) => {
            let way = v.try_normalize(0.0).ok_or(Fault::NoLength { at: at + 1 })?;
            Ok(Some(match a.point(at + 2) {
                Ok(near) => (way, (near - p).dot(&way), at + 3),
                Err(_) => (way, 0.0, at + 2),
            }))
        }
        _ => match a.point(at + 1) {
            Ok(q) => {
                let way = (q - p).try_normalize(0.0);
                let way = way.ok_or(Fault::Coincide { a: at, b: at + 1 })?;
                Ok(Some((way, 0.0, at + 2)))
            }
            Err(_) => Ok(None),
        },
    }
}

/// Do the arguments ask for a place of a sculptured form?
pub(super) fn asked(head: Word, args: &[super::Arg]) -> bool {
    let sculptured = |i: usize| args.get(i).is_some_and(|x| SC.takes(x) || SS.takes(x));
    matches!(head, word::POINT | word::VECTOR)
        && args.first().and_then(super::Arg::word) == Some(word::INTOF)
        && (sculptured(1) || sculptured(2))
}

#[expect(clippy::cast_precision_loss, reason = "a count of arcs")]
fn count(n: usize) -> f64 {
    n as f64
}
