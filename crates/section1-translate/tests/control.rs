//! Loops, jumps, macros, files, synonyms, several programs.

mod support;

use std::collections::BTreeMap;

use aptc_diagnostics::FrameKind;
use aptc_geometry::Vec3;
use aptc_protap::{Arg, DriveSide, Kind, Outcome};
use aptc_translate::Options;
use support::{Shelf, clean, numbers, run, run_with};

#[test]
fn if_has_three_ways() {
    let text = "A=-1\nLOOPST\nT) IF(A)N,Z,P\nN) GOTO/1,0,0\nJUMPTO/E\nZ) GOTO/2,0,0\nJUMPTO/E\n\
        P) GOTO/3,0,0\nE) A=A+1\nIF(A-1.5)T,T,D\nD) LOOPND\nFINI\n";
    assert_eq!(numbers(&clean(text)), [1.0, 2.0, 3.0]);
}

#[test]
fn a_loop_by_steps_of_three_hundredths_sees_its_end() {
    let text = "A=.2\nN=0\n1) N=N+1\nA=A+.03\nIF(.5-A)2,1,1\n2) GOTO/N,0,0\nFINI\n";
    assert_eq!(numbers(&clean(text)), [11.0]);
}

#[test]
fn jumps_work_outside_of_loops() {
    assert_eq!(
        numbers(&clean("JUMPTO/10\nGOTO/1,0,0\n10) GOTO/2,0,0\nTRANTO/E\nGOTO/3,0,0\nE) FINI\n")),
        [2.0]
    );
}

#[test]
fn do_counts_up_down_and_not_at_all() {
    let text = "DO/1,I=1,3\nDO/1,J=10,20,10\n1) GOTO/(I+J),0,0\n\
        DO/2,I=3,1,-1\n2) GOTO/I,0,0\n\
        DO/3,I=1,0\n3) GOTO/99,0,0\n\
        DO/4,A=0,1,.1\nN=A\n4) CONTIN\nGOTO/N,0,0\nFINI\n";
    let expected = [11.0, 21.0, 12.0, 22.0, 13.0, 23.0, 3.0, 2.0, 1.0, 1.0];
    let ours = numbers(&clean(text));
    assert_eq!(ours.len(), expected.len());
    assert!(ours.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{ours:?}");
}

#[test]
fn a_jump_out_of_a_do_ends_it() {
    let text = "DO/1,I=1,9\nIF(I.EQ.3)JUMPTO/2\n1) GOTO/I,0,0\n2) GOTO/(10*I),0,0\n\
        3) GOTO/4,0,0\nFINI\n";
    assert_eq!(numbers(&clean(text)), [1.0, 2.0, 30.0, 4.0]);
}

#[test]
fn labels_belong_to_their_loop_and_macro() {
    let text = "M=MACRO/A\nIF(A)1,1,2\n1) GOTO/1,0,0\n2) TERMAC\n\
        LOOPST\nI=0\n1) I=I+1\nIF(I-2)1,2,2\n2) LOOPND\n\
        LOOPST\nI=0\n1) I=I+1\nIF(I-3)1,2,2\n2) LOOPND\n\
        CALL/M,A=-1\nCALL/M,A=1\nGOTO/I,0,0\nFINI\n";
    assert_eq!(numbers(&clean(text)), [1.0, 3.0]);
}

#[test]
fn macro_parameters_are_numbers_words_and_names() {
    let text = "SLOT=MACRO/SIDE=TLLFT,D,P,OUT\nSIDE,GOLFT/L1,TO,L2\nGODLTA/0,0,(-D)\nGOTO/P\n\
        COOLNT/ON\nOUT=D*2\nTERMAC\n\
        L1=LINE/XAXIS\nL2=LINE/YAXIS\nPT=POINT/7,8\n\
        CALL/SLOT,D=3,P=PT,OUT=R\nCALL/SLOT,SIDE=TLRGT,D=(R+1),P=(POINT/1,2,3),OUT=R\n\
        GOTO/R,0,0\nFINI\n";
    let ran = clean(text);
    assert_eq!(numbers(&ran), [7.0, 1.0, 14.0]);
    let sides: Vec<_> = ran
        .kinds()
        .into_iter()
        .filter_map(|k| if let Kind::DriveSide(s) = k { Some(*s) } else { None })
        .collect();
    assert_eq!(sides, [DriveSide::Tllft, DriveSide::Tlrgt]);
}

#[test]
fn a_parameter_may_stand_for_an_array() {
    let text = "RESERV/P,3\nDO/1,I=1,3\n1) P(I)=POINT/I,0\n\
        M=MACRO/A,N\nI=1\n1) GOTO/A(I)\nI=I+1\nIF(I-N)1,1,2\n2) TERMAC\nCALL/M,A=P,N=3\nFINI\n";
    assert_eq!(numbers(&clean(text)), [1.0, 2.0, 3.0]);
}

#[test]
fn parameters_hide_names_in_their_own_macro_alone() {
    let text = "A=1\nIN=MACRO/B\nGOTO/(A+B),0,0\nTERMAC\n\
        OUT=MACRO/A\nCALL/IN,B=A\nGOTO/A,0,0\nA=A+1\nGOTO/A,0,0\nTERMAC\n\
        CALL/OUT,A=10\nGOTO/A,0,0\nFINI\n";
    assert_eq!(numbers(&clean(text)), [11.0, 10.0, 11.0, 1.0]);
}

#[test]
fn a_parameter_may_have_the_name_of_its_value() {
    let text = "A=5\nM=MACRO/A\nA=A+1\nTERMAC\nCALL/M,A=A\nGOTO/A,0,0\nFINI\n";
    assert_eq!(numbers(&clean(text)), [6.0]);
}

#[test]
fn local_names_are_those_of_one_call() {
    let text = "T=1\nM=MACRO/D\nLOCAL/T\nT=D*2\nIF(D.GT.1)CALL/M,D=(D-1)\nGOTO/T,0,0\nTERMAC\n\
        CALL/M,D=3\nGOTO/T,0,0\nFINI\n";
    let ran = clean(text);
    assert_eq!(numbers(&ran), [2.0, 4.0, 6.0, 1.0]);
    assert!(ran.geometry.iter().all(|(n, _)| n.name != "D"));
}

#[test]
fn macros_nest_deep_and_defaults_stay() {
    let mut text = String::from("M0=MACRO/A=1\nGOTO/A,0,0\nTERMAC\n");
    for i in 1..=20 {
        text += &format!("M{i}=MACRO/A=1\nCALL/M{},A=(A+1)\nTERMAC\n", i - 1);
    }
    text += "CALL/M20,A=100\nCALL/M0\nFINI\n";
    assert_eq!(numbers(&clean(&text)), [120.0, 1.0]);
}

#[test]
fn origins_tell_calls_and_passes() {
    let text =
        "M=MACRO/A\nGOTO/A,0,0\nTERMAC\nI=0\nLP) I=I+1\nCALL/M,A=I\nIF(I-2)LP,X,X\nX) FINI\n";
    let ran = clean(text);
    let traces: Vec<Vec<_>> = ran
        .records
        .iter()
        .filter(|r| matches!(r.kind, Kind::Goto(_)))
        .map(|r| {
            assert_eq!((r.origin.line, r.origin.isn), (2, 2));
            r.origin.frames().map(|f| (f.kind, f.name.to_string(), f.line, f.pass)).collect()
        })
        .collect();
    let call = (FrameKind::Macro, "M".to_owned(), 6, 0);
    let pass = (FrameKind::Loop, "LP".to_owned(), 5, 2);
    assert_eq!(traces, [vec![call.clone()], vec![call, pass]]);
}

#[test]
fn statement_numbers_count_all_cards_but_continuations() {
    let ran = clean("$$ NOTE\n\nA=1+ $\n  2\nGOTO/A,0,0\nFINI\n");
    let goto = ran.records.iter().find(|r| matches!(r.kind, Kind::Goto(_))).unwrap();
    assert_eq!((goto.origin.line, goto.origin.isn), (5, 4));
}

#[test]
fn synonyms_of_any_word_in_either_order() {
    for syn in ["SYN/PT,POINT,GT,GOTO,KL,CALL", "SYN/POINT,PT,GOTO,GT,CALL,KL"] {
        let text = format!("{syn}\nM=MACRO/A\nGT/A\nTERMAC\nP=PT/4,5\nKL/M,A=P\nFINI\n");
        assert_eq!(numbers(&clean(&text)), [4.0]);
    }
}

#[test]
fn files_are_read_where_they_are_asked_for() {
    let mut shelf = Shelf(BTreeMap::from([
        ("SEG", "B=A+1\nINCLUD/DEEP\n"),
        ("DEEP", "GOTO/B,0,0\n"),
        ("DRILL", "$$ a system macro\nDRILL=MACRO/N\nDO/1,I=1,N\n1) GOTO/I,9,0\nTERMAC\n"),
    ]));
    let text = "A=1\nREAD/2,SEG\nLIBRY/DRILL\nCALL/DRILL,N=2\nFINI\n";
    let ran = run_with(text, &mut shelf, Options::default(), |_| Outcome::None);
    assert!(ran.diagnostics.is_empty(), "{}", ran.messages());
    assert_eq!(numbers(&ran), [2.0, 1.0, 2.0]);
    let origins: Vec<_> = ran
        .records
        .iter()
        .filter(|r| matches!(r.kind, Kind::Goto(_)))
        .map(|r| (r.origin.file.as_deref().map(str::to_owned), r.origin.line))
        .collect();
    let at = |file: &str, line| (Some(file.to_owned()), line);
    assert_eq!(origins, [at("DEEP", 1), at("DRILL", 4), at("DRILL", 4)]);
}

#[test]
fn saved_definitions_are_read_by_their_names() {
    let mut shelf = Shelf(BTreeMap::from([
        ("TOR1", "TOR1=SSURF/CANON,1,2,3\n"),
        ("C1", "C1=CIRCLE/CANON,1,2,0,0,0,1,5\n"),
    ]));
    let text = "READ/1,C1,TOR1\nM=MATRIX/TRANSL,1,0,0\nT2=SSURF/COMBIN,TOR1,TRFORM,M\n\
        GOTO/(POINT/CENTER,C1)\nFINI\n";
    let ran = run_with(text, &mut shelf, Options::default(), |_| Outcome::None);
    assert!(ran.diagnostics.is_empty(), "{}", ran.messages());
    assert_eq!(numbers(&ran), [1.0]);
    assert_eq!(run("READ/1\nFINI\n").told(), [(1095, 1)]);
}

/// All that is to know of a file of surfaces comes with one message: of several at one place the first alone would be told.
#[test]
fn what_a_file_of_surfaces_holds_besides_is_told_whole() {
    let points: String = [[0, 0, 0], [0, 8, 0], [5, 0, 0], [5, 8, 1]]
        .iter()
        .zip(1..)
        .map(|([x, y, z], k)| format!("#{k}=CARTESIAN_POINT('',({x}.,{y}.,{z}.));\n"))
        .collect();
    let text = format!(
        "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('a','b',(''),(''),'c','d','');\n\
         FILE_SCHEMA(('CONFIG_CONTROL_DESIGN'));\nENDSEC;\nDATA;\n{points}\
         #5=BEZIER_SURFACE('',1,1,((#1,#2),(#3,#4)),.UNSPECIFIED.,.F.,.F.,.F.);\n#6=OFFSET_SURFACE('',#5,1.,.F.);\n\
         ENDSEC;\nEND-ISO-10303-21;\n"
    );
    let mut shelf = Shelf(BTreeMap::from([("LID", &*text)]));
    let ran = run_with("READ/1,LID\nFINI\n", &mut shelf, Options::default(), |_| Outcome::None);
    let [told] = &ran.diagnostics[..] else { panic!("{}", ran.messages()) };
    assert_eq!(told.code.number(), 1114);
    assert_eq!(
        told.message,
        "LID: it names no unit of length; that of the program is taken (1 of 2 notes)"
    );
    assert_eq!(told.notes, ["not read: 1 OFFSET_SURFACE"]);
}

#[test]
fn several_programs_in_a_file_know_nothing_of_each_other() {
    let text = "PARTNO ONE\nA=1\nM=MACRO/\nTERMAC\nGOTO/A,0,0\nFINI\nPARTNO TWO\nA=POINT/2,0\n\
        M=MACRO/\nTERMAC\nGOTO/A\nFINI\n\n$$ nothing more\n";
    let ran = clean(text);
    assert_eq!(numbers(&ran), [1.0, 2.0]);
    assert_eq!(ran.records.iter().filter(|r| r.kind == Kind::Fini).count(), 2);
}

/// L1 to L4 and a motion with two labels.
const BRANCH: &str = "L1=LINE/XAXIS\nL2=LINE/YAXIS\nL3=LINE/1,0,1,1\n\
    TLLFT,GOLFT/L1,TO,L2,ONE,ON,L3,2\nGOTO/0,0,0\nJUMPTO/E\n\
    ONE) GOTO/1,0,0\nJUMPTO/E\n2) GOTO/2,0,0\nE) FINI\n";

#[test]
fn the_check_surface_that_stopped_the_tool_decides() {
    let answer = |check| {
        move |r: &aptc_protap::Record| match r.kind {
            Kind::Drive(_) => Outcome::Moved { te: Vec3::zeros(), ta: Vec3::z(), check },
            _ => Outcome::None,
        }
    };
    for (check, expected) in [(0, 1.0), (1, 2.0), (7, 0.0)] {
        let ran = run_with(BRANCH, &mut aptc_translate::NoFiles, Options::default(), answer(check));
        assert_eq!(numbers(&ran), [expected], "{}", ran.messages());
    }
    // What failed or waits goes on behind the motion.
    assert_eq!(numbers(&clean(BRANCH)), [0.0]);
}

#[test]
fn a_label_may_have_the_name_of_a_number() {
    let text = format!("ONE=17\n{BRANCH}");
    let ran = run_with(&text, &mut aptc_translate::NoFiles, Options::default(), |r| match r.kind {
        Kind::Drive(_) => Outcome::Moved { te: Vec3::zeros(), ta: Vec3::z(), check: 0 },
        _ => Outcome::None,
    });
    assert_eq!(numbers(&ran), [1.0], "{}", ran.messages());
}

#[test]
fn digits_behind_a_single_check_surface_are_a_feed_rate() {
    let text = "L1=LINE/XAXIS\nL2=LINE/YAXIS\nGOLFT/L1,TO,L2,10\n10) GOTO/1,0,0\nFINI\n";
    let ran = clean(text);
    let Kind::Post { word, args } = ran.kinds()[0] else { panic!("{:?}", ran.kinds()) };
    assert_eq!((word.as_str(), args.as_slice()), ("FEDRAT", [Arg::Number(10.0)].as_slice()));
    let Kind::Drive(drive) = ran.kinds()[1] else { panic!("{:?}", ran.kinds()) };
    assert!(!drive.checks[0].branch);
}

#[test]
fn an_undecided_jump_brings_no_further_messages() {
    // C would be known had the jump led there; D is a mistake of its own.
    let ran = run("IF(X)2,2,1\n2) A=1\nJUMPTO/3\n1) C=2\n3) GOTO/C,0,0\nB=D\nFINI\n");
    assert_eq!(ran.told(), [(1050, 1), (1050, 6)]);
}

#[test]
fn a_macro_that_is_missing_brings_no_further_messages() {
    let ran = run("CALL/HOLES,N=3\nGOTO/P1\nA=B+1\nPRINT/3,B\nFINI\n");
    assert_eq!(ran.told(), [(1091, 1)]);
}

#[test]
fn a_mistake_in_a_loop_is_told_once() {
    let ran = run("DO/1,I=1,50\nA=SQRTF(-I)\n1) CONTIN\nFINI\n");
    assert_eq!(ran.told(), [(1053, 2)]);
    assert_eq!(ran.diagnostics[0].trace, None);
}

#[test]
fn a_mistake_in_a_macro_is_told_for_each_call() {
    let ran = run("M=MACRO/A\nB=SQRTF(A)\nTERMAC\nCALL/M,A=-1\nCALL/M,A=1\nCALL/M,A=-2\nFINI\n");
    assert_eq!(ran.told(), [(1053, 2), (1053, 2)]);
    let lines: Vec<_> =
        ran.diagnostics.iter().filter_map(|d| d.trace.as_ref().map(|t| t.line)).collect();
    assert_eq!(lines, [4, 6]);
}
