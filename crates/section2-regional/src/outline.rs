//! CLDAT and REGION: outlines of parameters recorded along a motion, and what they leave of a line.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_contact::{Side, Tool, gap, on};
use aptc_geometry::sculpt::nearest_on;
use aptc_geometry::{Form, Profile, Sculptured, Surface};
use aptc_protap::{Arg, NameRef};

use crate::failure::Failure;
use crate::regional::Regional;
use crate::scon::Words;

/// A closed outline on a surface.
#[derive(Clone, Debug)]
struct Outline {
    number: f64,
    form: Arc<Form>,
    /// Its corners, u and v.
    corners: Vec<[f64; 2]>,
}

/// The outlines and which of them limit lines.
#[derive(Clone, Debug, Default)]
pub(crate) struct Outlines {
    recorded: Vec<Outline>,
    /// Number, and whether the inside is milled.
    active: Vec<(f64, bool)>,
    /// Number, first record and role of what is being recorded.
    open: Option<(f64, usize, bool)>,
}

impl Regional {
    /// CLDAT/START,n,UVPPS and CLDAT/NOMORE,n: the contacts of the motions between them on their part
    /// surface (UVPDS: drive surface), as its parameters. These motions are recorded only: they are taken out of
    /// `out`, as SSV3 puts none of them out.
    ///
    /// APT: `CLDAT`.
    pub(crate) fn cldat(&mut self, args: &[Arg], out: &mut Vec<cl::Record>) -> Result<(), Failure> {
        let mut w = Words(args);
        if w.take("START") {
            let number = w.number().unwrap_or(0.0);
            let drive = w.take("UVPDS");
            if !drive && !w.take("UVPPS") || !w.0.is_empty() {
                return Err(Failure::Undone { what: "CLDAT of anything but UVPPS or UVPDS" });
            }
            self.outlines.open = Some((number, out.len(), drive));
            return Ok(());
        }
        w.take("NOMORE");
        let number = w.number().unwrap_or(0.0);
        let Some((_, from, drive)) = self.outlines.open.take().filter(|o| same(o.0, number)) else {
            return Err(Failure::Value {
                what: "the number of CLDAT/NOMORE",
                value: number,
                need: "that of the CLDAT/START before it".into(),
            });
        };
        let profile = self.settings.profile.ok_or(Failure::NoCutter)?;
        let mut found: Option<Outline> = None;
        let mut fitted: Option<(Surface, Arc<Sculptured>)> = None;
        let after = out.split_off(from.min(out.len()));
        for record in after {
            let cl::Kind::Motion(m) = &record.kind else {
                out.push(record);
                continue;
            };
            let control = m.control.as_ref();
            let controlled =
                control.and_then(|c| if drive { c.drive.as_ref() } else { c.part.as_ref() });
            let Some(c) = controlled.filter(|c| matches!(c.form.shape(), Form::Ssurf(_))) else {
                continue;
            };
            let outline = found.get_or_insert_with(|| Outline {
                number,
                form: Arc::clone(&c.form),
                corners: Vec::new(),
            });
            if !same_form(&outline.form, &c.form) {
                return Err(Failure::Undone { what: "CLDAT over more than one surface" });
            }
            if fitted.is_none() {
                let named = NameRef { name: c.name.name.clone(), subscript: c.name.subscript };
                let sculptured = self.surface(&named, &c.form)?;
                fitted = Surface::from_form(&c.form).map(|s| (s, sculptured));
            }
            let Some((surface, sculptured)) = &fitted else { continue };
            for p in &m.points {
                outline.corners.extend(contact(&profile, surface, sculptured, c, p));
            }
        }
        let outline = found.filter(|o| o.corners.len() >= 3);
        let outline =
            outline.ok_or(Failure::Undone { what: "CLDAT without a motion along an SSURF" })?;
        self.outlines.recorded.retain(|o| !same(o.number, number));
        self.outlines.recorded.push(outline);
        Ok(())
    }

    /// Are motions being recorded (CLDAT/START), which may be taken out of the output again?
    pub fn is_recording(&self) -> bool {
        self.outlines.open.is_some()
    }

    /// REGION/n,IN|OUT|OFF and REGION/OFF.
    ///
    /// APT: `REGION`.
    pub(crate) fn region(&mut self, args: &[Arg]) -> Result<(), Failure> {
        let mut w = Words(args);
        let Some(number) = w.number() else {
            self.outlines.active.clear();
            return Ok(());
        };
        if !self.outlines.recorded.iter().any(|o| same(o.number, number)) {
            return Err(Failure::Value {
                what: "the number of REGION",
                value: number,
                need: "one that CLDAT recorded before".into(),
            });
        }
        self.outlines.active.retain(|a| !same(a.0, number));
        if !w.take("OFF") {
            self.outlines.active.push((number, w.take("IN")));
        }
        Ok(())
    }
}

fn same(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-6
}

/// Parameters of the place that the cutter touches.
fn contact(
    profile: &Profile,
    surface: &Surface,
    sculptured: &Sculptured,
    c: &cl::Controlled,
    p: &cl::Position,
) -> Option<[f64; 2]> {
    let side = if c.side < 0 { Side::Negative } else { Side::Positive };
    let tool = Tool { profile, te: p.te, ta: p.ta };
    let place =
        if c.side == 0 { on(p.te, surface, side) } else { gap(&tool, surface, side, 0.0).ok()? };
    Some(nearest_on(sculptured, place.surface_point).uv)
}

/// Whether two places name one surface: from a numeric part program each statement has a copy of its own.
pub(crate) fn same_form(a: &Arc<Form>, b: &Arc<Form>) -> bool {
    Arc::ptr_eq(a, b) || a == b
}

impl Outlines {
    /// Are motions recorded only?
    pub(crate) fn is_recording(&self) -> bool {
        self.open.is_some()
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
            let of = |o: &&Outline| same(o.number, *number) && same_form(&o.form, form);
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
    /// Where its sides cross the line, rising; always an even number of them.
    fn crossings(&self, running: usize, fixed: f64) -> Vec<f64> {
        let n = self.corners.len();
        let mut all = Vec::new();
        for (i, a) in self.corners.iter().enumerate() {
            let b = &self.corners[(i + 1) % n];
            let (x, y) = (a[1 - running] - fixed, b[1 - running] - fixed);
            if (x > 0.0) != (y > 0.0) {
                let share = x / (x - y);
                all.push(a[running] + (b[running] - a[running]) * share);
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
        let outline = Outline { number: 1.0, form: Arc::clone(&form), corners };
        let clip = |inside: bool, fixed: f64| {
            let active = vec![(1.0, inside)];
            let all = Outlines { recorded: vec![outline.clone()], active, open: None };
            all.clip(&form, 0, fixed, [0.0, 4.0])
        };
        assert_eq!(clip(true, 2.0), vec![[1.0, 2.0]]);
        assert_eq!(clip(false, 2.0), vec![[0.0, 1.0], [2.0, 4.0]]);
        assert_eq!(clip(true, 5.0), Vec::<[f64; 2]>::new());
        assert_eq!(clip(false, 5.0), vec![[0.0, 4.0]]);
    }
}
