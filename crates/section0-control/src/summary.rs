//! A few figures of a compiled part.

use aptc_cldata::{Kind, MotionKind, Output, Record, Units, begins_cycle};
use aptc_geometry::Vec3;

/// What a part program made, in figures.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    /// Text of PARTNO.
    pub partno: String,
    /// Unit of the lengths below.
    pub units: Units,
    /// Statements that moved the tool, copies counted.
    pub motions: u64,
    /// Positions put out after the first.
    pub cut_vectors: u64,
    /// Length of the path at feed rate.
    pub cut_length: f64,
    /// Length of the path at rapid.
    pub rapid_length: f64,
    /// Tools loaded.
    pub tools: u64,
    state: State,
}

/// What holds from here on.
#[derive(Clone, Debug, Default, PartialEq)]
struct State {
    last: Option<Vec3>,
    rapid: bool,
    /// Between the holes of a cycle the tool goes at rapid.
    cycle: bool,
    /// DNTCUT.
    silent: bool,
}

impl Summary {
    /// Counts one record more of an edited CL stream of one part program.
    pub(crate) fn push(&mut self, record: &Record) {
        match &record.kind {
            Kind::Text { word, text } if word == "PARTNO" => {
                text.trim().clone_into(&mut self.partno);
            }
            Kind::Units(u) => self.units = *u,
            Kind::Post { word, .. } if word == "RAPID" => self.state.rapid = true,
            Kind::Post { word, .. } if word == "LOADTL" => self.tools += 1,
            Kind::Post { word, args } if word == "CYCLE" => {
                self.state.cycle = begins_cycle(args);
            }
            Kind::Output(o) => self.state.silent = *o == Output::Dntcut,
            Kind::Motion(m) if !self.state.silent => {
                self.motions += 1;
                let rapid = std::mem::take(&mut self.state.rapid) || self.state.cycle;
                for p in &m.points {
                    let last = self.state.last.replace(p.te);
                    if let (Some(from), false) = (last, m.kind == MotionKind::From) {
                        let length = (p.te - from).norm();
                        self.cut_vectors += 1;
                        if rapid {
                            self.rapid_length += length;
                        } else {
                            self.cut_length += length;
                        }
                    }
                }
            }
            _ => {}
        }
    }
}
