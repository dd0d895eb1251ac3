//! Tables: bytes that depend on the rows alone, read back as they were written, and sinks that fail.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester_table::{
    BLOCKS, Bytes, Column, Form, Rows, SEAL, TableError, TableReader, TableWriter, Values, csv_seal,
};
use std::io::{self, Write};

fn columns() -> Vec<Column> {
    vec![Column::whole("case"), Column::real("force_N"), Column::text("firing_order")]
}

fn rows(from: usize, to: usize) -> Rows {
    Rows::of(vec![
        Values::Whole((from..to).map(|k| k as i64).collect()),
        Values::Real((from..to).map(|k| 1.0 / (k as f64 + 0.1)).collect()),
        Values::Text((from..to).map(|k| format!("1-{},{}", k % 7, k % 11)).collect()),
    ])
}

fn table(form: Form, cuts: &[usize]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut writer = TableWriter::new(form, &mut bytes, &columns()).unwrap();
    for pair in cuts.windows(2) {
        writer.push(rows(pair[0], pair[1])).unwrap();
    }
    writer.finish(&[("key".to_owned(), "value".to_owned())]).unwrap();
    bytes
}

/// More rows than two groups.
const MANY: usize = 150_000;

#[test]
fn bytes_do_not_depend_on_the_pieces() {
    for form in [Form::Parquet, Form::Csv] {
        let whole = table(form, &[0, MANY]);
        assert_eq!(table(form, &[0, 1, 1, 65_535, 65_536, 65_537, 140_000, MANY]), whole);
        let every: Vec<usize> = (0..=MANY).step_by(1000).collect();
        assert_eq!(table(form, &every), whole);
        assert_ne!(table(form, &[0, MANY - 1]), whole);
    }
}

#[test]
fn what_is_read_is_what_was_written() {
    let mut reader = TableReader::open(Bytes::from(table(Form::Parquet, &[0, 70_000, MANY]))).unwrap();
    assert_eq!(
        (reader.rows(), reader.metadata("key"), reader.metadata("other")),
        (150_000, Some("value"), None)
    );
    assert_eq!(reader.columns(), Some(columns()));
    let mut all = Rows::empty(&columns());
    while let Some(rows) = reader.next(&columns()).unwrap() {
        all.append(rows);
    }
    assert_eq!(all, rows(0, MANY));
    let others = [Column::whole("case"), Column::real("couple_Nm")];
    let error = reader.next(&others).unwrap_err().to_string();
    assert_eq!(error, "the table has other columns: needed case, couple_Nm, got case, force_N, firing_order");
    // No row is a table too.
    let mut empty = TableReader::open(Bytes::from(table(Form::Parquet, &[0]))).unwrap();
    assert_eq!((empty.rows(), empty.next(&columns()).unwrap()), (0, None));
}

#[test]
fn csv_is_plain() {
    assert_eq!(
        String::from_utf8(table(Form::Csv, &[0, 2])).unwrap(),
        "case,force_N,firing_order\r\n0,10,\"1-0,0\"\r\n1,0.9090909090909091,\"1-1,1\"\r\n"
    );
}

#[test]
fn no_word_of_csv_is_a_formula() {
    let columns = [Column::text("shafts"), Column::real("force_N")];
    let words = ["=1+1", "+1 -1", "-2", "@A1", "web 1"].map(str::to_owned).to_vec();
    let mut bytes = Vec::new();
    let mut writer = TableWriter::new(Form::Csv, &mut bytes, &columns).unwrap();
    writer.push(Rows::of(vec![Values::Text(words), Values::Real(vec![-1.0, 0.0, 1.0, -2.5, 3.0])])).unwrap();
    writer.finish(&[]).unwrap();
    assert_eq!(
        String::from_utf8(bytes).unwrap(),
        "shafts,force_N\r\n'=1+1,-1\r\n'+1 -1,0\r\n-2,1\r\n'@A1,-2.5\r\nweb 1,3\r\n"
    );
}

#[test]
fn what_is_no_table_or_not_ended_is_told() {
    for bytes in [Vec::new(), b"case,force\n".to_vec(), table(Form::Parquet, &[0, 10])[..200].to_vec()] {
        assert!(matches!(TableReader::open(Bytes::from(bytes)), Err(TableError::Damaged { .. })));
    }
}

/// All that can be read from a table, every byte of it verified.
fn read_all(bytes: Vec<u8>) -> Result<Rows, TableError> {
    let mut reader = TableReader::open(Bytes::from(bytes))?;
    reader.verify()?;
    let mut all = Rows::empty(&columns());
    while let Some(rows) = reader.next(&columns())? {
        all.append(rows);
    }
    Ok(all)
}

/// Every bit of a table is under a hash: data, indexes, footer, the lengths and the hashes themselves.
#[test]
fn one_flipped_bit_anywhere_is_found() {
    let whole = table(Form::Parquet, &[0, 500]);
    assert_eq!(read_all(whole.clone()).unwrap(), rows(0, 500));
    let mut kinds = [0; 4];
    for byte in 0..whole.len() {
        let mut bytes = whole.clone();
        bytes[byte] ^= 1 << (byte % 8);
        let Err(error) = read_all(bytes) else { panic!("byte {byte}") };
        let kind = match error {
            TableError::Altered { first: 0, rows: 500, of: 500 } => 0,
            TableError::AlteredFooter => 1,
            TableError::Unsealed => 2,
            TableError::Damaged { .. } => 3,
            other => panic!("byte {byte}: {other}"),
        };
        kinds[kind] += 1;
    }
    // Where it is can be said of all but the few bytes by which lengths, hashes and the end are found.
    assert!(kinds[0] > 2000 && kinds[1] > 500 && kinds[2] + kinds[3] < 200, "{kinds:?}");
}

/// A cut anywhere is found too: a disk that was full, a copy that was cancelled.
#[test]
fn a_torn_table_is_found() {
    let whole = table(Form::Parquet, &[0, 500]);
    for length in 0..whole.len() {
        assert!(read_all(whole[..length].to_vec()).is_err(), "{length} bytes");
    }
}

/// Which block of a larger table is damaged is told, and the others can be read.
#[test]
fn a_damaged_block_is_named() {
    let whole = table(Form::Parquet, &[0, MANY]);
    let starts = blocks_of(&whole);
    for (k, (start, length, _)) in starts.iter().enumerate() {
        for byte in [*start, start + length / 2, start + length - 1] {
            let mut bytes = whole.clone();
            bytes[byte] ^= 1;
            let mut reader = TableReader::open(Bytes::from(bytes)).unwrap();
            let told = reader.verify().unwrap_err().to_string();
            let (from, to) = (k * 65_536 + 1, MANY.min((k + 1) * 65_536));
            let said =
                format!("rows {from} to {to} of 150000 are not those that were written (SHA-256 differs)");
            assert_eq!(told, said, "byte {byte}");
            for _ in 0..k {
                assert_eq!(reader.next(&columns()).unwrap().unwrap().len(), 65_536);
            }
            assert_eq!(reader.next(&columns()).unwrap_err().to_string(), said, "byte {byte}");
        }
    }
}

/// Start, length and hash of the blocks, as the footer tells them.
fn blocks_of(bytes: &[u8]) -> Vec<(usize, usize, String)> {
    let reader = TableReader::open(Bytes::from(bytes.to_vec())).unwrap();
    let mut start = 0;
    let block = |entry: &str| {
        let (length, hash) = entry.split_once(':').unwrap();
        let length: usize = length.parse().unwrap();
        start += length;
        (start - length, length, hash.to_owned())
    };
    reader.metadata(BLOCKS).unwrap().split(' ').map(block).collect()
}

/// Anybody can compute the hashes: those of the blocks over their bytes, that of the tail with sixty-four zeros in its place.
#[test]
fn the_hashes_are_what_is_said_of_them() {
    let bytes = table(Form::Parquet, &[0, MANY]);
    let blocks = blocks_of(&bytes);
    assert_eq!(blocks.len(), 3);
    for (start, length, hash) in &blocks {
        assert_eq!(csv_seal(&bytes[*start..start + length], &[]).unwrap(), *hash);
    }
    let reader = TableReader::open(Bytes::from(bytes.clone())).unwrap();
    let hash = reader.metadata(SEAL).unwrap();
    let place = bytes.windows(64).position(|some| some == hash.as_bytes()).unwrap();
    let mut open = bytes.clone();
    open[place..place + 64].fill(b'0');
    let (start, length, _) = blocks.last().unwrap();
    assert_eq!(csv_seal(&open[start + length..], &[]).unwrap(), hash);
    // The published value for "abc" (FIPS 180-2, appendix B.1).
    assert_eq!(
        csv_seal(&b"abc"[..], &[]).unwrap(),
        "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
    );
}

/// A disk with room for so many bytes.
struct Disk(usize);

impl Write for Disk {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.0 == 0 {
            return Err(io::Error::new(io::ErrorKind::StorageFull, "no space left"));
        }
        let taken = bytes.len().min(self.0);
        self.0 -= taken;
        Ok(taken)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_full_disk_is_told_wherever_it_fills() {
    for form in [Form::Parquet, Form::Csv] {
        let size = table(form, &[0, MANY]).len();
        for room in [0, 3, size / 2, size - 1, size] {
            let write = || -> Result<(), TableError> {
                let mut writer = TableWriter::new(form, Disk(room), &columns())?;
                writer.push(rows(0, MANY))?;
                writer.finish(&[("key".to_owned(), "value".to_owned())]).map(drop)
            };
            match write() {
                Ok(()) => assert_eq!(room, size, "{form:?}"),
                Err(error) => {
                    assert!(room < size, "{form:?} {room}: {error}");
                    assert_eq!(error.to_string(), "no space left", "{form:?} {room}");
                }
            }
        }
    }
}
