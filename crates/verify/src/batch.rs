//! Statements that wait to be judged, in parts that can be shared out.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Condvar, Mutex, OnceLock, PoisonError};

use aptc_cldata::{Motion, Position};
use aptc_diagnostics::Origin;

use crate::chain::Chain;
use crate::free::Rapid;
use crate::hurried::Hurried;
use crate::joined::Joined;
use crate::statement::{Answer, Share, Statement};

/// Work for any number of threads: whoever has a batch may work at it. The answers are the same whoever did it.
#[derive(Debug)]
pub struct Batch {
    pub(crate) events: Vec<Event>,
    jobs: Vec<Job>,
    /// The first job that nobody has begun.
    next: AtomicUsize,
    /// Jobs that are not done.
    open: Mutex<usize>,
    done: Condvar,
}

/// What the records tell, in their order.
#[derive(Debug)]
pub(crate) enum Event {
    /// A motion along surfaces.
    Along(Box<Statement>),
    /// Cut vectors along surfaces that the records do not tell.
    Unknown(Motion, Origin),
    /// A motion after RAPID.
    Rapid(Box<Rapid>),
    /// What GCLEAR puts behind a line.
    Behind(Box<Rapid>),
    /// Motion at feed from point to point.
    Chain(Box<Chain>),
    /// The way from DNTCUT to CUT.
    Joined(Arc<Joined>),
    /// Where the motion from point to point ends that comes next after one at rapid.
    Feed(Position),
    /// Motion along surfaces at rapid.
    Hurried(Hurried),
}

#[derive(Debug)]
struct Job {
    event: usize,
    share: Share,
    answer: OnceLock<Answer>,
}

/// Counts a job as done, also when it ends in a panic: nobody is to wait for it.
struct Counted<'b>(&'b Batch);

impl Batch {
    pub(crate) fn new(events: Vec<Event>) -> Self {
        let shares = |(event, e): (usize, &Event)| {
            let shares = if let Event::Along(s) = e { s.shares() } else { Vec::new() };
            shares.into_iter().map(move |share| Job { event, share, answer: OnceLock::new() })
        };
        let jobs: Vec<Job> = events.iter().enumerate().flat_map(shares).collect();
        let open = Mutex::new(jobs.len());
        Self { events, jobs, next: AtomicUsize::new(0), open, done: Condvar::new() }
    }

    /// Does what nobody has begun; returns when there is nothing left to begin.
    pub fn work(&self) {
        while let Some(job) = self.jobs.get(self.next.fetch_add(1, Ordering::Relaxed)) {
            let _counted = Counted(self);
            if let Some(Event::Along(statement)) = self.events.get(job.event) {
                // Each job is begun once.
                let _ = job.answer.set(statement.judge(&job.share));
            }
        }
    }

    /// Cut vectors, sampled ones too.
    pub fn vectors(&self) -> usize {
        let of = |e: &Event| if let Event::Along(s) = e { s.points.len() } else { 0 };
        self.events.iter().map(of).sum()
    }

    /// Nobody begins anything more.
    pub fn call_off(&self) {
        self.next.store(self.jobs.len(), Ordering::Relaxed);
    }

    /// Returns when all is done that somebody began.
    pub fn wait(&self) {
        let open = self.open.lock().unwrap_or_else(PoisonError::into_inner);
        let done = self.done.wait_while(open, |n| *n > 0);
        drop(done.unwrap_or_else(PoisonError::into_inner));
    }

    /// The answers of a statement, in the order of its parts.
    ///
    /// # Panics
    /// When a part of it was not done.
    pub(crate) fn answers(&self, event: usize) -> impl Iterator<Item = (&Share, &Answer)> {
        let from = self.jobs.partition_point(|j| j.event < event);
        self.jobs[from..]
            .iter()
            .take_while(move |j| j.event == event)
            .map(|j| (&j.share, j.answer.get().expect("each job is done before its answer counts")))
    }
}

impl Drop for Counted<'_> {
    fn drop(&mut self) {
        let mut open = self.0.open.lock().unwrap_or_else(PoisonError::into_inner);
        *open -= 1;
        if *open == 0 {
            self.0.done.notify_all();
        }
    }
}
