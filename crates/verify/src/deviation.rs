//! A map of what regional milling leaves on a part surface or cuts into it.

use std::fmt::Write as _;
use std::sync::Arc;

use aptc_cldata::milling::Milling;
use aptc_cldata::{Control, Kind, Position, Record};
use aptc_geometry::{Profile, Sculptured, Vec3};

use crate::milled::{name_of, ways};
use crate::swath::Swath;
use crate::tool::Pose;

/// Cells along u and v, and the width of a panel in pixels.
const CELLS: [usize; 2] = [96, 64];
const WIDTH: f64 = 480.0;
const MARGIN: f64 = 24.0;
/// From what is cut in deeply to what is left standing, and what no cutter came near.
const COLORS: [&str; 7] =
    ["#a50026", "#f46d43", "#66bd63", "#c7e9b4", "#74add1", "#313695", "#cccccc"];

/// What was cut of one part surface, with one thickness on it, by one cutter.
struct Cut {
    milling: Milling,
    profile: Profile,
    ways: Vec<[Pose; 2]>,
}

/// An SVG with two panels for each part surface of regional milling and each thickness on it: the deviation over u and v, and seen from
/// above. Green is within INTOL and OUTTOL, red is cut away, blue is left, pale where a scallop is
/// allowed; what no cutter came near is grey. `None` without regional milling.
pub fn deviation_svg<'r>(records: impl IntoIterator<Item = &'r Record>) -> Option<String> {
    let cuts = collect(records);
    if cuts.is_empty() {
        return None;
    }
    let height = WIDTH * 0.75 + 3.0 * MARGIN;
    let total = height * cuts.len() as f64;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{total}\" font-family=\"sans-serif\" \
         font-size=\"12\">\n",
        2.0 * WIDTH + 3.0 * MARGIN
    );
    for (i, cut) in cuts.iter().enumerate() {
        cut.draw(&mut svg, height * i as f64);
    }
    svg.push_str("</svg>\n");
    Some(svg)
}

fn collect<'r>(records: impl IntoIterator<Item = &'r Record>) -> Vec<Cut> {
    let mut cuts: Vec<Cut> = Vec::new();
    let (mut profile, mut last): (Option<Profile>, Option<Position>) = (None, None);
    // The control of the last motion: those of one statement share it.
    let mut under: Option<&Arc<Control>> = None;
    for record in records {
        match &record.kind {
            Kind::Cutter(c) => profile = Profile::new(c).ok(),
            Kind::Motion(m) => {
                let milling = m.control.as_ref().and_then(|c| c.milling.as_ref());
                if let (Some(milling), Some(profile)) = (milling, profile)
                    && let Some(part) = &milling.part
                {
                    let goes_on =
                        m.control.as_ref().zip(under).is_some_and(|(a, b)| Arc::ptr_eq(a, b));
                    let start = last.filter(|_| milling.joined || goes_on);
                    let new = ways(&start, &m.points);
                    let same = |c: &&mut Cut| {
                        c.profile == profile
                            && c.milling.part.as_ref().is_some_and(|p| {
                                Arc::ptr_eq(&p.surface, &part.surface)
                                    && p.thick.total_cmp(&part.thick).is_eq()
                            })
                    };
                    match cuts.iter_mut().find(same) {
                        Some(cut) => cut.ways.extend(new),
                        None => cuts.push(Cut { milling: milling.clone(), profile, ways: new }),
                    }
                }
                (under, last) = (m.control.as_ref(), m.points.last().copied().or(last));
            }
            _ => {}
        }
    }
    cuts
}

impl Cut {
    fn draw(&self, svg: &mut String, top: f64) {
        let Some(part) = &self.milling.part else { return };
        let surface: &Sculptured = &part.surface;
        let swath = Swath::new(&self.profile, self.milling.on, &self.ways, f64::INFINITY);
        let [nu, nv] = surface.spans();
        let at = |i: usize, j: usize| {
            let share = [i as f64 / CELLS[0] as f64, j as f64 / CELLS[1] as f64];
            (share, surface.at(share[0] * nu, share[1] * nv).point)
        };
        let (mut lo, mut hi) = (Vec3::repeat(f64::INFINITY), Vec3::repeat(f64::NEG_INFINITY));
        for j in 0..=CELLS[1] {
            for i in 0..=CELLS[0] {
                let p = at(i, j).1;
                (lo, hi) = (lo.inf(&p), hi.sup(&p));
            }
        }
        let tall = WIDTH * 0.75;
        let scale = (WIDTH / (hi.x - lo.x)).min(tall / (hi.y - lo.y));
        let scale = if scale.is_finite() { scale } else { 1.0 };
        let (left, right) = (MARGIN, 2.0 * MARGIN + WIDTH);
        let base = top + 2.0 * MARGIN;
        let over = |s: [f64; 2]| [left + s[0] * WIDTH, base + (1.0 - s[1]) * tall];
        let above = |p: Vec3| [right + (p.x - lo.x) * scale, base + tall - (p.y - lo.y) * scale];
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        let mut cells = String::new();
        for j in 0..CELLS[1] {
            for i in 0..CELLS[0] {
                let corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                let share =
                    [(i as f64 + 0.5) / CELLS[0] as f64, (j as f64 + 0.5) / CELLS[1] as f64];
                let middle = surface.at(share[0] * nu, share[1] * nv).point;
                let deviation = self.deviation(&swath, middle, part.thick);
                if let Some(d) = deviation {
                    (least, most) = (least.min(d), most.max(d));
                }
                let color = self.color(deviation);
                for panel in [corners.map(|c| over(c.0)), corners.map(|c| above(c.1))] {
                    let _ = write!(cells, "<path fill=\"{color}\" d=\"M");
                    for [x, y] in panel {
                        let _ = write!(cells, "{x:.1},{y:.1} ");
                    }
                    cells.push_str("z\"/>\n");
                }
            }
        }
        let name = if part.thick == 0.0 {
            name_of(&part.name)
        } else {
            format!("{} with the thickness {} on it,", name_of(&part.name), part.thick)
        };
        let said = if least <= most {
            format!("deviation {least:.5} to {most:.5}")
        } else {
            "nothing is cut".to_owned()
        };
        let _ = writeln!(
            svg,
            "<text x=\"{left}\" y=\"{}\">{name} over u and v: {said}</text>\
             <text x=\"{right}\" y=\"{}\">from above</text>",
            top + MARGIN,
            top + MARGIN
        );
        svg.push_str(&cells);
        self.legend(svg, base + tall + 0.25 * MARGIN);
    }

    /// What the colours mean, in a row.
    fn legend(&self, svg: &mut String, top: f64) {
        let scallop = self.milling.scallop.as_ref().map_or(0.0, |s| s.height);
        let Milling { intol, outtol, .. } = self.milling;
        let allowed = outtol + scallop;
        let wide = (2.0 * WIDTH + MARGIN) / COLORS.len() as f64;
        let texts = [
            format!("cut in, over {:.5}", 2.0 * intol),
            format!("cut in, over {intol:.5}"),
            "within tolerance".to_owned(),
            "scallop as allowed".to_owned(),
            format!("left, over {allowed:.5}"),
            format!("left, over {:.5}", 2.0 * allowed),
            "not reached".to_owned(),
        ];
        for (i, (color, text)) in COLORS.iter().zip(texts).enumerate() {
            let left = MARGIN + wide * i as f64;
            let _ = writeln!(
                svg,
                "<rect x=\"{left:.1}\" y=\"{top:.1}\" width=\"10\" height=\"10\" fill=\"{color}\"/>\
                 <text x=\"{:.1}\" y=\"{:.1}\" font-size=\"10\">{text}</text>",
                left + 14.0,
                top + 9.0
            );
        }
    }

    /// How far the thickness on the surface is from what the cutter swept there, negative cut into; `None` where the
    /// cutter did not come near it.
    fn deviation(&self, swath: &Swath, p: Vec3, thick: f64) -> Option<f64> {
        let scallop = self.milling.scallop.as_ref().map_or(0.0, |s| s.height);
        let near = 10.0 * (self.milling.intol + self.milling.outtol + scallop);
        let found = swath.least(p, (near + thick).max(0.0));
        found.map(|b| b.0 - thick).filter(|d| *d <= near)
    }

    fn color(&self, deviation: Option<f64>) -> &'static str {
        let Milling { intol, outtol, .. } = self.milling;
        let scallop = self.milling.scallop.as_ref().map_or(0.0, |s| s.height);
        let [deep, cut, within, allowed, left, high, none] = COLORS;
        match deviation {
            None => none,
            Some(d) if d < -2.0 * intol => deep,
            Some(d) if d < -intol => cut,
            Some(d) if d <= outtol => within,
            Some(d) if d <= outtol + scallop => allowed,
            Some(d) if d <= 2.0 * (outtol + scallop) => left,
            Some(_) => high,
        }
    }
}
