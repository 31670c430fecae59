//! Surfaces and demands of regional milling that tests share.

use std::sync::Arc;

use aptc_cldata::NameRef;
use aptc_cldata::milling::{Milled, Milling};
use aptc_geometry::sculpt::{SplinePoint, mesh};
use aptc_geometry::sculptured::MeshSpacing;
use aptc_geometry::{Sculptured, Vec3};

/// INTOL and OUTTOL.
pub(crate) const BAND: f64 = 0.01;

/// A square of 20 over x and y in so many spans each way, `z` above it.
pub(crate) fn square(n: i32, z: impl Fn(f64, f64) -> f64) -> Arc<Sculptured> {
    let step = 20.0 / f64::from(n);
    let at = |i: i32, j: i32| {
        let (x, y) = (step * f64::from(i), step * f64::from(j));
        SplinePoint::plain(Vec3::new(x, y, z(x, y)))
    };
    let rows: Vec<Vec<_>> = (0..=n).map(|j| (0..=n).map(|i| at(i, j)).collect()).collect();
    Arc::new(mesh(&rows, MeshSpacing::Xyz).expect("a surface"))
}

pub(crate) fn milled(name: &str, surface: &Arc<Sculptured>, side: f64, thick: f64) -> Milled {
    let name = NameRef { name: name.into(), subscript: 0 };
    Milled { name, surface: Arc::clone(surface), side, thick, body: None }
}

/// Nothing but a part surface is asked for.
pub(crate) fn milling(part: Option<Milled>) -> Milling {
    Milling {
        part,
        on: false,
        risen: false,
        checked: Vec::new(),
        plain: Vec::new(),
        holder: Vec::new(),
        guarded: false,
        intol: BAND,
        outtol: BAND,
        scallop: None,
        joined: false,
        over: false,
        limits: None,
    }
}
