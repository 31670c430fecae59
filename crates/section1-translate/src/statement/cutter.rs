//! CUTTER: the tool's shape.
//!
//! | format | meaning |
//! | --- | --- |
//! | d | flat end mill |
//! | d,r | corner radius r |
//! | d,r,e,f,alpha,beta,h | all seven: APT's general cutter |
//! | OPTION,1 or 2,radius,height | a disk stands for it against the part or drive surface |
//! | OPTION,1 or 2,OFF | no longer |

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_geometry::Cutter;
use aptc_protap::{Kind, OptionSurface, Units};
use aptc_syntax::tree::Clause;
use aptc_vocabulary::word;

use super::reader::Reader;
use crate::eval::{Arg, Known, Names, Poisoned};
use crate::{Interpreter, Language};

/// Height of a cutter given by one or two numbers, inches.
const HEIGHT_INCHES: f64 = 5.0;

impl Interpreter<'_> {
    /// CUTTER/...
    pub(super) fn cutter(&mut self, clause: &Clause) -> Known<()> {
        let args = self.args(clause, Names::Defined)?;
        let mut reader = Reader::new(word::CUTTER, clause, &args);
        if reader.is_word(word::OPTION) {
            return self.cutter_option(&mut reader);
        }
        let mut values = Vec::with_capacity(7);
        while let Some(n) = reader.number() {
            values.push(n);
        }
        let height = HEIGHT_INCHES * Units::Inches.mm() / self.state.unit.mm();
        let cutter = match *values.as_slice() {
            [d] => Cutter::by_two(d, 0.0, height),
            [d, r] => Cutter::by_two(d, r, height),
            // NCL: its height too.
            [d, r, h] if self.options.language == Language::Ncl => Cutter::mill(d, r, h),
            [diameter, corner_radius, e, f, alpha_deg, beta_deg, height] => {
                Cutter { diameter, corner_radius, e, f, alpha_deg, beta_deg, height }
            }
            _ if reader.is_empty() => {
                let n = values.len();
                self.error(
                    Diagnostic::error(
                        codes::BAD_CUTTER,
                        clause.span,
                        format!("{n} numbers do not describe a cutter"),
                    )
                    .help("write CUTTER/d or d,r or d,r,e,f,alpha,beta,h"),
                );
                return Err(Poisoned);
            }
            _ => return Err(self.expect(&reader, "a number")),
        };
        self.at_end(&reader)?;
        self.check_cutter(&cutter, &args)?;
        self.emit(Kind::Cutter(cutter));
        Ok(())
    }

    fn check_cutter(&mut self, cutter: &Cutter, args: &[Arg]) -> Known<()> {
        let at = |i: usize| args.get(i).or(args.last()).map_or(Span::default(), |a| a.span);
        let fault = if cutter.diameter < 0.0 {
            Some((0, format!("a diameter of {} is negative", cutter.diameter)))
        } else if cutter.corner_radius < 0.0 {
            Some((1, format!("a corner radius of {} is negative", cutter.corner_radius)))
        } else if args.len() == 2 && cutter.e < 0.0 {
            let (r, half) = (cutter.corner_radius, cutter.diameter / 2.0);
            Some((1, format!("a corner radius of {r} is larger than half the diameter, {half}")))
        } else if cutter.height < 0.0 {
            Some((6, format!("a height of {} is negative", cutter.height)))
        } else if cutter.alpha_deg.abs() >= 90.0 {
            Some((4, format!("{} is no angle of a bottom line", cutter.alpha_deg)))
        } else if cutter.beta_deg.abs() >= 90.0 {
            Some((5, format!("{} is no angle of a side line", cutter.beta_deg)))
        } else {
            None
        };
        let Some((i, message)) = fault else { return Ok(()) };
        self.error(
            Diagnostic::error(codes::BAD_CUTTER, at(i), message)
                .help("write CUTTER/d or d,r or d,r,e,f,alpha,beta,h"),
        );
        Err(Poisoned)
    }

    fn cutter_option(&mut self, reader: &mut Reader<'_>) -> Known<()> {
        let surface = match reader.peek().and_then(|a| a.number()) {
            Some(1.0) => OptionSurface::Part,
            Some(2.0) => OptionSurface::Drive,
            _ => {
                return Err(self.expect_as(
                    reader,
                    "1 or 2 for the part or drive surface",
                    "write CUTTER/OPTION,1|2,radius,height or CUTTER/OPTION,1|2,OFF",
                ));
            }
        };
        reader.skip(1);
        let disk = if reader.is_word(word::OFF) {
            None
        } else {
            let radius = self.length_of_disk(reader, "radius")?;
            let height = self.length_of_disk(reader, "height")?;
            // OFF may also close a full form.
            if reader.is_word(word::OFF) { None } else { Some((radius, height)) }
        };
        self.at_end(reader)?;
        self.emit(Kind::CutterOption { surface, disk });
        Ok(())
    }

    /// Radius or height of CUTTER/OPTION.
    fn length_of_disk(&mut self, reader: &mut Reader<'_>, what: &str) -> Known<f64> {
        let Some(length) = reader.number() else {
            return Err(self.expect(reader, "the disk's radius and height, or OFF,"));
        };
        if length < 0.0 {
            let message = format!("a {what} of {length} of the disk is negative");
            self.error(
                Diagnostic::error(codes::BAD_CUTTER, reader.before(), message)
                    .help("write CUTTER/OPTION,1|2,radius,height or CUTTER/OPTION,1|2,OFF"),
            );
            return Err(Poisoned);
        }
        Ok(length)
    }
}
