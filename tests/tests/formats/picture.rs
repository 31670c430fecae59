//! The picture of a scene as SVG: what is given thin and grey, the result bold and blue, the answers of
//! other modifiers dashed.

use std::fmt::Write as _;

use aptc_geometry::{Form, Line, Vec2, Vec3};

use super::label::{self, Wanted};
use super::scene::{Item, Scene};
use super::shape::{self, Shape};
use super::view::{self, Bounds, HEIGHT, View, WIDTH};

/// The whole file.
pub(crate) fn svg(scene: &Scene) -> String {
    let flat = view::is_flat(scene);
    let room = room(scene, flat);
    let shapes: Vec<(Shape, &Item)> =
        scene.items().map(|item| (shape::shape(item, Some(&room), flat), item)).collect();
    let view = view(scene, flat, &room, &shapes);
    let room = if flat { view.window() } else { room };
    // Lines and conics go to the border of the picture, which the view has set now.
    let shapes: Vec<(Shape, &Item)> = if flat {
        scene.items().map(|item| (shape::shape(item, Some(&room), flat), item)).collect()
    } else {
        shapes
    };
    let others = scene.others.iter().map(|form| {
        let item =
            Item { name: String::new(), form: form.clone(), foot: scene.result.foot, path: None };
        shape::shape(&item, Some(&room), flat)
    });
    let others: Vec<Shape> = others.collect();
    let mut out = head();
    if flat {
        grid(&mut out, &view);
    } else {
        axes(&mut out, &view, &room);
    }
    out.push_str("<g clip-path=\"url(#c)\">\n");
    if has_matrix(scene) {
        let old: Vec<Vec3> = shape::letter().to_vec();
        writeln!(out, "<path class=\"g\" d=\"{}Z\"/>", path(&view, &old)).expect("text");
    }
    let n_given = shapes.len() - 1;
    for (i, (s, _)) in shapes.iter().enumerate() {
        fills(&mut out, &view, s, if i == n_given { "rf" } else { "gf" });
    }
    for (s, _) in &shapes[..n_given] {
        strokes(&mut out, &view, s, "g");
    }
    for s in &others {
        strokes(&mut out, &view, s, "o");
    }
    if let (Form::Point(p), false) = (scene.result.form.shape(), flat) {
        let foot = Vec3::new(p.x, p.y, 0.0);
        let corner = [Vec3::new(p.x, 0.0, 0.0), foot, Vec3::new(0.0, p.y, 0.0)];
        let d = path(&view, &[*p, foot]) + &path(&view, &corner);
        writeln!(out, "<path class=\"gt\" stroke-dasharray=\"3 3\" d=\"{d}\"/>").expect("text");
    }
    strokes(&mut out, &view, &shapes[n_given].0, "r");
    out.push_str("</g>\n");
    for text in label::place(names(&view, flat, &shapes), &ink(&view, &shapes, &others)) {
        writeln!(
            out,
            "<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>",
            text.class,
            number(text.at.x),
            number(text.at.y),
            text.text
        )
        .expect("text");
    }
    out.push_str("</svg>\n");
    out
}

fn head() -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" width=\"{WIDTH}\" \
         height=\"{HEIGHT}\" font-family=\"system-ui, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif\">\n\
         <style>\n\
         .panel{{fill:#fff;stroke:#d5dbe1}} .grid{{stroke:#eef1f4;fill:none}} .zero{{stroke:#c3ccd5;fill:none}}\n\
         .tick{{font-size:10px;fill:#8a96a3;text-anchor:middle}}\n\
         .g,.gt,.o,.r,.rt{{fill:none;stroke-linejoin:round;stroke-linecap:round}}\n\
         .g{{stroke:#7c8895;stroke-width:1.2}} .gt{{stroke:#b4bec8;stroke-width:.8}}\n\
         .o{{stroke:#1d6fd1;stroke-width:1.2;stroke-dasharray:5 4;opacity:.55}}\n\
         .r{{stroke:#1d6fd1;stroke-width:2.6}} .rt{{stroke:#1d6fd1;stroke-width:1;opacity:.55}}\n\
         .gf{{fill:#8a96a3;opacity:.1}} .rf{{fill:#1d6fd1;opacity:.1}}\n\
         .gd{{fill:#4b5866}} .od{{fill:#fff;stroke:#1d6fd1;stroke-width:1.2;opacity:.7}} .rd{{fill:#1d6fd1}}\n\
         .gl,.rl{{font-size:12px;text-anchor:middle;paint-order:stroke;stroke:#fff;stroke-width:3px;stroke-linejoin:round}}\n\
         .gl{{fill:#4b5866}} .rl{{fill:#1d6fd1;font-weight:700;font-size:13px}}\n\
         </style>\n\
         <clipPath id=\"c\"><rect x=\"1\" y=\"1\" width=\"{}\" height=\"{}\" rx=\"6\"/></clipPath>\n\
         <rect class=\"panel\" x=\".5\" y=\".5\" width=\"{}\" height=\"{}\" rx=\"6\"/>\n",
        WIDTH - 2.0,
        HEIGHT - 2.0,
        WIDTH - 1.0,
        HEIGHT - 1.0
    )
}

/// Matrices are shown by a letter in the old and the new system.
fn has_matrix(scene: &Scene) -> bool {
    scene.items().any(|item| matches!(item.form.shape(), Form::Matrix(_)))
}

/// The box of space that the picture is about.
fn room(scene: &Scene, flat: bool) -> Bounds {
    if let Some(path) = &scene.result.path {
        let rings = path.stops.iter().map(|(p, r)| (p, Vec3::new(*r, *r, 0.0)));
        let rings = rings.flat_map(|(p, r)| [p - r, p + r]);
        let tools = path.tools.iter().flat_map(|(end, top, _)| [*end, *top]);
        let solids = scene.given.iter().filter(|_| !flat).flat_map(shape::core);
        let seen = shape::core(&scene.result).into_iter().chain(rings).chain(tools).chain(solids);
        let bounds = Bounds::of(seen).expect("a path has points");
        return bounds.grown(Vec3::new(1.0, 1.0, 0.0) * (bounds.size().amax() * 0.06));
    }
    let letter = shape::letter().into_iter().filter(|_| has_matrix(scene));
    let own = scene.items().flat_map(shape::core).chain([Vec3::zeros()]).chain(crossings(scene));
    let own = own.chain(letter).chain(sheet(scene, flat));
    let bounds = Bounds::of(own).expect("the origin is one");
    // Other answers that lie far away do not make the picture small.
    let lean = bounds.size().amax().max(20.0);
    let near = |p: &Vec3| {
        let out = (bounds.low - p).sup(&(p - bounds.high));
        out.amax() < 0.45 * lean
    };
    let others = scene.others.iter().map(|form| {
        shape::core(&Item {
            name: String::new(),
            form: form.clone(),
            foot: scene.result.foot,
            path: None,
        })
    });
    let bounds = others.filter(|p| p.iter().all(near)).fold(bounds, Bounds::with);
    if flat {
        return bounds.grown(Vec3::new(lean * 0.06, lean * 0.06, 0.0));
    }
    // Planes need room to be seen.
    let least = if bounds.size().amax() < 1e-9 { 30.0 } else { bounds.size().amax() * 0.55 };
    let half = bounds.size().sup(&Vec3::repeat(least)) * 0.56;
    Bounds { low: bounds.middle() - half, high: bounds.middle() + half }
}

/// What has no end alone would give no picture: then that of a part of everyday.
fn sheet(scene: &Scene, flat: bool) -> Vec<Vec3> {
    let endless = |item: &Item| matches!(item.form.shape(), Form::Line(_) | Form::Plane(_));
    let vector = |item: &Item| matches!(item.form.shape(), Form::Vector(_));
    if !scene.items().any(endless) || scene.items().any(vector) {
        return Vec::new();
    }
    let high = if flat { Vec3::new(60.0, 36.0, 0.0) } else { Vec3::new(36.0, 36.0, 10.0) };
    vec![Vec3::zeros(), high]
}

/// Where lines of the scene cross, unless that is far away.
fn crossings(scene: &Scene) -> Vec<Vec3> {
    let lines: Vec<Line> = scene
        .items()
        .filter_map(|item| match item.form.shape() {
            Form::Line(l) => Some(*l),
            Form::Plane(p) if p.n.z.abs() < 1e-9 => Line::new(p.n.x, p.n.y, p.d),
            _ => None,
        })
        .collect();
    let mut found = Vec::new();
    for (i, one) in lines.iter().enumerate() {
        for other in &lines[..i] {
            let det = one.a * other.b - one.b * other.a;
            if det.abs() > 0.05 {
                let x = (one.d * other.b - other.d * one.b) / det;
                let y = (one.a * other.d - other.a * one.d) / det;
                found.push(Vec3::new(x, y, 0.0));
            }
        }
        found.push(Vec3::new(one.a, one.b, 0.0) * one.d);
    }
    found.retain(|p| p.amax() < 100.0);
    found
}

fn view(scene: &Scene, flat: bool, room: &Bounds, shapes: &[(Shape, &Item)]) -> View {
    if flat {
        return View::fitting(true, room.corners());
    }
    let letter = shape::letter().into_iter().filter(|_| has_matrix(scene));
    let seen = shapes.iter().flat_map(|(s, _)| s.points()).chain(letter).chain([Vec3::zeros()]);
    let axes = [Vec3::x(), Vec3::y(), Vec3::z()].map(|v| v * (room.size().amax() * AXIS));
    View::fitting(false, seen.chain(axes))
}

/// Length of the axes in shares of the room.
const AXIS: f64 = 0.22;

fn axes(out: &mut String, view: &View, room: &Bounds) {
    let length = room.size().amax() * AXIS;
    for (v, name) in [(Vec3::x(), "x"), (Vec3::y(), "y"), (Vec3::z(), "z")] {
        let (o, p) = (view.at(Vec3::zeros()), view.at(v * length));
        let q = p + (p - o).normalize() * 9.0;
        writeln!(
            out,
            "<path class=\"zero\" d=\"M{} {}L{} {}\"/><text class=\"tick\" x=\"{}\" y=\"{}\">{name}</text>",
            number(o.x),
            number(o.y),
            number(p.x),
            number(p.y),
            number(q.x),
            number(q.y + 3.5)
        )
        .expect("text");
    }
}

/// Grid and numbers at its lines.
fn grid(out: &mut String, view: &View) {
    let window = view.window();
    let least = 44.0 / view.length(1.0);
    let powers = (-3..5).flat_map(|k| [1.0, 2.0, 5.0].map(|m| m * 10_f64.powi(k)));
    let step = powers.into_iter().find(|s| *s >= least).unwrap_or(1.0);
    for (axis, limit) in [(0, WIDTH), (1, HEIGHT)] {
        let mut k = (window.low[axis] / step).ceil();
        while k * step < window.high[axis] {
            let mut p = Vec3::zeros();
            p[axis] = k * step;
            let q = view.at(p);
            let class = if k == 0.0 { "zero" } else { "grid" };
            let text = number(k * step);
            let (line, place) = if axis == 0 {
                (format!("M{} 1V{}", number(q.x), HEIGHT - 1.0), (q.x, HEIGHT - 5.0))
            } else {
                (format!("M1 {}H{}", number(q.y), WIDTH - 1.0), (13.0, q.y - 3.0))
            };
            write!(out, "<path class=\"{class}\" d=\"{line}\"/>").expect("text");
            let along = if axis == 0 { place.0 } else { place.1 };
            if along > 24.0 && along < limit - 16.0 {
                let (x, y) = (number(place.0), number(place.1));
                write!(out, "<text class=\"tick\" x=\"{x}\" y=\"{y}\">{text}</text>")
                    .expect("text");
            }
            out.push('\n');
            k += 1.0;
        }
    }
}

fn path(view: &View, points: &[Vec3]) -> String {
    let mut d = String::new();
    let mut last = String::new();
    for (i, p) in points.iter().enumerate() {
        let q = view.at(*p);
        let text = format!("{} {}", number(q.x), number(q.y));
        if text != last {
            write!(d, "{}{text}", if i == 0 { "M" } else { "L" }).expect("text");
            last = text;
        }
    }
    d
}

fn fills(out: &mut String, view: &View, s: &Shape, class: &str) {
    // All turned the same way round, so that overlapping ones make one shade.
    let turned = |p: &Vec<Vec3>| {
        let q: Vec<Vec2> = p.iter().map(|p| view.at(*p)).collect();
        let next = q.iter().cycle().skip(1);
        let area: f64 = q.iter().zip(next).map(|(a, b)| a.perp(b)).sum();
        let mut p = p.clone();
        if area < 0.0 {
            p.reverse();
        }
        path(view, &p) + "Z"
    };
    let d: String = s.patches.iter().map(turned).collect();
    if !d.is_empty() {
        writeln!(out, "<path class=\"{class}\" d=\"{d}\"/>").expect("text");
    }
}

/// `kind` is g for given, o for other, r for result.
fn strokes(out: &mut String, view: &View, s: &Shape, kind: &str) {
    let thin: String = s.relief.iter().map(|c| path(view, c)).collect();
    if !thin.is_empty() && kind != "o" {
        writeln!(out, "<path class=\"{kind}t\" d=\"{thin}\"/>").expect("text");
    }
    let bold: String = s.curves.iter().map(|c| path(view, c)).collect();
    if !bold.is_empty() {
        writeln!(out, "<path class=\"{kind}\" d=\"{bold}\"/>").expect("text");
    }
    for (foot, head, _) in &s.arrows {
        arrow(out, view.at(*foot), view.at(*head), kind);
    }
    let radius = if kind == "r" { 4.2 } else { 2.8 };
    for p in &s.dots {
        let q = view.at(*p);
        let (x, y) = (number(q.x), number(q.y));
        writeln!(out, "<circle class=\"{kind}d\" cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"/>")
            .expect("text");
    }
}

fn arrow(out: &mut String, foot: Vec2, head: Vec2, kind: &str) {
    let way = head - foot;
    let length = way.norm();
    if length < 1.0 {
        return;
    }
    let u = way / length;
    let (long, wide): (f64, f64) = if kind == "r" { (12.0, 4.5) } else { (9.0, 3.2) };
    let neck = head - u * long;
    let foot = if length > long { foot } else { neck };
    let side = Vec2::new(-u.y, u.x) * wide;
    let at = |p: Vec2| format!("{} {}", number(p.x), number(p.y));
    writeln!(
        out,
        "<path class=\"{kind}\" d=\"M{}L{}\"/><path class=\"{kind}d\" d=\"M{}L{}L{}Z\"/>",
        at(foot),
        at(neck),
        at(head),
        at(neck + side),
        at(neck - side)
    )
    .expect("text");
}

/// Names that want a place, the result's first.
fn names(view: &View, flat: bool, shapes: &[(Shape, &Item)]) -> Vec<Wanted> {
    let mut wanted = Vec::new();
    for (i, (s, item)) in shapes.iter().enumerate().rev() {
        let result = i + 1 == shapes.len();
        let class = if result { "rl" } else { "gl" };
        let mut anchors = Vec::new();
        let gap = if s.dots.is_empty() { 4.0 } else { 5.0 };
        anchors.extend(s.dots.iter().take(1).map(|p| view.at(*p)));
        for (foot, head, _) in &s.arrows {
            anchors.extend([0.6, 0.45, 0.8].map(|t| view.at(foot.lerp(head, t))));
        }
        if matches!(item.form.shape(), Form::Matrix(_)) {
            anchors = s.patches.iter().flatten().map(|p| view.at(*p)).collect();
        }
        if !s.curves.is_empty() {
            anchors.extend(along(view, s, flat));
        }
        for (_, head, name) in s.arrows.iter().filter(|a| result && !a.2.is_empty()) {
            let text = (*name).to_owned();
            wanted.push(Wanted { text, anchors: vec![view.at(*head)], class: "gl", gap: 2.0 });
        }
        if s.numbered && result {
            for (k, p) in s.dots.iter().enumerate() {
                let text = (k + 1).to_string();
                wanted.push(Wanted { text, anchors: vec![view.at(*p)], class: "gl", gap: 4.0 });
            }
        }
        if !item.name.is_empty() {
            wanted.push(Wanted { text: item.name.clone(), anchors, class, gap });
        }
    }
    wanted
}

/// Places along the curves inside of the picture, those near an end of a line first.
fn along(view: &View, s: &Shape, flat: bool) -> Vec<Vec2> {
    let mut all = Vec::new();
    for curve in &s.curves {
        let seen: Vec<Vec2> = dense(view, curve);
        let inside =
            |p: &&Vec2| (16.0..WIDTH - 16.0).contains(&p.x) && (14.0..HEIGHT - 20.0).contains(&p.y);
        let seen: Vec<Vec2> = seen.iter().filter(inside).copied().collect();
        let n = seen.len();
        if n > 0 {
            let shares = if flat {
                [96, 90, 84, 4, 10, 16, 76, 24, 66, 34]
            } else {
                [8, 92, 20, 80, 50, 35, 65, 4, 96, 60]
            };
            all.extend(shares.map(|share| seen[(n - 1) * share / 100]));
        }
    }
    all.truncate(80);
    all
}

/// A curve in the picture as points a few units apart.
fn dense(view: &View, curve: &[Vec3]) -> Vec<Vec2> {
    let mut all = Vec::new();
    for pair in curve.windows(2) {
        let (p, q) = (view.at(pair[0]), view.at(pair[1]));
        // A line may go on far beyond the picture: more steps than that show nothing.
        let steps = ((q - p).norm() / 3.0).ceil().clamp(1.0, 4000.0);
        let mut k = 0.0;
        while k < steps {
            all.push(p + (q - p) * (k / steps));
            k += 1.0;
        }
    }
    all
}

/// Points of what is drawn; those of the result count double, the thin ones half.
fn ink(view: &View, shapes: &[(Shape, &Item)], others: &[Shape]) -> Vec<Vec2> {
    let mut all = Vec::new();
    for (i, s) in shapes.iter().map(|(s, _)| s).chain(others).enumerate() {
        let curves = s.curves.iter().flat_map(|c| dense(view, c));
        let relief = s.relief.iter().flat_map(|c| dense(view, c)).step_by(2);
        let arrows = s.arrows.iter().flat_map(|(p, q, _)| dense(view, &[*p, *q]));
        let own: Vec<Vec2> = curves.chain(relief).chain(arrows).collect();
        all.extend(own.iter().copied());
        if i + 1 == shapes.len() {
            all.extend(own);
        }
        for p in &s.dots {
            let q = view.at(*p);
            let about = [[0.0, 0.0], [2.5, 0.0], [-2.5, 0.0], [0.0, 2.5], [0.0, -2.5]];
            all.extend(about.map(|[x, y]| q + Vec2::new(x, y)));
        }
    }
    all
}

/// One decimal at most, no negative zero.
fn number(x: f64) -> String {
    let text = format!("{:.1}", x + 0.0);
    let text = text.strip_suffix(".0").unwrap_or(&text);
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}
