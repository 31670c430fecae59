//! What a compilation can be written as.

use aptc_cldata::{JsonWriter, Record, RecordWriter, TapeWriter, TextOptions, TextWriter};
use aptc_vocabulary::Dialect;

use crate::Compiled;
use crate::geometry_json::geometry_json;

/// A kind of result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Artifact {
    /// Numeric part program, `protap`.
    Protap,
    /// CL data as ISO 4343 text, `cl`.
    Cl,
    /// CL data as JSON lines, `cl.json`.
    ClJson,
    /// CL data as APT-360 binary records, `cltape`.
    Cltape,
    /// Machine code, `nc`, and `MACHINE.nc` for further machines.
    Nc,
    /// Listing, `lst`.
    Listing,
    /// Plot, `svg`.
    Svg,
    /// Canonical forms, `geometry.json`.
    Geometry,
}

impl Compiled {
    /// The files of a kind: ending without the first dot, and content. Nothing where the run had errors
    /// that this kind does not survive; with `keep_going` CL data then comes as `partial.cl`.
    pub fn artifact(&self, kind: Artifact, keep_going: bool) -> Vec<(String, Vec<u8>)> {
        let whole = self.is_cl_whole();
        let one = |ending: &str, bytes: Vec<u8>| vec![(ending.to_owned(), bytes)];
        match kind {
            Artifact::Protap if whole => Vec::new(),
            Artifact::Cl if whole => one("cl", self.cl_text()),
            Artifact::Cl if keep_going => one("partial.cl", self.cl_text()),
            Artifact::ClJson if whole => {
                let mut bytes = Vec::new();
                self.write(&mut JsonWriter::new(&mut bytes));
                one("cl.json", bytes)
            }
            Artifact::Cltape if whole => {
                let mut bytes = Vec::new();
                self.write(&mut TapeWriter::new(&mut bytes, Dialect::Apt360));
                one("cltape", bytes)
            }
            Artifact::Nc if whole && !self.is_refuted() => self.nc(),
            Artifact::Listing => one("lst", self.listing.clone().into_bytes()),
            Artifact::Svg if whole => self.plot(),
            Artifact::Geometry => {
                let items = self.geometry.iter().map(|(n, v)| (n.as_str(), v));
                one("geometry.json", geometry_json(items).into_bytes())
            }
            _ => Vec::new(),
        }
    }

    fn edited(&self) -> impl Iterator<Item = &Record> {
        self.parts.iter().flat_map(|p| &p.edited)
    }

    fn cl_text(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        self.write(&mut TextWriter::new(&mut bytes, TextOptions::default()));
        bytes
    }

    fn write(&self, writer: &mut dyn RecordWriter) {
        for record in self.edited() {
            writer.write(record).expect("memory takes all");
        }
        writer.finish().expect("memory takes all");
    }

    /// `nc` for the first part program, `2.nc` for the next; the machine stands between for further ones.
    fn nc(&self) -> Vec<(String, Vec<u8>)> {
        let mut files = Vec::new();
        for (i, part) in self.parts.iter().enumerate() {
            for nc in &part.nc {
                let number = if i == 0 { String::new() } else { format!("{}.", i + 1) };
                let machine = if nc.further { format!("{}.", nc.machine) } else { String::new() };
                files.push((format!("{number}{machine}nc"), nc.text.clone()));
            }
        }
        files
    }

    fn plot(&self) -> Vec<(String, Vec<u8>)> {
        if self.parts.iter().all(|p| p.noplot) {
            return Vec::new();
        }
        let records = self.parts.iter().filter(|p| !p.noplot).flat_map(|p| &p.edited);
        vec![("svg".to_owned(), aptc_edit::plot_svg(records).into_bytes())]
    }
}
