//! `toytop events`.

use crate::command::{branch_points, json, list, number, numbers, samples, scenario, toytop};
use serde_json::Value;

fn events(arguments: &str) -> Vec<Value> {
    list(&json(format!("events {arguments}"))["events"]).to_vec()
}

/// The toy top is released from rest at 20 degrees: its tilt turns at t = 0, and then every half period.
#[test]
fn turning_points_are_half_a_period_apart() {
    let found = events("@toy_top --count 5");
    let half = 0.5 * number(&json("constants @toy_top")["period"]);
    assert_eq!(found[0]["t"], 0.0);
    for (index, event) in found.iter().enumerate() {
        assert!((number(&event["t"]) - half * index as f64).abs() < 1e-15, "{event}");
        assert_eq!(event["sense"], if index % 2 == 0 { "upper" } else { "lower" });
    }
    assert!((number(&found[0]["tilt_deg"]) - 20.0).abs() < 1e-12);
    // the same is true a million seconds later, and no event is before the requested time
    let late = number(&events("@toy_top --from 1e6 --count 3")[0]["t"]);
    assert!(late >= 1e6 && late < 1e6 + half, "{late:?}");
}

/// The numbers of an event agree with those of `state` at its time.
#[test]
fn the_state_at_an_event_is_what_was_asked_for() {
    let kinds = "tilt=40,tilt=35:up,tip-angle=90,tip-angle=-45,circle=0.6";
    let found = events(&format!("@figure_3_loops --kind {kinds} --count 40"));
    assert_eq!(found.len(), 40);
    let times: Vec<_> = found.iter().map(|event| number(&event["t"])).collect();
    assert!(times.is_sorted());
    let list: Vec<_> = times.iter().map(|t| format!("{t:e}")).collect();
    let states = samples(format!("@figure_3_loops --times={}", list.join(",")));
    let mut seen = std::collections::BTreeSet::new();
    for (event, state) in found.iter().zip(states) {
        let [u, udot, x, y] = numbers(&state, "u udot tip")[..] else { panic!("{state}") };
        let kind = event["kind"].as_str().expect("a kind");
        seen.insert(kind.to_owned());
        let off = match kind {
            "tilt=40" => u - 40_f64.to_radians().cos(),
            "tilt=35:up" => u - 35_f64.to_radians().cos(),
            "circle=0.6" => x.hypot(y) - 0.6,
            "tip-angle=90" => x.hypot(y.min(0.0)),
            _ => (x + y).hypot(x.min(0.0)),
        };
        assert!(off.abs() < 1e-12, "{event}: {off:e}");
        assert!(!kind.ends_with(":up") || event["sense"] == "up" && udot > 0.0, "{event}");
        let error = number(&event["time_error"]);
        assert!(error > 0.0 && error < 1e-11, "{event}");
    }
    assert_eq!(seen.len(), 5, "{seen:?}");
}

/// A real top leaves the plane while it rises; one with a lower e3 never does; a held one cannot.
#[test]
fn a_top_lifts_off_where_the_force_is_zero() {
    let lifting = |e3: f64| {
        let text = branch_points([0.5, 0.8, e3], 1);
        let (_, motion) = text.split_once("[motion]").expect("a motion");
        let top = "[top]\nmass_moment = 1\ncom_height = 1\ntransverse_inertia = 1\naxial_inertia = 1\ngravity = 1\n";
        scenario(&format!("lifts_{e3}"), &format!("units = \"none\"\n{top}[motion]{motion}"))
    };
    let lifts = lifting(10.4);
    let up = events(&format!("{lifts} --kind lift-off:up --count 3"));
    assert!(up.len() == 3 && up.iter().all(|event| event["sense"] == "up"));
    let u = number(&up[0]["u"]);
    assert!(u > 0.5 && u < 0.8, "{u}");
    // N = 1 + s u'', where u'' is a difference quotient of u'
    let t = number(&up[0]["t"]);
    let states = samples(format!("{lifts} --times={:e},{:e}", t - 1e-5, t + 1e-5));
    let rate = |i: usize| number(&states[i]["udot"]);
    assert!((1.0 + (rate(1) - rate(0)) / 2e-5).abs() < 1e-6);
    assert_eq!(toytop(format!("events {} --kind lift-off", lifting(2.0))).ok(), "no such event\n");
    toytop("events @lagrange --kind lift-off").refused(3, "does not slide on a plane");
}

/// A regular precession has no turning points, which the table states.
#[test]
fn events_that_do_not_occur_give_an_empty_list() {
    assert!(events("@sleeping").is_empty());
    for line in ["@sleeping", "@toy_top --kind tilt=60"] {
        assert!(toytop(format!("events {line}")).ok().starts_with("no such event\n"), "{line}");
    }
    // CSV has its header
    let header = "t,kind,sense,u,tilt_deg,tip_x,tip_y,phi_deg,time_error\n";
    assert_eq!(toytop("events @sleeping --format csv").ok(), header);
    assert_eq!(events("@toy_top --kind tilt=60,tilt=21 --count 2").len(), 2);
    // a regular precession goes round in one sense for ever
    let circle = scenario("events_circle", &branch_points([0.5, 0.5, 1.7], 1));
    let mut counts =
        ["up", "down"].map(|way| events(&format!("{circle} --kind tip-angle=90:{way} --count 3")).len());
    counts.sort_unstable();
    assert_eq!(counts, [0, 3]);
    let csv = toytop("events @toy_top --kind turning,tilt=20.5 --count 4 --format csv").ok();
    assert!(csv.starts_with("t,kind,sense,u,tilt_deg,tip_x,tip_y,phi_deg,time_error\n"), "{csv}");
    assert_eq!(csv.lines().count(), 5);
}
