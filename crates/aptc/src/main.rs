//! The APT part program compiler: commands, options, terminal, files.

mod cli;
mod commands;
mod exit;
mod explain;
mod input;
mod output;
mod plain;
mod progress;
mod render;
mod report;

use std::io;
use std::process::ExitCode;

use clap::Parser as _;

use cli::{Cli, Command};

fn main() -> ExitCode {
    let cli = Cli::parse();
    let result = match &cli.command {
        None => commands::compile(&cli.compile, &cli.common),
        Some(Command::Compile(args)) => commands::compile(args, &cli.common),
        Some(Command::Check(args)) => commands::check(args, &cli.common),
        Some(Command::Verify(args)) => commands::verify(args, &cli.common),
        Some(Command::Post(args)) => commands::post(args, &cli.common),
        Some(Command::Test(args)) => commands::test(args, &cli.common),
        Some(Command::Fmt(args)) => commands::fmt(args),
        Some(Command::Convert(args)) => commands::convert(args, &cli.common),
        Some(Command::Cldiff(args)) => commands::cldiff(args, &cli.common),
        Some(Command::Stats(args)) => commands::stats(args, &cli.common),
        Some(Command::Explain { code }) => explain::explain(code.as_deref()),
        Some(Command::Machines { machine }) => commands::machines(machine.as_deref(), &cli.common),
        Some(Command::Completions { shell }) => commands::completions(*shell),
        Some(Command::Man { output }) => commands::man(output),
    };
    match result {
        Ok(code) => code,
        // Somebody closed the pipe: nothing to say, nobody to say it to.
        Err(e) if e.kind() == io::ErrorKind::BrokenPipe => ExitCode::from(exit::FILES),
        Err(e) => report::complain(&e.to_string()).unwrap_or(ExitCode::from(exit::FILES)),
    }
}
