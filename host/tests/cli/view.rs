//! `toytop view`: what is in the page, and that it is there as a whole or not at all; in a browser, what it shows.

mod browser;

use super::{RELEASE, TOP, branch_points, folder, json, needle, run, sample, scenario, stderr, stdout};
use serde_json::Value;
use std::path::Path;

fn view(file: &str, to: &Path) -> String {
    let output = run(&["view", file, "-o", to.to_str().expect("UTF-8")]);
    assert_eq!((output.status.code(), stdout(&output)), (Some(0), ""), "{file}: {}", stderr(&output));
    std::fs::read_to_string(to).expect("the page")
}

/// What an element of the page holds, which has only text in it.
fn element<'a>(page: &'a str, id: &str) -> &'a str {
    let (_, rest) = page.split_once(&format!("id=\"{id}\">")).expect("the element");
    rest.split_once('<').expect("its end").0
}

#[test]
fn one_page_that_needs_nothing_else() {
    let folder = folder("view_page");
    let file = sample("figure_3_loops");
    let page = view(&file, &folder.join("top.HTML"));
    for part in ["http", "src=", "href=", "@import", "url(", "import ", "fetch(", "{{", "}}"] {
        // the mark of the address, and a template's, are none of JavaScript's or CSS's
        let found = page.replace("http-equiv", "").replace("}}\n", "").contains(part);
        assert!(!found, "{part}: nothing comes from elsewhere, nothing is left out");
    }
    assert!(page.contains("default-src 'none'"));
    // the table is what `bake` writes at this tick
    let table: Value = serde_json::from_str(element(&page, "table")).expect("JSON");
    let hertz = table["tick"].as_str().expect("a tick").trim_end_matches(" Hz").to_owned();
    assert_eq!(table, json(&["bake", &file, "--lang", "json", "--hertz", &hertz]));
    let scene: Value = serde_json::from_str(element(&page, "scene")).expect("JSON");
    assert_eq!(scene["e"], serde_json::json!([0.7, 0.9, 3.0]));
    // the constants, as `constants` has them
    for fact in [
        "<th scope=\"row\">e₁, lowest u</th><td>0.7 <small>",
        "<th scope=\"row\">nutation period</th><td>3.48271 <small>s<",
        "<th scope=\"row\">α in a period</th><td>0.78468 <small>turns<",
        "<th scope=\"row\">least normal force</th><td>0.647059 <small>weights<",
        "tip curve: loops",
        "25 × 5 in f32",
        "<small>rad<",
    ] {
        assert!(page.contains(fact), "{fact}");
    }
    assert_eq!(std::fs::read_dir(&folder).expect("a folder").count(), 1, "nothing is left beside it");
}

/// Without a period, without a tip curve, with the tip held, and a name that is no HTML.
#[test]
fn every_kind_of_motion_has_a_page() {
    let folder = folder("view_kinds");
    let spiral = scenario("view_spiral", &branch_points([0.2, 1.0, 1.0], 1));
    let page = view(&spiral, &folder.join("spiral.html"));
    assert!(page.contains("aperiodic") && !page.contains("id=\"periods\""));
    assert!(page.contains("<th scope=\"row\">nutation period</th><td>– <small></small>"));
    assert!(view(&sample("sleeping"), &folder.join("sleeping.html")).contains("\"circles\":[]"));
    let tall = scenario("view_tall", &branch_points([0.6, 0.8, 1.5], 1));
    let page = view(&tall, &folder.join("tall.html"));
    let scene: Value = serde_json::from_str(element(&page, "scene")).expect("JSON");
    for (circle, radius) in scene["circles"].as_array().expect("circles").iter().zip([0.8, 0.6]) {
        let drawn = circle["radius"].as_f64().expect("a radius");
        assert!((drawn - radius).abs() < 1e-15, "{drawn} is not in units of s");
    }
    let held = view(&sample("lagrange"), &folder.join("held.html"));
    assert!(held.contains("\"held\":true"));
    assert!(held.contains("foot of the axis, −2αβ: minus the tip of <code>toytop state</code>"));
    let named = scenario("view <b>&amp;", &(TOP.to_owned() + RELEASE));
    let page = view(&named, &folder.join("named.html"));
    assert!(page.contains("<h1>view &lt;b&gt;&amp;amp;</h1>") && page.contains("view \\u003cb>&amp;"));
    assert!(!page.contains("<b>"));
}

#[test]
fn what_has_no_page_is_refused() {
    let folder = folder("view_refused");
    let good = sample("toy_top");
    let needle = needle("view_needle");
    for (file, name, code, part) in [
        (&good, "top.pdf", 2, "--output: "),
        (&good, "top", 2, "must end in .html"),
        (&good, "no/such/folder/top.html", 2, "no/such/folder/top.html"),
        (&sample("no_such_file"), "top.html", 2, "no_such_file.toml"),
        (&needle, "top.html", 3, "view_needle: no ephemeris"),
    ] {
        let output = run(&["view", file, "-o", folder.join(name).to_str().expect("UTF-8")]);
        let message = stderr(&output);
        assert_eq!((output.status.code(), stdout(&output)), (Some(code), ""), "{name}: {message}");
        assert!(message.contains(part) && message.matches('\n').count() == 1, "{name}: {message}");
        assert_eq!(std::fs::read_dir(&folder).expect("a folder").count(), 0, "{name}");
    }
}
