//! The ways that can hold a piece, fewer as the piece gets smaller.

use crate::swath::{Piece, Swath};

/// What is known of a piece at the nearest way found.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Best {
    pub(crate) way: usize,
    /// Distance of the middle, never less than it is.
    pub(crate) distance: f64,
    /// How much farther the ends are by parameter; infinite where that was not asked for.
    pub(crate) ends: [f64; 2],
    /// Is all of the piece within the way's tool?
    pub(crate) held: bool,
}

/// Numbers of ways in lists that stand one on the other: that of a piece begins where that of the piece it is
/// part of ends.
#[derive(Debug)]
pub(crate) struct Passes<'a> {
    swath: &'a Swath,
    /// What covers rounding.
    pad: f64,
    /// With the bound of the middle of the piece that the list was made for.
    numbers: Vec<(usize, f64)>,
}

/// Where the list of a piece stands.
#[derive(Clone, Copy, Debug)]
pub(crate) struct List {
    from: usize,
    to: usize,
}

impl<'a> Passes<'a> {
    pub(crate) fn new(swath: &'a Swath, pad: f64) -> Self {
        Self { swath, pad, numbers: Vec::new() }
    }

    /// What is known at one way.
    pub(crate) fn look(&self, way: usize, piece: &Piece) -> Best {
        let (distance, _) = self.swath.distance(way, piece.x, self.pad);
        let mut best = Best { way, distance, ends: [f64::INFINITY; 2], held: false };
        if distance <= self.pad {
            let hold = self.swath.hold(way, piece, self.pad - piece.slop);
            best.ends = hold.ends.map(|e| e - distance);
            best.held = hold.most + piece.slop <= self.pad;
        }
        best
    }

    /// The ways that can hold a place of a piece, of those in the list of what it is part of; of all where that has
    /// none. Lists made since then are gone.
    pub(crate) fn near(&mut self, piece: &Piece, of: Option<List>) -> List {
        let Self { swath, pad, numbers } = self;
        numbers.truncate(of.map_or(0, |l| l.to));
        let from = numbers.len();
        let take = |numbers: &mut Vec<_>, way: usize| {
            numbers.extend(swath.bound(way, piece, *pad).map(|middle| (way, middle)));
        };
        match of {
            Some(list) => {
                for k in list.from..list.to {
                    take(numbers, numbers[k].0);
                }
            }
            None => swath.around(piece.x, *pad + piece.radius() + piece.slop, |way| {
                take(numbers, way);
                false
            }),
        }
        List { from, to: numbers.len() }
    }

    /// Makes `best` the nearest of a list made for the piece, or one that holds all of it.
    pub(crate) fn nearest(&mut self, piece: &Piece, list: List, best: &mut Best) {
        let numbers = &mut self.numbers[list.from..list.to];
        numbers.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
        for k in list.from..list.to {
            let (way, bound) = self.numbers[k];
            if bound > best.distance || best.held {
                break;
            }
            let now = self.look(way, piece);
            if now.distance < best.distance || now.held {
                *best = now;
            }
        }
    }
}
