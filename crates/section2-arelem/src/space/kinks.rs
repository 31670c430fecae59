//! The gap along a chord on which the contact goes over from one place of the cutter to another, and back.

use std::cell::Cell;

use aptc_contact::Gap;
use aptc_geometry::Surface;

use super::judge::{BETWEEN, between, turn};
use super::track::{Node, Track, Trouble};

/// Halvings in the search for the place where the contact goes over from one to the other.
const HALVINGS: usize = 40;
/// Looks between those at first, for each place where the contact goes over may show another one.
const MORE: usize = 8;
/// Looks where the gap turns between two of them.
const TURNS: usize = 3;
/// Share of the band by which the gaps of both places may differ where it does.
const EVEN: f64 = 5e-7;
/// Share of the cutter's radius up to which two places found are one.
const ONE: f64 = 1e-6;

/// What is seen on a chord, as a share of it.
#[derive(Clone, Copy)]
struct Look {
    t: f64,
    gap: Gap,
}

impl Track {
    /// Least and greatest gap to surface `i`, by looks on the way and where the contact goes over between two of them: there
    /// the gap has an edge, which no look beside it tells.
    pub(super) fn over_kinks(&self, i: usize, from: &Node, to: &Node) -> Result<[f64; 2], Trouble> {
        let keep = &self.keeps[i];
        // Then it is told sooner whether another place of a surface by two parameters is deeper than which one is the deepest.
        let searched = matches!(keep.surface, Surface::Parametric(_));
        let stands = searched && !self.axis.turns();
        let length = (to.pose.te - from.pose.te).norm();
        // Where it was seen last that no other is deeper, and how far that holds.
        let alone = Cell::new((f64::NAN, 0.0));
        // Of places that are as deep, as all of a ridge along a flat end, it is that beside the one before.
        let look = |t: f64, near: &Gap| -> Result<Look, Trouble> {
            let pose = between(&from.pose, &to.pose, t);
            let even = EVEN * keep.width();
            let beside = keep.gap(&pose, Some(near.spot())).ok();
            if let Some(gap) = beside.filter(|_| stands) {
                let (last, room) = alone.get();
                if (t - last).abs() * length < room {
                    return Ok(Look { t, gap });
                }
                let (deeper, room) = keep.deeper_on(&pose, &gap, even, (true, (1.0 - t) * length));
                alone.set((t, if deeper.is_none() { room } else { 0.0 }));
                return Ok(Look { t, gap: deeper.unwrap_or(gap) });
            }
            let all = keep.gap(&pose, None)?;
            let beside = beside.filter(|b| b.g <= all.g + even);
            let gap = beside.map_or(all, |b| Gap { g: b.g.min(all.g), ..b });
            Ok(Look { t, gap })
        };
        let mut seen = [Look { t: 1.0, gap: to.gaps[i] }; BETWEEN.len() + MORE + 2];
        seen[0] = Look { t: 0.0, gap: from.gaps[i] };
        for (k, t) in BETWEEN.into_iter().enumerate() {
            seen[k + 1] = look(t, &seen[k].gap)?;
        }
        let mut n = BETWEEN.len() + 2;
        let gaps = || seen[..n].iter().map(|l| l.gap.g);
        let mut found =
            [gaps().fold(f64::INFINITY, f64::min), gaps().fold(f64::NEG_INFINITY, f64::max)];
        let mut k = 0;
        while k + 1 < n {
            let (a, b) = (seen[k], seen[k + 1]);
            k += 1;
            if !self.goes_over(i, [from, to], &a, &b) {
                found = self.bent([&a, &b], [from, to], found, look)?;
                continue;
            }
            let Ok((t, _)) = self.even(i, [from, to], [&a, &b]) else { continue };
            let there = look(t, &a.gap)?;
            found = [found[0].min(there.gap.g), found[1].max(there.gap.g)];
            let third = [&a, &b].iter().all(|l| self.goes_over(i, [from, to], l, &there));
            if third && n < seen.len() {
                seen[k..=n].rotate_right(1);
                seen[k] = there;
                n += 1;
                k -= 1;
                continue;
            }
            let pose = between(&from.pose, &to.pose, t);
            for (side, first) in [(&a, true), (&b, false)] {
                let Ok(gap) = keep.gap_at(&pose, side.gap.spot()) else { continue };
                let edge = Look { t, gap };
                let ends = if first { [side, &edge] } else { [&edge, side] };
                found = self.bent(ends, [from, to], found, look)?;
            }
        }
        Ok(found)
    }

    /// The same with what the gap comes to between two looks at one place of contact, where it turns between them: it lies on one
    /// side of the tangents at both, which tell whether it may go beyond what was found.
    fn bent(
        &self,
        [a, b]: [&Look; 2],
        [from, to]: [&Node; 2],
        mut found: [f64; 2],
        look: impl Fn(f64, &Gap) -> Result<Look, Trouble>,
    ) -> Result<[f64; 2], Trouble> {
        let (way, turn) = (to.pose.te - from.pose.te, turn(&from.pose, &to.pose));
        let slope = |l: &Look| {
            let te = from.pose.te + way * l.t;
            l.gap.normal.dot(&way) + l.gap.turn_rate(te, turn)
        };
        let (mut a, mut b) = (*a, *b);
        for _ in 0..TURNS {
            let (down, up) = (slope(&a), slope(&b));
            if down * up >= 0.0 {
                break;
            }
            let t = a.t + (b.t - a.t) * down / (down - up);
            let meet = a.gap.g + (b.gap.g - a.gap.g + up * (a.t - b.t)) * down / (down - up);
            if meet >= found[0] && meet <= found[1] {
                break;
            }
            let there = look(t, &a.gap)?;
            found = [found[0].min(there.gap.g), found[1].max(there.gap.g)];
            *(if slope(&there) * down > 0.0 { &mut a } else { &mut b }) = there;
        }
        Ok(found)
    }

    /// Does the cutter touch at different places of it?
    fn goes_over(&self, i: usize, [from, to]: [&Node; 2], a: &Look, b: &Look) -> bool {
        let way = to.pose.te - from.pose.te;
        let te = |l: &Look| from.pose.te + way * l.t;
        let ends = [(&a.gap, te(a)), (&b.gap, te(b))];
        let bend = |l: &Look| {
            let pose = between(&from.pose, &to.pose, l.t);
            way.try_normalize(0.0).map_or(0.0, |along| self.keeps[i].bend(&pose, &l.gap, along))
        };
        self.touches_elsewhere(i, ends[0], ends[1]) || self.has_edge(i, ends, [bend(a), bend(b)])
    }

    /// Where along a cut vector, as a share of it, the places of contact of both ends are as near as each other, and the gap
    /// there: the first is nearer at the start, the second at the end.
    pub(super) fn crest(&self, i: usize, from: &Node, to: &Node) -> Result<(f64, f64), Trouble> {
        let ends = [Look { t: 0.0, gap: from.gaps[i] }, Look { t: 1.0, gap: to.gaps[i] }];
        self.even(i, [from, to], ends.each_ref())
    }

    /// The same between two looks. Along a flank the gap has one least place, so that searches from both its ends come to the same
    /// one, or to none where it goes over: the edge is ahead then as long as the gap grows.
    fn even(
        &self,
        i: usize,
        [from, to]: [&Node; 2],
        [a, b]: [&Look; 2],
    ) -> Result<(f64, f64), Trouble> {
        let keep = &self.keeps[i];
        let (mut low, mut high, mut found) = (a.t, b.t, (b.t, b.gap.g));
        let mut spots = [a.gap.spot(), b.gap.spot()];
        let (way, turn) = (to.pose.te - from.pose.te, turn(&from.pose, &to.pose));
        let one = ONE * keep.profile.half_width(a.gap.segment);
        for _ in 0..HALVINGS {
            let t = 0.5 * (low + high);
            let pose = between(&from.pose, &to.pose, t);
            let both = spots.map(|spot| keep.gap_at(&pose, spot));
            let two = |a: &Gap, b: &Gap| (a.tool_point - b.tool_point).norm() > one;
            let (rises, even) = match both {
                [Ok(a), Ok(b)] if two(&a, &b) => {
                    spots = [a.spot(), b.spot()];
                    found = (t, a.g.max(b.g));
                    (a.g < b.g, (a.g - b.g).abs())
                }
                both => {
                    let gap = match both {
                        [Ok(a), Ok(b)] => {
                            if b.g < a.g {
                                b
                            } else {
                                a
                            }
                        }
                        _ => keep.gap(&pose, None)?,
                    };
                    let slope = gap.normal.dot(&way) + gap.turn_rate(pose.te, turn);
                    found = (t, gap.g);
                    (slope > 0.0, slope.abs() * (high - low))
                }
            };
            if even <= EVEN * keep.width() {
                break;
            }
            *(if rises { &mut low } else { &mut high }) = t;
        }
        Ok(found)
    }
}
