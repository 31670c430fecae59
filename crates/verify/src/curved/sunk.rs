//! A tool that is to be in the surface: a point of it that is deep enough goes along.

use aptc_geometry::Vec3;

use super::{Curved, DEPTH, Half, Warm};
use crate::between::bulge;
use crate::deep::{Deep, deepest, on_faces};
use crate::pile::Pile;
use crate::search::{Aim, Moved, clearance};
use crate::sheet::Spot;
use crate::sweep::Sweep;
use crate::tool::{Pose, Tool, carry};

impl Curved<'_> {
    /// That some point of the tool is nowhere less deep than the greatest gap allows: one for each stretch, which stays where it
    /// is in the tool or goes evenly from one place of it to another, as over a dome below a flat end.
    pub(super) fn sunk(
        &self,
        tool: &Tool<'_>,
        pose: &dyn Fn(f64) -> Pose,
        turn: f64,
        pad: f64,
    ) -> Option<Half> {
        /// Stretches that are looked at at most.
        const STRETCHES: u32 = 40;
        let Tool::Solid(_) = tool else { return None };
        let sweep = Sweep::still(tool, pose(0.0));
        let moved = Moved::whole(self.sheet, self.side, 0.0);
        let any = || clearance(&sweep, &moved, self.most + tool.reach(), Aim::Any).nearest;
        let mut spot = match self.within(tool, &pose(0.0)) {
            Some(spot) => spot,
            None => any()?.2,
        };
        let mut stack = Pile::<(f64, f64, u32), 32>::new();
        stack.push((0.0, 1.0, 0));
        let (mut seen, mut high) = (0, f64::NEG_INFINITY);
        while let Some((t0, t1, depth)) = stack.pop() {
            seen += 1;
            if seen > STRETCHES || depth > DEPTH {
                return None;
            }
            let (a, b) = (pose(t0), pose(t1));
            let middle = 0.5 * (t0 + t1);
            let bend = turn * (t1 - t0);
            let mut held = None;
            for seen in [Some(middle), None, Some(t0), Some(t1)] {
                let (ends, off) = if let Some(t) = seen {
                    let at = pose(t);
                    let deep = self.deep(tool, &at, spot, pad);
                    spot = deep.spot;
                    let above = deep.gap - self.most;
                    if above > pad {
                        return self.afloat(tool, &at, above, pad).map(|gap| Half::Broken(t, gap));
                    }
                    // The point goes along a chord but for its bulge.
                    let off = bulge((deep.p - at.te).norm(), bend);
                    ([a, b].map(|to| carry(&at, &to, deep.p)), off)
                } else {
                    // From the deepest of one end to that of the other: all between two points of the tool is of the tool.
                    let ends = [a, b].map(|at| (at.te, self.deep(tool, &at, spot, pad).p));
                    let lever = ends.map(|(te, p)| (p - te).norm());
                    let drift = (carry(&b, &a, ends[1].1) - ends[0].1).norm();
                    let off = bulge(lever[0].max(lever[1]), bend) + 0.25 * bend * drift;
                    (ends.map(|(_, p)| p), off)
                };
                let [p, q] = ends;
                let way = |s: f64| Pose { te: p + (q - p) * s, ta: Vec3::z() };
                let least = -self.most + off;
                let warm = &mut Warm::default();
                match self.not_below(&Tool::End, -self.side, least, &way, 0.0, pad, warm) {
                    Half::Holds(g) => {
                        held = Some(off - g);
                        break;
                    }
                    // A search that comes to no end does so again.
                    Half::Open(_, f64::INFINITY) => return None,
                    Half::Open(..) | Half::Broken(..) => {}
                }
            }
            match held {
                Some(g) => high = high.max(g),
                None => {
                    stack.push((middle, t1, depth + 1));
                    stack.push((t0, middle, depth + 1));
                }
            }
        }
        Some(Half::Holds(high))
    }

    /// The deepest point of the tool that is found.
    fn deep(&self, tool: &Tool<'_>, at: &Pose, spot: Spot, pad: f64) -> Deep {
        let most = self.most + pad;
        let mut deep = deepest(tool, at, self.sheet, self.side, spot, most);
        if deep.gap > most
            && let Some(spot) = self.within(tool, at)
        {
            deep = deepest(tool, at, self.sheet, self.side, spot, most);
        }
        if deep.gap > most {
            deep = on_faces(tool, at, self.sheet, self.side, deep, most);
        }
        deep
    }

    /// A place of the surface that lies in the tool when it is moved by the greatest gap: as deep the tool is there.
    fn within(&self, tool: &Tool<'_>, at: &Pose) -> Option<Spot> {
        let moved = Moved::whole(self.sheet, self.side, self.most);
        let found = clearance(&Sweep::still(tool, *at), &moved, 0.0, Aim::Nearest).nearest?;
        (found.0 < 0.0).then_some(found.2)
    }

    /// A gap beyond the greatest that no point of the tool is deeper than, at most `above` beyond it.
    fn afloat(&self, tool: &Tool<'_>, at: &Pose, above: f64, pad: f64) -> Option<f64> {
        /// Shares of it that are tried.
        const SHARES: [f64; 7] = [0.97, 0.9, 0.6, 0.25, 0.06, 0.015, 0.004];
        let pose = |_: f64| *at;
        for share in SHARES {
            let beyond = share * above;
            if beyond <= pad {
                break;
            }
            let least = self.most + beyond;
            match self.not_below(tool, self.side, least, &pose, 0.0, pad, &mut Warm::default()) {
                // What holds is short of that by what rounding may take.
                Half::Holds(low) if low > self.most => return Some(low),
                Half::Holds(_) => break,
                // A search that comes to no end does so again.
                Half::Open(_, f64::INFINITY) => break,
                Half::Open(..) | Half::Broken(..) => {}
            }
        }
        None
    }
}
