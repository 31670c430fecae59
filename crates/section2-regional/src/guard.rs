//! CHKSRF: no position and no cut vector deeper in a checked surface than allowed.

use std::sync::Arc;

use aptc_contact::{Clear, PIECES, PatchPlace, PatchTree, Swept, Tool};
use aptc_geometry::surface::kept;
use aptc_geometry::{Profile, Sculptured, Shell, Vec3};

use crate::failure::{point, short};
use crate::plain::{Depth, Patience, Plain};

/// A surface that is checked.
#[derive(Clone, Debug)]
pub(crate) struct Checked {
    pub(crate) name: String,
    pub(crate) surface: Arc<Sculptured>,
    pub(crate) tree: Arc<PatchTree>,
    /// Is it the part surface, which keeps its own thickness?
    pub(crate) part: bool,
    /// Left on it where it is another: that of check surfaces.
    pub(crate) thick: f64,
    /// What is left on it as the part surface, where its name stands in place of PS and that is something else.
    pub(crate) own: Option<f64>,
    /// Is it of triangles, whose numbers say nothing?
    pub(crate) facets: bool,
    /// What they bound, if they close.
    pub(crate) body: Option<Arc<Shell>>,
}

/// The checks of a path.
#[derive(Clone, Debug, Default)]
pub(crate) struct Guard {
    pub(crate) surfaces: Vec<Checked>,
    /// Those that are not sculptured.
    pub(crate) plain: Vec<Plain>,
    pub(crate) intol: f64,
    /// Left on the part surface.
    pub(crate) thick: f64,
    /// Shank and holder: solids with the height of their lower end above the tool end.
    pub(crate) holder: Vec<(Profile, f64)>,
    /// Is what is avoided told of (PRINT/AVPRT)?
    pub(crate) report: bool,
    /// The same with the part surface, where that is not checked: AVCTRL tilts no tool into it.
    pub(crate) tilting: Option<Box<Self>>,
}

/// Where a check fails.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Gouge {
    pub(crate) surface: String,
    /// Patch and its parameters, of a sculptured surface that is not of triangles.
    pub(crate) span: Option<(usize, [f64; 2])>,
    /// How deep, the thickness counted.
    pub(crate) depth: f64,
    /// That thickness; none where there is none.
    pub(crate) left: Option<Box<Left>>,
    /// What is in the surface.
    pub(crate) by: Solid,
    /// From where the tool came to stand in a solid that could be a bowl, if it came from outside.
    pub(crate) entered: Option<Box<Vec3>>,
    /// The place that was found in it; none of a surface of which it is known on which side the tool is.
    pub(crate) seen: Option<Box<Seen>>,
    /// Where the tool is deepest on its way, as [`Guard::deepest`] tells.
    pub(crate) stood: Option<Box<Stood>>,
}

/// What is left on a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Left {
    pub(crate) thick: f64,
    /// As [`Checked::own`].
    pub(crate) own: Option<f64>,
}

impl Left {
    fn of(thick: f64, own: Option<f64>) -> Option<Box<Self>> {
        (thick != 0.0 || own.is_some()).then(|| Box::new(Self { thick, own }))
    }
}

/// The tool where a surface is deepest in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stood {
    pub(crate) te: Vec3,
    pub(crate) ta: Vec3,
    /// The place of the surface.
    pub(crate) place: Vec3,
}

/// A place of a surface that was in a solid of the tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Seen {
    pub(crate) place: Vec3,
    by: Solid,
    /// Left on the surface.
    pub(crate) thick: f64,
}

/// A solid of the tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Solid {
    Cutter,
    /// Shank or holder.
    Holder,
    /// The axis between them.
    Between,
}

impl Checked {
    /// The part surface.
    pub(crate) fn part(name: String, surface: Arc<Sculptured>, tree: Arc<PatchTree>) -> Self {
        let (part, facets, body) = (true, false, None);
        Self { name, surface, tree, part, thick: 0.0, own: None, facets, body }
    }

    /// Among others, in place of the same surface.
    pub(crate) fn put(self, among: &mut Vec<Self>) {
        among.retain(|c| !Arc::ptr_eq(&c.surface, &self.surface));
        among.push(self);
    }
}

impl Gouge {
    /// Where on its surface: the patch of a sculptured one, the place of another; and the thickness on it.
    pub(crate) fn placed(&self) -> String {
        let stood = self.stood.as_ref().map(|s| s.place);
        let place = match (self.span, stood.or(self.seen.as_ref().map(|s| s.place))) {
            (Some((n, [u, v])), _) => format!(", patch {n}, u {}, v {}", short(u), short(v)),
            (None, Some(place)) => format!(" at {}", point(place)),
            (None, None) => String::new(),
        };
        match self.left.as_ref().map(|left| left.thick).filter(|thick| *thick != 0.0) {
            Some(thick) => format!("{place}, with the thickness {} on it", short(thick)),
            None => place,
        }
    }
}

impl Guard {
    /// Is there nothing to keep clear of?
    pub(crate) fn is_empty(&self) -> bool {
        self.surfaces.is_empty() && self.plain.is_empty()
    }

    /// Is nothing checked but the part surface of this tree with this thickness, and that not closer than `intol`?
    pub(crate) fn is_part_alone(&self, tree: &Arc<PatchTree>, thick: f64, intol: f64) -> bool {
        let part = |s: &Checked| s.part && Arc::ptr_eq(&s.tree, tree);
        let alone = self.surfaces.len() == 1 && self.plain.is_empty() && self.holder.is_empty();
        alone && self.surfaces.iter().all(part) && thick >= self.thick && intol <= self.intol
    }

    /// The tool comes to the statement from there. Where that is not known each way has the side of its first place.
    pub(crate) fn come_from(&mut self, cutter: &Profile, at: (Vec3, Vec3)) {
        for p in &mut self.plain {
            p.come_from(cutter, at, self.intol);
        }
        if let Some(tilting) = &mut self.tilting {
            tilting.come_from(cutter, at);
        }
    }

    /// What a tool that is tilted is held against.
    pub(crate) fn tilting(&self) -> &Self {
        self.tilting.as_deref().unwrap_or(self)
    }

    /// Is it not known from where the tool comes, and does that matter?
    pub(crate) fn asks(&self) -> bool {
        self.plain.iter().any(|p| p.from.is_none())
    }

    /// Cutter, holder and the axis between them, with the heights above the tool end at which they begin.
    pub(crate) fn solids(&self, cutter: &Profile) -> impl Iterator<Item = (Solid, (Profile, f64))> {
        let rod = kept::between(cutter, &self.holder, self.intol);
        std::iter::once((Solid::Cutter, (*cutter, 0.0)))
            .chain(self.holder.iter().map(|h| (Solid::Holder, *h)))
            .chain(rod.map(|rod| (Solid::Between, rod)))
    }

    /// A body of triangles in which a tool stands that is clear of them, and how far its middle is from them.
    pub(crate) fn held(&self, cutter: &Profile, (te, ta): (Vec3, Vec3)) -> Option<Gouge> {
        let bodies = self.surfaces.iter().filter_map(|s| s.body.as_ref().map(|body| (s, body)));
        let mut all = bodies.flat_map(|(s, body)| {
            self.solids(cutter).filter_map(move |(by, (profile, up))| {
                let middle = te + ta * (up + 0.5 * (profile.bottom() + profile.height()));
                let depth = body.holds(middle)?;
                let (surface, span, left) = (s.name.clone(), None, None);
                let (entered, seen, stood) = (None, None, None);
                Some(Gouge { surface, span, depth, left, by, entered, seen, stood })
            })
        });
        all.next()
    }

    /// The thickness left on a surface.
    pub(crate) fn left_on(&self, s: &Checked) -> f64 {
        if s.part { self.thick } else { s.thick }
    }

    pub(crate) fn told(&self, s: &Checked, place: PatchPlace, by: Solid) -> Gouge {
        let [u, v] = s.surface.global(place.patch, place.uv[0], place.uv[1]);
        let thick = self.left_on(s);
        let span = (!s.facets).then(|| s.surface.span_of(u, v));
        let depth = thick - place.distance;
        let seen = Some(Box::new(Seen { place: s.surface.at(u, v).point, by, thick }));
        let (surface, left) = (s.name.clone(), Left::of(thick, s.own));
        Gouge { surface, span, depth, left, by, entered: None, seen, stood: None }
    }

    /// Is a place that was in the tool somewhere else deeper than `intol` in it here too?
    pub(crate) fn holds(
        &self,
        cutter: &Profile,
        (te, ta): (Vec3, Vec3),
        seen: &Seen,
        intol: f64,
    ) -> bool {
        self.solids(cutter).filter(|(by, _)| *by == seen.by).any(|(_, (profile, up))| {
            let tool = Tool { profile: &profile, te: te + ta * up, ta };
            tool.distance(seen.place) < seen.thick - intol
        })
    }

    /// Is the tool with its holder clear all the way from one tool end and axis to the other? An axis that
    /// turns is proved stretch by stretch.
    pub(crate) fn way(&self, cutter: &Profile, ends: [(Vec3, Vec3); 2]) -> Result<(), Gouge> {
        self.way_by(cutter, ends, (PIECES, Patience::Full))
    }

    /// Is it soon seen to be clear all the way? Of one of many ways that would do.
    pub(crate) fn lets_by(&self, cutter: &Profile, ends: [(Vec3, Vec3); 2]) -> bool {
        self.way_by(cutter, ends, (PIECES, Patience::Short)).is_ok()
    }

    /// The same; a tool that stands is looked at for so many `looks` beside each sculptured surface.
    pub(crate) fn way_by(
        &self,
        cutter: &Profile,
        ends: [(Vec3, Vec3); 2],
        (looks, patience): (usize, Patience),
    ) -> Result<(), Gouge> {
        for solid in self.solids(cutter) {
            self.of_sculptured(solid, ends, self.intol, looks)?;
            self.of_plain(cutter, solid, (ends, patience), self.intol)?;
        }
        Ok(())
    }

    /// Is a tool clear where it stands? As above, what is answered soonest first: the part surface, which it touches, takes
    /// most looks.
    pub(crate) fn stands(
        &self,
        cutter: &Profile,
        at: (Vec3, Vec3),
        intol: f64,
        looks: usize,
    ) -> Result<(), Gouge> {
        for solid in self.solids(cutter) {
            self.of_plain(cutter, solid, ([at, at], Patience::Full), intol)?;
        }
        for solid in self.solids(cutter) {
            self.of_sculptured(solid, [at, at], intol, looks)?;
        }
        Ok(())
    }

    /// One solid beside the sculptured surfaces.
    fn of_sculptured(
        &self,
        (by, (profile, up)): (Solid, (Profile, f64)),
        ends: [(Vec3, Vec3); 2],
        intol: f64,
        looks: usize,
    ) -> Result<(), Gouge> {
        let [a, b] = ends;
        for s in &self.surfaces {
            let allowed = intol - self.left_on(s);
            let tool = Tool { profile: &profile, te: a.0 + a.1 * up, ta: a.1 };
            let found = if a == b {
                s.tree.clear_by(&tool, allowed, looks)
            } else if (a.1 - b.1).norm() <= 1e-12 {
                s.tree.clear(&Swept { tool, by: b.0 - a.0 }, allowed)
            } else {
                s.tree.clear_turning((&profile, up), ends, allowed)
            };
            // What cannot be proved clear is not taken for clear.
            if let Clear::No(place) | Clear::Unknown(place) = found {
                return Err(self.told(s, place, by));
            }
        }
        Ok(())
    }

    /// And beside the others.
    fn of_plain(
        &self,
        cutter: &Profile,
        (by, (profile, up)): (Solid, (Profile, f64)),
        (ends, patience): ([(Vec3, Vec3); 2], Patience),
        intol: f64,
    ) -> Result<(), Gouge> {
        for p in &self.plain {
            if let Some(Depth { depth, place, .. }) =
                p.deep(cutter, (&profile, up), ends, intol, patience)
            {
                let entered = p.entered(cutter, ends[1]).map(Box::new);
                let surface = p.name.clone();
                let (depth, left) = (depth + p.thick, Left::of(p.thick, None));
                let seen = place.map(|place| Box::new(Seen { place, by, thick: p.thick }));
                let (span, stood) = (None, None);
                return Err(Gouge { surface, span, depth, left, by, entered, seen, stood });
            }
        }
        Ok(())
    }
}
