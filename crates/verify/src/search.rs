//! That a curved surface, moved along its normals, stays clear of the tool: branch and bound over its charts.
//!
//! The tool's points all have signed distance at least `s` from the surface when no point of the surface
//! moved by `s` along its normal lies in the tool and the tool is not wholly on the wrong side. For a piece
//! in the parallelogram `c +- a +- b` inflated by `d` any unit m shows that it stays at
//! `m . c - h(T, m) - |m . a| - |m . b| - d` from the tool. As m serves the direction from the tool to c.

use aptc_geometry::Vec3;

use crate::beside::{Begin, Beside, Ways};
use crate::cut::{Cut, Cutting, Plane};
use crate::paraboloid::Seen;
use crate::sheet::{Patch, Patches, Sheet, Spot, Tile};
use crate::sweep::{Meeting, Slack, Sweep};

/// Pieces that one search looks at; beyond it the answer is open.
const MOST: u32 = 20_000;
/// The same where a place that is too near is known, and it is asked whether another is nearer still.
const FEW: u32 = 2_000;
/// Pieces that a search looks at for a still nearer place when it has found one that is too near.
const MORE: u32 = 400;

/// A bound may miss the truth by so many times what is allowed for the turn of the axis, and a shorter way still helps.
pub(crate) const TURNED: f64 = 20.0;

/// Share of the shift below which a piece that is too near is not cut further, as a rule and where that decides nothing.
pub(crate) const FOLD: f64 = 1e-4;
pub(crate) const FINE_FOLD: f64 = 1e-6;

/// What a search found.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clearance {
    /// No point of the moved surface is nearer to the tool; negative infinity when it is not known.
    pub(crate) least: f64,
    /// The nearest that was met: distance, share of the way, place of the surface.
    pub(crate) nearest: Option<(f64, f64, Spot)>,
    /// Did the search end where only a shorter way helps, as the axis turns?
    pub(crate) turned: bool,
}

/// The surface moved by `shift` along its normals to the side `side`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moved<'a> {
    pub(crate) sheet: &'a Sheet,
    pub(crate) side: f64,
    pub(crate) shift: f64,
    /// Share of the shift below which a piece of it counts as a fold.
    pub(crate) fold: f64,
}

impl Moved<'_> {
    /// Where a place of the surface is moved to.
    pub(crate) fn place(&self, spot: &Spot) -> Vec3 {
        let jet = self.sheet.jet(spot);
        jet.p + jet.n * (self.side * self.shift)
    }
}

/// What the search of the vector before leaves to the next along the same surface.
#[derive(Clone, Debug, Default)]
pub(crate) struct Lead {
    /// The direction that separated the tool from the piece next to it. About a tool that stands against a crest it is the
    /// only one.
    pub(crate) direction: Option<Vec3>,
    pub(crate) cut: Cut,
    /// Where the place of the surface next to the tool's corner is looked for.
    pub(crate) begin: Begin,
    /// Is a place known that is too near, so that only how near it is hangs on this search?
    pub(crate) known: bool,
}

/// What a search is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Aim {
    /// The nearest place, to a tenth of what it falls short of `enough`.
    Nearest,
    /// That all is far enough, else the same; what is far enough is not looked at closely.
    Clear,
    /// Any place that is too near, else that all is far enough; what is far enough is not looked at closely.
    Any,
}

/// Bounds the distance between the moved surface and the tool on its way. The search ends where `enough` is
/// shown.
pub(crate) fn clearance(sweep: &Sweep<'_>, moved: &Moved<'_>, enough: f64, aim: Aim) -> Clearance {
    clearance_from(sweep, moved, enough, aim, &mut Lead::default())
}

/// The same with what the vector before leaves, which becomes what this one does.
pub(crate) fn clearance_from(
    sweep: &Sweep<'_>,
    moved: &Moved<'_>,
    enough: f64,
    aim: Aim,
    lead: &mut Lead,
) -> Clearance {
    let direction = lead.direction;
    let found = search(sweep, moved, enough, aim, lead);
    // Where the axis turns too far for the way to be shown at once a shorter one is looked at next.
    let shorter = found.turned && enough - found.least <= TURNED * sweep.turned();
    if found.least >= enough || !lead.cut.went_on() || shorter {
        return found;
    }
    // What the cut leaves may hide the direction that shows all: once more from the root of the tree.
    lead.direction = direction;
    lead.cut.forget();
    search(sweep, moved, enough, aim, lead)
}

fn search(
    sweep: &Sweep<'_>,
    moved: &Moved<'_>,
    enough: f64,
    aim: Aim,
    lead: &mut Lead,
) -> Clearance {
    let (center, radius) = sweep.sphere();
    let mut pile = Patches::new();
    let mut out = Clearance { least: f64::INFINITY, nearest: None, turned: false };
    // What is farther than `enough` need not be looked at, and the rest of the surface is.
    let within = radius + moved.shift.abs() + enough.abs();
    let mut cutting = match moved.sheet.tree().filter(|_| aim == Aim::Clear) {
        Some(root) => Some(lead.cut.begin(sweep, moved, enough, root, &mut pile)),
        None if moved.sheet.roots(center, within, &mut pile) => None,
        None => return Clearance { least: f64::NEG_INFINITY, ..out },
    };
    if let Some(cutting) = &cutting {
        out.least = cutting.rest;
    }
    let found = |out: &Clearance| out.nearest.is_some_and(|n| n.0 < enough);
    let most = if lead.known { FEW } else { MOST };
    let mut seen = 0;
    // How far the piece was of which the hint is.
    let mut closest = f64::INFINITY;
    let mut hinted = lead.direction.map(|m| sweep.kept(sweep.along(m)));
    let mut whole = true;
    let ways = Ways::new(sweep);
    let mut beside = Beside::new(&ways, moved.shift + enough, lead.begin);
    while let Some(patch) = pile.pop() {
        seen += 1;
        if found(&out) {
            seen = seen.max(most - MORE);
        }
        if seen > most {
            out.least = f64::NEG_INFINITY;
            whole = false;
            break;
        }
        let known = known(&out, enough);
        if let Some(node) = moved.sheet.group(&patch) {
            let shift = moved.shift.abs();
            let radius = node.radius + shift;
            let held = |meeting: &Meeting| {
                let slack = |m| Slack { by: [radius, 0.0], all: node.extent(m) + shift };
                let (low, slack, _) = sweep.proved(meeting, node.center, radius, known, slack);
                (low, low + slack.all)
            };
            let (mut low, middle) =
                hinted.as_ref().map_or((f64::NEG_INFINITY, f64::NEG_INFINITY), held);
            let mut plane = hinted.map_or(Plane::NONE, |m| Plane::along(sweep, m.m, low));
            let mut at_end = low;
            if let Some(cutting) = cutting.as_ref().filter(|c| !c.is_far(low)) {
                let end = cutting.at_end(sweep, node, shift);
                at_end = low.max(end.by_end(sweep));
                low = low.max(cutting.before_end(end.by_end(sweep)));
                plane = plane.or(end, sweep);
            }
            if low < known {
                let far = (node.center - center).norm() - node.radius - within;
                if far >= 0.0 {
                    low = enough.max(far);
                } else if middle < known {
                    // What is far enough in its middle by the hint is far enough in parts by it, most likely.
                    low = low.max(held(&sweep.meet(node.center)).0);
                }
            }
            if low >= known {
                out.least = out.least.min(low);
                if let Some(cutting) = &mut cutting {
                    cutting.clear(&patch, low.max(at_end), plane);
                }
                continue;
            }
            let below = moved.sheet.below(&patch, center);
            if !below.into_iter().flatten().all(|p| pile.push(p)) {
                out.least = f64::NEG_INFINITY;
                whole = false;
                break;
            }
            continue;
        }
        let known_tile = cutting.as_ref().and_then(|c| c.tile(&patch));
        let tile = known_tile.unwrap_or_else(|| moved.sheet.tile(&patch));
        let far = (tile.c - center).norm() - tile.radius() - within;
        if far >= 0.0 {
            keep(&mut out, &mut cutting, (&patch, &tile), enough.max(far), Plane::NONE);
            continue;
        }
        let x = tile.c + tile.n * (moved.side * moved.shift);
        let within_tile = tile.radius() + 2.0 * moved.shift.abs();
        let bound = |meeting: Meeting| {
            let slack = |m| slack(&tile, m, moved.shift.abs());
            let (low, slack, rise) = sweep.proved(&meeting, x, within_tile, known, slack);
            Shown { low, own: low, meeting, slack, rise }
        };
        let by_hint = hinted.filter(|_| aim != Aim::Nearest).map(bound);
        if aim == Aim::Clear && by_hint.as_ref().is_none_or(|shown| shown.low < known) {
            match beside.see(moved.sheet, &patch, &tile) {
                (Seen::Clear(low, about), m) if enough + low >= known => {
                    if enough + low < closest {
                        (closest, hinted) = (enough + low, Some(sweep.kept(sweep.along(m))));
                    }
                    let shown = bound(sweep.along(about));
                    let plane = Plane::along(sweep, about, shown.low);
                    keep(&mut out, &mut cutting, (&patch, &tile), enough + low, plane);
                    continue;
                }
                // What lies beside it is shown by something else, where anything comes of this search.
                (Seen::Spanned { low, last, m }, _) if moved.shift <= 0.0 => {
                    out.least = out.least.min(enough + low);
                    let plane = Plane::along(sweep, m, bound(sweep.along(m)).low);
                    hold(&mut cutting, (&patch, &tile), enough + last, plane);
                    continue;
                }
                (Seen::Large(i), _) => {
                    let [near, away] = patch.halves(i);
                    if !(pile.push(away) && pile.push(near)) {
                        keep(
                            &mut out,
                            &mut cutting,
                            (&patch, &tile),
                            f64::NEG_INFINITY,
                            Plane::NONE,
                        );
                    }
                    continue;
                }
                _ => {}
            }
        }
        let shown = match by_hint {
            Some(shown) if shown.low >= known => shown,
            Some(shown) if shown.halves_show(known, &tile, moved) => shown,
            _ => {
                // Along the normal the piece has no extent: next to a place that is touched that direction shows
                // most.
                let [first, square] = sweep.level(tile.n * -moved.side, x);
                let first = bound(first);
                // Where the first shows it the other need not be asked.
                let level = if aim != Aim::Nearest && first.low >= known {
                    first
                } else {
                    Shown::better(first, bound(square))
                };
                let level = by_hint.map_or(level, |shown| Shown::better(shown, level));
                if aim != Aim::Nearest
                    && (level.low >= known || level.halves_show(known, &tile, moved))
                {
                    level
                } else {
                    let (meeting, within) = sweep.meet_within(x);
                    if out.nearest.is_none_or(|n| meeting.distance < n.0) {
                        out.nearest = Some((meeting.distance, meeting.t, patch.spot()));
                        if aim == Aim::Any && meeting.distance < enough {
                            out.least = f64::NEG_INFINITY;
                            whole = false;
                            break;
                        }
                    }
                    // The meeting tells where the piece is best cut.
                    let met = bound(meeting);
                    let mut best = Shown::better(level, met);
                    if best.low < known
                        && let Some(edge) = sweep.edge(tile.n * -moved.side, x, met.meeting.t)
                    {
                        best = edge.map(bound).into_iter().fold(best, Shown::better);
                    }
                    // What is lost of the two faces by whose edge it passes hangs on them alone.
                    let met = match within.filter(|_| best.low < known) {
                        Some(within) => {
                            let slack = |m| slack(&tile, m, moved.shift.abs());
                            let (low, slack, rise) = sweep.turning(&within, x, within_tile, &slack);
                            Shown { low, own: low, slack, rise, meeting }
                        }
                        None => met,
                    };
                    Shown {
                        low: best.low.max(met.low),
                        own: best.low,
                        meeting: best.meeting,
                        ..met
                    }
                }
            }
        };
        let Shown { low, own, meeting, slack: Slack { by: slack, .. }, rise } = shown;
        // The way may be known to be longer by now.
        let known = self::known(&out, enough);
        if low >= known {
            if low < closest {
                (closest, hinted) = (low, Some(sweep.kept(meeting)));
            }
            let plane = || {
                // What shows most at the end may show it for longer.
                let (distance, m) = sweep.tool.near(&sweep.b, x);
                let at_end = distance - self::slack(&tile, m, moved.shift.abs()).all;
                let plane = Plane::along(sweep, meeting.m, own);
                plane.or(Plane::at_end(sweep, m, at_end), sweep)
            };
            let plane = if cutting.is_some() { plane() } else { Plane::NONE };
            keep(&mut out, &mut cutting, (&patch, &tile), low, plane);
            continue;
        }
        if slack[0] + slack[1] <= rise {
            // Smaller pieces do not help, a shorter way does.
            out.least = out.least.min(low);
            (whole, out.turned) = (false, true);
            break;
        }
        if tile.radius() <= moved.fold * moved.shift.abs() {
            // What is left is the normal, which turns by as much however small the piece: the moved surface
            // has a fold or a tip here.
            keep(&mut out, &mut cutting, (&patch, &tile), low, Plane::NONE);
            seen = seen.max(most - MORE);
            continue;
        }
        let i = usize::from(slack[1] > slack[0]);
        let [near, away] = patch.halves(i);
        // The half towards the tool is looked at first.
        let towards = tile.side[i].dot(&meeting.m) < 0.0;
        let (first, second) = if towards { (away, near) } else { (near, away) };
        let tiny = slack[i] <= f64::EPSILON * (x.norm() + radius);
        if tiny || !(pile.push(second) && pile.push(first)) {
            keep(&mut out, &mut cutting, (&patch, &tile), low, Plane::NONE);
        }
    }
    if let Some(cutting) = cutting.filter(|_| whole) {
        cutting.done(sweep);
    }
    lead.direction = hinted.map(|h| h.m);
    lead.begin = beside.next();
    out.least = out.least.min(enough.max(out.nearest.map_or(enough, |n| n.0)));
    out
}

/// Notes how far a piece is at least; a search that goes on from here looks at it again in time.
fn keep(
    out: &mut Clearance,
    cutting: &mut Option<Cutting<'_>>,
    piece: (&Patch, &Tile),
    low: f64,
    plane: Plane,
) {
    out.least = out.least.min(low);
    hold(cutting, piece, low, plane);
}

/// The same but for what this search tells.
fn hold(cutting: &mut Option<Cutting<'_>>, (piece, tile): (&Patch, &Tile), low: f64, plane: Plane) {
    if let Some(cutting) = cutting {
        let piece = cutting.keep(piece, tile);
        cutting.clear(&piece, low, plane);
    }
}

/// What a direction shows of a piece.
#[derive(Clone, Copy, Debug)]
struct Shown {
    /// It is nowhere nearer than this.
    low: f64,
    /// What the direction of the meeting alone shows.
    own: f64,
    meeting: Meeting,
    slack: Slack,
    /// The part that is due to the turn.
    rise: f64,
}

impl Shown {
    /// Is the direction likely to show of both halves what it does not of the whole?
    fn halves_show(&self, known: f64, tile: &Tile, moved: &Moved<'_>) -> bool {
        let [u, v] = self.slack.by;
        self.low + 0.5 * self.slack.all >= known
            && u + v > 2.0 * self.rise
            && tile.radius() > 2.0 * moved.fold * moved.shift.abs()
    }

    fn better(a: Self, b: Self) -> Self {
        if b.low > a.low { b } else { a }
    }
}

/// What a piece must stay away from the tool to be of no more interest.
fn known(out: &Clearance, enough: f64) -> f64 {
    let nearest = out.nearest.map_or(f64::INFINITY, |n| n.0);
    if nearest < enough { nearest - 0.1 * (enough - nearest) } else { enough }
}

/// By how much the distance may be less on the piece than in its middle.
#[inline]
fn slack(tile: &Tile, m: Vec3, shift: f64) -> Slack {
    let along = m.dot(&tile.n);
    let across = (m - tile.n * along).norm();
    let whole = tile.turn[0] + tile.turn[1];
    let turned = tile.turn.map(|t| shift * t * (across + 0.5 * whole * along.abs()));
    let by = [0, 1].map(|i| m.dot(&tile.side[i]).abs() + tile.stray[i] + turned[i]);
    Slack { by, all: tile.dip(m) + turned[0] + turned[1] }
}
