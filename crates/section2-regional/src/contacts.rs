//! The contacts of a pass between its positions.

use crate::drive::Course;
use crate::position::Position;
use crate::solve::{Memory, Setup, Take};

/// Part of the band by which a line straight in the parameters of the part surface may leave the contacts.
const PART: f64 = 0.05;
/// Halvings of a cut vector.
const HALVINGS: u32 = 8;

impl Setup<'_> {
    /// The contacts of a path by parameters of the part surface, so close to each other that what is straight between them in the
    /// parameters runs along the contacts: a long cut vector over a surface of revolution is a curve there.
    pub(crate) fn contacts(
        &self,
        points: &[Position],
        (course, sense): (Course, f64),
    ) -> Vec<[f64; 2]> {
        let mut all: Vec<[f64; 2]> = points.iter().take(1).map(|p| p.part_uv).collect();
        let first =
            points.first().map(|p| self.position(p.drive_uv, course, sense, None, Take::Nothing));
        let memory = first.and_then(Result::ok).map(|(_, memory)| memory);
        for pair in points.windows(2) {
            if let Some(memory) = memory {
                self.contacts_between(
                    [&pair[0], &pair[1]],
                    (course, sense),
                    (memory, HALVINGS),
                    &mut all,
                );
            }
            all.push(pair[1].part_uv);
        }
        all
    }

    fn contacts_between(
        &self,
        [a, b]: [&Position; 2],
        (course, sense): (Course, f64),
        (memory, left): (Memory, u32),
        all: &mut Vec<[f64; 2]>,
    ) {
        let middle = |a: [f64; 2], b: [f64; 2]| [0, 1].map(|k| 0.5 * (a[k] + b[k]));
        // Where the tool rolls over an edge the drive point stays.
        let stays = (0..2).all(|k| (a.drive_uv[k] - b.drive_uv[k]).abs() <= f64::EPSILON);
        let Some(left) = left.checked_sub(1).filter(|_| !stays) else { return };
        let (uv, memory) = (middle(a.drive_uv, b.drive_uv), memory.at(a.part_uv));
        let Ok((mid, memory)) = self.position(uv, course, sense, Some(memory), Take::Nothing)
        else {
            return;
        };
        let [u, v] = middle(a.part_uv, b.part_uv);
        let off = (self.part.surface.at(u, v).point - mid.contact).norm();
        if off > PART * (self.band.intol + self.band.outtol) {
            self.contacts_between([a, &mid], (course, sense), (memory, left), all);
            all.push(mid.part_uv);
            self.contacts_between([&mid, b], (course, sense), (memory, left), all);
        }
    }
}
