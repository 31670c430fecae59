//! Where a tool comes to rest on one to three surfaces: the least way, a way along a direction, in a plane.
//!
//! APT: `CENTR`, `CENTR2`.

use aptc_contact::{Condition, Gap, Side, opens};
use aptc_geometry::{Fiop, Form, Plane, Surface, Vec3};
use aptc_protap::OptionSurface;

use super::band::AIM_TURNING;
use super::keep::{Keep, Pose};
use super::start::Aim;
use crate::axis::{Around, AxisRule, UPRIGHT};
use crate::failure::Failure;
use crate::scene::Wall;

/// Rounds of the iteration.
const ROUNDS: usize = 200;
/// Rounds in which it must come nearer by this part at least with a fixed axis: each may be a search all round the tool. One
/// that turns comes to rest by steps that are made ever shorter.
const IDLE: usize = 40;
const NEARER: f64 = 0.01;
/// The same for an axis that turns with the place.
const TURNS: usize = 30;
/// Rounds of an axis at one place after which its turn must become less each time.
const SETTLED: usize = 5;
/// Steps, however short, that may lead no nearer.
const MOST_STUCK: u32 = 3;

/// Surfaces with the gaps that the tool is to have, and the rule of its axis.
pub(super) struct Solver<'a> {
    pub(super) aims: &'a [Aim<'a>],
    pub(super) axis: &'a AxisRule,
    /// Where an upright axis leans.
    pub(super) onwards: Vec3,
    /// A plane in which the tool end stays: its unit normal and the distance of its points along it.
    pub(super) held: Option<(Vec3, f64)>,
}

impl Solver<'_> {
    /// The place nearest to `origin` at which all conditions hold where they are linear.
    fn least(&self, origin: Vec3, pose: &Pose, gaps: &[Gap], targets: &[f64]) -> Option<Vec3> {
        let way = pose.te - origin;
        let row = |(g, t): (&Gap, &f64)| (g.normal, t - g.g + g.normal.dot(&way));
        let held = self.held.map(|(n, d)| (n, d - n.dot(&origin)));
        let rows: Vec<(Vec3, f64)> = gaps.iter().zip(targets).map(row).chain(held).collect();
        least(&rows).map(|step| origin + step)
    }

    /// The plane through the line along `v` that is squarest to the course of both surfaces at `from`: in it the tool moves
    /// along `v`, forward or back, and along the part surface.
    ///
    /// With t the direction in which the surfaces meet, its normal is t less the part of it along v; none when t is along v.
    /// Source: what APT-360 does.
    pub(super) fn plane_along(&self, from: Pose, v: Vec3) -> Result<Option<(Vec3, f64)>, Failure> {
        let gaps = self.gaps(&from, None)?;
        let [a, b] = gaps.as_slice() else { return Ok(None) };
        let t = a.normal.cross(&b.normal);
        let n = (t - v * t.dot(&v)).try_normalize(1e-6);
        Ok(n.map(|n| (n, n.dot(&from.te))))
    }

    /// Is the nearest position meant? Near the bottom of a hollow, along a polyconic and with an axis that turns the place of
    /// contact moves far with the least step, and where steps from one to the next end would hang on rounding.
    fn nearest_of_all(&self, ta: Vec3) -> bool {
        let touches = |a: &Aim<'_>| a.keep.condition == Condition::Touch;
        let inside = |a: &Aim<'_>| a.keep.side != Side::Positive && opens(&a.keep.surface, ta);
        let polyconic = |a: &Aim<'_>| matches!(a.wall.surface.form.shape(), Form::Polyconic(_));
        self.axis.turns() || self.aims.iter().any(|a| touches(a) && (inside(a) || polyconic(a)))
    }

    /// Where the directions given for the surfaces bring the tool: each pierces its surface from the middle of the
    /// cutter, and leaves room for its radius, the thickness and the band. One that misses takes the tool along by three
    /// quarters of the gap there. Source: what APT-360 does.
    pub(super) fn approach(&self, pose: Pose) -> Pose {
        let mut te = pose.te;
        for aim in self.aims {
            let Some(v) = aim.along else { continue };
            let keep = &aim.keep;
            let middle = te + pose.ta * (0.5 * keep.profile.height());
            te += v * match keep.surface.directed_distance(middle, v, Fiop::Ahead) {
                Ok(hit) if aim.wall.on => hit.distance - keep.width(),
                Ok(hit) => hit.distance - keep.profile.half_diameter() - keep.thick - keep.width(),
                Err(_) => {
                    let apart = keep.gap(&Pose { te, ..pose }, None);
                    0.75 * apart.map_or_else(|_| keep.surface.distance(te), |g| g.g).abs()
                }
            };
        }
        Pose { te, ..pose }
    }

    /// The position from a start on one of the planes: from above a wall that leans or ends the way there is not
    /// seen, from its foot it is.
    pub(super) fn by_a_plane(&self, home: Pose) -> Option<Pose> {
        let planes = self.aims.iter().filter(|a| a.keep.is_plane());
        planes.filter(|_| self.aims.len() > 1).find_map(|plane| {
            let level = Pose { te: plane.keep.surface.foot(home.te).point, ..home };
            self.nearest(self.approach(level), home).ok()
        })
    }

    /// Where it is best begun. Above an open hollow, where only the walls that run on straight up face the tool, it is let down
    /// first: into the hollow, and before to what else it is to touch and meets on the way there.
    pub(super) fn let_down(&self, pose: Pose) -> (Pose, Option<Pose>) {
        let above = |a: &&Aim<'_>| {
            let beside = |g: Gap| g.normal.dot(&pose.ta).abs() <= 1e-9;
            a.keep.side == Side::Open
                && a.along.is_none()
                && a.keep.gap(&pose, None).is_ok_and(beside)
        };
        let Some(hollow) = self.aims.iter().find(above) else { return (pose, None) };
        let Some(floor) = self.run(hollow, pose, -pose.ta) else { return (pose, None) };
        let way = |p: &Pose| (p.te - pose.te).norm();
        let touches = |a: &&Aim<'_>| a.keep.condition == Condition::Touch;
        let downs = self.aims.iter().filter(touches).filter_map(|a| self.run(a, pose, -pose.ta));
        let first = downs.min_by(|a, b| way(a).total_cmp(&way(b)));
        (floor, first.filter(|p| way(p) < way(&floor)))
    }

    fn gaps(&self, pose: &Pose, last: Option<&[Gap]>) -> Result<Vec<Gap>, Failure> {
        self.aims
            .iter()
            .enumerate()
            .map(|(i, a)| {
                let start = last.and_then(|l| l.get(i)).map(Gap::spot);
                a.keep
                    .gap(pose, start)
                    .or_else(|_| flattened(&a.keep, pose).gap(pose, None))
                    .map_err(|_| Failure::NoContact { surface: a.wall.surface.clone() })
            })
            .collect()
    }

    /// The width of the narrowest band.
    pub(super) fn narrowest(&self) -> f64 {
        self.aims.iter().map(|a| a.keep.width()).fold(f64::INFINITY, f64::min)
    }

    /// Gap asked of each surface at a contact: within the band, outside at round and inside at hollow ones,
    /// so that the motion that follows has the whole band for its first cut vector. A flank that an axis lays along a
    /// surface touches all along it: what is not told apart there stays away from the border of the band.
    fn targets(&self, pose: &Pose, gaps: &[Gap]) -> Vec<f64> {
        let asked = self.wanted(pose, gaps);
        if !self.axis.turns() {
            return asked;
        }
        let inside = |(a, t): (&Aim<'_>, f64)| {
            let alike = self.alike(pose, &a.keep) / a.keep.width();
            a.keep.inside(t, alike.max(AIM_TURNING))
        };
        self.aims.iter().zip(asked).map(inside).collect()
    }

    fn wanted(&self, pose: &Pose, gaps: &[Gap]) -> Vec<f64> {
        self.aims
            .iter()
            .enumerate()
            .map(|(i, a)| {
                if a.keep.is_plane() {
                    return 0.0;
                }
                let other = gaps.get(if i == 0 { 1 } else { 0 }).map(|g| g.normal);
                let along = other.map(|n| gaps[i].normal.cross(&n)).filter(|t| t.norm() > 1e-6);
                let Some(t) = along else { return 0.0 };
                // A tool whose axis turns with the surface bends as the surface does, whatever touches it.
                let bend = if self.axis.turns() {
                    let shape = a.keep.surface.foot(gaps[i].surface_point).shape;
                    a.keep.side.sign() * shape.second(t.normalize())
                } else {
                    a.keep.bend(pose, &gaps[i], t.normalize())
                };
                a.keep.onwards(pose, bend)
            })
            .collect()
    }

    fn turned(&self, pose: &Pose, gaps: &[Gap]) -> Vec3 {
        if !self.axis.turns() {
            return pose.ta;
        }
        let drive = &gaps[0];
        let part = gaps.get(1).unwrap_or(drive);
        let keeps = [&self.aims[0].keep, self.aims.get(1).map_or(&self.aims[0].keep, |a| &a.keep)];
        let [on_drive, on_part] = [drive, part].map(|g| g.segment.is_none());
        let at = |rule: &AxisRule| {
            let came = match rule {
                AxisRule::Angle(_, came) if on_drive || on_part => came.home(),
                _ => 1.0,
            };
            // The direction of the motion that follows is not known; this one is APT-360's guess.
            let along = part.normal.cross(&drive.normal) * came;
            let along = if along.norm() > 1e-9 { along.normalize() } else { Vec3::x() };
            // The rule asks its sign only.
            let control = if rule.normal_of() == Some(OptionSurface::Part) { part } else { drive };
            let upright = control.normal.dot(&pose.ta).abs() <= UPRIGHT;
            let ta = if upright { pose.ta + self.onwards * (2.0 * UPRIGHT) } else { pose.ta };
            let around = Around { te: pose.te, ta, part, drive, along };
            rule.at(&around, keeps)
        };
        let ta = at(self.axis);
        // On its way there the tool leans as it did where it came from. Once there the side is that of the axis that belongs
        // to this place: the one of the round before leaned with the normal elsewhere.
        let there = |i: usize, g: &Gap| g.g.abs() <= self.aims[i].keep.width();
        let on = match self.axis.angle_to() {
            Some(OptionSurface::Part) if on_drive && there(0, drive) => drive.normal,
            Some(OptionSurface::Drive) if on_part && gaps.len() > 1 && there(1, part) => {
                part.normal
            }
            _ => return ta.unwrap_or(pose.ta),
        };
        ta.and_then(|ta| at(&self.axis.leaning(ta, on))).unwrap_or(pose.ta)
    }

    /// The position near `from` that satisfies all surfaces.
    ///
    /// Each round moves the tool by the least vector that satisfies the surfaces where they are linear; a round
    /// that makes the gaps worse is shortened. The vector is the least one from where the tool is, and the position that
    /// of APT-360, found by trial; else it is the least from the start, and the position the nearest one.
    pub(super) fn nearest(&self, from: Pose, home: Pose) -> Result<Pose, Failure> {
        let mut pose = from;
        let mut gaps = self.gaps(&pose, None)?;
        let mut best_step = f64::INFINITY;
        let mut factor: f64 = 1.0;
        let mut closest = (f64::INFINITY, from, gaps.clone());
        let pinned = self.nearest_of_all(from.ta);
        // With an axis that turns the gaps asked for keep so far from the edge.
        let strict = !self.axis.turns();
        let band = self.narrowest();
        let mut targets = self.targets(&pose, &gaps);
        let mut progress = Progress::default();
        for _ in 0..ROUNDS {
            let ta = self.turned(&pose, &gaps);
            let origin = if pinned { from.te } else { pose.te };
            let to = self
                .least(origin, &pose, &gaps, &targets)
                .ok_or_else(|| self.impossible(home, &closest))?;
            let step = to - pose.te;
            let size = step.norm();
            // Near the end the rounds must come closer; far from it surfaces may bend away.
            if size > 0.95 * best_step {
                factor = (0.7 * factor).max(0.05);
            }
            best_step = best_step.min(size);
            let turn = (ta - pose.ta).norm();
            pose = Pose { te: pose.te + step * factor, ta };
            gaps = self.gaps(&pose, Some(&gaps))?;
            let off = gaps.iter().zip(&targets).map(|(g, t)| (g.g - t).abs()).fold(0.0, f64::max);
            if off < closest.0 {
                closest = (off, pose, gaps.clone());
            }
            if off > band {
                // Within the band they stay: asked for anew at an edge they would never come to rest.
                targets = self.targets(&pose, &gaps);
            }
            let scale = self.size(&pose) + size;
            if size <= 1e-13 * scale && turn <= 1e-11 && off <= 1e-13 * scale {
                if !self.deeper(&pose, &mut gaps, strict) {
                    return Ok(pose);
                }
                (best_step, factor, progress) = (f64::INFINITY, 1.0, Progress::default());
            }
            if strict && off > band && progress.is_over(off) {
                break;
            }
        }
        // The least way is not known to the last digit; the place on the surfaces shall be.
        let strictly = strict.then(|| self.settle(pose, gaps.clone(), true)).flatten();
        strictly
            .or_else(|| self.settle(pose, gaps, false))
            .or_else(|| self.axis.turns().then(|| self.settle_turning(pose)).flatten())
            .or_else(|| self.near_enough(&closest))
            .ok_or_else(|| self.impossible(home, &closest))
    }

    /// A side that lies along a ruling touches at all of it: with an axis that turns the place of contact, and
    /// the axis with it, then jumps within the band for ever. Inside of the band is near enough there.
    fn near_enough(&self, (off, pose, gaps): &(f64, Pose, Vec<Gap>)) -> Option<Pose> {
        let least = self.narrowest();
        let inside = |(a, g): (&Aim<'_>, &Gap)| {
            // Another place of it may be deeper by as much as counts as one.
            let (limits, alike) = (a.keep.limits(), self.alike(pose, &a.keep));
            (limits.low + alike..=limits.high).contains(&g.g)
        };
        let all_inside = |gaps: &[Gap]| self.aims.iter().zip(gaps).all(inside);
        if !self.axis.turns() || *off > least || !all_inside(gaps) {
            return None;
        }
        let mut deepest = gaps.clone();
        (!self.deeper(pose, &mut deepest, false) || all_inside(&deepest)).then_some(*pose)
    }

    /// The nearest place on all surfaces, by Newton's method with steps of least length.
    fn settle(&self, mut pose: Pose, mut gaps: Vec<Gap>, strict: bool) -> Option<Pose> {
        // Where a surface bends otherwise on the other side of an edge, gaps that are asked for anew each round
        // would never come to rest; these lie within the band too.
        let targets = self.targets(&pose, &gaps);
        let band = self.narrowest();
        let mut progress = Progress::default();
        for _ in 0..ROUNDS {
            let off = gaps.iter().zip(&targets).map(|(g, t)| (g.g - t).abs()).fold(0.0, f64::max);
            if !self.axis.turns() && off > band && progress.is_over(off) {
                return None;
            }
            let enough = 1e-13 * self.size(&pose) + 1e-9 * self.aims[0].keep.width();
            if off <= enough {
                if !self.deeper(&pose, &mut gaps, strict) {
                    return Some(pose);
                }
                progress = Progress::default();
            }
            let te = self.least(pose.te, &pose, &gaps, &targets)?;
            pose = Pose { te, ta: self.turned(&pose, &gaps) };
            gaps = self.gaps(&pose, Some(&gaps)).ok()?;
        }
        None
    }

    /// The same where the axis turns with the place: how the gaps change with it is then found by differences.
    fn settle_turning(&self, from: Pose) -> Option<Pose> {
        let step = 1e-6 * self.size(&from);
        let (mut pose, mut gaps) = self.with_axis(from)?;
        let targets = self.targets(&pose, &gaps);
        let off = |gaps: &[Gap]| {
            gaps.iter().zip(&targets).map(|(g, t)| (g.g - t).abs()).fold(0.0, f64::max)
        };
        let enough = 1e-13 * self.size(&from) + 1e-9 * self.aims[0].keep.width();
        let mut stuck = 0;
        for _ in 0..TURNS {
            let worst = off(&gaps);
            if worst <= enough && !self.deeper(&pose, &mut gaps, false) {
                return Some(pose);
            }
            let mut slopes = vec![Vec3::zeros(); gaps.len()];
            for i in 0..3 {
                let mut beside = pose;
                beside.te[i] += step;
                let (_, other) = self.with_axis(beside)?;
                for (slope, (a, b)) in slopes.iter_mut().zip(gaps.iter().zip(&other)) {
                    slope[i] = (b.g - a.g) / step;
                }
            }
            let rows: Option<Vec<(Vec3, f64)>> = slopes
                .iter()
                .zip(gaps.iter().zip(&targets))
                .map(|(n, (g, t))| {
                    let size = n.norm();
                    (size > 1e-6).then(|| (n / size, (t - g.g) / size))
                })
                .collect();
            let held = self.held.map(|(n, d)| (n, d - n.dot(&pose.te)));
            let rows: Vec<(Vec3, f64)> = rows?.into_iter().chain(held).collect();
            let by = least(&rows)?;
            let mut share = 1.0;
            let next = loop {
                let next = self.with_axis(Pose { te: pose.te + by * share, ..pose })?;
                if off(&next.1) < worst {
                    break next;
                }
                if share < 1e-3 {
                    stuck += 1;
                    break next;
                }
                share *= 0.5;
            };
            if stuck > MOST_STUCK {
                return None;
            }
            (pose, gaps) = next;
        }
        None
    }

    /// The tool at its place with the axis that belongs there.
    fn with_axis(&self, mut pose: Pose) -> Option<(Pose, Vec<Gap>)> {
        let mut gaps = self.gaps(&pose, None).ok()?;
        let mut last = f64::INFINITY;
        for round in 0..TURNS {
            let ta = self.turned(&pose, &gaps);
            let turn = (ta - pose.ta).norm();
            pose.ta = ta;
            gaps = self.gaps(&pose, Some(&gaps)).ok()?;
            // Where the place of contact goes to and fro no axis belongs to the place.
            if turn <= 1e-12 || round >= SETTLED && turn > 0.9 * last {
                break;
            }
            last = turn;
        }
        Some((pose, gaps))
    }

    /// A length of the size of the scene.
    pub(super) fn size(&self, pose: &Pose) -> f64 {
        let of = |a: &Aim<'_>| a.keep.surface.extent() + a.keep.profile.reach();
        pose.te.norm() + self.aims.iter().map(of).fold(0.0, f64::max)
    }

    /// Gaps at two places of the cutter that differ by less count as one.
    fn alike(&self, pose: &Pose, keep: &Keep) -> f64 {
        1e-10 * self.size(pose) + 1e-8 * keep.width()
    }

    /// Replaces gaps where the cutter touches elsewhere first; if `strict` also where what counts as one is beyond the band.
    fn deeper(&self, pose: &Pose, gaps: &mut [Gap], strict: bool) -> bool {
        let mut any = false;
        for (aim, gap) in self.aims.iter().zip(gaps) {
            let alike = self.alike(pose, &aim.keep);
            let room = (gap.g - aim.keep.limits().low).max(1e-13 * self.size(pose));
            let exact = if strict { alike.min(room) } else { alike };
            if let Some(deeper) = aim.keep.deeper_on(pose, gap, exact, (true, 0.0)).0 {
                *gap = deeper;
                any = true;
            }
        }
        any
    }

    /// Why there is no position: a hollow too tight for the cutter, or how near it came.
    fn impossible(&self, home: Pose, closest: &(f64, Pose, Vec<Gap>)) -> Failure {
        for aim in self.aims {
            let q = aim.keep.surface.foot(home.te).point;
            if let Some(radius) = aim.keep.too_tight(q) {
                let (surface, cutter) = (aim.wall.surface.clone(), aim.keep.profile.widest());
                return Failure::TooLarge { surface, radius, cutter };
            }
        }
        let (_, pose, gaps) = closest;
        let mut gaps = gaps.clone();
        let there = |(a, g): (&Aim<'_>, &Gap)| g.g.abs() <= 2.0 * a.keep.width();
        let elsewhere =
            self.aims.iter().zip(&gaps).all(there) && self.deeper(pose, &mut gaps, false);
        let left =
            self.aims.iter().zip(&gaps).map(|(a, g)| (a.wall.surface.clone(), g.g)).collect();
        Failure::NoStart {
            left,
            place: Some(pose.te),
            others: Vec::new(),
            surfaces: self.aims.iter().map(|a| a.wall.surface.clone()).collect(),
            why: match elsewhere {
                true => "where it comes to them, another part of the cutter is in one of them",
                false => "no common position was found",
            },
        }
    }

    /// Exactly along the direction to the one surface.
    pub(super) fn along(&self, pose: Pose, v: Vec3) -> Result<Pose, Failure> {
        let Some(aim) = self.aims.first() else { return Ok(pose) };
        self.run(aim, pose, v).ok_or_else(|| Failure::Misses {
            surface: aim.wall.surface.clone(),
            closest: aim.keep.gap(&pose, None).map_or(0.0, |g| g.g.abs()),
        })
    }

    /// OFFSET: pierces the drive surface, moves out along its normal, then along the axis to the part.
    pub(super) fn offset(&self, pose: Pose, v: Vec3) -> Result<Pose, Failure> {
        let Some(aim) = self.aims.first() else { return Ok(pose) };
        let misses = |w: &Wall| Failure::Misses {
            surface: w.surface.clone(),
            closest: aim.keep.surface.distance(pose.te).abs(),
        };
        let hit = aim
            .keep
            .surface
            .directed_distance(pose.te, v, Fiop::Ahead)
            .map_err(|_| misses(aim.wall))?;
        let mut at = Pose { te: hit.point, ..pose };
        if !aim.wall.on {
            let normal = aim.keep.surface.foot(hit.point).normal * aim.keep.side.sign();
            at = self.run(aim, at, normal).ok_or_else(|| misses(aim.wall))?;
        }
        for aim in &self.aims[1..] {
            // Up or down, whichever is nearer: a bowl has a place above too.
            let ways = [at.ta, -at.ta].into_iter().filter_map(|v| self.run(aim, at, v));
            let far = |p: &Pose| (p.te - at.te).norm();
            at = ways.min_by(|a, b| far(a).total_cmp(&far(b))).ok_or_else(|| misses(aim.wall))?;
        }
        Ok(at)
    }

    /// The first place along `v` where the tool is at the surface, by steps no longer than the gap and
    /// Newton's method at the end.
    fn run(&self, aim: &Aim<'_>, from: Pose, v: Vec3) -> Option<Pose> {
        let (mut s, mut last) = (0.0_f64, None);
        let mut outside = None;
        for _ in 0..ROUNDS {
            let pose = Pose { te: from.te + v * s, ..from };
            let gap = aim.keep.gap(&pose, last).ok()?;
            last = Some(gap.spot());
            let scale = self.size(&pose);
            if gap.g.abs() <= 1e-13 * scale {
                return Some(pose);
            }
            let slope = gap.normal.dot(&v);
            let began_outside = *outside.get_or_insert(gap.g > 0.0);
            // The gap changes no faster than the tool moves: a step of its size passes nothing.
            let newton = -gap.g / slope;
            let step =
                if newton > 0.0 && newton < 2.0 * gap.g.abs() { newton } else { gap.g.abs() };
            if newton < 0.0 && (gap.g > 0.0) != began_outside {
                s += newton;
            } else {
                s += step;
            }
            if s > 1e9 * scale || s < -1e-9 * scale {
                return None;
            }
        }
        None
    }
}

/// Whether rounds still come nearer.
#[derive(Default)]
struct Progress {
    best: Option<f64>,
    idle: usize,
}

impl Progress {
    /// Has none of some rounds come nearer?
    fn is_over(&mut self, off: f64) -> bool {
        self.idle += 1;
        if self.best.is_none_or(|best| off < best * (1.0 - NEARER)) {
            (self.best, self.idle) = (Some(off), 0);
        }
        self.idle >= IDLE
    }
}

/// The least vector with the components asked for along one to three directions.
fn least(rows: &[(Vec3, f64)]) -> Option<Vec3> {
    match *rows {
        [(a, s)] => Some(a * s),
        [(a, s), (b, t)] => {
            let c = a.dot(&b);
            let det = 1.0 - c * c;
            (det > 1e-12).then(|| a * ((s - c * t) / det) + b * ((t - c * s) / det))
        }
        [(a, s), (b, t), (c, u)] => {
            let det = a.cross(&b).dot(&c);
            (det.abs() > 1e-9).then(|| (b.cross(&c) * s + c.cross(&a) * t + a.cross(&b) * u) / det)
        }
        _ => None,
    }
}

/// The surface's tangent plane nearest to the tool end in its place: far from a bounded surface the cutter has
/// no place that faces it, and the plane tells the way there.
pub(super) fn flattened(keep: &Keep, pose: &Pose) -> Keep {
    let foot = keep.surface.foot(pose.te);
    let plane = Plane { n: foot.normal, d: foot.normal.dot(&foot.point) };
    Keep { surface: Surface::Plane(plane), ..keep.clone() }
}
