//! Tests of `toytop state` against motions known to 30 digits, from the first period to 10^9 periods.

use super::{json, scenario};
use serde_json::Value;
use std::path::Path;

/// Reference vector as a scenario file, with its samples.
struct Vector {
    name: String,
    /// Whether the inputs are exact in f64, so that the truth belongs to the numbers that are read.
    exact: bool,
    /// Difference e3 - e2, by whose inverse the rounding of inexact inputs is amplified.
    gap: f64,
    scenario: String,
    /// Number of periods (0 for the first ones) and sample.
    samples: Vec<(u64, Value)>,
}

fn text<'a>(json: &'a Value, key: &str) -> &'a str {
    json[key].as_str().unwrap_or("0")
}

fn number(json: &Value) -> f64 {
    json.as_str().expect("a string").parse().expect("a number")
}

fn list(json: &Value) -> String {
    let entries = json.as_array().expect("an array").iter();
    format!("[{}]", entries.map(|entry| entry.as_str().expect("a string")).collect::<Vec<_>>().join(", "))
}

fn top(params: &Value) -> String {
    let height = match text(params, "s") {
        "0" | "0.0" => "support = \"fixed\"".to_owned(),
        s => format!("com_height = {s}"),
    };
    let [a, c, p] = ["A", "C", "p"].map(|key| text(params, key));
    format!(
        "[top]\ntransverse_inertia = {a}\naxial_inertia = {c}\nmass_moment = {p}\n{height}\ngravity = 1\n"
    )
}

fn motion(vector: &Value) -> String {
    let params = &vector["params"];
    if !text(params, "defined_by").starts_with("e1,e2,e3") {
        let given = params.get("alpha0").is_some();
        let (place, keys) = if given {
            (params, ["alpha0", "beta0", "omega0"])
        } else {
            (&vector["initial"], ["alpha", "beta", "omega_fixed"])
        };
        let [alpha, beta, omega] = keys.map(|key| list(&place[key]));
        return format!("[motion]\nkind = \"state\"\nalpha = {alpha}\nbeta = {beta}\nomega = {omega}\n");
    }
    let [e1, e2, e3] = ["e1", "e2", "e3"].map(|key| text(vector, key));
    let [plus, minus] = ["s_plus", "s_minus"].map(|key| &vector[key]);
    let [theta, alpha, beta] = ["theta0", "arg_alpha0", "arg_beta0"].map(|key| match text(params, key) {
        "pi" => "3.141592653589793",
        "pi/2" => "1.5707963267948966",
        digits => digits,
    });
    format!(
        "[motion]\nkind = \"branch_points\"\ne1 = {e1}\ne2 = {e2}\ne3 = {e3}\nsign_l_plus_n = {plus}\n\
         sign_l_minus_n = {minus}\nnutation_phase = {theta}\narg_alpha = {alpha}\narg_beta = {beta}\n"
    )
}

/// Scenario file of a vector, with a name of its own for each test.
pub(super) fn scenario_of(name: &str, test: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../tests/reference/vectors/{name}.json"));
    let vector: Value =
        serde_json::from_str(&std::fs::read_to_string(path).expect("readable")).expect("JSON");
    scenario(&format!("{test}_{name}"), &(top(&vector["params"]) + &motion(&vector)))
}

fn vectors() -> Vec<Vector> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/reference/vectors");
    let mut paths: Vec<_> =
        std::fs::read_dir(folder).expect("the vectors").map(|entry| entry.expect("a file").path()).collect();
    paths.sort();
    let read = |path: &std::path::PathBuf| {
        let vector: Value =
            serde_json::from_str(&std::fs::read_to_string(path).expect("readable")).expect("JSON");
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let entries = |key: &str| vector[key].as_array().cloned().unwrap_or_default();
        let huge = entries("huge_samples").into_iter().map(|sample| {
            (sample["period_count"].as_str().expect("a count").parse().expect("a whole number"), sample)
        });
        Vector {
            exact: vector["exact_in_f64"] == true,
            gap: number(&vector["e3"]) - number(&vector["e2"]),
            scenario: scenario(&format!("vector_{name}"), &(top(&vector["params"]) + &motion(&vector))),
            samples: entries("samples").into_iter().map(|sample| (0, sample)).chain(huge).collect(),
            name,
        }
    };
    paths.iter().map(read).collect()
}

/// Output of `state` at the times of a vector's samples.
fn found(vector: &Vector, scalar: &str) -> Vec<Value> {
    let times: Vec<_> = vector.samples.iter().map(|(_, sample)| text(sample, "t")).collect();
    let file = scenario(&format!("times_{scalar}_{}", vector.name), &times.join("\n"));
    let arguments =
        ["state", &vector.scenario, "--times-file", &file, "--scalar", scalar, "--format", "json"];
    json(&arguments)["samples"].as_array().expect("samples").clone()
}

/// Error of the orientation, and error of the tip angle minus the rounding of a number of its size.
///
/// * `near_centre`: |αβ| below which the scalar does not determine on which side of the centre the tip passes
fn errors(found: &Value, truth: &Value, near_centre: f64) -> [f64; 2] {
    let part =
        |key: &str, i: usize| (found[key][i].as_f64().expect("a number") - number(&truth[key][i])).powi(2);
    let orientation =
        2.0 * ["alpha", "beta"].map(|key| part(key, 0) + part(key, 1)).iter().sum::<f64>().sqrt();
    let (phi, true_phi) = (found["phi"].as_f64(), truth["phi"].as_str());
    let angle = phi.zip(true_phi).map(|(phi, truth)| {
        let truth: f64 = truth.parse().expect("a number");
        (phi - truth).abs() - 2.0 * f64::EPSILON * truth.abs()
    });
    let product = ["alpha", "beta"].map(|key| number(&truth[key][0]).hypot(number(&truth[key][1])));
    [orientation, angle.filter(|_| product[0] * product[1] >= near_centre).unwrap_or(0.0)]
}

/// Greatest errors up to 10, 10^3, 10^6 and 10^9 periods.
fn greatest(vector: &Vector, scalar: &str) -> [[f64; 2]; 4] {
    // 64 roundings
    let near_centre = if scalar == "q15" { 64.0 / 32768.0 } else { 0.0 };
    let mut greatest = [[0.0_f64; 2]; 4];
    for ((periods, truth), found) in vector.samples.iter().zip(found(vector, scalar)) {
        let decade =
            [10, 10_000, 10_000_000, u64::MAX].iter().position(|limit| periods < limit).expect("a decade");
        for (greatest, error) in greatest[decade].iter_mut().zip(errors(&found, truth, near_centre)) {
            *greatest = greatest.max(error);
        }
    }
    greatest
}

/// For inputs exact in f64, orientation and tip angle have errors of a few roundings of f64, or f32, at any time.
#[test]
fn exact_inputs_at_any_distance() {
    for (scalar, orientation_bound, angle_bound) in BOUNDS {
        let mut worst = [0.0_f64; 2];
        for vector in vectors().iter().filter(|vector| vector.exact) {
            for (decade, errors) in greatest(vector, scalar).iter().enumerate() {
                let [orientation, angle] = *errors;
                assert!(
                    orientation <= orientation_bound,
                    "{scalar} {}, {decade}: {orientation:e}",
                    vector.name
                );
                // the turns are counted by integers that are the same in all scalars
                assert!(angle <= angle_bound, "{scalar} {}, {decade}: phi {angle:e}", vector.name);
                worst = [worst[0].max(orientation), worst[1].max(angle)];
            }
        }
        assert!(worst[0] > 1e-3 * orientation_bound && worst[1] > 0.0, "{worst:?}");
    }
}

/// Bounds on the errors of the orientation and of φ, rad, for each scalar.
const BOUNDS: [(&str, f64, f64); 5] = [
    // aperiodic motions end at the vertical, where an error of 1e-16 rad in β is one of 1e-16/|β| in the tip angle
    ("f64", 1e-13, 2e-12),
    ("f32", 5e-7, 1e-5),
    ("q31", 1.2e-8, 1e-6),
    ("q15", 4e-4, 1e-1),
    ("micromath", 4e-3, 1e-1),
];

/// For decimal inputs the error is that of their rounding to f64, by the conditioning of the motion; the branch of φ is right for all.
#[test]
fn every_motion_over_its_first_periods() {
    for vector in vectors().iter().filter(|vector| !vector.exact) {
        let bound = if vector.gap > 0.0 && vector.gap < 1e-5 { 1e-8 } else { 1e-11 };
        let [[orientation, angle], rest @ ..] = greatest(vector, "f64");
        assert!(orientation < bound && angle < bound, "{}: {orientation:e}, phi {angle:e}", vector.name);
        for [_, angle] in rest {
            assert!(angle < 1.0, "{}: phi {angle:e}", vector.name);
        }
    }
}
