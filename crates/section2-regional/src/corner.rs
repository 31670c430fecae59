//! Where the corner of a cutter touches, sought in another way than by normals.

use aptc_contact::{Clear, PatchTree, Tool};
use aptc_geometry::Vec3;
use aptc_geometry::sculpt::Derivatives;

use crate::afar::SAME;
use crate::patience::Patience;
use crate::project::{Met, Probe, STEPS, Shot};

/// Steps in parameters from which the search by normals goes on.
const ABOUT: f64 = 1e-6;

impl Shot<'_> {
    /// A meeting that the corner of a cutter is led to.
    pub(crate) fn round(&self, start: [f64; 2], there: Derivatives) -> Option<Met> {
        self.corner(start, there).and_then(|(uv, there)| self.slope(uv, there))
    }

    /// A meeting that the corner of a cutter is led to from `start`, where nothing is in front of it: for where `near` finds none.
    pub fn beside(&self, start: [f64; 2], tree: &PatchTree) -> Option<Met> {
        let Probe::Cutter { profile, ta, thick } = self.probe else { return None };
        let met = self.round(start, self.surface.at(start[0], start[1]))?;
        let size = self.extent + self.from.norm() + profile.reach();
        let tool = Tool { profile, te: self.from + self.along * met.way, ta };
        (tree.clear(&tool, SAME * size - thick) == Clear::Yes).then_some(met)
    }

    /// A place about where the corner touches, from `start` by Newton's method for the parameters and the way together: the place is
    /// as far from the circle of the corner's middles as it is to be, and its tangents are square to that way. Where the normal is
    /// about the tool axis `slope` jumps round the circle; this does not.
    fn corner(&self, start: [f64; 2], mut d: Derivatives) -> Option<([f64; 2], Derivatives)> {
        let Probe::Cutter { profile, ta, thick } = self.probe else { return None };
        let ([wide, high], round) = (profile.corner(), profile.corner_radius() + thick);
        if wide <= 0.0 || round <= 0.0 {
            return None;
        }
        let [mut u, mut v] = start;
        let n = d.normal()? * self.side;
        let mut way = (d.point + self.reach(n).to - self.from).dot(&self.along);
        let mut patience = Patience::default();
        for _ in 0..STEPS {
            let q = d.point - self.from - self.along * way;
            let up = q.dot(&ta);
            let side = q - ta * up;
            let rho = side.norm();
            let out = side.try_normalize(0.0)?;
            let m = out * (rho - wide) + ta * (up - high);
            let length = m.norm();
            let n = m.try_normalize(0.0)?;
            // Second derivatives of the distance from the circle: in the half plane through the axis, and round it.
            let (along, round_it) = (out * n.dot(&ta) - ta * n.dot(&out), ta.cross(&out));
            let bend = |a: &Vec3, b: &Vec3| {
                along.dot(a) * along.dot(b) / length
                    + round_it.dot(a) * round_it.dot(b) * n.dot(&out) / rho
            };
            let missing = Vec3::new(length - round, n.dot(&d.u), n.dot(&d.v));
            let uv = bend(&d.u, &d.v) + n.dot(&d.uv);
            let row =
                |t: &Vec3, first: f64, second: f64| Vec3::new(first, second, -bend(t, &self.along));
            let rates = [
                Vec3::new(missing.y, missing.z, -n.dot(&self.along)),
                row(&d.u, bend(&d.u, &d.u) + n.dot(&d.uu), uv),
                row(&d.v, uv, bend(&d.v, &d.v) + n.dot(&d.vv)),
            ];
            let by = solved(rates, -missing)?;
            let far = missing.x.abs()
                + missing.y.abs() / d.u.norm() * round
                + missing.z.abs() / d.v.norm() * round;
            if patience.ends(far) {
                return None;
            }
            way += by.z * (0.5 / by.x.abs().max(by.y.abs())).clamp(0.0, 1.0);
            [u, v] = self.stepped([u, v], [by.x, by.y]);
            d = self.surface.at(u, v);
            if by.x.abs().max(by.y.abs()) <= ABOUT {
                return Some(([u, v], d));
            }
        }
        None
    }
}

/// The solution of three linear equations by their rows.
fn solved([a, b, c]: [Vec3; 3], of: Vec3) -> Option<Vec3> {
    let x = b.cross(&c) * of.x + c.cross(&a) * of.y + a.cross(&b) * of.z;
    let x = x / a.dot(&b.cross(&c));
    x.iter().all(|x| x.is_finite()).then_some(x)
}
