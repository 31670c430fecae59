//! Cells by their places among the parameters: they stand in columns and rows.

use super::Cell;

/// No cell.
const NONE: u32 = u32::MAX;
/// Parameters that differ by less are one.
const ONE: f64 = 1e-12;

/// The columns and rows of cells.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    /// Where they begin and end.
    ends: [Vec<f64>; 2],
    /// Of each place the number of its cell, row by row.
    at: Vec<u32>,
}

impl Grid {
    /// That of all cells of a surface.
    pub(super) fn new(cells: &[Cell]) -> Self {
        let ends = [0, 1].map(|k| {
            let both = |c: &Cell| [c.mid[k] - c.half[k], c.mid[k] + c.half[k]];
            let mut all: Vec<f64> = cells.iter().flat_map(both).collect();
            all.sort_by(f64::total_cmp);
            all.dedup_by(|a, b| *a - *b < ONE);
            all
        });
        let count = ends.each_ref().map(|e| e.len().saturating_sub(1));
        let mut new = Self { ends, at: vec![NONE; count[0] * count[1]] };
        for (number, cell) in (0..).zip(cells) {
            let [column, row] = new.place(cell.mid);
            new.at[row * count[0] + column] = number;
        }
        new
    }

    /// Columns and rows.
    pub(super) fn count(&self) -> [usize; 2] {
        let [u, v] = &self.ends;
        [u.len().saturating_sub(1), v.len().saturating_sub(1)]
    }

    /// Column and row that hold these parameters, or the nearest ones.
    pub(super) fn place(&self, uv: [f64; 2]) -> [usize; 2] {
        let count = self.count();
        [0, 1].map(|k| {
            let after = self.ends[k].partition_point(|x| *x <= uv[k]);
            after.saturating_sub(1).min(count[k].saturating_sub(1))
        })
    }

    /// The number of the cell in that column and row.
    #[inline]
    pub(super) fn number(&self, [column, row]: [usize; 2]) -> Option<usize> {
        let columns = self.ends[0].len().saturating_sub(1);
        let number = *self.at.get(row * columns + column)?;
        (number != NONE).then_some(number as usize)
    }
}
