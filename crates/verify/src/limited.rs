//! REGION: lines are milled where the outlines leave them, and nowhere else.
//!
//! A tool that is on its line touches the surface where that may be milled. So what touches it, and nowhere comes near a place that
//! may be milled, is not on its line: it mills what is to be left. Where a tool touches at several places, or all along its flat
//! end, one that may be milled is enough.

use std::sync::Arc;

use aptc_cldata::Position;
use aptc_cldata::milling::{Area, Held, Limits, Milling};
use aptc_geometry::sculpt::Layout;
use aptc_geometry::{Cutter, Profile, Sculptured, Vec3};

use crate::between::Way;
use crate::joint::goes_on;
use crate::outline::Outline;
use crate::search::{Aim, Moved, clearance};
use crate::sheet::{Jet, Patch, Sheet, Spot};
use crate::sweep::Sweep;
use crate::tool::{Pose, Tool};
use crate::witness::descend;

/// Parameters so near to a border of the surface are on it: what may be milled there is what may be beside it.
pub(crate) const AT_BORDER: f64 = 2e-6;
/// Pieces that are looked at for a place that may be milled.
const PIECES: u32 = 20_000;
/// Looks along one vector, and how often it is halved.
const LOOKS: u32 = 64;
const DEPTH: u32 = 10;

/// What may be milled of a surface.
#[derive(Clone, Debug)]
pub(crate) struct Areas {
    all: Vec<Known>,
    /// Where u and v end.
    spans: [f64; 2],
    /// Is each whole number of u the beginning of another patch, which may be anywhere?
    loose: bool,
}

/// One of them: what outlines hold, or the rest.
#[derive(Clone, Debug)]
struct Known {
    inside: bool,
    outlines: Vec<Outline>,
}

/// A part surface of which not all is to be milled.
#[derive(Debug)]
pub(crate) struct Limited {
    sheet: Arc<Sheet>,
    areas: Areas,
    /// Do the outlines go on from patch to patch?
    whole: bool,
    /// The greatest distance at which the tool mills.
    most: f64,
    /// Distance from what may be milled that does not count.
    room: f64,
    /// All that lies below a tool and above it, which may be lifted, and how far down that goes.
    shadow: Option<(Profile, f64)>,
}

/// What comes of a tool at a place.
#[derive(Clone, Copy, Debug)]
enum Look {
    /// It touches nothing.
    Clear,
    /// It touches here, and may.
    Milled(Spot),
    /// It touches where it may not, by so much from what may be milled.
    Wrong(Spot, f64),
}

/// The end of a vector with what came of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Last(Pose, Look);

impl Areas {
    pub(crate) fn new(all: &[Area], surface: &Sculptured) -> Self {
        let of = |a: &Area| {
            let outlines = a.outlines.iter().map(Outline::new).collect();
            Known { inside: a.inside, outlines }
        };
        let loose = matches!(surface.layout, Layout::Patches);
        Self { all: all.iter().map(of).collect(), spans: surface.spans(), loose }
    }

    /// Where the parameter ends across which lie others, at a value of it: of loose patches in the patch.
    pub(crate) fn ends(&self, k: usize, at: f64) -> [f64; 2] {
        if k == 0 && self.loose {
            let patch = at.floor().min(self.spans[0] - 1.0).max(0.0);
            [patch, patch + 1.0]
        } else {
            [0.0, self.spans[k]]
        }
    }

    /// May the place be milled? At a border of the surface what is beside it tells.
    pub(crate) fn allow(&self, at: [f64; 2]) -> bool {
        let at = [0, 1].map(|k| at[k].min(self.spans[k] - AT_BORDER).max(AT_BORDER));
        self.all.iter().all(|area| area.allows(at))
    }

    /// The lines of all outlines.
    pub(crate) fn lines(&self) -> impl Iterator<Item = &[[f64; 2]; 2]> {
        self.all.iter().flat_map(Known::lines)
    }

    /// Is there nothing in a piece that may be milled?
    fn leave_out(&self, patch: &Patch) -> bool {
        self.all.iter().any(|area| !area.meets(patch) && !area.allows(patch.at))
    }

    /// How far a place lies from what may be milled, by the lines next to it as its derivatives show them.
    fn within(&self, at: [f64; 2], jet: &Jet) -> f64 {
        let of = |area: &Known| {
            let [low, high] = self.ends(0, at[0]);
            let own = |line: &&[[f64; 2]; 2]| line.iter().all(|x| x[0] >= low && x[0] <= high);
            let inner = area.lines().filter(own).filter(|line| !self.on_border(line));
            inner.map(|line| beside(line, at, jet)).fold(f64::INFINITY, f64::min)
        };
        self.all.iter().filter(|area| !area.allows(at)).map(of).fold(0.0, f64::max)
    }

    fn on_border(&self, [a, b]: &[[f64; 2]; 2]) -> bool {
        let near = |x: f64, to: f64| (x - to).abs() <= AT_BORDER;
        (0..2).any(|k| [0.0, self.spans[k]].iter().any(|to| near(a[k], *to) && near(b[k], *to)))
    }

    /// A piece without what is on a border of the surface; `None` of what is all there.
    fn inner(&self, patch: &Patch) -> Option<Patch> {
        let mut inner = *patch;
        for k in 0..2 {
            let (from, to) = (patch.at[k] - patch.half[k], patch.at[k] + patch.half[k]);
            let (low, high) = (from.max(AT_BORDER), to.min(self.spans[k] - AT_BORDER));
            if low > high {
                return None;
            }
            if low > from || high < to {
                let Patch { chart, group, .. } = *patch;
                let (at, half) = (inner.at, inner.half);
                inner = Patch { chart, at, half, group, ..Patch::default() };
                (inner.at[k], inner.half[k]) = (0.5 * (low + high), 0.5 * (high - low));
            }
        }
        Some(inner)
    }
}

impl Known {
    fn allows(&self, at: [f64; 2]) -> bool {
        let within = self.outlines.iter().filter(|o| o.within(at)).count();
        (within % 2 == 1) == self.inside
    }

    fn meets(&self, patch: &Patch) -> bool {
        self.outlines.iter().any(|o| o.meets(patch))
    }

    fn lines(&self) -> impl Iterator<Item = &[[f64; 2]; 2]> {
        self.outlines.iter().flat_map(Outline::lines)
    }
}

impl Limited {
    /// `None` where nothing is limited, where it is not known in which direction the tool may be lifted off, and of what has no
    /// charts.
    pub(crate) fn new(
        milling: &Milling,
        sheet: Option<Arc<Sheet>>,
        profile: &Profile,
    ) -> Option<Self> {
        let Limits { areas, held, off, .. } = milling.limits.as_ref()?;
        let (part, sheet) = (milling.part.as_ref()?, sheet?);
        let tree = sheet.tree()?;
        let far = sheet.group(&tree).map(|node| node.center.norm() + node.radius)?;
        let shadow = match held {
            Held::Touching => None,
            Held::Above => {
                let high = 8.0 * (far + profile.reach());
                let flat = Cutter::mill(2.0 * profile.widest(), 0.0, high);
                Some((Profile::new(&flat).ok()?, -0.5 * high))
            }
            Held::Free => return None,
        };
        let most = part.thick + milling.outtol;
        let room = milling.intol + milling.outtol + off;
        let whole = areas.iter().all(|a| goes_on(a, &part.surface, room));
        let areas = Areas::new(areas, &part.surface);
        Some(Self { sheet, areas, whole, most, room, shadow })
    }

    /// Is it told of each patch what may be milled there?
    pub(crate) fn is_whole(&self) -> bool {
        self.whole
    }

    /// Where on a vector the tool mills what is to be left, and how far from what may be milled; of one that leads over it, its
    /// end alone is looked at. `last` is the vector before, and becomes this one.
    pub(crate) fn vector(
        &self,
        profile: &Profile,
        [a, b]: [&Position; 2],
        (over, pad): (bool, f64),
        last: &mut Option<Last>,
    ) -> Option<(Vec3, f64)> {
        let (tool, way) = (Tool::Solid(profile), Way::new(Pose::of(a), Pose::of(b)));
        let look = |t: f64, from: Option<Spot>| self.look(&tool, &way.at(t), from, pad);
        let before = last.take();
        let known = before.as_ref().filter(|l| l.0 == way.at(0.0)).map(|l| l.1);
        let first = known.unwrap_or_else(|| look(0.0, None));
        let end = look(1.0, first.spot().or(before.and_then(|l| l.1.spot())));
        *last = Some(Last(way.at(1.0), end));
        if let Look::Wrong(_, by) = end {
            return Some((b.te, by));
        }
        if over || Pose::of(a) == Pose::of(b) {
            return None;
        }
        if let (Look::Clear, Look::Clear) = (first, end) {
            let sweep = Sweep::new(&tool, way.at(0.0), way.at(1.0), way.turn);
            let whole = Moved::whole(&self.sheet, 1.0, 0.0);
            let (_, t, spot) = clearance(&sweep, &whole, self.most - pad, Aim::Any).nearest?;
            return match look(t, Some(spot)) {
                Look::Wrong(_, by) => Some((way.at(t).te, by)),
                _ => None,
            };
        }
        let mut stack = vec![(0.0, first, 1.0, end, 0)];
        let mut looks = 0;
        while let Some((t0, from, t1, to, depth)) = stack.pop() {
            if !self.asks(from, to, depth) || looks >= LOOKS {
                continue;
            }
            looks += 1;
            let t = 0.5 * (t0 + t1);
            let middle = look(t, from.spot().or(to.spot()));
            if let Look::Wrong(_, by) = middle {
                return Some((way.at(t).te, by));
            }
            stack.push((t, middle, t1, to, depth + 1));
            stack.push((t0, from, t, middle, depth + 1));
        }
        None
    }

    /// Is a stretch to be looked at between its ends? Each is once, and one whose contacts lie on both sides of a line until it is short.
    fn asks(&self, from: Look, to: Look, depth: u32) -> bool {
        let (Some(a), Some(b)) = (from.spot(), to.spot()) else { return depth < 2 };
        if depth == 0 {
            return true;
        }
        let jet = self.sheet.jet(&a);
        let way = jet.d[0] * (b.at[0] - a.at[0]) + jet.d[1] * (b.at[1] - a.at[1]);
        depth < DEPTH && way.norm() > self.room && self.crossed(a.at, b.at)
    }

    fn crossed(&self, a: [f64; 2], b: [f64; 2]) -> bool {
        let at = [0, 1].map(|k| 0.5 * (a[k] + b[k]));
        let half = [0, 1].map(|k| 0.5 * (a[k] - b[k]).abs());
        let box_of = Patch { at, half, ..Patch::default() };
        self.areas.all.iter().any(|area| area.meets(&box_of))
    }

    fn look(&self, tool: &Tool<'_>, pose: &Pose, from: Option<Spot>, pad: f64) -> Look {
        let most = self.most + pad;
        let near = |spot: Spot| {
            let (far, spot, jet) = descend(tool, pose, &self.sheet, spot);
            (far <= most).then_some((spot, jet))
        };
        let somewhere = || {
            let whole = Moved::whole(&self.sheet, 1.0, 0.0);
            let found = clearance(&Sweep::still(tool, *pose), &whole, most, Aim::Any);
            near(found.nearest?.2)
        };
        let Some((spot, jet)) = from.and_then(near).or_else(somewhere) else { return Look::Clear };
        if self.areas.allow(spot.at) {
            return Look::Milled(spot);
        }
        let by = self.areas.within(spot.at, &jet);
        let room = self.room + AT_BORDER * (jet.d[0].norm() + jet.d[1].norm());
        let shadow = self.shadow.as_ref().map(|(profile, up)| Tool::Raised(profile, *up));
        let off = if shadow.is_some() { 0.0 } else { self.most.max(0.0) };
        let tool = shadow.as_ref().unwrap_or(tool);
        if by > room && self.nothing_near(tool, pose, off + room + pad) {
            Look::Wrong(spot, by)
        } else {
            Look::Milled(spot)
        }
    }

    /// Is no place that may be milled within `reach` of the tool? Not where that is not shown.
    fn nothing_near(&self, tool: &Tool<'_>, pose: &Pose, reach: f64) -> bool {
        let Some(root) = self.sheet.tree() else { return false };
        let mut stack = vec![root];
        let mut seen = 0;
        while let Some(patch) = stack.pop() {
            seen += 1;
            if seen > PIECES {
                return false;
            }
            if let Some(node) = self.sheet.group(&patch) {
                if tool.near(pose, node.center).0 - node.radius <= reach {
                    stack.extend(self.sheet.below(&patch, pose.te).into_iter().flatten());
                }
                continue;
            }
            let Some(patch) = self.areas.inner(&patch) else { continue };
            if self.areas.leave_out(&patch) {
                continue;
            }
            let tile = self.sheet.tile(&patch);
            let far = tool.near(pose, tile.c).0;
            if far - tile.radius() > reach {
                continue;
            }
            if far <= reach && self.areas.allow(patch.at) {
                return false;
            }
            let sides = [0, 1].map(|i| tile.side[i].norm() + tile.stray[i]);
            stack.extend(patch.halves(usize::from(sides[1] > sides[0])));
        }
        true
    }
}

impl Look {
    fn spot(&self) -> Option<Spot> {
        match self {
            Self::Clear => None,
            Self::Milled(spot) | Self::Wrong(spot, _) => Some(*spot),
        }
    }
}

/// How far a place is from a line between parameters, as its derivatives show that.
fn beside([a, b]: &[[f64; 2]; 2], at: [f64; 2], jet: &Jet) -> f64 {
    let place = |[u, v]: [f64; 2]| jet.d[0] * (u - at[0]) + jet.d[1] * (v - at[1]);
    let (from, to) = (place(*a), place(*b));
    let way = to - from;
    let square = way.norm_squared();
    let t = if square > 0.0 { (-from.dot(&way) / square).clamp(0.0, 1.0) } else { 0.0 };
    (from + way * t).norm()
}
