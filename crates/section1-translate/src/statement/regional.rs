//! Regional milling, its checks, and milling along lines of a surface: arguments checked against tables
//! and handed on in the order written.
//!
//! Source of the tables: APT4 SSV3.

use aptc_diagnostics::{Diagnostic, codes};
use aptc_protap::{self as protap, Kind};
use aptc_syntax::tree::Clause;
use aptc_vocabulary::{Word, word};

use super::shape::{Shape, fixed, list, open};
use crate::Interpreter;
use crate::define::Item::{self, AS, N, Of, PL, S, SC, SS, V, W};
use crate::eval::{Arg, Known, Names, Poisoned};

const SIGN: Item = Of(&[word::PLUS, word::MINUS]);
const SWITCH: Item = Of(&[word::ON, word::OFF]);
const ALONG: Item = Of(&[word::TANSPL, word::CRSSPL]);
const AREAS: Item = Of(&[word::ALL, word::DS, word::PS, word::AXIS, word::FEED, word::STEPOV]);
const DIRECTION: Item = Of(&[word::UCONST, word::VCONST]);
const RELATION: Item = Of(&[word::TO, word::ON, word::PAST]);
const STEP: Item = Of(&[word::INCR, word::CHORD]);
const MEASURE: Item = Of(&[word::PARAM, word::FLOW]);
const PLACES: Item = Of(&[word::START, word::AWAY, word::BACK, word::THRU]);
const LIFT: Item = Of(&[word::NORMPS, word::AXIS]);

const SCON: &[Shape] = &[
    open(&[W(word::INIT), AREAS], &[&[AREAS], &[AREAS], &[AREAS], &[AREAS]]),
    open(&[W(word::DS), SC, W(word::PARAM), N, N, Of(&[word::AT, word::ON]), V], &[&[N]]),
    open(
        &[W(word::DS), SC, W(word::PARAM), N, N, Of(&[word::AT, word::ON]), W(word::CRSSPL)],
        &[&[N]],
    ),
    open(&[W(word::DS), SS, W(word::PARAM), N, N, N, N, Of(&[word::AT, word::ON]), V], &[&[N]]),
    open(
        &[W(word::DS), SS, W(word::PARAM), N, N, N, N, Of(&[word::AT, word::ON]), W(word::NORMAL)],
        &[&[N]],
    ),
    fixed(&[W(word::PS), Of(&[word::TO, word::ON]), SS, SIGN, N]),
    open(&[W(word::AXIS), V], &[&[SIGN]]),
    open(&[W(word::AXIS), W(word::NORMDS)], &[&[SIGN]]),
    fixed(&[W(word::AXIS), W(word::ATANGL), Of(&[word::DS, word::PS]), N, W(word::CUTANG), N]),
    fixed(&[
        W(word::AXIS),
        W(word::ATANGL),
        Of(&[word::DS, word::PS]),
        N,
        W(word::CUTANG),
        Of(&[word::LEAD, word::LAG]),
        N,
    ]),
    fixed(&[W(word::FEED), PL]),
    fixed(&[W(word::FEED), N, N, N, N]),
    fixed(&[W(word::STEPOV), N, N, N, N]),
];

const SMIL: &[Shape] = &[
    fixed(&[W(word::POSN), W(word::DS), W(word::PARAM), N, N, W(word::INCR), N]),
    fixed(&[W(word::POSN), W(word::DS), W(word::PARAM), N, N, W(word::INCR), V]),
    fixed(&[W(word::POSN), W(word::DS), W(word::PARAM), N, N, W(word::INCR), PL]),
    open(&[W(word::PATH), W(word::DS), W(word::PARAM), N, N, ALONG, SIGN], &[&[N]]),
    open(
        &[
            Of(&[word::ZIGZAG, word::PICKFD]),
            W(word::DS),
            W(word::PARAM),
            N,
            N,
            ALONG,
            SIGN,
            W(word::STEPOV),
            SIGN,
        ],
        &[&[N]],
    ),
];

const CHKSRF: &[Shape] = &[fixed(&[W(word::OFF)]), list(&[W(word::PS), AS], &[SWITCH])];

/// Diameter and height of a corner of shank and holder.
const CORNER: &[Item] = &[N, N];
const HOLDER: &[Shape] = &[
    fixed(&[W(word::OFF)]),
    open(&[N, N, N, N], &[CORNER, CORNER, CORNER, CORNER, CORNER, CORNER, CORNER, CORNER]),
];

const AVCTRL: &[Shape] = &[
    fixed(&[SWITCH]),
    open(&[LIFT], &[&[W(word::LIMIT), N]]),
    open(
        &[W(word::CUTANG), W(word::CONST), N, W(word::RANGE), N, N],
        &[&[LIFT], &[W(word::LIMIT), N]],
    ),
];

/// What a line of a surface or along a curve may be limited and stepped by.
const LINE: &[&[Item]] = &[
    &[W(word::START), N],
    &[W(word::START), RELATION, PL],
    &[W(word::THRU), N],
    &[W(word::THRU), RELATION, PL],
    &[W(word::AT), N],
    &[W(word::AT), RELATION, PL],
    &[W(word::INVERS)],
    &[W(word::MIRROR)],
    &[STEP, N],
    &[W(word::LENGTH), N],
];
const CURVE: &[&[Item]] =
    &[&[W(word::START), N], &[W(word::THRU), N], &[MEASURE], &[STEP, N], &[W(word::LENGTH), N]];

const GOLOFT: &[Shape] = &[open(&[SS, DIRECTION, N], LINE), open(&[SS], LINE), open(&[SC], CURVE)];

const PLOTFT: &[Shape] = &[
    open(
        &[SS, W(word::GRID)],
        &[
            &[W(word::UCONST)],
            &[W(word::UCONST), N],
            &[W(word::VCONST)],
            &[W(word::VCONST), N],
            &[STEP, N],
        ],
    ),
    open(&[SS, DIRECTION, N], LINE),
    open(&[SC], CURVE),
];

const RETRACTS: &[&[Item]] = &[
    &[Of(&[word::PICKFD, word::ZIGZAG])],
    &[W(word::SCALOP), N],
    &[W(word::MAXSTP), N],
    &[W(word::RETR), N],
    &[W(word::RETR), V],
    &[W(word::RETR), PL],
    &[W(word::START), N],
    &[W(word::THRU), N],
    &[W(word::INVERS)],
    &[W(word::AT), N],
];
const GOMILL: &[Shape] = &[
    open(&[SS, DIRECTION, N, W(word::STEPOV), N], RETRACTS),
    open(&[SS, DIRECTION, N], RETRACTS),
    open(&[SC, DIRECTION, N], RETRACTS),
];

const APPROACH: &[&[Item]] = &[
    &[W(word::MOTDIR), N],
    &[W(word::NORMAL), N],
    &[W(word::PARLEL), V],
    &[W(word::FEED), N],
    &[W(word::CLEARS), SS],
    &[W(word::CLEARS), S],
];
const GCLEAR: &[Shape] = &[
    open(&[PLACES, SWITCH], APPROACH),
    open(&[SWITCH], APPROACH),
    open(&[PLACES, W(word::MOTDIR), N], APPROACH),
    open(&[PLACES, W(word::NORMAL), N], APPROACH),
    open(&[PLACES, W(word::PARLEL), V], APPROACH),
    open(&[PLACES, W(word::FEED), N], APPROACH),
    open(&[PLACES, W(word::CLEARS), SS], APPROACH),
    open(&[PLACES, W(word::CLEARS), S], APPROACH),
    open(&[W(word::MOTDIR), N], APPROACH),
    open(&[W(word::NORMAL), N], APPROACH),
    open(&[W(word::PARLEL), V], APPROACH),
    open(&[W(word::FEED), N], APPROACH),
    open(&[W(word::CLEARS), SS], APPROACH),
    open(&[W(word::CLEARS), S], APPROACH),
];

/// What CLDAT keeps of each cut vector.
const KEPT: &[&[Item]] = &[
    &[W(word::TP)],
    &[W(word::TA)],
    &[W(word::TV)],
    &[W(word::PPS)],
    &[W(word::PDS)],
    &[W(word::NPS)],
    &[W(word::NDS)],
    &[W(word::UVPPS)],
    &[W(word::UVPDS)],
];
const CLDAT: &[Shape] = &[open(&[W(word::START), N], KEPT), fixed(&[W(word::NOMORE), N])];

const TLPROJ: &[Shape] = &[
    open(&[V], &[&[Of(&[word::ON, word::AT])]]),
    open(&[W(word::NORMAL)], &[&[Of(&[word::ON, word::AT])]]),
    fixed(&[W(word::OFF)]),
];

const REGION: &[Shape] =
    &[fixed(&[N, Of(&[word::IN, word::OUT, word::OFF])]), fixed(&[W(word::OFF)])];

/// The shapes of a word.
pub(super) fn shapes(word: Word) -> &'static [Shape] {
    match word {
        word::SCON => SCON,
        word::SMIL => SMIL,
        word::CHKSRF => CHKSRF,
        word::AVCTRL => AVCTRL,
        word::HOLDER => HOLDER,
        word::GOLOFT => GOLOFT,
        word::PLOTFT => PLOTFT,
        word::GOMILL => GOMILL,
        word::GCLEAR => GCLEAR,
        word::CLDAT => CLDAT,
        word::REGION => REGION,
        word::TLPROJ => TLPROJ,
        _ => &[],
    }
}

impl Interpreter<'_> {
    /// SCON, SMIL, GOLOFT and their kin.
    ///
    /// SMIL says nothing of its own where a SCON before it was refused: what it misses was told there.
    pub(super) fn regional(&mut self, word: Word, clause: &Clause) -> Known<()> {
        let known = self.regional_args(word, clause);
        let is_init = |args: &Vec<protap::Arg>| matches!(args.first(), Some(protap::Arg::Word(w)) if w == "INIT");
        match (word, &known) {
            (word::SCON, Err(Poisoned)) => self.state.doubt.milling = true,
            (word::SCON, Ok(args)) if is_init(args) => self.state.doubt.milling = false,
            (word::SMIL, _) if self.state.doubt.milling => return Err(Poisoned),
            _ => {}
        }
        self.emit(Kind::Regional { word: word.text().into(), args: known? });
        Ok(())
    }

    fn regional_args(&mut self, word: Word, clause: &Clause) -> Known<Vec<protap::Arg>> {
        let args = self.args(clause, Names::Defined)?;
        self.shaped(word, shapes(word), clause, &args)?;
        self.rising(word, &args)?;
        self.handed_on(args)
    }

    /// The limits of a drive curve or surface go upwards, and numbers of areas and scallops are not
    /// negative where that means nothing.
    fn rising(&mut self, word: Word, args: &[Arg]) -> Known<()> {
        if word != word::SCON || args.first().and_then(Arg::word) != Some(word::DS) {
            return Ok(());
        }
        let numbers: Vec<(usize, f64)> =
            (3..7).map_while(|i| Some((i, args.get(i)?.number()?))).collect();
        for pair in numbers.chunks(2) {
            let [(_, low), (at, high)] = pair else { continue };
            if low > high {
                self.error(
                    Diagnostic::error(
                        codes::BAD_ARGUMENTS,
                        args[*at].span,
                        format!(
                            "the range of parameters ends at {high}, before it begins at {low}"
                        ),
                    )
                    .help("give the smaller one first; SMIL says the direction"),
                );
                return Err(Poisoned);
            }
        }
        Ok(())
    }
}
