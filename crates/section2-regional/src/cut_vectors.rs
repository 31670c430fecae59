//! CLDAT: cut vectors recorded for the program and for REGION.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_cldata::milling::Milling;
use aptc_contact::{Side, Tool, gap, on};
use aptc_geometry::sculpt::nearest_on;
use aptc_geometry::{Form, Profile, Sculptured, Surface, Vec3};
use aptc_protap::{Arg, CutContact, CutPoint, CutVectors, NameRef};

use crate::area::Guide;
use crate::failure::Failure;
use crate::outline::{Outline, same, same_form};
use crate::regional::Regional;
use crate::scon::Words;

/// A section of CLDAT that is open.
#[derive(Clone, Debug)]
pub(crate) struct Recording {
    number: f64,
    /// The first record that belongs to it.
    from: usize,
    /// What CLDAT/START names.
    kept: Vec<Box<str>>,
    points: Vec<CutPoint>,
    outline: Outline,
    guided: Vec<Guided>,
}

/// A motion of regional milling, by its record, along its drive surface.
#[derive(Clone, Debug)]
struct Guided {
    record: usize,
    surface: Arc<Sculptured>,
    /// Parameters of the surface for each of its positions.
    uvs: Vec<[f64; 2]>,
}

impl Guided {
    /// The place of the surface that belongs to a position, its normal towards the tool.
    fn place(&self, k: usize, p: &cl::Position) -> Option<Contact> {
        let uv = *self.uvs.get(k)?;
        let at = self.surface.at(uv[0], uv[1]);
        let normal = at.normal()?;
        let normal = if normal.dot(&p.ta) < 0.0 { -normal } else { normal };
        let patch = Some(patch_of(&self.surface, uv));
        let uv = Some(self.surface.told(uv));
        Some(Contact { place: CutContact { point: at.point, normal, patch }, uv })
    }
}

/// A surface prepared for contacts.
struct Prepared {
    form: Arc<Form>,
    surface: Surface,
    sculptured: Option<Arc<Sculptured>>,
}

/// Where the cutter touches, and the parameters of the whole surface there.
#[derive(Clone, Copy)]
struct Contact {
    place: CutContact,
    uv: Option<[f64; 2]>,
}

impl Recording {
    fn keeps(&self, word: &str) -> bool {
        self.kept.iter().any(|k| **k == *word)
    }

    /// Does it need places of drive surface (else part surface)?
    fn needs(&self, drive: bool) -> bool {
        let words = if drive { ["PDS", "NDS", "UVPDS"] } else { ["PPS", "NPS", "UVPPS"] };
        words.iter().any(|w| self.keeps(w))
    }
}

impl Regional {
    /// CLDAT/START,n,.. and CLDAT/NOMORE,n: the cut vectors of the motions between them, with their contacts as
    /// asked for. These motions are recorded only: they are taken out of `out`, as SSV3 puts none of them out.
    ///
    /// One mistake is told once: what is refused leaves the open section as it is, and NOMORE, REGION and Section 1 ask for the
    /// refused one in silence. A NOMORE of another number ends the open section, which nothing else could.
    ///
    /// APT: `CLDAT`.
    pub(crate) fn cldat(&mut self, args: &[Arg], out: &mut Vec<cl::Record>) -> Result<(), Failure> {
        let mut w = Words(args);
        let begins = w.take("START");
        if !begins {
            w.take("NOMORE");
        }
        let number = w.number().unwrap_or(0.0);
        if !begins {
            return self.end_recording(number, out);
        }
        if let Some(open) = &self.recording {
            let need = format!("given after CLDAT/NOMORE,{}", open.number).into();
            if !same(open.number, number) {
                self.refuse_section(number);
            }
            return Err(Failure::Value { what: "the number of CLDAT/START", value: number, need });
        }
        let mut kept: Vec<Box<str>> = Vec::new();
        while let Some(word) = w.word() {
            kept.push(word.into());
        }
        self.refused.retain(|n| !same(*n, number));
        let of_drive = kept.iter().any(|k| **k == *"UVPDS");
        let (points, outline) = (Vec::new(), Outline::new(number, of_drive));
        let (from, guided) = (out.len(), Vec::new());
        self.recording = Some(Recording { number, from, kept, points, outline, guided });
        Ok(())
    }

    /// CLDAT/NOMORE,n.
    fn end_recording(&mut self, number: f64, out: &mut Vec<cl::Record>) -> Result<(), Failure> {
        let is_open = self.recording.as_ref().is_some_and(|open| same(open.number, number));
        if !is_open && self.is_refused(number) {
            return Ok(());
        }
        let Some(open) = self.recording.take() else {
            self.refuse_section(number);
            return Err(Failure::Value {
                what: "the number of CLDAT/NOMORE",
                value: number,
                need: format!("given after CLDAT/START,{number}").into(),
            });
        };
        let begun = open.number;
        let kept = self.keep_section(open, out);
        if kept.is_err() {
            self.refuse_section(begun);
        }
        if !is_open {
            self.refuse_section(number);
            return Err(Failure::Value {
                what: "the number of CLDAT/NOMORE",
                value: number,
                need: format!("{begun}, that of the CLDAT/START before it").into(),
            });
        }
        kept
    }

    /// Keeps the cut vectors of a section that has ended, and its outline.
    fn keep_section(
        &mut self,
        mut open: Recording,
        out: &mut Vec<cl::Record>,
    ) -> Result<(), Failure> {
        self.gather(&mut open, out)?;
        let Recording { number, kept, points, outline, .. } = open;
        if kept.iter().any(|k| matches!(&**k, "UVPPS" | "UVPDS")) {
            self.keep_outline(outline)?;
        }
        let section = Some(number);
        self.saved.push(CutVectors { section, kept, points, ..CutVectors::default() });
        Ok(())
    }

    /// Remembers that a section is refused, which is told where this is asked for, and tells Section 1. One of that number
    /// that was recorded before stays.
    fn refuse_section(&mut self, number: f64) {
        self.refused.push(number);
        let section = Some(number);
        self.saved.push(CutVectors { section, refused: true, ..CutVectors::default() });
    }

    /// Was that section refused?
    pub(crate) fn is_refused(&self, number: f64) -> bool {
        self.refused.iter().any(|n| same(*n, number))
    }

    /// Are motions being recorded (CLDAT/START), which may be taken out of the output again?
    pub fn is_recording(&self) -> bool {
        self.recording.is_some()
    }

    /// The sections that were closed, and the curves of INTSEC, since the last call.
    pub fn take_saved(&mut self) -> Vec<CutVectors> {
        std::mem::take(&mut self.saved)
    }

    /// Points of INTSEC, one curve after the other and whether it is closed: into the open section, and as the
    /// last path.
    pub(crate) fn record_curves(
        &mut self,
        curves: Vec<(Vec<CutPoint>, bool)>,
        [drive, part]: [Option<&Arc<Form>>; 2],
        uvs: &[Vec<[[f64; 2]; 2]>],
        canon: bool,
        out: &mut Vec<cl::Record>,
    ) -> Result<(), Failure> {
        if let Some(mut open) = self.recording.take() {
            self.gather(&mut open, out)?;
            open.from = out.len();
            let of_drive = open.keeps("UVPDS");
            let form = if of_drive { drive } else { part };
            for ((points, closed), uvs) in curves.iter().zip(uvs) {
                open.points.extend(points);
                let corners = uvs.iter().map(|uv| uv[usize::from(!of_drive)]);
                open.outline.add_curve(form, corners, *closed);
            }
            self.recording = Some(open);
        }
        let points = curves.into_iter().flat_map(|c| c.0).collect();
        self.saved.push(CutVectors { points, canon, ..CutVectors::default() });
        Ok(())
    }

    /// Remembers where the positions of the record of that index lie on their drive, if a section is open and asks
    /// for it.
    pub(crate) fn guided(&mut self, record: usize, guide: &Guide, uvs: Vec<[f64; 2]>) {
        let open = self.recording.as_mut().filter(|open| open.needs(true));
        if let (Some(open), Guide::Surface(surface)) = (open, guide) {
            open.guided.push(Guided { record, surface: Arc::clone(surface), uvs });
        }
    }

    /// Takes the motions of the section out of `out`.
    fn gather(&mut self, open: &mut Recording, out: &mut Vec<cl::Record>) -> Result<(), Failure> {
        let mut prepared: Vec<Prepared> = Vec::new();
        let mut last: Option<Vec3> = None;
        let guided = std::mem::take(&mut open.guided);
        let from = open.from.min(out.len());
        for (index, record) in (from..).zip(out.split_off(from)) {
            let cl::Kind::Motion(m) = &record.kind else {
                out.push(record);
                continue;
            };
            let control = m.control.as_deref();
            let drive = control.and_then(|c| c.drive.as_ref()).filter(|_| open.needs(true));
            let part = control.and_then(|c| c.part.as_ref()).filter(|_| open.needs(false));
            let milling = control.and_then(|c| c.milling.as_ref()).filter(|_| open.needs(false));
            let of_drive = open.keeps("UVPDS");
            let along = guided.iter().find(|g| g.record == index);
            let mut corners = Vec::new();
            for (k, p) in m.points.iter().enumerate() {
                let drive = match along {
                    Some(along) => along.place(k, p),
                    None => self.contact(&mut prepared, drive, p)?,
                };
                let part = match milling {
                    Some(milling) => self.milled(milling, p),
                    None => self.contact(&mut prepared, part, p)?,
                };
                let forward = last.and_then(|q| (p.te - q).try_normalize(0.0));
                last = Some(p.te);
                corners.extend(if of_drive { drive } else { part }.and_then(|c| c.uv));
                open.points.push(CutPoint {
                    te: p.te,
                    ta: p.ta,
                    along: forward,
                    drive: drive.map(|c| c.place),
                    part: part.map(|c| c.place),
                });
            }
            let milled = match along.filter(|_| of_drive) {
                Some(along) => Some(&along.surface),
                None => milling.filter(|_| !of_drive).and_then(|m| Some(&m.part.as_ref()?.surface)),
            };
            let form = match (milled, if of_drive { drive } else { part }) {
                (Some(surface), _) => self.form_of(surface),
                (None, c) => c.map(|c| Arc::clone(&c.form)),
            };
            match form.filter(|f| matches!(f.shape(), Form::Ssurf(_))) {
                Some(form) => open.outline.add(Some(&form), corners.into_iter(), false),
                None => {
                    let other = if of_drive { drive } else { part };
                    other.into_iter().for_each(|c| open.outline.pass(&c.name.name));
                }
            }
        }
        Ok(())
    }

    /// The place that the cutter touches, and its parameters on the whole surface.
    fn contact(
        &mut self,
        prepared: &mut Vec<Prepared>,
        controlled: Option<&cl::Controlled>,
        p: &cl::Position,
    ) -> Result<Option<Contact>, Failure> {
        let Some(c) = controlled else { return Ok(None) };
        let at = prepared.iter().position(|k| same_form(&k.form, &c.form));
        let at = match at {
            Some(at) => at,
            None => {
                let Some(surface) = Surface::from_form(&c.form) else { return Ok(None) };
                let named = NameRef { name: c.name.name.clone(), subscript: c.name.subscript };
                let sculptured = match c.form.shape() {
                    Form::Ssurf(_) => Some(self.surface(&named, &c.form)?),
                    _ => None,
                };
                prepared.push(Prepared { form: Arc::clone(&c.form), surface, sculptured });
                prepared.len() - 1
            }
        };
        let known = &prepared[at];
        let profile = self.settings.profile;
        let Some(place) = touched(profile.as_ref(), &known.surface, c, p) else { return Ok(None) };
        let hit = known.sculptured.as_ref().map(|s| {
            let uv = nearest_on(s, place.point).uv;
            (uv, patch_of(s, uv))
        });
        let place = CutContact { patch: hit.map(|h| h.1), ..place };
        Ok(Some(Contact { place, uv: hit.map(|h| h.0) }))
    }
}

impl Regional {
    /// The place that the cutter touches on the part surface of regional milling.
    fn milled(&mut self, milling: &Milling, p: &cl::Position) -> Option<Contact> {
        let milled = milling.part.as_ref()?;
        let surface = &milled.surface;
        let uv = match self.settings.profile.filter(|_| !milling.on) {
            Some(profile) => {
                let tree = self.tree(surface);
                let tool = Tool { profile: &profile, te: p.te, ta: p.ta };
                let eps = 1e-12 * (surface.extent() + p.te.norm());
                let (place, _) = tree.deepest(&tool, eps)?;
                surface.global(place.patch, place.uv[0], place.uv[1])
            }
            None => nearest_on(surface, p.te).uv,
        };
        let at = surface.at(uv[0], uv[1]);
        let normal = at.normal()? * milled.side;
        let patch = Some(patch_of(surface, uv));
        let uv = Some(surface.told(uv));
        Some(Contact { place: CutContact { point: at.point, normal, patch }, uv })
    }

    /// The definition of a surface that is fitted.
    fn form_of(&self, surface: &Arc<Sculptured>) -> Option<Arc<Form>> {
        let loose = self.wholes.iter().find(|(_, whole)| Arc::ptr_eq(whole, surface));
        let surface = loose.map_or(surface, |(loose, _)| loose);
        let same = self.fitted.iter().find(|(_, s)| Arc::ptr_eq(s, surface));
        same.map(|(form, _)| Arc::clone(form))
    }
}

/// The patch of a place, counted from 1, and its parameters there.
pub(crate) fn patch_of(s: &Sculptured, [u, v]: [f64; 2]) -> (u32, [f64; 2]) {
    let (n, local) = s.span_of(u, v);
    (u32::try_from(n).unwrap_or(u32::MAX), local)
}

/// The place that the cutter touches; without a cutter, and where the tool end lies on the surface, the foot of
/// the tool end.
fn touched(
    profile: Option<&Profile>,
    surface: &Surface,
    c: &cl::Controlled,
    p: &cl::Position,
) -> Option<CutContact> {
    let side = match (c.side, c.open) {
        (_, true) => Side::Open,
        (..0, _) => Side::Negative,
        _ => Side::Positive,
    };
    let place = match profile.filter(|_| c.side != 0) {
        Some(profile) => gap(&Tool { profile, te: p.te, ta: p.ta }, surface, side, 0.0).ok()?,
        None => on(p.te, surface, side),
    };
    Some(CutContact { point: place.surface_point, normal: place.normal, patch: None })
}
