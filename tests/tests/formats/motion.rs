//! The path of a program seen from the top, over the surfaces that guide it; in space where the tool leans.

use std::sync::Arc;

use aptc_cldata::{Kind, MotionKind};
use aptc_control::{Compiled, Memory, Named, Options, Source, Verify};
use aptc_geometry::{Form, Vec3};

use super::scene::{Item, Scene};
use super::view;

/// What is drawn of the way of a tool.
#[derive(Default)]
pub(crate) struct Path {
    /// Ways at feed rate.
    pub(crate) feed: Vec<Vec<Vec3>>,
    /// Ways at rapid.
    pub(crate) rapid: Vec<Vec<Vec3>>,
    /// Where a motion along surfaces ends, with the radius of the cutter.
    pub(crate) stops: Vec<(Vec3, f64)>,
    /// Where the tool begins.
    pub(crate) start: Option<Vec3>,
    /// The tool at some places: its end, a place up its axis, the radius of the cutter. Empty where it stands upright all the time.
    pub(crate) tools: Vec<(Vec3, Vec3, f64)>,
}

/// How many tools are drawn at most.
const MOST_TOOLS: usize = 16;
/// Length of a tool as it is drawn, in diameters.
const DRAWN_LENGTH: f64 = 3.0;

impl Scene {
    /// The scene of a program with motion, or its messages.
    pub(crate) fn of_motion(program: &str) -> Result<Self, String> {
        let source = Source { name: "picture.apt".into(), text: program.into() };
        let options = Options { post: false, verify: Verify::Off, ..Options::default() };
        let compiled = aptc_control::compile(source, &mut Memory::default(), &options);
        if compiled.has_errors() {
            let told: Vec<_> = compiled.diagnostics.iter().map(|d| d.message.clone()).collect();
            return Err(told.join("; "));
        }
        let path = path(&compiled);
        let leaning = !path.tools.is_empty();
        let given = compiled.geometry.iter().filter_map(|(name, value)| match value {
            // Planes that lie flat are the paper.
            Named::Form(form) if view::plane_form(form) || leaning && solid(form) => Some(Item {
                name: name.clone(),
                form: form.clone(),
                foot: Vec3::zeros(),
                path: None,
            }),
            _ => None,
        });
        let given = given.filter(|item| !matches!(item.form.shape(), Form::Matrix(_))).collect();
        let form = Arc::new(Form::Point(Vec3::zeros()));
        let result = Item { name: String::new(), form, foot: Vec3::zeros(), path: Some(path) };
        Ok(Self { given, result, others: Vec::new() })
    }
}

/// Forms that show in space what the tool leans on; a plane would hide it.
fn solid(form: &Form) -> bool {
    !matches!(form.shape(), Form::Plane(_) | Form::Vector(_))
}

/// The path of all parts, laid into the plane z = 0 unless the tool leans.
fn path(compiled: &Compiled) -> Path {
    let records = || {
        let parts = compiled.parts.iter();
        parts.flat_map(|part| part.edited.to_vec().expect("it can be read"))
    };
    let leaning = records().any(|record| match &record.kind {
        Kind::Motion(m) => m.points.iter().any(|p| p.ta.xy().norm() > 1e-9),
        _ => false,
    });
    let laid = |p: Vec3| if leaning { p } else { Vec3::new(p.x, p.y, 0.0) };
    let mut path = Path::default();
    let (mut here, mut radius, mut rapid) = (None, 0.0, false);
    for record in records() {
        match &record.kind {
            Kind::Cutter(c) => radius = c.diameter / 2.0,
            Kind::Post { word, .. } if word == "RAPID" => rapid = true,
            Kind::Motion(m) => {
                let points: Vec<Vec3> = m.points.iter().map(|p| laid(p.te)).collect();
                let Some(&end) = points.last() else { continue };
                if m.kind == MotionKind::From {
                    path.start = path.start.or(Some(end));
                } else {
                    let way: Vec<Vec3> = here.into_iter().chain(points).collect();
                    if rapid {
                        path.rapid.push(way);
                    } else {
                        path.feed.push(way);
                        let up = DRAWN_LENGTH * 2.0 * radius;
                        path.tools
                            .extend(m.points.iter().map(|p| (p.te, p.te + p.ta * up, radius)));
                    }
                    rapid = false;
                }
                if matches!(m.kind, MotionKind::Startup | MotionKind::Continuous) && !leaning {
                    path.stops.push((end, radius));
                }
                here = Some(end);
            }
            _ => {}
        }
    }
    thin(&mut path.tools, leaning);
    path
}

/// Leaves as many tools as can be seen, the first and the last among them.
fn thin(tools: &mut Vec<(Vec3, Vec3, f64)>, leaning: bool) {
    if !leaning {
        tools.clear();
    } else if tools.len() > MOST_TOOLS {
        let (last, gaps) = (tools.len() - 1, MOST_TOOLS - 1);
        *tools = (0..=gaps).map(|i| tools[(i * last + gaps / 2) / gaps]).collect();
    }
}
