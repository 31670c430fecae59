//! The fewest chords of an arc that the band allows.

use aptc_geometry::trig;

/// The band about the nominal circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ring {
    /// Nominal radius.
    pub(crate) radius: f64,
    /// How far a chord may go inwards.
    pub(crate) inner: f64,
    /// How far a vertex may go outwards.
    pub(crate) outer: f64,
}

/// A vertex: angle from the start of the arc and radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Vertex {
    pub(crate) angle: f64,
    pub(crate) radius: f64,
}

/// Ends of the chords that follow an arc of `sweep` radians from a vertex at the first radius to one at the second, both in the
/// band, as few as possible.
///
/// A chord between the circles spans most when both its ends lie on the outer one and it touches the inner
/// one: 2 acos((R - inner) / (R + outer)). The first and the last chord have one end at those radii, mostly on the nominal
/// circle. When the number is found, the share of the band that is used is made as small as the number
/// allows, so that nothing lies on the very edge of the band.
pub(crate) fn chords(ring: Ring, ends: [f64; 2], sweep: f64) -> Vec<Vertex> {
    let [start, radius] = ends;
    let end = Vertex { angle: sweep, radius };
    let n = count(ring, ends, sweep);
    if n <= 1 {
        return vec![end];
    }
    let share = share(ring, ends, sweep, n);
    let (low, high) = (ring.radius - share * ring.inner, ring.radius + share * ring.outer);
    let (first, step) = (half(low, start) + half(low, high), 2.0 * half(low, high));
    let last = half(low, radius) + half(low, high);
    // What rounding left goes into all chords alike.
    let planned = first + last + step * f64::from(n - 2);
    let scale = sweep / planned;
    let mut vertices: Vec<Vertex> = (0..n - 1)
        .map(|i| Vertex { angle: scale * (first + step * f64::from(i)), radius: high })
        .collect();
    vertices.push(end);
    vertices
}

/// The least number of chords.
pub(crate) fn count(ring: Ring, [start, end]: [f64; 2], sweep: f64) -> u32 {
    let (low, high) = (ring.radius - ring.inner, ring.radius + ring.outer);
    if low <= 0.0 {
        // The band holds the centre, so any chord of the circle lies in it.
        return 1;
    }
    let ends = half(low, start) + half(low, end);
    if sweep <= ends + 1e-12 {
        return 1;
    }
    let more = ((sweep - ends) / (2.0 * half(low, high)) - 1e-9).ceil();
    #[expect(clippy::cast_possible_truncation, reason = "clamped to the range of u32")]
    #[expect(clippy::cast_sign_loss, reason = "clamped to the range of u32")]
    let more = more.clamp(1.0, 4e9) as u32;
    1 + more
}

/// Angle between a vertex at radius `r` and the place where a line touches the circle of radius `low`.
fn half(low: f64, r: f64) -> f64 {
    trig::acos_clamped(low / r)
}

/// The least share of the band with which `n` chords suffice.
fn share(ring: Ring, [start, end]: [f64; 2], sweep: f64, n: u32) -> f64 {
    let reach = |share: f64| {
        let (low, high) = (ring.radius - share * ring.inner, ring.radius + share * ring.outer);
        if low <= 0.0 {
            return f64::INFINITY;
        }
        half(low, start) + half(low, end) + 2.0 * f64::from(n - 1) * half(low, high)
    };
    let (mut a, mut b) = (0.0, 1.0);
    for _ in 0..60 {
        let m = 0.5 * (a + b);
        if reach(m) >= sweep { b = m } else { a = m }
    }
    b
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fixed_ends(r: f64, inner: f64, outer: f64, sweep: f64) -> u32 {
        count(Ring { radius: r, inner, outer }, [r, r], sweep)
    }

    #[test]
    fn counts_are_the_published_least() {
        let tau = std::f64::consts::TAU;
        assert_eq!(fixed_ends(55.0, 0.05, 0.05, tau), 53);
        assert_eq!(fixed_ends(55.0, 0.005, 0.005, tau), 166);
        assert_eq!(fixed_ends(55.0, 0.0005, 0.0005, tau), 522);
        assert_eq!(fixed_ends(55.0, 0.0, 0.01, tau), 166);
        assert_eq!(fixed_ends(2.25, 0.0, 0.001, tau), 107);
        assert_eq!(fixed_ends(5.0, 0.001, 0.001, tau / 4.0), 29);
    }

    #[test]
    fn every_chord_stays_in_the_band_and_ends_are_nominal() {
        for (inner, outer) in [(0.0, 1e-3), (1e-3, 0.0), (5e-4, 2e-3)] {
            for sweep in [0.01, 0.3, 1.0, 3.0, 6.0] {
                let ring = Ring { radius: 2.0, inner, outer };
                let v = chords(ring, [2.0, 2.0], sweep);
                assert_eq!(v.last().map(|v| (v.angle, v.radius)), Some((sweep, 2.0)));
                let mut p = Vertex { angle: 0.0, radius: 2.0 };
                for q in v {
                    let d = q.angle - p.angle;
                    // Distance of the centre from the chord.
                    let (s, c) = trig::sin_cos(d);
                    let len = trig::hypot(q.radius * c - p.radius, q.radius * s);
                    let h = p.radius * q.radius * s / len;
                    assert!(h >= 2.0 - inner - 1e-12 && q.radius <= 2.0 + outer + 1e-12);
                    p = q;
                }
            }
        }
    }
}
