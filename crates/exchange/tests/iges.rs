//! IGES against shapes that are known, and against files that are broken.

mod ig;
mod quarter;

use aptc_exchange::{Fault, Outside};
use aptc_geometry::sculpt::{Sculptured, fit_surface};
use aptc_geometry::{Vec3, trig};
use ig::iges;
use quarter::{W, all, fitted, is_quarter};

fn quarter(range: &str) -> String {
    let points = "5.,0.,0.,5.,5.,0.,0.,5.,0.,5.,0.,8.,5.,5.,8.,0.,5.,8.";
    format!(
        "2,1,2,1,0,0,0,0,0,0.,0.,0.,1.,1.,1.,0.,0.,1.,1.,1.,{W},1.,1.D0,{W},1.,{points},{range},0.,1."
    )
}

#[test]
fn iges_of_type_128() {
    let file = all(&iges(2, &[(128, 0, quarter("0.,1."))])).unwrap();
    assert_eq!(file.unit_mm, Some(1.0));
    is_quarter(&fitted(&file), 5.0, 8.0);
    // Its matrix moves it; a part of its range is a part of it.
    let matrix = "1.,0.,0.,100.,0.,1.,0.,0.,0.,0.,1.,7.";
    let moved = [(124, 0, matrix.to_owned()), (128, 1, quarter("0.,.5"))];
    let p = fitted(&all(&iges(1, &moved)).unwrap()).at(1.0, 0.0).point;
    let w = 0.5_f64.sqrt() * 5.0;
    assert!((p - Vec3::new(100.0 + w, w, 7.0)).norm() < 1e-12, "{p}");
}

#[test]
fn iges_of_type_114() {
    // z = 1 + 2 s + s t^3 over 0..2 by 1..2, s and t from the corner; x and y are s and 10 + t.
    let mut c = [[0.0; 16]; 3];
    (c[0][1], c[1][0], c[1][4]) = (1.0, 10.0, 1.0);
    (c[2][0], c[2][1], c[2][13]) = (1.0, 2.0, 1.0);
    let list = |c: &[f64]| c.iter().map(|x| format!("{x:?},")).collect::<String>();
    let nothing = list(&[0.0; 48]);
    let text = format!("3,1,1,1,0.,2.,1.,2.,{}{nothing}{nothing}0.", list(&c.concat()));
    let s = fitted(&all(&iges(2, &[(114, 0, text)])).unwrap());
    for (u, v) in [(0.0, 0.0), (1.0, 1.0), (0.3, 0.6)] {
        let (x, t) = (2.0 * u, v);
        let q = Vec3::new(x, 10.0 + t, 1.0 + 2.0 * x + x * t * t * t);
        assert!((s.at(u, v).point - q).norm() < 1e-13);
    }
}

#[test]
fn what_is_broken_is_refused() {
    let refused = |entities: &[(u32, usize, String)]| all(&iges(2, entities)).unwrap_err();
    let good = (128, 0, quarter("0.,1."));
    // A trimmed surface of none, and one whose border is none.
    let why = refused(&[good.clone(), (144, 0, "9,0,0,0".into())]);
    assert!(why.to_string().contains("is of no surface"), "{why}");
    let file = all(&iges(2, &[good.clone(), (144, 0, "1,1,0,1".into())])).unwrap();
    assert_eq!(file.surfaces.len(), 1);
    assert!(file.notes[0].contains("the border is not read"), "{:?}", file.notes);
    let why = refused(&[(120, 0, "1,3,0.,1.".into())]).to_string();
    assert!(why.contains("1 of type 120 (surface of revolution)"), "{why}");
    let note = all(&iges(2, &[good.clone(), (120, 0, "1,3,0.,1.".into())])).unwrap().notes;
    assert_eq!(note, ["not read: 1 of type 120 (surface of revolution)"]);
    // A composite curve of itself ends.
    let around = [(122, 0, "3,0.,0.,1.".to_owned()), (102, 0, "1,3".to_owned())];
    assert!(matches!(refused(&around), Fault::TooLarge(_)));
    for text in ["2,1,2", "2,1,2,x", "999999999,9,3,3,0,0,0,0,0", "-1,1,2,1,0,0,0,0,0"] {
        assert!(matches!(
            refused(&[(128, 0, text.into())]),
            Fault::Broken { .. } | Fault::TooLarge(_)
        ));
    }
    // Weights of 0, as STEP says it.
    let flat = (128, 0, quarter("0.,1.").replace("1.D0", "0."));
    for more in [vec![], vec![of(144, "1,0,0,0")]] {
        let why = refused(&[vec![flat.clone()], more].concat()).to_string();
        assert!(why.ends_with("entity 128 is no surface: a control point is not finite, or a weight is not above zero"), "{why}");
    }
    // A matrix that refers to itself ends.
    let around = (124, 1, "1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,0.".to_owned());
    assert!(matches!(refused(&[around, (128, 1, quarter("0.,1."))]), Fault::TooLarge(_)));
}

/// The surfaces of a file that has nothing to tell.
fn silent(entities: &[(u32, usize, String)]) -> Vec<Sculptured> {
    let file = all(&iges(2, entities)).expect("a file");
    assert!(file.notes.is_empty(), "{:?}", file.notes);
    file.surfaces.iter().map(|s| fit_surface(s).expect("a surface")).collect()
}

fn line(a: [f64; 3], b: [f64; 3]) -> (u32, usize, String) {
    let [[x, y, z], [u, v, w]] = [a, b];
    (110, 0, format!("{x:?},{y:?},{z:?},{u:?},{v:?},{w:?}"))
}

/// About the point (0, 0, z), from one angle to another, degrees.
fn arc(z: f64, r: f64, from: f64, to: f64) -> (u32, usize, String) {
    let at = |a: f64| format!("{:?},{:?}", r * trig::cos_deg(a), r * trig::sin_deg(a));
    (100, 0, format!("{z:?},0.,0.,{},{}", at(from), at(to)))
}

fn of(kind: u32, text: &str) -> (u32, usize, String) {
    (kind, 0, text.to_owned())
}

/// The corners and the middle of a surface.
fn corners(s: &Sculptured) -> [Vec3; 4] {
    let [nu, nv] = s.spans();
    [[0.0, 0.0], [nu, 0.0], [0.0, nv], [nu, nv]].map(|[u, v]| s.at(u, v).point)
}

fn near(a: Vec3, b: [f64; 3]) {
    assert!((a - Vec3::from(b)).norm() < 1e-12, "{a} {b:?}");
}

/// Ruled surfaces of lines, of arcs and of a B-spline; turned round, and by length where that is not the parameter.
#[test]
fn iges_of_type_118() {
    let lines = [line([0.0; 3], [10.0, 0.0, 0.0]), line([0.0, 5.0, 2.0], [10.0, 5.0, 6.0])];
    let with = |two: &[(u32, usize, String)], kind: u32, text: &str| {
        let mut all = two.to_vec();
        all.push(of(kind, text));
        silent(&all).remove(0)
    };
    for kind in [118, 1118] {
        let s = with(&lines, kind, "1,3,0,0");
        near(s.at(0.5, 0.5).point, [5.0, 2.5, 2.0]);
        near(s.at(0.25, 1.0).point, [2.5, 5.0, 3.0]);
    }
    // The other curve from its end to its beginning.
    near(with(&lines, 118, "1,3,1,0").at(0.0, 1.0).point, [10.0, 5.0, 6.0]);
    // Between two arcs of the same angle: a cone, exactly.
    let s = with(&[arc(0.0, 5.0, 20.0, 170.0), arc(3.0, 8.0, 20.0, 170.0)], 118, "1,3,0,1");
    let [nu, nv] = s.spans();
    for k in 0..=20 {
        let p = s.at(nu * f64::from(k) / 20.0, nv * 0.3).point;
        assert!((p.xy().norm() - 5.9).abs() < 1e-12 && (p.z - 0.9).abs() < 1e-12, "{p}");
    }
    // Between an arc and a line by length: the ruling at a third of both joins their places there.
    let s =
        with(&[arc(0.0, 6.0, 0.0, 90.0), line([9.0, 0.0, 4.0], [0.0, 9.0, 4.0])], 118, "1,3,0,0");
    let [nu, nv] = s.spans();
    for k in 0..=12 {
        let share = f64::from(k) / 12.0;
        let a = 90.0 * share;
        let (p, q) = (s.at(nu * share, 0.0).point, s.at(nu * share, nv).point);
        assert!(
            (p - Vec3::new(6.0 * trig::cos_deg(a), 6.0 * trig::sin_deg(a), 0.0)).norm() < 1e-4,
            "{share} {p}"
        );
        assert!((q - Vec3::new(9.0 - 9.0 * share, 9.0 * share, 4.0)).norm() < 1e-4, "{share} {q}");
    }
    // By the parameter of a B-spline with a knot within, and a line.
    let spline = "3,2,0,0,1,0,0.,0.,0.,.25,1.,1.,1.,1.,1.,1.,1.,0.,0.,0.,1.,2.,0.,3.,2.,1.,4.,0.,0.,0.,1.,0.,0.,1.";
    let s = with(&[of(126, spline), line([0.0, 0.0, 9.0], [4.0, 0.0, 9.0])], 1118, "1,3,0,1");
    near(corners(&s)[1], [4.0, 0.0, 0.0]);
    // The knot at a quarter is a border of patches, and lies at a quarter of the line.
    let borders: Vec<f64> = (0..=40).map(|k| s.at(f64::from(k) / 20.0, 1.0).point.x).collect();
    assert!(borders.iter().any(|x| (x - 1.0).abs() < 1e-12), "{borders:?}");
}

/// A line turned about z: u along the line, v the angle; a part of a sphere from an arc, within its matrix.
#[test]
fn iges_of_type_120() {
    let axis = line([0.0; 3], [0.0, 0.0, 1.0]);
    let side = line([5.0, 0.0, 0.0], [5.0, 0.0, 8.0]);
    let quarter = core::f64::consts::FRAC_PI_2;
    let s = silent(&[axis.clone(), side, (120, 0, format!("1,3,0.,{quarter:?}"))]).remove(0);
    near(s.at(1.0, 0.0).point, [5.0, 0.0, 8.0]);
    near(s.at(0.0, 1.0).point, [0.0, 5.0, 0.0]);
    let n = s.at(0.5, 0.3).normal().unwrap();
    let p = s.at(0.5, 0.3).point;
    // u across v: up the line, across the way round.
    assert!((n + Vec3::new(p.x, p.y, 0.0) / 5.0).norm() < 1e-12, "{n} {p}");
    // An arc in the plane y = 0 by a matrix: x to x, y to z.
    let matrix = of(124, "1.,0.,0.,0.,0.,0.,-1.,0.,0.,1.,0.,0.");
    let mut half = arc(0.0, 4.0, 0.0, 60.0);
    half.1 = 1;
    let s =
        silent(&[matrix, line([0.0; 3], [0.0, 0.0, 2.0]), half, of(120, "3,5,0.,1.")]).remove(0);
    let [nu, nv] = s.spans();
    for k in 0..=10 {
        let p = s.at(nu * f64::from(k) / 10.0, nv * 0.7).point;
        assert!((p.norm() - 4.0).abs() < 1e-12, "{p}");
    }
    assert!((corners(&s)[1].z - 4.0 * trig::sin_deg(60.0)).abs() < 1e-12);
}

/// An arc moved along a vector.
#[test]
fn iges_of_type_122() {
    let s = silent(&[arc(1.0, 5.0, 0.0, 90.0), of(122, "1,5.,0.,9.")]).remove(0);
    for k in 0..=8 {
        let p = s.at(f64::from(k) / 8.0, 0.5).point;
        assert!((p.xy().norm() - 5.0).abs() < 1e-12 && (p.z - 5.0).abs() < 1e-12, "{p}");
    }
}

/// A cylinder all round that a trimmed surface cuts to a part of its angle and height, by its curves in space.
#[test]
fn iges_that_is_trimmed_in_space() {
    let axis = line([0.0; 3], [0.0, 0.0, 1.0]);
    let side = line([5.0, 0.0, 0.0], [5.0, 0.0, 20.0]);
    let round = of(120, "1,3,0.,6.283185307179586");
    let at = |deg: f64, z: f64| [5.0 * trig::cos_deg(deg), 5.0 * trig::sin_deg(deg), z];
    // Across the beginning of the angle, from 300 to 400 degrees and from 4 to 9.
    let up = line(at(40.0, 4.0), at(40.0, 9.0));
    let down = line(at(300.0, 9.0), at(300.0, 4.0));
    let mut back = arc(9.0, 5.0, 300.0, 40.0);
    let parts = [axis, side, round, arc(4.0, 5.0, 300.0, 40.0), up, down];
    let cut = |back: (u32, usize, String), tail: &[(u32, usize, String)]| {
        let mut all = parts.to_vec();
        all.push(back);
        all.extend(tail.iter().cloned());
        all
    };
    let composite = of(102, "4,7,9,13,11");
    let of_144 = [composite.clone(), of(142, "1,5,0,15,2"), of(144, "5,1,0,17")];
    // The way back is an arc the other way round: its ends in the file are as they are, so it is turned by 141.
    let check = |s: &Sculptured| {
        let [nu, nv] = s.spans();
        for k in 0..=10 {
            let share = f64::from(k) / 10.0;
            let p = s.at(nu * share, nv * 0.5).point;
            assert!((p.xy().norm() - 5.0).abs() < 1e-12 && (p.z - 4.0 - 5.0 * share).abs() < 1e-9);
        }
        for (place, corner) in corners(s).iter().zip([(300.0, 4.0), (300.0, 9.0), (40.0, 4.0)]) {
            let q = Vec3::from(at(corner.0, corner.1));
            assert!((place - q).norm() < 1e-6, "{place} {q}");
        }
    };
    let by_141 = [of(141, "0,1,5,4,7,1,0,9,1,0,13,2,0,11,1,0"), of(143, "0,5,1,15")];
    check(&silent(&cut(back.clone(), &by_141)).remove(0));
    // A half turn about the x axis makes the way back go backwards: z = 9 becomes what 141 had turned.
    back = of(126, "");
    let w = trig::cos_deg(50.0);
    let (a, b) = (at(40.0, 9.0), at(300.0, 9.0));
    let middle = [5.0 / w * trig::cos_deg(350.0), 5.0 / w * trig::sin_deg(350.0), 9.0];
    let text =
        [a, middle, b].concat().iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(",");
    back.2 = format!("2,2,0,0,0,0,0.,0.,0.,1.,1.,1.,1.,{w:?},1.,{text},0.,1.,0.,0.,1.");
    check(&silent(&cut(back, &of_144)).remove(0));
}

/// By the curves of its parameters, where the file has no others: a box, a hole, and a corner cut off.
#[test]
fn iges_that_is_trimmed_by_parameters() {
    let polygon = |corners: &[[f64; 2]]| {
        let all: Vec<String> =
            corners.iter().chain(&corners[..1]).map(|[u, v]| format!("{u:?},{v:?}")).collect();
        of(11106, &format!("1,{},0.,{}", all.len(), all.join(",")))
    };
    let plain = of(128, &quarter("0.,1."));
    let square = polygon(&[[0.25, 0.5], [1.0, 0.5], [1.0, 0.75], [0.25, 0.75]]);
    let with = |loops: &[(u32, usize, String)], text: &str| {
        let mut all = vec![plain.clone()];
        for one in loops {
            let at = 2 * all.len() + 1;
            all.push(one.clone());
            all.push(of(142, &format!("1,1,{at},0,1")));
        }
        all.push(of(144, text));
        all
    };
    let s = silent(&with(std::slice::from_ref(&square), "1,1,0,5")).remove(0);
    let whole = silent(std::slice::from_ref(&plain)).remove(0);
    for (u, v) in [(0.0, 0.0), (1.0, 0.0), (0.3, 0.9)] {
        let same = whole.at(0.25 + 0.75 * u, 0.5 + 0.25 * v).point;
        assert!((s.at(u, v).point - same).norm() < 1e-12, "{u} {v}");
    }
    let told = |entities: &[(u32, usize, String)]| {
        let file = all(&iges(2, entities)).unwrap();
        assert_eq!(file.surfaces.len(), 1);
        file.notes
    };
    let hole = polygon(&[[0.4, 0.55], [0.6, 0.55], [0.5, 0.6]]);
    let notes = told(&with(&[square, hole.clone()], "1,1,1,5,9"));
    assert!(notes.len() == 1 && notes[0].contains("not a box"), "{notes:?}");
    let corner = polygon(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]);
    let notes = told(&with(&[corner], "1,1,0,5"));
    assert!(notes.len() == 1 && notes[0].contains("not a box"), "{notes:?}");
    // The border of the surface itself, without and with a hole.
    assert!(told(&[plain.clone(), of(144, "1,0,0,0")]).is_empty());
    let notes = told(&with(&[hole], "1,0,1,0,5"));
    assert!(notes.len() == 1 && notes[0].contains("not a box"), "{notes:?}");
}

/// A plane is what its border leaves of it; alone it is none.
#[test]
fn iges_of_a_trimmed_plane() {
    let corners = [[1.0, 2.0], [4.0, 2.0], [4.0, 3.0], [1.0, 3.0]];
    let edge = |k: usize| {
        let ([a, b], [c, d]) = (corners[k], corners[(k + 1) % 4]);
        line([a, b, 7.0], [c, d, 7.0])
    };
    let mut all = vec![of(108, "0.,0.,1.,7.,0,0.,0.,0.,0.")];
    all.extend((0..4).map(edge));
    all.extend([of(102, "4,3,5,7,9"), of(142, "1,1,0,11,2"), of(144, "1,1,0,13")]);
    let s = silent(&all).remove(0);
    for [x, y] in corners {
        let far = |p: &Vec3| (p - Vec3::new(x, y, 7.0)).norm();
        assert!(least(&self::corners(&s).map(|p| far(&p))) < 1e-9);
    }
    let note = self::all(&iges(2, &[of(128, &quarter("0.,1.")), all[0].clone()])).unwrap().notes;
    assert_eq!(note, ["not read: 1 of type 108 (plane)"]);
}

fn least(all: &[f64]) -> f64 {
    all.iter().copied().fold(f64::INFINITY, f64::min)
}

/// A cube of 50 with one edge rounded by 15: six sides and the round, two of the sides cut by it.
#[test]
fn a_rounded_cube_of_another_program() {
    let name = "surfaces/test_data-single_rounded_cube.iges";
    let Some(path) = aptc_testkit::shared("a_rounded_cube", &format!("corpus/{name}")) else {
        return;
    };
    let text = std::fs::read_to_string(path).expect("the file");
    let file = all(&text).unwrap();
    assert_eq!(file.surfaces.len(), 7, "{:?}", file.notes);
    assert!(file.notes.len() == 1 && file.notes[0].contains("not a box"), "{:?}", file.notes);
    let mut round = 0;
    for d in &file.surfaces {
        let s = fit_surface(d).expect("a surface");
        for p in corners(&s) {
            // All corners are those of the cube or of the round.
            let on = |x: f64| [-25.0, -10.0, 10.0, 25.0].iter().any(|y| (x - y).abs() < 1e-6);
            assert!(p.iter().all(|x| on(*x)), "{p}");
        }
        let [nu, nv] = s.spans();
        let p = s.at(0.37 * nu, 0.61 * nv).point;
        let far = ((p.x + 10.0).powi(2) + (p.z - 10.0).powi(2)).sqrt();
        let flat = p.iter().any(|x| (x.abs() - 25.0).abs() < 1e-6);
        if !flat {
            assert!((far - 15.0).abs() < 1e-6, "{p}");
            round += 1;
        }
    }
    assert_eq!(round, 1);
}

/// A sphere of 4 turned up to an angle, and the part of it between the meridians at two angles: the first curve up, the second
/// down, or both the other way; with or without the same border in the parameters. Angles in degrees.
fn lune(up_to: f64, [a, b]: [f64; 2], backwards: bool, flat: bool) -> Outside {
    let meridian = |deg: f64| {
        let (s, c) = (trig::sin_deg(deg), trig::cos_deg(deg));
        of(124, &format!("{c:?},0.,{s:?},0.,{s:?},0.,{:?},0.,0.,1.,0.,0.", -c))
    };
    let half = |matrix: usize| {
        let mut half = arc(0.0, 4.0, -90.0, 90.0);
        half.1 = matrix;
        half
    };
    let rad = |deg: f64| deg * core::f64::consts::PI / 180.0;
    // The arc's parameter is its angle, from 270 degrees on.
    let side = |deg: f64, up: bool| {
        let mut ends = [[rad(270.0), rad(deg), 0.0], [rad(450.0), rad(deg), 0.0]];
        if !up {
            ends.reverse();
        }
        line(ends[0], ends[1])
    };
    let (up, down) = if backwards { (2, 1) } else { (1, 2) };
    let with = |at: usize| if flat { format!("1,{at}") } else { "0".into() };
    let mut all = vec![
        meridian(0.0),
        line([0.0; 3], [0.0, 0.0, 1.0]),
        half(1),
        (120, 0, format!("3,5,0.,{:?}", rad(up_to))),
        meridian(a),
        half(9),
        meridian(b),
        half(13),
        side(a, !backwards),
        side(b, backwards),
    ];
    all.push(of(141, &format!("1,1,7,2,11,{up},{},15,{down},{}", with(17), with(19))));
    all.push(of(143, "1,7,1,21"));
    self::all(&iges(2, &all)).expect("a file")
}

/// Angles about z at the first, middle and last places of the equator, each following the one before.
fn angles(file: &Outside) -> [f64; 3] {
    let s = fitted(file);
    let [nu, nv] = s.spans();
    let at = |share: f64| {
        let p = s.at(0.5 * nu, share * nv).point;
        assert!(p.z.abs() < 1e-9 && (p.norm() - 4.0).abs() < 1e-9, "{p}");
        trig::atan2(p.y, p.x).to_degrees().rem_euclid(360.0)
    };
    let first = at(0.0);
    let behind = |before: f64, x: f64| if x < before { x + 360.0 } else { x };
    let middle = behind(first, at(0.5));
    [first, middle, behind(middle, at(1.0))]
}

/// Meridians through both poles bound two parts of a sphere. Which it is say the surface's own range, the curves of the
/// parameters, or else the sense of the border, which is told.
#[test]
fn iges_between_meridians() {
    let is = |file: &Outside, [a, b]: [f64; 2], notes: usize| {
        let found = angles(file);
        for (x, y) in found.iter().zip([a, 0.5 * (a + b), b]) {
            assert!((x - y).abs() < 1e-6, "{found:?} {a} {b}");
        }
        assert_eq!(file.notes.len(), notes, "{:?}", file.notes);
    };
    for (a, b) in [(10.0, 260.0), (20.0, 200.0), (40.0, 90.0)] {
        for backwards in [false, true] {
            is(&lune(270.0, [a, b], backwards, false), [a, b], 0);
            is(&lune(360.0, [a, b], backwards, true), [a, b], 0);
        }
        is(&lune(360.0, [a, b], false, false), [a, b], 1);
        is(&lune(360.0, [a, b], true, false), [b, a + 360.0], 1);
    }
}

/// A cylinder that is cut along two rings without a seam, whichever way they run, and along one of them alone.
#[test]
fn iges_between_rings() {
    let base = [
        line([0.0; 3], [0.0, 0.0, 1.0]),
        line([5.0, 0.0, 0.0], [5.0, 0.0, 20.0]),
        of(120, "1,3,0.,6.283185307179586"),
        arc(4.0, 5.0, 70.0, 430.0),
        arc(9.0, 5.0, 70.0, 430.0),
    ];
    for senses in [[1, 1], [1, 2], [2, 1], [2, 2]] {
        let mut all = base.to_vec();
        for (at, sense) in [7, 9].iter().zip(senses) {
            all.push(of(141, &format!("0,1,5,1,{at},{sense},0")));
        }
        all.push(of(143, "0,5,2,11,13"));
        let s = silent(&all).remove(0);
        let heights = corners(&s).map(|p| p.z);
        let range = [least(&heights), -least(&heights.map(|z| -z))];
        assert!((range[0] - 4.0).abs() < 1e-9 && (range[1] - 9.0).abs() < 1e-9, "{range:?}");
    }
    // Above or below it: the sense is followed, and told.
    let mut heights = [1, 2].map(|sense| {
        let mut all = base.to_vec();
        all.push(of(141, &format!("0,1,5,1,7,{sense},0")));
        all.push(of(143, "0,5,1,11"));
        let file = self::all(&iges(2, &all)).unwrap();
        assert!(file.notes.len() == 1 && file.notes[0].contains("not a box"), "{:?}", file.notes);
        let heights = corners(&fitted(&file)).map(|p| p.z);
        [least(&heights), -least(&heights.map(|z| -z))]
    });
    heights.sort_by(|a, b| a[0].total_cmp(&b[0]));
    for (x, y) in heights.concat().iter().zip([0.0, 4.0, 4.0, 20.0]) {
        assert!((x - y).abs() < 1e-9, "{heights:?}");
    }
}

/// The cap of a whole sphere above 30 degrees, with a seam up to the pole and back, whichever way it runs: nothing to tell.
#[test]
fn the_cap_of_a_sphere_of_iges() {
    let level = |deg: f64| {
        let at = 4.0 * trig::sin_deg(deg);
        arc(at, 4.0 * trig::cos_deg(deg), 0.0, 360.0)
    };
    let matrix = of(124, "1.,0.,0.,0.,0.,0.,-1.,0.,0.,1.,0.,0.");
    let half = |from: f64| {
        let mut half = arc(0.0, 4.0, from, 90.0);
        half.1 = 1;
        half
    };
    let axis = line([0.0; 3], [0.0, 0.0, 1.0]);
    let base =
        [matrix, axis, half(-90.0), of(120, "3,5,0.,6.283185307179586"), level(30.0), half(30.0)];
    for edges in ["9,1,0,11,1,0,11,2,0", "11,1,0,11,2,0,9,2,0"] {
        let mut all = base.to_vec();
        all.push(of(141, &format!("0,1,7,3,{edges}")));
        all.push(of(143, "0,7,1,13"));
        let s = silent(&all).remove(0);
        let [nu, nv] = s.spans();
        for k in 0..=10 {
            let p = s.at(nu * f64::from(k) / 10.0, 0.3 * nv).point;
            assert!((p.norm() - 4.0).abs() < 1e-9 && p.z > 2.0 - 1e-9, "{p}");
        }
        let heights = corners(&s).map(|p| p.z);
        assert!((least(&heights) - 2.0).abs() < 1e-9, "{heights:?}");
        assert!((-least(&heights.map(|z| -z)) - 4.0).abs() < 1e-9, "{heights:?}");
    }
}

/// The box of a disk in the parameters is that of the disk, not that of places along it; so is that of an arc in space.
#[test]
fn the_box_of_a_round_border_of_iges() {
    let plain = of(128, &quarter("0.,1."));
    let round = |kind: u32, at: [f64; 3], r: f64| {
        let [x, y, z] = at;
        let (s, c) = (r * trig::sin_deg(11.25), r * trig::cos_deg(11.25));
        let end = format!("{:?},{:?}", x + c, y + s);
        (kind, 0, format!("{z:?},{x:?},{y:?},{end},{end}"))
    };
    let size = |entities: &[(u32, usize, String)]| {
        let file = all(&iges(2, entities)).unwrap();
        assert!(file.notes.len() == 1 && file.notes[0].contains("not a box"), "{:?}", file.notes);
        corners(&fitted(&file))
    };
    // Over v, .125 to .625 of a height of 8.
    let flat =
        [plain, round(100, [0.5, 0.375, 0.0], 0.25), of(142, "1,1,3,0,1"), of(144, "1,1,0,5")];
    let heights = size(&flat).map(|p| p.z);
    assert!((least(&heights) - 1.0).abs() < 1e-9, "{heights:?}");
    assert!((-least(&heights.map(|z| -z)) - 5.0).abs() < 1e-9, "{heights:?}");
    let plane = of(108, "0.,0.,1.,7.,0,0.,0.,0.,0.");
    let space =
        [plane, round(100, [300.0, 200.0, 7.0], 100.0), of(142, "1,1,0,3,2"), of(144, "1,1,0,5")];
    let all = size(&space);
    let side = (all[1] - all[0]).norm();
    assert!((side - 200.0).abs() < 1e-6, "{all:?}");
}

/// What is an IGES file by its lines or its name is told as one that is broken, with the line.
#[test]
fn lines_that_are_broken_are_told() {
    let good = iges(2, &[(128, 0, quarter("0.,1."))]);
    let why = |text: &str| all(text).unwrap_err().to_string();
    is_quarter(&fitted(&all(&good.replace('\n', "\r\n")).unwrap()), 5.0, 8.0);
    // Without numbers behind the letters.
    let bare: String = good.lines().map(|l| format!("{}\n", &l[..73])).collect();
    is_quarter(&fitted(&all(&bare).unwrap()), 5.0, 8.0);
    // Blanks at the left, or all that are many, are lost.
    let left: String = good.lines().map(|l| format!("{}\n", l.trim_start())).collect();
    assert!(why(&left).contains("stands in column"), "{}", why(&left));
    let narrow: String =
        good.lines().map(|l| l.split_whitespace().collect::<Vec<_>>().join(" ") + "\n").collect();
    assert!(why(&narrow).starts_with(
        "line 1: neither S, G, D, P nor T stands in column 73; S stands in column 16"
    ));
    // A line of parameters or of the directory is lost.
    for (mark, says) in [
        ("P      2", "it is line 3 of section P, and line 2 is due"),
        ("D      1", "it is line 2 of section D, and line 1 is due"),
    ] {
        let lost: String =
            good.lines().filter(|l| !l.ends_with(mark)).map(|l| format!("{l}\n")).collect();
        assert!(why(&lost).ends_with(says), "{}", why(&lost));
    }
    // By its name alone, and in another form.
    let limits = aptc_exchange::Limits::default();
    let named = |text: &str| {
        let found = aptc_exchange::read_named("A.IGS", text, &limits).expect("IGES by its name");
        found.unwrap_err().to_string()
    };
    assert!(named("HELLO\n").starts_with("line 1: neither S"));
    assert!(named("").contains("global section"));
    let compressed = format!("{:<72}C{:>7}\n", "", 1);
    assert!(named(&compressed).contains("compressed"));
    assert!(aptc_exchange::read_named("A.apt", "GOTO/1,2,3\n", &limits).is_none());
}

/// A model at half its size is read at its own.
#[test]
fn the_scale_of_a_model_is_regarded() {
    let good = iges(2, &[(128, 0, quarter("0.,1."))]);
    let half = good.replace("4Htest,1.,2,2HMM", "4Htest,.5,2,2HMM");
    assert_ne!(good, half);
    let file = all(&half).unwrap();
    assert_eq!(file.unit_mm, Some(2.0));
    assert_eq!(file.notes, ["its model has the scale 0.5, which is regarded"]);
}
