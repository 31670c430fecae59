//! When a search is given up.

/// Steps after which a search ends that comes no nearer, by so much.
const PATIENCE: usize = 8;
const NEARER: f64 = 0.75;

/// Ends a search that comes no nearer.
pub(crate) struct Patience {
    least: f64,
    left: usize,
}

impl Default for Patience {
    fn default() -> Self {
        Self { least: f64::INFINITY, left: PATIENCE }
    }
}

impl Patience {
    /// Is it at an end, with so much missing now?
    pub(crate) fn ends(&mut self, missing: f64) -> bool {
        if missing < NEARER * self.least {
            *self = Self { least: missing, ..Self::default() };
            return false;
        }
        self.left -= 1;
        self.left == 0
    }
}
