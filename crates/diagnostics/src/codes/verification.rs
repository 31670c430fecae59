//! Verification: `APT5xxx`.

use super::codes;

codes! {
    VERIFICATION:
    REFUTED = 5001, "a cut vector leaves its tolerance band";
    UNPROVED = 5002, "a cut vector could not be proved";
}
