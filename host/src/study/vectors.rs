//! The reference vectors, for the tests of the truth.

use serde_json::Value;
use std::path::Path;

/// The vector of this name.
pub(super) fn read(name: &str) -> Value {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/reference/vectors");
    let text = std::fs::read_to_string(folder.join(format!("{name}.json"))).expect("the vector");
    serde_json::from_str(&text).expect("JSON")
}

/// A number is a text of thirty digits.
pub(super) fn number(json: &Value) -> f64 {
    json.as_str().expect("a text").parse().expect("a number")
}

/// Of a sample that is far away; of one in the first period nothing is said.
pub(super) fn periods(sample: &Value) -> f64 {
    sample.get("period_count").map_or(0.0, number)
}
