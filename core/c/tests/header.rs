//! Test that the committed header agrees with the sources.

#![allow(clippy::expect_used, reason = "a test may fail so")]

use std::path::Path;

/// Header that cbindgen makes of the sources. It needs the sources with their macros expanded, which a stable compiler does only with
/// `RUSTC_BOOTSTRAP`.
fn made() -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let config = cbindgen::Config::from_file(folder.join("cbindgen.toml")).expect("a configuration");
    // SAFETY: this program has one test, and so one thread that reads or changes the environment.
    unsafe {
        std::env::set_var("RUSTC_BOOTSTRAP", "1");
        std::env::set_var("CARGO_EXPAND_TARGET_DIR", env!("CARGO_TARGET_TMPDIR"));
    }
    let bindings =
        cbindgen::Builder::new().with_crate(folder).with_config(config).generate().expect("bindings");
    let mut text = Vec::new();
    bindings.write(&mut text);
    String::from_utf8(text).expect("UTF-8")
}

#[test]
fn it_is_that_of_the_sources() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("include/toytop.h");
    let committed = std::fs::read_to_string(&path).expect("the header");
    let made = made();
    let written = concat!(env!("CARGO_TARGET_TMPDIR"), "/toytop.h");
    std::fs::write(written, &made).expect("a file");
    assert!(committed == made, "not that of the sources; if it is meant: cp {written} {}", path.display());
}
