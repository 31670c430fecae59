//! Surfaces of IGES that are made of curves (118 ruled, 120 of revolution, 122 tabulated cylinders), and what others are when they
//! are trimmed.

use aptc_geometry::sculptured::{
    BsplineSurface, CurveDefinition, CurveShape, FlowLaw, FlowSpan, SegmentSpan, SurfaceShape,
};
use aptc_geometry::{Plane, Transform, Vec3};

use super::curves::{Path, paths};
use super::{Entry, File, Numbers, bspline, cells, joined};
use crate::curve::{Axis, exchanged};
use crate::step::curves::Frame;
use crate::step::forms::Form;
use crate::{Fault, Limits};

/// A surface with exact patches over boxes of its parameters.
pub(super) struct Base {
    pub(super) form: Form,
    /// The file's first parameter is the form's second one.
    pub(super) exchange: bool,
    /// Of a surface of revolution what is turned, for its parameter.
    turned: Option<Path>,
    /// All of it; none of a plane without a border.
    pub(super) whole: Option<[[f64; 2]; 2]>,
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
    pub(super) fn own(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        match (&self.form, &self.turned) {
            (Form::Spline(_), _) => Some([x, y]),
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
        let whole = form.as_ref().ok().map(|f| {
            [0, 1].map(|k| {
                let ends = f.plane().ends[k].map(|x| x.unwrap_or(0.0));
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
                    exact(form.ok(), whole, None)
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
                b.curve = b.curve.reversed();
            }
            if alike(&a, &b, e.form == 1) {
                let (form, whole) = of_spline(a.curve.ruled(&b.curve));
                return exact(form.ok(), whole, None);
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
            let form = form.map_err(|why| Fault::Broken {
                what: format!("entity {} is no surface: {why}", e.kind),
                line: Some(e.line),
            });
            exact(Some(form?), whole, None)
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
