//! Section 2: regional milling of sculptured surfaces
