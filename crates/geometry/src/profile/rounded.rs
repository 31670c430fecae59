//! Where a cutter is a disk made thicker all around, as far as its distance goes.

use crate::profile::Profile;

impl Profile {
    /// Is the solid, for all places between `rhos` from the axis and between the heights `zs`, no nearer than the disk
    /// across the axis with the corner's centres for its edge, less the corner's radius?
    ///
    /// So it is where the corner arc is faced, and where a flat bottom is that goes over into the arc; also for places
    /// inside, as deep as the disk is far. Beside the upper line the solid is nearer.
    #[inline]
    pub fn is_rounded(&self, rhos: [f64; 2], zs: [f64; 2]) -> bool {
        if !(self.r > 0.0 && self.c.x >= 0.0 && self.a0.x >= 0.0 && self.a1.x >= 0.0) {
            return false;
        }
        // What is asked is linear, so that the corners decide.
        let [near, far] = rhos.map(|rho| rho - self.c.x);
        let [low, high] = zs.map(|z| z - self.c.y);
        let least = |x: f64, y: f64| {
            (x * if x > 0.0 { near } else { far }) + (y * if y > 0.0 { low } else { high })
        };
        let level = self.nl.x == 0.0 && self.a0 == self.nl;
        let above = if level { -high } else { least(-self.a0.y, self.a0.x) };
        above >= 0.0 && least(self.a1.y, -self.a1.x) >= 0.0
    }
}

#[cfg(test)]
mod tests {
    use crate::Cutter;
    use crate::profile::Profile;
    use crate::profile::distance::tests::cutter;
    use proptest::prelude::*;

    #[test]
    fn mills_are_rounded_below() {
        for r in [2.0, 5.0, 6.0] {
            let p = Profile::new(&Cutter::mill(12.0, r, 60.0)).unwrap();
            assert!(p.is_rounded([0.0, 9.0], [-1.0, 0.6]));
            assert!(!p.is_rounded([3.0; 2], [0.0, r + 0.5]) && !p.is_rounded([7.0; 2], [20.0; 2]));
        }
        let sharp = Profile::new(&Cutter::mill(12.0, 0.0, 60.0)).unwrap();
        assert!(!sharp.is_rounded([3.0; 2], [-1.0; 2]));
    }

    proptest! {
        #[test]
        fn what_is_rounded_is_no_nearer_than_the_disk(
            kind in 0_usize..8, s in prop::array::uniform4(0.05_f64..0.95),
            at in prop::array::uniform2(-1.0_f64..1.0), room in 0.0_f64..2.0,
            off in prop::array::uniform2(-1.0_f64..1.0),
        ) {
            let p = Profile::new(&cutter(kind, s)).unwrap();
            let (rho, z) = (20.0 * at[0].abs(), 20.0 * at[1]);
            prop_assume!(p.is_rounded([rho - room, rho + room], [z - room, z + room]));
            let (rho, z) = ((rho + room * off[0]).abs(), z + room * off[1]);
            let [e, f] = p.corner();
            let out = (rho - e).max(0.0);
            let disk = (out * out + (z - f) * (z - f)).sqrt();
            prop_assert!(p.near(rho, z).distance >= disk - p.corner_radius() - 1e-9 * p.reach());
        }
    }
}
