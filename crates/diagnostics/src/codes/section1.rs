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
    TEXT_BEHIND_CARD = 1010, "text behind column 72 is not read";
    BLANK_IN_NUMBER = 1011, "a blank inside a number";
    MISSING_SEPARATOR = 1012, "two words with no sign between them";
    NCL_COMMENT = 1013, "a comment of the dialect NCL";
    NO_SUCH_FORMAT = 1200, "arguments that no format of a definition reads";
    WRONG_ARGUMENT = 1201, "an argument of another kind than the format wants";
    PARALLEL = 1202, "lines or planes that do not meet";
    APART = 1203, "curves that do not meet";
    COINCIDE = 1204, "points or curves that fall together";
    DEPENDENT = 1205, "data that do not fix the definition";
    MISPLACED = 1206, "a point where it must not lie";
    NO_LENGTH = 1207, "a vector without length";
    OUT_OF_RANGE = 1208, "a number out of its range";
    LEANS = 1209, "a plane or cylinder that leans";
    UNDECIDED = 1210, "a modifier that does not choose";
    NOTHING_THERE = 1211, "no solution on the side named";
    FLAT_MATRIX = 1212, "a matrix that flattens space";
    NOT_SQUARE = 1213, "planes that are not at right angles";
    NO_SUCH_POINT = 1214, "a pattern without that point";
    TOO_MANY_POINTS = 1215, "more points than the limit";
    TOO_FEW = 1216, "too few points or values";
    NO_CURVE = 1217, "coefficients without a curve or surface";
    NO_FIT = 1218, "a curve that cannot be faired";
    CANON_ELEMENTS = 1219, "canonical elements that do not fit";
    NOT_CARRIED = 1220, "a form that REFSYS cannot carry";
    STEEP_ZSURF = 1221, "a ZSURF plane that gives no z";
}
