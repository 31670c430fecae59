//! Why a motion failed: data first, the words in `words`.

mod words;

use aptc_diagnostics::{Diagnostic, Origin};
use aptc_geometry::Vec3;
use aptc_protap::{Direction, OptionSurface, SurfaceRef};

/// Why a motion failed.
#[derive(Clone, Debug)]
pub(crate) enum Failure {
    /// No position yet.
    NoPosition,
    /// A surface is to be touched and there is no cutter.
    NoCutter { surface: SurfaceRef },
    /// The tool stands off the drive surface.
    OffDrive { surface: SurfaceRef, off: f64, allowed: f64, outside: bool },
    /// The tool stands off the part surface.
    OffPart { surface: SurfaceRef, off: f64, allowed: f64, outside: bool },
    /// Neither way is more left, right, forward or back than the other.
    Direction { word: Direction },
    /// The check surface is never met.
    NotReached {
        surface: SurfaceRef,
        nth: u32,
        met: u32,
        closest: f64,
        place: Vec3,
        gone: f64,
        /// The cut vectors after which it was given up, if that is why.
        spent: Option<u32>,
        /// TO was asked for, and the cutter stands in the surface at the start.
        within: bool,
        /// PAST was asked for, and a cutter of this height stands in the surface all the way.
        stuck: Option<f64>,
    },
    /// The track ends before its check surface is met.
    Blocked(Box<Blocked>),
    /// Nowhere tangent.
    NoTangency {
        surface: SurfaceRef,
        other: SurfaceRef,
        /// Negative when the cutter is in the other.
        closest: f64,
        allowed: f64,
        /// Thickness left on each.
        thick: [f64; 2],
    },
    /// The cutter does not fit into a round surface.
    TooLarge { surface: SurfaceRef, radius: f64, cutter: f64 },
    /// Start-up without a position that does what is asked.
    NoStart {
        surfaces: Vec<SurfaceRef>,
        why: &'static str,
        /// The best place that was found.
        place: Option<Vec3>,
        /// How far it is from each surface, negative when it cuts in.
        left: Vec<(SurfaceRef, f64)>,
        /// Positions that are found from elsewhere.
        others: Vec<Candidate>,
    },
    /// INDIRV or INDIRP leads away from the surface or along it.
    Misses { surface: SurfaceRef, closest: f64 },
    /// The next motion is needed to know where this one ends.
    NoCheck { word: Direction },
    /// A form that is no surface.
    NotASurface { surface: SurfaceRef },
    /// The cutter has no normal contact with a surface.
    NoContact { surface: SurfaceRef },
    /// Drive and part surface run alike, so that they give no direction.
    SideBySide { drive: SurfaceRef, part: SurfaceRef },
    /// No tool axis satisfies TLAXIS.
    NoAxis { place: Vec3 },
    /// The tool cannot turn in place from one axis to the other and keep its bands on the way.
    NoTurn { place: Vec3, axes: [Vec3; 2] },
    /// Where it turns in place it comes so deep into a check surface, with this axis.
    TurnsInto { surface: SurfaceRef, place: Vec3, axis: Vec3, deep: f64 },
    /// The disk of the cutter is on the side of the surface that the axis points into: the first axis would turn over to the second.
    TurnsOver { surface: SurfaceRef, place: Vec3, axes: [Vec3; 2] },
    /// None square to the vector is so near to the normal as the angle asks; degrees.
    NoneSquare { place: Vec3, least: f64, asked: f64 },
    /// TLAXIS/PARLEL along a surface that has no rulings, beside one that has them.
    NoRulings { role: OptionSurface, surface: SurfaceRef, other: Option<SurfaceRef> },
    /// The cutter cannot be at both surfaces.
    NoPlace { surfaces: Vec<SurfaceRef>, place: Vec3 },
    /// CUTTER that is no solid.
    BadCutter { why: String },
    /// A negative thickness greater than the cutter's greatest radius: the cutter would be past the surface.
    ThickBeyond { surface: SurfaceRef, thick: f64, radius: f64 },
    /// POCKET with numbers or points that make none.
    Pocket { why: String },
    /// A surface that is not done yet.
    Unsupported { surface: SurfaceRef },
}

/// The end of a track before its check surface.
#[derive(Clone, Debug)]
pub(crate) struct Blocked {
    /// Drive and part surface.
    pub(crate) surfaces: [SurfaceRef; 2],
    /// The check surface that was to be met.
    pub(crate) check: SurfaceRef,
    pub(crate) why: Hindrance,
    pub(crate) place: Vec3,
    /// Way done until then.
    pub(crate) gone: f64,
    /// How far the check surface is at the nearest.
    pub(crate) closest: f64,
    /// How often it was met, of how many times.
    pub(crate) met: [u32; 2],
}

/// What keeps the cutter from going on.
#[derive(Clone, Debug)]
pub(crate) enum Hindrance {
    /// No place of the surface faces the cutter any more.
    Ends(SurfaceRef),
    /// The cutter comes to touch the surface here as well, on its other hand.
    Again { surface: SurfaceRef, at: Vec3 },
    /// Neither: no cut vector of any length stays in the bands.
    Tight,
}

/// A position that would do for a start-up.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Candidate {
    pub(crate) te: Vec3,
    /// Direction to it from where the tool stands.
    pub(crate) along: Vec3,
}

impl Failure {
    /// The words, at the statement.
    pub(crate) fn explain(&self, origin: &Origin) -> Diagnostic {
        let (code, text, help) = self.words();
        let mut d = Diagnostic::error(code, origin.span, text).within(origin.trace.clone());
        for note in self.notes() {
            d = d.note(note);
        }
        d.help(help)
    }

    /// Did the motion end without its check surface?
    pub(crate) fn is_unmet(&self) -> bool {
        matches!(self, Self::NotReached { .. } | Self::NoTangency { .. } | Self::Blocked(_))
    }

    /// Did it, and may it be tried the other way?
    pub(crate) fn never_met(&self) -> bool {
        // What was given up after many cut vectors would take as many the other way.
        let given_up = matches!(self, Self::NotReached { spent: Some(_), .. });
        self.is_unmet() && !given_up
    }

    /// The words of the message alone.
    pub(crate) fn text(&self) -> String {
        self.words().1
    }

    /// The place that it speaks of.
    pub(crate) fn place(&self) -> Option<Vec3> {
        match self {
            Self::NotReached { place, .. }
            | Self::NoAxis { place }
            | Self::NoTurn { place, .. }
            | Self::TurnsInto { place, .. }
            | Self::TurnsOver { place, .. }
            | Self::NoneSquare { place, .. }
            | Self::NoPlace { place, .. } => Some(*place),
            Self::Blocked(b) => Some(b.place),
            Self::NoStart { place, .. } => *place,
            _ => None,
        }
    }
}

impl Candidate {
    /// The position `te` seen from `from`.
    pub(crate) fn of(from: Vec3, te: Vec3) -> Self {
        Self { te, along: (te - from).normalize() }
    }
}
