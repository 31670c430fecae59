//! A few figures of a compiled part.

use aptc_cldata::{Kind, MotionKind, Output, Record, Units};
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
}

impl Summary {
    /// Counts an edited CL stream of one part program.
    pub(crate) fn of(records: &[Record]) -> Self {
        let mut s = Self::default();
        let (mut last, mut rapid, mut output) = (None::<Vec3>, false, true);
        for record in records {
            match &record.kind {
                Kind::Text { word, text } if word == "PARTNO" => s.partno = text.trim().to_owned(),
                Kind::Units(u) => s.units = *u,
                Kind::Post { word, .. } if word == "RAPID" => rapid = true,
                Kind::Post { word, .. } if word == "LOADTL" => s.tools += 1,
                Kind::Output(o) => output = *o == Output::Cut,
                Kind::Motion(m) if output => {
                    s.motions += 1;
                    for p in &m.points {
                        if let (Some(from), false) = (last, m.kind == MotionKind::From) {
                            let length = (p.te - from).norm();
                            s.cut_vectors += 1;
                            if rapid {
                                s.rapid_length += length;
                            } else {
                                s.cut_length += length;
                            }
                        }
                        last = Some(p.te);
                    }
                    rapid = false;
                }
                _ => {}
            }
        }
        s
    }
}
