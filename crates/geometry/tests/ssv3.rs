//! Surfaces, points and derivatives beside the traces of CAM-I's SSV3.

use aptc_geometry::Vec3;
use aptc_geometry::sculpt::{Patch, Sculptured, SplinePoint, Vec4, mesh};

/// The mesh of the programs tr1 to tr3.
fn traced_mesh() -> Sculptured {
    let z = [
        [0.095, 0.183, -0.214, -0.045],
        [0.044, 0.085, -0.099, -0.021],
        [-0.072, -0.137, 0.161, 0.034],
        [-0.083, -0.158, 0.185, 0.039],
    ];
    let rows: Vec<Vec<SplinePoint>> = z
        .iter()
        .enumerate()
        .map(|(j, row)| {
            row.iter()
                .enumerate()
                .map(|(i, z)| SplinePoint::plain(Vec3::new(1.5 * i as f64, 1.4 * j as f64, *z)))
                .collect()
        })
        .collect();
    mesh(&rows, aptc_geometry::sculptured::MeshSpacing::Xyz).expect("an even mesh")
}

/// Values of a line `NAME x x x`.
fn values(line: &str) -> (&str, Vec<f64>) {
    let mut words = line.split_ascii_whitespace();
    let name = words.next().unwrap_or("");
    (name, words.map_while(|w| w.parse().ok()).collect())
}

#[test]
fn patches_of_the_trace_are_ours() {
    let name = "patches_of_the_trace_are_ours";
    let Some(path) = aptc_testkit::shared(name, "oracle/ssv3/tr1.trace.txt") else { return };
    let text = std::fs::read_to_string(path).unwrap();
    let ours = traced_mesh();
    let mut compared = 0;
    let (mut call, mut number) = ("", 0_usize);
    for line in text.lines() {
        if let Some(name) = line.strip_prefix('#') {
            call = name.split(' ').next().unwrap();
        }
        let (name, v) = values(line);
        if call == "INEX" && name == "NPATCH" {
            number = line.split_ascii_whitespace().nth(1).unwrap().parse().unwrap();
        }
        if call != "INEX" || name != "BCOEF" {
            continue;
        }
        assert_eq!(v.len(), 64);
        let rows = core::array::from_fn(|j| {
            core::array::from_fn(|i| {
                let at = |c: usize| v[16 * c + 4 * j + i];
                Vec4::new(at(0), at(1), at(2), at(3))
            })
        });
        let theirs = Patch::homogeneous_hermite(rows);
        for k in 0..25 {
            let (u, v) = (f64::from(k % 5) / 4.0, f64::from(k / 5) / 4.0);
            let (a, b) = (theirs.at(u, v), ours.at_span(number, u, v).unwrap());
            for (x, y) in [
                (a.point, b.point),
                (a.u, b.u),
                (a.v, b.v),
                (a.uu, b.uu),
                (a.uv, b.uv),
                (a.vv, b.vv),
            ] {
                assert!((x - y).norm() < 5e-9, "patch {number} at {u} {v}: {x} {y}");
            }
        }
        compared += 1;
    }
    assert_eq!(compared, 9);
}

#[test]
fn derivatives_of_the_trace_are_ours() {
    let name = "derivatives_of_the_trace_are_ours";
    let Some(path) = aptc_testkit::shared(name, "oracle/ssv3/tr1.trace.txt") else { return };
    let text = std::fs::read_to_string(path).unwrap();
    let ours = traced_mesh();
    let (mut uv, mut call, mut compared) = ([f64::NAN; 2], "", 0);
    for line in text.lines() {
        if let Some(name) = line.strip_prefix('#') {
            call = name.split(' ').next().unwrap();
        }
        let (name, v) = values(line);
        match (call, name) {
            ("DGEOM", "U") => uv[0] = v[0],
            ("DGEOM", "V") => uv[1] = v[0],
            ("SRFDIR", "R") => {
                let at = |k: usize| Vec3::new(v[k], v[k + 1], v[k + 2]);
                let d = ours.at(uv[0], uv[1]);
                let pairs = [
                    (at(0), d.point),
                    (at(4), d.u),
                    (at(8), d.v),
                    (at(12), d.uu),
                    (at(16), d.uv),
                    (at(20), d.vv),
                    (at(28), d.normal().unwrap()),
                ];
                for (k, (theirs, ours)) in pairs.into_iter().enumerate() {
                    assert!((theirs - ours).norm() < 5e-9, "{uv:?} item {k}: {theirs} {ours}");
                }
                compared += 1;
            }
            _ => {}
        }
    }
    assert!(compared >= 10, "{compared}");
}
