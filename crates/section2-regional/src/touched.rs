//! What the passes of a region touch of the part surface, and the region between them.

use aptc_cldata::Position;
use aptc_cldata::milling::Extent;
use aptc_geometry::{Sculptured, Vec3};

use crate::position::Position as Standing;
use crate::round::round;

/// The contacts of a pass, by parameters of the part surface, in one direction for all passes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Touched {
    line: Vec<[f64; 2]>,
    /// Least and greatest u and v.
    range: [[f64; 2]; 2],
    /// Where the tool stands at its ends, and between them where it begins and ends to roll over an edge.
    stands: Vec<Stand>,
}

/// Where the tool stands, and what it touches there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stand {
    at: Position,
    contact: Vec3,
}

impl Stand {
    pub(crate) fn of(p: &Standing) -> Self {
        Self { at: Position { te: p.te, ta: p.ta }, contact: p.contact }
    }

    pub(crate) fn at(&self) -> Position {
        self.at
    }

    /// The tool as it stands here with its contact at another place.
    pub(crate) fn over(&self, contact: Vec3) -> Position {
        Position { te: self.at.te + (contact - self.contact), ..self.at }
    }
}

impl Touched {
    /// The contacts of a pass and where the tool stands at its ends and beside edges; `back`: the pass goes the other way.
    pub(crate) fn by(
        contacts: impl Iterator<Item = [f64; 2]>,
        mut stands: Vec<Stand>,
        back: bool,
    ) -> Self {
        let mut line: Vec<[f64; 2]> = contacts.collect();
        if back {
            line.reverse();
            stands.reverse();
        }
        let range = [0, 1].map(|k| {
            let all = line.iter().map(|uv| uv[k]);
            all.fold([f64::INFINITY, f64::NEG_INFINITY], |r, x| [r[0].min(x), r[1].max(x)])
        });
        Self { line, range, stands }
    }

    /// Least and greatest u and v.
    pub(crate) fn range(&self) -> [[f64; 2]; 2] {
        self.range
    }

    /// Where the tool stands at its beginning, 0, or its end, 1.
    pub(crate) fn stand(&self, end: usize) -> Option<&Stand> {
        if end == 0 { self.stands.first() } else { self.stands.last() }
    }

    /// The same of the positions of a path and of its rolls over edges, and its contacts.
    pub(crate) fn of(
        points: &[Standing],
        rolls: &[[Standing; 2]],
        contacts: Vec<[f64; 2]>,
        back: bool,
    ) -> Self {
        let stands = points.first().into_iter().chain(rolls.iter().flatten()).chain(points.last());
        let stands = stands.map(Stand::of).collect();
        Self::by(contacts.into_iter(), stands, back)
    }
}

/// From each end of a pass to the same end of the next, and from each side of an edge that both roll over to the same side. Where
/// one rolls over more edges than the other nothing tells which are the same.
pub(crate) fn links(touched: &[Touched]) -> Vec<[Position; 2]> {
    let mut all = Vec::new();
    for pair in touched.windows(2) {
        let [a, b] = [&pair[0].stands, &pair[1].stands];
        match (a.as_slice(), b.as_slice()) {
            ([first, .., last], [begin, .., end]) if a.len() != b.len() => {
                link([first, begin], &mut all);
                link([last, end], &mut all);
            }
            _ => a.iter().zip(b).for_each(|(a, b)| link([a, b], &mut all)),
        }
    }
    all
}

/// From one stand to the next. To and fro a tool that leans along the path leans one way and the other: what it does not come over
/// while it turns it would with either axis.
fn link([a, b]: [&Stand; 2], all: &mut Vec<[Position; 2]>) {
    all.push([a.at, b.at]);
    if a.at.ta != b.at.ta {
        all.extend([[a.at, a.over(b.contact)], [b.over(a.contact), b.at]]);
    }
}

/// The region of passes along lines of the part surface itself.
pub(crate) fn along_lines(touched: &[Touched], surface: &Sculptured) -> Extent {
    let ranges: Vec<_> = touched.iter().map(|t| t.range).collect();
    between(&ranges, surface.spans())
        .map_or(Extent::Unknown("no box of parameters lies between its passes"), Extent::Box)
}

/// The region of passes that another surface leads: where they run along neither parameter its outline.
pub(crate) fn led(touched: &[Touched], surface: &Sculptured) -> Extent {
    let lines: Vec<&[[f64; 2]]> = touched.iter().map(|t| &t.line[..]).collect();
    round(&lines, surface).map_or_else(Extent::Unknown, Extent::Outline)
}

/// The box of the part surface's parameters that lies between the first and the last pass, from the least and greatest
/// parameters that each pass touches; the greater one of the two that passes along u and along v would have.
///
/// Along the passes it goes as far as each of them does. Their contacts run through all of it without a gap, the first on one
/// side of the box and the last on the other, so that every place in it has a pass on either side.
fn between(touched: &[[[f64; 2]; 2]], spans: [f64; 2]) -> Option<[[f64; 2]; 2]> {
    let (first, last) = (touched.first()?, touched.last()?);
    let boxes = [0, 1].map(|k| {
        let c = 1 - k;
        let whole = [f64::NEG_INFINITY, f64::INFINITY];
        let along = touched.iter().fold(whole, |r, t| [r[0].max(t[k][0]), r[1].min(t[k][1])]);
        let up = [first[c][1], last[c][0]];
        let down = [last[c][1], first[c][0]];
        let mut range = [along; 2];
        range[c] = if up[0] < up[1] { up } else { down };
        range
    });
    let size =
        |r: &[[f64; 2]; 2]| (r[0][1] - r[0][0]) / spans[0] * ((r[1][1] - r[1][0]) / spans[1]);
    let real = boxes.into_iter().filter(|r| r.iter().all(|[a, b]| a < b));
    real.max_by(|a, b| size(a).total_cmp(&size(b)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_cldata::milling::Outline;
    use aptc_geometry::sculpt::{SplinePoint, mesh};
    use aptc_geometry::sculptured::MeshSpacing;

    /// Passes along u at several v, in either order; along v; askew, and across both: a box between all of them, or none.
    #[test]
    fn a_box_between_the_first_and_the_last_pass() {
        let lines = [[[0.0, 4.0], [0.5, 0.6]], [[0.2, 4.0], [1.4, 1.7]], [[0.0, 3.9], [2.5, 2.8]]];
        let boxed = Some([[0.2, 3.9], [0.6, 2.5]]);
        assert_eq!(between(&lines, [4.0, 3.0]), boxed);
        let mut back = lines;
        back.reverse();
        assert_eq!(between(&back, [4.0, 3.0]), boxed);
        let turned = lines.map(|[u, v]| [v, u]);
        assert_eq!(between(&turned, [3.0, 4.0]), Some([[0.6, 2.5], [0.2, 3.9]]));
        let askew = [[[0.0, 2.0], [0.0, 2.0]], [[1.0, 3.0], [1.0, 3.0]]];
        assert_eq!(between(&askew, [4.0, 4.0]), None);
        assert_eq!(between(&lines[..1], [4.0, 3.0]), None);
        assert_eq!(between(&[], [4.0, 3.0]), None);
    }

    /// Ends to ends and edges to edges, to and fro, with both axes where these differ; edges of which one pass has more count for
    /// nothing.
    #[test]
    fn links_lead_from_stand_to_stand() {
        let stand = |x: f64, y: f64, lean: f64| {
            let contact = Vec3::new(x, y, 0.0);
            let ta = Vec3::new(lean, 0.0, 1.0).normalize();
            Stand { at: Position { te: contact - ta, ta }, contact }
        };
        let pass = |y: f64, xs: &[f64], lean: f64, back: bool| {
            let mut all: Vec<_> = xs.iter().map(|x| stand(*x, y, lean)).collect();
            if back {
                all.reverse();
            }
            Touched::by(std::iter::empty(), all, back)
        };
        let xs = [0.0, 4.0, 4.0, 9.0];
        let passes = [pass(0.0, &xs, 0.2, false), pass(1.0, &xs, 0.2, true)];
        let ends = links(&passes).into_iter().map(|[a, b]| (a.te, b.te - a.te));
        let wanted = xs.map(|x| (stand(x, 0.0, 0.2).at.te, Vec3::y()));
        assert!(ends.eq(wanted));
        // With either axis the contact goes from the one to the other.
        let turned = links(&[pass(0.0, &xs, 0.2, false), pass(1.0, &xs, -0.2, true)]);
        assert_eq!(turned.len(), 3 * xs.len());
        let straight = turned.iter().filter(|[a, b]| a.ta == b.ta && b.te - a.te == Vec3::y());
        assert_eq!(straight.count(), 2 * xs.len());
        let fewer = links(&[pass(0.0, &xs, 0.2, false), pass(1.0, &[0.0, 9.0], 0.2, true)]);
        assert!(fewer.iter().map(|[a, _]| a.te).eq([0.0, 9.0].map(|x| stand(x, 0.0, 0.2).at.te)));
    }

    fn flat() -> Sculptured {
        let row = |y: f64| {
            let at = |x: f64| SplinePoint::plain(Vec3::new(x, y, 0.0));
            [0.0, 10.0, 20.0].map(at).to_vec()
        };
        mesh(&[row(0.0), row(10.0), row(20.0)], MeshSpacing::Xyz).unwrap()
    }

    #[test]
    fn an_outline_round_askew_passes() {
        // Askew by 45 degrees, to and fro.
        let pass = |i: i32| {
            let d = 0.1 * f64::from(i);
            let line = [[0.8 + d, 0.2 + d], [0.6 + d, 0.4 + d], [0.4 + d, 0.6 + d]];
            let back = i % 2 == 1;
            let mut way = line.to_vec();
            if back {
                way.reverse();
            }
            Touched::by(way.into_iter(), Vec::new(), back)
        };
        let passes: Vec<_> = (0..4).map(pass).collect();
        let s = flat();
        let Extent::Outline(Outline { lines, .. }) = led(&passes, &s) else {
            panic!("an outline");
        };
        assert_eq!(lines.len(), 10);
        // Its area is that of the rectangle.
        let area: f64 = lines.iter().map(|[a, b]| a[0] * b[1] - a[1] * b[0]).sum();
        assert!((0.5 * area.abs() - 0.24).abs() < 1e-12, "{area}");
        // Passes that cross, one pass, and contacts that jump have none.
        let line = |points: &[[f64; 2]]| Touched::by(points.iter().copied(), Vec::new(), false);
        let cross = [line(&[[0.0, 0.0], [1.0, 1.0]]), line(&[[0.0, 1.0], [1.0, 0.0]])];
        assert!(matches!(led(&cross, &s), Extent::Unknown(_)));
        assert!(matches!(led(&passes[..1], &s), Extent::Unknown(_)));
        assert!(matches!(led(&[passes[0].clone(), line(&[])], &s), Extent::Unknown(_)));
    }
}
