//! The crate graph: who may depend on whom.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::Value;

use super::Finding;
use crate::repository::cargo;

/// The edges of ARCHITECTURE.md. A crate may also use whatever those it names may use.
const EDGES: [(&str, &[&str]); 19] = [
    ("aptc-vocabulary", &[]),
    ("aptc-diagnostics", &[]),
    ("aptc-geometry", &[]),
    ("aptc-contact", &["aptc-geometry"]),
    ("aptc-exchange", &["aptc-geometry"]),
    ("aptc-protap", &["aptc-geometry", "aptc-vocabulary", "aptc-diagnostics"]),
    ("aptc-cldata", &["aptc-geometry", "aptc-vocabulary", "aptc-diagnostics"]),
    ("aptc-syntax", &["aptc-vocabulary", "aptc-diagnostics"]),
    ("aptc-translate", &["aptc-syntax", "aptc-protap", "aptc-exchange"]),
    ("aptc-arelem", &["aptc-protap", "aptc-cldata", "aptc-contact"]),
    ("aptc-regional", &["aptc-protap", "aptc-cldata", "aptc-contact"]),
    ("aptc-edit", &["aptc-cldata"]),
    ("aptc-post", &["aptc-cldata"]),
    // Never `aptc-contact`: two independent ways to an answer are what makes a proof worth something.
    ("aptc-verify", &["aptc-protap", "aptc-cldata"]),
    (
        "aptc-control",
        &[
            "aptc-translate",
            "aptc-arelem",
            "aptc-regional",
            "aptc-edit",
            "aptc-post",
            "aptc-verify",
        ],
    ),
    ("aptc-golden", &["aptc-control"]),
    ("aptc-tests", &["aptc-golden"]),
    ("aptc", &["aptc-golden"]),
    // Processor time is measured in one way only.
    ("xtask", &["aptc-testkit"]),
];

/// Libraries that one room keeps to itself, so that they can be exchanged there.
const KEPT: [(&str, &[&str]); 8] = [
    ("logos", &["aptc-syntax"]),
    ("chumsky", &["aptc-syntax"]),
    ("ariadne", &["aptc"]),
    ("clap", &["aptc"]),
    ("clap_complete", &["aptc"]),
    ("clap_mangen", &["aptc"]),
    ("indicatif", &["aptc"]),
    ("tempfile", &["aptc", "aptc-control", "aptc-tests"]),
];

/// What only tests use; any crate may have it as a development dependency.
const FOR_TESTS: [&str; 4] = ["aptc-testkit", "proptest", "tempfile", "serde_json"];

/// Edges that are not in the plan.
pub(super) fn check() -> Result<Vec<Finding>, String> {
    let output = cargo()
        .args(["metadata", "--no-deps", "--format-version", "1", "--offline"])
        .output()
        .map_err(|error| format!("cargo does not start: {error}"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    let metadata: Value = serde_json::from_slice(&output.stdout).map_err(|e| e.to_string())?;
    let packages = metadata["packages"].as_array().ok_or("cargo metadata lists no packages")?;
    Ok(packages.iter().flat_map(package_findings).collect())
}

fn package_findings(package: &Value) -> Vec<Finding> {
    let name = package["name"].as_str().unwrap_or_default();
    if name == "aptc-testkit" {
        return Vec::new();
    }
    let Some(allowed) = allowed(name) else {
        return vec![format!("{name}: the crate is not in the plan (xtask/src/tidy/graph.rs)")];
    };
    let mut findings = Vec::new();
    for dependency in package["dependencies"].as_array().into_iter().flatten() {
        let used = dependency["name"].as_str().unwrap_or_default();
        let in_tests = dependency["kind"].as_str() == Some("dev");
        if in_tests && FOR_TESTS.contains(&used) {
            continue;
        }
        let ours = dependency["path"].is_string();
        if ours && !allowed.contains(used) {
            findings.push(format!("{name}: depends on {used}, which the plan does not allow"));
        }
        let kept = KEPT.iter().find(|(library, _)| *library == used);
        if kept.is_some_and(|(_, rooms)| !rooms.contains(&name)) {
            findings.push(format!("{name}: {used} belongs to another room"));
        }
    }
    findings
}

/// All crates that the plan lets `name` use; the test crate may also use the test kit.
fn allowed(name: &str) -> Option<BTreeSet<&'static str>> {
    let edges: BTreeMap<&str, &[&str]> = EDGES.into_iter().collect();
    let mut waiting: Vec<&'static str> = edges.get(name)?.to_vec();
    let mut allowed = BTreeSet::new();
    if name == "aptc-tests" {
        allowed.insert("aptc-testkit");
    }
    while let Some(next) = waiting.pop() {
        if allowed.insert(next) {
            waiting.extend(edges.get(next).copied().unwrap_or_default());
        }
    }
    if name == "aptc-verify" {
        allowed.remove("aptc-contact");
    }
    Some(allowed)
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn findings(name: &str, used: &str, kind: Option<&str>) -> usize {
        let dependency = json!({ "name": used, "kind": kind, "path": "/somewhere" });
        package_findings(&json!({ "name": name, "dependencies": [dependency] })).len()
    }

    #[test]
    fn edges_run_down_only() {
        assert_eq!(findings("aptc-arelem", "aptc-contact", None), 0);
        assert_eq!(findings("aptc-arelem", "aptc-vocabulary", None), 0);
        assert_eq!(findings("aptc-arelem", "aptc-translate", None), 1);
        assert_eq!(findings("aptc-arelem", "aptc-translate", Some("dev")), 1);
        assert_eq!(findings("aptc-arelem", "aptc-testkit", Some("dev")), 0);
        assert_eq!(findings("aptc-arelem", "aptc-testkit", None), 1);
        assert_eq!(findings("aptc-verify", "aptc-contact", None), 1);
        assert_eq!(findings("aptc-post", "aptc-syntax", None), 1);
        assert_eq!(findings("aptc-control", "aptc-contact", None), 0);
        assert_eq!(findings("aptc-viewer", "aptc-cldata", None), 1);
    }

    #[test]
    fn libraries_stay_in_their_room() {
        assert_eq!(findings("aptc-control", "ariadne", None), 2);
        let chumsky = json!({ "name": "aptc-translate", "dependencies": [{ "name": "chumsky" }] });
        assert_eq!(package_findings(&chumsky).len(), 1);
    }
}
