//! The looks of a search: group after group and piece after piece, until all is far enough or something is too near.

use std::ops::ControlFlow::{self, Break, Continue};

use aptc_geometry::Vec3;

use super::{Aim, Clearance, Lead, Moved};
use crate::beside::{Beside, Ways};
use crate::cut::{Cutting, Plane};
use crate::each::two;
use crate::paraboloid::Seen;
use crate::sheet::{Node, Patch, Patches, Tile};
use crate::sweep::{Meeting, Slack, Sweep};

/// Pieces that one search looks at; beyond it the answer is open.
const MOST: u32 = 20_000;
/// The same where a place that is too near is known, and it is asked whether another is nearer still.
const FEW: u32 = 2_000;
/// Pieces that a search looks at for a still nearer place when it has found one that is too near.
const MORE: u32 = 400;

/// One search, begun where `lead` says, which then says where the next one begins.
pub(super) fn search(
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
    let tree = moved.sheet.tree().filter(|_| aim == Aim::Clear && moved.only.is_none());
    let cutting = match tree {
        None if let Some(only) = moved.only => {
            if !only.iter().all(|patch| pile.push(*patch)) {
                return Clearance { least: f64::NEG_INFINITY, ..out };
            }
            None
        }
        Some(root) => Some(lead.cut.begin(sweep, moved, enough, root, &mut pile)),
        None if moved.sheet.roots(center, within, &mut pile) => None,
        None => return Clearance { least: f64::NEG_INFINITY, ..out },
    };
    if let Some(cutting) = &cutting {
        out.least = cutting.rest;
    }
    let ways = Ways::new(sweep);
    // How deep a tool is in what is moved back is told by the surface itself; how far it stays off from that is not.
    let told = moved.shift >= 0.0 || enough <= 0.0;
    let away = if told { moved.shift + enough } else { f64::NEG_INFINITY };
    let mut looks = Looks {
        sweep,
        moved,
        enough,
        aim,
        ball: (center, within),
        pile: &mut pile,
        out,
        cutting,
        left: if lead.known { FEW } else { MOST },
        closest: f64::INFINITY,
        hinted: None,
        towards: lead.direction,
        beside: Beside::new(&ways, away, lead.begin),
    };
    let whole = looks.all().is_continue();
    lead.direction = looks.towards.or(looks.hinted.map(|h| h.m));
    lead.begin = looks.beside.next();
    let mut out = looks.out;
    if let Some(cutting) = looks.cutting.filter(|_| whole) {
        cutting.done(sweep);
    }
    out.least = out.least.min(enough.max(out.nearest.map_or(enough, |n| n.0)));
    out
}

/// A search on its way. `Break` ends one that has not looked at all of the surface.
struct Looks<'a, 'c> {
    sweep: &'a Sweep<'a>,
    moved: &'a Moved<'a>,
    enough: f64,
    aim: Aim,
    /// What lies outside of it is far enough.
    ball: (Vec3, f64),
    /// What waits to be looked at: too large to be moved about.
    pile: &'c mut Patches,
    out: Clearance,
    cutting: Option<Cutting<'c>>,
    /// Looks that are left.
    left: u32,
    /// How far the piece was of which the hint is, and the hint: a direction that shows other pieces, most likely.
    closest: f64,
    hinted: Option<Meeting>,
    /// A direction that is a better one, and of which nothing is known yet.
    towards: Option<Vec3>,
    beside: Beside<'a>,
}

impl Looks<'_, '_> {
    fn all(&mut self) -> ControlFlow<()> {
        while let Some(patch) = self.pile.pop() {
            if self.out.nearest.is_some_and(|n| n.0 < self.enough) {
                self.left = self.left.min(MORE);
            }
            if self.left == 0 {
                return self.lost();
            }
            self.left -= 1;
            match self.moved.sheet.group(&patch) {
                Some(node) => self.group(&patch, node)?,
                None => self.piece(&patch)?,
            }
        }
        Continue(())
    }

    /// The hint.
    fn hint(&mut self) -> Option<Meeting> {
        if let Some(m) = self.towards.take() {
            self.hinted = Some(self.sweep.kept(self.sweep.along(m)));
        }
        self.hinted
    }

    /// Nothing is known of what is left.
    fn lost(&mut self) -> ControlFlow<()> {
        self.out.least = f64::NEG_INFINITY;
        Break(())
    }

    /// What a piece must stay away from the tool to be of no more interest.
    fn known(&self) -> f64 {
        let nearest = self.out.nearest.map_or(f64::INFINITY, |n| n.0);
        let short = self.enough - nearest;
        if short > 0.0 { nearest - 0.1 * short } else { self.enough }
    }

    /// A group of charts, whose parts are looked at where it is not far enough.
    fn group(&mut self, patch: &Patch, node: &Node) -> ControlFlow<()> {
        let (sweep, known, hinted) = (self.sweep, self.known(), self.hint());
        let (center, within) = self.ball;
        let shift = self.moved.shift.abs();
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
        if let Some(cutting) = self.cutting.as_ref().filter(|c| !c.is_far(low)) {
            let end = cutting.at_end(sweep, node, shift);
            at_end = low.max(end.by_end(sweep));
            low = low.max(cutting.before_end(end.by_end(sweep)));
            plane = plane.or(end, sweep);
        }
        if low < known {
            let far = (node.center - center).norm() - node.radius - within;
            if far >= 0.0 {
                low = self.enough.max(far);
            } else if middle < known {
                // What is far enough in its middle by the hint is far enough in parts by it, most likely.
                low = low.max(held(&sweep.meet(node.center)).0);
            }
        }
        if low >= known {
            self.out.least = self.out.least.min(low);
            if let Some(cutting) = &mut self.cutting {
                cutting.clear(patch, low.max(at_end), plane);
            }
            return Continue(());
        }
        let below = self.moved.sheet.below(patch, center);
        if below.into_iter().flatten().all(|p| self.pile.push(p)) {
            Continue(())
        } else {
            self.lost()
        }
    }

    /// A piece of a chart, which is cut in two where it is not far enough.
    fn piece(&mut self, patch: &Patch) -> ControlFlow<()> {
        let (sweep, moved, known) = (self.sweep, self.moved, self.known());
        let (center, within) = self.ball;
        let kept = self.cutting.as_ref().and_then(|c| c.tile(patch));
        let tile = kept.unwrap_or_else(|| moved.sheet.tile(patch));
        let radius = tile.radius();
        let far = (tile.c - center).norm() - radius - within;
        if far >= 0.0 {
            self.keep((patch, &tile), self.enough.max(far), Plane::NONE);
            return Continue(());
        }
        let x = tile.c + tile.n * (moved.side * moved.shift);
        let piece = Piece { tile: &tile, x, within: radius + 2.0 * moved.shift.abs() };
        // Of what holds the place next to the tool no other direction shows as much.
        let clear = self.aim == Aim::Clear;
        let first = clear && self.beside.is_in(patch);
        if first && self.by_place(patch, &piece, known) {
            return Continue(());
        }
        let by_hint = if self.aim == Aim::Nearest { None } else { self.hint() };
        let by_hint = by_hint.map(|m| piece.shown(sweep, moved, m, known));
        let open = by_hint.as_ref().is_none_or(|shown| shown.low < known);
        if clear && open && !first && self.by_place(patch, &piece, known) {
            return Continue(());
        }
        let shown = match by_hint {
            Some(shown) if shown.low >= known => shown,
            Some(shown) if shown.halves_show(known, &tile, moved) => shown,
            _ => match self.by_level(&piece, by_hint, known) {
                (level, true) => level,
                (level, false) if moved.is_overlapped(patch, x, piece.strays(moved)) => {
                    self.keep((patch, &tile), self.enough.max(level.low), Plane::NONE);
                    return Continue(());
                }
                (level, false) => self.by_meeting(patch, &piece, level, known)?,
            },
        };
        // The way may be known to be longer by now.
        if shown.low >= self.known() {
            self.settle(patch, &piece, &shown);
            return Continue(());
        }
        self.halve(patch, &piece, &shown)
    }

    /// Is a piece told by the place of the surface next to the tool's corner? Then it needs no other look.
    fn by_place(&mut self, patch: &Patch, piece: &Piece<'_>, known: f64) -> bool {
        let (sweep, moved, enough) = (self.sweep, self.moved, self.enough);
        // The axis stands still where anything is told.
        let parts = |m: Vec3, level: Option<f64>| {
            let low = match level {
                Some(level) => level - moved.shift.abs(),
                None => m.dot(&piece.x) - slack(piece.tile, m, moved).all,
            };
            Plane::beyond(sweep, m, low)
        };
        match self.beside.see(moved.sheet, patch, piece.tile) {
            (Seen::Clear(low, about, level), m) if enough + low >= known => {
                if enough + low < self.closest {
                    (self.closest, self.towards) = (enough + low, Some(m));
                }
                // What holds the place is shown by it again.
                let stays = self.beside.is_in(patch);
                let plane = if stays { Plane::NONE } else { parts(about, level) };
                self.keep((patch, piece.tile), enough + low, plane);
            }
            // What lies beside it is shown by something else, where anything comes of this search.
            (Seen::Spanned { low, last, m }, _) if moved.shift <= 0.0 => {
                self.out.least = self.out.least.min(enough + low);
                self.hold((patch, piece.tile), enough + last, parts(m, None));
            }
            (Seen::Large(i), _) => {
                let [near, away] = patch.halves(i);
                if !(self.pile.push(away) && self.pile.push(near)) {
                    self.keep((patch, piece.tile), f64::NEG_INFINITY, Plane::NONE);
                }
            }
            _ => return false,
        }
        true
    }

    /// What the directions level to the piece show, and whether nothing else need be asked. Along the normal the piece has no
    /// extent: next to a place that is touched that direction shows most.
    fn by_level(&self, piece: &Piece<'_>, by_hint: Option<Shown>, known: f64) -> (Shown, bool) {
        let (sweep, moved) = (self.sweep, self.moved);
        let bound = |meeting| piece.shown(sweep, moved, meeting, known);
        let [first, square] = sweep.level(piece.tile.n * -moved.side, piece.x);
        let first = bound(first);
        let clear = self.aim != Aim::Nearest;
        // Where the first shows it the other need not be asked.
        let level = match clear && first.low >= known {
            true => first,
            false => Shown::better(first, bound(square)),
        };
        let level = by_hint.map_or(level, |shown| Shown::better(shown, level));
        let told = level.low >= known || level.halves_show(known, piece.tile, moved);
        (level, clear && told)
    }

    /// What is shown by where the middle of the piece meets the tool, which tells where the piece is best cut.
    fn by_meeting(
        &mut self,
        patch: &Patch,
        piece: &Piece<'_>,
        level: Shown,
        known: f64,
    ) -> ControlFlow<(), Shown> {
        let (sweep, moved) = (self.sweep, self.moved);
        let bound = |meeting| piece.shown(sweep, moved, meeting, known);
        let (meeting, within) = sweep.meet_within(piece.x);
        let nearer = self.out.nearest.is_none_or(|n| meeting.distance < n.0);
        let counts =
            || meeting.distance >= self.enough || !moved.is_overlapped(patch, piece.x, 0.0);
        if nearer && counts() {
            self.out.nearest = Some((meeting.distance, meeting.t, patch.spot()));
            if self.aim == Aim::Any && meeting.distance < self.enough {
                self.out.least = f64::NEG_INFINITY;
                return Break(());
            }
        }
        let met = bound(meeting);
        let mut best = Shown::better(level, met);
        if best.low < known
            && let Some(edge) = sweep.edge(piece.tile.n * -moved.side, piece.x, met.meeting.t)
        {
            best = edge.map(bound).into_iter().fold(best, Shown::better);
        }
        // What is lost of the two faces by whose edge it passes hangs on them alone.
        let met = match within.filter(|_| best.low < known) {
            Some(within) => {
                let slack = |m| slack(piece.tile, m, moved);
                let (low, slack, rise) = sweep.turning(&within, piece.x, piece.within, &slack);
                Shown { low, own: low, slack, rise, meeting }
            }
            None => met,
        };
        Continue(Shown { low: best.low.max(met.low), own: best.low, meeting: best.meeting, ..met })
    }

    /// A piece that is far enough.
    fn settle(&mut self, patch: &Patch, piece: &Piece<'_>, shown: &Shown) {
        let sweep = self.sweep;
        if shown.low < self.closest {
            (self.closest, self.hinted) = (shown.low, Some(sweep.kept(shown.meeting)));
            self.towards = None;
        }
        let plane = || {
            // What shows most at the end may show it for longer.
            let (distance, m) = sweep.tool.near(&sweep.b, piece.x);
            let at_end = distance - slack(piece.tile, m, self.moved).all;
            let plane = Plane::along(sweep, shown.meeting.m, shown.own);
            plane.or(Plane::at_end(sweep, m, at_end), sweep)
        };
        let plane = if self.cutting.is_some() { plane() } else { Plane::NONE };
        self.keep((patch, piece.tile), shown.low, plane);
    }

    /// A piece that is not, in two parts, where that helps.
    fn halve(&mut self, patch: &Patch, piece: &Piece<'_>, shown: &Shown) -> ControlFlow<()> {
        let Shown { low, meeting, slack: Slack { by, .. }, rise, .. } = *shown;
        if by[0] + by[1] <= rise {
            // Smaller pieces do not help, a shorter way does.
            self.out.least = self.out.least.min(low);
            self.out.turned = true;
            return Break(());
        }
        let folds = self.moved.only.is_none();
        if folds && piece.tile.radius() <= self.moved.fold * self.moved.shift.abs() {
            // What is left is the normal, which turns by as much however small the piece: the moved surface
            // has a fold or a tip here.
            self.keep((patch, piece.tile), low, Plane::NONE);
            self.left = self.left.min(MORE);
            return Continue(());
        }
        let i = usize::from(by[1] > by[0]);
        let [near, away] = patch.halves(i);
        // The half towards the tool is looked at first.
        let towards = piece.tile.side[i].dot(&meeting.m) < 0.0;
        let (first, second) = if towards { (away, near) } else { (near, away) };
        let tiny = by[i] <= f64::EPSILON * (piece.x.norm() + self.sweep.sphere().1);
        if tiny || !(self.pile.push(second) && self.pile.push(first)) {
            self.keep((patch, piece.tile), low, Plane::NONE);
        }
        Continue(())
    }

    /// Notes how far a piece is at least; a search that goes on from here looks at it again in time.
    fn keep(&mut self, piece: (&Patch, &Tile), low: f64, plane: Plane) {
        self.out.least = self.out.least.min(low);
        self.hold(piece, low, plane);
    }

    /// The same but for what this search tells.
    fn hold(&mut self, (piece, tile): (&Patch, &Tile), low: f64, plane: Plane) {
        if let Some(cutting) = &mut self.cutting {
            let piece = cutting.keep(piece, tile);
            cutting.clear(&piece, low, plane);
        }
    }
}

/// A piece as it is looked at: what holds it, its middle as it is moved, and a radius that holds it so.
struct Piece<'t> {
    tile: &'t Tile,
    x: Vec3,
    within: f64,
}

impl Piece<'_> {
    /// How far from its middle a piece of a TABCYL lies as it is moved, across the generatrix, along which all is as there.
    fn strays(&self, moved: &Moved<'_>) -> f64 {
        let Tile { side: [along, _], stray, turn: [u, v], .. } = self.tile;
        along.norm() + stray[0] + moved.shift.abs() * (u + v)
    }

    /// What the direction of a meeting shows.
    fn shown(&self, sweep: &Sweep<'_>, moved: &Moved<'_>, meeting: Meeting, known: f64) -> Shown {
        let slack = |m| slack(self.tile, m, moved);
        let (low, slack, rise) = sweep.proved(&meeting, self.x, self.within, known, slack);
        Shown { low, own: low, meeting, slack, rise }
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

/// By how much the distance may be less on the piece than in its middle.
///
/// A normal that turns goes down along itself, by half the square of the turn: what is moved towards the tool goes away from it.
#[inline]
fn slack(tile: &Tile, m: Vec3, moved: &Moved<'_>) -> Slack {
    let shift = moved.side * moved.shift;
    let along = m.dot(&tile.n);
    let across = (m - tile.n * along).norm();
    let whole = tile.turn[0] + tile.turn[1];
    let (round, down) = (shift.abs() * across, (0.5 * shift * along).max(0.0));
    let turned = two(tile.turn, |t| t * (round + whole * down));
    let by = two([0, 1], |i| m.dot(&tile.side[i]).abs() + tile.stray[i] + turned[i]);
    Slack { by, all: tile.dip(m) + turned[0] + turned[1] }
}
