//! From the seven parameters to the profile, with the reasons why some seven numbers are no cutter.

use crate::Vec2;
use crate::cutter::TANGENT;
use crate::profile::{Profile, cross};
use crate::{Cutter, trig};

/// A centre nearer to the axis than this fraction of the cutter's size is on it: no flat is so narrow.
const CENTRED: f64 = 1e-9;

/// Why seven numbers are no cutter. The numbers in brackets are those of the sculptured-surface system.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BadCutter {
    /// A number is not finite, or the segments do not close to a convex solid (22201, 22217).
    NotAShape,
    /// Negative diameter (22202).
    NegativeDiameter,
    /// Negative height (22203).
    NegativeHeight,
    /// The angles add up to 90 degrees or more: the two lines do not meet (22204).
    Angles,
    /// Negative alpha (22205).
    NegativeAlpha,
    /// The lines meet above the top (22206).
    TooLow,
    /// Negative corner radius (22208).
    NegativeCornerRadius,
    /// The corner arc lies outside the upper line (22209).
    CornerOutsideUpperLine,
    /// The arc begins before the lower line does (22210).
    CornerMeetsLowerLineBadly,
    /// Nothing is left of the upper line: the sides meet below the top (22212).
    NoUpperLine,
    /// The arc does not reach the lower line (22213).
    CornerMissesLowerLine,
    /// The arc does not reach the upper line (22214).
    CornerMissesUpperLine,
    /// The arc ends after the upper line does (22215).
    CornerMeetsUpperLineBadly,
}

/// What is odd about a cutter and does no harm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CutterWarning {
    /// Negative beta: the cutter is wider below (22207).
    Bell,
    /// The top cuts the arc below the upper line (22216).
    UpperLineIgnored,
}

impl Profile {
    /// The profile of a cutter.
    pub fn new(cutter: &Cutter) -> Result<Self, BadCutter> {
        let [d, r, e, f, alpha, beta, h] = cutter.values();
        if !cutter.values().iter().all(|v| v.is_finite()) {
            return Err(BadCutter::NotAShape);
        }
        if d < 0.0 {
            return Err(BadCutter::NegativeDiameter);
        }
        if h < 0.0 {
            return Err(BadCutter::NegativeHeight);
        }
        if alpha < 0.0 {
            return Err(BadCutter::NegativeAlpha);
        }
        if r < 0.0 {
            return Err(BadCutter::NegativeCornerRadius);
        }
        if alpha + beta >= 90.0 || alpha >= 90.0 || beta.abs() >= 90.0 {
            return Err(BadCutter::Angles);
        }
        let mut warnings = [(beta < 0.0).then_some(CutterWarning::Bell), None];
        let (sa, ca) = (trig::sin_deg(alpha), trig::cos_deg(alpha));
        let (sb, cb) = (trig::sin_deg(beta), trig::cos_deg(beta));
        // Directions from tip to corner and from corner to rim, and the outward normals.
        let (tl, tu) = (Vec2::new(ca, sa), Vec2::new(sb, cb));
        let (nl, nu) = (Vec2::new(sa, -ca), Vec2::new(cb, -sb));
        let tip = Vec2::zeros();
        let meet = Vec2::new(0.5 * d, 0.5 * d * sa / ca);
        let size = d.max(h).max(r);
        let tol = TANGENT * size;
        if meet.y > h + tol {
            return Err(BadCutter::TooLow);
        }
        let top = |p: Vec2| Vec2::new(p.x + (h - p.y) * sb / cb, h);

        // A sharp corner lies where the lines meet; zero e and f then say nothing.
        let given = Vec2::new(e, f);
        let sharp = r <= 0.0 && (given == tip || (given - meet).norm() <= tol);
        let c = if sharp {
            meet
        } else if given == tip {
            // Nor do they with a corner radius: the corner is then tangent to both lines.
            let det = cross(nl, nu);
            let (low, up) = (-r, nu.dot(&meet) - r);
            Vec2::new((low * nu.y - up * nl.y) / det, (up * nl.x - low * nu.x) / det)
        } else {
            given
        };
        let (c, lower, upper) =
            if sharp { (c, Join::Tangent, Join::Tangent) } else { snap(c, r, meet, nl, nu, tol)? };

        let (mut pl, mut a0) = match lower {
            Join::Tangent => (c + nl * r, nl),
            Join::Edge(inside) => {
                let s = c.dot(&tl) + (r * r - inside * inside).sqrt();
                let p = tl * s;
                (p, (p - c) / r)
            }
        };
        let (mut pu, mut a1) = match upper {
            Join::Tangent => (c + nu * r, nu),
            Join::Edge(inside) => {
                let p = c + nu * inside - tu * (r * r - inside * inside).sqrt();
                (p, (p - c) / r)
            }
        };
        if pl.dot(&tl) < -tol {
            return Err(BadCutter::CornerMeetsLowerLineBadly);
        }
        if pl.norm() <= 1e-12 * size {
            pl = tip;
        }
        let (mut nu, mut rim) = (nu, top(pu));
        if pu.y > h + 1e-12 * size {
            // The top cuts the arc.
            let up = h - c.y;
            if up.abs() > r || pl.y > h {
                return Err(BadCutter::CornerMeetsUpperLineBadly);
            }
            if pu.y > h + tol {
                warnings[1] = Some(CutterWarning::UpperLineIgnored);
            }
            pu = Vec2::new(c.x + ((r - up) * (r + up)).sqrt(), h);
            a1 = (pu - c) / r;
            (nu, rim) = (a1, pu);
        }
        if rim.x < -1e-12 * size {
            return Err(BadCutter::NoUpperLine);
        }
        rim.x = rim.x.max(0.0);
        if pu.x < -1e-12 * size || pl.x < -1e-12 * size {
            return Err(BadCutter::NotAShape);
        }
        // An arc of no length has one normal.
        if r > 0.0 && cross(a0, a1) < 0.0 && (pu - pl).norm() <= tol {
            a0 = nl;
            a1 = nu;
        }
        let turns = cross(nl, a0) >= -1e-9 && cross(a1, nu) >= -1e-9;
        if !turns || cross(a0, a1) < -1e-9 {
            return Err(BadCutter::NotAShape);
        }
        let side = if a0.y <= 0.0 && a1.y >= 0.0 { c.x + r } else { 0.0 };
        let widest = side.max(pl.x).max(pu.x).max(rim.x);
        Ok(Self { tip, nl, pl, c, r, a0, a1, pu, nu, rim, widest, warnings })
    }
}

/// How an arc meets a line.
enum Join {
    /// Tangent.
    Tangent,
    /// With an edge; the centre's distance inside the line.
    Edge(f64),
}

/// Moves a centre that is meant to be tangent onto tangency, and says how the arc joins the lines.
fn snap(
    c: Vec2,
    r: f64,
    meet: Vec2,
    nl: Vec2,
    nu: Vec2,
    tol: f64,
) -> Result<(Vec2, Join, Join), BadCutter> {
    let inside = |c: Vec2| (-nl.dot(&c), nu.dot(&(meet - c)));
    let (dl, du) = inside(c);
    if dl > r + tol {
        return Err(BadCutter::CornerMissesLowerLine);
    }
    if du > r + tol {
        return Err(BadCutter::CornerMissesUpperLine);
    }
    let (tan_l, tan_u) = ((dl - r).abs() <= tol, (du - r).abs() <= tol);
    if du <= -r + tol && !tan_u {
        return Err(BadCutter::CornerOutsideUpperLine);
    }
    if dl <= -r && !tan_l {
        return Err(BadCutter::CornerMeetsLowerLineBadly);
    }
    // Shift x with nl.x = dl - r where tangent below, nu.x = du - r where tangent above.
    let (gl, gu) = (dl - r, du - r);
    let given = c;
    let c = match (tan_l, tan_u) {
        (true, true) => {
            let det = cross(nl, nu);
            c + Vec2::new(gl * nu.y - gu * nl.y, gu * nl.x - gl * nu.x) / det
        }
        (true, false) => c + nl * gl,
        (false, true) => c + nu * gu,
        (false, false) => c,
    };
    // A centre that is given on the axis or beyond it by digits, or comes within rounding of it, is on it: the cutter is round.
    // Along the lower line the shift onto the upper one has moved it, which begins where the arc ends anyway.
    let wide = r + meet.x;
    let on_axis = |x: f64, below: f64| (-below * wide..=CENTRED * wide).contains(&x);
    let c = if tan_l && tan_u && on_axis(given.x, TANGENT) {
        Vec2::new(0.0, -r / nl.y)
    } else if on_axis(c.x, CENTRED) {
        Vec2::new(0.0, c.y)
    } else {
        c
    };
    let (dl, du) = inside(c);
    let join = |tangent: bool, d: f64| if tangent { Join::Tangent } else { Join::Edge(d) };
    Ok((c, join(tan_l, dl), join(tan_u, du)))
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "some closed forms are met to the last bit")]
mod tests {
    use super::*;

    fn cutter(v: [f64; 7]) -> Cutter {
        let [diameter, corner_radius, e, f, alpha_deg, beta_deg, height] = v;
        Cutter { diameter, corner_radius, e, f, alpha_deg, beta_deg, height }
    }

    #[test]
    fn published_profile_values() {
        let p = Profile::new(&cutter([20.0, 0.0, 0.0, 0.0, 0.0, 30.0, 30.0])).unwrap();
        assert!((p.top_radius() - 27.320_51).abs() < 5e-6);
        // Centre given to five digits is moved onto tangency.
        let p = Profile::new(&cutter([20.0, 2.0, 8.39792, 3.51163, 10.0, 15.0, 50.0])).unwrap();
        let [e, f] = p.corner();
        assert!((e - 8.397_920).abs() < 1e-6 && (f - 3.511_633).abs() < 1e-6);
        let [[a, b], [c, d]] = p.joints();
        assert!((a - 8.745_217).abs() < 1e-6 && (b - 1.542_018).abs() < 1e-6);
        assert!((c - 10.329_772).abs() < 1e-6 && (d - 2.993_995).abs() < 1e-6);
        assert!((p.top_radius() - 22.924_993).abs() < 1e-6);
    }

    #[test]
    fn usual_mills() {
        let ball = Profile::new(&Cutter::mill(10.0, 5.0, 5.0)).unwrap();
        assert!(ball.is_round());
        assert_eq!(ball.warnings().count(), 0);
        assert_eq!((ball.widest(), ball.height()), (5.0, 5.0));
        let flat = Profile::new(&Cutter::mill(20.0, 0.0, 5.0)).unwrap();
        assert_eq!(flat.joints(), [[10.0, 0.0], [10.0, 0.0]]);
        let point = Profile::new(&Cutter::mill(0.0, 0.0, 5.0)).unwrap();
        assert_eq!((point.widest(), point.reach()), (0.0, 5.0));
        let bell = Profile::new(&cutter([20.0, 0.0, 0.0, 0.0, 0.0, -10.0, 8.0])).unwrap();
        assert_eq!(bell.warnings().next(), Some(CutterWarning::Bell));
        assert!(bell.top_radius() < 9.0);
        // Zero e and f of a flat mill, as many systems write it.
        let p = Profile::new(&cutter([20.0, 0.0, 0.0, 0.0, 0.0, 0.0, 50.0])).unwrap();
        assert_eq!(p.corner(), [10.0, 0.0]);
        // A ball of which only the lower part is there.
        let low = Profile::new(&cutter([10.0, 5.0, 0.0, 5.0, 0.0, 0.0, 2.0])).unwrap();
        assert_eq!(low.warnings().next(), Some(CutterWarning::UpperLineIgnored));
        assert!((low.top_radius() - 4.0).abs() < 1e-12);
    }

    #[test]
    fn each_refusal_has_its_reason() {
        use BadCutter::*;
        for (v, reason) in [
            ([-1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 5.0], NegativeDiameter),
            ([1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -5.0], NegativeHeight),
            ([1.0, 0.0, 0.0, 0.0, 50.0, 40.0, 5.0], Angles),
            ([1.0, 0.0, 0.0, 0.0, -5.0, 0.0, 5.0], NegativeAlpha),
            ([10.0, 0.0, 0.0, 0.0, 60.0, 0.0, 5.0], TooLow),
            ([10.0, -1.0, 0.0, 0.0, 0.0, 0.0, 5.0], NegativeCornerRadius),
            ([10.0, 1.0, 6.5, 1.0, 0.0, 0.0, 5.0], CornerOutsideUpperLine),
            ([10.0, 1.0, 4.0, 1.5, 0.0, 0.0, 5.0], CornerMissesLowerLine),
            ([10.0, 1.0, 3.0, 1.0, 0.0, 0.0, 5.0], CornerMissesUpperLine),
            ([10.0, 6.0, -1.0, 6.0, 0.0, 0.0, 20.0], CornerMeetsLowerLineBadly),
            ([10.0, 0.0, 0.0, 0.0, 0.0, -60.0, 5.0], NoUpperLine),
            ([10.0, 1.0, 4.0, 4.9, 0.0, 0.0, f64::NAN], NotAShape),
        ] {
            assert_eq!(Profile::new(&cutter(v)), Err(reason), "{v:?}");
        }
    }

    /// A ball whose corner radius is half the diameter but for digits is round, however its centre was written.
    #[test]
    fn a_ball_with_rounded_numbers_is_round() {
        for off in [-3e-5, -5e-13, -1e-15, 0.0, 1e-15, 5e-13, 3e-5] {
            let r = 5.0 + off;
            let round = |c: &Cutter| {
                let p = Profile::new(c).unwrap();
                assert!((p.widest() - 5.0).abs() < 1e-4 && (p.corner()[1] - 5.0).abs() < 1e-4);
                p.is_round()
            };
            assert_eq!(round(&Cutter::mill(10.0, r, 40.0)), off > -1e-9, "{off}");
            // The centre on the axis, or where d/2 - r has it.
            assert!(round(&cutter([10.0, r, 0.0, r, 0.0, 0.0, 40.0])), "{off}");
            assert_eq!(round(&cutter([10.0, r, -off, r, 0.0, 0.0, 40.0])), off > -1e-9, "{off}");
        }
        // Neither are a flat of some thousandths and a corner that is beyond the axis by more.
        assert!(!Profile::new(&Cutter::mill(10.0, 4.999, 40.0)).unwrap().is_round());
        assert!(Profile::new(&Cutter::mill(10.0, 5.002, 4.9)).is_err());
    }

    /// A tapered ball whose diameter has nine digits, rounded up or down, is round.
    #[test]
    fn a_tapered_ball_with_rounded_numbers_is_round() {
        for off in [-3e-6, -1e-9, 0.0, 1e-9, 3e-6] {
            let (s, c) = (trig::sin_deg(12.0), trig::cos_deg(12.0));
            let d = 2.0 * (1.8 / c - 1.8 * s / c) + off;
            let p = Profile::new(&cutter([d, 1.8, 0.0, 1.8, 0.0, 12.0, 40.0])).unwrap();
            assert!(p.is_round(), "{off}");
            assert_eq!(p.corner(), [0.0, 1.8]);
            assert!((p.top_radius() - (0.5 * d + 40.0 * s / c)).abs() < 1e-5);
        }
        // With a lower line the arc is tangent to that too.
        let (sa, ca) = (trig::sin_deg(20.0), trig::cos_deg(20.0));
        let (sb, cb) = (trig::sin_deg(5.0), trig::cos_deg(5.0));
        let f = 3.0 / ca;
        let side = 3.0 * cb - (f - 3.0 * sb) * sb / cb;
        let d = 2.0 * side / (1.0 - sa / ca * sb / cb);
        let p = Profile::new(&cutter([d - 1e-9, 3.0, 0.0, f, 20.0, 5.0, 40.0])).unwrap();
        assert!(p.is_round());
        let [[x, z], _] = p.joints();
        assert!((x - 3.0 * sa).abs() < 1e-9 && (z - x * sa / ca).abs() < 1e-9, "{x} {z}");
    }

    #[test]
    fn an_arc_that_is_not_tangent_leaves_edges() {
        // Centre .5 above the bottom, radius 1: the arc leaves the bottom with an edge.
        let p = Profile::new(&cutter([10.0, 1.0, 4.0, 0.5, 0.0, 0.0, 8.0])).unwrap();
        let [[x, z], _] = p.joints();
        assert!((x - (4.0 + 0.75_f64.sqrt())).abs() < 1e-12 && z.abs() < 1e-15);
        // A pointed nose: two arcs of radius 13 meeting on the axis.
        let p = Profile::new(&cutter([16.0, 13.0, -5.0, 12.0, 0.0, 0.0, 30.0])).unwrap();
        assert_eq!(p.joints()[0], [0.0, 0.0]);
        assert_eq!(p.widest(), 8.0);
    }

    #[test]
    fn what_is_pointed() {
        for (numbers, pointed) in [
            ([10.0, 0.0, 5.0, 0.0, 0.0, 0.0, 30.0], false),
            ([10.0, 5.0, 0.0, 5.0, 0.0, 0.0, 30.0], false),
            ([10.0, 2.0, 3.0, 2.0, 0.0, 0.0, 30.0], false),
            (
                [8.0, 0.0, 4.0, 4.0 * trig::sin_deg(20.0) / trig::cos_deg(20.0), 20.0, 0.0, 25.0],
                true,
            ),
            ([16.0, 13.0, -5.0, 12.0, 0.0, 0.0, 30.0], true),
        ] {
            let p = Profile::new(&cutter(numbers)).unwrap();
            assert_eq!(p.is_pointed(), pointed, "{numbers:?}");
        }
    }
}
