//! Numbers of CL text: shortest decimals without exponents, and fast reading.

use std::num::NonZeroI32;

/// How many decimals a writer gives.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Decimals {
    /// As many as it takes to read the same number back.
    #[default]
    Shortest,
    /// Rounded to so many, trailing zeros left off; at most 15.
    Fixed(u8),
}

/// Powers of ten that are exact.
const POW10: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

const PAIRS: &[u8; 200] = b"0001020304050607080910111213141516171819\
2021222324252627282930313233343536373839\
4041424344454647484950515253545556575859\
6061626364656667686970717273747576777879\
8081828384858687888990919293949596979899";

/// Appends `x`; zero has no sign. A number that is not finite is written as the largest there is, so that
/// no reader meets a word (the records are kept finite at their source).
pub fn put(out: &mut Vec<u8>, x: f64, decimals: Decimals) {
    let fitted = match decimals {
        Decimals::Shortest => {
            put_exact::<8>(out, x) || put_exact::<12>(out, x) || put_shortest(out, x)
        }
        Decimals::Fixed(n) => put_scaled(out, x, usize::from(n.min(15))),
    };
    if !fitted {
        let x = if x.is_finite() { x } else { f64::MAX.copysign(x) };
        put_any(out, x, decimals);
    }
}

/// Appends `x` with all of `places` decimals, at most 15, at the right of a column of `width`; zero has no sign.
pub fn put_column(out: &mut Vec<u8>, x: f64, places: u8, width: usize) {
    let places = usize::from(places.min(15));
    let Some(q) = scaled(x, places) else {
        out.extend_from_slice(format!("{x:>width$.places$}").as_bytes());
        return;
    };
    let mut digits = [b'0'; 24];
    let start = put_digits(&mut digits, q).min(digits.len() - places - 1);
    let (whole, fraction) = digits[start..].split_at(digits.len() - places - start);
    let minus = x < 0.0 && q > 0;
    let length = usize::from(minus) + whole.len() + usize::from(places > 0) + places;
    out.resize(out.len() + width.saturating_sub(length), b' ');
    if minus {
        out.push(b'-');
    }
    out.extend_from_slice(whole);
    if places > 0 {
        out.push(b'.');
        out.extend_from_slice(fraction);
    }
}

/// Longest number that [`put_exact`] makes: sign, 8 digits, point and 16 decimals, each copied as eight.
const LONGEST: usize = 32;
/// Eight decimals.
const EIGHT: u64 = 100_000_000;

/// Writes `x` with at most `PLACES` decimals, 8 or 12, when these read back the same number, which no shorter
/// ones do then; else writes nothing and gives false.
///
/// Up to 15 digits stand for one number only: the first of them that reads back is the shortest.
#[inline]
fn put_exact<const PLACES: usize>(out: &mut Vec<u8>, x: f64) -> bool {
    let unit = POW10[PLACES];
    let size = x.abs();
    let scaled = size * unit;
    // Nothing that is not finite gets further.
    if !(0.0..999_999_999_999_999.0).contains(&scaled) {
        return false;
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 <= it < 1e15")]
    let q = (scaled + 0.5) as u64;
    #[expect(
        clippy::float_cmp,
        reason = "the test is whether the digits read back the same number"
    )]
    if q as f64 / unit != size {
        return false;
    }
    // Of 12 decimals 16 are made, so that there are eights only; that stays below 2^64.
    let (whole, eights) = match PLACES {
        8 => (q / EIGHT, [q % EIGHT, 0]),
        _ => {
            let sixteen = q * 10_000;
            (sixteen / EIGHT / EIGHT, [sixteen / EIGHT % EIGHT, sixteen % EIGHT])
        }
    };
    let mut line = [b'-'; LONGEST];
    let mut at = usize::from(x < 0.0 && q > 0);
    // Below 1e7, for all of it has 15 digits; the lowest byte is the first digit, and one is always written.
    let digits = digit_values(whole);
    let zeros = (digits.trailing_zeros() / 8).min(7);
    line[at..at + 8].copy_from_slice(&((digits | ASCII_ZEROS) >> (8 * zeros)).to_le_bytes());
    at += 8 - zeros as usize;
    let mut end = at;
    line[at] = b'.';
    at += 1;
    for eight in eights.into_iter().take(PLACES.div_ceil(8)) {
        let digits = digit_values(eight);
        line[at..at + 8].copy_from_slice(&(digits | ASCII_ZEROS).to_le_bytes());
        at += 8;
        if eight != 0 {
            end = at - digits.leading_zeros() as usize / 8;
        }
    }
    // All of the line, for a copy of fixed size is much quicker, and then back to what counts.
    let start = out.len();
    out.extend_from_slice(&line);
    out.truncate(start + end);
    true
}

/// Sizes that [`put_shortest`] writes, and its digits before and behind the point at most.
const MIDDLING: std::ops::Range<f64> = 1e-9..1e15;
const SHORTEST: lexical_core::WriteFloatOptions = lexical_core::WriteFloatOptions::builder()
    .positive_exponent_break(NonZeroI32::new(16))
    .negative_exponent_break(NonZeroI32::new(-10))
    .trim_floats(true)
    .build_strict();

/// Writes `x` with the fewest digits that read back the same number, when it needs no exponent by far; else writes
/// nothing and gives false. Takes a third of the time of the standard library.
fn put_shortest(out: &mut Vec<u8>, x: f64) -> bool {
    use lexical_core::format::STANDARD;
    const SIZE: usize = SHORTEST.buffer_size_const::<f64, STANDARD>();
    if !MIDDLING.contains(&x.abs()) {
        return false;
    }
    let mut line = [0; SIZE];
    out.extend_from_slice(lexical_core::write_with_options::<_, STANDARD>(x, &mut line, &SHORTEST));
    true
}

/// Eight characters `0`.
const ASCII_ZEROS: u64 = 0x3030_3030_3030_3030;

/// The eight digits of `n` below 10^8, one a byte, the first in the lowest.
///
/// All of them at once: the fours from the eight, the pairs from the fours and the ones from the pairs; the
/// divisions by 100 and 10 are multiplications that are exact in their range.
#[inline]
fn digit_values(n: u64) -> u64 {
    let fours = (n / 10_000) | ((n % 10_000) << 32);
    let hundreds = ((fours * 10_486) >> 20) & 0x0000_007f_0000_007f;
    let pairs = hundreds | ((fours - 100 * hundreds) << 16);
    let tens = ((pairs * 103) >> 10) & 0x000f_000f_000f_000f;
    tens | ((pairs - 10 * tens) << 8)
}

/// The size of `x` in units of 10^-`places`, halves rounded up, when that is a number below 9e15.
fn scaled(x: f64, places: usize) -> Option<u64> {
    let (x, unit) = (x.abs(), POW10[places]);
    let scaled = x * unit;
    if scaled.is_nan() || scaled >= 9e15 {
        return None;
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 <= it < 9e15")]
    let whole = scaled as u64;
    let rest = scaled - whole as f64;
    // Half of a unit may be what rounding has made of a product that is less.
    let up = rest >= 0.5 && (rest > 0.5 || x.mul_add(unit, -scaled) >= 0.0);
    Some(whole + u64::from(up))
}

/// Writes `x` as an integer of 10^-`places`; false when it does not fit.
fn put_scaled(out: &mut Vec<u8>, x: f64, places: usize) -> bool {
    let Some(q) = scaled(x, places) else {
        return false;
    };
    if q == 0 {
        out.push(b'0');
        return true;
    }
    if x < 0.0 {
        out.push(b'-');
    }
    let mut digits = [b'0'; 24];
    let start = put_digits(&mut digits, q).min(digits.len() - places - 1);
    let point = digits.len() - places;
    out.extend_from_slice(&digits[start..point]);
    let fraction = &digits[point..];
    let kept = fraction.iter().rposition(|&b| b != b'0').map_or(0, |i| i + 1);
    if kept > 0 {
        out.push(b'.');
        out.extend_from_slice(&fraction[..kept]);
    }
    true
}

/// Digits of `q` at the end of the buffer, two at a time; the place of the first.
fn put_digits(digits: &mut [u8; 24], mut q: u64) -> usize {
    let mut at = digits.len();
    while q >= 100 {
        let pair = usize::try_from(q % 100).expect("below 100") * 2;
        q /= 100;
        at -= 2;
        digits[at..at + 2].copy_from_slice(&PAIRS[pair..pair + 2]);
    }
    let pair = usize::try_from(q).expect("below 100") * 2;
    at -= 1;
    digits[at] = PAIRS[pair + 1];
    if q >= 10 {
        at -= 1;
        digits[at] = PAIRS[pair];
    }
    at
}

/// Any finite number, by the library: it never writes exponents here.
fn put_any(out: &mut Vec<u8>, x: f64, decimals: Decimals) {
    use std::io::Write;
    let start = out.len();
    let written = match decimals {
        Decimals::Shortest => write!(out, "{x}"),
        Decimals::Fixed(n) => write!(out, "{:.*}", usize::from(n.min(15)), x),
    };
    written.expect("a vector takes all");
    if out[start..].contains(&b'.') {
        while out.last() == Some(&b'0') {
            out.pop();
        }
        if out.last() == Some(&b'.') {
            out.pop();
        }
    }
}

/// Reads the number at the head of `text`: its value and length. Signs, `5.`, `.5`, exponents with E or
/// FORTRAN's D; no leading blanks. `None` when no number stands there or when it is not finite.
pub fn parse_head(text: &[u8]) -> Option<(f64, usize)> {
    parse_at(text, 0)
}

/// As [`parse_head`], of the number that begins at `start`: its value and the place behind it.
#[inline]
pub fn parse_at(text: &[u8], start: usize) -> Option<(f64, usize)> {
    let first = text.get(start).copied().unwrap_or(0);
    let negative = first == b'-';
    let begin = start + usize::from(negative | (first == b'+'));
    let signed = |x: f64| if negative { -x } else { x };
    // Up to eight digits before the point and behind it, as nearly all numbers are.
    if let Some((whole, n)) = eight_digits(text, begin)
        && text.get(begin + n) == Some(&b'.')
        && let Some((fraction, n_decimals)) = eight_digits(text, begin + n + 1)
    {
        let end = begin + n + 1 + n_decimals;
        let mantissa = whole * UP_TO_EIGHT[n_decimals] + fraction;
        let ends = !matches!(text.get(end), Some(b'0'..=b'9' | b'E' | b'e' | b'D' | b'd'));
        if ends && n + n_decimals > 0 && mantissa < 1 << 53 {
            return Some((signed(mantissa as f64 / POW10[n_decimals]), end));
        }
    }
    parse_long(text, start, begin, negative)
}

/// As [`parse_at`], of any number; its digits begin at `begin`.
#[inline(never)]
fn parse_long(text: &[u8], start: usize, begin: usize, negative: bool) -> Option<(f64, usize)> {
    let (mut mantissa, mut n_digits) = take_digits(text, begin, 0);
    let mut at = begin + n_digits;
    let mut n_decimals = 0;
    if text.get(at) == Some(&b'.') {
        (mantissa, n_decimals) = take_digits(text, at + 1, mantissa);
        at += 1 + n_decimals;
        n_digits += n_decimals;
    }
    if n_digits == 0 {
        return None;
    }
    let exponent = exponent_at(text, at);
    // Up to 19 digits the mantissa did not overflow; below 2^53 it is exact, and so is the division by a
    // power of ten up to 22: one rounding, the right one.
    if exponent.is_none() && n_digits <= 19 && n_decimals <= 22 && mantissa < 1 << 53 {
        let value = mantissa as f64 / POW10[n_decimals];
        return Some((if negative { -value } else { value }, at));
    }
    let end = exponent.unwrap_or(at);
    let value = parse_slowly(text.get(start..end)?)?;
    Some((value, end))
}

/// `mantissa` with the digits from `at` on behind it, modulo 2^64, and how many they are.
#[inline]
fn take_digits(text: &[u8], at: usize, mut mantissa: u64) -> (u64, usize) {
    let mut end = at;
    while let Some((value, n)) = eight_digits(text, end) {
        mantissa = mantissa.wrapping_mul(UP_TO_EIGHT[n]).wrapping_add(value);
        end += n;
        if n < 8 {
            return (mantissa, end - at);
        }
    }
    while let Some(d) = text.get(end).map(|b| b.wrapping_sub(b'0')).filter(|d| *d < 10) {
        mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(d));
        end += 1;
    }
    (mantissa, end - at)
}

/// Powers of ten as integers.
const UP_TO_EIGHT: [u64; 9] =
    [1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000];

/// The eight bytes from `at` on, the first the lowest, with zeros behind the end of the text; `None` when the
/// whole text is shorter.
#[inline]
fn eight_bytes(text: &[u8], at: usize) -> Option<u64> {
    if let Some(bytes) = text.get(at..at + 8) {
        return Some(u64::from_le_bytes(bytes.try_into().ok()?));
    }
    // The last number of a line: what was before it is shifted out.
    let last = u64::from_le_bytes(*text.last_chunk()?);
    let missing = at + 8 - text.len();
    Some(if missing < 8 { last >> (8 * missing) } else { 0 })
}

/// Value and count of the digits at the head of the eight bytes from `at` on; `None` when the text is shorter
/// than eight.
///
/// All eight are looked at together: how many digits a number has cannot be foretold, so that a branch for
/// each would often go the wrong way. After D. Lemire, "Number parsing at a gigabyte per second" (2021).
#[inline]
fn eight_digits(text: &[u8], at: usize) -> Option<(u64, usize)> {
    // A digit becomes its value, 10 and more is none.
    let values = eight_bytes(text, at)? ^ ASCII_ZEROS;
    let others = (values.wrapping_add(0x7676_7676_7676_7676) | values) & 0x8080_8080_8080_8080;
    let n = others.trailing_zeros() / 8;
    if n == 0 {
        return Some((0, 0));
    }
    // Zeros in front, then pairs, fours and eight.
    let ones = values << (64 - 8 * n);
    let pairs = ones.wrapping_mul(10).wrapping_add(ones >> 8) & 0x00ff_00ff_00ff_00ff;
    let fours = pairs.wrapping_mul(100).wrapping_add(pairs >> 16) & 0x0000_ffff_0000_ffff;
    let eight = fours.wrapping_mul(10_000).wrapping_add(fours >> 32) & 0xffff_ffff;
    Some((eight, n as usize))
}

/// End of an exponent that begins at `at`, if a whole one stands there.
fn exponent_at(text: &[u8], at: usize) -> Option<usize> {
    if !matches!(text.get(at), Some(b'E' | b'e' | b'D' | b'd')) {
        return None;
    }
    let mut end = at + 1;
    if matches!(text.get(end), Some(b'+' | b'-')) {
        end += 1;
    }
    let first = end;
    while text.get(end).is_some_and(u8::is_ascii_digit) {
        end += 1;
    }
    (end > first).then_some(end)
}

/// The number that is all of `text`, by the library.
fn parse_slowly(text: &[u8]) -> Option<f64> {
    let text = text.strip_prefix(b"+").unwrap_or(text);
    let direct = || lexical_core::parse::<f64>(text).ok();
    let value = if text.iter().any(|b| matches!(b, b'D' | b'd')) {
        let as_e: Vec<u8> =
            text.iter().map(|b| if matches!(b, b'D' | b'd') { b'E' } else { *b }).collect();
        lexical_core::parse::<f64>(&as_e).ok()
    } else {
        direct()
    };
    value.filter(|v| v.is_finite())
}

/// The number that is all of `text` but for blanks, which may stand anywhere outside and after the sign.
pub fn parse(text: &[u8]) -> Option<f64> {
    let text = text.trim_ascii();
    if let Some((value, len)) = parse_head(text) {
        return (len == text.len()).then_some(value);
    }
    // FORTRAN formats may leave blanks between the sign and the digits.
    let (sign, rest) = text.split_first()?;
    let rest = rest.trim_ascii_start();
    let (value, len) = parse_head(rest).filter(|_| rest.first().is_some_and(u8::is_ascii_digit))?;
    match sign {
        _ if len != rest.len() => None,
        b'-' => Some(-value),
        b'+' => Some(value),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn text(x: f64, decimals: Decimals) -> String {
        let mut out = Vec::new();
        put(&mut out, x, decimals);
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn numbers_as_people_write_them() {
        for (x, short) in [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1"),
            (-2.5, "-2.5"),
            (100.0, "100"),
            (0.001, "0.001"),
            (-0.000_001, "-0.000001"),
            (1e-9, "0.000000001"),
            (1_234_567_890_123.0, "1234567890123"),
            (0.1 + 0.2, "0.30000000000000004"),
            (1e21, "1000000000000000000000"),
            (12_345.678_9, "12345.6789"),
            (123.000_001, "123.000001"),
            (10.000_000_01, "10.00000001"),
            (-999_999_999.5, "-999999999.5"),
            (0.000_000_5, "0.0000005"),
            (7.123_456_000_001, "7.123456000001"),
        ] {
            assert_eq!(text(x, Decimals::Shortest), short);
        }
        for (x, n, fixed) in [
            (1.234_56, 4, "1.2346"),
            (-0.000_04, 4, "0"),
            (2.0, 4, "2"),
            (-1.5, 0, "-2"),
            (1e18, 3, "1000000000000000000"),
            (9.999_99, 4, "10"),
        ] {
            assert_eq!(text(x, Decimals::Fixed(n)), fixed);
        }
    }

    #[test]
    fn columns_keep_their_zeros() {
        let column = |x: f64, places, width| {
            let mut out = Vec::new();
            put_column(&mut out, x, places, width);
            String::from_utf8(out).unwrap()
        };
        assert_eq!(column(-1.5, 6, 13), "    -1.500000");
        assert_eq!(column(-1e-9, 6, 10), "  0.000000");
        assert_eq!(column(12_345_678.25, 3, 4), "12345678.250");
        assert_eq!(column(2.5, 0, 3), "  3");
        // A little less than a half, which the product by 10^6 rounds to one.
        assert_eq!(column(0.000_003_5, 6, 8), "0.000003");
        assert_eq!(column(999_999.999_999_5, 6, 13), "999999.999999");
        assert_eq!(column(-0.062_5, 4, 8), " -0.0625");
        assert_eq!(column(1e300, 1, 4), format!("{:.1}", 1e300));
    }

    #[test]
    fn all_groups_of_digits() {
        for n in (0..100_000_000_u64).step_by(9_973).chain(0..10_000).chain(99_990_000..EIGHT) {
            let digits = (digit_values(n) | ASCII_ZEROS).to_le_bytes();
            assert_eq!(std::str::from_utf8(&digits).unwrap(), format!("{n:08}"));
        }
    }

    /// A number that is the last of its line is read eight digits at a time too.
    #[test]
    fn numbers_within_a_line() {
        let line = b"GOTO/-12.345678,+0.5,1234567890.125";
        assert_eq!(parse_at(line, 5), Some((-12.345_678, 15)));
        assert_eq!(parse_at(line, 16), Some((0.5, 20)));
        assert_eq!(parse_at(line, 21), Some((1_234_567_890.125, line.len())));
        assert_eq!(parse_at(line, line.len() - 3), Some((125.0, line.len())));
        assert_eq!((parse_at(line, 4), parse_at(line, 99)), (None, None));
    }

    #[test]
    fn numbers_as_files_have_them() {
        for (t, x) in [
            ("5.", 5.0),
            (".5", 0.5),
            ("+.25", 0.25),
            ("1.E-3", 0.001),
            ("1D2", 100.0),
            ("-1.5d+01", -15.0),
            (" - 3.5 ", -3.5),
            ("0.1", 0.1),
            ("123456789012345678901234567890", 1.234_567_890_123_456_8e29),
            ("0.00000000000000000000000012345", 1.2345e-25),
            ("12345678", 12_345_678.0),
            ("1234567.25", 1_234_567.25),
            ("-0.12345678", -0.123_456_78),
            ("123456789.87654321", 123_456_789.876_543_21),
        ] {
            assert_eq!(parse(t.as_bytes()), Some(x), "{t}");
        }
        for t in ["", ".", "-", "1EX", "1E", "NAN", "inf", "1..2", "3PT2SL", "1e999", "- ", "- -1"]
        {
            assert_eq!(parse(t.as_bytes()), None, "{t}");
        }
        assert_eq!(parse_head(b"1.5,2"), Some((1.5, 3)));
        assert_eq!(parse_head(b"1EX"), Some((1.0, 1)));
    }

    proptest! {
        #[test]
        fn shortest_reads_back(x in prop_oneof![
            proptest::num::f64::NORMAL | proptest::num::f64::SUBNORMAL | proptest::num::f64::ZERO,
            (-1_000_000_000_i64..1_000_000_000).prop_map(|q| q as f64 / 1e4),
            (-1e6_f64..1e6),
            (1.0_f64..2.0, -40..60_i32).prop_map(|(m, e)| m * 2.0_f64.powi(e)),
        ]) {
            let t = text(x, Decimals::Shortest);
            prop_assert!(!t.contains(['e', 'E']));
            prop_assert_eq!(parse(t.as_bytes()), Some(x), "{}", t);
            // As short as the standard library's, whose last digit may be another where two are as near.
            prop_assert!(x == 0.0 || t.len() <= x.to_string().len(), "{t} {x}");
        }

        #[test]
        fn reading_agrees_with_the_library(t in "-?[0-9]{1,20}(\\.[0-9]{0,25})?(E-?[0-9]{1,2})?") {
            prop_assert_eq!(parse(t.as_bytes()), t.parse::<f64>().ok());
        }
    }
}
