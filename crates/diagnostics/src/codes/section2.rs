//! Section 2, the arithmetic element and regional milling: `APT2xxx`.

use super::codes;

codes! {
    SECTION2:
    NO_POSITION = 2001, "a motion before the tool has a position";
}
