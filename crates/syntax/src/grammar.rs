//! The grammar: from the tokens of one statement to its body.
//!
//! Written once over the error type `E`: a statement is read with an error that says nothing, which is
//! several times quicker, and only one that fails is read again for a message (see `message`).

use aptc_diagnostics::{FileId, Span};
use aptc_vocabulary::word;
use chumsky::error::{Error, LabelError};
use chumsky::input::MappedInput;
use chumsky::prelude::{
    Boxed, IterParser, Parser, SimpleSpan, choice, custom, extra, recursive, select,
};

use crate::form::Form;
use crate::shelf::{Shelf, Shelves};
use crate::token::{Spanned, Token};
use crate::tree::{
    BinaryOp, Body, Clause, Definition, Expr, ExprKind, Indexed, Name, Param, Target, UnaryOp,
};
use crate::{Symbol, climb};

/// The tokens of a statement as the parser library sees them.
pub(crate) type Tokens<'t> = MappedInput<'t, Token, SimpleSpan<u32>, &'t [Spanned]>;

/// What an error must be able to do: `EmptyErr` and `Rich` can.
pub(crate) trait Fault<'t>:
    Error<'t, Tokens<'t>> + LabelError<'t, Tokens<'t>, &'static str> + 't
{
}

impl<'t, E> Fault<'t> for E where
    E: Error<'t, Tokens<'t>> + LabelError<'t, Tokens<'t>, &'static str> + 't
{
}

type Rule<'t, O, E> = Boxed<'t, 't, Tokens<'t>, O, extra::Err<E>>;

/// What the tokens leave out.
#[derive(Clone, Copy)]
pub(crate) struct Beside<'t> {
    /// The file of all spans.
    pub(crate) file: FileId,
    /// Quoted texts by number.
    pub(crate) texts: &'t [Box<str>],
    /// Fixed-field statements by number.
    pub(crate) fixed: &'t [Body],
    /// The symbol without letters, for arguments without a name.
    pub(crate) nameless: Symbol,
    /// Where lists wait until they are complete.
    pub(crate) shelves: &'t Shelves,
    /// Is speed asked for, not messages?
    pub(crate) quick: bool,
}

/// One rule for each form of statement.
pub(crate) struct Grammar<'t, E: Fault<'t>> {
    assign: Rule<'t, Body, E>,
    macro_: Rule<'t, Body, E>,
    call: Rule<'t, Body, E>,
    if_: Rule<'t, Body, E>,
    if_then: Rule<'t, Body, E>,
    do_: Rule<'t, Body, E>,
    clauses: Rule<'t, Body, E>,
}

impl<'t, E: Fault<'t>> Grammar<'t, E> {
    /// The rule of a form.
    pub(crate) fn rule(&self, form: Form) -> &Rule<'t, Body, E> {
        match form {
            Form::Assign => &self.assign,
            Form::Macro => &self.macro_,
            Form::Call => &self.call,
            Form::If => &self.if_,
            Form::IfThen => &self.if_then,
            Form::Do => &self.do_,
            Form::Clauses => &self.clauses,
        }
    }

    /// Builds the rules.
    pub(crate) fn new(beside: Beside<'t>) -> Self {
        let file = beside.file;
        let item = item(beside);
        let assign = assign(item.clone(), beside).boxed();
        let call = call(item.clone(), beside).boxed();
        let clauses = clauses(item.clone(), beside).boxed();
        let condition = name(file)
            .ignore_then(item.clone().delimited_by(just(Token::Open), just(Token::Close)));

        let target = label(file).labelled("a label");
        let if_ = condition
            .clone()
            .then(target.clone())
            .then_ignore(just(Token::Comma))
            .then(target.clone())
            .then_ignore(just(Token::Comma))
            .then(target)
            .map(|(((value, a), b), c)| Body::If { value, targets: Box::new([a, b, c]) })
            .boxed();
        let fixed = beside.fixed;
        let text = select! {
            Token::Fixed(i) if (i as usize) < fixed.len() => fixed[i as usize].clone(),
        };
        let if_then = condition
            .then(choice((text, call.clone(), assign.clone(), clauses.clone())))
            .map(|(condition, then)| Body::IfThen { condition, then: Box::new(then) })
            .boxed();
        Self {
            macro_: macro_rule(item.clone(), beside).boxed(),
            do_: do_rule(item, beside).boxed(),
            assign,
            call,
            if_,
            if_then,
            clauses,
        }
    }
}

fn at(file: FileId, span: SimpleSpan<u32>) -> Span {
    // An empty field lies between two tokens, where the library gives the end before the start.
    Span::new(file, span.start.min(span.end), span.end.max(span.start))
}

/// A symbol or word.
fn name<'t, E: Fault<'t>>(
    file: FileId,
) -> impl Parser<'t, Tokens<'t>, Name, extra::Err<E>> + Clone {
    select! {
        Token::Name(symbol, word) = e => Name { symbol, word, span: at(file, e.span()) },
        Token::Head(symbol, word) = e => Name { symbol, word, span: at(file, e.span()) },
    }
    .labelled("a name")
}

/// A label as a target: a symbol or digits.
fn label<'t, E: Fault<'t>>(
    file: FileId,
) -> impl Parser<'t, Tokens<'t>, Name, extra::Err<E>> + Clone {
    select! {
        Token::Name(symbol, word) = e => Name { symbol, word, span: at(file, e.span()) },
        Token::Number(_, Some(symbol)) = e =>
            Name { symbol, word: None, span: at(file, e.span()) },
    }
}

fn just<'t, E: Fault<'t>>(
    token: Token,
) -> impl Parser<'t, Tokens<'t>, Token, extra::Err<E>> + Clone {
    chumsky::primitive::just(token)
}

/// A list of arguments with empty fields.
fn list<'t, E: Fault<'t>>(
    item: impl Parser<'t, Tokens<'t>, Expr, extra::Err<E>> + Clone,
    beside: Beside<'t>,
) -> impl Parser<'t, Tokens<'t>, Box<[Expr]>, extra::Err<E>> + Clone {
    let item = item.or_not().map_with(move |item, e| {
        let empty = || Expr { kind: ExprKind::Empty, span: at(beside.file, e.span()) };
        item.unwrap_or_else(empty)
    });
    separated(item, &beside.shelves.exprs).map(|list| match &list[..] {
        [Expr { kind: ExprKind::Empty, .. }] => Box::default(),
        _ => list,
    })
}

/// One `item` or more with commas between.
fn separated<'t, T: 't, E: Fault<'t>>(
    item: impl Parser<'t, Tokens<'t>, T, extra::Err<E>> + Clone,
    shelf: &'t Shelf<T>,
) -> impl Parser<'t, Tokens<'t>, Box<[T]>, extra::Err<E>> + Clone {
    item.clone()
        .map(|first| shelf.put(shelf.pile(), first))
        .foldl(just(Token::Comma).ignore_then(item).repeated(), |pile, next| shelf.put(pile, next))
        .map(|pile| shelf.take(pile))
}

/// `POINT/1,2`: the head and its arguments.
fn definition<'t, E: Fault<'t>>(
    item: impl Parser<'t, Tokens<'t>, Expr, extra::Err<E>> + Clone,
    beside: Beside<'t>,
) -> impl Parser<'t, Tokens<'t>, Expr, extra::Err<E>> + Clone {
    let file = beside.file;
    select! {
        Token::Head(symbol, word) = e => Name { symbol, word, span: at(file, e.span()) },
    }
    .labelled("a definition")
    .then_ignore(just(Token::Slash))
    .then(list(item, beside))
    .map_with(move |(head, args), e| Expr {
        kind: ExprKind::Define(Box::new(Definition {
            target: None,
            head,
            args,
            juxtaposed: Box::default(),
        })),
        span: at(file, e.span()),
    })
}

/// An expression or `A=expression`.
fn item<'t, E: Fault<'t>>(
    beside: Beside<'t>,
) -> impl Parser<'t, Tokens<'t>, Expr, extra::Err<E>> + Clone {
    let file = beside.file;
    let full = recursive(move |full| {
        let item = choice((single(beside), full));
        let define = definition(item.clone(), beside);
        let inside =
            choice((define.clone().map(Inside::One), list(item.clone(), beside).map(Inside::List)));
        let value = choice((define.map(|d| (d, true)), item.map(|value| (value, false))));
        expression(atom(inside, beside), beside)
            .then(just(Token::Equal).ignore_then(value).or_not())
            .try_map(move |(left, value), span| match value {
                None => Ok(left),
                Some((value, defines)) => assigned(left, value, defines, file, span),
            })
    });
    choice((single(beside), full))
}

/// A number, perhaps with a minus, or a name that is an argument by itself, as most are: no operator,
/// bracket or `=` follows. Adds nothing to the language, and nearly a third to the speed; never matches
/// where messages are asked for.
fn single<'t, E: Fault<'t>>(
    beside: Beside<'t>,
) -> impl Parser<'t, Tokens<'t>, Expr, extra::Err<E>> + Clone {
    let file = beside.file;
    custom(move |input| {
        let start = input.cursor();
        let mut first = input.next();
        let mut inner = start.clone();
        let minus = beside.quick && first == Some(Token::Operator(BinaryOp::Sub));
        if minus {
            inner = input.cursor();
            first = input.next();
        }
        let alone =
            beside.quick && matches!(input.peek(), None | Some(Token::Comma | Token::Close));
        let kind = match first {
            Some(Token::Number(value, _)) if alone => ExprKind::Number(value),
            Some(Token::Name(symbol, word)) if alone => {
                ExprKind::Name(Name { symbol, word, span: at(file, input.span_since(&inner)) })
            }
            _ => {
                return Err(LabelError::expected_found(
                    ["a value"],
                    None,
                    input.span_since(&start),
                ));
            }
        };
        let value = Expr { kind, span: at(file, input.span_since(&inner)) };
        if !minus {
            return Ok(value);
        }
        let span = at(file, input.span_since(&start));
        Ok(Expr { kind: ExprKind::Unary(UnaryOp::Neg, Box::new(value)), span })
    })
}

/// `left = value` as an expression; a definition without brackets of its own takes the name in.
fn assigned<'t, E: Fault<'t>>(
    left: Expr,
    value: Expr,
    defines: bool,
    file: FileId,
    span: SimpleSpan<u32>,
) -> Result<Expr, E> {
    let whole = left.span.to(value.span);
    let Some(target) = target_of(left) else {
        let whole = SimpleSpan::from(whole.start..whole.end);
        return Err(LabelError::expected_found(["a name left of `=`"], None, whole));
    };
    let span = at(file, span);
    Ok(match value.kind {
        ExprKind::Define(mut definition) if defines => {
            definition.target = Some(target);
            Expr { kind: ExprKind::Define(definition), span }
        }
        kind => {
            let value = Expr { kind, span: value.span };
            Expr { kind: ExprKind::Assign(Box::new(target), Box::new(value)), span }
        }
    })
}

/// The expression as the left side of `=`.
fn target_of(expr: Expr) -> Option<Target> {
    match expr.kind {
        ExprKind::Name(name) => Some(Target { name, subscript: None, span: expr.span }),
        ExprKind::Indexed(indexed) => {
            let Indexed { name, list } = *indexed;
            let [subscript] = *<Box<[Expr; 1]>>::try_from(list).ok()?;
            Some(Target { name, subscript: Some(Box::new(subscript)), span: expr.span })
        }
        _ => None,
    }
}

/// What operators stand between.
fn atom<'t, E: Fault<'t>>(
    inside: impl Parser<'t, Tokens<'t>, Inside, extra::Err<E>> + Clone,
    beside: Beside<'t>,
) -> impl Parser<'t, Tokens<'t>, Expr, extra::Err<E>> + Clone {
    let Beside { file, texts, .. } = beside;
    let inside = inside.delimited_by(just(Token::Open), just(Token::Close));
    let simple = select! {
        Token::Number(value, _) = e =>
            Expr { kind: ExprKind::Number(value), span: at(file, e.span()) },
        Token::Truth(value) = e =>
            Expr { kind: ExprKind::Truth(value), span: at(file, e.span()) },
        Token::Text(i) = e => {
            let text = texts.get(i as usize).cloned().unwrap_or_default();
            Expr { kind: ExprKind::Text(text), span: at(file, e.span()) }
        },
    };
    let named = select! {
        Token::Name(symbol, word) = e => Name { symbol, word, span: at(file, e.span()) },
    }
    .then(inside.clone().or_not())
    .map_with(move |(name, list), e| match list {
        None => Expr { kind: ExprKind::Name(name), span: name.span },
        Some(list) => {
            let list = list.into_list();
            let span = at(file, e.span());
            Expr { kind: ExprKind::Indexed(Box::new(Indexed { name, list })), span }
        }
    });
    let word = select! {
        Token::Name(symbol, word) = e => {
            let name = Name { symbol, word, span: at(file, e.span()) };
            Expr { kind: ExprKind::Name(name), span: name.span }
        },
    };
    let bracket = inside
        .then(word.repeated().collect::<Vec<_>>())
        .try_map(move |(list, words), span| bracketed(list, words, file, span));
    choice((simple, named, bracket)).labelled("a value")
}

/// What stands in brackets.
enum Inside {
    /// A definition, or a list of one.
    One(Expr),
    List(Box<[Expr]>),
}

impl Inside {
    fn into_list(self) -> Box<[Expr]> {
        match self {
            Self::One(expr) => Box::new([expr]),
            Self::List(list) => list,
        }
    }
}

/// `(...)` with what follows it directly.
fn bracketed<'t, E: Fault<'t>>(
    inside: Inside,
    words: Vec<Expr>,
    file: FileId,
    simple: SimpleSpan<u32>,
) -> Result<Expr, E> {
    let span = at(file, simple);
    let inner = match inside {
        Inside::One(inner) => inner,
        Inside::List(list) if list.is_empty() => {
            return Err(LabelError::expected_found(["a value in the brackets"], None, simple));
        }
        Inside::List(list) => match <Box<[Expr; 1]>>::try_from(list) {
            Ok(one) => {
                let [inner] = *one;
                inner
            }
            Err(list) => {
                return only_definitions(words)
                    .map(|()| Expr { kind: ExprKind::Tuple(list), span });
            }
        },
    };
    match inner.kind {
        ExprKind::Define(mut definition) => {
            definition.juxtaposed = words.into();
            Ok(Expr { kind: ExprKind::Define(definition), span })
        }
        kind => only_definitions(words).map(|()| Expr { kind, span }),
    }
}

/// Words directly behind a bracket are right behind a definition only.
fn only_definitions<'t, E: Fault<'t>>(words: Vec<Expr>) -> Result<(), E> {
    match words.first() {
        None => Ok(()),
        Some(word) => {
            let span = SimpleSpan::from(word.span.start..word.span.end);
            Err(LabelError::expected_found(["an operator", "`,`"], None, span))
        }
    }
}

/// Values with operators between. Read as a flat row and put together by [`climb`]: one look at each
/// operator instead of one for each class of operators.
fn expression<'t, E: Fault<'t>>(
    atom: impl Parser<'t, Tokens<'t>, Expr, extra::Err<E>> + Clone,
    beside: Beside<'t>,
) -> impl Parser<'t, Tokens<'t>, Expr, extra::Err<E>> + Clone {
    let row = &beside.shelves.operands;
    let sign = select! {
        Token::Operator(BinaryOp::Add) = e => (UnaryOp::Pos, e.span()),
        Token::Operator(BinaryOp::Sub) = e => (UnaryOp::Neg, e.span()),
        Token::Not = e => (UnaryOp::Not, e.span()),
    }
    .labelled("a value");
    let operator = select! {
        Token::Operator(op) => op,
        Token::Slash => BinaryOp::Div,
    }
    .labelled("an operator");
    let operand = sign.repeated().collect::<Vec<_>>().then(atom);
    operand
        .clone()
        .map(|first| (first, row.pile()))
        .foldl(operator.then(operand).repeated(), |(first, pile), next| {
            (first, row.put(pile, next))
        })
        .map(|((signs, first), pile)| {
            if signs.is_empty() && pile.is_empty() {
                return first;
            }
            row.with(pile, |rest| climb::tree((signs, first), rest))
        })
}

/// `A=3*B`, `P(2)=POINT/1,2`.
fn assign<'t, E: Fault<'t>>(
    item: impl Parser<'t, Tokens<'t>, Expr, extra::Err<E>> + Clone,
    beside: Beside<'t>,
) -> impl Parser<'t, Tokens<'t>, Body, extra::Err<E>> + Clone {
    let file = beside.file;
    let subscript = item.clone().delimited_by(just(Token::Open), just(Token::Close));
    let target = name(file).then(subscript.or_not()).map_with(move |(name, subscript), e| Target {
        name,
        subscript: subscript.map(Box::new),
        span: at(file, e.span()),
    });
    let value = choice((definition(item.clone(), beside), item));
    target
        .then_ignore(just(Token::Equal))
        .then(value)
        .map(|(target, value)| Body::Assign { target, value })
}

/// `name=value` or a name alone.
fn params<'t, E: Fault<'t>>(
    item: impl Parser<'t, Tokens<'t>, Expr, extra::Err<E>> + Clone,
    beside: Beside<'t>,
) -> impl Parser<'t, Tokens<'t>, Box<[Param]>, extra::Err<E>> + Clone {
    let nameless = beside.nameless;
    let param = item.map(move |expr| match expr.kind {
        ExprKind::Name(name) => Param { name, value: None },
        ExprKind::Assign(target, value) if target.subscript.is_none() => {
            Param { name: target.name, value: Some(*value) }
        }
        kind => {
            let name = Name { symbol: nameless, word: None, span: expr.span };
            Param { name, value: Some(Expr { kind, span: expr.span }) }
        }
    });
    separated(param, &beside.shelves.params).or_not().map(Option::unwrap_or_default)
}

/// `M=MACRO/A,B=2`.
fn macro_rule<'t, E: Fault<'t>>(
    item: impl Parser<'t, Tokens<'t>, Expr, extra::Err<E>> + Clone,
    beside: Beside<'t>,
) -> impl Parser<'t, Tokens<'t>, Body, extra::Err<E>> + Clone {
    let params = just(Token::Slash).ignore_then(params(item, beside)).or_not();
    name(beside.file)
        .then_ignore(just(Token::Equal))
        .then_ignore(name(beside.file))
        .then(params)
        .map(|(name, params)| Body::Macro { name, params: params.unwrap_or_default() })
}

/// `CALL/M,A=1`.
fn call<'t, E: Fault<'t>>(
    item: impl Parser<'t, Tokens<'t>, Expr, extra::Err<E>> + Clone,
    beside: Beside<'t>,
) -> impl Parser<'t, Tokens<'t>, Body, extra::Err<E>> + Clone {
    let file = beside.file;
    select! { Token::Name(_, Some(word::CALL)) => () }
        .then(just(Token::Slash))
        .ignore_then(name(file).labelled("the name of a macro"))
        .then(just(Token::Comma).ignore_then(params(item, beside)).or_not())
        .map(|(name, args)| Body::Call { name, args: args.unwrap_or_default() })
}

/// `DO/L,I=1,10,2`.
fn do_rule<'t, E: Fault<'t>>(
    item: impl Parser<'t, Tokens<'t>, Expr, extra::Err<E>> + Clone,
    beside: Beside<'t>,
) -> impl Parser<'t, Tokens<'t>, Body, extra::Err<E>> + Clone {
    let file = beside.file;
    name(file)
        .then_ignore(just(Token::Slash))
        .ignore_then(label(file).labelled("the label of the last statement of the loop"))
        .then_ignore(just(Token::Comma))
        .then(name(file).labelled("the running variable"))
        .then_ignore(just(Token::Equal))
        .then(item.clone())
        .then_ignore(just(Token::Comma))
        .then(item.clone())
        .then(just(Token::Comma).ignore_then(item).or_not())
        .map(|((((label, variable), first), last), step)| Body::Do {
            label,
            variable,
            first: Box::new(first),
            last: Box::new(last),
            step: step.map(Box::new),
        })
}

/// `RAPID,GOTO/P`.
fn clauses<'t, E: Fault<'t>>(
    item: impl Parser<'t, Tokens<'t>, Expr, extra::Err<E>> + Clone,
    beside: Beside<'t>,
) -> impl Parser<'t, Tokens<'t>, Body, extra::Err<E>> + Clone {
    let file = beside.file;
    let head = name(file).map(|head| Clause { head, args: None, span: head.span });
    separated(head, &beside.shelves.clauses)
        .then(just(Token::Slash).ignore_then(list(item, beside)).or_not())
        .map_with(move |(mut clauses, args), e| {
            let end = at(file, e.span());
            if let Some(last) = clauses.last_mut() {
                last.args = args;
                last.span = last.span.to(Span::new(file, end.end, end.end));
            }
            Body::Clauses(clauses)
        })
}
