//! The files that were read, and the way from a byte to a line and column.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

/// Which file of the [`SourceMap`].
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Default, Serialize, Deserialize,
)]
pub struct FileId(pub u32);

/// One file as it was read.
#[derive(Clone, Debug)]
pub struct SourceFile {
    /// Name as the user gave it.
    pub name: Arc<str>,
    /// The whole text.
    pub text: Arc<str>,
    line_starts: Vec<u32>,
    /// Byte, line and column of the places asked about, when the text is not kept.
    places: Vec<[u32; 3]>,
}

/// All files of one run, in the order in which they were read.
#[derive(Clone, Debug, Default)]
pub struct SourceMap {
    files: Vec<SourceFile>,
}

impl SourceMap {
    /// Takes a file in. The text must be shorter than 4 GiB (Section 0 refuses longer ones).
    pub fn add(&mut self, name: impl Into<Arc<str>>, text: impl Into<Arc<str>>) -> FileId {
        let text: Arc<str> = text.into();
        let starts = text.bytes().enumerate().filter(|(_, b)| *b == b'\n').map(|(i, _)| i + 1);
        let line_starts = std::iter::once(0)
            .chain(starts)
            .map(|i| u32::try_from(i).expect("Section 0 refuses files of 4 GiB"))
            .collect();
        let id = FileId(u32::try_from(self.files.len()).expect("fewer than 4 G files"));
        let places = Vec::new();
        self.files.push(SourceFile { name: name.into(), text, line_starts, places });
        id
    }

    /// Takes a file in whose text is too long to be kept; its places are told later.
    pub fn add_unkept(&mut self, name: impl Into<Arc<str>>) -> FileId {
        self.add(name, "")
    }

    /// Tells byte, line and column of the places of a file whose text is not kept.
    pub fn set_places(&mut self, id: FileId, mut places: Vec<[u32; 3]>) {
        places.sort_unstable();
        if let Some(file) = self.files.get_mut(id.0 as usize) {
            file.places = places;
        }
    }

    /// The file, if there is one with that number.
    pub fn get(&self, id: FileId) -> Option<&SourceFile> {
        self.files.get(id.0 as usize)
    }

    /// All files in order.
    pub fn iter(&self) -> impl Iterator<Item = (FileId, &SourceFile)> {
        (0..).map(FileId).zip(&self.files)
    }

    /// Line and column, both from 1, of a byte; the column counts characters. (0, 0) when the file
    /// is not in the map.
    pub fn line_column(&self, file: FileId, byte: u32) -> (u32, u32) {
        self.get(file).map_or((0, 0), |f| f.line_column(byte))
    }
}

impl SourceFile {
    /// Line and column, both from 1, of a byte; the column counts characters.
    pub fn line_column(&self, byte: u32) -> (u32, u32) {
        if !self.places.is_empty() {
            let after = self.places.partition_point(|p| p[0] <= byte);
            return after.checked_sub(1).map_or((1, 1), |i| (self.places[i][1], self.places[i][2]));
        }
        let byte = byte.min(u32::try_from(self.text.len()).unwrap_or(u32::MAX));
        let line = self.line_starts.partition_point(|&s| s <= byte);
        let start = self.line_starts[line - 1] as usize;
        let before = self.text.get(start..byte as usize).unwrap_or("");
        let column = before.chars().count() + 1;
        (u32::try_from(line).unwrap_or(u32::MAX), u32::try_from(column).unwrap_or(u32::MAX))
    }

    /// Is the text there to be shown?
    pub fn is_kept(&self) -> bool {
        !self.text.is_empty()
    }

    /// Text of a line counted from 1, without its end; empty when there is no such line.
    pub fn line(&self, line: u32) -> &str {
        let at = |n: u32| self.line_starts.get(n as usize).map_or(self.text.len(), |&s| s as usize);
        if line == 0 || line as usize > self.line_starts.len() {
            return "";
        }
        self.text[at(line - 1)..at(line)].trim_end_matches(['\n', '\r'])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_columns_count_characters_from_one() {
        let mut map = SourceMap::default();
        let f = map.add("a.apt", "P1=POINT/1,2\n$$ Füße 7\nFINI");
        assert_eq!(map.line_column(f, 0), (1, 1));
        assert_eq!(map.line_column(f, 13), (2, 1));
        let seven = map.get(f).unwrap().text.find('7').unwrap();
        assert_eq!(map.line_column(f, u32::try_from(seven).unwrap()), (2, 9));
        assert_eq!(map.get(f).unwrap().line(3), "FINI");
        assert_eq!(map.line_column(FileId(9), 0), (0, 0));
        let long = map.add_unkept("long.cl");
        map.set_places(long, vec![[700, 30, 4], [90, 5, 1]]);
        assert_eq!((map.line_column(long, 90), map.line_column(long, 700)), ((5, 1), (30, 4)));
        assert!(!map.get(long).unwrap().is_kept() && map.get(f).unwrap().is_kept());
    }
}
