//! Section 3, editing and reading of CL data: `APT3xxx`.

use super::codes;

codes! {
    SECTION3:
    UNREADABLE_CL = 3001, "a CL record that cannot be read";
    UNKNOWN_CL_WORD = 3002, "a word of a CL file that no table has";
    CL_VALUE = 3003, "a value of a CL record that was taken otherwise than it stands";
    ARC_OFF_CIRCLE = 3004, "an arc whose start or end is not on its circle";
    CL_LINE_TOO_LONG = 3005, "a line of a CL file that is too long";
    CL_UNIT = 3006, "a CL file that does not state its unit";
    CL_UNENDED = 3007, "a CL file that ends without FINI";
    NO_INDEX = 3101, "a COPY or NOMORE without its INDEX";
    INDEX_TWICE = 3102, "an INDEX number that stands twice";
    NESTED_TOO_DEEP = 3103, "too many ranges of INDEX within one another";
    TOO_MANY_COPIES = 3104, "more copies than a program can hold";
    INDEX_UNUSED = 3105, "an INDEX that nothing closes or copies";
    CL_NOT_CARRIED = 3106, "something that TRACUT or COPY cannot carry properly";
    VTLAXS_REFUSED = 3107, "a path that VTLAXS cannot tilt";
    SUBPROGRAM = 3108, "a DEFSUB without its end, called within itself, or not there";
    COPY_OVERLAP = 3109, "ranges of COPY that overlap";
}
