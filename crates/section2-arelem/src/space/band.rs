//! The band of a surface as chords and their ends use it: what does not change along a motion is worked out once.

use super::keep::{Keep, Limits, target};

/// Share of the band by which a chord aims inside of it.
const AIM: f64 = 1e-6;
/// The same, and that by which vertices keep from the edge, where the axis turns: the gaps go by more than cubics then, and
/// are looked at in places. It makes a path longer by half of it.
pub(crate) const AIM_TURNING: f64 = 1e-3;
/// Extreme gaps on a chord are found to this share of the band.
const RESOLUTION: f64 = 2e-7;
/// The same on a chord along which the axis turns.
const RESOLUTION_TURNING: f64 = 0.01 * AIM_TURNING;
/// By this share of it they may be beyond those at its ends, which may lie at the edge of the band: what looks are unsure of.
const OWN_TURNING: f64 = 0.3 * RESOLUTION_TURNING;
/// Share of the band that is no room for a chord.
const NO_ROOM: f64 = 1e-8;
/// By how much more than it needs a chord is given, for a bend that changes along it.
const SPARE: f64 = 1.1;
/// Share of the band that is used below which a gap does not bend.
const EVEN: f64 = 1e-9;

/// The band of one surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Band {
    pub(super) width: f64,
    low: f64,
    high: f64,
    /// Where a vertex may lie at least and at most.
    vertex: [f64; 2],
    /// Where it lies when the gap does not bend.
    level: f64,
    /// By what share of the band chords aim inside of it, and by how much.
    pub(super) share: f64,
    aim: f64,
    /// To what extreme gaps on a chord are found.
    pub(super) resolution: f64,
    /// By how much gaps are beyond those at the ends, and inside of the edge, for a chord that fits.
    own: f64,
    inside: f64,
    /// Room that is none, and what rounding makes of gaps.
    none: f64,
    rounding: f64,
    /// By how much vertices keep from the edge when the axis turns.
    turning: Option<f64>,
}

impl Band {
    /// That of a surface in a scene of this `size`, with an axis that may turn.
    pub(super) fn new(keep: &Keep, size: f64, turns: bool) -> Self {
        let Limits { low, high } = keep.limits();
        let width = keep.width();
        let rounding = 1e-14 * size;
        let slack = |share: f64| rounding + share * width;
        let (resolution, found, own) = match turns {
            true => (RESOLUTION_TURNING, 2.0 * RESOLUTION_TURNING, OWN_TURNING),
            false => (RESOLUTION, RESOLUTION, RESOLUTION),
        };
        let share = if turns { AIM_TURNING } else { keep.searched().unwrap_or(AIM) };
        Self {
            width,
            low,
            high,
            vertex: keep.vertices(),
            level: keep.level(),
            share,
            aim: share * width,
            resolution: resolution * width,
            own: slack(own),
            inside: slack(found),
            none: slack(NO_ROOM),
            rounding,
            turning: (turns && !keep.is_on()).then_some(AIM_TURNING * width),
        }
    }

    /// Gap of the next vertex when cut vectors are about `usual` long and the gap bends so along them: in the share of the band
    /// that the chords use, and farther out where the vertex `before` left less room for the chord between both.
    #[inline(always)]
    pub(super) fn vertex(&self, before: f64, bend: f64, usual: f64) -> f64 {
        let at = self.even_vertex(before, bend, usual);
        match self.turning {
            Some(room) => least(most(at, self.low + room), self.high - room),
            None => at,
        }
    }

    #[inline(always)]
    fn even_vertex(&self, before: f64, bend: f64, usual: f64) -> f64 {
        let bow = bend.abs() * usual * usual;
        let share = least(bow / (8.0 * self.width), 1.0);
        if share < EVEN {
            return self.level;
        }
        let (even, edge) = (target(self.vertex, bend, share), target(self.vertex, bend, 1.0));
        let room = if bend > 0.0 { before - self.low } else { self.high - before };
        let (needed, room) = (0.5 * bow, most(room, 0.0));
        let lack = if needed > room { needed.sqrt() - room.sqrt() } else { 0.0 };
        let rest = SPARE * lack * lack;
        if bend > 0.0 {
            least(most(even, self.low + rest), edge)
        } else {
            most(least(even, self.high - rest), edge)
        }
    }

    /// Does a chord stay in the band, and how much longer could it be? `ends` are the gaps at its ends, then come the least and
    /// the greatest on it; `bow` is by how much the rate of change grows.
    #[inline(always)]
    pub(super) fn judge(&self, ends: [f64; 2], [low, high]: [f64; 2], bow: f64) -> (bool, f64) {
        // A chord bows by rounding alone where the gap does not bend, and has room for it at the very edge too.
        let depth = if bow.abs() > 2.0 * self.none { 0.5 * bow } else { 0.0 };
        let [under, over] = [least(ends[0], ends[1]), most(ends[0], ends[1])];
        let [dip, rise] = [most(under - low, 0.0), most(high - over, 0.0)];
        // Vertices of the motion before may lie at the very edge; they are no fault of this chord. What looks are unsure of
        // reaches to the edge, and beyond it only from an end that lies there.
        let own = |room: f64| least(self.own, most(room, self.rounding));
        let lowest = least(under - own(under - self.low), self.low + self.inside);
        let highest = most(over + own(self.high - over), self.high - self.inside);
        let fits = low >= lowest && high <= highest;
        // The ratio goes by the root of the room, which is not to be that of rounding: a vertex at the edge of what the chord
        // aims at leaves none.
        let room = |d: f64| if d > self.none { d } else { 0.0 };
        let mut ratio = f64::INFINITY;
        if depth > 0.0 || dip > self.aim {
            let above = |g: f64| room(g - self.low - self.aim);
            let e = [above(ends[0]), above(ends[1])];
            ratio = least(ratio, grow(e, [dip, most(over - low, 0.0)], depth, self.inside));
        }
        if depth < 0.0 || rise > self.aim {
            let below = |g: f64| room(self.high - self.aim - g);
            let f = [below(ends[0]), below(ends[1])];
            ratio = least(ratio, grow(f, [rise, most(high - under, 0.0)], -depth, self.inside));
        }
        (fits, ratio)
    }
}

/// Ratio of the longest chord to this one: `room` between the ends and the limit, the least and the greatest way between the
/// ends and the extreme place, `depth` of the parabola where the chord has no inner extreme. One that is beyond an end by no
/// more than looks are `unsure` of is that end: its root would be that of rounding, and along a straight chord mean nothing.
#[inline(always)]
fn grow(room: [f64; 2], [near, far]: [f64; 2], depth: f64, unsure: f64) -> f64 {
    let allowed = room[0].sqrt() + room[1].sqrt();
    let used = if near > unsure {
        near.sqrt() + far.sqrt()
    } else if near > 0.0 {
        least(most(depth, 0.0), far).sqrt()
    } else {
        most(depth, 0.0).sqrt()
    };
    if used > 0.0 { allowed / used } else { f64::INFINITY }
}

/// The greater of two numbers: one instruction, where [`f64::max`] looks for NaN.
#[inline(always)]
fn most(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The less of two numbers.
#[inline(always)]
fn least(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_contact::{Condition, Side};
    use aptc_geometry::{Cutter, Profile, Sphere, Surface, Vec3};

    #[test]
    fn a_chord_that_bows_by_rounding_alone_may_be_as_long_as_one_that_does_not() {
        let keep = Keep {
            profile: Profile::new(&Cutter::mill(10.0, 0.0, 40.0)).unwrap(),
            surface: Surface::Sphere(Sphere { center: Vec3::zeros(), radius: 50.0 }),
            condition: Condition::Touch,
            side: Side::Positive,
            thick: 0.0,
            intol: 0.01,
            outtol: 0.01,
            outside: false,
        };
        let band = Band::new(&keep, 100.0, false);
        for g in [band.low, band.low + band.aim, 0.0, band.high - band.aim, band.high] {
            for bow in [0.0, 1e-44, -1e-44, 1e-13, -1e-13] {
                let (fits, ratio) = band.judge([g; 2], [g; 2], bow);
                assert!(fits && ratio.is_infinite(), "{g} {bow}: {ratio}");
            }
        }
        // From the middle of the band a parabola of a quarter of its depth may be four times as deep.
        let (fits, ratio) = band.judge([0.0; 2], [-0.0025, 0.0], 0.02);
        assert!(fits && (ratio - 2.0).abs() < 1e-5, "{ratio}");
    }
}
