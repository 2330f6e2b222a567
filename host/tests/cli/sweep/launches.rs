//! Sweeps of a scenario: rows against `constants`, axes in the keys' units, and the heat map.

use super::{field, no_file, refused, sweep, words};
use crate::{json, run, sample, scenario, stderr, stdout};

/// Every row is the scenario with its numbers.
#[test]
fn a_row_is_the_scenario_with_its_numbers() {
    let file = sample("toy_top");
    let axes = ["--spin", "120..180/3", "--tilt", "0,20", "--axis", "com_height=0.02,0.03"];
    let columns = "regime,tip_class,period,phi_per_period,min_normal_force,h";
    let table = sweep(&no_file("launches"), &[&[&file, "--columns", columns][..], &axes].concat());
    assert!(table.starts_with("index,motions,version,seed,spin,tilt_deg,com_height,regime,"), "{table}");
    assert_eq!(table.lines().count(), 13);
    let text = std::fs::read_to_string(&file).expect("a scenario");
    for row in 0..12 {
        let cell = |name: &str| field(&table, row, name);
        let expected =
            [["120.0", "150.0", "180.0"][row / 4], ["0.0", "20.0"][row / 2 % 2], ["0.02", "0.03"][row % 2]];
        assert_eq!([cell("spin"), cell("tilt_deg"), cell("com_height")], expected);
        let own = text
            .replace("spin = 150.0", &format!("spin = {}", expected[0]))
            .replace("tilt_deg = 20.0", &format!("tilt_deg = {}", expected[1]))
            .replace("com_height = 0.03", &format!("com_height = {}", expected[2]));
        let constants = json(&["constants", &scenario("launches_row", &own), "--format", "json"]);
        for name in columns.split(',') {
            match constants[name].as_f64() {
                Some(expected) => {
                    assert_eq!(cell(name).parse::<f64>().expect(name), expected, "{row}: {name}")
                }
                None => assert_eq!(constants[name].as_str().unwrap_or_default(), cell(name), "{row}: {name}"),
            }
        }
    }
}

#[test]
fn numbers_that_a_scenario_cannot_have_are_refused_rows() {
    let file = sample("toy_top");
    let more = [&file, "--tilt", "-10..190/3", "--columns", "regime,period"];
    let table = sweep(&no_file("launches_refused"), &more);
    let regimes: Vec<_> = (0..3).map(|row| field(&table, row, "regime")).collect();
    assert_eq!(regimes, ["refused", "nutating", "refused"]);
    // the summary counts them, and says why the first one is no motion
    for (axes, shard, summary) in [
        (
            ["--tilt", "0..602/10"],
            "1/1",
            ": 10 motions, 7 of them refused (first: row 3, tilt_deg = 200.67: must be a number in [0, 180]), in ",
        ),
        (["--tilt", "0..602/10"], "2/2", ": 5 motions, 4 of them refused (first: row 3, tilt_deg = 200.67: "),
        (
            ["--axis", "com_height=-1,0.03"],
            "1/1",
            ": 2 motions, 1 of them refused (first: row 0, com_height = -1: must be positive, ",
        ),
        (["--tilt", "0,180"], "1/1", ": 2 motions in "),
    ] {
        let path = no_file("launches_counted");
        let output = run(&words(&path, &[&[&*file, "--shard", shard][..], &axes].concat()));
        assert!(stdout(&output).contains(summary), "{}", stdout(&output));
    }
    // drawn by lot, resumed, and in shards as any other sweep
    let lot = [&file, "--motions", "50", "--spin", "log:100..1000", "--tilt", "1..30"];
    let whole = sweep(&no_file("launches_lot"), &lot);
    let parts = ["1/2", "2/2"].map(|shard| {
        let name = format!("launches_lot_{}", &shard[..1]);
        sweep(&no_file(&name), &[&lot[..], &["--shard", shard, "--resume"]].concat())
    });
    for (row, line) in whole.lines().skip(1).enumerate() {
        assert_eq!(parts[row % 2].lines().nth(1 + row / 2), Some(line));
    }
}

#[test]
fn a_heat_map_shows_a_column() {
    let file = sample("toy_top");
    let path = no_file("launches_map");
    let picture = path.with_extension("svg");
    let _ = std::fs::remove_file(&picture);
    let axes = ["--spin", "90..300/12", "--tilt", "-5..60/14", "--plot", "spin,tilt,period"];
    sweep(&path, &[&[&*file][..], &axes].concat());
    let svg = std::fs::read_to_string(&picture).expect("the picture");
    for part in ["period, s", "tilt, degrees", "spin, rad/s", "grey: no value", "#c8c8c8"] {
        assert!(svg.contains(part), "{part}");
    }
    assert!(svg.matches("<rect").count() >= 12 * 14);
    let path = no_file("launches_no_map");
    for (more, part) in [
        (&["--spin", "90..300/12", "--plot", "spin,tilt,period"][..], "tilt_deg: must be a key that varies"),
        (
            &["--spin", "1,2", "--tilt", "1..2/2", "--plot", "spin,tilt,period"],
            "spin: must be a key that varies",
        ),
        (&["--spin", "1..2/2", "--tilt", "1..2/2", "--plot", "spin,tilt,colour"], "colour: must be one of"),
        (&["--spin", "1..2/2", "--plot", "spin"], "must be X,Y,COLUMN"),
        (&["--tilt", "1..2"], "tilt_deg: 1..2 in a grid"),
        (&["--axis", "speed=1,2"], "speed: no number of this scenario; allowed: transverse_inertia"),
        (&["--axis", "spin=1,2", "--spin", "3"], "spin: must be one axis only"),
        (&[], "needs at least one of --spin"),
        (&["--e1", "0.5"], "--e1"),
    ] {
        refused(&path, &[&[&*file][..], more].concat(), part);
    }
    let output = run(&words(&path, &["--spin", "1,2"]));
    assert_eq!(output.status.code(), Some(2), "{}{}", stdout(&output), stderr(&output));
}
