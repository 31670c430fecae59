//! GOTO of patterns with their modifiers.

mod support;

use aptc_protap::{Arg, Kind};
use support::{clean, run};

/// The stops of `GOTO/Q,modifiers` for the points 1 to 8 along x: x, or x and z when z is not 0; words of
/// CYCLE in their places.
fn stops(modifiers: &str) -> String {
    let text = format!("Q=PATERN/LINEAR,(POINT/1,0),(POINT/8,0),8\nGOTO/Q{modifiers}\nFINI\n");
    let mut stops = Vec::new();
    let show = |p: &aptc_geometry::Vec3| match p.z {
        0.0 => p.x.to_string(),
        z => format!("{}^{z}", p.x),
    };
    for kind in clean(&text).kinds() {
        match kind {
            Kind::Points { name, points } => {
                assert_eq!(name.name, "Q");
                stops.extend(points.iter().map(show));
            }
            Kind::Goto(place) => stops.push(show(&place.point)),
            Kind::Post { word, args } if word == "CYCLE" => {
                let [Arg::Word(mode)] = args.as_slice() else { panic!("{args:?}") };
                stops.push(mode.to_string());
            }
            Kind::Post { word, .. } => stops.push(word.to_string()),
            other => panic!("{other:?}"),
        }
    }
    stops.join(" ")
}

#[test]
fn patterns_in_order_and_reversed() {
    assert_eq!(stops(""), "1 2 3 4 5 6 7 8");
    assert_eq!(stops(",INVERS"), "8 7 6 5 4 3 2 1");
    assert_eq!(stops(",ZIGZAG"), "1 2 3 4 5 6 7 8");
    assert_eq!(stops(",20"), "FEDRAT 1 2 3 4 5 6 7 8");
}

#[test]
fn points_left_out_and_kept() {
    assert_eq!(stops(",OMIT,2,3,7"), "1 4 5 6 8");
    assert_eq!(stops(",RETAIN,2,THRU,6"), "2 3 4 5 6");
    assert_eq!(stops(",RETAIN,6,THRU,2"), "2 3 4 5 6");
    assert_eq!(stops(",RETAIN,4,THRU,6,8,OMIT,5"), "4 6 8");
    // Numbers count in the order of output, with CONST in that of definition.
    assert_eq!(stops(",INVERS,OMIT,1,2"), "6 5 4 3 2 1");
    assert_eq!(stops(",INVERS,CONST,OMIT,1,2"), "8 7 6 5 4 3");
}

#[test]
fn detours() {
    assert_eq!(stops(",RETAIN,1,THRU,3,AVOID,2,2"), "1 2 NOMORE 2^2 3^2 ON 3");
    assert_eq!(
        stops(",RETAIN,1,THRU,3,AVOID,2,1,AVOID,5,2"),
        "1 NOMORE 1^2 2^2 ON 2 NOMORE 2^5 3^5 ON 3"
    );
    // There is nothing to avoid behind the last point.
    assert_eq!(stops(",RETAIN,1,2,AVOID,2,2"), "1 2");
    // From the point before to the next that is not left out.
    assert_eq!(stops(",OMIT,2,4,THRU,8,AVOID,1,1"), "1 NOMORE 1^1 3^1 ON 3");
}

#[test]
fn mistakes() {
    for (modifiers, code) in [(",OMIT,9", 1214), (",OMIT", 1304), (",CLW", 1304), (",AVOID", 1304)]
    {
        let text = format!("Q=PATERN/LINEAR,(POINT/1,0),(POINT/8,0),8\nGOTO/Q{modifiers}\nFINI\n");
        assert_eq!(run(&text).told(), [(code, 2)], "{modifiers}");
    }
}
