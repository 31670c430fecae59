//! Verification: `APT5xxx`.

use super::codes;

codes! {
    VERIFICATION:
    REFUTED = 5001, "a cut vector leaves its tolerance band";
    UNPROVED = 5002, "a cut vector could not be proved";
    UNMATCHED = 5003, "a CL file that does not go with the program";
    REAL_CUTTER = 5004, "the real cutter cuts in where its disk does not";
    RAPID_CUT = 5005, "a cut at rapid";
    RAPID_LOW = 5006, "a rapid motion below the clearance plane";
    CORNERS = 5007, "corners that stand at the ends of passes, or beside edges";
    RAPID_ENDS_LOW = 5008, "a rapid motion that ends below the part surface";
    THROUGH = 5009, "a way that goes through a surface";
    RAPID_ALONG = 5010, "a motion along surfaces at rapid";
    FEED_CUT = 5011, "a motion from point to point that cuts in";
    NOT_THE_CL = 5401, "machine code that does not do what the CL data says";
}
