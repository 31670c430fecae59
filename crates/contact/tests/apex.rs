//! Checks beside the corner of a patch of three sides: they come to an answer there as elsewhere.

use aptc_contact::{Clear, PatchTree};
use aptc_geometry::sculpt::Patch;
use aptc_geometry::{Cutter, Profile, Sculptured, Tool, Vec3};

/// Straight lines from a bent border to one point.
fn fan() -> Sculptured {
    let apex = Vec3::new(90.0, 0.0, 3.0);
    let border = |u: f64| {
        let x = 2.0 * u - 1.0;
        Vec3::new(52.0 - 2.0 * x * x, -20.0 * x, 8.0 - 7.0 * x * x - x)
    };
    let way = |u: f64| {
        let x = 2.0 * u - 1.0;
        Vec3::new(-8.0 * x, -40.0, -28.0 * x - 2.0)
    };
    let none = Vec3::zeros();
    let across = [apex - border(0.0), apex - border(1.0), -way(0.0), -way(1.0)];
    let patch = Patch::hermite([
        [border(0.0), border(1.0), way(0.0), way(1.0)],
        [apex, apex, none, none],
        across,
        across,
    ]);
    Sculptured::grid(vec![patch], 1, 1).expect("one patch")
}

#[test]
fn a_tool_beside_the_corner_is_clear_or_not() {
    let surface = fan();
    let tree = PatchTree::new(&surface);
    let profile = Profile::new(&Cutter::mill(6.0, 3.0, 40.0)).expect("a ball");
    for v in [0.5, 0.9, 0.97, 0.99, 0.999, 0.99999, 1.0] {
        for u in [0.0, 0.3, 0.5, 1.0] {
            let n = surface.normal_at(u, v).expect("a normal by its limit");
            let n = if n.z < 0.0 { -n } else { n };
            for shift in [-0.1, 0.1] {
                let te = surface.at(u, v).point + n * (3.0 + shift) - Vec3::z() * 3.0;
                let tool = Tool { profile: &profile, te, ta: Vec3::z() };
                let found = tree.clear(&tool, 0.01);
                let told = if shift > 0.0 {
                    matches!(found, Clear::Yes)
                } else {
                    matches!(found, Clear::No(..))
                };
                assert!(told, "{u} {v} {shift} {found:?}");
            }
        }
    }
}
