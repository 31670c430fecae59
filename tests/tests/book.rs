//! The book: each program in it compiles without an error, each link leads somewhere, no page is forgotten.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use aptc_control::{Memory, Options, Source};
use mdbook_driver::MDBook;

fn docs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs")
}

/// All pages but those of the messages, whose examples have mistakes; paths from `docs`.
fn pages() -> Vec<(String, String)> {
    let mut pages = Vec::new();
    for folder in ["", "formats", "language", "motion"] {
        for entry in fs::read_dir(docs().join(folder)).expect("the folder is there") {
            let path = entry.expect("an entry").path();
            if path.extension().is_some_and(|e| e == "md") {
                let text = fs::read_to_string(&path).expect("a page is text");
                let name = path.strip_prefix(docs()).expect("it lies there").display().to_string();
                pages.push((name, text));
            }
        }
    }
    pages.sort();
    pages
}

/// The blocks between "```apt" and "```" with the line on which each begins.
fn programs(page: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    let mut lines = page.lines().enumerate();
    while let Some((n, line)) = lines.next() {
        if line.trim_end() == "```apt" {
            let body: Vec<_> =
                lines.by_ref().map(|(_, l)| l).take_while(|l| !l.starts_with("```")).collect();
            found.push((n + 2, body.join("\n") + "\n"));
        }
    }
    found
}

/// The blocks between "```json NAME.json" and "```": files beside the programs of the page, each with the name
/// by which a program asks for it.
fn files(page: &str) -> Vec<(String, String)> {
    let blocks = page.split("\n```json ").skip(1);
    let file = |block: &str| {
        let (name, rest) = block.split_once('\n')?;
        let (text, _) = rest.split_once("```")?;
        Some((name.trim().trim_end_matches(".json").to_owned(), text.to_owned()))
    };
    blocks.filter_map(file).collect()
}

#[test]
fn each_program_of_the_book_compiles_and_is_proved() {
    let (mut n, mut faults) = (0, Vec::new());
    for (name, page) in pages() {
        for (line, text) in programs(&page) {
            n += 1;
            let source = Source { name: name.as_str().into(), text: text.into() };
            let mut beside = Memory { files: files(&page) };
            let compiled = aptc_control::compile(source, &mut beside, &Options::default());
            if compiled.has_errors() || compiled.is_refuted() {
                let told: Vec<_> = compiled.diagnostics.iter().filter(|d| d.is_error()).collect();
                faults.push(format!("{name}, program in line {line}: {told:#?}"));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(n >= 20, "only {n} programs were found");
}

#[test]
fn each_link_leads_to_a_file() {
    let mut dead = Vec::new();
    for (name, page) in pages() {
        let folder = docs().join(&name).parent().expect("a folder").to_owned();
        for link in links(&page) {
            let file = link.split('#').next().unwrap_or_default();
            if !file.is_empty() && !link.contains("://") && !folder.join(file).exists() {
                dead.push(format!("{name}: {link}"));
            }
        }
    }
    assert!(dead.is_empty(), "dead links: {dead:?}");
}

/// The whole book as its readers get it: every link and picture of every page is there.
#[test]
fn the_book_builds_and_nothing_in_it_leads_nowhere() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut book = MDBook::load(docs()).expect("the book can be read");
    book.config.build.build_dir = folder.path().to_path_buf();
    book.build().expect("the book can be built");
    let mut pages = BTreeMap::new();
    html_below(folder.path(), &mut pages);
    assert!(pages.len() > 200, "only {} pages", pages.len());
    let mut dead = BTreeSet::new();
    for (path, page) in &pages {
        for link in quoted(page, &[" href=\"", " src=\""]) {
            let (file, place) = link.split_once('#').unwrap_or((link, ""));
            if link.contains("://") || file.starts_with("mailto:") {
                continue;
            }
            let target = match file {
                "" => path.clone(),
                file => path.parent().expect("a page lies in a folder").join(file),
            };
            let there = target.canonicalize().is_ok_and(|target| {
                place.is_empty()
                    || pages
                        .get(&target)
                        .is_none_or(|page| quoted(page, &[" id=\""]).any(|id| id == place))
            });
            if !there {
                dead.insert(format!("{}: {link}", path.display()));
            }
        }
    }
    assert!(dead.is_empty(), "{dead:#?}");
}

/// All pages of a built book, by their whole paths.
fn html_below(folder: &Path, pages: &mut BTreeMap<PathBuf, String>) {
    for entry in fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("an entry").path().canonicalize().expect("it is there");
        if path.is_dir() {
            html_below(&path, pages);
        } else if path.extension().is_some_and(|e| e == "html") {
            let text = fs::read_to_string(&path).expect("a page is text");
            pages.insert(path, text);
        }
    }
}

/// What stands between quotes behind any of the beginnings.
fn quoted<'a>(page: &'a str, beginnings: &'a [&str]) -> impl Iterator<Item = &'a str> {
    let behind = |beginning: &'a &str| page.split(*beginning).skip(1);
    beginnings.iter().flat_map(behind).filter_map(|rest| Some(rest.split_once('"')?.0))
}

#[test]
fn the_summary_names_each_page_once() {
    let summary = fs::read_to_string(docs().join("SUMMARY.md")).expect("there is a summary");
    let named = links(&summary);
    let once: BTreeSet<_> = named.iter().cloned().collect();
    assert_eq!(once.len(), named.len(), "a page is named twice");
    let errors = fs::read_dir(docs().join("errors")).expect("the folder is there").flatten();
    let errors = errors.map(|entry| format!("errors/{}", entry.file_name().to_string_lossy()));
    let all: BTreeSet<_> =
        pages().into_iter().map(|p| p.0).chain(errors).filter(|p| p != "SUMMARY.md").collect();
    let forgotten: Vec<_> = all.difference(&once).collect();
    assert!(forgotten.is_empty(), "pages that the summary forgets: {forgotten:?}");
}

#[test]
fn the_index_of_errors_names_each_page_with_its_title() {
    let index = fs::read_to_string(docs().join("errors.md")).expect("there is an index");
    let mut missing = Vec::new();
    for entry in fs::read_dir(docs().join("errors")).expect("the folder is there").flatten() {
        let text = fs::read_to_string(entry.path()).expect("a page is text");
        let heading = text.lines().next().unwrap_or_default().trim_start_matches("# ");
        let Some((code, title)) = heading.split_once(": ") else { continue };
        let line = format!("| [{code}](errors/{code}.md) | {title} |");
        if !index.lines().any(|l| l == line) {
            missing.push(line);
        }
    }
    missing.sort();
    assert!(missing.is_empty(), "lines that docs/errors.md lacks:\n{}", missing.join("\n"));
}

#[test]
fn the_limits_of_the_book_are_those_of_the_program() {
    let page = fs::read_to_string(docs().join("limits.md")).expect("the page is there");
    let limits = aptc_translate::Limits::default();
    let proof = aptc_control::FULL_PROOF;
    let number = |n: usize| u64::try_from(n).expect("a limit");
    let defaults = [
        ("--max-statements", limits.statements),
        ("--max-macro-depth", number(limits.macro_depth)),
        ("--max-include-depth", number(limits.include_depth)),
        ("--max-array-elements", number(limits.array_elements)),
        ("--max-points", number(limits.points)),
        ("lines of PRINT", number(limits.printed)),
        ("brackets within each other", number(limits.bracket_depth)),
        ("words, numbers and signs", number(limits.elements)),
        ("messages shown", number(limits.messages)),
        ("cut vectors proved one by one", proof),
    ];
    for (what, value) in defaults {
        let line = page.lines().find(|l| l.contains(what)).unwrap_or_else(|| panic!("no {what}"));
        let told: String = line.chars().filter(|c| *c != ',').collect();
        assert!(told.contains(&format!("| {value} |")), "{what} is {value}: {line}");
    }
}

/// Targets of `[..](target)`, code blocks left out.
fn links(page: &str) -> Vec<String> {
    let mut code = false;
    let mut found = Vec::new();
    for line in page.lines() {
        if line.starts_with("```") {
            code = !code;
        }
        let mut rest = if code { "" } else { line };
        while let Some((_, after)) = rest.split_once("](") {
            let Some((target, tail)) = after.split_once(')') else { break };
            found.push(target.to_owned());
            rest = tail;
        }
    }
    found
}
