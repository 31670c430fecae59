//! Byte order marks: UTF-8 with one, and UTF-16, become plain bytes.

use std::io::{self, Read};

/// Bytes decoded at once.
const BLOCK: usize = 16 * 1024;

/// A stream without its byte order mark, UTF-16 as UTF-8.
pub(super) struct Decoded<R> {
    input: R,
    form: Form,
    /// Bytes ready, from `at` on.
    ready: Vec<u8>,
    at: usize,
    /// Raw bytes of a pair or surrogate that is not whole yet.
    rest: Vec<u8>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    Unknown,
    Plain,
    Wide { big: bool },
}

impl<R: Read> Decoded<R> {
    pub(super) fn new(input: R) -> Self {
        Self { input, form: Form::Unknown, ready: Vec::new(), at: 0, rest: Vec::new() }
    }

    /// Looks at the first bytes.
    fn begin(&mut self) -> io::Result<()> {
        let mut head = Vec::with_capacity(3);
        self.input.by_ref().take(3).read_to_end(&mut head)?;
        self.form = Form::Plain;
        match head.as_slice() {
            [0xef, 0xbb, 0xbf] => {}
            [0xff, 0xfe, rest @ ..] => {
                self.form = Form::Wide { big: false };
                self.rest = rest.to_vec();
            }
            [0xfe, 0xff, rest @ ..] => {
                self.form = Form::Wide { big: true };
                self.rest = rest.to_vec();
            }
            _ => self.ready = head,
        }
        Ok(())
    }

    /// Decodes the next block of UTF-16; `ready` stays empty at the end only.
    fn decode(&mut self, big: bool) -> io::Result<()> {
        self.ready.clear();
        self.at = 0;
        let held = self.rest.len();
        let mut raw = std::mem::take(&mut self.rest);
        raw.resize(held + BLOCK, 0);
        let n = loop {
            match self.input.read(&mut raw[held..]) {
                Err(e) if e.kind() == io::ErrorKind::Interrupted => {}
                other => break other?,
            }
        };
        raw.truncate(held + n);
        let unit = |c: &[u8]| {
            let pair = [c[0], c[1]];
            if big { u16::from_be_bytes(pair) } else { u16::from_le_bytes(pair) }
        };
        let mut whole = raw.len() / 2 * 2;
        // A first half of a surrogate waits for its second.
        if n > 0 && whole >= 2 && (0xd800..0xdc00).contains(&unit(&raw[whole - 2..])) {
            whole -= 2;
        }
        let mut buffer = [0; 4];
        for c in char::decode_utf16(raw[..whole].chunks_exact(2).map(unit)) {
            let c = c.unwrap_or(char::REPLACEMENT_CHARACTER);
            self.ready.extend_from_slice(c.encode_utf8(&mut buffer).as_bytes());
        }
        if n > 0 {
            self.rest = raw[whole..].to_vec();
        }
        Ok(())
    }
}

impl<R: Read> Read for Decoded<R> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        if self.form == Form::Unknown {
            self.begin()?;
        }
        if let Form::Wide { big } = self.form {
            // A block may hold the first half of a character alone.
            for _ in 0..4 {
                if self.at == self.ready.len() {
                    self.decode(big)?;
                }
            }
        }
        if self.at < self.ready.len() {
            let n = out.len().min(self.ready.len() - self.at);
            out[..n].copy_from_slice(&self.ready[self.at..self.at + n]);
            self.at += n;
            return Ok(n);
        }
        if self.form == Form::Plain { self.input.read(out) } else { Ok(0) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decoded(bytes: &[u8]) -> String {
        let mut text = String::new();
        Decoded::new(bytes).read_to_string(&mut text).unwrap();
        text
    }

    #[test]
    fn marks_are_taken_off() {
        assert_eq!(decoded(b"\xef\xbb\xbfGOTO"), "GOTO");
        assert_eq!(decoded(b"GO"), "GO");
        assert_eq!(decoded(b""), "");
        let text = "PPRINT \u{e9}\u{1d11e}\n".repeat(5000);
        for big in [false, true] {
            let mut bytes = if big { vec![0xfe, 0xff] } else { vec![0xff, 0xfe] };
            for u in text.encode_utf16() {
                bytes.extend(if big { u.to_be_bytes() } else { u.to_le_bytes() });
            }
            assert!(decoded(&bytes) == text);
            bytes.pop();
            assert!(decoded(&bytes).starts_with("PPRINT"));
        }
    }
}
