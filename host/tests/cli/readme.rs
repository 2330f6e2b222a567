//! Command lines of README are accepted as they are printed.

use crate::command::{path, read, repository, toytop, write};

#[test]
fn command_lines_of_the_front_page_are_accepted() {
    toytop("simulate @toy_top --sample-rate 1000 --duration 0.3 --seed 7 -o SAMPLES.csv").ok();
    write("RESULT.csv", toytop("state @toy_top --times 0..1/101 --format csv").ok());
    // left over from an earlier run, or never there
    let _ = std::fs::remove_file(path("MAP.csv"));
    let page = read(&repository("README.md"));
    let lines: Vec<_> =
        page.lines().filter_map(|line| line.strip_prefix("| `toytop ")?.split('`').next()).collect();
    assert_eq!(lines.len(), 8, "{lines:?}");
    for line in lines {
        println!("toytop {line}");
        toytop(line.replace("SCENARIO", "@toy_top").replace("...", "")).ok();
    }
}
