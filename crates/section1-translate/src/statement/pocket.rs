//! POCKET: clearing a convex area.

use aptc_diagnostics::{Diagnostic, codes};
use aptc_protap::{Kind, Pocket};
use aptc_syntax::tree::Clause;
use aptc_vocabulary::word;

use super::reader::Reader;
use crate::Interpreter;
use crate::eval::{Known, Names, Poisoned};

/// Fewest and most vertices.
const VERTICES: std::ops::RangeInclusive<usize> = 3..=20;

impl Interpreter<'_> {
    /// POCKET/re,c,f,f1,f2,f3,o,p,P1,..
    pub(super) fn pocket(&mut self, clause: &Clause) -> Known<()> {
        let args = self.args(clause, Names::Defined)?;
        let mut reader = Reader::new(word::POCKET, clause, &args);
        let names = [
            "the effective radius",
            "the cut of the general passes",
            "the cut of the finish pass",
            "the feed rate of the plunge",
            "the feed rate of the general passes",
            "the feed rate of the finish pass",
            "the flag of the offset, 0 or 1,",
            "the kind of the points, 0 to 3,",
        ];
        let mut values = [0.0; 8];
        for (value, name) in values.iter_mut().zip(names) {
            match reader.number() {
                Some(n) => *value = n,
                None => return Err(self.expect(&reader, name)),
            }
        }
        let [radius, cut, finish, f1, f2, f3, offset, kind] = values;
        let flags = self.flags(&reader, offset, kind)?;
        // A finish cut of 0 goes along the last general pass once more.
        let fits = [radius > 0.0, cut > 0.0, finish >= 0.0];
        for ((value, name), fits) in values.iter().zip(names).zip(fits) {
            if !fits {
                self.error(Diagnostic::error(
                    codes::BAD_POCKET,
                    clause.span,
                    format!("{name} is {value} and should be positive"),
                ));
                return Err(Poisoned);
            }
        }
        let mut vertices = Vec::new();
        while !reader.is_empty() {
            match reader.point().map(|(p, _)| p).or_else(|| reader.triple()) {
                Some(point) => vertices.push(point),
                None => return Err(self.expect(&reader, "a point")),
            }
        }
        if !VERTICES.contains(&vertices.len()) {
            self.error(
                Diagnostic::error(
                    codes::BAD_POCKET,
                    clause.span,
                    format!("a pocket of {} points", vertices.len()),
                )
                .help("a pocket has 3 to 20 vertices"),
            );
            return Err(Poisoned);
        }
        self.emit(Kind::Pocket(Pocket {
            radius,
            cut,
            finish,
            feeds: [f1, f2, f3],
            flags,
            vertices,
        }));
        Ok(())
    }

    fn flags(&mut self, reader: &Reader<'_>, offset: f64, kind: f64) -> Known<[i32; 2]> {
        #[expect(clippy::float_cmp, reason = "the whole numbers themselves")]
        let whole = |n: f64, most: i32| (0..=most).find(|i| f64::from(*i) == n);
        match (whole(offset, 1), whole(kind, 3)) {
            (Some(offset), Some(kind)) => Ok([offset, kind]),
            _ => {
                self.error(
                    Diagnostic::error(
                        codes::BAD_POCKET,
                        reader.before(),
                        format!("{offset} and {kind} are no flags of a pocket"),
                    )
                    .help("the seventh number is 0 or 1, the eighth 0 to 3"),
                );
                Err(Poisoned)
            }
        }
    }
}
