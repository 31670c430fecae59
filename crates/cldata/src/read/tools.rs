//! Tool words of NX, CAMWorks, DMG and CATIA, said as ISO 4343 does.

use smol_str::SmolStr;

use crate::{Arg, Dialect};

/// The numbers behind the first of CATIA's `LOADTL/n,a,b` are correctors; a third one would be the length of the tool.
pub(super) fn without_correctors(dialect: Dialect, word: &str, args: &mut Vec<Arg>) {
    let plain = args.iter().all(|a| matches!(a, Arg::Number(_)));
    if dialect == Dialect::Catia && word == "LOADTL" && plain {
        args.truncate(2);
    }
}

/// `LOAD/TOOL,n,..` is `LOADTL/n,..`, `LOAD/TURRET,n,..` is `TURRET/n,..` and `SELECT/TOOL,n` is `SELCTL/n`; other statements stay.
pub(super) fn as_iso(word: &SmolStr, args: &mut Vec<Arg>) -> SmolStr {
    let iso = match word.as_str() {
        "LOAD" => "LOADTL",
        "SELECT" => "SELCTL",
        _ => return word.clone(),
    };
    match args.as_slice() {
        [Arg::Word(w), Arg::Number(_), ..] if w == "TURRET" && word == "LOAD" => {
            args.remove(0);
            "TURRET".into()
        }
        [Arg::Word(w), Arg::Number(_), ..] if w == "TOOL" => {
            args.remove(0);
            iso.into()
        }
        _ => word.clone(),
    }
}
