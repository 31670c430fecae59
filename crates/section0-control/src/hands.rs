//! Threads that work at the proof while the program goes on.

use std::collections::VecDeque;
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread::JoinHandle;

use aptc_verify::Batch;

use crate::threads;

/// Threads beside that of the program; they begin with the first batch and end when these are dropped.
#[derive(Debug)]
pub(crate) struct Hands {
    /// Threads in all, as asked for.
    asked: usize,
    threads: Vec<JoinHandle<()>>,
    queue: Arc<Queue>,
}

#[derive(Debug, Default)]
struct Queue {
    state: Mutex<State>,
    changed: Condvar,
}

#[derive(Debug, Default)]
struct State {
    batches: VecDeque<Arc<Batch>>,
    ended: bool,
}

impl Hands {
    /// So many with the caller's thread, 0 for as many as the machine has; none runs yet.
    pub(crate) fn new(asked: usize) -> Self {
        Self { asked, threads: Vec::new(), queue: Arc::default() }
    }

    /// Does none run?
    pub(crate) fn are_none(&self) -> bool {
        self.threads.is_empty()
    }

    /// Lets all of them work at a batch, after those that were given before.
    pub(crate) fn give(&mut self, batch: &Arc<Batch>) {
        let n = threads::count(self.asked).saturating_sub(1);
        if n == 0 {
            return;
        }
        while self.threads.len() < n {
            let queue = Arc::clone(&self.queue);
            self.threads.push(std::thread::spawn(move || queue.work()));
        }
        let mut state = self.queue.state.lock().unwrap_or_else(PoisonError::into_inner);
        state.batches.push_back(Arc::clone(batch));
        drop(state);
        self.queue.changed.notify_all();
    }
}

impl Queue {
    /// Works at the first batch, then at the next.
    fn work(&self) {
        while let Some(batch) = self.first() {
            batch.work();
            let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
            // Whoever finds first that nothing is left to begin takes it off.
            if state.batches.front().is_some_and(|b| Arc::ptr_eq(b, &batch)) {
                state.batches.pop_front();
            }
        }
    }

    fn first(&self) -> Option<Arc<Batch>> {
        let state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let idle = |s: &mut State| s.batches.is_empty() && !s.ended;
        let state = self.changed.wait_while(state, idle).unwrap_or_else(PoisonError::into_inner);
        state.batches.front().filter(|_| !state.ended).cloned()
    }
}

impl Drop for Hands {
    fn drop(&mut self) {
        let mut state = self.queue.state.lock().unwrap_or_else(PoisonError::into_inner);
        state.ended = true;
        state.batches.iter().for_each(|b| b.call_off());
        drop(state);
        self.queue.changed.notify_all();
        for thread in self.threads.drain(..) {
            // A panic of the proof was met by whoever waited for its answer.
            let _ = thread.join();
        }
    }
}
