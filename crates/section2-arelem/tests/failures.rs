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
        assert_eq!(notes.contains("stands in LY at the start"), told, "{text} {notes}");
    }
}

/// As APT-360: along an upright plane, without THICK; a circle and a leaning plane are refused.
#[test]
fn a_tool_on_an_upright_plane_stays_on_it_with_a_warning() {
    for side in ["TLLFT", "TLRGT"] {
        for (calc, before) in [("2DCALC", "FROM/-5,-2,3\nGO/ON,LX"), ("3DCALC", "FROM/-5,0,0")] {
            let text = format!(
                "{calc}\nCUTTER/1\n{before}\nINDIRV/1,0,0\n{side},GOFWD/LX,TO,LY\nTLON,GOFWD/LX,ON,LY"
            );
            let ran = run(&forms(), &text);
            assert_eq!(ran.code(), 2005, "{text}: {:?}", ran.diagnostics);
            let ends: Vec<_> =
                ran.motions().map(|(line, m)| (line, m.points.last().unwrap().te)).collect();
            let n = ends.len();
            assert!((ends[n - 2].1 - Vec3::new(-0.5, 0.0, 0.0)).norm() < 1e-3, "{text}: {ends:?}");
            assert!(ends[n - 1].1.norm() < 1e-3, "{text}: {ends:?}");
        }
    }
    // Beside it, within the width of the band: a needle is where the word wants it.
    let needle = run(&forms(), "CUTTER/0\nFROM/-5,0,0\nINDIRV/1,0,0\nTLLFT,GOFWD/LX,ON,LY");
    assert!(needle.diagnostics.is_empty(), "{:?}", needle.diagnostics);
    let on = "CUTTER/1\nFROM/-5,0,0\nINDIRV/1,0,0\n";
    assert_eq!(code(&format!("{on}THICK/0,.1\nTLLFT,GOFWD/LX,ON,LY")), 2003);
    assert_eq!(code("CUTTER/1\nFROM/-5,.3,0\nINDIRV/1,0,0\nTLLFT,GOFWD/LX,ON,LY"), 2003);
}

#[test]
fn the_words_of_a_refusal_have_names_and_numbers() {
    let ran = run(&forms(), "CUTTER/1\nFROM/-5,-1.25,0\nINDIRV/1,0,0\nTLRGT,GOFWD/LX,ON,LY");
    let text = &ran.diagnostics[0].message;
    assert!(text.contains("drive surface LX") && text.contains("0.75 off"), "{text}");
}

#[test]
fn srfvct_says_which_side_is_to() {
    let ran = run(&forms(), "CUTTER/1\nFROM/-5,0,0\nSRFVCT/0,1,0\nGO/TO,LX").clean();
    assert!((ran.end().y + 0.5).abs() < 1e-12);
    let ran = run(&forms(), "CUTTER/1\nFROM/-5,0,0\nSRFVCT/0,1,0\nGO/PAST,LX").clean();
    assert!((ran.end().y - 0.5).abs() < 1e-12);
}

#[test]
fn cut_after_dntcut_puts_out_the_position_and_cut_alone_does_not() {
    let ran =
        run(&forms(), "CUTTER/1\nFROM/-5,-5,0\nCUT\nDNTCUT\nGOTO/1,1,1\nGOTO/2,2,2\nCUT").clean();
    let lines: Vec<u32> = ran.motions().map(|(l, _)| l).collect();
    assert_eq!(lines, [2, 7]);
}

#[test]
fn the_first_check_surface_met_decides() {
    let mut arelem = aptc_arelem::Arelem::new(aptc_arelem::Options::default());
    let text = "CUTTER/1\nFROM/-5,-5,0\nGO/TO,LX\nTLRGT,GORGT/LX,TO,L5,TO,LY";
    let mut out = Vec::new();
    let mut last = aptc_protap::Outcome::None;
    for kind in text.lines().flat_map(|l| support::statement(&forms(), l)) {
        let record = aptc_protap::Record { origin: Default::default(), kind };
        last = arelem.execute(&record, &mut out);
    }
    let aptc_protap::Outcome::Moved { te, check, .. } = last else { panic!("{last:?}") };
    assert_eq!(check, 1);
    assert!((te.x + 0.5).abs() < 1e-12);
}

#[test]
fn a_thickness_that_a_pocket_does_not_have_is_told_once() {
    let mut f = forms();
    for (name, x, y) in [("A", 0.0, 0.0), ("B", 9.0, 0.0), ("C", 9.0, 9.0), ("D", 0.0, 9.0)] {
        f.insert(name.into(), form("POINT", &[x, y, 0.0]).expect("a point"));
    }
    let pocket = "POCKET/.4,.8,.6,35,30,20,0,1,A,B,C,D";
    let codes = |text: &str| -> Vec<u16> {
        run(&f, text).diagnostics.iter().map(|d| d.code.number()).collect()
    };
    let start = "CUTTER/1\nFROM/1,1,2";
    assert!(codes(&format!("{start}\n{pocket}")).is_empty());
    assert_eq!(codes(&format!("{start}\nTHICK/0,.1\n{pocket}\n{pocket}")), [1305]);
    assert_eq!(codes(&format!("{start}\nTHICK/.1\n{pocket}\nTHICK/.2\n{pocket}")), [1305, 1305]);
    assert!(codes(&format!("{start}\nTHICK/.1\nTHICK/0\n{pocket}")).is_empty());
    let bare = run(&f, &format!("FROM/1,1,2\n{pocket}"));
    assert_eq!(bare.code(), 2017);
    assert!(bare.diagnostics[0].message.contains("no CUTTER is given"));
}

#[test]
fn a_pocket_whose_cutter_is_not_as_flat_as_it_says_is_told_with_the_height() {
    let mut f = forms();
    for (name, x, y) in [("A", 0.0, 0.0), ("B", 92.0, 0.0), ("C", 92.0, 72.0), ("D", 0.0, 72.0)] {
        f.insert(name.into(), form("POINT", &[x, y, 0.0]).expect("a point"));
    }
    let said = |cutter: &str, numbers: &str| -> Vec<String> {
        let text = format!("CUTTER/{cutter}\nFROM/1,1,20\nPOCKET/{numbers},1,35,30,20,0,1,A,B,C,D");
        let told = run(&f, &text).diagnostics;
        assert!(told.iter().all(|d| d.code.number() == 2026 && !d.is_error()), "{told:?}");
        told.into_iter().map(|d| d.message).collect()
    };
    // Passes 8 apart: at their corners material is 8 / (1 + sin 45) from both, in the corner of the cutter.
    let far = 8.0 / (1.0 + 0.5_f64.sqrt());
    let high = 3.0 - (9.0 - (far - 2.0) * (far - 2.0)).sqrt();
    let told = said("10,3", "5,1.6");
    assert_eq!(told.len(), 1);
    let number = told[0].split(" high").next().and_then(|t| t.split_whitespace().last());
    let number: f64 = number.and_then(|n| n.parse().ok()).expect("a height");
    assert!((number - high).abs() < 1e-4, "{told:?} {high}");
    assert!(told[0].contains("radius 2, and the effective radius is 5"), "{told:?}");
    // With the flat end as the effective radius, a cutter that is as flat, or passes close enough nothing stands.
    assert!(said("10,3", "2,1.6").is_empty());
    assert!(said("10", "5,1.6").is_empty());
    assert!(said("10,3", "5,.4").len() == 1, "the innermost pass is 10 wide, and its middle stays");
}

#[test]
fn a_failure_has_a_picture_of_its_surfaces() {
    let mut arelem = aptc_arelem::Arelem::new(aptc_arelem::Options::default());
    let text = "CUTTER/1\nFROM/-5,-5,0\nGO/TO,LX\nTLLFT,GOLFT/LX,ON,C1";
    let mut out = Vec::new();
    for kind in text.lines().flat_map(|l| support::statement(&forms(), l)) {
        arelem.execute(&aptc_protap::Record { origin: Default::default(), kind }, &mut out);
    }
    let svg = arelem.take_situation().expect("the last motion failed").svg();
    assert!(svg.starts_with("<svg") && svg.ends_with("</svg>\n"));
    for word in ["drive surface LX", "check surface C1", "is not reached", "<polygon", "<path"] {
        assert!(svg.contains(word), "{word}: {svg}");
    }
    assert!(arelem.take_situation().is_none());
}

#[test]
fn a_start_that_nothing_decides_lists_its_positions_with_their_directions() {
    let mut f = forms();
    f.insert("DOME".into(), form("SPHERE", &[0.0, 0.0, 0.0, 5.0]).expect("a sphere"));
    f.insert("WALL".into(), form("PLANE", &[1.0, 0.0, 0.0, 0.0]).expect("a plane"));
    // The tool stands in its middle.
    f.insert(
        "RING".into(),
        form("CIRCLE", &[0.0, 9.0, 0.0, 0.0, 0.0, 1.0, 3.0]).expect("a circle"),
    );
    for (go, height) in
        [("GO/TO,C2,ON,LX", 0.0), ("GO/TO,RING", 0.0), ("3DCALC\nGO/ON,WALL,TO,DOME,TO,PL1", 2.0)]
    {
        let ran = |way: &str| {
            let from = if go.contains("DOME") { "9,0" } else { "0,9" };
            run(&f, &format!("CUTTER/1\nFROM/{from},{height}\n{way}\n{go}"))
        };
        // In the plane one of them is taken; in space the tie itself has no least way.
        let tie = ran("");
        let d = &tie.diagnostics[0];
        assert_eq!(tie.code(), if d.is_error() { 2011 } else { 2024 }, "{go} {d:?}");
        assert_eq!(d.is_error(), go.contains("DOME"));
        let notes: Vec<_> = d.notes.iter().filter(|n| n.contains(" leads to ")).collect();
        assert_eq!(notes.len(), 2, "{d:?}");
        for note in notes {
            // Each direction leads to the position that stands beside it.
            let (way, to) = note.split_once(" leads to ").expect("a direction and a position");
            let end = ran(way).clean().end();
            let at: Vec<f64> = to.split(',').map(|x| x.parse().expect("a number")).collect();
            for i in 0..3 {
                assert!((end[i] - at[i]).abs() < 1e-3, "{go}: {note} {end}");
            }
        }
    }
}

#[test]
fn a_motion_that_cannot_go_on_says_what_is_in_the_way() {
    let mut f = forms();
    let mut add = |name: &str, kind: &str, w: &[f64]| {
        f.insert(name.into(), form(kind, w).expect("a legal form"));
    };
    add("BOWL", "SPHERE", &[0.0, 0.0, 9.0, 9.0]);
    add("TUBE", "CYLNDR", &[0.0, 0.0, 6.0, 1.0, 0.0, 0.0, 6.0]);
    add("END", "PLANE", &[1.0, 0.0, 0.0, 7.0]);
    add("FAR", "PLANE", &[0.0, 1.0, 0.0, 3.0]);
    add("WALL", "PLANE", &[0.0, 1.0, 0.0, 0.0]);
    add("ACROSS", "PLANE", &[1.0, 0.0, 0.0, 0.0]);
    let told = |text: &str| {
        let ran = run(&f, &format!("3DCALC\nINTOL/0\nOUTTOL/.001\n{text}"));
        let d = &ran.diagnostics[0];
        (ran.code(), format!("{} {:?}", d.message, d.notes))
    };
    // A flat end that leans from the normal where it touches inside of a tube has two such places.
    let (code, text) = told(
        "MULTAX\nCUTTER/4,.2\nTLAXIS/ATANGL,1,5\nFROM/0,0,3\nGO/ON,ACROSS,TO,TUBE
INDIRV/0,1,0\nTLON,GOFWD/ACROSS,ON,FAR",
    );
    let parts = ["the motion to FAR ends at 0,", "TUBE", "from FAR at the nearest, after"];
    assert!(code == 2021 && parts.iter().all(|p| text.contains(p)), "{code} {text}");
    // A cutter with a wide top goes all round inside of a bowl, and is not sent round again.
    let (code, text) = told(
        "CUTTER/2,0,0,0,0,30,6\nFROM/0,0,5\nGO/ON,WALL,TO,BOWL\nINDIRV/1,0,0
TLON,GOFWD/WALL,ON,END",
    );
    assert!(code == 2008 && !text.contains("given up"), "{code} {text}");
}

/// Below the part surface that nobody gave GO lifts the tool, which is never meant; down to it is.
#[test]
fn a_tool_that_is_lifted_to_the_part_surface_is_told() {
    let told = |text: &str| {
        let ran = run(&forms(), &format!("CUTTER/1\n{text}"));
        ran.diagnostics.iter().map(|d| d.code.number()).collect::<Vec<_>>()
    };
    assert_eq!(told("FROM/-5,-3,-2\nGO/TO,LX"), [2028]);
    assert_eq!(told("FROM/-5,-3,2\nGO/TO,LX"), [0_u16; 0]);
    assert_eq!(told("FROM/-5,-3,-2\nAUTOPS\nGO/TO,LX"), [0_u16; 0]);
    assert_eq!(told("FROM/-5,-3,-2\nNOPS\nGO/TO,LX"), [0_u16; 0]);
    assert_eq!(told("FROM/-5,-3,-2\nGO/TO,LX,TO,PL1"), [0_u16; 0]);
    assert_eq!(told("PSIS/PL1\nFROM/-5,-3,-2\nGO/TO,LX"), [0_u16; 0]);
}

/// A tool along a cone leans to its axis and reaches every plane through it, if it is long: it never gets past one.
#[test]
fn a_long_tool_that_never_leaves_its_check_surface_is_told_its_height() {
    let mut f = forms();
    let cone = [0.0, 0.0, 4.0, 0.0, 0.0, -1.0, 0.939_692_620_785_908_4];
    f.insert("CN".into(), form("CONE", &cone).expect("a cone"));
    f.insert("ACROSS".into(), form("PLANE", &[1.0, 0.0, 0.0, 0.0]).expect("a plane"));
    f.insert("BESIDE".into(), form("PLANE", &[0.0, 1.0, 0.0, 0.0]).expect("a plane"));
    let told = |cutter: &str| {
        run(
            &f,
            &format!(
                "3DCALC\nINTOL/0\nOUTTOL/.001\nMULTAX\n{cutter}\nFROM/3,0,6\nTLAXIS/PARLEL,2\nINDIRV/-1,0,-2\n\
                 GO/ON,BESIDE,TO,PL1,TO,CN\nINDIRV/0,1,0\nTLRGT,GOFWD/CN,PAST,ACROSS"
            ),
        )
    };
    let ran = told("CUTTER/.4");
    assert_eq!(ran.code(), 2008, "{:?}", ran.diagnostics);
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

#[test]
fn a_turn_to_the_wrong_side_is_told_with_the_right_one() {
    let start = "CUTTER/1\nFROM/-5,-5,0\nGO/TO,LX\n";
    for calc in ["2DCALC\n", "3DCALC\n"] {
        for (motion, helped) in [
            ("TLRGT,GOLFT/LX,ON,LY", true),
            // The other way the tool would be on the wrong side.
            ("TLLFT,GOLFT/LX,ON,LY", false),
        ] {
            let ran = run(&forms(), &format!("{calc}{start}{motion}"));
            assert_eq!(ran.code(), 2008);
            let help = ran.diagnostics[0].help.clone().unwrap_or_default();
            assert_eq!(help == "GORGT leads to it", helped, "{calc}{motion} {help}");
        }
    }
}

#[test]
fn a_word_for_the_wrong_side_is_told_once_for_all_its_motions() {
    let start = "CUTTER/1\nFROM/-5,-5,0\nGO/TO,LX\nTLLFT,GORGT/LX,ON,LY\n";
    let told = |rest: &str| run(&forms(), &format!("{start}{rest}")).diagnostics.len();
    assert_eq!(told("GOFWD/LX,ON,L5"), 1);
    assert_eq!(told("TLLFT,GOFWD/LX,ON,L5"), 2);
}

/// Along the rulings of a cylinder a tool that leaves its check surface behind soon gives up.
#[test]
fn a_straight_track_ends_where_nothing_is_met_any_more() {
    let mut forms = forms();
    forms.insert("LOG".into(), form("CYLNDR", &[0.0, 0.0, -3.0, 0.0, 1.0, 0.0, 3.0]).expect("one"));
    let text = "CUTTER/1,.5\nFROM/0,-5,3\nPSIS/LOG\nGO/ON,LY\nINDIRV/0,-1,0\nTLON,GOFWD/LY,ON,LX";
    let ran = run(&forms, text);
    assert_eq!(ran.code(), 2008);
    let notes = ran.diagnostics[0].notes.join(" ");
    let gone = notes.split("after ").nth(1).and_then(|s| s.split(' ').next());
    let gone: f64 = gone.expect("how far").parse().expect("a number");
    assert!(gone < 200.0, "{notes}");
}

#[test]
fn an_axis_along_rulings_wants_a_surface_that_has_them() {
    let text = "CUTTER/1\nFROM/8,-1,3\nTLAXIS/PARLEL,1\nGO/TO,C1,ON,PL1\nTLRGT,GORGT/C1,ON,L5";
    let ran = run(&forms(), text);
    assert_eq!(ran.code(), 2020);
    let (message, help) = (&ran.diagnostics[0].message, ran.diagnostics[0].help.as_deref());
    assert!(message.contains("part surface PL1, which has none"), "{message}");
    assert_eq!(help, Some("write TLAXIS/PARLEL,2: C1 has them"));
}

#[test]
fn dntcut_to_the_end_is_told_with_the_motions_that_are_missing() {
    let told = |text: &str| {
        let ran = run(&forms(), &format!("CUTTER/1\nFROM/-5,-5,0\n{text}"));
        ran.diagnostics.iter().map(|d| (d.code.number(), d.message.clone())).collect::<Vec<_>>()
    };
    let motions = "GO/TO,LX\nTLRGT,GORGT/LX,ON,LY\nGODLTA/0,0,1";
    let three = "DNTCUT holds to the end of the part: 3 motions behind it are not put out";
    assert_eq!(told(&format!("DNTCUT\n{motions}")), [(2065, three.into())]);
    assert_eq!(told(&format!("DNTCUT\nGO/TO,LX\nDNTCUT\n{motions}")).len(), 1);
    let [(2065, one)] = &told("DNTCUT\nFROM/0,0,0\nGOTO/1,1,1")[..] else { panic!() };
    assert!(one.ends_with("the motion behind it is not put out"), "{one}");
    // Put out again, and without any motion.
    for text in ["DNTCUT\nGOTO/1,1,1\nCUT\nGOTO/2,1,1", "GOTO/1,1,1\nDNTCUT", "DNTCUT\nFROM/0,0,0"]
    {
        assert_eq!(told(text), [], "{text}");
    }
}

#[test]
fn a_tool_that_is_off_since_something_was_changed_is_told_what() {
    let notes = |text: &str| {
        let text = format!("CUTTER/1\nFROM/-5,-5,0\nGO/TO,LX\n{text}\nTLRGT,GORGT/LX,ON,LY");
        let ran = run(&forms(), &text);
        assert_eq!(ran.code(), 2003, "{text}");
        ran.diagnostics[0].notes.clone()
    };
    let said = |word: &str, line: u32| {
        format!("{word} was changed in line {line}, since the motion that brought the tool there")
    };
    assert_eq!(notes("CUTTER/2"), [said("CUTTER", 4)]);
    assert_eq!(notes("THICK/0,0\nTHICK/0,.3"), [said("THICK", 5)]);
    // As it was, and where no surface was come to.
    assert_eq!(notes("CUTTER/2\nCUTTER/1\nTHICK/0,.3"), [said("THICK", 6)]);
    assert!(notes("GOTO/-5,-3,0\nCUTTER/2").is_empty());
}

#[test]
fn a_check_surface_that_is_the_part_surface_is_told() {
    for word in ["TO", "ON", "PAST"] {
        let text = format!("CUTTER/1\nFROM/-5,-5,3\nGO/TO,LX,TO,PL1\nTLRGT,GORGT/LX,{word},PL1");
        let ran = run(&forms(), &text);
        assert_eq!(ran.code(), 2008, "{word}");
        let said = "the check surface PL1 is the part surface itself";
        let notes = &ran.diagnostics[0].notes;
        assert!(notes.iter().any(|n| n.starts_with(said)), "{notes:?}");
    }
}
