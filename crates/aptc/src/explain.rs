//! `aptc explain`: the pages of `docs/errors`, and what is known of a word.

use std::io::{self, Write};
use std::process::ExitCode;

use aptc_diagnostics::codes;

use crate::exit;

/// (code, page) in order of code.
const PAGES: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/pages.rs"));

/// Prints the page of a code or a word, or the list of codes.
pub(crate) fn explain(code: Option<&str>) -> io::Result<ExitCode> {
    let mut out = io::stdout().lock();
    let Some(text) = code else {
        for (code, title) in codes::all() {
            writeln!(out, "{code}  {title}")?;
        }
        return Ok(exit::GOOD);
    };
    let Some(code) = codes::Code::parse(text) else {
        if let Some(page) = aptc_control::about(text) {
            write!(out, "{page}")?;
            return Ok(exit::GOOD);
        }
        let near = aptc_control::near_word(text)
            .map_or_else(String::new, |near| format!("; did you mean {near}?"));
        writeln!(
            io::stderr(),
            "aptc: {text} is no code and no word{near}; `aptc explain` lists all codes"
        )?;
        return Ok(ExitCode::from(exit::FILES));
    };
    let name = code.to_string();
    match PAGES.iter().find(|(n, _)| *n == name) {
        Some((_, page)) => write!(out, "{page}")?,
        None => writeln!(out, "# {code}: {}", code.title())?,
    }
    Ok(exit::GOOD)
}
