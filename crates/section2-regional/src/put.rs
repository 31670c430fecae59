//! What is put out of a region.

use aptc_geometry::Vec3;

use crate::position::Position;

/// What is put out.
#[derive(Clone, Debug)]
pub(crate) enum Put {
    /// FEDRAT, unless it is 0.
    Feed(f64),
    /// Positions.
    Move(Vec<(Vec3, Vec3)>),
    /// Positions of a path, with the parameters of the drive.
    Path(Vec<Along>),
    /// The same of one that is lifted off the surface.
    Lifted(Vec<Along>),
    /// The same of one that got out of the way of something.
    Risen(Vec<Along>),
}

impl Put {
    /// A path that got out of the way or did not.
    pub(crate) fn path(along: Vec<Along>, avoided: bool) -> Self {
        if avoided { Self::Risen(along) } else { Self::Path(along) }
    }

    /// The last place of the tool.
    pub(crate) fn last(&self) -> Option<(Vec3, Vec3)> {
        match self {
            Self::Feed(_) => None,
            Self::Move(points) => points.last().copied(),
            Self::Path(along) | Self::Lifted(along) | Self::Risen(along) => {
                along.last().map(|a| a.at)
            }
        }
    }

    /// Leaves the first place of a path out.
    pub(crate) fn leave_first(&mut self) {
        if let Self::Path(along) | Self::Lifted(along) | Self::Risen(along) = self
            && !along.is_empty()
        {
            along.remove(0);
        }
    }

    /// The places of the tool.
    pub(crate) fn places(&self) -> Vec<(Vec3, Vec3)> {
        match self {
            Self::Feed(_) => Vec::new(),
            Self::Move(points) => points.clone(),
            Self::Path(along) | Self::Lifted(along) | Self::Risen(along) => {
                along.iter().map(|a| a.at).collect()
            }
        }
    }
}

/// A position that belongs to a place of the drive.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Along {
    pub(crate) at: (Vec3, Vec3),
    /// Parameters of the drive.
    pub(crate) uv: [f64; 2],
}

impl Along {
    pub(crate) fn of(p: &Position) -> Self {
        Self { at: (p.te, p.ta), uv: p.drive_uv }
    }

    /// A path, without its first place if that is to be skipped; where the tool stands still one place.
    pub(crate) fn each(points: &[Position], skip: bool) -> Vec<Self> {
        let mut all: Vec<Self> = points.iter().map(Self::of).collect();
        all.dedup_by(|b, a| a.at == b.at);
        if skip && !all.is_empty() {
            all.remove(0);
        }
        all
    }
}
