//! Plots: the path of the tool as SVG in four views, coloured by tool, rapid moves dashed.

mod draw;

use aptc_cldata::{
    Arc, Arg, Kind, Motion, MotionKind, Position, Record, Units, begins_cycle, flatten,
};
use aptc_geometry::Vec3;
use smol_str::SmolStr;

/// Points kept; when there are more, every other one within a stroke is left out.
const MOST_POINTS: usize = 60_000;
/// Tools with a colour and a line in the legend of their own.
const MOST_TOOLS: usize = 24;

/// The SVG of a whole stream. Pure: the same records give the same text.
pub fn plot_svg<'a>(records: impl IntoIterator<Item = &'a Record>) -> String {
    let mut plot = Plot::new();
    for record in records {
        plot.push(record);
    }
    plot.finish()
}

/// Collects a stream for its SVG; memory does not grow with the stream.
#[derive(Default)]
pub struct Plot {
    title: SmolStr,
    units: Units,
    tools: Vec<Tool>,
    tool: usize,
    strokes: Vec<Stroke>,
    n_points: usize,
    holes: Vec<(usize, Vec3)>,
    labels: Vec<(Vec3, String)>,
    start: Option<Vec3>,
    /// Lines of surfaces and curves, that no tool goes along.
    lines: Vec<Vec<Vec3>>,
    n_drawn: usize,
    last: Option<Position>,
    rapid: bool,
    cycle: bool,
    /// NOPLOT: nothing is to be drawn.
    off: bool,
    /// Diameter of a CUTTER since the last tool change.
    cutter: Option<f64>,
    low: Option<Vec3>,
    high: Option<Vec3>,
    length: [f64; 2],
}

/// A tool of the legend.
struct Tool {
    name: String,
    diameter: Option<f64>,
    used: bool,
}

/// Points of one tool, at feed or rapid.
struct Stroke {
    tool: usize,
    rapid: bool,
    points: Vec<Vec3>,
}

impl Plot {
    /// A plot of nothing yet.
    pub fn new() -> Self {
        let tools = vec![Tool { name: "cutter".into(), diameter: None, used: false }];
        Self { tools, ..Self::default() }
    }

    /// Takes a record in.
    pub fn push(&mut self, record: &Record) {
        match &record.kind {
            Kind::Text { word, text } if word == "PARTNO" && self.title.is_empty() => {
                self.title = text.trim().into();
            }
            Kind::Units(u) => self.units = *u,
            Kind::Cutter(c) => self.cutter(c.diameter),
            Kind::Post { word, args } => self.post(word, args),
            Kind::Motion(m) => self.motion(m),
            Kind::Fini => self.last = None,
            _ => {}
        }
    }

    /// Draws a line of a surface or a curve (PLOTFT), in part coordinates; a single point is a mark. Many lines are
    /// drawn with fewer points.
    pub fn line(&mut self, points: &[Vec3]) {
        let finite = points.iter().all(|p| p.iter().all(|x| x.is_finite()));
        if !finite || points.is_empty() {
            return;
        }
        for p in points {
            self.holds(*p);
        }
        self.lines.push(points.to_vec());
        self.n_drawn += points.len();
        if self.n_drawn > 2 * MOST_POINTS {
            too_many(&mut self.lines);
            self.n_drawn = self.lines.iter_mut().map(thinned).sum();
        }
    }

    fn holds(&mut self, p: Vec3) {
        self.low = Some(self.low.map_or(p, |l| l.inf(&p)));
        self.high = Some(self.high.map_or(p, |h| h.sup(&p)));
    }

    /// The SVG.
    pub fn finish(self) -> String {
        draw::svg(&self)
    }

    fn cutter(&mut self, diameter: f64) {
        self.cutter = Some(diameter);
        let tool = &mut self.tools[self.tool];
        match tool.diameter {
            // The cutter of a tool that was loaded before it was described, or the first cutter.
            None if !tool.used => tool.diameter = Some(diameter),
            Some(d) if (d - diameter).abs() < 1e-9 => {}
            _ => {
                let name = format!("tool {}", self.tools.len());
                self.select(&name);
                self.tools[self.tool].diameter = Some(diameter);
            }
        }
    }

    fn select(&mut self, name: &str) {
        if let Some(i) = self.tools.iter().position(|t| t.name == name) {
            self.tool = i;
        } else if self.tools.len() < MOST_TOOLS {
            // A cutter that was described before its tool was loaded.
            let current = &mut self.tools[self.tool];
            if !current.used {
                name.clone_into(&mut current.name);
                self.cutter = None;
                return;
            }
            let diameter = self.cutter.take();
            self.tools.push(Tool { name: name.into(), diameter, used: false });
            self.tool = self.tools.len() - 1;
        }
    }

    fn post(&mut self, word: &str, args: &[Arg]) {
        match (word, args) {
            ("RAPID", _) => self.rapid = true,
            ("LOADTL" | "TURRET" | "TOOLNO", [Arg::Number(n), ..]) => {
                self.select(&format!("T{n}"));
            }
            ("CYCLE", args) => self.cycle = begins_cycle(args),
            ("NOPLOT", _) => self.off = true,
            ("PLOT" | "OVPLOT", _) => self.off = false,
            ("PLABEL", args) => {
                let text: Vec<String> = args
                    .iter()
                    .map(|a| match a {
                        Arg::Number(x) => x.to_string(),
                        Arg::Word(w) => w.to_string(),
                        Arg::Text(t) => t.to_string(),
                        Arg::Form { name, .. } => name.name.to_string(),
                    })
                    .collect();
                if let Some(p) = self.last
                    && self.labels.len() < 200
                {
                    self.labels.push((p.te, text.join(" ")));
                }
            }
            _ => {}
        }
    }

    fn motion(&mut self, m: &Motion) {
        let rapid = std::mem::take(&mut self.rapid) || self.cycle;
        if self.off {
            self.last = m.points.last().copied().or(self.last);
            return;
        }
        let radius = m.arc.map_or(0.0, |a: Arc| a.circle.radius);
        let points = flatten::positions(m, self.last, 2e-3 * radius);
        for p in points {
            if !(p.te.x.is_finite() && p.te.y.is_finite() && p.te.z.is_finite()) {
                continue;
            }
            self.holds(p.te);
            if let Some(last) = self.last {
                self.length[usize::from(rapid)] += (p.te - last.te).norm();
            }
            if m.kind == MotionKind::From {
                self.start.get_or_insert(p.te);
            } else {
                self.to(p.te, rapid);
            }
            if self.cycle && self.holes.len() < MOST_POINTS {
                self.holes.push((self.tool, p.te));
            }
            self.last = Some(p);
        }
    }

    fn to(&mut self, te: Vec3, rapid: bool) {
        self.tools[self.tool].used = true;
        let tool = self.tool;
        let from = self.last.map(|p| p.te);
        match self.strokes.last_mut() {
            Some(s) if s.tool == tool && s.rapid == rapid && s.points.last().copied() == from => {
                s.points.push(te);
            }
            _ => {
                let points = from.into_iter().chain([te]).collect();
                self.strokes.push(Stroke { tool, rapid, points });
            }
        }
        self.n_points += 1;
        if self.n_points > 2 * MOST_POINTS {
            self.thin();
        }
    }

    /// Leaves out every other point within the strokes, and strokes that have become too many.
    fn thin(&mut self) {
        too_many(&mut self.strokes);
        self.n_points = self.strokes.iter_mut().map(|s| thinned(&mut s.points)).sum();
    }
}

/// Leaves out every other one where there are too many, but for the last.
fn too_many<T>(all: &mut Vec<T>) {
    let n = all.len();
    if n > MOST_POINTS {
        let mut i = 0;
        all.retain(|_| {
            i += 1;
            i % 2 == 0 || i == n
        });
    }
}

/// Leaves out every other point but for the first and the last; how many are left.
fn thinned(points: &mut Vec<Vec3>) -> usize {
    let n = points.len();
    let mut i = 0;
    points.retain(|_| {
        i += 1;
        i == n || i % 2 == 1
    });
    points.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn goto(x: f64, y: f64, z: f64) -> Record {
        let points = vec![Position::upright(Vec3::new(x, y, z))];
        Record { kind: Kind::Motion(Motion { points, ..Motion::default() }), ..Record::default() }
    }

    fn post(word: &str, args: Vec<Arg>) -> Record {
        Record { kind: Kind::Post { word: word.into(), args }, ..Record::default() }
    }

    #[test]
    fn tools_and_rapids_are_told_apart() {
        let program = [
            post("LOADTL", vec![Arg::Number(3.0)]),
            post("RAPID", vec![]),
            goto(0.0, 0.0, 10.0),
            goto(0.0, 0.0, 0.0),
            goto(50.0, 0.0, 0.0),
            post("LOADTL", vec![Arg::Number(4.0)]),
            goto(50.0, 30.0, 0.0),
        ];
        let mut plot = Plot::new();
        program.iter().for_each(|r| plot.push(r));
        assert_eq!(plot.tools.iter().map(|t| t.name.as_str()).collect::<Vec<_>>(), ["T3", "T4"]);
        assert_eq!(plot.strokes.iter().filter(|s| s.rapid).count(), 1);
        let svg = plot.finish();
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
        assert!(svg.contains("T3") && svg.contains("T4") && svg.contains("rapid"));
        assert_eq!(svg, plot_svg(&program));
    }

    #[test]
    fn from_hole_to_hole_it_goes_at_rapid() {
        let word = |w: &str| vec![Arg::Word(w.into())];
        let program = [
            goto(0.0, 0.0, 10.0),
            post("CYCLE", word("DRILL")),
            goto(20.0, 0.0, 10.0),
            goto(40.0, 0.0, 10.0),
            post("CYCLE", word("NOMORE")),
            goto(40.0, 30.0, 10.0),
        ];
        let mut plot = Plot::new();
        program.iter().for_each(|r| plot.push(r));
        assert_eq!((plot.length, plot.holes.len()), ([30.0, 40.0], 2));
    }

    #[test]
    fn lines_of_a_surface_are_drawn_below_the_path() {
        let mut plot = Plot::new();
        plot.line(&[Vec3::zeros(), Vec3::new(10.0, 0.0, 0.0), Vec3::new(10.0, 5.0, 1.0)]);
        plot.line(&[Vec3::new(3.0, 3.0, 0.0)]);
        plot.line(&[Vec3::new(f64::NAN, 3.0, 0.0)]);
        assert_eq!(plot.lines.len(), 2);
        plot.push(&goto(0.0, 0.0, 0.0));
        plot.push(&goto(10.0, 0.0, 5.0));
        let svg = plot.finish();
        let [line, path] = ["class=\"drawn\"", "class=\"feed\""].map(|c| svg.find(c).unwrap());
        assert!(line < path && svg.contains("surface lines"));
        assert!(!svg.contains("NaN"));
    }

    #[test]
    fn many_lines_are_drawn_with_fewer_points() {
        let mut plot = Plot::new();
        let line: Vec<Vec3> = (0..=1000).map(|i| Vec3::new(f64::from(i), 0.0, 0.0)).collect();
        for _ in 0..1000 {
            plot.line(&line);
        }
        assert_eq!(plot.lines.len(), 1000);
        assert!(plot.n_drawn <= 2 * MOST_POINTS);
        assert!(plot.lines.iter().all(|l| (l[0], l[l.len() - 1]) == (line[0], line[1000])));
    }

    #[test]
    fn nothing_and_a_point_can_be_drawn() {
        for program in [vec![], vec![goto(1.0, 1.0, 1.0)]] {
            let svg = plot_svg(&program);
            assert!(svg.contains("</svg>") && !svg.contains("NaN") && !svg.contains("inf"));
        }
    }

    #[test]
    fn a_long_path_makes_no_long_picture() {
        let mut plot = Plot::new();
        let mut record = goto(0.0, 0.0, 0.0);
        for i in 0..400_000 {
            let t = f64::from(i);
            if let Kind::Motion(m) = &mut record.kind {
                m.points[0].te = Vec3::new(t % 977.0, t % 1013.0, t % 7.0);
            }
            plot.push(&record);
        }
        assert!(plot.n_points <= 2 * MOST_POINTS);
        assert!(plot.finish().len() < 8 << 20);
    }
}
