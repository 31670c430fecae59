//! How far the next path may lie.

use aptc_geometry::{Profile, Segment, Vec3};

use crate::area::{AxisArea, Hold, StepoverArea};
use crate::drive::Course;
use crate::position::{Position, level};
use crate::ridge::Pass;
use crate::settings::Band;
use crate::solve::Setup;

/// A cutter that nearly fills a hollow moves its contact so many times as fast as itself, at most the inverse.
const LEAST: f64 = 0.05;

/// Part of a width that is counted on, however far the chords may leave their line sideways.
const LEFT: f64 = 0.5;

/// Distance between two paths on a surface of curvature `k` across them (positive hollow) that leaves a
/// scallop of height `h`, for a cutter whose profile across the path is a circle of radius `r` there;
/// never more than its diameter.
pub(crate) fn scallop_width(r: f64, h: f64, k: f64) -> f64 {
    let h = h.min(r);
    let most = 2.0 * r;
    if h <= 0.0 || r <= 0.0 {
        return 0.0;
    }
    if k.abs() * r < 1e-9 {
        return (2.0 * (2.0 * r * h - h * h).max(0.0).sqrt()).min(most);
    }
    let radius = 1.0 / k.abs();
    // Centres of the paths on the circle of radius c, the ridge on that of radius e; they differ by r - h.
    let (c, e) = if k < 0.0 { (radius + r, radius + h) } else { (radius - r, radius - h) };
    if c <= 0.0 || e <= 0.0 {
        return 0.0;
    }
    // The cosine of the angle between a centre and the ridge says nothing of small ones: over a surface that is flat but for
    // rounding it is 1. Its half has the square of the sine (r^2 - (c - e)^2) / (4 c e).
    let sine = ((2.0 * r * h - h * h) / (4.0 * c * e)).clamp(0.0, 1.0).sqrt();
    let angle = 2.0 * aptc_geometry::trig::atan2(sine, (1.0 - sine * sine).sqrt());
    (2.0 * radius * angle).min(most)
}

/// The step of the parameter across the path behind `points`.
///
/// The smallest over the path: for a fixed distance (scallop 0) the distance itself, else the width at
/// which two neighbouring paths leave the scallop, by the radius of the cutter across the path and the
/// curvature of the part surface there. A negative greatest step is one of the parameter.
pub(crate) fn parameter_step(
    area: &StepoverArea,
    setup: &Setup<'_>,
    points: &[Position],
    course: Course,
) -> f64 {
    let Setup { drive, profile, .. } = *setup;
    let by_parameter = area.most < 0.0;
    if area.scallop <= 0.0 && area.most == 0.0 {
        return 1.0;
    }
    if area.scallop <= 0.0 && by_parameter {
        return area.most.abs();
    }
    let mut step = if by_parameter { area.most.abs() } else { f64::INFINITY };
    let round = |i: usize| {
        let p: &Position = points.get(i)?;
        Some(Round::at(profile, p.ta, p.normal, side_of(points, i)))
    };
    let mut near = [None, None, round(0)];
    for (i, p) in points.iter().enumerate() {
        let place = drive.place(p.drive_uv, course);
        // The part of the step that leads away from the path, as seen on the part surface.
        near = [near[1], near[2], round(i + 1)];
        let across = laid(place.speed, place.direction, p.normal);
        // A pass that is one place, as at the top of a dome, has no direction: the next lies all round it.
        let side = match side_of(points, i) {
            side if side != Vec3::zeros() => side,
            _ => across.try_normalize(0.0).unwrap_or_else(Vec3::zeros),
        };
        let k = across_curvature(setup, p, side);
        let radius = radius_across(profile, &near);
        let thick = if setup.part.touches { setup.thick() } else { 0.0 };
        let mut speed = across.dot(&side).abs();
        if setup.part.touches && drive.hold == Hold::On {
            // It is the tool that is led: in a hollow its contact moves faster, on a hump more slowly.
            // An axis at an angle to the normal turns with it, and so does what lies between contact and tool end.
            let lever = match setup.axis {
                AxisArea::Angle { part: true, .. } => (p.te - p.contact).dot(&p.normal),
                _ => radius + thick,
            };
            speed /= (1.0 - k * lever).max(LEAST);
        }
        if speed <= 1e-12 * across.norm() || speed == 0.0 {
            continue;
        }
        let mut width = if by_parameter || area.most == 0.0 { f64::INFINITY } else { area.most };
        let height = kept(area.scallop, setup);
        // What is left stands on the surface with its thickness, which is as much wider as it is rounder.
        let wider = (1.0 - k * thick).max(LEAST);
        let allowed = scallop_width(radius, height, k / wider) / wider;
        if allowed > 0.0 {
            width = width.min(allowed);
        }
        // A ball is as round everywhere, so that the formula tells it all; its flank and the rim of its top are not.
        let ball = profile.is_round() && p.segment == Segment::Arc;
        if allowed > 0.0 && ball && points.len() > 2 {
            let middle = i.clamp(1, points.len() - 2);
            let three = [middle - 1, middle, middle + 1].map(|i| &points[i]);
            // Over a hump what is seen from the centre is less on the surface, in a hollow more.
            let aside = setup.aside(three, side) / (1.0 - k * (radius + thick)).max(LEAST);
            // As high in the band as a tool stands at most, it leaves this to the chords.
            let room = setup.band.outtol - setup.highest();
            let wide = scallop_width(radius, height + room, k / wider) / wider;
            width = width.min((wide - aside).max(LEFT * wide));
        }
        if height > 0.0 && !ball {
            let along = path_direction(points, i);
            let strip = Pass { profile, at: p, along, side, curvature: k }.strip(thick + height);
            // Its chords may leave the lines sideways; few of them do by all that they may, and where the strip is no wider the
            // passes have to be that close all the same.
            let strip = (strip - 2.0 * setup.lateral).max(LEFT * strip);
            if strip > 0.0 {
                width = width.min(strip);
            }
        }
        if width.is_finite() && width > 0.0 {
            step = step.min(width / speed);
        }
    }
    if step.is_finite() { step } else { 1.0 }.min(area.parameter.unwrap_or(f64::INFINITY))
}

/// The height that the passes are laid for: less than the scallop by a part of the band, for what a circle does not tell of
/// cutter and surface between two passes, and for rounding.
pub(crate) fn kept(scallop: f64, setup: &Setup<'_>) -> f64 {
    /// Parts of the band, of which the chords leave the rest to the height besides, and of the scallop, for places
    /// between those that are looked at.
    const PARTS: [f64; 2] = [0.02, 0.002];
    /// Part of the scallop, at most.
    const MOST: f64 = 0.1;
    let Band { intol, outtol } = setup.band;
    scallop - (PARTS[0] * (intol + outtol) + PARTS[1] * scallop).min(MOST * scallop)
}

/// A step of the drive as the tool takes it: projected along the line of projection on the plane that touches
/// the part surface.
fn laid(across: Vec3, direction: Option<Vec3>, n: Vec3) -> Vec3 {
    let Some(along) = direction else { return across };
    let down = n.dot(&along);
    if down.abs() < 1e-6 { across } else { across - along * (n.dot(&across) / down) }
}

/// Curvature of the part surface across the path.
fn across_curvature(setup: &Setup<'_>, p: &Position, side: Vec3) -> f64 {
    let d = setup.part.surface.at(p.part_uv[0], p.part_uv[1]);
    d.curvature_along(p.normal, side).unwrap_or(0.0)
}

/// How round the cutter is where it touches.
#[derive(Clone, Copy, Debug)]
struct Round {
    /// Radii along the profile and around the axis.
    radii: [f64; 2],
    /// Angle from the direction along the profile, outwards, to that across the path.
    turn: f64,
    /// Does a face touch, so that the direction along the profile is any?
    flat: bool,
}

/// Half a turn, after which the cutter is bent the same.
const HALF: f64 = std::f64::consts::PI;
/// Between two places that differ by more any direction may come.
const MUCH: f64 = HALF / 3.0;
/// Part of the angle between two places by which the direction may turn beyond either.
const BEYOND: f64 = 0.25;

impl Round {
    /// Of a cutter with the axis `ta` at a surface with that normal.
    fn at(profile: &Profile, ta: Vec3, normal: Vec3, side: Vec3) -> Self {
        let tool = aptc_contact::Tool { profile, te: Vec3::zeros(), ta };
        let s = tool.support(-level(normal, ta));
        let [along, around] = s.frame.map(|e| e.dot(&side));
        let flat = s.radii.iter().all(|r| r.is_infinite());
        Self { radii: s.radii, turn: aptc_geometry::trig::atan2(around, along), flat }
    }

    /// Radius in the direction `turn`, by the theorem of Euler.
    fn radius(&self, turn: f64) -> f64 {
        let (s, c) = aptc_geometry::trig::sin_cos(turn);
        let mut curvature = 0.0;
        for (c, radius) in [c, s].into_iter().zip(self.radii) {
            if radius > 0.0 && c.abs() > 1e-9 {
                curvature += c * c / radius;
            } else if c.abs() > 1e-9 {
                return 0.0;
            }
        }
        1.0 / curvature
    }
}

/// Least radius of the cutter in the plane of the normal and the direction across the path, from the place before to the
/// place after: on its way over a crest the contact swings round the cutter, between two places too.
///
/// The cutter is bent most along its profile where its corner touches, and less the more the direction turns from
/// there: of the angles that come between two places the least decides. Corner and radius around the axis are at both
/// places as round as between, the one exactly and the other, `r + e / sin`, where the normal leans most.
fn radius_across(profile: &Profile, near: &[Option<Round>; 3]) -> f64 {
    let [before, Some(here), after] = near else { return profile.widest() };
    let mut least = here.radius(here.turn);
    for other in [before, after].into_iter().flatten() {
        if here.flat && other.flat {
            continue;
        }
        // What leans tells how round the cutter is; beside a face that lies on the surface any direction comes.
        let leaning = if here.flat { other } else { here };
        let steeper = leaning.radii[1].min(other.radii[1]).min(here.radii[1]);
        let round = Round { radii: [leaning.radii[0], steeper], ..*leaning };
        if !(round.radii[0] > 0.0 && round.radii[0] < steeper) {
            continue;
        }
        let from = here.turn;
        let gone = other.turn - from;
        let gone = gone - 2.0 * HALF * (gone / (2.0 * HALF)).round();
        let more = BEYOND * gone.abs();
        let (low, high) = (from.min(from + gone) - more, from.max(from + gone) + more);
        let any = here.flat || other.flat || gone.abs() > MUCH;
        let along = (low / HALF).ceil() <= (high / HALF).floor();
        let off = |a: f64| (a - HALF * (a / HALF).round()).abs();
        let turn = if any || along { 0.0 } else { off(low).min(off(high)) };
        least = least.min(round.radius(turn));
    }
    least.min(profile.widest())
}

/// The direction across the path at the i-th of its points.
fn side_of(points: &[Position], i: usize) -> Vec3 {
    let across = points[i].normal.cross(&path_direction(points, i));
    across.try_normalize(0.0).unwrap_or_else(Vec3::zeros)
}

/// Along the surface there: between neighbours at unlike distances the chord would rise or fall.
fn path_direction(points: &[Position], i: usize) -> Vec3 {
    let a = &points[i.saturating_sub(1)];
    let b = &points[(i + 1).min(points.len() - 1)];
    let (way, n) = (b.contact - a.contact, points[i].normal);
    (way - n * n.dot(&way)).try_normalize(0.0).unwrap_or_else(Vec3::zeros)
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::Cutter;

    #[test]
    fn published_widths() {
        for (k, w) in [(0.0, 0.632_139_2), (-0.02, 0.602_661_8), (0.02, 0.666_401_1)] {
            assert!((scallop_width(5.0, 0.01, k) - w).abs() < 1e-7, "{k}");
        }
        assert!((scallop_width(5.0, 9.0, 0.0) - 10.0).abs() < 1e-15);
    }

    /// A plane whose curvature is not quite nothing is one.
    #[test]
    fn the_width_goes_over_into_that_of_a_plane() {
        let flat = scallop_width(5.0, 0.05, 0.0);
        for i in 4..20 {
            for k in [1.0, -3.0].map(|k| k * 0.1_f64.powi(i)) {
                let width = scallop_width(5.0, 0.05, k);
                assert!((width - flat).abs() <= 5.0 * k.abs() * flat + 1e-13, "{k} {width} {flat}");
            }
        }
    }

    /// Beside the top of a dome, between two places however far apart, the cutter is nowhere less round across the path.
    #[test]
    fn the_radius_holds_between_places_too() {
        for cutter in [
            Cutter::mill(12.0, 3.0, 40.0),
            Cutter::mill(16.0, 1.0, 40.0),
            Cutter::mill(10.0, 5.0, 40.0),
            Cutter { alpha_deg: 5.0, ..Cutter::mill(12.0, 2.0, 40.0) },
        ] {
            let profile = Profile::new(&cutter).unwrap();
            for beside in [0.01, 0.2, 1.0, 4.0, 15.0] {
                for (step, lean) in [(0.5, 0.0), (3.0, 0.05), (6.0, 0.0), (9.0, 0.1)] {
                    let ta = Vec3::new(lean, 0.3 * lean, 1.0).normalize();
                    let at = |x: f64| {
                        let p = Vec3::new(x, beside, (3600.0 - x * x - beside * beside).sqrt());
                        let (n, ahead) = (p / 60.0, Vec3::new(p.z, 0.0, -x));
                        Round::at(&profile, ta, n, n.cross(&ahead).normalize())
                    };
                    for i in -5..5 {
                        let x = |k: i32| (f64::from(i + k) + 0.37) * step;
                        let told = [0, 1].map(|k| {
                            let near = [at(x(k - 1)), at(x(k)), at(x(k + 1))].map(Some);
                            radius_across(&profile, &near)
                        });
                        for k in 0..=500 {
                            let here = at(x(0) + step * f64::from(k) / 500.0);
                            let least = here.radius(here.turn).min(profile.widest());
                            let told = told[0].min(told[1]);
                            assert!(told <= least * 1.01, "{cutter:?} {beside} {step} {i} {k}");
                        }
                    }
                }
            }
        }
    }

    /// Two balls that far apart on a circle of that curvature leave the scallop between them.
    #[test]
    fn the_ridge_is_as_high_as_asked() {
        for k in [0.03, -0.05, 0.1] {
            let (r, h) = (3.0, 0.05);
            let w = scallop_width(r, h, k);
            let radius = 1.0 / f64::abs(k);
            let angle = w / radius;
            let c = if k < 0.0 { radius + r } else { radius - r };
            // Where the two circles cross, on the ray between.
            let (half, d) = (0.5 * angle, c * aptc_geometry::trig::cos(0.5 * angle));
            let side = c * aptc_geometry::trig::sin(half);
            let reach = (r * r - side * side).sqrt();
            let ridge = if k < 0.0 { d - reach } else { d + reach };
            let height = if k < 0.0 { ridge - radius } else { radius - ridge };
            assert!((height - h).abs() < 1e-12, "{k} {height}");
        }
    }
}
