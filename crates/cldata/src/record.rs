//! The record types.

use std::sync::Arc as Shared;

use aptc_diagnostics::Origin;
use aptc_geometry::{Circle, Cutter, Form, Transform, Vec3};
use serde::{Deserialize, Serialize};
use smol_str::SmolStr;

use crate::milling::Milling;

pub use aptc_geometry::Units;

/// One record with the place it came from.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Statement, line and expansions.
    pub origin: Origin,
    /// What it says.
    #[serde(flatten)]
    pub kind: Kind,
}

/// What a record says.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// PARTNO, PPRINT, INSERT, TITLES or another word whose argument is plain text.
    Text {
        /// The word, upper case.
        word: SmolStr,
        /// The text without the blanks around it.
        text: Box<str>,
    },
    /// A post-processor word with its arguments; takes effect at the next motion or as the word says.
    Post {
        /// The word, upper case.
        word: SmolStr,
        /// Its arguments in order; empty also when there was no slash.
        args: Vec<Arg>,
    },
    /// UNITS: unit of all lengths that follow.
    Units(Units),
    /// MULTAX: positions that follow carry a tool axis.
    Multax(bool),
    /// CUTTER: the tool from here on.
    Cutter(Cutter),
    /// INTOL for part, drive, check and second check surface.
    Intol([f64; 4]),
    /// OUTTOL for part, drive, check and second check surface.
    Outtol([f64; 4]),
    /// Positions of the tool.
    Motion(Motion),
    /// CUT, DNTCUT: are positions put out?
    Output(Output),
    /// INDEX, COPY, TRACUT: work for Section 3.
    Edit(Edit),
    /// CLPRNT.
    Clprnt(Clprnt),
    /// CSYS, MSYS, the matrix of CATIA: map from the frame of the positions that follow to the base frame
    /// of the CAM system's part. Said, not applied.
    Csys(Transform),
    /// A comment worth keeping, without its `$$`.
    Comment(Box<str>),
    /// A statement that was not understood; kept as written.
    Unread(Box<str>),
    /// FINI: end of the part program.
    #[default]
    Fini,
}

/// An argument of a post-processor word.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Arg {
    /// A number.
    Number(f64),
    /// A word, upper case.
    Word(SmolStr),
    /// Quoted text.
    Text(Box<str>),
    /// A geometric form with its name.
    Form {
        /// Name and subscript.
        name: NameRef,
        /// Its canonical form.
        form: Shared<Form>,
    },
}

/// Does CYCLE with these words begin a cycle, between the holes of which the tool goes at rapid? OFF, NOMORE and INIT end one.
pub fn begins_cycle(args: &[Arg]) -> bool {
    let ends =
        |a: &Arg| matches!(a, Arg::Word(w) if matches!(w.as_str(), "OFF" | "NOMORE" | "INIT"));
    !args.iter().any(ends)
}

/// A symbol and its subscript, 0 when it has none.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct NameRef {
    /// The symbol; empty for an unnamed definition.
    pub name: SmolStr,
    /// The subscript.
    #[serde(default)]
    pub subscript: u32,
}

impl NameRef {
    /// Does it say in words what is meant, as of the part surface that no statement gives? Symbols have no blanks.
    pub fn is_in_words(&self) -> bool {
        self.name.contains(' ')
    }
}

/// Motion of one statement, or a part of it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Motion {
    /// How the tool gets there.
    pub kind: MotionKind,
    /// The drive surface or point that was named.
    #[serde(default)]
    pub name: NameRef,
    /// The circle on which the tool end travels: centre, axis and radius of the path, not of the part.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub arc: Option<Arc>,
    /// The positions in order; the first is the end of the first cut vector (for FROM, the start).
    pub points: Vec<Position>,
    /// Is the tool axis part of the output (MULTAX)?
    #[serde(default)]
    pub with_axis: bool,
    /// The surfaces that governed the motion, for the proof; none for point-to-point motion.
    #[serde(skip)]
    pub control: Option<Shared<Control>>,
}

/// How the tool gets to the positions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum MotionKind {
    /// FROM: it is there already.
    From,
    /// GOTO and GODLTA: point to point.
    #[default]
    Goto,
    /// GO and OFFSET: start-up.
    Startup,
    /// GOLFT, GORGT, GOFWD, GOBACK, GOUP, GODOWN: along surfaces.
    Continuous,
}

/// A circular course of the tool end.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Arc {
    /// Centre, unit axis and radius of the path of the tool end.
    pub circle: Circle,
    /// What the points are to the circle.
    pub course: Course,
}

/// What the points of a circular motion are.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Course {
    /// Ends of chords that approach the circle within tolerance; their order gives the sense.
    Chords,
    /// Only the end of the arc is given. Angle travelled in degrees, positive anticlockwise about the
    /// circle's axis, up to many turns for a helix.
    Sweep(f64),
}

/// Tool end and tool axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Position {
    /// Tool end.
    pub te: Vec3,
    /// Unit tool axis, from the tool end to the spindle.
    pub ta: Vec3,
}

/// Are positions put out?
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Output {
    /// CUT.
    Cut,
    /// DNTCUT.
    Dntcut,
}

/// What CLPRNT prints from here on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Clprnt {
    /// CLPRNT alone: the whole program, whatever others say.
    Whole,
    /// CLPRNT/ON.
    On,
    /// CLPRNT/OFF.
    Off,
    /// CLPRNT/OPTION: as ON, but positions before TRACUT and COPY.
    Option,
}

/// Work for Section 3.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Edit {
    /// INDEX/n opens, INDEX/n,NOMORE closes the range n.
    Index {
        /// The number of the range.
        n: f64,
        /// Is this the closing one?
        close: bool,
    },
    /// COPY/n,..: the range n again, `count` times, each moved by `step` once more than the last.
    Copy {
        /// The number of the range.
        n: f64,
        /// Map from one copy to the next; the identity for SAME.
        step: Transform,
        /// How many copies.
        count: u32,
    },
    /// TRACUT/M, and TRACUT/NOMORE as `None`.
    Tracut(Option<Transform>),
}

/// The surfaces that governed a motion.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Control {
    /// Drive surface; for a start-up the first surface.
    pub drive: Option<Controlled>,
    /// Part surface.
    pub part: Option<Controlled>,
    /// Check surfaces; the first is the one that stopped the motion.
    pub checks: Vec<Controlled>,
    /// What regional milling keeps to; it has no drive, part and check surface.
    pub milling: Option<Milling>,
}

impl Control {
    /// INTOL and OUTTOL by which a surface was held that is asked for so: on the same side, with the same thickness and disk; the
    /// wider ones where it was held twice. `None` where it was not.
    pub fn band_of(&self, c: &Controlled) -> Option<[f64; 2]> {
        let bands = self.alike(c).map(|e| [e.intol, e.outtol]);
        bands.reduce(|a, b| [a[0].max(b[0]), a[1].max(b[1])])
    }

    /// Was the hollow so held that does not count as open?
    pub fn held_whole(&self, c: &Controlled) -> bool {
        self.alike(c).any(|e| !e.open)
    }

    fn alike<'a>(&'a self, c: &'a Controlled) -> impl Iterator<Item = &'a Controlled> {
        let on = |c: &Controlled| c.side == 0 || c.relation == Relation::On;
        let alike = move |e: &&Controlled| {
            on(e) == on(c)
                && (on(c) || e.side == c.side)
                && e.disk == c.disk
                && e.thick.to_bits() == c.thick.to_bits()
                && (Shared::ptr_eq(&e.form, &c.form) || e.form == c.form)
        };
        self.drive.iter().chain(&self.part).chain(&self.checks).filter(alike)
    }
}

/// A surface with what was asked of the cutter against it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Controlled {
    /// Its name.
    pub name: NameRef,
    /// Its canonical form in the part frame.
    pub form: Shared<Form>,
    /// What the cutter does to it.
    pub relation: Relation,
    /// Side of the cutter: +1 on the side of the form's normal (outside of circles, spheres, cylinders and
    /// cones), -1 on the other; 0 when ON.
    pub side: i8,
    /// Does the hollow count as open along the tool axis, for a cutter taller than it?
    pub open: bool,
    /// Which of the meetings with it stops the motion, n,INTOF; 1 for drive and part surface.
    pub nth: u32,
    /// Thickness left on it, THICK.
    pub thick: f64,
    /// Radius and height of the disk that stands for the cutter against it, CUTTER/OPTION.
    pub disk: Option<[f64; 2]>,
    /// Allowed violation into the material.
    pub intol: f64,
    /// Allowed excess.
    pub outtol: f64,
}

/// What the cutter does to a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
pub enum Relation {
    /// The cutter touches it from the near side.
    To,
    /// The tool end lies on it.
    On,
    /// The cutter touches it from the far side.
    Past,
    /// The motion runs into it tangentially (TANTO and DSTAN: tangent to the drive surface).
    Tanto,
    /// Tangent to the part surface.
    Pstan,
}

impl Kind {
    /// May the record hold a length?
    pub(crate) fn has_lengths(&self) -> bool {
        match self {
            Self::Motion(_)
            | Self::Cutter(_)
            | Self::Intol(_)
            | Self::Outtol(_)
            | Self::Edit(_)
            | Self::Csys(_)
            | Self::Fini => true,
            Self::Post { word, args } => {
                !matches!(word.as_str(), "MACHIN" | "PPWORD")
                    && args.iter().any(|a| matches!(a, Arg::Number(_) | Arg::Form { .. }))
            }
            _ => false,
        }
    }
}

impl Position {
    /// Tool end with the axis straight up.
    pub fn upright(te: Vec3) -> Self {
        Self { te, ta: Vec3::z() }
    }
}
