//! Tests of scenarios whose numbers have units, as `"30 g"`.

use crate::command::{branch_points, numbers, read, samples, scenario, toytop};
use serde_json::Value;

/// Scenario in the units of the keys. Below it are two of the same motion, in decimal units and in units with a factor of π.
const PLAIN: &str = r#"[top]
transverse_inertia = 3.0e-5
axial_inertia = 2.0e-5
com_height = 0.03
mass = 0.05
gravity = 9.81
rotor_momentum = 1e-4
[motion]
kind = "release"
tilt_deg = 20.0
azimuth_deg = 45.0
spin = 150.0
precession = 3.0
"#;
const DECIMAL: &str = r#"[top]
transverse_inertia = "300 g cm^2"
axial_inertia = " 20000  g mm² "
com_height = "3 cm"
mass = "50 g"
gravity = "981 cm/s^2"
rotor_momentum = "1000 g cm^2/s"
[motion]
kind = "release"
tilt = "20 deg"
azimuth = "0.125 turns"
spin = "150 rad/s"
precession = "3e0 rad/s"
"#;
const CIRCULAR: &str = r#"[top]
transverse_inertia = 3.0e-5
axial_inertia = 2.0e-5
mass = 0.05
com_height = "30 mm"
gravity = 9.81
rotor_momentum = 1e-4
[motion]
kind = "release"
tilt = "0.3490658503988659 rad"
azimuth_deg = 45
spin = "1432.3944878270581 rpm"
precession = "171.88733853924697 deg/s"
"#;

fn state(name: &str, text: &str) -> Vec<Value> {
    samples(format!("{} --times=0,1.5", scenario(name, text)))
}

/// Greatest difference of two motions, relative where a number exceeds 1.
fn difference(a: &[Value], b: &[Value]) -> f64 {
    let all = |samples: &[Value]| {
        let keys = "u udot alpha beta quaternion omega tip phi";
        samples.iter().map(|sample| numbers(sample, keys)).collect::<Vec<_>>().concat()
    };
    all(a).iter().zip(all(b)).map(|(x, y)| (x - y).abs() / x.abs().max(1.0)).fold(0.0, f64::max)
}

#[test]
fn units_give_the_motion_of_the_numbers() {
    let plain = state("units_plain", PLAIN);
    assert_eq!(state("units_decimal", DECIMAL), plain);
    let circular = difference(&state("units_circular", CIRCULAR), &plain);
    assert!(circular < 1e-12, "{circular:e}");
    // rates in an array, and angles where there are no units
    let by_state = |omega: &str| {
        let top = PLAIN.split("[motion]").next().expect("a top");
        format!("{top}[motion]\nkind = \"state\"\nalpha = [1, 0]\nbeta = [0, 0]\nomega = {omega}\n")
    };
    let written = state("units_omega", &by_state("[\"360 deg/s\", 1, \"1 turns/s\"]"));
    let turns = std::f64::consts::TAU;
    assert_eq!(written, state("units_no_omega", &by_state(&format!("[{turns:?}, 1, {turns:?}]"))));
    let angle = |angle: &str| {
        format!("units = \"none\"\n{}nutation_phase = {angle}\n", branch_points([0.2, 0.8, 1.5], 1))
    };
    let half = state("units_phase", &angle("\"90 deg\""));
    assert_eq!(half, state("units_no_phase", &angle("1.5707963267948966")));
    assert!(difference(&half, &state("units_other_phase", &angle("1.57"))) > 1e-4);
}

/// A sweep replaces a number with a unit, and every other command reads the same keys.
#[test]
fn every_command_reads_units() {
    let [plain, decimal] =
        [("units_a", PLAIN), ("units_b", DECIMAL)].map(|(name, text)| scenario(name, text));
    for line in [
        "sweep --vary tilt_deg=10,30 --vary mass=0.04..0.06/3 -o -",
        "bake --name top",
        "events --kind turning",
    ] {
        let [plain, decimal] = [&plain, &decimal]
            .map(|file| toytop(format!("{line} {file}")).ok().replace("units_b", "units_a"));
        assert!(plain.lines().count() > 1 && decimal == plain, "{line}:\n{plain}\n{decimal}");
    }
    let [plain, decimal] = [&plain, &decimal].map(|file| {
        toytop(format!("view {file} -o units.html")).ok();
        read("units.html").replace("units_b", "units_a")
    });
    assert!(plain == decimal, "the pages of two scenarios of one motion differ");
}

/// A message names the file, the key and the units.
#[test]
fn wrong_units_are_refused() {
    for (index, (text, from, to, message)) in [
        (DECIMAL, "\"50 g\"", "\"50 g/s\"", "top.mass: \"50 g/s\": must be a number, a space and a unit"),
        (DECIMAL, "\"50 g\"", "\"50g\"", "as \"2.5 kg\"; units: kg, g, mg"),
        (DECIMAL, "\"50 g\"", "\"g\"", "top.mass"),
        (DECIMAL, "\"50 g\"", "\"1e999 g\"", "top.mass"),
        (DECIMAL, "\"50 g\"", "\"-50 g\"", "top.mass: must be"),
        (DECIMAL, "\"150 rad/s\"", "\"150 kg\"", "motion.spin: \"150 kg\""),
        (DECIMAL, "\"150 rad/s\"", "\"150\"", "units: rad/s, deg/s, rpm, turns/s"),
        (
            DECIMAL,
            "\"20 deg\"",
            "20",
            "motion.tilt: must be a text with a unit, as \"20 deg\", or tilt_deg a number",
        ),
        (DECIMAL, "\"20 deg\"", "\"20 m\"", "units: deg, rad, turns"),
        (DECIMAL, "\"20 deg\"", "\"180.5 deg\"", "motion.tilt_deg: must be a number in [0, 180]"),
        (DECIMAL, "tilt =", "tilt_deg = 20\ntilt =", "motion.tilt: allowed only without tilt_deg"),
        (DECIMAL, "tilt =", "tilt_deg =", "motion.tilt_deg: must be"),
        (DECIMAL, "[top]", "units = \"none\"\n[top]", "must be a number, because of units = \"none\""),
        (PLAIN, "kind = \"release\"\ntilt_deg", "kind = \"state\"\ntilt", "motion.azimuth_deg: unknown"),
    ]
    .into_iter()
    .enumerate()
    {
        assert!(text.contains(from), "{from}");
        let file = scenario(&format!("units_wrong_{index}"), &text.replacen(from, to, 1));
        toytop(format!("constants {file}")).refused(2, &format!("{file} ... {message}"));
    }
}
