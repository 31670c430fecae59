//! The scanner under all text dialects: lines of a stream, and statements of one or more lines.

use std::io::{self, Read};
use std::ops::Range;

use super::layout::Layout;

/// Bytes held at once, and so the longest line.
const BUFFER: usize = 256 * 1024;
/// Longest statement over all its lines.
const LONGEST_STATEMENT: usize = 1024 * 1024;

/// Cuts a stream into lines and statements; memory does not grow with the stream.
pub(super) struct Scanner<R> {
    input: R,
    buf: Box<[u8]>,
    /// Unread bytes of the buffer.
    unread: Range<usize>,
    /// The next line and its length with the end of line, when it has been looked at.
    peeked: Option<(Range<usize>, usize)>,
    at_end: bool,
    /// Where statements stand on the lines.
    pub(super) layout: Layout,
    /// Number of the next line, from 1.
    pub(super) line: u64,
    /// Bytes before the unread ones.
    pub(super) offset: u64,
    /// Joined text of a statement of several lines.
    joined: Vec<u8>,
    statement: Text,
    comment: Option<Range<usize>>,
    /// First line that was too long to be read, if any, and how many.
    pub(super) overlong: (u64, u64),
    /// Does the last statement go on past the end of the file?
    pub(super) cut_off: bool,
}

/// Where the text of the statement lies.
#[derive(Clone)]
enum Text {
    Buffer(Range<usize>),
    Joined,
}

impl<R: Read> Scanner<R> {
    pub(super) fn new(input: R) -> Self {
        Self {
            input,
            buf: vec![0; BUFFER].into_boxed_slice(),
            unread: 0..0,
            peeked: None,
            at_end: false,
            layout: Layout::default(),
            line: 1,
            offset: 0,
            joined: Vec::new(),
            statement: Text::Joined,
            comment: None,
            overlong: (0, 0),
            cut_off: false,
        }
    }

    /// The next line without its end; `None` at the end of the stream.
    #[inline]
    pub(super) fn peek(&mut self) -> io::Result<Option<&[u8]>> {
        if self.peeked.is_none() && !self.find_line()? {
            return Ok(None);
        }
        Ok(self.peeked.as_ref().map(|(r, _)| &self.buf[r.clone()]))
    }

    /// Goes past the line that was looked at.
    #[inline]
    pub(super) fn advance(&mut self) {
        if let Some((_, len)) = self.peeked.take() {
            self.unread.start += len;
            self.offset += len as u64;
            self.line += 1;
        }
    }

    fn find_line(&mut self) -> io::Result<bool> {
        let mut searched = 0;
        loop {
            let held = &self.buf[self.unread.clone()];
            if let Some(n) = memchr::memchr(self.layout.eol, &held[searched..]) {
                self.set_line(searched + n, searched + n + 1);
                return Ok(true);
            }
            searched = held.len();
            if self.at_end {
                if searched == 0 {
                    return Ok(false);
                }
                self.set_line(searched, searched);
                return Ok(true);
            }
            if searched == self.buf.len() {
                self.skip_line()?;
                searched = 0;
                continue;
            }
            self.fill()?;
        }
    }

    fn set_line(&mut self, len: usize, with_end: usize) {
        let start = self.unread.start;
        let mut end = start + len;
        while end > start && matches!(self.buf[end - 1], b'\r' | 0x1a | 0) {
            end -= 1;
        }
        let Layout { skip, width, .. } = self.layout;
        let (end, start) = (end.min(start.saturating_add(width)), end.min(start + skip));
        self.peeked = Some((start..end, with_end));
    }

    fn fill(&mut self) -> io::Result<()> {
        if self.unread.start > 0 {
            self.buf.copy_within(self.unread.clone(), 0);
            self.unread = 0..self.unread.len();
        }
        loop {
            match self.input.read(&mut self.buf[self.unread.end..]) {
                Ok(0) => self.at_end = true,
                Ok(n) => self.unread.end += n,
                Err(e) if e.kind() == io::ErrorKind::Interrupted => continue,
                Err(e) => return Err(e),
            }
            return Ok(());
        }
    }

    /// Drops a line that does not fit into the buffer.
    fn skip_line(&mut self) -> io::Result<()> {
        if self.overlong.1 == 0 {
            self.overlong.0 = self.line;
        }
        self.overlong.1 += 1;
        loop {
            let held = self.unread.len();
            if let Some(n) = memchr::memchr(self.layout.eol, &self.buf[self.unread.clone()]) {
                self.unread.start += n + 1;
                self.offset += n as u64 + 1;
                self.line += 1;
                return Ok(());
            }
            self.offset += held as u64;
            self.unread = 0..0;
            self.fill()?;
            if self.at_end && self.unread.is_empty() {
                return Ok(());
            }
        }
    }

    /// Reads the statement that begins with the line looked at, with its continuations (`$` at the end of
    /// a line); false at the end. `verbatim` says whether such a line is text to its end.
    pub(super) fn next_statement(&mut self, verbatim: fn(&[u8]) -> bool) -> io::Result<bool> {
        self.comment = None;
        self.joined.clear();
        let mut n_lines = 0_u32;
        loop {
            if self.peek()?.is_none() {
                self.statement = Text::Joined;
                self.end_statement();
                return Ok(n_lines > 0);
            }
            let Some((range, _)) = self.peeked.clone() else { return Ok(n_lines > 0) };
            let line = &self.buf[range.clone()];
            if n_lines == 0 && verbatim(line) {
                self.statement = Text::Buffer(range);
                self.advance();
                return Ok(true);
            }
            let mut cut = cut(line);
            let mut body = range.start..range.start + cut.body;
            // A structured comment of Creo goes on like a statement.
            let rest = cut.comment.map_or(&b""[..], |c| &line[c..]);
            let structured = cut.body == 0 && rest.starts_with(b"->");
            if n_lines == 0 && structured && rest.trim_ascii_end().ends_with(b"$") {
                let end = range.start + line.trim_ascii_end().len() - 1;
                body = range.end - rest.len()..end;
                cut.goes_on = true;
            }
            if n_lines == 0 && !cut.goes_on {
                self.comment = cut.comment.map(|c| range.start + c..range.end);
                self.statement = Text::Buffer(body);
                self.advance();
                return Ok(true);
            }
            let blank = n_lines > 0 && !cut.goes_on && self.buf[range].trim_ascii().is_empty();
            self.joined.extend_from_slice(&self.buf[body]);
            n_lines += 1;
            self.advance();
            if blank && self.is_rest_blank()? {
                self.end_statement();
            }
            if !cut.goes_on || self.joined.len() > LONGEST_STATEMENT {
                self.statement = Text::Joined;
                return Ok(true);
            }
        }
    }

    /// The file ends where a statement goes on: what is missing may be of a motion, unless FINI or nothing is there.
    fn end_statement(&mut self) {
        let text = self.joined.trim_ascii();
        self.cut_off = !text.is_empty() && !text.eq_ignore_ascii_case(b"FINI");
    }

    /// Goes past blank lines; is there nothing behind them?
    fn is_rest_blank(&mut self) -> io::Result<bool> {
        while let Some(line) = self.peek()? {
            if !line.trim_ascii().is_empty() {
                return Ok(false);
            }
            self.advance();
        }
        Ok(true)
    }

    /// Text of the statement, without comment and continuation marks.
    pub(super) fn text(&self) -> &[u8] {
        match &self.statement {
            Text::Buffer(r) => &self.buf[r.clone()],
            Text::Joined => &self.joined,
        }
    }

    /// The comment at the end of a statement of one line, after its `$$`.
    pub(super) fn comment(&self) -> Option<&[u8]> {
        self.comment.clone().map(|r| &self.buf[r])
    }
}

/// A line taken apart.
struct Cut {
    /// Length of the part before comment or continuation mark.
    body: usize,
    /// Where the text of the comment begins.
    comment: Option<usize>,
    /// Does the statement go on in the next line?
    goes_on: bool,
}

fn cut(line: &[u8]) -> Cut {
    let Some(first) = memchr::memchr(b'$', line) else {
        return Cut { body: line.len(), comment: None, goes_on: false };
    };
    let mut quoted = line[..first].iter().filter(|b| **b == b'\'').count() % 2 == 1;
    let mut at = first;
    while at < line.len() {
        match line[at] {
            b'\'' => quoted = !quoted,
            b'$' if !quoted => {
                if line.get(at + 1) == Some(&b'$') {
                    let body = line[..at].trim_ascii_end();
                    let goes_on = body.last() == Some(&b'$');
                    let body = body.len() - usize::from(goes_on);
                    return Cut { body, comment: Some(at + 2), goes_on };
                }
                if line[at + 1..].iter().all(u8::is_ascii_whitespace) {
                    return Cut { body: at, comment: None, goes_on: true };
                }
            }
            _ => {}
        }
        at += 1;
    }
    // An apostrophe without a partner must not hide the continuation.
    let trimmed = line.trim_ascii_end();
    if quoted && trimmed.last() == Some(&b'$') {
        return Cut { body: trimmed.len() - 1, comment: None, goes_on: true };
    }
    Cut { body: line.len(), comment: None, goes_on: false }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn statements(text: &[u8]) -> Vec<(u64, String, Option<String>)> {
        let mut s = Scanner::new(text);
        let mut out = Vec::new();
        loop {
            let line = s.line;
            if !s.next_statement(|l| l.starts_with(b"PPRINT")).unwrap() {
                return out;
            }
            let own = |b: &[u8]| String::from_utf8_lossy(b).into_owned();
            out.push((line, own(s.text()), s.comment().map(own)));
        }
    }

    #[test]
    fn statements_end_where_their_lines_do() {
        let text = b"GOTO/1,2,$\r\n  3\r\n$$ note $\nPPRINT it's $5 $$ all\nA/'$$',1 $$ end\n\
                     B/1,$ $$ c\n2\nC/'x,$\ny'";
        let got = statements(text);
        let expected = [
            (1, "GOTO/1,2,  3", None),
            (3, "", Some(" note $")),
            (4, "PPRINT it's $5 $$ all", None),
            (5, "A/'$$',1", Some(" end")),
            (6, "B/1,2", None),
            (8, "C/'x,y'", None),
        ];
        assert_eq!(got.len(), expected.len());
        for (g, e) in got.iter().zip(expected) {
            assert_eq!((g.0, g.1.as_str(), g.2.as_deref()), e);
        }
    }

    #[test]
    fn an_endless_line_is_left_out_and_counted() {
        let mut text = vec![b'x'; 10 << 20];
        text.extend_from_slice(b"\nFINI\n");
        let mut s = Scanner::new(text.as_slice());
        assert_eq!(s.peek().unwrap(), Some(b"FINI".as_slice()));
        assert_eq!((s.line, s.overlong), (2, (1, 1)));
        s.advance();
        assert_eq!(s.offset, text.len() as u64);
        assert_eq!(s.peek().unwrap(), None);
    }
}
