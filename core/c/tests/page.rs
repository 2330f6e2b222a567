//! Test that the sizes named in the pages are those of the header.

#![allow(clippy::expect_used, reason = "a test may fail so")]

const HEADER: &str = include_str!("../include/toytop.h");
const PAGE: &str = include_str!("../README.md");
const FRONT_PAGE: &str = include_str!("../../../README.md");

/// Number that the header defines.
fn defined(name: &str) -> usize {
    let line = HEADER.lines().find_map(|line| line.strip_prefix(&format!("#define {name} ")));
    line.expect(name).parse().expect("a whole number")
}

/// Text with one space between its words.
fn in_one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn the_sizes_are_those_of_the_header() {
    let [f32, f64, q31] = ["F32", "F64", "Q31"].map(|scalar| defined(&format!("TOYTOP_TABLE_{scalar}_SIZE")));
    let workspace = defined("TOYTOP_WORKSPACE_SIZE");
    let page = in_one_line(PAGE);
    for part in [
        format!("static toytop_table_f32 table; /* {f32} bytes */"),
        format!("and takes {f32}, {f64} or {q31} bytes"),
        format!("a `toytop_workspace` of {workspace} bytes"),
    ] {
        assert!(page.contains(&part), "not in the page: {part}");
    }
    let part = format!("static toytop_table_f32 table; /* the caller's memory, {f32} bytes */");
    assert!(FRONT_PAGE.contains(&part), "not in the front page: {part}");
    // no other size is named
    let words: Vec<_> = page.split(' ').collect();
    for pair in words.windows(2).filter(|pair| pair[1].starts_with("bytes")) {
        let Ok(bytes) = pair[0].parse::<usize>() else { continue };
        assert!([f32, f64, q31, workspace].contains(&bytes), "{bytes} bytes");
    }
}
