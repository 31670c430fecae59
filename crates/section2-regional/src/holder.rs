//! HOLDER: shank and holder above the cutter.

use aptc_geometry::{Cutter, Profile, trig};
use aptc_protap::Arg;

use crate::failure::Failure;
use crate::regional::Regional;
use crate::scon::Words;

/// Corners of an outline at most.
const CORNERS: usize = 40;

impl Regional {
    /// HOLDER/d,z,d,z,...: the outline of shank and holder from below, a diameter and its height above the
    /// tool end for each corner, joined by straight lines. HOLDER/OFF takes them away.
    ///
    /// Kept as convex solids one above the other, so that any outline is held exactly.
    pub(crate) fn holder(&mut self, args: &[Arg]) -> Result<(), Failure> {
        let mut w = Words(args);
        self.watch.outside.clear();
        if w.take("OFF") {
            self.holder.clear();
            return Ok(());
        }
        let mut corners = Vec::new();
        while let (Some(d), Some(z)) = (w.number(), w.number()) {
            corners.push([d, z]);
            if corners.len() > CORNERS {
                let need = format!("at most {CORNERS}").into();
                let value = corners.len() as f64;
                return Err(Failure::Value {
                    what: "the number of corners of HOLDER",
                    value,
                    need,
                });
            }
        }
        self.holder = solids(&corners)?;
        Ok(())
    }
}

/// The solids between neighbouring corners of an outline.
fn solids(corners: &[[f64; 2]]) -> Result<Vec<(Profile, f64)>, Failure> {
    let mut all = Vec::with_capacity(corners.len());
    for pair in corners.windows(2) {
        let [[d, z], [e, top]] = [pair[0], pair[1]];
        for (what, value) in [("a diameter of HOLDER", d), ("a diameter of HOLDER", e)] {
            if value < 0.0 {
                return Err(Failure::Value { what, value, need: "0 or more".into() });
            }
        }
        if top < z || z < 0.0 {
            let need = format!("at least the height before it, {z}").into();
            return Err(Failure::Value { what: "a height of HOLDER", value: top, need });
        }
        // A step outwards or inwards has no body of its own.
        if top <= z {
            continue;
        }
        let height = top - z;
        let beta_deg = trig::atan2(0.5 * (e - d), height).to_degrees();
        let plain = Cutter::mill(d, 0.0, height);
        let profile = Profile::new(&Cutter { beta_deg, ..plain }).map_err(|_| Failure::Value {
            what: "a diameter of HOLDER",
            value: e,
            need: "such that the corners make a solid".into(),
        })?;
        all.push((profile, z));
    }
    if all.is_empty() {
        let need = "two corners or more, of different heights".into();
        let value = corners.len() as f64;
        return Err(Failure::Value { what: "the number of corners of HOLDER", value, need });
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::{Tool, Vec3};

    #[test]
    fn an_outline_with_a_neck_keeps_its_hollow() {
        // A shank that narrows to a neck, a step, and a cone.
        let all = solids(&[[10.0, 20.0], [6.0, 30.0], [20.0, 30.0], [30.0, 50.0]]).unwrap();
        assert_eq!(all.len(), 2);
        let distance = |q: Vec3| {
            let at = |(p, z): &(Profile, f64)| {
                Tool { profile: p, te: Vec3::z() * *z, ta: Vec3::z() }.distance(q)
            };
            all.iter().map(at).fold(f64::INFINITY, f64::min)
        };
        assert!(distance(Vec3::new(4.0, 0.0, 21.0)) < 0.0);
        assert!(distance(Vec3::new(4.0, 0.0, 28.0)) > 0.0);
        assert!(distance(Vec3::new(9.0, 0.0, 30.5)) < 0.0);
        assert!((distance(Vec3::new(15.0, 0.0, 50.0))).abs() < 1e-9);
        assert!(solids(&[[10.0, 20.0]]).is_err() && solids(&[[1.0, 5.0], [2.0, 4.0]]).is_err());
        assert!(solids(&[[-1.0, 5.0], [2.0, 14.0]]).is_err());
    }
}
