//! The setup sheet: what the operator needs at the machine, as text and as a page to print.
//!
//! It is made from the summary of the posted text alone, so it says what the machine will do, not what the
//! part program meant to do.

use std::fmt::Write as _;

use crate::machine::Machine;
use crate::report::{AxisUse, Summary, ToolUse};

/// A setup sheet: one heading with its lines, in order.
#[derive(Clone, Debug, PartialEq)]
pub struct SetupSheet {
    title: String,
    sections: Vec<Section>,
}

#[derive(Clone, Debug, PartialEq)]
struct Section {
    heading: &'static str,
    columns: Vec<&'static str>,
    rows: Vec<Vec<String>>,
}

impl SetupSheet {
    /// The sheet of a posted text.
    pub fn new(machine: &Machine, summary: &Summary) -> Self {
        let title = match summary.part.trim() {
            "" => "part without a name".to_owned(),
            part => part.to_owned(),
        };
        let mut sections =
            vec![general(machine, summary), tools(summary), travel(summary), extent(summary)];
        if !summary.notes.is_empty() {
            let rows = summary.notes.iter().map(|n| vec![n.clone()]).collect();
            sections.push(Section { heading: "Notes", columns: Vec::new(), rows });
        }
        sections.retain(|s| !s.rows.is_empty());
        Self { title, sections }
    }
}

/// The sheet as text of at most 100 columns where the part's own texts allow it.
pub fn setup_text(sheet: &SetupSheet) -> String {
    let mut out = format!("SETUP SHEET  {}\n", sheet.title);
    for s in &sheet.sections {
        write!(out, "\n{}\n", s.heading).expect("strings take all");
        let header = s.columns.iter().map(|c| (*c).to_owned()).collect::<Vec<_>>();
        let lines: Vec<&[String]> = std::iter::once(header.as_slice())
            .filter(|h| h.iter().any(|c| !c.is_empty()))
            .chain(s.rows.iter().map(Vec::as_slice))
            .collect();
        let widths = widths(&lines);
        for line in lines {
            let mut text = String::from(" ");
            for (cell, width) in line.iter().zip(&widths) {
                write!(text, " {cell:<width$} ").expect("strings take all");
            }
            out.push_str(text.trim_end());
            out.push('\n');
        }
    }
    out
}

/// The sheet as a page that needs nothing else: no script, no other file.
pub fn setup_html(sheet: &SetupSheet) -> String {
    let mut out = String::from(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>Setup: ",
    );
    out.push_str(&escaped(&sheet.title));
    out.push_str("</title>\n<style>\n");
    out.push_str(STYLE);
    out.push_str("</style>\n</head>\n<body>\n<h1>");
    out.push_str(&escaped(&sheet.title));
    out.push_str("</h1>\n");
    for s in &sheet.sections {
        write!(out, "<h2>{}</h2>\n<table>\n", s.heading).expect("strings take all");
        if s.columns.iter().any(|c| !c.is_empty()) {
            row(&mut out, "th", s.columns.iter().copied());
        }
        for cells in &s.rows {
            row(&mut out, "td", cells.iter().map(String::as_str));
        }
        out.push_str("</table>\n");
    }
    out.push_str("</body>\n</html>\n");
    out
}

const STYLE: &str = "\
body { font: 11pt/1.35 sans-serif; margin: 2em auto; max-width: 50em; color: #111; background: #fff }
h1 { font-size: 1.4em; border-bottom: 2px solid #111 }
h2 { font-size: 1.05em; margin: 1.4em 0 .3em }
table { border-collapse: collapse; width: 100% }
th, td { text-align: left; padding: .2em .6em; border-bottom: 1px solid #bbb; vertical-align: top }
th { font-weight: 600 }
@media print { body { margin: 0 } }
";

fn row<'a>(out: &mut String, tag: &str, cells: impl Iterator<Item = &'a str>) {
    out.push_str("<tr>");
    for cell in cells {
        write!(out, "<{tag}>{}</{tag}>", escaped(cell)).expect("strings take all");
    }
    out.push_str("</tr>\n");
}

fn escaped(text: &str) -> String {
    text.chars()
        .map(|c| match c {
            '&' => "&amp;".to_owned(),
            '<' => "&lt;".to_owned(),
            '>' => "&gt;".to_owned(),
            '"' => "&quot;".to_owned(),
            c if c.is_control() => " ".to_owned(),
            c => c.to_string(),
        })
        .collect()
}

fn widths(lines: &[&[String]]) -> Vec<usize> {
    let n = lines.iter().map(|l| l.len()).max().unwrap_or(0);
    let width = |i: usize| {
        let cells = lines.iter().filter_map(|l| l.get(i));
        cells.map(|c| c.chars().count()).max().unwrap_or(0)
    };
    (0..n).map(width).collect()
}

fn general(machine: &Machine, s: &Summary) -> Section {
    let mut rows = Vec::new();
    let mut add = |label: &str, text: String| rows.push(vec![label.to_owned(), text]);
    add("Machine", format!("{} ({})", machine.title, machine.name));
    add("Program", format!("{} lines, lengths in {}", s.blocks, s.unit));
    let zero = match s.work_offset.as_str() {
        "" => "the zero of the part program".to_owned(),
        offset => format!("{offset} at the zero of the part program"),
    };
    add("Zero", zero);
    if let Some([min, max]) = s.stock {
        let corner = |c: [f64; 3]| c.map(|v| number(v, 4)).join(",");
        add("Stock", format!("from {} to {}", corner(min), corner(max)));
    }
    add("Time", format!("{} cutting, {} rapid", clock(s.cut_minutes), clock(s.rapid_minutes)));
    add(
        "Travel",
        format!(
            "{} {u} cutting, {} {u} rapid",
            number(s.cut_length, 1),
            number(s.rapid_length, 1),
            u = s.unit
        ),
    );
    if s.holes > 0 {
        add("Holes", s.holes.to_string());
    }
    Section { heading: "General", columns: Vec::new(), rows }
}

fn tools(s: &Summary) -> Section {
    let rows = s.tools.iter().map(|t| tool(t, s.unit)).collect();
    Section {
        heading: "Tools, in order of use",
        columns: vec![
            "Tool", "Offset", "Cutter", "Speed", "Feed", "Lowest Z", "Time", "Line", "Remark",
        ],
        rows,
    }
}

fn tool(t: &ToolUse, unit: &str) -> Vec<String> {
    let text = |n: Option<u32>| n.map_or("-".to_owned(), |n| n.to_string());
    let range = |r: Option<[f64; 2]>, places| match r {
        None => "-".to_owned(),
        Some([a, b]) if number(a, places) == number(b, places) => number(a, places),
        Some([a, b]) => format!("{} to {}", number(a, places), number(b, places)),
    };
    vec![
        text(t.number),
        text(t.offset),
        t.cutter.map_or("-".to_owned(), |c| cutter(&c)),
        range(t.speeds, 0),
        range(t.feeds, if unit == "mm" { 0 } else { 2 }),
        t.lowest.map_or("-".to_owned(), |z| number(z, 4)),
        clock(t.minutes),
        t.line.to_string(),
        t.comment.clone(),
    ]
}

/// `D12 R2 H50`: diameter, corner radius, height; the seven values where the cutter is of another shape.
fn cutter(&[d, r, e, f, alpha, beta, h]: &[f64; 7]) -> String {
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * d.abs().max(1.0);
    let usual = near(alpha, 0.0) && near(beta, 0.0) && near(e + r, d / 2.0) && near(f, r);
    if !usual {
        return [d, r, e, f, alpha, beta, h].map(|v| number(v, 4)).join(",");
    }
    let corner = if near(r, 0.0) {
        String::new()
    } else if near(2.0 * r, d) {
        " ball".to_owned()
    } else {
        format!(" R{}", number(r, 4))
    };
    // The five inches that CUTTER takes where it says no height are not those of the tool.
    let height = match [127.0, 5.0].iter().any(|said| near(h, *said)) {
        true => String::new(),
        false => format!(", height {}", number(h, 4)),
    };
    format!("D{}{corner}{height}", number(d, 4))
}

fn travel(s: &Summary) -> Section {
    let limit = |l: Option<f64>| l.map_or("-".to_owned(), |l| number(l, 3));
    let one = |a: &AxisUse| {
        let unit = if a.rotary { "degrees" } else { s.unit };
        vec![
            a.letter.to_string(),
            number(a.min, 4),
            number(a.max, 4),
            unit.to_owned(),
            limit(a.limits[0]),
            limit(a.limits[1]),
        ]
    };
    Section {
        heading: "Travel of the axes, in the numbers of the program",
        columns: vec!["Axis", "From", "To", "Unit", "Least allowed", "Greatest allowed"],
        rows: s.axes.iter().map(one).collect(),
    }
}

fn extent(s: &Summary) -> Section {
    let rows = s.extent.iter().flat_map(|e| {
        (0..3)
            .map(|i| vec![["X", "Y", "Z"][i].to_owned(), number(e.min[i], 4), number(e.max[i], 4)])
    });
    Section {
        heading: "Tool end in the frame of the part",
        columns: vec!["", "From", "To"],
        rows: rows.collect(),
    }
}

/// At most `places` decimals, none at the end that are zero.
fn number(value: f64, places: u8) -> String {
    crate::post::trimmed(value, places)
}

fn clock(minutes: f64) -> String {
    let s = (minutes.max(0.0) * 60.0).round();
    let (h, m, s) = ((s / 3600.0).floor(), (s / 60.0).floor() % 60.0, s % 60.0);
    if h > 0.0 { format!("{h}:{m:02}:{s:02} h") } else { format!("{m}:{s:02} min") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine;

    fn sheet() -> SetupSheet {
        let summary = Summary {
            part: "PLATE <A&B>".to_owned(),
            unit: "mm",
            blocks: 120,
            cut_minutes: 61.5,
            rapid_minutes: 0.25,
            work_offset: "G54".to_owned(),
            tools: vec![
                ToolUse {
                    number: Some(3),
                    offset: Some(3),
                    cutter: Some([12.0, 2.0, 4.0, 2.0, 0.0, 0.0, 50.0]),
                    comment: "BULL NOSE".to_owned(),
                    minutes: 60.0,
                    speeds: Some([1000.0, 2000.0]),
                    feeds: Some([300.0, 300.0]),
                    lowest: Some(-12.5),
                    line: 8,
                },
                ToolUse {
                    cutter: Some([10.0, 5.0, 0.0, 5.0, 0.0, 0.0, 50.0]),
                    ..ToolUse::default()
                },
            ],
            axes: vec![AxisUse {
                letter: 'X',
                rotary: false,
                min: -5.0,
                max: 105.25,
                limits: [None, Some(500.0)],
            }],
            notes: vec!["CLAMP AT BOTH ENDS".to_owned()],
            ..Summary::default()
        };
        SetupSheet::new(machine("linuxcnc-mill").unwrap(), &summary)
    }

    #[test]
    fn the_text_says_what_the_operator_asks() {
        let text = setup_text(&sheet());
        for part in [
            "G54 at the zero",
            "1:01:30 h cutting, 0:15 min rapid",
            "D12 R2, height 50",
            "D10 ball, height 50",
            "1000 to 2000",
            "105.25",
            "CLAMP AT BOTH ENDS",
        ] {
            assert!(text.contains(part), "{part} is missing:\n{text}");
        }
        let tool_line = text.lines().find(|l| l.contains("BULL NOSE")).unwrap();
        let cells: Vec<&str> =
            tool_line.split("  ").map(str::trim).filter(|c| !c.is_empty()).collect();
        assert_eq!(
            cells,
            [
                "3",
                "3",
                "D12 R2, height 50",
                "1000 to 2000",
                "300",
                "-12.5",
                "1:00:00 h",
                "8",
                "BULL NOSE"
            ]
        );
    }

    #[test]
    fn a_height_that_was_not_said_is_not_told() {
        assert_eq!(cutter(&[10.0, 0.0, 5.0, 0.0, 0.0, 0.0, 127.0]), "D10");
        assert_eq!(cutter(&[0.5, 0.25, 0.0, 0.25, 0.0, 0.0, 5.0]), "D0.5 ball");
        assert_eq!(cutter(&[10.0, 0.0, 5.0, 0.0, 0.0, 0.0, 40.0]), "D10, height 40");
    }

    #[test]
    fn the_page_is_whole_and_no_text_breaks_out_of_it() {
        let page = setup_html(&sheet());
        assert!(page.contains("<h1>PLATE &lt;A&amp;B&gt;</h1>"));
        for tag in ["table", "tr", "td", "th", "h2", "body", "html"] {
            let open = page.matches(&format!("<{tag}>")).count()
                + page.matches(&format!("<{tag} ")).count();
            assert_eq!(open, page.matches(&format!("</{tag}>")).count(), "{tag}");
        }
    }
}
