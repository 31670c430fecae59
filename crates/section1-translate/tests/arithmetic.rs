//! Numbers, functions, logical values, arrays.

mod support;

use support::{clean, numbers, run};

/// The values of expressions, each by a GOTO.
fn values(expressions: &[&str], before: &str) -> Vec<f64> {
    let lines: String = expressions.iter().map(|e| format!("GOTO/({e}),0,0\n")).collect();
    numbers(&clean(&format!("{before}\n{lines}FINI\n")))
}

fn close(ours: &[f64], expected: &[f64]) {
    assert_eq!(ours.len(), expected.len());
    for (i, (a, b)) in ours.iter().zip(expected).enumerate() {
        assert!((a - b).abs() <= 1e-14 * b.abs().max(1.0), "{i}: {a} is not {b}");
    }
}

#[test]
fn operators_bind_as_in_apt_360() {
    let expressions =
        ["2+3*4", "-2**2", "2**3**2", "12/4/3", "2-3-4", "-(2+3)*2", "+5", "2*(-3)", "7/2"];
    close(&values(&expressions, ""), &[14.0, 4.0, 512.0, 1.0, -5.0, -10.0, 5.0, -6.0, 3.5]);
}

#[test]
fn functions_of_degrees_are_exact_at_the_axes() {
    let expressions =
        ["SINF(30)", "COSF(60)", "SINF(180)", "COSF(90)", "TANF(45)", "COTANF(45)", "SINF(-90)"];
    close(&values(&expressions, ""), &[0.5, 0.5, 0.0, 0.0, 1.0, 1.0, -1.0]);
}

#[test]
fn inverse_functions_give_degrees_and_with_b_radians() {
    let expressions = [
        "ATANF(1)",
        "ATAN2F(1,-1)",
        "ARSINF(.5)",
        "ARCOSF(.5)",
        "ATANB(1)",
        "ATAN2B(1,0)",
        "ARSINB(1)",
        "ARCOSB(0)",
        "SINB(0)",
        "COSB(0)",
        "TANB(0)",
        "COTANB(ATANB(2))",
    ];
    let pi = std::f64::consts::PI;
    close(
        &values(&expressions, ""),
        &[45.0, 135.0, 30.0, 60.0, pi / 4.0, pi / 2.0, pi / 2.0, pi / 2.0, 0.0, 1.0, 0.0, 0.5],
    );
}

#[test]
fn other_functions() {
    let expressions = [
        "ABSF(-3)",
        "SQRTF(2.25)",
        "EXPF(0)",
        "LOGF(EXPF(2))",
        "LOG10F(1000)",
        "INTF(-2.7)",
        "MODF(7,3)",
        "MODF(-7,3)",
        "SIGNF(3,-1)",
        "SIGNF(-3,0)",
        "MINF(3,1,2)",
        "MAXF(3,1,2)",
        "SINHF(0)",
        "COSHF(0)",
        "TANHF(0)",
    ];
    close(
        &values(&expressions, ""),
        &[3.0, 1.5, 1.0, 2.0, 3.0, -2.0, 1.0, -1.0, -3.0, 3.0, 1.0, 3.0, 0.0, 1.0, 0.0],
    );
}

#[test]
fn functions_of_forms() {
    let before = "V1=VECTOR/3,4,0\nV2=VECTOR/0,0,2\nC=CIRCLE/1,1,5\nP=POINT/1,-4\n\
                  L1=LINE/XAXIS\nL2=LINE/PARLEL,L1,YLARGE,7\nQ=PATERN/LINEAR,P,(POINT/9,9),5";
    let expressions = [
        "LNTHF(V1)",
        "DOTF(V1,V1)",
        "V1 DOT V2",
        "SPATF(V1,(VECTOR/0,1,0),V2)",
        "ANGLF(C,P)",
        "ANGLB(C,P)",
        "DISTF(L1,L2)",
        "DISTF(P,L2)",
        "DISTF(L2,(POINT/0,0))",
        "NUMF(Q)",
        "CANF(C,7)",
        "LNTHF(V1 KREUZ V2)",
    ];
    let expected =
        [5.0, 25.0, 0.0, 6.0, 270.0, 1.5 * std::f64::consts::PI, 7.0, 11.0, 7.0, 5.0, 5.0, 10.0];
    close(&values(&expressions, before), &expected);
}

#[test]
fn a_vector_product_is_a_form() {
    let ran = clean("V=(VECTOR/1,0,0) KREUZ (VECTOR/0,1,0)\nFINI\n");
    assert_eq!(ran.form("V"), [0.0, 0.0, 1.0]);
}

#[test]
fn logical_values() {
    let text = "A=3\n\
        T=A.GT.2.AND..NOT.(A.EQ.4)\n\
        IF(T)GOTO/1,0,0\n\
        IF(T.AND..FALSE.)GOTO/2,0,0\n\
        IF(A.LT.3.OR.A.GE.3)GOTO/3,0,0\n\
        IF(A.NE.3)GOTO/4,0,0\n\
        IF(A.LE.3)GOTO/5,0,0\nFINI\n";
    close(&numbers(&clean(text)), &[1.0, 3.0, 5.0]);
}

#[test]
fn an_assignment_stands_in_an_expression() {
    let text = "RESERV/P,3\nI=0\nP(I=I+1)=POINT/1,0\nP(I=I+1)=POINT/2,0\n\
        GOTO/P(I),0\nA=(B=4)*2\nGOTO/A,0,0\nGOTO/B,0,0\nFINI\n";
    // GOTO/point,0 has a feed rate of 0.
    close(&numbers(&clean(text)), &[2.0, 8.0, 4.0]);
}

#[test]
fn subscripts_are_truncated_and_several_at_once() {
    let text = "RESERV/A,5,6,B\nI=0\nDO/1,I=1,5\n1) A(I)=I*I\nB(2.9)=7\nGOTO/B(2),0,0\n\
        GOTO/A(1,THRU,3)\nGOTO/A(3,THRU,ALL)\nGOTO/A(THRU,3)\nGOTO/A(1,THRU,5,INCR,2)\n\
        GOTO/A(1,THRU,5,DECR,2)\nFINI\n";
    let ran = clean(text);
    let points: Vec<_> = ran
        .kinds()
        .into_iter()
        .filter_map(|k| match k {
            aptc_protap::Kind::Goto(p) => Some([p.point.x, p.point.y, p.point.z]),
            _ => None,
        })
        .collect();
    assert_eq!(
        points,
        [
            [7.0, 0.0, 0.0],
            [1.0, 4.0, 9.0],
            [9.0, 16.0, 25.0],
            [1.0, 4.0, 9.0],
            [1.0, 9.0, 25.0],
            [25.0, 9.0, 1.0]
        ]
    );
}

#[test]
fn a_list_the_wrong_way_round_is_its_first_element() {
    let text = "RESERV/P,5\nDO/1,I=1,5\n1) P(I)=POINT/I,0\nQ=PATERN/RANDOM,P(5,THRU,3)\n\
        R=PATERN/RANDOM,P(5,THRU,3,DECR,1)\nGOTO/(NUMF(Q)),0,0\nGOTO/(NUMF(R)),0,0\nFINI\n";
    let ran = clean(text);
    close(&numbers(&ran), &[1.0, 1.0]);
    assert_eq!(ran.form("Q"), [5.0, 0.0, 0.0]);
    assert_eq!(ran.form("R"), [3.0, 0.0, 0.0]);
}

#[test]
fn words_may_be_symbols() {
    // AT, DEPTH and RIGHT are vocabulary words.
    let text = "AT=3\nDEPTH=AT+1\nRIGHT=POINT/AT,DEPTH\nGOTO/RIGHT\nGOTO/DEPTH,0,0\nFINI\n";
    close(&numbers(&clean(text)), &[3.0, 4.0]);
}

#[test]
fn mistakes_are_told_once_and_poison_their_users() {
    let ran = run("A=SQRTF(-1)\nB=A+1\nP=POINT/A,B\nGOTO/P\nGOTO/X,0,0\nGOTO/X,1,0\nC=X\nFINI\n");
    assert_eq!(ran.told(), [(1053, 1), (1050, 5)]);
}

#[test]
fn zero_has_no_sign() {
    let numbers = values(&["0*(-1)", "-A", "0/(-5)"], "A=0");
    assert!(numbers.iter().all(|n| n.is_sign_positive()), "{numbers:?}");
}
