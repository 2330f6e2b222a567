//! Rows with a checksum: each ends in a checksum of the text before it, which detects a changed byte.

/// Last column of every table.
pub(super) const CHECKSUM: &str = "crc32";

/// Row with its checksum, eight hexadecimal digits, and a line break.
pub(super) fn sealed(row: &str) -> String {
    format!("{row},{:08x}\n", crc32fast::hash(row.as_bytes()))
}

/// Row of a line without its line break; `None` where it does not match its checksum.
pub(super) fn unsealed(line: &[u8]) -> Option<&str> {
    let comma = line.iter().rposition(|byte| *byte == b',')?;
    let (row, checksum) = line.split_at(comma);
    let stated = format!(",{:08x}", crc32fast::hash(row));
    (checksum == stated.as_bytes()).then(|| str::from_utf8(row).ok())?
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_changed_byte_is_seen() {
        let line = sealed("17,30,0.1.0,1,0.25");
        let line = line.trim_end().as_bytes();
        assert_eq!(unsealed(line), Some("17,30,0.1.0,1,0.25"));
        for place in 0..line.len() {
            for bit in 0..8 {
                let mut changed = line.to_vec();
                changed[place] ^= 1 << bit;
                assert_eq!(unsealed(&changed), None, "{place} {bit}");
            }
        }
        assert_eq!([unsealed(b""), unsealed(b"17,30"), unsealed(&line[..line.len() - 1])], [None; 3]);
        // check value of the checksum of zip and PNG
        assert_eq!(sealed("123456789"), "123456789,cbf43926\n");
    }
}
