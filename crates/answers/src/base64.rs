//! Many numbers as one text: their bytes, the lowest first, in the letters of RFC 4648.

const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// The text of bytes.
pub(crate) fn base64(bytes: impl IntoIterator<Item = u8>) -> String {
    let mut text = Vec::new();
    let mut bytes = bytes.into_iter();
    while let Some(first) = bytes.next() {
        let (second, third) = (bytes.next(), bytes.next());
        let bits = (u32::from(first) << 16)
            | (u32::from(second.unwrap_or_default()) << 8)
            | u32::from(third.unwrap_or_default());
        let letter = |shift: u32| LETTERS[(bits >> shift) as usize % 64];
        text.extend([letter(18), letter(12)]);
        text.push(second.map_or(b'=', |_| letter(6)));
        text.push(third.map_or(b'=', |_| letter(0)));
    }
    text.into_iter().map(char::from).collect()
}

#[cfg(test)]
mod tests {
    use super::base64;

    #[test]
    fn texts_are_those_of_the_standard() {
        let wanted = ["", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"];
        for (length, wanted) in wanted.into_iter().enumerate() {
            assert_eq!(base64(b"foobar"[..length].iter().copied()), wanted);
        }
        assert_eq!(base64((-1i16).to_le_bytes()), "//8=");
    }
}
