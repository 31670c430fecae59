//! A motion to a tangent check surface that goes on past the first place where it is tangent is refuted.

#[path = "support/held.rs"]
mod held;

use aptc_cldata::{Kind, MotionKind, Record, Relation};
use aptc_diagnostics::Diagnostic;
use aptc_geometry::trig;
use aptc_verify::Breach;
use held::{held, last, records};

/// The place that the last motion passed, if that is what refutes it.
fn passed(path: &str, asked: &str) -> [f64; 3] {
    let right = held(asked, asked);
    assert!(right.0.is_proved(), "{:?} {asked}", right.1);
    let (c, said) = held(path, asked);
    let fault = c.statements.last().and_then(|s| s.fault.clone());
    let fault = fault
        .unwrap_or_else(|| panic!("no fault: {path} {asked} {:?}", last(&records(asked)).checks));
    assert!(fault.refuted && fault.breach == Some(Breach::Past), "{fault:?} {path}");
    let tells = |d: &Diagnostic| d.message.contains("goes past the place where check surface");
    assert!(said.iter().any(tells), "{said:?}");
    fault.te
}

/// Where a program's last motion along surfaces ends, along x.
fn end(text: &str) -> f64 {
    let along = |r: &Record| match &r.kind {
        Kind::Motion(m) if m.kind == MotionKind::Continuous => m.points.last().map(|p| p.te.x),
        _ => None,
    };
    records(text).iter().rev().find_map(along).expect("it moves along surfaces")
}

fn off(p: [f64; 3], q: [f64; 3]) -> f64 {
    (0..3).map(|i| (p[i] - q[i]).abs()).fold(0.0, f64::max)
}

/// From a line to a circle beside it, by flat, bull nose, ball and needle, over a floor that slopes too.
#[test]
fn a_line_goes_on_past_a_circle() {
    for circle in ["40,-25,25", "40,-3,3", "40,-300,300"] {
        for cutter in ["8", "8,1", "8,4", "0"] {
            for floor in ["0,0,1,0", ".05,0,1,0"] {
                let text = |to: &str| {
                    format!(
                        "UNITS/MM\nW=PLANE/0,1,0,0\nC=CIRCLE/{circle}\nPS=PLANE/{floor}\nCUTTER/{cutter}\n\
                         INTOL/.01\nOUTTOL/.01\nFROM/-10,20,30\nINDIRV/0,-1,0\n\
                         GO/TO,W,TO,PS,ON,(PLANE/1,0,0,-5)\nINDIRV/1,0,0\nTLLFT,GOFWD/W,{to}\nFINI\n"
                    )
                };
                let far = if circle == "40,-300,300" { 80 } else { 52 };
                let at = passed(&text(&format!("ON,(PLANE/1,0,0,{far})")), &text("TANTO,C"));
                assert!((at[0] - 40.0).abs() < 0.6, "{at:?} {circle} {cutter} {floor}");
            }
        }
    }
}

/// Inside of a circle past the place where a wider one touches it.
#[test]
fn a_circle_goes_on_past_a_wider_one() {
    let text = |to: &str| {
        format!(
            "UNITS/MM\nC=CIRCLE/0,0,20\nD=CIRCLE/0,-30,50\nPS=PLANE/0,0,1,0\nCUTTER/8\nOUTTOL/.01\n\
             FROM/0,0,30\nINDIRV/-1,0,0\nGO/TO,C,TO,PS\nINDIRV/0,1,0\nTLRGT,GOFWD/C,{to}\nFINI\n"
        )
    };
    let at = passed(&text("ON,(PLANE/1,0,0,10)"), &text("TANTO,D"));
    assert!(off(at, [0.0, 16.0, 0.0]) < 0.6, "{at:?}");
}

/// Up a ramp out of a floor: past the line where a fillet begins.
#[test]
fn a_floor_goes_on_past_a_fillet() {
    for cutter in ["6,3", "6,1", "6"] {
        let text = |to: &str| {
            format!(
                "UNITS/MM\nFL=PLANE/0,0,1,0\nWALL=PLANE/0,1,0,0\nR=CYLNDR/20,0,-40,0,1,0,40\n\
                 CUTTER/{cutter}\nINTOL/.005\nOUTTOL/.005\nFROM/-20,-15,5\nINDIRV/0,1,0\n\
                 GO/TO,WALL,TO,FL\nINDIRV/1,0,0\nTLRGT,GOFWD/WALL,{to}\nFINI\n"
            )
        };
        let at = passed(&text("ON,(PLANE/1,0,0,45)"), &text("PSTAN,R"));
        assert!((at[0] - 20.0).abs() < 4.0, "{at:?} {cutter}");
    }
}

/// A wave that touches twice, and curves that run along with the line before they leave it.
#[test]
fn curves_that_are_tangent_before() {
    let wave = |first: f64, to: &str| {
        format!(
            "UNITS/MM\nW=PLANE/0,1,0,0\nC=TABCYL/NOZ,SPLINE,-30,6,-20,4,-10,2,0,2,10,{first},20,2,$\n\
             30,2,40,0,50,2,60,2,70,4,80,6\nCUTTER/6\nINTOL/.01\nOUTTOL/.02\n\
             FROM/-20,-20,5\nINDIRV/0,1,0\nGO/TO,W,TO,(PLANE/0,0,1,0)\nINDIRV/1,0,0\n\
             TLRGT,GOFWD/W,{to}\nFINI\n"
        )
    };
    let at = passed(&wave(2.0, "TANTO,C"), &wave(0.0, "TANTO,C"));
    assert!((at[0] - 10.0).abs() < 0.5, "{at:?}");
    for hump in ["50,0,NORMAL,90,60,3,70,6,80,3,90,0,NORMAL,90", "50,0,NORMAL,90,60,-3,70,-6,80,-9"]
    {
        let text = |to: &str| {
            format!(
                "UNITS/MM\nPS=PLANE/0,0,1,0\nW1=LINE/XAXIS\nT1=TABCYL/NOZ,SPLINE,$\n{hump}\nCUTTER/10,2\n\
                 INTOL/.01\nOUTTOL/.02\nFROM/0,30,40\nINDIRV/0,-1,0\nGO/TO,W1,TO,PS,ON,(PLANE/1,0,0,0)\n\
                 INDIRV/1,0,0\nTLLFT,GOFWD/W1,{to}\nFINI\n"
            )
        };
        let at = passed(&text("ON,(PLANE/1,0,0,120)"), &text("TANTO,T1"));
        assert!((at[0] - 50.0).abs() < 0.5, "{at:?}");
    }
}

/// Crests nearer to each other than the cutter is wide, which comes to each of them in turn: it stops at the first that is level, and
/// one that goes on to the next is refuted.
#[test]
fn a_wide_cutter_stops_at_the_first_of_many_crests() {
    for (step, cutter) in [(5, "16,3"), (5, "8,4"), (6, "20,1"), (10, "16,3")] {
        let knots: Vec<String> = (-3..12)
            .map(|i| {
                let low = if i >= 4 { 0 } else { 1 };
                format!("{},{},NORMAL,90", i * step, if i % 2 == 0 { low } else { 3 })
            })
            .collect();
        let text = |to: &str| {
            format!(
                "UNITS/MM\nW=PLANE/0,1,0,0\nC=TABCYL/NOZ,TWOPT,$\n{}\nCUTTER/{cutter}\nINTOL/.001\nOUTTOL/.001\n\
                 FROM/{x},-20,5\nINDIRV/0,1,0\nGO/TO,W,TO,(PLANE/0,0,1,0),ON,(PLANE/1,0,0,{x})\n\
                 INDIRV/1,0,0\nTLRGT,GOFWD/W,{to}\nFINI\n",
                knots.join(",$\n"),
                x = -2 * step
            )
        };
        let (asked, first) = (text("TANTO,C"), f64::from(4 * step));
        assert!((end(&asked) - first).abs() < 1e-3, "{} {asked}", end(&asked));
        let at = passed(&text(&format!("ON,(PLANE/1,0,0,{})", 6 * step)), &asked);
        assert!((at[0] - first).abs() < 0.5, "{at:?} {asked}");
        // The second of them is counted.
        let (asked, second) = (text("TANTO,2,INTOF,C"), f64::from(6 * step));
        assert!((end(&asked) - second).abs() < 1e-3, "{} {asked}", end(&asked));
        let at = passed(&text(&format!("ON,(PLANE/1,0,0,{})", 8 * step)), &asked);
        assert!((at[0] - second).abs() < 0.5, "{at:?} {asked}");
    }
}

/// Over crests of a mesh that touch a floor from below: a flat end that covers more than one stops over the first of them, where a
/// ball does, and not over a hollow.
#[test]
fn a_flat_end_stops_over_a_crest() {
    for step in [5, 10] {
        let text = |cutter: &str, to: &str| {
            let row = |y: i32| {
                let high = |i: i32| match (i % 2 == 0, i >= 2) {
                    (true, true) => 0,
                    (true, false) => -1,
                    _ => -3,
                };
                let points = (-3..10).map(|i| format!("({},{y},{})", i * step, high(i)));
                format!("SPLINE,{}", points.collect::<Vec<_>>().join(",$\n"))
            };
            format!(
                "UNITS/MM\nC=SSURF/SMESH,XYZ,$\n{},$\n{}\nD=PLANE/0,1,0,0\nPS=PLANE/0,0,1,0\nCUTTER/{cutter}\n\
                 INTOL/.002\nOUTTOL/.002\nFROM/{x},0,20\nGO/ON,D,TO,PS,ON,(PLANE/1,0,0,{x})\nINDIRV/1,0,0\n\
                 TLON,GOFWD/D,{to}\nFINI\n",
                row(-30),
                row(30),
                x = -2 * step
            )
        };
        let ball = end(&text("8,4", "PSTAN,C"));
        assert!((ball - f64::from(2 * step)).abs() < 0.3, "{ball}");
        for cutter in ["12", "16,3"] {
            let asked = text(cutter, "PSTAN,C");
            assert!((end(&asked) - ball).abs() < 1e-3, "{} {ball} {asked}", end(&asked));
            let (right, said) = held(&asked, &asked);
            assert!(right.is_proved(), "{said:?} {asked}");
        }
        // Where it ends over a hollow it is tangent to nothing.
        let hollow = text("8,4", &format!("ON,(PLANE/1,0,0,{})", 3 * step));
        let (wrong, _) = held(&hollow, &text("8,4", "PSTAN,C"));
        let fault = wrong.statements.last().and_then(|s| s.fault.clone());
        assert!(fault.is_some_and(|f| f.refuted), "{hollow}");
    }
}

/// The parabola `y = k x x` on the one side of its vertex, and straight on there, to nine digits.
fn parabola(name: &str, k: f64, before: bool) -> String {
    let sign = if before { -1.0 } else { 1.0 };
    let places = [0.0, 8.0, 16.0, 24.0, 32.0, 40.0].map(|x| sign * x);
    let told = |x: f64| {
        let normal = 90.0 + trig::atan2(2.0 * k * x, 1.0).to_degrees();
        let end = x.abs() < 1.0 || x.abs() > 39.0;
        let normal = if end { format!(",NORMAL,{normal:.9}") } else { String::new() };
        format!("{x:.9},{:.9}{normal}", k * x * x)
    };
    let mut places = places.map(told);
    if before {
        places.reverse();
    }
    format!("{name}=TABCYL/NOZ,SPLINE,$\n{}\n", places.join(",$\n"))
}

/// Curves that join, the second one bending away: the gap turns back there, or goes on through nothing without a slope.
#[test]
fn a_curve_goes_on_past_the_one_that_it_runs_into() {
    for [first, then] in [[0.02_f64, -0.0075], [0.0075, -0.02], [-0.0075, -0.02], [-0.01, -0.015]] {
        for circle in [false, true] {
            let (middle, radius) = (0.5 / first, 0.5 / first.abs());
            let own = match circle {
                true => format!("QA=CYLNDR/0,{middle:.9},0,0,0,1,{radius:.9}\n"),
                false => parabola("QA", first, true),
            };
            // The parabola goes straight on, the circle round.
            if circle && first > 0.0 {
                continue;
            }
            let text = |to: &str| {
                format!(
                    "UNITS/MM\n{own}{}PS=PLANE/0,0,1,0\nCUTTER/8,2\nINTOL/.005\nOUTTOL/.01\n\
                     FROM/-13,15,40\nINDIRV/0,-1,0\nGO/TO,QA,TO,PS,ON,(PLANE/1,0,0,-12)\n\
                     INDIRV/1,0,0\nTLLFT,GOFWD/QA,{to}\nFINI\n",
                    parabola("QB", then, false)
                )
            };
            let at = passed(&text("ON,(PLANE/1,0,0,15)"), &text("TANTO,QB"));
            assert!(at[0].abs() < 1.6 && (at[1] - 4.0).abs() < 0.06, "{at:?} {first} {then}");
        }
    }
}

/// A tangency that n,INTOF counts, and one where the motion begins, are passed rightly.
#[test]
fn what_is_passed_on_purpose_is_proved() {
    let text = |to: &str| {
        format!(
            "UNITS/MM\nW=PLANE/0,1,0,0\nC=TABCYL/NOZ,SPLINE,-30,6,-20,4,-10,2,0,2,10,0,20,2,$\n\
             30,2,40,0,50,2,60,2,70,4,80,6\nCUTTER/6\nINTOL/.01\nOUTTOL/.02\n\
             FROM/-20,-20,5\nINDIRV/0,1,0\nGO/TO,W,TO,(PLANE/0,0,1,0)\nINDIRV/1,0,0\n\
             TLRGT,GOFWD/W,{to}\nFINI\n"
        )
    };
    for to in ["TANTO,2,INTOF,C", "TANTO,C\nGOFWD/W,TANTO,C"] {
        let (c, said) = held(&text(to), &text(to));
        let end = records(&text(to)).iter().rev().find_map(|r| match &r.kind {
            Kind::Motion(m) => m.points.last().copied(),
            _ => None,
        });
        assert!(c.is_proved() && (end.expect("it moves").te.x - 40.0).abs() < 0.5, "{said:?}");
    }
    let one = last(&records(&text("TANTO,C")));
    assert_eq!(one.checks[0].relation, Relation::Tanto);
}
