//! `toytop bake`: contents of the files, choice of the size, and complete files.

use crate::command::{
    RELEASE, TOP, all_refused, count, folder, motion_without_table, read, repository, run, scenario, slender,
    toytop,
};

/// The table that `spin_m0` has in flash is the one that this program writes.
#[test]
fn the_firmware_has_todays_table() {
    let committed = read(&repository("firmware-examples/src/tables/toy_top.rs"));
    assert_eq!(toytop("bake @toy_top --scalar q31").ok(), committed);
}

#[test]
fn the_size_is_chosen_and_stated() {
    let slender = scenario("bake_slender", &slender([-0.9, 0.99, 1.18], ["5.4e-3", "5e-3"]));
    for (file, scalar, word, [segments, terms]) in [
        ("@toy_top", "f32", "f32", [25, 5]),
        ("@toy_top", "f64", "f64", [48, 11]),
        ("@toy_top", "q31", "toytop::fixed::types::I2F30", [32, 4]),
        ("@toy_top", "q15", "toytop::fixed::types::I2F14", [16, 3]),
        (&slender, "f32", "f32", [128, 5]),
        (&slender, "f64", "f64", [128, 11]),
    ] {
        let run = toytop(format!("bake {file} --scalar {scalar}"));
        let stated = format!(": {segments}x{terms} in {scalar}, ");
        assert!(run.err.contains(&stated) && run.err.contains(" rad a tick"), "{}", run.err);
        assert!(run.out.contains(&format!("toytop::SizedTable<{word}, {segments}>")), "{file} {scalar}");
    }
    assert!(toytop("bake --help").ok().contains("toytop bake top.toml"));
}

/// A refusal names a size that is enough.
#[test]
fn the_least_size_is_named() {
    let summary = |line: &str| toytop(format!("bake {line}")).err.lines().next().expect("a line").to_owned();
    // the pendulum needs 17 to 25 segments in f32
    for (line, enough) in [
        ("@pendulum --scalar f32 --segments 8", 25),
        ("@pendulum --scalar f32 --segments 16", 25),
        ("@toy_top --scalar q15 --segments 8", 16),
    ] {
        let refused = summary(line);
        assert!(refused.ends_with(&format!("; at least {enough} segments would be enough")), "{refused}");
    }
    toytop("bake @pendulum --segments 25").ok();
}

#[test]
fn a_failed_bake_writes_nothing() {
    folder("bake_refused");
    all_refused(
        "bake -o bake_refused/top.rs",
        &[
            ("@toy_top --segments 17", "--segments: 17: must be"),
            ("@toy_top --segments 25x5", "--segments"),
            ("@toy_top --hertz 0", "44100/2"),
            ("@toy_top --hertz 0/2", "44100/2"),
            ("@toy_top --hertz 44100/x", "44100/2"),
            ("@toy_top --lang ada", "rust, c"),
            (&scenario("bake_broken", TOP), "motion: missing"),
        ],
    );
    all_refused("bake @toy_top", &[("-o no/such/folder/top.h", "no/such/folder/top.h")]);
    let motion_without_table =
        format!("bake -o bake_refused/top.rs {}", motion_without_table("bake_motion_without_table"));
    toytop(&motion_without_table).refused(3, "bake_motion_without_table: no table");
    toytop(motion_without_table + " --segments 32")
        .refused(3, "bake_motion_without_table: no table: a table of 32 segments");
    assert_eq!(count("bake_refused"), 0);
}

#[test]
fn any_file_name_makes_an_identifier() {
    for (name, identifier) in [("bake 1-é*", "BAKE_1_U00E9"), ("1st bake", "TOP_1ST_BAKE")] {
        let file = scenario(name, &format!("{TOP}{RELEASE}"));
        assert!(run(&["bake", &file]).ok().contains(&format!("pub static {identifier}: ")), "{name}");
    }
}
