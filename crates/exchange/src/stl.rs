//! STL: triangles, for checking. Which way they are turned does not count, for a tool may be on neither side in them.
//!
//! Read without a library: those that are kept read no texts of several solids, in capitals or without a name, and tell no line in
//! which one is broken.

mod open;

use aptc_geometry::Vec3;
use aptc_geometry::sculptured::SurfaceShape;

use crate::{Collected, Fault, Limits, Outside, broken};

/// Bytes before the triangles of a binary file, and of each.
const HEAD: usize = 84;
const TRIANGLE: usize = 50;

/// Coordinates of the format's numbers are below it.
const FAR: f64 = 4e38;

type Triangle = [Vec3; 3];

/// Is it the text of an STL file, or its bytes?
pub(crate) fn is(text: &str) -> bool {
    let mut lines = lines(text);
    let word = |line: Option<(usize, &str)>, words: &[&str]| {
        let first = line.and_then(|(_, l)| l.split_whitespace().next()).unwrap_or_default();
        words.iter().any(|w| first.eq_ignore_ascii_case(w))
    };
    word(lines.next(), &["solid"]) && word(lines.next(), &["facet", "endsolid"])
        || Bytes::of(text).is_some_and(|b| b.is_whole())
}

/// Lines that are not empty, with their numbers.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let text = text.trim_start_matches('\u{feff}');
    (1..).zip(text.lines()).filter(|(_, l)| !l.trim().is_empty())
}

/// The bytes of a binary file.
struct Bytes(Vec<u8>);

impl Bytes {
    /// Those of a text that may be one, which has the byte 0: as they are, or of letters that stand for bytes.
    fn of(text: &str) -> Option<Self> {
        if !text.contains('\0') {
            return None;
        }
        let own = Self(text.as_bytes().to_vec());
        if own.is_whole() {
            return Some(own);
        }
        let bytes: Option<Vec<u8>> =
            text.chars().map(|c| u8::try_from(u32::from(c)).ok()).collect();
        bytes.filter(|b| b.len() >= HEAD).map(Self)
    }

    /// How many triangles the head tells.
    fn told(&self) -> usize {
        let n = self.0.get(80..HEAD).and_then(|n| n.first_chunk::<4>());
        n.map_or(0, |n| usize::try_from(u32::from_le_bytes(*n)).unwrap_or(usize::MAX))
    }

    fn is_whole(&self) -> bool {
        let due = self.told().checked_mul(TRIANGLE).and_then(|n| n.checked_add(HEAD));
        due == Some(self.0.len())
    }

    fn triangles(&self) -> Result<impl Iterator<Item = Triangle>, Fault> {
        if !self.is_whole() {
            return Err(broken(format!(
                "its head tells of {} triangles, and behind it are {} bytes, {TRIANGLE} for each",
                self.told(),
                self.0.len() - HEAD
            )));
        }
        let number = |b: &[u8], at: usize| {
            let own = b.get(at..).and_then(|b| b.first_chunk::<4>());
            own.map_or(f64::NAN, |b| f64::from(f32::from_le_bytes(*b)))
        };
        // Behind the normal.
        let corner =
            move |b: &[u8], k: usize| Vec3::from([0, 4, 8].map(|i| number(b, 12 + 12 * k + i)));
        Ok(self.0[HEAD..].chunks_exact(TRIANGLE).map(move |b| [0, 1, 2].map(|k| corner(b, k))))
    }
}

pub(crate) fn read(text: &str, limits: &Limits) -> Result<Outside, Fault> {
    let mut found = Found { all: Vec::new(), n: 0, flat: 0, limits };
    match Bytes::of(text) {
        Some(bytes) => bytes.triangles()?.try_for_each(|t| found.add(t, None))?,
        None => written(text, &mut found)?,
    }
    let mut out = Collected::new(limits);
    let Found { all, flat, .. } = found;
    if all.is_empty() {
        return Err(broken(match flat {
            0 => "it holds no triangles".to_owned(),
            _ => format!("none of its {flat} triangles has an area"),
        }));
    }
    out.file.notes.extend(open::told(&all));
    let n = 3 * all.len();
    out.push(SurfaceShape::Facets(all), n, None)?;
    Ok(out.done())
}

/// The triangles of a file.
struct Found<'l> {
    all: Vec<Triangle>,
    /// How many there were, and how many of them have no area.
    n: usize,
    flat: usize,
    limits: &'l Limits,
}

impl Found<'_> {
    fn add(&mut self, corners: Triangle, lines: Option<[usize; 3]>) -> Result<(), Fault> {
        self.n += 1;
        if self.n > self.limits.points / 3 {
            return Err(Fault::TooLarge(format!("more than {} triangles", self.limits.points / 3)));
        }
        let far = corners.iter().position(|c| !c.iter().all(|x| x.abs() < FAR));
        if let Some(k) = far {
            let what = format!("triangle {} has a corner that is not finite", self.n);
            return Err(Fault::Broken { what, line: lines.map(|l| l[k]) });
        }
        // A triangle without area has neighbours that cover it.
        let [a, b, c] = corners;
        if (b - a).cross(&(c - a)) == Vec3::zeros() {
            self.flat += 1;
        } else {
            self.all.push(corners);
        }
        Ok(())
    }
}

/// The triangles of a text: `solid`, of each `facet normal`, `outer loop`, three of `vertex`, `endloop` and `endfacet`, and
/// `endsolid`, in small letters or capitals, of as many solids as there are.
fn written(text: &str, found: &mut Found<'_>) -> Result<(), Fault> {
    const FACET: [&str; 6] = ["outer", "vertex", "vertex", "vertex", "endloop", "endfacet"];
    let (mut last, mut within) = (1, false);
    let mut lines = lines(text).map(|(at, line)| {
        let mut words = line.split_whitespace();
        let first = words.next().unwrap_or_default();
        (at, line.trim(), first.to_ascii_lowercase(), words)
    });
    let wrong = |at: usize, due: &str, line: &str| {
        let held: String = line.chars().take(30).collect();
        Fault::Broken { what: format!("{due} is due there, and `{held}` stands"), line: Some(at) }
    };
    let ended = |at: usize, due: &str| {
        let what = format!("the file ends where {due} is due");
        Fault::Broken { what, line: Some(at) }
    };
    while let Some((at, line, first, _)) = lines.next() {
        last = at;
        match (first.as_str(), within) {
            ("solid", false) => within = true,
            ("endsolid", true) => within = false,
            ("facet", true) => {
                let (mut corners, mut at_lines, mut n) = ([Vec3::zeros(); 3], [0; 3], 0);
                for due in FACET {
                    let Some((at, line, first, words)) = lines.next() else {
                        return Err(ended(last, due));
                    };
                    last = at;
                    if first != due {
                        return Err(wrong(at, due, line));
                    }
                    if due == "vertex" {
                        let numbers: Vec<f64> = words.map_while(|w| w.parse().ok()).collect();
                        let [x, y, z] = *numbers.as_slice() else {
                            return Err(wrong(at, "vertex with three numbers", line));
                        };
                        (corners[n], at_lines[n]) = (Vec3::new(x, y, z), at);
                        n += 1;
                    }
                }
                found.add(corners, Some(at_lines))?;
            }
            (_, true) => return Err(wrong(at, "facet or endsolid", line)),
            (_, false) => return Err(wrong(at, "solid", line)),
        }
    }
    if within { Err(ended(last, "facet or endsolid")) } else { Ok(()) }
}
