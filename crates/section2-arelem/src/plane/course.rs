//! The course of the tool end in the plane: a straight line or a turn about a centre, from its start on.

use std::f64::consts::TAU;

use aptc_geometry::trig;

use super::curve::Curve;
use super::frame::{Vec2, angle, left, ray};

/// A course with its parameter: the distance on a straight one, the angle on a round one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Course {
    /// From `from` along the unit vector `along`.
    Straight { from: Vec2, along: Vec2 },
    /// About `c` with radius `r`, from the angle `start`, `sense` +1 anticlockwise.
    Round { c: Vec2, r: f64, start: f64, sense: f64 },
}

/// A place where the course meets a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Meeting {
    /// Parameter on the course.
    pub(crate) at: f64,
    /// Does it only touch?
    pub(crate) touch: bool,
}

impl Course {
    /// The position at a parameter.
    pub(crate) fn at(&self, s: f64) -> Vec2 {
        match *self {
            Self::Straight { from, along } => from + along * s,
            Self::Round { c, r, start, sense } => c + ray(start + sense * s) * r,
        }
    }

    /// Unit direction at a parameter.
    pub(crate) fn direction(&self, s: f64) -> Vec2 {
        match *self {
            Self::Straight { along, .. } => along,
            Self::Round { start, sense, .. } => left(ray(start + sense * s)) * sense,
        }
    }

    /// Parameter after which the course repeats.
    pub(crate) fn period(&self) -> Option<f64> {
        matches!(self, Self::Round { .. }).then_some(TAU)
    }

    /// Length from the start to a parameter.
    pub(crate) fn length(&self, s: f64) -> f64 {
        match *self {
            Self::Straight { .. } => s,
            Self::Round { r, .. } => r * s,
        }
    }

    /// All meetings with a curve: ahead and behind on a straight course, within one turn from the start
    /// on a round one. A curve missed by no more than `near` counts as touched.
    pub(crate) fn meetings(&self, curve: &Curve, near: f64) -> Vec<Meeting> {
        match (*self, *curve) {
            (Self::Straight { from, along }, Curve::Line { n, d }) => {
                let rate = n.dot(&along);
                if rate.abs() <= 1e-9 {
                    return Vec::new();
                }
                vec![Meeting { at: (d - n.dot(&from)) / rate, touch: false }]
            }
            (Self::Straight { from, along }, Curve::Circle { c, r }) => {
                let w = c - from;
                let foot = w.dot(&along);
                let h = (w - along * foot).norm();
                around(foot, r, h, near)
            }
            (Self::Round { c, r, start, sense }, Curve::Line { n, d }) => {
                // r cos(angle to the normal) = d - n . c
                turn(start, sense, angle(n), r, d - n.dot(&c), near)
            }
            (Self::Round { c, r, start, sense }, Curve::Circle { c: b, r: q }) => {
                let v = b - c;
                let dist = v.norm();
                if dist <= 1e-12 * (r + q) || r <= 0.0 {
                    return Vec::new();
                }
                // Height of the common chord along the line of centres; circles that miss each other by g
                // have it g q / dist beyond the course.
                let h = (dist + (r - q) * (r + q) / dist) / 2.0;
                turn(start, sense, angle(v), r, h, near * q / dist)
            }
        }
    }

    /// The places where the course runs along or against the tangent of a curve beside it.
    pub(crate) fn tangencies(&self, curve: &Curve) -> Vec<f64> {
        match (*self, *curve) {
            (Self::Straight { .. }, Curve::Line { .. }) => Vec::new(),
            (Self::Straight { from, along }, Curve::Circle { c, .. }) => {
                vec![(c - from).dot(&along)]
            }
            (Self::Round { start, sense, .. }, Curve::Line { n, .. }) => {
                both(start, sense, angle(n))
            }
            (Self::Round { c, r, start, sense }, Curve::Circle { c: b, r: q }) => {
                let v = b - c;
                if v.norm() <= 1e-12 * (r + q) {
                    return Vec::new();
                }
                both(start, sense, angle(v))
            }
        }
    }
}

/// An angle in [0, 2 pi).
fn ahead(a: f64) -> f64 {
    let t = a.rem_euclid(TAU);
    // rem_euclid of a tiny negative number rounds to the modulus itself.
    if t >= TAU { 0.0 } else { t }
}

fn both(start: f64, sense: f64, mid: f64) -> Vec<f64> {
    [mid, mid + std::f64::consts::PI].map(|a| ahead(sense * (a - start))).to_vec()
}

fn around(foot: f64, r: f64, h: f64, near: f64) -> Vec<Meeting> {
    let miss = h - r;
    if miss > near {
        return Vec::new();
    }
    let k = ((r - h) * (r + h)).max(0.0).sqrt();
    if k > 0.0 {
        vec![Meeting { at: foot - k, touch: false }, Meeting { at: foot + k, touch: false }]
    } else {
        vec![Meeting { at: foot, touch: true }]
    }
}

fn turn(start: f64, sense: f64, mid: f64, r: f64, h: f64, near: f64) -> Vec<Meeting> {
    if r <= 0.0 {
        return Vec::new();
    }
    let miss = h.abs() - r;
    if miss > near {
        return Vec::new();
    }
    let half = trig::acos_clamped(h / r);
    if miss >= 0.0 {
        return vec![Meeting { at: ahead(sense * (mid + half - start)), touch: true }];
    }
    let one = |a: f64| Meeting { at: ahead(sense * (a - start)), touch: false };
    vec![one(mid - half), one(mid + half)]
}
