//! Routines of SSV3 that have no counterpart here, replayed by formulas of their own with the inputs of its trace.
//!
//! Each formula is the corrected one of the literature; where the traced code was wrong the difference is stated.

mod trace;

use aptc_geometry::{Vec3, trig};
use trace::{v, x};

/// The twelve calls of a routine; none where the traces are not there.
fn calls(test: &str, routine: &str) -> Vec<trace::Call> {
    let all = trace::calls(test, routine);
    assert!(all.is_empty() || all.len() == 12, "twelve calls of {routine}");
    all
}

/// How far `q` is from the straight line through `p0` and `p1`, negative on the side away from `n`.
fn deviation(q: Vec3, n: Vec3, [p0, p1]: [Vec3; 2]) -> f64 {
    let way = p1 - p0;
    let off = q - p0 - way * ((q - p0).dot(&way) / way.norm_squared());
    if off.dot(&n) < 0.0 { -off.norm() } else { off.norm() }
}

/// `DEVCAL`: right for the line; a place beyond the chord's ends is measured from the line, not from the end.
#[test]
fn devcal() {
    let mut beyond = 0;
    for c in calls("devcal", "DEVCAL") {
        let ends = [v(&c, "P0"), v(&c, "P1")];
        let ours = deviation(v(&c, "Q"), v(&c, "TN"), ends);
        assert!((ours - x(&c, "DEV")).abs() < 1e-13 * ours.abs().max(1.0), "{ours}");
        let way = ends[1] - ends[0];
        let t = (v(&c, "Q") - ends[0]).dot(&way) / way.norm_squared();
        if !(0.0..=1.0).contains(&t) {
            // The chord itself is farther.
            let near = ends[0] + way * t.clamp(0.0, 1.0);
            assert!((v(&c, "Q") - near).norm() > ours.abs());
            beyond += 1;
        }
    }
    assert!(beyond == 0 || beyond == 5, "{beyond}");
}

/// Greatest steps of the contact and of the tool's centre over a surface of curvature `k`, such that the chord
/// leaves the way of the centre of a cutter of radius `t` by `e`.
fn steps(k: f64, t: f64, e: f64) -> [f64; 2] {
    let radius = 1.0 / k;
    let way = (radius - t).abs();
    let cos = 1.0 - e / way;
    let sin = (1.0 - cos * cos).max(1e-9).sqrt();
    [2.0 * radius.abs() * sin, 2.0 * way * sin]
}

/// `SRFTOL`.
#[test]
fn srftol() {
    for c in calls("srftol", "SRFTOL") {
        let ours = steps(x(&c, "SKRV"), x(&c, "TRAD"), x(&c, "TOL"));
        for (a, b) in ours.into_iter().zip([x(&c, "SSTEP"), x(&c, "TSTEP")]) {
            assert!((a - b).abs() < 1e-14 * b.max(1.0), "{a} {b}");
        }
        // What the step is for: the arc of the centre's way over half a step rises by e.
        let way = (1.0 / x(&c, "SKRV") - x(&c, "TRAD")).abs();
        let rise = way - (way * way - 0.25 * ours[1] * ours[1]).sqrt();
        assert!((rise - x(&c, "TOL")).abs() < 1e-12 * way);
    }
    // Flat: no limit, and nothing is made of it.
    assert!(steps(0.0, 5.0, 0.01)[1].is_nan() || steps(0.0, 5.0, 0.01)[1] > 1e4);
}

/// The step of a parameter so that no joint (a whole number) is passed: at most half of the way from a joint, to
/// the joint at most, and halfway when the step is more than half of the way. SSV3 adds 1e-10. Downwards the
/// next joint is the whole number below; the traced routine takes the one below that, but not below 0.
fn to_joint(from: f64, up: bool, step: f64, truncated: bool) -> f64 {
    const MORE: f64 = 1e-10;
    if from.fract() == 0.0 {
        return step.min(0.5) + MORE;
    }
    let next = if up {
        from.floor() + 1.0
    } else if truncated {
        (from - 1.0).trunc()
    } else {
        from.floor()
    };
    let way = (next - from).abs();
    MORE + if step >= way {
        way
    } else if step > 0.5 * way {
        0.5 * way
    } else {
        step
    }
}

/// `PCHG`: upwards right; downwards it goes a joint too far, and with the joint it means passes the right one.
#[test]
fn pchg() {
    let mut passed = 0;
    for c in calls("pchg", "PCHG") {
        let (from, up) = (x(&c, "PCUR"), x(&c, "PDIR") > 0.0);
        let (step, traced) = (x(&c, "PDELIN"), x(&c, "PDEL"));
        let same = to_joint(from, up, step, true);
        assert!((same - traced).abs() < 1e-14, "{from} {step}: {same} {traced}");
        let right = to_joint(from, up, step, false);
        assert!(
            right <= (from - if up { from.ceil() } else { from.floor() }).abs().max(0.5) + 2e-10
        );
        if up {
            assert!((right - traced).abs() < 1e-14);
        } else if (right - traced).abs() > 1e-14 {
            passed += 1;
        }
    }
    assert!(passed == 0 || passed == 2, "{passed}");
}

/// The place of a tool that stands elsewhere corresponding to a contact: the same across, along and up from the
/// tool end, seen in the direction from the last tool end to this one.
///
/// The frames are of unit vectors; the printed ones are not.
fn corresponding(
    contact: Vec3,
    [te, ta]: [Vec3; 2],
    [to_te, to_ta]: [Vec3; 2],
    forward: Vec3,
) -> Vec3 {
    let frame = |ta: Vec3| {
        let side = ta.cross(&forward).normalize();
        [side.cross(&ta), side, ta]
    };
    let [from, to] = [frame(ta), frame(to_ta)];
    let w = contact - te;
    to_te + to[0] * w.dot(&from[0]) + to[1] * w.dot(&from[1]) + to[2] * w.dot(&from[2])
}

/// `XTPCAL`.
#[test]
fn xtpcal() {
    for c in calls("xtpcal", "XTPCAL") {
        let now = [v(&c, "TE"), v(&c, "TA")];
        let last = [v(&c, "TEL"), v(&c, "TAL")];
        let forward = (now[0] - last[0]).normalize();
        let here = corresponding(v(&c, "TPL"), last, now, forward);
        let there = corresponding(v(&c, "TP"), now, last, forward);
        assert!((here - v(&c, "XTP")).norm() < 1e-14);
        assert!((there - v(&c, "XTPL")).norm() < 1e-14);
        // A tool is rigid: there and back is where it was.
        assert!((corresponding(there, last, now, forward) - v(&c, "TP")).norm() < 1e-13);
    }
}

/// The tilts about the contact at which a corner cutter just fits a hollow of radius `rs`: the angle between axis
/// and normal has the sine e / (rs - r). `None`: no tilt in the plane of `w` and `u` does.
fn fitting(rs: f64, [r, e]: [f64; 2], [w, u, sn]: [Vec3; 3]) -> Option<[f64; 2]> {
    let sin = e / (rs - r);
    if !(0.0..=1.0).contains(&sin) {
        return None;
    }
    let cos = (1.0 - sin * sin).sqrt();
    let (a, b) = (w.dot(&sn), u.dot(&sn));
    let most = trig::hypot(a, b);
    if cos > most {
        return None;
    }
    let (middle, off) = (trig::atan2(b, a), trig::acos_clamped(cos / most));
    Some([middle - off, middle + off])
}

/// `CALMXB`: all traced calls say that there is no such tilt, and there is none; closed forms for where there is.
#[test]
fn calmxb() {
    for c in calls("calmxb", "CALMXB") {
        let tul = &c["TUL"];
        let ours = fitting(x(&c, "RS"), [tul[0], tul[2]], [v(&c, "W"), v(&c, "U"), v(&c, "SN")]);
        assert_eq!(ours.is_some(), x(&c, "LRET") != 0.0);
        assert!(x(&c, "BETA").abs() < 1e-300);
    }
    let (w, u) = (Vec3::z(), Vec3::x());
    let [a, b] = fitting(17.0, [3.0, 7.0], [w, u, w]).expect("thirty degrees");
    assert!((a.to_degrees() + 30.0).abs() < 1e-12 && (b.to_degrees() - 30.0).abs() < 1e-12);
    assert!(fitting(9.0, [3.0, 7.0], [w, u, w]).is_none());
    // Both tilts turn the axis to the angle that fits, also beside the plane of the normal.
    let sn = Vec3::new(0.2, 0.1, 1.0).normalize();
    for beta in fitting(20.0, [3.0, 7.0], [w, u, sn]).expect("two tilts") {
        let (sin, cos) = trig::sin_cos(beta);
        let ta = w * cos + u * sin;
        let slope = ta.cross(&sn).norm();
        assert!((slope - 7.0 / 17.0).abs() < 1e-14, "{slope}");
    }
}

/// The sphere through all of `points` with its centre in their own plane or line; `None` where there is none.
fn sphere_through(points: &[Vec3]) -> Option<(Vec3, f64)> {
    let (first, rest) = points.split_first()?;
    let d: Vec<Vec3> = rest.iter().map(|p| p - first).collect();
    let center = match d.as_slice() {
        [a] => first + a * 0.5,
        [a, b] => {
            let n = a.cross(b);
            let to = b.cross(&n) * a.norm_squared() + n.cross(a) * b.norm_squared();
            first + to / (2.0 * n.norm_squared())
        }
        [a, b, c] => {
            let to = b.cross(c) * a.norm_squared()
                + c.cross(a) * b.norm_squared()
                + a.cross(b) * c.norm_squared();
            first + to / (2.0 * a.dot(&b.cross(c)))
        }
        _ => return None,
    };
    let radius = (center - first).norm();
    radius.is_finite().then_some((center, radius))
}

/// The smallest sphere that holds four points: that of two, three or all of them on its skin.
fn smallest(points: &[Vec3; 4]) -> (Vec3, f64) {
    let chosen = |mask: usize| {
        let some = (0..4).filter(|i| mask >> i & 1 == 1).map(|i| points[i]);
        sphere_through(&some.collect::<Vec<_>>())
    };
    let holds = |(c, r): &(Vec3, f64)| points.iter().all(|p| (p - c).norm() <= r * (1.0 + 1e-12));
    (1..16_usize)
        .filter(|mask| mask.count_ones() > 1)
        .filter_map(chosen)
        .filter(holds)
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .expect("four points in space")
}

/// `SHELLA`: nine of twelve are the smallest sphere. In two it passes over the pair that would do, for another pair
/// of the same first point did not, and takes a larger sphere of three; in one its radius is 0, the sign of no
/// sphere, though its centre is right.
#[test]
fn shella() {
    let mut counts = [0; 3];
    for c in calls("shella", "SHELLA") {
        let p = &c["P"];
        let points = [0, 1, 2, 3].map(|i| Vec3::new(p[i], p[4 + i], p[8 + i]));
        let (center, radius) = smallest(&points);
        let (theirs, r) = (v(&c, "C"), x(&c, "R"));
        let same = (center - theirs).norm() < 1e-12 * radius;
        if same && (radius - r).abs() < 1e-12 * radius {
            counts[0] += 1;
        } else if r > radius && points.iter().all(|p| (p - theirs).norm() <= r * (1.0 + 1e-12)) {
            counts[1] += 1;
        } else if same && r < 1e-300 {
            counts[2] += 1;
        } else {
            panic!("{center} {radius} {theirs} {r}");
        }
    }
    assert!(counts == [9, 2, 1] || counts == [0; 3], "{counts:?}");
}
