//! GCLEAR: how the tool comes to a line of GOLOFT and leaves it.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_contact::PatchTree;
use aptc_geometry::{Form, Sculptured, Surface, Vec3};
use aptc_protap::Arg;

use crate::failure::Failure;
use crate::project::{Ends, Probe, Shot};
use crate::regional::Regional;
use crate::scon::Words;

/// A tool with the normal of the surface that it touches.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spot {
    pub(crate) te: Vec3,
    pub(crate) ta: Vec3,
    pub(crate) normal: Vec3,
}

/// START, AWAY, BACK, THRU.
#[derive(Clone, Debug, Default)]
pub(crate) struct Clears {
    at: [Clear; 4],
    /// Did it shape a line since it was given?
    pub(crate) used: bool,
}

/// The extra motion at one of them.
#[derive(Clone, Debug, Default)]
struct Clear {
    on: bool,
    /// MOTDIR: before the first point or behind the last, along the motion.
    along: f64,
    /// NORMAL: off the surface.
    normal: f64,
    /// PARLEL.
    by: Option<Vec3>,
    /// FEED of the extra motion.
    feed: Option<f64>,
    /// CLEARS: from there along the tool axis to this surface.
    to: Option<Target>,
}

#[derive(Clone, Debug)]
enum Target {
    Plain(Box<Surface>),
    Sculptured(Arc<Sculptured>, Arc<PatchTree>),
}

/// Tool ends and axes that are put out as one motion.
#[derive(Clone, Debug)]
pub(crate) struct Leg {
    pub(crate) points: Vec<(Vec3, Vec3)>,
    pub(crate) feed: Feed,
    /// Does it belong to GCLEAR?
    pub(crate) extra: bool,
    /// Does the way to its first point lead over what REGION leaves out, from one stretch of the line to the next?
    pub(crate) over: bool,
}

/// What happens to the feed before a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Feed {
    Keep,
    Set(f64),
    /// That of the program again.
    Again,
}

impl Feed {
    /// The arguments of FEDRAT; none where there is nothing to say.
    pub(crate) fn args(self, before: &[cl::Arg]) -> Option<Vec<cl::Arg>> {
        match self {
            Self::Keep => None,
            Self::Set(f) => Some(vec![cl::Arg::Number(f)]),
            Self::Again => (!before.is_empty()).then(|| before.to_vec()),
        }
    }
}

const START: usize = 0;
const AWAY: usize = 1;
const BACK: usize = 2;
const THRU: usize = 3;

impl Clears {
    /// Is any of it on that shaped no line since it was given?
    pub(crate) fn is_idle(&self) -> bool {
        !self.used && self.at.iter().any(|c| c.on)
    }
}

impl Regional {
    /// GCLEAR/[START|AWAY|BACK|THRU,]ON|OFF and what follows. Without a place it is meant for all four; what
    /// is given of the motion switches it on.
    ///
    /// APT: `GCLEAR`.
    pub(crate) fn gclear(&mut self, args: &[Arg]) -> Result<(), Failure> {
        let mut w = Words(args);
        self.clears.used = false;
        let places: &[usize] =
            match [("START", START), ("AWAY", AWAY), ("BACK", BACK), ("THRU", THRU)]
                .into_iter()
                .find(|(word, _)| w.take(word))
            {
                Some((_, START)) => &[START],
                Some((_, AWAY)) => &[AWAY],
                Some((_, BACK)) => &[BACK],
                Some(_) => &[THRU],
                None => &[START, AWAY, BACK, THRU],
            };
        if w.take("OFF") {
            for k in places {
                self.clears.at[*k].on = false;
            }
            return Ok(());
        }
        w.take("ON");
        let mut wanted = self.clears.at[places[0]].clone();
        wanted.on = true;
        while let Some(word) = w.word() {
            match word {
                "MOTDIR" => wanted.along = w.number().unwrap_or(0.0),
                "NORMAL" => wanted.normal = w.number().unwrap_or(0.0),
                "PARLEL" => wanted.by = w.vector(),
                "FEED" => wanted.feed = w.number(),
                "CLEARS" => {
                    let Some((name, form)) = w.form() else { continue };
                    wanted.to = Some(match form.shape() {
                        Form::Ssurf(_) => {
                            let s = self.surface(name, form)?;
                            let tree = self.tree(&s);
                            Target::Sculptured(s, tree)
                        }
                        _ => Target::Plain(Box::new(Surface::from_form(form).ok_or(
                            Failure::Undone { what: "a surface of CLEARS of this kind" },
                        )?)),
                    });
                }
                _ => {}
            }
        }
        for k in places {
            self.clears.at[*k] = wanted.clone();
        }
        Ok(())
    }
}

impl Clears {
    /// The motions of a line in several stretches, with those that lead to them and away.
    pub(crate) fn around(&self, stretches: &[Vec<Spot>]) -> Result<Vec<Leg>, Failure> {
        let stretches: Vec<_> = stretches.iter().filter(|s| !s.is_empty()).collect();
        let mut legs = Vec::new();
        let mut again = false;
        for (i, stretch) in stretches.iter().enumerate() {
            let (first, last) = (stretch[0], stretch[stretch.len() - 1]);
            let way =
                |a: &Spot, b: &Spot| (b.te - a.te).try_normalize(0.0).unwrap_or_else(Vec3::zeros);
            let (out, home) = match stretch.as_slice() {
                [a, b, ..] => (way(a, b), way(&stretch[stretch.len() - 2], &last)),
                _ => (Vec3::zeros(), Vec3::zeros()),
            };
            let to = &self.at[if i == 0 { START } else { BACK }];
            let mut over = i > 0;
            if let Some(mut points) = to.beside(&first, -out)? {
                points.reverse();
                legs.push(Leg { points, feed: to.feed(again), extra: true, over });
                over = false;
                again = to.feed.is_some();
            }
            let feed = if again { Feed::Again } else { Feed::Keep };
            let points = stretch.iter().map(|s| (s.te, s.ta)).collect();
            legs.push(Leg { points, feed, extra: false, over });
            again = false;
            let from = &self.at[if i + 1 == stretches.len() { THRU } else { AWAY }];
            if let Some(points) = from.beside(&last, home)? {
                legs.push(Leg { points, feed: from.feed(false), extra: true, over: false });
                again = from.feed.is_some();
            }
        }
        if again {
            // The program's feed comes back behind the last extra motion.
            legs.push(Leg { points: Vec::new(), feed: Feed::Again, extra: true, over: false });
        }
        Ok(legs)
    }
}

impl Clear {
    fn feed(&self, again: bool) -> Feed {
        match self.feed {
            Some(f) => Feed::Set(f),
            None if again => Feed::Again,
            None => Feed::Keep,
        }
    }

    /// The points beside an end of a stretch, going away from it; `outward` is the unit direction of the
    /// motion beyond it.
    fn beside(&self, s: &Spot, outward: Vec3) -> Result<Option<Vec<(Vec3, Vec3)>>, Failure> {
        if !self.on {
            return Ok(None);
        }
        let by = self.by.unwrap_or_else(Vec3::zeros);
        let near = s.te + outward * self.along + s.normal * self.normal + by;
        let mut points = Vec::new();
        if near != s.te {
            points.push((near, s.ta));
        }
        if let Some(target) = &self.to {
            let up = target.along(near, s.ta).ok_or(Failure::NoClearance { te: near })?;
            points.push((near + s.ta * up, s.ta));
        }
        Ok((!points.is_empty()).then_some(points))
    }
}

impl Target {
    /// How far along `ta` it is met.
    fn along(&self, from: Vec3, ta: Vec3) -> Option<f64> {
        let ahead = |t: &f64| *t >= 0.0;
        match self {
            Self::Plain(s) => {
                s.ray(from, ta).ok()?.into_iter().filter(ahead).min_by(f64::total_cmp)
            }
            Self::Sculptured(s, tree) => [1.0, -1.0]
                .into_iter()
                .filter_map(|side| {
                    let (surface, extent, ends) = (&**s, s.extent(), Ends::of(s));
                    let probe = Probe::Ball(0.0);
                    Shot { surface, extent, ends, side, from, along: ta, probe }.first(tree)
                })
                .map(|m| m.way)
                .filter(ahead)
                .min_by(f64::total_cmp),
        }
    }
}

/// An argument of a post-processor word; forms have no place in FEDRAT.
pub(crate) fn post_arg(a: &Arg) -> Option<cl::Arg> {
    match a {
        Arg::Number(x) => Some(cl::Arg::Number(*x)),
        Arg::Word(w) => Some(cl::Arg::Word(w.clone())),
        Arg::Text(t) => Some(cl::Arg::Text(t.clone())),
        Arg::Form { .. } => None,
    }
}
