//! Forms of statements and expressions.

use aptc_syntax::tree::{Body, ExprKind};
use aptc_syntax::{Options, tree};
use aptc_vocabulary::word;

use crate::show::{one, read, read_with};

#[test]
fn labels() {
    assert_eq!(one("12)"), "12) ");
    assert_eq!(one("5A) A=1"), "5A) A=1");
    assert_eq!(one(" ID 1 )GOTO/P"), "ID1) GOTO/P");
    assert_eq!(one("LAB:"), "LAB) ");
    assert_eq!(one("LAB: FINI"), "LAB) FINI");
    assert_eq!(one("CONT)GOFWD/VRTL,TANTO,SCIRC"), "CONT) GOFWD/VRTL,TANTO,SCIRC");
    assert_eq!(one("007)L1=LINE/XAXIS"), "007) L1={LINE/XAXIS}");
}

#[test]
fn clauses_are_joined_by_commas() {
    assert_eq!(one("RAPID,GOTO/P"), "RAPID GOTO/P");
    assert_eq!(one("tlofps, go/ to, sph"), "TLOFPS GO/TO,SPH");
    assert_eq!(one("TLLFT,TLONPS,GOLFT/L1,TO,L2,20"), "TLLFT TLONPS GOLFT/L1,TO,L2,20");
    assert_eq!(one("FINI"), "FINI");
    assert_eq!(one("COOLNT/"), "COOLNT/");
    assert_eq!(one("FROM /P,1.5"), "FROM/P,1.5");
    assert_eq!(one("OBTAIN, LINE/ lr, , , , lrd"), "OBTAIN LINE/LR,_,_,_,LRD");
    assert_eq!(one("OBTAIN/CIRCLE,C1,,Y"), "OBTAIN/CIRCLE,C1,_,Y");
    assert_eq!(one("OBTAIN,POINT/P,X,,"), "OBTAIN POINT/P,X,_,_");
    assert_eq!(one("PRINT/3,'A, B'"), "PRINT/3,'A, B'");
    assert_eq!(one("JUMPTO/12"), "JUMPTO/12");
    assert_eq!(one("GOLFT/L1,TO,L2,5A,PAST,L3,12"), "GOLFT/L1,TO,L2,5A,PAST,L3,12");
    assert_eq!(one("GOTO/D/2,3"), "GOTO/(Div D 2),3");
}

#[test]
fn words_are_known_and_symbols_are_not() {
    let (_, parsed, interner) = read_with("TLLFT,GOLFT/L1,TO,L2", &Options::default());
    let Body::Clauses(clauses) = &parsed.program.statements[0].body else { panic!("clauses") };
    assert_eq!(clauses[0].head.word, Some(word::TLLFT));
    assert_eq!(clauses[1].head.word, Some(word::GOLFT));
    let args = clauses[1].args.as_ref().unwrap();
    let names: Vec<tree::Name> = args
        .iter()
        .map(|e| match e.kind {
            ExprKind::Name(name) => name,
            _ => panic!("names"),
        })
        .collect();
    assert_eq!(names.iter().map(|n| n.word).collect::<Vec<_>>(), [None, Some(word::TO), None]);
    assert_eq!(interner.text(names[0].symbol), "L1");
}

#[test]
fn assignments() {
    assert_eq!(one("A=3*B"), "A=(Mul 3 B)");
    assert_eq!(one("P(2)=POINT/1,2"), "P(2)={POINT/1,2}");
    assert_eq!(one("P(I=I+1)=P1"), "P([I=(Add I 1)])=P1");
    assert_eq!(one("PT(2)=POINT/1,2"), "PT(2)={POINT/1,2}");
    assert_eq!(one("IF(2)=3"), "IF(2)=3");
    assert_eq!(one("N = 1"), "N=1");
    assert_eq!(one("PL=(PLANE/0,0,1,D)CANON"), "PL={PLANE/0,0,1,D} CANON");
    assert_eq!(
        one("P3=POINT/(POINT/INTOF,LYN,XAX),CANON"),
        "P3={POINT/{POINT/INTOF,LYN,XAX},CANON}"
    );
    assert_eq!(one("pl1=plane/(plane/0,0,1,d3)canon"), "PL1={PLANE/{PLANE/0,0,1,D3} CANON}");
}

#[test]
fn a_slash_divides_or_begins_a_list() {
    assert_eq!(one("A=B/2"), "A=(Div B 2)");
    assert_eq!(one("A=B/2/C"), "A=(Div (Div B 2) C)");
    assert_eq!(one("L=LINE/XAXIS"), "L={LINE/XAXIS}");
    // A comma leaves no other meaning, whatever the word.
    assert_eq!(one("P=POIMT/1,2"), "P={POIMT/1,2}");
    // In brackets it does: an unnamed point.
    assert_eq!(one("GOTO/(D/2,H/2,0)"), "GOTO/<(Div D 2),(Div H 2),0>");
    assert_eq!(one("A=ATAN2F(Y/2,X)"), "A=ATAN2F((Div Y 2),X)");
    assert_eq!(one("CALL/M,A=B/2,C=1"), "call M A:(Div B 2) C:1");
    assert_eq!(
        one("L=LINE/(POINT/D2,D5),ATANGL,(360-D6),L2"),
        "L={LINE/{POINT/D2,D5},ATANGL,(Sub 360 D6),L2}"
    );
}

#[test]
fn synonyms_of_defining_words_define() {
    assert_eq!(read("SYN/ND,POINT\nP=ND/Q\nA=LN/2"), ["SYN/ND,POINT", "P={ND/Q}", "A=(Div LN 2)"]);
    assert_eq!(read("SYN/POINT,ND\nL=LINE/(ND/Q),P")[1], "L={LINE/{ND/Q},P}");
}

#[test]
fn nested_definitions() {
    assert_eq!(one("L=LINE/(P=POINT/1,2),P2"), "L={LINE/{P=POINT/1,2},P2}");
    assert_eq!(one("L=LINE/(P(3)=POINT/1,2),P2"), "L={LINE/{P(3)=POINT/1,2},P2}");
    assert_eq!(one("C=CYLNDR/(POINT/0,0,0),V1,(D1/2)"), "C={CYLNDR/{POINT/0,0,0},V1,(Div D1 2)}");
    assert_eq!(one("L=LINE/(1,2),(3,4,5)"), "L={LINE/<1,2>,<3,4,5>}");
}

#[test]
fn operators_bind_as_in_apt_360() {
    assert_eq!(one("A=-B**2"), "A=(Pow (Neg B) 2)");
    assert_eq!(one("A=2**3**2"), "A=(Pow 2 (Pow 3 2))");
    assert_eq!(one("A=2**-3"), "A=(Pow 2 (Neg 3))");
    assert_eq!(one("A=1-2-3"), "A=(Sub (Sub 1 2) 3)");
    assert_eq!(one("A=1+2*3**4-5"), "A=(Sub (Add 1 (Mul 2 (Pow 3 4))) 5)");
    assert_eq!(one("A=8/4*2"), "A=(Mul (Div 8 4) 2)");
    assert_eq!(one("A=-(-B)"), "A=(Neg (Neg B))");
    assert_eq!(one("A=- -B"), "A=(Neg (Neg B))");
    assert_eq!(one("A=SINF(30)**2"), "A=(Pow SINF(30) 2)");
    assert_eq!(one("B=.NOT.A.EQ.C"), "B=(Not (Eq A C))");
    assert_eq!(one("B=A.OR..NOT.C.AND.D"), "B=(Or A (And (Not C) D))");
    assert_eq!(one("B=A+1.LT.C*2.AND.D"), "B=(And (Lt (Add A 1) (Mul C 2)) D)");
}

#[test]
fn subscripts() {
    assert_eq!(one("PRINT/2,P(1,THRU,ALL)"), "PRINT/2,P(1,THRU,ALL)");
    assert_eq!(one("T=TABCYL/NOZ,SPLINE,P(ALL)"), "T={TABCYL/NOZ,SPLINE,P(ALL)}");
    assert_eq!(one("GOTO/P(I=I+1)"), "GOTO/P([I=(Add I 1)])");
    assert_eq!(one("A=B(C(D(1)))"), "A=B(C(D(1)))");
    assert_eq!(one("RESERV/TP,28,ZDCL,1"), "RESERV/TP,28,ZDCL,1");
}

#[test]
fn jumps_and_loops() {
    assert_eq!(one("IF(MV1-79.764)6,6,4"), "if (Sub MV1 79.764) 6 6 4");
    assert_eq!(one("4) IF(MV1-86.79)5A,5A,6"), "4) if (Sub MV1 86.79) 5A 5A 6");
    assert_eq!(one("if (n) finpas, rghpas, rghpas"), "if N FINPAS RGHPAS RGHPAS");
    assert_eq!(one("IF (V1.LT.1.2)JUMPTO/ID1"), "if (Lt V1 1.2) then JUMPTO/ID1");
    assert_eq!(one("IF(A.EQ.B)RAPID,GOTO/P"), "if (Eq A B) then RAPID GOTO/P");
    assert_eq!(one("IF(A.EQ.B)C=3"), "if (Eq A B) then C=3");
    assert_eq!(one("IF(A)RAPID"), "if A then RAPID");
    assert_eq!(one("IF(A)CALL/M,X=1"), "if A then call M X:1");
    assert_eq!(one("IF(A)P(3)=POINT/1,2"), "if A then P(3)={POINT/1,2}");
    assert_eq!(one("DO/12,I=1,10"), "do 12 I=1..10");
    assert_eq!(one("DO/L,I=N-1,A(2),-2"), "do L I=(Sub N 1)..A(2) by (Neg 2)");
}

#[test]
fn macros() {
    assert_eq!(one("GOGO=MACRO/"), "GOGO=macro ");
    assert_eq!(one("GOGO=MACRO"), "GOGO=macro ");
    assert_eq!(one("M=MACRO/A,B=2,C=TLLFT,D=-1"), "M=macro A B:2 C:TLLFT D:(Neg 1)");
    assert_eq!(one("CALL/GOGO"), "call GOGO ");
    assert_eq!(
        one("CALL/ M , A=1, B=TLLFT,C=(POINT/1,2), D='X'"),
        "call M A:1 B:TLLFT C:{POINT/1,2} D:'X'"
    );
    assert_eq!(one("CALL/PROG,SEC1,3,P1"), "call PROG SEC1 :3 P1");
}

#[test]
fn a_statement_in_error_tells_what_it_would_have_defined() {
    let (shown, parsed, _) =
        read_with("P1=POINT/1,*\nP(2)=POINT/(\n3) GOTO/*\nA=1", &Options::default());
    assert_eq!(shown, ["error P1", "error P", "3) error ", "A=1"]);
    assert_eq!(parsed.diagnostics.len(), 3);
}

#[test]
fn the_interner_is_shared_by_files() {
    use aptc_diagnostics::FileId;
    use aptc_syntax::{Interner, parse};
    let mut interner = Interner::default();
    parse(FileId(0), "A=1", &mut interner, &Options::default());
    let first = interner.find("A").unwrap();
    parse(FileId(1), "B=A", &mut interner, &Options::default());
    assert_eq!(interner.find("A"), Some(first));
    assert_eq!(interner.text(first), "A");
}
