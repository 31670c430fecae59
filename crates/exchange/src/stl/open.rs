//! Where triangles leave a surface open, so that a tool may come through.

use aptc_geometry::{Vec3, shell};

/// Of triangles with edges that have a triangle on one side alone, how many and where.
pub(super) fn told(all: &[[Vec3; 3]]) -> Option<String> {
    let edges = shell::edges(all);
    let open: Vec<[Vec3; 2]> =
        edges.values().filter(|e| e.0[0] + e.0[1] == 1).map(|e| e.1).collect();
    let length = |e: &[Vec3; 2]| (e[1] - e[0]).norm();
    let longest = open.iter().max_by(|a, b| length(a).total_cmp(&length(b)))?;
    let [from, to] = longest.map(|p| format!("{}, {}, {}", p.x, p.y, p.z));
    Some(format!(
        "its triangles do not close: {} edges have one on one side alone, the longest from {from} to {to}; where that is a hole, a tool that comes through it is not seen",
        open.len()
    ))
}
