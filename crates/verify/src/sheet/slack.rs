//! Charts of a quadric that hardly bends along one of its axes, such as a cylinder whose coefficients were printed. Its middle
//! along that axis is a quotient of two numbers that rounding has made and may lie at any distance: these charts begin at the
//! foot of the origin instead, and hold what they leave out for no longer than it stays small.

use aptc_geometry::{Vec3, trig};

use super::{Jet, Patch, Patches, Spot};

/// A share of the greatest bend along an axis, below which its middle is not counted on: with it at that share a place is still
/// known to some seven digits less than its coordinates.
pub(crate) const SLACK: f64 = 1e-5;

/// Square of the least share that a graph rises to of what the form does.
const STEEP: f64 = 1e-6;

/// A length that no part has.
const ALL: f64 = 1e150;

/// Numbers of the charts from here on are of this kind.
const FIRST: usize = 16;

/// `sum lambda y^2 + 2 beta . y + k = 0`, with the slack axis last, and without linear terms along the axes that bend.
#[derive(Clone, Debug)]
pub(super) struct Slack {
    pub(super) lambda: Vec3,
    pub(super) beta: Vec3,
    pub(super) k: f64,
    kind: Kind,
    /// How far from the origin along the parameters of a graph, or along the slack axis, the charts hold.
    far: f64,
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    /// Over x and y the root next to 0 of `lambda z^2 + 2 beta z + s(x, y) = 0`.
    Graph,
    /// `x^2/a^2 + y^2/b^2 = q(z)` over the angle and z, with the coefficients of `q` from the constant on.
    Tube([f64; 2], [f64; 3]),
    /// `x^2/a^2 - y^2/b^2 = q(z)` over y / b and z, two of them.
    Sheets([f64; 2], [f64; 3]),
}

/// Values and first two derivatives of a function of one parameter.
type Jet1 = [f64; 3];

impl Slack {
    /// `None` where such charts hold nowhere.
    pub(super) fn new(lambda: Vec3, beta: Vec3, k: f64) -> Option<Self> {
        let [x, y, z] = [lambda.x, lambda.y, lambda.z];
        // As far as a linear and a square term stay within a bound.
        let within = |square: f64, linear: f64, bound: f64| {
            let far = 2.0 * bound / (linear + (linear * linear + 4.0 * square * bound).sqrt());
            if bound <= 0.0 { 0.0 } else { far.min(ALL) }
        };
        let new = |kind, far| Some(Self { lambda, beta, k, kind, far }).filter(|_| far > 0.0);
        let steepest = x.abs().max(y.abs());
        if beta.z * beta.z > STEEP * (steepest * k).abs() {
            let linear = 2.0 * (beta.x.abs() + beta.y.abs());
            let rest = 0.5 * beta.z * beta.z / z.abs() - k.abs();
            let far = if z == 0.0 { ALL } else { within(x.abs() + y.abs(), linear, rest) };
            if far * far * steepest > k.abs() {
                return new(Kind::Graph, far);
            }
        }
        let bends = |l: f64, b: f64| l != 0.0 && b == 0.0;
        if !(bends(x, beta.x) && bends(y, beta.y) && k != 0.0) {
            return None;
        }
        // With the constant on the other side as something positive.
        let sign = -k.signum();
        let q = [k, 2.0 * beta.z, z].map(|c| -sign * c);
        let far = within(q[2].abs(), q[1].abs(), 0.5 * q[0]);
        let semi = [x, y].map(|l| 1.0 / l.abs().sqrt());
        match [x, y].map(|l| l * sign > 0.0) {
            [true, true] => new(Kind::Tube(semi, q), far),
            [true, false] => new(Kind::Sheets(semi, q), far),
            _ => None,
        }
    }

    /// Does the chart belong to these?
    pub(super) fn has(chart: usize) -> bool {
        chart >= FIRST
    }

    /// The pieces that hold all of the surface within the sphere, when all of it is in these charts; `None` when not, and else
    /// whether they were not too many.
    pub(super) fn roots(&self, c: Vec3, r: f64, out: &mut Patches) -> Option<bool> {
        const QUARTER: f64 = std::f64::consts::FRAC_PI_4;
        let mut push = |chart: usize, at: [f64; 2], half: [f64; 2]| {
            out.push(Patch { chart: FIRST + chart, at, half, ..Patch::default() })
        };
        match self.kind {
            Kind::Graph => {
                let wide = c.x.abs().max(c.y.abs()) + r <= self.far;
                // The other root lies farther off than half of what the middle does.
                let alone = (c.z.abs() + r) * self.lambda.z.abs() <= self.beta.z.abs();
                (wide && alone).then(|| push(0, [c.x, c.y], [r, r]))
            }
            Kind::Tube(..) => (c.z.abs() + r <= self.far).then(|| {
                (0..4).all(|i| push(0, [QUARTER * f64::from(2 * i - 3), c.z], [QUARTER, r]))
            }),
            Kind::Sheets([_, b], _) => (c.z.abs() + r <= self.far)
                .then(|| (0..2).all(|i| push(i, [c.y / b, c.z], [r / b, r]))),
        }
    }

    /// The place itself within the charts.
    pub(super) fn settle(&self, spot: Spot) -> Spot {
        let [u, v] = spot.at;
        let clamped = |x: f64| x.clamp(-self.far, self.far);
        match self.kind {
            Kind::Graph => Spot { at: [clamped(u), clamped(v)], ..spot },
            Kind::Tube(..) | Kind::Sheets(..) => Spot { at: [u, clamped(v)], ..spot },
        }
    }

    /// Half the gradient of the form.
    pub(super) fn half_gradient(&self, y: Vec3) -> Vec3 {
        self.lambda.component_mul(&y) + self.beta
    }

    pub(super) fn jet(&self, spot: &Spot) -> Jet {
        let [u, v] = spot.at;
        let (p, d) = match self.kind {
            Kind::Graph => {
                let [z, dz, _] = self.root(self.rest(u, v));
                let [su, sv] = self.rise(u, v);
                (Vec3::new(u, v, z), [Vec3::new(1.0, 0.0, dz * su), Vec3::new(0.0, 1.0, dz * sv)])
            }
            Kind::Tube([a, b], q) => {
                let (sin, cos) = trig::sin_cos(u);
                let [w, dw, _] = width(&q, v);
                let out = Vec3::new(a * cos, b * sin, 0.0);
                let along = Vec3::new(-a * sin, b * cos, 0.0);
                (out * w + Vec3::z() * v, [along * w, out * dw + Vec3::z()])
            }
            Kind::Sheets([a, b], q) => {
                let a = Self::of_sheet(spot.chart, a);
                let [q, dq] = [q[0] + v * (q[1] + v * q[2]), q[1] + 2.0 * v * q[2]];
                let w = (q.max(0.0) + u * u).sqrt();
                let d = [Vec3::new(a * u / w, b, 0.0), Vec3::new(0.5 * a * dq / w, 0.0, 1.0)];
                (Vec3::new(a * w, b * u, v), d)
            }
        };
        let n = crate::solid::unit_or(self.half_gradient(p), Vec3::z());
        Jet { p, d, n }
    }

    /// A length along x on the sheet of a chart.
    fn of_sheet(chart: usize, a: f64) -> f64 {
        if chart == FIRST { a } else { -a }
    }

    /// Bounds of the second derivatives over a piece: uu, uv, vv.
    pub(super) fn second(&self, patch: &Patch) -> [f64; 3] {
        match self.kind {
            Kind::Graph => {
                let ([su, sv], [_, dz, ddz]) = (self.steepest(patch), self.root_over(patch));
                let [x, y] = [self.lambda.x, self.lambda.y].map(|l| 2.0 * dz * l.abs());
                [x + ddz * su * su, ddz * su * sv, y + ddz * sv * sv]
            }
            Kind::Tube([a, b], q) => {
                width_over(&q, patch.at[1], patch.half[1]).map(|w| a.max(b) * w)
            }
            Kind::Sheets([a, _], q) => sheet_over(&q, patch).0.map(|x| a * x),
        }
    }

    /// Second derivatives in the middle of a piece, and how much they differ on it: uu, uv, vv.
    pub(super) fn bend(&self, patch: &Patch) -> ([Vec3; 3], [f64; 3]) {
        let ([u, v], [hu, hv]) = (patch.at, patch.half);
        match self.kind {
            Kind::Graph => {
                let ([su, sv], [_, dz, ddz]) = (self.rise(u, v), self.root(self.rest(u, v)));
                let [x, y] = [self.lambda.x, self.lambda.y].map(|l| 2.0 * l);
                let bend = [dz * x + ddz * su * su, ddz * su * sv, dz * y + ddz * sv * sv];
                let ([tu, tv], [.., most]) = (self.steepest(patch), self.root_over(patch));
                let by = most * (tu * hu + tv * hv);
                let [same, mixed] = [2.0, 2.0].map(|k| k * most);
                let vary =
                    [x.abs() * by + same * tu * tu, mixed * tu * tv, y.abs() * by + same * tv * tv];
                (bend.map(|z| Vec3::new(0.0, 0.0, z)), vary)
            }
            Kind::Tube([a, b], q) => {
                let (sin, cos) = trig::sin_cos(u);
                let [w, dw, ddw] = width(&q, v);
                let out = Vec3::new(a * cos, b * sin, 0.0);
                let along = Vec3::new(-a * sin, b * cos, 0.0);
                let [t, dt, ddt] = width_over(&q, v, hv);
                let vary = [t * hu + dt * hv, dt * hu + ddt * hv, ddt * hu + 2.0 * ddt];
                ([out * -w, along * dw, out * ddw], vary.map(|x| a.max(b) * x))
            }
            Kind::Sheets([a, _], q) => {
                let at = Self::of_sheet(patch.chart, a);
                let [f, df] = [q[0] + v * (q[1] + v * q[2]), q[1] + 2.0 * v * q[2]];
                let w = (f.max(0.0) + u * u).sqrt();
                let cube = w * w * w;
                let bend = [f / cube, -0.5 * u * df / cube, q[2] / w - 0.25 * df * df / cube];
                let (_, vary) = sheet_over(&q, patch);
                (bend.map(|x| Vec3::new(at * x, 0.0, 0.0)), vary.map(|x| a * x))
            }
        }
    }

    /// The form without its terms in z, at a place of a graph.
    fn rest(&self, x: f64, y: f64) -> f64 {
        let [l, b] = [&self.lambda, &self.beta];
        (l.x * x + 2.0 * b.x) * x + (l.y * y + 2.0 * b.y) * y + self.k
    }

    /// Its slopes.
    fn rise(&self, x: f64, y: f64) -> [f64; 2] {
        let half = self.half_gradient(Vec3::new(x, y, 0.0));
        [2.0 * half.x, 2.0 * half.y]
    }

    /// The steepest ones over a piece.
    fn steepest(&self, patch: &Patch) -> [f64; 2] {
        let slope = |l: f64, b: f64, i: usize| {
            2.0 * ((l * patch.at[i] + b).abs() + l.abs() * patch.half[i])
        };
        [slope(self.lambda.x, self.beta.x, 0), slope(self.lambda.y, self.beta.y, 1)]
    }

    /// The height of a graph over the rest of the form, and its derivatives by that: with `r^2 = beta^2 - lambda s` they are
    /// `-1 / (2 r)` and `-lambda / (4 r^3)`, with the sign of beta.
    fn root(&self, s: f64) -> Jet1 {
        let (l, b) = (self.lambda.z, self.beta.z);
        let r = (b * b - l * s).max(0.0).sqrt().copysign(b);
        [-s / (b + r), -0.5 / r, -0.25 * l / (r * r * r)]
    }

    /// Bounds of those over a piece.
    fn root_over(&self, patch: &Patch) -> Jet1 {
        let [su, sv] = self.steepest(patch);
        let by = su * patch.half[0] + sv * patch.half[1];
        let (l, b) = (self.lambda.z, self.beta.z);
        let s = self.rest(patch.at[0], patch.at[1]);
        // At most half of the square of beta is left out where the chart holds.
        let square = b * b - l * s - l.abs() * by;
        let r = square.max(0.0).sqrt();
        [f64::INFINITY, 0.5 / r, 0.25 * l.abs() / (r * r * r)]
    }
}

/// The root of a polynomial of the second degree, with its derivatives.
fn width(q: &[f64; 3], z: f64) -> Jet1 {
    let value = q[0] + z * (q[1] + z * q[2]);
    let slope = q[1] + 2.0 * z * q[2];
    let w = value.max(0.0).sqrt();
    [w, 0.5 * slope / w, q[2] / w - 0.25 * slope * slope / (w * w * w)]
}

/// Bounds of those about `z`.
fn width_over(q: &[f64; 3], z: f64, half: f64) -> Jet1 {
    let value = q[0] + z * (q[1] + z * q[2]);
    let slope = (q[1] + 2.0 * z * q[2]).abs() + 2.0 * half * q[2].abs();
    let [least, most] = [-1.0, 1.0].map(|s| (value + s * half * slope).max(0.0).sqrt());
    let steep = slope / least;
    [most, 0.5 * steep, q[2].abs() / least + 0.25 * steep * steep / least]
}

/// Bounds of the second derivatives of `sqrt(q(z) + u^2)` over a piece, uu, uz, zz, and of how much they differ on it from those
/// in its middle.
fn sheet_over(q: &[f64; 3], patch: &Patch) -> ([f64; 3], [f64; 3]) {
    let ([u, z], [hu, hz]) = (patch.at, patch.half);
    let value = q[0] + z * (q[1] + z * q[2]);
    let steep = (q[1] + 2.0 * z * q[2]).abs() + 2.0 * hz * q[2].abs();
    let [least, most] = [-1.0, 1.0].map(|s| (value + s * hz * steep).max(0.0));
    let [near, far] = [(u.abs() - hu).max(0.0), u.abs() + hu];
    let w = (least + near * near).sqrt();
    let cube = w * w * w;
    let second =
        [most / cube, 0.5 * far * steep / cube, q[2].abs() / w + 0.25 * steep * steep / cube];
    // The third derivatives uuu and uuz are -3 q u / w^5 and q' / w^3 - 3 q q' / (2 w^5).
    let uuu = 3.0 * most * far / (cube * w * w);
    let uuz = steep / cube * (1.0 + 1.5 * most / (w * w));
    let vary = [uuu * hu + uuz * hz, 2.0 * second[1], 2.0 * second[2]];
    (second, vary)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// One of each kind that bends along its last axis as much as the others, nearly, so that every term counts.
    fn all() -> [Slack; 5] {
        let of = |lambda: [f64; 3], beta: [f64; 3], k: f64| {
            Slack::new(Vec3::from(lambda), Vec3::from(beta), k).expect("charts")
        };
        [
            of([0.1, 0.3, 1e-3], [0.0, 0.0, 2e-3], -2.0),
            of([0.1, 0.3, -1e-3], [0.0, 0.0, 2e-3], -2.0),
            of([0.1, -0.3, 1e-3], [0.0, 0.0, -2e-3], -2.0),
            of([0.2, 0.1, 0.02], [0.0, 0.0, -1.0], 1.0),
            of([0.2, -0.01, -0.02], [0.0, 0.1, 0.5], 0.3),
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        #[test]
        fn charts_lie_on_the_surface_and_bend_by_no_more_than_is_told(
            i in 0_usize..5, second in any::<bool>(), at in prop::array::uniform2(-0.7_f64..0.7),
            half in prop::array::uniform2(0.001_f64..0.3), place in prop::array::uniform2(-1.0_f64..1.0),
        ) {
            let s = &all()[i];
            let round = |x: [f64; 2]| match s.kind {
                Kind::Graph => x.map(|x| x * s.far),
                Kind::Tube(..) => [x[0] * 4.0, x[1] * s.far],
                Kind::Sheets(..) => [x[0] * 3.0, x[1] * s.far],
            };
            let chart = FIRST + usize::from(second && matches!(s.kind, Kind::Sheets(..)));
            let patch = Patch { chart, at: round(at), half: round(half), ..Patch::default() };
            let there = [0, 1].map(|k| patch.at[k] + place[k] * patch.half[k]);
            let jet = |at: [f64; 2]| s.jet(&Spot { chart, at });
            let here = jet(there);
            let value = (s.half_gradient(here.p) + s.beta).dot(&here.p) + s.k;
            prop_assert!(value.abs() < 1e-12 * (1.0 + here.p.norm_squared()), "{value}");
            prop_assert!(here.n.dot(&s.half_gradient(here.p)) > 0.0);
            // Derivatives by differences over a short way.
            let step = 1e-5;
            let beside = |k: usize, by: f64| {
                jet([0, 1].map(|i| if i == k { there[i] + by } else { there[i] }))
            };
            let slope = |k: usize| (beside(k, step).p - beside(k, -step).p) / (2.0 * step);
            let bend = |k: usize, l: usize| (beside(k, step).d[l] - beside(k, -step).d[l]) / (2.0 * step);
            for k in 0..2 {
                prop_assert!((slope(k) - here.d[k]).norm() < 1e-7 * (1.0 + here.d[k].norm()));
            }
            let ((middle, vary), most) = (s.bend(&patch), s.second(&patch));
            for (j, [k, l]) in [[0, 0], [0, 1], [1, 1]].into_iter().enumerate() {
                let is = bend(k, l);
                let off = 1e-6 * (1.0 + is.norm());
                prop_assert!((is - bend(l, k)).norm() < off, "{is} {}", bend(l, k));
                prop_assert!(is.norm() <= most[j] + off, "{j}: {is} {most:?}");
                prop_assert!((is - middle[j]).norm() <= vary[j] + off, "{j}: {is} {middle:?} {vary:?}");
            }
        }
    }
}
