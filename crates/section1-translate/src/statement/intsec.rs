//! INTSEC: curves in which a plane meets sculptured surfaces, or these meet others.
//!
//! Source: the manual of APT4 SSV3, chapter 14.

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_geometry::Form;
use aptc_protap::Kind;
use aptc_syntax::tree::Clause;
use aptc_vocabulary::word;

use crate::Interpreter;
use crate::eval::{Arg, ArgKind, Known, Names, Poisoned, describe};

/// Most surfaces that are cut by a plane, and most on each side of WITH.
const MOST: [usize; 2] = [40, 20];

/// How the statement is written.
pub(super) const FORMATS: [&str; 2] =
    ["INTSEC/plane|line[,WITH],SSURF,..[,CANON]", "INTSEC/SSURF,..,WITH,SSURF,..[,CANON]"];

impl Interpreter<'_> {
    /// `INTSEC/plane|line[,WITH],SSURF,..[,CANON]` and `INTSEC/SSURF,..,WITH,SSURF,..[,CANON]`.
    pub(super) fn intsec(&mut self, clause: &Clause) -> Known<()> {
        let args = self.args(clause, Names::Defined)?;
        self.intsec_shaped(&args, clause)?;
        let args = self.handed_on(args)?;
        self.emit(Kind::Regional { word: word::INTSEC.text().into(), args });
        Ok(())
    }

    fn intsec_shaped(&mut self, args: &[Arg], clause: &Clause) -> Known<()> {
        let by_plane = args.first().is_some_and(is_plane);
        let from = usize::from(by_plane);
        let run = |from: usize| args[from..].iter().take_while(|a| is_surface(a)).count();
        let first = run(from);
        let with = args.get(from + first).and_then(Arg::word) == Some(word::WITH);
        let second_from = from + first + usize::from(with);
        let second = if with { run(second_from) } else { 0 };
        let end = second_from + second;
        let canon = args.get(end).and_then(Arg::word) == Some(word::CANON);
        let (expected, at) = if !by_plane && first == 0 {
            ("a plane, a line or an SSURF", 0)
        } else if by_plane && with && first > 0 {
            ("CANON or nothing more", from + first)
        } else if by_plane && first + second == 0 {
            (if with { "an SSURF" } else { "WITH or an SSURF" }, second_from)
        } else if !by_plane && !with {
            ("an SSURF or WITH", from + first)
        } else if !by_plane && second == 0 {
            ("an SSURF", second_from)
        } else if end + usize::from(canon) < args.len() {
            (if canon { "nothing more" } else { "an SSURF or CANON" }, end + usize::from(canon))
        } else {
            return self.intsec_counted(args, [from, first], [second_from, second], by_plane);
        };
        let (span, found) = match args.get(at) {
            Some(arg) => {
                (arg.span, format!("INTSEC expects {expected} here, found {}", describe(arg)))
            }
            None => {
                let end = args.last().map_or(clause.span, |a| a.span);
                let end = Span::new(end.file, end.end, end.end);
                (end, format!("INTSEC ends where {expected} is expected"))
            }
        };
        let mut message = Diagnostic::error(codes::BAD_ARGUMENTS, span, found);
        for format in FORMATS {
            message = message.note(format!("the format is {format}"));
        }
        self.error(message);
        Err(Poisoned)
    }

    /// Not too many of them, and none against itself.
    fn intsec_counted(
        &mut self,
        args: &[Arg],
        [from, first]: [usize; 2],
        [second_from, second]: [usize; 2],
        by_plane: bool,
    ) -> Known<()> {
        let most = if by_plane { MOST[0] } else { MOST[1] };
        let (ones, others) = (&args[from..from + first], &args[second_from..second_from + second]);
        if let Some(over) = ones.get(most).or(others.get(most)) {
            let message = format!("INTSEC takes {most} surfaces here at most");
            self.error(Diagnostic::error(codes::BAD_ARGUMENTS, over.span, message));
            return Err(Poisoned);
        }
        let same = others.iter().find(|b| ones.iter().any(|a| form(a) == form(b)));
        if let Some(same) = same {
            let message = format!("{} cannot meet itself", describe(same));
            self.error(
                Diagnostic::error(codes::BAD_ARGUMENTS, same.span, message)
                    .help("name it on one side of WITH only"),
            );
            return Err(Poisoned);
        }
        Ok(())
    }
}

fn form(arg: &Arg) -> Option<&Form> {
    match &arg.kind {
        ArgKind::Form { form, .. } => Some(form),
        _ => None,
    }
}

fn is_plane(arg: &Arg) -> bool {
    form(arg).is_some_and(|f| matches!(f.shape(), Form::Plane(_) | Form::Line(_)))
}

fn is_surface(arg: &Arg) -> bool {
    form(arg).is_some_and(|f| matches!(f.shape(), Form::Ssurf(_)))
}
