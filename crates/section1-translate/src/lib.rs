//! Section 1: from statements to the numeric part program

pub mod define;
