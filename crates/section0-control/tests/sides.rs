//! The side of a checked surface from a part program: what the path keeps to is what the proof asks.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

/// The floor of a basin milled inside of it; `before` stands before CHKSRF, `close` behind it.
fn program(basin: &str, before: &str, close: &str) -> String {
    format!(
        "PARTNO SIDES
UNITS/MM
FLOOR=SSURF/SMESH,XYZ,SPLINE,(-18,-15,0),(0,-15,1),(18,-15,0),$
 SPLINE,(-18,15,0),(0,15,1),(18,15,0)
K1={basin}
UP=VECTOR/0,0,1
CUTTER/10,5,0,5,0,0,30
HOLDER/14,45,30,95
INTOL/.01
OUTTOL/.01
{before}
SCON/DS,FLOOR,PARAM,0,2,0,1,AT,UP
SCON/PS,TO,FLOOR,PLUS,0
SCON/AXIS,UP
CHKSRF/K1,ON
{close}
SMIL/PATH,DS,PARAM,.2,.5,TANSPL,PLUS
END
FINI
"
    )
}

/// The codes of what is wrong with path or proof.
fn faults(text: String, verify: Verify) -> Vec<String> {
    run::run(&text, verify).faults()
}

const BALL: &str = "SPHERE/0,0,30,50";
/// The same, x^2 + y^2 + z^2 - 60 z - 1600.
const QUADRIC: &str = "QADRIC/1,1,1,0,0,0,0,0,-30,-1600";

#[test]
fn who_stands_in_a_basin_mills_it() {
    let recorded = "CLDAT/START,1,UVPPS\nGOTO/0,0,200\nCLDAT/NOMORE,1";
    for basin in [BALL, QUADRIC] {
        for (before, close) in [
            ("FROM/0,0,10", ""),
            ("FROM/0,0,200\nGOTO/0,0,10", ""),
            ("FROM/0,0,10", recorded),
            ("FROM/0,0,10", "CYCLE/DRILL,DEPTH,5,MMPM,100,CLEAR,2\nCYCLE/OFF"),
            ("FROM/0,0,10", "LOADTL/2"),
            ("FROM/0,0,10", "RETRCT"),
            ("", ""),
            ("", recorded),
        ] {
            let text = program(basin, before, close);
            assert_eq!(faults(text.clone(), Verify::Full), Vec::<String>::new(), "{text}");
        }
    }
}

#[test]
fn who_comes_from_outside_does_not_get_in() {
    let recorded = "CLDAT/START,1,UVPPS\nGOTO/0,0,10\nCLDAT/NOMORE,1";
    for basin in [BALL, QUADRIC] {
        for close in ["", recorded, "CYCLE/OFF", "LOADTL/2", "RETRCT"] {
            for verify in [Verify::Full, Verify::Off] {
                let text = program(basin, "FROM/0,0,200", close);
                assert_eq!(faults(text.clone(), verify), ["APT2046"], "{text}");
            }
        }
    }
}

/// What stands between the last place and the first of a statement is met, whatever guides that, and by the holder too.
#[test]
fn the_way_to_a_first_position_is_checked() {
    let sheet =
        "SSURF/SMESH,XYZ,SPLINE,(-60,-90,-40),(-60,-90,90),$\n SPLINE,(-60,90,-40),(-60,90,90)";
    let bar = "SSURF/SMESH,XYZ,SPLINE,(-60,-1,100),(-60,1,100),$\n SPLINE,(-50,-1,100),(-50,1,100)";
    let mills = [
        "SMIL/PATH,DS,PARAM,.2,.5,TANSPL,PLUS",
        "SMIL/POSN,DS,PARAM,.2,.5,INCR,0",
        "GOLOFT/FLOOR,VCONST,.5,INVERS,MIRROR",
        "GOMILL/FLOOR,VCONST,.5,STEPOV,.5",
    ];
    for wall in [sheet, bar] {
        for mill in mills {
            for (from, wrong) in [("FROM/-90,0,20", true), ("FROM/-15,0,20", false)] {
                let text = program(wall, from, "").replace(mills[0], mill);
                let faults = faults(text.clone(), Verify::Off);
                let met = faults.iter().any(|code| code == "APT2049");
                assert_eq!(met, wrong, "{faults:?}\n{text}");
            }
        }
    }
}

#[test]
fn a_sheet_between_cutter_and_holder_is_met() {
    // Over the path at the height 37, and beside it.
    let tabcyl = |y: f64| {
        format!(
            "TABCYL/NOX,SPLINE,(POINT/0,{},39),(POINT/0,{y},37),(POINT/0,{},39)",
            y - 3.0,
            y + 3.0
        )
    };
    for (y, wanted) in [(0.0, vec!["APT2046"]), (90.0, Vec::new())] {
        for verify in [Verify::Full, Verify::Off] {
            let text = program(&tabcyl(y), "FROM/0,0,10", "");
            assert_eq!(faults(text.clone(), verify), wanted, "{text}");
        }
    }
}

/// A tool end led on a surface (TLONPS) goes INTOL below it and OUTTOL above, as the cutter stands, whichever way the surface's
/// normal points.
#[test]
fn a_tool_end_on_a_surface_keeps_to_the_band_on_its_own_side() {
    let arc = |z: [i32; 2]| {
        format!(
            "A=SCURV/CURSEG,(POINT/-60,-50,{0}),(POINT/0,-50,{1}),(POINT/60,-50,{0})\n\
             B=SCURV/CURSEG,(POINT/-60,50,{0}),(POINT/0,50,{1}),(POINT/60,50,{0})\n",
            z[0], z[1]
        )
    };
    // Circles of radius 100 about (0,0,80) and (0,0,-80): 20 below their middles at x = +-60.
    let (bowl, dome) = (arc([0, -20]), arc([0, 20]));
    for (surface, hollow) in [
        ("S=SPHERE/0,0,80,100".to_owned(), true),
        ("S=SPHERE/0,0,-80,100".to_owned(), false),
        ("S=CYLNDR/0,0,80,0,1,0,100".to_owned(), true),
        (format!("{bowl}S=SSURF/RULED,A,B"), true),
        (format!("{bowl}S=SSURF/RULED,B,A"), true),
        (format!("{dome}S=SSURF/RULED,A,B"), false),
        (format!("{dome}S=SSURF/RULED,B,A"), false),
    ] {
        for [intol, outtol] in [[0.0, 0.05], [0.05, 0.0], [0.02, 0.03]] {
            let text = format!(
                "UNITS/MM\n{surface}\nCUTTER/10,5\nINTOL/{intol}\nOUTTOL/{outtol}\nFROM/-30,0,30\n\
                 GO/ON,(PLANE/0,1,0,0),ON,S\nINDIRV/1,0,0\n\
                 TLON,TLONPS,GOFWD/(PLANE/0,1,0,0),ON,(PLANE/1,0,0,40)\nFINI\n"
            );
            let ran = run::run(&text, Verify::Full);
            assert_eq!(ran.faults(), Vec::<String>::new(), "{text}");
            let above = |[x, _, z]: [f64; 3]| {
                let center = if hollow { 80.0 } else { -80.0 };
                let out = (x * x + (z - center) * (z - center)).sqrt() - 100.0;
                if hollow { -out } else { out }
            };
            let path = &ran.places[1..];
            assert!(path.len() > 5, "{text}");
            let middles = path.windows(2).map(|w| [0, 1, 2].map(|i| 0.5 * (w[0][i] + w[1][i])));
            for p in path.iter().copied().chain(middles) {
                let up = above(p);
                assert!(up >= -intol - 1e-6 && up <= outtol + 1e-6, "{up} at {p:?} {text}");
            }
        }
    }
}

/// The band is that of the surface, whether it is met as a check surface, in a start-up, or led along.
#[test]
fn a_tool_end_that_comes_to_a_hollow_stays_in_its_band() {
    let lead = "INDIRV/1,0,0\nTLON,TLONPS,GOFWD/D";
    let ways = [
        format!("GO/ON,D,ON,F\n{lead},ON,S\nPSIS/S\nGOFWD/D,ON,E"),
        format!("GO/ON,S,ON,D\nPSIS/S\n{lead},ON,E"),
        format!("GO/ON,D,ON,S\n{lead},PSTAN,T\nPSIS/T\nGOFWD/D,ON,E"),
    ];
    for surface in ["SPHERE/0,0,80,100", "CYLNDR/0,0,80,0,1,0,100"] {
        for [intol, outtol] in [[0.0, 0.05], [0.01, 0.05], [0.05, 0.0]] {
            for way in &ways {
                let text = format!(
                    "UNITS/MM\nS={surface}\nT=CYLNDR/0,0,90,0,1,0,110\nD=PLANE/0,1,0,0\n\
                     F=PLANE/0,0,1,-10\nE=PLANE/1,0,0,55\nCUTTER/10,5\nINTOL/{intol}\n\
                     OUTTOL/{outtol}\nFROM/-30,0,10\n{way}\nFINI\n"
                );
                let ran = run::run(&text, Verify::Full);
                assert_eq!(ran.faults(), Vec::<String>::new(), "{:?} {text}", ran.told);
                assert!(ran.places.len() > 4, "{text}");
            }
        }
    }
}
