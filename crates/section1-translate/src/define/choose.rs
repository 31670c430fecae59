//! Choosing among solutions by XLARGE .. ZSMALL and POSX .. NEGZ.

use aptc_geometry::{Vec2, Vec3};
use aptc_vocabulary::{Word, word};

use super::fault::Fault;
use super::format::Args;

/// XLARGE XSMALL YLARGE YSMALL.
pub(super) const XY_MODS: &[Word] = &[word::XLARGE, word::XSMALL, word::YLARGE, word::YSMALL];

/// The same with ZLARGE ZSMALL.
pub(super) const XYZ_MODS: &[Word] =
    &[word::XLARGE, word::XSMALL, word::YLARGE, word::YSMALL, word::ZLARGE, word::ZSMALL];

/// POSX .. NEGZ.
pub(super) const SENSES: &[Word] =
    &[word::POSX, word::POSY, word::POSZ, word::NEGX, word::NEGY, word::NEGZ];

/// Share of their distance by which two solutions must differ along an axis to be told apart by it, and
/// least component of a unit vector that gives it a sense along that axis. Below it, rounding decides.
const TOLD_APART: f64 = 1e-9;

/// The unit vector that a modifier stands for: XLARGE and POSX are +x.
pub(super) fn toward(modifier: Word) -> Option<Vec3> {
    Some(match modifier {
        word::XLARGE | word::POSX => Vec3::x(),
        word::XSMALL | word::NEGX => -Vec3::x(),
        word::YLARGE | word::POSY => Vec3::y(),
        word::YSMALL | word::NEGY => -Vec3::y(),
        word::ZLARGE | word::POSZ => Vec3::z(),
        word::ZSMALL | word::NEGZ => -Vec3::z(),
        _ => return None,
    })
}

impl Args<'_> {
    /// The unit vector of the modifier at `at`.
    pub(super) fn toward(&self, at: usize) -> Result<Vec3, Fault> {
        toward(self.word(at)?).ok_or(Fault::Kind { at })
    }

    /// Of two solutions the one that the modifier at `at` asks for.
    pub(super) fn pick(&self, at: usize, one: Vec3, other: Vec3) -> Result<Vec3, Fault> {
        let axis = self.toward(at)?;
        let apart = one - other;
        let lead = axis.dot(&apart);
        if lead.abs() <= TOLD_APART * apart.norm() && apart.norm() > 0.0 {
            return Err(Fault::Undecided { at, one, other });
        }
        Ok(if lead < 0.0 { other } else { one })
    }

    /// The same in the plane, lifted to ZSURF.
    pub(super) fn pick2(&self, at: usize, one: Vec2, other: Vec2) -> Result<Vec3, Fault> {
        self.pick(at, self.context.lift(one), self.context.lift(other))
    }

    /// +1 when the unit normal `n` points to the side that the modifier at `at` names, -1 when away.
    pub(super) fn side(&self, at: usize, n: Vec3) -> Result<f64, Fault> {
        let lead = self.toward(at)?.dot(&n);
        if lead.abs() <= TOLD_APART * n.norm() {
            return Err(Fault::NoSide { at, normal: n });
        }
        Ok(lead.signum())
    }

    /// The same for a normal of the plane.
    pub(super) fn side2(&self, at: usize, n: Vec2) -> Result<f64, Fault> {
        self.side(at, Vec3::new(n.x, n.y, 0.0))
    }
}
