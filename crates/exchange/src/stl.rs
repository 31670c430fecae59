//! STL: triangles, for checking.

use std::io::Cursor;

use aptc_geometry::Vec3;
use aptc_geometry::sculptured::SurfaceShape;

use crate::{Collected, Fault, Limits, Outside, broken};

/// Bytes before the triangles of a binary file, and of each.
const HEAD: usize = 84;
const TRIANGLE: usize = 50;

/// Is it the text of an STL file, or its bytes?
pub(crate) fn is(text: &str) -> bool {
    let start = text.trim_start();
    start.get(..5).is_some_and(|s| s.eq_ignore_ascii_case("solid"))
        && (start.contains("facet") || start.contains("FACET"))
        || binary(text).is_some()
}

/// The bytes of a binary file, whose length its head tells.
fn binary(text: &str) -> Option<Vec<u8>> {
    let fits = |b: &[u8]| {
        let Some(n) = b.get(80..HEAD).and_then(|n| n.first_chunk::<4>()) else { return false };
        let n = usize::try_from(u32::from_le_bytes(*n)).unwrap_or(usize::MAX);
        n > 0 && n.checked_mul(TRIANGLE).and_then(|m| m.checked_add(HEAD)) == Some(b.len())
    };
    if fits(text.as_bytes()) {
        return Some(text.as_bytes().to_vec());
    }
    let bytes: Option<Vec<u8>> = text.chars().map(|c| u8::try_from(u32::from(c)).ok()).collect();
    bytes.filter(|b| fits(b))
}

pub(crate) fn read(text: &str, limits: &Limits) -> Result<Outside, Fault> {
    let mut bytes = binary(text).unwrap_or_default();
    if bytes.is_empty() {
        bytes.extend_from_slice(text.as_bytes());
    } else {
        // A head that begins like a text must not make it one.
        bytes[..80].fill(0);
    }
    let mut source = Cursor::new(bytes);
    let failed = |e: std::io::Error| broken(format!("this STL file cannot be read: {e}"));
    let triangles = stl_io::create_stl_reader(&mut source).map_err(failed)?;
    let mut all = Vec::new();
    for t in triangles {
        let t = t.map_err(failed)?;
        if all.len() >= limits.points / 3 {
            return Err(Fault::TooLarge(format!("more than {} triangles", limits.points / 3)));
        }
        let corners = t.vertices.map(|v| Vec3::from(v.0.map(f64::from)));
        if !corners.iter().all(|c| c.iter().all(|x| x.is_finite())) {
            return Err(broken(format!(
                "triangle {} has a corner that is not finite",
                all.len() + 1
            )));
        }
        // A triangle without area has neighbours that cover it.
        let [a, b, c] = corners;
        if (b - a).cross(&(c - a)) != Vec3::zeros() {
            all.push(corners);
        }
    }
    let mut out = Collected::new(limits);
    if !all.is_empty() {
        let n = 3 * all.len();
        out.push(SurfaceShape::Facets(all), n, None)?;
    }
    Ok(out.file)
}
