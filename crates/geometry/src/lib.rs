//! Points, curves, surfaces, matrices, the cutter: definitions and evaluation
