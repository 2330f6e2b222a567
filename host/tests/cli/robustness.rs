//! Tests with killed processes, full disks, closed pipes and special files: files are complete or missing, and failures are one line with
//! the right exit code.

use super::killed::{files, is_whole, killed};
use super::{PROGRAM, folder, run, sample, scenario, stderr, stdout};
use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant, SystemTime};

/// Size of the buffer of a pipe in Linux, bytes.
const PIPE: usize = 65_536;

fn text(path: &Path) -> &str {
    path.to_str().expect("UTF-8")
}

#[test]
fn a_killed_bake_leaves_the_old_table_or_the_new() {
    let folder = folder("robust_bake");
    let path = folder.join("top.rs");
    let toy_top = sample("toy_top");
    let arguments = ["bake", &toy_top, "--scalar", "f64", "-o", text(&path)];
    let started = Instant::now();
    assert_eq!(run(&arguments).status.code(), Some(0));
    let whole = started.elapsed();
    let new = fs::read(&path).expect("the table");
    let mut kills = 0;
    for part in 0..24 {
        fs::write(&path, "old").expect("written");
        kills += u32::from(killed(&arguments, whole * part / 16, || {
            let left = fs::read(&path).expect("the table is there");
            assert!(left == b"old" || left == new, "part {part}: {} bytes", left.len());
        }));
    }
    assert!(kills > 0, "never killed in time");
}

#[test]
fn hidden_files_of_a_killed_process_are_removed() {
    let folder = folder("robust_leftovers");
    let long_ago = SystemTime::now() - Duration::from_secs(3600);
    let leave = |name: &str, time: SystemTime| {
        let file = fs::File::create(folder.join(name)).expect("a file");
        file.set_modified(time).expect("its time");
    };
    leave(".top.rs.12345", long_ago);
    // a file that another process is writing, and files with similar names
    let kept = [".top.rs.54321", ".top.rs.orig", ".top.c.12345", "top.rs.12345"];
    leave(kept[0], SystemTime::now());
    kept[1..].iter().for_each(|name| leave(name, long_ago));
    let toy_top = sample("toy_top");
    assert_eq!(run(&["bake", &toy_top, "-o", text(&folder.join("top.rs"))]).status.code(), Some(0));
    assert!(!folder.join(".top.rs.12345").exists());
    assert!(kept.iter().all(|name| folder.join(name).exists()));
}

#[test]
fn killed_figures_are_whole_or_not_there() {
    let folder = folder("robust_figures");
    let arguments = ["figures", "-o", text(&folder)];
    let started = Instant::now();
    assert_eq!(run(&arguments).status.code(), Some(0));
    let whole = started.elapsed();
    for share in [0.0, 0.5, 0.9, 1.1] {
        killed(&arguments, whole.mul_f64(share), || {
            let files = files(&folder);
            assert_eq!(files.len(), 8, "{share}");
            for (name, bytes) in files {
                assert!(is_whole(&name, &bytes), "{share}: {name}, {} bytes", bytes.len());
            }
        });
    }
}

/// Output of a script in Bash, which has limits on file sizes and exit codes of pipes.
fn bash(script: &str, arguments: &[&str]) -> std::process::Output {
    Command::new("bash").args(["-c", script, PROGRAM]).args(arguments).output().expect("bash runs")
}

#[test]
fn a_full_disk_leaves_no_file_and_exits_with_1() {
    let toy_top = sample("toy_top");
    let output = bash("\"$0\" \"$@\" > /dev/full", &["state", &toy_top, "--times", "1"]);
    let message = stderr(&output).to_owned();
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(message.contains("No space left") && message.matches('\n').count() == 1, "{message}");

    // like a full disk, a limit on the size of files allows a part of the file
    let limited = "trap '' XFSZ; ulimit -f 4; exec \"$0\" \"$@\"";
    let folder = folder("robust_full");
    let path = folder.join("top.rs");
    let picture = folder.join("top.svg");
    let rows = folder.join("rows.csv");
    for (arguments, path) in [
        (vec!["bake", &toy_top, "--scalar", "f64", "-o", text(&path)], &path),
        (vec!["plot", &toy_top, "-o", text(&picture)], &picture),
        (vec!["sweep", "--motions", "100", "-o", text(&rows)], &rows),
        (vec!["figures", "-o", text(&folder)], &folder),
    ] {
        let output = bash(limited, &arguments);
        let message = stderr(&output).to_owned();
        assert_eq!((output.status.code(), stdout(&output)), (Some(1), ""), "{arguments:?}: {message}");
        assert!(message.contains(text(path)) && message.contains("too large"), "{message}");
        assert_eq!(message.matches('\n').count(), 1, "{message}");
    }
    // a sweep keeps its rows, because it can be continued
    let left = fs::read_dir(&folder).expect("the folder").map(|entry| entry.expect("an entry").file_name());
    assert_eq!(left.collect::<Vec<_>>(), ["rows.csv"]);
    let output = run(&["sweep", "--motions", "100", "-o", text(&rows), "--resume"]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert_eq!(fs::read_to_string(&rows).expect("the rows").lines().count(), 101);
}

#[cfg(target_os = "linux")]
#[test]
fn devices_and_pipes_are_not_replaced() {
    let folder = folder("robust_device");
    let toy_top = sample("toy_top");
    let full = folder.join("full.rs");
    std::os::unix::fs::symlink("/dev/full", &full).expect("a link");
    let output = run(&["bake", &toy_top, "-o", text(&full)]);
    assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
    assert!(stderr(&output).contains("No space left"), "{}", stderr(&output));
    assert!(fs::symlink_metadata(&full).expect("the link").is_symlink());

    let (link, file) = (folder.join("link.rs"), folder.join("file.rs"));
    fs::write(&file, "old").expect("written");
    std::os::unix::fs::symlink(&file, &link).expect("a link");
    assert_eq!(run(&["bake", &toy_top, "-o", text(&link)]).status.code(), Some(0));
    assert!(fs::symlink_metadata(&link).expect("the link").is_symlink());
    assert!(fs::read_to_string(&file).expect("the table").contains("toytop"));
}

#[test]
fn a_place_that_cannot_be_written_exits_with_2() {
    let toy_top = sample("toy_top");
    let below_a_file = format!("{toy_top}/x");
    for place in [&*below_a_file, "/proc/toytop"] {
        let [svg, rs, csv] = ["svg", "rs", "csv"].map(|ending| format!("{place}.{ending}"));
        for arguments in [
            vec!["plot", &toy_top, "-o", &svg],
            vec!["bake", &toy_top, "-o", &rs],
            vec!["sweep", "--motions", "10", "-o", &csv],
            vec!["figures", "-o", place],
        ] {
            let output = run(&arguments);
            let message = stderr(&output);
            assert_eq!((output.status.code(), stdout(&output)), (Some(2), ""), "{arguments:?}: {message}");
            assert!(
                message.contains(place) && message.matches('\n').count() == 1,
                "{arguments:?}: {message}"
            );
        }
    }
}

#[test]
fn a_reader_that_closes_the_pipe_is_no_failure() {
    let toy_top = sample("toy_top");
    let times = vec!["0.5"; 2000].join(",");
    for (arguments, is_long) in [
        (vec!["state", &toy_top, "--times", &times], true),
        (vec!["bake", &toy_top, "--scalar", "f64", "--size", "512"], true),
        (vec!["bake", &toy_top, "--scalar", "f64", "--size", "512", "--lang", "c"], true),
        (vec!["constants", &toy_top], false),
        (vec!["completions", "bash"], false),
        (vec!["--help"], false),
    ] {
        // a pipe accepts as many bytes as its buffer even if they are not read
        assert_eq!(run(&arguments).stdout.len() > 2 * PIPE, is_long, "{arguments:?}");
        let output = bash("\"$0\" \"$@\" | head -c 1; exit ${PIPESTATUS[0]}", &arguments);
        assert_eq!((output.status.code(), stdout(&output).len()), (Some(0), 1), "{arguments:?}");
        // `bake` prints its summary to stderr
        assert!(!stderr(&output).contains("error"), "{arguments:?}: {}", stderr(&output));
    }
}

#[test]
fn invalid_scenario_files_are_refused_at_once() {
    let sparse = scenario("robust_100_mb", "");
    fs::File::options().write(true).open(&sparse).and_then(|file| file.set_len(100_000_000)).expect("a hole");
    let directory = folder("robust_scenario");
    let cases: [(&str, &str); 4] = [
        (&sparse, "1 MiB"),
        ("/dev/zero", "1 MiB"),
        (text(&directory), "directory"),
        ("/dev/null", "missing"),
    ];
    for (file, part) in cases {
        for arguments in [
            vec!["state", file, "--times", "1"],
            vec!["constants", file],
            vec!["compare", file],
            vec!["bake", file],
            vec!["plot", file, "-o", "x.svg"],
        ] {
            let output = run(&arguments);
            let message = stderr(&output);
            assert_eq!((output.status.code(), stdout(&output)), (Some(2), ""), "{arguments:?}: {message}");
            assert!(message.contains(file) && message.contains(part), "{arguments:?}: {message}");
            assert_eq!(message.matches('\n').count(), 1, "{arguments:?}: {message}");
        }
    }
    let toy_top = sample("toy_top");
    let output = run(&["state", &toy_top, "--times-file", "/dev/zero"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("64 MiB"), "{}", stderr(&output));
}
