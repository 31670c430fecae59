//! How many megabytes of CL text a core edits in a second, and in how much memory.
//!
//! `cargo bench -p aptc-edit`. 100 MB under a TRACUT, and 50 MB that a COPY repeats from a temporary file.

use std::io::{self, Read};

use aptc_cldata::{
    Dialect, Reader, Record, RecordReader, RecordWriter, Spill, Spool, TextOptions, TextWriter,
};
use aptc_edit::Editor;
use aptc_testkit::bench;

/// A head, a text again and again, a tail.
fn stream<'a>(head: &'a str, text: &'a str, times: u64, tail: &'a str) -> impl Read + 'a {
    let body = (0..times).map(|_| text.as_bytes());
    let parts: Vec<&[u8]> =
        std::iter::once(head.as_bytes()).chain(body).chain([tail.as_bytes()]).collect();
    Parts { parts, at: 0, done: 0 }
}

struct Parts<'a> {
    parts: Vec<&'a [u8]>,
    at: usize,
    done: usize,
}

impl Read for Parts<'_> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        while let Some(part) = self.parts.get(self.at) {
            let rest = &part[self.done..];
            if rest.is_empty() {
                (self.at, self.done) = (self.at + 1, 0);
                continue;
            }
            let n = rest.len().min(out.len());
            out[..n].copy_from_slice(&rest[..n]);
            self.done += n;
            return Ok(n);
        }
        Ok(0)
    }
}

fn moves() -> String {
    let mut text = String::new();
    for i in 0..20_000_u32 {
        let t = f64::from(i);
        let (x, y) = (t % 400.0 + t / 1e4, t % 311.0 - t / 1e5);
        text.push_str(&format!("GOTO/{x:.6},{y:.6},{:.6}\n", t % 7.0));
    }
    text
}

fn edit(input: impl Read) -> u64 {
    let mut reader = Reader::open(input, Some(Dialect::Iso)).expect("memory is read");
    let options = TextOptions { marks: false, ..TextOptions::default() };
    let mut out = TextWriter::new(io::sink(), options);
    let file = || Ok(Box::new(tempfile::tempfile()?) as Box<dyn Spill>);
    let mut editor = Editor::with_spool(Spool::spilling(file));
    let mut record = Record::default();
    let mut n = 0;
    while reader.read(&mut record).expect("memory is read") {
        editor.push(&record, &mut out).expect("a sink takes all");
        n += 1;
    }
    editor.finish(&mut out).expect("a sink takes all");
    out.finish().expect("a sink takes all");
    assert!(editor.take_diagnostics().is_empty());
    n
}

fn main() {
    let text = moves();
    let mb = |times: u64| text.len() as f64 * times as f64 / 1e6;
    let times = |mb: u64| mb * 1_000_000 / text.len() as u64;
    let n = times(100);
    bench::rate("edit CL text under TRACUT", mb(n), "MB/s", None, || {
        let head = "UNITS/MM\nTRACUT/0,1,0,5,-1,0,0,6,0,0,1,7\n";
        edit(stream(head, &text, n, "TRACUT/NOMORE\nFINI\n"))
    });
    let n = times(50);
    bench::rate("copy CL text once by a file", 2.0 * mb(n), "MB/s", None, || {
        edit(stream("UNITS/MM\nINDEX/1\n", &text, n, "COPY/1,TRANSL,1,2,3,1\nFINI\n"))
    });
    if let Some(peak) = bench::peak_memory() {
        bench::figure("peak memory of editing", peak, "MiB", None);
    }
}
