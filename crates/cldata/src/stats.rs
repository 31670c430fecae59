//! What a CL file holds in figures: moves, lengths, feeds, times, extents, tools.

use std::collections::BTreeMap;
use std::fmt::Write;

use aptc_geometry::Vec3;
use serde::Serialize;

use crate::{
    Arc, Arg, Course, Kind, Motion, MotionKind, Position, Record, Units, begins_cycle, flatten,
};

/// Different feeds and words that are listed; what is beyond is counted together.
const MOST_LISTED: usize = 200;

/// Figures of a stream.
#[derive(Debug, Default, Serialize)]
pub struct Stats {
    /// Title of the first PARTNO.
    pub title: String,
    /// Unit of all lengths here.
    pub units: Units,
    /// Records of all kinds.
    pub records: u64,
    /// Motion records.
    pub motions: u64,
    /// Positions, those of FROM included.
    pub points: u64,
    /// Arcs and helices among the motions.
    pub arcs: u64,
    /// Rapid moves and moves at feed.
    pub rapid: Moves,
    /// Moves at feed.
    pub feed: Moves,
    /// Time of the moves at feed in minutes, of those whose feed is known.
    pub feed_minutes: f64,
    /// Moves whose feed is not known.
    pub moves_without_feed: u64,
    /// Time of DELAY in seconds.
    pub dwell_seconds: f64,
    /// Positions while a cycle was on.
    pub cycle_positions: u64,
    /// Least and greatest coordinates of the tool end.
    pub extent: Option<[[f64; 3]; 2]>,
    /// Greatest angle between tool axis and z in degrees.
    pub greatest_tilt_deg: f64,
    /// Each tool in order.
    pub tools: Vec<Tool>,
    /// Each feed with the length cut by it.
    pub feeds: Vec<Feed>,
    /// How often each post-processor word stands.
    pub words: BTreeMap<String, u64>,
    /// Statements that were not understood.
    pub unread: u64,
    #[serde(skip)]
    state: State,
}

/// Number and length of moves.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Moves {
    /// How many.
    pub count: u64,
    /// Length of the way of the tool end.
    pub length: f64,
}

/// What one tool does.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Tool {
    /// Number of LOADTL and its kind, or none.
    pub number: Option<f64>,
    /// Diameter of CUTTER.
    pub diameter: Option<f64>,
    /// Rapid moves.
    pub rapid: Moves,
    /// Moves at feed.
    pub feed: Moves,
    /// Minutes at feed, as far as feeds are known.
    pub minutes: f64,
}

/// What is cut with one feed.
#[derive(Clone, Debug, Serialize)]
pub struct Feed {
    /// Value.
    pub value: f64,
    /// Unit as it was written, or empty.
    pub unit: String,
    /// Moves at it.
    pub moves: Moves,
}

/// What holds from here on.
#[derive(Debug, Default)]
struct State {
    last: Option<Position>,
    rapid: bool,
    cycle: bool,
    feed: Option<usize>,
    /// Turns a minute.
    spindle: Option<f64>,
    tool: Option<usize>,
    cutter: Option<f64>,
}

impl Stats {
    /// No figures yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Takes a record in.
    pub fn push(&mut self, record: &Record) {
        self.records += 1;
        match &record.kind {
            Kind::Text { word, text } if word == "PARTNO" && self.title.is_empty() => {
                self.title = text.trim().to_owned();
            }
            Kind::Units(u) => self.units = *u,
            Kind::Cutter(c) => self.cutter(c.diameter),
            Kind::Post { word, args } => self.post(word, args),
            Kind::Motion(m) => self.motion(m),
            Kind::Unread(_) => self.unread += 1,
            Kind::Fini => self.state.last = None,
            _ => {}
        }
    }

    fn tool(&mut self) -> &mut Tool {
        let index = *self.state.tool.get_or_insert_with(|| {
            self.tools.push(Tool { diameter: self.state.cutter, ..Tool::default() });
            self.tools.len() - 1
        });
        &mut self.tools[index]
    }

    fn cutter(&mut self, diameter: f64) {
        self.state.cutter = Some(diameter);
        let Some(index) = self.state.tool else { return };
        let tool = &mut self.tools[index];
        let unused = tool.feed.count + tool.rapid.count == 0;
        if unused || tool.diameter.is_none() {
            tool.diameter = Some(diameter);
        } else if tool.diameter.is_some_and(|d| (d - diameter).abs() > 1e-9) {
            // Another cutter without a tool change is another tool; its number may follow.
            self.state.tool = None;
        }
    }

    fn load(&mut self, number: f64) {
        let is = |t: &Tool| t.number.is_some_and(|n| (n - number).abs() < 0.5);
        if let Some(i) = self.tools.iter().position(is) {
            self.state.tool = Some(i);
            return;
        }
        if let Some(i) = self.state.tool
            && self.tools[i].number.is_none()
            && self.tools[i].feed.count + self.tools[i].rapid.count == 0
        {
            self.tools[i].number = Some(number);
            return;
        }
        if self.tools.len() < MOST_LISTED {
            let diameter = self.state.cutter.take();
            self.tools.push(Tool { number: Some(number), diameter, ..Tool::default() });
            self.state.tool = Some(self.tools.len() - 1);
        }
    }

    fn post(&mut self, word: &str, args: &[Arg]) {
        if self.words.len() < MOST_LISTED || self.words.contains_key(word) {
            *self.words.entry(word.to_owned()).or_default() += 1;
        }
        let first = args.iter().find_map(|a| match a {
            Arg::Number(x) => Some(*x),
            _ => None,
        });
        let has = |w: &str| args.iter().any(|a| matches!(a, Arg::Word(x) if x == w));
        match word {
            "RAPID" => self.state.rapid = true,
            "LOADTL" | "TURRET" | "TOOLNO" => {
                if let Some(n) = first {
                    self.load(n);
                }
            }
            "FEDRAT" => {
                if let Some(f) = first {
                    self.feed(f, args);
                }
            }
            "SPINDL" => {
                let rpm = !has("SFM") && !has("SMM") && !has("OFF");
                self.state.spindle = first.filter(|_| rpm).or(self.state.spindle);
            }
            "CYCLE" => self.state.cycle = begins_cycle(args),
            "DELAY" if !has("REV") => self.dwell_seconds += first.unwrap_or(0.0),
            _ => {}
        }
    }

    fn feed(&mut self, value: f64, args: &[Arg]) {
        let unit = args.iter().find_map(|a| match a {
            Arg::Word(w)
                if matches!(
                    w.as_str(),
                    "MMPM" | "IPM" | "MMPR" | "IPR" | "PERMIN" | "PERREV" | "FPM"
                ) =>
            {
                Some(w.as_str())
            }
            _ => None,
        });
        let unit = unit.unwrap_or("");
        let same = |f: &Feed| (f.value - value).abs() <= 1e-9 * value.abs() && f.unit == unit;
        let index = self.feeds.iter().position(same);
        self.state.feed = index.or_else(|| {
            if self.feeds.len() >= MOST_LISTED {
                return Some(self.feeds.len() - 1);
            }
            self.feeds.push(Feed { value, unit: unit.to_owned(), moves: Moves::default() });
            Some(self.feeds.len() - 1)
        });
    }

    /// The feed in lengths a minute.
    fn speed(&self) -> Option<f64> {
        let feed = &self.feeds[self.state.feed?];
        let in_mm = |mm: f64| feed.value * mm / self.units.mm();
        let speed = match feed.unit.as_str() {
            "MMPM" => in_mm(1.0),
            "IPM" => in_mm(25.4),
            "FPM" => in_mm(304.8),
            "MMPR" => in_mm(1.0) * self.state.spindle?,
            "IPR" => in_mm(25.4) * self.state.spindle?,
            "PERREV" => feed.value * self.state.spindle?,
            _ => feed.value,
        };
        (speed > 0.0).then_some(speed)
    }

    fn motion(&mut self, m: &Motion) {
        self.motions += 1;
        self.points += m.points.len() as u64;
        self.arcs += u64::from(m.arc.is_some());
        if self.state.cycle {
            self.cycle_positions += m.points.len() as u64;
        }
        for p in
            flatten::positions(m, self.state.last, 1e-3 * m.arc.map_or(1.0, |a| a.circle.radius))
        {
            self.reach(p);
        }
        let rapid = std::mem::take(&mut self.state.rapid);
        if m.kind == MotionKind::From {
            self.state.last = m.points.last().copied();
            return;
        }
        let speed = self.speed();
        for p in &m.points {
            let length = self.state.last.map_or(0.0, |l| way(m, l, *p));
            self.state.last = Some(*p);
            let add = |moves: &mut Moves| {
                moves.count += 1;
                moves.length += length;
            };
            if rapid {
                add(&mut self.rapid);
                add(&mut self.tool().rapid);
                continue;
            }
            add(&mut self.feed);
            if let Some(i) = self.state.feed {
                add(&mut self.feeds[i].moves);
            }
            let minutes = speed.map_or(0.0, |s| length / s);
            self.feed_minutes += minutes;
            self.moves_without_feed += u64::from(speed.is_none());
            let tool = self.tool();
            add(&mut tool.feed);
            tool.minutes += minutes;
        }
    }

    fn reach(&mut self, p: Position) {
        let [low, high] = self.extent.get_or_insert([[p.te.x, p.te.y, p.te.z]; 2]);
        for (i, x) in [p.te.x, p.te.y, p.te.z].into_iter().enumerate() {
            low[i] = low[i].min(x);
            high[i] = high[i].max(x);
        }
        let tilt = aptc_geometry::trig::acos_clamped(p.ta.z).to_degrees();
        self.greatest_tilt_deg = self.greatest_tilt_deg.max(tilt);
    }

    /// The figures for people.
    pub fn text(&self) -> String {
        let mut out = String::new();
        let unit = self.units.word().to_lowercase();
        let mut row = |name: &str, value: String| {
            let _ = writeln!(out, "{name:<20} {value}");
        };
        if !self.title.is_empty() {
            row("part", self.title.clone());
        }
        row("unit", unit.clone());
        row("records", self.records.to_string());
        row(
            "positions",
            format!("{} in {} motions, {} arcs", self.points, self.motions, self.arcs),
        );
        let moves = |m: &Moves| format!("{} moves, {:.3} {unit}", m.count, m.length);
        row("rapid", moves(&self.rapid));
        row("at feed", moves(&self.feed));
        let unknown = match self.moves_without_feed {
            0 => String::new(),
            n => format!(" (without {n} moves whose feed is not known)"),
        };
        row("time at feed", format!("{}{unknown}", minutes(self.feed_minutes)));
        if self.dwell_seconds > 0.0 {
            row("dwell", minutes(self.dwell_seconds / 60.0));
        }
        if self.cycle_positions > 0 {
            row("cycle positions", self.cycle_positions.to_string());
        }
        if let Some([low, high]) = self.extent {
            for (i, axis) in ["x", "y", "z"].iter().enumerate() {
                row(&format!("extent {axis}"), format!("{:.4} to {:.4}", low[i], high[i]));
            }
        }
        if self.greatest_tilt_deg > 1e-6 {
            row("greatest tilt", format!("{:.3} degrees", self.greatest_tilt_deg));
        }
        for tool in &self.tools {
            let number = tool.number.map_or("tool".to_owned(), |n| format!("tool {n}"));
            let diameter = tool.diameter.map_or(String::new(), |d| format!("diameter {d:.4}, "));
            row(&number, format!("{diameter}{}, {}", moves(&tool.feed), minutes(tool.minutes)));
        }
        for feed in &self.feeds {
            row(&format!("feed {} {}", feed.value, feed.unit), moves(&feed.moves));
        }
        for (word, n) in &self.words {
            row(word, n.to_string());
        }
        if self.unread > 0 {
            row("not understood", format!("{} statements", self.unread));
        }
        out
    }
}

fn minutes(x: f64) -> String {
    let seconds = x * 60.0;
    let (whole, rest) = ((seconds / 60.0).floor(), seconds % 60.0);
    if whole > 0.0 { format!("{whole} min {rest:.1} s") } else { format!("{rest:.1} s") }
}

/// Length of the way from `a` to `b`: along the arc when its end is what is given.
fn way(m: &Motion, a: Position, b: Position) -> f64 {
    let straight = b.te - a.te;
    match m.arc {
        Some(Arc { circle, course: Course::Sweep(angle) }) => {
            let rise = circle.axis.dot(&straight);
            let turn = angle.to_radians() * circle.radius;
            Vec3::new(turn, rise, 0.0).norm()
        }
        _ => straight.norm(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{RecordReader, TextReader};
    use aptc_diagnostics::FileId;

    fn stats(text: &str) -> Stats {
        let mut reader = TextReader::new(text.as_bytes(), crate::Dialect::Iso, FileId(0));
        let (mut stats, mut record) = (Stats::new(), Record::default());
        while reader.read(&mut record).unwrap() {
            stats.push(&record);
        }
        stats
    }

    #[test]
    fn lengths_times_and_tools() {
        let s = stats(
            "PARTNO A\nUNITS/MM\nLOADTL/3\nCUTTER/10\nSPINDL/RPM,1000,CLW\nFROM/0,0,10\nRAPID\n\
             GOTO/0,0,0\nFEDRAT/60,MMPM\nGOTO/30,0,0\nMOVARC/30,10,0,0,0,1,10,ANGLE,180\n\
             GOTO/30,20,0\nLOADTL/4\nCUTTER/5\nFEDRAT/0.1,MMPR\nGOTO/0,20,0\nDELAY/2\nFINI\n",
        );
        assert_eq!((s.motions, s.points, s.arcs), (5, 5, 1));
        assert!((s.rapid.length - 10.0).abs() < 1e-12 && s.rapid.count == 1);
        let arc = 10.0 * std::f64::consts::PI;
        assert!((s.feed.length - 60.0 - arc).abs() < 1e-9);
        assert!((s.feed_minutes - (30.0 + arc) / 60.0 - 0.3).abs() < 1e-9);
        assert_eq!(
            s.tools.iter().map(|t| (t.number, t.diameter)).collect::<Vec<_>>(),
            [(Some(3.0), Some(10.0)), (Some(4.0), Some(5.0))]
        );
        let [low, high] = s.extent.unwrap();
        assert!(low[0].abs() < 1e-12 && (high[0] - 40.0).abs() < 0.1);
        assert!(s.text().contains("time at feed"));
        let json = serde_json::to_value(&s).unwrap();
        assert_eq!(json["units"], "mm");
    }
}
