//! Files and limits: `APT0xxx`.

use super::codes;

codes! {
    FILES:
    UNREADABLE_FILE = 1, "a file cannot be read";
    UNWRITABLE_FILE = 2, "a file cannot be written";
    FILE_TOO_LARGE = 3, "a file is larger than the limit";
    NOT_TEXT = 4, "a file is not text";
    OUTSIDE_FOLDERS = 5, "a file outside the allowed folders was asked for";
}
