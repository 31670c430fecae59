//! Where a course meets its check surfaces (APT: `CHECK`).

use aptc_protap::Relation;

use super::course::{Course, Meeting};
use super::curve::Curve;

/// A check surface on the course.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Target {
    pub(crate) curve: Curve,
    pub(crate) relation: Relation,
    /// Distance of the tool axis from the surface where the cutter touches it.
    pub(crate) reach: f64,
    /// n of n,INTOF.
    pub(crate) nth: u32,
    /// Closer than this counts as touching.
    pub(crate) near: f64,
    /// A tangency may be this far from exact.
    pub(crate) loose: f64,
}

/// Where a target stops the course.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Stop {
    /// At this parameter.
    At(f64),
    /// Met too few times; the closest approach and its parameter, and whether TO was asked of a cutter that stood in it.
    Never { met: u32, closest: f64, at: f64, within: bool },
    /// Nowhere tangent; the least gap where the courses run alike.
    NotTangent { closest: f64 },
}

/// The place where `target` stops `course`.
///
/// TO and PAST by the manual: the places where the cutter touches the surface alternate, TO first when
/// the cutter starts clear of it, PAST first when it starts in it. The start itself does not count; a cutter that
/// starts at the surface is where it goes first, clear of it or in it.
pub(crate) fn stop(course: &Course, target: &Target) -> Stop {
    match target.relation {
        Relation::Tanto | Relation::Pstan => tangent(course, target),
        Relation::On => nth(course, target, &[0.0], |_| true),
        Relation::To | Relation::Past => {
            let levels = [target.reach, -target.reach];
            let first_is_to = leaves(course, target, &levels) > target.near;
            let wanted = usize::from((target.relation == Relation::To) != first_is_to);
            nth(course, target, &levels, |i| i % 2 == wanted)
        }
    }
}

/// Distance of cutter and surface; negative when it cuts in.
fn gap(course: &Course, target: &Target, s: f64) -> f64 {
    let d = target.curve.distance(course.at(s)).abs();
    if target.relation == Relation::On { d } else { d - target.reach }
}

/// The gap at the start, or where the cutter is clear of what it touches there.
fn leaves(course: &Course, target: &Target, levels: &[f64]) -> f64 {
    let here = gap(course, target, 0.0);
    if here.abs() > target.near {
        return here;
    }
    let next =
        meetings(course, target, levels).into_iter().find(|m| !is_start(course, target, m.at));
    next.map_or(here, |m| gap(course, target, 0.5 * m.at))
}

/// The places where the course meets the surface at these distances, in their order.
fn meetings(course: &Course, target: &Target, levels: &[f64]) -> Vec<Meeting> {
    let mut all: Vec<Meeting> = levels
        .iter()
        .filter_map(|by| target.curve.offset(*by))
        .flat_map(|c| course.meetings(&c, target.near))
        .filter(|m| m.at >= 0.0)
        .collect();
    all.sort_by(|a, b| a.at.total_cmp(&b.at));
    all
}

fn nth(course: &Course, target: &Target, levels: &[f64], wanted: impl Fn(usize) -> bool) -> Stop {
    let turn = meetings(course, target, levels);
    let turns = if course.period().is_some() { target.nth.saturating_add(2) } else { 1 };
    let (mut index, mut met) = (0, 0);
    for k in 0..turns {
        for m in &turn {
            let at = m.at + f64::from(k) * course.period().unwrap_or(0.0);
            if k == 0 && is_start(course, target, at) {
                continue;
            }
            // A place where it only touches is the last of one kind and the first of the other.
            for _ in 0..if m.touch && levels.len() > 1 { 2 } else { 1 } {
                if wanted(index) {
                    met += 1;
                    if met == target.nth.max(1) {
                        return Stop::At(at);
                    }
                }
                index += 1;
            }
        }
    }
    let mut closest = (gap(course, target, 0.0), 0.0);
    for s in course.tangencies(&target.curve).into_iter().filter(|s| *s > 0.0) {
        let g = gap(course, target, s);
        if g.abs() < closest.0.abs() {
            closest = (g, s);
        }
    }
    let within = target.relation == Relation::To && leaves(course, target, levels) < -target.near;
    Stop::Never { met, closest: closest.0, at: closest.1, within }
}

/// Does the contact at the start last until there?
fn is_start(course: &Course, target: &Target, at: f64) -> bool {
    let touching = |s: f64| gap(course, target, s).abs() <= target.near;
    touching(0.0) && [0.25, 0.5, 0.75].into_iter().all(|f| touching(f * at))
}

fn tangent(course: &Course, target: &Target) -> Stop {
    let mut places = course.tangencies(&target.curve);
    places.retain(|s| *s >= 0.0 || course.length(*s) >= -target.near);
    places.sort_by(f64::total_cmp);
    let fits = |s: &f64| (target.curve.distance(course.at(*s)).abs() - target.reach).abs();
    let closest = places.iter().map(fits).fold(f64::INFINITY, f64::min);
    places.retain(|s| fits(s) <= target.loose);
    // The start is the last resort on a straight course; on a round one it is reached by a full turn.
    let start = |s: &f64| course.length(*s) <= target.near;
    let mut ahead: Vec<f64> = places.iter().copied().filter(|s| !start(s)).collect();
    match course.period() {
        Some(period) => {
            let once: Vec<f64> = places;
            for k in 1..=target.nth.max(1) {
                ahead.extend(once.iter().map(|s| s + f64::from(k) * period));
            }
        }
        None => ahead.extend(places.iter().copied().filter(start).map(|s| s.max(0.0))),
    }
    let n = target.nth.max(1) as usize;
    ahead.get(n - 1).map_or(Stop::NotTangent { closest }, |s| Stop::At(*s))
}

#[cfg(test)]
mod tests {
    use super::super::frame::Vec2;
    use super::*;

    fn x_axis() -> Course {
        Course::Straight { from: Vec2::zeros(), along: Vec2::new(1.0, 0.0) }
    }

    fn target(curve: Curve, relation: Relation, reach: f64, nth: u32) -> Target {
        Target { curve, relation, reach, nth, near: 1e-6, loose: 1e-6 }
    }

    #[test]
    fn on_a_circle_the_first_and_the_second_intersection() {
        let c = Curve::Circle { c: Vec2::new(10.0, 0.0), r: 3.0 };
        assert_eq!(stop(&x_axis(), &target(c, Relation::On, 0.0, 1)), Stop::At(7.0));
        assert_eq!(stop(&x_axis(), &target(c, Relation::On, 0.0, 2)), Stop::At(13.0));
        let Stop::Never { met, .. } = stop(&x_axis(), &target(c, Relation::On, 0.0, 3)) else {
            panic!("a line meets a circle twice")
        };
        assert_eq!(met, 2);
    }

    #[test]
    fn to_and_past_alternate_from_outside_and_begin_with_past_from_within() {
        let c = Curve::Circle { c: Vec2::new(10.0, 0.0), r: 3.0 };
        for (relation, nth, at) in [
            (Relation::To, 1, 6.0),
            (Relation::Past, 1, 8.0),
            (Relation::To, 2, 12.0),
            (Relation::Past, 2, 14.0),
        ] {
            assert_eq!(stop(&x_axis(), &target(c, relation, 1.0, nth)), Stop::At(at));
        }
        let l = Curve::Line { n: Vec2::new(1.0, 0.0), d: 0.5 };
        assert_eq!(stop(&x_axis(), &target(l, Relation::Past, 1.0, 1)), Stop::At(1.5));
        assert!(matches!(stop(&x_axis(), &target(l, Relation::To, 1.0, 1)), Stop::Never { .. }));
        // Round a circle and back to the line that was touched at the start.
        let round = Course::Round { c: Vec2::zeros(), r: 2.0, start: 0.0, sense: -1.0 };
        let l = Curve::Line { n: Vec2::new(0.0, 1.0), d: 0.5 };
        for (relation, at) in [(Relation::To, 1.0), (Relation::Past, 7.0 / 6.0)] {
            let stop = stop(&round, &target(l, relation, 0.5, 1));
            let there = |s: f64| (s - at * std::f64::consts::PI).abs() < 1e-9;
            assert!(matches!(stop, Stop::At(s) if there(s)), "{relation:?} {stop:?}");
        }
    }

    #[test]
    fn tangent_where_the_foot_of_the_centre_is() {
        let c = Curve::Circle { c: Vec2::new(5.0, 3.0), r: 3.0 };
        assert_eq!(stop(&x_axis(), &target(c, Relation::Tanto, 0.0, 1)), Stop::At(5.0));
        let c = Curve::Circle { c: Vec2::new(5.0, 3.0), r: 2.0 };
        assert_eq!(
            stop(&x_axis(), &target(c, Relation::Tanto, 0.0, 1)),
            Stop::NotTangent { closest: 1.0 }
        );
    }

    #[test]
    fn a_full_turn_ends_on_the_surface_where_it_began() {
        let round = Course::Round { c: Vec2::zeros(), r: 2.0, start: 0.0, sense: 1.0 };
        let l = Curve::Line { n: Vec2::new(0.0, 1.0), d: 0.0 };
        assert!(matches!(stop(&round, &target(l, Relation::On, 0.0, 1)),
            Stop::At(s) if (s - std::f64::consts::PI).abs() < 1e-12));
        assert!(matches!(stop(&round, &target(l, Relation::On, 0.0, 2)),
            Stop::At(s) if (s - std::f64::consts::TAU).abs() < 1e-12));
    }
}
