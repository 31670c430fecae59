//! The pages of `docs/errors`: the example of each gives its code, and no other.
//!
//! A page shows its example as a block ` ```apt `, ` ```cl ` or ` ```protap `, with options of the command line
//! behind it. Blocks with a file's name behind the language are files beside the example. A page that can have
//! no example gives the reason in a line `no example: ...`.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use aptc_diagnostics::codes::{self, Code};
use serde_json::Value;

/// A fenced block of a page.
struct Block<'a> {
    language: &'a str,
    info: Vec<&'a str>,
    text: &'a str,
}

impl Block<'_> {
    fn file(&self) -> Option<&str> {
        self.info.first().copied().filter(|word| !word.starts_with('-'))
    }
}

fn blocks(page: &str) -> Vec<Block<'_>> {
    let mut found = Vec::new();
    let mut rest = page;
    while let Some((_, after)) = rest.split_once("\n```") {
        let Some((head, body)) = after.split_once('\n') else { break };
        let Some((text, after)) = body.split_once("```") else { break };
        let mut words = head.split_whitespace();
        let language = words.next().unwrap_or_default();
        found.push(Block { language, info: words.collect(), text });
        rest = after;
    }
    found
}

/// Codes that the example of a page gives; notes only where the page is of one.
fn told(code: Code, page: &str) -> Vec<String> {
    let dir = tempfile::tempdir().expect("a folder");
    let folder = dir.path().join("part");
    fs::create_dir(&folder).expect("a folder");
    let blocks = blocks(page);
    for (block, file) in blocks.iter().filter_map(|block| Some((block, block.file()?))) {
        fs::write(folder.join(file), block.text).expect("it is written");
    }
    let is_example = |block: &&Block<'_>| {
        matches!(block.language, "apt" | "cl" | "protap") && block.file().is_none()
    };
    let Some(example) = blocks.iter().find(is_example) else {
        return vec!["no example and no reason".to_owned()];
    };
    let name = format!("program.{}", example.language);
    fs::write(folder.join(&name), example.text).expect("it is written");
    let command = match example.language {
        "cl" => "post",
        _ if example.info.contains(&"--cl") => "verify",
        _ => "compile",
    };
    let mut arguments = vec![command, &name];
    arguments.extend(&example.info);
    // Which machine it is matters in few pages.
    let chosen = example.info.contains(&"--machine") || example.text.contains("MACHIN/");
    if !chosen && command != "verify" && code != codes::MACHINE_ASSUMED {
        arguments.extend(["--machine", "linuxcnc-mill"]);
    }
    let messages = run(&folder, &arguments);
    let note = messages.iter().all(|m| m["severity"] == "note");
    let codes = messages.iter().filter(|m| note || m["severity"] != "note");
    codes.map(|m| m["code"].as_str().unwrap_or_default().to_owned()).collect()
}

fn run(folder: &Path, arguments: &[&str]) -> Vec<Value> {
    let output = Command::new(env!("CARGO_BIN_EXE_aptc"))
        .args(arguments)
        .args(["--message-format", "json"])
        .current_dir(folder)
        .output()
        .expect("the program starts");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    said.lines().filter_map(|line| serde_json::from_str(line).ok()).collect()
}

#[test]
fn the_example_of_each_page_gives_its_code_and_no_other() {
    let pages = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/errors");
    let (mut wrong, mut without) = (Vec::new(), Vec::new());
    for (code, title) in codes::all() {
        let page = fs::read_to_string(pages.join(format!("{code}.md"))).expect("a page each code");
        assert_eq!(page.lines().next(), Some(format!("# {code}: {title}").as_str()));
        if page.contains("\nno example: ") {
            without.push(code.to_string());
            continue;
        }
        let told = told(code, &page);
        if told != [code.to_string()] {
            wrong.push(format!("{code} gives {told:?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(without.len() <= MOST_WITHOUT, "{} pages have no example: {without:?}", without.len());
    let distinct: BTreeSet<_> = without.iter().collect();
    assert_eq!(distinct.len(), without.len());
}

/// Pages whose fault takes an input of enormous size (below), a fault of aptc itself, or surfaces that do not fit
/// a page.
const MOST_WITHOUT: usize = 15;

#[test]
fn inputs_too_large_for_a_page_give_their_codes() {
    let many = |n: usize, line: &dyn Fn(usize) -> String| (0..n).map(line).collect::<String>();
    let head = "PARTNO EXAMPLE\nFEDRAT/100\nFROM/0,0,0\n";
    let statement = format!("A=1{}\nFINI\n", many(150_000, &|_| "+$\n1".to_owned()));
    let indices = format!("{head}{}FINI\n", many(101, &|n| format!("INDEX/{n}\n")));
    let unread = format!("{head}{}FINI\n", many(600, &|n| format!("AUXFUN/{}\n", 1000 + n)));
    let line = format!("PARTNO EXAMPLE\nPPRINT {}\nFINI\n", "X".repeat(300_000));
    let inputs = [
        (codes::STATEMENT_TOO_LONG, "apt", statement),
        (codes::NESTED_TOO_DEEP, "apt", indices),
        (codes::MORE_MESSAGES, "apt", unread),
        (codes::CL_LINE_TOO_LONG, "cl", line),
    ];
    for (code, language, text) in inputs {
        let dir = tempfile::tempdir().expect("a folder");
        let name = format!("large.{language}");
        fs::write(dir.path().join(&name), text).expect("it is written");
        let command = if language == "cl" { "post" } else { "compile" };
        let messages = run(dir.path(), &[command, &name, "--machine", "linuxcnc-mill"]);
        let told = messages.iter().filter(|m| m["code"] == code.to_string()).count();
        assert_eq!(told, 1, "{code}: {:?}", messages.iter().take(5).collect::<Vec<_>>());
    }
}

/// What the first pages and the help name exists.
#[test]
fn named_codes_are_codes() {
    let help = Command::new(env!("CARGO_BIN_EXE_aptc")).args(["explain", "--help"]).output();
    let mut texts = vec![String::from_utf8(help.expect("it starts").stdout).expect("it is text")];
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for page in ["README.md", "CONTRIBUTING.md", "docs/errors.md"] {
        texts.push(fs::read_to_string(root.join(page)).expect("it is there"));
    }
    for text in &texts {
        for code in text.split(|c: char| !c.is_ascii_alphanumeric()) {
            let digits = code.strip_prefix("APT").unwrap_or_default();
            if digits.len() == 4 && digits.bytes().all(|b| b.is_ascii_digit()) {
                assert!(Code::parse(code).is_some(), "{code}");
            }
        }
    }
}
