//! Lines of surfaces and curves: GOLOFT with RADIUS and HIGHT of TLAXIS, GOMILL along a curve.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_cldata::milling::{Extent, Outline};
use aptc_diagnostics::{Diagnostic, codes};
use aptc_geometry::sculpt::fit_curve;
use aptc_geometry::sculptured::{
    CurveDefinition, CurveShape, Knot, MeshSpacing, Smoothing, SurfaceDefinition,
};
use aptc_geometry::{Cutter, Form, Profile, Tool, Vec3};
use aptc_protap::{Arg, AxisAngle, Kind, NameRef, OptionSurface, Place, Record, ToolAxis, Units};
use aptc_regional::Regional;

const TOL: f64 = 0.01;

fn of(form: Form) -> Arg {
    Arg::Form { name: NameRef::default(), form: Arc::new(form) }
}

fn word(w: &str) -> Arg {
    Arg::Word(w.into())
}

fn regional(word: &str, args: Vec<Arg>) -> Kind {
    Kind::Regional { word: word.into(), args }
}

/// Tool ends and axes of all motions, and the messages.
fn run(kinds: Vec<Kind>) -> (Vec<(Vec3, Vec3)>, Vec<Diagnostic>) {
    let mut milling = Regional::default();
    let mut out = Vec::new();
    for kind in kinds {
        let record = Record { origin: aptc_diagnostics::Origin::default(), kind };
        if milling.execute(&record, &mut out).is_err() {
            break;
        }
    }
    let points = |r: &cl::Record| match &r.kind {
        cl::Kind::Motion(m) => m.points.iter().map(|p| (p.te, p.ta)).collect(),
        _ => Vec::new(),
    };
    (out.iter().flat_map(points).collect(), milling.take_diagnostics())
}

fn prepared(cutter: Cutter, axis: ToolAxis) -> Vec<Kind> {
    vec![
        Kind::Units(Units::Mm),
        Kind::Cutter(cutter),
        Kind::Intol([TOL; 4]),
        Kind::Outtol([TOL; 4]),
        Kind::ToolAxis(axis),
    ]
}

/// A wall that leans and bends, ruled upwards: the flank lies along the rulings, and HIGHT says which place of
/// it is on the line.
#[test]
fn a_flank_along_rulings_touches_at_its_hight() {
    let foot = |x: f64| Vec3::new(x, 0.004 * (x - 30.0) * (x - 30.0), 0.0);
    let row =
        |z: f64| (0..7).map(|i| foot(10.0 * f64::from(i)) + Vec3::new(0.0, 0.2 * z, z)).collect();
    let wall = SurfaceDefinition::mesh(MeshSpacing::Ruled, [row(0.0), row(20.0)]);
    let goloft = |height: Option<f64>| {
        let axis = ToolAxis::Parallel { surface: OptionSurface::Part, radius: None, height };
        let mut all = prepared(Cutter::mill(10.0, 2.0, 50.0), axis);
        let line = [word("VCONST"), Arg::Number(0.5)];
        let args = [vec![of(Form::Ssurf(Arc::new(wall.clone())))], line.to_vec()].concat();
        all.push(regional("GOLOFT", args));
        run(all)
    };
    let (low, told) = goloft(Some(12.0));
    assert!(told.iter().all(|d| d.code != codes::CONTACT_NOT_CHOSEN), "{told:?}");
    assert!(low.len() > 4);
    let surface = aptc_geometry::sculpt::fit_surface(&wall).expect("a ruled mesh");
    for (te, ta) in &low {
        // The place of the flank 12 above the tool end is 5 off the axis, next to the line.
        let axis = te + ta * 12.0;
        let foot = aptc_geometry::sculpt::nearest_on(&surface, axis);
        assert!((foot.distance - 5.0).abs() <= TOL + 1e-9, "{}", foot.distance);
        assert!((foot.uv[1] - 0.5).abs() < 1e-6, "{:?}", foot.uv);
    }
    let (high, _) = goloft(Some(20.0));
    let (first, second) = (low[0], high[0]);
    assert!((first.0 - first.1 * 8.0 - second.0).norm() < 1e-9);
    // Beyond the flank it is an error.
    let (none, told) = goloft(Some(60.0));
    assert!(none.is_empty());
    assert_eq!(told.iter().map(|d| d.code).collect::<Vec<_>>(), [codes::REGION_VALUE]);
}

/// Level rulings are square to an upright axis, which says nothing of the end to which the tool is to point: it keeps the one it took
/// first, and the one that an axis given before is nearer to.
#[test]
fn along_level_rulings_the_axis_keeps_its_end() {
    let arc = |y: f64| {
        let at = |x: f64, z: f64| Vec3::new(x, y, z);
        vec![at(0.0, 0.0), at(30.0, -8.0), at(60.0, 0.0)]
    };
    let trough = SurfaceDefinition::mesh(MeshSpacing::Ruled, [arc(0.0), arc(60.0)]);
    let axes = |before: Option<Vec3>| {
        let axis = ToolAxis::Parallel { surface: OptionSurface::Part, radius: None, height: None };
        let mut all = prepared(Cutter::mill(6.0, 3.0, 40.0), axis.clone());
        let point = Vec3::new(30.0, 30.0, 150.0);
        let from = Place { name: NameRef::default(), point, axis: None };
        all.push(Kind::From(from));
        all.extend(before.map(|v| Kind::ToolAxis(ToolAxis::Fixed(v))));
        all.push(Kind::ToolAxis(axis));
        let line = [word("VCONST"), Arg::Number(0.7)];
        let args = [vec![of(Form::Ssurf(Arc::new(trough.clone())))], line.to_vec()].concat();
        all.push(regional("GOLOFT", args));
        let (cut, told) = run(all);
        assert!(told.is_empty(), "{told:?}");
        assert!(cut.len() > 4);
        cut
    };
    for (before, y) in [
        (None, None),
        (Some(Vec3::new(0.0, 0.1, 1.0)), Some(1.0)),
        (Some(Vec3::new(0.0, -0.1, 1.0)), Some(-1.0)),
    ] {
        let cut = axes(before);
        let along = y.unwrap_or(cut[0].1.y);
        assert!(cut.iter().all(|(_, ta)| (ta - Vec3::y() * along).norm() < 1e-9), "{cut:?}");
    }
}

/// Along the rulings across lines of a dome the axis neither swings at the steps from line to line nor turns end for end at the top.
#[test]
fn along_rulings_the_axis_goes_on_from_line_to_line() {
    let height =
        |x: f64, y: f64| 10.0 - 5.0 * (x / 30.0 - 1.0).powi(2) - 5.0 * (y / 30.0 - 1.0).powi(2);
    let row = |y: f64| [0.0, 30.0, 60.0].map(|x| Vec3::new(x, y, height(x, y))).to_vec();
    let dome = SurfaceDefinition::mesh(MeshSpacing::Xyz, [row(0.0), row(30.0), row(60.0)]);
    let axis = ToolAxis::Parallel { surface: OptionSurface::Part, radius: None, height: None };
    let mut all = prepared(Cutter::mill(12.0, 0.0, 30.0), axis);
    let form = of(Form::Ssurf(Arc::new(dome)));
    let args = [form, word("VCONST"), Arg::Number(0.0), word("STEPOV"), Arg::Number(0.5)];
    all.push(regional("GOMILL", args.to_vec()));
    let (cut, told) = run(all);
    assert!(told.is_empty(), "{told:?}");
    assert!(cut.len() > 60);
    for pair in cut.windows(2) {
        assert!(pair[0].1.dot(&pair[1].1) > 0.98, "{pair:?}");
    }
}

/// Where the normal, u across v, points down the tool stands below with its shank through the surface, and is told so; MIRROR mills
/// the other side.
#[test]
fn gomill_mills_the_other_side_with_mirror() {
    let row = |x: f64| (0..4).map(|i| Vec3::new(x, 10.0 * f64::from(i), 0.02 * x * x)).collect();
    let sheet = SurfaceDefinition::mesh(MeshSpacing::Xyz, [row(0.0), row(10.0), row(20.0)]);
    let gomill = |more: &[Arg]| {
        let mut all = prepared(Cutter::mill(8.0, 2.0, 50.0), ToolAxis::Fixed(Vec3::z()));
        let line = [word("VCONST"), Arg::Number(0.0), word("STEPOV"), Arg::Number(0.25)];
        let form = of(Form::Ssurf(Arc::new(sheet.clone())));
        let args = [vec![form], line.to_vec(), more.to_vec()].concat();
        all.push(regional("GOMILL", args));
        run(all)
    };
    let (below, told) = gomill(&[]);
    assert!(told.iter().any(|d| d.code == codes::SIDE_FOULS), "{told:?}");
    assert!(below.iter().all(|(te, _)| te.z < -40.0));
    let (above, told) = gomill(&[word("MIRROR")]);
    assert!(told.is_empty(), "{told:?}");
    assert!(above.len() > 20);
    assert!(above.iter().all(|(te, _)| te.z > -0.02 && te.z < 8.1), "{above:?}");
}

/// A round corner touches at one place alone: the numbers do not count, and that is said once.
#[test]
fn where_the_shape_says_it_radius_does_not_count() {
    let row = |y: f64| (0..4).map(|i| Vec3::new(10.0 * f64::from(i), y, 0.0)).collect();
    let floor = SurfaceDefinition::mesh(MeshSpacing::Xyz, [row(0.0), row(10.0), row(20.0)]);
    let goloft = |angle_deg: f64, radius: Option<f64>| {
        let axis = AxisAngle {
            surface: OptionSurface::Part,
            angle_deg,
            reference: None,
            cutting_deg: None,
            radius,
            height: None,
        };
        let mut all = prepared(Cutter::mill(10.0, 2.0, 50.0), ToolAxis::Angle(axis));
        let line = [word("VCONST"), Arg::Number(1.0)];
        let args = [vec![of(Form::Ssurf(Arc::new(floor.clone())))], line.to_vec()].concat();
        all.push(regional("GOLOFT", args));
        run(all)
    };
    let (with, told) = goloft(10.0, Some(1.0));
    assert_eq!(told.iter().map(|d| d.code).collect::<Vec<_>>(), [codes::CONTACT_NOT_CHOSEN]);
    assert_eq!(with, goloft(10.0, None).0);
    // A flat bottom that lies on the floor: the line runs 2 beside the axis, and not under it.
    let (flat, told) = goloft(0.0, Some(2.0));
    assert!(told.is_empty(), "{told:?}");
    for (te, _) in flat {
        let [off, height] = [te.y - 10.0, te.z];
        assert!(height.abs() <= TOL && off.abs() <= 2.0 + 1e-9);
    }
}

/// The tool end goes along the curve within tolerance, from START to THRU and back, or touches one place.
#[test]
fn gomill_along_a_curve() {
    let knots = [[0.0, 0.0, 0.0], [20.0, 10.0, 2.0], [40.0, 5.0, 8.0], [55.0, -10.0, 3.0]]
        .map(|p| Knot { point: Vec3::from(p), ..Knot::default() });
    let curve = CurveDefinition::plain(CurveShape::Spline {
        smoothing: Smoothing::default(),
        knots: knots.to_vec(),
    });
    let fitted = fit_curve(&curve).expect("a spline");
    let gomill = |more: &[Arg]| {
        let mut all = prepared(Cutter::mill(6.0, 3.0, 50.0), ToolAxis::Fixed(Vec3::z()));
        let args = [vec![of(Form::Scurv(Arc::new(curve.clone())))], more.to_vec()].concat();
        all.push(regional("GOMILL", args));
        run(all)
    };
    let n = Arg::Number;
    let along = [word("VCONST"), n(0.0), word("START"), n(0.25), word("THRU"), n(2.5)];
    let (path, told) = gomill(&along);
    assert!(told.is_empty(), "{told:?}");
    assert!((path[0].0 - fitted.at(0.25).point).norm() < 1e-12);
    assert!((path[path.len() - 1].0 - fitted.at(2.5).point).norm() < 1e-12);
    // No place of the curve is farther from the path than the tolerance of the drive.
    for k in 0..=900 {
        let p = fitted.at(0.25 + f64::from(k) * 0.0025).point;
        let off = path.windows(2).map(|w| {
            let way = w[1].0 - w[0].0;
            let t = ((p - w[0].0).dot(&way) / way.norm_squared()).clamp(0.0, 1.0);
            (p - w[0].0 - way * t).norm()
        });
        assert!(off.fold(f64::INFINITY, f64::min) <= TOL, "{k}");
    }
    let mut back = gomill(&[&along[..], &[word("INVERS")]].concat()).0;
    back.reverse();
    assert_eq!(back, path);
    // One place, led to and from by RETR.
    let (touched, _) = gomill(&[word("UCONST"), n(1.0), word("RETR"), n(15.0)]);
    let on = Vec3::new(20.0, 10.0, 2.0);
    let heights: Vec<f64> = touched.iter().map(|p| (p.0 - on).z).collect();
    assert_eq!(heights, [15.0, 0.0, 15.0]);
    // What a curve has not is refused.
    let refused = |more: &[Arg], code: aptc_diagnostics::Code| {
        let (path, told) = gomill(more);
        assert!(path.is_empty());
        assert_eq!(told.iter().map(|d| d.code).collect::<Vec<_>>(), [code]);
    };
    refused(&[word("VCONST"), n(1.0)], codes::REGION_VALUE);
    refused(&[word("UCONST"), n(3.5)], codes::REGION_VALUE);
    refused(&[word("VCONST"), n(0.0), word("SCALOP"), n(0.1)], codes::UNSUPPORTED_MOTION);
}

/// Passes that a surface above leads over the part surface: the region between them is known in the parameters of the part
/// surface, also where these run the other way; where the tool end is led, and may not fit, what stands higher has an excuse.
#[test]
fn the_region_of_passes_that_another_surface_leads() {
    let n = Arg::Number;
    let hill = |x: f64, y: f64| 0.01 * (x - 30.0) * (y - 20.0);
    let part = |turned: bool| {
        let row = |j: u32| {
            let at = |i: u32| {
                let (a, b) = (10.0 * f64::from(i), 10.0 * f64::from(j));
                let (x, y) = if turned { (b, a) } else { (a, b) };
                Vec3::new(x, y, hill(x, y))
            };
            (0..7).map(at).collect()
        };
        SurfaceDefinition::mesh(MeshSpacing::Xyz, (0..7).map(row))
    };
    // Over x from 15 to 45 and y from 12 to 36.
    let lid = |y: f64| [15.0, 30.0, 45.0].map(|x| Vec3::new(x, y, 50.0)).to_vec();
    let above = SurfaceDefinition::mesh(MeshSpacing::Xyz, [lid(12.0), lid(24.0), lid(36.0)]);
    let region = |turned: bool, hold: &str| {
        let surface = |d: &SurfaceDefinition| of(Form::Ssurf(Arc::new(d.clone())));
        let mut all = prepared(Cutter::mill(8.0, 4.0, 50.0), ToolAxis::Fixed(Vec3::z()));
        let limits = [0.0, 2.0, 0.0, 2.0].map(n).to_vec();
        let down = of(Form::Vector(-Vec3::z()));
        let ds = [vec![word("DS"), surface(&above), word("PARAM")], limits, vec![word(hold), down]];
        all.push(regional("SCON", ds.concat()));
        let side = if turned { "MINUS" } else { "PLUS" };
        let ps = vec![word("PS"), word("TO"), surface(&part(turned)), word(side), n(0.0)];
        all.push(regional("SCON", ps));
        all.push(regional("SCON", vec![word("AXIS"), of(Form::Vector(Vec3::z()))]));
        let numbers = |w: &str, x: [f64; 4]| [vec![word(w)], x.map(n).to_vec()].concat();
        all.push(regional("SCON", numbers("FEED", [100.0; 4])));
        all.push(regional("SCON", numbers("STEPOV", [0.1, 4.0, 0.0, 0.0])));
        let from = vec![word("ZIGZAG"), word("DS"), word("PARAM"), n(0.0), n(0.0)];
        let ways = ["TANSPL", "PLUS", "STEPOV", "PLUS"].map(word).to_vec();
        all.push(regional("SMIL", [from, ways].concat()));
        let mut milling = Regional::default();
        let mut out = Vec::new();
        for kind in all {
            let record = Record { origin: aptc_diagnostics::Origin::default(), kind };
            assert!(milling.execute(&record, &mut out).is_ok(), "{:?}", milling.take_diagnostics());
        }
        let promised = out.iter().find_map(|r| match &r.kind {
            cl::Kind::Motion(m) => m.control.as_ref()?.milling.as_ref()?.scallop.clone(),
            _ => None,
        });
        let scallop = promised.expect("a scallop is asked for");
        assert!((scallop.height - 0.1).abs() < 1e-15);
        assert_eq!(scallop.excused.is_some(), hold == "ON");
        scallop.extent
    };
    for turned in [false, true] {
        // Nothing but the rectangle that the lid casts.
        let Extent::Outline(Outline { lines, .. }) = region(turned, "AT") else {
            panic!("a region");
        };
        let mut range = [0, 1].map(|k| {
            let all = lines.iter().map(|line| line[0][k]);
            all.fold([f64::INFINITY, f64::NEG_INFINITY], |r, x| [r[0].min(x), r[1].max(x)])
        });
        if turned {
            range.swap(0, 1);
        }
        let area: f64 = lines.iter().map(|[a, b]| a[0] * b[1] - a[1] * b[0]).sum();
        assert!((0.5 * area.abs() - 3.0 * 2.4).abs() < 1e-2, "{area}");
        for (found, asked) in range.iter().flatten().zip([1.5, 4.5, 1.2, 3.6]) {
            // The contact keeps to the line that is cast but for the tolerance.
            assert!((found - asked).abs() < 5e-3, "{range:?}");
        }
    }
    assert!(matches!(region(false, "ON"), Extent::Outline(_)));
}

/// In a hollow the rim of a flat end that stands square to the line comes deeper than its contact: it is lowered less there, or
/// raised, and keeps the band all over.
#[test]
fn the_rim_of_a_flat_end_keeps_the_band_in_a_hollow() {
    let profile = Profile::new(&Cutter::mill(10.0, 0.0, 50.0)).unwrap();
    for hollow in [0.0002, 0.0004, 0.0006] {
        let place = |i: i32, j: i32| {
            let [x, y] = [i, j].map(|i| 15.0 * f64::from(i));
            Vec3::new(x, y, hollow * ((x - 30.0) * (x - 30.0) + (y - 30.0) * (y - 30.0)))
        };
        let bowl: Vec<Vec<_>> = (0..5).map(|j| (0..5).map(|i| place(i, j)).collect()).collect();
        let bowl = SurfaceDefinition::mesh(MeshSpacing::Xyz, bowl);
        let axis = ToolAxis::NormPs;
        let mut all = prepared(Cutter::mill(10.0, 0.0, 50.0), axis);
        let line = vec![of(Form::Ssurf(Arc::new(bowl.clone()))), word("UCONST"), Arg::Number(2.3)];
        let ends = [word("START"), Arg::Number(0.6), word("THRU"), Arg::Number(3.4)];
        all.push(regional("GOLOFT", [line, ends.to_vec()].concat()));
        let (stops, told) = run(all);
        assert!(told.is_empty() && stops.len() > 4, "{told:?}");
        let surface = aptc_geometry::sculpt::fit_surface(&bowl).expect("a mesh");
        let grid = |n: i32| (0..=n).map(move |i| 4.0 * f64::from(i) / f64::from(n));
        let places = grid(160).flat_map(|u| grid(160).map(move |v| [u, v]));
        let places: Vec<Vec3> = places.map(|[u, v]| surface.at(u, v).point).collect();
        let mut deepest = 0.0_f64;
        for ends in stops.windows(2) {
            for t in [0.0, 0.25, 0.5, 0.75, 1.0] {
                let [te, ta] = [ends[0].0.lerp(&ends[1].0, t), ends[0].1.lerp(&ends[1].1, t)];
                let tool = Tool { profile: &profile, te, ta: ta.normalize() };
                let near = places.iter().filter(|p| (*p - te).norm() < 6.0);
                deepest = near.fold(deepest, |d, p| d.max(-tool.distance(*p)));
                let foot = aptc_geometry::sculpt::nearest_on(&surface, te);
                assert!(foot.distance <= TOL + 1e-6, "{hollow}: stands off by {}", foot.distance);
            }
        }
        assert!((0.3 * TOL..=TOL + 1e-6).contains(&deepest), "{hollow}: {deepest}");
    }
}

/// A flat end that the hollow does not hold cuts in wherever it is, and is not lowered for it: what stands lower on its way to the
/// next place is no reason for a short step.
#[test]
fn a_flat_end_goes_on_through_a_hollow_that_does_not_hold_it() {
    let place = |i: i32, j: i32| {
        let [x, y] = [i, j].map(|i| 15.0 * f64::from(i));
        Vec3::new(x, y, 0.02 * (y - 30.0) * (y - 30.0) - 0.015 * (x - 30.0) * (x - 30.0))
    };
    let hollow: Vec<Vec<_>> = (0..5).map(|j| (0..5).map(|i| place(i, j)).collect()).collect();
    let hollow = SurfaceDefinition::mesh(MeshSpacing::Xyz, hollow);
    let mut all = prepared(Cutter::mill(16.0, 0.0, 50.0), ToolAxis::NormPs);
    all.push(Kind::Outtol([0.2 * TOL; 4]));
    let surface = || of(Form::Ssurf(Arc::new(hollow.clone())));
    let numbers = |all: &[f64]| all.iter().map(|x| Arg::Number(*x)).collect::<Vec<_>>();
    let ds = [vec![word("DS"), surface(), word("PARAM")], numbers(&[0.3, 3.5, 0.6, 3.4])].concat();
    all.push(regional("SCON", [ds, vec![word("AT"), of(Form::Vector(Vec3::z()))]].concat()));
    let part = [word("PS"), word("TO"), surface(), word("PLUS"), Arg::Number(0.0)];
    all.push(regional("SCON", part.to_vec()));
    all.push(regional("SCON", vec![word("AXIS"), word("NORMDS")]));
    let from = [vec![word("PATH"), word("DS"), word("PARAM")], numbers(&[0.3, 0.6])].concat();
    all.push(regional("SMIL", [from, vec![word("CRSSPL"), word("PLUS")]].concat()));
    let (stops, told) = run(all);
    assert!(told.is_empty(), "{told:?}");
    // Chords that sag by OUTTOL at a radius of 25 mm are .6 long.
    assert!((20..200).contains(&stops.len()), "{}", stops.len());
}

/// An upright flat end that may not stand off touches a slope with its rim, which leaves each place there at once on one side: what
/// it touches ahead or behind answers for the chord, and its length is that of its sag.
#[test]
fn a_rim_that_may_not_stand_off_goes_on_as_far_as_it_sags() {
    let place = |i: i32, j: i32| {
        let [x, y] = [i, j].map(|i| 15.0 * f64::from(i));
        let [a, b] = [x - 30.0, y - 20.0];
        Vec3::new(x, y, 0.01 * (x + y) - 0.0005 * (a * a + b * b))
    };
    let hill: Vec<Vec<_>> = (0..5).map(|j| (0..5).map(|i| place(i, j)).collect()).collect();
    let hill = SurfaceDefinition::mesh(MeshSpacing::Xyz, hill);
    let mut all = prepared(Cutter::mill(10.0, 0.0, 50.0), ToolAxis::Fixed(Vec3::z()));
    all.extend([Kind::Intol([0.02; 4]), Kind::Outtol([0.0; 4])]);
    let surface = || of(Form::Ssurf(Arc::new(hill.clone())));
    let numbers = |all: &[f64]| all.iter().map(|x| Arg::Number(*x)).collect::<Vec<_>>();
    let ds = [vec![word("DS"), surface(), word("PARAM")], numbers(&[0.3, 3.5, 0.6, 3.4])].concat();
    all.push(regional("SCON", [ds, vec![word("AT"), of(Form::Vector(Vec3::z()))]].concat()));
    let part = [word("PS"), word("TO"), surface(), word("PLUS"), Arg::Number(0.0)];
    all.push(regional("SCON", part.to_vec()));
    all.push(regional("SCON", vec![word("AXIS"), of(Form::Vector(Vec3::z()))]));
    let from = [vec![word("PATH"), word("DS"), word("PARAM")], numbers(&[0.9, 0.6])].concat();
    all.push(regional("SMIL", [from, vec![word("CRSSPL"), word("PLUS")]].concat()));
    let (stops, told) = run(all);
    assert!(told.is_empty(), "{told:?}");
    // Chords that sag by .018 at a radius of 1000 mm are 12 long; of 42 mm a joint of the drive ends one every 15.
    assert!((5..=12).contains(&stops.len()), "{}", stops.len());
}
