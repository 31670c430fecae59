//! A drive point projected on the part surface.

use aptc_contact::Tool;
use aptc_geometry::sculpt::{Border, Derivatives};
use aptc_geometry::{Profile, Sculptured, Vec3};

use crate::patience::Patience;
use crate::position::level;

/// How far beyond the borders of the part surface, in spans, its linear continuation is followed.
const BEYOND: f64 = 10.0;
/// Share of one derivative that the other is at a pole.
const POLE: f64 = 1e-9;
/// Newton's steps of a search.
pub(crate) const STEPS: usize = 40;
/// A radius of curvature that is as good as none, in sizes of the cutter.
const LARGE: f64 = 1e3;
/// Radii of a flat bottom from its axis beyond which a summit is not looked for that the first step foretells there.
const FAR: f64 = 4.0;
/// A summit is looked for where the normal is about so near to the tool axis: its cosine.
const FACING: f64 = 0.95;

/// What is moved along the line of projection until the part surface is met.
#[derive(Clone, Copy, Debug)]
pub enum Probe<'a> {
    /// A ball of this radius about the moving point; of radius 0 the point itself.
    Ball(f64),
    /// The cutter with its tool end at the moving point, `thick` off the surface.
    Cutter {
        /// Its profile.
        profile: &'a Profile,
        /// Unit tool axis.
        ta: Vec3,
        /// Between cutter and surface.
        thick: f64,
    },
}

/// Where it meets.
#[derive(Clone, Copy, Debug)]
pub struct Met {
    /// Parameters of the part surface.
    pub uv: [f64; 2],
    /// Point and derivatives there.
    pub at: Derivatives,
    /// Unit normal there, towards the tool.
    pub normal: Vec3,
    /// How far along the direction.
    pub way: f64,
}

/// How a surface goes on at its borders.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ends {
    borders: [[Border; 2]; 2],
    /// How far its continuation is followed from each, in spans.
    beyond: [[f64; 2]; 2],
}

impl Ends {
    /// Of a surface.
    pub fn of(surface: &Sculptured) -> Self {
        let (borders, spans) = (surface.borders(), surface.spans());
        let beyond = [0, 1].map(|k| {
            [0, 1].map(|end| match borders[k][end] {
                Border::Free => BEYOND.min(spans[k] * surface.runs_on(k, end == 1)),
                _ => 0.0,
            })
        });
        Self { borders, beyond }
    }
}

/// The line of projection and the surface with the side of the tool.
#[derive(Clone, Copy, Debug)]
pub struct Shot<'a> {
    /// The surface.
    pub surface: &'a Sculptured,
    /// A length that says how large its numbers are.
    pub extent: f64,
    /// How it goes on at its borders.
    pub ends: Ends,
    /// +1 when the tool is on the side of dU x dV.
    pub side: f64,
    /// A point of the line.
    pub from: Vec3,
    /// Its unit direction.
    pub along: Vec3,
    /// What is moved.
    pub probe: Probe<'a>,
}

impl Met {
    /// The same of the line in the other direction.
    #[must_use]
    pub fn turned(self) -> Self {
        Self { way: -self.way, ..self }
    }
}

impl Shot<'_> {
    /// The line in the other direction.
    #[must_use]
    pub fn turned(&self) -> Self {
        Self { along: -self.along, ..*self }
    }

    /// The first of the meetings that searches from `start` reach: of cutter and slope, and of a flat bottom and
    /// a summit below it.
    pub fn near(&self, start: [f64; 2]) -> Option<Met> {
        let [u, v] = start;
        let there = self.surface.at(u, v);
        let summit = self.summit(start, there);
        let slope = self.slope(start, there);
        // Over a summit the normal is about the tool axis.
        let slope = slope.or_else(|| summit.and_then(|_| self.round(start, there)));
        match (slope, summit) {
            (Some(a), Some(b)) => Some(if b.way < a.way { b } else { a }),
            (a, b) => a.or(b),
        }
    }

    /// A place below a flat bottom whose normal is the tool axis, nearest to `start` by Newton's method: there any
    /// place of the bottom may touch.
    fn summit(&self, start: [f64; 2], mut d: Derivatives) -> Option<Met> {
        let Probe::Cutter { profile, ta, thick } = self.probe else { return None };
        let [wide, height] = profile.joints()[0];
        let lean = self.along.dot(&ta);
        if wide <= 0.0 || height.abs() > 1e-12 * profile.reach() || lean >= 0.0 {
            return None;
        }
        let [mut u, mut v] = start;
        let mut patience = Patience::default();
        for k in 0..STEPS {
            let n = d.normal()? * self.side;
            if k == 0 && n.dot(&ta) < FACING {
                return None;
            }
            let (g, h) = (d.u.dot(&ta), d.v.dot(&ta));
            // The way of the tool to where it has a place below it, and how far that is from its axis.
            let under = |p: Vec3| {
                let way = (p + ta * thick - self.from).dot(&ta) / lean;
                let off = p - (self.from + self.along * way);
                (way, (off - ta * off.dot(&ta)).norm())
            };
            if g.abs().max(h.abs()) <= 1e-13 * (d.u.norm() + d.v.norm()) {
                let (way, beside) = under(d.point);
                return (n.dot(&ta) > 0.0 && beside <= wide).then_some(Met {
                    uv: [u, v],
                    at: d,
                    normal: n,
                    way,
                });
            }
            let (a, b, c) = (d.uu.dot(&ta), d.uv.dot(&ta), d.vv.dot(&ta));
            let det = a * c - b * b;
            if det == 0.0 || !det.is_finite() || patience.ends(g.abs().max(h.abs())) {
                return None;
            }
            let (du, dv) = ((b * h - c * g) / det, (b * g - a * h) / det);
            let step = d.u * du + d.v * dv;
            // Most have none anywhere near. Later a step is about as long as the way that is left is not foretold.
            let over = if k == 0 { FAR * wide } else { wide + step.norm() };
            if under(d.point + step).1 > over {
                return None;
            }
            [u, v] = self.stepped([u, v], [du, dv]);
            d = self.surface.at(u, v);
        }
        None
    }

    /// Unit normal along u x v and the length of that; at a pole, where a derivative is but rounding, the normal to which they come.
    fn normal(&self, [u, v]: [f64; 2], d: &Derivatives) -> Option<(Vec3, f64)> {
        let (a, b) = (d.u.norm(), d.v.norm());
        let n = d.u.cross(&d.v);
        let size = n.norm();
        if a.min(b) <= POLE * a.max(b) {
            return self.surface.normal_at(u, v).map(|n| (n, size));
        }
        (size > 1e-12 * a * b && size > 0.0).then(|| (n / size, size))
    }

    /// A step of Newton's method: half a span at most, so that the patch between is seen, and not far off the surface. It
    /// crosses seams and poles.
    pub(crate) fn stepped(&self, from: [f64; 2], by: [f64; 2]) -> [f64; 2] {
        let spans = self.surface.spans();
        let cap = (0.5 / by[0].abs().max(by[1].abs())).min(1.0);
        let mut to = [from[0] + by[0] * cap, from[1] + by[1] * cap];
        for k in 0..2 {
            let [first, last] = self.ends.borders[k];
            let (low, high) = (to[k] < 0.0, to[k] > spans[k]);
            if low && first == Border::Pole || high && last == Border::Pole {
                to[k] = if low { -to[k] } else { 2.0 * spans[k] - to[k] };
                to[1 - k] += 0.5 * spans[1 - k];
            }
        }
        for k in 0..2 {
            let [first, last] = self.ends.beyond[k];
            to[k] = if self.ends.borders[k][0] == Border::Seam {
                to[k].rem_euclid(spans[k])
            } else {
                to[k].clamp(-first, spans[k] + last)
            };
        }
        to
    }

    /// The meeting that Newton's method reaches from `start`.
    pub(crate) fn slope(&self, start: [f64; 2], mut d: Derivatives) -> Option<Met> {
        let [a, b] = aptc_geometry::surface::frame_about(self.along);
        let size = self.extent + self.from.norm();
        let [mut u, mut v] = start;
        let mut patience = Patience::default();
        for _ in 0..STEPS {
            let (unit, area) = self.normal([u, v], &d)?;
            let n = unit * self.side;
            let reach = self.reach(n);
            let w = d.point + reach.to - self.from;
            let (e, g) = (w.dot(&a), w.dot(&b));
            if e.abs().max(g.abs()) <= 1e-13 * size {
                // A surface seen from behind is no contact.
                let way = w.dot(&self.along);
                let faces = n.dot(&self.along) < 0.0;
                return faces.then_some(Met { uv: [u, v], at: d, normal: n, way });
            }
            let [nu1, nv1] = self.turn(&d, unit, area)?;
            let (wu, wv) = (d.u + reach.rate(nu1), d.v + reach.rate(nv1));
            let (eu, ev, gu, gv) = (wu.dot(&a), wv.dot(&a), wu.dot(&b), wv.dot(&b));
            let det = eu * gv - ev * gu;
            if det == 0.0 || !det.is_finite() || patience.ends(e.abs().max(g.abs())) {
                return None;
            }
            let (du, dv) = ((ev * g - gv * e) / det, (gu * e - eu * g) / det);
            [u, v] = self.stepped([u, v], [du, dv]);
            d = self.surface.at(u, v);
        }
        None
    }

    /// From a contact of the unit normal `n` to the moving point.
    pub(crate) fn reach(&self, n: Vec3) -> Reach {
        match self.probe {
            Probe::Ball(r) => {
                Reach { to: n * r, frame: [Vec3::zeros(); 2], radii: [0.0; 2], even: r }
            }
            Probe::Cutter { profile, ta, thick } => {
                let s = Tool { profile, te: Vec3::zeros(), ta }.support(-level(n, ta));
                // On a face the contact would jump: a large radius keeps Newton's method moving.
                let large = |r: f64| r > LARGE * profile.widest();
                let radii = if s.radii.into_iter().any(large) {
                    s.radii.map(|r| r.min(LARGE * profile.reach()))
                } else {
                    s.radii
                };
                Reach { to: n * thick - s.point, frame: s.frame, radii, even: thick }
            }
        }
    }

    /// Derivatives of the unit normal towards the tool.
    fn turn(&self, d: &Derivatives, unit: Vec3, size: f64) -> Option<[Vec3; 2]> {
        if size <= 0.0 {
            return None;
        }
        let of = |m: Vec3| (m - unit * unit.dot(&m)) * (self.side / size);
        Some([of(d.uu.cross(&d.v) + d.u.cross(&d.uv)), of(d.uv.cross(&d.v) + d.u.cross(&d.vv))])
    }
}

/// The way from a contact to the moving point, and how it changes with the normal.
pub(crate) struct Reach {
    pub(crate) to: Vec3,
    frame: [Vec3; 2],
    radii: [f64; 2],
    /// By this all round, besides.
    even: f64,
}

impl Reach {
    /// Its derivative when the normal changes by `dn`.
    fn rate(&self, dn: Vec3) -> Vec3 {
        let along = |i: usize| self.frame[i] * (self.radii[i] * self.frame[i].dot(&dn));
        dn * self.even + along(0) + along(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_contact::PatchTree;
    use aptc_geometry::Cutter;
    use aptc_geometry::sculpt::{SplinePoint, mesh};
    use aptc_geometry::sculptured::BsplineSurface;

    fn waves() -> Sculptured {
        over(|x, y| aptc_geometry::trig::sin(0.4 * x) + 0.5 * aptc_geometry::trig::cos(0.3 * y))
    }

    fn over(z: impl Fn(f64, f64) -> f64) -> Sculptured {
        let rows: Vec<Vec<_>> = (0..5)
            .map(|j| {
                (0..6)
                    .map(|i| {
                        let (x, y) = (f64::from(i) * 2.0, f64::from(j) * 2.0);
                        SplinePoint::plain(Vec3::new(x, y, z(x, y)))
                    })
                    .collect()
            })
            .collect();
        mesh(&rows, aptc_geometry::sculptured::MeshSpacing::Xyz).unwrap()
    }

    #[test]
    fn a_point_pierces_and_a_ball_rests() {
        let s = waves();
        let shot = |probe| Shot {
            surface: &s,
            extent: s.extent(),
            ends: Ends::of(&s),
            side: 1.0,
            from: Vec3::new(3.3, 4.1, 20.0),
            along: -Vec3::z(),
            probe,
        };
        let tree = PatchTree::new(&s);
        let m = shot(Probe::Ball(0.0)).first(&tree).unwrap();
        assert!((m.at.point.xy() - Vec3::new(3.3, 4.1, 0.0).xy()).norm() < 1e-11);
        let m = shot(Probe::Ball(1.5)).first(&tree).unwrap();
        let centre = m.at.point + m.normal * 1.5;
        assert!((centre.xy() - Vec3::new(3.3, 4.1, 0.0).xy()).norm() < 1e-11);
        // Nothing of the surface is nearer to the centre.
        let near = aptc_geometry::sculpt::nearest_on(&s, centre);
        assert!((near.distance - 1.5).abs() < 1e-9, "{}", near.distance);
    }

    /// Over the top of a hill the flat of a cutter rests on the summit, wherever that is below it.
    #[test]
    fn a_flat_rests_on_a_summit() {
        let cos = aptc_geometry::trig::cos;
        let s = over(|x, y| cos(0.4 * (x - 5.0)) + 0.5 * cos(0.3 * (y - 4.0)));
        let summit = aptc_geometry::sculpt::nearest_on(&s, Vec3::new(5.0, 4.0, 40.0)).at.point;
        for r in [0.0, 0.4] {
            let profile = Profile::new(&Cutter::mill(4.0, r, 10.0)).unwrap();
            for off in [0.0, 0.3, -0.7] {
                let from = Vec3::new(summit.x + off, summit.y - 0.4, 20.0);
                let probe = Probe::Cutter { profile: &profile, ta: Vec3::z(), thick: 0.0 };
                let extent = s.extent();
                let (ends, along) = (Ends::of(&s), -Vec3::z());
                let shot = Shot { surface: &s, extent, ends, side: 1.0, from, along, probe };
                let tree = PatchTree::new(&s);
                let met = shot.first(&tree).unwrap();
                assert!((shot.fall(&tree).unwrap().way - met.way).abs() < 1e-7);
                let te = from - Vec3::z() * met.way;
                let tool = Tool { profile: &profile, te, ta: Vec3::z() };
                let (deepest, _) = tree.deepest(&tool, 1e-9).unwrap();
                assert!(deepest.distance.abs() < 1e-7, "{r} {off}: {deepest:?}");
            }
        }
    }

    /// A sphere of radius 25 that comes round along u, from pole to pole along v.
    fn sphere() -> Sculptured {
        const HALF: f64 = core::f64::consts::FRAC_1_SQRT_2;
        let ring = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [1, 0]];
        let outline = [[0, -1], [1, -1], [1, 0], [1, 1], [0, 1]];
        let weight = |i: usize| if i % 2 == 1 { HALF } else { 1.0 };
        let mut points = Vec::new();
        for (j, [r, z]) in outline.into_iter().enumerate() {
            for (i, [x, y]) in ring.into_iter().enumerate() {
                let [x, y, z] = [r * x, r * y, z].map(|c| 25.0 * f64::from(c));
                points.push([x, y, z, weight(i) * weight(j)]);
            }
        }
        let knots = |spans: u8| {
            let inner = (0..=spans).flat_map(|k| [f64::from(k); 2]);
            std::iter::once(0.0).chain(inner).chain([f64::from(spans)]).collect::<Vec<_>>()
        };
        let (surface, _) = aptc_geometry::sculpt::bspline(&BsplineSurface {
            degree: [2, 2],
            knots: [knots(4), knots(2)],
            counts: [9, 5],
            points,
            range: [None; 2],
        })
        .unwrap();
        surface
    }

    /// Beside a surface that closes there is nothing of it, and across its seam and over its poles it goes on.
    #[test]
    fn a_surface_that_closes_ends_nowhere() {
        let s = sphere();
        let [u, v] = s.borders();
        assert_eq!((u, v), ([Border::Seam; 2], [Border::Pole; 2]));
        let tree = PatchTree::new(&s);
        let shot = |x: f64, y: f64| Shot {
            surface: &s,
            extent: s.extent(),
            ends: Ends::of(&s),
            side: 1.0,
            from: Vec3::new(x, y, 60.0),
            along: -Vec3::z(),
            probe: Probe::Ball(4.0),
        };
        let height = |x: f64, y: f64| (29.0 * 29.0 - x * x - y * y).sqrt();
        for (x, y) in
            [(24.0, 10.0), (20.0, 0.0), (0.0, 0.0), (0.0, 1e-12), (0.0, 0.001), (24.0, -15.0)]
        {
            let met = shot(x, y).first(&tree).unwrap();
            assert!((60.0 - met.way - height(x, y)).abs() < 1e-6, "{x} {y}: {met:?}");
            let centre = met.at.point + met.normal * 4.0;
            assert!((centre - Vec3::new(x, y, height(x, y))).norm() < 1e-6, "{x} {y}: {met:?}");
            for turned in [[3.99, 1.5], [0.01, 1.5], [2.0, 1.97]] {
                let near = shot(x, y).near(turned);
                let same = |m: Met| (m.at.point - met.at.point).norm() < 1e-6;
                assert!(near.is_none_or(same), "{x} {y} from {turned:?}");
            }
        }
        for (x, y) in [(24.0, 17.0), (24.0, -17.0), (10.0, 30.0), (-28.0, 9.0)] {
            assert!(shot(x, y).first(&tree).is_none(), "{x} {y}");
        }
        // A little over the seam and over the pole from beside it.
        for (from, to) in [([3.97, 1.4], [25.0, 2.0]), ([2.0, 1.9], [3.0, -1.0])] {
            let met = shot(to[0], to[1]).near(from).unwrap();
            assert!((60.0 - met.way - height(to[0], to[1])).abs() < 1e-9, "{from:?}");
        }
    }

    /// Where the normal comes to the tool axis the search by normals jumps round the corner's circle; the other finds what the tool
    /// touches first when it comes from afar.
    #[test]
    fn a_bull_nose_is_led_round_its_corner() {
        let cos = aptc_geometry::trig::cos;
        let z = |x: f64, y: f64| {
            6.0 * cos(0.16 * x + 0.3) * cos(0.13 * y) + 3.0 * cos(0.23 * x - 0.11 * y)
        };
        let at = |k: u32| 10.0 * f64::from(k);
        let point = |i, j| SplinePoint::plain(Vec3::new(at(i), at(j), z(at(i), at(j))));
        let rows: Vec<Vec<_>> = (0..13).map(|j| (0..13).map(|i| point(i, j)).collect()).collect();
        let s = mesh(&rows, aptc_geometry::sculptured::MeshSpacing::Xyz).unwrap();
        let profile = Profile::new(&Cutter::mill(12.0, 2.0, 60.0)).unwrap();
        let probe = Probe::Cutter { profile: &profile, ta: Vec3::z(), thick: 0.0 };
        let (tree, extent) = (PatchTree::new(&s), s.extent());
        let (ends, along) = (Ends::of(&s), -Vec3::z());
        let shot = |x: f64, y: f64| {
            let from = Vec3::new(x, y, 60.0);
            Shot { surface: &s, extent, ends, side: 1.0, from, along, probe }
        };
        let mut led = 0;
        for j in 0..20 {
            let y = 12.0 + 5.0 * f64::from(j);
            let mut last = shot(10.0, y).touch(&tree).map(|m| m.uv);
            for i in 1..50 {
                let shot = shot(10.0 + 2.0 * f64::from(i), y);
                let first = shot.touch(&tree);
                if let Some(start) = last
                    && shot.near(start).is_none()
                    && let (Some(m), Some(first)) = (shot.beside(start, &tree), first)
                {
                    assert!((m.way - first.way).abs() < 1e-5, "{m:?} {first:?}");
                    led += 1;
                }
                last = first.map(|m| m.uv);
            }
        }
        assert!(led > 3, "{led}");
    }

    #[test]
    fn a_bull_nose_touches_and_does_not_gouge() {
        let s = waves();
        let profile = Profile::new(&Cutter::mill(2.0, 0.3, 10.0)).unwrap();
        let from = Vec3::new(5.2, 3.7, 20.0);
        let probe = Probe::Cutter { profile: &profile, ta: Vec3::z(), thick: 0.0 };
        let (extent, ends) = (s.extent(), Ends::of(&s));
        let shot = Shot { surface: &s, extent, ends, side: 1.0, from, along: -Vec3::z(), probe };
        let m = shot.first(&PatchTree::new(&s)).unwrap();
        let te = from - Vec3::z() * m.way;
        let tool = Tool { profile: &profile, te, ta: Vec3::z() };
        assert!(tool.distance(m.at.point).abs() < 1e-9);
        let mut least = f64::INFINITY;
        for i in 0..=250 {
            for j in 0..=200 {
                let q = s.at(f64::from(i) * 0.02, f64::from(j) * 0.02).point;
                least = least.min(tool.distance(q));
            }
        }
        assert!(least > -1e-9, "{least}");
    }
}
