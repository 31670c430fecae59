//! What GOLOFT says besides its line: where it begins and ends, how it is divided.

use aptc_geometry::{Form, Plane};

use super::STEP;
use crate::failure::Failure;
use crate::regional::Regional;
use crate::scon::Words;
use crate::settings::Band;
use crate::solve::Setup;

/// Where a line begins or ends.
#[derive(Clone, Copy, Debug)]
pub(crate) enum End {
    /// At a parameter.
    Number(f64),
    /// Where the tool meets a plane: -1 TO, 0 ON, +1 PAST.
    Plane(f64, Plane),
}

/// What the statement says besides the line.
#[derive(Clone, Debug)]
pub(crate) struct Wish {
    pub(crate) start: Option<End>,
    pub(crate) thru: Option<End>,
    pub(crate) at: Option<End>,
    pub(super) inverse: bool,
    pub(super) mirror: bool,
    /// PARAM when false.
    pub(crate) flow: bool,
    pub(crate) incr: f64,
    pub(crate) chord: Option<f64>,
    pub(crate) longest: f64,
}

impl Wish {
    /// The same setup with the lengths and tolerances that are asked for.
    pub(super) fn asked<'a>(&self, mut setup: Setup<'a>) -> Setup<'a> {
        setup.maxdp = self.longest;
        if let Some(c) = self.chord {
            setup.band = Band { intol: setup.band.intol.min(c), outtol: c };
            setup.lateral = c;
        } else {
            setup.every = Some(self.incr);
        }
        setup
    }
}

impl Regional {
    pub(crate) fn wish(&self, w: &mut Words<'_>) -> Result<Wish, Failure> {
        let mut wish = Wish {
            start: None,
            thru: None,
            at: None,
            inverse: false,
            mirror: false,
            flow: false,
            incr: STEP,
            chord: None,
            longest: self.settings.maxdp(),
        };
        while let Some(word) = w.word() {
            match word {
                "START" => wish.start = end(w),
                "THRU" => wish.thru = end(w),
                "AT" => wish.at = end(w),
                "INVERS" => wish.inverse = true,
                "MIRROR" => wish.mirror = true,
                "FLOW" => wish.flow = true,
                "INCR" => wish.incr = w.positive("INCR")?,
                "CHORD" => wish.chord = Some(w.positive("CHORD")?),
                "LENGTH" => wish.longest = w.positive("LENGTH")?,
                _ => {}
            }
        }
        Ok(wish)
    }
}

fn end(w: &mut Words<'_>) -> Option<End> {
    if let Some(x) = w.number() {
        return Some(End::Number(x));
    }
    let relation = match w.word() {
        Some("TO") => -1.0,
        Some("PAST") => 1.0,
        _ => 0.0,
    };
    let (_, form) = w.form()?;
    match form.shape() {
        Form::Plane(p) => Some(End::Plane(relation, *p)),
        Form::Line(l) => Some(End::Plane(relation, l.plane())),
        _ => None,
    }
}
