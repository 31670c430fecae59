//! The record types that are not motion.

use std::sync::Arc;

use aptc_diagnostics::Origin;
use aptc_geometry::{Cutter, Form, Transform, Vec3};
use serde::{Deserialize, Serialize};
use smol_str::SmolStr;

use crate::{
    Drive, DriveSide, Go, OptionSurface, PartSide, Place, Pocket, Sense, SurfaceRef, ToolAxis,
};

pub use aptc_geometry::Units;

/// One record with the place it came from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Statement, line and expansions.
    pub origin: Origin,
    /// What it says.
    #[serde(flatten)]
    pub kind: Kind,
}

/// What a record says. The numbers are APT-360's record types.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// 2000: PARTNO, PPRINT, INSERT, REMARK, TITLES: a word with plain text.
    Text {
        /// The word, upper case.
        word: SmolStr,
        /// The text without the blanks around it.
        text: Box<str>,
    },
    /// 2000: a post-processor word. A feed rate in a motion statement comes as FEDRAT before the motion.
    Post {
        /// The word, upper case.
        word: SmolStr,
        /// Its arguments.
        args: Vec<Arg>,
    },
    /// A geometric definition, for print-outs; Section 2 needs none of them.
    Define {
        /// Name and subscript.
        name: NameRef,
        /// Its form.
        form: Arc<Form>,
    },
    /// 9000,9: unit of all lengths that follow.
    Units(Units),
    /// 6000,6: the cutter from here on.
    Cutter(Cutter),
    /// CUTTER/OPTION: a disk stands for the cutter against one surface, until OFF.
    CutterOption {
        /// Against which surface.
        surface: OptionSurface,
        /// Radius and height of the disk; `None` for OFF.
        disk: Option<(f64, f64)>,
    },
    /// 6000,4: INTOL for part, drive, check and second check surface.
    Intol([f64; 4]),
    /// 6000,5: OUTTOL likewise.
    Outtol([f64; 4]),
    /// 9000,5: THICK likewise.
    Thick([f64; 4]),
    /// 9000,3: greatest step and, in APT4, greatest length of a path.
    Maxdp {
        /// Greatest length of a cut vector.
        step: f64,
        /// Greatest length of a motion.
        length: Option<f64>,
    },
    /// 9000,4: greatest number of points of a motion.
    Numpts(u32),
    /// 6000,2: 2DCALC and 3DCALC.
    Calc(Dimension),
    /// 9000,2: MULTAX/ON or OFF.
    Multax(bool),
    /// 9000,1: TLAXIS.
    ToolAxis(ToolAxis),
    /// 9000,8: GOUGCK, and NDTEST as `false`.
    Gougck(bool),
    /// 3000,4: PSIS.
    PartSurface(SurfaceRef),
    /// 9000,7: part surface through the tool end, square to the tool axis.
    Autops,
    /// 9000,6: no part surface.
    Nops,
    /// 4000,1..3: TLLFT, TLRGT, TLON, TLNDON.
    DriveSide(DriveSide),
    /// 4000,5..6: TLONPS, TLOFPS.
    PartSide(PartSide),
    /// 5000,1..2: INDIRP, INDIRV.
    Sense(Sense),
    /// 5000,8: SRFVCT: for the surfaces of the next GO, in the order written there, the direction from
    /// its TO position to its PAST position; `None` for an empty field.
    SurfaceNormals(Vec<Option<Vec3>>),
    /// 5000,3: FROM.
    From(Place),
    /// 5000,5: GOTO.
    Goto(Place),
    /// GOTO of a pattern, in order; each point is a stop.
    Points {
        /// The pattern.
        name: NameRef,
        /// The points.
        points: Vec<Vec3>,
    },
    /// 5000,4: GODLTA by a vector.
    GoDelta(Vec3),
    /// GODLTA with one number: along the tool axis.
    GoDeltaAxis(f64),
    /// 7000,1: GO, and 7000,2: OFFSET.
    Go(Go),
    /// 8000: GOLFT GORGT GOFWD GOBACK GOUP GODOWN.
    Drive(Drive),
    /// 11000: POCKET.
    Pocket(Pocket),
    /// 6000,1: CUT (true) and DNTCUT (false).
    Cut(bool),
    /// INDEX, COPY, TRACUT: for Section 3.
    Edit(Edit),
    /// Regional milling and its checks: SCON SMIL GOLOFT GOMILL GCLEAR CHKSRF AVCTRL CLDAT REGION and
    /// their kin, words and forms in the order written.
    Regional {
        /// The word, upper case.
        word: SmolStr,
        /// Its arguments.
        args: Vec<Arg>,
    },
    /// 13000,3: a statement that moves the tool could not be translated; a diagnostic was given. Where the
    /// tool stands is unknown up to the next FROM or GOTO.
    Failed,
    /// 13000,4: CLPRNT.
    Clprnt(Clprnt),
    /// NOPOST: Section 4 is not entered.
    Nopost,
    /// NOPLOT: no plot.
    Noplot,
    /// 14000: end of the part program.
    Fini,
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
        form: Arc<Form>,
    },
}

/// A symbol and its subscript, 0 when it has none.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
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

/// 2DCALC or 3DCALC.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Dimension {
    /// The plane routine where it applies (ARLM2).
    Two,
    /// Always the routine for space (ARLM3).
    Three,
}

/// Work for Section 3; the meaning is that of the CL records of the same names.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Edit {
    /// INDEX/n, and INDEX/n,NOMORE.
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
