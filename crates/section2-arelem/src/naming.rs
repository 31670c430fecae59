//! How messages name surfaces, words, places and numbers.

use aptc_geometry::Vec3;
use aptc_protap::{Direction, SurfaceRef};

/// How a message names a surface.
pub(crate) fn called(s: &SurfaceRef) -> String {
    if s.name.name.is_empty() {
        return format!("the {} given there", s.form.kind().word());
    }
    if s.name.subscript == 0 {
        s.name.name.to_string()
    } else {
        format!("{}({})", s.name.name, s.name.subscript)
    }
}

/// The same with its role, which one that no statement gives has in its name.
pub(crate) fn with_role(role: &str, s: &SurfaceRef) -> String {
    if s.name.is_in_words() {
        return s.name.name.to_string();
    }
    if s.name.name.is_empty() {
        return format!("the {} given there as {role} surface", s.form.kind().word());
    }
    format!("the {role} surface {}", called(s))
}

/// The APT word.
pub(crate) fn word_of(d: Direction) -> &'static str {
    match d {
        Direction::Golft => "GOLFT",
        Direction::Gorgt => "GORGT",
        Direction::Gofwd => "GOFWD",
        Direction::Goback => "GOBACK",
        Direction::Goup => "GOUP",
        Direction::Godown => "GODOWN",
    }
}

pub(crate) fn coordinates(p: Vec3) -> String {
    format!("{},{},{}", number(p.x), number(p.y), number(p.z))
}

pub(crate) fn list(surfaces: &[SurfaceRef]) -> String {
    surfaces.iter().map(called).collect::<Vec<_>>().join(" and ")
}

/// A number with as many digits as a person wants to read.
pub(crate) fn number(x: f64) -> String {
    if !x.is_finite() {
        return "infinitely far".into();
    }
    let size = x.abs();
    let text = if size >= 1000.0 {
        format!("{x:.1}")
    } else if size >= 1.0 {
        format!("{x:.4}")
    } else if !(1e-12..1e-4).contains(&size) {
        format!("{x:.6}")
    } else {
        return format!("{x:.2e}");
    };
    let trimmed = text.trim_end_matches('0').trim_end_matches('.');
    if trimmed == "-0" { "0".into() } else { trimmed.into() }
}
