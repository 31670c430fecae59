//! Every built-in machine writes programs that are proved by reading back.

mod common;

use aptc_post::{Dialect, MachineKind, PostOptions, machines, post_all};
use common::{chords, records};

fn part() -> String {
    let arc = chords([10.0, 20.0, -1.0], 10.0, 0.0, 270.0, 60, 0.0);
    let full = chords([20.0, 10.0, -1.0], 10.0, -90.0, 360.0, 90, 0.0);
    let helix = chords([20.0, 10.0, -1.0], 10.0, -90.0, -400.0, 100, -2.0);
    format!(
        "PARTNO PLATE (5 MM)\nUNITS/MM\nLOADTL/1\nSPINDL/3000,CLW\nCOOLNT/ON\nFEDRAT/500\nFROM/0,0,100\n\
         RAPID\nGOTO/20,20,5\nGOTO/20,20,-1\n{arc}GOTO/20,0,-1\n{full}{helix}RAPID\nGOTO/10,0,50\nLOADTL/2\n\
         CYCLE/DRILL,DEPTH,8,MMPM,100,CLEAR,3\nGOTO/40,0,0\nGOTO/50,0,2\nGOTO/60,0,2\n\
         CYCLE/DEEP,DEPTH,8,STEP,3,MMPM,100,CLEAR,3,RTRCTO,20\nGOTO/40,10,0\nGOTO/50,10,0\nCYCLE/OFF\n\
         CYCLE/REAM,DEPTH,8,MMPM,50,CLEAR,3\nGOTO/40,0,0\nCYCLE/OFF\nDELAY/1.5\nRAPID\nGOTO/0,0,70\nSTOP\nFINI"
    )
}

#[test]
fn every_machine_posts_a_plate() {
    let records = records(&part());
    for m in machines().filter(|m| m.kind == MachineKind::Mill) {
        let (nc, posted) = post_all(m, PostOptions::default(), &records);
        let errors: Vec<_> = posted.diagnostics.iter().filter(|d| d.is_error()).collect();
        assert!(errors.is_empty(), "{}: {errors:#?}\n{nc}", m.name);
        if m.dialect == Dialect::Apt {
            assert!(nc.contains("CYCLE/DRILL,DEPTH,8") && nc.ends_with("FINI\n"), "{nc}");
            continue;
        }
        let proof = posted.proof.unwrap();
        assert!(proof.points > 200, "{} {proof:?}", m.name);
    }
}

#[test]
fn numbers_and_signs_of_optional_blocks_stand_on_blocks_alone() {
    let text = "PARTNO A\nSEQNO/10,INCR,10\nUNITS/MM\nLOADTL/1\nSPINDL/900,CLW\nCOOLNT/ON\nFEDRAT/500\nFROM/0,0,100\n\
                GOTO/0,0,5\nOPSKIP/ON\nDELAY/2\nOPSKIP/OFF\nGOTO/9,0,5\nFINI";
    let with_skip = |m: &&aptc_post::Machine| {
        m.kind == MachineKind::Mill && m.dialect != Dialect::Apt && !m.program.skip.is_empty()
    };
    for m in machines().filter(with_skip) {
        let (nc, posted) = post_all(m, PostOptions::default(), &records(text));
        let errors: Vec<_> = posted.diagnostics.iter().filter(|d| d.is_error()).collect();
        assert!(errors.is_empty(), "{}: {errors:#?}\n{nc}", m.name);
        assert!(nc.contains('/'), "{}: nothing is optional\n{nc}", m.name);
        let marks = nc.lines().filter(|l| l.contains('%') || l.contains("O0"));
        assert!(marks.clone().all(|l| l.starts_with(['%', 'O'])), "{}: {nc}", m.name);
    }
}

#[test]
fn every_cycle_of_every_machine_is_written_and_proved() {
    for m in machines().filter(|m| m.kind == MachineKind::Mill && m.dialect != Dialect::Apt) {
        for kind in m.cycles.keys() {
            // The left-handed way of the same cycle.
            let (kind, hand) =
                kind.strip_suffix("LEFT").map_or((kind.as_str(), "CLW"), |kind| (kind, "CCLW"));
            let text = format!(
                "UNITS/MM\nLOADTL/1\nSPINDL/400,{hand}\nCOOLNT/ON\nFEDRAT/500\nFROM/0,0,100\n\
                 CYCLE/{kind},DEPTH,16,STEP,4,DWELL,1,MMPM,500,CLEAR,5,RTRCTO,20\nGOTO/15,15,0\nGOTO/45,15,0\n\
                 CYCLE/OFF\nGOTO/0,0,30\nFINI"
            );
            let (nc, posted) = post_all(m, PostOptions::default(), &records(&text));
            let bad: Vec<_> = posted.diagnostics.iter().filter(|d| d.is_error()).collect();
            // A dwell that the control's cycle lacks may leave nothing but a refusal by name.
            let refused = bad.iter().all(|d| d.code.to_string() == "APT4006");
            assert!(refused, "{} {kind}: {bad:#?}\n{nc}", m.name);
            let text = text.replace("DWELL,1,", "");
            let (nc, posted) = post_all(m, PostOptions::default(), &records(&text));
            let bad: Vec<_> = posted.diagnostics.iter().filter(|d| d.is_error()).collect();
            assert!(bad.is_empty(), "{} {kind}: {bad:#?}\n{nc}", m.name);
        }
    }
}

#[test]
fn every_five_axis_machine_posts_a_leaning_tool() {
    let text = "UNITS/MM\nLOADTL/1,LENGTH,80\nSPINDL/3000,CLW\nCOOLNT/ON\nFEDRAT/500\nMULTAX\n\
        FROM/0,0,100,0,0,1\nRAPID\nGOTO/10,0,30,0,.2,1\nGOTO/20,5,10,.3,.1,1\nGOTO/30,5,12,.4,-.2,1\n\
        GOTO/0,-30,5,-.2,-.4,1\nCYCLE/DRILL,DEPTH,5,CLEAR,2\nGOTO/0,-30,0,-.2,-.4,1\nCYCLE/OFF\n\
        RAPID\nGOTO/0,-30,100,-.2,-.4,1\nFINI";
    let records = records(text);
    let mut n = 0;
    for m in machines().filter(|m| m.rotary.len() == 2) {
        n += 1;
        let (nc, posted) = post_all(m, PostOptions::default(), &records);
        let errors: Vec<_> = posted.diagnostics.iter().filter(|d| d.is_error()).collect();
        assert!(errors.is_empty(), "{}: {errors:#?}\n{nc}", m.name);
        let proof = posted.proof.unwrap();
        assert!(
            proof.points == 6 && proof.path_mm <= m.multiaxis.lintol + 0.001,
            "{} {proof:?}",
            m.name
        );
        if m.multiaxis.tool_center {
            let on = m.multiaxis.tool_center_on.split(' ').next().unwrap();
            assert!(nc.contains(on), "{}\n{nc}", m.name);
            assert!(nc.lines().count() < 60, "{}\n{nc}", m.name);
        }
    }
    assert!(n >= 9);
}

#[test]
fn grbl_is_read_by_linuxcnc_too() {
    let (nc, _) = common::post("grbl", &part());
    assert!(!nc.contains("G81") && !nc.contains("G98"), "{nc}");
    if let Some(r) = common::rs274(&nc) {
        let canon = r.unwrap_or_else(|e| panic!("{e}\n{nc}"));
        let points = [[40.0, 0.0, -8.0], [50.0, 0.0, -6.0], [40.0, 10.0, -8.0]];
        common::assert_reaches(&common::ends(&canon), &points, 1e-3);
    }
}

/// Native cycles and the single motions in their place reach the same depths and retract to the same heights.
#[test]
fn native_and_expanded_cycles_are_the_same() {
    let native = aptc_post::machine("linuxcnc-mill").unwrap();
    let mut expanded = native.clone();
    expanded.cycles.clear();
    let records = records(&part());
    let read = |m: &aptc_post::Machine| {
        let (nc, posted) = post_all(m, PostOptions::default(), &records);
        assert!(!posted.diagnostics.iter().any(|d| d.is_error()), "{nc}");
        Some(common::ends(&common::rs274(&nc)?.unwrap()))
    };
    let (Some(a), Some(b)) = (read(native), read(&expanded)) else { return };
    // The same feeds in the same order, and never a rapid motion lower than the other's.
    let cuts = |list: &[(String, [f64; 3])]| {
        let cut = |e: &&(String, [f64; 3])| e.0 == "STRAIGHT_FEED";
        list.iter().filter(cut).map(|e| e.1).collect::<Vec<_>>()
    };
    let bottoms = |list: Vec<[f64; 3]>| {
        // Pecks may differ in number: the deepest of each hole counts.
        let mut deepest: Vec<[f64; 3]> = Vec::new();
        for p in list {
            match deepest.last_mut() {
                Some(last) if (last[0] - p[0]).abs() + (last[1] - p[1]).abs() < 1e-6 => {
                    last[2] = last[2].min(p[2]);
                }
                _ => deepest.push(p),
            }
        }
        deepest
    };
    let (a, b) = (bottoms(cuts(&a)), bottoms(cuts(&b)));
    assert_eq!(a.len(), b.len());
    for (p, q) in a.iter().zip(&b) {
        assert!((0..3).all(|i| (p[i] - q[i]).abs() < 1e-4), "{p:?} {q:?}");
    }
}

#[test]
fn machin_names_lead_to_their_machines() {
    for m in machines() {
        for name in &m.machin {
            let (name, args) = match name.split_once(',') {
                Some((n, i)) => (n, vec![aptc_cldata::Arg::Number(i.parse().unwrap())]),
                None => (name.as_str(), vec![]),
            };
            assert_eq!(aptc_post::machine_for(name, &args).unwrap().name, m.name);
        }
        assert_eq!(aptc_post::machine(&m.name).unwrap().name, m.name);
    }
    assert!(aptc_post::machine_for("NOSUCH", &[]).is_none());
}
