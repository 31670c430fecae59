//! SCURV: sculptured curves, read and checked; they are fitted by who needs them.

use std::sync::Arc;

use aptc_geometry::sculptured::{
    CurveDefinition, CurveShape, FlowLaw, FlowSpan, SegmentSpan, Smoothing,
};
use aptc_geometry::{Form, Vec2, Vec3};
use aptc_vocabulary::{Word, word};

use super::cursor::{Cursor, apart, bounded, plain};
use super::fault::Fault;
use super::format::Item::{LC, Rest, SC, Tail, W};
use super::format::{Args, Format, row};
use super::meet::{self, Meet};

const TAIL: super::format::Item = Rest("line, circle, POSX .. NEGY, FLOW or TRFORM");

pub(super) const FORMATS: &[Format] = &[
    row(&[W(word::CURSEG), Rest("points, each with TANSPL, CRSSPL or NORMAL,vector")], conic),
    row(&[W(word::SPLINE), Rest("points, each with TANSPL, NORMAL, WEIGHT ..")], spline),
    row(&[W(word::COMBIN), SC, Tail("curves, FLOW or TRFORM")], combined),
    row(&[W(word::SEG), LC, LC, TAIL], stretch),
];

/// Words that pick one of two intersections behind a bound of SEG: POSX is XLARGE and so on.
const CHOICES: &[Word] = &[
    word::POSX,
    word::POSY,
    word::NEGX,
    word::NEGY,
    word::XLARGE,
    word::YLARGE,
    word::XSMALL,
    word::YSMALL,
];

/// Slack in the spans of FLOW and SEG.
const WHOLE: f64 = 1e-7;

fn conic(a: &Args<'_>) -> Result<Form, Fault> {
    let mut c = Cursor::new(a, 1);
    let knots = c.knots(false)?;
    if knots.is_empty() {
        return c.unexpected("a point");
    }
    if knots.len() < 2 {
        return Err(Fault::TooFew { at: c.at, need: 2, found: knots.len(), what: "points" });
    }
    let tangents = knots.iter().filter(|(_, k)| k.tangent.is_some()).count();
    let given = knots.len() + tangents;
    if given > 5 {
        let at = knots.last().map_or(1, |(at, _)| *at);
        return Err(Fault::TooManyConditions { at, need: 5, found: given });
    }
    let size = knots.iter().fold(0.0_f64, |m, (_, k)| m.max(k.point.amax()));
    if knots.len() == 2 && (knots[1].1.point - knots[0].1.point).norm() <= 1e-12 * size {
        return Err(Fault::Coincide { a: knots[0].0, b: knots[1].0 });
    }
    apart(&knots)?;
    finish(
        &mut c,
        CurveShape::Conic(plain(knots)),
        "TANSPL, CRSSPL, NORMAL, a point, FLOW or TRFORM",
    )
}

fn spline(a: &Args<'_>) -> Result<Form, Fault> {
    let mut c = Cursor::new(a, 1);
    let mut smoothing = Smoothing::default();
    c.smoothing(&mut smoothing)?;
    let knots = c.knots(true)?;
    if knots.is_empty() {
        return c.unexpected("a point");
    }
    if knots.len() < 2 {
        return Err(Fault::TooFew { at: c.at, need: 2, found: knots.len(), what: "points" });
    }
    apart(&knots)?;
    let shape = CurveShape::Spline { smoothing, knots: plain(knots) };
    finish(&mut c, shape, "a point, TANSPL, CRSSPL, NORMAL, WEIGHT, LIMIT, FLOW or TRFORM")
}

fn combined(a: &Args<'_>) -> Result<Form, Fault> {
    let mut c = Cursor::new(a, 1);
    let mut curves = Vec::new();
    while let Some(curve) = c.curve() {
        curves.push(curve);
    }
    finish(&mut c, CurveShape::Combined(curves), "a curve, FLOW or TRFORM")
}

/// SEG, one after the other: the base, the two lines or circles that bound it, each with the word that
/// chooses among its intersections.
fn stretch(a: &Args<'_>) -> Result<Form, Fault> {
    let mut c = Cursor::new(a, 2);
    let mut ends = [Vec3::zeros(); 2];
    let mut bounds = [0; 2];
    for i in 0..2 {
        let bound = c.at;
        if a.line(bound).is_err() && a.circle(bound).is_err() {
            return c.unexpected("a line or a circle");
        }
        c.at += 1;
        let choice = c.at;
        let chosen = c.take(CHOICES).map(|_| choice);
        ends[i] = a.context.lift(meeting(a, bound, chosen)?);
        bounds[i] = bound;
    }
    let size = ends[0].amax().max(ends[1].amax());
    if (ends[1] - ends[0]).norm() <= 1e-12 * size {
        return Err(Fault::Coincide { a: bounds[0], b: bounds[1] });
    }
    let shape = match a.circle(1) {
        Ok(circle) if a.line(1).is_err() => CurveShape::Arc {
            center: Vec3::new(circle.center.x, circle.center.y, 0.5 * (ends[0].z + ends[1].z)),
            axis: circle.axis,
            ends,
        },
        _ => CurveShape::Stretch { ends },
    };
    finish(&mut c, shape, "FLOW or TRFORM")
}

/// Where the base meets the bound at `bound`; `choice` is the place of the word that picks one of two.
fn meeting(a: &Args<'_>, bound: usize, choice: Option<usize>) -> Result<Vec2, Fault> {
    let circle = |at: usize| -> Result<(Vec2, f64), Fault> {
        let c = a.circle(at)?;
        Ok((c.center.xy(), c.radius))
    };
    let is_line = |at: usize| a.line(at).is_ok();
    let met = match (is_line(1), is_line(bound)) {
        (true, true) => {
            let (one, other) = (a.line(1)?, a.line(bound)?);
            return meet::lines(&one, &other).ok_or(Fault::Parallel {
                a: 1,
                b: bound,
                one: one.plane(),
                other: other.plane(),
            });
        }
        (true, false) => meet::line_circle(&a.line(1)?, circle(bound)?.0, circle(bound)?.1),
        (false, true) => meet::line_circle(&a.line(bound)?, circle(1)?.0, circle(1)?.1),
        (false, false) => {
            let ((p, r), (q, s)) = (circle(1)?, circle(bound)?);
            meet::circles(p, r, q, s)
        }
    };
    match met {
        Meet::At(one, other) if (one - other).norm() <= 1e-12 * one.amax() => Ok(one),
        Meet::At(one, other) => match choice {
            Some(at) => {
                let lift = |p: Vec2| Vec3::new(p.x, p.y, 0.0);
                a.pick(at, lift(one), lift(other)).map(|p| p.xy())
            }
            None => Err(Fault::Unexpected {
                at: bound + 1,
                expected: "POSX, POSY, NEGX or NEGY, which choose between the two intersections,",
            }),
        },
        Meet::Apart(gap) => Err(Fault::Apart { a: 1, b: bound, gap }),
        Meet::Same => Err(Fault::Coincide { a: 1, b: bound }),
    }
}

/// FLOW, SEG and TRFORM behind a curve.
fn finish(
    c: &mut Cursor<'_, '_>,
    shape: CurveShape,
    expected: &'static str,
) -> Result<Form, Fault> {
    let mut curve = CurveDefinition::plain(shape);
    if c.peek() == Some(word::FLOW) {
        let n = curve.n_spans();
        curve.flow = flow(c, n)?;
        if c.take(&[word::SEG]).is_none() {
            return c.unexpected("SEG, which says how the spans of FLOW are divided,");
        }
        curve.segments = segments(c, n)?;
    }
    curve.map = c.map()?;
    c.end(expected)?;
    bounded(curve.extent(), c.args.context.max_points)?;
    Ok(Form::Scurv(Arc::new(curve)))
}

/// The spans behind FLOW.
fn flow(c: &mut Cursor<'_, '_>, n_spans: Option<usize>) -> Result<Vec<FlowSpan>, Fault> {
    let mut spans = Vec::new();
    let mut last = 0.0;
    c.take(&[word::FLOW]);
    let laws = [word::ARC, word::PARAM, word::ANGLE, word::CHORD];
    while let Some(law) = c.take(&laws) {
        let range = range(c, &mut last, n_spans)?;
        let law = match law {
            word::ARC => FlowLaw::Arc,
            word::PARAM => FlowLaw::Parameter,
            word::ANGLE => FlowLaw::Angle,
            _ => FlowLaw::Chord,
        };
        let mut span = FlowSpan { law, range, tolerance: None, points: Vec::new(), vector: None };
        modifiers(c, &mut span)?;
        spans.push(span);
        c.take(&[word::FLOW]);
    }
    if spans.is_empty() {
        return c.unexpected("ARC, PARAM, ANGLE or CHORD");
    }
    whole(c, last, n_spans)?;
    Ok(spans)
}

/// What follows the two numbers of a span: a tolerance, points and a vector.
fn modifiers(c: &mut Cursor<'_, '_>, span: &mut FlowSpan) -> Result<(), Fault> {
    let most = if span.law == FlowLaw::Chord || span.law == FlowLaw::Angle { 2 } else { 0 };
    loop {
        if c.take(&[word::RELTOL]).is_some() || c.args.is_number(c.at) {
            let at = c.at;
            let t = c.number("a number")?;
            if !(t > 0.0 && t < 1.0) {
                return Err(Fault::Range { at, value: t, need: "between 0 and 1" });
            }
            span.tolerance = Some(t);
            continue;
        }
        let named = c.take(&[word::PIVOT, word::CHDPT, word::PLANO]).is_some();
        let at = c.at;
        if let Some(p) = c.point() {
            if span.points.len() == most {
                return Err(Fault::Unexpected { at, expected: "the next span, SEG or TRFORM" });
            }
            span.points.push(p);
        } else if let Some(v) = c.vector() {
            if most == 0 || span.vector.replace(v).is_some() {
                return Err(Fault::Unexpected { at, expected: "the next span, SEG or TRFORM" });
            }
            if v == Vec3::zeros() {
                return Err(Fault::NoLength { at });
            }
        } else if named {
            return c.unexpected("a point or a vector");
        } else {
            return Ok(());
        }
    }
}

/// The spans behind SEG.
fn segments(c: &mut Cursor<'_, '_>, n_spans: Option<usize>) -> Result<Vec<SegmentSpan>, Fault> {
    let mut spans = Vec::new();
    let mut last = 0.0;
    while let Some(law) = c.take(&[word::LENGTH, word::PARAM]) {
        let range = range(c, &mut last, n_spans)?;
        spans.push(SegmentSpan { by_length: law == word::LENGTH, range });
        c.take(&[word::SEG]);
    }
    if spans.is_empty() {
        return c.unexpected("LENGTH or PARAM");
    }
    whole(c, last, n_spans)?;
    Ok(spans)
}

/// Two numbers of points: the first where the span before ended, the second beyond it.
fn range(
    c: &mut Cursor<'_, '_>,
    last: &mut f64,
    n_spans: Option<usize>,
) -> Result<[f64; 2], Fault> {
    let at = c.at;
    let from = c.number("the number of a point, from 0")?;
    if (from - *last).abs() > WHOLE {
        return Err(Fault::Range { at, value: from, need: "where the span before it ended" });
    }
    let at = c.at;
    let to = c.number("the number of a point")?;
    let most = n_spans.map_or(f64::INFINITY, count);
    if to <= from + WHOLE || to > most + WHOLE {
        let need = "of a later point of the curve";
        return Err(Fault::Range { at, value: to, need });
    }
    *last = to;
    Ok([from, to])
}

/// The last span must end at the last point.
fn whole(c: &Cursor<'_, '_>, last: f64, n_spans: Option<usize>) -> Result<(), Fault> {
    match n_spans {
        Some(n) if (last - count(n)).abs() > WHOLE => {
            c.unexpected("spans up to the last point of the curve")
        }
        _ => Ok(()),
    }
}

#[expect(clippy::cast_precision_loss, reason = "a count of points")]
fn count(n: usize) -> f64 {
    n as f64
}
