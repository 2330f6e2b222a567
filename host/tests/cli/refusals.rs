//! Tests of bad input: exit code 2, nothing on stdout, one line on stderr that names the file, the key and the allowed values.

use super::{RELEASE, TOP, branch_points, needle, run, sample, scenario, stderr, stdout};

fn assert_refused(arguments: &[&str], code: i32, parts: &[&str]) {
    let output = run(arguments);
    let message = stderr(&output);
    assert_eq!(output.status.code(), Some(code), "{arguments:?}: {message}");
    assert_eq!(stdout(&output), "", "{arguments:?}");
    assert_eq!(message.matches('\n').count(), 1, "{arguments:?}: {message}");
    for part in parts {
        assert!(message.contains(part), "{arguments:?}: {part:?} is not in {message:?}");
    }
}

#[test]
fn arguments() {
    let file = sample("toy_top");
    let missing = sample("no_such_file");
    let far = crate::scratch::file("far.txt", "1e300\n");
    let cases: &[(&[&str], &[&str])] = &[
        (&[], &["--help"]),
        (&["plot"], &["--output", "SCENARIO"]),
        (&["draw"], &["draw"]),
        (&["stat"], &["'stat'; some similar subcommands exist:", "'state'"]),
        (&["bench", "quickly"], &["quickly"]),
        (&["constants"], &["SCENARIO"]),
        (&["constants", &file, "--format", "xml"], &["--format", "table, csv, json"]),
        (&["constants", &missing], &["no_such_file.toml", "No such file"]),
        (&["compare", &file, &missing], &["no_such_file.toml"]),
        (&["compare", "--periods", "0"], &["--periods", "1..=10000"]),
        (&["compare", "--scalar", "f64,q7"], &["--scalar", "f64, f32, q31, q15, micromath, all"]),
        (&["state", &file], &["--times", "--times-file"]),
        (&["state", &file, "--times", "1", "--times-file", "x"], &["--times", "--times-file"]),
        (&["state", &file, "--times", "1,,2"], &["--times", "finite number"]),
        (&["state", &file, "--times", "1,NaN"], &["--times", "NaN", "finite number"]),
        (&["state", &file, "--times", "1e999"], &["--times", "finite number"]),
        (&["state", &file, "--times", "1 2"], &["--times", "finite number"]),
        (&["state", &file, "--times-file", &missing], &["no_such_file.toml"]),
        (&["state", &file, "--times-file", &file], &["toy_top.toml", "line 3", "finite number"]),
        (
            &["state", &file, "--times", "1", "--method", "euler"],
            &["euler", "ephemeris, stepper, full, closed-form"],
        ),
        (&["state", &file, "--times", "1", "--scalar", "q7"], &["q7", "f64, f32, q31, q15, micromath"]),
        (&["state", &file, "--times", "1", "--scalar", "q31", "--method", "full"], &["--scalar", "f64"]),
        (&["state", &file, "--times", "1", "--scalar", "f32", "--method", "full"], &["--scalar", "f64"]),
        (
            &["state", &file, "--times", "1", "--scalar", "f32", "--method", "closed-form"],
            &["--scalar", "f64"],
        ),
        (&["state", &file, "--times", "1", "--steps-per-period", "0"], &["1..=16777216"]),
        (
            &["state", &file, "--times", "1", "--steps-per-period", "10"],
            &["error: --steps-per-period: needs --method stepper\n"],
        ),
        (
            &["state", &file, "--times", "1", "--method", "full", "--steps-per-period", "10"],
            &["error: --steps-per-period: needs --method stepper\n"],
        ),
        (&["state", &file, "--times", "10..0/5"], &["error: --times: 10..0/5: LOW must be below HIGH\n"]),
        (
            &["state", &file, "--times", "0..1/6000000", "--method", "full"],
            &["error: --times: 6000000 times: must be at most 5000000"],
        ),
        (
            &["state", &file, "--times-file", &far],
            &["error: --times-file: ", "far.txt: 1e300 must be within ±"],
        ),
        (&["animate", &file, "--seconds", "-1", "-o", "x.gif"], &["'-1' for '--seconds <S>'", "0.1 to 600"]),
        (&["fit", "x.csv", "--top", &file, "--huber", "-1"], &["'-1' for '--huber <X>'", "a number from 1"]),
        (&["bake", &file, "--size", "-8"], &["'-8' for '--size <SEGMENTS>'"]),
        (&["plot", &file, "--size", "-100", "-o", "x.svg"], &["'-100'", "100..=10000"]),
        (&["simulate", &file, "-o", "no_such_folder/f.csv"], &["error: --output: no_such_folder/f.csv: "]),
        (&["state", &file, "--times", "1", "--steps-per-period", "16777217"], &["1..=16777216"]),
        (
            &["state", &file, "--times", "1e6,-1e6", "--method", "stepper"],
            &["--steps-per-period", "at most 1e10 steps"],
        ),
        (&["state", &file, "--times", "1,-1e300"], &["error: --times: -1e300 must be within ±2.8e14 s"]),
        (
            &["state", &sample("lagrange"), "--times", "1,-1e300", "--method", "closed-form"],
            &["times", "-1e300", "closed-form"],
        ),
    ];
    for (arguments, parts) in cases {
        assert_refused(arguments, 2, parts);
    }
}

/// Messages are short for any input, and state the error.
#[test]
fn long_input_makes_no_long_message() {
    let long = "k".repeat(100_000);
    let text = format!("{TOP}{RELEASE}");
    let key = scenario("long_key", &format!("{text}{long} = 1\n"));
    let value = scenario("long_value", &text.replace("\"release\"", &format!("\"{long}\"")));
    let table = scenario("long_table", &format!("{text}[{long}]\n"));
    let cases: &[(&[&str], &[&str])] = &[
        (&["constants", &key], &["motion.kkkk", "unknown or unneeded key; allowed"]),
        (&["constants", &value], &["motion.kind", "must be one of"]),
        (&["constants", &table], &["kkkk", "unknown key; allowed"]),
        (&["state", &key, "--times", &long], &["kkk"]),
        (&["constants", &long], &["kkk"]),
        (&["sweep", "-o", "x.csv", "--e1", "1e300"], &["--e1: 1e300: must be within [-1, 1]"]),
        (&["sweep", "-o", "x.csv", "--shard", "1/99999999999"], &["--shard", "N must be at most 4294967296"]),
        (&["sweep", "-o", "x.csv", "--shard", "3/2"], &["--shard", "must be I/N with I from 1 to N"]),
        (&["sweep", "-o", "x.csv", "--shard", &long], &["--shard"]),
    ];
    for (arguments, parts) in cases {
        assert_refused(arguments, 2, parts);
        assert!(stderr(&run(arguments)).len() < 1200, "{}", stderr(&run(arguments)).len());
    }
}

/// The full solver fails with exit code 3 and a message that names it, not another option.
#[test]
fn the_full_solver_gives_up_by_its_own_name() {
    let file = sample("toy_top");
    let arguments = ["state", &file, "--times", "1e6", "--method", "full"];
    assert_refused(&arguments, 3, &["toy_top: full solver: gives up at t = 3.59e3", "ask for earlier times"]);
}

/// A stepper in fixed point fails with exit code 3 and a message that names the ephemeris, which exists there.
#[test]
fn a_stepper_in_fixed_point() {
    let file = sample("toy_top");
    for scalar in ["q31", "q15"] {
        let arguments = ["state", &file, "--times", "1", "--method", "stepper", "--scalar", scalar];
        assert_refused(&arguments, 3, &["--method stepper", scalar, "--method ephemeris"]);
    }
}

/// A closed form fails with exit code 3 if the motion is hyperelliptic.
#[test]
fn a_motion_without_a_closed_form() {
    let file = sample("toy_top");
    for format in ["table", "csv", "json"] {
        let arguments = ["state", &file, "--times", "1", "--method", "closed-form", "--format", format];
        assert_refused(&arguments, 3, &["toy_top: ", "e3 = e4", "e2 = e3 = 1"]);
    }
}

#[test]
fn files() {
    let good = format!("{TOP}{RELEASE}");
    let cases: &[(&str, Vec<u8>, &[&str])] = &[
        ("empty", Vec::new(), &["top", "missing"]),
        ("utf", b"[top]\n\xff\xfe".to_vec(), &["UTF-8"]),
        ("large", format!("{good}#{}", "x".repeat(1 << 20)).into_bytes(), &["1 MiB"]),
        ("syntax", good.replace("= 3.5", "= 3,5").into_bytes(), &["line 10", "TOML"]),
        ("twice", format!("{good}spin = 2\n").into_bytes(), &["line 12", "TOML"]),
        ("two", format!("{good}[motion]\nkind = \"state\"\n").into_bytes(), &["line 12", "TOML"]),
        ("no_motion", TOP.into(), &["motion", "missing"]),
        ("no_table", format!("motion = 3\n{TOP}").into_bytes(), &["motion", "table"]),
        ("third", format!("{good}[tip]\n").into_bytes(), &["tip", "unknown"]),
        ("lines", format!("{good}\"a\\nb\" = 1\n").into_bytes(), &["motion.a\\nb", "unknown"]),
    ];
    for (name, content, parts) in cases {
        let file = scenario(&format!("file_{name}"), "");
        std::fs::write(&file, content).expect("the file is written");
        assert_refused(&["constants", &file], 2, &[&[&*file], *parts].concat());
    }
    assert_refused(&["constants", env!("CARGO_TARGET_TMPDIR")], 2, &["directory"]);
    let no_times = scenario("file_no_times", "# none\n\n");
    assert_refused(
        &["state", &sample("toy_top"), "--times-file", &no_times],
        2,
        &["file_no_times", "at least one"],
    );
}

/// Change of a valid file: the replaced text, the new text, and parts of the message.
type Change = (&'static str, &'static str, &'static [&'static str]);

fn assert_changes_refused(kind: &str, good: &str, changes: &[Change]) {
    let file = scenario(&format!("good_{kind}"), good);
    assert_eq!(run(&["constants", &file]).status.code(), Some(0), "{good}");
    for (index, (from, to, parts)) in changes.iter().enumerate() {
        assert!(good.contains(from), "{from}");
        let file = scenario(&format!("bad_{kind}_{index}"), &good.replacen(from, to, 1));
        assert_refused(
            &["state", &file, "--times", "1", "--format", "json"],
            2,
            &[&[&*file], *parts].concat(),
        );
    }
}

#[test]
fn tops() {
    let changes: &[Change] = &[
        ("gravity = 1", "gravity = -1", &["top.gravity", "positive"]),
        ("gravity = 1", "gravity = nan", &["top.gravity", "number"]),
        ("gravity = 1", "gravity = true", &["top.gravity", "number"]),
        ("gravity = 1", "gravity = \"1\"", &["top.gravity", "number"]),
        ("gravity = 1", "gravity = 1e61", &["top.gravity", "1e-60 and 1e60"]),
        ("gravity = 1", "gravty = 1", &["top.gravty", "unknown", "gravity"]),
        ("gravity = 1", "support = \"hinge\"", &["top.support", "\"sliding\", \"fixed\""]),
        ("gravity = 1", "support = 1", &["top.support", "\"sliding\", \"fixed\""]),
        ("transverse_inertia = 1.1\n", "", &["top.transverse_inertia", "missing", "1e-60 and 1e60"]),
        ("axial_inertia = 0.8\n", "", &["top.axial_inertia", "missing", "twice transverse_inertia"]),
        ("transverse_inertia = 1.1", "transverse_inertia = inf", &["top.transverse_inertia", "number"]),
        ("axial_inertia = 0.8", "axial_inertia = 2.3", &["top.axial_inertia", "twice transverse_inertia"]),
        ("gravity = 1", "gravity = 0", &["top.gravity", "support = \"free\""]),
        ("gravity = 1", "rotor_momentum = true", &["top.rotor_momentum", "number"]),
        ("gravity = 1", "rotor_momentum = 1e13", &["top.rotor_momentum", "1e12 per second"]),
        ("gravity = 1", "support = \"free\"\nmass = inf", &["top.mass", "number"]),
        ("com_height = 0.6\n", "", &["top.com_height", "missing"]),
        ("com_height = 0.6", "com_height = 0", &["top.com_height", "positive"]),
        ("mass_moment = 0.9\n", "", &["top.mass", "exactly one of mass, mass_moment"]),
        ("mass_moment = 0.9", "mass_moment = -0.9", &["top.mass_moment", "positive"]),
        ("mass_moment = 0.9", "mass = -0.9", &["top.mass", "positive"]),
        ("mass_moment = 0.9", "mass = 0", &["top.mass: must be positive, between 1e-60 and 1e60\n"]),
        (
            "mass_moment = 0.9",
            "mass_moment = -0.0",
            &["top.mass_moment: must be positive, between 1e-60 and"],
        ),
        ("mass_moment = 0.9", "mass = 1.5\nmass_moment = 0.9", &["top.mass_moment", "without mass"]),
        ("gravity = 1", "support = \"fixed\"", &["top.com_height", "fixed", "together with mass"]),
        ("com_height = 0.6", "support = \"fixed\"\nmass = 1", &["top.mass_moment", "without mass"]),
        (
            "mass_moment = 0.9\ncom_height = 0.6",
            "support = \"fixed\"\nmass = 1",
            &["top.com_height", "missing"],
        ),
    ];
    assert_changes_refused("top", &format!("{TOP}{RELEASE}"), changes);
}

#[test]
fn releases() {
    let changes: &[Change] = &[
        (
            "kind = \"release\"\n",
            "",
            &["motion.kind", "missing", "\"release\", \"state\", \"branch_points\""],
        ),
        ("\"release\"", "\"throw\"", &["motion.kind", "\"release\", \"state\", \"branch_points\""]),
        ("\"release\"", "\"state\"", &["motion.precession", "unneeded", "alpha, beta, omega"]),
        ("tilt_deg = 40\n", "", &["motion.tilt_deg", "missing", "[0, 180]"]),
        ("spin = 3.5\n", "", &["motion.spin", "missing"]),
        ("tilt_deg = 40", "tilt_deg = 180.00000001", &["motion.tilt_deg", "[0, 180]"]),
        ("tilt_deg = 40", "tilt_deg = -1", &["motion.tilt_deg", "[0, 180]"]),
        ("tilt_deg = 40", "tilt_deg = [40]", &["motion.tilt_deg", "[0, 180]"]),
        ("tilt_deg = 40", "tilt_deg = \"40\"", &["motion.tilt_deg", "[0, 180]"]),
        (
            "tilt_deg = 40",
            "tilt_deg = \"40 deg\"",
            &["motion.tilt_deg: must be a number of degrees; with a unit: tilt = \"40 deg\"\n"],
        ),
        (
            "precession = 0.3",
            "roll_deg = \"0.1 turns\"",
            &["motion.roll_deg: must be a number of degrees; with a unit: roll = \"0.1 turns\"\n"],
        ),
        ("spin = 3.5", "spin = -inf", &["motion.spin", "number"]),
        ("spin = 3.5", "spin = 1e12", &["motion.spin", "1e11"]),
        ("spin = 3.5", "spin = 1e9", &["motion.spin", "e3 <= 1e14", "support = \"free\" is then exact)\n"]),
        ("spin = 3.5", "spin = 3.5\nnutation = -1e9", &["motion.nutation", "e3 <= 1e14"]),
        ("precession = 0.3", "precession = 1e9", &["motion.precession", "e3 <= 1e14"]),
        ("precession", "presession", &["motion.presession", "unknown", "precession"]),
        ("precession = 0.3", "e1 = 0.3", &["motion.e1", "unneeded", "kind = \"release\""]),
        ("precession = 0.3", "roll_deg = nan", &["motion.roll_deg", "degrees"]),
    ];
    assert_changes_refused("release", &format!("{TOP}{RELEASE}"), changes);
}

#[test]
fn states() {
    let good =
        format!("{TOP}[motion]\nkind = \"state\"\nalpha = [0.6, 0]\nbeta = [0, 0.8]\nomega = [1, 2.5, 3]\n");
    let changes: &[Change] = &[
        ("alpha = [0.6, 0]\n", "", &["motion.alpha", "missing", "[re, im]"]),
        ("[0.6, 0]", "[0.6, 0.0, 0]", &["motion.alpha", "two"]),
        ("[0.6, 0]", "[0.6, \"0\"]", &["motion.alpha", "two"]),
        ("[0.6, 0]", "0.6", &["motion.alpha", "two"]),
        ("[0, 0.8]", "[0, nan]", &["motion.beta", "finite"]),
        ("[0, 0.8]", "[0, 0.800002]", &["motion.alpha", "unit norm", "1e-6"]),
        ("[1, 2.5, 3]", "[1, 2.5]", &["motion.omega", "three"]),
        ("[1, 2.5, 3]", "[1, 2.5, 1e13]", &["motion.omega", "1e12"]),
        ("[1, 2.5, 3]", "[1, 2.5, 1e9]", &["motion.omega", "e3 <= 1e14"]),
        ("omega", "spin = 1\nomega", &["motion.spin", "unneeded"]),
    ];
    assert_changes_refused("state", &good, changes);
    let near = scenario("state_norm", &good.replace("[0, 0.8]", "[0, 0.8000003]"));
    assert_eq!(run(&["constants", &near]).status.code(), Some(0));
}

/// The limit of a rate that a message states is one, with three digits.
#[test]
fn the_greatest_rate_is_stated() {
    let good = format!("{TOP}{RELEASE}");
    for (key, number, sign) in [("spin", "3.5", 1.0), ("spin", "3.5", -1.0), ("precession", "0.3", 1.0)] {
        let constants = |rate: f64| {
            let text = good.replace(&format!("{key} = {number}"), &format!("{key} = {:e}", sign * rate));
            run(&["constants", &scenario("greatest_rate", &text)])
        };
        let refused = constants(1e9);
        let message = stderr(&refused);
        let (_, limit) = message.split_once(&format!("motion.{key}: must be at most ")).expect("a limit");
        let limit: f64 = limit.split(' ').next().expect("a number").parse().expect("a number");
        assert_eq!(constants(limit).status.code(), Some(0), "{message}");
        assert_eq!(constants(1.01 * limit).status.code(), Some(2), "{message}");
    }
    // no spin helps where the precession is too fast
    let text = good.replace("= 0.3", "= 0.9e9").replace("= 3.5", "= 1e9");
    assert_refused(
        &["constants", &scenario("no_rate", &text)],
        2,
        &["motion.spin: must be slow enough for e3"],
    );
}

#[test]
fn branch_points_out_of_order() {
    let changes: &[Change] = &[
        ("e1 = 0.2", "e1 = 0.9", &["motion.e2", "[e1, 1]"]),
        ("e1 = 0.2", "e1 = -1.01", &["motion.e1", "[-1, e2]"]),
        ("e1 = 0.2", "e1 = nan", &["motion.e1", "number"]),
        ("e2 = 0.8", "e2 = 1.1", &["motion.e2", "[e1, 1]"]),
        ("e3 = 1.5", "e3 = 0.99", &["motion.e3", "[1, 1e14]"]),
        ("e3 = 1.5\n", "", &["motion.e3", "missing"]),
        ("sign_l_plus_n = 1", "sign_l_plus_n = 0", &["motion.sign_l_plus_n", "1 or -1"]),
        ("sign_l_minus_n = 1\n", "", &["motion.sign_l_minus_n", "missing", "1 or -1"]),
        ("e3 = 1.5", "e3 = 1.5\nnutation_phase = 1e7", &["motion.nutation_phase", "1e6"]),
        ("e3 = 1.5", "e3 = 1.5\narg_beta = inf", &["motion.arg_beta", "1e6"]),
        ("e3 = 1.5", "e3 = 1.5\ntilt_deg = 3", &["motion.tilt_deg", "unneeded", "kind = \"branch_points\""]),
    ];
    assert_changes_refused("branch_points", &branch_points([0.2, 0.8, 1.5], 1), changes);
}

#[test]
fn a_method_that_does_not_apply_exits_with_3() {
    // a million seconds exceed the limit of the full solver
    let file = scenario("too_far", &format!("{TOP}{RELEASE}"));
    let far = ["state", &file, "--times", "1e6", "--method", "full"];
    assert_refused(&far, 3, &["too_far", "full solver", "evaluations"]);
    // no table is large enough
    let file = needle("needle");
    for (scalar, size) in [("f64", "4096x11"), ("f32", "4096x5"), ("q31", "4096x4"), ("micromath", "4096x5")]
    {
        let arguments = ["state", &file, "--times", "1", "--scalar", scalar];
        assert_refused(
            &arguments,
            3,
            &["needle", "no ephemeris", size, "segments of this degree would be enough"],
        );
    }
}
