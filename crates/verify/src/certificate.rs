//! What was proved.

use std::borrow::Cow;
use std::fmt;

use aptc_diagnostics::{Diagnostic, Origin, codes};
use serde::Serialize;

/// The proof of a part program's path.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Certificate {
    /// One entry a statement that moved the tool along surfaces.
    pub statements: Vec<StatementProof>,
    /// Cut vectors proved.
    pub proved: u64,
    /// Cut vectors refuted.
    pub refuted: u64,
    /// Cut vectors not decided.
    pub undecided: u64,
    /// Cut vectors left out of a sample.
    pub left_out: u64,
    /// Vectors of point-to-point motion, which have no surface to hold to.
    pub free: u64,
    /// Motions after RAPID that cut into a part surface.
    pub rapid_cuts: u64,
    /// One entry each.
    pub rapids: Vec<RapidCut>,
    /// Stretches of lines that REGION leaves to be milled, and that are not.
    pub left_out_lines: Vec<LeftOut>,
    /// Motions of the program that a CL file lacks.
    pub unmatched: u64,
    /// Positions of a CL file that belong to no motion of the program.
    pub extra: u64,
    /// Allowance for rounding, as a share of the size of the scene.
    pub rounding: f64,
}

/// The proof of one statement.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StatementProof {
    /// The statement.
    pub origin: Origin,
    /// Cut vectors judged.
    pub vectors: u64,
    /// Of these proved.
    pub proved: u64,
    /// How.
    pub method: &'static str,
    /// Greatest proved violation and excess by surface, drive first.
    pub surfaces: Vec<SurfaceBound>,
    /// The first fault.
    pub fault: Option<Fault>,
}

/// A cut at rapid, into the part surface of the motion along surfaces before or after it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RapidCut {
    /// The statement.
    pub origin: Origin,
    /// Name and role of the surface.
    pub surface: String,
    /// Number of the point within the motion, from 1, on the way to which it is deepest.
    pub point: u64,
    /// Tool end there.
    pub te: [f64; 3],
    /// By how much it is deeper than the band allows.
    pub depth: f64,
}

/// A stretch of a line that REGION leaves to be milled, over which the tool never comes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LeftOut {
    /// The statement.
    pub origin: Origin,
    /// Name and role of the surface.
    pub surface: String,
    /// The word of the line, and its parameter.
    pub line: (&'static str, f64),
    /// A place in the middle of it.
    pub at: [f64; 3],
    /// Its length.
    pub length: f64,
}

/// Bounds of the gap to a surface over a statement; the gap includes the thickness.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SurfaceBound {
    /// Name of the surface.
    pub name: String,
    /// `drive`, `part` or `check`; in regional milling `part`, `checked`, `holder` (shank and holder against a checked
    /// surface) and `scallop`.
    pub role: &'static str,
    /// The gap is nowhere less.
    pub least: f64,
    /// The gap is nowhere more.
    pub most: f64,
    /// The band: allowed least and most.
    pub band: [f64; 2],
    /// Tool end at the end of the vector with the least, where it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<[f64; 3]>,
}

/// Where a vector leaves its band, or could not be decided.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Fault {
    /// Was it shown to leave the band? Else it is not decided.
    pub refuted: bool,
    /// Name and role of the surface.
    pub surface: String,
    /// Number of the vector within the statement, from 1.
    pub vector: u64,
    /// Tool end at the place.
    pub te: [f64; 3],
    /// By how much the band is left; for what is not decided at most this much, infinite when unknown.
    pub depth: f64,
    /// Is it material that is cut (else material that is left)?
    pub gouge: bool,
    /// What else is wrong than that the band is left.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub breach: Option<Breach>,
    /// Does it stand between the ends of passes alone, where the tool does not step from one to the next?
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub ends: bool,
    /// Why it is not decided, where that is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub why: Option<Cow<'static, str>>,
}

/// What is wrong with a vector that keeps to its band.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Breach {
    /// It mills where REGION leaves nothing to be milled; `depth` is how far that is from what may be milled.
    Outside,
    /// It goes past the place where the check surface of TANTO or PSTAN is tangent; `depth` is the way from there to the end.
    Past,
}

/// A length for a message: small ones keep their digits.
pub(crate) fn length(x: f64) -> String {
    if x != 0.0 && x.abs() < 1e-4 { format!("{x:.2e}") } else { format!("{x:.6}") }
}

impl Fault {
    /// By how much one place is out of what is allowed, and what ends the looks at it that is not refuted. What is refuted is told to a
    /// tenth, so that it is looked at anew with as much allowed.
    pub(crate) fn in_all<T>(
        of: &mut T,
        look: impl Fn(&T) -> Option<Self>,
        allow: impl Fn(&mut T, &Self),
    ) -> (f64, Option<Self>) {
        const LOOKS: usize = 8;
        let mut depth = 0.0;
        for _ in 0..LOOKS {
            match look(of) {
                Some(fault) if fault.refuted => {
                    allow(of, &fault);
                    depth += fault.depth;
                }
                other => return (depth, other),
            }
        }
        (depth, None)
    }

    /// The warning of a way that goes through a surface, with what goes so and what to do.
    pub(crate) fn through(&self, origin: &Origin, who: &str, help: &str) -> Diagnostic {
        let (surface, depth) = (&self.surface, length(self.depth));
        let message = format!("{who} into {surface} by {depth} beyond tolerance {}", self.place());
        let d = Diagnostic::warning(codes::THROUGH, origin.span, message);
        d.help(help).within(origin.trace.clone())
    }

    /// The place in words.
    pub(crate) fn place(&self) -> String {
        at_tool_end(self.te)
    }
}

/// A tool end as messages give it.
pub(crate) fn at_tool_end(te: [f64; 3]) -> String {
    format!("at tool end {}", point(te))
}

/// A point as messages give it, without a sign where a number is 0 but for rounding.
fn point(p: [f64; 3]) -> String {
    let [x, y, z] = p.map(|x| if x.abs() < 5e-6 { 0.0 } else { x });
    format!("{x:.5}, {y:.5}, {z:.5}")
}

impl LeftOut {
    pub(crate) fn told(&self) -> Diagnostic {
        let (at, (word, fixed)) = (point(self.at), self.line);
        let message = format!(
            "no cut vector mills {} of the line {word},{fixed} of {}, which REGION leaves to be milled, about {at}",
            length(self.length),
            self.surface
        );
        Diagnostic::error(codes::REFUTED, self.origin.span, message)
            .within(self.origin.trace.clone())
    }
}

impl Certificate {
    /// Is every cut vector proved?
    pub fn is_proved(&self) -> bool {
        self.refuted == 0
            && self.undecided == 0
            && self.left_out == 0
            && self.unmatched == 0
            && self.extra == 0
            && self.rapid_cuts == 0
            && self.left_out_lines.is_empty()
    }
}

impl fmt::Display for Certificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let judged = self.proved + self.refuted + self.undecided;
        if judged == 0 {
            f.write_str("no motion along surfaces")?;
        } else if self.refuted + self.undecided == 0 {
            write!(f, "all {judged} cut vectors along surfaces proved within tolerance")?;
        } else {
            write!(f, "{} of {judged} cut vectors along surfaces proved", self.proved)?;
            if self.refuted > 0 {
                write!(f, ", {} refuted", self.refuted)?;
            }
            if self.undecided > 0 {
                write!(f, ", {} not decided", self.undecided)?;
            }
        }
        if self.left_out > 0 {
            write!(f, ", {} left out of the sample", self.left_out)?;
        }
        if self.unmatched > 0 {
            write!(f, ", {} motions not found", self.unmatched)?;
        }
        if self.extra > 0 {
            write!(f, ", {} positions of no motion", self.extra)?;
        }
        if let n @ 1.. = self.left_out_lines.len() {
            let s = if n == 1 { "" } else { "es" };
            write!(f, ", {n} stretch{s} of lines not milled")?;
        }
        if self.free > 0 {
            write!(f, "; {} from point to point", self.free)?;
        }
        if self.rapid_cuts > 0 {
            let s = if self.rapid_cuts == 1 { "" } else { "s" };
            write!(f, "; {} cut{s} at rapid", self.rapid_cuts)?;
        }
        Ok(())
    }
}
