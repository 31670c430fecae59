//! REGION: what the outlines that CLDAT recorded leave of a line.

use std::sync::Arc;

use aptc_geometry::Form;
use aptc_protap::Arg;

use crate::failure::Failure;
use crate::regional::Regional;
use crate::scon::Words;

/// What a section of CLDAT went round on one surface.
#[derive(Clone, Debug)]
pub(crate) struct Outline {
    number: f64,
    form: Option<Arc<Form>>,
    /// Corners, u and v: of all motions and open curves together, then of each closed curve.
    loops: Vec<Vec<[f64; 2]>>,
    /// Does it go over more than one surface?
    scattered: bool,
}

/// The outlines and which of them limit lines.
#[derive(Clone, Debug, Default)]
pub(crate) struct Outlines {
    recorded: Vec<Outline>,
    /// Number, and whether the inside is milled.
    active: Vec<(f64, bool)>,
}

impl Regional {
    /// REGION/n,IN|OUT|OFF and REGION/OFF.
    ///
    /// APT: `REGION`.
    pub(crate) fn region(&mut self, args: &[Arg]) -> Result<(), Failure> {
        let mut w = Words(args);
        let Some(number) = w.number() else {
            self.outlines.active.clear();
            return Ok(());
        };
        let Some(outline) = self.outlines.recorded.iter().find(|o| same(o.number, number)) else {
            return Err(Failure::Value {
                what: "the number of REGION",
                value: number,
                need: "one that CLDAT recorded before with UVPPS or UVPDS".into(),
            });
        };
        if outline.scattered {
            return Err(Failure::Undone { what: "REGION over more than one surface" });
        }
        if !outline.encloses() {
            return Err(Failure::Undone {
                what: "REGION of a section without an outline on an SSURF",
            });
        }
        self.outlines.active.retain(|a| !same(a.0, number));
        if !w.take("OFF") {
            self.outlines.active.push((number, w.take("IN")));
        }
        Ok(())
    }
}

/// Do two numbers of sections mean the same?
pub(crate) fn same(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-6
}

/// Whether two places name one surface: from a numeric part program each statement has a copy of its own.
pub(crate) fn same_form(a: &Arc<Form>, b: &Arc<Form>) -> bool {
    Arc::ptr_eq(a, b) || a == b
}

impl Outlines {
    /// Keeps an outline, in the place of one of the same number.
    pub(crate) fn keep(&mut self, outline: Outline) {
        self.recorded.retain(|o| !same(o.number, outline.number));
        self.recorded.push(outline);
    }

    /// Does REGION limit lines now?
    pub(crate) fn is_active(&self) -> bool {
        !self.active.is_empty()
    }

    /// What the outlines leave of the line on which parameter `running` runs from one end to the other and
    /// the other parameter is `fixed`: stretches, rising.
    pub(crate) fn clip(
        &self,
        form: &Arc<Form>,
        running: usize,
        fixed: f64,
        ends: [f64; 2],
    ) -> Vec<[f64; 2]> {
        let mut left = vec![ends];
        for (number, inside) in &self.active {
            let on_it = |o: &Outline| o.form.as_ref().is_some_and(|f| same_form(f, form));
            let of = |o: &&Outline| same(o.number, *number) && on_it(o);
            let Some(outline) = self.recorded.iter().find(of) else { continue };
            let cuts = outline.crossings(running, fixed);
            let within: Vec<[f64; 2]> = cuts.chunks_exact(2).map(|c| [c[0], c[1]]).collect();
            let kept = if *inside { within } else { between(&within) };
            left = left
                .iter()
                .flat_map(|a| kept.iter().map(|b| [a[0].max(b[0]), a[1].min(b[1])]))
                .filter(|s| s[1] - s[0] > 1e-9)
                .collect();
        }
        left
    }
}

/// The stretches between others.
fn between(within: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut from = f64::NEG_INFINITY;
    let mut all = Vec::with_capacity(within.len() + 1);
    for s in within {
        all.push([from, s[0]]);
        from = s[1];
    }
    all.push([from, f64::INFINITY]);
    all
}

impl Outline {
    /// Nothing yet, of the section `number`.
    pub(crate) fn new(number: f64) -> Self {
        Self { number, form: None, loops: vec![Vec::new()], scattered: false }
    }

    /// Corners on the surface `form`; a closed curve goes round something of its own.
    pub(crate) fn add(
        &mut self,
        form: Option<&Arc<Form>>,
        corners: impl Iterator<Item = [f64; 2]>,
        closed: bool,
    ) {
        let Some(form) = form else {
            self.scattered = true;
            return;
        };
        let known = self.form.get_or_insert_with(|| Arc::clone(form));
        self.scattered |= !same_form(known, form);
        if closed {
            self.loops.push(corners.collect());
        } else {
            self.loops[0].extend(corners);
        }
    }

    fn encloses(&self) -> bool {
        self.loops.iter().any(|l| l.len() >= 3)
    }

    /// Where its sides cross the line, rising; always an even number of them.
    fn crossings(&self, running: usize, fixed: f64) -> Vec<f64> {
        let mut all = Vec::new();
        for corners in &self.loops {
            for (i, a) in corners.iter().enumerate() {
                let b = &corners[(i + 1) % corners.len()];
                let (x, y) = (a[1 - running] - fixed, b[1 - running] - fixed);
                if (x > 0.0) != (y > 0.0) {
                    let share = x / (x - y);
                    all.push(a[running] + (b[running] - a[running]) * share);
                }
            }
        }
        all.sort_by(f64::total_cmp);
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_is_cut_in_and_out() {
        let form = Arc::new(Form::Point(aptc_geometry::Vec3::zeros()));
        let corners = vec![[1.0, 1.0], [2.0, 1.0], [2.0, 3.0], [1.0, 3.0]];
        let mut outline = Outline::new(1.0);
        outline.add(Some(&form), corners.into_iter(), true);
        let clip = |inside: bool, fixed: f64| {
            let active = vec![(1.0, inside)];
            let all = Outlines { recorded: vec![outline.clone()], active };
            all.clip(&form, 0, fixed, [0.0, 4.0])
        };
        assert_eq!(clip(true, 2.0), vec![[1.0, 2.0]]);
        assert_eq!(clip(false, 2.0), vec![[0.0, 1.0], [2.0, 4.0]]);
        assert_eq!(clip(true, 5.0), Vec::<[f64; 2]>::new());
        assert_eq!(clip(false, 5.0), vec![[0.0, 4.0]]);
    }
}
