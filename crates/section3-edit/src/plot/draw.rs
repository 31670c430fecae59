//! The SVG text.

use std::fmt::Write;

use aptc_cldata::number::{self, Decimals};
use aptc_geometry::Vec3;

use super::Plot;

const WIDTH: f64 = 1280.0;
const HEIGHT: f64 = 900.0;
const LEGEND: f64 = 220.0;
const HEAD: f64 = 56.0;
const GAP: f64 = 14.0;
/// Room in a panel around the drawing.
const MARGIN: f64 = 34.0;

/// How lines of surfaces look.
const DRAWN: &str =
    "fill=\"none\" stroke=\"#a9b6a2\" stroke-width=\".9\" stroke-linejoin=\"round\"";
/// Colours of the tools, in turn.
const COLOURS: [&str; 12] = [
    "#1d6fd1", "#d9580d", "#178a4c", "#8b3fc4", "#c72c6b", "#0b8484", "#a86f00", "#6b7280",
    "#5b8c00", "#b3261e", "#4658c9", "#7a4a2b",
];

/// A view: its name, the axes to the right and up, and the letters beside the grid.
struct View {
    name: &'static str,
    right: Vec3,
    up: Vec3,
    letters: Option<(&'static str, &'static str)>,
}

fn views() -> [View; 4] {
    let v = Vec3::new;
    // Isometric: x to the right and down, y to the right and up, z up, all equally long.
    let (a, b, c) = (0.5_f64.sqrt(), (1.0_f64 / 6.0).sqrt(), (2.0_f64 / 3.0).sqrt());
    [
        View { name: "top", right: Vec3::x(), up: Vec3::y(), letters: Some(("x", "y")) },
        View { name: "isometric", right: v(a, a, 0.0), up: v(-b, b, c), letters: None },
        View { name: "front", right: Vec3::x(), up: Vec3::z(), letters: Some(("x", "z")) },
        View { name: "side", right: Vec3::y(), up: Vec3::z(), letters: Some(("y", "z")) },
    ]
}

/// The picture.
pub(super) fn svg(plot: &Plot) -> String {
    let mut out = String::new();
    head(plot, &mut out);
    let (Some(low), Some(high)) = (plot.low, plot.high) else {
        text(&mut out, WIDTH / 2.0, HEIGHT / 2.0, "middle", "note", "no motion");
        out.push_str("</svg>\n");
        return out;
    };
    let views = views();
    let width = (WIDTH - LEGEND - 3.0 * GAP) / 2.0;
    let height = (HEIGHT - HEAD - 3.0 * GAP) / 2.0;
    // The three plane views have one scale, so that they can be compared.
    let scale_of = |v: &View| {
        let (min, max) = bounds(v, low, high);
        let (w, h) = (max.0 - min.0, max.1 - min.1);
        let fit = |room: f64, size: f64| {
            if size > 0.0 { (room - 2.0 * MARGIN) / size } else { f64::INFINITY }
        };
        fit(width, w).min(fit(height, h))
    };
    let plane =
        [0, 2, 3].map(|i: usize| scale_of(&views[i])).into_iter().fold(f64::INFINITY, f64::min);
    for (i, view) in views.iter().enumerate() {
        let x = GAP + (width + GAP) * f64::from(u8::from(i % 2 == 1));
        let y = HEAD + GAP + (height + GAP) * f64::from(u8::from(i > 1));
        let scale = if view.letters.is_some() { plane } else { scale_of(view) };
        let scale = if scale.is_finite() { scale } else { 1.0 };
        let (min, max) = bounds(view, low, high);
        let middle = ((min.0 + max.0) / 2.0, (min.1 + max.1) / 2.0);
        let panel = Panel { view, x, y, width, height, scale, middle };
        panel.draw(plot, &mut out);
    }
    legend(plot, &mut out, (low, high));
    out.push_str("</svg>\n");
    out
}

fn head(plot: &Plot, out: &mut String) {
    let _ = write!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" \
         font-family=\"system-ui, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif\">\n\
         <style>\n\
         .page{{fill:#f4f6f8}} .panel{{fill:#fff;stroke:#d5dbe1}}\n\
         .title{{font-size:20px;font-weight:600;fill:#17202a}} .view{{font-size:12px;font-weight:600;fill:#4b5866;letter-spacing:.06em}}\n\
         .note{{font-size:12px;fill:#4b5866}} .tick{{font-size:10px;fill:#8a96a3}} .label{{font-size:10px;fill:#17202a}}\n\
         .grid{{stroke:#e9edf1;stroke-width:1;fill:none}} .zero{{stroke:#c3ccd5;stroke-width:1;fill:none}}\n\
         .feed{{fill:none;stroke-width:1.4;stroke-linejoin:round;stroke-linecap:round}}\n\
         .rapid{{fill:none;stroke:#98a4b1;stroke-width:1;stroke-dasharray:5 4}}\n\
         .bar{{fill:none;stroke:#4b5866;stroke-width:1.2}}\n\
         .hole{{fill:none;stroke-width:1.2}} .start{{fill:#17202a}}\n\
         </style>\n\
         <rect class=\"page\" width=\"{WIDTH}\" height=\"{HEIGHT}\"/>\n"
    );
    let title = if plot.title.is_empty() { "tool path" } else { &plot.title };
    text(out, GAP + 4.0, 36.0, "start", "title", title);
}

/// Text at a place, with the characters of XML escaped.
fn text(out: &mut String, x: f64, y: f64, anchor: &str, class: &str, content: &str) {
    let _ = write!(
        out,
        "<text x=\"{}\" y=\"{}\" text-anchor=\"{anchor}\" class=\"{class}\">",
        tenth(x),
        tenth(y)
    );
    for c in content.chars().take(80) {
        match c {
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '&' => out.push_str("&amp;"),
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out.push_str("</text>\n");
}

/// A tenth of a pixel is enough.
fn tenth(x: f64) -> f64 {
    let r = (x * 10.0).round() / 10.0;
    if r.abs() <= 0.0 { 0.0 } else { r }
}

/// Bounds of the box in a view.
fn bounds(view: &View, low: Vec3, high: Vec3) -> ((f64, f64), (f64, f64)) {
    let mut min = (f64::INFINITY, f64::INFINITY);
    let mut max = (f64::NEG_INFINITY, f64::NEG_INFINITY);
    for i in 0..8 {
        let pick = |bit: u32, a: f64, b: f64| if i & bit == 0 { a } else { b };
        let p = Vec3::new(pick(1, low.x, high.x), pick(2, low.y, high.y), pick(4, low.z, high.z));
        let (u, w) = (view.right.dot(&p), view.up.dot(&p));
        min = (min.0.min(u), min.1.min(w));
        max = (max.0.max(u), max.1.max(w));
    }
    (min, max)
}

/// A step of 1, 2 or 5 times a power of ten for about `n` lines over a length.
fn step(length: f64, n: f64) -> f64 {
    let raw = length / n;
    if !(raw > 0.0 && raw.is_finite()) {
        return 1.0;
    }
    let mut step = 1.0_f64;
    for _ in 0..400 {
        if step <= raw {
            break;
        }
        step /= 10.0;
    }
    for _ in 0..400 {
        if step * 10.0 > raw {
            break;
        }
        step *= 10.0;
    }
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|f| f * step).find(|s| *s >= raw).unwrap_or(10.0 * step)
}

/// A number of the grid with no more decimals than its step needs.
fn tick(x: f64, step: f64) -> String {
    let mut decimals = 0;
    let mut s = step;
    while s < 0.999 && decimals < 9 {
        s *= 10.0;
        decimals += 1;
    }
    let text = format!("{x:.decimals$}");
    if text.trim_start_matches('-').chars().all(|c| matches!(c, '0' | '.')) {
        "0".into()
    } else {
        text
    }
}

struct Panel<'a> {
    view: &'a View,
    x: f64,
    y: f64,
    width: f64,
    height: f64,
    scale: f64,
    /// Middle of what is drawn, along the view's right and up.
    middle: (f64, f64),
}

impl Panel<'_> {
    /// Pixels of a point.
    fn at(&self, p: Vec3) -> (f64, f64) {
        self.pixels(self.view.right.dot(&p), self.view.up.dot(&p))
    }

    fn pixels(&self, u: f64, w: f64) -> (f64, f64) {
        let x = self.x + self.width / 2.0 + (u - self.middle.0) * self.scale;
        let y = self.y + self.height / 2.0 - (w - self.middle.1) * self.scale;
        (x, y)
    }

    fn draw(&self, plot: &Plot, out: &mut String) {
        let (x, y, w, h) = (self.x, self.y, self.width, self.height);
        let (x, y, w, h) = (tenth(x), tenth(y), tenth(w), tenth(h));
        let _ = writeln!(
            out,
            "<g><rect class=\"panel\" x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" rx=\"6\"/>"
        );
        match self.view.letters {
            Some(letters) => self.grid(letters, out),
            None => self.axes(out),
        }
        text(out, x + 12.0, y + 20.0, "start", "view", self.view.name);
        self.scale_bar(plot, out);
        self.lines(plot, out);
        self.path(plot, true, out);
        self.path(plot, false, out);
        self.holes(plot, out);
        if let Some(start) = plot.start {
            let (px, py) = self.at(start);
            let _ = writeln!(
                out,
                "<circle class=\"start\" cx=\"{}\" cy=\"{}\" r=\"3.2\"/>",
                tenth(px),
                tenth(py)
            );
        }
        for (p, label) in &plot.labels {
            let (px, py) = self.at(*p);
            text(out, px + 4.0, py - 4.0, "start", "label", label);
        }
        out.push_str("</g>\n");
    }

    fn grid(&self, letters: (&str, &str), out: &mut String) {
        let middle = self.middle;
        let (half_w, half_h) = (self.width / 2.0 / self.scale, self.height / 2.0 / self.scale);
        let step = step(2.0 * half_w, 8.0);
        let lines = |from: f64, to: f64| {
            let first = (from / step).ceil();
            let n = ((to - from) / step).floor().clamp(0.0, 60.0);
            (0_u8..=60).map(f64::from).take_while(move |i| *i <= n).map(move |i| (first + i) * step)
        };
        let mut zero = String::new();
        let mut path = String::new();
        for u in lines(middle.0 - half_w, middle.0 + half_w) {
            let (px, _) = self.pixels(u, 0.0);
            if px < self.x + 1.0 || px > self.x + self.width - 1.0 {
                continue;
            }
            let line = if u.abs() < step / 2.0 { &mut zero } else { &mut path };
            let _ = write!(line, "M{} {}v{}", tenth(px), tenth(self.y), tenth(self.height));
            if px > self.x + 40.0 && px < self.x + self.width - 40.0 {
                text(out, px, self.y + self.height - 6.0, "middle", "tick", &tick(u, step));
            }
        }
        for w in lines(middle.1 - half_h, middle.1 + half_h) {
            let (_, py) = self.pixels(0.0, w);
            if py < self.y + 1.0 || py > self.y + self.height - 1.0 {
                continue;
            }
            let line = if w.abs() < step / 2.0 { &mut zero } else { &mut path };
            let _ = write!(line, "M{} {}h{}", tenth(self.x), tenth(py), tenth(self.width));
            if py > self.y + 54.0 && py < self.y + self.height - 18.0 {
                text(out, self.x + 6.0, py - 3.0, "start", "tick", &tick(w, step));
            }
        }
        let _ =
            writeln!(out, "<path class=\"grid\" d=\"{path}\"/><path class=\"zero\" d=\"{zero}\"/>");
        let right = self.x + self.width - 10.0;
        text(out, right, self.y + self.height - 6.0, "end", "view", letters.0);
        text(out, self.x + 12.0, self.y + 36.0, "start", "view", letters.1);
    }

    /// A bar of a round length at the top right.
    fn scale_bar(&self, plot: &Plot, out: &mut String) {
        let length = step(120.0 / self.scale, 1.5);
        let (x, y) = (self.x + self.width - 16.0, self.y + 18.0);
        let w = tenth(length * self.scale);
        let _ = writeln!(
            out,
            "<path class=\"bar\" d=\"M{} {}v6m0 -3h-{w}m0 -3v6\"/>",
            tenth(x),
            tenth(y - 6.0)
        );
        let unit = plot.units.word().to_lowercase();
        let label = format!("{} {unit}", tick(length, length));
        text(out, x - w / 2.0, y + 14.0, "middle", "tick", &label);
    }

    /// The directions of x, y and z in the isometric view.
    fn axes(&self, out: &mut String) {
        let (cx, cy) = (self.x + 44.0, self.y + self.height - 40.0);
        for (axis, letter) in [(Vec3::x(), "x"), (Vec3::y(), "y"), (Vec3::z(), "z")] {
            let (u, w) = (self.view.right.dot(&axis) * 28.0, -self.view.up.dot(&axis) * 28.0);
            let _ = writeln!(
                out,
                "<path class=\"zero\" d=\"M{} {}l{} {}\"/>",
                tenth(cx),
                tenth(cy),
                tenth(u),
                tenth(w)
            );
            text(out, cx + 1.3 * u, cy + 1.3 * w + 4.0, "middle", "view", letter);
        }
    }

    /// The points as a stroke.
    fn stroke(&self, points: &[Vec3], d: &mut Vec<u8>) {
        let mut last: Option<(f64, f64)> = None;
        let mut to = |command: u8, here: (f64, f64)| {
            d.push(command);
            number::put(d, here.0, Decimals::Fixed(1));
            d.push(b' ');
            number::put(d, here.1, Decimals::Fixed(1));
        };
        for p in points {
            let (px, py) = self.at(*p);
            let here = (tenth(px), tenth(py));
            match last {
                None => to(b'M', here),
                Some(l) if (l.0 - here.0).abs() + (l.1 - here.1).abs() < 0.25 => continue,
                Some(_) => to(b'L', here),
            }
            last = Some(here);
        }
    }

    /// What PLOTFT drew; a single point is a small cross.
    fn lines(&self, plot: &Plot, out: &mut String) {
        let mut d = Vec::new();
        for line in &plot.lines {
            if let [p] = line.as_slice() {
                let (px, py) = self.at(*p);
                d.extend(format!("M{} {}h6m-3 -3v6", tenth(px - 3.0), tenth(py)).bytes());
            } else {
                self.stroke(line, &mut d);
            }
        }
        if !d.is_empty() {
            let _ = writeln!(out, "<path class=\"drawn\" {DRAWN} d=\"{}\"/>", digits(&d));
        }
    }

    fn path(&self, plot: &Plot, rapid: bool, out: &mut String) {
        for (tool, _) in plot.tools.iter().enumerate() {
            let mut d = Vec::new();
            for stroke in plot.strokes.iter().filter(|s| s.tool == tool && s.rapid == rapid) {
                self.stroke(&stroke.points, &mut d);
            }
            if d.is_empty() {
                continue;
            }
            let class = if rapid { "rapid" } else { "feed" };
            let colour =
                if rapid { String::new() } else { format!(" stroke=\"{}\"", colour(tool)) };
            let _ = writeln!(out, "<path class=\"{class}\"{colour} d=\"{}\"/>", digits(&d));
        }
    }

    fn holes(&self, plot: &Plot, out: &mut String) {
        let mut last = (f64::NAN, f64::NAN);
        for (tool, p) in plot.holes.iter().take(4000) {
            let (px, py) = self.at(*p);
            let here = (tenth(px), tenth(py));
            if (last.0 - here.0).abs() + (last.1 - here.1).abs() < 0.5 {
                continue;
            }
            last = here;
            let c = colour(*tool);
            let _ = writeln!(
                out,
                "<circle class=\"hole\" stroke=\"{c}\" cx=\"{}\" cy=\"{}\" r=\"3\"/>",
                here.0, here.1
            );
        }
    }
}

fn digits(path: &[u8]) -> &str {
    std::str::from_utf8(path).expect("digits and letters")
}

fn colour(tool: usize) -> &'static str {
    COLOURS[tool % COLOURS.len()]
}

/// A number with about five digits.
fn figure(x: f64) -> String {
    let decimals = match x.abs() {
        a if a >= 1000.0 => 0,
        a if a >= 100.0 => 1,
        a if a >= 10.0 => 2,
        _ => 3,
    };
    let text = format!("{x:.decimals$}");
    if text.starts_with('-') && text[1..].chars().all(|c| matches!(c, '0' | '.')) {
        return text[1..].into();
    }
    text
}

fn legend(plot: &Plot, out: &mut String, (low, high): (Vec3, Vec3)) {
    let unit = plot.units.word().to_lowercase();
    let x = WIDTH - LEGEND;
    let mut y = HEAD + GAP + 18.0;
    text(out, x, y, "start", "view", "tools");
    for (i, tool) in plot.tools.iter().enumerate().filter(|(_, t)| t.used) {
        y += 22.0;
        let _ = writeln!(
            out,
            "<path class=\"feed\" stroke=\"{}\" style=\"stroke-width:3\" d=\"M{} {}h26\"/>",
            colour(i),
            tenth(x),
            tenth(y - 4.0)
        );
        let label = match tool.diameter {
            Some(d) => format!("{}  \u{2300} {}", tool.name, figure(d)),
            None => tool.name.clone(),
        };
        text(out, x + 36.0, y, "start", "note", &label);
    }
    y += 34.0;
    text(out, x, y, "start", "view", "moves");
    y += 22.0;
    let _ = writeln!(out, "<path class=\"rapid\" d=\"M{} {}h26\"/>", tenth(x), tenth(y - 4.0));
    text(out, x + 36.0, y, "start", "note", &format!("rapid  {} {unit}", figure(plot.length[1])));
    y += 22.0;
    let _ = writeln!(
        out,
        "<path class=\"feed\" stroke=\"#17202a\" d=\"M{} {}h26\"/>",
        tenth(x),
        tenth(y - 4.0)
    );
    text(out, x + 36.0, y, "start", "note", &format!("at feed  {} {unit}", figure(plot.length[0])));
    if !plot.holes.is_empty() {
        y += 22.0;
        let _ = writeln!(
            out,
            "<circle class=\"hole\" stroke=\"#17202a\" cx=\"{}\" cy=\"{}\" r=\"3\"/>",
            tenth(x + 13.0),
            tenth(y - 4.0)
        );
        text(out, x + 36.0, y, "start", "note", &format!("{} cycle positions", plot.holes.len()));
    }
    if !plot.lines.is_empty() {
        y += 22.0;
        let (x0, y0) = (tenth(x), tenth(y - 4.0));
        let _ = writeln!(out, "<path class=\"drawn\" {DRAWN} d=\"M{x0} {y0}h26\"/>");
        text(out, x + 36.0, y, "start", "note", "surface lines");
    }
    if plot.start.is_some() {
        y += 22.0;
        let _ = writeln!(
            out,
            "<circle class=\"start\" cx=\"{}\" cy=\"{}\" r=\"3.2\"/>",
            tenth(x + 13.0),
            tenth(y - 4.0)
        );
        text(out, x + 36.0, y, "start", "note", "start");
    }
    y += 34.0;
    text(out, x, y, "start", "view", &format!("extent in {unit}"));
    for (letter, a, b) in [("x", low.x, high.x), ("y", low.y, high.y), ("z", low.z, high.z)] {
        y += 20.0;
        text(out, x, y, "start", "note", &format!("{letter}  {} to {}", figure(a), figure(b)));
    }
}
