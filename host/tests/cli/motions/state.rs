//! Samples of `toytop state`: their shape, the start, continuity, both directions of time, every method and scalar.

use crate::command::{RELEASE, TOP, branch_points, motion_without_table, numbers, samples, scenario, toytop};
use serde_json::Value;

const COMPARED_KEYS: &str = "u udot alpha beta quaternion omega tip";

/// Greatest difference of two samples in the numbers of these keys.
fn distance(a: &Value, b: &Value, keys: &str) -> f64 {
    numbers(a, keys).iter().zip(numbers(b, keys)).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

/// Product αβ of a sample.
fn product(sample: &Value) -> [f64; 2] {
    let [a, b, c, d] = numbers(sample, "alpha beta")[..] else { panic!("{sample}") };
    [a * c - b * d, a * d + b * c]
}

#[test]
fn a_sample_has_the_shape_of_the_contract() {
    let file = scenario("shape", &format!("{TOP}{RELEASE}"));
    let text = toytop(format!("state {file} --times 0.7 --format json")).ok();
    let keys = "t u udot alpha beta quaternion omega tip phi error_bound gamma delta";
    let places: Vec<_> = keys.split(' ').map(|key| text.find(&format!("\"{key}\":"))).collect();
    assert!(places.is_sorted() && places[0] == Some(r#"{"samples":[{"#.len()), "{text}");
    assert!(text.ends_with("}]}\n"), "{text}");
    let sample = &samples(format!("{file} --times 0.7"))[0];
    assert_eq!(sample.as_object().map(|object| object.len()), Some(12), "{text}");
    let [ar, ai, br, bi] = numbers(sample, "alpha beta")[..] else { panic!("two complex numbers: {text}") };
    assert_eq!(numbers(sample, "quaternion"), [ar, bi, -br, ai]);
    assert_eq!(numbers(sample, "gamma delta"), [-br, bi, ar, -ai]);
    assert_eq!([numbers(sample, "omega").len(), numbers(sample, "tip").len()], [3, 2]);
    let by_name = &samples(format!("{file} --times 0.7 --columns u"))[0];
    assert_eq!(by_name.as_object().map(|object| object.len()), Some(2), "{by_name}");
    let bound = numbers(by_name, "error_bound")[0];
    assert!((1e-16..1e-14).contains(&bound), "{bound:e}");
    let tip = product(sample).map(|x| 1.2 * x);
    assert!(numbers(sample, "tip").iter().zip(tip).all(|(c, expected)| (c - expected).abs() < 1e-15));
}

#[test]
fn the_start_is_the_release_of_the_contract() {
    let release = "tilt_deg = 40\nspin = 3.5\nprecession = 0.3\nnutation = -0.2\nazimuth_deg = 720000000430\nroll_deg = -25\n";
    let file = scenario("release", &format!("{TOP}[motion]\nkind = \"release\"\n{release}"));
    // two whole turns, which change nothing, lose no digits
    let [tilt, azimuth, roll] = [40_f64, 430.0, -25.0].map(f64::to_radians);
    let [(sine, cosine), half_sum, half_difference] =
        [tilt / 2.0, (azimuth + roll) / 2.0, (azimuth - roll) / 2.0].map(f64::sin_cos);
    let axial = 3.5 - 0.3 * tilt.cos();
    let expected = [
        cosine * half_sum.1,
        cosine * half_sum.0,
        -sine * half_difference.1,
        -sine * half_difference.0,
        axial * tilt.sin() * azimuth.cos() + 0.2 * azimuth.sin(),
        axial * tilt.sin() * azimuth.sin() - 0.2 * azimuth.cos(),
        axial * tilt.cos() + 0.3,
    ];
    for method in ["ephemeris", "stepper", "full"] {
        let start = &samples(format!("{file} --times 0 --method {method}"))[0];
        let found = numbers(start, "alpha beta omega");
        assert!(found.iter().zip(expected).all(|(x, y)| (x - y).abs() < 3e-15), "{found:?} {expected:?}");
        // the tip is opposite to the direction in which the axis leans: -110 degrees
        assert!((numbers(start, "phi")[0] + 110_f64.to_radians()).abs() < 1e-14);
    }
    // exactly downward and exactly upright
    for (degrees, u) in [("180", -1.0), ("180.0", -1.0), ("0", 1.0)] {
        let file = scenario("vertical", &format!("{TOP}{}", RELEASE.replace("40", degrees)));
        let start = &samples(format!("{file} --times 0"))[0];
        assert_eq!(numbers(start, "u tip"), [u, 0.0, 0.0]);
        assert!(start["phi"].is_null());
    }
}

#[test]
fn times_come_in_the_order_of_the_request() {
    let asked = [0.31, -0.2, 0.0, 0.31, 1.0, -1.5, 1e-9];
    let together = samples(format!("@toy_top --times={}", asked.map(|t| t.to_string()).join(",")));
    for (t, sample) in asked.iter().zip(&together) {
        assert_eq!(sample["t"].as_f64(), Some(*t));
        // a single time is reached by other steps, with the same result
        let alone = &samples(format!("@toy_top --times={t}"))[0];
        assert!(distance(sample, alone, "alpha beta phi") < 1e-12, "t = {t}");
    }
    assert_eq!(together[0], together[3]);
    let path = scenario("times", &format!("# seconds\n\n{}", asked.map(|t| format!(" {t} # s\n")).concat()));
    assert_eq!(samples(format!("@toy_top --times-file {path}")), together);
}

/// Each method computes the motion by itself, so that the samples differ by roundings, and the tip angle is that of the table.
/// `tests/suite/closed_forms/methods_agree.rs` compares the core's methods on every kind of motion.
#[test]
fn each_method_is_another_way_to_one_motion() {
    let start = "nutation_phase = 0.7\narg_alpha = 2.9\narg_beta = 1.1\n";
    let e4 = (1.0 + 1.1 / (0.9 * 0.6_f64)).sqrt();
    let downward = branch_points([-1.0, 0.8, e4], -1);
    let aperiodic = branch_points([-0.3, 1.0, 1.0], 1).replace("com_height = 0.6", "support = \"fixed\"");
    for (name, text) in [("downward", downward), ("aperiodic", aperiodic)] {
        let file = scenario(name, &(text + start));
        let by = |method: &str| samples(format!("{file} --times=-9.96..9.96/25 --method {method}"));
        let closed = by("closed-form");
        for method in ["stepper", "full"] {
            let found = by(method);
            let errors =
                closed.iter().zip(&found).map(|(ours, theirs)| distance(ours, theirs, COMPARED_KEYS));
            let worst = errors.fold(0.0, f64::max);
            assert!((1e-16..1e-12).contains(&worst), "{name}, {method}: {worst:e}");
            for (ours, theirs) in closed.iter().zip(&found) {
                // the angle is known to the rounding of c divided by |c|
                let [x, y] = numbers(ours, "tip")[..] else { panic!("two numbers") };
                assert!(distance(ours, theirs, "phi") < 1e-12 / x.hypot(y).min(1.0), "{name}, {method}");
            }
        }
    }
    // a vertical axis has no tip angle
    assert!(samples("@sleeping --times 0.5 --method closed-form")[0]["phi"].is_null());
}

/// No table follows this motion. Only whole turns of the tip angle would come from one.
#[test]
fn the_full_equations_need_no_table() {
    let file = motion_without_table("state_without_table");
    let full = samples(format!("{file} --times 1e-3 --method full")).remove(0);
    let norm: f64 = numbers(&full, "alpha beta").iter().map(|x| x * x).sum();
    assert!((norm - 1.0).abs() < 1e-14, "{norm}");
    assert!(full["phi"].is_null());
}

#[test]
fn where_the_tip_is_at_the_centre_phi_goes_on_smoothly() {
    let file = scenario("centre", &(branch_points([-1.0, 0.6, 1.4], 1) + "arg_beta = 0.7\n"));
    for method in ["ephemeris", "stepper", "full"] {
        let passing = samples(format!("{file} --times=-1e-4,0,1e-4 --method {method}"));
        let [before, at, after] = [0, 1, 2].map(|i| numbers(&passing[i], "phi")[0]);
        assert!((before - at).abs() < 1e-3 && (after - at).abs() < 1e-3, "{method}: {before} {at} {after}");
    }
}

/// Numbers have the bits of the scalar, and an error of its size.
#[test]
fn every_scalar_has_its_bits() {
    let file = scenario("scalars", &format!("{TOP}{RELEASE}"));
    // limits of the error, the numbers in the scalar, and their last bit in fixed point
    for (how, [least, most], keys, bits) in [
        ("ephemeris --scalar f32", [1e-9, 1e-4], "alpha beta omega", None),
        ("stepper --scalar f32", [1e-9, 1e-5], "alpha beta", None),
        ("ephemeris --scalar q31", [1e-10, 2e-8], "alpha beta u", Some(30)),
        ("ephemeris --scalar q15", [1e-6, 3e-4], "alpha beta u", Some(14)),
    ] {
        let at = |how: &str| samples(format!("{file} --times=-0.7,0.3,2.5 --method {how}"));
        let is_narrow = |x: &f64| match bits {
            Some(bits) => (x * 2_f64.powi(bits)).fract() == 0.0,
            None => f64::from(*x as f32) == *x,
        };
        for (exact, found) in at("ephemeris").iter().zip(at(how)) {
            assert_eq!(exact["t"], found["t"]);
            assert!(numbers(&found, keys).iter().all(is_narrow), "{how}: {found}");
            assert!(!numbers(exact, "alpha beta").iter().all(is_narrow), "{exact}");
            let error = distance(exact, &found, "alpha beta");
            assert!(error > least && error < most, "{how}: {error:e}");
            // the rates are rounded to f32
            assert!(
                bits.is_none() || distance(exact, &found, "omega tip udot") < 25.0 * most,
                "{how}: {found}"
            );
        }
    }
}

/// Rounding of α and β must not give |u| > 1, for which the arc cosine is NaN.
#[test]
fn the_cosine_of_the_tilt_is_one() {
    let mut vertical = 0;
    for how in [
        "ephemeris",
        "ephemeris --scalar f32",
        "ephemeris --scalar q31",
        "ephemeris --scalar q15",
        "stepper",
        "stepper --scalar f32",
        "full",
        "closed-form",
    ] {
        for sample in samples(format!("@sleeping --times 0,0.1,0.33,1,2.7,10,55,300 --method {how}")) {
            let u = numbers(&sample, "u")[0];
            assert!(u <= 1.0 && u > 0.99, "{how}: {u:?}");
            vertical += usize::from(u == 1.0);
        }
    }
    assert!(vertical > 0);
}

/// The tip of a held top in `state` is minus the horizontal part of the axis, which the help text states with the units.
#[test]
fn a_held_tip_is_minus_the_horizontal_part_of_the_axis() {
    for sample in samples("@lagrange --times 0,0.3,7") {
        let tip = numbers(&sample, "tip");
        assert!(product(&sample).iter().zip(tip).all(|(part, x)| (x - 2.0 * part).abs() < 1e-15), "{sample}");
    }
    let help = toytop("state --help").ok();
    let stated = "minus the horizontal part of the axis";
    for part in [stated, "t in s", "omega in rad/s", "tip in m", "phi in rad"] {
        assert!(help.contains(part), "{part}");
    }
    let [held, sliding] =
        ["lagrange", "toy_top"].map(|name| toytop(format!("state @{name} --times 0.3")).ok());
    assert!(held.contains(stated) && !sliding.contains("minus the horizontal"), "{held} {sliding}");
}

/// Keys that a free body does not need are allowed and have no effect.
#[test]
fn a_free_body_needs_no_mass() {
    let free = "[top]\nsupport = \"free\"\ntransverse_inertia = 7.5e-5\naxial_inertia = 2.0e-5\n\
                [motion]\nkind = \"release\"\ntilt_deg = 20.0\nspin = 150.0\nnutation = 0.5\n";
    let with_more = free.replace("[motion]", "mass = 2\ncom_height = 0.1\ngravity = 1.6\n[motion]");
    let [states, again] = [("free_body", free), ("free_body_with_more", &with_more)]
        .map(|(name, text)| samples(format!("{} --times 0,1,10", scenario(name, text))));
    assert_eq!(states, again);
}

/// At times that no stepper reaches, φ grows at the constant rate (l + n)/(4A) after the axis has risen.
#[test]
fn an_aperiodic_motion_goes_on_for_ever() {
    let file = scenario("tip_angle_for_ever", &branch_points([0.2, 1.0, 1.0], 1));
    let states = samples(format!("{file} --times=1000,1e9,-1000,-1e9 --columns phi"));
    // l + n = √(2Ap(1+e1)(1+e2)(1+e3))
    let rate = (2.0 * 1.1 * 0.9 * 1.2 * 4.0_f64).sqrt() / 4.4;
    for pair in states.chunks(2) {
        let growth = (numbers(&pair[1], "phi")[0] - numbers(&pair[0], "phi")[0]).abs() / (1e9 - 1e3);
        assert!((growth / rate - 1.0).abs() < 1e-15, "{growth} {rate}");
    }
}
