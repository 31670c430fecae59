//! CL text after ISO 4343, the default form of a `.cl` file.
//!
//! One statement a line, in the part program's own words: `UNITS/MM`, `CUTTER/10,0,5,0,0,0,50`,
//! `GOTO/x,y,z` or with `,i,j,k` under MULTAX, post-processor words as they were written. The unit is
//! always stated, after PARTNO. What the standard has no statement for stands in comments that other
//! readers skip:
//!
//! | comment | says |
//! | --- | --- |
//! | `$$ LINE n`, `$$ LINE n FILE name` | what follows comes from this line of the part program; stands before each motion |
//! | `$$ PATH kind name(i)` | the next motion is a `STARTUP` or `CONTINUOUS` one, along or to the surface or point of that name |
//! | `$$ CIRCLE x,y,z,i,j,k,r` | the points of the next motion lie on this circle of the tool end |
//! | `$$ GEOMETRY n KIND m ..` | argument n of the next post word is a geometric form: its name, subscript and m canonical elements stand there |
//!
//! A circular move of which only the end is known is `MOVARC/x,y,z,i,j,k,r,ANGLE,sweep`, then `GOTO/`.

mod marks;
mod write;

pub(crate) use marks::{is_reserved, kind_word};
pub use write::{TextOptions, TextWriter};
