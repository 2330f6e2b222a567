//! The command line as other programs see it: exit codes, stdout, stderr, JSON.

mod bake;
mod budget;
mod errata;
mod figures;
mod measure;
mod plot;
mod refusals;
mod report;
mod robustness;
mod scalars;
mod scratch;
mod state;
mod study;
mod sweep;
mod times;
mod tip_angle;
mod vectors;
mod view;

use scratch::{RELEASE, TOP, branch_points, folder, needle, sample, scenario, slender};
use serde_json::Value;
use std::process::{Command, Output};

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_toytop")).args(arguments).output().expect("the program runs")
}

fn stdout(output: &Output) -> &str {
    std::str::from_utf8(&output.stdout).expect("stdout is UTF-8")
}

fn stderr(output: &Output) -> &str {
    std::str::from_utf8(&output.stderr).expect("stderr is UTF-8")
}

/// What a command that must succeed prints, as JSON.
fn json(arguments: &[&str]) -> Value {
    let output = run(arguments);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {}", stderr(&output));
    serde_json::from_slice(&output.stdout).expect("stdout is JSON")
}

/// What `state` says of a scenario file at these times.
fn samples(file: &str, times: &str, more: &[&str]) -> Vec<Value> {
    let times = format!("--times={times}");
    let mut arguments = vec!["state", file, &times, "--format", "json"];
    arguments.extend(more);
    json(&arguments)["samples"].as_array().expect("samples").clone()
}

#[test]
fn constants_have_the_keys_of_the_contract() {
    let keys = [
        "l n h e1 e2 e3 e4 one_plus_e1 one_minus_e2 e2_minus_e1 e3_minus_e2 e3_minus_one regime period",
        "alpha_turns beta_turns phi_per_period tip_class min_normal_force",
    ];
    let keys: Vec<_> = keys.iter().flat_map(|line| line.split(' ')).collect();
    // file, regime, tip class, keys that are null
    let hanging = RELEASE.replace("40", "180").replace("precession = 0.3", "");
    let rest = ["period", "alpha_turns", "beta_turns", "phi_per_period"];
    let cases: [(String, &str, &str, &[&str]); 9] = [
        (sample("toy_top"), "nutating", "cusp", &[]),
        (sample("figure_3_cusp"), "nutating", "cusp", &[]),
        (sample("lagrange"), "nutating", "loops", &["e4", "min_normal_force"]),
        (sample("sleeping"), "sleeping_stable", "point", &["phi_per_period"]),
        (scenario("c1", &format!("{TOP}{hanging}")), "hanging", "point", &["phi_per_period"]),
        (scenario("c2", &branch_points([0.2, 1.0, 1.0], 1)), "aperiodic", "spiral", &rest),
        (scenario("c3", &branch_points([0.5, 0.5, 1.7], -1)), "regular_precession", "circle", &[]),
        (scenario("c4", &branch_points([-1.0, 0.6, 1.4], 1)), "nutating", "through_origin", &[]),
        (
            scenario("c5", &(branch_points([0.2, 1.0, 1.0], 1) + "nutation_phase = 3.141592653589793")),
            "sleeping_unstable",
            "point",
            &rest,
        ),
    ];
    for (file, regime, tip_class, nulls) in cases {
        let output = run(&["constants", &file, "--format", "json"]);
        let constants: Value = serde_json::from_slice(&output.stdout).expect("JSON");
        let object = constants.as_object().expect("an object");
        assert_eq!(object.len(), keys.len(), "{file}");
        // serde_json sorts what it parses: the order is checked in the text
        let places: Vec<_> = keys.iter().map(|key| stdout(&output).find(&format!("\"{key}\":"))).collect();
        assert!(places.iter().all(Option::is_some) && places.is_sorted(), "{file}: {places:?}");
        assert_eq!(constants["regime"], regime, "{file}");
        assert_eq!(constants["tip_class"], tip_class, "{file}");
        for key in &keys {
            assert_eq!(constants[key].is_null(), nulls.contains(key), "{file}: {key}");
        }
        let csv = run(&["constants", &file, "--format", "csv"]);
        let lines: Vec<_> = stdout(&csv).lines().collect();
        let [header, values] = lines[..] else { panic!("{file}: {lines:?}") };
        assert_eq!(header, keys.join(","), "{file}");
        for (key, value) in keys.iter().zip(values.split(',')) {
            let same = match &constants[key] {
                Value::Number(x) => x.as_f64() == value.parse().ok(),
                other => other.as_str().unwrap_or_default() == value,
            };
            assert!(same, "{file}: {key}: {value}");
        }
        let table = run(&["constants", &file]);
        assert!(keys.iter().zip(stdout(&table).lines()).all(|(key, line)| line.starts_with(key)), "{file}");
    }
}

#[test]
fn numbers_have_seventeen_digits() {
    let file = sample("figure_3_cusp");
    assert!(
        stdout(&run(&["constants", &file, "--format", "json"])).contains("\"e1\":6.9999999999999996e-1,")
    );
    let csv = run(&["state", &file, "--times=0,1", "--format", "csv"]);
    let lines: Vec<_> = stdout(&csv).lines().map(|line| line.split(',').count()).collect();
    assert_eq!(lines, [17, 17, 17]);
    assert!(stdout(&csv).lines().skip(1).flat_map(|line| line.split(',')).all(|number| {
        number.trim_start_matches('-').split('e').next().is_some_and(|mantissa| mantissa.len() == 18)
    }));
}

#[test]
fn compare_holds_its_bounds() {
    let rows = json(&["compare", "--format", "json"]);
    let rows = rows["rows"].as_array().expect("rows");
    assert_eq!(rows.len(), 14 * 9);
    let (found, absent): (Vec<_>, Vec<_>) = rows.iter().partition(|row| row["verdict"] != "no fit");
    let [absent] = absent[..] else { panic!("{absent:?}") };
    assert!(absent["motion"] == "near separatrix 1e-6" && absent["scalar"] == "q31", "{absent}");
    for row in found {
        let error = row["max_orientation_error_rad"].as_f64().expect("a number");
        let unbounded = row["scalar"] == "micromath" && row["method"] == "stepper";
        assert_eq!(row["verdict"], if unbounded { "no bound" } else { "ok" }, "{row}");
        assert!(error > 0.0 && error <= row["bound_rad"].as_f64().expect("a number"), "{row}");
        // the derivatives of fixed point are in f32
        let drift_limit = match row["scalar"].as_str().expect("a name") {
            "f64" => 1e-14,
            "f32" | "q31" => 3e-6,
            "q15" => 3e-3,
            _ => 0.1,
        };
        let [by_steps, by_table] = ["steps", "table"].map(|key| !row[key].is_null());
        assert_eq!([by_steps, by_table], [row["method"] == "stepper", row["method"] == "ephemeris"], "{row}");
        if row["method"] == "ephemeris" && row["scalar"] == "f32" {
            assert!(row["bound_rad"].as_f64().is_some_and(|bound| bound < 5.11e-7), "{row}");
        }
        if row["scalar"] == "q31" {
            assert!(error < 3e-8 && error > 1e-9, "{row}");
        }
        for key in ["h_drift", "l_drift", "n_drift"] {
            assert!(row[key].as_f64().is_some_and(|drift| drift < drift_limit), "{key}: {row}");
        }
    }
    let table = run(&["compare", "--scalar", "f64"]);
    assert!(stdout(&table).lines().all(|line| line.chars().count() <= 120));
    assert_eq!(stdout(&table).matches(" ok\n").count(), 28);
    assert!(stdout(&table).contains("figure 2 e3=100 (-15.65"), "the warning is below the table");
}

#[test]
fn compare_reads_scenarios_and_tells_a_miss() {
    let all = json(&["compare", &sample("toy_top"), "--scalar", "all", "--periods", "2", "--format", "json"]);
    let names = |row: &Value| format!("{} {} {}", row["motion"], row["scalar"], row["method"]);
    let rows: Vec<_> = all["rows"].as_array().expect("rows").iter().map(names).collect();
    let expected = [
        "f64 stepper",
        "f32 stepper",
        "q31 stepper",
        "micromath stepper",
        "f64 ephemeris",
        "f32 ephemeris",
        "q31 ephemeris",
        "q15 ephemeris",
        "micromath ephemeris",
    ];
    assert_eq!(rows, expected.map(|row| format!("\"toy_top\" \"{}\"", row.replace(' ', "\" \""))));

    // A/(ps) = 1e-4 near the vertical is too steep for 4096 steps a period.
    let file = scenario("slender", &slender([-0.9, 0.99, 1.18], ["5.4e-5", "5e-5"]));
    let output = run(&["compare", &file, "--scalar", "f64,f32"]);
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(stdout(&output).matches(" MISS\n").count(), 2, "{}", stdout(&output));
    let of_the_ephemeris = |line: &&str| line.contains(" ephemeris ") && line.ends_with(" ok");
    assert_eq!(stdout(&output).lines().filter(of_the_ephemeris).count(), 2, "{}", stdout(&output));

    // at 1e-6 no table fits: said, not missed
    let output = run(&["compare", &needle("needle_compared"), "--scalar", "f32", "--periods", "1"]);
    assert!(stdout(&output).contains("needle_compared f32: no ephemeris"), "{}", stdout(&output));
    assert!(stdout(&output).lines().any(|line| line.contains(" ephemeris ") && line.ends_with(" no fit")));
}

#[test]
fn what_a_real_top_would_not_do_is_told_in_one_line() {
    let lifts = scenario("lift_off", &branch_points([0.7, 0.9, 100.0], 1));
    let falls = scenario("fall", &branch_points([-0.5, 0.9, 1.1], 1));
    warned(&lifts, "warning: a real top would leave the plane (least normal force / weight): lift_off (-");
    warned(&falls, "warning: a real top would fall on its side (greatest tilt, degrees): fall (120.0)");
    assert_eq!(stderr(&run(&["constants", &sample("toy_top"), "--format", "json"])), "");
    // what is held does not fall
    let held = std::fs::read_to_string(sample("lagrange")).expect("the sample");
    let held = scenario("hanging", &held.replace("tilt_deg = 20.0", "tilt_deg = 120.0"));
    assert_eq!(stderr(&run(&["constants", &held, "--format", "json"])), "");
}

fn warned(file: &str, warning: &str) {
    for (arguments, below) in [
        (vec!["constants", file], true),
        (vec!["constants", file, "--format", "json"], false),
        (vec!["state", file, "--times", "1"], true),
        (vec!["state", file, "--times", "1", "--format", "csv"], false),
        (vec!["compare", file, "--format", "csv"], false),
    ] {
        let output = run(&arguments);
        let (with, without) =
            if below { (stdout(&output), stderr(&output)) } else { (stderr(&output), stdout(&output)) };
        let warnings = |text: &str| text.lines().filter(|line| line.starts_with("warning: ")).count();
        assert_eq!((warnings(with), warnings(without)), (1, 0), "{arguments:?}");
        assert!(with.contains(warning), "{with}");
    }
}

#[test]
fn help_version_and_a_closed_pipe_are_no_failures() {
    for arguments in [vec!["--help"], vec!["--version"], vec!["state", "--help"]] {
        let output = run(&arguments);
        assert_eq!((output.status.code(), stderr(&output)), (Some(0), ""), "{arguments:?}");
        assert!(!output.stdout.is_empty());
    }
    let times = vec!["0.5"; 20_000].join(",");
    let program = env!("CARGO_BIN_EXE_toytop");
    let pipe = format!(
        "'{program}' state '{}' --times {times} --format csv | head -n 1; exit ${{PIPESTATUS[0]}}",
        sample("toy_top")
    );
    let output = Command::new("bash").args(["-c", &pipe]).output().expect("bash runs");
    assert_eq!((output.status.code(), stderr(&output)), (Some(0), ""));
    assert!(stdout(&output).starts_with("t,u,udot,"));
}

#[test]
fn every_command_has_help_with_an_example_and_completes() {
    let help = run(&["--help"]);
    let commands: Vec<_> = stdout(&help)
        .lines()
        .skip_while(|line| *line != "Commands:")
        .skip(1)
        .map_while(|line| line.strip_prefix("  ")?.split_whitespace().next())
        .filter(|name| *name != "help")
        .collect();
    assert!(commands.len() >= 10, "{commands:?}");
    let scripts = ["bash", "zsh", "fish"].map(|shell| stdout(&run(&["completions", shell])).to_owned());
    for command in commands {
        let help = run(&[command, "--help"]);
        assert!(stdout(&help).contains(&format!("Example: toytop {command} ")), "{command}");
        assert!(!stdout(&help).contains('\x1b'), "{command}: no colour, so none to switch off");
        assert!(scripts.iter().all(|script| script.contains(command)), "{command}");
    }
    assert!(scripts.iter().all(|script| script.contains("nutation") || script.contains("resume")));
}
