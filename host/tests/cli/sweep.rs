//! `toytop sweep`: rows that do not depend on who computes them, and a file that survives being killed.

mod files;
mod launches;
#[cfg(feature = "parquet")]
mod parquet;

use super::{json, run, stderr, stdout};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

/// A file that is not there.
fn no_file(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("sweep_{name}.csv"));
    // left over from an earlier run, or never there
    let _ = std::fs::remove_file(&path);
    path
}

fn words<'a>(path: &'a Path, more: &[&'a str]) -> Vec<&'a str> {
    let mut words = vec!["sweep", "-o", path.to_str().expect("UTF-8")];
    words.extend(more);
    words
}

/// The file that a sweep writes.
fn sweep(path: &Path, more: &[&str]) -> String {
    let output = run(&words(path, more));
    assert_eq!(output.status.code(), Some(0), "{more:?}: {}", stderr(&output));
    assert!(stdout(&output).contains(" motions"), "{}", stdout(&output));
    std::fs::read_to_string(path).expect("the file")
}

fn refused(path: &Path, more: &[&str], part: &str) {
    let before = std::fs::read(path).ok();
    let output = run(&words(path, more));
    let message = stderr(&output);
    assert_eq!((output.status.code(), stdout(&output)), (Some(2), ""), "{more:?}: {message}");
    assert!(message.contains(part) && message.matches('\n').count() == 1, "{more:?}: {message}");
    assert_eq!(std::fs::read(path).ok(), before, "{more:?}");
}

/// The fields of a row by name.
fn field<'a>(table: &'a str, row: usize, name: &str) -> &'a str {
    let mut lines = table.lines();
    let header = lines.next().expect("a header");
    let place = header.split(',').position(|column| column == name).expect(name);
    lines.nth(row).expect("a row").split(',').nth(place).expect("a field")
}

/// A grid of 36 places, of which six have e1 > e2.
const GRID: [&str; 9] =
    ["--e1=-0.5..0.5/3", "--e2", "0.2,0.6", "--e3", "log:1.1..9/3", "--a-over-ps", "1", "--c-over-a", "0.7"];

/// A sweep that is killed.
const KILLED: [&str; 5] = ["--motions", "6000", "--seed", "7", "--resume"];

/// Kills it when so many lines are in its CSV file; how many there were then.
fn killed(output: &Path, csv: &Path, least: usize) -> usize {
    let rows = || std::fs::read_to_string(csv).map_or(0, |text| text.matches('\n').count());
    let mut child = Command::new(super::PROGRAM)
        .args(words(output, &KILLED))
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program runs");
    while rows() < least && child.try_wait().expect("a child").is_none() {
        std::thread::sleep(Duration::from_millis(1));
    }
    let seen = rows();
    child.kill().expect("killed"); // SIGKILL
    child.wait().expect("ended");
    seen
}

#[test]
fn a_killed_sweep_goes_on_where_it_was() {
    let whole = sweep(&no_file("whole"), &KILLED);
    assert_eq!(whole.lines().count(), 6001);
    let path = no_file("killed");
    let mut kills = 0;
    // on a busy machine a sweep may end before it is killed
    for _ in 0..20 {
        let Some(least) = [1000, 3000].get(kills) else { break };
        let seen = killed(&path, &path, *least);
        let left = std::fs::read_to_string(&path).expect("the file");
        assert!(left.matches('\n').count() >= seen && whole.starts_with(&left), "what is there is good");
        if left.len() < whole.len() {
            kills += 1;
        } else {
            std::fs::remove_file(&path).expect("removed");
        }
    }
    assert_eq!(kills, 2, "killed before the end");
    // as if the last write had been cut off, or the machine, which leaves zeros
    let left = std::fs::read_to_string(&path).expect("the file");
    let zeros = "\0".repeat(10_000_000);
    std::fs::write(&path, left[..left.len() - 30].to_owned() + &zeros).expect("writable");
    assert!(sweep(&path, &KILLED) == whole);
    assert!(sweep(&path, &KILLED) == whole, "nothing is left to do");
}

#[test]
fn shards_make_the_whole() {
    let whole = sweep(&no_file("grid"), &GRID);
    let mut parts = Vec::new();
    for shard in 1..=5 {
        let shard = format!("{shard}/5");
        let more = [&GRID[..], &["--shard", &shard]].concat();
        let part = sweep(&no_file(&format!("grid_{}", &shard[..1])), &more);
        assert_eq!(part.lines().next(), whole.lines().next());
        parts.extend(part.lines().skip(1).map(str::to_owned));
    }
    parts.sort_by_key(|row| row.split(',').next().and_then(|index| index.parse::<u64>().ok()));
    assert_eq!(parts, whole.lines().skip(1).collect::<Vec<_>>());
    assert!(parts.iter().enumerate().all(|(index, row)| row.starts_with(&format!("{index},"))));
    assert_eq!(parts.len(), 36);
    // e1 = 0.5 > e2 = 0.2 is a place of the grid, but no motion
    let refused: Vec<_> = parts.iter().filter(|row| row.contains(",refused,")).collect();
    assert_eq!(refused.len(), 6);
    let output = run(&words(&no_file("grid_counted"), &GRID));
    assert!(
        stdout(&output).contains(": 36 motions, 6 of them refused (first: row 12, e"),
        "{}",
        stdout(&output)
    );
    assert!(parts.iter().all(|row| row.split(',').count() == 17) && refused[0].contains(",refused,,,,,"));
}

#[test]
fn a_row_says_what_constants_and_state_say() {
    let columns =
        "regime,tip_class,l,n,h,period,alpha_turns,beta_turns,phi_per_period,min_normal_force,u,phi,tip";
    let more = ["--motions", "20", "--columns", columns, "--ticks", "3", "--periods", "2.5"];
    let table = sweep(&no_file("row"), &more);
    for row in [0, 7, 19] {
        let cell = |name: &str| field(&table, row, name);
        let number = |name: &str| cell(name).parse::<f64>().expect(name);
        let a = number("a_over_ps");
        let file = super::scenario(
            &format!("sweep_row_{row}"),
            &format!(
                "[top]\nmass_moment = 1\ncom_height = 1\ntransverse_inertia = {a:?}\naxial_inertia = {:?}\ngravity = 1\n\
                 [motion]\nkind = \"branch_points\"\ne1 = {}\ne2 = {}\ne3 = {}\nsign_l_plus_n = {}\nsign_l_minus_n = {}\n",
                number("c_over_a") * a,
                cell("e1"),
                cell("e2"),
                cell("e3"),
                cell("sign_l_plus_n"),
                cell("sign_l_minus_n"),
            ),
        );
        let constants = json(&["constants", &file, "--format", "json"]);
        for name in columns.split(',').take(10) {
            match constants[name].as_f64() {
                Some(expected) => assert_eq!(number(name), expected, "{row}: {name}"),
                None => assert_eq!(constants[name], cell(name), "{row}: {name}"),
            }
        }
        // the times are not in the row: a third of 2.5 periods each, moved on by multiples of the golden section
        let part = 2.5 * number("period") / 3.0;
        let golden = (5_f64.sqrt() - 1.0) / 2.0;
        for tick in 1..=3 {
            let t = part * (f64::from(tick - 1) + (f64::from(tick) * golden).fract());
            let sample = &super::samples(&file, &format!("{t:?}"), &[])[0];
            let pairs = [
                ("u", &sample["u"]),
                ("alpha_re", &sample["alpha"][0]),
                ("alpha_im", &sample["alpha"][1]),
                ("beta_re", &sample["beta"][0]),
                ("beta_im", &sample["beta"][1]),
                ("tip_x", &sample["tip"][0]),
                ("tip_y", &sample["tip"][1]),
            ];
            for (name, expected) in pairs {
                let off = number(&format!("{name}_{tick}")) - expected.as_f64().expect("a number");
                assert!(off.abs() < 3e-13, "{row}: {name}_{tick}: {off:e}");
            }
        }
    }
}

#[test]
fn errors_are_those_of_the_scalars() {
    let columns = "error_f32,bound_f32,segments_f32,full_error_f64,full_error_f32";
    let axes = ["--e1=-0.9..0.2", "--e2", "0.3..0.9", "--e3", "1.2..3", "--a-over-ps", "0.5..2"];
    let table = sweep(&no_file("errors"), &[&["--motions", "40", "--columns", columns][..], &axes].concat());
    for row in 0..40 {
        let [error, bound, segments, double, single] =
            ["error_f32", "bound_f32", "segments_f32", "full_error_f64", "full_error_f32"]
                .map(|name| field(&table, row, name).parse::<f64>().expect(name));
        assert!(error > 1e-8 && error < bound && bound < 1e-6, "{error:e} {bound:e}");
        assert!(
            double > 1e-16 && double < 1e-12 && (single - error).abs() <= double,
            "{double:e} {single:e}"
        );
        // nothing here is near a corner
        assert!(segments == 16.0, "{segments}");
    }
}

#[test]
fn what_is_no_sweep_is_refused() {
    let path = no_file("refused");
    for (more, part) in [
        (&[][..], "--e1: -1..1 in a grid"),
        (&["--motions", "3", "--e1", "2"], "--e1: 2: must be within [-1, 1]"),
        (&["--motions", "3", "--e3", "x"], "'--e3 <AXIS>'"),
        (&["--motions", "3", "--e1", "0.5", "--e2", "0"], "e1 <= e2"),
        (&["--motions", "0"], "--motions"),
        (&["--motions", "3", "--shard", "0/4"], "I/N with I from 1 to N"),
        (&["--motions", "3", "--shard", "5/4"], "I/N with I from 1 to N"),
        (&["--motions", "3", "--columns", "colour"], "tip_class"),
        (&["--motions", "3", "--ticks", "0"], "--ticks"),
        (&["--motions", "3", "--periods", "-1"], "--periods"),
    ] {
        refused(&path, more, part);
    }
    let text = sweep(&path, &["--motions", "30"]);
    refused(&path, &["--motions", "30"], "--resume");
    for other in [["--seed", "2"], ["--columns", "u"], ["--shard", "1/2"], ["--e1", "-0.9..1"]] {
        refused(&path, &[&["--motions", "30", "--resume"][..], &other].concat(), "another sweep");
    }
    refused(&path, &["--motions", "29", "--resume"], "another sweep");
    std::fs::write(&path, text.replacen("\n12,30,0.1", "\n12,30,9.1", 1)).expect("writable");
    refused(&path, &["--motions", "30", "--resume"], "line 14: does not match its checksum");
    std::fs::write(&path, "something else").expect("writable");
    refused(&path, &["--motions", "30", "--resume"], "another sweep");
    let folder = path.join("file.csv");
    refused(&folder, &["--motions", "3"], "--output");
}

/// One process continues a file while another that tries to is refused; no row is lost or repeated.
#[test]
fn one_file_has_one_writer() {
    let whole = sweep(&no_file("one_writer_whole"), &KILLED);
    let path = no_file("one_writer");
    for _ in 0..4 {
        let _ = std::fs::remove_file(&path);
        let start = || {
            Command::new(env!("CARGO_BIN_EXE_toytop"))
                .args(words(&path, &KILLED))
                .stdout(Stdio::null())
                .stderr(Stdio::piped())
                .spawn()
                .expect("the program runs")
        };
        let mut outputs: Vec<_> = [start(), start(), start()]
            .into_iter()
            .map(|child| child.wait_with_output().expect("ended"))
            .collect();
        outputs.retain(|output| !output.status.success());
        for output in &outputs {
            assert_eq!(output.status.code(), Some(2), "{}", stderr(output));
            assert!(stderr(output).contains("another toytop is writing it"), "{}", stderr(output));
        }
        assert!(!outputs.is_empty() && outputs.len() < 3);
        assert!(std::fs::read_to_string(&path).expect("the file") == whole);
    }
}

/// An output that is no regular file is refused at once, also where reading it would wait for ever.
#[cfg(unix)]
#[test]
fn only_a_regular_file_is_gone_on_with() {
    let pipe = no_file("pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().expect("mkfifo runs").success());
    for path in [pipe.to_str().expect("UTF-8"), "/dev/null"] {
        for more in [&["--motions", "3", "--resume"][..], &["--motions", "3"]] {
            let output = Command::new("timeout")
                .args(["20", env!("CARGO_BIN_EXE_toytop")])
                .args(words(Path::new(path), more))
                .output()
                .expect("timeout runs");
            let message = stderr(&output);
            assert_eq!(output.status.code(), Some(2), "{path} {more:?}: {message}");
            assert!(message.contains("must be a regular file, or - for stdout"), "{path}: {message}");
        }
    }
}

#[test]
fn a_minus_is_stdout() {
    let more = ["--motions", "1500", "--columns", "regime,u"];
    let whole = sweep(&no_file("in_a_file"), &more);
    let output = run(&words(Path::new("-"), &more));
    assert!(output.status.success() && stdout(&output) == whole, "{}", stderr(&output));
    assert!(stderr(&output).contains("1500 motions"), "{}", stderr(&output));
    assert!(!Path::new("-").exists());
    refused(Path::new("-"), &["--motions", "3", "--resume"], "--resume: needs a file");
    let pipe = format!(
        "'{}' sweep -o - --motions 20000 --columns regime 2> /dev/null | head -n 1; exit ${{PIPESTATUS[0]}}",
        env!("CARGO_BIN_EXE_toytop")
    );
    let output = Command::new("bash").args(["-c", &pipe]).output().expect("bash runs");
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert!(stdout(&output).starts_with("index,motions,version,seed,"), "{}", stdout(&output));
}

#[cfg(not(feature = "parquet"))]
#[test]
fn what_was_built_without_parquet_says_so() {
    refused(&no_file("none").with_extension("parquet"), &["--motions", "3"], "built without Parquet");
}
