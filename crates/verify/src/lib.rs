//! Proof or refutation of every cut vector against the surfaces that governed it.
//!
//! Shares with Section 2 the definitions of surfaces and cutter, and nothing else: bounds rest on support
//! functions, so that a direction that was found badly makes a proof weaker and never wrong. The answer for
//! each cut vector is *proved*, *refuted* with place and depth, or *not decided*.

mod around;
mod asked;
mod batch;
mod behind;
mod beside;
mod between;
mod beyond;
mod bound;
mod certificate;
mod chain;
mod coming;
mod curved;
mod cut;
mod deep;
mod demand;
mod deviation;
mod each;
mod foreign;
mod free;
mod hollow;
mod hurried;
mod inside;
mod joined;
mod joint;
mod judged;
mod kept;
mod level;
mod limited;
mod milled;
mod outline;
mod outside;
mod oval;
mod over;
mod paraboloid;
mod passes;
mod past;
mod pile;
mod ridge;
mod rings;
mod scallop;
mod search;
mod sheet;
mod sheets;
mod solid;
mod statement;
mod swath;
mod sweep;
mod tool;
mod upright;
mod valley;
mod verifier;
mod witness;

pub use batch::Batch;
pub use certificate::{
    Breach, Certificate, Fault, LeftOut, RapidCut, StatementProof, SurfaceBound,
};
pub use deviation::deviation_svg;
pub use foreign::{Astray, Marks, Matched, matched, times_as_large};
pub use verifier::{Effort, Verifier, tells_gouge};
