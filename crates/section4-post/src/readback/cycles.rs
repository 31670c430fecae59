//! Drilling cycles of RS-274, as the single motions that they stand for.

use super::control::{Control, Place, Step};
use super::words::Line;

/// Words that stay from one hole to the next.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sticky {
    z: Option<f64>,
    r: Option<f64>,
    q: Option<f64>,
    /// Height from which the first hole was reached.
    initial: Option<f64>,
}

/// What is left of a hole is none when it is less than any control can be told, millimetres.
pub(super) const NOTHING_LEFT: f64 = 1e-6;

/// How far above the last depth a peck comes back, millimetres.
const BACK: f64 = 0.254;

/// Most pecks of one hole.
pub(super) const MOST_PECKS: usize = 100_000;

/// What a cycle does at the bottom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    /// Feed down, rapid out.
    Drill,
    /// Feed down, feed out.
    FeedOut,
    /// In pecks, out of the hole after each or not.
    Pecks { first: f64, step: f64, out: bool },
}

impl Control {
    pub(super) fn drill(
        &mut self,
        code: i32,
        line: &Line,
        target: &Place,
        steps: &mut Vec<Step>,
    ) -> Result<(), String> {
        if !self.along_z() {
            return Err("a cycle in another plane than XY".into());
        }
        let mm = self.unit();
        self.cycle.z = target[2].or(self.cycle.z);
        self.cycle.r = line.value(b'R').map(|r| r * mm).or(self.cycle.r);
        self.cycle.q = line.value(b'Q').map(|q| q * mm).or(self.cycle.q);
        let feed = self.needed_feed()?;
        let (Some(bottom), Some(clear)) = (self.cycle.z, self.cycle.r) else {
            return Err("a cycle without Z or R".into());
        };
        if clear < bottom {
            return Err("a cycle whose R lies below its Z".into());
        }
        let Some(now) = self.at[2] else {
            return Err("a cycle from a height that is not known".into());
        };
        let initial = *self.cycle.initial.get_or_insert(now);
        if now < clear - 1e-6 {
            // Some controls go up first and others across first.
            return Err("a cycle that begins below its R".into());
        }
        let mut over = *target;
        over[2] = Some(now);
        self.step(&over, true, feed, steps);
        let end = if self.to_initial { initial.max(clear) } else { clear };
        let kind = match code {
            81 | 82 | 86 => Kind::Drill,
            84 | 74 | 85 | 89 => Kind::FeedOut,
            73 | 83 => {
                let step = self.cycle.q.filter(|q| *q > 0.0).ok_or("pecks without Q")?;
                Kind::Pecks { first: step, step, out: code == 83 }
            }
            _ => return Err(format!("the cycle G{code}")),
        };
        self.down_and_up(kind, [clear, bottom, end], feed, steps)
    }

    /// A hole below the present place: from the clearance to the bottom and up to the end.
    pub(super) fn down_and_up(
        &mut self,
        kind: Kind,
        [clear, bottom, end]: [f64; 3],
        feed: f64,
        steps: &mut Vec<Step>,
    ) -> Result<(), String> {
        let z = |h: f64| [None, None, Some(h), None, None];
        self.step(&z(clear), true, feed, steps);
        match kind {
            Kind::Drill => self.step(&z(bottom), false, feed, steps),
            Kind::FeedOut => {
                self.step(&z(bottom), false, feed, steps);
                self.step(&z(clear), false, feed, steps);
            }
            Kind::Pecks { first, step, out } => {
                let mut depth = clear;
                for n in 0.. {
                    if n > MOST_PECKS {
                        return Err("too many pecks".into());
                    }
                    if n > 0 {
                        let back = (depth + BACK).min(clear);
                        if out {
                            self.step(&z(clear), true, feed, steps);
                        }
                        self.step(&z(back), true, feed, steps);
                    }
                    depth -= if n == 0 { first } else { step };
                    if depth <= bottom + NOTHING_LEFT {
                        depth = bottom;
                    }
                    self.step(&z(depth), false, feed, steps);
                    if depth <= bottom {
                        break;
                    }
                }
            }
        }
        self.step(&z(end), true, feed, steps);
        Ok(())
    }

    fn step(&mut self, target: &Place, rapid: bool, feed: f64, steps: &mut Vec<Step>) {
        let from = self.at;
        let to = self.merged(target);
        if from == to {
            return;
        }
        self.at = to;
        steps.push(Step::Line { from, to, rapid, feed: (!rapid).then_some(feed) });
    }
}
