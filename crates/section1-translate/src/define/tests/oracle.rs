//! Forms of programs that APT-360 has translated, from the same arguments. The answers stand in the folder
//! `shared` beside the project and are not part of it.

use std::collections::BTreeMap;
use std::path::PathBuf;

use aptc_geometry::{Circle, Cylinder, Form, Line, Plane, Quadric, QuadricKind, Sphere, Vec3};
use aptc_vocabulary::find;

use super::{define, n as n_, w};
use crate::define::Value;

/// One definition: program, name, then the statement's words, numbers and names.
const CASES: &[(&str, &str, &str)] = &[
    ("multax", "PL4A", "PLANE PA PB PC"),
    ("multax", "PL4B", "PLANE PARLEL PL4A ZSMALL .5"),
    ("multax", "PL7", "PLANE PB PARLEL PL5"),
    ("multax", "CYL1", "CYLNDR 0 0 0 1 0 1 1.5"),
    ("multax", "CYL2", "CYLNDR PA 0 1 0 .5"),
    ("case4axis", "CYL1", "CYLNDR (0,0,0) V1 1.53"),
    ("case4axis", "LEND", "LINE PARLEL LY XSMALL .5"),
    ("case4axis", "L1", "LINE PARLEL LX YSMALL .125"),
    ("case4axis", "C1", "CIRCLE CENTER PT1 TANTO L1"),
    ("case4axis", "C2", "CIRCLE YLARGE L2 XSMALL OUT C1 RADIUS .03"),
    ("case4axis", "C2B", "CIRCLE YSMALL L2B XSMALL OUT C1B RADIUS .03"),
    ("case4axis", "C3", "CIRCLE YSMALL L1 XSMALL L3 RADIUS .3125"),
    ("3axis_contour", "VA", "VECTOR LENGTH 1 ATANGL -98.5 ZXPLAN"),
    ("3axis_contour", "VB", "VECTOR LENGTH 1 ATANGL 196 YZPLAN"),
    ("3axis_contour", "VPN", "VECTOR VA CROSS VB"),
    ("3axis_contour", "PLTOP", "PLANE PTOP PERPTO VPN"),
    ("3axis_contour", "LCIR", "LINE RIGHT TANTO CLG RIGHT TANTO CSM"),
    ("3axis_contour", "VCON", "VECTOR PTS PTL"),
    ("3axis_contour", "LCNCIR", "LINE PTS PTL"),
    ("3axis_contour", "PLZ", "PLANE PERPTO PLCEN PTS PTL"),
    ("3axis_contour", "PTCON", "POINT INTOF PLCIR PLCEN PLZ"),
    ("3axis_contour", "SPL", "SPHERE CENTER PTL RADIUS 1"),
    ("3axis_contour", "CLG", "CIRCLE CENTER PTL RADIUS 1"),
    ("spoolLT", "P1", "POINT YLARGE INTOF L2 C1OFF"),
    ("spoolLT", "P2", "POINT YSMALL INTOF L3 C1OFF"),
    ("spoolLT", "C2", "CIRCLE XLARGE IN C3 IN C4 RADIUS 19"),
    ("window", "C3", "CIRCLE XLARGE IN C1 IN C2 RADIUS .25"),
    ("window", "C4", "CIRCLE XSMALL IN C1 IN C2 RADIUS .25"),
    ("spool2", "TOPFIL", "CIRCLE XLARGE VRTL YLARGE IN C1 RADIUS .15"),
    ("spool2", "BOTFIL", "CIRCLE XLARGE ANGL YSMALL IN C1 RADIUS .15"),
    ("spool2", "MIDFIL", "CIRCLE XLARGE VRTL YLARGE ANGL RADIUS .15"),
    ("spool2", "SPT", "POINT SCIRC ATANGL 90"),
    ("spool2", "SCIRC", "CIRCLE CENTER (.5,.646,0) TANTO VRTL"),
    ("pocket", "L5", "LINE CP ATANGL 90"),
    ("square", "L2", "LINE PARLEL L1 YSMALL 5"),
    ("square", "MAT1", "MATRIX XYROT 45"),
    ("race_4th", "MAT2", "MATRIX YZROT 30"),
    ("test3", "CONE1", "CONE (0,0,5) (VECTOR) 45"),
    ("test3", "PL2", "PLANE 0 1 1 -4"),
    ("doc-samplePart.full", "C4", "CIRCLE TANTO LY XSMALL P2 RADIUS 1"),
    ("doc-samplePart.full", "P1", "POINT XLARGE INTOF LX C1"),
    ("sample2", "P2", "POINT INTOF Y4A YN"),
    ("sample2", "Y4A", "LINE (79.764,-.238,0) ATANGL 94"),
    ("sample2", "ZDCL(1)", "LCONIC 3PT2SL 79.764 -.238 .0699268 86.79 0 0 83.373 -.069"),
    ("patern", "PAT1", "PATERN LINEAR P3 P2 11"),
    ("patern", "PAT2", "PATERN LINEAR P3 VEC1 5"),
    ("patern", "PAT3", "PATERN LINEAR P2 VEC1 INCR 3 AT .25 INCR 5 AT 1 INCR 7 AT 2"),
    ("patern", "PAT4", "PATERN LINEAR P2 VEC1 INCR 3 2 1 .25 .125"),
    ("patern", "PAT5", "PATERN ARC CPAT 60 200 CLW 6"),
    ("patern", "PAT6", "PATERN ARC CPAT 10 CCLW INCR 2 6 20 60"),
    ("patern", "PAT7", "PATERN ARC CPAT 10 CCLW INCR 2 AT 6 INCR 5 AT 25"),
];

type Answers = BTreeMap<String, serde_json::Value>;

fn answers(program: &str) -> Option<Answers> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/oracle/apt360");
    let path = PathBuf::from(folder).join(format!("{program}.geometry.json"));
    let text = std::fs::read_to_string(path).ok()?;
    serde_json::from_str(&text).ok()
}

fn numbers(v: &serde_json::Value) -> Vec<f64> {
    match v {
        serde_json::Value::Array(all) => all.iter().flat_map(numbers).collect(),
        other => other.as_f64().into_iter().collect(),
    }
}

fn words(answers: &Answers, name: &str) -> Vec<f64> {
    let v = &answers[name];
    numbers(v.get("words").or_else(|| v.get("points")).expect("words or points"))
}

fn form(kind: &str, e: &[f64]) -> Form {
    let at = |i: usize| Vec3::new(e[i], e[i + 1], e[i + 2]);
    match kind {
        "POINT" => Form::Point(at(0)),
        "VECTOR" => Form::Vector(at(0)),
        "LINE" => Form::Line(Line::new(e[0], e[1], e[3]).expect("a line")),
        "PLANE" => Form::Plane(Plane::new(at(0), e[3]).expect("a plane")),
        "CIRCLE" => Form::Circle(Circle { center: at(0), axis: at(3), radius: e[6] }),
        "CYLNDR" => Form::Cylinder(Cylinder { point: at(0), axis: at(3), radius: e[6] }),
        "SPHERE" => Form::Sphere(Sphere { center: at(0), radius: e[3] }),
        "LCONIC" => {
            let c = std::array::from_fn(|i| e[i]);
            Form::Quadric(Quadric { kind: QuadricKind::Lconic, c })
        }
        other => panic!("{other} is not an argument here"),
    }
}

fn argument(answers: &Answers, text: &str) -> Value {
    if text == "(VECTOR)" {
        return Form::Vector(-Vec3::z()).into();
    }
    if let Some(tuple) = text.strip_prefix('(') {
        let e: Vec<f64> =
            tuple.trim_end_matches(')').split(',').map(|x| x.parse().unwrap()).collect();
        return Form::Point(Vec3::new(e[0], e[1], e[2])).into();
    }
    if let Ok(x) = text.parse() {
        return n_(x);
    }
    // Names come first: a program may use a word of another dialect as a name.
    match answers.get(text) {
        Some(answer) => form(answer["type"].as_str().unwrap(), &words(answers, text)).into(),
        None => w(text),
    }
}

#[test]
fn canonical_forms_are_those_of_apt360() {
    let mut checked = 0;
    let mut wrong = Vec::new();
    for (program, name, text) in CASES {
        let Some(answers) = answers(program) else { continue };
        let mut parts = text.split_whitespace();
        let head = find(parts.next().unwrap()).unwrap();
        let args: Vec<Value> = parts.map(|t| argument(&answers, t)).collect();
        let expected = words(&answers, name);
        let size = expected.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
        let close = |e: &[f64], sign: f64| {
            e.len() == expected.len()
                && e.iter().zip(&expected).all(|(x, y)| (sign * x - y).abs() <= 1e-6 * size)
        };
        checked += 1;
        match define(head, &args) {
            Ok(form) if close(&form.canonical(), 1.0) => {}
            Ok(form) if matches!(form, Form::Quadric(_)) && close(&form.canonical(), -1.0) => {}
            found => {
                let found = found.map(|f| f.canonical());
                wrong.push(format!("{program} {name}={text}: {found:?}, not {expected:?}"));
            }
        }
    }
    if checked == 0 {
        println!("skipped: no answers of APT-360 beside the project");
    } else {
        assert_eq!(checked, CASES.len());
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The TABCYLs: program, name, the slope of the first point, of the last.
const CURVES: &[(&str, &str, Option<f64>, Option<f64>)] = &[
    ("tabcyl", "CURV1", Some(0.0), None),
    ("tabcyl", "INVOL", None, None),
    ("sample2", "MHB", Some(1e6), Some(0.0)),
];

#[test]
fn tabcyls_run_as_those_of_apt360() {
    for (program, name, first, last) in CURVES {
        let Some(answers) = answers(program) else {
            println!("skipped: no answers of APT-360 beside the project");
            continue;
        };
        let e = words(&answers, name);
        let n = (e.len() - 11 - 2) / 7;
        let mut args = vec![w("NOZ"), w("SPLINE")];
        for i in 1..=n - 1 {
            args.extend([n_(e[11 + 7 * i]), n_(e[12 + 7 * i])]);
            let slope = if i == 1 {
                first
            } else if i == n - 1 {
                last
            } else {
                &None
            };
            args.extend(slope.iter().flat_map(|s| [w("SLOPE"), n_(*s)]));
        }
        let ours = match define(find("TABCYL").unwrap(), &args).unwrap() {
            Form::Tabcyl(t) => t,
            other => panic!("{other:?}"),
        };
        let theirs = match crate::define::tabcyl::from_elements(&e).unwrap() {
            Form::Tabcyl(t) => t,
            other => panic!("{other:?}"),
        };
        assert_eq!(ours.spans.len(), theirs.spans.len());
        let ends = [(ours.spans[0].start, theirs.spans[0].start), (ours.end, theirs.end)];
        for (a, b) in ends {
            assert!((a - b).norm() < 2e-2, "{name}: straight end {a} {b}");
        }
        let mut worst = 0.0_f64;
        for (x, y) in ours.spans.iter().zip(&theirs.spans).skip(1).take(n - 2) {
            assert!((x.start - y.start).norm() < 1e-9 && (x.length - y.length).abs() < 1e-6);
            for k in 0..=20 {
                let s = x.length * f64::from(k) / 20.0;
                worst = worst.max((x.offset(s) - y.offset(s)).abs());
            }
        }
        println!("{name}: at most {worst:.2e} from APT-360's");
        assert!(worst < 2e-4, "{name}: {worst}");
    }
}
