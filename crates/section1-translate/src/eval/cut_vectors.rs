//! Saved cut vectors: POINT/CLDATA, VECTOR/CLDATA, CLDATF and NUMF(CLDATA), and what INTSEC with CANON prints.
//!
//! APT: `CLDATF`, `NUMF`. Source: APT4 SSV3.

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_geometry::{Form, Vec3};
use aptc_protap::{CutContact, CutPoint, CutVectors};
use aptc_syntax::tree::{Expr, ExprKind, Name};
use aptc_vocabulary::{Word, word};

use super::{Known, Poisoned};
use crate::Interpreter;
use crate::define;
use crate::listing::EntryKind;

impl Interpreter<'_> {
    /// Takes in cut vectors that a section of CLDAT recorded, or the path of the last motion.
    pub fn saved(&mut self, mut saved: CutVectors) {
        if saved.canon {
            for (k, p) in saved.points.iter().enumerate() {
                let patch = p.part.and_then(|c| c.patch).map_or(0, |(n, _)| n);
                let [x, y, z] = [p.te.x, p.te.y, p.te.z].map(|x| x + 0.0);
                let line = format!("PT{patch:04}({})=POINT/{x:.6},{y:.6},{z:.6}", k + 1);
                self.list(EntryKind::Remark(line));
            }
        }
        // Kept in the base system, as forms are; motion within REFSYS is in that of the matrix.
        if let Some(m) = &self.state.refsys {
            for p in &mut saved.points {
                (p.te, p.ta) = (m.point(p.te), m.vector(p.ta));
                p.along = p.along.map(|v| m.vector(v));
                for contact in [&mut p.part, &mut p.drive].into_iter().flatten() {
                    contact.point = m.point(contact.point);
                    contact.normal = m.vector(contact.normal);
                }
            }
        }
        let known = &mut self.state.cut_vectors;
        let same = |c: &CutVectors| c.section == saved.section;
        // One that was recorded before stays where another of its number is refused.
        if saved.refused && known.iter().any(same) {
            return;
        }
        known.retain(|c| c.section != saved.section);
        known.push(saved);
    }

    /// Does the program ask for the path of its last motion?
    pub fn asks_for_paths(&self) -> bool {
        self.asks_for_paths
    }

    /// `POINT/CLDATA,k`, `POINT/CLDATA,n,TP|PDS|PPS,k`, `VECTOR/CLDATA,k` (the tool axis) and
    /// `VECTOR/CLDATA,n,TA|TV|NDS|NPS,k`: of the path of the last motion, and of the section n of CLDAT.
    pub(super) fn saved_form(
        &mut self,
        head: Word,
        args: &[define::Arg],
        span: Span,
    ) -> Known<Form> {
        let number = |i: usize| match args.get(i).map(|a| &a.value) {
            Some(define::Value::Number(x)) => Some(*x),
            _ => None,
        };
        let at = |i: usize| args.get(i).map_or(span, |a| a.span);
        let what = match args.get(2).map(|a| &a.value) {
            Some(define::Value::Word(w)) => Some(*w),
            _ => None,
        };
        let vector = head == word::VECTOR;
        let items: &[Word] = if vector {
            &[word::TA, word::TV, word::NDS, word::NPS]
        } else {
            &[word::TP, word::PDS, word::PPS]
        };
        let found = match (args.len(), number(1), what, number(3)) {
            (2, Some(k), None, None) => {
                let item = if vector { word::TA } else { word::TP };
                self.item(None, item, k, at(1))?
            }
            (4, Some(n), Some(item), Some(k)) if items.contains(&item) => {
                self.item(Some((n, at(1))), item, k, at(3))?
            }
            _ => {
                let items = items.iter().map(|w| w.text()).collect::<Vec<_>>().join("|");
                self.error(
                    Diagnostic::error(
                        codes::BAD_ARGUMENTS,
                        span,
                        format!("these are no arguments of {head}/CLDATA"),
                    )
                    .note(format!("the format is {head}/CLDATA,number"))
                    .note(format!("the format is {head}/CLDATA,number,{items},number")),
                );
                return Err(Poisoned);
            }
        };
        Ok(if vector { Form::Vector(found) } else { Form::Point(found) })
    }

    /// `NUMF(CLDATA)` and `NUMF(CLDATA,n)`; `None` when the first argument is something else.
    pub(super) fn count_of_saved(&mut self, args: &[Expr]) -> Option<Known<f64>> {
        let ExprKind::Name(Name { word: Some(word::CLDATA), .. }) = args[0].kind else {
            return None;
        };
        let section = match args.get(1) {
            Some(expr) => match self.number(expr) {
                Ok(n) => Some((n, expr.span)),
                Err(poisoned) => return Some(Err(poisoned)),
            },
            None => None,
        };
        #[expect(clippy::cast_precision_loss, reason = "a count of points")]
        let count = self.section(section, args[0].span).map(|c| c.points.len() as f64);
        Some(count)
    }

    /// `CLDATF(n,UPS|VPS|PPS|UDS|VDS|PDS,k)`: a parameter of the place that cut vector k of section n touches,
    /// or the number of its patch.
    pub(super) fn saved_parameter(&mut self, args: &[Expr]) -> Known<f64> {
        let (n, k) = (self.number(&args[0]), self.number(&args[2]));
        let what = match &args[1].kind {
            ExprKind::Name(name) => self.interner.text(name.symbol).to_owned(),
            _ => String::new(),
        };
        let (which, drive) = match what.as_str() {
            "UPS" => (0, false),
            "VPS" => (1, false),
            "PPS" => (2, false),
            "UDS" => (0, true),
            "VDS" => (1, true),
            "PDS" => (2, true),
            _ => {
                let message = "CLDATF gives UPS, VPS or PPS of the part surface, and UDS, VDS or PDS of the drive surface";
                self.error(Diagnostic::error(codes::NO_VALUE, args[1].span, message));
                return Err(Poisoned);
            }
        };
        let (n, k) = (n?, k?);
        let asked = if drive { word::UVPDS } else { word::UVPPS };
        let point = self.kept(Some((n, args[0].span)), asked, k, args[2].span)?;
        let contact = if drive { point.drive } else { point.part };
        let Some((patch, uv)) = contact.and_then(|c| c.patch) else {
            return Err(self.no_place(k, drive, "sculptured ", args[2].span));
        };
        Ok(if which == 2 { f64::from(patch) } else { uv[which] })
    }

    /// A point or vector of a cut vector.
    fn item(
        &mut self,
        section: Option<(f64, Span)>,
        item: Word,
        k: f64,
        span: Span,
    ) -> Known<Vec3> {
        let p = self.kept(section, item, k, span)?;
        let of = |c: Option<CutContact>, normal: bool| {
            c.map(|c| if normal { c.normal } else { c.point })
        };
        let found = match item {
            word::TP => Some(p.te),
            word::TA => Some(p.ta),
            word::TV => p.along,
            word::PDS | word::NDS => of(p.drive, item == word::NDS),
            _ => of(p.part, item == word::NPS),
        };
        if let Some(found) = found {
            return Ok(found);
        }
        if item == word::TV {
            let message = format!("cut vector {k} has no direction: no motion came before it");
            self.error(Diagnostic::error(codes::NO_VALUE, span, message));
            return Err(Poisoned);
        }
        Err(self.no_place(k, matches!(item, word::PDS | word::NDS), "", span))
    }

    fn no_place(&mut self, k: f64, drive: bool, kind: &str, span: Span) -> Poisoned {
        let side = if drive { "drive" } else { "part" };
        let message = format!("cut vector {k} has no place on a {kind}{side} surface");
        self.error(
            Diagnostic::error(codes::NO_VALUE, span, message)
                .help("motions along surfaces and INTSEC have such places, GOTO has none"),
        );
        Poisoned
    }

    /// The cut vector k, of which `item` was kept.
    fn kept(
        &mut self,
        section: Option<(f64, Span)>,
        item: Word,
        k: f64,
        span: Span,
    ) -> Known<CutPoint> {
        let saved = self.section(section, span)?;
        let always = section.is_none() || matches!(item, word::TP | word::TA | word::TV);
        let keeps = always || saved.kept.iter().any(|w| **w == *item.text());
        let n = saved.points.len();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "saturates, and is looked up"
        )]
        let point = (k >= 1.0).then(|| saved.points.get((k + 1e-6) as usize - 1).copied());
        if !keeps {
            let number = section.map_or(0.0, |s| s.0);
            self.error(
                Diagnostic::error(
                    codes::NO_VALUE,
                    span,
                    format!("the section {number} of CLDAT did not keep {item}"),
                )
                .help(format!("write CLDAT/START,{number},{item}")),
            );
            return Err(Poisoned);
        }
        point.flatten().ok_or_else(|| {
            let message = format!("there are {n} cut vectors, and no number {k} among them");
            self.error(Diagnostic::error(codes::NO_VALUE, span, message));
            Poisoned
        })
    }

    /// A section of CLDAT, or the path of the last motion.
    fn section(&mut self, section: Option<(f64, Span)>, span: Span) -> Known<&CutVectors> {
        let number = section.map(|s| s.0);
        let same = |c: &CutVectors| match (c.section, number) {
            (Some(a), Some(b)) => (a - b).abs() < 1e-6,
            (a, b) => a.is_none() && b.is_none(),
        };
        let at = self.state.cut_vectors.iter().position(same);
        let Some(at) = at else {
            let (message, help) = match number {
                Some(n) => (
                    format!("no section {n} of CLDAT was recorded before"),
                    format!("record it between CLDAT/START,{n} and CLDAT/NOMORE,{n}"),
                ),
                None => (
                    "no motion came before, of which there are cut vectors".to_owned(),
                    "CLDATA without the number of a section is the path of the last motion"
                        .to_owned(),
                ),
            };
            let span = section.map_or(span, |s| s.1);
            self.error(Diagnostic::error(codes::NO_VALUE, span, message).help(help));
            return Err(Poisoned);
        };
        // It was told where it was refused.
        Some(&self.state.cut_vectors[at]).filter(|c| !c.refused).ok_or(Poisoned)
    }
}
