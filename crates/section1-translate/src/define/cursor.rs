//! Reading the lists of sculptured definitions one argument after the other.

use std::sync::Arc;

use aptc_geometry::sculptured::{CurveDefinition, Extent, Knot, Smoothing, SurfaceDefinition};
use aptc_geometry::{Form, Transform, Vec3};
use aptc_vocabulary::{Word, word};

use super::Arg;
use super::fault::Fault;
use super::format::Args;

/// A place among the arguments of a definition.
pub(super) struct Cursor<'a, 'b> {
    pub(super) args: &'a Args<'b>,
    pub(super) at: usize,
}

impl<'a, 'b> Cursor<'a, 'b> {
    /// Before argument `at`.
    pub(super) fn new(args: &'a Args<'b>, at: usize) -> Self {
        Self { args, at }
    }

    /// Are all read?
    pub(super) fn is_empty(&self) -> bool {
        self.at >= self.args.len()
    }

    /// The word here, if it is one.
    pub(super) fn peek(&self) -> Option<Word> {
        self.args.list.get(self.at).and_then(Arg::word)
    }

    /// Takes the word here when it is among `words`.
    pub(super) fn take(&mut self, words: &[Word]) -> Option<Word> {
        let word = self.peek().filter(|w| words.contains(w))?;
        self.at += 1;
        Some(word)
    }

    /// The fault that something else is expected here.
    pub(super) fn unexpected<T>(&self, expected: &'static str) -> Result<T, Fault> {
        Err(Fault::Unexpected { at: self.at, expected })
    }

    /// Takes the number here.
    pub(super) fn number(&mut self, expected: &'static str) -> Result<f64, Fault> {
        let Ok(n) = self.args.number(self.at) else { return self.unexpected(expected) };
        self.at += 1;
        Ok(n)
    }

    /// Takes the point here, if there is one.
    pub(super) fn point(&mut self) -> Option<Vec3> {
        let p = self.args.point(self.at).ok()?;
        self.at += 1;
        Some(p)
    }

    /// Takes the vector here, if there is one.
    pub(super) fn vector(&mut self) -> Option<Vec3> {
        let Ok(Form::Vector(v)) = self.args.form(self.at) else { return None };
        self.at += 1;
        Some(*v)
    }

    /// Takes the SCURV here, if there is one.
    pub(super) fn curve(&mut self) -> Option<Arc<CurveDefinition>> {
        let Ok(Form::Scurv(c)) = self.args.form(self.at) else { return None };
        self.at += 1;
        Some(Arc::clone(c))
    }

    /// Takes the SSURF here, if there is one.
    pub(super) fn surface(&mut self) -> Option<Arc<SurfaceDefinition>> {
        let Ok(Form::Ssurf(s)) = self.args.form(self.at) else { return None };
        self.at += 1;
        Some(Arc::clone(s))
    }

    /// Takes `TRFORM,matrix` when it is there.
    pub(super) fn map(&mut self) -> Result<Option<Transform>, Fault> {
        if self.take(&[word::TRFORM]).is_none() {
            return Ok(None);
        }
        let Ok(m) = self.args.matrix(self.at) else { return self.unexpected("a matrix") };
        self.at += 1;
        Ok(Some(m))
    }

    /// That all is read.
    pub(super) fn end(&self, expected: &'static str) -> Result<(), Fault> {
        if self.is_empty() { Ok(()) } else { self.unexpected(expected) }
    }

    /// Takes WEIGHT and LIMIT with their numbers.
    pub(super) fn smoothing(&mut self, into: &mut Smoothing) -> Result<(), Fault> {
        while let Some(word) = self.take(&[word::WEIGHT, word::LIMIT]) {
            let n = self.number("a number")?;
            if n < 0.0 {
                return Err(Fault::Range { at: self.at - 1, value: n, need: "of 0 or more" });
            }
            *(if word == word::WEIGHT { &mut into.weight } else { &mut into.limit }) = Some(n);
        }
        Ok(())
    }

    /// Takes points with their vectors, weights and limits; each with its place. `smooth` tells whether
    /// WEIGHT and LIMIT may stand here.
    pub(super) fn knots(&mut self, smooth: bool) -> Result<Vec<(usize, Knot)>, Fault> {
        let mut knots: Vec<(usize, Knot)> = Vec::new();
        loop {
            let place = self.at;
            if let Some(point) = self.point() {
                if knots.len() >= self.args.context.max_points {
                    let limit = self.args.context.max_points;
                    return Err(Fault::TooMany { at: place, limit });
                }
                knots.push((place, Knot { point, ..Knot::default() }));
                continue;
            }
            let Some((_, knot)) = knots.last_mut() else { return Ok(knots) };
            let sides = [word::TANSPL, word::CRSSPL, word::NORMAL];
            if let Some(word) = self.take(&sides) {
                let place = self.at;
                let Some(v) = self.vector() else { return self.unexpected("a vector") };
                if v == Vec3::zeros() {
                    return Err(Fault::NoLength { at: place });
                }
                let slot = match word {
                    word::TANSPL => &mut knot.tangent,
                    word::CRSSPL => &mut knot.cross,
                    _ => &mut knot.normal,
                };
                if slot.replace(v).is_some() {
                    return Err(Fault::Unexpected { at: place - 1, expected: "the next point" });
                }
            } else if smooth && matches!(self.peek(), Some(word::WEIGHT | word::LIMIT)) {
                self.smoothing(&mut knot.smoothing)?;
            } else {
                return Ok(knots);
            }
        }
    }
}

/// Refuses neighbouring points that fall together, unless they are all that there is: then they make a
/// curve of no length on purpose, as three-sided patches need one.
pub(super) fn apart(knots: &[(usize, Knot)]) -> Result<(), Fault> {
    if knots.len() == 2 {
        return Ok(());
    }
    let size = knots.iter().fold(0.0_f64, |m, (_, k)| m.max(k.point.amax()));
    for pair in knots.windows(2) {
        if (pair[1].1.point - pair[0].1.point).norm() <= 1e-12 * size {
            return Err(Fault::Coincide { a: pair[0].0, b: pair[1].0 });
        }
    }
    Ok(())
}

/// Definitions within each other, in a curve, surface or solid.
const DEPTH: usize = 64;

/// Refuses what holds too much or is nested too deep: definitions are held by value.
pub(super) fn bounded(extent: Extent, limit: usize) -> Result<(), Fault> {
    if extent.points > limit {
        return Err(Fault::TooMany { at: 0, limit });
    }
    if extent.depth > DEPTH {
        return Err(Fault::TooDeep { limit: DEPTH });
    }
    Ok(())
}

/// The knots without their places.
pub(super) fn plain(knots: Vec<(usize, Knot)>) -> Vec<Knot> {
    knots.into_iter().map(|(_, k)| k).collect()
}
