//! What several relations have in common.

use aptc_geometry::{Fit, Form, Quadric, Transform, Vec2, Vec3, trig};
use aptc_vocabulary::word;

use crate::define::Value;
use crate::define::tests::case::{Case, Residuals, at};

/// Zero when `a >= b`.
pub(super) fn not_below(a: f64, b: f64) -> f64 {
    (b - a).max(0.0)
}

pub(super) fn vec(a: Vec3, b: Vec3) -> f64 {
    (a - b).norm()
}

pub(super) fn lift(v: Vec2) -> Vec3 {
    Vec3::new(v.x, v.y, 0.0)
}

/// Residuals of a result that must be a certain point or vector.
pub(super) fn is(c: &Case<'_>, x: f64, y: f64, z: f64) -> Residuals {
    vec![vec(c.point(), Vec3::new(x, y, z))]
}

/// By how much a circle of radius `r` about `p` misses the distance for IN or OUT at `i` to circle `i + 1`.
pub(super) fn in_out(c: &Case<'_>, i: usize, p: Vec2, r: f64) -> f64 {
    let o = c.c(i + 1);
    let wanted = if c.is(i, word::IN) { (o.radius - r).abs() } else { o.radius + r };
    ((p - o.center.xy()).norm() - wanted).abs()
}

/// Distance from the line at `i + 1` less `r`, and the side that the modifier at `i` names.
pub(super) fn on_side(c: &Case<'_>, i: usize, p: Vec2, r: f64) -> Residuals {
    let l = c.pl(i + 1);
    let height = l.n.dot(&lift(p)) - l.d;
    vec![(height.abs() - r).abs(), not_below(height * l.n.dot(&c.toward(i)), 0.0)]
}

/// The chosen point is not behind the other solution.
pub(super) fn chosen(c: &Case<'_>, i: usize, p: Vec2, other: Vec2) -> f64 {
    let axis = c.toward(i).xy();
    not_below(axis.dot(&p), axis.dot(&other))
}

/// Which side of the way from `from` to `to` the line touches the circle at `i`: LEFT or RIGHT at `side`.
pub(super) fn touch(c: &Case<'_>, side: usize, i: usize, from: Vec2, to: Vec2) -> Residuals {
    let (l, o) = (c.plane(), c.c(i));
    let height = l.n.dot(&lift(o.center.xy())) - l.d;
    let foot = o.center.xy() - l.n.xy() * height;
    let lead = (to - from).perp(&(foot - o.center.xy())) / (to - from).norm();
    let sign = if c.is(side, word::LEFT) { 1.0 } else { -1.0 };
    vec![(height.abs() - o.radius).abs(), not_below(sign * lead, 0.0)]
}

/// How far `p` is from the conic, to first order.
pub(super) fn off(q: &Quadric, p: Vec2) -> f64 {
    q.value(lift(p)).abs() / q.gradient(lift(p)).norm()
}

/// How much the conic turns away at `p` from a slope, as a length.
fn turned(q: &Quadric, p: Vec2, slope: f64, size: f64) -> f64 {
    let along = Vec3::new(1.0, slope, 0.0).normalize();
    size * (q.gradient(lift(p)).dot(&along) / q.gradient(lift(p)).norm()).abs()
}

/// Points of a LCONIC with the slopes after them.
fn conic_points(c: &Case<'_>, slopes: &[bool]) -> Vec<(Vec2, Option<f64>)> {
    let mut i = 1;
    let mut all = Vec::new();
    for slope in slopes {
        let p = match c.args[i] {
            Value::Number(x) => {
                i += 2;
                Vec2::new(x, c.n(i - 1))
            }
            _ => {
                i += 1;
                c.p(i - 1).xy()
            }
        };
        all.push((p, slope.then(|| c.n(i))));
        i += usize::from(*slope);
    }
    all
}

pub(super) fn lconic(c: &Case<'_>, slopes: &[bool]) -> Residuals {
    let Form::Quadric(q) = c.form else { panic!("a conic") };
    let all = conic_points(c, slopes);
    let size = all.iter().fold(0.0_f64, |m, (p, _)| m.max(p.amax()));
    let each = |(p, slope): &(Vec2, Option<f64>)| {
        let turn = slope.map_or(0.0, |s| turned(q, *p, s, size));
        off(q, *p).max(turn)
    };
    all.iter().map(each).collect()
}

/// One map of a MATRIX statement and where the next begins.
fn step(c: &Case<'_>, i: usize) -> (Transform, usize, &'static str) {
    let plane = |from: usize, to: usize| {
        let (s, k) = trig::sin_cos(c.n(i + 1).to_radians());
        let mut m = Transform::identity();
        (m.linear[(from, from)], m.linear[(to, to)]) = (k, k);
        (m.linear[(from, to)], m.linear[(to, from)]) = (-s, s);
        (m, i + 2, "turn")
    };
    match &c.args[i] {
        Value::Word(word::XYROT) => plane(0, 1),
        Value::Word(word::YZROT) => plane(1, 2),
        Value::Word(word::ZXROT) => plane(2, 0),
        Value::Word(word::SCALE) => (Transform::scale(c.n(i + 1)), i + 2, ""),
        Value::Word(word::TRANSL) => {
            let z = matches!(c.args.get(i + 3), Some(Value::Number(_)));
            let v = Vec3::new(c.n(i + 1), c.n(i + 2), if z { c.n(i + 3) } else { 0.0 });
            (Transform::translation(v), if z { i + 4 } else { i + 3 }, "move")
        }
        _ => (c.m(i), i + 1, ""),
    }
}

/// What the map does to some points, against the maps of the statement one after the other.
pub(super) fn product(c: &Case<'_>) -> Residuals {
    let (one, next, first) = step(c, 0);
    let probes = [Vec3::zeros(), Vec3::x(), Vec3::y(), Vec3::new(1.0, -2.0, 3.0)];
    if next == c.args.len() {
        return probes.iter().map(|p| vec(c.matrix().point(*p), one.point(*p))).collect();
    }
    let (other, _, second) = step(c, next);
    let in_order = matches!((first, second), ("turn", "move") | ("move", "turn"));
    let whole = |p: Vec3| {
        if in_order { other.point(one.point(p)) } else { one.point(other.point(p)) }
    };
    probes.iter().map(|p| vec(c.matrix().point(*p), whole(*p))).collect()
}

/// The increments from argument `i` on, as a list of groups.
pub(super) fn increments(c: &Case<'_>, mut i: usize) -> Vec<Vec<f64>> {
    let mut groups = vec![Vec::new()];
    while i < c.args.len() {
        if c.is(i, word::INCR) {
            groups.push(Vec::new());
            i += 1;
        } else if c.is(i + 1, word::AT) {
            let mut left = c.n(i);
            while left > 0.5 {
                groups.last_mut().unwrap().push(c.n(i + 2));
                left -= 1.0;
            }
            i += 3;
        } else {
            groups.last_mut().unwrap().push(c.n(i));
            i += 1;
        }
    }
    groups
}

/// The pattern is exactly these points.
pub(super) fn points(c: &Case<'_>, expected: &[Vec3]) -> Residuals {
    assert_eq!(c.pattern().len(), expected.len(), "{:?}", c.args);
    c.pattern().iter().zip(expected).map(|(a, b)| vec(*a, *b)).collect()
}

pub(super) fn running(start: f64, steps: &[f64]) -> Vec<f64> {
    let mut all = vec![start];
    for s in steps {
        all.push(all[all.len() - 1] + s);
    }
    all
}

/// Column after column, every second one backwards; for PERIM the border, once around.
pub(super) fn grid(c: &Case<'_>, ways: &[Vec3]) -> Residuals {
    let column = c.points(1);
    if !c.is(0, word::PERIM) || ways.len() < 2 || column.len() < 2 {
        let mut all = Vec::new();
        for (i, way) in ways.iter().enumerate() {
            let moved = column.iter().map(|p| p + way);
            if i % 2 == 0 { all.extend(moved) } else { all.extend(moved.rev()) }
        }
        return points(c, &all);
    }
    // Each border point once, and neighbours are neighbours of the grid.
    let border = 2 * (column.len() + ways.len()) - 4;
    assert_eq!(c.pattern().len(), border);
    let on_grid = |q: &Vec3| {
        let all = ways
            .iter()
            .enumerate()
            .flat_map(|(i, w)| column.iter().enumerate().map(move |(j, p)| (i, j, vec(p + w, *q))));
        all.min_by(|a, b| a.2.total_cmp(&b.2)).unwrap()
    };
    c.pattern().iter().map(|q| on_grid(q).2).collect()
}

/// The TABCYL goes through its data with the slopes given, its generatrix is right.
pub(super) fn tabcyl(c: &Case<'_>) -> Residuals {
    let Form::Tabcyl(t) = c.form else { panic!("a TABCYL") };
    let mut i = 2;
    let m = if c.is(2, word::TRFORM) {
        i = 4;
        c.m(3)
    } else {
        Transform::identity()
    };
    let polar = c.is(0, word::RTHETA) || c.is(0, word::THETAR);
    let mut residuals = Vec::new();
    let w = match &c.args[0] {
        Value::Word(word::XYZ) => {
            i += 1;
            c.p(i - 1).normalize()
        }
        Value::Word(word::NOX) => Vec3::x(),
        Value::Word(word::NOY) => Vec3::y(),
        _ => Vec3::z(),
    };
    let flat = |a: f64, b: f64| match &c.args[0] {
        Value::Word(word::NOX) => Vec3::new(0.0, a, b),
        Value::Word(word::NOY) => Vec3::new(b, 0.0, a),
        _ => Vec3::new(a, b, 0.0),
    };
    residuals.push(vec(m.vector(w).normalize().cross(&t.w()), Vec3::zeros()));
    let mut span = 1;
    while i < c.args.len() {
        let p = match &c.args[i] {
            Value::Number(x) if c.is(0, word::XYZ) => {
                i += 3;
                Vec3::new(*x, c.n(i - 2), c.n(i - 1))
            }
            Value::Number(x) => {
                i += 2;
                let y = c.n(i - 1);
                match (polar, c.is(0, word::RTHETA)) {
                    (true, true) => lift(at(y) * *x),
                    (true, false) => lift(at(*x) * y),
                    _ => flat(*x, y),
                }
            }
            _ => {
                i += 1;
                c.p(i - 1)
            }
        };
        residuals.push((t.spans[span].start - t.flatten(m.point(p))).norm());
        let slope = |s: f64| flat(1.0, s);
        let normal = |n: f64| flat(-at(n).y, at(n).x);
        let tangent = if c.is(1, word::PTSLOP) {
            i += 1;
            Some(slope(c.n(i - 1)))
        } else if c.is(1, word::PTNORM) {
            i += 1;
            Some(normal(c.n(i - 1)))
        } else if c.is(i, word::SLOPE) || c.is(i, word::NORMAL) {
            i += 2;
            let value = c.n(i - 1);
            Some(if c.is(i - 2, word::SLOPE) { slope(value) } else { normal(value) })
        } else {
            None
        };
        // Within a SPLINE a slope does not count.
        let counts = !c.is(1, word::SPLINE) || span == 1 || i >= c.args.len();
        if let Some(along) = tangent.filter(|_| counts) {
            let along = t.flatten(m.vector(along)).normalize();
            residuals.push(along.perp(&t.tangent(span, 0.0).normalize()).abs());
        }
        span += 1;
    }
    assert_eq!(span, t.spans.len());
    if !c.is(1, word::FOURPT) {
        for i in 1..t.spans.len() - 2 {
            let l = t.spans[i].length;
            let (u, v) = (t.tangent(i, l).normalize(), t.tangent(i + 1, 0.0).normalize());
            residuals.push((u - v).norm());
        }
    }
    // The straight ends go on in the direction of the curve, and no gap is left anywhere.
    let _ = Fit::Spline;
    for i in 0..t.spans.len() {
        residuals.push((t.point(i, t.spans[i].length) - t.span_end(i)).norm());
    }
    residuals
}

pub(super) fn rail(c: &Case<'_>, i: usize, rail: &aptc_geometry::Rail) -> Residuals {
    let chord = (rail.end - rail.start).normalize();
    let across = rail.toward - chord * rail.toward.dot(&chord);
    let given = match &c.args[i + 3] {
        Value::Form { form, .. } if matches!(&**form, Form::Vector(_)) => c.p(i + 3),
        _ => c.p(i + 3) - rail.start,
    };
    vec![
        vec(rail.start, c.p(i + 1)),
        vec(rail.end, c.p(i + 2)),
        // The third point or the vector lies in the cutting plane, on the side of `toward`.
        chord.cross(&across.normalize()).dot(&given),
        not_below(given.dot(&across), 0.0),
    ]
}

/// The point of the axis at argument 3 that has the coordinate at 4.
pub(super) fn on_axis(c: &Case<'_>) -> Vec3 {
    if c.is(3, word::XAXIS) { Vec3::x() * c.n(4) } else { Vec3::y() * c.n(4) }
}

/// Polar coordinates in the plane at argument `i`.
pub(super) fn polar(c: &Case<'_>, r: f64, degrees: f64, i: usize) -> Residuals {
    let p = at(degrees) * r;
    if c.is(i, word::XYPLAN) {
        is(c, p.x, p.y, 0.0)
    } else if c.is(i, word::YZPLAN) {
        is(c, 0.0, p.x, p.y)
    } else {
        is(c, p.y, 0.0, p.x)
    }
}
