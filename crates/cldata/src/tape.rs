//! Binary records of APT-360 and APT-III, as their CL editors put them out.
//!
//! A record is four 32-bit integers, little-endian: its number, the number n of words, type and subtype;
//! then n words of eight bytes: a double, or a word code as an integer followed by 32 zero bits, or six
//! characters and two blanks. A byte `ff` may end the file.
//!
//! | type | subtype | words |
//! | --- | --- | --- |
//! | 1000 | statement number | |
//! | 2000 | code of the major word | its arguments |
//! | 3000 | 2 | 0, 4, 9, name, subscript, x y z i j k r: circle of the motion that follows |
//! | 5000 | 3 FROM, 5 GOTO, 6 goes on | name, subscript, points of 3 or, with axis, 6 |
//! | 6000 | 1 CUT, 4 INTOL, 5 OUTTOL, 6 CUTTER | values |
//! | 9000 | 2 MULTAX, 9 UNITS | values |
//! | 13000 | 4 CLPRNT | 0 off, 1 on, 2 the whole program, 3 OPTION |
//! | 14000 | 0 FINI | |
//!
//! The format tells start-up and continuous motion not from GOTO, forms not from their numbers, and has
//! no comments. Words that have no code stand as characters, those of more than six behind a count; a
//! statement of a major word without code has subtype 0 and begins with the word.

mod read;
mod words;
mod write;

pub use read::TapeReader;
pub(crate) use read::looks_like;
pub use write::TapeWriter;

/// How records are set off.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Framing {
    /// Four integers: number, count of words, type, subtype.
    Tape,
    /// FORTRAN's length before and after, three integers: number, type, subtype.
    Fortran {
        /// Most significant byte first.
        big: bool,
    },
}
