//! Regional milling on the surface that other programs were measured on, judged by their exact drop heights.
//!
//! The folder `../shared/peers` holds the surface (`surface.py`, needs numpy) and the judge (`exact.c`), which
//! knows neither patches nor chords: along each cut vector the tool end is compared with the height at which the
//! cutter rests there.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use aptc_testkit::bench::children_seconds;

use crate::repository::{cargo, read, root, target_folder};

/// Diameter and corner radius, with a name.
const CUTTERS: [(&str, f64, f64); 2] = [("ball D10", 10.0, 5.0), ("bull D12 r2", 12.0, 2.0)];
/// INTOL and OUTTOL.
const BANDS: [f64; 2] = [0.005, 0.01];
/// Lines of 100 mm, 10 mm and 1 mm apart: those that are judged and those that are timed.
const JUDGED: u32 = 11;
const TIMED: u32 = 101;

/// Reads cutter, control net and tool ends from its input; prints the greatest gouge and what is left at most,
/// in the direction of the normal, from places .05 along each cut vector.
const JUDGE: &str = r#"
#include <stdio.h>
static double at(double x, double y, double z, double R, double rc) {
  double cx, cy, h = 1e-4, t = drop1(x, y, R, rc, &cx, &cy);
  double p = (f(cx + h, cy) - f(cx - h, cy)) / (2 * h), q = (f(cx, cy + h) - f(cx, cy - h)) / (2 * h);
  return (z - t) / sqrt(1 + p * p + q * q);
}
int main(void) {
  double c[64 * 64], lo, step, R, rc, p[3], q[3], least = 0, most = 0;
  int n, first = 1;
  if (scanf("%lf %lf %lf %lf %d", &R, &rc, &lo, &step, &n) != 5 || n > 64) return 1;
  for (int i = 0; i < n * n; i++) if (scanf("%lf", c + i) != 1) return 1;
  setup(c, n, lo, step);
  while (scanf("%lf %lf %lf", q, q + 1, q + 2) == 3) {
    double way = first ? 0 : sqrt((q[0]-p[0])*(q[0]-p[0]) + (q[1]-p[1])*(q[1]-p[1]) + (q[2]-p[2])*(q[2]-p[2]));
    if (way < 40) {
      int m = (int)(way / 0.05) + 1;
      for (int k = 0; k <= m; k++) {
        double s = first ? 1 : (double)k / m, g[3];
        for (int i = 0; i < 3; i++) g[i] = first ? q[i] : p[i] + (q[i] - p[i]) * s;
        double off = at(g[0], g[1], g[2], R, rc);
        if (off < least) least = off;
        if (off > most) most = off;
      }
    }
    for (int i = 0; i < 3; i++) p[i] = q[i];
    first = 0;
  }
  printf("%.9f %.9f\n", -least, most);
  return 0;
}
"#;

/// The control net of the surface: heights over a square grid.
struct Net {
    /// Knot step, and coordinate of the first control point.
    step: f64,
    start: f64,
    heights: Vec<Vec<f64>>,
}

/// Runs the chore.
pub(crate) fn run() -> Result<(), String> {
    let peers = root().join("../shared/peers");
    if !peers.is_dir() {
        return Err(format!("{} is not there", peers.display()));
    }
    let target = target_folder()?;
    let (folder, aptc) = (target.join("peers"), target.join("release/aptc"));
    std::fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let net = net(&peers)?;
    let judge = build_judge(&peers, &folder)?;
    write(&folder.join("BUMPS.json"), &surface(&net))?;
    let built = cargo().args(["build", "--release", "--quiet", "-p", "aptc"]).status();
    if !built.is_ok_and(|status| status.success()) {
        return Err("aptc does not build".to_owned());
    }
    println!(
        "| cutter | INTOL, OUTTOL | points a line | ms a line | greatest gouge | left at most |"
    );
    println!("|---|--:|--:|--:|--:|--:|");
    for (name, diameter, corner) in CUTTERS {
        for band in BANDS {
            let points = compile(&aptc, &folder, &program(diameter, corner, band, JUDGED))?.0;
            let [gouge, left] = judged(&judge, &net, diameter, corner, &points)?;
            let one = compile(&aptc, &folder, &program(diameter, corner, band, 1))?.1;
            let all = compile(&aptc, &folder, &program(diameter, corner, band, TIMED))?.1;
            let ms = 1e3 * (all - one) / f64::from(TIMED - 1);
            #[expect(clippy::cast_precision_loss, reason = "thousands")]
            let each = points.len() as f64 / f64::from(JUDGED);
            println!("| {name} | {band} | {each:.0} | {ms:.1} | {gouge:.6} | {left:.6} |");
            if gouge > band || left > band {
                return Err(format!("{name} leaves the band of {band}"));
            }
        }
    }
    Ok(())
}

fn net(peers: &Path) -> Result<Net, String> {
    let output = Command::new("python3").arg(peers.join("surface.py")).arg("net").output();
    let output = output.map_err(|error| format!("python3 does not start: {error}"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    let wrong = || "surface.py tells no net".to_owned();
    let value: serde_json::Value = serde_json::from_slice(&output.stdout).map_err(|_| wrong())?;
    let heights = serde_json::from_value(value["C"].clone()).map_err(|_| wrong())?;
    let number = |key: &str| value[key].as_f64().ok_or_else(wrong);
    Ok(Net { step: number("H")?, start: number("X0")?, heights })
}

fn build_judge(peers: &Path, folder: &Path) -> Result<PathBuf, String> {
    let (source, program) = (folder.join("judge.c"), folder.join("judge"));
    let exact = read(&peers.join("exact.c"))?;
    write(&source, &format!("{exact}\n{JUDGE}"))?;
    let built =
        Command::new("cc").arg("-O2").arg("-o").arg(&program).arg(&source).arg("-lm").status();
    match built {
        Ok(status) if status.success() => Ok(program),
        _ => Err("cc does not build the judge".to_owned()),
    }
}

/// The surface as a B-spline for READ.
fn surface(net: &Net) -> String {
    let n = net.heights.len();
    #[expect(clippy::cast_precision_loss, reason = "a few")]
    let at = |i: usize| net.start + net.step * i as f64;
    #[expect(clippy::cast_precision_loss, reason = "a few")]
    let knots: Vec<f64> = (0..n + 4).map(|i| net.start + net.step * (i as f64 - 2.0)).collect();
    let row = |j: usize| (0..n).map(|i| [at(i), at(j), net.heights[i][j]]).collect::<Vec<_>>();
    let points: Vec<_> = (0..n).map(row).collect();
    serde_json::json!({"unit": "mm", "surfaces": [
        {"degree": [3, 3], "knots": [knots, knots], "points": points}]})
    .to_string()
}

/// Lines over 0 to 100, the tool led along z.
fn program(diameter: f64, corner: f64, band: f64, lines: u32) -> String {
    let mut text = format!(
        "PARTNO PEERS\nUNITS/MM\nREAD/1,BUMPS\nUP=VECTOR/0,0,1\nDOWN=VECTOR/0,0,-1\n\
         OVER=SSURF/SMESH,XYZ,SPLINE,(0,0,60),(100,0,60),$\nSPLINE,(0,100,60),(100,100,60)\n\
         CUTTER/{diameter},{corner}\nINTOL/{band}\nOUTTOL/{band}\nFROM/0,0,80\nFEDRAT/900\n\
         SCON/DS,OVER,PARAM,0,1,0,1,ON,DOWN\nSCON/PS,TO,BUMPS,PLUS,0\nSCON/AXIS,UP\nCHKSRF/PS,ON\n"
    );
    for k in 0..lines {
        let v = f64::from(k) / f64::from(lines.max(2) - 1);
        writeln!(text, "SMIL/PATH,DS,PARAM,0,{v},TANSPL,PLUS").expect("a string takes all");
        text.push_str("GODLTA/0,0,90\n");
    }
    text + "FINI\n"
}

/// Tool ends on the surface, and the seconds of processor time that it took.
fn compile(aptc: &Path, folder: &Path, text: &str) -> Result<(Vec<[f64; 3]>, f64), String> {
    write(&folder.join("lines.apt"), text)?;
    let before = children_seconds();
    let output = Command::new(aptc)
        .args(["compile", "lines.apt", "--emit", "cl", "--verify", "off", "--threads", "1"])
        .current_dir(folder)
        .output()
        .map_err(|error| format!("aptc does not start: {error}"))?;
    let seconds = children_seconds() - before;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    let mut points = Vec::new();
    for line in read(&folder.join("lines.cl"))?.lines() {
        let Some(numbers) = line.strip_prefix("GOTO/") else { continue };
        let numbers: Vec<f64> = numbers.split(',').filter_map(|x| x.trim().parse().ok()).collect();
        if let [x, y, z, ..] = *numbers.as_slice()
            && z < 60.0
        {
            points.push([x, y, z]);
        }
    }
    Ok((points, seconds))
}

fn judged(
    judge: &Path,
    net: &Net,
    diameter: f64,
    corner: f64,
    points: &[[f64; 3]],
) -> Result<[f64; 2], String> {
    let radius = 0.5 * diameter;
    let (low, n) = (net.start + net.step, net.heights.len());
    let mut text = format!("{radius} {corner} {low} {} {n}\n", net.step);
    for z in net.heights.iter().flatten() {
        writeln!(text, "{z}").expect("a string takes all");
    }
    for [x, y, z] in points {
        writeln!(text, "{x} {y} {z}").expect("a string takes all");
    }
    let failed = |error: std::io::Error| format!("the judge does not run: {error}");
    let mut child =
        Command::new(judge).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().map_err(failed)?;
    if let Some(mut input) = child.stdin.take() {
        input.write_all(text.as_bytes()).map_err(failed)?;
    }
    let output = child.wait_with_output().map_err(failed)?;
    let told = String::from_utf8_lossy(&output.stdout);
    let numbers: Vec<f64> = told.split_whitespace().filter_map(|x| x.parse().ok()).collect();
    <[f64; 2]>::try_from(numbers).map_err(|_| "the judge tells nothing".to_owned())
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    std::fs::write(path, text).map_err(|error| format!("{}: {error}", path.display()))
}
