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
    /// One is so deep, this one.
    Deep(f64, Vec3),
    /// The bound of boxes was reached.
    Unknown,
}

/// Boxes that are looked at: where nothing else tells; where a place of contact tells, or a shorter stretch will; before a place
/// of contact is looked for, which takes as long; and to see what is far off.
pub(crate) const MOST: usize = 20_000;
pub(crate) const FEW: usize = 1_000;
pub(crate) const SOON: usize = 256;
pub(crate) const FIRST: usize = 32;
/// Part of INTOL, and of the tool's size, to which a depth is told.
const FINE: f64 = 0.02;
const LEAST: f64 = 1e-6;
/// Boxes that are looked at for the deepest place, and steps along the surface to it: a foot on rulings takes milliseconds.
const TOLD: usize = 250;
const STEPS: u32 = 60;

/// Is a place of the surface deeper in the body than `allowed`, INTOL less a thickness? The body is known but for `slack`; what may be
/// so deep lies between the corners of a box; `most` boxes are looked at.
pub(crate) fn inside(
    body: &impl Convex,
    [low, high]: [Vec3; 2],
    surface: &Surface,
    (allowed, slack, intol): (f64, f64, f64),
    most: usize,
) -> Inside {
    let size = (high - low).norm();
    let fine = (FINE * intol).max(LEAST * size);
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
            return Inside::Deep(depth, foot.point);
        }
        if radius <= smallest {
            if slack > fine {
                return Inside::Unknown;
            }
            unknown = true;
            continue;
        }
        stack.extend(halves(centre, half));
    }
    if unknown { Inside::Unknown } else { Inside::Nothing }
}

/// A place of a surface in a tool on its way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Found {
    pub(crate) depth: f64,
    pub(crate) place: Vec3,
    /// Share of the way at which it is so deep.
    pub(crate) t: f64,
}

/// The deepest place of the surface in a tool that goes by the body's way, as far as [`TOLD`] boxes tell: so deep it is at
/// least, and no deeper is it told than it is. `None` where no place is found deeper than `allowed`. `real` tells how deep a
/// place gets in the tool and at which share of the way; the body knows that but for `slack`, and nothing gets deeper than `most`. It
/// begins with the deepest of the places `first`.
pub(crate) fn deepest(
    body: &impl Convex,
    [low, high]: [Vec3; 2],
    surface: &Surface,
    (allowed, slack, most): (f64, f64, f64),
    first: impl Iterator<Item = Vec3>,
    real: impl Fn(Vec3) -> (f64, f64),
) -> Option<Found> {
    let bound = |centre: Vec3, half: Vec3| (-body.near(centre).0 + half.norm() + slack).min(most);
    let mut best = Found { depth: allowed, place: Vec3::zeros(), t: f64::NAN };
    for place in first {
        let (depth, t) = real(place);
        if depth > best.depth {
            best = Found { depth, place, t };
        }
    }
    let whole = (0.5 * (low + high), 0.5 * (high - low));
    let mut stack = vec![(bound(whole.0, whole.1), whole)];
    let smallest = (LEAST * (high - low).norm()).max(slack);
    for _ in 0..TOLD {
        let Some((bounded, (centre, half))) = stack.pop() else { break };
        if bounded <= best.depth * (1.0 + FINE) {
            continue;
        }
        let foot = surface.foot(centre);
        if foot.distance.abs() > half.norm() {
            continue;
        }
        let (depth, t) = real(foot.point);
        if depth > best.depth {
            best = Found { depth, place: foot.point, t };
        }
        if half.norm() <= smallest {
            continue;
        }
        let mut halves =
            halves(centre, half).map(|(centre, half)| (bound(centre, half), (centre, half)));
        // The deeper one first.
        halves.sort_by(|a, b| a.0.total_cmp(&b.0));
        stack.extend(halves);
    }
    (best.depth > allowed).then(|| climbed(best, body, surface, &real))
}

/// From a place along the surface to where it is deepest, by steps that are halved where they lead to none deeper.
fn climbed(
    mut best: Found,
    body: &impl Convex,
    surface: &Surface,
    real: &impl Fn(Vec3) -> (f64, f64),
) -> Found {
    let mut step = best.depth.abs();
    for _ in 0..STEPS {
        let place = surface.foot(best.place - body.near(best.place).1 * step).point;
        let (depth, t) = real(place);
        if depth > best.depth {
            best = Found { depth, place, t };
        } else {
            step *= 0.5;
        }
    }
    best
}

/// Both halves of a box, cut across its longest side.
fn halves(centre: Vec3, half: Vec3) -> [(Vec3, Vec3); 2] {
    let axis = half.imax();
    let mut part = half;
    part[axis] *= 0.5;
    let mut step = Vec3::zeros();
    step[axis] = part[axis];
    [(centre - step, part), (centre + step, part)]
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
