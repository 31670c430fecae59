//! Section 4, post-processing: `APT4xxx`.

use super::codes;

codes! {
    SECTION4:
    NO_FEED = 4001, "a cut without a feed rate";
    MACHINE_FILE = 4002, "a machine file that cannot be right";
    MACHINE_ASSUMED = 4003, "no known machine is named";
    AXIS_OUT_OF_REACH = 4004, "a tool axis that the machine cannot take";
    CYCLE_INCOMPLETE = 4005, "a cycle without what it needs";
    WORD_LACKING = 4006, "a word for which the machine has nothing";
    POST_ARGUMENTS = 4007, "arguments that a post-processor word does not have";
    OVER_LIMIT = 4008, "beyond a limit of the machine";
    TOO_GREAT = 4009, "a number too great for a block";
    AFTER_END = 4010, "work after the end of the program";
    INSERT_NO_BLOCK = 4011, "inserted text that is no block";
    DEFAULT_FEED = 4012, "the feed of the machine file is used";
    WORD_IGNORED = 4013, "a word that means nothing to this machine";
    WORD_UNKNOWN = 4014, "a word that is not known";
    COMPENSATION = 4015, "compensation where the control cannot have it";
    WEAR_ONLY = 4016, "compensation of wear only";
    UNREAD_BY_POST = 4017, "a CL statement that the post-processor leaves out";
    NOT_READY = 4018, "a first cut without spindle or tool";
    ARC_WITHOUT_START = 4019, "an arc from an unknown position";
    MORE_MESSAGES = 4020, "more messages than are shown";
    STAYS_CLEAR = 4021, "a retract from beyond the clearance plane";
    TOOL_LENGTH = 4022, "a tool length that is needed and not known";
    WIND_BACK = 4023, "rotary axes that turn over within a motion";
    RAPID_IN_STOCK = 4024, "a rapid motion through the stock";
    OFF_TURNING_PLANE = 4026, "a position off the plane of a lathe";
    THREAD = 4027, "a thread that cannot be cut so";
    ARCS_FITTED = 4028, "arcs in place of short lines";
    INDEXED = 4029, "a turn of a table or head that cannot be";
    OTHER_FRAME = 4030, "a coordinate system that changes within a file";
    SHARED_OFFSET = 4031, "two tools with one length offset";
    DOUBTFUL_FEED = 4032, "a feed a minute that is so small";
    STOCK_UNCHECKED = 4025, "motion that cannot be checked against the stock";
}
