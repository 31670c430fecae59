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
use crate::define::Item::{self, AS, Num, Of, PL, S, SC, SS, V, W};
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

/// Limits of the drive, and the parameters of a place on it.
const U1: Item = Num("the first limit of u");
const U2: Item = Num("the second limit of u");
const V1: Item = Num("the first limit of v");
const V2: Item = Num("the second limit of v");
const U: Item = Num("the parameter u");
const VP: Item = Num("the parameter v");
const DRIVEN: Item = Num("the offset of the drive");
const OFFSET: Item = Num("the distance from the place");
const SLEW: Item = Num("the slew angle");
const TILT: Item = Num("the tilt angle");
/// Behind the place of SMIL: is its first point left out?
const SKIP: Item = Num("1 to leave the first point out");

const SCON: &[Shape] = &[
    open(&[W(word::INIT), AREAS], &[&[AREAS], &[AREAS], &[AREAS], &[AREAS]]),
    open(&[W(word::DS), SC, W(word::PARAM), U1, U2, Of(&[word::AT, word::ON]), V], &[&[DRIVEN]]),
    open(
        &[W(word::DS), SC, W(word::PARAM), U1, U2, Of(&[word::AT, word::ON]), W(word::CRSSPL)],
        &[&[DRIVEN]],
    ),
    open(
        &[W(word::DS), SS, W(word::PARAM), U1, U2, V1, V2, Of(&[word::AT, word::ON]), V],
        &[&[DRIVEN]],
    ),
    open(
        &[
            W(word::DS),
            SS,
            W(word::PARAM),
            U1,
            U2,
            V1,
            V2,
            Of(&[word::AT, word::ON]),
            W(word::NORMAL),
        ],
        &[&[DRIVEN]],
    ),
    fixed(&[W(word::PS), Of(&[word::TO, word::ON]), SS, SIGN, Num("the thickness")]),
    open(&[W(word::AXIS), V], &[&[SIGN]]),
    open(&[W(word::AXIS), W(word::NORMDS)], &[&[SIGN]]),
    fixed(&[
        W(word::AXIS),
        W(word::ATANGL),
        Of(&[word::DS, word::PS]),
        SLEW,
        W(word::CUTANG),
        TILT,
    ]),
    fixed(&[
        W(word::AXIS),
        W(word::ATANGL),
        Of(&[word::DS, word::PS]),
        SLEW,
        W(word::CUTANG),
        Of(&[word::LEAD, word::LAG]),
        TILT,
    ]),
    fixed(&[W(word::FEED), PL]),
    fixed(&[
        W(word::FEED),
        Num("the feed along a pass"),
        Num("the feed between passes"),
        Num("the feed down"),
        Num("the feed up"),
    ]),
    fixed(&[
        W(word::STEPOV),
        Num("the greatest height of the scallops"),
        Num("the greatest step"),
        Num("the lift between passes"),
        Num("the greatest number of passes"),
    ]),
];

const SMIL: &[Shape] = &[
    fixed(&[W(word::POSN), W(word::DS), W(word::PARAM), U, VP, W(word::INCR), OFFSET]),
    fixed(&[W(word::POSN), W(word::DS), W(word::PARAM), U, VP, W(word::INCR), V]),
    fixed(&[W(word::POSN), W(word::DS), W(word::PARAM), U, VP, W(word::INCR), PL]),
    open(&[W(word::PATH), W(word::DS), W(word::PARAM), U, VP, ALONG, SIGN], &[&[SKIP]]),
    open(
        &[
            Of(&[word::ZIGZAG, word::PICKFD]),
            W(word::DS),
            W(word::PARAM),
            U,
            VP,
            ALONG,
            SIGN,
            W(word::STEPOV),
            SIGN,
        ],
        &[&[SKIP]],
    ),
];

const CHKSRF: &[Shape] = &[fixed(&[W(word::OFF)]), list(&[W(word::PS), AS], &[SWITCH])];

/// Diameter and height of a corner of shank and holder.
const CORNER: &[Item] = &[DIAMETER, HEIGHT];
const DIAMETER: Item = Num("a diameter");
const HEIGHT: Item = Num("its height above the tool end");
const HOLDER: &[Shape] = &[
    fixed(&[W(word::OFF)]),
    open(
        &[DIAMETER, HEIGHT, DIAMETER, HEIGHT],
        &[CORNER, CORNER, CORNER, CORNER, CORNER, CORNER, CORNER, CORNER],
    ),
];

const FARTHEST: Item = Num("how far it may lift");
const AVCTRL: &[Shape] = &[
    fixed(&[SWITCH]),
    open(&[LIFT], &[&[W(word::LIMIT), FARTHEST]]),
    open(
        &[
            W(word::CUTANG),
            W(word::CONST),
            Num("the angle more than it takes"),
            W(word::RANGE),
            Num("the least angle"),
            Num("the greatest angle"),
        ],
        &[&[LIFT], &[W(word::LIMIT), FARTHEST]],
    ),
];

const START: Item = Num("the parameter where it begins");
const THRU: Item = Num("the parameter where it ends");
const AT: Item = Num("the parameter of the place");
const CONSTANT: Item = Num("the constant parameter");
const STEPS: Item = Num("the step or chord");
const LONGEST: Item = Num("the greatest length");

/// What a line of a surface or along a curve may be limited and stepped by.
const LINE: &[&[Item]] = &[
    &[W(word::START), START],
    &[W(word::START), RELATION, PL],
    &[W(word::THRU), THRU],
    &[W(word::THRU), RELATION, PL],
    &[W(word::AT), AT],
    &[W(word::AT), RELATION, PL],
    &[W(word::INVERS)],
    &[W(word::MIRROR)],
    &[STEP, STEPS],
    &[W(word::LENGTH), LONGEST],
];
const CURVE: &[&[Item]] = &[
    &[W(word::START), START],
    &[W(word::THRU), THRU],
    &[MEASURE],
    &[STEP, STEPS],
    &[W(word::LENGTH), LONGEST],
];

const GOLOFT: &[Shape] =
    &[open(&[SS, DIRECTION, CONSTANT], LINE), open(&[SS], LINE), open(&[SC], CURVE)];

const LINES: Item = Num("the number of lines");
const PLOTFT: &[Shape] = &[
    open(
        &[SS, W(word::GRID)],
        &[
            &[W(word::UCONST)],
            &[W(word::UCONST), LINES],
            &[W(word::VCONST)],
            &[W(word::VCONST), LINES],
            &[STEP, STEPS],
        ],
    ),
    open(&[SS, DIRECTION, CONSTANT], LINE),
    open(&[SC], CURVE),
];

const RETRACTS: &[&[Item]] = &[
    &[Of(&[word::PICKFD, word::ZIGZAG])],
    &[W(word::SCALOP), Num("the greatest height of the scallops")],
    &[W(word::MAXSTP), Num("the greatest step")],
    &[W(word::RETR), Num("the distance along the axis")],
    &[W(word::RETR), V],
    &[W(word::RETR), PL],
    &[W(word::START), START],
    &[W(word::THRU), THRU],
    &[W(word::INVERS)],
    &[W(word::MIRROR)],
    &[W(word::AT), AT],
];
const GOMILL: &[Shape] = &[
    open(&[SS, DIRECTION, CONSTANT, W(word::STEPOV), Num("the step of the parameter")], RETRACTS),
    open(&[SS, DIRECTION, CONSTANT], RETRACTS),
    open(&[SC, DIRECTION, CONSTANT], RETRACTS),
];

const BEFORE: Item = Num("the distance along the motion");
const OFF: Item = Num("the distance off the surface");
const FEED: Item = Num("the feed");
const APPROACH: &[&[Item]] = &[
    &[W(word::MOTDIR), BEFORE],
    &[W(word::NORMAL), OFF],
    &[W(word::PARLEL), V],
    &[W(word::FEED), FEED],
    &[W(word::CLEARS), SS],
    &[W(word::CLEARS), S],
];
const GCLEAR: &[Shape] = &[
    open(&[PLACES, SWITCH], APPROACH),
    open(&[SWITCH], APPROACH),
    open(&[PLACES, W(word::MOTDIR), BEFORE], APPROACH),
    open(&[PLACES, W(word::NORMAL), OFF], APPROACH),
    open(&[PLACES, W(word::PARLEL), V], APPROACH),
    open(&[PLACES, W(word::FEED), FEED], APPROACH),
    open(&[PLACES, W(word::CLEARS), SS], APPROACH),
    open(&[PLACES, W(word::CLEARS), S], APPROACH),
    open(&[W(word::MOTDIR), BEFORE], APPROACH),
    open(&[W(word::NORMAL), OFF], APPROACH),
    open(&[W(word::PARLEL), V], APPROACH),
    open(&[W(word::FEED), FEED], APPROACH),
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
const SECTION: Item = Num("the number of the section");
const CLDAT: &[Shape] =
    &[open(&[W(word::START), SECTION], KEPT), fixed(&[W(word::NOMORE), SECTION])];

const TLPROJ: &[Shape] = &[
    open(&[V], &[&[Of(&[word::ON, word::AT])]]),
    open(&[W(word::NORMAL)], &[&[Of(&[word::ON, word::AT])]]),
    fixed(&[W(word::OFF)]),
];

const REGION: &[Shape] =
    &[fixed(&[SECTION, Of(&[word::IN, word::OUT, word::OFF])]), fixed(&[W(word::OFF)])];

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
