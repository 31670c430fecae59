//! What lies between the stretches of neighbouring lines that REGION leaves.

use aptc_cldata::Position;
use aptc_cldata::milling::{Extent, Outline, Scallop};
use aptc_geometry::Sculptured;

use crate::drive::Course;
use crate::touched::Touched;

/// What a stretch touches, and the number of its line, counted from the first.
#[derive(Clone, Debug)]
pub(crate) struct Strip {
    pub(crate) line: usize,
    pub(crate) touched: Touched,
}

/// Parameters between two stretches, along the lines and across.
#[derive(Clone, Copy, Debug)]
struct Between {
    along: [f64; 2],
    across: [f64; 2],
}

/// What is promised of the places between the stretches, where a scallop of this height is asked for; `excused` where the tool
/// got out of the way. Beside a single stretch nothing lies between.
///
/// Of two stretches of neighbouring lines it is what runs beside both. What lies beyond the end of one of them, or beside lines
/// of which nothing is left, is not between any.
pub(crate) fn scallop(
    strips: &[Strip],
    (surface, course): (&Sculptured, Course),
    height: f64,
    excused: Option<&'static str>,
) -> Option<Scallop> {
    if height <= 0.0 || strips.len() < 2 {
        return None;
    }
    let (extent, links) = match between(strips, course) {
        Ok(all) => {
            let lines = all.iter().flat_map(|(b, _)| b.outline(course)).collect();
            let links = all.iter().flat_map(|(b, pair)| b.links(*pair, surface, course)).collect();
            (Extent::Outline(Outline { lines, along: course.index() }), links)
        }
        Err(why) => (Extent::Unknown(why), Vec::new()),
    };
    Some(Scallop { height, extent, excused, links })
}

/// What lies between each two stretches of neighbouring lines, with these.
fn between(
    strips: &[Strip],
    course: Course,
) -> Result<Vec<(Between, [&Touched; 2])>, &'static str> {
    let (k, c) = (course.index(), course.across().index());
    let mut all = Vec::new();
    for a in strips {
        for b in strips.iter().filter(|b| b.line == a.line + 1) {
            let [one, other] = [a.touched.range(), b.touched.range()];
            if [one, other].iter().flatten().flatten().any(|x| !x.is_finite()) {
                return Err("a pass of it touches nothing");
            }
            let along = [one[k][0].max(other[k][0]), one[k][1].min(other[k][1])];
            if along[0] >= along[1] {
                continue;
            }
            let [up, down] = [[one[c][1], other[c][0]], [other[c][1], one[c][0]]];
            let across = if up[0] < up[1] { up } else { down };
            if across[0] >= across[1] {
                return Err("the contacts of its passes cross");
            }
            all.push((Between { along, across }, [&a.touched, &b.touched]));
        }
    }
    if all.is_empty() { Err("no two of its passes run beside each other") } else { Ok(all) }
}

impl Between {
    /// Its borders.
    fn outline(&self, course: Course) -> [[[f64; 2]; 2]; 4] {
        let Self { along: [a, b], across: [c, d] } = *self;
        let at = |along: f64, across: f64| {
            let mut at = [along; 2];
            at[course.across().index()] = across;
            at
        };
        let corners = [at(a, c), at(b, c), at(b, d), at(a, d)];
        [0, 1, 2, 3].map(|i| [corners[i], corners[(i + 1) % 4]])
    }

    /// Where one of two stretches ends the tool would go from there straight over to the other line.
    fn links(
        &self,
        pair: [&Touched; 2],
        surface: &Sculptured,
        course: Course,
    ) -> Vec<[Position; 2]> {
        let (k, c) = (course.index(), course.across().index());
        let mut all = Vec::new();
        for end in 0..2 {
            for (i, one) in pair.iter().enumerate() {
                let (border, own) = (self.along[end], one.range()[k][end]);
                let short = if end == 0 { own >= border } else { own <= border };
                let Some(stand) = one.stand(end).filter(|_| short) else { continue };
                let mut uv = [border; 2];
                let other = pair[1 - i].range()[c];
                uv[c] = if one.range()[c][0] < other[0] { other[0] } else { other[1] };
                let [u, v] = uv;
                all.push([stand.at(), stand.over(surface.at(u, v).point)]);
            }
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A stretch along u at the given v.
    fn strip(line: usize, [from, to]: [f64; 2]) -> Strip {
        let v = 0.5 * (line + 1) as f64;
        let contacts = [[from, v], [0.5 * (from + to), v], [to, v]];
        Strip { line, touched: Touched::by(contacts.into_iter(), Vec::new(), false) }
    }

    fn held(strips: &[Strip], at: [f64; 2]) -> bool {
        let lines = between(strips, Course::U).unwrap();
        let lines = lines.iter().flat_map(|(b, _)| b.outline(Course::U)).collect();
        Outline { lines, along: 0 }.holds(at)
    }

    /// Over three lines, the middle one in two stretches about a hole; beyond the ends of either nothing lies between.
    #[test]
    fn what_runs_beside_both_stretches_lies_between() {
        let all = [
            strip(0, [0.0, 4.0]),
            strip(1, [3.0, 5.0]),
            strip(1, [0.5, 2.0]),
            strip(2, [1.0, 4.5]),
        ];
        for (at, within) in [
            ([0.4, 0.7], false),
            ([0.6, 0.7], true),
            ([1.9, 0.7], true),
            ([2.5, 0.7], false),
            ([3.1, 0.7], true),
            ([4.1, 0.7], false),
            ([0.8, 1.2], false),
            ([1.1, 1.2], true),
            ([4.4, 1.2], true),
            ([4.6, 1.2], false),
            ([2.0, 1.6], false),
            ([2.0, 0.4], false),
        ] {
            assert_eq!(held(&all, at), within, "{at:?}");
        }
    }

    /// Lines of which the one between has nothing left, stretches beside none, and such as touch nothing.
    #[test]
    fn what_is_not_known_is_told() {
        for all in [
            [strip(0, [0.0, 4.0]), strip(2, [0.0, 4.0])],
            [strip(0, [0.0, 1.0]), strip(1, [2.0, 4.0])],
            [
                strip(0, [0.0, 1.0]),
                Strip { line: 1, touched: Touched::by([].into_iter(), Vec::new(), false) },
            ],
        ] {
            assert!(between(&all, Course::U).is_err());
        }
    }
}
