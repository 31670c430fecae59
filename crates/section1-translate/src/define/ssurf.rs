//! SSURF: sculptured surfaces, read and checked; they are fitted by who needs them.

use std::sync::Arc;

use aptc_geometry::sculptured::{
    MeshKind, MeshSpacing, MeshSpline, Patch, PatchKind, Smoothing, SurfaceDefinition,
    SurfaceShape, Sweep,
};
use aptc_geometry::{Form, Vec3};
use aptc_vocabulary::{Word, word};

use super::cursor::{Cursor, apart, bounded, plain};
use super::fault::Fault;
use super::format::Item::{N, Of, P, Rest, SC, SS, Tail, V, W};
use super::format::{Args, Format, row};

const SPACINGS: &[Word] = &[word::XYZ, word::XYPLAN, word::YZPLAN, word::ZXPLAN, word::RULED];
const MESHES: &[Word] = &[word::SMESH, word::GMESH];
const ITEMS: &[Word] = &[word::POLYGN, word::PNTVEC, word::PNTSON];
const SIDES: &[Word] = &[word::PLUS, word::MINUS];
const TURNS: &[Word] = &[word::CLW, word::CCLW];
const SWEEPS: &[Word] = &[word::TRANSL, word::XYROT, word::YZROT, word::ZXROT, word::SCALE];
const MAP: super::format::Item = Tail("TRFORM,matrix or the end");

pub(super) const FORMATS: &[Format] = &[
    row(&[Of(MESHES), Of(SPACINGS), Rest("SPLINE,points, SPLINE,points ..")], mesh),
    row(&[W(word::PATCH), Of(ITEMS), Of(SIDES), Rest("sixteen points or vectors")], patches),
    row(&[W(word::REVOLV), SC, W(word::AXIS), P, P, Of(TURNS), N, N, MAP], revolved),
    row(&[W(word::REVOLV), SC, W(word::AXIS), P, V, Of(TURNS), N, N, MAP], revolved),
    row(&[W(word::RULED), SC, SC, MAP], ruled_between),
    row(&[W(word::RULED), SC, W(word::AXIS), P, P, MAP], ruled_along),
    row(&[W(word::RULED), SC, W(word::AXIS), V, MAP], ruled_along),
    row(&[W(word::GENCUR), SC, SC, Tail("curves, CROSS or TRFORM")], general),
    row(&[Of(SWEEPS), SC, W(word::CROSS), SC, MAP], swept),
    row(&[W(word::COMBIN), SS, Tail("surfaces or TRFORM")], combined),
];

fn mesh(a: &Args<'_>) -> Result<Form, Fault> {
    let kind = if a.is(0, word::SMESH) { MeshKind::Smesh } else { MeshKind::Gmesh };
    let spacing = match a.word(1)? {
        word::XYPLAN => MeshSpacing::Xyplan,
        word::YZPLAN => MeshSpacing::Yzplan,
        word::ZXPLAN => MeshSpacing::Zxplan,
        word::RULED => MeshSpacing::Ruled,
        _ => MeshSpacing::Xyz,
    };
    let mut c = Cursor::new(a, 2);
    // WEIGHT and LIMIT before the first SPLINE are for all.
    let mut common = Smoothing::default();
    c.smoothing(&mut common)?;
    let mut splines: Vec<MeshSpline> = Vec::new();
    if c.peek() != Some(word::SPLINE) {
        return c.unexpected("SPLINE");
    }
    while c.take(&[word::SPLINE]).is_some() {
        let mut smoothing = common;
        c.smoothing(&mut smoothing)?;
        let start = c.at;
        let knots = c.knots(true)?;
        if knots.is_empty() {
            return c.unexpected("a point");
        }
        if knots.len() < 2 {
            return Err(Fault::TooFew { at: c.at, need: 2, found: knots.len(), what: "points" });
        }
        let need = splines.first().map_or(knots.len(), |s| s.knots.len());
        if knots.len() != need {
            return Err(Fault::OtherCount { at: start, need, found: knots.len() });
        }
        apart(&knots)?;
        splines.push(MeshSpline { smoothing, knots: plain(knots) });
    }
    let map = c.map()?;
    c.end("a point, SPLINE, TANSPL, CRSSPL, NORMAL, WEIGHT, LIMIT or TRFORM")?;
    if splines.len() < 2 {
        return Err(Fault::TooFew { at: c.at, need: 2, found: splines.len(), what: "splines" });
    }
    made(a, SurfaceDefinition { shape: SurfaceShape::Mesh { kind, spacing, splines }, map })
}

fn patches(a: &Args<'_>) -> Result<Form, Fault> {
    let kind = match a.word(1)? {
        word::POLYGN => PatchKind::Polygn,
        word::PNTSON => PatchKind::Pntson,
        _ => PatchKind::Pntvec,
    };
    let mut c = Cursor::new(a, 2);
    let mut patches = Vec::new();
    while let Some(side) = c.take(SIDES) {
        let mut items = [Vec3::zeros(); 16];
        for (i, item) in items.iter_mut().enumerate() {
            // The corners of PNTVEC are points; elsewhere a point stands for its vector.
            let corner = kind != PatchKind::Pntvec || matches!(i, 0 | 1 | 4 | 5);
            let value = if corner { c.point() } else { c.vector().or_else(|| c.point()) };
            let Some(value) = value else {
                let expected = match corner {
                    true => "a point of the sixteen items of a patch",
                    false => "a vector of the sixteen items of a patch",
                };
                return c.unexpected(expected);
            };
            *item = value;
        }
        if patches.len() >= a.context.max_points {
            return Err(Fault::TooMany { at: c.at, limit: a.context.max_points });
        }
        patches.push(Patch { minus: side == word::MINUS, items });
    }
    let map = c.map()?;
    c.end("PLUS or MINUS of the next patch, or TRFORM")?;
    made(a, SurfaceDefinition { shape: SurfaceShape::Patches { kind, patches }, map })
}

/// The point and the direction of `AXIS,P,P` or `AXIS,P,V` from `at` on.
fn axis(a: &Args<'_>, at: usize) -> Result<(Vec3, Vec3), Fault> {
    let origin = a.point(at)?;
    let (axis, second) = match a.form(at + 1) {
        Ok(Form::Vector(v)) => (*v, false),
        _ => (a.point(at + 1)? - origin, true),
    };
    if axis == Vec3::zeros() {
        return Err(match second {
            true => Fault::Coincide { a: at, b: at + 1 },
            false => Fault::NoLength { at: at + 1 },
        });
    }
    Ok((origin, axis))
}

fn revolved(a: &Args<'_>) -> Result<Form, Fault> {
    let (origin, axis) = axis(a, 3)?;
    let angles_deg = a.numbers(6)?;
    let mut c = Cursor::new(a, 1);
    let Some(curve) = c.curve() else { return c.unexpected("a curve") };
    c.at = 8;
    let map = c.map()?;
    c.end("TRFORM or the end")?;
    let clockwise = a.is(5, word::CLW);
    let shape = SurfaceShape::Revolved { curve, origin, axis, clockwise, angles_deg };
    made(a, SurfaceDefinition { shape, map })
}

fn ruled_between(a: &Args<'_>) -> Result<Form, Fault> {
    let mut c = Cursor::new(a, 1);
    let (Some(one), Some(other)) = (c.curve(), c.curve()) else {
        return c.unexpected("a curve");
    };
    let map = c.map()?;
    c.end("TRFORM or the end")?;
    made(a, SurfaceDefinition { shape: SurfaceShape::RuledBetween([one, other]), map })
}

fn ruled_along(a: &Args<'_>) -> Result<Form, Fault> {
    let mut c = Cursor::new(a, 1);
    let Some(curve) = c.curve() else { return c.unexpected("a curve") };
    let (axis, end) = match a.form(3) {
        Ok(Form::Vector(v)) if *v == Vec3::zeros() => return Err(Fault::NoLength { at: 3 }),
        Ok(Form::Vector(v)) => (*v, 4),
        _ => (axis(a, 3)?.1, 5),
    };
    c.at = end;
    let map = c.map()?;
    c.end("TRFORM or the end")?;
    let reach = a.context.tabcyl_end;
    made(a, SurfaceDefinition { shape: SurfaceShape::RuledAlong { curve, axis, reach }, map })
}

fn general(a: &Args<'_>) -> Result<Form, Fault> {
    let mut c = Cursor::new(a, 1);
    let (mut curves, mut cross) = (Vec::new(), Vec::new());
    while let Some(curve) = c.curve() {
        curves.push(curve);
    }
    if c.take(&[word::CROSS]).is_some() {
        while let Some(curve) = c.curve() {
            cross.push(curve);
        }
        if cross.len() < 2 {
            return Err(Fault::TooFew {
                at: c.at,
                need: 2,
                found: cross.len(),
                what: "curves across",
            });
        }
    }
    let map = c.map()?;
    c.end("a curve, CROSS or TRFORM")?;
    made(a, SurfaceDefinition { shape: SurfaceShape::General { curves, cross }, map })
}

fn swept(a: &Args<'_>) -> Result<Form, Fault> {
    let motion = match a.word(0)? {
        word::TRANSL => Sweep::Transl,
        word::XYROT => Sweep::Xyrot,
        word::YZROT => Sweep::Yzrot,
        word::ZXROT => Sweep::Zxrot,
        _ => Sweep::Scale,
    };
    let mut c = Cursor::new(a, 1);
    let Some(curve) = c.curve() else { return c.unexpected("a curve") };
    c.at = 3;
    let Some(guide) = c.curve() else { return c.unexpected("a curve") };
    let map = c.map()?;
    c.end("TRFORM or the end")?;
    made(a, SurfaceDefinition { shape: SurfaceShape::Swept { motion, curve, guide }, map })
}

fn combined(a: &Args<'_>) -> Result<Form, Fault> {
    let mut c = Cursor::new(a, 1);
    let mut surfaces = Vec::new();
    while let Some(surface) = c.surface() {
        surfaces.push(surface);
    }
    let map = c.map()?;
    c.end("a surface or TRFORM")?;
    made(a, SurfaceDefinition { shape: SurfaceShape::Combined(surfaces), map })
}

fn made(a: &Args<'_>, surface: SurfaceDefinition) -> Result<Form, Fault> {
    bounded(surface.extent(), a.context.max_points)?;
    Ok(Form::Ssurf(Arc::new(surface)))
}
