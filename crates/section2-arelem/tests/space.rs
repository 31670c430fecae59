//! Motion in space against programs that another APT system has run: the same ends, no more cut vectors,
//! every cut vector in its bands.

mod support;

use aptc_geometry::Vec3;
use support::{Run, assert_in_bands, expected, form, forms_of, run};

/// Each statement ends where the oracle's does, with at most as many points; the oracle's own places lie
/// up to a tenth of the band beside ours.
fn agree(ours: &Run, theirs: &[Vec<Vec3>], tolerance: f64) {
    let mut by_line: Vec<(u32, Vec<Vec3>)> = Vec::new();
    for (line, m) in ours.motions() {
        let points = m.points.iter().map(|p| p.te);
        match by_line.last_mut() {
            Some(last) if last.0 == line => last.1.extend(points),
            _ => by_line.push((line, points.collect())),
        }
    }
    for ((line, o), t) in by_line.iter().zip(theirs) {
        let (a, b) = (o[o.len() - 1], t[t.len() - 1]);
        assert!((a - b).norm() <= 2.0 * tolerance + 1e-4, "line {line}: {a} for {b}");
        assert!(o.len() <= t.len(), "line {line}: {} vectors for {}", o.len(), t.len());
    }
}

fn check(program: &str, text: &str, statements: usize, tolerance: f64) {
    let (Some(forms), Some(theirs)) = (forms_of(program), expected(program)) else { return };
    let ours = run(&forms, text);
    let errors: Vec<_> = ours.diagnostics.iter().filter(|d| d.is_error()).collect();
    assert!(errors.is_empty(), "{errors:#?}");
    let lines: std::collections::BTreeSet<u32> = ours.motions().map(|(l, _)| l).collect();
    assert_eq!(lines.len(), statements, "statements that move");
    agree(&ours, &theirs, tolerance);
    assert_in_bands(&ours, 16);
}

#[test]
fn contour_of_cone_and_spheres() {
    let text = "FEDRAT/100
INTOL/.0002
OUTTOL/.0002
CUTTER/0
FROM/-5,-3,3
GO/ON,LXM,ON,PLTOP
TLON,GORGT/LXM,ON,SPL
GORGT/SPL,ON,CON
GOFWD/CON,ON,SPS
GOFWD/SPS,ON,LXM
GOFWD/SPS,ON,CON
GOFWD/CON,ON,SPL
GOFWD/SPL,ON,LXM";
    check("3axis_contour", text, 9, 0.0002);
}

#[test]
fn ball_in_a_cage() {
    let text = "CUTTER/.125,.0625
FROM/.625,-.625,.1
TLOFPS,GO/TO,SPH,ON,LX
PSIS/SPH
TLOFPS,TLON,GOFWD/LX,TO,(LINE/1,0,0,.7175)
TLLFT,GOLFT/(LINE/1,0,0,.7175),TO,(LINE/0,1,0,-.5325)
GOLFT/(LINE/0,1,0,-.5325),TO,(LINE/1,0,0,.5325)
GOLFT/(LINE/1,0,0,.5325),TO,(LINE/0,1,0,-.7175)
GOLFT/(LINE/0,1,0,-.7175),TO,(LINE/1,0,0,.7175)
GOLFT/(LINE/1,0,0,.7175),ON,LX";
    check("ballInCage", text, 8, 0.0005);
}

#[test]
fn sphere_by_levels() {
    let text = "MULTAX
CUTTER/0,0,0,0,0,0,.1
INTOL/.01
OUTTOL/.01
FROM/2,-1,2
GO/TO,PL2,ON,(PLANE/0,0,1,0)
TLLFT,TLONPS,GOLFT/PL2,TO,SPH1
GOLFT/SPH1,PAST,2,INTOF,PL2
PSIS/SPH1
GOUP/PL2,PAST,(PLANE/0,0,1,.25)
PSIS/(PLANE/0,0,1,.25)
GOLFT/SPH1,PAST,2,INTOF,PL2
PSIS/SPH1
GOUP/PL2,PAST,(PLANE/0,0,1,.5)
PSIS/(PLANE/0,0,1,.5)
GOLFT/SPH1,PAST,2,INTOF,PL2
PSIS/SPH1
GOUP/PL2,PAST,(PLANE/0,0,1,.75)
PSIS/(PLANE/0,0,1,.75)
GOLFT/SPH1,PAST,2,INTOF,PL2
PSIS/SPH1
GOUP/PL2,PAST,(PLANE/0,0,1,1)";
    check("sphere", text, 11, 0.01);
}

#[test]
fn start_up_to_sphere_and_cone() {
    let text = "CUTTER/1
FROM/0,-10,0
GO/TO,SPHR2,TO,CONE1";
    check("test3", text, 2, 0.0005);
}

#[test]
fn guard_on_a_cylinder_with_the_axis_square_to_it() {
    let text = "INTOL/.0001
OUTTOL/.0001
MULTAX
CUTTER/.25,.0,0,0,0,0,.25
FROM/-.5,1,1.63
TLAXIS/NORMPS
GO/TO,L2B,ON,CYL1
TLLFT,TLONPS,GOLFT/L2B,ON,L6
GOFWD/C2B,ON,L4B
CUTTER/OPTION,2,.125,0
GOFWD/C1B,ON,L5
CUTTER/OPTION,2,OFF
GOFWD/L1B,ON,L7
CUTTER/OPTION,2,.125,0
GOFWD/C3B,ON,L9
CUTTER/OPTION,2,OFF
GOFWD/L3,ON,L12B
GOFWD/C4B,ON,L7
GOFWD/LXROTB,ON,L5
CUTTER/OPTION,2,.125,0
GOFWD/C5B,ON,L11B
CUTTER/OPTION,2,OFF
GOFWD/C6B,ON,L6B
GODLTA/-.5,0,0
FROM/-.5,-4,0,0,-1,-1
TLAXIS/NORMPS
GO/TO,L10,ON,CYL1
TLLFT,TLONPS,GOLFT/L10,ON,L6
GOFWD/C6,ON,L11
CUTTER/OPTION,2,.125,0
GOFWD/C5,ON,L5
GOFWD/LXROT,ON,L7
GOFWD/C4,ON,L12
GOFWD/L3,ON,L8
GOFWD/C3,ON,L7
GOFWD/L1,ON,L5
GOFWD/C1,ON,L4
GOFWD/C2,ON,L6
GOFWD/L2,PAST,LY
GODLTA/-.5,0,0";
    check("case4axis", text, 27, 0.0001);
}

#[test]
fn nose_with_the_axis_square_to_a_cylinder() {
    let text = "CUTTER/.125
MULTAX/ON
INTOL/.0005
OUTTOL/.0005
FROM/-.383,-.835,-1.,0,-1,0
GO/TO,L1,ON,L4
TLAXIS/NORMPS
TLLFT,TLONPS,GOLFT/L1,PSTAN,CYL1
PSIS/CYL1
TLLFT,TLONPS,GOFWD/L1,ON,L3
CUTTER/OPTION,2,.0625,0
GOFWD/C1,ON,L7
GOFWD/C0,ON,L8
GOFWD/C2,ON,L12
GOFWD/L6,ON,L16
GOFWD/C5,ON,L11
GOFWD/C6,ON,L15
GOFWD/L14,ON,L13
GOFWD/C4,ON,L17
GOFWD/L10,ON,L17
GOFWD/C4,ON,L13
GOFWD/L14,ON,L15
GOFWD/C6,ON,L11
GOFWD/C5,ON,L16
GOFWD/L6,ON,L12
GOFWD/C2,ON,L8
GOFWD/C0,ON,L7
GOFWD/C1,ON,L3
GOFWD/L1,PSTAN,L4
PSIS/L4
GOFWD/L1,TO,PL1";
    check("ln1000", text, 23, 0.0005);
}

#[test]
fn fixed_and_tilted_axes() {
    let text = "MULTAX
CUTTER/1
FROM/2,-3,6
TLAXIS/-1,0,0
CUTTER/OPTION,2,.5,.5
GO/TO,CYL1,TO,PL1,ON,PL6
INDIRV/0,0,1
TLRGT,GOFWD/CYL1,ON,PL6
CUTTER/OPTION,2,OFF
GOTO/2,3,6
CUTTER/1
FROM/2,-3,6
TLAXIS/ATANGL,2,45
GO/PAST,PL5,TO,CYL1,ON,PL2
INDIRV/-1,0,1
TLLFT,GOFWD/PL5,ON,PL2
GOTO/2,3,6
CUTTER/.5,.25,0,0,0,0,.25
FROM/2,-3,6,-1,0,0
GO/ON,LX,ON,PL7,TO,CYL1
PSIS/PL7
TLON,TLONPS,GODOWN/LX,PAST,CYL3
PSIS/CYL3
TLON,TLOFPS,GOFWD/LX,PSTAN,PL4B
DNTCUT
GOTO/3.25,0,5,-1,0,1
GO/ON,LX,TO,PL4B,ON,PL7
CUT
PSIS/PL4B
INDIRV/-1,0,1
GOFWD/LX,ON,PL8
DNTCUT
GOTO/1.25,0,3,0,0,1
GO/ON,LX,TO,PL4B,TO,PL8
CUT
PSIS/PL4B
INDIRV/-1,0,-1
GOFWD/LX,PSTAN,CYL2
PSIS/CYL2
GOFWD/LX,ON,PL8
GODLTA/0,0,.5
GOTO/2,-3,6";
    check("multax", text, 19, 0.0005);
}

#[test]
fn sides_from_the_start_up() {
    let text = "GOTO/SPT
CUTTER/.218
TLONPS
GOTO/.5,.646,0
FROM/EPT
INDIRV/0,1,0
GO/TO,SCIRC,PL1
GOLFT/SCIRC,TANTO,VRTL
GOFWD/VRTL,TANTO,MIDFIL
GOFWD/MIDFIL,TANTO,ANGL
GOFWD/ANGL,TANTO,BOTFIL
GOFWD/BOTFIL,TANTO,C1
GOFWD/C1,TANTO,TOPFIL
GOFWD/TOPFIL,TANTO,VRTL
GOFWD/VRTL,TANTO,MIDFIL
GOFWD/MIDFIL,TANTO,ANGL
GOFWD/ANGL,TANTO,BOTFIL
GOFWD/BOTFIL,TANTO,C1
GOFWD/C1,TANTO,TOPFIL
GOFWD/TOPFIL,TANTO,VRTL
GOFWD/VRTL,TANTO,SCIRC
GOFWD/SCIRC,ON,ENDL";
    check("spool2", text, 19, 0.0005);
}

#[test]
fn a_tool_off_the_drive_surface_is_refused_with_the_amount() {
    let Some(forms) = forms_of("test3") else { return };
    let ran = run(&forms, "CUTTER/.1,.05\nFROM/7,7,7\nTLLFT,GOLFT/L1,TO,SPHR1");
    assert_eq!(ran.code(), 2003);
    assert!(
        ran.diagnostics[0].message.contains("0.750036 off it"),
        "{}",
        ran.diagnostics[0].message
    );
}

#[test]
fn one_direction_for_an_upright_cylinder_and_a_plane_is_kept() {
    let mut f = support::Forms::new();
    let mut add = |name: &str, kind: &str, w: &[f64]| {
        f.insert(name.into(), form(kind, w).expect("a legal form"));
    };
    add("PL", "PLANE", &[0.0, 0.0, 1.0, 0.0]);
    add("CY", "CYLNDR", &[20.0, 0.0, 0.0, 0.0, 0.0, 1.0, 6.0]);
    add("SP", "SPHERE", &[20.0, 0.0, 0.0, 6.0]);
    let start = |vector: &str, surface: &str| {
        let text = format!(
            "CUTTER/2,1\nINTOL/0\nOUTTOL/.001\nFROM/0,2,4\nINDIRV/{vector}\nGO/TO,{surface},TO,PL"
        );
        run(&f, &text).clean().end()
    };
    for vector in ["1,-.1,0", "1,.05,0", "1,-.3,0"] {
        let end = start(vector, "CY");
        let c = end - Vec3::new(20.0, 0.0, 0.0);
        assert!((c.norm() - 7.0).abs() < 1.1e-3 && end.z.abs() < 1e-9, "{end}");
        // In plan the tool goes exactly where the vector points.
        let v: Vec<f64> = vector.split(',').map(|x| x.parse().expect("a number")).collect();
        let off = end.x * v[1] - (end.y - 2.0) * v[0];
        assert!(off.abs() < 1e-9, "{end}");
        assert!(end.x < 20.0);
    }
    // A sphere is come to from where the direction leads first. Source: what APT-360 computes.
    for (vector, x, y) in [
        ("1,-.1,0", 13.105_275, 0.689_472),
        ("1,.05,0", 13.291_158, 1.733_216),
        ("1,-.3,0", 13.101_353, -0.649_049),
    ] {
        let end = start(vector, "SP");
        assert!((end - Vec3::new(x, y, 0.0)).norm() < 3e-4, "{end}");
    }
}

/// A flat end upright on a dome and in a bore: the axis is the normal through the tool end, which is on the dome
/// within the band, and in the bore as far from the wall as the edge keeps it.
#[test]
fn flat_end_upright_on_a_dome_and_in_a_bore() {
    let forms = ["DOME", "BORE", "ACROSS", "NEAR", "FAR"];
    let words: [(&str, &[f64]); 5] = [
        ("SPHERE", &[0.0, 0.0, 0.0, 5.0]),
        ("CYLNDR", &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 5.0]),
        ("PLANE", &[1.0, 0.0, 0.0, 0.0]),
        ("PLANE", &[0.0, 1.0, 0.0, -2.0]),
        ("PLANE", &[0.0, 1.0, 0.0, 2.0]),
    ];
    let forms = forms.iter().zip(words);
    let forms = forms.map(|(n, (k, w))| ((*n).into(), form(k, w).expect("a legal form"))).collect();
    let upright = |surface: &str, from: &str| {
        let text = format!(
            "MULTAX\nINTOL/0\nOUTTOL/.001\nCUTTER/1,0,0,0,0,0,1\nFROM/{from},0,0,1\nTLAXIS/NORMPS
GO/ON,ACROSS,TO,{surface},ON,NEAR\nINDIRV/0,1,0\nTLON,GOFWD/ACROSS,ON,FAR"
        );
        let ran = run(&forms, &text);
        assert!(ran.diagnostics.is_empty(), "{:?}", ran.diagnostics);
        assert_in_bands(&ran, 16);
        let points: Vec<_> = ran.motions().skip(1).flat_map(|(_, m)| m.points.clone()).collect();
        for p in &points {
            assert!((p.ta.cross(&p.te)).norm() < 1e-9 * p.te.norm(), "{p:?}");
        }
        points.iter().map(|p| p.te.norm()).collect::<Vec<_>>()
    };
    let dome = upright("DOME", "0,-2,8");
    assert!(dome.iter().all(|r| (5.0 - 1e-9..=5.001 + 1e-9).contains(r)), "{dome:?}");
    let bore = upright("BORE", "0,-2,-1");
    let kept = (25.0_f64 - 0.25).sqrt();
    assert!(bore.iter().all(|r| (kept - 0.0012..=kept + 1e-9).contains(r)), "{bore:?}");
}

/// A point has no body that says on which side of a surface it is: the axis before does, also a little beyond it.
#[test]
fn a_point_keeps_the_side_of_its_axis() {
    let words: [(&str, &str, &[f64]); 4] = [
        ("DOME", "SPHERE", &[0.0, 0.0, 0.0, 5.0]),
        ("ACROSS", "PLANE", &[1.0, 0.0, 0.0, 0.0]),
        ("NEAR", "PLANE", &[0.0, 1.0, 0.0, -2.0]),
        ("FAR", "PLANE", &[0.0, 1.0, 0.0, 2.0]),
    ];
    let forms = words.map(|(n, k, w)| (n.into(), form(k, w).expect("a legal form")));
    let forms = forms.into_iter().collect();
    for z in [-4.59, -4.58, -4.5] {
        let text = format!(
            "MULTAX\nINTOL/.001\nOUTTOL/.001\nCUTTER/0,0,0,0,0,0,0\nFROM/0,-2,{z},0,0,1\nTLAXIS/NORMPS
GO/ON,ACROSS,TO,DOME,ON,NEAR\nINDIRV/0,1,0\nTLON,GOFWD/ACROSS,ON,FAR"
        );
        let ran = run(&forms, &text);
        assert!(ran.diagnostics.is_empty(), "{:?}", ran.diagnostics);
        let points: Vec<_> = ran.motions().skip(1).flat_map(|(_, m)| m.points.clone()).collect();
        assert!(points.len() > 10);
        for p in &points {
            assert!((p.te.norm() - 5.0).abs() <= 0.001 + 1e-9 && p.ta.dot(&p.te) < -4.9, "{p:?}");
        }
    }
}

/// A needle that came TO a wall stands beside it, also where its normal points away and the band has nothing on that side.
#[test]
fn a_needle_stays_beside_the_wall_that_it_came_to() {
    let words: [(&str, &str, &[f64]); 4] = [
        ("WALL", "QADRIC", &[-1.0, -1.0, 0.0, 100.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
        ("FLOOR", "PLANE", &[0.0, 0.0, 1.0, 0.0]),
        ("ACROSS", "PLANE", &[1.0, 0.0, 0.0, 0.0]),
        ("FAR", "PLANE", &[1.0, 0.0, 0.0, 7.0]),
    ];
    let forms = words.map(|(n, k, w)| (n.into(), form(k, w).expect("a legal form")));
    let forms = forms.into_iter().collect();
    let text = "INTOL/0\nOUTTOL/.001\nCUTTER/0,0,0,0,0,0,.1\nFROM/0,-14,0
GO/ON,ACROSS,TO,FLOOR\nINDIRV/0,1,0\nGOFWD/ACROSS,WALL\nGORGT/WALL,FAR";
    let ran = run(&forms, text);
    assert!(ran.diagnostics.is_empty(), "{:?}", ran.diagnostics);
    let points: Vec<_> = ran.motions().flat_map(|(_, m)| m.points.clone()).collect();
    let along = points.iter().filter(|p| p.te.x > 1e-6);
    let off: Vec<f64> = along.map(|p| p.te.xy().norm() - 10.0).collect();
    assert!(off.len() > 5 && off.iter().all(|o| (-1e-9..=0.001 + 1e-9).contains(o)), "{off:?}");
}

/// From above the apex of a cone the way to its side is found on the floor.
#[test]
fn a_start_beside_a_cone_from_above() {
    let mut f = support::Forms::new();
    let mut add = |name: &str, kind: &str, w: &[f64]| {
        f.insert(name.into(), form(kind, w).expect("a legal form"));
    };
    let cos = aptc_geometry::trig::cos_deg(35.0);
    add("SIDE", "CONE", &[0.0, 0.0, 40.0, 0.0, 0.0, -1.0, cos]);
    add("BED", "PLANE", &[0.0, 0.0, 1.0, 0.0]);
    let start = |axis: &str, from: &str| {
        let ran = run(
            &f,
            &format!(
                "INTOL/.01\nOUTTOL/.01\nMULTAX\nCUTTER/10\nFROM/{from}\n{axis}\nINDIRV/0,1,0\nGO/TO,SIDE,TO,BED"
            ),
        );
        assert!(ran.diagnostics.is_empty(), "{:?}", ran.diagnostics);
        ran.end()
    };
    for axis in ["TLAXIS/0,0,1", "TLAXIS/PARLEL,2"] {
        let (above, beside) = (start(axis, "0,-90,60"), start(axis, "0,-90,20"));
        assert!((above - beside).norm() < 0.02, "{axis} {above} {beside}");
    }
}
