//! Cut vectors that go back to Section 1.

use aptc_geometry::Vec3;

/// What CLDAT recorded, for POINT/CLDATA, VECTOR/CLDATA, CLDATF and NUMF of statements that follow; lengths
/// in the unit of the program, the base system.
///
/// APT: the EXFILE of `CLDAT`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CutVectors {
    /// The number of the section; `None` for the path of the last motion.
    pub section: Option<f64>,
    /// What CLDAT/START asked to keep besides tool end and axis: `PPS`, `UVPDS` and the like.
    pub kept: Vec<Box<str>>,
    /// In order of motion.
    pub points: Vec<CutPoint>,
    /// Are the points to be printed as definitions, and as what (INTSEC with CANON)?
    pub canon: bool,
    /// Was the section refused, or its recording? That was told, and who asks for it is not told again.
    pub refused: bool,
}

/// A position of the tool.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CutPoint {
    /// Tool end, TP.
    pub te: Vec3,
    /// Unit tool axis, TA.
    pub ta: Vec3,
    /// Unit direction of the cut vector that ends there, TV; `None` for the first position of a program.
    pub along: Option<Vec3>,
    /// Where the cutter touches the drive surface, PDS, NDS and UVPDS.
    pub drive: Option<CutContact>,
    /// Where it touches the part surface, PPS, NPS and UVPPS.
    pub part: Option<CutContact>,
}

/// A place on a surface that the tool keeps to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CutContact {
    /// The place.
    pub point: Vec3,
    /// Unit normal, from the surface to the tool where it touches.
    pub normal: Vec3,
    /// Number of the patch from 1 and the parameters in it, of a sculptured surface.
    pub patch: Option<(u32, [f64; 2])>,
}
