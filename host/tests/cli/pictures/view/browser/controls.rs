//! Controls of the page: each has its effect, and the core computes the motion that it sets.

use super::{assert_core, core_of, probe};
use crate::command::{branch_points, list, sample, scenario};
use crate::pictures::view::{folder, view};
use serde_json::Value;
use toytop_host::input::scenario::Scenario;

#[test]
#[ignore = "a browser: cargo xtask test --only browser"]
fn the_page_does_what_its_controls_say() {
    let folder = folder("view_controls");
    for (name, width) in [("toy_top", 1200), ("figure_3_cusp", 320)] {
        let page = folder.join(format!("{name}.html"));
        view(&[&sample(name)], &page);
        let facts = probe(&page, "operate()", width, "");
        let facts = facts.as_object().expect("facts");
        assert!(facts.len() > 40, "{}", facts.len());
        for (fact, holds) in facts {
            assert_eq!(holds, true, "{name}: {fact}");
        }
    }
}

/// The scenario file and the address have the numbers that the sliders set, and the core computes that motion to the bit.
#[test]
#[ignore = "a browser: cargo xtask test --only browser"]
fn sliders_files_and_addresses_say_one_motion() {
    let folder = folder("view_moved");
    let roots = scenario("view_roots", &branch_points([0.2, 0.6, 1.5], -1));
    // with the least number of sliders
    let files = [
        (sample("toy_top"), 13),
        (sample("lagrange"), 12),
        (roots, 12),
        (sample("free_body"), 7),
        (sample("pendulum"), 12),
    ];
    for (i, (file, sliders)) in files.iter().enumerate() {
        let page = folder.join(format!("{i}.html"));
        view(&[file], &page);
        let moved = probe(&page, "moveSliders()", 1200, "");
        let results = list(&moved["results"]);
        // each slider is moved twice
        assert!(results.len() >= 2 * sliders, "{file}: {}", results.len());
        for shown in results {
            let toml = shown["toml"].as_str().expect("a scenario");
            let motion =
                Scenario::parse("page.toml", toml).unwrap_or_else(|error| panic!("{error}: {toml}")).motion;
            assert_core(shown, &core_of(&motion), 7.25);
        }
        let last = results.last().expect("a pose");
        let restored = probe(&page, "restored()", 1200, moved["fragment"].as_str().expect("a fragment"));
        assert_eq!((&restored["t"], &restored["playing"]), (&Value::from(7.25), &Value::from(false)));
        for (key, expected) in
            [("alpha", last), ("beta", last), ("tip", last), ("fragment", &moved), ("comparison", &moved)]
        {
            assert_eq!(restored[key], expected[key], "{key}");
        }
        let [speed, before] = [&restored, &moved].map(|page| page["speed"].as_f64().expect("a speed"));
        assert!((speed / before - 1.0).abs() < 1e-3, "{speed} {before}");
    }
}
