//! The words. Made by `cargo xtask codegen` from `words.tsv`: change that file.

use crate::class::Class::{
    self, Control, Function, Geometry, Modifier, Motion, Operator, Post, Regional, Text,
};
use crate::entry::{Entry, K, O, entry as w, record as r, surface as s};

const NONE: Option<Class> = None;

/// How many words there are.
pub(crate) const COUNT: u16 = 988;

/// Every word, sorted by spelling; a row of codes is major, minor for each dialect.
#[rustfmt::skip]
pub(crate) static ENTRIES: [Entry; COUNT as usize] = [
    w(".AND", Operator, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w(".EQ", Operator, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w(".FALSE", Operator, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w(".GE", Operator, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w(".GT", Operator, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w(".LE", Operator, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w(".LT", Operator, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w(".NE", Operator, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w(".NOT", Operator, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w(".OR", Operator, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w(".TRUE", Operator, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("1STPECK", Modifier, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [O, K]]),
    w("2DCALC", Motion, NONE, [[r(6000, 2), O], [r(6000, 2), O], [O, O], [O, O], [O, O], [O, O]]),
    w("3DCALC", Motion, NONE, [[r(6000, 2), O], [r(6000, 2), O], [O, O], [O, O], [O, O], [O, O]]),
    w("3PT2SL", Modifier, NONE, [[O, 43], [O, 43], [O, O], [O, O], [O, O], [O, O]]),
    w("4PT1SL", Modifier, NONE, [[O, 44], [O, 44], [O, O], [O, O], [O, O], [O, O]]),
    w("5PT", Modifier, NONE, [[O, 45], [O, 45], [O, O], [O, O], [O, O], [O, O]]),
    w("AA", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 1], [O, O], [O, O]]),
    w("AAXIS", Modifier, NONE, [[O, 140], [O, 140], [O, 140], [O, 140], [O, O], [O, O]]),
    w("ABS", Function, NONE, [[O, O], [O, O], [O, O], [O, 552], [O, O], [O, O]]),
    w("ABSF", Function, NONE, [[K, O], [K, O], [O, O], [O, 552], [O, O], [O, O]]),
    w("ABSOL", Modifier, NONE, [[O, O], [O, O], [O, 180], [O, 180], [O, O], [O, O]]),
    w("ACCESS", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 830], [O, O], [O, O]]),
    w("ACOS", Function, NONE, [[O, O], [O, O], [O, O], [O, 562], [O, O], [O, O]]),
    w("ACOSF", Function, NONE, [[O, O], [O, O], [O, O], [O, 562], [O, O], [O, O]]),
    w("ACTIVE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 341], [O, O], [O, O]]),
    w("ADJUST", Modifier, NONE, [[O, 159], [O, 159], [O, 159], [O, 159], [O, O], [O, O]]),
    w("AIR", Post, NONE, [[1011, O], [1011, O], [1011, O], [1011, O], [O, O], [O, O]]),
    w("ALIGN", Post, NONE, [[O, O], [O, O], [1076, O], [1076, O], [O, O], [O, O]]),
    w("ALL", Modifier, NONE, [[O, 51], [O, 51], [O, 51], [O, 816], [O, O], [O, O]]),
    w("ALTER", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 951], [O, O], [O, O]]),
    w("ANALYZ", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 874], [O, O], [O, O]]),
    w("ANGL", Function, NONE, [[O, O], [O, O], [O, O], [O, 559], [O, O], [O, O]]),
    w("ANGLB", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("ANGLE", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("ANGLF", Function, NONE, [[K, O], [K, O], [O, O], [O, 559], [O, O], [O, O]]),
    w("ANOTE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 616], [O, O], [O, O]]),
    w("ANTSPI", Modifier, NONE, [[O, 176], [O, 176], [O, O], [O, O], [O, O], [O, O]]),
    w("APPEND", Post, NONE, [[O, O], [O, O], [1199, O], [O, O], [O, O], [O, O]]),
    w("APPLY", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("APTRAN", Control, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("APTREN", Control, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("ARC", Modifier, NONE, [[O, 87], [O, 182], [O, 182], [O, 182], [O, 87], [O, O]]),
    w("ARCDAT", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("ARCMOV", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("ARCOSB", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("ARCOSF", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("ARCSLP", Post, NONE, [[1029, O], [1029, O], [1029, O], [1029, O], [O, O], [O, O]]),
    w("ARROW", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 925], [O, O], [O, O]]),
    w("ARSINB", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("ARSINF", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("AS", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 832], [O, O], [O, O]]),
    w("ASIN", Function, NONE, [[O, O], [O, O], [O, O], [O, 558], [O, O], [O, O]]),
    w("ASINF", Function, NONE, [[O, O], [O, O], [O, O], [O, 558], [O, O], [O, O]]),
    w("ASLOPE", Post, NONE, [[1053, O], [1053, O], [O, O], [O, O], [O, O], [O, O]]),
    w("AT", Modifier, NONE, [[O, 175], [O, 189], [O, 189], [O, 189], [O, O], [O, O]]),
    w("ATAN", Function, NONE, [[O, O], [O, O], [O, O], [O, 553], [O, O], [O, O]]),
    w("ATAN2", Function, NONE, [[O, O], [O, O], [O, O], [O, 565], [O, O], [O, O]]),
    w("ATAN2B", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("ATAN2F", Function, NONE, [[K, O], [K, O], [O, O], [O, 565], [O, O], [O, O]]),
    w("ATANB", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("ATANF", Function, NONE, [[K, O], [K, O], [O, O], [O, 553], [O, O], [O, O]]),
    w("ATANGL", Modifier, NONE, [[O, 1], [O, 1], [O, 1], [O, 1], [O, O], [O, O]]),
    w("ATTRIB", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 879], [O, O], [O, O]]),
    w("AUTO", Modifier, NONE, [[O, 88], [O, 88], [O, 88], [O, 88], [O, O], [O, O]]),
    w("AUTOPS", Motion, NONE, [[r(9000, 7), O], [r(9000, 7), O], [O, O], [745, O], [O, O], [O, O]]),
    w("AUXFUN", Post, NONE, [[1022, O], [1022, O], [1022, O], [1022, O], [O, O], [O, O]]),
    w("AVCTRL", Regional, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("AVMSG", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("AVOID", Modifier, NONE, [[O, 173], [O, 187], [O, 187], [O, 327], [O, 187], [O, O]]),
    w("AVPRT", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("AWAY", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("AXIS", Modifier, NONE, [[O, O], [O, K], [O, 132], [O, 132], [O, O], [O, O]]),
    w("BACK", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("BAR", Modifier, NONE, [[O, O], [O, O], [O, 207], [O, O], [O, O], [O, O]]),
    w("BASE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 868], [O, O], [O, O]]),
    w("BAXIS", Modifier, NONE, [[O, 141], [O, 141], [O, 141], [O, 141], [O, O], [O, O]]),
    w("BCD", Modifier, NONE, [[O, 165], [O, 165], [O, O], [O, O], [O, O], [O, O]]),
    w("BEGIN", Post, Some(Modifier), [[O, O], [O, O], [O, O], [O, 58], [O, O], [K, O]]),
    w("BEVELS", Motion, NONE, [[r(6000, 2), O], [O, O], [O, O], [O, O], [O, O], [O, O]]),
    w("BINARY", Modifier, NONE, [[O, 164], [O, 164], [O, O], [O, O], [O, O], [O, O]]),
    w("BINORM", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("BLACK", Modifier, NONE, [[O, 130], [O, 130], [O, O], [O, 904], [O, O], [O, O]]),
    w("BLADE", Modifier, NONE, [[O, O], [O, O], [O, 191], [O, 191], [O, O], [O, O]]),
    w("BLOCK", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("BLUE", Modifier, NONE, [[O, 133], [O, 133], [O, O], [O, 906], [O, O], [O, O]]),
    w("BORDER", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 932], [O, O], [O, O]]),
    w("BORE", Modifier, NONE, [[O, 82], [O, 82], [O, 82], [O, 82], [O, O], [O, O]]),
    w("BORE5", Modifier, NONE, [[O, O], [O, O], [O, 209], [O, O], [O, O], [O, O]]),
    w("BORE6", Modifier, NONE, [[O, O], [O, O], [O, 210], [O, O], [O, O], [O, O]]),
    w("BORE7", Modifier, NONE, [[O, O], [O, O], [O, 211], [O, 211], [O, 211], [O, O]]),
    w("BORE8", Modifier, NONE, [[O, O], [O, O], [O, 212], [O, 212], [O, 212], [O, O]]),
    w("BORE9", Modifier, NONE, [[O, O], [O, O], [O, 213], [O, 213], [O, 213], [O, O]]),
    w("BOTH", Modifier, NONE, [[O, 83], [O, 83], [O, 83], [O, 83], [O, O], [O, O]]),
    w("BOUND", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 624], [O, O], [O, O]]),
    w("BOUNDS", Geometry, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("BOX", Modifier, NONE, [[O, O], [O, O], [O, 340], [O, 340], [O, O], [O, O]]),
    w("BREAK", Post, NONE, [[O, O], [17, O], [16, O], [16, O], [17, O], [O, O]]),
    w("BRKCHP", Modifier, NONE, [[O, O], [O, O], [O, 288], [O, O], [O, O], [O, K]]),
    w("BROWN", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 912], [O, O], [O, O]]),
    w("BSP", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 628], [O, O], [O, O]]),
    w("CA", Control, NONE, [[O, O], [O, O], [O, O], [O, 645], [O, O], [O, O]]),
    w("CALL", Control, NONE, [[K, O], [K, O], [824, O], [824, O], [O, O], [O, O]]),
    w("CALLS", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 867], [O, O], [O, O]]),
    w("CALSUB", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("CAM", Modifier, NONE, [[O, 169], [O, 169], [O, 237], [O, 237], [O, 169], [O, O]]),
    w("CAMERA", Post, NONE, [[1047, O], [1047, O], [O, O], [O, O], [O, O], [O, O]]),
    w("CAN", Function, Some(Modifier), [[O, O], [O, O], [O, O], [O, 566], [O, O], [O, O]]),
    w("CANF", Function, NONE, [[O, O], [K, O], [O, O], [O, 566], [O, O], [O, O]]),
    w("CANON", Control, NONE, [[r(3099, 0), O], [r(3099, 0), O], [O, O], [645, O], [O, O], [O, O]]),
    w("CAXIS", Modifier, NONE, [[O, 142], [O, 142], [O, 142], [O, 142], [O, O], [O, O]]),
    w("CBORE", Modifier, NONE, [[O, O], [O, O], [O, 245], [O, 245], [O, 207], [O, O]]),
    w("CBRTF", Function, NONE, [[O, O], [O, O], [O, O], [O, 569], [O, O], [O, O]]),
    w("CCLW", Modifier, NONE, [[O, 59], [O, 59], [O, 59], [O, 59], [O, O], [O, O]]),
    w("CCW", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("CE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 634], [O, O], [O, O]]),
    w("CENTER", Modifier, NONE, [[O, 2], [O, 2], [O, 2], [O, 634], [O, O], [O, O]]),
    w("CFSAVE", Control, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("CHAMFR", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 961], [O, O], [O, O]]),
    w("CHANNEL", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("CHDPT", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("CHECK", Post, NONE, [[1023, O], [1023, O], [1023, O], [1023, O], [O, O], [O, O]]),
    w("CHIPS", Modifier, NONE, [[O, O], [O, O], [O, 331], [O, 331], [O, O], [O, O]]),
    w("CHKPTS", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 669], [O, O], [O, O]]),
    w("CHKSRF", Regional, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("CHORD", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("CHUCK", Post, Some(Modifier), [[O, 138], [O, 138], [1073, O], [1073, O], [O, O], [O, O]]),
    w("CI", Geometry, NONE, [[O, O], [O, O], [O, O], [O, 607], [O, O], [O, O]]),
    w("CIRCLE", Geometry, NONE, [[s(4), O], [s(4), O], [O, O], [607, O], [O, O], [O, O]]),
    w("CIRCUL", Modifier, NONE, [[O, 75], [O, 75], [O, 75], [O, 75], [O, O], [O, O]]),
    w("CIRLIN", Modifier, NONE, [[O, 126], [O, 126], [O, O], [O, O], [O, O], [O, O]]),
    w("CLAMP", Post, NONE, [[1060, O], [1060, O], [1060, O], [1060, O], [O, O], [O, O]]),
    w("CLDAT", Regional, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("CLDATA", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("CLDATF", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("CLDIST", Post, NONE, [[O, O], [O, O], [O, O], [1077, O], [O, O], [O, O]]),
    w("CLEAR", Modifier, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [O, K]]),
    w("CLEARP", Post, NONE, [[1004, O], [1004, O], [1004, O], [1004, O], [O, O], [O, O]]),
    w("CLEARS", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("CLFILE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 823], [O, O], [O, O]]),
    w("CLIPF", Function, NONE, [[O, O], [O, O], [O, O], [O, 949], [O, O], [O, O]]),
    w("CLONE", Modifier, NONE, [[O, O], [O, O], [O, 576], [O, 576], [O, O], [O, O]]),
    w("CLOSE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 831], [O, O], [O, O]]),
    w("CLPRNT", Control, NONE, [[K, O], [r(13000, 4), O], [O, O], [813, O], [O, O], [O, O]]),
    w("CLRSRF", Post, NONE, [[1057, O], [1057, O], [1057, O], [1057, O], [O, O], [O, O]]),
    w("CLTV", Control, NONE, [[K, O], [O, O], [O, O], [O, O], [O, O], [O, O]]),
    w("CLW", Modifier, NONE, [[O, 60], [O, 60], [O, 60], [O, 60], [O, O], [O, O]]),
    w("CM", Modifier, NONE, [[O, O], [O, O], [O, 302], [O, O], [O, O], [O, O]]),
    w("CMIT", Control, NONE, [[K, O], [O, O], [O, O], [O, O], [O, O], [O, O]]),
    w("CO", Post, NONE, [[O, O], [O, O], [O, O], [1030, O], [O, O], [O, O]]),
    w("COARSE", Modifier, NONE, [[O, O], [O, O], [O, 195], [O, 195], [O, 295], [O, O]]),
    w("CODEL", Post, NONE, [[O, O], [14, O], [O, O], [O, O], [O, O], [O, O]]),
    w("COLAPS", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 343], [O, O], [O, O]]),
    w("COLF", Function, NONE, [[O, O], [O, O], [O, O], [O, 942], [O, O], [O, O]]),
    w("COLLET", Modifier, NONE, [[O, 139], [O, 139], [O, 139], [O, 139], [O, O], [O, O]]),
    w("COLOR", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 900], [O, O], [O, O]]),
    w("COMBIN", Post, Some(Modifier), [[O, O], [O, K], [1071, O], [1071, O], [1079, O], [O, O]]),
    w("COMPOS", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 612], [O, O], [O, O]]),
    w("CONE", Geometry, Some(Modifier), [[s(8), O], [s(8), O], [O, 632], [O, 632], [O, O], [O, O]]),
    w("CONIC", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 611], [O, O], [O, O]]),
    w("CONSEC", Geometry, NONE, [[s(52), O], [O, O], [O, O], [O, O], [O, O], [O, O]]),
    w("CONST", Modifier, NONE, [[O, 64], [O, 64], [O, 64], [O, 328], [O, O], [O, O]]),
    w("CONT", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("CONTCT", Motion, NONE, [[O, O], [O, O], [O, O], [O, 856], [O, O], [O, O]]),
    w("CONTIN", Control, NONE, [[O, O], [K, O], [O, O], [846, O], [O, O], [O, O]]),
    w("CONTRL", Control, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("COOLNT", Post, NONE, [[1030, O], [1030, O], [1030, O], [1030, O], [O, O], [O, O]]),
    w("COPY", Control, NONE, [[1040, O], [1040, O], [1040, O], [811, O], [O, O], [O, O]]),
    w("CORNFD", Post, NONE, [[1067, O], [1067, O], [O, O], [O, O], [O, O], [O, O]]),
    w("COS", Function, NONE, [[O, O], [O, O], [O, O], [O, 556], [O, O], [O, O]]),
    w("COSB", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("COSF", Function, NONE, [[K, O], [K, O], [O, O], [O, 556], [O, O], [O, O]]),
    w("COSHF", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("COTANB", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("COTANF", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("COUPLE", Post, NONE, [[1049, O], [1049, O], [1049, O], [1049, O], [O, O], [O, O]]),
    w("CROSS", Modifier, NONE, [[O, 3], [O, 3], [O, 3], [O, 819], [O, O], [O, O]]),
    w("CRSSPL", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("CS", Modifier, NONE, [[O, O], [O, K], [O, 753], [O, 753], [O, O], [O, O]]),
    w("CSINK", Modifier, NONE, [[O, O], [O, O], [O, 256], [O, 119], [O, O], [O, K]]),
    w("CSS", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("CSUV", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 859], [O, O], [O, O]]),
    w("CSYS", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("CTRLIN", Modifier, NONE, [[O, O], [O, 126], [O, 126], [O, 126], [O, O], [O, O]]),
    w("CU", Motion, NONE, [[O, O], [O, O], [O, O], [O, 716], [O, O], [O, O]]),
    w("CUBE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 959], [O, O], [O, O]]),
    w("CURSEG", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("CURVE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 608], [O, O], [O, O]]),
    w("CUT", Motion, NONE, [[r(6000, 1), O], [r(6000, 1), O], [803, O], [803, O], [O, O], [O, O]]),
    w("CUTANG", Modifier, NONE, [[O, 160], [O, 160], [O, 160], [O, 160], [O, O], [O, O]]),
    w("CUTCOM", Post, NONE, [[1007, O], [1007, O], [1007, O], [1007, O], [O, O], [O, O]]),
    w("CUTTER", Motion, NONE, [[r(6000, 6), O], [r(6000, 6), O], [O, O], [716, O], [O, O], [O, O]]),
    w("CV", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 608], [O, O], [O, O]]),
    w("CW", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("CY", Post, NONE, [[O, O], [O, O], [O, O], [1054, O], [O, O], [O, O]]),
    w("CYAN", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 911], [O, O], [O, O]]),
    w("CYCLE", Post, NONE, [[1054, O], [1054, O], [1054, O], [1054, O], [O, O], [O, O]]),
    w("CYLNDR", Geometry, NONE, [[s(5), O], [s(5), O], [O, O], [620, O], [O, O], [O, O]]),
    w("DAC", Control, NONE, [[K, O], [O, O], [O, O], [O, O], [O, O], [O, O]]),
    w("DARK", Modifier, NONE, [[O, 137], [O, 137], [O, O], [O, O], [O, O], [O, O]]),
    w("DASH", Modifier, NONE, [[O, 124], [O, 124], [O, 124], [O, 124], [O, 188], [O, O]]),
    w("DASHDT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 918], [O, O], [O, O]]),
    w("DASHLN", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 917], [O, O], [O, O]]),
    w("DASHSP", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 919], [O, O], [O, O]]),
    w("DATA", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 858], [O, O], [O, O]]),
    w("DBFN", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 829], [O, O], [O, O]]),
    w("DBLCIR", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 957], [O, O], [O, O]]),
    w("DC", Motion, NONE, [[O, O], [O, O], [O, O], [O, 802], [O, O], [O, O]]),
    w("DDLIM", Regional, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("DEBUG", Control, NONE, [[K, O], [O, O], [O, O], [O, O], [O, O], [O, O]]),
    w("DEBUGG", Post, NONE, [[O, O], [1032, O], [1032, O], [1032, O], [O, O], [O, O]]),
    w("DECOMP", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 618], [O, O], [O, O]]),
    w("DECR", Modifier, NONE, [[O, 65], [O, 65], [O, 65], [O, 65], [O, O], [O, O]]),
    w("DEEP", Modifier, NONE, [[O, 153], [O, 153], [O, 153], [O, 153], [O, O], [O, O]]),
    w("DEEP2", Modifier, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [O, K]]),
    w("DEEPBK", Modifier, NONE, [[O, O], [O, O], [O, 216], [O, 216], [O, 184], [O, O]]),
    w("DEEPCL", Modifier, NONE, [[O, O], [O, O], [O, 208], [O, 208], [O, 185], [O, O]]),
    w("DEFALT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 903], [O, O], [O, O]]),
    w("DEFNAM", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 899], [O, O], [O, O]]),
    w("DEFSUB", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("DELAY", Post, NONE, [[1010, O], [1010, O], [1010, O], [1010, O], [O, O], [O, O]]),
    w("DELETE", Post, NONE, [[1012, O], [1012, O], [O, O], [O, O], [O, O], [O, O]]),
    w("DELTA", Modifier, NONE, [[O, O], [O, O], [O, 188], [O, 34], [O, O], [O, O]]),
    w("DEPTH", Modifier, NONE, [[O, O], [O, O], [O, 510], [O, 510], [O, 303], [O, K]]),
    w("DIAMTR", Modifier, NONE, [[O, O], [O, O], [O, 205], [O, 205], [O, O], [O, O]]),
    w("DIMOND", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 956], [O, O], [O, O]]),
    w("DISK", Post, NONE, [[O, O], [O, O], [1097, O], [1097, O], [O, O], [O, O]]),
    w("DISPDB", Post, NONE, [[O, O], [O, O], [O, O], [1090, O], [O, O], [O, O]]),
    w("DISPLY", Post, NONE, [[1021, O], [1021, O], [1021, O], [1021, O], [O, O], [O, O]]),
    w("DIST", Function, NONE, [[O, O], [O, O], [O, O], [O, 575], [O, O], [O, O]]),
    w("DISTF", Function, NONE, [[K, O], [K, O], [O, O], [O, 575], [O, O], [O, O]]),
    w("DITTO", Modifier, NONE, [[O, 127], [O, 127], [O, 127], [O, 127], [O, O], [O, O]]),
    w("DMILL", Motion, NONE, [[r(6000, 11), O], [O, O], [O, O], [O, O], [O, O], [O, O]]),
    w("DNTCUT", Motion, NONE, [[r(6000, 1), O], [r(6000, 1), O], [O, O], [802, O], [O, O], [O, O]]),
    w("DO", Control, NONE, [[O, O], [K, O], [O, O], [844, O], [O, O], [O, O]]),
    w("DOT", Operator, Some(Function), [[O, O], [O, K], [O, O], [O, 561], [O, O], [O, O]]),
    w("DOTF", Function, NONE, [[K, O], [K, O], [O, O], [O, 561], [O, O], [O, O]]),
    w("DOTTED", Modifier, NONE, [[O, 125], [O, 125], [O, 125], [O, 125], [O, O], [O, O]]),
    w("DOWN", Modifier, NONE, [[O, 113], [O, 113], [O, 113], [O, 113], [O, O], [O, O]]),
    w("DR", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 163], [O, O], [O, O]]),
    w("DRAFT", Post, NONE, [[1059, O], [1059, O], [1059, O], [1059, O], [O, O], [O, O]]),
    w("DRAG", Modifier, NONE, [[O, O], [O, O], [O, 278], [O, 278], [O, 193], [O, O]]),
    w("DRAWLI", Post, NONE, [[17, O], [17, O], [O, O], [O, O], [O, O], [O, O]]),
    w("DRESS", Post, NONE, [[8, O], [8, O], [O, O], [O, O], [O, O], [O, O]]),
    w("DRILL", Modifier, NONE, [[O, 163], [O, 163], [O, 163], [O, 163], [O, O], [O, O]]),
    w("DS", Modifier, NONE, [[O, O], [O, K], [O, 729], [O, 729], [O, O], [O, O]]),
    w("DSTAN", Modifier, NONE, [[O, 27], [O, 27], [O, O], [O, O], [O, O], [O, O]]),
    w("DSUV", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 858], [O, O], [O, O]]),
    w("DWELL", Post, Some(Modifier), [[1058, O], [1058, O], [O, 279], [O, 197], [O, 175], [O, O]]),
    w("DYNDMP", Motion, NONE, [[r(6000, 9), O], [r(6000, 9), O], [O, O], [O, O], [O, O], [O, O]]),
    w("EDGE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 860], [O, O], [O, O]]),
    w("EJECT", Control, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("ELLIPS", Geometry, NONE, [[s(6), O], [s(6), O], [O, O], [O, O], [O, O], [O, O]]),
    w("ELMSRF", Geometry, NONE, [[s(54), O], [O, O], [O, O], [O, O], [O, O], [O, O]]),
    w("ELSE", Control, NONE, [[O, O], [O, O], [O, O], [O, 940], [O, O], [O, O]]),
    w("ELSEIF", Control, NONE, [[O, O], [O, O], [O, O], [O, 939], [O, O], [O, O]]),
    w("END", Post, Some(Modifier), [[1, O], [1, O], [1, O], [O, 499], [O, O], [O, O]]),
    w("ENDARC", Modifier, NONE, [[O, 58], [O, 58], [O, O], [O, O], [O, O], [O, O]]),
    w("ENDIF", Control, NONE, [[O, O], [O, O], [O, O], [O, 941], [O, O], [O, O]]),
    w("ENDMDI", Post, NONE, [[O, O], [1052, O], [O, O], [O, O], [O, O], [O, O]]),
    w("ENDPT", Modifier, NONE, [[O, O], [O, O], [O, 664], [O, 664], [O, O], [O, O]]),
    w("ENDSUB", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("ENGAGE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 324], [O, O], [O, O]]),
    w("ERASE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 742], [O, O], [O, O]]),
    w("ERROR", Control, NONE, [[O, O], [K, O], [1103, O], [937, O], [O, O], [O, O]]),
    w("EXHVY", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 922], [O, O], [O, O]]),
    w("EXP", Function, NONE, [[O, O], [O, O], [O, O], [O, 550], [O, O], [O, O]]),
    w("EXPF", Function, NONE, [[K, O], [K, O], [O, O], [O, 550], [O, O], [O, O]]),
    w("EXTRUD", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 633], [O, O], [O, O]]),
    w("FACE", Modifier, NONE, [[O, 81], [O, 81], [O, 81], [O, 81], [O, O], [O, O]]),
    w("FACEML", Post, NONE, [[22, O], [22, O], [O, O], [O, O], [O, O], [O, O]]),
    w("FAN", Modifier, NONE, [[O, 184], [O, O], [O, O], [O, 723], [O, O], [O, O]]),
    w("FE", Post, NONE, [[O, O], [O, O], [O, O], [1009, O], [O, O], [O, O]]),
    w("FEDRAT", Post, NONE, [[1009, O], [1009, O], [1009, O], [1009, O], [O, O], [O, O]]),
    w("FEDTO", Modifier, NONE, [[O, O], [O, O], [O, 281], [O, 281], [O, 210], [O, K]]),
    w("FEED", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("FEEDX", Modifier, NONE, [[O, O], [O, O], [O, 217], [O, O], [O, O], [O, O]]),
    w("FEEDY", Modifier, NONE, [[O, O], [O, O], [O, 218], [O, O], [O, O], [O, O]]),
    w("FEEDZ", Modifier, NONE, [[O, O], [O, O], [O, 219], [O, 219], [O, O], [O, O]]),
    w("FEET", Modifier, NONE, [[O, O], [O, O], [O, 174], [O, O], [O, O], [O, O]]),
    w("FETCH", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("FILLET", Modifier, NONE, [[O, O], [O, O], [O, 402], [O, 402], [O, 239], [O, O]]),
    w("FILTER", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 950], [O, O], [O, O]]),
    w("FIND", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 872], [O, O], [O, O]]),
    w("FINDEX", Function, NONE, [[O, O], [O, O], [O, O], [O, 573], [O, O], [O, O]]),
    w("FINE", Modifier, NONE, [[O, O], [O, O], [O, 193], [O, 193], [O, 296], [O, O]]),
    w("FINI", Control, NONE, [[r(14000, 0), O], [r(14000, 0), O], [O, O], [801, O], [O, O], [O, O]]),
    w("FINISH", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 323], [O, O], [O, O]]),
    w("FIT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 834], [O, O], [O, O]]),
    w("FIVONE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 929], [O, O], [O, O]]),
    w("FIXTUR", Modifier, NONE, [[O, O], [O, O], [O, 898], [O, 898], [O, O], [O, O]]),
    w("FLOOD", Modifier, NONE, [[O, 89], [O, 89], [O, 89], [O, 89], [O, O], [O, O]]),
    w("FLOW", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("FLUSH", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("FLUTES", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 206], [O, O], [O, O]]),
    w("FMILL", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 748], [O, O], [O, O]]),
    w("FONT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 947], [O, O], [O, O]]),
    w("FORCE", Post, NONE, [[O, O], [O, O], [1106, O], [O, O], [O, O], [O, O]]),
    w("FORMAT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 849], [O, O], [O, O]]),
    w("FOUR", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 928], [O, O], [O, O]]),
    w("FOURPT", Modifier, NONE, [[O, 101], [O, 101], [O, O], [O, O], [O, O], [O, O]]),
    w("FPT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [O, K]]),
    w("FR", Post, NONE, [[O, O], [O, O], [O, O], [1009, O], [O, O], [O, O]]),
    w("FROM", Motion, NONE, [[r(5000, 3), O], [r(5000, 3), O], [O, O], [701, O], [O, O], [O, O]]),
    w("FRONT", Modifier, NONE, [[O, 148], [O, 148], [O, 148], [O, 148], [O, O], [O, O]]),
    w("FULL", Modifier, NONE, [[O, 147], [O, 147], [O, O], [O, O], [O, O], [O, O]]),
    w("FUNOFY", Modifier, NONE, [[O, 4], [O, 4], [O, O], [O, O], [O, O], [O, O]]),
    w("FWD", Modifier, NONE, [[O, O], [O, K], [O, 651], [O, 651], [O, O], [O, O]]),
    w("GAPLES", Modifier, NONE, [[O, 180], [O, 180], [O, O], [O, O], [O, O], [O, O]]),
    w("GB", Motion, NONE, [[O, O], [O, O], [O, O], [O, 707], [O, O], [O, O]]),
    w("GCLEAR", Regional, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("GCONIC", Geometry, NONE, [[s(9), O], [s(9), O], [O, O], [O, O], [O, O], [O, O]]),
    w("GD", Motion, NONE, [[O, O], [O, O], [O, O], [O, 710], [O, O], [O, O]]),
    w("GENCUR", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("GENPTS", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 743], [O, O], [O, O]]),
    w("GEO", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 835], [O, O], [O, O]]),
    w("GEOM", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("GET", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 827], [O, O], [O, O]]),
    w("GF", Motion, NONE, [[O, O], [O, O], [O, O], [O, 704], [O, O], [O, O]]),
    w("GFA", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 873], [O, O], [O, O]]),
    w("GL", Motion, NONE, [[O, O], [O, O], [O, O], [O, 705], [O, O], [O, O]]),
    w("GMESH", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("GO", Motion, NONE, [[r(7000, 1), O], [r(7000, 1), O], [O, O], [702, O], [O, O], [O, O]]),
    w("GOBACK", Motion, NONE, [[r(8000, 4), O], [r(8000, 4), O], [O, O], [707, O], [O, O], [O, O]]),
    w("GOCCLW", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("GOCLER", Post, NONE, [[16, O], [16, O], [O, O], [O, O], [O, O], [O, O]]),
    w("GOCLW", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("GODLTA", Motion, NONE, [[r(5000, 4), O], [r(5000, 4), O], [O, O], [710, O], [O, O], [O, O]]),
    w("GODOWN", Motion, NONE, [[r(8000, 6), O], [r(8000, 6), O], [O, O], [709, O], [O, O], [O, O]]),
    w("GOFWD", Motion, NONE, [[r(8000, 3), O], [r(8000, 3), O], [O, O], [704, O], [O, O], [O, O]]),
    w("GOFWDA", Motion, NONE, [[O, O], [O, O], [O, O], [O, 873], [O, O], [O, O]]),
    w("GOHOME", Post, NONE, [[14, O], [14, O], [17, O], [17, O], [14, O], [O, O]]),
    w("GOLFT", Motion, NONE, [[r(8000, 1), O], [r(8000, 1), O], [O, O], [705, O], [O, O], [O, O]]),
    w("GOLOFT", Regional, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("GOMILL", Regional, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("GORGT", Motion, NONE, [[r(8000, 2), O], [r(8000, 2), O], [O, O], [706, O], [O, O], [O, O]]),
    w("GOTO", Motion, NONE, [[r(5000, 5), O], [r(5000, 5), O], [O, O], [703, O], [O, O], [O, O]]),
    w("GOUGCK", Motion, NONE, [[r(9000, 8), O], [r(9000, 8), O], [O, O], [838, O], [O, O], [O, O]]),
    w("GOUP", Motion, NONE, [[r(8000, 5), O], [r(8000, 5), O], [O, O], [708, O], [O, O], [O, O]]),
    w("GR", Motion, NONE, [[O, O], [O, O], [O, O], [O, 706], [O, O], [O, O]]),
    w("GREEN", Modifier, NONE, [[O, 132], [O, 132], [O, O], [O, 908], [O, O], [O, O]]),
    w("GREY", Post, NONE, [[O, O], [O, O], [O, O], [1104, O], [O, O], [O, O]]),
    w("GRID", Modifier, NONE, [[O, 176], [O, 67], [O, 67], [O, 67], [O, 176], [O, O]]),
    w("GT", Motion, NONE, [[O, O], [O, O], [O, O], [O, 703], [O, O], [O, O]]),
    w("GUIDE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 865], [O, O], [O, O]]),
    w("HEAD", Post, NONE, [[1002, O], [1002, O], [1002, O], [1002, O], [O, O], [O, O]]),
    w("HEAVY", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 921], [O, O], [O, O]]),
    w("HEIGHT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 754], [O, O], [O, O]]),
    w("HELICAL", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("HELIX", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 855], [O, O], [O, O]]),
    w("HEX", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("HIDDEN", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 579], [O, O], [O, O]]),
    w("HIGH", Modifier, NONE, [[O, 62], [O, 62], [O, 62], [O, 62], [O, O], [O, O]]),
    w("HIGHT", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("HOLDER", Regional, Some(Modifier), [[O, 157], [157, O], [O, 157], [O, 157], [O, O], [O, O]]),
    w("HOME", Modifier, NONE, [[O, O], [O, O], [O, 790], [O, 790], [O, O], [O, O]]),
    w("HYPERB", Geometry, NONE, [[s(7), O], [s(7), O], [O, O], [O, O], [O, O], [O, O]]),
    w("IF", Control, NONE, [[K, O], [K, O], [O, O], [825, O], [O, O], [O, O]]),
    w("IFRO", Post, NONE, [[1032, O], [1032, O], [O, O], [O, O], [O, O], [O, O]]),
    w("IFTOL", Post, NONE, [[O, O], [O, O], [1108, O], [751, O], [O, O], [O, O]]),
    w("IN", Modifier, NONE, [[O, 48], [O, 48], [O, 48], [O, 652], [O, O], [O, O]]),
    w("INCHES", Modifier, NONE, [[O, O], [O, O], [O, 303], [O, 303], [O, 302], [O, O]]),
    w("INCLUD", Control, NONE, [[O, O], [O, O], [O, O], [O, 744], [O, O], [O, O]]),
    w("INCR", Modifier, NONE, [[O, 66], [O, 66], [O, 66], [O, 66], [O, O], [O, O]]),
    w("INDEX", Control, NONE, [[1039, O], [1039, O], [O, O], [810, O], [O, O], [O, O]]),
    w("INDEXF", Post, NONE, [[O, O], [O, O], [1039, O], [O, O], [O, O], [O, O]]),
    w("INDIRP", Motion, NONE, [[r(5000, 1), O], [r(5000, 1), O], [O, O], [712, O], [O, O], [O, O]]),
    w("INDIRV", Motion, NONE, [[r(5000, 2), O], [r(5000, 2), O], [O, O], [711, O], [O, O], [O, O]]),
    w("INHIBT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 279], [O, O], [O, O]]),
    w("INIT", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, K]]),
    w("INSERT", Text, NONE, [[1046, O], [1046, O], [1046, O], [1046, O], [O, O], [O, O]]),
    w("INT", Function, NONE, [[O, O], [O, O], [O, O], [O, 564], [O, O], [O, O]]),
    w("INTCOD", Post, NONE, [[1020, O], [1020, O], [1020, O], [1020, O], [O, O], [O, O]]),
    w("INTENS", Modifier, NONE, [[O, 134], [O, 134], [O, 134], [O, 134], [O, O], [O, O]]),
    w("INTERC", Modifier, NONE, [[O, 46], [O, 46], [O, O], [O, O], [O, O], [O, O]]),
    w("INTERP", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 752], [O, O], [O, O]]),
    w("INTF", Function, NONE, [[O, O], [K, O], [O, O], [O, 564], [O, O], [O, O]]),
    w("INTOF", Modifier, NONE, [[O, 5], [O, 5], [O, 727], [O, 727], [O, O], [O, O]]),
    w("INTOF3", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 758], [O, O], [O, O]]),
    w("INTOL", Motion, NONE, [[r(6000, 4), O], [r(6000, 4), O], [1064, O], [1064, O], [O, O], [O, O]]),
    w("INTSEC", Regional, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("INVERS", Modifier, NONE, [[O, 6], [O, 6], [O, 6], [O, 822], [O, O], [O, O]]),
    w("INVIS", Post, NONE, [[O, O], [O, O], [O, O], [1096, O], [O, O], [O, O]]),
    w("IO", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 727], [O, O], [O, O]]),
    w("IO3", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 758], [O, O], [O, O]]),
    w("IP", Motion, NONE, [[O, O], [O, O], [O, O], [O, 712], [O, O], [O, O]]),
    w("IPM", Modifier, NONE, [[O, 73], [O, 73], [O, 73], [O, 73], [O, O], [O, O]]),
    w("IPR", Modifier, NONE, [[O, 74], [O, 74], [O, 74], [O, 74], [O, O], [O, O]]),
    w("ISLAND", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 757], [O, O], [O, O]]),
    w("ISTOP", Post, NONE, [[4, O], [4, O], [O, O], [O, O], [O, O], [O, O]]),
    w("IV", Motion, NONE, [[O, O], [O, O], [O, O], [O, 711], [O, O], [O, O]]),
    w("JUMPTO", Control, NONE, [[K, O], [K, O], [O, O], [826, O], [O, O], [O, O]]),
    w("KNIFE", Post, NONE, [[O, O], [O, O], [1098, O], [1098, O], [O, O], [O, O]]),
    w("KNOT", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("KREUZ", Operator, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("LA", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 700], [O, O], [O, O]]),
    w("LABEL", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 936], [O, O], [O, O]]),
    w("LACE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 342], [O, O], [O, O]]),
    w("LAG", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("LARGE", Modifier, NONE, [[O, 7], [O, 7], [O, 7], [O, 662], [O, O], [O, O]]),
    w("LAST", Modifier, NONE, [[O, 52], [O, 52], [O, 52], [O, 52], [O, O], [O, O]]),
    w("LATHE", Modifier, NONE, [[O, O], [O, O], [O, 700], [O, 700], [O, O], [O, O]]),
    w("LAYER", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 902], [O, O], [O, O]]),
    w("LAYF", Function, NONE, [[O, O], [O, O], [O, O], [O, 943], [O, O], [O, O]]),
    w("LCONIC", Geometry, NONE, [[s(10), O], [s(10), O], [O, O], [O, O], [O, O], [O, O]]),
    w("LE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 8], [O, O], [O, O]]),
    w("LEAD", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("LEADER", Post, NONE, [[1013, O], [1013, O], [1013, O], [1013, O], [O, O], [O, O]]),
    w("LEFT", Modifier, NONE, [[O, 8], [O, 8], [O, 8], [O, 8], [O, O], [O, O]]),
    w("LENGTH", Modifier, NONE, [[O, 9], [O, 9], [O, 9], [O, 9], [O, O], [O, O]]),
    w("LETDIR", Post, NONE, [[O, O], [O, O], [O, O], [1041, O], [O, O], [O, O]]),
    w("LETORG", Post, NONE, [[O, O], [O, O], [O, O], [1042, O], [O, O], [O, O]]),
    w("LETSIZ", Post, NONE, [[O, O], [O, O], [O, O], [1040, O], [O, O], [O, O]]),
    w("LETTER", Post, NONE, [[1043, O], [1043, O], [1043, O], [1043, O], [O, O], [O, O]]),
    w("LEVEL", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 759], [O, O], [O, O]]),
    w("LI", Geometry, NONE, [[O, O], [O, O], [O, O], [O, 605], [O, O], [O, O]]),
    w("LIBPRT", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("LIBRY", Control, NONE, [[K, O], [O, O], [O, O], [O, O], [O, O], [O, O]]),
    w("LIGHT", Modifier, NONE, [[O, 100], [O, 100], [O, O], [O, O], [O, O], [O, O]]),
    w("LIMIT", Post, Some(Modifier), [[O, O], [O, K], [1078, O], [1078, O], [O, O], [O, O]]),
    w("LINCIR", Modifier, NONE, [[O, 95], [O, 95], [O, 95], [O, 95], [O, O], [O, O]]),
    w("LINE", Geometry, NONE, [[s(2), O], [s(2), O], [O, O], [605, O], [O, O], [O, O]]),
    w("LINEAR", Modifier, NONE, [[O, 76], [O, 76], [O, 76], [O, 76], [O, O], [O, O]]),
    w("LINTOL", Post, NONE, [[O, O], [1067, O], [1067, O], [1067, O], [1073, O], [O, O]]),
    w("LINTYP", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 131], [O, O], [O, O]]),
    w("LINWGT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 901], [O, O], [O, O]]),
    w("LIST", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 863], [O, O], [O, O]]),
    w("LISTING", Post, NONE, [[O, O], [O, O], [1101, O], [O, O], [O, O], [O, O]]),
    w("LISTON", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("LITE", Modifier, NONE, [[O, 135], [O, 135], [O, O], [O, O], [O, O], [O, O]]),
    w("LN", Geometry, NONE, [[O, O], [O, O], [O, O], [O, 605], [O, O], [O, O]]),
    w("LNTH", Function, NONE, [[O, O], [O, O], [O, O], [O, 560], [O, O], [O, O]]),
    w("LNTHF", Function, NONE, [[K, O], [K, O], [O, O], [O, 560], [O, O], [O, O]]),
    w("LOAD", Post, NONE, [[O, O], [O, O], [1075, O], [1075, O], [1074, O], [O, O]]),
    w("LOADTL", Post, NONE, [[1055, O], [1055, O], [1055, O], [1055, O], [O, O], [O, O]]),
    w("LOADU", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 847], [O, O], [O, O]]),
    w("LOCAL", Control, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("LOCK", Modifier, NONE, [[O, 114], [O, 114], [O, 114], [O, 114], [O, O], [O, O]]),
    w("LOCKX", Post, NONE, [[21, O], [21, O], [O, O], [O, O], [O, O], [O, O]]),
    w("LOFT", Geometry, NONE, [[s(16), O], [O, O], [O, O], [O, O], [O, O], [O, O]]),
    w("LOG", Function, NONE, [[O, O], [O, O], [O, O], [O, 551], [O, O], [O, O]]),
    w("LOG10F", Function, NONE, [[K, O], [K, O], [O, O], [O, 568], [O, O], [O, O]]),
    w("LOGF", Function, NONE, [[K, O], [K, O], [O, O], [O, 551], [O, O], [O, O]]),
    w("LONG", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 850], [O, O], [O, O]]),
    w("LOOK", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 871], [O, O], [O, O]]),
    w("LOOPND", Control, NONE, [[K, O], [K, O], [O, O], [809, O], [O, O], [O, O]]),
    w("LOOPST", Control, NONE, [[K, O], [K, O], [O, O], [808, O], [O, O], [O, O]]),
    w("LOW", Modifier, NONE, [[O, 63], [O, 63], [O, 63], [O, 63], [O, O], [O, O]]),
    w("LPRINT", Post, NONE, [[1065, O], [1065, O], [O, O], [1065, O], [O, O], [O, O]]),
    w("LRGDOT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 958], [O, O], [O, O]]),
    w("LT", Post, NONE, [[O, O], [O, O], [O, O], [1055, O], [O, O], [O, O]]),
    w("LTBLUE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 914], [O, O], [O, O]]),
    w("LTTAN", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 913], [O, O], [O, O]]),
    w("LTV", Control, NONE, [[K, O], [O, O], [O, O], [O, O], [O, O], [O, O]]),
    w("MACHIN", Post, NONE, [[1015, O], [1015, O], [1015, O], [1015, O], [O, O], [O, O]]),
    w("MACRO", Control, NONE, [[K, O], [K, O], [O, O], [806, O], [O, O], [O, O]]),
    w("MAGNTA", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 909], [O, O], [O, O]]),
    w("MAGTAP", Post, NONE, [[1072, O], [1072, O], [O, O], [O, O], [O, O], [O, O]]),
    w("MAIN", Modifier, NONE, [[O, 93], [O, 93], [O, 513], [O, 93], [O, O], [O, O]]),
    w("MANUAL", Modifier, NONE, [[O, 158], [O, 158], [O, 158], [O, 158], [O, O], [O, O]]),
    w("MARKER", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 952], [O, O], [O, O]]),
    w("MARKF", Function, NONE, [[O, O], [O, O], [O, O], [O, 960], [O, O], [O, O]]),
    w("MATERL", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 584], [O, O], [O, O]]),
    w("MATRIX", Geometry, Some(Modifier), [[s(12), O], [s(12), O], [O, 610], [O, 610], [O, O], [O, O]]),
    w("MAX1F", Function, NONE, [[O, O], [O, O], [O, O], [O, 570], [O, O], [O, O]]),
    w("MAXANG", Motion, NONE, [[O, O], [O, O], [O, O], [O, 741], [O, O], [O, O]]),
    w("MAXDP", Motion, NONE, [[r(9000, 3), O], [r(9000, 3), O], [O, O], [736, O], [O, O], [O, O]]),
    w("MAXDPM", Post, NONE, [[1062, O], [1062, O], [1062, O], [1062, O], [O, O], [O, O]]),
    w("MAXF", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("MAXIPM", Modifier, NONE, [[O, 96], [O, 96], [O, 96], [O, 96], [O, O], [O, O]]),
    w("MAXIS", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 870], [O, O], [O, O]]),
    w("MAXLNG", Modifier, NONE, [[O, O], [O, 174], [O, O], [O, O], [O, O], [O, O]]),
    w("MAXPTS", Modifier, NONE, [[O, O], [O, 179], [O, O], [O, O], [O, O], [O, O]]),
    w("MAXRPM", Modifier, NONE, [[O, 79], [O, 79], [O, 79], [O, 79], [O, O], [O, O]]),
    w("MAXSTP", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("MAXVEL", Post, NONE, [[1064, O], [1064, O], [O, O], [O, O], [O, O], [O, O]]),
    w("MAXWD", Modifier, NONE, [[O, O], [O, 173], [O, O], [O, O], [O, O], [O, O]]),
    w("MCHFIN", Post, NONE, [[1018, O], [1018, O], [O, O], [O, O], [O, O], [O, O]]),
    w("MCHTOL", Post, NONE, [[1016, O], [1016, O], [1016, O], [1016, O], [O, O], [O, O]]),
    w("MCSYS", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("MDEND", Post, NONE, [[1052, O], [1052, O], [1052, O], [1052, O], [O, O], [O, O]]),
    w("MDWRIT", Post, NONE, [[1051, O], [1051, O], [1051, O], [O, O], [O, O], [O, O]]),
    w("MED", Modifier, NONE, [[O, 136], [O, 136], [O, O], [O, O], [O, O], [O, O]]),
    w("MEDIUM", Modifier, NONE, [[O, 61], [O, 61], [O, 61], [O, 61], [O, O], [O, O]]),
    w("MESH", Geometry, NONE, [[s(51), O], [O, O], [O, O], [839, O], [O, O], [O, O]]),
    w("MIDDLE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 891], [O, O], [O, O]]),
    w("MILL", Modifier, NONE, [[O, 151], [O, 151], [O, 151], [O, 151], [O, O], [O, O]]),
    w("MILLFD", Modifier, NONE, [[O, O], [O, O], [O, 201], [O, 201], [O, 187], [O, O]]),
    w("MILLRP", Modifier, NONE, [[O, O], [O, O], [O, 200], [O, 200], [O, 186], [O, O]]),
    w("MIN1F", Function, NONE, [[O, O], [O, O], [O, O], [O, 571], [O, O], [O, O]]),
    w("MINF", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("MINFED", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 964], [O, O], [O, O]]),
    w("MINUS", Modifier, NONE, [[O, 10], [O, 10], [O, 10], [O, 10], [O, O], [O, O]]),
    w("MIRROR", Modifier, NONE, [[O, 56], [O, 56], [O, 56], [O, 821], [O, O], [O, O]]),
    w("MIST", Modifier, NONE, [[O, 90], [O, 90], [O, 90], [O, 90], [O, O], [O, O]]),
    w("MIT", Control, NONE, [[K, O], [O, O], [O, O], [O, O], [O, O], [O, O]]),
    w("MM", Modifier, NONE, [[O, O], [O, O], [O, 301], [O, 296], [O, O], [O, O]]),
    w("MMPM", Modifier, NONE, [[O, O], [O, 171], [O, 315], [O, 315], [O, 181], [O, O]]),
    w("MMPR", Modifier, NONE, [[O, O], [O, 172], [O, 316], [O, 316], [O, 182], [O, O]]),
    w("MO", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 667], [O, O], [O, O]]),
    w("MODALS", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 667], [O, O], [O, O]]),
    w("MODCUT", Post, NONE, [[O, O], [O, O], [1099, O], [1099, O], [O, O], [O, O]]),
    w("MODE", Post, NONE, [[1003, O], [1003, O], [1003, O], [1003, O], [O, O], [O, O]]),
    w("MODF", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("MODIFY", Modifier, NONE, [[O, 55], [O, 55], [O, 55], [O, 732], [O, O], [O, O]]),
    w("MODSYS", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 668], [O, O], [O, O]]),
    w("MOTDIR", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("MOTION", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 836], [O, O], [O, O]]),
    w("MOVARC", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("MOVE", Modifier, NONE, [[O, O], [O, O], [O, 577], [O, 577], [O, O], [O, O]]),
    w("MOVETO", Post, NONE, [[1066, O], [1066, O], [1190, O], [O, O], [O, O], [O, O]]),
    w("MSYS", Post, NONE, [[O, O], [O, O], [1077, O], [O, O], [O, O], [K, O]]),
    w("MULTAX", Motion, NONE, [[r(9000, 2), O], [r(9000, 2), O], [1105, O], [815, O], [O, O], [O, O]]),
    w("MULTRD", Modifier, NONE, [[O, 119], [O, 119], [O, O], [O, O], [O, O], [O, O]]),
    w("MX", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 610], [O, O], [O, O]]),
    w("NAME", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 933], [O, O], [O, O]]),
    w("NAMED", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 931], [O, O], [O, O]]),
    w("NDS", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("NDTEST", Motion, NONE, [[r(6000, 2), O], [r(6000, 2), O], [O, O], [O, O], [O, O], [O, O]]),
    w("NEARPT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 866], [O, O], [O, O]]),
    w("NEGX", Modifier, NONE, [[O, 11], [O, 11], [O, 11], [O, 657], [O, O], [O, O]]),
    w("NEGY", Modifier, NONE, [[O, 12], [O, 12], [O, 12], [O, 658], [O, O], [O, O]]),
    w("NEGZ", Modifier, NONE, [[O, 13], [O, 13], [O, 13], [O, 659], [O, O], [O, O]]),
    w("NEUTRL", Modifier, NONE, [[O, O], [O, O], [O, 166], [O, 166], [O, O], [O, O]]),
    w("NEXT", Modifier, NONE, [[O, 162], [O, 162], [O, 162], [O, 162], [O, O], [O, O]]),
    w("NEXTTL", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("NF", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 614], [O, O], [O, O]]),
    w("NIBBLE", Post, NONE, [[O, O], [O, O], [1082, O], [O, O], [O, O], [O, O]]),
    w("NINT", Function, NONE, [[O, O], [O, O], [O, O], [O, 567], [O, O], [O, O]]),
    w("NINTF", Function, NONE, [[O, O], [O, O], [O, O], [O, 567], [O, O], [O, O]]),
    w("NIXIE", Modifier, NONE, [[O, 99], [O, 99], [O, O], [O, O], [O, O], [O, O]]),
    w("NM", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 53], [O, O], [O, O]]),
    w("NOBACK", Modifier, NONE, [[O, O], [O, O], [O, 194], [O, O], [O, O], [O, O]]),
    w("NOBND", Modifier, NONE, [[O, O], [O, 178], [O, O], [O, O], [O, O], [O, O]]),
    w("NOCLRP", Modifier, NONE, [[O, O], [O, 170], [O, O], [O, O], [O, O], [O, O]]),
    w("NOLIST", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("NOMORE", Modifier, NONE, [[O, 53], [O, 53], [O, 53], [O, 53], [O, O], [O, O]]),
    w("NOPLOT", Control, NONE, [[K, O], [O, O], [O, O], [O, O], [O, O], [O, O]]),
    w("NOPOST", Control, Some(Modifier), [[K, O], [K, O], [O, 812], [814, O], [O, O], [O, O]]),
    w("NOPS", Motion, NONE, [[r(9000, 6), O], [r(9000, 6), O], [O, O], [726, O], [O, O], [O, O]]),
    w("NORMAL", Modifier, NONE, [[O, 111], [O, 111], [O, 111], [O, 820], [O, O], [O, O]]),
    w("NORMDS", Modifier, NONE, [[O, 182], [O, 87], [O, O], [O, O], [O, O], [O, O]]),
    w("NORMPS", Modifier, NONE, [[O, 181], [O, 181], [O, O], [O, 39], [O, O], [O, O]]),
    w("NOW", Modifier, NONE, [[O, 161], [O, 161], [O, 161], [O, 161], [O, O], [O, O]]),
    w("NOWARN", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 853], [O, O], [O, O]]),
    w("NOWRAP", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 890], [O, O], [O, O]]),
    w("NOX", Modifier, NONE, [[O, 14], [O, 14], [O, 14], [O, 14], [O, O], [O, O]]),
    w("NOY", Modifier, NONE, [[O, 15], [O, 15], [O, 15], [O, 15], [O, O], [O, O]]),
    w("NOZ", Modifier, NONE, [[O, 16], [O, 16], [O, 16], [O, 16], [O, O], [O, O]]),
    w("NPS", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("NSH", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 615], [O, O], [O, O]]),
    w("NSHAPE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 615], [O, O], [O, O]]),
    w("NSURF", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 614], [O, O], [O, O]]),
    w("NUM", Function, Some(Modifier), [[O, O], [O, O], [O, O], [O, 563], [O, O], [O, K]]),
    w("NUMF", Function, NONE, [[K, O], [K, O], [O, O], [O, 563], [O, O], [O, O]]),
    w("NUMPTS", Motion, NONE, [[r(9000, 4), O], [r(9000, 4), O], [O, O], [737, O], [O, O], [O, O]]),
    w("NURBS", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("OB", Control, NONE, [[O, O], [O, O], [O, O], [O, 661], [O, O], [O, O]]),
    w("OBJECT", Geometry, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("OBTAIN", Control, NONE, [[K, O], [K, O], [O, O], [661, O], [O, O], [O, O]]),
    w("OFF", Modifier, NONE, [[O, 72], [O, 72], [O, 72], [O, 72], [O, O], [O, O]]),
    w("OFFSET", Motion, Some(Modifier), [[r(7000, 2), O], [r(7000, 2), O], [O, 705], [666, O], [O, O], [O, O]]),
    w("OFSETL", Modifier, NONE, [[O, O], [O, O], [O, 275], [O, 275], [O, 279], [O, O]]),
    w("OMIT", Modifier, NONE, [[O, 172], [O, 186], [O, 176], [O, 172], [O, O], [O, O]]),
    w("ON", Modifier, NONE, [[O, 71], [O, 71], [O, 71], [O, 71], [O, O], [O, O]]),
    w("ONCE", Modifier, NONE, [[O, O], [O, O], [O, 325], [O, 325], [O, O], [O, O]]),
    w("OPEN", Modifier, NONE, [[O, 50], [O, 50], [O, O], [O, 50], [O, O], [O, O]]),
    w("OPNAME", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("OPPLOT", Post, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("OPSKIP", Post, NONE, [[1012, O], [1012, O], [1012, O], [1012, O], [O, O], [O, O]]),
    w("OPSTOP", Post, NONE, [[3, O], [3, O], [3, O], [3, O], [O, O], [O, O]]),
    w("OPTION", Modifier, NONE, [[O, 144], [O, 144], [O, 144], [O, 144], [O, O], [O, O]]),
    w("ORANGE", Post, NONE, [[O, O], [O, O], [O, O], [1101, O], [O, O], [O, O]]),
    w("ORIENT", Modifier, NONE, [[O, O], [O, O], [O, 246], [O, 246], [O, 199], [O, O]]),
    w("ORIGIN", Post, NONE, [[1027, O], [1027, O], [1027, O], [1027, O], [O, O], [O, O]]),
    w("OSETNO", Modifier, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [O, K]]),
    w("OUT", Modifier, NONE, [[O, 49], [O, 49], [O, 49], [O, 653], [O, O], [O, O]]),
    w("OUTTOL", Motion, NONE, [[r(6000, 5), O], [r(6000, 5), O], [1080, O], [1080, O], [O, O], [O, O]]),
    w("OVPLOT", Post, NONE, [[1042, O], [1042, O], [O, O], [1042, O], [O, O], [O, O]]),
    w("PA", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 637], [O, O], [O, O]]),
    w("PAINT", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("PALLET", Modifier, NONE, [[O, O], [O, O], [O, 239], [O, 239], [O, 216], [O, O]]),
    w("PARAB", Modifier, NONE, [[O, 77], [O, 77], [O, 77], [O, 77], [O, O], [O, O]]),
    w("PARAM", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("PARAMS", Modifier, NONE, [[O, O], [O, O], [O, 934], [O, 934], [O, O], [O, O]]),
    w("PARELM", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 833], [O, O], [O, O]]),
    w("PARLEL", Modifier, NONE, [[O, 17], [O, 17], [O, O], [O, 637], [O, O], [O, O]]),
    w("PARMF", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("PARSRF", Geometry, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("PART", Modifier, NONE, [[O, 166], [O, 166], [O, 260], [O, 260], [O, O], [O, O]]),
    w("PARTNO", Text, NONE, [[1045, O], [1045, O], [1045, O], [1045, O], [O, O], [O, O]]),
    w("PASS", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 755], [O, O], [O, O]]),
    w("PAST", Modifier, NONE, [[O, 70], [O, 70], [O, 70], [O, 715], [O, O], [O, O]]),
    w("PATCH", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("PATERN", Geometry, NONE, [[s(18), O], [s(18), O], [O, O], [636, O], [O, O], [O, O]]),
    w("PATH", Modifier, NONE, [[O, O], [O, K], [O, 234], [O, O], [O, O], [O, O]]),
    w("PBS", Post, NONE, [[1068, O], [1068, O], [O, O], [O, O], [O, O], [O, O]]),
    w("PD", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 130], [O, O], [O, O]]),
    w("PDS", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("PE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 630], [O, O], [O, O]]),
    w("PEN", Post, Some(Modifier), [[128, 128], [128, 128], [128, 128], [128, 128], [O, O], [O, O]]),
    w("PENDWN", Post, NONE, [[12, O], [12, O], [130, O], [130, O], [12, O], [O, O]]),
    w("PENUP", Post, NONE, [[11, O], [11, O], [129, O], [129, O], [11, O], [O, O]]),
    w("PERCNT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 763], [O, O], [O, O]]),
    w("PERIM", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("PERMIN", Modifier, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [O, K]]),
    w("PERPTO", Modifier, NONE, [[O, 18], [O, 18], [O, 18], [O, 630], [O, O], [O, O]]),
    w("PERREV", Modifier, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [O, K]]),
    w("PERSP", Modifier, NONE, [[O, 67], [O, O], [O, O], [O, O], [O, O], [O, O]]),
    w("PHANTM", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 916], [O, O], [O, O]]),
    w("PICKFD", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("PICKUP", Post, NONE, [[9, O], [9, O], [O, O], [O, O], [O, O], [O, O]]),
    w("PINK", Post, NONE, [[O, O], [O, O], [O, O], [1102, O], [O, O], [O, O]]),
    w("PITCH", Post, Some(Modifier), [[1050, O], [1050, 67], [1050, O], [1050, O], [O, O], [O, O]]),
    w("PIVOT", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("PIVOTZ", Post, NONE, [[1017, O], [1017, O], [1017, O], [1017, O], [O, O], [O, O]]),
    w("PL", Geometry, NONE, [[O, O], [O, O], [O, O], [O, 606], [O, O], [O, O]]),
    w("PLABEL", Post, NONE, [[1061, O], [1061, O], [1061, O], [1061, O], [O, O], [O, O]]),
    w("PLACE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 878], [O, O], [O, O]]),
    w("PLANE", Geometry, NONE, [[s(3), O], [s(3), O], [O, O], [606, O], [O, O], [O, O]]),
    w("PLANO", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("PLOT", Post, NONE, [[1041, O], [1041, O], [1041, O], [O, O], [O, O], [O, O]]),
    w("PLOTFT", Regional, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("PLUNGE", Post, NONE, [[1001, O], [1001, O], [1001, O], [1001, O], [O, O], [O, O]]),
    w("PLUS", Modifier, NONE, [[O, 19], [O, 19], [O, 19], [O, 19], [O, O], [O, O]]),
    w("PMILL", Post, NONE, [[O, O], [O, O], [O, O], [1051, O], [O, O], [O, O]]),
    w("PN", Geometry, NONE, [[O, O], [O, O], [O, O], [O, 636], [O, O], [O, O]]),
    w("PNTSON", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("PNTVEC", Modifier, NONE, [[O, O], [O, K], [O, O], [O, 613], [O, O], [O, O]]),
    w("POCKET", Motion, NONE, [[r(11000, 1), O], [r(11000, 1), O], [O, O], [738, O], [O, O], [O, O]]),
    w("POD", Post, NONE, [[O, O], [O, O], [1088, O], [1088, O], [O, O], [O, O]]),
    w("PODDEF", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 747], [O, O], [O, O]]),
    w("PODPTS", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 746], [O, O], [O, O]]),
    w("POINT", Geometry, NONE, [[s(1), O], [s(1), O], [O, O], [603, O], [O, O], [O, O]]),
    w("POKMOD", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 749], [O, O], [O, O]]),
    w("POLCON", Geometry, NONE, [[s(15), O], [s(15), O], [O, O], [O, O], [O, O], [O, O]]),
    w("POLYGN", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("POSCAL", Post, NONE, [[O, O], [O, O], [1109, O], [O, O], [O, O], [O, O]]),
    w("POSITN", Post, NONE, [[O, O], [O, O], [1072, O], [1072, O], [O, O], [O, O]]),
    w("POSMAP", Post, NONE, [[O, O], [1068, O], [1034, O], [1068, O], [24, O], [O, O]]),
    w("POSN", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("POSTN", Post, NONE, [[1024, O], [1024, O], [1024, O], [1024, O], [O, O], [O, O]]),
    w("POSX", Modifier, NONE, [[O, 20], [O, 20], [O, 20], [O, 654], [O, O], [O, O]]),
    w("POSY", Modifier, NONE, [[O, 21], [O, 21], [O, 21], [O, 655], [O, O], [O, O]]),
    w("POSZ", Modifier, NONE, [[O, 22], [O, 22], [O, 22], [O, 656], [O, O], [O, O]]),
    w("PPLOT", Post, NONE, [[1014, O], [1014, O], [1014, O], [1014, O], [O, O], [O, O]]),
    w("PPOPTN", Control, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("PPRINT", Text, NONE, [[1044, O], [1044, O], [1044, O], [1044, O], [O, O], [O, O]]),
    w("PPS", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("PPTOL", Post, NONE, [[O, O], [O, O], [1068, O], [1069, O], [O, O], [O, O]]),
    w("PPUNCH", Post, NONE, [[O, O], [O, O], [1086, O], [O, O], [O, O], [O, O]]),
    w("PPWORD", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("PREFUN", Post, NONE, [[1048, O], [1048, O], [1048, O], [1048, O], [O, O], [O, O]]),
    w("PRINT", Control, NONE, [[K, O], [K, O], [1102, O], [817, O], [O, O], [O, O]]),
    w("PRINTF", Post, NONE, [[O, O], [O, O], [1104, O], [O, O], [O, O], [O, O]]),
    w("PROBE", Post, NONE, [[O, O], [O, O], [1081, O], [1081, O], [O, O], [O, O]]),
    w("PROBX", Post, NONE, [[19, O], [19, O], [O, O], [O, O], [O, O], [O, O]]),
    w("PROBY", Post, NONE, [[18, O], [18, O], [O, O], [O, O], [O, O], [O, O]]),
    w("PROFIL", Post, NONE, [[O, O], [O, O], [761, O], [761, O], [O, O], [O, O]]),
    w("PROJCT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 888], [O, O], [O, O]]),
    w("PROMPT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 935], [O, O], [O, O]]),
    w("PS", Modifier, NONE, [[O, O], [O, K], [O, 728], [O, 728], [O, O], [O, O]]),
    w("PSEUDO", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 762], [O, O], [O, O]]),
    w("PSIS", Motion, NONE, [[r(3000, 4), O], [r(3000, 4), O], [O, O], [713, O], [O, O], [O, O]]),
    w("PSTAN", Modifier, NONE, [[O, 146], [O, 146], [O, O], [O, 729], [O, O], [O, O]]),
    w("PSTERR", Post, NONE, [[O, O], [O, O], [1107, O], [O, O], [O, O], [O, O]]),
    w("PSUV", Motion, NONE, [[O, O], [O, O], [O, O], [O, 857], [O, O], [O, O]]),
    w("PT", Geometry, NONE, [[O, O], [O, O], [O, O], [O, 603], [O, O], [O, O]]),
    w("PTNORM", Modifier, NONE, [[O, 104], [O, 104], [O, O], [O, O], [O, O], [O, O]]),
    w("PTONLY", Control, NONE, [[K, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("PTSLOP", Modifier, NONE, [[O, 103], [O, 103], [O, O], [O, O], [O, O], [O, O]]),
    w("PU", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 129], [O, O], [O, O]]),
    w("PUNCH", Control, NONE, [[K, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("PURPLE", Post, NONE, [[O, O], [O, O], [O, O], [1103, O], [O, O], [O, O]]),
    w("PUT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 828], [O, O], [O, O]]),
    w("PV", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 613], [O, O], [O, O]]),
    w("PVAL", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("QADRIC", Geometry, NONE, [[s(14), O], [s(14), O], [O, O], [O, O], [O, O], [O, O]]),
    w("QAXIS", Post, NONE, [[O, O], [O, O], [1089, O], [1089, O], [O, O], [O, O]]),
    w("QUILL", Modifier, NONE, [[O, O], [O, O], [O, 287], [O, 287], [O, 212], [O, O]]),
    w("QUILT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 837], [O, O], [O, O]]),
    w("RA", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 23], [O, O], [O, O]]),
    w("RADIAL", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 893], [O, O], [O, O]]),
    w("RADIUS", Modifier, NONE, [[O, 23], [O, 23], [O, 23], [O, 23], [O, O], [O, O]]),
    w("RAIL", Modifier, NONE, [[O, 93], [O, 93], [O, O], [O, O], [O, O], [O, O]]),
    w("RAM", Modifier, NONE, [[O, O], [O, O], [O, 500], [O, 500], [O, 143], [O, O]]),
    w("RAMP", Modifier, NONE, [[O, O], [O, O], [O, 854], [O, 854], [O, O], [O, O]]),
    w("RANDOM", Modifier, NONE, [[O, 174], [O, 147], [O, 183], [O, 326], [O, O], [O, O]]),
    w("RANGE", Modifier, NONE, [[O, 145], [O, 145], [O, 145], [O, 145], [O, O], [O, O]]),
    w("RAPID", Post, NONE, [[5, O], [5, O], [5, O], [5, O], [O, O], [O, O]]),
    w("RAPTO", Modifier, NONE, [[O, O], [O, O], [O, 280], [O, 280], [O, 211], [O, K]]),
    w("RE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 7], [O, O], [O, O]]),
    w("READ", Control, NONE, [[K, O], [K, O], [O, O], [876, O], [O, O], [O, O]]),
    w("REAL", Control, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("REAM", Modifier, NONE, [[O, 167], [O, 167], [O, 262], [O, 262], [O, 167], [O, O]]),
    w("REAR", Modifier, NONE, [[O, 149], [O, 149], [O, 149], [O, 149], [O, O], [O, O]]),
    w("RED", Modifier, NONE, [[O, 131], [O, 131], [O, O], [O, 907], [O, O], [O, O]]),
    w("REDEF", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 840], [O, O], [O, O]]),
    w("REDRAW", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 924], [O, O], [O, O]]),
    w("REFSYS", Control, NONE, [[K, O], [K, O], [O, O], [644, O], [O, O], [O, O]]),
    w("REGBRK", Post, NONE, [[1069, O], [1069, O], [O, O], [O, O], [O, O], [O, O]]),
    w("REGION", Regional, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("REGORD", Post, NONE, [[O, O], [O, O], [1110, O], [O, O], [O, O], [O, O]]),
    w("REGTOL", Modifier, NONE, [[O, O], [O, 171], [O, O], [O, O], [O, O], [O, O]]),
    w("RELTOL", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("REMARK", Text, NONE, [[K, O], [K, O], [O, O], [1091, O], [O, O], [O, O]]),
    w("REMOVE", Modifier, NONE, [[O, O], [O, O], [O, 843], [O, 843], [O, O], [O, O]]),
    w("RENAME", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 869], [O, O], [O, O]]),
    w("REPEAT", Post, NONE, [[O, O], [O, O], [1083, O], [1083, O], [O, O], [O, O]]),
    w("RESERV", Control, NONE, [[K, O], [K, O], [O, O], [805, O], [O, O], [O, O]]),
    w("RESET", Post, NONE, [[15, O], [15, O], [15, O], [15, O], [O, O], [O, O]]),
    w("RESTOR", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 583], [O, O], [O, O]]),
    w("RETAIN", Modifier, NONE, [[O, 171], [O, 184], [O, 184], [O, 329], [O, 171], [O, O]]),
    w("RETR", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("RETRCT", Post, NONE, [[7, O], [7, O], [7, O], [7, O], [O, O], [O, O]]),
    w("RETURN", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 322], [O, O], [O, K]]),
    w("REV", Modifier, NONE, [[O, 97], [O, 97], [O, 97], [O, 97], [O, O], [O, O]]),
    w("REVERS", Post, NONE, [[1008, O], [1008, O], [1008, O], [1008, O], [O, O], [O, O]]),
    w("REVOLV", Modifier, NONE, [[O, O], [O, K], [O, O], [O, 861], [O, O], [O, O]]),
    w("REWIND", Post, NONE, [[1006, O], [1006, O], [1006, O], [1006, O], [O, O], [O, O]]),
    w("RIGHT", Modifier, NONE, [[O, 24], [O, 24], [O, 24], [O, 24], [O, O], [O, O]]),
    w("RINDEX", Function, NONE, [[O, O], [O, O], [O, O], [O, 574], [O, O], [O, O]]),
    w("RLDSRF", Geometry, NONE, [[s(53), O], [s(53), O], [O, O], [O, O], [O, O], [O, O]]),
    w("RMILL", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 750], [O, O], [O, O]]),
    w("RO", Post, NONE, [[O, O], [O, O], [O, O], [1026, O], [O, O], [O, O]]),
    w("ROTABL", Post, NONE, [[1026, O], [1026, O], [1026, O], [1026, O], [O, O], [O, O]]),
    w("ROTATE", Post, NONE, [[O, O], [O, O], [1066, O], [1066, O], [1076, O], [O, O]]),
    w("ROTHED", Post, NONE, [[1035, O], [1035, O], [1035, O], [1035, O], [O, O], [O, O]]),
    w("ROTREF", Modifier, NONE, [[O, 68], [O, 68], [O, 68], [O, 68], [O, O], [O, O]]),
    w("ROUGH", Modifier, NONE, [[O, O], [O, O], [O, 320], [O, 320], [O, 247], [O, O]]),
    w("ROUTE", Modifier, NONE, [[O, O], [O, O], [O, 1205], [O, 1205], [O, O], [O, O]]),
    w("RP", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 5], [O, O], [O, O]]),
    w("RPM", Modifier, NONE, [[O, 78], [O, 78], [O, 78], [O, 78], [O, O], [O, O]]),
    w("RS", Control, NONE, [[O, O], [O, O], [O, O], [O, 644], [O, O], [O, O]]),
    w("RT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 24], [O, O], [O, O]]),
    w("RTHETA", Modifier, NONE, [[O, 106], [O, 106], [O, O], [O, O], [O, O], [O, O]]),
    w("RTRCTO", Modifier, NONE, [[O, O], [O, O], [O, 295], [O, 295], [O, O], [O, K]]),
    w("RULED", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("SADDLE", Modifier, NONE, [[O, 150], [O, 150], [O, 150], [O, 150], [O, O], [O, O]]),
    w("SAFETY", Post, NONE, [[1028, O], [1028, O], [1028, O], [1028, O], [O, O], [O, O]]),
    w("SAME", Modifier, NONE, [[O, 54], [O, 54], [O, 54], [O, 730], [O, O], [O, O]]),
    w("SAVE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 582], [O, O], [O, O]]),
    w("SAVEU", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 848], [O, O], [O, O]]),
    w("SAVMDI", Modifier, NONE, [[O, O], [O, 398], [O, O], [O, O], [O, O], [O, O]]),
    w("SAVTDI", Modifier, NONE, [[O, O], [O, 396], [O, O], [O, O], [O, O], [O, O]]),
    w("SCALAR", Modifier, NONE, [[O, O], [O, K], [O, O], [O, 601], [O, O], [O, O]]),
    w("SCALE", Modifier, NONE, [[O, 25], [O, 25], [O, 25], [O, 25], [O, O], [O, O]]),
    w("SCALOP", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("SCON", Regional, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("SCRIBE", Modifier, NONE, [[O, 129], [O, 129], [O, O], [O, O], [O, O], [O, O]]),
    w("SCRUB", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 739], [O, O], [O, O]]),
    w("SCURV", Geometry, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("SEAGRN", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 915], [O, O], [O, O]]),
    w("SEC1", Modifier, NONE, [[O, K], [O, O], [O, O], [O, O], [O, O], [O, O]]),
    w("SEC2", Modifier, NONE, [[O, K], [O, O], [O, O], [O, O], [O, O], [O, O]]),
    w("SEG", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("SELCTL", Post, NONE, [[1056, O], [1056, O], [1056, O], [1056, O], [O, O], [O, O]]),
    w("SELECT", Post, NONE, [[O, O], [O, O], [1074, O], [1074, O], [1034, O], [O, O]]),
    w("SEQNO", Post, NONE, [[1019, O], [1019, O], [1019, O], [1019, O], [O, O], [O, O]]),
    w("SEQUNC", Control, NONE, [[O, O], [O, O], [818, O], [818, O], [O, O], [O, O]]),
    w("SET", Post, NONE, [[O, O], [O, O], [1087, O], [1087, O], [1076, O], [O, O]]),
    w("SETANG", Modifier, NONE, [[O, 156], [O, 156], [O, O], [O, O], [O, O], [O, O]]),
    w("SETOOL", Modifier, NONE, [[O, 155], [O, 155], [O, O], [O, O], [O, O], [O, O]]),
    w("SETUP", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("SF", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 609], [O, O], [O, O]]),
    w("SFM", Post, Some(Modifier), [[O, 115], [K, 115], [O, 115], [O, 115], [O, O], [O, O]]),
    w("SH", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 602], [O, O], [O, O]]),
    w("SHADE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 578], [O, O], [O, O]]),
    w("SHANK", Modifier, NONE, [[O, O], [O, O], [O, 192], [O, 192], [O, O], [O, O]]),
    w("SHAPE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 602], [O, O], [O, O]]),
    w("SHARP", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 183], [O, O], [O, O]]),
    w("SHIFT", Modifier, NONE, [[O, O], [O, O], [O, 249], [O, 249], [O, O], [O, O]]),
    w("SHO", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 740], [O, O], [O, O]]),
    w("SHORT", Modifier, NONE, [[O, O], [O, O], [O, 851], [O, 851], [O, O], [O, O]]),
    w("SIDE", Modifier, NONE, [[O, 94], [O, 94], [O, 94], [O, 94], [O, O], [O, O]]),
    w("SIGNF", Function, NONE, [[O, O], [K, O], [O, O], [O, 572], [O, O], [O, O]]),
    w("SIN", Function, NONE, [[O, O], [O, O], [O, O], [O, 557], [O, O], [O, O]]),
    w("SINB", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("SINF", Function, NONE, [[K, O], [K, O], [O, O], [O, 557], [O, O], [O, O]]),
    w("SINGLE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 926], [O, O], [O, O]]),
    w("SINHF", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("SIX", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 930], [O, O], [O, O]]),
    w("SIZE", Modifier, NONE, [[O, O], [O, O], [O, 196], [O, 196], [O, O], [O, O]]),
    w("SKIP", Modifier, NONE, [[O, O], [O, O], [O, 178], [O, O], [O, O], [O, O]]),
    w("SLICE", Modifier, NONE, [[O, O], [O, O], [O, 804], [O, O], [O, O], [O, O]]),
    w("SLOPE", Modifier, NONE, [[O, 47], [O, 47], [O, 47], [O, 629], [O, O], [O, O]]),
    w("SLOT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 207], [O, O], [O, O]]),
    w("SLOWDN", Post, NONE, [[1063, O], [1063, O], [1063, O], [1063, O], [O, O], [O, O]]),
    w("SMALL", Modifier, NONE, [[O, 26], [O, 26], [O, 26], [O, 663], [O, O], [O, O]]),
    w("SMESH", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("SMIL", Regional, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("SMILL", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 756], [O, O], [O, O]]),
    w("SMM", Modifier, NONE, [[O, O], [O, O], [O, 505], [O, 505], [O, O], [O, K]]),
    w("SMOOTH", Post, NONE, [[O, O], [O, O], [1085, O], [1085, O], [O, O], [O, O]]),
    w("SOLID", Modifier, NONE, [[O, 123], [O, 123], [O, 123], [O, 123], [O, 189], [O, O]]),
    w("SP", Post, NONE, [[O, O], [O, O], [O, O], [1031, O], [O, O], [O, O]]),
    w("SPACE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 944], [O, O], [O, O]]),
    w("SPATF", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("SPEED", Modifier, NONE, [[O, O], [O, O], [O, 272], [O, O], [O, O], [O, O]]),
    w("SPHERE", Geometry, Some(Modifier), [[s(13), O], [s(13), O], [O, 631], [O, 631], [O, O], [O, O]]),
    w("SPINDL", Post, NONE, [[1031, O], [1031, O], [1031, O], [1031, O], [O, O], [O, O]]),
    w("SPIRAL", Modifier, NONE, [[O, O], [O, 175], [O, O], [O, O], [O, O], [O, O]]),
    w("SPLINE", Modifier, NONE, [[O, 105], [O, 105], [O, 628], [O, 628], [O, O], [O, O]]),
    w("SQRT", Function, NONE, [[O, O], [O, O], [O, O], [O, 555], [O, O], [O, O]]),
    w("SQRTF", Function, NONE, [[K, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("SQUARE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 955], [O, O], [O, O]]),
    w("SRFTYP", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 875], [O, O], [O, O]]),
    w("SRFVCT", Motion, NONE, [[r(5000, 8), O], [r(5000, 8), O], [O, O], [857, O], [O, O], [O, O]]),
    w("SSPLIN", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 619], [O, O], [O, O]]),
    w("SSPRT", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("SSTEST", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("SSURF", Geometry, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("STACK", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 927], [O, O], [O, O]]),
    w("STAR", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 953], [O, O], [O, O]]),
    w("START", Modifier, NONE, [[O, 57], [O, 57], [O, 57], [O, 57], [O, O], [O, O]]),
    w("STAT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 864], [O, O], [O, O]]),
    w("STD", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 920], [O, O], [O, O]]),
    w("STEP", Modifier, NONE, [[O, 92], [O, 92], [O, 92], [O, 92], [O, O], [O, O]]),
    w("STEPOV", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("STL", Modifier, NONE, [[O, O], [O, O], [O, 330], [O, 330], [O, O], [O, O]]),
    w("STOCK", Post, Some(Modifier), [[O, O], [O, O], [O, 321], [O, 321], [O, O], [O, O]]),
    w("STOP", Post, NONE, [[2, O], [2, O], [2, O], [2, O], [O, O], [O, O]]),
    w("STRCMP", Function, NONE, [[O, O], [O, O], [O, O], [O, 581], [O, O], [O, O]]),
    w("STRING", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 945], [O, O], [O, O]]),
    w("STROKE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 946], [O, O], [O, O]]),
    w("STRTPT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 665], [O, O], [O, O]]),
    w("STYLE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 948], [O, O], [O, O]]),
    w("SUBPECK", Modifier, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [O, K]]),
    w("SUBSCR", Control, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("SUBSTR", Function, NONE, [[O, O], [O, O], [O, O], [O, 580], [O, O], [O, O]]),
    w("SURF", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 609], [O, O], [O, O]]),
    w("SVAL", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("SWAP", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 111], [O, O], [O, O]]),
    w("SWITCH", Post, NONE, [[6, O], [6, O], [6, O], [O, O], [O, O], [O, O]]),
    w("SYMBOL", Modifier, NONE, [[O, O], [O, O], [O, 235], [O, 877], [O, O], [O, O]]),
    w("SYN", Control, NONE, [[K, O], [K, O], [O, O], [804, O], [O, O], [O, O]]),
    w("TA", Modifier, NONE, [[O, O], [O, K], [O, O], [O, 721], [O, O], [O, O]]),
    w("TABCYL", Geometry, NONE, [[s(50), O], [s(50), O], [O, O], [O, O], [O, O], [O, O]]),
    w("TABLE", Modifier, NONE, [[O, O], [O, O], [O, 177], [O, 177], [O, 224], [O, O]]),
    w("TABPRT", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("TAN", Function, NONE, [[O, O], [O, O], [O, O], [O, 554], [O, O], [O, O]]),
    w("TANB", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("TANCRV", Control, NONE, [[K, O], [O, O], [O, O], [O, O], [O, O], [O, O]]),
    w("TANDS", Modifier, NONE, [[O, 183], [O, O], [O, O], [O, O], [O, O], [O, O]]),
    w("TANF", Function, NONE, [[K, O], [K, O], [O, O], [O, 554], [O, O], [O, O]]),
    w("TANHF", Function, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("TANON", Modifier, NONE, [[O, 109], [O, 109], [O, O], [O, O], [O, O], [O, O]]),
    w("TANSPL", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("TANTO", Modifier, NONE, [[O, 27], [O, 27], [O, 27], [O, 646], [O, O], [O, O]]),
    w("TAP", Modifier, NONE, [[O, 168], [O, 168], [O, 168], [O, 168], [O, O], [O, O]]),
    w("TAPEFT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 660], [O, O], [O, O]]),
    w("TAPKUL", Modifier, NONE, [[O, 91], [O, 91], [O, O], [O, O], [O, O], [O, O]]),
    w("TC", Control, NONE, [[O, O], [O, O], [O, O], [O, 812], [O, O], [O, O]]),
    w("TCP", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("TDATA", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("TDIST", Function, NONE, [[O, O], [O, O], [O, O], [O, 585], [O, O], [O, O]]),
    w("TDISTF", Function, NONE, [[O, O], [O, O], [O, O], [O, 585], [O, O], [O, O]]),
    w("TE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 650], [O, O], [O, O]]),
    w("TERMAC", Control, NONE, [[K, O], [K, O], [O, O], [807, O], [O, O], [O, O]]),
    w("TEXTF", Function, NONE, [[O, O], [O, O], [O, O], [O, 38], [O, O], [O, O]]),
    w("TH", Motion, NONE, [[O, O], [O, O], [O, O], [O, 717], [O, O], [O, O]]),
    w("THEN", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 938], [O, O], [O, O]]),
    w("THETAR", Modifier, NONE, [[O, 107], [O, 107], [O, 107], [O, 107], [O, O], [O, O]]),
    w("THICK", Motion, NONE, [[r(9000, 5), O], [r(9000, 5), O], [O, O], [717, O], [O, O], [O, O]]),
    w("THREAD", Post, NONE, [[1036, O], [1036, O], [1036, O], [1036, O], [O, O], [O, O]]),
    w("THRU", Modifier, NONE, [[O, 152], [O, 152], [O, 152], [O, 152], [O, O], [O, O]]),
    w("TILT", Modifier, NONE, [[O, O], [O, O], [O, 247], [O, O], [O, O], [O, O]]),
    w("TIMES", Modifier, NONE, [[O, 28], [O, 28], [O, 28], [O, 28], [O, O], [O, O]]),
    w("TITLES", Text, NONE, [[K, O], [K, O], [1095, O], [1092, O], [O, O], [O, O]]),
    w("TL", Motion, NONE, [[O, O], [O, O], [O, O], [O, 719], [O, O], [O, O]]),
    w("TLAXIS", Motion, NONE, [[r(9000, 1), O], [r(9000, 1), O], [O, O], [721, O], [O, O], [O, O]]),
    w("TLDATA", Post, NONE, [[O, O], [O, O], [1079, O], [O, O], [O, O], [K, O]]),
    w("TLLFT", Motion, NONE, [[r(4000, 1), O], [r(4000, 1), O], [O, O], [719, O], [O, O], [O, O]]),
    w("TLNDON", Motion, NONE, [[r(4000, 3), O], [r(4000, 3), O], [O, O], [O, O], [O, O], [O, O]]),
    w("TLOFPS", Motion, NONE, [[r(4000, 6), O], [r(4000, 6), O], [O, O], [725, O], [O, O], [O, O]]),
    w("TLON", Motion, NONE, [[r(4000, 3), O], [r(4000, 3), O], [O, O], [718, O], [O, O], [O, O]]),
    w("TLONPS", Motion, NONE, [[r(4000, 5), O], [r(4000, 5), O], [O, O], [724, O], [O, O], [O, O]]),
    w("TLPROJ", Regional, NONE, [[O, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("TLRGT", Motion, NONE, [[r(4000, 2), O], [r(4000, 2), O], [O, O], [720, O], [O, O], [O, O]]),
    w("TM", Post, NONE, [[O, O], [O, O], [O, O], [1005, O], [O, O], [O, O]]),
    w("TMARK", Post, NONE, [[1005, O], [1005, O], [1005, O], [1005, O], [O, O], [O, O]]),
    w("TN", Motion, NONE, [[O, O], [O, O], [O, O], [O, 718], [O, O], [O, O]]),
    w("TO", Modifier, NONE, [[O, 69], [O, 69], [O, 69], [O, 714], [O, O], [O, O]]),
    w("TOLER", Motion, NONE, [[r(6000, 2), O], [r(6000, 2), O], [731, O], [731, O], [O, O], [O, O]]),
    w("TOOL", Geometry, Some(Modifier), [[s(17), O], [s(17), O], [O, 617], [O, 617], [O, 226], [O, O]]),
    w("TOOLNO", Post, NONE, [[1025, O], [1025, O], [1025, O], [1025, O], [O, O], [O, O]]),
    w("TOOLPN", Post, NONE, [[O, O], [O, O], [1053, O], [1053, O], [O, O], [O, O]]),
    w("TORCH", Modifier, NONE, [[O, O], [O, O], [O, 172], [O, 175], [O, O], [O, O]]),
    w("TORUS", Modifier, NONE, [[O, O], [O, O], [O, 627], [O, 627], [O, O], [O, O]]),
    w("TP", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("TPI", Modifier, NONE, [[O, 143], [O, 143], [O, 143], [O, 143], [O, O], [O, O]]),
    w("TPRINT", Post, NONE, [[O, O], [O, O], [1047, O], [O, O], [O, O], [O, O]]),
    w("TR", Motion, NONE, [[O, O], [O, O], [O, O], [O, 720], [O, O], [O, O]]),
    w("TRACUT", Control, NONE, [[1038, O], [1038, O], [1038, O], [812, O], [O, O], [O, O]]),
    w("TRALST", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 842], [O, O], [O, O]]),
    w("TRANS", Post, NONE, [[1037, O], [1037, O], [1037, O], [1037, O], [O, O], [O, O]]),
    w("TRANSL", Modifier, NONE, [[O, 29], [O, 29], [O, 29], [O, 649], [O, O], [O, O]]),
    w("TRANTO", Motion, NONE, [[r(6000, 7), O], [r(6000, 7), O], [O, O], [O, O], [O, O], [O, O]]),
    w("TRAV", Modifier, NONE, [[O, 154], [O, 154], [O, 154], [O, 154], [O, O], [O, O]]),
    w("TRAVED", Modifier, NONE, [[O, O], [O, 172], [O, O], [O, O], [O, O], [O, O]]),
    w("TRFORM", Modifier, NONE, [[O, 110], [O, 110], [O, 110], [O, 110], [O, O], [O, O]]),
    w("TRIAN", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 954], [O, O], [O, O]]),
    w("TRNTYP", Post, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [K, O]]),
    w("TT", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 646], [O, O], [O, O]]),
    w("TU", Post, NONE, [[O, O], [O, O], [O, O], [1033, O], [O, O], [O, O]]),
    w("TUNEUP", Control, NONE, [[K, O], [K, O], [O, O], [O, O], [O, O], [O, O]]),
    w("TURN", Modifier, NONE, [[O, 80], [O, 80], [O, 80], [O, 80], [O, O], [O, O]]),
    w("TURRET", Post, NONE, [[1033, O], [1033, O], [1033, O], [1033, O], [O, O], [O, O]]),
    w("TV", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("TVAL", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("TWOPT", Modifier, NONE, [[O, 102], [O, 102], [O, O], [O, O], [O, O], [O, O]]),
    w("TYPE", Modifier, NONE, [[O, 98], [O, 98], [O, 98], [O, 98], [O, O], [O, O]]),
    w("TYPEF", Function, NONE, [[O, O], [O, O], [O, O], [O, 98], [O, O], [O, O]]),
    w("UAXIS", Post, NONE, [[O, O], [O, O], [1018, O], [1018, O], [O, O], [O, O]]),
    w("UBFN", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 862], [O, O], [O, O]]),
    w("UCONST", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("ULOCKX", Post, NONE, [[20, O], [20, O], [O, O], [O, O], [O, O], [O, O]]),
    w("UNDO", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 845], [O, O], [O, O]]),
    w("UNIT", Modifier, Some(Control), [[O, 30], [O, 30], [O, 30], [O, 30], [O, O], [K, O]]),
    w("UNITS", Control, NONE, [[O, O], [r(9000, 9), O], [841, O], [841, O], [O, O], [O, O]]),
    w("UNLOAD", Post, NONE, [[10, O], [10, O], [10, O], [10, O], [O, O], [O, O]]),
    w("UP", Modifier, NONE, [[O, 112], [O, 112], [O, 112], [O, 112], [O, O], [O, O]]),
    w("USONIC", Post, NONE, [[O, O], [O, O], [1093, O], [1093, O], [O, O], [O, O]]),
    w("UVAL", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("UVPDS", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("UVPPS", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("VACUUM", Post, NONE, [[O, O], [O, O], [1094, O], [1094, O], [O, O], [O, O]]),
    w("VAXIS", Post, NONE, [[O, O], [O, O], [O, O], [1032, O], [O, O], [O, O]]),
    w("VCONST", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("VE", Geometry, NONE, [[O, O], [O, O], [O, O], [O, 604], [O, O], [O, O]]),
    w("VECTOR", Geometry, NONE, [[s(11), O], [s(11), O], [604, O], [604, O], [O, O], [O, O]]),
    w("VIEW", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 923], [O, O], [O, O]]),
    w("VISIBL", Post, NONE, [[O, O], [O, O], [O, O], [1095, O], [O, O], [O, O]]),
    w("VMP3AX", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 962], [O, O], [O, O]]),
    w("VMP5AX", Post, NONE, [[O, O], [O, O], [O, O], [1022, O], [O, O], [O, O]]),
    w("VMPMOD", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 764], [O, O], [O, O]]),
    w("VMPOCK", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 765], [O, O], [O, O]]),
    w("VOCABF", Function, NONE, [[O, O], [O, O], [O, O], [O, 549], [O, O], [O, O]]),
    w("VTLAXS", Control, NONE, [[1070, O], [1070, O], [O, O], [O, O], [O, O], [O, O]]),
    w("VVAL", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("WARN", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 852], [O, O], [O, O]]),
    w("WATRLN", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 892], [O, O], [O, O]]),
    w("WAXIS", Post, NONE, [[O, O], [O, O], [O, O], [1096, O], [O, O], [O, O]]),
    w("WCORN", Control, NONE, [[1071, O], [1071, O], [O, O], [O, O], [O, O], [O, O]]),
    w("WEIGHT", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("WHITE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 905], [O, O], [O, O]]),
    w("WIRE", Post, NONE, [[O, O], [O, O], [O, O], [1028, O], [O, O], [O, O]]),
    w("WITH", Modifier, NONE, [[O, O], [O, K], [O, O], [O, O], [O, O], [O, O]]),
    w("WORLD", Modifier, NONE, [[O, O], [O, O], [O, O], [O, O], [O, O], [O, K]]),
    w("WRAP", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 889], [O, O], [O, O]]),
    w("WRTMDI", Post, NONE, [[O, O], [1051, O], [O, O], [O, O], [O, O], [O, O]]),
    w("XAXIS", Modifier, NONE, [[O, 84], [O, 84], [O, 84], [O, 84], [O, O], [O, O]]),
    w("XCOORD", Modifier, NONE, [[O, 116], [O, 116], [O, 116], [O, 116], [O, O], [O, O]]),
    w("XL", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 638], [O, O], [O, O]]),
    w("XLARGE", Modifier, NONE, [[O, 31], [O, 31], [O, 31], [O, 638], [O, O], [O, O]]),
    w("XOFSET", Post, NONE, [[O, O], [O, O], [1084, O], [O, O], [O, O], [O, O]]),
    w("XS", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 641], [O, O], [O, O]]),
    w("XSMALL", Modifier, NONE, [[O, 32], [O, 32], [O, 32], [O, 641], [O, O], [O, O]]),
    w("XTYPE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 99], [O, O], [O, O]]),
    w("XTYPEF", Function, NONE, [[O, O], [O, O], [O, O], [O, 99], [O, O], [O, O]]),
    w("XYPLAN", Modifier, NONE, [[O, 33], [O, 33], [O, 33], [O, 33], [O, O], [O, O]]),
    w("XYROT", Modifier, NONE, [[O, 34], [O, 34], [O, 34], [O, 733], [O, O], [O, O]]),
    w("XYVIEW", Modifier, NONE, [[O, 120], [O, 120], [O, O], [O, O], [O, O], [O, O]]),
    w("XYZ", Modifier, NONE, [[O, 108], [O, 108], [O, 108], [O, O], [O, O], [O, O]]),
    w("XYZPLN", Modifier, NONE, [[O, O], [O, O], [O, 45], [O, 45], [O, O], [O, O]]),
    w("YAXIS", Modifier, NONE, [[O, 85], [O, 85], [O, 85], [O, 85], [O, O], [O, O]]),
    w("YCOORD", Modifier, NONE, [[O, 117], [O, 117], [O, 117], [O, 117], [O, O], [O, O]]),
    w("YELLOW", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 910], [O, O], [O, O]]),
    w("YL", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 639], [O, O], [O, O]]),
    w("YLARGE", Modifier, NONE, [[O, 35], [O, 35], [O, 35], [O, 639], [O, O], [O, O]]),
    w("YS", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 642], [O, O], [O, O]]),
    w("YSMALL", Modifier, NONE, [[O, 36], [O, 36], [O, 36], [O, 642], [O, O], [O, O]]),
    w("YZPLAN", Modifier, NONE, [[O, 37], [O, 37], [O, 37], [O, 37], [O, O], [O, O]]),
    w("YZROT", Modifier, NONE, [[O, 38], [O, 38], [O, 38], [O, 734], [O, O], [O, O]]),
    w("YZVIEW", Modifier, NONE, [[O, 121], [O, 121], [O, O], [O, O], [O, O], [O, O]]),
    w("ZAXIS", Modifier, NONE, [[O, 86], [O, 86], [O, 86], [O, 86], [O, O], [O, O]]),
    w("ZCOORD", Modifier, NONE, [[O, 118], [O, 118], [O, 118], [O, 118], [O, O], [O, O]]),
    w("ZERO", Post, NONE, [[13, O], [13, O], [O, O], [O, O], [O, O], [O, O]]),
    w("ZIGZAG", Modifier, NONE, [[O, 170], [O, 177], [O, 170], [O, 170], [O, O], [O, O]]),
    w("ZL", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 640], [O, O], [O, O]]),
    w("ZLARGE", Modifier, NONE, [[O, 39], [O, 39], [O, 39], [O, 640], [O, O], [O, O]]),
    w("ZONE", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 760], [O, O], [O, O]]),
    w("ZS", Modifier, NONE, [[O, O], [O, O], [O, O], [O, 643], [O, O], [O, O]]),
    w("ZSMALL", Modifier, NONE, [[O, 40], [O, 40], [O, 40], [O, 643], [O, O], [O, O]]),
    w("ZSURF", Control, NONE, [[K, O], [K, O], [O, O], [647, O], [O, O], [O, O]]),
    w("ZXPLAN", Modifier, NONE, [[O, 41], [O, 41], [O, 41], [O, 41], [O, O], [O, O]]),
    w("ZXROT", Modifier, NONE, [[O, 42], [O, 42], [O, 42], [O, 735], [O, O], [O, O]]),
    w("ZXVIEW", Modifier, NONE, [[O, 122], [O, 122], [O, O], [O, O], [O, O], [O, O]]),
];

/// Spreads packed spellings over `SLOTS`: chosen so that the longest probe is short.
pub(crate) const MULTIPLIER: u64 = 0x105cb87fe1596f6d;

/// Packed spellings, in the order of `ENTRIES`.
#[rustfmt::skip]
pub(crate) static PACKED: [u64; COUNT as usize] = [
    0x444e412e, 0x51452e, 0x45534c41462e, 0x45472e, 0x54472e, 0x454c2e, 0x544c2e, 0x454e2e,
    0x544f4e2e, 0x524f2e, 0x455552542e, 0x4b434550545331, 0x434c41434432, 0x434c41434433, 0x4c5332545033, 0x4c5331545034,
    0x545035, 0x4141, 0x5349584141, 0x534241, 0x46534241, 0x4c4f534241, 0x535345434341, 0x534f4341,
    0x46534f4341, 0x455649544341, 0x5453554a4441, 0x524941, 0x4e47494c41, 0x4c4c41, 0x5245544c41, 0x5a594c414e41,
    0x4c474e41, 0x424c474e41, 0x454c474e41, 0x464c474e41, 0x45544f4e41, 0x495053544e41, 0x444e45505041, 0x594c505041,
    0x4e4152545041, 0x4e4552545041, 0x435241, 0x544144435241, 0x564f4d435241, 0x42534f435241, 0x46534f435241, 0x504c53435241,
    0x574f525241, 0x424e49535241, 0x464e49535241, 0x5341, 0x4e495341, 0x464e495341, 0x45504f4c5341, 0x5441,
    0x4e415441, 0x324e415441, 0x42324e415441, 0x46324e415441, 0x424e415441, 0x464e415441, 0x4c474e415441, 0x424952545441,
    0x4f545541, 0x53504f545541, 0x4e5546585541, 0x4c5254435641, 0x47534d5641, 0x44494f5641, 0x5452505641, 0x59415741,
    0x53495841, 0x4b434142, 0x524142, 0x45534142, 0x5349584142, 0x444342, 0x4e49474542, 0x534c45564542,
    0x5952414e4942, 0x4d524f4e4942, 0x4b43414c42, 0x4544414c42, 0x4b434f4c42, 0x45554c42, 0x524544524f42, 0x45524f42,
    0x3545524f42, 0x3645524f42, 0x3745524f42, 0x3845524f42, 0x3945524f42, 0x48544f42, 0x444e554f42, 0x53444e554f42,
    0x584f42, 0x4b41455242, 0x5048434b5242, 0x4e574f5242, 0x505342, 0x4143, 0x4c4c4143, 0x534c4c4143,
    0x4255534c4143, 0x4d4143, 0x4152454d4143, 0x4e4143, 0x464e4143, 0x4e4f4e4143, 0x5349584143, 0x45524f4243,
    0x4654524243, 0x574c4343, 0x574343, 0x4543, 0x5245544e4543, 0x455641534643, 0x52464d414843, 0x4c454e4e414843,
    0x5450444843, 0x4b43454843, 0x5350494843, 0x5354504b4843, 0x4652534b4843, 0x44524f4843, 0x4b43554843, 0x4943,
    0x454c43524943, 0x4c5543524943, 0x4e494c524943, 0x504d414c43, 0x5441444c43, 0x415441444c43, 0x465441444c43, 0x545349444c43,
    0x5241454c43, 0x505241454c43, 0x535241454c43, 0x454c49464c43, 0x4650494c43, 0x454e4f4c43, 0x45534f4c43, 0x544e52504c43,
    0x465253524c43, 0x56544c43, 0x574c43, 0x4d43, 0x54494d43, 0x4f43, 0x455352414f43, 0x4c45444f43,
    0x5350414c4f43, 0x464c4f43, 0x54454c4c4f43, 0x524f4c4f43, 0x4e49424d4f43, 0x534f504d4f43, 0x454e4f43, 0x43494e4f43,
    0x4345534e4f43, 0x54534e4f43, 0x544e4f43, 0x5443544e4f43, 0x4e49544e4f43, 0x4c52544e4f43, 0x544e4c4f4f43, 0x59504f43,
    0x44464e524f43, 0x534f43, 0x42534f43, 0x46534f43, 0x4648534f43, 0x424e41544f43, 0x464e41544f43, 0x454c50554f43,
    0x53534f5243, 0x4c5053535243, 0x5343, 0x4b4e495343, 0x535343, 0x56555343, 0x53595343, 0x4e494c525443,
    0x5543, 0x45425543, 0x474553525543, 0x4556525543, 0x545543, 0x474e41545543, 0x4d4f43545543, 0x524554545543,
    0x5643, 0x5743, 0x5943, 0x4e415943, 0x454c435943, 0x52444e4c5943, 0x434144, 0x4b524144,
    0x48534144, 0x544448534144, 0x4e4c48534144, 0x505348534144, 0x41544144, 0x4e464244, 0x5249434c4244, 0x4344,
    0x4d494c4444, 0x4755424544, 0x474755424544, 0x504d4f434544, 0x52434544, 0x50454544, 0x3250454544, 0x4b4250454544,
    0x4c4350454544, 0x544c41464544, 0x4d414e464544, 0x425553464544, 0x59414c4544, 0x4554454c4544, 0x41544c4544, 0x4854504544,
    0x52544d414944, 0x444e4f4d4944, 0x4b534944, 0x424450534944, 0x594c50534944, 0x54534944, 0x4654534944, 0x4f54544944,
    0x4c4c494d44, 0x545543544e44, 0x4f44, 0x544f44, 0x46544f44, 0x444554544f44, 0x4e574f44, 0x5244,
    0x5446415244, 0x47415244, 0x494c57415244, 0x5353455244, 0x4c4c495244, 0x5344, 0x4e41545344, 0x56555344,
    0x4c4c455744, 0x504d444e5944, 0x45474445, 0x5443454a45, 0x5350494c4c45, 0x4652534d4c45, 0x45534c45, 0x464945534c45,
    0x444e45, 0x435241444e45, 0x4649444e45, 0x49444d444e45, 0x5450444e45, 0x425553444e45, 0x454741474e45, 0x4553415245,
    0x524f525245, 0x5956485845, 0x505845, 0x46505845, 0x445552545845, 0x45434146, 0x4c4d45434146, 0x4e4146,
    0x4546, 0x544152444546, 0x4f54444546, 0x44454546, 0x5844454546, 0x5944454546, 0x5a44454546, 0x54454546,
    0x4843544546, 0x54454c4c4946, 0x5245544c4946, 0x444e4946, 0x5845444e4946, 0x454e4946, 0x494e4946, 0x4853494e4946,
    0x544946, 0x454e4f564946, 0x525554584946, 0x444f4f4c46, 0x574f4c46, 0x4853554c46, 0x534554554c46, 0x4c4c494d46,
    0x544e4f46, 0x4543524f46, 0x54414d524f46, 0x52554f46, 0x545052554f46, 0x545046, 0x5246, 0x4d4f5246,
    0x544e4f5246, 0x4c4c5546, 0x59464f4e5546, 0x445746, 0x53454c504147, 0x4247, 0x5241454c4347, 0x43494e4f4347,
    0x4447, 0x5255434e4547, 0x5354504e4547, 0x4f4547, 0x4d4f4547, 0x544547, 0x4647, 0x414647,
    0x4c47, 0x4853454d47, 0x4f47, 0x4b4341424f47, 0x574c43434f47, 0x52454c434f47, 0x574c434f47, 0x41544c444f47,
    0x4e574f444f47, 0x4457464f47, 0x414457464f47, 0x454d4f484f47, 0x54464c4f47, 0x54464f4c4f47, 0x4c4c494d4f47, 0x5447524f47,
    0x4f544f47, 0x4b4347554f47, 0x50554f47, 0x5247, 0x4e45455247, 0x59455247, 0x44495247, 0x5447,
    0x4544495547, 0x44414548, 0x5956414548, 0x544847494548, 0x4c4143494c4548, 0x58494c4548, 0x584548, 0x4e4544444948,
    0x48474948, 0x5448474948, 0x5245444c4f48, 0x454d4f48, 0x425245505948, 0x4649, 0x4f524649, 0x4c4f544649,
    0x4e49, 0x534548434e49, 0x44554c434e49, 0x52434e49, 0x5845444e49, 0x465845444e49, 0x505249444e49, 0x565249444e49,
    0x544249484e49, 0x54494e49, 0x545245534e49, 0x544e49, 0x444f43544e49, 0x534e45544e49, 0x435245544e49, 0x505245544e49,
    0x46544e49, 0x464f544e49, 0x33464f544e49, 0x4c4f544e49, 0x434553544e49, 0x535245564e49, 0x5349564e49, 0x4f49,
    0x334f49, 0x5049, 0x4d5049, 0x525049, 0x444e414c5349, 0x504f545349, 0x5649, 0x4f54504d554a,
    0x4546494e4b, 0x544f4e4b, 0x5a5545524b, 0x414c, 0x4c4542414c, 0x4543414c, 0x47414c, 0x454752414c,
    0x5453414c, 0x454854414c, 0x524559414c, 0x4659414c, 0x43494e4f434c, 0x454c, 0x4441454c, 0x52454441454c,
    0x5446454c, 0x4854474e454c, 0x52494454454c, 0x47524f54454c, 0x5a495354454c, 0x52455454454c, 0x4c4556454c, 0x494c,
    0x54525042494c, 0x595242494c, 0x544847494c, 0x54494d494c, 0x5249434e494c, 0x454e494c, 0x5241454e494c, 0x4c4f544e494c,
    0x5059544e494c, 0x5447574e494c, 0x5453494c, 0x474e495453494c, 0x4e4f5453494c, 0x4554494c, 0x4e4c, 0x48544e4c,
    0x4648544e4c, 0x44414f4c, 0x4c5444414f4c, 0x5544414f4c, 0x4c41434f4c, 0x4b434f4c, 0x584b434f4c, 0x54464f4c,
    0x474f4c, 0x463031474f4c, 0x46474f4c, 0x474e4f4c, 0x4b4f4f4c, 0x444e504f4f4c, 0x5453504f4f4c, 0x574f4c,
    0x544e4952504c, 0x544f4447524c, 0x544c, 0x45554c42544c, 0x4e4154544c, 0x56544c, 0x4e494843414d, 0x4f5243414d,
    0x41544e47414d, 0x50415447414d, 0x4e49414d, 0x4c41554e414d, 0x52454b52414d, 0x464b52414d, 0x4c524554414d, 0x58495254414d,
    0x463158414d, 0x474e4158414d, 0x504458414d, 0x4d504458414d, 0x4658414d, 0x4d504958414d, 0x534958414d, 0x474e4c58414d,
    0x53545058414d, 0x4d505258414d, 0x50545358414d, 0x4c455658414d, 0x445758414d, 0x4e494648434d, 0x4c4f5448434d, 0x535953434d,
    0x444e45444d, 0x54495257444d, 0x44454d, 0x4d554944454d, 0x4853454d, 0x454c4444494d, 0x4c4c494d, 0x44464c4c494d,
    0x50524c4c494d, 0x46314e494d, 0x464e494d, 0x4445464e494d, 0x53554e494d, 0x524f5252494d, 0x5453494d, 0x54494d,
    0x4d4d, 0x4d504d4d, 0x52504d4d, 0x4f4d, 0x534c41444f4d, 0x545543444f4d, 0x45444f4d, 0x46444f4d,
    0x594649444f4d, 0x535953444f4d, 0x524944544f4d, 0x4e4f49544f4d, 0x435241564f4d, 0x45564f4d, 0x4f5445564f4d, 0x5359534d,
    0x5841544c554d, 0x4452544c554d, 0x584d, 0x454d414e, 0x44454d414e, 0x53444e, 0x54534554444e, 0x54505241454e,
    0x5847454e, 0x5947454e, 0x5a47454e, 0x4c525455454e, 0x5458454e, 0x4c545458454e, 0x464e, 0x454c4242494e,
    0x544e494e, 0x46544e494e, 0x454958494e, 0x4d4e, 0x4b4341424f4e, 0x444e424f4e, 0x50524c434f4e, 0x5453494c4f4e,
    0x45524f4d4f4e, 0x544f4c504f4e, 0x54534f504f4e, 0x53504f4e, 0x4c414d524f4e, 0x53444d524f4e, 0x53504d524f4e, 0x574f4e,
    0x4e5241574f4e, 0x504152574f4e, 0x584f4e, 0x594f4e, 0x5a4f4e, 0x53504e, 0x48534e, 0x45504148534e,
    0x465255534e, 0x4d554e, 0x464d554e, 0x5354504d554e, 0x534252554e, 0x424f, 0x5443454a424f, 0x4e494154424f,
    0x46464f, 0x54455346464f, 0x4c544553464f, 0x54494d4f, 0x4e4f, 0x45434e4f, 0x4e45504f, 0x454d414e504f,
    0x544f4c50504f, 0x50494b53504f, 0x504f5453504f, 0x4e4f4954504f, 0x45474e41524f, 0x544e4549524f, 0x4e494749524f, 0x4f4e5445534f,
    0x54554f, 0x4c4f5454554f, 0x544f4c50564f, 0x4150, 0x544e494150, 0x54454c4c4150, 0x4241524150, 0x4d41524150,
    0x534d41524150, 0x4d4c45524150, 0x4c454c524150, 0x464d524150, 0x465253524150, 0x54524150, 0x4f4e54524150, 0x53534150,
    0x54534150, 0x4843544150, 0x4e5245544150, 0x48544150, 0x534250, 0x4450, 0x534450, 0x4550,
    0x4e4550, 0x4e57444e4550, 0x50554e4550, 0x544e43524550, 0x4d49524550, 0x4e494d524550, 0x4f5450524550, 0x564552524550,
    0x5053524550, 0x4d544e414850, 0x44464b434950, 0x50554b434950, 0x4b4e4950, 0x4843544950, 0x544f564950, 0x5a544f564950,
    0x4c50, 0x4c4542414c50, 0x4543414c50, 0x454e414c50, 0x4f4e414c50, 0x544f4c50, 0x5446544f4c50, 0x45474e554c50,
    0x53554c50, 0x4c4c494d50, 0x4e50, 0x4e4f53544e50, 0x434556544e50, 0x54454b434f50, 0x444f50, 0x464544444f50,
    0x535450444f50, 0x544e494f50, 0x444f4d4b4f50, 0x4e4f434c4f50, 0x4e47594c4f50, 0x4c4143534f50, 0x4e5449534f50, 0x50414d534f50,
    0x4e534f50, 0x4e54534f50, 0x58534f50, 0x59534f50, 0x5a534f50, 0x544f4c5050, 0x4e54504f5050, 0x544e49525050,
    0x535050, 0x4c4f545050, 0x48434e555050, 0x44524f575050, 0x4e5546455250, 0x544e495250, 0x46544e495250, 0x45424f5250,
    0x58424f5250, 0x59424f5250, 0x4c49464f5250, 0x54434a4f5250, 0x54504d4f5250, 0x5350, 0x4f4455455350, 0x53495350,
    0x4e41545350, 0x525245545350, 0x56555350, 0x5450, 0x4d524f4e5450, 0x594c4e4f5450, 0x504f4c535450, 0x5550,
    0x48434e5550, 0x454c50525550, 0x545550, 0x5650, 0x4c415650, 0x434952444151, 0x5349584151, 0x4c4c495551,
    0x544c495551, 0x4152, 0x4c4149444152, 0x535549444152, 0x4c494152, 0x4d4152, 0x504d4152, 0x4d4f444e4152,
    0x45474e4152, 0x4449504152, 0x4f54504152, 0x4552, 0x44414552, 0x4c414552, 0x4d414552, 0x52414552,
    0x444552, 0x4645444552, 0x574152444552, 0x535953464552, 0x4b5242474552, 0x4e4f49474552, 0x44524f474552, 0x4c4f54474552,
    0x4c4f544c4552, 0x4b52414d4552, 0x45564f4d4552, 0x454d414e4552, 0x544145504552, 0x565245534552, 0x5445534552, 0x524f54534552,
    0x4e4941544552, 0x52544552, 0x544352544552, 0x4e5255544552, 0x564552, 0x535245564552, 0x564c4f564552, 0x444e49574552,
    0x5448474952, 0x5845444e4952, 0x465253444c52, 0x4c4c494d52, 0x4f52, 0x4c4241544f52, 0x455441544f52, 0x444548544f52,
    0x464552544f52, 0x4847554f52, 0x4554554f52, 0x5052, 0x4d5052, 0x5352, 0x5452, 0x415445485452,
    0x4f5443525452, 0x44454c5552, 0x454c44444153, 0x595445464153, 0x454d4153, 0x45564153, 0x5545564153, 0x49444d564153,
    0x494454564153, 0x52414c414353, 0x454c414353, 0x504f4c414353, 0x4e4f4353, 0x454249524353, 0x4255524353, 0x5652554353,
    0x4e5247414553, 0x31434553, 0x32434553, 0x474553, 0x4c54434c4553, 0x5443454c4553, 0x4f4e514553, 0x434e55514553,
    0x544553, 0x474e41544553, 0x4c4f4f544553, 0x5055544553, 0x4653, 0x4d4653, 0x4853, 0x4544414853,
    0x4b4e414853, 0x4550414853, 0x5052414853, 0x5446494853, 0x4f4853, 0x54524f4853, 0x45444953, 0x464e474953,
    0x4e4953, 0x424e4953, 0x464e4953, 0x454c474e4953, 0x46484e4953, 0x584953, 0x455a4953, 0x50494b53,
    0x4543494c53, 0x45504f4c53, 0x544f4c53, 0x4e44574f4c53, 0x4c4c414d53, 0x4853454d53, 0x4c494d53, 0x4c4c494d53,
    0x4d4d53, 0x48544f4f4d53, 0x44494c4f53, 0x5053, 0x4543415053, 0x4654415053, 0x4445455053, 0x455245485053,
    0x4c444e495053, 0x4c4152495053, 0x454e494c5053, 0x54525153, 0x4654525153, 0x455241555153, 0x505954465253, 0x544356465253,
    0x4e494c505353, 0x5452505353, 0x545345545353, 0x4652555353, 0x4b43415453, 0x52415453, 0x5452415453, 0x54415453,
    0x445453, 0x50455453, 0x564f50455453, 0x4c5453, 0x4b434f5453, 0x504f5453, 0x504d43525453, 0x474e49525453,
    0x454b4f525453, 0x545054525453, 0x454c595453, 0x4b434550425553, 0x524353425553, 0x525453425553, 0x46525553, 0x4c415653,
    0x50415753, 0x484354495753, 0x4c4f424d5953, 0x4e5953, 0x4154, 0x4c5943424154, 0x454c424154, 0x545250424154,
    0x4e4154, 0x424e4154, 0x5652434e4154, 0x53444e4154, 0x464e4154, 0x46484e4154, 0x4e4f4e4154, 0x4c50534e4154,
    0x4f544e4154, 0x504154, 0x544645504154, 0x4c554b504154, 0x4354, 0x504354, 0x4154414454, 0x5453494454,
    0x465453494454, 0x4554, 0x43414d524554, 0x4654584554, 0x4854, 0x4e454854, 0x524154454854, 0x4b43494854,
    0x444145524854, 0x55524854, 0x544c4954, 0x53454d4954, 0x53454c544954, 0x4c54, 0x534958414c54, 0x415441444c54,
    0x54464c4c54, 0x4e4f444e4c54, 0x5350464f4c54, 0x4e4f4c54, 0x53504e4f4c54, 0x4a4f52504c54, 0x5447524c54, 0x4d54,
    0x4b52414d54, 0x4e54, 0x4f54, 0x52454c4f54, 0x4c4f4f54, 0x4f4e4c4f4f54, 0x4e504c4f4f54, 0x4843524f54,
    0x5355524f54, 0x5054, 0x495054, 0x544e49525054, 0x5254, 0x545543415254, 0x54534c415254, 0x534e415254,
    0x4c534e415254, 0x4f544e415254, 0x56415254, 0x444556415254, 0x4d524f465254, 0x4e41495254, 0x5059544e5254, 0x5454,
    0x5554, 0x5055454e5554, 0x4e525554, 0x544552525554, 0x5654, 0x4c415654, 0x54504f5754, 0x45505954,
    0x4645505954, 0x5349584155, 0x4e464255, 0x54534e4f4355, 0x584b434f4c55, 0x4f444e55, 0x54494e55, 0x5354494e55,
    0x44414f4c4e55, 0x5055, 0x43494e4f5355, 0x4c415655, 0x5344505655, 0x5350505655, 0x4d5555434156, 0x5349584156,
    0x54534e4f4356, 0x4556, 0x524f54434556, 0x57454956, 0x4c4249534956, 0x584133504d56, 0x584135504d56, 0x444f4d504d56,
    0x4b434f504d56, 0x464241434f56, 0x5358414c5456, 0x4c415656, 0x4e524157, 0x4e4c52544157, 0x5349584157, 0x4e524f4357,
    0x544847494557, 0x4554494857, 0x45524957, 0x48544957, 0x444c524f57, 0x50415257, 0x49444d545257, 0x5349584158,
    0x44524f4f4358, 0x4c58, 0x454752414c58, 0x544553464f58, 0x5358, 0x4c4c414d5358, 0x4550595458, 0x464550595458,
    0x4e414c505958, 0x544f525958, 0x574549565958, 0x5a5958, 0x4e4c505a5958, 0x5349584159, 0x44524f4f4359, 0x574f4c4c4559,
    0x4c59, 0x454752414c59, 0x5359, 0x4c4c414d5359, 0x4e414c505a59, 0x544f525a59, 0x574549565a59, 0x534958415a,
    0x44524f4f435a, 0x4f52455a, 0x47415a47495a, 0x4c5a, 0x454752414c5a, 0x454e4f5a, 0x535a, 0x4c4c414d535a,
    0x465255535a, 0x4e414c50585a, 0x544f52585a, 0x57454956585a,
];

/// Open-addressed table of indices into `ENTRIES`; `u16::MAX` is an empty slot.
#[rustfmt::skip]
pub(crate) static SLOTS: [u16; 4096] = [
    584, 862, 65535, 65535, 65535, 65535, 31, 140, 65535, 65535, 65535, 643, 65535, 65535, 583, 65535,
    65535, 865, 144, 65535, 65535, 65535, 6, 65535, 818, 351, 61, 108, 915, 586, 65535, 65535,
    65535, 628, 65535, 65535, 65535, 65535, 65535, 65535, 167, 502, 261, 65535, 65535, 665, 65535, 65535,
    65535, 65535, 65535, 65535, 855, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 350, 541, 119, 304,
    794, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 357, 65535,
    65535, 174, 546, 65535, 65535, 65535, 65535, 65535, 854, 585, 65535, 65535, 65535, 65535, 65535, 65535,
    871, 65535, 65535, 65535, 822, 65535, 65535, 65535, 682, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 213, 65535, 65535, 65535, 65535, 518, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 756, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 282, 65535, 65535, 384, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 659, 65535, 491, 458, 65535, 65535,
    65535, 107, 695, 65535, 36, 752, 65535, 65535, 65535, 65535, 65535, 214, 693, 65535, 593, 65535,
    783, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 239, 692, 65535, 65535, 75,
    65535, 65535, 868, 981, 65535, 65535, 407, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    88, 65535, 530, 65535, 65535, 65535, 65535, 65535, 65535, 942, 65535, 65535, 65535, 375, 65535, 65535,
    565, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 714, 65535, 337, 65535, 65535, 65535, 65535, 65535,
    704, 65535, 65535, 65535, 65535, 65535, 753, 575, 922, 65535, 65535, 657, 65535, 65535, 65535, 380,
    65535, 65535, 65535, 900, 812, 65535, 65535, 320, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 317, 949, 184, 892, 65535, 226, 65535, 65535, 65535, 65535,
    65535, 162, 928, 65535, 65535, 676, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 782, 65535, 300, 426, 611, 683, 65535, 65535, 558, 246, 65535,
    65535, 65535, 65535, 65535, 65535, 82, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 608, 65535, 880, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 8, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 844, 65535, 65535,
    65535, 594, 39, 948, 340, 841, 65535, 834, 65535, 65535, 65535, 65535, 283, 65535, 65535, 40,
    65535, 65535, 65535, 65535, 492, 486, 65535, 72, 65535, 65535, 65535, 65535, 293, 480, 65535, 65535,
    957, 65535, 65535, 185, 65535, 65535, 270, 65535, 65535, 65535, 522, 599, 65535, 65535, 520, 65535,
    65535, 65535, 65535, 537, 65535, 65535, 65535, 435, 65535, 65535, 65535, 430, 126, 65535, 65535, 65535,
    483, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 125, 65535, 65535, 65535, 65535, 65535, 951, 65535,
    65535, 65535, 65535, 65535, 742, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 601, 353, 746,
    65535, 46, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 175, 289, 931, 65535, 65535, 65535,
    65535, 65535, 65535, 538, 840, 65535, 737, 65535, 916, 65535, 65535, 436, 219, 986, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 478, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 386, 475, 65535, 65535, 65535, 65535, 97, 65535,
    65535, 65535, 65535, 137, 65535, 65535, 65535, 861, 65535, 65535, 65535, 65535, 65535, 65535, 494, 65535,
    65535, 42, 65535, 65535, 65535, 885, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 744, 65535, 65535, 65535, 65535, 322, 389, 953, 65535, 443, 765,
    65535, 65535, 336, 820, 65535, 65535, 65535, 279, 917, 397, 904, 263, 627, 65535, 830, 65535,
    65535, 843, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 35, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 225, 595, 65535, 65535, 65535, 275, 65535, 180, 65535, 572, 65535, 65535, 109, 65535, 940,
    65535, 65535, 65535, 65535, 363, 971, 65535, 65535, 65535, 641, 781, 312, 65535, 555, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 84, 417, 473, 186, 65535, 65535, 65535, 147, 65535, 447, 65535,
    65535, 65535, 65535, 65535, 580, 65535, 65535, 302, 65535, 65535, 639, 65535, 661, 65535, 605, 198,
    467, 65535, 65535, 355, 65535, 65535, 65535, 65535, 352, 758, 65535, 65535, 400, 646, 65535, 65535,
    501, 65535, 65535, 838, 965, 65535, 656, 65535, 65535, 65535, 562, 65535, 65535, 65535, 65535, 65535,
    65535, 230, 65535, 65535, 65535, 65535, 65535, 138, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 619,
    65535, 65535, 65535, 65535, 65535, 136, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 44, 651,
    65535, 65535, 65535, 402, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 4, 65535, 5, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 414, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 711, 65535, 419, 356, 65535, 65535, 544, 324, 602, 759, 65535, 65535, 65535, 638, 65535,
    476, 688, 462, 987, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 811,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 298, 768, 716, 876, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    968, 65535, 65535, 65535, 906, 51, 731, 874, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 529, 65535, 65535, 774, 65535, 65535, 65535, 65535, 65535, 372, 65535, 65535, 254,
    437, 773, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    454, 65535, 65535, 750, 65535, 65535, 952, 65535, 65535, 132, 65535, 983, 65535, 488, 65535, 65535,
    65535, 65535, 271, 65535, 65535, 65535, 691, 65535, 432, 554, 612, 955, 65535, 65535, 177, 65535,
    65535, 65535, 22, 25, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 339, 474, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 686, 696, 65535, 65535, 21, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 633, 65535, 65535, 65535, 975, 65535, 65535, 65535, 65535, 535,
    65535, 745, 65535, 65535, 65535, 663, 65535, 456, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    114, 846, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 96, 65535, 65535, 455,
    65535, 50, 65535, 65535, 65535, 65535, 918, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 291, 879,
    65535, 65535, 408, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 675,
    453, 65535, 925, 296, 410, 65535, 831, 65535, 65535, 65535, 800, 65535, 65535, 65535, 65535, 553,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 645, 65535, 924, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 151, 2, 65535, 65535, 65535, 65535, 65535, 120, 115,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 466, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    685, 183, 65535, 34, 65535, 979, 383, 65535, 65535, 65535, 65535, 795, 65535, 65535, 65535, 65535,
    65535, 450, 65535, 65535, 65535, 65535, 65535, 86, 65535, 65535, 67, 65535, 433, 65535, 65535, 65535,
    65535, 65535, 65535, 802, 65535, 65535, 65535, 894, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 222,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 853, 65535, 966, 65535, 65535, 65535,
    65535, 570, 65535, 130, 65535, 65535, 128, 65535, 65535, 741, 65535, 65535, 349, 65535, 65535, 65535,
    65535, 83, 415, 668, 243, 65535, 65535, 172, 907, 65535, 543, 65535, 65535, 564, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 733, 65535, 65535, 65535, 65535, 429, 977, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 145, 65535, 1, 299, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 365, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 155, 65535, 65535, 123, 65535, 65535, 471, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 772, 919, 65535, 105, 600, 65535, 804, 65535, 65535, 65535,
    582, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 195, 697, 65535, 65535, 909, 65535, 65535, 215,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 37, 507, 653, 65535, 65535, 65535, 168, 65535,
    65535, 65535, 65535, 65535, 796, 65535, 223, 65535, 65535, 787, 396, 798, 65535, 65535, 65535, 65535,
    65535, 65535, 93, 574, 65535, 65535, 65535, 65535, 65535, 65535, 749, 526, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 978, 65535, 354, 65535, 65535, 65535, 485, 65535,
    65535, 178, 505, 889, 65535, 65535, 65535, 65535, 721, 65535, 65535, 912, 65535, 959, 65535, 65535,
    516, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 251, 333, 65535, 967, 65535, 65535, 65535, 65535, 65535, 65535, 416, 378, 65535, 944, 677,
    65535, 65535, 976, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 241, 65535, 65535, 524, 684,
    65535, 65535, 857, 65535, 624, 65535, 65, 65535, 859, 392, 65535, 65535, 65535, 268, 961, 65535,
    65535, 65535, 14, 626, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 323, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 899, 65535, 65535, 65535, 65535, 65535, 311, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 338, 972, 65535, 65535, 65535, 576, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 418, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 513, 65535, 65535, 65535, 65535, 615, 65535, 65535, 65535, 65535, 65535, 766,
    65535, 65535, 65535, 65535, 3, 65535, 65535, 65535, 65535, 65535, 65535, 943, 65535, 278, 65535, 65535,
    65535, 65535, 65535, 56, 388, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 762,
    65535, 331, 923, 65535, 65535, 297, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 666,
    65535, 163, 292, 65535, 65535, 65535, 65535, 63, 87, 347, 65535, 65535, 561, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 206, 395, 65535, 65535, 65535, 57, 65535, 65535, 65535, 65535, 65535,
    66, 512, 878, 448, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 883, 65535, 65535, 65535, 65535,
    851, 65535, 345, 65535, 65535, 65535, 65535, 245, 687, 921, 65535, 65535, 65535, 65535, 827, 53,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 460, 65535, 65535, 65535, 65535, 65535, 65535, 470,
    65535, 65535, 65535, 65535, 65535, 824, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 81, 65535, 937, 65535, 897, 817, 28, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 376, 65535, 65535, 65535, 65535, 65535, 341, 65535, 65535, 65535, 382, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 545, 65535, 577, 498, 65535, 65535, 65535, 65535, 65535, 669, 65535,
    65535, 65535, 65535, 192, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 517, 779, 65535, 65535, 143,
    65535, 65535, 65535, 592, 65535, 65535, 65535, 65535, 65535, 65535, 308, 65535, 24, 65535, 65535, 65535,
    65535, 62, 65535, 674, 962, 65535, 65535, 65535, 679, 65535, 65535, 65535, 65535, 65535, 176, 65535,
    65535, 65535, 65535, 65535, 309, 65535, 65535, 650, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 141, 860, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 604, 65535, 65535,
    65535, 65535, 65535, 248, 65535, 65535, 65535, 199, 47, 65535, 65535, 65535, 65535, 65535, 288, 65535,
    65535, 65535, 65535, 65535, 29, 65535, 65535, 939, 328, 371, 703, 655, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 58, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 710,
    65535, 65535, 548, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 315, 65535,
    65535, 272, 236, 65535, 755, 65535, 65535, 65535, 65535, 65535, 65535, 623, 856, 785, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 748, 65535, 65535, 65535, 65535, 559, 65535, 85, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 487, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 265, 65535, 934, 581, 625, 65535, 933, 814, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 680, 65535, 65535, 65535, 65535, 227, 699, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 11, 65535, 60, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 929, 65535,
    65535, 369, 65535, 427, 515, 65535, 65535, 65535, 65535, 65535, 65535, 896, 65535, 65535, 65535, 65535,
    65535, 65535, 77, 65535, 65535, 249, 65535, 259, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    751, 65535, 65535, 808, 775, 65535, 65535, 65535, 235, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 622, 65535, 65535, 65535, 65535, 65535, 65535, 644, 217, 819, 65535, 642, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 947, 277, 78, 65535, 65535, 65535, 65535, 196, 65535,
    640, 65535, 65535, 65535, 65535, 65535, 503, 146, 403, 563, 926, 65535, 124, 65535, 65535, 725,
    65535, 65535, 374, 73, 65535, 65535, 65535, 65535, 65535, 161, 391, 65535, 65535, 65535, 65535, 65535,
    65535, 569, 65535, 65535, 65535, 65535, 194, 908, 65535, 190, 65535, 65535, 65535, 65535, 833, 65535,
    65535, 65535, 65535, 65535, 65535, 366, 65535, 65535, 65535, 65535, 244, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 510, 65535, 65535, 65535, 65535, 65535, 65535, 658, 65535, 65535, 65535, 479,
    65535, 65535, 65535, 65535, 65535, 65535, 253, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 568, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 499, 65535, 65535,
    815, 65535, 621, 65535, 813, 902, 65535, 65535, 667, 377, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 32, 65535, 131, 65535, 634, 65535, 65535, 65535, 65535, 694, 65535, 65535, 189, 65535, 866,
    65535, 490, 381, 65535, 65535, 65535, 65535, 780, 65535, 65535, 65535, 65535, 858, 65535, 65535, 863,
    65535, 65535, 65535, 65535, 65535, 728, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 412,
    65535, 65535, 519, 893, 65535, 65535, 65535, 65535, 65535, 886, 65535, 65535, 65535, 159, 65535, 65535,
    79, 825, 65535, 477, 65535, 65535, 65535, 152, 65535, 65535, 65535, 216, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 754, 847, 228, 598, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 102,
    69, 334, 629, 181, 954, 65535, 65535, 65535, 65535, 65535, 229, 423, 65535, 946, 65535, 65535,
    65535, 65535, 65535, 849, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 398, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 92, 65535, 65535, 65535, 303, 508, 65535, 65535, 260,
    65535, 826, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 121, 65535, 158, 65535,
    542, 55, 872, 284, 65535, 65535, 358, 705, 164, 65535, 65535, 373, 652, 65535, 65535, 65535,
    65535, 449, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    212, 65535, 65535, 511, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 252, 65535, 286, 65535, 65535, 567, 65535, 65535, 65535, 285, 65535, 65535, 65535, 65535, 65535,
    65535, 348, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 528, 65535, 65535, 65535,
    65535, 65535, 888, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 521, 65535, 65535, 65535,
    65535, 723, 65535, 65535, 65535, 65535, 65535, 188, 442, 65535, 65535, 65535, 65535, 65535, 493, 905,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 770, 65535, 65535, 65535, 65535, 65535, 207, 65535,
    65535, 431, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 367,
    65535, 80, 65535, 65535, 65535, 65535, 41, 65535, 65535, 65535, 881, 65535, 65535, 65535, 718, 65535,
    65535, 65535, 801, 65535, 65535, 173, 65535, 65535, 65535, 65535, 238, 832, 938, 65535, 950, 103,
    65535, 65535, 276, 330, 65535, 65535, 409, 221, 821, 247, 969, 65535, 848, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 852, 153, 632, 65535, 65535,
    65535, 65535, 33, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 616, 65535, 65535, 440, 65535,
    65535, 385, 65535, 65535, 65535, 65535, 344, 65535, 65535, 65535, 65535, 65535, 65535, 401, 65535, 65535,
    65535, 65535, 461, 65535, 314, 65535, 65535, 65535, 65535, 18, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 306, 65535, 784, 65535, 9, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 743, 65535, 65535, 65535, 65535, 65535, 984, 65535, 65535, 65535, 65535, 579, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 335, 764, 65535, 647, 701, 805, 65535, 65535, 65535,
    65535, 10, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 129, 406, 65535, 715, 205, 65535, 65535,
    65535, 65535, 65535, 734, 65535, 0, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 210, 65535, 65535,
    65535, 65535, 256, 65535, 65535, 65535, 678, 791, 65535, 65535, 65535, 38, 65535, 65535, 65535, 65535,
    489, 65535, 65535, 43, 65535, 200, 469, 65535, 65535, 735, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 250, 106, 65535, 65535, 603, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 610, 65535, 171, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 170, 313, 65535, 65535,
    134, 65535, 203, 936, 65535, 65535, 65535, 65535, 224, 65535, 65535, 438, 956, 65535, 65535, 65535,
    792, 65535, 65535, 793, 65535, 65535, 65535, 65535, 65535, 404, 65535, 65535, 65535, 135, 980, 65535,
    65535, 27, 91, 65535, 618, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 17, 484, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 803, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 399,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 578, 797, 65535, 65535, 606, 65535, 636,
    806, 65535, 65535, 65535, 65535, 65535, 829, 65535, 65535, 65535, 65535, 65535, 65535, 732, 65535, 76,
    232, 845, 65535, 65535, 65535, 65535, 65535, 65535, 985, 65535, 169, 589, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 539, 65535, 65535, 566, 160, 368, 763, 65535, 154, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 504, 65535, 910, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 127, 963,
    65535, 65535, 65535, 65535, 65535, 45, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 257, 786, 911, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 139, 65535, 65535,
    65535, 370, 65535, 65535, 65535, 65535, 65535, 117, 65535, 713, 65535, 65535, 65535, 65535, 630, 413,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 281, 65535, 816, 319, 65535, 807, 65535, 65535, 65535,
    387, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 451, 547, 65535, 65535, 65535, 597,
    65535, 346, 148, 65535, 65535, 65535, 65535, 828, 617, 65535, 65535, 709, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 362, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 914,
    712, 970, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 258, 65535,
    941, 242, 835, 65535, 700, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 68, 65535, 823,
    65535, 65535, 65535, 65535, 65535, 65535, 635, 197, 720, 65535, 457, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 789, 65535, 65535, 65535, 65535, 689, 65535, 65535, 65535, 65535, 65535, 65535, 424,
    65535, 65535, 65535, 65535, 290, 65535, 98, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 790, 65535,
    65535, 761, 65535, 65535, 65535, 65535, 269, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 736, 65535,
    233, 65535, 327, 65535, 65535, 110, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 446, 65535,
    65535, 65535, 65535, 434, 65535, 549, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 113, 637, 810, 65535, 65535, 65535, 65535, 681, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    654, 65535, 65535, 445, 65535, 65535, 65535, 65535, 65535, 472, 65535, 65535, 65535, 325, 65535, 973,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 52, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 193,
    903, 65535, 65535, 65535, 514, 875, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 739, 65535, 65535, 65535, 65535,
    65535, 65535, 240, 65535, 65535, 65535, 166, 65535, 707, 935, 702, 65535, 65535, 165, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 740, 65535, 65535, 670, 65535, 496, 901, 287, 65535, 65535, 65535, 90, 65535, 65535, 65535,
    65535, 65535, 698, 730, 65535, 65535, 390, 532, 982, 65535, 65535, 65535, 65535, 65535, 65535, 719,
    425, 211, 342, 65535, 65535, 23, 65535, 65535, 65535, 481, 65535, 379, 65535, 65535, 65535, 65535,
    571, 465, 65535, 662, 842, 65535, 65535, 65535, 65535, 111, 65535, 65535, 65535, 202, 65535, 65535,
    65535, 101, 65535, 65535, 441, 65535, 65535, 65535, 65535, 65535, 65535, 231, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 738, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 867, 65535, 65535, 65535, 65535, 65535, 332, 65535, 116, 573, 760, 964, 65535,
    587, 596, 65535, 65535, 411, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 295, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 837, 65535, 65535, 65535, 65535, 65535, 65535, 536, 609, 65535,
    65535, 65535, 65535, 20, 422, 664, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 405, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 588,
    560, 65535, 280, 264, 468, 525, 65535, 65535, 65535, 65535, 724, 727, 65535, 65535, 65535, 65535,
    65535, 364, 59, 65535, 65535, 49, 65535, 65535, 65535, 65535, 65535, 74, 65535, 65535, 717, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 757, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 209,
    70, 65535, 65535, 112, 187, 974, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 428, 65535, 156, 218, 65535, 65535, 65535, 65535, 873, 30, 932, 65535, 65535, 150, 444,
    65535, 65535, 747, 65535, 65535, 65535, 65535, 65535, 65535, 722, 65535, 531, 898, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 19, 201, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 439, 65535, 65535, 65535, 65535, 65535, 884, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 552, 65535, 420, 65535, 65535, 65535, 12, 65535, 65535, 65535, 65535, 157, 65535, 65535,
    65535, 65535, 318, 65535, 65535, 65535, 958, 65535, 65535, 65535, 65535, 65535, 920, 65535, 65535, 65535,
    65535, 65535, 65535, 149, 631, 869, 65535, 65535, 65535, 65535, 204, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 671, 65535, 65535, 65535, 495, 65535, 556, 65535, 65535, 65535, 16, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 771, 788, 65535, 65535, 65535, 262, 361, 65535, 65535, 267,
    394, 648, 877, 65535, 459, 65535, 65535, 65535, 65535, 65535, 500, 65535, 65535, 95, 65535, 65535,
    65535, 310, 65535, 726, 836, 65535, 65535, 65535, 65535, 65535, 65535, 94, 65535, 65535, 65535, 65535,
    65535, 891, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 360, 65535, 65535, 65535, 65535, 329,
    65535, 65535, 65535, 65535, 65535, 7, 708, 65535, 65535, 482, 65535, 65535, 65535, 65535, 65535, 359,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 930, 220, 65535, 65535, 913, 65535, 65535,
    65535, 799, 65535, 65535, 778, 809, 65535, 887, 65535, 65535, 15, 316, 540, 777, 65535, 769,
    65535, 523, 497, 65535, 65535, 65535, 89, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 551, 65535, 591, 767, 65535, 118, 65535, 100, 65535, 65535, 133, 255, 65535,
    550, 65535, 65535, 65535, 65535, 65535, 179, 266, 104, 614, 613, 895, 393, 65535, 65535, 65535,
    690, 65535, 65535, 65535, 64, 65535, 65535, 65535, 65535, 65535, 142, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 607, 65535, 960, 182, 65535, 65535, 65535, 506, 945, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 452, 65535, 65535, 65535, 65535, 65535, 65535, 13, 65535,
    65535, 65535, 237, 191, 557, 65535, 65535, 65535, 890, 65535, 65535, 65535, 294, 870, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 234, 776, 729, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 343, 672, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 673, 65535, 65535, 65535, 65535, 527, 65535, 463, 65535, 65535, 839, 65535, 65535,
    71, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 99, 590, 65535, 65535, 65535, 274, 65535, 65535, 65535, 65535, 65535, 65535,
    65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 54, 421, 660,
    534, 65535, 65535, 65535, 464, 882, 65535, 65535, 509, 65535, 65535, 65535, 65535, 65535, 26, 65535,
    65535, 65535, 65535, 65535, 65535, 864, 326, 65535, 65535, 533, 65535, 65535, 65535, 65535, 65535, 301,
    65535, 65535, 65535, 927, 65535, 65535, 65535, 620, 65535, 65535, 649, 65535, 65535, 65535, 65535, 65535,
    307, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 65535, 208, 65535, 321, 65535,
    122, 65535, 65535, 65535, 65535, 65535, 65535, 305, 48, 273, 706, 65535, 65535, 65535, 65535, 850,
];

/// (dialect, minor, stored code, index into `ENTRIES`), sorted for a binary search.
#[rustfmt::skip]
pub(crate) static BY_CODE: [(u8, bool, u32, u16); 1685] = [
    (0, false, 0x1, 256),
    (0, false, 0x2, 821),
    (0, false, 0x3, 570),
    (0, false, 0x4, 389),
    (0, false, 0x5, 689),
    (0, false, 0x6, 833),
    (0, false, 0x7, 714),
    (0, false, 0x8, 243),
    (0, false, 0x9, 611),
    (0, false, 0xa, 920),
    (0, false, 0xb, 602),
    (0, false, 0xc, 601),
    (0, false, 0xd, 977),
    (0, false, 0xe, 331),
    (0, false, 0xf, 710),
    (0, false, 0x10, 325),
    (0, false, 0x11, 242),
    (0, false, 0x12, 657),
    (0, false, 0x13, 656),
    (0, false, 0x14, 916),
    (0, false, 0x15, 438),
    (0, false, 0x16, 270),
    (0, false, 0x80, 600),
    (0, false, 0x3e9, 623),
    (0, false, 0x3ea, 345),
    (0, false, 0x3eb, 502),
    (0, false, 0x3ec, 137),
    (0, false, 0x3ed, 880),
    (0, false, 0x3ee, 719),
    (0, false, 0x3ef, 190),
    (0, false, 0x3f0, 717),
    (0, false, 0x3f1, 273),
    (0, false, 0x3f2, 220),
    (0, false, 0x3f3, 27),
    (0, false, 0x3f4, 569),
    (0, false, 0x3f5, 407),
    (0, false, 0x3f6, 645),
    (0, false, 0x3f7, 454),
    (0, false, 0x3f8, 478),
    (0, false, 0x3f9, 615),
    (0, false, 0x3fa, 477),
    (0, false, 0x3fb, 758),
    (0, false, 0x3fc, 372),
    (0, false, 0x3fd, 228),
    (0, false, 0x3fe, 66),
    (0, false, 0x3ff, 121),
    (0, false, 0x400, 641),
    (0, false, 0x401, 885),
    (0, false, 0x402, 725),
    (0, false, 0x403, 574),
    (0, false, 0x404, 739),
    (0, false, 0x405, 47),
    (0, false, 0x406, 166),
    (0, false, 0x407, 800),
    (0, false, 0x408, 358),
    (0, false, 0x409, 907),
    (0, false, 0x40b, 727),
    (0, false, 0x40c, 864),
    (0, false, 0x40d, 895),
    (0, false, 0x40e, 893),
    (0, false, 0x40f, 364),
    (0, false, 0x410, 167),
    (0, false, 0x411, 621),
    (0, false, 0x412, 578),
    (0, false, 0x413, 413),
    (0, false, 0x414, 647),
    (0, false, 0x415, 590),
    (0, false, 0x416, 370),
    (0, false, 0x417, 106),
    (0, false, 0x418, 652),
    (0, false, 0x419, 175),
    (0, false, 0x41a, 613),
    (0, false, 0x41b, 481),
    (0, false, 0x41c, 480),
    (0, false, 0x41d, 54),
    (0, false, 0x41e, 196),
    (0, false, 0x41f, 434),
    (0, false, 0x420, 756),
    (0, false, 0x421, 144),
    (0, false, 0x422, 248),
    (0, false, 0x423, 240),
    (0, false, 0x424, 131),
    (0, false, 0x425, 617),
    (0, false, 0x426, 467),
    (0, false, 0x427, 787),
    (0, false, 0x428, 475),
    (0, false, 0x429, 448),
    (0, false, 0x42a, 510),
    (0, false, 0x42b, 168),
    (0, false, 0x42c, 596),
    (0, false, 0x42d, 700),
    (0, false, 0x42e, 938),
    (0, false, 0x42f, 943),
    (0, false, 0x430, 457),
    (0, false, 0x40000001, 633),
    (0, false, 0x40000002, 421),
    (0, false, 0x40000003, 619),
    (0, false, 0x40000004, 128),
    (0, false, 0x40000005, 197),
    (0, false, 0x40000006, 252),
    (0, false, 0x40000007, 356),
    (0, false, 0x40000008, 158),
    (0, false, 0x40000009, 311),
    (0, false, 0x4000000a, 404),
    (0, false, 0x4000000b, 930),
    (0, false, 0x4000000c, 463),
    (0, false, 0x4000000d, 799),
    (0, false, 0x4000000e, 677),
    (0, false, 0x4000000f, 635),
    (0, false, 0x40000010, 439),
    (0, false, 0x40000011, 884),
    (0, false, 0x40000012, 594),
    (0, false, 0x40000032, 837),
    (0, false, 0x40000033, 484),
    (0, false, 0x40000034, 160),
    (0, false, 0x40000035, 722),
    (0, false, 0x40000036, 253),
    (0, false, 0x800bb804, 663),
    (0, false, 0x800c1b00, 109),
    (0, false, 0x800fa001, 872),
    (0, false, 0x800fa002, 878),
    (0, false, 0x800fa003, 875),
    (0, false, 0x800fa005, 876),
    (0, false, 0x800fa006, 874),
    (0, false, 0x80138801, 366),
    (0, false, 0x80138802, 367),
    (0, false, 0x80138803, 303),
    (0, false, 0x80138804, 327),
    (0, false, 0x80138805, 336),
    (0, false, 0x80138808, 807),
    (0, false, 0x80177001, 188),
    (0, false, 0x80177002, 883),
    (0, false, 0x80177004, 379),
    (0, false, 0x80177005, 577),
    (0, false, 0x80177006, 191),
    (0, false, 0x80177007, 897),
    (0, false, 0x80177009, 249),
    (0, false, 0x8017700b, 232),
    (0, false, 0x801b5801, 322),
    (0, false, 0x801b5802, 561),
    (0, false, 0x801f4001, 332),
    (0, false, 0x801f4002, 335),
    (0, false, 0x801f4003, 329),
    (0, false, 0x801f4004, 323),
    (0, false, 0x801f4005, 338),
    (0, false, 0x801f4006, 328),
    (0, false, 0x80232801, 870),
    (0, false, 0x80232802, 512),
    (0, false, 0x80232803, 466),
    (0, false, 0x80232804, 555),
    (0, false, 0x80232805, 863),
    (0, false, 0x80232806, 539),
    (0, false, 0x80232807, 65),
    (0, false, 0x80232808, 337),
    (0, false, 0x802af801, 629),
    (0, false, 0x8036b000, 286),
    (0, true, 0x1, 62),
    (0, true, 0x2, 116),
    (0, true, 0x3, 176),
    (0, true, 0x4, 306),
    (0, true, 0x5, 377),
    (0, true, 0x6, 381),
    (0, true, 0x7, 399),
    (0, true, 0x8, 408),
    (0, true, 0x9, 409),
    (0, true, 0xa, 492),
    (0, true, 0xb, 520),
    (0, true, 0xc, 521),
    (0, true, 0xd, 522),
    (0, true, 0xe, 546),
    (0, true, 0xf, 547),
    (0, true, 0x10, 548),
    (0, true, 0x11, 586),
    (0, true, 0x12, 606),
    (0, true, 0x13, 624),
    (0, true, 0x14, 642),
    (0, true, 0x15, 643),
    (0, true, 0x16, 644),
    (0, true, 0x17, 683),
    (0, true, 0x18, 720),
    (0, true, 0x19, 746),
    (0, true, 0x1a, 788),
    (0, true, 0x1b, 848),
    (0, true, 0x1c, 867),
    (0, true, 0x1d, 896),
    (0, true, 0x1e, 918),
    (0, true, 0x1f, 954),
    (0, true, 0x20, 957),
    (0, true, 0x21, 960),
    (0, true, 0x22, 961),
    (0, true, 0x23, 969),
    (0, true, 0x24, 971),
    (0, true, 0x25, 972),
    (0, true, 0x26, 973),
    (0, true, 0x27, 980),
    (0, true, 0x28, 983),
    (0, true, 0x29, 985),
    (0, true, 0x2a, 986),
    (0, true, 0x2b, 14),
    (0, true, 0x2c, 15),
    (0, true, 0x2d, 16),
    (0, true, 0x2e, 374),
    (0, true, 0x2f, 785),
    (0, true, 0x30, 360),
    (0, true, 0x31, 576),
    (0, true, 0x32, 566),
    (0, true, 0x33, 29),
    (0, true, 0x34, 400),
    (0, true, 0x35, 536),
    (0, true, 0x36, 740),
    (0, true, 0x37, 504),
    (0, true, 0x38, 493),
    (0, true, 0x39, 814),
    (0, true, 0x3a, 257),
    (0, true, 0x3b, 113),
    (0, true, 0x3c, 146),
    (0, true, 0x3d, 483),
    (0, true, 0x3e, 352),
    (0, true, 0x3f, 447),
    (0, true, 0x40, 161),
    (0, true, 0x41, 212),
    (0, true, 0x42, 363),
    (0, true, 0x43, 608),
    (0, true, 0x44, 728),
    (0, true, 0x45, 882),
    (0, true, 0x46, 592),
    (0, true, 0x47, 564),
    (0, true, 0x48, 560),
    (0, true, 0x49, 386),
    (0, true, 0x4a, 387),
    (0, true, 0x4b, 129),
    (0, true, 0x4c, 422),
    (0, true, 0x4d, 582),
    (0, true, 0x4e, 732),
    (0, true, 0x4f, 473),
    (0, true, 0x50, 906),
    (0, true, 0x51, 269),
    (0, true, 0x52, 87),
    (0, true, 0x53, 93),
    (0, true, 0x54, 951),
    (0, true, 0x55, 965),
    (0, true, 0x56, 975),
    (0, true, 0x57, 42),
    (0, true, 0x58, 64),
    (0, true, 0x59, 291),
    (0, true, 0x5a, 494),
    (0, true, 0x5b, 851),
    (0, true, 0x5c, 817),
    (0, true, 0x5d, 458),
    (0, true, 0x5e, 774),
    (0, true, 0x5f, 420),
    (0, true, 0x60, 469),
    (0, true, 0x61, 716),
    (0, true, 0x62, 911),
    (0, true, 0x63, 530),
    (0, true, 0x64, 418),
    (0, true, 0x65, 300),
    (0, true, 0x66, 910),
    (0, true, 0x67, 670),
    (0, true, 0x68, 668),
    (0, true, 0x69, 802),
    (0, true, 0x6a, 735),
    (0, true, 0x6b, 862),
    (0, true, 0x6c, 963),
    (0, true, 0x6d, 846),
    (0, true, 0x6e, 900),
    (0, true, 0x6f, 540),
    (0, true, 0x70, 921),
    (0, true, 0x71, 238),
    (0, true, 0x72, 437),
    (0, true, 0x73, 765),
    (0, true, 0x74, 952),
    (0, true, 0x75, 966),
    (0, true, 0x76, 976),
    (0, true, 0x77, 513),
    (0, true, 0x78, 962),
    (0, true, 0x79, 974),
    (0, true, 0x7a, 987),
    (0, true, 0x7b, 794),
    (0, true, 0x7c, 200),
    (0, true, 0x7d, 237),
    (0, true, 0x7e, 130),
    (0, true, 0x7f, 231),
    (0, true, 0x80, 600),
    (0, true, 0x81, 749),
    (0, true, 0x82, 82),
    (0, true, 0x83, 696),
    (0, true, 0x84, 340),
    (0, true, 0x85, 85),
    (0, true, 0x86, 373),
    (0, true, 0x87, 429),
    (0, true, 0x88, 482),
    (0, true, 0x89, 199),
    (0, true, 0x8a, 126),
    (0, true, 0x8b, 154),
    (0, true, 0x8c, 18),
    (0, true, 0x8d, 76),
    (0, true, 0x8e, 110),
    (0, true, 0x8f, 890),
    (0, true, 0x90, 571),
    (0, true, 0x91, 688),
    (0, true, 0x92, 664),
    (0, true, 0x93, 305),
    (0, true, 0x94, 304),
    (0, true, 0x95, 695),
    (0, true, 0x96, 738),
    (0, true, 0x97, 486),
    (0, true, 0x98, 865),
    (0, true, 0x99, 213),
    (0, true, 0x9a, 898),
    (0, true, 0x9b, 762),
    (0, true, 0x9c, 761),
    (0, true, 0x9d, 354),
    (0, true, 0x9e, 459),
    (0, true, 0x9f, 26),
    (0, true, 0xa0, 189),
    (0, true, 0xa1, 543),
    (0, true, 0xa2, 524),
    (0, true, 0xa3, 244),
    (0, true, 0xa4, 80),
    (0, true, 0xa5, 77),
    (0, true, 0xa6, 589),
    (0, true, 0xa7, 694),
    (0, true, 0xa8, 849),
    (0, true, 0xa9, 105),
    (0, true, 0xaa, 978),
    (0, true, 0xab, 712),
    (0, true, 0xac, 563),
    (0, true, 0xad, 69),
    (0, true, 0xae, 687),
    (0, true, 0xaf, 55),
    (0, true, 0xb0, 342),
    (0, true, 0xb4, 308),
    (0, true, 0xb5, 542),
    (0, true, 0xb6, 541),
    (0, true, 0xb7, 843),
    (0, true, 0xb8, 271),
    (1, false, 0x1, 256),
    (1, false, 0x2, 821),
    (1, false, 0x3, 570),
    (1, false, 0x4, 389),
    (1, false, 0x5, 689),
    (1, false, 0x6, 833),
    (1, false, 0x7, 714),
    (1, false, 0x8, 243),
    (1, false, 0x9, 611),
    (1, false, 0xa, 920),
    (1, false, 0xb, 602),
    (1, false, 0xc, 601),
    (1, false, 0xd, 977),
    (1, false, 0xe, 331),
    (1, false, 0xf, 710),
    (1, false, 0x10, 325),
    (1, false, 0x11, 97),
    (1, false, 0x12, 657),
    (1, false, 0x13, 656),
    (1, false, 0x14, 916),
    (1, false, 0x15, 438),
    (1, false, 0x16, 270),
    (1, false, 0x80, 600),
    (1, false, 0x9d, 354),
    (1, false, 0x3e9, 623),
    (1, false, 0x3ea, 345),
    (1, false, 0x3eb, 502),
    (1, false, 0x3ec, 137),
    (1, false, 0x3ed, 880),
    (1, false, 0x3ee, 719),
    (1, false, 0x3ef, 190),
    (1, false, 0x3f0, 717),
    (1, false, 0x3f1, 273),
    (1, false, 0x3f2, 220),
    (1, false, 0x3f3, 27),
    (1, false, 0x3f4, 569),
    (1, false, 0x3f5, 407),
    (1, false, 0x3f6, 645),
    (1, false, 0x3f7, 454),
    (1, false, 0x3f8, 478),
    (1, false, 0x3f9, 615),
    (1, false, 0x3fa, 477),
    (1, false, 0x3fb, 758),
    (1, false, 0x3fc, 372),
    (1, false, 0x3fd, 228),
    (1, false, 0x3fe, 66),
    (1, false, 0x3ff, 121),
    (1, false, 0x400, 641),
    (1, false, 0x401, 885),
    (1, false, 0x402, 725),
    (1, false, 0x403, 574),
    (1, false, 0x404, 739),
    (1, false, 0x405, 47),
    (1, false, 0x406, 166),
    (1, false, 0x407, 800),
    (1, false, 0x408, 210),
    (1, false, 0x409, 907),
    (1, false, 0x40b, 727),
    (1, false, 0x40c, 864),
    (1, false, 0x40d, 895),
    (1, false, 0x40e, 893),
    (1, false, 0x40f, 364),
    (1, false, 0x410, 167),
    (1, false, 0x411, 621),
    (1, false, 0x412, 578),
    (1, false, 0x413, 413),
    (1, false, 0x414, 647),
    (1, false, 0x415, 590),
    (1, false, 0x416, 370),
    (1, false, 0x417, 106),
    (1, false, 0x418, 652),
    (1, false, 0x419, 175),
    (1, false, 0x41a, 613),
    (1, false, 0x41b, 481),
    (1, false, 0x41c, 480),
    (1, false, 0x41d, 54),
    (1, false, 0x41e, 196),
    (1, false, 0x41f, 434),
    (1, false, 0x420, 756),
    (1, false, 0x421, 144),
    (1, false, 0x422, 248),
    (1, false, 0x423, 240),
    (1, false, 0x424, 131),
    (1, false, 0x425, 617),
    (1, false, 0x426, 467),
    (1, false, 0x427, 787),
    (1, false, 0x428, 475),
    (1, false, 0x429, 448),
    (1, false, 0x42a, 510),
    (1, false, 0x42b, 423),
    (1, false, 0x42c, 639),
    (1, false, 0x42d, 700),
    (1, false, 0x42e, 938),
    (1, false, 0x42f, 943),
    (1, false, 0x430, 457),
    (1, false, 0x40000001, 633),
    (1, false, 0x40000002, 421),
    (1, false, 0x40000003, 619),
    (1, false, 0x40000004, 128),
    (1, false, 0x40000005, 197),
    (1, false, 0x40000006, 252),
    (1, false, 0x40000007, 356),
    (1, false, 0x40000008, 158),
    (1, false, 0x40000009, 311),
    (1, false, 0x4000000a, 404),
    (1, false, 0x4000000b, 930),
    (1, false, 0x4000000c, 463),
    (1, false, 0x4000000d, 799),
    (1, false, 0x4000000e, 677),
    (1, false, 0x4000000f, 635),
    (1, false, 0x40000011, 884),
    (1, false, 0x40000012, 594),
    (1, false, 0x40000032, 837),
    (1, false, 0x40000035, 722),
    (1, false, 0x800bb804, 663),
    (1, false, 0x800c1b00, 109),
    (1, false, 0x800fa001, 872),
    (1, false, 0x800fa002, 878),
    (1, false, 0x800fa003, 875),
    (1, false, 0x800fa005, 876),
    (1, false, 0x800fa006, 874),
    (1, false, 0x80138801, 366),
    (1, false, 0x80138802, 367),
    (1, false, 0x80138803, 303),
    (1, false, 0x80138804, 327),
    (1, false, 0x80138805, 336),
    (1, false, 0x80138808, 807),
    (1, false, 0x80177001, 188),
    (1, false, 0x80177002, 883),
    (1, false, 0x80177004, 379),
    (1, false, 0x80177005, 577),
    (1, false, 0x80177006, 191),
    (1, false, 0x80177007, 897),
    (1, false, 0x80177009, 249),
    (1, false, 0x801b5801, 322),
    (1, false, 0x801b5802, 561),
    (1, false, 0x801f4001, 332),
    (1, false, 0x801f4002, 335),
    (1, false, 0x801f4003, 329),
    (1, false, 0x801f4004, 323),
    (1, false, 0x801f4005, 338),
    (1, false, 0x801f4006, 328),
    (1, false, 0x80232801, 870),
    (1, false, 0x80232802, 512),
    (1, false, 0x80232803, 466),
    (1, false, 0x80232804, 555),
    (1, false, 0x80232805, 863),
    (1, false, 0x80232806, 539),
    (1, false, 0x80232807, 65),
    (1, false, 0x80232808, 337),
    (1, false, 0x80232809, 919),
    (1, false, 0x802af801, 629),
    (1, false, 0x8032c804, 143),
    (1, false, 0x8036b000, 286),
    (1, true, 0x1, 62),
    (1, true, 0x2, 116),
    (1, true, 0x3, 176),
    (1, true, 0x4, 306),
    (1, true, 0x5, 377),
    (1, true, 0x6, 381),
    (1, true, 0x7, 399),
    (1, true, 0x8, 408),
    (1, true, 0x9, 409),
    (1, true, 0xa, 492),
    (1, true, 0xb, 520),
    (1, true, 0xc, 521),
    (1, true, 0xd, 522),
    (1, true, 0xe, 546),
    (1, true, 0xf, 547),
    (1, true, 0x10, 548),
    (1, true, 0x11, 586),
    (1, true, 0x12, 606),
    (1, true, 0x13, 624),
    (1, true, 0x14, 642),
    (1, true, 0x15, 643),
    (1, true, 0x16, 644),
    (1, true, 0x17, 683),
    (1, true, 0x18, 720),
    (1, true, 0x19, 746),
    (1, true, 0x1a, 788),
    (1, true, 0x1b, 848),
    (1, true, 0x1c, 867),
    (1, true, 0x1d, 896),
    (1, true, 0x1e, 918),
    (1, true, 0x1f, 954),
    (1, true, 0x20, 957),
    (1, true, 0x21, 960),
    (1, true, 0x22, 961),
    (1, true, 0x23, 969),
    (1, true, 0x24, 971),
    (1, true, 0x25, 972),
    (1, true, 0x26, 973),
    (1, true, 0x27, 980),
    (1, true, 0x28, 983),
    (1, true, 0x29, 985),
    (1, true, 0x2a, 986),
    (1, true, 0x2b, 14),
    (1, true, 0x2c, 15),
    (1, true, 0x2d, 16),
    (1, true, 0x2e, 374),
    (1, true, 0x2f, 785),
    (1, true, 0x30, 360),
    (1, true, 0x31, 576),
    (1, true, 0x32, 566),
    (1, true, 0x33, 29),
    (1, true, 0x34, 400),
    (1, true, 0x35, 536),
    (1, true, 0x36, 740),
    (1, true, 0x37, 504),
    (1, true, 0x38, 493),
    (1, true, 0x39, 814),
    (1, true, 0x3a, 257),
    (1, true, 0x3b, 113),
    (1, true, 0x3c, 146),
    (1, true, 0x3d, 483),
    (1, true, 0x3e, 352),
    (1, true, 0x3f, 447),
    (1, true, 0x40, 161),
    (1, true, 0x41, 212),
    (1, true, 0x42, 363),
    (1, true, 0x43, 342),
    (1, true, 0x44, 728),
    (1, true, 0x45, 882),
    (1, true, 0x46, 592),
    (1, true, 0x47, 564),
    (1, true, 0x48, 560),
    (1, true, 0x49, 386),
    (1, true, 0x4a, 387),
    (1, true, 0x4b, 129),
    (1, true, 0x4c, 422),
    (1, true, 0x4d, 582),
    (1, true, 0x4e, 732),
    (1, true, 0x4f, 473),
    (1, true, 0x50, 906),
    (1, true, 0x51, 269),
    (1, true, 0x52, 87),
    (1, true, 0x53, 93),
    (1, true, 0x54, 951),
    (1, true, 0x55, 965),
    (1, true, 0x56, 975),
    (1, true, 0x57, 541),
    (1, true, 0x58, 64),
    (1, true, 0x59, 291),
    (1, true, 0x5a, 494),
    (1, true, 0x5b, 851),
    (1, true, 0x5c, 817),
    (1, true, 0x5d, 458),
    (1, true, 0x5e, 774),
    (1, true, 0x5f, 420),
    (1, true, 0x60, 469),
    (1, true, 0x61, 716),
    (1, true, 0x62, 911),
    (1, true, 0x63, 530),
    (1, true, 0x64, 418),
    (1, true, 0x65, 300),
    (1, true, 0x66, 910),
    (1, true, 0x67, 670),
    (1, true, 0x68, 668),
    (1, true, 0x69, 802),
    (1, true, 0x6a, 735),
    (1, true, 0x6b, 862),
    (1, true, 0x6c, 963),
    (1, true, 0x6d, 846),
    (1, true, 0x6e, 900),
    (1, true, 0x6f, 540),
    (1, true, 0x70, 921),
    (1, true, 0x71, 238),
    (1, true, 0x72, 437),
    (1, true, 0x73, 765),
    (1, true, 0x74, 952),
    (1, true, 0x75, 966),
    (1, true, 0x76, 976),
    (1, true, 0x77, 513),
    (1, true, 0x78, 962),
    (1, true, 0x79, 974),
    (1, true, 0x7a, 987),
    (1, true, 0x7b, 794),
    (1, true, 0x7c, 200),
    (1, true, 0x7d, 237),
    (1, true, 0x7e, 183),
    (1, true, 0x7f, 231),
    (1, true, 0x80, 600),
    (1, true, 0x81, 749),
    (1, true, 0x82, 82),
    (1, true, 0x83, 696),
    (1, true, 0x84, 340),
    (1, true, 0x85, 85),
    (1, true, 0x86, 373),
    (1, true, 0x87, 429),
    (1, true, 0x88, 482),
    (1, true, 0x89, 199),
    (1, true, 0x8a, 126),
    (1, true, 0x8b, 154),
    (1, true, 0x8c, 18),
    (1, true, 0x8d, 76),
    (1, true, 0x8e, 110),
    (1, true, 0x8f, 890),
    (1, true, 0x90, 571),
    (1, true, 0x91, 688),
    (1, true, 0x92, 664),
    (1, true, 0x93, 687),
    (1, true, 0x94, 304),
    (1, true, 0x95, 695),
    (1, true, 0x96, 738),
    (1, true, 0x97, 486),
    (1, true, 0x98, 865),
    (1, true, 0x99, 213),
    (1, true, 0x9a, 898),
    (1, true, 0x9b, 762),
    (1, true, 0x9c, 761),
    (1, true, 0x9e, 459),
    (1, true, 0x9f, 26),
    (1, true, 0xa0, 189),
    (1, true, 0xa1, 543),
    (1, true, 0xa2, 524),
    (1, true, 0xa3, 244),
    (1, true, 0xa4, 80),
    (1, true, 0xa5, 77),
    (1, true, 0xa6, 589),
    (1, true, 0xa7, 694),
    (1, true, 0xa8, 849),
    (1, true, 0xa9, 105),
    (1, true, 0xaa, 534),
    (1, true, 0xab, 497),
    (1, true, 0xac, 498),
    (1, true, 0xad, 476),
    (1, true, 0xae, 471),
    (1, true, 0xaf, 801),
    (1, true, 0xb0, 37),
    (1, true, 0xb1, 978),
    (1, true, 0xb2, 533),
    (1, true, 0xb3, 472),
    (1, true, 0xb4, 308),
    (1, true, 0xb5, 542),
    (1, true, 0xb6, 42),
    (1, true, 0xb8, 712),
    (1, true, 0xb9, 978),
    (1, true, 0xba, 563),
    (1, true, 0xbb, 69),
    (1, true, 0xbd, 55),
    (1, true, 0x18c, 744),
    (1, true, 0x18e, 743),
    (2, false, 0x1, 256),
    (2, false, 0x2, 821),
    (2, false, 0x3, 570),
    (2, false, 0x5, 689),
    (2, false, 0x6, 833),
    (2, false, 0x7, 714),
    (2, false, 0xa, 920),
    (2, false, 0xf, 710),
    (2, false, 0x10, 97),
    (2, false, 0x11, 331),
    (2, false, 0x80, 600),
    (2, false, 0x81, 602),
    (2, false, 0x82, 601),
    (2, false, 0x25c, 930),
    (2, false, 0x2db, 883),
    (2, false, 0x2f9, 658),
    (2, false, 0x323, 188),
    (2, false, 0x332, 759),
    (2, false, 0x338, 102),
    (2, false, 0x349, 919),
    (2, false, 0x3e9, 623),
    (2, false, 0x3ea, 345),
    (2, false, 0x3eb, 502),
    (2, false, 0x3ec, 137),
    (2, false, 0x3ed, 880),
    (2, false, 0x3ee, 719),
    (2, false, 0x3ef, 190),
    (2, false, 0x3f0, 717),
    (2, false, 0x3f1, 273),
    (2, false, 0x3f2, 220),
    (2, false, 0x3f3, 27),
    (2, false, 0x3f4, 569),
    (2, false, 0x3f5, 407),
    (2, false, 0x3f6, 645),
    (2, false, 0x3f7, 454),
    (2, false, 0x3f8, 478),
    (2, false, 0x3f9, 615),
    (2, false, 0x3fa, 913),
    (2, false, 0x3fb, 758),
    (2, false, 0x3fc, 372),
    (2, false, 0x3fd, 228),
    (2, false, 0x3fe, 66),
    (2, false, 0x3ff, 121),
    (2, false, 0x400, 641),
    (2, false, 0x401, 885),
    (2, false, 0x402, 725),
    (2, false, 0x403, 574),
    (2, false, 0x404, 739),
    (2, false, 0x405, 47),
    (2, false, 0x406, 166),
    (2, false, 0x407, 800),
    (2, false, 0x408, 210),
    (2, false, 0x409, 907),
    (2, false, 0x40a, 639),
    (2, false, 0x40b, 727),
    (2, false, 0x40c, 864),
    (2, false, 0x40d, 895),
    (2, false, 0x40e, 893),
    (2, false, 0x40f, 365),
    (2, false, 0x410, 167),
    (2, false, 0x411, 621),
    (2, false, 0x413, 413),
    (2, false, 0x414, 647),
    (2, false, 0x415, 590),
    (2, false, 0x416, 370),
    (2, false, 0x417, 891),
    (2, false, 0x418, 652),
    (2, false, 0x419, 175),
    (2, false, 0x41a, 613),
    (2, false, 0x41b, 481),
    (2, false, 0x41c, 480),
    (2, false, 0x41d, 886),
    (2, false, 0x41e, 196),
    (2, false, 0x41f, 434),
    (2, false, 0x420, 756),
    (2, false, 0x421, 144),
    (2, false, 0x423, 240),
    (2, false, 0x424, 131),
    (2, false, 0x425, 617),
    (2, false, 0x426, 467),
    (2, false, 0x427, 787),
    (2, false, 0x428, 379),
    (2, false, 0x42a, 726),
    (2, false, 0x42b, 423),
    (2, false, 0x42c, 649),
    (2, false, 0x42f, 156),
    (2, false, 0x430, 638),
    (2, false, 0x431, 126),
    (2, false, 0x432, 757),
    (2, false, 0x433, 433),
    (2, false, 0x434, 28),
    (2, false, 0x435, 511),
    (2, false, 0x436, 419),
    (2, false, 0x437, 871),
    (2, false, 0x438, 577),
    (2, false, 0x439, 655),
    (2, false, 0x43a, 527),
    (2, false, 0x43b, 708),
    (2, false, 0x43c, 955),
    (2, false, 0x43d, 793),
    (2, false, 0x43e, 650),
    (2, false, 0x43f, 760),
    (2, false, 0x440, 630),
    (2, false, 0x441, 678),
    (2, false, 0x445, 922),
    (2, false, 0x446, 926),
    (2, false, 0x447, 868),
    (2, false, 0x449, 226),
    (2, false, 0x44a, 392),
    (2, false, 0x44b, 501),
    (2, false, 0x44d, 427),
    (2, false, 0x44e, 653),
    (2, false, 0x44f, 264),
    (2, false, 0x450, 654),
    (2, false, 0x451, 512),
    (2, false, 0x452, 297),
    (2, false, 0x453, 665),
    (2, false, 0x454, 359),
    (2, false, 0x455, 637),
    (2, false, 0x456, 702),
    (2, false, 0x4a6, 510),
    (2, false, 0x4af, 38),
    (2, true, 0x1, 62),
    (2, true, 0x2, 116),
    (2, true, 0x3, 176),
    (2, true, 0x6, 381),
    (2, true, 0x7, 399),
    (2, true, 0x8, 408),
    (2, true, 0x9, 409),
    (2, true, 0xa, 492),
    (2, true, 0xb, 520),
    (2, true, 0xc, 521),
    (2, true, 0xd, 522),
    (2, true, 0xe, 546),
    (2, true, 0xf, 547),
    (2, true, 0x10, 548),
    (2, true, 0x12, 606),
    (2, true, 0x13, 624),
    (2, true, 0x14, 642),
    (2, true, 0x15, 643),
    (2, true, 0x16, 644),
    (2, true, 0x17, 683),
    (2, true, 0x18, 720),
    (2, true, 0x19, 746),
    (2, true, 0x1a, 788),
    (2, true, 0x1b, 848),
    (2, true, 0x1c, 867),
    (2, true, 0x1d, 896),
    (2, true, 0x1e, 918),
    (2, true, 0x1f, 954),
    (2, true, 0x20, 957),
    (2, true, 0x21, 960),
    (2, true, 0x22, 961),
    (2, true, 0x23, 969),
    (2, true, 0x24, 971),
    (2, true, 0x25, 972),
    (2, true, 0x26, 973),
    (2, true, 0x27, 980),
    (2, true, 0x28, 983),
    (2, true, 0x29, 985),
    (2, true, 0x2a, 986),
    (2, true, 0x2d, 964),
    (2, true, 0x2f, 785),
    (2, true, 0x30, 360),
    (2, true, 0x31, 576),
    (2, true, 0x33, 29),
    (2, true, 0x34, 400),
    (2, true, 0x35, 536),
    (2, true, 0x36, 740),
    (2, true, 0x37, 504),
    (2, true, 0x38, 493),
    (2, true, 0x39, 814),
    (2, true, 0x3b, 113),
    (2, true, 0x3c, 146),
    (2, true, 0x3d, 483),
    (2, true, 0x3e, 352),
    (2, true, 0x3f, 447),
    (2, true, 0x40, 161),
    (2, true, 0x41, 212),
    (2, true, 0x42, 363),
    (2, true, 0x43, 342),
    (2, true, 0x44, 728),
    (2, true, 0x45, 882),
    (2, true, 0x46, 592),
    (2, true, 0x47, 564),
    (2, true, 0x48, 560),
    (2, true, 0x49, 386),
    (2, true, 0x4a, 387),
    (2, true, 0x4b, 129),
    (2, true, 0x4c, 422),
    (2, true, 0x4d, 582),
    (2, true, 0x4e, 732),
    (2, true, 0x4f, 473),
    (2, true, 0x50, 906),
    (2, true, 0x51, 269),
    (2, true, 0x52, 87),
    (2, true, 0x53, 93),
    (2, true, 0x54, 951),
    (2, true, 0x55, 965),
    (2, true, 0x56, 975),
    (2, true, 0x58, 64),
    (2, true, 0x59, 291),
    (2, true, 0x5a, 494),
    (2, true, 0x5c, 817),
    (2, true, 0x5e, 774),
    (2, true, 0x5f, 420),
    (2, true, 0x60, 469),
    (2, true, 0x61, 716),
    (2, true, 0x62, 911),
    (2, true, 0x6b, 862),
    (2, true, 0x6c, 963),
    (2, true, 0x6e, 900),
    (2, true, 0x6f, 540),
    (2, true, 0x70, 921),
    (2, true, 0x71, 238),
    (2, true, 0x72, 437),
    (2, true, 0x73, 765),
    (2, true, 0x74, 952),
    (2, true, 0x75, 966),
    (2, true, 0x76, 976),
    (2, true, 0x7b, 794),
    (2, true, 0x7c, 200),
    (2, true, 0x7d, 237),
    (2, true, 0x7e, 183),
    (2, true, 0x7f, 231),
    (2, true, 0x80, 600),
    (2, true, 0x84, 72),
    (2, true, 0x86, 373),
    (2, true, 0x8b, 154),
    (2, true, 0x8c, 18),
    (2, true, 0x8d, 76),
    (2, true, 0x8e, 110),
    (2, true, 0x8f, 890),
    (2, true, 0x90, 571),
    (2, true, 0x91, 688),
    (2, true, 0x94, 304),
    (2, true, 0x95, 695),
    (2, true, 0x96, 738),
    (2, true, 0x97, 486),
    (2, true, 0x98, 865),
    (2, true, 0x99, 213),
    (2, true, 0x9a, 898),
    (2, true, 0x9d, 354),
    (2, true, 0x9e, 459),
    (2, true, 0x9f, 26),
    (2, true, 0xa0, 189),
    (2, true, 0xa1, 543),
    (2, true, 0xa2, 524),
    (2, true, 0xa3, 244),
    (2, true, 0xa6, 523),
    (2, true, 0xa8, 849),
    (2, true, 0xaa, 978),
    (2, true, 0xac, 887),
    (2, true, 0xae, 279),
    (2, true, 0xb0, 563),
    (2, true, 0xb1, 838),
    (2, true, 0xb2, 783),
    (2, true, 0xb4, 21),
    (2, true, 0xb6, 42),
    (2, true, 0xb7, 687),
    (2, true, 0xb8, 712),
    (2, true, 0xbb, 69),
    (2, true, 0xbc, 222),
    (2, true, 0xbd, 55),
    (2, true, 0xbf, 83),
    (2, true, 0xc0, 768),
    (2, true, 0xc1, 285),
    (2, true, 0xc2, 532),
    (2, true, 0xc3, 150),
    (2, true, 0xc4, 782),
    (2, true, 0xc8, 488),
    (2, true, 0xc9, 487),
    (2, true, 0xcd, 224),
    (2, true, 0xcf, 74),
    (2, true, 0xd0, 216),
    (2, true, 0xd1, 88),
    (2, true, 0xd2, 89),
    (2, true, 0xd3, 90),
    (2, true, 0xd4, 91),
    (2, true, 0xd5, 92),
    (2, true, 0xd8, 215),
    (2, true, 0xd9, 276),
    (2, true, 0xda, 277),
    (2, true, 0xdb, 278),
    (2, true, 0xea, 595),
    (2, true, 0xeb, 834),
    (2, true, 0xed, 105),
    (2, true, 0xef, 581),
    (2, true, 0xf5, 111),
    (2, true, 0xf6, 573),
    (2, true, 0xf7, 866),
    (2, true, 0xf9, 771),
    (2, true, 0x100, 179),
    (2, true, 0x104, 589),
    (2, true, 0x106, 694),
    (2, true, 0x110, 798),
    (2, true, 0x113, 562),
    (2, true, 0x116, 241),
    (2, true, 0x117, 248),
    (2, true, 0x118, 690),
    (2, true, 0x119, 274),
    (2, true, 0x11f, 679),
    (2, true, 0x120, 98),
    (2, true, 0x127, 736),
    (2, true, 0x12d, 496),
    (2, true, 0x12e, 147),
    (2, true, 0x12f, 361),
    (2, true, 0x13b, 497),
    (2, true, 0x13c, 498),
    (2, true, 0x140, 729),
    (2, true, 0x141, 820),
    (2, true, 0x145, 565),
    (2, true, 0x14a, 819),
    (2, true, 0x14b, 122),
    (2, true, 0x154, 96),
    (2, true, 0x192, 281),
    (2, true, 0x1f4, 685),
    (2, true, 0x1f9, 792),
    (2, true, 0x1fe, 223),
    (2, true, 0x201, 458),
    (2, true, 0x240, 141),
    (2, true, 0x241, 509),
    (2, true, 0x262, 463),
    (2, true, 0x269, 884),
    (2, true, 0x273, 888),
    (2, true, 0x274, 802),
    (2, true, 0x277, 799),
    (2, true, 0x278, 158),
    (2, true, 0x28b, 307),
    (2, true, 0x298, 260),
    (2, true, 0x2bc, 401),
    (2, true, 0x2c1, 561),
    (2, true, 0x2d7, 377),
    (2, true, 0x2d8, 661),
    (2, true, 0x2d9, 245),
    (2, true, 0x2f1, 178),
    (2, true, 0x316, 355),
    (2, true, 0x324, 784),
    (2, true, 0x32c, 538),
    (2, true, 0x34b, 706),
    (2, true, 0x353, 773),
    (2, true, 0x356, 686),
    (2, true, 0x382, 290),
    (2, true, 0x3a6, 584),
    (2, true, 0x4b5, 730),
    (3, false, 0x2, 821),
    (3, false, 0x3, 570),
    (3, false, 0x5, 689),
    (3, false, 0x7, 714),
    (3, false, 0xa, 920),
    (3, false, 0xf, 710),
    (3, false, 0x10, 97),
    (3, false, 0x11, 331),
    (3, false, 0x80, 600),
    (3, false, 0x81, 602),
    (3, false, 0x82, 601),
    (3, false, 0x25b, 633),
    (3, false, 0x25c, 930),
    (3, false, 0x25d, 421),
    (3, false, 0x25e, 619),
    (3, false, 0x25f, 128),
    (3, false, 0x26c, 197),
    (3, false, 0x27c, 594),
    (3, false, 0x284, 699),
    (3, false, 0x285, 109),
    (3, false, 0x287, 984),
    (3, false, 0x295, 559),
    (3, false, 0x29a, 561),
    (3, false, 0x2bd, 303),
    (3, false, 0x2be, 322),
    (3, false, 0x2bf, 336),
    (3, false, 0x2c0, 329),
    (3, false, 0x2c1, 332),
    (3, false, 0x2c2, 335),
    (3, false, 0x2c3, 323),
    (3, false, 0x2c4, 338),
    (3, false, 0x2c5, 328),
    (3, false, 0x2c6, 327),
    (3, false, 0x2c7, 367),
    (3, false, 0x2c8, 366),
    (3, false, 0x2c9, 663),
    (3, false, 0x2cc, 191),
    (3, false, 0x2cd, 863),
    (3, false, 0x2ce, 875),
    (3, false, 0x2cf, 872),
    (3, false, 0x2d0, 878),
    (3, false, 0x2d1, 870),
    (3, false, 0x2d4, 876),
    (3, false, 0x2d5, 874),
    (3, false, 0x2d6, 539),
    (3, false, 0x2db, 883),
    (3, false, 0x2e0, 466),
    (3, false, 0x2e1, 555),
    (3, false, 0x2e2, 629),
    (3, false, 0x2e9, 65),
    (3, false, 0x2ef, 359),
    (3, false, 0x2f9, 658),
    (3, false, 0x321, 286),
    (3, false, 0x322, 233),
    (3, false, 0x323, 188),
    (3, false, 0x324, 835),
    (3, false, 0x325, 709),
    (3, false, 0x326, 455),
    (3, false, 0x327, 858),
    (3, false, 0x328, 446),
    (3, false, 0x329, 445),
    (3, false, 0x32a, 364),
    (3, false, 0x32b, 167),
    (3, false, 0x32c, 893),
    (3, false, 0x32d, 143),
    (3, false, 0x32e, 538),
    (3, false, 0x32f, 512),
    (3, false, 0x331, 653),
    (3, false, 0x332, 759),
    (3, false, 0x338, 102),
    (3, false, 0x339, 357),
    (3, false, 0x33a, 391),
    (3, false, 0x346, 337),
    (3, false, 0x347, 484),
    (3, false, 0x349, 919),
    (3, false, 0x34c, 234),
    (3, false, 0x34e, 164),
    (3, false, 0x359, 807),
    (3, false, 0x36c, 692),
    (3, false, 0x3a9, 264),
    (3, false, 0x3e9, 623),
    (3, false, 0x3ea, 345),
    (3, false, 0x3eb, 502),
    (3, false, 0x3ec, 137),
    (3, false, 0x3ed, 880),
    (3, false, 0x3ee, 719),
    (3, false, 0x3ef, 190),
    (3, false, 0x3f0, 717),
    (3, false, 0x3f1, 273),
    (3, false, 0x3f2, 220),
    (3, false, 0x3f3, 27),
    (3, false, 0x3f4, 569),
    (3, false, 0x3f5, 407),
    (3, false, 0x3f6, 645),
    (3, false, 0x3f7, 454),
    (3, false, 0x3f8, 478),
    (3, false, 0x3f9, 615),
    (3, false, 0x3fa, 913),
    (3, false, 0x3fb, 758),
    (3, false, 0x3fc, 372),
    (3, false, 0x3fd, 228),
    (3, false, 0x3fe, 66),
    (3, false, 0x3ff, 121),
    (3, false, 0x400, 641),
    (3, false, 0x401, 885),
    (3, false, 0x402, 725),
    (3, false, 0x403, 574),
    (3, false, 0x404, 739),
    (3, false, 0x405, 47),
    (3, false, 0x406, 166),
    (3, false, 0x407, 800),
    (3, false, 0x408, 210),
    (3, false, 0x409, 907),
    (3, false, 0x40b, 727),
    (3, false, 0x40c, 864),
    (3, false, 0x40d, 895),
    (3, false, 0x410, 412),
    (3, false, 0x411, 410),
    (3, false, 0x412, 578),
    (3, false, 0x413, 413),
    (3, false, 0x414, 647),
    (3, false, 0x415, 590),
    (3, false, 0x416, 370),
    (3, false, 0x418, 652),
    (3, false, 0x419, 175),
    (3, false, 0x41a, 613),
    (3, false, 0x41b, 625),
    (3, false, 0x41c, 480),
    (3, false, 0x41d, 886),
    (3, false, 0x41e, 196),
    (3, false, 0x41f, 434),
    (3, false, 0x420, 756),
    (3, false, 0x421, 144),
    (3, false, 0x423, 240),
    (3, false, 0x424, 131),
    (3, false, 0x425, 617),
    (3, false, 0x426, 467),
    (3, false, 0x427, 787),
    (3, false, 0x428, 379),
    (3, false, 0x429, 448),
    (3, false, 0x42a, 726),
    (3, false, 0x42b, 423),
    (3, false, 0x42c, 639),
    (3, false, 0x42d, 649),
    (3, false, 0x42f, 156),
    (3, false, 0x430, 638),
    (3, false, 0x431, 126),
    (3, false, 0x432, 757),
    (3, false, 0x433, 433),
    (3, false, 0x434, 28),
    (3, false, 0x435, 135),
    (3, false, 0x436, 419),
    (3, false, 0x438, 577),
    (3, false, 0x439, 655),
    (3, false, 0x43b, 708),
    (3, false, 0x43d, 793),
    (3, false, 0x43f, 760),
    (3, false, 0x440, 630),
    (3, false, 0x441, 678),
    (3, false, 0x442, 227),
    (3, false, 0x443, 705),
    (3, false, 0x444, 868),
    (3, false, 0x445, 922),
    (3, false, 0x446, 926),
    (3, false, 0x447, 932),
    (3, false, 0x448, 382),
    (3, false, 0x449, 226),
    (3, false, 0x44a, 392),
    (3, false, 0x44b, 501),
    (3, false, 0x44d, 572),
    (3, false, 0x44e, 612),
    (3, false, 0x44f, 673),
    (3, false, 0x450, 341),
    (3, true, 0x1, 62),
    (3, true, 0x5, 731),
    (3, true, 0x7, 691),
    (3, true, 0x8, 408),
    (3, true, 0x9, 409),
    (3, true, 0xa, 492),
    (3, true, 0xe, 546),
    (3, true, 0xf, 547),
    (3, true, 0x10, 548),
    (3, true, 0x13, 624),
    (3, true, 0x17, 683),
    (3, true, 0x18, 720),
    (3, true, 0x19, 746),
    (3, true, 0x1c, 867),
    (3, true, 0x1e, 918),
    (3, true, 0x21, 960),
    (3, true, 0x22, 222),
    (3, true, 0x25, 972),
    (3, true, 0x26, 859),
    (3, true, 0x27, 542),
    (3, true, 0x29, 985),
    (3, true, 0x2d, 964),
    (3, true, 0x32, 566),
    (3, true, 0x34, 400),
    (3, true, 0x35, 536),
    (3, true, 0x39, 814),
    (3, true, 0x3a, 78),
    (3, true, 0x3b, 113),
    (3, true, 0x3c, 146),
    (3, true, 0x3d, 483),
    (3, true, 0x3e, 352),
    (3, true, 0x3f, 447),
    (3, true, 0x41, 212),
    (3, true, 0x42, 363),
    (3, true, 0x43, 342),
    (3, true, 0x44, 728),
    (3, true, 0x47, 564),
    (3, true, 0x48, 560),
    (3, true, 0x49, 386),
    (3, true, 0x4a, 387),
    (3, true, 0x4b, 129),
    (3, true, 0x4c, 422),
    (3, true, 0x4d, 582),
    (3, true, 0x4e, 732),
    (3, true, 0x4f, 473),
    (3, true, 0x50, 906),
    (3, true, 0x51, 269),
    (3, true, 0x52, 87),
    (3, true, 0x53, 93),
    (3, true, 0x54, 951),
    (3, true, 0x55, 965),
    (3, true, 0x56, 975),
    (3, true, 0x58, 64),
    (3, true, 0x59, 291),
    (3, true, 0x5a, 494),
    (3, true, 0x5c, 817),
    (3, true, 0x5d, 458),
    (3, true, 0x5e, 774),
    (3, true, 0x5f, 420),
    (3, true, 0x60, 469),
    (3, true, 0x61, 716),
    (3, true, 0x62, 911),
    (3, true, 0x63, 959),
    (3, true, 0x6b, 862),
    (3, true, 0x6e, 900),
    (3, true, 0x6f, 832),
    (3, true, 0x70, 921),
    (3, true, 0x71, 238),
    (3, true, 0x72, 437),
    (3, true, 0x73, 765),
    (3, true, 0x74, 952),
    (3, true, 0x75, 966),
    (3, true, 0x76, 976),
    (3, true, 0x77, 179),
    (3, true, 0x7b, 794),
    (3, true, 0x7c, 200),
    (3, true, 0x7d, 237),
    (3, true, 0x7e, 183),
    (3, true, 0x7f, 231),
    (3, true, 0x80, 600),
    (3, true, 0x81, 671),
    (3, true, 0x82, 597),
    (3, true, 0x83, 424),
    (3, true, 0x84, 72),
    (3, true, 0x86, 373),
    (3, true, 0x8b, 154),
    (3, true, 0x8c, 18),
    (3, true, 0x8d, 76),
    (3, true, 0x8e, 110),
    (3, true, 0x8f, 890),
    (3, true, 0x90, 571),
    (3, true, 0x91, 688),
    (3, true, 0x94, 304),
    (3, true, 0x95, 695),
    (3, true, 0x96, 738),
    (3, true, 0x97, 486),
    (3, true, 0x98, 865),
    (3, true, 0x99, 213),
    (3, true, 0x9a, 898),
    (3, true, 0x9d, 354),
    (3, true, 0x9e, 459),
    (3, true, 0x9f, 26),
    (3, true, 0xa0, 189),
    (3, true, 0xa1, 543),
    (3, true, 0xa2, 524),
    (3, true, 0xa3, 244),
    (3, true, 0xa6, 523),
    (3, true, 0xa8, 849),
    (3, true, 0xaa, 978),
    (3, true, 0xac, 563),
    (3, true, 0xaf, 887),
    (3, true, 0xb1, 838),
    (3, true, 0xb4, 21),
    (3, true, 0xb6, 42),
    (3, true, 0xb7, 770),
    (3, true, 0xbd, 55),
    (3, true, 0xbf, 83),
    (3, true, 0xc0, 768),
    (3, true, 0xc1, 285),
    (3, true, 0xc3, 150),
    (3, true, 0xc4, 782),
    (3, true, 0xc5, 248),
    (3, true, 0xc8, 488),
    (3, true, 0xc9, 487),
    (3, true, 0xcd, 224),
    (3, true, 0xce, 294),
    (3, true, 0xcf, 786),
    (3, true, 0xd0, 216),
    (3, true, 0xd3, 90),
    (3, true, 0xd4, 91),
    (3, true, 0xd5, 92),
    (3, true, 0xd8, 215),
    (3, true, 0xdb, 278),
    (3, true, 0xed, 105),
    (3, true, 0xef, 581),
    (3, true, 0xf5, 111),
    (3, true, 0xf6, 573),
    (3, true, 0xf9, 771),
    (3, true, 0x104, 589),
    (3, true, 0x106, 694),
    (3, true, 0x113, 562),
    (3, true, 0x116, 241),
    (3, true, 0x117, 368),
    (3, true, 0x118, 690),
    (3, true, 0x119, 274),
    (3, true, 0x11f, 679),
    (3, true, 0x127, 736),
    (3, true, 0x128, 496),
    (3, true, 0x12f, 361),
    (3, true, 0x13b, 497),
    (3, true, 0x13c, 498),
    (3, true, 0x140, 729),
    (3, true, 0x141, 820),
    (3, true, 0x142, 715),
    (3, true, 0x143, 287),
    (3, true, 0x144, 262),
    (3, true, 0x145, 565),
    (3, true, 0x146, 687),
    (3, true, 0x147, 69),
    (3, true, 0x148, 161),
    (3, true, 0x149, 712),
    (3, true, 0x14a, 819),
    (3, true, 0x14b, 122),
    (3, true, 0x154, 96),
    (3, true, 0x155, 25),
    (3, true, 0x156, 397),
    (3, true, 0x157, 152),
    (3, true, 0x192, 281),
    (3, true, 0x1f3, 256),
    (3, true, 0x1f4, 685),
    (3, true, 0x1f9, 792),
    (3, true, 0x1fe, 223),
    (3, true, 0x225, 937),
    (3, true, 0x226, 267),
    (3, true, 0x227, 442),
    (3, true, 0x228, 20),
    (3, true, 0x229, 61),
    (3, true, 0x22a, 844),
    (3, true, 0x22b, 803),
    (3, true, 0x22c, 171),
    (3, true, 0x22d, 778),
    (3, true, 0x22e, 53),
    (3, true, 0x22f, 35),
    (3, true, 0x230, 432),
    (3, true, 0x231, 236),
    (3, true, 0x232, 24),
    (3, true, 0x233, 554),
    (3, true, 0x234, 376),
    (3, true, 0x235, 59),
    (3, true, 0x236, 108),
    (3, true, 0x237, 529),
    (3, true, 0x238, 441),
    (3, true, 0x239, 112),
    (3, true, 0x23a, 464),
    (3, true, 0x23b, 489),
    (3, true, 0x23c, 775),
    (3, true, 0x23d, 284),
    (3, true, 0x23e, 721),
    (3, true, 0x23f, 230),
    (3, true, 0x240, 141),
    (3, true, 0x241, 509),
    (3, true, 0x242, 767),
    (3, true, 0x243, 351),
    (3, true, 0x244, 829),
    (3, true, 0x245, 822),
    (3, true, 0x246, 741),
    (3, true, 0x247, 711),
    (3, true, 0x248, 462),
    (3, true, 0x249, 856),
    (3, true, 0x259, 745),
    (3, true, 0x25a, 769),
    (3, true, 0x25b, 667),
    (3, true, 0x25c, 929),
    (3, true, 0x25d, 415),
    (3, true, 0x25e, 616),
    (3, true, 0x25f, 127),
    (3, true, 0x260, 187),
    (3, true, 0x261, 830),
    (3, true, 0x262, 463),
    (3, true, 0x263, 159),
    (3, true, 0x264, 157),
    (3, true, 0x265, 628),
    (3, true, 0x266, 552),
    (3, true, 0x267, 551),
    (3, true, 0x268, 36),
    (3, true, 0x269, 884),
    (3, true, 0x26a, 211),
    (3, true, 0x26b, 808),
    (3, true, 0x270, 94),
    (3, true, 0x273, 888),
    (3, true, 0x274, 802),
    (3, true, 0x275, 785),
    (3, true, 0x276, 606),
    (3, true, 0x277, 799),
    (3, true, 0x278, 158),
    (3, true, 0x279, 268),
    (3, true, 0x27a, 116),
    (3, true, 0x27c, 626),
    (3, true, 0x27d, 586),
    (3, true, 0x27e, 954),
    (3, true, 0x27f, 969),
    (3, true, 0x280, 980),
    (3, true, 0x281, 957),
    (3, true, 0x282, 971),
    (3, true, 0x283, 983),
    (3, true, 0x284, 733),
    (3, true, 0x285, 101),
    (3, true, 0x286, 848),
    (3, true, 0x289, 896),
    (3, true, 0x28a, 857),
    (3, true, 0x28b, 307),
    (3, true, 0x28c, 360),
    (3, true, 0x28d, 576),
    (3, true, 0x28e, 642),
    (3, true, 0x28f, 643),
    (3, true, 0x290, 644),
    (3, true, 0x291, 520),
    (3, true, 0x292, 521),
    (3, true, 0x293, 522),
    (3, true, 0x294, 850),
    (3, true, 0x295, 557),
    (3, true, 0x296, 399),
    (3, true, 0x297, 788),
    (3, true, 0x298, 260),
    (3, true, 0x299, 825),
    (3, true, 0x29b, 500),
    (3, true, 0x29c, 505),
    (3, true, 0x29d, 123),
    (3, true, 0x2bc, 401),
    (3, true, 0x2bf, 343),
    (3, true, 0x2c0, 318),
    (3, true, 0x2c1, 320),
    (3, true, 0x2c2, 339),
    (3, true, 0x2c3, 309),
    (3, true, 0x2c6, 312),
    (3, true, 0x2c7, 390),
    (3, true, 0x2c8, 385),
    (3, true, 0x2ca, 882),
    (3, true, 0x2cb, 592),
    (3, true, 0x2cc, 184),
    (3, true, 0x2cd, 860),
    (3, true, 0x2ce, 881),
    (3, true, 0x2cf, 869),
    (3, true, 0x2d0, 892),
    (3, true, 0x2d1, 836),
    (3, true, 0x2d3, 271),
    (3, true, 0x2d7, 377),
    (3, true, 0x2d8, 661),
    (3, true, 0x2d9, 664),
    (3, true, 0x2da, 740),
    (3, true, 0x2dc, 504),
    (3, true, 0x2dd, 961),
    (3, true, 0x2de, 973),
    (3, true, 0x2df, 986),
    (3, true, 0x2e3, 750),
    (3, true, 0x2e4, 772),
    (3, true, 0x2e5, 465),
    (3, true, 0x2e6, 263),
    (3, true, 0x2e7, 314),
    (3, true, 0x2e8, 362),
    (3, true, 0x2ea, 632),
    (3, true, 0x2eb, 631),
    (3, true, 0x2ec, 295),
    (3, true, 0x2ed, 634),
    (3, true, 0x2ee, 723),
    (3, true, 0x2f0, 375),
    (3, true, 0x2f1, 178),
    (3, true, 0x2f2, 347),
    (3, true, 0x2f3, 591),
    (3, true, 0x2f4, 791),
    (3, true, 0x2f5, 388),
    (3, true, 0x2f6, 378),
    (3, true, 0x2f7, 414),
    (3, true, 0x2f8, 981),
    (3, true, 0x2fa, 662),
    (3, true, 0x2fb, 603),
    (3, true, 0x2fc, 935),
    (3, true, 0x2fd, 936),
    (3, true, 0x316, 355),
    (3, true, 0x322, 207),
    (3, true, 0x32c, 852),
    (3, true, 0x330, 29),
    (3, true, 0x333, 176),
    (3, true, 0x334, 540),
    (3, true, 0x335, 493),
    (3, true, 0x336, 381),
    (3, true, 0x337, 139),
    (3, true, 0x33b, 317),
    (3, true, 0x33c, 674),
    (3, true, 0x33d, 205),
    (3, true, 0x33e, 22),
    (3, true, 0x33f, 142),
    (3, true, 0x340, 51),
    (3, true, 0x341, 585),
    (3, true, 0x342, 288),
    (3, true, 0x343, 315),
    (3, true, 0x344, 507),
    (3, true, 0x345, 680),
    (3, true, 0x348, 697),
    (3, true, 0x34a, 894),
    (3, true, 0x34b, 706),
    (3, true, 0x34d, 917),
    (3, true, 0x34f, 435),
    (3, true, 0x350, 742),
    (3, true, 0x351, 298),
    (3, true, 0x352, 443),
    (3, true, 0x353, 773),
    (3, true, 0x354, 940),
    (3, true, 0x355, 544),
    (3, true, 0x356, 686),
    (3, true, 0x357, 349),
    (3, true, 0x358, 163),
    (3, true, 0x359, 666),
    (3, true, 0x35a, 204),
    (3, true, 0x35b, 181),
    (3, true, 0x35c, 250),
    (3, true, 0x35d, 718),
    (3, true, 0x35e, 914),
    (3, true, 0x35f, 426),
    (3, true, 0x360, 815),
    (3, true, 0x361, 344),
    (3, true, 0x362, 519),
    (3, true, 0x363, 103),
    (3, true, 0x364, 75),
    (3, true, 0x365, 707),
    (3, true, 0x366, 470),
    (3, true, 0x367, 444),
    (3, true, 0x368, 283),
    (3, true, 0x369, 330),
    (3, true, 0x36a, 31),
    (3, true, 0x36b, 806),
    (3, true, 0x36d, 834),
    (3, true, 0x36e, 618),
    (3, true, 0x36f, 63),
    (3, true, 0x378, 659),
    (3, true, 0x379, 949),
    (3, true, 0x37a, 545),
    (3, true, 0x37b, 485),
    (3, true, 0x37c, 941),
    (3, true, 0x37d, 682),
    (3, true, 0x382, 290),
    (3, true, 0x383, 218),
    (3, true, 0x384, 155),
    (3, true, 0x385, 425),
    (3, true, 0x386, 402),
    (3, true, 0x387, 217),
    (3, true, 0x388, 82),
    (3, true, 0x389, 945),
    (3, true, 0x38a, 85),
    (3, true, 0x38b, 696),
    (3, true, 0x38c, 340),
    (3, true, 0x38d, 456),
    (3, true, 0x38e, 967),
    (3, true, 0x38f, 195),
    (3, true, 0x390, 99),
    (3, true, 0x391, 452),
    (3, true, 0x392, 451),
    (3, true, 0x393, 752),
    (3, true, 0x394, 609),
    (3, true, 0x395, 202),
    (3, true, 0x396, 201),
    (3, true, 0x397, 203),
    (3, true, 0x398, 816),
    (3, true, 0x399, 346),
    (3, true, 0x39a, 265),
    (3, true, 0x39b, 931),
    (3, true, 0x39c, 698),
    (3, true, 0x39d, 48),
    (3, true, 0x39e, 779),
    (3, true, 0x39f, 812),
    (3, true, 0x3a0, 299),
    (3, true, 0x3a1, 289),
    (3, true, 0x3a2, 781),
    (3, true, 0x3a3, 516),
    (3, true, 0x3a4, 86),
    (3, true, 0x3a5, 515),
    (3, true, 0x3a6, 584),
    (3, true, 0x3a7, 660),
    (3, true, 0x3a8, 396),
    (3, true, 0x3aa, 861),
    (3, true, 0x3ab, 255),
    (3, true, 0x3ac, 254),
    (3, true, 0x3ad, 258),
    (3, true, 0x3ae, 153),
    (3, true, 0x3af, 403),
    (3, true, 0x3b0, 796),
    (3, true, 0x3b1, 823),
    (3, true, 0x3b2, 824),
    (3, true, 0x3b3, 296),
    (3, true, 0x3b4, 826),
    (3, true, 0x3b5, 140),
    (3, true, 0x3b6, 282),
    (3, true, 0x3b7, 30),
    (3, true, 0x3b8, 460),
    (3, true, 0x3b9, 813),
    (3, true, 0x3ba, 901),
    (3, true, 0x3bb, 805),
    (3, true, 0x3bc, 225),
    (3, true, 0x3bd, 206),
    (3, true, 0x3be, 449),
    (3, true, 0x3bf, 185),
    (3, true, 0x3c0, 461),
    (3, true, 0x3c1, 118),
    (3, true, 0x3c2, 933),
    (3, true, 0x3c4, 491),
    (3, true, 0x4b5, 730),
    (4, false, 0xb, 602),
    (4, false, 0xc, 601),
    (4, false, 0xe, 331),
    (4, false, 0x11, 97),
    (4, false, 0x18, 639),
    (4, false, 0x40a, 757),
    (4, false, 0x431, 423),
    (4, false, 0x432, 433),
    (4, false, 0x434, 726),
    (4, false, 0x437, 156),
    (4, true, 0x57, 42),
    (4, true, 0x8f, 685),
    (4, true, 0xa7, 694),
    (4, true, 0xa9, 105),
    (4, true, 0xab, 712),
    (4, true, 0xaf, 248),
    (4, true, 0xb0, 342),
    (4, true, 0xb5, 497),
    (4, true, 0xb6, 498),
    (4, true, 0xb8, 215),
    (4, true, 0xb9, 216),
    (4, true, 0xba, 488),
    (4, true, 0xbb, 69),
    (4, true, 0xbc, 200),
    (4, true, 0xbd, 794),
    (4, true, 0xc1, 241),
    (4, true, 0xc7, 573),
    (4, true, 0xcf, 111),
    (4, true, 0xd2, 274),
    (4, true, 0xd3, 690),
    (4, true, 0xd4, 91),
    (4, true, 0xd5, 92),
    (4, true, 0xd8, 581),
    (4, true, 0xe0, 838),
    (4, true, 0xe2, 884),
    (4, true, 0xef, 281),
    (4, true, 0xf7, 729),
    (4, true, 0x117, 562),
    (4, true, 0x127, 150),
    (4, true, 0x128, 285),
    (4, true, 0x12e, 361),
    (4, true, 0x12f, 223),
];

/// The words as constants; a spelling that begins with a digit has `W` before it, one
/// with a point `DOT_` in its place.
pub mod word {
    use crate::Word;

    /// `.AND`: Operator; APT4 minor.
    pub const DOT_AND: Word = Word(0);
    /// `.EQ`: Operator; APT4 minor.
    pub const DOT_EQ: Word = Word(1);
    /// `.FALSE`: Operator; APT4 minor.
    pub const DOT_FALSE: Word = Word(2);
    /// `.GE`: Operator; APT4 minor.
    pub const DOT_GE: Word = Word(3);
    /// `.GT`: Operator; APT4 minor.
    pub const DOT_GT: Word = Word(4);
    /// `.LE`: Operator; APT4 minor.
    pub const DOT_LE: Word = Word(5);
    /// `.LT`: Operator; APT4 minor.
    pub const DOT_LT: Word = Word(6);
    /// `.NE`: Operator; APT4 minor.
    pub const DOT_NE: Word = Word(7);
    /// `.NOT`: Operator; APT4 minor.
    pub const DOT_NOT: Word = Word(8);
    /// `.OR`: Operator; APT4 minor.
    pub const DOT_OR: Word = Word(9);
    /// `.TRUE`: Operator; APT4 minor.
    pub const DOT_TRUE: Word = Word(10);
    /// `1STPECK`: Modifier; CL text minor.
    pub const W1STPECK: Word = Word(11);
    /// `2DCALC`: Motion; APT-360 6000:2, APT4 6000:2.
    pub const W2DCALC: Word = Word(12);
    /// `3DCALC`: Motion; APT-360 6000:2, APT4 6000:2.
    pub const W3DCALC: Word = Word(13);
    /// `3PT2SL`: Modifier; APT-360 minor 43, APT4 minor 43.
    pub const W3PT2SL: Word = Word(14);
    /// `4PT1SL`: Modifier; APT-360 minor 44, APT4 minor 44.
    pub const W4PT1SL: Word = Word(15);
    /// `5PT`: Modifier; APT-360 minor 45, APT4 minor 45.
    pub const W5PT: Word = Word(16);
    /// `AA`: Modifier; NCL minor 1.
    pub const AA: Word = Word(17);
    /// `AAXIS`: Modifier; APT-360 minor 140, APT4 minor 140, PostWorks minor 140, NCL minor 140.
    pub const AAXIS: Word = Word(18);
    /// `ABS`: Function; NCL minor 552.
    pub const ABS: Word = Word(19);
    /// `ABSF`: Function; APT-360, APT4, NCL minor 552.
    pub const ABSF: Word = Word(20);
    /// `ABSOL`: Modifier; PostWorks minor 180, NCL minor 180.
    pub const ABSOL: Word = Word(21);
    /// `ACCESS`: Modifier; NCL minor 830.
    pub const ACCESS: Word = Word(22);
    /// `ACOS`: Function; NCL minor 562.
    pub const ACOS: Word = Word(23);
    /// `ACOSF`: Function; NCL minor 562.
    pub const ACOSF: Word = Word(24);
    /// `ACTIVE`: Modifier; NCL minor 341.
    pub const ACTIVE: Word = Word(25);
    /// `ADJUST`: Modifier; APT-360 minor 159, APT4 minor 159, PostWorks minor 159, NCL minor 159.
    pub const ADJUST: Word = Word(26);
    /// `AIR`: Post; APT-360 1011, APT4 1011, PostWorks 1011, NCL 1011.
    pub const AIR: Word = Word(27);
    /// `ALIGN`: Post; PostWorks 1076, NCL 1076.
    pub const ALIGN: Word = Word(28);
    /// `ALL`: Modifier; APT-360 minor 51, APT4 minor 51, PostWorks minor 51, NCL minor 816.
    pub const ALL: Word = Word(29);
    /// `ALTER`: Modifier; NCL minor 951.
    pub const ALTER: Word = Word(30);
    /// `ANALYZ`: Modifier; NCL minor 874.
    pub const ANALYZ: Word = Word(31);
    /// `ANGL`: Function; NCL minor 559.
    pub const ANGL: Word = Word(32);
    /// `ANGLB`: Function; APT4.
    pub const ANGLB: Word = Word(33);
    /// `ANGLE`: Modifier; APT4 minor.
    pub const ANGLE: Word = Word(34);
    /// `ANGLF`: Function; APT-360, APT4, NCL minor 559.
    pub const ANGLF: Word = Word(35);
    /// `ANOTE`: Modifier; NCL minor 616.
    pub const ANOTE: Word = Word(36);
    /// `ANTSPI`: Modifier; APT-360 minor 176, APT4 minor 176.
    pub const ANTSPI: Word = Word(37);
    /// `APPEND`: Post; PostWorks 1199.
    pub const APPEND: Word = Word(38);
    /// `APPLY`: Post; CL text.
    pub const APPLY: Word = Word(39);
    /// `APTRAN`: Control; APT4.
    pub const APTRAN: Word = Word(40);
    /// `APTREN`: Control; APT4.
    pub const APTREN: Word = Word(41);
    /// `ARC`: Modifier; APT-360 minor 87, APT4 minor 182, PostWorks minor 182, NCL minor 182, IBM CL minor 87.
    pub const ARC: Word = Word(42);
    /// `ARCDAT`: Post; CL text.
    pub const ARCDAT: Word = Word(43);
    /// `ARCMOV`: Post; CL text.
    pub const ARCMOV: Word = Word(44);
    /// `ARCOSB`: Function; APT4.
    pub const ARCOSB: Word = Word(45);
    /// `ARCOSF`: Function; APT4.
    pub const ARCOSF: Word = Word(46);
    /// `ARCSLP`: Post; APT-360 1029, APT4 1029, PostWorks 1029, NCL 1029.
    pub const ARCSLP: Word = Word(47);
    /// `ARROW`: Modifier; NCL minor 925.
    pub const ARROW: Word = Word(48);
    /// `ARSINB`: Function; APT4.
    pub const ARSINB: Word = Word(49);
    /// `ARSINF`: Function; APT4.
    pub const ARSINF: Word = Word(50);
    /// `AS`: Modifier; NCL minor 832.
    pub const AS: Word = Word(51);
    /// `ASIN`: Function; NCL minor 558.
    pub const ASIN: Word = Word(52);
    /// `ASINF`: Function; NCL minor 558.
    pub const ASINF: Word = Word(53);
    /// `ASLOPE`: Post; APT-360 1053, APT4 1053.
    pub const ASLOPE: Word = Word(54);
    /// `AT`: Modifier; APT-360 minor 175, APT4 minor 189, PostWorks minor 189, NCL minor 189.
    pub const AT: Word = Word(55);
    /// `ATAN`: Function; NCL minor 553.
    pub const ATAN: Word = Word(56);
    /// `ATAN2`: Function; NCL minor 565.
    pub const ATAN2: Word = Word(57);
    /// `ATAN2B`: Function; APT4.
    pub const ATAN2B: Word = Word(58);
    /// `ATAN2F`: Function; APT-360, APT4, NCL minor 565.
    pub const ATAN2F: Word = Word(59);
    /// `ATANB`: Function; APT4.
    pub const ATANB: Word = Word(60);
    /// `ATANF`: Function; APT-360, APT4, NCL minor 553.
    pub const ATANF: Word = Word(61);
    /// `ATANGL`: Modifier; APT-360 minor 1, APT4 minor 1, PostWorks minor 1, NCL minor 1.
    pub const ATANGL: Word = Word(62);
    /// `ATTRIB`: Modifier; NCL minor 879.
    pub const ATTRIB: Word = Word(63);
    /// `AUTO`: Modifier; APT-360 minor 88, APT4 minor 88, PostWorks minor 88, NCL minor 88.
    pub const AUTO: Word = Word(64);
    /// `AUTOPS`: Motion; APT-360 9000:7, APT4 9000:7, NCL 745.
    pub const AUTOPS: Word = Word(65);
    /// `AUXFUN`: Post; APT-360 1022, APT4 1022, PostWorks 1022, NCL 1022.
    pub const AUXFUN: Word = Word(66);
    /// `AVCTRL`: Regional; APT4.
    pub const AVCTRL: Word = Word(67);
    /// `AVMSG`: Modifier; APT4 minor.
    pub const AVMSG: Word = Word(68);
    /// `AVOID`: Modifier; APT-360 minor 173, APT4 minor 187, PostWorks minor 187, NCL minor 327, IBM CL minor 187.
    pub const AVOID: Word = Word(69);
    /// `AVPRT`: Modifier; APT4 minor.
    pub const AVPRT: Word = Word(70);
    /// `AWAY`: Modifier; APT4 minor.
    pub const AWAY: Word = Word(71);
    /// `AXIS`: Modifier; APT4 minor, PostWorks minor 132, NCL minor 132.
    pub const AXIS: Word = Word(72);
    /// `BACK`: Modifier; APT4 minor.
    pub const BACK: Word = Word(73);
    /// `BAR`: Modifier; PostWorks minor 207.
    pub const BAR: Word = Word(74);
    /// `BASE`: Modifier; NCL minor 868.
    pub const BASE: Word = Word(75);
    /// `BAXIS`: Modifier; APT-360 minor 141, APT4 minor 141, PostWorks minor 141, NCL minor 141.
    pub const BAXIS: Word = Word(76);
    /// `BCD`: Modifier; APT-360 minor 165, APT4 minor 165.
    pub const BCD: Word = Word(77);
    /// `BEGIN`: Post and Modifier; NCL minor 58, CL text.
    pub const BEGIN: Word = Word(78);
    /// `BEVELS`: Motion; APT-360 6000:2.
    pub const BEVELS: Word = Word(79);
    /// `BINARY`: Modifier; APT-360 minor 164, APT4 minor 164.
    pub const BINARY: Word = Word(80);
    /// `BINORM`: Modifier; APT4 minor.
    pub const BINORM: Word = Word(81);
    /// `BLACK`: Modifier; APT-360 minor 130, APT4 minor 130, NCL minor 904.
    pub const BLACK: Word = Word(82);
    /// `BLADE`: Modifier; PostWorks minor 191, NCL minor 191.
    pub const BLADE: Word = Word(83);
    /// `BLOCK`: Post; CL text.
    pub const BLOCK: Word = Word(84);
    /// `BLUE`: Modifier; APT-360 minor 133, APT4 minor 133, NCL minor 906.
    pub const BLUE: Word = Word(85);
    /// `BORDER`: Modifier; NCL minor 932.
    pub const BORDER: Word = Word(86);
    /// `BORE`: Modifier; APT-360 minor 82, APT4 minor 82, PostWorks minor 82, NCL minor 82.
    pub const BORE: Word = Word(87);
    /// `BORE5`: Modifier; PostWorks minor 209.
    pub const BORE5: Word = Word(88);
    /// `BORE6`: Modifier; PostWorks minor 210.
    pub const BORE6: Word = Word(89);
    /// `BORE7`: Modifier; PostWorks minor 211, NCL minor 211, IBM CL minor 211.
    pub const BORE7: Word = Word(90);
    /// `BORE8`: Modifier; PostWorks minor 212, NCL minor 212, IBM CL minor 212.
    pub const BORE8: Word = Word(91);
    /// `BORE9`: Modifier; PostWorks minor 213, NCL minor 213, IBM CL minor 213.
    pub const BORE9: Word = Word(92);
    /// `BOTH`: Modifier; APT-360 minor 83, APT4 minor 83, PostWorks minor 83, NCL minor 83.
    pub const BOTH: Word = Word(93);
    /// `BOUND`: Modifier; NCL minor 624.
    pub const BOUND: Word = Word(94);
    /// `BOUNDS`: Geometry; APT4.
    pub const BOUNDS: Word = Word(95);
    /// `BOX`: Modifier; PostWorks minor 340, NCL minor 340.
    pub const BOX: Word = Word(96);
    /// `BREAK`: Post; APT4 17, PostWorks 16, NCL 16, IBM CL 17.
    pub const BREAK: Word = Word(97);
    /// `BRKCHP`: Modifier; PostWorks minor 288, CL text minor.
    pub const BRKCHP: Word = Word(98);
    /// `BROWN`: Modifier; NCL minor 912.
    pub const BROWN: Word = Word(99);
    /// `BSP`: Modifier; NCL minor 628.
    pub const BSP: Word = Word(100);
    /// `CA`: Control; NCL minor 645.
    pub const CA: Word = Word(101);
    /// `CALL`: Control; APT-360, APT4, PostWorks 824, NCL 824.
    pub const CALL: Word = Word(102);
    /// `CALLS`: Modifier; NCL minor 867.
    pub const CALLS: Word = Word(103);
    /// `CALSUB`: Post; CL text.
    pub const CALSUB: Word = Word(104);
    /// `CAM`: Modifier; APT-360 minor 169, APT4 minor 169, PostWorks minor 237, NCL minor 237, IBM CL minor 169.
    pub const CAM: Word = Word(105);
    /// `CAMERA`: Post; APT-360 1047, APT4 1047.
    pub const CAMERA: Word = Word(106);
    /// `CAN`: Function and Modifier; NCL minor 566.
    pub const CAN: Word = Word(107);
    /// `CANF`: Function; APT4, NCL minor 566.
    pub const CANF: Word = Word(108);
    /// `CANON`: Control; APT-360 3099:0, APT4 3099:0, NCL 645.
    pub const CANON: Word = Word(109);
    /// `CAXIS`: Modifier; APT-360 minor 142, APT4 minor 142, PostWorks minor 142, NCL minor 142.
    pub const CAXIS: Word = Word(110);
    /// `CBORE`: Modifier; PostWorks minor 245, NCL minor 245, IBM CL minor 207.
    pub const CBORE: Word = Word(111);
    /// `CBRTF`: Function; NCL minor 569.
    pub const CBRTF: Word = Word(112);
    /// `CCLW`: Modifier; APT-360 minor 59, APT4 minor 59, PostWorks minor 59, NCL minor 59.
    pub const CCLW: Word = Word(113);
    /// `CCW`: Post; CL text.
    pub const CCW: Word = Word(114);
    /// `CE`: Modifier; NCL minor 634.
    pub const CE: Word = Word(115);
    /// `CENTER`: Modifier; APT-360 minor 2, APT4 minor 2, PostWorks minor 2, NCL minor 634.
    pub const CENTER: Word = Word(116);
    /// `CFSAVE`: Control; APT4.
    pub const CFSAVE: Word = Word(117);
    /// `CHAMFR`: Modifier; NCL minor 961.
    pub const CHAMFR: Word = Word(118);
    /// `CHANNEL`: Post; CL text.
    pub const CHANNEL: Word = Word(119);
    /// `CHDPT`: Modifier; APT4 minor.
    pub const CHDPT: Word = Word(120);
    /// `CHECK`: Post; APT-360 1023, APT4 1023, PostWorks 1023, NCL 1023.
    pub const CHECK: Word = Word(121);
    /// `CHIPS`: Modifier; PostWorks minor 331, NCL minor 331.
    pub const CHIPS: Word = Word(122);
    /// `CHKPTS`: Modifier; NCL minor 669.
    pub const CHKPTS: Word = Word(123);
    /// `CHKSRF`: Regional; APT4.
    pub const CHKSRF: Word = Word(124);
    /// `CHORD`: Modifier; APT4 minor.
    pub const CHORD: Word = Word(125);
    /// `CHUCK`: Post and Modifier; APT-360 minor 138, APT4 minor 138, PostWorks 1073, NCL 1073.
    pub const CHUCK: Word = Word(126);
    /// `CI`: Geometry; NCL minor 607.
    pub const CI: Word = Word(127);
    /// `CIRCLE`: Geometry; APT-360 surface type 4, APT4 surface type 4, NCL 607.
    pub const CIRCLE: Word = Word(128);
    /// `CIRCUL`: Modifier; APT-360 minor 75, APT4 minor 75, PostWorks minor 75, NCL minor 75.
    pub const CIRCUL: Word = Word(129);
    /// `CIRLIN`: Modifier; APT-360 minor 126, APT4 minor 126.
    pub const CIRLIN: Word = Word(130);
    /// `CLAMP`: Post; APT-360 1060, APT4 1060, PostWorks 1060, NCL 1060.
    pub const CLAMP: Word = Word(131);
    /// `CLDAT`: Regional; APT4.
    pub const CLDAT: Word = Word(132);
    /// `CLDATA`: Modifier; APT4 minor.
    pub const CLDATA: Word = Word(133);
    /// `CLDATF`: Function; APT4.
    pub const CLDATF: Word = Word(134);
    /// `CLDIST`: Post; NCL 1077.
    pub const CLDIST: Word = Word(135);
    /// `CLEAR`: Modifier; CL text minor.
    pub const CLEAR: Word = Word(136);
    /// `CLEARP`: Post; APT-360 1004, APT4 1004, PostWorks 1004, NCL 1004.
    pub const CLEARP: Word = Word(137);
    /// `CLEARS`: Modifier; APT4 minor.
    pub const CLEARS: Word = Word(138);
    /// `CLFILE`: Modifier; NCL minor 823.
    pub const CLFILE: Word = Word(139);
    /// `CLIPF`: Function; NCL minor 949.
    pub const CLIPF: Word = Word(140);
    /// `CLONE`: Modifier; PostWorks minor 576, NCL minor 576.
    pub const CLONE: Word = Word(141);
    /// `CLOSE`: Modifier; NCL minor 831.
    pub const CLOSE: Word = Word(142);
    /// `CLPRNT`: Control; APT-360, APT4 13000:4, NCL 813.
    pub const CLPRNT: Word = Word(143);
    /// `CLRSRF`: Post; APT-360 1057, APT4 1057, PostWorks 1057, NCL 1057.
    pub const CLRSRF: Word = Word(144);
    /// `CLTV`: Control; APT-360.
    pub const CLTV: Word = Word(145);
    /// `CLW`: Modifier; APT-360 minor 60, APT4 minor 60, PostWorks minor 60, NCL minor 60.
    pub const CLW: Word = Word(146);
    /// `CM`: Modifier; PostWorks minor 302.
    pub const CM: Word = Word(147);
    /// `CMIT`: Control; APT-360.
    pub const CMIT: Word = Word(148);
    /// `CO`: Post; NCL 1030.
    pub const CO: Word = Word(149);
    /// `COARSE`: Modifier; PostWorks minor 195, NCL minor 195, IBM CL minor 295.
    pub const COARSE: Word = Word(150);
    /// `CODEL`: Post; APT4 14.
    pub const CODEL: Word = Word(151);
    /// `COLAPS`: Modifier; NCL minor 343.
    pub const COLAPS: Word = Word(152);
    /// `COLF`: Function; NCL minor 942.
    pub const COLF: Word = Word(153);
    /// `COLLET`: Modifier; APT-360 minor 139, APT4 minor 139, PostWorks minor 139, NCL minor 139.
    pub const COLLET: Word = Word(154);
    /// `COLOR`: Modifier; NCL minor 900.
    pub const COLOR: Word = Word(155);
    /// `COMBIN`: Post and Modifier; APT4 minor, PostWorks 1071, NCL 1071, IBM CL 1079.
    pub const COMBIN: Word = Word(156);
    /// `COMPOS`: Modifier; NCL minor 612.
    pub const COMPOS: Word = Word(157);
    /// `CONE`: Geometry and Modifier; APT-360 surface type 8, APT4 surface type 8, PostWorks minor 632, NCL minor 632.
    pub const CONE: Word = Word(158);
    /// `CONIC`: Modifier; NCL minor 611.
    pub const CONIC: Word = Word(159);
    /// `CONSEC`: Geometry; APT-360 surface type 52.
    pub const CONSEC: Word = Word(160);
    /// `CONST`: Modifier; APT-360 minor 64, APT4 minor 64, PostWorks minor 64, NCL minor 328.
    pub const CONST: Word = Word(161);
    /// `CONT`: Post; CL text.
    pub const CONT: Word = Word(162);
    /// `CONTCT`: Motion; NCL minor 856.
    pub const CONTCT: Word = Word(163);
    /// `CONTIN`: Control; APT4, NCL 846.
    pub const CONTIN: Word = Word(164);
    /// `CONTRL`: Control; APT4.
    pub const CONTRL: Word = Word(165);
    /// `COOLNT`: Post; APT-360 1030, APT4 1030, PostWorks 1030, NCL 1030.
    pub const COOLNT: Word = Word(166);
    /// `COPY`: Control; APT-360 1040, APT4 1040, PostWorks 1040, NCL 811.
    pub const COPY: Word = Word(167);
    /// `CORNFD`: Post; APT-360 1067, APT4 1067.
    pub const CORNFD: Word = Word(168);
    /// `COS`: Function; NCL minor 556.
    pub const COS: Word = Word(169);
    /// `COSB`: Function; APT4.
    pub const COSB: Word = Word(170);
    /// `COSF`: Function; APT-360, APT4, NCL minor 556.
    pub const COSF: Word = Word(171);
    /// `COSHF`: Function; APT4.
    pub const COSHF: Word = Word(172);
    /// `COTANB`: Function; APT4.
    pub const COTANB: Word = Word(173);
    /// `COTANF`: Function; APT4.
    pub const COTANF: Word = Word(174);
    /// `COUPLE`: Post; APT-360 1049, APT4 1049, PostWorks 1049, NCL 1049.
    pub const COUPLE: Word = Word(175);
    /// `CROSS`: Modifier; APT-360 minor 3, APT4 minor 3, PostWorks minor 3, NCL minor 819.
    pub const CROSS: Word = Word(176);
    /// `CRSSPL`: Modifier; APT4 minor.
    pub const CRSSPL: Word = Word(177);
    /// `CS`: Modifier; APT4 minor, PostWorks minor 753, NCL minor 753.
    pub const CS: Word = Word(178);
    /// `CSINK`: Modifier; PostWorks minor 256, NCL minor 119, CL text minor.
    pub const CSINK: Word = Word(179);
    /// `CSS`: Post; CL text.
    pub const CSS: Word = Word(180);
    /// `CSUV`: Modifier; NCL minor 859.
    pub const CSUV: Word = Word(181);
    /// `CSYS`: Post; CL text.
    pub const CSYS: Word = Word(182);
    /// `CTRLIN`: Modifier; APT4 minor 126, PostWorks minor 126, NCL minor 126.
    pub const CTRLIN: Word = Word(183);
    /// `CU`: Motion; NCL minor 716.
    pub const CU: Word = Word(184);
    /// `CUBE`: Modifier; NCL minor 959.
    pub const CUBE: Word = Word(185);
    /// `CURSEG`: Modifier; APT4 minor.
    pub const CURSEG: Word = Word(186);
    /// `CURVE`: Modifier; NCL minor 608.
    pub const CURVE: Word = Word(187);
    /// `CUT`: Motion; APT-360 6000:1, APT4 6000:1, PostWorks 803, NCL 803.
    pub const CUT: Word = Word(188);
    /// `CUTANG`: Modifier; APT-360 minor 160, APT4 minor 160, PostWorks minor 160, NCL minor 160.
    pub const CUTANG: Word = Word(189);
    /// `CUTCOM`: Post; APT-360 1007, APT4 1007, PostWorks 1007, NCL 1007.
    pub const CUTCOM: Word = Word(190);
    /// `CUTTER`: Motion; APT-360 6000:6, APT4 6000:6, NCL 716.
    pub const CUTTER: Word = Word(191);
    /// `CV`: Modifier; NCL minor 608.
    pub const CV: Word = Word(192);
    /// `CW`: Post; CL text.
    pub const CW: Word = Word(193);
    /// `CY`: Post; NCL 1054.
    pub const CY: Word = Word(194);
    /// `CYAN`: Modifier; NCL minor 911.
    pub const CYAN: Word = Word(195);
    /// `CYCLE`: Post; APT-360 1054, APT4 1054, PostWorks 1054, NCL 1054.
    pub const CYCLE: Word = Word(196);
    /// `CYLNDR`: Geometry; APT-360 surface type 5, APT4 surface type 5, NCL 620.
    pub const CYLNDR: Word = Word(197);
    /// `DAC`: Control; APT-360.
    pub const DAC: Word = Word(198);
    /// `DARK`: Modifier; APT-360 minor 137, APT4 minor 137.
    pub const DARK: Word = Word(199);
    /// `DASH`: Modifier; APT-360 minor 124, APT4 minor 124, PostWorks minor 124, NCL minor 124, IBM CL minor 188.
    pub const DASH: Word = Word(200);
    /// `DASHDT`: Modifier; NCL minor 918.
    pub const DASHDT: Word = Word(201);
    /// `DASHLN`: Modifier; NCL minor 917.
    pub const DASHLN: Word = Word(202);
    /// `DASHSP`: Modifier; NCL minor 919.
    pub const DASHSP: Word = Word(203);
    /// `DATA`: Modifier; NCL minor 858.
    pub const DATA: Word = Word(204);
    /// `DBFN`: Modifier; NCL minor 829.
    pub const DBFN: Word = Word(205);
    /// `DBLCIR`: Modifier; NCL minor 957.
    pub const DBLCIR: Word = Word(206);
    /// `DC`: Motion; NCL minor 802.
    pub const DC: Word = Word(207);
    /// `DDLIM`: Regional; APT4.
    pub const DDLIM: Word = Word(208);
    /// `DEBUG`: Control; APT-360.
    pub const DEBUG: Word = Word(209);
    /// `DEBUGG`: Post; APT4 1032, PostWorks 1032, NCL 1032.
    pub const DEBUGG: Word = Word(210);
    /// `DECOMP`: Modifier; NCL minor 618.
    pub const DECOMP: Word = Word(211);
    /// `DECR`: Modifier; APT-360 minor 65, APT4 minor 65, PostWorks minor 65, NCL minor 65.
    pub const DECR: Word = Word(212);
    /// `DEEP`: Modifier; APT-360 minor 153, APT4 minor 153, PostWorks minor 153, NCL minor 153.
    pub const DEEP: Word = Word(213);
    /// `DEEP2`: Modifier; CL text minor.
    pub const DEEP2: Word = Word(214);
    /// `DEEPBK`: Modifier; PostWorks minor 216, NCL minor 216, IBM CL minor 184.
    pub const DEEPBK: Word = Word(215);
    /// `DEEPCL`: Modifier; PostWorks minor 208, NCL minor 208, IBM CL minor 185.
    pub const DEEPCL: Word = Word(216);
    /// `DEFALT`: Modifier; NCL minor 903.
    pub const DEFALT: Word = Word(217);
    /// `DEFNAM`: Modifier; NCL minor 899.
    pub const DEFNAM: Word = Word(218);
    /// `DEFSUB`: Post; CL text.
    pub const DEFSUB: Word = Word(219);
    /// `DELAY`: Post; APT-360 1010, APT4 1010, PostWorks 1010, NCL 1010.
    pub const DELAY: Word = Word(220);
    /// `DELETE`: Post; APT-360 1012, APT4 1012.
    pub const DELETE: Word = Word(221);
    /// `DELTA`: Modifier; PostWorks minor 188, NCL minor 34.
    pub const DELTA: Word = Word(222);
    /// `DEPTH`: Modifier; PostWorks minor 510, NCL minor 510, IBM CL minor 303, CL text minor.
    pub const DEPTH: Word = Word(223);
    /// `DIAMTR`: Modifier; PostWorks minor 205, NCL minor 205.
    pub const DIAMTR: Word = Word(224);
    /// `DIMOND`: Modifier; NCL minor 956.
    pub const DIMOND: Word = Word(225);
    /// `DISK`: Post; PostWorks 1097, NCL 1097.
    pub const DISK: Word = Word(226);
    /// `DISPDB`: Post; NCL 1090.
    pub const DISPDB: Word = Word(227);
    /// `DISPLY`: Post; APT-360 1021, APT4 1021, PostWorks 1021, NCL 1021.
    pub const DISPLY: Word = Word(228);
    /// `DIST`: Function; NCL minor 575.
    pub const DIST: Word = Word(229);
    /// `DISTF`: Function; APT-360, APT4, NCL minor 575.
    pub const DISTF: Word = Word(230);
    /// `DITTO`: Modifier; APT-360 minor 127, APT4 minor 127, PostWorks minor 127, NCL minor 127.
    pub const DITTO: Word = Word(231);
    /// `DMILL`: Motion; APT-360 6000:11.
    pub const DMILL: Word = Word(232);
    /// `DNTCUT`: Motion; APT-360 6000:1, APT4 6000:1, NCL 802.
    pub const DNTCUT: Word = Word(233);
    /// `DO`: Control; APT4, NCL 844.
    pub const DO: Word = Word(234);
    /// `DOT`: Operator and Function; APT4 minor, NCL minor 561.
    pub const DOT: Word = Word(235);
    /// `DOTF`: Function; APT-360, APT4, NCL minor 561.
    pub const DOTF: Word = Word(236);
    /// `DOTTED`: Modifier; APT-360 minor 125, APT4 minor 125, PostWorks minor 125, NCL minor 125.
    pub const DOTTED: Word = Word(237);
    /// `DOWN`: Modifier; APT-360 minor 113, APT4 minor 113, PostWorks minor 113, NCL minor 113.
    pub const DOWN: Word = Word(238);
    /// `DR`: Modifier; NCL minor 163.
    pub const DR: Word = Word(239);
    /// `DRAFT`: Post; APT-360 1059, APT4 1059, PostWorks 1059, NCL 1059.
    pub const DRAFT: Word = Word(240);
    /// `DRAG`: Modifier; PostWorks minor 278, NCL minor 278, IBM CL minor 193.
    pub const DRAG: Word = Word(241);
    /// `DRAWLI`: Post; APT-360 17, APT4 17.
    pub const DRAWLI: Word = Word(242);
    /// `DRESS`: Post; APT-360 8, APT4 8.
    pub const DRESS: Word = Word(243);
    /// `DRILL`: Modifier; APT-360 minor 163, APT4 minor 163, PostWorks minor 163, NCL minor 163.
    pub const DRILL: Word = Word(244);
    /// `DS`: Modifier; APT4 minor, PostWorks minor 729, NCL minor 729.
    pub const DS: Word = Word(245);
    /// `DSTAN`: Modifier; APT-360 minor 27, APT4 minor 27.
    pub const DSTAN: Word = Word(246);
    /// `DSUV`: Modifier; NCL minor 858.
    pub const DSUV: Word = Word(247);
    /// `DWELL`: Post and Modifier; APT-360 1058, APT4 1058, PostWorks minor 279, NCL minor 197, IBM CL minor 175.
    pub const DWELL: Word = Word(248);
    /// `DYNDMP`: Motion; APT-360 6000:9, APT4 6000:9.
    pub const DYNDMP: Word = Word(249);
    /// `EDGE`: Modifier; NCL minor 860.
    pub const EDGE: Word = Word(250);
    /// `EJECT`: Control; APT4.
    pub const EJECT: Word = Word(251);
    /// `ELLIPS`: Geometry; APT-360 surface type 6, APT4 surface type 6.
    pub const ELLIPS: Word = Word(252);
    /// `ELMSRF`: Geometry; APT-360 surface type 54.
    pub const ELMSRF: Word = Word(253);
    /// `ELSE`: Control; NCL minor 940.
    pub const ELSE: Word = Word(254);
    /// `ELSEIF`: Control; NCL minor 939.
    pub const ELSEIF: Word = Word(255);
    /// `END`: Post and Modifier; APT-360 1, APT4 1, PostWorks 1, NCL minor 499.
    pub const END: Word = Word(256);
    /// `ENDARC`: Modifier; APT-360 minor 58, APT4 minor 58.
    pub const ENDARC: Word = Word(257);
    /// `ENDIF`: Control; NCL minor 941.
    pub const ENDIF: Word = Word(258);
    /// `ENDMDI`: Post; APT4 1052.
    pub const ENDMDI: Word = Word(259);
    /// `ENDPT`: Modifier; PostWorks minor 664, NCL minor 664.
    pub const ENDPT: Word = Word(260);
    /// `ENDSUB`: Post; CL text.
    pub const ENDSUB: Word = Word(261);
    /// `ENGAGE`: Modifier; NCL minor 324.
    pub const ENGAGE: Word = Word(262);
    /// `ERASE`: Modifier; NCL minor 742.
    pub const ERASE: Word = Word(263);
    /// `ERROR`: Control; APT4, PostWorks 1103, NCL 937.
    pub const ERROR: Word = Word(264);
    /// `EXHVY`: Modifier; NCL minor 922.
    pub const EXHVY: Word = Word(265);
    /// `EXP`: Function; NCL minor 550.
    pub const EXP: Word = Word(266);
    /// `EXPF`: Function; APT-360, APT4, NCL minor 550.
    pub const EXPF: Word = Word(267);
    /// `EXTRUD`: Modifier; NCL minor 633.
    pub const EXTRUD: Word = Word(268);
    /// `FACE`: Modifier; APT-360 minor 81, APT4 minor 81, PostWorks minor 81, NCL minor 81.
    pub const FACE: Word = Word(269);
    /// `FACEML`: Post; APT-360 22, APT4 22.
    pub const FACEML: Word = Word(270);
    /// `FAN`: Modifier; APT-360 minor 184, NCL minor 723.
    pub const FAN: Word = Word(271);
    /// `FE`: Post; NCL 1009.
    pub const FE: Word = Word(272);
    /// `FEDRAT`: Post; APT-360 1009, APT4 1009, PostWorks 1009, NCL 1009.
    pub const FEDRAT: Word = Word(273);
    /// `FEDTO`: Modifier; PostWorks minor 281, NCL minor 281, IBM CL minor 210, CL text minor.
    pub const FEDTO: Word = Word(274);
    /// `FEED`: Modifier; APT4 minor.
    pub const FEED: Word = Word(275);
    /// `FEEDX`: Modifier; PostWorks minor 217.
    pub const FEEDX: Word = Word(276);
    /// `FEEDY`: Modifier; PostWorks minor 218.
    pub const FEEDY: Word = Word(277);
    /// `FEEDZ`: Modifier; PostWorks minor 219, NCL minor 219.
    pub const FEEDZ: Word = Word(278);
    /// `FEET`: Modifier; PostWorks minor 174.
    pub const FEET: Word = Word(279);
    /// `FETCH`: Modifier; APT4 minor.
    pub const FETCH: Word = Word(280);
    /// `FILLET`: Modifier; PostWorks minor 402, NCL minor 402, IBM CL minor 239.
    pub const FILLET: Word = Word(281);
    /// `FILTER`: Modifier; NCL minor 950.
    pub const FILTER: Word = Word(282);
    /// `FIND`: Modifier; NCL minor 872.
    pub const FIND: Word = Word(283);
    /// `FINDEX`: Function; NCL minor 573.
    pub const FINDEX: Word = Word(284);
    /// `FINE`: Modifier; PostWorks minor 193, NCL minor 193, IBM CL minor 296.
    pub const FINE: Word = Word(285);
    /// `FINI`: Control; APT-360 14000:0, APT4 14000:0, NCL 801.
    pub const FINI: Word = Word(286);
    /// `FINISH`: Modifier; NCL minor 323.
    pub const FINISH: Word = Word(287);
    /// `FIT`: Modifier; NCL minor 834.
    pub const FIT: Word = Word(288);
    /// `FIVONE`: Modifier; NCL minor 929.
    pub const FIVONE: Word = Word(289);
    /// `FIXTUR`: Modifier; PostWorks minor 898, NCL minor 898.
    pub const FIXTUR: Word = Word(290);
    /// `FLOOD`: Modifier; APT-360 minor 89, APT4 minor 89, PostWorks minor 89, NCL minor 89.
    pub const FLOOD: Word = Word(291);
    /// `FLOW`: Modifier; APT4 minor.
    pub const FLOW: Word = Word(292);
    /// `FLUSH`: Post; CL text.
    pub const FLUSH: Word = Word(293);
    /// `FLUTES`: Modifier; NCL minor 206.
    pub const FLUTES: Word = Word(294);
    /// `FMILL`: Modifier; NCL minor 748.
    pub const FMILL: Word = Word(295);
    /// `FONT`: Modifier; NCL minor 947.
    pub const FONT: Word = Word(296);
    /// `FORCE`: Post; PostWorks 1106.
    pub const FORCE: Word = Word(297);
    /// `FORMAT`: Modifier; NCL minor 849.
    pub const FORMAT: Word = Word(298);
    /// `FOUR`: Modifier; NCL minor 928.
    pub const FOUR: Word = Word(299);
    /// `FOURPT`: Modifier; APT-360 minor 101, APT4 minor 101.
    pub const FOURPT: Word = Word(300);
    /// `FPT`: Modifier; CL text minor.
    pub const FPT: Word = Word(301);
    /// `FR`: Post; NCL 1009.
    pub const FR: Word = Word(302);
    /// `FROM`: Motion; APT-360 5000:3, APT4 5000:3, NCL 701.
    pub const FROM: Word = Word(303);
    /// `FRONT`: Modifier; APT-360 minor 148, APT4 minor 148, PostWorks minor 148, NCL minor 148.
    pub const FRONT: Word = Word(304);
    /// `FULL`: Modifier; APT-360 minor 147, APT4 minor 147.
    pub const FULL: Word = Word(305);
    /// `FUNOFY`: Modifier; APT-360 minor 4, APT4 minor 4.
    pub const FUNOFY: Word = Word(306);
    /// `FWD`: Modifier; APT4 minor, PostWorks minor 651, NCL minor 651.
    pub const FWD: Word = Word(307);
    /// `GAPLES`: Modifier; APT-360 minor 180, APT4 minor 180.
    pub const GAPLES: Word = Word(308);
    /// `GB`: Motion; NCL minor 707.
    pub const GB: Word = Word(309);
    /// `GCLEAR`: Regional; APT4.
    pub const GCLEAR: Word = Word(310);
    /// `GCONIC`: Geometry; APT-360 surface type 9, APT4 surface type 9.
    pub const GCONIC: Word = Word(311);
    /// `GD`: Motion; NCL minor 710.
    pub const GD: Word = Word(312);
    /// `GENCUR`: Modifier; APT4 minor.
    pub const GENCUR: Word = Word(313);
    /// `GENPTS`: Modifier; NCL minor 743.
    pub const GENPTS: Word = Word(314);
    /// `GEO`: Modifier; NCL minor 835.
    pub const GEO: Word = Word(315);
    /// `GEOM`: Modifier; APT4 minor.
    pub const GEOM: Word = Word(316);
    /// `GET`: Modifier; NCL minor 827.
    pub const GET: Word = Word(317);
    /// `GF`: Motion; NCL minor 704.
    pub const GF: Word = Word(318);
    /// `GFA`: Modifier; NCL minor 873.
    pub const GFA: Word = Word(319);
    /// `GL`: Motion; NCL minor 705.
    pub const GL: Word = Word(320);
    /// `GMESH`: Modifier; APT4 minor.
    pub const GMESH: Word = Word(321);
    /// `GO`: Motion; APT-360 7000:1, APT4 7000:1, NCL 702.
    pub const GO: Word = Word(322);
    /// `GOBACK`: Motion; APT-360 8000:4, APT4 8000:4, NCL 707.
    pub const GOBACK: Word = Word(323);
    /// `GOCCLW`: Post; CL text.
    pub const GOCCLW: Word = Word(324);
    /// `GOCLER`: Post; APT-360 16, APT4 16.
    pub const GOCLER: Word = Word(325);
    /// `GOCLW`: Post; CL text.
    pub const GOCLW: Word = Word(326);
    /// `GODLTA`: Motion; APT-360 5000:4, APT4 5000:4, NCL 710.
    pub const GODLTA: Word = Word(327);
    /// `GODOWN`: Motion; APT-360 8000:6, APT4 8000:6, NCL 709.
    pub const GODOWN: Word = Word(328);
    /// `GOFWD`: Motion; APT-360 8000:3, APT4 8000:3, NCL 704.
    pub const GOFWD: Word = Word(329);
    /// `GOFWDA`: Motion; NCL minor 873.
    pub const GOFWDA: Word = Word(330);
    /// `GOHOME`: Post; APT-360 14, APT4 14, PostWorks 17, NCL 17, IBM CL 14.
    pub const GOHOME: Word = Word(331);
    /// `GOLFT`: Motion; APT-360 8000:1, APT4 8000:1, NCL 705.
    pub const GOLFT: Word = Word(332);
    /// `GOLOFT`: Regional; APT4.
    pub const GOLOFT: Word = Word(333);
    /// `GOMILL`: Regional; APT4.
    pub const GOMILL: Word = Word(334);
    /// `GORGT`: Motion; APT-360 8000:2, APT4 8000:2, NCL 706.
    pub const GORGT: Word = Word(335);
    /// `GOTO`: Motion; APT-360 5000:5, APT4 5000:5, NCL 703.
    pub const GOTO: Word = Word(336);
    /// `GOUGCK`: Motion; APT-360 9000:8, APT4 9000:8, NCL 838.
    pub const GOUGCK: Word = Word(337);
    /// `GOUP`: Motion; APT-360 8000:5, APT4 8000:5, NCL 708.
    pub const GOUP: Word = Word(338);
    /// `GR`: Motion; NCL minor 706.
    pub const GR: Word = Word(339);
    /// `GREEN`: Modifier; APT-360 minor 132, APT4 minor 132, NCL minor 908.
    pub const GREEN: Word = Word(340);
    /// `GREY`: Post; NCL 1104.
    pub const GREY: Word = Word(341);
    /// `GRID`: Modifier; APT-360 minor 176, APT4 minor 67, PostWorks minor 67, NCL minor 67, IBM CL minor 176.
    pub const GRID: Word = Word(342);
    /// `GT`: Motion; NCL minor 703.
    pub const GT: Word = Word(343);
    /// `GUIDE`: Modifier; NCL minor 865.
    pub const GUIDE: Word = Word(344);
    /// `HEAD`: Post; APT-360 1002, APT4 1002, PostWorks 1002, NCL 1002.
    pub const HEAD: Word = Word(345);
    /// `HEAVY`: Modifier; NCL minor 921.
    pub const HEAVY: Word = Word(346);
    /// `HEIGHT`: Modifier; NCL minor 754.
    pub const HEIGHT: Word = Word(347);
    /// `HELICAL`: Post; CL text.
    pub const HELICAL: Word = Word(348);
    /// `HELIX`: Modifier; NCL minor 855.
    pub const HELIX: Word = Word(349);
    /// `HEX`: Modifier; APT4 minor.
    pub const HEX: Word = Word(350);
    /// `HIDDEN`: Modifier; NCL minor 579.
    pub const HIDDEN: Word = Word(351);
    /// `HIGH`: Modifier; APT-360 minor 62, APT4 minor 62, PostWorks minor 62, NCL minor 62.
    pub const HIGH: Word = Word(352);
    /// `HIGHT`: Modifier; APT4 minor.
    pub const HIGHT: Word = Word(353);
    /// `HOLDER`: Regional and Modifier; APT-360 minor 157, APT4 157, PostWorks minor 157, NCL minor 157.
    pub const HOLDER: Word = Word(354);
    /// `HOME`: Modifier; PostWorks minor 790, NCL minor 790.
    pub const HOME: Word = Word(355);
    /// `HYPERB`: Geometry; APT-360 surface type 7, APT4 surface type 7.
    pub const HYPERB: Word = Word(356);
    /// `IF`: Control; APT-360, APT4, NCL 825.
    pub const IF: Word = Word(357);
    /// `IFRO`: Post; APT-360 1032, APT4 1032.
    pub const IFRO: Word = Word(358);
    /// `IFTOL`: Post; PostWorks 1108, NCL 751.
    pub const IFTOL: Word = Word(359);
    /// `IN`: Modifier; APT-360 minor 48, APT4 minor 48, PostWorks minor 48, NCL minor 652.
    pub const IN: Word = Word(360);
    /// `INCHES`: Modifier; PostWorks minor 303, NCL minor 303, IBM CL minor 302.
    pub const INCHES: Word = Word(361);
    /// `INCLUD`: Control; NCL minor 744.
    pub const INCLUD: Word = Word(362);
    /// `INCR`: Modifier; APT-360 minor 66, APT4 minor 66, PostWorks minor 66, NCL minor 66.
    pub const INCR: Word = Word(363);
    /// `INDEX`: Control; APT-360 1039, APT4 1039, NCL 810.
    pub const INDEX: Word = Word(364);
    /// `INDEXF`: Post; PostWorks 1039.
    pub const INDEXF: Word = Word(365);
    /// `INDIRP`: Motion; APT-360 5000:1, APT4 5000:1, NCL 712.
    pub const INDIRP: Word = Word(366);
    /// `INDIRV`: Motion; APT-360 5000:2, APT4 5000:2, NCL 711.
    pub const INDIRV: Word = Word(367);
    /// `INHIBT`: Modifier; NCL minor 279.
    pub const INHIBT: Word = Word(368);
    /// `INIT`: Modifier; APT4 minor, CL text minor.
    pub const INIT: Word = Word(369);
    /// `INSERT`: Text; APT-360 1046, APT4 1046, PostWorks 1046, NCL 1046.
    pub const INSERT: Word = Word(370);
    /// `INT`: Function; NCL minor 564.
    pub const INT: Word = Word(371);
    /// `INTCOD`: Post; APT-360 1020, APT4 1020, PostWorks 1020, NCL 1020.
    pub const INTCOD: Word = Word(372);
    /// `INTENS`: Modifier; APT-360 minor 134, APT4 minor 134, PostWorks minor 134, NCL minor 134.
    pub const INTENS: Word = Word(373);
    /// `INTERC`: Modifier; APT-360 minor 46, APT4 minor 46.
    pub const INTERC: Word = Word(374);
    /// `INTERP`: Modifier; NCL minor 752.
    pub const INTERP: Word = Word(375);
    /// `INTF`: Function; APT4, NCL minor 564.
    pub const INTF: Word = Word(376);
    /// `INTOF`: Modifier; APT-360 minor 5, APT4 minor 5, PostWorks minor 727, NCL minor 727.
    pub const INTOF: Word = Word(377);
    /// `INTOF3`: Modifier; NCL minor 758.
    pub const INTOF3: Word = Word(378);
    /// `INTOL`: Motion; APT-360 6000:4, APT4 6000:4, PostWorks 1064, NCL 1064.
    pub const INTOL: Word = Word(379);
    /// `INTSEC`: Regional; APT4.
    pub const INTSEC: Word = Word(380);
    /// `INVERS`: Modifier; APT-360 minor 6, APT4 minor 6, PostWorks minor 6, NCL minor 822.
    pub const INVERS: Word = Word(381);
    /// `INVIS`: Post; NCL 1096.
    pub const INVIS: Word = Word(382);
    /// `IO`: Modifier; NCL minor 727.
    pub const IO: Word = Word(383);
    /// `IO3`: Modifier; NCL minor 758.
    pub const IO3: Word = Word(384);
    /// `IP`: Motion; NCL minor 712.
    pub const IP: Word = Word(385);
    /// `IPM`: Modifier; APT-360 minor 73, APT4 minor 73, PostWorks minor 73, NCL minor 73.
    pub const IPM: Word = Word(386);
    /// `IPR`: Modifier; APT-360 minor 74, APT4 minor 74, PostWorks minor 74, NCL minor 74.
    pub const IPR: Word = Word(387);
    /// `ISLAND`: Modifier; NCL minor 757.
    pub const ISLAND: Word = Word(388);
    /// `ISTOP`: Post; APT-360 4, APT4 4.
    pub const ISTOP: Word = Word(389);
    /// `IV`: Motion; NCL minor 711.
    pub const IV: Word = Word(390);
    /// `JUMPTO`: Control; APT-360, APT4, NCL 826.
    pub const JUMPTO: Word = Word(391);
    /// `KNIFE`: Post; PostWorks 1098, NCL 1098.
    pub const KNIFE: Word = Word(392);
    /// `KNOT`: Post; CL text.
    pub const KNOT: Word = Word(393);
    /// `KREUZ`: Operator; APT4 minor.
    pub const KREUZ: Word = Word(394);
    /// `LA`: Modifier; NCL minor 700.
    pub const LA: Word = Word(395);
    /// `LABEL`: Modifier; NCL minor 936.
    pub const LABEL: Word = Word(396);
    /// `LACE`: Modifier; NCL minor 342.
    pub const LACE: Word = Word(397);
    /// `LAG`: Modifier; APT4 minor.
    pub const LAG: Word = Word(398);
    /// `LARGE`: Modifier; APT-360 minor 7, APT4 minor 7, PostWorks minor 7, NCL minor 662.
    pub const LARGE: Word = Word(399);
    /// `LAST`: Modifier; APT-360 minor 52, APT4 minor 52, PostWorks minor 52, NCL minor 52.
    pub const LAST: Word = Word(400);
    /// `LATHE`: Modifier; PostWorks minor 700, NCL minor 700.
    pub const LATHE: Word = Word(401);
    /// `LAYER`: Modifier; NCL minor 902.
    pub const LAYER: Word = Word(402);
    /// `LAYF`: Function; NCL minor 943.
    pub const LAYF: Word = Word(403);
    /// `LCONIC`: Geometry; APT-360 surface type 10, APT4 surface type 10.
    pub const LCONIC: Word = Word(404);
    /// `LE`: Modifier; NCL minor 8.
    pub const LE: Word = Word(405);
    /// `LEAD`: Modifier; APT4 minor.
    pub const LEAD: Word = Word(406);
    /// `LEADER`: Post; APT-360 1013, APT4 1013, PostWorks 1013, NCL 1013.
    pub const LEADER: Word = Word(407);
    /// `LEFT`: Modifier; APT-360 minor 8, APT4 minor 8, PostWorks minor 8, NCL minor 8.
    pub const LEFT: Word = Word(408);
    /// `LENGTH`: Modifier; APT-360 minor 9, APT4 minor 9, PostWorks minor 9, NCL minor 9.
    pub const LENGTH: Word = Word(409);
    /// `LETDIR`: Post; NCL 1041.
    pub const LETDIR: Word = Word(410);
    /// `LETORG`: Post; NCL 1042.
    pub const LETORG: Word = Word(411);
    /// `LETSIZ`: Post; NCL 1040.
    pub const LETSIZ: Word = Word(412);
    /// `LETTER`: Post; APT-360 1043, APT4 1043, PostWorks 1043, NCL 1043.
    pub const LETTER: Word = Word(413);
    /// `LEVEL`: Modifier; NCL minor 759.
    pub const LEVEL: Word = Word(414);
    /// `LI`: Geometry; NCL minor 605.
    pub const LI: Word = Word(415);
    /// `LIBPRT`: Modifier; APT4 minor.
    pub const LIBPRT: Word = Word(416);
    /// `LIBRY`: Control; APT-360.
    pub const LIBRY: Word = Word(417);
    /// `LIGHT`: Modifier; APT-360 minor 100, APT4 minor 100.
    pub const LIGHT: Word = Word(418);
    /// `LIMIT`: Post and Modifier; APT4 minor, PostWorks 1078, NCL 1078.
    pub const LIMIT: Word = Word(419);
    /// `LINCIR`: Modifier; APT-360 minor 95, APT4 minor 95, PostWorks minor 95, NCL minor 95.
    pub const LINCIR: Word = Word(420);
    /// `LINE`: Geometry; APT-360 surface type 2, APT4 surface type 2, NCL 605.
    pub const LINE: Word = Word(421);
    /// `LINEAR`: Modifier; APT-360 minor 76, APT4 minor 76, PostWorks minor 76, NCL minor 76.
    pub const LINEAR: Word = Word(422);
    /// `LINTOL`: Post; APT4 1067, PostWorks 1067, NCL 1067, IBM CL 1073.
    pub const LINTOL: Word = Word(423);
    /// `LINTYP`: Modifier; NCL minor 131.
    pub const LINTYP: Word = Word(424);
    /// `LINWGT`: Modifier; NCL minor 901.
    pub const LINWGT: Word = Word(425);
    /// `LIST`: Modifier; NCL minor 863.
    pub const LIST: Word = Word(426);
    /// `LISTING`: Post; PostWorks 1101.
    pub const LISTING: Word = Word(427);
    /// `LISTON`: Modifier; APT4 minor.
    pub const LISTON: Word = Word(428);
    /// `LITE`: Modifier; APT-360 minor 135, APT4 minor 135.
    pub const LITE: Word = Word(429);
    /// `LN`: Geometry; NCL minor 605.
    pub const LN: Word = Word(430);
    /// `LNTH`: Function; NCL minor 560.
    pub const LNTH: Word = Word(431);
    /// `LNTHF`: Function; APT-360, APT4, NCL minor 560.
    pub const LNTHF: Word = Word(432);
    /// `LOAD`: Post; PostWorks 1075, NCL 1075, IBM CL 1074.
    pub const LOAD: Word = Word(433);
    /// `LOADTL`: Post; APT-360 1055, APT4 1055, PostWorks 1055, NCL 1055.
    pub const LOADTL: Word = Word(434);
    /// `LOADU`: Modifier; NCL minor 847.
    pub const LOADU: Word = Word(435);
    /// `LOCAL`: Control; APT4.
    pub const LOCAL: Word = Word(436);
    /// `LOCK`: Modifier; APT-360 minor 114, APT4 minor 114, PostWorks minor 114, NCL minor 114.
    pub const LOCK: Word = Word(437);
    /// `LOCKX`: Post; APT-360 21, APT4 21.
    pub const LOCKX: Word = Word(438);
    /// `LOFT`: Geometry; APT-360 surface type 16.
    pub const LOFT: Word = Word(439);
    /// `LOG`: Function; NCL minor 551.
    pub const LOG: Word = Word(440);
    /// `LOG10F`: Function; APT-360, APT4, NCL minor 568.
    pub const LOG10F: Word = Word(441);
    /// `LOGF`: Function; APT-360, APT4, NCL minor 551.
    pub const LOGF: Word = Word(442);
    /// `LONG`: Modifier; NCL minor 850.
    pub const LONG: Word = Word(443);
    /// `LOOK`: Modifier; NCL minor 871.
    pub const LOOK: Word = Word(444);
    /// `LOOPND`: Control; APT-360, APT4, NCL 809.
    pub const LOOPND: Word = Word(445);
    /// `LOOPST`: Control; APT-360, APT4, NCL 808.
    pub const LOOPST: Word = Word(446);
    /// `LOW`: Modifier; APT-360 minor 63, APT4 minor 63, PostWorks minor 63, NCL minor 63.
    pub const LOW: Word = Word(447);
    /// `LPRINT`: Post; APT-360 1065, APT4 1065, NCL 1065.
    pub const LPRINT: Word = Word(448);
    /// `LRGDOT`: Modifier; NCL minor 958.
    pub const LRGDOT: Word = Word(449);
    /// `LT`: Post; NCL 1055.
    pub const LT: Word = Word(450);
    /// `LTBLUE`: Modifier; NCL minor 914.
    pub const LTBLUE: Word = Word(451);
    /// `LTTAN`: Modifier; NCL minor 913.
    pub const LTTAN: Word = Word(452);
    /// `LTV`: Control; APT-360.
    pub const LTV: Word = Word(453);
    /// `MACHIN`: Post; APT-360 1015, APT4 1015, PostWorks 1015, NCL 1015.
    pub const MACHIN: Word = Word(454);
    /// `MACRO`: Control; APT-360, APT4, NCL 806.
    pub const MACRO: Word = Word(455);
    /// `MAGNTA`: Modifier; NCL minor 909.
    pub const MAGNTA: Word = Word(456);
    /// `MAGTAP`: Post; APT-360 1072, APT4 1072.
    pub const MAGTAP: Word = Word(457);
    /// `MAIN`: Modifier; APT-360 minor 93, APT4 minor 93, PostWorks minor 513, NCL minor 93.
    pub const MAIN: Word = Word(458);
    /// `MANUAL`: Modifier; APT-360 minor 158, APT4 minor 158, PostWorks minor 158, NCL minor 158.
    pub const MANUAL: Word = Word(459);
    /// `MARKER`: Modifier; NCL minor 952.
    pub const MARKER: Word = Word(460);
    /// `MARKF`: Function; NCL minor 960.
    pub const MARKF: Word = Word(461);
    /// `MATERL`: Modifier; NCL minor 584.
    pub const MATERL: Word = Word(462);
    /// `MATRIX`: Geometry and Modifier; APT-360 surface type 12, APT4 surface type 12, PostWorks minor 610, NCL minor 610.
    pub const MATRIX: Word = Word(463);
    /// `MAX1F`: Function; NCL minor 570.
    pub const MAX1F: Word = Word(464);
    /// `MAXANG`: Motion; NCL minor 741.
    pub const MAXANG: Word = Word(465);
    /// `MAXDP`: Motion; APT-360 9000:3, APT4 9000:3, NCL 736.
    pub const MAXDP: Word = Word(466);
    /// `MAXDPM`: Post; APT-360 1062, APT4 1062, PostWorks 1062, NCL 1062.
    pub const MAXDPM: Word = Word(467);
    /// `MAXF`: Function; APT4.
    pub const MAXF: Word = Word(468);
    /// `MAXIPM`: Modifier; APT-360 minor 96, APT4 minor 96, PostWorks minor 96, NCL minor 96.
    pub const MAXIPM: Word = Word(469);
    /// `MAXIS`: Modifier; NCL minor 870.
    pub const MAXIS: Word = Word(470);
    /// `MAXLNG`: Modifier; APT4 minor 174.
    pub const MAXLNG: Word = Word(471);
    /// `MAXPTS`: Modifier; APT4 minor 179.
    pub const MAXPTS: Word = Word(472);
    /// `MAXRPM`: Modifier; APT-360 minor 79, APT4 minor 79, PostWorks minor 79, NCL minor 79.
    pub const MAXRPM: Word = Word(473);
    /// `MAXSTP`: Modifier; APT4 minor.
    pub const MAXSTP: Word = Word(474);
    /// `MAXVEL`: Post; APT-360 1064, APT4 1064.
    pub const MAXVEL: Word = Word(475);
    /// `MAXWD`: Modifier; APT4 minor 173.
    pub const MAXWD: Word = Word(476);
    /// `MCHFIN`: Post; APT-360 1018, APT4 1018.
    pub const MCHFIN: Word = Word(477);
    /// `MCHTOL`: Post; APT-360 1016, APT4 1016, PostWorks 1016, NCL 1016.
    pub const MCHTOL: Word = Word(478);
    /// `MCSYS`: Post; CL text.
    pub const MCSYS: Word = Word(479);
    /// `MDEND`: Post; APT-360 1052, APT4 1052, PostWorks 1052, NCL 1052.
    pub const MDEND: Word = Word(480);
    /// `MDWRIT`: Post; APT-360 1051, APT4 1051, PostWorks 1051.
    pub const MDWRIT: Word = Word(481);
    /// `MED`: Modifier; APT-360 minor 136, APT4 minor 136.
    pub const MED: Word = Word(482);
    /// `MEDIUM`: Modifier; APT-360 minor 61, APT4 minor 61, PostWorks minor 61, NCL minor 61.
    pub const MEDIUM: Word = Word(483);
    /// `MESH`: Geometry; APT-360 surface type 51, NCL 839.
    pub const MESH: Word = Word(484);
    /// `MIDDLE`: Modifier; NCL minor 891.
    pub const MIDDLE: Word = Word(485);
    /// `MILL`: Modifier; APT-360 minor 151, APT4 minor 151, PostWorks minor 151, NCL minor 151.
    pub const MILL: Word = Word(486);
    /// `MILLFD`: Modifier; PostWorks minor 201, NCL minor 201, IBM CL minor 187.
    pub const MILLFD: Word = Word(487);
    /// `MILLRP`: Modifier; PostWorks minor 200, NCL minor 200, IBM CL minor 186.
    pub const MILLRP: Word = Word(488);
    /// `MIN1F`: Function; NCL minor 571.
    pub const MIN1F: Word = Word(489);
    /// `MINF`: Function; APT4.
    pub const MINF: Word = Word(490);
    /// `MINFED`: Modifier; NCL minor 964.
    pub const MINFED: Word = Word(491);
    /// `MINUS`: Modifier; APT-360 minor 10, APT4 minor 10, PostWorks minor 10, NCL minor 10.
    pub const MINUS: Word = Word(492);
    /// `MIRROR`: Modifier; APT-360 minor 56, APT4 minor 56, PostWorks minor 56, NCL minor 821.
    pub const MIRROR: Word = Word(493);
    /// `MIST`: Modifier; APT-360 minor 90, APT4 minor 90, PostWorks minor 90, NCL minor 90.
    pub const MIST: Word = Word(494);
    /// `MIT`: Control; APT-360.
    pub const MIT: Word = Word(495);
    /// `MM`: Modifier; PostWorks minor 301, NCL minor 296.
    pub const MM: Word = Word(496);
    /// `MMPM`: Modifier; APT4 minor 171, PostWorks minor 315, NCL minor 315, IBM CL minor 181.
    pub const MMPM: Word = Word(497);
    /// `MMPR`: Modifier; APT4 minor 172, PostWorks minor 316, NCL minor 316, IBM CL minor 182.
    pub const MMPR: Word = Word(498);
    /// `MO`: Modifier; NCL minor 667.
    pub const MO: Word = Word(499);
    /// `MODALS`: Modifier; NCL minor 667.
    pub const MODALS: Word = Word(500);
    /// `MODCUT`: Post; PostWorks 1099, NCL 1099.
    pub const MODCUT: Word = Word(501);
    /// `MODE`: Post; APT-360 1003, APT4 1003, PostWorks 1003, NCL 1003.
    pub const MODE: Word = Word(502);
    /// `MODF`: Function; APT4.
    pub const MODF: Word = Word(503);
    /// `MODIFY`: Modifier; APT-360 minor 55, APT4 minor 55, PostWorks minor 55, NCL minor 732.
    pub const MODIFY: Word = Word(504);
    /// `MODSYS`: Modifier; NCL minor 668.
    pub const MODSYS: Word = Word(505);
    /// `MOTDIR`: Modifier; APT4 minor.
    pub const MOTDIR: Word = Word(506);
    /// `MOTION`: Modifier; NCL minor 836.
    pub const MOTION: Word = Word(507);
    /// `MOVARC`: Post; CL text.
    pub const MOVARC: Word = Word(508);
    /// `MOVE`: Modifier; PostWorks minor 577, NCL minor 577.
    pub const MOVE: Word = Word(509);
    /// `MOVETO`: Post; APT-360 1066, APT4 1066, PostWorks 1190.
    pub const MOVETO: Word = Word(510);
    /// `MSYS`: Post; PostWorks 1077, CL text.
    pub const MSYS: Word = Word(511);
    /// `MULTAX`: Motion; APT-360 9000:2, APT4 9000:2, PostWorks 1105, NCL 815.
    pub const MULTAX: Word = Word(512);
    /// `MULTRD`: Modifier; APT-360 minor 119, APT4 minor 119.
    pub const MULTRD: Word = Word(513);
    /// `MX`: Modifier; NCL minor 610.
    pub const MX: Word = Word(514);
    /// `NAME`: Modifier; NCL minor 933.
    pub const NAME: Word = Word(515);
    /// `NAMED`: Modifier; NCL minor 931.
    pub const NAMED: Word = Word(516);
    /// `NDS`: Modifier; APT4 minor.
    pub const NDS: Word = Word(517);
    /// `NDTEST`: Motion; APT-360 6000:2, APT4 6000:2.
    pub const NDTEST: Word = Word(518);
    /// `NEARPT`: Modifier; NCL minor 866.
    pub const NEARPT: Word = Word(519);
    /// `NEGX`: Modifier; APT-360 minor 11, APT4 minor 11, PostWorks minor 11, NCL minor 657.
    pub const NEGX: Word = Word(520);
    /// `NEGY`: Modifier; APT-360 minor 12, APT4 minor 12, PostWorks minor 12, NCL minor 658.
    pub const NEGY: Word = Word(521);
    /// `NEGZ`: Modifier; APT-360 minor 13, APT4 minor 13, PostWorks minor 13, NCL minor 659.
    pub const NEGZ: Word = Word(522);
    /// `NEUTRL`: Modifier; PostWorks minor 166, NCL minor 166.
    pub const NEUTRL: Word = Word(523);
    /// `NEXT`: Modifier; APT-360 minor 162, APT4 minor 162, PostWorks minor 162, NCL minor 162.
    pub const NEXT: Word = Word(524);
    /// `NEXTTL`: Post; CL text.
    pub const NEXTTL: Word = Word(525);
    /// `NF`: Modifier; NCL minor 614.
    pub const NF: Word = Word(526);
    /// `NIBBLE`: Post; PostWorks 1082.
    pub const NIBBLE: Word = Word(527);
    /// `NINT`: Function; NCL minor 567.
    pub const NINT: Word = Word(528);
    /// `NINTF`: Function; NCL minor 567.
    pub const NINTF: Word = Word(529);
    /// `NIXIE`: Modifier; APT-360 minor 99, APT4 minor 99.
    pub const NIXIE: Word = Word(530);
    /// `NM`: Modifier; NCL minor 53.
    pub const NM: Word = Word(531);
    /// `NOBACK`: Modifier; PostWorks minor 194.
    pub const NOBACK: Word = Word(532);
    /// `NOBND`: Modifier; APT4 minor 178.
    pub const NOBND: Word = Word(533);
    /// `NOCLRP`: Modifier; APT4 minor 170.
    pub const NOCLRP: Word = Word(534);
    /// `NOLIST`: Modifier; APT4 minor.
    pub const NOLIST: Word = Word(535);
    /// `NOMORE`: Modifier; APT-360 minor 53, APT4 minor 53, PostWorks minor 53, NCL minor 53.
    pub const NOMORE: Word = Word(536);
    /// `NOPLOT`: Control; APT-360.
    pub const NOPLOT: Word = Word(537);
    /// `NOPOST`: Control and Modifier; APT-360, APT4, PostWorks minor 812, NCL 814.
    pub const NOPOST: Word = Word(538);
    /// `NOPS`: Motion; APT-360 9000:6, APT4 9000:6, NCL 726.
    pub const NOPS: Word = Word(539);
    /// `NORMAL`: Modifier; APT-360 minor 111, APT4 minor 111, PostWorks minor 111, NCL minor 820.
    pub const NORMAL: Word = Word(540);
    /// `NORMDS`: Modifier; APT-360 minor 182, APT4 minor 87.
    pub const NORMDS: Word = Word(541);
    /// `NORMPS`: Modifier; APT-360 minor 181, APT4 minor 181, NCL minor 39.
    pub const NORMPS: Word = Word(542);
    /// `NOW`: Modifier; APT-360 minor 161, APT4 minor 161, PostWorks minor 161, NCL minor 161.
    pub const NOW: Word = Word(543);
    /// `NOWARN`: Modifier; NCL minor 853.
    pub const NOWARN: Word = Word(544);
    /// `NOWRAP`: Modifier; NCL minor 890.
    pub const NOWRAP: Word = Word(545);
    /// `NOX`: Modifier; APT-360 minor 14, APT4 minor 14, PostWorks minor 14, NCL minor 14.
    pub const NOX: Word = Word(546);
    /// `NOY`: Modifier; APT-360 minor 15, APT4 minor 15, PostWorks minor 15, NCL minor 15.
    pub const NOY: Word = Word(547);
    /// `NOZ`: Modifier; APT-360 minor 16, APT4 minor 16, PostWorks minor 16, NCL minor 16.
    pub const NOZ: Word = Word(548);
    /// `NPS`: Modifier; APT4 minor.
    pub const NPS: Word = Word(549);
    /// `NSH`: Modifier; NCL minor 615.
    pub const NSH: Word = Word(550);
    /// `NSHAPE`: Modifier; NCL minor 615.
    pub const NSHAPE: Word = Word(551);
    /// `NSURF`: Modifier; NCL minor 614.
    pub const NSURF: Word = Word(552);
    /// `NUM`: Function and Modifier; NCL minor 563, CL text minor.
    pub const NUM: Word = Word(553);
    /// `NUMF`: Function; APT-360, APT4, NCL minor 563.
    pub const NUMF: Word = Word(554);
    /// `NUMPTS`: Motion; APT-360 9000:4, APT4 9000:4, NCL 737.
    pub const NUMPTS: Word = Word(555);
    /// `NURBS`: Post; CL text.
    pub const NURBS: Word = Word(556);
    /// `OB`: Control; NCL minor 661.
    pub const OB: Word = Word(557);
    /// `OBJECT`: Geometry; APT4.
    pub const OBJECT: Word = Word(558);
    /// `OBTAIN`: Control; APT-360, APT4, NCL 661.
    pub const OBTAIN: Word = Word(559);
    /// `OFF`: Modifier; APT-360 minor 72, APT4 minor 72, PostWorks minor 72, NCL minor 72.
    pub const OFF: Word = Word(560);
    /// `OFFSET`: Motion and Modifier; APT-360 7000:2, APT4 7000:2, PostWorks minor 705, NCL 666.
    pub const OFFSET: Word = Word(561);
    /// `OFSETL`: Modifier; PostWorks minor 275, NCL minor 275, IBM CL minor 279.
    pub const OFSETL: Word = Word(562);
    /// `OMIT`: Modifier; APT-360 minor 172, APT4 minor 186, PostWorks minor 176, NCL minor 172.
    pub const OMIT: Word = Word(563);
    /// `ON`: Modifier; APT-360 minor 71, APT4 minor 71, PostWorks minor 71, NCL minor 71.
    pub const ON: Word = Word(564);
    /// `ONCE`: Modifier; PostWorks minor 325, NCL minor 325.
    pub const ONCE: Word = Word(565);
    /// `OPEN`: Modifier; APT-360 minor 50, APT4 minor 50, NCL minor 50.
    pub const OPEN: Word = Word(566);
    /// `OPNAME`: Post; CL text.
    pub const OPNAME: Word = Word(567);
    /// `OPPLOT`: Post; APT4.
    pub const OPPLOT: Word = Word(568);
    /// `OPSKIP`: Post; APT-360 1012, APT4 1012, PostWorks 1012, NCL 1012.
    pub const OPSKIP: Word = Word(569);
    /// `OPSTOP`: Post; APT-360 3, APT4 3, PostWorks 3, NCL 3.
    pub const OPSTOP: Word = Word(570);
    /// `OPTION`: Modifier; APT-360 minor 144, APT4 minor 144, PostWorks minor 144, NCL minor 144.
    pub const OPTION: Word = Word(571);
    /// `ORANGE`: Post; NCL 1101.
    pub const ORANGE: Word = Word(572);
    /// `ORIENT`: Modifier; PostWorks minor 246, NCL minor 246, IBM CL minor 199.
    pub const ORIENT: Word = Word(573);
    /// `ORIGIN`: Post; APT-360 1027, APT4 1027, PostWorks 1027, NCL 1027.
    pub const ORIGIN: Word = Word(574);
    /// `OSETNO`: Modifier; CL text minor.
    pub const OSETNO: Word = Word(575);
    /// `OUT`: Modifier; APT-360 minor 49, APT4 minor 49, PostWorks minor 49, NCL minor 653.
    pub const OUT: Word = Word(576);
    /// `OUTTOL`: Motion; APT-360 6000:5, APT4 6000:5, PostWorks 1080, NCL 1080.
    pub const OUTTOL: Word = Word(577);
    /// `OVPLOT`: Post; APT-360 1042, APT4 1042, NCL 1042.
    pub const OVPLOT: Word = Word(578);
    /// `PA`: Modifier; NCL minor 637.
    pub const PA: Word = Word(579);
    /// `PAINT`: Post; CL text.
    pub const PAINT: Word = Word(580);
    /// `PALLET`: Modifier; PostWorks minor 239, NCL minor 239, IBM CL minor 216.
    pub const PALLET: Word = Word(581);
    /// `PARAB`: Modifier; APT-360 minor 77, APT4 minor 77, PostWorks minor 77, NCL minor 77.
    pub const PARAB: Word = Word(582);
    /// `PARAM`: Modifier; APT4 minor.
    pub const PARAM: Word = Word(583);
    /// `PARAMS`: Modifier; PostWorks minor 934, NCL minor 934.
    pub const PARAMS: Word = Word(584);
    /// `PARELM`: Modifier; NCL minor 833.
    pub const PARELM: Word = Word(585);
    /// `PARLEL`: Modifier; APT-360 minor 17, APT4 minor 17, NCL minor 637.
    pub const PARLEL: Word = Word(586);
    /// `PARMF`: Function; APT4.
    pub const PARMF: Word = Word(587);
    /// `PARSRF`: Geometry; APT4.
    pub const PARSRF: Word = Word(588);
    /// `PART`: Modifier; APT-360 minor 166, APT4 minor 166, PostWorks minor 260, NCL minor 260.
    pub const PART: Word = Word(589);
    /// `PARTNO`: Text; APT-360 1045, APT4 1045, PostWorks 1045, NCL 1045.
    pub const PARTNO: Word = Word(590);
    /// `PASS`: Modifier; NCL minor 755.
    pub const PASS: Word = Word(591);
    /// `PAST`: Modifier; APT-360 minor 70, APT4 minor 70, PostWorks minor 70, NCL minor 715.
    pub const PAST: Word = Word(592);
    /// `PATCH`: Modifier; APT4 minor.
    pub const PATCH: Word = Word(593);
    /// `PATERN`: Geometry; APT-360 surface type 18, APT4 surface type 18, NCL 636.
    pub const PATERN: Word = Word(594);
    /// `PATH`: Modifier; APT4 minor, PostWorks minor 234.
    pub const PATH: Word = Word(595);
    /// `PBS`: Post; APT-360 1068, APT4 1068.
    pub const PBS: Word = Word(596);
    /// `PD`: Modifier; NCL minor 130.
    pub const PD: Word = Word(597);
    /// `PDS`: Modifier; APT4 minor.
    pub const PDS: Word = Word(598);
    /// `PE`: Modifier; NCL minor 630.
    pub const PE: Word = Word(599);
    /// `PEN`: Post and Modifier; APT-360 128, APT-360 minor 128, APT4 128, APT4 minor 128, PostWorks 128, PostWorks minor 128, NCL 128, NCL minor 128.
    pub const PEN: Word = Word(600);
    /// `PENDWN`: Post; APT-360 12, APT4 12, PostWorks 130, NCL 130, IBM CL 12.
    pub const PENDWN: Word = Word(601);
    /// `PENUP`: Post; APT-360 11, APT4 11, PostWorks 129, NCL 129, IBM CL 11.
    pub const PENUP: Word = Word(602);
    /// `PERCNT`: Modifier; NCL minor 763.
    pub const PERCNT: Word = Word(603);
    /// `PERIM`: Modifier; APT4 minor.
    pub const PERIM: Word = Word(604);
    /// `PERMIN`: Modifier; CL text minor.
    pub const PERMIN: Word = Word(605);
    /// `PERPTO`: Modifier; APT-360 minor 18, APT4 minor 18, PostWorks minor 18, NCL minor 630.
    pub const PERPTO: Word = Word(606);
    /// `PERREV`: Modifier; CL text minor.
    pub const PERREV: Word = Word(607);
    /// `PERSP`: Modifier; APT-360 minor 67.
    pub const PERSP: Word = Word(608);
    /// `PHANTM`: Modifier; NCL minor 916.
    pub const PHANTM: Word = Word(609);
    /// `PICKFD`: Modifier; APT4 minor.
    pub const PICKFD: Word = Word(610);
    /// `PICKUP`: Post; APT-360 9, APT4 9.
    pub const PICKUP: Word = Word(611);
    /// `PINK`: Post; NCL 1102.
    pub const PINK: Word = Word(612);
    /// `PITCH`: Post and Modifier; APT-360 1050, APT4 1050, APT4 minor 67, PostWorks 1050, NCL 1050.
    pub const PITCH: Word = Word(613);
    /// `PIVOT`: Modifier; APT4 minor.
    pub const PIVOT: Word = Word(614);
    /// `PIVOTZ`: Post; APT-360 1017, APT4 1017, PostWorks 1017, NCL 1017.
    pub const PIVOTZ: Word = Word(615);
    /// `PL`: Geometry; NCL minor 606.
    pub const PL: Word = Word(616);
    /// `PLABEL`: Post; APT-360 1061, APT4 1061, PostWorks 1061, NCL 1061.
    pub const PLABEL: Word = Word(617);
    /// `PLACE`: Modifier; NCL minor 878.
    pub const PLACE: Word = Word(618);
    /// `PLANE`: Geometry; APT-360 surface type 3, APT4 surface type 3, NCL 606.
    pub const PLANE: Word = Word(619);
    /// `PLANO`: Modifier; APT4 minor.
    pub const PLANO: Word = Word(620);
    /// `PLOT`: Post; APT-360 1041, APT4 1041, PostWorks 1041.
    pub const PLOT: Word = Word(621);
    /// `PLOTFT`: Regional; APT4.
    pub const PLOTFT: Word = Word(622);
    /// `PLUNGE`: Post; APT-360 1001, APT4 1001, PostWorks 1001, NCL 1001.
    pub const PLUNGE: Word = Word(623);
    /// `PLUS`: Modifier; APT-360 minor 19, APT4 minor 19, PostWorks minor 19, NCL minor 19.
    pub const PLUS: Word = Word(624);
    /// `PMILL`: Post; NCL 1051.
    pub const PMILL: Word = Word(625);
    /// `PN`: Geometry; NCL minor 636.
    pub const PN: Word = Word(626);
    /// `PNTSON`: Modifier; APT4 minor.
    pub const PNTSON: Word = Word(627);
    /// `PNTVEC`: Modifier; APT4 minor, NCL minor 613.
    pub const PNTVEC: Word = Word(628);
    /// `POCKET`: Motion; APT-360 11000:1, APT4 11000:1, NCL 738.
    pub const POCKET: Word = Word(629);
    /// `POD`: Post; PostWorks 1088, NCL 1088.
    pub const POD: Word = Word(630);
    /// `PODDEF`: Modifier; NCL minor 747.
    pub const PODDEF: Word = Word(631);
    /// `PODPTS`: Modifier; NCL minor 746.
    pub const PODPTS: Word = Word(632);
    /// `POINT`: Geometry; APT-360 surface type 1, APT4 surface type 1, NCL 603.
    pub const POINT: Word = Word(633);
    /// `POKMOD`: Modifier; NCL minor 749.
    pub const POKMOD: Word = Word(634);
    /// `POLCON`: Geometry; APT-360 surface type 15, APT4 surface type 15.
    pub const POLCON: Word = Word(635);
    /// `POLYGN`: Modifier; APT4 minor.
    pub const POLYGN: Word = Word(636);
    /// `POSCAL`: Post; PostWorks 1109.
    pub const POSCAL: Word = Word(637);
    /// `POSITN`: Post; PostWorks 1072, NCL 1072.
    pub const POSITN: Word = Word(638);
    /// `POSMAP`: Post; APT4 1068, PostWorks 1034, NCL 1068, IBM CL 24.
    pub const POSMAP: Word = Word(639);
    /// `POSN`: Modifier; APT4 minor.
    pub const POSN: Word = Word(640);
    /// `POSTN`: Post; APT-360 1024, APT4 1024, PostWorks 1024, NCL 1024.
    pub const POSTN: Word = Word(641);
    /// `POSX`: Modifier; APT-360 minor 20, APT4 minor 20, PostWorks minor 20, NCL minor 654.
    pub const POSX: Word = Word(642);
    /// `POSY`: Modifier; APT-360 minor 21, APT4 minor 21, PostWorks minor 21, NCL minor 655.
    pub const POSY: Word = Word(643);
    /// `POSZ`: Modifier; APT-360 minor 22, APT4 minor 22, PostWorks minor 22, NCL minor 656.
    pub const POSZ: Word = Word(644);
    /// `PPLOT`: Post; APT-360 1014, APT4 1014, PostWorks 1014, NCL 1014.
    pub const PPLOT: Word = Word(645);
    /// `PPOPTN`: Control; APT4.
    pub const PPOPTN: Word = Word(646);
    /// `PPRINT`: Text; APT-360 1044, APT4 1044, PostWorks 1044, NCL 1044.
    pub const PPRINT: Word = Word(647);
    /// `PPS`: Modifier; APT4 minor.
    pub const PPS: Word = Word(648);
    /// `PPTOL`: Post; PostWorks 1068, NCL 1069.
    pub const PPTOL: Word = Word(649);
    /// `PPUNCH`: Post; PostWorks 1086.
    pub const PPUNCH: Word = Word(650);
    /// `PPWORD`: Post; CL text.
    pub const PPWORD: Word = Word(651);
    /// `PREFUN`: Post; APT-360 1048, APT4 1048, PostWorks 1048, NCL 1048.
    pub const PREFUN: Word = Word(652);
    /// `PRINT`: Control; APT-360, APT4, PostWorks 1102, NCL 817.
    pub const PRINT: Word = Word(653);
    /// `PRINTF`: Post; PostWorks 1104.
    pub const PRINTF: Word = Word(654);
    /// `PROBE`: Post; PostWorks 1081, NCL 1081.
    pub const PROBE: Word = Word(655);
    /// `PROBX`: Post; APT-360 19, APT4 19.
    pub const PROBX: Word = Word(656);
    /// `PROBY`: Post; APT-360 18, APT4 18.
    pub const PROBY: Word = Word(657);
    /// `PROFIL`: Post; PostWorks 761, NCL 761.
    pub const PROFIL: Word = Word(658);
    /// `PROJCT`: Modifier; NCL minor 888.
    pub const PROJCT: Word = Word(659);
    /// `PROMPT`: Modifier; NCL minor 935.
    pub const PROMPT: Word = Word(660);
    /// `PS`: Modifier; APT4 minor, PostWorks minor 728, NCL minor 728.
    pub const PS: Word = Word(661);
    /// `PSEUDO`: Modifier; NCL minor 762.
    pub const PSEUDO: Word = Word(662);
    /// `PSIS`: Motion; APT-360 3000:4, APT4 3000:4, NCL 713.
    pub const PSIS: Word = Word(663);
    /// `PSTAN`: Modifier; APT-360 minor 146, APT4 minor 146, NCL minor 729.
    pub const PSTAN: Word = Word(664);
    /// `PSTERR`: Post; PostWorks 1107.
    pub const PSTERR: Word = Word(665);
    /// `PSUV`: Motion; NCL minor 857.
    pub const PSUV: Word = Word(666);
    /// `PT`: Geometry; NCL minor 603.
    pub const PT: Word = Word(667);
    /// `PTNORM`: Modifier; APT-360 minor 104, APT4 minor 104.
    pub const PTNORM: Word = Word(668);
    /// `PTONLY`: Control; APT-360, APT4.
    pub const PTONLY: Word = Word(669);
    /// `PTSLOP`: Modifier; APT-360 minor 103, APT4 minor 103.
    pub const PTSLOP: Word = Word(670);
    /// `PU`: Modifier; NCL minor 129.
    pub const PU: Word = Word(671);
    /// `PUNCH`: Control; APT-360, APT4.
    pub const PUNCH: Word = Word(672);
    /// `PURPLE`: Post; NCL 1103.
    pub const PURPLE: Word = Word(673);
    /// `PUT`: Modifier; NCL minor 828.
    pub const PUT: Word = Word(674);
    /// `PV`: Modifier; NCL minor 613.
    pub const PV: Word = Word(675);
    /// `PVAL`: Modifier; APT4 minor.
    pub const PVAL: Word = Word(676);
    /// `QADRIC`: Geometry; APT-360 surface type 14, APT4 surface type 14.
    pub const QADRIC: Word = Word(677);
    /// `QAXIS`: Post; PostWorks 1089, NCL 1089.
    pub const QAXIS: Word = Word(678);
    /// `QUILL`: Modifier; PostWorks minor 287, NCL minor 287, IBM CL minor 212.
    pub const QUILL: Word = Word(679);
    /// `QUILT`: Modifier; NCL minor 837.
    pub const QUILT: Word = Word(680);
    /// `RA`: Modifier; NCL minor 23.
    pub const RA: Word = Word(681);
    /// `RADIAL`: Modifier; NCL minor 893.
    pub const RADIAL: Word = Word(682);
    /// `RADIUS`: Modifier; APT-360 minor 23, APT4 minor 23, PostWorks minor 23, NCL minor 23.
    pub const RADIUS: Word = Word(683);
    /// `RAIL`: Modifier; APT-360 minor 93, APT4 minor 93.
    pub const RAIL: Word = Word(684);
    /// `RAM`: Modifier; PostWorks minor 500, NCL minor 500, IBM CL minor 143.
    pub const RAM: Word = Word(685);
    /// `RAMP`: Modifier; PostWorks minor 854, NCL minor 854.
    pub const RAMP: Word = Word(686);
    /// `RANDOM`: Modifier; APT-360 minor 174, APT4 minor 147, PostWorks minor 183, NCL minor 326.
    pub const RANDOM: Word = Word(687);
    /// `RANGE`: Modifier; APT-360 minor 145, APT4 minor 145, PostWorks minor 145, NCL minor 145.
    pub const RANGE: Word = Word(688);
    /// `RAPID`: Post; APT-360 5, APT4 5, PostWorks 5, NCL 5.
    pub const RAPID: Word = Word(689);
    /// `RAPTO`: Modifier; PostWorks minor 280, NCL minor 280, IBM CL minor 211, CL text minor.
    pub const RAPTO: Word = Word(690);
    /// `RE`: Modifier; NCL minor 7.
    pub const RE: Word = Word(691);
    /// `READ`: Control; APT-360, APT4, NCL 876.
    pub const READ: Word = Word(692);
    /// `REAL`: Control; APT4.
    pub const REAL: Word = Word(693);
    /// `REAM`: Modifier; APT-360 minor 167, APT4 minor 167, PostWorks minor 262, NCL minor 262, IBM CL minor 167.
    pub const REAM: Word = Word(694);
    /// `REAR`: Modifier; APT-360 minor 149, APT4 minor 149, PostWorks minor 149, NCL minor 149.
    pub const REAR: Word = Word(695);
    /// `RED`: Modifier; APT-360 minor 131, APT4 minor 131, NCL minor 907.
    pub const RED: Word = Word(696);
    /// `REDEF`: Modifier; NCL minor 840.
    pub const REDEF: Word = Word(697);
    /// `REDRAW`: Modifier; NCL minor 924.
    pub const REDRAW: Word = Word(698);
    /// `REFSYS`: Control; APT-360, APT4, NCL 644.
    pub const REFSYS: Word = Word(699);
    /// `REGBRK`: Post; APT-360 1069, APT4 1069.
    pub const REGBRK: Word = Word(700);
    /// `REGION`: Regional; APT4.
    pub const REGION: Word = Word(701);
    /// `REGORD`: Post; PostWorks 1110.
    pub const REGORD: Word = Word(702);
    /// `REGTOL`: Modifier; APT4 minor 171.
    pub const REGTOL: Word = Word(703);
    /// `RELTOL`: Modifier; APT4 minor.
    pub const RELTOL: Word = Word(704);
    /// `REMARK`: Text; APT-360, APT4, NCL 1091.
    pub const REMARK: Word = Word(705);
    /// `REMOVE`: Modifier; PostWorks minor 843, NCL minor 843.
    pub const REMOVE: Word = Word(706);
    /// `RENAME`: Modifier; NCL minor 869.
    pub const RENAME: Word = Word(707);
    /// `REPEAT`: Post; PostWorks 1083, NCL 1083.
    pub const REPEAT: Word = Word(708);
    /// `RESERV`: Control; APT-360, APT4, NCL 805.
    pub const RESERV: Word = Word(709);
    /// `RESET`: Post; APT-360 15, APT4 15, PostWorks 15, NCL 15.
    pub const RESET: Word = Word(710);
    /// `RESTOR`: Modifier; NCL minor 583.
    pub const RESTOR: Word = Word(711);
    /// `RETAIN`: Modifier; APT-360 minor 171, APT4 minor 184, PostWorks minor 184, NCL minor 329, IBM CL minor 171.
    pub const RETAIN: Word = Word(712);
    /// `RETR`: Modifier; APT4 minor.
    pub const RETR: Word = Word(713);
    /// `RETRCT`: Post; APT-360 7, APT4 7, PostWorks 7, NCL 7.
    pub const RETRCT: Word = Word(714);
    /// `RETURN`: Modifier; NCL minor 322, CL text minor.
    pub const RETURN: Word = Word(715);
    /// `REV`: Modifier; APT-360 minor 97, APT4 minor 97, PostWorks minor 97, NCL minor 97.
    pub const REV: Word = Word(716);
    /// `REVERS`: Post; APT-360 1008, APT4 1008, PostWorks 1008, NCL 1008.
    pub const REVERS: Word = Word(717);
    /// `REVOLV`: Modifier; APT4 minor, NCL minor 861.
    pub const REVOLV: Word = Word(718);
    /// `REWIND`: Post; APT-360 1006, APT4 1006, PostWorks 1006, NCL 1006.
    pub const REWIND: Word = Word(719);
    /// `RIGHT`: Modifier; APT-360 minor 24, APT4 minor 24, PostWorks minor 24, NCL minor 24.
    pub const RIGHT: Word = Word(720);
    /// `RINDEX`: Function; NCL minor 574.
    pub const RINDEX: Word = Word(721);
    /// `RLDSRF`: Geometry; APT-360 surface type 53, APT4 surface type 53.
    pub const RLDSRF: Word = Word(722);
    /// `RMILL`: Modifier; NCL minor 750.
    pub const RMILL: Word = Word(723);
    /// `RO`: Post; NCL 1026.
    pub const RO: Word = Word(724);
    /// `ROTABL`: Post; APT-360 1026, APT4 1026, PostWorks 1026, NCL 1026.
    pub const ROTABL: Word = Word(725);
    /// `ROTATE`: Post; PostWorks 1066, NCL 1066, IBM CL 1076.
    pub const ROTATE: Word = Word(726);
    /// `ROTHED`: Post; APT-360 1035, APT4 1035, PostWorks 1035, NCL 1035.
    pub const ROTHED: Word = Word(727);
    /// `ROTREF`: Modifier; APT-360 minor 68, APT4 minor 68, PostWorks minor 68, NCL minor 68.
    pub const ROTREF: Word = Word(728);
    /// `ROUGH`: Modifier; PostWorks minor 320, NCL minor 320, IBM CL minor 247.
    pub const ROUGH: Word = Word(729);
    /// `ROUTE`: Modifier; PostWorks minor 1205, NCL minor 1205.
    pub const ROUTE: Word = Word(730);
    /// `RP`: Modifier; NCL minor 5.
    pub const RP: Word = Word(731);
    /// `RPM`: Modifier; APT-360 minor 78, APT4 minor 78, PostWorks minor 78, NCL minor 78.
    pub const RPM: Word = Word(732);
    /// `RS`: Control; NCL minor 644.
    pub const RS: Word = Word(733);
    /// `RT`: Modifier; NCL minor 24.
    pub const RT: Word = Word(734);
    /// `RTHETA`: Modifier; APT-360 minor 106, APT4 minor 106.
    pub const RTHETA: Word = Word(735);
    /// `RTRCTO`: Modifier; PostWorks minor 295, NCL minor 295, CL text minor.
    pub const RTRCTO: Word = Word(736);
    /// `RULED`: Modifier; APT4 minor.
    pub const RULED: Word = Word(737);
    /// `SADDLE`: Modifier; APT-360 minor 150, APT4 minor 150, PostWorks minor 150, NCL minor 150.
    pub const SADDLE: Word = Word(738);
    /// `SAFETY`: Post; APT-360 1028, APT4 1028, PostWorks 1028, NCL 1028.
    pub const SAFETY: Word = Word(739);
    /// `SAME`: Modifier; APT-360 minor 54, APT4 minor 54, PostWorks minor 54, NCL minor 730.
    pub const SAME: Word = Word(740);
    /// `SAVE`: Modifier; NCL minor 582.
    pub const SAVE: Word = Word(741);
    /// `SAVEU`: Modifier; NCL minor 848.
    pub const SAVEU: Word = Word(742);
    /// `SAVMDI`: Modifier; APT4 minor 398.
    pub const SAVMDI: Word = Word(743);
    /// `SAVTDI`: Modifier; APT4 minor 396.
    pub const SAVTDI: Word = Word(744);
    /// `SCALAR`: Modifier; APT4 minor, NCL minor 601.
    pub const SCALAR: Word = Word(745);
    /// `SCALE`: Modifier; APT-360 minor 25, APT4 minor 25, PostWorks minor 25, NCL minor 25.
    pub const SCALE: Word = Word(746);
    /// `SCALOP`: Modifier; APT4 minor.
    pub const SCALOP: Word = Word(747);
    /// `SCON`: Regional; APT4.
    pub const SCON: Word = Word(748);
    /// `SCRIBE`: Modifier; APT-360 minor 129, APT4 minor 129.
    pub const SCRIBE: Word = Word(749);
    /// `SCRUB`: Modifier; NCL minor 739.
    pub const SCRUB: Word = Word(750);
    /// `SCURV`: Geometry; APT4.
    pub const SCURV: Word = Word(751);
    /// `SEAGRN`: Modifier; NCL minor 915.
    pub const SEAGRN: Word = Word(752);
    /// `SEC1`: Modifier; APT-360 minor.
    pub const SEC1: Word = Word(753);
    /// `SEC2`: Modifier; APT-360 minor.
    pub const SEC2: Word = Word(754);
    /// `SEG`: Modifier; APT4 minor.
    pub const SEG: Word = Word(755);
    /// `SELCTL`: Post; APT-360 1056, APT4 1056, PostWorks 1056, NCL 1056.
    pub const SELCTL: Word = Word(756);
    /// `SELECT`: Post; PostWorks 1074, NCL 1074, IBM CL 1034.
    pub const SELECT: Word = Word(757);
    /// `SEQNO`: Post; APT-360 1019, APT4 1019, PostWorks 1019, NCL 1019.
    pub const SEQNO: Word = Word(758);
    /// `SEQUNC`: Control; PostWorks 818, NCL 818.
    pub const SEQUNC: Word = Word(759);
    /// `SET`: Post; PostWorks 1087, NCL 1087, IBM CL 1076.
    pub const SET: Word = Word(760);
    /// `SETANG`: Modifier; APT-360 minor 156, APT4 minor 156.
    pub const SETANG: Word = Word(761);
    /// `SETOOL`: Modifier; APT-360 minor 155, APT4 minor 155.
    pub const SETOOL: Word = Word(762);
    /// `SETUP`: Post; CL text.
    pub const SETUP: Word = Word(763);
    /// `SF`: Modifier; NCL minor 609.
    pub const SF: Word = Word(764);
    /// `SFM`: Post and Modifier; APT-360 minor 115, APT4 minor 115, APT4, PostWorks minor 115, NCL minor 115.
    pub const SFM: Word = Word(765);
    /// `SH`: Modifier; NCL minor 602.
    pub const SH: Word = Word(766);
    /// `SHADE`: Modifier; NCL minor 578.
    pub const SHADE: Word = Word(767);
    /// `SHANK`: Modifier; PostWorks minor 192, NCL minor 192.
    pub const SHANK: Word = Word(768);
    /// `SHAPE`: Modifier; NCL minor 602.
    pub const SHAPE: Word = Word(769);
    /// `SHARP`: Modifier; NCL minor 183.
    pub const SHARP: Word = Word(770);
    /// `SHIFT`: Modifier; PostWorks minor 249, NCL minor 249.
    pub const SHIFT: Word = Word(771);
    /// `SHO`: Modifier; NCL minor 740.
    pub const SHO: Word = Word(772);
    /// `SHORT`: Modifier; PostWorks minor 851, NCL minor 851.
    pub const SHORT: Word = Word(773);
    /// `SIDE`: Modifier; APT-360 minor 94, APT4 minor 94, PostWorks minor 94, NCL minor 94.
    pub const SIDE: Word = Word(774);
    /// `SIGNF`: Function; APT4, NCL minor 572.
    pub const SIGNF: Word = Word(775);
    /// `SIN`: Function; NCL minor 557.
    pub const SIN: Word = Word(776);
    /// `SINB`: Function; APT4.
    pub const SINB: Word = Word(777);
    /// `SINF`: Function; APT-360, APT4, NCL minor 557.
    pub const SINF: Word = Word(778);
    /// `SINGLE`: Modifier; NCL minor 926.
    pub const SINGLE: Word = Word(779);
    /// `SINHF`: Function; APT4.
    pub const SINHF: Word = Word(780);
    /// `SIX`: Modifier; NCL minor 930.
    pub const SIX: Word = Word(781);
    /// `SIZE`: Modifier; PostWorks minor 196, NCL minor 196.
    pub const SIZE: Word = Word(782);
    /// `SKIP`: Modifier; PostWorks minor 178.
    pub const SKIP: Word = Word(783);
    /// `SLICE`: Modifier; PostWorks minor 804.
    pub const SLICE: Word = Word(784);
    /// `SLOPE`: Modifier; APT-360 minor 47, APT4 minor 47, PostWorks minor 47, NCL minor 629.
    pub const SLOPE: Word = Word(785);
    /// `SLOT`: Modifier; NCL minor 207.
    pub const SLOT: Word = Word(786);
    /// `SLOWDN`: Post; APT-360 1063, APT4 1063, PostWorks 1063, NCL 1063.
    pub const SLOWDN: Word = Word(787);
    /// `SMALL`: Modifier; APT-360 minor 26, APT4 minor 26, PostWorks minor 26, NCL minor 663.
    pub const SMALL: Word = Word(788);
    /// `SMESH`: Modifier; APT4 minor.
    pub const SMESH: Word = Word(789);
    /// `SMIL`: Regional; APT4.
    pub const SMIL: Word = Word(790);
    /// `SMILL`: Modifier; NCL minor 756.
    pub const SMILL: Word = Word(791);
    /// `SMM`: Modifier; PostWorks minor 505, NCL minor 505, CL text minor.
    pub const SMM: Word = Word(792);
    /// `SMOOTH`: Post; PostWorks 1085, NCL 1085.
    pub const SMOOTH: Word = Word(793);
    /// `SOLID`: Modifier; APT-360 minor 123, APT4 minor 123, PostWorks minor 123, NCL minor 123, IBM CL minor 189.
    pub const SOLID: Word = Word(794);
    /// `SP`: Post; NCL 1031.
    pub const SP: Word = Word(795);
    /// `SPACE`: Modifier; NCL minor 944.
    pub const SPACE: Word = Word(796);
    /// `SPATF`: Function; APT4.
    pub const SPATF: Word = Word(797);
    /// `SPEED`: Modifier; PostWorks minor 272.
    pub const SPEED: Word = Word(798);
    /// `SPHERE`: Geometry and Modifier; APT-360 surface type 13, APT4 surface type 13, PostWorks minor 631, NCL minor 631.
    pub const SPHERE: Word = Word(799);
    /// `SPINDL`: Post; APT-360 1031, APT4 1031, PostWorks 1031, NCL 1031.
    pub const SPINDL: Word = Word(800);
    /// `SPIRAL`: Modifier; APT4 minor 175.
    pub const SPIRAL: Word = Word(801);
    /// `SPLINE`: Modifier; APT-360 minor 105, APT4 minor 105, PostWorks minor 628, NCL minor 628.
    pub const SPLINE: Word = Word(802);
    /// `SQRT`: Function; NCL minor 555.
    pub const SQRT: Word = Word(803);
    /// `SQRTF`: Function; APT-360, APT4.
    pub const SQRTF: Word = Word(804);
    /// `SQUARE`: Modifier; NCL minor 955.
    pub const SQUARE: Word = Word(805);
    /// `SRFTYP`: Modifier; NCL minor 875.
    pub const SRFTYP: Word = Word(806);
    /// `SRFVCT`: Motion; APT-360 5000:8, APT4 5000:8, NCL 857.
    pub const SRFVCT: Word = Word(807);
    /// `SSPLIN`: Modifier; NCL minor 619.
    pub const SSPLIN: Word = Word(808);
    /// `SSPRT`: Modifier; APT4 minor.
    pub const SSPRT: Word = Word(809);
    /// `SSTEST`: Modifier; APT4 minor.
    pub const SSTEST: Word = Word(810);
    /// `SSURF`: Geometry; APT4.
    pub const SSURF: Word = Word(811);
    /// `STACK`: Modifier; NCL minor 927.
    pub const STACK: Word = Word(812);
    /// `STAR`: Modifier; NCL minor 953.
    pub const STAR: Word = Word(813);
    /// `START`: Modifier; APT-360 minor 57, APT4 minor 57, PostWorks minor 57, NCL minor 57.
    pub const START: Word = Word(814);
    /// `STAT`: Modifier; NCL minor 864.
    pub const STAT: Word = Word(815);
    /// `STD`: Modifier; NCL minor 920.
    pub const STD: Word = Word(816);
    /// `STEP`: Modifier; APT-360 minor 92, APT4 minor 92, PostWorks minor 92, NCL minor 92.
    pub const STEP: Word = Word(817);
    /// `STEPOV`: Modifier; APT4 minor.
    pub const STEPOV: Word = Word(818);
    /// `STL`: Modifier; PostWorks minor 330, NCL minor 330.
    pub const STL: Word = Word(819);
    /// `STOCK`: Post and Modifier; PostWorks minor 321, NCL minor 321.
    pub const STOCK: Word = Word(820);
    /// `STOP`: Post; APT-360 2, APT4 2, PostWorks 2, NCL 2.
    pub const STOP: Word = Word(821);
    /// `STRCMP`: Function; NCL minor 581.
    pub const STRCMP: Word = Word(822);
    /// `STRING`: Modifier; NCL minor 945.
    pub const STRING: Word = Word(823);
    /// `STROKE`: Modifier; NCL minor 946.
    pub const STROKE: Word = Word(824);
    /// `STRTPT`: Modifier; NCL minor 665.
    pub const STRTPT: Word = Word(825);
    /// `STYLE`: Modifier; NCL minor 948.
    pub const STYLE: Word = Word(826);
    /// `SUBPECK`: Modifier; CL text minor.
    pub const SUBPECK: Word = Word(827);
    /// `SUBSCR`: Control; APT4.
    pub const SUBSCR: Word = Word(828);
    /// `SUBSTR`: Function; NCL minor 580.
    pub const SUBSTR: Word = Word(829);
    /// `SURF`: Modifier; NCL minor 609.
    pub const SURF: Word = Word(830);
    /// `SVAL`: Modifier; APT4 minor.
    pub const SVAL: Word = Word(831);
    /// `SWAP`: Modifier; NCL minor 111.
    pub const SWAP: Word = Word(832);
    /// `SWITCH`: Post; APT-360 6, APT4 6, PostWorks 6.
    pub const SWITCH: Word = Word(833);
    /// `SYMBOL`: Modifier; PostWorks minor 235, NCL minor 877.
    pub const SYMBOL: Word = Word(834);
    /// `SYN`: Control; APT-360, APT4, NCL 804.
    pub const SYN: Word = Word(835);
    /// `TA`: Modifier; APT4 minor, NCL minor 721.
    pub const TA: Word = Word(836);
    /// `TABCYL`: Geometry; APT-360 surface type 50, APT4 surface type 50.
    pub const TABCYL: Word = Word(837);
    /// `TABLE`: Modifier; PostWorks minor 177, NCL minor 177, IBM CL minor 224.
    pub const TABLE: Word = Word(838);
    /// `TABPRT`: Modifier; APT4 minor.
    pub const TABPRT: Word = Word(839);
    /// `TAN`: Function; NCL minor 554.
    pub const TAN: Word = Word(840);
    /// `TANB`: Function; APT4.
    pub const TANB: Word = Word(841);
    /// `TANCRV`: Control; APT-360.
    pub const TANCRV: Word = Word(842);
    /// `TANDS`: Modifier; APT-360 minor 183.
    pub const TANDS: Word = Word(843);
    /// `TANF`: Function; APT-360, APT4, NCL minor 554.
    pub const TANF: Word = Word(844);
    /// `TANHF`: Function; APT4.
    pub const TANHF: Word = Word(845);
    /// `TANON`: Modifier; APT-360 minor 109, APT4 minor 109.
    pub const TANON: Word = Word(846);
    /// `TANSPL`: Modifier; APT4 minor.
    pub const TANSPL: Word = Word(847);
    /// `TANTO`: Modifier; APT-360 minor 27, APT4 minor 27, PostWorks minor 27, NCL minor 646.
    pub const TANTO: Word = Word(848);
    /// `TAP`: Modifier; APT-360 minor 168, APT4 minor 168, PostWorks minor 168, NCL minor 168.
    pub const TAP: Word = Word(849);
    /// `TAPEFT`: Modifier; NCL minor 660.
    pub const TAPEFT: Word = Word(850);
    /// `TAPKUL`: Modifier; APT-360 minor 91, APT4 minor 91.
    pub const TAPKUL: Word = Word(851);
    /// `TC`: Control; NCL minor 812.
    pub const TC: Word = Word(852);
    /// `TCP`: Post; CL text.
    pub const TCP: Word = Word(853);
    /// `TDATA`: Post; CL text.
    pub const TDATA: Word = Word(854);
    /// `TDIST`: Function; NCL minor 585.
    pub const TDIST: Word = Word(855);
    /// `TDISTF`: Function; NCL minor 585.
    pub const TDISTF: Word = Word(856);
    /// `TE`: Modifier; NCL minor 650.
    pub const TE: Word = Word(857);
    /// `TERMAC`: Control; APT-360, APT4, NCL 807.
    pub const TERMAC: Word = Word(858);
    /// `TEXTF`: Function; NCL minor 38.
    pub const TEXTF: Word = Word(859);
    /// `TH`: Motion; NCL minor 717.
    pub const TH: Word = Word(860);
    /// `THEN`: Modifier; NCL minor 938.
    pub const THEN: Word = Word(861);
    /// `THETAR`: Modifier; APT-360 minor 107, APT4 minor 107, PostWorks minor 107, NCL minor 107.
    pub const THETAR: Word = Word(862);
    /// `THICK`: Motion; APT-360 9000:5, APT4 9000:5, NCL 717.
    pub const THICK: Word = Word(863);
    /// `THREAD`: Post; APT-360 1036, APT4 1036, PostWorks 1036, NCL 1036.
    pub const THREAD: Word = Word(864);
    /// `THRU`: Modifier; APT-360 minor 152, APT4 minor 152, PostWorks minor 152, NCL minor 152.
    pub const THRU: Word = Word(865);
    /// `TILT`: Modifier; PostWorks minor 247.
    pub const TILT: Word = Word(866);
    /// `TIMES`: Modifier; APT-360 minor 28, APT4 minor 28, PostWorks minor 28, NCL minor 28.
    pub const TIMES: Word = Word(867);
    /// `TITLES`: Text; APT-360, APT4, PostWorks 1095, NCL 1092.
    pub const TITLES: Word = Word(868);
    /// `TL`: Motion; NCL minor 719.
    pub const TL: Word = Word(869);
    /// `TLAXIS`: Motion; APT-360 9000:1, APT4 9000:1, NCL 721.
    pub const TLAXIS: Word = Word(870);
    /// `TLDATA`: Post; PostWorks 1079, CL text.
    pub const TLDATA: Word = Word(871);
    /// `TLLFT`: Motion; APT-360 4000:1, APT4 4000:1, NCL 719.
    pub const TLLFT: Word = Word(872);
    /// `TLNDON`: Motion; APT-360 4000:3, APT4 4000:3.
    pub const TLNDON: Word = Word(873);
    /// `TLOFPS`: Motion; APT-360 4000:6, APT4 4000:6, NCL 725.
    pub const TLOFPS: Word = Word(874);
    /// `TLON`: Motion; APT-360 4000:3, APT4 4000:3, NCL 718.
    pub const TLON: Word = Word(875);
    /// `TLONPS`: Motion; APT-360 4000:5, APT4 4000:5, NCL 724.
    pub const TLONPS: Word = Word(876);
    /// `TLPROJ`: Regional; APT4.
    pub const TLPROJ: Word = Word(877);
    /// `TLRGT`: Motion; APT-360 4000:2, APT4 4000:2, NCL 720.
    pub const TLRGT: Word = Word(878);
    /// `TM`: Post; NCL 1005.
    pub const TM: Word = Word(879);
    /// `TMARK`: Post; APT-360 1005, APT4 1005, PostWorks 1005, NCL 1005.
    pub const TMARK: Word = Word(880);
    /// `TN`: Motion; NCL minor 718.
    pub const TN: Word = Word(881);
    /// `TO`: Modifier; APT-360 minor 69, APT4 minor 69, PostWorks minor 69, NCL minor 714.
    pub const TO: Word = Word(882);
    /// `TOLER`: Motion; APT-360 6000:2, APT4 6000:2, PostWorks 731, NCL 731.
    pub const TOLER: Word = Word(883);
    /// `TOOL`: Geometry and Modifier; APT-360 surface type 17, APT4 surface type 17, PostWorks minor 617, NCL minor 617, IBM CL minor 226.
    pub const TOOL: Word = Word(884);
    /// `TOOLNO`: Post; APT-360 1025, APT4 1025, PostWorks 1025, NCL 1025.
    pub const TOOLNO: Word = Word(885);
    /// `TOOLPN`: Post; PostWorks 1053, NCL 1053.
    pub const TOOLPN: Word = Word(886);
    /// `TORCH`: Modifier; PostWorks minor 172, NCL minor 175.
    pub const TORCH: Word = Word(887);
    /// `TORUS`: Modifier; PostWorks minor 627, NCL minor 627.
    pub const TORUS: Word = Word(888);
    /// `TP`: Modifier; APT4 minor.
    pub const TP: Word = Word(889);
    /// `TPI`: Modifier; APT-360 minor 143, APT4 minor 143, PostWorks minor 143, NCL minor 143.
    pub const TPI: Word = Word(890);
    /// `TPRINT`: Post; PostWorks 1047.
    pub const TPRINT: Word = Word(891);
    /// `TR`: Motion; NCL minor 720.
    pub const TR: Word = Word(892);
    /// `TRACUT`: Control; APT-360 1038, APT4 1038, PostWorks 1038, NCL 812.
    pub const TRACUT: Word = Word(893);
    /// `TRALST`: Modifier; NCL minor 842.
    pub const TRALST: Word = Word(894);
    /// `TRANS`: Post; APT-360 1037, APT4 1037, PostWorks 1037, NCL 1037.
    pub const TRANS: Word = Word(895);
    /// `TRANSL`: Modifier; APT-360 minor 29, APT4 minor 29, PostWorks minor 29, NCL minor 649.
    pub const TRANSL: Word = Word(896);
    /// `TRANTO`: Motion; APT-360 6000:7, APT4 6000:7.
    pub const TRANTO: Word = Word(897);
    /// `TRAV`: Modifier; APT-360 minor 154, APT4 minor 154, PostWorks minor 154, NCL minor 154.
    pub const TRAV: Word = Word(898);
    /// `TRAVED`: Modifier; APT4 minor 172.
    pub const TRAVED: Word = Word(899);
    /// `TRFORM`: Modifier; APT-360 minor 110, APT4 minor 110, PostWorks minor 110, NCL minor 110.
    pub const TRFORM: Word = Word(900);
    /// `TRIAN`: Modifier; NCL minor 954.
    pub const TRIAN: Word = Word(901);
    /// `TRNTYP`: Post; CL text.
    pub const TRNTYP: Word = Word(902);
    /// `TT`: Modifier; NCL minor 646.
    pub const TT: Word = Word(903);
    /// `TU`: Post; NCL 1033.
    pub const TU: Word = Word(904);
    /// `TUNEUP`: Control; APT-360, APT4.
    pub const TUNEUP: Word = Word(905);
    /// `TURN`: Modifier; APT-360 minor 80, APT4 minor 80, PostWorks minor 80, NCL minor 80.
    pub const TURN: Word = Word(906);
    /// `TURRET`: Post; APT-360 1033, APT4 1033, PostWorks 1033, NCL 1033.
    pub const TURRET: Word = Word(907);
    /// `TV`: Modifier; APT4 minor.
    pub const TV: Word = Word(908);
    /// `TVAL`: Modifier; APT4 minor.
    pub const TVAL: Word = Word(909);
    /// `TWOPT`: Modifier; APT-360 minor 102, APT4 minor 102.
    pub const TWOPT: Word = Word(910);
    /// `TYPE`: Modifier; APT-360 minor 98, APT4 minor 98, PostWorks minor 98, NCL minor 98.
    pub const TYPE: Word = Word(911);
    /// `TYPEF`: Function; NCL minor 98.
    pub const TYPEF: Word = Word(912);
    /// `UAXIS`: Post; PostWorks 1018, NCL 1018.
    pub const UAXIS: Word = Word(913);
    /// `UBFN`: Modifier; NCL minor 862.
    pub const UBFN: Word = Word(914);
    /// `UCONST`: Modifier; APT4 minor.
    pub const UCONST: Word = Word(915);
    /// `ULOCKX`: Post; APT-360 20, APT4 20.
    pub const ULOCKX: Word = Word(916);
    /// `UNDO`: Modifier; NCL minor 845.
    pub const UNDO: Word = Word(917);
    /// `UNIT`: Modifier and Control; APT-360 minor 30, APT4 minor 30, PostWorks minor 30, NCL minor 30, CL text.
    pub const UNIT: Word = Word(918);
    /// `UNITS`: Control; APT4 9000:9, PostWorks 841, NCL 841.
    pub const UNITS: Word = Word(919);
    /// `UNLOAD`: Post; APT-360 10, APT4 10, PostWorks 10, NCL 10.
    pub const UNLOAD: Word = Word(920);
    /// `UP`: Modifier; APT-360 minor 112, APT4 minor 112, PostWorks minor 112, NCL minor 112.
    pub const UP: Word = Word(921);
    /// `USONIC`: Post; PostWorks 1093, NCL 1093.
    pub const USONIC: Word = Word(922);
    /// `UVAL`: Modifier; APT4 minor.
    pub const UVAL: Word = Word(923);
    /// `UVPDS`: Modifier; APT4 minor.
    pub const UVPDS: Word = Word(924);
    /// `UVPPS`: Modifier; APT4 minor.
    pub const UVPPS: Word = Word(925);
    /// `VACUUM`: Post; PostWorks 1094, NCL 1094.
    pub const VACUUM: Word = Word(926);
    /// `VAXIS`: Post; NCL 1032.
    pub const VAXIS: Word = Word(927);
    /// `VCONST`: Modifier; APT4 minor.
    pub const VCONST: Word = Word(928);
    /// `VE`: Geometry; NCL minor 604.
    pub const VE: Word = Word(929);
    /// `VECTOR`: Geometry; APT-360 surface type 11, APT4 surface type 11, PostWorks 604, NCL 604.
    pub const VECTOR: Word = Word(930);
    /// `VIEW`: Modifier; NCL minor 923.
    pub const VIEW: Word = Word(931);
    /// `VISIBL`: Post; NCL 1095.
    pub const VISIBL: Word = Word(932);
    /// `VMP3AX`: Modifier; NCL minor 962.
    pub const VMP3AX: Word = Word(933);
    /// `VMP5AX`: Post; NCL 1022.
    pub const VMP5AX: Word = Word(934);
    /// `VMPMOD`: Modifier; NCL minor 764.
    pub const VMPMOD: Word = Word(935);
    /// `VMPOCK`: Modifier; NCL minor 765.
    pub const VMPOCK: Word = Word(936);
    /// `VOCABF`: Function; NCL minor 549.
    pub const VOCABF: Word = Word(937);
    /// `VTLAXS`: Control; APT-360 1070, APT4 1070.
    pub const VTLAXS: Word = Word(938);
    /// `VVAL`: Modifier; APT4 minor.
    pub const VVAL: Word = Word(939);
    /// `WARN`: Modifier; NCL minor 852.
    pub const WARN: Word = Word(940);
    /// `WATRLN`: Modifier; NCL minor 892.
    pub const WATRLN: Word = Word(941);
    /// `WAXIS`: Post; NCL 1096.
    pub const WAXIS: Word = Word(942);
    /// `WCORN`: Control; APT-360 1071, APT4 1071.
    pub const WCORN: Word = Word(943);
    /// `WEIGHT`: Modifier; APT4 minor.
    pub const WEIGHT: Word = Word(944);
    /// `WHITE`: Modifier; NCL minor 905.
    pub const WHITE: Word = Word(945);
    /// `WIRE`: Post; NCL 1028.
    pub const WIRE: Word = Word(946);
    /// `WITH`: Modifier; APT4 minor.
    pub const WITH: Word = Word(947);
    /// `WORLD`: Modifier; CL text minor.
    pub const WORLD: Word = Word(948);
    /// `WRAP`: Modifier; NCL minor 889.
    pub const WRAP: Word = Word(949);
    /// `WRTMDI`: Post; APT4 1051.
    pub const WRTMDI: Word = Word(950);
    /// `XAXIS`: Modifier; APT-360 minor 84, APT4 minor 84, PostWorks minor 84, NCL minor 84.
    pub const XAXIS: Word = Word(951);
    /// `XCOORD`: Modifier; APT-360 minor 116, APT4 minor 116, PostWorks minor 116, NCL minor 116.
    pub const XCOORD: Word = Word(952);
    /// `XL`: Modifier; NCL minor 638.
    pub const XL: Word = Word(953);
    /// `XLARGE`: Modifier; APT-360 minor 31, APT4 minor 31, PostWorks minor 31, NCL minor 638.
    pub const XLARGE: Word = Word(954);
    /// `XOFSET`: Post; PostWorks 1084.
    pub const XOFSET: Word = Word(955);
    /// `XS`: Modifier; NCL minor 641.
    pub const XS: Word = Word(956);
    /// `XSMALL`: Modifier; APT-360 minor 32, APT4 minor 32, PostWorks minor 32, NCL minor 641.
    pub const XSMALL: Word = Word(957);
    /// `XTYPE`: Modifier; NCL minor 99.
    pub const XTYPE: Word = Word(958);
    /// `XTYPEF`: Function; NCL minor 99.
    pub const XTYPEF: Word = Word(959);
    /// `XYPLAN`: Modifier; APT-360 minor 33, APT4 minor 33, PostWorks minor 33, NCL minor 33.
    pub const XYPLAN: Word = Word(960);
    /// `XYROT`: Modifier; APT-360 minor 34, APT4 minor 34, PostWorks minor 34, NCL minor 733.
    pub const XYROT: Word = Word(961);
    /// `XYVIEW`: Modifier; APT-360 minor 120, APT4 minor 120.
    pub const XYVIEW: Word = Word(962);
    /// `XYZ`: Modifier; APT-360 minor 108, APT4 minor 108, PostWorks minor 108.
    pub const XYZ: Word = Word(963);
    /// `XYZPLN`: Modifier; PostWorks minor 45, NCL minor 45.
    pub const XYZPLN: Word = Word(964);
    /// `YAXIS`: Modifier; APT-360 minor 85, APT4 minor 85, PostWorks minor 85, NCL minor 85.
    pub const YAXIS: Word = Word(965);
    /// `YCOORD`: Modifier; APT-360 minor 117, APT4 minor 117, PostWorks minor 117, NCL minor 117.
    pub const YCOORD: Word = Word(966);
    /// `YELLOW`: Modifier; NCL minor 910.
    pub const YELLOW: Word = Word(967);
    /// `YL`: Modifier; NCL minor 639.
    pub const YL: Word = Word(968);
    /// `YLARGE`: Modifier; APT-360 minor 35, APT4 minor 35, PostWorks minor 35, NCL minor 639.
    pub const YLARGE: Word = Word(969);
    /// `YS`: Modifier; NCL minor 642.
    pub const YS: Word = Word(970);
    /// `YSMALL`: Modifier; APT-360 minor 36, APT4 minor 36, PostWorks minor 36, NCL minor 642.
    pub const YSMALL: Word = Word(971);
    /// `YZPLAN`: Modifier; APT-360 minor 37, APT4 minor 37, PostWorks minor 37, NCL minor 37.
    pub const YZPLAN: Word = Word(972);
    /// `YZROT`: Modifier; APT-360 minor 38, APT4 minor 38, PostWorks minor 38, NCL minor 734.
    pub const YZROT: Word = Word(973);
    /// `YZVIEW`: Modifier; APT-360 minor 121, APT4 minor 121.
    pub const YZVIEW: Word = Word(974);
    /// `ZAXIS`: Modifier; APT-360 minor 86, APT4 minor 86, PostWorks minor 86, NCL minor 86.
    pub const ZAXIS: Word = Word(975);
    /// `ZCOORD`: Modifier; APT-360 minor 118, APT4 minor 118, PostWorks minor 118, NCL minor 118.
    pub const ZCOORD: Word = Word(976);
    /// `ZERO`: Post; APT-360 13, APT4 13.
    pub const ZERO: Word = Word(977);
    /// `ZIGZAG`: Modifier; APT-360 minor 170, APT4 minor 177, APT4 minor 185, PostWorks minor 170, NCL minor 170.
    pub const ZIGZAG: Word = Word(978);
    /// `ZL`: Modifier; NCL minor 640.
    pub const ZL: Word = Word(979);
    /// `ZLARGE`: Modifier; APT-360 minor 39, APT4 minor 39, PostWorks minor 39, NCL minor 640.
    pub const ZLARGE: Word = Word(980);
    /// `ZONE`: Modifier; NCL minor 760.
    pub const ZONE: Word = Word(981);
    /// `ZS`: Modifier; NCL minor 643.
    pub const ZS: Word = Word(982);
    /// `ZSMALL`: Modifier; APT-360 minor 40, APT4 minor 40, PostWorks minor 40, NCL minor 643.
    pub const ZSMALL: Word = Word(983);
    /// `ZSURF`: Control; APT-360, APT4, NCL 647.
    pub const ZSURF: Word = Word(984);
    /// `ZXPLAN`: Modifier; APT-360 minor 41, APT4 minor 41, PostWorks minor 41, NCL minor 41.
    pub const ZXPLAN: Word = Word(985);
    /// `ZXROT`: Modifier; APT-360 minor 42, APT4 minor 42, PostWorks minor 42, NCL minor 735.
    pub const ZXROT: Word = Word(986);
    /// `ZXVIEW`: Modifier; APT-360 minor 122, APT4 minor 122.
    pub const ZXVIEW: Word = Word(987);
}
