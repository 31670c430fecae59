//! Section 4, post-processing: `APT4xxx`.

use super::codes;

codes! {
    SECTION4:
    NO_FEED = 4001, "a cut without a feed rate";
}
