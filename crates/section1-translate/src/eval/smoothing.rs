//! WEIGHT and LIMIT that change nothing: only points of a weight below 1 are moved, and LIMIT says how far these may go.

use aptc_diagnostics::{Diagnostic, codes};
use aptc_vocabulary::{Word, word};

use crate::Interpreter;
use crate::define::{self, Value};

/// What is given at a point, for a row of points, or for all rows.
#[derive(Clone, Copy, Default)]
struct Level {
    /// WEIGHT, and where its word stands.
    weight: Option<(f64, usize)>,
    /// Where LIMIT stands.
    limit: Option<usize>,
    /// Does its LIMIT hold a point that is moved?
    holds: bool,
}

impl Level {
    fn take(&mut self, word: Word, at: usize, value: f64) {
        match word {
            word::WEIGHT => self.weight = Some((value, at)),
            _ => self.limit = Some(at),
        }
    }

    /// Is WEIGHT below 1 here? `None` where it is not given.
    fn moves(&self) -> Option<bool> {
        self.weight.map(|(weight, _)| weight < 1.0)
    }

    /// The words of the level that change nothing, where the levels above it move its points or do not.
    fn idle(&self, above: bool) -> impl Iterator<Item = usize> {
        let limit = self.limit.filter(|_| !self.holds);
        let weight = self.weight.filter(|(weight, _)| *weight >= 1.0 && !above);
        limit.into_iter().chain(weight.map(|(_, at)| at))
    }
}

/// A walk through the arguments of a spline or a mesh.
#[derive(Default)]
struct Walk {
    all: Level,
    row: Option<Level>,
    point: Option<Level>,
    idle: Vec<usize>,
}

impl Walk {
    fn end_point(&mut self) {
        let Some(mut point) = self.point.take() else { return };
        let above = self.row.and_then(|r| r.moves()).or(self.all.moves()) == Some(true);
        if point.moves().unwrap_or(above) {
            let row = self.row.as_mut().filter(|row| row.limit.is_some());
            match (point.limit, row) {
                (Some(_), _) => point.holds = true,
                (None, Some(row)) => row.holds = true,
                (None, None) => self.all.holds = true,
            }
        }
        self.idle.extend(point.idle(above));
    }

    fn end_row(&mut self) {
        self.end_point();
        let above = self.all.moves() == Some(true);
        self.idle.extend(self.row.take().iter().flat_map(|row| row.idle(above)));
    }
}

/// Where the first WEIGHT or LIMIT stands that changes nothing.
fn first_idle(args: &[define::Arg]) -> Option<usize> {
    let mut walk = Walk::default();
    for (at, arg) in args.iter().enumerate() {
        match &arg.value {
            Value::Word(word::SPLINE) => {
                walk.end_row();
                walk.row = Some(Level::default());
            }
            Value::Word(word @ (word::WEIGHT | word::LIMIT)) => {
                let value = match args.get(at + 1).map(|a| &a.value) {
                    Some(Value::Number(value)) => *value,
                    _ => continue,
                };
                let row = walk.row.as_mut().unwrap_or(&mut walk.all);
                walk.point.as_mut().unwrap_or(row).take(*word, at, value);
            }
            Value::Form { form, .. } if form.kind() == aptc_geometry::FormKind::Point => {
                walk.end_point();
                walk.point = Some(Level::default());
            }
            _ => {}
        }
    }
    walk.end_row();
    walk.idle.extend(walk.all.idle(false));
    walk.idle.into_iter().min()
}

impl Interpreter<'_> {
    /// Says once a statement that a WEIGHT or LIMIT changes nothing.
    pub(super) fn idle_smoothing(&mut self, head: Word, args: &[define::Arg]) {
        let first = args.first().map(|a| &a.value);
        let by_points = match head {
            word::SCURV => matches!(first, Some(Value::Word(word::SPLINE))),
            word::SSURF => matches!(first, Some(Value::Word(word::SMESH | word::GMESH))),
            _ => false,
        };
        let Some(at) = first_idle(args).filter(|_| by_points) else { return };
        let message = if args[at].value == Value::Word(word::WEIGHT) {
            "this WEIGHT changes nothing: from 1 on the curve goes through the points, as it does without it"
        } else {
            "this LIMIT changes nothing: no point is moved by a WEIGHT below 1"
        };
        self.error(
            Diagnostic::warning(codes::IDLE_SMOOTHING, args[at].span, message)
                .note("WEIGHT below 1 lets the curve leave its points, the more the smaller it is; LIMIT says how far at most")
                .help("write WEIGHT,.5,LIMIT,.1 before the points or behind one, with numbers to your needs; or leave both out"),
        );
    }
}

#[cfg(test)]
mod tests {
    use aptc_diagnostics::codes;

    use crate::{Interpreter, NoFiles, Options, Step};

    /// The words that the warnings about a spline point at.
    fn told(definition: &str) -> Vec<String> {
        let text = format!("S={definition}\nFINI\n");
        let mut files = NoFiles;
        let mut program = Interpreter::new("test", &text, &mut files, Options::default());
        while program.step() != Step::End {}
        let all = program.take_diagnostics();
        assert!(all.iter().all(|d| d.code == codes::IDLE_SMOOTHING), "{all:?}");
        let at = |d: &aptc_diagnostics::Diagnostic| {
            text[d.span.start as usize..].chars().take_while(char::is_ascii_alphabetic).collect()
        };
        all.iter().map(at).collect()
    }

    const REST: &str = "(0,0,0),(9,8,0),(20,1,0)";
    const ROW: &str = "(0,9,0),(9,9,5),(20,9,0)";

    #[test]
    fn what_moves_no_point_is_told() {
        for (given, word) in
            [("LIMIT,2,", "LIMIT"), ("WEIGHT,1,", "WEIGHT"), ("WEIGHT,2,LIMIT,3,", "WEIGHT")]
        {
            assert_eq!(told(&format!("SCURV/SPLINE,{given}{REST}")), [word], "{given}");
            let mesh = format!("SSURF/SMESH,XYZ,{given}$\n SPLINE,{REST},$\n SPLINE,{ROW}");
            assert_eq!(told(&mesh), [word], "{given}");
        }
        assert_eq!(told("SCURV/SPLINE,(0,0,0),(9,8,0),LIMIT,2,(20,1,0)"), ["LIMIT"]);
        // Of two points one is moved; the other one's LIMIT holds nothing.
        let one = "SCURV/SPLINE,(0,0,0),(9,8,0),WEIGHT,.1,LIMIT,2,$\n(15,3,0),LIMIT,1,(20,1,0)";
        assert_eq!(told(one), ["LIMIT"]);
    }

    #[test]
    fn what_moves_points_and_holds_them_is_not_told() {
        for given in ["", "WEIGHT,.5,", "WEIGHT,.5,LIMIT,3,", "LIMIT,3,WEIGHT,0,"] {
            assert_eq!(told(&format!("SCURV/SPLINE,{given}{REST}")), [""; 0], "{given}");
        }
        // One point is held fast among those that move; and a LIMIT for all holds the one that moves.
        assert_eq!(told("SCURV/SPLINE,WEIGHT,.1,(0,0,0),(9,8,0),WEIGHT,1,(20,1,0)"), [""; 0]);
        assert_eq!(told("SCURV/SPLINE,LIMIT,2,(0,0,0),(9,8,0),WEIGHT,.1,(20,1,0)"), [""; 0]);
        let mesh = format!("SSURF/SMESH,XYZ,LIMIT,1,SPLINE,{REST},$\n SPLINE,WEIGHT,.2,{ROW}");
        assert_eq!(told(&mesh), [""; 0]);
    }
}
