//! POCKET (APT: `APOCK`): a convex polygon cleared from the inside out.
//!
//! The passes are polygons, each the next one inwards by the programmed cut. They are computed from the outside and cut
//! from the inside, always beginning at the corner of the first point. How near the innermost ones come, and how the cut
//! is shortened at corners that come up, is APT-360's way, found by running some hundreds of pockets through it.

use aptc_contact::{Condition, Side as Contact, distance};
use aptc_geometry::{Form, Plane, Surface, Vec3};
use aptc_protap::Pocket;

use crate::state::{Part, Role, Settings, Tool};

/// Least and greatest number of corners.
const CORNERS: std::ops::RangeInclusive<usize> = 3..=20;

/// Sines of half corners that differ by less are those of one corner.
const SAME_CORNER: f64 = 1e-9;

/// Heights that differ by less, in effective radii, are one.
const LEVEL: f64 = 1e-6;

/// More passes than this are a mistake in the numbers.
const MOST_PASSES: usize = 10_000;

/// The passes of a pocket.
#[derive(Clone, Debug)]
pub(crate) struct Passes {
    /// Closed polygons, innermost first; the last is the finish pass. An innermost one may be a single line.
    pub(crate) polygons: Vec<Vec<Vec3>>,
    /// Material that they leave: how far the nearest pass stays from it beyond the effective radius.
    pub(crate) left: Option<f64>,
    /// How far material is from the nearest pass at most.
    pub(crate) farthest: f64,
}

/// What stands on the floor between passes, as the bottom of the cutter is not as flat as the effective radius is great.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Between {
    pub(crate) height: f64,
    /// Radius of the flat end.
    pub(crate) flat: f64,
    pub(crate) radius: f64,
}

/// Why there are no passes.
pub(crate) type Reason = String;

/// Works them out.
pub(crate) fn passes(p: &Pocket, settings: &Settings, tool: &Tool) -> Result<Passes, Reason> {
    let cutter = settings.cutter.ok_or("no CUTTER is given before it")?.diameter / 2.0;
    let [keep_offsets, kind] = p.flags;
    let points = if kind >= 2 { project(&p.vertices, settings, tool)? } else { p.vertices.clone() };
    let mut figure = Figure::new(&points)?;
    if kind % 2 == 1 {
        let wide = beside_walls(settings).unwrap_or(cutter);
        // The walls stand along the tool axis, so over a sloping bottom the way in its plane is longer.
        let way = |s: &Side| {
            let wall = tool.ta.cross(&s.along).normalize();
            wide / figure.inwards(s).dot(&wall).abs()
        };
        figure = figure.inset_by(way).ok_or("the cutter does not fit into the pocket")?;
    }
    let positive = |x: f64| x > 0.0 && x.is_finite();
    // A finish cut of 0 goes along the last general pass once more.
    let finish = p.finish == 0.0 || positive(p.finish);
    if !positive(p.radius) || !positive(p.cut) || !finish || !positive(cutter) {
        return Err("effective radius, cuts and cutter must be above zero".into());
    }
    let (mut polygons, mut farthest) = (vec![figure.closed()], 0.0_f64);
    let mut cut = p.finish * cutter;
    // The sharpest corner until now limits the cut.
    let mut sharpest = figure.sharpest();
    while polygons.len() < MOST_PASSES {
        if figure.width() <= 2.0 * p.radius {
            return Ok(inside_out(polygons, farthest.max(figure.room()), p.radius));
        }
        let most = if keep_offsets == 0 { p.radius * (1.0 + sharpest) } else { f64::INFINITY };
        let step = cut.min(most);
        let half = figure.inset(step / 2.0);
        if let Some(last) = half.as_ref().filter(|h| h.width() <= 2.0 * p.radius) {
            // Half of the cut clears what is left, and a line of that pass if it is a narrow one.
            let (line, within) = last.rest(p.radius);
            polygons.push(line);
            let farthest = farthest.max(between(&figure, last)).max(within);
            return Ok(inside_out(polygons, farthest, p.radius));
        }
        let next = match half {
            Some(half) if keep_offsets == 0 => {
                let (step, s) = nearer(&figure, &half, step, p.radius);
                sharpest = sharpest.min(s);
                figure.inset(step).or(Some(half))
            }
            Some(half) => figure.inset(step).or(Some(half)),
            None => None,
        };
        let Some(next) = next else {
            // As given, no cut of this depth has room.
            return Ok(inside_out(polygons, farthest.max(figure.room()), p.radius));
        };
        farthest = farthest.max(between(&figure, &next));
        polygons.push(next.closed());
        figure = next;
        cut = p.cut * cutter;
    }
    Err("the cut is too small for the pocket".into())
}

/// How wide a cutter is beside upright walls whose sides lean in: half its diameter is measured where the lines of its outline meet,
/// beyond its corner. What widens upwards leaves walls that lean, from the corners at the floor on.
fn beside_walls(settings: &Settings) -> Option<f64> {
    settings.cutter.filter(|c| c.beta_deg < 0.0)?;
    Some(settings.profile(Role::Drive)?.ok()?.widest())
}

/// How deep the cutter is below a floor that leans while its tool end is on it, where that is more than INTOL: its rim is lower there
/// on one side. Of places of the tool end nobody says that they lie on a floor.
pub(crate) fn below_floor(
    passes: &Passes,
    p: &Pocket,
    settings: &Settings,
    tool: &Tool,
) -> Option<f64> {
    if p.flags[1] == 0 {
        return None;
    }
    let profile = settings.profile(Role::Part)?.ok()?;
    let corners = passes.polygons.last()?;
    let next = corners.iter().skip(1).chain(corners.first());
    let area: Vec3 =
        corners.iter().zip(next).map(|(a, b)| (a - corners[0]).cross(&(b - corners[0]))).sum();
    let n = area.try_normalize(0.0)?;
    let n = n * n.dot(&tool.ta).signum();
    let at = aptc_contact::Tool { profile: &profile, te: Vec3::zeros(), ta: tool.ta };
    let floor = Surface::Plane(Plane { n, d: 0.0 });
    let gap = distance(&at, &floor, Condition::Touch, Contact::Positive, 0.0, None).ok()?;
    let allowed = settings.intol_of_part() + LEVEL * profile.reach();
    (-gap.g > allowed).then_some(-gap.g)
}

/// What stands between the passes higher than OUTTOL, on a floor square to the tool axis.
pub(crate) fn between_passes(
    passes: &Passes,
    p: &Pocket,
    settings: &Settings,
    tool: &Tool,
) -> Option<Between> {
    let profile = settings.profile(Role::Part)?.ok()?;
    let corners = passes.polygons.last()?;
    let level = |a: &Vec3| (a - corners[0]).dot(&tool.ta).abs() <= LEVEL * p.radius;
    if !corners.iter().all(level) {
        return None;
    }
    let height = profile.height_at(passes.farthest.min(profile.widest()))? - profile.bottom();
    let joint = profile.joints()[0];
    let flat = if joint[1] - profile.bottom() <= LEVEL * p.radius { joint[0] } else { 0.0 };
    (height > settings.outtol_of_part()).then_some(Between { height, flat, radius: p.radius })
}

/// How far material between two passes is from them at most. It stays on the halving lines of the inner
/// corners, as far from them as from the outer sides, but where the tool goes out along one.
fn between(outer: &Figure, inner: &Figure) -> f64 {
    let farthest = |i: usize| {
        let n = inner.sides.len();
        let sides = [&inner.sides[(i + n - 1) % n], &inner.sides[i]];
        let inwards = |s: &Side| inner.normal.cross(&s.along);
        let along = (inwards(sides[0]) + inwards(sides[1])).normalize();
        let off = |s: &Side| (inner.corners[i] - s.on).dot(&inwards(s));
        let reach = |s: &Side| off(s) / (1.0 + along.dot(&inwards(s)));
        outer.sides.iter().map(reach).fold(f64::INFINITY, f64::min)
    };
    let (from, to) = (inner.first(), outer.first());
    let straight = inner.sides[from].index == outer.sides[to].index;
    let corners = (0..inner.corners.len()).filter(|i| !straight || *i != from);
    corners.map(farthest).fold(0.0, f64::max)
}

fn inside_out(mut polygons: Vec<Vec<Vec3>>, farthest: f64, radius: f64) -> Passes {
    polygons.reverse();
    let left = farthest - radius;
    Passes { polygons, left: (left > 1e-6 * radius).then_some(left), farthest }
}

/// A cut that leaves no material at corners that come up on the way, as sides vanish, and the sine of half the sharpest:
/// half of it and as much of the effective radius as the corner has.
fn nearer(figure: &Figure, half: &Figure, step: f64, radius: f64) -> (f64, f64) {
    let fewer = half.sides.len() < figure.sides.len();
    let shortened = |sine: f64| step.min(0.5 * step + radius * sine);
    let mut sine = if fewer { half.sharpest() } else { figure.sharpest() };
    let mut cut = if fewer { shortened(sine) } else { step };
    // Each round meets a sharper corner; there are no more of them than sides.
    for _ in 0..figure.sides.len() {
        let there = figure.inset(cut).map_or(sine, |f| f.sharpest());
        if there >= sine - SAME_CORNER {
            break;
        }
        sine = there;
        cut = shortened(sine);
    }
    (cut, sine)
}

/// Points moved along the tool axis onto the part surface.
fn project(points: &[Vec3], settings: &Settings, tool: &Tool) -> Result<Vec<Vec3>, Reason> {
    let plane = match &settings.part {
        Part::Surface(s) => match s.form.shape() {
            Form::Plane(p) => *p,
            _ => return Err("the part surface of this kind of pocket must be a plane".into()),
        },
        Part::Auto => Plane { n: tool.ta, d: tool.ta.dot(&tool.te) },
    };
    let rate = plane.n.dot(&tool.ta);
    if rate.abs() < 0.2 {
        return Err("the part plane is too steep for the tool axis".into());
    }
    Ok(points.iter().map(|p| p - tool.ta * (plane.distance(*p) / rate)).collect())
}

/// A convex polygon in a plane.
#[derive(Clone, Debug)]
struct Figure {
    normal: Vec3,
    /// Sides in order: a point, the unit direction along, the place of its start among the given points.
    sides: Vec<Side>,
    corners: Vec<Vec3>,
}

#[derive(Clone, Copy, Debug)]
struct Side {
    on: Vec3,
    along: Vec3,
    index: usize,
}

impl Figure {
    fn new(points: &[Vec3]) -> Result<Self, Reason> {
        let n = points.len();
        if !CORNERS.contains(&n) {
            return Err(format!("a pocket has 3 to 20 corners, not {n}"));
        }
        let next = |i: usize| points[(i + 1) % n];
        let area: Vec3 = (0..n).map(|i| points[i].cross(&next(i))).sum();
        let size = points.iter().map(|p| (p - points[0]).norm()).fold(0.0, f64::max);
        let normal = area / area.norm();
        if area.norm() <= 1e-9 * size * size {
            // The two halves of a bow tie make up for each other.
            return Err(crossing(points, size)
                .unwrap_or_else(|| "the corners of the pocket lie on a line".into()));
        }
        if points.iter().any(|p| (p - points[0]).dot(&normal).abs() > 1e-6 * size) {
            return Err("the corners of the pocket do not lie in a plane".into());
        }
        let mut sides = Vec::with_capacity(n);
        for (index, on) in points.iter().copied().enumerate() {
            let v = next(index) - on;
            if v.norm() <= 1e-9 * size {
                return Err("a corner of the pocket is given twice".into());
            }
            sides.push(Side { on, along: v.normalize(), index });
        }
        if let Some(why) = crossing(points, size) {
            return Err(why);
        }
        for i in 0..n {
            if sides[i].along.cross(&sides[(i + 1) % n].along).dot(&normal) < -1e-9 {
                return Err("the pocket has a corner that points inwards".into());
            }
        }
        Ok(Self { normal, sides, corners: points.to_vec() })
    }

    /// The polygon with all sides moved in; sides that vanish are left out.
    fn inset(&self, by: f64) -> Option<Self> {
        self.inset_by(|_| by)
    }

    /// The same, each side by a way of its own; `None` if one has no way.
    fn inset_by(&self, by: impl Fn(&Side) -> f64) -> Option<Self> {
        if !self.sides.iter().all(|s| by(s).is_finite()) {
            return None;
        }
        let mut sides: Vec<Side> =
            self.sides.iter().map(|s| Side { on: s.on + self.inwards(s) * by(s), ..*s }).collect();
        // Each round drops the sides that run backwards; a convex figure has at most all of them.
        for _ in 0..self.sides.len() {
            if sides.len() < 3 {
                return None;
            }
            let n = sides.len();
            let corners: Option<Vec<Vec3>> =
                (0..n).map(|i| cross(&sides[(i + n - 1) % n], &sides[i], self.normal)).collect();
            let corners = corners?;
            let lengths: Vec<f64> =
                (0..n).map(|i| (corners[(i + 1) % n] - corners[i]).dot(&sides[i].along)).collect();
            let worst = (0..n).min_by(|a, b| lengths[*a].total_cmp(&lengths[*b]))?;
            if lengths[worst] > 0.0 {
                return Some(Self { normal: self.normal, sides, corners });
            }
            if lengths.iter().all(|l| *l <= 0.0) {
                return None;
            }
            sides.remove(worst);
        }
        None
    }

    /// The direction across a side, into the figure.
    fn inwards(&self, side: &Side) -> Vec3 {
        self.normal.cross(&side.along)
    }

    /// Greatest distance of an inner point from the sides.
    fn room(&self) -> f64 {
        let (mut a, mut b) = (0.0, 0.0);
        for p in &self.corners {
            b = (p - self.corners[0]).norm().max(b);
        }
        for _ in 0..60 {
            let m = 0.5 * (a + b);
            if self.inset(m).is_some() { a = m } else { b = m }
        }
        a
    }

    /// Sine of half the sharpest corner.
    fn sharpest(&self) -> f64 {
        let n = self.sides.len();
        let sine = |i: usize| {
            let (a, b) = (self.sides[i].along, self.sides[(i + 1) % n].along);
            // The inner angle is what the turn leaves of 180 degrees.
            ((1.0 + a.dot(&b)) / 2.0).max(0.0).sqrt()
        };
        (0..n).map(sine).fold(1.0, f64::min)
    }

    /// Distance of the farthest corner from a side.
    fn across(&self, side: &Side) -> f64 {
        let inwards = self.inwards(side);
        self.corners.iter().map(|p| (p - side.on).dot(&inwards)).fold(0.0, f64::max)
    }

    /// Least of them: twice the radius of any circle in the figure is no more.
    fn width(&self) -> f64 {
        self.sides.iter().map(|s| self.across(s)).fold(f64::INFINITY, f64::min)
    }

    /// The innermost pass, and how far what is within it is from it at most: a line where one is enough.
    fn rest(&self, radius: f64) -> (Vec<Vec3>, f64) {
        let across = |s: &Side| self.across(s);
        let within = || self.sides.iter().map(across).filter(|a| *a <= radius).fold(0.0, f64::max);
        self.line(radius).map_or_else(|| (self.closed(), self.room()), |line| (line, within()))
    }

    /// The first side that has all of the figure within `radius`, towards the corner that comes first.
    fn line(&self, radius: f64) -> Option<Vec<Vec3>> {
        let (n, first) = (self.sides.len(), self.first());
        let at = |k: usize| (first + k) % n;
        let k = (0..n).find(|k| self.across(&self.sides[at(*k)]) <= radius)?;
        let (from, to) = if k + 1 == n { (k, 0) } else { (k + 1, k) };
        Some(vec![self.corners[at(from)], self.corners[at(to)]])
    }

    /// Corners from the one of the first point on, and that one again.
    fn closed(&self) -> Vec<Vec3> {
        let (n, first) = (self.corners.len(), self.first());
        (0..=n).map(|i| self.corners[(first + i) % n]).collect()
    }

    /// The corner of the first point; when the side that begins there has vanished, it is the end of the last.
    fn first(&self) -> usize {
        (0..self.sides.len()).min_by_key(|i| self.sides[*i].index).unwrap_or(0)
    }
}

/// Which two sides of a figure cross each other, if any do.
fn crossing(points: &[Vec3], size: f64) -> Option<Reason> {
    let (n, first) = (points.len(), points[0]);
    let pairs = (1..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
    let areas = pairs.map(|(i, j)| (points[i] - first).cross(&(points[j] - first)));
    // Across the plane of the figure, whichever way it goes round.
    let across = areas.max_by(|a, b| a.norm().total_cmp(&b.norm()))?.normalize();
    let side = |i: usize| [points[i], points[(i + 1) % n]];
    let apart = |[a, b]: [Vec3; 2], [c, d]: [Vec3; 2]| {
        let on = |p: Vec3| (b - a).cross(&(p - a)).dot(&across) / (size * size);
        on(c).min(on(d)) < -1e-9 && on(c).max(on(d)) > 1e-9
    };
    let cross = |i: usize, j: usize| apart(side(i), side(j)) && apart(side(j), side(i));
    (0..n).flat_map(|i| (i + 2..n).map(move |j| (i, j))).find(|(i, j)| cross(*i, *j)).map(
        |(i, j)| {
            let name = |i: usize| format!("from corner {} to corner {}", i + 1, (i + 1) % n + 1);
            format!("the sides of the pocket {} and {} cross", name(i), name(j))
        },
    )
}

/// The common point of two lines in the plane.
fn cross(a: &Side, b: &Side, normal: Vec3) -> Option<Vec3> {
    let det = a.along.cross(&b.along).dot(&normal);
    if det <= 1e-9 {
        // Three corners in a line: the one between them stays where it is along it.
        return (a.along.dot(&b.along) > 0.0).then_some(b.on);
    }
    let t = (b.on - a.on).cross(&b.along).dot(&normal) / det;
    Some(a.on + a.along * t)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(side: f64) -> Vec<Vec3> {
        [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
            .map(|(x, y)| Vec3::new(x * side, y * side, 1.0))
            .to_vec()
    }

    #[test]
    fn a_square_shrinks_and_vanishes_at_its_half() {
        let f = Figure::new(&square(4.0)).unwrap();
        assert_eq!(f.inset(1.0).unwrap().corners[0], Vec3::new(1.0, 1.0, 1.0));
        assert!(f.inset(2.1).is_none());
        assert!((f.room() - 2.0).abs() < 1e-9);
        assert!((f.sharpest() - 0.5f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn a_short_side_vanishes() {
        // A square with one corner cut off.
        let mut p = square(4.0);
        p[2] = Vec3::new(4.0, 3.5, 1.0);
        p.insert(3, Vec3::new(3.5, 4.0, 1.0));
        let f = Figure::new(&p).unwrap();
        assert_eq!(f.inset(0.1).unwrap().sides.len(), 5);
        assert_eq!(f.inset(1.0).unwrap().sides.len(), 4);
    }

    #[test]
    fn sides_that_cross_are_told() {
        let of = |p: &[(f64, f64)]| {
            let corners: Vec<Vec3> = p.iter().map(|(x, y)| Vec3::new(*x, *y, -2.0)).collect();
            Figure::new(&corners).unwrap_err()
        };
        let tie = of(&[(0.0, 0.0), (60.0, 40.0), (60.0, 0.0), (0.0, 40.0)]);
        let told =
            "the sides of the pocket from corner 1 to corner 2 and from corner 3 to corner 4 cross";
        assert_eq!(tie, told);
        assert_eq!(of(&[(0.0, 0.0), (60.0, 40.0), (60.0, 0.0), (0.0, 30.0)]), told);
        // Round twice: no corner points inwards.
        let star = of(&[(0.0, 10.0), (6.0, -8.0), (-9.5, 3.0), (9.5, 3.0), (-6.0, -8.0)]);
        assert!(star.ends_with("cross"), "{star}");
        let line = of(&[(0.0, 0.0), (60.0, 0.0), (30.0, 0.0)]);
        assert_eq!(line, "the corners of the pocket lie on a line");
    }

    #[test]
    fn a_corner_in_a_line_moves_with_it() {
        let mut p = square(4.0);
        p.insert(1, Vec3::new(1.0, 0.0, 1.0));
        let f = Figure::new(&p).unwrap().inset(0.5).unwrap();
        assert_eq!(f.corners[1], Vec3::new(1.0, 0.5, 1.0));
        assert!((f.width() - 3.0).abs() < 1e-12);
    }

    #[test]
    fn a_narrow_rest_is_cleared_along_one_side() {
        let p = [(0.0, 0.0), (9.0, 0.0), (9.0, 1.0), (0.0, 1.0)].map(|(x, y)| Vec3::new(x, y, 0.0));
        let f = Figure::new(&p).unwrap();
        assert_eq!(f.line(1.0).unwrap(), vec![p[1], p[0]]);
        assert!(f.line(0.9).is_none());
    }

    #[test]
    fn passes_too_far_apart_leave_material_at_the_corner() {
        let f = Figure::new(&square(4.0)).unwrap();
        let inner = f.inset(1.0).unwrap();
        // On the halving line it is as far from the sides as from the inner corner, root 2 from the outer one.
        let worst = 1.0 / (1.0 + 0.5f64.sqrt());
        assert!((between(&f, &inner) - worst).abs() < 1e-12);
    }

    #[test]
    fn a_corner_that_points_inwards_is_refused() {
        let mut p = square(4.0);
        p.insert(1, Vec3::new(2.0, 1.0, 1.0));
        assert!(Figure::new(&p).is_err());
    }
}
