//! Statements by their major word: what every dialect shares.

use aptc_diagnostics::{Severity, codes};
use aptc_geometry::{Circle, Cutter, Vec3};
use smol_str::SmolStr;

use super::args::{self, Numbers};
use super::edit::{copy, index, matrix, tracut};
use super::motion::{COORDINATES, circle, godlta, goto, indir, motion, points};
use super::state::State;
use super::{catia, comments, couplets, fusion, nx, source};
use crate::{Arg, Clprnt, Dialect, Kind, Output, Units, restore};

/// Words whose statement is text to its end.
const TEXT_WORDS: [&[u8; 6]; 5] = [b"PARTNO", b"PPRINT", b"INSERT", b"REMARK", b"TITLES"];

/// Does a text word head the line?
pub(super) fn is_verbatim(line: &[u8]) -> bool {
    text_word(line).is_some_and(|(word, rest)| {
        // Creo goes on with `REMARK -> CSYS / ..` in further lines.
        let structured = word == "REMARK" && rest.trim_ascii_start().starts_with(b"->");
        !(structured && rest.trim_ascii_end().ends_with(b"$"))
    })
}

/// The text word at the head and the rest of the line.
pub(super) fn text_word(line: &[u8]) -> Option<(&'static str, &[u8])> {
    let line = line.trim_ascii_start();
    let head = line.get(..6)?;
    let word = TEXT_WORDS.iter().find(|w| head.eq_ignore_ascii_case(w.as_slice()))?;
    Some((std::str::from_utf8(word.as_slice()).expect("letters"), &line[6..]))
}

/// Takes a statement in.
pub(super) fn statement(state: &mut State, text: &[u8]) {
    let text = text.trim_ascii();
    if text.is_empty() {
        return;
    }
    if text.starts_with(b"->") {
        // A structured comment of several lines.
        if !super::creo::structured(state, text) {
            state.emit(Kind::Comment(args::text(text).into()));
        }
        return;
    }
    if let Some((word, rest)) = text_word(text) {
        return fixed_field(state, word, rest);
    }
    // In NX a point without its word may also stand behind RAPID or FEDRAT.
    if (state.in_goto || (state.dialect == Dialect::Nx && state.te.is_some()))
        && matches!(text[0], b'0'..=b'9' | b'-' | b'+' | b'.')
        && let Some(numbers) = args::all_numbers(text)
    {
        state.bare = true;
        goto(state, numbers.get(), false);
        state.bare = false;
        return;
    }
    let slash = memchr::memchr(b'/', text);
    let (head, rest) = slash.map_or((text, &b""[..]), |s| (&text[..s], &text[s + 1..]));
    let Some(word) = major(head) else { return joined(state, text, head, rest) };
    state.in_goto = matches!(word.as_str(), "GOTO" | "FROM");
    word_statement(state, text, &word, rest);
}

/// The major word of a head; `None` when it is not one word.
fn major(head: &[u8]) -> Option<SmolStr> {
    let head = head.trim_ascii();
    let inner_blank = head.iter().any(u8::is_ascii_whitespace);
    let letters = head
        .iter()
        .all(|b| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'-') || b.is_ascii_whitespace());
    let has_letter = head.iter().any(u8::is_ascii_alphabetic);
    if !letters || !has_letter || head.len() > 40 {
        return None;
    }
    let word = args::upper(head);
    // A word may be printed with blanks inside if it is known without them; else it is a sentence.
    let known = || is_known(&word);
    (!inner_blank || known() || matches!(word.as_str(), "TOOLPATH")).then_some(word)
}

/// Words that vendors use and no table has.
fn is_known(word: &str) -> bool {
    aptc_vocabulary::find(word).is_some()
        || matches!(
            word,
            "TOOLPATH"
                | "END-OF-PATH"
                | "TLDATA"
                | "MSYS"
                | "CSYS"
                | "MCS"
                | "UNIT"
                | "GOCCLW"
                | "GOCLW"
                | "HELICAL"
                | "NURBS"
                | "KNOT"
                | "CNTRL"
                | "PAINT"
                | "SETUP"
                | "TRNTYP"
                | "CSI_SET_EXTENSION_LENGTH"
                | "CSI_SET_FLUTE_LENGTH"
                | "CSI_TOOL_PATH"
                | "OPFEATSTART"
                | "OPFEATEND"
                | "MOVE_ATTRIB"
                | "OP_NAME"
                | "PART_OPE"
                | "PROGRAM"
                | "CATPROCESS"
                | "CATPRODUCT"
                | "MOVNRB"
                | "ISN"
                | "MOVE"
                | "PPFUN"
                | "OFSTNO"
                | "CHANNEL"
        )
}

/// `RAPID,GOTO/P`: several words before the slash, joined by commas.
fn joined(state: &mut State, text: &[u8], head: &[u8], rest: &[u8]) {
    if let Some((word, rest)) = without_slash(head).filter(|_| head.len() == text.len()) {
        return word_statement(state, text, &word, rest);
    }
    let words: Option<Vec<SmolStr>> = head.split(|b| *b == b',').map(major).collect();
    let Some(words) = words.filter(|w| w.len() > 1) else {
        return unread(state, text);
    };
    let arc = words.last().is_some_and(|w| matches!(w.as_str(), "GOFWD" | "GF"));
    if arc && rest.contains(&b'(') {
        return catia::circular_move(state, text, rest);
    }
    if words.iter().any(|w| w != "TLON" && source::is_word(w)) {
        return of_source(state, Kind::Unread(args::text(text).into()));
    }
    let slash = memchr::memchr(b'/', text).is_some();
    for (i, word) in words.iter().enumerate() {
        let last = i + 1 == words.len();
        state.in_goto = matches!(word.as_str(), "GOTO" | "FROM");
        if last && slash {
            word_statement(state, text, word, rest);
        } else {
            word_statement(state, word.as_bytes(), word, b"");
        }
    }
}

/// `CHANNEL,1`, `NEXTTL, 4` and `OPNAME 'text'`: a word whose arguments follow without a slash.
fn without_slash(head: &[u8]) -> Option<(SmolStr, &[u8])> {
    let end = head.iter().position(|b| matches!(b, b',' | b'\''))?;
    let word = major(&head[..end])?;
    let rest = if head[end] == b',' { &head[end + 1..] } else { &head[end..] };
    let first = args::fields(rest).next()?.trim_ascii();
    let quoted = first.len() > 1 && first.starts_with(b"'") && first.ends_with(b"'");
    (quoted || crate::number::parse(first).is_some()).then_some((word, rest))
}

fn word_statement(state: &mut State, text: &[u8], word: &SmolStr, rest: &[u8]) {
    match word.as_str() {
        "GOTO" | "GT" => motion(state, text, rest, false),
        "FROM" => motion(state, text, rest, true),
        "GODLTA" => godlta(state, text, rest),
        "UNITS" | "UNIT" => units(state, text, rest),
        "MULTAX" => multax(state, text, rest),
        "CUTTER" => cutter(state, word, rest),
        "INTOL" | "OUTTOL" | "TOLER" => tolerance(state, word, rest),
        "CUT" if rest.is_empty() => state.emit(Kind::Output(Output::Cut)),
        "DNTCUT" => state.emit(Kind::Output(Output::Dntcut)),
        "INDEX" => index(state, word, rest),
        "COPY" => copy(state, word, rest),
        "TRACUT" => tracut(state, word, rest),
        "CLPRNT" => clprnt(state, word, rest),
        "CSYS" => csys(state, word, rest),
        "CIRCLE" => circle(state, text, rest),
        "MOVARC" => couplets::movarc(state, text, rest),
        "ARC" | "ARCDAT" | "ARCMOV" | "CW" | "CCW" | "GOCLW" | "GOCCLW" | "HELICAL" => {
            couplets::arc_word(state, text, word, rest);
        }
        "INDIRV" | "INDIRP" => indir(state, text, word, rest),
        "PSIS" => catia::psis(state, text, rest),
        "AUTOPS" if rest.is_empty() => state.psis = None,
        "GOFWD" | "GF" if rest.contains(&b'(') => catia::circular_move(state, text, rest),
        "TLON" if rest.is_empty() => {}
        "CONT" | "MOVE" if args::all_numbers(rest).is_some_and(|n| n.get().len() > 1) => {
            if let Some(Circle { center, axis, radius }) = state.arcdat.filter(|_| word == "CONT") {
                state.close();
                state.pending = Some(points(center, axis, radius));
            }
            motion(state, text, rest, false);
        }
        "ISN" if comments::line(state, true, rest) => {}
        "CYCLE" if state.dialect == Dialect::Fusion && fusion::cycle(state, rest) => {}
        "MCSYS" if couplets::mcsys(state, rest) => {}
        "GOHOME" => gohome(state, word, rest),
        // The points of a MOVNRB stand after it as GOTO.
        "PPWORD" | "MOVNRB" if state.dialect == Dialect::Creo => {
            state.emit(Kind::Comment(format!(" {}", args::text(text)).into()));
        }
        "TLAXIS" if catia::tlaxis(state, rest) => {}
        "ORIGIN" if state.dialect == Dialect::Catia && catia::origin(state, rest) => {}
        "MCS" if couplets::mcs(state, rest) => {}
        "FINI" => fini(state),
        _ if source::is_word(word) => {
            of_source(state, Kind::Post { word: word.clone(), args: list(rest) });
        }
        _ if !is_known(word) && source::motion_word(word.as_bytes()).is_some() => {
            unread(state, text);
        }
        _ if state.dialect == Dialect::Nx && nx::statement(state, text, word, rest) => {}
        _ => post(state, word, rest),
    }
}

/// PARTNO and its kind.
fn fixed_field(state: &mut State, word: &str, rest: &[u8]) {
    state.in_goto = false;
    let rest = rest.trim_ascii_start();
    let (slashed, body) = match rest.strip_prefix(b"/") {
        Some(body) => (true, body.trim_ascii_start()),
        None => (false, rest),
    };
    let body = body.trim_ascii_end();
    state.text_going_on = body.ends_with(b"$").then_some(state.at.line);
    if word == "REMARK" && super::creo::structured(state, body) {
        return;
    }
    let quoted = body.strip_prefix(b"'").and_then(|b| b.strip_suffix(b"'"));
    let body = quoted.filter(|_| slashed).unwrap_or(body);
    // CAMWorks describes tools in INSERT, which would go into the NC file as it stands.
    let word = match word {
        "INSERT" if state.dialect == Dialect::Camworks => "PPRINT",
        _ => word,
    };
    state.emit(Kind::Text { word: word.into(), text: args::text(body).into() });
}

/// A statement that is kept as it stands; an error where it should have moved the tool or is one of a part program.
pub(super) fn unread(state: &mut State, text: &[u8]) {
    state.in_goto = false;
    if let Some(word) = source::motion_word(text) {
        state.pending = None;
        let point = matches!(word, "GOTO" | "FROM" | "GODLTA");
        if point && !text.contains(&b'/') {
            return wrong(state, text, "a motion without its slash", COORDINATES);
        }
        let help = format!("write {word}, a slash, and what belongs to it");
        return wrong(state, text, &format!("{word} in a form that is not known"), &help);
    }
    // A text may go on in this line and look like a definition.
    let in_text = state.text_going_on.is_some_and(|line| line + 1 == state.at.line);
    if !in_text && source::is_definition(text) {
        return of_source(state, Kind::Unread(args::text(text).into()));
    }
    let text = args::text(text);
    let end = text.find(|c: char| c == '/' || c == '=' || c.is_whitespace()).unwrap_or(text.len());
    let word: String = text[..end].chars().take(24).collect();
    state.report.unknown(state.at, &word);
    state.emit(Kind::Unread(text.into()));
}

/// A statement of a part program: what it would do there is missing here.
fn of_source(state: &mut State, kind: Kind) {
    state.in_goto = false;
    state.report.note(state.at, codes::UNREADABLE_CL, Severity::Error, source::TOLD);
    state.emit(kind);
}

/// A statement that should have been understood: kept, and an error.
pub(super) fn wrong(state: &mut State, text: &[u8], what: &str, help: &str) {
    state.report.error(state.at, what, help);
    state.emit(Kind::Unread(args::text(text).into()));
}

/// A post-processor word.
pub(super) fn post(state: &mut State, word: &SmolStr, rest: &[u8]) {
    if !is_known(word) {
        state.report.unknown(state.at, word);
    }
    let mut list = Vec::new();
    args::parse(rest, &mut list);
    let word = super::tools::as_iso(word, &mut list);
    super::tools::without_correctors(state.dialect, &word, &mut list);
    state.subprogram_word(&word);
    if !state.geometry.is_empty() {
        list = with_forms(std::mem::take(&mut state.geometry), list, rest);
    }
    state.emit(Kind::Post { word, args: list });
}

/// Puts the forms together that `$$ GEOMETRY` announced; what does not fit stays as it is.
fn with_forms(
    geometry: Vec<(usize, aptc_geometry::FormKind, usize)>,
    plain: Vec<Arg>,
    rest: &[u8],
) -> Vec<Arg> {
    let fields: Vec<&[u8]> = args::fields(rest).collect();
    let mut out = Vec::new();
    let mut at = 0;
    for (index, kind, count) in geometry {
        while out.len() + 1 < index && at < plain.len() {
            out.push(plain[at].clone());
            at += 1;
        }
        let form = elements(&plain, at, count).and_then(|e| restore::form(kind, &e));
        let (Some(form), Some(name), Some(Arg::Number(subscript))) =
            (form, fields.get(at), plain.get(at + 1))
        else {
            return plain;
        };
        let name = args::text(name.trim_ascii());
        let name = if name == "0" { SmolStr::default() } else { name.into() };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
        let subscript = *subscript as u32;
        out.push(Arg::Form { name: crate::NameRef { name, subscript }, form: form.into() });
        at += 2 + count;
    }
    out.extend_from_slice(&plain[at..]);
    out
}

fn elements(plain: &[Arg], at: usize, count: usize) -> Option<Vec<f64>> {
    let end = at.checked_add(2)?.checked_add(count)?;
    let number = |a: &Arg| match a {
        Arg::Number(x) => Some(*x),
        _ => None,
    };
    plain.get(at + 2..end)?.iter().map(number).collect()
}

fn units(state: &mut State, text: &[u8], rest: &[u8]) {
    let Some(units) = unit_named(rest) else {
        let help = "write UNITS/MM, CM, INCHES or FEET";
        return wrong(state, text, "a unit that is not known", help);
    };
    state.units = Some(units);
    state.emit(Kind::Units(units));
}

/// The unit behind UNITS.
pub(super) fn unit_named(rest: &[u8]) -> Option<Units> {
    match args::upper(rest).as_str() {
        "MM" => Some(Units::Mm),
        "CM" => Some(Units::Cm),
        "INCHES" | "INCH" | "IN" => Some(Units::Inches),
        "FEET" => Some(Units::Feet),
        _ => None,
    }
}

fn multax(state: &mut State, text: &[u8], rest: &[u8]) {
    let on = match args::upper(rest).as_str() {
        "" | "ON" => true,
        "OFF" => false,
        _ => return wrong(state, text, "MULTAX with an unknown argument", "write ON or OFF"),
    };
    state.multax = on;
    if !on {
        state.axis_held = false;
        state.axis_seen = false;
        state.ta = Vec3::z();
    }
    state.emit(Kind::Multax(on));
}

/// CUTTER with 1 to 7 numbers; the defaults are those of APT, the height at least as much as it needs.
fn cutter(state: &mut State, word: &SmolStr, rest: &[u8]) {
    let numbers = args::all_numbers(rest);
    let height = Units::Inches.mm() * 5.0 / state.units.unwrap_or_default().mm();
    let cutter = match numbers.as_ref().map(Numbers::get) {
        Some(&[d]) => Cutter::by_two(d, 0.0, height),
        Some(&[d, r]) => Cutter::by_two(d, r, height),
        Some(&[d, r, e, f, alpha, beta, ref rest @ ..]) if rest.len() <= 1 => Cutter {
            diameter: d,
            corner_radius: r,
            e,
            f,
            alpha_deg: alpha,
            beta_deg: beta,
            height: rest.first().copied().unwrap_or(height),
        },
        Some(&[d, r, h]) => Cutter::mill(d, r, h),
        _ => return post(state, word, rest),
    };
    state.emit(Kind::Cutter(cutter));
}

/// One value for all four surfaces, or up to four of them.
fn tolerance(state: &mut State, word: &SmolStr, rest: &[u8]) {
    let numbers = args::all_numbers(rest);
    let Some(&[first, ref more @ ..]) = numbers.as_ref().map(Numbers::get) else {
        return post(state, word, rest);
    };
    if more.len() > 3 || (more.len() == 3 && word == "TOLER") {
        return post(state, word, rest);
    }
    let mut t = [first; 4];
    t[1..1 + more.len()].copy_from_slice(more);
    let drive = t[1];
    match word.as_str() {
        "INTOL" => {
            state.intol = drive;
            state.emit(Kind::Intol(t));
        }
        "OUTTOL" => {
            state.outtol = drive;
            state.emit(Kind::Outtol(t));
        }
        _ => {
            (state.intol, state.outtol) = (0.0, drive);
            state.emit(Kind::Intol([0.0; 4]));
            state.emit(Kind::Outtol(t));
        }
    }
}

/// The arguments of a word.
pub(super) fn list(rest: &[u8]) -> Vec<Arg> {
    let mut out = Vec::new();
    args::parse(rest, &mut out);
    out
}

fn clprnt(state: &mut State, word: &SmolStr, rest: &[u8]) {
    match args::upper(rest).as_str() {
        "" => state.emit(Kind::Clprnt(Clprnt::Whole)),
        "ON" => state.emit(Kind::Clprnt(Clprnt::On)),
        "OFF" => state.emit(Kind::Clprnt(Clprnt::Off)),
        "OPTION" => state.emit(Kind::Clprnt(Clprnt::Option)),
        _ => post(state, word, rest),
    }
}

fn csys(state: &mut State, word: &SmolStr, rest: &[u8]) {
    match matrix(&list(rest)) {
        Some(m) => state.emit(Kind::Csys(m)),
        None => post(state, word, rest),
    }
}

/// GOHOME stays a post-processor word; where it names the place, the tool is there afterwards.
fn gohome(state: &mut State, word: &SmolStr, rest: &[u8]) {
    post(state, word, rest);
    if let Some(&[x, y, z, ..]) = args::all_numbers(rest).as_ref().map(Numbers::get) {
        state.te = Some(Vec3::new(x, y, z));
    }
}

/// End of the program: nothing of it holds for the next one in the file.
fn fini(state: &mut State) {
    state.emit(Kind::Fini);
    state.te = None;
    state.ta = Vec3::z();
    state.axis_seen = false;
    state.multax = false;
    state.axis_held = false;
    state.pending = None;
    state.direction = None;
    (state.subprogram, state.called) = (None, false);
    (state.bottoms, state.bottoms_off) = (None, None);
}
