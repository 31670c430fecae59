//! A CL file in which COPY and TRACUT are carried out, one within another, is held against the surfaces as they lie in the program.

use std::fmt::Write;

use aptc_control::{Artifact, ClFile, Disk, Options, Source, Verify, compile, verify};

/// A wall, a floor, and matrices that turn, move, mirror and tip.
const HEAD: &str = "PARTNO NESTS
UNITS/MM
W=PLANE/0,1,0,0
FL=PLANE/0,0,1,0
PA=PLANE/1,0,0,-20
PB=PLANE/1,0,0,20
M1=MATRIX/XYROT,37
M2=MATRIX/TRANSL,11,-23,5
M3=MATRIX/MIRROR,YZPLAN
M4=MATRIX/M1,M2
M5=MATRIX/YZROT,25
M6=MATRIX/M5,M3
CUTTER/8,2
OUTTOL/.01
MULTAX/ON
FEDRAT/300
FROM/-30,-30,30
";

/// Programs of ranges in ranges, the same each time.
struct Nests {
    state: u64,
    text: String,
    ranges: u32,
}

impl Nests {
    fn new(seed: u64) -> Self {
        let state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x1357;
        Self { state, text: HEAD.to_owned(), ranges: 0 }
    }

    fn below(&mut self, n: u64) -> u64 {
        self.state = self
            .state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.state >> 33) % n
    }

    fn say(&mut self, line: &str) {
        writeln!(self.text, "{line}").expect("text");
    }

    /// Along the wall, in some under a TRACUT that ends with it.
    fn motions(&mut self) {
        let tracut = self.below(3) == 0;
        if tracut {
            let m = self.below(6) + 1;
            self.say(&format!("TRACUT/M{m}"));
        }
        self.say("GOTO/-40,-30,40\nGO/TO,W,TO,FL,ON,PA\nINDIRV/1,0,0");
        self.say("TLRGT,TLOFPS,GOFWD/W,ON,PB\nGODLTA/0,0,40");
        if tracut {
            self.say("TRACUT/NOMORE");
        }
    }

    fn copy(&mut self, n: u32) {
        let count = 1 + self.below(2);
        let [a, b] = [0; 2].map(|_| self.below(300) as f64 - 150.0);
        let m = self.below(6) + 1;
        let how = match self.below(4) {
            0 => format!("TRANSL,{a},{b},7"),
            1 => format!("XYROT,{a}"),
            2 => "SAME".to_owned(),
            _ => format!("MODIFY,M{m}"),
        };
        self.say(&format!("COPY/{n},{how},{count}"));
    }

    /// A range that holds motions and other ranges, and is copied once or twice, ended by NOMORE or not.
    fn range(&mut self, depth: u32) {
        self.ranges += 1;
        let n = self.ranges;
        self.say(&format!("INDEX/{n}"));
        if depth == 0 || self.below(2) == 0 {
            self.motions();
        }
        if depth > 0 {
            self.range(depth - 1);
        }
        if self.below(3) == 0 {
            self.say(&format!("INDEX/{n},NOMORE"));
        }
        self.copy(n);
        if self.below(3) == 0 {
            self.copy(n);
        }
    }
}

/// The program's CL file, with the comments that say where each record comes from, or without them.
fn cl_of(text: &str, marked: bool) -> String {
    let options = Options { verify: Verify::Off, post: false, ..Options::default() };
    let source = Source { name: "part".into(), text: text.into() };
    let compiled = compile(source, &mut Disk::new(Vec::new(), 0), &options);
    let cl = compiled.artifact(Artifact::Cl, false).expect("memory takes it");
    let [(_, bytes)] = cl.as_slice() else { panic!("{text}: {:?}", compiled.diagnostics) };
    let cl = String::from_utf8(bytes.clone()).expect("it is text");
    let bare = || cl.lines().filter(|l| !l.starts_with("$$")).map(|l| format!("{l}\n")).collect();
    if marked { cl } else { bare() }
}

/// Whether all of a CL file is proved, how many cut vectors are refuted, and what is told.
fn held(text: &str, cl: String) -> (bool, u64, Vec<String>) {
    let options = Options { verify: Verify::Full, post: false, ..Options::default() };
    let source = Source { name: "part".into(), text: text.into() };
    let file = ClFile { name: "part.cl".into(), bytes: cl.into_bytes() };
    let found = verify(source, &mut Disk::new(Vec::new(), 0), &options, Some(file));
    let wrong = found.diagnostics.iter().filter(|d| d.code.to_string().starts_with("APT5"));
    let told = wrong.map(|d| format!("{} {}", d.code, d.message)).collect();
    let [part] = found.parts.as_slice() else { panic!("{text}") };
    let c = part.certificate.as_ref().expect("it is judged");
    let proved = c.proved > 0 && c.refuted + c.undecided + c.unmatched + c.extra == 0;
    (proved, c.refuted, told)
}

/// What copies last goes first, then what copied before, all behind TRACUT.
#[test]
fn copies_of_copies_are_undone_in_their_order() {
    for seed in 0..60 {
        let mut nests = Nests::new(seed);
        let depth = seed % 4;
        nests.range(u32::try_from(depth).expect("small"));
        if nests.below(2) == 0 {
            nests.range(1);
        }
        nests.say("FINI");
        let text = &nests.text;
        let (proved, _, told) = held(text, cl_of(text, seed % 3 != 0));
        assert!(proved && told.is_empty(), "{seed}: {told:?}\n{text}");
    }
}

/// A shift within a range that is turned stays a shift: there too a place that is off the wall is found.
#[test]
fn a_place_off_the_wall_in_a_copy_of_a_copy_is_found() {
    let text = format!(
        "{HEAD}INDEX/1\nINDEX/2\nGO/TO,W,TO,FL,ON,PA\nINDIRV/1,0,0\nTLRGT,TLOFPS,GOFWD/W,ON,PB\n\
         GODLTA/0,0,40\nCOPY/2,TRANSL,0,200,0,1\nCOPY/1,XYROT,90,1\nFINI\n"
    );
    let cl = cl_of(&text, true);
    let (proved, _, told) = held(&text, cl.clone());
    assert!(proved && told.is_empty(), "{told:?}");
    // The end of the wall in the last copy, turned about the middle and then 200 up.
    let lines: Vec<&str> = cl.lines().collect();
    let (at, place) = lines
        .iter()
        .enumerate()
        .rev()
        .filter(|(_, l)| l.starts_with("GOTO"))
        .nth(1)
        .expect("it is there");
    let (x, rest) = place["GOTO/".len()..].split_once(',').expect("numbers");
    assert!(rest.starts_with("220,"), "{place}");
    for off in [0.5, -0.5] {
        let x = x.parse::<f64>().expect("a number") + off;
        let moved = format!("GOTO/{x},{rest}");
        let spoiled: Vec<&str> =
            lines.iter().enumerate().map(|(i, l)| if i == at { &moved } else { *l }).collect();
        let (_, refuted, told) = held(&text, spoiled.join("\n") + "\n");
        assert!(refuted == 1 && told.len() == 1, "{off}: {told:?}");
    }
}
