//! `toytop score`: trajectories with known errors, and runs with a known order.

use crate::command::{
    all_refused, csv, folder, json, list, number, path, read, sample, scenario, toytop, write,
};
use serde_json::Value;
use std::f64::consts::PI;

/// Score of one file.
fn score(arguments: &str) -> Value {
    json(format!("score {arguments}"))["files"][0].clone()
}

/// Columns of a trajectory: time, quaternion, and ω in the fixed frame, which a file may lack.
const COLUMNS: [&str; 8] = ["t", "w", "x", "y", "z", "omega_x", "omega_y", "omega_z"];
const WITHOUT_RATES: usize = 5;

/// Rows of a scenario at these times.
fn rows(scenario: &str, times: &[f64]) -> Vec<Vec<f64>> {
    csv(&format!("state {scenario} --times={} --columns t,quaternion,omega", joined(times))).rows
}

fn joined(numbers: &[f64]) -> String {
    numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(",")
}

/// Writes the first columns of rows.
fn written(to: &str, rows: &[Vec<f64>], columns: usize) {
    let rows: Vec<_> = rows.iter().map(|row| joined(&row[..columns])).collect();
    write(to, format!("{}\n{}\n", COLUMNS[..columns].join(","), rows.join("\n")));
}

fn evenly(end: f64, places: u32) -> Vec<f64> {
    (0..places).map(|i| end * f64::from(i) / f64::from(places - 1)).collect()
}

/// Turns the orientation of a row at a rate about the vertical, from the left, or about the body's axis, from the right.
fn turn(row: &mut [f64], rate: f64, about_vertical: bool) {
    let (s, c) = (0.5 * (rate * row[0])).sin_cos();
    let sign = if about_vertical { 1.0 } else { -1.0 };
    let [w, x, y, z] = [1, 2, 3, 4].map(|k| row[k]);
    let turned = [c * w - s * z, c * x - sign * s * y, c * y + sign * s * x, c * z + s * w];
    row[1..5].copy_from_slice(&turned);
}

#[test]
fn exact_rows_have_no_error_whatever_their_signs() {
    let mut exact = rows("@toy_top", &evenly(1.0, 201));
    exact.iter_mut().step_by(3).for_each(|row| row[1..5].iter_mut().for_each(|x| *x = -*x));
    written("score_exact.csv", &exact, WITHOUT_RATES);
    let found = json("score @toy_top score_exact.csv");
    assert_eq!((&found["order"], &found["sign"]), (&Value::Null, &Value::from("nearest")));
    let scored = &found["files"][0];
    assert_eq!((&scored["rows"], &scored["step_from"]), (&Value::from(201), &Value::from("rows")));
    assert!((number(&scored["step"]) - 0.005).abs() < 1e-15);
    for key in ["max_error_rad", "rms_error_rad", "final_error_rad", "max_u_error", "residual_rad"] {
        assert!(number(&scored[key]) < 1e-15, "{key}: {scored}");
    }
    let bound = number(&scored["truth_bound_rad"]);
    assert!(bound > 1e-16 && bound < 1e-13);
    assert!(scored["drift_h"].is_null(), "{scored}");
    let table = toytop("score @toy_top score_exact.csv").ok();
    assert!(table.contains("score_exact.csv") && table.lines().count() < 20, "{table}");
}

/// A motion that is delayed by τ has known phase errors and no other error.
#[test]
fn a_delay_is_three_phase_errors() {
    let constants = json("constants @figure_3_loops");
    let [period, a, b] = ["period", "alpha_turns", "beta_turns"].map(|key| number(&constants[key]));
    let times = evenly(6.0 * period, 301);
    // a constant delay, and a delay that grows to more than a nutation period; the middle of the last period is known to half a row
    type Delay = fn(f64) -> f64;
    let cases: [(Delay, [f64; 2]); 2] = [(|_| 1e-6, [2e-8, 1e-14]), (|t| 0.21 * t, [3e-3, 1e-8])];
    for (delay, [tolerance, rest]) in cases {
        let mut late = rows("@figure_3_loops", &times.iter().map(|t| t - delay(*t)).collect::<Vec<_>>());
        late.iter_mut().zip(&times).for_each(|(row, t)| row[0] = *t);
        written("score_late.csv", &late, WITHOUT_RATES);
        let scored = score("@figure_3_loops score_late.csv");
        for (key, turns) in
            [("nutation_error_rad", 1.0), ("precession_error_rad", a + b), ("spin_error_rad", a - b)]
        {
            // mean delay over the last period
            let expected = -2.0 * PI * turns * delay(5.5 * period) / period;
            assert!((number(&scored[key]) / expected - 1.0).abs() < tolerance, "{key}: {scored} {expected}");
        }
        assert!(number(&scored["residual_rad"]) < rest, "{scored}");
    }
}

/// An error of the precession alone is no error of the nutation, and one of the spin neither.
#[test]
fn an_error_of_a_rate_is_that_of_its_angle() {
    let exact = rows("@toy_top", &evenly(1.0, 2001));
    for (about_vertical, key) in [(true, "precession_error_rad"), (false, "spin_error_rad")] {
        let mut off = exact.clone();
        off.iter_mut().for_each(|row| turn(row, 1e-3, about_vertical));
        written("score_rate.csv", &off, WITHOUT_RATES);
        let scored = score("@toy_top score_rate.csv");
        assert!(number(&scored["nutation_error_rad"]).abs() < 1e-11, "{scored}");
        assert!((number(&scored[key]) / 1e-3 - 0.96).abs() < 0.04, "{scored}");
        assert!(number(&scored["residual_rad"]) < 1e-13, "{scored}");
    }
}

/// For a top that spins faster by a millionth, the drift of n is a millionth.
#[test]
fn a_faster_spin_is_a_drift_of_l_and_n() {
    let text = read(&sample("toy_top"));
    let faster = scenario("score_faster", &text.replace("spin = 150.0", "spin = 150.00015"));
    let [own, other] = ["@toy_top", &faster].map(|file| json(format!("constants {file}")));
    let fast = rows(&faster, &evenly(0.5, 1001));
    written("score_drift.csv", &fast, COLUMNS.len());
    let scored = score("@toy_top score_drift.csv");
    for key in ["l", "n"] {
        // n is the greatest of the three scales
        let expected = (number(&other[key]) - number(&own[key])).abs() / number(&own["n"]);
        let drift = number(&scored[format!("drift_{key}")]);
        assert!((drift / expected - 1.0).abs() < 1e-5, "{key}: {drift} {expected}");
    }
    written("score_short.csv", &fast[..6], WITHOUT_RATES);
    assert!(score("@toy_top score_short.csv")["residual_rad"].is_null());
}

/// File with a run of the stepper over the loops of Figure 3, below its step.
fn stepped(name: &str, steps: u32, times: &str, step: f64) -> String {
    let run = format!("state @figure_3_loops --times={times} --method stepper --steps-per-period {steps}");
    let rows = toytop(format!("{run} --format csv")).ok();
    write(&format!("score_{name}_{steps}.csv"), format!("# step = {step}\n{rows}")).to_owned()
}

/// `toytop score` reads the output of `toytop state`, and finds that the stepper is of fourth order.
#[test]
fn the_steppers_order_is_measured() {
    let period = number(&json("constants @figure_3_loops")["period"]);
    let times = format!("0..{}/161", 5.0 * period);
    let counts = [128, 64, 256, 512];
    let files = counts.map(|steps| stepped("work", steps, &times, 1.0));
    let steps = counts.map(|steps| (period / f64::from(steps)).to_string()).join(",");
    let line = format!("score @figure_3_loops {} --steps={steps}", files.join(" "));
    let found = json(format!("{line} --plot work.svg"));
    let order = number(&found["order"]);
    assert!(order > 3.9 && order < 4.1, "{order}");
    assert_eq!(found["methods"][0]["files"], 4);
    // the files keep their order; the one with the largest step has none to compare with
    for (file, name) in list(&found["files"]).iter().zip(&files) {
        assert_eq!((&file["name"], &file["step_from"]), (&Value::from(&**name), &Value::from("option")));
        let is_fourth = file["order"].as_f64().is_some_and(|order| order > 3.8 && order < 4.2);
        assert_eq!(is_fourth, !name.contains("work_64"), "{file}");
    }
    assert!(toytop(line).ok().contains("Order of convergence: "));
    let svg = read("work.svg");
    // ticks between powers of ten, from 64 to 512 steps
    for part in ["steps in a nutation period", "measured order", ">10²<", ">10³<"] {
        assert!(svg.contains(part), "{part}");
    }
}

/// Files of different lengths have no order, and the reason is printed.
#[test]
fn runs_of_different_lengths_have_no_order() {
    let files = [(64, "0..20/101"), (128, "0..10/101"), (256, "0..5/101")]
        .map(|(steps, times)| stepped("lengths", steps, times, 1.0 / f64::from(steps)));
    let found = json(format!("score @figure_3_loops {}", files.join(" ")));
    assert!(found["order"].is_null() && found["files"][1]["method_order"].is_null(), "{found}");
    let [first, other, _] = files;
    let output = toytop(format!("score @figure_3_loops {first} {other}")).err;
    assert!(
        output.contains(&format!("warning: no order: {first} and {other} end at different times")),
        "{output}"
    );
}

#[test]
fn another_convention_is_noticed() {
    let mut inverse = rows("@toy_top", &evenly(0.1, 11));
    inverse.iter_mut().for_each(|row| row[2..5].iter_mut().for_each(|x| *x = -*x));
    written("score_inverse.csv", &inverse, WITHOUT_RATES);
    let run = toytop("score @toy_top score_inverse.csv --format json");
    assert!(run.err.contains("are the columns from fixed to body coordinates?"), "{}", run.err);
}

/// Positions and the angular velocity are compared where the file has them.
#[test]
fn positions_and_rates_are_checked() {
    let table = csv("state @toy_top --times=0..1/101 --columns t,quaternion,tip,omega");
    let shifted = |column: &str, by: f64| {
        let place = table.names.split(',').position(|name| name == column).expect("a column");
        let mut rows = table.rows.clone();
        rows.iter_mut().for_each(|row| row[place] += by);
        let rows: Vec<_> = rows.iter().map(|row| joined(row)).collect();
        write("score_shifted.csv", format!("{}\n{}\n", table.names, rows.join("\n")));
        (score("@toy_top score_shifted.csv"), toytop("score @toy_top score_shifted.csv").err)
    };
    assert!(number(&shifted("t", 0.0).0["max_position_error"]) < 1e-15);
    let (off, output) = shifted("tip_x", 0.5);
    assert!((number(&off["max_position_error"]) - 0.5).abs() < 1e-12, "{off}");
    assert!(output.contains("the position of the first row is off by 1.7e1 "), "{output}");
    let (_, output) = shifted("omega_x", 10.0);
    assert!(output.contains("the angular velocity of the first row is off by 6.7e-2 "), "{output}");
}

#[test]
fn wrong_files_are_refused() {
    written("score_good.csv", &rows("@toy_top", &[0.0, 0.1, 0.2]), WITHOUT_RATES);
    written("score_uneven.csv", &rows("@toy_top", &[0.0, 0.1, 0.3]), WITHOUT_RATES);
    write("score_far.csv", "t,w,x,y,z\n1e300,1,0,0,0\n");
    folder("score_refused");
    all_refused(
        "score @toy_top",
        &[
            ("", "RESULT.csv"),
            ("no_such.csv", "no_such.csv: "),
            ("score_far.csv", "score_far.csv: t: 1e300 must be within ±"),
            ("score_good.csv --steps 0.1,0.2", "--steps: needs one number for each file, 1 in all"),
            ("score_good.csv --steps -1", "--steps"),
            ("score_good.csv --plot work.jpg", "'work.jpg' for '--plot <FILE>': must end in"),
            ("score_uneven.csv --plot score_refused/a.svg", "# evaluations = N in every file, or --steps"),
        ],
    );
    assert!(!path("score_refused/a.svg").exists());
}
