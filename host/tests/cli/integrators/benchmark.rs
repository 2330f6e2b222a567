//! `toytop benchmark` and `score --benchmark`.

use crate::command::{json, list, number, read, repository, toytop, write};
use serde_json::Value;

fn names() -> Vec<String> {
    let problems = json("benchmark");
    let name = |problem: &Value| problem["benchmark"].as_str().expect("a name").to_owned();
    list(&problems["problems"]).iter().map(name).collect()
}

/// The printed scenario can be read, and its table reaches the 30 digits of every problem, in the axes of the source.
#[test]
fn the_scenario_agrees_with_the_reference_digits() {
    // errors of the position, the quaternion and the angular velocity; the first and the last in units of its length
    let mut worst = [0.0_f64; 3];
    for name in names() {
        let text = toytop(format!("benchmark {name} --scenario")).ok();
        toytop(format!("constants {}", write(&format!("{name}_printed.toml"), text))).ok();
        let digits = json(format!("benchmark {name}"));
        for sample in list(&digits["samples"]) {
            let t = sample["t"].as_str().expect("a time");
            let ours = &json(format!("benchmark {name} --times={t}"))["samples"][0];
            let pairs = |keys: &'static str| {
                keys.split(' ').map(|key| {
                    let truth: f64 = sample[key].as_str().expect("digits").parse().expect("a number");
                    (truth, number(&ours[key]))
                })
            };
            let off = |keys, sign: f64| pairs(keys).map(|(x, y)| (x - sign * y).abs()).fold(0.0, f64::max);
            let relative = |keys| {
                let length = pairs(keys).map(|(x, _)| x * x).sum::<f64>().sqrt();
                if length > 0.0 { off(keys, 1.0) / length } else { off(keys, 1.0) }
            };
            let quaternion = off("w x y z", 1.0).min(off("w x y z", -1.0));
            for (worst, error) in
                worst.iter_mut().zip([relative("x_com y_com z_com"), quaternion, relative("wx wy wz")])
            {
                assert!(error.is_finite(), "{name} at {t}");
                *worst = worst.max(error);
            }
        }
    }
    let ranges = [[3e-16, 2e-15], [2e-14, 1e-13], [8e-16, 5e-15]];
    let is_within = |(error, [least, most]): (f64, [f64; 2])| error > least && error < most;
    assert!(worst.into_iter().zip(ranges).all(is_within), "{worst:?}");
}

/// A run in the source's axes has no error, and one in other axes has a large error.
#[test]
fn a_run_is_judged_in_the_axes_of_its_source() {
    let scored = |of: &str, judged_as: &str| {
        let rows = toytop(format!("benchmark {of} --times=0..0.4/41 --format csv")).ok();
        let file = format!("{of}_as_{judged_as}.csv");
        let score = json(format!("score --benchmark {judged_as} {}", write(&file, rows)));
        assert_eq!(score["scenario"], judged_as);
        number(&score["files"][0]["max_error_rad"])
    };
    let worst = names().iter().map(|name| scored(name, name)).fold(0.0, f64::max);
    assert!(worst > 3e-16 && worst < 3e-15, "{worst:e}");
    assert!(scored("parker", "bruls_cardona") > 0.1, "the rows of one problem are no run of another");
}

/// The pages contain the digits.
#[test]
fn the_pages_have_the_digits() {
    for name in names() {
        let page = read(&repository(&format!("host/problems/{name}/README.md")));
        let digits = json(format!("benchmark {name}"));
        for sample in list(&digits["samples"]) {
            let numbers: Vec<_> =
                sample.as_object().expect("an object").values().filter_map(Value::as_str).collect();
            assert_eq!(numbers.len(), 11, "{name}");
            for number in numbers {
                assert!(page.contains(number), "{name}: {number}");
            }
        }
    }
}
