//! CLRSRF, CLEARP, RETRCT and GOHOME: where the tool is clear.

use std::sync::Arc;

use aptc_cldata::Arg;
use aptc_diagnostics::codes;
use aptc_geometry::{Form, Plane, Vec3};

use crate::args::Statement;
use crate::post::Post;
use crate::words::{bad_arguments, refuse};

/// `CLRSRF/plane|z|[NORMAL,]i,j,k,d` stores the plane; `CLRSRF/NOW` retracts to it along the tool axis.
pub(super) fn clrsrf(post: &mut Post, s: &Statement<'_>) {
    match s.word(0) {
        Some("NOW" | "START") => retract(post, s),
        Some("STOP") => {}
        _ => store(post, s),
    }
}

/// `CLEARP/plane|XYPLAN,z`.
pub(super) fn clearp(post: &mut Post, s: &Statement<'_>) {
    store(post, s);
}

fn store(post: &mut Post, s: &Statement<'_>) {
    match plane(s, post.st.units.mm()) {
        Some(p) => post.st.clearance_mm = Some(p),
        None => bad_arguments(post, s, "CLRSRF/plane, or CLRSRF/z"),
    }
}

/// The plane of a statement, in millimetres.
pub(crate) fn plane(s: &Statement<'_>, mm: f64) -> Option<Plane> {
    let plane = match s.args {
        [Arg::Form { form, .. }] => match &**form {
            Form::Plane(p) => Some(*p),
            _ => None,
        },
        [Arg::Number(z)] => Plane::new(Vec3::z(), *z),
        [Arg::Word(w), Arg::Number(d)] => match w.as_str() {
            "XYPLAN" => Plane::new(Vec3::z(), *d),
            "YZPLAN" => Plane::new(Vec3::x(), *d),
            "ZXPLAN" => Plane::new(Vec3::y(), *d),
            _ => None,
        },
        [rest @ .., Arg::Number(i), Arg::Number(j), Arg::Number(k), Arg::Number(d)]
            if rest.is_empty() || matches!(rest, [Arg::Word(w)] if w == "NORMAL") =>
        {
            Plane::new(Vec3::new(*i, *j, *k), *d)
        }
        // A plane by name, subscript and canonical form, as CL text has it.
        [_, rest @ ..] => match *numbers(rest) {
            [_, a, b, c, d] => Plane::new(Vec3::new(a, b, c), d),
            _ => None,
        },
        _ => None,
    }?;
    Some(Plane { n: plane.n, d: plane.d * mm })
}

fn numbers(args: &[Arg]) -> Box<[f64]> {
    let number = |a: &Arg| match a {
        Arg::Number(n) => *n,
        _ => f64::NAN,
    };
    args.iter().map(number).collect()
}

fn retract(post: &mut Post, s: &Statement<'_>) {
    let Some(plane) = post.st.clearance() else {
        let message = "CLRSRF/NOW before a clearance plane was given".to_string();
        let help = "write CLRSRF/plane first";
        post.error(codes::POST_ARGUMENTS, s.origin, message, help);
        return;
    };
    post.st.rapid = false;
    // Without a position there is nothing to retract from: the machine stands retracted.
    let Some(pos) = post.st.pos else { return };
    post.start(s.origin);
    post.annotate(s.origin);
    post.leave_cycle();
    let ta = post.st.ta;
    let slope = plane.n.dot(&ta);
    if slope.abs() < 1e-6 {
        let message = "the tool axis never meets the clearance plane".to_string();
        post.error(codes::POST_ARGUMENTS, s.origin, message, "give a plane across the tool axis");
        return;
    }
    let way = (plane.d - plane.n.dot(&pos)) / slope;
    let resolution = post.blocks.number(b'Z').resolution();
    if way < -resolution {
        let message = "the tool is beyond the clearance plane already and stays there".to_string();
        post.note(codes::STAYS_CLEAR, s.origin, message, "");
        return;
    }
    if way > 0.0 {
        post.go_to(pos + ta * way, ta, true, s.origin);
    }
}

/// `RETRCT`, in NX `RETRCT/ZAXIS`: as far as the machine goes.
pub(super) fn retrct(post: &mut Post, s: &Statement<'_>) {
    let along_z = s.args.len() == 1 && s.word(0) == Some("ZAXIS") && post.tool_along() == 2;
    if !s.args.is_empty() && !along_z {
        refuse(post, s, "only RETRCT without arguments retracts here");
        return;
    }
    if post.machine.program.retract.is_empty() {
        if post.st.clearance_mm.is_some() {
            retract(post, s);
        } else {
            refuse(post, s, "the machine has no way to retract");
        }
        return;
    }
    post.st.rapid = false;
    post.start(s.origin);
    post.annotate(s.origin);
    post.leave_cycle();
    post.retract_to_home(s.origin);
}

/// `GOHOME`.
pub(super) fn gohome(post: &mut Post, s: &Statement<'_>) {
    if post.machine.program.home.is_empty() {
        refuse(post, s, "the machine has no home");
        return;
    }
    post.st.rapid = false;
    post.start(s.origin);
    post.annotate(s.origin);
    post.leave_cycle();
    post.leave_plane();
    post.tool_center_off();
    let machine = Arc::clone(&post.machine);
    let vars = post.common_vars();
    post.blocks.template(&machine.program.home, &vars.list());
    post.left_for_home();
    // The CL position is where the tool was; the next cut begins where it says itself.
    post.st.pos = None;
}
