//! Axes that change where the tool stands: they turn in place where they must, and each cut vector of it is proved.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

/// GO does not know the way that follows: the ball leans to the other side then, and where a check surface stands nearer than the
/// first cut vector would have to go to turn on it, it turns before.
#[test]
fn a_ball_that_leans_to_the_other_side_comes_to_a_near_check_surface() {
    for angle in 3..=10 {
        for (intol, outtol) in
            [(0.005, 0.02), (0.0, 0.02), (0.005, 0.05), (0.02, 0.02), (0.02, 0.01)]
        {
            let text = format!(
                "UNITS/MM\nPA=CYLNDR/0,0,-3000,0,1,0,3000\nDR=PLANE/0,1,0,1\nCUTTER/8,4\nINTOL/{intol}\n\
                 OUTTOL/{outtol}\nMULTAX\nFROM/-45,1,30\nTLAXIS/ATANGL,1,{angle},(VECTOR/0,1,0)\n\
                 GO/ON,DR,TO,PA,ON,(PLANE/1,0,0,-45)\nINDIRV/1,0,0\nTLON,GOFWD/DR,ON,(PLANE/1,0,0,-20)\n\
                 FINI\n"
            );
            let ran = run::run(&text, Verify::Full);
            assert!(ran.told.is_empty(), "{angle} {intol} {outtol} {:?}", ran.told);
            let end = ran.places.last().expect("the tool goes");
            assert!((end[0] + 20.0).abs() < 1e-6, "{end:?}");
        }
    }
}

/// A fixed axis in the middle of a pass: the ball turns about the place where it touches, its middle stays where it is.
#[test]
fn a_fixed_axis_in_the_middle_of_a_pass_turns_in_place() {
    const RADIUS: f64 = 6.0;
    for (first, axis) in [
        ("NORMPS", [0.0, 0.0, 1.0]),
        ("NORMPS", [0.1, 0.05, 1.0]),
        ("NORMPS", [-0.12, 0.0, 1.0]),
        ("0,0,1", [0.2, -0.1, 1.0]),
        ("ATANGL,1,12", [0.0, 0.3, 1.0]),
    ] {
        let [i, j, k] = axis;
        let text = format!(
            "UNITS/MM\nPA=SPHERE/0,0,-200,200\nDR=PLANE/0,1,0,0\nCUTTER/12,6\nINTOL/.01\nOUTTOL/.02\nMULTAX\n\
             FROM/-45,0,30\nTLAXIS/{first}\nGO/ON,DR,TO,PA,ON,(PLANE/1,0,0,-45)\nINDIRV/1,0,0\n\
             TLON,GOFWD/DR,ON,(PLANE/1,0,0,-25)\nTLAXIS/{i},{j},{k}\nGOFWD/DR,ON,(PLANE/1,0,0,0)\nFINI\n"
        );
        let ran = run::run(&text, Verify::Full);
        assert!(ran.told.is_empty(), "{first} {axis:?} {:?}", ran.told);
        let size = f64::sqrt(i * i + j * j + k * k);
        let turned = |ta: &[f64; 3]| {
            let off = [ta[0] - i / size, ta[1] - j / size, ta[2] - k / size];
            off.iter().all(|x| x.abs() < 1e-9)
        };
        let at = 1 + ran.axes.iter().rposition(|ta| !turned(ta)).expect("it turns");
        assert!(at + 1 < ran.places.len(), "on the way, not at its end");
        // In place: the tool end goes no farther than the turn about the ball takes it.
        assert!((ran.places[at][0] + 25.0).abs() < 0.05 + RADIUS * 0.3, "{:?}", ran.places[at]);
        let middle = |n: usize| {
            let (te, ta) = (ran.places[n], ran.axes[n]);
            [0, 1, 2].map(|i| te[i] + RADIUS * ta[i])
        };
        let far = |p: [f64; 3]| (p[0] * p[0] + p[1] * p[1] + (p[2] + 200.0).powi(2)).sqrt();
        for n in 1..ran.places.len() {
            let gap = far(middle(n)) - 200.0 - RADIUS;
            assert!((-0.0101..=0.0201).contains(&gap), "{n} {gap}");
        }
    }
}

/// A check surface into which the tool turns before the motion begins is no end of a motion that comes out of it again.
#[test]
fn what_the_tool_turns_into_where_it_stands_is_told() {
    let text = |far: f64, axis: &str, next: &str| {
        format!(
            "UNITS/MM\nF=PLANE/0,0,1,0\nD=PLANE/0,1,0,0\nW=PLANE/.8,.6,0,{far}\nCUTTER/10,0,5,0,0,0,60\nTOLER/.01\nMULTAX\n\
             FROM/0,0,50\nTLAXIS/{axis}\nGO/ON,D,TO,F,ON,(PLANE/1,0,0,0)\nINDIRV/1,0,0\nTLAXIS/{next}\n\
             TLON,GOFWD/D,TO,W\nFINI\n"
        )
    };
    for next in ["ATANGL,1,35", "0,.7,1", ".3,0,1"] {
        let near = run::run(&text(14.0, "0,0,1", next), Verify::Full);
        assert_eq!(near.codes(), ["APT2020"], "{next} {:?}", near.told);
        let (_, words) = &near.told[0];
        assert!(words.contains("deep into the check surface W where it turns in place"), "{words}");
        // Farther off it turns beside it and comes to it, as with the axis of the motion from the beginning.
        for axis in ["0,0,1", next] {
            let far = run::run(&text(40.0, axis, next), Verify::Full);
            assert!(far.told.is_empty(), "{axis} {next} {:?}", far.told);
        }
    }
}

/// The same axis once more, or one given before a GO, turns nothing.
#[test]
fn an_axis_that_stays_turns_nothing() {
    let program = |axis: &str| {
        format!(
            "UNITS/MM\nPA=SPHERE/0,0,-200,200\nDR=PLANE/0,1,0,0\nCUTTER/12,6\nINTOL/.01\nOUTTOL/.02\nMULTAX\n\
             FROM/-45,0,30\nTLAXIS/.1,0,1\nGO/ON,DR,TO,PA,ON,(PLANE/1,0,0,-45)\nINDIRV/1,0,0\n\
             TLON,GOFWD/DR,ON,(PLANE/1,0,0,-25)\n{axis}\nGOFWD/DR,ON,(PLANE/1,0,0,0)\nFINI\n"
        )
    };
    let plain = run::run(&program(""), Verify::Full);
    for axis in ["TLAXIS/.1,0,1", "TLAXIS/.2,0,2", "TLAXIS/1\nTLAXIS/.1,0,1"] {
        let ran = run::run(&program(axis), Verify::Full);
        assert_eq!((ran.places.len(), ran.told), (plain.places.len(), vec![]), "{axis}");
    }
}

/// Square to a cone a flat end lies along a ruling, and touches anywhere on it. Where the band begins at the surface the tool turns in
/// place to an axis that leaves the first cut vector room.
#[test]
fn a_flat_end_turns_onto_the_ruling_of_a_cone_in_a_band_that_begins_there() {
    for cutter in ["12", "12,2", "12,6"] {
        for cone in [
            "(POINT/-80,-2,0),(VECTOR/1,0,-.35),20",
            "(POINT/-80,-3,0),(VECTOR/1,0,-.35),20",
            "(POINT/-90,0,-10),(VECTOR/1,.1,0),15",
        ] {
            for axis in ["ATANGL,1,15,(VECTOR/-.5483,.836282,0)", "ATANGL,1,8", "0,0,1"] {
                let text = format!(
                    "UNITS/MM\nPA=CONE/{cone}\nDR=PLANE/-.5483,.836282,0,3\nCUTTER/{cutter}\nINTOL/0\n\
                     OUTTOL/.01\nMULTAX\nFROM/20.098,16.765,70\nTLAXIS/{axis}\n\
                     GO/ON,DR,TO,PA,ON,(PLANE/.836282,.5483,0,26)\nINDIRV/-.83628,-.5483,0\n\
                     TLAXIS/NORMPS\nTLON,GOFWD/DR,ON,(PLANE/.836282,.5483,0,14)\nFINI\n"
                );
                let ran = run::run(&text, Verify::Full);
                assert!(ran.told.is_empty(), "{:?} {text}", ran.told);
                let end = ran.places.last().expect("the tool goes");
                assert!(
                    (0.836282 * end[0] + 0.5483 * end[1] - 14.0).abs() < 1e-4,
                    "{end:?} {text}"
                );
            }
        }
    }
}

/// From the slope that rises by the first angle along x to the next one, the tool square to each.
fn over_a_ridge(
    [from, to]: [f64; 2],
    next: &str,
    cutter: &str,
    [intol, outtol]: [f64; 2],
) -> run::Ran {
    let n = |deg: f64| [-aptc_geometry::trig::sin_deg(deg), aptc_geometry::trig::cos_deg(deg)];
    let ([a, c], [i, k]) = (n(from), n(to));
    // A cylinder of 80 whose normal at the ridge is that of the slope.
    let (x, z) = (-80.0 * i, -80.0 * k);
    let next = match next {
        "PLANE" => format!("PLANE/{i:.12},0,{k:.12},0"),
        _ => format!("CYLNDR/{x:.12},0,{z:.12},0,1,0,80"),
    };
    let text = format!(
        "UNITS/MM\nCANON/ON\nFIRST=PLANE/{a:.12},0,{c:.12},0\nNEXT={next}\nDR=PLANE/(POINT/0,0,0),(POINT/10,2,0),(POINT/0,0,9)\n\
         CUTTER/{cutter}\nINTOL/{intol}\nOUTTOL/{outtol}\nMULTAX\nFROM/-45,0,60\nTLAXIS/NORMPS\n\
         GO/ON,DR,TO,FIRST,ON,(PLANE/1,0,0,-30)\nINDIRV/1,0,0\nTLON,GOFWD/DR,ON,(PLANE/1,0,0,0)\n\
         PSIS/NEXT\nGOFWD/DR,ON,(PLANE/1,0,0,12)\nFINI\n"
    );
    run::run(&text, Verify::Full)
}

/// On the ridge to the next part surface the tool turns about its end, and then goes on: it does not cut into what is before or beyond
/// it. In a valley it stands in the next one there.
#[test]
fn a_tool_square_to_its_part_surface_turns_on_a_ridge() {
    for next in ["PLANE", "CYLNDR"] {
        for angles in [[12.0, -4.0], [8.0, 1.0], [-3.0, -35.0], [30.0, 5.0]] {
            for (cutter, bands) in [
                ("10", [0.01, 0.01]),
                ("16,8", [0.0, 0.05]),
                ("12,2", [0.005, 0.02]),
                ("20,.5", [0.1, 0.1]),
            ] {
                let ran = over_a_ridge(angles, next, cutter, bands);
                assert!(ran.told.is_empty(), "{next} {angles:?} {cutter} {:?}", ran.told);
                let turned = |k: usize| {
                    let (a, b) = (ran.axes[k - 1], ran.axes[k]);
                    (0..3).map(|i| a[i] * b[i]).sum::<f64>() < 1.0 - 1e-5
                };
                let at = (2..ran.places.len()).find(|k| turned(*k)).expect("it turns");
                let by = (0..3).map(|i| (ran.places[at][i] - ran.places[at - 1][i]).abs());
                let room = 2.0 * (bands[0] + bands[1]);
                assert!(by.fold(0.0, f64::max) <= room, "{next} {angles:?} {cutter}");
                let [from, to] = angles;
                let valley = over_a_ridge([to, from], "PLANE", cutter, bands);
                assert_eq!(valley.faults(), ["APT5001"], "{angles:?} {cutter} {:?}", valley.told);
            }
        }
    }
}

/// Of a sculptured surface beyond the ridge, whose tangent plane need not hold it, that is not decided, with the reason.
#[test]
fn a_turn_on_a_ridge_to_a_sculptured_surface_is_not_refuted() {
    let text = "UNITS/MM\nFIRST=PLANE/-.2,0,1,0\nL1=SCURV/SPLINE,(0,-30,0),(0,30,0)\nL2=SCURV/SPLINE,(40,-30,-6),(40,30,-6)\n\
        NEXT=SSURF/RULED,L1,L2\nDR=PLANE/0,1,0,0\nCUTTER/10\nINTOL/.01\nOUTTOL/.01\nMULTAX\nFROM/-45,0,60\nTLAXIS/NORMPS\n\
        GO/ON,DR,TO,FIRST,ON,(PLANE/1,0,0,-30)\nINDIRV/1,0,0\nTLON,GOFWD/DR,ON,(PLANE/1,0,0,0)\n\
        PSIS/NEXT\nGOFWD/DR,ON,(PLANE/1,0,0,12)\nFINI\n";
    let ran = run::run(text, Verify::Full);
    assert_eq!(ran.faults(), ["APT5002"], "{:?}", ran.told);
}
