//! `toytop view`: what is in the page, and that it is there as a whole or not at all; in a browser, what it shows.

mod browser;

use super::{RELEASE, TOP, branch_points, folder, needle, run, sample, scenario, stderr, stdout};
use serde_json::{Value, json};
use std::path::Path;
use toytop_host::pictures::view::{CORE, NOT_LIVE};

fn view(words: &[&str], to: &Path) -> String {
    let output = run(&[&["view"], words, &["-o", to.to_str().expect("UTF-8")]].concat());
    let said = stderr(&output);
    assert_eq!((output.status.code(), stdout(&output)), (Some(0), ""), "{words:?}: {said}");
    assert_eq!(said.contains(NOT_LIVE), CORE.is_empty(), "{said}");
    std::fs::read_to_string(to).expect("the page")
}

/// Text of an element of the page that holds nothing else.
fn element<'a>(page: &'a str, id: &str) -> &'a str {
    let (_, rest) = page.split_once(&format!("id=\"{id}\">")).expect("the element");
    rest.split_once('<').expect("its end").0
}

fn data(page: &str) -> Value {
    serde_json::from_str(element(page, "data")).expect("JSON")
}

/// Bytes that a page may have.
const MOST: usize = 400_000;

#[test]
fn one_page_that_needs_nothing_else() {
    let folder = folder("view_page");
    let page = view(&[&sample("figure_3_loops")], &folder.join("top.HTML"));
    let namespace = "http://www.w3.org/2000/svg";
    let rest = page.replace("http-equiv", "").replace(namespace, "");
    let (before, icon) =
        rest.split_once("<link rel=\"icon\" href=\"data:").expect("an icon that is in the page");
    let rest = before.to_owned() + icon;
    for part in ["http", "src=", "href=", "@import", "url(", "import ", "fetch(", "{{"] {
        assert!(!rest.contains(part), "{part}: nothing comes from elsewhere, nothing is left out");
    }
    assert!(page.contains("default-src 'none'"));
    assert!(page.len() < MOST, "{} bytes", page.len());
    assert_eq!(element(&page, "core").is_empty(), CORE.is_empty());
    let data = data(&page);
    assert_eq!(data["recorded"].is_null(), !CORE.is_empty());
    // the keys are those of the file, whole numbers included
    let motion = json!({
        "kind": "branch_points", "e1": 0.7, "e2": 0.9, "e3": 3, "sign_l_plus_n": 1, "sign_l_minus_n": -1, "nutation_phase": 0,
    });
    assert_eq!(data["scenario"]["motion"], motion);
    assert_eq!(data["name"], "figure_3_loops");
    assert_eq!(std::fs::read_dir(&folder).expect("a folder").count(), 1, "nothing is left beside it");
}

/// Without a period, without a tip curve, with the tip held, a name that is no HTML, and no scenario at all.
#[test]
fn every_kind_of_motion_has_a_page() {
    let folder = folder("view_kinds");
    let spiral = scenario("view_spiral", &branch_points([0.2, 1.0, 1.0], 1));
    for (i, file) in [&spiral, &sample("sleeping"), &sample("lagrange")].into_iter().enumerate() {
        view(&[file], &folder.join(format!("{i}.html")));
    }
    let named = scenario("view <b>&amp;", &(TOP.to_owned() + RELEASE));
    let page = view(&[&named], &folder.join("named.html"));
    assert!(
        page.contains("<h1 id=\"name\">view &lt;b&gt;&amp;amp;</h1>") && page.contains("view \\u003cb>&amp;")
    );
    assert!(!page.contains("<b>"));
    let front = view(&[], &folder.join("index.htm"));
    assert_eq!(data(&front)["scenario"], data(&front)["toy_top"]);
    assert_eq!(data(&front)["name"], "A spinning top");
}

#[test]
fn what_has_no_page_is_refused() {
    let folder = folder("view_refused");
    let good = sample("toy_top");
    let needle = needle("view_needle");
    for (file, name, code, part) in [
        (&good, "top.pdf", 2, "--output: "),
        (&good, "top", 2, "must end in .html or .htm\n"),
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
