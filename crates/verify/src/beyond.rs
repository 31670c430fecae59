//! What GCLEAR adds to a line under REGION: it may lead on into what is to be left.

use aptc_cldata::Position;
use aptc_cldata::milling::Area;
use aptc_diagnostics::{Diagnostic, codes};
use aptc_geometry::Vec3;

use crate::around::Around;
use crate::between::Way;
use crate::certificate::{at_tool_end, length};
use crate::free::Rapid;
use crate::statement::Statement;
use crate::tool::Pose;

/// Parts of a vector.
const PARTS: u32 = 8;

/// Tells it once for each REGION.
#[derive(Debug, Default)]
pub(crate) struct Beyond {
    told: Option<Vec<Area>>,
}

impl Beyond {
    /// What is added before the line of a statement, and between two stretches of one, with its part surface around.
    pub(crate) fn before(&mut self, line: &Statement, around: &Around) -> Option<Diagnostic> {
        // How the tool comes from elsewhere to what is added is its program's.
        let from = usize::from(!line.again);
        let extra = line.way.get(from..).filter(|_| line.way.len() > 1 && !line.rapid)?;
        let points: Vec<_> = extra.iter().chain(line.points.first()).copied().collect();
        self.along(&Rapid::at_feed(&line.origin, points, line.profile, line.pad), around)
    }

    /// A way of such motions: what it mills that is to be left.
    pub(crate) fn along(&mut self, way: &Rapid, around: &Around) -> Option<Diagnostic> {
        let areas = around.areas()?;
        if self.told.as_deref() == Some(areas) {
            return None;
        }
        let (limited, name) = around.limited(&way.profile)?;
        let mut last = None;
        let mut mills = |[a, b]: [Position; 2]| {
            limited.vector(&way.profile, [&a, &b], (false, way.pad), &mut last)
        };
        let parts = way.points.windows(2).flat_map(|w| parts(&w[0], &w[1]));
        let all = parts.filter_map(&mut mills);
        let (te, by) = all.reduce(|a, b| if b.1 > a.1 { b } else { a })?;
        self.told = Some(areas.to_vec());
        Some(told(way, &name, te, by))
    }
}

/// A vector in parts, at whose ends it is looked how far outside the tool is.
fn parts(a: &Position, b: &Position) -> impl Iterator<Item = [Position; 2]> {
    let way = Way::new(Pose::of(a), Pose::of(b));
    let at = move |i: u32| {
        let Pose { te, ta } = way.at(f64::from(i) / f64::from(PARTS));
        Position { te, ta }
    };
    (0..PARTS).map(move |i| [at(i), at(i + 1)])
}

fn told(way: &Rapid, name: &str, te: Vec3, by: f64) -> Diagnostic {
    let (place, by) = (at_tool_end(te.into()), length(by));
    let message = format!(
        "GCLEAR leads the tool on, at feed, into what REGION leaves out: it mills part surface {name} {by} outside of what is to be milled, {place}"
    );
    Diagnostic::warning(codes::STRAIGHT_OVER, way.origin.span, message)
        .help("leave MOTDIR out where REGION ends a line, or lead the tool off the surface with it, by NORMAL,h")
        .within(way.origin.trace.clone())
}
