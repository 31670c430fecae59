//! Section 2, the arithmetic element and regional milling: `APT2xxx`.

use super::codes;

codes! {
    SECTION2:
    NO_POSITION = 2001, "a motion before the tool has a position";
    NO_CUTTER = 2002, "a surface is to be touched and no cutter is given";
    OFF_DRIVE_SURFACE = 2003, "the tool is not within tolerance of the drive surface";
    OFF_PART_SURFACE = 2004, "the tool is not within tolerance of the part surface";
    WRONG_SIDE = 2005, "the tool is not beside the drive surface where the word says";
    UNCLEAR_DIRECTION = 2006, "a direction word that does not say which way";
    ASSUMED_DIRECTION = 2007, "a direction word with no direction before it";
    CHECK_NOT_REACHED = 2008, "the check surface is not reached";
    NO_TANGENCY = 2009, "surfaces that are not tangent where the motion should end";
    CUTTER_TOO_LARGE = 2010, "the cutter does not fit into the surface";
    NO_START = 2011, "a start-up without a position that satisfies it";
    DIRECTION_MISSES = 2012, "the given direction does not lead to the surface";
    NO_SIDE = 2013, "TO or PAST while the tool stands on the surface";
    NO_CHECK_SURFACE = 2014, "a motion without a check surface";
    NOT_A_SURFACE = 2015, "a form that cannot guide the tool";
    UNSUPPORTED_MOTION = 2016, "a motion that cannot be computed yet";
    POCKET = 2017, "a pocket that cannot be cleared";
    NO_CONTACT = 2018, "a surface that no place of the cutter faces";
    SIDE_BY_SIDE = 2019, "drive and part surface that run side by side";
    NO_AXIS = 2020, "a tool axis that cannot be had";
    NO_PLACE = 2021, "two surfaces that the cutter cannot be at";
    CUTTER_NO_SOLID = 2022, "a cutter that is no solid";
    SIDE_FOULS = 2023, "the side of the cutter cuts into the drive surface that its edge follows";
    AMBIGUOUS_START = 2024, "a start-up with two positions that are equally near";
    CONTACT_NOT_CHOSEN = 2025, "RADIUS or HIGHT of TLAXIS along a surface";
    MATERIAL_LEFT = 2026, "a pocket whose passes leave material";
    THICK_BEYOND_CUTTER = 2027, "a negative thickness greater than the radius of the cutter";
    LIFTED_TO_PART = 2028, "a start-up that lifts the tool to a part surface that was not given";
    AXIS_LEFT_OUT = 2029, "a tool that leans without MULTAX";
    SLOW_DOWN = 2030, "a slow-down before the check surface that slows nothing down";
    AREA_NOT_SET = 2040, "regional milling before its areas are set";
    REGION_VALUE = 2041, "a number or direction of regional milling out of its range";
    PART_NOT_MET = 2042, "a drive point from which the part surface is not met";
    NO_CHORD = 2043, "a path of regional milling that no chord keeps in tolerance";
    PATH_TOO_LONG = 2044, "a path with more points or more length than allowed";
    UNFIT_SURFACE = 2045, "a sculptured curve or surface that cannot be fitted";
    INTERFERENCE = 2046, "the cutter gouges a checked surface and cannot avoid it";
    AVOIDED = 2047, "a gouge that was avoided, told at PRINT/AVPRT,ON";
    FIRST_POINT = 2048, "a first point that was to be left out, and the tool stands elsewhere";
    BETWEEN_PASSES = 2049, "a way between passes that goes through a surface";
    ODD_CONTACT = 2050, "a cutter that touches with its tip or the rim of its top";
    NO_MEETING = 2051, "surfaces of INTSEC whose curves are not found";
    MEETING = 2052, "the curves that INTSEC found";
    LEFT_STANDING = 2053, "passes that leave material where the contact jumps";
    TOO_THIN = 2054, "a tool too thin to be seen by CHKSRF";
    NO_OUTLINE = 2055, "what makes no outline of REGION";
    COMES_BACK = 2056, "PAST where the cutter never gets past";
    STRAIGHT_OVER = 2057, "a line that goes straight through what REGION leaves out";
    LEFT_BY_OFFSET = 2058, "OFFSET that leaves its drive surface";
    NO_EFFECT = 2059, "a word that has no effect on regional milling";
    BARE_HOLDER = 2060, "HOLDER while nothing is checked";
    WHOLLY_BEYOND = 2061, "motion wholly beyond the border of a sculptured surface";
    BEGINS_IN = 2062, "TO a check surface in which the cutter stands at the start";
    BELOW_FLOOR = 2063, "a pocket below whose floor the cutter reaches";
    FAR_LIFT = 2064, "a lift of AVCTRL farther than three lengths of the tool";
    NEVER_CUT = 2065, "DNTCUT to the end of the part";
    ENDS_ON_PART = 2066, "the tool end stays on the part surface, the cutter in it";
    AXIS_ENDED = 2067, "FROM or GOTO with an axis ends TLAXIS";
}
