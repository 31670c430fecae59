//! A checked surface that has sides: cutter, holder and the axis between them keep to that from which the tool comes.

use std::sync::Arc;

use aptc_cldata::Position;
use aptc_geometry::surface::kept::{lower_end, opens, side_from, with_inside};
use aptc_geometry::{Form, Profile, Surface, Vec3};

use crate::curved::Warm;
use crate::demand::{Demand, Verdict};
use crate::milled::clear;
use crate::sheet::Sheet;
use crate::sheets::Sheets;
use crate::solid::unit_or;
use crate::tool::{Pose, Tool};

/// What is asked beside such a surface.
#[derive(Clone, Debug)]
pub(crate) struct Kept {
    /// Its inside is on its negative side.
    surface: Surface,
    /// From where the tool comes, and the side there.
    from: Vec3,
    side: f64,
    beside: Beside,
    /// What is asked of a tool in the inside of it that is open along the axis.
    opened: Option<Demand>,
    least: f64,
}

/// What is asked of a tool wherever that does not count.
#[derive(Clone, Debug)]
enum Beside {
    Solid(Box<Demand>),
    /// That nothing of the surface is in the tool, which is on its side then if a point of it is.
    Sheet(Arc<Sheet>),
}

impl Kept {
    /// Nothing of the surface is deeper in the tool than `depth`; a lower end no farther than `near` from it is on it. `None` of
    /// surfaces that have no sides.
    pub(crate) fn new(
        form: &Arc<Form>,
        [near, depth]: [f64; 2],
        sheets: &Sheets,
        (cutter, at): (&Profile, &Position),
    ) -> Option<Self> {
        let surface = with_inside(&Surface::from_form(form)?)?;
        let side = side_from(&surface, cutter, (at.te, at.ta), near)?;
        let (beside, opened) = if let Surface::Quadric(quadric) = &surface {
            let opened = if side < 0.0 { Demand::hollow(quadric, depth) } else { None };
            (Beside::Sheet(sheets.of_form(form)?), opened)
        } else {
            let opened = if side < 0.0 { Demand::clear(form, side, true, depth) } else { None };
            (Beside::Solid(Box::new(Demand::clear(form, side, false, depth)?)), opened)
        };
        Some(Self { surface, from: at.te, side, beside, opened, least: -depth })
    }

    /// Does the tool work inside of a round surface?
    pub(crate) fn is_round_about(&self) -> bool {
        self.side < 0.0 && !matches!(self.surface, Surface::Plane(_))
    }

    /// Does its inside end above, as seen along the axis?
    pub(crate) fn ends_along(&self, ta: Vec3) -> bool {
        match &self.surface {
            Surface::Cone(s) => s.axis.dot(&ta) < s.cos_half,
            surface => opens(surface, ta),
        }
    }

    /// Allows the tool to be deeper by so much.
    pub(crate) fn allow(&mut self, deeper: f64) {
        self.least -= deeper;
        if let Beside::Solid(demand) = &mut self.beside {
            demand.least -= deeper;
        }
        if let Some(demand) = &mut self.opened {
            demand.least -= deeper;
        }
    }

    /// Does the tool come from the inside, and is the point there too?
    pub(crate) fn encloses(&self, p: Vec3) -> bool {
        self.side < 0.0 && self.surface.distance(p) < 0.0
    }

    /// Judges the vector of a solid of the tool from `a` to `b`: a trough along which the tool comes to stand is a bore.
    pub(crate) fn judge(
        &self,
        tool: &Tool<'_>,
        a: &Position,
        b: &Position,
        pad: f64,
        warm: &mut Warm,
    ) -> Verdict {
        if let Some(demand) = &self.opened
            && opens(&self.surface, unit_or(a.ta + b.ta, a.ta))
        {
            return demand.judge_tool(tool, a, b, pad, warm);
        }
        match &self.beside {
            Beside::Solid(demand) => demand.judge_tool(tool, a, b, pad, warm),
            Beside::Sheet(sheet) => {
                let found = clear(sheet, tool, [a, b], self.least - pad, warm);
                // It was nowhere passed: one point of the tool tells on which side all of it is.
                let inner = tool.inner(&Pose { te: b.te, ta: b.ta });
                let gap = self.side * self.surface.distance(inner);
                match found {
                    Verdict::Proved { .. } if gap < self.least - pad => {
                        Verdict::Refuted { gap, te: b.te }
                    }
                    found => found,
                }
            }
        }
    }

    /// What there is to say where a vector is refuted: does the tool, which came from outside, stand in what could be a bowl?
    pub(crate) fn entered(
        &self,
        cutter: &Profile,
        te: Vec3,
        [a, b]: [&Position; 2],
    ) -> Option<String> {
        let ta = unit_or(a.ta + b.ta, a.ta);
        let inside = self.surface.distance(lower_end(cutter, (te, ta))) < 0.0;
        let [x, y, z]: [f64; 3] = self.from.into();
        (self.side > 0.0 && inside && opens(&self.surface, ta)).then(|| {
            format!(
                "the tool came from {x:.4}, {y:.4}, {z:.4}, outside of this surface, which counts as solid; here it stands inside"
            )
        })
    }
}
