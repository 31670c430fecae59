//! Coordinate systems that CL data name: positions are written as they are given.

use aptc_diagnostics::{Origin, codes};
use aptc_geometry::{Transform, trig};

use crate::post::{Post, trimmed};

/// Axes turned by less than this are the same, degrees: files give five decimals of a matrix or more.
const TURNED_DEG: f64 = 0.01;
/// Origins closer than this are the same, millimetres.
const MOVED_MM: f64 = 0.01;

impl Post {
    /// The coordinate system of the positions that follow.
    ///
    /// The one that holds when the tool first moves is that of the zero on the machine; where none was named until
    /// then, the first that is named is compared with that of the program itself. Positions of another one are
    /// written as they are, for only the operator knows where its zero lies; that is told.
    pub(crate) fn frame(&mut self, frame: &Transform, origin: &Origin) {
        let last = self.st.frame.replace(*frame);
        if self.st.pos.is_none() {
            return;
        }
        let last = last.unwrap_or_else(Transform::identity);
        let turn = last.linear.transpose() * frame.linear;
        let turned = trig::acos_clamped((turn.trace() - 1.0) / 2.0).to_degrees();
        let shift = frame.shift - last.shift;
        let moved = shift.norm() > MOVED_MM / self.st.units.mm();
        if turned <= TURNED_DEG && !moved {
            return;
        }
        let mut how = Vec::new();
        if moved {
            let place: Vec<String> = shift.iter().map(|x| trimmed(*x, 4)).collect();
            how.push(format!("its origin lies {} from the last one", place.join(",")));
        }
        if turned > TURNED_DEG {
            how.push(format!("it is turned by {} degrees", trimmed(turned, 3)));
        }
        let message = format!("another coordinate system: {}", how.join(" and "));
        let help = "positions are written as they stand: post its part of the file alone, or set the zero of the machine there";
        self.warn(codes::OTHER_FRAME, origin, message, help);
    }
}
