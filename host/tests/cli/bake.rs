//! Tests of `toytop bake`: contents of the files, choice of the size, and complete files.

mod c;
mod c_files;
pub(crate) mod cases;
mod compiled;

use super::{RELEASE, TOP, folder, json, needle, run, sample, scenario, slender, stderr, stdout};
use serde_json::Value;
use std::path::Path;
use toytop::{Baked, Clock, Ephemeris, ErrorBound, Tick, TipClock};
use toytop_host::input::scenario::Scenario;

/// The table that `spin_m0` has in flash is the one that this program writes.
#[test]
fn the_firmware_has_todays_table() {
    let committed = Path::new(env!("CARGO_MANIFEST_DIR")).join("../firmware-examples/src/tables/toy_top.rs");
    let committed = std::fs::read_to_string(committed).expect("a file");
    assert_eq!(stdout(&run(&["bake", &sample("toy_top"), "--scalar", "q31"])), committed);
}

#[test]
fn json_holds_every_number() {
    let file = sample("toy_top");
    let object = json(&["bake", &file, "--lang", "json"]);
    let motion = Scenario::read(Path::new(&file)).expect("a scenario").motion;
    let baked =
        Ephemeris::<f32, 25>::new(&motion, Tick::hertz(1000).expect("a tick")).expect("it fits").to_baked();
    let whole = |value: &Value| value.as_i64().expect("a whole number");
    let number = |value: &Value| value.as_f64().expect("a number");
    let read = Baked::<f32, 25> {
        format: whole(&object["format"]) as u32,
        crc32: whole(&object["crc32"]) as u32,
        clock: Clock {
            first: std::array::from_fn(|i| {
                let words = &object["first"][i];
                (whole(&words[1]) as u64) << 32 | whole(&words[0]) as u64
            }),
            step: std::array::from_fn(|i| std::array::from_fn(|j| whole(&object["step"][i][j]) as u32)),
            exact_step: std::array::from_fn(|i| std::array::from_fn(|j| number(&object["exact_step"][i][j]))),
            ticks_per_time: std::array::from_fn(|i| number(&object["ticks_per_time"][i])),
            horizon: None,
            tip_scale: number(&object["tip_scale"]) as f32,
            rates: std::array::from_fn(|i| number(&object["rates"][i]) as f32),
            tip: TipClock {
                start: std::array::from_fn(|i| whole(&object["tip"]["start"][i]) as u32),
                step: std::array::from_fn(|i| whole(&object["tip"]["step"][i]) as u32),
                quarter: whole(&object["tip"]["quarter"]) as i8,
                passes: whole(&object["tip"]["passes"]) as u8,
                exists: object["tip"]["exists"] == true,
            },
            turns: object["turns"] == true,
        },
        error_bound: ErrorBound {
            constant: number(&object["error_bound"][0]),
            per_tick: number(&object["error_bound"][1]),
        },
        rate_error_bound: ErrorBound {
            constant: number(&object["rate_error_bound"][0]),
            per_tick: number(&object["rate_error_bound"][1]),
        },
        cells: std::array::from_fn(|i| whole(&object["cells"][i]) as u16),
        segments: std::array::from_fn(|i| {
            std::array::from_fn(|j| std::array::from_fn(|k| whole(&object["coefficients"][i][j][k]) as i32))
        }),
    };
    assert_eq!(read, baked);
    assert!(read.ephemeris().is_ok() && object["horizon"].is_null());
    assert_eq!(object["sine"]["points"].as_array().map(Vec::len), Some(640));
    assert_eq!((object["scalar"].as_str(), object["tick"].as_str()), (Some("f32"), Some("1000 Hz")));
}

#[test]
fn the_size_is_chosen_and_said() {
    let slender = scenario("bake_slender", &slender([-0.9, 0.99, 1.18], ["5.4e-3", "5e-3"]));
    for (file, scalar, size) in [
        (&sample("toy_top"), "f32", "25x5"),
        (&sample("toy_top"), "f64", "48x11"),
        (&sample("toy_top"), "q31", "32x4"),
        (&sample("toy_top"), "q15", "16x3"),
        (&slender, "f32", "128x5"),
        (&slender, "f64", "128x11"),
    ] {
        let output = run(&["bake", file, "--scalar", scalar]);
        let note = stderr(&output);
        assert!(note.contains(&format!(": {size} in {scalar}, ")) && note.contains(" rad a tick"), "{note}");
        let scalar = match scalar {
            "q31" => "toytop::fixed::types::I2F30",
            "q15" => "toytop::fixed::types::I2F14",
            float => float,
        };
        let segments = size.split_once('x').expect("segments x terms").0;
        let name = format!("toytop::Ephemeris<{scalar}, {segments}>");
        assert!(stdout(&output).contains(&name));
    }
    assert!(stdout(&run(&["bake", "--help"])).contains("toytop bake top.toml"));
}

/// A smaller table is named only if it has the same error bound, and every size that is named is enough.
#[test]
fn the_least_size_is_named() {
    let summary = |file: &str, more: &[&str]| {
        let output = run(&[&["bake", file], more].concat());
        stderr(&output).lines().next().expect("a line").to_owned()
    };
    let bound = |summary: &str| {
        let (_, bound) = summary.split_once("orientation within ").expect("a bound");
        bound.split(" rad").next().expect("a number").parse::<f64>().expect("a number")
    };
    for (file, scalar, size, bytes) in
        [("toy_top", "f64", "8", "2816"), ("lagrange", "f32", "16", "1280"), ("sleeping", "q15", "8", "192")]
    {
        let file = sample(file);
        let large = summary(&file, &["--scalar", scalar]);
        assert!(large.ends_with(&format!("; --size {size} would be enough ({bytes} bytes)")), "{large}");
        let small = summary(&file, &["--scalar", scalar, "--size", size]);
        assert!(small.contains(&format!("{bytes} bytes, ")) && !small.contains("enough"), "{small}");
        assert!((bound(&small) / bound(&large) - 1.0).abs() < 0.07, "{small} {large}");
    }
    // the table of 8 segments exists, with a larger bound
    let [small, large] =
        ["8", "16"].map(|size| summary(&sample("toy_top"), &["--scalar", "q15", "--size", size]));
    assert!(bound(&small) > bound(&large) && !large.contains("enough"), "{small} {large}");
    // the pendulum needs 17 to 25 segments in f32
    let pendulum = sample("pendulum");
    for size in ["8", "16"] {
        let refused = summary(&pendulum, &["--size", size]);
        assert!(refused.ends_with("; at least --size 25 would be enough"), "{refused}");
    }
    assert!(!summary(&pendulum, &["--size", "25"]).contains("enough"));
}

#[test]
fn a_failed_bake_writes_nothing() {
    let (folder, good) = (folder("bake_refused"), sample("toy_top"));
    let needle = needle("bake_needle");
    let broken = scenario("bake_broken", TOP);
    let cases: &[(&str, &[&str], i32, &str)] = &[
        (&good, &["--size", "17"], 2, "--size: 17: must be"),
        (&good, &["--size", "25x5"], 2, "--size"),
        (&good, &["--hertz", "0"], 2, "1..=4294967295"),
        (&good, &["--tick", "0/2"], 2, "44100/2"),
        (&good, &["--tick", "44100"], 2, "44100/2"),
        (&good, &["--tick", "1/2", "--hertz", "3"], 2, "--hertz"),
        (&good, &["--scalar", "micromath"], 2, "--scalar: micromath: must be f64, f32, q31 or q15"),
        (&good, &["--lang", "ada"], 2, "rust, c, json"),
        (&good, &["-o", "no/such/folder/top.h"], 2, "no/such/folder/top.h"),
        (&broken, &[], 2, "motion: missing"),
        (&needle, &[], 3, "bake_needle: no ephemeris"),
        (&needle, &["--size", "32"], 3, "bake_needle: no ephemeris of 32 segments"),
    ];
    for (file, more, code, part) in cases {
        let to = folder.join("top.rs");
        let mut arguments = vec!["bake", file];
        arguments.extend(*more);
        if !more.contains(&"-o") {
            arguments.extend(["-o", to.to_str().expect("UTF-8")]);
        }
        let output = run(&arguments);
        let message = stderr(&output);
        assert_eq!((output.status.code(), stdout(&output)), (Some(*code), ""), "{arguments:?}: {message}");
        assert!(message.contains(part) && message.matches('\n').count() == 1, "{arguments:?}: {message}");
        assert_eq!(std::fs::read_dir(&folder).expect("a folder").count(), 0, "{arguments:?}");
    }
}

#[test]
fn any_file_name_makes_an_identifier() {
    let text = format!("{TOP}{}", RELEASE);
    for (name, identifier) in [("bake 1-é*", "BAKE_1_U00E9"), ("1st bake", "TOP_1ST_BAKE")] {
        let file = scenario(name, &text);
        assert!(stdout(&run(&["bake", &file])).contains(&format!("pub static {identifier}: ")), "{name}");
    }
}
