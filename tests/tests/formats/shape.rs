//! From a form to curves, patches, dots and arrows in space.

use aptc_geometry::sculpt::{Layout, fit_curve, fit_surface};
use aptc_geometry::sculptured::{SurfaceDefinition, SurfaceShape};
use aptc_geometry::{
    Circle, Cone, Cylinder, Form, Plane, Quadric, RuledSurface, Sphere, Tabcyl, Transform, Vec3,
    trig,
};

use super::contour;
use super::motion::Path;
use super::scene::Item;
use super::view::Bounds;

/// Steps of a full circle.
const ROUND: u32 = 96;
/// Height of the letter that shows what a matrix does.
const LETTER: f64 = 12.0;

/// What is drawn of a form.
#[derive(Default)]
pub(crate) struct Shape {
    /// Curves: outlines, edges, traces.
    pub(crate) curves: Vec<Vec<Vec3>>,
    /// Thin curves that give a surface its relief.
    pub(crate) relief: Vec<Vec<Vec3>>,
    /// Patches to be filled.
    pub(crate) patches: Vec<Vec<Vec3>>,
    /// Dots.
    pub(crate) dots: Vec<Vec3>,
    /// Arrows from foot to head, with what stands at the head.
    pub(crate) arrows: Vec<(Vec3, Vec3, &'static str)>,
    /// Number the dots?
    pub(crate) numbered: bool,
}

impl Shape {
    /// Every point that it holds.
    pub(crate) fn points(&self) -> impl Iterator<Item = Vec3> + '_ {
        let curves = self.curves.iter().chain(&self.patches).flatten().copied();
        curves.chain(self.dots.iter().copied()).chain(self.arrows.iter().flat_map(|a| [a.0, a.1]))
    }
}

/// The points that an item certainly wants in its picture: all of what ends, little of what does not.
pub(crate) fn core(item: &Item) -> Vec<Vec3> {
    match item.form.shape() {
        _ if item.path.is_some() => shape(item, None, true).points().collect(),
        Form::Line(_) | Form::Plane(_) => Vec::new(),
        Form::Cylinder(c) => {
            let ends = [-1.0, 1.0].map(|s| c.point + c.axis * (s * 1.4 * c.radius));
            ends.iter().flat_map(|p| ring(*p, c.axis, c.radius)).collect()
        }
        Form::Cone(c) => cone_base(c, CONE_HEIGHT).into_iter().chain([c.vertex]).collect(),
        Form::Quadric(q) => contour::extent(q),
        _ => shape(item, None, true).points().collect(),
    }
}

/// Height at which a cone is cut off.
const CONE_HEIGHT: f64 = 30.0;

/// What is drawn of the item. What has no end goes to the box `room`; `flat` when seen from the top.
pub(crate) fn shape(item: &Item, room: Option<&Bounds>, flat: bool) -> Shape {
    let mut s = Shape::default();
    if let Some(path) = &item.path {
        way(&mut s, path);
        return s;
    }
    match item.form.shape() {
        Form::Point(p) => s.dots.push(*p),
        Form::Vector(v) => s.arrows.push((item.foot, item.foot + v, "")),
        Form::Line(l) => plane(&mut s, &l.plane(), room, flat),
        Form::Plane(p) => plane(&mut s, p, room, flat),
        Form::Circle(c) => circle(&mut s, c, flat),
        Form::Cylinder(c) => cylinder(&mut s, c, flat),
        Form::Sphere(b) => sphere(&mut s, b),
        Form::Cone(c) => cone(&mut s, c),
        Form::Quadric(q) => quadric(&mut s, q, room, flat),
        Form::Matrix(m) => matrix(&mut s, m, flat),
        Form::Pattern(p) => {
            s.dots.clone_from(&p.points);
            s.relief.push(p.points.clone());
            s.numbered = true;
        }
        Form::Tabcyl(t) => tabcyl(&mut s, t, flat),
        Form::Ruled(r) => ruled(&mut s, r),
        Form::Polyconic(p) => net(&mut s, [8, 8], |u, v| p.point(u, v)),
        Form::Scurv(c) => {
            if let Ok(c) = fit_curve(c) {
                let at = |i: u32| c.at(share(i, ROUND) * c.span()).point;
                s.curves.push((0..=ROUND).map(at).collect());
            }
        }
        Form::Ssurf(d) => {
            if let Ok(f) = fit_surface(&near(d)) {
                let [m, n] = f.spans();
                match f.layout {
                    Layout::Mesh { .. } => {
                        net(&mut s, [10, 10], |u, v| Some(f.at(u * m, v * n).point));
                    }
                    // One patch after the other; the end of each belongs to it, not to the next.
                    Layout::Patches => (0_u32..).zip(&f.patches).for_each(|(i, _)| {
                        let at = |u: f64| f64::from(i) + u * (1.0 - 1e-9);
                        net(&mut s, [5, 5], |u, v| Some(f.at(at(u), v).point));
                    }),
                }
            }
        }
        Form::Solid(solid) => {
            for (form, _) in &solid.parts {
                let part = Item {
                    name: String::new(),
                    form: form.clone().into(),
                    foot: item.foot,
                    path: None,
                };
                let part = shape(&part, room, flat);
                s.curves.extend(part.curves);
                s.relief.extend(part.relief);
                s.patches.extend(part.patches);
            }
        }
        Form::Written(_) => {}
    }
    s
}

/// The same, but what goes along an axis to where the picture ends.
fn near(d: &SurfaceDefinition) -> SurfaceDefinition {
    const SWEPT: f64 = 30.0;
    let mut near = d.clone();
    if let SurfaceShape::RuledAlong { reach, .. } = &mut near.shape {
        *reach = SWEPT;
    }
    near
}

/// The path with an arrow on each way, the cutter where a motion ends, and where it begins.
fn way(s: &mut Shape, path: &Path) {
    s.curves.clone_from(&path.feed);
    s.relief.clone_from(&path.rapid);
    s.relief.extend(path.stops.iter().map(|(p, radius)| ring(*p, Vec3::z(), *radius)));
    for (end, top, radius) in &path.tools {
        let axis = (top - end).normalize();
        s.relief.extend([vec![*end, *top], ring(*end, axis, *radius), ring(*top, axis, *radius)]);
    }
    for points in &path.feed {
        let longest =
            points.windows(2).max_by(|a, b| (a[1] - a[0]).norm().total_cmp(&(b[1] - b[0]).norm()));
        let whole: f64 = points.windows(2).map(|p| (p[1] - p[0]).norm()).sum();
        if let Some([p, q]) = longest.filter(|_| whole > 4.0) {
            s.arrows.push((*p, p.lerp(q, 0.5), ""));
        }
    }
    s.dots.extend(path.start);
}

fn share(i: u32, n: u32) -> f64 {
    f64::from(i) / f64::from(n)
}

/// Two unit vectors that make a frame with `axis`.
pub(crate) fn across(axis: Vec3) -> [Vec3; 2] {
    let other = if axis.x.abs() < 0.9 { Vec3::x() } else { Vec3::y() };
    let u = (other - axis * axis.dot(&other)).normalize();
    [u, axis.cross(&u)]
}

fn ring(center: Vec3, axis: Vec3, radius: f64) -> Vec<Vec3> {
    let [u, v] = across(axis);
    let at = |i: u32| {
        let angle = share(i, ROUND) * 360.0;
        center + (u * trig::cos_deg(angle) + v * trig::sin_deg(angle)) * radius
    };
    (0..=ROUND).map(at).collect()
}

fn plane(s: &mut Shape, p: &Plane, room: Option<&Bounds>, flat: bool) {
    let Some(room) = room else { return };
    let middle = room.middle();
    let foot = middle - p.n * p.distance(middle);
    let far = room.size().norm();
    if flat {
        let along = Vec3::z().cross(&p.n) * far;
        s.curves.push(vec![foot - along, foot + along]);
        return;
    }
    // A square about the place nearest to the middle.
    let half = room.size().amax() * 0.5;
    let [u, v] = across(p.n).map(|v| v * half);
    let patch = vec![foot - u - v, foot + u - v, foot + u + v, foot - u + v];
    s.curves.push(patch.iter().copied().chain([patch[0]]).collect());
    s.patches.push(patch);
}

fn circle(s: &mut Shape, c: &Circle, flat: bool) {
    s.curves.push(ring(c.center, c.axis, c.radius));
    if !flat {
        s.patches.push(ring(c.center, c.axis, c.radius));
    }
}

/// The eye of the view from the front, the right and above.
fn eye() -> Vec3 {
    Vec3::new(1.0, -1.0, 1.0).normalize()
}

fn cylinder(s: &mut Shape, c: &Cylinder, flat: bool) {
    if flat {
        s.curves.push(ring(c.point, c.axis, c.radius));
        return;
    }
    let reach = c.axis * (1.4 * c.radius);
    let ends = [c.point - reach, c.point + reach];
    s.curves.extend(ends.map(|p| ring(p, c.axis, c.radius)));
    s.relief.push(ring(c.point, c.axis, c.radius));
    s.relief.push(vec![ends[0], ends[1]]);
    if let Some(n) = c.axis.cross(&eye()).try_normalize(1e-9) {
        for side in [-c.radius, c.radius] {
            s.curves.push(ends.map(|p| p + n * side).to_vec());
        }
        let quad = [ends[0] + n * c.radius, ends[1] + n * c.radius];
        s.patches.push(vec![quad[0], quad[1], ends[1] - n * c.radius, ends[0] - n * c.radius]);
        s.patches.extend(ends.map(|p| ring(p, c.axis, c.radius)));
    }
}

fn sphere(s: &mut Shape, b: &Sphere) {
    s.curves.push(ring(b.center, eye(), b.radius));
    s.patches.push(ring(b.center, eye(), b.radius));
    for axis in [Vec3::x(), Vec3::y(), Vec3::z()] {
        s.relief.push(ring(b.center, axis, b.radius));
    }
}

fn cone_base(c: &Cone, height: f64) -> Vec<Vec3> {
    let radius = height * (1.0 - c.cos_half * c.cos_half).sqrt() / c.cos_half;
    ring(c.vertex + c.axis * height, c.axis, radius)
}

fn cone(s: &mut Shape, c: &Cone) {
    let base = cone_base(c, CONE_HEIGHT);
    s.relief.push(cone_base(c, CONE_HEIGHT / 2.0));
    s.relief.extend(base.iter().step_by(12).map(|p| vec![c.vertex, *p]));
    // The outline are the rulings farthest to both sides of the axis, as the eye sees them.
    if let Some(side) = c.axis.cross(&eye()).try_normalize(1e-9) {
        let key = |p: &Vec3| {
            let seen = |v: Vec3| v - eye() * v.dot(&eye());
            let (to, axis) = (seen(p - c.vertex), seen(c.axis));
            to.dot(&side) / to.dot(&axis).max(1e-9)
        };
        let most = base.iter().max_by(|p, q| key(p).total_cmp(&key(q)));
        let least = base.iter().min_by(|p, q| key(p).total_cmp(&key(q)));
        for p in [most, least].into_iter().flatten() {
            s.curves.push(vec![c.vertex, *p]);
        }
        if let (Some(p), Some(q)) = (most, least) {
            s.patches.push(vec![c.vertex, *p, *q]);
        }
    }
    s.patches.push(base.clone());
    s.curves.push(base);
}

fn quadric(s: &mut Shape, q: &Quadric, room: Option<&Bounds>, flat: bool) {
    let Some(room) = room else {
        s.dots.extend(contour::extent(q));
        return;
    };
    if flat {
        s.curves.extend(contour::slice(q, room, 2, 0.0));
        return;
    }
    for i in 0..=8 {
        let at = room.low.z + room.size().z * share(i, 8);
        s.curves.extend(contour::slice(q, room, 2, at));
    }
    for axis in [0, 1] {
        s.relief.extend(contour::slice(q, room, axis, room.middle()[axis]));
    }
}

/// The letter F and the axes before and after.
fn matrix(s: &mut Shape, m: &Transform, flat: bool) {
    let axis = [(Vec3::x(), "x'"), (Vec3::y(), "y'"), (Vec3::z(), "z'")];
    for (v, name) in axis.iter().take(if flat { 2 } else { 3 }) {
        s.arrows.push((m.point(Vec3::zeros()), m.point(v * (LETTER * 1.5)), name));
    }
    s.patches.push(letter().map(|p| m.point(p)).to_vec());
    let closed: Vec<Vec3> = letter().iter().chain([&letter()[0]]).map(|p| m.point(*p)).collect();
    s.curves.push(closed);
}

/// An F in the first quadrant of the xy plane: it shows turns and mirrors.
pub(crate) fn letter() -> [Vec3; 10] {
    let f = [
        [0.2, 0.2],
        [0.4, 0.2],
        [0.4, 0.5],
        [0.65, 0.5],
        [0.65, 0.7],
        [0.4, 0.7],
        [0.4, 0.9],
        [0.75, 0.9],
        [0.75, 1.1],
        [0.2, 1.1],
    ];
    f.map(|[x, y]| Vec3::new(x, y, 0.0) * LETTER)
}

fn tabcyl(s: &mut Shape, t: &Tabcyl, flat: bool) {
    // The first and the last span only prolong the curve.
    let inner = 1..t.spans.len().saturating_sub(1);
    let trace = |w: f64| -> Vec<Vec3> {
        let along = |i: usize| {
            let length = t.spans[i].length;
            (0..=12_u32).map(move |k| t.lift(t.point(i, length * share(k, 12)), w))
        };
        inner.clone().flat_map(along).collect()
    };
    let joints = inner.clone().chain([t.spans.len() - 1]).map(|i| t.spans[i].start);
    if flat {
        s.curves.push(trace(0.0));
        return;
    }
    let (low, high) = (0.0, 30.0);
    s.curves.extend([trace(low), trace(high)]);
    let ends: Vec<_> = joints.collect();
    for (i, p) in ends.iter().enumerate() {
        let ruling = vec![t.lift(*p, low), t.lift(*p, high)];
        if i == 0 || i + 1 == ends.len() { s.curves.push(ruling) } else { s.relief.push(ruling) }
    }
    let mut patch = trace(low);
    patch.extend(trace(high).into_iter().rev());
    s.patches.push(patch);
}

fn ruled(s: &mut Shape, r: &RuledSurface) {
    net(s, [12, 4], |t, u| r.point(t, u).ok());
}

/// The net of a surface over the unit square: its border bold, lines between thin.
fn net(s: &mut Shape, cells: [u32; 2], at: impl Fn(f64, f64) -> Option<Vec3>) {
    let fine = 4;
    let [m, n] = cells;
    let mut line = |fixed: u32, count: u32, other: u32, first: bool| {
        let f = share(fixed, count);
        let run = (0..=other * fine).map(|k| share(k, other * fine));
        let curve: Option<Vec<Vec3>> =
            run.map(|t| if first { at(f, t) } else { at(t, f) }).collect();
        let Some(curve) = curve else { return };
        let border = fixed == 0 || fixed == count;
        if border { s.curves.push(curve) } else { s.relief.push(curve) }
    };
    (0..=m).for_each(|i| line(i, m, n, true));
    (0..=n).for_each(|j| line(j, n, m, false));
    for (i, j) in (0..m).flat_map(|i| (0..n).map(move |j| (i, j))) {
        let corner = |a: u32, b: u32| at(share(i + a, m), share(j + b, n));
        let patch: Option<Vec<Vec3>> =
            [(0, 0), (1, 0), (1, 1), (0, 1)].into_iter().map(|(a, b)| corner(a, b)).collect();
        s.patches.extend(patch);
    }
}
