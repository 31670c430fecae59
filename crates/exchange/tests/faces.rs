//! Faces of STEP as patches of their surfaces, by closed forms.

use aptc_exchange::{Limits, Outside, read};
use aptc_geometry::Vec3;
use aptc_geometry::sculpt::{Sculptured, fit_surface};

/// A file of STEP that is put together from numbered entities.
#[derive(Default)]
struct Step(Vec<String>);

impl Step {
    fn add(&mut self, entity: String) -> usize {
        self.0.push(entity);
        self.0.len()
    }

    fn point(&mut self, [x, y, z]: [f64; 3]) -> usize {
        self.add(format!("CARTESIAN_POINT('',({x:?},{y:?},{z:?}))"))
    }

    fn direction(&mut self, [x, y, z]: [f64; 3]) -> usize {
        self.add(format!("DIRECTION('',({x:?},{y:?},{z:?}))"))
    }

    fn frame(&mut self, at: [f64; 3], z: [f64; 3], x: [f64; 3]) -> usize {
        let (p, z, x) = (self.point(at), self.direction(z), self.direction(x));
        self.add(format!("AXIS2_PLACEMENT_3D('',#{p},#{z},#{x})"))
    }

    fn vertex(&mut self, at: [f64; 3]) -> usize {
        let p = self.point(at);
        self.add(format!("VERTEX_POINT('',#{p})"))
    }

    fn line(&mut self, from: [f64; 3], to: [f64; 3]) -> usize {
        let d = [0, 1, 2].map(|i| to[i] - from[i]);
        let (p, d) = (self.point(from), self.direction(d));
        let v = self.add(format!("VECTOR('',#{d},1.)"));
        self.add(format!("LINE('',#{p},#{v})"))
    }

    fn circle(&mut self, at: [f64; 3], z: [f64; 3], x: [f64; 3], r: f64) -> usize {
        let frame = self.frame(at, z, x);
        self.add(format!("CIRCLE('',#{frame},{r:?})"))
    }

    /// An edge along a curve, `along` its sense.
    fn edge(&mut self, ends: [usize; 2], curve: usize, along: bool) -> usize {
        let [a, b] = ends;
        self.add(format!("EDGE_CURVE('',#{a},#{b},#{curve},{})", flag(along)))
    }

    /// A loop of edges, each with its sense.
    fn bound(&mut self, edges: &[(usize, bool)]) -> usize {
        let all: Vec<String> = edges
            .iter()
            .map(|(e, along)| {
                let id = self.add(format!("ORIENTED_EDGE('',*,*,#{e},{})", flag(*along)));
                format!("#{id}")
            })
            .collect();
        let id = self.add(format!("EDGE_LOOP('',({}))", all.join(",")));
        self.add(format!("FACE_BOUND('',#{id},.T.)"))
    }

    fn face(&mut self, bounds: &[usize], surface: usize) -> usize {
        let all: Vec<String> = bounds.iter().map(|b| format!("#{b}")).collect();
        self.add(format!("ADVANCED_FACE('',({}),#{surface},.T.)", all.join(",")))
    }

    /// Straight edges around corners.
    fn polygon(&mut self, corners: &[[f64; 3]]) -> usize {
        let vertices: Vec<usize> = corners.iter().map(|p| self.vertex(*p)).collect();
        let edges: Vec<_> = (0..corners.len())
            .map(|k| {
                let j = (k + 1) % corners.len();
                let line = self.line(corners[k], corners[j]);
                (self.edge([vertices[k], vertices[j]], line, true), true)
            })
            .collect();
        self.bound(&edges)
    }

    fn read(&self) -> Outside {
        let data: String =
            self.0.iter().enumerate().map(|(k, e)| format!("#{}={e};\n", k + 1)).collect();
        let text = format!(
            "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('a','b',(''),(''),'c','d','');\n\
             FILE_SCHEMA(('CONFIG_CONTROL_DESIGN'));\nENDSEC;\nDATA;\n{data}ENDSEC;\nEND-ISO-10303-21;\n"
        );
        read(&text, &Limits::default()).expect("STEP").expect("surfaces")
    }
}

fn flag(b: bool) -> &'static str {
    if b { ".T." } else { ".F." }
}

/// Places all over the first surface, its corners among them.
fn places(file: &Outside) -> Vec<Vec3> {
    let s: Sculptured = fit_surface(&file.surfaces[0], 1.0).expect("a surface");
    let [nu, nv] = s.spans();
    let share = |k: i32| f64::from(k) / 12.0;
    (0..=12)
        .flat_map(|i| (0..=12).map(move |j| (i, j)))
        .map(|(i, j)| s.at(nu * share(i), nv * share(j)).point)
        .collect()
}

/// Least and greatest coordinates.
fn bounds(all: &[Vec3]) -> [Vec3; 2] {
    all.iter().fold([all[0], all[0]], |b, p| [b[0].inf(p), b[1].sup(p)])
}

fn near(a: Vec3, b: [f64; 3]) -> bool {
    (a - Vec3::from(b)).norm() < 1e-9
}

#[test]
fn a_plane_between_its_edges() {
    let mut step = Step::default();
    let frame = step.frame([1.0, 2.0, 3.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]);
    let plane = step.add(format!("PLANE('',#{frame})"));
    let z = 3.0;
    let around = step.polygon(&[[0.0, 0.0, z], [8.0, 0.0, z], [8.0, 5.0, z], [0.0, 5.0, z]]);
    step.face(&[around], plane);
    let file = step.read();
    assert!(file.notes.is_empty(), "{:?}", file.notes);
    let [low, high] = bounds(&places(&file));
    assert!(near(low, [0.0, 0.0, z]) && near(high, [8.0, 5.0, z]), "{low} {high}");
    // With a corner cut off it is told of, and all of the box is there.
    let mut step = Step(step.0[..plane].to_vec());
    let around = step.polygon(&[[0.0, 0.0, z], [8.0, 0.0, z], [8.0, 3.0, z], [0.0, 5.0, z]]);
    let cut = step.face(&[around], plane);
    let file = step.read();
    assert!(file.notes[0].contains(&format!("#{cut}")), "{:?}", file.notes);
    assert!(near(bounds(&places(&file))[1], [8.0, 5.0, z]));
}

/// Two circles about z with a seam between them, and the face.
fn ring(step: &mut Step, surface: usize, [r, h]: [f64; 2], [s, k]: [f64; 2], seam: bool) -> usize {
    let (z, x) = ([0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
    let (a, b) = (step.vertex([r, 0.0, h]), step.vertex([s, 0.0, k]));
    let (low, high) = (step.circle([0.0, 0.0, h], z, x, r), step.circle([0.0, 0.0, k], z, x, s));
    let (low, high) = (step.edge([a, a], low, true), step.edge([b, b], high, true));
    if !seam {
        let bounds = [step.bound(&[(low, true)]), step.bound(&[(high, false)])];
        return step.face(&bounds, surface);
    }
    let up = step.line([r, 0.0, h], [s, 0.0, k]);
    let up = step.edge([a, b], up, true);
    let bound = step.bound(&[(low, true), (up, true), (high, false), (up, false)]);
    step.face(&[bound], surface)
}

#[test]
fn cylinders_and_cones_all_round() {
    for seam in [true, false] {
        for slope in [0.0, 0.5] {
            let mut step = Step::default();
            let frame = step.frame([0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
            let surface = if slope == 0.0 {
                step.add(format!("CYLINDRICAL_SURFACE('',#{frame},5.)"))
            } else {
                let angle = aptc_geometry::trig::atan2(slope, 1.0);
                step.add(format!("CONICAL_SURFACE('',#{frame},5.,{angle:?})"))
            };
            let of = |z: f64| [5.0 + slope * z, z];
            ring(&mut step, surface, of(-2.0), of(4.0), seam);
            let file = step.read();
            assert!(file.notes.is_empty(), "{:?}", file.notes);
            let all = places(&file);
            assert!(all.iter().all(|p| (p.xy().norm() - 5.0 - slope * p.z).abs() < 1e-9));
            let [low, high] = bounds(&all);
            let r = 5.0 + slope * 4.0;
            assert!(near(low, [-r, -r, -2.0]) && near(high, [r, r, 4.0]), "{low} {high}");
        }
    }
}

#[test]
fn an_eighth_of_a_sphere_and_a_cap() {
    let mut step = Step::default();
    let (o, x, y, z) = ([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let frame = step.frame(o, z, x);
    let sphere = step.add(format!("SPHERICAL_SURFACE('',#{frame},4.)"));
    let ends = [[4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]].map(|p| step.vertex(p));
    let arcs = [(z, x), (x, y), (y, z)].map(|(n, from)| step.circle(o, n, from, 4.0));
    let edges = [0, 1, 2].map(|k| (step.edge([ends[k], ends[(k + 1) % 3]], arcs[k], true), true));
    // The loop may begin anywhere.
    for turn in 0..3 {
        let mut step = Step(step.0.clone());
        let around: Vec<_> = (0..3).map(|k| edges[(k + turn) % 3]).collect();
        let bound = step.bound(&around);
        step.face(&[bound], sphere);
        let file = step.read();
        assert!(file.notes.is_empty(), "{:?}", file.notes);
        let all = places(&file);
        assert!(all.iter().all(|p| (p.norm() - 4.0).abs() < 1e-9));
        let [low, high] = bounds(&all);
        assert!(near(low, [0.0; 3]) && near(high, [4.0; 3]), "{turn} {low} {high}");
    }
    // A cap within one circle: it is on its left.
    for up in [true, false] {
        let mut step = Step(step.0.clone());
        let (r, h) = (3.2, 2.4);
        let (v, arc) = (step.vertex([r, 0.0, h]), step.circle([0.0, 0.0, h], z, x, r));
        let edge = step.edge([v, v], arc, true);
        let bound = step.bound(&[(edge, up)]);
        step.face(&[bound], sphere);
        let [low, high] = bounds(&places(&step.read()));
        let (a, b) = if up { (h, 4.0) } else { (-4.0, h) };
        assert!((low.z - a).abs() < 1e-9 && (high.z - b).abs() < 1e-9, "{low} {high}");
    }
}

#[test]
fn a_torus_without_a_border() {
    let mut step = Step::default();
    let frame = step.frame([0.0, 0.0, 7.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
    let torus = step.add(format!("TOROIDAL_SURFACE('',#{frame},10.,3.)"));
    step.face(&[], torus);
    let all = places(&step.read());
    let off = |p: &Vec3| {
        let out = p.xy().norm() - 10.0;
        (out * out + (p.z - 7.0) * (p.z - 7.0)).sqrt() - 3.0
    };
    assert!(all.iter().all(|p| off(p).abs() < 1e-9));
    let [low, high] = bounds(&all);
    assert!(near(low, [-13.0, -13.0, 4.0]) && near(high, [13.0, 13.0, 10.0]));
}

#[test]
fn curves_that_are_turned_or_moved() {
    // An arc of radius 2 about (6, 0, 0), over its upper half, turned by a quarter about z, and moved along y.
    let mut step = Step::default();
    let (y, z, x) = ([0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
    let arc = step.circle([6.0, 0.0, 0.0], y, x, 2.0);
    let (p, d) = (step.point([0.0; 3]), step.direction(z));
    let axis = step.add(format!("AXIS1_PLACEMENT('',#{p},#{d})"));
    let turned = step.add(format!("SURFACE_OF_REVOLUTION('',#{arc},#{axis})"));
    let d = step.direction([0.0, 1.0, 0.0]);
    let v = step.add(format!("VECTOR('',#{d},2.)"));
    let moved = step.add(format!("SURFACE_OF_LINEAR_EXTRUSION('',#{arc},#{v})"));
    let here = [step.vertex([8.0, 0.0, 0.0]), step.vertex([4.0, 0.0, 0.0])];
    let first = step.edge(here, arc, true);
    for (surface, there, normal) in [
        (turned, [[0.0, 8.0, 0.0], [0.0, 4.0, 0.0]], [1.0, 0.0, 0.0]),
        (moved, [[8.0, 9.0, 0.0], [4.0, 9.0, 0.0]], [0.0, -1.0, 0.0]),
    ] {
        let mut step = Step(step.0.clone());
        let at = there.map(|p| step.vertex(p));
        let middle = [0, 1, 2].map(|i| 0.5 * (there[0][i] + there[1][i]));
        let from = [0, 1, 2].map(|i| 0.5 * (there[0][i] - there[1][i]));
        let arc = step.circle(middle, normal, from, 2.0);
        let last = step.edge(at, arc, true);
        let sides = [0, 1].map(|k| {
            let curve = if surface == turned {
                step.circle([0.0; 3], z, x, there[k][1])
            } else {
                step.line([there[k][0], 0.0, 0.0], there[k])
            };
            step.edge([here[k], at[k]], curve, true)
        });
        let bound =
            step.bound(&[(first, true), (sides[1], true), (last, false), (sides[0], false)]);
        step.face(&[bound], surface);
        let file = step.read();
        // The other one is bounded by no face.
        let other = if surface == turned { "LINEAR_EXTRUSION" } else { "REVOLUTION" };
        assert_eq!(file.notes, [format!("not read: 1 SURFACE_OF_{other}")]);
        let all = places(&file);
        let off = |p: &Vec3| {
            let out = if surface == turned { p.xy().norm() } else { p.x } - 6.0;
            (out * out + p.z * p.z).sqrt() - 2.0
        };
        assert!(all.iter().all(|p| off(p).abs() < 1e-9));
        let [low, high] = bounds(&all);
        let most = if surface == turned { [8.0, 8.0, 2.0] } else { [8.0, 9.0, 2.0] };
        assert!((low.z).abs() < 1e-9 && near(high, most), "{low} {high}");
    }
}
