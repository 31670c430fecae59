//! The pages of the geometry formats and of motion: each format of the tables stands on one, and each picture
//! is what its program gives now.
//!
//! `APTC_BLESS=formats` writes the pictures anew; `cargo xtask bless` does it with the goldens.

mod contour;
mod label;
mod motion;
mod picture;
mod scene;
mod shape;
mod view;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::PathBuf;

use aptc_testkit::repository;
use aptc_translate::define::formats;
use aptc_vocabulary::all;

use scene::Scene;

fn folder(chapter: &str) -> PathBuf {
    repository().join("docs").join(chapter)
}

/// Stem and text of each page of a chapter.
fn pages(chapter: &str) -> Vec<(String, String)> {
    let mut pages = Vec::new();
    for entry in fs::read_dir(folder(chapter)).expect("the folder is there").flatten() {
        let path = entry.path();
        if path.extension().is_some_and(|e| e == "md") {
            let stem = path.file_stem().expect("a name").to_string_lossy().into_owned();
            pages.push((stem, fs::read_to_string(&path).expect("a page is text")));
        }
    }
    pages.sort();
    pages
}

/// The formats that a page explains: whole headings and whole items of lists.
fn explained(page: &str) -> Vec<String> {
    let line = |line: &str| {
        let rest = line.strip_prefix("## ").or_else(|| line.strip_prefix("- "))?;
        let text = rest.trim().strip_prefix('`')?.strip_suffix('`')?;
        (!text.contains('`')).then(|| text.to_owned())
    };
    page.lines().filter_map(line).collect()
}

/// Each picture that a page shows with the program below it.
fn pictures(page: &str) -> Vec<(String, String)> {
    let (mut found, mut lines) = (Vec::new(), page.lines());
    while let Some(line) = lines.next() {
        let Some((_, link)) = line.split_once("](pictures/") else { continue };
        let name = link.trim_end_matches(')').to_owned();
        let body = lines.by_ref().skip_while(|l| *l != "```apt").skip(1);
        let program: Vec<_> = body.take_while(|l| *l != "```").collect();
        found.push((name, program.join("\n") + "\n"));
    }
    found
}

#[test]
fn each_format_stands_on_a_page_once() {
    let mut told = BTreeMap::new();
    for (page, text) in pages("formats") {
        for format in explained(&text) {
            let before = told.insert(format.clone(), page.clone());
            assert_eq!(before, None, "{format} is explained twice");
        }
    }
    let all: BTreeSet<String> = all().flat_map(formats).collect();
    let told: BTreeSet<String> = told.into_keys().collect();
    let missing: Vec<_> = all.difference(&told).collect();
    assert!(missing.is_empty(), "formats that no page explains: {missing:#?}");
    let stale: Vec<_> = told.difference(&all).collect();
    assert!(stale.is_empty(), "formats that are no longer there: {stale:#?}");
}

#[test]
fn each_picture_is_what_its_program_gives() {
    let formats = drawn("formats", Scene::of);
    assert!(formats >= 100, "only {formats} pictures of formats");
    let motions = drawn("motion", Scene::of_motion);
    assert!(motions >= 8, "only {motions} pictures of motions");
}

/// Draws the pictures of a chapter, or holds them against its programs; how many there are.
fn drawn(chapter: &str, scene: impl Fn(&str) -> Result<Scene, String>) -> usize {
    let bless = std::env::var("APTC_BLESS").is_ok_and(|what| what == "formats");
    let folder = folder(chapter).join("pictures");
    let (mut drawn, mut faults) = (BTreeSet::new(), Vec::new());
    for (page, text) in pages(chapter) {
        for (name, program) in pictures(&text) {
            assert!(drawn.insert(name.clone()), "{page}: {name} is shown twice");
            let svg = match scene(&program) {
                Ok(scene) => picture::svg(&scene),
                Err(why) => {
                    faults.push(format!("{page}: {name}: {why}\n{program}"));
                    continue;
                }
            };
            let path = folder.join(&name);
            if bless {
                fs::create_dir_all(&folder).expect("a folder");
                fs::write(&path, svg).expect("it is written");
            } else if fs::read_to_string(&path).ok() != Some(svg) {
                faults.push(format!("{page}: {name} is not what its program gives"));
            }
        }
    }
    assert!(faults.is_empty(), "{}\nAPTC_BLESS=formats draws them anew", faults.join("\n"));
    for entry in fs::read_dir(folder).expect("the folder is there").flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        let known = drawn.contains(&name);
        if bless && !known {
            fs::remove_file(entry.path()).expect("it is removed");
        } else {
            assert!(known, "no page shows {name}");
        }
    }
    drawn.len()
}
