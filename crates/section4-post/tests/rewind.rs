//! Rotary axes that turn over within a motion: the tool goes up along itself, the axes turn, and it comes back.

mod common;

use aptc_geometry::trig;
use aptc_post::{PostOptions, Posted, machine, post_all};
use common::records;

/// A cut with a tool that leans by 30 degrees, whose direction goes round by 300 degrees.
fn posted(before: &str) -> (String, Posted) {
    let mut m = machine("linuxcnc-5axis").expect("built in").clone();
    (m.rotary[0].min, m.rotary[0].max) = (Some(-5.0), Some(110.0));
    (m.rotary[1].min, m.rotary[1].max) = (Some(-180.0), Some(180.0));
    (m.multiaxis.rewind_retract, m.multiaxis.rewind_feed) = (30.0, 2000.0);
    let mut cl = format!(
        "UNITS/MM\nCUTTER/8\nMULTAX\nLOADTL/2,LENGTH,80\nSPINDL/3000,CLW\nCOOLNT/ON\nFEDRAT/500\n{before}"
    );
    cl.push_str("FROM/40,0,90,0,0,1\n");
    for i in 0..16 {
        let a = 20.0 * f64::from(i) + 3.0;
        let (s, c) = (trig::sin_deg(a), trig::cos_deg(a));
        let rapid = if i == 0 { "RAPID\n" } else { "" };
        let (x, y, i, j) = (40.0 * c, 40.0 * s, 0.5 * c, 0.5 * s);
        cl.push_str(&format!("{rapid}GOTO/{x},{y},0,{i},{j},.8660254037844386\n"));
    }
    cl.push_str("FINI");
    post_all(&m, PostOptions::default(), &records(&cl))
}

/// By how much the tool was retracted.
fn retracted(posted: &Posted) -> Vec<f64> {
    let said = posted.diagnostics.iter().filter(|d| d.code.to_string() == "APT4023");
    said.filter_map(|d| d.message.rsplit_once("by ")?.1.parse().ok()).collect()
}

#[test]
fn the_tool_goes_above_the_clearance_plane_and_the_stock() {
    let (nc, plain) = posted("");
    assert!(!plain.diagnostics.iter().any(|d| d.is_error()), "{:#?}\n{nc}", plain.diagnostics);
    assert_eq!(retracted(&plain), [30.0], "{nc}");
    let slope = trig::cos_deg(30.0);
    for (before, height) in
        [("CLRSRF/60\n", 60.0), ("STOCK/-30,-30,-40,30,30,48\n", 50.0), ("CLRSRF/20\n", 0.0)]
    {
        let (nc, p) = posted(before);
        let [up] = retracted(&p)[..] else { panic!("{before}{:#?}\n{nc}", p.diagnostics) };
        // Between two positions of the chord the axis leans a little less.
        assert!((up - f64::max(30.0, height / slope)).abs() < 0.3, "{before}{up}\n{nc}");
    }
}
