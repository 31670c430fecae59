//! Faces of STEP as patches of their surfaces, by closed forms.

mod maker;

use aptc_geometry::Vec3;
use maker::{Step, bounds, near, places};

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
        let mut around = [(first, true), (sides[1], true), (last, false), (sides[0], false)];
        // The normal of what is turned looks outwards, of what is moved inwards; the face is on the left of its border.
        if surface == turned {
            around.reverse();
            around.iter_mut().for_each(|(_, along)| *along = !*along);
        }
        let bound = step.bound(&around);
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

/// A cone of 45 degrees, whatever the entities that tell what a degree is.
#[test]
fn angles_in_degrees() {
    let degree = "PLANE_ANGLE_MEASURE(0.017453292519943295)";
    for measure in ["PLANE_ANGLE_MEASURE_WITH_UNIT()MEASURE_WITH_UNIT", "MEASURE_WITH_UNIT"] {
        let mut step = Step::default();
        let mm = step.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))".into());
        let radian = step.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))".into());
        let measure = step.add(format!("({measure}({degree},#{radian}))"));
        let unit = step.add(format!(
            "(CONVERSION_BASED_UNIT('DEGREE',#{measure})NAMED_UNIT(*)PLANE_ANGLE_UNIT())"
        ));
        step.add(format!(
            "(GLOBAL_UNIT_ASSIGNED_CONTEXT((#{mm},#{unit}))REPRESENTATION_CONTEXT('',''))"
        ));
        let frame = step.frame([0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
        let cone = step.add(format!("CONICAL_SURFACE('',#{frame},5.,45.)"));
        ring(&mut step, cone, [5.0, 0.0], [9.0, 4.0], true);
        let file = step.read();
        assert!(file.notes.is_empty(), "{:?}", file.notes);
        let [low, high] = bounds(&places(&file));
        assert!(near(low, [-9.0, -9.0, 0.0]) && near(high, [9.0, 9.0, 4.0]), "{low} {high}");
    }
}

/// Places of a border follow each other also on a surface of many pieces whose boxes overlap: to look through all of them for each
/// place took seconds.
#[test]
fn a_face_of_a_high_degree() {
    let mut step = Step::default();
    // Half of x + y runs evenly along u, half of x - y along v, and z waves with u.
    let at = |k: f64, y: f64, z: f64| [k + y, k - y, z];
    let row = |step: &mut Step, y: f64| {
        let point = |k: i32| at(f64::from(k), y, if k % 2 == 0 { 0.1 } else { -0.1 });
        (0..=14).map(|k| format!("#{}", step.point(point(k)))).collect::<Vec<_>>()
    };
    let (low, high) = (row(&mut step, 0.0), row(&mut step, 10.0));
    let net: Vec<String> = low.iter().zip(&high).map(|(a, b)| format!("({a},{b})")).collect();
    let kind = ".UNSPECIFIED.,.F.,.F.";
    let surface = step.add(format!("BEZIER_SURFACE('',14,1,({}),{kind},.F.)", net.join(",")));
    let sides = [2.5, 7.5].map(|y| {
        let points = row(&mut step, y).join(",");
        step.add(format!("BEZIER_CURVE('',14,({points}),{kind})"))
    });
    let corners = [at(0.0, 2.5, 0.1), at(14.0, 2.5, 0.1), at(14.0, 7.5, 0.1), at(0.0, 7.5, 0.1)];
    let vertices = corners.map(|p| step.vertex(p));
    let ends = [step.line(corners[1], corners[2]), step.line(corners[0], corners[3])];
    let edges = [
        (step.edge([vertices[0], vertices[1]], sides[0], true), true),
        (step.edge([vertices[1], vertices[2]], ends[0], true), true),
        (step.edge([vertices[3], vertices[2]], sides[1], true), false),
        (step.edge([vertices[0], vertices[3]], ends[1], true), false),
    ];
    let bound = step.bound(&edges);
    for _ in 0..40 {
        step.face(&[bound], surface);
    }
    let began = std::time::Instant::now();
    let file = step.read();
    // A fortieth of that as a rule.
    assert!(began.elapsed().as_secs() < 4);
    assert_eq!(file.surfaces.len(), 40);
    assert!(file.notes.len() == 1 && file.notes[0].contains("degree"), "{:?}", file.notes);
    let own: Vec<Vec3> = places(&file)
        .iter()
        .map(|p| Vec3::new(0.5 * (p.x + p.y), 0.5 * (p.x - p.y), p.z))
        .collect();
    let [low, high] = bounds(&own);
    for (a, b) in [(low, [0.0, 2.5]), (high, [14.0, 7.5])] {
        assert!((a.x - b[0]).abs() < 1e-6 && (a.y - b[1]).abs() < 1e-6, "{low} {high}");
    }
}
