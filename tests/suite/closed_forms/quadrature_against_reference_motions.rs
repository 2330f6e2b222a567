//! The quadrature in 640 bits, itself a reference, is compared with motions known to 30 digits.

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use serde_json::Value;
use toytop::{Orientation, Support, TopParameters};
use toytop_host::input::scenario::{Launch, MotionInput};
use toytop_host::reference::float640::{Float640, Orientation640, to_f64};
use toytop_host::reference::quadrature::Quadrature;
use toytop_tests::vectors::{self, Vector, complex, entries, number, triple};

/// Number of a text of thirty digits, with all of them.
fn digits(json: &Value) -> Float640 {
    let decimal: FBig<HalfEven, 10> = json.as_str().unwrap().parse().unwrap();
    decimal.with_precision(80).value().with_base_and_precision::<2>(640).value()
}

/// Top and launch of a vector whose numbers are exact in `f64`.
fn input(vector: &Vector) -> MotionInput {
    let params = &vector.json["params"];
    let [a, c, s, p] = ["A", "C", "s", "p"].map(|key| number(&params[key]));
    let top = TopParameters {
        transverse_inertia: a,
        axial_inertia: c,
        com_height: s,
        mass_moment: p,
        gravity: 1.0,
        ..TopParameters::default()
    };
    let launch = if vector.by_branch_points() {
        Launch::BranchPoints { e: vector.roots(), signs: vector.signs(), phases: vector.start() }
    } else {
        let [alpha, beta] = ["alpha0", "beta0"].map(|key| complex(&params[key]));
        Launch::State { orientation: Orientation { alpha, beta }, omega: triple(&params["omega0"]) }
    };
    MotionInput { support: if s > 0.0 { Support::Sliding } else { Support::Fixed }, top, launch }
}

#[test]
fn quadrature_agrees_with_thirty_digits() {
    let mut checked = 0;
    for vector in vectors::all().iter().filter(|vector| vector.is_exact()) {
        let (name, exact) = (&vector.name, Quadrature::new(&input(vector)));
        let Some(period) = exact.period() else { continue };
        let period = period / digits(&vector.json["period"]["T"]) - Float640::ONE;
        assert!(to_f64(&period).abs() < 1e-29, "{name}: period off by {:e}", to_f64(&period));
        for sample in ["samples", "huge_samples"].iter().flat_map(|key| entries(&vector.json[key])) {
            let [alpha, beta] = ["alpha", "beta"].map(|key| [0, 1].map(|i| digits(&sample[key][i])));
            let error = exact.at(&digits(&sample["t"])).distance(&Orientation640 { alpha, beta });
            assert!(error < 1e-28, "{name} at {}: {error:e}", sample["t"]);
            checked += 1;
        }
    }
    assert!(checked > 360, "{checked}");
}
