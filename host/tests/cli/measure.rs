//! `toytop bench` and `toytop study`: what they print, never how long it took.

use super::{run, stderr, stdout};

/// The cells of the line that starts with this.
fn cells(text: &str, start: &str) -> Vec<String> {
    let line = text.lines().find(|line| line.trim_start().starts_with(start));
    let line = line.unwrap_or_else(|| panic!("no line {start:?} in {text}"));
    line.trim_start()[start.len()..].split_whitespace().map(str::to_owned).collect()
}

#[test]
fn bench_says_what_each_way_costs_and_how_wrong_it_is() {
    let output = run(&["bench"]);
    let text = stdout(&output);
    assert_eq!((output.status.code(), stderr(&output)), (Some(0), ""));
    // greatest and least error, rad
    let cases = [
        ("full solver, tolerance", 1e-9, 1e-13),
        ("Runge-Kutta of the full equations, 6400 steps a period:", 1e-9, 1e-11),
        ("ephemeris f64, 48x11, at any time: the same", 1e-11, 1e-16),
        ("ephemeris f64, 48x11, at any tick: orientation", 1e-11, 1e-16),
    ];
    for (start, most, least) in cases {
        let cells = cells(text, start);
        let [.., error, ratio] = &cells[..] else { panic!("{cells:?}") };
        let error: f64 = error.parse().expect("an error");
        assert!(error < most && error > least, "{start}: {error}");
        assert!(ratio.parse::<f64>().is_ok_and(|ratio| ratio > 0.0), "{start}: {ratio}");
    }
    for name in ["f32, 25x5", "f64, 48x11"] {
        for way in ["in a batch", "the next tick", "any tick"] {
            assert_eq!(cells(text, &format!("ephemeris {name}: {way}")).len(), 3);
        }
    }
    let build = if cfg!(debug_assertions) { "UNOPTIMISED build" } else { "release build" };
    assert!(text.contains(" on one core of ") && text.contains(build));
}

#[test]
fn a_study_is_fixed_by_its_seed_and_adds_up() {
    let study = |seed: &str| {
        let output = run(&["study", "--motions", "150", "--seed", seed]);
        let text = stdout(&output).to_owned();
        let (head, rest) = text.split_once('\n').expect("lines");
        assert!(head.starts_with(&format!("150 motions, seed {seed}: ")), "{head}");
        assert_eq!(output.status.code(), Some(0), "{text}");
        assert_eq!(cells(&text, "BOUND VIOLATED"), ["0", "0"], "{text}");
        rest.to_owned()
    };
    let text = study("3");
    assert_eq!(text, study("3"));
    assert_ne!(text, study("4"));
    assert!(!text.contains("FAILURE"), "{text}");

    let count = |word: &str| word.parse::<u64>().expect("a count");
    let regimes = text.lines().next().expect("regimes").split("; ");
    let regimes: u64 = regimes.map(|part| count(part.split(' ').next().unwrap_or_default())).sum();
    assert_eq!(regimes, 150, "{text}");
    for side in [0, 1] {
        let fits = text
            .lines()
            .filter(|line| line.starts_with("fit "))
            .map(|line| line.split_whitespace().collect::<Vec<_>>());
        let fits: u64 = fits.map(|words| count(words[3 + side])).sum();
        assert_eq!(fits + count(&cells(&text, "do not fit")[side]), 150, "{text}");
    }
    // the errors are those of the scalars
    let number = |start: &str, side: usize| cells(&text, start)[side].parse::<f64>().expect("a number");
    for (side, rounding) in [(0, f64::EPSILON), (1, f64::from(f32::EPSILON))] {
        for kind in ["near", "far"] {
            let median = number(&format!("{kind}: error, median, rad"), side);
            assert!(median > 0.3 * rounding && median < 20.0 * rounding, "{kind} {side}: {median:e}");
            assert!(number(&format!("{kind}: bound / error, 10 %"), side) > 1.0);
        }
    }
}

#[test]
fn what_is_a_table_is_also_records() {
    for (words, rows) in [(&["bench"][..], 14), (&["study", "--motions", "20"], 20)] {
        let json = super::json(&[words, &["--format", "json"]].concat());
        let records = json["rows"].as_array().expect("rows");
        assert!(records.len() >= rows, "{words:?}: {}", records.len());
        assert!(records.iter().all(|record| record["what"].is_string()));
        let csv = run(&[words, &["--format", "csv"]].concat());
        assert_eq!(stdout(&csv).lines().count(), records.len() + 1, "{words:?}");
    }
}
