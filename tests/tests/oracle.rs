//! Part programs that nobody here wrote, against the answers of APT-360.
//!
//! They lie beside the project, in `../shared`, and are not part of it: where the folder is absent the tests
//! say so and pass. Programs that do not agree yet stand by name in `shared-failures.toml`; one that begins
//! to agree fails the run until its line is removed.
#![expect(clippy::print_stdout, reason = "what is known or blessed is told")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use aptc_control::{Artifact, Compiled, Disk, Options};

fn shared() -> Option<PathBuf> {
    aptc_testkit::shared("oracle of APT-360", "oracle").and_then(|o| o.parent().map(Path::to_owned))
}

/// Name and reason of what does not agree yet, for one kind of comparison.
fn known(kind: &str) -> BTreeMap<String, String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("shared-failures.toml");
    let text = fs::read_to_string(path).expect("shared-failures.toml stands beside the tests");
    let mut all: BTreeMap<String, BTreeMap<String, String>> =
        toml::from_str(&text).expect("shared-failures.toml is TOML");
    all.remove(kind).unwrap_or_default()
}

fn compile(program: &Path, shared: &Path) -> Compiled {
    let source = Disk::open(program, 1 << 24).expect("the program can be read");
    let library = shared.join("corpus/apt360/maclib");
    let folder = program.parent().expect("it lies in a folder").to_owned();
    let mut world = Disk::new(vec![folder, library], 1 << 24);
    let options = Options { post: false, plot: false, ..Options::default() };
    aptc_control::compile(source, &mut world, &options)
}

/// Runs a comparison over all programs that have an oracle and holds the result against the list.
fn hold(
    kind: &str,
    oracle_ending: &str,
    compare: impl Fn(&Path, &Path, &Path, &str) -> Result<(), String>,
) {
    let Some(shared) = shared() else { return };
    let mut known = known(kind);
    let mut faults = Vec::new();
    let mut names: Vec<String> = fs::read_dir(shared.join("corpus/apt360"))
        .expect("the corpus is there")
        .flatten()
        .filter_map(|e| e.file_name().into_string().ok())
        .filter_map(|n| n.strip_suffix(".apt").map(str::to_owned))
        .filter(|n| shared.join(format!("oracle/apt360/{n}{oracle_ending}")).is_file())
        .collect();
    names.sort();
    assert!(names.len() > 15, "the oracle has programs");
    for name in names {
        let program = shared.join(format!("corpus/apt360/{name}.apt"));
        let oracle = shared.join(format!("oracle/apt360/{name}{oracle_ending}"));
        match (compare(&shared, &program, &oracle, &name), known.remove(&name)) {
            (Ok(()), None) => {}
            (Ok(()), Some(_)) => faults.push(format!("{name} agrees now: remove it from the list")),
            (Err(_), Some(reason)) => println!("known: {name}: {reason}"),
            (Err(e), None) => faults.push(format!("{name}: {e}")),
        }
    }
    faults.extend(known.into_keys().map(|n| format!("{n} is on the list and nowhere else")));
    assert!(faults.is_empty(), "{kind}:\n{}", faults.join("\n"));
}

fn python(arguments: &[&std::ffi::OsStr]) -> Result<(), String> {
    let out = Command::new("python3").args(arguments).output().map_err(|e| e.to_string())?;
    if out.status.success() {
        return Ok(());
    }
    let text = String::from_utf8_lossy(&out.stdout);
    let bad = text.lines().filter(|l| !l.starts_with("ok ")).collect::<Vec<_>>();
    Err(format!("{}{}", bad.join("\n  "), String::from_utf8_lossy(&out.stderr)))
}

fn one_artifact(compiled: &Compiled, kind: Artifact, folder: &Path) -> Result<PathBuf, String> {
    let made = compiled.artifact(kind, true).map_err(|error| error.to_string())?;
    let (ending, bytes) = made.into_iter().next().ok_or("nothing made")?;
    let path = folder.join(format!("x.{ending}"));
    fs::write(&path, bytes).map_err(|e| e.to_string())?;
    Ok(path)
}

#[test]
fn canonical_forms_agree() {
    let dir = tempfile::tempdir().expect("a folder for results");
    hold("geometry", ".geometry.json", |shared, program, oracle, _| {
        let ours = one_artifact(&compile(program, shared), Artifact::Geometry, dir.path())?;
        let tool = shared.join("tools/compare_geometry.py");
        python(&[tool.as_os_str(), ours.as_os_str(), oracle.as_os_str()])
    });
}

#[test]
fn paths_agree() {
    let dir = tempfile::tempdir().expect("a folder for results");
    hold("path", ".json", |shared, program, oracle, _| {
        let compiled = compile(program, shared);
        if let Some(e) = compiled.diagnostics.iter().find(|d| d.is_error()) {
            return Err(format!("{}: {}", e.code, e.message));
        }
        let ours = one_artifact(&compiled, Artifact::Cl, dir.path())?;
        let tool = shared.join("tools/compare.py");
        python(&[
            tool.as_os_str(),
            "--ours".as_ref(),
            ours.as_os_str(),
            "--expected".as_ref(),
            oracle.as_os_str(),
            "--program".as_ref(),
            program.as_os_str(),
            "--max-ratio".as_ref(),
            "1".as_ref(),
        ])
    });
}
