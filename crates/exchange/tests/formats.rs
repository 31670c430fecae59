//! Each format against shapes that are known, and against files that are broken.

mod quarter;

use aptc_exchange::{Fault, Limits, read};
use aptc_geometry::Vec3;
use quarter::{W, all, fitted, is_quarter};

#[test]
fn json_is_read_or_refused() {
    let text = |weights: &str| {
        format!(
            r#"{{"unit": "inch", "surfaces": [{{"degree": [2, 1],
            "knots": [[0, 0, 0, 1, 1, 1], [0, 0, 1, 1]],
            "points": [[[5, 0, 0], [5, 5, 0], [0, 5, 0]], [[5, 0, 8], [5, 5, 8], [0, 5, 8]]],
            "weights": {weights}}}]}}"#
        )
    };
    let file = all(&text(&format!("[[1, {W}, 1], [1, {W}, 1]]"))).unwrap();
    assert_eq!(file.unit_mm, Some(25.4));
    is_quarter(&fitted(&file), 5.0, 8.0);
    for (weights, says) in [
        ("[[1, 1], [1, 1]]", "differ in length"),
        ("[[1, 0, 1], [1, 1, 1]]", "not above zero"),
        ("[[1, 1, 1], [1, 1, 1]], \"weight\": 1", "unknown field"),
        ("[[1, 1, 1], [1, 1, ", "expected value"),
    ] {
        let why = all(&text(weights)).unwrap_err().to_string();
        assert!(why.contains(says), "{why}");
    }
    let trimmed = r#"{"shape": {"type": "surface", "data": [{"degree_u": 1, "degree_v": 1,
        "knotvector_u": [0, 0, 1, 1], "knotvector_v": [0, 0, 1, 1], "size_u": 2, "size_v": 2,
        "control_points": {"points": [[0, 0, 0], [0, 3, 0], [4, 0, 0], [4, 3, 1]]}, "trims": {"count": N}}]}}"#;
    let made = fitted(&all(&trimmed.replace('N', "0")).unwrap());
    assert!((made.at(1.0, 0.0).point - Vec3::new(4.0, 0.0, 0.0)).norm() < 1e-15);
    assert!(matches!(all(&trimmed.replace('N', "1")), Err(Fault::Unsupported(_))));
}

/// In millimetres, where the data does not tell another unit.
fn step(data: &str) -> String {
    let unit = "#901=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n\
        #902=(GLOBAL_UNIT_ASSIGNED_CONTEXT((#901))REPRESENTATION_CONTEXT('',''));\n";
    let unit = if data.contains("UNIT_ASSIGNED") { "" } else { unit };
    format!(
        "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('a','b',(''),(''),'c','d','');\n\
         FILE_SCHEMA(('CONFIG_CONTROL_DESIGN'));\nENDSEC;\nDATA;\n{unit}{data}ENDSEC;\nEND-ISO-10303-21;\n"
    )
}

const POINTS: &str = "#1=CARTESIAN_POINT('',(5.,0.,0.));\n#2=CARTESIAN_POINT('',(5.,0.,8.));\n\
    #3=CARTESIAN_POINT('',(5.,5.,0.));\n#4=CARTESIAN_POINT('',(5.,5.,8.));\n\
    #5=CARTESIAN_POINT('',(0.,5.,0.));\n#6=CARTESIAN_POINT('',(0.,5.,8.));\n";

#[test]
fn step_with_complex_instances() {
    let rational = format!(
        "{POINTS}#10=(BOUNDED_SURFACE()B_SPLINE_SURFACE(2,1,((#1,#2),(#3,#4),(#5,#6)),\
         .UNSPECIFIED.,.F.,.F.,.U.)B_SPLINE_SURFACE_WITH_KNOTS((3,3),(2,2),(0.,1.),(0.,1.),.UNSPECIFIED.)\
         GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_SURFACE(((1.,1.),({W},{W}),(1.,1.)))\
         REPRESENTATION_ITEM('')SURFACE());\n\
         #20=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n\
         #21=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#20);\n\
         #22=(CONVERSION_BASED_UNIT('INCH',#21)LENGTH_UNIT()NAMED_UNIT(#23));\n\
         #24=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#22))\
         REPRESENTATION_CONTEXT('',''));\n"
    );
    let file = all(&step(&rational)).unwrap();
    assert!((file.unit_mm.unwrap() - 25.4).abs() < 1e-12);
    is_quarter(&fitted(&file), 5.0, 8.0);
    let plain = format!(
        "{POINTS}#10=B_SPLINE_SURFACE_WITH_KNOTS('',2,1,((#1,#2),(#3,#4),(#5,#6)),.UNSPECIFIED.,.F.,.F.,.F.,\
         (3,3),(2,2),(0.,1.),(0.,1.),.UNSPECIFIED.);\n#11=PLANE('',#1);\n#12=ADVANCED_FACE('',(),#10,.T.);\n"
    );
    let file = all(&step(&plain)).unwrap();
    let p = fitted(&file).at(0.5, 0.5).point;
    assert!((p - Vec3::new(3.75, 3.75, 4.0)).norm() < 1e-14, "{p}");
    assert_eq!(file.notes, ["not read: 1 PLANE"]);
    let implied = format!(
        "{POINTS}#10=QUASI_UNIFORM_SURFACE('',2,1,((#1,#2),(#3,#4),(#5,#6)),.UNSPECIFIED.,.F.,.F.,.F.);\n"
    );
    let q = fitted(&all(&step(&implied)).unwrap()).at(0.5, 0.5).point;
    assert!((q - p).norm() < 1e-14);
}

#[test]
fn numbers_of_several_entities_of_step_are_told() {
    let twice = format!(
        "{POINTS}#6=CARTESIAN_POINT('',(0.,5.,9.));\n#10=BEZIER_SURFACE('',1,1,((#1,#2),(#5,#6)),.U.,.F.,.F.,.F.);\n"
    );
    let file = all(&step(&twice)).unwrap();
    assert_eq!(file.notes, ["numbers of several entities stand for the last of them: #6"]);
    assert!((fitted(&file).at(1.0, 1.0).point.z - 9.0).abs() < 1e-12);
}

/// Several surfaces of a high degree are told at once.
#[test]
fn surfaces_of_a_high_degree_are_told_together() {
    let surface = r#"{"degree": [4, 1], "knots": [[0,0,0,0,0,1,1,1,1,1], [0,0,1,1]], "points":
        [[[0,0,0],[1,0,4],[2,0,-3],[3,0,5],[4,0,0]], [[0,9,0],[1,9,4],[2,9,-3],[3,9,5],[4,9,0]]]}"#;
    let notes = |n: usize| {
        let all = vec![surface; n].join(",");
        self::all(&format!(r#"{{"surfaces": [{all}]}}"#)).unwrap().notes
    };
    let one = notes(1);
    assert!(one.len() == 1 && one[0].starts_with("surface 1 is of degree 4 by 1;"), "{one:?}");
    let many = notes(15);
    assert!(many.len() == 1 && many[0].ends_with("surface 12 and 3 more"), "{many:?}");
}

#[test]
fn step_that_is_broken_is_refused() {
    let why = |data: &str| all(&step(data)).unwrap_err().to_string();
    assert!(why("#11=PLANE('',#1);\n").contains("1 PLANE"));
    assert!(why("#11=PLANE(''").contains("no STEP file"));
    let deep = format!("#1=A({}{});\n", "(".repeat(5000), ")".repeat(5000));
    assert!(why(&deep).contains("brackets"));
    let lost = "#10=B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#1,#2),(#3,#4)),.U.,.F.,.F.,.F.,(2,2),(2,2),(0.,1.),(0.,1.),.U.);\n";
    assert!(why(lost).contains("control point"));
}

/// What is no surface is refused where it is read, not at a motion.
#[test]
fn surfaces_without_area_or_beyond_numbers_are_refused() {
    let why = |points: &str| {
        let text = format!(
            "{{\"surfaces\": [{{\"degree\": [1, 1], \"knots\": [[0, 0, 1, 1], [0, 0, 1, 1]], \"points\": {points}}}]}}"
        );
        all(&text).unwrap_err().to_string()
    };
    for points in ["[[[1,2,3],[1,2,3]],[[1,2,3],[1,2,3]]]", "[[[0,0,0],[1,0,0]],[[2,0,0],[3,0,0]]]"]
    {
        assert!(why(points).contains("surface 1 has no area"), "{points}");
    }
    let far = "[[[0,0,0],[1e200,0,0]],[[0,1e200,0],[1e200,1e200,1e200]]]";
    assert!(why(far).contains("farther off than 1e75"), "{}", why(far));
}

#[test]
fn stl_of_both_kinds() {
    let text = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 4 0 0\nvertex 0 3 1\nendloop\n\
        endfacet\nendsolid a\n";
    let corners = [[0.0_f32, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 3.0, 1.0]];
    let mut bytes = b"solid but binary".to_vec();
    bytes.resize(80, b' ');
    bytes.extend(1_u32.to_le_bytes());
    bytes.extend([0.0_f32; 3].iter().chain(corners.as_flattened()).flat_map(|x| x.to_le_bytes()));
    bytes.extend([0, 0]);
    // As the file comes: its bytes as Latin-1 where they are no UTF-8.
    let binary: String = bytes.iter().map(|b| char::from(*b)).collect();
    for text in [text, &binary] {
        let file = all(text).unwrap();
        assert!(file.surfaces[0].only_checks());
        let s = fitted(&file);
        assert!((s.at(1.0, 0.0).point - Vec3::new(4.0, 0.0, 0.0)).norm() < 1e-15);
        assert!((s.at(0.5, 1.0).point - Vec3::new(0.0, 3.0, 1.0)).norm() < 1e-15);
        assert!((s.at(0.5, 0.5).point - Vec3::new(1.0, 1.5, 0.5)).norm() < 1e-15);
    }
    assert!(matches!(
        all("solid a\nfacet normal 0 0 1\nendsolid a\n"),
        Err(Fault::Broken { .. } | Fault::NoSurface(_))
    ));
    assert!(read("GOTO/1,2,3\n", &Limits::default()).is_none());
}

/// A box as it is written, its triangles' corners turned outwards.
fn solid(name: &str, size: f64) -> String {
    let corner = |i: usize| [i & 1, i >> 1 & 1, i >> 2].map(|b| if b == 1 { size } else { 0.0 });
    let sides =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let facet = |t: [usize; 3]| {
        let corners: String = t
            .iter()
            .map(|k| {
                let [x, y, z] = corner(*k);
                format!("vertex {x} {y} {z}\n")
            })
            .collect();
        format!("facet normal 0 0 0\nouter loop\n{corners}endloop\nendfacet\n")
    };
    let all: String =
        sides.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).map(facet).collect();
    format!("solid {name}\n{all}endsolid {name}\n")
}

#[test]
fn stl_as_others_write_it() {
    let triangles = |text: &str| match &all(text).unwrap().surfaces[0].shape {
        aptc_geometry::sculptured::SurfaceShape::Facets(all) => all.len(),
        _ => unreachable!("triangles"),
    };
    let text = solid("clamp", 4.0);
    assert_eq!(triangles(&text), 12);
    assert!(all(&text).unwrap().notes.is_empty());
    for text in [
        text.to_uppercase(),
        text.replace('\n', "\r\n"),
        text.replace(" clamp", ""),
        format!("\u{feff}{text}"),
        text.replace("vertex 4 ", "vertex 4.000001E0 "),
    ] {
        assert_eq!(triangles(&text), 12, "{text}");
        assert!(all(&text).unwrap().notes.is_empty());
    }
    // Each solid of several, and no triangle without area.
    let flat = "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 1 1\nvertex 2 2 2\nendloop\nendfacet\n";
    let more = format!("{text}{}", solid("b", 9.0).replace("endsolid", &format!("{flat}endsolid")));
    assert_eq!(triangles(&more), 24);
    // A side is missing.
    let from = text.rfind("facet normal").unwrap();
    let open = format!("{}endsolid", &text[..from]);
    let notes = all(&open).unwrap().notes;
    assert!(notes.len() == 1 && notes[0].contains("3 edges"), "{notes:?}");
    assert!(notes[0].contains("from 4, 4, 4 to 4, 0, 0"), "{notes:?}");
}

#[test]
fn stl_that_is_broken_is_refused_with_its_line() {
    let named = |text: &str| {
        let found = aptc_exchange::read_named("clamp.STL", text, &Limits::default());
        found.expect("STL by its name").unwrap_err().to_string()
    };
    let text = solid("clamp", 4.0);
    let mut head = vec![b' '; 80];
    head.extend(12_u32.to_le_bytes());
    head.resize(84 + 11 * 50, 0);
    let short: String = head.iter().map(|b| char::from(*b)).collect();
    for (text, says) in [
        (String::new(), "no triangles"),
        ("solid\nendsolid\n".to_owned(), "no triangles"),
        ("HELLO\n".to_owned(), "line 1: solid is due there, and `HELLO` stands"),
        (text.replacen("vertex 0", "vertex nan", 1), "line 4: triangle 1 has a corner"),
        (text.replacen("vertex 0", "vertex 1e99", 1), "line 4: triangle 1 has a corner"),
        (text.replacen("vertex 0 0", "vertex 0,5 0", 1), "line 4: vertex with three numbers"),
        (text.replacen("endloop", "vertex 1 2 3\nendloop", 1), "line 7: endloop is due"),
        (text.replace("endsolid clamp", ""), "ends where facet or endsolid is due"),
        (text[..text.rfind("endloop").unwrap()].to_owned(), "the file ends where endloop is due"),
        (short, "its head tells of 12 triangles, and behind it are 550 bytes"),
    ] {
        let why = named(&text);
        assert!(why.contains(says), "{why}");
    }
    let flat = solid("clamp", 0.0);
    assert!(named(&flat).contains("none of its 12 triangles has an area"));
}
