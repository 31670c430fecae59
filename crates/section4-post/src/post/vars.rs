//! Values that the templates of a machine file may use.

use super::{Post, trimmed};

impl Post {
    /// Values that every template may use.
    pub(crate) fn common_vars(&self) -> Vars {
        let p = &self.machine.program;
        let mm = self.st.path_tolerance_mm.unwrap_or(p.path_tolerance);
        let tolerance = if mm > 0.0 {
            let places = if self.st.inch { 5 } else { 4 };
            trimmed(mm / self.st.out_mm(), places)
        } else {
            String::new()
        };
        let path_mode =
            crate::emit::render(&p.path_mode, &[("tolerance", &tolerance)]).unwrap_or_default();
        Vars {
            part: self.st.partno.clone(),
            machine: self.machine.title.clone(),
            units: if self.st.inch { p.inch.clone() } else { p.metric.clone() },
            work_offset: self.options.work_offset.clone().unwrap_or_else(|| p.work_offset.clone()),
            path_mode,
            number: if p.number == 0 { String::new() } else { format!("{:04}", p.number) },
            name: program_name(&self.st.partno),
        }
    }
}

/// Values that every template may use.
pub(crate) struct Vars {
    part: String,
    machine: String,
    units: String,
    pub(super) work_offset: String,
    pub(crate) path_mode: String,
    number: String,
    name: String,
}

impl Vars {
    pub(crate) fn list(&self) -> Vec<(&'static str, &str)> {
        vec![
            ("part", &self.part),
            ("machine", &self.machine),
            ("units", &self.units),
            ("work_offset", &self.work_offset),
            ("path_mode", &self.path_mode),
            ("number", &self.number),
            ("name", &self.name),
        ]
    }
}

/// A name that every control takes: letters and digits of PARTNO.
fn program_name(part: &str) -> String {
    let name: String = part
        .to_ascii_uppercase()
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() { c } else { '_' })
        .collect();
    let words: Vec<&str> = name.split('_').filter(|w| !w.is_empty()).collect();
    let name: String = words.join("_").chars().take(24).collect();
    if name.is_empty() { "PART".into() } else { name }
}
