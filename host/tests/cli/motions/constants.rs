//! Constants of a motion: keys, regimes, definitions, units and warnings.

use crate::command::{RELEASE, TOP, branch_points, json, number, read, sample, samples, scenario, toytop};

const KEYS: &str = "l n h e1 e2 e3 e4 one_plus_e1 one_minus_e2 e2_minus_e1 e3_minus_e2 e3_minus_one regime period \
                    alpha_turns beta_turns phi_per_period tip_class min_normal_force min_tilt_deg max_tilt_deg nutation_hz \
                    mean_precession_deg_per_s mean_precession_rpm spin_deg_per_s spin_rpm critical_spin_deg_per_s critical_spin_rpm";

#[test]
fn constants_have_the_keys_of_the_contract() {
    let hanging = RELEASE.replace("40", "180").replace("precession = 0.3", "");
    let at_rest = branch_points([0.2, 1.0, 1.0], 1) + "nutation_phase = 3.141592653589793";
    let upright = "phi_per_period mean_precession_deg_per_s mean_precession_rpm";
    let rest = "period alpha_turns beta_turns nutation_hz phi_per_period mean_precession_deg_per_s mean_precession_rpm";
    // file, regime, tip class, keys that are null
    for (file, regime, tip_class, nulls) in [
        ("@toy_top", "nutating", "cusp", ""),
        ("@figure_3_cusp", "nutating", "cusp", ""),
        ("@lagrange", "nutating", "loops", "e4 min_normal_force"),
        ("@sleeping", "sleeping_stable", "point", upright),
        (&scenario("c1", &format!("{TOP}{hanging}")), "hanging", "point", upright),
        (&scenario("c2", &branch_points([0.2, 1.0, 1.0], 1)), "aperiodic", "spiral", rest),
        (&scenario("c3", &branch_points([0.5, 0.5, 1.7], -1)), "regular_precession", "circle", ""),
        (&scenario("c4", &branch_points([-1.0, 0.6, 1.4], 1)), "nutating", "through_origin", ""),
        (&scenario("c5", &at_rest), "sleeping_unstable", "point", rest),
    ] {
        let constants = json(format!("constants {file}"));
        assert_eq!(constants["regime"], regime, "{file}");
        assert_eq!(constants["tip_class"], tip_class, "{file}");
        let text = toytop(format!("constants {file} --format json")).out;
        let csv = toytop(format!("constants {file} --format csv")).ok();
        let [header, values] = csv.lines().collect::<Vec<_>>()[..] else { panic!("{file}: {csv}") };
        assert_eq!(header.replace(',', " "), KEYS, "{file}");
        let table = toytop(format!("constants {file}")).ok();
        let mut end = 0;
        for ((key, value), line) in KEYS.split(' ').zip(values.split(',')).zip(table.lines()) {
            // the order is that of the contract
            end += text[end..].find(&format!("\"{key}\":")).unwrap_or_else(|| panic!("{file}: {key}"));
            assert_eq!(constants[key].is_null(), nulls.split(' ').any(|null| null == key), "{file}: {key}");
            let is_same = match constants[key].as_f64() {
                Some(x) => value.parse() == Ok(x),
                None => constants[key].as_str().unwrap_or_default() == value,
            };
            assert!(is_same && line.starts_with(key), "{file}: {key}: {value} {line}");
        }
        assert_eq!(constants.as_object().map(|object| object.len()), Some(KEYS.split(' ').count()), "{file}");
    }
}

/// The toy top is released at 20 degrees with 150 rad/s; the upright top is stable above 2 sqrt(A p g)/C.
#[test]
fn constants_in_degrees_and_turns() {
    let constants = json("constants @toy_top");
    let value = |key: &str| number(&constants[key]);
    for (key, expected) in [
        ("min_tilt_deg", 20.0),
        ("max_tilt_deg", value("e1").acos().to_degrees()),
        ("nutation_hz", 1.0 / value("period")),
        ("mean_precession_deg_per_s", value("phi_per_period").to_degrees() / value("period")),
        ("mean_precession_rpm", value("mean_precession_deg_per_s") / 6.0),
        ("spin_deg_per_s", 150_f64.to_degrees()),
        ("spin_rpm", 150.0 * 30.0 / std::f64::consts::PI),
        ("critical_spin_deg_per_s", (2.0 * (3e-5 * 0.0015 * 9.81_f64).sqrt() / 2e-5).to_degrees()),
        ("critical_spin_rpm", value("critical_spin_deg_per_s") / 6.0),
    ] {
        assert!((value(key) / expected - 1.0).abs() < 1e-12, "{key}: {} {expected}", value(key));
    }
    // spins on both sides of the critical one
    let text = read(&sample("sleeping"));
    let critical = number(&json("constants @sleeping")["critical_spin_deg_per_s"]).to_radians();
    let line = text.lines().find(|line| line.starts_with("spin")).expect("a spin");
    for (factor, regime) in [(1.001, "sleeping_stable"), (0.999, "sleeping_unstable")] {
        let spun = scenario("critical", &text.replace(line, &format!("spin = {}", factor * critical)));
        assert_eq!(json(format!("constants {spun}"))["regime"], regime);
    }
}

/// A scenario without units prints none.
#[test]
fn units_are_named_only_where_there_are_any() {
    let text = read(&sample("toy_top"));
    let [si, none, wrong] = ["SI", "none", "feet"]
        .map(|units| scenario(&format!("units_{units}"), &format!("units = \"{units}\"\n{text}")));
    let units = |line: String| {
        let text = toytop(line).ok();
        let words = text.split(|c: char| c.is_whitespace() || "[],^2/".contains(c));
        words.filter(|word| ["kg", "m", "s"].contains(word)).count()
    };
    for command in ["constants", "state --times=0,1"] {
        assert!(units(format!("{command} {si}")) > 1, "{command}");
        assert_eq!(units(format!("{command} {none}")), 0, "{command}");
    }
    toytop(format!("constants {wrong}")).refused(2, "units: must be one of \"SI\", \"none\"");
}

#[test]
fn numbers_have_seventeen_digits() {
    let json = toytop("constants @figure_3_cusp --format json").ok();
    assert!(json.contains("\"e1\":6.9999999999999996e-1,"), "{json}");
    let csv = toytop("state @figure_3_cusp --times=0,1 --format csv").ok();
    let lines: Vec<_> = csv.lines().map(|line| line.split(',').count()).collect();
    assert_eq!(lines, [18, 18, 18]);
    for number in csv.lines().skip(1).flat_map(|line| line.split(',')) {
        let mantissa = number.trim_start_matches('-').split('e').next();
        assert_eq!(mantissa.map(str::len), Some(18), "{number}");
    }
}

/// A pendulum that is released at rest stays in a plane, so that nothing turns about the vertical; its precession does not consist of rounding
/// errors. With the least momentum about the vertical it precesses.
#[test]
fn a_plane_pendulum_does_not_precess() {
    let text = read(&sample("pendulum"));
    let pushed = scenario("pendulum_pushed", &text.replace("spin = 0", "spin = 0\nprecession = 1e-9"));
    for (file, is_plane) in [("@pendulum", true), (&pushed, false)] {
        let constants = json(format!("constants {file}"));
        for key in [
            "alpha_turns",
            "beta_turns",
            "phi_per_period",
            "mean_precession_deg_per_s",
            "mean_precession_rpm",
        ] {
            assert_eq!(number(&constants[key]) == 0.0, is_plane, "{key}: {constants}");
        }
        assert!(number(&constants["period"]) > 1.0, "{constants}");
        // the azimuth of the tip stays where it began
        let samples = samples(format!("{file} --times 0,0.3,0.7,1.6,40 --columns phi"));
        let stays = samples.iter().all(|row| (number(&row["phi"]) - std::f64::consts::PI).abs() < 1e-14);
        assert_eq!(stays, is_plane, "{samples:?}");
    }
}

/// Each warning about a real top is one line on stderr.
#[test]
fn each_warning_about_real_tops_is_one_line() {
    let still = RELEASE.replace("40", "0").replace("3.5", "0.5").replace("precession = 0.3", "");
    let lifts = "a real top would leave the plane (least normal force / weight)";
    for (name, text, warning) in [
        ("lift_off", branch_points([0.7, 0.9, 100.0], 1), format!("{lifts}: lift_off (-")),
        ("fall", branch_points([-0.5, 0.9, 1.1], 1), "a real top would fall on its side (greatest tilt, degrees): fall (120.0)".into()),
        // a force just below 0 gives a warning, with any number of digits
        ("mild", branch_points([0.5, 0.8, 10.4], 1), format!("{lifts}: mild (-0.201)")),
        ("just_off", branch_points([0.5, 0.8, 8.790_124_5], 1), format!("{lifts}: just_off (-1.3e-7)")),
        // an unstable sleeping top stays upright, although its e1 is below 0
        ("unstable", format!("{TOP}{still}"), "by the equations the axis stays upright, but the motion is unstable (a real top would fall): unstable\n".into()),
    ] {
        let file = scenario(name, &text);
        for line in [
            format!("constants {file}"),
            format!("constants {file} --format json"),
            format!("state {file} --times 1"),
            format!("state {file} --times 1 --format csv"),
            format!("compare {file} --format csv"),
        ] {
            let run = toytop(&line);
            let warnings = |text: &str| text.lines().filter(|line| line.starts_with("warning: ")).count();
            assert_eq!((warnings(&run.err), warnings(&run.out)), (1, 0), "{line}");
            assert!(run.err.contains(&format!("warning: {warning}")), "{}", run.err);
        }
    }
    let zero = "[top]\nmass_moment = 1\ncom_height = 1\ntransverse_inertia = 1\naxial_inertia = 1\ngravity = 1\n\
                [motion]\nkind = \"release\"\ntilt_deg = 0\nspin = 5\nnutation = 1\n";
    let held = read(&sample("lagrange"));
    for (file, force) in [
        ("@toy_top", None),
        (&scenario("just_on", &branch_points([0.5, 0.8, 8.790_123], 1)), None),
        (&scenario("zero", zero), Some(0.0)),
        // a held top does not fall
        (&scenario("held", &held.replace("tilt_deg = 20.0", "tilt_deg = 120.0")), None),
    ] {
        assert_eq!(toytop(format!("constants {file} --format json")).err, "", "{file}");
        let constants = json(format!("constants {file}"));
        assert!(force.is_none() || constants["min_normal_force"].as_f64() == force, "{constants}");
    }
}
