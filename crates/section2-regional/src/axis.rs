//! The tool axis at a place.

use aptc_geometry::{Vec3, trig};
use aptc_protap::ToolAxis;

use crate::area::AxisArea;
use crate::drive::DrivePoint;
use crate::failure::Failure;

/// Two axes are equally near to a third where their cosines to it differ by no more: digits do not choose between them.
const TIE: f64 = 1e-9;

/// The axis before the part surface is met; for an axis tilted against the part surface this is where the
/// search for it starts.
///
/// APT: `AXSET`. The slew is towards the direction across the path, laid square to the normal, the tilt
/// towards the motion. Along a curve NORMDS is its CRSSPL. `None` where normal or directions vanish.
pub(crate) fn at_drive(area: &AxisArea, p: &DrivePoint, forward: Vec3) -> Option<Vec3> {
    match *area {
        AxisArea::Fixed(v) => Some(v),
        AxisArea::NormDs(sign) => p.normal.or(p.cross).map(|n| n * sign),
        AxisArea::Angle { part: true, .. } => p.normal.or_else(|| p.direction.map(|d| -d)),
        AxisArea::Angle { part: false, alpha, beta } => {
            let n = p.normal?;
            let (sa, ca) = trig::sin_cos(alpha);
            let slewed = if alpha == 0.0 { n } else { n * ca + square(p.across, n)? * sa };
            let (sb, cb) = trig::sin_cos(beta);
            if beta == 0.0 {
                return Some(slewed);
            }
            Some(slewed * cb + square(forward, slewed)? * sb)
        }
        AxisArea::Ruling { lines, sense } => {
            // From one line to the next the path goes along the rulings.
            let along = if p.course == lines { p.across } else { p.along };
            along.try_normalize(0.0).map(|along| along * sense)
        }
        AxisArea::Square { to, side, alpha, sense } => {
            // In the plane square to `to` the normal's part of length c: cos alpha = c cos of the turn from it.
            let n = p.normal? * side;
            let part = n - to * to.dot(&n);
            let c = part.norm();
            // As near to the normal as it can be, for no angle.
            let cos = alpha.map_or(c, trig::cos);
            if c < 1e-9 || cos.abs() > c {
                return None;
            }
            let (e, f) = (part / c, to.cross(&part) / c);
            let turn = trig::acos_clamped(cos / c);
            Some(e * trig::cos(turn) + f * (trig::sin(turn) * sense))
        }
    }
}

/// Of two axes that differ by the sense of an area, +1 or -1, that of the one at a place which is nearer to the axis `last`.
fn nearer(area: impl Fn(f64) -> AxisArea, start: &DrivePoint, last: Vec3) -> AxisArea {
    let cos =
        |sense: f64| at_drive(&area(sense), start, start.along).map_or(-1.0, |ta| ta.dot(&last));
    area(if cos(-1.0) > cos(1.0) + TIE { -1.0 } else { 1.0 })
}

/// The rule of TLAXIS for lines of a surface whose tool stands on `side` of dU x dV; `last` is the axis before, and the first line
/// begins at the place `start`. Of two axes that satisfy it all lines have that which is nearer to the axis before there.
pub(crate) fn of_line(
    axis: Option<&ToolAxis>,
    side: f64,
    last: Vec3,
    start: &DrivePoint,
) -> Result<AxisArea, Failure> {
    Ok(match axis {
        None => AxisArea::Fixed(Vec3::z()),
        Some(ToolAxis::Fixed(v)) => AxisArea::Fixed(v.try_normalize(0.0).unwrap_or_else(Vec3::z)),
        Some(ToolAxis::Keep) => AxisArea::Fixed(last),
        Some(ToolAxis::NormPs | ToolAxis::NormDs) => AxisArea::NormDs(side),
        Some(ToolAxis::Parallel { .. }) => {
            nearer(|sense| AxisArea::Ruling { lines: start.course, sense }, start, last)
        }
        Some(ToolAxis::PerpTo(v)) => {
            let to = v.try_normalize(0.0);
            let to = to.ok_or(Failure::NoDirection { what: "the vector of PERPTO" })?;
            // Square to the vector and as near to the normal as that lets it be.
            AxisArea::Square { to, side, alpha: None, sense: 1.0 }
        }
        Some(ToolAxis::Angle(a)) => {
            let alpha = a.angle_deg.to_radians();
            let lead_deg = a.cutting_deg.unwrap_or(0.0);
            match a.reference.and_then(|v| v.try_normalize(0.0)) {
                None => {
                    let alpha = beside(a.angle_deg, lead_deg)?;
                    AxisArea::Angle { part: true, alpha, beta: lead_deg.to_radians() }
                }
                Some(_) if lead_deg != 0.0 => {
                    let what = "GOLOFT with ATANGL square to a vector and CUTANG";
                    return Err(Failure::Undone { what });
                }
                Some(to) => {
                    let alpha = Some(alpha);
                    nearer(|sense| AxisArea::Square { to, side, alpha, sense }, start, last)
                }
            }
        }
        Some(ToolAxis::Last) => {
            return Err(Failure::Undone { what: "GOLOFT behind TLAXIS/LAST with no axis before" });
        }
    })
}

/// The lean across the motion, radians, of an axis that makes the angle `alpha_deg` with the normal and leans by `beta_deg` along
/// the motion, as TLAXIS has it; SCON gives both leans.
fn beside(alpha_deg: f64, beta_deg: f64) -> Result<f64, Failure> {
    /// By which rounding may make the lean greater than the angle.
    const ROUNDING: f64 = 1e-9;
    if beta_deg.abs() > alpha_deg.abs() + ROUNDING {
        return Err(Failure::Value {
            what: "CUTANG of TLAXIS/ATANGL",
            value: beta_deg,
            need: "no more than the angle to the normal, of which it is a part".into(),
        });
    }
    let cos = trig::cos_deg(beta_deg);
    // Along the motion itself nothing is left for across.
    let across =
        if cos > ROUNDING { trig::acos_clamped(trig::cos_deg(alpha_deg) / cos) } else { 0.0 };
    Ok(across.copysign(alpha_deg))
}

/// The axis at a contact with the part surface whose unit normal `n` points to the tool.
///
/// APT: `SSPATH` for ITAC = 2, with unit directions of roll and pitch. `over` points to the side of the
/// step-over.
pub(crate) fn at_part(alpha: f64, beta: f64, n: Vec3, forward: Vec3, over: Vec3) -> Option<Vec3> {
    let (sa, ca) = trig::sin_cos(alpha);
    let (sb, cb) = trig::sin_cos(beta);
    let ahead = square(forward, n)?;
    let side = n.cross(&ahead);
    let side = if side.dot(&over) < 0.0 { -side } else { side };
    Some(n * (ca * cb) + ahead * sb + side * (sa * cb))
}

/// The part of `v` square to the unit vector `n`, as a unit vector.
fn square(v: Vec3, n: Vec3) -> Option<Vec3> {
    let v = v.try_normalize(0.0)?;
    (v - n * n.dot(&v)).try_normalize(1e-9)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drive::Course;
    use aptc_protap::{AxisAngle, OptionSurface};

    fn place(across: Vec3) -> DrivePoint {
        DrivePoint {
            uv: [0.0; 2],
            course: Course::V,
            point: Vec3::zeros(),
            along: Vec3::y(),
            across,
            speed: across,
            normal: Some(Vec3::z()),
            cross: None,
            direction: Some(-Vec3::z()),
            foot: None,
        }
    }

    #[test]
    fn published_slews() {
        let tilt = |deg: f64, across: Vec3| {
            let area = AxisArea::Angle { part: false, alpha: deg.to_radians(), beta: 0.0 };
            at_drive(&area, &place(across), Vec3::y()).unwrap()
        };
        let (s, c) = (0.5, 0.75_f64.sqrt());
        assert!((tilt(30.0, Vec3::x()) - Vec3::new(s, 0.0, c)).norm() < 1e-15);
        assert!((tilt(-30.0, Vec3::x()) - Vec3::new(-s, 0.0, c)).norm() < 1e-15);
        assert!((tilt(30.0, Vec3::new(1.0, 0.0, 1.0)) - Vec3::new(s, 0.0, c)).norm() < 1e-15);
        let area = AxisArea::Angle { part: false, alpha: 0.3, beta: 0.0 };
        assert!(at_drive(&area, &place(Vec3::zeros()), Vec3::y()).is_none());
    }

    #[test]
    fn the_axis_of_a_line_has_both_angles() {
        let angles = |alpha: f64, beta: f64| {
            let axis = ToolAxis::Angle(AxisAngle {
                surface: OptionSurface::Part,
                angle_deg: alpha,
                reference: None,
                cutting_deg: Some(beta),
                radius: None,
                height: None,
            });
            of_line(Some(&axis), 1.0, Vec3::z(), &place(Vec3::x()))
        };
        let n = Vec3::new(0.1, -0.2, 1.0).normalize();
        for (alpha, beta) in [(20.0, 15.0), (20.0, -20.0), (-30.0, 5.0), (40.0, 0.0), (90.0, 30.0)]
        {
            let Ok(AxisArea::Angle { part: true, alpha: across, beta: along }) =
                angles(alpha, beta)
            else {
                unreachable!("a rule of two angles");
            };
            let a = at_part(across, along, n, Vec3::x(), Vec3::y()).unwrap();
            let ahead = square(Vec3::x(), n).unwrap();
            assert!((a.dot(&n) - trig::cos_deg(alpha)).abs() < 1e-12, "{alpha} {beta}");
            assert!((a.dot(&ahead) - trig::sin_deg(beta)).abs() < 1e-12, "{alpha} {beta}");
            let lean = a - n * a.dot(&n) - ahead * a.dot(&ahead);
            assert!(lean.norm() < 1e-7 || (lean.y > 0.0) == (alpha > 0.0), "{alpha} {beta}");
        }
        assert!(angles(10.0, 15.0).is_err() && angles(0.0, 1.0).is_err());
    }

    #[test]
    fn an_axis_at_the_part_is_unit_and_leads() {
        let n = Vec3::new(0.1, -0.2, 1.0).normalize();
        let a = at_part(0.2, 0.1, n, Vec3::x(), Vec3::y()).unwrap();
        assert!((a.norm() - 1.0).abs() < 1e-15);
        assert!((a.dot(&n) - trig::cos(0.2) * trig::cos(0.1)).abs() < 1e-15);
        assert!(a.x > n.x && a.y > n.y);
    }
}
