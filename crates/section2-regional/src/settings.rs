//! The modal words that regional milling obeys.

use aptc_geometry::{Cutter, Profile};
use aptc_protap::{Kind, OptionSurface, ToolAxis, Units};

/// Historic defaults, in millimetres: they were inches and are converted to the unit of the program.
const OUTTOL_MM: f64 = 0.0005 * 25.4;
const MAXDP_MM: f64 = 10.0 * 25.4;
/// Points of a path when NUMPTS does not say.
const POINTS: u32 = 100_000;

/// Modal settings.
#[derive(Debug, Default)]
pub(crate) struct Settings {
    pub(crate) units: Units,
    pub(crate) cutter: Option<Cutter>,
    pub(crate) profile: Option<Profile>,
    /// Is it told, since the last CUTTER, that there is none that is a solid?
    pub(crate) told_no_cutter: bool,
    intol: Option<[f64; 4]>,
    outtol: Option<[f64; 4]>,
    maxdp: Option<f64>,
    length: Option<f64>,
    numpts: Option<u32>,
    pub(crate) multax: bool,
    pub(crate) cut: Option<bool>,
    /// Left on the part surface by THICK.
    pub(crate) thick: f64,
    /// Left on the drive surface.
    pub(crate) thick_drive: f64,
    /// Left on check surfaces.
    pub(crate) thick_check: f64,
    /// CUTTER/OPTION against part and drive surface: radius and height.
    pub(crate) disks: [Option<(f64, f64)>; 2],
    /// TLAXIS; `None` before any.
    pub(crate) axis: Option<ToolAxis>,
    /// Was it given by TLAXIS itself, and led no motion since?
    pub(crate) axis_idle: bool,
}

/// Allowed violation and excess.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Band {
    pub(crate) intol: f64,
    pub(crate) outtol: f64,
}

impl Settings {
    /// Takes a modal record.
    pub(crate) fn observe(&mut self, kind: &Kind) {
        match kind {
            Kind::Units(u) => self.units = *u,
            Kind::Cutter(c) => {
                self.cutter = Some(*c);
                self.profile = Profile::new(c).ok();
                self.told_no_cutter = false;
            }
            Kind::Intol(t) => self.intol = Some(*t),
            Kind::Outtol(t) => self.outtol = Some(*t),
            Kind::Maxdp { step, length } => {
                self.maxdp = Some(*step);
                if length.is_some() {
                    self.length = *length;
                }
            }
            Kind::Numpts(n) => self.numpts = Some(*n),
            Kind::Multax(on) => self.multax = *on,
            Kind::Cut(on) => self.cut = Some(*on),
            Kind::CutterOption { surface, disk } => {
                self.disks[usize::from(*surface == OptionSurface::Drive)] = *disk;
            }
            Kind::Thick([part, drive, check, _]) => {
                [self.thick, self.thick_drive, self.thick_check] = [*part, *drive, *check];
            }
            Kind::ToolAxis(axis) => (self.axis, self.axis_idle) = (Some(axis.clone()), true),
            Kind::From(p) | Kind::Goto(p) => {
                if let Some(ta) = p.axis {
                    (self.axis, self.axis_idle) = (Some(ToolAxis::Fixed(ta)), false);
                }
            }
            _ => {}
        }
    }

    /// Tolerance on the part surface; never of no width.
    pub(crate) fn band(&self) -> Band {
        let default = OUTTOL_MM / self.units.mm();
        let intol = self.intol.map_or(0.0, |t| t[0]).max(0.0);
        let outtol = self.outtol.map_or(default, |t| t[0]).max(0.0);
        let least = default * 1e-4;
        if intol + outtol < least { Band { intol, outtol: least } } else { Band { intol, outtol } }
    }

    /// How far a chord may leave the drive sideways: OUTTOL of the drive surface, else its INTOL.
    pub(crate) fn lateral(&self) -> f64 {
        let default = OUTTOL_MM / self.units.mm();
        let given = |t: Option<[f64; 4]>| t.map(|t| t[1]).filter(|t| *t > 0.0);
        given(self.outtol).or_else(|| given(self.intol)).unwrap_or(default)
    }

    /// How far the chords of INTSEC may leave their curve: half of the narrower band of part and drive surface.
    pub(crate) fn chord(&self) -> f64 {
        let default = OUTTOL_MM / self.units.mm();
        let width = |i: usize| {
            let of = |t: Option<[f64; 4]>, without: f64| t.map_or(without, |t| t[i]).max(0.0);
            of(self.intol, 0.0) + of(self.outtol, default)
        };
        0.5 * width(0).min(width(1)).max(default * 1e-4)
    }

    /// Greatest length of a cut vector.
    pub(crate) fn maxdp(&self) -> f64 {
        match self.maxdp {
            Some(d) if d != 0.0 => d.abs(),
            _ => MAXDP_MM / self.units.mm(),
        }
    }

    /// Greatest length of a path, if MAXDP gave one.
    pub(crate) fn length(&self) -> Option<f64> {
        self.length.filter(|l| *l > 0.0)
    }

    /// Most points of a path.
    pub(crate) fn numpts(&self) -> usize {
        self.numpts.unwrap_or(POINTS) as usize
    }
}
