//! Who does work that can be shared out.

/// Runs jobs, on threads that belong to whoever runs the Sections.
pub trait Crew: Sync {
    /// Calls `work` once for each number below `n`, in any order and on any thread.
    fn run(&self, n: usize, work: &(dyn Fn(usize) + Sync));

    /// Has the work been called off? Jobs not yet begun then end at once.
    fn is_stopped(&self) -> bool {
        false
    }
}

/// One job after the other, on the caller's thread.
#[derive(Clone, Copy, Debug)]
pub struct Alone;

impl Crew for Alone {
    fn run(&self, n: usize, work: &(dyn Fn(usize) + Sync)) {
        (0..n).for_each(work);
    }
}
