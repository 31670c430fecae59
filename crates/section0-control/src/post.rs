//! Section 4 for every machine that a part program names.

use aptc_cldata::{Arg, Kind, Record};
use aptc_diagnostics::{Diagnostic, Span, codes};
use aptc_post::{Machine, Post, PostOptions, ToolScan};

use crate::MachineChoice;

/// Machine code for one machine.
#[derive(Debug, Default)]
pub struct Nc {
    /// Name of the machine.
    pub machine: String,
    /// The text.
    pub text: Vec<u8>,
    /// Machining time in seconds.
    pub seconds: f64,
    /// Is it for a machine after the first?
    pub further: bool,
}

/// Posts an edited CL stream for the machine that was chosen, else for those that MACHIN names, else for the
/// default machine. A text that the post refused is left out.
pub fn post_part(records: &[Record], choice: Option<&MachineChoice>) -> (Vec<Nc>, Vec<Diagnostic>) {
    let mut diagnostics = Vec::new();
    let machines = match machines(records, choice, &mut diagnostics) {
        Ok(m) => m,
        Err(d) => {
            diagnostics.extend(d);
            return (Vec::new(), diagnostics);
        }
    };
    let mut scan = ToolScan::default();
    for record in records {
        scan.push(record);
    }
    let tools = scan.finish();
    let mut texts = Vec::new();
    for (i, machine) in machines.iter().enumerate() {
        let options = PostOptions { tools: tools.clone(), ..PostOptions::default() };
        let mut post = Post::new(machine, options);
        let mut text = Vec::new();
        for record in records {
            post.push(record, &mut text);
        }
        let posted = post.finish(&mut text);
        let refused = posted.diagnostics.iter().any(Diagnostic::is_error);
        for d in posted.diagnostics {
            if !diagnostics.contains(&d) {
                diagnostics.push(d);
            }
        }
        if !refused && !text.is_empty() {
            let machine = machine.name.clone();
            texts.push(Nc {
                machine,
                text,
                seconds: 60.0 * (posted.summary.cut_minutes + posted.summary.rapid_minutes),
                further: i > 0,
            });
        }
    }
    (texts, diagnostics)
}

fn machines(
    records: &[Record],
    choice: Option<&MachineChoice>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Result<Vec<Machine>, Vec<Diagnostic>> {
    match choice {
        Some(MachineChoice::File(_, text)) => return Machine::parse(text).map(|m| vec![m]),
        Some(MachineChoice::Named(name)) => {
            if let Some(m) = aptc_post::machine(name).or_else(|| aptc_post::machine_for(name, &[]))
            {
                return Ok(vec![m.clone()]);
            }
            let known: Vec<_> = aptc_post::machines().map(|m| m.name.as_str()).collect();
            let message = format!("there is no machine {name}");
            return Err(vec![
                Diagnostic::error(codes::MACHINE_FILE, Span::default(), message)
                    .help(format!("give a machine file, or one of {}", known.join(", "))),
            ]);
        }
        None => {}
    }
    let (mut found, mut unknown) = (Vec::<Machine>::new(), Vec::new());
    for record in records {
        let Kind::Post { word, args } = &record.kind else { continue };
        let (true, Some(Arg::Word(name))) = (word == "MACHIN", args.first()) else { continue };
        match aptc_post::machine_for(name, &args[1..]) {
            Some(m) if found.iter().any(|f| f.name == m.name) => {}
            Some(m) => found.push(m.clone()),
            None => unknown.push((name.clone(), record.origin.clone())),
        }
    }
    if !found.is_empty() {
        return Ok(found);
    }
    let default = aptc_post::machine("linuxcnc-mill").expect("it is built in");
    let (span, message) = match unknown.first() {
        Some((name, origin)) => (
            origin.span,
            format!("{name} is no machine that aptc knows; posted for {}", default.title),
        ),
        None => (Span::default(), format!("no MACHIN statement; posted for {}", default.title)),
    };
    diagnostics.push(
        Diagnostic::note_at(codes::MACHINE_ASSUMED, span, message)
            .help("choose a machine with --machine; `aptc machines` lists them"),
    );
    Ok(vec![default.clone()])
}
