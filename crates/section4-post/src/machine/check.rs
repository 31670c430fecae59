//! Reads and checks a machine file.

use aptc_diagnostics::{Diagnostic, FileId, Span, codes};

use super::{Carries, Dialect, Machine, MachineKind, RotaryFeed};

/// Letters that every machine's `format` table must have; mills have Y too.
const NEEDED: &[char] = &['X', 'Z', 'F', 'S'];

/// Values that lines of a cycle may name.
const CYCLE_NAMES: &[&str] = &[
    "surface",
    "bottom",
    "clearance",
    "retract",
    "depth",
    "clear",
    "back",
    "step",
    "first",
    "dwell",
    "feed",
    "pitch",
    "speed",
];

/// Values that lines before a cycle may name.
const BEFORE_NAMES: &[&str] = &["speed", "pitch", "feed"];

impl Machine {
    /// The machine of a TOML text, or all that is wrong with it.
    pub fn parse(text: &str) -> Result<Self, Vec<Diagnostic>> {
        Self::parse_in(text, FileId::default())
    }

    /// As [`parse`](Self::parse), with messages that point into `file`.
    pub fn parse_in(text: &str, file: FileId) -> Result<Self, Vec<Diagnostic>> {
        let at = |range: std::ops::Range<usize>| {
            let byte = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
            Span::new(file, byte(range.start), byte(range.end))
        };
        let machine: Self = toml::from_str(text).map_err(|e| {
            let span = at(e.span().unwrap_or(0..0));
            let message = format!("machine file: {}", e.message().replace('\n', ", "));
            let help = "the keys of a machine file are described in docs/machines.md";
            vec![Diagnostic::error(codes::MACHINE_FILE, span, message).help(help)]
        })?;
        let faults = machine.faults();
        if faults.is_empty() {
            return Ok(machine);
        }
        let span = at(0..0);
        Err(faults
            .into_iter()
            .map(|f| {
                let message = format!("machine {}: {f}", machine.name);
                Diagnostic::error(codes::MACHINE_FILE, span, message)
                    .help("change this key of the machine file")
            })
            .collect())
    }

    /// What cannot be right, in words.
    fn faults(&self) -> Vec<String> {
        let mut faults = Vec::new();
        let mut say = |bad: bool, what: String| {
            if bad {
                faults.push(what);
            }
        };
        say(self.name.is_empty(), "`name` is empty".into());
        let y = (self.kind == MachineKind::Mill).then_some(&'Y');
        for letter in NEEDED.iter().chain(y) {
            let missing = self.dialect != Dialect::Apt && !self.format.contains_key(letter);
            say(missing, format!("`format` lacks {letter}"));
        }
        for (letter, f) in &self.format {
            let most = f.mm.max(f.inch.unwrap_or(0));
            say(most > 9, format!("`format.{letter}` has {most} decimals, at most 9 are possible"));
            say(!letter.is_ascii_uppercase(), format!("`format.{letter}` is no address letter"));
        }
        say(
            self.default_feed.is_some_and(|f| !positive(f)),
            "`default_feed` is not positive".into(),
        );
        say(self.rotary.len() > 2, "`rotary` has more than two axes".into());
        let spindle = self.milling.iter().map(|m| &m.rotary);
        for r in self.rotary.iter().chain(spindle) {
            let [x, y, z] = r.axis;
            let none = !positive(x * x + y * y + z * z);
            say(none, format!("`axis` of rotary {} has no direction", r.letter));
            let format = self.format.contains_key(&r.letter);
            say(
                self.dialect != Dialect::Apt && !format,
                format!("`format` lacks {}, a rotary axis", r.letter),
            );
            if let (Some(a), Some(b)) = (r.min, r.max) {
                say(
                    !positive(b - a),
                    format!("`min` of rotary {} is not below its `max`", r.letter),
                );
            }
        }
        let order = self
            .rotary
            .windows(2)
            .any(|w| w[0].carries == Carries::Tool && w[1].carries == Carries::Part);
        say(order, "`rotary`: the axes that carry the part come before those of the tool".into());
        for (letter, a) in &self.axes {
            if let (Some(low), Some(high)) = (a.min, a.max) {
                say(!positive(high - low), format!("`axes.{letter}`: min is not below max"));
            }
        }
        let m = &self.multiaxis;
        let half = m.plane_on.is_empty() != m.plane_off.is_empty();
        say(half, "`multiaxis.plane_on` and `plane_off` belong together".into());
        say(
            !m.plane_on.is_empty() && !m.tool_center,
            "`multiaxis.plane_on` needs `tool_center`: without it the axes are written anyway"
                .into(),
        );
        for (kind, cycle) in &self.cycles {
            for name in cycle.lines.iter().flat_map(|l| l.split('{').skip(1)) {
                let name = name.split('}').next().unwrap_or("");
                let known = CYCLE_NAMES.contains(&name);
                say(!known, format!("`cycles.{kind}`: {{{name}}} is no value of a cycle"));
            }
            for name in cycle.before.iter().flat_map(|l| l.split('{').skip(1)) {
                let name = name.split('}').next().unwrap_or("");
                let known = BEFORE_NAMES.contains(&name);
                say(!known, format!("`cycles.{kind}.before`: {{{name}}} is not known there"));
            }
            let two = cycle.lead.is_some() && !(cycle.lines.is_empty() && cycle.before.is_empty());
            say(two, format!("`cycles.{kind}`: `lead` goes with `code` alone"));
        }
        let lathe = self.kind == MachineKind::Lathe;
        if let Some(m) = &self.milling {
            say(!lathe, "`milling` is for lathes: a mill has it anyway".into());
            let [x, y, z] = m.rotary.axis;
            let along = x.abs() + y.abs() < 1e-9 * z.abs() && m.rotary.carries == Carries::Part;
            say(!along, "`milling.rotary` is not the spindle along Z that carries the part".into());
            say(m.multiaxis.tool_center, "`milling.multiaxis.tool_center` is not known".into());
            say(!positive(m.multiaxis.lintol), "`milling.multiaxis.lintol` is not positive".into());
            let by_time = m.multiaxis.feed == RotaryFeed::Inverse;
            let none = by_time && self.feed.inverse_time.is_empty();
            say(
                none,
                "`milling.multiaxis.feed` is inverse, and `feed.inverse_time` is empty".into(),
            );
        }
        say(lathe && !self.rotary.is_empty(), "a lathe with `rotary` axes is not known".into());
        if let Some(arcs) = &self.arcs {
            let sweep = arcs.max_sweep;
            say(
                !(1.0..=360.0).contains(&sweep),
                format!("`arcs.max_sweep` {sweep} is not within 1 to 360"),
            );
            say(!positive(arcs.radius_tolerance), "`arcs.radius_tolerance` is not positive".into());
            let fit = arcs.fit.is_finite() && arcs.fit >= 0.0;
            say(!fit, "`arcs.fit` is neither 0 nor positive".into());
        }
        say(!positive(self.rapid.feed), "`rapid.feed` is not positive".into());
        say(!positive(self.multiaxis.lintol), "`multiaxis.lintol` is not positive".into());
        say(self.program.block_numbers.step == 0, "`block_numbers.step` is zero".into());
        say(self.program.max_line < 20, "`max_line` is below 20".into());
        faults
    }
}

fn positive(n: f64) -> bool {
    n > 0.0 && n.is_finite()
}
