//! Positions and paths beside those of CAM-I's SSV3 for its test part 43.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_contact::{PatchTree, Swept, Tool};
use aptc_geometry::sculpt::fit_surface;
use aptc_geometry::sculptured::{MeshSpacing, SurfaceDefinition};
use aptc_geometry::{Cutter, Form, Profile, Vec3};
use aptc_protap::{Arg, Kind, NameRef, Record};
use aptc_regional::Regional;

const TOL: f64 = 0.01;
const THICK: f64 = 0.1;

fn surface() -> SurfaceDefinition {
    let rows = [
        [[0.0, 0.0, 0.0], [2.0, 0.0, 0.1], [3.0, 0.0, 0.13], [4.0, 0.0, 0.0]],
        [[0.0, 1.0, 0.3], [2.0, 1.0, 0.5], [3.0, 1.0, 0.4], [4.0, 1.0, 0.0]],
        [[0.0, 3.0, 0.0], [2.0, 3.0, 0.2], [3.0, 3.0, 0.4], [4.0, 3.0, 0.5]],
    ];
    SurfaceDefinition::mesh(MeshSpacing::Xyz, rows.map(|row| row.map(Vec3::from).to_vec()))
}

fn cutter() -> Cutter {
    Cutter::mill(1.0, 0.5, 5.0)
}

/// Words, numbers and forms as arguments: `S` is the surface, `(x y z)` a vector.
fn args(text: &str, s: &Arc<Form>) -> Vec<Arg> {
    let form = |form: Arc<Form>| Arg::Form { name: NameRef::default(), form };
    text.split(',')
        .map(|word| match word.parse::<f64>() {
            Ok(x) => Arg::Number(x),
            Err(_) if word == "S" => form(Arc::clone(s)),
            Err(_) if word.starts_with('(') => {
                let inner = word.trim_matches(['(', ')']);
                let v: Vec<f64> = inner.split(' ').filter_map(|x| x.parse().ok()).collect();
                form(Arc::new(Form::Vector(Vec3::new(v[0], v[1], v[2]))))
            }
            Err(_) => Arg::Word(word.into()),
        })
        .collect()
}

/// Positions of the last of the statements `word/arguments`.
fn milled(statements: &[&str]) -> Vec<cl::Position> {
    let s = Arc::new(Form::Ssurf(Arc::new(surface())));
    let mut regional = Regional::default();
    let mut out = Vec::new();
    let modal =
        [Kind::Cutter(cutter()), Kind::Intol([TOL; 4]), Kind::Outtol([TOL; 4]), Kind::Multax(true)];
    let given = statements.iter().map(|text| {
        let (word, rest) = text.split_once('/').expect("a word and its arguments");
        Kind::Regional { word: word.into(), args: args(rest, &s) }
    });
    for kind in modal.into_iter().chain(given) {
        out.clear();
        let record = Record { origin: aptc_diagnostics::Origin::default(), kind };
        let done = regional.execute(&record, &mut out);
        assert!(done.is_ok(), "{:?}", regional.take_diagnostics());
    }
    out.into_iter()
        .flat_map(|r| match r.kind {
            cl::Kind::Motion(m) => m.points,
            _ => Vec::new(),
        })
        .collect()
}

const DS_ON: &str = "SCON/DS,S,PARAM,0.3,1.6,0.55,1.8,ON,(0 0 -1)";
const DS_AT: &str = "SCON/DS,S,PARAM,0.3,1.6,0.55,1.8,AT,(0 0 -1)";
const PS: &str = "SCON/PS,TO,S,PLUS,0.1";
const UP: &str = "SCON/AXIS,(0 0 1),PLUS";

#[test]
fn positions_are_those_of_ssv3() {
    let at = |statements: &[&str]| milled(statements)[0];
    // Printed to all digits; SSV3 projects to a fifth of the band and comes closer in practice.
    let on = at(&[DS_ON, PS, UP, "SMIL/POSN,DS,PARAM,0.3,0.55,INCR,(0 0 0.5)"]);
    let theirs = Vec3::new(0.594_830_112_504, 0.536_945_081_162, 0.929_755_514_316);
    assert!((on.te - theirs).norm() < 1e-3, "{}", on.te);
    let touching = at(&[DS_AT, PS, UP, "SMIL/POSN,DS,PARAM,1.4,0.75,INCR,(0 0 0.5)"]);
    let theirs = Vec3::new(2.437_292_969_073, 0.574_139_711_355, 1.006_073_842_591);
    assert!((touching.te - theirs).norm() < 1e-9, "{}", touching.te);
    let leaning =
        at(&[DS_ON, PS, "SCON/AXIS,NORMDS,PLUS", "SMIL/POSN,DS,PARAM,0.3,0.55,INCR,(0 0 0.5)"]);
    let theirs = Vec3::new(-0.100_385_520_384, -0.367_291_558_587, 0.924_672_730_369);
    assert!((leaning.ta - theirs).norm() < 1e-9, "{}", leaning.ta);
    let theirs = Vec3::new(0.585_004_363_093, 0.499_302_154_886, 0.880_123_032_599);
    assert!((leaning.te - theirs).norm() < 1e-3, "{}", leaning.te);
}

/// Along every cut vector the deepest place stays within INTOL, and every vertex within OUTTOL.
#[test]
fn cut_vectors_keep_the_tolerance() {
    let tree = PatchTree::new(&fit_surface(&surface()).expect("an even mesh"));
    let profile = Profile::new(&cutter()).expect("a ball");
    for (ds, smil) in [
        (DS_AT, "SMIL/PATH,DS,PARAM,0.5,1.8,CRSSPL,MINUS"),
        (DS_AT, "SMIL/PATH,DS,PARAM,0.3,0.75,TANSPL,PLUS"),
        (DS_ON, "SMIL/PATH,DS,PARAM,0.3,0.55,TANSPL,PLUS"),
    ] {
        let points = milled(&[ds, PS, UP, smil]);
        assert!(points.len() > 3, "{}", points.len());
        for pair in points.windows(2) {
            let tool = Tool { profile: &profile, te: pair[0].te, ta: pair[0].ta };
            let at = |body: &Swept<'_>| tree.deepest(body, 1e-7).expect("patches").0.distance;
            let end = at(&Swept { tool, by: Vec3::zeros() }) - THICK;
            assert!(end < TOL + 1e-6 && end > -TOL - 1e-6, "{smil} {end}");
            let least = at(&Swept { tool, by: pair[1].te - pair[0].te }) - THICK;
            assert!(least > -TOL - 1e-6, "{smil} {least}");
        }
    }
}
