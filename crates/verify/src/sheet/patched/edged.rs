//! Edges of a surface of charts: where its normal jumps, and whether a hollow or a ridge is there.

use aptc_geometry::Vec3;
use aptc_geometry::sculpt::Derivatives;

use super::{Chart, Jet, Kind, Patch, Patched, SMOOTH, Side, Spot, Tile};
use crate::solid::unit_or;

/// How sharp an edge is of which nothing is known: as three square faces are about their corner.
const UNKNOWN: f64 = 0.82;
/// Parts of a border at whose ends it is looked at.
const PARTS: u32 = 16;
/// Share of a chart beside a border that is one point at which the normals round it are looked at, how many times as far apart as in one
/// chart they are in all, and up to which half of the difference they count as one.
const BESIDE_POINT: f64 = 1e-4;
const ALL_ROUND: f64 = 4.0;
const BLUNT: f64 = 1e-3;
/// Share of the surface's size by which charts that meet lie apart.
const MEET: f64 = 1e-9;
/// Up to this share of it they are side by side.
const CRACKS: f64 = 1e-2;

/// The edges of a surface.
#[derive(Clone, Debug, Default)]
pub(crate) struct Edged {
    /// Is there one?
    pub(crate) any: bool,
    /// What closes the gaps at the hollow ones between charts that are known: they count as charts, behind the others.
    rolled: Vec<Rolled>,
    /// Those that are hollow, seen from the positive and from the negative side.
    pub(crate) hollow: [Vec<Hollow>; 2],
}

/// A hollow edge, or a corner at which one ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hollow {
    /// A ball that holds it.
    pub(crate) center: Vec3,
    pub(crate) radius: f64,
    /// Greatest sine of half the angle between the normals.
    pub(crate) half: f64,
    /// What closes the gap there, where the faces are known.
    pub(crate) rolled: Option<Patch>,
    /// How far apart the faces lie there at most, for they do not meet.
    pub(crate) crack: f64,
}

/// What closes the gap between faces that are moved back: places with all unit normals between those of the faces there.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Rolled {
    /// A border that two charts share: by the parameter along it and by the share from one normal to the other.
    Edge {
        charts: [usize; 2],
        /// The parameter that is constant along it, and its value in either chart.
        k: usize,
        across: [f64; 2],
    },
    /// A corner of four charts, in their order round it: by the shares from the first to the second and from the first to the last.
    Corner([Spot; 4]),
}

/// Is one of two derivatives but rounding, as at a border that is one point? The normal is rounding, too.
pub(crate) fn bare([u, v]: [Vec3; 2]) -> bool {
    /// Share of the other that it is.
    const NONE: f64 = 1e-9;
    let (u, v) = (u.norm(), v.norm());
    u.min(v) <= NONE * u.max(v)
}

impl Rolled {
    /// What is made of a part of it on the faces beside it; of an edge each stands twice.
    fn on_faces<T: Copy>(&self, patch: &Patch, make: impl Fn(Patch) -> T) -> [T; 4] {
        match self {
            Self::Edge { charts, k, across } => {
                let [a, b] = [0, 1].map(|i: usize| {
                    let (mut at, mut half) = ([across[i]; 2], [0.0; 2]);
                    (at[1 - k], half[1 - k]) = (patch.at[0], patch.half[0]);
                    make(Patch { chart: charts[i], at, half, ..Patch::default() })
                });
                [a, b, b, a]
            }
            Self::Corner(spots) => {
                spots.map(|s| make(Patch { chart: s.chart, at: s.at, ..Patch::default() }))
            }
        }
    }

    /// Between the normals of the faces, by two shares or, of an edge, by the second.
    fn between(&self, [a, b, c, d]: [Vec3; 4], at: [f64; 2]) -> Vec3 {
        let blend = |p: Vec3, q: Vec3, share: f64| p * (1.0 - share) + q * share;
        match self {
            Self::Edge { .. } => blend(a, b, at[1]),
            Self::Corner(_) => blend(blend(a, b, at[0]), blend(d, c, at[0]), at[1]),
        }
    }

    /// The parameter of the faces that runs along it.
    fn along(&self) -> Option<usize> {
        match self {
            Self::Edge { k, .. } => Some(1 - k),
            Self::Corner(_) => None,
        }
    }
}

impl Patched {
    /// What edges the surface has, inside, where it closes and where a border runs together in a point.
    pub(crate) fn edged(&self) -> &Edged {
        self.edged.get_or_init(|| {
            let mut all = Edged::default();
            for chart in (0..self.charts.len()).filter(|chart| !self.charts[*chart].none) {
                let smooth = self.smooth(chart);
                for (k, end) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                    if !smooth[k][end] {
                        self.look_over(chart, k, end, &mut all);
                    }
                }
            }
            all
        })
    }

    /// How the surface turns at an end of a chart, which is not smooth.
    fn look_over(&self, chart: usize, k: usize, end: usize, all: &mut Edged) {
        let columns = self.columns();
        let counts = [columns, self.charts.len() / columns];
        let place = [chart % columns, chart / columns];
        let last = place[k] == if end == 0 { 0 } else { counts[k] - 1 };
        let side = &self.grid.sides[k];
        if last && [side.before, side.behind][end].is_some() {
            // It ends, far out.
            return;
        }
        let one = &self.charts[chart];
        let next = beside(place, counts, k, end == 1);
        let other = &self.charts[next[0] + columns * next[1]];
        // On the border of the cell: beyond, it goes on as there.
        let [from, to] =
            one.range[1 - k].map(|t| t.clamp(one.within[1 - k][0], one.within[1 - k][1]));
        let at = |chart: &Chart, t: f64, across: f64| {
            let mut at = [across; 2];
            at[1 - k] = from + (to - from) * t;
            self.at(chart, at)
        };
        let (border, point, end_at) = (one.range[k][end], one.points[k][end], end as f64);
        // Of a point both sides are parts of the one chart, half of the border apart, and a little away.
        let [near, there, sense, least] = if point {
            let near = border + (0.5 - end_at) * BESIDE_POINT;
            [near, near, 1.0 - 2.0 * end_at, BLUNT]
        } else {
            let there = if last { other.range[k][1 - end] } else { border };
            [border, there, 2.0 * end_at - 1.0, SMOOTH]
        };
        let both = |t: f64| {
            let far = if point { at(one, (t + 0.5).fract(), there) } else { at(other, t, there) };
            [at(one, t, near), far]
        };
        let size = self.nodes.last().map_or(0.0, |root| root.radius);
        let joins = side.joins(place[k], end);
        let mut sharpest = if joins { [0.0_f64; 2] } else { [UNKNOWN; 2] };
        let (mut cracked, mut steps) = (false, 0.0_f64);
        let mut before: Option<Vec3> = None;
        for i in (0..=PARTS).filter(|_| joins) {
            let [a, b] = both(f64::from(i) / f64::from(PARTS));
            if !point && (a.point - b.point).norm() > MEET * size {
                if last || one.none || other.none {
                    // Nothing is beside it.
                    return;
                }
                cracked = true;
            }
            let told = |d: &Derivatives| if bare([d.u, d.v]) { None } else { d.normal() };
            let Some((m, n)) = told(&a).zip(told(&b)) else { continue };
            // How the normals of the other face change from one look to the next, farther than a crack reaches.
            steps = before.replace(n).map_or(steps, |b| steps.max((b - n).norm()));
            let half = 0.5 * (m - n).norm();
            let half = if point { half.max(UNKNOWN.min(ALL_ROUND * half)) } else { half };
            if half > least {
                // Seen from where it rises from the first face it is a hollow.
                let into = if k == 0 { b.u } else { b.v } * sense;
                let seen = usize::from(m.dot(&into) <= 0.0);
                sharpest[seen] = sharpest[seen].max(half);
            }
        }
        if cracked {
            self.crack(place, (k, end), sharpest.map(|half| half + steps), all);
            return;
        }
        if sharpest.iter().all(|half| *half <= 0.0) {
            return;
        }
        all.any = true;
        let known = joins && !point;
        // Of two charts that share a border the first has it.
        if known && end == 0 && !other.none {
            return;
        }
        let (center, radius) = self.ball_of(one, k, border);
        let charts = [chart, next[0] + columns * next[1]];
        let mut rolled = |rolled: Rolled, [from, to]: [f64; 2]| {
            all.rolled.push(rolled);
            let (at, half) = ([0.5 * (from + to), 0.5], [0.5 * (to - from), 0.5]);
            let chart = self.charts.len() + all.rolled.len() - 1;
            Patch { chart, at, half, ..Patch::default() }
        };
        let edge = Rolled::Edge { charts, k, across: [near, there] };
        let edge = known.then(|| rolled(edge, one.range[1 - k]));
        let corners = [0, 1].map(|to| {
            let corner = self.corner([place, next], k, [end, to]).filter(|_| known)?;
            Some((self.look(&corner[0]).0.p, rolled(Rolled::Corner(corner), [0.0, 1.0])))
        });
        if known {
            self.reentrant([place, next], (k, end), all);
        }
        for (found, half) in all.hollow.iter_mut().zip(sharpest).filter(|(_, half)| *half > 0.0) {
            let crack = 0.0;
            found.push(Hollow { center, radius, half, rolled: edge, crack });
            for (center, corner) in corners.iter().flatten() {
                let (center, rolled) = (*center, Some(*corner));
                found.push(Hollow { center, radius: 0.0, half, rolled, crack });
            }
        }
    }

    /// Ends of an edge about which three faces lie and a hole: what closes gaps at edges leaves one there of which nothing is known.
    fn reentrant(&self, both: [[usize; 2]; 2], (k, end): (usize, usize), all: &mut Edged) {
        let columns = self.columns();
        let counts = [columns, self.charts.len() / columns];
        for to in [0, 1] {
            let behind = both.map(|at| beside(at, counts, 1 - k, to == 1));
            let charts = behind.map(|at| &self.charts[at[0] + columns * at[1]]);
            if charts[0].none == charts[1].none {
                continue;
            }
            let chart = both[0][0] + columns * both[0][1];
            let mut at = [self.charts[chart].range[k][end]; 2];
            at[1 - k] = self.charts[chart].range[1 - k][to];
            let center = self.look(&Spot { chart, at }).0.p;
            for found in &mut all.hollow {
                let (radius, half, rolled, crack) = (0.0, UNKNOWN, None, 0.0);
                found.push(Hollow { center, radius, half, rolled, crack });
            }
        }
    }

    /// A border within the surface along which the faces do not meet, as patches that were fitted apart do not: a hollow from both sides.
    ///
    /// With `half` the greatest half of the difference between the normals, whatever direction lies between
    /// both normals at a place is no farther from one of them than by the angle of that sine. About an end up to four faces meet: a
    /// direction among their normals is no farther from one of them than any two of these are from each other. So there the whole of
    /// the difference counts for the half, and all that is between the ends too. The place of the other face next to it may be one beside
    /// that with the same parameter: `half` has how far the normals turn up to there.
    fn crack(&self, place: [usize; 2], (k, end): (usize, usize), half: [f64; 2], all: &mut Edged) {
        let columns = self.columns();
        let counts = [columns, self.charts.len() / columns];
        let next = beside(place, counts, k, end == 1);
        let charts = [place, next].map(|at| at[0] + columns * at[1]);
        let [one, other] = charts.map(|at| &self.charts[at]);
        let border = one.range[k][end];
        let ahead = [0, 1].map(|to| one.range[1 - k][to] - one.within[1 - k][to]);
        let beyond = if one.range[1 - k][0] >= one.within[1 - k][1] { ahead[1] } else { ahead[0] };
        // Beyond its cell a chart lies all of it.
        let goes_on = one.range[1 - k][0] < one.within[1 - k][0] || beyond > 0.0;
        let at = |chart: &Chart, share: f64| {
            let mut at = [border; 2];
            at[1 - k] = one.range[1 - k][0] + (one.range[1 - k][1] - one.range[1 - k][0]) * share;
            self.at(chart, at)
        };
        let apart = match &self.kind {
            // Both go straight on, from one place but for a gap; along the line of the other it may be as far as that goes.
            Kind::Sculpted(_) if goes_on => {
                let share = if beyond > 0.0 { 0.0 } else { 1.0 };
                let [a, b] = [one, other].map(|chart| at(chart, share));
                let [to, along] = [a, b].map(|d| if k == 0 { d.v } else { d.u });
                let leaves = to.cross(&along).norm() / along.norm();
                let most = (a.point - b.point).norm() + beyond.abs() * leaves;
                most.is_finite().then_some(most)
            }
            Kind::Sculpted(s) => s.apart([one.cell, other.cell], k, end),
            _ => None,
        };
        let mut half = half[0].max(half[1]);
        for i in 0..=PARTS {
            let share = f64::from(i) / f64::from(PARTS);
            let normals = at(one, share).normal().zip(at(other, share).normal());
            half = half.max(normals.map_or(UNKNOWN, |(m, n)| 0.5 * (m - n).norm()));
        }
        let size = self.nodes.last().map_or(0.0, |root| root.radius);
        // On the border; beyond its ends the faces go on straight from there, and may part.
        let ends = [0, 1].map(|to| {
            let behind = [place, next].map(|at| beside(at, counts, 1 - k, to == 1));
            let corner = [place, next, behind[0], behind[1]].map(|at| at[0] + columns * at[1]);
            let at = one.range[1 - k][to];
            let looks = corner.map(|chart| {
                let chart = &self.charts[chart];
                let mut spot = [at; 2];
                spot[k] = border;
                for (x, [low, high]) in spot.iter_mut().zip(chart.range) {
                    *x = x.clamp(low, high);
                }
                self.at(chart, spot)
            });
            let first = looks[0].point;
            // Those that go round the end of the surface lie elsewhere.
            let here = |d: &&Derivatives| (d.point - first).norm() <= CRACKS * size;
            let near: Vec<&Derivatives> = looks.iter().filter(here).collect();
            let mut most = [0.0_f64; 2];
            for (i, a) in near.iter().enumerate() {
                for b in &near[i + 1..] {
                    let normals = a.normal().zip(b.normal());
                    let turned = normals.map_or(UNKNOWN, |(m, n)| (m - n).norm());
                    most = [most[0].max(turned), most[1].max((a.point - b.point).norm())];
                }
            }
            // Elsewhere all four lie along one border of two patches, and `apart` tells.
            let corner = match &self.kind {
                Kind::Sculpted(_) if goes_on => (to == 0) == (beyond > 0.0),
                Kind::Sculpted(s) => s.is_corner(one.cell, 1 - k, to),
                _ => true,
            };
            if corner { most } else { [most[0], 0.0] }
        });
        let (turned, wide) =
            ends.iter().fold((0.0_f64, 0.0_f64), |m, e| (m.0.max(e[0]), m.1.max(e[1])));
        let half = turned.max(2.0 * half).max(SMOOTH);
        let (half, crack) = match apart.filter(|_| half < UNKNOWN) {
            Some(apart) => (half, apart.max(wide)),
            None => (UNKNOWN, 0.0),
        };
        all.any = true;
        let (center, radius) = self.ball_of(one, k, border);
        for found in &mut all.hollow {
            found.push(Hollow { center, radius, half, rolled: None, crack });
        }
    }

    /// The corner of four charts at an end `to` of the border between two of them, the first at its end `end` by the parameter `k`;
    /// `None` where the surface ends there.
    fn corner(
        &self,
        places: [[usize; 2]; 2],
        k: usize,
        [end, to]: [usize; 2],
    ) -> Option<[Spot; 4]> {
        let columns = self.columns();
        let counts = [columns, self.charts.len() / columns];
        let [one, next] = places;
        let behind = places.map(|place| beside(place, counts, 1 - k, to == 1));
        let spot = |place: [usize; 2], across: usize, along: usize| {
            let chart = place[0] + columns * place[1];
            let mut at = [0.0; 2];
            (at[k], at[1 - k]) =
                (self.charts[chart].range[k][across], self.charts[chart].range[1 - k][along]);
            Spot { chart, at }
        };
        let all = [
            spot(one, end, to),
            spot(next, 1 - end, to),
            spot(behind[1], 1 - end, 1 - to),
            spot(behind[0], end, 1 - to),
        ];
        let size = self.nodes.last().map_or(0.0, |root| root.radius);
        let first = self.look(&all[0]).0.p;
        let meets = |s: &Spot| {
            !self.charts[s.chart].none && (self.look(s).0.p - first).norm() <= MEET * size
        };
        all.iter().all(meets).then_some(all)
    }

    /// What closes a gap and counts as a chart with this number.
    pub(crate) fn on_rolled(&self, chart: usize) -> Option<&Rolled> {
        let n = chart.checked_sub(self.charts.len())?;
        self.edged.get()?.rolled.get(n)
    }

    /// The same place on a face beside the edge.
    pub(crate) fn on_face(&self, spot: Spot) -> Spot {
        let at = Patch { at: spot.at, ..Patch::default() };
        self.on_rolled(spot.chart).map_or(spot, |rolled| rolled.on_faces(&at, |p| p)[0].spot())
    }

    /// A place of what closes a gap, with one of its normals.
    pub(crate) fn rolled_jet(&self, rolled: &Rolled, spot: &Spot) -> Jet {
        let at = Patch { at: spot.at, ..Patch::default() };
        let faces = rolled.on_faces(&at, |face| self.look(&face.spot()).0);
        let n = rolled.between(faces.map(|jet| jet.n), spot.at);
        let along = rolled.along().map_or_else(Vec3::zeros, |along| faces[0].d[along]);
        Jet { p: faces[0].p, d: [along, Vec3::zeros()], n: unit_or(n, faces[0].n) }
    }

    /// What holds a part of it, by what holds it on the faces.
    ///
    /// With t the most by which a normal of a face turns along it, b what is between the normals of the faces from the middle of the
    /// part on and l the least length of that, a unit normal is off by no more than t and b over l.
    pub(crate) fn rolled_tile(
        &self,
        rolled: &Rolled,
        patch: &Patch,
        made: impl Fn(Patch) -> Tile,
    ) -> Tile {
        /// Of unit vectors any two differ by no more.
        const MOST: f64 = 2.0;
        let none = Vec3::zeros();
        let faces = rolled.on_faces(patch, made);
        let normals = faces.map(|face| face.n);
        let n = rolled.between(normals, patch.at);
        let [a, b, c, d] = normals;
        let Some(along) = rolled.along() else {
            let by = [(b - a).norm().max((c - d).norm()), (d - a).norm().max((c - b).norm())];
            let by = [0, 1].map(|i| patch.half[i] * by[i]);
            let least = n.norm() - by[0] - by[1];
            let turn = by.map(|x| if least > 0.0 { (x / least).min(MOST) } else { x * MOST });
            let n = unit_or(n, a);
            return Tile {
                side: [none; 2],
                bend: [none; 3],
                vary: [0.0; 3],
                stray: [0.0; 2],
                n,
                turn,
                ..faces[0]
            };
        };
        let turn = faces[0].turn[along].max(faces[1].turn[along]);
        let h = patch.half[1];
        let from_to = h * ((a - b).norm() + 2.0 * turn);
        // Of unit vectors the middle of both is the shortest between them.
        let shortest = 0.5_f64.clamp(patch.at[1] - h, patch.at[1] + h);
        let least = (a * (1.0 - shortest) + b * shortest).norm() - turn;
        let by = |x: f64| if least > 0.0 { (x / least).min(MOST) } else { MOST };
        Tile {
            c: faces[0].c,
            side: [faces[0].side[along], none],
            stray: [faces[0].stray[along], 0.0],
            bend: [faces[0].bend[2 * along], none, none],
            vary: [faces[0].vary[2 * along], 0.0, 0.0],
            n: unit_or(n, a),
            turn: [by(turn), by(from_to)],
        }
    }

    /// A ball about a border of a chart, with its continuation.
    fn ball_of(&self, chart: &Chart, k: usize, border: f64) -> (Vec3, f64) {
        let [low, high] = chart.range[1 - k];
        let at = |i: u32| {
            let mut at = [border; 2];
            at[1 - k] = low + (high - low) * f64::from(i) / f64::from(PARTS);
            self.at(chart, at).point
        };
        let line: Vec<Vec3> = (0..=PARTS).map(at).collect();
        let center = (line[0] + line[line.len() - 1]) * 0.5;
        let gap = line.windows(2).map(|w| (w[1] - w[0]).norm()).fold(0.0, f64::max);
        let radius = line.iter().map(|p| (p - center).norm()).fold(0.0, f64::max);
        (center, radius + gap)
    }

    /// What is at a place and, beside a border of its chart, at the same place of the charts there, also where the surface closes.
    pub(crate) fn around(&self, spot: &Spot) -> Vec<Jet> {
        /// Share of a chart up to which a place is beside its border.
        const BESIDE: f64 = 1e-2;
        let columns = self.columns();
        let counts = [columns, self.charts.len() / columns];
        let place = [spot.chart % columns, spot.chart / columns];
        let here = &self.charts[spot.chart];
        let upper = [0, 1].map(|k| spot.at[k] > 0.5 * (here.range[k][0] + here.range[k][1]));
        let close = [0, 1].map(|k| {
            let [low, high] = here.range[k];
            let border = if upper[k] { high } else { low };
            (spot.at[k] - border).abs() <= BESIDE * (high - low)
        });
        let mut all = vec![self.jet(spot)];
        let size = BESIDE * self.nodes.last().map_or(0.0, |root| root.radius);
        for over in [[true, false], [false, true], [true, true]] {
            if (0..2).any(|k| over[k] && !close[k]) {
                continue;
            }
            let across = || (0..2).filter(|k| over[*k]);
            let next = across().fold(place, |place, k| beside(place, counts, k, upper[k]));
            let chart = next[0] + columns * next[1];
            let mut at = spot.at;
            across().for_each(|k| at[k] = self.charts[chart].range[k][usize::from(!upper[k])]);
            let jet = self.jet(&Spot { chart, at });
            // Of a surface that does not close the first chart is not beside the last.
            if !self.charts[chart].none && (jet.p - all[0].p).norm() <= size {
                all.push(jet);
            }
        }
        all
    }
}

impl Side {
    /// Does a cell, counted with the continuation, touch the one before it (`end` 0) or behind it?
    pub(crate) fn joins(&self, cell: usize, end: usize) -> bool {
        let Some(n) = self.loose else { return true };
        let (behind, first) = (cell + end, usize::from(self.before.is_some()));
        let all = self.knots.len() - 1;
        // What goes on does so from one patch.
        let goes_on = |k: usize| k == 0 && first == 1 || k == all && self.behind.is_some();
        behind.checked_sub(first).is_some_and(|k| k % n != 0 || goes_on(k))
    }
}

/// Column and row of the chart beside one along the parameter `k`: behind the last comes the first.
fn beside(mut place: [usize; 2], counts: [usize; 2], k: usize, upper: bool) -> [usize; 2] {
    place[k] = (place[k] + if upper { 1 } else { counts[k] - 1 }) % counts[k];
    place
}
