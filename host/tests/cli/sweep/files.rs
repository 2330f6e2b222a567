//! Existing files of sweeps: their checksums, the join of shards, and rows that are computed again.

use super::{GRID, no_file, refused, sweep, words};
use crate::{run, stderr, stdout};
use std::path::Path;

/// A command on files that are there: its answer, or that it is refused with these words and writes nothing.
fn files(words: &[&str], part: &str) -> String {
    let output = run(&[&["sweep"], words].concat());
    let good = stdout(&output).contains(part) && output.status.success();
    let refused = output.status.code() == Some(2) && stderr(&output).contains(part);
    assert!(
        good || refused && stderr(&output).matches('\n').count() == 1,
        "{words:?}: {} {}",
        stderr(&output),
        stdout(&output)
    );
    stdout(&output).to_owned()
}

/// Without the options of the sweep: any bit, rows that are gone at the end or between, and rows of another sweep are noticed.
#[test]
fn checksums_tell_what_was_changed() {
    let path = no_file("sealed");
    let name = path.to_str().expect("UTF-8");
    let text = sweep(&path, &["--motions", "90", "--shard", "2/3"]);
    assert!(
        files(&["verify", name], "30 rows of a sweep of 90, all match their checksums").starts_with(name)
    );
    let line = |i: usize| text.lines().nth(i).expect("a line").to_owned() + "\n";
    let other = sweep(&no_file("sealed_other"), &["--motions", "90", "--shard", "2/3", "--seed", "2"]);
    for (content, part) in [
        (text.replacen(&line(20), &line(20).replace('4', "5"), 1), "line 21: does not match its checksum"),
        (text[..text.len() - 9].to_owned(), "line 31: does not match its checksum: cut off"),
        (text.replacen(&line(20), "", 1), "line 21: does not follow the row before it"),
        (text.replacen(&line(20), &line(19), 1), "line 21: does not follow the row before it"),
        (text.replacen(&line(30), "", 1), "line 31: missing: the sweep has more rows"),
        (
            text.replacen(&line(30), other.lines().nth(30).expect("a row"), 1) + "\n",
            "line 31: does not follow the row before it",
        ),
        (line(0), "line 2: missing"),
        (text.replacen("index", "Index", 1), "line 1: is not the header"),
        (String::new(), "line 1: is not the header"),
    ] {
        std::fs::write(&path, content).expect("writable");
        files(&["verify", name], part);
    }
    files(&["verify", "/dev/null"], "must be a regular file");
    files(&["verify"], "FILE");
}

/// Parts in any order are the whole again, to the byte; anything else is no file.
#[test]
fn joined_shards_are_the_whole() {
    let whole = sweep(&no_file("join_whole"), &GRID);
    let parts: Vec<String> = (1..=5)
        .map(|shard| {
            let path = no_file(&format!("join_{shard}"));
            let shard = format!("{shard}/5");
            sweep(&path, &[&GRID[..], &["--shard", &shard]].concat());
            path.to_str().expect("UTF-8").to_owned()
        })
        .collect();
    let output = no_file("joined");
    let name = output.to_str().expect("UTF-8");
    let [a, b, c, d, e] = &parts[..] else { panic!("five") };
    files(&["join", d, a, e, c, b, "-o", name], "36 rows of 5 files");
    assert!(std::fs::read_to_string(&output).expect("the file") == whole);
    files(&["verify", name], "36 rows of a sweep of 36");
    std::fs::remove_file(&output).expect("it was there");
    let other = no_file("join_other");
    sweep(&other, &["--motions", "36", "--shard", "2/5"]);
    for (parts, part) in [
        (vec![a, b, c, e], "row 3 is in no file"),
        (vec![a, b, c, d, d], "row 3 is in another file, too"),
        (vec![a], "row 1 is in no file"),
    ] {
        files(
            &[&["join"], &parts.iter().map(|part| part.as_str()).collect::<Vec<_>>()[..], &["-o", name]]
                .concat(),
            part,
        );
        assert!(!output.exists(), "{part}");
    }
    files(&["join", a, other.to_str().expect("UTF-8"), "-o", name], "is of another sweep");
    assert!(!output.exists());
}

/// Every byte counts: a changed digit, a row that is gone, one too many, another sweep.
#[test]
fn a_file_is_verified_row_by_row() {
    let path = no_file("verified");
    let more = ["--motions", "1500", "--columns", "regime,period"];
    let verify = [&more[..], &["--recompute"]].concat();
    refused(&path, &verify, "No such file");
    let text = sweep(&path, &more);
    let output = run(&words(&path, &verify));
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert!(stdout(&output).contains("1500 rows, all equal to the computed ones"), "{}", stdout(&output));
    let line = text.lines().nth(1200).expect("a row");
    let digit = line.rfind(|c: char| c.is_ascii_digit()).expect("a digit");
    let other = if line.as_bytes()[digit] == b'1' { "2" } else { "1" };
    let changed = format!("{}{other}{}", &line[..digit], &line[digit + 1..]);
    let last = text[..text.len() - 1].rfind('\n').expect("rows") + 1;
    for (content, part) in [
        (text.replacen(line, &changed, 1), "line 1201: differs from the computed row"),
        (text[..last].to_owned(), "line 1501: missing"),
        (text.clone() + "1500,\n", "line 1502: must be the end of the file"),
        (text.replacen("index", "Index", 1), "line 1: differs from the computed row"),
        (String::new(), "line 1: missing"),
    ] {
        std::fs::write(&path, content).expect("writable");
        refused(&path, &verify, part);
    }
    std::fs::write(&path, &text).expect("writable");
    refused(&path, &[&verify[..], &["--seed", "2"]].concat(), "line 2: differs from the computed row");
    refused(Path::new("/dev/null"), &verify, "must be a regular file");
}
