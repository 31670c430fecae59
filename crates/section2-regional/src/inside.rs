//! Is a place of a surface in the tool? Asked of boxes about the tool, whatever kind of surface it is.
//!
//! Places of contact are no help where none of the surface faces the tool: beside its end, above it, or at both sides of a
//! wall. How far a point is from the surface is known of every kind: a box that is smaller than that holds nothing of it.

use aptc_contact::Convex;
use aptc_geometry::{Profile, Surface, Tool, Vec3};

/// What is in the tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Inside {
    /// No place of the surface is deeper than allowed.
    Nothing,
    /// One is so deep.
    Deep(f64),
    /// The bound of boxes was reached.
    Unknown,
}

/// Boxes that are looked at: where nothing else tells; where a place of contact tells, or a shorter stretch will; and to see what
/// is far off.
pub(crate) const MOST: usize = 20_000;
pub(crate) const FEW: usize = 1_000;
pub(crate) const FIRST: usize = 32;
/// Part of what is allowed, and of the tool's size, to which a depth is told.
const FINE: f64 = 0.02;
const LEAST: f64 = 1e-6;

/// Is a place of the surface deeper in the body than `allowed`? The body is known but for `slack`, and lies between the
/// corners of a box; `most` boxes are looked at.
pub(crate) fn inside(
    body: &impl Convex,
    [low, high]: [Vec3; 2],
    surface: &Surface,
    (allowed, slack): (f64, f64),
    most: usize,
) -> Inside {
    let size = (high - low).norm();
    let fine = (FINE * allowed).max(LEAST * size);
    let mut stack = vec![(0.5 * (low + high), 0.5 * (high - low))];
    let mut seen = 0;
    let mut unknown = false;
    // Smaller ones tell nothing of a body that is not known better.
    let smallest = fine.max(slack);
    while let Some((centre, half)) = stack.pop() {
        seen += 1;
        if seen > most {
            return Inside::Unknown;
        }
        let radius = half.norm();
        // The depth that the box can hold at most.
        if -body.near(centre).0 + radius + slack <= allowed + fine {
            continue;
        }
        let foot = surface.foot(centre);
        if foot.distance.abs() > radius {
            continue;
        }
        let depth = -body.near(foot.point).0;
        if depth - slack > allowed {
            return Inside::Deep(depth);
        }
        if radius <= smallest {
            if slack > fine {
                return Inside::Unknown;
            }
            unknown = true;
            continue;
        }
        // Across its longest side.
        let axis = half.imax();
        let mut part = half;
        part[axis] *= 0.5;
        let mut step = Vec3::zeros();
        step[axis] = part[axis];
        stack.push((centre - step, part));
        stack.push((centre + step, part));
    }
    if unknown { Inside::Unknown } else { Inside::Nothing }
}

/// A box about a tool on its way.
pub(crate) fn hull(profile: &Profile, tool: &Tool<'_>, by: Vec3) -> [Vec3; 2] {
    let wide = Vec3::repeat(profile.widest());
    let ends = [profile.bottom(), profile.height()].map(|z| tool.te + tool.ta * z);
    let all = [ends[0], ends[1], ends[0] + by, ends[1] + by];
    let low = all.iter().fold(all[0], |low, p| low.inf(p));
    let high = all.iter().fold(all[0], |high, p| high.sup(p));
    [low - wide, high + wide]
}

#[cfg(test)]
#[path = "inside_tests.rs"]
mod tests;
