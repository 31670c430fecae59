//! Passes of cutters with a flat bottom over crests, where the contact jumps from the one rim to the other between two passes.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_contact::{Convex, Swept, Tool};
use aptc_diagnostics::{Diagnostic, codes};
use aptc_geometry::sculpt::fit_surface;
use aptc_geometry::sculptured::{MeshSpacing, SurfaceDefinition};
use aptc_geometry::{Cutter, Form, Plane, Profile, Vec3};
use aptc_protap::{Arg, Kind, NameRef, Record, Units};
use aptc_regional::Regional;

const TOL: f64 = 0.01;

fn mesh(z: impl Fn(f64, f64) -> f64) -> SurfaceDefinition {
    let at = |i: u32, j: u32| {
        let (x, y) = (15.0 * f64::from(i), 15.0 * f64::from(j));
        Vec3::new(x, y, z(x, y))
    };
    let spline = |j: u32| (0..=4).map(|i| at(i, j)).collect();
    SurfaceDefinition::mesh(MeshSpacing::Xyz, (0..=4).map(spline))
}

/// Tool ends of a region over all of the surface but its borders, and what is said.
fn region(
    part: &SurfaceDefinition,
    cutter: Cutter,
    stepover: [f64; 2],
    word: &str,
) -> (Vec<Vec3>, Vec<Diagnostic>) {
    let of = |form: Form| Arg::Form { name: NameRef::default(), form: Arc::new(form) };
    let surface = || of(Form::Ssurf(Arc::new(part.clone())));
    let say = |w: &str| Arg::Word(w.into());
    let numbers = |all: &[f64]| all.iter().map(|x| Arg::Number(*x)).collect::<Vec<_>>();
    let regional = |word: &str, args: Vec<Arg>| Kind::Regional { word: word.into(), args };
    let ds = [vec![say("DS"), surface(), say("PARAM")], numbers(&[0.5, 3.5, 0.53, 3.5])].concat();
    let [scallop, most] = stepover;
    let step = [vec![say("STEPOV")], numbers(&[scallop, most, 0.0, 0.0])].concat();
    let from = [vec![say(word), say("DS"), say("PARAM")], numbers(&[0.5, 0.53])].concat();
    let way = ["TANSPL", "PLUS", "STEPOV", "PLUS"].map(say).to_vec();
    let safe = Form::Plane(Plane { n: Vec3::z(), d: 40.0 });
    let kinds = [
        Kind::Units(Units::Mm),
        Kind::Cutter(cutter),
        Kind::Intol([TOL; 4]),
        Kind::Outtol([TOL; 4]),
        regional("SCON", [ds, vec![say("AT"), of(Form::Vector(-Vec3::z()))]].concat()),
        regional("SCON", vec![say("PS"), say("TO"), surface(), say("PLUS"), Arg::Number(0.0)]),
        regional("SCON", vec![say("AXIS"), of(Form::Vector(Vec3::z()))]),
        regional("SCON", [vec![say("FEED")], numbers(&[0.0; 4])].concat()),
        regional("SCON", vec![say("FEED"), of(safe)]),
        regional("SCON", step),
        regional("SMIL", [from, way].concat()),
    ];
    let mut milling = Regional::default();
    let mut out = Vec::new();
    for kind in kinds {
        out.clear();
        let record = Record { origin: aptc_diagnostics::Origin::default(), kind };
        let done = milling.execute(&record, &mut out);
        assert!(done.is_ok(), "{:?}", milling.take_diagnostics());
    }
    let points = |r: &cl::Record| match &r.kind {
        cl::Kind::Motion(m) => m.points.iter().map(|p| p.te).collect(),
        _ => Vec::new(),
    };
    (out.iter().flat_map(points).collect(), milling.take_diagnostics())
}

/// How far places of the inner part, so high over the surface, are from what the cutter sweeps: the farthest.
fn farthest(part: &SurfaceDefinition, cutter: &Cutter, path: &[Vec3], high: f64) -> f64 {
    let surface = fit_surface(part).expect("a mesh");
    let profile = Profile::new(cutter).expect("a cutter");
    let grid = || (0..=80).map(|i| 1.1 + 1.8 * f64::from(i) / 80.0);
    let mut farthest = f64::NEG_INFINITY;
    for [u, v] in grid().flat_map(|u| grid().map(move |v| [u, v])) {
        let d = surface.at(u, v);
        let n = d.u.cross(&d.v).normalize();
        let x = d.point + n * high;
        let ways = path.windows(2).filter(|w| {
            let way = w[1] - w[0];
            (x - w[0]).xy().norm() < 6.0 + way.norm()
        });
        let far = ways.map(|w| {
            let tool = Tool { profile: &profile, te: w[0], ta: Vec3::z() };
            Swept { tool, by: w[1] - w[0] }.near(x).0
        });
        farthest = farthest.max(far.fold(f64::INFINITY, f64::min));
    }
    farthest
}

fn dome(x: f64, y: f64) -> f64 {
    12.0 - ((x - 30.0) * (x - 30.0) + (y - 30.0) * (y - 30.0)) / 75.0
}

fn ridge(_: f64, y: f64) -> f64 {
    12.0 - (y - 30.0) * (y - 30.0) / 75.0
}

/// With a scallop height nothing higher is left over the crest, by passes that are not all as close together as there.
#[test]
fn passes_are_closer_where_the_contact_jumps() {
    for cutter in [Cutter::mill(10.0, 0.0, 40.0), Cutter::mill(10.0, 1.0, 40.0)] {
        for form in [dome, ridge] {
            let part = mesh(form);
            for word in ["ZIGZAG", "PICKFD"] {
                let (path, told) = region(&part, cutter, [0.1, 0.0], word);
                assert!(told.is_empty(), "{told:?}");
                let far = farthest(&part, &cutter, &path, 0.1 + TOL);
                assert!(far <= 1e-6, "{word} {cutter:?}: {far}");
            }
        }
    }
}

/// A dome whose summit lies between the lines: a pass goes over the summit itself, where those beside it swing round it, and on
/// the flanks passes are as close as the rim's saw teeth ask for. So it is where a joint of the surface lies on the swing.
#[test]
fn a_pass_goes_over_a_summit() {
    let cases = [
        (0.0, "ZIGZAG", [31.3, 28.6]),
        (0.5, "PICKFD", [31.3, 28.6]),
        (0.0, "PICKFD", [30.01, 29.3]),
    ];
    for (corner, word, [x0, y0]) in cases {
        let dome = |x: f64, y: f64| 12.0 - ((x - x0) * (x - x0) + (y - y0) * (y - y0)) / 150.0;
        let part = mesh(dome);
        let cutter = Cutter::mill(10.0, corner, 40.0);
        let (path, told) = region(&part, cutter, [0.03, 0.0], word);
        assert!(told.is_empty(), "{told:?}");
        let far = farthest(&part, &cutter, &path, 0.03 + TOL);
        assert!(far <= 1e-6, "{word} {cutter:?} {x0}: {far}");
    }
}

/// Passes a fixed distance apart leave what they leave there, and that is told with place and height.
#[test]
fn what_a_fixed_step_leaves_over_a_crest_is_told() {
    // Between two corners of radius 2 that touch 3 apart stands what circles leave.
    let cutter = Cutter::mill(10.0, 2.0, 40.0);
    let (path, told) = region(&mesh(ridge), cutter, [0.0, 3.0], "ZIGZAG");
    let [one] = told.as_slice() else { panic!("{told:?}") };
    assert_eq!(one.code, codes::LEFT_STANDING);
    let height = one.message.split(' ').next().and_then(|x| x.parse::<f64>().ok());
    let height = height.unwrap_or_else(|| panic!("{one:?}"));
    let ridge_between = 2.0 - (4.0 - 1.5_f64 * 1.5).sqrt();
    assert!((height - ridge_between).abs() < 0.1, "{one:?}");
    let far = [0.8, 1.02].map(|share| farthest(&mesh(ridge), &cutter, &path, share * height));
    assert!(far[0] > 0.0 && far[1] <= 0.0, "{one:?} {far:?}");
    // Over what is between two flat ends no pass comes, and where they are close enough nothing is told.
    let cutter = Cutter::mill(10.0, 0.0, 40.0);
    let (_, told) = region(&mesh(dome), cutter, [0.0, 8.0], "ZIGZAG");
    assert!(told.len() == 1 && told[0].message.starts_with("all of the material"), "{told:?}");
    let flat = mesh(|x, _| 0.1 * x);
    let (_, told) = region(&flat, cutter, [0.0, 8.0], "ZIGZAG");
    assert!(told.is_empty(), "{told:?}");
}
