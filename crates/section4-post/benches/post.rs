//! Lines of machine code a second of processor time.

use aptc_cldata::{Arg, Kind, Motion, Position, Record, Units};
use aptc_geometry::{Vec3, trig};
use aptc_post::{Post, PostOptions, machine};
use aptc_testkit::bench;

const N: u32 = 200_000;

/// A surface-like path: three decimals change in X and Z, Y at each row.
fn path(tilted: bool) -> Vec<Record> {
    let record = |kind| Record { origin: Default::default(), kind };
    let post = |word: &str, args: Vec<Arg>| record(Kind::Post { word: word.into(), args });
    let mut list = vec![
        record(Kind::Units(Units::Mm)),
        post("LOADTL", vec![Arg::Number(1.0)]),
        post("SPINDL", vec![Arg::Number(9000.0)]),
        post("FEDRAT", vec![Arg::Number(2000.0)]),
    ];
    for i in 0..N {
        let t = f64::from(i) * 0.37;
        let row = f64::from(i / 500);
        let te = Vec3::new(t % 185.0, row * 0.5, 3.0 * trig::sin(t * 0.05) - 10.0);
        let ta = if tilted {
            Vec3::new(0.2 * trig::sin(t * 0.003), 0.2 + 0.1 * trig::cos(t * 0.002), 1.0).normalize()
        } else {
            Vec3::z()
        };
        let points = vec![Position { te, ta }];
        list.push(record(Kind::Motion(Motion { points, with_axis: tilted, ..Motion::default() })));
    }
    list.push(record(Kind::Fini));
    list
}

fn lines(name: &str, records: &[Record], check: bool) -> u64 {
    let options = PostOptions { check, ..PostOptions::default() };
    let mut post = Post::new(machine(name).expect("built in"), options);
    let mut out = Vec::with_capacity(1 << 18);
    for r in records {
        post.push(r, &mut out);
        if out.len() > 1 << 17 {
            out.clear();
        }
    }
    let posted = post.finish(&mut out);
    assert!(!posted.diagnostics.iter().any(aptc_diagnostics::Diagnostic::is_error));
    posted.summary.blocks
}

fn main() {
    let (flat, tilted) = (path(false), path(true));
    for (what, machine, records, check, target) in [
        ("post 3-axis", "linuxcnc-mill", &flat, false, 5.0),
        ("post 3-axis, read back", "linuxcnc-mill", &flat, true, 2.0),
        ("post 5-axis", "linuxcnc-5axis", &tilted, false, 1.5),
        ("post 5-axis, read back", "linuxcnc-5axis", &tilted, true, 0.5),
    ] {
        #[expect(clippy::cast_precision_loss, reason = "a count of lines")]
        let n = lines(machine, records, check) as f64;
        bench::rate(what, n / 1e6, "M lines/s", Some(target), || lines(machine, records, check));
    }
}
