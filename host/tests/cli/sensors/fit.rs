//! `toytop simulate` and `toytop fit`: from a scenario to samples and back.

use crate::command::{
    all_refused, count, folder, json, number, numbers, path, read, sample, samples, scenario, toytop, write,
};
use serde_json::Value;

/// Samples of the toy top in a file of this name, 0.3 s at 1 kHz.
fn simulated(to: &str, sensors: &str) {
    toytop(format!("simulate @toy_top --sample-rate 1000 --duration 0.3 --seed 7 -o {to} {sensors}")).ok();
}

#[test]
fn a_fitted_scenario_predicts_what_the_true_one_does() {
    simulated("fit_round.csv", "");
    let found = json("fit fit_round.csv --top @toy_top -o fit_round.toml");
    assert!(found["converged"] == true && found["reason"].is_null(), "{found}");
    let error = (number(&found["spin"]) - 150.0) / number(&found["spin_deviation"]);
    assert!(error.abs() < 4.5, "{found}");
    assert!(number(&found["saturated"]) >= 300.0, "the gyroscope is blind along the axis: {found}");
    // a second after the end, within the announced error
    let [state, truth] = ["fit_round.toml", "@toy_top"]
        .map(|file| numbers(&samples(format!("{file} --times 1.3"))[0], "alpha beta"));
    let announced = &found["prediction"][1];
    assert!((number(&announced["t"]) - 1.299).abs() < 1e-9, "{announced}");
    let square: f64 = state.iter().zip(truth).map(|(x, y)| (x - y).powi(2)).sum();
    let off = 2.0 * square.sqrt();
    assert!(off < 4.0 * number(&announced["orientation_rad"]), "{off} {announced}");
    let table = toytop("fit fit_round.csv --top @toy_top").ok();
    assert!(table.starts_with("converged\n") && table.contains("spin "), "{table}");
}

/// A column that no sensor reads is named, a unit in brackets is understood, and another unit is refused.
#[test]
fn columns_are_read_named_or_refused() {
    simulated("fit_columns.csv", "");
    let own = read("fit_columns.csv");
    let (header, rows) = own.split_once('\n').expect("a header");
    let fitted = |header: &str, rows: &str| {
        write("fit_other_columns.csv", format!("{header}\n{rows}"));
        toytop("fit fit_other_columns.csv --top @toy_top")
    };
    let plain = fitted(header, rows).ok();
    let with_units = header.replace("gyro_x", "gyro_x [rad/s]").replace("accel_z", "accel_z (m/s^2)");
    assert_eq!(fitted(&with_units, rows).ok(), plain);
    let more: String = rows.lines().map(|row| format!("{row},1\n")).collect();
    let named = fitted(&format!("{header},gx"), &more);
    assert!(named.err.contains("columns that no sensor reads: gx\n"), "{}", named.err);
    assert_eq!(named.ok(), plain);
    for unit in ["deg/s", "rpm"] {
        let refused = fitted(&header.replace("gyro_x", &format!("gyro_x [{unit}]")), rows);
        refused.refused(2, &format!("gyro_x: must be in rad/s, not {unit}"));
    }
}

#[test]
fn a_wrong_inertia_is_corrected_where_it_is_free() {
    write("fit_camera.toml", "[orientation]\nnoise = 0.002\nevery = 2\n");
    simulated("fit_free.csv", "--sensors fit_camera.toml");
    let own = read(&sample("toy_top"));
    let wrong = scenario("fit_wrong", &own.replace("axial_inertia = 2.0e-5", "axial_inertia = 2.06e-5"));
    folder("fit_free");
    let line = format!("fit fit_free.csv --top {wrong} --sensors fit_camera.toml -o fit_free/fitted.toml");
    let strict = toytop(&line);
    assert_eq!(strict.code, Some(1));
    assert!(strict.out.starts_with("NOT CONVERGED: "), "{}", strict.out);
    assert!(!path("fit_free/fitted.toml").exists(), "a launch that is not believed is not written");
    let found = json(format!("{line} --free axial_inertia"));
    let inertia = &found["free"]["axial_inertia"];
    let error = (number(&inertia["value"]) - 2e-5) / number(&inertia["deviation"]);
    assert!(error.abs() < 4.5, "{inertia}");
    let row = toytop(format!("{line} --free axial_inertia --format csv")).ok();
    let (header, values) = row.split_once('\n').expect("a header");
    assert!(header.starts_with("converged,reason,epoch,quaternion_w,quaternion_x,"), "{header}");
    let place = header.split(',').position(|name| name == "free_axial_inertia_value").expect("a column");
    let value: f64 = values.split(',').nth(place).expect("a value").parse().expect("a number");
    assert_eq!((values.starts_with("true,"), value), (true, number(&inertia["value"])), "{row}");
    toytop("state fit_free/fitted.toml --times 0").ok();
}

/// The drift of a top without losses is 0 within the error bars, and its launch is that of the last sample.
#[test]
fn a_drift_is_reported_with_its_error_bars() {
    simulated("fit_drift.csv", "");
    let line = "fit fit_drift.csv --top @toy_top";
    let found = json(format!("{line} --drift 0.02 -o fit_drift.toml"));
    assert_eq!(found["converged"], true, "{found}");
    assert!((number(&found["epoch"]) - 0.299).abs() < 1e-9, "{found}");
    let [rates, deviations] = ["rates", "deviation"].map(|key| numbers(&found["drift"], key));
    for (rate, deviation) in rates.iter().zip(deviations) {
        assert!(deviation > 0.0 && (rate / deviation).abs() < 4.5 && *rate != 0.0, "{found}");
    }
    let written = read("fit_drift.toml");
    let comment = written.lines().nth(1).expect("a comment");
    assert!(comment.starts_with("# Drift during the samples") && comment.contains("dh/dt = "), "{comment}");
    toytop("state fit_drift.toml --times 0").ok();
    let table = toytop(format!("{line} --drift 0.02")).ok();
    assert!(table.contains("dn/dt ") && table.contains(" N m"), "{table}");
    all_refused(
        line,
        &[
            ("--drift 0.02 --free axial_inertia,gravity", "--free: must be at most one name with a drift"),
            ("--drift 0", "--drift"),
            ("-o -", "must not be -, because stdout has the report"),
        ],
    );
}

/// Residuals are dots, in a strip for each sensor, and no lines join them.
#[test]
fn the_picture_of_a_fit_can_be_read() {
    simulated("fit_pictures.csv", "");
    toytop("fit fit_pictures.csv --top @toy_top --plot-residuals fit_residuals.svg").ok();
    // a file that cannot be written leaves no other
    folder("fit_half");
    let line =
        "fit fit_pictures.csv --top @toy_top -o fit_half/fitted.toml --plot-residuals fit_half/no/a.svg";
    toytop(line).refused(2, "--plot-residuals: ");
    assert_eq!(count("fit_half"), 0);
    let svg = read("fit_residuals.svg");
    for sensor in ["gyroscope", "accelerometer", "magnetometer"] {
        assert!(svg.contains(&format!(">{sensor}: residuals of the fit, standard deviations<")), "{sensor}");
    }
    // 300 samples of two rates and three accelerations, and 30 of the field; the rate about the axis is beyond the range
    assert_eq!(svg.matches("r=\"1.6\"").count(), 300 * 5 + 30 * 3);
    assert_eq!(svg.matches("stroke=\"#8a8a8a\"").count(), 6, "lines at 3 and -3");
    let longest = svg
        .split("d=\"M ")
        .skip(1)
        .map(|path| path.split('"').next().map_or(0, |path| path.matches('L').count()));
    assert!(longest.max() <= Some(1), "no line joins the dots");
}

#[test]
fn bad_samples_are_refused_with_their_line() {
    let header = "t,gyro_x,gyro_y,gyro_z,accel_x,accel_y,accel_z\n";
    let fitted = |rows: String| {
        write("fit_bad.csv", rows);
        toytop("fit fit_bad.csv --top @toy_top")
    };
    for (rows, expected) in [
        ("0,1,2,3,0,0,9.8\n0.001,1,NaN,3,0,0,9.8\n", "line 3: gyro_y: must be a finite number"),
        ("0,100,2,3,0,0,9.8\n", "line 2: gyro_x: must be at most the range of the sensor: another unit?"),
        ("0,1,2,3,0,0,9.8\n-1,1,2,3,0,0,9.8\n", "line 3: t: must not be earlier"),
        ("0,1,2,3,0\n", "line 2: must have 7 fields, as the header; has 5"),
        ("0,1,2,,0,0,9.8\n", "line 2: gyro_z: must be a finite number"),
        ("", "measurements: must be at least one"),
    ] {
        fitted(format!("{header}{rows}")).refused(2, expected);
    }
    fitted("# a comment\n\nt,a,b\n0,1,2\n".to_owned())
        .refused(2, "line 3: must have the columns of a sensor");
    fitted("gyro_x,gyro_y,gyro_z\n0,1,2\n".to_owned()).refused(2, "line 1: must have a column t");
    let few = fitted(format!("{header}0,1,2,3,0,0,9.8\n"));
    assert_eq!(few.code, Some(1));
    assert_eq!(few.out, "NOT CONVERGED: there are fewer observations than unknowns\n");
}

/// Samples of another top give no launch, and no file is written.
#[test]
fn samples_of_another_top_have_no_launch() {
    folder("fit_other");
    simulated("fit_other/a.csv", "");
    for top in ["@lagrange", "@pendulum", "@figure_3_loops"] {
        let line = format!("fit fit_other/a.csv --top {top} -o fit_other/a.toml --format json");
        let run = toytop(&line);
        assert_eq!(run.code, Some(1), "{}", run.out);
        let found: Value = serde_json::from_str(&run.out).expect("JSON");
        assert!(found["converged"] == false && found["reason"].is_string(), "{found}");
        assert!(!path("fit_other/a.toml").exists());
    }
}

#[test]
fn bad_sensors_and_keys_are_refused() {
    folder("fit_sensors");
    for (content, expected) in [
        ("[gyroscop]\nnoise = 1\n", "gyroscop: unknown sensor; allowed: timing, gyroscope"),
        ("[gyroscope]\nrange = 1\n", "gyroscope.noise: missing"),
        ("[gyroscope]\nnoise = -1\n", "gyroscope.noise: must be a number from"),
        ("[gyroscope]\nnoise = 1\nfield = [1, 2, 3]\n", "gyroscope.field: unknown or unneeded key"),
        (
            "[magnetometer]\nnoise = 1\nrotation = [1, 1, 0, 0]\n",
            "magnetometer.rotation: must be a unit quaternion",
        ),
        ("", "must have one to four sensors"),
    ] {
        write("fit_wrong_sensors.toml", content);
        let line = "simulate @toy_top --sensors fit_wrong_sensors.toml -o fit_sensors/a.csv";
        toytop(line).refused(2, expected);
        assert!(!path("fit_sensors/a.csv").exists());
    }
    simulated("fit_sensors/a.csv", "");
    all_refused(
        "fit fit_sensors/a.csv --top @toy_top",
        &[
            ("-o no_such_folder/f.toml", "error: --output: no_such_folder/f.toml: "),
            (
                "--free mass,mass_moment",
                "--free: mass_moment: must be one of the numbers that describe the top: transverse_inertia, \
                 axial_inertia, com_height, mass, gravity (",
            ),
            ("--free mass,mass", "--free: mass: must be named once"),
        ],
    );
}
