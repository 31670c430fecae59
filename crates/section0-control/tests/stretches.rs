//! Lines that REGION limits: the straight way from one stretch to the next is told, and so is the line it belongs to.

#[path = "support/run.rs"]
mod run;

use std::sync::Arc;

use aptc_cldata::milling::{Limits, Milling};
use aptc_cldata::{Control, Kind, Motion, Record};
use aptc_control::{Disk, Options, Source, Verify, compile};
use aptc_diagnostics::{Diagnostic, codes};
use aptc_verify::{Breach, Certificate, Effort, Verifier};

/// A surface of 60 by 60 with the window from 20 to 40 recorded as outline 1; and statements.
fn program(rise: f64, work: &str) -> String {
    let spline = |y: f64, z: f64| format!("SPLINE,(0,{y},{z}),(30,{y},{}),(60,{y},{z})", z + rise);
    let splines = [spline(0.0, 0.0), spline(30.0, rise), spline(60.0, 0.0)];
    format!(
        "UNITS/MM\nF=SSURF/SMESH,XYZ,{}\nCUTTER/4,2\nINTOL/.01\nOUTTOL/.01\n\
         PL=PLANE/1,0,0,20\nPR=PLANE/1,0,0,40\nPF=PLANE/0,1,0,20\nPB=PLANE/0,1,0,40\n\
         FROM/30,30,60\nCLDAT/START,1,UVPPS\nINDIRV/-1,1,0\nGO/ON,PB,TO,F,ON,PL\nINDIRV/0,-1,0\n\
         TLON,GOFWD/PL,ON,PF\nTLON,GOLFT/PF,ON,PR\nTLON,GOLFT/PR,ON,PB\nTLON,GOLFT/PB,ON,PL\n\
         CLDAT/NOMORE,1\n{work}\nFINI\n",
        splines.join(",$\n")
    )
}

#[test]
fn a_straight_way_through_the_window_is_told_once_a_region() {
    let two =
        "GOLOFT/F,VCONST,1,CHORD,.01\nGODLTA/0,0,40\nGOLOFT/F,VCONST,.9,CHORD,.01\nGODLTA/0,0,40";
    let ran = run::run(&program(0.0, &format!("REGION/1,OUT\n{two}")), Verify::Full);
    assert_eq!(ran.faults(), ["APT2057"], "{:?}", ran.told);
    let text = &ran.told.iter().find(|(code, _)| code == "APT2057").unwrap().1;
    assert!(
        text.contains("from the tool end 20, 30, 0 ") && text.contains(" at 40, 30, 0, "),
        "{text}"
    );
    let again = format!("REGION/1,OUT\n{two}\nREGION/1,OUT\n{two}");
    assert_eq!(run::run(&program(0.0, &again), Verify::Full).faults(), ["APT2057", "APT2057"]);
}

#[test]
fn nothing_is_told_where_there_is_no_such_way() {
    for work in [
        // One stretch of each line.
        "REGION/1,IN\nGOLOFT/F,VCONST,1,CHORD,.01",
        // The line passes the window.
        "REGION/1,OUT\nGOLOFT/F,VCONST,.5,CHORD,.01",
        "REGION/1,OUT\nGCLEAR/AWAY,NORMAL,5\nGCLEAR/BACK,NORMAL,5\nGOLOFT/F,VCONST,1,CHORD,.01",
        "REGION/1,OUT\nGCLEAR/ON,CLEARS,(PLANE/0,0,1,30)\nGOLOFT/F,VCONST,1,CHORD,.01",
        "GOLOFT/F,VCONST,1,CHORD,.01",
    ] {
        let ran = run::run(&program(0.0, work), Verify::Full);
        assert!(ran.faults().is_empty(), "{work}: {:?}", ran.told);
    }
}

/// The surface is flat, and the ball touches it below its end: it mills as far into the window as GCLEAR leads it on, and not where
/// it is lifted.
#[test]
fn what_gclear_adds_into_the_window_at_feed_is_told() {
    let line = "GOLOFT/F,VCONST,1,CHORD,.01";
    let (lift, high) = ("NORMAL,30", "CLEARS,(PLANE/0,0,1,30)");
    for (sense, clear, told) in [
        ("OUT", format!("GCLEAR/AWAY,MOTDIR,6,{high}\nGCLEAR/BACK,{lift}"), Some((6.0, 26.0))),
        ("OUT", format!("GCLEAR/AWAY,{lift}\nGCLEAR/BACK,MOTDIR,7"), Some((7.0, 33.0))),
        ("OUT", "GCLEAR/AWAY,MOTDIR,4\nGCLEAR/BACK,MOTDIR,3".into(), Some((9.5, 30.5))),
        ("OUT", format!("GCLEAR/BACK,{lift}\nGCLEAR/AWAY,MOTDIR,5"), Some((5.0, 25.0))),
        ("OUT", "GCLEAR/BACK,MOTDIR,5".into(), Some((9.375, 29.375))),
        ("IN", "GCLEAR/THRU,MOTDIR,5".into(), Some((5.0, 45.0))),
        ("IN", format!("GCLEAR/START,MOTDIR,8,{high}"), Some((8.0, 12.0))),
        ("IN", format!("GCLEAR/START,PARLEL,(VECTOR/-3,0,0),{high}"), Some((3.0, 17.0))),
        ("OUT", format!("GCLEAR/AWAY,MOTDIR,6,{lift}\nGCLEAR/BACK,MOTDIR,6,{lift}"), None),
        ("OUT", format!("GCLEAR/{high}\nGCLEAR/START,MOTDIR,9\nGCLEAR/THRU,MOTDIR,9"), None),
        ("IN", format!("GCLEAR/START,{lift}\nGCLEAR/THRU,MOTDIR,.005"), None),
    ] {
        let two = format!("{line}\nGODLTA/0,0,40\nGOLOFT/F,VCONST,.98,CHORD,.01\nGODLTA/0,0,40");
        let text = program(0.0, &format!("REGION/1,{sense}\n{clear}\n{two}"));
        let ran = run::run(&text, Verify::Full);
        assert_eq!(
            ran.faults(),
            vec!["APT2057"; usize::from(told.is_some())],
            "{clear} {:?}",
            ran.told
        );
        let Some((by, x)) = told else { continue };
        let said = &ran.told.iter().find(|(code, _)| code == "APT2057").unwrap().1;
        let words: Vec<&str> = said.split([' ', ',']).collect();
        let after = |word: &str, n: usize| {
            let i = words.iter().position(|w| *w == word).expect("it says so");
            words[i + n].parse::<f64>().expect("a number")
        };
        assert!((after("F", 1) - by).abs() < 0.05 && (after("end", 1) - x).abs() < 0.5, "{said}");
    }
}

#[test]
fn over_a_hill_the_way_is_refuted_or_refused() {
    let line = "REGION/1,OUT\nGOLOFT/F,VCONST,1,CHORD,.01";
    let ran = run::run(&program(4.0, line), Verify::Full);
    assert_eq!(ran.faults(), ["APT2057", "APT5001"], "{:?}", ran.told);
    let checked = format!("CHKSRF/PS,ON\n{line}");
    let ran = run::run(&program(4.0, &checked), Verify::Full);
    assert_eq!(ran.faults(), ["APT2046"], "{:?}", ran.told);
    let over = "on the way over what REGION leaves out";
    assert!(ran.told.iter().any(|(_, text)| text.contains(over)), "{:?}", ran.told);
}

/// Which lines are left out, and what else is told.
fn parted(said: Vec<Diagnostic>) -> (Vec<Diagnostic>, Vec<Diagnostic>) {
    said.into_iter().partition(|d| d.message.contains("which REGION leaves to be milled, about"))
}

/// The proof of a program's path under other promises.
fn changed(text: &str, change: impl Fn(&mut Milling)) -> (Certificate, Vec<Diagnostic>) {
    let options = Options { verify: Verify::Off, post: false, ..Options::default() };
    let source = Source { name: "part".into(), text: text.into() };
    let compiled = compile(source, &mut Disk::new(Vec::new(), 0), &options);
    let wrong: Vec<_> = compiled.diagnostics.iter().filter(|d| d.is_error()).collect();
    assert!(wrong.is_empty(), "{wrong:?}");
    let mut verifier = Verifier::new(Effort::Full);
    // Motions of one control stay so.
    let mut known: Vec<[Arc<Control>; 2]> = Vec::new();
    for mut record in compiled.parts[0].computed.to_vec().expect("they can be read") {
        if let Kind::Motion(Motion { control: Some(control), .. }) = &mut record.kind
            && let Some(milling) = &control.milling
        {
            let found =
                known.iter().find(|k| Arc::ptr_eq(&k[0], control)).map(|k| Arc::clone(&k[1]));
            let new = found.unwrap_or_else(|| {
                let mut milling = milling.clone();
                change(&mut milling);
                let new = Control { milling: Some(milling), ..Control::clone(control) };
                known.push([Arc::clone(control), Arc::new(new)]);
                Arc::clone(&known[known.len() - 1][1])
            });
            *control = new;
        }
        verifier.push(&record);
    }
    verifier.finish()
}

fn limits(milling: &mut Milling) -> &mut Limits {
    milling.limits.as_mut().expect("REGION limits it")
}

/// A path within an outline, held against what is outside of it, and the other way round. The ends of the stretches lie in both.
#[test]
fn what_is_milled_where_it_is_to_be_left_is_refuted() {
    let line = "GOLOFT/F,VCONST,1,CHORD,.01";
    let passes = "GOMILL/F,VCONST,0,STEPOV,.1,RETR,(PLANE/0,0,1,30)";
    let away = "GCLEAR/AWAY,NORMAL,15\nGCLEAR/BACK,NORMAL,15\n";
    let mut told = 0;
    for rise in [0.0, 4.0] {
        for cutter in ["4,2", "6,1", "3"] {
            for work in [format!("{away}{line}"), passes.to_owned()] {
                for sense in ["IN", "OUT"] {
                    let text = program(rise, &format!("CUTTER/{cutter}\nREGION/1,{sense}\n{work}"));
                    let right = changed(&text, |_| {});
                    let gouges = |said: &[Diagnostic]| {
                        said.iter().filter(|d| d.message.contains("cuts into")).count()
                    };
                    // A flat end that does not turn cuts into the hill beside its contact.
                    let (lines, rest) = parted(right.1);
                    assert!(lines.is_empty() && rest.len() == gouges(&rest), "{text} {rest:?}");
                    if !rest.is_empty() {
                        continue;
                    }
                    assert!(right.0.is_proved(), "{text} {}", right.0);
                    let wrong = changed(&text, |m| {
                        limits(m).lines.clear();
                        limits(m).areas.iter_mut().for_each(|a| a.inside = !a.inside);
                    });
                    let fault = wrong.0.statements.iter().filter_map(|s| s.fault.as_ref());
                    let most = fault
                        .filter(|f| f.breach == Some(Breach::Outside))
                        .map(|f| f.depth)
                        .fold(0.0, f64::max);
                    // From the middle of the window, and from a corner of the surface.
                    let far = match (sense, work.contains("GOLOFT")) {
                        ("IN", _) => 10.0,
                        (_, true) => 20.0,
                        (_, false) => 28.3,
                    };
                    assert!((0.85 * far..1.3 * far).contains(&most), "{text} {most} {:?}", wrong.1);
                    let words = "outside of what REGION leaves to be milled, at tool end";
                    assert!(wrong.1.iter().any(|d| d.message.contains(words)), "{:?}", wrong.1);
                    told += 1;
                }
            }
        }
    }
    assert!(told >= 16, "{told}");
}

/// The straight way over the window counts as milled where it is not one that is told.
#[test]
fn one_vector_over_the_window_is_refuted() {
    let text = program(0.0, "REGION/1,OUT\nGOLOFT/F,VCONST,1,CHORD,.01");
    assert!(changed(&text, |_| {}).0.is_proved());
    let (c, said) = changed(&text, |m| m.over = false);
    let fault = c.statements[0].fault.as_ref().expect("a fault");
    assert!(
        c.refuted == 1 && fault.breach == Some(Breach::Outside) && (fault.depth - 10.0).abs() < 0.1,
        "{said:?}"
    );
}

/// Lines of which nothing is milled, or a stretch is not.
#[test]
fn stretches_that_are_left_out_are_told() {
    let passes = "GOMILL/F,VCONST,0,STEPOV,.1,PICKFD,RETR,(PLANE/0,0,1,30)";
    for (rise, sense, n) in [(0.0, "IN", 28), (4.0, "IN", 28), (0.0, "OUT", 7), (4.0, "OUT", 7)] {
        let text = program(rise, &format!("REGION/1,{sense}\n{passes}"));
        let lines = changed(&text, |m| assert!(limits(m).lines.len() > 20)).0.left_out_lines;
        assert!(lines.is_empty(), "{lines:?}");
        // What was not milled is asked for instead.
        let flip = |m: &mut Milling| limits(m).areas.iter_mut().for_each(|a| a.inside = !a.inside);
        let (c, _) = changed(&text, flip);
        let other = if sense == "IN" { [0.0, 60.0] } else { [20.0, 40.0] };
        let within = c
            .left_out_lines
            .iter()
            .all(|l| (other[0] - 1e-6..other[1] + 1e-6).contains(&l.at[0]) && l.line.0 == "VCONST");
        assert!(
            within && !c.is_proved() && c.left_out_lines.len() == n,
            "{} {c}",
            c.left_out_lines.len()
        );
    }
}

/// The records of a program's path as far as they are kept, judged: the roles that have bounds, and what is told.
fn judged(text: &str, keep: impl Fn(&Motion) -> bool) -> (Vec<&'static str>, Vec<Diagnostic>) {
    let options = Options { verify: Verify::Off, post: false, ..Options::default() };
    let source = Source { name: "part".into(), text: text.into() };
    let compiled = compile(source, &mut Disk::new(Vec::new(), 0), &options);
    let mut verifier = Verifier::new(Effort::Full);
    let take = |r: &Record| match &r.kind {
        Kind::Motion(m) if m.control.as_ref().is_some_and(|c| c.milling.is_some()) && !keep(m) => {}
        _ => verifier.push(r),
    };
    compiled.parts[0].computed.for_each(take).expect("they can be read");
    let (certificate, said) = verifier.finish();
    let surfaces = certificate.statements.iter().flat_map(|s| &s.surfaces);
    (surfaces.map(|s| s.role).collect(), said)
}

/// A pass that is missing leaves a ridge within the outline and none beside it; without SCALOP nothing is asked.
#[test]
fn what_is_left_between_the_stretches_is_judged() {
    let lines = "GOMILL/F,VCONST,0,STEPOV,.05,SCALOP,.2,RETR,9";
    for (region, missing, told) in [
        ("REGION/1,IN", None, None),
        ("REGION/1,IN", Some([25.0, 35.0]), Some(codes::REFUTED)),
        ("REGION/1,OUT", None, None),
        ("REGION/1,OUT", Some([25.0, 35.0]), Some(codes::REFUTED)),
    ] {
        let gone = |m: &Motion| {
            let ys = m.points.iter().map(|p| p.te.y);
            missing.is_some_and(|[a, b]: [f64; 2]| ys.into_iter().all(|y| a < y && y < b))
        };
        let text = program(0.0, &format!("{region}\n{lines}"));
        let (roles, said) = judged(&text, |m| !gone(m));
        // Each stretch that is left out is told besides.
        let (lines, said) = parted(said);
        let codes: Vec<_> = said.iter().map(|d| d.code).collect();
        assert_eq!(codes, Vec::from_iter(told), "{region} {said:?}");
        assert_eq!(roles.contains(&"scallop"), told.is_none(), "{region} {roles:?}");
        assert_eq!(lines.is_empty(), told.is_none(), "{region} {lines:?}");
        if told.is_some() {
            assert!(said[0].message.contains("part surface F between the passes"), "{said:?}");
        }
        let (roles, said) = judged(&text.replace("SCALOP,.2,", ""), |m| !gone(m));
        let (lines, said) = parted(said);
        assert!(!roles.contains(&"scallop") && said.is_empty(), "{said:?}");
        assert_eq!(lines.is_empty(), told.is_none(), "{region} {lines:?}");
    }
}

/// A surface of 90 by 60 with the strip between two curves from border to border recorded as outline 1, the first at x 40, the
/// second at x 70 in a plane that faces this way; and statements.
fn strip(faces: f64, work: &str) -> String {
    let spline = |y: f64, z: f64| {
        let points = [(0, 0.0), (30, 2.0), (60, 0.0), (90, 1.0)];
        let points = points.map(|(x, more)| format!("({x},{y},{})", z + more * (1.0 + z)));
        format!("SPLINE,$\n{}", points.join(",$\n"))
    };
    let splines = [spline(0.0, 0.0), spline(30.0, 2.0), spline(60.0, 0.0)];
    format!(
        "UNITS/MM\nF=SSURF/SMESH,XYZ,{}\nCUTTER/6,3\nINTOL/.01\nOUTTOL/.01\n\
         L2=PLANE/1,0,0,40\nL3=PLANE/{faces},0,0,{}\nFROM/0,0,60\n\
         CLDAT/START,1,UVPPS\nINTSEC/L2,WITH,F\nINTSEC/L3,WITH,F\nCLDAT/NOMORE,1\n{work}\nFINI\n",
        splines.join(",$\n"),
        faces * 70.0
    )
}

/// The borders themselves are within and without as what lies beside them, by lines along them and in passes.
#[test]
fn an_outline_from_border_to_border_holds_the_borders() {
    let lines = [0, 1, 2].map(|c| format!("GOLOFT/F,VCONST,{c}")).join("\n");
    let lines = format!("GCLEAR/ON,CLEARS,(PLANE/0,0,1,30)\n{lines}");
    let passes = "GOMILL/F,VCONST,0,STEPOV,.5,PICKFD,RETR,(PLANE/0,0,1,50)";
    for (faces, work) in [(-1.0, &*lines), (1.0, &*lines), (-1.0, passes), (1.0, passes)] {
        for (sense, ends) in [("IN", &[[40.0, 70.0]][..]), ("OUT", &[[0.0, 40.0], [70.0, 90.0]])] {
            let ran = run::run(&strip(faces, &format!("REGION/1,{sense}\n{work}")), Verify::Full);
            // Where INTSEC meets is told.
            let faults = ran.faults();
            assert!(faults.iter().all(|code| code == "APT2052"), "{sense} {work} {:?}", ran.told);
            for y in [0.0, 30.0, 60.0] {
                let on_line = |p: &&[f64; 3]| p[2] < 20.0 && (p[1] - y).abs() < 1.5;
                let all: Vec<f64> = ran.places.iter().filter(on_line).map(|p| p[0]).collect();
                for [from, to] in ends {
                    for end in [from, to] {
                        let there = all.iter().any(|x| (x - end).abs() < 1.5);
                        assert!(there, "{faces} {sense} {work} {y} {end}: {all:?}");
                    }
                }
                let within = |x: &f64| ends.iter().any(|[a, b]| (a - 1.5..b + 1.5).contains(x));
                assert!(all.iter().all(within), "{faces} {sense} {work} {y}: {all:?}");
            }
        }
    }
}

/// What lies between the passes next to a border and the border itself is judged: without the line along it a ridge stands there.
#[test]
fn what_is_left_along_a_border_is_judged() {
    let lines = "GOMILL/F,VCONST,0,STEPOV,.05,SCALOP,.2,RETR,(PLANE/0,0,1,50)";
    for sense in ["IN", "OUT"] {
        let text = strip(-1.0, &format!("REGION/1,{sense}\n{lines}"));
        let (roles, said) = judged(&text, |_| true);
        assert!(roles.contains(&"scallop") && said.is_empty(), "{sense} {said:?}");
        for border in [0.0, 60.0] {
            // The surface rises from its borders: the cutter stands outside of them, and within with the next line.
            let beyond = |y: f64| if border == 0.0 { -y } else { y - border };
            let along = |m: &Motion| m.points.iter().all(|p| beyond(p.te.y) > -0.1);
            let (_, said) = judged(&text, |m| !along(m));
            let (lines, said) = parted(said);
            let codes: Vec<_> = said.iter().map(|d| d.code).collect();
            assert_eq!(codes, [codes::REFUTED], "{sense} {border} {said:?}");
            assert_eq!(lines.len(), if sense == "IN" { 1 } else { 2 }, "{lines:?}");
        }
    }
}
