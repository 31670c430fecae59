//! Charts hold what they say, and cover the surface.

use std::sync::Arc;

use super::*;
use aptc_geometry::sculptured::{BsplineSurface, SurfaceDefinition, SurfaceShape};
use aptc_geometry::{Quadric as Ten, QuadricKind, trig};
use proptest::prelude::*;

/// An eighth of an ellipsoid that ends in a pole: at the low or high end of v, or of u.
fn eighth(low: bool, exchanged: bool) -> Form {
    let w = 0.5_f64.sqrt();
    let mut arc = [(1.0, 0.0, 1.0), (1.0, 1.0, w), (0.0, 1.0, 1.0)];
    if low {
        arc.reverse();
    }
    let round = [(1.0, 0.0, 1.0), (1.0, 1.0, w), (0.0, 1.0, 1.0)];
    let point = |k: usize| {
        let (i, j) = if exchanged { (k / 3, k % 3) } else { (k % 3, k / 3) };
        let ((a, z, wa), (x, y, wc)) = (arc[j], round[i]);
        [30.0 * a * x, 20.0 * a * y, 20.0 * z, wa * wc]
    };
    let knots = || vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0];
    let shape = SurfaceShape::Bspline(Box::new(BsplineSurface {
        degree: [2; 2],
        knots: [knots(), knots()],
        counts: [3; 2],
        points: (0..9).map(point).collect(),
        range: [None; 2],
    }));
    Form::Ssurf(Arc::new(SurfaceDefinition { shape, map: None }))
}

/// What a piece is told to turn by, and how far its normal turns at a place of it.
fn turned(form: &Form, chart: usize, share: [[f64; 2]; 2], place: [f64; 2]) -> (f64, f64) {
    let sheet = Sheet::new(form).expect("it has charts");
    let Kind::Patched(patched) = &sheet.kind else { unreachable!() };
    let all: Vec<Patch> = patched.charts().collect();
    let mut patch = all[chart % all.len()];
    for (k, [from, to]) in share.into_iter().enumerate() {
        patch.at[k] += (from + to - 1.0) * patch.half[k];
        patch.half[k] *= to - from;
    }
    let middle = sheet.jet(&Spot { chart: patch.chart, at: patch.at });
    let at = [0, 1].map(|k| patch.at[k] + place[k] * patch.half[k]);
    let there = sheet.jet(&Spot { chart: patch.chart, at });
    let [by_u, by_v] = sheet.made(&patch).turn;
    (by_u + by_v, (there.n - middle.n).norm())
}

/// Pieces that touch a pole are told to turn by the less the smaller they are.
#[test]
fn pieces_at_a_pole_are_told_to_turn_little() {
    for (low, exchanged) in [(true, false), (false, false), (true, true), (false, true)] {
        let mut found = 0;
        let end = |size: f64| if low { [0.0, size] } else { [1.0 - size, 1.0] };
        for chart in 0..64 {
            let of = |size: f64| {
                let (around, across) = ([0.5, 0.5 + size], end(size));
                let share = if exchanged { [across, around] } else { [around, across] };
                turned(&eighth(low, exchanged), chart, share, [0.0; 2]).0
            };
            found += usize::from(of(0.1) < 0.4 && of(0.01) < 0.04);
        }
        // Four cells lie about the pole, and others beside them.
        assert!(found >= 4, "{low} {exchanged}: {found}");
    }
}

proptest! {
    #[test]
    fn the_normal_turns_by_no_more_than_is_told(
        low: bool, exchanged: bool, chart in 0_usize..64, from in prop::array::uniform2(0.0..0.99_f64),
        size in prop::array::uniform2(0.001..1.0_f64), place in prop::array::uniform2(-0.999..0.999_f64),
        ends in prop::array::uniform2(0_u8..3),
    ) {
        let share = [0, 1].map(|k| match ends[k] {
            0 => [0.0, size[k]],
            1 => [1.0 - size[k], 1.0],
            _ => [from[k], from[k] + (1.0 - from[k]) * size[k]],
        });
        let (told, is) = turned(&eighth(low, exchanged), chart, share, place);
        prop_assert!(is <= told * (1.0 + 1e-6) + 1e-7, "{is} {told}");
    }
}

/// A quadric of each kind, turned and moved.
pub(crate) fn quadrics() -> Vec<Form> {
    let diagonal: [[f64; 10]; 14] = [
        [0.04, 0.1, 0.2, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.2, 0.1, -0.05, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [-0.2, -0.1, 0.05, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.2, 0.1, -0.15, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.2, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
        [0.2, -0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
        [0.1, 0.3, 0.0, -2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.1, -0.3, 0.0, -2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.3, -1.0],
        // Hardly bent along an axis or two.
        [0.1, 0.3, 1e-6, -2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1e-6],
        [0.1, -0.3, -1e-6, -2.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1e-6],
        [-0.1, 0.3, 1e-12, -2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1e-12],
        [0.2, 0.1, -1e-6, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
        [0.1, 1e-9, -1e-12, 0.0, 0.0, 0.0, 0.0, 0.0, 0.3, -1.0],
    ];
    let map = aptc_geometry::Transform::rotation(Vec3::new(1.0, 2.0, 2.0) / 3.0, 40.0)
        .then(&aptc_geometry::Transform::translation(Vec3::new(0.3, -0.2, 0.5)));
    diagonal
        .into_iter()
        .map(|c| {
            let form = Form::Quadric(Ten { kind: QuadricKind::Qadric, c });
            form.transformed(&map).expect("a rigid motion")
        })
        .collect()
}

proptest! {
    /// Pieces of all surfaces by two parameters, their continuations too, found by going down the tree.
    #[test]
    fn a_piece_by_two_parameters_is_held(
        which in 0_usize..9, walk in prop::collection::vec(any::<bool>(), 12),
        at in prop::array::uniform2(-1.0..1.0_f64), half in prop::array::uniform2(0.001..1.0_f64),
        in_piece in prop::array::uniform2(-1.0..1.0_f64), lean in prop::array::uniform3(-1.0..1.0_f64),
    ) {
        let form = &forms::parametric()[which];
        let sheet = Sheet::new(form).expect("it has charts");
        let Kind::Patched(patched) = &sheet.kind else { unreachable!() };
        let mut patch = patched.root();
        let mut spheres = Vec::new();
        for side in walk {
            let Some(node) = sheet.group(&patch) else { break };
            let [first, second] = sheet.below(&patch, Vec3::zeros());
            spheres.push(*node);
            patch = if side { first.or(second) } else { second }.unwrap();
        }
        prop_assert!(!patch.group);
        patch.kept = Kept::Nowhere;
        for i in 0..2 {
            patch.at[i] += at[i] * patch.half[i] * (1.0 - half[i]);
            patch.half[i] *= half[i];
        }
        let tile = sheet.tile(&patch);
        let spot = Spot {
            chart: patch.chart,
            at: [0, 1].map(|i| patch.at[i] + in_piece[i] * patch.half[i]),
        };
        let jet = sheet.jet(&spot);
        for s in spheres {
            prop_assert!((jet.p - s.center).norm() <= s.radius * (1.0 + 1e-9), "outside of its group");
            for m in directions(jet.n, Vec3::from(lean)) {
                let off = m.dot(&(s.center - jet.p));
                prop_assert!(off <= s.extent(m) * (1.0 + 1e-9) + 1e-12, "outside of its box");
            }
        }
        let flat = tile.c + tile.side[0] * in_piece[0] + tile.side[1] * in_piece[1];
        let stray = (jet.p - flat).norm();
        prop_assert!(stray <= (tile.stray[0] + tile.stray[1]) * (1.0 + 1e-6) + 1e-9, "{stray} {tile:?}");
        for m in directions(tile.n, Vec3::from(lean)) {
            let dip = m.dot(&(tile.c - jet.p));
            prop_assert!(dip <= tile.dip(m) * (1.0 + 1e-9) + 1e-9, "{dip} {m:?} {tile:?}");
        }
        let turn = (jet.n - tile.n).norm();
        prop_assert!(turn <= (tile.turn[0] + tile.turn[1]) * (1.0 + 1e-6) + 1e-8, "{turn} {tile:?}");
        if jet.p.norm() > if which == 8 { 3.0 } else { 8.0 } {
            // Far out the straight continuations cross each other, and `foot`, which begins at a few samples,
            // ends on another place than the nearest.
            return Ok(());
        }
        let surface = aptc_geometry::Surface::from_form(form).unwrap();
        let foot = surface.foot(jet.p);
        // Section 2 takes the direction of a steep rail from beside its end.
        let near = if which == 1 { 1e-5 } else { 1e-8 };
        prop_assert!(foot.distance.abs() < near * (1.0 + jet.p.norm()), "off the surface by {}", foot.distance);
    }
}

/// Unit directions near a normal and any other.
fn directions(n: Vec3, lean: Vec3) -> impl Iterator<Item = Vec3> {
    [n, -n, lean, n + lean * 0.1].into_iter().filter_map(|m| m.try_normalize(1e-3))
}

fn world(sheet: &Sheet, y: Vec3) -> Vec3 {
    sheet.origin + sheet.axes[0] * y.x + sheet.axes[1] * y.y + sheet.axes[2] * y.z
}

proptest! {
    #[test]
    fn a_tile_holds_its_piece(
        which in 0_usize..14, root in 0_usize..6, at in prop::array::uniform2(-1.0..1.0_f64),
        half in prop::array::uniform2(0.001..0.5_f64), in_piece in prop::array::uniform2(-1.0..1.0_f64),
        lean in prop::array::uniform3(-1.0..1.0_f64),
    ) {
        let form = &quadrics()[which];
        let Form::Quadric(ten) = form else { unreachable!() };
        let sheet = Sheet::new(form).unwrap();
        let mut roots = Patches::new();
        prop_assert!(sheet.roots(Vec3::new(0.2, 0.4, -0.3), 4.0, &mut roots));
        let mut patch = roots.pop().unwrap();
        for _ in 0..root {
            patch = roots.pop().unwrap_or(patch);
        }
        for i in 0..2 {
            patch.at[i] += at[i] * patch.half[i];
            patch.half[i] *= half[i];
        }
        let tile = sheet.tile(&patch);
        let move_by = [0, 1].map(|i| in_piece[i] * patch.half[i]);
        let spot = Spot { chart: patch.chart, at: [0, 1].map(|i| patch.at[i] + move_by[i]) };
        let jet = sheet.jet(&spot);
        let p = world(&sheet, jet.p);
        prop_assert!(ten.value(p).abs() < 1e-10 * (1.0 + p.norm_squared()), "off the surface");
        let flat = tile.c + tile.side[0] * in_piece[0] + tile.side[1] * in_piece[1];
        let stray = (jet.p - flat).norm();
        prop_assert!(stray <= (tile.stray[0] + tile.stray[1]) * (1.0 + 1e-9) + 1e-12, "{} {:?}", stray, tile);
        for m in directions(tile.n, Vec3::from(lean)) {
            let dip = m.dot(&(tile.c - jet.p));
            prop_assert!(dip <= tile.dip(m) * (1.0 + 1e-9) + 1e-9, "{dip} {m:?} {tile:?}");
        }
        let turn = (jet.n - tile.n).norm();
        prop_assert!(turn <= (tile.turn[0] + tile.turn[1]) * (1.0 + 1e-9) + 1e-12, "{} {:?}", turn, tile);
        let g = ten.gradient(p);
        let n = sheet.axes[0] * jet.n.x + sheet.axes[1] * jet.n.y + sheet.axes[2] * jet.n.z;
        prop_assert!(g.norm() < 1e-6 || (g.normalize() - n).norm() < 1e-8, "{:?} {:?}", g, n);
        // Half way between two places the line is off by no more than the sag.
        let start = patch.spot();
        let middle = Spot { at: [0, 1].map(|i| patch.at[i] + 0.5 * move_by[i]), ..start };
        let sag = (sheet.jet(&middle).p - 0.5 * (jet.p + tile.c)).norm();
        prop_assert!(sag <= sheet.sag(&start, &spot) * (1.0 + 1e-9) + 1e-12);
    }

    #[test]
    fn the_roots_cover_the_surface(
        which in 0_usize..14, from in prop::array::uniform3(-2.0..2.0_f64),
        to in prop::array::uniform3(-1.0..1.0_f64),
    ) {
        let form = &quadrics()[which];
        let Form::Quadric(ten) = form else { unreachable!() };
        let sheet = Sheet::new(form).unwrap();
        // Where a ray meets the surface, some piece is near, however finely it is cut.
        let (p, d) = (Vec3::from(from), Vec3::from(to));
        prop_assume!(d.norm() > 0.1);
        let f = |t: f64| ten.value(p + d * t);
        let (mut a, mut b) = (0.0, 4.0);
        prop_assume!(f(a) * f(b) < 0.0);
        for _ in 0..60 {
            let m = 0.5 * (a + b);
            if f(a) * f(m) <= 0.0 { b = m } else { a = m }
        }
        let q = sheet.local(&Pose { te: p + d * a, ta: Vec3::z() }).te;
        let mut pile = Patches::new();
        prop_assert!(sheet.roots(q, 0.5, &mut pile));
        let mut found = false;
        while let Some(patch) = pile.pop() {
            let tile = sheet.tile(&patch);
            if (tile.c - q).norm() > tile.radius() {
                continue;
            }
            if tile.radius() < 1e-3 {
                found = true;
                break;
            }
            let i = usize::from(tile.side[1].norm() > tile.side[0].norm());
            for half in patch.halves(i) {
                prop_assert!(pile.push(half));
            }
        }
        prop_assert!(found);
    }
}

#[test]
fn derivatives_of_the_blown_up_cube_are_bounded() {
    let unit = Form::Quadric(Ten {
        kind: QuadricKind::Ellips,
        c: [1.0, 1.0, 1.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    });
    let sheet = Sheet::new(&unit).unwrap();
    let h = 1e-4;
    let d = |u: f64, v: f64| sheet.jet(&Spot { chart: 0, at: [u, v] }).d[0];
    let mut top = [0.0_f64; 2];
    for i in -60..=60 {
        for j in -60..=60 {
            let (u, v) = (f64::from(i) * 0.05, f64::from(j) * 0.05);
            top[0] = top[0].max((d(u + h, v) - d(u - h, v)).norm() / (2.0 * h));
            top[1] = top[1].max((d(u, v + h) - d(u, v - h)).norm() / (2.0 * h));
        }
    }
    let bounds = sheet.second(&Patch::default());
    assert!(top[0] <= bounds[0] && top[1] <= bounds[1], "{top:?} {bounds:?}");
    assert!(trig::hypot(bounds[0], bounds[1]) < 2.0);
}

/// Two flat patches that meet in a corner, or in none, at a knot that halving does not come to exactly: a piece beside it goes
/// on there only where they do.
#[test]
fn a_piece_at_a_corner_of_the_surface_does_not_go_on() {
    use aptc_geometry::sculpt::{Layout, Patch as Bicubic};
    for knot in [0.052_895_871_052_422_07, 0.1, 0.3, 2.0 / 3.0] {
        for rise in [0.0, 0.4] {
            let flat = |x: f64, up: f64| {
                let [a, b] = [[0.0, 0.0], [1.0, up]].map(|[dx, z]| Vec3::new(x + dx, 0.0, z));
                let (u, v, none) = (b - a, Vec3::y(), Vec3::zeros());
                Bicubic::hermite([
                    [a, b, u, u],
                    [a + v, b + v, u, u],
                    [v, v, none, none],
                    [v, v, none, none],
                ])
            };
            let layout = Layout::Mesh { u: vec![0.0, knot, 1.0], v: vec![0.0, 1.0] };
            let patches = vec![flat(0.0, 0.0), flat(1.0, rise)];
            let sheet = Sheet::bare(&Sculptured::checked(patches, layout).unwrap()).unwrap();
            let Kind::Patched(patched) = &sheet.kind else { unreachable!() };
            let beside = |end: f64| {
                let all = patched.charts().filter(move |p| {
                    let [from, to] = [p.at[0] - p.half[0], p.at[0] + p.half[0]];
                    // In the middle across, where nothing else ends.
                    let inner = p.at[1] > 0.3 && p.at[1] < 0.7;
                    inner && (if end < 0.0 { from } else { to } - knot).abs() < 1e-12
                });
                all.collect::<Vec<_>>()
            };
            for (end, half) in [(1.0, 1), (-1.0, 0)] {
                let first = beside(end);
                assert!(!first.is_empty());
                for mut piece in first {
                    for depth in 0..20 {
                        assert_eq!(sheet.goes_on(&piece), rise == 0.0, "{knot} {end} {depth}");
                        piece = piece.halves(0)[half];
                    }
                }
            }
        }
    }
}

/// A round foot along a side and about its corner, where a border of the surface is one point.
fn foot() -> Sheet {
    use aptc_geometry::sculpt::Patch as Bicubic;
    let (x, y, z, o) = (Vec3::x(), Vec3::y(), Vec3::z(), Vec3::zeros());
    let at = Vec3::new;
    let side = [
        [at(3.0, 1.0, 0.0), at(3.0, 1.0, 2.0), z * 2.0, z * 2.0],
        [at(2.0, 0.0, 0.0), at(2.0, 0.0, 2.0), z * 2.0, z * 2.0],
        [-y, -y, o, o],
        [-x, -x, o, o],
    ];
    let tip = at(2.0, 0.0, 2.0);
    let corner = [
        [at(3.0, 1.0, 2.0), at(2.0, 1.0, 3.0), z, -x],
        [tip, tip, o, o],
        [-y, -y, o, o],
        [-x, -z, o, o],
    ];
    let patches = [side, corner].map(Bicubic::hermite).to_vec();
    Sheet::reaching(&Sculptured::grid(patches, 2, 1).unwrap()).unwrap()
}

/// Beyond the point there is nothing, where lines straight on from it would cross: all that lies there looks the same way as the
/// rest. Beside it pieces are told to turn the less the smaller they are.
#[test]
fn nothing_goes_on_from_a_point() {
    let sheet = foot();
    let whole = [[f64::NEG_INFINITY, f64::INFINITY]; 2];
    let all = sheet.pieces(&whole);
    let beyond = |p: &&Patch| p.at[1] > 1.0;
    assert!(all.iter().any(|p| p.at[1] > 1.0 && p.at[0] < 1.0));
    assert!(!all.iter().filter(beyond).any(|p| p.at[0] > 1.0 && p.at[0] < 2.0));
    for p in all.iter().filter(beyond) {
        assert!(sheet.jet(&p.spot()).n.y < -0.9, "{p:?}");
        let step = Spot { at: [p.at[0] + 0.6, p.at[1]], ..p.spot() };
        assert!(sheet.jet(&sheet.settle(step)).n.y < -0.9, "{p:?}");
    }
    let beside = |p: &&Patch| p.at[0] > 1.0 && p.at[0] < 2.0 && p.at[1] > 0.75 && p.at[1] < 1.0;
    let mut found = 0;
    for p in all.iter().filter(beside) {
        let mut piece = *p;
        for _ in 0..5 {
            // Towards the tip, and to both corners there.
            let along = usize::from(piece.at[0] > 1.5);
            piece = piece.halves(1)[1].halves(0)[along];
        }
        let [by_u, by_v] = sheet.tile(&piece).turn;
        assert!(by_u + by_v < 0.1, "{by_u} {by_v} {piece:?}");
        found += 1;
    }
    assert_eq!(found, 4);
}
