//! Curves that go over a border of a patch and back between two of their places.

/// Bends of a parameter that are not held against its border: on both sides of it the curves are one.
const BULGE: f64 = 1e-8;
/// Share of a bend up to which its distance to a border does not tell on which side it ends.
const NEAR: f64 = 0.1;
/// Halvings by which the lowest place is found.
const HALVINGS: u32 = 40;

/// Does a parameter come to its border, or too near to tell, between these two values that it leaves and comes to at these rates?
pub(super) fn strays([a, b]: [f64; 2], [from, to]: [f64; 2]) -> bool {
    // The border towards which it goes.
    let (a, b) = if from > 0.0 { (1.0 - a, 1.0 - b) } else { (a, b) };
    let (down, up) = (from.abs(), to * -from.signum());
    if up <= 0.0 {
        return false;
    }
    let least = a.min(b);
    if least > 0.3 * down.max(up) {
        return false;
    }
    let lowest = lowest([a, b], [-down, up]);
    least - lowest > BULGE && lowest < NEAR * (least - lowest)
}

/// The lowest value of a cubic with these ends and slopes, the first falling and the second rising.
fn lowest([a, b]: [f64; 2], [from, to]: [f64; 2]) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    let slope = |t: f64| {
        let way = 6.0 * t * (1.0 - t) * (b - a);
        way + from * (1.0 - t) * (1.0 - 3.0 * t) + to * t * (3.0 * t - 2.0)
    };
    for _ in 0..HALVINGS {
        let t = 0.5 * (low + high);
        if slope(t) < 0.0 { low = t } else { high = t }
    }
    let t = low;
    let s = 1.0 - t;
    a * s * s * (1.0 + 2.0 * t) + from * t * s * s + b * t * t * (3.0 - 2.0 * t) - to * t * t * s
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_that_comes_to_its_border() {
        // x = (t - 1 / 2)^2 + gap, and the same below the other border.
        let both = |gap: f64| {
            let end = 0.25 + gap;
            [strays([end, end], [-1.0, 1.0]), strays([1.0 - end, 1.0 - end], [1.0, -1.0])]
        };
        assert_eq!([-0.1, 0.0, 0.02].map(both), [[true; 2]; 3]);
        assert_eq!([0.03, 0.3].map(both), [[false; 2]; 2]);
        assert!(!strays([0.0, 0.5], [0.5, 0.5]));
        assert!((lowest([0.3, 0.3], [-1.0, 1.0]) - 0.05).abs() < 1e-12);
    }
}
