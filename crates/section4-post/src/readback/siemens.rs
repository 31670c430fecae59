//! Keywords of Siemens 840D: frames, transformations and modal cycles.

use super::control::{Control, Frame, Step};
use super::cycles::Kind;
use super::words::Keyword;
use crate::angles::about;

/// A cycle that each position calls: heights in millimetres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Called {
    kind: Kind,
    clear: f64,
    bottom: f64,
    end: f64,
}

/// The tilted plane of CYCLE800 in its mode 57: about X, the new Y and the new Z. Without angles there is none.
pub(super) fn swivelled(k: &Keyword) -> Option<Frame> {
    let angle = |i: usize| k.args.get(i).copied().flatten();
    angle(7)?;
    let [a, b, c] = [7, 8, 9].map(|i| angle(i).unwrap_or(0.0));
    Some(Frame::Plane(about(0, a) * about(1, b) * about(2, c)))
}

impl Control {
    /// Obeys a keyword; true when the block is in the frame of the machine.
    pub(super) fn keyword(&mut self, k: &Keyword) -> Result<bool, String> {
        match k.name.as_str() {
            "SUPA" => return Ok(true),
            "CYCLE800" | "TRAORI" | "TRAFOOF" | "CYCLE832" | "MSG" | "STOPRE" | "FFWON"
            | "SOFT" | "WORKPIECE" | "SPOS" => {}
            "MCALL" => self.called = None,
            name if name.starts_with("CYCLE") => self.called = Some(self.cycle_of(k)?),
            name => return Err(format!("the word {name} is not known")),
        }
        Ok(false)
    }

    fn cycle_of(&self, k: &Keyword) -> Result<Called, String> {
        let mm = self.unit();
        let arg = |i: usize| k.args.get(i).copied().flatten();
        let length = |i: usize, what: &str| {
            arg(i).map(|v| v * mm).ok_or_else(|| format!("{} without {what}", k.name))
        };
        let (retract, surface, safety) = (length(0, "RTP")?, length(1, "RFP")?, length(2, "SDIS")?);
        let bottom = match (arg(3), arg(4)) {
            (Some(dp), _) => dp * mm,
            (None, Some(dpr)) => surface - dpr * mm,
            _ => return Err(format!("{} without a depth", k.name)),
        };
        let clear = surface + safety;
        let kind = match k.name.as_str() {
            "CYCLE81" | "CYCLE82" | "CYCLE86" => Kind::Drill,
            "CYCLE84" | "CYCLE840" | "CYCLE85" | "CYCLE89" => Kind::FeedOut,
            "CYCLE83" => {
                let first = arg(6).map(|d| d * mm).or(arg(5).map(|d| surface - d * mm));
                let first = first.filter(|d| *d > 0.0).ok_or("CYCLE83 without a first depth")?;
                let step = arg(7).filter(|d| *d > 0.0).map_or(first, |d| d * mm);
                let first = first + safety;
                Kind::Pecks { first, step, out: arg(11).is_some_and(|v| v > 0.5) }
            }
            name => return Err(format!("the cycle {name}")),
        };
        if retract < clear - 1e-6 || clear < bottom {
            return Err(format!("{} whose planes are out of order", k.name));
        }
        Ok(Called { kind, clear, bottom, end: retract })
    }

    pub(super) fn call(&mut self, called: &Called, steps: &mut Vec<Step>) -> Result<(), String> {
        let feed = self.needed_feed()?;
        match self.at[2] {
            Some(z) if z < called.clear - 1e-6 => Err("a cycle called below its clearance".into()),
            None => Err("a cycle from a height that is not known".into()),
            _ => self.down_and_up(
                called.kind,
                [called.clear, called.bottom, called.end],
                feed,
                steps,
            ),
        }
    }
}
