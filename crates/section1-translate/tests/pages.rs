//! Each message of names, control flow and statements has a page whose example triggers it.

mod support;

use std::fs;

use aptc_diagnostics::codes;

const PAGES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/errors");

#[test]
fn the_example_of_each_page_is_true() {
    let mut n = 0;
    for (code, title) in codes::all() {
        if !matches!(code.number(), 1050..=1399) {
            continue;
        }
        let page = fs::read_to_string(format!("{PAGES}/{code}.md")).expect("a page of each code");
        assert_eq!(page.lines().next(), Some(format!("# {code}: {title}").as_str()));
        if page.contains("\nno example: ") {
            continue;
        }
        let example = page.split("```apt\n").nth(1).and_then(|p| p.split("```").next());
        let ran = support::run(example.expect("an example or a reason for none"));
        let told: Vec<u16> = ran.diagnostics.iter().map(|d| d.code.number()).collect();
        assert_eq!(told, [code.number()], "{code}\n{}", ran.messages());
        n += 1;
    }
    assert!(n > 40, "{n} pages");
}
