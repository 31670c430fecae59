//! Verification: `APT5xxx`.

use super::codes;

codes! {
    VERIFICATION:
    REFUTED = 5001, "a cut vector leaves its tolerance band";
    UNPROVED = 5002, "a cut vector could not be proved";
    NOT_THE_CL = 5401, "machine code that does not do what the CL data says";
}
