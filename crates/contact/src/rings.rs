//! A tool inside a hollow: its hull is spanned by circles about its axis, the arc being one thickened by
//! the corner radius unless its centre lies beyond the axis, and only these can touch.

use aptc_geometry::profile::Segment;
use aptc_geometry::surface::frame_about;
use aptc_geometry::{Foot, Profile, Reason, Tool, Vec3};

use crate::barrel::{self, Barrel};
use crate::gap::{Gap, deeper};

/// Cosines of the multiples of 22.5 degrees, to spread samples around an axis.
pub(crate) const COS16: [f64; 16] = {
    let (a, b, c) =
        (0.923_879_532_511_286_7, std::f64::consts::FRAC_1_SQRT_2, 0.382_683_432_365_089_8);
    [1.0, a, b, c, 0.0, -c, -b, -a, -1.0, -a, -b, -c, 0.0, c, b, a]
};
/// Bound of Newton's method on one circle.
const MAX_STEPS: usize = 60;
/// After a step of Newton's method of no more than this, radians, rounding alone is left: it converges quadratically.
const LAST: f64 = 1e-9;

/// The wall of a hollow that is convex.
pub(crate) trait Wall {
    /// The nearest place of it.
    fn foot(&self, p: Vec3) -> Foot;

    /// The signed distance of a point alone, negative inside.
    fn distance(&self, p: Vec3) -> f64 {
        self.foot(p).distance
    }

    /// The signed distances of sixteen places of the circle about `center` with these two spokes.
    fn around(&self, center: Vec3, spokes: [Vec3; 2]) -> [f64; 16] {
        std::array::from_fn(|k| self.distance(center + at16(spokes, k)))
    }
}

impl<F: Fn(Vec3) -> Foot> Wall for F {
    fn foot(&self, p: Vec3) -> Foot {
        self(p)
    }
}

/// The `k`th of sixteen places of a circle with these two spokes.
#[inline]
pub(crate) fn at16([a, b]: [Vec3; 2], k: usize) -> Vec3 {
    a * COS16[k] + b * COS16[(k + 12) % 16]
}

/// A circle of the cutter about its axis, thickened by r.
#[derive(Clone, Copy)]
struct Ring {
    rho: f64,
    z: f64,
    r: f64,
    segment: Segment,
}

/// The circles whose hull the cutter is, each once.
fn rings(profile: &Profile) -> [Option<Ring>; 5] {
    let [[a, za], [b, zb]] = profile.joints();
    let [e, f] = profile.corner();
    let (rim, top) = (profile.top_radius(), profile.height());
    let sharp = |rho: f64, z: f64, segment| Some(Ring { rho, z, r: 0.0, segment });
    let r = profile.corner_radius();
    let edge = |new: bool, ring| if new { ring } else { None };
    let arc = r > 0.0 || (e, f) != (rim, top);
    [
        sharp(rim, top, Segment::Rim),
        edge(arc, Some(Ring { rho: e, z: f, r, segment: Segment::Arc })),
        edge(r > 0.0, sharp(a, za, Segment::LowerPoint)),
        edge(r > 0.0 && (b, zb) != (rim, top), sharp(b, zb, Segment::UpperPoint)),
        sharp(0.0, profile.bottom(), Segment::Tip),
    ]
}

/// A place on a circle.
#[derive(Clone, Copy)]
struct At {
    out: Vec3,
    foot: Foot,
    /// Distance of the circle's point from the wall.
    value: f64,
    /// Its derivative by the angle.
    slope: f64,
}

/// Gap of a tool inside a hollow.
///
/// On each circle the distance from the wall is smooth and has at most two dips, on opposite sides, which
/// sixteen samples tell apart.
pub(crate) fn within(tool: &Tool<'_>, wall: impl Wall) -> Result<Gap, Reason> {
    nearest(tool, wall, None)
}

/// As [`within`], and a gap (before THICK) below which no other place of the tool is: one that is `apart` from the
/// nearest. Every sample counts, for where a dip becomes two there is no second one before.
pub(crate) fn with_rival(
    tool: &Tool<'_>,
    wall: impl Wall,
    apart: f64,
) -> Result<(Gap, f64), Reason> {
    let mut seen: Seen = [None; 5];
    let gap = nearest(tool, wall, Some(&mut seen))?;
    let others = seen.iter().flatten().flatten();
    let others = others.filter(|d| (d.0 - gap.tool_point).norm() > apart);
    Ok((gap, others.map(|d| d.1).fold(f64::INFINITY, f64::min)))
}

/// The samples of the circles: a point of the tool and a gap that is not greater than the one there.
type Seen = [Option<[(Vec3, f64); 16]>; 5];

fn nearest(tool: &Tool<'_>, wall: impl Wall, mut seen: Option<&mut Seen>) -> Result<Gap, Reason> {
    let [a, b] = frame_about(tool.ta);
    let mut best: Option<Gap> = None;
    let rings = rings(tool.profile);
    let middles = rings.map(|ring| ring.map(|r| -wall.distance(tool.te + tool.ta * r.z)));
    let reach = reachable(&rings, &middles);
    for (k, (ring, middle)) in rings.iter().zip(middles).enumerate() {
        let (Some(ring), Some(middle)) = (ring, middle) else { continue };
        // Within its radius of its middle all of a circle lies.
        if seen.is_none() && deeper(tool, reach, middle - ring.rho.max(0.0) - ring.r) {
            continue;
        }
        if ring.segment == Segment::Arc && barrel::is_one(tool.profile) {
            let samples = Barrel::new(tool, [a, b]).nearest(&wall, |at| {
                let normal = -at.foot.normal;
                if best.is_none_or(|b| deeper(tool, at.value, b.raw)) {
                    best = Some(Gap {
                        g: at.value,
                        raw: at.value,
                        tool_point: at.point,
                        surface_point: at.foot.point,
                        at: at.foot.at,
                        normal,
                        segment: Some(ring.segment),
                        residual: at.slope * ring.r,
                    });
                }
            });
            if let Some(seen) = &mut seen {
                seen[k] = Some(samples);
            }
            continue;
        }
        let center = tool.te + tool.ta * ring.z;
        let at = |out: Vec3| {
            let foot = wall.foot(center + out * ring.rho);
            let slope = -foot.normal.dot(&tool.ta.cross(&out)) * ring.rho;
            At { out, foot, value: -foot.distance, slope }
        };
        let mut offer = |at: &At| {
            let normal = -at.foot.normal;
            let real =
                ring.segment != Segment::Arc || tool.support(-normal).segment == Segment::Arc;
            let raw = at.value - ring.r;
            if real && best.is_none_or(|b| deeper(tool, raw, b.raw)) {
                best = Some(Gap {
                    g: raw,
                    raw,
                    tool_point: center + at.out * ring.rho - normal * ring.r,
                    surface_point: at.foot.point,
                    at: at.foot.at,
                    normal,
                    segment: Some(ring.segment),
                    residual: at.slope.abs(),
                });
            }
            raw
        };
        if ring.rho <= 0.0 {
            offer(&at(a));
            continue;
        }
        let point = |at: &At| center + at.out * ring.rho + at.foot.normal * ring.r;
        let all = wall.around(center, [a * ring.rho, b * ring.rho]).map(|d| -d);
        let sample = |i: usize| (point(&at(at16([a, b], i))), all[i] - ring.r);
        let mut samples =
            seen.as_deref_mut().map(|seen| seen[k].insert(std::array::from_fn(sample)));
        let mut least = f64::INFINITY;
        for i in 0..16 {
            let (before, here, after) = (all[(i + 15) % 16], all[i], all[(i + 1) % 16]);
            if here > before || here > after {
                continue;
            }
            // No dip is deeper below its sample than this.
            let depth = (before - here).max(after - here);
            let bound = here - depth - ring.r;
            if let Some(samples) = &mut samples {
                samples[i].1 = bound;
            }
            if bound <= least {
                let lowest = descend(tool, ring, &at, at(at16([a, b], i)));
                least = least.min(offer(&lowest));
                if let Some(samples) = &mut samples {
                    samples[i] = (point(&lowest), lowest.value - ring.r);
                }
            }
        }
    }
    best.ok_or(Reason::NoHit)
}

/// A gap that the deepest place of the circles does not exceed, from the distances of their middles: the distance from the
/// wall of a hollow is concave, so that somewhere on a circle it is no greater than in its middle.
fn reachable(rings: &[Option<Ring>; 5], middles: &[Option<f64>; 5]) -> f64 {
    let sharp = rings.iter().zip(middles).filter_map(|(ring, middle)| {
        // Only a part of the arc's circle may belong to the cutter.
        ring.filter(|r| r.segment != Segment::Arc).and(*middle)
    });
    sharp.fold(f64::INFINITY, f64::min)
}

/// Newton's method downhill on a circle, with steps no longer than the sampling.
fn descend(tool: &Tool<'_>, ring: &Ring, place: &impl Fn(Vec3) -> At, start: At) -> At {
    let mut at = start;
    let mut cap = 0.4;
    for _ in 0..MAX_STEPS {
        if at.slope.abs() <= 1e-14 * ring.rho {
            break;
        }
        let around = tool.ta.cross(&at.out);
        let turn = at.foot.shape.offset(at.foot.distance).map_or(0.0, |s| s.second(around));
        let bend = ring.rho * at.foot.normal.dot(&at.out) - turn * ring.rho * ring.rho;
        let newton = -at.slope / bend;
        let downhill = -cap * at.slope.signum();
        let step = if bend > 0.0 && newton.abs() <= cap { newton } else { downhill };
        let next = place((at.out + around * step).normalize());
        if bend > 0.0 && newton.abs() <= LAST {
            return next;
        }
        if next.value < at.value || next.slope.abs() < 0.5 * at.slope.abs() && bend > 0.0 {
            at = next;
        } else {
            cap = 0.5 * step.abs();
            if cap < 1e-15 {
                break;
            }
        }
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::{Cutter, Sphere, Surface, trig};

    #[test]
    fn a_ball_above_the_bottom_of_a_hollow_touches_with_its_arc_in_any_size() {
        for k in 1..200 {
            let s = 0.013 * f64::from(k);
            let ball = Surface::Sphere(Sphere { center: Vec3::z() * (9.0 * s), radius: 9.0 * s });
            let profile = Profile::new(&Cutter::mill(4.7 * s, 2.35 * s, 12.7 * s)).unwrap();
            let tool = Tool { profile: &profile, te: Vec3::z() * (0.7 * s), ta: Vec3::z() };
            let foot = |p| ball.foot(p);
            let gap = within(&tool, foot).unwrap();
            assert_eq!(gap.segment, Some(Segment::Arc), "{s}");
        }
    }

    #[test]
    fn no_place_apart_from_the_nearest_is_nearer_than_its_rival() {
        let ball = Surface::Sphere(Sphere { center: Vec3::zeros(), radius: 10.0 });
        for (d, r) in [(6.0, 0.0), (8.0, 1.0)] {
            let profile = Profile::new(&Cutter::mill(d, r, 9.0)).unwrap();
            for (x, y, lean) in [(2.0, 0.3, 0.0), (0.1, 0.0, 0.2), (1.0, -2.0, -0.3)] {
                let (s, c) = trig::sin_cos(lean);
                let (te, ta) = (Vec3::new(x, y, -6.0), Vec3::new(s, 0.0, c));
                let tool = Tool { profile: &profile, te, ta };
                let apart = 0.3;
                let (gap, rival) = with_rival(&tool, |p| ball.foot(p), apart).unwrap();
                let [a, b] = frame_about(ta);
                for ring in rings(&profile).iter().flatten() {
                    for k in 0..720 {
                        let (s, c) = trig::sin_cos(f64::from(k) * std::f64::consts::TAU / 720.0);
                        let foot_of = te + ta * ring.z + (a * c + b * s) * ring.rho;
                        let foot = ball.foot(foot_of);
                        let (p, g) = (foot_of + foot.normal * ring.r, -foot.distance - ring.r);
                        // Between two samples, some 1.2 apart, the gap may fall by what the surface falls on that way.
                        let free = (p - gap.tool_point).norm() <= apart || g >= rival - 0.1;
                        assert!(free, "{d} {r} {x} {lean}: {g} at {p}, rival {rival}");
                    }
                }
            }
        }
    }
}
