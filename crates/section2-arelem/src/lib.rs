//! Section 2: the arithmetic element, cut vectors along drive and part surfaces
