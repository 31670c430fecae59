//! Fuzz targets, each for a time.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::repository::{files, read, root};

/// More memory than this for one input is a finding: MiB.
const MOST_MEMORY: &str = "-rss_limit_mb=1024";
/// A longer run of one input is a finding: seconds.
const LONGEST_INPUT: &str = "-timeout=10";

/// Runs the chore with its options `[SECONDS] [TARGET]`.
pub(crate) fn run(options: &[&str]) -> Result<(), String> {
    let seconds = options.iter().find_map(|option| option.parse::<u32>().ok()).unwrap_or(60);
    let filter = options.iter().find(|option| option.parse::<u32>().is_err());
    if !cargo_fuzz(&["--version"]).is_ok_and(|good| good) {
        return Err("fuzz needs cargo-fuzz: `cargo install cargo-fuzz`".to_owned());
    }
    let targets: Vec<String> =
        targets()?.into_iter().filter(|target| filter.is_none_or(|f| target.contains(f))).collect();
    if targets.is_empty() {
        return Err("no fuzz target of that name".to_owned());
    }
    let aids = Aids::prepare()?;
    let mut broken = Vec::new();
    for target in targets {
        println!("xtask: {target} for {seconds} s");
        let time = format!("-max_total_time={seconds}");
        let kept = root().join("fuzz/corpus").join(&target);
        fs::create_dir_all(&kept).map_err(|error| format!("{}: {error}", kept.display()))?;
        let (kept, seeds) = (kept.display().to_string(), aids.seeds.display().to_string());
        let dictionary = format!("-dict={}", aids.dictionary.display());
        // Optimised, but with overflow and debug assertions on: they are what is to be broken.
        let places = ["run", &target, &kept, &seeds, "--"];
        let limits = [&time, MOST_MEMORY, LONGEST_INPUT, &dictionary, "-print_final_stats=1"];
        if !cargo_fuzz(&[places.as_slice(), &limits].concat())? {
            broken.push(target);
        }
    }
    aids.remove();
    if broken.is_empty() { Ok(()) } else { Err(format!("fuzz: findings in {}", broken.join(", "))) }
}

/// What helps the fuzzer to inputs that are nearly right: corpus programs with their goldens, and the words.
struct Aids {
    folder: PathBuf,
    seeds: PathBuf,
    dictionary: PathBuf,
}

impl Aids {
    fn prepare() -> Result<Self, String> {
        let folder = std::env::temp_dir().join(format!("aptc-fuzz-{}", std::process::id()));
        let (seeds, dictionary) = (folder.join("seeds"), folder.join("words"));
        let unwritable =
            |path: &Path, error: std::io::Error| format!("{}: {error}", path.display());
        fs::create_dir_all(&seeds).map_err(|error| unwritable(&seeds, error))?;
        let table = read(&root().join("crates/vocabulary/words.tsv"))?;
        let words = table.lines().skip(1).filter_map(|line| line.split('\t').next());
        let words: String = words.map(|word| format!("\"{word}\"\n")).collect();
        fs::write(&dictionary, words).map_err(|error| unwritable(&dictionary, error))?;
        for (path, number) in
            files()?.into_iter().filter(|path| path.starts_with("corpus")).zip(0..)
        {
            let seed = seeds.join(format!("{number}"));
            fs::copy(root().join(&path), &seed).map_err(|error| unwritable(&path, error))?;
        }
        Ok(Self { folder, seeds, dictionary })
    }

    fn remove(&self) {
        if let Err(error) = fs::remove_dir_all(&self.folder) {
            println!("xtask: {}: {error}", self.folder.display());
        }
    }
}

/// Names of the files in `fuzz/fuzz_targets`.
fn targets() -> Result<Vec<String>, String> {
    let folder = root().join("fuzz/fuzz_targets");
    let entries = fs::read_dir(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let paths = entries.flatten().map(|entry| entry.path());
    let mut names: Vec<String> = paths
        .filter(|path| path.extension().is_some_and(|e| e == "rs"))
        .filter_map(|path| path.file_stem().map(|name| name.to_string_lossy().into_owned()))
        .collect();
    names.sort();
    Ok(names)
}

/// Whether `cargo fuzz` ends well. It needs switches of the compiler that are not stable yet; the
/// variable opens them on a stable one.
fn cargo_fuzz(arguments: &[&str]) -> Result<bool, String> {
    Command::new("cargo")
        .arg("fuzz")
        .args(arguments)
        .current_dir(root())
        .env("RUSTC_BOOTSTRAP", "1")
        .status()
        .map(|status| status.success())
        .map_err(|error| format!("cargo does not start: {error}"))
}
