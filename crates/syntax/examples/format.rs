//! Prints the file named on the command line in the one style.

use aptc_syntax::{FormatOptions, format};

fn main() {
    for name in std::env::args().skip(1) {
        let text = std::fs::read_to_string(&name).unwrap_or_default();
        #[expect(clippy::print_stdout, reason = "this is what the example is for")]
        {
            print!("{}", format(&text, &FormatOptions::default()));
        }
    }
}
