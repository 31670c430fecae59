//! The units of files, and what is told of those that are not known.

#[expect(dead_code, reason = "other tests make more of it")]
mod ig;

use aptc_exchange::{Fault, Limits, Outside, read};
use aptc_geometry::sculpt::fit_surface;

fn tried(text: &str) -> Result<Outside, Fault> {
    read(text, &Limits::default()).expect("the format is seen")
}

/// A plane patch in STEP with these entities about its unit.
fn step(units: &str) -> Result<Outside, Fault> {
    let surface = "#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=CARTESIAN_POINT('',(0.,20.,0.));\n\
        #3=CARTESIAN_POINT('',(10.,0.,0.));\n#4=CARTESIAN_POINT('',(10.,20.,0.));\n\
        #5=B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#1,#2),(#3,#4)),.UNSPECIFIED.,.F.,.F.,.F.,(2,2),(2,2),(0.,1.),\
        (0.,1.),.UNSPECIFIED.);\n#6=SHAPE_REPRESENTATION('',(#5),#9);\n";
    tried(&format!(
        "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('a','b',(''),(''),'c','d','');\n\
         FILE_SCHEMA(('CONFIG_CONTROL_DESIGN'));\nENDSEC;\nDATA;\n{surface}{units}ENDSEC;\nEND-ISO-10303-21;\n"
    ))
}

/// A context that names the unit #10.
const CONTEXT: &str = "#9=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#10))\
    REPRESENTATION_CONTEXT('',''));\n";
const MM: &str = "#30=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n";

fn by_measure(measure: &str) -> String {
    format!(
        "{CONTEXT}{MM}#10=(CONVERSION_BASED_UNIT('INCH',#31)LENGTH_UNIT()NAMED_UNIT(#32));\n#31={measure};\n"
    )
}

#[test]
fn step_in_units_that_are_known() {
    for (unit, mm) in [
        ("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.))", 1000.0),
        ("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.NANO.,.METRE.))", 1e-6),
        ("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.HECTO.,.METRE.))", 1e5),
        ("SI_UNIT(*,.CENTI.,.METRE.)", 10.0),
    ] {
        let file = step(&format!("{CONTEXT}#10={unit};\n")).unwrap();
        assert!(file.notes.is_empty(), "{:?}", file.notes);
        assert!((file.unit_mm.unwrap() - mm).abs() < 1e-12 * mm, "{unit}");
    }
    for measure in [
        "LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#30)",
        "MEASURE_WITH_UNIT(25.4,#30)",
        "(LENGTH_MEASURE_WITH_UNIT()MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#30))",
        "(MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#30)LENGTH_MEASURE_WITH_UNIT())",
    ] {
        let file = step(&by_measure(measure)).unwrap();
        assert!(file.notes.is_empty(), "{:?}", file.notes);
        assert_eq!(file.unit_mm, Some(25.4), "{measure}");
    }
}

#[test]
fn step_in_units_that_are_not_known() {
    let around = "LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#10)";
    for unit in [
        format!("{CONTEXT}#10=(CONTEXT_DEPENDENT_UNIT('CUBIT')LENGTH_UNIT()NAMED_UNIT(#32));\n"),
        format!("{CONTEXT}#10=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MINI.,.METRE.));\n"),
        by_measure(around),
        by_measure("DESCRIPTION('25.4')"),
    ] {
        let file = step(&unit).unwrap();
        assert_eq!(file.unit_mm, None);
        assert_eq!(
            file.notes,
            ["its unit of length is not known (#10); that of the program is taken"]
        );
    }
    let none = step("#9=REPRESENTATION_CONTEXT('','');\n").unwrap();
    assert_eq!(none.notes, ["it names no unit of length; that of the program is taken"]);
    for x in ["0.", "-25.4", "1.E999"] {
        let measure = format!("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE({x}),#30)");
        let why = step(&by_measure(&measure)).unwrap_err();
        assert!(
            matches!(why, Fault::Broken { .. }) && why.to_string().contains("the factor"),
            "{why}"
        );
    }
}

/// A context in another unit of which no shape is says nothing; of two that have shapes no unit is that of all.
#[test]
fn step_in_several_units() {
    let other = "#40=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));\n\
        #41=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#40))REPRESENTATION_CONTEXT('',''));\n\
        #42=REPRESENTATION('volume',(#40),#41);\n";
    let own =
        format!("{CONTEXT}#10=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n{other}");
    let file = step(&own).unwrap();
    assert!(file.notes.is_empty() && file.unit_mm == Some(1.0), "{:?}", file.notes);
    // The context of the shape names none.
    let bare = "#9=(GEOMETRIC_REPRESENTATION_CONTEXT(3)REPRESENTATION_CONTEXT('',''));\n";
    assert_eq!(step(&format!("{bare}{other}")).unwrap().unit_mm, Some(1000.0));
    let why = step(&format!("{own}#43=SHAPE_REPRESENTATION('',(#5),#41);\n")).unwrap_err();
    assert_eq!(why.to_string(), "it has several units of length");
}

/// A plane patch in IGES with these fields: the scale, the flag of the unit and its name.
fn iges(fields: &str) -> Result<Outside, Fault> {
    let surface = "1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,10.,0.,0.,0.,20.,0.,10.,20.,0.,\
        0.,1.,0.,1.";
    tried(&ig::told(fields, &[(128, 0, surface.to_owned())]))
}

#[test]
fn iges_in_units_that_are_known() {
    for (fields, mm) in [
        ("1.,2,2HMM", 1.0),
        ("1.,1,", 25.4),
        ("1.,3,2HFT", 304.8),
        // Inches by the standard where neither is there; the name where it stands alone.
        ("1.,,", 25.4),
        (",,2HCM", 10.0),
    ] {
        let file = iges(fields).unwrap();
        assert!(file.notes.is_empty(), "{:?}", file.notes);
        assert_eq!(file.unit_mm, Some(mm), "{fields}");
    }
}

#[test]
fn iges_in_units_that_are_not_known() {
    for (fields, mm, says) in [
        ("1.,0,", None, "(flag 0, name empty); the unit of the program is taken"),
        ("1.,99,", None, "(flag 99, name empty); the unit of the program is taken"),
        ("1.,99,2HMM", Some(1.0), "(flag 99, name MM); the name is taken"),
        ("1.,3,", None, "(flag 3, name empty); the unit of the program is taken"),
        ("1.,3,5HCUBIT", None, "(flag 3, name CUBIT); the unit of the program is taken"),
        ("1.,,5HCUBIT", None, "(flag empty, name CUBIT); the unit of the program is taken"),
        ("1.,1,2HMM", Some(25.4), "the flag counts, a unit of 25.4 mm"),
    ] {
        let file = iges(fields).unwrap();
        assert_eq!(file.unit_mm, mm, "{fields}");
        assert!(file.notes.len() == 1 && file.notes[0].ends_with(says), "{:?}", file.notes);
    }
}

#[test]
fn scales_of_models() {
    for (scale, mm) in [(".5D0", 2.0), ("5.D-1", 2.0), ("2.d0", 0.5), (".25E1", 0.4)] {
        let file = iges(&format!("{scale},2,2HMM")).unwrap();
        assert!((file.unit_mm.unwrap() - mm).abs() < 1e-12, "{scale}");
        assert!(file.notes[0].ends_with("which is regarded"), "{:?}", file.notes);
    }
    for scale in ["0.", "-1.", "0.D0", "half", "1.E999"] {
        let why = iges(&format!("{scale},2,2HMM")).unwrap_err().to_string();
        assert!(why.ends_with("and not above zero"), "{why}");
    }
    let corner = |fields: &str| {
        let file = iges(fields).unwrap();
        fit_surface(&file.surfaces[0]).expect("a surface").at(1.0, 1.0).point
    };
    assert!((corner(".5D0,2,2HMM").x - 10.0).abs() < 1e-12);
}
