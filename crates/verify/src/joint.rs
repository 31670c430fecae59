//! REGION on loose patches (COMBIN): that what the outlines hold of one patch goes on in the next.
//!
//! The parameters of such patches do not run through, so each has lines of its own, closed along its borders. Here it is looked in
//! space, from border to border, whether what is held on one side of a joint is held on the other, but for where the outline itself
//! runs along it, and whether the lines go where the corners lie that were recorded. Nothing of how the outline was cut is used.

use aptc_cldata::milling::Area;
use aptc_geometry::sculpt::Layout;
use aptc_geometry::{Sculptured, Vec3};

/// Numbers so near to that of a border are on it.
const ON: f64 = 1e-9;
/// Corners so near to a border may be put on it.
const BESIDE: f64 = 2e-6;
/// How far inside of a patch it is looked what is held, and stretches of a border that are too short for that.
const INSIDE: f64 = 1e-5;
const SHORT: f64 = 1e-3;
/// Parts of a border that are looked at at least, and places of it by which another is found.
const PARTS: u32 = 8;
const PLACES: u32 = 32;
const ROUNDS: u32 = 48;
/// Share of the surface's size by which two borders may part that are one joint.
const PART: f64 = 1e-4;
/// Share of its length by which what is straight between two corners may be beside the chord.
const BULGE: f64 = 0.1;

/// A border of a patch: the patch, the parameter that is constant along it, at which end, with a box that holds it.
struct Side {
    patch: usize,
    axis: usize,
    end: f64,
    low: Vec3,
    high: Vec3,
}

impl Side {
    /// The parameters of the patch so far along it, and so far inside.
    fn own(&self, t: f64, inside: f64) -> [f64; 2] {
        let mut own = [t.clamp(inside, 1.0 - inside); 2];
        own[self.axis] = self.end + inside * (1.0 - 2.0 * self.end);
        own
    }

    fn place(&self, surface: &Sculptured, t: f64) -> Vec3 {
        let [u, v] = self.own(t, 0.0);
        surface.patches[self.patch].point(u, v)
    }

    /// How far along it the outline comes to it.
    fn ends(&self, area: &Area) -> Vec<f64> {
        let from = self.patch as f64;
        let all = area.outlines.iter().flat_map(|o| &o.lines).flatten();
        let own = all.map(|[u, v]| [u - from, *v]);
        let on = own.filter(|own| {
            (own[self.axis] - self.end).abs() <= ON
                && (-ON..=1.0 + ON).contains(&own[1 - self.axis])
        });
        on.map(|own| own[1 - self.axis]).collect()
    }
}

/// Do the lines of an area make sense on each patch and from patch to patch? `room` is a distance that does not count. Of a surface
/// whose parameters run through nothing is asked.
pub(crate) fn goes_on(area: &Area, surface: &Sculptured, room: f64) -> bool {
    if !matches!(surface.layout, Layout::Patches) || surface.patches.len() < 2 {
        return true;
    }
    let lines = || area.outlines.iter().flat_map(|o| &o.lines);
    let in_one = |[a, b]: &[[f64; 2]; 2]| {
        let patch = (0.5 * (a[0] + b[0])).floor();
        let on_joint = (a[0] - b[0]).abs() <= 0.0;
        on_joint || [a, b].iter().all(|x| x[0] >= patch && x[0] <= patch + 1.0)
    };
    lines().all(in_one) && follows(area, surface, room) && is_whole(area, surface, room)
}

/// Is each line that runs inside of a patch one between recorded corners, and is none of these passed over?
fn follows(area: &Area, surface: &Sculptured, room: f64) -> bool {
    let on_border =
        |[u, v]: [f64; 2]| [u - u.round(), v, v - 1.0].iter().any(|x| x.abs() <= BESIDE);
    // Off the round numbers, near which corners lie.
    let key = |x: &[f64; 2]| x.map(|x| (x / BESIDE + 0.37).round());
    let order = |a: &[f64; 2], b: &[f64; 2]| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]));
    let mut corners: Vec<[f64; 2]> = area.recorded.iter().flatten().map(key).collect();
    corners.sort_by(order);
    let mut ends: Vec<[f64; 2]> = Vec::new();
    for [a, b] in area.outlines.iter().flat_map(|o| &o.lines) {
        let along = |x: f64, y: f64| (x - y).abs() <= ON && on_border([x, 0.5]);
        let border = along(a[0], b[0]) || ((a[1] - b[1]).abs() <= ON && on_border([0.5, a[1]]));
        for end in [a, b] {
            let known = corners.binary_search_by(|c| order(c, &key(end))).is_ok();
            let at = surface.at(end[0].min(last(surface, [a, b])), end[1]).point;
            if !border && !known && !beside(area, surface, at, room) {
                return false;
            }
            ends.push(key(end));
        }
    }
    ends.sort_by(order);
    let met = |c: &[f64; 2]| on_border(*c) || ends.binary_search_by(|e| order(e, &key(c))).is_ok();
    area.recorded.iter().filter(|l| l.len() >= 3).flatten().all(met)
}

/// The greatest first parameter of the patch in which a line lies.
fn last(surface: &Sculptured, [a, b]: [&[f64; 2]; 2]) -> f64 {
    let end = (0.5 * (a[0] + b[0])).floor() + 1.0;
    if end >= surface.spans()[0] { end } else { end.next_down() }
}

/// Is what is held beside a border held on its other side too, where another patch is there and the outline does not run along it?
fn is_whole(area: &Area, surface: &Sculptured, room: f64) -> bool {
    let most = PART * surface.extent();
    let sides = sides(surface, most);
    let held = |side: &Side, t: f64| {
        let [u, v] = side.own(t, INSIDE);
        let at = [side.patch as f64 + u, v];
        area.outlines.iter().filter(|o| o.holds(at)).count() % 2 == 1
    };
    sides.iter().all(|side| {
        let mut cuts = side.ends(area);
        cuts.extend((0..=PARTS).map(|i| f64::from(i) / f64::from(PARTS)));
        cuts.sort_by(f64::total_cmp);
        let stretches = cuts.windows(2).filter(|w| w[1] - w[0] > SHORT);
        stretches.map(|w| 0.5 * (w[0] + w[1])).all(|t| {
            let at = side.place(surface, t);
            let other = sides.iter().filter(|other| other.patch != side.patch);
            let other = other.filter_map(|other| Some((other, meets(other, surface, at, most)?)));
            let nearest = other.min_by(|a, b| a.1[1].total_cmp(&b.1[1]));
            nearest.is_none_or(|(other, [there, _])| {
                held(side, t) == held(other, there) || beside(area, surface, at, room)
            })
        })
    })
}

fn sides(surface: &Sculptured, most: f64) -> Vec<Side> {
    let of = |patch: usize| {
        [(0, 0.0), (0, 1.0), (1, 0.0), (1, 1.0)].map(|(axis, end)| {
            let (low, high) = (Vec3::repeat(f64::INFINITY), Vec3::repeat(f64::NEG_INFINITY));
            let mut side = Side { patch, axis, end, low, high };
            let all = (0..=PLACES).map(|i| f64::from(i) / f64::from(PLACES));
            let all: Vec<Vec3> = all.map(|t| side.place(surface, t)).collect();
            // Between two places it does not bulge by more than they are apart.
            let step = all.windows(2).map(|w| (w[1] - w[0]).norm()).fold(most, f64::max);
            for p in all {
                side.low = side.low.inf(&(p - Vec3::repeat(step)));
                side.high = side.high.sup(&(p + Vec3::repeat(step)));
            }
            side
        })
    };
    (0..surface.patches.len()).flat_map(of).collect()
}

/// How far along a border a place is, and how far from it, where it is on it.
fn meets(side: &Side, surface: &Sculptured, at: Vec3, most: f64) -> Option<[f64; 2]> {
    if (0..3).any(|k| at[k] < side.low[k] || at[k] > side.high[k]) {
        return None;
    }
    let far = |t: f64| (side.place(surface, t) - at).norm();
    let all = (0..=PLACES).map(|i| f64::from(i) / f64::from(PLACES));
    let nearest = all.min_by(|a, b| far(*a).total_cmp(&far(*b)))?;
    let step = 1.0 / f64::from(PLACES);
    let (mut low, mut high) = ((nearest - step).max(0.0), (nearest + step).min(1.0));
    for _ in 0..ROUNDS {
        let third = (high - low) / 3.0;
        if far(low + third) < far(high - third) { high -= third } else { low += third }
    }
    let t = 0.5 * (low + high);
    (far(t) <= most).then(|| [t, far(t)])
}

/// Is a place on the way from a recorded corner to the next?
fn beside(area: &Area, surface: &Sculptured, at: Vec3, room: f64) -> bool {
    let place = |[u, v]: &[f64; 2]| surface.at(*u, *v).point;
    area.recorded.iter().any(|corners| {
        corners.iter().zip(corners.iter().cycle().skip(1)).any(|(a, b)| {
            let (p, q) = (place(a), place(b));
            let (way, to) = (q - p, at - p);
            let square = way.norm_squared();
            let share = if square > 0.0 { (to.dot(&way) / square).clamp(0.0, 1.0) } else { 0.0 };
            (to - way * share).norm() <= room + BULGE * way.norm()
        })
    })
}
