//! Transformations of STEP that place a representation in another one.

use std::collections::BTreeSet;

use aptc_geometry::{Transform, Vec3};
use ruststep::ast::Parameter;

use super::super::curves::{Frame, direction, frame, point, single};
use super::super::{Entities, of, real, reference};

/// From the first representation of a relation into the second: the frame of its first item onto that of its second.
///
/// `items` are those of both representations: some programs name the frames the other way round.
pub(super) fn operator(
    entities: &Entities<'_>,
    id: u64,
    [first, second]: [&BTreeSet<u64>; 2],
) -> Option<Transform> {
    let Some(all) = single(entities, id, "ITEM_DEFINED_TRANSFORMATION") else {
        return scaled(entities, id);
    };
    let [.., a, b] = all else { return None };
    let (one, two) = (reference(a)?, reference(b)?);
    let belong = first.contains(&one) && second.contains(&two);
    let exchanged = !belong && first.contains(&two) && second.contains(&one);
    let (a, b) = if exchanged { (b, a) } else { (a, b) };
    onto(entities, a, b)
}

/// The representation that a mapped item shows, and where; `None` for what is no mapped item.
pub(super) fn mapped(entities: &Entities<'_>, id: u64) -> Option<(u64, Option<Transform>)> {
    let [.., map, target] = of(entities.get(&id)?, "MAPPED_ITEM")? else { return None };
    let [origin, shown] = single(entities, reference(map)?, "REPRESENTATION_MAP")? else {
        return None;
    };
    Some((reference(shown)?, onto(entities, origin, target)))
}

/// One frame onto another, which may scale and mirror.
fn onto(entities: &Entities<'_>, from: &Parameter, to: &Parameter) -> Option<Transform> {
    let from = placed(&frame(entities, from)?).inverse()?;
    let to = match frame(entities, to) {
        Some(to) => placed(&to),
        None => scaled(entities, reference(to)?)?,
    };
    Some(from.then(&to))
}

/// From coordinates of a frame.
fn placed(f: &Frame) -> Transform {
    let Frame { origin, x, y, z } = f;
    Transform::from_rows(&[
        x.x, y.x, z.x, origin.x, x.y, y.y, z.y, origin.y, x.z, y.z, z.z, origin.z,
    ])
}

/// CARTESIAN_TRANSFORMATION_OPERATOR_3D: directions of x and y, the origin, the scale, and the direction of z. The second
/// direction says on which side y is.
fn scaled(entities: &Entities<'_>, id: u64) -> Option<Transform> {
    let all = single(entities, id, "CARTESIAN_TRANSFORMATION_OPERATOR_3D")?;
    let [.., x, y, origin, scale, z] = all else { return None };
    let own = |p: &Parameter| match reference(p) {
        Some(_) => direction(entities, p).map(Some),
        None => Some(None),
    };
    let (x, y, z) = (own(x)?, own(y)?, own(z)?.unwrap_or_else(Vec3::z));
    let origin = point(entities, origin)?;
    let scale = match scale {
        Parameter::NotProvided | Parameter::Omitted => 1.0,
        given => real(given).filter(|s| *s > 0.0)?,
    };
    let square = |w: Vec3, to: Vec3| (w - to * w.dot(&to)).try_normalize(1e-9);
    let x = x.or(Some(Vec3::x())).and_then(|w| square(w, z)).or_else(|| square(Vec3::y(), z))?;
    let left = z.cross(&x);
    let y = if y.unwrap_or_else(Vec3::y).dot(&left) < 0.0 { -left } else { left };
    let (x, y, z) = (x * scale, y * scale, z * scale);
    Some(placed(&Frame { origin, x, y, z }))
}
