//! Random programs of regional milling over a wavy surface, with a holder, beside planes, spheres, cylinders and cones, some in a
//! bowl or a trough.

use std::fmt::Write;

/// The program of that number, the same each time.
pub(crate) fn program(seed: u64) -> String {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x5555;
    let mut random = |from: f64, to: f64| {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * (state >> 40) as f64 / f64::from(1 << 24)
    };
    let mut out = String::from("PARTNO MILLED\nUNITS/MM\nFORM = SSURF/SMESH,XYZ");
    for i in 0..4 {
        out.push_str(",SPLINE");
        for j in 0..4 {
            let z = random(0.0, 9.0);
            write!(out, ",$\n({},{},{z:.3})", 20 * j, 20 * i).expect("text");
        }
    }
    out.push('\n');
    let corner = [1.0, 2.5, 5.0][(seed % 3) as usize];
    // The holder begins at the top of the cutter or above it.
    let (height, gap) = (random(15.0, 30.0), random(-8.0, 20.0_f64).max(0.0));
    let low = height + gap;
    writeln!(out, "CUTTER/10,{corner},{},{corner},0,0,{height:.2}", 5.0 - corner).expect("text");
    writeln!(out, "HOLDER/14,{low:.2},18,{:.2},30,{:.2}", low + 12.0, low + 20.0).expect("text");
    out.push_str("UP = VECTOR/0,0,1\nMULTAX/ON\nINTOL/.01\nOUTTOL/.01\nFROM/30,30,12\n");
    // A wall beside, leaning in; a ball above one corner; a post; a cone that hangs down.
    let lean = random(-0.3, 0.05);
    writeln!(out, "K1 = PLANE/1,0,{lean:.4},{:.3}", random(61.0, 70.0) - 10.0 * lean)
        .expect("text");
    let radius = random(5.0, 30.0);
    let above = low + radius + random(2.0, 12.0);
    writeln!(
        out,
        "K2 = SPHERE/{:.3},{:.3},{above:.3},{radius:.3}",
        random(-40.0, 0.0) - 0.4 * radius,
        random(0.0, 60.0),
    )
    .expect("text");
    writeln!(
        out,
        "K3 = CYLNDR/{:.3},{:.3},0,{:.3},{:.3},1,{:.3}",
        random(20.0, 40.0),
        random(-25.0, -12.0),
        random(-0.2, 0.2),
        random(-0.2, 0.0),
        random(2.0, 8.0),
    )
    .expect("text");
    writeln!(
        out,
        "K4 = CONE/(POINT/{:.3},{:.3},{:.3}),UP,{:.2}",
        random(0.0, 60.0),
        random(70.0, 85.0),
        random(5.0, 40.0),
        random(10.0, 25.0),
    )
    .expect("text");
    // A bowl or a trough all round, out of which a tall tool reaches.
    let (round, deep) = (random(48.0, 64.0), random(2.0, 14.0));
    match seed % 5 {
        0 => writeln!(out, "K5 = SPHERE/30,30,{deep:.3},{round:.3}"),
        1 => writeln!(out, "K5 = CYLNDR/30,30,{deep:.3},1,{:.3},0,{round:.3}", random(-0.5, 0.5)),
        _ => writeln!(out, "K5 = PLANE/0,0,1,-30"),
    }
    .expect("text");
    let [u, v] = [random(0.1, 0.6), random(2.3, 2.9)];
    writeln!(out, "SCON/DS,FORM,PARAM,{u:.3},{v:.3},{u:.3},{v:.3},AT,UP").expect("text");
    out.push_str("SCON/PS,TO,FORM,PLUS,0\n");
    match seed / 3 % 3 {
        0 => out.push_str("SCON/AXIS,UP\n"),
        1 => out.push_str("SCON/AXIS,NORMDS\n"),
        _ => {
            let [x, y] = [random(-0.3, 0.3), random(-0.3, 0.3)];
            writeln!(out, "SCON/AXIS,(VECTOR/{x:.3},{y:.3},1)").expect("text");
        }
    }
    out.push_str(
        "SCON/FEED,0,0,0,0\nSCON/STEPOV,0,9,0,0\nCHKSRF/K1,K2,K3,K4,K5,ON\nCHKSRF/PS,ON\n",
    );
    if seed.is_multiple_of(2) {
        out.push_str("AVCTRL/CUTANG,CONST,1,RANGE,-40,40,AXIS,LIMIT,30\n");
    }
    writeln!(out, "SMIL/ZIGZAG,DS,PARAM,{u:.3},{u:.3},TANSPL,PLUS,STEPOV,PLUS").expect("text");
    out.push_str("END\nFINI\n");
    out
}
