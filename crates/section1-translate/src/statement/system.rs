//! ZSURF, REFSYS and RESERV.

use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_geometry::{Form, Plane, Vec3};
use aptc_syntax::tree::{Clause, ExprKind};
use aptc_vocabulary::{Word, word};

use super::reader::Reader;
use crate::Interpreter;
use crate::define::Context;
use crate::eval::{Known, Names, Poisoned, whole};
use crate::memory::Value;

impl Interpreter<'_> {
    /// ZSURF/plane, z or NOMORE; REFSYS/matrix or NOMORE.
    pub(super) fn system(&mut self, word: Word, clause: &Clause) -> Known<()> {
        let args = if word == word::ZSURF {
            self.args(clause, Names::Defined)?
        } else {
            self.args_in_base(clause, Names::Defined)?
        };
        let mut reader = Reader::new(word, clause, &args);
        self.state.carried.clear();
        if reader.is_word(word::NOMORE) {
            if word == word::ZSURF {
                self.state.zsurf = None;
            } else {
                self.state.refsys = None;
            }
        } else if word == word::ZSURF {
            let plane = self.z_plane(&mut reader)?;
            self.state.zsurf = Some(plane);
        } else {
            self.refsys(&mut reader)?;
        }
        self.at_end(&reader)
    }

    /// The plane of ZSURF, as the present reference system sees it.
    fn z_plane(&mut self, reader: &mut Reader<'_>) -> Known<Plane> {
        let plane = if let Some(z) = reader.number() {
            Plane { n: Vec3::z(), d: z }
        } else if let Some(Form::Plane(plane)) = reader.peek().and_then(|a| a.form()) {
            reader.skip(1);
            *plane
        } else {
            return Err(self.expect(reader, "a plane, a number or NOMORE"));
        };
        if !Context::zsurf_is_usable(&plane) {
            self.error(
                Diagnostic::error(
                    codes::STEEP_ZSURF,
                    reader.before(),
                    "an upright plane gives no z to a point",
                )
                .help("ZSURF takes a plane that leans less than 90 degrees"),
            );
            return Err(Poisoned);
        }
        Ok(plane)
    }

    fn refsys(&mut self, reader: &mut Reader<'_>) -> Known<()> {
        let Some(Form::Matrix(m)) = reader.peek().and_then(|a| a.form()) else {
            return Err(self.expect(reader, "a matrix or NOMORE"));
        };
        reader.skip(1);
        if m.inverse().is_none() {
            self.error(
                Diagnostic::error(
                    codes::FLAT_MATRIX,
                    reader.before(),
                    "this matrix flattens space, so no form has a place in its system",
                )
                .help("a reference system has three axes that span space"),
            );
            return Err(Poisoned);
        }
        self.state.refsys = Some(*m);
        Ok(())
    }

    /// RESERV/name,n,...: either order, the first pair decides.
    pub(super) fn reserve(&mut self, clause: &Clause) -> Known<()> {
        let args = clause.args.as_deref().unwrap_or_default();
        if args.is_empty() {
            return Err(self.bad_reserve(clause.span, "RESERV names no array"));
        }
        let mut known = Ok(());
        for pair in args.chunks(2) {
            let [a, b] = pair else {
                // `RESERV/A(10)` as other languages write it.
                let name = match &pair[0].kind {
                    ExprKind::Indexed(indexed) => Some(indexed.name),
                    kind => Self::as_name(kind),
                };
                if let Some(name) = name {
                    let place = self.memory.place(name.symbol);
                    self.memory.set(place, Value::Poison, name.span);
                }
                known = Err(self.bad_reserve(pair[0].span, "this has no partner in RESERV"));
                continue;
            };
            let (name, size) = match (&a.kind, &b.kind) {
                (ExprKind::Name(name), _) => (name, b),
                (_, ExprKind::Name(name)) => (name, a),
                _ => {
                    known = Err(self.bad_reserve(a.span, "a name and a number are expected"));
                    continue;
                }
            };
            let Ok(n) = self.number(size) else {
                let place = self.memory.place(name.symbol);
                self.memory.set(place, Value::Poison, name.span);
                known = Err(Poisoned);
                continue;
            };
            if self.reserve_one(*name, n, size.span).is_err() {
                known = Err(Poisoned);
            }
        }
        known
    }

    fn reserve_one(&mut self, name: aptc_syntax::tree::Name, n: f64, size: Span) -> Known<()> {
        let place = self.memory.place(name.symbol);
        let text = self.spelled(place);
        let (given, old) = {
            let slot = self.memory.slot(place);
            (slot.given, matches!(slot.value, Value::Unset | Value::Poison))
        };
        if !old {
            self.error(
                Diagnostic::error(
                    codes::KIND_CHANGED,
                    name.span,
                    format!("{text} has a value already and cannot become an array"),
                )
                .also(given, "it has one since here")
                .help("reserve it before it is used, and once"),
            );
            return Err(Poisoned);
        }
        let Some(n) = whole(n).filter(|n| *n >= 1.0) else {
            self.memory.set(place, Value::Poison, name.span);
            return Err(self.bad_reserve(size, &format!("{n} elements are no array")));
        };
        let limit = self.options.limits.array_elements;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "saturates, and is compared with the limit"
        )]
        let n_elements = n as usize;
        if n_elements.saturating_add(self.memory.n_elements()) > limit {
            self.memory.set(place, Value::Poison, name.span);
            self.error(
                Diagnostic::error(
                    codes::TOO_MANY_ELEMENTS,
                    size,
                    format!("{n} elements bring all arrays over the limit of {limit}"),
                )
                .help("reserve fewer; the limit is a setting"),
            );
            return Err(Poisoned);
        }
        self.memory.reserve(name.symbol, n_elements, name.span);
        Ok(())
    }

    fn bad_reserve(&mut self, span: Span, message: &str) -> Poisoned {
        self.error(
            Diagnostic::error(codes::BAD_RESERVE, span, message).help("write RESERV/name,n,name,n"),
        );
        Poisoned
    }
}
