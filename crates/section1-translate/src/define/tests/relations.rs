//! The defining relation of every format: residuals that must vanish, written without the solvers.

use aptc_geometry::{Form, Second, Vec2, Vec3, trig};
use aptc_vocabulary::word;

use super::case::{Case, Residuals, at, mirror};
use crate::define::Value;

mod parts;

use parts::{
    chosen, grid, in_out, increments, is, lconic, lift, not_below, off, on_axis, on_side, points,
    polar, product, rail, running, tabcyl, touch, vec,
};

/// The relation of a format; `None` when it has none.
#[expect(clippy::too_many_lines, reason = "one arm a format")]
pub(super) fn residuals(head: &str, key: &str, c: &Case<'_>, size: f64) -> Option<Residuals> {
    // CYLNDR takes the formats of CIRCLE.
    let head = if head == "CYLNDR"
        && !key.ends_with("vector,number")
        && key != "circle"
        && !key.starts_with("number")
        && key != "point,number,number,number,number"
    {
        "CIRCLE"
    } else {
        head
    };
    let on = |i: usize, p: Vec3| c.pl(i).distance(p).abs();
    let mine = |p: Vec3| c.plane().distance(lift(p.xy())).abs();
    let on_mine = |p: Vec3| c.plane().distance(p).abs();
    let around = |i: usize, p: Vec3| ((p - c.c(i).center).xy().norm() - c.c(i).radius).abs();
    let along = |d: Vec2| size * c.plane().n.xy().dot(&d).abs();
    let slope = |s: f64| Vec2::new(1.0, s).normalize();
    let quarter = |d: Vec2| Vec2::new(-d.y, d.x);
    let turned_by = |i: usize, d: Vec2| {
        let n = c.pl(i).n.xy();
        let along_line = Vec2::new(n.y, -n.x);
        Vec2::new(along_line.x * d.x - along_line.y * d.y, along_line.x * d.y + along_line.y * d.x)
    };
    Some(match (head, key) {
        ("POINT", "number,number") => is(c, c.n(0), c.n(1), 0.0),
        ("POINT", "number,number,number") => is(c, c.n(0), c.n(1), c.n(2)),
        ("POINT", "INTOF,line,line") => vec![on(1, c.point()), on(2, c.point())],
        ("POINT", "INTOF,plane,plane,plane") => (1..4).map(|i| on(i, c.point())).collect(),
        ("POINT", "modz,INTOF,line,circle") => {
            let (p, l, o) = (c.point().xy(), c.pl(2), c.c(3));
            let other = mirror(p, o.center.xy(), l.n.xy());
            vec![on(2, c.point()), around(3, c.point()), chosen(c, 0, p, other)]
        }
        ("POINT", "modz,INTOF,circle,circle") => {
            let (p, a, b) = (c.point().xy(), c.c(2).center.xy(), c.c(3).center.xy());
            let other = mirror(p, a, (b - a).normalize());
            vec![around(2, c.point()), around(3, c.point()), chosen(c, 0, p, other)]
        }
        ("POINT", "modz,INTOF,line,conic") => {
            vec![on(2, c.point()), off(&c.k(3), c.point().xy())]
        }
        ("POINT", "INTOF,line,TABCYL,point") => {
            let (t, q) = (c.tabcyl(2), c.point().xy());
            let here = t.meets_line(Vec2::new(0.0, 1.0), q.y);
            let near = here.iter().map(|f| (f.point - q).norm()).fold(f64::MAX, f64::min);
            vec![on(1, c.point()), near]
        }
        ("POINT", "circle,ATANGL,number") => {
            let away = c.point().xy() - c.c(0).center.xy();
            vec![
                around(0, c.point()),
                at(c.n(2)).perp(&away),
                not_below(at(c.n(2)).dot(&away), 0.0),
            ]
        }
        ("POINT", "CENTER,circle") => vec![(c.point() - c.c(1).center).xy().norm()],
        ("POINT", "RTHETA,XYPLAN|YZPLAN|ZXPLAN,number,number") => polar(c, c.n(2), c.n(3), 1),
        ("POINT", "THETAR,XYPLAN|YZPLAN|ZXPLAN,number,number") => polar(c, c.n(3), c.n(2), 1),
        ("POINT", "pattern,number") => {
            let n =
                c.points(0).iter().zip(1_u32..).find(|(_, i)| (f64::from(*i) - c.n(1)).abs() < 0.5);
            vec![vec(c.point(), *n.expect("a point of the pattern").0)]
        }
        ("POINT", "point") => vec![vec(c.point(), c.p(0))],

        ("LINE", "number,number,number,number") => {
            vec![mine(Vec3::new(c.n(0), c.n(1), 0.0)), mine(Vec3::new(c.n(2), c.n(3), 0.0))]
        }
        ("LINE", "number,number,number,number,number,number") => {
            vec![mine(Vec3::new(c.n(0), c.n(1), 0.0)), mine(Vec3::new(c.n(3), c.n(4), 0.0))]
        }
        ("LINE", "point,point") => vec![mine(c.p(0)), mine(c.p(1))],
        ("LINE" | "PLANE", "point,LEFT|RIGHT,TANTO,circle") => {
            let (p, o) = (c.p(0).xy(), c.c(3).center.xy());
            let toward = c.plane().n.dot(&lift(o)) - c.plane().d;
            [vec![mine(c.p(0)), not_below(toward, 0.0)], touch(c, 1, 3, p, o)].concat()
        }
        ("LINE" | "PLANE", "LEFT|RIGHT,TANTO,circle,LEFT|RIGHT,TANTO,circle") => {
            let (p, o) = (c.c(2).center.xy(), c.c(5).center.xy());
            let toward = c.plane().n.dot(&lift(o)) - c.plane().d;
            let both = [touch(c, 0, 2, p, o), touch(c, 3, 5, p, o)].concat();
            [both, vec![not_below(toward, 0.0)]].concat()
        }
        ("LINE", "point,ATANGL,number") => vec![mine(c.p(0)), along(at(c.n(2)))],
        ("LINE", "point,ATANGL,number,XAXIS|YAXIS") => {
            let d = at(c.n(2));
            vec![mine(c.p(0)), along(if c.is(3, word::YAXIS) { quarter(d) } else { d })]
        }
        ("LINE", "point,ATANGL,number,line") => {
            vec![mine(c.p(0)), along(turned_by(3, at(c.n(2))))]
        }
        ("LINE", "point,SLOPE,number") => vec![mine(c.p(0)), along(slope(c.n(2)))],
        ("LINE", "point,SLOPE,number,XAXIS|YAXIS") => {
            let d = slope(c.n(2));
            vec![mine(c.p(0)), along(if c.is(3, word::YAXIS) { quarter(d) } else { d })]
        }
        ("LINE", "point,SLOPE,number,line") => {
            vec![mine(c.p(0)), along(turned_by(3, slope(c.n(2))))]
        }
        ("LINE", "point,PARLEL,line") => vec![mine(c.p(0)), along(quarter(c.pl(2).n.xy()))],
        ("LINE", "point,PERPTO,line") => vec![mine(c.p(0)), along(c.pl(2).n.xy())],
        ("LINE" | "PLANE", "PARLEL,line,mod,number" | "PARLEL,plane,modz,number") => {
            let (old, new) = (c.pl(1), c.plane());
            let from = old.n * old.d;
            let way = new.n * (new.d - new.n.dot(&from));
            vec![
                size * old.n.cross(&new.n).norm(),
                (way.norm() - c.n(3).abs()).abs(),
                not_below(c.n(3).signum() * way.dot(&c.toward(2)), 0.0),
            ]
        }
        ("LINE", "INTOF,plane,plane") => {
            // A point over the line, brought onto the flatter plane, lies on the other.
            let (a, b) = (c.pl(1), c.pl(2));
            let (flat, other) = if a.n.z.abs() > b.n.z.abs() { (a, b) } else { (b, a) };
            let l = c.plane();
            let probe = |t: f64| {
                let p = lift(l.n.xy() * l.d + Vec2::new(-l.n.y, l.n.x) * t);
                let z = (flat.d - flat.n.dot(&p)) / flat.n.z;
                // A steep plane makes heights large; its share of them is what counts.
                other.distance(p + Vec3::z() * z).abs() * flat.n.z.abs().min(1.0)
            };
            vec![probe(0.0), probe(size), probe(-size)]
        }
        ("LINE", "ATANGL,number,INTERC,number") => {
            vec![mine(Vec3::new(0.0, c.n(3), 0.0)), along(at(c.n(1)))]
        }
        ("LINE", "SLOPE,number,INTERC,number") => {
            vec![mine(Vec3::new(0.0, c.n(3), 0.0)), along(slope(c.n(1)))]
        }
        ("LINE", "ATANGL,number,INTERC,XAXIS|YAXIS,number") => {
            vec![mine(on_axis(c)), along(at(c.n(1)))]
        }
        ("LINE", "SLOPE,number,INTERC,XAXIS|YAXIS,number") => {
            vec![mine(on_axis(c)), along(slope(c.n(1)))]
        }
        ("LINE", "point,TANTO,TABCYL" | "point,TANTO,TABCYL,point") => {
            let (l, t) = (c.plane(), c.tabcyl(2));
            let near = t.meets_line(l.n.xy(), l.d);
            let n = l.n.xy();
            // Some place of the curve where it lies along the line.
            let turn =
                |f: &aptc_geometry::CurveFoot| t.tangent(f.span, f.s).normalize().dot(&n).abs();
            let places = t.tangents_from(c.p(0).xy());
            let miss =
                |f: &aptc_geometry::CurveFoot| (n.dot(&f.point) - l.d).abs() + size * turn(f);
            let best = near.iter().chain(&places).map(miss).fold(f64::MAX, f64::min);
            vec![mine(c.p(0)), best]
        }
        ("LINE", "point,PERPTO,TABCYL,point") => {
            let (l, t) = (c.plane(), c.tabcyl(2));
            let n = l.n.xy();
            let turn = |f: &aptc_geometry::CurveFoot| {
                size * t.tangent(f.span, f.s).normalize().perp(&n).abs()
            };
            let best = t.meets_line(n, l.d).iter().map(turn).fold(f64::MAX, f64::min);
            vec![mine(c.p(0)), best, (-n.y).max(0.0)]
        }
        ("LINE", "XAXIS") => vec![mine(Vec3::zeros()), mine(Vec3::x())],
        ("LINE", "YAXIS") => vec![mine(Vec3::zeros()), mine(Vec3::y())],
        ("LINE", "line") | ("PLANE", "plane") => {
            vec![size * vec(c.plane().n, c.pl(0).n), (c.plane().d - c.pl(0).d).abs()]
        }

        ("PLANE", "number,number,number,number") => {
            let (n, d) = (Vec3::new(c.n(0), c.n(1), c.n(2)), c.n(3));
            let p = c.plane();
            vec![vec(p.n * n.norm(), n), (p.d * n.norm() - d).abs()]
        }
        ("PLANE", "point,point,point") => (0..3).map(|i| on_mine(c.p(i))).collect(),
        ("PLANE", "point,PARLEL,plane") => {
            vec![on_mine(c.p(0)), size * c.plane().n.cross(&c.pl(2).n).norm()]
        }
        ("PLANE", "point,PERPTO,vector") => {
            vec![on_mine(c.p(0)), size * vec(c.plane().n, c.p(2).normalize())]
        }
        ("PLANE", "PERPTO,plane,point,point") => {
            vec![on_mine(c.p(2)), on_mine(c.p(3)), size * c.plane().n.dot(&c.pl(1).n).abs()]
        }
        ("PLANE", "point,point,PERPTO,plane") => {
            vec![on_mine(c.p(0)), on_mine(c.p(1)), size * c.plane().n.dot(&c.pl(3).n).abs()]
        }
        ("PLANE", "point,PERPTO,plane,plane") => vec![
            on_mine(c.p(0)),
            size * c.plane().n.dot(&c.pl(2).n).abs(),
            size * c.plane().n.dot(&c.pl(3).n).abs(),
        ],

        ("CIRCLE", "number,number,number") => {
            vec![vec(c.circle().center, Vec3::new(c.n(0), c.n(1), 0.0)), c.circle().radius - c.n(2)]
        }
        ("CIRCLE", "number,number,number,number") => {
            let at = Vec3::new(c.n(0), c.n(1), 0.0);
            vec![vec(c.circle().center, at), c.circle().radius - c.n(3)]
        }
        ("CIRCLE", "CENTER,point,RADIUS,number") => {
            vec![(c.circle().center - c.p(1)).xy().norm(), c.circle().radius - c.n(3)]
        }
        ("CIRCLE", "CENTER,number,number,number,RADIUS,number") => {
            let at = Vec3::new(c.n(1), c.n(2), 0.0);
            vec![vec(c.circle().center, at), c.circle().radius - c.n(5)]
        }
        ("CIRCLE", "CENTER,point,TANTO,line") => {
            vec![
                (c.circle().center - c.p(1)).xy().norm(),
                on(3, lift(c.p(1).xy())) - c.circle().radius,
            ]
        }
        ("CIRCLE", "CENTER,point,point") => {
            let r = (c.p(2) - c.p(1)).xy().norm();
            vec![(c.circle().center - c.p(1)).xy().norm(), r - c.circle().radius]
        }
        ("CIRCLE", "point,point,point") => {
            let o = c.circle();
            (0..3).map(|i| (c.p(i) - o.center).xy().norm() - o.radius).collect()
        }
        ("CIRCLE", "CENTER,point,LARGE|SMALL,TANTO,circle") => {
            let (o, g) = (c.circle(), c.c(4));
            let d = (o.center - g.center).xy().norm();
            let tangent = if c.is(2, word::LARGE) {
                d - (o.radius - g.radius)
            } else {
                (d - (o.radius + g.radius)).abs().min((d - (g.radius - o.radius)).abs())
            };
            vec![(o.center - c.p(1)).xy().norm(), tangent]
        }
        ("CIRCLE", "TANTO,line,mod,point,RADIUS,number") => {
            let (o, l) = (c.circle(), c.pl(1));
            let center = lift(o.center.xy());
            let other = mirror(o.center.xy(), c.p(3).xy(), l.n.xy());
            vec![
                (l.distance(center).abs() - c.n(5)).abs(),
                (o.center - c.p(3)).xy().norm() - c.n(5),
                o.radius - c.n(5),
                chosen(c, 2, o.center.xy(), other),
            ]
        }
        ("CIRCLE", "mod,line,mod,line,RADIUS,number") => {
            let (p, r) = (c.circle().center.xy(), c.circle().radius);
            [on_side(c, 0, p, r), on_side(c, 2, p, r), vec![r - c.n(5)]].concat()
        }
        ("CIRCLE", "mod,line,mod,IN|OUT,circle,RADIUS,number") => {
            let (p, r) = (c.circle().center.xy(), c.circle().radius);
            let other = mirror(p, c.c(4).center.xy(), c.pl(1).n.xy());
            let touching = vec![in_out(c, 3, p, r), chosen(c, 2, p, other), r - c.n(6)];
            [on_side(c, 0, p, r), touching].concat()
        }
        ("CIRCLE", "mod,IN|OUT,circle,IN|OUT,circle,RADIUS,number") => {
            let (p, r) = (c.circle().center.xy(), c.circle().radius);
            let (a, b) = (c.c(2).center.xy(), c.c(4).center.xy());
            let other = mirror(p, a, (b - a).normalize());
            vec![in_out(c, 1, p, r), in_out(c, 3, p, r), chosen(c, 0, p, other), r - c.n(6)]
        }
        ("CIRCLE", "TANTO,line,mod,TABCYL,mod,point,RADIUS,number") => {
            let (o, t, l) = (c.circle(), c.tabcyl(3), c.pl(1));
            let p = o.center.xy();
            let height = l.distance(lift(p));
            // The circle touches the curve in a foot of its centre that lies on the named side.
            let feet = t.normals_from(p);
            let miss = |f: &aptc_geometry::CurveFoot| {
                let away = p - f.point;
                (away.norm() - o.radius).abs() + not_below(c.toward(4).xy().dot(&away), 0.0)
            };
            let best = feet.iter().map(miss).fold(f64::MAX, f64::min);
            let side = height * l.n.dot(&c.toward(2));
            vec![(height.abs() - o.radius).abs(), not_below(side, 0.0), best, o.radius - c.n(7)]
        }
        ("CIRCLE", "mod,line,mod,line,mod,line") => {
            let (p, r) = (c.circle().center.xy(), c.circle().radius);
            [on_side(c, 0, p, r), on_side(c, 2, p, r), on_side(c, 4, p, r)].concat()
        }
        ("CIRCLE" | "CYLNDR", "circle") => {
            let (a, b) = (c.circle(), c.c(0));
            vec![vec(a.center, b.center), vec(a.axis, b.axis), a.radius - b.radius]
        }
        ("CYLNDR", _) => {
            let mut i = 0;
            let mut read = || match c.args[i] {
                Value::Number(_) => {
                    i += 3;
                    Vec3::new(c.n(i - 3), c.n(i - 2), c.n(i - 1))
                }
                _ => {
                    i += 1;
                    c.p(i - 1)
                }
            };
            let (p, axis) = (read(), read());
            let o = c.circle();
            vec![vec(o.center, p), vec(o.axis * axis.norm(), axis), o.radius - c.n(i)]
        }

        ("SPHERE", "number,number,number,number") => {
            let at = Vec3::new(c.n(0), c.n(1), c.n(2));
            vec![vec(c.circle().center, at), c.circle().radius - c.n(3)]
        }
        ("SPHERE", "CENTER,point,RADIUS,number") => {
            vec![vec(c.circle().center, c.p(1)), c.circle().radius - c.n(3)]
        }
        ("SPHERE", "CENTER,number,number,number,RADIUS,number") => {
            let at = Vec3::new(c.n(1), c.n(2), c.n(3));
            vec![vec(c.circle().center, at), c.circle().radius - c.n(5)]
        }
        ("SPHERE", "point,number") => {
            vec![vec(c.circle().center, c.p(0)), c.circle().radius - c.n(1)]
        }
        ("SPHERE", "CENTER,point,point") => {
            vec![vec(c.circle().center, c.p(1)), c.circle().radius - vec(c.p(1), c.p(2))]
        }
        ("SPHERE", "CENTER,point,TANTO,plane") => {
            vec![vec(c.circle().center, c.p(1)), on(3, c.p(1)) - c.circle().radius]
        }
        ("SPHERE", "point,point,point,point") => {
            (0..4).map(|i| vec(c.p(i), c.circle().center) - c.circle().radius).collect()
        }
        ("CONE", "point,vector,number") => {
            let Form::Cone(k) = c.form else { panic!("a cone") };
            let cos = at(c.n(2)).x;
            vec![vec(k.vertex, c.p(0)), vec(k.axis, c.p(1).normalize()), k.cos_half - cos]
        }
        ("ELLIPS" | "HYPERB", _) => {
            let Form::Quadric(q) = c.form else { panic!("a conic") };
            let (o, u) = (c.p(1).xy(), at(c.n(4)));
            let v = quarter(u);
            let curve = |t: f64| {
                let (x, y) = if head == "ELLIPS" {
                    (trig::cos(t), trig::sin(t))
                } else {
                    (trig::cosh(t), trig::sinh(t))
                };
                o + u * (c.n(2) * x) + v * (c.n(3) * y)
            };
            [0.0, 0.7, -0.4, 1.5].iter().map(|t| off(q, curve(*t))).collect()
        }
        ("GCONIC", "number,number,number,number,number,number") => {
            let Form::Quadric(q) = c.form else { panic!("a conic") };
            [(0.3, -0.8), (1.0, 2.0), (-1.5, 0.1)]
                .iter()
                .map(|(x, y)| {
                    let terms = [x * x, x * y, y * y, *x, *y, 1.0];
                    let value: f64 = terms.iter().enumerate().map(|(i, t)| c.n(i) * t).sum();
                    q.value(Vec3::new(*x, *y, 0.0)) - value
                })
                .collect()
        }
        ("GCONIC", _) => {
            let Form::Quadric(q) = c.form else { panic!("a conic") };
            let mut all = Vec::new();
            for x in [-0.9, -0.2, 0.4, 1.1] {
                let under = c.n(2) * x * x + c.n(3) * x + c.n(4);
                for y in [1.0, -1.0].map(|s| c.n(0) * x + c.n(1) + s * under.max(0.0).sqrt()) {
                    let p = if c.is(5, word::FUNOFY) {
                        Vec3::new(y, x, 0.0)
                    } else {
                        Vec3::new(x, y, 0.0)
                    };
                    // The value, not the distance: where the root is zero the slope is without bound.
                    all.push(if under > 0.0 { q.value(p) } else { 0.0 });
                }
            }
            all
        }
        ("LCONIC", "5PT,point,point,point,point,point") => lconic(c, &[false; 5]),
        ("LCONIC", "4PT1SL,point,number,point,point,point") => {
            lconic(c, &[true, false, false, false])
        }
        ("LCONIC", "3PT2SL,point,number,point,number,point") => lconic(c, &[true, true, false]),
        ("QADRIC", _) => {
            let Form::Quadric(q) = c.form else { panic!("a quadric") };
            let probes = [[0.3, -0.8, 0.5], [1.0, 2.0, -1.0], [-1.5, 0.1, 0.7]];
            probes
                .iter()
                .map(|[x, y, z]| {
                    let t = [x * x, y * y, z * z, y * z, x * z, x * y, *x, *y, *z, 1.0];
                    let value: f64 = t.iter().enumerate().map(|(i, t)| c.n(i) * t).sum();
                    q.value(Vec3::new(*x, *y, *z)) - value
                })
                .collect()
        }

        ("VECTOR", "number,number,number") => is(c, c.n(0), c.n(1), c.n(2)),
        ("VECTOR", "number,number,number,number,number,number") => {
            is(c, c.n(3) - c.n(0), c.n(4) - c.n(1), c.n(5) - c.n(2))
        }
        ("VECTOR", "point,point") => vec![vec(c.p(0) + c.point(), c.p(1))],
        ("VECTOR", "PERPTO,plane,dir") => {
            vec![
                c.pl(1).n.cross(&c.point()).norm(),
                c.point().norm() - 1.0,
                not_below(c.point().dot(&c.toward(2)), 0.0),
            ]
        }
        ("VECTOR", "number,TIMES,vector") => {
            vec![vec(c.point(), c.p(2) * c.n(0)) / (1.0 + c.n(0).abs())]
        }
        ("VECTOR", "vector,CROSS,vector") => {
            let v = c.point();
            vec![v.dot(&c.p(0)) / (1.0 + size), v.dot(&c.p(2)) / (1.0 + size)]
        }
        ("VECTOR", "UNIT,vector") => {
            vec![c.point().norm() - 1.0, vec(c.point() * c.p(1).norm(), c.p(1))]
        }
        ("VECTOR", "UNIT,number,number,number") => {
            let v = Vec3::new(c.n(1), c.n(2), c.n(3));
            vec![c.point().norm() - 1.0, vec(c.point() * v.norm(), v)]
        }
        ("VECTOR", "LENGTH,number,ATANGL,number,XYPLAN|YZPLAN|ZXPLAN") => {
            polar(c, c.n(1), c.n(3), 4)
        }
        ("VECTOR", "PARLEL,INTOF,plane,plane,dir") => vec![
            c.point().dot(&c.pl(2).n),
            c.point().dot(&c.pl(3).n),
            c.point().norm() - 1.0,
            not_below(c.point().dot(&c.toward(4)), 0.0),
        ],
        ("VECTOR", "vector,PLUS,vector") => vec![vec(c.point() - c.p(2), c.p(0))],
        ("VECTOR", "vector,MINUS,vector") => vec![vec(c.point() + c.p(2), c.p(0))],
        ("VECTOR", "ATANGL,number,line,POSX|NEGX|POSY|NEGY|XLARGE|XSMALL|YLARGE|YSMALL") => {
            let d = turned_by(2, at(c.n(1)));
            vec![
                d.perp(&c.point().xy()),
                c.point().norm() - 1.0,
                not_below(c.point().dot(&c.toward(3)), 0.0),
            ]
        }
        ("VECTOR", "vector") => vec![vec(c.point(), c.p(0))],

        (
            "MATRIX",
            "number,number,number,number,number,number,number,number,number,number,number,number",
        ) => (0..12).map(|i| c.matrix().rows()[i] - c.n(i)).collect(),
        ("MATRIX", "INVERS,matrix") => {
            let p = Vec3::new(1.0, -2.0, 0.5);
            vec![vec(c.matrix().point(c.m(1).point(p)), p)]
        }
        ("MATRIX", "plane,plane,plane") => {
            let m = c.matrix();
            let (o, axes) = (m.point(Vec3::zeros()), [Vec3::x(), Vec3::y(), Vec3::z()]);
            (0..3).flat_map(|i| [on(i, o), vec(m.vector(axes[i]), c.pl(i).n)]).collect()
        }
        ("MATRIX", "point,vector,vector") => {
            let m = c.matrix();
            let (x, y, z) = (m.vector(Vec3::x()), m.vector(Vec3::y()), m.vector(Vec3::z()));
            vec![
                vec(m.shift, c.p(0)),
                vec(x, c.p(1).normalize()),
                z.dot(&c.p(2)),
                not_below(y.dot(&c.p(2)), 0.0),
                vec(x.cross(&y), z),
            ]
        }
        ("MATRIX", "point,vector,number") => {
            let (m, p, v) = (c.matrix(), c.p(0), c.p(1).normalize());
            let side = v.cross(&Vec3::new(0.3, -0.5, 0.7));
            let (away, d) = (m.point(p + side) - p, at(c.n(2)));
            vec![
                vec(m.point(p + v), p + v),
                away.dot(&v),
                side.dot(&away) - d.x * side.norm_squared(),
                side.cross(&away).dot(&v) - d.y * side.norm_squared(),
            ]
        }
        ("MATRIX", "MIRROR,plane") => {
            let (m, p, q) = (c.matrix(), c.pl(1), Vec3::new(0.4, 1.5, -0.6));
            let image = m.point(q);
            vec![(p.distance(q) + p.distance(image)).abs(), (image - q).cross(&p.n).norm()]
        }
        ("MATRIX", k) if k.starts_with("MIRROR") => {
            let q = Vec3::new(0.4, 1.5, -0.6);
            let flipped = |w| if (1..4).any(|i| c.is(i, w)) { -1.0 } else { 1.0 };
            let [x, y, z] = [word::YZPLAN, word::ZXPLAN, word::XYPLAN].map(flipped);
            vec![vec(c.matrix().point(q), Vec3::new(x * q.x, y * q.y, z * q.z))]
        }
        ("MATRIX", _) => product(c),

        ("PATERN", "LINEAR,point,point,number") => {
            let (a, b, n) = (c.p(1), c.p(2), c.pattern().len());
            let step = (b - a) / (c.n(3) - 1.0);
            let gaps = c.pattern().windows(2).map(|w| vec(w[1] - w[0], step));
            assert!((c.n(3) - f64::from(u32::try_from(n).unwrap())).abs() < 0.5);
            gaps.chain([vec(c.pattern()[0], a), vec(c.pattern()[n - 1], b)]).collect()
        }
        ("PATERN", "LINEAR,point,vector,number") => {
            let gaps = c.pattern().windows(2).map(|w| vec(w[1] - w[0], c.p(2)));
            gaps.chain([vec(c.pattern()[0], c.p(1))]).collect()
        }
        ("PATERN", "LINEAR,point,vector,INCR,steps") => {
            let sums = running(0.0, &increments(c, 4).concat());
            let u = c.p(2).normalize();
            points(c, &sums.iter().map(|s| c.p(1) + u * *s).collect::<Vec<_>>())
        }
        ("PATERN", "ARC,circle,number,number,CLW|CCLW,number") => {
            let (o, all) = (c.c(1), c.pattern());
            let place = |d: f64| o.center + lift(at(d)) * o.radius;
            let sense = if c.is(4, word::CLW) { -1.0 } else { 1.0 };
            let turn = |w: &[Vec3]| {
                let (p, q) = ((w[0] - o.center).xy(), (w[1] - o.center).xy());
                let angle = trig::atan2(p.perp(&q), p.dot(&q));
                (sense * angle).rem_euclid(2.0 * std::f64::consts::PI)
            };
            let steps: Vec<f64> = all.windows(2).map(turn).collect();
            let round = all.iter().map(|p| (p - o.center).norm() - o.radius);
            let ends = [vec(all[0], place(c.n(2))), vec(all[all.len() - 1], place(c.n(3)))];
            let even = steps.iter().map(|s| o.radius * trig::sin(0.5 * (s - steps[0])));
            round.chain(ends).chain(even).collect()
        }
        ("PATERN", "ARC,circle,number,CLW|CCLW,INCR,steps") => {
            let (o, sense) = (c.c(1), if c.is(3, word::CLW) { -1.0 } else { 1.0 });
            let mut angle = c.n(2);
            let mut all = Vec::new();
            for group in increments(c, 5) {
                let sums = running(angle, &group.iter().map(|s| s * sense).collect::<Vec<_>>());
                angle = sums[sums.len() - 1];
                all.extend(sums.iter().map(|d| o.center + lift(at(*d)) * o.radius));
            }
            points(c, &all)
        }
        ("PATERN", "PARLEL|GRID|PERIM,pattern,pattern") => {
            let row = c.points(2);
            let end = row[row.len() - 1];
            let column = c.points(1);
            let near = |p: Vec3| vec(p, column[0]).min(vec(p, column[column.len() - 1]));
            let mut ways: Vec<Vec3> = row.to_vec();
            if near(end) < near(row[0]) {
                ways.reverse();
            }
            let from = ways[0];
            grid(c, &ways.iter().map(|p| p - from).collect::<Vec<_>>())
        }
        ("PATERN", "PARLEL|GRID|PERIM,pattern,vector,number") => {
            let mut ways = Vec::new();
            let mut i = 0.0;
            while i < c.n(3) - 0.5 {
                ways.push(c.p(2) * i);
                i += 1.0;
            }
            grid(c, &ways)
        }
        ("PATERN", "PARLEL|GRID|PERIM,pattern,vector,INCR,steps") => {
            let (mut from, mut ways) = (0.0, Vec::new());
            let u = c.p(2).normalize();
            for group in increments(c, 4) {
                let sums = running(from, &group);
                from = sums[sums.len() - 1];
                ways.extend(sums.iter().map(|s| u * *s));
            }
            grid(c, &ways)
        }
        ("PATERN", "RANDOM,points and patterns") => {
            let mut all = Vec::new();
            for i in 1..c.args.len() {
                match &c.args[i] {
                    Value::Form { form, .. } if matches!(&**form, Form::Pattern(_)) => {
                        all.extend_from_slice(c.points(i));
                    }
                    _ => all.push(c.p(i)),
                }
            }
            points(c, &all)
        }
        ("PATERN", "pattern") => points(c, c.points(0)),
        ("TABCYL", _) => tabcyl(c),
        ("RLDSRF", _) => {
            let Form::Ruled(r) = c.form else { panic!("a ruled surface") };
            let second = match &r.second {
                Second::Rail(other) => rail(c, 4, other),
                Second::Apex(p) => vec![vec(*p, c.p(4))],
            };
            [rail(c, 0, &r.first), second].concat()
        }
        _ => return None,
    })
}
