//! Cells that are written are read again, in their rows and columns; what is no table says so.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use lanchester_sheet::{Cell, SheetError, read_csv, read_workbook, separator, workbook};

#[test]
fn workbooks_read_back_and_are_the_same_bytes_again() {
    let heads = ["rod.length [mm]".to_owned(), "name".to_owned(), "flag".to_owned()];
    let rows = [
        vec![Cell::Number(140.25), Cell::Text("=not a formula".to_owned()), Cell::Flag(true)],
        vec![],
        vec![Cell::Empty, Cell::Text("long".to_owned())],
    ];
    let bytes = workbook("cases", &heads, &rows).unwrap();
    assert_eq!(bytes, workbook("cases", &heads, &rows).unwrap());
    let read = read_workbook(&bytes).unwrap();
    assert_eq!(read.iter().map(|row| row.number).collect::<Vec<_>>(), [1, 2, 4]);
    assert_eq!(read[1].cells, rows[0]);
    assert_eq!(read[2].cells, rows[2]);
}

#[test]
fn csv_keeps_the_numbers_of_its_rows() {
    let rows = read_csv("\u{feff}a,\"b, c\"\r\n\r\n1,\r\n").unwrap();
    assert_eq!(rows[0].cells[1], Cell::Text("b, c".to_owned()));
    assert_eq!((rows[1].number, rows[1].cells[1].clone()), (3, Cell::Empty));
}

#[test]
fn the_first_row_says_what_parts_the_cells() {
    let text = |text: &str| Cell::Text(text.to_owned());
    for (written, by) in [("a;\"b; c\"\n1,5;x\n", ';'), ("\u{feff}a\t\"b; c\"\n1,5\tx\n", '\t')] {
        assert_eq!(separator(written), by, "{written}");
        let rows = read_csv(written).unwrap();
        assert_eq!(rows[0].cells, [text("a"), text("b; c")], "{written}");
        assert_eq!(rows[1].cells, [text("1,5"), text("x")], "{written}");
    }
    // Quotes and later rows say nothing, nor does a single semicolon or comma in a head.
    assert_eq!(separator("a,\"b;c;d\"\n1;2,3;4\n"), ',');
    assert_eq!(separator("rod.length [mm],comment; free\n140,x\n"), ',');
    assert_eq!(separator("rod.length [mm],comment; free; or not,name\r1;2;3\n"), ',');
    assert_eq!(separator("rod.length [mm];comment, free;name\n1,5;x;y\n"), ';');
    assert_eq!(separator("a; b\tc, d\te\n"), '\t');
    let rows = read_csv("rod.length [mm],comment; free\n140,\"long, thin\"\n").unwrap();
    assert_eq!(rows[1].cells, [text("140"), text("long, thin")]);
    assert_eq!(separator(""), ',');
}

#[test]
fn a_quotation_mark_that_is_not_closed_is_named_with_its_line() {
    for (written, line) in
        [("name,b\n\"abc,140\n", 2), ("a;b\n1;\"x\"\n\n2;\"y\nz", 4), ("a\n\"b\"\"\n", 2), ("\"", 1)]
    {
        let error = read_csv(written).unwrap_err();
        assert!(matches!(error, SheetError::Csv { row, .. } if row == line), "{written}: {error}");
        assert!(error.to_string().contains("quotation mark"), "{error}");
    }
    // Within a cell, doubled, and at its end they are none of that.
    for written in ["a\n1\" pipe\n", "a,b\n\"x \"\"y\"\"\",\"\"\n", "a\n\"\"\n", "a\n\"two\nlines\"\nb\n"] {
        assert!(read_csv(written).is_ok(), "{written}");
    }
}

#[test]
fn what_is_no_workbook_says_so() {
    for bytes in [&b""[..], b"rod.length\n140\n", b"PK\x03\x04 damaged"] {
        assert!(matches!(read_workbook(bytes), Err(SheetError::Workbook(_))));
    }
}
