//! Motions that cannot be done are refused with the reason.

mod support;

use aptc_geometry::Vec3;
use support::{Forms, form, run};

fn forms() -> Forms {
    let mut f = Forms::new();
    let mut add = |name: &str, kind: &str, w: &[f64]| {
        f.insert(name.into(), form(kind, w).expect("a legal form"));
    };
    add("LX", "LINE", &[0.0, 1.0, 0.0, 0.0]);
    add("LY", "LINE", &[1.0, 0.0, 0.0, 0.0]);
    add("L5", "LINE", &[1.0, 0.0, 0.0, 5.0]);
    add("C1", "CIRCLE", &[5.0, 3.0, 0.0, 0.0, 0.0, 1.0, 1.0]);
    add("C2", "CIRCLE", &[0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 2.0]);
    add("P1", "POINT", &[1.0, 1.0, 0.0]);
    add("PL1", "PLANE", &[0.0, 0.0, 1.0, 1.0]);
    f
}

fn code(text: &str) -> u16 {
    run(&forms(), text).code()
}

#[test]
fn each_refusal_has_its_code_and_is_the_only_message() {
    // No position; no cutter; not at the drive surface; not at the part surface.
    assert_eq!(code("CUTTER/1\nGODLTA/0,0,1"), 2001);
    assert_eq!(code("FROM/0,-5,0\nGO/TO,LX"), 2002);
    assert_eq!(code("CUTTER/1\nFROM/-5,-2,0\nINDIRV/1,0,0\nTLRGT,GOFWD/LX,ON,LY"), 2003);
    assert_eq!(code("CUTTER/1\nFROM/-5,-5,3\nGO/TO,LX\nPSIS/PL1\nTLRGT,GORGT/LX,ON,LY"), 2004);
    // Forward is square to LX; nothing came before.
    assert_eq!(code("CUTTER/1\nFROM/-5,-5,0\nGO/TO,LX\nTLRGT,GOFWD/LX,ON,LY"), 2006);
    assert_eq!(code("CUTTER/1\nFROM/-5,-.5,0\nTLRGT,GOFWD/LX,ON,LY"), 2007);
    // Away from the check surface; met once only; not tangent.
    assert_eq!(code("CUTTER/1\nFROM/-5,-5,0\nGO/TO,LX\nTLLFT,GOLFT/LX,ON,LY"), 2008);
    assert_eq!(code("CUTTER/1\nFROM/-5,-5,0\nGO/TO,LX\nTLRGT,GORGT/LX,ON,2,INTOF,LY"), 2008);
    assert_eq!(code("CUTTER/1\nFROM/-5,-5,0\nGO/TO,LX\nTLRGT,GORGT/LX,TANTO,C1"), 2009);
    // Too large for C2 from inside; parallel to the surface; on the surface; no check; no surface.
    assert_eq!(code("CUTTER/5\nFROM/.5,0,0\nGO/TO,C2"), 2010);
    assert_eq!(code("CUTTER/1\nFROM/-5,-5,0\nGO/TO,C1,TO,PL1,TO,LY"), 2011);
    assert_eq!(code("CUTTER/1\nFROM/-5,-5,0\nINDIRV/1,0,0\nGO/TO,LX"), 2012);
    assert_eq!(code("CUTTER/1\nFROM/-5,0,0\nGO/TO,LX"), 2013);
    assert_eq!(code("CUTTER/1\nFROM/-5,-5,0\nGO/TO,LX\nTLRGT,GORGT/LX"), 2014);
    assert_eq!(code("CUTTER/1\nFROM/-5,-5,0\nGO/TO,P1"), 2015);
}

#[test]
fn a_start_without_a_position_begins_at_zero_and_says_so() {
    let text = "CUTTER/1\nOUTTOL/1E-9\nGO/TO,L5";
    let ran = run(&forms(), text);
    assert_eq!(ran.code(), 2001);
    let known = run(&forms(), &text.replace("GO/", "FROM/0,0,0\nGO/")).clean();
    assert!((ran.end() - known.end()).norm() < 1e-12, "{:?} {:?}", ran.end(), known.end());
}

#[test]
fn after_a_failure_motions_are_skipped_up_to_the_next_position() {
    let text =
        "CUTTER/1\nFROM/-5,-5,0\nGO/TO,LX\nTLLFT,GOLFT/LX,ON,LY\nGOFWD/LX,ON,L5\nGODLTA/0,0,1
CUTTER/1\nGOTO/0,0,5\nGODLTA/0,0,1";
    let ran = run(&forms(), text);
    assert_eq!(ran.code(), 2008);
    let lines: Vec<u32> = ran.motions().map(|(l, _)| l).collect();
    assert_eq!(lines, [2, 3, 8, 9]);
}

#[test]
fn a_tool_on_the_other_side_stays_there_with_a_warning() {
    for calc in ["2DCALC", "3DCALC"] {
        let text = format!("{calc}\nCUTTER/1\nFROM/-5,-5,0\nGO/TO,LX\nTLLFT,GORGT/LX,ON,LY");
        let ran = run(&forms(), &text);
        assert_eq!(ran.code(), 2005);
        assert!((ran.end() - Vec3::new(0.0, -0.5, 0.0)).norm() < 1e-12);
    }
}

#[test]
fn a_cutter_that_stands_in_its_check_surface_is_told_so() {
    for (calc, x, told) in [
        ("2DCALC", "0", true),
        ("3DCALC", "0", true),
        ("2DCALC", "2", false),
        ("3DCALC", "2", false),
    ] {
        let text = format!(
            "{calc}\nCUTTER/1\nFROM/{x},-5,0\nGO/TO,LX\nINDIRV/1,0,0\nTLRGT,GOFWD/LX,TO,LY"
        );
        let ran = run(&forms(), &text);
        assert_eq!(ran.code(), 2008, "{text}");
        let notes = format!("{:?}", ran.diagnostics[0].notes);
    assert!(notes.contains("5 high, stands in ACROSS all the way"), "{notes}");
    let short = told("CUTTER/.4,0,.2,0,0,0,1");
    assert!(short.diagnostics.is_empty(), "{:?}", short.diagnostics);
}

#[test]
fn failures_in_space_have_their_reasons_and_numbers() {
    let mut f = forms();
    f.insert("BOWL".into(), form("SPHERE", &[0.0, 0.0, 0.0, 3.0]).expect("a sphere"));
    f.insert("FAR".into(), form("SPHERE", &[50.0, 0.0, 0.0, 3.0]).expect("a sphere"));
    let told = |text: &str| {
        let ran = run(&f, &format!("3DCALC\nINTOL/0\nOUTTOL/.001\n{text}"));
        assert_eq!(ran.diagnostics.len(), 1, "{:?}", ran.diagnostics);
        let d = &ran.diagnostics[0];
        (d.code.number(), format!("{} {:?}", d.message, d.notes))
    };
    // A ball of radius 4 in a sphere of radius 3.
    let (code, text) = told("CUTTER/8,4\nFROM/.5,0,-4\nGO/TO,BOWL");
    assert!(
        code == 2010 && text.contains("cutter radius 4") && text.contains("surface 3"),
        "{code} {text}"
    );
    // Two spheres that no ball of radius 1 touches at once.
    let (code, text) = told("CUTTER/2,1\nFROM/20,0,0\nGO/TO,BOWL,TO,FAR");
    assert!(code == 2011 && text.contains("off BOWL") && text.contains("off FAR"), "{code} {text}");
    // The part surface that nobody gave, and that of AUTOPS, are called by what they are.
    let (code, text) = told("CUTTER/1\nFROM/-5,-.5,2\nINDIRV/1,0,0\nTLRGT,GOFWD/LX,ON,LY");
    let called = "not within tolerance of the part surface z=0 (no PSIS is given): 2 off";
    assert!(code == 2004 && text.contains(called), "{code} {text}");
    let (code, text) =
        told("CUTTER/1\nFROM/-5,-.5,2\nAUTOPS\nGODLTA/0,0,1\nINDIRV/1,0,0\nTLRGT,GOFWD/LX,ON,LY");
    let called = "not within tolerance of the part surface of AUTOPS: 1 off";
    assert!(code == 2004 && text.contains(called), "{code} {text}");
    // Off the drive surface by three quarters.
    let (code, text) = told("CUTTER/1\nFROM/-5,-1.25,0\nINDIRV/1,0,0\nTLRGT,GOFWD/LX,ON,LY");
    assert!(code == 2003 && text.contains("0.75 off it"), "{code} {text}");
    // Past the check surface: how near it came and after how much travel.
    let (code, text) =
        told("CUTTER/1\nFROM/-5,0,0\nINDIRV/1,0,0\nTLON,GOFWD/LX,TO,(SPHERE/0,9,0,3)");
    assert!(code == 2008 && text.contains("5.5 from it"), "{code} {text}");
}

#[test]
fn a_start_between_surfaces_that_nearly_touch_holds_both_bands() {
    let mut f = forms();
    f.insert(
        "CN".into(),
        form("CIRCLE", &[5.0, 3.0, 0.0, 0.0, 0.0, 1.0, 2.9998]).expect("a circle"),
    );
    let start = |outtol: &str, go: &str| {
        run(&f, &format!("CUTTER/1\nINTOL/0\nOUTTOL/{outtol}\nFROM/4,-2,0\nGO/{go}"))
    };
    // They miss each other by .0002: halfway each is .0001 off, on one of them the other is .0002 off.
    for (outtol, y) in [(".001", 0.0001), (".00015", 0.0001)] {
        let end = start(outtol, "ON,CN,ON,LX").clean().end();
        assert!((end.x - 5.0).abs() < 1e-12 && (end.y - y).abs() < 1e-12, "{end:?}");
    }
    assert_eq!(start(".00005", "ON,CN,ON,LX").code(), 2011);
    // Below both, where halfway would be in the line, the place that touches the line is taken.
    let end = start(".001", "TO,CN,TO,LX").clean().end();
    assert!((end.x - 5.0).abs() < 1e-12 && (end.y + 0.5).abs() < 1e-12, "{end:?}");
}

/// The motion says which CUTTER it is, and its values.
#[test]
fn a_cutter_that_is_no_solid_is_named() {
    let ran = run(&forms(), "FROM/0,-5,0\nCUTTER/1,0,0,0,60,40,5\nGO/TO,LX");
    let said = ran.diagnostics[0].message.clone();
    assert_eq!(ran.code(), 2022);
    assert!(said.contains("(CUTTER/1,0,0,0,60,40,5 of line "), "{said}");
}

#[test]
fn tolerances_that_leave_no_band_are_told_once() {
    let told = |tolerances: &str| {
        let text = format!("CUTTER/1\n{tolerances}\nFROM/-5,-5,0\nGO/TO,LX\nTLRGT,GORGT/LX,ON,LY");
        let ran = run(&forms(), &text);
        ran.diagnostics.iter().map(|d| (d.code.number(), d.is_error())).collect::<Vec<_>>()
    };
    assert_eq!(told("INTOL/0\nOUTTOL/0"), [(1307, false)]);
    assert_eq!(told("OUTTOL/0\nINTOL/.001"), []);
    assert_eq!(told("INTOL/0"), []);
}
