//! Reference vectors, for the tests of the truth.

use super::exact::PreciseOrientation;
use super::precise::{Precise, rounded, to_f64};
use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use serde_json::Value;
use std::path::Path;

/// Reference vector of this name.
pub(super) fn read(name: &str) -> Value {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/reference/vectors");
    let text = std::fs::read_to_string(folder.join(format!("{name}.json"))).expect("the vector");
    serde_json::from_str(&text).expect("JSON")
}

/// Number of a text of thirty digits, rounded to `f64`.
pub(super) fn number(json: &Value) -> f64 {
    json.as_str().expect("a text").parse().expect("a number")
}

/// Number of a text of thirty digits, with all of them.
pub(super) fn digits(json: &Value) -> Precise {
    let decimal: FBig<HalfEven, 10> = json.as_str().expect("a text").parse().expect("a number");
    rounded(&decimal.with_precision(80).value().with_base_and_precision::<2>(256).value())
}

/// Samples of a vector, with those after many periods.
pub(super) fn samples(json: &Value) -> impl Iterator<Item = &Value> {
    let list = |key: &str| json[key].as_array().expect("samples").iter();
    list("samples").chain(list("huge_samples"))
}

/// Distance 2 √(|Δα|² + |Δβ|²) of an orientation from a sample, rad.
pub(super) fn error(phi: &PreciseOrientation, sample: &Value) -> f64 {
    let parameter = |key: &str| [0, 1].map(|i| digits(&sample[key][i]));
    phi.apart(&PreciseOrientation { alpha: parameter("alpha"), beta: parameter("beta") })
}

/// Relative error of a number against a text of thirty digits.
pub(super) fn relative(found: &Precise, json: &Value) -> f64 {
    to_f64(&(found / digits(json) - Precise::ONE)).abs()
}
