//! What to say when no format reads the arguments: the least change after which one would.

use aptc_vocabulary::{Word, word};

use super::format::{Format, Item, Reach, reach};
use super::{Arg, DefineError, Value};

/// What is amiss, best explanation first.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Mismatch {
    /// A word that the format does not have here, where it has others.
    OtherWord(String),
    /// Something is left out here.
    Missing(String),
    /// This argument and the one before it stand in the wrong order.
    Swapped,
    /// An argument of another kind.
    OtherKind(String),
    /// One argument too many.
    Extra,
    /// No single change helps; these could stand here.
    Unread(Vec<String>),
}

/// The best explanation, and the formats that it comes from.
pub(super) fn explain(head: Word, table: &'static [Format], args: &[Arg]) -> DefineError {
    let mut best: Vec<(Mismatch, usize, String)> = Vec::new();
    // Where the first argument is a word that begins formats, one of those is meant.
    let begun = |f: &&Format| match (f.items.first(), args.first()) {
        (Some(item), Some(arg)) => matches!(arg.value, Value::Word(_)) && item.takes(arg),
        _ => false,
    };
    let any_begun = table.iter().any(|f| begun(&f));
    let farthest = table.iter().map(|f| reach_of(f, args)).max().unwrap_or(0);
    for format in table {
        let Some((mismatch, at)) = single(format, args, farthest) else { continue };
        if any_begun && at == 0 && matches!(mismatch, Mismatch::OtherWord(_)) {
            continue;
        }
        best.push((mismatch, at, format.text()));
    }
    // Among equal kinds of change the table's order decides: the usual formats stand first.
    best.sort_by_key(|(mismatch, ..)| rank(mismatch));
    if let Some((mismatch, at, _)) = best.first().cloned() {
        let alike = |(m, a, _): &&(Mismatch, usize, String)| *a == at && *m == mismatch;
        let mut candidates: Vec<String> =
            best.iter().filter(alike).map(|(_, _, text)| text.clone()).collect();
        if let Mismatch::OtherKind(_) = mismatch {
            // Something else may be meant than the nearest format: the others of the same word are shown too.
            let first = table.iter().find(|f| candidates.contains(&f.text()));
            let word = first.and_then(|f| f.items.first()).filter(|i| matches!(i, Item::W(_)));
            let others = table.iter().filter(|f| word.is_some() && f.items.first() == word);
            for text in others.map(Format::text) {
                if !candidates.contains(&text) {
                    candidates.push(text);
                }
            }
        }
        return DefineError::NoSuchFormat { head, at, mismatch, candidates };
    }
    furthest(head, table, args)
}

fn rank(mismatch: &Mismatch) -> u8 {
    match mismatch {
        Mismatch::OtherWord(_) => 0,
        Mismatch::Missing(_) => 1,
        Mismatch::Swapped => 2,
        Mismatch::OtherKind(_) => 3,
        Mismatch::Extra => 4,
        Mismatch::Unread(_) => 5,
    }
}

/// The best single change that makes the arguments fit the format, and its place.
///
/// What stands at the end of a format for anything explains nothing: where the change lets the format read no more before
/// that than it read without, or less than some format of the table reads as it stands (`farthest`), it is no explanation.
fn single(format: &Format, args: &[Arg], farthest: usize) -> Option<(Mismatch, usize)> {
    let items = format.items;
    let own = reach_of(format, args);
    let explains = |left_out: usize, changed: usize| {
        let fixed = items.iter().enumerate().filter(|(i, item)| *i != left_out && !is_rest(item));
        let others = args.iter().enumerate().filter(|(i, _)| changed == 0 || *i != left_out);
        match reach(fixed.map(|(_, item)| item), others.map(|(_, arg)| arg)) {
            Reach::All => true,
            Reach::Stops(n) => n + changed > own && n + changed >= farthest,
        }
    };
    if let [_, Item::Rest(_) | Item::Tail(_)] = items {
        // A word and then anything: whatever the word, it would be said to be the wrong one.
        return None;
    }
    let mut found: Vec<(Mismatch, usize)> = Vec::new();
    for at in 0..=args.len() {
        if let Some(item) = items.get(at).filter(|i| !is_rest(i)) {
            let rest = items.iter().enumerate().filter(|(i, _)| *i != at).map(|(_, item)| item);
            if reach(rest, args.iter()) == Reach::All && explains(at, 0) {
                found.push((Mismatch::Missing(item.text()), at));
            }
        }
        let Some(arg) = args.get(at) else { continue };
        let others = args.iter().enumerate().filter(|(i, _)| *i != at).map(|(_, arg)| arg);
        if reach(items.iter(), others.clone()) == Reach::All && !has_rest(items) {
            found.push((Mismatch::Extra, at));
        }
        if at > 0 {
            let order = |i: usize| {
                if i == at {
                    at - 1
                } else if i + 1 == at {
                    at
                } else {
                    i
                }
            };
            let swapped = (0..args.len()).map(|i| &args[order(i)]);
            // Both are read before what stands there for anything.
            let fixed = items.iter().filter(|item| !is_rest(item));
            let read = match reach(fixed, swapped.clone()) {
                Reach::All => true,
                Reach::Stops(n) => n > at,
            };
            if read && reach(items.iter(), swapped) == Reach::All {
                found.push((Mismatch::Swapped, at));
            }
        }
        if let Some(item) = items.get(at).filter(|i| !i.takes(arg)) {
            let rest = items.iter().enumerate().filter(|(i, _)| *i != at).map(|(_, item)| item);
            let word = matches!(arg.value, Value::Word(_));
            let wants_word = matches!(item, Item::W(_) | Item::Of(_));
            if word == wants_word && reach(rest, others) == Reach::All && explains(at, 1) {
                let text = item.text();
                let mismatch =
                    if word { Mismatch::OtherWord(text) } else { Mismatch::OtherKind(text) };
                found.push((mismatch, at));
            }
        }
    }
    // Where one of a row of equals is left out, it is the last: whoever writes gives them in order.
    let last = |mismatch: &Mismatch, at: usize| match mismatch {
        Mismatch::Missing(_) => args.len() - at,
        _ => at,
    };
    found.sort_by_key(|(mismatch, at)| (rank(mismatch), last(mismatch, *at)));
    found.into_iter().next()
}

fn has_rest(items: &[Item]) -> bool {
    items.iter().any(is_rest)
}

fn is_rest(item: &Item) -> bool {
    matches!(item, Item::Rest(_) | Item::Tail(_))
}

/// How many arguments the format reads as it stands.
fn reach_of(format: &Format, args: &[Arg]) -> usize {
    match reach(format.items.iter(), args.iter()) {
        Reach::All => args.len(),
        Reach::Stops(at) => at,
    }
}

/// What could stand where the formats that go furthest stop.
fn furthest(head: Word, table: &'static [Format], args: &[Arg]) -> DefineError {
    let at = table.iter().map(|f| reach_of(f, args)).max().unwrap_or(0);
    let best: Vec<&Format> = table.iter().filter(|f| reach_of(f, args) == at).collect();
    let mut expected: Vec<String> = Vec::new();
    if table.is_empty() {
        expected.push(word::CANON.text().to_owned());
    }
    for format in &best {
        let text = format.items.get(at).map_or_else(|| "the end".to_owned(), Item::text);
        if !expected.contains(&text) {
            expected.push(text);
        }
    }
    let candidates = best.iter().map(|f| f.text()).collect();
    DefineError::NoSuchFormat { head, at, mismatch: Mismatch::Unread(expected), candidates }
}
