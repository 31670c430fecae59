//! SPHERE.

use aptc_geometry::{Form, Sphere, Vec3};
use aptc_vocabulary::word;

use super::fault::Fault;
use super::format::Item::{N, P, PL, W};
use super::format::{Args, Format, row};

pub(super) const FORMATS: &[Format] = &[
    row(&[N, N, N, N], numbers),
    row(&[W(word::CENTER), P, W(word::RADIUS), N], about_point),
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
    let p = a.point(0)?;
    let [u, v, w] = [a.point(1)? - p, a.point(2)? - p, a.point(3)? - p];
    let volume = u.dot(&v.cross(&w));
    let longest = u.norm().max(v.norm()).max(w.norm());
    // Flatter, and the centre would be a thousand million edges away.
    if volume.abs() <= 1e-9 * longest * longest * longest || volume.abs() < f64::MIN_POSITIVE {
        return Err(Fault::Dependent { places: vec![0, 1, 2, 3], what: "they lie in one plane" });
    }
    let sum = v.cross(&w) * u.norm_squared()
        + w.cross(&u) * v.norm_squared()
        + u.cross(&v) * w.norm_squared();
    let to_center = sum / (2.0 * volume);
    Ok(sphere(p + to_center, to_center.norm()))
}
