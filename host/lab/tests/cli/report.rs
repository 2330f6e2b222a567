//! Tests of `toytop-lab report`: the page needs no other file, and the tables of `host/docs/accuracy.md` are up to date.

use super::killed::{files, is_whole, killed};
use super::{folder, run, stderr, stdout};
use std::fs;
use std::path::Path;
use std::time::Duration;

fn text(path: &Path) -> &str {
    path.to_str().expect("UTF-8")
}

#[test]
fn the_tables_of_the_page_are_what_is_measured() {
    let readme = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/accuracy.md");
    let output = run(&["report", "--readme", text(&readme), "--check"]);
    assert_eq!((output.status.code(), stderr(&output)), (Some(0), ""));

    let good = std::fs::read_to_string(&readme).expect("the page");
    let stale = folder("report_stale").join("stale.md");
    let changed = good.replacen("| RK4, 1024 steps | 9e-9 |", "| RK4, 1024 steps | 8e-9 |", 1);
    assert_ne!(changed, good);
    std::fs::write(&stale, &changed).expect("writable");
    let output = run(&["report", "--readme", text(&stale), "--check"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(stderr(&output).contains("stale") && stderr(&output).matches('\n').count() == 1);
    assert_eq!(std::fs::read_to_string(&stale).expect("the file"), changed, "a check changes nothing");
    assert_eq!(run(&["report", "--readme", text(&stale)]).status.code(), Some(0));
    assert_eq!(std::fs::read_to_string(&stale).expect("the file"), good);
}

#[test]
fn one_page_with_everything() {
    let folder = folder("report_page");
    let [budget, others] = ["budget.json", "others.json"].map(|name| folder.join(name));
    std::fs::write(&budget, r#"{"rows":[{"chip":"<m4f>","bytes":2048},{"chip":"m0","bytes":null}]}"#)
        .expect("writable");
    let row = r#"{"rows":[{"name":"somebody","effort":"much","error_rad":2.5e-7,"us_per_period":12.5}]}"#;
    std::fs::write(&others, row).expect("writable");
    let folder = folder.join("new");
    let words = ["report", "-o", text(&folder), "--budget", text(&budget), "--others", text(&others)];
    let output = run(&words);
    assert_eq!((output.status.code(), stderr(&output)), (Some(0), ""));
    let page = std::fs::read_to_string(stdout(&output).trim()).expect("the page");
    for part in [
        "<td>figure 3 e3=1.85</td>",
        "<td>ephemeris f64</td>",
        "<td>RK4, multicalc</td>",
        "<td>nalgebra, exponential</td>",
        "<td>somebody</td><td>much</td><td>2.5e-7</td><td>12.50</td>",
        "<th>chip</th><th>bytes</th>",
        "<td>&lt;m4f&gt;</td><td>2048</td>",
        "<td>m0</td><td>-</td>",
        "Times are those of this machine",
    ] {
        assert!(page.contains(part), "{part}");
    }
    assert_eq!(page.matches("<svg ").count(), 5);
    let place = |part: &str| page.find(part).unwrap_or_else(|| panic!("{part}"));
    assert!(place("<svg ") < place("<table>"), "figures first");
    assert!(place("<details id=\"budget\"><summary>") < place("<th>chip</th>"), "the budget is folded");
    let (_, date) = page.split_once("</h1>\n<p>").expect("the date");
    let date: Vec<_> = date[..10].split('-').map(|part| part.parse::<u32>().expect("a number")).collect();
    assert!(date[0] >= 2026 && (1..=12).contains(&date[1]) && (1..=31).contains(&date[2]), "{date:?}");
    assert!(page.contains("prefers-color-scheme:dark"));
    assert_eq!(
        page.contains(", revision "),
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../.git").exists()
    );
    let elsewhere = page.replace("http://www.w3.org/2000/svg", "");
    for part in ["http", "src=", "@import", "url(http"] {
        assert!(!elsewhere.contains(part), "{part}: nothing comes from elsewhere");
    }
}

#[test]
fn invalid_report_arguments_are_refused() {
    let folder = folder("report_refused");
    let bad = folder.join("bad.json");
    std::fs::write(&bad, r#"{"rows":[{"chip":1},{"core":2}]}"#).expect("writable");
    let to = folder.join("refused");
    for (words, part) in [
        (vec!["report"], "--output"),
        (vec!["report", "-o", text(&to), "--check"], "--readme"),
        (vec!["report", "-o", text(&to), "--budget", text(&bad)], "same keys"),
        (vec!["report", "-o", text(&to), "--others", text(&bad)], "us_per_period"),
        (vec!["report", "--readme", text(&bad)], "<!-- toytop-lab report: accuracy -->"),
        (vec!["report", "--readme", text(&to)], "--readme"),
    ] {
        let output = run(&words);
        let message = stderr(&output);
        assert_eq!((output.status.code(), stdout(&output)), (Some(2), ""), "{words:?}: {message}");
        assert!(message.contains(part) && message.matches('\n').count() == 1, "{words:?}: {message}");
    }
    assert!(!to.exists(), "not even a folder");
}

/// The page is written last. If the program is killed before, the old page remains.
#[test]
fn a_killed_report_leaves_the_old_page_or_the_new() {
    let folder = folder("robust_report");
    let mut kills = 0;
    for tenths in [0, 3, 6, 9, 12] {
        fs::write(folder.join("index.html"), "old").expect("written");
        kills +=
            u32::from(killed(&["report", "-o", text(&folder)], Duration::from_millis(100 * tenths), || {
                let files = files(&folder);
                let [(name, bytes)] = &files[..] else { panic!("{tenths}: {} files", files.len()) };
                assert!(bytes == b"old" || is_whole(name, bytes), "{tenths}: {name}, {} bytes", bytes.len());
            }));
    }
    assert!(kills > 0, "never killed in time");
}
