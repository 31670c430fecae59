//! PROTAP records that Section 2 passes on as they are.

use aptc_cldata as cl;
use aptc_protap as protap;

/// The CL form of a record that has nothing to do with motion; `None` for those that Section 2 itself
/// acts on.
pub(crate) fn forward(kind: &protap::Kind) -> Option<cl::Kind> {
    use protap::Kind as P;
    Some(match kind {
        P::Text { word, text } => cl::Kind::Text { word: word.clone(), text: text.clone() },
        P::Post { word, args } => {
            cl::Kind::Post { word: word.clone(), args: args.iter().map(argument).collect() }
        }
        P::Units(u) => cl::Kind::Units(*u),
        P::Multax(on) => cl::Kind::Multax(*on),
        P::Cutter(c) => cl::Kind::Cutter(*c),
        P::Intol(t) => cl::Kind::Intol(*t),
        P::Outtol(t) => cl::Kind::Outtol(*t),
        P::Edit(e) => cl::Kind::Edit(edit(e)),
        P::Clprnt(what) => cl::Kind::Clprnt(match what {
            protap::Clprnt::Whole => cl::Clprnt::Whole,
            protap::Clprnt::On => cl::Clprnt::On,
            protap::Clprnt::Off => cl::Clprnt::Off,
            protap::Clprnt::Option => cl::Clprnt::Option,
        }),
        P::Fini => cl::Kind::Fini,
        _ => return None,
    })
}

/// Name and subscript.
pub(crate) fn name(n: &protap::NameRef) -> cl::NameRef {
    cl::NameRef { name: n.name.clone(), subscript: n.subscript }
}

/// Relation of the cutter to a surface.
pub(crate) fn relation(r: protap::Relation) -> cl::Relation {
    match r {
        protap::Relation::To => cl::Relation::To,
        protap::Relation::On => cl::Relation::On,
        protap::Relation::Past => cl::Relation::Past,
        protap::Relation::Tanto => cl::Relation::Tanto,
        protap::Relation::Pstan => cl::Relation::Pstan,
    }
}

fn argument(a: &protap::Arg) -> cl::Arg {
    match a {
        protap::Arg::Number(x) => cl::Arg::Number(*x),
        protap::Arg::Word(w) => cl::Arg::Word(w.clone()),
        protap::Arg::Text(t) => cl::Arg::Text(t.clone()),
        protap::Arg::Form { name: n, form } => cl::Arg::Form { name: name(n), form: form.clone() },
    }
}

fn edit(e: &protap::Edit) -> cl::Edit {
    match e {
        protap::Edit::Index { n, close } => cl::Edit::Index { n: *n, close: *close },
        protap::Edit::Copy { n, step, count } => {
            cl::Edit::Copy { n: *n, step: *step, count: *count }
        }
        protap::Edit::Tracut(m) => cl::Edit::Tracut(*m),
    }
}
