//! The way to the first position of a statement of regional milling in a CL file that is held against the program.

#[path = "support/run.rs"]
mod run;

use std::fmt::Write as _;

use aptc_control::{ClFile, Disk, Options, Source, Verify, verify};

/// A floor milled behind something that stands in the way; the tool is led over it.
fn program(wall: &str, mill: &str) -> String {
    format!(
        "PARTNO ARRIVALS
UNITS/MM
FLOOR=SSURF/SMESH,XYZ,SPLINE,(-18,-15,0),(0,-15,1),(18,-15,0),$
 SPLINE,(-18,15,0),(0,15,1),(18,15,0)
K1={wall}
UP=VECTOR/0,0,1
CUTTER/10,5,0,5,0,0,30
HOLDER/14,45,30,95
INTOL/.01
OUTTOL/.01
FROM/-90,0,20
GOTO/-90,0,200
GOTO/0,0,200
SCON/DS,FLOOR,PARAM,0,2,0,1,AT,UP
SCON/PS,TO,FLOOR,PLUS,0
SCON/AXIS,UP
CHKSRF/K1,ON
{mill}
END
FINI
"
    )
}

/// The places of a path as a CL file, without some of them.
fn file(ran: &run::Ran, left_out: std::ops::Range<usize>) -> Vec<u8> {
    let mut text = String::from("PARTNO ARRIVALS\nUNITS/MM\nMULTAX/ON\n");
    let all = ran.places.iter().zip(&ran.axes).enumerate();
    for (i, ([x, y, z], [a, b, c])) in all.filter(|(i, _)| !left_out.contains(i)) {
        let word = if i == 0 { "FROM" } else { "GOTO" };
        writeln!(text, "{word}/{x:.9},{y:.9},{z:.9},{a:.9},{b:.9},{c:.9}")
            .expect("memory takes it");
    }
    text.push_str("FINI\n");
    text.into_bytes()
}

/// What the proof of a file tells.
fn told(text: &str, bytes: Vec<u8>) -> Vec<String> {
    let options = Options { verify: Verify::Full, post: false, ..Options::default() };
    let source = Source { name: "part".into(), text: text.into() };
    let file = ClFile { name: "part.cl".into(), bytes };
    let found = verify(source, &mut Disk::new(Vec::new(), 0), &options, Some(file));
    let wrong = found.diagnostics.iter().filter(|d| d.code.to_string().starts_with("APT5"));
    wrong.map(|d| format!("{} {}", d.code, d.message)).collect()
}

const MILLS: [&str; 4] = [
    "SMIL/PATH,DS,PARAM,.2,.5,TANSPL,PLUS",
    "SMIL/POSN,DS,PARAM,.2,.5,INCR,0",
    "GOLOFT/FLOOR,VCONST,.5",
    "GOMILL/FLOOR,VCONST,.5,STEPOV,.5",
];

/// A sculptured wall, a bar that only the holder meets, a ball and a cylinder.
const WALLS: [&str; 4] = [
    "SSURF/SMESH,XYZ,SPLINE,(-60,-90,-40),(-60,-90,90),$\n SPLINE,(-60,90,-40),(-60,90,90)",
    "SSURF/SMESH,XYZ,SPLINE,(-60,-1,100),(-60,1,100),$\n SPLINE,(-50,-1,100),(-50,1,100)",
    "SPHERE/-50,0,20,25",
    "CYLNDR/-50,0,20,0,1,0,25",
];

#[test]
fn a_file_whose_way_to_the_first_position_goes_through_a_surface_is_refuted() {
    for wall in WALLS {
        for mill in MILLS {
            let text = program(wall, mill);
            let ran = run::run(&text, Verify::Off);
            assert_eq!(told(&text, file(&ran, 0..0)), Vec::<String>::new(), "{text}");
            // It goes straight there.
            let mut said = told(&text, file(&ran, 1..3));
            said.retain(|d| !d.starts_with("APT5003"));
            let way = " on the way to its first position by ";
            let met = |d: &String| {
                d.starts_with("APT5001 cut vector 1 cuts into checked surface K1")
                    && d.contains(way)
                    && d.contains(" at tool end ")
            };
            assert!(said.len() == 1 && said.iter().all(met), "{said:?}\n{text}");
        }
    }
}

/// The machine takes the tool away: how it comes back is not known, and of a rapid motion a file is told as the program is.
#[test]
fn words_between_motions_count_in_a_file_as_in_the_program() {
    let text = program(WALLS[0], &format!("RETRCT\n{}", MILLS[0]));
    let ran = run::run(&text, Verify::Off);
    let said = told(&text, file(&ran, 1..3));
    assert!(said.iter().all(|d| d.starts_with("APT5003")), "{said:?}");
    let text = "PARTNO RAPID\nUNITS/MM\nCUTTER/10\nINTOL/.01\nOUTTOL/.01\nL1=LINE/0,0,100,0\nL2=LINE/60,-100,60,100\n\
                FLOOR=PLANE/0,0,1,0\nFROM/-20,-20,30\nGO/TO,L1,TO,FLOOR\nTLRGT,GORGT/L1,PAST,L2\nRAPID\nGOTO/0,0,-9\n\
                GOTO/0,0,50\nFINI\n";
    let own = run::run(text, Verify::Full);
    let of_file = told(text, file(&own, 0..0));
    let own: Vec<_> = own.told.iter().map(|(code, text)| format!("{code} {text}")).collect();
    assert_eq!((of_file.len(), &of_file), (1, &own));
}

/// GCLEAR puts places before a line; what the tool goes through on its way over them is told as without them.
#[test]
fn a_way_by_places_of_gclear_through_the_part_surface_is_told() {
    let program = |from: &str, clear: &str, then: &str| {
        format!(
            "PARTNO LEADS
UNITS/MM
HILL=SSURF/SMESH,XYZ,$
 SPLINE,(-60,-30,0),(-20,-30,18),(20,-30,18),(60,-30,0),$
 SPLINE,(-60,0,0),(-20,0,20),(20,0,20),(60,0,0),$
 SPLINE,(-60,30,0),(-20,30,18),(20,30,18),(60,30,0)
CUTTER/10,5
INTOL/.01
OUTTOL/.01
FROM/{from}
SCON/DS,HILL,PARAM,0,2,0,1,AT,(VECTOR/0,0,1)
SCON/PS,TO,HILL,PLUS,0
SCON/AXIS,(VECTOR/0,0,1)
{clear}
GOLOFT/HILL,VCONST,1
{then}
FINI
"
        )
    };
    let near = "GCLEAR/START,NORMAL,3";
    let high = "GCLEAR/START,NORMAL,3,CLEARS,(PLANE/0,0,1,60)";
    let home = format!("{high}\nGCLEAR/THRU,NORMAL,2");
    let over = format!("{home},CLEARS,(PLANE/0,0,1,60)");
    let again = "GOLOFT/HILL,VCONST,1.2";
    let (below, above) = ("90,0,5", "90,0,60");
    for (from, clear, then, told) in [
        (below, near, "", 1),
        (below, "GCLEAR/START,NORMAL,3,CLEARS,(PLANE/0,0,1,10)", "", 1),
        (above, high, "", 0),
        ("-90,0,5", near, "", 0),
        // From the end of a line straight up towards the beginning of the next.
        (above, &home, again, 1),
        (above, &over, again, 0),
    ] {
        let text = program(from, clear, then);
        let ran = run::run(&text, Verify::Full);
        assert_eq!(ran.faults(), vec!["APT5009"; told], "{:?} {text}", ran.told);
    }
}

/// What GCLEAR puts behind a line, and before it, may lead along the floor into a ramp that rises at 45 degrees from x = 40. A ball
/// of 5 whose end is at (x, 0) is 5 - (45 - x) / sqrt 2 deep in it.
#[test]
fn what_gclear_adds_is_held_against_the_part_surface_where_it_ends() {
    let program = |clear: &str, line: &str, then: &str| {
        format!(
            "PARTNO RAMP
UNITS/MM
FLOOR=SSURF/SMESH,XYZ,SPLINE,(0,-40,0),(40,-40,0),$
 SPLINE,(0,40,0),(40,40,0)
RAMP=SSURF/SMESH,XYZ,SPLINE,(40,-40,0),(70,-40,30),$
 SPLINE,(40,40,0),(70,40,30)
F=SSURF/COMBIN,FLOOR,RAMP
CUTTER/10,5
INTOL/.01
OUTTOL/.01
FROM/20,0,60
{clear}
GOLOFT/F,VCONST,.5,{line}
{then}
FINI
"
        )
    };
    let there = "START,0,THRU,.5";
    let back = "START,0,THRU,.5,INVERS";
    let over = "GODLTA/0,0,60";
    let depth = |x: f64| 5.0 - (45.0 - x) * 0.5_f64.sqrt() - 0.01;
    for (clear, line, then, told) in [
        ("GCLEAR/THRU,MOTDIR,23", there, over, Some(depth(43.0))),
        ("GCLEAR/THRU,MOTDIR,23", there, "", Some(depth(43.0))),
        (
            "GCLEAR/THRU,MOTDIR,21,FEED,50",
            there,
            "FEDRAT/90\nRAPID\nGODLTA/0,0,60",
            Some(depth(41.0)),
        ),
        // Up along the axis it cuts nothing more.
        ("GCLEAR/THRU,MOTDIR,23,CLEARS,(PLANE/0,0,1,60)", there, "", Some(depth(43.0))),
        ("GCLEAR/START,MOTDIR,22", back, over, Some(depth(42.0))),
        ("GCLEAR/MOTDIR,17", there, over, None),
        ("GCLEAR/THRU,MOTDIR,23,NORMAL,18", there, over, None),
        ("GCLEAR/THRU,MOTDIR,23", back, over, None),
    ] {
        let text = program(clear, line, then);
        let ran = run::run(&text, Verify::Full);
        assert_eq!(
            ran.faults(),
            vec!["APT5009"; usize::from(told.is_some())],
            "{:?} {text}",
            ran.told
        );
        let Some(deep) = told else { continue };
        let words: Vec<&str> = ran.told.iter().flat_map(|(_, text)| text.split(' ')).collect();
        let by = words.iter().position(|w| *w == "by").expect("it tells how deep");
        let by: f64 = words[by + 1].parse().expect("a number");
        assert!(by > 0.85 * deep && by < deep + 1e-6, "{by} {deep} {:?}", ran.told);
    }
    // CHKSRF/PS,ON refuses it.
    let text = program("CHKSRF/PS,ON\nGCLEAR/THRU,MOTDIR,23", there, over);
    let ran = run::run(&text, Verify::Full);
    assert_eq!(
        ran.told.iter().map(|t| t.0.as_str()).collect::<Vec<_>>(),
        ["APT2046"],
        "{:?}",
        ran.told
    );
}
