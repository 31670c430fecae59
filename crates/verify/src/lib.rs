//! Proof or refutation of every cut vector against its surfaces
