//! JSON: our own form, and that which geomdl (NURBS-Python) writes.
//!
//! Ours: `{"unit": "mm", "surfaces": [{"degree": [p, q], "knots": [[..], [..]], "points": [[[x, y, z], ..], ..],
//! "weights": [[..], ..]}]}`. A row of points runs along u, the rows follow each other along v; `weights` stand
//! likewise and may be left out. `unit` is `mm`, `cm`, `m`, `inch` or `ft`, or left out.

use serde::Deserialize;

use aptc_geometry::sculptured::BsplineSurface;

use crate::{Collected, Fault, Limits, Outside, broken};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    unit: Option<String>,
    surfaces: Vec<Surface>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Surface {
    degree: [usize; 2],
    knots: [Vec<f64>; 2],
    points: Vec<Vec<[f64; 3]>>,
    #[serde(default)]
    weights: Option<Vec<Vec<f64>>>,
}

/// What geomdl writes.
#[derive(Deserialize)]
struct Geomdl {
    shape: Shape,
}

#[derive(Deserialize)]
struct Shape {
    #[serde(rename = "type")]
    kind: String,
    data: Vec<Data>,
}

#[derive(Deserialize)]
struct Data {
    degree_u: usize,
    degree_v: usize,
    knotvector_u: Vec<f64>,
    knotvector_v: Vec<f64>,
    size_u: usize,
    size_v: usize,
    control_points: Points,
    #[serde(default)]
    trims: serde_json::Value,
}

#[derive(Deserialize)]
struct Points {
    points: Vec<Vec<f64>>,
    #[serde(default)]
    weights: Vec<f64>,
}

pub(crate) fn read(text: &str, limits: &Limits) -> Result<Outside, Fault> {
    let text = text.trim_start_matches('\u{feff}');
    let failed = |e: serde_json::Error| Fault::Broken {
        what: e.to_string(),
        line: (e.line() > 0).then(|| e.line()),
    };
    let ours = match serde_json::from_str::<File>(text) {
        Ok(file) => file,
        Err(e) if e.is_data() => match serde_json::from_str::<Geomdl>(text) {
            Ok(file) => return geomdl(file, limits),
            Err(_) => return Err(failed(e)),
        },
        Err(e) => return Err(failed(e)),
    };
    let mut out = Collected::new(limits);
    out.file.unit_mm = match ours.unit.as_deref() {
        None => None,
        Some(name) => Some(unit(name)?),
    };
    for (k, s) in ours.surfaces.into_iter().enumerate() {
        let name = format!("surface {}", k + 1);
        let uneven = || broken(format!("the rows of points or weights of {name} differ in length"));
        let counts = [s.points.first().map_or(0, Vec::len), s.points.len()];
        let weights = s.weights.unwrap_or_default();
        let same = |n: usize| n == counts[0];
        if !s.points.iter().all(|r| same(r.len()))
            || !weights.is_empty()
                && (weights.len() != counts[1] || !weights.iter().all(|r| same(r.len())))
        {
            return Err(uneven());
        }
        let mut weights = weights.into_iter().flatten();
        let weighted = |p: [f64; 3]| [p[0], p[1], p[2], weights.next().unwrap_or(1.0)];
        let points = s.points.into_iter().flatten().map(weighted).collect();
        let surface =
            BsplineSurface { degree: s.degree, knots: s.knots, counts, points, range: [None; 2] };
        out.bspline(&name, surface, None)?;
    }
    Ok(out.done())
}

fn unit(name: &str) -> Result<f64, Fault> {
    Ok(match name.to_ascii_lowercase().as_str() {
        "mm" => 1.0,
        "cm" => 10.0,
        "m" => 1000.0,
        "in" | "inch" | "inches" => 25.4,
        "ft" | "feet" => 304.8,
        _ => return Err(broken(format!("the unit {name} is not mm, cm, m, inch or ft"))),
    })
}

/// There the points run along v first, and those of rational surfaces are not multiplied by their weights.
fn geomdl(file: Geomdl, limits: &Limits) -> Result<Outside, Fault> {
    if file.shape.kind != "surface" {
        return Err(Fault::NoSurface(format!("a {}", file.shape.kind)));
    }
    let mut out = Collected::new(limits);
    for (k, s) in file.shape.data.into_iter().enumerate() {
        let name = format!("surface {}", k + 1);
        if s.trims.get("count").and_then(serde_json::Value::as_u64).unwrap_or(0) > 0 {
            return Err(Fault::Unsupported(format!("{name} is trimmed, and trims are not read")));
        }
        let (nu, nv, all) = (s.size_u, s.size_v, s.control_points);
        let short = || broken(format!("{name} has not {nu} times {nv} control points"));
        if nu.checked_mul(nv) != Some(all.points.len()) {
            return Err(short());
        }
        let mut points = Vec::with_capacity(all.points.len());
        for j in 0..nv {
            for i in 0..nu {
                let at = i * nv + j;
                let Some(&[x, y, z]) = all.points.get(at).and_then(|p| p.first_chunk()) else {
                    return Err(short());
                };
                let w =
                    if all.weights.is_empty() { Some(1.0) } else { all.weights.get(at).copied() };
                points.push([x, y, z, w.ok_or_else(short)?]);
            }
        }
        let surface = BsplineSurface {
            degree: [s.degree_u, s.degree_v],
            knots: [s.knotvector_u, s.knotvector_v],
            counts: [nu, nv],
            points,
            range: [None; 2],
        };
        out.bspline(&name, surface, None)?;
    }
    Ok(out.done())
}
