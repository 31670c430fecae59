//! What one cut vector tells the next: how long it was for what was foretold, and how its gaps bent.

/// Greatest change of the ratio of two cut vectors that is expected to go on.
const EVEN: f64 = 0.02;
/// The same of their bends, as a share of these.
const EVEN_BENDS: f64 = 0.5;

/// Times as far as the last look told that the next one asks for, and looks of which one asks for any way.
const FARTHER: f64 = 2.4;
const ANEW: u32 = 8;

/// What one cut vector tells the next.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pace {
    /// The longest length over the foretold one, and by how much more it was than that of the cut vector before.
    pub(super) ratio: Option<f64>,
    pub(super) trend: f64,
    /// By how much more that was than the time before.
    pub(super) growth: f64,
    /// The length of the last one.
    pub(super) length: f64,
    /// How far from its end there are places at most, where one farther on was not found.
    pub(super) left: Option<f64>,
    /// The length of the next one, where it was found and not yet looked at as a whole.
    pub(super) found: Option<f64>,
    /// Way for which no other place of contact can become the deepest, and whether that was looked for where it is now.
    pub(super) room: f64,
    pub(super) looked: bool,
    /// The way that the last look told, and how many there were.
    seen: f64,
    looks: u32,
    /// Cut vectors yet of which every trial looks for other places of contact.
    pub(super) careful: u32,
    /// How the gaps bend along the last cut vector when the axis turns, which the curvatures do not tell, and by how much
    /// more than along the one before.
    pub(super) bends: Option<[f64; 2]>,
    pub(super) grown: [f64; 2],
}

impl Pace {
    pub(crate) fn new() -> Self {
        Self {
            ratio: None,
            trend: 0.0,
            growth: 0.0,
            length: 0.0,
            left: None,
            found: None,
            room: 0.0,
            looked: false,
            seen: f64::INFINITY,
            looks: 0,
            careful: 0,
            bends: None,
            grown: [0.0; 2],
        }
    }

    /// The longest way that the next look for other places of contact asks for: now and then any.
    pub(super) fn farthest(&self) -> f64 {
        if self.looks.is_multiple_of(ANEW) { f64::INFINITY } else { FARTHER * self.seen }
    }

    /// Did the last look tell more than a way as this?
    pub(super) fn worth(&self, way: f64) -> bool {
        way < self.room || way < self.seen
    }

    /// The same where another one, from there on, was told by a look.
    pub(super) fn told(self, other: &Self) -> Self {
        if !other.looked {
            return self;
        }
        let Self { room, looked, seen, looks, .. } = *other;
        Self { room, looked, seen, looks, ..self }
    }

    /// A look told this way.
    pub(super) fn saw(&mut self, way: f64) {
        (self.seen, self.looks) = (way, self.looks + 1);
    }

    /// The ratio that is to be expected next: the curvature that changes it does so evenly for a while. With an axis that `turns`
    /// ratios scatter, and how the change grows says nothing.
    pub(super) fn expected(&self, turns: bool) -> f64 {
        self.ratio.unwrap_or(1.0) + self.trend + if turns { 0.0 } else { self.growth }
    }

    /// How the gaps of the next one are expected to bend.
    pub(super) fn expected_bends(&self) -> Option<[f64; 2]> {
        self.bends.map(|b| [b[0] + self.grown[0], b[1] + self.grown[1]])
    }

    /// The gaps bend so along a cut vector.
    pub(super) fn learn_bends(&mut self, bends: [f64; 2]) {
        let last = self.bends.unwrap_or(bends);
        self.grown = [0, 1].map(|i| {
            let grown = bends[i] - last[i];
            // What jumps does not go on so.
            if grown.abs() <= EVEN_BENDS * last[i].abs() { grown } else { 0.0 }
        });
        self.bends = Some(bends);
    }

    /// A cut vector was this long where `plan` was foretold, and could be longer by the ratio `rest`.
    #[inline]
    pub(super) fn learn(&mut self, length: f64, rest: f64, plan: f64) {
        (self.length, self.left) = (length, None);
        let ratio = (length * rest / plan).clamp(0.2, 2.0);
        let trend = self.ratio.map_or(0.0, |last| ratio - last);
        let trend = if trend.abs() <= EVEN { trend } else { 0.0 };
        let growth = trend - self.trend;
        self.growth = if growth.abs() <= EVEN * EVEN { growth } else { 0.0 };
        self.trend = trend;
        self.ratio = Some(ratio);
    }
}
