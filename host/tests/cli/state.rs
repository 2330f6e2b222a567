//! Tests of `toytop state`: order of the samples, continuity, both directions of time, and all methods.

use super::{RELEASE, TOP, branch_points, json, run, sample, samples, scenario, stdout};
use serde_json::Value;

fn numbers(sample: &Value, keys: &[&str]) -> Vec<f64> {
    let number = |value: &Value| value.as_f64().expect("a number");
    keys.iter()
        .flat_map(|key| match &sample[key] {
            Value::Array(parts) => parts.iter().map(number).collect(),
            value => vec![number(value)],
        })
        .collect()
}

const EVERYTHING: [&str; 9] = ["u", "udot", "alpha", "beta", "gamma", "delta", "omega", "tip", "phi"];

fn distance(a: &Value, b: &Value, keys: &[&str]) -> f64 {
    numbers(a, keys).iter().zip(numbers(b, keys)).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

#[test]
fn a_sample_has_the_shape_of_the_contract() {
    let file = scenario("shape", &format!("{TOP}{RELEASE}"));
    let output = run(&["state", &file, "--times", "0.7", "--format", "json"]);
    let mut rest = stdout(&output);
    for part in [
        r#"{"samples":[{"t":"#,
        r#","u":"#,
        r#","udot":"#,
        r#","alpha":["#,
        r#"],"beta":["#,
        r#"],"gamma":["#,
        r#"],"delta":["#,
        r#"],"omega":["#,
        r#"],"tip":["#,
        r#"],"phi":"#,
        "}]}\n",
    ] {
        rest = rest.split_once(part).expect(part).1;
    }
    assert_eq!(rest, "");
    let parsed: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let sample = &parsed["samples"][0];
    let lengths: Vec<_> = ["alpha", "beta", "gamma", "delta", "omega", "tip"]
        .iter()
        .map(|key| sample[key].as_array().map(Vec::len))
        .collect();
    assert_eq!(lengths, [2, 2, 2, 2, 3, 2].map(Some));
    let [ar, ai, br, bi, cr, ci, dr, di] = numbers(sample, &["alpha", "beta", "gamma", "delta"])[..] else {
        panic!("four complex numbers");
    };
    assert_eq!([cr, ci, dr, di], [-br, bi, ar, -ai]);
    let tip = [1.2 * (ar * br - ai * bi), 1.2 * (ar * bi + ai * br)];
    assert!(numbers(sample, &["tip"]).iter().zip(tip).all(|(c, expected)| (c - expected).abs() < 1e-15));
}

#[test]
fn the_start_is_the_release_of_the_contract() {
    let release = "tilt_deg = 40\nspin = 3.5\nprecession = 0.3\nnutation = -0.2\nazimuth_deg = 720000000430\nroll_deg = -25\n";
    let file = scenario("release", &format!("{TOP}[motion]\nkind = \"release\"\n{release}"));
    // two whole turns, which change nothing, lose no digits
    let (tilt, azimuth, roll) = (40_f64.to_radians(), 430_f64.to_radians(), -25_f64.to_radians());
    let (half_sum, half_difference) = ((azimuth + roll) / 2.0, (azimuth - roll) / 2.0);
    let (cosine, sine) = ((tilt / 2.0).cos(), (tilt / 2.0).sin());
    let r = [tilt.sin() * azimuth.cos(), tilt.sin() * azimuth.sin(), tilt.cos()];
    let axial = 3.5 - 0.3 * tilt.cos();
    let expected = [
        cosine * half_sum.cos(),
        cosine * half_sum.sin(),
        -sine * half_difference.cos(),
        -sine * half_difference.sin(),
        axial * r[0] + 0.2 * azimuth.sin(),
        axial * r[1] - 0.2 * azimuth.cos(),
        axial * r[2] + 0.3,
    ];
    for method in ["ephemeris", "stepper", "full"] {
        let start = &samples(&file, "0", &["--method", method])[0];
        let found = numbers(start, &["alpha", "beta", "omega"]);
        assert!(found.iter().zip(expected).all(|(x, y)| (x - y).abs() < 3e-15), "{found:?} {expected:?}");
        // the tip is opposite to the direction in which the axis leans: -110 degrees
        assert!((numbers(start, &["phi"])[0] + 110_f64.to_radians()).abs() < 1e-14);
    }
    // exactly downward and exactly upright
    for (degrees, u) in [("180", -1.0), ("180.0", -1.0), ("0", 1.0)] {
        let file = scenario("vertical", &format!("{TOP}{}", RELEASE.replace("40", degrees)));
        let start = &samples(&file, "0", &[])[0];
        assert_eq!(numbers(start, &["u", "tip"]), [u, 0.0, 0.0]);
        assert!(start["phi"].is_null());
    }
}

#[test]
fn times_come_in_the_order_of_the_request() {
    let file = sample("toy_top");
    let asked = [0.31, -0.2, 0.0, 0.31, 1.0, -1.5, 1e-9];
    let list = asked.map(|t| t.to_string()).join(",");
    let together = samples(&file, &list, &[]);
    for (t, sample) in asked.iter().zip(&together) {
        assert_eq!(sample["t"].as_f64(), Some(*t));
        // a single time is reached by other steps, with the same result
        let alone = &samples(&file, &t.to_string(), &[])[0];
        assert!(distance(sample, alone, &["alpha", "beta", "phi"]) < 1e-12, "t = {t}");
    }
    assert_eq!(together[0], together[3]);

    let path = scenario("times", &format!("# seconds\n\n{}", asked.map(|t| format!(" {t} # s\n")).concat()));
    let from_file = json(&["state", &file, "--times-file", &path, "--format", "json"]);
    assert_eq!(from_file["samples"].as_array(), Some(&together));
    assert_eq!(
        json(&["state", &file, "--times", "-0.2,1", "--format", "json"])["samples"][0],
        samples(&file, "-0.2", &[])[0]
    );
}

#[test]
fn the_methods_agree_and_phi_is_continued_from_zero() {
    // each case is e1, e2, e3, sign of l - n: smooth, loops, through the centre at the bottom, at the top, near the separatrix
    let cases = [
        ([0.2, 0.8, 1.5], 1),
        ([0.2, 0.8, 3.0], -1),
        ([-1.0, 0.6, 1.4], -1),
        ([-0.3, 1.0, 1.3], 1),
        ([0.2, 0.9995, 1.0005], 1),
    ];
    for (index, (e, minus)) in cases.into_iter().enumerate() {
        let start = "nutation_phase = 0.4\narg_alpha = 2.9\narg_beta = 1.1\n";
        let file = scenario(&format!("phi{index}"), &(branch_points(e, minus) + start));
        let times: Vec<f64> = (-300..=300).map(|i| 0.05 * f64::from(i)).collect();
        let list = times.iter().map(f64::to_string).collect::<Vec<_>>().join(",");
        let [stepper, full, ephemeris] =
            ["stepper", "full", "ephemeris"].map(|method| samples(&file, &list, &["--method", method]));
        let phi = |sample: &Value| numbers(sample, &["phi"])[0];
        let origin = phi(&stepper[300]);
        assert!(-std::f64::consts::PI < origin && origin <= std::f64::consts::PI, "{e:?}: {origin}");
        let alone = phi(&samples(&file, "15", &["--method", "full"])[0]);
        assert!((alone - phi(&stepper[600])).abs() < 1e-7, "{e:?}: {alone}");
        for (a, b) in stepper.iter().zip(&full).chain(stepper.iter().zip(&ephemeris)) {
            assert!(distance(a, b, &EVERYTHING[..8]) < 1e-9, "{e:?}: {a} {b}");
        }
        for pair in stepper.windows(2).chain(full.windows(2)).chain(ephemeris.windows(2)) {
            assert!((phi(&pair[1]) - phi(&pair[0])).abs() < 1.0, "{e:?}: {pair:?}");
        }
        for (a, b) in stepper.iter().zip(&full).chain(ephemeris.iter().zip(&full)) {
            let [x, y] = numbers(a, &["tip"])[..] else { panic!("two numbers") };
            // rounding error divided by |c|
            assert!((phi(a) - phi(b)).abs() < 1e-9 / x.hypot(y).min(1.0), "{e:?}: {a} {b}");
            let radius =
                if e[0] == -1.0 || e[1] == 1.0 { x * phi(a).cos() + y * phi(a).sin() } else { x.hypot(y) };
            assert!((x - radius * phi(a).cos()).hypot(y - radius * phi(a).sin()) < 1e-9, "{e:?}: {a}");
        }
    }
}

/// For every kind of motion with a closed form, four methods agree; the full solver shares no code with the other three.
#[test]
fn closed_form_ephemeris_stepper_and_full_solver_agree() {
    let e4 = (1.0 + 1.1 / (0.9 * 0.6_f64)).sqrt();
    let fixed = |text: String| text.replace("com_height = 0.6", "support = \"fixed\"");
    let start = "nutation_phase = 0.7\narg_alpha = 2.9\narg_beta = 1.1\n";
    let cases = [
        ("e3_e4", branch_points([-0.3, 0.8, e4], 1)),
        ("e3_e4_loops", branch_points([-0.3, 0.8, e4], -1)),
        ("e3_e4_e1", branch_points([-1.0, 0.8, e4], -1)),
        ("e3_e4_e2", branch_points([-0.3, 1.0, e4], 1)),
        ("aperiodic", branch_points([-0.3, 1.0, 1.0], 1)),
        ("precession", branch_points([0.4, 0.4, 1.3], -1)),
        ("lagrange", fixed(branch_points([-0.3, 0.8, 1.4], -1))),
        ("lagrange_aperiodic", fixed(branch_points([-0.3, 1.0, 1.0], 1))),
    ];
    let mut worst = 0.0_f64;
    for (name, text) in cases {
        let file = scenario(&format!("four_{name}"), &(text + start));
        let times: Vec<_> = (-12..=12).map(|i| (0.83 * f64::from(i)).to_string()).collect();
        let by = |method: &str| samples(&file, &times.join(","), &["--method", method]);
        let closed = by("closed-form");
        for method in ["ephemeris", "stepper", "full"] {
            for (ours, theirs) in closed.iter().zip(by(method)) {
                let error = distance(ours, &theirs, &EVERYTHING[..8]);
                assert!(error < 1e-12, "{name}, {method}: {error:e} at {}", ours["t"]);
                worst = worst.max(error);
                // the angle is known to the rounding of c divided by |c|
                let [x, y] = numbers(ours, &["tip"])[..] else { panic!("two numbers") };
                assert!(distance(ours, &theirs, &["phi"]) < 1e-12 / x.hypot(y).min(1.0), "{name}, {method}");
            }
        }
    }
    assert!(worst > 1e-15, "{worst:e}: four methods, not one");
    // a vertical axis has no tip angle
    let upright = samples(&sample("sleeping"), "0.5", &["--method", "closed-form"]);
    assert!(upright[0]["phi"].is_null());
}

#[test]
fn where_the_tip_is_at_the_centre_phi_goes_on_smoothly() {
    let file = scenario("centre", &(branch_points([-1.0, 0.6, 1.4], 1) + "arg_beta = 0.7\n"));
    for method in ["ephemeris", "stepper", "full"] {
        let passing = samples(&file, "-1e-4,0,1e-4", &["--method", method]);
        let [before, at, after] = [0, 1, 2].map(|i| numbers(&passing[i], &["phi"])[0]);
        assert!((before - at).abs() < 1e-3 && (after - at).abs() < 1e-3, "{method}: {before} {at} {after}");
    }
}

#[test]
fn single_precision_is_single_precision() {
    let file = scenario("f32", &format!("{TOP}{RELEASE}"));
    let times = "-7.3,0.1,25,333.3,25";
    let (double, single) = (samples(&file, times, &[]), samples(&file, times, &["--scalar", "f32"]));
    assert_eq!(single[2], single[4]);
    for (a, b) in double.iter().zip(&single) {
        assert_eq!(a["t"], b["t"]);
        let error = distance(a, b, &["alpha", "beta"]);
        assert!(error > 1e-9 && error < 1e-4, "{error:e}");
        assert!(numbers(b, &["alpha", "beta", "omega"]).iter().all(|x| f64::from(*x as f32) == *x));
    }
}

/// α, β and u are printed with all bits, not rounded to the `f32` of the rates.
#[test]
fn fixed_point_is_fixed_point() {
    let file = scenario("fixed_point", &format!("{TOP}{RELEASE}"));
    let times = "-7.3,0.1,25,333.3,25";
    let double = samples(&file, times, &[]);
    for (scalar, unit, least, most) in [("q31", 30, 1e-10, 2e-8), ("q15", 14, 1e-6, 3e-4)] {
        let fixed = samples(&file, times, &["--scalar", scalar]);
        assert_eq!(fixed[2], fixed[4]);
        for (a, b) in double.iter().zip(&fixed) {
            let error = distance(a, b, &["alpha", "beta", "u"]);
            assert!(error > least && error < most, "{scalar}: {error:e}");
            let whole = |x: &f64| (x * 2_f64.powi(unit)).fract() == 0.0;
            assert!(numbers(b, &["alpha", "beta", "u"]).iter().all(whole), "{scalar}: {b}");
            let slower = distance(a, b, &["omega", "tip", "udot"]);
            // the rates are rounded to f32
            assert!(slower < 25.0 * most, "{scalar}: {slower:e}");
        }
    }
}

#[test]
fn micromath_is_what_it_is() {
    let file = scenario("micromath", &format!("{TOP}{RELEASE}"));
    let double = samples(&file, "0,0.1,333.3", &[]);
    let tabulated = samples(&file, "0,0.1,333.3", &["--scalar", "micromath"]);
    let worst = double.iter().zip(&tabulated).map(|(a, b)| distance(a, b, &["alpha", "beta"]));
    let worst = worst.fold(0.0, f64::max);
    assert!(worst > 1e-4 && worst < 3e-3, "its sines: {worst:e}");
    let stepped = samples(&file, "0,2", &["--scalar", "micromath", "--method", "stepper"]);
    let error = distance(&samples(&file, "2", &[])[0], &stepped[1], &["alpha", "beta"]);
    assert!(error > 1e-3, "its square root: {error:e}");
}

#[test]
fn steps_per_period_are_obeyed_and_fourth_order() {
    let file = scenario("order", &format!("{TOP}{RELEASE}"));
    let at =
        |steps: &str| samples(&file, "20", &["--method", "stepper", "--steps-per-period", steps])[0].clone();
    let exact = at("8192");
    let [coarse, fine] = ["64", "128"].map(|steps| distance(&at(steps), &exact, &["alpha", "beta"]));
    let order = (coarse / fine).log2();
    assert!((3.0..5.0).contains(&order), "{coarse:e} {fine:e}");
}

#[test]
fn a_fixed_tip_has_a_direction_for_a_tip() {
    let sample = &samples(&sample("lagrange"), "0.4", &[])[0];
    let [ar, ai, br, bi, x, y] = numbers(sample, &["alpha", "beta", "tip"])[..] else {
        panic!("six numbers")
    };
    assert!((x - 2.0 * (ar * br - ai * bi)).hypot(y - 2.0 * (ar * bi + ai * br)) < 1e-15);
}

#[test]
fn a_table_says_its_units() {
    for (file, of_tip) in [("toy_top", Some("m")), ("lagrange", None)] {
        let output = run(&["state", &sample(file), "--times", "0.5"]);
        let units = stdout(&output).lines().take_while(|line| !line.is_empty()).map(|line| {
            let mut words = line.split_whitespace();
            let name = words.next().expect("a name");
            (name, words.next().filter(|word| word.parse::<f64>().is_err()))
        });
        let expected = EVERYTHING.map(|name| match name {
            "udot" => (name, Some("1/s")),
            "omega" => (name, Some("rad/s")),
            "phi" => (name, Some("rad")),
            "tip" => (name, of_tip),
            _ => (name, None),
        });
        assert_eq!(units.collect::<Vec<_>>(), [&[("t", Some("s"))][..], &expected].concat(), "{file}");
    }
}

/// The stepper in `f32` computes in `f32`: its numbers are of that type, and differ from those in `f64` by rounding errors.
#[test]
fn the_stepper_in_f32_is_one() {
    let file = sample("toy_top");
    let of = |scalar: &str| samples(&file, "0.3,1,2.5", &["--method", "stepper", "--scalar", scalar]);
    let (single, double) = (of("f32"), of("f64"));
    for (narrow, wide) in single.iter().zip(&double) {
        let parts = numbers(narrow, &["alpha", "beta"]);
        assert!(parts.iter().all(|x| f64::from(*x as f32) == *x), "{narrow}");
        assert!(numbers(wide, &["alpha", "beta"]).iter().any(|x| f64::from(*x as f32) != *x), "{wide}");
        let error = distance(narrow, wide, &["alpha", "beta"]);
        assert!(error > 1e-9 && error < 1e-5, "{error:e}");
    }
}

/// Rounding of α and β must not give |u| > 1, for which the arc cosine is NaN.
#[test]
fn the_cosine_of_the_tilt_is_one() {
    let sleeping = sample("sleeping");
    let mut vertical = 0;
    for (method, scalars) in [
        ("ephemeris", &["f64", "f32", "q31", "q15", "micromath"][..]),
        ("stepper", &["f64", "f32", "micromath"]),
        ("full", &["f64"]),
        ("closed-form", &["f64"]),
    ] {
        for scalar in scalars {
            let more = ["--method", method, "--scalar", scalar];
            for sample in samples(&sleeping, "0,0.1,0.33,1,2.7,10,55,300", &more) {
                let u = sample["u"].as_f64().expect("a number");
                assert!(u <= 1.0 && u > 0.99, "{method} {scalar}: {u:?}");
                vertical += usize::from(u == 1.0);
            }
        }
    }
    assert!(vertical > 0);
}

/// The tip of a held top in `state` is minus the horizontal part of the axis, which the help text states with the units.
#[test]
fn a_held_tip_is_minus_the_horizontal_part_of_the_axis() {
    for sample in samples(&sample("lagrange"), "0,0.3,7", &[]) {
        let pair = |key: &str| [0, 1].map(|i| sample[key][i].as_f64().expect("a number"));
        let ([a, b], [c, d], [x, y]) = (pair("alpha"), pair("beta"), pair("tip"));
        assert!((x - 2.0 * (a * c - b * d)).abs() < 1e-15 && (y - 2.0 * (a * d + b * c)).abs() < 1e-15);
    }
    let help = run(&["state", "--help"]);
    for part in
        ["minus the horizontal part of the axis", "t in s", "omega in rad/s", "tip in m", "phi in rad"]
    {
        assert!(stdout(&help).contains(part), "{part}");
    }
    let table = run(&["state", &sample("lagrange"), "--times", "0.3"]);
    assert!(stdout(&table).contains("minus the horizontal part of the axis"), "{}", stdout(&table));
    let sliding = run(&["state", &sample("toy_top"), "--times", "0.3"]);
    assert!(!stdout(&sliding).contains("minus the horizontal"), "{}", stdout(&sliding));
}

/// A free body keeps its angular momentum. Keys that a free body does not need are allowed and have no effect.
#[test]
fn a_free_body_keeps_its_angular_momentum() {
    let free = "[top]\nsupport = \"free\"\ntransverse_inertia = 7.5e-5\naxial_inertia = 2.0e-5\n\
                [motion]\nkind = \"release\"\ntilt_deg = 20.0\nspin = 150.0\nnutation = 0.5\n";
    let states = samples(&scenario("free_body", free), "0,1,10", &[]);
    let with_more = free.replace("[motion]", "mass = 2\ncom_height = 0.1\ngravity = 1.6\n[motion]");
    assert_eq!(states, samples(&scenario("free_body_with_more", &with_more), "0,1,10", &[]));
    let vectors: Vec<_> = states
        .iter()
        .map(|state| {
            let [x, y, z] = [0, 1, 2].map(|i| state["omega"][i].as_f64().expect("a number"));
            let tip = [0, 1].map(|i| state["tip"][i].as_f64().expect("a number"));
            let axis = [-tip[0], -tip[1], state["u"].as_f64().expect("a number")];
            let along = x * axis[0] + y * axis[1] + z * axis[2];
            // the angular momentum A ω + (C - A) ⟨ω, r⟩ r, which is constant
            let momentum = [0, 1, 2].map(|i| 7.5e-5 * [x, y, z][i] - (7.5e-5 - 2.0e-5) * along * axis[i]);
            (along, momentum)
        })
        .collect();
    for (along, momentum) in &vectors {
        assert!((along - 150.0).abs() < 1e-9, "{along:?}");
        for (now, first) in momentum.iter().zip(vectors[0].1) {
            assert!((now - first).abs() < 1e-14 * 3e-3, "{now:?} {first:?}");
        }
    }
}
