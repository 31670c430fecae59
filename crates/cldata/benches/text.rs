//! How many megabytes of CL text a core reads, and reads and writes, in a second.
//!
//! `cargo bench -p aptc-cldata`. 200 MB of moves, every fourth with a tool axis, and some post-processor
//! words; the file is made on the way, so that the peak of memory is the reader's and the writer's own.

use std::io::{self, Read};

use aptc_cldata::{
    Dialect, Kind, Reader, Record, RecordReader, RecordWriter, TextOptions, TextWriter,
};
use aptc_testkit::bench;

const SIZE: usize = 200_000_000;

/// A text again and again.
struct Repeated<'a> {
    text: &'a [u8],
    at: usize,
    left: usize,
}

impl Read for Repeated<'_> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        let rest = &self.text[self.at..];
        let n = rest.len().min(out.len()).min(self.left);
        out[..n].copy_from_slice(&rest[..n]);
        self.at = (self.at + n) % self.text.len();
        self.left -= n;
        Ok(n)
    }
}

/// About 4 MB: moves in three axes, every fourth in five, a feed rate now and then.
fn moves() -> String {
    let mut text = String::from("UNITS/MM\n");
    let mut seed = 1_u64;
    let mut random = |span: f64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (((seed >> 33) as f64) / f64::from(1_u32 << 31) - 0.5) * span
    };
    for i in 0.. {
        let (x, y, z) = (random(400.0), random(400.0), random(80.0));
        match i % 40 {
            39 => text.push_str("FEDRAT/850,MMPM\n"),
            n if n % 4 == 3 => {
                let (a, b) = (random(0.6), random(0.6));
                let c = (1.0 - a * a - b * b).sqrt();
                text.push_str(&format!("GOTO / {x:.6}, {y:.6}, {z:.6}, {a:.8}, {b:.8}, {c:.8}\n"));
            }
            _ => text.push_str(&format!("GOTO/{x:.6},{y:.6},{z:.6}\n")),
        }
        if text.len() > 4_000_000 {
            return text;
        }
    }
    text
}

fn read(text: &str, size: usize) -> usize {
    let input = Repeated { text: text.as_bytes(), at: 0, left: size };
    let mut reader = Reader::open(input, Some(Dialect::Iso)).expect("memory is read");
    let mut record = Record::default();
    let mut n = 0;
    while reader.read(&mut record).expect("memory is read") {
        n += usize::from(matches!(record.kind, Kind::Motion(_)));
    }
    n
}

fn read_and_write(text: &str, size: usize) -> usize {
    let input = Repeated { text: text.as_bytes(), at: 0, left: size };
    let mut reader = Reader::open(input, Some(Dialect::Iso)).expect("memory is read");
    let options = TextOptions { marks: false, ..TextOptions::default() };
    let mut writer = TextWriter::new(io::sink(), options);
    let mut record = Record::default();
    let mut n = 0;
    while reader.read(&mut record).expect("memory is read") {
        writer.write(&record).expect("a sink takes all");
        n += 1;
    }
    writer.finish().expect("a sink takes all");
    n
}

fn main() {
    let text = moves();
    let mb = |size: usize| size as f64 / 1e6;
    for (name, size) in [("read 20 MB of CL text", SIZE / 10), ("read 200 MB of CL text", SIZE)] {
        bench::rate(name, mb(size), "MB/s", Some(400.0), || read(&text, size));
    }
    bench::rate("read and write 200 MB of CL text", mb(SIZE), "MB/s", Some(200.0), || {
        read_and_write(&text, SIZE)
    });
    if let Some(peak) = bench::peak_memory() {
        bench::figure("peak memory of CL text", peak, "MiB", None);
    }
}
