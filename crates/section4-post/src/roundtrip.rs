//! The proof: what was written is read back and compared with the CL data.
//!
//! Positions that the CL data asks for wait in a queue; each [`Step`] that the reader sees has to reach the
//! next of them on the way that the CL data means: a cut never as a rapid, never off its line by more than
//! the resolution and LINTOL, an arc through all its cut vectors, a hole from its clearance to its bottom and
//! back. Lengths here are millimetres.

mod asked;
mod done;
mod from_home;
mod hole;
mod posed;
mod prove;
mod round;
mod straight;

use std::collections::VecDeque;
use std::fmt;

use aptc_cldata::Units;
use aptc_geometry::Vec3;

use crate::drill::DrillCycle;
use crate::index::Index;
use crate::machine::Machine;
use crate::readback::{Fault, Frame, Reader, Step};

pub use prove::prove;

/// Faults of one program that are told.
const MOST_FAULTS: usize = 20;

/// What the CL data asks for.
#[derive(Clone, Debug)]
enum Expect {
    /// A position. `via`: on an arc of which only the end was given, to be passed, not to be stopped at.
    /// `round`: the way to it is an arc of the CL data.
    Point { te: Vec3, ta: Vec3, rapid: bool, via: bool, round: bool },
    /// A hole.
    Hole(Hole),
    /// A retract along the tool axis, perhaps none.
    Clear,
    /// The tool is there, or is brought there from home.
    From { te: Vec3, ta: Vec3 },
    /// A tool change with the length of the tool, when it is known.
    Tool { length: Option<f64> },
    /// The machine goes home.
    Home,
    /// A lathe begins or ends to mill.
    Mill(bool),
    /// Text of the user's own: any motion may come.
    Free,
}

#[derive(Clone, Debug)]
struct Hole {
    at: Vec3,
    ta: Vec3,
    bottom: f64,
    clearance: f64,
    retract: f64,
    deepest: f64,
    /// CLRSRF, above which nothing stands.
    plane: Option<aptc_geometry::Plane>,
}

/// The tool stands on the line through `at` along `ta`.
#[derive(Clone, Copy, Debug)]
struct Over {
    at: Vec3,
    ta: Vec3,
    /// Is `at` where it stands, and not only beside it?
    known: bool,
    angles: [Option<f64>; 2],
}

/// What the comparison has found.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
pub struct Proof {
    /// Positions of the CL data that were reached.
    pub points: u64,
    /// Greatest distance of a reached position from the CL data, millimetres.
    pub position_mm: f64,
    /// Greatest distance from the straight line between two positions, millimetres.
    pub path_mm: f64,
    /// Greatest angle between tool axes, degrees.
    pub axis_deg: f64,
}

impl fmt::Display for Proof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} positions reached within {:.5} mm, paths within {:.5} mm, tool axes within {:.5} degrees",
            self.points, self.position_mm, self.path_mm, self.axis_deg
        )
    }
}

/// Compares the text with the CL data.
pub(crate) struct Checker {
    control: Reader,
    posed: Option<posed::Posed>,
    /// The tilted plane in which the text is written.
    frame: Option<Frame>,
    machine: std::sync::Arc<Machine>,
    /// The machine as its file has it: a lathe is another while it mills.
    lathe: std::sync::Arc<Machine>,
    /// Milling on a lathe: the tool stands across the spindle.
    across: bool,
    units: Units,
    shift: Vec3,
    /// ROTABL and ROTHED: the angles, and from there to the frame of the part.
    index: Option<Index>,
    indexed: [f64; 2],
    multax: bool,
    tool_length: Option<f64>,
    /// The length of the tool whose text is read.
    read_length: Option<f64>,
    cycle: Option<DrillCycle>,
    last_cycle: Option<DrillCycle>,
    clearance: Option<aptc_geometry::Plane>,
    rapid: bool,
    band: Option<f64>,
    /// How far arcs may leave the lines of the CL data: ARCSLP/LINCIR.
    fit: Option<f64>,
    intol: f64,
    lintol: f64,
    queue: VecDeque<Expect>,
    /// Where the CL data stands at the end of the queue.
    planned: Option<(Vec3, Vec3)>,
    /// The last position of the CL data that was reached, or FROM.
    at: Option<(Vec3, Vec3)>,
    /// The motion to `at` was a cut.
    at_cut: bool,
    /// Where a cut ended below the place at which the tool came from home: it may go down there first.
    below: Option<(Vec3, Vec3)>,
    /// Tool end and axis as read.
    now: Option<(Vec3, Vec3)>,
    away: bool,
    /// On the way from home: a place and direction along which the tool stands, and the angles for it.
    over: Option<Over>,
    /// Positions are those of the tool end beside turned axes.
    centered: bool,
    /// Text of INSERT or PREFUN comes: any motion is the user's own.
    free: bool,
    /// The tool is retracted to wind the rotary axes back.
    detour: bool,
    linear: f64,
    angular: f64,
    steps: Vec<Step>,
    pub(crate) faults: Vec<Fault>,
    pub(crate) proof: Proof,
}

impl Checker {
    pub(crate) fn new(machine: &std::sync::Arc<Machine>) -> Self {
        Self {
            control: Reader::new(machine),
            posed: None,
            frame: None,
            machine: std::sync::Arc::clone(machine),
            lathe: std::sync::Arc::clone(machine),
            across: false,
            units: Units::default(),
            shift: Vec3::zeros(),
            index: None,
            indexed: [0.0; 2],
            multax: false,
            tool_length: None,
            read_length: None,
            cycle: None,
            last_cycle: None,
            clearance: None,
            rapid: false,
            band: None,
            fit: machine.arcs.as_ref().map(|a| a.fit).filter(|t| *t > 0.0),
            intol: 0.0,
            lintol: machine.multiaxis.lintol,
            queue: VecDeque::new(),
            planned: None,
            at: None,
            at_cut: false,
            below: None,
            now: None,
            away: machine.program.start_retracts,
            over: None,
            centered: machine.multiaxis.tool_center_on.is_empty(),
            free: false,
            detour: false,
            linear: 0.001,
            angular: 1e-5,
            steps: Vec::new(),
            faults: Vec::new(),
            proof: Proof::default(),
        }
    }

    /// Takes the resolution of the output as the measure.
    pub(crate) fn set_resolution_of(&mut self, blocks: &crate::emit::Blocks, unit_mm: f64) {
        let linear = [b'X', b'Y', b'Z'].map(|l| blocks.number(l).resolution() * unit_mm);
        let turning =
            self.machine.rotary.iter().map(|r| blocks.number(r.letter as u8).resolution());
        let angular_deg = turning.fold(0.0, f64::max);
        self.linear = linear.into_iter().fold(0.0, f64::max) + 1e-6;
        self.angular = (angular_deg + self.machine.multiaxis.singular).to_radians() + 2e-6;
    }

    /// Tool end and tool axis in millimetres in the frame of the part.
    fn seen(&self, te: Vec3, ta: Vec3) -> (Vec3, Vec3) {
        let (te, ta) = (te * self.units.mm() + self.shift, ta.normalize());
        self.index.as_ref().and_then(|i| i.position(te, ta)).unwrap_or((te, ta))
    }

    /// Reads text; its lines belong to the record that was taken last.
    pub(crate) fn text(&mut self, text: &[u8]) {
        for line in text.split(|b| *b == b'\n') {
            if line.is_empty() {
                continue;
            }
            let mut steps = std::mem::take(&mut self.steps);
            steps.clear();
            if let Err(fault) = self.control.read(line, &mut steps) {
                self.say(fault.message);
            }
            for step in &steps {
                self.step(step);
            }
            self.steps = steps;
        }
    }

    /// After a record: all that it asks for must have been done.
    pub(crate) fn settle(&mut self) {
        loop {
            self.marks();
            self.skip_here();
            match self.queue.front() {
                Some(Expect::Clear) => {
                    self.queue.pop_front();
                }
                Some(Expect::Point { .. } | Expect::Hole(_)) | None => break,
                Some(_) => {}
            }
        }
        let missed = match self.queue.front() {
            Some(Expect::Point { te, .. }) => *te,
            Some(Expect::Hole(h)) => h.at + h.ta * h.bottom,
            _ => return,
        };
        self.say(format!("the position {} of the CL data is not reached", shown(missed)));
        self.queue.clear();
    }

    /// What comes before the next position and is no motion.
    fn marks(&mut self) {
        loop {
            match self.queue.front() {
                Some(Expect::From { te, ta }) => {
                    let far = self.at.is_some_and(|(at, _)| (at - te).norm() > self.linear);
                    self.away |= far && !self.machine.program.retract.is_empty();
                    (self.at, self.at_cut) = (Some((*te, *ta)), false);
                }
                Some(Expect::Tool { length }) => {
                    self.read_length = *length;
                    self.posed = None;
                    self.away = self.machine.program.start_retracts;
                }
                Some(Expect::Home) => {
                    self.at = None;
                    self.away = true;
                }
                Some(Expect::Mill(on)) => {
                    let milling = on.then(|| self.lathe.while_milling()).flatten();
                    let lathe = || std::sync::Arc::clone(&self.lathe);
                    self.machine = milling.map_or_else(lathe, std::sync::Arc::new);
                    self.posed = None;
                    self.lintol = self.machine.multiaxis.lintol;
                    (self.at, self.away) = (None, true);
                }
                Some(Expect::Free) => self.free = true,
                _ => return,
            }
            self.queue.pop_front();
        }
    }

    fn say(&mut self, message: String) {
        if self.faults.len() < MOST_FAULTS {
            self.faults.push(Fault { line: self.control.n_lines(), message });
        }
    }
}

fn shown(p: Vec3) -> String {
    [p.x, p.y, p.z].map(|c| crate::post::trimmed(c, 4)).join(",")
}
