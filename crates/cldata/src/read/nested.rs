//! Nested definitions, as CL text has them in circular moves: `(CIRCLE/x,y,z,r)`, `(LINE/..)`,
//! `(PLANE/PERPTO,(PLANE/..),(POINT/..),(POINT/..))`.

use aptc_geometry::{Plane, Vec3};
use smol_str::SmolStr;

use super::args;
use super::comments::unit;

/// How deep definitions may stand in one another.
const DEEPEST: u32 = 8;

/// What a nested definition gives.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Nested {
    Point(Vec3),
    Vector(Vec3),
    /// Two points of the line.
    Line(Vec3, Vec3),
    Plane(Plane),
    /// Centre, axis if it is given, radius.
    Round(Vec3, Option<Vec3>, f64),
}

/// An argument of a statement with nested definitions.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Part {
    Number(f64),
    Word(SmolStr),
    Nested(Nested),
}

/// The arguments; `None` when one cannot be read.
pub(super) fn parts(text: &[u8]) -> Option<Vec<Part>> {
    parts_at(text, DEEPEST)
}

fn parts_at(text: &[u8], depth: u32) -> Option<Vec<Part>> {
    let mut out = Vec::new();
    for field in args::fields(text) {
        let field = field.trim_ascii();
        if field.is_empty() {
            continue;
        }
        if let Some(x) = args::coordinate(field) {
            out.push(Part::Number(x));
        } else if let Some(inner) = field.strip_prefix(b"(").and_then(|f| f.strip_suffix(b")")) {
            out.push(Part::Nested(definition(inner, depth.checked_sub(1)?)?));
        } else if field.contains(&b'(') {
            return None;
        } else {
            out.push(Part::Word(args::upper(field)));
        }
    }
    Some(out)
}

/// `KIND/arguments`.
fn definition(text: &[u8], depth: u32) -> Option<Nested> {
    let slash = memchr::memchr(b'/', text)?;
    let kind = args::upper(&text[..slash]);
    let mut parts = parts_at(&text[slash + 1..], depth)?;
    if parts.first() == Some(&Part::Word("CANON".into())) {
        parts.remove(0);
        return plain(&kind, &parts, true);
    }
    plain(&kind, &parts, false)
}

fn plain(kind: &str, parts: &[Part], canon: bool) -> Option<Nested> {
    let numbers: Option<Vec<f64>> = parts
        .iter()
        .map(|p| match p {
            Part::Number(x) => Some(*x),
            _ => None,
        })
        .collect();
    let Some(n) = numbers else { return composed(kind, parts) };
    let v = |i: usize| Vec3::new(n[i], n[i + 1], n[i + 2]);
    match (kind, n.len()) {
        ("POINT" | "PT", 3) => Some(Nested::Point(v(0))),
        ("POINT" | "PT", 2) => Some(Nested::Point(Vec3::new(n[0], n[1], 0.0))),
        ("VECTOR" | "VE", 3) => Some(Nested::Vector(v(0))),
        ("LINE" | "LN", 6) => Some(Nested::Line(v(0), v(3))),
        ("LINE" | "LN", 4) if canon => {
            Some(Nested::Plane(Plane::new(Vec3::new(n[0], n[1], n[2]), n[3])?))
        }
        ("LINE" | "LN", 4) => {
            Some(Nested::Line(Vec3::new(n[0], n[1], 0.0), Vec3::new(n[2], n[3], 0.0)))
        }
        ("PLANE" | "PL", 4) => Some(Nested::Plane(Plane::new(v(0), n[3])?)),
        ("CIRCLE" | "CI" | "CYLNDR" | "CY", 7) => {
            Some(Nested::Round(v(0), Some(unit(v(3))?), n[6]))
        }
        ("CIRCLE" | "CI", 4) => Some(Nested::Round(v(0), None, n[3])),
        ("CIRCLE" | "CI", 3) => Some(Nested::Round(Vec3::new(n[0], n[1], 0.0), None, n[2])),
        _ => None,
    }
}

/// Definitions by other definitions.
fn composed(kind: &str, parts: &[Part]) -> Option<Nested> {
    let word = |w: &str| Part::Word(w.into());
    let point = |p: &Part| match p {
        Part::Nested(Nested::Point(v)) => Some(*v),
        _ => None,
    };
    match (kind, parts) {
        ("LINE" | "LN", [a, b]) => Some(Nested::Line(point(a)?, point(b)?)),
        ("CIRCLE" | "CI", [c, Part::Number(r)]) => Some(Nested::Round(point(c)?, None, *r)),
        ("CIRCLE" | "CI", [w, c, on]) if *w == word("CENTER") => {
            let (c, on) = (point(c)?, point(on)?);
            Some(Nested::Round(c, None, (on - c).norm()))
        }
        ("CIRCLE" | "CI", [w, c, r, Part::Number(radius)])
            if *w == word("CENTER") && *r == word("RADIUS") =>
        {
            Some(Nested::Round(point(c)?, None, *radius))
        }
        ("CYLNDR" | "CY", [p, Part::Nested(Nested::Vector(a)), Part::Number(r)]) => {
            Some(Nested::Round(point(p)?, Some(unit(*a)?), *r))
        }
        ("CYLNDR" | "CY", [p, i, j, k, r]) => {
            let number = |p: &Part| match p {
                Part::Number(x) => Some(*x),
                _ => None,
            };
            let axis = Vec3::new(number(i)?, number(j)?, number(k)?);
            Some(Nested::Round(point(p)?, Some(unit(axis)?), number(r)?))
        }
        ("PLANE" | "PL", [w, Part::Nested(Nested::Plane(to)), a, b]) if *w == word("PERPTO") => {
            let (a, b) = (point(a)?, point(b)?);
            through(a, to.n.cross(&(b - a)))
        }
        ("PLANE" | "PL", [w, Part::Nested(Nested::Plane(to)), rest @ ..])
            if *w == word("PERPTO") && rest.len() == 6 =>
        {
            let n: Option<Vec<f64>> = rest
                .iter()
                .map(|p| match p {
                    Part::Number(x) => Some(*x),
                    _ => None,
                })
                .collect();
            let n = n?;
            let (a, b) = (Vec3::new(n[0], n[1], n[2]), Vec3::new(n[3], n[4], n[5]));
            through(a, to.n.cross(&(b - a)))
        }
        ("PLANE" | "PL", [p, w, Part::Nested(Nested::Vector(v))]) if *w == word("PERPTO") => {
            through(point(p)?, *v)
        }
        ("PLANE" | "PL", [p, w, Part::Nested(Nested::Plane(to))])
            if *w == word("PARLEL") || *w == word("PA") =>
        {
            through(point(p)?, to.n)
        }
        ("PLANE" | "PL", [a, b, c]) => {
            let (a, b, c) = (point(a)?, point(b)?, point(c)?);
            through(a, (b - a).cross(&(c - a)))
        }
        _ => None,
    }
}

/// The plane through a point with a normal of any length.
fn through(p: Vec3, n: Vec3) -> Option<Nested> {
    Plane::new(n, n.dot(&p)).map(Nested::Plane)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn one(text: &str) -> Option<Nested> {
        match parts(text.as_bytes())?.into_iter().next()? {
            Part::Nested(n) => Some(n),
            _ => None,
        }
    }

    #[test]
    fn definitions_of_circular_moves() {
        let v = Vec3::new;
        assert_eq!(
            one("(CIRCLE/ -5.0, 65.0, 50.0, 15.0)"),
            Some(Nested::Round(v(-5.0, 65.0, 50.0), None, 15.0))
        );
        assert_eq!(
            one("(circle/canon,1,2,3,0,0,2,4)"),
            Some(Nested::Round(v(1.0, 2.0, 3.0), Some(v(0.0, 0.0, 1.0)), 4.0))
        );
        assert_eq!(
            one("(LINE/(POINT/1,2,3),(POINT/4,5,6))"),
            Some(Nested::Line(v(1.0, 2.0, 3.0), v(4.0, 5.0, 6.0)))
        );
        let Some(Nested::Plane(p)) =
            one("(PLANE/PERPTO,(PLANE/0,0,1,5),(POINT/1,0,0),(POINT/1,9,0))")
        else {
            panic!("no plane");
        };
        assert!(p.distance(v(1.0, 4.0, 7.0)).abs() < 1e-12 && p.n.x.abs() > 0.99);
        assert_eq!(one("(CIRCLE/1,2)"), None);
        assert_eq!(one("(POINT/X,2,3)"), None);
        let deep = "(LINE/".repeat(50) + &")".repeat(50);
        assert_eq!(parts(deep.as_bytes()), None);
    }
}
