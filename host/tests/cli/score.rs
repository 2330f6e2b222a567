//! Tests of `toytop score`: trajectories with known errors, and integrators with a known order.

mod integrators;

use super::{folder, json, run, sample, scenario, stderr, stdout};
use serde_json::Value;
use std::f64::consts::PI;
use std::path::{Path, PathBuf};

/// Scores of these files, as JSON.
fn score(scenario: &str, files: &[PathBuf], more: &[&str]) -> Value {
    let mut arguments = vec!["score", scenario];
    arguments.extend(files.iter().map(|file| file.to_str().expect("UTF-8")));
    arguments.extend(more);
    arguments.extend(["--format", "json"]);
    json(&arguments)
}

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("{key} is no number in {value}"))
}

/// Sample of `toytop state`: time, quaternion, ω in the fixed frame.
type Sample = (f64, [f64; 4], [f64; 3]);

fn samples(scenario: &str, times: &[f64]) -> Vec<Sample> {
    let times: Vec<_> = times.iter().map(f64::to_string).collect();
    let list = |value: &Value| -> Vec<f64> {
        value.as_array().expect("an array").iter().map(|x| x.as_f64().expect("a number")).collect()
    };
    let sample = |value: &Value| {
        let [a, b, omega] = ["alpha", "beta", "omega"].map(|key| list(&value[key]));
        let quaternion = [a[0], b[1], -b[0], a[1]];
        (value["t"].as_f64().expect("a number"), quaternion, omega.try_into().expect("three"))
    };
    super::samples(scenario, &times.join(","), &[]).iter().map(sample).collect()
}

/// Writes rows; without ω if `rates` is not set.
fn write(to: &Path, rows: &[Sample], rates: bool) {
    let mut text = "t,w,x,y,z".to_owned() + if rates { ",omega_x,omega_y,omega_z\n" } else { "\n" };
    for (t, q, omega) in rows {
        let numbers = std::iter::once(t).chain(q).chain(omega.iter().filter(|_| rates));
        text += &(numbers.map(f64::to_string).collect::<Vec<_>>().join(",") + "\n");
    }
    std::fs::write(to, text).expect("the file is written");
}

fn evenly(end: f64, places: u32) -> Vec<f64> {
    (0..places).map(|i| end * f64::from(i) / f64::from(places - 1)).collect()
}

#[test]
fn exact_rows_have_no_error_whatever_their_signs() {
    let (file, folder) = (sample("toy_top"), folder("score_exact"));
    let mut rows = samples(&file, &evenly(1.0, 201));
    for (_, q, _) in rows.iter_mut().step_by(3) {
        *q = q.map(|x| -x);
    }
    let to = folder.join("exact.csv");
    write(&to, &rows, false);
    let found = score(&file, std::slice::from_ref(&to), &[]);
    assert_eq!((&found["order"], &found["sign"]), (&Value::Null, &Value::from("nearest")));
    let scored = &found["files"][0];
    assert_eq!((&scored["rows"], &scored["step_from"]), (&Value::from(201), &Value::from("rows")));
    assert!((number(scored, "step") - 0.005).abs() < 1e-15);
    for key in ["max_error_rad", "rms_error_rad", "final_error_rad", "max_u_error", "residual_rad"] {
        assert!(number(scored, key) < 1e-15, "{key}: {scored}");
    }
    let bound = number(scored, "truth_bound_rad");
    assert!(bound > 1e-16 && bound < 1e-13);
    assert!(number(scored, "drift_h") < 1e-13 && scored["drift_from"] == "differences", "{scored}");
    let table = run(&["score", &file, to.to_str().expect("UTF-8")]);
    assert!(
        stdout(&table).contains("exact.csv") && stdout(&table).lines().count() < 20,
        "{}",
        stdout(&table)
    );
}

/// A motion that is delayed by τ has known phase errors and no other error.
#[test]
fn a_delay_is_three_phase_errors() {
    let (file, folder) = (sample("figure_3_loops"), folder("score_delay"));
    let constants = json(&["constants", &file, "--format", "json"]);
    let [period, a, b] = ["period", "alpha_turns", "beta_turns"].map(|key| number(&constants, key));
    let times = evenly(6.0 * period, 301);
    // a constant delay, and a delay that grows to more than a nutation period
    for (index, delay) in [|_: f64| 1e-6, |t: f64| 0.21 * t].into_iter().enumerate() {
        let late: Vec<_> = times.iter().map(|t| t - delay(*t)).collect();
        let mut rows = samples(&file, &late);
        rows.iter_mut().zip(&times).for_each(|(row, t)| row.0 = *t);
        let to = folder.join(format!("{index}.csv"));
        write(&to, &rows, false);
        let found = score(&file, &[to], &[]);
        let scored = &found["files"][0];
        // mean delay over the last period
        let mean = delay(5.5 * period);
        for (key, turns) in
            [("nutation_error_rad", 1.0), ("precession_error_rad", a + b), ("spin_error_rad", a - b)]
        {
            let expected = -2.0 * PI * turns * mean / period;
            let tolerance = if index == 0 { 2e-8 } else { 0.05 };
            let found = number(scored, key);
            assert!((found / expected - 1.0).abs() < tolerance, "{key}: {found} {expected}");
        }
        let residual = number(scored, "residual_rad");
        assert!(if index == 0 { residual < 1e-14 } else { residual < 1.0 && residual > 0.01 }, "{residual}");
    }
}

/// A motion that is turned about the vertical has only a precession error.
#[test]
fn a_turn_about_the_vertical_is_precession() {
    let (file, folder) = (sample("lagrange"), folder("score_turned"));
    let angle = 1e-5_f64;
    let (sin, cos) = (0.5 * angle).sin_cos();
    let mut rows = samples(&file, &evenly(1.0, 401));
    for (_, [w, x, y, z], _) in &mut rows {
        [*w, *x, *y, *z] =
            [cos * *w - sin * *z, cos * *x - sin * *y, cos * *y + sin * *x, cos * *z + sin * *w];
    }
    let to = folder.join("turned.csv");
    write(&to, &rows, false);
    let found = score(&file, &[to], &[]);
    let scored = &found["files"][0];
    assert!((number(scored, "precession_error_rad") / angle - 1.0).abs() < 1e-9, "{scored}");
    assert!((number(scored, "max_error_rad") / angle - 1.0).abs() < 1e-9, "{scored}");
    for key in ["nutation_error_rad", "spin_error_rad", "residual_rad", "max_u_error"] {
        assert!(number(scored, key).abs() < 1e-13, "{key}: {scored}");
    }
}

/// For a top that spins faster by a millionth, the drift of n is a millionth, with and without given ω.
#[test]
fn drift_of_n_by_columns_and_by_differences() {
    let (file, folder) = (sample("toy_top"), folder("score_drift"));
    let text = std::fs::read_to_string(&file).expect("a scenario");
    let faster = scenario("score_faster", &text.replace("spin = 150.0", "spin = 150.00015"));
    let [own, other] = [&file, &faster].map(|file| json(&["constants", file, "--format", "json"]));
    let rows = samples(&faster, &evenly(0.5, 1001));
    for (name, rates) in [("columns", true), ("differences", false)] {
        let to = folder.join(format!("{name}.csv"));
        write(&to, &rows, rates);
        let found = score(&file, &[to], &[]);
        let scored = &found["files"][0];
        assert_eq!(scored["drift_from"], name);
        for key in ["l", "n"] {
            // n is the greatest of the three scales
            let expected = (number(&other, key) - number(&own, key)).abs() / number(&own, "n");
            let drift = number(scored, &format!("drift_{key}"));
            assert!((drift / expected - 1.0).abs() < 1e-5, "{name}: {key}: {drift} {expected}");
        }
        let uncertainty = scored["drift_uncertainty"].as_f64();
        assert_eq!(uncertainty.is_some(), !rates);
        assert!(uncertainty.is_none_or(|x| x < 1e-10), "{scored}");
    }
    let to = folder.join("short.csv");
    write(&to, &rows[..6], false);
    let found = score(&file, &[to], &[]);
    assert_eq!(
        (&found["files"][0]["drift_h"], &found["files"][0]["residual_rad"]),
        (&Value::Null, &Value::Null)
    );
}

/// `toytop score` reads the output of `toytop state`, and finds that the stepper is of fourth order.
#[test]
fn the_steppers_order_is_measured() {
    let (file, folder) = (sample("figure_3_loops"), folder("score_stepper"));
    let period = number(&json(&["constants", &file, "--format", "json"]), "period");
    let times = format!("--times=0..{}/161", 5.0 * period);
    let (mut files, mut steps) = (Vec::new(), Vec::new());
    for per_period in [64_u32, 128, 256, 512] {
        let count = per_period.to_string();
        let output = run(&[
            "state",
            &file,
            &times,
            "--method",
            "stepper",
            "--steps-per-period",
            &count,
            "--format",
            "csv",
        ]);
        files.push(folder.join(format!("{count}.csv")));
        std::fs::write(&files[files.len() - 1], stdout(&output)).expect("the file is written");
        steps.push((period / f64::from(per_period)).to_string());
    }
    let picture = folder.join("work.svg");
    let steps = format!("--steps={}", steps.join(","));
    let found = score(&file, &files, &[&steps, "--plot", picture.to_str().expect("UTF-8")]);
    let order = number(&found, "order");
    assert!(order > 3.9 && order < 4.1, "{order}");
    assert_eq!(found["methods"][0]["files"], 4);
    assert_eq!(found["files"][3]["step_from"], "option");
    let svg = std::fs::read_to_string(&picture).expect("the picture");
    assert!(svg.contains("steps in a nutation period") && svg.contains("measured order"), "{svg}");
    // from 64 to 512 steps
    assert!([">50<", ">200<", ">1000<"].iter().all(|tick| svg.contains(tick)), "ticks between powers of ten");
    let (before, _) = svg.split_once(">measured order").expect("the name of the line");
    let (_, tag) = before.rsplit_once("<text ").expect("its element");
    let x: f64 = tag.split('"').nth(1).expect("a place").parse().expect("pixels");
    assert!(x + 150.0 < 896.0, "the name is inside the frame: {tag}");
}

/// Runs of the stepper with 64, 128 and 256 steps in a period, whose steps are 1/1024 s and so on.
fn runs_of_the_stepper(folder: &Path) -> [PathBuf; 3] {
    ["64", "128", "256"].map(|count| {
        let more = ["--method", "stepper", "--steps-per-period", count, "--format", "csv"];
        let file = sample("figure_3_loops");
        let output = run(&[&["state", &file, "--times=0..20/101"], &more[..]].concat());
        let to = folder.join(format!("h_{count}.csv"));
        let step = 0.064 / count.parse::<f64>().expect("a number");
        std::fs::write(&to, format!("# step = {step}\n{}", stdout(&output))).expect("the file is written");
        to
    })
}

/// Names and orders of the first table, in its order.
fn orders_of(table: &str) -> Vec<(String, String)> {
    let rows = table.lines().skip(2).take_while(|line| !line.is_empty());
    let ends = |line: &str| {
        let words: Vec<_> = line.split_whitespace().collect();
        let name = Path::new(words[0]).file_name().expect("a file").to_str().expect("UTF-8").to_owned();
        (name, words[words.len() - 1].to_owned())
    };
    rows.map(ends).collect()
}

#[test]
fn rows_are_sorted_from_the_largest_step() {
    let (file, folder) = (sample("figure_3_loops"), folder("score_sorted"));
    let [coarse, middle, fine] =
        runs_of_the_stepper(&folder).map(|path| path.to_str().expect("UTF-8").to_owned());
    let output = run(&["score", &file, &middle, &fine, &coarse]);
    let table = stdout(&output);
    let orders = orders_of(table);
    let names: Vec<_> = orders.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["h_64.csv", "h_128.csv", "h_256.csv"], "{table}");
    assert_eq!(orders[0].1, "-", "{table}");
    for (_, order) in &orders[1..] {
        let order = order.parse::<f64>().expect("a number");
        assert!(order > 3.8 && order < 4.2, "{table}");
    }
    assert!(
        table.contains("Order: from the next larger step of the same method.") && !table.contains("warning")
    );
    // the files keep their order where a program reads them
    let json = json(&["score", &file, &middle, &fine, &coarse, "--format", "json"]);
    assert_eq!(json["files"][0]["name"], middle.as_str());
    // exchanged steps
    let output = run(&["score", &file, &middle, &fine, "--steps", "0.001,0.002"]);
    let (table, order) = (stdout(&output), &orders_of(stdout(&output))[1].1);
    assert!(order.parse::<f64>().is_ok_and(|order| order < -3.8), "{table}");
    let warning = format!("warning: {middle}: order {order}: do --steps belong to these files?");
    assert!(table.contains(&warning), "{table}");
}

#[test]
fn the_advice_names_the_command_that_prints_the_state() {
    let (file, folder) = (sample("toy_top"), folder("score_advice"));
    let to = folder.join("other.csv");
    write(&to, &samples(&sample("figure_3_loops"), &evenly(1.0, 11)), false);
    let to = to.to_str().expect("UTF-8");
    for (more, command) in [
        (&[&*file, to][..], format!("toytop state {file} --times 0")),
        (
            &["--benchmark", "bruls_cardona", to],
            "toytop benchmark bruls_cardona --times 0 --format csv".to_owned(),
        ),
    ] {
        let output = run(&[&["score"], more].concat());
        assert!(stdout(&output).contains(&format!("? ({command})\n")), "{}", stdout(&output));
        let words: Vec<_> = command.split(' ').skip(1).collect();
        let state = run(&words);
        assert!(state.status.success() && stdout(&state).lines().count() > 1, "{}", stderr(&state));
    }
}

#[test]
fn another_convention_is_noticed() {
    let (file, folder) = (sample("toy_top"), folder("score_doubt"));
    let mut rows = samples(&file, &evenly(0.1, 11));
    for (_, [_, x, y, z], _) in &mut rows {
        [*x, *y, *z] = [-*x, -*y, -*z];
    }
    let to = folder.join("inverse.csv");
    write(&to, &rows, false);
    let output = run(&["score", &file, to.to_str().expect("UTF-8"), "--format", "json"]);
    assert!(
        stderr(&output).contains("are the columns from fixed to body coordinates?"),
        "{}",
        stderr(&output)
    );
}

#[test]
fn invalid_results_are_refused_in_one_line() {
    let (file, folder) = (sample("toy_top"), folder("score_refused"));
    let [good, uneven, far] = ["good", "uneven", "far"].map(|name| folder.join(format!("{name}.csv")));
    write(&good, &samples(&file, &[0.0, 0.1, 0.2]), false);
    write(&uneven, &samples(&file, &[0.0, 0.1, 0.3]), false);
    std::fs::write(&far, "t,w,x,y,z\n1e300,1,0,0,0\n").expect("writable");
    let [good, uneven, far] = [good, uneven, far].map(|path| path.to_str().expect("UTF-8").to_owned());
    let picture = folder.join("work.svg").to_str().expect("UTF-8").to_owned();
    let cases: &[(&[&str], &str)] = &[
        (&[], "RESULT.csv"),
        (&["no_such.csv"], "no_such.csv: "),
        (&[&far], "far.csv: t: 1e300 must be within ±"),
        (&[&good, "--steps", "0.1,0.2"], "--steps: must be 1 numbers, one for each file"),
        (&[&good, "--steps", "-1"], "--steps"),
        (&[&good, "--plot", "work.jpg"], "--plot: work.jpg: must end in"),
        (&[&uneven, "--plot", &picture], "# evaluations = N in every file, or --steps"),
    ];
    for (arguments, part) in cases {
        let output = run(&[&["score", &file], *arguments].concat());
        let message = stderr(&output);
        assert_eq!((output.status.code(), stdout(&output)), (Some(2), ""), "{arguments:?}: {message}");
        assert!(message.contains(part) && message.matches('\n').count() == 1, "{arguments:?}: {message}");
        assert!(!Path::new(&picture).exists());
    }
}
