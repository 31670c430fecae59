//! What regional milling promises of its motions.

use std::sync::Arc as Shared;

use aptc_geometry::{Form, Profile, Sculptured, Shell};

use crate::{NameRef, Position};

/// What the motions of a statement of regional milling keep to, for the proof.
#[derive(Clone, Debug, PartialEq)]
pub struct Milling {
    /// The part surface; none where the tool end is led away from a surface that it would lie on.
    pub part: Option<Milled>,
    /// Does the tool end lie on the part surface (ON)? Else the cutter touches it.
    pub on: bool,
    /// May the tool end stand above the part surface on which it lies? It got out of the way of something (AVCTRL).
    pub risen: bool,
    /// Further sculptured surfaces that are checked (CHKSRF).
    pub checked: Vec<Milled>,
    /// Checked surfaces of other kinds.
    pub plain: Vec<Plain>,
    /// Shank and holder, which keep clear of what is checked.
    pub holder: Vec<Raised>,
    /// Is the part surface checked too (CHKSRF/PS), so that shank and holder keep clear of it?
    pub guarded: bool,
    /// How deep the cutter may be in a surface.
    pub intol: f64,
    /// How much may be left on the part surface beyond thickness and scallop.
    pub outtol: f64,
    /// What is left between the passes of a region; none where nothing is promised.
    pub scallop: Option<Scallop>,
    /// Does the first vector begin on the surface, where the statement before ended? Else it is how the tool
    /// comes there.
    pub joined: bool,
    /// Does each motion begin, straight from where the one before ended, beyond what REGION leaves out?
    pub over: bool,
    /// What REGION leaves of its lines; none where it does not limit them.
    pub limits: Option<Limits>,
}

/// What REGION leaves of the lines of a part surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Limits {
    /// What is milled lies in all of them.
    pub areas: Vec<Area>,
    /// The lines that are asked for, of which all is milled that the areas hold; none where nothing is promised of them.
    pub lines: Vec<AskedLine>,
    /// How the tool is held to its lines.
    pub held: Held,
    /// By how much a vector may leave its line between two places of it (CHORD).
    pub off: f64,
}

/// What is inside of outlines, or outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Area {
    /// Is it what an odd number of the outlines hold? Else it is the rest.
    pub inside: bool,
    /// The outlines.
    pub outlines: Vec<Outline>,
    /// Of loose patches (COMBIN) the corners from which these were made, u and v, in the order of each outline; else none.
    pub recorded: Vec<Vec<[f64; 2]>>,
}

/// A line of a surface before anything limits it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AskedLine {
    /// The parameter that runs, 0 for u and 1 for v.
    pub running: usize,
    /// The value of the other.
    pub fixed: f64,
    /// From where to where it runs, rising.
    pub ends: [f64; 2],
}

/// How a tool is held to a place of the line along which it is led.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Held {
    /// It touches it.
    Touching,
    /// It may be lifted off it along its axis (AVCTRL).
    Above,
    /// It may be lifted off it in another direction.
    Free,
}

impl Milling {
    /// Is the tool held to a surface or kept off one? A tool end that is led away from its surface is free.
    pub fn asks(&self) -> bool {
        self.part.is_some() || !self.checked.is_empty() || !self.plain.is_empty()
    }

    /// How deep a tool that just touches may be in: INTOL, or a little where that is nothing.
    pub fn touching(intol: f64, outtol: f64) -> f64 {
        intol.max(0.01 * (intol + outtol))
    }

    /// What the way to the first position keeps to: what CHKSRF names.
    #[must_use]
    pub fn arrival(&self) -> Self {
        Self {
            part: self.part.clone().filter(|_| self.guarded),
            on: false,
            scallop: None,
            limits: None,
            intol: Self::touching(self.intol, self.outtol),
            ..self.clone()
        }
    }
}

/// A surface that the cutter does not cut into.
#[derive(Clone, Debug, PartialEq)]
pub struct Milled {
    /// Its name.
    pub name: NameRef,
    /// The surface in the part frame.
    pub surface: Shared<Sculptured>,
    /// The side of the cutter, +1 on that of dU x dV.
    pub side: f64,
    /// Thickness left on it.
    pub thick: f64,
    /// Of triangles that close, the body that they bound: nothing of the tool is in it.
    pub body: Option<Shared<Shell>>,
}

/// A surface that is not sculptured. Where it has sides cutter and holder keep to one of them, by the rule of
/// [`aptc_geometry::surface::kept`].
#[derive(Clone, Debug, PartialEq)]
pub struct Plain {
    /// Its name.
    pub name: NameRef,
    /// Its canonical form in the part frame.
    pub form: Shared<Form>,
    /// Thickness left on it.
    pub thick: f64,
}

/// A solid about the tool axis that goes along with the cutter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Raised {
    /// Its outline, from its own lower end.
    pub profile: Profile,
    /// Height of that end above the tool end.
    pub up: f64,
}

/// What may be left between the passes.
#[derive(Clone, Debug, PartialEq)]
pub struct Scallop {
    /// Greatest height over the part surface and its thickness.
    pub height: f64,
    /// Where.
    pub extent: Extent,
    /// Why more may stand somewhere, if it may: where the tool got out of the way (AVCTRL) that was not to be cut, and
    /// what is led over another surface touches only where it fits.
    pub excused: Option<&'static str>,
    /// Positions between which a tool would take what stands at the ends of passes, and beside edges that they roll over, in
    /// the unit of the motion: from each end of a pass, or of a roll, to that of the next, with either axis where these differ.
    /// ZIGZAG goes over one end in two, PICKFD over none, and nothing over edges.
    pub links: Vec<[Position; 2]>,
}

/// An outline of straight lines in the parameters u and v of a surface. It is closed, but for where the surface closes in itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// The lines.
    pub lines: Vec<[[f64; 2]; 2]>,
    /// The parameter along which what it holds is told: from a place in it, this parameter rising, an odd number of lines is met.
    pub along: usize,
}

impl Outline {
    /// Does it hold the place?
    pub fn holds(&self, at: [f64; 2]) -> bool {
        let [x, y] = [at[self.along], at[1 - self.along]];
        let met = self.lines.iter().filter(|line| {
            let [[a, c], [b, d]] = line.map(|end| [end[self.along], end[1 - self.along]]);
            (c > y) != (d > y) && x < a + (b - a) * ((y - c) / (d - c))
        });
        met.count() % 2 == 1
    }
}

/// A region of the part surface, by its parameters u and v, between the contacts of the first and the last pass.
#[derive(Clone, Debug, PartialEq)]
pub enum Extent {
    /// Least and greatest u and v.
    Box([[f64; 2]; 2]),
    /// What an outline holds: the contacts of the first and the last pass, and the ends of those between. Its lines do not cross.
    Outline(Outline),
    /// It is not known, for this reason.
    Unknown(&'static str),
}
