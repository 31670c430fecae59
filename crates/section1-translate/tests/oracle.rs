//! The canonical forms that APT-360 gave for the same programs.
//!
//! The files are not part of this project; without them the test says so and passes.

mod support;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use aptc_protap::Outcome;
use aptc_translate::{FileError, FileRequest, Files, LoadedFile, Options};
use serde_json::Value;

const SHARED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared");

/// The system macros beside the programs.
struct Library;

impl Files for Library {
    fn read(&mut self, request: &FileRequest) -> Result<LoadedFile, FileError> {
        let path = format!("{SHARED}/corpus/apt360/maclib/{}", request.name);
        match fs::read_to_string(&path) {
            Ok(text) => Ok(LoadedFile { name: path.into(), text: text.into() }),
            Err(why) => Err(FileError {
                code: aptc_diagnostics::codes::NOT_READ,
                message: format!("{path}: {why}"),
                help: None,
            }),
        }
    }
}

fn numbers(values: &Value) -> Vec<f64> {
    values.as_array().into_iter().flatten().filter_map(Value::as_f64).collect()
}

/// Alike to a millionth of the size.
fn close(a: &[f64], b: &[f64]) -> bool {
    let size = b.iter().fold(1.0, |s: f64, x| s.max(x.abs()));
    a.len() == b.len() && a.iter().zip(b).all(|(x, y)| (x - y).abs() <= 1e-6 * size)
}

/// Surfaces whose sign says nothing.
const UNSIGNED: &[&str] = &["LINE", "PLANE", "QADRIC", "GCONIC", "LCONIC", "ELLIPS", "HYPERB"];

fn agrees(kind: &str, ours: &[f64], expected: &Value) -> bool {
    if matches!(kind, "TABCYL" | "RLDSRF" | "POLCON") {
        return true; // The old fit stops early; the motion along them is compared instead.
    }
    if let Some(points) = expected["points"].as_array() {
        return ours.len() == 3 * points.len()
            && ours.chunks(3).zip(points).all(|(p, q)| close(p, &numbers(q)));
    }
    let words = numbers(&expected["words"]);
    let turned: Vec<f64> = ours.iter().map(|x| -x).collect();
    close(ours, &words) || UNSIGNED.contains(&kind) && close(&turned, &words)
}

/// Programs with a name whose form differs for a reason.
const EXCEPTIONS: &[(&str, &str, &str)] = &[
    ("case4axis", "L13", "through C5 it has x = .3675; the old answer misses that point by .12"),
    ("case4axis", "L6B", "likewise: a tilted line was taken without its length"),
    ("cone", "Y", "exactly 0 after 33 turns; the old degrees are good to 1e-8 only"),
];

#[test]
fn final_forms_are_those_of_apt_360() {
    let folder = format!("{SHARED}/oracle/apt360");
    if !Path::new(&folder).is_dir() {
        println!("no {folder}: skipped");
        return;
    }
    let (mut n, mut wrong) = (0, Vec::new());
    let mut files: Vec<_> = fs::read_dir(&folder)
        .unwrap()
        .map(|f| f.unwrap().file_name().into_string().unwrap())
        .collect();
    files.sort();
    for file in files {
        let Some(program) = file.strip_suffix(".geometry.json") else { continue };
        let text = fs::read(format!("{SHARED}/corpus/apt360/{program}.apt")).unwrap();
        let text: String = text.into_iter().map(char::from).collect();
        let ran = support::run_with(&text, &mut Library, Options::default(), |_| Outcome::None);
        let ours: BTreeMap<String, (&str, Vec<f64>)> = ran
            .geometry
            .iter()
            .map(|(name, form)| {
                let key = match name.subscript {
                    0 => name.name.to_string(),
                    i => format!("{}({i})", name.name),
                };
                (key, (form.word(), form.elements()))
            })
            .collect();
        let expected: Value =
            serde_json::from_str(&fs::read_to_string(format!("{folder}/{file}")).unwrap()).unwrap();
        for (name, form) in expected.as_object().unwrap() {
            n += 1;
            let name = name.to_uppercase();
            let kind = form["type"].as_str().unwrap_or_default();
            let good = ours.get(&name).is_some_and(|(k, e)| *k == kind && agrees(kind, e, form));
            let known = EXCEPTIONS.iter().any(|(p, m, _)| *p == program && *m == name);
            if good == known {
                wrong.push(format!("{program} {name}: {:?} instead of {form}", ours.get(&name)));
            }
        }
        let errors: Vec<_> = ran.diagnostics.iter().filter(|d| d.is_error()).collect();
        assert!(errors.is_empty(), "{program}\n{}", ran.messages());
    }
    assert!(wrong.is_empty(), "{} of {n}:\n{}", wrong.len(), wrong.join("\n"));
    assert!(n >= 200, "{n} forms");
}
