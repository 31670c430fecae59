//! The package: a program without dependencies on shared libraries, as a tarball and as a `.deb`.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::repository::{cargo, linked_statically, read, root, target_folder, triple};

const SHELLS: [(&str, &str); 3] = [
    ("bash", "share/bash-completion/completions/aptc"),
    ("zsh", "share/zsh/vendor-completions/_aptc"),
    ("fish", "share/fish/vendor_completions.d/aptc.fish"),
];

/// Files of the repository beside the program, and where they go.
const PAPERS: [(&str, &str); 6] = [
    ("README.md", "share/doc/aptc/README.md"),
    ("CHANGELOG.md", "share/doc/aptc/CHANGELOG.md"),
    ("LICENSE-MIT", "share/doc/aptc/LICENSE-MIT"),
    ("LICENSE-APACHE", "share/doc/aptc/LICENSE-APACHE"),
    ("editors/apt.tmLanguage.json", "share/aptc/apt.tmLanguage.json"),
    ("editors/apt-cl.tmLanguage.json", "share/aptc/apt-cl.tmLanguage.json"),
];

/// Builds, stages and packs into `target/package`.
pub(crate) fn run() -> Result<(), String> {
    let target = target_folder()?;
    let triple = triple()?;
    done(linked_statically(
        cargo().args(["build", "--release", "--locked", "--package", "aptc"]),
        &triple,
    ))?;
    let program = target.join(&triple).join("release/aptc");
    let version = version()?;
    let packages = target.join("package");
    let name = format!("aptc-{version}-{triple}");
    let stage = packages.join(&name);
    if stage.exists() {
        fs::remove_dir_all(&stage).map_err(|e| format!("{}: {e}", stage.display()))?;
    }
    stage_files(&program, &stage)?;
    let tarball = packages.join(format!("{name}.tar.gz"));
    done(
        Command::new("tar")
            .args(["--sort=name", "--owner=0", "--group=0", "--numeric-owner", "--mtime=@0"])
            .args(["--gzip", "--create", "--file"])
            .arg(&tarball)
            .arg("--directory")
            .args([&packages, Path::new(&name)]),
    )?;
    println!("{}", tarball.display());
    deb(&stage, &packages, &version)
}

/// The tree of an installation below `stage`: `bin`, `share`.
fn stage_files(program: &Path, stage: &Path) -> Result<(), String> {
    copy(program, &stage.join("bin/aptc"))?;
    let aptc = || Command::new(program);
    done(aptc().args(["man", "--output"]).arg(stage.join("share/man/man1")))?;
    for (shell, path) in SHELLS {
        let output = aptc().args(["completions", shell]).output();
        let script = output.ok().filter(|o| o.status.success());
        let script = script.ok_or_else(|| format!("aptc completions {shell} failed"))?.stdout;
        let path = stage.join(path);
        make_room(&path)?;
        fs::write(&path, script).map_err(|e| format!("{}: {e}", path.display()))?;
    }
    PAPERS.iter().try_for_each(|(from, to)| copy(&root().join(from), &stage.join(to)))
}

/// The same tree below `/usr`, with a control file.
fn deb(stage: &Path, packages: &Path, version: &str) -> Result<(), String> {
    if Command::new("dpkg-deb").arg("--version").output().is_err() {
        println!("dpkg-deb is not there: no .deb");
        return Ok(());
    }
    let architecture = Command::new("dpkg").arg("--print-architecture").output();
    let architecture = architecture.map_err(|e| format!("dpkg: {e}"))?.stdout;
    let architecture = String::from_utf8_lossy(&architecture).trim().to_owned();
    let tree = packages.join("deb");
    if tree.exists() {
        fs::remove_dir_all(&tree).map_err(|e| format!("{}: {e}", tree.display()))?;
    }
    let control = tree.join("DEBIAN/control");
    make_room(&control)?;
    let text = format!(
        "Package: aptc\nVersion: {version}\nArchitecture: {architecture}\nSection: science\n\
         Priority: optional\nMaintainer: the aptc project <aptc@localhost>\n\
         Description: compiler for APT part programs\n \
         Surfaces and motions of a cutter in English-like statements become cutter location\n \
         data and machine code; every cut vector is proved to lie inside its tolerance.\n"
    );
    fs::write(&control, text).map_err(|e| format!("{}: {e}", control.display()))?;
    done(Command::new("cp").arg("-a").arg(stage).arg(tree.join("usr")))?;
    let file = packages.join(format!("aptc_{version}_{architecture}.deb"));
    done(Command::new("dpkg-deb").args(["--build", "--root-owner-group"]).args([&tree, &file]))
}

fn copy(from: &Path, to: &Path) -> Result<(), String> {
    make_room(to)?;
    fs::copy(from, to).map(|_| ()).map_err(|e| format!("{}: {e}", from.display()))
}

fn make_room(path: &Path) -> Result<(), String> {
    let folder = path.parent().expect("a file lies in a folder");
    fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))
}

fn done(command: &mut Command) -> Result<(), String> {
    let name = command.get_program().to_string_lossy().into_owned();
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("{name}: {status}")),
        Err(error) => Err(format!("{name}: {error}")),
    }
}

/// `version` of the workspace.
fn version() -> Result<String, String> {
    let manifest = read(&root().join("Cargo.toml"))?;
    let line = manifest.lines().find_map(|l| l.strip_prefix("version = "));
    line.map(|v| v.trim_matches('"').to_owned())
        .ok_or_else(|| "Cargo.toml has no version".to_owned())
}
