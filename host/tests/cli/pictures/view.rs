//! `toytop view`: contents of the page, which is complete or missing; and the page in a browser.

mod browser;

use crate::command::{
    RELEASE, TOP, branch_points, count, folder, motion_without_table, run, sample, scenario, toytop,
};
use serde_json::{Value, json};
use std::path::Path;

fn view(words: &[&str], to: &Path) -> String {
    assert_eq!(run(&[&["view"], words, &["-o", to.to_str().expect("UTF-8")]].concat()).ok(), "");
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

/// Greatest size of a page, bytes.
const MAX_BYTES: usize = 400_000;

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
    assert!(page.len() < MAX_BYTES, "{} bytes", page.len());
    let data = data(&page);
    // the keys are those of the file, whole numbers included
    let motion = json!({
        "kind": "branch_points", "e1": 0.7, "e2": 0.9, "e3": 3, "sign_l_plus_n": 1, "sign_l_minus_n": -1, "nutation_phase": 0,
    });
    assert_eq!(data["scenario"]["motion"], motion);
    assert_eq!(data["name"], "figure_3_loops");
    assert_eq!(std::fs::read_dir(&folder).expect("a folder").count(), 1, "nothing is left beside it");
}

/// Pages of motions without a period or a tip curve, of a held tip, of a name that is no HTML, and without a scenario.
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
fn wrong_arguments_and_motions_are_refused() {
    folder("view_refused");
    let motion_without_table = motion_without_table("view_needle");
    for (file, name, code, part) in [
        ("@toy_top", "top.pdf", 2, "for '--output <FILE>'"),
        ("@toy_top", "top", 2, "must end in .html or .htm\n"),
        ("@toy_top", "no/such/folder/top.html", 2, "no/such/folder/top.html"),
        ("@no_such_file", "top.html", 2, "no_such_file.toml"),
        (&motion_without_table, "top.html", 3, "view_needle: no table"),
    ] {
        toytop(format!("view {file} -o view_refused/{name}")).refused(code, part);
        assert_eq!(count("view_refused"), 0, "{name}");
    }
}
