//! Section 1, translation: `APT1xxx`.

use super::codes;

codes! {
    SECTION1:
    ILLEGAL_CHARACTER = 1001, "a character that APT does not have";
    EXPECTED_OTHERWISE = 1002, "a statement that cannot be read";
    UNCLOSED_BRACKET = 1003, "a bracket that is not closed";
    UNOPENED_BRACKET = 1004, "a closing bracket without an opening one";
    UNCLOSED_QUOTE = 1005, "a quoted text that is not closed";
    NUMBER_TOO_LARGE = 1006, "a number that is too large";
    CONTINUED_PAST_END = 1007, "a statement that goes on past the end of the file";
    TOO_DEEP = 1008, "an expression that is nested too deep";
    STATEMENT_TOO_LONG = 1009, "a statement that is too long";
}
