//! A cut vector: along guides or by contacts, with a look whether the cutter cuts in elsewhere on its way.

use aptc_contact::{Gap, Guide};
use aptc_geometry::Vec3;

use super::contacts::Contacts;
use super::guided::{Guided, Guides, Place};
use super::keep::Keep;
use super::pace::Pace;
use super::track::{Node, Track, Trouble};

/// Cut vectors of which every trial looks for other places of contact once one was found.
const CAREFUL: u32 = 6;
/// How often a cut vector is made shorter as the cutter cuts in on its way.
const CUT_SHORT: u32 = 12;

/// A cut vector.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stride<To = Node> {
    /// Length along the track.
    pub(crate) length: f64,
    pub(crate) to: To,
    /// Gaps at its end, from which the next one continues.
    pub(crate) targets: [f64; 2],
}

impl Stride {
    /// The way of the tool end at most, about: where the track ends to bend on it the tool moves by more than the length.
    pub(crate) fn most(&self, from: &Node) -> f64 {
        self.length.max((self.to.pose.te - from.pose.te).norm())
    }
}

impl Track {
    /// The longest cut vector from a node, no longer than `cap`.
    ///
    /// The contacts are followed from vector to vector. Whether the cutter touches deeper elsewhere is asked
    /// when it may be so; once it is, and where nothing is found, every trial of some cut vectors asks.
    pub(crate) fn stride(&self, from: &Node, cap: f64, pace: &mut Pace) -> Result<Stride, Trouble> {
        let mut cap = cap;
        for _ in 0..CUT_SHORT {
            let before = *pace;
            let (stride, room) = self.stride_to(from, cap, pace)?;
            let missed = self.overlooked(from, &stride, room);
            let Some(s) = missed.or_else(|| self.overleapt(from, &stride)) else {
                return Ok(stride);
            };
            (*pace, cap) = (before, s);
        }
        Err(Trouble::Contact)
    }

    /// The same, of which nobody has looked on the way, and the way from its start for which nothing else could touch.
    fn stride_to(&self, from: &Node, cap: f64, pace: &mut Pace) -> Result<(Stride, f64), Trouble> {
        let looked = std::mem::take(&mut pace.looked);
        let (mut free, left) = (pace.room, pace.left);
        if pace.careful == 0 {
            let guided = self.guided(from, cap, pace);
            if let Some(stride) = guided
                && !self.several()
            {
                return Ok((stride, free));
            }
            let stride = match guided {
                Some(stride) => Ok(stride),
                None => self.by_contacts(from, cap, pace, false),
            };
            if let Ok(stride) = stride {
                let turn = (stride.to.pose.ta - from.pose.ta).norm();
                let reach = self.keeps[0].profile.reach().max(self.keeps[1].profile.reach());
                pace.room -= stride.most(from) + turn * reach;
                if pace.room > 0.0 {
                    return Ok((stride, free));
                }
                let none = |deeper: &[Option<Gap>; 2]| deeper.iter().all(Option::is_none);
                // One look from its start is worth those on the way and at its end.
                if !looked && !self.axis.turns() {
                    let (deeper, room) = self.deeper(&from.pose, &from.gaps, pace.farthest());
                    pace.saw(room);
                    if none(&deeper) {
                        free = free.max(room);
                    }
                    if free > stride.most(from) {
                        pace.room = free - stride.most(from);
                        return Ok((stride, free));
                    }
                }
                let (deeper, room) = self.deeper(&stride.to.pose, &stride.to.gaps, pace.farthest());
                pace.saw(room);
                if none(&deeper) {
                    (pace.room, pace.looked) = (room, true);
                    return Ok((stride, free));
                }
            }
            pace.careful = CAREFUL;
        }
        pace.careful -= 1;
        (pace.room, pace.left) = (0.0, left);
        Ok((self.by_contacts(from, cap, pace, true)?, free))
    }

    /// The same by contacts. Chords on which the contact goes over to another place are looked at as a whole once one is found;
    /// only where that does not fit each trial is.
    fn by_contacts(
        &self,
        from: &Node,
        cap: f64,
        pace: &mut Pace,
        look: bool,
    ) -> Result<Stride, Trouble> {
        let trials = |between| Contacts { track: self, from, look, between };
        if self.axis.turns() || !self.keeps.iter().any(Keep::is_mixed) {
            return self.longest(&trials(true), cap, pace);
        }
        let before = *pace;
        let found = self.longest(&trials(false), cap, pace);
        let over = |to: &Node| {
            let way = (to.pose.te - from.pose.te).norm();
            let over = |i: usize| self.keeps[i].is_mixed() && self.apart(i, from, to);
            (0..2).any(|i| over(i) && !self.keeps[i].touches_once(&from.pose, &from.gaps[i], way))
        };
        if let Ok(stride) = found
            && (!over(&stride.to) || self.fits(from, &stride.to))
        {
            return Ok(stride);
        }
        *pace = before;
        self.longest(&trials(true), cap, pace)
    }

    /// May guides miss a place of contact that becomes the deepest?
    fn several(&self) -> bool {
        self.guides.as_ref().is_some_and(Guides::several)
    }

    /// The same along guides; `None` where these do not tell.
    fn guided(&self, from: &Node, cap: f64, pace: &mut Pace) -> Option<Stride> {
        match self.guides.as_ref()? {
            Guides::Closed(guides) => self.guided_by(guides, from, cap, pace),
            Guides::Point(guides) => self.guided_by(guides, from, cap, pace),
        }
    }

    fn guided_by<G: Guide>(
        &self,
        guides: &[G; 2],
        from: &Node,
        cap: f64,
        pace: &mut Pace,
    ) -> Option<Stride> {
        let place = Place::of::<G>(from);
        let guided = Guided::new(self, guides, &place);
        let Stride { length, to, targets } = self.longest(&guided, cap, pace).ok()?;
        Some(Stride { length, to: guided.node(from.pose.ta, &to), targets })
    }

    /// Goes on along guides, without a look at anything else, for less than `free`; `take` gets both ends of each cut vector
    /// and the direction at the second, and says whether it goes on so. The node where that ends; `None` at the start.
    pub(crate) fn cruise(
        &self,
        from: &Node,
        cap: f64,
        pace: &mut Pace,
        free: f64,
        take: impl FnMut([Vec3; 2], Vec3) -> bool,
    ) -> Option<Node> {
        // Where looks tell less than a cut vector is long each goes by itself.
        let few = self.several() && !pace.worth(pace.length);
        if pace.careful > 0 || few || free <= pace.length {
            return None;
        }
        match self.guides.as_ref()? {
            Guides::Closed(guides) => self.cruise_by(guides, from, cap, pace, free, take),
            Guides::Point(guides) => self.cruise_by(guides, from, cap, pace, free, take),
        }
    }

    fn cruise_by<G: Guide>(
        &self,
        guides: &[G; 2],
        from: &Node,
        cap: f64,
        pace: &mut Pace,
        mut free: f64,
        mut take: impl FnMut([Vec3; 2], Vec3) -> bool,
    ) -> Option<Node> {
        let (several, ta) = (self.several(), from.pose.ta);
        let mut at = Place::of::<G>(from);
        let (mut next, mut gone) = (at, false);
        loop {
            let guided = Guided::new(self, guides, &at);
            let before = *pace;
            let length = guided.at_once(cap, pace, &mut next).or_else(|| {
                let found = self.longest(&guided, cap, pace).ok()?;
                next = found.to;
                Some(found.length)
            });
            let way = length.map(|length| length.max((next.te - at.te).norm()));
            let may = |way: &f64, pace: &mut Pace| {
                let seen = !several || *way < pace.room;
                *way < free && (seen || self.sees(&guided.node(ta, &at), *way, pace))
            };
            match way.filter(|way| may(way, pace)) {
                Some(way) if take([at.te, next.te], next.course.along) => {
                    free -= way;
                    (pace.room, pace.looked) = (pace.room - way, false);
                    (at, gone) = (next, true);
                }
                _ => {
                    // What a look told from there need not be asked again.
                    *pace = before.told(pace);
                    pace.found = length;
                    return gone.then(|| guided.node(ta, &at));
                }
            }
        }
    }

    /// Is no other place of contact seen from a node that could become the deepest on a way? What is told is the room.
    fn sees(&self, from: &Node, way: f64, pace: &mut Pace) -> bool {
        if pace.looked || !pace.worth(way) {
            return false;
        }
        let (deeper, room) = self.deeper(&from.pose, &from.gaps, pace.farthest());
        pace.saw(room);
        if deeper.iter().any(Option::is_some) {
            return false;
        }
        (pace.room, pace.looked) = (room, true);
        way < room
    }
}
