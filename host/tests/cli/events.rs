//! Tests of `toytop events`.

use crate::program::{json, run, stderr, stdout};
use crate::scratch::{sample, scenario};
use serde_json::Value;

fn events(arguments: &[&str]) -> Vec<Value> {
    let found = json(&[&["events"], arguments, &["--format", "json"]].concat());
    found["events"].as_array().expect("events").clone()
}

fn numbers(events: &[Value], key: &str) -> Vec<f64> {
    events.iter().map(|event| event[key].as_f64().unwrap_or_else(|| panic!("{key}: {event}"))).collect()
}

/// The toy top is released from rest at 20 degrees: its tilt turns at t = 0, and then every half period.
#[test]
fn turning_points_are_half_a_period_apart() {
    let file = sample("toy_top");
    let found = events(&[&file, "--count", "5"]);
    let period = json(&["constants", &file, "--format", "json"])["period"].as_f64().expect("a period");
    assert_eq!(found[0]["t"], 0.0);
    for (index, event) in found.iter().enumerate() {
        let t = event["t"].as_f64().expect("a time");
        assert!((t - 0.5 * period * index as f64).abs() < 1e-15, "{event}");
        assert_eq!(event["sense"], if index % 2 == 0 { "upper" } else { "lower" });
    }
    assert!((numbers(&found, "tilt_deg")[0] - 20.0).abs() < 1e-12);
    // the same is true a million seconds later, and no event is before the requested time
    let late = events(&[&file, "--from", "1e6", "--count", "3"]);
    let times = numbers(&late, "t");
    assert!(times[0] >= 1e6 && times[0] < 1e6 + 0.5 * period, "{times:?}");
}

/// The numbers of an event agree with those of `state` at its time.
#[test]
fn the_state_at_an_event_is_what_was_asked_for() {
    let file = sample("figure_3_loops");
    let kinds = "tilt=40,tilt=35:up,tip-angle=90,tip-angle=-45,circle=0.6";
    let found = events(&[&file, "--kind", kinds, "--count", "40"]);
    assert_eq!(found.len(), 40);
    let times = numbers(&found, "t");
    assert!(times.windows(2).all(|pair| pair[0] <= pair[1]));
    let list: Vec<_> = times.iter().map(|t| format!("{t:e}")).collect();
    let states = json(&["state", &file, &format!("--times={}", list.join(",")), "--format", "json"]);
    let mut seen = std::collections::BTreeSet::new();
    for (event, state) in found.iter().zip(states["samples"].as_array().expect("samples")) {
        let value = |key: &str| state[key].as_f64().expect("a number");
        let kind = event["kind"].as_str().expect("a kind");
        seen.insert(kind.to_owned());
        let tip = [0, 1].map(|i| state["tip"][i].as_f64().expect("a number"));
        let off = match kind {
            "tilt=40" => value("u") - 40_f64.to_radians().cos(),
            "tilt=35:up" => value("u") - 35_f64.to_radians().cos(),
            "circle=0.6" => tip[0].hypot(tip[1]) - 0.6,
            "tip-angle=90" => tip[0].hypot(tip[1].min(0.0)),
            _ => (tip[0] + tip[1]).hypot(tip[0].min(0.0)),
        };
        assert!(off.abs() < 1e-12, "{event}: {off:e}");
        assert!(!kind.ends_with(":up") || event["sense"] == "up" && value("udot") > 0.0, "{event}");
        assert!(event["time_error"].as_f64().is_some_and(|error| error > 0.0 && error < 1e-11), "{event}");
    }
    assert_eq!(seen.len(), 5, "{seen:?}");
}

const LIFTING: &str = "units = \"none\"\n[top]\nmass_moment = 1\ncom_height = 1\ntransverse_inertia = 1\naxial_inertia = 1\n\
                       gravity = 1\n[motion]\nkind = \"branch_points\"\ne1 = 0.5\ne2 = 0.8\ne3 = 10.4\n\
                       sign_l_plus_n = 1\nsign_l_minus_n = 1\n";

/// A real top leaves the plane while it rises; one with a lower e3 never does; a held one cannot.
#[test]
fn a_top_lifts_off_where_the_force_is_zero() {
    let lifts = scenario("lifts", LIFTING);
    let up = events(&[&lifts, "--kind", "lift-off:up", "--count", "3"]);
    assert!(up.len() == 3 && up.iter().all(|event| event["sense"] == "up"));
    let u = numbers(&up, "u")[0];
    assert!(u > 0.5 && u < 0.8, "{u}");
    // N = 1 + s u'', where u'' is a difference quotient of u'
    let t = numbers(&up, "t")[0];
    let times = format!("--times={:e},{:e}", t - 1e-5, t + 1e-5);
    let states = json(&["state", &lifts, &times, "--format", "json"]);
    let rate = |i: usize| states["samples"][i]["udot"].as_f64().expect("a number");
    assert!((1.0 + (rate(1) - rate(0)) / 2e-5).abs() < 1e-6);
    let stays = scenario("stays", &LIFTING.replace("10.4", "2.0"));
    assert_eq!(stdout(&run(&["events", &stays, "--kind", "lift-off"])), "no such event\n");
    let held = run(&["events", &sample("lagrange"), "--kind", "lift-off"]);
    assert_eq!((held.status.code(), stdout(&held)), (Some(3), ""));
    assert!(stderr(&held).contains("does not slide on a plane"), "{}", stderr(&held));
}

/// A regular precession has no turning points, which the table states.
#[test]
fn events_that_do_not_occur_give_an_empty_list() {
    let asleep = sample("sleeping");
    assert!(events(&[&asleep]).is_empty());
    assert!(stdout(&run(&["events", &asleep])).starts_with("no such event\n"));
    // a tilt that is sought in vain
    let top = sample("toy_top");
    for (file, kind, expected) in [
        (&top, "tilt=60", "no such event: the tilt stays between 20 and 22.234 degrees\n"),
        (&top, "tilt=19.9:up,tilt=23", "no such event: the tilt stays between 20 and 22.234 degrees\n"),
        (&asleep, "tilt=60", "no such event: the tilt stays at 0 degrees\n"),
        (&asleep, "tilt=60,turning", "no such event\n"),
    ] {
        let output = run(&["events", file, "--kind", kind]);
        assert!(stdout(&output).starts_with(expected), "{file} {kind}: {}", stdout(&output));
    }
    assert_eq!(events(&[&top, "--kind", "tilt=60,tilt=21", "--count", "2"]).len(), 2);
    let csv = run(&[
        "events",
        &sample("toy_top"),
        "--kind",
        "turning,tilt=20.5",
        "--count",
        "4",
        "--format",
        "csv",
    ]);
    let lines: Vec<_> = stdout(&csv).lines().collect();
    assert_eq!((lines.len(), lines[0]), (5, "t,kind,sense,u,tilt_deg,tip_x,tip_y,phi_deg,time_error"));
}

#[test]
fn bad_input_is_one_line() {
    let file = sample("toy_top");
    for (arguments, part) in [
        (&["--kind", "tilt"][..], "must be turning, tilt=DEGREES"),
        (&["--kind", "tilt=200"], "must be in [0, 180]"),
        (&["--kind", "circle=-1"], "must be above 0"),
        (&["--kind", "circle=0.04"], "must be above 0 and below 0.03"),
        (&["--kind", "turning:left"], "must be turning"),
        (&["--count", "0"], "1..=1000000"),
        (&["--from", "NaN"], "must be a finite number"),
        (&["--from", "1e300"], "must be within"),
    ] {
        let output = run(&[&["events", &file], arguments].concat());
        assert_eq!((output.status.code(), stdout(&output)), (Some(2), ""), "{arguments:?}");
        assert_eq!(stderr(&output).lines().count(), 1, "{}", stderr(&output));
        assert!(stderr(&output).contains(part), "{}", stderr(&output));
    }
    assert_eq!(run(&["events", "no_such_file.toml"]).status.code(), Some(2));
}
