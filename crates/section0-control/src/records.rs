//! The records of a part program between two Sections: the first in memory, the rest in a temporary file.

use std::fmt;
use std::io;
use std::sync::{Mutex, PoisonError};

use aptc_cldata::{Block, Kind, Record, RecordWriter, Spool};

use crate::cl_edit::spool;

/// Positions and other records that stay in memory, about 10 MB.
const IN_MEMORY: usize = 40_000;

/// CL data of a part program, which can be read again and again.
#[derive(Default)]
pub struct Records {
    memory: Vec<Record>,
    /// Records and positions in memory.
    size: usize,
    /// What did not fit; reading it moves the place in the file.
    rest: Option<Mutex<Spool>>,
    /// Records in `rest`.
    n_rest: u64,
    n_positions: u64,
}

impl Records {
    /// How many there are.
    pub fn len(&self) -> u64 {
        self.memory.len() as u64 + self.n_rest
    }

    /// Positions of all motions.
    pub(crate) fn positions(&self) -> u64 {
        self.n_positions
    }

    /// Are there none?
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Hands each record to `take`, in order.
    ///
    /// # Errors
    /// What the temporary file gives.
    pub fn for_each(&self, mut take: impl FnMut(&Record)) -> io::Result<()> {
        self.try_for_each(|record| {
            take(record);
            Ok(())
        })
    }

    /// Hands each record to `take`, in order, until that fails.
    ///
    /// # Errors
    /// What the temporary file and `take` give.
    pub fn try_for_each(&self, mut take: impl FnMut(&Record) -> io::Result<()>) -> io::Result<()> {
        for record in &self.memory {
            take(record)?;
        }
        let Some(rest) = &self.rest else { return Ok(()) };
        let mut spool = rest.lock().unwrap_or_else(PoisonError::into_inner);
        let (mut at, end) = (0, spool.end());
        let (mut record, mut block) = (Record::default(), Block::default());
        while at < end {
            at = spool.get(at, &mut record, &mut block)?;
            take(&record)?;
        }
        Ok(())
    }

    /// All of them in memory.
    ///
    /// # Errors
    /// What the temporary file gives.
    pub fn to_vec(&self) -> io::Result<Vec<Record>> {
        let mut all = Vec::new();
        self.for_each(|record| all.push(record.clone()))?;
        Ok(all)
    }

    /// Appends a record.
    pub(crate) fn push(&mut self, record: Record) -> io::Result<()> {
        let n = if let Kind::Motion(m) = &record.kind { m.points.len() } else { 0 };
        self.n_positions += n as u64;
        if self.size < IN_MEMORY {
            self.size += 1 + n;
            self.memory.push(record);
            return Ok(());
        }
        let rest = self.rest.get_or_insert_with(|| Mutex::new(spool()));
        rest.get_mut().unwrap_or_else(PoisonError::into_inner).put(&record)?;
        self.n_rest += 1;
        Ok(())
    }
}

impl RecordWriter for Records {
    fn write(&mut self, record: &Record) -> io::Result<()> {
        self.push(record.clone())
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl fmt::Debug for Records {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Records({})", self.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use aptc_cldata::{Motion, Position};
    use aptc_geometry::Vec3;

    #[test]
    fn what_does_not_fit_into_memory_comes_back_in_order() {
        let mut records = Records::default();
        let n = u32::try_from(IN_MEMORY).unwrap();
        for i in 0..n {
            let points = vec![Position::upright(Vec3::new(f64::from(i), 0.1, -2.0))];
            let kind = Kind::Motion(Motion { points, ..Motion::default() });
            let mut record = Record { kind, ..Record::default() };
            record.origin.line = i;
            records.push(record).unwrap();
        }
        records.push(Record::default()).unwrap();
        assert!(records.n_rest > 1000 && records.memory.len() < 30_000);
        for _ in 0..2 {
            let mut next = 0;
            let done = records.for_each(|r| {
                match &r.kind {
                    Kind::Motion(m) => {
                        assert_eq!(m.points[0].te.x.to_bits(), f64::from(next).to_bits());
                    }
                    other => assert_eq!((other, next), (&Kind::Fini, n)),
                }
                assert!(next == n || r.origin.line == next);
                next += 1;
            });
            done.unwrap();
            assert_eq!(next, n + 1);
        }
    }
}
