//! Commands and options.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

/// The APT part program compiler.
///
/// `aptc PART.apt` compiles it. Exit codes: 0 all is well, 1 errors in the program, 2 wrong usage or files
/// that cannot be read or written, 3 verification failed.
#[derive(Debug, Parser)]
#[command(name = "aptc", version = version(), args_conflicts_with_subcommands = true)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Option<Command>,
    #[command(flatten)]
    pub(crate) compile: CompileArgs,
    #[command(flatten)]
    pub(crate) common: Common,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Compile part programs to CL data, machine code, listing and plot
    Compile(CompileArgs),
    /// Report all errors of a part program, write nothing
    Check(CheckArgs),
    /// Prove the path of a program, or a CL file against the surfaces of the program
    Verify(VerifyArgs),
    /// Post-process a CL file for a machine
    Post(PostArgs),
    /// Put part programs into one style
    Fmt(FmtArgs),
    /// Convert CL data from one dialect to another
    Convert(ConvertArgs),
    /// Compare two CL files by geometry
    Cldiff(CldiffArgs),
    /// Figures of a CL file
    Stats(StatsArgs),
    /// Compile the programs of a folder and hold the results against the goldens beside them
    Test(TestArgs),
    /// Explain an error code or a word of the language
    Explain {
        /// The code or the word, for example APT1050 or CIRCLE; all codes are listed without one
        code: Option<String>,
    },
    /// List the machines, print the file of one, or check one's own
    Machines {
        /// Name of a machine or path of a machine file
        machine: Option<String>,
    },
    /// Print the completions of commands and options for a shell
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
    /// Write a manual page for each command
    Man {
        /// Folder for the pages
        #[arg(short, long, value_name = "DIR")]
        output: PathBuf,
    },
}

/// Options that every command has.
#[derive(Args, Clone, Debug)]
pub(crate) struct Common {
    /// Form of the messages
    #[arg(long, value_enum, default_value = "human", global = true)]
    pub(crate) message_format: MessageFormat,
    /// Colours in messages
    #[arg(long, value_enum, default_value = "auto", global = true)]
    pub(crate) color: Color,
    /// No summary, no progress, no warnings
    #[arg(short, long, global = true)]
    pub(crate) quiet: bool,
}

/// Dialect of a part program.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SourceDialect {
    /// APT-360 and APT4
    Apt,
    /// What NCL has in common with them
    Ncl,
}

/// How a part program is read.
#[derive(Args, Clone, Debug)]
pub(crate) struct SourceArgs {
    /// Folder of macros and included files; the program's own folder comes first
    #[arg(short = 'I', long = "include", value_name = "DIR", value_parser = existing_folder)]
    pub(crate) include: Vec<PathBuf>,
    /// Lines of any length: no card columns
    #[arg(long)]
    pub(crate) free_form: bool,
    /// Unknown post-processor words are errors
    #[arg(long)]
    pub(crate) deny_unknown_words: bool,
    /// Dialect of the source text
    #[arg(long, value_enum, default_value = "apt", value_name = "NAME")]
    pub(crate) dialect: SourceDialect,
    /// Warn of names that are defined and never used
    #[arg(long)]
    pub(crate) warn_unused: bool,
    /// Most statements that are carried out, loops and macros counted
    #[arg(long, value_name = "N")]
    pub(crate) max_statements: Option<u64>,
    /// Deepest nesting of macro calls
    #[arg(long, value_name = "N")]
    pub(crate) max_macro_depth: Option<u32>,
    /// Most files read within each other
    #[arg(long, value_name = "N")]
    pub(crate) max_include_depth: Option<u32>,
    /// Most elements of all arrays together
    #[arg(long, value_name = "N")]
    pub(crate) max_array_elements: Option<u32>,
    /// Most points of a pattern, TABCYL or sculptured form
    #[arg(long, value_name = "N")]
    pub(crate) max_points: Option<u32>,
    /// Most seconds that a part program may take
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub(crate) max_seconds: Option<std::time::Duration>,
    /// Threads for regional milling and the proof; as many as the machine has if not given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    pub(crate) threads: Option<u16>,
    /// Largest file that is read, in bytes
    #[arg(long, value_name = "BYTES", default_value_t = 256 << 20)]
    pub(crate) max_file_size: u64,
}

/// `--max-seconds`: above 0.
fn seconds(text: &str) -> Result<std::time::Duration, String> {
    let seconds: f64 = text.parse().map_err(|_| "a number of seconds is expected".to_owned())?;
    match std::time::Duration::try_from_secs_f64(seconds) {
        Ok(time) if !time.is_zero() => Ok(time),
        _ => Err("it must be above 0".to_owned()),
    }
}

/// How machine code is written.
#[derive(Args, Clone, Debug)]
pub(crate) struct CodeArgs {
    /// Machine by name or file, instead of the program's MACHIN
    #[arg(short, long, value_name = "NAME")]
    pub(crate) machine: Option<String>,
    /// Work offset instead of the machine's own, for example G55
    #[arg(long, value_name = "CODE", value_parser = one_code)]
    pub(crate) work_offset: Option<String>,
    /// Block of material for the check of rapid motion, when the program has no STOCK
    #[arg(long, value_name = "X1,Y1,Z1,X2,Y2,Z2", value_parser = corners, allow_hyphen_values = true)]
    pub(crate) stock: Option<[f64; 6]>,
    /// Statement numbers as comments in the machine code
    #[arg(long)]
    pub(crate) annotate: bool,
}

/// `aptc compile`.
#[derive(Args, Clone, Debug)]
pub(crate) struct CompileArgs {
    /// Part programs (.apt) or numeric part programs (.protap)
    #[arg(required = true, value_name = "PART")]
    pub(crate) parts: Vec<PathBuf>,
    /// Folder for the results; the current one if not given
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
    /// What to write
    #[arg(long, value_enum, value_delimiter = ',', value_name = "KINDS",
          default_values = ["cl", "nc", "lst", "svg"])]
    pub(crate) emit: Vec<Emit>,
    #[command(flatten)]
    pub(crate) code: CodeArgs,
    /// How much of the path is proved
    #[arg(long, value_enum, value_name = "HOW")]
    pub(crate) verify: Option<VerifyHow>,
    /// Write X.partial.cl also when the program has errors
    #[arg(long)]
    pub(crate) keep_going: bool,
    #[command(flatten)]
    pub(crate) source: SourceArgs,
}

/// `aptc check`.
#[derive(Args, Clone, Debug)]
pub(crate) struct CheckArgs {
    /// Part programs
    #[arg(required = true, value_name = "PART")]
    pub(crate) parts: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) source: SourceArgs,
}

/// `aptc verify`.
#[derive(Args, Clone, Debug)]
pub(crate) struct VerifyArgs {
    /// Part programs
    #[arg(required_unless_present = "nc", value_name = "PART")]
    pub(crate) parts: Vec<PathBuf>,
    /// A CL file of any dialect, held against the surfaces of the one program
    #[arg(long, value_name = "FILE")]
    pub(crate) cl: Option<PathBuf>,
    /// Machine code of any origin, held against the CL file
    #[arg(long, value_name = "FILE")]
    pub(crate) nc: Option<PathBuf>,
    /// The machine for which the code is: its name or file
    #[arg(short, long, value_name = "NAME", requires = "nc")]
    pub(crate) machine: Option<String>,
    /// Dialect of the CL file; found out if it is not given
    #[arg(long, value_name = "DIALECT", requires = "nc")]
    pub(crate) from: Option<String>,
    /// The certificates as a JSON document on standard output
    #[arg(long)]
    pub(crate) json: bool,
    /// How much of the path is proved
    #[arg(long, value_enum, value_name = "HOW", default_value = "full")]
    pub(crate) verify: VerifyHow,
    #[command(flatten)]
    pub(crate) source: SourceArgs,
}

/// `aptc post`.
#[derive(Args, Clone, Debug)]
pub(crate) struct PostArgs {
    /// The CL file
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,
    /// Its dialect; found out if not given
    #[arg(long, value_name = "DIALECT")]
    pub(crate) from: Option<String>,
    /// Carry out INDEX, COPY and TRACUT; what aptc compile wrote has been edited already
    #[arg(long)]
    pub(crate) edit: bool,
    #[command(flatten)]
    pub(crate) code: CodeArgs,
    /// Write the setup sheet too, OUT.setup.txt and OUT.setup.html
    #[arg(long)]
    pub(crate) setup: bool,
    /// Write from which statement each block comes, OUT.nc.map.json
    #[arg(long)]
    pub(crate) map: bool,
    /// File or folder to write to, the current folder if not given, - for standard output; in a folder the file
    /// has the CL file's name with .nc
    #[arg(short, long, value_name = "OUT")]
    pub(crate) output: Option<PathBuf>,
}

/// `aptc test`.
#[derive(Args, Clone, Debug)]
pub(crate) struct TestArgs {
    /// Folder of part programs: X.apt, or folders with a program.apt
    #[arg(value_name = "DIR")]
    pub(crate) folder: PathBuf,
    /// Only programs whose name contains this
    #[arg(value_name = "FILTER", default_value = "")]
    pub(crate) filter: String,
    /// Write the goldens anew
    #[arg(long)]
    pub(crate) bless: bool,
}

/// `aptc fmt`.
#[derive(Args, Clone, Debug)]
pub(crate) struct FmtArgs {
    /// Part programs, changed in place
    #[arg(required = true, value_name = "PART")]
    pub(crate) parts: Vec<PathBuf>,
    /// Write nothing; exit code 1 if a file would change
    #[arg(long)]
    pub(crate) check: bool,
    /// Write nothing; show what would change
    #[arg(long)]
    pub(crate) diff: bool,
    /// Keep the identification in columns 73 to 80
    #[arg(long)]
    pub(crate) keep_columns: bool,
    /// Lines of any length: no card columns
    #[arg(long)]
    pub(crate) free_form: bool,
}

/// `aptc convert`.
#[derive(Args, Clone, Debug)]
pub(crate) struct ConvertArgs {
    /// The CL file
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,
    /// Its dialect; found out if not given
    #[arg(long, value_name = "DIALECT")]
    pub(crate) from: Option<String>,
    /// Carry out INDEX, COPY, TRACUT and CALSUB; what aptc compile wrote has been edited already
    #[arg(long)]
    pub(crate) edit: bool,
    /// Dialect to write: iso, catia, json, cltape or clfile
    #[arg(long, value_name = "DIALECT", default_value = "iso")]
    pub(crate) to: String,
    /// Where to write
    #[arg(short, long, value_name = "OUT")]
    pub(crate) output: PathBuf,
}

/// `aptc cldiff`.
#[derive(Args, Clone, Debug)]
pub(crate) struct CldiffArgs {
    /// One CL file
    #[arg(value_name = "FIRST")]
    pub(crate) first: PathBuf,
    /// The other
    #[arg(value_name = "SECOND")]
    pub(crate) second: PathBuf,
    /// Deviation that does not count, in the unit of the first file
    #[arg(short, long, value_name = "LENGTH", default_value_t = 0.001)]
    pub(crate) tolerance: f64,
    /// The files are machine code of this machine; else those ending in nc, ngc, mpf, h and the like are
    #[arg(short, long, value_name = "NAME")]
    pub(crate) machine: Option<String>,
    /// As a JSON object
    #[arg(long)]
    pub(crate) json: bool,
}

/// `aptc stats`.
#[derive(Args, Clone, Debug)]
pub(crate) struct StatsArgs {
    /// The CL file
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,
    /// As a JSON object
    #[arg(long)]
    pub(crate) json: bool,
}

/// Outputs of `aptc compile`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, ValueEnum)]
pub(crate) enum Emit {
    /// Numeric part program, X.protap
    Protap,
    /// CL data as ISO 4343 text, X.cl
    Cl,
    /// CL data as JSON lines, X.cl.json
    ClJson,
    /// CL data as APT-360 binary records, X.cltape
    Cltape,
    /// Machine code, X.nc
    Nc,
    /// Setup sheet for the operator, X.setup.txt and X.setup.html
    Setup,
    /// From which statement each block comes, X.nc.map.json
    Map,
    /// Listing, X.lst
    Lst,
    /// Plot, X.svg
    Svg,
    /// Picture of the first motion that failed, X.diagram.svg
    Diagram,
    /// What regional milling leaves on its part surfaces or cuts into them, X.deviation.svg
    Deviation,
    /// Canonical forms of all named geometry, X.geometry.json
    Geometry,
}

/// Form of the messages.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum MessageFormat {
    /// With the source text around
    Human,
    /// One line each
    Short,
    /// One JSON object a line
    Json,
    /// One SARIF document
    Sarif,
}

/// When to colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Color {
    /// On a terminal, unless NO_COLOR is set
    Auto,
    /// Always
    Always,
    /// Never
    Never,
}

/// How much is verified.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum VerifyHow {
    /// Every cut vector
    Full,
    /// Every n-th cut vector
    Sample,
    /// None
    Off,
}

/// A folder that is there: one misspelt would be passed over in silence.
fn existing_folder(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    if path.is_dir() { Ok(path) } else { Err("there is no such folder".to_owned()) }
}

/// A code that stands in a block without bringing anything else into it.
fn one_code(text: &str) -> Result<String, String> {
    let plain = |b: u8| b.is_ascii_alphanumeric() || b == b'.';
    if !text.is_empty() && text.bytes().all(plain) {
        return Ok(text.to_owned());
    }
    Err("one code of letters, digits and point is expected, as G55 or G54.1P2".to_owned())
}

/// Six numbers with commas between.
fn corners(text: &str) -> Result<[f64; 6], String> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|n| n.trim().parse()).collect();
    let numbers = numbers.map_err(|e| format!("{e}"))?;
    numbers
        .try_into()
        .map_err(|n: Vec<f64>| format!("six numbers are needed, {} are given", n.len()))
}

fn version() -> &'static str {
    match env!("APTC_COMMIT") {
        "" => env!("CARGO_PKG_VERSION"),
        _ => concat!(env!("CARGO_PKG_VERSION"), " (", env!("APTC_COMMIT"), ")"),
    }
}
