//! The machines that come with the program.

use std::sync::LazyLock;

use aptc_cldata::Arg;

use super::Machine;

/// The machine files, in the order of the list.
const FILES: &[(&str, &str)] = &[
    ("linuxcnc-mill", include_str!("../../machines/linuxcnc-mill.toml")),
    ("linuxcnc-4axis", include_str!("../../machines/linuxcnc-4axis.toml")),
    ("linuxcnc-5axis", include_str!("../../machines/linuxcnc-5axis.toml")),
    ("linuxcnc-5axis-bar", include_str!("../../machines/linuxcnc-5axis-bar.toml")),
    ("linuxcnc-5axis-head", include_str!("../../machines/linuxcnc-5axis-head.toml")),
    ("linuxcnc-5axis-head-table", include_str!("../../machines/linuxcnc-5axis-head-table.toml")),
    ("linuxcnc-5axis-nutated", include_str!("../../machines/linuxcnc-5axis-nutated.toml")),
    ("linuxcnc-lathe", include_str!("../../machines/linuxcnc-lathe.toml")),
    ("linuxcnc-lathe-xy", include_str!("../../machines/linuxcnc-lathe-xy.toml")),
    ("linuxcnc-lathe-c", include_str!("../../machines/linuxcnc-lathe-c.toml")),
    ("fanuc-0i-lathe", include_str!("../../machines/fanuc-0i-lathe.toml")),
    ("fanuc-0i-lathe-c", include_str!("../../machines/fanuc-0i-lathe-c.toml")),
    ("fanuc-0i-mill", include_str!("../../machines/fanuc-0i-mill.toml")),
    ("fanuc-31i-5axis", include_str!("../../machines/fanuc-31i-5axis.toml")),
    ("haas-vf", include_str!("../../machines/haas-vf.toml")),
    ("haas-umc", include_str!("../../machines/haas-umc.toml")),
    ("siemens-840d-mill", include_str!("../../machines/siemens-840d-mill.toml")),
    ("siemens-840d-5axis", include_str!("../../machines/siemens-840d-5axis.toml")),
    ("heidenhain-tnc", include_str!("../../machines/heidenhain-tnc.toml")),
    ("heidenhain-tnc-5axis", include_str!("../../machines/heidenhain-tnc-5axis.toml")),
    ("grbl", include_str!("../../machines/grbl.toml")),
    ("apt", include_str!("../../machines/apt.toml")),
];

/// A machine that is read when it is asked for.
type Lazy = LazyLock<Machine, Box<dyn FnOnce() -> Machine + Send + Sync>>;

static MACHINES: LazyLock<Vec<Lazy>> = LazyLock::new(|| {
    let lazy = |&(name, text): &(&'static str, &'static str)| {
        let read =
            move || Machine::parse(text).unwrap_or_else(|d| unreachable!("machine {name}: {d:?}"));
        LazyLock::new(Box::new(read) as Box<dyn FnOnce() -> Machine + Send + Sync>)
    };
    FILES.iter().map(lazy).collect()
});

/// All built-in machines.
pub fn machines() -> impl Iterator<Item = &'static Machine> {
    MACHINES.iter().map(|m| &**m)
}

/// The built-in machine of that name; only its file is read.
pub fn machine(name: &str) -> Option<&'static Machine> {
    let idx = FILES.iter().position(|(n, _)| n.eq_ignore_ascii_case(name))?;
    MACHINES.get(idx).map(|m| &**m)
}

/// The machine file of that built-in machine, to read and to begin another with.
pub fn machine_file(name: &str) -> Option<&'static str> {
    FILES.iter().find(|(n, _)| n.eq_ignore_ascii_case(name)).map(|(_, text)| *text)
}

/// The built-in machine that `MACHIN/name,args` means.
///
/// A name with its number (`PMILL,5`) goes before the name alone.
pub fn machine_for(name: &str, args: &[Arg]) -> Option<&'static Machine> {
    let name = name.to_ascii_uppercase();
    let numbered = match args.first() {
        Some(Arg::Number(n)) => format!("{name},{n}"),
        _ => name.clone(),
    };
    let find = |wanted: &str| {
        let idx = FILES.iter().position(|(_, text)| meant(text).any(|m| m == wanted))?;
        MACHINES.get(idx).map(|m| &**m)
    };
    find(&numbered).or_else(|| find(&name)).or_else(|| machine(&name))
}

/// The names by which MACHIN may mean a built-in machine.
pub fn machin_names() -> impl Iterator<Item = &'static str> {
    FILES.iter().flat_map(|(_, text)| meant(text))
}

/// The same of one file, of which only the line is read that has them.
fn meant(text: &str) -> impl Iterator<Item = &str> {
    let line = text.lines().find(|l| l.starts_with("machin = "));
    line.unwrap_or_default().split('"').skip(1).step_by(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_names_are_those_of_the_machines() {
        let read: Vec<&str> = machines().flat_map(|m| &m.machin).map(String::as_str).collect();
        assert_eq!(machin_names().collect::<Vec<_>>(), read);
    }
}
