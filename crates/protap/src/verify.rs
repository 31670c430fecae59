//! What holds for every numeric part program.
//!
//! 1. Numbers are finite.
//! 2. Words are upper case letters and digits; names and texts hold no line ends.
//! 3. Unit vectors of forms have length 1, radii are not negative, the cosine of a cone lies between 0
//!    and 1, and a written form holds no written form.
//! 4. Surfaces of GO, PSIS and motion are surfaces: no POINT, VECTOR, MATRIX, PATERN, SCURV, BOUNDS or
//!    OBJECT.
//! 5. GO has one to three surfaces, and only the third is met at a tangent; an intersection is counted
//!    from 1; INDIRV, INDIRP and SRFVCT have one to three fields, one of them filled, directions not zero.
//! 6. Tolerances, diameter, corner radius and height are not negative; NUMPTS and copies are at least 1;
//!    POCKET has 3 to 20 vertices and known flags.
//! 7. Tool axes are not zero, angles lie between -90 and 90 degrees.
//! 8. COPY follows an INDEX of its number; INDEX with NOMORE closes an open one.
//! 9. Nothing stands after the last FINI, and there is one.

use aptc_diagnostics::{Diagnostic, codes};
use aptc_geometry::{Cutter, Form, Vec3};

use crate::{Arg, Check, Edit, Kind, Record, Relation, Sense, SurfaceRef, ToolAxis};

/// How far the length of a unit vector may be from 1.
const UNIT: f64 = 1e-9;

/// Checks records one by one.
#[derive(Clone, Debug, Default)]
pub struct Verifier {
    /// Numbers of INDEX that were opened, and whether they are still open.
    indices: Vec<(f64, bool)>,
    /// The last record that was not FINI, since the last FINI.
    open: Option<Record>,
    ended: bool,
}

/// Says which rules `records` break.
pub fn verify<'r>(records: impl IntoIterator<Item = &'r Record>) -> Vec<Diagnostic> {
    let mut verifier = Verifier::default();
    let mut messages: Vec<_> = records.into_iter().filter_map(|r| verifier.record(r)).collect();
    messages.extend(verifier.end());
    messages
}

impl Verifier {
    /// The rule that the next record breaks, if it breaks one.
    pub fn record(&mut self, record: &Record) -> Option<Diagnostic> {
        let fault = self.fault(&record.kind);
        if matches!(record.kind, Kind::Fini) {
            self.open = None;
            self.ended = true;
            self.indices.clear();
        } else if self.open.is_none() {
            self.open = Some(record.clone());
        }
        fault.map(|why| told(record, &why))
    }

    /// The rule that the end breaks.
    pub fn end(&self) -> Option<Diagnostic> {
        match &self.open {
            Some(record) if self.ended => Some(told(record, "records stand behind the last FINI")),
            Some(record) => Some(told(record, "the program has no FINI")),
            None => None,
        }
    }

    fn fault(&mut self, kind: &Kind) -> Option<String> {
        match kind {
            Kind::Text { word, text } => is_word(word).or_else(|| one_line(text)),
            Kind::Post { word, args } | Kind::Regional { word, args } => {
                is_word(word).or_else(|| args.iter().find_map(arg))
            }
            Kind::Define { name, form } => one_line(&name.name).or_else(|| fault_of_form(form)),
            Kind::Cutter(c) => cutter(c),
            Kind::CutterOption { disk: Some((radius, height)), .. } => numbers(&[*radius, *height])
                .or_else(|| {
                    (*radius < 0.0 || *height < 0.0).then(|| "a disk of negative size".to_owned())
                }),
            Kind::Intol(t) | Kind::Outtol(t) => numbers(t).or_else(|| {
                t.iter().any(|t| *t < 0.0).then(|| "a tolerance is negative".to_owned())
            }),
            Kind::Thick(t) => numbers(t),
            Kind::Maxdp { step, length } => numbers(&[*step, length.unwrap_or_default()]),
            Kind::Numpts(0) => Some("NUMPTS is 0".to_owned()),
            Kind::ToolAxis(axis) => tool_axis(axis),
            Kind::PartSurface(s) => surface(s),
            Kind::Sense(Sense::Vector(fields)) | Kind::SurfaceNormals(fields) => {
                sense(fields, true)
            }
            Kind::Sense(Sense::Point(fields)) => sense(fields, false),
            Kind::From(place) | Kind::Goto(place) => one_line(&place.name.name)
                .or_else(|| vector(place.point))
                .or_else(|| place.axis.and_then(direction)),
            Kind::Points { name, points } => one_line(&name.name).or_else(|| {
                if points.is_empty() {
                    return Some("GOTO of a pattern without points".to_owned());
                }
                points.iter().find_map(|p| vector(*p))
            }),
            Kind::GoDelta(v) => vector(*v),
            Kind::GoDeltaAxis(d) => numbers(&[*d]),
            Kind::Go(go) => {
                if go.surfaces.is_empty() || go.surfaces.len() > 3 {
                    return Some(format!("GO to {} surfaces", go.surfaces.len()));
                }
                let tangent = |r: &Relation| matches!(r, Relation::Tanto | Relation::Pstan);
                if go.surfaces.iter().take(2).any(|(r, _)| tangent(r)) {
                    return Some("GO at a tangent to the drive or part surface".to_owned());
                }
                go.surfaces.iter().find_map(|(_, s)| surface(s))
            }
            Kind::Drive(drive) => {
                surface(&drive.drive).or_else(|| drive.checks.iter().find_map(check))
            }
            Kind::Pocket(pocket) => numbers(&[pocket.radius, pocket.cut, pocket.finish])
                .or_else(|| numbers(&pocket.feeds))
                .or_else(|| pocket.vertices.iter().find_map(|p| vector(*p)))
                .or_else(|| {
                    let n = pocket.vertices.len();
                    (!(3..=20).contains(&n)).then(|| format!("a pocket of {n} vertices"))
                })
                .or_else(|| {
                    let [o, p] = pocket.flags;
                    let known = (0..=1).contains(&o) && (0..=3).contains(&p);
                    (!known).then(|| format!("flags {o} and {p} of a pocket"))
                }),
            Kind::Edit(e) => self.edit(e),
            _ => None,
        }
    }

    #[expect(clippy::float_cmp, reason = "numbers of ranges are names")]
    fn edit(&mut self, edit: &Edit) -> Option<String> {
        match edit {
            Edit::Index { n, close: false } => {
                self.indices.push((*n, true));
                numbers(&[*n])
            }
            Edit::Index { n, close: true } => {
                let open = self.indices.iter_mut().rev().find(|(i, open)| i == n && *open);
                match open {
                    Some((_, open)) => {
                        *open = false;
                        None
                    }
                    None => Some(format!("INDEX/{n},NOMORE closes no INDEX")),
                }
            }
            Edit::Copy { n, step, count } => numbers(&step.rows()).or_else(|| {
                if *count == 0 {
                    return Some("COPY makes no copies".to_owned());
                }
                (!self.indices.iter().any(|(i, _)| i == n))
                    .then(|| format!("COPY/{n} has no INDEX before it"))
            }),
            Edit::Tracut(Some(m)) => numbers(&m.rows()),
            Edit::Tracut(None) => None,
        }
    }
}

fn told(record: &Record, why: &str) -> Diagnostic {
    Diagnostic::error(codes::BAD_PROTAP_RECORD, record.origin.span, why)
        .within(record.origin.trace.clone())
}

fn numbers(numbers: &[f64]) -> Option<String> {
    numbers.iter().find(|n| !n.is_finite()).map(|n| format!("{n} is no number"))
}

fn vector(v: Vec3) -> Option<String> {
    numbers(&[v.x, v.y, v.z])
}

fn direction(v: Vec3) -> Option<String> {
    vector(v).or_else(|| (v == Vec3::zeros()).then(|| "a direction of no length".to_owned()))
}

fn unit(v: Vec3) -> Option<String> {
    vector(v).or_else(|| {
        ((v.norm() - 1.0).abs() > UNIT).then(|| format!("a unit vector of length {}", v.norm()))
    })
}

fn is_word(word: &str) -> Option<String> {
    let good = !word.is_empty()
        && word.chars().all(|c| c.is_ascii_uppercase() || c.is_ascii_digit() || "._".contains(c));
    (!good).then(|| format!("`{}` is no word", word.escape_debug()))
}

fn one_line(text: &str) -> Option<String> {
    text.contains(['\n', '\r']).then(|| "a text of several lines".to_owned())
}

fn arg(arg: &Arg) -> Option<String> {
    match arg {
        Arg::Number(n) => numbers(&[*n]),
        Arg::Word(word) => is_word(word),
        Arg::Text(text) => one_line(text),
        Arg::Form { name, form } => one_line(&name.name).or_else(|| fault_of_form(form)),
    }
}

/// Why a form breaks rule 1 or 3, if it does.
pub fn fault_of_form(form: &Form) -> Option<String> {
    let radius = |r: f64| (r < 0.0).then(|| format!("a radius of {r}"));
    let own = match form {
        Form::Line(l) => unit(Vec3::new(l.a, l.b, 0.0)),
        Form::Plane(p) => unit(p.n),
        Form::Circle(c) => unit(c.axis).or_else(|| radius(c.radius)),
        Form::Cylinder(c) => unit(c.axis).or_else(|| radius(c.radius)),
        Form::Sphere(s) => radius(s.radius),
        Form::Cone(c) => unit(c.axis).or_else(|| {
            (c.cos_half <= 0.0 || c.cos_half >= 1.0)
                .then(|| format!("a cone whose half angle has the cosine {}", c.cos_half))
        }),
        Form::Written(w) => match &w.shape {
            Form::Written(_) => return Some("a written form in a written form".to_owned()),
            shape => fault_of_form(shape),
        },
        _ => None,
    };
    own.or_else(|| match form {
        Form::Point(v) | Form::Vector(v) => vector(*v),
        form => numbers(&form.canonical()),
    })
}

fn surface(s: &SurfaceRef) -> Option<String> {
    one_line(&s.name.name).or_else(|| fault_of_form(&s.form)).or_else(|| {
        (!s.form.is_surface()).then(|| format!("a {} is no surface", s.form.kind().word()))
    })
}

fn check(check: &Check) -> Option<String> {
    (check.nth == 0).then(|| "intersection 0".to_owned()).or_else(|| surface(&check.surface))
}

fn sense(fields: &[Option<Vec3>], directions: bool) -> Option<String> {
    if fields.len() > 3 || fields.iter().all(Option::is_none) {
        return Some("a sense of direction of no or too many fields".to_owned());
    }
    let check = if directions { direction } else { vector };
    fields.iter().flatten().find_map(|v| check(*v))
}

fn cutter(c: &Cutter) -> Option<String> {
    numbers(&c.values()).or_else(|| {
        let sizes = [c.diameter, c.corner_radius, c.height];
        sizes.iter().find(|s| **s < 0.0).map(|s| format!("a cutter with a size of {s}"))
    })
}

fn angle(degrees: f64) -> Option<String> {
    (degrees.is_nan() || degrees.abs() > 90.0).then(|| format!("an angle of {degrees} degrees"))
}

fn tool_axis(axis: &ToolAxis) -> Option<String> {
    match axis {
        ToolAxis::Fixed(v) | ToolAxis::PerpTo(v) => direction(*v),
        ToolAxis::Parallel { radius, height, .. } => {
            numbers(&[radius.unwrap_or_default(), height.unwrap_or_default()])
        }
        ToolAxis::Angle(a) => angle(a.angle_deg)
            .or_else(|| a.cutting_deg.and_then(angle))
            .or_else(|| a.reference.and_then(direction))
            .or_else(|| numbers(&[a.radius.unwrap_or_default(), a.height.unwrap_or_default()])),
        ToolAxis::Keep | ToolAxis::NormPs | ToolAxis::NormDs | ToolAxis::Last => None,
    }
}
