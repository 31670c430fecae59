//! What is wrong with the cases.

use std::fmt;

use crate::run::Stage;

/// One thing that is not as it should be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// A message that the program expects did not come.
    NoMessage(String),
    /// A message came that the program does not expect.
    Unexpected(String),
    /// A stage gave something and there is no golden.
    NoGolden(Stage),
    /// There is a golden and the stage gave nothing.
    Orphan(Stage),
    /// The golden differs, from this line on, in digits that say nothing. Told, and good.
    Digits(Stage, usize),
    /// The golden differs, from this line on, without change of the part.
    Cosmetic(Stage, usize),
    /// The golden differs.
    Changed {
        /// Which golden.
        stage: Stage,
        /// First line that differs.
        line: usize,
        /// That line in the golden.
        golden: String,
        /// The line that came.
        new: String,
    },
    /// The golden was written anew.
    Blessed(Box<Fault>),
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoMessage(text) => write!(f, "no message: {text}"),
            Self::Unexpected(text) => write!(f, "unexpected: {text}"),
            Self::NoGolden(stage) => write!(f, "{} is missing", stage.file()),
            Self::Orphan(stage) => {
                write!(f, "{} is an orphan: nothing was made of it", stage.file())
            }
            Self::Digits(stage, line) => {
                write!(f, "{} line {line}: cosmetic, in the last digits", stage.file())
            }
            Self::Cosmetic(stage, line) => {
                write!(f, "{} line {line}: cosmetic, the part is the same", stage.file())
            }
            Self::Changed { stage, line, golden, new } => {
                write!(f, "{} line {line}: `{golden}` became `{new}`", stage.file())
            }
            Self::Blessed(fault) => match &**fault {
                Self::NoGolden(stage) => write!(f, "blessed: {} is new", stage.file()),
                Self::Orphan(stage) => write!(f, "blessed: {} is taken away", stage.file()),
                fault => write!(f, "blessed: {fault}"),
            },
        }
    }
}

/// The faults of all cases that were run.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Report {
    cases: Vec<(String, Vec<Fault>)>,
}

impl Report {
    pub(crate) fn add(&mut self, case: String, faults: Vec<Fault>) {
        self.cases.push((case, faults));
    }

    /// How many cases were run.
    pub fn n_cases(&self) -> usize {
        self.cases.len()
    }

    /// How many of them have no fault.
    pub fn n_good(&self) -> usize {
        self.cases.iter().filter(|(_, faults)| faults.iter().all(is_good)).count()
    }

    /// Whether no fault is left.
    pub fn is_good(&self) -> bool {
        self.n_good() == self.n_cases()
    }

    /// Whether all faults are cosmetic.
    pub fn is_cosmetic(&self) -> bool {
        self.faults().all(|(_, fault)| is_good(fault) || matches!(fault, Fault::Cosmetic(..)))
    }

    /// Case and fault, in order.
    pub fn faults(&self) -> impl Iterator<Item = (&str, &Fault)> {
        self.cases.iter().flat_map(|(case, faults)| faults.iter().map(|f| (case.as_str(), f)))
    }
}

fn is_good(fault: &Fault) -> bool {
    matches!(fault, Fault::Blessed(_) | Fault::Digits(..))
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (case, fault) in self.faults() {
            writeln!(f, "{case}: {fault}")?;
        }
        write!(f, "{} of {} programs as they should be", self.n_good(), self.n_cases())
    }
}
