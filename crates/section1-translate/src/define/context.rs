//! What stands around a definition: ZSURF, REFSYS and limits.

use std::cell::{Cell, RefCell};
use std::rc::Rc;
use std::sync::Arc;

use aptc_geometry::sculpt::SpaceCurve;
use aptc_geometry::{Plane, Transform, Vec2, Vec3};

use super::fits::Fits;

/// State of the interpreter that definitions depend on.
#[derive(Clone, Debug)]
pub struct Context {
    /// ZSURF: an equation whose numbers hold in each system, as in APT-360; `None`, z = 0, after NOMORE.
    pub zsurf: Option<Plane>,
    /// REFSYS: the map from the reference system into the base system.
    pub refsys: Option<Transform>,
    /// MATRIX as APT4 has it: given by places (points, vectors, planes) within REFSYS it leads into the base system, and
    /// of two maps the first is carried out first. Else as the manual of APT-360 has it: into the reference system,
    /// and the left map is applied to what the right gives.
    pub apt4: bool,
    /// Most points in a PATERN and most points of a TABCYL; historic 330 and 139.
    pub max_points: usize,
    /// How far a TABCYL goes straight on at both ends; historic 10 inches, in program units.
    pub tabcyl_end: f64,
    /// Curves and surfaces that definitions asked for.
    pub fits: Rc<Fits>,
    /// What the definition found on a curve or surface, for PARMF.
    pub found: RefCell<Option<Found>>,
    /// A parameter beyond the end of a curve or surface that was taken.
    pub beyond: Cell<Option<Beyond>>,
}

/// A parameter beyond the end of a sculptured form.
#[derive(Clone, Copy, Debug)]
pub struct Beyond {
    /// Number of the argument.
    pub at: usize,
    /// What it is.
    pub value: f64,
    /// The last one of the curve or surface; the first is 0.
    pub last: f64,
}

/// The place on a curve or surface that a POINT or VECTOR found.
#[derive(Clone, Debug)]
pub enum Found {
    /// At `t` of the whole curve.
    Curve {
        /// The parameter.
        t: f64,
        /// The curve.
        curve: Arc<SpaceCurve>,
    },
    /// On a patch.
    Surface {
        /// Number of the patch, from 1.
        number: usize,
        /// Parameters in it.
        local: [f64; 2],
        /// Parameters of the whole mesh; those in the patch where there is no mesh.
        global: [f64; 2],
    },
}

impl Default for Context {
    fn default() -> Self {
        Self {
            zsurf: None,
            refsys: None,
            apt4: false,
            max_points: 100_000,
            tabcyl_end: 10.0,
            fits: Rc::default(),
            found: RefCell::default(),
            beyond: Cell::default(),
        }
    }
}

/// ZSURF gives no height where its normal is this much flatter than upright.
const STEEP: f64 = 1e-9;

impl Context {
    /// The point over (x, y) on ZSURF.
    pub(super) fn on_zsurf(&self, x: f64, y: f64) -> Vec3 {
        on_zsurf(self.zsurf, x, y)
    }

    /// The point over `p` on ZSURF.
    pub(super) fn lift(&self, p: Vec2) -> Vec3 {
        self.on_zsurf(p.x, p.y)
    }

    /// Is ZSURF a plane that gives heights? The interpreter asks once, at the ZSURF statement.
    pub fn zsurf_is_usable(plane: &Plane) -> bool {
        plane.n.z.abs() > STEEP
    }

    /// This context within its reference system.
    pub(super) fn inside(&self) -> Self {
        Self { refsys: None, ..self.clone() }
    }
}

/// The point over (x, y) on the plane of ZSURF, or at z = 0.
pub(crate) fn on_zsurf(zsurf: Option<Plane>, x: f64, y: f64) -> Vec3 {
    let z = zsurf.map_or(0.0, |s| (s.d - s.n.x * x - s.n.y * y) / s.n.z);
    // A plane z = 0 must not give the point a negative zero.
    Vec3::new(x, y, z + 0.0)
}
