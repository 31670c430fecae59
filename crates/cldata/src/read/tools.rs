//! Tool words of NX, CAMWorks and DMG, said as ISO 4343 does.

use smol_str::SmolStr;

use crate::Arg;

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
