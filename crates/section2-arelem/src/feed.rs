//! FEDRAT with a slow-down before each check surface.
//!
//! `FEDRAT/fb,dm,fm` goes at fb, and at fm from the distance dm to the end of every motion along surfaces.
//! `FEDRAT/d1,f1` does so once, with d1 and f1. A unit before or behind the numbers is that of both feeds. Every other FEDRAT
//! is the basic feed and ends the first.

use aptc_cldata::{Arc, Arg, Course, Position};
use aptc_geometry::Vec3;

use crate::space::{Pose, between};

/// Units of a feed.
const UNITS: [&str; 8] = ["MMPM", "MMPR", "IPM", "IPR", "PERMIN", "PERREV", "UPM", "UPR"];

/// What FEDRAT has said.
#[derive(Clone, Debug, Default)]
pub(crate) struct Feed {
    base: Vec<Arg>,
    always: Option<Slow>,
    once: Option<Slow>,
}

/// A slower feed near the end of a motion.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Slow {
    pub(crate) distance: f64,
    pub(crate) feed: Vec<Arg>,
}

/// A slow-down that slows nothing down: what its FEDRAT says of it, and what it needs.
pub(crate) struct BadSlow {
    pub(crate) what: String,
    pub(crate) help: &'static str,
}

impl Feed {
    /// Takes the arguments of a FEDRAT; those that go on to the post-processor, if any.
    pub(crate) fn take(&mut self, args: &[Arg]) -> Result<Option<Vec<Arg>>, BadSlow> {
        let feed = |f: f64| -> Vec<Arg> {
            args.iter()
                .filter(|a| matches!(a, Arg::Word(_)))
                .cloned()
                .chain([Arg::Number(f)])
                .collect()
        };
        let given = numbers(args).unwrap_or_default();
        match *given.as_slice() {
            [base, distance, slow] => {
                right(distance, slow)?;
                self.base = feed(base);
                self.always = Some(Slow { distance, feed: feed(slow) });
                Ok(Some(self.base.clone()))
            }
            [distance, slow] => {
                right(distance, slow)?;
                self.once = Some(Slow { distance, feed: feed(slow) });
                Ok(None)
            }
            _ => {
                self.base = args.to_vec();
                self.always = None;
                Ok(Some(args.to_vec()))
            }
        }
    }

    /// The slow-down of the next motion along surfaces, and the feed after it.
    pub(crate) fn slow(&mut self) -> Option<(Slow, Vec<Arg>)> {
        let slow = self.once.take().or_else(|| self.always.clone())?;
        (slow.distance > 0.0).then(|| (slow, self.base.clone()))
    }
}

/// The numbers of a FEDRAT that is nothing but numbers, and a unit before or behind them.
fn numbers(args: &[Arg]) -> Option<Vec<f64>> {
    let unit = |a: &Arg| matches!(a, Arg::Word(w) if UNITS.contains(&w.as_str()));
    let args = match args {
        [first, rest @ ..] if unit(first) => rest,
        [rest @ .., last] if unit(last) => rest,
        _ => args,
    };
    args.iter().map(|a| if let Arg::Number(n) = a { Some(*n) } else { None }).collect()
}

/// A distance of 0 slows down nowhere, and may be meant.
fn right(distance: f64, feed: f64) -> Result<(), BadSlow> {
    if distance < 0.0 {
        let what = format!("slows down at {distance} before the check surface");
        return Err(BadSlow { what, help: "give a distance of 0 or more" });
    }
    if feed <= 0.0 {
        let what = format!("goes on at a feed of {feed} before the check surface");
        return Err(BadSlow { what, help: "give a feed above 0" });
    }
    Ok(())
}

/// Divides a path at a distance from its end, on a cut vector where need be: of one that stands for a part of a circle on that.
pub(crate) fn divide(
    start: Pose,
    points: &[Position],
    distance: f64,
    arc: Option<&Arc>,
) -> (Vec<Position>, Vec<Position>) {
    let mut left = distance;
    for i in (0..points.len()).rev() {
        let from = if i == 0 { start } else { Pose::of(&points[i - 1]) };
        let to = Pose::of(&points[i]);
        let length = (to.te - from.te).norm();
        if length < left {
            left -= length;
            continue;
        }
        let mut head = points[..i].to_vec();
        let share = 1.0 - left / length;
        if share > 1e-9 {
            let at = between(&from, &to, share).position();
            let chords = arc.filter(|arc| arc.course == Course::Chords);
            let te = chords.map_or(at.te, |arc| beside(arc, [from.te, to.te], share, at.te));
            head.push(Position { te, ..at });
        }
        return (head, points[i..].to_vec());
    }
    (Vec::new(), points.to_vec())
}

/// The place beside a chord, at this share of it, that is as far from the middle of the circle as the chord's ends are.
fn beside(arc: &Arc, ends: [Vec3; 2], share: f64, at: Vec3) -> Vec3 {
    let circle = &arc.circle;
    let out = |p: Vec3| {
        let from = p - circle.center;
        from - circle.axis * from.dot(&circle.axis)
    };
    let [a, b] = ends.map(|p| out(p).norm());
    let here = out(at);
    let by = (a + (b - a) * share) / here.norm() - 1.0;
    if by.is_finite() { at + here * by } else { at }
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::{Circle, trig};

    fn at(x: f64) -> Position {
        Position::upright(Vec3::new(x, 0.0, 0.0))
    }

    #[test]
    fn a_path_is_divided_on_a_cut_vector_or_at_its_end() {
        let path = [at(4.0), at(10.0)];
        let start = Pose { te: Vec3::zeros(), ta: Vec3::z() };
        let (a, b) = divide(start, &path, 2.0, None);
        assert_eq!((a, b), (vec![at(4.0), at(8.0)], vec![at(10.0)]));
        let (a, b) = divide(start, &path, 6.0, None);
        assert_eq!((a, b), (vec![at(4.0)], vec![at(10.0)]));
        let (a, b) = divide(start, &path, 12.0, None);
        assert_eq!((a.len(), b.len()), (0, 2));
    }

    #[test]
    fn the_axis_turns_evenly_from_where_the_tool_stands() {
        let turned = |x: f64, deg: f64| Position {
            te: Vec3::new(x, 0.0, 0.0),
            ta: Vec3::new(trig::sin_deg(deg), 0.0, trig::cos_deg(deg)),
        };
        let (a, b) = divide(Pose::of(&turned(0.0, 10.0)), &[turned(10.0, 40.0)], 4.0, None);
        let [Position { te, ta }] = a[..] else { panic!("{a:?}") };
        assert!((te.x - 6.0).abs() < 1e-12 && (ta - turned(0.0, 28.0).ta).norm() < 1e-12);
        assert_eq!(b.len(), 1);
    }

    #[test]
    fn a_part_of_a_circle_is_divided_on_it() {
        let circle = Circle { center: Vec3::zeros(), axis: Vec3::z(), radius: 10.0 };
        let on = |deg: f64| {
            Position::upright(Vec3::new(10.0 * trig::cos_deg(deg), 10.0 * trig::sin_deg(deg), 3.0))
        };
        let arc = Arc { circle, course: Course::Chords };
        let (a, _) = divide(Pose::of(&on(0.0)), &[on(30.0), on(60.0)], 2.0, Some(&arc));
        let last = a[1].te;
        assert!(
            (trig::hypot(last.x, last.y) - 10.0).abs() < 1e-12 && (last.z - 3.0).abs() < 1e-12,
            "{last}"
        );
    }

    fn n(x: f64) -> Arg {
        Arg::Number(x)
    }

    fn slow(distance: f64, feed: Vec<Arg>) -> Slow {
        Slow { distance, feed }
    }

    #[test]
    fn once_comes_before_always_and_a_plain_feed_ends_always() {
        let mut feed = Feed::default();
        let mut take = |args: &[Arg]| feed.take(args).ok().unwrap();
        assert_eq!(take(&[n(30.0), n(0.5), n(5.0)]), Some(vec![n(30.0)]));
        assert_eq!(take(&[n(0.2), n(3.0)]), None);
        assert_eq!(feed.slow().unwrap().0, slow(0.2, vec![n(3.0)]));
        assert_eq!(feed.slow().unwrap().0, slow(0.5, vec![n(5.0)]));
        assert_eq!(feed.take(&[n(20.0)]).ok().unwrap(), Some(vec![n(20.0)]));
        assert!(feed.slow().is_none());
    }

    #[test]
    fn a_unit_is_that_of_both_feeds() {
        let unit = || Arg::Word("MMPM".into());
        for args in [[unit(), n(30.0), n(0.5), n(5.0)], [n(30.0), n(0.5), n(5.0), unit()]] {
            let mut feed = Feed::default();
            assert_eq!(feed.take(&args).ok().unwrap(), Some(vec![unit(), n(30.0)]));
            let slows = feed.slow().unwrap();
            assert_eq!(slows, (slow(0.5, vec![unit(), n(5.0)]), vec![unit(), n(30.0)]));
        }
        // What the post-processor has to read is left to it.
        let mut feed = Feed::default();
        let most = [Arg::Word("IPR".into()), n(0.1), Arg::Word("MAXIPM".into()), n(20.0)];
        assert_eq!(feed.take(&most).ok().unwrap(), Some(most.to_vec()));
        assert!(feed.slow().is_none());
    }

    #[test]
    fn what_slows_nothing_down_is_refused() {
        let told = |args: &[Arg]| Feed::default().take(args).err().map(|b| b.what);
        let before = |what: &str| Some(format!("{what} before the check surface"));
        assert_eq!(told(&[n(200.0), n(-10.0), n(50.0)]), before("slows down at -10"));
        assert_eq!(told(&[n(-10.0), n(50.0)]), before("slows down at -10"));
        assert_eq!(told(&[n(200.0), n(10.0), n(0.0)]), before("goes on at a feed of 0"));
        assert_eq!(told(&[n(200.0), n(0.0), n(50.0)]), None);
    }
}
