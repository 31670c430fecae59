//! Plate cams: a TABCYL whose last point is its first goes round, and so does the tool, all of it proved.

#[path = "support/run.rs"]
mod run;

use std::fmt::Write as _;

use aptc_control::Verify;
use aptc_geometry::trig;

/// A cam and the way round it.
#[derive(Clone, Debug)]
struct Cam {
    fairing: &'static str,
    /// Points of a turn.
    n: u32,
    /// Where it begins and ends, in degrees.
    seam: f64,
    /// The points follow each other against the clock, or with it.
    ccw: bool,
    radius: f64,
    /// By how much it strays from the circle, and how often in a turn.
    lift: f64,
    lobes: f64,
    inside: bool,
    cutter: String,
    /// Direction of the start in degrees, and +1 where the tool goes round against the clock.
    start: f64,
    way: f64,
    band: f64,
    /// Half turns to the end behind the start, and how many of them.
    intersections: u32,
}

fn round() -> Cam {
    Cam {
        fairing: "SPLINE",
        n: 18,
        seam: 0.0,
        ccw: true,
        radius: 40.0,
        lift: 0.0,
        lobes: 0.0,
        inside: false,
        cutter: "10".into(),
        start: 90.0,
        way: 1.0,
        band: 0.01,
        intersections: 5,
    }
}

impl Cam {
    fn radius(&self, degrees: f64) -> f64 {
        self.radius + self.lift * trig::cos_deg(self.lobes * degrees)
    }

    fn points(&self) -> String {
        let mut points = String::new();
        for i in 0..=self.n {
            let turn = f64::from(i) * 360.0 / f64::from(self.n);
            let angle = self.seam + if self.ccw { turn } else { -turn };
            write!(points, ",$\n{angle},{:.6}", self.radius(angle)).unwrap_or_default();
        }
        points
    }

    /// From the start to the line through the centre 30 degrees on, which is met as often as that is asked.
    fn program(&self, axis: &str) -> String {
        let unit = |degrees: f64, size: f64| {
            let [x, y] = [trig::cos_deg(degrees), trig::sin_deg(degrees)].map(|x| x * size);
            format!("{x:.12},{y:.12},")
        };
        let (far, to) = if self.inside { (0.3, 1.0) } else { (2.0, -1.0) };
        let (start, way) = (self.start, self.way);
        // Against the clock what is inside of the curve lies to the left.
        let side = if (way > 0.0) == self.inside { "TLLFT" } else { "TLRGT" };
        format!(
            "UNITS/MM\nCAM=TABCYL/THETAR,{}{}\nBASE=PLANE/0,0,1,-5\nEND=PLANE/{}0,0\nCUTTER/{}\n\
             TOLER/{}\n{axis}FROM/{}20\nINDIRV/{}0\nGO/TO,CAM,TO,BASE\nINDIRV/{}0\n\
             {side},GOFWD/CAM,ON,{},INTOF,END\nFINI\n",
            self.fairing,
            self.points(),
            unit(start + 30.0 * way + 90.0, 1.0),
            self.cutter,
            self.band,
            unit(start, self.radius * far),
            unit(start, to),
            unit(start + 90.0 * way, 1.0),
            self.intersections
        )
    }

    /// How far the tool goes round, in degrees, by what the program says and by its path, where it begins upright to the cam.
    fn turns(&self, places: &[[f64; 3]]) -> [f64; 2] {
        let angle = |p: &[f64; 3]| trig::atan2(p[1], p[0]).to_degrees();
        let path = places.get(1..).unwrap_or_default();
        let step = |w: &[[f64; 3]]| {
            let by = angle(&w[1]) - angle(&w[0]);
            by - 360.0 * (by / 360.0).round()
        };
        let gone = self.way * path.windows(2).map(step).sum::<f64>();
        let begun = path.first().map_or(f64::NAN, |p| (angle(p) - self.start) * self.way);
        let begun = begun - 360.0 * (begun / 360.0).round();
        [30.0 - begun + 180.0 * f64::from(self.intersections - 1), gone]
    }

    /// What is wrong with its path, when anything is told of it or it does not go round so far.
    fn fault(&self, axis: &str) -> Option<String> {
        let ran = run::run(&self.program(axis), Verify::Full);
        let [asked, gone] = self.turns(&ran.places);
        // The line is met within the band.
        let met = (asked - gone).abs() < 2.0 * self.band;
        (!ran.told.is_empty() || !met).then(|| format!("{asked} {gone} {:?}", ran.told))
    }
}

/// The `i`th place of a low discrepancy sequence for the cam `k`.
fn share(k: u32, i: u32) -> f64 {
    (f64::from(k + 1) * 0.618_033_988_75 * f64::from(i)).fract()
}

/// Cams by chance, each way round, inside and outside, with the tool begun anywhere.
fn chance(k: u32) -> Cam {
    let share = |i: u32| share(k, i);
    let inside = share(1) < 0.4;
    let (diameter, corner) = (2.0 + if inside { 8.0 } else { 30.0 } * share(2), k % 3);
    let corner = [0.0, 0.1, 0.5][corner as usize] * diameter;
    let cutter = format!("{:.3},{:.4}", diameter, (corner - 1e-3).max(0.0));
    let lobes = f64::from(k % 4);
    Cam {
        n: [18, 24, 36, 60][(k / 2 % 4) as usize],
        seam: if k.is_multiple_of(2) { 360.0 * share(4) } else { 0.0 },
        ccw: share(5) < 0.5,
        radius: 30.0 + 20.0 * share(6),
        lift: 6.0 * share(7) / (1.0 + lobes * lobes),
        lobes,
        inside,
        cutter,
        start: 360.0 * share(8),
        way: if share(9) < 0.5 { 1.0 } else { -1.0 },
        band: [0.001, 0.01, 0.05][(k / 8 % 3) as usize],
        intersections: 1 + k / 3 % 5,
        ..round()
    }
}

/// Five degrees of a circle are met by their cubic to a ten-thousandth.
#[test]
fn a_round_cam_is_a_circle() {
    for (inside, ccw) in [(false, true), (false, false), (true, true), (true, false)] {
        for way in [1.0, -1.0] {
            for fairing in ["SPLINE", "TWOPT"] {
                let cam = Cam { fairing, n: 72, inside, ccw, way, ..round() };
                let ran = run::run(&cam.program(""), Verify::Full);
                assert!(ran.told.is_empty(), "{cam:?}: {:?}", ran.told);
                let around = 40.0 + if inside { -5.0 } else { 5.0 };
                for p in &ran.places[1..] {
                    let off = (p[0] * p[0] + p[1] * p[1]).sqrt() - around;
                    assert!(off.abs() < 0.0101 && (p[2] + 5.0).abs() < 1e-9, "{cam:?}: {off}");
                }
                let [asked, gone] = cam.turns(&ran.places);
                assert!((asked - gone).abs() < 1e-6 && gone > 740.0, "{cam:?}: {gone}");
            }
        }
    }
}

#[test]
fn cams_by_chance_are_cut_round() {
    let faults: Vec<String> =
        (0..120).filter_map(|k| Some(format!("{k}: {}", chance(k).fault("")?))).collect();
    assert!(faults.is_empty(), "{faults:#?}");
}

/// The tool leans by some ten degrees, over a cam that is smooth where it closes.
#[test]
fn a_leaning_tool_goes_round() {
    for k in 0..12 {
        let axis = format!(
            "MULTAX\nTLAXIS/{:.3},{:.3},1\n",
            0.3 * share(k, 12) - 0.15,
            0.3 * share(k, 13) - 0.15
        );
        let cam = Cam { lift: 0.0, n: 36, ..chance(k) };
        let ran = run::run(&cam.program(&axis), Verify::Full);
        assert!(ran.told.is_empty(), "{k}: {:?}", ran.told);
        let [_, gone] = cam.turns(&ran.places);
        assert!(gone >= 180.0 * f64::from(cam.intersections - 1), "{k}: {gone}");
    }
}

/// Splines through few points bend where they close: the tool rolls round the tip there, or comes out of the corner, also where it
/// begins on it.
#[test]
fn the_tool_goes_round_the_corner_where_a_cam_closes() {
    let corners = |k: u32| {
        let cam = chance(k);
        let n = [7, 8, 10, 12][(k % 4) as usize];
        let cutter = format!("{:.3}", 6.0 + 8.0 * share(k, 14));
        Cam { n, cutter, inside: k.is_multiple_of(2), lift: 0.0, intersections: 4, ..cam }
    };
    let faults: Vec<String> =
        (0..80).filter_map(|k| Some(format!("{k}: {}", corners(k).fault("")?))).collect();
    assert!(faults.is_empty(), "{faults:#?}");
}

/// FOURPT leaves slight corners between its spans; where they are hollow the gap is greatest on them, and over a floor that is not level
/// cut vectors cross them with the flank upright.
#[test]
fn slight_corners_hold_their_band_over_any_floor() {
    for (floor, cutter, thick, outtol, [from, to], points) in [
        (
            "PLANE/-.1,.05,1,0",
            "6,3",
            0.0,
            0.001,
            [20.0, -30.0],
            "48.5,34,43.8,40.4,22.9,54.4,3.2,59.3,-10.8,58.9,$\n-28.6,52,-47.2,35,-56.4,16.3,-60.3,5.3",
        ),
        (
            "CYLNDR/0,0,-200,1,0,0,200",
            "10",
            0.0,
            0.005,
            [20.0, -30.0],
            "47.3,33.1,27.2,53.3,17.4,55.9,7.5,57.6,$\n-24.3,54.9,-45.4,37.8,-52.5,24.5,-59.7,5.2",
        ),
        (
            "SPHERE/5,-3,-400,400",
            "4,.8",
            0.95,
            0.002,
            [10.0, -35.0],
            "47.073,38.8267,20.5967,53.008,1.9257,57.3363,$\n-12.3614,58.1021,-39.7759,49.0455,-54.8981,29.1417,-58.2897,11.4582",
        ),
    ] {
        let text = format!(
            "PARTNO CAM\nUNITS/MM\nF={floor}\nW=TABCYL/NOZ,FOURPT,{points}\nCUTTER/{cutter}\n\
             INTOL/0,.01,.01\nOUTTOL/.01,{outtol},{outtol}\nTHICK/0,{thick},0\nFROM/10,90,10\n\
             INDIRV/0,-1,0\nGO/TO,W,TO,F,ON,(PLANE/1,0,0,{from})\nINDIRV/-1,0,0\n\
             TLRGT,GOFWD/W,ON,(PLANE/1,0,0,{to})\nNOPOST\nFINI\n"
        );
        let ran = run::run(&text, Verify::Full);
        assert_eq!(ran.faults(), Vec::<String>::new(), "{floor} {cutter} {:?}", ran.told);
    }
}
