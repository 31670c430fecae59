//! Regional milling at its ends: a tool end led over a border, out of the way and back, a single pass, an edge that
//! is to go in.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;

/// Statements after those that define a dome of 60 by 60, a flat sheet above and a wall over the dome.
fn program(cutter: &str, work: &str) -> String {
    format!(
        "PARTNO ENDS
UNITS/MM
DOME=SSURF/SMESH,XYZ,SPLINE,(0,0,0),(30,0,3),(60,0,0),$
 SPLINE,(0,30,3),(30,30,7),(60,30,3),$
 SPLINE,(0,60,0),(30,60,3),(60,60,0)
OVER=SSURF/SMESH,XYZ,SPLINE,(-5,-5,20),(65,-5,20),$
 SPLINE,(-5,65,20),(65,65,20)
WALL=SSURF/SMESH,RULED,SPLINE,(34,-9,-5),(34,69,-5),$
 SPLINE,(34,-9,20),(34,69,20)
LEAN=SSURF/SMESH,RULED,SPLINE,(42,-9,12),(42,69,12),$
 SPLINE,(28,-9,42),(28,69,42)
UP=VECTOR/0,0,1
SAFE=PLANE/0,0,1,60
CUTTER/{cutter}
INTOL/.01
OUTTOL/.01
MULTAX/ON
FROM/30,30,100
SCON/FEED,0,0,0,0
SCON/FEED,SAFE
{work}
END
FINI
"
    )
}

/// The codes of what is wrong with path or proof.
fn faults(cutter: &str, work: &str) -> Vec<String> {
    told(program(cutter, work))
}

fn told(text: String) -> Vec<String> {
    run::run(&text, Verify::Full).faults()
}

const BALL: &str = "6,3,0,3,0,0,30";
const FLAT: &str = "8,0,4,0,0,0,30";

/// The path follows the surface straight on beyond its borders, and so does the proof.
#[test]
fn a_tool_end_goes_over_a_border() {
    for smil in ["ZIGZAG", "PICKFD"] {
        let work = format!(
            "SCON/DS,OVER,PARAM,0,1,0,1,AT,(VECTOR/.1,0,1)
SCON/PS,ON,DOME,PLUS,0
SCON/AXIS,UP
SCON/STEPOV,0,9,0,0
SMIL/{smil},DS,PARAM,0,0,TANSPL,PLUS,STEPOV,PLUS"
        );
        assert_eq!(faults(BALL, &work), Vec::<String>::new(), "{smil}");
    }
}

/// A scallop of any height asks for no more than the greatest step and the cutter's width give.
#[test]
fn a_scallop_higher_than_the_cutter_asks_for_nothing() {
    for height in ["12", "999"] {
        for work in [
            format!("SCON/STEPOV,{height},4,0,0\nSMIL/ZIGZAG,DS,PARAM,0,0,TANSPL,PLUS,STEPOV,PLUS"),
            format!("GOMILL/DOME,UCONST,0,STEPOV,.25,SCALOP,{height},MAXSTP,4"),
        ] {
            for cutter in [BALL, "8,1,3,1,0,0,30"] {
                let work = format!(
                    "SCON/DS,DOME,PARAM,0,2,0,2,AT,UP\nSCON/PS,TO,DOME,PLUS,0\nSCON/AXIS,UP\n{work}"
                );
                assert_eq!(faults(cutter, &work), Vec::<String>::new(), "{cutter} {work}");
            }
        }
    }
}

/// A tool end that is led on a surface leaves it where it lifts over a wall, and stays on it where it tilts.
#[test]
fn a_tool_end_gets_out_of_the_way() {
    for (wall, to, avoid) in
        [("WALL", 2, "NORMPS,LIMIT,90"), ("LEAN", 1, "CUTANG,CONST,2,RANGE,-80,80,AXIS,LIMIT,0")]
    {
        for smil in
            ["PATH,DS,PARAM,0,.5,TANSPL,PLUS", "ZIGZAG,DS,PARAM,0,0,CRSSPL,PLUS,STEPOV,PLUS"]
        {
            let work = format!(
                "SCON/DS,DOME,PARAM,0,{to},0,2,AT,UP
SCON/PS,ON,DOME,PLUS,0
SCON/AXIS,UP
SCON/STEPOV,0,9,0,0
CHKSRF/{wall},ON
AVCTRL/{avoid}
SMIL/{smil}"
            );
            let without = work.replace(&format!("AVCTRL/{avoid}\n"), "");
            assert_eq!(faults(FLAT, &without), ["APT2046"], "{smil}");
            assert_eq!(faults(FLAT, &work), Vec::<String>::new(), "{avoid} {smil}");
        }
    }
}

/// Where the axis turns with the direction of the path the tool goes from the end of a pass, lifted over a sheet and leaning along
/// it, to the side step, which leans across: that way goes over the sheet too, also where a lift is asked for. All of it is
/// proved; only what is left between passes that are led ON and lifted is not judged.
#[test]
fn the_way_to_a_lifted_side_step_is_checked() {
    let text = "PARTNO LIFTED
UNITS/MM
FORM=SSURF/SMESH,XYZ,SPLINE,(-1.9461,0.0000,0.1511),(27.6299,$
 0.0000,0.5661),(60.0000,0.0000,0.1871),(90.0000,1.5442,0.4139),$
 (120.0000,0.0000,0.0051),SPLINE,(-5.8430,30.0000,0.3002),$
 (22.4498,30.0000,0.5151),(55.3110,30.0000,0.3419),(84.1570,$
 30.0000,0.0914),(114.1570,30.0000,0.3513),SPLINE,(-11.6860,$
 60.6647,0.5497),(15.5710,60.0000,0.3214),(48.3140,60.0000,$
 0.1442),(78.3140,60.0000,0.3011),(108.3140,60.0000,0.2481),$
 SPLINE,(-17.6502,90.0000,0.1448),(12.4710,90.0000,0.1878),$
 (42.4710,90.0000,0.5410),(72.4710,87.0170,0.4803),(102.4710,$
 90.0000,0.3726)
CUTTER/10.0000,5.0000,0,5.0000,0,0,50.7299
INTOL/0.0100
OUTTOL/0.0200
UP=VECTOR/0,0,1
MULTAX/ON
SAFE=PLANE/0,0,1,11.2000
CHKA=SSURF/SMESH,RULED,SPLINE,(74.8683,-5,7.5372),(74.8683,$
 95.0000,7.5372),SPLINE,(95.1506,-5,8.7423),(95.1506,95.0000,$
 8.7423)
FROM/17.8351,54.6109,142.6598
SCON/DS,FORM,PARAM,1.4137,3.1667,0.6415,2.8191,AT,UP
SCON/PS,ON,FORM,PLUS,0.0000
SCON/AXIS,ATANGL,PS,24.3286,CUTANG,5.2273
SCON/FEED,1200,900,400,2000
SCON/FEED,SAFE
SCON/STEPOV,.0282,2,1,0
CHKSRF/CHKA,ON
CHKSRF/PS,ON
AVCTRL/NORMPS,LIMIT,60.0000
SMIL/ZIGZAG,DS,PARAM,1.4137,0.6415,CRSSPL,PLUS,STEPOV,PLUS
END
FINI
";
    assert_eq!(told(text.into()), ["APT5002"]);
}

/// What stands between passes of a tool end is judged where it stays on the surface; beside one pass there is nothing.
#[test]
fn what_lies_between_passes() {
    let work = |ps: &str, most: u32, smil: &str| {
        format!(
            "SCON/DS,DOME,PARAM,.5,.9,.5,.9,AT,UP
SCON/PS,{ps},DOME,PLUS,0
SCON/AXIS,UP
SCON/STEPOV,.05,4,0,{most}
SMIL/{smil},DS,PARAM,.5,.5,TANSPL,PLUS,STEPOV,PLUS"
        )
    };
    for cutter in [BALL, FLAT] {
        assert_eq!(faults(cutter, &work("ON", 0, "ZIGZAG")), Vec::<String>::new());
        assert_eq!(faults(cutter, &work("ON", 0, "PICKFD")), ["APT5002"]);
    }
    for smil in ["ZIGZAG", "PICKFD"] {
        assert_eq!(faults(BALL, &work("TO", 1, smil)), Vec::<String>::new());
    }
}

/// A flat end cannot be so deep in a surface with its edge; a corner that is round enough can.
#[test]
fn an_edge_goes_in_by_no_thickness() {
    let work = "SCON/DS,DOME,PARAM,0,2,0,2,AT,UP
SCON/PS,TO,DOME,PLUS,-.1
SCON/AXIS,UP
SMIL/PATH,DS,PARAM,0,.5,TANSPL,PLUS";
    assert_eq!(faults(FLAT, work), ["APT2027"]);
    let work = work.replace("SCON/AXIS,UP", "SCON/AXIS,NORMDS");
    assert_eq!(faults(FLAT, &work), ["APT2027"]);
    assert_eq!(faults("8,1,3,1,0,0,30", &work), Vec::<String>::new());
}

/// Along the level ruling on top of a lying cone a flat end comes to the tip: there the way ends, the surfaces do not run side by side.
#[test]
fn a_motion_past_the_tip_of_a_cone_ends_there() {
    let [c, s] = [aptc_geometry::trig::cos_deg(10.0), aptc_geometry::trig::sin_deg(10.0)];
    let text = format!(
        "PARTNO TIP\nUNITS/MM\nY0=PLANE/0,1,0,0\nTIP=CONE/(POINT/100,0,0),(VECTOR/-{c:.9},0,-{s:.9}),10\nCUTTER/24\n\
         INTOL/.04\nOUTTOL/.04\nFROM/20,0,60\nGO/ON,Y0,TO,TIP,ON,(PLANE/1,0,0,20)\nINDIRV/1,0,0\n\
         TLON,GOFWD/Y0,ON,(PLANE/1,0,0,300)\nNOPOST\nFINI\n"
    );
    let ran = run::run(&text, Verify::Full);
    assert_eq!(ran.faults(), ["APT2021"], "{:?}", ran.told);
}
