//! The cutter's profile: what is computed from the seven parameters once, and asked millions of times.
//!
//! ```text
//!   z
//!   |--------- 7 rim          The solid is the profile turned about z. It is convex: going from the tip
//!   |         /               to the rim the outward normal only turns left. Below and above the arc there
//!   |        / 6 upper line   may be an edge (3, 5) when the arc is not tangent to its line. A sharp
//!   |       / 5               corner is an arc of radius 0. A pointed or narrow tool has empty segments.
//!   |  c +  ) 4 arc
//!   |    __/ 3
//!   +--- 2 lower line
//!   1 tip -------- rho
//! ```

mod build;
pub(crate) mod distance;
mod rounded;
mod support;

pub use build::{BadCutter, CutterWarning};
pub use distance::Near;
pub use support::{Farthest, Support};

use crate::Vec2;

/// The segments of the profile in APT's order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Segment {
    /// 1: the tool end.
    Tip,
    /// 2: the lower line.
    LowerLine,
    /// 3: the edge between lower line and arc.
    LowerPoint,
    /// 4: the corner arc; of radius 0 the sharp corner.
    Arc,
    /// 5: the edge between arc and upper line.
    UpperPoint,
    /// 6: the upper line.
    UpperLine,
    /// 7: the edge of the top.
    Rim,
    /// The top face, which APT does not count.
    Top,
}

/// Profile of a convex cutter in the half plane rho >= 0 of its own frame, tool end at the origin.
#[derive(Clone, Copy, Debug)]
pub struct Profile {
    /// Bottom on the axis: (0, 0), or the height of a disk.
    pub(crate) tip: Vec2,
    /// Normal of the lower line.
    pub(crate) nl: Vec2,
    /// Lower line's end.
    pub(crate) pl: Vec2,
    /// Arc: centre, radius, unit normals of its ends.
    pub(crate) c: Vec2,
    pub(crate) r: f64,
    pub(crate) a0: Vec2,
    pub(crate) a1: Vec2,
    /// Upper line's beginning.
    pub(crate) pu: Vec2,
    /// Normal of the upper line.
    pub(crate) nu: Vec2,
    /// Edge of the top.
    pub(crate) rim: Vec2,
    /// Greatest distance from the axis.
    pub(crate) widest: f64,
    pub(crate) warnings: [Option<CutterWarning>; 2],
}

/// Number by number: what is derived goes through each point by an iterator, for each cut vector that is proved.
impl PartialEq for Profile {
    fn eq(&self, other: &Self) -> bool {
        let same = |of: fn(&Self) -> Vec2| {
            let (a, b) = (of(self), of(other));
            a.x == b.x && a.y == b.y
        };
        same(|p| p.tip)
            && same(|p| p.nl)
            && same(|p| p.pl)
            && same(|p| p.c)
            && same(|p| p.a0)
            && same(|p| p.a1)
            && same(|p| p.pu)
            && same(|p| p.nu)
            && same(|p| p.rim)
            && self.r == other.r
            && self.widest == other.widest
            && self.warnings == other.warnings
    }
}

impl Profile {
    /// A disk without thickness at `height` above the tool end.
    ///
    /// CUTTER/OPTION,1|2,radius,height: it stands for the cutter against the part or the drive surface.
    pub fn disk(radius: f64, height: f64) -> Result<Self, BadCutter> {
        if !(radius >= 0.0 && radius.is_finite() && height.is_finite()) {
            return Err(BadCutter::NotAShape);
        }
        let edge = Vec2::new(radius, height);
        let (down, out) = (Vec2::new(0.0, -1.0), Vec2::new(1.0, 0.0));
        Ok(Self {
            tip: Vec2::new(0.0, height),
            nl: down,
            pl: edge,
            c: edge,
            r: 0.0,
            a0: down,
            a1: out,
            pu: edge,
            nu: out,
            rim: edge,
            widest: radius,
            warnings: [None; 2],
        })
    }

    /// What is odd about the cutter and does no harm.
    pub fn warnings(&self) -> impl Iterator<Item = CutterWarning> {
        self.warnings.into_iter().flatten()
    }

    /// Greatest distance from the axis.
    pub fn widest(&self) -> f64 {
        self.widest
    }

    /// Greatest distance from the axis of what a segment belongs to: of end and corner below sides that lean outwards that of the
    /// upper joint, else that of all. Places that far from each other are two.
    pub fn half_width(&self, segment: Option<Segment>) -> f64 {
        let lower = matches!(segment, Some(Segment::LowerLine | Segment::Arc));
        let joint = self.pu.x.max(self.pl.x);
        if lower && joint > 0.0 { joint.min(self.widest) } else { self.widest }
    }

    /// Distance from the axis at which lower and upper line meet, half the diameter of CUTTER: `widest` but for sides that
    /// lean. The greatest distance where they do not meet.
    pub fn half_diameter(&self) -> f64 {
        let det = self.nl.perp(&self.nu);
        let rho = (self.nl.dot(&self.tip) * self.nu.y - self.nu.dot(&self.pu) * self.nl.y) / det;
        if rho.is_finite() && rho >= 0.0 { rho } else { self.widest }
    }

    /// Half width of the top.
    ///
    /// APT: `WIDTH`, which is the greatest only for sides that do not lean inwards.
    pub fn top_radius(&self) -> f64 {
        self.rim.x
    }

    /// Height of the top.
    pub fn height(&self) -> f64 {
        self.rim.y
    }

    /// Height of the lowest point, on the axis: 0 but for a disk.
    pub fn bottom(&self) -> f64 {
        self.tip.y
    }

    /// Radius of the corner arc, 0 for a sharp corner.
    pub fn corner_radius(&self) -> f64 {
        self.r
    }

    /// Centre of the corner arc: distance from the axis, height.
    pub fn corner(&self) -> [f64; 2] {
        [self.c.x, self.c.y]
    }

    /// The joints: lower line to arc, arc to upper line.
    pub fn joints(&self) -> [[f64; 2]; 2] {
        [[self.pl.x, self.pl.y], [self.pu.x, self.pu.y]]
    }

    /// Has the cutter a centre, so that every contact on the arc is as far from it as the radius?
    pub fn is_round(&self) -> bool {
        self.c.x == 0.0
    }

    /// Is the tool end a point of the cutter, and not the middle of a flat or round bottom?
    pub fn is_pointed(&self) -> bool {
        /// Sine of the slope of a bottom that counts as flat.
        const FLAT: f64 = 1e-6;
        !self.is_round() && self.support(FLAT, -1.0).point[0] <= FLAT * self.widest
    }

    /// Radius of the sphere about the tool end that holds the cutter.
    pub fn reach(&self) -> f64 {
        let arc = self.c.norm() + self.r;
        arc.max(self.rim.norm()).max(self.pl.norm()).max(self.pu.norm()).max(self.tip.y.abs())
    }

    /// Height of the lowest point at the distance `rho` from the axis; `None` beside the cutter.
    pub fn height_at(&self, rho: f64) -> Option<f64> {
        if !(0.0..=self.widest).contains(&rho) {
            return None;
        }
        let line = |a: Vec2, b: Vec2| {
            let s = if b.x > a.x { (rho - a.x) / (b.x - a.x) } else { 0.0 };
            a.y + s * (b.y - a.y)
        };
        let arc_end = if self.nu.y < 0.0 { self.pu.x } else { self.c.x + self.r };
        Some(if rho <= self.pl.x {
            line(self.tip, self.pl)
        } else if rho <= arc_end {
            let x = rho - self.c.x;
            self.c.y - (self.r * self.r - x * x).max(0.0).sqrt()
        } else {
            line(self.pu, self.rim)
        })
    }

    /// Half width at height `z`; `None` above the top and below the bottom.
    pub fn radius_at(&self, z: f64) -> Option<f64> {
        let line = |a: Vec2, b: Vec2| {
            let s = if b.y > a.y { (z - a.y) / (b.y - a.y) } else { 1.0 };
            a.x + s * (b.x - a.x)
        };
        if z < self.tip.y || z > self.rim.y {
            None
        } else if z <= self.pl.y {
            Some(line(self.tip, self.pl))
        } else if z >= self.pu.y {
            Some(line(self.pu, self.rim))
        } else {
            let up = z - self.c.y;
            Some(self.c.x + ((self.r - up) * (self.r + up)).max(0.0).sqrt())
        }
    }

    /// Is a normal direction one of the arc's?
    #[inline]
    pub(crate) fn in_arc(&self, n: Vec2) -> bool {
        // The sector is narrower than a half turn; an arc of one single normal needs the third test.
        cross(self.a0, n) >= 0.0 && cross(n, self.a1) >= 0.0 && n.dot(&(self.a0 + self.a1)) >= 0.0
    }
}

/// z component of the vector product.
#[inline]
pub(crate) fn cross(a: Vec2, b: Vec2) -> f64 {
    a.x * b.y - a.y * b.x
}
