//! TABCYL with corners, as FOURPT and TWOPT fair them: the tool goes over them with its axis askew to the rulings, as beside a cam that
//! it leans against, or across waves that lie. All of it is proved.

#[path = "support/run.rs"]
mod run;

use std::fmt::Write as _;

use aptc_control::Verify;
use aptc_geometry::trig;

/// The `i`th place of a low discrepancy sequence for the program `k`.
fn share(k: u32, i: u32) -> f64 {
    (f64::from(k + 1) * 0.618_033_988_75 * f64::from(i + 1) + 0.37 * f64::from(i)).fract()
}

/// A mill 25 high, flat or with a round corner.
fn cutter(k: u32, diameter: f64) -> String {
    let corner = [0.0, 0.2, 0.5][(k % 3) as usize] * diameter;
    format!("CUTTER/{diameter:.4},{corner:.4},{:.4},{corner:.4},0,0,25", 0.5 * diameter - corner)
}

fn fairing(k: u32) -> &'static str {
    ["FOURPT", "TWOPT"][(k % 5 / 4) as usize]
}

/// Round a plate of uneven radius, inside or outside, with an axis that leans by 2 to 18 degrees.
fn leaning(k: u32) -> String {
    let n = [12, 16, 20, 24][(k % 4) as usize];
    let radius = 25.0 + 25.0 * share(k, 0);
    let point = |i: u32| {
        let angle = 360.0 * f64::from(i) / f64::from(n);
        let r = radius * (0.97 + 0.06 * share(k, 20 + i));
        [r * trig::cos_deg(angle), r * trig::sin_deg(angle)]
    };
    let mut curve = String::new();
    for [x, y] in (0..=n).map(|i| point(i % n)) {
        write!(curve, ",$\n{x:.5},{y:.5}").unwrap_or_default();
    }
    let (lean, to) = (0.03 + 0.29 * share(k, 1), 360.0 * share(k, 2));
    let [lean_x, lean_y] = [trig::cos_deg(to), trig::sin_deg(to)].map(|x| lean * x);
    let (inside, way) = (share(k, 3) < 0.4, if share(k, 4) < 0.5 { 1.0 } else { -1.0 });
    let start = 360.0 * share(k, 5);
    let [x, y] = [trig::cos_deg(start), trig::sin_deg(start)];
    let end = start + way * 60.0;
    let (far, to) = if inside { (0.3, 1.0) } else { (2.0, -1.0) };
    let side = if (way > 0.0) == inside { "TLLFT" } else { "TLRGT" };
    format!(
        "UNITS/MM\nCAM=TABCYL/NOZ,{}{curve}\nBASE=PLANE/0,0,1,-5\n{}\nTOLER/{}\nMULTAX\n\
         TLAXIS/{lean_x:.4},{lean_y:.4},1\nEND=PLANE/{:.9},{:.9},0,0\nFROM/{:.4},{:.4},20\n\
         INDIRV/{:.6},{:.6},0\nGO/TO,CAM,TO,BASE\nINDIRV/{:.6},{:.6},0\n\
         {side},GOFWD/CAM,ON,{},INTOF,END\nFINI\n",
        fairing(k),
        cutter(k / 2, 4.0 + 8.0 * share(k, 6)),
        [0.002, 0.01, 0.05][(k % 3) as usize],
        -trig::sin_deg(end),
        trig::cos_deg(end),
        radius * far * x,
        radius * far * y,
        to * x,
        to * y,
        -way * y,
        way * x,
        1 + k % 2
    )
}

/// Across waves that lie along y, straight or askew, with an axis that is upright or leans.
fn lying(k: u32) -> String {
    const N: u32 = 14;
    let step = 4.0 + 8.0 * share(k, 0);
    let height = step * (0.05 + 0.25 * share(k, 1));
    let mut curve = String::new();
    for i in 0..N {
        let (z, x) =
            (height * (2.0 * share(k, 20 + i) - 1.0), (f64::from(i) - 0.5 * f64::from(N)) * step);
        write!(curve, ",$\n{z:.5},{x:.5}").unwrap_or_default();
    }
    let askew = if k.is_multiple_of(3) { 80.0 * share(k, 2) - 40.0 } else { 0.0 };
    let axis = if k.is_multiple_of(2) {
        String::new()
    } else {
        let lean = |i: u32| 0.6 * share(k, i) - 0.3;
        format!("MULTAX\nTLAXIS/{:.3},{:.3},1\n", lean(3), lean(4))
    };
    let [x, y] = [trig::cos_deg(askew), trig::sin_deg(askew)];
    let far = 0.35 * step * f64::from(N);
    format!(
        "UNITS/MM\nS=TABCYL/NOY,{}{curve}\n{}\nTOLER/{}\n{axis}D=PLANE/{:.6},{x:.6},0,0\n\
         E=PLANE/1,0,0,{far:.3}\nFROM/{:.3},{:.3},30\nGO/ON,D,TO,S\nINDIRV/{x:.5},{y:.5},0\n\
         TLON,GOFWD/D,ON,E\nFINI\n",
        fairing(k),
        cutter(k, 3.0 + 9.0 * share(k, 5)),
        [0.002, 0.01, 0.05][(k / 2 % 3) as usize],
        -y,
        -far,
        -far * y / x
    )
}

fn faults(program: impl Fn(u32) -> String) -> Vec<String> {
    let fault = |k: u32| {
        let program = program(k);
        let ran = run::run(&program, Verify::Full);
        (!ran.told.is_empty()).then(|| format!("{k}: {:?}\n{program}", ran.told))
    };
    (0..60).filter_map(fault).collect()
}

#[test]
fn a_leaning_tool_goes_round_corners() {
    let faults = faults(leaning);
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn a_tool_goes_across_waves_with_corners() {
    let faults = faults(lying);
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
