//! CHKSRF and AVCTRL: what is checked, and how a gouge is avoided.

use std::sync::Arc;

use aptc_contact::PatchTree;
use aptc_protap::Arg;

use crate::avoid::Avoid;
use crate::failure::Failure;
use crate::guard::{Checked, Guard};
use crate::regional::Regional;
use crate::scon::Words;

impl Regional {
    /// CHKSRF/PS,ON|OFF and CHKSRF/name,ON|OFF.
    ///
    /// APT: `CHKSRF`, which took any name for PS.
    pub(crate) fn chksrf(&mut self, args: &[Arg]) -> Result<(), Failure> {
        let mut w = Words(args);
        if w.take("PS") {
            self.check_part = w.take("ON");
            return Ok(());
        }
        let Some((name, form)) = w.form() else {
            return Err(Failure::Undone { what: "CHKSRF without PS or a sculptured surface" });
        };
        let surface = self.surface(name, form)?;
        let label = name.name.to_string();
        self.checked.retain(|c| !Arc::ptr_eq(&c.surface, &surface));
        if w.take("ON") {
            let tree = Arc::new(PatchTree::new(&surface));
            self.checked.push(Checked { name: label, surface, tree, part: false });
        }
        Ok(())
    }

    /// AVCTRL/ON|OFF leaves the parameters alone; the other forms set them and switch it on. LIMIT
    /// omitted: none.
    ///
    /// APT: `AVCTRL`.
    pub(crate) fn avctrl(&mut self, args: &[Arg]) -> Result<(), Failure> {
        let mut w = Words(args);
        if w.take("ON") {
            self.avoid.on = true;
            return Ok(());
        }
        if w.take("OFF") {
            self.avoid.on = false;
            return Ok(());
        }
        let mut avoid = Avoid { on: true, ..Avoid::default() };
        if w.take("CUTANG") {
            w.take("CONST");
            let constant = w.number().unwrap_or(0.0);
            w.take("RANGE");
            let (low, high) = (w.number().unwrap_or(0.0), w.number().unwrap_or(0.0));
            for (what, value) in [
                ("the technological angle", constant),
                ("a limit of the tilt", low),
                ("a limit of the tilt", high),
            ] {
                if value.abs() >= 90.0 {
                    return Err(Failure::Value { what, value, need: "between -90 and 90".into() });
                }
            }
            if low > high {
                let need = format!("at most the second, {high}").into();
                return Err(Failure::Value {
                    what: "the first limit of the tilt",
                    value: low,
                    need,
                });
            }
            avoid.tilt = Some([constant, low, high]);
        }
        avoid.along_normal = w.take("NORMPS");
        w.take("AXIS");
        if w.take("LIMIT") {
            let limit = w.number().unwrap_or(0.0);
            if limit < 0.0 {
                let need = "0 or more".into();
                return Err(Failure::Value { what: "the limit of the lift", value: limit, need });
            }
            avoid.limit = Some(limit);
        }
        self.avoid = avoid;
        Ok(())
    }

    /// What is checked along the next path; none without CHKSRF.
    pub(crate) fn guard(&self) -> Option<Guard> {
        let mut surfaces = self.checked.clone();
        let part = self.areas.part.as_ref();
        if let Some(p) = part.filter(|p| self.check_part && p.touches) {
            surfaces.retain(|c| !Arc::ptr_eq(&c.surface, &p.surface));
            let tree = Arc::new(PatchTree::new(&p.surface));
            let surface = Arc::clone(&p.surface);
            surfaces.push(Checked { name: p.name.name.to_string(), surface, tree, part: true });
        }
        let thick = part.map_or(0.0, |p| p.thick);
        let intol = self.settings.band().intol;
        (!surfaces.is_empty()).then_some(Guard { surfaces, intol, thick })
    }
}
