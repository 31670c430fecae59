//! What the CL data has said so far.

use std::collections::BTreeSet;

use aptc_cldata::Units;
use aptc_diagnostics::{Origin, Severity};
use aptc_geometry::{Cutter, Plane, Transform, Vec3};
use smol_str::SmolStr;

use crate::drill::DrillCycle;
use crate::report::Extent;

/// Unit of a programmed feed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FeedUnit {
    /// CL units per minute.
    PerMinute,
    /// CL units per revolution.
    PerRevolution,
    /// Inches per minute.
    InchPerMinute,
    /// Inches per revolution.
    InchPerRevolution,
    /// Millimetres per minute.
    MmPerMinute,
    /// Millimetres per revolution.
    MmPerRevolution,
}

/// FEDRAT.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Feedrate {
    pub(crate) value: f64,
    pub(crate) unit: FeedUnit,
}

/// SPINDL.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct SpindleState {
    pub(crate) on: bool,
    pub(crate) speed: f64,
    pub(crate) ccw: bool,
    /// Constant surface speed.
    pub(crate) surface: bool,
}

/// What the CL data has said so far. Lengths are in output units once the program has begun.
#[derive(Debug)]
pub(crate) struct State {
    pub(crate) units: Units,
    /// Was UNITS said?
    pub(crate) units_said: bool,
    /// Unit of the output is the inch.
    pub(crate) inch: bool,
    /// Output units in one CL unit.
    pub(crate) scale: f64,
    /// TRANS and ORIGIN, in output units.
    pub(crate) shift: Vec3,
    /// The same in millimetres: the unit of the output may change before the first block.
    pub(crate) shift_mm: Vec3,
    pub(crate) partno: String,
    /// Comments that came before the first block.
    pub(crate) early: Vec<String>,
    pub(crate) started: bool,
    pub(crate) ended: bool,
    /// What was said of work after the end: it is said once, and once more when it is worse.
    pub(crate) late: Option<Severity>,
    /// Tool end, in output units.
    pub(crate) pos: Option<Vec3>,
    /// Tool axis.
    pub(crate) ta: Vec3,
    /// Angles of the rotary axes as the control knows them, degrees, not wrapped.
    pub(crate) angles: [f64; 2],
    /// The rotary axes with the present tool.
    pub(crate) chain: Option<crate::kinematics::Chain>,
    /// ROTABL and ROTHED.
    pub(crate) index: Option<Box<crate::index::Index>>,
    /// The tilted plane in which positions are written: the rotation from the frame of the part to it.
    pub(crate) plane: Option<nalgebra::Matrix3<f64>>,
    /// The control was told of it.
    pub(crate) plane_on: bool,
    /// A tool end and the place of the linear axes for it at `angles`.
    pub(crate) placed: Option<(Vec3, Vec3)>,
    /// Tool-centre control is on.
    pub(crate) centered: bool,
    /// The last motion to `pos` was a cut.
    pub(crate) cut_last: bool,
    /// The machine is retracted and not at `pos`.
    pub(crate) away: bool,
    /// The motion is a piece of an arc that is gone around in lines.
    pub(crate) rounding: bool,
    /// RAPID is pending.
    pub(crate) rapid: bool,
    pub(crate) feed: Option<Feedrate>,
    /// `feed` in the words of the machine, until it or the spindle changes.
    pub(crate) feed_word: Option<crate::emit::FeedWord>,
    /// FEDRAT/INVERS.
    pub(crate) inverse: bool,
    pub(crate) feed_missing_said: bool,
    /// Words of statements that were refused.
    pub(crate) refused_words: BTreeSet<SmolStr>,
    pub(crate) spindle: SpindleState,
    /// The spindle was stopped by a tool change and has to run again.
    pub(crate) spindle_again: bool,
    /// A program stop may have stopped the spindle; or it runs on. Either way it is told to run again, and as running
    /// where it is to stop.
    pub(crate) spindle_perhaps: bool,
    /// SPINDL/ORIENT has stopped the spindle: the program, not the machine, says when it runs again.
    pub(crate) spindle_oriented: bool,
    /// SPINDL and COOLNT whose blocks wait.
    pub(crate) held: Vec<crate::held::Held>,
    pub(crate) max_rpm: Option<f64>,
    pub(crate) coolant: Option<String>,
    pub(crate) last_coolant: Option<String>,
    pub(crate) coolant_again: bool,
    /// The same as `spindle_perhaps` of the coolant.
    pub(crate) coolant_perhaps: bool,
    /// The coordinate system that the CL data named last.
    pub(crate) frame: Option<Transform>,
    pub(crate) tool: Option<u32>,
    /// Where the tool was when it was changed.
    pub(crate) changed_at: Option<Vec3>,
    pub(crate) offset: Option<u32>,
    pub(crate) tool_length: Option<f64>,
    /// Tool numbers that LOADTL has given so far.
    pub(crate) n_loads: usize,
    pub(crate) tool_comment: String,
    pub(crate) cutter: Option<Cutter>,
    pub(crate) cutcom: Option<(bool, u32)>,
    /// Motions before CUTCOM came.
    pub(crate) cutcom_since: u64,
    pub(crate) last_cutcom: Option<(bool, u32)>,
    /// CUTCOM/ON whose side is to follow.
    pub(crate) cutcom_asked: Option<Origin>,
    pub(crate) wear_defined: Vec<u32>,
    /// CLRSRF, in millimetres.
    pub(crate) clearance_mm: Option<Plane>,
    pub(crate) cycle: Option<DrillCycle>,
    pub(crate) last_cycle: Option<DrillCycle>,
    /// How far arcs may leave the lines that they replace, millimetres; none while ARCSLP/LINCIR is off.
    pub(crate) fit_mm: Option<f64>,
    /// The same while it was on last.
    pub(crate) last_fit_mm: Option<f64>,
    /// The arc that is written replaces lines: rounding may not move it by more than a few steps.
    pub(crate) fitted: bool,
    /// Milling on a lathe: does the tool stand across the spindle? Not known before its first motion.
    pub(crate) across: Option<bool>,
    /// THREAD is on: the lead, output units.
    pub(crate) thread: Option<f64>,
    pub(crate) intol: f64,
    pub(crate) outtol: f64,
    pub(crate) tolerance_said: bool,
    pub(crate) path_tolerance_mm: Option<f64>,
    pub(crate) lintol_mm: Option<f64>,
    pub(crate) ready_said: bool,
    pub(crate) extent: Option<Extent>,
    /// Least and greatest position of each axis, output units and degrees; the wrong way round at first.
    pub(crate) reach: [[f64; 2]; 5],
    /// Which ends of X, Y and Z have been reported as exceeded.
    pub(crate) limits_told: [[bool; 2]; 3],
    pub(crate) multax: bool,
    /// It was told that no tool is loaded where its length counts.
    pub(crate) length_told: bool,
    /// The note about blocks in which the tool turns where it stands is written.
    pub(crate) turn_noted: bool,
    /// Was a feed doubted that is so small a minute?
    pub(crate) feed_doubted: bool,
}

impl State {
    pub(crate) fn new() -> Self {
        Self {
            units: Units::default(),
            units_said: false,
            inch: true,
            scale: 1.0,
            shift: Vec3::zeros(),
            shift_mm: Vec3::zeros(),
            partno: String::new(),
            early: Vec::new(),
            started: false,
            ended: false,
            late: None,
            pos: None,
            ta: Vec3::z(),
            angles: [0.0; 2],
            chain: None,
            index: None,
            plane: None,
            plane_on: false,
            placed: None,
            centered: false,
            cut_last: false,
            away: false,
            rounding: false,
            rapid: false,
            feed: None,
            feed_word: None,
            inverse: false,
            feed_missing_said: false,
            refused_words: BTreeSet::new(),
            spindle: SpindleState::default(),
            spindle_again: false,
            spindle_perhaps: false,
            spindle_oriented: false,
            held: Vec::new(),
            max_rpm: None,
            coolant: None,
            last_coolant: None,
            coolant_again: false,
            coolant_perhaps: false,
            frame: None,
            tool: None,
            changed_at: None,
            offset: None,
            tool_length: None,
            n_loads: 0,
            tool_comment: String::new(),
            cutter: None,
            cutcom: None,
            cutcom_since: 0,
            last_cutcom: None,
            cutcom_asked: None,
            wear_defined: Vec::new(),
            clearance_mm: None,
            cycle: None,
            last_cycle: None,
            fit_mm: None,
            last_fit_mm: None,
            fitted: false,
            across: None,
            thread: None,
            intol: 0.0,
            outtol: 0.0005,
            tolerance_said: false,
            path_tolerance_mm: None,
            lintol_mm: None,
            ready_said: false,
            extent: None,
            reach: [[f64::INFINITY, f64::NEG_INFINITY]; 5],
            limits_told: [[false; 2]; 3],
            multax: false,
            length_told: false,
            turn_noted: false,
            feed_doubted: false,
        }
    }

    /// A SPINDL says how the spindle is from here on, whatever has stopped it before.
    pub(crate) fn spindle_said(&mut self) {
        (self.spindle_again, self.spindle_perhaps, self.spindle_oriented) = (false, false, false);
    }

    /// Must spindle or coolant be told to run before the next motion?
    #[inline]
    pub(crate) fn stands_still(&self) -> bool {
        self.spindle_again || self.spindle_perhaps || self.coolant_again || self.coolant_perhaps
    }

    /// Millimetres in one output unit.
    pub(crate) fn out_mm(&self) -> f64 {
        if self.inch { 25.4 } else { 1.0 }
    }

    /// A CL point in output units and the program's frame.
    #[inline]
    pub(crate) fn point(&self, p: Vec3) -> Vec3 {
        p * self.scale + self.shift
    }

    /// CLRSRF in output units, in the frame of the positions.
    pub(crate) fn clearance(&self) -> Option<Plane> {
        let p = self.clearance_mm?;
        let moved = Plane { n: p.n, d: p.d + p.n.dot(&self.shift_mm) };
        let seen = self.index.as_ref().map_or(moved, |i| i.plane(&moved));
        Some(Plane { n: seen.n, d: seen.d / self.out_mm() })
    }

    /// Greatest deviation that the CL data allows, in output units.
    pub(crate) fn band(&self) -> f64 {
        let t = self.intol.max(self.outtol);
        if self.tolerance_said { t * self.scale } else { 0.0005 * 25.4 / self.out_mm() }
    }

    /// Follows a change of the unit of the CL data or of the output.
    pub(crate) fn rescale(&mut self) {
        // Exactly 1 when both are the same.
        self.scale = self.units.mm() / self.out_mm();
        self.shift = self.shift_mm / self.out_mm();
    }
}
