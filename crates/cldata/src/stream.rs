//! What all readers and writers of CL data share.

use std::io;

use crate::Record;

/// Gives records one after the other.
pub trait RecordReader {
    /// Puts the next record into `record`, whose memory is used again; false at the end.
    fn read(&mut self, record: &mut Record) -> io::Result<bool>;
}

/// Takes records one after the other.
pub trait RecordWriter {
    /// Writes one record.
    fn write(&mut self, record: &Record) -> io::Result<()>;

    /// Ends the file; call it once, after the last record.
    fn finish(&mut self) -> io::Result<()>;
}

impl RecordWriter for Vec<Record> {
    fn write(&mut self, record: &Record) -> io::Result<()> {
        self.push(record.clone());
        Ok(())
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Passes everything from the reader to the writer and ends the file. The number of records.
pub fn copy(reader: &mut dyn RecordReader, writer: &mut dyn RecordWriter) -> io::Result<u64> {
    let mut record = Record::default();
    let mut n = 0;
    while reader.read(&mut record)? {
        writer.write(&record)?;
        n += 1;
    }
    writer.finish()?;
    Ok(n)
}
