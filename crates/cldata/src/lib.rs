//! Cutter location data: records, readers and writers
