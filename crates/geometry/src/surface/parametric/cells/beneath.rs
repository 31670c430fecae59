//! Where a sculptured surface may come next to a disk: pieces of it that may hold a place at which the distance of the disk dips.
//!
//! At such a place q with the normal n the point of the disk next to it is `q + d n`. That is in the middle of the disk where n is its
//! axis, and else the point of its border to which n leans least: `center + rho e`, e being the direction across the axis from which n
//! leans. So of a piece whose normals lean all about the same way it is known where that point is, and whether it faces the piece.

use super::{Cell, Cells};
use crate::Vec3;
use crate::surface::parametric::Jet;

/// How often a cell is cut in four at most.
const CUTS: u32 = 4;
/// Share of a normal's lean by which others of its piece may lean otherwise, for it to be known from where they do.
const LEANS: f64 = 0.5;

/// The points not farther than `rho` from `center`, square to the unit vector `axis`, which leads away from the surface.
#[derive(Clone, Copy, Debug)]
pub struct Disk {
    /// Its middle.
    pub center: Vec3,
    /// Unit vector square to it.
    pub axis: Vec3,
    /// Its radius.
    pub rho: f64,
}

/// A piece of a surface, seen from a disk.
#[derive(Clone, Copy, Debug)]
pub struct Facing {
    /// The parameters of its middle.
    pub mid: [f64; 2],
    /// The point there.
    pub point: Vec3,
    /// No point of it is farther from that one.
    pub reach: f64,
    /// None of it is nearer to the disk, or to what is above the disk.
    pub bound: f64,
    /// How far the disk has to go until its distance may dip at a place of the piece.
    pub until: f64,
    /// The normal in the middle, on the side of the axis; zero beside an edge.
    pub normal: Vec3,
    /// By how much others differ from it, as vectors; 2 where they may be anything.
    pub turn: f64,
    /// Can it be cut?
    pub whole: bool,
}

/// What becomes of a piece.
#[derive(Clone, Copy, Debug)]
pub enum Next {
    /// It is cut in four, if it can be.
    Cut,
    /// From now on pieces not nearer than the first of these are of no matter, nor those that may hold a dip after the second.
    Left([f64; 2]),
}

impl Disk {
    /// Distance of a point from the disk and all that is above it, and the gradient of that.
    fn near(&self, p: Vec3) -> (f64, Vec3) {
        let w = p - self.center;
        let z = w.dot(&self.axis);
        let radial = w - self.axis * z;
        let r = radial.norm();
        let beside = if r > self.rho { radial * (1.0 - self.rho / r) } else { Vec3::zeros() };
        let away = beside + self.axis * z.min(0.0);
        let far = away.norm();
        (far, away.try_normalize(0.0).unwrap_or_else(Vec3::zeros))
    }
}

impl Cells {
    /// The pieces that may come nearer to a disk than the first of the limits and, the disk having gone by less than the second, hold a
    /// place at which its distance dips: `look` is asked what is to become of each.
    pub(in super::super) fn beneath(
        &self,
        disk: &Disk,
        limits: [f64; 2],
        jet: impl Fn([usize; 2], f64, f64) -> Jet,
        mut look: impl FnMut(&Facing) -> Next,
    ) {
        self.beside(
            |p| disk.near(p).0,
            limits,
            |cell, limits| cell.beneath(disk, limits, &jet, CUTS, &mut look),
        );
    }

    /// The least cosine between a vector and the normals of the surface within balls, which are those of the parameters; `None` where
    /// it is not above 0, and at edges.
    pub(in super::super) fn upright(&self, balls: &[(Vec3, f64)], axis: Vec3) -> Option<f64> {
        let formed = self.formed();
        let mut least = 1.0_f64;
        self.within(balls, |number, _| {
            let formed = &formed[number];
            least = least.min(formed.normal.dot(&axis) - formed.turn);
            let smooth = self.cells[number].smooth.iter().flatten().all(|s| *s);
            (smooth && least > 0.0).then_some(())
        })?;
        Some(least)
    }
}

impl Cell {
    fn beneath(
        &self,
        disk: &Disk,
        limits: &mut [f64; 2],
        jet: &impl Fn([usize; 2], f64, f64) -> Jet,
        cuts: u32,
        look: &mut impl FnMut(&Facing) -> Next,
    ) {
        let (far, gradient) = disk.near(self.c);
        let bound = far - self.width(gradient);
        if bound > limits[0].max(0.0) {
            return;
        }
        let smooth = self.smooth.iter().flatten().all(|s| *s);
        let normals = self.normals().filter(|_| smooth);
        let normals = normals.map(|(n, turn)| (n * n.dot(&disk.axis).signum(), turn));
        let until = normals.map_or(0.0, |normals| self.until(disk, normals));
        if until > limits[1] {
            return;
        }
        let (normal, turn) = normals.unwrap_or((Vec3::zeros(), 2.0));
        let &Self { mid, c: point, reach, .. } = self;
        let whole = cuts > 0;
        match look(&Facing { mid, point, reach, bound, until, normal, turn, whole }) {
            Next::Left(next) => *limits = next,
            Next::Cut if whole => {
                for part in self.parts(jet) {
                    part.beneath(disk, limits, jet, cuts - 1, look);
                }
            }
            Next::Cut => {}
        }
    }

    /// How far the disk has to go until a place of it, whose normals differ from `n` by no more than `turn`, may face the point of the
    /// disk that is next to it.
    fn until(&self, disk: &Disk, (n, turn): (Vec3, f64)) -> f64 {
        let up = n.dot(&disk.axis);
        let across = n - disk.axis * up;
        let lean = across.norm();
        if turn >= LEANS * lean {
            // It may be any point of the disk, and the normals lean by no more than this.
            let lean = lean + turn;
            let w = self.c - disk.center;
            let z = w.dot(&disk.axis);
            let beside = (w - disk.axis * z).norm() - disk.rho - self.reach;
            let upright = (1.0 - lean * lean).max(0.0).sqrt();
            // From there it is farther by what it goes and by what it rises.
            let more = beside * upright - lean * (z.abs() + self.reach);
            return more.max(0.0) / (upright + lean);
        }
        let out = across / lean;
        let p = disk.center - out * disk.rho;
        let other = disk.rho * turn / (lean - 0.5 * turn);
        let w = self.c - p;
        let off = w - n * n.dot(&w);
        let Some(t) = off.try_normalize(0.0) else { return 0.0 };
        let (size, far) = (off.norm(), w.norm() + self.reach + other);
        // How much of it the piece can make up for, whatever its parts do, and where it does so evenly.
        let first = self.width(t) + other + turn * far;
        let around = disk.axis.cross(&out);
        let ([da, db], odd) = self.turned(n, turn);
        let even = |side: &Vec3, d: &Vec3| {
            let next = disk.rho * t.dot(&around) * around.dot(d) / lean;
            (t.dot(side) + next - n.dot(&w) * t.dot(d)).abs()
        };
        let uneven = disk.rho * (odd + 2.0 * turn * turn / lean) / lean
            + far * (odd + turn * turn)
            + turn * (self.reach + other);
        let [a, b] = &self.side;
        let second = even(a, &da) + even(b, &db) + self.stray(t) + uneven;
        (size - first.min(second)).max(0.0) / (1.0 + turn)
    }

    /// By how much the normal differs at the ends of both parameters from `n` in the middle if it turns evenly, and by how much other
    /// normals differ from that, no two of them by more than `turn`.
    fn turned(&self, n: Vec3, turn: f64) -> ([Vec3; 2], f64) {
        let [a, b] = &self.side;
        let [(uu, ru), (uv, rx), (vv, rv)] = self.bend;
        let whole = a.cross(b);
        let size = whole.norm().copysign(whole.dot(&n));
        let along = |x: Vec3| (x - n * n.dot(&x)) / size;
        let [ea, eb] = self.turns();
        let rest = (ru + rx) * b.norm() + (rx + rv) * a.norm() + ea * eb;
        let even = [along(uu.cross(b) + a.cross(&uv)), along(uv.cross(b) + a.cross(&vv))];
        (even, rest / size.abs() + 2.0 * turn * turn)
    }

    /// How far it goes along a direction, to both sides of its middle.
    pub(super) fn width(&self, t: Vec3) -> f64 {
        let [a, b] = &self.side;
        t.dot(a).abs() + t.dot(b).abs() + self.stray(t)
    }

    /// By how much it strays along a direction from what it is if it does not bend.
    fn stray(&self, t: Vec3) -> f64 {
        let [uu, uv, vv] = &self.bend;
        let most = |(m, r): &(Vec3, f64)| t.dot(m).abs() + r;
        0.5 * (most(uu) + most(vv)) + most(uv)
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::sculptured::Spans;
    use super::super::part::tests::mesh;
    use super::*;
    use crate::trig;
    use proptest::prelude::*;
    use std::cell::Cell as Counter;

    /// The lowest places of a grid of the parameters, each followed downhill by ever smaller steps, which are places at which the distance
    /// of the disk dips.
    fn dips(spans: &Spans, disk: &Disk, limit: f64) -> Vec<[f64; 2]> {
        const N: usize = 120;
        let far = |u: f64, v: f64| disk.near(spans.jet(u, v).s).0;
        let at = |i: usize| 0.1 + 0.8 * (i as f64 + 0.5) / N as f64;
        let grid: Vec<Vec<f64>> =
            (0..N).map(|i| (0..N).map(|j| far(at(i), at(j))).collect()).collect();
        let mut found = Vec::new();
        for i in 1..N - 1 {
            for j in 1..N - 1 {
                let d = grid[i][j];
                let lowest = (i - 1..=i + 1).all(|k| (j - 1..=j + 1).all(|l| d <= grid[k][l]));
                if !lowest || d > limit {
                    continue;
                }
                let (mut d, mut u, mut v, mut h) = (d, at(i), at(j), 1.0 / N as f64);
                while h > 1e-10 {
                    let turns =
                        (0..12).map(|k| trig::sin_cos(f64::from(k) * std::f64::consts::PI / 6.0));
                    let next =
                        turns.map(|(s, c)| (far(u + h * c, v + h * s), u + h * c, v + h * s));
                    match next.min_by(|a, b| a.0.total_cmp(&b.0)) {
                        Some(next) if next.0 < d => (d, u, v) = next,
                        _ => h *= 0.6,
                    }
                }
                // What reaches into what is above the disk has no distance.
                if d > 1e-6 {
                    found.push([u, v]);
                }
            }
        }
        found
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

        /// Each dip lies in a piece that is left; and where the disk has gone, in one that may come to hold one.
        #[test]
        fn no_dip_is_left_out(
            waves in prop::array::uniform2(-4.0_f64..4.0), uneven in -0.5_f64..0.5,
            at in prop::array::uniform2(-0.6_f64..0.6), lean in prop::array::uniform2(-0.4_f64..0.4),
            (rho, high, way) in (0.5_f64..8.0, 0.2_f64..4.0, 0.0_f64..1.0), to in prop::array::uniform3(-1.0_f64..1.0),
        ) {
            let spans = mesh(waves, uneven);
            let axis = Vec3::new(lean[0], lean[1], 1.0).normalize();
            let below = spans.jet(0.5 + 0.5 * at[0], 0.5 + 0.5 * at[1]).s;
            let stands = Disk { center: below + axis * high, axis, rho };
            let moved = Disk { center: stands.center + Vec3::from(to).normalize() * way, ..stands };
            let limit = high + 2.0;
            for uv in dips(&spans, &moved, limit) {
                let p = spans.jet(uv[0], uv[1]).s;
                let (held, smallest) = (Counter::new(false), Counter::new(f64::INFINITY));
                let jet = |patch, u, v| spans.jet_of(patch, u, v);
                spans.cells().beneath(&stands, [limit + way, way + 1e-9], jet, |piece| {
                    if (piece.point - p).norm() <= piece.reach * (1.0 + 1e-9) {
                        held.set(held.get() || !piece.whole);
                        smallest.set(smallest.get().min(piece.reach));
                        return Next::Cut;
                    }
                    Next::Left([limit + way, way + 1e-9])
                });
                prop_assert!(held.get(), "{uv:?} {p} {} {stands:?} {moved:?}", smallest.get());
            }
        }
    }
}
