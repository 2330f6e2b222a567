//! `toytop bake`: what is in the files, how the size is chosen, and that a file is there as a whole or not at all.

pub(crate) mod cases;
mod compiled;

use super::{RELEASE, TOP, folder, json, needle, run, sample, scenario, slender, stderr, stdout};
use serde_json::Value;
use std::path::Path;
use toytop::{Baked, Ephemeris, Tick};
use toytop_host::scenario::Scenario;

/// The table that `spin_m0` has in flash is what this program would write today.
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
    let baked = Ephemeris::<f32, 25, 5>::new(&motion, Tick::hertz(1000).expect("a tick"))
        .expect("it fits")
        .to_baked();
    let whole = |value: &Value| value.as_i64().expect("a whole number");
    let number = |value: &Value| value.as_f64().expect("a number");
    let read = Baked::<f32, 25, 5> {
        format: whole(&object["format"]) as u32,
        checksum: whole(&object["checksum"]) as u32,
        first: std::array::from_fn(|i| {
            let words = &object["first"][i];
            (whole(&words[1]) as u64) << 32 | whole(&words[0]) as u64
        }),
        step: std::array::from_fn(|i| std::array::from_fn(|j| whole(&object["step"][i][j]) as u32)),
        exact_step: std::array::from_fn(|i| std::array::from_fn(|j| number(&object["exact_step"][i][j]))),
        ticks_per_time: std::array::from_fn(|i| number(&object["ticks_per_time"][i])),
        horizon: None,
        bound: std::array::from_fn(|i| number(&object["bound"][i])),
        tip_scale: number(&object["tip_scale"]) as f32,
        rates: std::array::from_fn(|i| number(&object["rates"][i]) as f32),
        cells: std::array::from_fn(|i| whole(&object["cells"][i]) as u16),
        coefficients: std::array::from_fn(|i| {
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
        (&slender, "f32", "128x6"),
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
        let name = format!("toytop::Ephemeris<{scalar}, {}>", size.replace('x', ", "));
        assert!(stdout(&output).contains(&name));
    }
    assert!(stdout(&run(&["bake", "--help"])).contains("toytop bake top.toml"));
}

#[test]
fn what_cannot_be_baked_leaves_nothing_behind() {
    let (folder, good) = (folder("bake_refused"), sample("toy_top"));
    let needle = needle("bake_needle");
    let broken = scenario("bake_broken", TOP);
    let cases: &[(&str, &[&str], i32, &str)] = &[
        (&good, &["--size", "17x8"], 2, "--size: 17x8 must be one of 16x6, 25x5, 32x6, 128x6, 1024x6"),
        (&good, &["--size", "16*8"], 2, "segments x terms"),
        (&good, &["--hertz", "0"], 2, "1..=4294967295"),
        (&good, &["--tick", "0/2"], 2, "44100/2"),
        (&good, &["--tick", "44100"], 2, "44100/2"),
        (&good, &["--tick", "1/2", "--hertz", "3"], 2, "--hertz"),
        (&good, &["--scalar", "micromath"], 2, "--scalar: micromath: must be f64, f32, q31 or q15"),
        (&good, &["--lang", "ada"], 2, "rust, c, json"),
        (&good, &["-o", "no/such/folder/top.h"], 2, "no/such/folder/top.h"),
        (&broken, &[], 2, "motion: missing"),
        (&needle, &[], 3, "bake_needle: no ephemeris"),
        (&needle, &["--size", "25x5"], 3, "bake_needle: no ephemeris of 25x5"),
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
    for (name, identifier) in [("bake 1-é*", "BAKE_1___"), ("1st bake", "TOP_1ST_BAKE")] {
        let file = scenario(name, &text);
        assert!(stdout(&run(&["bake", &file])).contains(&format!("pub static {identifier}: ")), "{name}");
    }
}
