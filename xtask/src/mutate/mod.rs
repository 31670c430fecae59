//! One-token changes over the corpus: the compiler neither panics nor hangs, and says where the mistake is.

mod program;

use std::io::Read as _;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::random::Random;
use crate::repository::{cargo, files, read, root};
use program::{Mutant, Program};

/// A check of a program that takes longer hangs.
const LONGEST: Duration = Duration::from_secs(10);
/// How often the first message must stand on the changed statement.
const LEAST_SHARE: f64 = 0.9;

/// What became of a mutant.
enum Outcome {
    Legal,
    /// The first error stands on the changed statement.
    Found,
    /// It stands elsewhere: line and message.
    Elsewhere(u64, String),
    Panicked(String),
    Hung,
}

/// Runs the chore with its options `[N] [--seed S]`.
pub(crate) fn run(options: &[&str]) -> Result<(), String> {
    let (n, seed) = parse(options)?;
    let programs = programs()?;
    let aptc = build()?;
    let folder = std::env::temp_dir().join(format!("aptc-mutate-{}", std::process::id()));
    let work = Work { programs, aptc, folder, n, seed, next: AtomicUsize::new(0) };
    std::fs::create_dir_all(&work.folder).map_err(|e| format!("{}: {e}", work.folder.display()))?;
    let report = Mutex::new(Report::default());
    let workers = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for worker in 0..workers {
            let (work, report) = (&work, &report);
            scope.spawn(move || work.run(worker, report));
        }
    });
    std::fs::remove_dir_all(&work.folder).map_err(|e| format!("{}: {e}", work.folder.display()))?;
    report.into_inner().expect("no worker panics").conclude()
}

fn parse(options: &[&str]) -> Result<(usize, u64), String> {
    let (mut n, mut seed) = (1_000, 1);
    let mut options = options.iter();
    while let Some(option) = options.next() {
        let wrong = || format!("mutate does not know `{option}`");
        if *option == "--seed" {
            seed = options.next().and_then(|s| s.parse().ok()).ok_or("--seed needs a number")?;
        } else {
            n = option.parse().map_err(|_| wrong())?;
        }
    }
    Ok((n, seed))
}

fn programs() -> Result<Vec<(PathBuf, Program)>, String> {
    let mut programs = Vec::new();
    for path in files()? {
        if path.starts_with("corpus") && path.ends_with("program.apt") {
            let text = read(&root().join(&path))?;
            // A program that shows a mistake would answer for its own one, not for ours.
            let wrong = text.contains("$$ ERROR");
            programs.extend(Program::new(text).filter(|_| !wrong).map(|program| (path, program)));
        }
    }
    if programs.is_empty() { Err("the corpus has no program".to_owned()) } else { Ok(programs) }
}

/// Builds the compiler and asks cargo where it put it.
fn build() -> Result<PathBuf, String> {
    let output = cargo()
        .args(["build", "--package", "aptc", "--message-format", "json-render-diagnostics"])
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| format!("cargo does not start: {error}"))?;
    let messages = String::from_utf8_lossy(&output.stdout);
    let programs = messages.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    let built = programs.filter_map(|m| m["executable"].as_str().map(PathBuf::from)).next_back();
    built.filter(|_| output.status.success()).ok_or_else(|| "aptc does not build".to_owned())
}

struct Work {
    programs: Vec<(PathBuf, Program)>,
    aptc: PathBuf,
    folder: PathBuf,
    n: usize,
    seed: u64,
    next: AtomicUsize,
}

impl Work {
    fn run(&self, worker: usize, report: &Mutex<Report>) {
        let file = self.folder.join(format!("mutant{worker}.apt"));
        loop {
            let number = self.next.fetch_add(1, Ordering::Relaxed);
            if number >= self.n {
                return;
            }
            let (path, program) = &self.programs[number % self.programs.len()];
            let mut random = Random::new(self.seed << 32 | u64::try_from(number).unwrap_or(0));
            let mutant = program.mutate(&mut random);
            let outcome = self.check(&file, path, &mutant);
            report.lock().expect("no worker panics").take(path, &mutant, outcome);
        }
    }

    fn check(&self, file: &Path, original: &Path, mutant: &Mutant) -> Outcome {
        let failed = |error: std::io::Error| Outcome::Panicked(error.to_string());
        if let Err(error) = std::fs::write(file, &mutant.text) {
            return failed(error);
        }
        let includes = root().join(original.parent().unwrap_or(original));
        let started = Command::new(&self.aptc)
            .args(["check", "--message-format", "json", "--include"])
            .arg(includes)
            .arg(file)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn();
        match started.and_then(finish) {
            Err(error) => failed(error),
            Ok(None) => Outcome::Hung,
            Ok(Some((code, output))) => judge(code, &output, &mutant.statement),
        }
    }
}

/// Exit code (none for a signal) and all that was said, or `None` after too long a time.
fn finish(mut child: Child) -> std::io::Result<Option<(Option<i32>, String)>> {
    let start = Instant::now();
    let (stdout, stderr) = (child.stdout.take(), child.stderr.take());
    std::thread::scope(|scope| {
        let said = scope.spawn(|| {
            let mut text = Vec::new();
            stdout.map(|mut s| s.read_to_end(&mut text)).transpose().map(|_| text)
        });
        let complained = scope.spawn(|| {
            let mut text = Vec::new();
            stderr.map(|mut s| s.read_to_end(&mut text)).transpose().map(|_| text)
        });
        let status = loop {
            if let Some(status) = child.try_wait()? {
                break status;
            }
            if start.elapsed() > LONGEST {
                child.kill()?;
                child.wait()?;
                return Ok(None);
            }
            std::thread::sleep(Duration::from_millis(2));
        };
        let mut text = said.join().expect("reading does not panic")?;
        text.push(b'\n');
        text.extend(complained.join().expect("reading does not panic")?);
        Ok(Some((status.code(), String::from_utf8_lossy(&text).into_owned())))
    })
}

/// Exit codes 0, 1 and 3 are answers; anything else is our fault.
fn judge(code: Option<i32>, output: &str, statement: &Range<usize>) -> Outcome {
    if !matches!(code, Some(0 | 1 | 3)) || output.contains("panicked at") {
        let line = output.lines().find(|line| line.contains("panicked") || !line.is_empty());
        return Outcome::Panicked(format!("{code:?}: {}", line.unwrap_or_default()));
    }
    let messages = output.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    let Some(error) = messages.into_iter().find(|message| message["severity"] == "error") else {
        return Outcome::Legal;
    };
    let line = error["line"].as_u64().unwrap_or(0);
    let last = error["end_line"].as_u64().unwrap_or(line).max(line);
    let lines =
        u64::try_from(statement.start).unwrap_or(0)..u64::try_from(statement.end).unwrap_or(0);
    if line < lines.end && last >= lines.start {
        return Outcome::Found;
    }
    let text = |key: &str| error[key].as_str().unwrap_or_default().to_owned();
    Outcome::Elsewhere(line, format!("{} {}", text("code"), text("message")))
}

#[derive(Default)]
struct Report {
    n: usize,
    legal: usize,
    found: usize,
    elsewhere: usize,
    faults: usize,
}

impl Report {
    fn take(&mut self, path: &Path, mutant: &Mutant, outcome: Outcome) {
        let place = || format!("{} {}", path.display(), mutant.change);
        self.n += 1;
        match outcome {
            Outcome::Legal => self.legal += 1,
            Outcome::Found => self.found += 1,
            Outcome::Elsewhere(line, message) => {
                self.elsewhere += 1;
                println!("elsewhere  {}\n           line {line}: {message}", place());
            }
            Outcome::Panicked(message) => {
                self.faults += 1;
                println!("PANIC      {}\n           {message}", place());
            }
            Outcome::Hung => {
                self.faults += 1;
                println!("HANG       {}", place());
            }
        }
    }

    fn conclude(&self) -> Result<(), String> {
        let illegal = self.found + self.elsewhere;
        let share = if illegal == 0 { 1.0 } else { ratio(self.found, illegal) };
        println!(
            "{} changes: {} legal, {illegal} illegal, first message on the changed statement in {:.1} %, \
             {} panics or hangs",
            self.n,
            self.legal,
            100.0 * share,
            self.faults
        );
        if self.faults > 0 || share < LEAST_SHARE {
            return Err(
                "mutate: the compiler must not panic or hang, and find nine mistakes of ten"
                    .to_owned(),
            );
        }
        Ok(())
    }
}

#[expect(clippy::cast_precision_loss, reason = "counts of some thousands")]
fn ratio(part: usize, whole: usize) -> f64 {
    part as f64 / whole as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_error_decides() {
        let said = |line: u64| {
            format!(
                "{{\"severity\":\"warning\",\"line\":1}}\n{{\"severity\":\"error\",\"line\":{line},\
                 \"end_line\":{line},\"code\":\"APT1001\",\"message\":\"m\"}}\n"
            )
        };
        assert!(matches!(judge(Some(1), &said(4), &(3..5)), Outcome::Found));
        assert!(matches!(judge(Some(1), &said(5), &(3..5)), Outcome::Elsewhere(5, _)));
        assert!(matches!(judge(Some(0), "", &(3..5)), Outcome::Legal));
        assert!(matches!(judge(Some(101), "", &(3..5)), Outcome::Panicked(_)));
        assert!(matches!(judge(None, "", &(3..5)), Outcome::Panicked(_)));
    }
}
