//! A cutter that goes over to the other side of a surface to which its disk keeps, CUTTER/OPTION.
//!
//! A disk without height touches from both sides: what is asked of it holds as well of a cutter that stands on its head, or that goes
//! on behind the surface. The cutter above it went through the surface then.

use aptc_cldata::{Control, Controlled, Position, Relation};
use aptc_geometry::{Profile, Vec3};

use crate::demand::Demand;
use crate::sheets::Sheets;

/// Cosine between axis and normal from which a tool stands on a surface, and is not beside it.
const STANDS: f64 = 0.5;

/// Where the cutter is in the material, which its disk does not show: the number of the vector, counted from 0, and the position. It goes
/// over where the motion `earlier`, which ended where this one begins, kept to the other side of the surface, and where it turns over in
/// place. PAST leads to the other side.
pub(crate) fn goes_over(
    c: &Controlled,
    (start, points): (&Position, &[Position]),
    startup: bool,
    earlier: Option<&Control>,
    profile: &Profile,
    sheets: &Sheets,
) -> Option<(usize, Position)> {
    let [_, height] = c.disk.filter(|_| c.side != 0 && c.relation != Relation::On)?;
    let side = f64::from(c.side);
    let reach = profile.reach();
    let end = Controlled { relation: Relation::On, side: 0, outtol: f64::INFINITY, ..c.clone() };
    let demand = Demand::new(&end, sheets);
    // The cosine of the angle between the axis and the normal on the side of the tool.
    let lean = |at: &Position| {
        let step = 1e-3 * reach;
        let gap =
            |up: f64| demand.gap_at(profile, &Position { te: at.te + up * at.ta, ta: Vec3::z() });
        Some(side * (gap(height + step)? - gap(height)?) / step)
    };
    let other = Controlled { side: -c.side, ..c.clone() };
    let from_there = c.relation == Relation::To
        && earlier.is_some_and(|e| e.band_of(c).is_none() && e.band_of(&other).is_some());
    if from_there && lean(start).is_some_and(|lean| lean <= -STANDS) {
        return Some((0, *start));
    }
    let turned = |to: &Position| {
        let near = (to.te - start.te).norm() <= reach;
        !startup && near && to.ta.dot(&start.ta) < 0.0
    };
    if !points.iter().any(turned) {
        return None;
    }
    let first = lean(start).filter(|first| first.abs() >= STANDS)?;
    let over =
        |to: &Position| turned(to) && lean(to).is_some_and(|l| l * first <= -STANDS * STANDS);
    let i = points.iter().position(over)?;
    Some((i, if first < 0.0 { *start } else { points[i] }))
}
