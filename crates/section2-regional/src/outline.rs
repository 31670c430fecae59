//! REGION: what the outlines that CLDAT recorded leave of a line.

use std::sync::Arc;

use aptc_cldata as cl;
use aptc_cldata::milling::{self, Area, AskedLine, Limits, Milling};
use aptc_geometry::{Form, Sculptured};
use aptc_protap::{Arg, NameRef};

use crate::avoid::Avoid;
use crate::failure::{Failure, NoOutline};
use crate::joints::Joined;
use crate::regional::Regional;
use crate::round::{closed, crosses, is_one};
use crate::scon::Words;

/// Parameters so near to a border are on it.
const AT_BORDER: f64 = 1e-6;
/// A line along a border is judged so far within it, farther than what is on the border may lie.
const BESIDE: f64 = 2.0 * AT_BORDER;

/// What a section of CLDAT went round on one surface.
#[derive(Clone, Debug)]
pub(crate) struct Outline {
    number: f64,
    form: Option<Arc<Form>>,
    /// Corners, u and v: of all motions and open curves together, then of each closed curve.
    loops: Vec<Vec<[f64; 2]>>,
    /// The first and the last corner of each open curve of INTSEC among all motions.
    open: Vec<[usize; 2]>,
    /// Is there a curve of INTSEC?
    curved: bool,
    /// Does it go over more than one surface?
    scattered: bool,
    /// Was it recorded by UVPDS?
    of_drive: bool,
    /// The first surface along it that is no SSURF.
    other: Option<Box<str>>,
}

/// The outlines and which of them limit lines.
#[derive(Clone, Debug, Default)]
pub(crate) struct Outlines {
    recorded: Vec<Outline>,
    active: Vec<Active>,
    /// Numbers of which REGION failed, so that it is not known what they limit.
    failed: Vec<f64>,
}

/// An outline that limits lines.
#[derive(Clone, Debug)]
struct Active {
    number: f64,
    /// Is the inside milled?
    inside: bool,
    /// What it went round: of places that lie in an odd number of them.
    held: Vec<milling::Outline>,
    /// The corners of loops on loose patches.
    corners: Vec<Vec<[f64; 2]>>,
    /// Where u and v of its surface end.
    spans: [f64; 2],
}

/// What an outline goes round, and its corners on loose patches.
#[derive(Default)]
struct Held {
    held: Vec<milling::Outline>,
    corners: Vec<Vec<[f64; 2]>>,
    spans: [f64; 2],
}

impl Regional {
    /// REGION/n,IN|OUT|OFF and REGION/OFF. Where it fails no lines are milled until it is given again or switched off.
    ///
    /// APT: `REGION`.
    pub(crate) fn region(&mut self, args: &[Arg]) -> Result<(), Failure> {
        let mut w = Words(args);
        self.told_over = false;
        let Some(number) = w.number() else {
            self.outlines.active.clear();
            self.outlines.failed.clear();
            return Ok(());
        };
        let is_off = { w }.take("OFF");
        let failed = self.outlines.failed.iter().any(|n| same(*n, number));
        self.outlines.failed.retain(|n| !same(*n, number));
        if failed && is_off {
            self.outlines.active.retain(|a| !same(a.number, number));
            return Ok(());
        }
        let done = self.limit(number, w);
        if done.is_err() && !is_off {
            self.outlines.failed.push(number);
        }
        done
    }

    fn limit(&mut self, number: f64, mut w: Words<'_>) -> Result<(), Failure> {
        let Some(outline) = self.outlines.recorded.iter().find(|o| same(o.number, number)) else {
            if self.is_refused(number) {
                return Err(Failure::Told);
            }
            return Err(Failure::Value {
                what: "the number of REGION",
                value: number,
                need: "one that CLDAT recorded before with UVPPS or UVPDS".into(),
            });
        };
        if outline.scattered {
            return Err(Failure::Undone { what: "REGION over more than one surface" });
        }
        if !outline.encloses() {
            let (of_drive, other) = (outline.of_drive, outline.other.clone());
            return Err(Failure::NoOutline(Box::new(NoOutline { number, of_drive, other })));
        }
        let outline = outline.clone();
        let active = match w.take("OFF") {
            true => None,
            false => {
                let Held { held, corners, spans } = self.held(&outline)?;
                Some(Active { number, inside: w.take("IN"), held, corners, spans })
            }
        };
        self.outlines.active.retain(|a| !same(a.number, number));
        self.outlines.active.extend(active);
        Ok(())
    }

    /// Keeps an outline, in the place of one of the same number, also where that limits lines now.
    pub(crate) fn keep_outline(&mut self, outline: Outline) -> Result<(), Failure> {
        let of = |a: &Active| same(a.number, outline.number);
        if self.outlines.active.iter().any(of) {
            let Held { held, corners, spans } = self.held(&outline)?;
            for active in self.outlines.active.iter_mut().filter(|a| of(a)) {
                active.held.clone_from(&held);
                active.corners.clone_from(&corners);
                active.spans = spans;
            }
        }
        self.outlines.recorded.retain(|o| !same(o.number, outline.number));
        self.outlines.recorded.push(outline);
        Ok(())
    }

    /// What the loops of an outline hold.
    fn held(&mut self, outline: &Outline) -> Result<Held, Failure> {
        let Some(form) = &outline.form else {
            return Ok(Held { spans: [f64::INFINITY; 2], ..Held::default() });
        };
        let surface = self.surface(&NameRef::default(), form)?;
        let mut outline = outline.clone();
        let band = self.settings.band();
        let joined = (!is_one(&surface)).then(|| Joined::new(&surface, band.intol + band.outtol));
        let flat = joined.as_ref().map_or(&*surface, Joined::grid);
        let mut corners = Vec::new();
        if let Some(joined) = &joined {
            outline.lay(joined)?;
        }
        outline.join(flat.spans());
        if let Some(why) = outline.astray(flat.spans()) {
            return Err(Failure::Outline { why });
        }
        if let Some(joined) = &joined {
            corners = outline.told(joined);
            outline.cross(joined)?;
        }
        let closed = outline.loops.iter().filter(|l| l.len() >= 3);
        let held: Vec<_> =
            closed.map(|l| held(l, flat)).collect::<Result<_, _>>().map_err(|_| {
                Failure::Outline {
                    why: "its outline goes round a surface that ends in no point, which has no side inside of it",
                }
            })?;
        if let Some(why) = outline.fault(&held, flat.spans()) {
            return Err(Failure::Outline { why });
        }
        let held = match &joined {
            Some(joined) => held
                .iter()
                .map(|o| joined.by_patch(o))
                .collect::<Result<_, _>>()
                .map_err(|why| Failure::Joint { why })?,
            None => held,
        };
        Ok(Held { held, corners, spans: surface.spans() })
    }
}

/// Do two numbers of sections mean the same?
pub(crate) fn same(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-6
}

/// Whether two places name one surface: from a numeric part program each statement has a copy of its own.
pub(crate) fn same_form(a: &Arc<Form>, b: &Arc<Form>) -> bool {
    Arc::ptr_eq(a, b) || a == b
}

impl Outlines {
    /// That it is known what REGION limits: where it failed, that was told.
    pub(crate) fn known(&self) -> Result<(), Failure> {
        if self.failed.is_empty() { Ok(()) } else { Err(Failure::Told) }
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
        for active in self.on(form) {
            let kept = active.stretches(running, fixed, ends);
            left = left
                .iter()
                .flat_map(|a| kept.iter().map(|b| [a[0].max(b[0]), a[1].min(b[1])]))
                .filter(|s| s[1] - s[0] > 1e-9)
                .collect();
        }
        left
    }

    /// What is promised of lines of a surface; `None` where no outline limits them.
    pub(crate) fn limits(
        &self,
        form: &Arc<Form>,
        lines: Vec<AskedLine>,
        off: f64,
        avoid: Avoid,
    ) -> Option<Limits> {
        let area = |a: &Active| Area {
            inside: a.inside,
            outlines: a.held.clone(),
            recorded: a.corners.clone(),
        };
        let areas: Vec<_> = self.on(form).map(area).collect();
        let held = match (avoid.on, avoid.along_normal) {
            (false, _) => milling::Held::Touching,
            (true, false) => milling::Held::Above,
            (true, true) => milling::Held::Free,
        };
        (!areas.is_empty()).then_some(Limits { areas, lines, held, off })
    }

    /// The outlines that limit lines of a surface.
    fn on(&self, form: &Arc<Form>) -> impl Iterator<Item = &Active> {
        self.active.iter().filter(move |active| {
            let on_it = |o: &Outline| o.form.as_ref().is_some_and(|f| same_form(f, form));
            self.recorded.iter().any(|o| same(o.number, active.number) && on_it(o))
        })
    }
}

/// Takes back that all lines are milled that were asked for: not all are.
pub(crate) fn broken_off(records: &mut [cl::Record]) {
    let mut free: Option<Arc<cl::Control>> = None;
    for record in records {
        if let cl::Kind::Motion(motion) = &mut record.kind
            && let Some(control) = &mut motion.control
            && let Some(milling) = &control.milling
            && let Some(limits) = milling.limits.as_ref().filter(|l| !l.lines.is_empty())
        {
            // Motions of one control stay so.
            *control = Arc::clone(free.get_or_insert_with(|| {
                let limits = Some(Limits { lines: Vec::new(), ..limits.clone() });
                let milling = Some(Milling { limits, ..milling.clone() });
                Arc::new(cl::Control { milling, ..cl::Control::clone(control) })
            }));
        }
    }
}

impl Active {
    /// What is milled of the line, rising. Of a line along a border of the surface it is what is milled beside it: the lines of
    /// an outline that is closed along the border lie on it, to rounding, and tell nothing.
    fn stretches(&self, running: usize, fixed: f64, [from, to]: [f64; 2]) -> Vec<[f64; 2]> {
        let fixed = fixed.min(self.spans[1 - running] - BESIDE).max(BESIDE);
        let mut cuts = vec![from, to];
        for [a, b] in self.held.iter().flat_map(|o| &o.lines) {
            let (x, y) = (a[1 - running] - fixed, b[1 - running] - fixed);
            if (x > 0.0) != (y > 0.0) {
                cuts.push(a[running] + (b[running] - a[running]) * (x / (x - y)));
            }
        }
        cuts.retain(|x| (from..=to).contains(x));
        cuts.sort_by(f64::total_cmp);
        let is_milled = |middle: f64| {
            let mut at = [fixed; 2];
            at[running] = middle;
            let held = self.held.iter().filter(|o| o.holds(at)).count();
            (held % 2 == 1) == self.inside
        };
        let mut all: Vec<[f64; 2]> = Vec::new();
        for w in cuts.windows(2).filter(|w| w[0] < w[1] && is_milled(0.5 * (w[0] + w[1]))) {
            match all.last_mut() {
                Some(last) if last[1] >= w[0] => last[1] = w[1],
                _ => all.push([w[0], w[1]]),
            }
        }
        all
    }
}

/// What a loop of corners holds. On a surface that nowhere closes its lines may cross.
fn held(corners: &[[f64; 2]], surface: &Sculptured) -> Result<milling::Outline, &'static str> {
    if is_one(surface) && (surface.closes(0) || surface.closes(1)) {
        return closed(corners, surface);
    }
    let next = corners.iter().cycle().skip(1);
    let lines = corners.iter().zip(next).map(|(a, b)| [*a, *b]).collect();
    Ok(milling::Outline { lines, along: 0 })
}

impl Outline {
    /// Nothing yet, of the section `number`, on the drive surfaces or the part surfaces.
    pub(crate) fn new(number: f64, of_drive: bool) -> Self {
        Self {
            number,
            form: None,
            loops: vec![Vec::new()],
            open: Vec::new(),
            curved: false,
            scattered: false,
            of_drive,
            other: None,
        }
    }

    /// A motion along that surface, which is no SSURF.
    pub(crate) fn pass(&mut self, name: &str) {
        self.other.get_or_insert_with(|| name.into());
    }

    /// Corners of a curve of INTSEC.
    pub(crate) fn add_curve(
        &mut self,
        form: Option<&Arc<Form>>,
        corners: impl Iterator<Item = [f64; 2]>,
        closed: bool,
    ) {
        let from = self.loops[0].len();
        self.add(form, corners, closed);
        self.curved = true;
        if self.loops[0].len() > from {
            self.open.push([from, self.loops[0].len() - 1]);
        }
    }

    /// Corners on the surface `form`; a closed curve goes round something of its own.
    pub(crate) fn add(
        &mut self,
        form: Option<&Arc<Form>>,
        corners: impl Iterator<Item = [f64; 2]>,
        closed: bool,
    ) {
        let Some(form) = form else {
            self.scattered = true;
            return;
        };
        let known = self.form.get_or_insert_with(|| Arc::clone(form));
        self.scattered |= !same_form(known, form);
        if closed {
            self.loops.push(corners.collect());
        } else {
            self.loops[0].extend(corners);
        }
    }

    /// Lays the corners into the grid that loose patches make.
    fn lay(&mut self, joined: &Joined<'_>) -> Result<(), Failure> {
        for corners in &mut self.loops {
            let laid = joined.laid(corners);
            *corners = laid.ok_or(Failure::Joint { why: "a corner of it is in no patch" })?;
        }
        Ok(())
    }

    /// The corners as the patches tell them.
    fn told(&self, joined: &Joined<'_>) -> Vec<Vec<[f64; 2]>> {
        let told = |at: &[f64; 2]| joined.grid().told(*at);
        self.loops.iter().map(|corners| corners.iter().map(told).collect()).collect()
    }

    /// Puts corners where lines between others cross joints of the patches.
    fn cross(&mut self, joined: &Joined<'_>) -> Result<(), Failure> {
        for corners in &mut self.loops {
            *corners = joined.crossed(corners).map_err(|why| Failure::Joint { why })?;
        }
        Ok(())
    }

    /// Turns open curves of INTSEC round so that each begins on the border on which the one before ends, where curves are all that
    /// it holds besides closed ones: which way they go depends on how the normals lie. As they are where that does not lead round.
    fn join(&mut self, spans: [f64; 2]) {
        let all = &self.loops[0];
        let curves: Vec<&[[f64; 2]]> =
            self.open.iter().map(|[first, last]| &all[*first..=*last]).collect();
        if curves.iter().map(|c| c.len()).sum::<usize>() != all.len() {
            return;
        }
        let joins = |a: &Turned<'_>, b: &Turned<'_>| on_border([a.ends()[1], b.ends()[0]], spans);
        let chain = |turned: bool| {
            let mut chain: Vec<Turned<'_>> = Vec::with_capacity(curves.len());
            for curve in &curves {
                let ways = [false, true].map(|turned| Turned { curve, turned });
                let next = match chain.last() {
                    None => ways.into_iter().find(|w| w.turned == turned),
                    Some(before) => ways.into_iter().find(|w| joins(before, w)),
                };
                chain.push(next?);
            }
            joins(chain.last()?, chain.first()?).then_some(chain)
        };
        if let Some(chain) = chain(false).or_else(|| chain(true)) {
            self.loops[0] = chain.iter().flat_map(Turned::corners).collect();
        }
    }

    fn encloses(&self) -> bool {
        self.loops.iter().any(|l| l.len() >= 3)
    }

    /// Why curves of INTSEC lead nowhere for certain.
    fn astray(&self, spans: [f64; 2]) -> Option<&'static str> {
        let all = &self.loops[0];
        let leads_in = self.open.iter().any(|[_, last]| {
            let next = (last + 1) % all.len();
            let to_curve = self.open.iter().any(|[first, _]| *first == next);
            to_curve && !on_border([all[*last], all[next]], spans)
        });
        leads_in.then_some(
            "a curve of INTSEC ends at a border, and the next begins at another or is the same",
        )
    }

    /// Why curves of INTSEC hold nothing for certain. What motions go round is as they say.
    fn fault(&self, held: &[milling::Outline], spans: [f64; 2]) -> Option<&'static str> {
        if !self.curved {
            return None;
        }
        let mut lines: Vec<[[f64; 2]; 2]> = held.iter().flat_map(|o| o.lines.clone()).collect();
        lines.retain(|line| !on_border(*line, spans));
        if crosses(&lines) {
            return Some("its curves cross");
        }
        let key = |line: &[[f64; 2]; 2]| {
            let mut ends = line.map(|end| end.map(f64::to_bits));
            ends.sort_unstable();
            ends
        };
        // From the end of a closed curve to its beginning there is no way.
        let mut keys: Vec<_> = lines.iter().map(key).filter(|[a, b]| a != b).collect();
        keys.sort_unstable();
        keys.windows(2).any(|w| w[0] == w[1]).then_some("a curve is in it twice")
    }
}

/// A curve from its beginning to its end, or the other way where it is turned round.
struct Turned<'a> {
    curve: &'a [[f64; 2]],
    turned: bool,
}

impl Turned<'_> {
    fn ends(&self) -> [[f64; 2]; 2] {
        let [first, last] = [0, self.curve.len() - 1].map(|i| self.curve[i]);
        if self.turned { [last, first] } else { [first, last] }
    }

    fn corners(&self) -> impl Iterator<Item = [f64; 2]> {
        let n = self.curve.len();
        (0..n).map(move |i| self.curve[if self.turned { n - 1 - i } else { i }])
    }
}

/// Does a line run along a border of the surface?
fn on_border([a, b]: [[f64; 2]; 2], spans: [f64; 2]) -> bool {
    let near = |x: f64, to: f64| (x - to).abs() <= AT_BORDER;
    (0..2).any(|k| [0.0, spans[k]].iter().any(|to| near(a[k], *to) && near(b[k], *to)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_that_hold_nothing_for_certain_are_told() {
        let form = Arc::new(Form::Point(aptc_geometry::Vec3::zeros()));
        let square = |x: f64| [[x, x], [x + 1.0, x], [x + 1.0, x + 1.0], [x, x + 1.0], [x, x]];
        let told = |curves: &[(&[[f64; 2]], bool)]| {
            let mut outline = Outline::new(1.0, false);
            for (corners, closed) in curves {
                outline.add_curve(Some(&form), corners.iter().copied(), *closed);
            }
            let line = |l: &Vec<[f64; 2]>| {
                let next = l.iter().cycle().skip(1);
                let lines = l.iter().zip(next).map(|(a, b)| [*a, *b]).collect();
                milling::Outline { lines, along: 0 }
            };
            outline.join([4.0, 4.0]);
            let held: Vec<_> = outline.loops.iter().map(line).collect();
            outline.astray([4.0, 4.0]).or_else(|| outline.fault(&held, [4.0, 4.0]))
        };
        assert_eq!(told(&[(&square(0.5), true), (&square(2.0), true)]), None);
        assert!(told(&[(&square(0.5), true), (&square(1.0), true)]).is_some());
        assert!(told(&[(&square(0.5), true), (&square(0.5), true)]).is_some());
        // From side to side and back, each time to where it began, in a bow, and round a corner.
        let over = |y: f64| [[0.0, y], [2.0, y + 0.3], [4.0, y]];
        let back = |y: f64| [[4.0, y], [2.0, y + 0.3], [0.0, y]];
        assert_eq!(told(&[(&over(1.0), false), (&back(2.0), false)]), None);
        assert_eq!(told(&[(&[[0.0, 1.0], [1.0, 1.5], [0.0, 2.0]], false)]), None);
        // Which way round each of them goes does not matter.
        assert_eq!(told(&[(&over(1.0), false), (&over(2.0), false)]), None);
        assert_eq!(told(&[(&back(1.0), false), (&over(2.0), false)]), None);
        assert!(told(&[(&over(1.0), false), (&over(1.0), false)]).is_some());
        assert!(told(&[(&over(1.0), false), (&over(2.0), false), (&over(3.0), false)]).is_some());
        let round = [[0.0, 1.0], [0.7, 0.7], [1.0, 0.0]];
        assert!(told(&[(&over(2.0), false), (&round, false)]).is_some());
        assert!(told(&[(&[[0.0, 1.0], [0.7, 0.7], [1.0, 0.0]], false)]).is_some());
    }

    #[test]
    fn a_square_is_cut_in_and_out() {
        let form = Arc::new(Form::Point(aptc_geometry::Vec3::zeros()));
        let corners = [[1.0, 1.0], [2.0, 1.0], [2.0, 3.0], [1.0, 3.0]];
        let mut outline = Outline::new(1.0, false);
        outline.add(Some(&form), corners.iter().copied(), true);
        let clip = |inside: bool, fixed: f64| {
            let next = corners.iter().cycle().skip(1);
            let lines = corners.iter().zip(next).map(|(a, b)| [*a, *b]).collect();
            let held = vec![milling::Outline { lines, along: 0 }];
            let active =
                vec![Active { number: 1.0, inside, held, corners: Vec::new(), spans: [4.0; 2] }];
            let failed = Vec::new();
            let all = Outlines { recorded: vec![outline.clone()], active, failed };
            all.clip(&form, 0, fixed, [0.0, 4.0])
        };
        assert_eq!(clip(true, 2.0), vec![[1.0, 2.0]]);
        assert_eq!(clip(false, 2.0), vec![[0.0, 1.0], [2.0, 4.0]]);
        assert_eq!(clip(true, 5.0), Vec::<[f64; 2]>::new());
        assert_eq!(clip(false, 5.0), vec![[0.0, 4.0]]);
    }

    /// What an outline from border to border holds it holds on the borders too, though its corners lie on them but to rounding.
    #[test]
    fn lines_along_a_border_are_cut_as_those_beside_them() {
        let form = Arc::new(Form::Point(aptc_geometry::Vec3::zeros()));
        for off in [-1e-12, 0.0, 1e-12] {
            let corners = [[1.0, off], [1.5, 2.0], [1.0, 4.0 + off], [3.0, 4.0 - off], [3.0, -off]];
            // Along u and along v, with a line along u or v.
            for turned in [false, true] {
                let swap = |[u, v]: [f64; 2]| if turned { [v, u] } else { [u, v] };
                let corners = corners.map(swap);
                let mut outline = Outline::new(1.0, false);
                outline.add(Some(&form), corners.into_iter(), false);
                let next = corners.iter().cycle().skip(1);
                let lines = corners.iter().zip(next).map(|(a, b)| [*a, *b]).collect::<Vec<_>>();
                for (along, inside) in [(0, true), (0, false), (1, true), (1, false)] {
                    let held = vec![milling::Outline { lines: lines.clone(), along }];
                    let active = vec![Active {
                        number: 1.0,
                        inside,
                        held,
                        corners: Vec::new(),
                        spans: [4.0; 2],
                    }];
                    let failed = Vec::new();
                    let all = Outlines { recorded: vec![outline.clone()], active, failed };
                    for fixed in [0.0, 1e-3, 4.0 - 1e-3, 4.0] {
                        let left = all.clip(&form, usize::from(turned), fixed, [0.0, 4.0]);
                        let ends: Vec<_> =
                            if inside { vec![[1.0, 3.0]] } else { vec![[0.0, 1.0], [3.0, 4.0]] };
                        let near = |(a, b): (&[f64; 2], &[f64; 2])| {
                            (0..2).all(|k| (a[k] - b[k]).abs() < 1e-3)
                        };
                        assert!(
                            left.len() == ends.len() && left.iter().zip(&ends).all(near),
                            "{off} {turned} {along} {inside} {fixed}: {left:?}"
                        );
                    }
                }
            }
        }
    }
}
