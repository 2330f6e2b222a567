//! `toytop simulate` and `toytop fit`: from a scenario to samples and back.

use super::{folder, json, run, sample, scenario, stderr, stdout};
use serde_json::Value;
use std::path::Path;

fn text(path: &Path) -> &str {
    path.to_str().expect("UTF-8")
}

/// Samples of a scenario, 0.3 s at 1 kHz.
fn simulated(file: &str, to: &Path, more: &[&str]) {
    let mut arguments =
        vec!["simulate", file, "--hertz", "1000", "--duration", "0.3", "--seed", "7", "-o", text(to)];
    arguments.extend(more);
    let output = run(&arguments);
    assert!(output.status.success(), "{}", stderr(&output));
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

#[test]
fn a_fitted_scenario_predicts_what_the_true_one_does() {
    let (file, folder) = (sample("toy_top"), folder("fit_round"));
    let (samples, fitted) = (folder.join("samples.csv"), folder.join("fitted.toml"));
    simulated(&file, &samples, &[]);
    let found = json(&["fit", text(&samples), "--top", &file, "-o", text(&fitted), "--format", "json"]);
    assert_eq!((&found["converged"], &found["reason"]), (&Value::Bool(true), &Value::Null), "{found}");
    let error = (number(&found["spin"]) - 150.0) / number(&found["spin_deviation"]);
    assert!(error.abs() < 4.5, "{found}");
    assert!(number(&found["saturated"]) >= 300.0, "the gyroscope is blind along the axis: {found}");
    // a second after the end, within what was announced
    let [state, truth] = [text(&fitted), &file].map(|file| super::samples(file, "1.3", &[]).remove(0));
    let announced = &found["prediction"][1];
    assert!((number(&announced["t"]) - 1.299).abs() < 1e-9, "{announced}");
    let part = |key: &str, k: usize| number(&state[key][k]) - number(&truth[key][k]);
    let square: f64 =
        ["alpha", "beta"].iter().flat_map(|key| [part(key, 0), part(key, 1)]).map(|x| x * x).sum();
    let off = 2.0 * square.sqrt();
    assert!(off < 4.0 * number(&announced["orientation_rad"]), "{off} {announced}");
    let table = run(&["fit", text(&samples), "--top", &file]);
    assert!(
        stdout(&table).starts_with("converged\n") && stdout(&table).contains("spin "),
        "{}",
        stdout(&table)
    );
}

#[test]
fn a_wrong_inertia_is_corrected_where_it_is_free() {
    let folder = folder("fit_free");
    let (samples, fitted) = (folder.join("samples.csv"), folder.join("fitted.toml"));
    let sensors = folder.join("sensors.toml");
    std::fs::write(&sensors, "[orientation]\nnoise = 0.002\nevery = 2\n").expect("written");
    simulated(&sample("toy_top"), &samples, &["--sensors", text(&sensors)]);
    let own = std::fs::read_to_string(sample("toy_top")).expect("a scenario");
    let wrong = scenario("fit_wrong", &own.replace("axial_inertia = 2.0e-5", "axial_inertia = 2.06e-5"));
    let arguments =
        ["fit", text(&samples), "--top", &wrong, "--sensors", text(&sensors), "-o", text(&fitted)];
    let strict = run(&arguments);
    assert_eq!(strict.status.code(), Some(1));
    assert!(stdout(&strict).starts_with("NOT CONVERGED: "), "{}", stdout(&strict));
    assert!(!fitted.exists(), "a launch that is not believed is not written");
    let found = json(&[&arguments[..], &["--free", "axial_inertia", "--format", "json"]].concat());
    let inertia = &found["free"]["axial_inertia"];
    let error = (number(&inertia["value"]) - 2e-5) / number(&inertia["deviation"]);
    assert!(error.abs() < 4.5, "{inertia}");
    assert!(run(&["state", text(&fitted), "--times", "0"]).status.success());
}

/// A top that loses nothing: its drift is 0 within the error bars, and its launch is that of the last sample.
#[test]
fn a_drift_is_reported_with_its_error_bars() {
    let (file, folder) = (sample("toy_top"), folder("fit_drift"));
    let (samples, fitted) = (folder.join("samples.csv"), folder.join("fitted.toml"));
    simulated(&file, &samples, &[]);
    let arguments = ["fit", text(&samples), "--top", &file, "--drift", "0.02"];
    let found = json(&[&arguments[..], &["-o", text(&fitted), "--format", "json"]].concat());
    assert_eq!(found["converged"], true, "{found}");
    assert!((number(&found["epoch"]) - 0.299).abs() < 1e-9, "{found}");
    for k in 0..3 {
        let [rate, deviation] = ["rates", "deviation"].map(|key| number(&found["drift"][key][k]));
        assert!(deviation > 0.0 && (rate / deviation).abs() < 4.5 && rate != 0.0, "{found}");
    }
    let written = std::fs::read_to_string(&fitted).expect("written");
    let comment = written.lines().nth(1).expect("a comment");
    assert!(comment.starts_with("# Drift during the samples") && comment.contains("dh/dt = "), "{comment}");
    assert!(run(&["state", text(&fitted), "--times", "0"]).status.success());
    let table = run(&arguments);
    assert!(stdout(&table).contains("dn/dt ") && stdout(&table).contains(" N m"), "{}", stdout(&table));
    for (more, expected) in [
        (&["--free", "axial_inertia,gravity"][..], "--drift: --free must name at most one key with it"),
        (&["--drift", "0"], "--drift"),
    ] {
        let start = if more[0] == "--drift" { &arguments[..4] } else { &arguments[..] };
        let output = run(&[start, more].concat());
        assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
        assert!(stderr(&output).contains(expected), "{}", stderr(&output));
    }
}

/// Points of a curve of this colour in a picture, pixels.
fn curve(svg: &str, color: &str) -> Vec<[f64; 2]> {
    let (before, _) = svg.split_once(&format!("\" stroke=\"{color}\"")).expect("a curve of this colour");
    let (_, path) = before.rsplit_once("d=\"M ").expect("its points");
    let number = |text: &str| text.parse::<f64>().expect("a number");
    path.split('L')
        .map(|pair| pair.trim().split_once(' ').expect("x y"))
        .map(|(x, y)| [number(x), number(y)])
        .collect()
}

/// Residuals are dots, in a strip for each sensor, and no lines join them. The error of the axis across the vertical grows with the
/// time, and does not seem to oscillate.
#[test]
fn pictures_of_a_fit_can_be_read() {
    let folder = folder("fit_pictures");
    let [samples, residuals, prediction] =
        ["samples.csv", "residuals.svg", "prediction.svg"].map(|name| folder.join(name));
    simulated(&sample("toy_top"), &samples, &[]);
    let plots = ["--plot-residuals", text(&residuals), "--plot-prediction", text(&prediction)];
    let output = run(&[&["fit", text(&samples), "--top", &sample("toy_top")][..], &plots].concat());
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let svg = std::fs::read_to_string(&residuals).expect("the picture");
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

    let svg = std::fs::read_to_string(&prediction).expect("the picture");
    let short = curve(&svg, "#009e73");
    let late = &short[short.len() / 2..];
    assert!(late.len() >= 40 && late[0][1] - late[late.len() - 1][1] > 100.0, "{late:?}");
    assert!(late.windows(2).all(|pair| pair[1][1] < pair[0][1] + 1.0), "it never falls: {late:?}");
}

#[test]
fn bad_samples_are_refused_with_their_line() {
    let folder = folder("fit_bad");
    let header = "t,gyro_x,gyro_y,gyro_z,accel_x,accel_y,accel_z\n";
    let cases = [
        (
            "nan",
            format!("{header}0,1,2,3,0,0,9.8\n0.001,1,NaN,3,0,0,9.8\n"),
            "line 3: gyro_y: must be a finite number",
        ),
        (
            "degrees",
            format!("{header}0,100,2,3,0,0,9.8\n"),
            "line 2: gyro_x: must be at most the range of the sensor: another unit?",
        ),
        ("order", format!("{header}0,1,2,3,0,0,9.8\n-1,1,2,3,0,0,9.8\n"), "line 3: t: must not be earlier"),
        ("short", format!("{header}0,1,2,3,0\n"), "line 2: must have 7 fields, as the header; has 5"),
        ("half", format!("{header}0,1,2,,0,0,9.8\n"), "line 2: gyro_z: must be a finite number"),
        ("none", "t,a,b\n0,1,2\n".to_owned(), "line 1: must have the columns of a sensor"),
        ("time", "gyro_x,gyro_y,gyro_z\n0,1,2\n".to_owned(), "line 1: must have a column t"),
        ("empty", header.to_owned(), "must not be empty"),
    ];
    for (name, content, expected) in cases {
        let path = folder.join(format!("{name}.csv"));
        std::fs::write(&path, content).expect("written");
        let output = run(&["fit", text(&path), "--top", &sample("toy_top")]);
        assert_eq!(output.status.code(), Some(2), "{name}: {}", stderr(&output));
        assert!(
            stderr(&output).contains(expected) && stderr(&output).lines().count() == 1,
            "{}",
            stderr(&output)
        );
        assert_eq!(stdout(&output), "", "{name}");
    }
    let few = folder.join("few.csv");
    std::fs::write(&few, format!("{header}0,1,2,3,0,0,9.8\n")).expect("written");
    let output = run(&["fit", text(&few), "--top", &sample("toy_top")]);
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(stdout(&output), "NOT CONVERGED: there are fewer observations than unknowns\n");
}

/// Samples of another top: no launch and no prediction is printed where none was found.
#[test]
fn samples_of_another_top_have_no_launch() {
    let folder = folder("fit_other");
    let samples = folder.join("samples.csv");
    simulated(&sample("toy_top"), &samples, &[]);
    let picture = folder.join("prediction.svg");
    for name in ["lagrange", "pendulum"] {
        let top = sample(name);
        let arguments = ["fit", text(&samples), "--top", &top];
        let output = run(&[&arguments[..], &["--plot-prediction", text(&picture)]].concat());
        let reason = format!("no start fits the samples: is --top {top} the top that they are of?");
        assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
        assert_eq!(stdout(&output), format!("NOT CONVERGED: {reason}\n"));
        assert!(stderr(&output).contains("not written, because there is no launch") && !picture.exists());
        let output = run(&[&arguments[..], &["--format", "json"]].concat());
        let found: Value = serde_json::from_slice(&output.stdout).expect("JSON");
        assert_eq!((&found["reason"], &found["used"]), (&Value::from(reason), &Value::from(0)), "{found}");
        assert_eq!(found["prediction"], Value::Array(Vec::new()), "{found}");
    }
    // a gyroscope alone states no direction, whichever top it is on
    let (file, sensors) = (sample("toy_top"), folder.join("sensors.toml"));
    std::fs::write(&sensors, "[gyroscope]\nnoise = 0.002\n").expect("written");
    simulated(&file, &samples, &["--sensors", text(&sensors)]);
    let output = run(&["fit", text(&samples), "--top", &file, "--sensors", text(&sensors)]);
    assert!(stdout(&output).contains("they need an orientation, an axis, or a direction and rates"));
}

#[test]
fn bad_sensors_and_keys_are_refused() {
    let folder = folder("fit_sensors");
    let samples = folder.join("samples.csv");
    let top = sample("toy_top");
    for (content, expected) in [
        ("[gyroscop]\nnoise = 1\n", "gyroscop: unknown sensor; allowed: timing, gyroscope"),
        ("[gyroscope]\nrange = 1\n", "gyroscope.noise: missing"),
        ("[gyroscope]\nnoise = -1\n", "gyroscope.noise: must be a number from"),
        ("[gyroscope]\nnoise = 1\nfield = [1, 2, 3]\n", "gyroscope.field: unknown key"),
        (
            "[magnetometer]\nnoise = 1\nrotation = [1, 1, 0, 0]\n",
            "magnetometer.rotation: must be a unit quaternion",
        ),
        ("", "must have one to four sensors"),
    ] {
        let path = folder.join("sensors.toml");
        std::fs::write(&path, content).expect("written");
        let output = run(&["simulate", &top, "--sensors", text(&path), "-o", text(&samples)]);
        assert_eq!(output.status.code(), Some(2), "{content}: {}", stderr(&output));
        assert!(stderr(&output).contains(expected), "{}", stderr(&output));
        assert!(!samples.exists());
    }
    simulated(&top, &samples, &[]);
    let output = run(&["fit", text(&samples), "--top", &top, "-o", "no_such_folder/f.toml"]);
    assert_eq!((output.status.code(), stdout(&output)), (Some(2), ""));
    assert!(stderr(&output).starts_with("error: --output: no_such_folder/f.toml: "), "{}", stderr(&output));
    for (free, expected) in [
        (
            "mass,mass_moment",
            "--free: mass_moment: must be one of the numbers that describe the top: transverse_inertia, \
             axial_inertia, com_height, mass, gravity (",
        ),
        ("mass,mass", "--free: mass: must be named once"),
    ] {
        let output = run(&["fit", text(&samples), "--top", &top, "--free", free]);
        assert_eq!(output.status.code(), Some(2));
        assert!(stderr(&output).contains(expected), "{}", stderr(&output));
    }
}
