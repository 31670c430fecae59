//! Section 3, editing and reading of CL data: `APT3xxx`.

use super::codes;

codes! {
    SECTION3:
    UNREADABLE_CL = 3001, "a CL record that cannot be read";
}
