//! Scenario files that are refused: exit code 2, and one line that names the file, the key and the allowed values.

use crate::command::{RELEASE, TOP, branch_points, scenario, toytop, write};

#[test]
fn wrong_files_are_refused() {
    let good = format!("{TOP}{RELEASE}");
    for (name, content, parts) in [
        ("empty", Vec::new(), "top ... missing"),
        ("utf", b"[top]\n\xff\xfe".to_vec(), "UTF-8"),
        ("large", format!("{good}#{}", "x".repeat(1 << 20)).into_bytes(), "1 MiB"),
        ("syntax", good.replace("= 3.5", "= 3,5").into_bytes(), "line 10 ... TOML"),
        ("twice", format!("{good}spin = 2\n").into_bytes(), "line 12 ... TOML"),
        ("two", format!("{good}[motion]\nkind = \"state\"\n").into_bytes(), "line 12 ... TOML"),
        ("no_motion", TOP.into(), "motion ... missing"),
        ("no_table", format!("motion = 3\n{TOP}").into_bytes(), "motion ... table"),
        ("third", format!("{good}[tip]\n").into_bytes(), "tip ... unknown"),
        ("lines", format!("{good}\"a\\nb\" = 1\n").into_bytes(), "motion.a\\nb ... unknown"),
    ] {
        let file = format!("file_{name}.toml");
        write(&file, content);
        toytop(format!("constants {file}")).refused(2, &format!("{file} ... {parts}"));
    }
}

/// Changes a valid file in many ways, each of which is refused. A change is the replaced text, the new text, and parts of the message.
fn changes_are_refused(kind: &str, good: &str, changes: &[(&str, &str, &str)]) {
    toytop(format!("constants {}", scenario(&format!("good_{kind}"), good))).ok();
    for (index, (from, to, parts)) in changes.iter().enumerate() {
        assert!(good.contains(from), "{from}");
        let file = scenario(&format!("bad_{kind}_{index}"), &good.replacen(from, to, 1));
        toytop(format!("state {file} --times 1 --format json")).refused(2, &format!("{file} ... {parts}"));
    }
}

#[test]
fn wrong_tops_are_refused() {
    changes_are_refused(
        "top",
        &format!("{TOP}{RELEASE}"),
        &[
            ("gravity = 1", "gravity = -1", "top.gravity ... positive"),
            ("gravity = 1", "gravity = nan", "top.gravity ... number"),
            ("gravity = 1", "gravity = true", "top.gravity ... number"),
            ("gravity = 1", "gravity = \"1\"", "top.gravity ... number"),
            ("gravity = 1", "gravity = 1e61", "top.gravity ... 1e-60 and 1e60"),
            ("gravity = 1", "gravty = 1", "top.gravty ... unknown ... gravity"),
            ("gravity = 1", "support = \"hinge\"", "top.support ... \"sliding\", \"fixed\""),
            ("transverse_inertia = 1.1\n", "", "top.transverse_inertia ... missing ... 1e-60 and 1e60"),
            ("axial_inertia = 0.8\n", "", "top.axial_inertia ... missing ... twice transverse_inertia"),
            ("axial_inertia = 0.8", "axial_inertia = 2.3", "top.axial_inertia ... twice transverse_inertia"),
            ("gravity = 1", "rotor_momentum = 1e13", "top.rotor_momentum ... 1e12 per second"),
            ("com_height = 0.6\n", "", "top.com_height ... missing"),
            ("mass_moment = 0.9\n", "", "top.mass ... exactly one of mass, mass_moment"),
            ("mass_moment = 0.9", "mass = 0", "top.mass: must be positive, between 1e-60 and 1e60\n"),
            (
                "mass_moment = 0.9",
                "mass_moment = -0.0",
                "top.mass_moment: must be positive, between 1e-60 and",
            ),
            ("mass_moment = 0.9", "mass = 1.5\nmass_moment = 0.9", "top.mass_moment ... without mass"),
            ("gravity = 1", "support = \"fixed\"", "top.com_height ... fixed ... together with mass"),
            ("com_height = 0.6", "support = \"fixed\"\nmass = 1", "top.mass_moment ... without mass"),
            (
                "mass_moment = 0.9\ncom_height = 0.6",
                "support = \"fixed\"\nmass = 1",
                "top.com_height ... missing",
            ),
        ],
    );
}

#[test]
fn wrong_releases_are_refused() {
    changes_are_refused(
        "release",
        &format!("{TOP}{RELEASE}"),
        &[
            (
                "kind = \"release\"\n",
                "",
                "motion.kind ... missing ... \"release\", \"state\", \"branch_points\"",
            ),
            ("\"release\"", "\"throw\"", "motion.kind ... \"release\", \"state\", \"branch_points\""),
            ("\"release\"", "\"state\"", "motion.precession ... unneeded ... alpha, beta, omega"),
            ("tilt_deg = 40\n", "", "motion.tilt_deg ... missing ... [0, 180]"),
            ("spin = 3.5\n", "", "motion.spin ... missing"),
            ("tilt_deg = 40", "tilt_deg = 180.00000001", "motion.tilt_deg ... [0, 180]"),
            ("tilt_deg = 40", "tilt_deg = \"40\"", "motion.tilt_deg ... [0, 180]"),
            ("tilt_deg = 40", "tilt_deg = \"40 deg\"", "motion.tilt_deg: must be a number in [0, 180]\n"),
            (
                "precession = 0.3",
                "roll_deg = \"0.1 turns\"",
                "motion.roll_deg: must be a finite number of degrees\n",
            ),
            (
                "spin = 3.5",
                "spin = 1e9",
                "motion.spin ... e3 <= 1e14 ... support = \"free\" is then exact)\n",
            ),
            ("precession", "presession", "motion.presession ... unknown ... precession"),
            ("precession = 0.3", "e1 = 0.3", "motion.e1 ... unneeded ... kind = \"release\""),
            ("precession = 0.3", "roll_deg = nan", "motion.roll_deg ... degrees"),
        ],
    );
}

#[test]
fn wrong_states_are_refused() {
    let good =
        format!("{TOP}[motion]\nkind = \"state\"\nalpha = [0.6, 0]\nbeta = [0, 0.8]\nomega = [1, 2.5, 3]\n");
    changes_are_refused(
        "state",
        &good,
        &[
            ("alpha = [0.6, 0]\n", "", "motion.alpha ... missing ... [re, im]"),
            ("[0.6, 0]", "[0.6, \"0\"]", "motion.alpha ... two"),
            ("[0, 0.8]", "[0, nan]", "motion.beta ... finite"),
            ("[0, 0.8]", "[0, 0.800002]", "motion.alpha ... unit norm ... 1e-6"),
            ("[1, 2.5, 3]", "[1, 2.5, 1e13]", "motion.omega ... 1e12"),
            ("omega", "spin = 1\nomega", "motion.spin ... unneeded"),
        ],
    );
    let near = scenario("state_norm", &good.replace("[0, 0.8]", "[0, 0.8000003]"));
    toytop(format!("constants {near}")).ok();
}

#[test]
fn wrong_branch_points_are_refused() {
    changes_are_refused(
        "branch_points",
        &branch_points([0.2, 0.8, 1.5], 1),
        &[
            ("e1 = 0.2", "e1 = 0.9", "motion.e2 ... [e1, 1]"),
            ("e3 = 1.5", "e3 = 0.99", "motion.e3 ... [1, 1e14]"),
            ("e3 = 1.5\n", "", "motion.e3 ... missing"),
            ("sign_l_plus_n = 1", "sign_l_plus_n = 0", "motion.sign_l_plus_n ... 1 or -1"),
            ("sign_l_minus_n = 1\n", "", "motion.sign_l_minus_n ... missing ... 1 or -1"),
            ("e3 = 1.5", "e3 = 1.5\nnutation_phase = 1e7", "motion.nutation_phase ... 1e6"),
            (
                "e3 = 1.5",
                "e3 = 1.5\ntilt_deg = 3",
                "motion.tilt_deg ... unneeded ... kind = \"branch_points\"",
            ),
        ],
    );
}

/// The message names the greatest rate.
#[test]
fn a_refusal_names_the_greatest_rate() {
    let good = format!("{TOP}{RELEASE}");
    for (from, key) in [("= 3.5", "spin"), ("= 0.3", "precession")] {
        let file = scenario("greatest_rate", &good.replace(from, "= 1e9"));
        toytop(format!("constants {file}")).refused(2, &format!("motion.{key}: must be slow enough for e3"));
    }
}
