//! How space is seen: from the top where all is plane, else from the front, the right and above.

use aptc_geometry::{Form, Vec2, Vec3};

use super::scene::Scene;

/// Width of a picture.
pub(crate) const WIDTH: f64 = 480.0;
/// Height of a picture.
pub(crate) const HEIGHT: f64 = 320.0;
/// Free border of a picture.
const MARGIN: f64 = 30.0;

/// A box of space or, in x and y alone, of the picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    /// Least coordinates.
    pub(crate) low: Vec3,
    /// Greatest coordinates.
    pub(crate) high: Vec3,
}

impl Bounds {
    /// The box of points; `None` of none.
    pub(crate) fn of(points: impl IntoIterator<Item = Vec3>) -> Option<Self> {
        points.into_iter().fold(None, |all, p| {
            Some(match all {
                None => Self { low: p, high: p },
                Some(Self { low, high }) => Self { low: low.inf(&p), high: high.sup(&p) },
            })
        })
    }

    /// The box with that of others.
    pub(crate) fn with(self, points: impl IntoIterator<Item = Vec3>) -> Self {
        Self::of(points.into_iter().chain([self.low, self.high])).unwrap_or(self)
    }

    /// Larger by `by` to all sides.
    pub(crate) fn grown(self, by: Vec3) -> Self {
        Self { low: self.low - by, high: self.high + by }
    }

    /// Its sides.
    pub(crate) fn size(&self) -> Vec3 {
        self.high - self.low
    }

    /// Its middle.
    pub(crate) fn middle(&self) -> Vec3 {
        (self.low + self.high) / 2.0
    }

    /// Its corners.
    pub(crate) fn corners(&self) -> [Vec3; 8] {
        let (l, h) = (self.low, self.high);
        std::array::from_fn(|i| {
            let pick = |bit: usize, l: f64, h: f64| if i >> bit & 1 == 0 { l } else { h };
            Vec3::new(pick(0, l.x, h.x), pick(1, l.y, h.y), pick(2, l.z, h.z))
        })
    }
}

/// Does the scene lie in the xy plane, all that leaves it standing upright?
pub(crate) fn is_flat(scene: &Scene) -> bool {
    let forms = scene.items().map(|item| &item.form).chain(&scene.others);
    let upright = scene.result.path.as_ref().is_none_or(|path| path.tools.is_empty());
    upright && forms.into_iter().all(|form| plane_form(form))
}

/// Does the form lie in the xy plane, or stand upright on it?
pub(crate) fn plane_form(form: &Form) -> bool {
    let upright = |v: Vec3| v.xy().norm() < 1e-9;
    let level = |p: &Vec3| p.z.abs() < 1e-9;
    match form.shape() {
        Form::Point(p) | Form::Vector(p) => level(p),
        Form::Line(_) => true,
        Form::Plane(p) => level(&p.n),
        Form::Circle(c) => upright(c.axis) && level(&c.center),
        Form::Cylinder(c) => upright(c.axis) && level(&c.point),
        Form::Quadric(q) => [2, 4, 5, 9].iter().all(|i| q.c[*i].abs() < 1e-12),
        Form::Matrix(m) => {
            let z = m.vector(Vec3::z());
            upright(z) && z.z > 0.0 && level(&m.shift)
        }
        Form::Pattern(p) => p.points.iter().all(level),
        Form::Tabcyl(t) => upright(t.w()),
        Form::Scurv(c) => aptc_geometry::sculpt::fit_curve(c)
            .is_ok_and(|c| c.arcs.iter().all(|a| a.b.iter().all(|h| h.z.abs() < 1e-9))),
        _ => false,
    }
}

/// The map from space to the picture.
#[derive(Clone, Copy)]
pub(crate) struct View {
    /// Seen from the top?
    pub(crate) flat: bool,
    scale: f64,
    shift: Vec2,
}

impl View {
    /// The view in which the points fill the picture.
    pub(crate) fn fitting(flat: bool, points: impl IntoIterator<Item = Vec3>) -> Self {
        let plain = Self { flat, scale: 1.0, shift: Vec2::zeros() };
        let lift = |p: Vec3| {
            let q = plain.at(p);
            Vec3::new(q.x, q.y, 0.0)
        };
        let bounds = Bounds::of(points.into_iter().map(lift));
        let bounds = bounds.unwrap_or(Bounds { low: Vec3::zeros(), high: Vec3::zeros() });
        let size = bounds.size();
        let fit = |room: f64, size: f64| (room - 2.0 * MARGIN) / size.max(1e-9);
        let scale = fit(WIDTH, size.x).min(fit(HEIGHT, size.y)).min(200.0);
        let middle = bounds.middle().xy() * scale;
        Self { flat, scale, shift: Vec2::new(WIDTH / 2.0, HEIGHT / 2.0) - middle }
    }

    /// Where a point of space is in the picture; y of the picture goes down.
    pub(crate) fn at(&self, p: Vec3) -> Vec2 {
        let q = if self.flat {
            Vec2::new(p.x, -p.y)
        } else {
            Vec2::new((p.x + p.y) * 0.866_025_403_784_438_6, (p.x - p.y) * 0.5 - p.z)
        };
        q * self.scale + self.shift
    }

    /// Length in the picture of a length in space that is seen square.
    pub(crate) fn length(&self, length: f64) -> f64 {
        length * self.scale
    }

    /// The part of the xy plane that the picture shows, seen from the top.
    pub(crate) fn window(&self) -> Bounds {
        let back = |x: f64, y: f64| {
            let q = (Vec2::new(x, y) - self.shift) / self.scale;
            Vec3::new(q.x, -q.y, 0.0)
        };
        let corners = [back(0.0, HEIGHT), back(WIDTH, 0.0)];
        Bounds { low: corners[0], high: corners[1] }
    }
}
