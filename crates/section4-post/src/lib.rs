//! Section 4: from cutter location data to machine director text
