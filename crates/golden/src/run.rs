//! Runs the cases and compares or blesses their goldens.

use std::fmt;
use std::fs;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::case::{Case, discover};
use crate::compare::{Change, change};
use crate::expected;
use crate::report::{Fault, Report};

/// A stage that leaves a golden.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// Section 1: the numeric part program.
    Protap,
    /// Section 2: CL text.
    Cl,
    /// Section 3: CL text, where it differs from Section 2's.
    EditedCl,
    /// Section 4: machine code.
    Nc,
    /// The messages.
    Diag,
}

impl Stage {
    /// All, in the order of the road.
    pub const ALL: [Self; 5] = [Self::Protap, Self::Cl, Self::EditedCl, Self::Nc, Self::Diag];

    /// Name of the golden.
    pub const fn file(self) -> &'static str {
        match self {
            Self::Protap => "program.protap",
            Self::Cl => "program.cl",
            Self::EditedCl => "program.edited.cl",
            Self::Nc => "program.nc",
            Self::Diag => "program.diag",
        }
    }
}

/// A message as goldens know it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Message {
    /// `error`, `warning` or `note`.
    pub severity: &'static str,
    /// `APT1050`.
    pub code: String,
    /// Line, from 1; 0 for a message about no line of the program.
    pub line: u32,
    /// First and last column, from 1.
    pub columns: (u32, u32),
    /// The message itself.
    pub text: String,
    /// Labels, notes and help, a line each.
    pub more: String,
}

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ((first, last), Self { severity, code, line, text, more, .. }) = (self.columns, self);
        write!(f, "line {line}: {severity} {code} {first}-{last} {text}")?;
        more.lines().try_for_each(|line| write!(f, "\n    {line}"))
    }
}

/// What the compiler made of a case; a stage that gave nothing is `None`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Outputs {
    /// PROTAP text.
    pub protap: Option<String>,
    /// CL text before Section 3.
    pub cl: Option<String>,
    /// CL text after Section 3.
    pub edited_cl: Option<String>,
    /// Machine code.
    pub nc: Option<String>,
    /// All messages.
    pub messages: Vec<Message>,
}

impl Outputs {
    fn golden(&self, stage: Stage) -> Option<String> {
        match stage {
            Stage::Protap => self.protap.clone(),
            Stage::Cl => self.cl.clone(),
            Stage::EditedCl => self.edited_cl.clone().filter(|_| self.edited_cl != self.cl),
            Stage::Nc => self.nc.clone(),
            Stage::Diag => {
                let lines = self.messages.iter().map(|message| format!("{message}\n"));
                (!self.messages.is_empty()).then(|| lines.collect())
            }
        }
    }
}

/// What to do about goldens.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Report those that differ.
    Compare,
    /// Write them anew and remove orphans.
    Bless,
}

/// Compiles every case below `root` whose name contains `filter`, several side by side, and holds the
/// results against the goldens.
///
/// # Errors
/// When a folder or file cannot be read or written, or `compile` fails. What is wrong with a case is in the report.
pub fn run(
    root: &Path,
    filter: &str,
    mode: Mode,
    compile: impl Fn(&Case) -> Result<Outputs, String> + Sync,
) -> Result<Report, String> {
    let cases = discover(root, filter)?;
    let outputs = compile_all(&cases, compile);
    let mut report = Report::default();
    for (case, outputs) in cases.into_iter().zip(outputs) {
        let outputs = outputs?;
        let program = fs::read(&case.program).map_err(|error| named(&case.program, &error))?;
        let expected = expected::parse(&String::from_utf8_lossy(&program));
        let (missing, unexpected) = expected::differences(&expected, &outputs.messages);
        let mut faults: Vec<Fault> = missing.into_iter().map(Fault::NoMessage).collect();
        faults.extend(unexpected.into_iter().map(Fault::Unexpected));
        for stage in Stage::ALL {
            let path = case.goldens.join(stage.file());
            faults.extend(hold(stage, &path, outputs.golden(stage), mode)?);
        }
        report.add(case.name, faults);
    }
    Ok(report)
}

fn compile_all(
    cases: &[Case],
    compile: impl Fn(&Case) -> Result<Outputs, String> + Sync,
) -> Vec<Result<Outputs, String>> {
    let workers = std::thread::available_parallelism().map_or(1, usize::from);
    let next = AtomicUsize::new(0);
    let mut outputs: Vec<(usize, Result<Outputs, String>)> = std::thread::scope(|scope| {
        let work = || {
            let numbers = std::iter::repeat_with(|| next.fetch_add(1, Ordering::Relaxed));
            let mine = numbers.take_while(|number| *number < cases.len());
            mine.map(|number| (number, compile(&cases[number]))).collect::<Vec<_>>()
        };
        let workers: Vec<_> = (0..workers).map(|_| scope.spawn(work)).collect();
        let joined = workers.into_iter().map(|worker| worker.join());
        joined
            .flat_map(|done| done.unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
            .collect()
    });
    outputs.sort_by_key(|(number, _)| *number);
    outputs.into_iter().map(|(_, outputs)| outputs).collect()
}

/// Holds one result against its golden, or makes it the golden.
fn hold(
    stage: Stage,
    path: &Path,
    new: Option<String>,
    mode: Mode,
) -> Result<Option<Fault>, String> {
    let golden = match fs::read_to_string(path) {
        Ok(text) => Some(text),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => None,
        Err(error) => return Err(named(path, &error)),
    };
    let fault = match (&golden, &new) {
        (None, None) => return Ok(None),
        (Some(_), None) => Fault::Orphan(stage),
        (None, Some(_)) => Fault::NoGolden(stage),
        (Some(golden), Some(new)) => match change(stage, golden, new) {
            Change::None => return Ok(None),
            Change::Digits { line } => Fault::Digits(stage, line),
            Change::Cosmetic { line } => Fault::Cosmetic(stage, line),
            Change::Real { line, golden, new } => Fault::Changed { stage, line, golden, new },
        },
    };
    if mode == Mode::Compare {
        return Ok(Some(fault));
    }
    let written = match new {
        Some(text) => {
            path.parent().map_or(Ok(()), fs::create_dir_all).and_then(|()| fs::write(path, text))
        }
        None => fs::remove_file(path),
    };
    written.map_err(|error| named(path, &error))?;
    Ok(Some(Fault::Blessed(Box::new(fault))))
}

fn named(path: &Path, error: &std::io::Error) -> String {
    format!("{}: {error}", path.display())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn case() -> tempfile::TempDir {
        let root = tempfile::tempdir().unwrap();
        fs::create_dir(root.path().join("a")).unwrap();
        fs::write(root.path().join("a/program.apt"), "$$ WARNING APT1042\nP1=POINT/1,2\nFINI\n")
            .unwrap();
        root
    }

    fn outputs(cl: &str) -> Outputs {
        let message = Message {
            severity: "warning",
            code: "APT1042".to_owned(),
            line: 2,
            columns: (1, 2),
            text: "never used".to_owned(),
            more: "help: remove it".to_owned(),
        };
        let cl = Some(cl.to_owned());
        Outputs { edited_cl: cl.clone(), cl, messages: vec![message], ..Outputs::default() }
    }

    fn faults(root: &Path, mode: Mode, outputs: &Outputs) -> Vec<String> {
        let report = run(root, "", mode, |_| Ok(outputs.clone())).unwrap();
        report.faults().map(|(_, fault)| fault.to_string()).collect()
    }

    #[test]
    fn goldens_are_blessed_and_then_hold() {
        let root = case();
        let made = outputs("GOTO/1,2,3\n");
        assert_eq!(faults(root.path(), Mode::Compare, &made).len(), 2);
        assert_eq!(faults(root.path(), Mode::Bless, &made).len(), 2);
        assert_eq!(faults(root.path(), Mode::Compare, &made), [""; 0]);
        assert!(!root.path().join("a/program.edited.cl").exists());
        let diag = fs::read_to_string(root.path().join("a/program.diag")).unwrap();
        assert_eq!(diag, "line 2: warning APT1042 1-2 never used\n    help: remove it\n");
        assert!(run(root.path(), "", Mode::Compare, |_| Ok(made.clone())).unwrap().is_good());
    }

    #[test]
    fn missing_changed_and_orphaned_goldens_fail() {
        let root = case();
        faults(root.path(), Mode::Bless, &outputs("GOTO/1,2,3\n"));
        assert_eq!(
            faults(root.path(), Mode::Compare, &outputs("GOTO/1,2,4\n")),
            ["program.cl line 1: `GOTO/1,2,3` became `GOTO/1,2,4`"]
        );
        let cosmetic =
            run(root.path(), "", Mode::Compare, |_| Ok(outputs("$$ LINE 7\nGOTO/1, 2,3\n")))
                .unwrap();
        assert!(!cosmetic.is_good() && cosmetic.is_cosmetic());
        let silent = Outputs { messages: Vec::new(), ..outputs("GOTO/1,2,3\n") };
        assert_eq!(
            faults(root.path(), Mode::Compare, &silent),
            [
                "no message: line 2: warning APT1042",
                "program.diag is an orphan: nothing was made of it"
            ]
        );
        fs::remove_file(root.path().join("a/program.cl")).unwrap();
        let made = outputs("GOTO/1,2,3\n");
        assert_eq!(faults(root.path(), Mode::Compare, &made), ["program.cl is missing"]);
    }

    #[test]
    fn unexpected_messages_are_not_blessed_away() {
        let root = case();
        let mut made = outputs("GOTO/1,2,3\n");
        made.messages[0].severity = "error";
        faults(root.path(), Mode::Bless, &made);
        let report = run(root.path(), "", Mode::Bless, |_| Ok(made.clone())).unwrap();
        assert!(!report.is_good());
    }
}
