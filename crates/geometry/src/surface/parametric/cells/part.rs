//! How a sculptured surface turns and bends near a tool: bounds over its cells there.

use super::super::part::{MOST_TURN, Part};
use super::{Cell, Cells, Sizes, WAITING};
use crate::Vec3;
use crate::balls::Below;
use crate::trig::hypot;

/// Cells of a rectangle at most.
const MOST: usize = 400;
/// Greatest sine by which normals turn over a cell, and share by which its derivatives change.
const CELL_TURN: f64 = 0.9;
const CHANGE: f64 = 0.5;

/// Columns and rows, the last ones too.
type Rectangle = [[usize; 2]; 2];

/// How a cell turns and bends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Formed {
    /// The normal in the middle, and by how much the others differ from it, as vectors.
    pub(super) normal: Vec3,
    pub(super) turn: f64,
    /// Least and greatest curvature, positive where the surface bends away from its normals.
    curvature: Option<[f64; 2]>,
    /// Its column and row.
    place: [usize; 2],
    sizes: Sizes,
}

impl Cells {
    /// Bounds over all of the surface within the balls, about the place with the parameters `near` and the normal `n`; the
    /// curvatures are those within the last ball. `None` where they tell nothing, or it is not seen that each point of the
    /// ball `from` has one nearest place there.
    ///
    /// The cells within the balls, and the place, lie in a rectangle of cells. From one cell to the next the surface goes on
    /// in the same directions: with parameters that grow as fast on both sides the square of the distance has no edge
    /// there, so that it is convex over all of the rectangle where it is convex over each cell, whatever their parameters are.
    pub(in super::super) fn part(
        &self,
        balls: &[(Vec3, f64)],
        from: (Vec3, f64),
        (near, n): ([f64; 2], Vec3),
    ) -> Option<Part> {
        let [column, row] = self.grid.place(near);
        let mut all = [[column; 2], [row; 2]];
        let (mut turn, mut curvature) = (0.0_f64, [f64::INFINITY, f64::NEG_INFINITY]);
        let formed = self.formed();
        let whole = self.within(balls, |number, last| {
            let cell = &formed[number];
            turn = turn.max((cell.normal - n).norm() + cell.turn);
            if last {
                let [least, most] = cell.curvature?;
                curvature = [curvature[0].min(least), curvature[1].max(most)];
            }
            for (ends, at) in all.iter_mut().zip(cell.place) {
                *ends = [ends[0].min(at), ends[1].max(at)];
            }
            (turn <= MOST_TURN && size(&all) <= MOST).then_some(())
        });
        whole?;
        self.is_convex(&all, from)?;
        let across = [0.0; 2];
        // Of directions nothing is known: none is that of rulings.
        let (ruling, lean, twist) = (Vec3::zeros(), 0.0, 0.0);
        let bends = curvature[0] <= curvature[1];
        bends.then_some(Part { turn, curvature, across, ruling, lean, twist })
    }

    pub(super) fn formed(&self) -> &[Formed] {
        self.formed.get_or_init(|| {
            let formed = |cell: &Cell| {
                let (place, sizes) = (self.grid.place(cell.mid), cell.sizes());
                // Of a cell whose normals may look anywhere.
                let Some((normal, turn)) = cell.normals() else {
                    let (normal, turn) = (Vec3::zeros(), f64::INFINITY);
                    return Formed { normal, turn, curvature: None, place, sizes };
                };
                Formed { normal, turn, curvature: cell.curvature(normal, turn), place, sizes }
            };
            self.cells.iter().map(formed).collect()
        })
    }

    /// The numbers of the cells that come into the balls go to `put`, with whether they come into the last one, until that gives up.
    pub(super) fn within(
        &self,
        balls: &[(Vec3, f64)],
        mut put: impl FnMut(usize, bool) -> Option<()>,
    ) -> Option<()> {
        let last = 1_u64.checked_shl(u32::try_from(balls.len()).ok()?.checked_sub(1)?)?;
        // With each group the balls that what holds it comes into: none of its parts comes into others.
        let mut waiting = [(0_usize, last | (last - 1)); WAITING];
        let mut n = usize::from(!self.tree.is_empty());
        while n > 0 {
            n -= 1;
            let (at, above) = waiting[n];
            let ball = &self.tree[at];
            let apart = |(c, r): &(Vec3, f64)| ball.apart(*c) > r * r;
            let into = marked(above).filter(|i| !apart(&balls[*i])).fold(0, |all, i| all | 1 << i);
            if into == 0 {
                continue;
            }
            match ball.below {
                Below::Balls(pair) => {
                    for i in pair {
                        *waiting.get_mut(n)? = (i, into);
                        n += 1;
                    }
                }
                Below::Things(from, to) => {
                    for (number, cell) in (from..to).zip(&self.cells[from..to]) {
                        let comes_into = |i: usize| cell.comes_into(&balls[i]);
                        let in_last = into & last != 0 && marked(last).all(comes_into);
                        if in_last || marked(into & !last).any(comes_into) {
                            put(number, in_last)?;
                        }
                    }
                }
            }
        }
        Some(())
    }

    /// Is the square of the distance from each point of the ball convex over a rectangle, within the borders of the surface?
    fn is_convex(&self, all: &Rectangle, from: (Vec3, f64)) -> Option<()> {
        let count = self.grid.count();
        let inner = (0..2).all(|k| all[k][0] > 0 && all[k][1] + 1 < count[k]);
        inner.then_some(())?;
        let formed = self.formed();
        for row in all[1][0]..=all[1][1] {
            for column in all[0][0]..=all[0][1] {
                let at = [column, row];
                let number = self.grid.number(at)?;
                let cell = &self.cells[number];
                let goes_on = (0..2).all(|k| {
                    (at[k] == all[k][0] || cell.smooth[k][0])
                        && (at[k] == all[k][1] || cell.smooth[k][1])
                });
                (goes_on && cell.has_one_dip_of(&formed[number].sizes, from)).then_some(())?;
            }
        }
        Some(())
    }
}

/// The numbers of the bits that are set.
#[inline(always)]
fn marked(mut bits: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let next = (bits != 0).then(|| bits.trailing_zeros() as usize);
        bits &= bits.wrapping_sub(1);
        next
    })
}

fn size(all: &Rectangle) -> usize {
    (all[0][1] - all[0][0] + 1) * (all[1][1] - all[1][0] + 1)
}

impl Cell {
    /// May a point of it be in the ball?
    fn comes_into(&self, (center, radius): &(Vec3, f64)) -> bool {
        let far = (self.c - center).norm_squared();
        // Its middle is a point of it.
        far <= radius * radius
            || far <= (radius + self.reach) * (radius + self.reach)
                && self.bound(*center, self.toward(*center)) <= *radius
    }

    /// The normal in the middle, and by how much the others differ from it, as vectors.
    pub(super) fn normals(&self) -> Option<(Vec3, f64)> {
        let [a, b] = &self.side;
        let [ea, eb] = self.turns();
        let (la, lb) = (a.norm(), b.norm());
        let across = a.cross(b);
        let size = across.norm();
        let sine = (la * eb + lb * ea + ea * eb) / size;
        // The chord of an angle with that sine.
        let chord = || (2.0 - 2.0 * (1.0 - sine * sine).sqrt()).max(0.0).sqrt();
        (sine <= CELL_TURN).then(|| (across / size, chord()))
    }

    /// Least and greatest curvature, positive where the surface bends away from its normals, which differ from that by `turn`.
    fn curvature(&self, normal: Vec3, turn: f64) -> Option<[f64; 2]> {
        let [a, b] = &self.side;
        let [ea, eb] = self.turns();
        // In the middle the directions `a / la` and `(b - lean a) / lb` are square to each other.
        let la = a.norm();
        let lean = a.dot(b) / (la * la);
        let lb = (b - a * lean).norm();
        let [oa, ob] = [ea / la, (eb + lean.abs() * ea) / lb];
        let off = hypot(oa, ob);
        (off <= CHANGE).then_some(())?;
        let [(uu, ru), (uv, rv), (vv, rw)] = self.bend;
        // The same of the second of those directions.
        let (vu, rx) = (uv - uu * lean, rv + lean.abs() * ru);
        let (ww, ry) = (vv - uv * lean, rw + lean.abs() * rv);
        let [e, f] = [a / la, (b - a * lean) / lb];
        // Their products change by what of the changes lies along them, and by the product of these.
        let along = |d: &Vec3, x: &Vec3, y: &Vec3| d.dot(x).abs() + d.dot(y).abs();
        let first = |d: &Vec3| (along(d, &uu, &uv) + ru + rv) / la;
        let second = |d: &Vec3| (along(d, &vu, &ww) + rx + ry) / lb;
        let [square, other] = [2.0 * first(&e) + oa * oa, 2.0 * second(&f) + ob * ob];
        let form_off = square.max(other) + first(&f) + second(&e) + oa * ob;
        // A normal has of another's no more along it than the cosine of the turn, and as much beside it as its sine.
        let form = |m: Vec3, r: f64, by: f64| {
            let up = normal.dot(&m);
            let beside = (m - normal * up).norm();
            (-up / by, (turn * beside + 0.5 * turn * turn * up.abs() + r) / by)
        };
        let (l, rl) = form(uu, ru, la * la);
        let (m, rm) = form(vu, rx, la * lb);
        let (q, rq) = form(ww - vu * lean, ry + lean.abs() * rx, lb * lb);
        let (mid, root) = (0.5 * (l + q), hypot(0.5 * (l - q), m));
        let unsure = rl.max(rq) + rm;
        // Those directions are no longer unit ones elsewhere, nor square to each other.
        let short = ((1.0 - off) * (1.0 - off)).max(1.0 - form_off);
        let long = ((1.0 + off) * (1.0 + off)).min(1.0 + form_off);
        let greatest = |x: f64| if x > 0.0 { x / short } else { x / long };
        Some([-greatest(root + unsure - mid), greatest(mid + root + unsure)])
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::super::super::ParametricSurface;
    use super::super::super::sculptured::Spans;
    use super::*;
    use crate::sculptured::{MeshSpacing, SurfaceDefinition};
    use crate::trig;
    use proptest::prelude::*;
    use std::cell::Cell as Counter;

    /// A mesh over 90 by 80 with waves and uneven spans.
    pub(in super::super) fn mesh(waves: [f64; 2], uneven: f64) -> Spans {
        let stretch = |t: f64| t + uneven * trig::sin(3.0 * t) / 3.0;
        let row = |j: i32| {
            let at = |i: i32| {
                let (s, t) = (f64::from(i) / 4.0 - 1.0, f64::from(j) / 3.0 - 1.0);
                let z = waves[0] * trig::sin(4.0 * s + t) + waves[1] * trig::cos(3.0 * t - s);
                Vec3::new(45.0 * stretch(s), 40.0 * stretch(t), z)
            };
            (0..9).map(at).collect()
        };
        let definition = SurfaceDefinition::mesh(MeshSpacing::Xyz, (0..7).map(row));
        Spans::new(&definition).expect("a surface")
    }

    #[test]
    fn bounds_hold_all_of_the_surface_in_the_balls() {
        let told = Counter::new([0_u32; 2]);
        let one = || -1.0_f64..1.0;
        let all = ([one(), one()], one(), [one(), one(), one()], 1.0_f64..9.0, 0.1_f64..4.0);
        let config = proptest::test_runner::Config::with_cases(200);
        let mut runner = proptest::test_runner::TestRunner::new(config);
        let check = runner.run(&all, |(waves, uneven, place, radius, last)| {
            let spans = mesh(waves.map(|w| 4.0 * w), 0.5 * uneven);
            let near = [0.5 + 0.4 * place[0], 0.5 + 0.4 * place[1]];
            let here = spans.jet(near[0], near[1]);
            let n = here.su.cross(&here.sv).normalize();
            let from = (here.s + n * (4.0 * place[2]), 0.5);
            let balls = [(from.0, radius), (here.s, last)];
            let [no, yes] = told.get();
            let Some(part) = spans.cells().part(&balls, from, (near, n)) else {
                told.set([no + 1, yes]);
                return Ok(());
            };
            told.set([no, yes + 1]);
            let surface = ParametricSurface::of_spans(spans.clone());
            let within = |i: i32, k: i32| (f64::from(i) + 0.5) / 90.0 + 1e-9 * f64::from(k);
            for i in 0..90 {
                for j in 0..90 {
                    let (u, v) = (within(i, j), within(j, i));
                    let jet = spans.jet(u, v);
                    let comes_into = |b: &(Vec3, f64)| (jet.s - b.0).norm() <= b.1;
                    if !balls.iter().any(comes_into) {
                        continue;
                    }
                    let normal = jet.su.cross(&jet.sv).normalize();
                    prop_assert!((normal - n).norm() <= part.turn + 1e-9);
                    // Each point asked for has no nearest place elsewhere.
                    let p = from.0 + Vec3::from(place) * (0.5 / 3.0_f64.sqrt());
                    let down = surface.descend_free(p, [u, v]).1.jet.s;
                    let nearest = surface.descend_free(p, near).1.jet.s;
                    prop_assert!((down - nearest).norm() < 1e-4, "{down} {nearest}");
                    if comes_into(&balls[1]) {
                        let [a, b, c] = surface.bend(&jet, normal).k;
                        let (mid, root) = (0.5 * (a + c), hypot(0.5 * (a - c), b));
                        let [least, most] = part.curvature;
                        let seen = [mid - root, mid + root];
                        prop_assert!(
                            seen[0] >= least - 1e-9 && seen[1] <= most + 1e-9,
                            "{seen:?} {part:?}"
                        );
                    }
                }
            }
            Ok(())
        });
        check.unwrap();
        let [no, yes] = told.get();
        assert!(yes > no / 2, "{yes} {no}");
    }
}
