//! Rows as a NumPy file: a structured array of one dimension, read by `numpy.load(FILE)["omega_x"]`.

/// Header of a file with columns of these names and this many rows (format 1.0: magic, length, and a Python literal that ends at a multiple of 64 bytes).
pub fn header(names: &[String], rows: u64) -> Vec<u8> {
    const BEFORE: usize = 10;
    let fields: String = names.iter().map(|name| format!("('{name}', '<f8'), ")).collect();
    let mut text = format!("{{'descr': [{fields}], 'fortran_order': False, 'shape': ({rows},), }}");
    while !(BEFORE + text.len() + 1).is_multiple_of(64) {
        text.push(' ');
    }
    text.push('\n');
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    // the header has some hundred bytes, so its length fits 16 bits
    bytes.extend_from_slice(&(text.len() as u16).to_le_bytes());
    bytes.extend_from_slice(text.as_bytes());
    bytes
}
