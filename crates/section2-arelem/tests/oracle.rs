//! Programs that another APT system has run: the same positions, no more cut vectors.

mod support;

use aptc_geometry::Vec3;
use support::{Forms, Run, expected, form, forms_of, run};

/// Each statement ends where the oracle's does, with at most as many points.
fn agree(ours: &Run, theirs: &[Vec<Vec3>], tolerance: f64, ratio: f64) {
    let mut ours_by_line: Vec<(u32, Vec<Vec3>)> = Vec::new();
    for (line, m) in ours.motions() {
        let points = m.points.iter().map(|p| p.te);
        match ours_by_line.last_mut() {
            Some(last) if last.0 == line => last.1.extend(points),
            _ => ours_by_line.push((line, points.collect())),
        }
    }
    for ((line, o), t) in ours_by_line.iter().zip(theirs) {
        let (a, b) = (o[o.len() - 1], t[t.len() - 1]);
        assert!((a - b).norm() <= 2.0 * tolerance + 1e-4, "line {line}: {a} for {b}");
        let limit = ratio * t.len() as f64;
        assert!(o.len() as f64 <= limit, "line {line}: {} vectors for {}", o.len(), t.len());
    }
    assert_eq!(ours_by_line.len(), theirs.len(), "statements with motion");
}

fn check(program: &str, text: &str, take: std::ops::Range<usize>, tolerance: f64) {
    let (Some(forms), Some(theirs)) = (forms_of(program), expected(program)) else { return };
    let take = take.start..take.end.min(theirs.len());
    agree(&run(&forms, text).clean(), &theirs[take], tolerance, 1.0);
}

#[test]
fn window() {
    let text = "CUTTER/.2\nFROM/SPT\nGODLTA/0,0,-.2\nAUTOPS\nGO/TO,C2\nTLLFT,GOLFT/C2,TANTO,C4
GOFWD/C4,TANTO,C1\nGOFWD/C1,TANTO,C3\nGOFWD/C3,TANTO,C2\nGODLTA/0,0,-.2\nAUTOPS
GOFWD/C2,TO,L1\nGOFWD/C2,PAST,L1";
    check("window", text, 0..99, 0.0005);
}

#[test]
fn spool_window_with_implied_check_surfaces() {
    let text = "CUTTER/.21875\nFROM/SPT\nGO/TO,C2\nTLLFT,GOLFT/C2\nGOFWD/C4\nCOOLNT/1\nGOFWD/C1
GOFWD/C3\nGOFWD/C2,PAST,LX";
    check("spoolLT", text, 0..99, 0.0005);
}

#[test]
fn canted_plane() {
    let text =
        "CUTTER/.25,.125\nFROM/SETPT\nGO/ON,LY,TO,PL1\nTLON,TLOFPS,GORGT/LY,ON,LX\nGOLFT/LX,ON,L2";
    check("plane_cant", text, 0..4, 0.0005);
}

#[test]
fn sample_part() {
    let text =
        "CUTTER/.25\nFROM/-.5,-.5,2\nGO/TO,LY,ON,PL2\nTLLFT,GOLFT/LY,TANTO,C2\nGOFWD/C2,TANTO,L1
GOFWD/L1,PAST,L3\nGORGT/L3,PAST,L2\nGORGT/L2,TANTO,C3\nGOFWD/C3,TANTO,LX\nGOFWD/LX,TANTO,C1
GOFWD/C1,TANTO,C4\nGOFWD/C4,ON,L4\nGOTO/-.5,-.5,0\nCUT";
    check("doc-samplePart.full", text, 0..12, 0.0005);
}

#[test]
fn square_profile() {
    // The oracle turned this path by 45 degrees: it is compared with its own closed form.
    let Some(forms) = forms_of("square") else { return };
    let text = "CUTTER/.5\nFROM/-1,0,.3\nGO/TO,L5,ON,PL1\nTLLFT,GOLFT/L5\nGOLFT/L7,PAST,L1
GORGT/L1,PAST,L8\nGORGT/L8\nGOLFT/L5,PAST,L4";
    let ran = run(&forms, text).clean();
    let want = [
        (-1.0, -1.875),
        (1.875, -1.875),
        (1.875, 0.25),
        (3.125, 0.25),
        (3.125, -1.875),
        (5.25, -1.875),
    ];
    let got: Vec<_> = ran.motions().skip(1).map(|(_, m)| m.points[0].te).collect();
    assert_eq!(got.len(), want.len());
    for (g, w) in got.iter().zip(want) {
        assert!((g.x - w.0).abs() + (g.y - w.1).abs() + (g.z + 0.03).abs() < 1e-7, "{g} for {w:?}");
    }
}

#[test]
fn pocket_frame_with_a_start_up_to_three_surfaces() {
    let text = "CUTTER/.5\nPSIS/PL1\nFROM/SETPT\nGO/TO,L1,TO,PL1,TO,LY\nINDIRV/1,0,0\nTLRGT\nGOFWD/L1,TANTO,C2
GOFWD/C2,TANTO,L4\nGOFWD/L4,ON,LY\nGOTO/0,-1.5,1.25";
    check("pocket", text, 0..6, 0.0005);
}

/// How far inside of the corners given each pass of a POCKET lies, innermost first, and by how many points it goes.
fn depths(corners: &[(f64, f64)], numbers: &str) -> Vec<(f64, usize)> {
    let named = corners.iter().enumerate().map(|(i, (x, y))| (format!("P{i}"), [*x, *y, 0.0]));
    let forms: Forms = named.filter_map(|(p, at)| Some((p, form("POINT", &at)?))).collect();
    let points: Vec<String> = (0..corners.len()).map(|i| format!("P{i}")).collect();
    let ran = run(&forms, &format!("FROM/0,0,1\n{numbers},{}", points.join(","))).clean();
    let n = corners.len();
    let mut passes: Vec<(f64, usize)> = Vec::new();
    for te in ran.motions().skip(1).flat_map(|(_, m)| &m.points).map(|p| p.te) {
        let depth = |i: usize| {
            let ((ax, ay), (bx, by)) = (corners[i], corners[(i + 1) % n]);
            let (ux, uy) = (bx - ax, by - ay);
            (ux * (te.y - ay) - uy * (te.x - ax)).abs() / (ux * ux + uy * uy).sqrt()
        };
        let depth = (0..n).map(depth).fold(f64::INFINITY, f64::min);
        match passes.last_mut() {
            Some((last, count)) if (*last - depth).abs() < 1e-6 => *count += 1,
            _ => passes.push((depth, 1)),
        }
    }
    passes
}

fn same_passes(got: &[(f64, usize)], want: &[(f64, usize)]) {
    assert_eq!(got.len(), want.len(), "{got:?}");
    for (g, w) in got.iter().zip(want) {
        assert!((g.0 - w.0).abs() < 6e-5 && g.1 == w.1, "{got:?}");
    }
}

#[test]
fn passes_of_pockets_lie_where_apt_360_puts_them() {
    // A side vanishes and leaves a sharper corner: 3.4578 is nearer than the corners before would ask, and half a cut ends it.
    let four = [(7.87064, 1.21475), (-1.48353, 6.66463), (-6.29592, -4.18443), (6.90456, -3.42561)];
    let got = depths(&four, "CUTTER/.75\nPOCKET/.35625,1.6,1,35,30,20,0,0");
    let whole = [2.5423, 2.0005, 1.4587, 0.9168, 0.375, 0.0].map(|d| (d, 5));
    let inner = [(4.1462, 4), (3.9168, 4), (3.4578, 4), (3.0842, 5)];
    same_passes(&got, &[&inner[..], &whole].concat());
    // The rest is so narrow that a line clears it.
    let five = [
        (7.222, 2.61238),
        (-1.60775, 5.94906),
        (-6.85424, 3.13172),
        (-7.94285, 0.7246),
        (-3.72485, -5.37453),
    ];
    let got = depths(&five, "CUTTER/0.25\nPOCKET/0.1,1.8,0.6,35,30,20,0,0");
    same_passes(&got[..4], &[(4.1674, 2), (4.114, 4), (4.0333, 5), (3.8857, 5)]);
}

/// The places of a POCKET whose corners are given, from the plunge on.
fn pocket(corners: &[[f64; 3]], numbers: &str) -> Run {
    let named = corners.iter().enumerate().map(|(i, at)| (format!("P{i}"), *at));
    let forms: Forms = named.filter_map(|(p, at)| Some((p, form("POINT", &at)?))).collect();
    let points: Vec<String> = (0..corners.len()).map(|i| format!("P{i}")).collect();
    let text = format!("CUTTER/1\nFROM/0,0,2\nPOCKET/.4,.8,{numbers},{}", points.join(","));
    run(&forms, &text)
}

fn passes(ran: &Run) -> Vec<Vec3> {
    ran.motions().skip(1).flat_map(|(_, m)| &m.points).map(|p| p.te).collect()
}

#[test]
fn walls_of_a_pocket_with_a_sloping_bottom_stand_along_the_tool_axis() {
    let corners = [[-2.0, -2.0, 0.6], [2.0, -2.0, -0.6], [2.0, 2.0, -0.6], [-2.0, 2.0, 0.6]];
    let ran = pocket(&corners, ".2,35,30,20,0,1");
    // The tool end lies on the bottom, and the rim reaches below it.
    assert_eq!(ran.code(), 2063);
    let got = passes(&ran);
    // As in APT-360.
    let want = [(-1.5, -1.5, 0.45), (1.5, -1.5, -0.45), (1.5, 1.5, -0.45), (-1.5, 1.5, 0.45)];
    for (g, w) in got[got.len() - 5..].iter().zip(want) {
        assert!((g - Vec3::new(w.0, w.1, w.2)).norm() < 1e-9, "{g} for {w:?}");
    }
}

#[test]
fn a_finish_cut_of_nothing_goes_round_once_more() {
    let corners = [[-2.0, -2.0, 0.0], [2.0, -2.0, 0.0], [2.0, 2.0, 0.0], [-2.0, 2.0, 0.0]];
    let got = passes(&pocket(&corners, "0,35,30,20,1,1").clean());
    // As in APT-360.
    let want = [0.3, 0.7, 1.1, 1.5, 1.5];
    let depths: Vec<f64> = got.chunks(5).map(|pass| pass[2].x).collect();
    assert_eq!(depths.len(), want.len(), "{got:?}");
    assert!(depths.iter().zip(want).all(|(d, w)| (d - w).abs() < 1e-9), "{depths:?}");
}

#[test]
fn past_the_second_intersection_from_a_start_on_the_check_surface() {
    let text = "CUTTER/.5\nPSIS/PL1\nFROM/2,-.25,.25\nDNTCUT\nPSIS/PL2\nGO/TO,L2,TO,PL2,TO,L5
TLLFT,GOFWD/L2,TANTO,C1\nCUT\nGOFWD/C1,PAST,2,INTOF,L5";
    let Some(forms) = forms_of("pocket") else { return };
    let end = run(&forms, text).clean().end();
    assert!((end.x - 2.5).abs() < 1e-9 && (end.y - 0.5f64.sqrt()).abs() < 1e-8, "{end}");
}

#[test]
fn pocket_from_the_inside_out() {
    let text = "CUTTER/.5\nFROM/2,-.25,1.25\nPOCKET/.2125,1.7,1.7,35,30,20,0,1,P2,P3,P4,P5,P1";
    let (Some(forms), Some(theirs)) = (forms_of("pocket"), expected("pocket")) else { return };
    let ours = run(&forms, text).clean();
    let ours: Vec<_> = ours.motions().skip(1).flat_map(|(_, m)| &m.points).map(|p| p.te).collect();
    let theirs = &theirs[7];
    assert_eq!(ours.len(), theirs.len());
    for (a, b) in ours.iter().zip(theirs) {
        assert!((a - b).norm() < 1e-6, "{a} for {b}");
    }
}
