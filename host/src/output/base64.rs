//! Base 64 (RFC 4648): bytes as text.

/// Digits, in the order of their values.
const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Bytes in base 64, padded.
pub fn base64(bytes: &[u8]) -> String {
    bytes.chunks(3).flat_map(four).collect()
}

/// Digits of up to three bytes.
fn four(bytes: &[u8]) -> [char; 4] {
    let word = (0..3).fold(0, |word, i| (word << 8) | usize::from(bytes.get(i).copied().unwrap_or(0)));
    core::array::from_fn(|place| {
        let digit = DIGITS[(word >> (18 - 6 * place)) & 63];
        if place <= bytes.len() { digit.into() } else { '=' }
    })
}

#[cfg(test)]
mod tests {
    use super::base64;

    /// The examples of RFC 4648, and every digit.
    #[test]
    fn as_the_rfc_has_it() {
        let text = b"foobar";
        let expected = ["", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"];
        for (length, expected) in expected.into_iter().enumerate() {
            assert_eq!(base64(&text[..length]), expected);
        }
        assert_eq!(base64(&[0xfb, 0xef, 0xbe, 0xff, 0xff, 0xff]), "++++////");
    }
}
