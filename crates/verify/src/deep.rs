//! The point of the tool that is deepest in a surface.
//!
//! Over the tool the signed distance from the surface is looked for its least: from a place of the surface to the point of
//! the tool next to it and back, along sharp edges over the angle about the axis, over flat ends and the flank by Newton's
//! method, since behind a dome the way to and fro leads away from its deepest point.

use aptc_geometry::surface::frame_about;
use aptc_geometry::{Vec2, Vec3, trig};

use crate::sheet::{Sheet, Spot};
use crate::tool::{Pose, Tool};
use crate::witness::descend;

/// A point of the tool with its signed distance from the surface and the place that is nearest to it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Deep {
    pub(crate) gap: f64,
    pub(crate) p: Vec3,
    pub(crate) spot: Spot,
}

/// The signed distance of a point from the surface, by the place that is found from `spot` on. Where that is at the border of its
/// chart, and the point lies beside it, how far it is along the normal: not as deep as it is far.
fn depth(sheet: &Sheet, side: f64, p: Vec3, spot: Spot) -> Deep {
    let (_, spot, jet) = descend(&Tool::End, &Pose { te: p, ta: Vec3::z() }, sheet, spot);
    Deep { gap: side * (p - jet.p).dot(&jet.n), p, spot }
}

/// The point of the tool that is deepest in the surface, as found from `spot` on; where it is not as deep as `most`,
/// all around the axis.
pub(crate) fn deepest(
    tool: &Tool<'_>,
    pose: &Pose,
    sheet: &Sheet,
    side: f64,
    spot: Spot,
    most: f64,
) -> Deep {
    /// Rounds from a point of the tool to the normal below it and back.
    const ROUNDS: u32 = 12;
    /// Places around the axis.
    const AROUND: u32 = 16;
    // Against a face many points are as far along the normal; then the one next to the place.
    let below = |spot: Spot| {
        let jet = sheet.jet(&spot);
        let (f, m) = tool.near(pose, jet.p);
        let far = depth(sheet, side, tool.farthest(pose, jet.n * -side), spot);
        let near = depth(sheet, side, jet.p - m * f, spot);
        if near.gap < far.gap { near } else { far }
    };
    let down = |mut best: Deep| {
        for _ in 0..ROUNDS {
            let mut next = below(best.spot);
            if next.gap >= best.gap
                && let Some(slid) = slide(pose, sheet, side, best.p, best.spot)
            {
                next = slid;
            }
            if next.gap >= best.gap {
                return best;
            }
            best = next;
        }
        // To and fro along an edge comes to its deepest point slowly.
        let slid = slide(pose, sheet, side, best.p, best.spot);
        slid.filter(|s| s.gap < best.gap).unwrap_or(best)
    };
    let mut first = down(below(spot));
    if first.gap > most
        && tool.is_thin()
        && let Some(disk) = Disk::of(tool, pose)
    {
        let over = over_end(pose, sheet, side, &disk, first.spot);
        first = if over.gap < first.gap { over } else { first };
    }
    if first.gap <= most {
        return first;
    }
    let up = pose.ta * (first.p - pose.te).dot(&pose.ta);
    let out = first.p - pose.te - up;
    let across = pose.ta.cross(&out);
    let around = (1..AROUND).map(|k| {
        let (s, c) = trig::sin_cos(std::f64::consts::TAU * f64::from(k) / f64::from(AROUND));
        depth(sheet, side, pose.te + up + out * c + across * s, first.spot)
    });
    let other = around.reduce(|a, b| if b.gap < a.gap { b } else { a });
    other.map(down).filter(|o| o.gap < first.gap).unwrap_or(first)
}

/// How deep the surface is in the tool about a place of it, downhill over the surface in steps that begin with `size`, across its edges:
/// less than none inside.
pub(crate) fn inside(tool: &Tool<'_>, pose: &Pose, sheet: &Sheet, spot: Spot, size: f64) -> f64 {
    /// Steps at most, and share of the first below which no other counts.
    const STEPS: u32 = 80;
    const LEAST: f64 = 1e-4;
    let look = |spot: Spot| {
        let jet = sheet.jet(&spot);
        (tool.near(pose, jet.p).0, spot, jet.d)
    };
    let mut best = look(spot);
    let mut step = size;
    for _ in 0..STEPS {
        let ways = [(0, step), (0, -step), (1, step), (1, -step)];
        let next = ways.into_iter().filter_map(|(k, by)| {
            let rate = best.2[k].norm();
            let mut spot = best.1;
            spot.at[k] += by / rate;
            (rate > 0.0).then(|| look(sheet.settle(spot)))
        });
        match next.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|n| n.0 < best.0) {
            Some(next) => best = next,
            None if step <= LEAST * size => break,
            None => step *= 0.5,
        }
    }
    best.0
}

/// A deeper point than `first`, if there is one, on the flat end or the flank of the tool. It may be deep in a surface that
/// it is beside of, whose nearest place is another: what it says is to be shown.
pub(crate) fn on_faces(
    tool: &Tool<'_>,
    pose: &Pose,
    sheet: &Sheet,
    side: f64,
    first: Deep,
    most: f64,
) -> Deep {
    let deeper = |a: Deep, b: Deep| if b.gap < a.gap { b } else { a };
    let mut best = first;
    if let Some(end) = Disk::of(tool, pose) {
        best = deeper(best, over_end(pose, sheet, side, &end, first.spot));
    }
    if let Some(flank) = Flank::of(tool, pose).filter(|_| best.gap > most) {
        best = deeper(best, glide(sheet, side, &flank, flank.beside(best.p), best.spot));
    }
    best
}

/// The deepest point on the ring that the tool's point `p` makes about the axis. Along a sharp edge the distance has
/// a narrow and bent valley, in which a descent over the surface comes to a halt; over the angle about the
/// axis it is smooth. `None` where there is no ring, or no deeper point on it.
pub(crate) fn slide(pose: &Pose, sheet: &Sheet, side: f64, p: Vec3, spot: Spot) -> Option<Deep> {
    /// Steps along the ring, the longest of them and that over which the slope is taken again, in radians.
    const STEPS: u32 = 16;
    const LONGEST: f64 = 0.4;
    const DIFFERENCE: f64 = 1e-5;
    let middle = pose.te + pose.ta * (p - pose.te).dot(&pose.ta);
    let out = p - middle;
    if out.norm() <= 1e-9 * (p - pose.te).norm() {
        return None;
    }
    let across = pose.ta.cross(&out);
    let look = |angle: f64, spot: Spot| {
        let (s, c) = trig::sin_cos(angle);
        let deep = depth(sheet, side, middle + out * c + across * s, spot);
        (deep, side * sheet.jet(&deep.spot).n.dot(&(across * c - out * s)))
    };
    let (mut angle, mut now) = (0.0, look(0.0, spot));
    let mut moved = false;
    for _ in 0..STEPS {
        let bend = (look(angle + DIFFERENCE, now.0.spot).1 - now.1) / DIFFERENCE;
        let straight = if bend > 0.0 { -now.1 / bend } else { -LONGEST.copysign(now.1) };
        let mut step = straight.clamp(-LONGEST, LONGEST);
        let mut next = look(angle + step, now.0.spot);
        for _ in 0..6 {
            if next.0.gap < now.0.gap {
                break;
            }
            step *= 0.25;
            next = look(angle + step, now.0.spot);
        }
        if next.0.gap >= now.0.gap {
            break;
        }
        (now, angle, moved) = (next, angle + step, true);
        if step.abs() <= DIFFERENCE {
            break;
        }
    }
    moved.then_some(now.0)
}

/// A face of the tool by two lengths.
trait Face {
    /// The point at `x`, and how it goes with either length.
    fn at(&self, x: Vec2) -> (Vec3, [Vec3; 2]);
    /// The place of the face next to `x`.
    fn within(&self, x: Vec2) -> Vec2;
    /// Signs of the ways that lead away from the border.
    fn inward(&self, x: Vec2) -> Vec2;
    /// The longest step of a search.
    fn size(&self) -> f64;
}

/// A disk without thickness, or a flat end.
struct Disk {
    middle: Vec3,
    e: Vec3,
    f: Vec3,
    radius: f64,
}

impl Disk {
    /// `None` of a tool whose end is not flat.
    fn of(tool: &Tool<'_>, pose: &Pose) -> Option<Self> {
        let Tool::Solid(profile) = tool else { return None };
        let [[radius, z], _] = profile.joints();
        let flat = radius > 0.0 && z <= profile.bottom();
        let [e, f] = frame_about(pose.ta);
        flat.then_some(Self { middle: pose.te + pose.ta * z, e, f, radius })
    }
}

impl Face for Disk {
    fn at(&self, x: Vec2) -> (Vec3, [Vec3; 2]) {
        (self.middle + self.e * x.x + self.f * x.y, [self.e, self.f])
    }

    fn within(&self, x: Vec2) -> Vec2 {
        x * (self.radius / x.norm()).min(1.0)
    }

    fn inward(&self, x: Vec2) -> Vec2 {
        x.map(|v| if v > 0.0 { -1.0 } else { 1.0 })
    }

    fn size(&self) -> f64 {
        self.radius
    }
}

/// The upper line of the profile, turned about the axis: the way round at its widest, and the height above its lower end.
struct Flank {
    foot: Vec3,
    ta: Vec3,
    e: Vec3,
    f: Vec3,
    /// Its radius below and by how much that grows with the height.
    radius: f64,
    lean: f64,
    height: f64,
}

impl Flank {
    /// `None` of what has none.
    fn of(tool: &Tool<'_>, pose: &Pose) -> Option<Self> {
        let Tool::Solid(profile) = tool else { return None };
        let [_, [radius, z]] = profile.joints();
        let height = profile.height() - z;
        let lean = (profile.top_radius() - radius) / height;
        let [e, f] = frame_about(pose.ta);
        let foot = pose.te + pose.ta * z;
        (height > 0.0 && radius > 0.0 && lean.is_finite()).then_some(Self {
            foot,
            ta: pose.ta,
            e,
            f,
            radius,
            lean,
            height,
        })
    }

    /// The place on the side of the point `p`.
    fn beside(&self, p: Vec3) -> Vec2 {
        let w = p - self.foot;
        let round = trig::atan2(w.dot(&self.f), w.dot(&self.e)) * self.radius;
        self.within(Vec2::new(round, w.dot(&self.ta)))
    }
}

impl Face for Flank {
    fn at(&self, x: Vec2) -> (Vec3, [Vec3; 2]) {
        let (s, c) = trig::sin_cos(x.x / self.radius);
        let (out, round) = (self.e * c + self.f * s, self.f * c - self.e * s);
        let rho = self.radius + self.lean * x.y;
        let p = self.foot + self.ta * x.y + out * rho;
        (p, [round * (rho / self.radius), self.ta + out * self.lean])
    }

    fn within(&self, x: Vec2) -> Vec2 {
        Vec2::new(x.x, x.y.clamp(0.0, self.height))
    }

    fn inward(&self, x: Vec2) -> Vec2 {
        Vec2::new(1.0, if x.y > 0.5 * self.height { -1.0 } else { 1.0 })
    }

    fn size(&self) -> f64 {
        self.radius
    }
}

/// The deepest point of a flat end: found from its middle on, and where that leads to its edge along it.
fn over_end(pose: &Pose, sheet: &Sheet, side: f64, end: &Disk, spot: Spot) -> Deep {
    let inside = glide(sheet, side, end, Vec2::zeros(), spot);
    let edge = slide(pose, sheet, side, inside.p, inside.spot);
    edge.filter(|e| e.gap < inside.gap).unwrap_or(inside)
}

/// The deepest point of a face, found from its place `start` on: Newton's method with differences of the slope.
fn glide(sheet: &Sheet, side: f64, face: &impl Face, start: Vec2, spot: Spot) -> Deep {
    /// Newton's steps, and the share of the face's size over which the slope is taken again.
    const STEPS: u32 = 24;
    const DIFFERENCE: f64 = 1e-5;
    // Depth and its slope at a place of the face, which is nowhere left.
    let look = |x: Vec2, spot: Spot| {
        let x = face.within(x);
        let (p, [e, f]) = face.at(x);
        let deep = depth(sheet, side, p, spot);
        let n = sheet.jet(&deep.spot).n * side;
        (deep, x, Vec2::new(n.dot(&e), n.dot(&f)))
    };
    let h = DIFFERENCE * face.size();
    let (mut now, mut at, mut slope) = look(start, spot);
    for _ in 0..STEPS {
        let bend = |d: Vec2| (look(at + d, now.spot).2 - slope) / h;
        // Away from the edge, so that the difference is one.
        let inward = face.inward(at);
        let along = [Vec2::new(h * inward.x, 0.0), Vec2::new(0.0, h * inward.y)];
        let (u, v) = (bend(along[0]) * inward.x, bend(along[1]) * inward.y);
        let (a, b, c) = (u.x, 0.5 * (u.y + v.x), v.y);
        let det = a * c - b * b;
        let mut step = if a > 0.0 && det > 0.0 {
            Vec2::new(b * slope.y - c * slope.x, b * slope.x - a * slope.y) / det
        } else {
            slope * (-face.size() / slope.norm().max(f64::MIN_POSITIVE))
        };
        let mut next = look(at + step, now.spot);
        for _ in 0..8 {
            if next.0.gap < now.gap {
                break;
            }
            step *= 0.25;
            next = look(at + step, now.spot);
        }
        if next.0.gap >= now.gap {
            break;
        }
        (now, at, slope) = next;
    }
    now
}
