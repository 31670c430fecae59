//! What a compilation can be written as.

use std::io::{self, Write};

use aptc_cldata::{JsonWriter, RecordWriter, TapeWriter, TextOptions, TextWriter};
use aptc_edit::Plot;
use aptc_post::{setup_html, setup_text};
use aptc_vocabulary::Dialect;

use crate::geometry_json::geometry_json;
use crate::{Compiled, Nc, Text, listing};

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

/// A file that can be written.
pub struct ArtifactFile<'c> {
    /// Its ending, without the first dot.
    pub ending: String,
    content: Content<'c>,
}

enum Content<'c> {
    Made(Vec<u8>),
    Text(&'c Text),
    Cl(&'c Compiled, Form),
    Listing(&'c Compiled),
}

/// A form of CL data.
#[derive(Clone, Copy)]
enum Form {
    Text,
    Json,
    Tape,
}

impl ArtifactFile<'_> {
    /// Writes it, in memory that does not grow with CL data and machine code.
    ///
    /// # Errors
    /// What `out` and the temporary files give.
    pub fn write_to(&self, out: &mut dyn Write) -> io::Result<()> {
        match &self.content {
            Content::Made(bytes) => out.write_all(bytes),
            Content::Text(text) => text.copy_to(out),
            Content::Cl(compiled, Form::Text) => {
                compiled.write(&mut TextWriter::new(out, TextOptions::default()))
            }
            Content::Cl(compiled, Form::Json) => compiled.write(&mut JsonWriter::new(out)),
            Content::Cl(compiled, Form::Tape) => {
                compiled.write(&mut TapeWriter::new(out, Dialect::Apt360))
            }
            Content::Listing(compiled) => listing::write(out, compiled),
        }
    }
}

impl Compiled {
    /// The files of a kind with their content.
    ///
    /// # Errors
    /// What the temporary files give.
    pub fn artifact(&self, kind: Artifact, keep_going: bool) -> io::Result<Vec<(String, Vec<u8>)>> {
        let mut all = Vec::new();
        for file in self.files(kind, keep_going)? {
            let mut bytes = Vec::new();
            file.write_to(&mut bytes)?;
            all.push((file.ending, bytes));
        }
        Ok(all)
    }

    /// The files of a kind. Nothing where the run had errors that this kind does not survive; with
    /// `keep_going` CL data then comes as `partial.cl`.
    ///
    /// # Errors
    /// What the temporary files give.
    pub fn files(&self, kind: Artifact, keep_going: bool) -> io::Result<Vec<ArtifactFile<'_>>> {
        let whole = self.is_cl_whole();
        let one = |ending: &str, content| vec![ArtifactFile { ending: ending.to_owned(), content }];
        let made = |ending: &str, bytes| one(ending, Content::Made(bytes));
        let all = |files: Vec<(String, Vec<u8>)>| {
            let file = |(ending, bytes)| ArtifactFile { ending, content: Content::Made(bytes) };
            files.into_iter().map(file).collect()
        };
        Ok(match kind {
            Artifact::Protap if whole => {
                let records = self.parts.iter().flat_map(|p| &p.protap);
                made("protap", aptc_protap::write(records).into_bytes())
            }
            Artifact::Cl if whole => one("cl", Content::Cl(self, Form::Text)),
            Artifact::Cl if keep_going => one("partial.cl", Content::Cl(self, Form::Text)),
            Artifact::ClJson if whole => one("cl.json", Content::Cl(self, Form::Json)),
            Artifact::Cltape if whole => one("cltape", Content::Cl(self, Form::Tape)),
            Artifact::Nc if whole && !self.is_refuted() => {
                let mut files = Vec::new();
                for (stem, nc) in self.nc() {
                    let ending = format!("{stem}nc");
                    files.push(ArtifactFile { ending, content: Content::Text(&nc.text) });
                }
                files
            }
            Artifact::Setup if whole && !self.is_refuted() => all(self.setup()),
            Artifact::Map if whole && !self.is_refuted() => all(self.map()),
            Artifact::Listing => one("lst", Content::Listing(self)),
            Artifact::Svg if whole => all(self.plot()?),
            Artifact::Geometry => {
                let items = self.geometry.iter().map(|(n, v)| (n.as_str(), v));
                made("geometry.json", geometry_json(items).into_bytes())
            }
            Artifact::Deviation if whole => {
                let mut records = Vec::new();
                for part in &self.parts {
                    records.extend(part.computed.to_vec()?);
                }
                let svg = aptc_verify::deviation_svg(&records);
                svg.map_or_else(Vec::new, |s| made("deviation.svg", s.into_bytes()))
            }
            Artifact::Diagram => {
                let situation = self.situation.iter();
                situation.flat_map(|s| made("diagram.svg", s.svg().into_bytes())).collect()
            }
            _ => Vec::new(),
        })
    }

    fn write(&self, writer: &mut dyn RecordWriter) -> io::Result<()> {
        for part in &self.parts {
            part.edited.try_for_each(|record| writer.write(record))?;
        }
        writer.finish()
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

    fn plot(&self) -> io::Result<Vec<(String, Vec<u8>)>> {
        if self.parts.iter().all(|p| p.noplot) {
            return Ok(Vec::new());
        }
        let mut plot = Plot::new();
        for part in self.parts.iter().filter(|p| !p.noplot) {
            part.drawn.iter().for_each(|line| plot.line(line));
            part.edited.for_each(|record| plot.push(record))?;
        }
        Ok(vec![("svg".to_owned(), plot.finish().into_bytes())])
    }
}
