//! Names in a picture, where they hide least.

use aptc_geometry::Vec2;

use super::view::{HEIGHT, WIDTH};

/// A text that wants a place.
pub(crate) struct Wanted {
    /// The text.
    pub(crate) text: String,
    /// Places that it may stand at, the best first.
    pub(crate) anchors: Vec<Vec2>,
    /// Class of the text in the picture.
    pub(crate) class: &'static str,
    /// Room between the anchor and the text.
    pub(crate) gap: f64,
}

/// A text at its place: the middle of its base line.
pub(crate) struct Placed {
    /// The text.
    pub(crate) text: String,
    /// Middle of the base line.
    pub(crate) at: Vec2,
    /// Class of the text.
    pub(crate) class: &'static str,
}

struct Frame {
    low: Vec2,
    high: Vec2,
}

impl Frame {
    fn about(middle: Vec2, half: Vec2) -> Self {
        Self { low: middle - half, high: middle + half }
    }

    fn meets(&self, o: &Self) -> bool {
        self.low.x < o.high.x
            && o.low.x < self.high.x
            && self.low.y < o.high.y
            && o.low.y < self.high.y
    }

    fn holds(&self, p: Vec2) -> bool {
        (self.low.x..self.high.x).contains(&p.x) && (self.low.y..self.high.y).contains(&p.y)
    }
}

const LETTER: f64 = 7.6;
const LINE: f64 = 13.0;

/// Places the texts one after the other; `ink` are points of what is drawn, `bold` those of the result.
pub(crate) fn place(wanted: Vec<Wanted>, ink: &[Vec2]) -> Vec<Placed> {
    let mut taken: Vec<Frame> = Vec::new();
    let mut placed = Vec::new();
    for label in wanted {
        let letters = f64::from(u32::try_from(label.text.len()).unwrap_or(0));
        let half = Vec2::new(letters * LETTER / 2.0 + 1.5, LINE / 2.0);
        let mut best: Option<(f64, Vec2)> = None;
        for (rank, anchor) in (0_u32..).zip(&label.anchors) {
            for (turn, way) in (0_u32..).zip(WAYS) {
                let away = Vec2::new(way[0] * (half.x + label.gap), way[1] * (half.y + label.gap));
                let middle = anchor + away;
                let frame = Frame::about(middle, half);
                let inside = frame.low.x > 4.0
                    && frame.low.y > 4.0
                    && frame.high.x < WIDTH - 4.0
                    && frame.high.y < HEIGHT - 4.0;
                let wide = Frame::about(middle, half + Vec2::new(1.0, 1.0));
                let hidden = ink.iter().filter(|p| wide.holds(**p)).count().min(60);
                let hidden = f64::from(u32::try_from(hidden).unwrap_or(60));
                let over = taken.iter().filter(|t| t.meets(&frame)).count();
                let cost = hidden * 4.0
                    + if over > 0 { 1000.0 } else { 0.0 }
                    + if inside { 0.0 } else { 2000.0 }
                    + f64::from(rank) * 0.6
                    + f64::from(turn) * 0.4;
                if best.is_none_or(|(least, _)| cost < least) {
                    best = Some((cost, middle));
                }
            }
        }
        // One that would stand over another says nothing.
        let Some((cost, middle)) = best else { continue };
        if cost < 2000.0 {
            taken.push(Frame::about(middle, half));
            let at = middle + Vec2::new(0.0, 4.4);
            placed.push(Placed { text: label.text, at, class: label.class });
        }
    }
    placed
}

/// Ways from an anchor to the middle of a text, in shares of its half sides.
const WAYS: [[f64; 2]; 8] = [
    [1.0, -0.8],
    [-1.0, -0.8],
    [1.0, 0.8],
    [-1.0, 0.8],
    [0.0, -1.0],
    [0.0, 1.0],
    [1.0, 0.0],
    [-1.0, 0.0],
];
