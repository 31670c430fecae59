//! Reads the files named on the command line and prints their messages and, with `-v`, their trees.

use aptc_diagnostics::SourceMap;
use aptc_syntax::{Interner, Options, parse};

fn main() {
    let (mut verbose, mut shown) = (false, String::new());
    for name in std::env::args().skip(1) {
        if name == "-v" {
            verbose = true;
            continue;
        }
        let Ok(bytes) = std::fs::read(&name) else {
            shown += &format!("{name}: cannot be read\n");
            continue;
        };
        let text = String::from_utf8_lossy(&bytes).into_owned();
        let mut map = SourceMap::default();
        let file = map.add(name.clone(), text.clone());
        let mut interner = Interner::default();
        let options =
            Options { free_form: std::env::var_os("FREE").is_some(), ..Options::default() };
        let parsed = parse(file, &text, &mut interner, &options);
        let (n, m) = (parsed.program.statements.len(), parsed.diagnostics.len());
        shown += &format!("{name}: {n} statements, {m} messages\n");
        for d in &parsed.diagnostics {
            let (line, column) = map.line_column(file, d.span.start);
            let help = d.help.as_deref().unwrap_or_default();
            shown +=
                &format!("  {line}:{column} {} {} | {} | {help}\n", d.code, d.message, d.label);
        }
        if verbose {
            for statement in &parsed.program.statements {
                shown += &format!("{statement:?}\n");
            }
        }
    }
    #[expect(clippy::print_stdout, reason = "this is what the example is for")]
    {
        print!("{shown}");
    }
}
