//! Surfaces of IGES that are made of curves (118 ruled, 120 of revolution, 122 tabulated cylinders), and trimmed ones (143 with
//! 141, 144 with 142) as the boxes of parameters that their borders leave.

use aptc_geometry::sculptured::{
    BsplineSurface, CurveDefinition, CurveShape, FlowLaw, FlowSpan, SegmentSpan, SurfaceShape,
};
use aptc_geometry::{Plane, Transform, Vec3};

use super::curves::{Path, paths};
use super::{Entry, File, Numbers, bspline, cells, joined};
use crate::border::Border;
use crate::curve::{Axis, exchanged};
use crate::step::curves::Frame;
use crate::step::faces::{Line, bounded, followed};
use crate::step::forms::Form;
use crate::{Fault, Limits};

/// Curves of a border at most.
const CURVES: usize = 10_000;

/// A surface with exact patches over boxes of its parameters.
pub(super) struct Base {
    form: Form,
    /// The file's first parameter is the form's second one.
    exchange: bool,
    /// Of a surface of revolution what is turned, for its parameter.
    turned: Option<Path>,
    /// All of it; none of a plane without a border.
    whole: Option<[[f64; 2]; 2]>,
    pub(super) map: Option<Transform>,
}

/// What an entity is.
pub(super) enum Held {
    Exact(Box<Base>),
    /// Ruled by equal length, or patches without common parameters: the shape, and the number of its points.
    Followed(SurfaceShape, usize, Option<Transform>),
}

impl Base {
    /// The exact patch over a box of the form's parameters.
    pub(super) fn patch(&self, range: [[f64; 2]; 2]) -> BsplineSurface {
        let patch = self.form.patch(range);
        if self.exchange { exchanged(patch) } else { patch }
    }

    /// All of the surface.
    pub(super) fn whole(&self) -> Option<BsplineSurface> {
        self.whole.map(|range| self.patch(range))
    }

    /// The form's parameters for the file's; `None` where a type's are not known.
    fn own(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        match (&self.form, &self.turned) {
            (Form::Spline { .. }, _) => Some([x, y]),
            (Form::Turned { .. }, Some(path)) => Some([y, path.own(x)]),
            _ => None,
        }
    }
}

/// The surface of an entry; `None` for a type that is not read, or one of curves that are not. `trimmed`: is it asked for
/// by its parameters?
pub(super) fn held(
    file: &File<'_>,
    e: &Entry,
    trimmed: bool,
    limits: &Limits,
) -> Result<Option<Held>, Fault> {
    let mut p = Numbers::of(file, e)?;
    let map = file.map(e.matrix)?;
    let single = |at: usize| -> Result<Option<Path>, Fault> {
        let all = paths(file, at, limits)?;
        Ok(all.and_then(|mut all| if all.len() == 1 { all.pop() } else { None }))
    };
    let exact = |form: Option<Form>, whole, turned: Option<Path>| {
        let exchange = turned.is_some();
        let base = form.map(|form| Base { form, exchange, turned, whole, map });
        Ok(base.map(|b| Held::Exact(Box::new(b))))
    };
    let of_spline = |mut s: BsplineSurface| {
        // The form has all of the knots' range; the part that belongs to the surface is taken of it.
        let range = std::mem::take(&mut s.range);
        let form = Form::spline(s);
        let whole = form.as_ref().map(|f| {
            [0, 1].map(|k| {
                let ends = f.ends(k).map(|x| x.unwrap_or(0.0));
                let r = range[k].unwrap_or(ends);
                [r[0].max(ends[0]), r[1].min(ends[1])]
            })
        });
        (form, whole)
    };
    match e.kind {
        108 => exact(plane(&mut p)?, None, None),
        114 => {
            let cells = cells(p, limits)?;
            match joined(&cells).filter(|_| trimmed) {
                Some(s) => {
                    let (form, whole) = of_spline(s);
                    exact(form, whole, None)
                }
                None => {
                    let n = cells.net.len() / 4;
                    Ok(Some(Held::Followed(cells.shape(), n, map)))
                }
            }
        }
        118 => {
            let (first, second) = (p.pointer()?, p.pointer()?);
            let turned = p.take(1)?[0] > 0.5;
            let (Some(a), Some(mut b)) = (single(first)?, single(second)?) else { return Ok(None) };
            if turned {
                b.curve.reverse();
            }
            if alike(&a, &b, e.form == 1) {
                let (form, whole) = of_spline(a.curve.ruled(&b.curve));
                return exact(form, whole, None);
            }
            Ok(if e.form == 1 { None } else { by_length(&a, &b, map) })
        }
        120 => {
            let (axis, generatrix) = (p.pointer()?, p.pointer()?);
            let angles: [f64; 2] = [p.take(1)?[0], p.take(1)?[0]];
            let (Some(axis), Some(path)) = (single(axis)?, single(generatrix)?) else {
                return Ok(None);
            };
            let [from, to] = axis.ends();
            let z = (to - from).try_normalize(0.0).filter(|_| axis.straight);
            let (Some(z), true) = (z, angles[1] > angles[0]) else { return Ok(None) };
            let curve = path.curve.clone();
            let whole = Some([angles, curve.range]);
            let form = Form::Turned { axis: Axis { point: from, z }, curve };
            exact(Some(form), whole, Some(path))
        }
        122 => {
            let directrix = p.pointer()?;
            let end = Vec3::from_row_slice(p.take(3)?);
            let Some(path) = single(directrix)? else { return Ok(None) };
            let by = end - path.ends()[0];
            let whole = Some([path.curve.range, [0.0, 1.0]]);
            let sound = by.norm() > 0.0;
            exact(sound.then_some(Form::Moved { curve: path.curve, by }), whole, None)
        }
        128 => {
            let (form, whole) = of_spline(bspline(p, limits)?);
            exact(form, whole, None)
        }
        _ => Ok(None),
    }
}

/// Does a share of the parameter stand for the share of the file's law on both curves?
fn alike(a: &Path, b: &Path, by_parameter: bool) -> bool {
    let sweep = |p: &Path| p.curve.range[1] - p.curve.range[0];
    if a.arc || b.arc {
        // Of two arcs of the same angle halves, and all that lies at the same share of it, meet.
        let same = (sweep(a) - sweep(b)).abs() <= 1e-9;
        return a.arc && b.arc && same && (by_parameter || a.round && b.round);
    }
    by_parameter || a.straight && b.straight
}

/// Straight lines between places at the same share of the length of both.
fn by_length(a: &Path, b: &Path, map: Option<Transform>) -> Option<Held> {
    let mut n = 0;
    let mut curve = |path: &Path| {
        let arcs = path.curve.chain().cubics()?;
        n += 4 * arcs.len();
        #[expect(clippy::cast_precision_loss, reason = "counts within the limits")]
        let count = arcs.len() as f64;
        let mut words = vec![count];
        words.extend(arcs.iter().flatten().flatten());
        let law = FlowLaw::Arc;
        let range = [0.0, count];
        let flow = FlowSpan { law, range, tolerance: None, points: Vec::new(), vector: None };
        Some(std::sync::Arc::new(CurveDefinition {
            flow: vec![flow],
            segments: vec![SegmentSpan { by_length: true, range }],
            ..CurveDefinition::plain(CurveShape::Canonical(words))
        }))
    };
    let shape = SurfaceShape::RuledBetween([curve(a)?, curve(b)?]);
    Some(Held::Followed(shape, n, map))
}

/// A plane a x + b y + c z = d.
fn plane(p: &mut Numbers) -> Result<Option<Form>, Fault> {
    let c = p.take(4)?;
    let Some(plane) = Plane::new(Vec3::new(c[0], c[1], c[2]), c[3]) else { return Ok(None) };
    let z = plane.n;
    let aside = if z.x.abs() < 0.9 { Vec3::x() } else { Vec3::y() };
    let y = z.cross(&aside).normalize();
    Ok(Some(Form::Plane(Frame { origin: z * plane.d, x: y.cross(&z), y, z })))
}

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

/// The box of a trimmed surface in the parameters of its form; `None` where its borders do not tell.
pub(super) fn border(
    file: &File<'_>,
    trimmed: &Trimmed,
    base: &Base,
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
    let mut lines = Vec::with_capacity(trimmed.borders.len());
    for at in &trimmed.borders {
        let Some(line) = line(file, *at, (base, &back), limits)? else { return Ok(None) };
        lines.push(line);
    }
    if lines.is_empty() {
        return Ok(None);
    }
    Ok(bounded(&lines, &base.form, true).map(|b| base.form.within(b)))
}

/// A border on a surface: by its curves in space where the file has them, else by those in the parameters.
fn line(
    file: &File<'_>,
    at: usize,
    (base, back): (&Base, &Transform),
    limits: &Limits,
) -> Result<Option<Line>, Fault> {
    let Some(e) = file.entries.get(&at).filter(|e| [141, 142].contains(&e.kind)) else {
        return Ok(None);
    };
    let mut p = Numbers::of(file, e)?;
    // Curves in space with their senses, and curves of parameters.
    let (mut space, mut flat) = (Vec::new(), Vec::new());
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
    } else {
        let _kinds = p.take(3)?;
        for _ in 0..p.count(limits)?.min(CURVES) {
            let curve = p.pointer()?;
            let along = p.take(1)?[0] < 1.5;
            space.push((curve, along));
            for _ in 0..p.count(limits)?.min(CURVES) {
                flat.push((p.pointer()?, true));
            }
        }
    }
    let places = |all: &[(usize, bool)]| -> Result<Option<Vec<Vec<Vec3>>>, Fault> {
        let mut out = Vec::new();
        for (at, along) in all {
            let Some(paths) = paths(file, *at, limits)? else { return Ok(None) };
            let mut own: Vec<Vec<Vec3>> = paths.iter().map(|p| p.curve.places()).collect();
            if !along {
                own.reverse();
                own.iter_mut().for_each(|c| c.reverse());
            }
            out.append(&mut own);
        }
        Ok((!out.is_empty()).then_some(out))
    };
    if let Some(mut curves) = places(&space)? {
        curves.iter_mut().flatten().for_each(|q| *q = back.point(*q));
        return Ok(followed(&curves, &base.form));
    }
    let Some(curves) = places(&flat)? else { return Ok(None) };
    let own = curves.iter().flatten().map(|q| base.own([q.x, q.y])).collect::<Option<Vec<_>>>();
    Ok(own.map(Line::of))
}
