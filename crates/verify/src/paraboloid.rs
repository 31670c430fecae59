//! The corner of a tool that does not turn, held in a paraboloid on its way.
//!
//! With the unit direction m from the tool to the surface, `p` the middle of its corner there and w square to m, a point x is out
//! of the tool made smaller by d when `(m + w) . x` is more than the support of that, for any one w. Where all `m + w` face the
//! corner the support is no more than `(m + w) . p + R + w . C w / 2`, with R the radius of the corner less d. C is R, and around
//! the axis `R + rho / l` with the radius rho of the corner's circle, where no `m + w` leans from the axis by a sine less than l: so
//! each piece has a paraboloid of its own. x is out of it where `m . (x - p) - R + y . C^-1 y / 2 >= 0`, y being what
//! x is beside p. By planes alone a piece next to the tool must be cut until what it bends is of no account; against this a
//! piece of which that function is convex is shown by its least place.
//!
//! A surface no point of which is in the tool made smaller by d has no point of a rounded tool deeper in it than d: that is
//! within d of the smaller one.

use aptc_geometry::Vec3;

use crate::each::{three, two};
use crate::sheet::{Jet, Patch, Sheet, Spot, Tile, fall};
use crate::solid::unit_or;
use crate::sweep::Sweep;
use crate::tool::same;

/// Looks for the place next to the tool, and for the least of a piece.
const LOOKS: u32 = 10;
const STEPS: u32 = 5;
/// Share of the corner's radius that is a last step to the place: what is left after it is that of its square.
const FOUND: f64 = 3e-3;
/// Share of the corner's radius below which a piece is not cut for this alone.
const SMALL: f64 = 0.02;
/// What is convex in the middle of a piece by as much is worth to be cut until all of it is.
const TWICE: f64 = 2.0;
/// Cosine between the way and the direction to the surface from which on the tool comes to it, or leaves it.
const COMES: f64 = 0.1;
/// Sine by which a direction may lean along the way and be square to it.
const SQUARE: f64 = 1e-12;
/// Sine between two directions that are as good for a paraboloid: what the second shows less is of its square.
const ALIKE: f64 = 1e-5;
/// Share of the tool's height by which it may be made smaller.
const LITTLE: f64 = 0.1;

/// Where on its way the tool is met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum At {
    Start,
    End,
    /// Between both, square to the way.
    Between,
}

/// The corner where it is met in the direction m: what holds it there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Paraboloid {
    pub(crate) at: At,
    pub(crate) m: Vec3,
    /// Unit direction away from the axis, and the sine of m to that.
    radial: Vec3,
    lean: f64,
    /// Middle of the corner there.
    p: Vec3,
    /// Radius of the corner, and of the circle of its middle about the axis.
    radius: f64,
    rho: f64,
    /// Unit directions square to m, and the squares of how far they run around the axis.
    across: [(Vec3, f64); 2],
}

/// A paraboloid that holds the tool for directions that lean no less than told.
#[derive(Clone, Copy, Debug)]
struct Bowl {
    m: Vec3,
    p: Vec3,
    radius: f64,
    /// Directions square to m, and what 1 is over C along them.
    across: [(Vec3, f64); 2],
}

/// The place of the surface next to the tool, with the paraboloid about it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    pub(crate) about: Paraboloid,
    pub(crate) spot: Spot,
    /// What was read of the surface a last little step before it.
    read: Read,
}

/// A place of the surface with its derivatives.
#[derive(Clone, Copy, Debug)]
struct Read {
    spot: Spot,
    jet: Jet,
    bend: [Vec3; 3],
}

/// What is seen of a piece.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Seen {
    /// It is no nearer than what is enough, by as much; about the direction from the tool to it, and along that what all of it is beyond
    /// at least, where that is told closely.
    Clear(f64, Vec3, Option<f64>),
    /// The same by `low`, if what lies beside it on the surface is no nearer; by `last` at the end of the way in any case, and about
    /// the direction there.
    Spanned { low: f64, last: f64, m: Vec3 },
    /// Smaller it may be: the parameter along which it is best cut.
    Large(usize),
    /// Not by this.
    Near,
}

/// The corner of the tool, and how much of it must stay clear of the surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Corner<'a> {
    sweep: &'a Sweep<'a>,
    way: Vec3,
    /// Distance of the corner's middle from the axis, its height, and R.
    pub(crate) rho: f64,
    high: f64,
    pub(crate) radius: f64,
    /// Cosine of the greatest angle from straight down at which it is faced.
    cos: f64,
    /// Nothing higher counts, where the tool is made smaller.
    top: f64,
    /// By how much it is made larger.
    least: f64,
}

impl<'a> Corner<'a> {
    /// The corner of a tool, the distance from which is to be `least` at least; `None` where that has no paraboloid.
    pub(crate) fn new(sweep: &'a Sweep<'a>, least: f64) -> Option<Self> {
        if sweep.turn != 0.0 {
            return None;
        }
        let ((profile, up), (radius, top)) = (sweep.tool.solid()?, sweep.tool.rounding()?);
        let [rho, high] = profile.corner();
        let cos = (high - profile.joints()[1][1]) / radius;
        // Made smaller and rounded again it lacks but what is at the edge of its top.
        let little = radius + least > 0.0 && -least <= LITTLE * profile.height();
        let top = if least < 0.0 { top + least } else { f64::INFINITY };
        little.then(|| Self {
            sweep,
            way: sweep.b.te - sweep.a.te,
            rho,
            high: up + high,
            radius: radius + least,
            cos: cos.max(0.0),
            top,
            least,
        })
    }

    /// The paraboloid about the place of the surface next to the tool that a way down from `spot` leads to, where the direction to
    /// it is about `m`.
    pub(crate) fn find(&self, sheet: &Sheet, spot: Spot, at: At, m: Vec3) -> Option<Place> {
        let stands = same(self.way, Vec3::zeros());
        let mut at = if stands { At::Start } else { at };
        let mut spot = sheet.settle(spot);
        let mut about = self.about(at, m)?;
        for _ in 0..LOOKS {
            let (jet, bend) = sheet.bent(&spot);
            let read = Read { spot, jet, bend };
            let mut bowl = about.bowl(about.lean);
            let mut slope = bowl.value(jet.p).1;
            if !about.is_towards(slope) {
                // Where the tool is met from here.
                about = self.about(at, slope.try_normalize(0.0)?)?;
                bowl = about.bowl(about.lean);
                slope = bowl.value(jet.p).1;
            }
            let (along, share) = (about.m.dot(&self.way), (jet.p - about.p).dot(&self.way));
            let met = match at {
                At::Start if along > 0.0 => At::Between,
                At::End if along < 0.0 => At::Between,
                At::Between if share < 0.0 => At::Start,
                At::Between if share > self.way.norm_squared() => At::End,
                at => at,
            };
            let g = two(jet.d, |d| slope.dot(&d));
            let [a, b, c] = bowl.second(slope, jet.d, bend);
            let det = a * c - b * b;
            if !(a > 0.0 && det > 0.0) {
                return None;
            }
            let step = [-(c * g[0] - b * g[1]) / det, -(a * g[1] - b * g[0]) / det];
            spot = sheet.settle(Spot { at: [spot.at[0] + step[0], spot.at[1] + step[1]], ..spot });
            let by = jet.d[0] * step[0] + jet.d[1] * step[1];
            if met == at && by.norm() <= FOUND * self.radius {
                let slope = bowl.value(jet.p + by).1;
                if !about.is_towards(slope) {
                    about = self.about(at, slope.try_normalize(0.0)?)?;
                }
                // In a hollow along its way the tool is met at both ends, and no piece between them is shown by any.
                let bends = || {
                    let passing = self.about(At::Between, about.m)?;
                    let passing = passing.bowl(passing.lean);
                    let [a, b, c] = passing.second(passing.value(jet.p).1, jet.d, bend);
                    (a > 0.0 && a * c > b * b).then_some(())
                };
                let comes = along.abs() > COMES * self.way.norm();
                if !(stands || comes || at == At::Between) {
                    bends()?;
                }
                return Some(Place { about, spot, read });
            }
            if met != at {
                at = met;
                about = self.about(at, about.m)?;
            }
        }
        None
    }

    /// The same of the tool where it stands.
    pub(crate) fn standing(&self, sweep: &'a Sweep<'a>) -> Self {
        Self { sweep, way: Vec3::zeros(), ..*self }
    }

    /// Is none of a piece as high as what does not count, wherever on its way?
    pub(crate) fn is_below_top(&self, tile: &Tile) -> bool {
        let ta = self.sweep.a.ta;
        let above = |te: Vec3| (tile.c - te).dot(&ta);
        above(self.sweep.a.te).max(above(self.sweep.b.te)) + tile.radius() <= self.top
    }

    /// Is it the corner, or what is below it, that faces the unit direction n and all that differ from it by as much?
    pub(crate) fn turns_to(&self, n: Vec3, by: f64) -> bool {
        -n.dot(&self.sweep.a.ta) - by >= self.cos
    }

    /// By how much more than asked a plane parts a piece from the tool at the start of its way.
    pub(crate) fn parted(&self, tile: &Tile) -> (f64, Vec3) {
        let (distance, m) = self.sweep.tool.near(&self.sweep.a, tile.c);
        let first = distance - tile.dip(m) - self.least;
        if first >= 0.0 || self.rho == 0.0 {
            return (first, m);
        }
        let n = if tile.n.dot(&m) < 0.0 { -tile.n } else { tile.n };
        let between = unit_or(m + n, m);
        let pose = &self.sweep.a;
        let low = between.dot(&tile.c) - self.sweep.tool.height(pose, between);
        let second = low - tile.dip(between) - self.least;
        if second > first { (second, between) } else { (first, m) }
    }

    /// How much more than the corner alone the tool is bent along `on` where it faces n, square to that.
    pub(crate) fn ring(&self, n: Vec3, on: Vec3) -> f64 {
        let ta = self.sweep.a.ta;
        let out = n - ta * n.dot(&ta);
        let lean = out.norm();
        let around = ta.cross(&out).dot(&on) / lean;
        if self.rho > 0.0 { self.rho * around * around / lean } else { 0.0 }
    }

    /// The radius of the tool's own corner.
    pub(crate) fn own_radius(&self) -> f64 {
        self.radius - self.least
    }

    /// The direction from the tool to a piece.
    pub(crate) fn met(&self, tile: &Tile) -> Vec3 {
        self.sweep.meet(tile.c).m
    }

    /// The same from a piece.
    pub(crate) fn find_beside(&self, sheet: &Sheet, patch: &Patch, tile: &Tile) -> Option<Place> {
        let meeting = self.sweep.meet(tile.c);
        let at = match meeting.t {
            t if t <= 0.0 => At::Start,
            t if t >= 1.0 => At::End,
            _ => At::Between,
        };
        self.find(sheet, patch.spot(), at, meeting.m)
    }

    fn about(&self, at: At, m: Vec3) -> Option<Paraboloid> {
        let m = match at {
            At::Between => unit_or(m - self.way * (m.dot(&self.way) / self.way.norm_squared()), m),
            At::Start | At::End => m,
        };
        let ta = self.sweep.a.ta;
        let side = m - ta * m.dot(&ta);
        let lean = side.norm();
        let radial = side.try_normalize(1e-6).or_else(|| (self.rho == 0.0).then(Vec3::zeros))?;
        let te = match at {
            At::Start | At::Between => self.sweep.a.te,
            At::End => self.sweep.b.te,
        };
        let p = te + radial * self.rho + ta * self.high;
        let around = ta.cross(&radial);
        let across = match at {
            At::Between => {
                let n = unit_or(m.cross(&self.way), around);
                let by = around.dot(&n);
                [(n, by * by), (Vec3::zeros(), 0.0)]
            }
            At::Start | At::End => {
                let first =
                    if radial == Vec3::zeros() { crate::solid::any_across(m) } else { around };
                [(first, 1.0), (m.cross(&first), 0.0)]
            }
        };
        let (radius, rho) = (self.radius, self.rho);
        Some(Paraboloid { at, m, radial, lean, p, radius, rho, across })
    }

    /// What the paraboloid shows of a piece.
    pub(crate) fn see(&self, place: &Place, sheet: &Sheet, patch: &Patch, tile: &Tile) -> Seen {
        let held = &place.about;
        let spread = |n: Vec3, i: usize| n.dot(&tile.side[i]).abs() + tile.stray[i];
        let cut = |by: [f64; 2]| match by[0].max(by[1]) > SMALL * self.radius {
            true => Seen::Large(usize::from(by[1] > by[0])),
            false => Seen::Near,
        };
        let from = tile.c - held.p;
        let beside = two(held.across, |(n, _)| {
            let (middle, by) = (n.dot(&from), spread(n, 0) + spread(n, 1));
            [middle - by, middle + by]
        });
        // What cannot be shown of a piece that is too wide for the paraboloid may be shown of its halves, if its middle faces that.
        let smaller = || {
            let middle = two(beside, |[a, b]| [0.5 * (a + b); 2]);
            let inside = self.wide(held, middle).is_some_and(|(.., share)| share >= 1.0);
            let across = |i| held.across.iter().map(|(n, _)| spread(*n, i)).sum::<f64>();
            if inside { cut([across(0), across(1)]) } else { Seen::Near }
        };
        let Some((bowl, lean, share)) = self.wide(held, beside) else { return smaller() };
        let whole = share >= 1.0;
        let ta = self.sweep.a.ta;
        let te = [self.sweep.a.te, self.sweep.b.te];
        let above = two(te, |te| (tile.c - te).dot(&ta));
        if above[0].max(above[1]) + tile.radius() > self.top {
            let inside = above[0].max(above[1]) < self.top;
            return if inside { cut(two([0, 1], |i| spread(ta, i))) } else { Seen::Near };
        }
        let clear = |value: f64, slope: Vec3, level: Option<f64>| {
            let [x, y] = two(lean, |[a, b]| a.abs().max(b.abs()));
            let length = slope.norm();
            let low = value / (1.0 + x * x + y * y).sqrt();
            Seen::Clear(low, slope / length, level.map(|level| level / length))
        };
        let (value, slope) = bowl.value(tile.c);
        let g = two(tile.side, |d| slope.dot(&d));
        let [uu, uv, vv] = bowl.second(slope, tile.side, tile.bend);
        let bent = Bent::new([uu, uv, vv], bowl.vary(tile, slope.norm()));
        let least = value - fall(g[0], bent.u - bent.uv) - fall(g[1], bent.v - bent.uv);
        if least >= 0.0 {
            return clear(least, slope, None);
        }
        if !bent.is_convex() && !whole {
            return smaller();
        }
        if !bent.is_convex() {
            // The halves of a piece may be convex that is so in its middle.
            let convex = uu > 0.0 && uu * vv > TWICE * uv * uv;
            let size = two([0, 1], |i| tile.side[i].norm() + tile.stray[i]);
            return if convex { cut(size) } else { Seen::Near };
        }
        // Convex all over the piece: it is above its tangent plane at any place of it, by what bends it at least.
        let straight = |g: [f64; 2], s: [f64; 2]| {
            let by = |i: usize| if g[i] > 0.0 { g[i] * (1.0 + s[i]) } else { g[i] * (s[i] - 1.0) };
            by(0) + by(1)
        };
        let lost = |g: [f64; 2], s: [f64; 2]| straight(g, s).min(bent.deepest(g));
        // Of a piece that bends away from a plane that is so too.
        let level = |slope: Vec3, p: Vec3, g: [f64; 2], s: [f64; 2]| {
            let second = three([0, 1, 2], |i| slope.dot(&tile.bend[i]));
            let plane = Bent::new(second, three(tile.vary, |vary| slope.norm() * vary));
            plane.is_convex().then(|| slope.dot(&p) - straight(g, s))
        };
        let known = |spot: &Spot| {
            let at = || two([0, 1], |i| (spot.at[i] - patch.at[i]) / patch.half[i]);
            patch.holds(spot).then(at)
        };
        let [hu, hv] = patch.half;
        let look = |s: [f64; 2], jet: &Jet, bend: &[Vec3; 3]| {
            let (value, slope) = bowl.value(jet.p);
            let side = two([0, 1], |i| jet.d[i] * patch.half[i]);
            let bend = [bend[0] * (hu * hu), bend[1] * (hu * hv), bend[2] * (hv * hv)];
            let g = two(side, |d| slope.dot(&d));
            (value, slope, value - lost(g, s), g, bowl.second(slope, side, bend))
        };
        let mut now = (g, [uu, uv, vv]);
        let mut s = [0.0; 2];
        if let Some(at) = known(&place.read.spot) {
            let Read { jet, bend, .. } = &place.read;
            let (value, slope, least, ..) = look(at, jet, bend);
            if least >= 0.0 {
                return clear(least, slope, None);
            }
            if value < 0.0 {
                return if whole { Seen::Near } else { smaller() };
            }
        }
        for round in 0..STEPS {
            // The place next to the tool is the least of the piece it lies in.
            let found = if round == 0 { known(&place.spot) } else { None };
            s = found.unwrap_or_else(|| step(s, now.0, now.1));
            let at = two([0, 1], |i| patch.at[i] + s[i] * patch.half[i]);
            let (jet, bend) = sheet.bent(&Spot { chart: patch.chart, at });
            let (value, slope, least, g, second) = look(s, &jet, &bend);
            if least >= 0.0 {
                return clear(least, slope, level(slope, jet.p, g, s));
            }
            if value < 0.0 {
                break;
            }
            now = (g, second);
        }
        if whole { Seen::Near } else { smaller() }
    }

    /// What holds the corner for all that is so far beside p along both directions, the range of `w` by each, and the share of
    /// what bends the paraboloid that is left: any C that is greater than the corner's holds it as well, and asks for less of `w`, so
    /// that all `m + w` face the corner and the end of the way that is held. `None` where m itself does not.
    fn wide(&self, held: &Paraboloid, beside: [[f64; 2]; 2]) -> Option<(Bowl, [[f64; 2]; 2], f64)> {
        /// Share of the lean of m that is left at least.
        const KEPT: f64 = 0.5;
        /// Part of what is allowed that is used, for rounding.
        const USED: f64 = 0.999;
        let (m, ta, way) = (held.m, self.sweep.a.ta, self.way);
        let (along, down) = (m.dot(&way), -m.dot(&ta));
        // Which way along the way no direction may lean.
        let on = match held.at {
            At::Start => 1.0,
            At::End => -1.0,
            At::Between => 0.0,
        };
        let there = match held.at {
            At::Start | At::End => on * along <= 0.0,
            At::Between => along.abs() <= SQUARE * way.norm(),
        };
        if !(there && held.leans(held.lean) && down >= self.cos) {
            return None;
        }
        // No more than m leans itself: less of w is nearer to that.
        let least = held.least_lean(beside).max(KEPT * held.lean).min(held.lean);
        let bowl = held.bowl(least);
        let lean = two([0, 1], |i| two(beside[i], |y| bowl.across[i].1 * y));
        // The most that `w` may go along a direction.
        let most = |x: Vec3| {
            let by = |i: usize| {
                let along = held.across[i].0.dot(&x);
                (along * lean[i][0]).max(along * lean[i][1])
            };
            by(0) + by(1)
        };
        let longest = two(lean, |[from, to]| from.abs().max(to.abs()));
        let mut share: f64 = 1.0;
        let mut limit = |room: f64, by: f64| {
            if by > room {
                share = share.min(USED * room / by);
            }
        };
        if on != 0.0 {
            limit(-on * along, most(way * on));
        }
        limit(down - self.cos, most(ta) + self.cos * (longest[0] + longest[1]));
        if held.rho > 0.0 {
            limit(held.lean - least, most(-held.radial));
        }
        let lean = two(lean, |range| two(range, |w| share * w));
        Some((bowl.flatter(share), lean, share))
    }
}

impl Paraboloid {
    /// Is it about this direction, of about unit length?
    fn is_towards(&self, slope: Vec3) -> bool {
        (slope - self.m).norm_squared() <= ALIKE * ALIKE
    }

    /// What holds the corner for directions that lean by as much at least.
    fn bowl(&self, lean: f64) -> Bowl {
        let ring = if self.rho > 0.0 { self.rho / lean } else { 0.0 };
        let across = two(self.across, |(n, by)| (n, 1.0 / (self.radius + ring * by)));
        Bowl { m: self.m, p: self.p, radius: self.radius, across }
    }

    /// How much `m + w` leans from the axis at least, for what is so far beside p along both directions: `w = C^-1 y`.
    fn least_lean(&self, beside: [[f64; 2]; 2]) -> f64 {
        /// Share of the lean of m that all may have most likely.
        const MOST: f64 = 0.75;
        let along = |(n, [from, to]): (Vec3, [f64; 2]), most: f64| {
            let out = self.radial.dot(&n) * most;
            (out * from).min(out * to)
        };
        let [(first, by), (second, _)] = self.across;
        let of_second = along((second, beside[1]), 1.0 / self.radius);
        // Along one that runs around the axis C is not known before.
        if self.at == At::Between && self.rho > 0.0 {
            let all = MOST * self.lean;
            let out = along((first, beside[0]), 1.0 / (self.radius + self.rho / all * by));
            if self.lean + out >= all {
                return all;
            }
        }
        self.lean + along((first, beside[0]), 1.0 / self.radius).min(0.0) + of_second
    }

    /// Is it of the corner, not of the flat beside it, what faces a direction that leans by as much?
    fn leans(&self, lean: f64) -> bool {
        self.rho == 0.0 || lean > 0.0
    }
}

impl Bowl {
    /// With this share of what bends it.
    fn flatter(self, share: f64) -> Self {
        Self { across: two(self.across, |(n, by)| (n, share * by)), ..self }
    }

    /// The function and its gradient.
    fn value(&self, x: Vec3) -> (f64, Vec3) {
        let from = x - self.p;
        let (mut value, mut slope) = (self.m.dot(&from) - self.radius, self.m);
        for (n, k) in self.across {
            let y = n.dot(&from);
            value += 0.5 * k * y * y;
            slope += n * (k * y);
        }
        (value, slope)
    }

    /// Its second derivatives by the parameters, where they have these derivatives: uu, uv, vv.
    fn second(&self, slope: Vec3, [u, v]: [Vec3; 2], bend: [Vec3; 3]) -> [f64; 3] {
        let mut out = three(bend, |b| slope.dot(&b));
        for (n, k) in self.across {
            let (x, y) = (n.dot(&u), n.dot(&v));
            out = [out[0] + k * x * x, out[1] + k * x * y, out[2] + k * y * y];
        }
        out
    }

    /// By how much they may be others on a piece.
    fn vary(&self, tile: &Tile, slope: f64) -> [f64; 3] {
        // By how much the derivatives themselves differ.
        let [du, dv] = two(tile.stray, |s| 2.0 * s);
        let far = tile.radius();
        let mut out = three(tile.vary, |vary| slope * vary);
        for (n, k) in self.across {
            let [x, y] = two(tile.side, |d| n.dot(&d).abs());
            let bent = three([0, 1, 2], |i| far * (n.dot(&tile.bend[i]).abs() + tile.vary[i]));
            out[0] += k * (du * (2.0 * x + du) + bent[0]);
            out[1] += k * (x * dv + y * du + du * dv + bent[1]);
            out[2] += k * (dv * (2.0 * y + dv) + bent[2]);
        }
        out
    }
}

/// How a function is bent on a piece: along both parameters at least, by both together at most.
#[derive(Clone, Copy, Debug)]
struct Bent {
    u: f64,
    uv: f64,
    v: f64,
}

impl Bent {
    /// From its second derivatives in the middle, and by how much they may be others on the piece.
    fn new([uu, uv, vv]: [f64; 3], off: [f64; 3]) -> Self {
        Self { u: uu - off[0], uv: uv.abs() + off[1], v: vv - off[2] }
    }

    fn is_convex(&self) -> bool {
        self.u > 0.0 && self.v > 0.0 && self.u * self.v >= self.uv * self.uv
    }

    /// By how much one that is convex may be below its value at a place with this slope, wherever; no number where nothing tells.
    fn deepest(&self, g: [f64; 2]) -> f64 {
        let Self { u, uv, v } = *self;
        let [x, y] = two(g, f64::abs);
        (v * x * x + 2.0 * uv * x * y + u * y * y) / (2.0 * (u * v - uv * uv))
    }
}

/// A step of Newton's method from `s` that stays in the square from -1 to 1.
fn step(s: [f64; 2], g: [f64; 2], [a, b, c]: [f64; 3]) -> [f64; 2] {
    let inside = |x: f64| x.clamp(-1.0, 1.0);
    let det = a * c - b * b;
    let free = [s[0] - (c * g[0] - b * g[1]) / det, s[1] - (a * g[1] - b * g[0]) / det];
    if det > 0.0 && free.iter().all(|x| x.abs() <= 1.0) {
        return free;
    }
    // Along one parameter after the other.
    let mut to = if det > 0.0 { two(free, inside) } else { s };
    for _ in 0..2 {
        to[0] = inside(s[0] - (g[0] + b * (to[1] - s[1])) / a);
        to[1] = inside(s[1] - (g[1] + b * (to[0] - s[0])) / c);
    }
    to
}

#[cfg(test)]
#[path = "paraboloid_tests.rs"]
mod tests;
