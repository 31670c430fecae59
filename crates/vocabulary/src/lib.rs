//! APT words, their classes and codes by dialect
