//! Chores of this repository, run as `cargo xtask <chore>`.
#![expect(clippy::print_stderr, reason = "xtask talks to its terminal")]

mod codegen;
mod root;

use std::process::ExitCode;

const USAGE: &str = "\
cargo xtask <chore>

  codegen [--check]   write crates/vocabulary/src/table.rs from words.tsv, or fail when it is stale
";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let outcome = match words.as_slice() {
        ["codegen"] => codegen::run(codegen::Mode::Write),
        ["codegen", "--check"] => codegen::run(codegen::Mode::Check),
        _ => {
            eprint!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("xtask: {message}");
            ExitCode::FAILURE
        }
    }
}
