//! What a compilation can be written as.

use aptc_cldata::{JsonWriter, Record, RecordWriter, TapeWriter, TextOptions, TextWriter};
use aptc_post::{setup_html, setup_text};
use aptc_vocabulary::Dialect;

use crate::Compiled;
use crate::Nc;
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
    /// Setup sheet, `setup.txt` and `setup.html`, for each machine code.
    Setup,
    /// From which statement each block comes, `nc.map.json`, for each machine code.
    Map,
    /// Listing, `lst`.
    Listing,
    /// Plot, `svg`.
    Svg,
    /// Canonical forms, `geometry.json`.
    Geometry,
    /// What regional milling leaves on its part surfaces or cuts into them, `deviation.svg`.
    Deviation,
    /// A picture of the situation in which the first motion failed, `diagram.svg`.
    Diagram,
}

impl Compiled {
    /// The files of a kind: ending without the first dot, and content. Nothing where the run had errors
    /// that this kind does not survive; with `keep_going` CL data then comes as `partial.cl`.
    pub fn artifact(&self, kind: Artifact, keep_going: bool) -> Vec<(String, Vec<u8>)> {
        let whole = self.is_cl_whole();
        let one = |ending: &str, bytes: Vec<u8>| vec![(ending.to_owned(), bytes)];
        match kind {
            Artifact::Protap if whole => {
                let records = self.parts.iter().flat_map(|p| &p.protap);
                one("protap", aptc_protap::write(records).into_bytes())
            }
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
            Artifact::Nc if whole && !self.is_refuted() => {
                self.nc().map(|(stem, nc)| (format!("{stem}nc"), nc.text.clone())).collect()
            }
            Artifact::Setup if whole && !self.is_refuted() => self.setup(),
            Artifact::Map if whole && !self.is_refuted() => self.map(),
            Artifact::Listing => one("lst", self.listing.clone().into_bytes()),
            Artifact::Svg if whole => self.plot(),
            Artifact::Geometry => {
                let items = self.geometry.iter().map(|(n, v)| (n.as_str(), v));
                one("geometry.json", geometry_json(items).into_bytes())
            }
            Artifact::Deviation if whole => {
                let records = self.parts.iter().flat_map(|p| &p.computed);
                let svg = aptc_verify::deviation_svg(records);
                svg.map_or_else(Vec::new, |s| one("deviation.svg", s.into_bytes()))
            }
            Artifact::Diagram => {
                let situation = self.situation.iter();
                situation.map(|s| ("diagram.svg".to_owned(), s.svg().into_bytes())).collect()
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

    /// Each machine code with what stands before the ending: nothing for the first part program, `2.` for
    /// the next; the machine stands between for further ones.
    pub fn nc(&self) -> impl Iterator<Item = (String, &Nc)> {
        self.parts.iter().enumerate().flat_map(|(i, part)| {
            part.nc.iter().map(move |nc| {
                let number = if i == 0 { String::new() } else { format!("{}.", i + 1) };
                let machine =
                    if nc.further { format!("{}.", nc.machine.name) } else { String::new() };
                (format!("{number}{machine}"), nc)
            })
        })
    }

    fn setup(&self) -> Vec<(String, Vec<u8>)> {
        let sheets = self.nc().flat_map(|(stem, nc)| {
            let sheet = nc.setup();
            [
                (format!("{stem}setup.txt"), setup_text(&sheet).into_bytes()),
                (format!("{stem}setup.html"), setup_html(&sheet).into_bytes()),
            ]
        });
        sheets.collect()
    }

    /// One JSON object: the lines of text with their CL record and statement, macros and loops.
    fn map(&self) -> Vec<(String, Vec<u8>)> {
        let maps = self.nc().map(|(stem, nc)| {
            let files: Vec<&str> = self.sources.iter().map(|(_, f)| f.name.as_ref()).collect();
            let map = serde_json::json!({
                "version": 1,
                "machine": nc.machine.name,
                "files": files,
                "blocks": nc.map,
            });
            (format!("{stem}nc.map.json"), format!("{map:#}\n").into_bytes())
        });
        maps.collect()
    }

    fn plot(&self) -> Vec<(String, Vec<u8>)> {
        if self.parts.iter().all(|p| p.noplot) {
            return Vec::new();
        }
        let records = self.parts.iter().filter(|p| !p.noplot).flat_map(|p| &p.edited);
        vec![("svg".to_owned(), aptc_edit::plot_svg(records).into_bytes())]
    }
}
