//! SPINDL.

use aptc_cldata::Arg;
use aptc_diagnostics::codes;
use std::f64::consts::PI;

use crate::args::Statement;
use crate::emit::render;
use crate::post::{Post, trimmed};
use crate::words::{bad_arguments, refuse};

/// `SPINDL/[RPM|SFM|SMM,]n[,CLW|CCLW][,RANGE,r|LOW|MEDIUM|HIGH]`, `ON`, `OFF`, `ORIENT[,a]`, `MAXRPM,n`.
pub(super) fn spindl(post: &mut Post, s: &Statement<'_>) {
    post.start(s.origin);
    match s.word(0) {
        Some("OFF") if s.args.len() == 1 => {
            post.annotate(s.origin);
            post.st.spindle_said();
            post.st.held.retain(|h| !h.spindle);
            post.st.spindle.on = false;
            post.st.feed_word = None;
            let off = post.machine.spindle.off.clone();
            post.blocks.line(&off);
            return;
        }
        Some("ORIENT") => {
            post.annotate(s.origin);
            let angle = trimmed(s.first_number().unwrap_or(0.0), 3);
            match render(&post.machine.spindle.orient, &[("angle", &angle)]) {
                Some(line) if !line.is_empty() => {
                    post.blocks.line(&line);
                    // What would start it before the next motion would undo it.
                    post.st.spindle_said();
                    post.st.spindle_oriented = true;
                }
                _ => refuse(post, s, "the machine has no oriented spindle stop"),
            }
            return;
        }
        Some("MAXRPM") => {
            post.st.max_rpm = s.first_number();
            return;
        }
        Some("LOCK" | "NEUTRL" | "AUTO") => {
            refuse(post, s, "the machine has nothing like it");
            return;
        }
        _ => {}
    }
    let Some(next) = wanted(post, s) else { return };
    let st = &post.st;
    let stands = st.spindle_again || st.spindle_perhaps || st.spindle_oriented;
    let again = stands || next != st.spindle;
    post.st.spindle_said();
    post.st.spindle = next;
    post.st.feed_word = None;
    if again {
        post.hold(true, s.written(), s.origin);
    }
}

fn wanted(post: &mut Post, s: &Statement<'_>) -> Option<crate::state::SpindleState> {
    let forms = "SPINDL/n with CLW or CCLW, ON, OFF, ORIENT or MAXRPM,n";
    let mut next = post.st.spindle;
    let mut value = None;
    let mut surface = None;
    let mut turns = None;
    let mut args = s.args.iter();
    while let Some(arg) = args.next() {
        match arg {
            Arg::Number(n) => value = value.or(Some(*n)),
            Arg::Word(w) => match w.as_str() {
                "RPM" => surface = Some(None),
                // Feet a minute, metres a minute: in output units a minute.
                "SFM" => surface = Some(Some(12.0 * 25.4)),
                "SMM" => surface = Some(Some(1000.0)),
                "CLW" | "CCLW" => {
                    next.ccw = w == "CCLW";
                    if turns.replace(next.ccw).is_some_and(|before| before != next.ccw) {
                        bad_arguments(post, s, "SPINDL/n with CLW or with CCLW");
                        return None;
                    }
                }
                "ON" => {}
                "MAXRPM" => {
                    if let Some(Arg::Number(n)) = args.next() {
                        post.st.max_rpm = Some(*n);
                    }
                }
                "RANGE" => {
                    let name = match args.next() {
                        Some(Arg::Number(n)) => format!("{n}"),
                        Some(Arg::Word(w)) => w.to_string(),
                        _ => String::new(),
                    };
                    range(post, s, &name);
                }
                "LOW" | "MEDIUM" | "HIGH" => range(post, s, w),
                "DIAMTR" | "RADIUS" | "NOTE" => break,
                _ => {
                    bad_arguments(post, s, forms);
                    return None;
                }
            },
            _ => {
                bad_arguments(post, s, forms);
                return None;
            }
        }
    }
    match (value, surface) {
        (Some(v), Some(Some(mm))) => return by_surface_speed(post, s, next, v, mm),
        (Some(v), _) => next.speed = v,
        (None, _) if next.speed > 0.0 => {}
        (None, _) => {
            bad_arguments(post, s, "a speed: SPINDL/n");
            return None;
        }
    }
    next.on = true;
    next.surface = false;
    if next.ccw && post.machine.spindle.ccw.is_empty() {
        refuse(post, s, "the spindle does not turn anticlockwise");
        return None;
    }
    within(post, s, next.speed).then_some(next)
}

/// Speed from a surface speed: with CSS of the control, or from the cutter's diameter.
fn by_surface_speed(
    post: &mut Post,
    s: &Statement<'_>,
    mut next: crate::state::SpindleState,
    value: f64,
    mm: f64,
) -> Option<crate::state::SpindleState> {
    next.on = true;
    if !post.machine.spindle.surface_speed.is_empty() {
        next.surface = true;
        // The control wants metres a minute, or feet a minute when it works in inches.
        next.speed = if post.st.inch { value * mm / (12.0 * 25.4) } else { value * mm / 1000.0 };
        return Some(next);
    }
    let diameter = s.after(&["DIAMTR"]).or_else(|| s.after(&["RADIUS"]).map(|r| 2.0 * r));
    let diameter = diameter.or_else(|| post.st.cutter.map(|c| c.diameter)).filter(|d| *d > 0.0);
    let Some(diameter) = diameter else {
        let message =
            format!("{}: a surface speed without the diameter of the cutter", s.written());
        let help = "write CUTTER/d before it, or the speed in revolutions a minute";
        post.error(codes::POST_ARGUMENTS, s.origin, message, help);
        return None;
    };
    next.surface = false;
    let speed = (value * mm / (PI * diameter * post.st.units.mm())).round();
    // MAXRPM bounds what comes of a surface speed.
    next.speed = post.st.max_rpm.map_or(speed, |most| speed.min(most));
    let most = post.machine.spindle.max;
    if most > 0.0 && next.speed > most {
        let message = format!(
            "{}: {} turns a minute come of it, and {} has {}",
            s.written(),
            trimmed(next.speed, 0),
            post.machine.name,
            trimmed(most, 0)
        );
        let help = "write MAXRPM,n behind it, or the speed in turns a minute";
        post.warn(codes::OVER_LIMIT, s.origin, message, help);
        next.speed = most;
    }
    within(post, s, next.speed).then_some(next)
}

fn within(post: &mut Post, s: &Statement<'_>, speed: f64) -> bool {
    let (min, max) = (post.machine.spindle.min, post.machine.spindle.max);
    let max = post.st.max_rpm.map_or(max, |m| if max > 0.0 { max.min(m) } else { m });
    if !(speed > 0.0 && speed.is_finite()) || speed < min || (max > 0.0 && speed > max) {
        let limits = if max > 0.0 {
            format!("within {} to {}", trimmed(min, 1), trimmed(max, 1))
        } else if min > 0.0 {
            format!("at least {}", trimmed(min, 1))
        } else {
            "above 0".into()
        };
        let message = format!(
            "{}: spindle speed {} is not {limits}, as {} has it",
            s.written(),
            trimmed(speed, 1),
            post.machine.name
        );
        post.error(codes::OVER_LIMIT, s.origin, message, "program a speed that the machine has");
        return false;
    }
    true
}

fn range(post: &mut Post, s: &Statement<'_>, name: &str) {
    if post.machine.spindle.ranges.is_empty() {
        let message = format!("{}: {} has one spindle range only", s.written(), post.machine.name);
        post.note(codes::WORD_IGNORED, s.origin, message, "");
        return;
    }
    match post.machine.spindle.ranges.get(name).cloned() {
        Some(code) => {
            post.annotate(s.origin);
            post.blocks.line(&code);
        }
        None => refuse(post, s, "the machine has no such spindle range"),
    }
}

impl Post {
    /// Writes the spindle as it is to run.
    pub(crate) fn spindle_on(&mut self) {
        write(self);
    }
}

fn write(post: &mut Post) {
    let st = post.st.spindle;
    let speed = trimmed(st.speed, 3);
    let machine = std::sync::Arc::clone(&post.machine);
    let spindle = &machine.spindle;
    let number = post.blocks.number(b'S');
    let speed = number.round(st.speed).map_or(speed, |q| number.text(q));
    if st.surface {
        let max = post.st.max_rpm.map_or(String::new(), |m| trimmed(m, 0));
        let max = if max.is_empty() { trimmed(spindle.max, 0) } else { max };
        let on = if st.ccw { "M4" } else { "M3" };
        if let Some(line) = render(&spindle.surface_speed, &[("speed", &speed), ("max", &max)]) {
            post.blocks.line(&format!("{line}{}{on}", machine.program.separator));
        }
        return;
    }
    let template = if st.ccw { &spindle.ccw } else { &spindle.cw };
    if let Some(line) = render(template, &[("speed", &speed)]) {
        post.blocks.line(&line);
    }
}
