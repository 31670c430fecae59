//! Programs of others that our output is tried on, brought onto the machine where that is allowed.

use std::path::Path;
use std::process::{Command, Stdio};

/// A program and the Debian package that has it.
struct Client {
    program: &'static str,
    package: &'static str,
}

/// `rs274` is LinuxCNC's interpreter without the machine: it reads our G-code as the control would.
const CLIENTS: [Client; 1] = [Client { program: "rs274", package: "linuxcnc-uspace" }];

/// Installs what is missing. What cannot be installed is said; the tests that need it count as skipped.
pub(crate) fn install() {
    let missing: Vec<&Client> = CLIENTS.iter().filter(|client| !present(client.program)).collect();
    if missing.is_empty() {
        return;
    }
    let packages: Vec<&str> = missing.iter().map(|client| client.package).collect();
    let Some(apt_get) = apt_get() else {
        for client in missing {
            let Client { program, package } = client;
            println!("xtask: `{program}` is missing; as root: apt-get install {package}");
        }
        return;
    };
    println!("xtask: installing {}", packages.join(", "));
    let update = run(&apt_get, &["update", "-q"]);
    let install = [&["install", "-y", "-q", "--no-install-recommends"], packages.as_slice()];
    if let Err(reason) = update.and_then(|()| run(&apt_get, &install.concat())) {
        println!("xtask: {reason}");
    }
}

fn present(program: &str) -> bool {
    let path = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&path).any(|folder| folder.join(program).is_file())
}

/// The words that start apt-get, if this user may: root, or an unattended machine with free sudo.
fn apt_get() -> Option<Vec<&'static str>> {
    if !Path::new("/usr/bin/apt-get").exists() {
        return None;
    }
    let id = Command::new("id").arg("-u").output().ok()?;
    if id.stdout.trim_ascii() == b"0" {
        return Some(vec!["apt-get"]);
    }
    let unattended = std::env::var_os("CI").is_some();
    (unattended && run(&["sudo"], &["-n", "true"]).is_ok())
        .then(|| vec!["sudo", "-n", "--preserve-env=DEBIAN_FRONTEND", "apt-get"])
}

fn run(program: &[&str], arguments: &[&str]) -> Result<(), String> {
    let line = || [program, arguments].concat().join(" ");
    let status = Command::new(program[0])
        .args(&program[1..])
        .args(arguments)
        .env("DEBIAN_FRONTEND", "noninteractive")
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .status();
    match status {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("`{}` failed: {status}", line())),
        Err(error) => Err(format!("`{}` does not start: {error}", line())),
    }
}
