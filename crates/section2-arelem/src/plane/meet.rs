//! The end of a motion to a check surface that misses being tangent to the drive surface by less than the bands.

use super::curve::Curve;
use super::frame::Vec2;
use crate::state::Band;

/// A curve with the side of the tool, 0 on it, the distance at which it touches, and the band.
#[derive(Clone, Copy, Debug)]
pub(super) struct Touched {
    pub(super) curve: Curve,
    pub(super) side: f64,
    pub(super) reach: f64,
    pub(super) band: Band,
}

/// Cosine of the angle between two normals that are those of one tangent.
const ALIKE: f64 = 0.9;
/// Share of the size of the scene that is rounding, far below what the proof allows for it.
const EXACT: f64 = 1e-14;

impl Touched {
    /// The way out at a place, to the side of the tool, and the gap there.
    fn gap(&self, p: Vec2) -> Option<(Vec2, f64)> {
        let sign = if self.side < 0.0 { -1.0 } else { 1.0 };
        Some((self.curve.normal(p)? * sign, self.curve.distance(p) * sign - self.reach))
    }

    /// Least and greatest gap allowed; neither side of a line is its outside.
    fn allowed(&self) -> [f64; 2] {
        let Band { intol, outtol, .. } = self.band;
        match self.curve {
            Curve::Line { .. } if self.side == 0.0 => [-intol.max(outtol), intol.max(outtol)],
            _ => [-intol, outtol],
        }
    }
}

/// By how much the end `p` at the drive curve, where the check curve is to be tangent to it, lies outside of the band of that: the
/// least way along the normal to a place in both bands; none where there is no such place.
///
/// Coordinates of a drawing have some decimals: a line and a circle that are meant to be tangent miss it by as much.
pub(super) fn into_both(p: Vec2, drive: &Touched, check: &Touched) -> Vec2 {
    let ways = drive.gap(p).zip(check.gap(p));
    let Some(((out, gap), (other, apart))) = ways else { return Vec2::zeros() };
    let cos = out.dot(&other);
    if cos.abs() < ALIKE {
        return Vec2::zeros();
    }
    let [[low, high], [least, most]] = [drive.allowed(), check.allowed()];
    let miss = apart.clamp(least, most) - apart;
    let there = gap + miss / cos;
    let rounding = EXACT * (p.norm() + drive.reach + check.reach);
    // What both bands cannot take up stays as it is, and is told by the proof.
    if miss.abs() <= rounding || !(low..=high).contains(&there) {
        return Vec2::zeros();
    }
    out * (there - gap)
}
