//! Outlines on loose patches (COMBIN), whose parameters do not run through from patch to patch.
//!
//! Corners are laid into the grid that the patches make. A line from patch to patch is cut where it crosses a joint in space, and what
//! the outline holds of each patch gets an outline of its own, closed along the borders of the patch: so each place is judged by the
//! lines of its own patch.

use std::borrow::Cow;

use aptc_cldata::milling::Outline;
use aptc_geometry::{Sculptured, Vec3};

/// Parameters so near to a joint are on it.
const AT_JOINT: f64 = 1e-6;
/// How far inside of a patch is looked whether its border is held.
const INSIDE: f64 = 1e-9;
/// Places of a joint that are looked at for each of its patches, and halvings between two.
const PLACES: u32 = 32;
const HALVINGS: u32 = 60;
/// Share of the surface's size up to which two places are one.
const SAME: f64 = 1e-9;
/// Share of the surface's size by which the ends of two patches of a row may part.
const PART: f64 = 1e-6;

/// Why a line is not cut.
const NO_JOINT: &str = "its outline goes from one patch of its surface to another, and no joint of the two is found where it does";

/// Loose patches as they lie side by side; in their row where they do not fit together.
pub(crate) struct Joined<'a> {
    grid: Cow<'a, Sculptured>,
    loose: bool,
    /// How far the place at which a line crosses a joint may be beside the line.
    room: f64,
}

/// The way of an outline from corner to corner.
struct Way {
    ends: [[f64; 2]; 2],
    places: [Vec3; 2],
    /// Square to the plane in which it crosses joints.
    square: Vec3,
}

impl<'a> Joined<'a> {
    pub(crate) fn new(surface: &'a Sculptured, room: f64) -> Self {
        let together = surface.together();
        let loose = together.is_none();
        let grid = together.map_or(Cow::Borrowed(surface), Cow::Owned);
        Self { grid, loose, room }
    }

    pub(crate) fn grid(&self) -> &Sculptured {
        &self.grid
    }

    /// Corners by the parameters of the grid, on a joint where they are near one. In a row of patches the end of one that is no
    /// joint stays in its patch.
    pub(crate) fn laid(&self, corners: &[[f64; 2]]) -> Option<Vec<[f64; 2]>> {
        let end = self.grid.spans()[0];
        let own = |[u, v]: [f64; 2]| {
            let level = on_joint(u);
            let inner = self.loose && same(level, level.round()) && level > 0.0 && level < end;
            if inner && !self.is_joint(0, level, v) {
                [if u < level { level - INSIDE } else { level + INSIDE }, v]
            } else {
                [level, on_joint(v)]
            }
        };
        corners.iter().map(|at| self.grid.laid_at(*at).map(own)).collect()
    }

    /// The corners with those between them at which the outline crosses joints.
    pub(crate) fn crossed(&self, corners: &[[f64; 2]]) -> Result<Vec<[f64; 2]>, &'static str> {
        let mut all = Vec::with_capacity(corners.len());
        for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            all.push(*a);
            self.cross(*a, *b, &mut all)?;
        }
        Ok(all)
    }

    /// Adds the places between two corners at which the way between them crosses joints.
    fn cross(&self, a: [f64; 2], b: [f64; 2], all: &mut Vec<[f64; 2]>) -> Result<(), &'static str> {
        let spans = self.grid.spans();
        // Where the surface closes the shorter way round.
        let over = [0, 1].map(|k| {
            let ways = (a[k] - b[k]) / spans[k];
            let goes = ways.abs() > 0.5 + SAME && self.grid.closes(k);
            if goes { ways.round() * spans[k] } else { 0.0 }
        });
        let b = [0, 1].map(|k| b[k] + over[k]);
        if cell_of(a, b).is_some() {
            return Ok(());
        }
        let mut met: Vec<(f64, [f64; 2])> = Vec::new();
        let border = (0..2).find(|k| {
            let on = |x: f64| (a[*k] - x).abs() + (b[*k] - x).abs() <= AT_JOINT;
            on(0.0) || on(spans[*k])
        });
        let way = self.way(a, b);
        for axis in 0..2 {
            let (low, high) = (a[axis].min(b[axis]), a[axis].max(b[axis]));
            let mut level = low.floor() + 1.0;
            while level < high {
                let found = match border {
                    // Along a border of the surface it goes straight.
                    Some(_) => {
                        let share = (level - a[axis]) / (b[axis] - a[axis]);
                        let mut at = [0, 1].map(|k| a[k] + (b[k] - a[k]) * share);
                        at[axis] = level;
                        Some((share, at))
                    }
                    None => way.as_ref().and_then(|way| self.meets(way, axis, level)),
                };
                met.push(found.ok_or(NO_JOINT)?);
                level += 1.0;
            }
        }
        met.sort_by(|p, q| p.0.total_cmp(&q.0));
        let mut last = a;
        for (_, at) in met.into_iter().chain([(1.0, b)]) {
            if cell_of(last, at).is_none() {
                return Err(NO_JOINT);
            }
            if !one(last, a) {
                self.put(last, over, all);
            }
            last = at;
        }
        Ok(())
    }

    /// A place of a way that may go over an end of the surface to where that begins: there it is put twice.
    fn put(&self, at: [f64; 2], over: [f64; 2], all: &mut Vec<[f64; 2]>) {
        let spans = self.grid.spans();
        let rolled = [0, 1].map(|k| at[k] - (at[k] / spans[k]).floor() * spans[k]);
        let own = |k: usize, end: f64| {
            if over[k] == 0.0 {
                at[k]
            } else if rolled[k] == 0.0 {
                end * spans[k]
            } else {
                rolled[k]
            }
        };
        let rises = |k: usize| if over[k] > 0.0 { [1.0, 0.0] } else { [0.0, 1.0] };
        let [before, behind] = [0, 1].map(|i| [0, 1].map(|k| own(k, rises(k)[i])));
        all.push(before);
        if !one(behind, before) {
            all.push(behind);
        }
    }

    fn place(&self, at: [f64; 2]) -> Vec3 {
        self.grid.at(at[0], at[1]).point
    }

    fn way(&self, a: [f64; 2], b: [f64; 2]) -> Option<Way> {
        let spans = self.grid.spans();
        let within = |x: [f64; 2]| {
            [0, 1].map(
                |k| if x[k] < 0.0 || x[k] > spans[k] { x[k].rem_euclid(spans[k]) } else { x[k] },
            )
        };
        let places = [a, b].map(|x| self.place(within(x)));
        let normals = [a, b].map(within).map(|[u, v]| self.grid.normal_at(u, v));
        let normal = match normals {
            [Some(m), Some(n)] => m + n,
            [m, n] => m.or(n)?,
        };
        let along = (places[1] - places[0]).try_normalize(SAME * self.grid.extent())?;
        let square = along.cross(&normal).try_normalize(SAME)?;
        Some(Way { ends: [a, b], places, square })
    }

    /// Where a way crosses the joint at which a parameter has this value: how far along, and the place.
    fn meets(&self, way: &Way, axis: usize, level: f64) -> Option<(f64, [f64; 2])> {
        let spans = self.grid.spans();
        let (across, end) = (1 - axis, spans[1 - axis]);
        let on = level.rem_euclid(spans[axis]);
        let at = |t: f64, x: f64| {
            let mut at = [t; 2];
            at[axis] = x;
            at
        };
        let [p, q] = way.places;
        let chord = q - p;
        let off = |t: f64| (self.place(at(t, on)) - p).dot(&way.square);
        let share = |t: f64| (self.place(at(t, on)) - p).dot(&chord) / chord.norm_squared();
        let beside = |t: f64| {
            let to = self.place(at(t, on)) - p;
            (to - chord * share(t).clamp(0.0, 1.0)).norm()
        };
        let n = PLACES * u32::try_from(whole(end)).unwrap_or(1).clamp(1, 10_000);
        let places: Vec<(f64, f64)> =
            (0..=n).map(|i| end * f64::from(i) / f64::from(n)).map(|t| (t, off(t))).collect();
        let none = SAME * self.grid.extent();
        let mut found: Vec<f64> =
            places.iter().filter(|x| x.1.abs() <= none).map(|x| x.0).collect();
        for w in places.windows(2) {
            if (w[0].1 > 0.0) == (w[1].1 > 0.0) {
                continue;
            }
            let (mut low, mut high) = (w[0].0, w[1].0);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                if (off(middle) > 0.0) == (w[0].1 > 0.0) { low = middle } else { high = middle }
            }
            found.push(0.5 * (low + high));
        }
        if found.is_empty() {
            // Beside the end of the joint, by less than counts.
            let ends = [places.first()?, places.last()?];
            found.extend(ends.iter().filter(|x| x.1.abs() <= self.room).map(|x| x.0));
        }
        let far = 0.5 * chord.norm() + self.room;
        let t = found.into_iter().min_by(|a, b| beside(*a).total_cmp(&beside(*b)))?;
        (beside(t) <= far && self.is_joint(axis, on, t)).then_some(())?;
        // Over the end of a surface that closes across too.
        let [a, b] = way.ends.map(|x| x[across]);
        let ways = if self.grid.closes(across) { [0.0, -end, end] } else { [0.0; 3] };
        let from = |t: f64| (t - 0.5 * (a + b)).abs();
        let t = ways
            .map(|w| t + w)
            .into_iter()
            .fold(f64::INFINITY, |x, y| if from(y) < from(x) { y } else { x });
        let mut place = at(on_joint(t), level);
        place[axis] = level;
        Some((share(t.rem_euclid(end)), place))
    }

    /// Do the patches on both sides go on there? Those of a grid do.
    fn is_joint(&self, axis: usize, level: f64, t: f64) -> bool {
        if !self.loose {
            return true;
        }
        let n = whole(level);
        let [before, behind] = [self.grid.at_span(n, 1.0, t), self.grid.at_span(n + 1, 0.0, t)];
        let apart = before.zip(behind).map(|(a, b)| (a.point - b.point).norm());
        axis == 0 && apart.is_some_and(|x| x <= PART * self.grid.extent())
    }

    /// What an outline in the grid holds, by the parameters of each patch.
    pub(crate) fn by_patch(&self, outline: &Outline) -> Result<Outline, &'static str> {
        let [columns, rows] = self.grid.spans().map(|n| whole(n).max(1));
        let mut pieces: Vec<Vec<[[f64; 2]; 2]>> = vec![Vec::new(); columns * rows];
        let mut all = Outline { lines: Vec::new(), along: outline.along };
        for line in &outline.lines {
            let line = line.map(|end| end.map(on_joint));
            all.lines.push(line);
            for piece in split(line) {
                // What lies along a joint is in no patch.
                let along =
                    (0..2).any(|k| same(piece[0][k], piece[1][k]) && piece[0][k].fract() == 0.0);
                if let Some([i, j]) = cell_of(piece[0], piece[1]).filter(|_| !along)
                    && i < columns
                    && j < rows
                {
                    pieces[j * columns + i].push(piece);
                }
            }
        }
        let mut lines = Vec::new();
        for (k, pieces) in pieces.iter().enumerate() {
            let cell = [k % columns, k / columns];
            let border = border(&all, pieces, cell).ok_or("its outline is not closed")?;
            for line in pieces.iter().chain(&border) {
                let [a, b] = line.map(|at| self.grid.told_in(cell, at));
                lines.extend(a.zip(b).map(|(a, b)| [a, b]));
            }
        }
        Ok(Outline { lines, along: 0 })
    }
}

#[expect(clippy::cast_possible_truncation, reason = "a number of patches")]
fn whole(x: f64) -> usize {
    x.round().max(0.0) as usize
}

fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 0.0
}

fn one(a: [f64; 2], b: [f64; 2]) -> bool {
    (0..2).all(|k| same(a[k], b[k]))
}

/// A parameter so near to a joint that it is on it is that of the joint.
fn on_joint(x: f64) -> f64 {
    let joint = x.round();
    if (x - joint).abs() <= AT_JOINT { joint } else { x }
}

/// The cell that holds both places, on its borders too.
fn cell_of(a: [f64; 2], b: [f64; 2]) -> Option<[usize; 2]> {
    let cell = [0, 1].map(|k| (0.5 * (a[k] + b[k])).floor());
    let low = [0, 1].map(|k| {
        let on = same(a[k], b[k]) && same(a[k], cell[k]) && a[k] > 0.0;
        if on { a[k] - 1.0 } else { cell[k] }
    });
    let within = [a, b].iter().all(|x| (0..2).all(|k| x[k] >= low[k] && x[k] <= low[k] + 1.0));
    within.then(|| low.map(whole))
}

/// A line in parts that lie in one cell each.
fn split([a, b]: [[f64; 2]; 2]) -> Vec<[[f64; 2]; 2]> {
    let mut cuts = vec![(0.0, a), (1.0, b)];
    for k in 0..2 {
        let (low, high) = (a[k].min(b[k]), a[k].max(b[k]));
        let mut level = low.floor() + 1.0;
        while level < high {
            let share = (level - a[k]) / (b[k] - a[k]);
            let mut at = [0, 1].map(|i| a[i] + (b[i] - a[i]) * share);
            at[k] = level;
            // Through a corner of four cells.
            at[1 - k] = on_joint(at[1 - k]);
            cuts.push((share, at));
            level += 1.0;
        }
    }
    cuts.sort_by(|p, q| p.0.total_cmp(&q.0));
    cuts.windows(2).map(|w| [w[0].1, w[1].1]).filter(|[a, b]| !one(*a, *b)).collect()
}

/// What of the border of a cell closes the pieces of an outline in it: between the places where they come to it, in turn.
fn border(all: &Outline, pieces: &[[[f64; 2]; 2]], cell: [usize; 2]) -> Option<Vec<[[f64; 2]; 2]>> {
    let from = cell.map(|i| i as f64);
    let mut ends: Vec<(f64, [f64; 2])> = pieces
        .iter()
        .flatten()
        .filter_map(|at| Some((round([0, 1].map(|k| at[k] - from[k]))?, *at)))
        .collect();
    if ends.len() % 2 == 1 {
        return None;
    }
    ends.sort_by(|a, b| a.0.total_cmp(&b.0));
    let place = |t: f64| {
        let at = corner_way(t);
        [0, 1].map(|k| from[k] + at[k])
    };
    let held = |t: f64| {
        let at = corner_way(t).map(|x| x.clamp(INSIDE, 1.0 - INSIDE));
        all.holds([0, 1].map(|k| from[k] + at[k]))
    };
    if ends.is_empty() {
        let corners = [0.0, 1.0, 2.0, 3.0, 4.0].map(place);
        return Some(if held(0.5) {
            corners.windows(2).map(|w| [w[0], w[1]]).collect()
        } else {
            Vec::new()
        });
    }
    let n = ends.len();
    let next = |i: usize| if i + 1 < n { ends[i + 1] } else { (ends[0].0 + 4.0, ends[0].1) };
    let long = |i: usize| next(i).0 - ends[i].0;
    let longest = (0..n).max_by(|a, b| long(*a).total_cmp(&long(*b)))?;
    let first = usize::from(!held(ends[longest].0 + 0.5 * long(longest))) ^ (longest % 2);
    let mut lines = Vec::new();
    for i in (first..n).step_by(2) {
        let ((t, mut at), (to, end)) = (ends[i], next(i));
        let mut corner = t.floor() + 1.0;
        while corner < to {
            lines.push([at, place(corner)]);
            at = place(corner);
            corner += 1.0;
        }
        lines.push([at, end]);
    }
    lines.retain(|[a, b]| !one(*a, *b));
    Some(lines)
}

/// How far round its border, from 0 to 4, a place of the unit square is; `None` inside.
fn round([u, v]: [f64; 2]) -> Option<f64> {
    match [u, v] {
        [_, 0.0] => Some(u),
        [1.0, _] => Some(1.0 + v),
        [_, 1.0] => Some(3.0 - u),
        [0.0, _] => Some(4.0 - v),
        _ => None,
    }
}

/// The place so far round.
fn corner_way(t: f64) -> [f64; 2] {
    let t = t.rem_euclid(4.0);
    match t {
        ..1.0 => [t, 0.0],
        ..2.0 => [1.0, t - 1.0],
        ..3.0 => [3.0 - t, 1.0],
        _ => [0.0, 4.0 - t],
    }
}
