//! Section 1, translation: `APT1xxx`.

use super::codes;

codes! {
    SECTION1:
    ILLEGAL_CHARACTER = 1001, "a character that APT does not have";
    EXPECTED_OTHERWISE = 1002, "a statement that cannot be read";
}
