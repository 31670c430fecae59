//! Chores of this repository, run as `cargo xtask <chore>`.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "xtask talks to its terminal")]

mod bench;
mod bless;
mod ci;
mod clients;
mod codegen;
mod fuzz;
mod mutate;
mod package;
mod peers;
mod random;
mod repository;
mod test;
mod tidy;

use std::process::ExitCode;

const USAGE: &str = "\
cargo xtask <chore>

  test                all tests; installs the clients they need where it may
  ci                  formatting, lints, documentation, tidy, codegen, then test
  tidy                crate graph, file sizes, banned functions and words
  bless [FILTER]      write the goldens of the corpus anew
  mutate [N] [--seed S]
                      N one-token changes of corpus programs (1,000): panics, hangs, and how often the
                      first message stands on the changed statement
  fuzz [SECONDS] [TARGET]
                      each fuzz target for a time (60 s); needs cargo-fuzz
  bench [FILTER] [--runs N]
                      benchmarks; medians into docs/performance.md when all are run
  peers               regional milling on the surface of ../shared/peers, judged by its exact heights
  package             static tarball and .deb with manual pages and completions, in target/package
  codegen [--check]   write the word tables and the editors' grammars from words.tsv, or fail when stale
";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    if words.iter().any(|w| ["help", "--help", "-h"].contains(w)) {
        println!("{}", USAGE.trim_end());
        return ExitCode::SUCCESS;
    }
    let outcome = match words.as_slice() {
        ["test"] => test::run(),
        ["ci"] => ci::run(),
        ["tidy"] => tidy::run(),
        ["bless", options @ ..] => bless::run(options),
        ["bench", options @ ..] => bench::run(options),
        ["fuzz", options @ ..] => fuzz::run(options),
        ["mutate", options @ ..] => mutate::run(options),
        ["peers"] => peers::run(),
        ["package"] => package::run(),
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
