//! Tests of the times of `toytop state`.

use super::{run, sample, stderr, stdout};

#[test]
fn times_spread_evenly() {
    let file = sample("toy_top");
    let [spread, listed] = ["--times=-1..1/5", "--times=-1,-0.5,0,0.5,1"]
        .map(|times| run(&["state", &file, times, "--format", "csv"]));
    assert_eq!(spread.status.code(), Some(0), "{}", stderr(&spread));
    assert_eq!(stdout(&spread), stdout(&listed));
    let refused = run(&["state", &file, "--times=0..1"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(
        stderr(&refused).contains("--times: 0..1: must be T1,T2,... or LOW..HIGH/PLACES"),
        "{}",
        stderr(&refused)
    );
}
