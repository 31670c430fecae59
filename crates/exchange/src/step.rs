//! STEP (ISO 10303-21): B-spline surfaces, also rational ones as complex instances, and those with implied
//! knots; planes, cylinders, cones, spheres, tori and surfaces of revolution and extrusion where faces bound them. The text is
//! read by `ruststep`.
//!
//! A face is the patch of its surface over the box of parameters that its edges leave.

pub(crate) mod curves;
pub(crate) mod edges;
mod faces;
pub(crate) mod forms;
mod places;
mod units;

use std::collections::{BTreeMap, BTreeSet};

use aptc_geometry::sculptured::BsplineSurface;
use ruststep::ast::{EntityInstance, Name, Parameter, Record};

use crate::follow::WORK;
use crate::{Collected, Fault, Limits, Outside, broken, named};
use edges::Curves;
use faces::{Face, border, faces};
use forms::{Form, NAMES};
use places::Drawn;

/// Brackets within each other: the reader of the text calls itself for each.
const DEPTH: usize = 64;

/// Surfaces that are not read.
const OTHER: [&str; 3] = ["OFFSET_SURFACE", "RECTANGULAR_TRIMMED_SURFACE", "CURVE_BOUNDED_SURFACE"];

/// Records of an entity by its number.
type Entities<'x> = BTreeMap<u64, &'x [Record]>;

pub(crate) fn read(text: &str, limits: &Limits) -> Result<Outside, Fault> {
    let text = prepared(text)?;
    let file = ruststep::parser::parse(&text).map_err(|e| {
        let first = e.to_string();
        broken(format!("this is no STEP file: {}", first.lines().next().unwrap_or_default()))
    })?;
    let mut out = Collected::new(limits);
    let mut entities = Entities::new();
    let mut twice = BTreeSet::new();
    for e in file.data.iter().flat_map(|d| &d.entities) {
        let (id, records) = match e {
            EntityInstance::Simple { id, record } => (*id, std::slice::from_ref(record)),
            EntityInstance::Complex { id, subsuper } => (*id, subsuper.0.as_slice()),
        };
        if entities.insert(id, records).is_some() {
            twice.insert(id);
        }
    }
    if !twice.is_empty() {
        let twice: Vec<u64> = twice.into_iter().collect();
        out.file.notes.push(format!(
            "numbers of several entities stand for the last of them: {}",
            named("#", &twice)
        ));
    }
    out.file.unit_mm = units::length(&entities, &mut out.file.notes)?;
    let angle = units::angle(&entities, &mut out.file.notes)?;
    let mut faces_of = BTreeMap::<u64, Vec<Face>>::new();
    let mut surface_of = BTreeMap::new();
    for face in faces(&entities) {
        surface_of.insert(face.id, face.surface);
        faces_of.entry(face.surface).or_default().push(face);
    }
    let mut other = BTreeMap::<&str, Left>::new();
    // The face or surface that each of the surfaces is.
    let mut read = Vec::new();
    // Faces that are not the box of their parameters, those of which the box is not known, and those that make no surface.
    let (mut cut, mut unbounded, mut none) = (Vec::new(), Vec::new(), Vec::new());
    let mut curves = Curves::new(&entities, limits);
    for (id, records) in &entities {
        let whole = surface(&entities, *id, records, limits)?;
        let bounded = faces_of.get(id).map_or(&[][..], Vec::as_slice);
        let form = (!bounded.is_empty())
            .then(|| Form::of(&entities, *id, angle, whole.as_ref(), limits))
            .flatten();
        let mut left = bounded.is_empty() || form.is_none();
        let mut faces = Vec::new();
        if form.is_none() {
            faces.extend(bounded.iter().map(|f| f.id));
        }
        for (face, form) in bounded.iter().filter_map(|face| Some((face, form.as_ref()?))) {
            let Some(border) = border(&mut curves, face, form).map(|b| form.within(b)) else {
                left = true;
                faces.push(face.id);
                continue;
            };
            match out.bspline(
                &format!("#{id} of face #{}", face.id),
                form.patch(border.range),
                None,
            ) {
                Ok(()) => {
                    read.push(face.id);
                    if !border.whole {
                        cut.push(face.id);
                    }
                }
                Err(why @ Fault::TooLarge(_)) => return Err(why),
                Err(_) => none.push(face.id),
            }
        }
        match whole {
            Some(surface) if left => {
                unbounded.append(&mut faces);
                out.bspline(&format!("#{id}"), surface, None)?;
                read.push(*id);
            }
            _ => {}
        }
        let known = |name: &str| NAMES.iter().chain(&OTHER).find(|n| **n == name);
        for name in records.iter().filter_map(|r| known(&r.name)).filter(|_| left) {
            let left = other.entry(name).or_default();
            left.surfaces += 1;
            left.faces.append(&mut faces);
        }
    }
    let left: Vec<String> = other.iter().map(|(name, left)| left.told(name)).collect();
    if out.file.surfaces.is_empty() {
        return Err(Fault::NoSurface(left.join(", ")));
    }
    if !left.is_empty() {
        out.file.notes.push(format!("not read: {}", left.join(", ")));
    }
    if curves.work.spent() {
        out.file.notes.push(format!(
            "the borders of its faces take more than {WORK} looks at curves; those of further faces are not read"
        ));
    }
    if !none.is_empty() {
        out.file
            .notes
            .push(format!("faces that have no extent are not read: {}", named("#", &none)));
    }
    if !cut.is_empty() {
        out.file.notes.push(format!(
            "faces whose border is not a box of their surface's parameters are taken as all of that box: {}",
            named("#", &cut)
        ));
    }
    if !unbounded.is_empty() {
        out.file.notes.push(format!(
            "faces of which the border is not read are taken as the whole of their surface: {}",
            named("#", &unbounded)
        ));
    }
    let drawn = Drawn { faces: surface_of, read: &read };
    if let Some(assembly) = places::assembly(&entities, &drawn, &mut out.file.notes)? {
        out.place(&read, &assembly)?;
        if out.file.surfaces.is_empty() {
            return Err(Fault::NoSurface(out.file.notes.join("; ")));
        }
    }
    Ok(out.done())
}

/// Surfaces of a kind that are not read, or not for these faces.
#[derive(Default)]
struct Left {
    surfaces: usize,
    faces: Vec<u64>,
}

impl Left {
    fn told(&self, name: &str) -> String {
        match self.faces.len() {
            0 => format!("{} {name}", self.surfaces),
            1 => format!("{} {name} (face {})", self.surfaces, named("#", &self.faces)),
            _ => format!("{} {name} (faces {})", self.surfaces, named("#", &self.faces)),
        }
    }
}

/// The text with `$` for empty lists, which the reader does not know. Brackets deeper than its stack should bear
/// are refused.
fn prepared(text: &str) -> Result<String, Fault> {
    let (mut depth, mut quoted, mut last) = (0_usize, false, ' ');
    let mut out = String::with_capacity(text.len());
    let mut skip_to = 0;
    for (at, c) in text.char_indices() {
        if at < skip_to {
            continue;
        }
        match c {
            '\'' => quoted = !quoted,
            '(' if !quoted && matches!(last, ',' | '(') => {
                let inner = &text[at + 1..];
                let blank = inner.len() - inner.trim_start().len();
                if inner[blank..].starts_with(')') {
                    out.push('$');
                    last = '$';
                    skip_to = at + 1 + blank + 1;
                    continue;
                }
                depth += 1;
            }
            '(' if !quoted => depth += 1,
            ')' if !quoted => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth > DEPTH {
            return Err(Fault::TooLarge(format!("more than {DEPTH} brackets within each other")));
        }
        if !c.is_whitespace() {
            last = c;
        }
        out.push(c);
    }
    Ok(out)
}

fn list(p: &Parameter) -> Option<&[Parameter]> {
    match p {
        Parameter::List(all) => Some(all),
        _ => None,
    }
}

fn real(p: &Parameter) -> Option<f64> {
    match p {
        Parameter::Real(x) => Some(*x),
        #[expect(clippy::cast_precision_loss, reason = "coordinates are of no such size")]
        Parameter::Integer(n) => Some(*n as f64),
        Parameter::Typed { parameter, .. } => match &**parameter {
            Parameter::List(all) if all.len() == 1 => real_of_single(&all[0]),
            one => real_of_single(one),
        },
        _ => None,
    }
}

/// A measure such as `LENGTH_MEASURE(25.4)` holds a number and no further measure.
fn real_of_single(p: &Parameter) -> Option<f64> {
    if matches!(p, Parameter::Typed { .. }) { None } else { real(p) }
}

fn count(p: &Parameter) -> Option<usize> {
    match p {
        Parameter::Integer(n) => usize::try_from(*n).ok(),
        _ => None,
    }
}

fn reference(p: &Parameter) -> Option<u64> {
    match p {
        Parameter::Ref(Name::Entity(id)) => Some(*id),
        _ => None,
    }
}

/// The parameters of a record of the given name.
fn of<'x>(records: &'x [Record], name: &str) -> Option<&'x [Parameter]> {
    records.iter().find(|r| r.name == name).and_then(|r| list(&r.parameter))
}

/// The surface of an entity; `None` when it is no B-spline surface.
fn surface(
    entities: &Entities<'_>,
    id: u64,
    records: &[Record],
    limits: &Limits,
) -> Result<Option<BsplineSurface>, Fault> {
    const IMPLIED: [&str; 3] = ["BEZIER_SURFACE", "UNIFORM_SURFACE", "QUASI_UNIFORM_SURFACE"];
    let wrong = |what: &str| broken(format!("#{id}: {what}"));
    // A simple instance holds all; in a complex one each of its types holds its own.
    let [base, own, implied] = match records {
        [one] => {
            let Some(all) = list(&one.parameter) else { return Ok(None) };
            let rest = all.get(1..).unwrap_or_default();
            match one.name.as_str() {
                "B_SPLINE_SURFACE_WITH_KNOTS" => [Some(rest), rest.get(7..), None],
                name if IMPLIED.contains(&name) => [Some(rest), None, Some(rest)],
                _ => return Ok(None),
            }
        }
        many => {
            let implied = IMPLIED.iter().find_map(|n| of(many, n));
            [of(many, "B_SPLINE_SURFACE"), of(many, "B_SPLINE_SURFACE_WITH_KNOTS"), implied]
        }
    };
    let Some([p, q, net, ..]) = base else { return Ok(None) };
    let (Some(p), Some(q), Some(rows)) = (count(p), count(q), list(net)) else {
        return Err(wrong("degrees or control points are missing"));
    };
    let weights = of(records, "RATIONAL_B_SPLINE_SURFACE").and_then(|w| w.first()).and_then(list);
    let nu = rows.len();
    let nv = rows.first().and_then(list).map_or(0, <[_]>::len);
    let n = nu.saturating_mul(nv);
    if n == 0 || n > limits.points {
        return Err(wrong("it has no control points, or too many"));
    }
    // There a row runs along v.
    let mut points = vec![[0.0; 4]; n];
    for (i, row) in rows.iter().enumerate() {
        let row = list(row).filter(|r| r.len() == nv);
        let row = row.ok_or_else(|| wrong("the rows of control points differ in length"))?;
        let own = weights.map(|w| w.get(i).and_then(list).filter(|w| w.len() == nv));
        for (j, q) in row.iter().enumerate() {
            let w = match &own {
                None => Some(1.0),
                Some(w) => w.and_then(|w| real(&w[j])),
            };
            let point = reference(q).and_then(|q| place(entities, q));
            let (Some([x, y, z]), Some(w)) = (point, w) else {
                return Err(wrong("a control point or weight is missing"));
            };
            points[j * nu + i] = [x, y, z, w];
        }
    }
    let (degree, counts) = ([p, q], [nu, nv]);
    let knots = match (own, implied) {
        (Some([mu, mv, tu, tv, ..]), _) => [repeated(mu, tu, n), repeated(mv, tv, n)]
            .map(|k| k.ok_or_else(|| wrong("its knots and their multiplicities do not agree"))),
        (_, Some(_)) => {
            let even = records.iter().any(|r| r.name == "UNIFORM_SURFACE");
            let bezier = records.iter().any(|r| r.name == "BEZIER_SURFACE");
            [0, 1].map(|k| {
                steps(degree[k], counts[k], even, bezier)
                    .ok_or_else(|| wrong("its control points do not fit its degree"))
            })
        }
        _ => return Err(wrong("its knots are missing")),
    };
    let [u, v] = knots;
    Ok(Some(BsplineSurface { degree, knots: [u?, v?], counts, points, range: [None; 2] }))
}

fn place(entities: &Entities<'_>, id: u64) -> Option<[f64; 3]> {
    let all = of(entities.get(&id)?, "CARTESIAN_POINT")?;
    let [x, y, z] = list(all.get(1)?)? else { return None };
    Some([real(x)?, real(y)?, real(z)?])
}

/// Knots, each as often as its multiplicity says.
fn repeated(times: &Parameter, knots: &Parameter, most: usize) -> Option<Vec<f64>> {
    let (times, knots) = (list(times)?, list(knots)?);
    if times.len() != knots.len() {
        return None;
    }
    let mut all = Vec::new();
    for (m, t) in times.iter().zip(knots) {
        let (m, t) = (count(m)?, real(t)?);
        if m > 2 * most + 64 || all.len() > 2 * most + 64 {
            return None;
        }
        all.extend(std::iter::repeat_n(t, m));
    }
    Some(all)
}

/// Knots that the type of the surface implies.
#[expect(clippy::cast_precision_loss, reason = "counts within the limits")]
fn steps(degree: usize, n: usize, even: bool, bezier: bool) -> Option<Vec<f64>> {
    if degree == 0 || n <= degree {
        return None;
    }
    let all = n + degree + 1;
    if even {
        return Some((0..all).map(|k| k as f64 - degree as f64).collect());
    }
    if bezier && !(n - 1).is_multiple_of(degree) {
        return None;
    }
    let each = if bezier { degree } else { 1 };
    let spans = (n - degree).div_ceil(each).max(1);
    Some(
        (0..all)
            .map(|k| {
                let inner = k.saturating_sub(degree + 1) / each + 1;
                if k <= degree {
                    0.0
                } else if k >= n {
                    spans as f64
                } else {
                    inner as f64
                }
            })
            .collect(),
    )
}
