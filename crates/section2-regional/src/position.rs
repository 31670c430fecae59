//! The cutter put against a contact.

use aptc_contact::Tool;
use aptc_geometry::{Profile, Segment, Vec3};
use aptc_protap::ToolAxis;

/// A position of the tool with its contact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Position {
    /// Tool end.
    pub(crate) te: Vec3,
    /// Unit tool axis.
    pub(crate) ta: Vec3,
    /// Parameters of the part surface at the contact.
    pub(crate) part_uv: [f64; 2],
    /// The contact on the part surface.
    pub(crate) contact: Vec3,
    /// Unit normal there, towards the tool.
    pub(crate) normal: Vec3,
    /// What the position takes of the tolerance, positive off the surface.
    pub(crate) shift: f64,
    /// Parameters of the drive.
    pub(crate) drive_uv: [f64; 2],
    /// What of the cutter touches; the arc where the tool end lies on the surface.
    pub(crate) segment: Segment,
    /// What avoidance has moved the tool end by.
    pub(crate) lift: Vec3,
}

impl Position {
    /// Does the tool stand on the side to which its axis does not point, so that its shank passes through the surface?
    pub(crate) fn stands_through(&self) -> bool {
        self.normal.dot(&self.ta) < -1e-6
    }
}

/// What is odd about the positions of a path: the first tool ends at which the cutter touches with a place that does not cut well, and
/// how far it got out of the way.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Odd {
    /// With its tip.
    pub(crate) tip: Option<Vec3>,
    /// With the edge of its top.
    pub(crate) rim: Option<Vec3>,
    /// The greatest lift of avoidance, and the tool end there.
    pub(crate) high: Option<(f64, Vec3)>,
}

impl Odd {
    pub(crate) fn of(points: &[Position]) -> Self {
        let first = |s: Segment| points.iter().find(|p| p.segment == s).map(|p| p.te);
        let lifted = points.iter().filter(|p| p.lift != Vec3::zeros());
        let lifts = lifted.map(|p| (p.lift.norm(), p.te));
        let high = lifts.reduce(|a, b| if b.0 > a.0 { b } else { a });
        Self { tip: first(Segment::Tip), rim: first(Segment::Rim), high }
    }

    /// What stands here, else what stands there.
    pub(crate) fn or(self, other: Self) -> Self {
        let higher = |a: (f64, Vec3)| other.high.is_none_or(|b| a.0 >= b.0);
        let high = self.high.filter(|a| higher(*a)).or(other.high);
        Self { tip: self.tip.or(other.tip), rim: self.rim.or(other.rim), high }
    }
}

/// The tool end for a contact at `contact` whose unit normal `n` points to the tool, with `thick` between
/// cutter and surface.
///
/// APT: `TULPOS`, `TECALC`, for all seven segments: the place of the cutter whose outward normal is `-n`.
/// Where a flat bottom lies on the surface, the contact is under the corner on the side of `last`, the
/// unit direction square to the axis from the contact to the axis of the position before.
pub(crate) fn tool_end(
    profile: &Profile,
    ta: Vec3,
    contact: Vec3,
    n: Vec3,
    thick: f64,
    last: Vec3,
) -> Vec3 {
    let tool = Tool { profile, te: Vec3::zeros(), ta };
    let radial = n - ta * n.dot(&ta);
    let [rho, z] = profile.joints()[0];
    let lowest = -tool.support(-ta).reach;
    let flat = (z - lowest).abs() <= 1e-12 * profile.reach();
    // The squared sine below which normal and axis are taken for parallel.
    let place = if flat && radial.norm_squared() < 1e-12 && n.dot(&ta) > 0.0 {
        let out = -(last - ta * last.dot(&ta)).try_normalize(0.0).unwrap_or_else(Vec3::zeros);
        out * rho + ta * lowest
    } else {
        tool.support(-level(n, ta)).point
    };
    contact + n * thick - place
}

/// The normal at a contact of the flank, square to the axis where it is but for digits: the rim of the top does not count as what touches
/// for those of an arc that ends level.
pub(crate) fn level(n: Vec3, ta: Vec3) -> Vec3 {
    /// Sine up to which it is. A flank a hundred times as long as the surface is exact is no farther off.
    const EVEN: f64 = 1e-9;
    let up = n.dot(&ta);
    if up.abs() > EVEN { n } else { (n - ta * up).normalize() }
}

/// RADIUS and HIGHT of TLAXIS: where on its bottom or its flank the cutter is to touch.
///
/// They count where the bottom or the flank as a whole lies along the surface, where any place of it would do;
/// elsewhere the cutter touches where its shape does.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Chosen {
    /// Distance of the place from the axis, which counts for the bottom.
    pub(crate) radius: Option<f64>,
    /// Height of the place above the tool end, which counts for the flank.
    pub(crate) height: Option<f64>,
}

impl Chosen {
    /// Of a rule of TLAXIS.
    pub(crate) fn of(axis: Option<&ToolAxis>) -> Self {
        match axis {
            Some(ToolAxis::Parallel { radius, height, .. }) => {
                Self { radius: *radius, height: *height }
            }
            Some(ToolAxis::Angle(a)) => Self { radius: a.radius, height: a.height },
            _ => Self::default(),
        }
    }

    /// With which face the cutter touches at a contact of the unit normal `n`, the number that counts there,
    /// and its range; `None` where no face lies along the surface.
    pub(crate) fn counts(
        &self,
        profile: &Profile,
        ta: Vec3,
        n: Vec3,
    ) -> Option<(Segment, Option<f64>, [f64; 2])> {
        let [lower, upper] = profile.joints();
        let segment = Tool { profile, te: Vec3::zeros(), ta }.support(-level(n, ta)).segment;
        match segment {
            Segment::LowerLine => Some((segment, self.radius, [0.0, lower[0]])),
            Segment::UpperLine => Some((segment, self.height, [upper[1], profile.height()])),
            _ => None,
        }
    }

    /// The tool end for a contact, as [`tool_end`] has it, with the place that is chosen at the contact; `None`
    /// where nothing is chosen. With a flat bottom that place is on the side away from `last`.
    pub(crate) fn tool_end(
        &self,
        profile: &Profile,
        ta: Vec3,
        contact: Vec3,
        n: Vec3,
        thick: f64,
        last: Vec3,
    ) -> Option<Vec3> {
        if *self == Self::default() {
            return None;
        }
        let (segment, value, [least, most]) = self.counts(profile, ta, n)?;
        let value = value.filter(|x| (least..=most).contains(x))?;
        // The face runs square to its normal (out, up) of the half plane.
        let (level, up) = (-(n - ta * n.dot(&ta)), -n.dot(&ta));
        let out = level.norm();
        let (rho, z) = if segment == Segment::LowerLine {
            (value, profile.bottom() - out / up * value)
        } else {
            let [_, [rho, z]] = profile.joints();
            (rho - up / out * (value - z), value)
        };
        let away = if out > 1e-6 { level / out } else { -(last - ta * last.dot(&ta)) };
        let away = away.try_normalize(0.0).unwrap_or_else(Vec3::zeros);
        Some(contact + n * thick - away * rho - ta * z)
    }
}

/// Unit direction square to the axis from a contact to the axis, `None` where the normal stands along it.
pub(crate) fn toward_axis(n: Vec3, ta: Vec3) -> Option<Vec3> {
    let radial = n - ta * n.dot(&ta);
    (radial.norm_squared() >= 1e-12).then(|| radial.normalize())
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_geometry::{Cutter, trig};

    #[test]
    fn published_positions() {
        let ball = Profile::new(&Cutter::mill(10.0, 5.0, 40.0)).unwrap();
        let ta = Vec3::new(0.3, -0.4, 1.0).normalize();
        let te = tool_end(&ball, ta, Vec3::zeros(), Vec3::z(), 0.0, Vec3::x());
        assert!((te - (Vec3::z() - ta) * 5.0).norm() < 1e-14);
        let bull = Profile::new(&Cutter::mill(20.0, 3.0, 40.0)).unwrap();
        let ta = Vec3::new(0.5, 0.0, 0.75_f64.sqrt());
        let te = tool_end(&bull, ta, Vec3::zeros(), Vec3::z(), 0.0, Vec3::x());
        assert!((te - Vec3::new(-7.562_177_8, 0.0, 3.901_923_8)).norm() < 1e-6, "{te}");
        // The same surface parametrised the other way round gives the same normal, hence the same place;
        // thickness lifts along it.
        let lifted = tool_end(&bull, ta, Vec3::zeros(), Vec3::z(), 0.25, Vec3::x());
        assert!((lifted - te - Vec3::z() * 0.25).norm() < 1e-15);
    }

    /// A tapered cutter whose flank or bottom cone lies along a plane: wherever it is said to touch, all of the
    /// face is on the plane and the place that was named is at the contact.
    #[test]
    fn the_place_on_a_face_is_that_of_radius_and_hight() {
        // Both lines meet 10 from the axis, and the corner is tangent to them.
        let (alpha_deg, beta_deg, r) = (20.0, 10.0, 3.0);
        let [sa, ca] = [trig::sin_deg(alpha_deg), trig::cos_deg(alpha_deg)];
        let [sb, cb] = [trig::sin_deg(beta_deg), trig::cos_deg(beta_deg)];
        let slope = sa / ca;
        let e = (10.0 * cb + r / ca * sb - 10.0 * slope * sb - r) / (cb - sb * slope);
        let f = (r + e * sa) / ca;
        let cutter = Cutter { e, f, alpha_deg, beta_deg, ..Cutter::mill(20.0, r, 60.0) };
        let profile = Profile::new(&cutter).unwrap();
        let contact = Vec3::new(3.0, -2.0, 7.0);
        let n = Vec3::z();
        // The normals of both faces make these angles with the axis.
        for (deg, chosen, face) in [
            (20.0, Chosen { radius: Some(2.5), height: None }, Segment::LowerLine),
            (80.0, Chosen { radius: None, height: Some(31.0) }, Segment::UpperLine),
        ] {
            let (sin, cos) = (trig::sin_deg(deg), trig::cos_deg(deg));
            let ta = Vec3::new(sin, 0.0, cos);
            assert_eq!(chosen.counts(&profile, ta, n).map(|c| c.0), Some(face), "{deg}");
            let te = chosen.tool_end(&profile, ta, contact, n, 0.5, Vec3::x()).unwrap();
            let tool = Tool { profile: &profile, te, ta };
            // The cutter is thick above the plane, and the named place is over the contact.
            assert!((tool.support(-n).point.z - (contact.z + 0.5)).abs() < 1e-12);
            let from = contact + n * 0.5 - te;
            let (z, rho) = (from.dot(&ta), (from - ta * from.dot(&ta)).norm());
            let named = if face == Segment::LowerLine { rho } else { z };
            let asked = chosen.radius.or(chosen.height).unwrap();
            assert!((named - asked).abs() < 1e-12, "{named} {asked}");
            assert!(profile.near(rho, z).distance.abs() < 1e-12);
            // Beyond the face, and with the other number alone, it does not count.
            let other = Chosen { radius: chosen.height, height: chosen.radius };
            assert!(other.tool_end(&profile, ta, contact, n, 0.5, Vec3::x()).is_none());
        }
        let flat = Profile::new(&Cutter::mill(20.0, 3.0, 40.0)).unwrap();
        let chosen = Chosen { radius: Some(4.0), height: None };
        let te = chosen.tool_end(&flat, n, Vec3::zeros(), n, 0.0, -Vec3::y()).unwrap();
        assert!((te - Vec3::new(0.0, -4.0, 0.0)).norm() < 1e-14, "{te}");
        let wide = Chosen { radius: Some(7.5), height: None };
        assert!(wide.tool_end(&flat, n, Vec3::zeros(), n, 0.0, -Vec3::y()).is_none());
    }

    #[test]
    fn a_flat_bottom_keeps_the_side_of_the_last_contact() {
        let flat = Profile::new(&Cutter::mill(20.0, 3.0, 40.0)).unwrap();
        let te = tool_end(&flat, Vec3::z(), Vec3::zeros(), Vec3::z(), 0.0, -Vec3::y());
        assert!((te - Vec3::new(0.0, -7.0, 0.0)).norm() < 1e-14, "{te}");
    }
}
