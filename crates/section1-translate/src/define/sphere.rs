//! SPHERE.

use aptc_geometry::{Form, Sphere, Vec3};
use aptc_vocabulary::word;

use super::fault::Fault;
use super::format::Item::{N, P, PL, W};
use super::format::{Args, Format, row};

pub(super) const FORMATS: &[Format] = &[
    row(&[N, N, N, N], numbers),
    row(&[W(word::CENTER), P, W(word::RADIUS), N], about_point),
    row(&[W(word::CENTER), N, N, N, W(word::RADIUS), N], about_numbers),
    row(&[P, N], point_radius),
    row(&[W(word::CENTER), P, P], about_through),
    row(&[W(word::CENTER), P, W(word::TANTO), PL], about_touching),
    row(&[P, P, P, P], four_points),
];

fn sphere(center: Vec3, radius: f64) -> Form {
    Form::Sphere(Sphere { center, radius })
}

fn numbers(a: &Args<'_>) -> Result<Form, Fault> {
    let [x, y, z] = a.numbers(0)?;
    Ok(sphere(Vec3::new(x, y, z), a.positive(3)?))
}

fn about_point(a: &Args<'_>) -> Result<Form, Fault> {
    Ok(sphere(a.point(1)?, a.positive(3)?))
}

fn about_numbers(a: &Args<'_>) -> Result<Form, Fault> {
    let [x, y, z] = a.numbers(1)?;
    Ok(sphere(Vec3::new(x, y, z), a.positive(5)?))
}

fn point_radius(a: &Args<'_>) -> Result<Form, Fault> {
    Ok(sphere(a.point(0)?, a.positive(1)?))
}

/// A radius lost in the rounding of its arguments is none.
fn found(a: usize, b: usize, center: Vec3, radius: f64) -> Result<Form, Fault> {
    if radius > 1e-12 * center.amax() {
        Ok(sphere(center, radius))
    } else {
        Err(Fault::Coincide { a, b })
    }
}

fn about_through(a: &Args<'_>) -> Result<Form, Fault> {
    let (p, q) = (a.point(1)?, a.point(2)?);
    found(1, 2, p, (q - p).norm())
}

fn about_touching(a: &Args<'_>) -> Result<Form, Fault> {
    let p = a.point(1)?;
    found(1, 3, p, a.plane(3)?.distance(p).abs())
}

fn four_points(a: &Args<'_>) -> Result<Form, Fault> {
    let p = [a.point(0)?, a.point(1)?, a.point(2)?, a.point(3)?];
    let size = p.iter().fold(0.0_f64, |m, p| m.max(p.amax()));
    for (i, j) in [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)] {
        if (p[j] - p[i]).norm() <= 1e-12 * size {
            return Err(Fault::Coincide { a: i, b: j });
        }
    }
    // From the point whose neighbours are nearest: differences of close points are exact.
    let others = |i: usize| [1, 2, 3].map(|k| p[(i + k) % 4] - p[i]);
    let reach = |i: usize| others(i).iter().map(|e| e.norm()).product::<f64>();
    let base = (0..4).min_by(|i, j| reach(*i).total_cmp(&reach(*j))).unwrap_or(0);
    let [u, v, w] = others(base);
    let volume = u.dot(&v.cross(&w));
    // Flatter, and the centre would be a thousand million edges away.
    if volume.abs() <= 1e-9 * reach(base) || volume.abs() < f64::MIN_POSITIVE {
        return Err(Fault::Dependent { places: vec![0, 1, 2, 3], what: "they lie in one plane" });
    }
    // The centre stands half an edge up each edge; taken again against its own residuals.
    let mut center = Vec3::zeros();
    for _ in 0..3 {
        let lack = |e: &Vec3| e.dot(&(e * 0.5 - center));
        let step = v.cross(&w) * lack(&u) + w.cross(&u) * lack(&v) + u.cross(&v) * lack(&w);
        center += step / volume;
    }
    Ok(sphere(p[base] + center, center.norm()))
}
