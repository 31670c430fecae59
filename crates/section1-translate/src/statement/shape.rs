//! The arguments of statements as tables: a beginning in fixed order and groups that may follow it, or a list.

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_syntax::tree::Clause;
use aptc_vocabulary::Word;

use crate::Interpreter;
use crate::define::{self, Item};
use crate::eval::{Arg, Known, Poisoned, describe};

/// One way to write a statement: a list, one at least of its items as often as wanted; `lead`; then any of the groups, each at
/// most once, in any order.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape {
    /// What the list may hold; empty when there is none.
    pub(super) list: &'static [Item],
    /// What stands first, or behind the list.
    pub(super) lead: &'static [Item],
    /// What may follow.
    pub(super) then: &'static [&'static [Item]],
}

/// How far the arguments fit a shape, and what could stand there.
struct Stop {
    at: usize,
    expected: Vec<String>,
}

/// A shape without groups.
pub(super) const fn fixed(lead: &'static [Item]) -> Shape {
    Shape { list: &[], lead, then: &[] }
}

/// A shape with groups.
pub(super) const fn open(lead: &'static [Item], then: &'static [&'static [Item]]) -> Shape {
    Shape { list: &[], lead, then }
}

/// A list of any length, and what stands behind it.
pub(super) const fn list(list: &'static [Item], lead: &'static [Item]) -> Shape {
    Shape { list, lead, then: &[] }
}

impl Shape {
    /// The shape in the notation of the manuals: `AXIS,vector[,PLUS|MINUS]`.
    pub(super) fn text(&self) -> String {
        let join = |items: &[Item]| items.iter().map(Item::text).collect::<Vec<_>>().join(",");
        let mut text = join(self.lead);
        if !self.list.is_empty() {
            let one = self.list.iter().map(Item::text).collect::<Vec<_>>().join("|");
            text = format!("{one}[,..],{text}");
        }
        let mut last = self.lead.last().map(Item::text);
        for group in self.then {
            let next = join(group);
            // The same once more, and again.
            if last.as_ref() == Some(&next) {
                if !text.ends_with("[,..]") {
                    text += "[,..]";
                }
                continue;
            }
            text += &format!("[,{next}]");
            last = Some(next);
        }
        text
    }

    /// Nothing when the arguments fit.
    fn stop(&self, args: &[define::Arg]) -> Option<Stop> {
        let listed = |a: &&define::Arg| self.list.iter().any(|item| item.takes(a));
        let n = args.iter().take_while(listed).count();
        let texts = || self.list.iter().map(Item::missed).collect();
        if n == 0 && !self.list.is_empty() {
            return Some(Stop { at: 0, expected: texts() });
        }
        let mut at = match run(self.lead, args, n) {
            Ok(at) => at,
            // The list could have gone on there.
            Err(Stop { at, expected }) if at == n => {
                return Some(Stop { at, expected: [texts(), expected].concat() });
            }
            Err(stop) => return Some(stop),
        };
        let mut used = vec![false; self.then.len()];
        while at < args.len() {
            let mut best: Option<Stop> = None;
            let mut next = None;
            for (i, group) in self.then.iter().enumerate().filter(|(i, _)| !used[*i]) {
                match run(group, args, at) {
                    Ok(end) if next.is_none_or(|(_, e)| end > e) => next = Some((i, end)),
                    Ok(_) => {}
                    Err(stop) => join(&mut best, stop),
                }
            }
            let Some((i, end)) = next else {
                let nothing = Stop { at, expected: Vec::new() };
                return Some(best.unwrap_or(nothing));
            };
            used[i] = true;
            at = end;
        }
        None
    }
}

/// Where `items` end that begin at `at`.
fn run(items: &[Item], args: &[define::Arg], at: usize) -> Result<usize, Stop> {
    for (i, item) in items.iter().enumerate() {
        if !args.get(at + i).is_some_and(|a| item.takes(a)) {
            return Err(Stop { at: at + i, expected: vec![item.missed()] });
        }
    }
    Ok(at + items.len())
}

/// Keeps what goes furthest; of equals, what all of them expect.
fn join(best: &mut Option<Stop>, stop: Stop) {
    match best {
        Some(old) if old.at > stop.at => {}
        Some(old) if old.at == stop.at => {
            for text in stop.expected {
                if !old.expected.contains(&text) {
                    old.expected.push(text);
                }
            }
        }
        _ => *best = Some(stop),
    }
}

impl Interpreter<'_> {
    /// Tells where the arguments leave every shape of the statement.
    pub(super) fn shaped(
        &mut self,
        head: Word,
        shapes: &[Shape],
        clause: &Clause,
        args: &[Arg],
    ) -> Known<()> {
        let plain: Vec<define::Arg> = args.iter().cloned().map(define::Arg::from).collect();
        let mut best: Option<Stop> = None;
        for shape in shapes {
            match shape.stop(&plain) {
                None => return Ok(()),
                Some(stop) => join(&mut best, stop),
            }
        }
        let Some(stop) = best else { return Ok(()) };
        let expected = match stop.expected.as_slice() {
            [] => "nothing more".to_owned(),
            [one] => one.clone(),
            [most @ .., last] => format!("{} or {last}", most.join(", ")),
        };
        let (span, message) = match args.get(stop.at) {
            Some(arg) => {
                let found = describe(arg);
                (arg.span, format!("{head} expects {expected} here, found {found}"))
            }
            None => {
                let end = args.last().map_or(clause.span, |a| a.span);
                let end = Span::new(end.file, end.end, end.end);
                (end, format!("{head} ends where {expected} is expected"))
            }
        };
        let mut message = Diagnostic::error(codes::BAD_ARGUMENTS, span, message);
        for shape in nearest(shapes, &plain, stop.at) {
            message = message.note(format!("the format is {head}/{}", shape.text()));
        }
        self.error(message);
        Err(Poisoned)
    }
}

/// The shapes that go as far as `at`, four at most.
fn nearest<'s>(
    shapes: &'s [Shape],
    args: &'s [define::Arg],
    at: usize,
) -> impl Iterator<Item = &'s Shape> {
    shapes.iter().filter(move |s| s.stop(args).is_some_and(|stop| stop.at == at)).take(4)
}
