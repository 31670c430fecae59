//! All places of contact on a tabulated cylinder, by a look along its directrix.
//!
//! At a place of the directrix let p be the point of the cutter that is farthest in along the surface normal. Where it lies
//! ahead of the place before, and behind it afterwards, the cutter touches in between, on a crest as in a hollow; where the
//! opposite happens it is farthest away. The cutter may span many crests, which stations around it would miss.

use aptc_geometry::surface::TabcylSurface;
use aptc_geometry::{Spot, Tool, Vec3};

use crate::gap::{Gap, Side};
use crate::stations::{SEEDS, Seeds};

/// Parts in which a span is looked at, and those of it where the cutter is near a contact at both ends.
const PARTS: u32 = 4;
/// How often parts are divided at most.
const LEVELS: u32 = 3;
/// Halvings between two looks.
const HALVINGS: u32 = 10;

/// Places of contact beside the tool, the deepest first; `None` where there are none, as far from the surface.
pub(crate) fn seeds(
    tool: &Tool<'_>,
    surface: &TabcylSurface,
    side: Side,
    known: Option<&Gap>,
) -> Option<Seeds> {
    let wide = tool.profile.widest();
    let found = within(tool, surface, side, known, (1.0 + MARGIN) * wide)?;
    // What is nearer than the deepest may lie farther beside a tool that is not at the surface.
    let depth = found.deepest.0;
    if depth > MARGIN * wide {
        return within(tool, surface, side, known, wide + (1.0 + BEHIND) * depth);
    }
    Some(found)
}

/// The same of the spans not farther than `reach` from the tool axis.
fn within(
    tool: &Tool<'_>,
    surface: &TabcylSurface,
    side: Side,
    known: Option<&Gap>,
    reach: f64,
) -> Option<Seeds> {
    let top = tool.te + tool.ta * tool.profile.height();
    let behind = BEHIND * tool.profile.widest();
    let mut found: [Option<(f64, Spot)>; SEEDS] = [None; SEEDS];
    let (mut deepest, mut next) = ((f64::INFINITY, tool.te), f64::INFINITY);
    let mut offer = |l: Look| {
        // The far side of a closed curve, or of a fold, is not cut into from behind: neither is the cutter's point behind the
        // surface there, nor the place in the cutter.
        let w = surface.generator();
        let apart = |p: Vec3| tool.distance(l.spot.point + w * w.dot(&(p - l.spot.point)));
        let outside = || [l.tool_point, tool.te, top].into_iter().all(|p| apart(p) > behind);
        let before = || side.sign() * surface.foot(l.tool_point).distance > 0.5 * l.depth;
        if l.depth < 0.0 && outside() && before() {
            return;
        }
        if l.depth < deepest.0 {
            deepest = (l.depth, l.tool_point);
        }
        let mut last = Some((l.depth, l.spot));
        if let Some(i) = found.iter().position(|f| f.is_none_or(|f| l.depth < f.0)) {
            found[i..].rotate_right(1);
            std::mem::swap(&mut found[i], &mut last);
        }
        next = last.map_or(next, |l| next.min(l.0));
    };
    let look = |span: usize, s: f64| Look::at(tool, surface, side, span, s);
    let mut before: Option<(usize, Look)> = None;
    for (span, length) in surface.spans_near(tool.te, top, reach) {
        let first = look(span, 0.0);
        // A corner between two spans.
        if let Some((last, l)) = before
            && last + 1 == span
            && l.ahead > 0.0
            && first.ahead <= 0.0
        {
            offer(first);
        }
        let last = look(span, length);
        let part = Part { span, from: (0.0, first), to: (length, last) };
        part.contacts(&look, &mut offer, LEVELS);
        before = Some((span, last));
    }
    found[0]?;
    let way = known.map_or(f64::INFINITY, |k| (next - k.raw).max(0.0));
    let spot = |i: usize| found.get(i).copied().flatten().map(|f| f.1);
    Some(Seeds { found: std::array::from_fn(spot), deepest, way })
}

/// Share of the cutter's radius by which a span may be beside the cutter.
const MARGIN: f64 = 0.5;
/// The same by which a place that the cutter seems to cut into may be outside of it.
const BEHIND: f64 = 1e-3;

/// A part of a span between two looks.
struct Part {
    span: usize,
    from: (f64, Look),
    to: (f64, Look),
}

impl Part {
    /// Offers its places of contact. Where the cutter is ahead at both ends, or behind, by less than the length of the part
    /// it may touch in between.
    fn contacts(
        &self,
        look: &impl Fn(usize, f64) -> Look,
        offer: &mut impl FnMut(Look),
        levels: u32,
    ) {
        let Self { span, from: (low, a), to: (high, b) } = self;
        let (a_ahead, b_ahead) = (a.ahead > 0.0, b.ahead > 0.0);
        let near = a.ahead.abs().min(b.ahead.abs()) < high - low;
        if levels == LEVELS || levels > 0 && a_ahead == b_ahead && near {
            let mut from = self.from;
            for part in 1..=PARTS {
                let s = low + (high - low) * (f64::from(part) / f64::from(PARTS));
                let to = if part == PARTS { self.to } else { (s, look(*span, s)) };
                Part { span: *span, from, to }.contacts(look, offer, levels - 1);
                from = to;
            }
            return;
        }
        if !a_ahead || b_ahead {
            return;
        }
        let (mut low, mut high, mut nearest) = (*low, *high, *b);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            nearest = look(*span, middle);
            *(if nearest.ahead > 0.0 { &mut low } else { &mut high }) = middle;
        }
        offer(nearest);
    }
}

/// What is seen at a place of the directrix.
#[derive(Clone, Copy)]
struct Look {
    spot: Spot,
    tool_point: Vec3,
    /// How far the cutter's farthest point in is before the tangent plane, and how far ahead along the directrix.
    depth: f64,
    ahead: f64,
}

impl Look {
    fn at(tool: &Tool<'_>, surface: &TabcylSurface, side: Side, span: usize, s: f64) -> Self {
        #[expect(clippy::cast_precision_loss, reason = "thousands at most")]
        let place = surface.place(tool.te, [span as f64, s]);
        let normal = place.normal * side.sign();
        let tool_point = tool.support(-normal).point;
        let away = tool_point - place.point;
        // The directrix runs with its normal on its left.
        let along = place.normal.cross(&surface.generator());
        let mut spot = place.spot();
        spot.point += surface.generator() * surface.generator().dot(&away);
        Self { spot, tool_point, depth: normal.dot(&away), ahead: along.dot(&away) }
    }
}
