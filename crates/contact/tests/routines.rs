//! The routines of SSV3 that hold cutter against surface, replayed with the inputs of its trace.
//!
//! What took their place gives the same where they were right; where they were not, the difference is stated.

mod trace;

use aptc_contact::Tool;
use aptc_geometry::sculpt::Derivatives;
use aptc_geometry::{Cutter, Profile, Vec3};
use trace::{Call, calls, v, x};

/// The cutter of TUL: corner radius, half diameter, e, f - r, alpha, beta, height.
fn cutter(call: &Call) -> (Profile, [f64; 3]) {
    let t = &call["TUL"];
    let (r, half, e) = (t[0], t[1], t[2]);
    let c = Cutter::mill(2.0 * half, r, t[6] + r);
    (Profile::new(&c).expect("a mill"), [r, half, e])
}

fn derivatives(call: &Call) -> Derivatives {
    let second = call.contains_key("RUU");
    let of = |n: &str| if second { v(call, n) } else { Vec3::zeros() };
    let (u, w) = (v(call, "RU"), v(call, "RV"));
    let point = if call.contains_key("R") { v(call, "R") } else { Vec3::zeros() };
    Derivatives { point, u, v: w, uu: of("RUU"), uv: of("RUV"), vv: of("RVV") }
}

/// `ALGO1`: the step to a point in the tangent plane.
#[test]
fn algo1() {
    for c in calls("algo1", "ALGO1") {
        let d = derivatives(&c);
        let n = v(&c, "RN");
        let w = v(&c, "T") - d.point;
        let [du, dv] = d.components(w - n * n.dot(&w)).expect("a regular place");
        let size = 1.0 + du.abs() + dv.abs();
        assert!((du - x(&c, "DU")).abs() < 1e-9 * size, "{du} {}", x(&c, "DU"));
        assert!((dv - x(&c, "DV")).abs() < 1e-9 * size, "{dv} {}", x(&c, "DV"));
    }
}

/// `CURCAL`: principal curvatures.
#[test]
fn curcal() {
    for c in calls("curcal", "CURCAL") {
        let d = derivatives(&c);
        let n = v(&c, "RNORM") * x(&c, "SIDE");
        let ours = d.curvatures(n).expect("a regular place");
        let theirs = [x(&c, "CURVE1"), x(&c, "CURVE2")];
        let scale = ours[0].abs().max(ours[1].abs());
        // Where their product is below a threshold SSV3 gives their sum and 0.
        let sum = (ours[0] + ours[1] - theirs[0] - theirs[1]).abs();
        assert!(sum < 1e-6 * scale + 1e-9, "{ours:?} {theirs:?}");
        if theirs[0] != 0.0 && theirs[1] != 0.0 {
            assert!((ours[0] - theirs[0]).abs() < 1e-6 * scale, "{ours:?} {theirs:?}");
        }
    }
}

/// `PENCUT` below the middle of the corner: depth of a point in the cutter. Above it SSV3 measures through the
/// tool to its far side; there the distance is held against the plain cylinder.
#[test]
fn pencut() {
    for c in calls("pencut", "PENCUT") {
        let (profile, [r, half, _]) = cutter(&c);
        let (center, ta) = (v(&c, "TOOLCE"), v(&c, "TOOLAX"));
        let tool = Tool { profile: &profile, te: center - ta * r, ta };
        let at = v(&c, "R");
        let deep = -tool.distance(at) + x(&c, "PTHICK");
        let w = at - center;
        let up = w.dot(&ta);
        if up < 0.0 {
            assert!((deep - x(&c, "PEN")).abs() < 1e-9, "{deep} {}", x(&c, "PEN"));
        } else if up < x(&c, "TUL") {
            let out = (w - ta * up).norm();
            assert!(deep <= half - out + 1e-9, "{deep}");
        }
    }
}

/// `CALCT`: the place of the cutter whose normal is against that of the surface, on ball and corner.
#[test]
fn calct() {
    let mut compared = 0;
    for c in calls("calct", "CALCT") {
        let (profile, [r, ..]) = cutter(&c);
        let (center, ta) = (v(&c, "TOOLCE"), v(&c, "TOOLAX"));
        let n = v(&c, "RN") * x(&c, "PSIDE");
        let up = n.dot(&ta);
        // On the base any place is as good; with a normal that points down there is none that cuts.
        if !(1e-3..1.0 - 1e-3).contains(&up) {
            continue;
        }
        let tool = Tool { profile: &profile, te: center - ta * r, ta };
        let ours = tool.support(-n).point;
        assert!((ours - v(&c, "T")).norm() < 1e-9, "{ours} {}", v(&c, "T"));
        compared += 1;
    }
    assert!(compared > 0 || calls("calct", "CALCT").is_empty());
}

/// `HULCUT`: where it calls a sphere clear below the cutter it is; what it calls hit for a flat is often clear.
#[test]
fn hulcut() {
    for c in calls("hulcut", "HULCUT") {
        let (profile, _) = cutter(&c);
        let s = &c["SPHR"];
        let tool = Tool { profile: &profile, te: v(&c, "TE"), ta: v(&c, "TA") };
        let center = Vec3::new(s[0], s[1], s[2]);
        let distance = tool.distance(center) - s[3];
        let height = (center - tool.te).dot(&tool.ta);
        if x(&c, "ISEG") < 0.0 && height < 0.0 {
            assert!(distance > -1e-9, "{distance}");
        }
    }
}

/// `TCSPHR`: the sphere about the axis that touches the corner at the contact's inclination.
#[test]
fn tcsphr() {
    for c in calls("tcsphr", "TCSPHR") {
        let (_, [r, _, e]) = cutter(&c);
        let ta = v(&c, "TA");
        let n = v(&c, "RNORM") * x(&c, "PSIDE");
        let (up, across) = (n.dot(&ta), (n - ta * n.dot(&ta)).norm());
        // SSV3 takes the raw normal and a large constant for one along the axis.
        if up < 0.0 || across < 1e-3 {
            continue;
        }
        let radius = e / across + r;
        assert!((radius - x(&c, "TCRAD")).abs() < 1e-6 * radius, "{radius} {}", x(&c, "TCRAD"));
    }
}
