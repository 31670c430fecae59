//! Post-processor words of two streams, compared in their order.

use std::collections::VecDeque;

use serde::Serialize;

use crate::Arg;

/// Differences of post-processor words that are listed.
const MOST_LISTED: usize = 20;
/// Words of one stream that wait for those of the other.
const MOST_WAITING: usize = 100_000;

/// A post-processor word that is not the same in both.
#[derive(Clone, Debug, Serialize)]
pub struct WordDifference {
    /// Number of the word in order, from 1.
    pub number: u64,
    /// The statement of the first stream; empty when it has no more.
    pub first: String,
    /// Its line.
    pub first_line: u32,
    /// The statement of the second stream; empty when it has no more.
    pub second: String,
    /// Its line.
    pub second_line: u32,
}

/// Post-processor words in order.
#[derive(Default)]
pub(super) struct Words {
    pub(super) list: Vec<WordDifference>,
    pub(super) n: u64,
    compared: u64,
}

/// A word with its arguments and its line.
pub(super) type Post = (String, Vec<Value>, u32);

/// Words that wait for those of the other stream.
pub(super) type Posts = VecDeque<Post>;

/// An argument to be compared.
#[derive(Clone, Debug)]
pub(super) enum Value {
    Number(f64),
    Text(String),
}

impl Words {
    /// Compares those of both streams that have come.
    pub(super) fn compare(&mut self, a: &mut Posts, b: &mut Posts) {
        while !a.is_empty() && !b.is_empty() {
            let (Some(x), Some(y)) = (a.pop_front(), b.pop_front()) else { return };
            self.compared += 1;
            if !same(&x, &y) {
                self.differ(Some(&x), Some(&y));
            }
        }
        // When one way has words without end and the other none, they are counted, not kept.
        self.drop_waiting(a, false);
        self.drop_waiting(b, true);
    }

    fn drop_waiting(&mut self, posts: &mut Posts, second: bool) {
        while posts.len() > MOST_WAITING {
            let Some(x) = posts.pop_front() else { return };
            self.compared += 1;
            if second { self.differ(None, Some(&x)) } else { self.differ(Some(&x), None) }
        }
    }

    /// What one stream has and the other has not.
    pub(super) fn rest(&mut self, a: &mut Posts, b: &mut Posts) {
        for x in a.drain(..) {
            self.compared += 1;
            self.differ(Some(&x), None);
        }
        for y in b.drain(..) {
            self.compared += 1;
            self.differ(None, Some(&y));
        }
    }

    fn differ(&mut self, a: Option<&Post>, b: Option<&Post>) {
        self.n += 1;
        if self.list.len() < MOST_LISTED {
            let show = |x: Option<&Post>| x.map_or(String::new(), shown);
            let line = |x: Option<&Post>| x.map_or(0, |x| x.2);
            self.list.push(WordDifference {
                number: self.compared,
                first: show(a),
                first_line: line(a),
                second: show(b),
                second_line: line(b),
            });
        }
    }
}

/// What an argument is compared by.
pub(super) fn values(arg: &Arg) -> Vec<Value> {
    match arg {
        Arg::Number(x) => vec![Value::Number(*x)],
        Arg::Word(w) => vec![Value::Text(w.to_string())],
        Arg::Text(t) => vec![Value::Text(t.to_string())],
        Arg::Form { form, .. } => form.canonical().into_iter().map(Value::Number).collect(),
    }
}

fn shown((word, args, _): &Post) -> String {
    let args: Vec<String> = args
        .iter()
        .map(|a| match a {
            Value::Number(x) => x.to_string(),
            Value::Text(t) => t.clone(),
        })
        .collect();
    if args.is_empty() { word.clone() } else { format!("{word}/{}", args.join(",")) }
}

/// Same word and arguments, numbers to a millionth.
fn same(a: &Post, b: &Post) -> bool {
    let one = |(x, y): (&Value, &Value)| match (x, y) {
        (Value::Number(x), Value::Number(y)) => (x - y).abs() <= 1e-6 * y.abs().max(1.0),
        (Value::Text(x), Value::Text(y)) => x.eq_ignore_ascii_case(y),
        _ => false,
    };
    a.0 == b.0 && a.1.len() == b.1.len() && a.1.iter().zip(&b.1).all(one)
}
