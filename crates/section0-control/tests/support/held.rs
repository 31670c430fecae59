//! A path held against what another program asks of its last motion.

use std::sync::Arc;

use aptc_cldata::{Control, Kind, Motion, MotionKind, Record};
use aptc_control::{Disk, Options, Source, Verify, compile};
use aptc_diagnostics::Diagnostic;
use aptc_verify::{Certificate, Effort, Verifier};

/// The records of a program that is right.
pub(crate) fn records(text: &str) -> Vec<Record> {
    let options = Options { verify: Verify::Off, post: false, ..Options::default() };
    let source = Source { name: "part".into(), text: text.into() };
    let compiled = compile(source, &mut Disk::new(Vec::new(), 0), &options);
    let wrong: Vec<_> = compiled.diagnostics.iter().filter(|d| d.is_error()).collect();
    assert!(wrong.is_empty(), "{wrong:?} {text}");
    compiled.parts[0].computed.to_vec().expect("they can be read")
}

/// What governs the last motion along surfaces.
pub(crate) fn last(records: &[Record]) -> Arc<Control> {
    let along = |r: &Record| match &r.kind {
        Kind::Motion(Motion { kind: MotionKind::Continuous, control, .. }) => control.clone(),
        _ => None,
    };
    records.iter().rev().find_map(along).expect("it moves along surfaces")
}

/// The path of one program, its last motion held against what the other asks of its own.
pub(crate) fn held(path: &str, asked: &str) -> (Certificate, Vec<Diagnostic>) {
    let mut records = records(path);
    let (own, control) = (last(&records), last(&self::records(asked)));
    let mut verifier = Verifier::new(Effort::Full);
    for record in &mut records {
        if let Kind::Motion(Motion { control: Some(c), .. }) = &mut record.kind
            && Arc::ptr_eq(c, &own)
        {
            *c = Arc::clone(&control);
        }
        verifier.push(record);
    }
    verifier.finish()
}
