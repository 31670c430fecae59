//! Files and limits: `APT0xxx`.

use super::codes;

codes! {
    FILES:
    UNREADABLE_FILE = 1, "a file cannot be read";
    FILE_TOO_LARGE = 3, "a file is larger than the limit";
    OUTSIDE_FOLDERS = 5, "a file outside the allowed folders was asked for";
}
