//! How wide a strip a cutter clears down to a height, whatever its form: as far as it reaches across the path there.

use aptc_contact::{Convex, Swept, Tool};
use aptc_geometry::{Profile, Vec3, trig};

use crate::position::Position;

/// Rounds in which the end of a strip is closed in on, to this part of its greatest width.
const ROUNDS: u32 = 40;
const EXACT: f64 = 1e-9;
/// Below this share of its size a surface is flat.
const FLAT: f64 = 1e-9;
/// Part of the strip that a pass clears which is counted on, however far its chords may lie aside.
const LEFT: f64 = 0.5;

/// A cutter on its way over a place of the surface that it touches.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pass<'a> {
    pub(crate) profile: &'a Profile,
    pub(crate) at: &'a Position,
    /// Unit direction of the path, and of the step across along the surface.
    pub(crate) along: Vec3,
    pub(crate) side: Vec3,
    /// Curvature of the surface across the path, positive hollow.
    pub(crate) curvature: f64,
}

impl Pass<'_> {
    /// Width of the strip over which nothing stands higher than `high` over the surface; two passes as far apart leave that.
    ///
    /// A place is cleared when the cutter comes over it somewhere on the straight way through this one: what it clears is
    /// convex, so that all between is cleared too. A corner that leads with its edge leaves a saw's tooth, `h / sin cos` wide,
    /// where the formula of a round one has no radius.
    ///
    /// `aside`: the place as the tool takes it on a chord; the one pass may go by it where its neighbour does not.
    pub(crate) fn strip(&self, high: f64, aside: Option<&Position>) -> f64 {
        let far = 2.0 * self.profile.widest();
        let reach = |p: &Position, most: [f64; 2]| {
            let off = self.off(p, high);
            let from = self.aside(p).into_iter().find(|s| off(*s) <= 0.0).unwrap_or(0.0);
            [(-1.0, most[0]), (1.0, most[1])].map(|(sense, most)| {
                ending(|s| off(sense * s), [(sense * from).min(most), most], EXACT * far)
            })
        };
        let own = reach(self.at, [far; 2]);
        let strip = own[0] + own[1];
        let narrow = aside.map_or(strip, |p| reach(p, own).iter().sum());
        // Few chords lie aside by all that they may, and where the strip is no wider the passes have to be that close all the same.
        narrow.max(LEFT * strip).min(far)
    }

    /// How far across what touches of the tool may lie at a place.
    fn aside(&self, p: &Position) -> [f64; 3] {
        let lowest = |p: &Position| {
            let tool = Tool { profile: self.profile, te: p.te, ta: p.ta };
            tool.support(-self.at.normal).point
        };
        [lowest(p) - lowest(self.at), p.te - self.at.te, Vec3::zeros()].map(|m| m.dot(&self.side))
    }

    /// How far the place so far across, raised by a height, is off the tool that goes straight through a place.
    fn off(&self, p: &Position, high: f64) -> impl Fn(f64) -> f64 {
        let way = self.along * self.profile.widest();
        let tool = Tool { profile: self.profile, te: p.te - way, ta: p.ta };
        let swept = Swept { tool, by: way * 2.0 };
        move |s| swept.near(self.over(s, high)).0
    }

    /// The place that height over the surface, so far across from where it is touched along its circle of curvature.
    fn over(&self, s: f64, high: f64) -> Vec3 {
        let (contact, n, k) = (self.at.contact, self.at.normal, self.curvature);
        if k.abs() * self.profile.reach() < FLAT {
            return contact + self.side * s + n * high;
        }
        let (sin, cos) = trig::sin_cos(s * k);
        contact + n / k + (self.side * sin - n * cos) * (1.0 / k - high)
    }
}

/// How far from one place on, and no farther than another, a tool takes what is so far off it; up to `exact` less.
fn ending(off: impl Fn(f64) -> f64, [mut near, mut far]: [f64; 2], exact: f64) -> f64 {
    let (mut low, mut high) = (off(near), off(far));
    if high <= 0.0 || low > 0.0 {
        return if high <= 0.0 { far } else { near };
    }
    // Regula falsi; the end that stays twice counts half.
    let mut stays = 0.0;
    for _ in 0..ROUNDS {
        if far - near <= exact {
            break;
        }
        let part = low / (low - high);
        let part = if part > 0.0 && part < 1.0 { part } else { 0.5 };
        let middle = near + (far - near) * part;
        let now = off(middle);
        if now <= 0.0 {
            (near, low) = (middle, now);
            high *= if stays > 0.0 { 0.5 } else { 1.0 };
            stays = 1.0;
        } else {
            (far, high) = (middle, now);
            low *= if stays < 0.0 { 0.5 } else { 1.0 };
            stays = -1.0;
        }
    }
    near
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stepover::scallop_width;
    use aptc_geometry::{Cutter, Segment, Transform};

    fn strip(cutter: &Cutter, lean: f64, curvature: f64, high: f64) -> f64 {
        beside(cutter, lean, curvature, high, |_| None)
    }

    fn beside(
        cutter: &Cutter,
        lean: f64,
        curvature: f64,
        high: f64,
        aside: impl Fn(Position) -> Option<Position>,
    ) -> f64 {
        let profile = Profile::new(cutter).unwrap();
        let ta = Transform::rotation(Vec3::x(), lean).vector(Vec3::z());
        let support = Tool { profile: &profile, te: Vec3::zeros(), ta }.support(-Vec3::z());
        let at = Position {
            te: -support.point,
            ta,
            part_uv: [0.0; 2],
            contact: Vec3::zeros(),
            normal: Vec3::z(),
            shift: 0.0,
            drive_uv: [0.0; 2],
            segment: Segment::Arc,
            lift: Vec3::zeros(),
        };
        let (along, side) = (Vec3::x(), Vec3::y());
        Pass { profile: &profile, at: &at, along, side, curvature }.strip(high, aside(at).as_ref())
    }

    #[test]
    fn a_ball_clears_what_the_formula_says() {
        for (lean, k) in [(0.0, 0.0), (20.0, 0.02), (-10.0, -0.04)] {
            let width = strip(&Cutter::mill(10.0, 5.0, 30.0), lean, k, 0.05);
            assert!((width - scallop_width(5.0, 0.05, k)).abs() < 1e-5, "{lean} {k} {width}");
        }
    }

    #[test]
    fn an_edge_leaves_the_tooth_of_a_saw() {
        let (h, lean) = (0.1, 8.0);
        let (s, c) = (trig::sin_deg(lean), trig::cos_deg(lean));
        for lean in [lean, -lean] {
            let width = strip(&Cutter::mill(10.0, 0.0, 30.0), lean, 0.0, h);
            assert!((width - h / (s * c)).abs() < 1e-5, "{width}");
        }
        // Not wider than the cutter.
        let width = strip(&Cutter::mill(10.0, 0.0, 30.0), 0.05, 0.0, h);
        assert!(width <= 10.0 && width > 9.99, "{width}");
    }

    /// Where the chords of one pass lie aside of its line and those of the next do not, so much less is cleared between them; where
    /// the tool leans otherwise on them the tooth of a saw is another.
    #[test]
    fn a_tool_aside_of_its_line_clears_less() {
        let cutter = Cutter::mill(10.0, 0.0, 30.0);
        let (h, lean) = (0.1, 8.0);
        let whole = strip(&cutter, lean, 0.0, h);
        for off in [0.03, -0.03] {
            let moved = |p: Position| Some(Position { te: p.te + Vec3::y() * off, ..p });
            let width = beside(&cutter, lean, 0.0, h, moved);
            assert!((width - (whole - 0.03)).abs() < 1e-6, "{width}");
        }
        let steeper = Transform::rotation(Vec3::x(), 0.2);
        let turned = |p: Position| {
            let te = p.contact + steeper.vector(p.te - p.contact);
            Some(Position { te, ta: steeper.vector(p.ta), ..p })
        };
        // The gentle side of the steeper tooth, and the steep side of the other.
        let tan = |deg: f64| trig::sin_deg(deg) / trig::cos_deg(deg);
        let width = beside(&cutter, lean, 0.0, h, turned);
        assert!((width - (h / tan(lean + 0.2) + h * tan(lean))).abs() < 1e-6, "{width} {whole}");
    }
}
