//! Tests of `toytop benchmark` and `score --benchmark`.

use crate::program::{json, run, stderr, stdout};
use crate::scratch::file;
use serde_json::Value;
use std::path::Path;

fn names() -> Vec<String> {
    let list = json(&["benchmark", "--format", "json"]);
    let name = |problem: &Value| problem["benchmark"].as_str().expect("a name").to_owned();
    list["problems"].as_array().expect("problems").iter().map(name).collect()
}

/// Values of the top of Brüls and Cardona at 1 s, with 30 digits.
#[test]
fn the_heavy_top_of_bruls_and_cardona() {
    let answer = json(&["benchmark", "bruls_cardona", "--format", "json"]);
    let samples = answer["samples"].as_array().expect("samples");
    let at = |t: &str| samples.iter().find(|sample| sample["t"] == t).expect("a sample");
    assert_eq!(at("1")["z_com"], "-0.748490791133581309483597679122");
    assert_eq!(at("2")["z_com"], "-0.673022269560444096050221046988");
    let table = stdout(&run(&["benchmark", "bruls_cardona"])).to_owned();
    assert!(table.contains("-0.748490791133581309483597679122") && table.contains("EXUDYN"), "{table}");
}

/// The ephemeris of the scenario reaches the 30 digits of every problem, in the axes of the source.
#[test]
fn the_scenario_agrees_with_the_reference_digits() {
    for name in names() {
        let digits = json(&["benchmark", &name, "--format", "json"]);
        for sample in digits["samples"].as_array().expect("samples") {
            let t = sample["t"].as_str().expect("a time");
            let computed = json(&["benchmark", &name, &format!("--times={t}"), "--format", "json"]);
            let ours = &computed["samples"][0];
            let values = |keys: &[&str]| -> Vec<[f64; 2]> {
                let pair = |key: &&str| {
                    let truth = sample[*key].as_str().expect("digits").parse().expect("a number");
                    [truth, ours[*key].as_f64().expect("a number")]
                };
                keys.iter().map(pair).collect()
            };
            let length = values(&["x_com", "y_com", "z_com"]).iter().map(|[x, _]| x * x).sum::<f64>().sqrt();
            for [truth, ours] in values(&["x_com", "y_com", "z_com"]) {
                assert!((truth - ours).abs() < 2e-13 * length, "{name} at {t}: {truth} {ours}");
            }
            let quaternion = values(&["w", "x", "y", "z"]);
            let off = |sign: f64| {
                quaternion.iter().map(|[truth, ours]| (truth - sign * ours).abs()).fold(0.0, f64::max)
            };
            assert!(off(1.0).min(off(-1.0)) < 1e-12, "{name} at {t}: {:e}", off(1.0).min(off(-1.0)));
            for [truth, ours] in values(&["wx", "wy", "wz"]) {
                assert!((truth - ours).abs() < 1e-10, "{name} at {t}: {truth} {ours}");
            }
        }
    }
}

/// A run in the source's axes has no error, and one in other axes has a large error.
#[test]
fn a_run_is_judged_in_the_axes_of_its_source() {
    for name in names() {
        let rows = run(&["benchmark", &name, "--times=0..0.4/41", "--format", "csv"]);
        let exact = file(&format!("{name}.csv"), stdout(&rows));
        let score = json(&["score", "--benchmark", &name, &exact, "--format", "json"]);
        let run = &score["files"][0];
        assert!(run["max_error_rad"].as_f64().is_some_and(|error| error < 1e-11), "{name}: {run}");
        assert_eq!(score["scenario"], name.as_str());
    }
    // the rows of one problem are not a run of another
    let rows = run(&["benchmark", "parker", "--times=0..0.4/41", "--format", "csv"]);
    let other = file("parker_as_bruls.csv", stdout(&rows));
    let score = json(&["score", "--benchmark", "bruls_cardona", &other, "--format", "json"]);
    assert!(score["files"][0]["max_error_rad"].as_f64().is_some_and(|error| error > 0.1));
}

/// The printed scenario can be read, and has the motion of the problem.
#[test]
fn the_scenario_is_a_scenario() {
    for name in names() {
        let text = run(&["benchmark", &name, "--scenario"]);
        let scenario = file(&format!("{name}_printed.toml"), stdout(&text));
        assert_eq!(run(&["constants", &scenario]).status.code(), Some(0), "{name}");
    }
}

/// The pages contain the tables that the command writes.
#[test]
fn the_pages_are_up_to_date() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("benchmarks");
    let mut pages = vec![(Vec::new(), folder.join("README.md"))];
    pages.extend(names().into_iter().map(|name| (vec![name.clone()], folder.join(name).join("README.md"))));
    for (index, (name, page)) in pages.into_iter().enumerate() {
        let text = std::fs::read_to_string(&page).expect("a page");
        let copy = file(&format!("page_{index}.md"), &text);
        let arguments: Vec<_> = ["benchmark"]
            .into_iter()
            .chain(name.iter().map(String::as_str))
            .chain(["--page", &copy])
            .collect();
        assert_eq!(run(&arguments).status.code(), Some(0));
        let written = std::fs::read_to_string(&copy).expect("the copy");
        assert!(written == text, "{}: toytop {} writes it anew", page.display(), arguments.join(" "));
    }
}

#[test]
fn bad_input_is_one_line() {
    let rows = file("rows.csv", "t,w,x,y,z\n0,1,0,0,0\n");
    for (arguments, part) in [
        (&["benchmark", "nothing"][..], "benchmark: nothing: must be one of bruls_cardona"),
        (&["benchmark", "parker", "--times", "x"], "--times"),
        (&["benchmark", "parker", "--times", "1e300"], "must be within"),
        (&["benchmark", "--times", "1"], "NAME"),
        (&["benchmark", "--page", "no/such/page.md"], "no/such/page.md"),
        (&["benchmark", "--page", &rows], "must hold the lines"),
        (&["score", "--benchmark", "nothing", &rows], "--benchmark: nothing: must be one of"),
        (&["score", &rows], "RESULT.csv"),
    ] {
        let output = run(arguments);
        assert_eq!((output.status.code(), stdout(&output)), (Some(2), ""), "{arguments:?}");
        assert_eq!(stderr(&output).lines().count(), 1, "{}", stderr(&output));
        assert!(stderr(&output).contains(part), "{arguments:?}: {}", stderr(&output));
    }
}
