//! Borders of faces in the plane of their surface's parameters: the box that holds them, and whether they are that box.

/// A border may leave the box by this part of its sides.
const OFF: f64 = 1e-4;

/// The box of a border.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Border {
    /// From and to, of both parameters.
    pub(crate) range: [[f64; 2]; 2],
    /// Is the border that of the box?
    pub(crate) whole: bool,
}

/// The box of closed lines through the given places. A parameter that goes `around` begins at the first of these numbers and
/// ends at the second, whatever the places say. `None` where the box has no inside.
pub(crate) fn boxed(lines: &[Vec<[f64; 2]>], around: [Option<[f64; 2]>; 2]) -> Option<Border> {
    let places = || lines.iter().flatten();
    let range = [0, 1].map(|k| {
        around[k].unwrap_or_else(|| {
            places()
                .fold([f64::INFINITY, f64::NEG_INFINITY], |r, p| [r[0].min(p[k]), r[1].max(p[k])])
        })
    });
    let sound = range.iter().all(|r| r[0].is_finite() && r[1].is_finite());
    let size = range.map(|r| r[1] - r[0]);
    let least = [0, 1].map(|k| 1e-9 * range[k][0].abs().max(range[k][1].abs()));
    if !sound || (0..2).any(|k| size[k] <= least[k]) {
        return None;
    }
    // A line that never leaves the border of the box and comes to all of its sides goes round it.
    let on = |p: &[f64; 2], k: usize| {
        let room = OFF * size[k];
        around[k].is_none() && range[k].iter().any(|end| (p[k] - end).abs() <= room)
    };
    let whole = places().all(|p| on(p, 0) || on(p, 1));
    Some(Border { range, whole })
}

/// Names of faces in a message, the first of them.
pub(crate) fn named(faces: &[String]) -> String {
    const MOST: usize = 12;
    let mut text = faces.iter().take(MOST).cloned().collect::<Vec<_>>().join(", ");
    if faces.len() > MOST {
        text += &format!(" and {} more", faces.len() - MOST);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(corners: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let mut out = Vec::new();
        for (k, a) in corners.iter().enumerate() {
            let b = corners[(k + 1) % corners.len()];
            out.extend((0..8).map(|i| {
                let t = f64::from(i) / 8.0;
                [0, 1].map(|k| a[k] + (b[k] - a[k]) * t)
            }));
        }
        out
    }

    #[test]
    fn a_box_and_what_is_none() {
        let all = square(&[[1.0, 2.0], [5.0, 2.0], [5.0, 3.0], [1.0, 3.0]]);
        let border = boxed(std::slice::from_ref(&all), [None; 2]).unwrap();
        assert_eq!(border, Border { range: [[1.0, 5.0], [2.0, 3.0]], whole: true });
        let hole = square(&[[2.0, 2.2], [3.0, 2.2], [3.0, 2.8]]);
        assert!(!boxed(&[all, hole], [None; 2]).unwrap().whole);
        let cut = square(&[[1.0, 2.0], [5.0, 2.0], [5.0, 3.0]]);
        assert!(!boxed(&[cut], [None; 2]).unwrap().whole);
        let flat = square(&[[1.0, 2.0], [5.0, 2.0]]);
        assert!(boxed(std::slice::from_ref(&flat), [None; 2]).is_none());
        // Two rings round a cylinder.
        let rings = [0.0, 4.0].map(|v| (0..9).map(|k| [f64::from(k), v]).collect());
        let border = boxed(&rings, [Some([0.0, 8.0]), None]).unwrap();
        assert_eq!(border, Border { range: [[0.0, 8.0], [0.0, 4.0]], whole: true });
    }
}
