//! Statements of regional milling, by closed forms.

mod support;

use std::sync::Arc;

use aptc_cldata::milling::{Extent, Milling, Outline, Plain, Raised, Scallop};
use aptc_cldata::{Control, Kind, Motion, MotionKind, NameRef, Position, Record};
use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_geometry::{Cutter, Cylinder, Form, Plane, Profile, Sculptured, Sphere, Vec3, trig};
use aptc_verify::{Certificate, Effort, Verifier, deviation_svg};
use support::{BAND, milled};

/// A square of 20 over x and y, `z` above it, its parameters from 0 to 4.
fn square(z: impl Fn(f64, f64) -> f64) -> Arc<Sculptured> {
    support::square(4, z)
}

fn milling(surface: &Arc<Sculptured>, scallop: Option<f64>) -> Milling {
    let scallop = scallop.map(|height| {
        let extent = Extent::Box([[0.0, 4.0]; 2]);
        Scallop { height, extent, excused: None, links: Vec::new() }
    });
    Milling { scallop, ..support::milling(Some(milled("FLOOR", surface, 1.0, 0.0))) }
}

fn records(milling: Milling, points: Vec<Position>) -> [Record; 2] {
    let record = |kind| Record { origin: Origin::default(), kind };
    let control = Control { milling: Some(milling), ..Control::default() };
    let motion = Motion {
        kind: MotionKind::Continuous,
        points,
        control: Some(Arc::new(control)),
        ..Motion::default()
    };
    [record(Kind::Cutter(Cutter::mill(10.0, 5.0, 40.0))), record(Kind::Motion(motion))]
}

fn judge(milling: Milling, points: Vec<Position>) -> (Certificate, Vec<Diagnostic>) {
    let mut verifier = Verifier::new(Effort::Full);
    records(milling, points).iter().for_each(|r| verifier.push(r));
    verifier.finish()
}

fn upright(points: &[[f64; 3]]) -> Vec<Position> {
    points.iter().map(|p| Position::upright(Vec3::from(*p))).collect()
}

/// Passes along x, `step` apart, at the height `z`.
fn passes(step: f64, z: f64) -> Vec<[f64; 3]> {
    let n = (20.0 / step).ceil();
    let mut out = Vec::new();
    let mut i = 0.0;
    while i <= n {
        let y = (step * i).min(20.0);
        let ends = if i % 2.0 == 0.0 { [0.0, 20.0] } else { [20.0, 0.0] };
        out.extend(ends.map(|x| [x, y, z]));
        i += 1.0;
    }
    out
}

#[test]
fn a_gouge_is_found_with_its_depth_and_place() {
    let flat = square(|_, _| 0.0);
    let good = judge(milling(&flat, None), upright(&passes(2.0, 0.0)));
    assert!(good.0.is_proved() && good.1.is_empty(), "{:?}", good.1);
    for depth in [1.5 * BAND, 0.3] {
        let mut points = passes(2.0, 0.0);
        points[5][2] -= depth;
        let (c, said) = judge(milling(&flat, None), upright(&points));
        let fault = c.statements[0].fault.clone().expect("a fault");
        assert_eq!((c.refuted, said[0].code), (2, codes::REFUTED));
        // To a tenth of what is beyond the band.
        let beyond = depth - BAND;
        assert!(fault.depth > 0.85 * beyond && fault.depth < beyond * (1.0 + 1e-9), "{fault:?}");
        assert!(fault.vector == 6 || fault.vector == 7);
    }
}

#[test]
fn a_chord_over_a_crest_cuts_by_its_sagitta_and_a_checked_wall_is_held_off() {
    // Along the crest of a wave a long chord between points of the surface.
    let wave = square(|x, _| 0.5 * trig::sin(0.15 * x));
    let over = |x: f64| {
        let d = wave.at(x / 5.0, 2.0);
        let n = d.normal().expect("regular");
        let te = d.point + (n - Vec3::z()) * 5.0;
        [te.x, te.y, te.z]
    };
    let fine: Vec<[f64; 3]> = (1..100).map(|i| over(0.2 * f64::from(i))).collect();
    assert!(judge(milling(&wave, None), upright(&fine)).0.is_proved());
    let (c, _) = judge(milling(&wave, None), upright(&[over(6.0), over(15.0)]));
    assert_eq!(c.refuted, 1);
    // A wall that goes up beside the path.
    let wall = square(|x, _| 40.0 * (x - 19.0).max(0.0));
    let mut with = milling(&wave, None);
    with.checked.push(milled("WALL", &wall, 1.0, 0.0));
    let (c, _) = judge(with, upright(&fine));
    let fault = c.statements[0].fault.clone().expect("the wall");
    assert!(c.refuted > 0 && fault.surface == "checked surface WALL", "{fault:?}");
}

fn plain(name: &str, form: Form) -> Plain {
    Plain { name: NameRef { name: name.into(), subscript: 0 }, form: Arc::new(form), thick: 0.0 }
}

/// A holder of radius 8 that begins 30 above the tool end.
fn holder() -> Raised {
    let profile = Profile::new(&Cutter::mill(16.0, 0.0, 20.0)).expect("a solid");
    Raised { profile, up: 30.0 }
}

#[test]
fn surfaces_of_other_kinds_are_held_off_by_cutter_and_holder() {
    let flat = square(|_, _| 0.0);
    let path = upright(&passes(2.0, 0.0));
    let wall = |x: f64| plain("WALL", Form::Plane(Plane { n: Vec3::x(), d: x }));
    let boss = |radius: f64| {
        let center = Vec3::new(10.0, 9.0, 45.0);
        plain("BOSS", Form::Sphere(Sphere { center, radius }))
    };
    let post = |radius: f64| {
        let point = Vec3::new(10.0, -13.0, 0.0);
        plain("POST", Form::Cylinder(Cylinder { point, axis: Vec3::z(), radius }))
    };
    let left = |thick: f64, p: Plain| Plain { thick, ..p };
    let with = |p: &Plain, held: bool| {
        let holder = if held { vec![holder()] } else { Vec::new() };
        let own = Milling { plain: vec![p.clone()], holder, ..milling(&flat, None) };
        judge(own, path.clone())
    };
    // The cutter comes to x = 25, its holder to 28; y to -5 and -8.
    for (p, held, role, gap) in [
        (wall(25.0 + 0.9 * BAND), false, "checked", 0.9 * BAND),
        (wall(25.0 - 0.9 * BAND), false, "checked", -0.9 * BAND),
        (wall(28.0 - 0.9 * BAND), true, "holder", -0.9 * BAND),
        (post(8.0 + 0.9 * BAND), false, "checked", -0.9 * BAND),
        (post(5.0 + 0.9 * BAND), true, "holder", -0.9 * BAND),
        // With a thickness on it.
        (left(2.0, wall(27.0 - 0.9 * BAND)), false, "checked", 2.0 - 0.9 * BAND),
        (left(2.0, post(6.0 + 0.9 * BAND)), false, "checked", 2.0 - 0.9 * BAND),
        (left(2.0, wall(30.0 - 0.9 * BAND)), true, "holder", 2.0 - 0.9 * BAND),
        (left(-0.3, wall(24.7 - 0.9 * BAND)), false, "checked", -0.3 - 0.9 * BAND),
    ] {
        let (c, said) = with(&p, held);
        assert!(c.is_proved(), "{said:?}");
        let s = c.statements[0].surfaces.iter().find(|s| s.role == role).expect("a bound");
        assert!((s.least - gap).abs() < 1e-9 && s.name == p.name.name.as_str(), "{s:?}");
    }
    for (p, held, what, depth) in [
        (wall(25.0 - 1.5 * BAND), false, "checked surface WALL", 0.5 * BAND),
        (wall(27.0), true, "checked surface WALL with the holder", 1.0 - BAND),
        (post(8.0 + 3.0 * BAND), true, "checked surface POST with the holder", 3.0 + 2.0 * BAND),
        (post(5.0 + 3.0 * BAND), true, "checked surface POST with the holder", 2.0 * BAND),
        (boss(4.0), true, "checked surface BOSS with the holder", 5.0),
        (left(2.0, wall(27.0 - 1.5 * BAND)), false, "checked surface WALL", 0.5 * BAND),
        (left(2.0, post(6.0 + 3.0 * BAND)), false, "checked surface POST", 2.0 * BAND),
        (
            left(2.0, wall(30.0 - 1.5 * BAND)),
            true,
            "checked surface WALL with the holder",
            0.5 * BAND,
        ),
        (left(-0.3, wall(24.7 - 1.5 * BAND)), false, "checked surface WALL", 0.5 * BAND),
    ] {
        let (c, _) = with(&p, held);
        let fault = c.statements[0].fault.clone().expect("a fault");
        assert!(c.refuted > 0 && fault.gouge && fault.surface == what, "{fault:?}");
        assert!(fault.depth > 0.85 * depth, "{fault:?}");
    }
    // The part surface is held off by the holder where it is checked.
    let tall = square(|x, _| if x > 17.0 { 40.0 } else { 0.0 });
    for (guarded, faults) in [(false, false), (true, true)] {
        let place = upright(&[[-20.0, 10.0, 35.0], [-6.0, 10.0, 35.0]]);
        let high =
            Raised { up: 1.0, profile: Profile::new(&Cutter::mill(60.0, 0.0, 3.0)).expect("") };
        let own = Milling { holder: vec![high], guarded, ..milling(&tall, None) };
        let (c, _) = judge(own, place);
        let holder = c.statements[0].fault.as_ref().map(|f| f.surface.clone());
        assert_eq!(c.refuted > 0, faults, "{holder:?}");
        assert!(!faults || holder.is_some_and(|s| s == "part surface FLOOR with the holder"));
    }
}

#[test]
fn cutter_and_holder_keep_to_the_side_that_the_tool_comes_from() {
    let flat = square(|_, _| 0.0);
    let path = upright(&[[9.0, 10.0, 0.0], [11.0, 10.0, 0.0]]);
    // The cutter of radius 5 ends at 40; the holder of radius 8 begins at 50.
    let judged = |form: Form, from: Option<[f64; 3]>| {
        let own = Milling {
            plain: vec![plain("K", form)],
            holder: vec![Raised { up: 50.0, ..holder() }],
            ..milling(&flat, None)
        };
        let mut verifier = Verifier::new(Effort::Full);
        let [cutter, motion] = records(own, path.clone());
        verifier.push(&cutter);
        if let Some(from) = from {
            let motion =
                Motion { kind: MotionKind::From, points: upright(&[from]), ..Motion::default() };
            verifier.push(&Record { origin: Origin::default(), kind: Kind::Motion(motion) });
        }
        verifier.push(&motion);
        let (certificate, _) = verifier.finish();
        let fault = certificate.statements[0].fault.clone();
        (certificate.is_proved(), fault.map(|f| (f.surface, f.depth)))
    };
    let plane = |z: f64| Form::Plane(Plane { n: Vec3::z(), d: z });
    let ball = |radius: f64| Form::Sphere(Sphere { center: Vec3::new(10.0, 10.0, 6.0), radius });
    let bar = |radius: f64| {
        Form::Cylinder(Cylinder { point: Vec3::new(10.0, 0.0, 6.0), axis: Vec3::y(), radius })
    };
    let (above, inside) = (Some([10.0, 10.0, 90.0]), Some([10.0, 10.0, 1.0]));
    for from in [above, inside, None] {
        assert!(judged(plane(-3.0), from).0 && judged(plane(75.0), inside).0);
    }
    let refuted = |form: Form, from: Option<[f64; 3]>, what: &str, depth: f64| {
        let (_, fault) = judged(form, from);
        let (surface, deep) = fault.expect("a fault");
        assert_eq!(surface, what);
        assert!(deep > 0.85 * depth && deep < depth * 1.001, "{deep} {depth}");
    };
    // A plane between them stands in the way of the one or the other, as the tool comes from below or from above.
    refuted(plane(45.0), inside, "checked surface K with the holder", 70.0 - 45.0 - BAND);
    refuted(plane(45.0), above, "checked surface K", 45.0 - BAND);
    // Who comes into a ball or a bar from above cuts it; who stands in it is in a bowl or a trough, open above.
    refuted(ball(9.5), above, "checked surface K", 14.5 - BAND);
    refuted(bar(9.5), above, "checked surface K", 14.5 - BAND);
    for from in [inside, None] {
        assert!(judged(ball(9.0 - 0.9 * BAND), from).0 && judged(bar(9.0 - 0.9 * BAND), from).0);
        let wide = "checked surface K with the holder";
        refuted(ball(8.5), from, wide, 0.5 - BAND);
        refuted(bar(8.5), from, wide, 0.5 - BAND);
        refuted(ball(5.5), from, wide, 3.5 - BAND);
    }
}

#[test]
fn a_tool_that_gets_out_of_the_way_is_proved_while_it_turns() {
    // About the point that the ball stands on, away from a wall at x = 9, as AVCTRL tilts it.
    let flat = square(|_, _| 0.0);
    let lean = |deg: f64| {
        let ta = Vec3::new(-trig::sin_deg(deg), 0.0, trig::cos_deg(deg));
        Position { te: Vec3::new(4.0, 10.0, 5.0) - ta * 5.0, ta }
    };
    let wall = Plane { n: Vec3::x(), d: 9.0 - 0.5 * BAND };
    let roof = Plane { n: Vec3::z(), d: 40.2 };
    let at = |form: Plane, degrees: [f64; 2], raised: Option<Raised>| {
        let own = Milling {
            plain: vec![plain("WALL", Form::Plane(form))],
            holder: raised.into_iter().collect(),
            ..milling(&flat, None)
        };
        judge(own, degrees.map(lean).to_vec()).0
    };
    assert!(at(wall, [0.0, 20.0], None).is_proved());
    assert!(at(wall, [-1.0, 20.0], None).refuted > 0);
    // The holder is clear where it leans by 20 degrees and not where it stands upright.
    let long = Raised { up: 40.0, ..holder() };
    assert!(at(wall, [15.0, 30.0], Some(long)).is_proved());
    assert!(at(wall, [0.0, 30.0], Some(long)).refuted > 0);
    // Between two leaning positions the rim of the top rises to its highest.
    assert!(at(roof, [-30.0, -20.0], None).is_proved());
    assert!(at(roof, [-30.0, 30.0], None).refuted > 0);
}

#[test]
fn what_is_left_between_passes_is_bounded() {
    let flat = square(|_, _| 0.0);
    for step in [1.0_f64, 2.5] {
        let ridge = 5.0 - (25.0 - 0.25 * step * step).sqrt();
        let path = upright(&passes(step, 0.0));
        let (c, said) = judge(milling(&flat, Some(ridge - BAND + 1e-4)), path.clone());
        assert!(c.is_proved(), "{step} {said:?}");
        let (c, _) = judge(milling(&flat, Some(ridge - BAND - 1e-4)), path.clone());
        let fault = c.statements[0].fault.clone().expect("a ridge");
        assert!(!fault.gouge && c.refuted == 1 && fault.depth < 1.1e-4, "{fault:?}");
        // A pass that was left out: the ridge beside the way across is told to a twentieth where it is highest.
        let mut short = path;
        short.drain(6..8);
        let (c, _) = judge(milling(&flat, Some(ridge)), short);
        assert!(c.refuted > 0, "{step}");
        let fault = c.statements[0].fault.clone().expect("a ridge");
        let cos = 20.0 / trig::hypot(20.0, 2.0 * step);
        let half = 2.0 * step * cos / (1.0 + cos);
        let highest = 5.0 - (25.0 - half * half).sqrt();
        let told = fault.depth + ridge + BAND;
        assert!((0.94 * highest..=highest + 1e-9).contains(&told), "{told} of {highest}");
    }
    // Where the tool got out of the way that is proved too, and what stands higher is told and not refuted.
    for (step, proved) in [(1.0_f64, true), (2.5, false)] {
        let mut lifted = milling(&flat, Some(0.1));
        lifted.scallop.as_mut().expect("set").excused = Some("the tool got out of the way");
        let (c, said) = judge(lifted, upright(&passes(step, 0.0)));
        assert_eq!((c.is_proved(), c.refuted, c.undecided), (proved, 0, u64::from(!proved)));
        let ridge = 5.0 - (25.0 - 0.25 * step * step).sqrt();
        let depth = c.statements[0].fault.as_ref().map(|f| f.depth);
        let over = ridge - 0.1 - BAND;
        let about = |d: f64| (over - 0.06 * ridge..over + 1e-9).contains(&d);
        assert!(proved || depth.is_some_and(about), "{depth:?} {said:?}");
    }
    // A statement that has put out nothing claims nothing.
    let (c, said) = judge(milling(&flat, Some(0.1)), Vec::new());
    assert_eq!((c.refuted, c.undecided, said.len()), (0, 0, 0));
    // Where the region is not known that is said.
    let mut unknown = milling(&flat, Some(0.1));
    unknown.scallop.as_mut().expect("set").extent = Extent::Unknown("the tool end is led");
    let (c, said) = judge(unknown, upright(&passes(1.0, 0.0)));
    assert_eq!((c.undecided, said[0].code), (1, codes::UNPROVED));
    assert_eq!(said[0].notes, ["the tool end is led"]);
}

#[test]
fn what_is_left_between_askew_passes_is_bounded_within_their_outline() {
    let flat = square(|_, _| 0.0);
    // Passes askew to both parameters, over a square of 8 that stands on its corner about the middle.
    let (along, over) = (Vec3::new(0.6, 0.8, 0.0), Vec3::new(-0.8, 0.6, 0.0));
    let place = |s: f64, t: f64| Vec3::new(10.0, 10.0, 0.0) + along * s + over * t;
    let way = |step: f64, n: i32| {
        let pass = |i: i32| {
            let t = step * f64::from(i) - 4.0;
            let ends = if i % 2 == 0 { [-4.0, 4.0] } else { [4.0, -4.0] };
            ends.map(|s| Position::upright(place(s, t)))
        };
        (0..=n).flat_map(pass).collect::<Vec<_>>()
    };
    let outline = |size: f64, along: f64| {
        let ends = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        let uv = |p: Vec3| [p.x / 5.0, p.y / 5.0];
        let corners = ends.map(|(s, t)| uv(place(s * along, t * size)));
        let lines = (0..4).map(|i| [corners[i], corners[(i + 1) % 4]]).collect();
        Extent::Outline(Outline { lines, along: 0 })
    };
    let asked = |height: f64, extent: Extent| Milling {
        scallop: Some(Scallop { height, extent, excused: None, links: Vec::new() }),
        ..milling(&flat, None)
    };
    for (step, n) in [(2.0_f64, 4), (4.0, 2)] {
        let ridge = 5.0 - (25.0 - 0.25 * step * step).sqrt();
        let (c, said) = judge(asked(ridge - BAND + 1e-4, outline(4.0, 4.0)), way(step, n));
        assert!(c.is_proved(), "{step} {said:?}");
        assert!(c.statements[0].surfaces.iter().any(|s| s.role == "scallop"));
        let (c, _) = judge(asked(ridge - BAND - 1e-4, outline(4.0, 4.0)), way(step, n));
        let fault = c.statements[0].fault.clone().expect("a ridge");
        assert!(!fault.gouge && c.refuted == 1 && fault.depth < 1.1e-4, "{fault:?}");
        // Beyond the passes nothing was cut.
        let (c, _) = judge(asked(ridge, outline(6.0, 6.0)), way(step, n));
        assert!(c.refuted > 0, "{step}");
        // A little beyond their ends the ridge is cleared where the tool steps across, and stands where it does not.
        let link = |i: i32, s: f64| {
            [i, i + 1].map(|i| Position::upright(place(s, step * f64::from(i) - 4.0)))
        };
        let links: Vec<_> = (0..n).flat_map(|i| [link(i, -4.0), link(i, 4.0)]).collect();
        let mut beyond = asked(ridge - BAND + 1e-4, outline(4.0, 4.1));
        let (c, _) = judge(beyond.clone(), way(step, n));
        assert!(c.refuted > 0, "{step}");
        beyond.scallop.as_mut().expect("asked").links = links;
        let (c, said) = judge(beyond.clone(), way(step, n));
        assert_eq!((c.refuted, c.undecided, said[0].code), (0, 1, codes::CORNERS));
        // What stands between passes is no corner.
        let mut torn = way(step, n);
        torn[2] = torn[3];
        let (c, _) = judge(beyond, torn);
        assert!(c.refuted > 0, "{step}");
    }
}

#[test]
fn a_ball_that_stands_on_a_wave_with_turning_axis_is_proved() {
    let wave = square(|x, y| 0.5 * trig::sin(0.15 * x) * trig::cos(0.1 * y));
    let place = |x: f64, deep: f64| {
        let d = wave.at(x / 5.0, 1.7);
        let n = d.normal().expect("regular");
        Position { te: d.point - n * deep, ta: n }
    };
    let path: Vec<Position> = (1..60).map(|i| place(f64::from(i) / 3.0, 0.0)).collect();
    let (c, said) = judge(milling(&wave, None), path);
    assert!(c.is_proved(), "{said:?}");
    let path: Vec<Position> = (1..60).map(|i| place(f64::from(i) / 3.0, 2.0 * BAND)).collect();
    assert_eq!(judge(milling(&wave, None), path).0.refuted, 59);
}

#[test]
fn the_map_shows_what_is_cut_and_what_is_left() {
    let flat = square(|_, _| 0.0);
    let path = |low: f64| {
        let mut points = passes(1.0, 0.0);
        (points[20][2], points[21][2]) = (low, low);
        deviation_svg(&records(milling(&flat, Some(0.05)), upright(&points))).expect("a map")
    };
    let [green, pale, red] =
        ["#66bd63", "#c7e9b4", "#a50026"].map(|color| format!("<path fill=\"{color}\""));
    let good = path(0.0);
    assert!(good.contains(&green) && good.contains(&pale) && !good.contains(&red));
    assert!(good.contains("FLOOR over u and v: deviation 0.0"), "{}", &good[..400]);
    let deep = path(-0.1);
    assert!(deep.contains(&red) && deep.contains("deviation -0.09"), "{}", &deep[..400]);
    for means in ["cut in, over", "within tolerance", "scallop as allowed", "not reached"] {
        assert_eq!(good.matches(means).count(), if means == "cut in, over" { 2 } else { 1 });
    }
    assert!(deviation_svg(&[]).is_none());
    // The same in a motion of its own for each point.
    let whole = records(milling(&flat, Some(0.05)), upright(&passes(1.0, 0.0)));
    let [cutter, Record { origin, kind: Kind::Motion(motion) }] = &whole else {
        unreachable!("a motion")
    };
    let one = |p: &Position| Record {
        origin: origin.clone(),
        kind: Kind::Motion(Motion { points: vec![*p], ..motion.clone() }),
    };
    let parts: Vec<Record> = motion.points.iter().map(one).collect();
    assert_eq!(deviation_svg([cutter].into_iter().chain(&parts)), deviation_svg(&whole));
}

/// A thickness is far from the surface itself by many times the tolerance; what is cut down to it is within.
#[test]
fn the_map_shows_what_is_left_over_a_thickness() {
    let flat = square(|_, _| 0.0);
    let map = |thicks: &[f64], off: f64| {
        let all = thicks.iter().flat_map(|&thick| {
            let part = Some(milled("FLOOR", &flat, 1.0, thick));
            let milling = Milling { part, ..milling(&flat, Some(0.05)) };
            records(milling, upright(&passes(1.0, thick + off)))
        });
        deviation_svg(&all.collect::<Vec<_>>()).expect("a map")
    };
    let [red, green, grey] =
        ["#a50026", "#66bd63", "#cccccc"].map(|color| format!("<path fill=\"{color}\""));
    for thick in [-2.0, 0.3, 3.0] {
        let good = map(&[thick], 0.0);
        let said = format!("FLOOR with the thickness {thick} on it, over u and v: deviation 0.0");
        assert!(good.contains(&said), "{thick}: {}", &good[..400]);
        assert!(good.contains(&green) && !good.contains(&red) && !good.contains(&grey), "{thick}");
        let deep = map(&[thick], -0.1);
        assert!(deep.contains(&red) && deep.contains("deviation -0.09"), "{}", &deep[..400]);
        assert!(map(&[thick], 4.0).contains("nothing is cut"), "{thick}");
    }
    // Each thickness has its own panels: what is roughed is not cut into by what is finished.
    let both = map(&[1.0, 0.0], 0.0);
    assert!(both.contains("FLOOR over u and v: deviation 0.0"));
    assert!(both.contains("thickness 1 on it") && !both.contains(&red));
}
