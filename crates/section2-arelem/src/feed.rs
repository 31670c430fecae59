//! FEDRAT with a slow-down before each check surface.
//!
//! `FEDRAT/fb,dm,fm` goes at fb, and at fm from the distance dm to the end of every motion along surfaces.
//! `FEDRAT/d1,f1` does so once, with d1 and f1. Every other FEDRAT is the basic feed and ends the first.

use aptc_cldata::{Arg, Position};
use aptc_geometry::Vec3;

/// What FEDRAT has said.
#[derive(Clone, Debug, Default)]
pub(crate) struct Feed {
    base: Vec<Arg>,
    always: Option<Slow>,
    once: Option<Slow>,
}

/// A slower feed near the end of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Slow {
    pub(crate) distance: f64,
    pub(crate) feed: f64,
}

impl Feed {
    /// Takes the arguments of a FEDRAT; those that go on to the post-processor, if any.
    pub(crate) fn take(&mut self, args: &[Arg]) -> Option<Vec<Arg>> {
        match *args {
            [Arg::Number(base), Arg::Number(distance), Arg::Number(feed)] => {
                self.base = vec![Arg::Number(base)];
                self.always = Some(Slow { distance, feed });
                Some(self.base.clone())
            }
            [Arg::Number(distance), Arg::Number(feed)] => {
                self.once = Some(Slow { distance, feed });
                None
            }
            _ => {
                self.base = args.to_vec();
                self.always = None;
                Some(args.to_vec())
            }
        }
    }

    /// The slow-down of the next motion along surfaces, and the feed after it.
    pub(crate) fn slow(&mut self) -> Option<(Slow, Vec<Arg>)> {
        let slow = self.once.take().or(self.always)?;
        (slow.distance > 0.0).then(|| (slow, self.base.clone()))
    }
}

/// Divides a path at a distance from its end, on a cut vector where need be.
pub(crate) fn divide(
    start: Vec3,
    points: &[Position],
    distance: f64,
) -> (Vec<Position>, Vec<Position>) {
    let mut left = distance;
    for i in (0..points.len()).rev() {
        let from = if i == 0 { start } else { points[i - 1].te };
        let length = (points[i].te - from).norm();
        if length < left {
            left -= length;
            continue;
        }
        let mut head = points[..i].to_vec();
        let share = left / length;
        if share < 1.0 - 1e-9 {
            let ta = if i == 0 { points[i].ta } else { points[i - 1].ta };
            let turned = points[i].ta + (ta - points[i].ta) * share;
            let te = points[i].te + (from - points[i].te) * share;
            head.push(Position { te, ta: turned / turned.norm() });
        }
        return (head, points[i..].to_vec());
    }
    (Vec::new(), points.to_vec())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f64) -> Position {
        Position::upright(Vec3::new(x, 0.0, 0.0))
    }

    #[test]
    fn a_path_is_divided_on_a_cut_vector_or_at_its_end() {
        let path = [at(4.0), at(10.0)];
        let (a, b) = divide(Vec3::zeros(), &path, 2.0);
        assert_eq!((a, b), (vec![at(4.0), at(8.0)], vec![at(10.0)]));
        let (a, b) = divide(Vec3::zeros(), &path, 6.0);
        assert_eq!((a, b), (vec![at(4.0)], vec![at(10.0)]));
        let (a, b) = divide(Vec3::zeros(), &path, 12.0);
        assert_eq!((a.len(), b.len()), (0, 2));
    }

    #[test]
    fn once_comes_before_always_and_a_plain_feed_ends_always() {
        let n = |x: f64| Arg::Number(x);
        let mut feed = Feed::default();
        assert_eq!(feed.take(&[n(30.0), n(0.5), n(5.0)]), Some(vec![n(30.0)]));
        assert_eq!(feed.take(&[n(0.2), n(3.0)]), None);
        assert_eq!(feed.slow().unwrap().0, Slow { distance: 0.2, feed: 3.0 });
        assert_eq!(feed.slow().unwrap().0, Slow { distance: 0.5, feed: 5.0 });
        assert_eq!(feed.take(&[n(20.0)]), Some(vec![n(20.0)]));
        assert!(feed.slow().is_none());
    }
}
