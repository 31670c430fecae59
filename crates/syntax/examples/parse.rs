//! Reads the files named on the command line and prints their messages and, with `-v`, their trees.

use aptc_diagnostics::SourceMap;
use aptc_syntax::{Interner, Options, parse};

fn main() {
    let mut verbose = false;
    for name in std::env::args().skip(1) {
        if name == "-v" {
            verbose = true;
            continue;
        }
        let Ok(bytes) = std::fs::read(&name) else { continue };
        let text = String::from_utf8_lossy(&bytes).into_owned();
        let mut map = SourceMap::default();
        let file = map.add(name.clone(), text.clone());
        let mut interner = Interner::default();
        let parsed = parse(file, &text, &mut interner, &Options::default());
        println!(
            "{name}: {} statements, {} messages",
            parsed.program.statements.len(),
            parsed.diagnostics.len()
        );
        for d in &parsed.diagnostics {
            let (line, column) = map.line_column(file, d.span.start);
            println!(
                "  {line}:{column} {} {} [{}] {:?}",
                d.code,
                d.message,
                &text[d.span.start as usize..d.span.end as usize],
                d.help
            );
        }
        if verbose {
            for s in &parsed.program.statements {
                println!("{s:?}");
            }
        }
    }
}
