//! Cutter against surfaces: normal distance, gap, penetration, swept gap
