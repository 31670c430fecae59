//! The path of a program seen from the top, over the surfaces that guide it.

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
}

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
        let given = compiled.geometry.iter().filter_map(|(name, value)| match value {
            // Planes that lie flat are the paper.
            Named::Form(form) if view::plane_form(form) => Some(Item {
                name: name.clone(),
                form: form.clone(),
                foot: Vec3::zeros(),
                path: None,
            }),
            _ => None,
        });
        let given = given.filter(|item| !matches!(item.form.shape(), Form::Matrix(_))).collect();
        let form = Arc::new(Form::Point(Vec3::zeros()));
        let path = Some(path(&compiled));
        let result = Item { name: String::new(), form, foot: Vec3::zeros(), path };
        Ok(Self { given, result, others: Vec::new() })
    }
}

/// The path of all parts, laid into the plane z = 0.
fn path(compiled: &Compiled) -> Path {
    let flat = |p: Vec3| Vec3::new(p.x, p.y, 0.0);
    let mut path = Path::default();
    let (mut here, mut radius, mut rapid) = (None, 0.0, false);
    let records = compiled.parts.iter().map(|part| part.edited.to_vec().expect("it can be read"));
    for record in records.flatten() {
        match &record.kind {
            Kind::Cutter(c) => radius = c.diameter / 2.0,
            Kind::Post { word, .. } if word == "RAPID" => rapid = true,
            Kind::Motion(m) => {
                let points: Vec<Vec3> = m.points.iter().map(|p| flat(p.te)).collect();
                let Some(&end) = points.last() else { continue };
                if m.kind == MotionKind::From {
                    path.start = path.start.or(Some(end));
                } else {
                    let way: Vec<Vec3> = here.into_iter().chain(points).collect();
                    if rapid {
                        path.rapid.push(way);
                    } else {
                        path.feed.push(way);
                    }
                    rapid = false;
                }
                if matches!(m.kind, MotionKind::Startup | MotionKind::Continuous) {
                    path.stops.push((end, radius));
                }
                here = Some(end);
            }
            _ => {}
        }
    }
    path
}
