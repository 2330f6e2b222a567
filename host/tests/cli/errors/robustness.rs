//! Killed processes, full disks, closed pipes and special files: files are complete or missing, and failures are one line with
//! the right exit code.

use crate::command::{HERE, Run, bash, command, count, folder, path, read, sample, scenario, toytop, write};
use std::fs;
use std::process::Stdio;
use std::thread::sleep;
use std::time::{Duration, Instant, SystemTime};

/// Size of the buffer of a pipe in Linux, bytes.
const PIPE: usize = 65_536;

/// Kills a command after a time, if it still runs. `look` is called repeatedly before.
fn kill(line: &str, after: Duration, look: impl Fn()) {
    let started = Instant::now();
    let mut child =
        command(line).stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("the program runs");
    while started.elapsed() < after {
        look();
        sleep(Duration::from_micros(100));
    }
    child.kill().expect("it can be killed");
    child.wait().expect("it ends");
    look();
}

/// Checks that a file is written by a command as a whole, even if the command is killed.
fn is_written_as_a_whole(line: &str, to: &str) {
    let started = Instant::now();
    toytop(line).ok();
    let (whole, new) = (started.elapsed(), read(to));
    for part in 0..=24 {
        write(to, "old");
        kill(line, whole * part / 16, || {
            let left = read(to);
            assert!(left == "old" || left == new, "part {part}: {} bytes", left.len());
        });
    }
}

#[test]
fn a_killed_command_leaves_the_old_file_or_the_new() {
    folder("robust_killed");
    is_written_as_a_whole("bake @toy_top --scalar f64 -o robust_killed/top.rs", "robust_killed/top.rs");
    let sweep = "sweep @toy_top --motions 20000 --spin 90..300 -o robust_killed/rows.csv";
    is_written_as_a_whole(sweep, "robust_killed/rows.csv");
    is_written_as_a_whole("figures -o robust_killed", "robust_killed/figure_3_e3_3.svg");
}

/// A command touches neither other files, whatever their names, nor its inputs.
#[test]
fn only_the_output_is_written() {
    folder("robust_strangers");
    let long_ago = SystemTime::now() - Duration::from_secs(3600);
    let strangers = [".a.csv.123", ".a.csv.12345", ".toytop12345", ".a.csv", "a.csv.1"]
        .map(|name| path(&format!("robust_strangers/{name}")));
    for stranger in &strangers {
        fs::File::create(stranger).and_then(|file| file.set_modified(long_ago)).expect("a file");
    }
    toytop("state @toy_top --times 0 --format csv -o robust_strangers/a.csv").ok();
    assert!(strangers.iter().all(|stranger| stranger.exists()));
    assert_eq!(count("robust_strangers"), strangers.len() + 1);
    let text = read(&sample("toy_top"));
    let own = write("robust_strangers/top.toml", &text);
    for line in [
        format!("state {own} --times 0 -o {own}"),
        format!("bake {own} -o {own}"),
        format!("simulate {own} -o {own}"),
        format!("sweep {own} --spin 90..300/3 -o {own}"),
        format!("fit /dev/null --top {own} -o {own}"),
    ] {
        toytop(line).refused(2, "must not be a file that the command reads");
        assert_eq!(read(own), text);
    }
}

/// An endless line is refused by one line, in bounded memory.
#[cfg(target_os = "linux")]
#[test]
fn an_endless_line_is_refused() {
    for line in ["score @toy_top /dev/zero", "fit /dev/zero --top @toy_top"] {
        bash("ulimit -v 4000000; exec timeout 60 \"$@\"", line).refused(2, "/dev/zero: ");
    }
}

#[test]
fn a_full_disk_leaves_no_file_and_exits_with_1() {
    bash("\"$@\" > /dev/full", "state @toy_top --times 1").refused(1, "No space left");
    // like a full disk, a limit on the size of files allows a part of the file
    folder("robust_full");
    for (line, to) in [
        ("bake @toy_top --scalar f64", "robust_full/top.rs"),
        ("plot @toy_top", "robust_full/top.svg"),
        ("sweep @toy_top --spin 90..300 --motions 1000", "robust_full/rows.csv"),
        ("figures", "robust_full"),
    ] {
        let run = bash("trap '' XFSZ; ulimit -f 4; exec \"$@\"", format!("{line} -o {to}"));
        run.refused(1, &format!("{to} ... too large"));
    }
    assert_eq!(count("robust_full"), 0);
}

#[cfg(target_os = "linux")]
#[test]
fn devices_and_pipes_are_not_replaced() {
    folder("robust_device");
    let link = path("robust_device/link.rs");
    let is_link = || fs::symlink_metadata(&link).expect("the link").is_symlink();
    std::os::unix::fs::symlink("/dev/full", &link).expect("a link");
    toytop("bake @toy_top -o robust_device/link.rs").refused(1, "No space left");
    assert!(is_link());
    fs::remove_file(&link).expect("removed");
    std::os::unix::fs::symlink(path(write("robust_device/file.rs", "old")), &link).expect("a link");
    toytop("bake @toy_top -o robust_device/link.rs").ok();
    assert!(is_link() && read("robust_device/file.rs").contains("toytop"));
}

#[test]
fn a_place_that_cannot_be_written_exits_with_2() {
    write("robust_file", "");
    for place in ["robust_file/x", "/proc/toytop"] {
        for line in [
            format!("plot @toy_top -o {place}.svg"),
            format!("bake @toy_top -o {place}.rs"),
            format!("sweep @toy_top --spin 1,2 -o {place}.csv"),
            format!("figures -o {place}"),
        ] {
            toytop(line).refused(2, place);
        }
    }
}

#[test]
fn a_reader_that_closes_the_pipe_is_no_failure() {
    let times = vec!["0.5"; 20_000].join(",");
    for (line, is_long) in [
        (&*format!("state @toy_top --format csv --times {times}"), true),
        (&format!("state @toy_top --times {}", &times[..7999]), true),
        ("bake @toy_top --scalar f64 --segments 512", true),
        ("bake @toy_top --scalar f64 --segments 512 --lang c", true),
        ("constants @toy_top", false),
        ("completions bash", false),
        ("--help", false),
    ] {
        // a pipe accepts as many bytes as its buffer even if they are not read
        assert_eq!(toytop(line).out.len() > 2 * PIPE, is_long, "{}", &line[..20.min(line.len())]);
        let Run { code, out, err } = bash("\"$@\" | head -c 1; exit ${PIPESTATUS[0]}", line);
        // `bake` prints its summary to stderr
        assert!(code == Some(0) && out.len() == 1 && !err.contains("error"), "{err}");
    }
}

#[test]
fn invalid_scenario_files_are_refused_at_once() {
    let sparse = scenario("robust_100_mb", "");
    fs::File::options().write(true).open(&sparse).and_then(|file| file.set_len(100_000_000)).expect("a hole");
    for (file, part) in
        [(&*sparse, "1 MiB"), ("/dev/zero", "1 MiB"), (HERE, "directory"), ("/dev/null", "missing")]
    {
        for line in ["state --times 1", "constants", "compare", "bake", "plot -o x.svg"] {
            toytop(format!("{line} {file}")).refused(2, &format!("{file} ... {part}"));
        }
    }
}
