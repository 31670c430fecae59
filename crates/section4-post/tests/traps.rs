//! What posts are known to get wrong, each with its test.
//!
//! | trap | test |
//! |---|---|
//! | radii of an arc that differ after rounding | `radii_agree_after_rounding` |
//! | R arcs near half a turn | `r_arcs_stay_away_from_half_a_turn` |
//! | giant arcs that are almost straight | `almost_straight_arcs_are_lines` |
//! | a missing decimal point | `every_length_has_its_point` |
//! | first motion after a tool change | `after_a_tool_change_across_then_down` |
//! | order of G49 and G43 | `the_length_offset_ends_retracted_and_begins_with_z` |
//! | block of the unit | `the_unit_stands_alone_before_any_length` |
//! | a cycle and the modal Z after it | `z_is_said_again_after_a_cycle` |
//! | a rotary axis at 360 degrees | `rotary_axes_go_on_over_a_turn` |
//! | RAPID before an arc | `at_rapid_an_arc_is_gone_around` |
//! | arcs in another plane | `arcs_name_their_plane_and_leave_it` |

mod common;

use aptc_geometry::trig;
use aptc_post::{Dialect, Machine, MachineKind, PostOptions, machine, machines, post_all};
use common::{chords, good, records, rs274};
use proptest::prelude::*;

const HEAD: &str =
    "UNITS/MM\nCUTTER/6\nLOADTL/1\nSPINDL/3000,CLW\nCOOLNT/ON\nFEDRAT/500\nFROM/0,0,100\n";

/// The number after a letter.
fn value(line: &str, letter: char) -> Option<f64> {
    let at = line.find(letter)?;
    let rest = &line[at + 1..];
    let end = rest.find(|c: char| !matches!(c, '0'..='9' | '.' | '-')).unwrap_or(rest.len());
    rest[..end].parse().ok()
}

fn by_radius() -> Machine {
    let mut m = machine("grbl").expect("built in").clone();
    m.arcs.as_mut().expect("arcs").center = aptc_post::ArcCenter::Radius;
    m.format.insert('R', m.format[&'X']);
    m
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]
    #[test]
    fn radii_agree_after_rounding(
        x in -200.0..200.0_f64, y in -200.0..200.0_f64, r in 0.02..300.0_f64,
        from in 0.0..360.0_f64, sweep in -360.0..360.0_f64, inch: bool,
    ) {
        prop_assume!(sweep.abs() > 1.0);
        let scale = if inch { 25.4 } else { 1.0 };
        let [x, y, r] = [x, y, r].map(|v| v / scale);
        let start = from.to_radians();
        let unit = if inch { "INCHES" } else { "MM" };
        let (sx, sy) = (x + r * trig::cos(start), y + r * trig::sin(start));
        let text = format!(
            "{}GOTO/{sx},{sy},0\n{}FINI",
            HEAD.replace("UNITS/MM", &format!("UNITS/{unit}")),
            chords([x, y, 0.0], r, from, sweep, 40, 0.0)
        );
        for name in ["linuxcnc-mill", "haas-vf", "grbl"] {
            let m = machine(name).expect("built in");
            let tolerance = 2.0 * m.arcs.as_ref().expect("arcs").radius_tolerance / scale;
            let (nc, posted) = post_all(m, PostOptions::default(), &records(&text));
            prop_assert!(!posted.diagnostics.iter().any(|d| d.is_error()), "{}", nc);
            let (mut at, mut arcs) = ([0.0; 2], 0);
            for line in nc.lines().filter(|l| !l.starts_with('(')) {
                let end = [value(line, 'X').unwrap_or(at[0]), value(line, 'Y').unwrap_or(at[1])];
                if let (Some(i), Some(j)) = (value(line, 'I'), value(line, 'J')) {
                    arcs += 1;
                    let [one, two] = [trig::hypot(i, j), trig::hypot(end[0] - at[0] - i, end[1] - at[1] - j)];
                    prop_assert!((one - two).abs() <= tolerance, "{} {}: {} {}", name, line, one, two);
                }
                at = end;
            }
            prop_assert!(arcs <= 4);
        }
    }
}

#[test]
fn r_arcs_stay_away_from_half_a_turn() {
    let m = by_radius();
    for sweep in [90.0, 170.0, 179.9, 180.0, 180.1, 270.0, 359.9, 360.0] {
        let text =
            format!("{HEAD}GOTO/20,0,0\n{}FINI", chords([0.0; 3], 20.0, 0.0, sweep, 90, 0.0));
        let (nc, posted) = post_all(&m, PostOptions::default(), &records(&text));
        assert!(!posted.diagnostics.iter().any(|d| d.is_error()), "{nc}");
        let arcs: Vec<_> = nc.lines().filter(|l| l.contains('R')).collect();
        let n = arcs.len();
        assert!(n >= 1 && sweep / f64::from(u32::try_from(n).unwrap_or(1)) < 115.0, "{sweep} {nc}");
        assert!(
            arcs.iter().all(|l| value(l, 'R').is_some_and(|r| (r - 20.0).abs() < 0.01)),
            "{nc}"
        );
    }
}

/// Reading back refuses the straight way to the end, which crosses what the arc goes around.
#[test]
fn at_rapid_an_arc_is_gone_around() {
    let mills = machines().filter(|m| m.kind == MachineKind::Mill && m.dialect != Dialect::Apt);
    // In a plane, and as a helix, whose pieces move the tool axis too.
    for (machine, z) in mills.flat_map(|m| [(m, 0), (m, -6)]) {
        let text =
            format!("{HEAD}GOTO/20,0,0\nRAPID\nARC/0,0,0,0,0,1,20,180\nGOTO/-20,0,{z}\nFINI");
        let (nc, posted) = post_all(machine, PostOptions::default(), &records(&text));
        let wrong = posted.diagnostics.iter().find(|d| d.is_error());
        assert!(wrong.is_none(), "{}: {wrong:?}\n{nc}", machine.name);
        let top =
            nc.replace('+', "").lines().filter_map(|line| value(line, 'Y')).fold(0.0, f64::max);
        assert!((top - 20.0).abs() < 0.1, "{}: {nc}", machine.name);
    }
}

/// No control here has arcs in such planes: lines within the tolerance, held against the arc itself.
#[test]
fn arcs_in_leaning_planes_become_lines_that_keep_to_them() {
    let head = "UNITS/MM\nLOADTL/1\nSPINDL/3000,CLW\nCOOLNT/ON\nFEDRAT/500\nFROM/0,0,50\n";
    for (radius, tolerance) in [(3.25, 0.0005), (10.0, 0.01), (250.0, 0.02), (2.0, 0.05)] {
        let text = format!(
            "{head}OUTTOL/{tolerance}\nGOTO/{radius},0,0\nARC/0,0,0,0,.6,.8,{radius},130\nGOTO/{:.9},{:.9},{:.9}\n\
             RAPID\nGOTO/0,0,90\nFINI",
            radius * -0.642_787_610,
            radius * 0.766_044_443 * 0.8,
            radius * 0.766_044_443 * -0.6
        );
        for machine in ["linuxcnc-mill", "grbl", "heidenhain-tnc-5axis"] {
            let (nc, posted) = common::post(machine, &text);
            let bad: Vec<_> = posted.diagnostics.iter().filter(|d| d.is_error()).collect();
            assert!(bad.is_empty(), "{machine} {radius} {bad:#?}\n{nc}");
            assert!(posted.proof.unwrap().points > 2, "{machine}");
        }
        // A chord that leaves the arc is found.
        let nc = good("linuxcnc-mill", &text);
        let lines: Vec<&str> = nc.lines().filter(|l| l.starts_with('X')).collect();
        let Some(middle) = lines.get(lines.len() / 2).filter(|_| lines.len() > 4) else { continue };
        let wrong = nc.replace(&format!("{middle}\n"), "");
        let wrong = wrong.replace(&format!("{}\n", lines[lines.len() / 2 - 1]), "");
        let machine = machine("linuxcnc-mill").unwrap();
        let mut records = records(&text).into_iter();
        let (_, said) = aptc_post::prove(machine, &mut records, &mut wrong.as_bytes()).unwrap();
        assert!(!said.is_empty(), "{radius}\n{wrong}");
    }
}

#[test]
fn almost_straight_arcs_are_lines() {
    // A circle of 30 metres, and one of 9 metres along a millimetre: no centre that a control could hold to.
    for (r, sweep) in [(30_000.0, 0.5), (9_000.0, 0.006)] {
        let text = format!("{HEAD}GOTO/0,{r},0\n{}FINI", chords([0.0; 3], r, 90.0, sweep, 10, 0.0));
        let nc = good("linuxcnc-mill", &text);
        assert!(!nc.contains(" I"), "{nc}");
    }
    // Fitted arcs neither: see the tests of `fit`.
}

#[test]
fn every_length_has_its_point() {
    let text = format!(
        "{HEAD}RAPID\nGOTO/10,20,5\nGOTO/10,20,0\n{}CYCLE/DEEP,DEPTH,9,STEP,3,MMPM,100,CLEAR,2\nGOTO/40,0,0\nCYCLE/OFF\nDELAY/2\nFINI",
        chords([0.0, 20.0, 0.0], 10.0, 0.0, 90.0, 30, 0.0)
    );
    for m in machines().filter(|m| m.name.starts_with("fanuc") || m.name.starts_with("haas")) {
        if m.kind == MachineKind::Lathe {
            continue;
        }
        let nc = good(&m.name, &text);
        for line in nc.lines().filter(|l| !l.starts_with(['(', 'O', '%'])) {
            for word in line.split(' ') {
                let length =
                    word.starts_with(['X', 'Y', 'Z', 'I', 'J', 'K', 'R', 'Q', 'F', 'A', 'B', 'C']);
                assert!(!length || word.contains('.'), "{} {line}\n{nc}", m.name);
                // Speeds, tools and times in milliseconds have none.
                let whole = word.starts_with(['S', 'T', 'P', 'M', 'N', 'H', 'D']);
                assert!(!whole || !word.contains('.'), "{} {line}", m.name);
            }
        }
    }
}

#[test]
fn after_a_tool_change_across_then_down() {
    let text = format!(
        "{HEAD}RAPID\nGOTO/10,20,5\nGOTO/10,20,-1\nLOADTL/2\nRAPID\nGOTO/60,70,5\nGOTO/60,70,-2\nFINI"
    );
    for m in machines().filter(|m| m.kind == MachineKind::Mill) {
        if m.dialect == Dialect::Apt {
            continue;
        }
        let nc = good(&m.name, &text.replace("COOLNT/ON", "COOLNT/FLOOD"));
        let lines: Vec<&str> = nc.lines().collect();
        let change = lines
            .iter()
            .rposition(|l| l.contains("T2") || l.contains("TOOL CALL 2") || l.contains("TOOL 2"));
        let after = &lines[change.unwrap_or(0)..];
        let is = |l: &&&str, a: &str, b: &str| l.contains(a) && l.contains(b);
        let across = after.iter().position(|l| is(&l, "X", "60") && is(&l, "Y", "70"));
        let down = after.iter().position(|l| l.contains("Z5") || l.contains("Z+5"));
        let (across, down) = (across.expect("across"), down.expect("down"));
        assert!(across < down && !after[across].contains('Z'), "{}\n{nc}", m.name);
    }
}

#[test]
fn the_length_offset_ends_retracted_and_begins_with_z() {
    let text = format!(
        "{HEAD}RAPID\nGOTO/10,20,5\nGOTO/10,20,-1\nLOADTL/2\nRAPID\nGOTO/60,70,5\nGOTO/60,70,-2\nFINI"
    );
    for m in machines().filter(|m| m.kind == MachineKind::Mill && m.dialect == Dialect::Rs274) {
        if m.compensation.length.is_empty() {
            continue;
        }
        let nc = good(&m.name, &text);
        let mut z_known = false;
        for line in nc.lines() {
            if line.contains("G49") || line.contains("G28 Z") || line.contains("G53") {
                z_known = false;
            }
            let begins = line.contains("G43") || line.contains("G234");
            // Never a Z of the part without the offset, and the offset in the block of that Z.
            let z = line.contains('Z') && !line.contains("G53") && !line.contains("G28");
            assert!(!z || z_known || begins, "{}: {line}\n{nc}", m.name);
            assert!(!begins || line.contains('Z'), "{}: {line}\n{nc}", m.name);
            z_known |= begins;
        }
    }
}

#[test]
fn the_unit_stands_alone_before_any_length() {
    for (unit, code) in [("MM", "G21"), ("INCHES", "G20")] {
        let text = format!("{}GOTO/1,2,3\nLOADTL/2\nGOTO/2,2,2\nFINI", HEAD.replace("MM", unit));
        for m in machines().filter(|m| m.dialect == Dialect::Rs274 && m.kind == MachineKind::Mill) {
            let nc = good(&m.name, &text);
            let at = nc.lines().position(|l| l == code).expect("the unit alone");
            let length = nc.lines().position(|l| {
                !l.starts_with('(') && l.contains(['X', 'Y', 'F']) && l.contains(['0', '1', '2'])
            });
            assert!(at < length.expect("a length"), "{}\n{nc}", m.name);
            // Said again at each tool change, where the operator may begin.
            let again = nc.lines().filter(|l| *l == code).count();
            assert!(
                again == 3 || m.program.tool_change.iter().all(|l| l != "{units}"),
                "{}\n{nc}",
                m.name
            );
        }
    }
}

#[test]
fn z_is_said_again_after_a_cycle() {
    // Down to -5 by a cut, a cycle whose Z is -5 too, and back to -5: the control knows Z as something else.
    let text = format!(
        "{HEAD}RAPID\nGOTO/0,0,2\nGOTO/0,0,-5\nRAPID\nGOTO/0,0,2\nCYCLE/DRILL,DEPTH,5,MMPM,100,CLEAR,2\n\
         GOTO/10,0,0\nGOTO/20,0,0\nCYCLE/OFF\nGOTO/20,0,-5\nGOTO/30,0,-5\nFINI"
    );
    for m in machines().filter(|m| m.kind == MachineKind::Mill && !m.program.start.is_empty()) {
        let nc = good(&m.name, &text.replace("COOLNT/ON", "COOLNT/FLOOD"));
        let lines: Vec<&str> = nc.lines().collect();
        let cut = |l: &&str| l.contains("X30") || l.contains("X+30");
        let last = lines.iter().rposition(cut).expect("the cut");
        let before = lines[last - 1];
        assert!(before.contains("Z-5"), "{}\n{nc}", m.name);
    }
    let nc = good("linuxcnc-mill", &text);
    assert!(rs274(&nc).is_none_or(|r| r.is_ok()));
}

#[test]
fn rotary_axes_go_on_over_a_turn() {
    // Twice around a cylinder in steps of ten degrees, the tool axis outward.
    let mut text = HEAD.replace("LOADTL/1", "LOADTL/1,LENGTH,80") + "MULTAX\n";
    for i in 0..=72 {
        let (s, c) = trig::sin_cos((f64::from(i) * 10.0).to_radians());
        text.push_str(&format!("GOTO/{i},{},{},0,{s},{c}\n", 30.0 * s, 30.0 * c));
    }
    text.push_str("FINI");
    // Angles that grow without end, and angles within a turn of which the control takes the nearest.
    let unwound = good("linuxcnc-4axis", &text);
    assert!(unwound.contains("A-720") || unwound.contains("A720"), "{unwound}");
    let m = {
        let mut m = machine("linuxcnc-4axis").expect("built in").clone();
        m.rotary[0].wrap = aptc_post::Wrap::Modulo;
        m
    };
    let (nc, posted) = post_all(&m, PostOptions::default(), &records(&text));
    assert!(!posted.diagnostics.iter().any(|d| d.is_error()), "{:?}", posted.diagnostics);
    let angles: Vec<f64> =
        nc.lines().filter_map(|l| value(l.strip_prefix("G").unwrap_or(l), 'A')).collect();
    assert!(angles.len() > 70 && angles.iter().all(|a| (0.0..360.0).contains(a)), "{nc}");
    assert!(posted.proof.is_some_and(|p| p.points == 73));
}

#[test]
fn arcs_name_their_plane_and_leave_it() {
    let text = format!(
        "{HEAD}GOTO/0,10,0\nARC/0,0,0,1,0,0,10,90\nGOTO/0,0,10\nGOTO/0,0,20\nARC/0,0,10,0,1,0,10,-90\nGOTO/-10,0,10\n\
         CYCLE/DRILL,DEPTH,5,MMPM,100,CLEAR,2\nGOTO/10,0,0\nCYCLE/OFF\nARC/0,0,2,0,0,1,10,90\nGOTO/0,10,2\nFINI"
    );
    for name in ["linuxcnc-mill", "fanuc-0i-mill", "haas-vf", "siemens-840d-mill"] {
        let nc = good(name, &text);
        let plane =
            |code: &str| nc.lines().position(|l| l.contains(&format!("{code} G"))).is_some();
        assert!(plane("G19") && plane("G18"), "{name}\n{nc}");
        // A cycle drills along Z: the plane is XY again before it.
        let lines: Vec<&str> = nc.lines().collect();
        let cycle =
            lines.iter().position(|l| l.contains("G81") || l.contains("CYCLE81")).expect("a cycle");
        let last = lines[..=cycle]
            .iter()
            .rev()
            .find_map(|l| ["G17", "G18", "G19"].into_iter().find(|p| l.contains(p)));
        assert_eq!(last, Some("G17"), "{name}\n{nc}");
    }
    let nc = good("linuxcnc-mill", &text);
    assert!(rs274(&nc).is_none_or(|r| r.is_ok()), "{nc}");
}
