//! INTSEC: the curves in which a plane or surfaces meet sculptured surfaces.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_geometry::sculpt::{Cutting, MeetCurve, MeetSide, Sculptured, meet};
use aptc_geometry::{Form, Plane, Vec3};
use aptc_protap::{Arg, CutContact, CutPoint, NameRef};

use crate::cut_vectors::patch_of;
use crate::failure::Failure;
use crate::regional::Regional;
use crate::scon::Words;

/// Curves that the message about them names.
const TOLD: usize = 12;

/// One side of WITH.
#[derive(Default)]
struct Surfaces {
    names: Vec<Box<str>>,
    forms: Vec<Arc<Form>>,
    fitted: Vec<Arc<Sculptured>>,
}

impl Regional {
    /// The points of the curves become those of the open section of CLDAT and the path of the last motion; the
    /// tool stays where it is.
    ///
    /// The plane, and the surfaces before WITH, are the drive surface, the others the part surface: THICK moves
    /// each along its normals. The points lie on both, their chords leave the curves by half of the narrower
    /// band of INTOL and OUTTOL at most (SSV3 puts the points themselves off by an eighth of its band).
    ///
    /// APT: `INTSEC`.
    pub(crate) fn intsec(
        &mut self,
        origin: &Origin,
        args: &[Arg],
        out: &mut Vec<cl::Record>,
    ) -> Result<(), Failure> {
        let mut w = Words(args);
        let plane = match w.0.first() {
            Some(Arg::Form { form, .. }) => plane_of(form),
            _ => None,
        };
        let by = if plane.is_some() { w.form().map(|(name, _)| name) } else { None };
        let mut ones = self.surfaces(&mut w)?;
        w.take("WITH");
        let mut others = self.surfaces(&mut w)?;
        let canon = w.take("CANON");
        if plane.is_some() && others.fitted.is_empty() {
            std::mem::swap(&mut ones, &mut others);
        }
        let first = match plane {
            Some(plane) => Cutting::Plane(plane),
            None => Cutting::Surfaces(ones.fitted.iter().map(AsRef::as_ref).collect()),
        };
        let second: Vec<&Sculptured> = others.fitted.iter().map(AsRef::as_ref).collect();
        let thick = [self.settings.thick_drive, self.settings.thick];
        let tolerance = self.settings.chord();
        let curves = meet((&first, thick[0]), (&second, thick[1]), tolerance)
            .map_err(|why| Failure::NotCut { why: why.to_string().into() })?;
        let shown = match by {
            Some(name) => [shown(name), others.names.join(", ").into()],
            None => [ones.names.join(", ").into(), others.names.join(", ").into()],
        };
        self.diagnostics.push(told(origin, &shown, &curves));
        self.diagnostics
            .extend(curves.iter().find_map(|c| c.lost).map(|p| lost(origin, &shown, p)));
        let ta = self.stand.map_or_else(Vec3::z, |s| s.ta);
        let uvs: Vec<Vec<[[f64; 2]; 2]>> = curves
            .iter()
            .map(|c| c.points.iter().map(|p| p.sides.map(|s| s.uv)).collect())
            .collect();
        let on = |side: &MeetSide, all: &Surfaces| CutContact {
            point: side.foot,
            normal: side.normal,
            patch: all.fitted.get(side.surface).map(|s| patch_of(s, side.uv)),
        };
        let points = |c: &MeetCurve| -> Vec<CutPoint> {
            let point = |p: &aptc_geometry::sculpt::MeetPoint| CutPoint {
                te: p.point,
                ta,
                along: Some(p.along),
                drive: Some(on(&p.sides[0], &ones)),
                part: Some(on(&p.sides[1], &others)),
            };
            c.points.iter().map(point).collect()
        };
        let curves = curves.iter().map(|c| (points(c), c.closed)).collect();
        // Parameters of several surfaces make no outline.
        let one = |all: &Surfaces| match all.forms.as_slice() {
            [form] => Some(Arc::clone(form)),
            _ => None,
        };
        let forms = [one(&ones), one(&others)];
        self.record_curves(curves, [forms[0].as_ref(), forms[1].as_ref()], &uvs, canon, out)
    }

    /// Surfaces up to the next word, each once.
    fn surfaces(&mut self, w: &mut Words<'_>) -> Result<Surfaces, Failure> {
        let mut all = Surfaces::default();
        while let Some((name, form)) = w.form() {
            if all.forms.iter().any(|f| crate::outline::same_form(f, form)) {
                continue;
            }
            all.fitted.push(self.surface(name, form)?);
            all.names.push(shown(name));
            all.forms.push(Arc::clone(form));
        }
        Ok(all)
    }
}

fn plane_of(form: &Form) -> Option<Plane> {
    match form.shape() {
        Form::Plane(p) => Some(*p),
        Form::Line(l) => Some(l.plane()),
        _ => None,
    }
}

fn shown(name: &NameRef) -> Box<str> {
    match (name.name.as_str(), name.subscript) {
        ("", _) => "an unnamed form".into(),
        (n, 0) => n.into(),
        (n, i) => format!("{n}({i})").into(),
    }
}

/// What was found: a note, and a warning when it is nothing.
fn told(origin: &Origin, [one, other]: &[Box<str>; 2], curves: &[MeetCurve]) -> Diagnostic {
    if curves.is_empty() {
        let text = format!("{one} and {other} do not meet: there are no points");
        return Diagnostic::warning(codes::NO_MEETING, origin.span, text)
            .within(origin.trace.clone())
            .help("NUMF(CLDATA) is 0 then; THICK moves the surfaces along their normals");
    }
    let mut from = 1;
    let mut parts = Vec::with_capacity(curves.len());
    for c in curves {
        let to = from + c.points.len() - 1;
        let kind = if c.closed { " (closed)" } else { "" };
        parts.push(format!("points {from} to {to}{kind}"));
        from = to + 1;
    }
    let n = curves.len();
    let noun = if n == 1 { "curve" } else { "curves" };
    let more = n.saturating_sub(TOLD);
    parts.truncate(TOLD);
    if more > 0 {
        parts.push(format!("and {more} more"));
    }
    let text = format!("{one} and {other} meet in {n} {noun}: {}", parts.join(", "));
    Diagnostic::note_at(codes::MEETING, origin.span, text).within(origin.trace.clone())
}

/// A curve that ends where no surface does.
fn lost(origin: &Origin, [one, other]: &[Box<str>; 2], p: Vec3) -> Diagnostic {
    let text = format!(
        "a curve of {one} and {other} ends at {:.4}, {:.4}, {:.4}, where no surface ends: it may go on there",
        p.x, p.y, p.z
    );
    Diagnostic::warning(codes::NO_MEETING, origin.span, text)
        .within(origin.trace.clone())
        .help("move the plane, or one of the two by THICK, a little; REGION takes no such curve")
}
