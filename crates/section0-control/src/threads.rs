//! Threads for work that can be shared out, with what is told of it.

use std::num::NonZero;
use std::sync::LazyLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use aptc_regional::Crew;

use crate::Options;
use crate::compile::Clock;

/// How far the passes of the region that is being milled are; whoever shows progress reads it.
#[derive(Debug, Default)]
pub struct Passes {
    done: AtomicUsize,
    all: AtomicUsize,
}

impl Passes {
    /// Passes that are milled, and all of the region; 0 of 0 when none is being milled.
    pub fn state(&self) -> (usize, usize) {
        (self.done.load(Ordering::Relaxed), self.all.load(Ordering::Relaxed))
    }
}

/// The threads of this machine: asking the system for them reads a dozen files, which a short run would notice.
static OWN: LazyLock<usize> =
    LazyLock::new(|| std::thread::available_parallelism().map_or(1, NonZero::get));

/// The threads that `asked` stands for: 0 is as many as the machine has.
pub(crate) fn count(asked: usize) -> usize {
    if asked > 0 { asked } else { *OWN }
}

/// The threads of a run for the passes of a region.
#[derive(Debug)]
pub(crate) struct Threads<'o> {
    /// As asked for; 0 is as many as the machine has.
    n: usize,
    clock: Clock,
    passes: Option<&'o Passes>,
}

impl<'o> Threads<'o> {
    pub(crate) fn new(options: &'o Options, clock: Clock) -> Self {
        Self { n: options.threads, clock, passes: options.passes.as_deref() }
    }

    /// Threads beside the running one that `n` pieces of work can use.
    fn others(&self, n: usize) -> usize {
        if n < 2 {
            return 0;
        }
        count(self.n).min(n) - 1
    }

    fn told(&self, done: usize, all: usize) {
        if let Some(p) = self.passes {
            p.all.store(all, Ordering::Relaxed);
            p.done.store(done, Ordering::Relaxed);
        }
    }
}

impl Crew for Threads<'_> {
    fn run(&self, n: usize, work: &(dyn Fn(usize) + Sync)) {
        let (next, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
        self.told(0, n);
        let one = || {
            loop {
                let i = next.fetch_add(1, Ordering::Relaxed);
                if i >= n {
                    break;
                }
                work(i);
                self.told(done.fetch_add(1, Ordering::Relaxed) + 1, n);
            }
        };
        let others = self.others(n);
        std::thread::scope(|s| {
            for _ in 0..others {
                s.spawn(one);
            }
            one();
        });
        self.told(0, 0);
    }

    fn is_stopped(&self) -> bool {
        self.clock.is_over()
    }
}
