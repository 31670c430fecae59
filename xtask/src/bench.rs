//! Benchmarks: runs them, prints medians, writes `docs/performance.md`.
//!
//! A name `GROUP: WHAT` stands in the table of its group; what is wanted beside a peer is the peer's rate.
//!
//! A benchmark is a `[[bench]]` target without the harness whose program measures through
//! `aptc_testkit::bench` and so prints lines `BENCH <tab> name <tab> rate <tab> unit <tab> target`. It is
//! started several times: the spread between starts is larger than within one.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use crate::repository::{cargo, linked_statically, root, triple};

/// The figures of one benchmark, one a start.
#[derive(Default)]
struct Series {
    rates: Vec<f64>,
    unit: String,
    target: Option<f64>,
}

/// The figures by group and name.
type AllSeries = BTreeMap<(String, String), Series>;

/// Runs the chore with its options `[FILTER] [--runs N]`.
pub(crate) fn run(options: &[&str]) -> Result<(), String> {
    let (filter, runs) = parse(options)?;
    let mut series = AllSeries::new();
    let triple = triple()?;
    for run in 1..=runs {
        println!("xtask: benchmarks, run {run} of {runs}");
        let mut command = cargo();
        linked_statically(command.args(["bench", "--quiet", "--workspace", "--benches"]), &triple);
        command.arg("--").args(filter);
        let output = command.output().map_err(|error| format!("cargo does not start: {error}"))?;
        if !output.status.success() {
            return Err(String::from_utf8_lossy(&output.stderr).into_owned());
        }
        for line in String::from_utf8_lossy(&output.stdout).lines() {
            take(line, &mut series);
        }
    }
    if series.is_empty() {
        return Err("no benchmark of that name".to_owned());
    }
    let table = table(&mut series);
    print!("{table}");
    if filter.is_some() {
        return Ok(());
    }
    let path = root().join("docs/performance.md");
    let page = format!("{}\n{table}", preface(runs));
    std::fs::write(&path, page).map_err(|error| format!("{}: {error}", path.display()))
}

fn parse<'a>(options: &[&'a str]) -> Result<(Option<&'a str>, usize), String> {
    let (mut filter, mut runs) = (None, 5);
    let mut options = options.iter();
    while let Some(option) = options.next() {
        if *option == "--runs" {
            runs = options.next().and_then(|n| n.parse().ok()).ok_or("--runs needs a number")?;
        } else {
            filter = Some(*option);
        }
    }
    Ok((filter, runs))
}

fn take(line: &str, series: &mut AllSeries) {
    let fields: Vec<&str> = line.split('\t').collect();
    let ["BENCH", name, rate, unit, target] = fields.as_slice() else { return };
    let Ok(rate) = rate.parse() else { return };
    let (group, name) = name.split_once(": ").unwrap_or(("rates", name));
    let entry = series.entry((group.to_owned(), name.to_owned())).or_default();
    entry.rates.push(rate);
    (*unit).clone_into(&mut entry.unit);
    entry.target = target.parse().ok();
}

fn preface(runs: usize) -> String {
    let cpu = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let link = std::env::var("CARGO_PROFILE_BENCH_LTO");
    let link = link.map_or(String::new(), |how| format!(" Link-time optimisation: {how}."));
    let model = cpu.lines().find_map(|line| line.strip_prefix("model name")?.split(": ").nth(1));
    format!(
        "# Performance\n\nMade by `cargo xtask bench`: medians of {runs} starts, least and greatest beside \
         them, per second of processor time on one core of {}.{link}\n\
         Linked without shared libraries, as the package is.\n",
        model.unwrap_or("a machine that does not tell its name")
    )
}

fn table(series: &mut AllSeries) -> String {
    let mut out = String::new();
    let mut before = None;
    for ((group, name), Series { rates, unit, target }) in series {
        if before != Some(group) {
            let wanted = if group.starts_with("beside") { "theirs" } else { "wanted" };
            write!(
                out,
                "\n## {}\n\n| what | median | least | greatest | unit | {wanted} | ratio |\n\
                 |---|--:|--:|--:|---|--:|--:|\n",
                capital(group)
            )
            .expect("a string takes all");
            before = Some(group);
        }
        rates.sort_by(f64::total_cmp);
        let median = rates[rates.len() / 2];
        let (least, most) = (rates[0], rates[rates.len() - 1]);
        let (wanted, share) = target.map_or((String::new(), String::new()), |target| {
            (figure(target), format!("{:.2}", median / target))
        });
        let (median, least, most) = (figure(median), figure(least), figure(most));
        writeln!(out, "| {name} | {median} | {least} | {most} | {unit} | {wanted} | {share} |")
            .expect("a string takes all");
    }
    out
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// Three significant figures, thousands apart.
fn figure(value: f64) -> String {
    if value < 100.0 {
        let decimals = if value < 1.0 {
            3
        } else if value < 10.0 {
            2
        } else {
            1
        };
        return format!("{value:.decimals$}");
    }
    let digits = format!("{value:.0}");
    let zeros = digits.len().saturating_sub(3);
    let rounded = format!("{:.0}", value / 10f64.powi(i32::try_from(zeros).unwrap_or(0)));
    let digits = rounded + &"0".repeat(zeros);
    let head = digits.len() % 3;
    let groups = digits.as_bytes()[head..].chunks(3).map(String::from_utf8_lossy);
    let groups: Vec<_> =
        (head > 0).then(|| digits[..head].into()).into_iter().chain(groups).collect();
    groups.join(",")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_have_three_digits() {
        for (value, text) in [
            (0.1234, "0.123"),
            (9.876, "9.88"),
            (31.416, "31.4"),
            (314.16, "314"),
            (31_416.0, "31,400"),
            (999_600.0, "1,000,000"),
            (4_123_456.0, "4,120,000"),
        ] {
            assert_eq!(figure(value), text);
        }
    }

    #[test]
    fn medians_stand_between_their_runs() {
        let mut series = AllSeries::new();
        for rate in ["3.0", "9.0", "4.0"] {
            take(&format!("BENCH\tparse\t{rate}\tMB/s\t2"), &mut series);
        }
        take("running 0 tests", &mut series);
        let table = table(&mut series);
        assert!(table.contains("\n## Rates\n"), "{table}");
        assert!(table.contains("| parse | 4.00 | 3.00 | 9.00 | MB/s | 2.00 | 2.00 |"), "{table}");
    }
}
