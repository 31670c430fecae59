//! SCURV, SSURF, BOUNDS and OBJECT: every format reaches PROTAP with its arguments, and mistakes are told
//! where they stand.

mod support;

use std::collections::BTreeMap;

use aptc_geometry::sculptured::{
    CurveDefinition, CurveShape, FlowLaw, MeshSpacing, PatchKind, Side, SurfaceDefinition,
    SurfaceShape, Sweep,
};
use aptc_geometry::{Form, Vec3};
use aptc_protap::{Kind, Outcome};
use aptc_translate::{NoFiles, Options};
use support::{Ran, Shelf, run_with};

const POINTS: &str = "P1=POINT/0,0,0\nP2=POINT/1,1,0\nP3=POINT/3,1,0\nP4=POINT/4,0,0\n\
                      V1=VECTOR/1,1,0\nV2=VECTOR/0,0,1\n";

fn free(text: &str) -> Ran {
    let options = Options { free_form: true, ..Options::default() };
    run_with(&format!("{POINTS}{text}\nFINI\n"), &mut NoFiles, options, |_| Outcome::None)
}

fn defined(text: &str, name: &str) -> Form {
    defined_with(text, name, &[])
}

/// What `name` stands for, with these messages and no other.
fn defined_with(text: &str, name: &str, codes: &[u16]) -> Form {
    let ran = free(text);
    let told: Vec<u16> = ran.told().iter().map(|(code, _)| *code).collect();
    assert_eq!(told, codes, "{text}\n{}", ran.messages());
    let found = ran.records.iter().rev().find_map(|r| match &r.kind {
        Kind::Define { name: n, form } if n.name == name => Some((**form).clone()),
        _ => None,
    });
    assert!(aptc_protap::verify(&ran.records).is_empty());
    let file = aptc_diagnostics::FileId(0);
    let back = aptc_protap::read(file, &aptc_protap::write(&ran.records));
    assert_eq!(back, (ran.records.clone(), vec![]));
    found.expect("the name is defined")
}

fn curve(text: &str) -> CurveDefinition {
    match defined(text, "C") {
        Form::Scurv(c) => (*c).clone(),
        other => panic!("{other:?} is no curve"),
    }
}

fn surface(text: &str) -> SurfaceDefinition {
    surface_of(defined(text, "S"))
}

fn surface_of(form: Form) -> SurfaceDefinition {
    match form {
        Form::Ssurf(s) => (*s).clone(),
        other => panic!("{other:?} is no surface"),
    }
}

/// Code and line of the only message.
fn mistake(text: &str) -> (u16, u32) {
    let ran = free(text);
    let told = ran.told();
    assert_eq!(told.len(), 1, "{text}\n{}", ran.messages());
    told[0]
}

#[test]
fn a_conic_segment_keeps_points_and_directions() {
    // Of the circle about (2, -1).
    let c = curve("C=SCURV/CURSEG,P1,TANSPL,(VECTOR/1,2,0),P2,P4,CRSSPL,V2,NORMAL,(VECTOR/2,1,0)");
    let CurveShape::Conic(knots) = c.shape else { panic!("a conic") };
    assert_eq!(knots.len(), 3);
    assert_eq!(knots[0].tangent, Some(Vec3::new(1.0, 2.0, 0.0)));
    assert_eq!(
        (knots[2].cross, knots[2].normal),
        (Some(Vec3::z()), Some(Vec3::new(2.0, 1.0, 0.0)))
    );
    assert_eq!(c.map, None);
}

#[test]
fn a_spline_tells_weights_for_all_from_those_of_a_point() {
    let c = curve("C=SCURV/SPLINE,WEIGHT,0.5,LIMIT,.1,P1,P2,WEIGHT,2,P3,LIMIT,0,(5,0,0)");
    let CurveShape::Spline { smoothing, knots } = c.shape else { panic!("a spline") };
    assert_eq!((smoothing.weight, smoothing.limit), (Some(0.5), Some(0.1)));
    assert_eq!((knots[1].smoothing.weight, knots[2].smoothing.limit), (Some(2.0), Some(0.0)));
    assert_eq!(knots[3].point, Vec3::new(5.0, 0.0, 0.0));
    assert!(knots[0].smoothing.is_none());
}

#[test]
fn flow_and_seg_follow_a_curve() {
    let c = curve(
        "C=SCURV/SPLINE,P1,P2,P3,P4,FLOW,ARC,0,1,RELTOL,.01,CHORD,1,2,P1,P4,\
         ANGLE,2,3,PIVOT,P1,PLANO,V2,SEG,LENGTH,0,2,PARAM,2,3",
    );
    let laws: Vec<_> = c.flow.iter().map(|s| s.law).collect();
    assert_eq!(laws, [FlowLaw::Arc, FlowLaw::Chord, FlowLaw::Angle]);
    assert_eq!(c.flow[0].tolerance, Some(0.01));
    assert_eq!(c.flow[1].points.len(), 2);
    assert_eq!((c.flow[2].points.len(), c.flow[2].vector), (1, Some(Vec3::z())));
    assert_eq!(c.segments.iter().map(|s| s.by_length).collect::<Vec<_>>(), [true, false]);
    assert_eq!(c.segments[1].range.map(f64::to_bits), [2.0_f64, 3.0].map(f64::to_bits));
}

#[test]
fn curves_are_joined_and_carried() {
    let c = curve(
        "A=SCURV/CURSEG,P1,P2,P3\nM1=MATRIX/TRANSL,0,0,7\nB=SCURV/SPLINE,P3,P4\n\
         C=SCURV/COMBIN,A,B,TRFORM,M1",
    );
    let CurveShape::Combined(parts) = &c.shape else { panic!("joined curves") };
    assert_eq!((parts.len(), c.n_spans()), (2, Some(2)));
    assert_eq!(c.map.unwrap().point(Vec3::zeros()), Vec3::new(0.0, 0.0, 7.0));
}

#[test]
fn a_stretch_of_a_circle_ends_where_its_bounds_cut_it() {
    let c = curve(
        "K=CIRCLE/0,0,5\nLX=LINE/XAXIS\nLY=LINE/YAXIS\nZSURF/2\nC=SCURV/SEG,K,LY,POSY,LX,POSX",
    );
    let CurveShape::Arc { center, axis, ends } = c.shape else { panic!("an arc") };
    assert_eq!((center, axis), (Vec3::new(0.0, 0.0, 2.0), Vec3::z()));
    let wanted = [Vec3::new(0.0, 5.0, 2.0), Vec3::new(5.0, 0.0, 2.0)];
    assert!((ends[0] - wanted[0]).norm() < 1e-12 && (ends[1] - wanted[1]).norm() < 1e-12);
    let c = curve("LX=LINE/XAXIS\nK=CIRCLE/0,0,5\nL2=LINE/9,0,9,1\nC=SCURV/SEG,LX,K,NEGX,L2");
    let CurveShape::Stretch { ends } = c.shape else { panic!("a line") };
    assert!((ends[0] + Vec3::x() * 5.0).norm() < 1e-12 && (ends[1].x - 9.0).abs() < 1e-12);
    // XSMALL is NEGX, and so are its like.
    let of = |low: &str, high: &str| {
        curve(&format!(
            "LX=LINE/XAXIS\nK=CIRCLE/0,0,5\nL=LINE/YAXIS\nC=SCURV/SEG,K,LX,{low},L,{high}"
        ))
    };
    assert_eq!(of("XSMALL", "YLARGE"), of("NEGX", "POSY"));
    assert_eq!(of("XLARGE", "YSMALL"), of("POSX", "NEGY"));
}

#[test]
fn meshes_of_every_spacing() {
    for (word, spacing) in [
        ("XYZ", MeshSpacing::Xyz),
        ("XYPLAN", MeshSpacing::Xyplan),
        ("YZPLAN", MeshSpacing::Yzplan),
        ("ZXPLAN", MeshSpacing::Zxplan),
        ("RULED", MeshSpacing::Ruled),
    ] {
        let s = surface(&format!(
            "S=SSURF/SMESH,{word},SPLINE,P1,P2,P3,SPLINE,WEIGHT,.2,(0,0,5),TANSPL,V1,(1,1,5),(3,1,5)"
        ));
        let SurfaceShape::Mesh { spacing: found, splines, .. } = s.shape else { panic!("a mesh") };
        assert_eq!((found, splines.len()), (spacing, 2));
        assert_eq!(splines[1].smoothing.weight, Some(0.2));
        assert_eq!(splines[1].knots[0].tangent, Some(Vec3::new(1.0, 1.0, 0.0)));
    }
}

#[test]
fn a_weight_before_the_first_spline_is_for_all() {
    let s = surface(
        "S=SSURF/GMESH,XYZ,WEIGHT,.3,SPLINE,P1,P2,SPLINE,LIMIT,.1,P3,P4,SPLINE,WEIGHT,1,P4,P1",
    );
    let SurfaceShape::Mesh { splines, .. } = s.shape else { panic!("a mesh") };
    let weights: Vec<_> = splines.iter().map(|s| s.smoothing.weight).collect();
    assert_eq!(weights, [Some(0.3), Some(0.3), Some(1.0)]);
    assert_eq!(splines[1].smoothing.limit, Some(0.1));
    assert_eq!(mistake("S=SSURF/SMESH,XYZ,P1,P2"), (1200, 7));
}

#[test]
fn patches_have_sixteen_items() {
    let net = "P1,P2,P3,P4,(0,0,1),(1,1,1),(3,1,1),(4,0,1),(0,0,2),(1,1,2),(3,1,2),(4,0,2),\
               (0,0,3),(1,1,3),(3,1,3),(4,0,3)";
    for (word, kind) in [("POLYGN", PatchKind::Polygn), ("PNTSON", PatchKind::Pntson)] {
        let text = format!("S=SSURF/PATCH,{word},PLUS,{net},MINUS,{net}");
        let s = surface_of(defined_with(&text, "S", &[1225]));
        let SurfaceShape::Patches { kind: found, patches } = s.shape else { panic!("patches") };
        assert_eq!((found, patches.len(), patches[1].minus), (kind, 2, true));
        assert_eq!(patches[0].items[15], Vec3::new(4.0, 0.0, 3.0));
    }
    let vectors = "P1,P4,V1,V1,(0,0,3),(4,0,3),V1,V1,V2,V2,V1,V1,V2,V2,V1,V1";
    let s = surface(&format!("S=SSURF/PATCH,PNTVEC,PLUS,{vectors}"));
    let SurfaceShape::Patches { patches, .. } = s.shape else { panic!("patches") };
    assert_eq!(patches[0].items[8], Vec3::z());
    let fifteen = vectors.rsplit_once(',').unwrap().0;
    let (code, _) = mistake(&format!("S=SSURF/PATCH,PNTVEC,PLUS,{fifteen}"));
    assert_eq!(code, 1200);
}

#[test]
fn surfaces_of_curves() {
    let two = "A=SCURV/SPLINE,P1,P2,P3\nB=SCURV/SPLINE,(0,0,5),(1,1,5),(3,1,5)\n";
    let s = surface(&format!("{two}S=SSURF/REVOLV,A,AXIS,P1,P4,CCLW,0,180"));
    let SurfaceShape::Revolved { axis, clockwise, angles_deg, .. } = s.shape else { panic!() };
    assert_eq!((axis, clockwise, angles_deg), (Vec3::new(4.0, 0.0, 0.0), false, [0.0, 180.0]));
    let s = surface(&format!("{two}S=SSURF/REVOLV,A,AXIS,P1,V2,CLW,-90,90"));
    assert!(matches!(s.shape, SurfaceShape::Revolved { clockwise: true, .. }));
    let s = surface(&format!("{two}S=SSURF/RULED,A,B"));
    assert!(matches!(s.shape, SurfaceShape::RuledBetween(_)));
    for axis in ["V2", "P1,(0,0,1)"] {
        let s = surface(&format!("{two}S=SSURF/RULED,A,AXIS,{axis}"));
        let SurfaceShape::RuledAlong { axis, .. } = s.shape else { panic!("a cylinder") };
        assert_eq!(axis, Vec3::z());
    }
    let across = "C=SCURV/SPLINE,(0,0,9),(1,1,9),(3,1,9)\nX=SCURV/SPLINE,P1,(0,0,5),(0,0,9)\n\
                  Y=SCURV/SPLINE,P3,(3,1,5),(3,1,9)\n";
    let s = surface(&format!("{two}{across}S=SSURF/GENCUR,A,B,C,CROSS,X,Y"));
    let SurfaceShape::General { curves, cross } = s.shape else { panic!("through curves") };
    assert_eq!((curves.len(), cross.len()), (3, 2));
    for (word, motion) in [
        ("TRANSL", Sweep::Transl),
        ("XYROT", Sweep::Xyrot),
        ("YZROT", Sweep::Yzrot),
        ("ZXROT", Sweep::Zxrot),
        ("SCALE", Sweep::Scale),
    ] {
        let s = surface(&format!("{two}S=SSURF/{word},A,CROSS,B"));
        assert!(matches!(s.shape, SurfaceShape::Swept { motion: m, .. } if m == motion));
    }
    let s = surface(&format!(
        "{two}T=SSURF/RULED,A,B\nU=SSURF/RULED,B,A\nM=MATRIX/XYROT,90\n\
         S=SSURF/COMBIN,T,U,TRFORM,M"
    ));
    assert!(matches!(&s.shape, SurfaceShape::Combined(parts) if parts.len() == 2));
    assert!(s.map.is_some());
}

#[test]
fn a_surface_by_canonical_numbers_gives_them_back() {
    let s = surface("S=SSURF/CANON,1,2,3.5\nOBTAIN,SSURF/S,,,X\nGOTO/X,0,0");
    assert_eq!(s.shape, SurfaceShape::Canonical(vec![1.0, 2.0, 3.5]));
}

#[test]
fn bounds_and_objects_name_sides() {
    let form = defined_with(
        "PL=PLANE/0,0,1,5\nK=CYLNDR/0,0,0,0,0,1,3\nB1=BOUNDS/PL,NEGZ,K,IN\nB2=BOUNDS/PL,P1,B1,2,K\n\
         O=OBJECT/B1,B2",
        "O",
        &[1305, 1305],
    );
    let Form::Solid(object) = form else { panic!("an object") };
    assert!(object.object);
    let sides: Vec<Side> = object
        .parts
        .iter()
        .flat_map(|(form, _)| match form {
            Form::Solid(b) => b.parts.iter().map(|(_, s)| *s).collect::<Vec<_>>(),
            other => panic!("{other:?} is no BOUNDS"),
        })
        .collect();
    let down = Side::Toward(-Vec3::z());
    assert_eq!(sides, [down, Side::In, Side::Of(Vec3::zeros()), Side::Numbered(2.0), Side::Own]);
}

#[test]
fn a_reference_system_carries_the_finished_curve() {
    let c =
        curve("M1=MATRIX/TRANSL,10,0,0\nREFSYS/M1\nC=SCURV/CURSEG,(0,0,0),(1,0,0)\nREFSYS/NOMORE");
    let CurveShape::Conic(knots) = &c.shape else { panic!("a line") };
    let map = c.map.expect("the system");
    assert_eq!(map.point(knots[1].point), Vec3::new(11.0, 0.0, 0.0));
}

#[test]
fn mistakes_are_told_where_they_stand() {
    let line = 7;
    assert_eq!(mistake("C=SCURV/SPLINE,P1"), (1216, line));
    assert_eq!(mistake("C=SCURV/SPLINE,P1,P2,TANSPL,P3"), (1200, line));
    assert_eq!(mistake("C=SCURV/CURSEG,P1,P1"), (1204, line));
    assert_eq!(mistake("C=SCURV/CURSEG,P1,TANSPL,V1,P2,TANSPL,V1,P3,P4"), (1205, line));
    assert_eq!(mistake("C=SCURV/SPLINE,P1,P2,P3,FLOW,ARC,0,1,SEG,LENGTH,0,2"), (1200, line));
    assert_eq!(mistake("C=SCURV/SPLINE,P1,P2,P3,FLOW,ARC,0,2"), (1200, line));
    assert_eq!(mistake("S=SSURF/SMESH,XYZ,SPLINE,P1,P2,SPLINE,P3,P4,P1"), (1216, line));
    assert_eq!(mistake("S=SSURF/SMESH,XYZ,SPLINE,P1,P2"), (1216, line));
    assert_eq!(mistake("S=SSURF/RULED,P1,P2"), (1200, line));
    assert_eq!(mistake("K=CIRCLE/0,0,5\nL=LINE/XAXIS\nC=SCURV/SEG,K,L,L"), (1200, line + 2));
    assert_eq!(
        mistake("K=CIRCLE/0,0,5\nL=LINE/0,9,1,9\nC=SCURV/SEG,K,L,POSX,L,NEGX"),
        (1203, line + 2)
    );
    assert_eq!(mistake("C=SCURV/CURSEG,P1,P2\nPSIS/C"), (1304, line + 1));
}

#[test]
fn definitions_within_each_other_are_bounded() {
    let text = "CANON/ON\nC=SCURV/CURSEG,P1,P2\nLOOPST\nI=0\nA)C=SCURV/COMBIN,C,C\nI=I+1\n\
                IF(I-90)A,B,B\nB)LOOPND";
    assert_eq!(mistake(text).1, 11);
}

fn vec3(text: &str, name: &str) -> Vec3 {
    vec3_of(defined(text, name))
}

fn vec3_of(form: Form) -> Vec3 {
    match form {
        Form::Point(v) | Form::Vector(v) => v,
        other => panic!("{other:?}"),
    }
}

/// A flat square of two by two patches, x = 2u, y = 3v, z = 1, and a quarter of a circle of radius 5 from
/// (5,0,0) to (0,5,0).
const SQUARE: &str = "S=SSURF/SMESH,XYZ,SPLINE,(0,0,1),(2,0,1),(4,0,1),SPLINE,(0,3,1),(2,3,1),(4,3,1),\
                      SPLINE,(0,6,1),(2,6,1),(4,6,1)\n";
const QUARTER: &str = "R=5*SQRTF(.5)\nC=SCURV/CURSEG,(5,0,0),(R,R,0),(0,5,0)\n";

fn near(text: &str, wanted: [f64; 3]) {
    let got = vec3(&format!("{SQUARE}{QUARTER}X={text}"), "X");
    let off = (got - Vec3::from(wanted)).norm();
    assert!(off < 1e-9, "{text}: {got:?} instead of {wanted:?}");
}

/// It is the line that misses the surface, and not the point that it goes through.
#[test]
fn a_line_that_misses_is_told_as_a_line() {
    for (line, said) in [
        ("Q1,V2", "the line through POINT Q1 along VECTOR V2 does not meet SSURF S"),
        ("Q1,Q2", "the line through POINT Q1 and POINT Q2 does not meet SSURF S"),
    ] {
        let ran = free(&format!("{SQUARE}Q1=POINT/9,0,5\nQ2=POINT/9,0,6\nX=POINT/INTOF,S,{line}"));
        let told = ran.messages();
        assert!(told.contains(said), "{told}");
    }
}

#[test]
fn points_and_vectors_of_a_plane_square() {
    for text in [
        "POINT/INTOF,S,1.25,.5",
        "POINT/INTOF,S,1.25,.5,0",
        "POINT/INTOF,S,.25,.5,2",
        "POINT/INTOF,S,PARAM,1.25,.5",
        "POINT/INTOF,S,PARAM,.25,.5,2",
        "POINT/INTOF,S,(2.5,1.5,9)",
        "POINT/INTOF,S,(2.5,1.5,9),(2.5,1.5,8)",
        "POINT/INTOF,S,(2.5,1.5,9),V2",
        "POINT/INTOF,S,(1.5,1.5,2),(VECTOR/1,0,-1),(9,9,9)",
        "POINT/INTOF,S,PARAM,(2.5,1.5,-3)",
        "POINT/INTOF,S,FLOW,(2.5,1.5,-3),(2.5,1.5,0)",
        "POINT/INTOF,S,PARAM,(2.5,1.5,-3),V2",
        "POINT/INTOF,S,PARAM,(2.5,1.5,-3),V2,P1",
    ] {
        near(text, [2.5, 1.5, 1.0]);
    }
    for place in [
        "PARAM,1,1,0",
        "1,1",
        "1,1,0",
        "PARAM,1,1",
        "(1,1,5)",
        "(1,1,5),(1,1,0)",
        "(1,1,5),V2",
        "(1,1,5),V2,P1",
    ] {
        near(&format!("VECTOR/INTOF,S,{place},TANSPL"), [2.0, 0.0, 0.0]);
        near(&format!("VECTOR/INTOF,S,{place},CRSSPL,UNIT"), [0.0, 1.0, 0.0]);
        near(&format!("VECTOR/INTOF,S,{place},NORMAL"), [0.0, 0.0, 6.0]);
    }
}

#[test]
fn points_and_vectors_of_a_circle() {
    for text in [
        "POINT/INTOF,C,PARAM,1",
        "POINT/INTOF,C,PARAM,1,1",
        "POINT/INTOF,C,FLOW,1",
        "POINT/INTOF,(LINE/YAXIS),C,(1,4,0)",
    ] {
        near(text, [0.0, 5.0, 0.0]);
    }
    near("POINT/INTOF,(PLANE/0,1,0,3),C,(5,0,0)", [4.0, 3.0, 0.0]);
    // Straight on before the beginning of the arc.
    near("POINT/INTOF,(PLANE/0,1,0,-2),C,P1", [5.0, -2.0, 0.0]);
    near("VECTOR/INTOF,C,PARAM,0,TANSPL,UNIT", [0.0, 1.0, 0.0]);
    near("VECTOR/INTOF,C,PARAM,0,1,TANSPL,UNIT", [0.0, 1.0, 0.0]);
    near("VECTOR/INTOF,C,FLOW,.5,BINORM,UNIT", [0.0, 0.0, 1.0]);
    near("VECTOR/INTOF,(PLANE/0,1,0,3),C,P1,TANSPL,UNIT", [-0.6, 0.8, 0.0]);
    let line = "D=SCURV/SPLINE,P1,CRSSPL,V2,(2,0,0),CRSSPL,(VECTOR/0,2,0)\n";
    let v = vec3(&format!("{line}X=VECTOR/INTOF,D,PARAM,.5,CRSSPL"), "X");
    assert!((v - Vec3::new(0.0, 1.0, 0.5)).norm() < 1e-12, "{v:?}");
}

/// A curve goes straight on beyond its ends, as SSV3 gives it.
#[test]
fn a_curve_goes_on_straight() {
    let c = "P5=POINT/0,0,0\nP6=POINT/1,1,.2\nP7=POINT/2.1,.1,.3\nP8=POINT/3,1,.1\nC=SCURV/SPLINE,P5,P6,P7,P8\n";
    for (of, wanted) in [
        ("POINT/INTOF,C,PARAM,-.3", [-0.245_893_366, -0.507_159_574, -0.064_854_646]),
        ("POINT/INTOF,C,PARAM,3.4", [3.316_811_983, 1.584_269_414, -0.016_464_776]),
        ("POINT/INTOF,C,PARAM,1.2,1", [1.187_595_895, 0.964_731_127, 0.233_901_565]),
        ("POINT/INTOF,C,PARAM,-.2,2", [0.745_110_698, 1.047_920_337, 0.153_937_445]),
        ("VECTOR/INTOF,C,PARAM,3.4,TANSPL", [0.792_029_958, 1.460_673_536, -0.291_161_940]),
    ] {
        let got = vec3_of(defined_with(&format!("{c}X={of}"), "X", &[1226]));
        assert!((got - Vec3::from(wanted)).norm() < 2e-9, "{of}: {got}");
    }
}

#[test]
fn places_that_are_not_there_are_told() {
    let told = |text: &str| {
        let ran = free(&format!("{SQUARE}{QUARTER}X={text}"));
        assert_eq!(ran.diagnostics.len(), 1, "{text}\n{}", ran.messages());
        ran.diagnostics[0].code.number()
    };
    assert_eq!(told("POINT/INTOF,C,PARAM,.5,2"), 1214);
    assert_eq!(told("POINT/INTOF,C,FLOW,.5,2"), 1214);
    assert_eq!(told("POINT/INTOF,S,0,0,5"), 1214);
    assert_eq!(told("VECTOR/INTOF,C,PARAM,0,CRSSPL"), 1207);
    assert_eq!(told("VECTOR/INTOF,S,0,0,TANSPL,LENGTH"), 1200);
    assert_eq!(told("POINT/INTOF,S,(9,9,9),V2"), 1203);
    assert_eq!(told("POINT/INTOF,(PLANE/0,0,1,4),C,P1"), 1203);
    assert_eq!(told("POINT/INTOF,S,TANSPL"), 1200);
}

#[test]
fn parameters_of_the_place_found_last() {
    let value = |text: &str| {
        let ran = free(&format!("{SQUARE}{QUARTER}{text}\nGOTO/X,0,0"));
        assert!(ran.diagnostics.is_empty(), "{text}\n{}", ran.messages());
        support::numbers(&ran)[0]
    };
    let place = "Q=POINT/INTOF,S,(2.5,4.5,9)\n";
    for (function, wanted) in [
        ("UVAL", 0.25),
        ("VVAL", 0.5),
        ("PVAL", 4.0),
        ("S", 4.0),
        ("S,PATCH", 4.0),
        ("S,UPARAM", 1.25),
        ("S,VPARAM", 1.5),
    ] {
        let found = value(&format!("{place}X=PARMF({function})"));
        assert!((found - wanted).abs() < 1e-9, "{function}: {found}");
    }
    // Two arcs of 2 and 6; the flow runs evenly over both.
    let place = "D=SCURV/SPLINE,(0,0,0),(2,0,0),(8,0,0),FLOW,ARC,0,2,SEG,LENGTH,0,2\n\
                 Q=POINT/INTOF,(PLANE/1,0,0,5),D,P1\n";
    for (function, wanted) in [("SVAL", 2.0), ("D,FLOW", 0.625)] {
        let found = value(&format!("{place}X=PARMF({function})"));
        assert!((found - wanted).abs() < 1e-6, "{function}: {found}");
    }
    let both = value(&format!("{place}X=PARMF(D)-PARMF(TVAL)-PARMF(D,PARAM)+PARMF(TVAL)"));
    assert!(both.abs() < 1e-12);
    for (text, wanted) in [
        ("X=NUMF(C)", 1.0),
        ("X=NUMF(S)", 4.0),
        ("X=NUMF(S,PATCH)", 4.0),
        ("X=NUMF(S,SPLINE)", 3.0),
        ("X=NUMF(S,CRSSPL)", 3.0),
        ("D=SCURV/SPLINE,P1,P2,P3,FLOW,ARC,0,2,SEG,LENGTH,0,2\nX=NUMF(D,ARC)*10+NUMF(D,SEG)", 21.0),
    ] {
        assert!((value(text) - wanted).abs() < 1e-12, "{text}");
    }
    let told = |text: &str| free(&format!("{SQUARE}{text}")).told().len();
    assert_eq!(told("X=PARMF(UVAL)"), 1);
    assert_eq!(told("Q=POINT/INTOF,S,P1\nX=PARMF(TVAL)"), 1);
    assert_eq!(told("X=NUMF(S,ARC)"), 1);
}

#[test]
fn what_needs_other_files_is_refused_by_name() {
    assert_eq!(mistake("S=SSURF/FETCH,5"), (1303, 7));
}

#[test]
fn cut_vectors_that_are_not_there_are_told() {
    assert_eq!(mistake("P=POINT/CLDATA,1,TP,3"), (1053, 7));
    assert_eq!(mistake("V=VECTOR/CLDATA,1"), (1053, 7));
    assert_eq!(mistake("P=POINT/CLDATA,1,TA,3"), (1304, 7));
    assert_eq!(mistake("N=NUMF(CLDATA)"), (1053, 7));
    assert_eq!(mistake("X=CLDATF(1,UPS,1)"), (1053, 7));
    assert_eq!(mistake("X=CLDATF(1,UVPPS,1)"), (1053, 7));
}

#[test]
fn what_does_not_fit_is_told_by_the_formats_of_its_word() {
    let told = |text: &str| {
        let ran = free(&format!("C1=SCURV/SPLINE,P1,P2,P3\n{text}"));
        assert_eq!(ran.diagnostics.len(), 1, "{text}\n{}", ran.messages());
        let d = &ran.diagnostics[0];
        format!("{}\n{:?}", d.message, d.notes)
    };
    let axis = told("S=SSURF/RULED,C1,AXIS,P1,V1");
    assert!(axis.contains("expected a point"), "{axis}");
    let ruled = "RULED,sculptured curve,";
    for format in
        ["sculptured curve", "AXIS,point,point", "AXIS,vector"].map(|f| format!("{ruled}{f}"))
    {
        assert!(axis.contains(&format), "{format}: {axis}");
    }
    // A mesh whose first word is left out is told as before.
    let mesh = told("S=SSURF/RULED,SPLINE,P1,P2,SPLINE,P3,P4");
    assert!(mesh.contains("SMESH|GMESH is missing before RULED"), "{mesh}");
}

/// Surfaces whose curves lie along each other are refused where they are defined, not at a motion.
#[test]
fn a_surface_without_area_is_refused() {
    let head = "A1=POINT/0,0,0\nA2=POINT/10,0,0\nA3=POINT/20,0,0\nQ1=POINT/0,10,0\nQ2=POINT/10,10,5\nQ3=POINT/20,10,0\n\
                C1=SCURV/SPLINE,A1,A2,A3\nC2=SCURV/SPLINE,Q1,Q2,Q3\n";
    for definition in [
        "SMESH,XYZ,SPLINE,A1,A2,A3,SPLINE,A1,A2,A3",
        "RULED,C1,C1",
        "RULED,C1,AXIS,(VECTOR/1,0,0)",
        "REVOLV,C1,AXIS,A1,A2,CLW,0,360",
        "GENCUR,C1,C1",
        "TRANSL,C1,CROSS,C1",
    ] {
        let ran = free(&format!("{head}S=SSURF/{definition}"));
        assert_eq!(ran.told(), [(1205, 15)], "{definition}: {}", ran.messages());
    }
    for definition in [
        "SMESH,XYZ,SPLINE,A1,A2,A3,SPLINE,Q1,Q2,Q3",
        "RULED,C1,C2",
        "RULED,C1,AXIS,(VECTOR/1,.001,0)",
        "REVOLV,C1,AXIS,A1,(VECTOR/0,1,0),CLW,0,1",
        "GENCUR,C1,C2",
        "TRANSL,C1,CROSS,C2",
    ] {
        let ran = free(&format!("{head}S=SSURF/{definition}"));
        assert_eq!(ran.told(), [], "{definition}: {}", ran.messages());
    }
    // Of the formats that begin with the word that is written one is told.
    let ran = free(&format!("{head}S=SSURF/TRANSL,C1,C2"));
    assert!(ran.messages().contains("CROSS is missing"), "{}", ran.messages());
}

/// What is read later may use what cannot be fitted.
#[test]
fn what_cannot_be_fitted_is_an_error_where_more_is_read() {
    let mut shelf = Shelf(BTreeMap::from([("REST", "GOTO/(POINT/INTOF,C,PARAM,.5)\n")]));
    let text = "C=SCURV/CURSEG,(POINT/0,0,0),(POINT/4,4,0),(POINT/8,0,0)\nINCLUD/REST\nFINI\n";
    let ran = run_with(text, &mut shelf, Options::default(), |_| Outcome::None);
    let told: Vec<(u16, bool)> =
        ran.diagnostics.iter().map(|d| (d.code.number(), d.is_error())).collect();
    assert_eq!(told, [(2045, true)], "{}", ran.messages());
}

/// One message where the curve is defined, however often it and what is made of it are used; a warning where it never is.
#[test]
fn what_cannot_be_fitted_is_told_once_where_it_is_defined() {
    let half = "C=SCURV/CURSEG,(0,0,0),(4,4,0),(8,0,0)";
    let cases: [(&str, &[bool]); 9] = [
        (half, &[false]),
        // What is said of it is no use of it.
        (&format!("{half} $$ C is half a turn\nREMARK C\nPPRINT C"), &[false]),
        (&format!("{half}\nGOTO/(POINT/INTOF,C,PARAM,.5) $$ C"), &[true]),
        (&format!("{half}\nQ=POINT/INTOF,C,PARAM,.5\nGOTO/Q"), &[true]),
        (&format!("{half}\nS=SSURF/RULED,C,C\nQ=POINT/INTOF,S,PARAM,.5,.5"), &[true]),
        (&format!("{half}\nGOTO/(POINT/INTOF,C,PARAM,.5)\nGOTO/(POINT/INTOF,C,PARAM,.4)"), &[true]),
        ("Q=POINT/INTOF,(SCURV/CURSEG,(0,0,0),(4,4,0),(8,0,0)),PARAM,.5", &[true]),
        // In a line, but there and back.
        ("C=SCURV/CURSEG,(0,0,0),(8,0,0),(4,0,0)\nGOTO/(POINT/INTOF,C,PARAM,.5)", &[true]),
        ("D=SCURV/CURSEG,(0,0,0),(4,0,0),(8,0,0)\nGOTO/(POINT/INTOF,D,PARAM,.5)", &[]),
    ];
    for (text, wanted) in cases {
        let ran = free(text);
        let told: Vec<(u16, bool)> =
            ran.diagnostics.iter().map(|d| (d.code.number(), d.is_error())).collect();
        let wanted: Vec<(u16, bool)> = wanted.iter().map(|error| (2045, *error)).collect();
        assert_eq!(told, wanted, "{text}\n{}", ran.messages());
    }
}
