//! NumPy's `.npz`: a ZIP archive of arrays, stored without compression.

use crate::FlexError;

/// An array of a file.
#[derive(Debug, Clone, PartialEq)]
pub enum Array {
    /// Numbers (`<f8`), row by row.
    Numbers {
        /// Its shape.
        shape: Vec<usize>,
        /// Its values.
        values: Vec<f64>,
    },
    /// Words (`|S`), of at most so many bytes.
    Words {
        /// Bytes of each.
        length: usize,
        /// The words.
        values: Vec<String>,
    },
}

/// Day that every entry carries: the first that the format knows, so that equal models are equal files.
const DAY: u16 = 1 << 5 | 1;

/// The bytes of a file of named arrays.
pub fn write_npz(arrays: &[(&str, Array)]) -> Vec<u8> {
    let (mut file, mut directory) = (Vec::new(), Vec::new());
    for (name, array) in arrays {
        let (name, data) = (format!("{name}.npy"), npy(array));
        let place = file.len() as u32;
        let mut common = Vec::new();
        // Version 2.0, no flags, stored, time and day, checksum, both sizes, length of the name, no extra field.
        for number in [20u16, 0, 0, 0, DAY] {
            common.extend(number.to_le_bytes());
        }
        for number in [checksum(&data), data.len() as u32, data.len() as u32] {
            common.extend(number.to_le_bytes());
        }
        common.extend((name.len() as u16).to_le_bytes());
        common.extend(0u16.to_le_bytes());
        file.extend(b"PK\x03\x04");
        file.extend(&common);
        file.extend(name.as_bytes());
        file.extend(data);
        directory.extend(b"PK\x01\x02");
        directory.extend(20u16.to_le_bytes());
        directory.extend(&common);
        directory.extend([0; 10]);
        directory.extend(place.to_le_bytes());
        directory.extend(name.as_bytes());
    }
    let (start, count) = (file.len() as u32, arrays.len() as u16);
    let length = directory.len() as u32;
    file.extend(directory);
    file.extend(b"PK\x05\x06");
    for number in [0, 0, count, count] {
        file.extend(number.to_le_bytes());
    }
    file.extend(length.to_le_bytes());
    file.extend(start.to_le_bytes());
    file.extend(0u16.to_le_bytes());
    file
}

fn npy(array: &Array) -> Vec<u8> {
    let (kind, shape) = match array {
        Array::Numbers { shape, .. } => ("<f8".to_owned(), shape.clone()),
        Array::Words { length, values } => (format!("|S{length}"), vec![values.len()]),
    };
    let shape: Vec<String> = shape.iter().map(|size| format!("{size},")).collect();
    let mut head = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({}), }}", shape.join(" "));
    // Magic, version and length take 10 bytes; the data begin at a multiple of 64.
    while !(10 + head.len() + 1).is_multiple_of(64) {
        head.push(' ');
    }
    head.push('\n');
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((head.len() as u16).to_le_bytes());
    bytes.extend(head.as_bytes());
    match array {
        Array::Numbers { values, .. } => bytes.extend(values.iter().flat_map(|value| value.to_le_bytes())),
        Array::Words { length, values } => {
            for word in values {
                let mut word: Vec<u8> = word.bytes().take(*length).collect();
                word.resize(*length, 0);
                bytes.extend(word);
            }
        }
    }
    bytes
}

fn wrong(message: impl Into<String>) -> FlexError {
    FlexError::File { what: ".npz file", message: message.into() }
}

fn short(bytes: &[u8], at: usize) -> Result<usize, FlexError> {
    let pair = bytes.get(at..at + 2).ok_or_else(|| wrong("it is cut off"))?;
    Ok(usize::from(u16::from_le_bytes([pair[0], pair[1]])))
}

fn long(bytes: &[u8], at: usize) -> Result<usize, FlexError> {
    let own = bytes.get(at..at + 4).ok_or_else(|| wrong("it is cut off"))?;
    Ok(u32::from_le_bytes([own[0], own[1], own[2], own[3]]) as usize)
}

/// The arrays of a file that [`write_npz`] or NumPy's `savez` wrote.
///
/// # Errors
/// [`FlexError::File`] for what is no such file, is compressed, damaged, or holds numbers of another kind.
pub fn read_npz(bytes: &[u8]) -> Result<Vec<(String, Array)>, FlexError> {
    let end = bytes.windows(4).rposition(|four| four == b"PK\x05\x06");
    let end = end.ok_or_else(|| wrong("it has no directory: it is no .npz file, or cut off"))?;
    if bytes.len() != end + 22 + short(bytes, end + 20)? {
        return Err(wrong("it is cut off"));
    }
    let (count, mut place) = (short(bytes, end + 10)?, long(bytes, end + 16)?);
    let mut arrays = Vec::new();
    for _ in 0..count {
        if bytes.get(place..place + 4) != Some(b"PK\x01\x02") {
            return Err(wrong("its directory is damaged"));
        }
        let (method, sum, length) =
            (short(bytes, place + 10)?, long(bytes, place + 16)?, long(bytes, place + 24)?);
        let (name_length, extra, comment) =
            (short(bytes, place + 28)?, short(bytes, place + 30)?, short(bytes, place + 32)?);
        let start = long(bytes, place + 42)?;
        let name = bytes.get(place + 46..place + 46 + name_length).ok_or_else(|| wrong("it is cut off"))?;
        let name = String::from_utf8_lossy(name).trim_end_matches(".npy").to_owned();
        if method != 0 {
            return Err(wrong(format!("the array {name} is compressed: write it with numpy.savez")));
        }
        let data = start + 30 + short(bytes, start + 26)? + short(bytes, start + 28)?;
        let data = bytes.get(data..data + length).ok_or_else(|| wrong("it is cut off"))?;
        if checksum(data) as usize != sum {
            return Err(wrong(format!("the array {name} is damaged: its checksum differs")));
        }
        let array = array(&name, data)?;
        arrays.push((name, array));
        place += 46 + name_length + extra + comment;
    }
    Ok(arrays)
}

fn array(name: &str, data: &[u8]) -> Result<Array, FlexError> {
    let other = |what: &str| wrong(format!("the array {name} {what}"));
    if data.get(..6) != Some(b"\x93NUMPY") || data.get(6) != Some(&1) {
        return Err(other("has no head of version 1"));
    }
    let length = short(data, 8)?;
    let head = data.get(10..10 + length).ok_or_else(|| other("is cut off"))?;
    let head = String::from_utf8_lossy(head);
    let value = |key: &str| head.split_once(key).map(|(_, rest)| rest.trim_start_matches([':', ' ', '\'']));
    let kind = value("'descr'").and_then(|rest| rest.split('\'').next()).unwrap_or_default().to_owned();
    if !head.contains("'fortran_order': False") {
        return Err(other("is stored column by column"));
    }
    let shape = value("'shape'").and_then(|rest| rest.trim_start_matches('(').split(')').next());
    let shape: Option<Vec<usize>> = shape.and_then(|shape| {
        shape
            .split(',')
            .map(str::trim)
            .filter(|part| !part.is_empty())
            .map(|part| part.parse().ok())
            .collect()
    });
    let shape = shape.ok_or_else(|| other("has no shape"))?;
    let rest = &data[10 + length..];
    let count = shape.iter().try_fold(1usize, |product, size| product.checked_mul(*size));
    let count = count.ok_or_else(|| other("is too large"))?;
    if kind == "<f8" {
        if rest.len() != count.saturating_mul(8) {
            return Err(other("has a shape that does not fit its length"));
        }
        let number = |own: &[u8]| {
            let mut bytes = [0; 8];
            bytes.copy_from_slice(own);
            f64::from_le_bytes(bytes)
        };
        return Ok(Array::Numbers { shape, values: rest.chunks_exact(8).map(number).collect() });
    }
    let length =
        kind.strip_prefix("|S").and_then(|length| length.parse::<usize>().ok()).filter(|length| *length > 0);
    match length {
        Some(length) if shape.len() == 1 && rest.len() == count.saturating_mul(length) => {
            let word = |own: &[u8]| String::from_utf8_lossy(own).trim_end_matches('\0').to_owned();
            Ok(Array::Words { length, values: rest.chunks_exact(length).map(word).collect() })
        }
        _ => Err(other(&format!("is of the kind {kind}, needed <f8 or |S"))),
    }
}

/// CRC-32 of ZIP (polynomial 0xEDB88320, reflected).
fn checksum(bytes: &[u8]) -> u32 {
    let mut sum = u32::MAX;
    for byte in bytes {
        sum ^= u32::from(*byte);
        for _ in 0..8 {
            sum = if sum & 1 == 1 { sum >> 1 ^ 0xEDB8_8320 } else { sum >> 1 };
        }
    }
    !sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_published_check_value_of_crc_32() {
        assert_eq!(checksum(b"123456789"), 0xCBF4_3926);
    }

    #[test]
    fn arrays_come_back_and_damage_is_refused() {
        let numbers = Array::Numbers { shape: vec![2, 3], values: vec![1.0, -2.5, 1e-300, 0.1, 7.0, 9.0] };
        let words = Array::Words { length: 8, values: vec!["PIN_1".to_owned(), "MAIN_1".to_owned()] };
        let file = write_npz(&[("a", numbers.clone()), ("b", words.clone())]);
        let read = read_npz(&file).unwrap();
        assert_eq!(read, vec![("a".to_owned(), numbers), ("b".to_owned(), words)]);
        for end in 0..file.len() {
            assert!(read_npz(&file[..end]).is_err(), "{end}");
        }
        let mut damaged = file.clone();
        let place = file.windows(8).position(|own| own == (-2.5f64).to_le_bytes()).unwrap();
        damaged[place] ^= 1;
        assert!(read_npz(&damaged).unwrap_err().to_string().contains("checksum"));
        for place in 0..file.len() {
            let mut damaged = file.clone();
            damaged[place] ^= 0x55;
            let _ = read_npz(&damaged);
        }
    }
}
