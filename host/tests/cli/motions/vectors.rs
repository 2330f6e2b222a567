//! Tests of `toytop state` against motions known to 30 digits, from the first period to 10^9 periods.

use crate::command::{list, numbers, read, repository, samples, scenario};
use serde_json::Value;

fn text<'a>(json: &'a Value, key: &str) -> &'a str {
    json[key].as_str().unwrap_or("0")
}

fn number(json: &Value) -> f64 {
    json.as_str().expect("a string").parse().expect("a number")
}

fn array(json: &Value) -> String {
    let entries: Vec<_> = list(json).iter().map(|entry| entry.as_str().expect("a string")).collect();
    format!("[{}]", entries.join(", "))
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
    if params.get("alpha0").is_some() {
        let [alpha, beta, omega] = ["alpha0", "beta0", "omega0"].map(|key| array(&params[key]));
        return format!("[motion]\nkind = \"state\"\nalpha = {alpha}\nbeta = {beta}\nomega = {omega}\n");
    }
    let [e1, e2, e3] = ["e1", "e2", "e3"].map(|key| text(vector, key));
    let [plus, minus] = ["s_plus", "s_minus"].map(|key| &vector[key]);
    let [theta, alpha, beta] = ["theta0", "arg_alpha0", "arg_beta0"].map(|key| text(params, key));
    format!(
        "[motion]\nkind = \"branch_points\"\ne1 = {e1}\ne2 = {e2}\ne3 = {e3}\nsign_l_plus_n = {plus}\n\
         sign_l_minus_n = {minus}\nnutation_phase = {theta}\narg_alpha = {alpha}\narg_beta = {beta}\n"
    )
}

/// Folder of the reference vectors.
const FOLDER: &str = "tests/reference/vectors";

fn vector(name: &str) -> Value {
    serde_json::from_str(&read(&repository(&format!("{FOLDER}/{name}.json")))).expect("JSON")
}

/// Scenario file of a vector, with a name of its own for each test.
pub(crate) fn scenario_of(name: &str, test: &str) -> String {
    let vector = vector(name);
    scenario(&format!("{test}_{name}"), &(top(&vector["params"]) + &motion(&vector)))
}

/// Orientations of the vectors whose inputs are exact in f64, so that the truth belongs to the numbers that are read.
#[test]
fn exact_inputs_at_any_distance() {
    let (mut compared, mut worst) = (0, 0.0_f64);
    for entry in std::fs::read_dir(repository(FOLDER)).expect("the vectors") {
        let file = entry.expect("a file").file_name();
        let name = file.to_str().and_then(|file| file.strip_suffix(".json")).expect("a name");
        let vector = vector(name);
        if vector["exact_in_f64"] != true {
            continue;
        }
        let truths = ["samples", "huge_samples"]
            .map(|key| vector[key].as_array().cloned().unwrap_or_default())
            .concat();
        let times: Vec<_> = truths.iter().map(|sample| text(sample, "t")).collect();
        let times = scenario(&format!("times_{name}"), &times.join("\n"));
        let found = samples(format!("{} --times-file {times}", scenario_of(name, "vector")));
        assert_eq!(found.len(), truths.len(), "{name}");
        for (found, truth) in found.iter().zip(&truths) {
            let parts = ["alpha", "beta"].map(|key| [0, 1].map(|i| number(&truth[key][i])));
            let parts = numbers(found, "alpha beta").into_iter().zip(parts.concat());
            let error = 2.0 * parts.map(|(x, y)| (x - y).powi(2)).sum::<f64>().sqrt();
            assert!(error.is_finite(), "{name} at {}", truth["t"]);
            worst = worst.max(error);
            compared += 1;
        }
    }
    assert!(compared > 200 && worst > 3e-16 && worst < 2e-15, "{compared} {worst:e}");
}
