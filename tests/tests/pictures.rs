//! The pictures of the corpus in the book: each part has its line in the index, each picture is what its
//! program gives now.
//!
//! `APTC_BLESS=pictures` writes them anew; `cargo xtask bless` does it with the goldens.

use std::collections::BTreeSet;
use std::fs;

use aptc_control::{Artifact, Disk, Options, Source, Verify};
use aptc_testkit::repository;

/// Where the views of a plot stand in it: the name of the view, its place among the views, its frame.
const VIEWS: [(&str, usize, &str); 3] =
    [("top", 1, "8 64 521 413"), ("iso", 2, "531 64 521 413"), ("front", 3, "8 479 521 413")];

/// Topic and name of each program of the corpus that has no mistakes.
fn programs() -> BTreeSet<(String, String)> {
    let folders = |path: &std::path::Path| -> Vec<String> {
        let entries = fs::read_dir(path).expect("the corpus can be read").flatten();
        entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect()
    };
    let corpus = repository().join("corpus");
    let topics = folders(&corpus).into_iter().filter(|topic| topic != "errors");
    let names = topics.flat_map(|topic| {
        folders(&corpus.join(&topic)).into_iter().map(move |name| (topic.clone(), name))
    });
    names
        .filter(|(topic, name)| corpus.join(topic).join(name).join("program.apt").exists())
        .collect()
}

/// One view of the plot of a program.
fn view(topic: &str, name: &str, view: &str) -> String {
    let path = repository().join("corpus").join(topic).join(name).join("program.apt");
    let folder = path.parent().map(std::path::Path::to_owned).into_iter().collect();
    let text = fs::read_to_string(&path).expect("a program of the corpus");
    let source = Source { name: "program.apt".into(), text: text.into() };
    let options = Options { post: false, verify: Verify::Off, ..Options::default() };
    let compiled = aptc_control::compile(source, &mut Disk::new(folder, 1 << 24), &options);
    let (_, bytes) = compiled.artifact(Artifact::Svg, false).expect("it is made").remove(0);
    let plot = String::from_utf8(bytes).expect("SVG is text");
    let (_, nth, frame) = VIEWS.into_iter().find(|v| v.0 == view).expect("a view of a plot");
    let mut pieces = plot.split("<g>");
    let head = pieces.next().expect("a head");
    let style = head.find("<rect").map_or(head, |at| &head[..at]);
    let panel = pieces.nth(nth - 1).and_then(|p| p.split_once("</g>")).expect("the view").0;
    let style = style.replace("0 0 1280 900", frame);
    format!(
        "{}<g>{panel}</g>\n</svg>\n",
        style.replacen("<svg ", "<svg width=\"521\" height=\"413\" ", 1)
    )
}

#[test]
fn each_picture_of_a_part_is_what_its_program_gives() {
    let bless = std::env::var("APTC_BLESS").is_ok_and(|what| what == "pictures");
    let docs = repository().join("docs");
    let mut shown = BTreeSet::new();
    for page in ["corpus.md", "regional.md"] {
        let text = fs::read_to_string(docs.join(page)).expect("the page is there");
        for link in text.split("](pictures/corpus/").skip(1) {
            shown.insert(link.split(')').next().expect("a link ends").to_owned());
        }
    }
    let mut faults = Vec::new();
    for file in &shown {
        let parts: Vec<&str> = file.trim_end_matches(".svg").split('-').collect();
        let [topic, name, which] = parts.as_slice() else { panic!("{file}: TOPIC-NAME-VIEW.svg") };
        let svg = view(topic, name, which);
        let path = docs.join("pictures/corpus").join(file);
        if bless {
            fs::create_dir_all(docs.join("pictures/corpus")).expect("a folder");
            fs::write(path, svg).expect("it is written");
        } else if fs::read_to_string(path).ok() != Some(svg) {
            faults.push(file);
        }
    }
    assert!(faults.is_empty(), "{faults:?}\nAPTC_BLESS=pictures draws them anew");
    for entry in fs::read_dir(docs.join("pictures/corpus")).expect("the folder").flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        assert!(shown.contains(&name), "no page shows {name}");
    }
}

#[test]
fn the_index_names_each_program_of_the_corpus() {
    let page = repository().join("docs/corpus.md");
    let text = fs::read_to_string(page).expect("the page is there");
    let missing: Vec<_> = programs()
        .into_iter()
        .map(|(topic, name)| format!("`{topic}/{name}`"))
        .filter(|name| !text.contains(name.as_str()))
        .collect();
    assert!(missing.is_empty(), "programs without a line: {missing:?}");
    let named = text.split('`').skip(1).step_by(2).filter_map(|code| code.split_once('/'));
    let known = programs();
    for (topic, name) in named {
        let there = known.contains(&(topic.to_owned(), name.to_owned()));
        assert!(there || topic == "corpus", "{topic}/{name} is no program of the corpus");
    }
}
