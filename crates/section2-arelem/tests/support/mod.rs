//! Motion statements as text for tests: forms by name, records made by hand, answers of an oracle.
#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]
#![allow(dead_code, reason = "each test program uses a part of it")]

pub(crate) mod brute;
pub(crate) mod scene;

use std::collections::BTreeMap;
use std::sync::Arc;

use aptc_arelem::{Arelem, Options};
use aptc_cldata as cl;
use aptc_diagnostics::{Diagnostic, Origin};
use aptc_geometry::{
    Circle, Cone, Cutter, Cylinder, Form, Line, Plane, Profile, Quadric, QuadricKind, Sphere, Vec3,
};
use aptc_protap::{
    AxisAngle, Check, Dimension, Direction, Drive, DriveSide, Go, Kind, NameRef, OptionSurface,
    PartSide, Place, Pocket, Record, Relation, Sense, SurfaceRef, ToolAxis,
};
use aptc_testkit::shared;
use serde_json::Value;

/// Forms by name.
pub(crate) type Forms = BTreeMap<String, Form>;

/// What a run gave.
pub(crate) struct Run {
    /// The CL records.
    pub(crate) cl: Vec<cl::Record>,
    /// What went wrong.
    pub(crate) diagnostics: Vec<Diagnostic>,
}

/// The form with the canonical elements `w`.
pub(crate) fn form(kind: &str, w: &[f64]) -> Option<Form> {
    let v = |i: usize| Vec3::new(w[i], w[i + 1], w[i + 2]);
    Some(match kind {
        "POINT" => Form::Point(v(0)),
        "VECTOR" => Form::Vector(v(0)),
        // In a turned reference system a line is any plane.
        "LINE" if w[2] != 0.0 => Form::Plane(Plane::new(v(0), w[3])?),
        "LINE" => Form::Line(Line::new(w[0], w[1], w[3])?),
        "PLANE" => Form::Plane(Plane::new(v(0), w[3])?),
        "CIRCLE" => Form::Circle(Circle { center: v(0), axis: v(3).normalize(), radius: w[6] }),
        "CYLNDR" => Form::Cylinder(Cylinder { point: v(0), axis: v(3).normalize(), radius: w[6] }),
        "SPHERE" => Form::Sphere(Sphere { center: v(0), radius: w[3] }),
        "CONE" => Form::Cone(Cone { vertex: v(0), axis: v(3).normalize(), cos_half: w[6] }),
        "ELLIPS" | "HYPERB" | "GCONIC" | "LCONIC" | "QADRIC" => {
            Form::Quadric(Quadric { kind: QuadricKind::Qadric, c: w.try_into().ok()? })
        }
        _ => return None,
    })
}

/// The forms that an oracle gives for a program; `None` when the folder is absent.
pub(crate) fn forms_of(program: &str) -> Option<Forms> {
    let path = shared(program, &format!("oracle/apt360/{program}.geometry.json"))?;
    let all: BTreeMap<String, Value> =
        serde_json::from_str(&std::fs::read_to_string(path).ok()?).unwrap();
    let numbers = |v: &Value| -> Vec<f64> {
        v["words"].as_array().map_or(Vec::new(), |a| a.iter().filter_map(Value::as_f64).collect())
    };
    let forms = all
        .iter()
        .filter_map(|(name, v)| Some((name.clone(), form(v["type"].as_str()?, &numbers(v))?)));
    Some(forms.collect())
}

/// Runs statements, one a line.
pub(crate) fn run(forms: &Forms, text: &str) -> Run {
    let mut arelem = Arelem::new(Options::default());
    let mut out = Vec::new();
    for (i, line) in text.lines().enumerate() {
        for kind in statement(forms, line) {
            let line = u32::try_from(i + 1).unwrap();
            let origin = Origin { isn: line, line, ..Origin::default() };
            arelem.execute(&Record { origin, kind }, &mut out);
        }
    }
    arelem.finish(&mut out);
    Run { cl: out, diagnostics: arelem.take_diagnostics() }
}

impl Run {
    /// The motions.
    pub(crate) fn motions(&self) -> impl Iterator<Item = (u32, &cl::Motion)> {
        self.cl.iter().filter_map(|r| match &r.kind {
            cl::Kind::Motion(m) => Some((r.origin.line, m)),
            _ => None,
        })
    }

    /// Fails with the messages when there are any.
    pub(crate) fn clean(self) -> Self {
        let text: Vec<_> =
            self.diagnostics.iter().map(|d| format!("{} {:?}", d.message, d.notes)).collect();
        assert!(text.is_empty(), "{text:#?}");
        self
    }

    /// The last position.
    pub(crate) fn end(&self) -> Vec3 {
        self.motions().last().and_then(|(_, m)| m.points.last()).map(|p| p.te).unwrap()
    }

    /// The only code of the diagnostics.
    pub(crate) fn code(&self) -> u16 {
        assert_eq!(self.diagnostics.len(), 1, "{:#?}", self.diagnostics);
        self.diagnostics[0].code.number()
    }
}

pub(crate) fn statement(forms: &Forms, line: &str) -> Vec<Kind> {
    let text: String = line.split("$$").next().unwrap().split_whitespace().collect::<String>();
    let mut out = Vec::new();
    let text = text.to_uppercase();
    let (head, rest) = text.split_once('/').unwrap_or((&text, ""));
    let words: Vec<&str> = head.split(',').filter(|w| !w.is_empty()).collect();
    let args = split(rest);
    for (i, word) in words.iter().enumerate() {
        let last = i + 1 == words.len();
        out.push(one(forms, word, if last { &args } else { &[] }));
    }
    out
}

/// Splits at the commas outside brackets.
fn split(text: &str) -> Vec<String> {
    let (mut out, mut depth, mut cur) = (Vec::new(), 0, String::new());
    for c in text.chars() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            ',' if depth == 0 => {
                out.push(std::mem::take(&mut cur));
                continue;
            }
            _ => {}
        }
        cur.push(c);
    }
    if !text.is_empty() {
        out.push(cur);
    }
    out
}

fn number(s: &str) -> Option<f64> {
    s.parse().ok()
}

fn find(forms: &Forms, s: &str) -> (NameRef, Form) {
    if let Some(inner) = s.strip_prefix('(') {
        let (kind, rest) = inner.trim_end_matches(')').split_once('/').unwrap();
        let w: Vec<f64> = rest.split(',').filter_map(number).collect();
        return (NameRef::default(), form(kind, &w).unwrap());
    }
    let form = forms.get(s).unwrap_or_else(|| panic!("no form {s}")).clone();
    (NameRef { name: s.into(), subscript: 0 }, form)
}

fn surface(forms: &Forms, s: &str) -> SurfaceRef {
    let (name, form) = find(forms, s);
    SurfaceRef { name, form: Arc::new(form) }
}

fn vector(forms: &Forms, s: &str) -> Vec3 {
    match find(forms, s).1 {
        Form::Vector(v) | Form::Point(v) => v,
        _ => panic!("{s} is no vector"),
    }
}

/// Numbers three by three, or vectors by name.
fn vectors(forms: &Forms, args: &[String]) -> Vec<Vec3> {
    let numbers: Vec<f64> = args.iter().filter_map(|a| number(a)).collect();
    if numbers.is_empty() {
        return args.iter().map(|a| vector(forms, a)).collect();
    }
    numbers.chunks(3).map(|c| Vec3::new(c[0], c[1], c.get(2).copied().unwrap_or(0.0))).collect()
}

/// Vectors for each surface; an empty field skips one.
fn some(forms: &Forms, args: &[String]) -> Vec<Option<Vec3>> {
    if args.iter().any(String::is_empty) {
        return args.iter().map(|a| (!a.is_empty()).then(|| vector(forms, a))).collect();
    }
    vectors(forms, args).into_iter().map(Some).collect()
}

fn relation(s: &str) -> Option<Relation> {
    Some(match s {
        "TO" => Relation::To,
        "ON" => Relation::On,
        "PAST" => Relation::Past,
        "TANTO" | "DSTAN" => Relation::Tanto,
        "PSTAN" => Relation::Pstan,
        _ => return None,
    })
}

fn four(args: &[String]) -> [f64; 4] {
    let v: Vec<f64> = args.iter().filter_map(|a| number(a)).collect();
    [0, 1, 2, 3].map(|i| v[i.min(v.len() - 1)])
}

fn place(forms: &Forms, args: &[String]) -> Place {
    if args.iter().all(|a| number(a).is_some()) {
        let v = vectors(forms, args);
        return Place { name: NameRef::default(), point: v[0], axis: v.get(1).copied() };
    }
    let (name, _) = find(forms, &args[0]);
    let axis = (args.len() > 1).then(|| vectors(forms, &args[1..])[0]);
    Place { name, point: vector(forms, &args[0]), axis }
}

fn one(forms: &Forms, word: &str, args: &[String]) -> Kind {
    let direction = match word {
        "GOLFT" => Some(Direction::Golft),
        "GORGT" => Some(Direction::Gorgt),
        "GOFWD" => Some(Direction::Gofwd),
        "GOBACK" => Some(Direction::Goback),
        "GOUP" => Some(Direction::Goup),
        "GODOWN" => Some(Direction::Godown),
        _ => None,
    };
    if let Some(direction) = direction {
        return Kind::Drive(drive(forms, direction, args));
    }
    match word {
        "FROM" => Kind::From(place(forms, args)),
        "GOTO" => Kind::Goto(place(forms, args)),
        "GODLTA" if args.len() == 1 && number(&args[0]).is_some() => {
            Kind::GoDeltaAxis(number(&args[0]).unwrap())
        }
        "GODLTA" => Kind::GoDelta(vectors(forms, args)[0]),
        "GO" | "OFFSET" => {
            let mut surfaces = Vec::new();
            let mut next = Relation::To;
            for a in args {
                match relation(a) {
                    Some(r) => next = r,
                    None => {
                        surfaces.push((next, surface(forms, a)));
                        next = Relation::To;
                    }
                }
            }
            Kind::Go(Go { offset: word == "OFFSET", surfaces })
        }
        "PSIS" => Kind::PartSurface(surface(forms, &args[0])),
        "AUTOPS" => Kind::Autops,
        "NOPS" => Kind::Nops,
        "TLLFT" => Kind::DriveSide(DriveSide::Tllft),
        "TLRGT" => Kind::DriveSide(DriveSide::Tlrgt),
        "TLON" => Kind::DriveSide(DriveSide::Tlon),
        "TLNDON" => Kind::DriveSide(DriveSide::Tlndon),
        "TLONPS" => Kind::PartSide(PartSide::Tlonps),
        "TLOFPS" => Kind::PartSide(PartSide::Tlofps),
        "INDIRV" => Kind::Sense(Sense::Vector(some(forms, args))),
        "INDIRP" => Kind::Sense(Sense::Point(some(forms, args))),
        "SRFVCT" => Kind::SurfaceNormals(some(forms, args)),
        "CUTTER" if args[0] == "OPTION" => Kind::CutterOption {
            surface: if args[1] == "1" { OptionSurface::Part } else { OptionSurface::Drive },
            disk: number(&args[2]).map(|r| (r, number(&args[3]).unwrap())),
        },
        "CUTTER" => {
            let v: Vec<f64> = args.iter().filter_map(|a| number(a)).collect();
            Kind::Cutter(match v.len() {
                1 => Cutter::mill(v[0], 0.0, 5.0),
                2 => Cutter::mill(v[0], v[1], 5.0),
                _ => Cutter {
                    diameter: v[0],
                    corner_radius: v[1],
                    e: v[2],
                    f: v[3],
                    alpha_deg: v[4],
                    beta_deg: v[5],
                    height: v[6],
                },
            })
        }
        "INTOL" => Kind::Intol(four(args)),
        "OUTTOL" => Kind::Outtol(four(args)),
        "THICK" => Kind::Thick(four(args)),
        "MAXDP" => Kind::Maxdp { step: number(&args[0]).unwrap(), length: None },
        "NUMPTS" => Kind::Numpts(args[0].parse().unwrap()),
        "3DCALC" => Kind::Calc(Dimension::Three),
        "2DCALC" => Kind::Calc(Dimension::Two),
        "MULTAX" => Kind::Multax(args.first().is_none_or(|a| a == "ON")),
        "TLAXIS" => Kind::ToolAxis(axis(forms, args)),
        "CUT" => Kind::Cut(true),
        "DNTCUT" => Kind::Cut(false),
        "POCKET" => {
            let v: Vec<f64> = args[..8].iter().filter_map(|a| number(a)).collect();
            #[expect(clippy::cast_possible_truncation, reason = "small flags")]
            let flags = [v[6] as i32, v[7] as i32];
            Kind::Pocket(Pocket {
                radius: v[0],
                cut: v[1],
                finish: v[2],
                feeds: [v[3], v[4], v[5]],
                flags,
                vertices: args[8..].iter().map(|a| vector(forms, a)).collect(),
            })
        }
        _ => Kind::Post {
            word: word.into(),
            args: args.iter().filter_map(|a| number(a)).map(aptc_protap::Arg::Number).collect(),
        },
    }
}

fn axis(forms: &Forms, args: &[String]) -> ToolAxis {
    let surface = |s: &str| if s == "1" { OptionSurface::Part } else { OptionSurface::Drive };
    match args[0].as_str() {
        "NORMPS" => ToolAxis::NormPs,
        "NORMDS" => ToolAxis::NormDs,
        "PARLEL" => ToolAxis::Parallel { surface: surface(&args[1]), radius: None, height: None },
        "ATANGL" => ToolAxis::Angle(AxisAngle {
            surface: surface(&args[1]),
            angle_deg: number(&args[2]).unwrap(),
            reference: args
                .get(3)
                .filter(|a| *a != "CUTANG")
                .map(|_| vectors(forms, &args[3..])[0]),
            cutting_deg: (args.get(3).map(String::as_str) == Some("CUTANG"))
                .then(|| number(&args[4]).unwrap()),
            radius: None,
            height: None,
        }),
        "PERPTO" => ToolAxis::PerpTo(vectors(forms, &args[1..])[0]),
        "1" if args.len() == 1 => ToolAxis::Fixed(Vec3::z()),
        _ => ToolAxis::Fixed(vectors(forms, args)[0]),
    }
}

fn drive(forms: &Forms, direction: Direction, args: &[String]) -> Drive {
    let drive = surface(forms, &args[0]);
    let mut checks = Vec::new();
    let (mut rel, mut nth) = (Relation::To, 1);
    let mut i = 1;
    while i < args.len() {
        let a = &args[i];
        if let Some(r) = relation(a) {
            rel = r;
        } else if args.get(i + 1).is_some_and(|b| b == "INTOF") {
            nth = a.parse().unwrap();
            i += 1;
        } else {
            checks.push(Check { relation: rel, nth, surface: surface(forms, a), branch: false });
            (rel, nth) = (Relation::To, 1);
        }
        i += 1;
    }
    Drive { direction, drive, checks }
}

/// Motion of an oracle: one entry a statement, with its points.
pub(crate) fn expected(program: &str) -> Option<Vec<Vec<Vec3>>> {
    let path = shared(program, &format!("oracle/apt360/{program}.json"))?;
    let records: Vec<Value> = serde_json::from_str(&std::fs::read_to_string(path).ok()?).unwrap();
    let mut groups: Vec<(u64, Vec<Vec3>)> = Vec::new();
    for r in &records {
        let Some(points) = r["points"].as_array() else {
            if r["kind"] == "source" {
                groups.push((0, Vec::new()));
            }
            continue;
        };
        let isn = r["isn"].as_u64().unwrap();
        if groups.last().is_none_or(|g| g.0 != isn && g.0 != 0) {
            groups.push((isn, Vec::new()));
        }
        let last = groups.last_mut().unwrap();
        last.0 = isn;
        last.1.extend(points.iter().map(|p| {
            Vec3::new(p[0].as_f64().unwrap(), p[1].as_f64().unwrap(), p[2].as_f64().unwrap())
        }));
    }
    Some(groups.into_iter().map(|g| g.1).filter(|g| !g.is_empty()).collect())
}

/// Samples every cut vector of every motion along surfaces and asserts that it stays in its bands; the
/// number of cut vectors.
pub(crate) fn assert_in_bands(run: &Run, samples: u32) -> usize {
    let mut profile = Profile::disk(0.0, 0.0).unwrap();
    let mut last: Option<cl::Position> = None;
    let mut count = 0;
    for r in &run.cl {
        match &r.kind {
            cl::Kind::Cutter(c) => profile = Profile::new(c).unwrap(),
            cl::Kind::Motion(m) => {
                if let (Some(control), Some(start)) = (&m.control, last) {
                    let startup = m.kind == cl::MotionKind::Startup;
                    let mut a = start;
                    for b in &m.points {
                        let from = if startup { samples } else { 0 };
                        for i in from..=samples {
                            let p = between(&a, b, f64::from(i) / f64::from(samples));
                            for c in control.drive.iter().chain(&control.part) {
                                in_band(c, &profile, &p, r.origin.line);
                            }
                        }
                        a = *b;
                        count += 1;
                    }
                    if let Some(c) = control.checks.first()
                        && !matches!(c.relation, cl::Relation::Tanto | cl::Relation::Pstan)
                    {
                        in_band(c, &profile, &a, r.origin.line);
                    }
                }
                last = m.points.last().copied().or(last);
            }
            _ => {}
        }
    }
    count
}

fn between(a: &cl::Position, b: &cl::Position, t: f64) -> cl::Position {
    let cos = a.ta.dot(&b.ta).clamp(-1.0, 1.0);
    let across = b.ta - a.ta * cos;
    let sin = across.norm();
    let ta = if sin < 1e-12 {
        a.ta
    } else {
        let (s, c) = aptc_geometry::trig::sin_cos(aptc_geometry::trig::atan2(sin, cos) * t);
        a.ta * c + across * (s / sin)
    };
    cl::Position { te: a.te + (b.te - a.te) * t, ta }
}

fn in_band(c: &cl::Controlled, profile: &Profile, p: &cl::Position, line: u32) {
    let disk = c.disk.map(|[r, h]| Profile::disk(r, h).unwrap());
    let tool = aptc_contact::Tool { profile: disk.as_ref().unwrap_or(profile), te: p.te, ta: p.ta };
    let surface = aptc_geometry::Surface::from_form(&c.form).unwrap();
    let side = if c.side < 0 { aptc_contact::Side::Negative } else { aptc_contact::Side::Positive };
    let (g, low, high) = if c.side == 0 {
        let g = aptc_contact::on(p.te, &surface, side).g;
        let plane = matches!(surface, aptc_geometry::Surface::Plane(_));
        (g, if plane { -c.outtol.max(c.intol) } else { -c.intol }, c.outtol)
    } else {
        (aptc_contact::gap(&tool, &surface, side, c.thick).unwrap().g, -c.intol, c.outtol)
    };
    let slack = 1e-10 * (1.0 + p.te.norm());
    assert!(
        g >= low - slack && g <= high + slack,
        "line {line}: {} {:?} gap {g} not in {low}..{high} at {}",
        c.name.name,
        c.relation,
        p.te
    );
}
