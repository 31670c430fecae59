//! Numbers of blocks: whole numbers of the least unit, written without a minus zero or an exponent.

use crate::machine::Format;

/// How numbers of one address are rounded and written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Number {
    /// Units of the last decimal in one: 10^decimals.
    scale: f64,
    decimals: u8,
    point: bool,
    zeros: bool,
    plus: bool,
}

/// Numbers beyond this many units of the last decimal are refused: above it f64 has no last decimal.
const MOST: f64 = 9e15;

impl Number {
    /// The format for output in inches or millimetres.
    pub(crate) fn new(format: &Format, inch: bool) -> Self {
        let decimals = if inch { format.inch.unwrap_or(format.mm) } else { format.mm }.min(9);
        let scale = (0..decimals).fold(1.0, |s, _| s * 10.0);
        Self { scale, decimals, point: format.point, zeros: format.zeros, plus: format.plus }
    }

    /// `value` in units of the last decimal; `None` when it is too great or not a number.
    #[inline]
    pub(crate) fn round(&self, value: f64) -> Option<i64> {
        let q = (value * self.scale).round();
        #[expect(clippy::cast_possible_truncation, reason = "a whole number below 2^53")]
        (q.abs() < MOST).then_some(q as i64)
    }

    /// The number that `q` units of the last decimal are.
    #[inline]
    pub(crate) fn value(&self, q: i64) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "below 2^53 by `round`")]
        let q = q as f64;
        q / self.scale
    }

    /// One unit of the last decimal.
    pub(crate) fn resolution(&self) -> f64 {
        1.0 / self.scale
    }

    /// The text of `q` units of the last decimal.
    pub(crate) fn text(&self, q: i64) -> String {
        let mut out = Vec::new();
        self.write(q, &mut out);
        String::from_utf8(out).expect("digits, a sign and a point")
    }

    /// Writes `q` units of the last decimal.
    #[inline]
    pub(crate) fn write(&self, q: i64, out: &mut Vec<u8>) {
        if q < 0 {
            out.push(b'-');
        } else if self.plus {
            out.push(b'+');
        }
        // The digits are made from the last to the first into the end of `text`.
        let mut text = [b'0'; 24];
        let mut at = text.len();
        let mut rest = q.unsigned_abs();
        let mut decimals = self.decimals;
        if !self.zeros {
            while decimals > 0 && rest.is_multiple_of(10) {
                rest /= 10;
                decimals -= 1;
            }
        }
        let whole = decimals == 0;
        for _ in 0..decimals {
            at -= 1;
            text[at] = digit(rest);
            rest /= 10;
        }
        if !whole || self.point {
            at -= 1;
            text[at] = b'.';
        }
        loop {
            at -= 1;
            text[at] = digit(rest);
            rest /= 10;
            if rest == 0 {
                break;
            }
        }
        out.extend_from_slice(&text[at..]);
    }
}

fn digit(n: u64) -> u8 {
    b'0' + u8::try_from(n % 10).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(format: Format, value: f64) -> String {
        let n = Number::new(&format, false);
        n.text(n.round(value).unwrap())
    }

    const PLAIN: Format = Format { mm: 3, inch: None, point: false, zeros: false, plus: false };

    #[test]
    fn no_minus_zero_no_exponent_no_needless_zero() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (-0.0004, "0"),
            (0.0005, "0.001"),
            (-12.5, "-12.5"),
            (100.0, "100"),
            (1e12, "1000000000000"),
            (1e-9, "0"),
            (0.07, "0.07"),
        ] {
            assert_eq!(written(PLAIN, value), text);
        }
    }

    #[test]
    fn point_zeros_and_sign_as_asked() {
        assert_eq!(written(Format { point: true, ..PLAIN }, 50.0), "50.");
        assert_eq!(written(Format { point: true, zeros: true, ..PLAIN }, 50.0), "50.000");
        assert_eq!(written(Format { plus: true, ..PLAIN }, 2.5), "+2.5");
        assert_eq!(written(Format { plus: true, ..PLAIN }, -0.0), "+0");
        assert_eq!(written(Format { mm: 0, point: true, ..PLAIN }, 7.0), "7.");
    }

    #[test]
    fn what_f64_cannot_hold_is_refused() {
        let n = Number::new(&PLAIN, false);
        assert_eq!(n.round(f64::NAN), None);
        assert_eq!(n.round(f64::INFINITY), None);
        assert_eq!(n.round(1e13), None);
    }

    proptest::proptest! {
        #[test]
        fn reads_back_to_the_last_decimal(value in -1e6..1e6_f64, mm in 0_u8..=6) {
            let f = Format { mm, ..PLAIN };
            let back: f64 = written(f, value).parse().unwrap();
            proptest::prop_assert!((back - value).abs() <= 0.5001 * Number::new(&f, false).resolution());
        }
    }
}
