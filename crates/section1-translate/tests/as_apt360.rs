//! Canonical forms where the manual leaves the height, the scale or the sign open: as APT-360 answers this program.

mod support;

use support::clean;

const PROGRAM: &str = "
Z1=PLANE/.1,0,1,2
PL1=PLANE/1,2,3,4
PL2=PLANE/-1,1,2,3
P1=POINT/1,2,3
C1=CIRCLE/4,5,6,2
C2=CIRCLE/CENTER,1,2,7,RADIUS,3
E1=ELLIPS/CENTER,P1,3,2,30
H1=HYPERB/CENTER,P1,2,1,45
Q1=LCONIC/5PT,1,0,1,2,3,3,5,1,4,-1
Q2=LCONIC/5PT,0,0,4,1,5,3,3,5,1,4
Q3=LCONIC/4PT1SL,0,0,3,4,1,5,3,3,5
Q4=LCONIC/4PT1SL,0,0,.5,4,1,5,3,1,4
Q5=LCONIC/3PT2SL,0,0,2,4,1,-3,3,3
Q6=LCONIC/3PT2SL,0,0,.5,4,1,-.25,2,3
S1=LINE/INTOF,PL1,PL2
S2=LINE/P1,ATANGL,30,YAXIS
S3=LINE/P1,SLOPE,2,YAXIS
S4=LINE/P1,ATANGL,30,XAXIS
ZSURF/Z1
C3=CIRCLE/XLARGE,OUT,C1,OUT,C2,RADIUS,4
C4=CIRCLE/CENTER,P1,RADIUS,5
K1=POINT/CENTER,C1
K2=POINT/RTHETA,XYPLAN,2,30
K3=POINT/C1,ATANGL,60
K4=POINT/CENTER,(CIRCLE/CANON,1,2,3,0,0,1,4)
FINI
";

/// Printed by APT-360 with six decimals.
const ANSWERS: &[(&str, &[f64])] = &[
    ("C1", &[4.0, 5.0, 0.0, 0.0, 0.0, 1.0, 2.0]),
    ("C2", &[1.0, 2.0, 0.0, 0.0, 0.0, 1.0, 3.0]),
    ("E1", &[5.25, 7.75, 0.0, -8.410254, 0.0, 0.0, -2.165063, -0.919873, -13.334937, 0.0]),
    ("H1", &[-1.5, -1.5, 0.0, -1.5, 0.0, 0.0, 2.5, -3.5, 0.5, 0.0]),
    ("Q1", &[0.715542, 0.715542, 0.0, 3.488266, 0.0, 0.0, 0.044721, -2.101904, -0.760263, 0.0]),
    ("Q2", &[0.671875, 0.671875, 0.0, 0.0, 0.0, 0.0, -0.265625, -0.929688, -0.929688, 0.0]),
    ("Q3", &[-2.264085, -0.999173, 0.0, 0.0, 0.0, 0.0, 1.17456, 3.794733, -1.264911, 0.0]),
    ("Q4", &[-0.382143, 0.892857, 0.0, 0.0, 0.0, 0.0, 0.121429, 1.0625, -2.125, 0.0]),
    ("Q5", &[-0.853766, 0.057616, 0.0, 0.0, 0.0, 0.0, 0.091662, 1.838478, -0.919239, 0.0]),
    ("Q6", &[-0.155, 0.52, 0.0, 0.0, 0.0, 0.0, -0.005, 0.5, -1.0, 0.0]),
    ("S1", &[0.980581, 0.196116, 0.0, -0.196116]),
    ("S2", &[0.866025, 0.5, 0.0, 1.866025]),
    ("S3", &[0.447214, 0.894427, 0.0, 2.236068]),
    ("S4", &[-0.5, 0.866025, 0.0, 1.232051]),
    ("C3", &[7.805464, 0.361202, 1.219454, 0.0, 0.0, 1.0, 4.0]),
    ("C4", &[1.0, 2.0, 0.0, 0.0, 0.0, 1.0, 5.0]),
    ("K1", &[4.0, 5.0, 1.6]),
    ("K2", &[1.732051, 1.0, 0.0]),
    ("K3", &[5.0, 6.732051, 1.5]),
    ("K4", &[1.0, 2.0, 1.9]),
];

#[test]
fn heights_scales_and_signs_are_those_of_apt360() {
    let ran = clean(PROGRAM);
    for (name, expected) in ANSWERS {
        let ours = ran.form(name);
        let close = ours.iter().zip(*expected).all(|(a, b)| (a - b).abs() <= 2e-6);
        assert!(ours.len() == expected.len() && close, "{name}: {ours:?}, not {expected:?}");
    }
}

/// ZSURF is taken as its own system sees it, and its numbers hold in each system: both old systems answer so.
#[test]
fn zsurf_keeps_its_numbers_from_system_to_system() {
    let z = |text: &str| {
        let report = clean(&format!("ZS=PLANE/0,.2,1,5\nM=MATRIX/TRANSL,1,2,3\n{text}\nFINI"));
        [report.form("A")[2], report.form("B")[2]]
    };
    let near = |found: [f64; 2], wanted: [f64; 2]| {
        assert!((0..2).all(|i| (found[i] - wanted[i]).abs() < 1e-9), "{found:?} {wanted:?}");
    };
    let inside = "A=POINT/1,1";
    let outside = "REFSYS/NOMORE\nB=POINT/1,1";
    near(z(&format!("ZSURF/ZS\nREFSYS/M\n{inside}\n{outside}")), [7.8, 4.8]);
    near(z(&format!("REFSYS/M\nZSURF/ZS\n{inside}\n{outside}")), [4.4, 1.4]);
    near(z(&format!("REFSYS/M\nZSURF/(PLANE/0,.2,1,5)\n{inside}\n{outside}")), [7.8, 4.8]);
    near(z(&format!("REFSYS/M\nZSURF/2\n{inside}\n{outside}")), [5.0, 2.0]);
    // A plane that stands upright in the new system still gives the height that it gave.
    near(z(&format!("ZSURF/2\nREFSYS/(R=MATRIX/YZROT,90)\n{inside}\n{outside}")), [1.0, 2.0]);
}
