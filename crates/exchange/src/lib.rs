//! Surfaces that other programs made, read from the text of a file: JSON, IGES, STEP and STL.
//!
//! What a file is shows in its text. Every loop, size and depth is bounded by the length of the text or by
//! [`Limits`]; what cannot be had of a file is named, never left out in silence.
//!
//! ```
//! let text = r#"{"surfaces": [{"degree": [1, 1], "knots": [[0, 0, 1, 1], [0, 0, 1, 1]],
//!     "points": [[[0, 0, 0], [10, 0, 0]], [[0, 10, 0], [10, 10, 5]]]}]}"#;
//! let file = aptc_exchange::read(text, &aptc_exchange::Limits::default()).expect("JSON");
//! assert_eq!(file.expect("a surface").surfaces.len(), 1);
//! ```

mod border;
mod curve;
mod follow;
mod iges;
mod instances;
mod json;
mod step;
mod stl;

use std::fmt;

use aptc_geometry::sculptured::{BsplineSurface, SurfaceDefinition, SurfaceShape};
use aptc_geometry::{Transform, sculpt};

/// Bounds on what is read.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Control points or corners of triangles of all surfaces together.
    pub points: usize,
    /// Surfaces.
    pub surfaces: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self { points: 5_000_000, surfaces: 10_000 }
    }
}

/// The surfaces of a file.
#[derive(Clone, Debug, Default)]
pub struct Outside {
    /// In the order of the file.
    pub surfaces: Vec<SurfaceDefinition>,
    /// Length of the file's unit in millimetres; `None` when it does not say, and then it is the program's.
    pub unit_mm: Option<f64>,
    /// What the user should know: entities that were not read, borders that are not regarded, degrees that
    /// were reduced.
    pub notes: Vec<String>,
}

/// Why a file gives no surfaces.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The file is broken: what, and at which line where that is known.
    Broken {
        /// What is wrong.
        what: String,
        /// Line, from 1.
        line: Option<usize>,
    },
    /// It is sound and holds what cannot be used; the name of it.
    Unsupported(String),
    /// It holds no surface; what it holds instead.
    NoSurface(String),
    /// A bound is exceeded.
    TooLarge(String),
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Broken { what, line: Some(line) } => write!(f, "line {line}: {what}"),
            Self::Broken { what, line: None } | Self::Unsupported(what) | Self::TooLarge(what) => {
                f.write_str(what)
            }
            Self::NoSurface(held) if held.is_empty() => f.write_str("it holds no surface"),
            Self::NoSurface(held) => write!(f, "it holds no surface that can be read, but {held}"),
        }
    }
}

/// The surfaces of a file of one of the formats; `None` when it is of none of them.
///
/// Bytes that are no UTF-8 may stand in the text as Latin-1, so that binary STL comes through.
pub fn read(text: &str, limits: &Limits) -> Option<Result<Outside, Fault>> {
    let start = text.trim_start_matches('\u{feff}').trim_start();
    let read = if start.starts_with('{') {
        json::read(text, limits)
    } else if start.starts_with("ISO-10303-21") {
        step::read(text, limits)
    } else if iges::is(text) {
        iges::read(text, limits)
    } else if stl::is(text) {
        stl::read(text, limits)
    } else {
        return None;
    };
    Some(read.and_then(|file| if file.surfaces.is_empty() { Err(none()) } else { Ok(file) }))
}

/// The surfaces of a file that is called `name`: what its text is tells which format it has, and its ending where the text is of
/// none, so that the file is broken. `None` of a name with another ending.
pub fn read_named(name: &str, text: &str, limits: &Limits) -> Option<Result<Outside, Fault>> {
    let own = || {
        let (_, ending) = name.rsplit_once('.')?;
        Some(match ending.to_ascii_lowercase().as_str() {
            "json" => json::read(text, limits),
            "igs" | "iges" => iges::read(text, limits),
            "stp" | "step" => step::read(text, limits),
            "stl" => stl::read(text, limits),
            _ => return None,
        })
    };
    read(text, limits).or_else(own)
}

fn none() -> Fault {
    Fault::NoSurface(String::new())
}

fn broken(what: impl Into<String>) -> Fault {
    Fault::Broken { what: what.into(), line: None }
}

/// Collects the surfaces of a file within the limits.
struct Collected<'l> {
    file: Outside,
    points: usize,
    /// The points of each surface.
    sizes: Vec<usize>,
    /// Surfaces that cubic patches follow, with their degrees and how near.
    followed: Vec<(String, [usize; 2], f64)>,
    limits: &'l Limits,
}

impl<'l> Collected<'l> {
    fn new(limits: &'l Limits) -> Self {
        Self {
            file: Outside::default(),
            points: 0,
            sizes: Vec::new(),
            followed: Vec::new(),
            limits,
        }
    }

    /// A B-spline surface that the file calls `name`; it is fitted once to see that it is one.
    fn bspline(
        &mut self,
        name: &str,
        surface: BsplineSurface,
        map: Option<Transform>,
    ) -> Result<(), Fault> {
        let points = surface.points.len();
        let (fitted, off) = sculpt::bspline(&surface)
            .map_err(|why| broken(format!("{name} is no surface: {why}")))?;
        if !fitted.has_area() {
            return Err(broken(format!("{name} has no area: its control points lie on one line")));
        }
        if off > 0.0 {
            self.followed.push((name.to_owned(), surface.degree, off));
        }
        self.push(SurfaceShape::Bspline(Box::new(surface)), points, map)
    }

    /// The file, with what is left to tell.
    fn done(mut self) -> Outside {
        let names: Vec<&str> = self.followed.iter().map(|f| f.0.as_str()).collect();
        let off = self.followed.iter().fold(0.0_f64, |m, f| m.max(f.2));
        match &self.followed[..] {
            [] => {}
            [(name, [p, q], _)] => self.file.notes.push(format!(
                "{name} is of degree {p} by {q}; cubic patches follow it within {off:.1e}"
            )),
            _ => self.file.notes.push(format!(
                "surfaces of a degree above three, which cubic patches follow within {off:.1e}: {}",
                named("", &names)
            )),
        }
        self.file
    }

    fn push(
        &mut self,
        shape: SurfaceShape,
        points: usize,
        map: Option<Transform>,
    ) -> Result<(), Fault> {
        self.points = self.points.saturating_add(points);
        if self.points > self.limits.points {
            return Err(Fault::TooLarge(format!("more than {} points", self.limits.points)));
        }
        if self.file.surfaces.len() >= self.limits.surfaces {
            return Err(Fault::TooLarge(format!("more than {} surfaces", self.limits.surfaces)));
        }
        self.file.surfaces.push(SurfaceDefinition { shape, map });
        self.sizes.push(points);
        Ok(())
    }
}

/// Numbers in a message, the first of them, with what stands before each.
fn named<T: fmt::Display>(mark: &str, all: &[T]) -> String {
    const MOST: usize = 12;
    let first: Vec<String> = all.iter().take(MOST).map(|id| format!("{mark}{id}")).collect();
    let more = all.len().saturating_sub(MOST);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    first.join(", ") + &more
}
