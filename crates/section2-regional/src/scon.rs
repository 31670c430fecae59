//! SCON: its words into areas.

use std::sync::Arc;

use aptc_contact::PatchTree;
use aptc_diagnostics::Origin;
use aptc_geometry::sculpt::{FitFault, fit_curve, fit_surface};
use aptc_geometry::{Form, Sculptured, SpaceCurve, Vec3};
use aptc_protap::{Arg, NameRef};

use crate::area::{AxisArea, DriveArea, Guide, Hold, PartArea, Projection, StepoverArea};
use crate::failure::Failure;
use crate::outline::same_form;
use crate::project::Ends;
use crate::regional::Regional;
use crate::unused::on_with_thickness;

/// Arguments read one after the other.
#[derive(Clone, Copy)]
pub(crate) struct Words<'a>(pub(crate) &'a [Arg]);

impl<'a> Words<'a> {
    /// The next word.
    pub(crate) fn word(&mut self) -> Option<&'a str> {
        match self.0 {
            [Arg::Word(w), rest @ ..] => {
                self.0 = rest;
                Some(w)
            }
            _ => None,
        }
    }

    /// Is the next one this word? It is then taken.
    pub(crate) fn take(&mut self, word: &str) -> bool {
        let found = matches!(self.0, [Arg::Word(w), ..] if w == word);
        if found {
            self.0 = &self.0[1..];
        }
        found
    }

    /// The next number.
    pub(crate) fn number(&mut self) -> Option<f64> {
        match self.0 {
            [Arg::Number(x), rest @ ..] => {
                self.0 = rest;
                Some(*x)
            }
            _ => None,
        }
    }

    /// The next number, which must be greater than 0.
    pub(crate) fn positive(&mut self, what: &'static str) -> Result<f64, Failure> {
        let value = self.number().unwrap_or(0.0);
        if value > 0.0 {
            Ok(value)
        } else {
            Err(Failure::Value { what, value, need: "greater than 0".into() })
        }
    }

    /// The next form.
    pub(crate) fn form(&mut self) -> Option<(&'a NameRef, &'a Arc<Form>)> {
        match self.0 {
            [Arg::Form { name, form }, rest @ ..] => {
                self.0 = rest;
                Some((name, form))
            }
            _ => None,
        }
    }

    /// The next vector.
    pub(crate) fn vector(&mut self) -> Option<Vec3> {
        match self.0 {
            [Arg::Form { form, .. }, rest @ ..] => match form.shape() {
                Form::Vector(v) | Form::Point(v) => {
                    self.0 = rest;
                    Some(*v)
                }
                _ => None,
            },
            _ => None,
        }
    }

    /// PLUS or MINUS; +1 when neither stands there.
    pub(crate) fn sign(&mut self) -> f64 {
        if self.take("MINUS") {
            return -1.0;
        }
        self.take("PLUS");
        1.0
    }
}

fn unit(v: Option<Vec3>, what: &'static str) -> Result<Vec3, Failure> {
    v.and_then(|v| v.try_normalize(0.0)).ok_or(Failure::NoDirection { what })
}

/// A number that must be there; Section 1 has checked the form of the statement.
fn need(x: Option<f64>, what: &'static str) -> Result<f64, Failure> {
    x.filter(|x| x.is_finite()).ok_or_else(|| Failure::Value {
        what,
        value: x.unwrap_or(f64::NAN),
        need: "a number".into(),
    })
}

/// The words of SCON that set an area.
const AREAS: [&str; 5] = ["DS", "PS", "AXIS", "FEED", "STEPOV"];

impl Regional {
    /// Sets or clears areas.
    ///
    /// APT: `SCON`.
    pub(crate) fn scon(&mut self, origin: &Origin, args: &[Arg]) -> Result<(), Failure> {
        let mut w = Words(args);
        let word = w.word().unwrap_or("");
        if word == "INIT" {
            self.init(w);
            return Ok(());
        }
        let Some(area) = AREAS.into_iter().find(|a| *a == word) else {
            return Err(Failure::Undone { what: "this form of SCON" });
        };
        let done = self.set_area(area, &mut w);
        let on = |p: &&PartArea| area == "PS" && !p.touches && p.thick != 0.0;
        let part = self.areas.part.as_ref().filter(|_| done.is_ok()).filter(on);
        self.diagnostics.extend(part.map(|part| on_with_thickness(origin, part)));
        let areas = &mut self.areas;
        if done.is_err() {
            // What was set before is not what the program goes on with.
            areas.clear(area);
            areas.failed.push(area);
        } else {
            areas.failed.retain(|a| *a != area);
        }
        done
    }

    fn set_area(&mut self, area: &str, w: &mut Words<'_>) -> Result<(), Failure> {
        match area {
            "DS" => self.areas.drive = Some(self.drive_area(w)?),
            "PS" => self.areas.part = Some(self.part_area(w)?),
            "AXIS" => self.areas.axis = Some(axis_area(w)?),
            "FEED" => self.feed_area(w)?,
            _ => self.areas.stepover = Some(stepover_area(w)?),
        }
        self.agree();
        Ok(())
    }

    fn init(&mut self, mut w: Words<'_>) {
        while let Some(word) = w.word() {
            let all = word == "ALL";
            AREAS.iter().filter(|a| all || **a == word).for_each(|a| self.areas.clear(a));
        }
    }

    fn drive_area(&mut self, w: &mut Words<'_>) -> Result<DriveArea, Failure> {
        let Some((name, form)) = w.form() else {
            return Err(Failure::Undone { what: "SCON/DS without a sculptured curve or surface" });
        };
        let guide = match form.shape() {
            Form::Scurv(_) => Guide::Curve(self.curve(name, form)?),
            _ => Guide::Surface(self.lined(name, form)?),
        };
        w.take("PARAM");
        let mut limit = |what| need(w.number(), what);
        let u = [limit("the first limit of u")?, limit("the second limit of u")?];
        let (v, spans) = match &guide {
            Guide::Curve(c) => ([0.0, 0.0], [c.span(), 0.0]),
            Guide::Surface(s) => {
                ([limit("the first limit of v")?, limit("the second limit of v")?], s.spans())
            }
        };
        // A curve goes on beyond its ends, as APT4 has it; a surface's limits lie on it.
        let room = if matches!(guide, Guide::Curve(_)) { 1.0 } else { 1e-9 };
        let limits = [("a limit of u of the drive", u), ("a limit of v of the drive", v)];
        for ((what, [a, b]), span) in limits.into_iter().zip(spans) {
            for value in [a, b] {
                if value < -room || value > span + room {
                    let need = format!("between 0 and {span}").into();
                    return Err(Failure::Value { what, value, need });
                }
            }
        }
        let hold = if w.take("ON") { Hold::On } else { Hold::At };
        w.take("AT");
        let projection = if w.take("NORMAL") {
            Projection::Normal
        } else if w.take("CRSSPL") {
            Projection::Cross
        } else {
            Projection::Along(unit(w.vector(), "the direction of projection")?)
        };
        let offset = w.number().unwrap_or(0.0);
        Ok(DriveArea { name: name.clone(), guide, u, v, hold, projection, offset })
    }

    fn part_area(&mut self, w: &mut Words<'_>) -> Result<PartArea, Failure> {
        let touches = !w.take("ON");
        w.take("TO");
        let Some((name, form)) = w.form() else {
            return Err(Failure::Undone { what: "SCON/PS without a sculptured surface" });
        };
        let surface = self.surface(name, form)?;
        let surface = self.whole(&surface);
        let side = w.sign();
        let thick = need(w.number(), "the thickness")?;
        Ok(self.part(name, surface, touches, (side, thick)))
    }

    /// A part surface.
    pub(crate) fn part(
        &mut self,
        name: &NameRef,
        surface: Arc<Sculptured>,
        touches: bool,
        (side, thick): (f64, f64),
    ) -> PartArea {
        let (tree, extent, ends) = (self.tree(&surface), surface.extent(), Ends::of(&surface));
        let whole = self.whole(&surface);
        let whole = (Arc::clone(&whole), self.tree(&whole));
        PartArea { name: name.clone(), surface, tree, whole, extent, ends, touches, side, thick }
    }

    /// Along its own lines a part surface is as they are told: loose patches then stay loose. Over another drive they are one grid.
    fn agree(&mut self) {
        let Some(DriveArea { guide: Guide::Surface(lined), hold, offset, .. }) = &self.areas.drive
        else {
            return;
        };
        let (lined, led) = (Arc::clone(lined), *hold == Hold::At && *offset == 0.0);
        let own = self.whole(&lined);
        let Some(part) = &self.areas.part else { return };
        let own = led && Arc::ptr_eq(&own, &part.whole.0);
        let surface = if own { lined } else { Arc::clone(&part.whole.0) };
        if !Arc::ptr_eq(&surface, &part.surface) {
            let (name, touches) = (part.name.clone(), part.touches);
            let kept = (part.side, part.thick);
            self.areas.part = Some(self.part(&name, surface, touches, kept));
        }
    }

    /// A surface whose loose patches are one grid, if they fit together; each is put together once.
    pub(crate) fn whole(&mut self, surface: &Arc<Sculptured>) -> Arc<Sculptured> {
        if let Some((_, whole)) = self.wholes.iter().find(|(s, _)| Arc::ptr_eq(s, surface)) {
            return Arc::clone(whole);
        }
        let whole = surface.together().map_or_else(|| Arc::clone(surface), Arc::new);
        self.wholes.push((Arc::clone(surface), Arc::clone(&whole)));
        whole
    }

    fn feed_area(&mut self, w: &mut Words<'_>) -> Result<(), Failure> {
        if let Some((_, form)) = w.form() {
            self.areas.clearance = match form.shape() {
                Form::Plane(p) => Some(*p),
                Form::Line(l) => Some(l.plane()),
                _ => return Err(Failure::Undone { what: "a clearance surface that is no plane" }),
            };
            return Ok(());
        }
        let mut feeds = [0.0; 4];
        for f in &mut feeds {
            *f = need(w.number(), "a feed")?;
        }
        self.areas.feeds = Some(feeds);
        Ok(())
    }

    /// The fitted curve; each definition is fitted once.
    pub(crate) fn curve(
        &mut self,
        name: &NameRef,
        form: &Arc<Form>,
    ) -> Result<Arc<SpaceCurve>, Failure> {
        let Form::Scurv(d) = form.shape() else {
            return Err(Failure::Undone { what: "a drive that is no sculptured curve" });
        };
        fit_curve(d).map(Arc::new).map_err(|why| self.unfit((name, form), &why))
    }

    /// The surface prepared for questions; each is prepared once.
    pub(crate) fn tree(&mut self, surface: &Arc<Sculptured>) -> Arc<PatchTree> {
        if let Some((_, tree)) = self.trees.iter().find(|(s, _)| Arc::ptr_eq(s, surface)) {
            return Arc::clone(tree);
        }
        let tree = Arc::new(PatchTree::new(surface));
        self.trees.push((Arc::clone(surface), Arc::clone(&tree)));
        tree
    }

    /// The fitted surface; each definition is fitted once. Equal ones are one: records that were read from
    /// text hold the same surface several times.
    pub(crate) fn surface(
        &mut self,
        name: &NameRef,
        form: &Arc<Form>,
    ) -> Result<Arc<Sculptured>, Failure> {
        if let Some((_, s)) = self.fitted.iter().find(|(f, _)| same_form(f, form)) {
            return Ok(Arc::clone(s));
        }
        let Form::Ssurf(d) = form.shape() else {
            return Err(Failure::Undone { what: "a surface that is not sculptured" });
        };
        let fitted = fit_surface(d).map_err(|why| self.unfit((name, form), &why))?;
        let fitted = Arc::new(fitted);
        self.fitted.push((Arc::clone(form), Arc::clone(&fitted)));
        Ok(fitted)
    }

    /// The same of a surface along whose lines the tool is led.
    pub(crate) fn lined(
        &mut self,
        name: &NameRef,
        form: &Arc<Form>,
    ) -> Result<Arc<Sculptured>, Failure> {
        match form.shape() {
            Form::Ssurf(d) if d.only_checks() => {
                Err(Failure::Facets { name: name.name.as_str().into() })
            }
            _ => self.surface(name, form),
        }
    }

    /// What cannot be fitted is told where it is used first.
    fn unfit(&mut self, (name, form): (&NameRef, &Arc<Form>), why: &FitFault) -> Failure {
        if self.unfit.iter().any(|known| same_form(known, form)) {
            return Failure::Told;
        }
        self.unfit.push(Arc::clone(form));
        let name = if name.name.is_empty() { "the curve or surface" } else { name.name.as_str() };
        Failure::Unfit { name: name.into(), why: why.to_string().into() }
    }
}

fn axis_area(w: &mut Words<'_>) -> Result<AxisArea, Failure> {
    if w.take("NORMDS") {
        return Ok(AxisArea::NormDs(w.sign()));
    }
    if w.take("ATANGL") {
        let part = w.take("PS");
        w.take("DS");
        let alpha = need(w.number(), "the slew angle")?;
        w.take("CUTANG");
        let lag = w.take("LAG");
        w.take("LEAD");
        let beta = need(w.number(), "the tilt angle")?;
        for (what, value) in [("the slew angle", alpha), ("the tilt angle", beta)] {
            if value.abs() >= 90.0 {
                return Err(Failure::Value { what, value, need: "between -90 and 90".into() });
            }
        }
        let beta = if lag { -beta } else { beta };
        return Ok(AxisArea::Angle { part, alpha: alpha.to_radians(), beta: beta.to_radians() });
    }
    let v = unit(w.vector(), "the tool axis")?;
    Ok(AxisArea::Fixed(v * w.sign()))
}

fn stepover_area(w: &mut Words<'_>) -> Result<StepoverArea, Failure> {
    let scallop = need(w.number(), "the height of the scallop")?;
    let most = need(w.number(), "the greatest step")?;
    let lift = need(w.number(), "the lift")?;
    let paths = need(w.number(), "the number of paths")?;
    for (what, value) in
        [("the height of the scallop", scallop), ("the lift", lift), ("the number of paths", paths)]
    {
        if value < 0.0 {
            return Err(Failure::Value { what, value, need: "0 or more".into() });
        }
    }
    let paths = (paths >= 1.0).then(|| paths.min(1e9)).map(whole);
    Ok(StepoverArea { scallop, most, lift, paths, parameter: None })
}

#[expect(clippy::cast_possible_truncation, reason = "bounded by the caller")]
fn whole(x: f64) -> usize {
    x as usize
}
