//! Under an axis that turns, a motion over a patch to a plane that is tangent along its border ends at the border, and not on what goes
//! on straight beyond it; a path that goes on there is refuted.

#[path = "support/held.rs"]
mod held;
#[path = "support/run.rs"]
mod run;

use aptc_control::Verify;
use aptc_verify::Breach;
use held::held;

/// A patch with the section `p`, a Bezier curve whose last side lies in a plane, and that plane; `across` is (y, z) a unit of its
/// height and of what lies across.
fn surfaces(p: [[f64; 2]; 4], shift: f64, across: [[f64; 2]; 2], size: f64) -> String {
    let [high, aside] = across;
    let place = |[x, h]: [f64; 2], v: f64| {
        let [y, z] = [0, 1].map(|i| h * high[i] + v * aside[i]);
        format!("({},{},{})", x * size, y * size, z * size)
    };
    let slope = (p[3][1] - p[2][1]) / (p[3][0] - p[2][0]);
    let row = |v: f64| {
        let at = |i: usize| {
            // What lies on the first and the last side may be anywhere on it.
            let by = if i == 1 || i == 2 { shift * v } else { 0.0 };
            let rise = if i == 2 { slope * by } else { 0.0 };
            place([p[i][0] + by, p[i][1] + rise], v)
        };
        [0, 1, 2, 3].map(at).join(",$\n")
    };
    let rows = [-70.0, -20.0, 20.0, 70.0].map(row).join(",$\n");
    let [ny, nz] = high;
    let d = (p[3][1] - slope * p[3][0]) * size;
    format!("SL=PLANE/{},{ny},{nz},{d}\nCY=SSURF/PATCH,POLYGN,PLUS,$\n{rows}\n", -slope)
}

/// Over a patch, or along one that stands, to `to`.
struct Scene {
    section: [[f64; 2]; 4],
    shift: f64,
    cutter: &'static str,
    bands: [f64; 2],
    axis: &'static str,
    stands: bool,
    size: f64,
}

impl Scene {
    fn tangent(&self) -> &'static str {
        if self.stands { "TANTO,SL" } else { "PSTAN,SL" }
    }

    fn text(&self, to: &str) -> String {
        let Self { section, shift, cutter, bands: [intol, outtol], axis, stands, size } = self;
        let (x, up) = (5.0 * size, 30.0 * size);
        let across = if *stands { [[1.0, 0.0], [0.0, 1.0]] } else { [[0.0, 1.0], [1.0, 0.0]] };
        let surfaces = surfaces(*section, *shift, across, *size);
        let cutter: Vec<String> = cutter
            .split(',')
            .map(|c| (c.parse::<f64>().unwrap_or(0.0) * size).to_string())
            .collect();
        let head = format!(
            "UNITS/MM\n{surfaces}W=PLANE/{},0\nCUTTER/{}\nINTOL/{}\nOUTTOL/{}\nMULTAX\n",
            if *stands { "0,0,1" } else { "0,1,0" },
            cutter.join(","),
            intol * size,
            outtol * size
        );
        let ahead = "INDIRV/1,0,0";
        if *stands {
            format!(
                "{head}FROM/{x},{},{up}\nTLAXIS/{axis}\nINDIRV/0,1,0\n\
                 GO/TO,CY,TO,W,ON,(PLANE/1,0,0,{x})\n{ahead}\nTLRGT,TLOFPS,GOFWD/CY,{to}\nFINI\n",
                -20.0 * size
            )
        } else {
            format!(
                "{head}FROM/{x},0,{up}\nTLAXIS/{axis}\nGO/ON,W,TO,CY,ON,(PLANE/1,0,0,{x})\n\
                 {ahead}\nTLON,TLOFPS,GOFWD/W,{to}\nFINI\n"
            )
        }
    }
}

/// How far the tool end may be beside what it touches: the radius of the cutter and some of its lean.
const BESIDE: f64 = 4.5;

/// Sections that come to their last side from above and from below, and one that does not bend where it ends.
const SECTIONS: [[[f64; 2]; 4]; 3] = [
    [[0.0, 0.0], [21.0, 0.0], [42.0, -0.8], [64.0, -2.0]],
    [[0.0, 0.0], [15.0, 0.0], [55.0, -6.25], [71.0, -10.5]],
    [[0.0, 0.0], [20.0, 0.0], [45.0, 2.0], [70.0, 5.0]],
];

const FLAT: &str = "8,0,4,0,0,0,25";

fn scenes() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for section in SECTIONS {
        for (stands, axis) in [
            (false, "NORMPS"),
            (false, "ATANGL,1,15"),
            (false, "ATANGL,1,15,CUTANG,5"),
            (true, "PARLEL,2"),
            (true, "ATANGL,1,5"),
            (false, "0,0,1"),
            (true, "0,0,1"),
        ] {
            for (cutter, bands, size) in [
                ("8,4,0,4,0,0,25", [0.005, 0.005], 1.0),
                ("8,2,2,2,0,0,25", [0.01, 0.01], 0.1),
                (FLAT, [0.0, 0.02], 1.0),
            ] {
                let shift = if stands { 0.02 } else { 0.0 };
                scenes.push(Scene { section, shift, cutter, bands, axis, stands, size });
            }
        }
    }
    scenes
}

#[test]
fn a_motion_ends_where_the_patch_does() {
    for scene in scenes() {
        let text = scene.text(scene.tangent());
        let ran = run::run(&text, Verify::Full);
        assert_eq!(ran.faults(), Vec::<String>::new(), "{:?} {text}", ran.told);
        let end = ran.places.last().expect("it goes")[0] / scene.size;
        // The tool end lies beside the place that it touches by its radius at most, and is in the band some way before.
        let joint = scene.section[3][0];
        assert!(end < joint + BESIDE && end > joint - 2.0 * BESIDE, "{end} {joint} {text}");
    }
}

/// All of rounded cutters, and most of flat ends: of one that touches with its edge it is not told.
#[test]
fn a_path_that_goes_on_beyond_the_patch_is_refuted() {
    let mut open = 0;
    for scene in scenes() {
        let joint = scene.section[3][0];
        for on in [20.0, 60.0] {
            let path = scene.text(&format!("ON,(PLANE/1,0,0,{})", (joint + on) * scene.size));
            let asked = scene.text(scene.tangent());
            let (certificate, _) = held(&path, &asked);
            let fault = certificate.statements.last().and_then(|s| s.fault.clone());
            let Some(fault) = fault else {
                assert_eq!(scene.cutter, FLAT, "no fault {path} {asked}");
                open += 1;
                continue;
            };
            assert!(fault.refuted && fault.breach == Some(Breach::Past), "{fault:?} {path}");
            let (at, by) = (fault.te[0] / scene.size, fault.depth / scene.size);
            assert!(
                (at - joint).abs() < BESIDE && (by - on).abs() < 2.0 * BESIDE,
                "{fault:?} {path}"
            );
        }
    }
    assert!(open <= 9, "{open}");
}
