//! What holds from statement to statement: modal words, part surface, position of the tool.

use std::sync::Arc;

use aptc_geometry::{BadCutter, Cutter, Form, Plane, Profile, Vec3};
use aptc_protap::{
    Dimension, DriveSide, NameRef, OptionSurface, PartSide, SurfaceRef, ToolAxis, Units,
};

/// Historic defaults, in millimetres: they were inches and are converted to the unit of the program.
const OUTTOL_MM: f64 = 0.0005 * 25.4;
const MAXDP_MM: f64 = 10.0 * 25.4;

/// Surfaces with a tolerance and a thickness of their own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    Part = 0,
    Drive = 1,
    Check = 2,
    SecondCheck = 3,
}

/// Tolerance on one surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Band {
    /// Allowed violation.
    pub(crate) intol: f64,
    /// Allowed excess.
    pub(crate) outtol: f64,
}

/// The part surface.
#[derive(Clone, Debug)]
pub(crate) enum Part {
    /// PSIS, GO, or the xy plane when none was given.
    Surface(SurfaceRef),
    /// AUTOPS whose plane waits for the tool to have a position.
    Auto,
}

/// Modal settings.
#[derive(Clone, Debug)]
pub(crate) struct Settings {
    pub(crate) units: Units,
    pub(crate) cutter: Option<Cutter>,
    /// Disks of CUTTER/OPTION: radius and height.
    pub(crate) part_disk: Option<(f64, f64)>,
    pub(crate) drive_disk: Option<(f64, f64)>,
    /// What touches each surface, or why the cutter is none.
    profile: Option<Result<Profile, String>>,
    intol: [f64; 4],
    outtol: Option<[f64; 4]>,
    /// Was said which band is taken where these leave none?
    least_said: bool,
    maxdp: Option<f64>,
    /// Greatest length of a path of regional milling by MAXDP, until it was told that it counts for no other motion.
    pub(crate) longest_path: Option<f64>,
    pub(crate) numpts: Option<u32>,
    pub(crate) calc: Dimension,
    pub(crate) thick: [f64; 4],
    /// Was it told that this thickness does not count in a pocket?
    pub(crate) thick_told: bool,
    pub(crate) multax: bool,
    pub(crate) multax_told: bool,
    pub(crate) axis: ToolAxis,
    pub(crate) axis_before: ToolAxis,
    /// RADIUS or HIGHT of TLAXIS were given, and it was not said yet that they do not count.
    pub(crate) contact_chosen: bool,
    pub(crate) part: Part,
    pub(crate) nops: bool,
    /// The last of TLLFT, TLRGT, TLON, TLNDON; none yet.
    pub(crate) drive_side: Option<DriveSide>,
    /// Was it told that the tool is on the other side than this word says?
    pub(crate) astray_told: bool,
    /// The last of TLONPS, TLOFPS; none yet, or since a GO that named the part surface.
    pub(crate) part_side: Option<PartSide>,
    /// Does GO with its drive surface alone put the tool end on the part surface? The last of TLONPS, TLOFPS and of the
    /// GOs that named the part surface says so, whatever stood between. Source: what APT-360 does.
    pub(crate) ends_on_part: bool,
    /// The part surface of the last GO, and whether it put the tool end on it; none when the tool has moved since
    /// otherwise than along surfaces.
    pub(crate) started: Option<(Arc<Form>, bool)>,
    /// Unit normal of the part surface where the last start-up in space ended. One whose part surface has another goes to
    /// where its direction pierces the drive surface and on from there the least way.
    pub(crate) part_normal_before: Option<Vec3>,
    /// Directions of INDIRV, or of INDIRP from where the tool stood then, for the next motion along surfaces; GOTO and the like
    /// between leave them. Source: what APT-360 does.
    pub(crate) given: Vec<Option<Vec3>>,
    pub(crate) normals: Vec<Option<Vec3>>,
    pub(crate) cut: bool,
}

/// Where the tool is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Tool {
    /// Tool end.
    pub(crate) te: Vec3,
    /// Unit tool axis.
    pub(crate) ta: Vec3,
    /// Unit direction of the last motion that did not run along the axis; x before the first.
    pub(crate) forward: Vec3,
    /// Was there none yet?
    pub(crate) assumed: bool,
    /// The unit direction of INDIRV or INDIRP, where nothing moved the tool since.
    pub(crate) sense: Option<Vec3>,
    /// The axis with which it stands there, when another one was given since.
    pub(crate) stood: Option<Vec3>,
}

impl Tool {
    /// A tool that nothing brought to its place.
    pub(crate) fn at(te: Vec3, ta: Vec3) -> Self {
        Self { te, ta, forward: Vec3::x(), assumed: true, sense: None, stood: None }
    }
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            units: Units::default(),
            cutter: None,
            part_disk: None,
            drive_disk: None,
            profile: None,
            intol: [0.0; 4],
            least_said: false,
            maxdp: None,
            longest_path: None,
            numpts: None,
            calc: Dimension::Two,
            outtol: None,
            thick: [0.0; 4],
            thick_told: false,
            multax: false,
            multax_told: false,
            axis: ToolAxis::Fixed(Vec3::z()),
            axis_before: ToolAxis::Fixed(Vec3::z()),
            contact_chosen: false,
            part: Part::Surface(part_plane(DEFAULT_PART, Vec3::z(), 0.0)),
            nops: false,
            drive_side: None,
            astray_told: false,
            part_side: None,
            ends_on_part: false,
            started: None,
            part_normal_before: None,
            given: Vec::new(),
            normals: Vec::new(),
            cut: true,
        }
    }
}

impl Settings {
    pub(crate) fn set_intol(&mut self, t: [f64; 4]) {
        self.intol = t;
        self.least_said = false;
    }

    /// Does GO lift the tool to a part surface that nobody gave? That it goes down to it is usual, and meant.
    pub(crate) fn lifts(&self, from_z: f64, to_z: f64) -> bool {
        let default = matches!(&self.part, Part::Surface(s) if s.name.name == DEFAULT_PART);
        let rise = to_z - from_z;
        default
            && !self.nops
            && from_z < 0.0
            && rise > 1e-6 * from_z.abs()
            && rise > self.outtol_of_part()
    }

    /// Less than this is no other height.
    pub(crate) fn outtol_of_part(&self) -> f64 {
        self.outtol.map_or(OUTTOL_MM / self.units.mm(), |t| t[0])
    }

    /// So deep the cutter may be in the part surface.
    pub(crate) fn intol_of_part(&self) -> f64 {
        self.intol[0]
    }

    pub(crate) fn set_outtol(&mut self, t: [f64; 4]) {
        self.outtol = Some(t);
        self.least_said = false;
    }

    /// CUTTER of that line.
    pub(crate) fn set_cutter(&mut self, cutter: Cutter, line: u32) {
        self.cutter = Some(cutter);
        let profile = Profile::new(&cutter);
        let given = || {
            let values: Vec<_> = cutter.values().iter().map(f64::to_string).collect();
            format!("CUTTER/{} of line {line}", values.join(","))
        };
        self.profile = Some(profile.map_err(|bad| match why(bad) {
            Some(why) => format!("{why} ({})", given()),
            None => format!("{} ({})", open(&cutter), given()),
        }));
    }

    /// The disk that stands for the cutter against the surface of that role.
    pub(crate) fn disk(&self, role: Role) -> Option<(f64, f64)> {
        match role {
            Role::Part => self.part_disk,
            Role::Drive => self.drive_disk,
            Role::Check | Role::SecondCheck => None,
        }
    }

    /// What touches the surface of that role; `None` before any CUTTER.
    pub(crate) fn profile(&self, role: Role) -> Option<Result<Profile, String>> {
        match self.disk(role) {
            Some((r, h)) => {
                let of = || format!("CUTTER/OPTION with the radius {r} and the height {h}");
                Some(Profile::disk(r, h).map_err(|_| of()))
            }
            None => self.profile.clone(),
        }
    }

    pub(crate) fn set_maxdp(&mut self, step: f64, length: Option<f64>) {
        self.maxdp = Some(step);
        self.longest_path = length.filter(|l| *l > 0.0);
    }

    /// Greatest length of a cut vector along curved surfaces.
    pub(crate) fn maxdp(&self) -> f64 {
        self.maxdp.map_or(MAXDP_MM / self.units.mm(), f64::abs)
    }

    pub(crate) fn set_disk(&mut self, surface: OptionSurface, disk: Option<(f64, f64)>) {
        match surface {
            OptionSurface::Part => self.part_disk = disk,
            OptionSurface::Drive => self.drive_disk = disk,
        }
    }

    pub(crate) fn set_axis(&mut self, axis: ToolAxis) {
        let next = match axis {
            ToolAxis::Last => self.axis_before.clone(),
            axis => axis,
        };
        let [radius, height] = match &next {
            ToolAxis::Parallel { radius, height, .. } => [*radius, *height],
            ToolAxis::Angle(a) => [a.radius, a.height],
            _ => [None; 2],
        };
        self.contact_chosen = radius.or(height).is_some();
        self.axis_before = std::mem::replace(&mut self.axis, next);
    }

    /// A start-up says anew whether the tool end is on the drive surface: a word for its side that says
    /// otherwise holds no longer, as in APT4.
    pub(crate) fn start_side(&mut self, on: bool) {
        let said = matches!(self.drive_side, Some(DriveSide::Tlon | DriveSide::Tlndon));
        if said != on {
            self.drive_side = None;
        }
    }

    /// A start-up that names the part surface says anew whether the tool end is on it: TLONPS or TLOFPS before it holds no
    /// longer, as in APT-360.
    pub(crate) fn start_part(&mut self, surface: &SurfaceRef, on: bool) {
        self.started = Some((Arc::clone(&surface.form), on));
        self.part_side = None;
        self.ends_on_part = on;
        self.part = Part::Surface(surface.clone());
        self.nops = false;
    }

    /// The band that is taken for one of no width on part, drive or check surface, unless it was said.
    pub(crate) fn untold_least(&mut self) -> Option<f64> {
        let outtol = self.outtol?;
        let none = (0..3).any(|i| outtol[i].max(0.0) + self.intol[i].max(0.0) == 0.0);
        let untold = none && !self.least_said;
        self.least_said |= untold;
        untold.then(|| self.least())
    }

    fn least(&self) -> f64 {
        OUTTOL_MM / self.units.mm() * 1e-4
    }

    /// Tolerance band on the surface of that role; never of no width.
    pub(crate) fn band(&self, role: Role) -> Band {
        let default = OUTTOL_MM / self.units.mm();
        let outtol = self.outtol.map_or(default, |t| t[role as usize]).max(0.0);
        let intol = self.intol[role as usize].max(0.0);
        // A band of no width has no chord of a curve in it.
        if outtol + intol > 0.0 {
            Band { intol, outtol }
        } else {
            Band { intol, outtol: self.least() }
        }
    }

    pub(crate) fn thick(&self, role: Role) -> f64 {
        self.thick[role as usize]
    }
}

/// Why a cutter is none.
fn why(bad: BadCutter) -> Option<&'static str> {
    Some(match bad {
        BadCutter::NegativeDiameter => "negative diameter",
        BadCutter::NegativeHeight => "negative height",
        BadCutter::Angles => "the two angles add up to 90 degrees or more",
        BadCutter::NegativeAlpha => "negative alpha",
        BadCutter::TooLow => "the two lines meet above the top",
        BadCutter::NegativeCornerRadius => "negative corner radius",
        _ => return None,
    })
}

/// Lines and corner that do not close, with the corner that would.
fn open(cutter: &Cutter) -> String {
    let text = "its lines and its corner do not close";
    let Some([e, f]) = cutter.tangent_corner().map(|c| c.map(|x| (x * 1e6).round() / 1e6)) else {
        return text.into();
    };
    format!("{text}: a corner that touches both lines has e {e} and f {f}")
}

/// The unit vector; none for one without a length.
pub(crate) fn unit(v: Vec3) -> Option<Vec3> {
    let l = v.norm();
    (l > 0.0 && l.is_finite()).then(|| v / l)
}

/// What messages call the part surface of a program that gives none.
const DEFAULT_PART: &str = "the part surface z=0 (no PSIS is given)";
/// What messages call that of AUTOPS.
const AUTO_PART: &str = "the part surface of AUTOPS";

fn part_plane(called: &str, n: Vec3, d: f64) -> SurfaceRef {
    let name = NameRef { name: called.into(), subscript: 0 };
    SurfaceRef { name, form: Arc::new(Form::Plane(Plane { n, d })) }
}

/// The plane of AUTOPS: through the tool end, across the tool axis.
pub(crate) fn auto_part(te: Vec3, ta: Vec3) -> SurfaceRef {
    part_plane(AUTO_PART, ta, ta.dot(&te))
}

/// Is it the plane of AUTOPS?
pub(crate) fn is_auto(part: &SurfaceRef) -> bool {
    part.name.name == AUTO_PART
}

impl Tool {
    /// Does it stand with its axis, not with the one before it?
    pub(crate) fn stands(&self) -> bool {
        const SAME: f64 = 1e-9;
        self.stood.is_none_or(|stood| (stood - self.ta).norm() <= SAME)
    }

    /// Takes a direction that is given for the next motion.
    pub(crate) fn sense(&mut self, along: Vec3) {
        self.turn(along);
        self.sense = along.try_normalize(0.0);
    }

    /// Takes the direction of a move unless it ran along the axis or nowhere.
    pub(crate) fn turn(&mut self, along: Vec3) {
        let length = along.norm();
        if length > 0.0 {
            self.sense = None;
        }
        let across = along - self.ta * along.dot(&self.ta);
        if length > 0.0 && across.norm() > 1e-6 * length {
            self.forward = along / length;
            self.assumed = false;
        }
    }
}
