//! Paths of a led tool end (ON) whose contact jumps from one slope to another, and places led to the nearest one.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_contact::{PatchTree, Swept, Tool};
use aptc_geometry::sculpt::{Derivatives, fit_surface};
use aptc_geometry::sculptured::{MeshSpacing, SurfaceDefinition};
use aptc_geometry::{Cutter, Form, Profile, Sculptured, Vec3, trig};
use aptc_protap::{Arg, Kind, NameRef, Record, Units};
use aptc_regional::Regional;

const TOL: f64 = 0.01;
/// Spans of 10 mm each way.
const SPANS: u32 = 6;

/// Hills with hollows between that are narrower than the cutters are wide.
fn hills(x: f64, y: f64) -> f64 {
    8.0 + 5.0 * trig::sin(0.21 * x) * trig::cos(0.17 * y) + 2.0 * trig::cos(0.33 * (x + y))
}

fn mesh(z: impl Fn(f64, f64) -> f64) -> SurfaceDefinition {
    let at = |i: u32, j: u32| {
        let (x, y) = (10.0 * f64::from(i), 10.0 * f64::from(j));
        Vec3::new(x, y, z(x, y))
    };
    let spline = |j: u32| (0..=SPANS).map(|i| at(i, j)).collect();
    SurfaceDefinition::mesh(MeshSpacing::Xyz, (0..=SPANS).map(spline))
}

/// Statements for the line at `v` over the middle of the surface, the tool led over it along z.
fn statements(part: &SurfaceDefinition, cutter: Cutter, v: f64) -> [Kind; 8] {
    let of = |form: Form| Arg::Form { name: NameRef::default(), form: Arc::new(form) };
    let surface = |d: &SurfaceDefinition| of(Form::Ssurf(Arc::new(d.clone())));
    let word = |w: &str| Arg::Word(w.into());
    let numbers = |all: &[f64]| all.iter().map(|x| Arg::Number(*x)).collect::<Vec<_>>();
    let regional = |word: &str, args: Vec<Arg>| Kind::Regional { word: word.into(), args };
    let down = || of(Form::Vector(-Vec3::z()));
    let last = f64::from(SPANS) - 1.0;
    let limits = numbers(&[1.0, last, 1.0, last]);
    let ds = [vec![word("DS"), surface(&mesh(|_, _| 60.0)), word("PARAM")], limits];
    let ps = vec![word("PS"), word("TO"), surface(part), word("PLUS"), Arg::Number(0.0)];
    let from = [vec![word("PATH"), word("DS"), word("PARAM")], numbers(&[1.0, v])];
    [
        Kind::Units(Units::Mm),
        Kind::Cutter(cutter),
        Kind::Intol([TOL; 4]),
        Kind::Outtol([TOL; 4]),
        regional("SCON", [ds.concat(), vec![word("ON"), down()]].concat()),
        regional("SCON", ps),
        regional("SCON", vec![word("AXIS"), of(Form::Vector(Vec3::z()))]),
        regional("SMIL", [from.concat(), vec![word("TANSPL"), word("PLUS")]].concat()),
    ]
}

/// Tool ends of the line.
fn line(part: &SurfaceDefinition, cutter: Cutter, v: f64) -> Vec<Vec3> {
    let kinds = statements(part, cutter, v);
    let mut regional = Regional::default();
    let mut out = Vec::new();
    for kind in kinds {
        out.clear();
        let record = Record { origin: aptc_diagnostics::Origin::default(), kind };
        let done = regional.execute(&record, &mut out);
        assert!(done.is_ok(), "{:?}", regional.take_diagnostics());
    }
    let points = |r: &cl::Record| match &r.kind {
        cl::Kind::Motion(m) => m.points.iter().map(|p| p.te).collect(),
        _ => Vec::new(),
    };
    out.iter().flat_map(points).collect()
}

/// Each cut vector is nowhere deeper than INTOL and nowhere farther off than OUTTOL, and few suffice: where the
/// contact jumps the path has a corner, not a crowd of points.
#[test]
fn the_contact_may_jump() {
    let part = mesh(hills);
    let tree = PatchTree::new(&fit_surface(&part).expect("an even mesh"));
    for cutter in [
        Cutter::mill(12.0, 2.0, 60.0),
        Cutter::mill(10.0, 0.5, 60.0),
        Cutter::mill(14.0, 7.0, 60.0),
        Cutter::mill(8.0, 0.0, 60.0),
    ] {
        let profile = Profile::new(&cutter).expect("a mill");
        for v in [1.3, 2.9, 4.4] {
            let points = line(&part, cutter, v);
            assert!((10..200).contains(&points.len()), "{cutter:?} {v} {}", points.len());
            for pair in points.windows(2) {
                let by = pair[1] - pair[0];
                let tool = Tool { profile: &profile, te: pair[0], ta: Vec3::z() };
                let least = tree.deepest(&Swept { tool, by }, 1e-6).expect("patches").0.distance;
                assert!(least > -TOL - 1e-5, "{cutter:?} {v} at {} {least}", pair[0]);
                for k in 0..=8 {
                    let at = tool.at(pair[0] + by * (f64::from(k) / 8.0));
                    let off = tree.deepest(&at, 1e-6).expect("patches").0.distance;
                    assert!(off < TOL + 1e-5, "{cutter:?} {v} at {} {off}", at.te);
                }
            }
        }
    }
}

/// CLDAT keeps the places of the drive surface that the tool is led over.
#[test]
fn a_section_knows_the_places_of_the_drive_surface() {
    let word = |w: &str| Arg::Word(w.into());
    let section = |w: &str, more: &[&str]| {
        let args = [vec![word(w), Arg::Number(1.0)], more.iter().map(|m| word(m)).collect()];
        Kind::Regional { word: "CLDAT".into(), args: args.concat() }
    };
    let v = 2.5;
    let mut kinds: Vec<Kind> = statements(&mesh(hills), Cutter::mill(8.0, 4.0, 60.0), v).into();
    kinds.insert(kinds.len() - 1, section("START", &["UVPDS", "PDS", "NDS"]));
    kinds.push(section("NOMORE", &[]));
    let mut regional = Regional::default();
    let mut out = Vec::new();
    for kind in kinds {
        let record = Record { origin: aptc_diagnostics::Origin::default(), kind };
        let done = regional.execute(&record, &mut out);
        assert!(done.is_ok(), "{:?}", regional.take_diagnostics());
    }
    let saved = regional.take_saved();
    let [section] = saved.as_slice() else { panic!("one section: {saved:?}") };
    assert!(section.points.len() > 10);
    let mut last = 0.0;
    for p in &section.points {
        let place = p.drive.expect("a place of the drive surface");
        // The drive surface is level at z = 60 with spans of 10; the tool end is below the place but for its tolerance.
        assert!((place.point.z - 60.0).abs() < 1e-9 && (place.normal - Vec3::z()).norm() < 1e-9);
        assert!((place.point.xy() - p.te.xy()).norm() < 2.0 * TOL, "{p:?}");
        let (patch, [a, b]) = place.patch.expect("a patch");
        let u = f64::from((patch - 1) % SPANS) + a;
        assert!((u * 10.0 - place.point.x).abs() < 1e-9 && (b - 0.5).abs() < 1e-9);
        assert!(u >= last);
        last = u;
    }
}

/// The records of a program, the last of which gives what comes back.
fn put_out(regional: &mut Regional, kinds: impl IntoIterator<Item = Kind>) -> Vec<cl::Record> {
    let mut out = Vec::new();
    for kind in kinds {
        out.clear();
        let record = Record { origin: aptc_diagnostics::Origin::default(), kind };
        let done = regional.execute(&record, &mut out);
        assert!(done.is_ok(), "{:?}", regional.take_diagnostics());
    }
    out
}

/// Furrows so steep that the normals in one pass through the ridges beside it.
fn furrows(x: f64, y: f64) -> f64 {
    16.0 * trig::sin(0.16 * x) + 0.5 * trig::cos(0.1 * y)
}

/// TLPROJ/NORMAL,AT: the cutter touches the place of the part surface that is nearest to the one programmed.
#[test]
fn a_place_is_led_to_the_nearest_one() {
    led(hills);
    led(furrows);
}

/// The nearest of many samples, and from there by Newton's method to where the normal meets `p`.
fn nearest(s: &Sculptured, p: Vec3) -> Derivatives {
    const SIDE: u32 = 120;
    let share = |k: u32| f64::from(SPANS) * f64::from(k) / f64::from(SIDE);
    let places = (0..=SIDE * (SIDE + 2)).map(|k| [share(k % (SIDE + 1)), share(k / (SIDE + 1))]);
    let far = |uv: &[f64; 2]| (s.at(uv[0], uv[1]).point - p).norm();
    let [mut u, mut v] = places.min_by(|a, b| far(a).total_cmp(&far(b))).expect("samples");
    for _ in 0..20 {
        let d = s.at(u, v);
        let w = d.point - p;
        let (g, h) = (w.dot(&d.u), w.dot(&d.v));
        let (a, c) = (d.u.norm_squared() + w.dot(&d.uu), d.v.norm_squared() + w.dot(&d.vv));
        let b = d.u.dot(&d.v) + w.dot(&d.uv);
        let det = a * c - b * b;
        (u, v) = (u + (b * h - c * g) / det, v + (b * g - a * h) / det);
    }
    s.at(u, v)
}

fn led(height: fn(f64, f64) -> f64) {
    let part = mesh(height);
    let fitted = fit_surface(&part).expect("an even mesh");
    let of = |form: Form| Arg::Form { name: NameRef::default(), form: Arc::new(form) };
    let word = |w: &str| Arg::Word(w.into());
    let regional = |word: &str, args: Vec<Arg>| Kind::Regional { word: word.into(), args };
    let surface = of(Form::Ssurf(Arc::new(part)));
    let radius = 1.0;
    let mut milling = Regional::default();
    let ps = vec![word("PS"), word("TO"), surface, word("PLUS"), Arg::Number(0.0)];
    put_out(
        &mut milling,
        [
            Kind::Units(Units::Mm),
            Kind::Cutter(Cutter::mill(2.0 * radius, radius, 60.0)),
            Kind::Intol([TOL; 4]),
            Kind::Outtol([TOL; 4]),
            regional("SCON", ps),
        ],
    );
    for k in 0..12 {
        let f = f64::from(k);
        let (x, y) = (30.0 + 20.0 * trig::sin(f), 30.0 + 20.0 * trig::cos(1.7 * f));
        // Above the surface and below it.
        let p = Vec3::new(x, y, height(x, y) + 1.5 * trig::sin(3.0 * f));
        put_out(&mut milling, [regional("TLPROJ", vec![word("NORMAL"), word("AT")])]);
        let motion = cl::Motion { points: vec![cl::Position::upright(p)], ..cl::Motion::default() };
        // Nothing is known of where the tool comes from.
        milling.stood(None);
        let origin = aptc_diagnostics::Origin::default();
        let mut records = vec![cl::Record { origin, kind: cl::Kind::Motion(motion) }];
        let done = milling.project(&mut records, 0);
        assert!(done.is_ok(), "{:?}", milling.take_diagnostics());
        let cl::Kind::Motion(m) = &records[0].kind else { panic!("a motion stays one") };
        let [position] = m.points.as_slice() else { panic!("one place is one: {m:?}") };
        let center = position.te + Vec3::z() * radius;
        let nearest = nearest(&fitted, p);
        let normal = nearest.normal().expect("a smooth surface");
        let normal = if normal.z > 0.0 { normal } else { -normal };
        let off = (center - (nearest.point + normal * radius)).norm();
        assert!(off < 1e-8, "{k} {position:?} {off:e}");
    }
}
