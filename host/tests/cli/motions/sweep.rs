//! `toytop sweep`: rows that do not depend on the part that computes them, and a file that is complete or absent.

use crate::command::{
    all_refused, bash, json, number, numbers, path, read, sample, samples, scenario, toytop, write,
};

/// Text of the file that a sweep writes.
fn sweep(to: &str, arguments: &str) -> String {
    // left over from an earlier run, or never there
    let _ = std::fs::remove_file(path(to));
    let run = toytop(format!("sweep -o {to} {arguments}"));
    assert!(run.err.contains(" motions"), "{}", run.err);
    assert_eq!(run.ok(), "");
    read(to)
}

/// Field of a row by name.
fn field<'a>(table: &'a str, row: usize, name: &str) -> &'a str {
    let mut lines = table.lines();
    let header = lines.next().expect("a header");
    let place = header.split(',').position(|column| column == name).expect(name);
    lines.nth(row).expect("a row").split(',').nth(place).expect("a field")
}

/// `cat` joins the parts, and their indices are those of the whole. The grid has 18 rows, of which three have e1 > e2.
#[test]
fn parts_make_the_whole() {
    for (name, more) in [
        ("grid", "@figure_3_loops --vary e1=-0.5..0.5/3 --vary e2=0.2,0.6 --vary e3=log:1.1..9/3"),
        ("lot", "@toy_top --motions 50 --spin log:100..1000 --tilt 1..30"),
    ] {
        let whole = sweep(&format!("sweep_{name}.csv"), more);
        let joined = [1, 2, 3, 4]
            .map(|part| sweep(&format!("sweep_{name}_{part}.csv"), &format!("{more} --part {part}/4")))
            .concat();
        let (header, rows) = joined.split_once('\n').expect("a header");
        let mut rows: Vec<_> = rows.lines().collect();
        rows.sort_by_key(|row| row.split(',').next().and_then(|index| index.parse::<u64>().ok()));
        assert_eq!([&[header], &rows[..]].concat(), whole.lines().collect::<Vec<_>>());
        assert!(rows.iter().enumerate().all(|(index, row)| row.starts_with(&format!("{index},"))));
    }
}

/// Every row is the scenario with its numbers.
#[test]
fn a_row_is_the_scenario_with_its_numbers() {
    let constant = "regime,tip_class,l,n,h,period,alpha_turns,beta_turns,phi_per_period,min_normal_force";
    let line = format!("@toy_top --columns {constant},u,alpha,beta,tip,phi --instants 3 --periods 2.5");
    let axes = "--spin 120..180/3 --tilt 0,20 --vary com_height=0.02,0.03";
    let table = sweep("sweep_launches.csv", &format!("{line} {axes}"));
    assert!(table.starts_with("index,spin,tilt_deg,com_height,regime,"), "{table}");
    assert_eq!(table.lines().count(), 13);
    let text = read(&sample("toy_top"));
    for row in 0..12 {
        let cell = |name: &str| field(&table, row, name);
        let [spin, tilt, height] =
            [["120.0", "150.0", "180.0"][row / 4], ["0.0", "20.0"][row / 2 % 2], ["0.02", "0.03"][row % 2]];
        for (name, expected) in [("spin", spin), ("tilt_deg", tilt), ("com_height", height)] {
            assert_eq!(cell(name).parse::<f64>(), expected.parse::<f64>(), "{row}: {name}");
        }
        let own = text
            .replace("spin = 150.0", &format!("spin = {spin}"))
            .replace("tilt_deg = 20.0", &format!("tilt_deg = {tilt}"))
            .replace("com_height = 0.03", &format!("com_height = {height}"));
        let own = scenario("launches_row", &own);
        let constants = json(format!("constants {own}"));
        for name in constant.split(',') {
            match constants[name].as_f64() {
                Some(expected) => assert_eq!(cell(name).parse(), Ok(expected), "{row}: {name}"),
                None => assert_eq!(constants[name].as_str().unwrap_or_default(), cell(name), "{row}: {name}"),
            }
        }
        if constants["regime"] != "nutating" {
            continue;
        }
        // the row has no times: there is one in each third of 2.5 periods, shifted by multiples of the golden section
        let part = 2.5 * number(&constants["period"]) / 3.0;
        for (tick, thirds) in [(1, 0.0), (2, 1.618_033_988_749_895), (3, 2.236_067_977_499_79)] {
            let t = part * thirds;
            let truth = numbers(&samples(format!("{own} --times={t:?}"))[0], "u alpha beta tip phi");
            let names = ["u", "alpha_re", "alpha_im", "beta_re", "beta_im", "tip_x", "tip_y", "phi"];
            for (name, expected) in names.into_iter().zip(truth) {
                let off = cell(&format!("{name}_{tick}")).parse::<f64>().expect(name) - expected;
                assert!(off.abs() < 3e-13, "{row}: {name}_{tick}: {off:e}");
            }
        }
    }
}

#[test]
fn numbers_that_a_scenario_cannot_have_are_refused_rows() {
    let table = sweep("sweep_refused.csv", "@toy_top --tilt -10..190/3 --columns regime,period");
    assert_eq!([0, 1, 2].map(|row| field(&table, row, "regime")), ["refused", "nutating", "refused"]);
    // the summary counts them, and says why the first one is no motion
    for (axes, summary) in [
        (
            "--tilt 0..602/10",
            ": 10 motions, 7 of them refused (first: row 3, tilt_deg = 200.67: must be a number in [0, 180]), in ",
        ),
        ("--tilt 0..602/10 --part 2/2", ": 5 motions, 4 of them refused (first: row 3, tilt_deg = 200.67: "),
        (
            "--vary com_height=-1,0.03",
            ": 2 motions, 1 of them refused (first: row 0, com_height = -1: must be positive, ",
        ),
        ("--tilt 0,180", ": 2 motions in "),
    ] {
        let run = toytop(format!("sweep -o sweep_counted.csv @toy_top {axes}"));
        assert!(run.err.contains(summary), "{}", run.err);
    }
}

#[test]
fn errors_are_those_of_the_scalars() {
    let axes = "--vary transverse_inertia=0.5..2 --vary e1=-0.9..0.2 --vary e2=0.3..0.9 --vary e3=1.2..3";
    let columns = ["error_f32", "bound_f32", "segments_f32"];
    let line = format!("@figure_3_loops --motions 40 --columns {} {axes}", columns.join(","));
    let table = sweep("sweep_errors.csv", &line);
    for row in 0..40 {
        let [error, bound, segments] =
            columns.map(|name| field(&table, row, name).parse::<f64>().expect(name));
        assert!(error > 1e-8 && error < bound && bound < 1e-6, "{error:e} {bound:e}");
        // no motion here is near a degenerate case
        assert!(segments == 16.0 || segments == 32.0, "{segments}");
    }
}

#[test]
fn a_refused_sweep_leaves_the_file() {
    write("sweep_kept.csv", "kept");
    all_refused(
        "sweep -o sweep_kept.csv @toy_top",
        &[
            ("--tilt 1..2", "tilt_deg: a range in a grid"),
            ("--vary speed=1,2", "speed: no number of this scenario; allowed: transverse_inertia"),
            ("--vary spin=1,2 --spin 3", "spin: must be given once only"),
            ("", "needs at least one of --spin"),
            ("--motions 3 --spin x", "'--spin <VALUES>'"),
            ("--motions 0", "--motions"),
            ("--motions 3 --part 0/4", "I/N with I from 1 to N"),
            ("--motions 3 --part 5/4", "I/N with I from 1 to N"),
            ("--motions 3 --columns colour", "tip_class"),
            ("--motions 3 --instants 0", "--instants"),
            ("--motions 3 --periods -1", "--periods"),
        ],
    );
    // the allowed keys in the reason are no axes
    let unknown = read(&sample("toy_top")).replace("spin =", "foo = 1\nspin =");
    let unknown = scenario("sweep_unknown_key", &unknown);
    toytop(format!("sweep -o sweep_kept.csv {unknown} --spin 90,100")).refused(2, "motion.foo: unknown");
    assert_eq!(read("sweep_kept.csv"), "kept");
    toytop("sweep -o no/such/folder/a.csv @toy_top --spin 1,2").refused(2, "--output");
    assert_eq!(toytop("sweep -o sweep_kept.csv --spin 1,2").code, Some(2));
}

#[test]
fn a_minus_is_stdout() {
    let more = "@toy_top --motions 1500 --spin 90..300 --columns regime,u";
    let whole = sweep("sweep_in_a_file.csv", more);
    let run = toytop(format!("sweep -o - {more}"));
    assert!(run.err.contains("1500 motions") && !path("-").exists(), "{}", run.err);
    assert_eq!(run.ok(), whole);
    let script = "\"$@\" 2> /dev/null | head -n 1; exit ${PIPESTATUS[0]}";
    let first = bash(script, "sweep @toy_top -o - --spin 90..300 --motions 20000 --columns regime").ok();
    assert!(first.starts_with("index,spin,regime"), "{first}");
}
