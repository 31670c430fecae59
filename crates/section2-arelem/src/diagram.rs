//! A picture of the situation in which a motion failed: the surfaces cut by two planes through the tool, the
//! cutter, and the place that the message speaks of.

use std::fmt::Write as _;

use aptc_geometry::{Profile, Surface, Vec3};
use aptc_protap::SurfaceRef;

use crate::naming::{number, with_role};
use crate::plane::Frame;
use crate::state::Tool;

/// Side of a view in units of the picture.
const SIDE: f64 = 480.0;
/// Squares of a view's side in which a surface is looked for.
const SQUARES: u32 = 120;
/// Colours of drive, part and check surfaces that colour-blind readers can tell apart.
const COLOURS: [&str; 4] = ["#d55e00", "#0072b2", "#009e73", "#cc79a7"];
/// What the surfaces are, in the order of the colours.
const ROLES: [&str; 4] = ["drive", "part", "check", "check"];

/// What is drawn.
#[derive(Clone, Debug)]
pub struct Situation {
    pub(crate) tool: Tool,
    pub(crate) profile: Option<Profile>,
    /// Drive, part and check surfaces as far as they are known.
    pub(crate) surfaces: Vec<(usize, SurfaceRef)>,
    /// The place that the message names.
    pub(crate) place: Option<Vec3>,
    pub(crate) text: String,
}

/// A plane through the tool end, with the window that is seen.
struct View {
    title: &'static str,
    origin: Vec3,
    right: Vec3,
    up: Vec3,
    half: f64,
    /// Where it lies in the picture.
    at: [f64; 2],
}

impl Situation {
    /// The picture as SVG.
    pub fn svg(&self) -> String {
        let frame = Frame::of(self.tool.ta);
        let ahead = self.tool.forward - frame.w * frame.w.dot(&self.tool.forward);
        let ahead = ahead.try_normalize(1e-9).unwrap_or(frame.u);
        let (half, middle) = self.window();
        let plan = View {
            title: "seen along the tool axis, at the tool end",
            origin: middle + frame.w * frame.w.dot(&(self.tool.te - middle)),
            right: frame.u,
            up: frame.v,
            half,
            at: [10.0, 40.0],
        };
        let side = frame.w.cross(&ahead);
        let elevation = View {
            title: "cut along the direction of the last motion",
            origin: middle + side * side.dot(&(self.tool.te - middle)),
            right: ahead,
            up: frame.w,
            half,
            at: [SIDE + 30.0, 40.0],
        };
        let (wide, high) = (2.0 * SIDE + 40.0, SIDE + 140.0);
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {wide} {high}\" \
             font-family=\"sans-serif\" font-size=\"13\">\n\
             <rect width=\"{wide}\" height=\"{high}\" fill=\"white\"/>\n"
        );
        text(&mut out, 10.0, 20.0, "black", &self.text);
        self.view(&mut out, &plan, true);
        self.view(&mut out, &elevation, false);
        let mut y = SIDE + 75.0;
        for (role, surface) in &self.surfaces {
            let role = (*role).min(3);
            text(&mut out, 10.0, y, COLOURS[role], &with_role(ROLES[role], surface));
            y += 17.0;
        }
        out.push_str("</svg>\n");
        out
    }

    /// Half the side of the window and its middle: the cutter, the place, and what is near of the surfaces.
    fn window(&self) -> (f64, Vec3) {
        let te = self.tool.te;
        let reach = self.profile.as_ref().map_or(0.0, Profile::widest);
        let middle = self.place.map_or(te, |p| 0.5 * (te + p));
        let mut half = (3.0 * reach).max(0.7 * self.place.map_or(0.0, |p| (p - te).norm()));
        for (_, s) in &self.surfaces {
            let away = Surface::from_form(&s.form).map_or(0.0, |s| s.distance(te).abs());
            if half <= 0.0 || away < 8.0 * half {
                half = half.max(1.3 * away);
            }
        }
        (if half > 0.0 { 1.2 * half } else { 1.0 }, middle)
    }

    fn view(&self, out: &mut String, view: &View, plan: bool) {
        let [x, y] = view.at;
        let _ = writeln!(
            out,
            "<rect x=\"{x}\" y=\"{y}\" width=\"{SIDE}\" height=\"{SIDE}\" fill=\"none\" stroke=\"#999\"/>"
        );
        let title = format!("{}; {} wide", view.title, number(2.0 * view.half));
        text(out, x, y + SIDE + 16.0, "#555", &title);
        // A view of its own: what is beyond the frame is not drawn.
        let _ = writeln!(
            out,
            "<svg x=\"{x}\" y=\"{y}\" width=\"{SIDE}\" height=\"{SIDE}\" viewBox=\"{x} {y} {SIDE} {SIDE}\">"
        );
        for (role, surface) in &self.surfaces {
            let Some(s) = Surface::from_form(&surface.form) else { continue };
            let colour = COLOURS[(*role).min(3)];
            let path = view.trace(&s);
            if !path.is_empty() {
                let _ = writeln!(
                    out,
                    "<path d=\"{path}\" stroke=\"{colour}\" fill=\"none\" stroke-width=\"2\"/>"
                );
            }
        }
        self.cutter(out, view, plan);
        if let Some(p) = self.place {
            let [px, py] = view.pixel(p);
            let _ = writeln!(
                out,
                "<path d=\"M{:.1} {:.1}l10 10m0 -10l-10 10\" stroke=\"red\" stroke-width=\"2\"/>",
                px - 5.0,
                py - 5.0
            );
        }
        out.push_str("</svg>\n");
    }

    fn cutter(&self, out: &mut String, view: &View, plan: bool) {
        let [x, y] = view.pixel(self.tool.te);
        let scale = SIDE / (2.0 * view.half);
        let _ = writeln!(out, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3\" fill=\"black\"/>");
        let Some(p) = &self.profile else { return };
        if plan {
            let r = p.widest() * scale;
            let _ = writeln!(
                out,
                "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{r:.1}\" fill=\"black\" fill-opacity=\".13\" stroke=\"black\"/>"
            );
            return;
        }
        // Heights above the window are cut off.
        let top = p.height().min(2.0 * view.half);
        let mut half = Vec::new();
        for i in 0..=40 {
            let z = p.bottom() + (top - p.bottom()) * f64::from(i * i) / 1600.0;
            half.push([p.radius_at(z).unwrap_or(0.0), z]);
        }
        let corner = |[r, z]: [f64; 2]| format!("{:.1},{:.1} ", x + r * scale, y - z * scale);
        let left: String = half.iter().rev().map(|[r, z]| corner([-r, *z])).collect();
        let right: String = half.iter().map(|q| corner(*q)).collect();
        let _ = writeln!(
            out,
            "<polygon points=\"{left}{right}\" fill=\"black\" fill-opacity=\".13\" stroke=\"black\"/>"
        );
    }
}

impl View {
    fn pixel(&self, p: Vec3) -> [f64; 2] {
        let w = p - self.origin;
        let scale = SIDE / (2.0 * self.half);
        let clip = |v: f64| v.clamp(-3.0 * SIDE, 3.0 * SIDE);
        [
            self.at[0] + 0.5 * SIDE + clip(self.right.dot(&w) * scale),
            self.at[1] + 0.5 * SIDE - clip(self.up.dot(&w) * scale),
        ]
    }

    /// The line in which a surface cuts the view: in each square between the places on its sides where the
    /// distance changes sign.
    fn trace(&self, surface: &Surface) -> String {
        let n = SQUARES as usize;
        let at =
            |k: usize| (f64::from(u32::try_from(k).unwrap_or(0)) / f64::from(SQUARES)) * 2.0 - 1.0;
        let place = |x: f64, y: f64| self.origin + (self.right * x + self.up * y) * self.half;
        let values: Vec<f64> = (0..=n)
            .flat_map(|j| (0..=n).map(move |i| (i, j)))
            .map(|(i, j)| surface.distance(place(at(i), at(j))))
            .collect();
        let value = |i: usize, j: usize| values[j * (n + 1) + i];
        let mut path = String::new();
        for j in 0..n {
            for i in 0..n {
                let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
                let mut cuts = Vec::new();
                for k in 0..4 {
                    let (a, b) = (corners[k], corners[(k + 1) % 4]);
                    let (f, g) = (value(a.0, a.1), value(b.0, b.1));
                    // A jump of the sign beside the end of a surface is no cut.
                    let small = f.abs().max(g.abs()) <= 3.0 * self.half / f64::from(SQUARES);
                    if (f > 0.0) != (g > 0.0) && small {
                        let t = f / (f - g);
                        let (x, y) =
                            (at(a.0) + (at(b.0) - at(a.0)) * t, at(a.1) + (at(b.1) - at(a.1)) * t);
                        cuts.push(self.pixel(place(x, y)));
                    }
                }
                for pair in cuts.chunks_exact(2) {
                    let ([a, b], [c, d]) = (pair[0], pair[1]);
                    let _ = write!(path, "M{a:.1} {b:.1}L{c:.1} {d:.1}");
                }
            }
        }
        path
    }
}

fn text(out: &mut String, x: f64, y: f64, colour: &str, words: &str) {
    let words = words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    let _ = writeln!(out, "<text x=\"{x}\" y=\"{y}\" fill=\"{colour}\">{words}</text>");
}
