//! Wide cutters over a wavy TABCYL, RLDSRF or POLCON, and long flanks beside one: they span many crests, and every cut vector is
//! proved.

#[path = "support/run.rs"]
mod run;

use std::fmt::Write as _;

use aptc_control::Verify;
use aptc_geometry::trig;

/// The `i`th place of a low discrepancy sequence for the program `k`: fractions that do not repeat.
fn share(k: u32, i: u32) -> f64 {
    (f64::from(k + 1) * 0.618_033_988_75 * f64::from(i)).fract()
}

/// A wave along x, or along z where it is a wall, that repeats itself but for its last digits, with the tool on its way across.
fn program(k: u32, wall: bool) -> String {
    let share = |i: u32| share(k, i);
    let (height, length) = (0.05 + 0.25 * share(1), 6.0 + 18.0 * share(2));
    let step = length / f64::from(6 + k % 5);
    let mut points = String::new();
    let mut x = -70.0;
    while x < 70.0 {
        let turn = std::f64::consts::TAU * (x / length + share(3));
        let bend = height * (trig::sin(turn) + 0.15 * trig::sin(3.7 * turn));
        let (z, x_of) = if wall { (x, bend) } else { (bend, x) };
        write!(points, ",$\n{z:.4},{x_of:.5}").unwrap_or_default();
        x += step;
    }
    let (diameter, corner) = (16.0 + 9.0 * share(4), [0.0, 0.5, 2.0][(k % 3) as usize]);
    let (tolerance, slope) = (0.002 + 0.04 * share(5), 1.2 * share(6) - 0.6);
    let (way, from, check) = if wall {
        (format!("PLANE/0,{slope},1,0"), "40,-30,5", "PLANE/0,1,0,30")
    } else {
        (format!("PLANE/{slope},1,0,0"), "-30,0,5", "PLANE/1,0,0,30")
    };
    let forward = if wall { "0,1,0" } else { "1,0,0" };
    format!(
        "UNITS/MM\nWAVE=TABCYL/NOY,SPLINE{points}\nWAY={way}\nEND={check}\nTOLER/{tolerance}\n\
         CUTTER/{diameter},{corner}\nFROM/{from}\nINDIRV/{}\nGO/ON,WAY,TO,WAVE\nINDIRV/{forward}\n\
         TLON,GOFWD/WAY,ON,END\nFINI\n",
        if wall { "-1,0,0" } else { "0,0,-1" }
    )
}

/// Rulings between two waves beside each other, of the same length or nearly so.
fn ruled(k: u32) -> String {
    let share = |i: u32| share(k, i);
    let length = 6.0 + 18.0 * share(1);
    let mut rails = String::new();
    for (name, y, i) in [("A", -60, 2), ("B", 60, 7)] {
        let height = 0.05 + 0.25 * share(i);
        let length = length * if y > 0 { 1.0 + 0.2 * (share(8) - 0.5) } else { 1.0 };
        let step = length / f64::from(6 + k % 5);
        let (lift, phase) =
            if y > 0 { (4.0 * share(9) - 2.0, 0.3 * share(10)) } else { (0.0, 0.0) };
        let mut points = String::new();
        let mut x = -70.0;
        while x < 80.0 {
            let turn = std::f64::consts::TAU * (x / length + share(3) + phase);
            let bend = height * (trig::sin(turn) + 0.15 * trig::sin(3.7 * turn));
            write!(points, ",$\n{:.4},{x:.5}", lift + bend).unwrap_or_default();
            x += step;
        }
        writeln!(rails, "W{name}=TABCYL/NOY,SPLINE{points}").unwrap_or_default();
        for (p, x, z) in [("1", -60, lift), ("2", 60, lift), ("3", 0, lift + 5.0)] {
            writeln!(rails, "{name}{p}=POINT/{x},{y},{z}").unwrap_or_default();
        }
    }
    let (diameter, corner) = (16.0 + 9.0 * share(4), [0.0, 0.5, 2.0][(k % 3) as usize]);
    let (tolerance, slope) = (0.002 + 0.04 * share(5), 1.2 * share(6) - 0.6);
    format!(
        "UNITS/MM\n{rails}WAVES=RLDSRF/WA,A1,A2,A3,WB,B1,B2,B3\nWAY=PLANE/{slope},1,0,0\n\
         END=PLANE/1,0,0,20\nTOLER/{tolerance}\nCUTTER/{diameter},{corner}\nFROM/-20,{},5\n\
         INDIRV/0,0,-1\nGO/ON,WAY,TO,WAVES\nINDIRV/1,0,0\nTLON,GOFWD/WAY,ON,END\nFINI\n",
        20.0 * slope
    )
}

/// A polyconic along x whose height is a wave of degree seven, the arch of its sections changing with it; as a wall it stands on
/// end.
fn polyconic(k: u32, wall: bool) -> String {
    let share = |i: u32| share(k, i);
    let (length, width) = (30.0 + 90.0 * share(1), 25.0 + 35.0 * share(2));
    // Chebyshev's polynomials of degree 5 to 7 over 0 to 1, shifted powers first.
    let waves = [
        [-1.0, 50.0, -400.0, 1120.0, -1280.0, 512.0, 0.0, 0.0],
        [1.0, -72.0, 840.0, -3584.0, 6912.0, -6144.0, 2048.0, 0.0],
        [-1.0, 98.0, -1568.0, 9408.0, -26880.0, 39424.0, -28672.0, 8192.0],
    ];
    let height = 0.05 + 0.4 * share(3);
    let sum = |i: usize| {
        let parts = waves.iter().zip([4, 5, 6]);
        parts.map(|(wave, of)| wave[i] * height * (share(of) - 0.5)).sum::<f64>()
    };
    let rise = (0.2 + 8.0 * share(7)) * if k.is_multiple_of(2) { 1.0 } else { -1.0 };
    let p = 0.6 + 0.2 * share(8);
    let mut e = [0.0; 79];
    e[0] = 1.0;
    if wall {
        e[1..13].copy_from_slice(&[-1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    }
    (e[14], e[15]) = (-0.5 * length, length);
    (e[16], e[32], e[48]) = (-width, -width, width);
    (e[24], e[25], e[40], e[41]) = (rise, 0.2 * rise, -rise, -0.2 * rise);
    for i in 0..8 {
        e[56 + i] = sum(i) - e[24 + i] * (2.0 * p - 1.0);
    }
    e[64] = p;
    let elements: String = e.iter().map(|x| format!(",$\n{x:.8}")).collect();
    let diameter = 8.0 + 14.0 * share(9);
    let corner = [0.0, 0.5, 2.0][(k % 3) as usize];
    let (tolerance, slope) = (0.005 + 0.04 * share(10), 0.8 * share(11) - 0.4);
    let end = 0.36 * length - 0.3 * diameter;
    let z = -0.7 * width;
    let (way, go, from, forward, word) = if wall {
        let way = format!("PLANE/{:.4},0,1,{z:.4}", 0.2 * slope);
        let from = format!("{:.4},{:.4},{:.4}\nINDIRV/0,-1,0", -end, 30.0 + diameter, z + 3.0);
        (way, "TO,WAVE,TO,WAY", from, "WAVE", "TLLFT")
    } else {
        let from = format!("{:.4},{:.4},25\nINDIRV/0,0,-1", -end, slope * end);
        (format!("PLANE/{slope:.4},1,0,0"), "ON,WAY,TO,WAVE", from, "WAY", "TLON")
    };
    format!(
        "UNITS/MM\nWAVE=POLCON/CANON{elements}\nWAY={way}\nEND=PLANE/1,0,0,{end:.4}\nTOLER/{tolerance}\n\
         CUTTER/{diameter:.4},{corner},{:.6},{corner},0,0,{width:.4}\nFROM/{from}\nGO/{go}\n\
         INDIRV/1,0,0\n{word},GOFWD/{forward},ON,END\nFINI\n",
        0.5 * diameter - corner
    )
}

/// A wave with an edge beside its crests, the axis leaning, the tool begun at `x`.
fn leaning(x: f64) -> String {
    format!(
        "UNITS/MM\nWAVE=TABCYL/NOY,SPLINE,.2467,-41.073,.28411,-39.7582,.2505,-38.4433,$\n\
         .12121,-37.1285,-.05438,-35.8136,-.2092,-34.4987,-.25482,-33.1839,$\n\
         -.2457,-31.869,-.12121,-30.5542,.10135,-29.2393,.2646,-27.9244,$\n\
         .3334,-26.6096,.2505,-25.2947,.14803,-23.9798,-.05438,-22.665,$\n\
         -.19247,-21.3501,-.28411,-20.0353,-.2505,-18.7204,-.12121,-17.4055,$\n\
         .05438,-16.0907,.24636,-14.7758,.32286,-13.461,.2505,-12.1461\n\
         WAY=PLANE/.502554,.864546,0,0\nEND=PLANE/1,0,0,-24\nTOLER/.00755\nCUTTER/16.961,2\n\
         MULTAX\nTLAXIS/.0824,-.0487,1\nFROM/{x:.2},{:.4},5\nGO/ON,WAY,TO,WAVE\n\
         INDIRV/1,0,0\nTLON,GOFWD/WAY,ON,END\nFINI\n",
        -x * 0.502_554 / 0.864_546
    )
}

/// A wave through places farther apart than a bull nose is wide, which goes through the bottoms of its hollows: there its corner
/// touches on both sides at once.
fn sparse(k: u32) -> String {
    let share = |i: u32| share(k, i);
    let (step, height) = (18.0 + 14.0 * share(1), 2.0 + 3.0 * share(2));
    let mut points = String::new();
    let mut x = -80.0;
    while x <= 80.0 {
        let turn = std::f64::consts::TAU * (x / (2.7 * step) + share(3));
        write!(points, ",$\n{:.5},{x:.4}", height * trig::sin(turn)).unwrap_or_default();
        x += step;
    }
    let diameter = 6.0 + 6.0 * share(4);
    let corner = diameter * (0.1 + 0.35 * share(5));
    let outtol = [0.05, 0.01, 0.001, 0.0005][(k % 4) as usize];
    let intol = if (k / 4).is_multiple_of(2) { 0.0 } else { outtol };
    format!(
        "UNITS/MM\nWAVE=TABCYL/NOY,SPLINE{points}\nWAY=PLANE/0,1,0,0\nEND=PLANE/1,0,0,45\nINTOL/{intol}\n\
         OUTTOL/{outtol}\nCUTTER/{diameter:.3},{corner:.3}\nFROM/-45,0,9\nINDIRV/0,0,-1\n\
         GO/ON,WAY,TO,WAVE\nINDIRV/1,0,0\nTLON,GOFWD/WAY,ON,END\nFINI\n"
    )
}

/// What is told of programs, each with its number.
fn told(programs: impl Iterator<Item = String>) -> Vec<String> {
    let told = programs.enumerate().flat_map(|(k, text)| {
        let told = run::run(&text, Verify::Full).told.into_iter();
        told.map(move |(code, message)| format!("{k}: {code} {message}"))
    });
    told.collect()
}

#[test]
fn all_crests_below_a_wide_cutter_are_kept() {
    let told = told((0..120).map(|k| program(k / 2, k % 2 > 0)));
    assert!(told.is_empty(), "{told:#?}");
}

#[test]
fn both_sides_of_hollows_between_far_places_are_kept() {
    let told = told((0..80).map(sparse));
    assert!(told.is_empty(), "{told:#?}");
}

#[test]
fn all_crests_of_rulings_are_kept() {
    let told = told((0..16).map(ruled));
    assert!(told.is_empty(), "{told:#?}");
}

#[test]
fn all_crests_of_polyconics_are_kept() {
    let told = told((0..160).map(|k| polyconic(k / 2, k % 2 > 0)));
    assert!(told.is_empty(), "{told:#?}");
}

#[test]
fn an_edge_of_the_gap_is_seen_where_both_places_lie_side_by_side() {
    let told = told((0..20).map(|i| leaning(-36.5 + 0.13 * f64::from(i))));
    assert!(told.is_empty(), "{told:#?}");
}

/// A flank beside an upright cylinder, or over a lying one, that comes to stand along its rulings and goes over from one of its ends
/// to the other: surfaces, cutter, band, check surface, start, the way to both surfaces and the motion.
const OVER: [[&str; 10]; 4] = [
    [
        "0,0,-31.335,-.97249,.23295,0,31.335",
        "-.155,-6.642,0,0,0,1,8.264",
        "16,0,8,0,0,0,40",
        "OUTTOL/0\nINTOL/.00695",
        ".98482,-.17358,0,1",
        "23.031,-13.791,30",
        "NORMDS",
        "-23.18664,7.14921,0",
        "-.29465,-.95561,0",
        "TLLFT,GOFWD/DS,TO,CS",
    ],
    [
        "0,0,-91.125,.59886,-.80085,0,91.125",
        "12.003,-1.125,0,0,0,1,11.031",
        "10,0,5,0,0,0,20",
        "OUTTOL/0\nINTOL/.01263",
        ".98152,.19134,0,11.566",
        "-4.967,-13.546,30",
        "NORMPS",
        "16.97037,12.42145,0",
        ".59064,-.80694,0",
        "TLRGT,GOFWD/DS,ON,CS",
    ],
    [
        "0,0,-42.36,-.9247,-.3807,0,42.36",
        "6.77,-2.124,0,0,0,1,14.644",
        "20,10,0,10,0,0,20",
        "INTOL/0\nOUTTOL/.00157",
        "-.81897,.57383,0,-6.763",
        "40.72,-9.019,30",
        "NORMPS",
        "-33.95053,6.89469,0",
        ".19902,.98,0",
        "TLRGT,GOFWD/DS,PAST,CS",
    ],
    [
        "0,0,-43.962,-.61552,.78812,0,43.962",
        ".247,-4.815,0,0,0,1,10.51",
        "12,3,3,3,0,0,40",
        "INTOL/0\nOUTTOL/.0035",
        ".97318,.23005,0,-.867",
        "22.502,-8.195,30",
        "NORMDS",
        "-22.25439,3.38017,0",
        "-.15017,-.98866,0",
        "TLLFT,GOFWD/DS,ON,CS",
    ],
];

#[test]
fn an_edge_of_the_gap_is_seen_where_a_flank_goes_over_from_end_to_end() {
    let program = |[ps, ds, cutter, band, cs, from, axis, to, on, go]: [&str; 10]| {
        format!(
            "MULTAX\nPS=CYLNDR/{ps}\nDS=CYLNDR/{ds}\nCUTTER/{cutter}\n{band}\nCS=PLANE/{cs}\nFROM/{from}\n\
             TLAXIS/{axis}\nINDIRV/{to}\nGO/TO,DS,TO,PS\nINDIRV/{on}\n{go}\nFINI\n"
        )
    };
    let told = told(OVER.into_iter().map(program));
    assert!(told.is_empty(), "{told:#?}");
}

/// Waves of .2 in a band of 1 take two cut vectors, whichever crests a flat end lies on between: what is farther from it than one of
/// them, and was touched before, asks for none.
#[test]
fn waves_lower_than_the_band_are_gone_over_at_once() {
    let rows: Vec<String> = (0..17)
        .map(|j| {
            let y = -30.0 + 3.75 * f64::from(j);
            let place = |k: i32| {
                let x = -60.0 + 7.5 * f64::from(k);
                format!(",$\n({x},{y},{:.5})", 0.2 * trig::sin(0.1 * x))
            };
            format!(",$\nSPLINE{}", (0..17).map(place).collect::<String>())
        })
        .collect();
    let text = format!(
        "PARTNO WAVES\nUNITS/MM\nS=SSURF/SMESH,XYZ{}\nD=PLANE/0,1,0,0\nCUTTER/10\nINTOL/.01\nOUTTOL/1\n\
         FROM/-50,0,40\nGO/ON,D,TO,S,ON,(PLANE/1,0,0,-50)\nINDIRV/1,0,0\n\
         TLON,GOFWD/D,ON,(PLANE/1,0,0,50)\nFINI\n",
        rows.concat()
    );
    let ran = run::run(&text, Verify::Full);
    assert!(ran.faults().is_empty(), "{:?}", ran.told);
    assert!(ran.places.len() <= 4, "{:?}", ran.places);
}
