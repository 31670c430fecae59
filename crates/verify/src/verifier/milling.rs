//! The statements of regional milling.

use std::sync::Arc;

use aptc_cldata::Position;
use aptc_cldata::milling::Milling;
use aptc_geometry::{Profile, Sculptured};

use super::{Effort, Open, Verifier, keep};
use crate::certificate::{Fault, StatementProof, SurfaceBound};
use crate::milled::{MilledSurface, name_of};
use crate::scallop::{Cusps, Left};
use crate::sheet::Sheet;
use crate::swath::Swath;
use crate::tool::{Pose, Tool};

/// How it is proved.
const METHOD: &str = "branch and bound";

impl Verifier {
    /// Judges a statement: each vector against the part surface and those that are checked, and then what is
    /// left between its passes.
    pub(super) fn milled(&mut self, open: &Open, milling: &Milling) {
        let Open { start, points, profile, .. } = open;
        let pad = self.pad(points, profile);
        let n = points.len() as u64;
        let surfaces = MilledSurface::all(milling, |s| self.sheet(s));
        let mut proof = StatementProof {
            origin: open.origin.clone(),
            vectors: 0,
            proved: 0,
            method: if surfaces.is_some() { METHOD } else { "none" },
            surfaces: Vec::new(),
            fault: None,
        };
        let Some(mut surfaces) = surfaces else {
            proof.vectors = n;
            self.certificate.undecided += n;
            proof.fault = points.first().map(|p| Fault {
                refuted: false,
                surface: "the surfaces of regional milling".to_owned(),
                vector: 1,
                te: p.te.into(),
                depth: f64::INFINITY,
                gouge: false,
            });
            self.report(&proof, None);
            self.certificate.statements.push(proof);
            return;
        };
        // The vectors, each with whether it was judged and is proved.
        let mut proved: Vec<bool> = Vec::with_capacity(points.len());
        let mut from = *start;
        for (i, to) in (1..).zip(points) {
            let start = from.unwrap_or(*to);
            from = Some(*to);
            let wanted = match self.effort {
                Effort::Full => true,
                Effort::Every(k) => i == 1 || i == n || i % k.max(1) == 0,
            };
            proved.push(false);
            if !wanted {
                self.certificate.left_out += 1;
                continue;
            }
            proof.vectors += 1;
            let mut fault: Option<Fault> = None;
            for s in &mut surfaces {
                keep(&mut fault, s.vector(profile, &start, to, pad, i));
            }
            match &fault {
                None => {
                    proof.proved += 1;
                    self.certificate.proved += 1;
                    proved.last_mut().into_iter().for_each(|p| *p = true);
                }
                Some(f) if f.refuted => self.certificate.refuted += 1,
                Some(_) => self.certificate.undecided += 1,
            }
            keep(&mut proof.fault, fault);
        }
        proof.surfaces = surfaces.iter().filter_map(MilledSurface::bound).collect();
        if let (Some(scallop), Some(part), Effort::Full) =
            (milling.scallop, &milling.part, self.effort)
        {
            let cusps = Cusps {
                sheet: &surfaces[0].sheet,
                side: part.side,
                height: part.thick + scallop.height + milling.outtol,
                range: scallop.range,
            };
            let name = name_of(&part.name);
            self.between(&cusps, name, (start, points, profile), pad, &proved, &mut proof);
        }
        self.report(&proof, None);
        self.certificate.statements.push(proof);
    }

    /// What is left between the passes; the nearest vector answers for it.
    fn between(
        &mut self,
        cusps: &Cusps<'_>,
        name: String,
        (start, points, profile): (&Option<Position>, &[Position], &Profile),
        pad: f64,
        proved: &[bool],
        proof: &mut StatementProof,
    ) {
        let height = cusps.height;
        let tool = Tool::Solid(profile);
        let swath = Swath::new(&tool, profile, ways(start, points));
        let left = cusps.judge(&swath, pad);
        let (way, depth, refuted) = match left {
            Left::Proved => {
                let (least, band) = (0.0, [0.0, height]);
                let (role, most) = ("scallop", height);
                proof.surfaces.push(SurfaceBound { name, role, least, most, band, at: None });
                return;
            }
            Left::Higher(stands, way) => (way, stands - height, true),
            Left::Open(way) => (way, f64::INFINITY, false),
        };
        let Some(at) = points.get(way) else { return };
        if proved.get(way).copied().unwrap_or(false) {
            proof.proved -= 1;
            self.certificate.proved -= 1;
            let count = if refuted {
                &mut self.certificate.refuted
            } else {
                &mut self.certificate.undecided
            };
            *count += 1;
        }
        let vector = way as u64 + 1;
        let surface = format!("between the passes the part surface {name}");
        let te = at.te.into();
        keep(&mut proof.fault, Some(Fault { refuted, surface, vector, te, depth, gouge: false }));
    }

    /// The surface with charts; each is prepared once.
    fn sheet(&mut self, surface: &Arc<Sculptured>) -> Option<Arc<Sheet>> {
        if let Some((_, sheet)) = self.sheets.iter().find(|(s, _)| Arc::ptr_eq(s, surface)) {
            return Some(Arc::clone(sheet));
        }
        let sheet = Arc::new(Sheet::bare(surface)?);
        self.sheets.push((Arc::clone(surface), Arc::clone(&sheet)));
        Some(sheet)
    }
}

/// The vectors to the points.
pub(crate) fn ways(start: &Option<Position>, points: &[Position]) -> Vec<[Pose; 2]> {
    let pose = |p: &Position| Pose { te: p.te, ta: p.ta };
    let first = start.as_ref().or(points.first());
    first.into_iter().chain(points).zip(points).map(|(a, b)| [pose(a), pose(b)]).collect()
}
