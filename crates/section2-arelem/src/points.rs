//! Point-to-point motion: FROM, GOTO, GODLTA, patterns, POCKET, and what CUT puts out.

use aptc_cldata as cl;
use aptc_diagnostics::{Diagnostic, Origin, codes};
use aptc_geometry::Vec3;
use aptc_protap as protap;
use aptc_protap::{Outcome, ToolAxis};

use crate::arelem::Arelem;
use crate::failure::Failure;
use crate::state::{Role, Tool, unit};
use crate::{forward, pocket, warning};

impl Arelem {
    /// FROM and GOTO.
    pub(crate) fn place(
        &mut self,
        origin: &Origin,
        place: &protap::Place,
        kind: cl::MotionKind,
        out: &mut Vec<cl::Record>,
    ) -> Outcome {
        if let Some(axis) = place.axis.and_then(unit) {
            self.settings.set_axis(ToolAxis::Fixed(axis));
            if let Some(t) = &mut self.tool {
                t.ta = axis;
            }
        }
        self.go_to(place.point);
        // Nothing moved at FROM: there is no direction yet but one given before.
        if kind == cl::MotionKind::From
            && let (Some(f), Some(t)) =
                (self.settings.given.iter().flatten().next(), &mut self.tool)
        {
            t.sense(*f);
        }
        self.put(origin, kind, forward::name(&place.name), vec![place.point], out);
        if kind == cl::MotionKind::From { self.stands(0) } else { self.moved(0) }
    }

    pub(crate) fn points(
        &mut self,
        origin: &Origin,
        name: &protap::NameRef,
        points: &[Vec3],
        out: &mut Vec<cl::Record>,
    ) -> Outcome {
        for p in points {
            self.go_to(*p);
        }
        if points.is_empty() {
            return Outcome::None;
        }
        self.put(origin, cl::MotionKind::Goto, forward::name(name), points.to_vec(), out);
        self.moved(0)
    }

    /// GODLTA.
    pub(crate) fn by(&mut self, origin: &Origin, v: Vec3, out: &mut Vec<cl::Record>) -> Outcome {
        if self.poisoned {
            return Outcome::Failed;
        }
        let Some(tool) = self.tool else { return self.fail(origin, &Failure::NoPosition) };
        let te = tool.te + v;
        self.go_to(te);
        self.put(origin, cl::MotionKind::Goto, cl::NameRef::default(), vec![te], out);
        self.moved(0)
    }

    /// Puts the tool there.
    pub(crate) fn go_to(&mut self, te: Vec3) {
        match &mut self.tool {
            Some(t) => {
                t.turn(te - t.te);
                (t.te, t.stood) = (te, None);
            }
            None => self.tool = Some(self.first(te)),
        }
        self.poisoned = false;
        self.ended = None;
    }

    /// The tool at its first position.
    fn first(&self, te: Vec3) -> Tool {
        let fixed = match &self.settings.axis {
            ToolAxis::Fixed(v) => unit(*v),
            _ => None,
        };
        Tool::at(te, fixed.unwrap_or_else(Vec3::z))
    }

    /// A start without a position before it begins at 0,0,0, as in APT-360, and says so: where it begins only tells the way to
    /// the surfaces. A step from an unknown place (GODLTA) is refused.
    pub(crate) fn stand_at_zero(&mut self, origin: &Origin) -> Tool {
        self.diagnostics.push(warning::from_zero(origin));
        let tool = self.first(Vec3::zeros());
        self.tool = Some(tool);
        tool
    }

    /// CUT and DNTCUT: after DNTCUT, CUT puts out where the tool is.
    pub(crate) fn cut(&mut self, origin: &Origin, on: bool, out: &mut Vec<cl::Record>) {
        let again = on && !self.settings.cut;
        self.settings.cut = on;
        self.silent =
            if on { None } else { self.silent.take().or_else(|| Some((origin.clone(), 0))) };
        if let (true, false, Some(t)) = (again, self.poisoned, self.tool) {
            self.put(origin, cl::MotionKind::Goto, cl::NameRef::default(), vec![t.te], out);
        }
        let output = if on { cl::Output::Cut } else { cl::Output::Dntcut };
        out.push(cl::Record { origin: origin.clone(), kind: cl::Kind::Output(output) });
    }

    /// That THICK leaves nothing in a pocket is told once.
    fn no_thickness(&mut self, origin: &Origin) {
        let s = &mut self.settings;
        if s.thick.iter().all(|t| *t == 0.0) || std::mem::replace(&mut s.thick_told, true) {
            return;
        }
        let text = "THICK does not count in a pocket: its walls and its floor are cut as given";
        let help = "to leave material give corners that lie further in and points that lie higher, or THICK/0 first";
        self.diagnostics.push(
            Diagnostic::warning(codes::WITHOUT_EFFECT, origin.span, text)
                .within(origin.trace.clone())
                .help(help),
        );
    }

    /// POCKET: three feeds, the plunge, the general passes from the inside out, the finish pass.
    pub(crate) fn pocket(
        &mut self,
        origin: &Origin,
        p: &protap::Pocket,
        out: &mut Vec<cl::Record>,
    ) -> Outcome {
        if self.poisoned {
            return Outcome::Failed;
        }
        let Some(tool) = self.tool else { return self.fail(origin, &Failure::NoPosition) };
        if let Some(Err(why)) = self.settings.profile(Role::Drive) {
            return self.fail(origin, &Failure::BadCutter { why });
        }
        let passes = match pocket::passes(p, &self.settings, &tool) {
            Ok(passes) => {
                self.no_thickness(origin);
                if let Some(left) = passes.left {
                    self.diagnostics.push(warning::material_left(origin, left));
                } else if let Some(stands) =
                    pocket::between_passes(&passes, p, &self.settings, &tool)
                {
                    self.diagnostics.push(warning::flat_too_small(origin, &stands));
                }
                if let Some(depth) = pocket::below_floor(&passes, p, &self.settings, &tool) {
                    self.diagnostics.push(warning::below_floor(origin, depth));
                }
                passes.polygons
            }
            Err(why) => return self.fail(origin, &Failure::Pocket { why }),
        };
        let general: Vec<Vec3> = passes[..passes.len() - 1].iter().flatten().copied().collect();
        let finish = passes.last().cloned().unwrap_or_default();
        let all = [general, finish].concat();
        let split = all.len() - passes.last().map_or(0, Vec::len);
        let parts = [&all[..1], &all[1..split.max(1)], &all[split.max(1)..]];
        for (points, feed) in parts.into_iter().zip(p.feeds) {
            if points.is_empty() {
                continue;
            }
            self.take_feed(origin, vec![cl::Arg::Number(feed)], out);
            for p in points {
                self.go_to(*p);
            }
            let name = cl::NameRef { name: "POCKET".into(), subscript: 0 };
            self.put(origin, cl::MotionKind::Goto, name, points.to_vec(), out);
        }
        self.moved(0)
    }
}

/// A basic feed for the post-processor.
pub(crate) fn put_feed(origin: &Origin, args: Vec<cl::Arg>, out: &mut Vec<cl::Record>) {
    let kind = cl::Kind::Post { word: "FEDRAT".into(), args };
    out.push(cl::Record { origin: origin.clone(), kind });
}
