//! The APT part program compiler.
fn main() {}
