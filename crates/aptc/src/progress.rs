//! A sign of life on work over a second.

use std::io::{self, IsTerminal as _};
use std::path::Path;
use std::sync::Arc;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use aptc_control::Passes;
use indicatif::ProgressBar;

use crate::cli::Common;

/// Work that takes no longer shows nothing.
const PATIENCE: Duration = Duration::from_secs(1);
/// Between two pictures.
const TICK: Duration = Duration::from_millis(120);

/// Shows on a terminal, after a second, what is being worked on and for how long; gone when it is dropped.
#[derive(Debug)]
pub(crate) struct Progress(Option<(Sender<()>, JoinHandle<()>)>);

impl Progress {
    /// Begins the wait.
    pub(crate) fn of(part: &Path, common: &Common, passes: Option<Arc<Passes>>) -> Self {
        if common.quiet || !io::stderr().is_terminal() {
            return Self(None);
        }
        let (stop, stopped) = channel::<()>();
        let (name, start) = (part.display().to_string(), Instant::now());
        let shown = std::thread::spawn(move || {
            let waits = |time| stopped.recv_timeout(time) == Err(RecvTimeoutError::Timeout);
            if !waits(PATIENCE) {
                return;
            }
            let bar = ProgressBar::new_spinner();
            let mut begun = None;
            loop {
                let region = passes.as_ref().map_or_else(String::new, |p| region(p, &mut begun));
                bar.set_message(format!("{name}, {} s{region}", start.elapsed().as_secs()));
                bar.tick();
                if !waits(TICK) {
                    break;
                }
            }
            bar.finish_and_clear();
        });
        Self(Some((stop, shown)))
    }
}

/// How far the passes of a region are and how long the rest will take; `begun` is when they were first seen,
/// and how many were done then.
fn region(passes: &Passes, begun: &mut Option<(Instant, usize)>) -> String {
    let (done, all) = passes.state();
    if all == 0 {
        *begun = None;
        return String::new();
    }
    let (since, before) = *begun.get_or_insert((Instant::now(), done));
    let left = left(since.elapsed(), done.saturating_sub(before), all - done.min(all));
    let left = left.map_or_else(String::new, |s| format!(", about {s} s left"));
    format!(", pass {done} of {all}{left}")
}

/// Seconds for the rest at the pace so far; none before the first is done.
fn left(gone: Duration, done: usize, rest: usize) -> Option<u64> {
    let done = u32::try_from(done).ok().filter(|n| *n > 0)?;
    let rest = u32::try_from(rest).ok()?;
    Some((gone / done).saturating_mul(rest).as_secs())
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some((stop, shown)) = self.0.take() {
            drop(stop);
            // It only draws: nothing is lost if it fell over.
            let _ = shown.join();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rest_takes_as_long_as_what_was_done() {
        assert_eq!(left(Duration::from_secs(10), 5, 20), Some(40));
        assert_eq!(left(Duration::from_secs(10), 0, 20), None);
    }
}
