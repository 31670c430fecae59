//! Every format of every table, over random and nearly degenerate arguments: its relation holds to 1e-9
//! of the size, or a diagnostic is given.

use aptc_geometry::{Form, Pattern, Plane, Vec3};
use aptc_vocabulary::{Word, all, word};

use super::case::Case;
use super::generate::Gen;
use super::relations::residuals;
use super::{args, define, n, w};
use crate::define::format::Format;
use crate::define::{Context, Value, table};

/// Samples of each format.
const SAMPLES: u64 = 1500;

/// Least share of the samples of a format that must give a form, or its relation would prove nothing.
const LEAST: u64 = SAMPLES / 12;

/// A pattern of a format as the relations name it.
fn key(format: &Format) -> String {
    format
        .text()
        .replace("XLARGE|XSMALL|YLARGE|YSMALL|ZLARGE|ZSMALL", "modz")
        .replace("POSX|NEGX|POSY|NEGY|XLARGE|XSMALL|YLARGE|YSMALL", "flat")
        .replace("XLARGE|XSMALL|YLARGE|YSMALL", "mod")
        .replace("flat", "POSX|NEGX|POSY|NEGY|XLARGE|XSMALL|YLARGE|YSMALL")
        .replace("POSX|POSY|POSZ|NEGX|NEGY|NEGZ", "dir")
        .replace("increments or number,AT,increment", "steps")
}

/// Sculptured definitions solve nothing: what they keep is tested where they are.
fn is_solved(word: Word) -> bool {
    !matches!(word, word::SCURV | word::SSURF | word::BOUNDS | word::OBJECT)
}

fn every_format() -> Vec<(Word, &'static Format)> {
    all()
        .filter(|w| is_solved(*w))
        .filter_map(|w| table(w).map(|t| (w, t)))
        .flat_map(|(w, t)| t.iter().map(move |f| (w, f)))
        .collect()
}

/// Arguments where the generator's own are no sense: counts, lists, squares.
fn arguments(g: &mut Gen, head: Word, key: &str, format: &Format) -> Vec<Value> {
    let mut out = g.arguments(format);
    let whole = |g: &mut Gen| n(f64::from(u32::try_from(2 + g.below(6)).unwrap()));
    match (head.text(), key) {
        ("CONE", _) => out[2] = n(g.within(1.0, 89.0)),
        ("POINT", "pattern,number") => {
            out[1] = n(f64::from(u32::try_from(1 + g.below(4)).unwrap()));
        }
        // A needle's canonical coefficients cannot hold its point.
        ("ELLIPS" | "HYPERB", _) => (out[2], out[3]) = (n(g.radius()), n(g.radius())),
        ("LCONIC", _) => return conic_data(g, key),
        ("MATRIX", "plane,plane,plane") => {
            let (u, v) = (g.direction(), g.direction());
            let z = u.cross(&v);
            let normals = [u, z.cross(&u), z];
            let level = Plane { n: Vec3::z(), d: 1.0 };
            let plane = |i: usize, g: &mut Gen| {
                Form::Plane(Plane::new(normals[i], g.coordinate()).unwrap_or(level)).into()
            };
            return (0..3).map(|i| plane(i, g)).collect();
        }
        ("PATERN", k) if k.starts_with("LINEAR") && k.ends_with("number") => out[3] = whole(g),
        ("PATERN", "ARC,circle,number,number,CLW|CCLW,number") => out[5] = whole(g),
        ("PATERN", "PARLEL|GRID|PERIM,pattern,vector,number") => out[3] = whole(g),
        ("PATERN", "PARLEL|GRID|PERIM,pattern,pattern") => {
            // The second begins or ends where the first begins or ends.
            let (a, b) = (g.pattern(), g.pattern());
            let (Form::Pattern(first), Form::Pattern(second)) = (&a, &b) else { return out };
            let pick = |g: &mut Gen, p: &Pattern| {
                p.points[if g.below(2) == 0 { 0 } else { p.points.len() - 1 }]
            };
            let way = pick(g, first) - pick(g, second);
            let moved = second.points.iter().map(|p| p + way).collect();
            out[2] = Form::Pattern(Pattern { points: moved }).into();
            out[1] = a.into();
        }
        ("PATERN", k) if k.ends_with("steps") => out.extend(steps(g)),
        ("PATERN", "RANDOM,points and patterns") => {
            for _ in 0..1 + g.below(4) {
                let p = g.vec3();
                out.push(if g.below(3) == 0 { g.pattern().into() } else { Form::Point(p).into() });
            }
        }
        ("TABCYL", _) => tabcyl_data(g, &mut out),
        _ => {}
    }
    out
}

/// Increments, `n,AT,i` among them.
fn steps(g: &mut Gen) -> Vec<Value> {
    let mut out = Vec::new();
    for _ in 0..1 + g.below(4) {
        let step = n(g.radius());
        if g.below(2) == 0 {
            let count = n(f64::from(u32::try_from(1 + g.below(4)).unwrap()));
            out.extend([count, w("AT"), step]);
        } else {
            out.push(step);
        }
        if g.below(4) == 0 {
            out.push(w("INCR"));
        }
    }
    if out.last() == Some(&w("INCR")) {
        out.pop();
    }
    out
}

/// Points along an arch with slopes near its own, or far from it.
fn conic_data(g: &mut Gen, key: &str) -> Vec<Value> {
    let (name, slopes, count) = match key.get(..1) {
        Some("5") => ("5PT", 0, 5),
        Some("4") => ("4PT1SL", 1, 4),
        _ => ("3PT2SL", 2, 3),
    };
    let wild = g.below(4) == 0;
    let (ox, oy, s) = (g.coordinate(), g.coordinate(), g.radius());
    let (bend, lean) = (g.within(0.2, 2.0), g.within(-0.5, 0.5));
    let mut out = vec![w(name)];
    for i in 0..count {
        let x = if wild { g.within(-2.0, 2.0) } else { f64::from(i) - 1.5 + g.within(0.0, 0.3) };
        let y = bend * x * x + lean * x + if wild { g.within(-1.0, 1.0) } else { 0.01 * x * x * x };
        out.extend([n(ox + s * x), n(oy + s * y)]);
        if i < slopes {
            out.push(n(2.0 * bend * x + lean + g.within(-0.1, 0.1)));
        }
    }
    out
}

/// Data of a TABCYL after its heading words: a gentle curve in its plane.
fn tabcyl_data(g: &mut Gen, out: &mut Vec<Value>) {
    let is = |out: &[Value], i: usize, word: Word| out[i] == Value::Word(word);
    let polar = is(out, 0, word::RTHETA) || is(out, 0, word::THETAR);
    let space = is(out, 0, word::XYZ);
    if let Some(i) = out.iter().position(|v| *v == Value::Word(word::TRFORM)) {
        out[i + 1] = g.matrix().into();
    }
    let (rise, swing, s) = (g.within(0.1, 0.7), g.within(0.1, 0.8), g.radius());
    for i in 0..8_u32 {
        let x = f64::from(i);
        let y = swing * aptc_geometry::trig::sin(rise * x);
        let slope = swing * rise * aptc_geometry::trig::cos(rise * x) + g.within(-0.02, 0.02);
        let degrees = 90.0 + aptc_geometry::trig::atan(slope).to_degrees();
        if polar {
            // Seen from a point below, so that the angles run on.
            let (x, y) = (s * (x - 3.5), s * (y + 5.0));
            let r = aptc_geometry::trig::hypot(x, y);
            let angle = aptc_geometry::trig::atan2(y, x).to_degrees();
            let first = is(out, 0, word::RTHETA);
            out.extend([n(if first { r } else { angle }), n(if first { angle } else { r })]);
        } else {
            out.extend([n(s * x), n(s * y)]);
        }
        if space {
            out.push(n(s * 0.1 * g.within(0.0, 1.0)));
        }
        if is(out, 1, word::PTSLOP) {
            out.push(n(slope));
        } else if is(out, 1, word::PTNORM) {
            out.push(n(degrees));
        } else if !space && !is(out, 1, word::FOURPT) && g.below(4) == 0 {
            let (name, value) =
                if g.below(2) == 0 { ("SLOPE", slope) } else { ("NORMAL", degrees) };
            out.extend([w(name), n(value)]);
        }
    }
}

#[test]
fn every_format_keeps_its_relation() {
    let formats = every_format();
    assert!(formats.len() >= 150, "{} formats", formats.len());
    let mut bad = Vec::new();
    for (number, (head, format)) in formats.iter().enumerate() {
        let key = key(format);
        let mut solved = 0;
        for sample in 0..SAMPLES {
            let mut g = Gen::new(sample * 1000 + u64::try_from(number).unwrap());
            let values = arguments(&mut g, *head, &key, format);
            // Lists without a pattern may read more than one; the first row counts.
            let given = args(&values);
            let fitting = table(*head).unwrap().iter().filter(|f| f.fits(&given));
            let texts: Vec<String> = fitting.map(Format::text).collect();
            assert_eq!(texts.first(), Some(&format.text()), "{head}/{values:?}");
            assert!(texts.len() == 1 || head.text() == "TABCYL", "{texts:?} read {values:?}");
            let form = match define(*head, &values) {
                Ok(form) => form,
                Err(error) => {
                    let d = error.diagnostic(&args(&values), aptc_diagnostics::Span::default());
                    assert!(d.is_error() && !d.message.is_empty());
                    continue;
                }
            };
            solved += 1;
            let case = Case { args: &values, form: &form };
            let size = case.size();
            let Some(all) = residuals(head.text(), &key, &case, size) else {
                panic!("{head}/{key} has no property");
            };
            let worst =
                all.iter().fold(0.0_f64, |m, r| if r.is_nan() { f64::NAN } else { m.max(r.abs()) });
            if worst.is_nan() || worst > 1e-9 * size.max(1e-3) {
                bad.push(format!("{head}/{key} sample {sample}: off by {worst:e} of {size:e}\n  {values:?}\n  {form:?}"));
                break;
            }
        }
        if solved < LEAST
            && !bad.last().is_some_and(|b: &String| b.starts_with(&format!("{head}/{key} ")))
        {
            bad.push(format!("{head}/{key}: only {solved} of {SAMPLES} samples give a form"));
        }
    }
    assert!(bad.is_empty(), "{} formats fail:\n{}", bad.len(), bad.join("\n"));
}

#[test]
fn zsurf_gives_the_height_of_flat_points() {
    let plane = Plane::new(Vec3::new(0.2, -0.1, 1.0), 3.0).unwrap();
    let context = Context { zsurf: Some(plane), ..Context::default() };
    let lines = [[0.0, 0.0, 1.0, 2.0], [1.0, 0.0, 0.0, 1.0]];
    let line = |e: [f64; 4]| -> Value { define(word::LINE, &e.map(n)).unwrap().into() };
    for values in [
        vec![n(2.0), n(5.0)],
        vec![w("INTOF"), line(lines[0]), line(lines[1])],
        vec![w("CENTER"), define(word::CIRCLE, &[4.0, 5.0, 6.0, 2.0].map(n)).unwrap().into()],
        vec![Value::Tuple { x: 1.0, y: 1.0, z: None }],
    ] {
        let form = crate::define::define(word::POINT, &args(&values), &context).unwrap();
        let Form::Point(p) = form else { panic!("a point") };
        assert!(plane.distance(p).abs() < 1e-12, "{values:?}");
    }
}
