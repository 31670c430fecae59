//! The areas that SCON sets.

use std::sync::Arc;

use aptc_contact::PatchTree;
use aptc_geometry::surface::ParametricSurface;
use aptc_geometry::{Plane, Profile, Sculptured, SpaceCurve, Vec3};
use aptc_protap::NameRef;

use crate::drive::Course;
use crate::failure::Failure;
use crate::project::Ends;

/// What guides the tool.
#[derive(Clone, Debug)]
pub(crate) enum Guide {
    /// A curve.
    Curve(Arc<SpaceCurve>),
    /// A surface.
    Surface(Arc<Sculptured>),
}

/// How the tool stands to the drive point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Hold {
    /// ON: the tool end is on the line of projection through the drive point.
    On,
    /// AT: the cutter touches the part surface where that line pierces it.
    At,
}

/// The direction in which drive points are projected.
#[derive(Clone, Debug)]
pub(crate) enum Projection {
    /// A vector.
    Along(Vec3),
    /// NORMAL: against the normal of the drive surface.
    Normal,
    /// CRSSPL: the direction across the drive curve.
    Cross,
    /// Towards the nearest place of a surface, from the side of its normal (+1) or the other (-1).
    Foot(Arc<ParametricSurface>, f64),
}

/// SCON/DS.
#[derive(Clone, Debug)]
pub(crate) struct DriveArea {
    pub(crate) name: NameRef,
    pub(crate) guide: Guide,
    /// Limits of u and v.
    pub(crate) u: [f64; 2],
    pub(crate) v: [f64; 2],
    pub(crate) hold: Hold,
    pub(crate) projection: Projection,
    /// Moves the tip down the axis before the projection.
    pub(crate) offset: f64,
}

/// SCON/PS.
#[derive(Clone, Debug)]
pub(crate) struct PartArea {
    pub(crate) name: NameRef,
    /// The surface along which the tool is led; loose patches that fit together are one grid, but for lines of the surface itself.
    pub(crate) surface: Arc<Sculptured>,
    /// It, prepared for questions.
    pub(crate) tree: Arc<PatchTree>,
    /// The grid in any case, as which it is checked, and that prepared for questions.
    pub(crate) whole: (Arc<Sculptured>, Arc<PatchTree>),
    /// A length that says how large its numbers are.
    pub(crate) extent: f64,
    /// How it goes on at its borders.
    pub(crate) ends: Ends,
    /// TO: the cutter touches; ON when false: the tool end lies on it.
    pub(crate) touches: bool,
    /// +1 on the side of dU x dV.
    pub(crate) side: f64,
    /// Material left on it.
    pub(crate) thick: f64,
}

/// SCON/AXIS.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum AxisArea {
    /// A unit vector.
    Fixed(Vec3),
    /// Along the drive normal, +1 or -1.
    NormDs(f64),
    /// At an angle to the normal of drive or part surface.
    Angle {
        /// Part surface; drive when false.
        part: bool,
        /// Slew across the path, radians.
        alpha: f64,
        /// Tilt along the path, radians, positive leading.
        beta: f64,
    },
    /// Along the rulings across lines with this running parameter: towards rising ones of the other, +1, or falling ones, -1.
    Ruling {
        /// The parameter that runs along the lines.
        lines: Course,
        /// +1 or -1.
        sense: f64,
    },
    /// At an angle to the drive normal of this sign, square to a unit vector, and of the two always the same.
    Square {
        /// The unit vector.
        to: Vec3,
        /// +1 or -1.
        side: f64,
        /// The angle, radians; none: as near to the normal as can be.
        alpha: Option<f64>,
        /// The one that is turned about the vector from the normal, +1, or back, -1.
        sense: f64,
    },
}

/// SCON/STEPOV.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct StepoverArea {
    pub(crate) scallop: f64,
    pub(crate) most: f64,
    pub(crate) lift: f64,
    pub(crate) paths: Option<usize>,
    /// Greatest step of the parameter, besides.
    pub(crate) parameter: Option<f64>,
}

impl StepoverArea {
    /// The same for a cutter, scallops no higher than its radius: passes clear nothing that stands higher between them than at
    /// two balls that just do not overlap, and so far above its end the cutter is solid whichever way it leans.
    pub(crate) fn of(self, cutter: &Profile) -> Self {
        let most = cutter.widest();
        Self { scallop: if most > 0.0 { self.scallop.min(most) } else { self.scallop }, ..self }
    }
}

/// All areas.
#[derive(Clone, Debug, Default)]
pub(crate) struct Areas {
    pub(crate) drive: Option<DriveArea>,
    pub(crate) part: Option<PartArea>,
    pub(crate) axis: Option<AxisArea>,
    /// Feeds of path, side step, plunge, retract; 0 leaves the feed.
    pub(crate) feeds: Option<[f64; 4]>,
    pub(crate) stepover: Option<StepoverArea>,
    /// The clearance plane; INIT leaves it.
    pub(crate) clearance: Option<Plane>,
    /// Those whose last statement failed, or that were told to be missing.
    pub(crate) failed: Vec<&'static str>,
}

impl Areas {
    /// Forgets what is set by a word of SCON.
    pub(crate) fn clear(&mut self, word: &str) {
        match word {
            "DS" => self.drive = None,
            "PS" => self.part = None,
            "AXIS" => self.axis = None,
            "FEED" => self.feeds = None,
            "STEPOV" => self.stepover = None,
            _ => {}
        }
        self.failed.retain(|w| *w != word);
    }

    /// Why a statement ends that needs those of these areas that are missing.
    pub(crate) fn missing(areas: &[(&'static str, bool)]) -> Failure {
        Failure::NotSet { areas: areas.iter().filter(|a| a.1).map(|a| a.0).collect() }
    }

    /// The failure without the areas of which was told: each is told once, at its own statement where that failed.
    pub(crate) fn once(&mut self, failure: Failure) -> Failure {
        let Failure::NotSet { mut areas } = failure else { return failure };
        areas.retain(|a| !self.failed.contains(a));
        self.failed.extend(&areas);
        Failure::NotSet { areas }
    }
}
