//! STOCK: the block of material; a rapid motion through what cuts have left of it is refused.

use aptc_diagnostics::{Origin, codes};
use aptc_geometry::{Cutter, Profile, Vec3};

use crate::args::Statement;
use crate::machine::MachineKind;
use crate::post::{Post, trimmed};
use crate::stock::Stock;
use crate::words::bad_arguments;

/// Cosine of the greatest lean of a tool that counts as standing along Z: 0.003 degrees.
const ALONG_Z: f64 = 1.0 - 1e-9;

/// `STOCK/x1,y1,z1,x2,y2,z2`: two opposite corners of the block.
pub(super) fn stock(post: &mut Post, s: &Statement<'_>) {
    let numbers: Vec<f64> = (0..s.args.len()).map_while(|i| s.number(i)).collect();
    match <[f64; 6]>::try_from(numbers) {
        Ok(corners) if s.args.len() == 6 => {
            if !post.set_stock(corners, s.origin) {
                bad_arguments(post, s, "STOCK/ with two corners of a block that has a volume");
            }
        }
        _ => bad_arguments(post, s, "STOCK/x1,y1,z1,x2,y2,z2"),
    }
}

impl Post {
    /// The material is the block between two corners, in units of the CL data; `false` without volume.
    pub(crate) fn set_stock(&mut self, c: [f64; 6], origin: &Origin) -> bool {
        if self.machine.kind == MachineKind::Lathe {
            let message = "on a lathe rapid motions are not checked against the stock".to_owned();
            self.warn(codes::STOCK_UNCHECKED, origin, message, "");
            return true;
        }
        let a = self.st.point(Vec3::new(c[0], c[1], c[2]));
        let b = self.st.point(Vec3::new(c[3], c[4], c[5]));
        self.stock = Stock::new(a, b).map(Box::new);
        self.summary.stock = self.stock.as_ref().map(|_| [a.inf(&b).into(), a.sup(&b).into()]);
        self.stock.is_some()
    }

    /// A cut takes material away.
    #[inline]
    pub(crate) fn takes_away(&mut self, from: Option<Vec3>, to: Vec3, ta: Vec3, origin: &Origin) {
        if self.stock.is_none() || !self.stands(ta, origin) {
            return;
        }
        let cutter = self.cutter_here();
        if let (Some(stock), Some(from)) = (&mut self.stock, from) {
            stock.cut(from, to, cutter.as_ref());
        }
    }

    /// A rapid motion along straight lines must not touch material.
    pub(crate) fn must_be_free(&mut self, way: &[Vec3], ta: Vec3, origin: &Origin) {
        if self.stock.is_none() || !self.stands(ta, origin) {
            return;
        }
        let cutter = self.cutter_here();
        let Some(stock) = &mut self.stock else { return };
        let hits = way.windows(2).filter_map(|w| stock.hit(w[0], w[1], cutter.as_ref()));
        let Some(hit) = hits.max_by(|a, b| a.depth.total_cmp(&b.depth)) else { return };
        // What it went through is gone: the way back and out of it is no further mistake.
        way.windows(2).for_each(|w| stock.cut(w[0], w[1], cutter.as_ref()));
        if self.hit_told == Some((origin.isn, origin.line)) {
            return;
        }
        self.hit_told = Some((origin.isn, origin.line));
        let [x, y, z] = [hit.at.x, hit.at.y, hit.at.z].map(|c| trimmed(c, 3));
        let message = format!(
            "a rapid motion goes through the stock, {} deep at {x},{y},{z}",
            trimmed(hit.depth, 3)
        );
        let help = "retract first, leave RAPID out, or correct STOCK";
        self.error(codes::RAPID_IN_STOCK, origin, message, help);
    }

    /// From the height of the machine down to a position.
    pub(crate) fn down_to(&self, to: Vec3) -> [Vec3; 2] {
        let top = self.summary.stock.map_or(to.z, |[_, max]| max[2].max(to.z));
        [Vec3::new(to.x, to.y, top), to]
    }

    /// Does the tool stand along Z? When it leans the check ends, and the user is told.
    fn stands(&mut self, ta: Vec3, origin: &Origin) -> bool {
        if ta.z >= ALONG_Z {
            return true;
        }
        self.stock = None;
        let message =
            "from here on rapid motions are not checked against the stock: the tool leans";
        self.warn(codes::STOCK_UNCHECKED, origin, message.to_owned(), "");
        false
    }

    /// The cutter in output units; none where CUTTER is missing or describes no cutter.
    fn cutter_here(&self) -> Option<Profile> {
        let s = self.st.scale;
        let c = self.st.cutter?;
        Profile::new(&Cutter {
            diameter: c.diameter * s,
            corner_radius: c.corner_radius * s,
            e: c.e * s,
            f: c.f * s,
            height: c.height * s,
            ..c
        })
        .ok()
    }
}
