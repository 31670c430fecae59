//! What formatting and lints cannot hold: the plan of the house.
//!
//! `graph` compares the crates' dependencies with the plan, `source` looks at each Rust file (size, banned
//! functions, order), `texts` at every file under version control, `codes` at the pages of the errors.

mod codes;
mod graph;
mod source;
mod texts;

/// Something out of order, as `place: what`.
type Finding = String;

/// Runs all checks and prints what they found.
pub(crate) fn run() -> Result<(), String> {
    let findings = findings()?;
    for finding in &findings {
        println!("{finding}");
    }
    match findings.len() {
        0 => Ok(()),
        n => Err(format!("tidy: {n} findings")),
    }
}

fn findings() -> Result<Vec<Finding>, String> {
    Ok([graph::check()?, source::check()?, texts::check()?, codes::check()?].concat())
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_repository_is_tidy() {
        let findings = super::findings().expect("the repository can be read");
        assert!(findings.is_empty(), "{}", findings.join("\n"));
    }
}
