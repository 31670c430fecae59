//! Measuring: repetitions until the figure is steady, processor time, one line a figure.
//!
//! For a `[[bench]]` target with `harness = false`:
//!
//! ```no_run
//! let text = "P1 = POINT/1,2\n".repeat(1_000);
//! let mb = text.len() as f64 / 1e6;
//! aptc_testkit::bench::rate("lexer", mb, "MB/s", Some(100.0), || text.split('/').count());
//! ```
//!
//! `cargo xtask bench` collects the lines.

use std::hint::black_box;
use std::time::Instant;

/// Repetitions of a measurement, of which the best is the machine's and the rest its neighbours'.
const REPETITIONS: usize = 7;
/// A repetition shorter than this is repeated within: seconds.
const SHORTEST: f64 = 0.1;

/// Measures `work`, which does `amount` of something, and prints amount a second of processor time; `target` is the rate that is wanted.
///
/// A first argument of the program that is no part of `name` leaves it out: false.
pub fn rate<T>(
    name: &str,
    amount: f64,
    unit: &str,
    target: Option<f64>,
    mut work: impl FnMut() -> T,
) -> bool {
    let filter = std::env::args().skip(1).find(|argument| !argument.starts_with('-'));
    if filter.is_some_and(|filter| !name.contains(&filter)) {
        return false;
    }
    let mut inner = 1;
    let mut times = Vec::with_capacity(REPETITIONS);
    while times.len() < REPETITIONS {
        let start = Clock::start();
        for _ in 0..inner {
            black_box(work());
        }
        let seconds = start.seconds();
        if seconds < SHORTEST && times.is_empty() {
            inner *= 2;
        } else {
            times.push(seconds / f64::from(inner));
        }
    }
    times.sort_by(f64::total_cmp);
    figure(name, amount / times[REPETITIONS / 2], unit, target);
    true
}

/// Prints a figure that was had in another way, such as peak memory.
pub fn figure(name: &str, value: f64, unit: &str, target: Option<f64>) {
    let target = target.map_or(String::new(), |target| target.to_string());
    println!("BENCH\t{name}\t{value}\t{unit}\t{target}");
}

/// The most memory that this process has had, in MiB; `None` where the system does not tell.
pub fn peak_memory() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kib: f64 = line.trim().trim_end_matches(" kB").trim().parse().ok()?;
    Some(kib / 1024.0)
}

/// Processor seconds of all processes that this one has started and waited for, in hundredths; 0 where the system does
/// not tell.
pub fn children_seconds() -> f64 {
    let status = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // The name before stands in brackets and may hold anything.
    let fields = status.rsplit(')').next().unwrap_or_default();
    let ticks = fields.split_ascii_whitespace().skip(13).take(2);
    ticks.filter_map(|ticks| ticks.parse::<f64>().ok()).sum::<f64>() / 100.0
}

/// Processor time of the calling thread where the system tells it, else time on the wall.
struct Clock {
    wall: Instant,
    thread: Option<u64>,
}

impl Clock {
    fn start() -> Self {
        Self { wall: Instant::now(), thread: thread_nanoseconds() }
    }

    fn seconds(&self) -> f64 {
        match (self.thread, thread_nanoseconds()) {
            (Some(before), Some(after)) => {
                std::time::Duration::from_nanos(after - before).as_secs_f64()
            }
            _ => self.wall.elapsed().as_secs_f64(),
        }
    }
}

fn thread_nanoseconds() -> Option<u64> {
    let statistics = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    statistics.split_ascii_whitespace().next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_takes_time() {
        let clock = Clock::start();
        let mut sum = 0u64;
        while clock.wall.elapsed().as_millis() < 30 {
            sum = black_box(sum.wrapping_mul(31) + 1);
        }
        assert!(clock.seconds() > 0.0 && clock.seconds() < 10.0);
    }
}
