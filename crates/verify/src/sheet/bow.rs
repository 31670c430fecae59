//! Bowed boxes about charts: a group of pieces of a crest or a hollow lies in one that is thin.

use aptc_geometry::Vec3;

use super::patched::Node;

/// Where the charts of a node are laid out.
pub(super) struct Frame {
    pub(super) center: Vec3,
    pub(super) e: [Vec3; 3],
    /// Half lengths of the box along them.
    pub(super) lengths: [f64; 3],
}

impl Frame {
    /// A vector by the first sides, and along the normal.
    fn own(&self, w: Vec3) -> [f64; 3] {
        let share = |i: usize| if self.lengths[i] > 0.0 { 1.0 / self.lengths[i] } else { 0.0 };
        [self.e[0].dot(&w) * share(0), self.e[1].dot(&w) * share(1), self.e[2].dot(&w)]
    }

    /// The bow that middles and corners of the charts have, by least squares; none where they do not tell.
    pub(super) fn bow(&self, leaves: &[Node]) -> [f64; 2] {
        const PLACES: [[f64; 2]; 5] =
            [[0.0, 0.0], [1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];
        let places = leaves.iter().flat_map(|n| {
            PLACES.map(|[a, b]| {
                let place = n.center + n.half[0] * a + n.half[1] * b;
                let bowed = n.normal * (n.bow[0] * a * a + n.bow[1] * b * b);
                let [s, t, z] = self.own(place + bowed - self.center);
                [s * s, t * t, z]
            })
        });
        let n = (PLACES.len() * leaves.len()) as f64;
        let (mut sum, mut square, mut cross) = (Vec3::zeros(), Vec3::zeros(), Vec3::zeros());
        for [s, t, z] in places {
            sum += Vec3::new(s, t, z);
            square += Vec3::new(s * s, s * t, t * t);
            cross += Vec3::new(s * z, t * z, 0.0);
        }
        let mean = sum / n;
        let moment = |all: f64, a: f64, b: f64| all / n - a * b;
        let ss = moment(square.x, mean.x, mean.x);
        let st = moment(square.y, mean.x, mean.y);
        let tt = moment(square.z, mean.y, mean.y);
        let (sz, tz) = (moment(cross.x, mean.x, mean.z), moment(cross.y, mean.y, mean.z));
        let det = ss * tt - st * st;
        if det > 1e-3 * ss * tt {
            [(sz * tt - tz * st) / det, (tz * ss - sz * st) / det]
        } else if ss > tt {
            [sz / ss, 0.0]
        } else if tt > 0.0 {
            [0.0, tz / tt]
        } else {
            [0.0; 2]
        }
    }

    /// Between which heights over the bow all points of the charts lie.
    ///
    /// With x and y from -1 to 1 along the sides of a chart, `q = bow[0] x^2 + bow[1] y^2` its own bow and L what its sides add to
    /// the place along the first two axes, a point is at `place + L + normal q`, thick all around. Its height over the bow of
    /// the frame is that of the middle, what goes evenly in x and y, a form of second degree, in which both bows take each
    /// other away, and what is left of the squares of the place.
    pub(super) fn heights(&self, bow: [f64; 2], leaves: &[Node]) -> [f64; 2] {
        let of = |n: &Node| {
            let [s, t, z] = self.own(n.center - self.center);
            let [a, b] = [n.half[0], n.half[1]].map(|h| self.own(h));
            let normal = self.own(n.normal);
            let slope = [2.0 * bow[0] * s, 2.0 * bow[1] * t];
            let over = |w: &[f64; 3]| w[2] - slope[0] * w[0] - slope[1] * w[1];
            let middle = z - bow[0] * s * s - bow[1] * t * t;
            let by =
                [0, 1].map(|k| if self.lengths[k] > 0.0 { n.thick / self.lengths[k] } else { 0.0 });
            let around = n.thick + slope[0].abs() * by[0] + slope[1].abs() * by[1];
            let product = |v: &[f64; 3], w: &[f64; 3]| bow[0] * v[0] * w[0] + bow[1] * v[1] * w[1];
            let square = [
                n.bow[0] * over(&normal) - product(&a, &a),
                n.bow[1] * over(&normal) - product(&b, &b),
            ];
            let cross = 2.0 * product(&a, &b).abs();
            let rest = [0, 1].map(|k| {
                let by = by[k] + normal[k].abs() * (n.bow[0].abs() + n.bow[1].abs());
                bow[k].abs() * (2.0 * (a[k].abs() + b[k].abs()) + by) * by
            });
            let room = over(&a).abs() + over(&b).abs() + around + cross + rest[0] + rest[1];
            let [down, up] =
                [-1.0, 1.0].map(|x| square.iter().map(|q| (x * q).max(0.0)).sum::<f64>());
            [middle - room - down, middle + room + up]
        };
        leaves
            .iter()
            .map(of)
            .fold([f64::INFINITY, f64::NEG_INFINITY], |b, l| [b[0].min(l[0]), b[1].max(l[1])])
    }
}
