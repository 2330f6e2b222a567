//! Tests of the command line: exit codes, stdout, stderr, JSON.

mod animate;
mod bake;
mod bench;
mod benchmark;
mod budget;
mod constants;
mod errata;
mod events;
mod figures;
mod fit;
mod killed;
mod plot;
mod program;
mod refusals;
mod robustness;
mod samples;
mod scalars;
mod score;
mod scratch;
mod state;
mod sweep;
mod times;
mod tip_angle;
mod units;
mod vectors;
mod view;

use program::{folder, json, run, stderr, stdout};
use scratch::{RELEASE, TOP, branch_points, needle, sample, scenario, slender};
use serde_json::Value;
use std::process::Command;

const PROGRAM: &str = env!("CARGO_BIN_EXE_toytop");

/// Samples of `state` for a scenario file at these times.
pub(crate) fn samples(file: &str, times: &str, more: &[&str]) -> Vec<Value> {
    let times = format!("--times={times}");
    let mut arguments = vec!["state", file, &times, "--format", "json"];
    arguments.extend(more);
    json(&arguments)["samples"].as_array().expect("samples").clone()
}

#[test]
fn constants_have_the_keys_of_the_contract() {
    let keys = [
        "l n h e1 e2 e3 e4 one_plus_e1 one_minus_e2 e2_minus_e1 e3_minus_e2 e3_minus_one regime period",
        "alpha_turns beta_turns phi_per_period tip_class min_normal_force min_tilt_deg max_tilt_deg nutation_hz",
        "mean_precession_deg_per_s mean_precession_rpm spin_deg_per_s spin_rpm critical_spin_deg_per_s critical_spin_rpm",
    ];
    let keys: Vec<_> = keys.iter().flat_map(|line| line.split(' ')).collect();
    // file, regime, tip class, keys that are null
    let hanging = RELEASE.replace("40", "180").replace("precession = 0.3", "");
    let upright = ["phi_per_period", "mean_precession_deg_per_s", "mean_precession_rpm"];
    let rest = [&["period", "alpha_turns", "beta_turns", "nutation_hz"], &upright[..]].concat();
    let cases: [(String, &str, &str, &[&str]); 9] = [
        (sample("toy_top"), "nutating", "cusp", &[]),
        (sample("figure_3_cusp"), "nutating", "cusp", &[]),
        (sample("lagrange"), "nutating", "loops", &["e4", "min_normal_force"]),
        (sample("sleeping"), "sleeping_stable", "point", &upright),
        (scenario("c1", &format!("{TOP}{hanging}")), "hanging", "point", &upright),
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
        // serde_json sorts keys, so the order is checked in the text
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

/// The toy top is released at 20 degrees with 150 rad/s; the upright top is stable above 2 sqrt(A p g)/C.
#[test]
fn constants_in_degrees_and_turns() {
    let constants = json(&["constants", &sample("toy_top"), "--format", "json"]);
    let value = |key: &str| constants[key].as_f64().unwrap_or_else(|| panic!("{key}: {constants}"));
    let near = |key: &str, expected: f64| {
        let found = value(key);
        assert!((found / expected - 1.0).abs() < 1e-12, "{key}: {found} {expected}");
    };
    near("min_tilt_deg", 20.0);
    near("max_tilt_deg", value("e1").acos().to_degrees());
    near("nutation_hz", 1.0 / value("period"));
    near("mean_precession_deg_per_s", value("phi_per_period").to_degrees() / value("period"));
    near("mean_precession_rpm", value("mean_precession_deg_per_s") / 6.0);
    near("spin_deg_per_s", 150_f64.to_degrees());
    near("spin_rpm", 150.0 * 30.0 / std::f64::consts::PI);
    near("critical_spin_deg_per_s", (2.0 * (3e-5 * 0.0015 * 9.81_f64).sqrt() / 2e-5).to_degrees());
    near("critical_spin_rpm", value("critical_spin_deg_per_s") / 6.0);
    // spins on both sides of the critical one
    let text = std::fs::read_to_string(sample("sleeping")).expect("a scenario");
    let own = json(&["constants", &sample("sleeping"), "--format", "json"]);
    let critical = own["critical_spin_deg_per_s"].as_f64().expect("a number").to_radians();
    let line = text.lines().find(|line| line.starts_with("spin")).expect("a spin");
    for (factor, regime) in [(1.001, "sleeping_stable"), (0.999, "sleeping_unstable")] {
        let spun = scenario("critical", &text.replace(line, &format!("spin = {}", factor * critical)));
        assert_eq!(json(&["constants", &spun, "--format", "json"])["regime"], regime);
    }
}

/// A scenario without units prints none.
#[test]
fn units_are_named_only_where_there_are_any() {
    let text = std::fs::read_to_string(sample("toy_top")).expect("a scenario");
    let none = scenario("no_units", &format!("units = \"none\"\n{text}"));
    let si = scenario("si_units", &format!("units = \"SI\"\n{text}"));
    for command in
        [&["constants"][..], &["state", "--times=0,1"], &["state", "--times=0", "--units", "--format", "csv"]]
    {
        let [named, bare] = [&si, &none].map(|file| {
            let output = run(&[command, &[file]].concat());
            stdout(&output).to_owned()
        });
        let unit = |text: &str| {
            let words = text.split(|c: char| c.is_whitespace() || "[],^2/".contains(c));
            words.filter(|word| ["kg", "m", "s"].contains(word)).count()
        };
        assert!(unit(&named) > 1 && unit(&bare) == 0, "{command:?}: {named} {bare}");
    }
    let wrong = scenario("wrong_units", &format!("units = \"feet\"\n{text}"));
    let refused = run(&["constants", &wrong]);
    assert!(stderr(&refused).contains("units: must be one of \"SI\", \"none\""), "{}", stderr(&refused));
}

/// Values satisfy their definitions, such as e4² - 1 = A/(ps).
#[test]
fn constants_are_what_their_keys_say() {
    let constants =
        json(&["constants", &scenario("e4", &branch_points([0.2, 0.7, 1.6], 1)), "--format", "json"]);
    let e4 = constants["e4"].as_f64().expect("a number");
    let spread = 1.1 / (0.9 * 0.6);
    assert!((e4 * e4 - 1.0 - spread).abs() < 1e-15 * spread, "{e4}");
    // the sum of the turns of alpha and beta cancels to a share of 1e-8, the advance of the tip angle does not
    let e2 = 0.5 + 13.0 * f64::EPSILON;
    let fast = branch_points([0.5, e2, 1e8], -1);
    let unit = ["mass_moment = 0.9", "com_height = 0.6", "inertia = 1.1", "inertia = 0.8"];
    let fast = unit.iter().fold(fast, |text, line| {
        let (key, _) = line.split_once(" = ").expect("a key");
        text.replace(line, &format!("{key} = 1"))
    });
    let constants = json(&["constants", &scenario("fast", &fast), "--format", "json"]);
    let phi = constants["phi_per_period"].as_f64().expect("a number");
    assert!((phi / 4.1559364514228804e-8 - 1.0).abs() <= f64::EPSILON, "{phi:e}");
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
    assert_eq!(rows.len(), 18 * 8);
    for row in rows {
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
        // a pendulum has no spin, so that all its energy is in the motion of the axis, which is fast at the lowest point
        let drift_limit = if row["motion"] == "pendulum" { 5.0 * drift_limit } else { drift_limit };
        let [by_steps, by_table] = ["steps", "table"].map(|key| !row[key].is_null());
        assert_eq!([by_steps, by_table], [row["method"] == "stepper", row["method"] == "ephemeris"], "{row}");
        if row["method"] == "ephemeris" && row["scalar"] == "f32" {
            assert!(row["bound_rad"].as_f64().is_some_and(|bound| bound < 5.11e-7), "{row}");
        }
        if row["scalar"] == "q31" {
            assert!(error < 3e-8 && error > 1e-9, "{row}");
        }
        for key in ["h_drift", "l_drift", "n_drift"] {
            assert!(row[key].as_f64().is_some_and(|drift| drift < drift_limit || unbounded), "{key}: {row}");
        }
    }
    let table = run(&["compare", "--all", "--scalar", "f64"]);
    assert!(stdout(&table).lines().all(|line| line.chars().count() <= 120));
    assert_eq!(stdout(&table).matches(" ok\n").count(), 36);
    assert!(stdout(&table).contains("figure 2 e3=100 (-15.65"), "the warning is below the table");
    let table = run(&["compare", &sample("toy_top"), "--scalar", "micromath"]);
    let lines: Vec<_> =
        stdout(&table).lines().map(|line| line.split_whitespace().collect::<Vec<_>>()).collect();
    assert_eq!(lines[0][lines[0].len() - 2..], ["bound", "result"], "{lines:?}");
    assert!(lines[1][2] == "stepper" && lines[1].ends_with(&["-", "no", "bound"]), "{lines:?}");
    assert!(lines[2][2] == "ephemeris" && lines[2].ends_with(&["1e-2", "ok"]), "{lines:?}");
}

/// Without arguments there is one row for each motion, and the output fits one screen.
#[test]
fn compare_fits_one_screen() {
    let output = run(&["compare"]);
    let text = stdout(&output);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert!(text.lines().count() <= 24 && text.lines().all(|line| line.chars().count() <= 100), "{text}");
    assert_eq!(text.matches(" ok\n").count(), 18, "{text}");
    let header: Vec<_> = text.lines().next().expect("a header").split_whitespace().collect();
    assert_eq!(header, ["motion", "f64", "f32", "q31", "q15", "micromath", "ns", "result"]);
    let row = text.lines().find(|line| line.starts_with("figure 2 e3=100")).expect("a row");
    let cells: Vec<_> = row.split_whitespace().rev().skip(2).take(5).collect();
    for cell in cells {
        let [error, bound] = cell.split('/').map(|x| x.parse::<f64>().expect(cell)).collect::<Vec<_>>()[..]
        else {
            panic!("{cell}")
        };
        assert!(error <= bound && error > 0.0, "{cell}");
    }
    assert!(text.contains("--all"), "{text}");
}

#[test]
fn compare_reads_scenarios_and_reports_a_missed_bound() {
    let all = json(&["compare", &sample("toy_top"), "--scalar", "all", "--periods", "2", "--format", "json"]);
    let names = |row: &Value| format!("{} {} {}", row["motion"], row["scalar"], row["method"]);
    let rows: Vec<_> = all["rows"].as_array().expect("rows").iter().map(names).collect();
    let expected = [
        "f64 stepper",
        "f32 stepper",
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

    // at 1e-6 no table is large enough, which is stated and no missed bound
    let output = run(&["compare", &needle("needle_compared"), "--scalar", "f32", "--periods", "1"]);
    assert!(stdout(&output).contains("needle_compared f32: no ephemeris"), "{}", stdout(&output));
    assert!(stdout(&output).lines().any(|line| line.contains(" ephemeris ") && line.ends_with(" no fit")));
}

#[test]
fn each_warning_about_real_tops_is_one_line() {
    let lifts = scenario("lift_off", &branch_points([0.7, 0.9, 100.0], 1));
    let falls = scenario("fall", &branch_points([-0.5, 0.9, 1.1], 1));
    warned(&lifts, "warning: a real top would leave the plane (least normal force / weight): lift_off (-");
    warned(&falls, "warning: a real top would fall on its side (greatest tilt, degrees): fall (120.0)");
    assert_eq!(stderr(&run(&["constants", &sample("toy_top"), "--format", "json"])), "");
    // a force just below 0 gives a warning, with any number of digits; one just above gives none
    let mild = scenario("mild", &branch_points([0.5, 0.8, 10.4], 1));
    warned(&mild, "warning: a real top would leave the plane (least normal force / weight): mild (-0.201)");
    for (name, e3, warning) in [("just_on", 8.790_123, ""), ("just_off", 8.790_124_5, "just_off (-1.3e-7)")] {
        let file = scenario(name, &branch_points([0.5, 0.8, e3], 1));
        let warned = run(&["constants", &file, "--format", "json"]);
        assert!(stderr(&warned).contains(warning), "{}", stderr(&warned));
        assert_eq!(stderr(&warned).is_empty(), warning.is_empty(), "{name}: {}", stderr(&warned));
    }
    let unit =
        "[top]\nmass_moment = 1\ncom_height = 1\ntransverse_inertia = 1\naxial_inertia = 1\ngravity = 1\n";
    let release = "[motion]\nkind = \"release\"\ntilt_deg = 0\nspin = 5\nnutation = 1\n";
    let zero = scenario("zero", &format!("{unit}{release}"));
    let output = run(&["constants", &zero, "--format", "json"]);
    let constants: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!((constants["min_normal_force"].as_f64(), stderr(&output)), (Some(0.0), ""));
    // an unstable sleeping top stays upright, although its e1 is below 0
    let still = RELEASE.replace("40", "0").replace("3.5", "0.5").replace("precession = 0.3", "");
    let asleep = scenario("unstable", &format!("{TOP}{still}"));
    let unstable = "warning: by the equations the axis stays upright, but the motion is unstable (a real top would fall): unstable\n";
    warned(&asleep, unstable);
    // a held top does not fall
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
    let pipe = format!(
        "'{PROGRAM}' state '{}' --times {times} --format csv | head -n 1; exit ${{PIPESTATUS[0]}}",
        sample("toy_top")
    );
    let output = Command::new("bash").args(["-c", &pipe]).output().expect("bash runs");
    assert_eq!((output.status.code(), stderr(&output)), (Some(0), ""));
    assert!(stdout(&output).starts_with("t,u,udot,"));
}

#[test]
fn every_command_has_help_with_an_example_and_completes() {
    let help = run(&["--help"]);
    assert!(stdout(&help).lines().count() <= 24, "one screen: {}", stdout(&help));
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
