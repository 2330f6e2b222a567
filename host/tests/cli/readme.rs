//! Command lines of README are accepted as they are printed, and its figures are those of the pages that it links.

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
    assert!(lines.len() > 5, "{lines:?}");
    for line in lines {
        println!("toytop {line}");
        toytop(line.replace("SCENARIO", "@toy_top").replace("...", "")).ok();
    }
}

#[test]
fn figures_of_the_front_page_are_those_of_the_tables() {
    let [front, costs, accuracy] =
        ["README.md", "host/docs/costs.md", "host/docs/accuracy.md"].map(|page| read(&repository(page)));
    let cell = |page: &str, row: &str, column: usize| {
        let cells = page.lines().find_map(|line| line.strip_prefix(row)).expect(row);
        cells.split('|').nth(column).expect("a cell").replace(' ', "")
    };
    let [f64, f32, q31] = ["| f64 |", "| f32 |", "| q31 |"].map(|row| cell(&accuracy, row, 0));
    let millions =
        |column| cell(&costs, "| m4f | f32 | ready |", column).parse::<f64>().expect("cycles") / 1e6;
    let refused = cell(&costs, "| m4f | f32 | refused |", 0);
    for figures in [
        format!("{f64} rad in `f64`, {f32} in `f32`, {q31} in 32-bit fixed point"),
        format!(
            "median {:.2} million cycles, at most {:.1} million; {refused} refused",
            millions(1),
            millions(2)
        ),
    ] {
        assert!(front.contains(&figures), "{figures}");
    }
}
