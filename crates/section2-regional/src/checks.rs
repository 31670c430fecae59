//! CHKSRF and AVCTRL: what is checked, and how a gouge is avoided.

use std::sync::Arc;

use aptc_geometry::sculptured::SurfaceDefinition;
use aptc_geometry::{Form, Sculptured, Shell};
use aptc_protap::Arg;

use crate::area::PartArea;
use crate::avoid::Avoid;
use crate::failure::Failure;
use crate::guard::{Checked, Guard};
use crate::outline::same_form;
use crate::plain::Plain;
use crate::regional::Regional;
use crate::scon::Words;

impl Regional {
    /// CHKSRF/PS,names,ON|OFF, either or both, and CHKSRF/OFF for all of them.
    ///
    /// APT: `CHKSRF`, which took any name for PS.
    pub(crate) fn chksrf(&mut self, args: &[Arg]) -> Result<(), Failure> {
        let mut w = Words(args);
        if w.take("OFF") {
            self.check_part = false;
            self.checked.clear();
            self.plain.clear();
            self.watch.outside.clear();
            return Ok(());
        }
        let (mut named, mut part) = (Vec::new(), false);
        loop {
            if w.take("PS") {
                part = true;
            } else if let Some(one) = w.form() {
                named.push(one);
            } else {
                break;
            }
        }
        if named.is_empty() && !part {
            return Err(Failure::Undone { what: "CHKSRF without PS or a surface" });
        }
        let on = w.take("ON");
        if part {
            self.check_part = on;
        }
        for (name, form) in named {
            let label = name.name.to_string();
            if let Form::Ssurf(definition) = form.shape() {
                let surface = self.surface(name, form)?;
                let facets = definition.only_checks();
                let surface = if facets { surface } else { self.whole(&surface) };
                self.checked.retain(|c| !Arc::ptr_eq(&c.surface, &surface));
                self.watch.outside.retain(|s| !Arc::ptr_eq(s, &surface));
                if on {
                    let tree = self.tree(&surface);
                    let body = self.body(&surface, definition);
                    let (name, part, thick, own) = (label, false, 0.0, None);
                    let checked = Checked { name, surface, tree, part, thick, own, facets, body };
                    self.checked.push(checked);
                }
                continue;
            }
            self.plain.retain(|p| !same_form(&p.form, form));
            if on {
                let plain = Plain::new(label, form)
                    .ok_or(Failure::Undone { what: "CHKSRF of a surface of this kind" })?;
                self.plain.push(plain);
            }
        }
        Ok(())
    }

    /// What triangles bound, if they close; looked at once.
    fn body(
        &mut self,
        surface: &Arc<Sculptured>,
        definition: &SurfaceDefinition,
    ) -> Option<Arc<Shell>> {
        if let Some((_, body)) = self.bodies.iter().find(|(s, _)| Arc::ptr_eq(s, surface)) {
            return body.clone();
        }
        let body = definition.triangles().and_then(|all| Shell::closed(&all)).map(Arc::new);
        self.bodies.push((Arc::clone(surface), body.clone()));
        body
    }

    /// PRINT/AVPRT,ON|OFF, also written AVMSG.
    pub(crate) fn print(&mut self, args: &[Arg]) {
        let mut w = Words(args);
        if w.take("AVPRT") || w.take("AVMSG") {
            self.report = w.take("ON");
        }
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
        self.guarded(self.areas.part.as_ref())
    }

    /// What CHKSRF names, with the thickness that check surfaces have now: the third number of THICK.
    pub(crate) fn named(&self) -> (Vec<Checked>, Vec<Plain>) {
        let thick = self.settings.thick_check;
        let checked = self.checked.iter().map(|c| Checked { thick, ..c.clone() });
        let plain = self.plain.iter().map(|p| Plain { thick, ..p.clone() });
        (checked.collect(), plain.collect())
    }

    /// The same with the part surface given.
    pub(crate) fn guarded(&self, part: Option<&PartArea>) -> Option<Guard> {
        let (mut surfaces, plain) = self.named();
        for s in &mut surfaces {
            let other = |p: &&PartArea| {
                Arc::ptr_eq(&s.surface, &p.surface) && (p.thick - s.thick).abs() > 0.0
            };
            s.own = part.filter(other).map(|p| p.thick);
        }
        let part_too = |surfaces: &mut Vec<Checked>| {
            if let Some(p) = part.filter(|p| p.touches) {
                let (surface, tree) = p.whole.clone();
                Checked::part(p.name.name.to_string(), surface, tree).put(surfaces);
            }
        };
        if self.check_part {
            part_too(&mut surfaces);
        }
        let thick = part.map_or(0.0, |p| p.thick);
        let intol = self.settings.band().intol;
        let (holder, report) = (self.holder.clone(), self.report);
        let mut guard = Guard { surfaces, plain, intol, thick, holder, report, tilting: None };
        let tilts = self.avoid.on && self.avoid.tilt.is_some();
        if tilts && !self.check_part && !guard.is_empty() {
            let mut tilting = guard.clone();
            part_too(&mut tilting.surfaces);
            guard.tilting = Some(Box::new(tilting));
        }
        if let (Some(cutter), Some(came)) = (&self.settings.profile, self.came) {
            guard.come_from(cutter, came);
        }
        (!guard.is_empty()).then_some(guard)
    }
}
