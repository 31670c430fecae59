//! The numeric part program: records between Section 1 and Section 2
