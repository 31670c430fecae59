//! Good files of every form, damaged in thousands of ways that are always the same: no panic, no number that
//! is none, messages with their line, and every writer takes what was read.

#![expect(clippy::unwrap_used, reason = "a test: it fails")]

use aptc_cldata::number::Decimals;
use aptc_cldata::{
    CatiaWriter, ClfileWriter, Dialect, JsonWriter, Kind, Reader, Record, RecordReader,
    RecordWriter, TapeWriter, TextOptions, TextWriter, flatten, stats,
};

/// Statements of all systems, each text a small program.
const TEXTS: [(Dialect, &str); 7] = [
    (
        Dialect::Iso,
        "PARTNO 'A'\nUNITS/MM\nMULTAX/ON\nCUTTER/10,1,4,1,0,0,50\nINTOL/0,.01\nFROM/0,0,50\nRAPID\n\
         GOTO/1,2,3,0,0,1\nMOVARC/0,0,2,0,0,1,10,ANGLE,90\nGOTO/0,10,2\nGODLTA/0,0,5\n\
         CYCLE/DRILL,DEPTH,5,MMPM,100,CLEAR,2\nGOTO/1,1,1\n2,2,2\nCYCLE/OFF\nINDEX/1\n\
         COPY/1,TRANSL,1,2,3,4\nTRACUT/1,0,0,0,0,1,0,0,0,0,1,0\nTRACUT/NOMORE\nDEFSUB/1\nENDSUB\nFINI\n",
    ),
    (
        Dialect::Catia,
        "$$     CATIA APT VERSION 1.0\n$$*CATIA0\n$$ OP\n$$  1.0 0.0 0.0 5.0\n$$  0.0 1.0 0.0 0.0\n\
         $$  0.0 0.0 1.0 0.0\nFEDRAT/  100.0,MMPM\nGOTO  /   10.0, 0.0, 2.0\nAUTOPS\n\
         INDIRV/ 0.0, 1.0, 0.0\nTLON,GOFWD/ (CIRCLE/ 0.0, 0.0, 2.0,$\n 10.0),ON,2,INTOF,$\n\
         (LINE/ 0.0, 0.0, 2.0, 0.0, -10.0, 2.0)\nPSIS/(PLANE/0,1,0,0)\n\
         TLON,GOFWD/(CYLNDR/0,0,0,0,1,0,10),ON,(PLANE/PERPTO,(PLANE/0,1,0,0),(POINT/0,0,0),(POINT/0,0,1))\n\
         HELICAL/0,0,2,0,1,0,0,0,1,450,10,0,10,-4\nTLAXIS/ 1.0, 0.0, 0.0\n",
    ),
    (
        Dialect::Nx,
        "TOOL PATH/OP,TOOL,T1\nTLDATA/MILL,10.0,1.0,75.0,0.0,0.0\nMSYS/0,0,0,1,0,0,0,1,0\nPAINT/PATH\n\
         LOAD/TOOL,2,ADJUST,2\nFEDRAT/MMPM,250.0\nGOTO/10.0,0.0,2.0,0.0,0.0,1.0\n\
         CIRCLE/0.0,0.0,2.0,0.0,0.0,-1.0,10.0,0.06,0.5,10.0,0.0,TIMES,2\nGOTO/0.0,10.0,2.0\nNURBS/\n\
         KNOT/0.5,1.0\nCNTRL/1,1,1\nCNTRL/2,2,2\nCNTRL/3,3,3\nCNTRL/4,4,4\nGOTO/5,5,5\nEND-OF-PATH\n",
    ),
    (
        Dialect::Creo,
        "$$*  Pro/CLfile  Version 11.0\n$$-> CUTTER / 6.0\n$$-> CSYS / 1,0,0,0, $\n 0,1,0,0,0,0,1,0\n\
         UNITS / MM\nGOTO / 10, 0, 2\nCIRCLE / 0, 0, 2, 0, 0, 1, 10\nGOTO / 0, 10, 2\n-10, 0, 2\n\
         REMARK -> CUTTER / 5\nPPWORD/STEP,66\nMOVNRB/ON,4,8,0,4,30\nDEFSUB / 1\nGODLTA/1,2,3\nENDSUB\n\
         CALSUB / 1\nFINI\n",
    ),
    (
        Dialect::Camworks,
        "PARTNO/1\nUNIT/MM\nCSI_SET_FLUTE_LENGTH/4.\nLOAD/TOOL,1\nTRNTYP/WORLD,1\n\
         CSYS/1,0,0,0,0,1,0,0,0,0,1,0\nRAPID/\nGOTO/10.,0,2.\nCIRCLE/0,0,2.,0,0,1.\nGOTO/0,10.,2.\n\
         CYCLE/INIT\nINSERT/TEXT\nFINI\n",
    ),
    (
        Dialect::Dmg,
        "PARTNO/ 'X'\nOPNAME 'Y'\nMCSYS/ NUM, 1, POINT, 0, 0, 0, VECTOR, 1, 0, 0, VECTOR, 0, 1, 0\n\
         UNITS/ MM\nNEXTTL, 4\nGOTO/ 10, 0, 2\nARCSLP/ 2\nMOVARC/ CENTER, 0, 0, 2, AXIS, 0, 0, 1, $\n\
         RADIUS, 10, TIMES, 2\nGOTO/ 0, 10, 4\n",
    ),
    (
        Dialect::Ncl,
        "REMARK a.as  18-MAR-2019  NCLCAM 2018\nISN/5\nGOTO/10,0,2\nARCDAT/0,0,2,0,0,1,10\nARCMOV/CLW,0,10,2,270\n\
         CCW/0,0,1,10,0,2,0,0,2,0,10,2,10\nGOCLW/0,0,2,0,0,1,10,0,10,2\n$$ CIRCLE/ 0,0,2,0,0,1,10\n\
         GOTO/7.07,7.07,2\nGOTO/0,10,2\n$$ LINE 4\n$$ PATH GOTO P(3)\nGOTO/1,1,1\n$$ GEOMETRY 1 PLANE 4\n\
         CLRSRF/PL,0,0,0,1,5\nFINI\n",
    ),
];

/// What damages text most.
const PIECES: [&str; 22] = [
    ",",
    "/",
    "$",
    "$$",
    "'",
    "(",
    ")",
    "\n",
    "\r",
    "-",
    ".",
    "1e308",
    "-1D400",
    "NAN",
    "0,0,0",
    "9999999999",
    "GOTO/",
    "CIRCLE/",
    "MOVARC/",
    "\u{0}",
    "\u{ff}",
    "\t",
];

struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap() % n.max(1)
    }
}

/// One to four damages.
fn damage(bytes: &[u8], random: &mut Random) -> Vec<u8> {
    let mut out = bytes.to_vec();
    for _ in 0..=random.below(4) {
        let at = random.below(out.len().max(1)).min(out.len());
        match random.below(7) {
            0 => out.truncate(at),
            1 if at < out.len() => out[at] = u8::try_from(random.below(256)).unwrap(),
            2 => {
                let end = (at + random.below(12)).min(out.len());
                out.drain(at..end);
            }
            3 => {
                let end = (at + random.below(60)).min(out.len());
                let again = out[at..end].to_vec();
                let to = random.below(out.len().max(1)).min(out.len());
                out.splice(to..to, again);
            }
            4 if at < out.len() => out[at] ^= 1 << random.below(8),
            _ => {
                let piece = PIECES[random.below(PIECES.len())];
                out.splice(at..at, piece.bytes());
            }
        }
    }
    out
}

/// Reads, checks, and writes in every form.
fn survives(bytes: &[u8], dialect: Option<Dialect>) {
    let mut reader = Reader::open(bytes, dialect).unwrap();
    let mut record = Record::default();
    let mut writers: [Box<dyn RecordWriter>; 5] = [
        Box::new(TextWriter::new(Vec::new(), TextOptions::default())),
        Box::new(CatiaWriter::new(Vec::new(), Decimals::Fixed(5))),
        Box::new(JsonWriter::new(Vec::new())),
        Box::new(TapeWriter::new(Vec::new(), aptc_vocabulary::Dialect::Apt360)),
        Box::new(ClfileWriter::new(Vec::new())),
    ];
    let (mut figures, mut last, mut n) = (stats::Stats::new(), None, 0);
    while reader.read(&mut record).unwrap() {
        n += 1;
        assert!(n < 1_000_000, "records without end");
        if let Kind::Motion(m) = &record.kind {
            let finite = |v: &aptc_geometry::Vec3| v.iter().all(|x| x.is_finite());
            assert!(m.points.iter().all(|p| finite(&p.te) && finite(&p.ta)), "{m:?}");
            let _ = flatten::positions(m, last, 0.01);
            last = m.points.last().copied().or(last);
        }
        figures.push(&record);
        for w in &mut writers {
            w.write(&record).unwrap();
        }
    }
    for w in &mut writers {
        w.finish().unwrap();
    }
    let _ = figures.text();
    let said = reader.into_diagnostics();
    assert!(said.len() <= 1200, "{} messages", said.len());
    let placed = |m: &str| ["line ", "record ", "byte "].iter().any(|w| m.contains(w));
    let lost = said.iter().find(|d| d.is_error() && !placed(&d.message));
    assert!(lost.is_none(), "without a place: {lost:?}");
}

#[test]
fn damaged_texts() {
    for (i, (dialect, text)) in (1..).zip(TEXTS) {
        let mut random = Random(i);
        survives(text.as_bytes(), Some(dialect));
        for k in 0..1500 {
            let damaged = damage(text.as_bytes(), &mut random);
            survives(&damaged, if k % 3 == 0 { None } else { Some(dialect) });
        }
    }
}

/// The same programs in binary and JSON, damaged.
#[test]
fn damaged_binaries_and_json() {
    for (dialect, text) in TEXTS {
        let mut tape = TapeWriter::new(Vec::new(), aptc_vocabulary::Dialect::Apt360);
        let mut clfile = ClfileWriter::new(Vec::new());
        let mut json = Vec::new();
        let mut lines = JsonWriter::new(&mut json);
        let mut reader = Reader::open(text.as_bytes(), Some(dialect)).unwrap();
        let mut record = Record::default();
        while reader.read(&mut record).unwrap() {
            tape.write(&record).unwrap();
            clfile.write(&record).unwrap();
            lines.write(&record).unwrap();
        }
        lines.finish().unwrap();
        let files = [
            (tape.into_inner().unwrap(), Dialect::Tape),
            (clfile.into_inner().unwrap(), Dialect::Clfile),
            (json, Dialect::Json),
        ];
        for (i, (bytes, form)) in (1..).zip(files) {
            let mut random = Random(100 + i);
            for k in 0..400 {
                let damaged = damage(&bytes, &mut random);
                survives(&damaged, if k % 3 == 0 { None } else { Some(form) });
            }
        }
    }
}
