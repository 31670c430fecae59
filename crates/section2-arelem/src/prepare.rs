//! Which way the tool goes (APT: `AREPRE`).

use aptc_geometry::Vec3;
use aptc_protap::Direction;

use crate::failure::Failure;
use crate::state::Tool;

/// Least cosine by which one way must win. Below it (within about a twentieth of a degree of square) the
/// words do not decide.
const CLEAR: f64 = 1e-3;

/// Of `tangent` and its opposite the one that the word means: forward and back by the direction that was given for this
/// motion, else by that of the last one, left and right of it with the tool axis up, up and down by the tool axis.
pub(crate) fn way(tool: &Tool, word: Direction, tangent: Vec3) -> Result<Vec3, Failure> {
    let reference = match word {
        Direction::Goup => tool.ta,
        Direction::Godown => -tool.ta,
        Direction::Golft | Direction::Gorgt => {
            let left = tool.ta.cross(&tool.forward);
            if word == Direction::Golft { left } else { -left }
        }
        Direction::Gofwd | Direction::Goback => {
            if let Some(forward) = tool.sense.filter(|s| s.dot(&tool_unit(tangent)).abs() >= CLEAR)
            {
                let along = forward.dot(&tangent) > 0.0;
                return Ok(if along == (word == Direction::Gofwd) { tangent } else { -tangent });
            }
            // Of the last motion only the part across the axis decides, where both have one.
            let across = |v: Vec3| v - tool.ta * v.dot(&tool.ta);
            let (f, t) = (across(tool.forward), across(tool_unit(tangent)));
            let forward = if f.norm() > CLEAR && t.norm() > CLEAR { f } else { tool.forward };
            if word == Direction::Gofwd { forward } else { -forward }
        }
    };
    let (r, t) = (tool_unit(reference), tool_unit(tangent));
    let cosine = r.dot(&t);
    let flat = t - tool.ta * t.dot(&tool.ta);
    let scale = match word {
        Direction::Goup | Direction::Godown => 1.0,
        _ if flat.norm() > CLEAR => flat.norm(),
        _ => 1.0,
    };
    if cosine.abs() < CLEAR * scale {
        return Err(Failure::Direction { word });
    }
    Ok(if cosine > 0.0 { tangent } else { -tangent })
}

fn tool_unit(v: Vec3) -> Vec3 {
    let l = v.norm();
    if l > 0.0 { v / l } else { v }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tool() -> Tool {
        Tool { assumed: false, ..Tool::at(Vec3::zeros(), Vec3::z()) }
    }

    #[test]
    fn left_right_forward_and_back() {
        let go = |word, t| way(&tool(), word, t).unwrap();
        assert_eq!(go(Direction::Golft, Vec3::y()), Vec3::y());
        assert_eq!(go(Direction::Gorgt, Vec3::y()), -Vec3::y());
        assert_eq!(go(Direction::Gofwd, -Vec3::x()), Vec3::x());
        assert_eq!(go(Direction::Goback, -Vec3::x()), -Vec3::x());
        assert_eq!(go(Direction::Godown, Vec3::z()), -Vec3::z());
    }

    #[test]
    fn what_is_given_for_the_motion_decides_as_a_whole() {
        let rise = |z: f64| Vec3::new(0.1, 0.0, z).normalize();
        let go = |given: Vec3, word, t| {
            let mut tool = tool();
            tool.sense(given);
            way(&tool, word, t).unwrap()
        };
        // Along the axis, and against what is left across it.
        assert_eq!(go(Vec3::z(), Direction::Gofwd, rise(1.0)), rise(1.0));
        assert_eq!(go(-Vec3::z(), Direction::Gofwd, rise(1.0)), -rise(1.0));
        assert_eq!(go(Vec3::z(), Direction::Goback, rise(1.0)), -rise(1.0));
        assert_eq!(go(Vec3::new(-0.2, 0.0, 1.0), Direction::Gofwd, rise(1.0)), rise(1.0));
        // Square to the way it says nothing, and the motion before does.
        assert_eq!(go(Vec3::z(), Direction::Gofwd, Vec3::x()), Vec3::x());
        // A motion since then takes its place.
        let mut tool = tool();
        tool.sense(-Vec3::x());
        tool.turn(Vec3::x());
        assert_eq!(way(&tool, Direction::Gofwd, rise(0.1)).unwrap(), rise(0.1));
    }

    #[test]
    fn square_to_forward_is_neither_forward_nor_back() {
        assert!(matches!(
            way(&tool(), Direction::Gofwd, Vec3::y()),
            Err(Failure::Direction { .. })
        ));
        assert!(matches!(
            way(&tool(), Direction::Golft, Vec3::x()),
            Err(Failure::Direction { .. })
        ));
    }
}
