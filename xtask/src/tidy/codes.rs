//! Every code of a diagnostic has its page, and every page its code.

use std::collections::BTreeMap;

use super::Finding;
use crate::repository::{files, read, root};

const REGISTRY: &str = "crates/diagnostics/src/codes/";
const PAGES: &str = "docs/errors/APT";

/// Codes without a page, pages without a code, titles that differ.
pub(super) fn check() -> Result<Vec<Finding>, String> {
    let mut titles = BTreeMap::new();
    let mut pages = BTreeMap::new();
    for path in files()? {
        let name = path.to_string_lossy().replace('\\', "/");
        if name.starts_with(REGISTRY) {
            titles.extend(read(&root().join(&path))?.lines().filter_map(registered));
        } else if let Some(number) = name.strip_prefix(PAGES).and_then(|n| n.strip_suffix(".md")) {
            let text = read(&root().join(&path))?;
            pages.insert(number.to_owned(), text.lines().next().unwrap_or_default().to_owned());
        }
    }
    Ok(compare(&titles, &pages))
}

/// Number and title of a registry line: `FILE_TOO_LARGE = 3, "a file is larger than the limit";`
fn registered(line: &str) -> Option<(String, String)> {
    let (name, rest) = line.trim().split_once(" = ")?;
    let (number, title) = rest.split_once(", \"")?;
    let spelled = name.bytes().all(|b| b.is_ascii_uppercase() || b.is_ascii_digit() || b == b'_');
    let number: u16 = number.parse().ok().filter(|_| spelled)?;
    Some((format!("{number:04}"), title.strip_suffix("\";")?.to_owned()))
}

fn compare(titles: &BTreeMap<String, String>, pages: &BTreeMap<String, String>) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (number, title) in titles {
        match pages.get(number) {
            None => findings.push(format!("{PAGES}{number}.md: the code has no page")),
            Some(heading) if *heading != format!("# APT{number}: {title}") => findings.push(
                format!("{PAGES}{number}.md:1: `{heading}` should be `# APT{number}: {title}`"),
            ),
            Some(_) => {}
        }
    }
    let orphans = pages.keys().filter(|number| !titles.contains_key(*number));
    findings.extend(orphans.map(|number| format!("{PAGES}{number}.md: the page has no code")));
    findings
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn registry_lines_are_read() {
        let line = "    FILE_TOO_LARGE = 3, \"a file is larger than the limit\";";
        let read = ("0003".to_owned(), "a file is larger than the limit".to_owned());
        assert_eq!(registered(line), Some(read));
        assert_eq!(registered("    FILES:"), None);
    }

    #[test]
    fn codes_and_pages_pair() {
        let one = |number: &str, text: &str| BTreeMap::from([(number.to_owned(), text.to_owned())]);
        assert_eq!(
            compare(&one("0003", "too large"), &one("0003", "# APT0003: too large")).len(),
            0
        );
        assert_eq!(compare(&one("0003", "too large"), &one("0003", "# APT0003: large")).len(), 1);
        assert_eq!(
            compare(&one("0003", "too large"), &one("0004", "# APT0004: too large")).len(),
            2
        );
    }
}
