//! Section 0: conducts the Sections over a World; the face of the library
