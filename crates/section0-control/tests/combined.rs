//! COMBIN of meshes side by side, in any order and however each is turned, guides the tool as the one surface that they are parts of.

#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;
use aptc_geometry::trig;

/// Meshes of three by three points over the cells of a rectangle of 60 by 40, cut in so many columns and rows, as one surface F: shuffled
/// and turned by the numbers of `order`, without the cell `missing`.
fn combined(
    z: fn(f64, f64) -> f64,
    [columns, rows]: [usize; 2],
    order: usize,
    missing: Option<usize>,
) -> String {
    let [wide, high] = [60.0 / columns as f64, 40.0 / rows as f64];
    let mut cells: Vec<usize> = (0..columns * rows).filter(|cell| Some(*cell) != missing).collect();
    let n = cells.len();
    cells.rotate_left(order % n);
    let mut text = String::new();
    for (k, cell) in cells.iter().enumerate() {
        // The first looks up.
        let turn = if k == 0 { [0, 3, 5, 6][order % 4] } else { (order * 5 + k * 3) % 8 };
        let [x, y] = [(cell % columns) as f64 * wide, (cell / columns) as f64 * high];
        let point = |i: usize, j: usize| {
            let (i, j) = if turn & 1 > 0 { (j, i) } else { (i, j) };
            let i = if turn & 2 > 0 { 2 - i } else { i };
            let j = if turn & 4 > 0 { 2 - j } else { j };
            let (x, y) = (x + 0.5 * wide * i as f64, y + 0.5 * high * j as f64);
            format!("$\n({x:.6},{y:.6},{:.6})", z(x, y))
        };
        let splines: Vec<String> = (0..3)
            .map(|j| {
                format!("SPLINE,{}", (0..3).map(|i| point(i, j)).collect::<Vec<_>>().join(","))
            })
            .collect();
        text += &format!("F{k}=SSURF/SMESH,XYZ,{}\n", splines.join(","));
    }
    let names: Vec<String> = (0..n).map(|k| format!("F{k}")).collect();
    text + &format!("F=SSURF/COMBIN,{}\n", names.join(","))
}

fn plane(x: f64, y: f64) -> f64 {
    2.0 + 0.1 * x - 0.05 * y
}

/// One mesh through the same points.
fn single(z: fn(f64, f64) -> f64, [columns, rows]: [usize; 2]) -> String {
    let splines = (0..=2 * rows).map(|j| {
        let points = (0..=2 * columns).map(|i| {
            let (x, y) = (30.0 * i as f64 / columns as f64, 20.0 * j as f64 / rows as f64);
            format!("$\n({x:.6},{y:.6},{:.6})", z(x, y))
        });
        format!("SPLINE,{}", points.collect::<Vec<_>>().join(","))
    });
    format!("F=SSURF/SMESH,XYZ,{}\n", splines.collect::<Vec<_>>().join(","))
}

/// A parabola all along y: on three places the tangents of a mesh are those of it.
fn cylinder(x: f64, _: f64) -> f64 {
    7.0 - 0.006 * (x - 30.0) * (x - 30.0)
}

fn dome(x: f64, y: f64) -> f64 {
    5.0 - 0.003 * ((x - 30.0) * (x - 30.0) + (y - 20.0) * (y - 20.0))
}

/// The least distance of the surface from a ball of radius 3 that stands there; `holds` tells what there is of the surface.
fn gap(z: fn(f64, f64) -> f64, te: [f64; 3], holds: &dyn Fn(f64, f64) -> bool) -> f64 {
    const SIDE: u32 = 80;
    let mut least = f64::INFINITY;
    for i in 0..=SIDE {
        for j in 0..=SIDE {
            let near = |at: f64, k: u32| at + 3.2 * (2.0 * f64::from(k) / f64::from(SIDE) - 1.0);
            let (x, y) = (near(te[0], i), near(te[1], j));
            if (0.0..=60.0).contains(&x) && (0.0..=40.0).contains(&y) && holds(x, y) {
                let up = z(x, y) - te[2] - 3.0;
                least = least.min(trig::hypot(trig::hypot(x - te[0], y - te[1]), up) - 3.0);
            }
        }
    }
    least
}

const CUTS: [[usize; 2]; 5] = [[2, 1], [1, 2], [3, 1], [2, 2], [3, 2]];

/// Regional milling over it: all is proved, and the ball touches the surface all over within the band.
#[test]
fn regional_milling_over_it_is_that_over_one_surface() {
    for (order, cut) in CUTS.into_iter().enumerate() {
        for z in [plane, cylinder, dome] {
            for hold in ["ON", "AT"] {
                let of = |surface: String| {
                    let text = format!(
                        "PARTNO WHOLE
UNITS/MM
{surface}D=SSURF/SMESH,XYZ,SPLINE,(6,6,20),(54,6,20),SPLINE,(6,34,20),(54,34,20)
CUTTER/6,3
INTOL/.05
OUTTOL/.05
FROM/0,0,60
SCON/DS,D,PARAM,0,1,0,1,{hold},(VECTOR/0,0,-1)
SCON/PS,TO,F,PLUS,0
CHKSRF/PS,ON
SCON/AXIS,(VECTOR/0,0,1)
SCON/FEED,900,800,300,2000
SCON/STEPOV,.2,8,0,0
SMIL/ZIGZAG,DS,PARAM,0,0,TANSPL,PLUS,STEPOV,PLUS
END
FINI
"
                    );
                    run::run(&text, Verify::Full)
                };
                let (ran, one) = (of(combined(z, cut, order, None)), of(single(z, cut)));
                // What is left between the passes may not be decided, whatever the surface is made of.
                let told =
                    |t: &(String, String)| t.0 == "APT5002" && t.1.contains("between the passes");
                assert!(ran.told.iter().all(told), "{cut:?} {order} {hold}: {:?}", ran.told);
                let (a, b) = (ran.places.len(), one.places.len());
                assert!(a.abs_diff(b) <= 2 + b / 4, "{cut:?} {hold} {a} {b}");
                for te in &ran.places[1..] {
                    let gap = gap(z, *te, &|_, _| true);
                    // The meshes leave the form by a little.
                    assert!((-0.07..0.07).contains(&gap), "{cut:?} {hold} {te:?} {gap}");
                }
            }
        }
    }
}

/// Ordinary motion over it, along its joints and across them, is proved.
#[test]
fn motion_over_it_is_proved() {
    for (order, cut) in CUTS.into_iter().enumerate() {
        for z in [plane, cylinder, dome] {
            for y in [9.0, 20.0] {
                let text = format!(
                    "PARTNO WHOLE
UNITS/MM
{}CUTTER/6,3
INTOL/.05
OUTTOL/.05
W=PLANE/0,1,0,{y}
FROM/5,{y},60
INDIRV/0,0,-1
GO/ON,(PLANE/1,0,0,5),TO,F,ON,W
INDIRV/1,0,0
TLON,GOFWD/W,ON,(PLANE/1,0,0,55)
END
FINI
",
                    combined(z, cut, order + 1, None)
                );
                let ran = run::run(&text, Verify::Full);
                assert_eq!(ran.faults(), Vec::<String>::new(), "{cut:?} {y}: {:?}", ran.told);
                for te in &ran.places[1..] {
                    let gap = gap(z, *te, &|_, _| true);
                    assert!((-0.07..0.07).contains(&gap), "{cut:?} {te:?} {gap}");
                }
            }
        }
    }
}

/// An L: over the corner that is missing the tool goes on smoothly, and nothing is said of what is not there.
#[test]
fn an_l_is_one_surface() {
    for missing in 0..4 {
        let text = format!(
            "PARTNO ELL
UNITS/MM
{}D=SSURF/SMESH,XYZ,SPLINE,(4,4,20),(56,4,20),SPLINE,(4,36,20),(56,36,20)
CUTTER/6,3
INTOL/.05
OUTTOL/.05
FROM/0,0,60
SCON/DS,D,PARAM,0,1,0,1,ON,(VECTOR/0,0,-1)
SCON/PS,TO,F,PLUS,0
CHKSRF/PS,ON
SCON/AXIS,(VECTOR/0,0,1)
SCON/FEED,900,800,300,2000
SCON/STEPOV,.2,8,0,0
SMIL/ZIGZAG,DS,PARAM,0,0,TANSPL,PLUS,STEPOV,PLUS
END
FINI
",
            combined(dome, [2, 2], missing, Some(missing))
        );
        let ran = run::run(&text, Verify::Full);
        assert!(ran.faults().iter().all(|f| f == "APT5002"), "{missing}: {:?}", ran.told);
        let holds = |x: f64, y: f64| usize::from(x > 30.0) + 2 * usize::from(y > 20.0) != missing;
        for te in &ran.places[1..] {
            let gap = gap(dome, *te, &holds);
            let over = holds(te[0], te[1]);
            assert!(gap > -0.07 && (!over || gap < 0.07), "{missing} {te:?} {gap}");
        }
    }
}
