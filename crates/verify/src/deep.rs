//! The point of the tool that is deepest in a surface.
//!
//! Over the tool the signed distance from the surface is looked for its least: from a place of the surface to the point of
//! the tool next to it and back, along sharp edges over the angle about the axis, over a disk without thickness by Newton's
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

/// The signed distance of a point from the surface, by the place that is found from `spot` on.
fn depth(sheet: &Sheet, side: f64, p: Vec3, spot: Spot) -> Deep {
    let (far, spot, q) = descend(&Tool::End, &Pose { te: p, ta: Vec3::z() }, sheet, spot);
    let gap = far.copysign(side * (p - q).dot(&sheet.jet(&spot).n));
    Deep { gap, p, spot }
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
                break;
            }
            best = next;
        }
        best
    };
    let mut first = down(below(spot));
    if first.gap > most
        && let Tool::Solid(disk) = tool
        && tool.is_thin()
    {
        let over = glide(pose, sheet, side, tool.inner(pose), disk.widest(), first.spot);
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

/// The deepest point of the face of a disk about `middle`, found from there on.
fn glide(pose: &Pose, sheet: &Sheet, side: f64, middle: Vec3, radius: f64, spot: Spot) -> Deep {
    /// Newton's steps, and the share of the radius over which the slope is taken again.
    const STEPS: u32 = 24;
    const DIFFERENCE: f64 = 1e-5;
    let [e, f] = frame_about(pose.ta);
    // Depth and its slope at a place of the face, which is nowhere left.
    let look = |x: Vec2, spot: Spot| {
        let x = x * (radius / x.norm()).min(1.0);
        let deep = depth(sheet, side, middle + e * x.x + f * x.y, spot);
        let n = sheet.jet(&deep.spot).n * side;
        (deep, x, Vec2::new(n.dot(&e), n.dot(&f)))
    };
    let h = DIFFERENCE * radius;
    let (mut now, mut at, mut slope) = look(Vec2::zeros(), spot);
    for _ in 0..STEPS {
        let bend = |d: Vec2| (look(at + d, now.spot).2 - slope) / h;
        // Away from the edge, so that the difference is one.
        let inward = Vec2::new(-at.x, -at.y).map(|v| if v < 0.0 { -1.0 } else { 1.0 });
        let along = [Vec2::new(h * inward.x, 0.0), Vec2::new(0.0, h * inward.y)];
        let (u, v) = (bend(along[0]) * inward.x, bend(along[1]) * inward.y);
        let (a, b, c) = (u.x, 0.5 * (u.y + v.x), v.y);
        let det = a * c - b * b;
        let mut step = if a > 0.0 && det > 0.0 {
            Vec2::new(b * slope.y - c * slope.x, b * slope.x - a * slope.y) / det
        } else {
            slope * (-radius / slope.norm().max(f64::MIN_POSITIVE))
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
