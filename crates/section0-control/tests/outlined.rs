//! REGION on COMBIN: an outline goes on from patch to patch where these lie side by side, whatever their numbers.

#[path = "support/run.rs"]
mod run;

use std::sync::Arc;

use aptc_cldata::milling::{Area, Milling, Outline};
use aptc_cldata::{Control, Kind, Motion};
use aptc_control::{Disk, Options, Source, Verify, compile};
use aptc_diagnostics::Diagnostic;
use aptc_geometry::trig;
use aptc_verify::{Certificate, Effort, Verifier};

/// A box and a quadrangle askew, by their corners.
const BOX: [[f64; 2]; 4] = [[15.0, 32.0], [45.0, 32.0], [45.0, 8.0], [15.0, 8.0]];
const ASKEW: [[f64; 2]; 4] = [[12.0, 30.0], [50.0, 35.0], [44.0, 6.0], [20.0, 10.0]];

/// Meshes from joint to joint, along x or y, as one surface of 60 by 40 that rises by `rise`; every other one is turned half round.
fn sheets(rise: f64, joints: &[f64], along_x: bool) -> String {
    let z =
        |x: f64, y: f64| rise - 0.001 * rise * ((x - 30.0) * (x - 30.0) + (y - 20.0) * (y - 20.0));
    let mut text = String::new();
    for (k, w) in joints.windows(2).enumerate() {
        let across = [w[0], 0.5 * (w[0] + w[1]), w[1]];
        let (xs, ys) =
            if along_x { (across, [0.0, 20.0, 40.0]) } else { ([0.0, 30.0, 60.0], across) };
        let turned = |i: usize| if k % 2 == 1 { 2 - i } else { i };
        let point = |i: usize, j: usize| {
            let (x, y) = (xs[turned(i)], ys[turned(j)]);
            format!("$\n({x},{y},{:.6})", z(x, y))
        };
        let row = |j: usize| {
            let points: Vec<String> = (0..3).map(|i| point(i, j)).collect();
            format!("SPLINE,{}", points.join(","))
        };
        let rows: Vec<String> = (0..3).map(row).collect();
        text += &format!("F{k}=SSURF/SMESH,XYZ,{}\n", rows.join(","));
    }
    let names: Vec<String> = (1..joints.len()).map(|k| format!("F{}", k - 1)).collect();
    text + &format!("F=SSURF/COMBIN,{}\n", names.join(","))
}

/// A contour round the corners, recorded on F, and lines within or outside of it.
fn program(surface: &str, corners: &[[f64; 2]; 4], work: &str) -> String {
    let mut text = format!("UNITS/MM\n{surface}CUTTER/4,2\nINTOL/.01\nOUTTOL/.01\n");
    for (k, [x, y]) in corners.iter().enumerate() {
        let [p, q] = corners[(k + 1) % 4];
        let long = trig::hypot(p - x, q - y);
        let [a, b] = [(y - q) / long, (p - x) / long];
        text += &format!("L{k}=PLANE/{a:.9},{b:.9},0,{:.9}\n", a * x + b * y);
    }
    let ([x, y], [p, q]) = (corners[0], corners[1]);
    text + &format!(
        "CLDAT/START,1,UVPPS\nFROM/{x},{y},40\nGO/ON,L0,TO,F,ON,L3\nINDIRV/{},{},0\nTLON,GOFWD/L0,ON,L1\n\
         TLON,GORGT/L1,ON,L2\nTLON,GORGT/L2,ON,L3\nTLON,GORGT/L3,ON,L0\nCLDAT/NOMORE,1\nFROM/30,20,60\n{work}\nFINI\n",
        p - x,
        q - y
    )
}

const PASSES: &str = "GOMILL/F,UCONST,.03,STEPOV,.11,ZIGZAG,RETR,(PLANE/0,0,1,30)";

/// How far within the quadrangle a place is.
fn within(corners: &[[f64; 2]; 4], at: [f64; 3]) -> f64 {
    let side = |k: usize| {
        let ([x, y], [p, q]) = (corners[k], corners[(k + 1) % 4]);
        ((q - y) * (at[0] - x) - (p - x) * (at[1] - y)) / trig::hypot(p - x, q - y)
    };
    (0..4).map(side).fold(f64::INFINITY, f64::min)
}

/// Along every way at feed over the sheet the tool is within, or without, and it mills about as much as there is.
#[test]
fn lines_are_milled_on_all_patches_and_nowhere_else() {
    let mut n = 0;
    for rise in [0.0, 3.0] {
        for (along_x, joints) in [
            (false, &[0.0, 20.0, 40.0][..]),
            (false, &[0.0, 9.0, 40.0]),
            (false, &[0.0, 10.0, 24.0, 40.0]),
            (true, &[0.0, 18.0, 60.0]),
            (true, &[0.0, 14.0, 35.0, 60.0]),
        ] {
            let surface = sheets(rise, joints, along_x);
            for corners in [BOX, ASKEW] {
                let mut lengths = [0.0; 2];
                for (k, sense) in ["IN", "OUT"].into_iter().enumerate() {
                    let text = program(&surface, &corners, &format!("REGION/1,{sense}\n{PASSES}"));
                    let ran = run::run(&text, Verify::Full);
                    assert!(ran.faults().is_empty(), "{text} {:?}", ran.told);
                    for w in ran.places.windows(2).filter(|w| w[0][2].max(w[1][2]) < 8.0) {
                        let step = trig::hypot(w[1][0] - w[0][0], w[1][1] - w[0][1]);
                        lengths[k] += step;
                        for i in 0..=20 {
                            let t = 0.05 * f64::from(i);
                            let at = [0, 1, 2].map(|k| w[0][k] + (w[1][k] - w[0][k]) * t);
                            let far = within(&corners, at) * if k == 0 { 1.0 } else { -1.0 };
                            // The ball touches beside its middle.
                            assert!(
                                far > -0.5 * f64::from(u8::from(rise > 0.0)) - 0.02,
                                "{text} {at:?} {far}"
                            );
                            n += 1;
                        }
                    }
                }
                // All lines together are as long as the sheet lets them, each over one of the four patches of a mesh.
                let last = 4.0 * (joints.len() - 1) as f64;
                let lines = (0..1000).map(|k| 0.03 + 0.11 * f64::from(k)).take_while(|u| *u < last);
                let long = |u: f64| {
                    let mesh =
                        joints.windows(2).zip(1_u32..).find(|(_, n)| u < 4.0 * f64::from(*n));
                    mesh.map_or(0.0, |(w, _)| if along_x { 20.0 } else { 0.5 * (w[1] - w[0]) })
                };
                let whole: f64 = lines.map(long).sum();
                let sum: f64 = lengths.iter().sum();
                assert!((sum - whole).abs() < 0.1 * whole, "{surface} {lengths:?} {whole}");
                assert!(lengths.iter().all(|x| *x > 0.15 * whole), "{lengths:?} {whole}");
            }
        }
    }
    assert!(n > 10_000, "{n}");
}

/// The proof of a program's path under other promises.
fn changed(text: &str, change: impl Fn(&mut Area)) -> (Certificate, Vec<Diagnostic>) {
    let options = Options { verify: Verify::Off, post: false, ..Options::default() };
    let source = Source { name: "part".into(), text: text.into() };
    let compiled = compile(source, &mut Disk::new(Vec::new(), 0), &options);
    let mut verifier = Verifier::new(Effort::Full);
    let mut known: Vec<[Arc<Control>; 2]> = Vec::new();
    for mut record in compiled.parts[0].computed.to_vec().expect("they can be read") {
        if let Kind::Motion(Motion { control: Some(control), .. }) = &mut record.kind
            && let Some(Milling { limits: Some(limits), .. }) = &control.milling
        {
            let found = known.iter().find(|[old, _]| Arc::ptr_eq(old, control));
            let new = found.map(|[_, new]| Arc::clone(new)).unwrap_or_else(|| {
                let mut limits = limits.clone();
                limits.areas.iter_mut().for_each(&change);
                let milling =
                    control.milling.clone().map(|m| Milling { limits: Some(limits), ..m });
                let new = Arc::new(Control { milling, ..Control::clone(control) });
                known.push([Arc::clone(control), Arc::clone(&new)]);
                new
            });
            *control = new;
        }
        verifier.push(&record);
    }
    verifier.finish()
}

/// Outlines that are drawn straight from number to number of patches that are not side by side, that end at a joint, or that are
/// others than was recorded, prove nothing.
#[test]
fn an_outline_that_does_not_go_on_proves_nothing() {
    let line = "REGION/1,IN\nGOLOFT/F,UCONST,.5";
    let text = program(&sheets(0.0, &[0.0, 20.0, 40.0], false), &BOX, line);
    let (right, said) = changed(&text, |_| {});
    assert!(right.is_proved() && said.is_empty(), "{said:?}");
    let wrong: [&dyn Fn(&mut Area); 4] = [
        &|area| {
            let straight = |corners: &Vec<[f64; 2]>| {
                let next = corners.iter().cycle().skip(1);
                let lines = corners.iter().zip(next).map(|(a, b)| [*a, *b]).collect();
                Outline { lines, along: 0 }
            };
            area.outlines = area.recorded.iter().map(straight).collect();
        },
        &|area| {
            for o in &mut area.outlines {
                o.lines.retain(|l| l[0][0].max(l[1][0]) <= 4.0);
            }
        },
        &|area| {
            let ends = area.outlines.iter_mut().flat_map(|o| &mut o.lines).flatten();
            ends.filter(|end| end[1] > 0.0 && end[1] < 1.0).for_each(|end| end[1] *= 0.8);
        },
        &|area| area.outlines.clear(),
    ];
    for (k, change) in wrong.into_iter().enumerate() {
        let (c, said) = changed(&text, change);
        assert!(!c.is_proved() && !said.is_empty(), "{k} {c}");
    }
}

/// A level curve over a ridge that is a joint is one outline.
#[test]
fn a_level_curve_over_a_joint_holds_what_is_above_it() {
    let surface = sheets(8.0, &[0.0, 20.0, 40.0], false);
    for (sense, high) in [("IN", true), ("OUT", false)] {
        let text = format!(
            "UNITS/MM\n{surface}CUTTER/4,2\nINTOL/.01\nOUTTOL/.01\nCLDAT/START,1,UVPPS\n\
             INTSEC/(PLANE/0,0,1,6),WITH,F\nCLDAT/NOMORE,1\nFROM/30,20,60\nREGION/1,{sense}\n{PASSES}\nFINI\n"
        );
        let ran = run::run(&text, Verify::Full);
        let wrong: Vec<_> = ran.faults().into_iter().filter(|code| code != "APT2052").collect();
        assert!(wrong.is_empty(), "{text} {:?}", ran.told);
        let low: Vec<_> = ran.places.iter().filter(|te| te[2] < 12.0).collect();
        assert!(low.len() > 20);
        for te in low {
            assert!((te[2] > 5.8) == high || (te[2] - 6.0).abs() < 0.3, "{te:?}");
        }
    }
}

/// Two small surfaces beside a large one have no whole border in one place with it.
#[test]
fn where_no_joint_is_found_it_is_refused() {
    let patch = |name: &str, [x, y]: [f64; 2], [p, q]: [f64; 2]| {
        format!(
            "{name}=SSURF/SMESH,XYZ,SPLINE,({x},{y},0),({p},{y},0),SPLINE,({x},{q},0),({p},{q},0)\n"
        )
    };
    let surface = patch("F0", [0.0, 0.0], [60.0, 20.0])
        + &patch("F1", [0.0, 20.0], [30.0, 40.0])
        + &patch("F2", [30.0, 20.0], [60.0, 40.0])
        + "F=SSURF/COMBIN,F0,F1,F2\n";
    let ran = run::run(&program(&surface, &BOX, &format!("REGION/1,IN\n{PASSES}")), Verify::Full);
    assert!(ran.faults().contains(&"APT2055".to_owned()), "{:?}", ran.told);
    // What stays on one of them, or goes over from the second to the third, is milled.
    for (corners, n) in [
        ([[15.0, 16.0], [45.0, 16.0], [45.0, 8.0], [15.0, 8.0]], 2),
        ([[15.0, 36.0], [45.0, 36.0], [45.0, 26.0], [15.0, 26.0]], 4),
    ] {
        let text = program(&surface, &corners, &format!("REGION/1,IN\n{PASSES}"));
        let ran = run::run(&text, Verify::Full);
        assert!(ran.faults().is_empty(), "{text} {:?}", ran.told);
        let low: Vec<_> = ran.places[1..].iter().filter(|te| te[2] < 8.0).collect();
        assert!(low.len() > n && low.iter().all(|te| within(&corners, **te) > -0.02), "{low:?}");
    }
}

/// Three ruled sheets round an axis, and a contour on the first and the last of them.
const ROUND: &str = "UNITS/MM
A0=SCURV/CURSEG,(0.0,6.836313,-26.624652),(0.0,26.475781,-7.391905),$
 (0.0,19.639468,19.232746)
B0=SCURV/CURSEG,(55.605045,5.321825,-19.702798),(55.605045,22.015523,$
 -3.354817),(55.605045,16.204605,19.27634)
R0=SSURF/RULED,A0,B0
A1=SCURV/CURSEG,(0.0,19.639468,19.232746),(0.0,-6.836313,26.624652),$
 (0.0,-26.475781,7.391905)
B1=SCURV/CURSEG,(55.605045,16.204605,19.27634),(55.605045,-6.300011,$
 25.559516),(55.605045,-22.993709,9.211535)
R1=SSURF/RULED,A1,B1
A2=SCURV/CURSEG,(0.0,-26.475781,7.391905),(0.0,-19.639468,-19.232746),$
 (0.0,6.836313,-26.624652)
B2=SCURV/CURSEG,(55.605045,-22.993709,9.211535),(55.605045,-17.182791,$
 -13.419622),(55.605045,5.321825,-19.702798)
R2=SSURF/RULED,A2,B2
RG=SSURF/COMBIN,R2,R1,R0
PA=PLANE/1.0,0.0,0.0,8.355646
PB=PLANE/1.0,0.0,0.0,34.187026
F1=PLANE/0.0,0.999158,-0.04102,0.0
F2=PLANE/0.0,0.624048,0.781386,0.0
CUTTER/12.0,1.2,4.8,1.2,0,0,40.0
INTOL/0.005
OUTTOL/0.005
MULTAX
FROM/8.355646,-2.406248,-56.380849,0.0,-0.04102,-0.999158
TLAXIS/NORMPS
CLDAT/START,1,UVPPS
GO/ON,PA,TO,RG,ON,F1
INDIRV/0,0.999158,-0.04102
TLON,TLOFPS,GOFWD/PA,ON,F2
INDIRV/1,0,0
GOFWD/F2,ON,PB
INDIRV/0,-0.624048,-0.781386
GOFWD/PB,ON,F1
INDIRV/-1,0,0
GOFWD/F1,ON,PA
CLDAT/NOMORE,1
";

/// The last sheet goes on where the first began: between their stretches of a line the tool goes nowhere, though the sheet between them
/// in their row is left out. The line is one, which GCLEAR does not interrupt.
#[test]
fn stretches_that_meet_at_a_joint_are_one() {
    let line = "REGION/1,IN\nGOLOFT/RG,VCONST,.354752\nREGION/OFF\nNOPOST\nFINI\n";
    let plain = run::run(&format!("{ROUND}{line}"), Verify::Full);
    assert!(plain.faults().is_empty(), "{:?}", plain.told);
    let away = "GCLEAR/AWAY,NORMAL,9\nGCLEAR/BACK,NORMAL,9\n";
    let cleared = run::run(&format!("{ROUND}{away}{line}"), Verify::Full);
    assert!(cleared.faults().is_empty(), "{:?}", cleared.told);
    assert!(plain.places.len() > 10 && plain.places == cleared.places);
    // Where something lies between it is told.
    let line = line.replace("1,IN", "1,OUT");
    let told = run::run(&format!("{ROUND}{line}"), Verify::Full).faults();
    assert!(told.contains(&"APT2057".to_owned()), "{told:?}");
}
