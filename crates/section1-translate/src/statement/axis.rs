//! TLAXIS: the tool axis.
//!
//! | format | the axis |
//! | --- | --- |
//! | vector, or i,j,k | is fixed along it |
//! | 1 | stays as it is now |
//! | NORMPS, NORMDS | stands square to the part or drive surface |
//! | `PARLEL,s[,radius,height]` | lies along the rulings of surface s |
//! | ATANGL,s,a | makes the angle a with the normal of surface s |
//! | ATANGL,s,a,vector | and stays in the plane square to the vector |
//! | ATANGL,s,a,CUTANG,b | and leans by b along the motion, LEAD or LAG |
//! | PERPTO,vector | stands square to it |
//! | LAST | is that of the mode before |
//!
//! s is 1 or PS for the part surface, 2 or DS for the drive surface. RADIUS,r and HIGHT,h may follow.

use aptc_diagnostics::{Diagnostic, codes};
use aptc_geometry::{Form, Vec3};
use aptc_protap::{AxisAngle, Kind, OptionSurface, ToolAxis};
use aptc_syntax::tree::Clause;
use aptc_vocabulary::word;

use super::reader::Reader;
use crate::Interpreter;
use crate::eval::{Known, Names, Poisoned};

/// Greatest angle that TLAXIS takes, degrees.
const RIGHT_ANGLE: f64 = 90.0;

impl Interpreter<'_> {
    /// TLAXIS/...
    pub(super) fn tool_axis(&mut self, clause: &Clause) -> Known<()> {
        let args = self.args(clause, Names::Defined)?;
        let mut reader = Reader::new(word::TLAXIS, clause, &args);
        let words =
            &[word::NORMPS, word::NORMDS, word::PARLEL, word::ATANGL, word::PERPTO, word::LAST];
        let axis = match reader.word_of(words) {
            Some(word::NORMPS) => ToolAxis::NormPs,
            Some(word::NORMDS) => ToolAxis::NormDs,
            Some(word::LAST) => ToolAxis::Last,
            Some(word::PARLEL) => self.along_rulings(&mut reader)?,
            Some(word::ATANGL) => ToolAxis::Angle(self.at_angle(&mut reader)?),
            Some(_) => ToolAxis::PerpTo(self.direction(&mut reader)?),
            None => match (reader.left(), reader.peek().and_then(|a| a.number())) {
                (1, Some(1.0)) => {
                    reader.skip(1);
                    ToolAxis::Keep
                }
                _ => ToolAxis::Fixed(self.direction(&mut reader)?),
            },
        };
        self.at_end(&reader)?;
        self.emit(Kind::ToolAxis(axis));
        Ok(())
    }

    /// A vector or three numbers, not zero.
    fn direction(&mut self, reader: &mut Reader<'_>) -> Known<Vec3> {
        let Some(direction) = reader.vector().or_else(|| reader.triple()) else {
            return Err(self.expect(reader, "a vector or three numbers"));
        };
        self.not_zero(direction, reader)
    }

    /// The direction that was just read, unless it is none.
    pub(super) fn not_zero(&mut self, direction: Vec3, reader: &Reader<'_>) -> Known<Vec3> {
        if direction == Vec3::zeros() {
            self.error(Diagnostic::error(
                codes::BAD_AXIS,
                reader.before(),
                "a vector of no length gives no direction",
            ));
            return Err(Poisoned);
        }
        Ok(direction)
    }

    /// 1, 2, PS or DS.
    fn control_surface(&mut self, reader: &mut Reader<'_>) -> Known<OptionSurface> {
        match (reader.peek().and_then(|a| a.word()), reader.peek().and_then(|a| a.number())) {
            (Some(word::PS), _) | (_, Some(1.0)) => {
                reader.skip(1);
                Ok(OptionSurface::Part)
            }
            (Some(word::DS), _) | (_, Some(2.0)) => {
                reader.skip(1);
                Ok(OptionSurface::Drive)
            }
            _ => {
                Err(self
                    .expect(reader, "1 or PS for the part surface, 2 or DS for the drive surface,"))
            }
        }
    }

    fn along_rulings(&mut self, reader: &mut Reader<'_>) -> Known<ToolAxis> {
        let surface = self.control_surface(reader)?;
        let (mut radius, mut height) = (reader.number(), reader.number());
        self.radius_height(reader, &mut radius, &mut height)?;
        Ok(ToolAxis::Parallel { surface, radius, height })
    }

    /// RADIUS,r and HIGHT,h in either order.
    fn radius_height(
        &mut self,
        reader: &mut Reader<'_>,
        radius: &mut Option<f64>,
        height: &mut Option<f64>,
    ) -> Known<()> {
        while let Some(word) = reader.word_of(&[word::RADIUS, word::HIGHT]) {
            let Some(n) = reader.number() else {
                return Err(self.expect(reader, "a number"));
            };
            *(if word == word::RADIUS { &mut *radius } else { &mut *height }) = Some(n);
        }
        Ok(())
    }

    fn angle(&mut self, reader: &mut Reader<'_>) -> Known<f64> {
        let Some(angle) = reader.number() else {
            return Err(self.expect(reader, "an angle in degrees"));
        };
        if angle.abs() > RIGHT_ANGLE {
            self.error(
                Diagnostic::error(
                    codes::BAD_AXIS,
                    reader.before(),
                    format!("an angle of {angle} degrees is outside -90 to 90"),
                )
                .help("the angle is measured from the surface normal"),
            );
            return Err(Poisoned);
        }
        Ok(angle)
    }

    fn at_angle(&mut self, reader: &mut Reader<'_>) -> Known<AxisAngle> {
        let surface = self.control_surface(reader)?;
        let angle_deg = self.angle(reader)?;
        let mut axis = AxisAngle {
            surface,
            angle_deg,
            reference: None,
            cutting_deg: None,
            radius: None,
            height: None,
        };
        if reader.is_word(word::CUTANG) {
            axis.cutting_deg = Some(self.cutting_angle(reader)?);
        } else if !reader.is_empty() {
            axis.reference = self.reference(reader)?;
        }
        self.radius_height(reader, &mut axis.radius, &mut axis.height)?;
        Ok(axis)
    }

    /// [LEAD|LAG,]b; AUTO is not known.
    fn cutting_angle(&mut self, reader: &mut Reader<'_>) -> Known<f64> {
        if reader.is_word(word::AUTO) {
            self.error(
                Diagnostic::error(
                    codes::BAD_AXIS,
                    reader.before(),
                    "CUTANG,AUTO leaves the angle open, which is not done here",
                )
                .note("the grammar of APT4 has the word, and no source says which angle it takes")
                .help("give the lead or lag angle in degrees"),
            );
            return Err(Poisoned);
        }
        let sign = match reader.word_of(&[word::LEAD, word::LAG]) {
            Some(word::LAG) => -1.0,
            _ => 1.0,
        };
        Ok(sign * self.angle(reader)?)
    }

    /// The plane that the axis stays in, by its normal: a vector, PERPTO,vector, or a line or plane with
    /// or without PARLEL; MOTDIR is the motion itself.
    fn reference(&mut self, reader: &mut Reader<'_>) -> Known<Option<Vec3>> {
        if reader.is_word(word::MOTDIR) {
            return Ok(None);
        }
        if matches!(reader.peek().and_then(|a| a.word()), Some(word::RADIUS | word::HIGHT)) {
            return Ok(None);
        }
        reader.word_of(&[word::PARLEL, word::PERPTO]);
        let normal = match reader.peek().and_then(|a| a.form()) {
            Some(Form::Line(l)) => Some(l.plane().n),
            Some(Form::Plane(p)) => Some(p.n),
            _ => None,
        };
        if let Some(normal) = normal {
            reader.skip(1);
            return Ok(Some(normal));
        }
        self.direction(reader).map(Some)
    }
}
