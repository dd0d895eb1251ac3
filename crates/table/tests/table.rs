//! Tables: bytes that depend on the rows alone, read back as they were written, and sinks that fail.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester_table::{
    Bytes, Column, Form, Rows, SEAL, TableError, TableReader, TableWriter, Values, csv_seal,
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

/// Every bit of a table is under its hash: data, footer and the hash itself.
#[test]
fn one_flipped_bit_anywhere_is_found() {
    let whole = table(Form::Parquet, &[0, 500]);
    TableReader::open(Bytes::from(whole.clone())).unwrap();
    for byte in 0..whole.len() {
        let mut bytes = whole.clone();
        bytes[byte] ^= 1 << (byte % 8);
        let Err(error) = TableReader::open(Bytes::from(bytes)) else { panic!("byte {byte}") };
        assert!(
            matches!(error, TableError::Altered | TableError::Unsealed | TableError::Damaged { .. }),
            "{error}"
        );
    }
}

/// The hash is that of the bytes with sixty-four zeros in its place: anybody can compute it.
#[test]
fn the_hash_is_what_is_said_of_it() {
    let bytes = table(Form::Parquet, &[0, 500]);
    let reader = TableReader::open(Bytes::from(bytes.clone())).unwrap();
    let hash = reader.metadata(SEAL).unwrap();
    let place = bytes.windows(64).position(|some| some == hash.as_bytes()).unwrap();
    let mut open = bytes.clone();
    open[place..place + 64].fill(b'0');
    assert_eq!(csv_seal(&open[..], &[]).unwrap(), hash);
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
