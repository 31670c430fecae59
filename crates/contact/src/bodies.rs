//! Convex bodies that patches are held against: a tool, and a tool on its way.

use aptc_geometry::{Tool, Vec3};

use crate::under::{Cell, Low, under};

/// Value, slope and how fast that turns: see [`Convex::near`].
pub(crate) type Near = (f64, Vec3, f64);

/// A convex body with its signed distance, negative inside, and a gradient of it.
pub trait Convex {
    /// A value `d` at `q` and a slope `n`, `|n| <= 1`, such that no point `p` is nearer to the body than
    /// `d + n . (p - q)`, but for [`Convex::slack`]; and how fast the slope turns across itself, as a guess.
    fn near(&self, q: Vec3) -> Near;

    /// As `near`, for who only asks whether the value reaches `enough`: less exact, and faster, where it does.
    fn near_enough(&self, q: Vec3, _enough: f64) -> Near {
        self.near(q)
    }

    /// As `near`, for who asks whether the value, less what `lost` says of the slope, reaches `aim`: less exact, and faster, once it
    /// does or is sure not to. With what the distance at `q` is at most.
    fn near_until(&self, q: Vec3, _aim: f64, _lost: impl Fn(Vec3) -> f64) -> (Near, f64) {
        let near = self.near(q);
        (near, near.0)
    }

    /// Is the body certain to be farther than `reach` from `q`? As fast as can be: a no says nothing.
    fn misses(&self, q: Vec3, reach: f64) -> bool;

    /// The distances of a piece, but for [`Convex::slack`], the bound as sharp as need be to reach `aim`; `None` where there
    /// are only tangents.
    fn under(&self, cell: &Cell, aim: f64) -> Option<Low>;

    /// By how much distances of points within `radius` of `q` may differ from what `near` says at `q`.
    fn slack(&self, _q: Vec3, _radius: f64) -> f64 {
        0.0
    }

    /// The same of the points of a piece about its middle, and by how much more from what it says at another of them.
    fn slacks(&self, _cell: &Cell) -> [f64; 2] {
        [0.0; 2]
    }
}

impl Convex for Tool<'_> {
    #[inline]
    fn near(&self, q: Vec3) -> (f64, Vec3, f64) {
        let n = Tool::near(self, q);
        (n.distance, n.normal, n.shape.k[0].max(n.shape.k[2]))
    }

    #[inline]
    fn misses(&self, q: Vec3, reach: f64) -> bool {
        outside(self, Vec3::zeros(), q, reach)
    }

    #[inline]
    fn under(&self, cell: &Cell, aim: f64) -> Option<Low> {
        under(self, Vec3::zeros(), cell, aim)
    }
}

/// Is a place farther than `reach` from a cylinder that holds the tool on its way by `by`?
#[inline]
fn outside(tool: &Tool<'_>, by: Vec3, q: Vec3, reach: f64) -> bool {
    let half = by * 0.5;
    let w = q - tool.te - half;
    let z = w.dot(&tool.ta);
    let up = half.dot(&tool.ta).abs() + reach;
    let wide = tool.profile.widest() + half.norm() + reach;
    let square = (w - tool.ta * z).norm_squared();
    z < tool.profile.bottom() - up
        || z > tool.profile.height() + up
        || wide < 0.0
        || square > wide * wide
}

/// A tool with everything that it passes on the way by `by`, its axis unchanged.
#[derive(Clone, Copy, Debug)]
pub struct Swept<'a> {
    /// Where it starts.
    pub tool: Tool<'a>,
    /// The cut vector.
    pub by: Vec3,
}

/// Rounds that bring the tangents at both sides of the nearest place together.
const ROUNDS: usize = 80;
/// Part of the tool's reach to which the least distance along a way is found; the answer is below it.
const CLOSE: f64 = 1e-12;

impl Convex for Swept<'_> {
    fn near(&self, q: Vec3) -> Near {
        self.near_enough(q, f64::INFINITY)
    }

    fn near_enough(&self, q: Vec3, enough: f64) -> Near {
        self.closed_in(q, |cut, _, _| cut >= enough).0
    }

    fn near_until(&self, q: Vec3, aim: f64, lost: impl Fn(Vec3) -> f64) -> (Near, f64) {
        self.closed_in(q, |cut, [a, b], most| {
            let lost = lost(mixed(a, b));
            cut - lost >= aim || most - lost < aim
        })
    }

    #[inline]
    fn misses(&self, q: Vec3, reach: f64) -> bool {
        outside(&self.tool, self.by, q, reach)
    }

    #[inline]
    fn under(&self, cell: &Cell, aim: f64) -> Option<Low> {
        under(&self.tool, self.by, cell, aim)
    }
}

impl Swept<'_> {
    /// What is near a place, and what its distance is at most, by rounds that are over when `told` says so of what the distance is at
    /// least, of the places on both sides of the nearest, and of what it is at most.
    ///
    /// The distance is convex along the way: tangents at two places with slopes of both signs meet below its
    /// least value, and so do the planes through them, mixed until they do not rise along the way.
    fn closed_in(&self, q: Vec3, told: impl Fn(f64, [&Place; 2], f64) -> bool) -> (Near, f64) {
        let at = |t: f64| {
            let (d, n, bend) = Convex::near(&self.tool, q - self.by * t);
            (t, d, n, -n.dot(&self.by), bend)
        };
        let mut low = at(0.0);
        if low.3 >= 0.0 || self.by == Vec3::zeros() {
            return ((low.1, low.2, low.4), low.1);
        }
        let mut high = at(1.0);
        if high.3 <= 0.0 {
            return ((high.1, high.2, high.4), high.1);
        }
        let mut most = low.1.min(high.1);
        let close = CLOSE * (self.tool.profile.reach() + self.by.norm());
        // Where the tool end, or the middle of a ball, passes is a good first guess.
        let bend = high.3 - low.3;
        let mut t = -low.3 / bend;
        // What the slopes at the ends count, and which end stayed in the last round.
        let (mut counts, mut stays) = ([1.0_f64; 2], 0_i32);
        for _ in 0..ROUNDS {
            let cut = meet(&low, &high);
            if told(cut, [&low, &high], most) {
                break;
            }
            let here = at(t);
            most = most.min(here.1);
            if here.1 - cut <= close || high.0 - low.0 <= 1e-14 {
                break;
            }
            if here.3 == 0.0 {
                return ((here.1, here.2, here.4), here.1);
            }
            // Illinois: an end that stays twice counts half, three times a quarter and so on, so that both close in: beside
            // an edge of the tool the slopes of the two differ by orders of magnitude.
            if here.3 < 0.0 {
                low = here;
                counts = [1.0, if stays > 0 { 0.5 * counts[1] } else { 1.0 }];
                stays = 1;
            } else {
                high = here;
                counts = [if stays < 0 { 0.5 * counts[0] } else { 1.0 }, 1.0];
                stays = -1;
            }
            let (a, b) = (counts[0] * low.3, counts[1] * high.3);
            let next = low.0 + (high.0 - low.0) * (-a / (b - a));
            let margin = 1e-3 * (high.0 - low.0);
            t = next.clamp(low.0 + margin, high.0 - margin);
        }
        ((meet(&low, &high), mixed(&low, &high), low.4), most)
    }
}

/// A place of the way with value, gradient, slope along the way and bend.
type Place = (f64, f64, Vec3, f64, f64);

/// The slope of the plane that is mixed of those at two places and does not rise along the way.
fn mixed(a: &Place, b: &Place) -> Vec3 {
    let share = -a.3 / (b.3 - a.3);
    a.2 * (1.0 - share) + b.2 * share
}

/// Value at which the tangents at two places meet.
fn meet(a: &Place, b: &Place) -> f64 {
    let share = -a.3 / (b.3 - a.3);
    (1.0 - share) * (a.1 - a.3 * a.0) + share * (b.1 - b.3 * b.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::{Cutter, Profile, trig};

    fn places() -> impl Iterator<Item = Vec3> {
        (0..60).map(|k| {
            let f = f64::from(k);
            Vec3::new(15.0 * trig::sin(f), 12.0 * trig::cos(1.3 * f), 10.0 * trig::sin(0.7 * f))
        })
    }

    #[test]
    fn a_way_is_the_union_of_its_places() {
        for cutter in [Cutter::mill(12.0, 2.0, 40.0), Cutter::mill(9.0, 0.0, 6.0)] {
            let profile = Profile::new(&cutter).unwrap();
            let tool = Tool { profile: &profile, te: Vec3::new(1.0, 2.0, 3.0), ta: Vec3::z() };
            let by = Vec3::new(7.0, -3.0, 1.5);
            let swept = Swept { tool, by };
            let exact = |q: Vec3| {
                (0..=4000)
                    .map(|i| tool.at(tool.te + by * (f64::from(i) / 4000.0)).distance(q))
                    .fold(f64::INFINITY, f64::min)
            };
            let least: Vec<f64> = places().map(exact).collect();
            for (k, q) in places().enumerate() {
                let (d, n, _) = swept.near(q);
                assert!(d <= least[k] + 1e-12 && d > least[k] - 2e-3, "{k} {d} {}", least[k]);
                assert!(n.norm() < 1.0 + 1e-12);
                // Who asks for less gets a value that is below, and enough where that much is there.
                for enough in [0.5 * d, d - 1.0, d - 1e-3] {
                    let (e, m, _) = swept.near_enough(q, enough);
                    assert!(e <= d + 1e-12 && (e >= enough || d < enough + 1e-3), "{k} {e} {d}");
                    assert!(places().zip(&least).all(|(p, l)| e + m.dot(&(p - q)) <= l + 1e-9));
                }
                // So does who asks for a value less something of the slope, and is told no sooner.
                for aim in [d - 4.0, d - 1.0, d - 0.5, d] {
                    let lost = |n: Vec3| 1.0 + n.x.abs();
                    let ((e, m, _), most) = swept.near_until(q, aim, lost);
                    assert!(e <= d + 1e-12 && most >= d - 1e-12);
                    let told = e - lost(m) >= aim || most - lost(m) < aim;
                    assert!(told || most - e <= 1e-9, "{k} {e} {d} {most}");
                    assert!(places().zip(&least).all(|(p, l)| e + m.dot(&(p - q)) <= l + 1e-9));
                }
                // The plane lies below the distance everywhere, also where the tool has edges.
                for (j, p) in places().enumerate() {
                    assert!(d + n.dot(&(p - q)) <= least[j] + 1e-9, "{k} {j}");
                }
            }
        }
    }

    /// The slope of the distance is next to nothing below the flat and some thousand times that behind the corner.
    #[test]
    fn beside_the_flat_the_least_distance_is_found() {
        let profile = Profile::new(&Cutter::mill(12.0, 2.0, 127.0)).unwrap();
        let tool = Tool { profile: &profile, te: Vec3::zeros(), ta: Vec3::z() };
        let by = Vec3::new(10.834, 0.0, -7.48e-3);
        let swept = Swept { tool, by };
        for k in 0..40 {
            let f = f64::from(k) / 40.0;
            let q = Vec3::new(1.0 + 6.0 * f, 3.9 * trig::sin(5.0 * f), 4e-3);
            // Convex along the way.
            let at = |t: f64| tool.at(by * t).distance(q);
            let [mut low, mut high] = [0.0, 1.0];
            for _ in 0..200 {
                let third = (high - low) / 3.0;
                if at(low + third) > at(high - third) { low += third } else { high -= third }
            }
            let least = at(0.5 * (low + high));
            let (d, _, _) = swept.near(q);
            assert!(d <= least + 1e-12, "{k}: {d} {least}");
            assert!(d > least - 1.01 * CLOSE * (profile.reach() + by.norm()), "{k}: {d} {least}");
        }
    }
}
