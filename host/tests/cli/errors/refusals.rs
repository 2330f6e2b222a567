//! Bad arguments: exit code 2, nothing on stdout, one line on stderr that names the option and the allowed values.

use crate::command::{
    RELEASE, TOP, all_refused, branch_points, motion_without_table, scenario, toytop, write,
};

#[test]
fn wrong_arguments_are_refused() {
    write("far.txt", "1e300\n");
    write("no_times.txt", "# none\n\n");
    all_refused(
        "",
        &[
            ("", "--help"),
            ("plot", "--output ... SCENARIO"),
            ("draw", "draw"),
            ("stat", "'stat'; some similar subcommands exist: ... 'state'"),
            ("timings quickly", "quickly"),
            ("constants", "SCENARIO"),
            ("constants @toy_top --format xml", "--format ... table, csv, json"),
            ("constants @no_such_file", "no_such_file.toml ... No such file"),
            ("constants .", "directory"),
            ("compare @toy_top @no_such_file", "no_such_file.toml"),
            ("compare --periods 0", "--periods ... 1..=10000"),
            ("compare --scalar f64,q7", "--scalar ... f64, f32, q31, q15, all"),
            ("animate @toy_top --duration -1 -o x.gif", "'-1' for '--duration <S>' ... 0.1 to 600"),
            ("fit x.csv --top @toy_top --huber -1", "'-1' for '--huber <X>' ... a number from 1"),
            ("bake @toy_top --segments -8", "'-8' for '--segments <N>'"),
            ("plot @toy_top --size -100 -o x.svg", "'-100' ... 100..=10000"),
            ("simulate @toy_top -o no_such_folder/f.csv", "error: --output: no_such_folder/f.csv: "),
            ("state @lagrange --times 1,-1e300 --method closed-form", "times ... -1e300 ... closed-form"),
        ],
    );
    all_refused(
        "state @toy_top",
        &[
            ("", "--times ... --times-file"),
            ("--times 1 --times-file x", "--times ... --times-file"),
            ("--times 1,,2", "--times ... finite number"),
            ("--times 1,NaN", "--times ... NaN ... finite number"),
            ("--times 0..1", "'0..1' for '--times <T1,T2,...>' ... must be X,Y,... or LOW..HIGH/COUNT"),
            ("--times 10..0/5", "--times ... LOW must be below HIGH\n"),
            ("--times log:0..1/3", "--times ... LOW must be above 0 with log:"),
            ("--times 0..1/1", "--times ... COUNT must be a whole number from 2 to 4294967295"),
            ("--times 0..1/x", "--times ... COUNT must be a whole number from 2 to 4294967295"),
            ("--times 0..x/3", "--times ... must be a finite number"),
            ("--times 1..", "--times ... must be a finite number"),
            ("--times log:3", "--times ... must be a finite number"),
            ("--times 0..1/60000000", "--times: 60000000 times: must be at most 10000000"),
            ("--times 1,-1e300", "error: --times: -1e300 must be within ±2.8e14 s"),
            ("--times-file @no_such_file", "no_such_file.toml"),
            ("--times-file @toy_top", "toy_top.toml ... line 3 ... finite number"),
            ("--times-file far.txt", "error: --times-file: far.txt: 1e300 must be within ±"),
            ("--times-file no_times.txt", "no_times ... at least one"),
            ("--times-file /dev/zero", "256 MiB"),
            ("--ticks 1..0", "--ticks: 1..0: must be N1,N2,... or FIRST..LAST"),
            ("--ticks 1.5", "--ticks: 1.5: must be N1,N2,... or FIRST..LAST"),
            ("--ticks 1,,2", "--ticks: 1,,2: must be N1,N2,... or FIRST..LAST"),
            ("--ticks 0..99999999999999999999", "--ticks: 0..99999999999999999999: must be"),
            ("--ticks 0..10000000", "--ticks: 0..10000000: 10000001 times: must be at most 10000000"),
            ("--ticks 1 --hertz 0/1", "--hertz"),
            ("--times 1 --hertz 5", "'--times <T1,T2,...>' cannot be used with '--hertz <N>'"),
            ("--from 0 --to 1", "--count"),
            ("--from 1 --to 0 --count 3", "--from must be below --to"),
            ("--from 0 --to 1 --count 3 --times 1", "cannot be used with"),
            ("--times 1 --columns t,speed", "speed"),
            ("--times 1 --method euler", "euler ... ephemeris, stepper, full, closed-form"),
            ("--times 1 --scalar q7", "q7 ... f64, f32, q31, q15"),
            ("--times 1 --scalar q31 --method full", "--scalar ... f64"),
            ("--times 1 --scalar q31 --method stepper", "--method stepper ... q31 ... --method ephemeris"),
            ("--times 1 --scalar f32 --method closed-form", "--scalar ... f64"),
            ("--times 1 --steps-per-period 0", "1..=16777216"),
            ("--times 1 --steps-per-period 16777217", "1..=16777216"),
            ("--times 1 --steps-per-period 10", "error: --steps-per-period: needs --method stepper\n"),
            ("--times 1e6,-1e6 --method stepper", "--times ... at most 1e10 steps"),
        ],
    );
    all_refused(
        "events @toy_top",
        &[
            ("--kind tilt", "must be turning, tilt=DEGREES"),
            ("--kind tilt=x", "must be a number from 0 to 180 degrees"),
            ("--kind tilt=200", "must be a number from 0 to 180 degrees"),
            ("--kind tilt=nan", "must be a number from 0 to 180 degrees"),
            ("--kind circle=0", "must be a number above 0"),
            ("--kind circle=-1", "must be a number above 0"),
            ("--kind circle=0.04", "must be above 0 and below 0.03"),
            ("--kind turning:left", "must be turning"),
            ("--kind lift-off=1", "must be turning"),
            ("--count 0", "1..=1000000"),
            ("--from NaN", "must be a finite number"),
            ("--from 1e300", "must be within"),
        ],
    );
}

#[test]
fn wrong_arguments_of_benchmarks_and_checks_are_refused() {
    write("rows.csv", "t,w,x,y,z\n0,1,0,0,0\n");
    write("no_program.elf", "");
    all_refused(
        "",
        &[
            ("events no_such_file.toml", "no_such_file.toml"),
            ("benchmark nothing", "benchmark: nothing: must be one of bruls_cardona"),
            ("benchmark parker --times x", "--times"),
            ("benchmark parker --times 1e300", "must be within"),
            ("benchmark --times 1", "NAME"),
            ("score --benchmark nothing rows.csv", "--benchmark: nothing: must be one of"),
            ("score rows.csv", "RESULT.csv"),
            ("score --benchmark parker", "RESULT.csv"),
            ("accuracy --scalar q7", "q31, q15, all"),
            ("accuracy --accept page.md", "page.md"),
            ("budget --chip m5", "m0plus, m4f, m7, m33, riscv"),
            ("budget --clock 0", "a number above 0"),
            ("budget --elf no_program.elf", "--chip"),
            ("budget --elf no_program.elf --chip m4f", "no_program.elf"),
            ("budget --check --accept", "--accept"),
            ("budget --check --flash", "--flash"),
            ("study", "see toytop --help"),
            ("study fit --motions 0", "1..=100000000"),
            ("study corners --seed x", "--seed"),
            ("study corners --accept page.md", "page.md"),
        ],
    );
}

/// Messages are short for any input, and state the error.
#[test]
fn long_input_makes_no_long_message() {
    let long = "k".repeat(100_000);
    let text = format!("{TOP}{RELEASE}");
    let key = scenario("long_key", &format!("{text}{long} = 1\n"));
    let value = scenario("long_value", &text.replace("\"release\"", &format!("\"{long}\"")));
    let table = scenario("long_table", &format!("{text}[{long}]\n"));
    for (line, parts) in [
        (format!("constants {key}"), "motion.kkkk ... unknown or unneeded key; allowed"),
        (format!("constants {value}"), "motion.kind ... must be one of"),
        (format!("constants {table}"), "kkkk ... unknown key; allowed"),
        (format!("state {key} --times {long}"), "kkk"),
        (format!("constants {long}"), "kkk"),
        (format!("sweep {key} -o x.csv --part 1/99999999999"), "--part ... N at most 2^32"),
        (format!("sweep {key} -o x.csv --part {long}"), "--part"),
    ] {
        let run = toytop(line);
        run.refused(2, parts);
        assert!(run.err.len() < 1200, "{}", run.err.len());
    }
}

/// A method that does not apply exits with 3, and its message names another.
#[test]
fn a_method_that_does_not_apply() {
    let motion_without_table = motion_without_table("motion_without_table");
    let rising = scenario("rising", &branch_points([0.2, 1.0, 1.0], 1));
    for (line, parts) in [
        (
            &*format!("{rising} --times 1 --scalar f32"),
            "rising: --scalar: f32: an aperiodic motion has a closed form in f64, and no table",
        ),
        (
            "@toy_top --times 1e6 --method full",
            "toy_top: full solver: gives up at t = 3.59e3 ... evaluations ... ask for earlier times",
        ),
        ("@toy_top --times 1 --method closed-form", "toy_top:  ... e3 = e4 ... e2 = e3 = 1"),
        ("@toy_top --times 1 --method closed-form --format json", "toy_top:  ... e3 = e4 ... e2 = e3 = 1"),
        (
            &format!("{motion_without_table} --times 1 --scalar f64"),
            "motion_without_table ... no table ... a table of 4096 segments ... segments of this degree would be enough",
        ),
        (
            &format!("{motion_without_table} --times 1 --scalar f32"),
            "motion_without_table ... no table ... a table of 4096 segments ... segments of this degree would be enough",
        ),
    ] {
        toytop(format!("state {line}")).refused(3, parts);
    }
}
