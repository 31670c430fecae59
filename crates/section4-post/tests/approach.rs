//! From the retracted place to a part beside turned axes, under controls that keep the tool end on its path.

mod common;

use aptc_geometry::{Vec3, trig};
use aptc_post::{Carries, machine, machines, post_all, prove};
use common::{good, records};
use proptest::prelude::*;

const HEAD: &str =
    "UNITS/MM\nCUTTER/8\nMULTAX\nLOADTL/2,LENGTH,80\nSPINDL/3000,CLW\nCOOLNT/ON\nFEDRAT/500\n";
const LEANING: &str = "FROM/-30,60,90,0,0,1\nRAPID\nGOTO/-34.6,60,40,.4330127,.75,.5\n\
    GOTO/-30,60,38,.4330127,.75,.5\n";

fn program(way: &str) -> String {
    format!("{HEAD}{way}FINI")
}

/// The blocks from the first that turns an axis to the first cut, without numbers.
fn approach(nc: &str) -> Vec<String> {
    let bare = |l: &str| {
        let l = l.split_once(' ').filter(|(n, _)| n.trim_start_matches('N').parse::<u32>().is_ok());
        l.map(|(_, rest)| rest.to_owned())
    };
    let lines = nc.lines().map(|l| bare(l).unwrap_or_else(|| l.to_owned()));
    let turns = |l: &String| ["A60", "A+60", "B60"].iter().any(|w| l.contains(w));
    let cut = |l: &String| l.starts_with("G1 ") || (l.contains(" F") && !l.contains("FMAX"));
    lines.skip_while(|l| !turns(l)).take_while(|l| !cut(l)).collect()
}

#[test]
fn a_leaning_tool_turns_goes_across_in_its_plane_and_comes_down_along_its_axis() {
    let plane = ["PLANE SPATIAL SPA-56.3099 SPB+25.6589 SPC-16.1021 TURN FMAX", "PLANE RESET STAY"];
    let cycle = "CYCLE800(0,\"\",200000,57,0,0,0,-56.3099,25.6589,-16.1021,0,0,0,1,0,1)";
    for (name, wanted) in [
        (
            "fanuc-31i-5axis",
            vec![
                "G0 A60. C30.",
                "G68.2 X0. Y0. Z0. I-30. J-60. K0.",
                "G53.1",
                "X-59.964 Y-17.31",
                "G69",
                "G43.4 H2 X-34.6 Y60. Z40.",
            ],
        ),
        (
            "haas-umc",
            vec!["G0 B60. C120.", "G254", "X17.31 Y-59.964", "G255", "G234 H2 X-34.6 Y60. Z40."],
        ),
        (
            "siemens-840d-5axis",
            vec![
                "G0 A60 C30",
                cycle,
                "X-59.9645 Y-17.3103",
                "CYCLE800()",
                "TRAORI",
                "D1 X-34.6 Y60 Z40",
            ],
        ),
        (
            "heidenhain-tnc-5axis",
            vec![
                "L A+60 C+30 FMAX",
                plane[0],
                "L X-59.9645 Y-17.3103 FMAX",
                plane[1],
                "M128",
                "L X-34.6 Y+60 Z+40 FMAX",
            ],
        ),
    ] {
        assert_eq!(approach(&good(name, &program(LEANING))), wanted, "{name}");
    }
}

fn value(line: &str, letter: char) -> Option<f64> {
    line.split_whitespace().find_map(|w| w.strip_prefix(letter)?.parse().ok())
}

/// `v` turned about `axis` anticlockwise.
fn turned(v: Vec3, axis: Vec3, degrees: f64) -> Vec3 {
    let (s, c) = (trig::sin_deg(degrees), trig::cos_deg(degrees));
    v * c + axis.cross(&v) * s + axis * (axis.dot(&v) * (1.0 - c))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]
    /// The tables of a machine turn the part about any places: where its linear axes stand for a place of the part is the
    /// place turned, and a shift that is the same for all. So what the block across and the block down have of X and Y
    /// must be the same place turned.
    #[test]
    fn only_the_axis_along_the_tool_moves_in_the_last_block(
        at in (-90.0..90.0_f64, -90.0..90.0_f64, 0.0..90.0_f64),
        lean in (-1.0..1.0_f64, -1.0..1.0_f64, 0.1..1.0_f64),
        spin in any::<bool>(),
    ) {
        let axis = if spin { Vec3::z() } else { Vec3::new(lean.0, lean.1, lean.2).normalize() };
        for m in machines().filter(|m| m.multiaxis.tool_center) {
            // Upright tools too come to a table that was turned before.
            let [te, ta] = [at, (axis.x, axis.y, axis.z)].map(|(x, y, z)| format!("{x},{y},{z}"));
            let before = "FROM/0,0,90,0,0,1\nRAPID\nGOTO/0,0,80,.3,.2,.8\nRAPID\nGOTO/0,0,95,0,0,1\n";
            let text = program(&format!("{before}GOHOME\nRAPID\nGOTO/{te},{ta}\n"));
            let records = records(&text);
            let (nc, posted) = post_all(m, Default::default(), &records);
            let errors: Vec<_> = posted.diagnostics.iter().filter(|d| d.is_error()).collect();
            // Beyond the limits of its tables.
            if errors.iter().any(|d| d.code.to_string() == "APT4004") { continue; }
            prop_assert!(errors.is_empty(), "{} {errors:#?}\n{nc}", m.name);
            let lines: Vec<&str> = nc.lines().collect();
            let down = lines.iter().rposition(|l| value(l, 'Z').is_some() && value(l, 'X').is_some());
            let down = down.expect("it comes to X Y Z");
            let across = lines[..down].iter().rfind(|l| value(l, 'X').is_some()).expect("across");
            let last = |letter| lines[..down].iter().rev().find_map(|l| value(l, letter)).expect("turned");
            let tables: Vec<(Vec3, f64)> =
                m.rotary.iter().map(|r| (Vec3::from(r.axis), last(r.letter))).collect();
            prop_assert!(m.rotary.iter().all(|r| r.carries == Carries::Part));
            let beside = |v: Vec3| tables.iter().rev().fold(v, |v, (axis, a)| turned(v, *axis, *a));
            prop_assert!((beside(axis) - Vec3::z()).norm() < 1e-3, "{}\n{nc}", m.name);
            let place = beside(Vec3::from(["X", "Y", "Z"].map(|l| {
                value(lines[down], l.chars().next().expect("a letter")).expect("a place")
            })));
            for (c, letter) in [(place.x, 'X'), (place.y, 'Y')] {
                let c = c - value(across, letter).expect("a place");
                prop_assert!(c.abs() < 0.005, "{} {c}\n{nc}", m.name);
            }
        }
    }
}

/// What stands in place of a leaning approach is read as the controls read it, and refused.
#[test]
fn a_tool_that_comes_down_aslant_is_found() {
    for (name, find, put) in [
        // X and Y of the part before the control is on, then Z alone.
        (
            "fanuc-31i-5axis",
            "G0 A60. C30.\nG68.2 X0. Y0. Z0. I-30. J-60. K0.\nG53.1\nX-59.964 Y-17.31\nG69\nG43.4 H2 X-34.6 Y60. Z40.",
            "G0 X-34.6 Y60. A60. C30.\nG43.4 H2 Z40.",
        ),
        // At once, from wherever the tool was.
        ("fanuc-31i-5axis", "X-59.964 Y-17.31\n", ""),
        ("fanuc-31i-5axis", "X-59.964", "X-59.9"),
        ("fanuc-31i-5axis", "J-60.", "J60."),
        // The control is never on, or goes off too soon.
        ("fanuc-31i-5axis", "G43.4 H2 X", "G43 H2 X"),
        ("fanuc-31i-5axis", "G1 X-30.", "G49\nG1 X-30."),
        ("fanuc-31i-5axis", "G1 X-30.", "G43 H2\nG1 X-30."),
        ("haas-umc", "G1 X-30.", "G43 H2\nG1 X-30."),
        // The tables turn on the way down.
        ("fanuc-31i-5axis", "G0 A60. C30.", "G0 A60. C29."),
        ("haas-umc", "G255\n", ""),
        ("haas-umc", "G234 H2", "G43 H2"),
        ("siemens-840d-5axis", "N190 TRAORI\n", ""),
        ("siemens-840d-5axis", "N170 X-59.9645 Y-17.3103\n", ""),
        ("heidenhain-tnc-5axis", "14 M128\n", ""),
        ("heidenhain-tnc-5axis", "X-59.9645", "X-34.6"),
    ] {
        let m = machine(name).expect("built in");
        let cl = program(LEANING);
        let nc = good(name, &cl);
        let broken = nc.replacen(find, put, 1);
        assert_ne!(broken, nc, "{name} {find}\n{nc}");
        let list = |text: &str| {
            prove(m, &mut records(&cl).into_iter(), &mut text.as_bytes()).expect("it is read").1
        };
        assert!(list(&nc).is_empty(), "{name}\n{nc}");
        assert!(!list(&broken).is_empty(), "{name} {find}\n{broken}");
    }
}

/// A machine file without a tilted plane, and a head that leans: the control is on first, and the tool comes down from
/// above its place.
#[test]
fn without_a_plane_the_tool_comes_down_from_above_its_place() {
    let mut m = machine("fanuc-31i-5axis").expect("built in").clone();
    (m.multiaxis.plane_on, m.multiaxis.plane_off) = (Vec::new(), Vec::new());
    let (nc, posted) = post_all(&m, Default::default(), &records(&program(LEANING)));
    assert!(!posted.diagnostics.iter().any(|d| d.is_error()), "{nc}");
    let blocks = ["G0 A60. C30.", "G43.4 H2 X-12.949 Y97.5 Z65.", "X-34.6 Y60. Z40."];
    assert_eq!(approach(&nc), blocks, "{nc}");
    let (_, posted) =
        post_all(&m, Default::default(), &records(&program(&format!("CLRSRF/90\n{LEANING}"))));
    assert!(!posted.diagnostics.iter().any(|d| d.is_error()));
    let aslant = nc.replace("X-12.949", "X-12.5");
    let (_, list) = prove(&m, &mut records(&program(LEANING)).into_iter(), &mut aslant.as_bytes())
        .expect("read");
    assert!(!list.is_empty());
    let [a, b] = [machine("fanuc-31i-5axis"), machine("haas-umc")]
        .map(|m| m.expect("built in").rotary[0].clone());
    m.rotary = vec![a, b];
    m.rotary.iter_mut().for_each(|r| (r.carries, r.min) = (Carries::Tool, Some(-90.0)));
    (m.multiaxis.plane_on, m.multiaxis.plane_off) = (vec!["G68.2".into()], vec!["G69".into()]);
    let (nc, posted) = post_all(&m, Default::default(), &records(&program(LEANING)));
    assert!(!posted.diagnostics.iter().any(|d| d.is_error()), "{:#?}{nc}", posted.diagnostics);
    assert!(nc.contains("\nG43.4 H2 X-12.949 Y97.5 Z65.\nX-34.6 Y60. Z40.\n"), "{nc}");
}

/// The way out: up along Z of the machine with the control still on (Fanuc, whose G49 alone may move the tool), or
/// with it off before.
#[test]
fn the_control_ends_with_the_tool_retracted_or_before_a_place_of_the_machine() {
    let text = program(&format!("{LEANING}RETRCT\nGOTO/-20,60,38,.4330127,.75,.5\n"));
    for (name, out) in [
        ("fanuc-31i-5axis", "G91 G28 Z0.\nG90 G49\n"),
        ("haas-umc", "G49\nG53 G0 Z0.\n"),
        ("siemens-840d-5axis", "TRAFOOF|G0 SUPA Z0 D0"),
        ("heidenhain-tnc-5axis", "M129|L Z-1 R0 FMAX M91"),
    ] {
        let nc = good(name, &text);
        if let Some((off, home)) = out.split_once('|') {
            let lines: Vec<&str> = nc.lines().collect();
            let at = lines.iter().position(|l| l.ends_with(off)).expect("off");
            assert!(lines[at + 1].ends_with(home), "{name}\n{nc}");
        } else {
            assert!(nc.contains(out), "{name}\n{nc}");
        }
    }
}

/// After RETRCT a cut goes on where the last one ended: down to there, the last part at the feed.
#[test]
fn a_cut_that_goes_on_is_not_come_to_at_rapid() {
    let cut = |words: &str, next: &str| {
        format!(
            "UNITS/MM\nCUTTER/8\nLOADTL/1,LENGTH,80\nSPINDL/3000,CLW\nCOOLNT/ON\nFEDRAT/500\n{words}FROM/0,0,100\nRAPID\n\
             GOTO/0,0,5\nGOTO/0,0,-2\nRETRCT\n{next}FINI"
        )
    };
    for name in
        ["linuxcnc-mill", "linuxcnc-5axis", "fanuc-0i-mill", "heidenhain-tnc", "fanuc-31i-5axis"]
    {
        // Heights, and whether they are come to at feed, behind the first approach and cut.
        let heights = |words: &str, next: &str| -> Vec<(f64, bool)> {
            let nc = good(name, &cut(words, next));
            let part = |l: &&str| ["G53", "G28", "M91"].iter().all(|w| !l.contains(w));
            let feed = |l: &str| l.split(' ').any(|w| w == "G1" || w == "F500" || w == "F500.");
            let all = nc.lines().filter(part).filter_map(|l| Some((value(l, 'Z')?, feed(l))));
            all.skip(2).collect()
        };
        let on = "GOTO/20,0,-2\n";
        assert_eq!(heights("", on), [(0.0, false), (-2.0, true)], "{name}");
        assert_eq!(heights("CLRSRF/3\n", on), [(3.0, false), (-2.0, true)], "{name}");
        // At rapid to its own end.
        assert_eq!(heights("", "RAPID\nGOTO/20,0,4\n"), [(4.0, false)], "{name}");
        // Where it ended, deeper below it, around from it, and with another tool.
        let deep = [(0.0, false), (-2.0, true)];
        for next in [
            on,
            "GOTO/0,0,-2\nGOTO/20,0,-2\n",
            "GOTO/0,0,-20\n",
            "ARC/10,0,-2,0,0,1,10,-180\nGOTO/20,0,-2\n",
            "LOADTL/2,LENGTH,80\nSPINDL/900,CLW\nCOOLNT/ON\nGOTO/20,0,-2\n",
        ] {
            assert_eq!(heights("", next)[..2], deep, "{name} {next}");
            // At rapid to where the cut ended: it is found.
            let cl = cut("", next);
            let nc = good(name, &cl);
            let lines: Vec<&str> = nc.lines().collect();
            let at =
                lines.iter().rposition(|l| value(l, 'Z') == Some(-2.0)).expect("the last way down");
            let mut broken = lines.clone();
            let rapid = lines[at - 1].replace("Z+0", "Z-2").replace("Z0", "Z-2");
            assert_ne!(rapid, lines[at - 1], "{name} {next}\n{nc}");
            broken[at - 1] = &rapid;
            let m = machine(name).expect("built in");
            for (text, bad) in [(&lines, false), (&broken, true)] {
                let text = text.join("\n");
                let (_, list) = prove(m, &mut records(&cl).into_iter(), &mut text.as_bytes())
                    .expect("it is read");
                let found = list.iter().any(|d| d.message.contains("the last cut"));
                assert_eq!((found, list.is_empty()), (bad, !bad), "{name} {list:?}\n{text}");
            }
        }
        // Straight up nothing is cut.
        assert_eq!(heights("", "GOTO/0,0,4\n"), [(-2.0, false), (4.0, true)], "{name}");
    }
    let leaning = program(&format!("{LEANING}RETRCT\nGOTO/-20,60,38,.4330127,.75,.5\n"));
    let nc = good("fanuc-31i-5axis", &leaning);
    assert!(
        nc.contains("G69\nG43.4 H2 X-29.134 Y61.5 Z39.\nG1 X-30. Y60. Z38. F500.\nX-20."),
        "{nc}"
    );
}

/// A rapid motion that goes nowhere before the retract does not take the tool out of its cut.
#[test]
fn a_rapid_motion_of_no_length_does_not_end_a_cut() {
    let cl = "UNITS/MM\nCUTTER/8\nLOADTL/2\nSPINDL/3000,CLW\nCOOLNT/ON\nFEDRAT/500\nGOTO/0,0,5\nGOTO/0,0,-2\n\
              GOTO/9,0,-2\nRAPID\nGOTO/9,0,-2\nRETRCT\nGOTO/20,0,-2\nFINI";
    for name in ["haas-vf", "linuxcnc-mill", "linuxcnc-5axis-head", "heidenhain-tnc"] {
        let nc = good(name, cl);
        let lines: Vec<&str> = nc.lines().collect();
        let down =
            lines.iter().rposition(|l| value(l, 'Z') == Some(-2.0)).expect("the last way down");
        assert!(lines[down].contains('F') && !lines[down].contains("FMAX"), "{name} {nc}");
        let m = machine(name).expect("built in");
        let rapid = lines[down - 1].replace("Z+0", "Z-2").replace("Z0", "Z-2");
        assert_ne!(rapid, lines[down - 1], "{name}");
        let mut broken = lines.clone();
        broken[down - 1] = &rapid;
        let text = broken.join("\n");
        let list = prove(m, &mut records(cl).into_iter(), &mut text.as_bytes()).expect("read").1;
        assert!(list.iter().any(|d| d.message.contains("the last cut")), "{name} {list:?}\n{text}");
    }
}

/// A head that leans without such control: the first motions down stand beside the tool's own line, high above; the last
/// one goes along it.
#[test]
fn a_leaning_head_comes_down_along_its_tool() {
    for way in ["RAPID\n", ""] {
        let cl = program(&format!("{way}GOTO/0,0,0,.8,0,.6\nGOTO/10,0,0,.8,0,.6\n"));
        let m = machine("linuxcnc-5axis-head").expect("built in");
        let nc = good("linuxcnc-5axis-head", &cl);
        // 230 mm from the centre of the head to the tool end, and 50 above.
        let (above, down) = ("G0 X224 Y0 C0 B53.1301\nG43 H2 Z-62\n", "X184 Z-92");
        assert!(nc.contains(above) && nc.contains(down), "{nc}");
        let list = |text: &str| {
            prove(m, &mut records(&cl).into_iter(), &mut text.as_bytes()).expect("it is read").1
        };
        assert!(list(&nc).is_empty(), "{:?}", list(&nc));
        for x in ["G0 X184 Y0", "G0 X225 Y0"] {
            let aslant = nc.replace("G0 X224 Y0", x);
            assert_ne!(aslant, nc);
            assert!(!list(&aslant).is_empty(), "{aslant}");
        }
    }
}
