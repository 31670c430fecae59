//! Lines and circles with the decimals of a drawing miss being tangent by as much: where the bands take that up the motion goes on.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;
use aptc_geometry::trig;

/// From a line round a fillet to another line that turns off by `turn_deg`, all coordinates with so many decimals.
fn program(turn_deg: f64, radius: f64, decimals: usize, stance: &str, bands: &str) -> String {
    let (c, s) = (trig::cos_deg(turn_deg), trig::sin_deg(turn_deg));
    let back = radius * s / (1.0 + c);
    let (from, turn) = match stance {
        "TLLFT" => ("0,25,10\nINDIRV/0,-1,0\nGO/TO,L1", "GOLFT"),
        "TLRGT" => ("0,-25,10\nINDIRV/0,1,0\nGO/TO,L1", "GORGT"),
        _ => ("0,25,10\nINDIRV/0,-1,0\nGO/ON,L1", "GOLFT"),
    };
    format!(
        "UNITS/MM\nL1=LINE/0,0,60,0\nL2=LINE/60,0,{:.decimals$},{:.decimals$}\n\
         C1=CIRCLE/{:.decimals$},{radius},{radius}\nE1=LINE/(POINT/{},{}),PERPTO,L2\n\
         PS=PLANE/0,0,1,0\nCUTTER/10\n{bands}\nFROM/{from},TO,PS\n{stance},{turn}/L1,TANTO,C1\n\
         GOFWD/C1,TANTO,L2\nGOFWD/L2,ON,E1\nFINI\n",
        60.0 + 50.0 * c,
        50.0 * s,
        60.0 - back,
        60.0 + 45.0 * c,
        45.0 * s,
    )
}

#[test]
fn fillets_with_the_decimals_of_a_drawing_are_proved() {
    for bands in ["OUTTOL/.02", "INTOL/.02\nOUTTOL/0", "INTOL/.002\nOUTTOL/.01"] {
        for stance in ["TLLFT", "TLRGT", "TLON"] {
            for k in 0..20 {
                let turn_deg = 31.0 + 5.7 * f64::from(k);
                let radius = 7.0 + f64::from(k % 5);
                for decimals in [3, 4, 6] {
                    let text = program(turn_deg, radius, decimals, stance, bands);
                    let ran = run::run(&text, Verify::Full);
                    assert_eq!(ran.codes(), Vec::<String>::new(), "{:?}\n{text}", ran.told);
                    assert!(ran.places.len() > 4, "{text}");
                }
            }
        }
    }
}

/// A line that a circle misses by shares of the bands together, inside of it and outside: what both bands take up is proved, what
/// they do not is told, and neither takes more chords.
#[test]
fn what_the_bands_do_not_take_up_is_told() {
    for [intol, outtol] in [[0.0, 0.02], [0.02, 0.0], [0.01, 0.01], [0.005, 0.02]] {
        for share in [0.3, 0.7, 0.99, 1.01, 1.4, 1.9] {
            for hollow in [true, false] {
                let miss = share * (intol + outtol);
                let (from, stance, y) = if hollow {
                    ("20,0,10", "TLRGT,GORGT", -30.0 + miss)
                } else {
                    ("-38,9,10", "TLLFT,GOLFT", -40.0 + miss)
                };
                // Outside the line is on the other side of the cutter's circle, below it.
                let y = if hollow { y } else { y + 10.0 };
                let text = format!(
                    "UNITS/MM\nC1=CIRCLE/0,0,0,30\nL1=LINE/(POINT/-40,{y}),(POINT/40,{y})\n\
                     CUTTER/10\nINTOL/{intol}\nOUTTOL/{outtol}\nFROM/{from}\nINDIRV/1,0,0\n\
                     GO/TO,C1,TO,(PLANE/0,0,1,0)\n{stance}/C1,TANTO,L1\nFINI\n"
                );
                let ran = run::run(&text, Verify::Full);
                assert!(ran.places.len() < 140, "{} {text}", ran.places.len());
                let faults = ran.faults();
                let other = |c: &String| c != "APT5001" && c != "APT2009" && c != "APT2005";
                assert!(!faults.iter().any(other), "{:?} {text}", ran.told);
                if hollow {
                    let told = faults.iter().any(|c| c == "APT5001");
                    assert_eq!(told, share > 1.0, "{share} {:?} {text}", ran.told);
                }
            }
        }
    }
}
