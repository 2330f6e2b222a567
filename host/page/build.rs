//! Puts the style and the scripts of the page of `toytop view` into the page itself, which needs no other file.

use std::env::var;
use std::fs::{read_to_string, write};
use std::io::Result;

fn main() -> Result<()> {
    println!("cargo:rerun-if-changed=view");
    let source = read_to_string("view/page.html")?.replace("{{style}}", &read_to_string("view/style.css")?);
    let mut page = String::new();
    for line in source.lines() {
        let script = line.strip_prefix("<script src=\"").and_then(|rest| rest.strip_suffix("\"></script>"));
        match script {
            Some(file) => {
                let script = read_to_string(format!("view/{file}"))?;
                page += &format!("<script>\n\"use strict\";\n{script}</script>\n");
            }
            None => page.extend([line, "\n"]),
        }
    }
    assert!(!page.contains("<script src"), "page.html: a script must be a line of its own");
    write(var("OUT_DIR").expect("cargo sets OUT_DIR") + "/page.html", page)
}
