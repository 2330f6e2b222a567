//! Sentences of the page about a motion.

use super::probe;
use crate::command::list;
use crate::pictures::view::{folder, view};

/// Regimes, each with a phrase of its summary.
const REGIMES: [(&str, &str); 6] = [
    ("nutating", "nods between two tilts"),
    ("regular_precession", "goes round at a constant tilt"),
    ("sleeping_stable", "it stands upright"),
    ("sleeping_unstable", "any push makes it fall"),
    ("hanging", "hangs straight down"),
    ("aperiodic", "only in infinite time"),
];

/// No word has a capital letter inside, as the names of a script have.
#[test]
#[ignore = "a browser: cargo xtask test --only browser"]
fn every_regime_is_described_in_words() {
    let page = folder("view_sentences").join("top.html");
    view(&[], &page);
    let regimes = REGIMES.map(|(regime, _)| regime);
    let found = probe(&page, &format!("describe({regimes:?})"), 1200, "");
    let texts: Vec<_> = list(&found).iter().map(|text| text.as_str().expect("a text")).collect();
    for ((regime, phrase), text) in REGIMES.into_iter().zip(&texts) {
        assert!(text.contains(phrase), "{regime}: {text}");
    }
    let has_inner_capital = |word: &&str| {
        let letters: Vec<_> = word.chars().collect();
        letters.windows(2).any(|pair| pair[0].is_lowercase() && pair[1].is_uppercase())
    };
    let words = texts.iter().flat_map(|text| text.split(char::is_whitespace));
    assert_eq!(words.filter(has_inner_capital).collect::<Vec<_>>(), [""; 0]);
}
