//! A sign of life on work over a second.

use std::io::{self, IsTerminal as _};
use std::path::Path;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

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
    pub(crate) fn of(part: &Path, common: &Common) -> Self {
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
            loop {
                bar.set_message(format!("{name}, {} s", start.elapsed().as_secs()));
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

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some((stop, shown)) = self.0.take() {
            drop(stop);
            // It only draws: nothing is lost if it fell over.
            let _ = shown.join();
        }
    }
}
