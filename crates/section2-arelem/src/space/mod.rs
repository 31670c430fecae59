//! Motion in space (APT: `ARLM3`): any drive, part and check surfaces, any cutter, fixed or turning axis.

mod band;
mod begin;
mod blocked;
mod contacts;
mod corner;
mod ends;
mod follow;
mod guided;
mod joined;
mod judge;
mod keep;
mod kinks;
mod lengths;
mod longest;
mod loops;
mod meet;
mod nearest;
mod overlooked;
mod pace;
mod placing;
mod refusal;
mod run;
mod settle;
mod start;
mod stride;
mod swing;
mod tangent;
mod track;
mod turning;
mod watch;
mod way;

pub(crate) use judge::between;
pub(crate) use keep::{Keep, Pose};
pub(crate) use run::run;
pub(crate) use start::start;
pub(crate) use watch::Watch;
