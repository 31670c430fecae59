//! A judge of cut vectors: a search over the skin of the tool with the distances of `geometry`.

use std::sync::Arc;

use aptc_cldata::milling::{Milled, Milling, Plain, Raised};
use aptc_cldata::{Control, Controlled, Position, Relation};
use aptc_geometry::surface::{continued, kept};
use aptc_geometry::{Cutter, Form, Profile, Sculptured, Surface, Vec3, trig};

use crate::support::brute;

/// Everything that a motion is asked for.
pub(crate) struct Brute {
    pub(crate) profile: Profile,
    along: Vec<Asked>,
    nets: Vec<Net>,
    check: Option<Asked>,
    /// Cutter, holder and the axis between them, and the surfaces that all keep off.
    solids: Vec<Raised>,
    beside: Vec<Beside>,
    /// The nets that the holder keeps off too.
    held: Vec<bool>,
}

impl Brute {
    /// The tool comes from `from`.
    pub(crate) fn new(cutter: &Cutter, control: &Control, from: &Position) -> Option<Self> {
        let along = control.drive.iter().chain(&control.part);
        let milling = control.milling.iter();
        let nets = milling.flat_map(|m| {
            let part = m.part.iter().map(|p| Net::milled(p, m.on, m));
            part.chain(m.checked.iter().map(|c| Net::milled(c, false, m)))
        });
        let profile = Profile::new(cutter).ok()?;
        let milling = || control.milling.iter();
        let holder = milling().flat_map(|m| m.holder.iter().copied());
        let mut solids: Vec<_> =
            std::iter::once(Raised { profile, up: 0.0 }).chain(holder).collect();
        let above: Vec<_> = solids[1..].iter().map(|s| (s.profile, s.up)).collect();
        let allowed = milling().map(|m| m.intol).next().unwrap_or(0.0);
        let rod = kept::between(&profile, &above, allowed);
        solids.extend(rod.map(|(profile, up)| Raised { profile, up }));
        let beside = milling()
            .flat_map(|m| m.plain.iter().map(|p| Beside::new(p, m.intol, &solids, from)))
            .collect::<Option<_>>()?;
        Some(Self {
            profile,
            solids,
            beside,
            held: milling()
                .flat_map(|m| {
                    let part = m.part.iter().map(|_| m.guarded);
                    part.chain(m.checked.iter().map(|_| true))
                })
                .collect(),
            along: along.map(|c| Asked::new(c, false)).collect::<Option<_>>()?,
            nets: nets.collect(),
            check: match control.checks.first() {
                Some(c) => Some(Asked::new(c, true)?),
                None => None,
            },
        })
    }

    pub(crate) fn at(&self, pose: &Position, last: bool) -> f64 {
        let beside = self.beside.iter().map(|b| b.excess(&self.solids, pose));
        let held = self.nets.iter().zip(&self.held).filter(|(_, held)| **held);
        let above = held.flat_map(|(net, _)| {
            self.solids[1..].iter().map(|s| {
                let raised = Position { te: pose.te + pose.ta * s.up, ..*pose };
                net.excess(&s.profile, &raised)
            })
        });

        let along = self.along.iter().map(|a| a.excess(&self.profile, pose));
        let check = self.check.iter().filter(|_| last).map(|a| a.excess(&self.profile, pose));
        let nets = self.nets.iter().map(|n| n.excess(&self.profile, pose));
        along.chain(check).chain(nets).chain(beside).chain(above).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The room at a place between shank and holder and the surfaces beside them; negative in one.
    pub(crate) fn room(&self, at: &Position) -> f64 {
        let beside = self.beside.iter().map(|b| -b.intol - b.excess(&self.solids[1..], at));
        beside.fold(f64::INFINITY, f64::min)
    }

    /// The greatest excess along a motion at `n` places of each vector.
    pub(crate) fn worst(&self, start: &Position, points: &[Position], n: u32) -> f64 {
        let mut worst = f64::NEG_INFINITY;
        let mut from = *start;
        for (i, to) in points.iter().enumerate() {
            for k in 0..=n {
                let last = i + 1 == points.len() && k == n;
                let place = between(&from, to, f64::from(k) / f64::from(n));
                worst = worst.max(self.at(&place, last));
            }
            from = *to;
        }
        worst
    }
}

/// A surface that is asked for, with its band.
struct Asked {
    surface: Surface,
    sign: f64,
    on: bool,
    band: [f64; 2],
    /// Its points, where the distance from it is not to be had far away.
    net: Option<Net>,
}

impl Asked {
    fn new(c: &Controlled, check: bool) -> Option<Self> {
        let on = c.side == 0 || c.relation == Relation::On;
        let surface = Surface::from_form(&c.form)?;
        let flat = matches!(surface, Surface::Plane(_));
        let widest = c.intol.max(c.outtol);
        let mut band = match (on, flat) {
            (true, true) => [-widest, widest],
            (true, false) => [-c.intol, c.outtol],
            _ => [c.thick - c.intol, c.thick + c.outtol],
        };
        if check && matches!(c.relation, Relation::Tanto | Relation::Pstan) {
            band[1] = f64::INFINITY;
        }
        let sign = if c.side < 0 && !on { -1.0 } else { 1.0 };
        let net = Net::guiding(c, band, on);
        Some(Self { surface, sign, on, band, net })
    }

    /// By how much the band is left, negative within it.
    fn excess(&self, profile: &Profile, at: &Position) -> f64 {
        if let Some(net) = &self.net {
            return net.excess(profile, at);
        }
        let gap = if self.on {
            self.surface.distance(at.te)
        } else {
            brute::least(profile, at.te, at.ta, &self.surface, self.sign)
        };
        (self.band[0] - gap).max(gap - self.band[1])
    }
}

/// A sculptured surface by its points.
struct Net {
    surface: Arc<Sculptured>,
    /// Least u and v, steps along them, and the points, those of the first v first.
    from: [f64; 2],
    step: [f64; 2],
    points: Vec<Vec3>,
    on: bool,
    band: [f64; 2],
}

/// Points of a net on a side.
const SIDE: usize = 120;

impl Net {
    fn milled(of: &Milled, on: bool, milling: &Milling) -> Self {
        let widest = milling.intol.max(milling.outtol);
        let band = if on { [-widest, widest] } else { [of.thick - milling.intol, f64::INFINITY] };
        let range = of.surface.spans().map(|n| [0.0, n]);
        Self::new(Arc::new(Sculptured::clone(&of.surface)), range, on, band)
    }

    /// A surface that guides the tool, with its continuation; on which side the tool is it does not tell.
    fn guiding(c: &Controlled, band: [f64; 2], on: bool) -> Option<Self> {
        let Form::Ssurf(definition) = c.form.shape() else { return None };
        let whole = continued(definition)?;
        let spans = whole.surface.spans();
        let range = [(whole.u, spans[0]), (whole.v, spans[1])].map(|(r, n)| r.map(|x| x * n));
        Some(Self::new(Arc::new(whole.surface), range, on, band))
    }

    fn new(surface: Arc<Sculptured>, range: [[f64; 2]; 2], on: bool, band: [f64; 2]) -> Self {
        let from = range.map(|r| r[0]);
        let step = range.map(|r| (r[1] - r[0]) / (SIDE - 1) as f64);
        let at = |k: usize| {
            let (i, j) = (k % SIDE, k / SIDE);
            surface.at(from[0] + i as f64 * step[0], from[1] + j as f64 * step[1]).point
        };
        let points = (0..SIDE * SIDE).map(at).collect();
        Self { surface, from, step, points, on, band }
    }

    /// The least distance of the surface from the tool, or from its end: the best points, searched on.
    fn excess(&self, profile: &Profile, at: &Position) -> f64 {
        let far = |p: Vec3| {
            let w = p - at.te;
            let z = w.dot(&at.ta);
            if self.on { w.norm() } else { profile.near((w - at.ta * z).norm(), z).distance }
        };
        let all: Vec<f64> = self.points.iter().map(|p| far(*p)).collect();
        let lowest = |k: &usize| {
            let (i, j) = (k % SIDE, k / SIDE);
            let beside = [(i > 0, k.wrapping_sub(1)), (i + 1 < SIDE, k + 1)];
            let across = [(j > 0, k.wrapping_sub(SIDE)), (j + 1 < SIDE, k + SIDE)];
            beside.into_iter().chain(across).all(|(is, n)| !is || all[n] >= all[*k])
        };
        let mut places: Vec<usize> = (0..all.len()).filter(lowest).collect();
        places.sort_by(|a, b| all[*a].total_cmp(&all[*b]));
        let top = [0, 1].map(|i| self.from[i] + self.step[i] * (SIDE - 1) as f64);
        let down = |k: usize| {
            let steps = [k % SIDE, k / SIDE];
            let mut place = [0, 1].map(|i| self.from[i] + steps[i] as f64 * self.step[i]);
            let (mut least, mut share) = (all[k], 1.0);
            while share > 1e-7 {
                let mut moved = false;
                for way in
                    [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0], [1.0, 1.0], [-1.0, -1.0]]
                {
                    let next = [0, 1].map(|i| {
                        (place[i] + way[i] * share * self.step[i]).clamp(self.from[i], top[i])
                    });
                    let d = far(self.surface.at(next[0], next[1]).point);
                    if d < least {
                        (least, place, moved) = (d, next, true);
                    }
                }
                share *= if moved { 1.0 } else { 0.5 };
            }
            least
        };
        let gap = places.into_iter().take(6).map(down).fold(f64::INFINITY, f64::min);
        (self.band[0] - gap).max(gap - self.band[1])
    }
}

/// A checked plane, sphere, cylinder or cone: cutter and holder on one side of it.
struct Beside {
    surface: Surface,
    sign: f64,
    /// Is its hollow open along the tool axis?
    open: bool,
    intol: f64,
}

impl Beside {
    /// The side is that of the cutter's lower end at `from`, before the motion. `None` of other surfaces.
    fn new(of: &Plain, intol: f64, solids: &[Raised], from: &Position) -> Option<Self> {
        use Surface::{Cone, Cylinder, Plane, Sphere};
        let surface = Surface::from_form(&of.form)?;
        let (round, flat) =
            (matches!(surface, Sphere(_) | Cylinder(_)), matches!(surface, Plane(_) | Cone(_)));
        if !round && !flat {
            return None;
        }
        let cutter = solids.first()?.profile;
        let up = cutter.widest().min(0.5 * cutter.height());
        let sign = 1.0_f64.copysign(surface.distance(from.te + from.ta * up));
        let mut new = Self { surface, sign, open: false, intol };
        if sign > 0.0 || matches!(new.surface, Plane(_)) {
            return Some(new);
        }
        // A bowl or a trough is open above. The inside of a cone, and of a cylinder that may open or not as the tool leans,
        // is left to the tests of the proof.
        let stands = match &new.surface {
            Cylinder(s) => s.axis.dot(&from.ta).abs(),
            Cone(_) => return None,
            _ => 0.0,
        };
        new.open = stands < 0.6;
        (new.open || stands > 0.8).then_some(new)
    }

    /// How far a point is from it, positive on the side of the tool.
    fn distance(&self, p: Vec3, ta: Vec3) -> f64 {
        let closed = self.sign * self.surface.distance(p);
        if !self.open {
            return closed;
        }
        // Above the widest place the wall goes straight up.
        match &self.surface {
            Surface::Sphere(s) => {
                let w = p - s.center;
                let up = w.dot(&ta);
                if up > 0.0 { s.radius - (w - ta * up).norm() } else { closed }
            }
            Surface::Cylinder(s) => {
                let w = p - s.point;
                let w = w - s.axis * w.dot(&s.axis);
                let side = s.axis.cross(&ta).normalize();
                if w.dot(&ta) > 0.0 { s.radius - w.dot(&side).abs() } else { closed }
            }
            _ => closed,
        }
    }

    /// The same of a solid that has the middle of a ball or a rod in it, which no point of its skin tells: no point of these is
    /// deeper in them than their radius.
    fn about_axis(&self, profile: &Profile, te: Vec3, ta: Vec3) -> f64 {
        let near = |p: Vec3| {
            let w = p - te;
            let z = w.dot(&ta);
            profile.near((w - ta * z).norm(), z).distance
        };
        match &self.surface {
            Surface::Sphere(s) if self.sign > 0.0 => near(s.center) - s.radius,
            Surface::Cylinder(s) if self.sign > 0.0 => {
                // Along the axis the distance is convex.
                let at = |t: f64| near(s.point + s.axis * t);
                let middle = (te - s.point).dot(&s.axis);
                let (mut a, mut b) = (middle - profile.reach(), middle + profile.reach());
                for _ in 0..120 {
                    let (x, y) = ((2.0 * a + b) / 3.0, (a + 2.0 * b) / 3.0);
                    (a, b) = if at(x) < at(y) { (a, y) } else { (x, b) };
                }
                at(0.5 * (a + b)) - s.radius
            }
            _ => f64::INFINITY,
        }
    }

    /// How far the cutter or what is above it reaches over to the other side, beyond what is allowed.
    fn excess(&self, solids: &[Raised], at: &Position) -> f64 {
        let least = |s: &Raised| {
            let te = at.te + at.ta * s.up;
            let by_skin = brute::lowest(&s.profile, te, at.ta, |p| self.distance(p, at.ta));
            by_skin.min(self.about_axis(&s.profile, te, at.ta))
        };
        -self.intol - solids.iter().map(least).fold(f64::INFINITY, f64::min)
    }
}

/// Tool end straight on, tool axis turning evenly.
pub(crate) fn between(a: &Position, b: &Position, t: f64) -> Position {
    let te = a.te + (b.te - a.te) * t;
    let turn = trig::angle_between(a.ta, b.ta);
    let s = trig::sin(turn);
    let ta = if s > 1e-12 {
        a.ta * (trig::sin((1.0 - t) * turn) / s) + b.ta * (trig::sin(t * turn) / s)
    } else {
        a.ta
    };
    Position { te, ta: ta.normalize() }
}
